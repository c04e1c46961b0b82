// SPDX-License-Identifier: BSD-3-Clause
#include "scLitPixel.h"

#include "scWideLoops.h"

namespace shadowcones
{
namespace
{
SHADOWCONES_WIDE void Multiply(float* values, float factor, std::size_t count)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    values[k] *= factor;
  }
}
} // anonymous namespace

void FinishPixel(const LitQuadrature& quadrature, LitPixel& pixel)
{
  pixel.Variable = LitVariable(quadrature, pixel.Line, pixel.Interval, nullptr);
  if (pixel.Variable.NeedsDouble())
  {
    pixel.Variable.FillEdges(pixel.Edges.data());
  }
  else
  {
    for (std::size_t k = 0; k < pixel.Edges.size(); ++k)
    {
      pixel.Edges[k] = pixel.Interval.Begin + static_cast<double>(pixel.Values[k]);
    }
  }
  Multiply(pixel.Values.data() + LitProfileLayout::Edges, static_cast<float>(pixel.Variable.CellFactor()),
    pixel.Values.size() - LitProfileLayout::Edges);
}

} // namespace shadowcones
