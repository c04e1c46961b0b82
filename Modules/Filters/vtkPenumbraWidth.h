// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPenumbraWidth
 * @brief How wide the edges of shadows are: the distance from 5 % to 95 % of the light, across them or along a line.
 *
 * On a surface, or on points with normals: through every point whose visible fraction lies from Lower to Upper a straight way
 * is laid in the surface's tangent plane, along the gradient of the visible fraction. Its two ends are where the fraction
 * passes Lower and Upper, found by halving, with rays to the same samples of the light at every place. On a surface that
 * is curved within a penumbra it is the width that a flat surface through the point would have.
 *
 * On lines (data without polygons): each polyline is looked at in SamplesPerLine places, and where the fraction goes from
 * Lower at most to Upper at least, or back, the two ends are found by halving; the width is the length along the line, whatever
 * the angle at which it crosses the edge. Two edges between neighbouring places are not told apart.
 *
 * There is no width where the fraction turns back before it reaches both ends, as in the shadow of a twig that hides no more than
 * half of the lamp; nor under point lights and a Sun without a size, whose edges are hard.
 *
 * Input ports:
 * - 0, vtkPolyData: a surface, lines, or points with active normals. Light from below active point normals is hidden. A
 *   surface without them takes the planes of its polygons, and then the surface hides nothing.
 * - 1, vtkPolyData or composite data of them: the lights, of vtkAreaLightSource or meshes of polygons, which emit along their
 *   normals.
 * - 2, vtkPolyData or composite data of them: the mesh. Cells with a negative "OccluderId" are receivers and cast no shadow.
 *
 * Output port 0: the input with point data "PenumbraWidth" (float, world units; NaN where there is none), "PenumbraWidthError"
 * (float, world units; what the standard errors of both fractions, those of independent samples, do to the width: a bound for the
 * stratified ones), "Visibility" (float, 0..1) and "OccluderId" (int, the occluder that hides most of the light there, -1
 * where none does). On lines a point has the width of the edge that it lies in. Each has one component a light, in the order of
 * connections and blocks. Output port 1: the widths themselves, a line from Lower to Upper each (points in double precision):
 * of a surface one for every width at a point, of lines one for every crossing. Cell data "PenumbraWidth",
 * "PenumbraWidthError" (float), "OccluderId" (int, that hides most of the light half way), "LightId" (int), "InputId" (vtkIdType:
 * the point of a surface, the line of lines). Both: field data "OccluderNames" (by id), "CastersFingerprint",
 * "LightFingerprint".
 *
 * Every piece holds the whole. The bytes are the same for any number of threads. Hidden points ("vtkGhostType") get NaN, NaN, NaN and -1.
 *
 * @sa vtkConeSetProbe vtkShadowFootprints
 */
#ifndef vtkPenumbraWidth_h
#define vtkPenumbraWidth_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

namespace shadowcones
{
class Team;
}

class SHADOWCONESFILTERS_EXPORT vtkPenumbraWidth : public vtkPolyDataAlgorithm
{
public:
  static vtkPenumbraWidth* New();
  vtkTypeMacro(vtkPenumbraWidth, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// The mesh that casts the shadows, input port 2.
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The same, as data without a pipeline.
  ///@}

  ///@{
  /// The light, input port 1; replaces all that were connected. Several lights: one a connection, or a block of a composite.
  void SetLightConnection(vtkAlgorithmOutput* light);
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light, whose widths are a component more.
  void SetLightData(vtkDataObject* light);            ///< The light as data without a pipeline.
  void AddLightData(vtkDataObject* light);            ///< One more light as data without a pipeline.
  void RemoveAllLights();                             ///< Disconnects all lights.
  ///@}

  ///@{
  /// Visible fraction of the light at the dark end of a width, above 0 and below Upper. Default 0.05.
  vtkSetMacro(Lower, double);
  vtkGetMacro(Lower, double); ///< Visible fraction of the light at the dark end of a width.
  ///@}

  ///@{
  /// Visible fraction of the light at the bright end of a width, above Lower and below 1. Default 0.95.
  vtkSetMacro(Upper, double);
  vtkGetMacro(Upper, double); ///< Visible fraction of the light at the bright end of a width.
  ///@}

  ///@{
  /// Samples of the light at every place, 1 to 65536. Time grows with it, some 40 places are asked for a width.
  /// Default 256.
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Samples of the light at every place.
  ///@}

  ///@{
  /// Places along each line that are looked at for edges, 2 to 1000000. Default 256.
  vtkSetMacro(SamplesPerLine, int);
  vtkGetMacro(SamplesPerLine, int); ///< Places along each line that are looked at for edges.
  ///@}

  ///@{
  /// How far from a point of a surface an end is looked for, world units, 0 or above. Default 0, which stands for the diagonal
  /// of the joint bounds of surface and mesh.
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double); ///< How far from a point of a surface an end is looked for, world units.
  ///@}

  ///@{
  /// Seed of the light samples, any integer. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the light samples.
  ///@}

protected:
  vtkPenumbraWidth();
  ~vtkPenumbraWidth() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPenumbraWidth(const vtkPenumbraWidth&) = delete;
  void operator=(const vtkPenumbraWidth&) = delete;

  struct Scene;   // what is asked, and with what
  struct Results; // what was found
  bool ReadInputs(vtkInformationVector** inputs, Scene& scene, std::string& error) const;
  /// @return false where aborted.
  bool Measure(const Scene& scene, shadowcones::Team* team, Results& results);
  void Write(const Scene& scene, Results& results, vtkPolyData* places, vtkPolyData* widths) const;

  double Lower = 0.05;
  double Upper = 0.95;
  int NumberOfLightSamples = 256;
  int SamplesPerLine = 256;
  double MaximumDistance = 0.0;
  int Seed = 1;
};

#endif
