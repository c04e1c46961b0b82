// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSmoothShadow.h
 * @brief Where shadow is smooth over the image, a pixel's neighbours tell it. Internal to Core.
 *
 * The hidden share of the light of all pixels around a block, which few samples each have told, is fitted by a cubic in
 * the pixel's place. Terms of fourth and fifth order, which are fitted along with it, tell how far the cubic may be off,
 * and what they leave is noise: so the error is measured, not assumed. What is assumed: nothing that matters is narrower
 * than a pixel and shorter than a block. Sums along rows, columns and diagonals look for what is as narrow and longer.
 */
#ifndef scSmoothShadow_h
#define scSmoothShadow_h

#include "scExtinctionGroups.h"
#include "scLookedPixels.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Judges blocks of pixels; one a thread.
class SmoothShadow
{
public:
  static constexpr int Side = LookedPixels::BlockSide;

  /// @param goal relative standard error that is asked for; @param darkest what is left counts as no less than this.
  SmoothShadow(const LookedPixels& looked, const ExtinctionGroups& groups, double goal, double darkest);

  /// The block whose first pixel this is.
  void MoveTo(int i0, int j0);

  /// A pixel of the block.
  struct Answer
  {
    bool Known = false;
    double Variance = 0.0;
  };
  const Answer& Of(int i, int j) const { return this->Answers[this->PlaceOf(i, j)]; }
  /// What is left of its light, of every group.
  const double* LeftOf(int i, int j) const { return this->Left.data() + this->PlaceOf(i, j) * this->Groups; }

private:
  static constexpr int Cubic = 10; ///< terms of a cubic
  static constexpr int Terms = 21; ///< with those of fourth and fifth order
  using Coefficients = std::array<double, Terms>;
  struct Member
  {
    int I = 0;
    int J = 0;
    bool InBlock = false;
    Coefficients Basis;
    double Residual = 0.0;
  };

  std::size_t PlaceOf(int i, int j) const { return static_cast<std::size_t>((j - this->J0) * Side + (i - this->I0)); }
  bool IsAlike(int i, int j) const;
  bool TakeAlike(int i, int j);
  void Fit(int kind, int margin);
  bool Gather(int kind, int margin);
  bool Orthonormalize();
  template <class Value>
  Coefficients Project(Value&& value) const;
  bool IsUneven() const;
  bool HasLine(double variance, int margin);
  void Accept(const Member& member, const Coefficients& mean, double noise, double bias);
  bool IsAccurate(double variance, double left) const;

  const LookedPixels& Looked;
  const ExtinctionGroups& Extinction;
  const std::size_t Groups;
  const double Goal;
  const double Darkest;
  int I0 = 0;
  int J0 = 0;
  std::array<Answer, Side * Side> Answers;
  std::vector<double> Left;
  std::vector<Member> Members;
  std::vector<Coefficients> OfGroups;
  std::vector<double> Sums;
  std::vector<int> Counts;
};

} // namespace shadowcones

#endif
