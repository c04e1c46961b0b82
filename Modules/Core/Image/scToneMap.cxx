// SPDX-License-Identifier: BSD-3-Clause
#include "scToneMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace shadowcones
{

namespace
{

constexpr int tileSide = 32;
constexpr int mostTiles = 32; // along an axis
constexpr int enoughPixels = 4096;
constexpr double whitePercentile = 0.99;
/// Luminance of linear sRGB (IEC 61966-2-1).
constexpr double luminanceOfSrgb[3] = { 0.2126, 0.7152, 0.0722 };

struct Range
{
  int From;
  int To;
};

int TilesAlong(int pixels)
{
  return (pixels + tileSide - 1) / tileSide;
}

/// Pieces of an axis: the middle @p side pixels of every tile, or of every second, third... of many tiles.
std::vector<Range> MiddlesAlong(int pixels, int side)
{
  const int tiles = TilesAlong(pixels);
  const int step = (tiles + mostTiles - 1) / mostTiles;
  std::vector<Range> middles;
  for (int tile = step / 2; tile < tiles; tile += step)
  {
    const int length = std::min(tileSide, pixels - tile * tileSide);
    const int taken = std::min(side, length);
    const int from = tile * tileSide + (length - taken) / 2;
    middles.push_back({ from, from + taken - 1 });
  }
  return middles;
}

} // namespace

std::vector<double> LuminanceWeights(const std::vector<double>& wavelengths)
{
  const auto matrix = SpectrumToLinearSrgb(wavelengths);
  std::vector<double> weights(wavelengths.size(), 0.0);
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      weights[k] += luminanceOfSrgb[c] * matrix[c][k];
    }
  }
  return weights;
}

std::vector<std::array<int, 4>> ExposureSquares(int width, int height)
{
  std::vector<std::array<int, 4>> squares;
  if (width < 1 || height < 1)
  {
    return squares;
  }
  const int tiles = std::min(TilesAlong(width), mostTiles) * std::min(TilesAlong(height), mostTiles);
  int side = tileSide;
  while (tiles * side * side > enoughPixels)
  {
    side /= 2;
  }
  for (const Range& rows : MiddlesAlong(height, side))
  {
    for (const Range& columns : MiddlesAlong(width, side))
    {
      squares.push_back({ columns.From, columns.To, rows.From, rows.To });
    }
  }
  return squares;
}

void AppendLuminances(const std::array<int, 4>& extent, const std::array<int, 4>& square,
  const std::vector<const float*>& parts, const std::vector<double>& weights, std::vector<double>& luminances)
{
  const auto columns = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  for (int j = square[2]; j <= square[3]; ++j)
  {
    for (int i = square[0]; i <= square[1]; ++i)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(j - extent[2]) * columns + static_cast<std::size_t>(i - extent[0]);
      double luminance = 0.0;
      for (std::size_t k = 0; k < weights.size(); ++k)
      {
        const std::size_t value = pixel * weights.size() + k;
        const double sum = std::accumulate(parts.begin(), parts.end(), 0.0,
          [value](double before, const float* part) { return before + static_cast<double>(part[value]); });
        luminance += weights[k] * sum;
      }
      luminances.push_back(luminance);
    }
  }
}

double ExposureOf(std::vector<double> luminances)
{
  luminances.erase(std::remove_if(luminances.begin(), luminances.end(), [](double y) { return !std::isfinite(y); }),
    luminances.end());
  if (luminances.empty())
  {
    return 1.0;
  }
  const auto count = static_cast<double>(luminances.size());
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(whitePercentile * count)) - 1;
  std::nth_element(luminances.begin(), luminances.begin() + rank, luminances.end());
  double white = luminances[static_cast<std::size_t>(rank)];
  if (!(white > 0.0))
  {
    white = *std::max_element(luminances.begin(), luminances.end());
  }
  return white > 0.0 ? 1.0 / white : 1.0;
}

double ApplyToneCurve(ToneCurve curve, double linear)
{
  constexpr double white = 7.25; // of Filmic; it begins at 7.242
  if (!(linear > 0.0))
  {
    return 0.0;
  }
  if (curve == ToneCurve::Linear || linear > white)
  {
    return std::min(linear, 1.0);
  }
  return std::min(linear * (2.51 * linear + 0.03) / (linear * (2.43 * linear + 0.59) + 0.14), 1.0);
}

bool ToneMap(const float* radiance, vtkIdType numberOfPixels, const ToneMapping& mapping, const Monitor& monitor,
  unsigned char* rgb)
{
  const auto matrix = SpectrumToLinearSrgb(mapping.Wavelengths);
  const std::size_t count = mapping.Wavelengths.size();
  return ParallelFor(numberOfPixels, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float* spectrum = radiance + static_cast<std::size_t>(i) * count;
        for (int c = 0; c < 3; ++c)
        {
          double linear = 0.0;
          for (std::size_t k = 0; k < count; ++k)
          {
            linear += matrix[c][k] * spectrum[k];
          }
          rgb[3 * i + c] = EncodeSrgb(ApplyToneCurve(mapping.Curve, mapping.Exposure * linear));
        }
      }
    });
}

} // namespace shadowcones
