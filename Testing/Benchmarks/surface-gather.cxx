// SPDX-License-Identifier: BSD-3-Clause
// Final gather or not: light that has bounced, at surfaces that the camera sees in the chair's room.
//
//   direct   the photons around the point say its irradiance, what the image does; asked with those of a tile of 8 x 8 pixels
//   gather   N rays with the cosine's density read a map that has the light straight from the lamp too: the surfaces that they
//            meet by the 32 photons nearest there, for rays average noise, the medium on their way by discs of as many
//
// The truth is path tracing with a ray to the lamp at every vertex, in plain code. Errors are root mean squares over the mean, the
// noise of the truth taken off. Seconds are the processor's: to trace and prepare a map, and with that for so many points as
// an image of 256 x 256 pixels has.
#include "BenchmarkScene.h"
#include "ProgramOptions.h"
#include "scConstants.h"
#include "scFrame.h"
#include "scLightSampling.h"
#include "scPhotonEstimates.h"
#include "scPhotonMap.h"
#include "scRandom.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;

namespace
{
double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Place
{
  Vector3 Point;
  Vector3 Normal;
  double Irradiance = 0.0;
  double Variance = 0.0; ///< of that
};

Vector3 AboutCosine(const Vector3& normal, double u, double v)
{
  const Frame frame = FrameAround(normal);
  const double sine = std::sqrt(u);
  return Normalized(
    std::sqrt(1.0 - u) * normal + sine * std::cos(TwoPi * v) * frame.U + sine * std::sin(TwoPi * v) * frame.V);
}

Vector3 AnyDirection(double u, double v)
{
  const double sine = std::sqrt(std::max(0.0, 1.0 - (2.0 * u - 1.0) * (2.0 * u - 1.0)));
  return { sine * std::cos(TwoPi * v), sine * std::sin(TwoPi * v), 2.0 * u - 1.0 };
}

/// The room in grey light.
struct GreyRoom
{
  const OccluderScene& Fast;
  std::vector<Light> Lights;
  shadowcones::Medium Medium; ///< that absorbs nothing
  std::vector<float> Reflectance;

  struct Flight
  {
    RayInterval Inside; ///< the medium
    RayHit Hit;
    bool Meets = false;
    Vector3 Normal; ///< on the side of the ray
  };
  Flight Fly(const Ray& ray) const
  {
    Flight flight;
    flight.Meets = this->Fast.Intersect(ray.Origin, ray.Direction, 0.0, HUGE_VAL, flight.Hit);
    flight.Inside = { 0.0, flight.Meets ? flight.Hit.T : HUGE_VAL };
    if (!this->Medium.Bounds.Clip(ray.Origin, ray.Direction, flight.Inside.Begin, flight.Inside.End))
    {
      flight.Inside = {};
    }
    if (flight.Meets)
    {
      flight.Normal = (flight.Hit.FrontFacing ? 1.0 : -1.0) * this->Fast.TriangleNormal(flight.Hit.Triangle);
    }
    return flight;
  }
  double Passes(double length) const { return std::exp(-this->Medium.SigmaS.front() * length); }
  /// Light straight from the lamp through one of its points, times the cosine at a surface.
  double FromLamp(const Vector3& point, const Vector3* normal, RandomStream& random) const
  {
    const double u = random.Next();
    const IncidentSample sample = SampleIncidentLight(this->Lights.front(), point, u, random.Next());
    const double cosine = normal ? Dot(*normal, sample.Direction) : 1.0;
    if (!(sample.Weight > 0.0) || !(cosine > 0.0) ||
      this->Fast.Occluded(point, sample.Direction, 0.0, sample.Distance * (1.0 - 1e-9)))
    {
      return 0.0;
    }
    RayInterval inside{ 0.0, sample.Distance };
    const bool crosses = this->Medium.Bounds.Clip(point, sample.Direction, inside.Begin, inside.End);
    return sample.Weight * cosine * (crosses ? this->Passes(inside.End - inside.Begin) : 1.0);
  }
};

/// Irradiance by one path, of light that was turned before.
double ByPath(const GreyRoom& room, const Place& place, RandomStream& random)
{
  const double first = random.Next();
  Ray ray{ place.Point, AboutCosine(place.Normal, first, random.Next()) };
  double sum = 0.0;
  while (true)
  {
    const GreyRoom::Flight flight = room.Fly(ray);
    const double collision =
      flight.Inside.Begin - std::log(1.0 - random.Next()) / std::max(room.Medium.SigmaS.front(), 1e-300);
    if (!flight.Inside.Empty() && collision < flight.Inside.End)
    {
      ray.Origin = ray.Origin + collision * ray.Direction;
      sum += room.FromLamp(ray.Origin, nullptr, random) / FourPi;
      const double u = random.Next();
      ray.Direction = AnyDirection(u, random.Next());
      continue;
    }
    if (!flight.Meets)
    {
      return Pi * sum;
    }
    ray.Origin =
      ray.Origin + flight.Hit.T * ray.Direction + RoundingAlong(ray.Origin, flight.Hit.T) * flight.Normal;
    const double reflectance = static_cast<double>(room.Reflectance[static_cast<std::size_t>(flight.Hit.Triangle)]);
    sum += reflectance / Pi * room.FromLamp(ray.Origin, &flight.Normal, random);
    if (random.Next() >= reflectance)
    {
      return Pi * sum;
    }
    const double u = random.Next();
    ray.Direction = AboutCosine(flight.Normal, u, random.Next());
  }
}

/// With their irradiance.
std::vector<Place> VisiblePlaces(const GreyRoom& room, const Camera& camera, int count, int paths)
{
  std::vector<Place> places;
  for (std::uint64_t item = 0; places.size() < static_cast<std::size_t>(count); ++item)
  {
    RandomStream random(11, item);
    const double i = random.Next() - 0.5;
    const Ray ray = camera.PixelRay(i, random.Next() - 0.5, 1, 1);
    const GreyRoom::Flight flight = room.Fly(ray);
    if (!flight.Meets)
    {
      continue;
    }
    const double t = flight.Hit.T;
    Place place{ ray.Origin + t * ray.Direction + RoundingAlong(ray.Origin, t) * flight.Normal, flight.Normal };
    double squares = 0.0;
    for (int k = 0; k < paths; ++k)
    {
      const double value = ByPath(room, place, random);
      place.Irradiance += value / paths;
      squares += value * value / paths;
    }
    place.Variance = (squares - place.Irradiance * place.Irradiance) / paths;
    places.push_back(place);
  }
  return places;
}

/// For direct estimates, or for gathering, which needs the light straight from the lamp too. @param neighbours 0: automatic.
double PrepareMap(const GreyRoom& room, vtkIdType photons, bool gathers, int neighbours, PhotonEstimates& estimates)
{
  const double start = ProcessorSeconds();
  PhotonMapOptions options;
  options.NumberOfPhotons = photons;
  options.StoreDirect = gathers;
  options.SurfaceReflectance = room.Reflectance;
  PhotonMap map;
  TracePhotonMap({ room.Fast, room.Lights, room.Medium }, options, {}, map);
  PreparePhotonEstimates(std::move(map.Surface), std::move(map.Volume), neighbours, 1, {}, estimates);
  return ProcessorSeconds() - start;
}

class Gather
{
public:
  Gather(const GreyRoom& room, const PhotonEstimates& estimates)
    : Room(room)
    , Estimates(estimates)
    , InMedium(room.Medium)
  {
  }
  double At(const Place& place, int rays)
  {
    double sum = 0.0;
    const std::uint64_t seed = HashSeed(5, this->Asked++);
    for (int k = 0; k < rays; ++k)
    {
      const auto u = SobolPoint(seed, static_cast<std::uint32_t>(k));
      const Ray ray{ place.Point, AboutCosine(place.Normal, u[0], u[1]) };
      const GreyRoom::Flight flight = this->Room.Fly(ray);
      sum += this->OfMedium(ray, flight);
      if (flight.Meets)
      {
        this->OnSurface.Clear(); // one by one: they lie all over the room
        this->OnSurface.Add(ray.Origin + flight.Hit.T * ray.Direction, flight.Normal);
        this->Estimates.Surface.Estimate(this->OnSurface);
        sum += this->Room.Passes(flight.Inside.End - flight.Inside.Begin) * this->OnSurface.Irradiance(0, 0) / Pi *
          static_cast<double>(this->Room.Reflectance[static_cast<std::size_t>(flight.Hit.Triangle)]);
      }
    }
    return Pi * sum / rays;
  }

private:
  double OfMedium(const Ray& ray, const GreyRoom::Flight& flight)
  {
    if (this->Estimates.Volume.Empty() || flight.Inside.Empty())
    {
      return 0.0;
    }
    const bool ends = flight.Meets && flight.Inside.End >= flight.Hit.T;
    this->InMedium.Clear(this->Estimates.Volume.Origin());
    this->InMedium.Add({ ray, flight.Inside, ends ? flight.Normal : Vector3{} }, {});
    this->Estimates.Volume.Gather(this->InMedium);
    return this->InMedium.Radiance(0, 0);
  }

  const GreyRoom& Room;
  const PhotonEstimates& Estimates;
  DiscPacket InMedium;
  SurfacePacket OnSurface;
  std::uint64_t Asked = 0;
};

/// The irradiance at a place that is asked with those of a tile.
double InTile(const PhotonEstimates& estimates, const Place& place, SurfacePacket& packet)
{
  constexpr double pixel = 5.5 / 256.0;
  const Frame frame = FrameAround(place.Normal);
  packet.Clear();
  for (int k = 0; k < 64; ++k)
  {
    packet.Add(place.Point + pixel * (k % 8) * frame.U + pixel * (k / 8) * frame.V, place.Normal);
  }
  estimates.Surface.Estimate(packet);
  return packet.Irradiance(0, 0);
}

void PrintRow(const GreyRoom& room, vtkIdType photons, const std::string& name, double prepared,
  const std::vector<Place>& places, int together, const std::function<double(const Place&)>& estimate)
{
  double squares = 0.0;
  double difference = 0.0;
  double mean = 0.0;
  const double start = ProcessorSeconds();
  for (const Place& place : places)
  {
    const double error = estimate(place) - place.Irradiance;
    squares += error * error - place.Variance;
    difference += error;
    mean += place.Irradiance;
  }
  const auto count = static_cast<double>(places.size());
  const double each = (ProcessorSeconds() - start) / count / together;
  std::printf("| %g | %lld | %s | %.3f | %+.3f | %.2f | %.1f | %.1f |\n", room.Medium.SigmaS.front(),
    static_cast<long long>(photons), name.c_str(), std::sqrt(std::max(squares, 0.0) * count) / mean, difference / mean, prepared,
    1e6 * each, prepared + 65536.0 * each);
  std::fflush(stdout);
}

void PrintMedium(const GreyRoom& room, const Camera& camera, int count, int paths)
{
  const std::vector<Place> places = VisiblePlaces(room, camera, count, paths);
  double variance = 0.0;
  double mean = 0.0;
  for (const Place& place : places)
  {
    variance += place.Variance / count;
    mean += place.Irradiance / count;
  }
  std::fprintf(stderr, "SigmaS %g: noise of the truth %.3f\n", room.Medium.SigmaS.front(), std::sqrt(variance) / mean);
  for (const vtkIdType photons : { 10000, 100000, 1000000, 4000000 })
  {
    for (const int neighbours : { 0, 64, 256 })
    {
      PhotonEstimates indirect;
      const double seconds = PrepareMap(room, photons, false, neighbours, indirect);
      SurfacePacket packet;
      PrintRow(room, photons, neighbours > 0 ? "direct, k = " + std::to_string(neighbours) : "direct", seconds, places, 64,
        [&](const Place& place) { return InTile(indirect, place, packet); });
    }
    if (photons > 1000000)
    {
      continue;
    }
    PhotonEstimates all;
    const double secondsOfAll = PrepareMap(room, photons, true, 32, all);
    Gather gather(room, all);
    for (const int rays : { 16, 64, 256 })
    {
      PrintRow(room, photons, "gather of " + std::to_string(rays), secondsOfAll, places, 1,
        [&](const Place& place) { return gather.At(place, rays); });
    }
  }
}
} // anonymous namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Is a final gather worth its time? Light that has bounced, at surfaces of the chair's room");
  int count = 200;
  int paths = 8192;
  commandLine.AddPositive("--points", count, "of surfaces, which are compared with the truth");
  commandLine.AddPositive("--paths", paths, "of the truth for each of them");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    const BenchmarkScene scene("chair");
    const OccluderScene fast(scene.Room.View());
    GreyRoom room{ fast, { scene.Light }, scene.Medium, std::vector<float>(scene.Room.Triangles.size() / 3, 0.6f) };
    room.Lights.front().Spectrum = { 1.0 };
    room.Medium.SigmaA = { 0.0 };
    std::printf("| SigmaS | photons | estimate | error | mean difference | seconds of the map | us a point | seconds of a picture |\n"
                "|---|---|---|---|---|---|---|---|\n");
    for (const double sigma : { 0.0, 0.12 })
    {
      room.Medium.SigmaS = { sigma };
      PrintMedium(room, scene.Camera, count, paths);
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  return 0;
}
