// SPDX-License-Identifier: BSD-3-Clause
// How wrong the image is where cones are the shadow itself: no mesh is asked for what is lit.
//
// The medium term along a ray is written as lit minus blocked. Every row has the same lit part, and the truth too, so
// that the error is of the shadow alone: root of the mean square over pixels, over the mean of the truth. The truth's
// blocked part is estimated with occlusion rays at random places and light points of its own; its noise is known and
// taken off. --reference holds the truth against the independent renderer of Testing/Reference.
#include "ProgramOptions.h"
#include "ReferencePixels.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scOccluderInterval.h"
#include "scRandom.h"
#include "scVisibilityGrid.h"
#include "scVisibilityProbe.h"

#include "scFrame.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <set>

using namespace shadowcones;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr int cells = 256;       ///< of a ray, even in the angle seen from the light
constexpr int lightRings = 12;   ///< of the lit part's rule, even in area
constexpr int lightSpokes = 32;
constexpr int batches = 16;      ///< independent estimates of the truth, which give its noise
constexpr double nearest = 0.15; ///< of a ray to the light's centre, in the change of variable

/// What the room's disc light sends from (a, b) on it through the medium by way of x to the camera, per unit of length.
class Integrand
{
public:
  Integrand(const Light& light, const Medium& medium)
    : Source(light)
    , Inside(medium.Bounds)
    , Axes(FrameAround(light.Normal))
  {
    for (std::size_t k = 0; k < light.Spectrum.size(); ++k)
    {
      const double scatter = medium.SigmaS[k] * light.Spectrum[k] / static_cast<double>(light.Spectrum.size());
      this->Scatter[medium.SigmaS[k] + medium.SigmaA[k]] += scatter;
    }
  }

  Vector3 LightPoint(double radius, double angle) const
  {
    return this->Source.Center +
      this->Source.Radius * radius * (std::cos(angle) * this->Axes.U + std::sin(angle) * this->Axes.V);
  }

  /// Mean over wavelengths, times the light's area. @param depth inside the medium from the camera to x.
  double At(const Vector3& x, double depth, const Vector3& lightPoint) const
  {
    const Vector3 to = lightPoint - x;
    const double distance = Length(to);
    const Vector3 direction = (1.0 / distance) * to;
    const double cosine = -Dot(direction, this->Source.Normal);
    if (!(cosine > 0.0))
    {
      return 0.0;
    }
    double begin = 0.0;
    double end = distance;
    const double path = depth + (this->Inside.Clip(x, direction, begin, end) ? end - begin : 0.0);
    double sum = 0.0;
    for (const auto& [sigmaT, scatter] : this->Scatter)
    {
      sum += scatter * std::exp(-sigmaT * path);
    }
    return sum * cosine / (distance * distance) * this->Source.Radius * this->Source.Radius / 4.0;
  }

  double Unshadowed(const Vector3& x, double depth) const
  {
    double sum = 0.0;
    for (int ring = 0; ring < lightRings; ++ring)
    {
      for (int spoke = 0; spoke < lightSpokes; ++spoke)
      {
        const double angle = 2.0 * pi * (spoke + 0.5 * (ring % 2)) / lightSpokes;
        sum += this->At(x, depth, this->LightPoint(std::sqrt((ring + 0.5) / lightRings), angle));
      }
    }
    return sum / (lightRings * lightSpokes);
  }

private:
  const Light& Source;
  Box Inside;
  Frame Axes;
  std::map<double, double> Scatter; ///< by sigma_t: sum over wavelengths of sigma_s L
};

/// The part of a pixel's ray in the medium, t = Nearest + Distance tan(angle), and the unshadowed light of its cells.
struct PixelRay
{
  Ray Line;
  double Begin = 0.0;
  double End = 0.0;
  double Nearest = 0.0;
  double Distance = 1.0;
  double FirstAngle = 0.0;
  double CellAngle = 0.0;
  std::vector<double> Lit; ///< a cell; empty: the ray misses the medium

  double PositionAt(double cell) const
  {
    return this->Nearest + this->Distance * std::tan(this->FirstAngle + cell * this->CellAngle);
  }
  /// Length a cell at this position.
  double Stretch(double t) const
  {
    const double offset = t - this->Nearest;
    return this->CellAngle * (this->Distance + offset * offset / this->Distance);
  }
  double CellOf(double t) const
  {
    return (std::atan((t - this->Nearest) / this->Distance) - this->FirstAngle) / this->CellAngle;
  }
  Vector3 Point(double t) const { return this->Line.Origin + t * this->Line.Direction; }
  double Sum() const
  {
    double sum = 0.0;
    for (const double lit : this->Lit)
    {
      sum += lit;
    }
    return sum;
  }
};

PixelRay MakeRay(const Ray& line, const BenchmarkScene& scene, const OccluderScene& room,
  const Integrand& integrand)
{
  PixelRay ray;
  ray.Line = line;
  ray.End = HUGE_VAL;
  RayHit hit;
  if (!RoomBounds().Clip(line.Origin, line.Direction, ray.Begin, ray.End))
  {
    return ray;
  }
  if (room.Intersect(line.Origin, line.Direction, 0.0, HUGE_VAL, hit))
  {
    ray.End = std::min(ray.End, hit.T);
  }
  if (!(ray.End > ray.Begin))
  {
    return ray;
  }
  ray.Nearest = Dot(scene.Light.Center - line.Origin, line.Direction);
  ray.Distance = std::max(nearest, Length(ray.Point(ray.Nearest) - scene.Light.Center));
  ray.FirstAngle = std::atan((ray.Begin - ray.Nearest) / ray.Distance);
  ray.CellAngle = (std::atan((ray.End - ray.Nearest) / ray.Distance) - ray.FirstAngle) / cells;
  for (int cell = 0; cell < cells; ++cell)
  {
    const double t = ray.PositionAt(cell + 0.5);
    ray.Lit.push_back(ray.Stretch(t) * integrand.Unshadowed(ray.Point(t), t - ray.Begin));
  }
  return ray;
}

/// Light along the ray that the mesh blocks, by occlusion rays at random places to random light points.
void TraceTruth(const PixelRay& ray, const OccluderScene& room, const Integrand& integrand, int samplesPerCell,
  std::uint64_t item, PixelTruth& truth)
{
  RandomStream random(2026, item);
  double sum = 0.0;
  double squares = 0.0;
  for (int batch = 0; batch < batches && !ray.Lit.empty(); ++batch)
  {
    double blocked = 0.0;
    for (int sample = 0; sample < cells * samplesPerCell; ++sample)
    {
      const double t = ray.PositionAt((sample + random.Next()) / samplesPerCell);
      const double radius = std::sqrt(random.Next());
      const Vector3 y = integrand.LightPoint(radius, 2.0 * pi * random.Next());
      const Vector3 x = ray.Point(t);
      const double distance = Length(y - x);
      if (room.Occluded(x, (1.0 / distance) * (y - x), 0.0, distance))
      {
        blocked += ray.Stretch(t) * integrand.At(x, t - ray.Begin, y) / samplesPerCell;
      }
    }
    sum += blocked;
    squares += blocked * blocked;
  }
  const double mean = sum / batches;
  truth.Mean = ray.Sum() - mean;
  truth.StandardError = std::sqrt(std::max(0.0, squares / batches - mean * mean) / (batches - 1));
}

/// What passes the ray's cells where a share of the light is visible.
double WithVisibility(const PixelRay& ray, const std::function<double(const Vector3&)>& visibility)
{
  double sum = 0.0;
  for (std::size_t cell = 0; cell < ray.Lit.size(); ++cell)
  {
    sum += ray.Lit[cell] * visibility(ray.Point(ray.PositionAt(static_cast<double>(cell) + 0.5)));
  }
  return sum;
}

/// Nothing inside cones, everything outside.
double OutsideCones(const PixelRay& ray, const ConeHierarchy& cones, std::vector<OccluderInterval>& intervals)
{
  double sum = ray.Sum();
  if (ray.Lit.empty())
  {
    return sum;
  }
  cones.Intersect(ray.Line.Origin, ray.Line.Direction, ray.Begin, ray.End, intervals);
  for (const OccluderInterval& interval : intervals)
  {
    const double first = std::clamp(ray.CellOf(interval.Begin), 0.0, static_cast<double>(cells));
    const double last = std::clamp(ray.CellOf(interval.End), first, static_cast<double>(cells));
    for (int cell = static_cast<int>(first); cell < std::min<int>(cells, static_cast<int>(std::ceil(last))); ++cell)
    {
      sum -= ray.Lit[cell] * std::max(0.0, std::min(last, cell + 1.0) - std::max(first, static_cast<double>(cell)));
    }
  }
  return sum;
}

struct Setting
{
  int Size = 256;
  int Pixels = 2048;
  int SamplesPerCell = 4;
  int ReferenceSamples = 0;
  std::string Folder = ".";
  std::vector<std::string> Shadows = { "preview", "soft", "exact" };
  std::vector<int> Sides = { 65 };
  int Parts = 4;
  int LightSamples = 64;
  bool WithoutGrid = false;
};

class Table
{
public:
  Table(const std::string& name, const Setting& setting)
    : Scene(name)
    , RoomScene(this->Scene.Room.View())
    , What(this->Scene.Light, this->Scene.Medium)
    , Settings(setting)
    , Truth(SpreadPixels(setting.Size, setting.Pixels))
    , Rays(this->Truth.size())
  {
    vtkSMPTools::For(0, setting.Pixels, 8,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType k = begin; k < end; ++k)
        {
          PixelTruth& pixel = this->Truth[k];
          this->Rays[k] = MakeRay(this->Scene.Camera.PixelRay(pixel.I, pixel.J, setting.Size, setting.Size),
            this->Scene, this->RoomScene, this->What);
          TraceTruth(this->Rays[k], this->RoomScene, this->What, setting.SamplesPerCell,
            static_cast<std::uint64_t>(k), pixel);
        }
      });
  }

  /// The truth against the independent reference: mean difference, and differences over their standard errors.
  void CheckTruth() const
  {
    const std::vector<PixelTruth> reference = ReferencePixels(
      this->Scene, this->Settings.Size, this->Settings.Pixels, this->Settings.ReferenceSamples, this->Settings.Folder);
    double difference = 0.0;
    double variance = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < reference.size(); ++k)
    {
      const double d = this->Truth[k].Mean - reference[k].Mean;
      const double v = std::pow(this->Truth[k].StandardError, 2) + std::pow(reference[k].StandardError, 2);
      difference += d;
      variance += v;
      sum += reference[k].Mean;
      if (v > 0.0)
      {
        squares += d * d / v;
        count += 1.0;
      }
    }
    std::printf("# %s: truth minus Testing/Reference %+.5f +- %.5f of the mean; differences over their standard errors "
                "%.3f (root mean square; 1.07 expected of 16 batches)\n",
      this->Scene.Name.c_str(), difference / sum, std::sqrt(variance) / sum, std::sqrt(squares / count));
  }

  void Run()
  {
    if (this->Settings.ReferenceSamples > 0)
    {
      this->CheckTruth();
    }
    this->Print("no shadow", 0, 0, 0.0, 0.0, [](const PixelRay& ray) { return ray.Sum(); });
    const auto wanted = [&](const char* name)
    { return std::count(this->Settings.Shadows.begin(), this->Settings.Shadows.end(), name) > 0; };
    for (const vtkIdType vectors : { 5800, 50000 })
    {
      if (!wanted("preview"))
      {
        break;
      }
      double seconds = 0.0;
      const std::vector<Cone> cones = this->Cones("preview", vectors, seconds);
      const ConeHierarchy hierarchy(cones, RoomBounds());
      this->Print("Fast, Preview", vectors, cones.size(), seconds, 0.0,
        [&](const PixelRay& ray)
        {
          thread_local std::vector<OccluderInterval> intervals;
          return OutsideCones(ray, hierarchy, intervals);
        });
    }
    if (wanted("soft"))
    {
      this->RunGrid("soft", 5800, VisibilityMethod::Soft);
      this->RunGrid("soft", 50000, VisibilityMethod::Soft);
    }
    if (wanted("exact"))
    {
      this->RunGrid("conservative", 50000, VisibilityMethod::Exact);
    }
    double noise = 0.0;
    double sum = 0.0;
    for (const PixelTruth& pixel : this->Truth)
    {
      noise += pixel.StandardError * pixel.StandardError;
      sum += pixel.Mean;
    }
    const auto count = static_cast<double>(this->Truth.size());
    std::printf("# %s: noise of the truth %.5f of the mean a pixel\n", this->Scene.Name.c_str(),
      std::sqrt(noise / count) / (sum / count));
  }

private:
  std::vector<Cone> Cones(const std::string& set, vtkIdType vectors, double& seconds) const
  {
    ConeParameters parameters = NamedParameters(set);
    parameters.Vectors = vectors;
    const VectorsOfScene made = this->Scene.MakeVectors(parameters);
    ConesOfScene cones = MakeCones(made, parameters);
    seconds = made.Seconds + cones.TuningSeconds + cones.Seconds;
    return std::move(cones.Cones);
  }

  void RunGrid(const std::string& set, vtkIdType vectors, VisibilityMethod method)
  {
    double seconds = 0.0;
    const std::vector<Cone> cones = this->Cones(set, vectors, seconds);
    const std::string name = method == VisibilityMethod::Soft ? "Soft" : "Exact";
    for (const int side : this->Settings.Sides)
    {
      for (const int parts : std::set<int>{ 1, this->Settings.Parts })
      {
        VisibilityGridOptions options;
        options.Method = method;
        options.Dimensions = { side, side, side };
        options.NumberOfLightSamples = this->Settings.LightSamples;
        options.BrickParts = parts;
        const double start = Now();
        VisibilityGrid grid;
        FillVisibilityGrid(cones, this->Scene.Light, this->Scene.Fast.get(), RoomBounds(), options, {}, grid);
        const double fill = Now() - start;
        const std::string label = name + ", grid " + std::to_string(side);
        this->Print(parts > 1 ? label + "x" + std::to_string(parts) : label, vectors, cones.size(), seconds, fill,
          [&](const PixelRay& ray)
          { return WithVisibility(ray, [&](const Vector3& x) { return VisibilityAt(grid, x); }); });
      }
    }
    if (this->Settings.WithoutGrid)
    {
      VisibilityOptions options;
      options.Method = method;
      options.NumberOfLightSamples = this->Settings.LightSamples;
      const VisibilityProbe probe(cones, this->Scene.Light, this->Scene.Fast.get(), RoomBounds(), options);
      this->Print(name + ", no grid", vectors, cones.size(), seconds, 0.0,
        [&](const PixelRay& ray)
        { return WithVisibility(ray, [&](const Vector3& x) { return probe.At(x).Fraction; }); });
    }
  }

  void Print(const std::string& name, vtkIdType vectors, std::size_t cones, double coneSeconds, double fillSeconds,
    const std::function<double(const PixelRay&)>& value) const
  {
    std::vector<double> values(this->Rays.size());
    const double start = Now();
    vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()), 8,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType k = begin; k < end; ++k)
        {
          values[k] = value(this->Rays[k]);
        }
      });
    const double seconds = Now() - start;
    const ImageError error = Compare(values, this->Truth);
    std::printf("%-8s %-18s %8lld %7zu %8.2f %8.3f %8.3f %9.5f %9.5f\n", this->Scene.Name.c_str(), name.c_str(),
      static_cast<long long>(vectors), cones, coneSeconds, fillSeconds, seconds, error.Rms, error.Bias);
    std::fflush(stdout);
  }

  BenchmarkScene Scene;
  OccluderScene RoomScene;
  Integrand What;
  const Setting& Settings;
  std::vector<PixelTruth> Truth;
  std::vector<PixelRay> Rays;
};
} // namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("How wrong the image is where cones are the shadow itself.");
  Setting setting;
  std::vector<std::string> scenes = { "chair", "tree", "blob" };
  std::vector<std::string> meshes;
  commandLine.Add("--scene", scenes, "chair, tree, blob, or a mesh file");
  commandLine.Add("--mesh", meshes, "mesh files beside the scenes");
  commandLine.AddChoice("--shadow", setting.Shadows, "rows to make", { "preview", "soft", "exact" });
  commandLine.AddPositive("--size", setting.Size, "width and height in pixels");
  commandLine.AddPositive("--pixels", setting.Pixels, "pixels that are compared with the truth");
  commandLine.AddPositive("--samples", setting.SamplesPerCell, "occlusion rays of the truth, in units of 4,096 a pixel");
  commandLine.AddWithin("--grid", setting.Sides, "vertices along a side of the grid, one or more", 2, 513);
  commandLine.AddPositive("--parts", setting.Parts, "parts into which sides of refined cells are cut; 1: no such rows");
  commandLine.AddPositive("--light-samples", setting.LightSamples, "light points a vertex");
  commandLine.AddFlag("--without-grid", setting.WithoutGrid, "also ask for the visible fraction along the rays themselves");
  commandLine.Add("--reference", setting.ReferenceSamples, "samples a pixel of Testing/Reference to hold the truth against");
  commandLine.Add("--cache", setting.Folder, "folder that keeps the reference from one run to the next");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  scenes.insert(scenes.end(), meshes.begin(), meshes.end());

  try
  {
    std::printf("# %d of %d x %d pixels, %d light points a vertex; error and bias of the medium term over its mean, "
                "the truth's noise taken off\n# seconds: cones = vectors, tuning and fit; fill = visible fractions on the "
                "grid (x4: and in finer cells); "
                "image = %d pixels, the lit part excluded\n",
      setting.Pixels, setting.Size, setting.Size, setting.LightSamples, setting.Pixels);
    std::printf("%-8s %-18s %8s %7s %8s %8s %8s %9s %9s\n", "scene", "shadow", "vectors", "cones", "cones s", "fill s",
      "image s", "error", "bias");
    for (const std::string& name : scenes)
    {
      Table(name, setting).Run();
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "cone-image: %s\n", failure.what());
    return 1;
  }
  return 0;
}
