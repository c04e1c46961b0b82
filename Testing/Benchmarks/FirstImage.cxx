// SPDX-License-Identifier: BSD-3-Clause
#include "FirstImage.h"

#include "BenchmarkScene.h"
#include "ErrorCurve.h"

#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkLightShafts.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

namespace shadowcones
{
namespace
{
/// Of all threads together: what a busy machine does not change.
double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// How an image is made; no vectors: no cones.
struct Way
{
  const char* Name = "";
  vtkIdType Vectors = 0;
  bool Proved = true;
  bool OneLine = false; ///< by vtkLightShafts
};

const Way ways[] = {
  { "Guided without cones" },
  { "vtkLightShafts", 0, true, true },
  { "with cones as by default", 5800 },
  { "1,500 vectors", 1500 },
  { "not proved", 5800, false },
  { "1,500 vectors, not proved", 1500, false },
};
constexpr std::size_t numberOfWays = sizeof(ways) / sizeof(ways[0]);

vtkSmartPointer<vtkCamera> CameraBefore()
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.0, 2.65, 10.0);
  camera->SetFocalPoint(0.0, 2.65, 0.0);
  return camera;
}

std::vector<double> ValuesOf(vtkImageData* image)
{
  vtkDataArray* light = image->GetPointData()->GetArray("InScattering");
  std::vector<double> values;
  for (vtkIdType k = 0; k < light->GetNumberOfTuples(); ++k)
  {
    values.push_back(light->GetComponent(k, 0));
  }
  return values;
}

/// The chain from a mesh to an image, with nothing made yet.
struct Chain
{
  Chain(const BenchmarkScene& scene, const Way& way, int size)
    : Camera(CameraBefore())
  {
    const Box bounds = testsupport::RoomBounds();
    this->Labels->SetInputData(scene.Occluders);
    this->Vectors->SetInputConnection(this->Labels->GetOutputPort());
    this->Vectors->SetLightData(scene.LightData);
    this->Vectors->SetTargetNumberOfVectors(way.Vectors);
    this->Cones->SetInputConnection(this->Vectors->GetOutputPort(0));
    this->Cones->SetPhotonPathConnection(this->Vectors->GetOutputPort(1));
    if (way.Proved)
    {
      this->Cones->SetMeshConnection(this->Labels->GetOutputPort());
    }
    this->Image->SetInputConnection(this->Labels->GetOutputPort());
    this->Image->SetLightData(scene.LightData);
    if (way.Vectors > 0)
    {
      this->Image->SetConeSetConnection(this->Cones->GetOutputPort());
    }
    this->Image->SetCamera(this->Camera);
    this->Image->SetResolution(size, size);
    this->Image->SetRelativeErrorGoal(0.01);
    this->Image->SetSigmaS(scene.Medium.SigmaS.front());
    this->Image->SetMediumBounds(bounds.Min.X, bounds.Max.X, bounds.Min.Y, bounds.Max.Y, bounds.Min.Z, bounds.Max.Z);
  }

  vtkSmartPointer<vtkCamera> Camera;
  vtkNew<vtkLabelOccluders> Labels;
  vtkNew<vtkShadowVectorFilter> Vectors;
  vtkNew<vtkConeSetFilter> Cones;
  vtkNew<vtkScatteringImageFilter> Image;
};

struct Cost
{
  std::vector<double> Before; ///< seconds up to the image
  std::vector<double> First;  ///< all
  std::vector<double> Next;   ///< an image of another camera
  std::vector<double> Values;
};

void Measure(const BenchmarkScene& scene, const Way& way, int size, Cost& cost)
{
  const double start = ProcessorSeconds();
  if (way.OneLine)
  {
    const Box bounds = testsupport::RoomBounds();
    vtkNew<vtkLightShafts> shafts;
    shafts->SetInputData(scene.Occluders);
    shafts->SetLightData(scene.LightData);
    shafts->SetCamera(CameraBefore());
    shafts->SetResolution(size, size);
    shafts->SetRelativeErrorGoal(0.01);
    shafts->SetPhaseAsymmetry(0.0); // isotropic, as the others
    shafts->SetOpticalDepth(scene.Medium.SigmaS.front() * (bounds.Max.X - bounds.Min.X));
    shafts->SetMediumBounds(bounds.Min.X, bounds.Max.X, bounds.Min.Y, bounds.Max.Y, bounds.Min.Z, bounds.Max.Z);
    shafts->Update();
    cost.First.push_back(ProcessorSeconds() - start);
    cost.Values = ValuesOf(vtkImageData::SafeDownCast(shafts->GetOutputDataObject(2)));
    return;
  }
  Chain chain(scene, way, size);
  way.Vectors > 0 ? chain.Cones->Update() : chain.Labels->Update();
  cost.Before.push_back(ProcessorSeconds() - start);
  chain.Image->Update();
  const double first = ProcessorSeconds();
  cost.First.push_back(first - start);
  cost.Values = ValuesOf(chain.Image->GetOutput());
  chain.Camera->Azimuth(0.5);
  chain.Image->Update();
  cost.Next.push_back(ProcessorSeconds() - first);
}

/// With 2,048 samples a pixel, each on its own.
std::vector<double> FineImage(const BenchmarkScene& scene, int size)
{
  Chain chain(scene, ways[0], size);
  chain.Image->SetRelativeErrorGoal(0.0);
  chain.Image->SetMaximumSamples(2048);
  chain.Image->SetSeed(4711);
  chain.Image->Update();
  return ValuesOf(chain.Image->GetOutput());
}

double ErrorOf(const std::vector<double>& values, const std::vector<double>& fine)
{
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < fine.size(); ++k)
  {
    squares += (values[k] - fine[k]) * (values[k] - fine[k]);
    sum += fine[k];
  }
  return std::sqrt(squares * static_cast<double>(fine.size())) / sum;
}
} // anonymous namespace

void MeasureFirstImages(const std::string& nameOrFile, int size, int repeats)
{
  vtkObject::GlobalWarningDisplayOff(); // pixels that end at MaximumSamples
  const BenchmarkScene scene(nameOrFile);
  const std::vector<double> fine = FineImage(scene, size);
  Cost costs[numberOfWays];
  for (int k = 0; k < repeats; ++k)
  {
    for (std::size_t way = 0; way < numberOfWays; ++way)
    {
      Measure(scene, ways[way], size, costs[way]);
    }
  }
  const double without = Median(costs[0].First);
  const double nextWithout = Median(costs[0].Next);
  for (std::size_t way = 0; way < numberOfWays; ++way)
  {
    const Cost& cost = costs[way];
    const double first = Median(cost.First);
    std::printf("first: %s, %d x %d, %s: processor %.3f s, %.2f times as fast as without cones; error %.2f %%",
      scene.Name.c_str(), size, size, ways[way].Name, first, without / first, 100.0 * ErrorOf(cost.Values, fine));
    if (!cost.Next.empty())
    {
      std::printf("; before the image %.3f s, another camera %.3f s", Median(cost.Before), Median(cost.Next));
    }
    if (ways[way].Vectors > 0)
    {
      const double saved = nextWithout - Median(cost.Next);
      const double more = (first - without) / saved;
      saved > 0.0 ? std::printf("; cones have paid after %.0f more images", std::ceil(std::max(more, 0.0)))
                  : std::printf("; cones do not pay");
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

} // namespace shadowcones
