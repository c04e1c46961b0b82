// SPDX-License-Identifier: BSD-3-Clause
#include "FogSpeed.h"

#include "BenchmarkScene.h"
#include "SampledDensity.h"
#include "TestMeshes.h"

#include "scDensityGrid.h"
#include "scRandom.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace shadowcones
{
namespace
{
/// One random value at every point of a lattice of whole numbers, smoothly in between.
double Noise(const Vector3& p)
{
  const double base[3] = { std::floor(p.X), std::floor(p.Y), std::floor(p.Z) };
  double smooth[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = p[axis] - base[axis];
    smooth[axis] = x * x * (3.0 - 2.0 * x);
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::uint64_t key = 7;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int upper = corner >> axis & 1;
      weight *= upper ? smooth[axis] : 1.0 - smooth[axis];
      key = HashSeed(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(base[axis]) + upper));
    }
    sum += weight * static_cast<double>(key >> 11) * 0x1p-53;
  }
  return sum;
}

/// Banks of fog some two units across.
double Smooth(const Vector3& p)
{
  return 0.2 + 1.6 * Noise(0.5 * p);
}

/// Wisps down to half a unit, with clear air between them.
double Wispy(const Vector3& p)
{
  const double sum = 0.5 * Noise(0.5 * p) + 0.3 * Noise(1.1 * p + Vector3{ 3.0, 5.0, 7.0 }) +
    0.2 * Noise(2.0 * p + Vector3{ 11.0, 2.0, 5.0 });
  return std::max(6.0 * (sum - 0.4), 0.0);
}

DensityGrid FogOf(const Box& bounds, int points, double (*density)(const Vector3&))
{
  const Vector3 spacing = (1.0 / (points - 1)) * (bounds.Max - bounds.Min);
  return SampleDensity({ { points, points, points } }, bounds.Min, UnitAxes(spacing), density);
}

/// Thin slats under the lamp.
testsupport::TestMesh Slats()
{
  testsupport::TestMesh mesh;
  for (int k = 0; k < 7; ++k)
  {
    mesh.AddBox({ -1.5 + 0.45 * k, 2.9, -1.5 }, { -1.25 + 0.45 * k, 2.93, 1.5 }, k);
  }
  return mesh;
}

struct Cost
{
  double Processor = HUGE_VAL; ///< seconds of all threads together
  vtkIdType Rays = 0;
};

void Render(const ScatteringScene& scene, const ScatteringOptions& options, Cost& cost)
{
  ScatteringImage image;
  const std::clock_t start = std::clock();
  RenderScattering(scene, options, Monitor(), image);
  cost.Processor = std::min(cost.Processor, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  cost.Rays = image.NumberOfOcclusionRays;
}
} // anonymous namespace

void MeasureFog(int size, int repeats)
{
  BenchmarkScene chair("chair");
  const testsupport::TestMesh slats = Slats();
  const OccluderScene chairs(chair.Room.View());
  const OccluderScene boards(slats.View());
  struct Fog
  {
    const char* Name;
    DensityGrid Grid;
  };
  const Box& bounds = chair.Medium.Bounds;
  const Fog fogs[] = { { "smooth, 32^3", FogOf(bounds, 32, Smooth) }, { "wispy, 32^3", FogOf(bounds, 32, Wispy) },
    { "smooth, 64^3", FogOf(bounds, 64, Smooth) }, { "wispy, 64^3", FogOf(bounds, 64, Wispy) },
    { "the same everywhere", FogOf(bounds, 32, [](const Vector3&) { return 1.0; }) } };
  for (const OccluderScene* body : { &chairs, &boards })
  {
    for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::BruteForce })
    {
      const ScatteringOptions options = chair.Options(mode, size);
      for (const Fog& fog : fogs)
      {
        Medium foggy = chair.Medium;
        foggy.Density = &fog.Grid;
        Cost clear;
        Cost dense;
        for (int k = 0; k < repeats; ++k)
        {
          Render({ *body, chair.Light, chair.Medium, chair.Camera }, options, clear);
          Render({ *body, chair.Light, foggy, chair.Camera }, options, dense);
        }
        std::printf("fog: %s, %s, %d x %d, %s: processor %.4f s, without %.4f s, ratio %.2f; %lld rays, without %lld\n",
          body == &chairs ? "chair" : "slats", mode == ScatteringMode::Guided ? "Guided" : "BruteForce", size, size,
          fog.Name, dense.Processor, clear.Processor, dense.Processor / clear.Processor,
          static_cast<long long>(dense.Rays), static_cast<long long>(clear.Rays));
        std::fflush(stdout);
      }
    }
  }
}

} // namespace shadowcones
