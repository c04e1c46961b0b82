// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityData.h"

#include "scFieldArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shadowcones
{
namespace
{
/// A point array with one component and a value a point; nullptr, with a sentence, where it is not as it should be.
vtkDataArray* FindValues(vtkImageData* input, const char* name, std::string& error)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name);
  if (array && (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != input->GetNumberOfPoints()))
  {
    std::ostringstream text;
    text << "Point array \"" << name << "\" of the visibility volume has " << array->GetNumberOfTuples()
         << " values of " << array->GetNumberOfComponents() << " components for " << input->GetNumberOfPoints()
         << " points: it must have one component and one value a point.";
    error = text.str();
    return nullptr;
  }
  return array;
}

bool ReadPlacement(vtkImageData* input, VisibilityGrid& grid, std::string& error)
{
  int extent[6];
  input->GetExtent(extent);
  const double* origin = input->GetOrigin();
  const double* spacing = input->GetSpacing();
  double first[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    first[axis] = origin[axis] + extent[2 * axis] * spacing[axis];
    if (grid.Dimensions[axis] < 2)
    {
      std::ostringstream text;
      text << "The visibility volume has " << std::max(grid.Dimensions[axis], 0) << " points along "
           << "xyz"[axis] << ": it must have at least 2.";
      error = text.str();
      return false;
    }
    if (!std::isfinite(first[axis]) || !(spacing[axis] > 0.0) || std::isinf(spacing[axis]))
    {
      std::ostringstream text;
      text << "The visibility volume begins at " << first[axis] << " along "
           << "xyz"[axis] << " with a spacing of " << spacing[axis]
           << ": both must be finite, and the spacing above 0.";
      error = text.str();
      return false;
    }
  }
  if (!input->GetDirectionMatrix()->IsIdentity())
  {
    error = "The visibility volume is rotated by its direction matrix: its axes must be those of the world.";
    return false;
  }
  grid.Origin = { first[0], first[1], first[2] };
  grid.Spacing = { spacing[0], spacing[1], spacing[2] };
  return true;
}

bool ReadValues(vtkImageData* input, VisibilityGrid& grid, std::string& error)
{
  vtkDataArray* visibility = FindValues(input, "Visibility", error);
  if (!visibility)
  {
    error = error.empty() ? "The visibility volume has no point array \"Visibility\"." : error;
    return false;
  }
  vtkDataArray* classes = FindValues(input, "ShadowClass", error);
  vtkDataArray* marked = error.empty() ? FindValues(input, "Marked", error) : nullptr;
  if (!error.empty())
  {
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  grid.Visibility.resize(static_cast<std::size_t>(count));
  grid.ShadowClasses.resize(grid.Visibility.size());
  grid.Marked.resize(grid.Visibility.size());
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = visibility->GetComponent(i, 0);
    if (!(value >= 0.0 && value <= 1.0))
    {
      std::ostringstream text;
      text << "\"Visibility\" of the visibility volume is " << value << " at point " << i << ": it must be in 0..1.";
      error = text.str();
      return false;
    }
    const ShadowClass byValue =
      value == 1.0 ? ShadowClass::Lit : (value == 0.0 ? ShadowClass::Umbra : ShadowClass::Penumbra);
    const auto id = static_cast<std::size_t>(i);
    grid.Visibility[id] = static_cast<float>(value);
    grid.ShadowClasses[id] =
      static_cast<unsigned char>(classes ? classes->GetComponent(i, 0) : static_cast<double>(byValue));
    grid.Marked[id] = value < 1.0 || (marked && marked->GetComponent(i, 0) != 0.0) ? 1 : 0;
  }
  return true;
}

/// Are the bricks of this very grid, and not of one that it was cut or resampled from?
bool HasBricks(vtkFieldData* field, const VisibilityGrid& grid)
{
  vtkDataArray* parts = field->GetArray("BrickParts");
  vtkDataArray* dimensions = field->GetArray("BrickDimensions");
  if (!parts || parts->GetNumberOfValues() != 1 || parts->GetComponent(0, 0) == 0.0 || !dimensions ||
    dimensions->GetNumberOfValues() != 3)
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (dimensions->GetVariantValue(axis).ToInt() != grid.Dimensions[axis])
    {
      return false;
    }
  }
  return true;
}

bool ReadBricks(vtkFieldData* field, VisibilityGrid& grid, std::string& error)
{
  vtkDataArray* cells = field->GetArray("BrickCells");
  vtkDataArray* values = field->GetArray("BrickVisibility");
  const double parts = field->GetArray("BrickParts")->GetComponent(0, 0);
  const double side = parts + 1.0;
  if (!cells || !values || !(parts >= 1.0 && parts <= 1024.0) || cells->GetNumberOfComponents() != 1 ||
    values->GetNumberOfComponents() != side * side * side || values->GetNumberOfTuples() != cells->GetNumberOfTuples())
  {
    error =
      "The field data of the visibility volume do not fit together: \"BrickVisibility\" must have a tuple for each of "
      "\"BrickCells\", of \"BrickParts\" + 1 values to the power of three.";
    return false;
  }
  grid.BrickParts = static_cast<int>(parts);
  const vtkIdType numberOfCells = grid.CellIndex(0, 0, grid.Dimensions[2] - 1);
  for (vtkIdType brick = 0; brick < cells->GetNumberOfTuples(); ++brick)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(brick, 0));
    if (cell < 0 || cell >= numberOfCells || (brick > 0 && cell <= grid.BrickCells.back()))
    {
      error = "\"BrickCells\" of the visibility volume must be cells of the volume in ascending order: that of brick " +
        std::to_string(brick) + " is " + std::to_string(cell) + ".";
      return false;
    }
    grid.BrickCells.push_back(cell);
  }
  grid.BrickVisibility.resize(static_cast<std::size_t>(values->GetNumberOfValues()));
  for (vtkIdType brick = 0; brick < values->GetNumberOfTuples(); ++brick)
  {
    const int components = values->GetNumberOfComponents();
    for (int c = 0; c < components; ++c)
    {
      const double value = values->GetComponent(brick, c);
      if (!(value >= 0.0 && value <= 1.0))
      {
        std::ostringstream text;
        text << "\"BrickVisibility\" of the visibility volume is " << value << " in brick " << brick
             << ": it must be in 0..1.";
        error = text.str();
        return false;
      }
      grid.BrickVisibility[static_cast<std::size_t>(brick * components + c)] = static_cast<float>(value);
    }
  }
  return true;
}
} // anonymous namespace

bool ReadVisibilityGrid(vtkImageData* input, VisibilityGrid& grid, std::string& error)
{
  grid = {};
  error.clear();
  return ReadPlacement(input, grid, error) && ReadValues(input, grid, error) &&
    (!HasBricks(input->GetFieldData(), grid) || ReadBricks(input->GetFieldData(), grid, error));
}

void WriteVisibilityGrid(const VisibilityGrid& grid, const int extent[6], vtkImageData* output)
{
  output->SetExtent(const_cast<int*>(extent));
  output->SetOrigin(grid.Origin.X, grid.Origin.Y, grid.Origin.Z);
  output->SetSpacing(grid.Spacing.X, grid.Spacing.Y, grid.Spacing.Z);
  vtkNew<vtkFloatArray> visibility;
  vtkNew<vtkUnsignedCharArray> classes;
  vtkNew<vtkUnsignedCharArray> marked;
  visibility->SetName("Visibility");
  classes->SetName("ShadowClass");
  marked->SetName("Marked");
  const vtkIdType count = output->GetNumberOfPoints();
  visibility->SetNumberOfTuples(count);
  classes->SetNumberOfTuples(count);
  marked->SetNumberOfTuples(count);
  const auto row = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  std::size_t to = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j, to += row)
    {
      const std::size_t from = grid.VertexIndex(extent[0], j, k);
      std::copy_n(grid.Visibility.data() + from, row, visibility->GetPointer(0) + to);
      std::copy_n(grid.ShadowClasses.data() + from, row, classes->GetPointer(0) + to);
      std::copy_n(grid.Marked.data() + from, row, marked->GetPointer(0) + to);
    }
  }
  output->GetPointData()->SetScalars(visibility);
  output->GetPointData()->AddArray(classes);
  output->GetPointData()->AddArray(marked);

  vtkFieldData* field = output->GetFieldData();
  AddIntArray(field, "BrickParts", 1, { grid.BrickParts });
  AddIntArray(field, "BrickDimensions", 3, { grid.Dimensions[0], grid.Dimensions[1], grid.Dimensions[2] });
  if (!grid.BrickCells.empty())
  {
    const int side = grid.BrickParts + 1;
    AddIdArray(field, "BrickCells", grid.BrickCells);
    AddFloatArray(field, "BrickVisibility", side * side * side, grid.BrickVisibility);
  }
}

void WriteVisibility(const VisibilityResult& result, vtkDataSetAttributes* data)
{
  AddFloatArray(data, "Visibility", 1, result.Visibility);
  AddByteArray(data, "ShadowClass", result.ShadowClasses);
  AddIntArray(data, "OccluderId", 1, result.OccluderIds);
  AddFloatArray(data, "VisibilityError", 1, result.Errors);
}

} // namespace shadowcones
