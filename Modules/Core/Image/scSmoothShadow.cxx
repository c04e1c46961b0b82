// SPDX-License-Identifier: BSD-3-Clause
#include "scSmoothShadow.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Where all samples of so many pixels around one say the same, nothing is fitted.
constexpr int alikeReach = 2;
/// A thin shadow or beam may have slipped between them: see scBlockedLight.cxx.
constexpr double unseenSpread = 0.7;
/// Pixels may err by this much more than is asked for.
constexpr double excess = 1.2;
/// No fit with fewer pixels than so many.
constexpr std::size_t fewestMembers = 80;
/// Unshadowed light that ends at a surface is to follow a cubic to this share of the goal.
constexpr double unevenShare = 0.5;
/// What the higher terms say is counted so many times: next to an edge those of still higher order are no less.
constexpr double doubt = 2.0;
/// A sum along a line is out of the ordinary above so many standard errors.
constexpr double outOfOrdinary = 4.0;
constexpr int shortestLine = 6;
constexpr int margins[] = { 4, 12 };
static_assert(margins[1] <= LookedPixels::Margin);
} // anonymous namespace

SmoothShadow::SmoothShadow(const LookedPixels& looked, const ExtinctionGroups& groups, double goal, double darkest)
  : Looked(looked)
  , Extinction(groups)
  , Groups(static_cast<std::size_t>(groups.Count()))
  , Goal(goal)
  , Darkest(darkest)
  , Left(Side * Side * this->Groups)
  , OfGroups(this->Groups)
{
}

bool SmoothShadow::IsAccurate(double variance, double left) const
{
  const double wanted = excess * this->Goal * std::max(left, this->Darkest);
  return variance <= wanted * wanted;
}

bool SmoothShadow::IsAlike(int i, int j) const
{
  const LookedPixel& pixel = this->Looked.At(i, j);
  const bool lit = pixel.Visible == pixel.Samples;
  for (int b = j - alikeReach; b <= j + alikeReach; ++b)
  {
    for (int a = i - alikeReach; a <= i + alikeReach; ++a)
    {
      if (!this->Looked.Holds(a, b))
      {
        continue; // beside the image
      }
      const LookedPixel& other = this->Looked.At(a, b);
      if (other.Kind >= 0 && other.Visible != (lit ? other.Samples : 0))
      {
        return false;
      }
    }
  }
  return lit || pixel.Visible == 0;
}

/// All samples around the pixel are visible, or all are hidden.
bool SmoothShadow::TakeAlike(int i, int j)
{
  if (!this->IsAlike(i, j))
  {
    return false;
  }
  const LookedPixel& pixel = this->Looked.At(i, j);
  const bool lit = pixel.Visible == pixel.Samples;
  Answer& answer = this->Answers[this->PlaceOf(i, j)];
  double* left = this->Left.data() + this->PlaceOf(i, j) * this->Groups;
  for (std::size_t g = 0; g < this->Groups; ++g)
  {
    left[g] = static_cast<double>(this->Looked.LightOf(i, j)[g]) *
      (lit ? 1.0 : 1.0 - static_cast<double>(this->Looked.HiddenOf(i, j)[g]));
  }
  const double unseen =
    pixel.Samples > 0 ? unseenSpread * static_cast<double>(pixel.Inside) / (Side * pixel.Samples) : 0.0;
  const double ofLit = lit ? static_cast<double>(pixel.LitError) : 0.0;
  answer.Variance = unseen * unseen + ofLit * ofLit;
  const double shown = static_cast<double>(pixel.Whole) - (lit ? 0.0 : static_cast<double>(pixel.Inside));
  answer.Known = this->IsAccurate(unseen * unseen, shown);
  return true;
}

void SmoothShadow::MoveTo(int i0, int j0)
{
  this->I0 = i0;
  this->J0 = j0;
  this->Answers.fill(Answer());
  std::array<int, Side * Side> kinds;
  kinds.fill(-1);
  for (int j = j0; j < j0 + Side; ++j)
  {
    for (int i = i0; i < i0 + Side; ++i)
    {
      if (this->Looked.Holds(i, j) && this->Looked.At(i, j).Kind >= 0 && !this->TakeAlike(i, j))
      {
        kinds[this->PlaceOf(i, j)] = this->Looked.At(i, j).Kind;
      }
    }
  }
  for (std::size_t k = 0; k < kinds.size(); ++k)
  {
    const int kind = kinds[k];
    if (kind < 0)
    {
      continue;
    }
    std::replace(kinds.begin(), kinds.end(), kind, -1);
    for (const int margin : margins)
    {
      this->Fit(kind, margin);
    }
  }
}

/// The pixels of a kind around the block.
bool SmoothShadow::Gather(int kind, int margin)
{
  this->Members.clear();
  bool open = false;
  const double middle = 0.5 * (Side - 1);
  const double scale = 1.0 / (0.5 * Side + margin);
  for (int j = this->J0 - margin; j < this->J0 + Side + margin; ++j)
  {
    for (int i = this->I0 - margin; i < this->I0 + Side + margin; ++i)
    {
      if (!this->Looked.Holds(i, j) || this->Looked.At(i, j).Kind != kind)
      {
        continue;
      }
      Member member;
      member.I = i;
      member.J = j;
      member.InBlock = i >= this->I0 && i < this->I0 + Side && j >= this->J0 && j < this->J0 + Side;
      open = open || (member.InBlock && !this->Answers[this->PlaceOf(i, j)].Known);
      // Products of Legendre's polynomials, by their order.
      const double x[2] = { (i - this->I0 - middle) * scale, (j - this->J0 - middle) * scale };
      double p[2][6];
      for (int axis = 0; axis < 2; ++axis)
      {
        p[axis][0] = 1.0;
        p[axis][1] = x[axis];
        for (int n = 1; n < 5; ++n)
        {
          p[axis][n + 1] = ((2 * n + 1) * x[axis] * p[axis][n] - n * p[axis][n - 1]) / (n + 1);
        }
      }
      std::size_t term = 0;
      for (int order = 0; order < 6; ++order)
      {
        for (int n = 0; n <= order; ++n)
        {
          member.Basis[term] = p[0][order - n] * p[1][n];
          ++term;
        }
      }
      this->Members.push_back(member);
    }
  }
  return open && this->Members.size() >= fewestMembers;
}

/// By Cholesky's factor of the basis' products. @return false where the pixels do not tell the terms apart.
bool SmoothShadow::Orthonormalize()
{
  double factor[Terms][Terms] = {};
  for (const Member& member : this->Members)
  {
    for (int a = 0; a < Terms; ++a)
    {
      for (int b = 0; b <= a; ++b)
      {
        factor[a][b] += member.Basis[static_cast<std::size_t>(a)] * member.Basis[static_cast<std::size_t>(b)];
      }
    }
  }
  for (int a = 0; a < Terms; ++a)
  {
    const double before = factor[a][a];
    for (int b = 0; b <= a; ++b)
    {
      double sum = factor[a][b];
      for (int c = 0; c < b; ++c)
      {
        sum -= factor[a][c] * factor[b][c];
      }
      if (a == b)
      {
        if (!(sum > 1e-6 * before))
        {
          return false;
        }
        factor[a][a] = std::sqrt(sum);
      }
      else
      {
        factor[a][b] = sum / factor[b][b];
      }
    }
  }
  for (Member& member : this->Members)
  {
    for (int a = 0; a < Terms; ++a)
    {
      double value = member.Basis[static_cast<std::size_t>(a)];
      for (int b = 0; b < a; ++b)
      {
        value -= factor[a][b] * member.Basis[static_cast<std::size_t>(b)];
      }
      member.Basis[static_cast<std::size_t>(a)] = value / factor[a][a];
    }
  }
  return true;
}

template <class Value>
SmoothShadow::Coefficients SmoothShadow::Project(Value&& value) const
{
  Coefficients sums{};
  for (const Member& member : this->Members)
  {
    const double y = value(member);
    for (std::size_t k = 0; k < Terms; ++k)
    {
      sums[k] += y * member.Basis[k];
    }
  }
  return sums;
}

namespace
{
template <class Array>
double SumOf(const Array& a, const Array& b, std::size_t begin, std::size_t end)
{
  double sum = 0.0;
  for (std::size_t k = begin; k < end; ++k)
  {
    sum += a[k] * b[k];
  }
  return sum;
}
} // anonymous namespace

/// Do rays end at surfaces that do not go on smoothly? The unshadowed light tells, which has no noise.
bool SmoothShadow::IsUneven() const
{
  const auto whole = [this](const Member& member)
  { return static_cast<double>(this->Looked.At(member.I, member.J).Whole); };
  const Coefficients fit = this->Project(whole);
  return std::any_of(this->Members.begin(), this->Members.end(),
    [&](const Member& member)
    {
      const double value = whole(member);
      return std::fabs(value - SumOf(fit, member.Basis, 0, Cubic)) > unevenShare * this->Goal * value;
    });
}

/// Is there a line of pixels through the block whose residuals are no noise?
bool SmoothShadow::HasLine(double variance, int margin)
{
  const int side = Side + 2 * margin;
  const auto size = static_cast<std::size_t>(6 * side);
  this->Sums.assign(size, 0.0);
  this->Counts.assign(size, 0);
  for (const Member& member : this->Members)
  {
    const int i = member.I - this->I0 + margin;
    const int j = member.J - this->J0 + margin;
    const int lines[4] = { i, side + j, 2 * side + i + j, 4 * side + i - j + side - 1 };
    for (const int line : lines)
    {
      this->Sums[static_cast<std::size_t>(line)] += member.Residual;
      this->Counts[static_cast<std::size_t>(line)] += 1;
    }
  }
  for (std::size_t line = 0; line < size; ++line)
  {
    const int count = this->Counts[line];
    if (count >= shortestLine && this->Sums[line] * this->Sums[line] > outOfOrdinary * outOfOrdinary * count * variance)
    {
      return true;
    }
  }
  return false;
}

void SmoothShadow::Accept(const Member& member, const Coefficients& mean, double noise, double bias)
{
  Answer& answer = this->Answers[this->PlaceOf(member.I, member.J)];
  if (answer.Known)
  {
    return;
  }
  const LookedPixel& pixel = this->Looked.At(member.I, member.J);
  const auto whole = static_cast<double>(pixel.Whole);
  const double most = static_cast<double>(pixel.Inside) / whole;
  const double hidden = std::clamp(SumOf(mean, member.Basis, 0, Cubic), 0.0, most);
  const double beyond = SumOf(mean, member.Basis, Cubic, Terms);
  const double ofShare = noise * SumOf(member.Basis, member.Basis, 0, Cubic) + std::max(doubt * bias, beyond * beyond);
  const double variance = whole * whole * ofShare;
  if (!this->IsAccurate(variance, (1.0 - hidden) * whole))
  {
    return;
  }
  const double ofLit = (1.0 - hidden) * static_cast<double>(pixel.LitError);
  answer.Known = true;
  answer.Variance = variance + ofLit * ofLit;
  double* left = this->Left.data() + this->PlaceOf(member.I, member.J) * this->Groups;
  for (std::size_t g = 0; g < this->Groups; ++g)
  {
    const double ofGroup =
      this->Groups > 1 ? std::clamp(SumOf(this->OfGroups[g], member.Basis, 0, Cubic), 0.0, 1.0) : hidden;
    left[g] = static_cast<double>(this->Looked.LightOf(member.I, member.J)[g]) * (1.0 - ofGroup);
  }
}

void SmoothShadow::Fit(int kind, int margin)
{
  if (!this->Gather(kind, margin) || !this->Orthonormalize() || (kind % 2 == 1 && this->IsUneven()))
  {
    return;
  }
  const auto hiddenOf = [this](const Member& member)
  { return 1.0 - static_cast<double>(this->Looked.At(member.I, member.J).Shown); };
  const Coefficients mean = this->Project(hiddenOf);
  double all = 0.0;
  double ofBlock = 0.0;
  double beyond = 0.0;
  int inBlock = 0;
  for (Member& member : this->Members)
  {
    member.Residual = hiddenOf(member) - SumOf(mean, member.Basis, 0, Terms);
    all += member.Residual * member.Residual;
    if (member.InBlock)
    {
      const double more = SumOf(mean, member.Basis, Cubic, Terms);
      ofBlock += member.Residual * member.Residual;
      beyond += more * more;
      inBlock += 1;
    }
  }
  const auto count = static_cast<double>(this->Members.size());
  const double noise = std::max(all, ofBlock / inBlock * count) / (count - Terms);
  if (this->HasLine(noise, margin))
  {
    return;
  }
  for (std::size_t g = 0; g<this->Groups&& this->Groups> 1; ++g)
  {
    this->OfGroups[g] = this->Project(
      [this, g](const Member& member) { return static_cast<double>(this->Looked.HiddenOf(member.I, member.J)[g]); });
  }
  for (const Member& member : this->Members)
  {
    if (member.InBlock)
    {
      this->Accept(member, mean, noise, beyond / inBlock);
    }
  }
}

} // namespace shadowcones
