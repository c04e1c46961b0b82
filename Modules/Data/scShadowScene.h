// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowScene.h
 * @brief Lights and a mesh that are asked for shadows by rays alone, without cones.
 */
#ifndef scShadowScene_h
#define scShadowScene_h

#include "ShadowConesDataModule.h"
#include "scMeshData.h"
#include "scSceneLights.h"

#include <cstdint>
#include <string>

class vtkDataObject;
class vtkInformationVector;

namespace shadowcones
{

struct SHADOWCONESDATA_EXPORT ShadowScene
{
  SceneLights Lights;
  TriangleMesh Mesh; ///< without its receivers
  std::uint64_t Fingerprint = 0;
};

/// Read both ports. @return false, with a sentence in @p error, where one is not connected or has a fault.
SHADOWCONESDATA_EXPORT bool ReadShadowScene(
  vtkInformationVector** inputs, int lightPort, int meshPort, ShadowScene& scene, std::string& error);

/// Tell in the field data of an output of what it is: names of occluders, fingerprints of casters and lights.
SHADOWCONESDATA_EXPORT void WriteShadowScene(const ShadowScene& scene, vtkDataObject* output);

} // namespace shadowcones

#endif
