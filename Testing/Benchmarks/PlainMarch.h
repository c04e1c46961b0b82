// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainMarch.h
 * @brief The paper's adaptive march written out again, so that the library behind its occlusion rays can be exchanged.
 *
 * It takes the light samples of BruteForce, one occlusion ray a call: with Embree it must give BruteForce's image and
 * ray count. A homogeneous medium only.
 */
#ifndef PlainMarch_h
#define PlainMarch_h

#include "scScatteringOptions.h"
#include "scScatteringScene.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <vector>

namespace shadowcones
{

/// Every stride-th pixel in both directions.
struct PlainImage
{
  int Stride = 1;
  std::vector<int> Pixels;    ///< i + width * j of the whole image
  std::vector<double> Values; ///< the medium term, mean over wavelengths
  std::vector<int> Samples;   ///< light samples
  vtkIdType NumberOfOcclusionRays = 0;
};

PlainImage MarchWithEmbree(const ScatteringScene& scene, const ScatteringOptions& options, int stride);

/// The mesh of @p scene in VTK's own search structure.
class LocatorScene
{
public:
  explicit LocatorScene(const TriangleMeshView& mesh);
  vtkStaticCellLocator* Locator() const { return this->Search; }

private:
  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkStaticCellLocator> Search;
};

/// Rays from the camera too are traced by the locator.
PlainImage MarchWithLocator(
  const ScatteringScene& scene, const LocatorScene& locator, const ScatteringOptions& options, int stride);

} // namespace shadowcones

#endif
