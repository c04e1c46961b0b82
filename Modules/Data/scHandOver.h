// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scHandOver.h
 * @brief Large vectors as arrays of data sets, without a copy.
 */
#ifndef scHandOver_h
#define scHandOver_h

#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <utility>
#include <vector>

class vtkCellArray;

namespace shadowcones
{

/// Lives as long as the array that it observes, and has its values.
template <typename T>
class VectorKeeper : public vtkCommand
{
public:
  static VectorKeeper* New() { return new VectorKeeper; }
  void Execute(vtkObject*, unsigned long, void*) override {}

  std::vector<T> Values;
};

/// An array of the values, which are gone then. One that has far more room than values is copied: the room would stay.
template <typename ArrayT, typename T>
vtkSmartPointer<ArrayT> HandOver(int components, std::vector<T>& values)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetNumberOfComponents(components);
  vtkNew<VectorKeeper<T>> keeper;
  keeper->Values = std::exchange(values, {});
  if (keeper->Values.size() < keeper->Values.capacity() / 2)
  {
    keeper->Values.shrink_to_fit();
  }
  if (!keeper->Values.empty())
  {
    constexpr int keepsIt = 1; // the array does not free it
    array->SetArray(keeper->Values.data(), static_cast<vtkIdType>(keeper->Values.size()), keepsIt);
    array->AddObserver(vtkCommand::DeleteEvent, keeper);
  }
  return array;
}

/// The same, as an array of that name.
template <typename ArrayT, typename T>
void GiveArray(vtkFieldData* data, const char* name, int components, std::vector<T>& values)
{
  const auto array = HandOver<ArrayT>(components, values);
  array->SetName(name);
  data->AddArray(array);
}

/// A vertex for each of so many points.
vtkSmartPointer<vtkCellArray> VerticesOf(vtkIdType count);

} // namespace shadowcones

#endif
