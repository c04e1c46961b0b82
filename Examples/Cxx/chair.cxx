// SPDX-License-Identifier: BSD-3-Clause
// The whole chain in C++: a mesh in a room under a ceiling lamp gives shadow vectors, cones and an image of light shafts.
//
//   chair MESH.vtp ROOM.vtp FOLDER [--mode NAME]
//
// for example: build/bin/chair Data/chair.vtp Data/cornell-box.vtp output --mode Volume
#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"
#include "vtkVisibilityVolume.h"

#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>

namespace
{
/// At the index that vtkScatteringImageFilter has for each.
const char* const modes[] = { "BruteForce", "Medium", "Fast", "Guided", "Soft", "Volume" };

bool Read(vtkXMLPolyDataReader* reader, const char* path)
{
  if (!std::filesystem::exists(path))
  {
    std::cerr << "There is no file " << path << "\n";
    return false;
  }
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput()->GetNumberOfCells() > 0;
}

/// The same diffuse reflectance for every cell, with as many wavelengths as the room has.
void AddReflectance(vtkPolyData* mesh, vtkPolyData* room, double value)
{
  vtkDataArray* ofRoom = room->GetCellData()->GetArray("Reflectance");
  if (!ofRoom)
  {
    return;
  }
  vtkNew<vtkFloatArray> reflectance;
  reflectance->SetName("Reflectance");
  reflectance->SetNumberOfComponents(ofRoom->GetNumberOfComponents());
  reflectance->SetNumberOfTuples(mesh->GetNumberOfCells());
  reflectance->Fill(value);
  mesh->GetCellData()->AddArray(reflectance);
}

/// Works for the writers of VTK's XML files and of images alike.
template <typename Writer>
bool Write(vtkAlgorithmOutput* port, const std::filesystem::path& path)
{
  vtkNew<Writer> writer;
  writer->SetInputConnection(port);
  writer->SetFileName(path.string().c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
} // namespace

int main(int argc, char* argv[])
{
  const bool hasMode = argc == 6 && std::string(argv[4]) == "--mode";
  const auto* chosen = std::find(std::begin(modes), std::end(modes), std::string(hasMode ? argv[5] : "Guided"));
  if ((argc != 4 && !hasMode) || chosen == std::end(modes))
  {
    std::cerr << "usage: chair MESH.vtp ROOM.vtp FOLDER [--mode NAME]\n"
              << "NAME is Guided (default), Volume, Soft, BruteForce, Medium or Fast\n";
    return EXIT_FAILURE;
  }
  const auto mode = static_cast<int>(chosen - std::begin(modes));
  std::error_code error;
  const std::filesystem::path folder = argv[3];
  std::filesystem::create_directories(folder, error);
  vtkNew<vtkXMLPolyDataReader> mesh;
  vtkNew<vtkXMLPolyDataReader> walls;
  if (error || !Read(mesh, argv[1]) || !Read(walls, argv[2]))
  {
    std::cerr << "Cannot read the meshes or make the folder " << folder << "\n";
    return EXIT_FAILURE;
  }

  // The readers' output must not change: the pipeline owns it.
  vtkNew<vtkPolyData> painted;
  painted->ShallowCopy(mesh->GetOutput());
  AddReflectance(painted, walls->GetOutput(), 0.6);

  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputData(painted);

  // Appending keeps the arrays that both have. The walls' "OccluderId" is -1: they catch shadows and cast none.
  vtkNew<vtkAppendPolyData> room;
  room->AddInputConnection(occluders->GetOutputPort());
  room->AddInputConnection(walls->GetOutputPort());

  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(0.0, 5.49, 0.0);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.5);

  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputConnection(room->GetOutputPort());
  vectors->SetLightConnection(light->GetOutputPort());
  vectors->SetTargetNumberOfVectors(5800);

  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetPhotonPathConnection(vectors->GetOutputPort(1));
  cones->SetMeshConnection(room->GetOutputPort()); // cones that are proved to hold all of the shadow

  if (mode == vtkScatteringImageFilter::Soft)
  {
    cones->SetTuningToSoft(); // discs that stand for the chair itself
  }

  const double fog[6] = { -2.75, 2.75, 0.0, 5.2, -2.75, 2.75 };
  vtkNew<vtkVisibilityVolume> volume;
  volume->SetInputConnection(cones->GetOutputPort());
  volume->SetLightConnection(light->GetOutputPort());
  volume->SetMeshConnection(room->GetOutputPort());
  volume->SetBounds(fog);

  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 2.75, 12.5);
  camera->SetFocalPoint(0.0, 2.75, 0.0);
  camera->SetViewAngle(32.0);

  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(room->GetOutputPort());
  image->SetLightConnection(light->GetOutputPort());
  image->SetConeSetConnection(cones->GetOutputPort());
  image->SetCamera(camera);
  image->SetResolution(256, 256);
  image->SetMode(mode);
  if (mode == vtkScatteringImageFilter::Volume)
  {
    image->SetVisibilityVolumeConnection(volume->GetOutputPort()); // filled once, for any number of cameras
  }
  image->SetSigmaS(0.12);
  image->SetMediumBounds(fog);
  image->Update();

  if (image->GetOutput()->GetNumberOfPoints() == 0 ||
    !Write<vtkXMLPolyDataWriter>(vectors->GetOutputPort(), folder / "shadow-vectors.vtp") ||
    !Write<vtkXMLPolyDataWriter>(cones->GetOutputPort(), folder / "cone-set.vtp") ||
    !Write<vtkXMLImageDataWriter>(image->GetOutputPort(), folder / "scattering.vti") ||
    !Write<vtkPNGWriter>(image->GetOutputPort(), folder / "scattering.png"))
  {
    std::cerr << "Cannot write to " << folder << ", or the chain gave nothing: its messages stand above\n";
    return EXIT_FAILURE;
  }

  std::cout << "shadow vectors " << vectors->GetOutput()->GetNumberOfPoints() << "\ncones "
            << cones->GetOutput()->GetNumberOfPoints() << "\nocclusion rays "
            << image->GetOutput()->GetFieldData()->GetArray("NumberOfOcclusionRays")->GetTuple1(0) << "\nwritten to "
            << folder.string() << "\n";
  return EXIT_SUCCESS;
}
