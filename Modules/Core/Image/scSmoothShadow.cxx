// SPDX-License-Identifier: BSD-3-Clause
#include "scSmoothShadow.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// A thin shadow or beam may have slipped between them: see scBlockedLight.cxx.
constexpr double unseenSpread = 0.7;
/// As many pixels around one are to say the same.
constexpr int fewestAlike = 6;
/// Pixels may err by this much more than is asked for.
constexpr double excess = 1.2;
/// No fit with fewer pixels than so many, and so many of the block.
constexpr std::size_t fewestMembers = 80;
constexpr int fewestOfBlock = 8;
/// Unshadowed light that ends at a surface is to follow a cubic to this share of the goal.
constexpr double unevenShare = 0.5;
/// What the higher terms say is counted so many times: next to an edge those of still higher order are no less.
constexpr double doubt = 2.0;
/// A sum along a line is out of the ordinary above so many standard errors.
constexpr double outOfOrdinary = 4.0;
constexpr int shortestLine = 6;
constexpr int shortestSparseLine = 4;
/// Noise of n samples falls as n to this power.
constexpr double noisePower = 0.75;

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

SmoothShadow::SmoothShadow(const LookedPixels& looked, int level, SmoothShadow* coarser, const Wanted& wanted)
  : Looked(looked)
  , Level(lookLevels[level])
  , Coarser(coarser)
  , Groups(looked.NumberOfGroups())
  , Asked(wanted)
  , Answers(static_cast<std::size_t>(Level.Side * Level.Side))
  , Left(this->Answers.size() * this->Groups)
  , OfGroups(this->Groups)
{
  for (std::size_t k = 0; k < this->Answers.size(); ++k)
  {
    this->Answers[k].Left = this->Left.data() + k * this->Groups;
  }
}

const SmoothShadow::Answer* SmoothShadow::Of(int i, int j) const
{
  const Answer& own = this->Answers[this->PlaceOf(i, j)];
  return own.Known ? &own : this->Coarser ? this->Coarser->Of(i, j) : nullptr;
}

bool SmoothShadow::IsAccurate(double variance, double left) const
{
  const double wanted = excess * this->Asked.Goal * std::max(left, this->Asked.Darkest);
  return variance <= wanted * wanted;
}

bool SmoothShadow::IsAsked(int i, int j) const
{
  return this->Level.Has(i, j) && this->Looked.Holds(i, j) && this->Looked.At(i, j).Kind >= 0 &&
    this->Looked.At(i, j).Samples >= 0;
}

/// Is light all that pixels around this one see, or shadow? @param samples of each of them on average.
SmoothShadow::Around SmoothShadow::LookAround(int i, int j, double& samples) const
{
  const int reach = this->Level.Reach;
  bool lit = true;
  bool dark = true;
  double sum = 0.0;
  int count = 0;
  for (int b = std::max(j - reach, 0); b <= j + reach; ++b)
  {
    int a = std::max(i - reach, 0);
    for (; !this->Level.Has(a, b); ++a)
    {
    }
    for (; a <= i + reach; a += this->Level.Period)
    {
      if (!this->IsAsked(a, b))
      {
        continue; // beside the image, or an edge
      }
      const LookedPixel& other = this->Looked.At(a, b);
      lit = lit && other.Visible == other.Samples;
      dark = dark && other.Visible == 0;
      if (!lit && !dark)
      {
        return Around::Both;
      }
      sum += other.Samples;
      count += 1;
    }
  }
  samples = count > 0 ? sum / count : 0.0;
  return count < fewestAlike || !(sum > 0.0) ? Around::Both : lit ? Around::Lit : Around::Dark;
}

/// All samples around the pixel are visible, or all are hidden.
bool SmoothShadow::TakeAlike(int i, int j)
{
  const LookedPixel& pixel = this->Looked.At(i, j);
  double samples = 0.0;
  const Around around = pixel.Inside > 0.0f ? this->LookAround(i, j, samples) : Around::Lit;
  if (around == Around::Both)
  {
    return false;
  }
  const bool lit = around == Around::Lit;
  const std::size_t place = this->PlaceOf(i, j);
  Answer& answer = this->Answers[place];
  for (std::size_t g = 0; g < this->Groups; ++g)
  {
    this->Left[place * this->Groups + g] = static_cast<double>(this->Looked.LightOf(i, j)[g]) *
      (lit ? 1.0 : 1.0 - static_cast<double>(this->Looked.HiddenOf(i, j)[g]));
  }
  // As many samples as a line through the block has.
  const double onLine = samples * this->Level.Side / this->Level.Period;
  const double unseen = onLine > 0.0 ? unseenSpread * static_cast<double>(pixel.Inside) / onLine : 0.0;
  const double ofLit = lit ? static_cast<double>(pixel.LitError) : 0.0;
  answer.Variance = unseen * unseen + ofLit * ofLit;
  const double shown = static_cast<double>(pixel.Whole) - (lit ? 0.0 : static_cast<double>(pixel.Inside));
  answer.Known = this->IsAccurate(unseen * unseen, shown);
  return true;
}

void SmoothShadow::MoveTo(int i, int j)
{
  const int side = this->Level.Side;
  if (i / side * side == this->I0 && j / side * side == this->J0)
  {
    return;
  }
  this->I0 = i / side * side;
  this->J0 = j / side * side;
  if (this->Coarser)
  {
    this->Coarser->MoveTo(i, j);
  }
  this->Kinds.clear();
  for (int b = this->J0; b < this->J0 + side; ++b)
  {
    for (int a = this->I0; a < this->I0 + side; ++a)
    {
      this->Answers[this->PlaceOf(a, b)].Known = false;
      if (this->Looked.Holds(a, b) && this->Looked.At(a, b).Kind >= 0 && !this->Of(a, b) && !this->TakeAlike(a, b))
      {
        this->Kinds.push_back(this->Looked.At(a, b).Kind);
      }
    }
  }
  std::sort(this->Kinds.begin(), this->Kinds.end());
  this->Kinds.erase(std::unique(this->Kinds.begin(), this->Kinds.end()), this->Kinds.end());
  for (const int kind : this->Kinds)
  {
    for (const int margin : this->Level.Margins)
    {
      this->Fit(kind, margin);
    }
  }
}

/// Products of Legendre's polynomials, by their order.
void SmoothShadow::SetBasis(Member& member, int margin) const
{
  const double middle = 0.5 * (this->Level.Side - 1);
  const double scale = 1.0 / (0.5 * this->Level.Side + margin);
  const double x[2] = { (member.I - this->I0 - middle) * scale, (member.J - this->J0 - middle) * scale };
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
      member.Basis[term] = member.Weight * p[0][order - n] * p[1][n];
      ++term;
    }
  }
}

/// The pixels of a kind around the block that were asked, and those of the block that nobody knows.
bool SmoothShadow::Gather(int kind, int margin)
{
  this->Members.clear();
  this->Pixels.clear();
  const int side = this->Level.Side;
  int inBlock = 0;
  for (int j = std::max(this->J0 - margin, 0); j < this->J0 + side + margin; ++j)
  {
    for (int i = std::max(this->I0 - margin, 0); i < this->I0 + side + margin; ++i)
    {
      Member member;
      member.I = i;
      member.J = j;
      member.InBlock = i >= this->I0 && i < this->I0 + side && j >= this->J0 && j < this->J0 + side;
      const bool asked = this->IsAsked(i, j) && this->Looked.At(i, j).Kind == kind;
      if (member.InBlock && this->Looked.Holds(i, j) && this->Looked.At(i, j).Kind == kind && !this->Of(i, j))
      {
        this->Pixels.push_back(member);
      }
      if (asked)
      {
        const int samples = std::max(this->Looked.At(i, j).Samples, this->Level.Fewest);
        member.Weight = std::pow(static_cast<double>(samples) / this->Level.Fewest, noisePower);
        this->Members.push_back(member);
        inBlock += member.InBlock ? 1 : 0;
      }
    }
  }
  return !this->Pixels.empty() && this->Members.size() >= fewestMembers && inBlock >= fewestOfBlock;
}

/// Cholesky's factor of the basis' products. @return false where the pixels do not tell the terms apart.
bool SmoothShadow::Factorize()
{
  for (std::size_t a = 0; a < Terms; ++a)
  {
    this->Factor[a].fill(0.0);
  }
  for (const Member& member : this->Members)
  {
    for (std::size_t a = 0; a < Terms; ++a)
    {
      for (std::size_t b = 0; b <= a; ++b)
      {
        this->Factor[a][b] += member.Basis[a] * member.Basis[b];
      }
    }
  }
  for (std::size_t a = 0; a < Terms; ++a)
  {
    const double before = this->Factor[a][a];
    for (std::size_t b = 0; b <= a; ++b)
    {
      const double sum = this->Factor[a][b] - SumOf(this->Factor[a], this->Factor[b], 0, b);
      if (a > b)
      {
        this->Factor[a][b] = sum / this->Factor[b][b];
      }
      else if (sum > 1e-6 * before)
      {
        this->Factor[a][a] = std::sqrt(sum);
      }
      else
      {
        return false;
      }
    }
  }
  return true;
}

void SmoothShadow::Orthonormalize(Coefficients& basis) const
{
  for (std::size_t a = 0; a < Terms; ++a)
  {
    basis[a] = (basis[a] - SumOf(this->Factor[a], basis, 0, a)) / this->Factor[a][a];
  }
}

template <class Value>
SmoothShadow::Coefficients SmoothShadow::Project(Value&& value) const
{
  Coefficients sums{};
  for (const Member& member : this->Members)
  {
    const double y = member.Weight * value(member);
    for (std::size_t k = 0; k < Terms; ++k)
    {
      sums[k] += y * member.Basis[k];
    }
  }
  return sums;
}

/// Do rays end at surfaces that do not go on smoothly? The unshadowed light tells, which has no noise.
bool SmoothShadow::IsUneven() const
{
  const auto whole = [this](const Member& member)
  { return static_cast<double>(this->Looked.At(member.I, member.J).Whole); };
  const Coefficients fit = this->Project(whole);
  const auto differs = [&](const Member& member)
  {
    const double value = member.Weight * whole(member);
    return std::fabs(value - SumOf(fit, member.Basis, 0, Cubic)) > unevenShare * this->Asked.Goal * value;
  };
  return std::any_of(this->Members.begin(), this->Members.end(), differs) ||
    std::any_of(this->Pixels.begin(), this->Pixels.end(), differs);
}

/// Is there a line of pixels through the block whose residuals are no noise?
bool SmoothShadow::HasLine(double variance, int margin)
{
  const int side = this->Level.Side + 2 * margin;
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
  const int shortest = this->Level.Period > 1 ? shortestSparseLine : shortestLine;
  for (std::size_t line = 0; line < size; ++line)
  {
    const int count = this->Counts[line];
    if (count >= shortest && this->Sums[line] * this->Sums[line] > outOfOrdinary * outOfOrdinary * count * variance)
    {
      return true;
    }
  }
  return false;
}

void SmoothShadow::Accept(const Member& pixel, const Coefficients& mean, double noise, double bias)
{
  const LookedPixel& looked = this->Looked.At(pixel.I, pixel.J);
  const auto whole = static_cast<double>(looked.Whole);
  const double most = static_cast<double>(looked.Inside) / whole;
  const double hidden = std::clamp(SumOf(mean, pixel.Basis, 0, Cubic), 0.0, most);
  const double beyond = SumOf(mean, pixel.Basis, Cubic, Terms);
  const double ofShare = noise * SumOf(pixel.Basis, pixel.Basis, 0, Cubic) + std::max(doubt * bias, beyond * beyond);
  const double variance = whole * whole * ofShare;
  if (!this->IsAccurate(variance, (1.0 - hidden) * whole))
  {
    return;
  }
  const double ofLit = (1.0 - hidden) * static_cast<double>(looked.LitError);
  const std::size_t place = this->PlaceOf(pixel.I, pixel.J);
  this->Answers[place].Known = true;
  this->Answers[place].Variance = variance + ofLit * ofLit;
  for (std::size_t g = 0; g < this->Groups; ++g)
  {
    const double ofGroup =
      this->Groups > 1 ? std::clamp(SumOf(this->OfGroups[g], pixel.Basis, 0, Cubic), 0.0, 1.0) : hidden;
    this->Left[place * this->Groups + g] =
      static_cast<double>(this->Looked.LightOf(pixel.I, pixel.J)[g]) * (1.0 - ofGroup);
  }
}

void SmoothShadow::Fit(int kind, int margin)
{
  if (!this->Gather(kind, margin))
  {
    return;
  }
  for (Member& member : this->Members)
  {
    this->SetBasis(member, margin);
  }
  if (!this->Factorize())
  {
    return;
  }
  for (Member& member : this->Members)
  {
    this->Orthonormalize(member.Basis);
  }
  for (Member& pixel : this->Pixels)
  {
    this->SetBasis(pixel, margin);
    this->Orthonormalize(pixel.Basis);
  }
  if (kind % 2 == 1 && this->IsUneven())
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
    member.Residual = member.Weight * hiddenOf(member) - SumOf(mean, member.Basis, 0, Terms);
    all += member.Residual * member.Residual;
    if (member.InBlock)
    {
      const double more = SumOf(mean, member.Basis, Cubic, Terms) / member.Weight;
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
  for (std::size_t g = 0; this->Groups > 1 && g < this->Groups; ++g)
  {
    this->OfGroups[g] = this->Project(
      [this, g](const Member& member) { return static_cast<double>(this->Looked.HiddenOf(member.I, member.J)[g]); });
  }
  for (const Member& pixel : this->Pixels)
  {
    this->Accept(pixel, mean, noise, beyond / inBlock);
  }
}

} // namespace shadowcones
