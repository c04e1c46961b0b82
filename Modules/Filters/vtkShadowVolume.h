// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolume
 * @brief Closed surfaces around the penumbra and the umbra of each occluder, from a cone set.
 *
 * The cones of an occluder are cut at a length and at a box, and the surface of their union is contoured from its
 * signed distance on a regular grid (vtkFlyingEdges3D). The surfaces are closed, also where the box cuts them, manifold
 * and oriented outward; no two points of a surface coincide. They are fit for vtkBooleanOperationPolyDataFilter,
 * vtkClipClosedSurface and vtkMassProperties. Each surface has a grid of its own, in the box around its cones; the
 * distance is evaluated in blocks near the surface only. Results are the same bytes for any number of threads; the
 * pieces of a piece request are ranges of occluders.
 *
 * Input port 0: vtkPolyData, a cone set as vtkConeSetFilter writes it; point data "Axis", "BaseRadius" and "HalfAngle"
 * are required, "InnerHalfAngle", "OccluderId" and "LightId" optional. Field data: the lights' exact shapes, for Umbra
 * BaseDiscs. Cones of several lights make surfaces of their own for each light.
 *
 * Output port 0: vtkPolyData, the outer bound: the union of the cones that open by "HalfAngle", which holds the
 * penumbra and the umbra where the cones are bounds (Expansion LightGeometry, ExpansionFraction 1). Output port 1: the
 * inner bound: the union of the cones that open or close by "InnerHalfAngle", or what the base discs hide together; see
 * Umbra. Both hold triangles; points are in double precision, world units. Cell data: "OccluderId" (int; -1 where
 * PerOccluder is off), "LightId" (int); triangles in ascending order of lights, then of occluders. Field data: that of
 * the cone set. An occluder whose cones have no volume inside the bounds has no triangles.
 *
 * Memory: 5 bytes (Umbra BaseDiscs: 9) a sample of the largest grid, at most (Resolution + 2)^3 samples and never more
 * than 2^28 (1.3 or 2.3 GiB), beside the outputs. Larger grids are an error.
 *
 * @warning A surface is true to about a cell, its region's longest side over Resolution: edges and tips are rounded
 * off, and what is thinner than a cell may be missing. That makes the umbra too small, whose cones end in tips.
 * @sa vtkConeSetFilter vtkConeSetGeometry
 */
#ifndef vtkShadowVolume_h
#define vtkShadowVolume_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

class SHADOWCONESFILTERS_EXPORT vtkShadowVolume : public vtkPolyDataAlgorithm
{
public:
  static vtkShadowVolume* New();
  vtkTypeMacro(vtkShadowVolume, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Cells along the longest side of a surface's grid, 4 to 1024. Time grows with its square, memory with its cube.
  /// Default 64.
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int); ///< Cells along the longest side of a surface's grid.
  ///@}

  ///@{
  /// The box that cuts the surfaces, world units: x from, to, y from, to, z from, to; from must be below to. Surfaces
  /// are closed at its faces. Default: 1, -1, 1, -1, 1, -1, which stands for no box: cones end by Length alone.
  vtkSetVector6Macro(Bounds, double);
  /// The box that cuts the surfaces, world units: x from, to, y from, to, z from, to.
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// Distance from their base at which cones are cut, world units, 0 or more. 0: where they leave Bounds or, without
  /// Bounds, at the diagonal of the box around all base discs. Default 0.
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double); ///< Distance from their base at which cones are cut, world units; 0: automatic.
  ///@}

  enum UmbraType
  {
    InnerCones = 0,
    BaseDiscs = 1,
    // Older spelling.
    INNER_CONES = InnerCones,
    BASE_DISCS = BaseDiscs
  };
  ///@{
  /// What the inner bound is. InnerCones: the union of the inner cones, what each base disc alone puts in full shadow;
  /// never too large, but far too small where many small discs hide the light together. BaseDiscs: what all base discs
  /// of an occluder together hide from every one of some 64 points of the light (256 of a sphere), and the inner cones;
  /// gaps between the discs let light through. It needs the light's exact shape in the field data and takes longer.
  /// Default InnerCones.
  vtkSetMacro(Umbra, int);
  vtkGetMacro(Umbra, int);                                    ///< 0 InnerCones, 1 BaseDiscs.
  void SetUmbraToInnerCones() { this->SetUmbra(InnerCones); } ///< What each base disc alone puts in full shadow.
  void SetUmbraToBaseDiscs() { this->SetUmbra(BaseDiscs); }   ///< What all base discs of an occluder hide together.
  ///@}

  ///@{
  /// On: a closed surface for each "OccluderId", which overlap where shadows do. Off: one for all. Default on.
  vtkSetMacro(PerOccluder, bool);
  vtkGetMacro(PerOccluder, bool); ///< Whether each occluder has a surface of its own.
  /// A closed surface for each occluder.
  vtkBooleanMacro(PerOccluder, bool); ///< One closed surface for all.
  ///@}

protected:
  vtkShadowVolume();
  ~vtkShadowVolume() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowVolume(const vtkShadowVolume&) = delete;
  void operator=(const vtkShadowVolume&) = delete;

  bool HasBounds() const;
  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;

  int Resolution = 64;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Length = 0.0;
  int Umbra = InnerCones;
  bool PerOccluder = true;
};

#endif
