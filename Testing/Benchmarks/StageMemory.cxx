// SPDX-License-Identifier: BSD-3-Clause
#include "StageMemory.h"

#include "SphereRoom.h"

#include "vtkConeSetFilter.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkPoints.h"
#include "vtkShadowVectorFilter.h"
#include "vtkSmartPointer.h"

#include <malloc.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

namespace shadowcones
{
namespace
{
/// The largest memory of the process since the last restart, in bytes; 0 where the system does not say.
double PeakMemory()
{
  double kilobytes = 0.0;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, 6, "VmHWM:") == 0)
    {
      kilobytes = std::stod(line.substr(6));
    }
  }
  return 1024.0 * kilobytes;
}

/// The largest memory of a run over what was there before, against a formula.
void PrintMemory(const char* what, const std::function<void()>& run, const std::function<double()>& formula)
{
  malloc_trim(0); // what was freed before would hide what is taken next
  std::ofstream("/proc/self/clear_refs") << 5;
  const double before = PeakMemory();
  run();
  const double measured = PeakMemory() - before;
  const double expected = formula();
  std::printf("memory: %-44s formula %8.1f MB, measured %8.1f MB, ratio %.2f\n", what, 1e-6 * expected, 1e-6 * measured,
    measured > 0.0 ? expected / measured : 0.0);
  std::fflush(stdout);
}

/// Of a mesh as it is kept, and so many bytes a triangle for what is made of it.
double MeshBytes(vtkPolyData* mesh, double ofTriangle)
{
  const auto points = static_cast<double>(mesh->GetNumberOfPoints());
  return 24.0 * points + (32.0 + ofTriangle) * static_cast<double>(mesh->GetNumberOfCells());
}

void MeasureMesh(double triangles)
{
  SphereRoom room(triangles);
  room.Image->SetVisibilityVolumeConnection(nullptr); // which has a search tree of its own
  room.Image->SetResolution(8, 8);
  room.Image->SetModeToBruteForce();
  room.Light->Update();
  const auto count = static_cast<double>(room.Mesh->GetNumberOfCells());
  PrintMemory("mesh and tree, while they are built", [&] { room.Image->Update(); }, [&] { return MeshBytes(room.Mesh, 160.0); });
  std::printf("memory: kept %.1f bytes a triangle\n", static_cast<double>(room.Image->GetPreparedMemory()) / count);
}

void MeasureVolumes()
{
  SphereRoom room(2000.0);
  room.Volume->SetDimensions(257, 257, 257);
  room.Volume->SetNumberOfLightSamples(1);
  room.Volume->SetBrickParts(1);
  room.Light->Update();
  const double points = 257.0 * 257.0 * 257.0;
  PrintMemory("volume of 257^3 points, filled", [&] { room.Volume->Update(); }, [&] { return 15.0 * points; });
  room.Image->SetResolution(8, 8);
  PrintMemory("the same, read by an image", [&] { room.Image->Update(); }, [&] { return 10.0 * points; });
}

void MeasureImage()
{
  SphereRoom room(2000.0);
  room.Image->SetModeToGuided();
  room.Image->SetRelativeErrorGoal(0.2);
  room.Image->SetResolution(8, 8);
  room.Image->Update();
  room.Image->SetResolution(1024, 1024);
  PrintMemory("image of 1024 x 1024, seven wavelengths", [&] { room.Image->Update(); },
    [] { return (16.0 * 7.0 + 68.0) * 1024.0 * 1024.0; });
}

vtkSmartPointer<vtkPolyData> Labelled(const SphereRoom& room)
{
  vtkNew<vtkLabelOccluders> label;
  label->SetInputData(room.Mesh);
  label->Update();
  return label->GetOutput();
}

/// Photons, and cones of them: as they are, and tuned.
void MeasureCones()
{
  SphereRoom room(2000.0);
  room.Light->Update();
  const vtkSmartPointer<vtkPolyData> mesh = Labelled(room);
  vtkNew<vtkShadowVectorFilter> photons;
  photons->SetToPaper();
  photons->SetInputData(mesh);
  photons->SetLightData(room.Light->GetOutput());
  photons->SetTargetNumberOfVectors(200000);
  const auto counts = [&photons](double ofVector, double ofPath)
  {
    const auto number = [&photons](int port)
    { return static_cast<double>(vtkPolyData::SafeDownCast(photons->GetOutputDataObject(port))->GetNumberOfPoints()); };
    return ofVector * number(0) + ofPath * number(1);
  };
  PrintMemory("200,000 vectors and their photons", [&] { photons->Update(); }, [&] { return counts(120.0, 250.0); });
  vtkNew<vtkConeSetFilter> cones;
  cones->SetToPaper();
  cones->SetInputData(photons->GetOutputDataObject(0));
  cones->SetPhotonPathData(photons->GetOutputDataObject(1));
  PrintMemory("cones of them", [&] { cones->Update(); }, [&] { return counts(150.0, 200.0); });
  cones->SetTuningToConservative();
  PrintMemory("cones of them, tuned", [&] { cones->Update(); }, [&] { return counts(150.0, 200.0) + 480.0 * 40000.0; });
}

void MeasureProof()
{
  SphereRoom room(2e5);
  room.Light->Update();
  const vtkSmartPointer<vtkPolyData> mesh = Labelled(room);
  vtkNew<vtkShadowVectorFilter> photons;
  photons->SetInputData(mesh);
  photons->SetLightData(room.Light->GetOutput());
  photons->SetTargetNumberOfVectors(5800);
  photons->Update();
  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputData(photons->GetOutputDataObject(0));
  cones->SetPhotonPathData(photons->GetOutputDataObject(1));
  cones->SetLightData(room.Light->GetOutput());
  cones->SetMeshData(mesh);
  // Where the fitted cones hold no part of the mesh, as here with tight ones.
  PrintMemory("cones of 200,000 triangles, proved", [&] { cones->Update(); },
    [&] { return 14e6 + MeshBytes(mesh, 265.0) + 600.0 * 5800.0; });
}

void MeasureProbe()
{
  SphereRoom room(2000.0);
  room.Light->Update();
  constexpr int side = 100;
  vtkNew<vtkPoints> where;
  for (int k = 0; k < side * side * side; ++k)
  {
    where->InsertNextPoint(0.05 * (k % side) - 2.5, 0.05 * (k / side % side), 0.05 * (k / side / side) - 2.5);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(where);
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(data);
  probe->SetLightData(room.Light->GetOutput());
  probe->SetMeshData(room.Mesh);
  probe->SetMethodToExact();
  probe->SetNumberOfLightSamples(1);
  PrintMemory("a million points probed", [&] { probe->Update(); }, [] { return 66.0 * side * side * side; });
}
} // anonymous namespace

void MeasureMemory(double triangles)
{
  MeasureMesh(triangles);
  MeasureVolumes();
  MeasureImage();
  MeasureCones();
  MeasureProof();
  MeasureProbe();
}

} // namespace shadowcones
