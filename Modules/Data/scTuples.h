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
#include <string>
#include <vector>

class vtkPolyData;

namespace shadowcones
{

inline void CopyInts(vtkDataArray* array, std::vector<int>& values)
{
  values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values[i] = static_cast<int>(array->GetComponent(i, 0));
  }
}

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
