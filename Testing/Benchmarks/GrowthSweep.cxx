// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthSweep.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <list>
#include <memory>
#include <stdexcept>

namespace shadowcones
{
namespace
{
/// A bumpy sphere of about so many triangles, in a file.
std::string WriteBumpySphere(double triangles, const std::string& folder)
{
  const int across = std::max(4, static_cast<int>(std::lround(std::sqrt(triangles))));
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(across);
  source->SetPhiResolution(across / 2 + 1);
  source->Update();
  vtkPolyData* sphere = source->GetOutput();
  vtkPoints* points = sphere->GetPoints();
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
  {
    double p[3];
    points->GetPoint(k, p);
    const double factor = 1.0 + 0.2 * std::sin(14.0 * p[0]) * std::sin(14.0 * p[1]) * std::sin(14.0 * p[2]);
    points->SetPoint(k, factor * p[0], factor * p[1], factor * p[2]);
  }
  sphere->GetPointData()->SetNormals(nullptr);
  const std::string file = folder + "/bumpy-sphere-" + std::to_string(across) + ".vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(sphere);
  if (!writer->Write())
  {
    throw std::runtime_error("Cannot write '" + file + "'.");
  }
  return file;
}

/// One value of a parameter: a scene of its own and jobs for its stages.
class Sample
{
public:
  Sample(const std::string& nameOrFile, const SpeedSetting& setting, TimedJobs& jobs)
    : Setting(setting)
    , Scene(nameOrFile, setting.Light)
    , Jobs(jobs)
  {
    this->Add("occluders", [this] { this->Scene.BuildRoom(); });
    this->Add("vectors", [this] { this->Scene.TraceVectors(this->Setting.Vectors); });
    this->Add("cones", [this] { this->Scene.FitCones(); });
    this->Add("hierarchy", [this] { this->Scene.BuildHierarchy(); });
    this->Add("fill", [this] { this->Grid = this->Scene.FillGrid(65, 16, 2); });
    this->Add("BruteForce", [this] { this->Render(ScatteringMode::BruteForce, nullptr); });
    this->Add("Stratified", [this] { this->Render(ScatteringMode::Guided, nullptr); });
    this->Add("Guided", [this] { this->Render(ScatteringMode::Guided, this->Scene.Hierarchy()); });
    this->Add("Volume", [this] { this->Render(ScatteringMode::Volume, nullptr); });
  }

  struct Stage
  {
    std::string Name;
    TimedJobs::Job Job;
  };
  const std::vector<Stage>& Stages() const { return this->List; }
  double Triangles() const { return static_cast<double>(this->Scene.NumberOfTriangles()); }
  double Photons() const { return static_cast<double>(this->Scene.NumberOfPhotons()); }
  double Cones() const { return static_cast<double>(this->Scene.Cones().size()); }

private:
  void Add(const char* name, const std::function<void()>& run)
  {
    this->List.push_back({ name, this->Jobs.Add(this->Scene.Name + ", " + name, this->Setting.Threads, run) });
  }
  void Render(ScatteringMode mode, const ConeHierarchy* cones)
  {
    this->Scene.Render(this->Scene.Options(mode, this->Setting.Size), cones,
      mode == ScatteringMode::Volume ? &this->Grid : nullptr, this->Image);
  }

  const SpeedSetting Setting;
  BenchmarkScene Scene;
  TimedJobs& Jobs;
  VisibilityGrid Grid;
  ScatteringImage Image;
  std::vector<Stage> List;
};

/// What the same runs are listed by. Without valueOf: the values that were set.
struct Measure
{
  std::string Parameter;
  std::function<double(const Sample&)> ValueOf;
};

/// @param change sets the parameter and gives the scene's name.
void Sweep(const std::vector<Measure>& measures, const std::vector<double>& values, const SpeedSetting& setting,
  const std::function<std::string(double, SpeedSetting&)>& change, std::vector<Growth>& list)
{
  TimedJobs jobs;
  std::list<Sample> samples;
  for (const double value : values)
  {
    SpeedSetting changed = setting;
    const std::string name = change(value, changed);
    samples.emplace_back(name, changed, jobs);
  }
  jobs.Run(setting.Repeats, setting.Enough);
  const std::size_t stages = samples.front().Stages().size();
  for (const Measure& measure : measures)
  {
    const Clock clock = measure.Parameter == "threads" ? Clock::Wall : Clock::Processor;
    for (std::size_t stage = 0; stage < stages; ++stage)
    {
      Growth growth;
      growth.Parameter = measure.Parameter;
      growth.Stage = samples.front().Stages()[stage].Name;
      std::size_t k = 0;
      for (const Sample& sample : samples)
      {
        growth.Values.push_back(measure.ValueOf ? measure.ValueOf(sample) : values[k]);
        growth.Seconds.push_back(std::max(1e-9, jobs.Of(sample.Stages()[stage].Job).By(clock)));
        ++k;
      }
      list.push_back(growth);
    }
  }
}
} // namespace

//------------------------------------------------------------------------------
std::vector<Growth> MeasureGrowth(const std::string& nameOrFile, const SpeedSetting& setting)
{
  std::vector<Growth> list;
  const auto same = [&](const std::function<void(double, SpeedSetting&)>& set)
  {
    return [&nameOrFile, set](double value, SpeedSetting& changed)
    {
      set(value, changed);
      return nameOrFile;
    };
  };
  Sweep({ { "pixels along a side", {} } }, { 64, 128, 256, 512 }, setting,
    same([](double value, SpeedSetting& changed) { changed.Size = static_cast<int>(value); }), list);
  Sweep({ { "light radius", {} } }, { 0.1, 0.2, 0.4, 1.0 }, setting,
    same([](double value, SpeedSetting& changed) { changed.Light.Radius = value; }), list);
  Sweep({ { "photons", [](const Sample& sample) { return sample.Photons(); } },
          { "cones", [](const Sample& sample) { return sample.Cones(); } } },
    { 1000, 5800, 20000, 80000 }, setting,
    same([](double value, SpeedSetting& changed) { changed.Vectors = static_cast<vtkIdType>(value); }), list);
  std::vector<std::string> files;
  Sweep({ { "triangles", [](const Sample& sample) { return sample.Triangles(); } } }, { 1e2, 1e3, 1e4, 1e5, 1e6 }, setting,
    [&files](double value, SpeedSetting& changed)
    {
      files.push_back(WriteBumpySphere(value, changed.Folder));
      return files.back();
    },
    list);
  for (const std::string& file : files)
  {
    std::remove(file.c_str());
  }
  if (setting.Threads > 1)
  {
    std::vector<double> threads;
    for (int count = 1; count < setting.Threads; count *= 2)
    {
      threads.push_back(count);
    }
    threads.push_back(setting.Threads);
    Sweep({ { "threads", {} } }, threads, setting,
      same([](double value, SpeedSetting& changed) { changed.Threads = static_cast<int>(value); }), list);
  }
  return list;
}

//------------------------------------------------------------------------------
void PrintGrowth(const std::string& scene, const std::vector<Growth>& list)
{
  std::printf("%s: seconds of a stage at values of a parameter; time grows as the parameter to the exponent\n"
              "  (of the processor, for threads by the wall clock; triangles: of a bumpy sphere instead of the scene)\n",
    scene.c_str());
  std::string parameter;
  for (const Growth& growth : list)
  {
    if (growth.Parameter != parameter)
    {
      parameter = growth.Parameter;
      std::printf("  %-20s", parameter.c_str());
      for (const double value : growth.Values)
      {
        std::printf(" %9g", value);
      }
      std::printf("  exponent\n");
    }
    std::printf("    %-18s", growth.Stage.c_str());
    for (const double seconds : growth.Seconds)
    {
      std::printf(" %9.4f", seconds);
    }
    std::printf(" %9.2f\n", growth.Exponent());
  }
  std::printf("\n");
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void WriteGrowth(const std::vector<Growth>& list, JsonWriter& json)
{
  json.BeginList("growth");
  for (const Growth& growth : list)
  {
    json.BeginObject();
    json.Write("parameter", growth.Parameter);
    json.Write("stage", growth.Stage);
    json.BeginList("values");
    for (const double value : growth.Values)
    {
      json.Write("", value);
    }
    json.EndList();
    json.BeginList("seconds");
    for (const double seconds : growth.Seconds)
    {
      json.Write("", seconds);
    }
    json.EndList();
    json.Write("exponent", growth.Exponent());
    json.EndObject();
  }
  json.EndList();
}

} // namespace shadowcones
