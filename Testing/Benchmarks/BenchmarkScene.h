// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkScene.h
 * @brief The room, its light and its occluders, and cone sets made from them with the filters.
 */
#ifndef BenchmarkScene_h
#define BenchmarkScene_h

#include "scConeSet.h"
#include "scLight.h"
#include "scMeshData.h"
#include "scOccluderScene.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace shadowcones
{

/// Seconds since some moment.
double Now();

/// x and z in +-2.75, y in 0..5.2.
Box RoomBounds();

/// An occluder in the room under a disc light of radius 0.5 at (0, 5.49, 0) that faces down.
struct BenchmarkScene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Occluders; ///< labelled
  vtkSmartPointer<vtkPolyData> LightData;
  Light Source;
  TriangleMesh Mesh;
  std::unique_ptr<OccluderScene> Fast;
};

/**
 * Load "chair", "tree" or "blob", or a file (.vtp, .obj, .ply, .stl), which is scaled to a height of 3 and stood on
 * the floor.
 * Throws std::runtime_error where there is no such mesh.
 */
BenchmarkScene LoadBenchmarkScene(const std::string& nameOrFile);

/// Parameters of a cone set and of the vectors that it is made from.
struct ConeParameters
{
  std::string Set = "bounds";
  vtkIdType Vectors = 5800;
  int Storage = 1; ///< 0 BackSide, 1 HitPoint
  int P1 = 100;
  int P2 = 20;
  int P3 = 16;
  int P4 = 20;
  double Variance = 1.8;
  double Planarity = 0.0;
  int Expansion = 2; ///< 0 MaximumDeviation, 1 RadiusRatio, 2 LightGeometry
  double Fraction = 1.0;
  bool Cosine = false;
  bool Overlap = true;
  int Seed = 1;
  int Tuning = 0; ///< 0 Manual; 1 Conservative, 2 Preview, 3 Soft choose what is above, but for Storage and Seed
};

/**
 * "paper": section 3.2 as it stands. "bounds": few, large, conservative cones. "conservative", "preview", "soft":
 * tuned. Throws std::runtime_error otherwise.
 */
ConeParameters NamedParameters(const std::string& set);
/// The parameters as one line, for a table.
std::string Describe(const ConeParameters& parameters);

struct VectorsOfScene
{
  vtkSmartPointer<vtkPolyData> Vectors;
  vtkSmartPointer<vtkPolyData> Paths;
  double Seconds = 0.0;
};
/// Runs vtkShadowVectorFilter; vectors depend on Vectors, Storage and Seed only.
VectorsOfScene MakeVectors(const BenchmarkScene& scene, const ConeParameters& parameters);

struct ConesOfScene
{
  std::vector<Cone> Cones;
  double Discarded = 0.0; ///< share of the vectors that no cone holds
  double TuningSeconds = 0.0; ///< 0 where Tuning is Manual
  double Seconds = 0.0;       ///< to fit with the parameters given or found
};
/// Runs vtkConeSetFilter.
ConesOfScene MakeCones(const VectorsOfScene& vectors, const ConeParameters& parameters);

} // namespace shadowcones

#endif
