// SPDX-License-Identifier: BSD-3-Clause
// Seconds, error and occlusion rays of each mode: Hougs and Day's Table 1 with measured errors.
//
// The scene is the room with coloured side walls and a black back wall (Data/cornell-box.vtp). The error is that of the
// medium term: root of the mean square over pixels, over the mean, of the mean over wavelengths. The truth is
// Testing/Reference at random pixels, with independent random light points; its own noise is known and taken off.
#include "BenchmarkScene.h"

#include "scConeIntervals.h"
#include "scReference.h"
#include "scScatteringImage.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkXMLPolyDataReader.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iomanip>

using namespace shadowcones;

namespace
{
struct PixelTruth
{
  int I = 0;
  int J = 0;
  double Mean = 0.0;
  double StandardError = 0.0;
};

struct Setting
{
  int Size = 256;
  int Pixels = 2048;
  int Samples = 65536;
  int LightSamples = 16;
  int Steps = 32;
  int Depth = 3;
  double Threshold = 0.1;
  int Repeats = 3;
};

Camera RoomCamera()
{
  Camera camera;
  camera.Position = { 0.0, 2.65, 10.0 };
  camera.HalfHeight = 0.37;
  return camera;
}

Medium RoomMedium(const Light& light)
{
  Medium medium;
  medium.SigmaS.assign(light.Spectrum.size(), 0.12);
  medium.SigmaA.assign(light.Spectrum.size(), 0.0);
  medium.Bounds = RoomBounds();
  return medium;
}

/// The occluder and the walls as one mesh; walls have OccluderId -1 and a reflectance.
struct Room
{
  TriangleMesh Mesh;
  std::vector<float> Reflectance; ///< one a triangle and wavelength
};

Room BuildRoom(const BenchmarkScene& scene, std::size_t wavelengths)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(SHADOWCONES_DATA_DIR "/cornell-box.vtp");
  reader->Update();
  TriangleMesh walls;
  std::string error;
  if (!ReadTriangles(reader->GetOutput(), walls, error))
  {
    throw std::runtime_error(error);
  }
  Room room;
  room.Mesh = scene.Mesh;
  room.Mesh.OccluderIds.resize(room.Mesh.Triangles.size() / 3, 0);
  room.Reflectance.assign(room.Mesh.OccluderIds.size() * wavelengths, 0.5f);
  const auto offset = static_cast<vtkIdType>(room.Mesh.Points.size() / 3);
  room.Mesh.Points.insert(room.Mesh.Points.end(), walls.Points.begin(), walls.Points.end());
  for (const vtkIdType id : walls.Triangles)
  {
    room.Mesh.Triangles.push_back(id + offset);
  }
  room.Mesh.OccluderIds.resize(room.Mesh.Triangles.size() / 3, -1);
  vtkDataArray* reflectance = reader->GetOutput()->GetCellData()->GetArray("Reflectance");
  for (const vtkIdType cell : walls.SourceCells)
  {
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      room.Reflectance.push_back(static_cast<float>(reflectance->GetComponent(cell, static_cast<int>(k))));
    }
  }
  return room;
}

double MeanOverWavelengths(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

/// Part of the header of kept references: to be raised where the rule of the reference changes.
constexpr int referenceVersion = 2;

/// A number that changes with the scene, so that a stale file is not read.
double Fingerprint(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < mesh.Points.size(); ++k)
  {
    sum += mesh.Points[k] * std::cos(static_cast<double>(k));
  }
  return sum;
}

std::vector<PixelTruth> Reference(
  const BenchmarkScene& scene, const Room& room, const Setting& setting, const std::string& folder)
{
  char header[200];
  std::snprintf(header, sizeof(header), "%d %s %d %d %d %.6f", referenceVersion, scene.Name.c_str(), setting.Size,
    setting.Pixels, setting.Samples, Fingerprint(room.Mesh));
  const std::string file = folder + "/scattering-reference-" + scene.Name + ".txt";
  std::vector<PixelTruth> truth(setting.Pixels);
  std::ifstream in(file);
  std::string line;
  if (in && std::getline(in, line) && line == header)
  {
    bool whole = true;
    for (PixelTruth& pixel : truth)
    {
      whole = whole && static_cast<bool>(in >> pixel.I >> pixel.J >> pixel.Mean >> pixel.StandardError);
    }
    if (whole)
    {
      return truth;
    }
  }

  std::fprintf(stderr, "%s: making the reference, %d pixels x %d samples ...\n", scene.Name.c_str(), setting.Pixels,
    setting.Samples);
  const double start = Now();
  const ReferenceScene slow(room.Mesh.View());
  const Medium medium = RoomMedium(scene.Source);
  const Camera camera = RoomCamera();
  vtkSMPTools::For(0, setting.Pixels, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        // Pixels in the order of the golden ratio cover the image evenly.
        const double turns = 0.61803398874989485 * static_cast<double>(k);
        PixelTruth& pixel = truth[k];
        pixel.I = static_cast<int>((turns - std::floor(turns)) * setting.Size);
        pixel.J = static_cast<int>((static_cast<double>(k) + 0.5) / setting.Pixels * setting.Size);
        const ReferenceEstimate estimate = ReferenceInScattering(
          slow, scene.Source, medium, camera, pixel.I, pixel.J, setting.Size, setting.Size, setting.Samples);
        pixel.Mean = MeanOverWavelengths(estimate.Mean);
        pixel.StandardError = MeanOverWavelengths(estimate.StandardError);
      }
    });
  std::fprintf(stderr, "%s: %.0f s\n", scene.Name.c_str(), Now() - start);
  std::ofstream out(file);
  out << header << '\n' << std::setprecision(12);
  for (const PixelTruth& pixel : truth)
  {
    out << pixel.I << ' ' << pixel.J << ' ' << pixel.Mean << ' ' << pixel.StandardError << '\n';
  }
  return truth;
}

struct Error
{
  double Rms = 0.0;       ///< over the mean, the reference's noise taken off
  double Bias = 0.0;      ///< mean difference over the mean
  double Reference = 0.0; ///< the reference's own noise over the mean
};

Error Compare(const ScatteringImage& image, const std::vector<PixelTruth>& truth, int size)
{
  double squares = 0.0;
  double noise = 0.0;
  double sum = 0.0;
  double difference = 0.0;
  for (const PixelTruth& pixel : truth)
  {
    const std::size_t at = (static_cast<std::size_t>(pixel.J) * size + pixel.I) * image.NumberOfWavelengths;
    double value = 0.0;
    for (int k = 0; k < image.NumberOfWavelengths; ++k)
    {
      value += image.InScattering[at + k] / static_cast<double>(image.NumberOfWavelengths);
    }
    squares += (value - pixel.Mean) * (value - pixel.Mean);
    noise += pixel.StandardError * pixel.StandardError;
    difference += value - pixel.Mean;
    sum += pixel.Mean;
  }
  const auto count = static_cast<double>(truth.size());
  Error error;
  error.Rms = std::sqrt(std::max(squares - noise, 0.0) / count) / (sum / count);
  error.Bias = difference / sum;
  error.Reference = std::sqrt(noise / count) / (sum / count);
  return error;
}
} // namespace

int main(int argc, char* argv[])
{
  CLI::App app("Seconds, error and occlusion rays of each mode of the scattering image.");
  Setting setting;
  std::vector<std::string> scenes = { "chair", "tree" };
  std::string folder = ".";
  vtkIdType vectors = 5800;
  int threads = 1;
  app.add_option("--scene", scenes, "chair, tree, blob, or a mesh file");
  app.add_option("--vectors", vectors, "shadow vectors asked for");
  app.add_option("--size", setting.Size, "width and height in pixels")->check(CLI::PositiveNumber);
  app.add_option("--pixels", setting.Pixels, "pixels that are compared with the reference")->check(CLI::PositiveNumber);
  app.add_option("--samples", setting.Samples, "samples of the reference for each of them")->check(CLI::PositiveNumber);
  app.add_option("--light-samples", setting.LightSamples, "light points for each march sample")
    ->check(CLI::PositiveNumber);
  app.add_option("--steps", setting.Steps, "march intervals along a ray")->check(CLI::PositiveNumber);
  app.add_option("--depth", setting.Depth, "times an interval may be halved");
  app.add_option("--threshold", setting.Threshold, "difference that halves an interval");
  app.add_option("--repeats", setting.Repeats, "the best time of so many runs")->check(CLI::PositiveNumber);
  app.add_option("--threads", threads, "threads for the images; the reference takes all");
  app.add_option("--cache", folder, "folder that keeps the reference from one run to the next");
  CLI11_PARSE(app, argc, argv);

  try
  {
    std::printf(
      "# %d x %d pixels, %d thread(s), steps %d, depth %d, threshold %g, %d light points a march sample, best of %d "
      "runs\n# seconds: of processor time; they and the rays include surfaces, shaded with 16 light points\n"
      "# error and bias: of the medium term at %d pixels, over its mean, the reference's noise taken off; speed: "
      "BruteForce = 1\n",
      setting.Size, setting.Size, threads, setting.Steps, setting.Depth, setting.Threshold, setting.LightSamples,
      setting.Repeats, setting.Pixels);
    std::printf(
      "%-8s %-24s %7s %8s %7s %8s %8s %12s\n", "scene", "mode", "cones", "seconds", "speed", "error", "bias", "rays");
    for (const std::string& name : scenes)
    {
      const BenchmarkScene scene = LoadBenchmarkScene(name);
      const Room room = BuildRoom(scene, scene.Source.Spectrum.size());
      vtkSMPTools::Initialize(0);
      const std::vector<PixelTruth> truth = Reference(scene, room, setting, folder);

      const auto conesOf = [&](const std::string& set, double fraction)
      {
        ConeParameters parameters = NamedParameters(set);
        parameters.Vectors = vectors;
        parameters.Fraction = fraction;
        return MakeCones(MakeVectors(scene, parameters), parameters).Cones;
      };
      struct Row
      {
        std::string Name;
        ScatteringMode Mode;
        std::vector<Cone> Cones;
      };
      const std::vector<Row> rows = { { "BruteForce", ScatteringMode::BruteForce, {} },
        { "Medium, paper", ScatteringMode::Medium, conesOf("paper", 1.0) },
        { "Medium, bounds", ScatteringMode::Medium, conesOf("bounds", 1.0) },
        { "Fast, paper", ScatteringMode::Fast, conesOf("paper", 1.0) },
        { "Fast, paper, angle x 0.25", ScatteringMode::Fast, conesOf("paper", 0.25) },
        { "no shadow", ScatteringMode::Fast, {} } };

      vtkSMPTools::Initialize(threads);
      const OccluderScene occluders(room.Mesh.View());
      const Medium medium = RoomMedium(scene.Source);
      double brute = 0.0;
      Error error;
      for (const Row& row : rows)
      {
        const ConeHierarchy cones(row.Cones, medium.Bounds);
        ScatteringOptions options;
        options.Mode = row.Mode;
        options.Width = setting.Size;
        options.Height = setting.Size;
        options.Extent = { 0, setting.Size - 1, 0, setting.Size - 1 };
        options.NumberOfSteps = setting.Steps;
        options.MaximumDepth = setting.Depth;
        options.IntensityThreshold = setting.Threshold;
        options.NumberOfLightSamples = setting.LightSamples;
        options.LightVisible = false;
        options.SurfaceReflectance = room.Reflectance;
        options.ReflectanceComponents = static_cast<int>(scene.Source.Spectrum.size());
        ScatteringImage image;
        double seconds = HUGE_VAL;
        for (int run = 0; run < setting.Repeats; ++run)
        {
          const std::clock_t start = std::clock();
          RenderScattering(occluders, scene.Source, medium, RoomCamera(), &cones, options, Monitor(), image);
          seconds = std::min(seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        }
        brute = row.Mode == ScatteringMode::BruteForce ? seconds : brute;
        error = Compare(image, truth, setting.Size);
        std::printf("%-8s %-24s %7zu %8.3f %7.2f %8.4f %8.4f %12lld\n", scene.Name.c_str(), row.Name.c_str(),
          row.Cones.size(), seconds, brute / seconds, error.Rms, error.Bias,
          static_cast<long long>(image.NumberOfOcclusionRays));
        std::fflush(stdout);
      }
      std::printf("# %s: noise of the reference %.4f of the mean a pixel\n", scene.Name.c_str(), error.Reference);
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "scattering-table: %s\n", failure.what());
    return 1;
  }
  return 0;
}
