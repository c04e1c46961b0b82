// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowScene.h"

#include "scFingerprints.h"
#include "scLightData.h"
#include "scOccluderNames.h"
#include "scSentence.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace shadowcones
{

bool ReadShadowScene(vtkInformationVector** inputs, int lightPort, int meshPort, ShadowScene& scene, std::string& error)
{
  if (inputs[lightPort]->GetNumberOfInformationObjects() == 0)
  {
    error = Sentence("No light on input port ", lightPort,
      ": connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.");
    return false;
  }
  vtkDataObject* mesh = vtkDataObject::GetData(inputs[meshPort]);
  if (!mesh)
  {
    error = Sentence("No mesh on input port ", meshPort, ": connect a vtkLabelOccluders with SetMeshConnection.");
    return false;
  }
  if (!ReadLights(inputs[lightPort], scene.Lights, error) || !ReadTriangles(mesh, scene.Mesh, error))
  {
    return false;
  }
  if (scene.Mesh.Triangles.empty() && scene.Mesh.NumberOfCells > 0)
  {
    error = Sentence("The mesh on input port ", meshPort, " has ", scene.Mesh.NumberOfCells,
      " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first.");
    return false;
  }
  scene.Fingerprint = CastersFingerprintOf(scene.Mesh);
  DropReceivers(scene.Mesh);
  return true;
}

void WriteShadowScene(const ShadowScene& scene, vtkDataObject* output)
{
  WriteOccluderNames(scene.Mesh.OccluderNames, output->GetFieldData());
  WriteFingerprints(castersFingerprint, { scene.Fingerprint }, output->GetFieldData());
  WriteLightFingerprints(scene.Lights.Lights, output);
}

} // namespace shadowcones
