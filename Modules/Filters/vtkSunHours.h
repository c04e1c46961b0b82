// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSunHours
 * @brief How long the points or cells of any data set are in the Sun, when, and whose shadow takes most.
 *
 * The path of the Sun comes in steps. For the middle of each step with the Sun above MinimumAltitude, rays from every
 * point ask how much of the Sun's disc is visible past the mesh; the rest of the time is dark. SunHours is the sum of
 * the visible shares times the step. With an angular diameter of 0 it is one ray a step (a hard Sun), else
 * NumberOfLightSamples stratified ones; what of the disc is below the horizon, or below a lower MinimumAltitude, is
 * dark. All of the path is answered in one run: the pipeline's time plays no part in it.
 *
 * A surface casts no shadow on itself: a triangle in whose plane a point lies hides nothing from it. Where the data set
 * has active normals (of points or of cells, as Association says) light that comes from below the surface is hidden by
 * it. Without normals the far side of a closed mesh is still dark, that of an open sheet is not. Cells of the mesh with
 * a negative "OccluderId" are receivers and cast no shadow.
 *
 * Results are the same bytes for any number of threads, and the samples of a point are a pure function of (Seed, its
 * coordinates), so that pieces of a data set give what the whole does. Piece requests and extents are passed to input
 * 0.
 *
 * Input port 0: any vtkDataSet; composite data are answered block by block. Input port 1: the mesh, vtkPolyData with
 * optional cell data "OccluderId" (any numeric type), or composite data of meshes, which are joined. Input port 2: a
 * vtkSunPath; of its field data "SunStepTime", "SunStepLength", "SunStepDirection", "SunStepAltitude",
 * "SunAngularDiameter" and "SunUp" are read.
 *
 * Output: the input's type, structure and arrays, and in its point data (or cell data, as Association says), one
 * component each:
 * - "SunHours" (float, h)
 * - "FirstSun", "LastSun" (float, h after the start of the path): begin of the first and end of the last step with any
 *   Sun; -1: none
 * - "LongestSun" (float, h): the most of SunHours in steps with some Sun that follow each other
 * - "SunHoursError" (float, h): a bound of what the steps leave open. Where the shares at two middles that follow each
 *   other are a and b, |a - b| times half a step, summed up; it holds where between them the Sun comes or goes once,
 *   and knows nothing of shadows that pass within a step, nor of the sampling of the disc, which is far less
 * - "OccluderId" (int), with ComputeOccluders: the occluder whose shadow takes most time, the smallest id of several;
 *   -1: none takes any. Every occluder on a ray counts. What only the surface itself or the night takes is nobody's.
 *
 * Arrays of these names are replaced. Points and cells that "vtkGhostType" marks as hidden, and cells that use a hidden
 * point, get NaN and -1; duplicates are computed. Field data "OccluderNames" (by id) and "CastersFingerprint" say of
 * what mesh.
 *
 * @sa vtkSunPath vtkConeSetProbe
 */
#ifndef vtkSunHours_h
#define vtkSunHours_h

#include "ShadowConesFiltersModule.h"
#include "vtkDataSetAlgorithm.h"

#include <string>

namespace shadowcones
{
class Team;
struct SunHoursResult;
}

class SHADOWCONESFILTERS_EXPORT vtkSunHours : public vtkDataSetAlgorithm
{
public:
  static vtkSunHours* New();
  vtkTypeMacro(vtkSunHours, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// The mesh, input port 1.
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The mesh as a data object, without a pipeline.
  ///@}

  ///@{
  /// The path of the Sun, input port 2: a vtkSunPath.
  void SetPathConnection(vtkAlgorithmOutput* path);
  void SetPathData(vtkDataObject* path); ///< The path as a data object, without a pipeline.
  ///@}

  ///@{
  /// The Sun counts where its middle stands higher, degrees, -90 to 90. Default 0.
  vtkSetMacro(MinimumAltitude, double);
  vtkGetMacro(MinimumAltitude, double); ///< The altitude above which the Sun counts, degrees.
  ///@}

  enum AssociationType
  {
    Points = 0,
    Cells = 1
  };
  ///@{
  /// Where to ask: at points, or at the centres of cells; the arrays go to the data of the same. Default Points.
  vtkSetMacro(Association, int);
  void SetAssociationToPoints() { this->SetAssociation(Points); } ///< Ask at points; the arrays go to the point data.
  /// Ask at the centres of cells; the arrays go to the cell data.
  void SetAssociationToCells() { this->SetAssociation(Cells); }
  vtkGetMacro(Association, int); ///< 0 Points, 1 Cells.
  ///@}

  ///@{
  /// Samples of the Sun's disc for each point and step, 1 to 65536. Time grows with it; unused where the angular
  /// diameter is 0. Default 64.
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Samples of the Sun's disc for each point and step.
  ///@}

  ///@{
  /// Find whose shadow takes most time: the array "OccluderId". Takes about as long again where there is much shadow.
  /// Default off.
  vtkSetMacro(ComputeOccluders, bool);
  vtkGetMacro(ComputeOccluders, bool); ///< Whether it is asked whose shadow takes most time.
  /// Find whose shadow takes most time.
  vtkBooleanMacro(ComputeOccluders, bool); ///< Do not ask whose shadow it is.
  ///@}

  ///@{
  /// Light from below a surface is hidden by it, where the data set has active normals. Turn off for normals that point
  /// inward. Default on.
  vtkSetMacro(UseNormals, bool);
  vtkGetMacro(UseNormals, bool); ///< Whether light from below a surface is hidden by it.
  /// Surfaces with active normals hide light that comes from below.
  vtkBooleanMacro(UseNormals, bool); ///< Leave normals alone, for those that point inward.
  ///@}

  ///@{
  /// Seed of the samples of the disc, any integer. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the samples of the disc.
  ///@}

protected:
  vtkSunHours();
  ~vtkSunHours() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  struct Inputs;

  /// What is wrong with the parameters, or with what is connected, as a sentence; empty where nothing is.
  std::string CheckRequest(vtkDataObject* mesh, vtkDataObject* path) const;
  bool ReadInputs(vtkInformationVector** inputVector, Inputs& in, std::string& error) const;
  /// @return false where aborted.
  bool Compute(const Inputs& in, shadowcones::Team* team, shadowcones::SunHoursResult& result);

  vtkSunHours(const vtkSunHours&) = delete;
  void operator=(const vtkSunHours&) = delete;

  double MinimumAltitude = 0.0;
  int Association = Points;
  int NumberOfLightSamples = 64;
  bool ComputeOccluders = false;
  bool UseNormals = true;
  int Seed = 1;
};

#endif
