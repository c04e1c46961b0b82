// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpeedScene.h
 * @brief One scene with all that an image of it is made from, stage by stage, so that each stage can be timed alone.
 */
#ifndef SpeedScene_h
#define SpeedScene_h

#include "BenchmarkScene.h"
#include "RoomImage.h"

#include "scConeIntervals.h"
#include "scScatteringImage.h"
#include "scVisibilityGrid.h"

#include <memory>
#include <string>
#include <vector>

namespace shadowcones
{

/// A disc light that faces down.
struct DiscLight
{
  Vector3 Center{ 0.0, 5.49, 0.0 };
  double Radius = 0.5;
};

class SpeedScene
{
public:
  /// @param vectors shadow vectors asked for; 0: 5,800, on the tree 20,000.
  SpeedScene(const std::string& nameOrFile, const DiscLight& light, vtkIdType vectors = 0);
  SpeedScene(const SpeedScene&) = delete;
  SpeedScene& operator=(const SpeedScene&) = delete;

  // The stages, in order. Each takes the results of those before, and may be run again.
  void BuildOccluders();
  void TraceVectors();
  void FitCones();
  void BuildHierarchy();
  VisibilityGrid FillGrid(int dimensions, int lightSamples, int brickParts) const;
  /// Medium term alone: surfaces black, the light not seen.
  ScatteringOptions Options(ScatteringMode mode, int size) const;
  void Render(const ScatteringOptions& options, const ConeHierarchy* cones, const VisibilityGrid* grid,
    ScatteringImage& image) const;

  ScatteringScene View(const ConeHierarchy* cones = nullptr, const VisibilityGrid* grid = nullptr) const
  {
    return { *this->Occluders, this->Scene.Source, this->Fog, this->Eye, cones, grid };
  }
  const std::string& Name() const { return this->Scene.Name; }
  vtkIdType NumberOfTriangles() const { return static_cast<vtkIdType>(this->Scene.Mesh.Triangles.size() / 3); }
  vtkIdType NumberOfVectors() const;
  vtkIdType NumberOfPhotons() const;
  const std::vector<Cone>& Cones() const { return this->Fitted.Cones; }
  const ConeHierarchy* Hierarchy() const { return this->Tree.get(); }
  const BenchmarkScene& Data() const { return this->Scene; }
  const Room& Walls() const { return this->Surroundings; }
  /// Ask for another number of vectors from now on.
  void SetVectors(vtkIdType vectors) { this->Parameters.Vectors = vectors; }

private:
  BenchmarkScene Scene;
  Room Surroundings;
  Medium Fog;
  Camera Eye;
  ConeParameters Parameters;
  std::unique_ptr<OccluderScene> Occluders;
  VectorsOfScene Traced;
  ConesOfScene Fitted;
  std::unique_ptr<ConeHierarchy> Tree;
};

} // namespace shadowcones

#endif
