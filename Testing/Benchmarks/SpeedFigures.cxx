// SPDX-License-Identifier: BSD-3-Clause
#include "SpeedFigures.h"

#include "DarkScenes.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace shadowcones
{
namespace
{
/// How many times faster than the baselines an image is wanted.
struct Bounds
{
  double FirstAgainstMarch;
  double FurtherAgainstMarch;
  double FirstAgainstLocator;
  double GuidedAgainstStratified;
  double FurtherAgainstStratified;
  double Error; ///< of the last one
};

Bounds BoundsOf(const std::string& scene)
{
  if (IsDarkScene(scene))
  {
    return { 0.0, 0.0, 0.0, 0.0, 0.0, scene == "canopy" ? 0.007 : 0.01 };
  }
  if (scene == "tree")
  {
    return { 10.0, 50.0, 50.0, 1.2, 20.0, 0.014 };
  }
  return { 4.0, 15.0, 50.0, 2.0, scene == "chair" ? 5.0 : 4.0, 0.007 };
}

TimeAtError Plus(TimeAtError time, double seconds)
{
  time.Seconds += time.IsKnown() ? seconds : 0.0;
  return time;
}

/// Where most is dark: without cones, against the march with the best of its knobs.
std::vector<Comparison> CompareInTheDark(const SpeedFigures& figures, Clock clock)
{
  const double occluders = figures.StageSeconds("occluders", clock);
  std::vector<Comparison> list;
  const bool canopy = figures.Scene == "canopy";
  for (const double error : { canopy ? 0.015 : 0.025, canopy ? 0.007 : 0.01 })
  {
    Comparison c;
    c.Name = "first image without cones, against the best of (a)";
    c.Error = std::max(error, figures.SmallestError);
    c.Ours = "Stratified";
    c.Time = Plus(TimeAt(figures.Curve("Stratified", clock), c.Error), occluders);
    c.Baseline = Plus(TimeAt(figures.Curve("BruteForce", clock), c.Error), occluders);
    c.Wanted = 1.0;
    list.push_back(c);
  }
  return list;
}

/// The shorter of two times; @p name receives what it is the time of.
TimeAtError Shorter(
  const TimeAtError& a, const char* nameOfA, const TimeAtError& b, const char* nameOfB, std::string& name)
{
  const bool takeA = a.IsKnown() && (!b.IsKnown() || a.Seconds <= b.Seconds);
  name = takeA ? nameOfA : nameOfB;
  return takeA ? a : b;
}
} // namespace

//------------------------------------------------------------------------------
double SpeedFigures::StageSeconds(const std::string& name, Clock clock) const
{
  for (const Stage& stage : this->Stages)
  {
    if (stage.Name == name)
    {
      return stage.Time.By(clock);
    }
  }
  throw std::logic_error("No stage '" + name + "'.");
}

//------------------------------------------------------------------------------
const ModeRow& SpeedFigures::DefaultRow(const std::string& mode) const
{
  const auto row = std::find_if(this->Rows.begin(), this->Rows.end(),
    [&](const ModeRow& candidate) { return candidate.Mode == mode && candidate.Default; });
  if (row == this->Rows.end())
  {
    throw std::logic_error("No default of '" + mode + "'.");
  }
  return *row;
}

//------------------------------------------------------------------------------
std::vector<CurvePoint> SpeedFigures::Curve(const std::string& mode, Clock clock, bool withFill) const
{
  std::vector<CurvePoint> points;
  for (const ModeRow& row : this->Rows)
  {
    if (row.Mode == mode)
    {
      points.push_back(
        { row.Frame.By(clock) + (withFill ? row.Fill.By(clock) : 0.0), std::max(row.Error.Rms, this->SmallestError) });
    }
  }
  return points;
}

//------------------------------------------------------------------------------
bool Comparison::IsMet() const
{
  if (!this->IsKnown())
  {
    return false;
  }
  return this->AtMost ? this->Time.Seconds <= this->Wanted * this->Baseline.Seconds : this->Ratio() >= this->Wanted;
}

//------------------------------------------------------------------------------
std::vector<Comparison> CompareAtEqualError(const SpeedFigures& figures, Clock clock)
{
  const Bounds bounds = BoundsOf(figures.Scene);
  const ModeRow& march = figures.DefaultRow("BruteForce");
  const double occluders = figures.StageSeconds("occluders", clock);
  const double cones = occluders + figures.StageSeconds("vectors", clock) + figures.StageSeconds("cones", clock);
  const double hierarchy = figures.StageSeconds("hierarchy", clock);
  const auto exactly = [](double seconds) { return TimeAtError{ TimeAtError::Interpolated, seconds }; };
  const auto first = [&](double error, std::string& name)
  {
    return Shorter(Plus(TimeAt(figures.Curve("Volume", clock, true), error), cones), "Volume",
      Plus(TimeAt(figures.Curve("Guided", clock), error), cones + hierarchy), "Guided", name);
  };
  const auto further = [&](double error, std::string& name)
  {
    return Shorter(TimeAt(figures.Curve("Volume", clock), error), "Volume",
      TimeAt(figures.Curve("Guided", clock), error), "Guided", name);
  };

  std::vector<Comparison> list;
  if (IsDarkScene(figures.Scene))
  {
    list = CompareInTheDark(figures, clock);
  }
  Comparison c;
  const double atDefault = std::max(march.Error.Rms, figures.SmallestError);
  c.Error = atDefault;
  c.Time = first(c.Error, c.Ours);
  c.Name = "first image, against (a)";
  c.Baseline = exactly(occluders + march.Frame.By(clock));
  c.Wanted = bounds.FirstAgainstMarch;
  list.push_back(c);

  c.Name = "first image, against (b)";
  c.Baseline = exactly(figures.Locator.Build.By(clock) + figures.Locator.SecondsOfImage(clock));
  c.Wanted = bounds.FirstAgainstLocator;
  list.push_back(c);

  c.Name = "further images, against (a)";
  c.Time = further(c.Error, c.Ours);
  c.Baseline = exactly(march.Frame.By(clock));
  c.Wanted = bounds.FurtherAgainstMarch;
  list.push_back(c);

  for (const double error :
    { atDefault, std::max(figures.DefaultRow("Stratified").Error.Rms, figures.SmallestError), bounds.Error })
  {
    c.Name = "Guided, cones given, against (c)";
    c.Error = error;
    c.Ours = "Guided";
    c.Time = TimeAt(figures.Curve("Guided", clock), error);
    c.Baseline = TimeAt(figures.Curve("Stratified", clock), error);
    c.Wanted = bounds.GuidedAgainstStratified;
    list.push_back(c);
  }

  for (const double error : { bounds.Error, atDefault })
  {
    c.Name = "further images, against (c)";
    c.Error = error;
    c.Time = further(error, c.Ours);
    c.Baseline = TimeAt(figures.Curve("Stratified", clock), error);
    c.Wanted = error == bounds.Error ? bounds.FurtherAgainstStratified : 0.0;
    list.push_back(c);
  }

  c.Name = "first image, against (a)";
  c.Error = bounds.Error;
  c.Time = first(c.Error, c.Ours);
  c.Baseline = Plus(TimeAt(figures.Curve("BruteForce", clock), c.Error), occluders);
  c.Wanted = 0.0;
  list.push_back(c);

  c = Comparison();
  c.Name = "frame of Volume / unshadowed frame";
  c.Ours = "Volume";
  c.Time = exactly(figures.DefaultRow("Volume").Frame.By(clock));
  c.Baseline = exactly(figures.Unshadowed.By(clock));
  c.Wanted = 1.5;
  c.AtMost = true;
  list.push_back(c);
  for (std::size_t k = 0; clock == Clock::Wall && k < figures.Threading.size(); ++k)
  {
    const ThreadsRow& row = figures.Threading[k];
    c.Name = std::to_string(figures.Threads) + " threads against one: " + row.Name;
    c.Ours = row.Name;
    c.Time = exactly(row.Many.Seconds);
    c.Baseline = exactly(row.One.Seconds);
    c.Wanted = figures.Threads == 2 ? 1.8 : 0.0;
    c.AtMost = false;
    list.push_back(c);
  }
  return list;
}

} // namespace shadowcones
