// SPDX-License-Identifier: BSD-3-Clause
#include "RivalRows.h"

#include "Rivals/ConesAround.h"
#include "Rivals/DeepShadowMaps.h"
#include "Rivals/LampRays.h"
#include "Rivals/ProjectedSolids.h"
#include "Rivals/RivalMarch.h"
#include "Rivals/RivalReference.h"
#include "Rivals/ShadowBuffers.h"
#include "Rivals/ShadowPhotonMap.h"
#include "Rivals/VisibilityOctree.h"
#include "Rivals/VisibilityVoxels.h"

#include "scParallel.h"
#include "scReference.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

namespace shadowcones
{
namespace
{
double ProcessorSeconds(const std::function<void()>& run)
{
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The shortest of up to five runs, once .3 s are spent.
double ShortestSeconds(const std::function<void()>& run)
{
  double shortest = ProcessorSeconds(run);
  double sum = shortest;
  for (int more = 0; more < 4 && sum < 0.3; ++more)
  {
    const double seconds = ProcessorSeconds(run);
    sum += seconds;
    shortest = std::min(shortest, seconds);
  }
  return shortest;
}

class Unshadowed : public PointRival
{
public:
  double BlockedAt(const Vector3&, RandomStream&) const override { return 0.0; }
  std::int64_t Memory() const override { return 0; }
};

std::int64_t MemoryOf(const VisibilityGrid& grid)
{
  return static_cast<std::int64_t>(grid.Visibility.size() * sizeof(float) + grid.ShadowClasses.size() + grid.Marked.size() +
    grid.BrickCells.size() * sizeof(vtkIdType) + grid.BrickVisibility.size() * sizeof(float));
}

std::string Number(int value)
{
  return std::to_string(value);
}

class Contest
{
public:
  Contest(const std::string& nameOrFile, const RivalSetting& setting)
    : Setting(setting)
    , Scene(nameOrFile, setting.Light)
  {
    this->Scene.BuildRoom();
    this->ConeSeconds = ProcessorSeconds(
      [this]
      {
        this->Scene.TraceVectors(0);
        this->Scene.FitCones();
        this->Scene.BuildHierarchy();
      });
    this->March = std::make_unique<RivalMarch>(this->Scene.View(), setting.Size, setting.Size, setting.Places);
    this->MakeTruth();
  }

  RivalFigures Run()
  {
    this->AddBuffers();
    this->AddSpaces();
    this->AddPhotonsAndPaths();
    this->AddCones();
    this->AddModes();
    RivalFigures& figures = this->Figures;
    figures.Scene = this->Scene.Name;
    figures.LitSeconds = this->March->LitSeconds();
    figures.Triangles = this->Scene.NumberOfTriangles();
    figures.Cones = static_cast<vtkIdType>(this->Scene.Cones().size());
    const ImageError error = Compare(std::vector<double>(this->Truth.size(), 0.0), this->Truth);
    figures.ReferenceNoise = error.Reference;
    figures.SmallestError = error.Smallest;
    return figures;
  }

private:
  using Maker = std::function<std::unique_ptr<PointRival>()>;

  /// Is the row asked for?
  bool Wanted(const std::string& name, const std::string& setting) const
  {
    return (name + ", " + setting).find(this->Setting.Rows) != std::string::npos;
  }

  void MakeTruth()
  {
    this->Truth = SpreadPixels(this->Setting.Size, this->Setting.Pixels);
    const ReferenceScene slow(this->Scene.Mesh.View());
    ParallelFor(static_cast<vtkIdType>(this->Truth.size()), Monitor(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType k = begin; k < end; ++k)
        {
          PixelTruth& pixel = this->Truth[static_cast<std::size_t>(k)];
          const std::size_t at = this->IndexOf(pixel);
          const HiddenLight hidden = ReferenceHiddenLight(*this->March, slow, at, this->Setting.Samples);
          pixel.Mean = this->March->Lit()[at] - hidden.Mean;
          pixel.StandardError = hidden.StandardError;
        }
      });
  }

  std::size_t IndexOf(const PixelTruth& pixel) const
  {
    return static_cast<std::size_t>(pixel.J) * static_cast<std::size_t>(this->Setting.Size) + static_cast<std::size_t>(pixel.I);
  }

  void Judge(RivalRow& row)
  {
    std::vector<double> values;
    for (const PixelTruth& pixel : this->Truth)
    {
      values.push_back(row.Image[this->IndexOf(pixel)]);
    }
    row.Error = Compare(values, this->Truth);
    this->Figures.Rows.push_back(row);
  }

  void AddRival(
    const std::string& name, const std::string& setting, const std::function<std::unique_ptr<Rival>()>& make, bool cones = false)
  {
    if (!this->Wanted(name, setting))
    {
      return;
    }
    RivalRow row;
    row.Name = name;
    row.Setting = setting;
    std::unique_ptr<Rival> rival;
    try
    {
      row.BuildSeconds = ProcessorSeconds([&] { rival = make(); }) + (cones ? this->ConeSeconds : 0.0);
    }
    catch (const std::runtime_error& failure)
    {
      row.Fault = failure.what();
      this->Figures.Rows.push_back(row);
      return;
    }
    row.Megabytes = 1e-6 * static_cast<double>(rival->Memory());
    row.ImageSeconds = this->March->LitSeconds() + ShortestSeconds([&] { this->March->Render(*rival, row.Image); });
    this->Judge(row);
  }

  Maker Buffers(int points, int resolution, bool soft = false) const
  {
    ShadowBufferOptions options;
    options.Points = points;
    options.Resolution = resolution;
    options.Soft = soft;
    return [this, options] { return std::make_unique<ShadowBuffers>(this->Scene.Mesh.View(), this->Scene.Light, options); };
  }
  Maker Rays(int rays) const
  {
    return [this, rays] { return std::make_unique<LampRays>(*this->Scene.Fast, this->Scene.Light, rays); };
  }

  void AddBuffers()
  {
    this->AddRival("no shadow", "", [] { return std::make_unique<Unshadowed>(); });
    const auto squared = [](int points, int resolution) { return Number(points) + " x " + Number(resolution) + "^2"; };
    for (const int resolution : { 256, 1024 })
    {
      this->AddRival("shadow buffer", squared(1, resolution), this->Buffers(1, resolution));
    }
    this->AddRival("shadow buffer, soft", squared(1, 512), this->Buffers(1, 512, true));
    for (const auto& [points, resolution] : { std::pair{ 4, 512 }, { 16, 128 }, { 16, 512 }, { 64, 256 } })
    {
      this->AddRival("shadow buffers", squared(points, resolution), this->Buffers(points, resolution));
    }
    for (const auto& [points, resolution] : { std::pair{ 1, 256 }, { 4, 256 }, { 16, 128 }, { 64, 128 } })
    {
      DeepShadowMapOptions options;
      options.Points = points;
      options.Resolution = resolution;
      this->AddRival("deep shadow maps", squared(points, resolution) + ", 4^2 rays",
        [this, options] { return std::make_unique<DeepShadowMaps>(this->Scene.Mesh.View(), this->Scene.Light, options); });
    }
  }

  void AddSpaces()
  {
    const Box& bounds = this->Scene.Medium.Bounds;
    for (const int side : { 33, 65, 97 })
    {
      this->AddRival("voxels", Number(side) + "^3, 16 rays",
        [this, side, &bounds] { return std::make_unique<VisibilityVoxels>(*this->Scene.Fast, this->Scene.Light, bounds, side, 16); });
    }
    for (const int depth : { 5, 6, 7 })
    {
      VisibilityOctreeOptions options;
      options.Depth = depth;
      this->AddRival("octree", "depth " + Number(depth) + ", 32 rays",
        [this, options, &bounds] { return std::make_unique<VisibilityOctree>(*this->Scene.Fast, this->Scene.Light, bounds, options); });
    }
    for (const int points : { 1, 4, 16 })
    {
      this->AddRival("projection volumes", Number(points) + (points == 1 ? " point" : " points"),
        [this, points, &bounds] { return std::make_unique<ProjectedSolids>(this->Scene.Mesh.View(), this->Scene.Light, bounds, points); });
    }
  }

  void AddPhotonsAndPaths()
  {
    for (const auto& [paths, neighbors, rays] : { std::array{ 10000, 16, 0 }, { 50000, 24, 0 }, { 10000, 16, 16 } })
    {
      ShadowPhotonOptions options;
      options.Paths = paths;
      options.Neighbors = neighbors;
      options.Rays = rays;
      this->AddRival(rays > 0 ? "shadow photons, rays" : "shadow photons",
        Number(paths) + " paths, " + Number(neighbors) + " near" + (rays > 0 ? ", " + Number(rays) + " rays" : ""),
        [this, options] { return std::make_unique<ShadowPhotonMap>(*this->Scene.Fast, this->Scene.Light, this->Scene.Medium.Bounds, options); });
    }
    for (const bool evenAngle : { false, true })
    {
      for (const int samples : { 64, 256, 1024 })
      {
        const std::string name = evenAngle ? "path tracing, even angle" : "path tracing, uniform";
        const std::string setting = Number(samples) + " a pixel";
        if (this->Wanted(name, setting) && (evenAngle || samples == 256))
        {
          this->AddWhole(name, setting, 0.0, this->Scene.Fast->Memory(), [=](std::vector<double>& image) { this->March->TracePaths(samples, evenAngle, image); });
        }
      }
    }
    for (const int rays : { 1, 4, 16 })
    {
      this->AddRival("rays everywhere", Number(rays) + " a place", this->Rays(rays));
    }
  }

  void AddCones()
  {
    const auto around = [this](const Maker& inside) -> std::function<std::unique_ptr<Rival>()>
    { return [this, inside] { return std::make_unique<ConesAround>(*this->Scene.Hierarchy(), inside()); }; };
    for (const auto& [points, resolution] : { std::pair{ 16, 128 }, { 16, 512 }, { 64, 256 } })
    {
      this->AddRival("cones, buffers inside", Number(points) + " x " + Number(resolution) + "^2",
        around(this->Buffers(points, resolution)), true);
    }
    for (const int rays : { 1, 4, 16 })
    {
      this->AddRival("cones, rays inside", Number(rays) + " a place", around(this->Rays(rays)), true);
    }
  }

  void AddWhole(const std::string& name, const std::string& setting, double build, std::int64_t memory,
    const std::function<void(std::vector<double>&)>& render, bool whole = true)
  {
    RivalRow row;
    row.Name = name;
    row.Setting = setting;
    row.BuildSeconds = build;
    row.Megabytes = 1e-6 * static_cast<double>(memory);
    row.Whole = whole;
    row.ImageSeconds = ShortestSeconds([&] { render(row.Image); });
    this->Judge(row);
  }

  void AddMode(const std::string& setting, const ScatteringOptions& options, double fill, std::int64_t memory, const VisibilityGrid* grid = nullptr)
  {
    const bool march = options.Mode == ScatteringMode::Medium;
    this->AddWhole(march ? "ours: Medium" : grid ? "ours: Volume" : "ours: Guided", setting, this->ConeSeconds + fill,
      memory + this->Scene.Hierarchy()->Memory(),
      [&](std::vector<double>& image)
      {
        this->Scene.Render(options, this->Scene.Hierarchy(), grid, this->Rendered);
        image.assign(this->March->NumberOfPixels(), 0.0);
        const auto wavelengths = static_cast<std::size_t>(this->Rendered.NumberOfWavelengths);
        for (std::size_t k = 0; k < image.size() * wavelengths; ++k)
        {
          image[k / wavelengths] += this->Rendered.InScattering[k] / static_cast<double>(wavelengths);
        }
      },
      march);
  }

  void AddModes()
  {
    const std::int64_t rays = this->Scene.Fast->Memory();
    ScatteringOptions options = this->Scene.Options(ScatteringMode::Medium, this->Setting.Size);
    if (this->Wanted("ours: Medium", "as by default"))
    {
      this->AddMode("as by default", options, 0.0, rays);
    }
    options = this->Scene.Options(ScatteringMode::Guided, this->Setting.Size);
    for (const auto& [goal, name] : { std::pair{ 0.04, "goal 4 %" }, { 0.01, "goal 1 %" }, { 0.0025, "goal 0.25 %" } })
    {
      options.RelativeErrorGoal = goal;
      options.MaximumSamples = 4096;
      if (this->Wanted("ours: Guided", name))
      {
        this->AddMode(name, options, 0.0, rays);
      }
    }
    options = this->Scene.Options(ScatteringMode::Volume, this->Setting.Size);
    for (const int side : { 33, 65, 97 })
    {
      const std::string name = Number(side) + "^3, 16 rays, bricks";
      if (this->Wanted("ours: Volume", name))
      {
        VisibilityGrid grid;
        const double fill = ProcessorSeconds([&] { grid = this->Scene.FillGrid(side, 16, 2); });
        this->AddMode(name, options, fill, MemoryOf(grid), &grid);
      }
    }
  }

  const RivalSetting& Setting;
  BenchmarkScene Scene;
  std::vector<PixelTruth> Truth;
  double ConeSeconds = 0.0;
  std::unique_ptr<RivalMarch> March;
  ScatteringImage Rendered;
  RivalFigures Figures;
};
} // namespace

//------------------------------------------------------------------------------
RivalFigures MeasureRivals(const std::string& nameOrFile, const RivalSetting& setting)
{
  return Contest(nameOrFile, setting).Run();
}

} // namespace shadowcones
