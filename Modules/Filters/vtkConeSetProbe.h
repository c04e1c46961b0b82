// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkConeSetProbe
 * @brief Lit, penumbra or umbra, whose shadow, and how sure: at the points or cells of any data set.
 *
 * Exact sends rays from a point to stratified samples of the light, but only where the point is inside a cone or at
 * most one base radius before its base; elsewhere the light is taken as visible. Its cones are to be bounds
 * (LightGeometry, Overlap, CosineCorrection off). Soft needs no mesh: the base discs of the cones are the occluders,
 * and each hides from a point the samples of the light behind it; its discs are best made with CosineCorrection off (a
 * correction that the cone set's field data tells of is taken back). Cells with a negative "OccluderId" of the mesh are
 * receivers and cast no shadow.
 *
 * A surface casts no shadow on itself: a triangle (Exact) or disc (Soft) in whose plane a point lies hides nothing from
 * it. Where the data set has active normals (of points or of cells, as Association says) light that comes from below
 * the surface is hidden by it, so that faces turned away from the light are in full shadow. Soft needs normals for that
 * on closed surfaces too; Exact finds it out by itself there, and needs them on open sheets only.
 *
 * Results are the same bytes for any number of threads, and the samples of a point are a pure function of (Seed, its
 * coordinates), so that pieces of a data set give what the whole does. Piece requests and extents are passed to input
 * 0.
 *
 * Input port 0: any vtkDataSet. Input port 1: a cone set, optional for Exact, which without one sends rays from every point;
 * point data "Axis" (3), "BaseRadius" and "HalfAngle" are required, "Normal", "OccluderId", "Planarity" and "LightId" are
 * optional. Input port 2: the lights, each of vtkAreaLightSource or any mesh of polygons, one a connection or a block of a
 * composite. Input port 3, required for Exact: the mesh,
 * vtkPolyData with cell data "OccluderId" (any numeric type; without it every id is 0), or composite data of meshes, which
 * are joined. Composite data on port 0 are answered block by block.
 *
 * Output: the input's type, structure and arrays, and in its point data (or cell data, as Association says)
 * "Visibility" (float 0..1, visible share of the part of the light that emits towards the point), "ShadowClass"
 * (unsigned char: 0 lit, every sample is visible; 1 penumbra; 2 umbra, none is), "OccluderId" (int, the occluder that
 * hides most of the light, the smallest id of several; -1 where none hides any), "VisibilityError" (float, standard
 * error of Visibility). Arrays of these names are replaced. Points and cells that "vtkGhostType" marks as hidden, and
 * cells that use a hidden point, get NaN, 255, -1 and NaN; duplicates are computed. Field data "OccluderNames" (by id) and
 * "CastersFingerprint" say of what mesh. On the dark side of the light, and where only the surface
 * itself hides the light, Visibility is 0, ShadowClass 2, OccluderId -1. Each array has one component a light, in the
 * order of connections and blocks, and a light is asked for inside its own cones ("LightId"). Field data
 * "LightFingerprint" (unsigned 64-bit, one value a light) and "Certified" (int; Exact: 1 where the cones are proved for this
 * mesh and these lights, or where there are none). Where points lie out of the box in which a set is proved
 * ("CertifiedBounds") all are asked.
 *
 * On request, light that arrives, from all lights together: "Irradiance" (float, one component a wavelength, W m^-2: the
 * integral of radiance x visibility x cosine over the side of the normal), "FluenceRate" (float, one a wavelength, W m^-2: the
 * integral of radiance x visibility over all directions, or over those above the surface where UseNormals finds one) and
 * "Illuminance" (float, lux). A wavelength is a band: W m^-2 in it, not per nm. Coordinates count as metres where they are
 * divided by (point lights). Each has a standard error, "IrradianceError", "FluenceRateError", "IlluminanceError". The whole
 * of a light is taken in closed form, the seen share of it from the samples, weighted by their solid angle and cosine: where
 * nothing hides the light the values are exact. Hidden points, and those whose normal has no length, get NaN.
 *
 * With k of n samples visible VisibilityError is sqrt(p (1 - p) / n), p = (k + 1/2) / (n + 1): the standard error of
 * independent samples, a bound for these stratified ones. It is 0 where nothing was sampled (outside all cones, on the
 * dark side of the light, point lights). It says nothing of shadow that lies outside the cones (Exact; there is none where
 * the set is proved: "Certified" of vtkConeSetFilter) or of what the discs miss (Soft).
 *
 * @sa vtkConeSetFilter vtkConeSetAccuracy vtkAreaLightSource
 */
#ifndef vtkConeSetProbe_h
#define vtkConeSetProbe_h

#include "ShadowConesFiltersModule.h"
#include "vtkDataSetAlgorithm.h"

#include <map> // for the efficacies
#include <memory>
#include <string>

class vtkDataArray;
class vtkFieldData;

namespace shadowcones
{
class PreparedUser;
class Team;
struct VisibilityResult;
}

class SHADOWCONESFILTERS_EXPORT vtkConeSetProbe : public vtkDataSetAlgorithm
{
public:
  static vtkConeSetProbe* New();
  vtkTypeMacro(vtkConeSetProbe, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// The cone set, input port 1. Optional for Exact: without it rays are sent from every point.
  void SetConeSetConnection(vtkAlgorithmOutput* cones);
  void SetConeSetData(vtkDataObject* cones); ///< The cone set as a data object, without a pipeline.
  ///@}

  ///@{
  /// The light, input port 2.
  /// Several lights: one a connection, or a block of a composite, all with the same wavelengths. Set replaces all of
  /// them.
  void SetLightConnection(vtkAlgorithmOutput* light);
  void SetLightData(vtkDataObject* light);            ///< The light as a data object, without a pipeline.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light.
  void AddLightData(vtkDataObject* light);            ///< One more light as a data object, without a pipeline.
  void RemoveAllLights();                             ///< No light is connected from here on.
  ///@}

  ///@{
  /// The mesh, input port 3. Required for Exact, not used by Soft.
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The mesh as a data object, without a pipeline.
  ///@}

  enum MethodType
  {
    Exact = 0,
    Soft = 1,
    // Older spelling.
    EXACT = Exact,
    SOFT = Soft
  };
  ///@{
  /// What hides the light. Exact: the mesh, asked inside cones only. Soft: the base discs of the cones. Default Exact.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);                           ///< 0 Exact, 1 Soft.
  void SetMethodToExact() { this->SetMethod(Exact); } ///< Ask the mesh, inside cones only.
  void SetMethodToSoft() { this->SetMethod(Soft); }   ///< Ask the base discs of the cones; needs no mesh.
  ///@}

  enum AssociationType
  {
    Points = 0,
    Cells = 1,
    // Older spelling.
    POINTS = Points,
    CELLS = Cells
  };
  ///@{
  /// Where to ask: at points, or at the centres of cells; the arrays go to the data of the same. Default Points.
  vtkSetMacro(Association, int);
  vtkGetMacro(Association, int);                                  ///< 0 Points, 1 Cells.
  void SetAssociationToPoints() { this->SetAssociation(Points); } ///< Ask at points; the arrays go to the point data.
  /// Ask at the centres of cells; the arrays go to the cell data.
  void SetAssociationToCells() { this->SetAssociation(Cells); }
  ///@}

  ///@{
  /// Samples of the light for each point, 1 to 65536. Time grows with it; a point light takes one. Default 64.
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Samples of the light for each point.
  ///@}

  ///@{
  /// Add "Irradiance" and "IrradianceError". Needs active normals, of points or of cells as Association says. Default off.
  vtkSetMacro(ComputeIrradiance, bool);
  vtkGetMacro(ComputeIrradiance, bool); ///< Whether "Irradiance" is added.
  /// Add "Irradiance" and "IrradianceError".
  vtkBooleanMacro(ComputeIrradiance, bool); ///< Leave "Irradiance" out.
  ///@}

  ///@{
  /// Add "FluenceRate" and "FluenceRateError". Default off.
  vtkSetMacro(ComputeFluenceRate, bool);
  vtkGetMacro(ComputeFluenceRate, bool); ///< Whether "FluenceRate" is added.
  /// Add "FluenceRate" and "FluenceRateError".
  vtkBooleanMacro(ComputeFluenceRate, bool); ///< Leave "FluenceRate" out.
  ///@}

  ///@{
  /// Add "Illuminance" (lux) and "IlluminanceError": the irradiance weighted as LuminousEfficacySpectrum says. Needs normals
  /// as ComputeIrradiance does. Default off.
  vtkSetMacro(ComputeIlluminance, bool);
  vtkGetMacro(ComputeIlluminance, bool); ///< Whether "Illuminance" is added.
  /// Add "Illuminance" and "IlluminanceError".
  vtkBooleanMacro(ComputeIlluminance, bool); ///< Leave "Illuminance" out.
  ///@}

  ///@{
  /// What a watt in a wavelength is worth to the eye, lm/W, index from 0, 0 and above. Wavelengths that are not set have 683
  /// times the CIE's photopic V at the middle of their band ("LightWavelengths" of the light; without it equal bands from 400
  /// to 700 nm). A light of one wavelength should have it set: 683 for radiance counted at 555 nm.
  void SetLuminousEfficacySpectrum(int index, double efficacy);
  void SetLuminousEfficacySpectrum(vtkDataArray* efficacies); ///< Of the first wavelengths, in place of all that were set.
  void ClearLuminousEfficacySpectrum();                       ///< Every wavelength has its own V again.
  double GetLuminousEfficacySpectrum(int index); ///< Efficacy of a wavelength, lm/W; -1: not set, as the CIE's V has it.
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
  /// Seed of the light samples, any integer. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the light samples.
  ///@}

  ///@{
  /// What Exact builds of the mesh is kept from run to run: as in vtkScatteringImageFilter, whose scene it may be.
  vtkObject* GetPreparedScene();
  vtkIdType GetNumberOfPreparations();     ///< How many of these this probe has built.
  vtkTypeInt64 GetPreparedMemory();        ///< Bytes of mesh and search tree.
  /// Take mesh and search tree from there. Default: a scene of its own.
  void SetPreparedScene(vtkObject* scene);
  void ReleasePreparedScene();             ///< Free them: the next run builds them again.
  ///@}

protected:
  vtkConeSetProbe();
  ~vtkConeSetProbe() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  struct Inputs;

  bool ReadInputs(vtkInformationVector** inputVector, vtkFieldData* coneData, Inputs& in, std::string& error);
  /// @return false where aborted.
  bool Probe(const Inputs& in, shadowcones::Team* team, shadowcones::VisibilityResult& result);
  /// What is wrong with the parameters, or with what is connected, as a sentence; empty where nothing is.
  std::string CheckRequest(vtkDataObject* cones, bool hasLight, vtkDataObject* mesh) const;
  /// Which light is to arrive, and that there are normals where it needs them. @return false, with a sentence in @p error.
  bool ReadArrivingLight(Inputs& in, std::string& error) const;

  vtkConeSetProbe(const vtkConeSetProbe&) = delete;
  void operator=(const vtkConeSetProbe&) = delete;

  int Method = Exact;
  int Association = Points;
  int NumberOfLightSamples = 64;
  bool ComputeIrradiance = false;
  bool ComputeFluenceRate = false;
  bool ComputeIlluminance = false;
  std::map<int, double> LuminousEfficacySpectrum; // of wavelengths that were set
  bool UseNormals = true;
  int Seed = 1;

  std::unique_ptr<shadowcones::PreparedUser> Prepared;
};

#endif
