// SPDX-License-Identifier: BSD-3-Clause
// The chain of the method: shadow vectors, cones, how far to trust them, and how long all of it takes.
#include "scCommandLine.h"
#include "scOutputFile.h"
#include "scScene.h"
#include "scTerminal.h"
#include "scUpdate.h"
#include "vtkCamera.h"
#include "vtkConeSetAccuracy.h"
#include "vtkConeSetFilter.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLabelOccluders.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkScatteringImageFilter.h"
#include "vtkSceneDefaults.h"
#include "vtkShadowVectorFilter.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

namespace
{
using namespace shadowcones;

struct ChainOptions
{
  SceneOptions Scene;
  std::string Output;
  int Vectors = 5800;
  vtkIdType Samples = 100000;
  bool Paper = false;
};

/// The filters of the chain, connected.
struct Chain
{
  Chain(const ChainOptions& options, const Scene& scene)
  {
    if (options.Paper)
    {
      this->Vectors->SetToPaper();
      this->Cones->SetToPaper();
    }
    this->Vectors->SetInputConnection(scene.Occluders->GetOutputPort());
    scene.ConnectLights(this->Vectors.Get());
    this->Vectors->SetTargetNumberOfVectors(options.Vectors);
    this->Vectors->SetSeed(options.Scene.Seed);
    this->Cones->SetInputConnection(this->Vectors->GetOutputPort(0));
    this->Cones->SetPhotonPathConnection(this->Vectors->GetOutputPort(1));
    this->Cones->SetMeshConnection(scene.Occluders->GetOutputPort());
    scene.ConnectLights(this->Cones.Get());
  }
  vtkNew<vtkShadowVectorFilter> Vectors;
  vtkNew<vtkConeSetFilter> Cones;
};

void RunVectors(const ChainOptions& options)
{
  CheckOutput(options.Output, FileKind::Points);
  const Scene scene(options.Scene);
  const Chain chain(options, scene);
  Update(chain.Vectors, "shadow vectors", options.Scene.Quiet);
  WriteOutput(chain.Vectors->GetOutput(), options.Output);
}

void RunCones(const ChainOptions& options)
{
  CheckOutput(options.Output, FileKind::Points);
  const Scene scene(options.Scene);
  const Chain chain(options, scene);
  Update(chain.Cones, "cones", options.Scene.Quiet);
  WriteOutput(chain.Cones->GetOutput(), options.Output);
  vtkDataArray* certified = chain.Cones->GetOutput()->GetFieldData()->GetArray("Certified");
  std::cout << chain.Cones->GetOutput()->GetNumberOfPoints() << " cones, "
            << (certified && certified->GetTuple1(0) > 0.0 ? "proved: outside all of them no light is hidden\n"
                                                           : "not proved\n");
}

void RunAccuracy(const ChainOptions& options)
{
  const Scene scene(options.Scene);
  const Chain chain(options, scene);
  vtkNew<vtkConeSetAccuracy> accuracy;
  accuracy->SetConeSetConnection(chain.Cones->GetOutputPort());
  accuracy->SetMeshConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(accuracy.Get());
  accuracy->SetNumberOfSamples(options.Samples);
  accuracy->SetSeed(options.Scene.Seed);
  Update(accuracy, "accuracy", options.Scene.Quiet);
  auto* table = vtkTable::SafeDownCast(accuracy->GetOutputDataObject(1));
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    std::printf("%-22s %10.6g  %10.6g .. %.6g\n", table->GetValue(row, 0).ToString().c_str(),
      table->GetValue(row, 1).ToDouble(), table->GetValue(row, 2).ToDouble(), table->GetValue(row, 3).ToDouble());
  }
}

/// Seconds of one update.
double Seconds(vtkAlgorithm* filter, const std::string& step, bool quiet)
{
  const double start = Now();
  Update(filter, step, quiet);
  return Now() - start;
}

void RunBench(const ChainOptions& options)
{
  const Scene scene(options.Scene);
  const Chain chain(options, scene);
  vtkNew<vtkCamera> camera;
  scene.Defaults->PlaceCamera(camera, 1.0);
  double medium[6];
  scene.Defaults->GetMediumBounds(medium);
  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(image.Get());
  image->SetCamera(camera);
  image->SetResolution(256, 256);
  image->SetMediumBounds(medium);
  image->SetSigmaS(scene.Defaults->GetSigmaS());

  std::printf(
    "triangles              %10lld\n", static_cast<long long>(scene.Occluders->GetOutput()->GetNumberOfPolys()));
  std::printf("shadow vectors         %10.3f s\n", Seconds(chain.Vectors, "shadow vectors", options.Scene.Quiet));
  std::printf("cones, tuned, proved   %10.3f s\n", Seconds(chain.Cones, "cones", options.Scene.Quiet));
  std::printf("image without cones    %10.3f s\n", Seconds(image, "image without cones", options.Scene.Quiet));
  image->SetConeSetConnection(chain.Cones->GetOutputPort());
  std::printf("image with cones       %10.3f s\n", Seconds(image, "image with cones", options.Scene.Quiet));
}

CLI::App* AddChainCommand(CLI::App& program, const std::string& name, const std::string& does,
  const std::string& examples, void (*run)(const ChainOptions&), bool output)
{
  CLI::App* command = AddCommand(program, name, does, examples);
  auto options = std::make_shared<ChainOptions>();
  AddSceneOptions(command, options->Scene);
  if (output)
  {
    command->add_option("-o,--output", options->Output, "vtp, or csv")->required();
  }
  command->add_option("--vectors", options->Vectors, "How many shadow vectors, at least")->capture_default_str();
  command->add_flag("--paper", options->Paper, "As the paper has it: neither tuned nor proved");
  if (run == RunAccuracy)
  {
    command->add_option("--samples", options->Samples, "Points at which the cones are held against the mesh")
      ->capture_default_str();
  }
  command->callback([options, run] { run(*options); });
  return command;
}
} // namespace

namespace shadowcones
{
void AddChainCommands(CLI::App& program)
{
  AddChainCommand(program, "vectors", "Shadow vectors: where light that an occluder stopped would have gone on",
    "  shadowcones vectors chair.stl -o vectors.vtp\n"
    "  shadowcones vectors bunny.obj --light sphere:0,3,0 radius 0.2 --vectors 50000 -o vectors.vtp\n"
    "  shadowcones vectors chair.stl --paper -o vectors.csv",
    RunVectors, true);
  AddChainCommand(program, "cones", "Cones that hold the shadow, proved against the mesh",
    "  shadowcones cones chair.stl -o cones.vtp\n"
    "  shadowcones cones bunny.obj --light disc:0,5,0 radius 0.5 facing 0,-1,0 -o cones.vtp\n"
    "  shadowcones cones chair.stl --paper -o cones.csv",
    RunCones, true);
  AddChainCommand(program, "accuracy",
    "How far the cones can be trusted: recall, precision, leaked and lost light, whether proved",
    "  shadowcones accuracy chair.stl\n"
    "  shadowcones accuracy bunny.obj --samples 1000000\n"
    "  shadowcones accuracy chair.stl --paper",
    RunAccuracy, false);
  AddChainCommand(program, "bench", "How long each step takes on a mesh of yours",
    "  shadowcones bench chair.stl\n"
    "  shadowcones bench city.glb --light 'sun: azimuth 135 altitude 40'\n"
    "  shadowcones bench bunny.obj --vectors 20000",
    RunBench, false);
}
} // namespace shadowcones
