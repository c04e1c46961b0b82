// SPDX-License-Identifier: BSD-3-Clause
// Time at equal error: Guided and Volume against three named brute forces, all measured in one run.
//
// (a) BruteForce: the paper's adaptive march with Embree. (b) the same march with vtkStaticCellLocator. (c) Stratified:
// Guided without cones, the strongest brute force. Only the medium term counts; surfaces are black. The error is the
// root of the mean square over pixels, over the mean, against Testing/Reference at random pixels, the reference's own
// noise taken off. Each mode is run over its knobs, and its time at an error is read off its own curve.
#include "DarkScenes.h"
#include "GrowthSweep.h"
#include "ProgramOptions.h"
#include "SpeedMeasurement.h"
#include "SpeedReport.h"

#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{
std::vector<std::string> DefaultScenes()
{
  std::vector<std::string> scenes = { "chair", "tree", "blob" };
  const std::string bunny = "/usr/share/glmark2/models/bunny.obj";
  if (std::ifstream(bunny))
  {
    scenes.push_back(bunny);
  }
  scenes.insert(scenes.end(), DarkSceneNames().begin(), DarkSceneNames().end());
  return scenes;
}

void Run(const std::vector<std::string>& scenes, const SpeedSetting& setting, bool sweep, JsonWriter* json)
{
  for (const std::string& name : scenes)
  {
    if (sweep)
    {
      const std::vector<Growth> growth = MeasureGrowth(name, setting);
      PrintGrowth(name, growth);
      if (json)
      {
        json->BeginObject();
        json->Write("scene", name);
        WriteGrowth(growth, *json);
        json->EndObject();
      }
      continue;
    }
    const SpeedFigures figures = MeasureSpeed(name, setting);
    PrintSpeed(figures);
    if (json)
    {
      WriteSpeed(figures, *json);
    }
  }
}
} // namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Time at equal error of the scattering image, against three named baselines.");
  SpeedSetting setting;
  std::vector<std::string> scenes = DefaultScenes();
  std::array<double, 3> center = { setting.Light.Center.X, setting.Light.Center.Y, setting.Light.Center.Z };
  std::string jsonFile;
  bool sweep = false;
  commandLine.Add("--scene", scenes, "chair, tree, blob, blinds, canopy, holes, colonnade, or mesh files, which are scaled to a height of 3 units");
  commandLine.AddPositive("--light-radius", setting.Light.Radius, "radius of the disc light that faces down");
  commandLine.Add("--light-center", center, "its centre; the room is x and z in +-2.75, y in 0..5.2");
  commandLine.Add("--vectors", setting.Vectors, "shadow vectors asked for; 0: 5800, on the tree 20000");
  commandLine.AddPositive("--size", setting.Size, "width and height in pixels");
  commandLine.AddPositive("--threads", setting.Threads, "threads; the reference takes all");
  commandLine.AddPositive("--repeats", setting.Repeats, "runs of each job, of which the median counts");
  commandLine.Add("--enough", setting.Enough, "seconds after which a job is not repeated, but for its second run");
  commandLine.AddPositive("--pixels", setting.Pixels, "pixels that are compared with the reference");
  commandLine.AddPositive("--samples", setting.Samples, "samples of the reference for each of them");
  commandLine.Add("--cache", setting.Folder, "folder that keeps references from one run to the next");
  commandLine.Add("--json", jsonFile, "file that receives all figures");
  commandLine.AddFlag("--sweep", sweep, "instead of the table: growth with resolution, light radius, photons, triangles and threads");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  setting.Light.Center = { center[0], center[1], center[2] };

  try
  {
    std::printf("# seconds: by the wall clock, medians; processor: of all threads together; error and bias: of the "
                "medium term at %d pixels, over its mean\n# * marks the defaults of a mode\n\n",
      setting.Pixels);
    std::ofstream out;
    if (!jsonFile.empty())
    {
      out.open(jsonFile);
      if (!out)
      {
        throw std::runtime_error("Cannot write '" + jsonFile + "'.");
      }
    }
    JsonWriter json(out);
    json.BeginList();
    Run(scenes, setting, sweep, out.is_open() ? &json : nullptr);
    json.EndList();
    out << '\n';
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "scattering-speed: %s\n", failure.what());
    return 1;
  }
  return 0;
}
