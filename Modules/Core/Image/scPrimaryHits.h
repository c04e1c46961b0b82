// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPrimaryHits.h
 * @brief What the camera's rays meet first, and the part of a ray inside the medium. Internal to Core.
 */
#ifndef scPrimaryHits_h
#define scPrimaryHits_h

#include "scScatteringImage.h"
#include "scVisibleLight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shadowcones
{

/// The nearest surface on a camera ray.
struct PrimaryHit
{
  double T = HUGE_VAL;     ///< distance; infinite where there is none
  vtkIdType Triangle = -1; ///< -1 where there is none
  bool SeesLight = false;  ///< the light itself is before the surface

  bool HasSurface() const { return this->Triangle >= 0; }
};

/// The part of a camera ray inside the medium's bounds, up to the first surface.
struct MediumSegment
{
  bool Crosses = false;
  double Begin = 0.0;
  double End = 0.0;
  double EndOfMarch = 0.0; ///< a little before a surface: an occlusion ray would start on the wrong side of it

  double Length() const { return this->Crosses ? this->End - this->Begin : 0.0; }
};

inline MediumSegment SegmentInside(
  const Box& bounds, const OccluderScene& occluders, const Ray& ray, const PrimaryHit& hit)
{
  MediumSegment segment;
  segment.End = hit.T;
  segment.Crosses = bounds.Clip(ray.Origin, ray.Direction, segment.Begin, segment.End);
  segment.EndOfMarch = segment.End;
  if (segment.Crosses && hit.HasSurface() && segment.End >= hit.T)
  {
    const double cosine = std::fabs(Dot(ray.Direction, occluders.TriangleNormal(hit.Triangle)));
    const double gap = 4.0 * occluders.Epsilon() / std::max(cosine, 0.01);
    segment.EndOfMarch = std::max(segment.End - gap, 0.5 * (segment.Begin + segment.End));
  }
  return segment;
}

/// The unit normal of the surface that a ray hits, on the ray's side.
inline Vector3 NormalTowards(const OccluderScene& occluders, const Ray& ray, const PrimaryHit& hit)
{
  const Vector3 normal = occluders.TriangleNormal(hit.Triangle);
  return Dot(normal, ray.Direction) > 0.0 ? -normal : normal;
}

/// The nearest surface of every pixel of an extent, and where neighbours see different ones.
class PrimaryHits
{
public:
  /// Everything is referred to and must outlive the hits. @p visibleLight nullptr: the camera does not see the light.
  PrimaryHits(const ScatteringScene& scene, const ScatteringOptions& options, const VisibleLight* visibleLight);

  /// Trace the rays of @p options.Extent and, where edges are anti-aliased, of one pixel around it, those outside the
  /// image too. @return false where aborted.
  bool Trace(const Monitor& monitor);

  Ray RayOf(double i, double j) const
  {
    return this->Scene.Eye.PixelRay(i, j, this->Options.Width, this->Options.Height);
  }
  /// The nearest surfaces along rays that run close together.
  void Find(const Ray* rays, int count, PrimaryHit* hits) const;
  /// That of pixel (i, j), counted over the whole image.
  const PrimaryHit& At(int i, int j) const
  {
    const auto row = static_cast<std::size_t>(j - this->First[1]);
    return this->Hits[row * static_cast<std::size_t>(this->Columns) + static_cast<std::size_t>(i - this->First[0])];
  }

  /**
   * Does one of its four neighbours see another surface: none, one of another occluder or reflectance, one at more than
   * 25 degrees, or one that the surface does not lead to? Or does the one see the light and the other does not? Never,
   * where edges are not anti-aliased.
   */
  bool IsEdge(int i, int j) const;

private:
  void TraceBlock(int i, int j);
  bool Differ(int i, int j, int otherI, int otherJ) const;
  bool SameReflectance(vtkIdType a, vtkIdType b) const;

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const VisibleLight* const Visible;
  const int Apron;
  std::array<int, 2> First; ///< pixel of Hits[0]
  int Columns;
  int Rows;
  std::vector<PrimaryHit> Hits;
};

} // namespace shadowcones

#endif
