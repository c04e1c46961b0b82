// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkScene.h
 * @brief The one scene of all benchmarks: an occluder in the room under its lamp, and all that an image of it is made from.
 */
#ifndef BenchmarkScene_h
#define BenchmarkScene_h

#include "Room.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scLight.h"
#include "scMeshData.h"
#include "scOccluderScene.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scVisibilityGrid.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

namespace shadowcones
{

using testsupport::RoomBounds;
using testsupport::RoomLamp;

/// Seconds since some moment.
double Now();

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
struct ConesOfScene
{
  std::vector<Cone> Cones;
  double Discarded = 0.0; ///< share of the vectors that no cone holds
  double TuningSeconds = 0.0; ///< 0 where Tuning is Manual
  double Seconds = 0.0;       ///< to fit with the parameters given or found
};
/// Runs vtkConeSetFilter.
ConesOfScene MakeCones(const VectorsOfScene& vectors, const ConeParameters& parameters);

class BenchmarkScene
{
public:
  /**
   * "chair", "tree" or "blob", or a file (.vtp, .obj, .ply, .stl), which is scaled to a height of 3 and stood on the floor;
   * or one of DarkScenes.h, with a light, a medium and a camera of its own and no other walls.
   * Throws std::runtime_error where there is no such mesh.
   */
  explicit BenchmarkScene(const std::string& nameOrFile, const RoomLamp& lamp = {});
  BenchmarkScene(const BenchmarkScene&) = delete;
  BenchmarkScene& operator=(const BenchmarkScene&) = delete;

  std::string Name;
  vtkSmartPointer<vtkPolyData> Occluders; ///< labelled
  vtkSmartPointer<vtkPolyData> LightData;
  shadowcones::Light Light;
  TriangleMesh Mesh;
  std::unique_ptr<OccluderScene> Fast; ///< of the mesh alone
  TriangleMesh Room;                   ///< with the walls of Data/cornell-box.vtp, which have OccluderId -1
  std::vector<float> Reflectance;      ///< of the room: one a triangle and wavelength
  shadowcones::Medium Medium;          ///< isotropic, in RoomBounds(), but for dark scenes
  shadowcones::Camera Camera;

  /// Runs vtkShadowVectorFilter; vectors depend on Vectors, Storage and Seed only.
  VectorsOfScene MakeVectors(const ConeParameters& parameters) const;
  /// Vectors and cones of them.
  std::vector<Cone> MakeConesOf(const ConeParameters& parameters) const
  {
    return MakeCones(this->MakeVectors(parameters), parameters).Cones;
  }

  // The stages of an image, in order, so that each can be timed alone. Each takes the results of those before, and may be
  // run again. Vectors and cones are those of the parameter set "bounds".
  void BuildRoom() { this->FastRoom = std::make_unique<OccluderScene>(this->Room.View()); }
  /// @param vectors that are asked for; 0: 5,800, on the tree 20,000.
  void TraceVectors(vtkIdType vectors);
  void FitCones() { this->Fitted = MakeCones(this->Traced, NamedParameters("bounds")); }
  void BuildHierarchy() { this->Tree = std::make_unique<ConeHierarchy>(this->Fitted.Cones, this->Medium.Bounds); }
  VisibilityGrid FillGrid(int dimensions, int lightSamples, int brickParts) const;
  /// Medium term alone: surfaces black, the light not seen.
  ScatteringOptions Options(ScatteringMode mode, int size) const;
  ScatteringScene View(const ConeHierarchy* cones = nullptr, const VisibilityGrid* grid = nullptr) const
  {
    return { *this->FastRoom, this->Light, this->Medium, this->Camera, cones, grid };
  }
  void Render(const ScatteringOptions& options, const ConeHierarchy* cones, const VisibilityGrid* grid,
    ScatteringImage& image) const
  {
    RenderScattering(this->View(cones, grid), options, Monitor(), image);
  }

  vtkIdType NumberOfTriangles() const { return static_cast<vtkIdType>(this->Mesh.Triangles.size() / 3); }
  vtkIdType NumberOfVectors() const { return this->Traced.Vectors->GetNumberOfPoints(); }
  vtkIdType NumberOfPhotons() const;
  const std::vector<Cone>& Cones() const { return this->Fitted.Cones; }
  const ConeHierarchy* Hierarchy() const { return this->Tree.get(); }

private:
  void AddWalls();

  std::unique_ptr<OccluderScene> FastRoom;
  VectorsOfScene Traced;
  ConesOfScene Fitted;
  std::unique_ptr<ConeHierarchy> Tree;
};

} // namespace shadowcones

#endif
