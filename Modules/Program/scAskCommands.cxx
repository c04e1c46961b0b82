// SPDX-License-Identifier: BSD-3-Clause
// Questions at points: how much of the light is seen, how much arrives, and whose shadow it is.
#include "scCommandLine.h"
#include "scFailure.h"
#include "scOutputFile.h"
#include "scPlaces.h"
#include "scScene.h"
#include "scUpdate.h"
#include "vtkConeSetProbe.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkLabelOccluders.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <CLI/CLI.hpp>
#include <iostream>

namespace
{
using namespace shadowcones;

struct AskOptions
{
  SceneOptions Scene;
  PlaceOptions Places;
  std::string Output;
  int Samples = 64;
  bool Lux = false;
};

enum class Question
{
  Visibility,
  Irradiance,
  Fluence,
  ShadowOf
};

/// A line a point: the name of the occluder, or its number where it has no name; empty where the point is lit.
void PrintShadows(vtkDataSet* answer)
{
  vtkDataArray* ids = answer->GetPointData()->GetArray("OccluderId");
  auto* names = vtkStringArray::SafeDownCast(answer->GetFieldData()->GetAbstractArray("OccluderNames"));
  for (vtkIdType point = 0; point < ids->GetNumberOfTuples(); ++point)
  {
    for (int light = 0; light < ids->GetNumberOfComponents(); ++light)
    {
      const vtkIdType id = static_cast<vtkIdType>(ids->GetComponent(point, light));
      const bool named = names && id >= 0 && id < names->GetNumberOfValues();
      std::cout << (light ? "," : "") << (id < 0 ? "" : named ? names->GetValue(id) : std::to_string(id));
    }
    std::cout << '\n';
  }
}

void Ask(const AskOptions& options, Question question)
{
  if (!options.Output.empty())
  {
    CheckOutput(options.Output, FileKind::Points);
  }
  const Scene scene(options.Scene);
  const vtkSmartPointer<vtkDataSet> places = FindPlaces(options.Places, scene);
  if (question == Question::Irradiance && !places->GetPointData()->GetNormals())
  {
    throw Failure("irradiance counts light on one side: say which with --facing x,y,z", ExitUsage);
  }

  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputDataObject(places);
  probe->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(probe.Get());
  probe->SetNumberOfLightSamples(options.Samples);
  probe->SetSeed(options.Scene.Seed);
  probe->SetComputeIrradiance(question == Question::Irradiance && !options.Lux);
  probe->SetComputeIlluminance(question == Question::Irradiance && options.Lux);
  probe->SetComputeFluenceRate(question == Question::Fluence);
  Update(probe, "asking", options.Scene.Quiet);

  if (!options.Output.empty())
  {
    WriteOutput(probe->GetOutput(), options.Output);
  }
  else if (question == Question::ShadowOf)
  {
    PrintShadows(probe->GetOutput());
  }
  else
  {
    std::cout << MakeTable(probe->GetOutput(), false);
  }
}

CLI::App* AddAskCommand(
  CLI::App& program, const std::string& name, const std::string& does, const std::string& examples, Question question)
{
  CLI::App* command = AddCommand(program, name, does, examples);
  auto options = std::make_shared<AskOptions>();
  AddSceneOptions(command, options->Scene);
  AddPlaceOptions(command, options->Places, false);
  command->add_option("-o,--output", options->Output, "csv, vtp, or vti for a grid. Default: standard output");
  command->add_option("--samples", options->Samples, "Samples of the light at each point")->capture_default_str();
  if (question == Question::Irradiance)
  {
    command->add_flag("--lux", options->Lux, "Illuminance in lux, of all wavelengths together");
  }
  command->callback([options, question] { Ask(*options, question); });
  return command;
}
} // namespace

namespace shadowcones
{
void AddAskCommands(CLI::App& program)
{
  AddAskCommand(program, "probe",
    "How much of the light is seen at points: lit, penumbra or umbra, whose shadow, how sure",
    "  shadowcones probe chair.stl --light disc:0,5,0 radius 0.5 facing 0,-1,0 --at 0,0,0 --at 1,0,0\n"
    "  shadowcones probe house.obj --light 'sun: azimuth 135 altitude 40' --grid 64,64,32 -o light.vti\n"
    "  shadowcones probe tree.ply --where terrain.vtp -o shade.vtp",
    Question::Visibility);
  AddAskCommand(program, "irradiance", "Light that arrives on a side, W m^-2 a wavelength, or lux",
    "  shadowcones irradiance hall.obj --light disc:0,4,0 radius 0.2 facing 0,-1,0 flux 2000 lm --ground 0.8,6,64 --up "
    "y --lux -o desks.csv\n"
    "  shadowcones irradiance panel.stl --light 'sun: azimuth 180 altitude 30 irradiance 1000 W/m2' -o panel.vtp\n"
    "  shadowcones irradiance room.glb --at 1,1,1 --facing 0,0,1",
    Question::Irradiance);
  AddAskCommand(program, "fluence",
    "Light that passes points from all directions, W m^-2 a wavelength (disinfection by UV)",
    "  shadowcones fluence room.obj --light rectangle:0,2,0 size 0.05,1 facing 0,0,1 flux 15 W --grid 40,40,20 -o "
    "fluence.vti\n"
    "  shadowcones fluence pillar.stl --light point:2,0,1 --at 0,0,1 --at -2,0,1\n"
    "  shadowcones fluence room.obj --where points.csv -o fluence.csv",
    Question::Fluence);
  AddAskCommand(program, "shadow-of",
    "Whose shadow it is: a line a point, the name of the occluder that hides most of the light",
    "  shadowcones shadow-of house.obj tree.obj --light 'sun: azimuth 200 altitude 25' --at 12,3,0\n"
    "  shadowcones shadow-of house.obj tree.obj --light 'sun: azimuth 200 altitude 25' --where windows.csv\n"
    "  shadowcones shadow-of blocks.glb --occluders component --ground auto -o whose.vtp",
    Question::ShadowOf);
}
} // namespace shadowcones
