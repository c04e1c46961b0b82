// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderNames.h"

#include "scSentence.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cmath>
#include <limits>
#include <type_traits>

namespace shadowcones
{
namespace
{

constexpr const char* namesArray = "OccluderNames";

template <typename T>
bool ToGivenId(T value, GivenId& id)
{
  id = GivenId();
  if constexpr (std::is_floating_point<T>::value)
  {
    constexpr double end = 18446744073709551616.0; // 2^64
    const double number = value;
    id.Receiver = number < 0.0;
    if (number >= end)
    {
      id.Whole = std::numeric_limits<std::uint64_t>::max();
      id.Rest = number;
    }
    else if (number >= 0.0)
    {
      id.Whole = static_cast<std::uint64_t>(number);
      id.Rest = number - std::floor(number);
    }
    return !std::isnan(number);
  }
  else
  {
    if constexpr (std::is_signed<T>::value)
    {
      id.Receiver = value < T(0);
    }
    id.Whole = id.Receiver ? 0 : static_cast<std::uint64_t>(value);
    return true;
  }
}

/// Reads every value in the array's own type.
struct IdReader
{
  template <typename ArrayT>
  void operator()(ArrayT* array, std::vector<GivenId>& ids, vtkIdType& fault) const
  {
    using ValueT = vtk::GetAPIType<ArrayT>;
    const auto tuples = vtk::DataArrayTupleRange(array);
    for (vtkIdType i = 0; i < tuples.size(); ++i)
    {
      if (!ToGivenId(static_cast<ValueT>(tuples[i][0]), ids[static_cast<std::size_t>(i)]))
      {
        fault = i;
        return;
      }
    }
  }
};

} // namespace

std::string GivenId::Text() const
{
  if (this->Rest >= 1.0)
  {
    return Sentence(this->Rest);
  }
  if (this->Rest == 0.0)
  {
    return std::to_string(this->Whole);
  }
  std::ostringstream text;
  text.precision(15);
  text << static_cast<double>(this->Whole) + this->Rest;
  return text.str();
}

bool ReadGivenIds(vtkDataArray* array, const char* item, std::vector<GivenId>& ids, std::string& error)
{
  ids.assign(static_cast<std::size_t>(array->GetNumberOfTuples()), GivenId());
  vtkIdType fault = -1;
  if (!vtkArrayDispatch::Dispatch::Execute(array, IdReader(), ids, fault))
  {
    IdReader()(array, ids, fault);
  }
  if (fault >= 0)
  {
    error = Sentence("The \"", array->GetName(), "\" of ", item, " ", fault,
      " is not a number: it must be 0 or above, or below 0 for a receiver.");
  }
  return fault < 0;
}

int OccluderNumbers::Of(const std::string& key, const std::string& name)
{
  const auto found = this->Numbers.emplace(key, static_cast<int>(this->Names.size()));
  if (found.second)
  {
    this->Names.push_back(name);
  }
  return found.first->second;
}

std::vector<std::string> ReadOccluderNames(vtkFieldData* data)
{
  std::vector<std::string> names;
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(namesArray));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    names.push_back(array->GetValue(i));
  }
  return names;
}

void WriteOccluderNames(const std::vector<std::string>& names, vtkFieldData* data)
{
  data->RemoveArray(namesArray);
  if (!names.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(namesArray);
    for (const std::string& name : names)
    {
      array->InsertNextValue(name);
    }
    data->AddArray(array);
  }
}

} // namespace shadowcones
