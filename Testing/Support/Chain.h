// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Chain.h
 * @brief Photons traced and cones fitted to the vectors that they leave, without filters.
 */
#ifndef Chain_h
#define Chain_h

#include "scCone.h"
#include "scConeSet.h"
#include "scLightExtent.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"
#include "scShadowVectors.h"

#include <stdexcept>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

/// The arrays must outlive the view.
inline ShadowVectorView ViewOf(const ShadowVectors& vectors)
{
  return { static_cast<vtkIdType>(vectors.OccluderIds.size()), vectors.Points.data(), vectors.Directions.data(),
    vectors.EmissionPoints.data(), vectors.OccluderIds.data(), vectors.LightIds.data() };
}

/// The arrays must outlive the view.
inline PhotonPathView ViewOf(const PhotonPaths& paths)
{
  return { static_cast<vtkIdType>(paths.States.size()), paths.Points.data(), paths.EmissionPoints.data(),
    paths.Directions.data(), paths.States.data(), paths.LightIds.data() };
}

/// @param light one light, or a vector of them.
template <typename Lights>
ShadowVectorResult Trace(const OccluderScene& occluders, const Lights& light, const ShadowVectorOptions& options)
{
  ShadowVectorResult traced;
  if (!TraceShadowVectors(occluders, light, options, {}, traced))
  {
    throw std::logic_error("Nobody asked to stop the tracing.");
  }
  return traced;
}

/// At least @p vectors of them, stored where the photons hit.
inline ShadowVectorResult TraceToHits(const OccluderScene& occluders, const Light& light, vtkIdType vectors)
{
  ShadowVectorOptions options;
  options.TargetNumberOfVectors = vectors;
  options.Storage = VectorStorage::HitPoint;
  return Trace(occluders, light, options);
}

/// Few and large cones: overlapping, under the exact light, their bases as they are.
inline ConeSetOptions BoundOptions()
{
  ConeSetOptions options;
  options.VarianceThreshold = 1.8;
  options.CosineCorrection = false;
  options.Expansion = ConeExpansion::LightGeometry;
  options.Overlap = true;
  return options;
}

/// By the vectors alone, without the photons' paths.
inline ConeSet Fit(const ShadowVectorResult& traced, const Light& light, const ConeSetOptions& options)
{
  ConeSet set;
  if (!FitConeSet(ViewOf(traced.Vectors), {}, LightExtentOf(light), options, {}, set))
  {
    throw std::logic_error("Nobody asked to stop the fit.");
  }
  return set;
}

/// Cones that hold the shadow.
inline std::vector<Cone> BoundingCones(const OccluderScene& occluders, const Light& light, vtkIdType vectors = 20000)
{
  return Fit(TraceToHits(occluders, light, vectors), light, BoundOptions()).Cones;
}

} // namespace testsupport
} // namespace shadowcones

#endif
