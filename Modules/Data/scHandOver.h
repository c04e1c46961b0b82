// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scHandOver.h
 * @brief Large vectors as arrays of data sets, without a copy.
 */
#ifndef scHandOver_h
#define scHandOver_h

#include "scFieldArrays.h"

#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

class vtkCellArray;

namespace shadowcones
{

/// Keep what lies at @p place until FreeKept() is called with it, as VTK does when the last array that uses it is gone.
SHADOWCONESDATA_EXPORT void KeepUntilFreed(void* place, std::shared_ptr<void> values);
SHADOWCONESDATA_EXPORT void FreeKept(void* place);

/// An array of the values, which are gone then. One that has far more room than values is copied: the room would stay.
template <typename ArrayT, typename T>
vtkSmartPointer<ArrayT> HandOver(int components, std::vector<T>& values)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetNumberOfComponents(components);
  const auto kept = std::make_shared<std::vector<T>>(std::exchange(values, {}));
  if (kept->size() < kept->capacity() / 2)
  {
    kept->shrink_to_fit();
  }
  if (!kept->empty())
  {
    KeepUntilFreed(kept->data(), kept);
    array->SetArray(kept->data(), static_cast<vtkIdType>(kept->size()), 0, ArrayT::VTK_DATA_ARRAY_USER_DEFINED);
    array->SetArrayFreeFunction(FreeKept);
  }
  return array;
}

/// The same, as an array of that name; throws as AddFloatArray().
template <typename ArrayT, typename T>
void GiveArray(vtkFieldData* data, const char* name, int components, std::vector<T>& values)
{
  if constexpr (std::is_same_v<T, float>)
  {
    CheckSinglePrecision(name, values);
  }
  const auto array = HandOver<ArrayT>(components, values);
  array->SetName(name);
  data->AddArray(array);
}

/// A vertex for each of so many points.
vtkSmartPointer<vtkCellArray> VerticesOf(vtkIdType count);

} // namespace shadowcones

#endif
