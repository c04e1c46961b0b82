// SPDX-License-Identifier: BSD-3-Clause
#include "scLitTile.h"

#include "scCellIndex.h"
#include "scWideLoops.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowcones
{
namespace
{
/// No ray takes more evaluations of the light than this where a tolerance of 1e-3 is asked for, and at most eight times
/// as many where it is smaller. Discs and rectangles have sharp edges for rays that pass near them; meshes have many
/// points, which are cheap.
constexpr int mostEvaluations = 1 << 12;
constexpr int mostFlatEvaluations = 1 << 13;
constexpr int mostMeshEvaluations = 1 << 15;

int MostEvaluations(LightShape shape)
{
  const bool flat = shape == LightShape::Disc || shape == LightShape::Rectangle;
  return shape == LightShape::Mesh ? mostMeshEvaluations : flat ? mostFlatEvaluations : mostEvaluations;
}

/// Rules are checked at one ray of a square: to be trusted at the others they must agree by this fraction of the
/// tolerance.
constexpr double quadratureFraction = 0.3;

/// A sum of three rows: the innermost loop of interpolation.
SHADOWCONES_WIDE void AddThree(
  float* sum, const float* a, const float* b, const float* c, const double weights[3], std::size_t count)
{
  const auto wa = static_cast<float>(weights[0]);
  const auto wb = static_cast<float>(weights[1]);
  const auto wc = static_cast<float>(weights[2]);
  for (std::size_t k = 0; k < count; ++k)
  {
    sum[k] = wa * a[k] + wb * b[k] + wc * c[k];
  }
}

/// Quadratic weights of nodes at 0, 1/2 and 1.
void QuadraticWeights(double x, double weights[3])
{
  weights[0] = (1.0 - x) * (1.0 - 2.0 * x);
  weights[1] = 4.0 * x * (1.0 - x);
  weights[2] = x * (2.0 * x - 1.0);
}
} // anonymous namespace

LitTile::LitTile(const LitQuadrature& quadrature, const Camera& camera, int width, int height, double tolerance,
  const std::vector<double>& typical)
  : Quadrature(quadrature)
  , View(camera)
  , Width(width)
  , Height(height)
  , Tolerance(tolerance)
  , Smallest(typical)
  , Profiler(quadrature)
  , LeafOf(static_cast<std::size_t>(Side * Side))
{
  for (double& smallest : this->Smallest)
  {
    smallest *= 0.1;
  }
  this->Columns.resize(3 * quadrature.Layout.Size());
  this->ComputedValues.reset(new float[(Side + 1) * (Side + 1) * quadrature.Layout.Size()]);
  for (std::vector<float>& values : this->Scratch)
  {
    values.resize(quadrature.Layout.Size());
  }
}

void LitTile::MoveTo(int i0, int j0)
{
  if (!this->Leaves.empty() && i0 == this->I0 && j0 == this->J0)
  {
    return;
  }
  this->I0 = i0;
  this->J0 = j0;
  this->Leaves.clear();
  this->Sheets.clear();
  this->Values.clear();
  this->ComputedPixels.assign((Side + 1) * (Side + 1), Computed());
  this->BlendedRow = -1;
  this->Cut(i0, j0, Side, this->Quadrature.FirstLevel(), this->Tolerance);
}

const LitTile::Leaf& LitTile::LeafAt(double i, double j) const
{
  const int column = CellIndex(std::floor(i + 0.5) - this->I0, Side - 1);
  const int row = CellIndex(std::floor(j + 0.5) - this->J0, Side - 1);
  return this->Leaves[static_cast<std::size_t>(this->LeafOf[static_cast<std::size_t>(row * Side + column)])];
}

void LitTile::Interpolate(double i, double j, LitPixel& pixel)
{
  const Leaf& leaf = this->LeafAt(i, j);
  pixel.Line = this->RayOf(i, j);
  pixel.Interval = this->Quadrature.Intervals.Find(pixel.Line);
  pixel.Tolerance = leaf.Tolerance;
  pixel.Values.resize(this->Quadrature.Layout.Size());
  if (pixel.Interval.Empty())
  {
    std::fill(pixel.Values.begin(), pixel.Values.end(), 0.0f);
    pixel.Edges.fill(0.0);
    return;
  }
  std::size_t sheet = leaf.FirstSheet;
  while (sheet < leaf.EndOfSheets && this->Sheets[sheet].Faces != pixel.Interval.Faces)
  {
    ++sheet;
  }
  const bool computed = leaf.Size > 1 || (i == leaf.I && j == leaf.J);
  if (sheet < leaf.EndOfSheets && computed)
  {
    this->Blend(leaf, this->Sheets[sheet], i, j, pixel.Values.data());
  }
  else
  {
    // It passes a face of the medium that none of the computed rays passes, or beside the one that is computed.
    this->Evaluate(pixel.Line, pixel.Interval, leaf.Level, pixel.Values.data());
  }
  FinishPixel(this->Quadrature, pixel);
}

void LitTile::Cut(int i, int j, int size, LitLevel level, double tolerance)
{
  if (size == 2)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->AddPixel(i + k % 2, j + k / 2, level, tolerance);
    }
    return;
  }
  this->RaiseLevel(i, j, size, level, tolerance);
  if (this->AddLeaf(i, j, size, level, tolerance))
  {
    return;
  }
  const int half = size / 2;
  for (int k = 0; k < 4; ++k)
  {
    this->Cut(i + half * (k % 2), j + half * (k / 2), half, level, tolerance);
  }
}

bool LitTile::Affords(const LitLevel& level) const
{
  const int most = MostEvaluations(this->Quadrature.Lamp.Shape);
  return level.Panels < LitQuadrature::NumberOfPanelLevels && level.Rule < LightRule::NumberOfLevels &&
    LitProfiler::NumberOfEvaluations(this->Quadrature, level) <=
    most * std::clamp(1e-3 / std::max(this->Tolerance, 1e-9), 1.0, 8.0);
}

void LitTile::RaiseLevel(int i0, int j0, int size, LitLevel& level, double& tolerance)
{
  // Where rules do for the ray that passes nearest to the light they do for the others.
  int nearestI = i0;
  int nearestJ = j0;
  double nearest = HUGE_VAL;
  for (int k = 0; k < 10; ++k)
  {
    const int i = k < 9 ? i0 + size / 2 * (k % 3) : i0 + size / 4;
    const int j = k < 9 ? j0 + size / 2 * (k / 3) : j0 + size - size / 4;
    const Ray other = this->RayOf(i, j);
    const LitInterval part = this->Quadrature.Intervals.Find(other);
    const double t = std::clamp(Dot(this->Quadrature.Center - other.Origin, other.Direction), part.Begin, part.End);
    const double distance = Length(other.Origin + t * other.Direction - this->Quadrature.Center);
    if (!part.Empty() && distance < nearest)
    {
      nearestI = i;
      nearestJ = j;
      nearest = distance;
    }
  }
  this->RaiseLevelFor(nearestI, nearestJ, level, tolerance);
  if (this->Quadrature.Air.Density)
  {
    // Nor is a density alike everywhere.
    for (const int corner : { 0, size })
    {
      this->RaiseLevelFor(i0 + corner, j0 + corner, level, tolerance);
    }
  }
}

void LitTile::RaiseLevelFor(int i, int j, LitLevel& level, double& tolerance)
{
  const Ray ray = this->RayOf(i, j);
  const LitInterval interval = this->Quadrature.Intervals.Find(ray);
  if (interval.Empty())
  {
    return;
  }
  const double factor = this->CellFactor(ray, interval);
  float* values = this->Scratch[0].data();
  float* finer = this->Scratch[1].data();
  this->EvaluatePixel(i, j, interval, level, values);
  double differences[2] = { 0.0, 0.0 }; // when panels and rule were last made finer
  bool raised = true;
  while (raised)
  {
    raised = false;
    for (int LitLevel::*part : { &LitLevel::Panels, &LitLevel::Rule })
    {
      LitLevel next = level;
      next.*part += 1;
      if (!this->Affords(next))
      {
        continue;
      }
      this->Evaluate(ray, interval, next, finer);
      const double difference = this->Difference(values, finer, factor);
      differences[part == &LitLevel::Panels ? 0 : 1] = difference;
      if (difference > quadratureFraction * this->Tolerance)
      {
        level = next;
        std::swap(values, finer);
        raised = true;
      }
    }
  }
  // Where finer rules cost too much the ray stays as wrong as it is: rays in between need not be better.
  tolerance = std::max({ tolerance, differences[0], differences[1] });
}

bool LitTile::AddLeaf(int i, int j, int size, const LitLevel& level, double tolerance)
{
  const int half = size / 2;
  Leaf leaf;
  leaf.I = i;
  leaf.J = j;
  leaf.Size = size;
  leaf.Level = level;
  leaf.Tolerance = tolerance;
  leaf.FirstSheet = this->Sheets.size();
  leaf.EndOfSheets = leaf.FirstSheet;
  const std::size_t firstValue = this->Values.size();
  for (int k = 0; k < 9; ++k)
  {
    const LitInterval interval = this->IntervalOf(i + half * (k % 3), j + half * (k / 3));
    bool known = interval.Empty();
    for (std::size_t sheet = leaf.FirstSheet; sheet < leaf.EndOfSheets; ++sheet)
    {
      known = known || this->Sheets[sheet].Faces == interval.Faces;
    }
    if (known)
    {
      continue;
    }
    if (leaf.FirstSheet == leaf.EndOfSheets)
    {
      leaf.Reference = interval.Begin;
    }
    if (!this->AddSheet(leaf, interval.Faces))
    {
      this->Sheets.resize(leaf.FirstSheet);
      this->Values.resize(firstValue);
      return false;
    }
  }
  this->Register(leaf);
  return true;
}

bool LitTile::AddSheet(Leaf& leaf, int faces)
{
  const std::size_t stride = this->Quadrature.Layout.Size();
  const double far = 4.0 * this->Quadrature.Extent;
  const int half = leaf.Size / 2;
  const int quarter = leaf.Size / 4;
  // Nine nodes, then rays to check: quadratics are worst halfway between their nodes, on any side of what is not
  // smooth.
  constexpr int count = 13;
  const int places[count][2] = { { 0, 0 }, { half, 0 }, { 2 * half, 0 }, { 0, half }, { half, half },
    { 2 * half, half }, { 0, 2 * half }, { half, 2 * half }, { 2 * half, 2 * half }, { quarter, quarter },
    { 3 * quarter, quarter }, { 3 * quarter, 3 * quarter }, { quarter, 3 * quarter } };
  LitInterval intervals[count];
  for (int k = 0; k < count; ++k)
  {
    intervals[k] = this->Quadrature.Intervals.Between(this->RayOf(leaf.I + places[k][0], leaf.J + places[k][1]), faces);
    // Rays that run along a face meet its plane far away, or nowhere.
    if (!(std::fabs(intervals[k].Begin - leaf.Reference) < far && std::fabs(intervals[k].End - leaf.Reference) < far))
    {
      return false;
    }
  }
  Sheet sheet;
  sheet.Faces = faces;
  sheet.Nodes = this->Values.size();
  this->BlendedRow = -1; // a discarded sheet may have had the same place
  this->Values.resize(sheet.Nodes + 9 * stride);
  for (int k = 0; k < 9; ++k)
  {
    this->EvaluatePixel(leaf.I + places[k][0], leaf.J + places[k][1], intervals[k], leaf.Level,
      this->Values.data() + sheet.Nodes + static_cast<std::size_t>(k) * stride);
  }
  for (int k = 9; k < count; ++k)
  {
    const int i = leaf.I + places[k][0];
    const int j = leaf.J + places[k][1];
    this->EvaluatePixel(i, j, intervals[k], leaf.Level, this->Scratch[0].data());
    this->Blend(leaf, sheet, i, j, this->Scratch[1].data());
    const double factor = this->CellFactor(this->RayOf(i, j), intervals[k]);
    if (this->Difference(this->Scratch[1].data(), this->Scratch[0].data(), factor) > leaf.Tolerance)
    {
      return false;
    }
  }
  this->Sheets.push_back(sheet);
  leaf.EndOfSheets = this->Sheets.size();
  return true;
}

void LitTile::AddPixel(int i, int j, const LitLevel& level, double tolerance)
{
  const LitInterval interval = this->IntervalOf(i, j);
  Leaf leaf;
  leaf.I = i;
  leaf.J = j;
  leaf.Size = 1;
  leaf.Level = level;
  leaf.Tolerance = tolerance;
  leaf.FirstSheet = this->Sheets.size();
  leaf.EndOfSheets = leaf.FirstSheet;
  if (!interval.Empty())
  {
    const std::size_t first = this->Values.size();
    this->Values.resize(first + this->Quadrature.Layout.Size());
    this->EvaluatePixel(i, j, interval, level, this->Values.data() + first);
    this->Sheets.push_back({ interval.Faces, first });
    leaf.EndOfSheets = this->Sheets.size();
  }
  this->Register(leaf);
}

void LitTile::Register(const Leaf& leaf)
{
  for (int j = leaf.J; j < leaf.J + leaf.Size; ++j)
  {
    int* row = this->LeafOf.data() + (j - this->J0) * Side + leaf.I - this->I0;
    std::fill(row, row + leaf.Size, static_cast<int>(this->Leaves.size()));
  }
  this->Leaves.push_back(leaf);
}

void LitTile::Blend(const Leaf& leaf, const Sheet& sheet, double i, double j, float* values)
{
  const std::size_t count = this->Quadrature.Layout.Size();
  const float* first = this->Values.data() + sheet.Nodes;
  if (leaf.Size == 1)
  {
    std::copy_n(first, count, values);
    return;
  }
  double weights[3];
  if (this->BlendedNodes != sheet.Nodes || this->BlendedRow != j)
  {
    // Pixels of one row share the three columns' values in it.
    this->BlendedNodes = sheet.Nodes;
    this->BlendedRow = j;
    QuadraticWeights((j - leaf.J) / leaf.Size, weights);
    for (std::size_t column = 0; column < 3; ++column)
    {
      const float* node = first + column * count;
      AddThree(this->Columns.data() + column * count, node, node + 3 * count, node + 6 * count, weights, count);
    }
  }
  QuadraticWeights((i - leaf.I) / leaf.Size, weights);
  const float* column = this->Columns.data();
  AddThree(values, column, column + count, column + 2 * count, weights, count);
}

void LitTile::Evaluate(const Ray& ray, const LitInterval& interval, const LitLevel& level, float* values)
{
  this->Profiler.Evaluate(ray, interval, level, values);
  this->Rays += 1;
}

void LitTile::EvaluatePixel(int i, int j, const LitInterval& interval, const LitLevel& level, float* values)
{
  const auto at = static_cast<std::size_t>((j - this->J0) * (Side + 1) + i - this->I0);
  const std::size_t count = this->Quadrature.Layout.Size();
  Computed& computed = this->ComputedPixels[at];
  float* known = this->ComputedValues.get() + at * count;
  if (computed.Faces != interval.Faces || computed.Level.Panels != level.Panels || computed.Level.Rule != level.Rule)
  {
    this->Evaluate(this->RayOf(i, j), interval, level, known);
    computed = { interval.Faces, level };
  }
  std::copy_n(known, count, values);
}

double LitTile::CellFactor(const Ray& ray, const LitInterval& interval) const
{
  return LitVariable(this->Quadrature, ray, interval, nullptr).CellFactor();
}

double LitTile::Difference(const float* a, const float* b, double factor) const
{
  // Rays end at surfaces and shadows take parts of them: what counts is the error of sums up to any cell, and that of
  // the worst wavelength.
  double worst = 0.0;
  for (int g = 0; g < this->Quadrature.Layout.NumberOfGroups; ++g)
  {
    double largest = 0.0;
    double difference = 0.0;
    double sum = 0.0;
    for (int k = 0; k < LitProfileLayout::Cells; ++k)
    {
      const int at = LitProfileLayout::Edges + g * LitProfileLayout::Cells + k;
      difference += static_cast<double>(a[at]) - b[at];
      sum += b[at];
      largest = std::max(largest, std::fabs(difference));
    }
    const double smallest = this->Smallest[static_cast<std::size_t>(g)];
    const double total = std::max(std::fabs(sum * factor), smallest);
    worst = std::max(worst, total > 0.0 ? largest * std::fabs(factor) / total : 0.0);
  }
  return worst;
}

std::vector<double> TypicalLitSums(const LitQuadrature& quadrature, const Camera& camera, int width, int height)
{
  constexpr int side = 8;
  LitProfiler profiler(quadrature);
  std::vector<float> values(quadrature.Layout.Size());
  std::vector<double> typical(static_cast<std::size_t>(quadrature.Layout.NumberOfGroups), 0.0);
  for (int k = 0; k < side * side; ++k)
  {
    const Ray ray = camera.PixelRay((k % side + 0.5) * width / side, (k / side + 0.5) * height / side, width, height);
    const LitInterval interval = quadrature.Intervals.Find(ray);
    if (interval.Empty())
    {
      continue;
    }
    profiler.Evaluate(ray, interval, quadrature.FirstLevel(), values.data());
    const double factor = LitVariable(quadrature, ray, interval, nullptr).CellFactor() / (side * side);
    for (std::size_t g = 0; g < typical.size(); ++g)
    {
      const float* cell = values.data() + LitProfileLayout::Edges + g * LitProfileLayout::Cells;
      typical[g] += factor * std::accumulate(cell, cell + LitProfileLayout::Cells, 0.0);
    }
  }
  return typical;
}

} // namespace shadowcones
