// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPrimaryHits.h
 * @brief What the camera's rays meet first, and which pixels see several surfaces. Internal to Core.
 */
#ifndef scPrimaryHits_h
#define scPrimaryHits_h

#include "scParallel.h"
#include "scPixelArray.h"
#include "scPixelRay.h"
#include "scPrimaryHit.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scVisibleLight.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// The nearest surface of every pixel of an extent, and which pixels see several.
class PrimaryHits
{
public:
  /// Everything is referred to and must outlive the hits. Of the scene the light does not matter; @p visibleLights are
  /// those that the camera sees.
  PrimaryHits(const ScatteringScene& scene, const ScatteringOptions& options, const std::array<int, 4>& extent,
    const std::vector<VisibleLight>& visibleLights);

  /// Trace the rays through the centres of the pixels of the extent and, where edges are anti-aliased, through
  /// their corners. @return false where aborted.
  bool Trace(const Monitor& monitor);

  Ray RayOf(double i, double j) const
  {
    return this->Scene.Camera.PixelRay(i, j, this->Options.Width, this->Options.Height);
  }
  /**
   * What a pixel is the mean of: the ray through its centre, and at an edge one ray for each surface that is seen in
   * the pixel, with the fraction of the pixel that it covers. That fraction comes from 16 rays for each of
   * NumberOfEdgeSamples: a bright rim that is thinner than a pixel does not come and go along its way. @p rays is
   * overwritten; fractions sum to 1.
   */
  void RaysOf(int i, int j, std::vector<PixelRay>& rays) const;
  /// The centre of pixel (i, j), counted over the whole image.
  const PrimaryHit& At(int i, int j) const { return this->Centers.At(i, j); }

  /**
   * Does one of its corners see another surface than its centre: none, one of another occluder or reflectance, one at
   * more than 25 degrees, or one that the surface does not lead to? Or does the one see a light and the other does
   * not? Never, where edges are not anti-aliased.
   */
  bool IsEdge(int i, int j) const;

private:
  /// What rays see that are a pixel apart.
  struct Lattice
  {
    double Shift = 0.0; ///< of its rays from the pixels' centres
    std::array<int, 2> First{ 0, 0 };
    int Columns = 0;
    int Rows = 0;
    PixelArray<PrimaryHit> Hits;

    const PrimaryHit& At(int i, int j) const
    {
      const auto row = static_cast<std::size_t>(j - this->First[1]);
      return this->Hits[row * static_cast<std::size_t>(this->Columns) + static_cast<std::size_t>(i - this->First[0])];
    }
  };
  Lattice LatticeOver(double shift, int more) const;
  bool Trace(Lattice& lattice, const Monitor& monitor) const;
  void TraceBlock(int i, int j, Lattice& lattice) const;
  void Find(const Ray* rays, int count, PrimaryHit* hits) const;
  bool Differ(const Ray& rayA, const PrimaryHit& a, const Ray& rayB, const PrimaryHit& b) const;
  std::size_t MiddleOf(const std::vector<std::size_t>& seen) const;
  bool SameReflectance(vtkIdType a, vtkIdType b) const;

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const std::array<int, 4> Extent;
  const std::vector<VisibleLight>& Visible;
  const bool FindsEdges;
  Lattice Centers;
  Lattice Corners; ///< (i, j): of pixel (i, j) the one next to pixel (i - 1, j - 1)
  /// Of the rays that look into a pixel at an edge, from its centre, in pixels.
  std::vector<std::array<double, 2>> EdgeOffsets;
};

} // namespace shadowcones

#endif
