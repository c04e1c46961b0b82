// SPDX-License-Identifier: BSD-3-Clause
#include "LargeRequests.h"

#include "ChildProcess.h"
#include "DataBytes.h"
#include "Messages.h"
#include "TestPolyData.h"
#include "TimeLimit.h"

#include "vtkConeSetFilter.h"
#include "vtkConeSetProbe.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"
#include "vtkVisibilityVolume.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <unistd.h>

using namespace shadowcones::testsupport;
using namespace invariants;

namespace robustness
{
namespace
{
/// A filter, and what makes its request large or small.
struct Request
{
  vtkSmartPointer<vtkAlgorithm> Filter;
  std::function<void(bool isLarge)> Ask;
};

struct Large
{
  const char* Name;
  const char* Message; ///< before the reason
  std::function<Request()> Make;
};

constexpr const char* reason = "there is not enough memory; ask for less, or of less";

vtkSmartPointer<vtkPolyData> Box()
{
  return MeshBuilder().AddBox(0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0).Build();
}

vtkSmartPointer<vtkPolyData> Lamp()
{
  vtkNew<vtkAreaLightSource> lamp;
  lamp->SetShapeToDisc();
  lamp->SetCenter(0.0, 0.0, 3.0);
  lamp->SetNormal(0.0, 0.0, -1.0);
  lamp->SetRadius(0.2);
  lamp->Update();
  return lamp->GetOutput();
}

vtkSmartPointer<vtkShadowVectorFilter> Photons(vtkIdType count)
{
  auto photons = vtkSmartPointer<vtkShadowVectorFilter>::New();
  photons->SetInputData(Box());
  photons->SetLightData(Lamp());
  photons->SetNumberOfPhotons(count);
  return photons;
}

vtkSmartPointer<vtkImageData> Points(int side)
{
  auto points = vtkSmartPointer<vtkImageData>::New();
  points->SetDimensions(side, side, side);
  points->SetOrigin(-1.0, -1.0, -2.0);
  points->SetSpacing(2.0 / side, 2.0 / side, 2.0 / side);
  return points;
}

Request MakePhotons()
{
  const auto photons = Photons(100);
  return { photons, [photons](bool isLarge) { photons->SetNumberOfPhotons(isLarge ? 1000000000 : 100); } };
}

/// The vectors are there before the limit is.
Request MakeCones()
{
  const auto few = Photons(500);
  const auto many = Photons(150000);
  few->Update();
  many->Update();
  auto cones = vtkSmartPointer<vtkConeSetFilter>::New();
  cones->SetTuningToManual();
  return { cones, [=](bool isLarge) { cones->SetInputData((isLarge ? many : few)->GetOutput(0)); } };
}

Request MakeVolume()
{
  auto volume = vtkSmartPointer<vtkVisibilityVolume>::New();
  volume->SetMeshData(Box());
  volume->SetLightData(Lamp());
  volume->SetBounds(-1.0, 1.0, -1.0, 1.0, -2.0, 2.0);
  volume->SetNumberOfLightSamples(1);
  return { volume, [volume](bool isLarge)
    {
      const int side = isLarge ? 512 : 6;
      volume->SetDimensions(side, side, side);
    } };
}

Request MakeImage()
{
  auto image = vtkSmartPointer<vtkScatteringImageFilter>::New();
  image->SetInputData(Box());
  image->SetLightData(Lamp());
  image->SetMediumBounds(-1.0, 1.0, -1.0, 1.0, -2.0, 2.0);
  image->SetModeToBruteForce();
  image->SetNumberOfLightSamples(1);
  return { image, [image](bool isLarge)
    {
      const int side = isLarge ? 8192 : 6;
      image->SetResolution(side, side);
    } };
}

Request MakeProbe()
{
  auto probe = vtkSmartPointer<vtkConeSetProbe>::New();
  probe->SetMeshData(Box());
  probe->SetLightData(Lamp());
  probe->SetNumberOfLightSamples(1);
  return { probe, [probe](bool isLarge) { probe->SetInputData(Points(isLarge ? 400 : 6)); } };
}

/// A small request, a large one, the small one again. @return what was not as it should be.
std::string Try(const Large& large)
{
  constexpr std::int64_t room = 12 << 20;
  const Request request = large.Make();
  request.Ask(false);
  request.Filter->UpdateWholeExtent();
  const auto small = BytesOfOutputs(request.Filter);
  if (AreOutputsEmpty(request.Filter))
  {
    return "nothing of a small request";
  }
  LimitAddresses(room);
  request.Ask(true);
  {
    const Messages messages(request.Filter);
    request.Filter->UpdateWholeExtent();
    if (messages.Errors.find(std::string(large.Message) + reason) == std::string::npos)
    {
      return "no such message: " + messages.Errors;
    }
    if (!AreOutputsEmpty(request.Filter))
    {
      return "outputs that are not empty";
    }
  }
  request.Ask(false);
  const Messages messages(request.Filter);
  request.Filter->UpdateWholeExtent();
  return messages.Errors.empty() ? Difference(small, BytesOfOutputs(request.Filter)) : "then: " + messages.Errors;
}
} // anonymous namespace

int TryLargeRequests()
{
  const std::vector<Large> all = {
    { "photons", "Tracing photons failed: ", MakePhotons },
    { "cones", "", MakeCones },
    { "volume", "Filling the volume failed: ", MakeVolume },
    { "image", "Rendering failed: ", MakeImage },
    { "probe", "", MakeProbe },
  };
  int lost = 0;
  for (const Large& large : all)
  {
    const ChildEnd end = RunInChild(
      [&](const Tell& tell)
      {
        alarm(static_cast<unsigned>(TimeLimit(60.0)));
        vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
        vtkSMPTools::SetBackend("Sequential");
        tell({ "end", Try(large) });
      });
    const std::string fault = end.Crashed() ? end.Why()
      : end.Lines.empty()                   ? "nothing told"
      : end.Lines[0].size() > 1             ? end.Lines[0][1]
                                            : "";
    lost += fault.empty() ? 0 : 1;
    std::cout << "more than there is memory for, " << large.Name << ": " << (fault.empty() ? "a message" : "LOST " + fault)
              << "\n" << std::flush;
  }
  return lost;
}

} // namespace robustness
