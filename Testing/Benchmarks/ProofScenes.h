// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProofScenes.h
 * @brief Meshes and lights that are hard on bounds of their shadow: bodies in a room, lamps in a box, beside a wall, in a ring
 * and in a dome, slender and distant things; each as it comes, and with its cones by the filters.
 */
#ifndef ProofScenes_h
#define ProofScenes_h

#include "scCone.h"
#include "scLight.h"
#include "scMeshData.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace shadowcones
{

struct ProofScene
{
  std::string Name;
  std::string LightName;
  vtkSmartPointer<vtkPolyData> Occluders; ///< labelled
  vtkSmartPointer<vtkPolyData> LightData;
  TriangleMesh Mesh;
  shadowcones::Light Light;
  Box Region; ///< where volume counts
};

/// How the cones of a scene are made.
struct ConesOfProof
{
  int Tuning = 4;      ///< of vtkConeSetFilter
  bool Paths = true;   ///< photon paths are connected
  bool Proved = true;  ///< mesh and light are connected
};

struct ProofSceneCones
{
  std::vector<Cone> Cones;
  Box CertifiedBounds;
  bool Certified = false;
  std::string Choice;   ///< "TuningChoice"
  double Seconds = 0.0; ///< for vectors, cones and proof
};

/// Names of all scenes; those of meshes that are not installed are left out.
std::vector<std::string> ProofSceneNames();
/// Lights that every scene can have instead of its own: "disc", "rectangle", "sphere", "point", "sun", "mesh".
std::vector<std::string> ProofLightNames();
/// @param light one of the names, or empty for the scene's own. Throws std::runtime_error where there is no such scene or light.
ProofScene MakeProofScene(const std::string& name, const std::string& light);
/// Throws std::runtime_error where the filters fail.
ProofSceneCones MakeCones(const ProofScene& scene, vtkIdType vectors, const ConesOfProof& how);

} // namespace shadowcones

#endif
