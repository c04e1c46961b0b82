// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RealMeshes.h
 * @brief Meshes that nobody here made: those of Debian's glmark2-data, where it is installed.
 */
#ifndef RealMeshes_h
#define RealMeshes_h

#include "vtk3DSImporter.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAppendPolyData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <fstream>
#include <string>

namespace shadowcones
{
namespace testsupport
{

/// Path of a model; empty where it is not installed.
inline std::string Model(const char* name)
{
  const std::string path = std::string("/usr/share/glmark2/models/") + name;
  return std::ifstream(path) ? path : std::string();
}

/// The importer's meshes joined, as they come: split at creases.
inline vtkSmartPointer<vtkPolyData> Import3DS(const std::string& path, bool normals = false)
{
  vtkNew<vtk3DSImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetComputeNormals(normals);
  importer->Update();
  vtkNew<vtkAppendPolyData> append;
  vtkActorCollection* actors = importer->GetRenderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetMapper()->Update();
    append->AddInputData(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0)));
  }
  append->Update();
  return append->GetOutput();
}

} // namespace testsupport
} // namespace shadowcones

#endif
