// SPDX-License-Identifier: BSD-3-Clause
// Solids of vtkShadowVolume held against random points: volumes of the outer and the inner bound, the share of the inner one that
// sees light, and seconds; for a house, a plate, a ring and a sphere, each under a Sun, a disc and a point.
#include "BenchmarkScene.h"
#include "ProgramOptions.h"
#include "SolidReference.h"
#include "SolidScenes.h"
#include "TestPolyData.h"
#include "TestSolids.h"

#include "scMeshData.h"
#include "vtkShadowVolume.h"

#include <cstdio>
#include <exception>

using namespace shadowcones;
using namespace testsupport;

namespace
{
struct Options
{
  std::string Method = "visibility";
  int Resolution = 64;
  int LightSamples = 64;
  int Side = 100;
  int Points = 100000;
  int Rays = 24;
};

double Percent(double value, double truth)
{
  return truth > 0.0 ? 100.0 * (value / truth - 1.0) : 0.0;
}

void Measure(const SolidScene& scene, const Options& options)
{
  vtkNew<vtkAreaLightSource> source;
  const Light& light = scene.Lamp;
  const bool sun = light.Shape == LightShape::Sun;
  sun ? source->SetShapeToSun()
      : (light.Shape == LightShape::Point ? source->SetShapeToPoint() : source->SetShapeToDisc());
  source->SetCenter(light.Center.X, light.Center.Y, light.Center.Z);
  source->SetNormal(light.Normal.X, light.Normal.Y, light.Normal.Z);
  if (sun)
  {
    source->SetAngularDiameter(options.Method == "projection" ? 0.0 : 2.0 * light.Radius * 180.0 / testsupport::Pi);
  }
  else if (light.Shape == LightShape::Disc)
  {
    source->SetRadius(light.Radius);
  }
  Light asked = light;
  asked.Radius = options.Method == "projection" ? 0.0 : light.Radius;

  vtkNew<vtkShadowVolume> solids;
  solids->SetMethod(options.Method == "projection" ? vtkShadowVolume::Projection : vtkShadowVolume::Visibility);
  solids->SetMeshData(ToPolyData(scene.Mesh));
  solids->SetLightConnection(source->GetOutputPort());
  solids->SetResolution(options.Resolution);
  solids->SetNumberOfLightSamples(options.LightSamples);
  const Box& b = scene.Bounds;
  solids->SetBounds(b.Min.X, b.Max.X, b.Min.Y, b.Max.Y, b.Min.Z, b.Max.Z);
  const double start = Now();
  solids->Update();
  const double seconds = Now() - start;
  const double outer = VolumeOf(solids->GetOutput(0));
  const double inner = VolumeOf(solids->GetOutput(1));
  const ReferenceVolumes truth = MeasureShadow(scene.Mesh.View(), asked, b, options.Side, options.Rays);
  double lit = 0.0;
  TriangleMesh surface;
  std::string error;
  if (options.Points > 0 && ReadSurface(solids->GetOutput(1), surface, error))
  {
    const double* box = solids->GetOutput(1)->GetBounds();
    const Box around{ { box[0], box[2], box[4] }, { box[1], box[3], box[5] } };
    lit = LitShare(scene.Mesh.View(), asked, surface.View(), around, options.Points, options.Rays);
  }
  std::printf("%-13s %9.2f %9.2f +- %5.2f %7.2f %% %9.2f %9.2f +- %5.2f %7.2f %% %8.4f %% %7.2f\n", scene.Name.c_str(),
    outer, truth.Outer, truth.OuterError, Percent(outer, truth.Outer), inner, truth.Inner, truth.InnerError,
    Percent(inner, truth.Inner), 100.0 * lit, seconds);
  std::fflush(stdout);
}
} // anonymous namespace

int main(int argc, char** argv)
{
  Options options;
  std::vector<std::string> occluders = { "house", "plate", "ring", "sphere" };
  std::vector<std::string> lights = { "sun", "disc", "point" };
  ProgramOptions commandLine("Shadow solids against random points");
  commandLine.Add("--occluder", occluders, "house, plate, ring, sphere");
  commandLine.Add("--light", lights, "sun, disc, point");
  commandLine.Add("--method", options.Method, "visibility or projection");
  commandLine.Add("--resolution", options.Resolution, "cells along the longest side");
  commandLine.Add("--light-samples", options.LightSamples, "points inside the light");
  commandLine.Add("--side", options.Side, "the cube of this many reference points for the volumes");
  commandLine.Add("--points", options.Points, "reference points inside the inner bound");
  commandLine.Add("--rays", options.Rays, "to the rim of the light, and as many inside, from each reference point");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    std::printf("%-13s %9s %9s    %5s %9s %9s %9s    %5s %9s %10s %7s\n", "scene", "outer", "reference", "", "off",
      "inner", "reference", "", "off", "sees light", "seconds");
    for (const std::string& occluder : occluders)
    {
      for (const std::string& light : lights)
      {
        Measure(MakeSolidScene(occluder, light), options);
      }
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  return 0;
}
