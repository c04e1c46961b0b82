// SPDX-License-Identifier: BSD-3-Clause
// Processes that share the work: each asks for the piece of its own rank, as ParaView's servers do, and each has its tile of the
// image.
//
//   mpirun -np 2 ranks MESH.vtp [--size PIXELS]
//
// for example: mpirun -np 2 build/bin/ranks Data/chair.vtp
// Every process reads the whole mesh. Photons, the search for parameters and the grid are shared, and their results joined.
#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkRankWork.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"
#include "vtkVisibilityVolume.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace
{
/// A number that other values would change (FNV-1a).
std::uint64_t HashOf(vtkDataArray* array)
{
  std::uint64_t hash = 14695981039346656037u;
  const auto* bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  for (vtkIdType i = 0; i < array->GetDataSize() * array->GetDataTypeSize(); ++i)
  {
    hash = (hash ^ bytes[i]) * 1099511628211u;
  }
  return hash;
}

void Run(const char* path, int size, vtkMultiProcessController* controller)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path);
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(0.0, 5.49, 0.0);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.5);
  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputConnection(occluders->GetOutputPort());
  vectors->SetLightConnection(light->GetOutputPort());
  vectors->SetNumberOfPhotons(12000);
  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetPhotonPathConnection(vectors->GetOutputPort(1));
  vtkNew<vtkVisibilityVolume> volume;
  volume->SetInputConnection(cones->GetOutputPort());
  volume->SetMeshConnection(occluders->GetOutputPort());
  volume->SetLightConnection(light->GetOutputPort());
  volume->SetDimensions(33, 33, 33);
  volume->SetBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75); // bounds from the data would be looked for by each process alone
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 2.75, 12.5);
  camera->SetFocalPoint(0.0, 2.75, 0.0);
  camera->SetViewAngle(32.0);
  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(occluders->GetOutputPort());
  image->SetLightConnection(light->GetOutputPort());
  image->SetVisibilityVolumeConnection(volume->GetOutputPort());
  image->SetModeToVolume();
  image->SetCamera(camera);
  image->SetResolution(size, size);
  image->SetMediumBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  image->UpdatePiece(rank, ranks, 0);

  // One process speaks at a time.
  for (int k = 0; k < ranks; ++k)
  {
    controller->Barrier();
    if (k == rank)
    {
      const int* extent = image->GetOutput()->GetExtent();
      std::cout << "process " << rank << " of " << ranks << ": " << vtkRankWork::GetNumberOfItems() << " items, "
                << vtkRankWork::GetNumberOfRays() << " rays, " << vtkRankWork::GetBytesSent() << " bytes sent; pixels "
                << extent[0] << ".." << extent[1] << " x " << extent[2] << ".." << extent[3] << std::endl;
    }
  }
  controller->Barrier();
  if (rank == 0)
  {
    std::cout << "vectors " << HashOf(vectors->GetOutput()->GetPoints()->GetData()) << " cones "
              << HashOf(cones->GetOutput()->GetPoints()->GetData()) << " grid "
              << HashOf(volume->GetOutput()->GetPointData()->GetArray("Visibility")) << std::endl;
  }
}
} // anonymous namespace

int main(int argc, char* argv[])
{
  const bool sized = argc == 4 && std::string(argv[2]) == "--size" && std::atoi(argv[3]) > 0;
  if ((argc != 2 && !sized) || !std::filesystem::exists(argv[1]))
  {
    std::cerr << "usage: mpirun -np N ranks MESH.vtp [--size PIXELS]\n";
    return 2;
  }
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Run(argv[1], sized ? std::atoi(argv[3]) : 64, controller);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return 0;
}
