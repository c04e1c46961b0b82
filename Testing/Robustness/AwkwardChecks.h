// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AwkwardChecks.h
 * @brief Every filter in every mode, asked of one awkward mesh and held against the truth.
 */
#ifndef AwkwardChecks_h
#define AwkwardChecks_h

#include "AwkwardMeshes.h"
#include "PlainRays.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace robustness
{

enum class Verdict
{
  Right, ///< as the truth has it
  Sound, ///< every number is finite and in its range; there is no truth to hold it against
  Said,  ///< a message, where one is due
  Lost
};

struct Finding
{
  Verdict Kind = Verdict::Sound;
  std::string Text; ///< the message, or what is wrong
};

/// A mesh under a disc lamp, what the chain makes of it, and where it is asked.
struct Scene
{
  explicit Scene(const AwkwardMesh& mesh);

  const AwkwardMesh& Mesh;
  PlainRays Rays;
  vtkSmartPointer<vtkPolyData> Lamp;
  vtkSmartPointer<vtkPolyData> Places;
  std::vector<shadowcones::Vector3> PlacesBefore; ///< scaling and moving
  std::vector<double> Seen;                       ///< the share of the lamp that each place sees
  vtkSmartPointer<vtkPolyData> Labelled; ///< or, where no labels are given, the mesh as it is

  ///@{
  /// Made when they are first asked for.
  vtkPolyData* Vectors() const;
  vtkPolyData* Paths() const;
  vtkPolyData* Cones() const;
  ///@}

private:
  mutable vtkSmartPointer<vtkPolyData> MadeVectors;
  mutable vtkSmartPointer<vtkPolyData> MadePaths;
  mutable vtkSmartPointer<vtkPolyData> MadeCones;
};

struct Check
{
  std::string Filter;
  std::string Mode;
  std::function<Finding(const Scene&)> Ask;
};

const std::vector<Check>& AllChecks();

} // namespace robustness

#endif
