// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scProbePoints.h
 * @brief The points or cells of a data set at which light is asked for.
 */
#ifndef scProbePoints_h
#define scProbePoints_h

#include "ShadowConesDataModule.h"
#include "scBox.h"
#include "scShadowClass.h"
#include "scVisibilityProbe.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataSet;

namespace shadowcones
{

/// Three coordinates each, and normals or none.
struct SHADOWCONESDATA_EXPORT ProbePoints
{
  std::vector<double> Points;
  std::vector<double> Normals;
  std::vector<vtkIdType> Items; ///< the point or cell of each
  vtkIdType NumberOfItems = 0;  ///< with those that are hidden
  Box Bounds;
  bool OnSurfaces = false; ///< there are normals, or the data set is one of polygons

  vtkIdType Count() const { return static_cast<vtkIdType>(this->Items.size()); }
};

/// Read the points of a data set, or the centres of its cells, that are not hidden. @return false, with a sentence in @p error,
/// where a coordinate is not finite.
SHADOWCONESDATA_EXPORT bool ReadProbePoints(
  vtkDataSet* data, bool atCells, bool useNormals, ProbePoints& points, std::string& error);

/// How many points are of this class towards every light.
SHADOWCONESDATA_EXPORT vtkIdType CountOfClass(const VisibilityResult& result, std::size_t lights, ShadowClass kind);

/// Values of some items, @p components each, among those of all @p count; the others get @p other.
template <typename T>
std::vector<T> Spread(
  const std::vector<T>& values, int components, const std::vector<vtkIdType>& items, vtkIdType count, T other)
{
  const auto n = static_cast<std::size_t>(components);
  std::vector<T> all(n * static_cast<std::size_t>(count), other);
  for (std::size_t k = 0; k < items.size(); ++k)
  {
    std::copy_n(values.data() + n * k, n, all.data() + n * static_cast<std::size_t>(items[k]));
  }
  return all;
}

} // namespace shadowcones

#endif
