// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTuples.h
 * @brief Values of VTK arrays as plain ones, each checked. Internal to Data.
 */
#ifndef scTuples_h
#define scTuples_h

#include "scVector3.h"

#include "vtkDataArray.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;

namespace shadowcones
{

/// A number of any array as a whole one: cut off towards 0, and at the ends of the type's range; -1 of what is no number.
template <typename Whole>
Whole WholeOf(double value)
{
  constexpr auto least = std::numeric_limits<Whole>::lowest();
  constexpr auto most = std::numeric_limits<Whole>::max();
  return std::isnan(value)                    ? Whole(-1)
    : value <= static_cast<double>(least) ? least
    : value >= static_cast<double>(most)  ? most
                                          : static_cast<Whole>(value);
}

/// Outputs in single precision hold no larger radiance times a solid angle.
constexpr double LargestRadiance = 1e30;
/// Squares of larger lengths leave what single precision holds, and their volumes' squares what double precision does.
constexpr double LargestLength = 1e18;
/// Of grids; the largest length in smaller steps is a number that single precision does not hold.
constexpr double SmallestStep = 1e-18;

/// What is wrong with a coordinate or a size, as a sentence ends; nullptr: nothing.
inline const char* FaultOf(double value)
{
  return !std::isfinite(value) ? "is not finite" : std::fabs(value) > LargestLength ? "is beyond 1e18" : nullptr;
}
inline const char* FaultOf(const Vector3& a)
{
  const char* first = FaultOf(a.X) ? FaultOf(a.X) : FaultOf(a.Y);
  return first ? first : FaultOf(a.Z);
}

/// What whole numbers an array may have, and how a message about another one ends.
struct WholeRange
{
  int Least = std::numeric_limits<int>::lowest();
  int Most = std::numeric_limits<int>::max();
  const char* Expected = "a whole number that 32 bits hold";
};
constexpr WholeRange NotNegative{ 0, std::numeric_limits<int>::max(), "a whole number, 0 or more" };

/// A whole number of a range; @p item names what has it in messages.
bool ReadWholeNumber(
  vtkDataArray* array, const char* item, vtkIdType i, const WholeRange& range, int& value, std::string& error);
/// All of them.
bool CopyWholeNumbers(
  vtkDataArray* array, const char* item, const WholeRange& range, std::vector<int>& values, std::string& error);
/// Occluder ids: whole numbers that an int holds; @p item names one of them in messages.
bool CopyOccluderIds(vtkDataArray* array, const char* item, std::vector<int>& ids, std::string& error);
/// All points, in double precision.
void CopyPoints(vtkPolyData* input, std::vector<double>& points);
/// All points, which must be finite; @p item names one of them in messages.
bool CopyFinitePoints(vtkPolyData* input, const char* item, std::vector<double>& points, std::string& error);
/// Finite triples.
bool CopyTriples(vtkDataArray* array, const char* item, std::vector<double>& values, std::string& error);
/// A tuple of length 1; nearly 1 is rounding, and is put right.
bool ReadUnitVector(vtkDataArray* array, const char* item, vtkIdType i, Vector3& vector, std::string& error);
/// Unit vectors; those that already are unit in single precision keep their bytes.
bool CopyDirections(vtkDataArray* array, const char* item, std::vector<float>& directions, std::string& error);

} // namespace shadowcones

#endif
