// SPDX-License-Identifier: BSD-3-Clause
// Which estimate of multiple scattering to take: discs that a ray pierces, nearest photons at steps along it, or the flights of
// photons as beams that a ray passes.
//
// A point source in an infinite medium that scatters alike into all directions, of which the exact light is known
// (Testing/Support/PointSource.h). Rays pass the source at 0.1 to 3 mean free paths. The error is the root mean square of
// what is found less the exact value, over the mean exact value; times are of one thread and of a ray. Discs are asked by a ray
// alone, and by the 64 of a tile of an image of 512 pixels a side together.
#include "PointSource.h"
#include "ProgramOptions.h"
#include "TestLights.h"
#include "scPhotonEstimates.h"
#include "scPhotonMap.h"
#include "scPointTree.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

constexpr double reach = 6.0; // rays run from -reach to reach, in mean free paths
constexpr double fourPi = 4.0 * Pi;

struct LookedAt
{
  Ray Line;
  double Exact = 0.0; ///< radiance of light that has been scattered before
};

std::vector<LookedAt> RaysPastSource(double albedo)
{
  std::vector<LookedAt> rays;
  constexpr int offsets = 16;
  constexpr int turns = 24;
  for (int i = 0; i < offsets; ++i)
  {
    const double offset = 0.1 * std::pow(30.0, i / (offsets - 1.0));
    double exact = 0.0;
    const int steps = 600;
    for (int k = 0; k < steps; ++k)
    {
      const double z = reach * (2.0 * (k + 0.5) / steps - 1.0);
      const double r = std::hypot(offset, z);
      const double scattered = ExactFluence(albedo, r) - std::exp(-r) / (fourPi * r * r);
      exact += std::exp(-(z + reach)) * albedo / fourPi * scattered * 2.0 * reach / steps;
    }
    for (int turn = 0; turn < turns; ++turn)
    {
      const double angle = 2.0 * Pi * (turn + 0.37 * i) / turns;
      rays.push_back({ { { offset * std::cos(angle), offset * std::sin(angle), -reach }, { 0.0, 0.0, 1.0 } }, exact });
    }
  }
  return rays;
}

/// What one estimate found, over all maps.
struct Figures
{
  double Squares = 0.0;
  double Difference = 0.0;
  double Seconds = 0.0;
  int Rays = 0;
  int RaysOfTile = 1;
};
using Table = std::map<std::pair<std::string, int>, Figures>;

void Measure(Figures& figures, const std::vector<LookedAt>& rays, const std::function<double(const Ray&)>& estimate)
{
  const auto start = std::chrono::steady_clock::now();
  for (const LookedAt& ray : rays)
  {
    const double difference = estimate(ray.Line) - ray.Exact;
    figures.Squares += difference * difference;
    figures.Difference += difference;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  figures.Seconds += seconds.count();
  figures.Rays += static_cast<int>(rays.size());
}

Medium MediumOf(double albedo)
{
  Medium medium;
  medium.SigmaS = { albedo };
  medium.SigmaA = { 1.0 - albedo };
  medium.Bounds = { { -200.0, -200.0, -200.0 }, { 200.0, 200.0, 200.0 } };
  return medium;
}

/// The rays of a tile of so many pixels a side, of which the first is asked for.
double ByDiscs(const PhotonDiscs& discs, DiscPacket& packet, int side, const Ray& ray)
{
  packet.Clear(discs.Origin());
  const double pixel = 2.0 * reach / 512.0;
  for (int k = 0; k < side * side; ++k)
  {
    const Vector3 moved{ pixel * (k % side), pixel * (k / side), 0.0 };
    packet.Add({ { ray.Origin + moved, ray.Direction }, { 0.0, 2.0 * reach }, -ray.Direction }, {});
  }
  discs.Gather(packet);
  return packet.Radiance(0, 0);
}

/// Flights between two scatterings: consecutive photons of one path, the first of which may be straight from the source.
struct Beam
{
  Vector3 From;
  Vector3 Along;
  double Length;
  double Power;
};

std::vector<Beam> BeamsOf(const StoredPhotons& photons, double albedo)
{
  std::vector<Beam> beams;
  for (vtkIdType id = 1; id < photons.Count(); ++id)
  {
    const auto k = static_cast<std::size_t>(id);
    if (photons.Bounces[k] == photons.Bounces[k - 1] + 1)
    {
      const Vector3 way = photons.Point(id) - photons.Point(id - 1);
      beams.push_back({ photons.Point(id - 1), photons.Direction(id), Length(way),
        static_cast<double>(*photons.Power(id)) / albedo });
    }
  }
  return beams;
}

/// Jarosz et al., "A Comprehensive Theory of Volumetric Radiance Estimation Using Photon Points and Beams" (2011): beam by ray,
/// blurred along the line that is across both, with a kernel of one radius. Plain: every ray looks at every beam.
double ByBeams(const std::vector<Beam>& beams, double radius, double albedo, const Ray& ray, double& met)
{
  double sum = 0.0;
  for (const Beam& beam : beams)
  {
    const Vector3 across = Cross(beam.Along, ray.Direction);
    const double sine = Length(across);
    const Vector3 to = beam.From - ray.Origin;
    const double distance = sine > 0.0 ? std::fabs(Dot(to, across)) / sine : HUGE_VAL;
    if (distance >= radius)
    {
      continue;
    }
    const double cosine = Dot(beam.Along, ray.Direction);
    const double u = (cosine * Dot(to, ray.Direction) - Dot(to, beam.Along)) / (sine * sine); // along the beam
    const double t = Dot(to, ray.Direction) + u * cosine;
    if (u > 0.0 && u < beam.Length && t > 0.0 && t < 2.0 * reach)
    {
      const double rest = 1.0 - distance * distance / (radius * radius);
      sum += beam.Power * albedo / fourPi * std::exp(-t) * 15.0 / 16.0 / radius * rest * rest / sine;
      met += 1.0;
    }
  }
  return sum;
}

double ByMarch(const StoredPhotons& photons, const PointTree& tree, int neighbours, int steps, const Ray& ray)
{
  std::vector<vtkIdType> found;
  std::vector<double> squared;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const double t = 2.0 * reach * (k + 0.5) / steps;
    tree.NearestTo(ray.Origin + t * ray.Direction, neighbours, found, squared);
    double power = 0.0;
    for (std::size_t i = 0; i + 1 < found.size(); ++i) // the last one marks the ball's border
    {
      power += static_cast<double>(*photons.Power(found[i]));
    }
    const double radius = std::sqrt(squared.back());
    sum += std::exp(-t) * power / (fourPi / 3.0 * radius * radius * radius) / fourPi * 2.0 * reach / steps;
  }
  return sum;
}

/// Photons without those straight from the source.
StoredPhotons Indirect(const StoredPhotons& all)
{
  StoredPhotons photons;
  photons.NumberOfWavelengths = 1;
  for (vtkIdType id = 0; id < all.Count(); ++id)
  {
    if (all.Bounces[static_cast<std::size_t>(id)] > 0)
    {
      const Vector3 point = all.Point(id);
      const float* direction = all.Directions.data() + 3 * id;
      photons.Points.insert(photons.Points.end(), { point.X, point.Y, point.Z });
      photons.Directions.insert(photons.Directions.end(), direction, direction + 3);
      photons.Powers.push_back(*all.Power(id));
      photons.Bounces.push_back(all.Bounces[static_cast<std::size_t>(id)]);
    }
  }
  return photons;
}

void MeasureBeams(const StoredPhotons& all, double albedo, const std::vector<LookedAt>& rays, Table& table)
{
  const std::vector<Beam> beams = BeamsOf(all, albedo);
  for (const double radius : { 0.05, 0.1, 0.2, 0.4 })
  {
    double met = 0.0;
    Measure(table[{ "beams, thousandths of radius", static_cast<int>(1000.0 * radius) }], rays,
      [&](const Ray& ray) { return ByBeams(beams, radius, albedo, ray, met); });
    std::fprintf(stderr, "radius %g: a ray meets %.0f of %zu beams\n", radius, met / static_cast<double>(rays.size()), beams.size());
  }
}

void MeasureMap(const StoredPhotons& photons, double albedo, const std::vector<LookedAt>& rays, Table& table)
{
  const Medium medium = MediumOf(albedo);
  DiscPacket packet(medium);
  for (const int neighbours : { 16, 32, 64, 128, 256, 512 })
  {
    PhotonDiscs discs;
    discs.Build(photons, neighbours, {});
    Measure(table[{ "discs", neighbours }], rays, [&](const Ray& ray) { return ByDiscs(discs, packet, 1, ray); });
    Figures& tiles = table[{ "discs, in tiles", neighbours }];
    Measure(tiles, rays, [&](const Ray& ray) { return ByDiscs(discs, packet, 8, ray); });
    tiles.RaysOfTile = 64;
  }
  Box bounds;
  for (vtkIdType id = 0; id < photons.Count(); ++id)
  {
    bounds.Add(photons.Point(id));
  }
  const PointTree tree(bounds, photons.Count(), [&](vtkIdType id) { return photons.Point(id); });
  for (const int steps : { 16, 64 })
  {
    for (const int neighbours : { 16, 64, 256 })
    {
      Measure(table[{ "march of " + std::to_string(steps) + " steps", neighbours }], rays,
        [&](const Ray& ray) { return ByMarch(photons, tree, neighbours, steps, ray); });
    }
  }
}
} // anonymous namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Estimates of multiple scattering against the exact light around a point source");
  vtkIdType count = 50000;
  double albedo = 0.9;
  int maps = 4;
  commandLine.Add("--photons", count, "photons to emit for a map");
  commandLine.Add("--albedo", albedo, "albedo of the medium");
  commandLine.Add("--maps", maps, "maps of other seeds");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }

  const Medium medium = MediumOf(albedo);
  const std::vector<Light> lights = { PointLight({}, { 1.0 / fourPi }) };
  const OccluderScene scene{ TriangleMeshView{} };
  const std::vector<LookedAt> rays = RaysPastSource(albedo);
  double mean = 0.0;
  for (const LookedAt& ray : rays)
  {
    mean += ray.Exact / static_cast<double>(rays.size());
  }
  Table table;
  for (int seed = 1; seed <= maps; ++seed)
  {
    PhotonMapOptions options;
    options.NumberOfPhotons = count;
    options.Seed = static_cast<std::uint64_t>(seed);
    options.StoreDirect = true;
    PhotonMap map;
    TracePhotonMap({ scene, lights, medium }, options, {}, map);
    MeasureBeams(map.Volume, albedo, rays, table);
    MeasureMap(Indirect(map.Volume), albedo, rays, table);
  }
  std::printf("%d maps of %lld photons, albedo %g\n\n| estimate | neighbours | error | mean difference | us a ray |\n"
              "|---|---|---|---|---|\n",
    maps, static_cast<long long>(count), albedo);
  for (const auto& [key, figures] : table)
  {
    std::printf("| %s | %d | %.4f | %+.4f | %.0f |\n", key.first.c_str(), key.second,
      std::sqrt(figures.Squares / figures.Rays) / mean, figures.Difference / figures.Rays / mean,
      1e6 * figures.Seconds / figures.Rays / figures.RaysOfTile);
  }
  return 0;
}
