// SPDX-License-Identifier: BSD-3-Clause
#include "scLightLegsChoice.h"

#include "scGaussLegendre.h"
#include "scLitVariable.h"
#include "scMediumOpticalDepth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace shadowcones
{
namespace
{
/// Tables have this many cells of the density from point to point, coarse ones first.
constexpr double cellsOfTables[] = { 4.0, 2.0, 1.0, 0.5 };
/// No table has more places, and none so many that filling it costs more than the pixels' own integrals.
constexpr std::int64_t mostPlaces = std::int64_t(1) << 18;
constexpr double placesOfPixel = 64.0;
/// Rays by rays that are looked at, places on each, and of the light's points as seen from a place every so manieth.
constexpr int raySide = 8;
constexpr int placesOfRay = 32;
constexpr int pointsLeftOut = 4;
/// Rays with less than this share of the mean light count as if they had it.
constexpr double darkest = 0.1;
/// The worst of the rays errs by no more than so many standard errors.
constexpr double worstOverError = 3.0;

/// A place on a ray and a point of the light, and what is known of the way between them.
struct Leg
{
  Vector3 Direction;
  double Distance = 0.0;
  double Depth = 0.0;
  double Light = 0.0; ///< that comes this way, attenuated
};
struct Look
{
  int Ray = 0;
  Vector3 Point;
  std::vector<Leg> Legs;
};

/// The light of the whole ray as from few places, by integrals.
void LookAlong(const LitQuadrature& quadrature, const Ray& ray, double sigmaT, int number, std::vector<Look>& looks)
{
  const LitInterval interval = quadrature.Intervals.Find(ray);
  if (interval.Empty())
  {
    return;
  }
  MediumOpticalDepth depth(quadrature.Air);
  depth.SetRay(ray.Origin, ray.Direction, interval.MediumBegin, interval.End);
  const LitVariable variable(quadrature, ray, interval, &depth);
  static const GaussLegendre rule(placesOfRay);
  double before = interval.Begin;
  double share = 0.0;
  for (std::size_t k = 0; k < placesOfRay; ++k)
  {
    // Each place stands for the density of its part of the ray.
    share += rule.Weights[k];
    const double after = variable.DistanceAt(LitProfileLayout::Cells * std::min(share, 1.0));
    const double t = variable.DistanceAt(LitProfileLayout::Cells * rule.Nodes[k]);
    const double passed = depth.Along(after) - depth.Along(before);
    before = after;
    if (!(passed > 0.0))
    {
      continue;
    }
    Look look{ number, ray.Origin + t * ray.Direction, {} };
    int point = 0;
    quadrature.Rules.front().ForEach(look.Point,
      [&](const IncidentSample& sample)
      {
        if ((point++ - static_cast<int>(k)) % pointsLeftOut != 0)
        {
          return; // these are looked at from other places
        }
        Leg leg{ sample.Direction, sample.Distance,
          depth.Towards(look.Point, sample.Direction, sample.Distance), 0.0 };
        const double scattered =
          sample.Weight * EvaluatePhaseFunction(quadrature.Air.Phase, Dot(sample.Direction, ray.Direction));
        leg.Light = passed * scattered * TransmittanceOver(sigmaT, depth.Along(t) + leg.Depth);
        look.Legs.push_back(leg);
      });
    looks.push_back(std::move(look));
  }
}

void LookAround(const LitQuadrature& quadrature, const Camera& camera, const ScatteringOptions& options, double sigmaT,
  std::vector<Look>& looks)
{
  const int width = options.Width;
  const int height = options.Height;
  for (int k = 0; k < raySide * raySide; ++k)
  {
    const double i = (k % raySide + 0.5) * width / raySide;
    const double j = (k / raySide + 0.5) * height / raySide;
    LookAlong(quadrature, camera.PixelRay(i, j, width, height), sigmaT, k, looks);
  }
}

/// Measure what a table errs by.
void Measure(const std::vector<Look>& looks, double sigmaT, LightLegs& table)
{
  std::vector<double> light(raySide * raySide, 0.0);
  std::vector<double> errors(light.size(), 0.0);
  double all = 0.0;
  double squares = 0.0;
  LightLegs::Place place;
  for (const Look& look : looks)
  {
    table.LookAt(look.Point, place);
    for (const Leg& leg : look.Legs)
    {
      const double depth = table.Towards(place, leg.Direction, leg.Distance);
      const double error = std::expm1(sigmaT * (leg.Depth - depth));
      light[static_cast<std::size_t>(look.Ray)] += leg.Light;
      errors[static_cast<std::size_t>(look.Ray)] += leg.Light * error;
      all += leg.Light;
      squares += leg.Light * error * error;
    }
  }
  const double mean = all / static_cast<double>(light.size());
  double sum = 0.0;
  double worst = 0.0;
  for (std::size_t ray = 0; ray < light.size(); ++ray)
  {
    const double error = mean > 0.0 ? errors[ray] / std::max(light[ray], darkest * mean) : 0.0;
    sum += error * error;
    worst = std::max(worst, std::fabs(error));
  }
  table.ErrorOfRays = std::max(std::sqrt(sum / static_cast<double>(light.size())), worst / worstOverError);
  table.ErrorOfLegs = all > 0.0 ? std::sqrt(squares / all) : 0.0;
}

/// Where optical depths count most.
double LargestSigmaT(const ExtinctionGroups& groups)
{
  double largest = 0.0;
  for (std::size_t g = 0; g < groups.SigmaT.size(); ++g)
  {
    largest = groups.MeanScatteredRadiance[g] > 0.0 ? std::max(largest, groups.SigmaT[g]) : largest;
  }
  return largest;
}
} // anonymous namespace

std::unique_ptr<const LightLegs> ChooseLightLegs(const LitQuadrature& quadrature, const Camera& camera,
  const ScatteringOptions& options, const LightLegsTolerance& tolerance, const Monitor& monitor)
{
  const DensityGrid* density = quadrature.Air.Density;
  if (!density || density->Support.Empty() || !LightLegs::Fit(quadrature.Lamp))
  {
    return nullptr;
  }
  const double pixels = static_cast<double>(options.Width) * options.Height;
  const double sigmaT = LargestSigmaT(quadrature.Groups);
  std::vector<Look> looks;
  double tried = 0.0;
  for (const double cells : cellsOfTables)
  {
    const double share = 1.0 / static_cast<double>(std::size(cellsOfTables));
    const Monitor part = monitor.Part(share * tried, share * (tried + 1.0));
    tried += 1.0;
    auto table = std::make_unique<LightLegs>(quadrature.Lamp, quadrature.Air, cells);
    const std::int64_t places = table->NumberOfPlaces();
    if (places > mostPlaces || static_cast<double>(places) > placesOfPixel * pixels || !table->Fill(part))
    {
      return nullptr;
    }
    if (looks.empty())
    {
      LookAround(quadrature, camera, options, sigmaT, looks);
    }
    Measure(looks, sigmaT, *table);
    if (table->ErrorOfRays <= tolerance.OfRays && table->ErrorOfLegs <= tolerance.OfLegs)
    {
      return table;
    }
  }
  return nullptr;
}

} // namespace shadowcones
