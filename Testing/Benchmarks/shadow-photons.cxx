// SPDX-License-Identifier: BSD-3-Clause
// Shadow photons on surfaces (Jensen and Christensen, "Efficiently Rendering Shadows Using the Photon Map", 1995), next to cones.
//
// A path from the lamp leaves a direct photon where it first meets a surface, and a shadow photon wherever it goes on through
// others. Where the k photons nearest to a point are all direct it is taken as lit, where all are shadow photons as hidden, and no
// ray is sent; elsewhere all rays are. With cones a point outside all of them is lit, and others send all rays.
//
// Points are those that random rays of the camera meet, with a point of the lamp in each of 16 strata. Rays are counted where
// surface and lamp face each other; the truth is the rays. Times are of one thread's processor, a point: to decide, and to
// send the rays that are left.
#include "BenchmarkScene.h"
#include "ProgramOptions.h"
#include "ProofScenes.h"
#include "scBox.h"
#include "scConstants.h"
#include "scFrame.h"
#include "scLightSampling.h"
#include "scPointTree.h"
#include "scRandom.h"

#include "vtkObject.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;

namespace
{
enum class Answer
{
  Ask,
  Lit,
  Hidden
};

struct Place
{
  Vector3 Point;
  std::vector<std::pair<Vector3, double>> Rays; ///< directions and distances to the lamp
  std::uint64_t Lit = 0;                        ///< bit k: ray k arrives
};

std::uint64_t SendRays(const OccluderScene& scene, const Place& place)
{
  std::uint64_t lit = 0;
  for (std::size_t k = 0; k < place.Rays.size(); ++k)
  {
    const auto& [direction, distance] = place.Rays[k];
    lit |= std::uint64_t(!scene.Occluded(place.Point, direction, 0.0, distance)) << k;
  }
  return lit;
}

std::vector<Place> VisiblePlaces(const BenchmarkScene& scene, const OccluderScene& room, int count)
{
  std::vector<Place> places;
  for (std::uint64_t item = 0; places.size() < static_cast<std::size_t>(count); ++item)
  {
    RandomStream random(7, item);
    const Ray ray = scene.Camera.PixelRay(random.Next() - 0.5, random.Next() - 0.5, 1, 1);
    RayHit hit;
    if (!room.Intersect(ray.Origin, ray.Direction, 0.0, HUGE_VAL, hit))
    {
      continue;
    }
    const Vector3 normal = (hit.FrontFacing ? 1.0 : -1.0) * room.TriangleNormal(hit.Triangle);
    Place place{ ray.Origin + hit.T * ray.Direction + 1e-6 * normal, {}, 0 };
    for (int k = 0; k < 16; ++k)
    {
      const IncidentSample sample = SampleVisibleLight(
        scene.Light, place.Point, (k % 4 + random.Next()) / 4.0, (k / 4 + random.Next()) / 4.0);
      if (sample.Weight > 0.0 && Dot(sample.Direction, normal) > 0.0)
      {
        place.Rays.emplace_back(sample.Direction, sample.Distance);
      }
    }
    if (!place.Rays.empty())
    {
      place.Lit = SendRays(room, place);
      places.push_back(std::move(place));
    }
  }
  return places;
}

class PhotonsOnSurfaces
{
public:
  PhotonsOnSurfaces(const BenchmarkScene& scene, const OccluderScene& room, int count)
  {
    std::vector<Vector3> points;
    std::vector<RayHit> hits;
    for (int i = 0; i < count; ++i)
    {
      const std::array<double, 4> u = SobolPoint(1, static_cast<std::uint32_t>(i));
      const LightSurfaceSample from = SampleLightArea(scene.Light, u[0], u[1]);
      const Frame frame = FrameAround(from.Normal);
      const double sine = std::sqrt(u[2]);
      const Vector3 direction = std::sqrt(1.0 - u[2]) * from.Normal + sine * std::cos(TwoPi * u[3]) * frame.U +
        sine * std::sin(TwoPi * u[3]) * frame.V;
      room.IntersectAll(from.Position, direction, 0.0, HUGE_VAL, hits);
      for (const RayHit& hit : hits)
      {
        if (&hit == hits.data() || hit.T > hits.front().T + 1e-9) // two triangles share an edge
        {
          points.push_back(from.Position + hit.T * direction);
          this->Direct.push_back(&hit == hits.data());
        }
      }
    }
    Box bounds;
    for (const Vector3& point : points)
    {
      bounds.Add(point);
    }
    this->Tree = std::make_unique<PointTree>(
      bounds, static_cast<vtkIdType>(points.size()), [&](vtkIdType id) { return points[static_cast<std::size_t>(id)]; });
  }
  Answer At(const Vector3& point, int neighbours)
  {
    this->Tree->NearestTo(point, neighbours, this->Found, this->Squared);
    int direct = 0;
    for (const vtkIdType id : this->Found)
    {
      direct += this->Direct[static_cast<std::size_t>(id)];
    }
    return direct == 0 ? Answer::Hidden : direct == static_cast<int>(this->Found.size()) ? Answer::Lit : Answer::Ask;
  }

private:
  std::vector<char> Direct;
  std::unique_ptr<PointTree> Tree;
  std::vector<vtkIdType> Found;
  std::vector<double> Squared;
};

void PrintRow(const std::string& scene, const std::string& method, const OccluderScene& room, const std::vector<Place>& places,
  const std::function<Answer(const Vector3&)>& decide)
{
  double rays = 0.0;
  double sent = 0.0;
  double falseLit = 0.0;
  double falseHidden = 0.0;
  double wrongRays = 0.0;
  const std::clock_t start = std::clock();
  for (const Place& place : places)
  {
    const Answer answer = decide(place.Point);
    const std::uint64_t all = (std::uint64_t(1) << place.Rays.size()) - 1;
    const std::uint64_t lit = answer == Answer::Ask ? SendRays(room, place) : answer == Answer::Lit ? all : 0;
    const auto count = static_cast<double>(place.Rays.size());
    rays += count;
    sent += answer == Answer::Ask ? count : 0.0;
    falseLit += (lit & ~place.Lit) != 0;
    falseHidden += (place.Lit & ~lit) != 0;
    wrongRays += static_cast<double>(__builtin_popcountll(lit ^ place.Lit));
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto count = static_cast<double>(places.size());
  std::printf("| %s | %s | %.1f %% | %.2f %% | %.2f %% | %.3f %% | %.1f |\n", scene.c_str(), method.c_str(),
    100.0 * (1.0 - sent / rays), 100.0 * falseLit / count, 100.0 * falseHidden / count, 100.0 * wrongRays / rays,
    1e6 * seconds / count);
  std::fflush(stdout);
}

void PrintScene(const std::string& name)
{
  const BenchmarkScene scene(name);
  const OccluderScene room(scene.Room.View());
  const std::vector<Place> places = VisiblePlaces(scene, room, 20000);
  PrintRow(name, "rays everywhere", room, places, [](const Vector3&) { return Answer::Ask; });
  for (const int count : { 40000, 400000 })
  {
    PhotonsOnSurfaces photons(scene, room, count);
    for (const int neighbours : { 16, 50 })
    {
      PrintRow(name, std::to_string(count) + " photons, k = " + std::to_string(neighbours), room, places,
        [&](const Vector3& point) { return photons.At(point, neighbours); });
    }
  }
  const ProofScene proof{ name, "", scene.Occluders, scene.LightData, scene.Mesh, scene.Light, scene.Medium.Bounds };
  const ProofSceneCones cones = MakeCones(proof, 5800, {});
  const ConeHierarchy hierarchy(cones.Cones, Box{ { -2.8, -0.1, -2.8 }, { 2.8, 5.6, 2.8 } });
  PrintRow(name, std::to_string(cones.Cones.size()) + (cones.Certified ? " proved" : "") + " cones", room, places,
    [&](const Vector3& point) { return hierarchy.Contains(point) ? Answer::Ask : Answer::Lit; });
}
} // anonymous namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("What shadow photons on surfaces save, and where they are wrong, next to cones");
  std::vector<std::string> scenes{ "chair", "tree", "blob" };
  commandLine.Add("--scene", scenes, "chair, tree, blob or a mesh file");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  vtkObject::GlobalWarningDisplayOff();
  std::printf("| scene | who says where rays are sent | rays saved | lit in error | hidden in error | rays in error | us a point |\n"
              "|---|---|---|---|---|---|---|\n");
  try
  {
    for (const std::string& scene : scenes)
    {
      PrintScene(scene);
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  return 0;
}
