// SPDX-License-Identifier: BSD-3-Clause
#include "SpeedReport.h"

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace shadowcones
{
namespace
{
void PrintTime(const char* name, const JobTime& time, const char* more = "")
{
  std::printf("  %-34s %9.4f %9.4f %4d%s\n", name, time.Seconds, time.ProcessorSeconds, time.Runs, more);
}

void PrintStages(const SpeedFigures& figures)
{
  std::printf("  %-34s %9s %9s %4s\n", "stage", "seconds", "processor", "runs");
  for (const Stage& stage : figures.Stages)
  {
    PrintTime(stage.Name.c_str(), stage.Time);
  }
  PrintTime("unshadowed frame", figures.Unshadowed);
  const LocatorFigures& locator = figures.Locator;
  char more[160];
  std::snprintf(more, sizeof(more), "  (%.0f of %.0f pixels: %.3f s an image; differs from BruteForce by %.1e)",
    locator.Pixels, locator.OfPixels, locator.SecondsOfImage(Clock::Wall), locator.Difference);
  PrintTime("locator", locator.Build);
  PrintTime("march with the locator", locator.March, more);
  std::snprintf(more, sizeof(more),
    "  (%.3f s an image; all pixels: %lld rays, differ from BruteForce by %.1e at most)",
    locator.EmbreeMarch.Seconds * locator.OfPixels / locator.Pixels, static_cast<long long>(locator.EmbreeRays),
    locator.EmbreeDifference);
  PrintTime("the same march with Embree", locator.EmbreeMarch, more);
}

void PrintRows(const SpeedFigures& figures)
{
  std::printf("  %-11s %-36s %8s %8s %9s %4s %11s %11s %8s %8s\n", "mode", "knobs", "fill s", "frame s", "processor",
    "runs", "fill rays", "frame rays", "error", "bias");
  for (const ModeRow& row : figures.Rows)
  {
    std::printf("%c %-11s %-36s %8.4f %8.4f %9.4f %4d %11lld %11lld %8.5f %8.5f\n", row.Default ? '*' : ' ',
      row.Mode.c_str(), row.Knobs.c_str(), row.Fill.Seconds, row.Frame.Seconds,
      row.Fill.ProcessorSeconds + row.Frame.ProcessorSeconds, row.Frame.Runs, static_cast<long long>(row.FillRays),
      static_cast<long long>(row.FrameRays), row.Error.Rms, row.Error.Bias);
  }
}

std::string TimeText(const TimeAtError& time)
{
  if (!time.IsKnown())
  {
    return "not reached";
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%s%.4f", time.Is == TimeAtError::AtMost ? "<= " : "", time.Seconds);
  return text;
}

std::string RatioText(const Comparison* comparison)
{
  if (!comparison || !comparison->IsKnown())
  {
    return "-";
  }
  // A time that is an upper bound leaves the ratio open to one side.
  const bool ours = comparison->Time.Is == TimeAtError::AtMost;
  const bool theirs = comparison->Baseline.Is == TimeAtError::AtMost;
  char text[32];
  std::snprintf(text, sizeof(text), "%s%.2f",
    ours && theirs ? "~ "
      : ours       ? ">= "
      : theirs     ? "<= "
                   : "",
    comparison->AtMost ? 1.0 / comparison->Ratio() : comparison->Ratio());
  return text;
}

std::string VerdictOf(const Comparison& comparison)
{
  if (!(comparison.Wanted > 0.0))
  {
    return "";
  }
  char text[40];
  std::snprintf(text, sizeof(text), "%s %g: %s", comparison.AtMost ? "at most" : "at least", comparison.Wanted,
    !comparison.IsKnown()  ? "not known"
      : comparison.IsMet() ? "met"
                           : "NOT MET");
  return text;
}

/// Share of the time that one-thread jobs had a processor for themselves.
double ShareOfProcessor(const SpeedFigures& figures)
{
  double processor = 0.0;
  double wall = 0.0;
  for (const ThreadsRow& row : figures.Threading)
  {
    processor += row.One.ProcessorSeconds;
    wall += row.One.Seconds;
  }
  return wall > 0.0 ? processor / wall : 1.0;
}

void PrintComparisons(const SpeedFigures& figures)
{
  std::printf("  %-42s %8s %-11s %12s %12s %9s %9s  %s\n", "at equal error", "error", "by", "seconds", "baseline",
    "ratio", "processor", "wanted");
  const std::vector<Comparison> byProcessor = CompareAtEqualError(figures, Clock::Processor);
  std::size_t k = 0;
  for (const Comparison& c : CompareAtEqualError(figures, Clock::Wall))
  {
    const Comparison* other = k < byProcessor.size() ? &byProcessor[k] : nullptr;
    ++k;
    char error[16] = "-";
    if (c.Error > 0.0)
    {
      std::snprintf(error, sizeof(error), "%.5f", c.Error);
    }
    std::printf("  %-42s %8s %-11s %12s %12s %9s %9s  %s\n", c.Name.c_str(), error, c.Ours.c_str(),
      TimeText(c.Time).c_str(), TimeText(c.Baseline).c_str(), RatioText(&c).c_str(), RatioText(other).c_str(),
      VerdictOf(c).c_str());
  }
}

void WriteTime(const std::string& key, const JobTime& time, JsonWriter& json)
{
  json.BeginObject(key);
  json.Write("seconds", time.Seconds);
  json.Write("processor_seconds", time.ProcessorSeconds);
  json.Write("runs", time.Runs);
  json.EndObject();
}

void WriteTimeAtError(const std::string& key, const TimeAtError& time, JsonWriter& json)
{
  static const char* const kinds[3] = { "interpolated", "at most", "not reached" };
  json.BeginObject(key);
  json.Write("seconds", time.Seconds);
  json.Write("is", kinds[time.Is]);
  json.EndObject();
}

void WriteRows(const SpeedFigures& figures, JsonWriter& json)
{
  json.BeginList("modes");
  for (const ModeRow& row : figures.Rows)
  {
    json.BeginObject();
    json.Write("mode", row.Mode);
    json.Write("knobs", row.Knobs);
    json.Write("default", row.Default);
    if (row.Mode == "Volume")
    {
      WriteTime("fill", row.Fill, json);
      json.Write("fill_occlusion_rays", row.FillRays);
    }
    WriteTime("frame", row.Frame, json);
    json.Write("frame_occlusion_rays", row.FrameRays);
    json.Write("error", row.Error.Rms);
    json.Write("bias", row.Error.Bias);
    json.EndObject();
  }
  json.EndList();
}

void WriteLocator(const LocatorFigures& locator, JsonWriter& json)
{
  json.BeginObject("locator");
  WriteTime("build", locator.Build, json);
  WriteTime("march", locator.March, json);
  WriteTime("same_march_with_embree", locator.EmbreeMarch, json);
  json.Write("pixels", locator.Pixels);
  json.Write("of_pixels", locator.OfPixels);
  json.Write("seconds_of_image", locator.SecondsOfImage(Clock::Wall));
  json.Write("difference", locator.Difference);
  json.Write("embree_difference", locator.EmbreeDifference);
  json.Write("embree_occlusion_rays", locator.EmbreeRays);
  json.EndObject();
}

void WriteComparisons(const std::string& key, const SpeedFigures& figures, Clock clock, JsonWriter& json)
{
  json.BeginList(key);
  for (const Comparison& c : CompareAtEqualError(figures, clock))
  {
    json.BeginObject();
    json.Write("name", c.Name);
    json.Write("error", c.Error);
    json.Write("by", c.Ours);
    WriteTimeAtError("time", c.Time, json);
    WriteTimeAtError("baseline", c.Baseline, json);
    if (c.IsKnown())
    {
      json.Write("ratio", c.AtMost ? 1.0 / c.Ratio() : c.Ratio());
    }
    if (c.Wanted > 0.0)
    {
      json.Write(c.AtMost ? "at_most" : "at_least", c.Wanted);
      json.Write("met", c.IsMet());
    }
    json.EndObject();
  }
  json.EndList();
}
} // namespace

//------------------------------------------------------------------------------
void PrintSpeed(const SpeedFigures& figures)
{
  std::printf("%s: %lld triangles, %lld photons, %lld vectors, %lld cones; %d x %d pixels, %d thread(s); noise of the "
              "reference %.4f of the mean a pixel,\n  which hides errors below %.5f\n",
    figures.Scene.c_str(), static_cast<long long>(figures.Triangles), static_cast<long long>(figures.Photons),
    static_cast<long long>(figures.Vectors), static_cast<long long>(figures.Cones), figures.Size, figures.Size,
    figures.Threads, figures.ReferenceNoise, figures.SmallestError);
  PrintStages(figures);
  PrintRows(figures);
  PrintComparisons(figures);
  const double share = ShareOfProcessor(figures);
  if (share < 0.95)
  {
    std::printf("  The machine was busy: one thread had %.0f %% of a processor. Trust ratios by processor time only.\n",
      100.0 * share);
  }
  std::printf("\n");
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void WriteSpeed(const SpeedFigures& figures, JsonWriter& json)
{
  json.BeginObject();
  json.Write("scene", figures.Scene);
  json.Write("size", figures.Size);
  json.Write("threads", figures.Threads);
  json.Write("triangles", figures.Triangles);
  json.Write("photons", figures.Photons);
  json.Write("vectors", figures.Vectors);
  json.Write("cones", figures.Cones);
  json.Write("reference_noise", figures.ReferenceNoise);
  json.Write("smallest_error", figures.SmallestError);
  json.BeginObject("stages");
  for (const Stage& stage : figures.Stages)
  {
    WriteTime(stage.Name, stage.Time, json);
  }
  WriteTime("unshadowed frame", figures.Unshadowed, json);
  json.EndObject();
  WriteRows(figures, json);
  WriteLocator(figures.Locator, json);
  json.BeginList("threading");
  for (const ThreadsRow& row : figures.Threading)
  {
    json.BeginObject();
    json.Write("name", row.Name);
    WriteTime("one", row.One, json);
    WriteTime("many", row.Many, json);
    json.EndObject();
  }
  json.EndList();
  WriteComparisons("at_equal_error", figures, Clock::Wall, json);
  WriteComparisons("at_equal_error_by_processor_time", figures, Clock::Processor, json);
  json.EndObject();
}

} // namespace shadowcones
