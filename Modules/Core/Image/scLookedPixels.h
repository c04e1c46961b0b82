// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLookedPixels.h
 * @brief What a few samples of every pixel say of its shadow, for its neighbours. Internal to Core.
 */
#ifndef scLookedPixels_h
#define scLookedPixels_h

#include "scPixelArray.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace shadowcones
{

/// One pixel that was looked at.
struct LookedPixel
{
  /// Which pixels change smoothly from one to the next: those that pass the same faces of the medium, and end at a
  /// surface or not. Below 0: this one is nobody's neighbour.
  int Kind = -1;
  int Samples = 0;
  int Visible = 0;       ///< of the samples; -1: some
  float Shown = 0.0f;    ///< share of the light that is left, mean over wavelengths
  float Inside = 0.0f;   ///< unshadowed light where cones allow for shadow, mean over wavelengths
  float Whole = 0.0f;    ///< all of it
  float LitError = 0.0f; ///< its standard error
};

/// Those of an image's part, and around it as far as its pixels ask for neighbours.
class LookedPixels
{
public:
  /// Blocks of so many pixels by so many, aligned to pixel (0, 0), are judged at once.
  static constexpr int BlockSide = 8;
  /// By so many pixels more on each side: whole blocks.
  static constexpr int Margin = 16;

  /// The pixels that those of an extent ask for.
  static std::array<int, 4> ExtentFor(const std::array<int, 4>& extent, int width, int height)
  {
    const auto low = [](int at) { return std::max(at / BlockSide * BlockSide - Margin, 0); };
    const auto high = [](int at, int size)
    {
      const int rest = size - 1 - at / BlockSide * BlockSide; // nothing passes the largest integer
      return rest < BlockSide + Margin ? size - 1 : size - 1 - rest + BlockSide - 1 + Margin;
    };
    return { low(extent[0]), high(extent[1], width), low(extent[2]), high(extent[3], height) };
  }

  LookedPixels(const std::array<int, 4>& extent, int groups)
    : Extent(extent)
    , Groups(static_cast<std::size_t>(groups))
  {
    const auto columns = static_cast<std::size_t>(extent[1] - extent[0] + 1);
    const auto rows = static_cast<std::size_t>(extent[3] - extent[2] + 1);
    this->Pixels.Resize(columns * rows);
    this->Hidden.Resize(columns * rows * this->Groups);
    this->Light.Resize(columns * rows * this->Groups);
  }

  const std::array<int, 4>& GetExtent() const { return this->Extent; }
  bool Holds(int i, int j) const
  {
    return i >= this->Extent[0] && i <= this->Extent[1] && j >= this->Extent[2] && j <= this->Extent[3];
  }
  LookedPixel& At(int i, int j) { return this->Pixels[this->IndexOf(i, j)]; }
  const LookedPixel& At(int i, int j) const { return this->Pixels[this->IndexOf(i, j)]; }
  /// The share of the unshadowed light that is hidden, of every group.
  float* HiddenOf(int i, int j) { return this->Hidden.data() + this->IndexOf(i, j) * this->Groups; }
  const float* HiddenOf(int i, int j) const { return this->Hidden.data() + this->IndexOf(i, j) * this->Groups; }
  /// The unshadowed light of every group.
  float* LightOf(int i, int j) { return this->Light.data() + this->IndexOf(i, j) * this->Groups; }
  const float* LightOf(int i, int j) const { return this->Light.data() + this->IndexOf(i, j) * this->Groups; }

private:
  std::size_t IndexOf(int i, int j) const
  {
    const auto columns = static_cast<std::size_t>(this->Extent[1] - this->Extent[0] + 1);
    return static_cast<std::size_t>(j - this->Extent[2]) * columns + static_cast<std::size_t>(i - this->Extent[0]);
  }

  std::array<int, 4> Extent;
  std::size_t Groups;
  PixelArray<LookedPixel> Pixels;
  PixelArray<float> Hidden;
  PixelArray<float> Light;
};

} // namespace shadowcones

#endif
