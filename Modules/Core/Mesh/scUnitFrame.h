// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scUnitFrame.h
 * @brief A mesh seen so that its bounds have a diagonal of 1. Internal to Core.
 */
#ifndef scUnitFrame_h
#define scUnitFrame_h

#include "scTriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shadowcones
{

/// Differences of the mesh's points, over the diagonal of its bounds: no size is too large or too small to be multiplied.
class UnitFrame
{
public:
  explicit UnitFrame(const TriangleMeshView& mesh)
    : Mesh(mesh)
  {
    const Box bounds = MeshBounds(mesh);
    if (bounds.Empty())
    {
      return;
    }
    const Vector3 size = bounds.Size();
    const double diagonal = std::hypot(size.X, size.Y, size.Z);
    if (!std::isfinite(diagonal))
    {
      throw std::runtime_error("The mesh's bounds are too large to be measured.");
    }
    this->Diagonal = diagonal > 0.0 ? diagonal : 1.0;
  }
  Vector3 Between(vtkIdType from, vtkIdType to) const
  {
    const Vector3 d = this->Mesh.Point(to) - this->Mesh.Point(from);
    return { d.X / this->Diagonal, d.Y / this->Diagonal, d.Z / this->Diagonal };
  }
  /// What rounding of a point's coordinates alone can make.
  double Rounding(vtkIdType id) const { return RoundingOf(this->Mesh.Point(id)) / this->Diagonal; }

  static double RoundingOf(const Vector3& p)
  {
    return 4.0 * std::numeric_limits<double>::epsilon() * std::max({ std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }

private:
  const TriangleMeshView& Mesh;
  double Diagonal = 1.0;
};

} // namespace shadowcones

#endif
