// SPDX-License-Identifier: BSD-3-Clause
#include "scLitTile.h"

#include "scWideLoops.h"

#include <algorithm>
#include <numeric>

namespace shadowcones
{
namespace
{
/// No ray takes more evaluations of the light than this; meshes have many points, which are cheap.
constexpr int mostEvaluations = 1 << 12;
constexpr int mostMeshEvaluations = 1 << 15;

/// Rules are checked at one ray of a square: to be trusted at the others they must agree by this share of the tolerance.
constexpr double quadratureShare = 0.3;

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

SHADOWCONES_WIDE void Multiply(float* values, float factor, std::size_t count)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    values[k] *= factor;
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

LitTile::LitTile(
  const LitQuadrature& quadrature, const Camera& camera, int width, int height, double tolerance,
  const std::vector<double>& typical)
  : Quadrature(quadrature)
  , Eye(camera)
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
  for (std::vector<float>& values : this->Scratch)
  {
    values.resize(quadrature.Layout.Size());
  }
}

void LitTile::MoveTo(int i0, int j0)
{
  this->I0 = i0;
  this->J0 = j0;
  this->Leaves.clear();
  this->Sheets.clear();
  this->Values.clear();
  this->BlendedRow = -1;
  this->Cut(i0, j0, Side, LitLevel(), this->Tolerance);
}

void LitTile::Interpolate(int i, int j, LitPixel& pixel)
{
  const auto index = static_cast<std::size_t>((j - this->J0) * Side + i - this->I0);
  const Leaf& leaf = this->Leaves[static_cast<std::size_t>(this->LeafOf[index])];
  pixel.Line = this->RayOf(i, j);
  pixel.Span = this->Quadrature.Spans.Find(pixel.Line);
  pixel.Reference = leaf.Reference;
  pixel.Tolerance = leaf.Tolerance;
  pixel.Values.resize(this->Quadrature.Layout.Size());
  if (pixel.Span.Empty())
  {
    std::fill(pixel.Values.begin(), pixel.Values.end(), 0.0f);
    return;
  }
  std::size_t sheet = leaf.FirstSheet;
  while (sheet < leaf.EndOfSheets && this->Sheets[sheet].Faces != pixel.Span.Faces)
  {
    ++sheet;
  }
  if (sheet < leaf.EndOfSheets)
  {
    this->Blend(leaf, this->Sheets[sheet], i, j, pixel.Values.data());
  }
  else
  {
    // It passes a face of the medium that none of the computed rays passes.
    this->Evaluate(i, j, pixel.Span, pixel.Reference, leaf.Level, pixel.Values.data());
  }
  const LitAngle angle(this->Quadrature, pixel.Line, pixel.Span);
  Multiply(pixel.Values.data() + LitProfileLayout::Edges, static_cast<float>(angle.CellFactor()),
    pixel.Values.size() - LitProfileLayout::Edges);
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
  return level.Panels < LitQuadrature::NumberOfPanelLevels && level.Rule < LightRule::NumberOfLevels &&
    LitProfiler::NumberOfEvaluations(this->Quadrature, level) <=
    (this->Quadrature.Source.Shape == LightShape::Mesh ? mostMeshEvaluations : mostEvaluations);
}

void LitTile::RaiseLevel(int i0, int j0, int size, LitLevel& level, double& tolerance)
{
  int i = i0 + size / 4;
  int j = j0 + size - size / 4;
  MediumSpan span = this->SpanOf(i, j);
  for (int k = 0; k < 9 && span.Empty(); ++k)
  {
    // Any ray of the square will do that meets the medium.
    i = i0 + size / 2 * (k % 3);
    j = j0 + size / 2 * (k / 3);
    span = this->SpanOf(i, j);
  }
  if (span.Empty())
  {
    return;
  }
  const double factor = LitAngle(this->Quadrature, this->RayOf(i, j), span).CellFactor();
  float* values = this->Scratch[0].data();
  float* finer = this->Scratch[1].data();
  this->Evaluate(i, j, span, span.Begin, level, values);
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
      this->Evaluate(i, j, span, span.Begin, next, finer);
      const double difference = this->Difference(values, finer, factor);
      differences[part == &LitLevel::Panels ? 0 : 1] = difference;
      if (difference > quadratureShare * this->Tolerance)
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
    const MediumSpan span = this->SpanOf(i + half * (k % 3), j + half * (k / 3));
    bool known = span.Empty();
    for (std::size_t sheet = leaf.FirstSheet; sheet < leaf.EndOfSheets; ++sheet)
    {
      known = known || this->Sheets[sheet].Faces == span.Faces;
    }
    if (known)
    {
      continue;
    }
    if (leaf.FirstSheet == leaf.EndOfSheets)
    {
      leaf.Reference = span.Begin;
    }
    if (!this->AddSheet(leaf, span.Faces))
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
  // Nine nodes, then rays to check: quadratics are worst halfway between their nodes, where the errors along the two
  // axes add in one of these and take from each other in the other.
  const int places[11][2] = { { 0, 0 }, { half, 0 }, { 2 * half, 0 }, { 0, half }, { half, half }, { 2 * half, half },
    { 0, 2 * half }, { half, 2 * half }, { 2 * half, 2 * half }, { quarter, quarter }, { 3 * quarter, quarter } };
  MediumSpan spans[11];
  for (int k = 0; k < 11; ++k)
  {
    spans[k] = this->Quadrature.Spans.Between(this->RayOf(leaf.I + places[k][0], leaf.J + places[k][1]), faces);
    // Rays that run along a face meet its plane far away, or nowhere.
    if (!(std::fabs(spans[k].Begin - leaf.Reference) < far && std::fabs(spans[k].End - leaf.Reference) < far))
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
    this->Evaluate(leaf.I + places[k][0], leaf.J + places[k][1], spans[k], leaf.Reference, leaf.Level,
      this->Values.data() + sheet.Nodes + static_cast<std::size_t>(k) * stride);
  }
  for (int k = 9; k < 11; ++k)
  {
    const int i = leaf.I + places[k][0];
    const int j = leaf.J + places[k][1];
    this->Evaluate(i, j, spans[k], leaf.Reference, leaf.Level, this->Scratch[0].data());
    this->Blend(leaf, sheet, i, j, this->Scratch[1].data());
    const double factor = LitAngle(this->Quadrature, this->RayOf(i, j), spans[k]).CellFactor();
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
  const MediumSpan span = this->SpanOf(i, j);
  Leaf leaf;
  leaf.I = i;
  leaf.J = j;
  leaf.Size = 1;
  leaf.Level = level;
  leaf.Tolerance = tolerance;
  leaf.Reference = span.Begin;
  leaf.FirstSheet = this->Sheets.size();
  leaf.EndOfSheets = leaf.FirstSheet;
  if (!span.Empty())
  {
    const std::size_t first = this->Values.size();
    this->Values.resize(first + this->Quadrature.Layout.Size());
    this->Evaluate(i, j, span, leaf.Reference, level, this->Values.data() + first);
    this->Sheets.push_back({ span.Faces, first });
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

void LitTile::Blend(const Leaf& leaf, const Sheet& sheet, int i, int j, float* values)
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
    QuadraticWeights(static_cast<double>(j - leaf.J) / leaf.Size, weights);
    for (std::size_t column = 0; column < 3; ++column)
    {
      const float* node = first + column * count;
      AddThree(this->Columns.data() + column * count, node, node + 3 * count, node + 6 * count, weights, count);
    }
  }
  QuadraticWeights(static_cast<double>(i - leaf.I) / leaf.Size, weights);
  const float* column = this->Columns.data();
  AddThree(values, column, column + count, column + 2 * count, weights, count);
}

void LitTile::Evaluate(
  int i, int j, const MediumSpan& span, double reference, const LitLevel& level, float* values)
{
  this->Profiler.Evaluate(this->RayOf(i, j), span, reference, level, values);
  this->Rays += 1;
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
    const Ray ray =
      camera.PixelRay((k % side + 0.5) * width / side, (k / side + 0.5) * height / side, width, height);
    const MediumSpan span = quadrature.Spans.Find(ray);
    if (span.Empty())
    {
      continue;
    }
    profiler.Evaluate(ray, span, span.Begin, LitLevel(), values.data());
    const double factor = LitAngle(quadrature, ray, span).CellFactor() / (side * side);
    for (std::size_t g = 0; g < typical.size(); ++g)
    {
      const float* cell = values.data() + LitProfileLayout::Edges + g * LitProfileLayout::Cells;
      typical[g] += factor * std::accumulate(cell, cell + LitProfileLayout::Cells, 0.0);
    }
  }
  return typical;
}

} // namespace shadowcones
