// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTileRange.h
 * @brief Tiles of an image that lie at the same place in every part of it. Internal to Core.
 */
#ifndef scTileRange_h
#define scTileRange_h

#include <algorithm>
#include <array>
#include <vector>

namespace shadowcones
{

/// Pixels of the whole image, both ends inclusive.
struct TileRange
{
  int I0 = 0;
  int I1 = -1;
  int J0 = 0;
  int J1 = -1;
};

/// The extent (i from, to, j from, to, inclusive) cut along multiples of @p side, counted from pixel (0, 0).
inline std::vector<TileRange> TilesOf(const std::array<int, 4>& extent, int side)
{
  std::vector<TileRange> tiles;
  if (extent[1] < extent[0] || extent[3] < extent[2])
  {
    return tiles;
  }
  for (int j = extent[2] / side; j <= extent[3] / side; ++j)
  {
    for (int i = extent[0] / side; i <= extent[1] / side; ++i)
    {
      // From the tile's other end, so that nothing passes the largest integer.
      const auto last = [side](int tile, int end) { return end / side > tile ? tile * side + side - 1 : end; };
      tiles.push_back({ std::max(i * side, extent[0]), last(i, extent[1]), std::max(j * side, extent[2]),
        last(j, extent[3]) });
    }
  }
  return tiles;
}

} // namespace shadowcones

#endif
