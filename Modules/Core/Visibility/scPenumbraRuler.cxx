// SPDX-License-Identifier: BSD-3-Clause
#include "scPenumbraRuler.h"

#include "scFrame.h"
#include "scLampPlane.h"
#include "scLightSampling.h"
#include "scRandom.h"
#include "scVisibilityProbe.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int halvings = 24;

/// Corners of a line with the lengths along it.
class Way
{
public:
  explicit Way(const std::vector<Vector3>& corners)
    : Corners(corners)
  {
    double length = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      length += k > 0 ? Length(corners[k] - corners[k - 1]) : 0.0;
      this->Lengths.push_back(length);
    }
  }

  double WholeLength() const { return this->Lengths.empty() ? 0.0 : this->Lengths.back(); }

  Vector3 At(double length) const
  {
    const auto found = std::upper_bound(this->Lengths.begin() + 1, this->Lengths.end() - 1, length);
    const auto k = static_cast<std::size_t>(found - this->Lengths.begin());
    const double step = this->Lengths[k] - this->Lengths[k - 1];
    const double t = step > 0.0 ? std::clamp((length - this->Lengths[k - 1]) / step, 0.0, 1.0) : 0.0;
    return this->Corners[k - 1] + t * (this->Corners[k] - this->Corners[k - 1]);
  }

private:
  const std::vector<Vector3>& Corners;
  std::vector<double> Lengths;
};
} // anonymous namespace

struct PenumbraRuler::Implementation
{
  Implementation(const std::vector<Cone>& cones, const Light& light, const OccluderScene& scene, const Box& bounds,
    const PenumbraWidthOptions& options)
    : Lamp(light)
    , Scene(scene)
    , Rules(scene.RulesFor(FlatFaceOf(light)))
    , Options(options)
  {
    LightBoundingSphere(light, this->Center, this->Radius);
    VisibilityOptions same;
    same.NumberOfLightSamples = options.NumberOfLightSamples;
    same.Seed = options.Seed;
    same.SameSamples = true;
    this->Probe = std::make_unique<VisibilityProbe>(cones, light, &scene, bounds, same);
  }

  /// How fast the fraction changes at a place of a way, or on the average where it cannot be told.
  template <typename Fraction>
  double Slope(const Fraction& fraction, double at, double step, double mean) const
  {
    const double slope = std::fabs(fraction(at + step) - fraction(at - step)) / (2.0 * step);
    return slope > 0.0 ? slope : mean;
  }

  /**
   * Where along a way the fraction passes @p wanted, between a place where it is less (or equal) and one where it is more.
   */
  template <typename Fraction>
  static double Pass(const Fraction& fraction, double wanted, double less, double more)
  {
    for (int k = 0; k < halvings; ++k)
    {
      const double middle = 0.5 * (less + more);
      (fraction(middle) < wanted ? less : more) = middle;
    }
    return 0.5 * (less + more);
  }

  /// The width between two places along a way, and its error; @p place gives the points.
  template <typename Fraction, typename Place>
  PenumbraEdge Measure(const Fraction& fraction, const Place& place, double dark, double bright) const
  {
    PenumbraEdge edge;
    edge.Width = std::fabs(bright - dark);
    edge.Dark = place(dark);
    edge.Bright = place(bright);
    edge.From = std::min(dark, bright);
    edge.To = std::max(dark, bright);
    edge.OccluderId = this->Probe->At(place(0.5 * (dark + bright))).OccluderId;
    const double mean = (this->Options.Upper - this->Options.Lower) / std::max(edge.Width, 1e-300);
    double squares = 0.0;
    for (const bool atDark : { true, false })
    {
      const double at = atDark ? dark : bright;
      const double p = atDark ? this->Options.Lower : this->Options.Upper;
      const double deviation = std::sqrt(p * (1.0 - p) / this->Probe->NumberOfSamples());
      squares += std::pow(deviation / this->Slope(fraction, at, 0.05 * edge.Width, mean), 2);
    }
    edge.Error = std::sqrt(squares);
    return edge;
  }

  /// How wide the penumbra may be by the rule of three, from what hides the light; 0: nothing that was looked at does.
  double RoughWidth(const Vector3& point) const
  {
    constexpr int enough = 8;
    RayRules rules = this->Rules;
    rules.StartTolerance = this->Scene.SurfaceTolerance(point);
    double sum = 0.0;
    int found = 0;
    for (int k = 0; k < this->Options.NumberOfLightSamples && found < enough; ++k)
    {
      const auto uv = SobolPoint(this->Options.Seed, static_cast<std::uint32_t>(k));
      const IncidentSample sample = SampleVisibleLight(this->Lamp, point, uv[0], uv[1]);
      RayHit hit;
      if (sample.Weight > 0.0 && this->Scene.Intersect(point, sample.Direction, 0.0, sample.Distance, hit, rules))
      {
        sum += IsAtInfinity(this->Lamp)
          ? 2.0 * this->Lamp.Radius * hit.T
          : 2.0 * this->Radius * hit.T / std::max(sample.Distance - hit.T, 1e-6 * sample.Distance);
        ++found;
      }
    }
    return found > 0 ? sum / found : 0.0;
  }

  double Fraction(const Vector3& point, const Vector3* normal) const { return this->Probe->At(point, normal).Fraction; }

  /// Unit vector in the plane along which the fraction grows; 0 where that cannot be told.
  Vector3 Uphill(const Vector3& point, const Vector3& normal, const Vector3* facing, double step) const
  {
    const Frame frame = FrameAround(normal);
    for (int attempt = 0; attempt < 3; ++attempt, step *= 3.0)
    {
      const double u = this->Fraction(point + step * frame.U, facing) - this->Fraction(point - step * frame.U, facing);
      const double v = this->Fraction(point + step * frame.V, facing) - this->Fraction(point - step * frame.V, facing);
      if (std::hypot(u, v) * this->Probe->NumberOfSamples() >= 4.0)
      {
        return Normalized(u * frame.U + v * frame.V);
      }
    }
    return {};
  }

  /**
   * Walk from 0, where the fraction is @p start, in growing steps until it is Upper (@p sign 1) or Lower (-1).
   * @return false where it turns back or gets nowhere; else the last place before it and the first place behind it.
   */
  template <typename Function>
  bool Walk(const Function& fraction, double start, int sign, double step, double& before, double& behind) const
  {
    const double wanted = sign > 0 ? this->Options.Upper : this->Options.Lower;
    constexpr double turn = 0.1;
    double best = start;
    before = 0.0;
    behind = 0.0;
    double value = start;
    while (sign * (value - wanted) < 0.0)
    {
      before = behind;
      behind += sign * step;
      step *= 1.25;
      value = fraction(behind);
      if (std::fabs(behind) > this->Options.MaximumWidth || sign * (best - value) > turn)
      {
        return false;
      }
      best = sign > 0 ? std::max(best, value) : std::min(best, value);
    }
    return true;
  }

  const Light Lamp;
  Vector3 Center;
  double Radius = 0.0;
  const OccluderScene& Scene;
  const RayRules Rules;
  const PenumbraWidthOptions Options;
  std::unique_ptr<const VisibilityProbe> Probe;
};

PenumbraRuler::PenumbraRuler(const std::vector<Cone>& cones, const Light& light, const OccluderScene& scene,
  const Box& bounds, const PenumbraWidthOptions& options)
  : Impl(new Implementation(cones, light, scene, bounds, options))
{
}

PenumbraRuler::~PenumbraRuler() = default;

PenumbraPlace PenumbraRuler::Look(const Vector3& point, const Vector3* normal) const
{
  const PointVisibility seen = this->Impl->Probe->At(point, normal);
  PenumbraPlace place;
  place.Visibility = seen.Fraction;
  place.OccluderId = seen.OccluderId;
  return place;
}

PenumbraPlace PenumbraRuler::At(const Vector3& point, const Vector3& normal, bool facing) const
{
  const Implementation& impl = *this->Impl;
  const Vector3* horizon = facing ? &normal : nullptr;
  PenumbraPlace place = this->Look(point, horizon);
  const bool between = place.Visibility >= impl.Options.Lower && place.Visibility <= impl.Options.Upper;
  const double rough = between ? impl.RoughWidth(point) : 0.0;
  if (!(rough > 0.0))
  {
    return place;
  }
  // Off the surface, towards the light, by what single precision can lose, which else might hide the places.
  const Vector3 toLight = IsAtInfinity(impl.Lamp) ? -impl.Lamp.Normal : impl.Center - point;
  const double lift = 0x1p-22 * std::max({ std::fabs(point.X), std::fabs(point.Y), std::fabs(point.Z) });
  const Vector3 start = point + (Dot(toLight, normal) < 0.0 ? -lift : lift) * normal;
  const Vector3 uphill = impl.Uphill(start, normal, horizon, 0.15 * rough);
  const auto at = [&](double length) { return start + length * uphill; };
  const auto fraction = [&](double length) { return impl.Fraction(at(length), horizon); };
  double dark[2];
  double bright[2];
  if (Dot(uphill, uphill) > 0.0 && impl.Walk(fraction, place.Visibility, -1, 0.2 * rough, dark[0], dark[1]) &&
    impl.Walk(fraction, place.Visibility, 1, 0.2 * rough, bright[0], bright[1]))
  {
    place.Edge = impl.Measure(fraction, at, impl.Pass(fraction, impl.Options.Lower, dark[1], dark[0]),
      impl.Pass(fraction, impl.Options.Upper, bright[0], bright[1]));
  }
  return place;
}

std::vector<PenumbraEdge> PenumbraRuler::Along(const std::vector<Vector3>& line) const
{
  const Implementation& impl = *this->Impl;
  std::vector<PenumbraEdge> edges;
  if (line.size() < 2)
  {
    return edges;
  }
  const Way way(line);
  const auto at = [&way](double length) { return way.At(length); };
  const auto fraction = [&](double length) { return impl.Fraction(way.At(length), nullptr); };
  const int parts = impl.Options.SamplesPerLine;
  const double step = way.WholeLength() / parts;
  const double lower = impl.Options.Lower;
  const double upper = impl.Options.Upper;
  int last = -1; // the last place that was dark (Lower at most) or bright (Upper at least)
  bool wasDark = false;
  for (int k = 0; k <= parts; ++k)
  {
    const double value = fraction(k * step);
    if (value > lower && value < upper)
    {
      continue;
    }
    const bool isDark = value <= lower;
    if (last >= 0 && isDark != wasDark)
    {
      // It left one end right behind the last place, and comes to the other right before this one.
      const double leaving[2] = { last * step, (last + 1) * step };
      const double coming[2] = { (k - 1) * step, k * step };
      const double dark =
        wasDark ? impl.Pass(fraction, lower, leaving[0], leaving[1]) : impl.Pass(fraction, lower, coming[1], coming[0]);
      const double bright =
        wasDark ? impl.Pass(fraction, upper, coming[0], coming[1]) : impl.Pass(fraction, upper, leaving[1], leaving[0]);
      edges.push_back(impl.Measure(fraction, at, dark, bright));
    }
    last = k;
    wasDark = isDark;
  }
  return edges;
}

} // namespace shadowcones
