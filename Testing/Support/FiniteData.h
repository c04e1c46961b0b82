// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FiniteData.h
 * @brief Does any number that is none, or an infinite one, leave a filter?
 */
#ifndef FiniteData_h
#define FiniteData_h

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>
#include <set>
#include <string>

namespace shadowcones
{
namespace testsupport
{

/// Arrays whose documentation has NaN or infinity among their values.
inline bool MayBeNotFinite(const std::string& name)
{
  for (const char* one : { "PenumbraWidth", "PenumbraWidthError", "CertifiedBounds", "Precision", "PrecisionLow",
         "PrecisionHigh", "TuningObjective", "TuningLeak", "TuningLost" })
  {
    if (name == one)
    {
      return true;
    }
  }
  return false;
}

/// Names of arrays that a filter only hands on.
using HandedOn = std::set<std::string>;

/// The first array with a number that is not finite; empty: none.
inline std::string NotFiniteIn(vtkFieldData* data, const HandedOn& handedOn = {})
{
  for (int k = 0; data && k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    const std::string name = array && array->GetName() ? array->GetName() : "an array";
    if (!array || (array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE) || MayBeNotFinite(name) ||
      handedOn.count(name) > 0)
    {
      continue;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        if (!std::isfinite(array->GetComponent(i, c)))
        {
          return name + " holds " + std::to_string(array->GetComponent(i, c));
        }
      }
    }
  }
  return {};
}

/// The same of a data object: points, and arrays of points, cells and fields. Tables are left out: 0 / 0 is NaN there.
inline std::string NotFiniteIn(vtkDataObject* data, const HandedOn& handedOn = {})
{
  if (!data || vtkTable::SafeDownCast(data))
  {
    return {};
  }
  auto* set = vtkDataSet::SafeDownCast(data);
  std::string found = NotFiniteIn(data->GetFieldData(), handedOn);
  if (!set || !found.empty())
  {
    return found;
  }
  found = NotFiniteIn(set->GetPointData(), handedOn);
  found = found.empty() ? NotFiniteIn(set->GetCellData(), handedOn) : found;
  for (vtkIdType i = 0; found.empty() && i < set->GetNumberOfPoints(); ++i)
  {
    double p[3];
    set->GetPoint(i, p);
    found = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) ? std::string() : "a point is not finite";
  }
  return found;
}

/// The same of all outputs of a filter.
inline std::string NotFiniteOf(vtkAlgorithm* filter, const HandedOn& handedOn = {})
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    const std::string found = NotFiniteIn(filter->GetOutputDataObject(port), handedOn);
    if (!found.empty())
    {
      return "output " + std::to_string(port) + ": " + found;
    }
  }
  return {};
}

} // namespace testsupport
} // namespace shadowcones

#endif
