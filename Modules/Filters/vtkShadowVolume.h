// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolume
 * @brief Closed surfaces around the penumbra and the umbra of each occluder: of cones, of what is truly seen, or projected.
 *
 * Method Cones: the cones of an occluder are cut at a length and at a box, and the surface of their union is contoured from its
 * signed distance on a regular grid (vtkFlyingEdges3D). Where a mesh is connected an inner cone counts only as far as it is a
 * fact that the mesh hides all of the light from its base, which moves and shrinks for that; see Umbra.
 *
 * Method Visibility: needs a mesh and lights, no cones. The outer bound holds what sees less than all of a light: where a
 * caster reaches into the convex hull of place and light. The inner bound holds what sees nothing of it: none of the points around
 * the light and NumberOfLightSamples inside. Edges of the grid are bisected on that truth, to a thousandth of a cell; then triangles
 * whose middle lies in light (inner), or still in penumbra (outer), are moved until it does not. Blocks of places for which no edge of
 * a surface lies on the way to the light are decided as a whole, for sure, so that time goes to where shadows end.
 *
 * Method Projection: of point lights and Suns without width. The silhouette of each closed convex body, or flat convex sheet, is
 * extruded away from the light and cut at the box: exact up to rounding, without a grid. Other occluders are an error that says to use
 * Visibility. Parts of one occluder that do not hang together have a solid each, and these overlap.
 *
 * The surfaces are closed, also where the box cuts them, manifold and oriented outward; no two points of a surface coincide. They are
 * fit for vtkBooleanOperationPolyDataFilter, vtkClipClosedSurface and vtkMassProperties. Solids of Visibility and Projection hold
 * the insides of closed occluders too, which no light reaches; a place that the light does not shine to, behind a lamp of one side,
 * belongs to none. Each surface has a grid of its own, in the box around its shadow. Results are the same bytes for any number of
 * threads; the pieces of a piece request are ranges of occluders.
 *
 * Input port 0, required for Cones: vtkPolyData, a cone set as vtkConeSetFilter writes it; point data "Axis", "BaseRadius" and
 * "HalfAngle" are required, "InnerHalfAngle", "OccluderId" and "LightId" optional. Field data: the lights' exact shapes, for Umbra
 * BaseDiscs and to prove inner cones where no light is connected. For Visibility and Projection a set that is proved for this mesh and
 * these lights limits where shadow is looked for; any other is not looked at.
 * Input port 1, optional, Visibility: vtkImageData of vtkVisibilityVolume for these lights. Its box stands in for Bounds, and
 * shadow is looked for only about where it has some.
 * Input port 2, required for Visibility and Projection: the mesh, vtkPolyData with cell data "OccluderId" or composite data of meshes.
 * Points in one place are one. Input port 3, required for these too: the lights, one a connection or a block of a composite.
 *
 * Output port 0: vtkPolyData, the outer bound, which holds penumbra and umbra: of Cones the union of the cones that open by
 * "HalfAngle" (a bound where these are: Expansion LightGeometry, ExpansionFraction 1, or proved). Output port 1: the inner bound, the
 * umbra; of Projection the same solid again. Both hold triangles; points are in double precision, world units. Cell data: "OccluderId" (int; -1 where
 * PerOccluder is off), "LightId" (int); triangles in ascending order of lights, then of occluders. Field data: that of
 * the cone set, "Method" (int), "InnerCertified" (int, 1: the inner bound is proved to see no light: Projection, and Cones with
 * InnerCones and a mesh; 0: it is not: Cones without a mesh or with BaseDiscs, and Visibility, which asks at points), and of proved cones
 * "NumberOfWholeInnerCones", "NumberOfShrunkInnerCones" and "NumberOfDroppedInnerCones" (id); with mesh and lights "OccluderNames",
 * "CastersFingerprint" and "LightFingerprint". An occluder whose shadow has no volume inside the bounds has no triangles.
 *
 * Memory: 5 bytes (Umbra BaseDiscs: 9; Visibility: 2) a sample of the largest grid, at most (Resolution + 2)^3 samples and never more
 * than 2^28 (1.3, 2.3 or 0.5 GiB), beside the outputs; Visibility and proofs take 150 bytes a triangle and Embree's search tree.
 * Larger grids are an error.
 *
 * @warning A surface of cones is true to about a cell, its region's longest side over Resolution: edges and tips are rounded
 * off. What is thinner than a cell may be missing, in Visibility too. That makes the umbra too small, which ends in tips.
 * @sa vtkConeSetFilter vtkConeSetGeometry vtkVisibilityVolume
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
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// A visibility volume, input port 1. Optional: where Visibility looks for shadow.
  void SetVisibilityVolumeConnection(vtkAlgorithmOutput* volume);
  void SetVisibilityVolumeData(vtkDataObject* volume); ///< The volume as a data object, without a pipeline.
  ///@}

  ///@{
  /// The light, input port 3. Required for Visibility and Projection.
  /// Several lights: one a connection, or a block of a composite, all with the same wavelengths. Set replaces all of
  /// them.
  void SetLightConnection(vtkAlgorithmOutput* light);
  void SetLightData(vtkDataObject* light);            ///< The light as a data object, without a pipeline.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light.
  void AddLightData(vtkDataObject* light);            ///< One more light as a data object, without a pipeline.
  void RemoveAllLights();                             ///< No light is connected from here on.
  ///@}

  enum MethodType
  {
    Cones = 0,
    Visibility = 1,
    Projection = 2
  };
  ///@{
  /// What the solids are made of. Cones: the cones of port 0. Visibility: what rays from the mesh and the lights tell, asked where
  /// shadows end. Projection: silhouettes of convex occluders, for lights without width. Default Cones.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);                                     ///< 0 Cones, 1 Visibility, 2 Projection.
  void SetMethodToCones() { this->SetMethod(Cones); }           ///< The union of the cones.
  void SetMethodToVisibility() { this->SetMethod(Visibility); } ///< What mesh and lights truly leave of the light.
  void SetMethodToProjection() { this->SetMethod(Projection); } ///< Silhouettes, of lights without width.
  ///@}

  ///@{
  /// The mesh, input port 2. Required for Visibility and Projection; with it inner cones are proved.
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The mesh as a data object, without a pipeline.
  ///@}

  ///@{
  /// Cells along the longest side of a surface's grid, 4 to 1024; not used by Projection. Time grows with its square, memory with its cube.
  /// Default 64.
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int); ///< Cells along the longest side of a surface's grid.
  ///@}

  ///@{
  /// The box that cuts the surfaces, world units: x from, to, y from, to, z from, to; from must be below to. Surfaces
  /// are closed at its faces. Default: 1, -1, 1, -1, 1, -1, which stands for no box: shadows end by Length alone.
  vtkSetVector6Macro(Bounds, double);
  /// The box that cuts the surfaces, world units: x from, to, y from, to, z from, to.
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// Distance from their base at which cones are cut, world units, 0 or more; of Visibility and Projection how far the box that
  /// cuts a solid reaches behind the box around its occluder. 0: where they leave Bounds or, without Bounds, at the diagonal of the
  /// box around all base discs, or around all casters. Default 0.
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double); ///< How far shadows reach, world units; 0: automatic.
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
  /// What the inner bound of Cones is. InnerCones: the union of the inner cones, what each base disc alone puts in full shadow;
  /// far too small where many small discs hide the light together, and too large where a disc hangs over an edge or a hole, unless
  /// a mesh is connected: discs are then shrunk, or dropped, to what the mesh is proved to hide. BaseDiscs: what all base discs
  /// of an occluder together hide from every one of some 64 points of the light (256 of a sphere), and the inner cones;
  /// gaps between the discs let light through. It needs the light's exact shape in the field data and takes longer.
  /// Default InnerCones.
  vtkSetMacro(Umbra, int);
  vtkGetMacro(Umbra, int);                                    ///< 0 InnerCones, 1 BaseDiscs.
  void SetUmbraToInnerCones() { this->SetUmbra(InnerCones); } ///< What each base disc alone puts in full shadow.
  void SetUmbraToBaseDiscs() { this->SetUmbra(BaseDiscs); }   ///< What all base discs of an occluder hide together.
  ///@}

  ///@{
  /// Points of a light that Visibility asks for, beside those around it, 1 to 65536. More find smaller gaps that let light into the inner
  /// bound. Default 64.
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Points inside a light that Visibility asks for.
  ///@}

  ///@{
  /// On: a closed surface for each "OccluderId", of what it hides alone; they overlap where shadows do. Off: one for what all of them
  /// hide together. Default on.
  vtkSetMacro(PerOccluder, bool);
  vtkGetMacro(PerOccluder, bool); ///< Whether each occluder has a surface of its own.
  /// A closed surface for each occluder.
  vtkBooleanMacro(PerOccluder, bool); ///< One closed surface for all.
  ///@}

protected:
  vtkShadowVolume();
  ~vtkShadowVolume() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowVolume(const vtkShadowVolume&) = delete;
  void operator=(const vtkShadowVolume&) = delete;

  struct Inputs;
  struct Work;

  bool HasBounds() const;
  /// What is wrong with the parameters, or with what is connected, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  std::string CheckConnections(vtkInformationVector** inputVector) const;
  bool ReadInputs(vtkInformationVector** inputVector, Inputs& in, std::string& error) const;
  bool ReadMeshAndLights(vtkInformationVector** inputVector, Inputs& in, std::string& error) const;
  /// The solids of what a work holds. @return false where aborted, or with a sentence in its Error.
  bool BuildFromCones(Inputs& in, Work& work) const;
  bool BuildFromMesh(Inputs& in, Work& work) const;

  int Method = Cones;
  int Resolution = 64;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Length = 0.0;
  int Umbra = InnerCones;
  int NumberOfLightSamples = 64;
  bool PerOccluder = true;
};

#endif
