// SPDX-License-Identifier: BSD-3-Clause
#include "scDensityData.h"

#include "scSentence.h"
#include "scTuples.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <cmath>
#include <sstream>

namespace shadowcones
{

namespace
{

vtkDataArray* FindDensity(vtkImageData* input)
{
  vtkPointData* points = input->GetPointData();
  if (vtkDataArray* named = points->GetArray("Density"))
  {
    return named;
  }
  if (vtkDataArray* scalars = points->GetScalars())
  {
    return scalars;
  }
  for (int k = 0; k < points->GetNumberOfArrays(); ++k)
  {
    if (vtkDataArray* array = points->GetArray(k))
    {
      return array;
    }
  }
  return nullptr;
}

void ReadPlacement(vtkImageData* input, DensityGrid& grid)
{
  int extent[6];
  double spacing[3];
  double origin[3];
  input->GetExtent(extent);
  input->GetSpacing(spacing);
  input->GetOrigin(origin);
  const double* direction = input->GetDirectionMatrix()->GetData();
  grid.Origin = { origin[0], origin[1], origin[2] };
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    grid.Dimensions[a] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    // Nothing depends on the spacing along an axis with one point.
    const double step = grid.Dimensions[a] == 1 ? 1.0 : spacing[axis];
    grid.Axes[a] = { step * direction[axis], step * direction[3 + axis], step * direction[6 + axis] };
    grid.Origin += static_cast<double>(extent[2 * axis]) * grid.Axes[a];
  }
}

/// The array as floats; false, with a sentence in @p error, where a value is no density.
bool ReadValues(vtkDataArray* array, DensityGrid& grid, std::string& error)
{
  const vtkIdType count = array->GetNumberOfTuples();
  grid.Values.resize(static_cast<std::size_t>(count));
  for (vtkIdType point = 0; point < count; ++point)
  {
    const auto value = static_cast<float>(array->GetComponent(point, 0));
    if (!(value >= 0.0f) || FaultOf(static_cast<double>(value)))
    {
      std::ostringstream message;
      message << "The density of point " << point << " is " << array->GetComponent(point, 0)
              << ": it must be finite, 0 or above and at most 1e18.";
      error = message.str();
      return false;
    }
    grid.Values[static_cast<std::size_t>(point)] = value;
  }
  return true;
}

} // namespace

bool ChooseDensity(vtkAlgorithm* filter, int port, vtkImageData* density, vtkDataArray*& values, std::string& error)
{
  vtkInformationVector* choices = filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* choice = choices ? choices->GetInformationObject(0) : nullptr;
  const std::string name =
    choice && choice->Has(vtkDataObject::FIELD_NAME()) ? choice->Get(vtkDataObject::FIELD_NAME()) : "(automatic)";
  const bool byAttribute = choice && choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  if (!density || !choice || (!byAttribute && (name.empty() || name == "(automatic)")))
  {
    return true; // the usual one
  }
  const int association = choice->Get(vtkDataObject::FIELD_ASSOCIATION());
  vtkPointData* points = density->GetPointData();
  if (choice->Get(vtkAlgorithm::INPUT_PORT()) != port)
  {
    error = Sentence("SetInputArrayToProcess chooses an array of input port ", choice->Get(vtkAlgorithm::INPUT_PORT()),
      ": the only one to be chosen is the density's, of input port ", port, ".");
  }
  else if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    association != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    error = "SetInputArrayToProcess chooses a density that is not point data: run vtkCellDataToPointData first.";
  }
  else if (!byAttribute)
  {
    values = points->GetArray(name.c_str());
    std::string others;
    for (int i = 0; i < points->GetNumberOfArrays(); ++i)
    {
      const char* other = points->GetArrayName(i);
      others += (i == 0 ? "\"" : ", \"") + std::string(other ? other : "") + "\"";
    }
    error = values ? ""
                   : Sentence("The density on input port ", port, " has no point array \"", name,
                       "\", which SetInputArrayToProcess chooses: it has ", others.empty() ? "none" : others, ".");
  }
  else
  {
    values = points->GetAttribute(choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
    error = values
      ? ""
      : Sentence("The density on input port ", port, " lacks the attribute that SetInputArrayToProcess chooses.");
  }
  return error.empty();
}

bool ReadDensity(vtkImageData* input, vtkDataArray* chosen, DensityGrid& grid, std::string& error)
{
  grid = DensityGrid();
  if (!input || input->GetNumberOfPoints() == 0)
  {
    error = "There are no points.";
    return false;
  }
  vtkDataArray* array = chosen ? chosen : FindDensity(input);
  if (!array)
  {
    error = "There is no point array: name it \"Density\" or make it the active scalars. Cell data can be turned into "
            "point data with vtkCellDataToPointData.";
    return false;
  }
  const std::string name = array->GetName() ? array->GetName() : "";
  if (array->GetNumberOfComponents() != 1)
  {
    error = "The point array \"" + name + "\" has " + std::to_string(array->GetNumberOfComponents()) +
      " components where a density has 1.";
    return false;
  }
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    error = "The point array \"" + name + "\" has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(input->GetNumberOfPoints()) + " points.";
    return false;
  }
  ReadPlacement(input, grid);
  if (!ReadValues(array, grid, error))
  {
    return false;
  }
  if (const char* fault = PrepareDensityGrid(grid))
  {
    error = fault;
    return false;
  }
  return true;
}

} // namespace shadowcones
