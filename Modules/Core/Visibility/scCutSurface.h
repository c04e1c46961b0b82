// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCutSurface.h
 * @brief A surface of triangles that is cut at the middles of its sides, without gaps. Internal to Core.
 */
#ifndef scCutSurface_h
#define scCutSurface_h

#include "scSinglePrecision.h"
#include "scTriangleMesh.h"
#include "scVector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace shadowcones
{

class CutSurface
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /// Equal points with equal normals become one; @p normals 3 a point, or nullptr.
  CutSurface(const TriangleMeshView& mesh, const double* normals);

  std::vector<Vector3> Points;
  std::vector<Vector3> Normals; ///< one a point, unit or 0; empty: none
  std::vector<Triangle> Triangles;

  /// Cut sides that are longer, in rounds, until none is.
  void CutTo(double longest);
  /// Cut all sides of the triangles that are marked; their neighbours follow.
  void CutMarked(const std::vector<unsigned char>& marked);

  /// A place on a side, and the normal there. Its coordinates are in single precision where those of all points were.
  Vector3 On(vtkIdType a, vtkIdType b, double t) const;
  Vector3 NormalOn(vtkIdType a, vtkIdType b, double t) const;

  /// One number for a side, whichever end comes first.
  static std::uint64_t KeyOf(vtkIdType a, vtkIdType b)
  {
    const auto low = static_cast<std::uint64_t>(a < b ? a : b);
    const auto high = static_cast<std::uint64_t>(a < b ? b : a);
    return low << 32 | high;
  }

private:
  template <typename Chooser>
  bool Cut(const Chooser& isCut);
  vtkIdType MiddleOf(vtkIdType a, vtkIdType b);
  void Divide(const Triangle& t, const std::array<vtkIdType, 3>& middles, std::vector<Triangle>& result) const;

  std::unordered_map<std::uint64_t, vtkIdType> Middles; ///< of sides that were cut in this round
  bool SinglePrecision = true;
};

} // namespace shadowcones

#endif
