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

/// How closely pixels are looked at. Each level looks at every fifth pixel of the one below, in a turned square lattice: each
/// row, column and diagonal has as many of them. Blocks and windows grow so that a fit has about as many pixels at any level.
struct LookLevel
{
  int Side;       ///< blocks of so many pixels by so many, aligned to pixel (0, 0), are judged at once
  int Period;     ///< of so many pixels one is looked at
  int Turn;       ///< those for which the period divides i + Turn j
  int Along[2];   ///< from one of them to the next
  int Across[2];
  int Reach;      ///< where all samples of so many pixels around one say the same, nothing is fitted
  int Margins[2]; ///< windows of fits reach so far beyond the block
  int Fewest;     ///< samples of a first look: as many along a line through a block at any level
  int Most;       ///< samples of a second one

  bool Has(int i, int j) const { return (i + this->Turn * j) % this->Period == 0; }
};

/// The finest first.
constexpr LookLevel lookLevels[] = {
  { 8, 1, 0, { 1, 0 }, { 0, 1 }, 2, { 2, 4 }, 8, 256 },
  { 16, 5, 2, { 1, 2 }, { 2, -1 }, 5, { 4, 8 }, 20, 512 },
  { 32, 25, 7, { 4, 3 }, { 3, -4 }, 11, { 8, 16 }, 50, 512 },
};

/// One pixel that was looked at.
struct LookedPixel
{
  /// Which pixels change smoothly from one to the next: those that pass the same faces of the medium, and end at a
  /// surface or not. Below 0: this one is nobody's neighbour.
  int Kind = -1;
  int Samples = -1;      ///< -1: it was not asked, the unshadowed light is all that is known
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
  /// Of an image of this size: where pixels are many, neighbours are alike further around.
  static int NumberOfLevels(int width, int height)
  {
    const int least = std::min(width, height);
    return least < SmallestOfLevels[0] ? 1 : least < SmallestOfLevels[1] ? 2 : 3;
  }
  /// The pixels that those of an extent ask for at a level: whole blocks, and one more on each side for their windows.
  static std::array<int, 4> ExtentFor(int level, const std::array<int, 4>& extent, int width, int height)
  {
    const int side = lookLevels[level].Side;
    const std::array<int, 4> inner = level > 0 ? ExtentFor(level - 1, extent, width, height) : extent;
    const auto low = [side](int at) { return std::max(at / side * side - side, 0); };
    const auto high = [side](int at, int size)
    {
      const int rest = size - 1 - at / side * side; // nothing passes the largest integer
      return rest < 2 * side ? size - 1 : size - 1 - rest + 2 * side - 1;
    };
    return { low(inner[0]), high(inner[1], width), low(inner[2]), high(inner[3], height) };
  }

  /// @param extent of the coarsest of @p levels.
  LookedPixels(const std::array<int, 4>& extent, int levels, int groups)
    : Extent(extent)
    , LevelCount(levels)
    , Groups(static_cast<std::size_t>(groups))
  {
    const auto columns = static_cast<std::size_t>(extent[1] - extent[0] + 1);
    const auto rows = static_cast<std::size_t>(extent[3] - extent[2] + 1);
    this->Pixels.Resize(columns * rows);
    this->Hidden.Resize(columns * rows * this->Groups);
    this->Light.Resize(columns * rows * this->Groups);
  }

  int Levels() const { return this->LevelCount; }
  std::size_t NumberOfGroups() const { return this->Groups; }
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

  static constexpr int SmallestOfLevels[] = { 128, 1024 };

  std::array<int, 4> Extent;
  int LevelCount;
  std::size_t Groups;
  PixelArray<LookedPixel> Pixels;
  PixelArray<float> Hidden;
  PixelArray<float> Light;
};

} // namespace shadowcones

#endif
