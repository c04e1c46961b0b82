// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AwkwardMeshes.h
 * @brief The one list of meshes that are easy to get wrong, each with the triangles that it truly consists of.
 */
#ifndef AwkwardMeshes_h
#define AwkwardMeshes_h

#include "scVector3.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace robustness
{

/// How much is asked of a mesh.
enum class Run
{
  Quick, ///< in every run of the tests
  Long   ///< by hand
};

/**
 * A mesh about the origin, some 2 units in size and above z = -0.4, that was then scaled and moved. What it truly is was
 * written down as it was built, by no code of the project: corners before scaling and moving, three a triangle.
 */
struct AwkwardMesh
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<shadowcones::Vector3> Corners;
  double Scale = 1.0;
  shadowcones::Vector3 Offset;
  std::string Refusal; ///< a part of the message where there is no right answer
  Run When = Run::Quick;

  shadowcones::Vector3 Place(const shadowcones::Vector3& p) const { return this->Scale * p + this->Offset; }
  shadowcones::Vector3 Unplace(const shadowcones::Vector3& p) const { return (1.0 / this->Scale) * (p - this->Offset); }
  /// Does it hide any light?
  bool Casts() const { return !this->Corners.empty(); }
};

/// All of the list that belong to a run; one mesh alone where a name is given.
std::vector<AwkwardMesh> AwkwardMeshes(Run run, const std::string& name = std::string());

} // namespace robustness

#endif
