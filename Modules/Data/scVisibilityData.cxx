// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityData.h"

#include "scFieldArrays.h"
#include "scFingerprint.h"
#include "scParallel.h"
#include "scProbePoints.h"
#include "scSentence.h"
#include "scShadowClass.h"
#include "scTuples.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace shadowcones
{
namespace
{
/// A point array with so many components and a tuple a point; nullptr, with a sentence, where it is not as it should
/// be.
vtkDataArray* FindValues(vtkImageData* input, const char* name, int components, std::string& error)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name);
  if (array &&
    (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != input->GetNumberOfPoints()))
  {
    std::ostringstream text;
    text << "Point array \"" << name << "\" of the visibility volume has " << array->GetNumberOfTuples()
         << " values of " << array->GetNumberOfComponents() << " components for " << input->GetNumberOfPoints()
         << " points: it must have " << components << " components and a tuple a point.";
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
    if (FaultOf(first[axis]) || FaultOf(spacing[axis]) || !(spacing[axis] >= SmallestStep))
    {
      std::ostringstream text;
      text << "The visibility volume begins at " << first[axis] << " along "
           << "xyz"[axis] << " with a spacing of " << spacing[axis]
           << ": both must be finite and at most 1e18, and the spacing at least 1e-18.";
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

/// The class of a point of which only the visible fraction is known, as a number.
double ClassOf(double visibility)
{
  return static_cast<double>(
    visibility == 1.0 ? ShadowClass::Lit : (visibility == 0.0 ? ShadowClass::Umbra : ShadowClass::Penumbra));
}

/// @return false where the value or its class is out of range.
bool SetValue(std::size_t id, double value, double shadow, bool marked, VisibilityGrid& grid)
{
  if (!(value >= 0.0 && value <= 1.0) || !IsShadowClass(shadow))
  {
    return false;
  }
  grid.Visibility[id] = static_cast<float>(value);
  grid.ShadowClasses[id] = static_cast<unsigned char>(shadow);
  grid.Marked[id] = value < 1.0 || marked ? 1 : 0;
  return true;
}

/// The values of one of some lights, by several threads; @p classes and @p marked may be null. @return the first point whose
/// value is out of range, or -1.
vtkIdType CopyValues(const float* values, const unsigned char* classes, const unsigned char* marked, int light,
  int lights, VisibilityGrid& grid)
{
  const auto count = static_cast<vtkIdType>(grid.Visibility.size());
  std::atomic<vtkIdType> firstBad{ count };
  ParallelFor(count, {},
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType at = i * lights + light;
        const auto value = static_cast<double>(values[at]);
        if (!SetValue(static_cast<std::size_t>(i), value, classes ? static_cast<double>(classes[at]) : ClassOf(value),
              marked && marked[i] != 0, grid))
        {
          vtkIdType known = firstBad;
          while (i < known && !firstBad.compare_exchange_weak(known, i))
          {
          }
          return;
        }
      }
    });
  const vtkIdType first = firstBad;
  return first < count ? first : -1;
}

/// Of the light of this index.
bool ReadValues(vtkImageData* input, int light, int lights, VisibilityGrid& grid, std::string& error)
{
  vtkDataArray* visibility = FindValues(input, "Visibility", lights, error);
  if (!visibility)
  {
    error = error.empty() ? "The visibility volume has no point array \"Visibility\"." : error;
    return false;
  }
  vtkDataArray* classes = FindValues(input, "ShadowClass", lights, error);
  vtkDataArray* marked = error.empty() ? FindValues(input, "Marked", 1, error) : nullptr;
  if (!error.empty())
  {
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  grid.Visibility.resize(static_cast<std::size_t>(count));
  grid.ShadowClasses.resize(grid.Visibility.size());
  grid.Marked.resize(grid.Visibility.size());
  auto* floats = vtkFloatArray::FastDownCast(visibility);
  auto* classBytes = vtkUnsignedCharArray::FastDownCast(classes);
  auto* markedBytes = vtkUnsignedCharArray::FastDownCast(marked);
  vtkIdType bad = -1;
  if (floats && (!classes || classBytes) && (!marked || markedBytes))
  {
    const auto valuesOf = [](auto* array) { return array ? array->GetPointer(0) : nullptr; };
    bad = CopyValues(floats->GetPointer(0), valuesOf(classBytes), valuesOf(markedBytes), light, lights, grid);
  }
  else
  {
    // Arrays of other types need not be safe to ask from several threads.
    for (vtkIdType i = 0; i < count && bad < 0; ++i)
    {
      const double value = visibility->GetComponent(i, light);
      bad = SetValue(static_cast<std::size_t>(i), value, classes ? classes->GetComponent(i, light) : ClassOf(value),
              marked && marked->GetComponent(i, 0) != 0.0, grid)
        ? -1
        : i;
    }
  }
  if (bad >= 0)
  {
    const bool byClass = classes && !IsShadowClass(classes->GetComponent(bad, light));
    std::ostringstream text;
    text << (byClass ? "\"ShadowClass\"" : "\"Visibility\"") << " of the visibility volume is "
         << (byClass ? classes : visibility)->GetComponent(bad, light) << " at point " << bad << ": it must be "
         << (byClass ? "0, 1 or 2." : "in 0..1.");
    error = text.str();
  }
  return bad < 0;
}

/// Of the values at the points of the lights' grids, which the bricks refine.
vtkIdType HashOf(const std::vector<VisibilityGrid>& grids)
{
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < grids.front().Visibility.size(); ++i)
  {
    for (const VisibilityGrid& grid : grids)
    {
      fingerprint.AddNumber(static_cast<double>(grid.Visibility[i]));
    }
  }
  return static_cast<vtkIdType>(fingerprint.Value());
}

/// Is this the array that was written with the grid? Files round numbers.
bool Holds(vtkFieldData* field, const char* name, const std::vector<double>& values, double tolerance)
{
  vtkDataArray* array = field->GetArray(name);
  bool same = array && array->GetNumberOfValues() == static_cast<vtkIdType>(values.size());
  for (std::size_t i = 0; same && i < values.size(); ++i)
  {
    same = std::abs(array->GetVariantValue(static_cast<vtkIdType>(i)).ToDouble() - values[i]) <= tolerance;
  }
  return same;
}

std::vector<double> DimensionsOf(const VisibilityGrid& grid)
{
  return { grid.Dimensions.begin(), grid.Dimensions.end() };
}

std::vector<double> PlacementOf(const VisibilityGrid& grid)
{
  return { grid.Origin.X, grid.Origin.Y, grid.Origin.Z, grid.Spacing.X, grid.Spacing.Y, grid.Spacing.Z };
}

/// Are there bricks, and of these very grids: not of some that they were cut, resampled or computed from?
bool HasBricks(vtkFieldData* field, const std::vector<VisibilityGrid>& grids, std::string& warning)
{
  const VisibilityGrid& grid = grids.front();
  vtkDataArray* parts = field->GetArray("BrickParts");
  vtkDataArray* cells = field->GetArray("BrickCells");
  if (!parts || parts->GetNumberOfValues() != 1 || parts->GetComponent(0, 0) == 0.0 || !cells)
  {
    return false;
  }
  const double detail = 1e-6 * std::min({ grid.Spacing.X, grid.Spacing.Y, grid.Spacing.Z });
  const double size = std::max({ std::abs(grid.Origin.X), std::abs(grid.Origin.Y), std::abs(grid.Origin.Z) });
  const char* changed = nullptr;
  auto* hash = vtkIdTypeArray::SafeDownCast(field->GetAbstractArray("BrickHash"));
  if (!Holds(field, "BrickDimensions", DimensionsOf(grid), 0.0))
  {
    changed = "dimensions";
  }
  else if (!Holds(field, "BrickPlacement", PlacementOf(grid), detail + 1e-9 * size))
  {
    changed = "origin or spacing";
  }
  else if (!hash || hash->GetNumberOfValues() != 1 ||
    hash->GetValue(0) != HashOf(grids))
  {
    changed = "\"Visibility\"";
  }
  if (changed)
  {
    warning = Sentence("The ", cells->GetNumberOfTuples(), " bricks of the visibility volume are left out: they were "
      "filled for another ", changed, " than it has now. Shadows have the detail of its grid; for more, run "
      "vtkVisibilityVolume on the grid that you need.");
  }
  return !changed;
}

/// Of the light of this index, of so many.
bool ReadBricks(vtkFieldData* field, int light, int lights, VisibilityGrid& grid, std::string& error)
{
  vtkDataArray* cells = field->GetArray("BrickCells");
  vtkDataArray* values = field->GetArray("BrickVisibility");
  vtkDataArray* lightIds = field->GetArray("BrickLightId");
  const double parts = field->GetArray("BrickParts")->GetComponent(0, 0);
  const double side = parts + 1.0;
  if (!cells || !values || !(parts >= 1.0 && parts <= 1024.0) || cells->GetNumberOfComponents() != 1 ||
    values->GetNumberOfComponents() != side * side * side ||
    values->GetNumberOfTuples() != cells->GetNumberOfTuples() ||
    (lightIds &&
      (lightIds->GetNumberOfComponents() != 1 || lightIds->GetNumberOfTuples() != cells->GetNumberOfTuples())))
  {
    error =
      "The field data of the visibility volume do not fit together: \"BrickVisibility\" must have a tuple for each of "
      "\"BrickCells\", of \"BrickParts\" + 1 values to the power of three.";
    return false;
  }
  grid.BrickParts = static_cast<int>(parts);
  const vtkIdType numberOfCells = grid.CellIndex(0, 0, grid.Dimensions[2] - 1);
  std::vector<int> lightOf(static_cast<std::size_t>(cells->GetNumberOfTuples()), 0);
  if (lightIds && !CopyWholeNumbers(lightIds, "brick", { 0, lights - 1, "that of a light of the volume" }, lightOf, error))
  {
    return false;
  }
  const auto isOther = [&lightOf, light](vtkIdType brick) { return lightOf[brick] != light; };
  for (vtkIdType brick = 0; brick < cells->GetNumberOfTuples(); ++brick)
  {
    if (isOther(brick))
    {
      continue;
    }
    const double cell = cells->GetComponent(brick, 0);
    const double before = grid.BrickCells.empty() ? -1.0 : static_cast<double>(grid.BrickCells.back());
    if (!(cell > before && cell < static_cast<double>(numberOfCells) && cell == std::floor(cell)))
    {
      error = Sentence("\"BrickCells\" of the visibility volume must be cells of the volume in ascending order: that of brick ",
        brick, " is ", ShortestText(cell), ".");
      return false;
    }
    grid.BrickCells.push_back(static_cast<vtkIdType>(cell));
  }
  grid.BrickVisibility.reserve(static_cast<std::size_t>(values->GetNumberOfComponents()) * grid.BrickCells.size());
  for (vtkIdType brick = 0; brick < values->GetNumberOfTuples(); ++brick)
  {
    if (isOther(brick))
    {
      continue;
    }
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
      grid.BrickVisibility.push_back(static_cast<float>(value));
    }
  }
  return true;
}
/// The bricks of all lights, one light after the other.
void WriteBricks(const std::vector<VisibilityGrid>& grids, vtkFieldData* field)
{
  int parts = 0;
  std::vector<vtkIdType> cells;
  std::vector<float> values;
  std::vector<int> lightIds;
  for (std::size_t light = 0; light < grids.size(); ++light)
  {
    const VisibilityGrid& grid = grids[light];
    parts = std::max(parts, grid.BrickParts);
    cells.insert(cells.end(), grid.BrickCells.begin(), grid.BrickCells.end());
    values.insert(values.end(), grid.BrickVisibility.begin(), grid.BrickVisibility.end());
    lightIds.insert(lightIds.end(), grid.BrickCells.size(), static_cast<int>(light));
  }
  const std::array<int, 3>& n = grids.front().Dimensions;
  AddIntArray(field, "BrickParts", 1, { parts });
  AddIntArray(field, "BrickDimensions", 3, { n[0], n[1], n[2] });
  if (!cells.empty())
  {
    const int side = parts + 1;
    AddDoubleArray(field, "BrickPlacement", 6, PlacementOf(grids.front()));
    AddIdArray(field, "BrickHash", { HashOf(grids) });
    AddIdArray(field, "BrickCells", cells);
    AddFloatArray(field, "BrickVisibility", side * side * side, values);
    if (grids.size() > 1)
    {
      AddIntArray(field, "BrickLightId", 1, lightIds);
    }
  }
}

} // anonymous namespace

bool ReadVisibilityGrids(
  vtkImageData* input, std::vector<VisibilityGrid>& grids, std::string& error, std::string& warning)
{
  error.clear();
  warning.clear();
  vtkDataArray* visibility = input->GetPointData()->GetArray("Visibility");
  const int lights = visibility ? std::max(visibility->GetNumberOfComponents(), 1) : 1;
  grids.assign(static_cast<std::size_t>(lights), {});
  for (int light = 0; light < lights; ++light)
  {
    VisibilityGrid& grid = grids[static_cast<std::size_t>(light)];
    if (!ReadPlacement(input, grid, error) || !ReadValues(input, light, lights, grid, error))
    {
      return false;
    }
  }
  const bool hasBricks = HasBricks(input->GetFieldData(), grids, warning);
  for (int light = 0; hasBricks && light < lights; ++light)
  {
    if (!ReadBricks(input->GetFieldData(), light, lights, grids[static_cast<std::size_t>(light)], error))
    {
      return false;
    }
  }
  return true;
}

void WriteVisibilityGrids(const std::vector<VisibilityGrid>& grids, const int extent[6], vtkImageData* output)
{
  const VisibilityGrid& first = grids.front();
  output->SetExtent(const_cast<int*>(extent));
  output->SetOrigin(first.Origin.X, first.Origin.Y, first.Origin.Z);
  output->SetSpacing(first.Spacing.X, first.Spacing.Y, first.Spacing.Z);
  vtkNew<vtkFloatArray> visibility;
  vtkNew<vtkUnsignedCharArray> classes;
  vtkNew<vtkUnsignedCharArray> marked;
  visibility->SetName("Visibility");
  classes->SetName("ShadowClass");
  marked->SetName("Marked");
  const vtkIdType count = output->GetNumberOfPoints();
  visibility->SetNumberOfComponents(static_cast<int>(grids.size()));
  classes->SetNumberOfComponents(static_cast<int>(grids.size()));
  visibility->SetNumberOfTuples(count);
  classes->SetNumberOfTuples(count);
  marked->SetNumberOfTuples(count);
  vtkIdType to = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++to)
      {
        const std::size_t from = first.VertexIndex(i, j, k);
        unsigned char mark = 0;
        for (std::size_t light = 0; light < grids.size(); ++light)
        {
          const vtkIdType place = to * static_cast<vtkIdType>(grids.size()) + static_cast<vtkIdType>(light);
          visibility->SetValue(place, grids[light].Visibility[from]);
          classes->SetValue(place, grids[light].ShadowClasses[from]);
          mark |= grids[light].Marked[from];
        }
        marked->SetValue(to, mark);
      }
    }
  }
  output->GetPointData()->SetScalars(visibility);
  output->GetPointData()->AddArray(classes);
  output->GetPointData()->AddArray(marked);
  WriteBricks(grids, output->GetFieldData());
}

bool ReadVisibilityGrid(vtkImageData* input, VisibilityGrid& grid, std::string& error, std::string& warning)
{
  std::vector<VisibilityGrid> grids;
  const bool read = ReadVisibilityGrids(input, grids, error, warning);
  grid = std::move(grids.front());
  return read;
}

void WriteVisibilityGrid(const VisibilityGrid& grid, const int extent[6], vtkImageData* output)
{
  WriteVisibilityGrids({ grid }, extent, output);
}

void WriteVisibility(const VisibilityResult& result, int lights, const std::vector<vtkIdType>& items, vtkIdType count,
  vtkDataSetAttributes* data)
{
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  AddFloatArray(data, "Visibility", lights, Spread(result.Visibility, lights, items, count, unknown));
  AddByteArray(data, "ShadowClass", Spread(result.ShadowClasses, lights, items, count, HiddenShadowClass), lights);
  AddIntArray(data, "OccluderId", lights, Spread(result.OccluderIds, lights, items, count, -1));
  AddFloatArray(data, "VisibilityError", lights, Spread(result.Errors, lights, items, count, unknown));
}

} // namespace shadowcones
