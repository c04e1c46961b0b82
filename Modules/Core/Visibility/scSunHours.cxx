// SPDX-License-Identifier: BSD-3-Clause
#include "scSunHours.h"

#include "scBits.h"
#include "scFrame.h"
#include "scLight.h"
#include "scLightPatterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

namespace shadowcones
{
namespace
{
constexpr vtkIdType pointsPerBlock = 64; // dealt out to processes: near ones take about as long


/// Place of a direction along a Hilbert curve over the sphere: neighbours along it are neighbours on the sphere.
std::uint32_t HilbertPlace(const Vector3& direction)
{
  // The octahedral map onto a square, z downwards folded out to the corners.
  const double sum = std::fabs(direction.X) + std::fabs(direction.Y) + std::fabs(direction.Z);
  double u = direction.X / sum;
  double v = direction.Y / sum;
  if (direction.Z < 0.0)
  {
    const double folded = (1.0 - std::fabs(v)) * (u < 0.0 ? -1.0 : 1.0);
    v = (1.0 - std::fabs(u)) * (v < 0.0 ? -1.0 : 1.0);
    u = folded;
  }
  constexpr std::uint32_t side = 1u << 15;
  const auto cellOf = [](double w) { return std::min(side - 1, static_cast<std::uint32_t>(0.5 * (w + 1.0) * side)); };
  std::uint32_t x = cellOf(u);
  std::uint32_t y = cellOf(v);
  std::uint32_t place = 0;
  for (std::uint32_t half = side / 2; half > 0; half /= 2)
  {
    const std::uint32_t right = (x & half) ? 1 : 0;
    const std::uint32_t upper = (y & half) ? 1 : 0;
    place += half * half * ((3 * right) ^ upper);
    if (upper == 0)
    {
      x = right ? side - 1 - x : x;
      y = right ? side - 1 - y : y;
      std::swap(x, y);
    }
  }
  return place;
}

/// Directions that lie all within an angle of an axis.
struct Bundle
{
  /// Rounding of directions, and what decides on rays at the edges of triangles.
  static constexpr double Margin = 1e-6;
  static constexpr double Widest = 1.0; // radians

  Vector3 Axis;
  double Sine = 2.0; ///< of the angle and a margin; above 1: too wide

  void SetAngle(double angle) { this->Sine = angle < Widest ? std::sin(angle + Margin) : 2.0; }
};

/// Up to 64 vectors to the Sun, as OccluderScene::OccludedFrom takes them.
struct RayBlock
{
  Bundle Around;
  std::array<double, 64> X{};
  std::array<double, 64> Y{};
  std::array<double, 64> Z{};
  std::uint64_t Used = 0;

  void Set(int k, const Vector3& direction)
  {
    this->X[k] = direction.X;
    this->Y[k] = direction.Y;
    this->Z[k] = direction.Z;
  }
  Vector3 Direction(int k) const { return { this->X[k], this->Y[k], this->Z[k] }; }
  /// Find what bundle the used ones make.
  void Bound()
  {
    Vector3 sum;
    for (int k = 0; k < 64; ++k)
    {
      sum += this->Direction(k); // others are 0
    }
    this->Around.Axis = Normalized(sum);
    double angle = 0.0;
    for (std::uint64_t rest = this->Used; rest; rest &= rest - 1)
    {
      const Vector3 direction = this->Direction(LowestBit(rest));
      angle =
        std::max(angle, std::atan2(Length(Cross(this->Around.Axis, direction)), Dot(this->Around.Axis, direction)));
    }
    this->Around.SetAngle(angle);
  }
  /// Those of @p rays that come from above a surface, or from higher above it by the sine of an angle.
  std::uint64_t Above(const Vector3& normal, std::uint64_t rays, double sine = 0.0) const
  {
    for (int k = 0; k < 64; ++k)
    {
      const std::uint64_t below = Dot(this->Direction(k), normal) > sine ? 0 : 1;
      rays &= ~(below << k);
    }
    return rays;
  }
};

/// What one point needs; kept from point to point.
struct Scratch
{
  std::vector<double> Shares; ///< visible share of the disc at each step
  LightView View;
  RayBlock Block;
  vtkIdType Cover = -1; ///< a triangle that hid all of a bundle, and may hide the next one
  std::vector<RayHit> Hits;
  std::vector<double> Taken; ///< hours that each occluder takes away
  std::vector<int> Takers;   ///< occluders that took some
  std::vector<int> OnRay;
};

/// A point, and what its own surface hides.
struct Sensor
{
  Vector3 Place;
  Vector3 Normal; ///< unit; 0: none
  bool HasNormal = false;
  RayRules Rules;
};

/**
 * Does a triangle lie before all of a bundle, beyond doubt? The directions in which it is seen are those on the inner
 * sides of three planes, each through the sensor and an edge; a bundle is before it where it keeps its angle from all three.
 */
bool Covers(const Sensor& sensor, const Bundle& bundle, const Vector3& a, const Vector3& b, const Vector3& c)
{
  constexpr double rounding = 1e-9;
  const Vector3 normal = Cross(b - a, c - a);
  const double volume = Dot(normal, a);
  const double farthest = std::max({ Length(a), Length(b), Length(c) });
  const double doubt = sensor.Rules.StartTolerance + rounding * (farthest + Length(sensor.Place));
  const double side = volume > 0.0 ? 1.0 : -1.0;
  const auto isInside = [&bundle, side](const Vector3& from, const Vector3& to)
  {
    const Vector3 edge = Cross(from, to);
    return side * Dot(edge, bundle.Axis) > Length(edge) * bundle.Sine + rounding * Length(from) * Length(to);
  };
  return std::fabs(volume) > Length(normal) * doubt && isInside(a, b) && isInside(b, c) && isInside(c, a);
}

class SunHoursWorker
{
public:
  SunHoursWorker(const OccluderScene& scene, const std::vector<SunStep>& steps, const SunHoursOptions& options)
    : Scene(scene)
    , Steps(steps)
    , Options(options)
  {
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      if (steps[i].IsUp)
      {
        this->Order.push_back(i);
      }
    }
    const TriangleMeshView& mesh = scene.Mesh();
    for (vtkIdType t = 0; options.FindOccluders && t < mesh.NumberOfTriangles; ++t)
    {
      this->NumberOfOccluders = std::max(this->NumberOfOccluders, mesh.OccluderId(t) + 1);
    }
    if (options.AngularRadius > 0.0)
    {
      // Looked at along z; each step turns it to where the Sun is.
      Light sun;
      sun.Shape = LightShape::Sun;
      sun.Normal = { 0.0, 0.0, -1.0 };
      sun.Radius = options.AngularRadius;
      this->Disc = std::make_unique<const LightPatterns>(sun, options.NumberOfLightSamples, options.Seed);
      this->DiscBundle.SetAngle(options.AngularRadius);
    }
    else
    {
      this->MakeBlocks();
    }
  }

  void Ask(vtkIdType i, const double* point, const double* normal, SunHoursResult& result) const
  {
    thread_local Scratch scratch;
    Sensor sensor;
    sensor.Place = { point[0], point[1], point[2] };
    sensor.Normal = normal ? Normalized({ normal[0], normal[1], normal[2] }) : Vector3();
    sensor.HasNormal = Dot(sensor.Normal, sensor.Normal) > 0.0;
    sensor.Rules.StartTolerance = this->Scene.SurfaceTolerance(sensor.Place);
    scratch.Cover = -1;
    scratch.Shares.assign(this->Steps.size(), 0.0);
    scratch.Taken.resize(static_cast<std::size_t>(this->NumberOfOccluders), 0.0);
    if (this->Disc)
    {
      this->AskDisc(sensor, scratch);
    }
    else
    {
      this->AskRays(sensor, scratch);
    }
    this->Sum(i, scratch.Shares, result);
    if (this->Options.FindOccluders)
    {
      result.OccluderIds[static_cast<std::size_t>(i)] = TakeMain(scratch);
    }
  }

private:
  /// The directions of all steps in blocks, neighbours side by side.
  void MakeBlocks()
  {
    std::vector<std::uint32_t> places(this->Steps.size(), 0);
    for (const std::size_t step : this->Order)
    {
      places[step] = HilbertPlace(this->Steps[step].Direction);
    }
    std::stable_sort(this->Order.begin(), this->Order.end(),
      [&places](std::size_t a, std::size_t b) { return places[a] < places[b]; });
    this->Blocks.resize((this->Order.size() + 63) / 64);
    for (std::size_t k = 0; k < this->Order.size(); ++k)
    {
      RayBlock& block = this->Blocks[k / 64];
      block.Set(static_cast<int>(k % 64), this->Steps[this->Order[k]].Direction);
      block.Used |= std::uint64_t(1) << (k % 64);
    }
    for (RayBlock& block : this->Blocks)
    {
      block.Bound();
    }
  }

  void AskRays(const Sensor& sensor, Scratch& scratch) const
  {
    for (std::size_t b = 0; b < this->Blocks.size(); ++b)
    {
      const RayBlock& block = this->Blocks[b];
      const std::uint64_t wanted = sensor.HasNormal ? block.Above(sensor.Normal, block.Used) : block.Used;
      const std::uint64_t hidden = this->Hidden(sensor, block, wanted, scratch);
      for (std::uint64_t rest = wanted & ~hidden; rest; rest &= rest - 1)
      {
        scratch.Shares[this->Order[64 * b + static_cast<std::size_t>(LowestBit(rest))]] = 1.0;
      }
      for (std::uint64_t rest = this->Options.FindOccluders ? hidden : 0; rest; rest &= rest - 1)
      {
        const int k = LowestBit(rest);
        const double hours = this->Steps[this->Order[64 * b + static_cast<std::size_t>(k)]].Length;
        this->AddTakers(sensor, block.Direction(k), hours, scratch);
      }
    }
  }

  void AskDisc(const Sensor& sensor, Scratch& scratch) const
  {
    const double reach = std::sin(this->Options.AngularRadius);
    this->Disc->LookFrom(sensor.Place, scratch.View);
    for (const std::size_t i : this->Order)
    {
      const SunStep& step = this->Steps[i];
      const double height = sensor.HasNormal ? Dot(sensor.Normal, step.Direction) : 1.0;
      if (height > -reach)
      {
        scratch.Shares[i] = this->ShareOf(sensor, step, height < reach, scratch);
      }
    }
  }

  /// The visible share of the Sun's disc; @p cut: some of it may be below the sensor's own surface.
  double ShareOf(const Sensor& sensor, const SunStep& step, bool cut, Scratch& scratch) const
  {
    const Frame frame = FrameAround(step.Direction);
    // Some of the disc may be below the horizon.
    const bool low = Dot(this->Options.Up, this->Options.Up) > 0.0 &&
      std::asin(std::clamp(Dot(this->Options.Up, step.Direction), -1.0, 1.0)) <
        this->Options.LowestAltitude + this->Options.AngularRadius;
    const int count = this->Disc->Count();
    const double weight = step.Length / count;
    int visible = 0;
    RayBlock& block = scratch.Block;
    block.Around = this->DiscBundle;
    block.Around.Axis = step.Direction;
    for (int first = 0; first < count; first += 64)
    {
      const double* x = scratch.View.X.data() + first;
      const double* y = scratch.View.Y.data() + first;
      const double* z = scratch.View.Z.data() + first;
      for (int k = 0; k < 64; ++k)
      {
        block.X[k] = x[k] * frame.U.X + y[k] * frame.V.X + z[k] * step.Direction.X;
        block.Y[k] = x[k] * frame.U.Y + y[k] * frame.V.Y + z[k] * step.Direction.Y;
        block.Z[k] = x[k] * frame.U.Z + y[k] * frame.V.Z + z[k] * step.Direction.Z;
      }
      const std::uint64_t open = scratch.View.Open[static_cast<std::size_t>(first / 64)];
      std::uint64_t wanted = cut && sensor.HasNormal ? block.Above(sensor.Normal, open) : open;
      wanted = low ? block.Above(this->Options.Up, wanted, std::sin(this->Options.LowestAltitude)) : wanted;
      const std::uint64_t hidden = this->Hidden(sensor, block, wanted, scratch);
      visible += CountBits(wanted & ~hidden);
      for (std::uint64_t rest = this->Options.FindOccluders ? hidden : 0; rest; rest &= rest - 1)
      {
        this->AddTakers(sensor, block.Direction(LowestBit(rest)), weight, scratch);
      }
    }
    return static_cast<double>(visible) / count;
  }

  std::uint64_t Hidden(const Sensor& sensor, const RayBlock& block, std::uint64_t wanted, Scratch& scratch) const
  {
    const TriangleMeshView& mesh = this->Scene.Mesh();
    const auto corner = [&](int k) { return mesh.Corner(scratch.Cover, k) - sensor.Place; };
    if (wanted == 0 || (scratch.Cover >= 0 && Covers(sensor, block.Around, corner(0), corner(1), corner(2))))
    {
      return wanted;
    }
    const std::uint64_t hidden = this->Scene.OccludedFrom(
      sensor.Place, block.X.data(), block.Y.data(), block.Z.data(), wanted, true, sensor.Rules);
    RayHit hit;
    if (hidden == wanted && this->Scene.Intersect(sensor.Place, block.Around.Axis, 0.0, HUGE_VAL, hit, sensor.Rules))
    {
      scratch.Cover = hit.Triangle;
    }
    return hidden;
  }

  /// Note the hours for every occluder on a ray, once each.
  void AddTakers(const Sensor& sensor, const Vector3& direction, double hours, Scratch& scratch) const
  {
    this->Scene.IntersectAll(sensor.Place, direction, 0.0, HUGE_VAL, scratch.Hits, sensor.Rules);
    scratch.OnRay.clear();
    for (const RayHit& hit : scratch.Hits)
    {
      scratch.OnRay.push_back(this->Scene.Mesh().OccluderId(hit.Triangle));
    }
    std::sort(scratch.OnRay.begin(), scratch.OnRay.end());
    scratch.OnRay.erase(std::unique(scratch.OnRay.begin(), scratch.OnRay.end()), scratch.OnRay.end());
    for (const int id : scratch.OnRay)
    {
      double& taken = scratch.Taken[static_cast<std::size_t>(id)];
      if (taken == 0.0)
      {
        scratch.Takers.push_back(id);
      }
      taken += hours;
    }
  }

  /// The occluder that takes most, the smallest of several; forgets all of them.
  static int TakeMain(Scratch& scratch)
  {
    // Sums of the same hours in another order are the same hours.
    constexpr double rounding = 1e-9;
    double most = 0.0;
    for (const int id : scratch.Takers)
    {
      most = std::max(most, scratch.Taken[static_cast<std::size_t>(id)]);
    }
    int main = -1;
    for (const int id : scratch.Takers)
    {
      double& taken = scratch.Taken[static_cast<std::size_t>(id)];
      main = taken >= (1.0 - rounding) * most && (main < 0 || id < main) ? id : main;
      taken = 0.0;
    }
    scratch.Takers.clear();
    return main;
  }

  /// What comes out of the shares at all steps, in the order of time.
  void Sum(vtkIdType i, const std::vector<double>& shares, SunHoursResult& result) const
  {
    double hours = 0.0;
    double first = -1.0;
    double last = -1.0;
    double run = 0.0;
    double longest = 0.0;
    double error = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k)
    {
      const SunStep& step = this->Steps[k];
      const double share = shares[k];
      hours += share * step.Length;
      run = share > 0.0 ? run + share * step.Length : 0.0;
      longest = std::max(longest, run);
      if (share > 0.0)
      {
        first = first < 0.0 ? step.Begin : first;
        last = step.Begin + step.Length;
      }
      if (k > 0)
      {
        error += 0.5 * std::fabs(share - shares[k - 1]) * std::max(step.Length, this->Steps[k - 1].Length);
      }
    }
    const auto at = static_cast<std::size_t>(i);
    result.Hours[at] = static_cast<float>(hours);
    result.First[at] = static_cast<float>(first);
    result.Last[at] = static_cast<float>(last);
    result.Longest[at] = static_cast<float>(longest);
    result.Errors[at] = static_cast<float>(error);
  }

  const OccluderScene& Scene;
  const std::vector<SunStep>& Steps;
  const SunHoursOptions& Options;
  std::vector<std::size_t> Order; ///< steps with the Sun up
  std::vector<RayBlock> Blocks;   ///< of a hard Sun, the steps in Order
  std::unique_ptr<const LightPatterns> Disc;
  Bundle DiscBundle; ///< but for its axis
  int NumberOfOccluders = 0;
};

} // anonymous namespace

bool ComputeSunHours(const OccluderScene& scene, const std::vector<SunStep>& steps, const double* points,
  const double* normals, vtkIdType count, const SunHoursOptions& options, const Monitor& monitor,
  SunHoursResult& result)
{
  const auto size = static_cast<std::size_t>(count);
  for (std::vector<float>* values : { &result.Hours, &result.First, &result.Last, &result.Longest, &result.Errors })
  {
    values->resize(size);
  }
  result.OccluderIds.assign(options.FindOccluders ? size : 0, -1);
  const SunHoursWorker worker(scene, steps, options);
  const TeamShare share(options.Workers, count, pointsPerBlock);
  TeamJoin join(options.Workers);
  for (std::vector<float>* values : { &result.Hours, &result.First, &result.Last, &result.Longest, &result.Errors })
  {
    join.AddItems(*values, share);
  }
  join.AddItems(result.OccluderIds, share);
  return TeamFor(options.Workers, join, share, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        worker.Ask(i, points + 3 * i, normals ? normals + 3 * i : nullptr, result);
      }
    });
}

} // namespace shadowcones
