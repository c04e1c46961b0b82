// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfaceOcclusion.h"

#include "scVisibilityGrid.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

SurfaceOcclusion::SurfaceOcclusion(const ScatteringScene& scene, const ScatteringOptions& options)
  : Mode(options.Mode)
  , Grid(scene.Visibility)
{
  const bool bounded = this->Mode == ScatteringMode::Medium || this->Mode == ScatteringMode::Guided ||
    this->Mode == ScatteringMode::Volume;
  if (bounded && scene.Cones && options.NumberOfSurfaceLightSamples > 0)
  {
    double largest = 0.0;
    for (const Cone& cone : scene.Cones->Cones())
    {
      largest = std::max(largest, cone.BaseRadius);
    }
    // Surfaces outside the medium lie in shadow too.
    const double margin = 1e-5 * scene.Occluders.Bounds().Diagonal();
    const Vector3 reach{ margin, margin, margin };
    const Box& box = scene.Occluders.Bounds();
    this->Cones = std::make_unique<ConeHierarchy>(
      Lengthened(scene.Cones->Cones()), Box{ box.Min - reach, box.Max + reach }, scene.Cones->Length() + largest);
  }
}

bool SurfaceOcclusion::NeedsRays(const Vector3& point) const
{
  switch (this->Mode)
  {
    case ScatteringMode::Fast:
    case ScatteringMode::Soft:
      return false;
    case ScatteringMode::BruteForce:
      return true;
    case ScatteringMode::Medium:
    case ScatteringMode::Guided:
      return !this->Cones || this->Cones->Contains(point);
    case ScatteringMode::Volume:
      return this->Cones ? this->Cones->Contains(point) : this->NearMark(point);
  }
  return true;
}

bool SurfaceOcclusion::NearMark(const Vector3& point) const
{
  if (!this->Grid || this->Grid->Marked.empty())
  {
    return true;
  }
  const VisibilityGrid& grid = *this->Grid;
  int first[3];
  int last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double coordinate = (point[axis] - grid.Origin[axis]) / grid.Spacing[axis];
    const int vertices = grid.Dimensions[static_cast<std::size_t>(axis)];
    if (!(coordinate >= 0.0 && coordinate <= vertices - 1.0))
    {
      return true; // the grid knows nothing of points outside
    }
    const auto cell = static_cast<int>(coordinate);
    first[axis] = std::max(cell - 1, 0);
    last[axis] = std::min(cell + 2, vertices - 1);
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      const auto row = grid.Marked.begin() + static_cast<std::ptrdiff_t>(grid.VertexIndex(0, j, k));
      if (std::find(row + first[0], row + last[0] + 1, 1) != row + last[0] + 1)
      {
        return true;
      }
    }
  }
  return false;
}

double SurfaceOcclusion::VisibleFraction(const Vector3& point, const Vector3& normal) const
{
  if (this->Mode != ScatteringMode::Soft || !this->Grid)
  {
    return 1.0;
  }
  // One cell above the surface: vertices below it lie in its own shadow.
  const Vector3& spacing = this->Grid->Spacing;
  const double cell =
    std::fabs(normal.X) * spacing.X + std::fabs(normal.Y) * spacing.Y + std::fabs(normal.Z) * spacing.Z;
  return VisibilityAt(*this->Grid, point + cell * normal);
}

} // namespace shadowcones
