// SPDX-License-Identifier: BSD-3-Clause
// What the pipeline costs beside the estimators: frames of a prepared scene, grids that are read, probes, threads, memory.
//
//   frames    a sphere of many triangles in a lit room: the first image, further cameras, another exposure
//   volume    a visibility volume of many points read by a further frame
//   probe     20,000 points of 64 light samples
//   rising    pictures of rising quality: how soon, and how near
//   umbra     the joint umbra of many discs on grids
//   first     the first image of a body from its mesh on, with cones and without
//   fog       images with a density image over those without
//   dark      Guided where most is dark: time at an error
//   pixels    a Guided image of the sphere at growing sizes: how time grows with pixels, and whether claims hold
//   threads   each stage on one and on two threads, and its loops replayed item by item on more
//   memory    bytes of what is kept and the largest memory of each stage, against its formula
#include "BenchmarkScene.h"
#include "ErrorCurve.h"
#include "DarkSpeed.h"
#include "FirstImage.h"
#include "FogSpeed.h"
#include "ProgramOptions.h"
#include "SphereRoom.h"
#include "StageMemory.h"
#include "ThreadReplay.h"

#include "scRandom.h"
#include "scUmbraField.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkConeSetProbe.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "vtkAreaLightSource.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{
/// Of all threads together: what a busy machine does not change.
double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void MeasureFrames(double triangles, int size)
{
  SphereRoom room(triangles);
  room.Volume->SetDimensions(65, 65, 65);
  const double fill = SecondsOf([&] { room.Volume->Update(); });
  room.Image->SetResolution(size, size);
  const double first = room.Frame();
  const double processor = ProcessorSeconds();
  const double further = room.MedianOfFrames(9);
  const double used = (ProcessorSeconds() - processor) / 9.0;
  const vtkIdType rays = room.Image->GetNumberOfRaysSent();
  const double exposed = SecondsOf(
    [&]
    {
      room.Image->AutoExposureOff();
      room.Image->SetExposure(2.0);
      room.Image->Update();
    });
  std::printf("frames: %lld triangles, Volume, %d x %d: volume filled %.3f s, first image %.3f s, further ones %.4f s "
              "(processor %.4f s), another exposure %.4f s and %lld rays; %lld preparations; kept %.1f MB\n",
    static_cast<long long>(room.Mesh->GetNumberOfCells()), size, size, fill, first, further, used, exposed,
    static_cast<long long>(room.Image->GetNumberOfRaysSent() - rays),
    static_cast<long long>(room.Image->GetNumberOfPreparations()),
    static_cast<double>(room.Image->GetPreparedMemory()) * 1e-6);
  std::fflush(stdout);
}

void MeasureVolume(int points)
{
  SphereRoom room(2000.0);
  room.Volume->SetDimensions(points, points, points);
  room.Volume->SetNumberOfLightSamples(1);
  room.Volume->SetBrickParts(1);
  room.Volume->Update();
  room.Image->SetResolution(64, 64);
  const double first = room.Frame();
  const double further = room.MedianOfFrames(5);
  std::printf("volume: %d^3 points, 64 x 64: first image %.3f s, further ones %.4f s\n", points, first, further);
  std::fflush(stdout);
}

void MeasureProbe(const std::string& name, int points, int samples)
{
  const BenchmarkScene scene(name);
  vtkNew<vtkPoints> where;
  for (int k = 0; k < points; ++k)
  {
    const auto at = [k](int base)
    {
      double value = 0.0;
      double digit = 1.0;
      for (int rest = k + 1; rest > 0; rest /= base)
      {
        digit /= base;
        value += digit * (rest % base);
      }
      return value;
    };
    where->InsertNextPoint(5.4 * at(2) - 2.7, 5.1 * at(3), 5.4 * at(5) - 2.7);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(where);
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(0.0, 5.49, 0.0);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.5);
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(data);
  probe->SetLightConnection(light->GetOutputPort());
  probe->SetMeshData(scene.Occluders);
  probe->SetMethodToExact();
  probe->SetNumberOfLightSamples(samples);
  const double first = SecondsOf([&] { probe->Update(); });
  const double processor = ProcessorSeconds();
  std::vector<double> seconds;
  for (int k = 0; k < 5; ++k)
  {
    probe->Modified();
    seconds.push_back(SecondsOf([&] { probe->Update(); }));
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf("probe: %s, %d points x %d: first %.3f s, again %.3f s (processor %.3f s)\n", name.c_str(), points,
    samples, first, seconds[2], (ProcessorSeconds() - processor) / 5.0);
  std::fflush(stdout);
}
/// How soon a window has something to show, and how far it is from the image.
void MeasureRising(int size)
{
  SphereRoom room(2000.0);
  room.Image->SetModeToGuided();
  room.Image->SetResolution(size, size);
  room.Image->ProgressiveOn();
  room.Image->Update(); // the search tree is there
  struct Seen
  {
    double Start = 0.0;
    std::vector<double> Seconds;
    std::vector<std::vector<float>> Values;
    vtkScatteringImageFilter* Image = nullptr;
  } seen;
  const auto valuesOf = [](vtkImageData* picture)
  {
    auto* values = vtkFloatArray::SafeDownCast(picture->GetPointData()->GetArray("InScattering"));
    return std::vector<float>(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues());
  };
  seen.Image = room.Image;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&seen);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* all = static_cast<Seen*>(data);
      all->Seconds.push_back(Now() - all->Start);
      auto* values =
        vtkFloatArray::SafeDownCast(all->Image->GetPicture()->GetPointData()->GetArray("InScattering"));
      all->Values.emplace_back(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues());
    });
  room.Image->AddObserver(vtkCommand::UpdateDataEvent, command);
  seen.Start = Now();
  room.Frame();
  const double last = Now() - seen.Start;
  const std::vector<float> image = valuesOf(room.Image->GetOutput());
  for (std::size_t k = 0; k < seen.Seconds.size(); ++k)
  {
    double squares = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i)
    {
      squares += std::pow(static_cast<double>(seen.Values[k][i]) - static_cast<double>(image[i]), 2.0);
      sum += static_cast<double>(image[i]);
    }
    const auto count = static_cast<double>(image.size());
    std::printf("rising: Guided, %d x %d: picture %zu after %.3f s, %.1f %% from the image, which took %.3f s\n", size,
      size, k + 1, seen.Seconds[k], 100.0 * std::sqrt(squares / count) / (sum / count), last);
  }
  std::fflush(stdout);
}

/// Discs side by side under the lamp, as many along each side.
std::vector<Cone> SheetOfDiscs(int side)
{
  std::vector<Cone> discs;
  for (int k = 0; k < side * side; ++k)
  {
    Cone disc;
    disc.Center = { 4.0 * (k % side + 0.5) / side - 2.0, 3.5, 4.0 * (k / side + 0.5) / side - 2.0 };
    disc.Axis = { 0.0, -1.0, 0.0 };
    disc.Normal = { 0.0, 1.0, 0.0 };
    disc.BaseRadius = 1.6 / side;
    discs.push_back(disc);
  }
  return discs;
}

/// The joint umbra of discs that hang side by side, on grids: of a box, and of a thin part of it at the finest resolution.
void MeasureUmbra()
{
  Light light;
  light.Shape = LightShape::Disc;
  light.Center = { 0.0, 5.49, 0.0 };
  light.Normal = { 0.0, -1.0, 0.0 };
  light.Radius = 0.2;
  light.Spectrum = { 1.0 };
  PrepareLight(light);
  const struct
  {
    int Resolution;
    Box Region;
  } grids[] = { { 64, { { -2.5, 1.0, -2.5 }, { 2.5, 3.5, 2.5 } } },
    { 1024, { { -2.5, 2.5, -0.05 }, { 2.5, 2.6, 0.05 } } } };
  for (const auto& of : grids)
  {
    const RegularGrid grid = GridOver(of.Region, of.Resolution);
    std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
    std::vector<double> counts;
    std::vector<double> seconds;
    for (const int side : { 10, 20, 40 })
    {
      const UmbraField field(SheetOfDiscs(side), light, 10.0, of.Region);
      const double processor = ProcessorSeconds();
      field.Sample(grid, of.Region, {}, values.data());
      counts.push_back(side * side);
      seconds.push_back(ProcessorSeconds() - processor);
      std::printf("umbra: resolution %d, %lld points, %d discs: processor %.3f s\n", of.Resolution,
        static_cast<long long>(grid.NumberOfPoints()), side * side, seconds.back());
      std::fflush(stdout);
    }
    std::printf("umbra: resolution %d: time grows as the number of discs to the power of %.2f\n", of.Resolution,
      GrowthExponent(counts, seconds));
    std::fflush(stdout);
  }
}

/// Of pixels at random: by how much the image differs from a finer one of another seed, over what both claim, and how
/// much of its light that is.
void JudgePixels(SphereRoom& room, int size, int pixels)
{
  const auto arrayOf = [&room](const char* name)
  { return vtkFloatArray::SafeDownCast(room.Image->GetOutput()->GetPointData()->GetArray(name)); };
  struct Pixel
  {
    int I = 0;
    int J = 0;
    double Value = 0.0;
    double Claim = 0.0;
  };
  std::vector<Pixel> of;
  RandomStream random(7, static_cast<std::uint64_t>(size));
  for (int k = 0; k < pixels; ++k)
  {
    Pixel pixel;
    pixel.I = static_cast<int>(random.Next() * size);
    pixel.J = static_cast<int>(random.Next() * size);
    const vtkIdType index = static_cast<vtkIdType>(pixel.J) * size + pixel.I;
    pixel.Value = static_cast<double>(arrayOf("InScattering")->GetComponent(index, 0));
    pixel.Claim = pixel.Value * arrayOf("RelativeError")->GetComponent(index, 0);
    of.push_back(pixel);
  }
  const double goal = room.Image->GetRelativeErrorGoal();
  const int most = room.Image->GetMaximumSamples();
  room.Image->SetRelativeErrorGoal(0.0); // every pixel on its own
  room.Image->SetMaximumSamples(1 << 15);
  room.Image->SetSeed(4711);
  double ratios = 0.0;
  double errors = 0.0;
  double within = 0.0;
  int count = 0;
  for (const Pixel& pixel : of)
  {
    const int extent[6] = { pixel.I, pixel.I, pixel.J, pixel.J, 0, 0 };
    room.Image->UpdateExtent(extent);
    const double truth = arrayOf("InScattering")->GetComponent(0, 0);
    const double error = truth * arrayOf("RelativeError")->GetComponent(0, 0);
    if (truth > 0.0 && pixel.Value > 0.0)
    {
      const double ratio = (pixel.Value - truth) / std::hypot(pixel.Claim, error);
      ratios += ratio * ratio;
      within += std::fabs(ratio) <= 2.0 ? 1.0 : 0.0;
      errors += std::pow(pixel.Value / truth - 1.0, 2.0);
      count += 1;
    }
  }
  std::printf("pixels: %d of %d x %d at random: error %.2f %%, %.2f of the claims, %.1f %% within two of them\n", count, size,
    size, 100.0 * std::sqrt(errors / count), std::sqrt(ratios / count), 100.0 * within / count);
  std::fflush(stdout);
  room.Image->SetRelativeErrorGoal(goal);
  room.Image->SetMaximumSamples(most);
  room.Image->SetSeed(1);
}

/// A Guided image, another camera on a scene that stands, at sizes that double. Time grows as the number of pixels to the
/// exponent that is printed.
void MeasurePixels(double triangles, int smallest, int largest, int judged)
{
  SphereRoom room(triangles);
  room.Image->SetModeToGuided();
  room.Image->AutoExposureOff(); // single pixels ask for no others
  room.Image->SetResolution(8, 8);
  room.Image->Update(); // the search tree is there
  std::vector<double> counts;
  std::vector<double> times;
  for (int size = smallest; size <= largest; size *= 2)
  {
    room.Image->SetResolution(size, size);
    const double start = ProcessorSeconds();
    const vtkIdType rays = room.Image->GetNumberOfRaysSent();
    const double seconds = room.Frame();
    times.push_back(ProcessorSeconds() - start);
    counts.push_back(static_cast<double>(size) * size);
    const vtkIdType sent = room.Image->GetNumberOfRaysSent() - rays;
    std::printf("pixels: %lld triangles, Guided, %d x %d: %.3f s, processor %.3f s, %.1f rays a pixel\n",
      static_cast<long long>(room.Mesh->GetNumberOfCells()), size, size, seconds, times.back(),
      static_cast<double>(sent) / counts.back());
    std::fflush(stdout);
    if (judged > 0)
    {
      JudgePixels(room, size, judged);
    }
  }
  if (times.size() > 1)
  {
    std::printf("pixels: processor time grows as their number to the power of %.2f\n", GrowthExponent(counts, times));
  }
}
} // namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("What the pipeline costs beside the estimators.");
  std::vector<std::string> rows{ "frames", "volume", "probe", "rising", "umbra", "memory", "first", "fog", "dark", "pixels", "threads" };
  double triangles = 1e6;
  int size = 256;
  int points = 257;
  int largest = 1024;
  int judged = 200;
  std::string scene = "chair";
  std::string folder = ".";
  commandLine.Add("--rows", rows, "frames, volume, probe, rising, umbra, memory, first, fog, dark, pixels, threads");
  commandLine.Add("--triangles", triangles, "of the sphere");
  commandLine.Add("--size", size, "width and height of images, pixels");
  commandLine.Add("--largest", largest, "width and height of the largest image for pixels");
  commandLine.Add("--judged", judged, "pixels of each image whose claims are checked, for pixels");
  commandLine.Add("--points", points, "of a volume along a side");
  commandLine.Add("--scene", scene, "chair, tree, blob or a mesh file, for probes, threads and first images");
  commandLine.Add("--cache", folder, "folder that keeps references for dark from one run to the next");
  std::vector<std::string> stages = threadStages;
  commandLine.AddChoice("--stages", stages, "stages for threads", threadStages);
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    for (const std::string& row : rows)
    {
      if (row == "frames")
      {
        MeasureFrames(triangles, size);
      }
      else if (row == "volume")
      {
        MeasureVolume(points);
      }
      else if (row == "probe")
      {
        MeasureProbe(scene, 20000, 64);
      }
      else if (row == "rising")
      {
        MeasureRising(size);
      }
      else if (row == "umbra")
      {
        MeasureUmbra();
      }
      else if (row == "memory")
      {
        MeasureMemory(triangles);
      }
      else if (row == "first")
      {
        MeasureFirstImages(scene, std::min(size, 128), 3);
      }
      else if (row == "fog")
      {
        MeasureFog(64, 3);
      }
      else if (row == "dark")
      {
        MeasureDark(folder);
      }
      else if (row == "pixels")
      {
        MeasurePixels(triangles, size, largest, judged);
      }
      else if (row == "threads")
      {
        MeasureThreads(scene, size, stages);
      }
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "pipeline-speed: %s\n", failure.what());
    return 1;
  }
  return 0;
}
