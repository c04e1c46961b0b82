// SPDX-License-Identifier: BSD-3-Clause
// The light shafts that a camera sees.
#include "scCommandLine.h"
#include "scFailure.h"
#include "scOutputFile.h"
#include "scPlaces.h"
#include "scScene.h"
#include "scUpdate.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLabelOccluders.h"
#include "vtkNew.h"
#include "vtkScatteringImageFilter.h"
#include "vtkSceneDefaults.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace
{
using namespace shadowcones;

struct ImageOptions
{
  SceneOptions Scene;
  std::string Output;
  std::string Size = "640x480";
  std::string Mode = "guided";
  double Error = 0.02;
  std::vector<double> Camera;
  std::vector<double> Medium;
  double SigmaS = -1.0;
  double SigmaA = 0.0;
  double Asymmetry = 0.0;
  double Exposure = 0.0;
  std::string Tone = "filmic";
  int Steps = 64;
  int Samples = 16;
};

/// "640x480" as two numbers.
void ReadSize(const std::string& text, int (&size)[2])
{
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size[0], &size[1], &rest) != 2 || size[0] < 1 || size[1] < 1)
  {
    throw Failure("--size " + text + ": expected width x height in pixels, such as 640x480", ExitUsage);
  }
}

void PlaceCamera(const ImageOptions& options, const Scene& scene, const int (&size)[2], vtkCamera* camera)
{
  scene.Defaults->PlaceCamera(camera, static_cast<double>(size[0]) / size[1]);
  if (!options.Camera.empty())
  {
    camera->SetPosition(options.Camera.data());
    camera->SetFocalPoint(options.Camera.data() + 3);
    camera->SetViewUp(scene.Up);
    camera->SetViewAngle(30.0);
  }
}

void SetMedium(const ImageOptions& options, const Scene& scene, vtkScatteringImageFilter* image)
{
  double bounds[6];
  scene.Defaults->GetMediumBounds(bounds);
  std::copy(options.Medium.begin(), options.Medium.end(), bounds);
  image->SetMediumBounds(bounds);
  image->SetSigmaS(options.SigmaS >= 0.0 ? options.SigmaS : scene.Defaults->GetSigmaS());
  image->SetSigmaA(options.SigmaA);
  if (options.Asymmetry != 0.0)
  {
    image->SetPhaseFunctionToHenyeyGreenstein();
    image->SetPhaseAsymmetry(options.Asymmetry);
  }
}

void RunImage(const ImageOptions& options)
{
  int size[2];
  ReadSize(options.Size, size);
  CheckOutput(options.Output, FileKind::Picture);
  const Scene scene(options.Scene);
  vtkNew<vtkCamera> camera;
  PlaceCamera(options, scene, size, camera);

  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(scene.Occluders->GetOutputPort());
  scene.ConnectLights(image.Get());
  image->SetCamera(camera);
  image->SetResolution(size);
  image->SetRelativeErrorGoal(options.Error);
  image->SetSeed(options.Scene.Seed);
  SetMedium(options, scene, image);
  if (options.Mode == "bruteforce")
  {
    image->SetModeToBruteForce();
    image->SetNumberOfSteps(options.Steps);
    image->SetNumberOfLightSamples(options.Samples);
  }
  if (options.Exposure > 0.0)
  {
    image->AutoExposureOff();
    image->SetExposure(options.Exposure);
  }
  image->SetToneCurve(options.Tone == "linear" ? vtkScatteringImageFilter::Linear : vtkScatteringImageFilter::Filmic);
  Update(image, "light shafts", options.Scene.Quiet);
  WriteOutput(image->GetOutput(), options.Output);
}
} // namespace

namespace shadowcones
{
void AddImageCommand(CLI::App& program)
{
  CLI::App* command = AddCommand(program, "image",
    "The light shafts that a camera sees around a mesh in fog, smoke or water: a picture, or every number of it",
    "  shadowcones image chair.stl -o shafts.png\n"
    "  shadowcones image room.obj table.obj --light disc:0,2.4,0 radius 0.3 facing 0,-1,0 --size 1280x720 -o room.png\n"
    "  shadowcones image house.glb --light 'sun: azimuth 135 altitude 40' --camera 20,5,20,0,2,0 --error 0.01 -o "
    "house.vti");
  auto options = std::make_shared<ImageOptions>();
  AddSceneOptions(command, options->Scene);
  command->add_option("-o,--output", options->Output, "png or tif: the picture; vti: every number")->required();
  command->add_option("--size", options->Size, "Width and height in pixels")->capture_default_str();
  command->add_option("--error", options->Error, "Relative error of a pixel to reach, of the light from the medium")
    ->capture_default_str();
  command->add_option("--camera", options->Camera, "Position and focal point, x,y,z,x,y,z. Default: one that sees all")
    ->delimiter(',')
    ->expected(6);
  command->add_option("--medium", options->Medium, "The box of the medium, x,x,y,y,z,z. Default: around the mesh")
    ->delimiter(',')
    ->expected(6);
  command
    ->add_option("--sigma-s", options->SigmaS, "Scattering coefficient, 1/unit. Default: 0.7 over the medium's size")
    ->check(CLI::NonNegativeNumber);
  command->add_option("--sigma-a", options->SigmaA, "Absorption coefficient, 1/unit")->capture_default_str();
  command->add_option("--asymmetry", options->Asymmetry, "Mean cosine of scattering (Henyey-Greenstein), -1 to 1")
    ->capture_default_str();
  command->add_option("--exposure", options->Exposure, "What 1 over radiance is white. Default: found from the image");
  command->add_option("--tone", options->Tone, "filmic rolls lamps and bright spots off, linear cuts them at white")
    ->check(CLI::IsMember({ "filmic", "linear" }))
    ->capture_default_str();
  command
    ->add_option(
      "--mode", options->Mode, "How: guided to the error asked for, or bruteforce with --steps and --samples")
    ->check(CLI::IsMember({ "guided", "bruteforce" }))
    ->capture_default_str();
  command->add_option("--steps", options->Steps, "Steps of bruteforce along each ray")->capture_default_str();
  command->add_option("--samples", options->Samples, "Light samples of bruteforce at each step")->capture_default_str();
  command->callback([options] { RunImage(*options); });
}
} // namespace shadowcones
