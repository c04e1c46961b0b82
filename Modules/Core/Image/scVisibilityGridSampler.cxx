// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityGridSampler.h"

#include "scParallel.h"
#include "scScatteringScene.h"
#include "scTrilinear.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shadowcones
{
namespace
{
/// Most places looked at in one cell of a ray.
constexpr float mostPlaces = 64.0f;

std::vector<float> OneMinus(const std::vector<float>& values)
{
  std::vector<float> result(values.size());
  ParallelFor(static_cast<vtkIdType>(values.size()), {},
    [&](vtkIdType begin, vtkIdType end)
    {
      std::transform(values.begin() + begin, values.begin() + end, result.begin() + begin,
        [](float value) { return 1.0f - value; });
    });
  return result;
}
} // anonymous namespace

VisibilityGridSampler::VisibilityGridSampler(const VisibilityGrid& grid)
  : Grid(grid)
  , PerLength{ 1.0 / grid.Spacing.X, 1.0 / grid.Spacing.Y, 1.0 / grid.Spacing.Z }
  , Hidden(OneMinus(grid.Visibility))
  , BrickHidden(OneMinus(grid.BrickVisibility))
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Cells[axis] = grid.Dimensions[axis] - 1;
    this->Macros[axis] = (this->Cells[axis] + MacroSide - 1) / MacroSide;
  }
  const vtkIdType rows = static_cast<vtkIdType>(this->Macros[1]) * this->Macros[2];
  this->Occupied.assign(static_cast<std::size_t>(rows) * this->Macros[0], 0);
  ParallelFor(rows, {},
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        this->FindOccupied(static_cast<int>(row % this->Macros[1]), static_cast<int>(row / this->Macros[1]));
      }
    });
  if (grid.BrickCells.empty())
  {
    return;
  }
  this->BrickOf.assign(static_cast<std::size_t>(this->Cells[0]) * this->Cells[1] * this->Cells[2], -1);
  for (std::size_t brick = 0; brick < grid.BrickCells.size(); ++brick)
  {
    const auto cell = static_cast<std::size_t>(grid.BrickCells[brick]);
    this->BrickOf[cell] = static_cast<int>(brick);
    const auto columns = static_cast<std::size_t>(this->Cells[0]);
    const auto lines = static_cast<std::size_t>(this->Cells[1]);
    const std::size_t macro[3] = { cell % columns / MacroSide, cell / columns % lines / MacroSide,
      cell / columns / lines / MacroSide };
    this->Occupied[(macro[2] * this->Macros[1] + macro[1]) * this->Macros[0] + macro[0]] = 1;
  }
}

/// Look at the vertices of a row of macro cells: one on a border belongs to the cells on all its sides.
void VisibilityGridSampler::FindOccupied(int macroJ, int macroK)
{
  const auto last = [this](int macro, int axis) { return std::min((macro + 1) * MacroSide, this->Cells[axis]); };
  const auto vertices = static_cast<std::size_t>(this->Grid.Dimensions[0]);
  unsigned char* occupied =
    this->Occupied.data() + (static_cast<std::size_t>(macroK) * this->Macros[1] + macroJ) * this->Macros[0];
  for (int k = macroK * MacroSide; k <= last(macroK, 2); ++k)
  {
    for (int j = macroJ * MacroSide; j <= last(macroJ, 1); ++j)
    {
      const float* row = this->Hidden.data() + this->Grid.VertexIndex(0, j, k);
      for (int macro = 0; macro < this->Macros[0]; ++macro)
      {
        const float* first = row + static_cast<std::ptrdiff_t>(macro) * MacroSide;
        const float* end = std::min(first + MacroSide + 1, row + vertices);
        occupied[macro] |= std::any_of(first, end, [](float hidden) { return hidden != 0.0f; }) ? 1 : 0;
      }
    }
  }
}

std::int64_t VisibilityGridSampler::Memory() const
{
  return static_cast<std::int64_t>((this->Hidden.capacity() + this->BrickHidden.capacity()) * sizeof(float) +
    this->BrickOf.capacity() * sizeof(int) + this->Occupied.capacity());
}

std::shared_ptr<const VisibilityGridSampler> LayOutGrid(const VisibilityGrid& grid)
{
  return std::make_shared<const VisibilityGridSampler>(grid);
}

std::int64_t MemoryOf(const VisibilityGridSampler& layout)
{
  return layout.Memory();
}

Vector3 VisibilityGridSampler::ToGrid(const Vector3& point) const
{
  const Vector3 offset = point - this->Grid.Origin;
  return { offset.X * this->PerLength.X, offset.Y * this->PerLength.Y, offset.Z * this->PerLength.Z };
}

bool VisibilityGridSampler::AnyHidden(const int first[3], const int last[3]) const
{
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        if (this->Occupied[(static_cast<std::size_t>(k) * this->Macros[1] + j) * this->Macros[0] + i])
        {
          return true;
        }
      }
    }
  }
  return false;
}

std::uint64_t VisibilityGridSampler::CellsInShadow(const std::array<LitPixel, 4>& pixels) const
{
  std::uint64_t bits = 0;
  Box before;
  for (int edge = 0; edge <= LitProfileLayout::Cells; ++edge)
  {
    Box box;
    for (const LitPixel& pixel : pixels)
    {
      box.Add(this->ToGrid(pixel.Line.Origin + pixel.EdgeAt(edge) * pixel.Line.Direction));
    }
    Box cell = box;
    cell.Add(before);
    before = box;
    if (edge == 0)
    {
      continue;
    }
    // One grid cell more on all sides: cells of rays in between are interpolated.
    int first[3];
    int last[3];
    bool outside = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = cell.Min[axis] - 1.0;
      const double high = cell.Max[axis] + 1.0;
      outside = outside || high < 0.0 || low > this->Cells[axis];
      first[axis] = static_cast<int>(std::clamp(low, 0.0, this->Cells[axis] - 1.0)) / MacroSide;
      last[axis] = static_cast<int>(std::clamp(high, 0.0, this->Cells[axis] - 1.0)) / MacroSide;
    }
    if (!outside && this->AnyHidden(first, last))
    {
      bits |= std::uint64_t(1) << (edge - 1);
    }
  }
  return bits;
}

float VisibilityGridSampler::HiddenAt(float x, float y, float z, bool& inBrick) const
{
  inBrick = false;
  // Vertices on the last faces belong to the last cells; beyond the grid all is lit.
  const auto sizeX = static_cast<float>(this->Cells[0]);
  const auto sizeY = static_cast<float>(this->Cells[1]);
  const auto sizeZ = static_cast<float>(this->Cells[2]);
  if (!(x >= -1e-3f && y >= -1e-3f && z >= -1e-3f && x <= sizeX + 1e-3f && y <= sizeY + 1e-3f && z <= sizeZ + 1e-3f))
  {
    return 0.0f;
  }
  const int i = std::clamp(static_cast<int>(x), 0, this->Cells[0] - 1);
  const int j = std::clamp(static_cast<int>(y), 0, this->Cells[1] - 1);
  const int k = std::clamp(static_cast<int>(z), 0, this->Cells[2] - 1);
  const float fx = std::clamp(x - static_cast<float>(i), 0.0f, 1.0f);
  const float fy = std::clamp(y - static_cast<float>(j), 0.0f, 1.0f);
  const float fz = std::clamp(z - static_cast<float>(k), 0.0f, 1.0f);
  if (!this->BrickOf.empty())
  {
    const int brick = this->BrickOf[(static_cast<std::size_t>(k) * this->Cells[1] + j) * this->Cells[0] + i];
    if (brick >= 0)
    {
      inBrick = true;
      const int parts = this->Grid.BrickParts;
      const auto row = static_cast<std::size_t>(parts + 1);
      const float bx = fx * static_cast<float>(parts);
      const float by = fy * static_cast<float>(parts);
      const float bz = fz * static_cast<float>(parts);
      const int bi = std::min(static_cast<int>(bx), parts - 1);
      const int bj = std::min(static_cast<int>(by), parts - 1);
      const int bk = std::min(static_cast<int>(bz), parts - 1);
      const float* corner = this->BrickHidden.data() + static_cast<std::size_t>(brick) * row * row * row +
        (static_cast<std::size_t>(bk) * row + static_cast<std::size_t>(bj)) * row + static_cast<std::size_t>(bi);
      return Trilinear(corner, 1, row, row * row, bx - static_cast<float>(bi), by - static_cast<float>(bj),
        bz - static_cast<float>(bk));
    }
  }
  const auto row = static_cast<std::size_t>(this->Grid.Dimensions[0]);
  const std::size_t slice = row * static_cast<std::size_t>(this->Grid.Dimensions[1]);
  const float* corner = this->Hidden.data() + static_cast<std::size_t>(k) * slice + static_cast<std::size_t>(j) * row +
    static_cast<std::size_t>(i);
  return Trilinear(corner, 1, row, slice, fx, fy, fz);
}

float VisibilityGridSampler::HiddenBetween(const GridRay& ray, float begin, float width, int& looks) const
{
  const int parts = std::max(this->Grid.BrickParts, 1);
  // Two places a grid cell, and two for each part of a refined one: edges of shadows lie anywhere between them.
  const int places = static_cast<int>(std::min(std::max(1.0f, std::ceil(2.0f * width * ray.Speed)), mostPlaces));
  const float step = width / static_cast<float>(places);
  float sum = 0.0f;
  for (int place = 0; place < places; ++place)
  {
    const float from = begin + step * static_cast<float>(place);
    bool inBrick = false;
    const auto at = [&](float offset)
    {
      return this->HiddenAt(ray.Origin[0] + offset * ray.Direction[0], ray.Origin[1] + offset * ray.Direction[1],
        ray.Origin[2] + offset * ray.Direction[2], inBrick);
    };
    const float middle = at(from + 0.5f * step);
    looks += 1;
    if (!inBrick)
    {
      sum += middle;
      continue;
    }
    float fine = 0.0f;
    for (int part = 0; part < parts; ++part)
    {
      fine += at(from + step * ((static_cast<float>(part) + 0.5f) / static_cast<float>(parts)));
    }
    looks += parts;
    sum += fine / static_cast<float>(parts);
  }
  return sum / static_cast<float>(places);
}

int VisibilityGridSampler::Walk(const LitSums& lit, std::uint64_t wanted, std::vector<double>& hidden) const
{
  const LitPixel& pixel = lit.Profile();
  const double reference = pixel.Interval.Begin;
  const Vector3 start = this->ToGrid(pixel.Line.Origin + reference * pixel.Line.Direction);
  GridRay ray;
  ray.Speed = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    ray.Origin[axis] = static_cast<float>(start[axis]);
    ray.Direction[axis] = static_cast<float>(pixel.Line.Direction[axis] * this->PerLength[axis]);
    ray.Speed = std::max(ray.Speed, std::fabs(ray.Direction[axis]));
  }
  const int last = lit.LastCell();
  int looks = 0;
  wanted &= ~std::uint64_t(0) >> (63 - last);
  for (int cell = 0; wanted != 0; ++cell, wanted >>= 1)
  {
    if (!(wanted & 1))
    {
      continue;
    }
    const double begin = pixel.EdgeAt(cell);
    const double end = cell < last ? pixel.EdgeAt(cell + 1) : std::max(begin, lit.End());
    const auto fraction = static_cast<double>(
      this->HiddenBetween(ray, static_cast<float>(begin - reference), static_cast<float>(end - begin), looks));
    if (fraction != 0.0)
    {
      for (std::size_t g = 0; g < hidden.size(); ++g)
      {
        const auto group = static_cast<int>(g);
        hidden[g] += fraction * (cell < last ? static_cast<double>(pixel.Cells(group)[cell]) : lit.InLastCell(group));
      }
    }
  }
  return looks;
}

} // namespace shadowcones
