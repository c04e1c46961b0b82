// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFieldArrays.h
 * @brief Named arrays: found and checked, and added; vertices.
 */
#ifndef scFieldArrays_h
#define scFieldArrays_h

#include "ShadowConesDataModule.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkPolyData;

namespace shadowcones
{

/// Must an array be there?
enum class Need
{
  Required,
  Optional
};

/**
 * Find a numeric array of the right shape. @return false, with a sentence in @p error that names it and its @p owner,
 * where it is missing but required, or has the wrong size.
 */
SHADOWCONESDATA_EXPORT bool FindArray(vtkFieldData* data, const char* owner, const char* name, int components,
  vtkIdType tuples, Need need, vtkDataArray*& array, std::string& error);

/// Every array of the attributes has a tuple for each of @p count items, so that it can be passed on; @p what names
/// their kind. @return false, with a sentence in @p error.
SHADOWCONESDATA_EXPORT bool CheckAttributes(
  vtkDataSetAttributes* data, vtkIdType count, const char* what, std::string& error);

/// Throws std::overflow_error, whose sentence names the array, where a value left single precision.
SHADOWCONESDATA_EXPORT void CheckSinglePrecision(const char* name, const std::vector<float>& values);

/**
 * A new named array with a copy of values, components a tuple; types as in the name. Floats are checked by
 * CheckSinglePrecision().
 */
SHADOWCONESDATA_EXPORT void AddFloatArray(
  vtkFieldData* data, const char* name, int components, const std::vector<float>& values);
SHADOWCONESDATA_EXPORT void AddDoubleArray(
  vtkFieldData* data, const char* name, int components, const std::vector<double>& values);
SHADOWCONESDATA_EXPORT void AddIntArray(
  vtkFieldData* data, const char* name, int components, const std::vector<int>& values);
SHADOWCONESDATA_EXPORT void AddIdArray(
  vtkFieldData* data, const char* name, const std::vector<vtkIdType>& values, int components = 1);
SHADOWCONESDATA_EXPORT void AddByteArray(
  vtkFieldData* data, const char* name, const std::vector<unsigned char>& values, int components = 1);
/// Points in double precision with one vertex cell each.
SHADOWCONESDATA_EXPORT void SetVertices(vtkPolyData* output, const std::vector<double>& points);

} // namespace shadowcones

#endif
