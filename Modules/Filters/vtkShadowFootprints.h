// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowFootprints
 * @brief The outlines and areas of penumbra and umbra on a surface, of each occluder by its name.
 *
 * The surface is cut into triangles no longer than Spacing. From their corners rays go to samples of the light, half of which
 * lie on its outline: shadow begins where the outline is hidden first, and umbra where it is seen last. Triangles in which
 * something changes are cut in four, Refinements times, and along their sides the edge is found by halving. So the outlines'
 * points lie on true edges of the shadow, and the outline is straight between them, from side to side of the smallest
 * triangles (Spacing / 2^Refinements): corners of shadows are cut off by up to that. Shadows that lie between all corners of
 * Spacing are missed.
 *
 * With PerOccluder each occluder has the footprint that it would have alone: footprints overlap where shadows do, and what is
 * dark only because of several occluders is no umbra of one of them. Else all are taken together.
 *
 * Input ports:
 * - 0, vtkPolyData: the surface, polygons and strips. Active point normals say which side the light must come from; without
 *   them the surface hides nothing unless it is in the mesh. Footprints are closed along its borders.
 * - 1, vtkPolyData or composite data of them: the lights, of vtkAreaLightSource or meshes of polygons. Each has footprints of
 *   its own.
 * - 2, vtkPolyData or composite data of them: the mesh. Cells with a negative "OccluderId" are receivers and cast no shadow. A
 *   surface that is in the mesh casts none on its own planes.
 *
 * Output port 0, vtkPolyData: outlines, one polyline each, points in double precision; closed ones end with their first point.
 * The shadow lies on the left of an outline for an eye on the side that the surface's polygons face: round areas run
 * counter-clockwise, holes clockwise. Output port 1, vtkPolyData: the areas as small convex polygons that share their points and
 * leave no gaps. Cell data of both: "ShadowClass" (unsigned char; outlines: 1 where the whole shadow begins, 2 where the umbra
 * does; areas: 1 penumbra without umbra, 2 umbra), "OccluderId" (int; -1 where PerOccluder is off), "LightId" (int). Cells in
 * ascending order of lights; outlines then of occluders and classes. Field data: "OccluderNames" (by id), "CastersFingerprint",
 * "LightFingerprint". Lights without extent give umbra only.
 *
 * Every piece holds the whole. The bytes are the same for any number of threads. vtkShadowFootprintWriter writes outlines
 * for maps.
 *
 * @sa vtkShadowFootprintWriter vtkConeSetProbe vtkPenumbraWidth
 */
#ifndef vtkShadowFootprints_h
#define vtkShadowFootprints_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>
#include <vector>

namespace shadowcones
{
struct ShadowFootprints;
}

class SHADOWCONESFILTERS_EXPORT vtkShadowFootprints : public vtkPolyDataAlgorithm
{
public:
  static vtkShadowFootprints* New();
  vtkTypeMacro(vtkShadowFootprints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// What casts the shadows, input port 2.
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The mesh as data alone.
  ///@}

  ///@{
  /// One more light, input port 1: a connection, or a block of a composite, each with footprints of its own.
  void AddLightConnection(vtkAlgorithmOutput* light);
  void AddLightData(vtkDataObject* light);            ///< One more light as data alone.
  void SetLightConnection(vtkAlgorithmOutput* light); ///< The only light from here on.
  void SetLightData(vtkDataObject* light);            ///< The only light from here on, as data alone.
  void RemoveAllLights();                             ///< There are no lights from here on.
  ///@}

  ///@{
  /// Longest side of the triangles whose corners are asked, world units, 0 or above; what is smaller may be missed. Default 0,
  /// which stands for a hundredth of the diagonal of the surface's bounds.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double); ///< Longest side of the triangles whose corners are asked, world units.
  ///@}

  ///@{
  /// Times that triangles in which shadow begins or ends are cut in four, 0 to 8. Default 2.
  vtkSetMacro(Refinements, int);
  vtkGetMacro(Refinements, int); ///< Times that triangles in which shadow begins or ends are cut in four.
  ///@}

  ///@{
  /// Samples of the light for each place, half of them on its outline, 1 to 65536. Default 128.
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Samples of the light for each place.
  ///@}

  ///@{
  /// Whether each occluder has footprints of its own, or all have them together. Default on.
  vtkSetMacro(PerOccluder, bool);
  vtkGetMacro(PerOccluder, bool); ///< Whether each occluder has footprints of its own.
  /// Each occluder has footprints of its own.
  vtkBooleanMacro(PerOccluder, bool); ///< All occluders have footprints together.
  ///@}

  ///@{
  /// Seed of the light samples, any integer. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the light samples.
  ///@}

protected:
  vtkShadowFootprints();
  ~vtkShadowFootprints() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowFootprints(const vtkShadowFootprints&) = delete;
  void operator=(const vtkShadowFootprints&) = delete;

  struct Scene; // what is asked, and with what
  bool ReadInputs(vtkInformationVector** inputs, Scene& scene, std::string& error) const;
  /// One result a light. @return false where aborted.
  bool Find(const Scene& scene, std::vector<shadowcones::ShadowFootprints>& found);

  double Spacing = 0.0;
  int Refinements = 2;
  int NumberOfLightSamples = 128;
  bool PerOccluder = true;
  int Seed = 1;
};

#endif
