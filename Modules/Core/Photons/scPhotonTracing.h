// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonTracing.h
 * @brief Ranges of photons traced in parallel, joined in their order. Internal to Core.
 */
#ifndef scPhotonTracing_h
#define scPhotonTracing_h

#include "scParallel.h"
#include "scPhotonBundles.h"
#include "scPhotonTracer.h"
#include "scShadowVectors.h"

namespace shadowcones
{

/// What photons are traced with.
struct PhotonTracing
{
  const PhotonTracer& Tracer;
  PhotonBundles& Bundles;

  /// Trace one photon, which is to have this index.
  void Trace(const PhotonBundles::BundlePhoton& photon, vtkIdType index, ShadowVectorResult& result) const
  {
    this->Tracer.Trace(
      this->Bundles.Emit(photon.Bundle, photon.Index), this->Bundles.LightOf(photon.Bundle), index, result);
  }
  /// Trace photons [begin, end). @return false where aborted.
  bool TraceRange(vtkIdType begin, vtkIdType end, const Monitor& monitor, ShadowVectorResult& result) const;
};

/// What photons of a later range left behind, after what is there.
void Append(ShadowVectorResult& result, const ShadowVectorResult& more);

} // namespace shadowcones

#endif
