// SPDX-License-Identifier: BSD-3-Clause
// Shapes of shadow: widths of penumbrae, footprints, solids, and a page that shows what was found.
#include "scCommandLine.h"
#include "scFailure.h"
#include "scOutputFile.h"
#include "scPlaces.h"
#include "scScene.h"
#include "scUpdate.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetProbe.h"
#include "vtkDataSet.h"
#include "vtkLabelOccluders.h"
#include "vtkNew.h"
#include "vtkPenumbraWidth.h"
#include "vtkPolyData.h"
#include "vtkSceneDefaults.h"
#include "vtkShadowFootprintWriter.h"
#include "vtkShadowFootprints.h"
#include "vtkShadowPage.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"

#include <CLI/CLI.hpp>
#include <iostream>

namespace
{
using namespace shadowcones;

struct ShapeOptions
{
  SceneOptions Scene;
  PlaceOptions Places;
  std::string Output;
  std::string Inner;
  std::string Method = "visibility";
  std::string Title = "Light and shadow";
  std::vector<double> Bounds;
  int Resolution = 64;
  bool Together = false;
};

bool IsGeoJson(const std::string& path)
{
  return path.size() > 8 && path.compare(path.size() - 8, 8, ".geojson") == 0;
}

void RunWidths(const ShapeOptions& options)
{
  if (!options.Output.empty())
  {
    CheckOutput(options.Output, FileKind::Points);
  }
  const Scene scene(options.Scene);
  vtkNew<vtkPenumbraWidth> widths;
  const vtkSmartPointer<vtkDataSet> places = FindPlaces(options.Places, scene);
  widths->SetInputDataObject(places);
  widths->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(widths.Get());
  widths->SetSeed(options.Scene.Seed);
  Update(widths, "widths", options.Scene.Quiet);
  if (options.Output.empty())
  {
    std::cout << MakeTable(widths->GetOutputDataObject(1), true);
    return;
  }
  WriteOutput(widths->GetOutputDataObject(0), options.Output);
}

void RunFootprints(const ShapeOptions& options)
{
  if (!IsGeoJson(options.Output))
  {
    CheckOutput(options.Output, FileKind::Points);
  }
  const Scene scene(options.Scene);
  PlaceOptions where = options.Places;
  if (where.File.empty() && where.Ground.empty())
  {
    where.Ground = "auto";
  }
  vtkNew<vtkShadowFootprints> footprints;
  const vtkSmartPointer<vtkDataSet> places = FindPlaces(where, scene);
  footprints->SetInputDataObject(places);
  footprints->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(footprints.Get());
  footprints->SetPerOccluder(!options.Together);
  footprints->SetSeed(options.Scene.Seed);
  Update(footprints, "footprints", options.Scene.Quiet);
  if (!IsGeoJson(options.Output))
  {
    WriteOutput(footprints->GetOutputDataObject(0), options.Output);
    return;
  }
  WriteBeside(options.Output,
    [&](const std::string& beside)
    {
      vtkNew<vtkShadowFootprintWriter> writer;
      writer->SetInputDataObject(footprints->GetOutputDataObject(0));
      writer->SetFileName(beside.c_str());
      writer->Write();
      return writer->GetErrorCode() == 0;
    });
}

void RunSolids(const ShapeOptions& options)
{
  CheckOutput(options.Output, FileKind::Surface);
  if (!options.Inner.empty())
  {
    CheckOutput(options.Inner, FileKind::Surface);
  }
  const Scene scene(options.Scene);
  vtkNew<vtkShadowVolume> solids;
  solids->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(solids.Get());
  solids->SetMethod(options.Method == "projection" ? vtkShadowVolume::Projection : vtkShadowVolume::Visibility);
  solids->SetResolution(options.Resolution);
  solids->SetPerOccluder(!options.Together);
  if (!options.Bounds.empty())
  {
    solids->SetBounds(options.Bounds.data());
  }
  Update(solids, "solids", options.Scene.Quiet);
  WriteOutput(solids->GetOutput(0), options.Output);
  if (!options.Inner.empty())
  {
    WriteOutput(solids->GetOutput(1), options.Inner);
  }
}

void RunPage(const ShapeOptions& options)
{
  const std::string& path = options.Output;
  if (path.size() < 6 || path.compare(path.size() - 5, 5, ".html") != 0)
  {
    throw Failure("-o " + path + ": expected a name that ends in .html", ExitUsage);
  }
  const Scene scene(options.Scene);
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(vectors.Get());
  vectors->SetTargetNumberOfVectors(5800);
  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetPhotonPathConnection(vectors->GetOutputPort(1));
  cones->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(cones.Get());
  Update(cones, "cones", options.Scene.Quiet);

  PlaceOptions where = options.Places;
  if (where.File.empty() && where.Ground.empty())
  {
    where.Ground = "auto";
  }
  const vtkSmartPointer<vtkDataSet> places = FindPlaces(where, scene);
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputDataObject(places);
  probe->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(probe.Get());
  Update(probe, "asking", options.Scene.Quiet);

  vtkNew<vtkShadowPage> page;
  page->SetTitle(options.Title);
  page->SetViewUp(scene.Up);
  page->AddMesh(scene.Occluders->GetOutput(), "Mesh");
  if (cones->GetOutput()->GetNumberOfPoints() > 0)
  {
    page->AddCones(cones->GetOutput());
  }
  page->AddAnswer(vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0)), "Visibility", "Visibility");
  if (!page->Write(path))
  {
    throw Failure(path + ": cannot be written: is the folder there, writable, and the disk not full?");
  }
}

std::shared_ptr<ShapeOptions> AddShapeCommand(CLI::App& program, const std::string& name, const std::string& does,
  const std::string& examples, void (*run)(const ShapeOptions&))
{
  CLI::App* command = AddCommand(program, name, does, examples);
  auto options = std::make_shared<ShapeOptions>();
  AddSceneOptions(command, options->Scene);
  command->callback([options, run] { run(*options); });
  return options;
}
} // namespace

namespace shadowcones
{
void AddShapeCommands(CLI::App& program)
{
  auto widths =
    AddShapeCommand(program, "widths", "How wide the edges of shadows are: from 5 % to 95 % of the light, world units",
      "  shadowcones widths roof.stl --light 'sun: azimuth 180 altitude 45' --ground auto -o widths.vtp\n"
      "  shadowcones widths chair.stl --where floor.vtp\n"
      "  shadowcones widths pole.obj --light disc:0,9,0 radius 0.3 facing 0,-1,0 --ground 0,4,65 --up y -o widths.csv",
      RunWidths);
  CLI::App* command = program.get_subcommand("widths");
  AddPlaceOptions(command, widths->Places, true);
  command->add_option(
    "-o,--output", widths->Output, "vtp or csv: the surface with its widths. Default: a table of the widths");

  auto footprints =
    AddShapeCommand(program, "footprints", "Outlines of whole shadow and umbra on a surface, by occluder",
      "  shadowcones footprints house.obj tree.obj --light 'sun: azimuth 200 altitude 25' -o shadows.geojson\n"
      "  shadowcones footprints mast.stl --light 'sun: azimuth 90 altitude 10' --where terrain.vtp -o shadows.vtp\n"
      "  shadowcones footprints chair.stl --ground 0,8,257 --together -o shadow.vtp",
      RunFootprints);
  command = program.get_subcommand("footprints");
  AddPlaceOptions(command, footprints->Places, true);
  command->add_option("-o,--output", footprints->Output, "geojson for maps, vtp, csv")->required();
  command->add_flag("--together", footprints->Together, "One footprint of all occluders");

  auto solids = AddShapeCommand(program, "solids", "Shadows as closed solids, to cut, measure or print",
    "  shadowcones solids chair.stl -o shadow.stl\n"
    "  shadowcones solids house.obj --light 'sun: azimuth 180 altitude 45' --bounds=-5,30,-10,20,0,20 -o outer.stl "
    "--inner umbra.stl\n"
    "  shadowcones solids post.ply --light point:0,9,0 --method projection -o shadow.obj",
    RunSolids);
  command = program.get_subcommand("solids");
  command->add_option("-o,--output", solids->Output, "stl, ply, obj or vtp: around penumbra and umbra")->required();
  command->add_option("--inner", solids->Inner, "The same, inside the umbra");
  command
    ->add_option("--method", solids->Method, "visibility: of any light; projection: exact, of lights without width")
    ->check(CLI::IsMember({ "visibility", "projection" }))
    ->capture_default_str();
  command->add_option("--bounds", solids->Bounds, "The box that cuts them, x,x,y,y,z,z")->delimiter(',')->expected(6);
  command->add_option("--resolution", solids->Resolution, "Cells along the longest side")->capture_default_str();
  command->add_flag("--together", solids->Together, "One solid of all occluders");

  auto page = AddShapeCommand(program, "page",
    "One HTML file that shows mesh, cones and the light on a surface, without a network",
    "  shadowcones page chair.stl -o chair.html\n"
    "  shadowcones page house.obj --light 'sun: azimuth 135 altitude 40' --ground 0,60,257 -o house.html\n"
    "  shadowcones page tree.ply --where terrain.vtp --title 'Shade of the oak' -o oak.html",
    RunPage);
  command = program.get_subcommand("page");
  AddPlaceOptions(command, page->Places, true);
  command->add_option("-o,--output", page->Output, "html")->required();
  command->add_option("--title", page->Title, "What stands above the picture")->capture_default_str();
}
} // namespace shadowcones
