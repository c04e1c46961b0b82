// SPDX-License-Identifier: BSD-3-Clause
#include "SpeedMeasurement.h"

#include "DarkScenes.h"
#include "PlainMarch.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <list>
#include <memory>
#include <utility>

namespace shadowcones
{
namespace
{
class Measurement
{
public:
  Measurement(const std::string& nameOrFile, const SpeedSetting& setting)
    : Setting(setting)
    , Scene(nameOrFile, setting.Light)
  {
    vtkSMPTools::Initialize(0);
    this->Truth = ReferencePixels(this->Scene, setting.Size, setting.Pixels, setting.Samples, setting.Folder);
  }

  SpeedFigures Run()
  {
    this->AddStages();
    this->AddMarches();
    this->AddEstimators();
    this->AddGrids();
    this->AddLocator();
    this->AddThreads();
    this->Jobs.Run(this->Setting.Repeats, this->Setting.Enough);
    this->CheckPlainMarch();
    return this->Collect();
  }

private:
  /// A mode with its knobs.
  struct Frame
  {
    ModeRow Row;
    ScatteringOptions Options;
    bool UseCones = false;
    int Dimensions = 0; ///< Volume
    int LightSamples = 0;
    int BrickParts = 0;
    VisibilityGrid Grid;
    TimedJobs::Job FrameJob = 0;
    TimedJobs::Job FillJob = 0;
  };

  void Render(const Frame& frame)
  {
    this->Scene.Render(frame.Options, frame.UseCones ? this->Scene.Hierarchy() : nullptr,
      frame.Row.Mode == "Volume" ? &frame.Grid : nullptr, this->Image);
  }

  /// Of the image just rendered.
  void Judge(Frame& frame)
  {
    frame.Row.FrameRays = this->Image.NumberOfOcclusionRays;
    std::vector<double> values;
    for (const PixelTruth& pixel : this->Truth)
    {
      values.push_back(MeanOfPixel(this->Image, static_cast<std::size_t>(pixel.J) * this->Setting.Size + pixel.I));
    }
    frame.Row.Error = Compare(values, this->Truth);
    if (frame.Row.Mode == "BruteForce" && frame.Row.Default)
    {
      for (std::size_t pixel = 0; pixel < this->Image.Depth.size(); ++pixel)
      {
        this->BruteForce.push_back(MeanOfPixel(this->Image, pixel));
      }
    }
  }

  Frame& AddFrame(const std::string& mode, const std::string& knobs, bool isDefault, const ScatteringOptions& options)
  {
    this->Frames.emplace_back();
    Frame& frame = this->Frames.back();
    frame.Row.Mode = mode;
    frame.Row.Knobs = knobs;
    frame.Row.Default = isDefault;
    frame.Options = options;
    frame.UseCones = mode == "Guided";
    return frame;
  }

  void AddFrameJob(Frame& frame)
  {
    frame.FrameJob = this->Jobs.Add(
      frame.Row.Mode + ", " + frame.Row.Knobs, this->Setting.Threads, [this, &frame] { this->Render(frame); },
      [this, &frame] { this->Judge(frame); });
  }

  void AddStages()
  {
    const auto add = [this](const char* name, const std::function<void()>& run) {
      this->StageJobs.push_back({ name, this->Jobs.Add(name, this->Setting.Threads, run) });
    };
    add("occluders", [this] { this->Scene.BuildRoom(); });
    add("vectors", [this] { this->Scene.TraceVectors(this->Setting.Vectors); });
    add("cones", [this] { this->Scene.FitCones(); });
    add("hierarchy", [this] { this->Scene.BuildHierarchy(); });
  }

  void AddMarches()
  {
    const ScatteringOptions options = this->Scene.Options(ScatteringMode::BruteForce, this->Setting.Size);
    const std::pair<int, int> usual{ options.NumberOfSteps, options.NumberOfLightSamples };
    std::vector<std::pair<int, int>> knobs = { { 8, 4 }, { 16, 4 }, { 16, 8 }, { 32, 8 }, usual };
    if (IsDarkScene(this->Scene.Name))
    {
      // Which knobs are best there nobody knows beforehand: all that take no more than a few seconds.
      knobs = { usual };
      for (int steps = 8; steps <= 512; steps *= 2)
      {
        for (int points = 1; points <= 32 && steps * points <= 4096; points *= 2)
        {
          if (usual != std::pair<int, int>{ steps, points })
          {
            knobs.emplace_back(steps, points);
          }
        }
      }
    }
    for (const auto& [steps, points] : knobs)
    {
      ScatteringOptions changed = options;
      changed.NumberOfSteps = steps;
      changed.NumberOfLightSamples = points;
      this->AddFrameJob(this->AddFrame("BruteForce",
        std::to_string(steps) + " steps, " + std::to_string(points) + " light points",
        usual == std::pair<int, int>{ steps, points }, changed));
    }
  }

  /// Guided with cones, and without: the strongest brute force.
  void AddEstimators()
  {
    for (const char* mode : { "Stratified", "Guided" })
    {
      const ScatteringOptions options = this->Scene.Options(ScatteringMode::Guided, this->Setting.Size);
      const auto add = [&](double goal, int samples, bool isDefault)
      {
        ScatteringOptions changed = options;
        changed.RelativeErrorGoal = goal;
        changed.MaximumSamples = samples;
        char knobs[60];
        std::snprintf(
          knobs, sizeof(knobs), goal > 0.0 ? "goal %g, at most %d samples" : "goal %g: %d samples", goal, samples);
        this->AddFrameJob(this->AddFrame(mode, knobs, isDefault, changed));
      };
      add(options.RelativeErrorGoal, options.MaximumSamples, true);
      for (const double goal : { 0.16, 0.08, 0.04, 0.02 })
      {
        add(goal, options.MaximumSamples, false);
      }
      for (const int samples : { 8, 16, 32, 64, 128, 256, 512 })
      {
        add(0.0, samples, false);
      }
    }
  }

  void AddGrid(int dimensions, int lightSamples, int brickParts, bool isDefault)
  {
    const std::string knobs = std::to_string(dimensions) + "^3, " + std::to_string(lightSamples) + " light points, " +
      (brickParts > 1 ? "bricks of " + std::to_string(brickParts) : std::string("no bricks"));
    Frame& frame =
      this->AddFrame("Volume", knobs, isDefault, this->Scene.Options(ScatteringMode::Volume, this->Setting.Size));
    frame.Dimensions = dimensions;
    frame.LightSamples = lightSamples;
    frame.BrickParts = brickParts;
    frame.FillJob = this->Jobs.Add("fill, " + knobs, this->Setting.Threads, [this, &frame] { this->Fill(frame); });
    this->AddFrameJob(frame);
  }

  void Fill(Frame& frame) const
  {
    frame.Grid = this->Scene.FillGrid(frame.Dimensions, frame.LightSamples, frame.BrickParts);
    frame.Row.FillRays = frame.Grid.NumberOfOcclusionRays;
  }

  void AddGrids()
  {
    for (const int dimensions : { 33, 49, 65, 97, 129 })
    {
      for (const int lightSamples : { 8, 16, 32 })
      {
        this->AddGrid(dimensions, lightSamples, 2, dimensions == 65 && lightSamples == 16);
      }
    }
    this->AddGrid(33, 16, 4, false);
    this->AddGrid(65, 16, 1, false);
    this->AddGrid(65, 16, 4, false);

    this->Nothing.Origin = this->Scene.Medium.Bounds.Min;
    this->Nothing.Spacing = (1.0 / 64.0) * this->Scene.Medium.Bounds.Size();
    this->Nothing.Dimensions = { 65, 65, 65 };
    this->Nothing.Visibility.assign(65 * 65 * 65, 1.0f);
    this->Nothing.ShadowClasses.assign(65 * 65 * 65, 0);
    this->Nothing.Marked.assign(65 * 65 * 65, 0);
    this->UnshadowedJob = this->Jobs.Add("unshadowed frame", this->Setting.Threads,
      [this]
      {
        this->Scene.Render(
          this->Scene.Options(ScatteringMode::Volume, this->Setting.Size), nullptr, &this->Nothing, this->Image);
      });
  }

  void AddLocator()
  {
    const int stride = std::min(this->Setting.LocatorStride, std::max(1, this->Setting.Size / 16));
    this->LocatorBuildJob = this->Jobs.Add("locator", this->Setting.Threads,
      [this] { this->Locator = std::make_unique<LocatorScene>(this->Scene.Room.View()); });
    const ScatteringOptions options = this->Scene.Options(ScatteringMode::BruteForce, this->Setting.Size);
    this->LocatorMarchJob = this->Jobs.Add("march with the locator", this->Setting.Threads,
      [this, options, stride]
      { this->ByLocator = MarchWithLocator(this->Scene.View(), *this->Locator, options, stride); });
    this->EmbreeMarchJob = this->Jobs.Add("the same march with Embree", this->Setting.Threads,
      [this, options, stride] { this->ByEmbree = MarchWithEmbree(this->Scene.View(), options, stride); });
  }

  void AddThreads()
  {
    if (this->Setting.Threads < 2)
    {
      return;
    }
    for (const char* mode : { "BruteForce", "Stratified", "Guided", "Volume" })
    {
      Frame& frame = this->DefaultFrame(mode);
      this->OneThreadJobs.push_back(
        { mode, this->Jobs.Add(std::string(mode) + ", one thread", 1, [this, &frame] { this->Render(frame); }),
          frame.FrameJob });
    }
    Frame& volume = this->DefaultFrame("Volume");
    this->OneThreadJobs.push_back(
      { "fill", this->Jobs.Add("fill, one thread", 1, [this, &volume] { this->Fill(volume); }), volume.FillJob });
    for (const NamedJob& stage : this->StageJobs)
    {
      if (stage.Name == "vectors" || stage.Name == "cones")
      {
        const bool vectors = stage.Name == "vectors";
        this->OneThreadJobs.push_back({ stage.Name,
          this->Jobs.Add(stage.Name + ", one thread", 1,
            [this, vectors] { vectors ? this->Scene.TraceVectors(this->Setting.Vectors) : this->Scene.FitCones(); }),
          stage.Job });
      }
    }
  }

  Frame& DefaultFrame(const std::string& mode)
  {
    return *std::find_if(this->Frames.begin(), this->Frames.end(),
      [&](const Frame& frame) { return frame.Row.Mode == mode && frame.Row.Default; });
  }

  /// All pixels by the plain march with Embree: values and rays must be those of BruteForce.
  void CheckPlainMarch()
  {
    vtkSMPTools::Initialize(this->Setting.Threads);
    const Frame& brute = this->DefaultFrame("BruteForce");
    const PlainImage plain = MarchWithEmbree(this->Scene.View(), brute.Options, 1);
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < plain.Pixels.size(); ++k)
    {
      const double value = this->BruteForce[static_cast<std::size_t>(plain.Pixels[k])];
      largest = std::max(largest, std::fabs(value - plain.Values[k]));
      sum += value;
    }
    this->Figures.Locator.EmbreeDifference = largest / (sum / static_cast<double>(plain.Pixels.size()));
    this->Figures.Locator.EmbreeRays = plain.NumberOfOcclusionRays;
  }

  SpeedFigures Collect()
  {
    SpeedFigures& figures = this->Figures;
    figures.Scene = this->Scene.Name;
    figures.Size = this->Setting.Size;
    figures.Threads = this->Setting.Threads;
    figures.Triangles = this->Scene.NumberOfTriangles();
    figures.Photons = this->Scene.NumberOfPhotons();
    figures.Vectors = this->Scene.NumberOfVectors();
    figures.Cones = static_cast<vtkIdType>(this->Scene.Cones().size());
    for (const NamedJob& stage : this->StageJobs)
    {
      figures.Stages.push_back({ stage.Name, this->Jobs.Of(stage.Job), 0 });
    }
    for (Frame& frame : this->Frames)
    {
      frame.Row.Frame = this->Jobs.Of(frame.FrameJob);
      frame.Row.Fill = frame.Row.Mode == "Volume" ? this->Jobs.Of(frame.FillJob) : JobTime();
      figures.ReferenceNoise = frame.Row.Error.Reference;
      figures.SmallestError = frame.Row.Error.Smallest;
      figures.Rows.push_back(frame.Row);
    }
    this->CollectLocator();
    figures.Unshadowed = this->Jobs.Of(this->UnshadowedJob);
    for (const ThreadsJob& job : this->OneThreadJobs)
    {
      figures.Threading.push_back({ job.Name, this->Jobs.Of(job.One), this->Jobs.Of(job.Many) });
    }
    return figures;
  }

  void CollectLocator()
  {
    LocatorFigures& locator = this->Figures.Locator;
    locator.Build = this->Jobs.Of(this->LocatorBuildJob);
    locator.March = this->Jobs.Of(this->LocatorMarchJob);
    locator.EmbreeMarch = this->Jobs.Of(this->EmbreeMarchJob);
    locator.Pixels = static_cast<double>(this->ByLocator.Pixels.size());
    locator.OfPixels = static_cast<double>(this->Setting.Size) * this->Setting.Size;
    double squares = 0.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < this->ByLocator.Pixels.size(); ++k)
    {
      const double value = this->BruteForce[static_cast<std::size_t>(this->ByLocator.Pixels[k])];
      squares += std::pow(value - this->ByLocator.Values[k], 2);
      sum += value;
    }
    locator.Difference = std::sqrt(squares / locator.Pixels) / (sum / locator.Pixels);
  }

  struct NamedJob
  {
    std::string Name;
    TimedJobs::Job Job;
  };
  struct ThreadsJob
  {
    std::string Name;
    TimedJobs::Job One;
    TimedJobs::Job Many;
  };

  const SpeedSetting& Setting;
  BenchmarkScene Scene;
  std::vector<PixelTruth> Truth;
  TimedJobs Jobs;
  std::list<Frame> Frames; ///< a list: jobs refer to its items
  std::vector<NamedJob> StageJobs;
  std::vector<ThreadsJob> OneThreadJobs;
  std::unique_ptr<LocatorScene> Locator;
  PlainImage ByLocator;
  PlainImage ByEmbree;
  VisibilityGrid Nothing;
  ScatteringImage Image;          ///< of the last frame
  std::vector<double> BruteForce; ///< its image by default, mean over wavelengths
  TimedJobs::Job LocatorBuildJob = 0;
  TimedJobs::Job LocatorMarchJob = 0;
  TimedJobs::Job EmbreeMarchJob = 0;
  TimedJobs::Job UnshadowedJob = 0;
  SpeedFigures Figures;
};
} // namespace

//------------------------------------------------------------------------------
SpeedFigures MeasureSpeed(const std::string& nameOrFile, const SpeedSetting& setting)
{
  return Measurement(nameOrFile, setting).Run();
}

} // namespace shadowcones
