// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scAimedPhotons.h
 * @brief Photons aimed at occluders that would have too few vectors. Internal to Core.
 */
#ifndef scAimedPhotons_h
#define scAimedPhotons_h

#include "scPhotonTracing.h"

namespace shadowcones
{

/**
 * Aim photons at the occluders that would have too few vectors: the first photons of all, which every piece traces. How many a
 * bundle has is found with other random numbers than its own, so that their powers stay right; it has some more only where
 * these were not enough after all. @param ofOthers vectors that the lights' own bundles must give at least, for
 * occluders that are not aimed at.
 * @return false where aborted.
 */
bool TraceAimedPhotons(const PhotonTracing& tracing, const TriangleMeshView& mesh, std::size_t lights,
  const ShadowVectorOptions& options, const Monitor& monitor, ShadowVectorResult& result, vtkIdType& ofOthers);

} // namespace shadowcones

#endif
