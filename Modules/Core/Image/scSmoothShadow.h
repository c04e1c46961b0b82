// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSmoothShadow.h
 * @brief Where shadow is smooth over the image, a pixel's neighbours tell it. Internal to Core.
 *
 * The hidden share of the light of pixels around a block, which few samples each have told, is fitted by a cubic in the
 * pixel's place, those that took more samples by their weight. Terms of fourth and fifth order, which are fitted along with
 * it, tell how far the cubic may be off, and what they leave is noise: so the error is measured, not assumed. Windows are
 * small, and looks long enough for these: what large windows leave of thin things is lost in the noise of short looks.
 * What is assumed: nothing that matters is narrower than a pixel and shorter than a block. Sums along rows, columns and
 * diagonals look for what is as narrow and longer. Where a coarser level tells a pixel, no finer one is asked.
 */
#ifndef scSmoothShadow_h
#define scSmoothShadow_h

#include "scLookedPixels.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Judges blocks of pixels of a level; one a thread.
class SmoothShadow
{
public:
  /// Of an answer.
  struct Wanted
  {
    double Goal;    ///< relative standard error that is asked for
    double Darkest; ///< what is left counts as no less than this
  };
  /// @param coarser of the next level, which is moved along with this one; nullptr: none.
  SmoothShadow(const LookedPixels& looked, int level, SmoothShadow* coarser, const Wanted& wanted);

  /// The block that holds this pixel.
  void MoveTo(int i, int j);

  /// A pixel of the block.
  struct Answer
  {
    bool Known = false;
    double Variance = 0.0;
    const double* Left = nullptr; ///< of its light, of every group
  };
  /// @return nullptr where nobody knows.
  const Answer* Of(int i, int j) const;

private:
  static constexpr int Cubic = 10; ///< terms of a cubic
  static constexpr int Terms = 21; ///< with those of fourth and fifth order
  using Coefficients = std::array<double, Terms>;
  struct Member
  {
    int I = 0;
    int J = 0;
    bool InBlock = false;
    double Weight = 1.0; ///< noise is as one over it
    Coefficients Basis;  ///< of one that is fitted: times the weight
    double Residual = 0.0; ///< the same
  };
  enum class Around
  {
    Lit,
    Dark,
    Both
  };

  std::size_t PlaceOf(int i, int j) const
  {
    return static_cast<std::size_t>((j - this->J0) * this->Level.Side + (i - this->I0));
  }
  bool IsAsked(int i, int j) const;
  Around LookAround(int i, int j, double& samples) const;
  bool TakeAlike(int i, int j);
  void Fit(int kind, int margin);
  bool Gather(int kind, int margin);
  void SetBasis(Member& member, int margin) const;
  bool Factorize();
  void Orthonormalize(Coefficients& basis) const;
  template <class Value>
  Coefficients Project(Value&& value) const;
  bool IsUneven() const;
  bool HasLine(double variance, int margin);
  void Accept(const Member& pixel, const Coefficients& mean, double noise, double bias);
  bool IsAccurate(double variance, double left) const;

  const LookedPixels& Looked;
  const LookLevel& Level;
  SmoothShadow* const Coarser;
  const std::size_t Groups;
  const Wanted Asked;
  int I0 = -1;
  int J0 = -1;
  std::vector<Answer> Answers;
  std::vector<int> Kinds;
  std::vector<double> Left;
  std::vector<Member> Members;
  std::vector<Member> Pixels; ///< of the block, which ask
  std::array<Coefficients, Terms> Factor; ///< of the basis' products
  std::vector<Coefficients> OfGroups;
  std::vector<double> Sums;
  std::vector<int> Counts;
};

} // namespace shadowcones

#endif
