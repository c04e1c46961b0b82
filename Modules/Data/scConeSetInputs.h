// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeSetInputs.h
 * @brief What a cone set is fitted to and proved with: shadow vectors and photon paths, mesh and lights.
 */
#ifndef scConeSetInputs_h
#define scConeSetInputs_h

#include "ShadowConesDataModule.h"
#include "scLightExtent.h"
#include "scMeshData.h"
#include "scVectorData.h"
#include "scWarnings.h"

#include <string>
#include <vector>

class vtkInformationVector;

namespace shadowcones
{

struct SHADOWCONESDATA_EXPORT ConeSetInputs
{
  ShadowVectorArrays Vectors;
  PhotonPathArrays Paths;
  std::vector<LightExtent> Extents; ///< of the lights that the vectors come from
  TriangleMesh Mesh;
  std::vector<Light> Lights; ///< to prove the set for
  Warnings Said;
};

/**
 * Read vectors (port 0), and where they are connected photon paths (1), mesh (2) and lights (3). Without connected lights
 * those that the vectors tell of in their field data are taken, unless one is a mesh, whose faces do not travel, or does not
 * fit the vectors. The vectors' emission points give the extent of such lights.
 * @return false, with a sentence in @p error.
 */
SHADOWCONESDATA_EXPORT bool ReadConeSetInputs(
  vtkInformationVector** inputVector, ConeSetInputs& inputs, std::string& error);

} // namespace shadowcones

#endif
