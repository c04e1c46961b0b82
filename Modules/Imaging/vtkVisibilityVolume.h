// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVisibilityVolume
 * @brief How much of the light is visible at the points of a regular grid, asked only where cones reach.
 *
 * A cone set tells which part of space a shadow can be in. The points of every cell that a cone reaches are asked for
 * the visible fraction of the light; all others see the whole light. Exact sends rays to stratified samples of the
 * light; its cones are to be bounds (Tuning Conservative, or LightGeometry with Overlap and without CosineCorrection).
 * Soft needs no mesh: the base discs of the cones are the occluders. The volume is made once and serves any number of
 * images (vtkScatteringImageFilter, Mode Volume), and it is ordinary image data: to be volume-rendered, sliced,
 * contoured and saved.
 *
 * Cells whose corners differ by more than RefinementThreshold are refined: a brick holds the values of a finer grid
 * inside the cell, so that shadows stay sharp next to what casts them. The threshold lies above the sampling noise of
 * the points, which a test of small differences would refine instead. Readers that know nothing of bricks see the plain
 * volume.
 *
 * Input ports:
 * - 0, vtkPolyData: the cone set of vtkConeSetFilter; point data "Axis" (3 components), "BaseRadius" and "HalfAngle"
 *   are required. A set without cones leaves everything lit. Optional for Exact: with nothing connected rays are sent from
 *   every point.
 * - 1, vtkPolyData: the lights, from vtkAreaLightSource or any mesh of polygons, which emit along their normals; one a
 *   connection, or a block of a composite.
 * - 2, vtkPolyData or composite data of them, required for Exact: the mesh, with cell data "OccluderId"; cells with a negative
 *   one are receivers and cast no shadow.
 *
 * Output port 0, vtkImageData of Dimensions points over Bounds. Point data:
 * - "Visibility" (float, 0..1, the active scalars): visible share of the part of the light that emits towards the
 *   point.
 * - "ShadowClass" (unsigned char): 0 lit, every sample is visible; 1 penumbra; 2 umbra, none is.
 * - "Marked" (unsigned char): 1 where a cone reaches a cell at the point, so that it was asked for; elsewhere 0, with
 *   Visibility 1 and ShadowClass 0. Points behind the light, where it sends nothing, are not marked.
 * - On request "FluenceRate" (float, one component a wavelength, W m^-2; the integral of radiance x visibility over all
 *   directions, of all lights together; a wavelength is a band) and "FluenceRateError" (float, its standard error). The
 *   whole of a light is taken in closed form, so that both are exact where no cone reaches. Bricks have none.
 *
 * With several lights "Visibility" and "ShadowClass" have one component a light, in the order of connections and
 * blocks, each light is asked for where its own cones ("LightId") reach, and "Marked" is 1 where those of any light do.
 *
 * Field data: "BrickParts" (int; 0 where no cell is refined), "BrickDimensions" (int, 3 components: those of the whole
 * volume), and for refined cells "BrickCells" (vtkIdType, ascending; i + (nx - 1) (j + (ny - 1) k) of the whole volume)
 * and "BrickVisibility" (float, (BrickParts + 1)^3 components: the values of the brick's points, i fastest, the cell's
 * own corners among them), of several lights one after the other, with "BrickLightId" (int). "LightFingerprint"
 * (unsigned 64-bit, one value a light). "Method", "NumberOfLightSamples", "Seed" (int), "RefinementThreshold" (double),
 * "NumberOfOcclusionRays" (vtkIdType; of this extent), "Certified" (int; Exact: 1 where the cones are proved for this mesh
 * and these lights, or where there are none). Where the box reaches out of that in which a set is proved
 * ("CertifiedBounds") every point is asked.
 *
 * The bytes are the same for any number of threads and for any division into extents; a brick comes with the extent
 * that holds all corners of its cell.
 *
 * @warning Between points values are interpolated: shadows thinner than a cell that reach none of its corners are lost,
 * and at surfaces the dark side shines through to the lit one, by up to a cell (a part of a brick where it is refined).
 *
 * @sa vtkScatteringImageFilter vtkConeSetFilter vtkConeSetProbe
 */
#ifndef vtkVisibilityVolume_h
#define vtkVisibilityVolume_h

#include "ShadowConesImagingModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithmOutput;
class vtkFieldData;

namespace shadowcones
{
class PreparedUser;
class Team;
struct VisibilityGrid;
}

class SHADOWCONESIMAGING_EXPORT vtkVisibilityVolume : public vtkImageAlgorithm
{
public:
  static vtkVisibilityVolume* New();
  vtkTypeMacro(vtkVisibilityVolume, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /**
   * The light, input port 1. Required. Several lights: one a connection, or a block of a composite, all with the same
   * wavelengths. Set replaces all of them.
   */
  void SetLightConnection(vtkAlgorithmOutput* light);
  void SetLightData(vtkDataObject* light);            ///< The light as a data object, without a pipeline.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light.
  void AddLightData(vtkDataObject* light);            ///< One more light as a data object, without a pipeline.
  void RemoveAllLights();                             ///< No light is connected from here on.
  ///@}

  ///@{
  /**
   * The mesh, input port 2. Required for Exact; Soft takes no more than its bounds.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The mesh as a data object, without a pipeline.
  ///@}

  enum MethodType
  {
    Exact = 0,
    Soft = 1
  };
  ///@{
  /**
   * What hides the light. Exact: the mesh. Soft: the base discs of the cones. Default: Exact.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);                           ///< 0 Exact, 1 Soft.
  void SetMethodToExact() { this->SetMethod(Exact); } ///< The mesh hides the light.
  void SetMethodToSoft() { this->SetMethod(Soft); }   ///< The base discs of the cones hide the light; needs no mesh.
  ///@}

  ///@{
  /**
   * Points along x, y and z. Small lights need finer grids: a penumbra should be some cells wide. Default: 65, 65, 65.
   * Valid: at least 2 each, at most 2^31 - 1 together.
   */
  vtkSetVector3Macro(Dimensions, int);
  /// Points along x, y and z.
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The box between the first and the last points, world units: x from, to, y from, to, z from, to.
   * Default: 1, -1, 1, -1, 1, -1, which stands for the joint bounds of mesh (without one: of the cones' bases) and light
   * (without a Sun), each side enlarged by 10 % about the centre, as vtkScatteringImageFilter has it for its medium. To
   * announce them the filter updates its inputs already when it is asked for information; with inputs that change with time
   * they are those of the first time, and a warning says where the scene leaves them.
   * Valid: from below to.
   */
  vtkSetVector6Macro(Bounds, double);
  /// The box between the first and the last points, world units: x from, to, y from, to, z from, to.
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Samples of the light for each point. Time grows with it; neighbouring points share their noise out, so that 8 to 16
   * are enough for images. Default: 16. Valid: 1 to 65,536.
   */
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Samples of the light for each point.
  ///@}

  ///@{
  /**
   * Parts into which the sides of a refined cell are cut. An even number is reached by halves, which go on only where
   * values still differ. Default: 2. Valid: 1 to 32; 1: no cell is refined.
   */
  vtkSetMacro(BrickParts, int);
  vtkGetMacro(BrickParts, int); ///< Parts into which the sides of a refined cell are cut; 1: no cell is refined.
  ///@}

  ///@{
  /**
   * Cells whose corners' visibilities differ by more than this are refined. Below 0.3 the noise of 16 samples is
   * refined too. Default: 0.5. Valid: 0..1; 1: no cell is refined.
   */
  vtkSetMacro(RefinementThreshold, double);
  vtkGetMacro(RefinementThreshold, double); ///< Difference of visibilities above which a cell is refined.
  ///@}

  ///@{
  /**
   * Add "FluenceRate" and "FluenceRateError". Default: off.
   */
  vtkSetMacro(ComputeFluenceRate, bool);
  vtkGetMacro(ComputeFluenceRate, bool); ///< Whether "FluenceRate" is added.
  /// Add "FluenceRate" and "FluenceRateError".
  vtkBooleanMacro(ComputeFluenceRate, bool); ///< Leave "FluenceRate" out.
  ///@}

  ///@{
  /**
   * Seed of the light samples. Default: 1. Valid: any.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the light samples.
  ///@}

  ///@{
  /// Mesh and search tree are kept while the mesh stands, and shared on request: see vtkScatteringImageFilter.
  vtkObject* GetPreparedScene();
  /// Share mesh and search tree with an image or a probe. Default: a scene of its own.
  void SetPreparedScene(vtkObject* scene);
  void ReleasePreparedScene();             ///< Free what is kept for the next volume.
  vtkTypeInt64 GetPreparedMemory();        ///< Bytes of what is kept.
  vtkIdType GetNumberOfPreparations();     ///< How often this volume has read the mesh or built its tree.
  ///@}

protected:
  vtkVisibilityVolume();
  ~vtkVisibilityVolume() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVisibilityVolume(const vtkVisibilityVolume&) = delete;
  void operator=(const vtkVisibilityVolume&) = delete;

  struct Scene; // what RequestData hands to Core

  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  bool ReadInputs(vtkInformationVector** inputs, Scene& scene, std::string& error);
  void FindAutomaticBounds(vtkInformationVector** inputs);
  bool FindBounds(Scene& scene, std::string& error) const;
  bool FillGrids(const Scene& scene, const int extent[6], shadowcones::Team* team,
    std::vector<shadowcones::VisibilityGrid>& grids);
  void Warn(const std::vector<shadowcones::VisibilityGrid>& grids, vtkFieldData* coneField, const Scene& scene,
    vtkIdType points);

  int Method = Exact;
  int Dimensions[3] = { 65, 65, 65 };
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double AutomaticBounds[6] = {}; // as announced where Bounds are not set; 0: there are none
  int NumberOfLightSamples = 16;
  int BrickParts = 2;
  double RefinementThreshold = 0.5;
  bool ComputeFluenceRate = false;
  int Seed = 1;

  std::unique_ptr<shadowcones::PreparedUser> Prepared;
};

#endif
