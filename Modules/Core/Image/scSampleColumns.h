// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSampleColumns.h
 * @brief The error of samples of places and light points, from differences of those that are near in both. Internal to Core.
 *
 * Of n samples the k-th has a place in the k-th of n parts of the ray and a light point from a sequence: of every 4^p in
 * turn each of 2^p x 2^p cells of the lamp has one. Those of a cell are a column along the ray. Half the mean square of the
 * differences of neighbours in a column is a sample's variance in its stratum, 4^p parts of the ray by a cell of the lamp,
 * and somewhat more. Single parts by all of the lamp (p = 0) serve where the lamp is small or samples are few; for more
 * samples under a large lamp what strata say falls with their size, as the error does. The least of them is taken.
 *
 * It is more where strata differ by what lies between them: of a lone edge half the square of its step is counted, and
 * the variance is a sixth of it (x (1 - x) for an edge anywhere in its stratum). Whether differences are edges or noise is
 * seen in their products with the next: noise turns back, by half a square on average, and a lone edge does not.
 */
#ifndef scSampleColumns_h
#define scSampleColumns_h

#include <array>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Of the samples of one pass; one a thread.
class SampleColumns
{
public:
  static constexpr int MostLevels = 5;

  /// Sums of products of two differences each of all and of the visible light, for any ratio of the two.
  struct Products
  {
    double AllAll = 0.0;
    double AllVisible = 0.0;
    double VisibleVisible = 0.0;

    void Add(double all, double visible, double nextAll, double nextVisible)
    {
      this->AllAll += all * nextAll;
      this->AllVisible += 0.5 * (all * nextVisible + visible * nextAll);
      this->VisibleVisible += visible * nextVisible;
    }
    /// Of what is visible but for the ratio of all.
    double Of(double ratio) const
    {
      return this->VisibleVisible - 2.0 * ratio * this->AllVisible + ratio * ratio * this->AllAll;
    }
  };
  /// Of columns of one size.
  struct Level
  {
    int Differences = 0;
    int Pairs = 0;     ///< of a difference and the next
    Products Squares;
    Products Turns;    ///< of pairs
  };
  using Levels = std::array<Level, MostLevels>;

  /// What is to be said of the samples' sum.
  struct Error
  {
    double Variance = 0.0;
    double Roughness = 1.0; ///< 1 where differences are noise, 0 where they are lone edges
  };

  SampleColumns();
  /// So many samples are to come.
  void Begin(int count);
  /// @param u, v of the light point, in parts of 2^-32 of the lamp.
  void Add(double all, double visible, std::uint32_t u, std::uint32_t v);
  const Levels& Sums() const { return this->Found; }

  /// @param unit largest difference of two samples, about: columns with few of these do not tell edges from noise.
  static Error ErrorOf(const Levels& sums, int count, double ratio, double unit);

private:
  /// Of a cell of the lamp.
  struct Column
  {
    int Samples = 0; ///< 2: two or more
    double All = 0.0; ///< of the last one
    double Visible = 0.0;
    double AllStep = 0.0; ///< to it from the one before
    double VisibleStep = 0.0;
  };

  int InUse = 1; ///< levels
  Levels Found;
  std::vector<Column> Columns; ///< level by level
};

} // namespace shadowcones

#endif
