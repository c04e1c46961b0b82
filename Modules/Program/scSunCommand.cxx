// SPDX-License-Identifier: BSD-3-Clause
// Hours of Sun.
#include "scCommandLine.h"
#include "scFailure.h"
#include "scOutputFile.h"
#include "scPlaces.h"
#include "scScene.h"
#include "scUpdate.h"
#include "vtkDataSet.h"
#include "vtkLabelOccluders.h"
#include "vtkNew.h"
#include "vtkSunHours.h"
#include "vtkSunPath.h"

#include <CLI/CLI.hpp>
#include <iostream>

namespace
{
using namespace shadowcones;

struct SunOptions
{
  SceneOptions Scene;
  PlaceOptions Places;
  std::string Output;
  std::string Start;
  std::string End;
  double Latitude = 0.0;
  double Longitude = 0.0;
  double Step = 10.0;
  double Diameter = 0.533;
  std::vector<double> North;
  bool Whose = false;
};

void RunSunHours(const SunOptions& options)
{
  if (!options.Output.empty())
  {
    CheckOutput(options.Output, FileKind::Points);
  }
  SceneOptions sceneOptions = options.Scene;
  sceneOptions.Up = options.Scene.Up.empty() ? "z" : options.Scene.Up;
  const Scene scene(sceneOptions, false);
  vtkNew<vtkSunPath> path;
  path->SetLatitude(options.Latitude);
  path->SetLongitude(options.Longitude);
  path->SetStart(options.Start.c_str());
  path->SetEnd(options.End.c_str());
  path->SetStep(options.Step);
  path->SetAngularDiameter(options.Diameter);
  path->SetUp(scene.Up);
  if (!options.North.empty())
  {
    path->SetNorth(options.North.data());
  }
  else if (sceneOptions.Up == "y")
  {
    path->SetNorth(0.0, 0.0, -1.0);
  }

  vtkNew<vtkSunHours> hours;
  const vtkSmartPointer<vtkDataSet> places = FindPlaces(options.Places, scene);
  hours->SetInputDataObject(places);
  hours->SetMeshConnection(scene.Occluders->GetOutputPort());
  hours->SetPathConnection(path->GetOutputPort());
  hours->SetSeed(options.Scene.Seed);
  hours->SetComputeOccluders(options.Whose);
  Update(hours, "sun hours", options.Scene.Quiet);
  if (options.Output.empty())
  {
    std::cout << MakeTable(hours->GetOutputDataObject(0), false);
    return;
  }
  WriteOutput(hours->GetOutputDataObject(0), options.Output);
}
} // namespace

namespace shadowcones
{
void AddSunCommand(CLI::App& program)
{
  CLI::App* command = AddCommand(program, "sun-hours",
    "How long points are in the Sun between two times: hours, first and last Sun, whose shadow takes most",
    "  shadowcones sun-hours block.glb --latitude 52.5 --longitude 13.4 --start 2026-06-21 --end 2026-06-22 --ground "
    "auto -o hours.vtp\n"
    "  shadowcones sun-hours house.obj tree.obj --latitude 48.1 --longitude 11.6 --start 2026-12-21 --end 2026-12-22 "
    "--at 3,2,1.5 --whose\n"
    "  shadowcones sun-hours facade.stl --latitude -33.9 --longitude 151.2 --start 2026-01-01 --end 2027-01-01 --step "
    "30 -o year.vtp");
  auto options = std::make_shared<SunOptions>();
  AddSceneOptions(command, options->Scene, false);
  AddPlaceOptions(command, options->Places, false);
  command->add_option("--latitude", options->Latitude, "Degrees, north is positive")->required();
  command->add_option("--longitude", options->Longitude, "Degrees, east is positive")->required();
  command->add_option("--start", options->Start, "ISO 8601; without a zone it is UTC")->required();
  command->add_option("--end", options->End, "The same")->required();
  command->add_option("--step", options->Step, "Minutes between two positions of the Sun")->capture_default_str();
  command->add_option("--diameter", options->Diameter, "Of the Sun, degrees; 0: hard shadows, and quicker")
    ->capture_default_str();
  command->add_option("--north", options->North, "Which way is north, x,y,z. Default: y, and where y is up -z")
    ->delimiter(',')
    ->expected(3);
  command->add_flag("--whose", options->Whose, "Find whose shadow takes most time");
  command->add_option("-o,--output", options->Output, "csv, vtp, or vti for a grid. Default: standard output");
  command->callback([options] { RunSunHours(*options); });
}
} // namespace shadowcones
