// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPhotonMapFilter
 * @brief Photon maps: where light that was scattered or reflected before meets surfaces and the medium.
 *
 * Photons leave the lights, fly through the medium, are scattered by its phase function and reflected by diffuse surfaces, and
 * are stored where that happens (Jensen and Christensen, "Efficient Simulation of Light Transport in Scenes with Participating
 * Media using Photon Maps", SIGGRAPH 1998). vtkScatteringImageFilter takes the maps on its port 5 and adds multiple scattering
 * and indirect light to its direct light. Light straight from a lamp is not stored, since direct light stays with the cones;
 * StoreDirect stores it too, with "Bounces" 0, which the image leaves out.
 *
 * Distances to collisions are drawn exactly, in a density by delta tracking (Woodcock et al. 1965). Where wavelengths differ in
 * their extinction each photon has one that draws its flights, and weights for all by the balance heuristic (Wilkie et al.,
 * "Hero Wavelength Spectral Sampling", 2014): right in the mean, and no weight above the number of wavelengths. Photons end by
 * Russian roulette, so that their powers stay alike. scPhotonMap.h has the derivation. Photon i is a pure function of (Seed,
 * i): the same bytes for any number of threads, and pieces are ranges of photons whose union is the whole.
 *
 * Input ports:
 * - 0, vtkPolyData or a composite: the mesh; polygons and strips, casters and receivers alike. Cell data "Reflectance" (1
 *   component or one a wavelength sample, 0..1, optional). It may be missing or empty: then there is the medium alone.
 * - 1, vtkPolyData or composites: the lights, one a connection or block. They share the photons by power, see
 *   vtkShadowVectorFilter. Lights outside the bounds of mesh and medium send their photons at these alone. Lamps are no
 *   bodies: light passes through them.
 * - 2, vtkImageData, optional: the density of the medium, as on port 4 of vtkScatteringImageFilter.
 *
 * Output port 0, surface photons, and output port 1, volume photons, one vertex each (points in double precision). Point data:
 * "Direction" (float 3, unit, the way that the light travels before it meets what is there), "Power" (float, one component a
 * wavelength sample, W: on surfaces the flux that arrives, in the medium the flux that is scattered there), "Bounces" (int,
 * scatterings and reflections before: 1 and above, 0 straight from a light). Surface photons have "Normal" too (float 3, unit,
 * on the side that the light came from). So the sum of "Power" over an area tells its irradiance, over a volume the light
 * that it scatters: SigmaS times its mean fluence rate.
 *
 * Field data: "PhotonMap" (int: 0 surface, 1 volume), "NumberOfPhotons" (id, emitted in all), "Seed", "MaximumBounces"
 * (int); the account of the photons of the piece (double, one component a wavelength sample, W): "EmittedPower" (into the
 * scene) = "PowerAbsorbedBySurfaces" + "PowerAbsorbedByMedium" + "EscapedPower" + "CutOffPower" (left at MaximumBounces) in the
 * mean; the medium: "SigmaS", "SigmaA" (double, one component a wavelength sample), "MediumBounds" (double 6),
 * "PhaseFunction" (int), "PhaseLobes" (double 3), "PhaseAsymmetry" (double); "OccluderNames", "CastersFingerprint",
 * "LightFingerprint" and the lights' exact shapes.
 *
 * @warning Memory is 44 bytes and 4 more a wavelength for each photon that is stored, 12 more on surfaces, and twice that while
 * outputs are written; MaximumStoredPhotons ends it. In a thick medium that absorbs little a photon is stored at each of
 * hundreds of scatterings.
 *
 * @sa vtkScatteringImageFilter vtkShadowVectorFilter vtkAreaLightSource
 */
#ifndef vtkPhotonMapFilter_h
#define vtkPhotonMapFilter_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <map>
#include <memory>
#include <string>

class vtkDataArray;

namespace shadowcones
{
class PreparedUser;
struct PhotonInputs;
struct SchlickLobes;
} // namespace shadowcones

class SHADOWCONESFILTERS_EXPORT vtkPhotonMapFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkPhotonMapFilter* New();
  vtkTypeMacro(vtkPhotonMapFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  enum PhaseFunctionType
  {
    Isotropic = 0,
    BlasiSchlick = 1,
    HenyeyGreenstein = 2,
    Rayleigh = 3
  };

  ///@{
  /// The light, input port 1. Required.
  /// Several lights: one a connection, or a block of a composite, all with the same wavelengths. Set replaces all of
  /// them.
  void SetLightConnection(vtkAlgorithmOutput* light);
  void SetLightData(vtkDataObject* light);            ///< The light as a data object, without a pipeline.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light.
  void AddLightData(vtkDataObject* light);            ///< One more light as a data object, without a pipeline.
  void RemoveAllLights();                             ///< No light is connected from here on.
  ///@}

  ///@{
  /// The density of the medium, input port 2. Optional; nullptr: 1 everywhere. Where it has several arrays,
  /// SetInputArrayToProcess(0, 2, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name) chooses; the name "(automatic)" is no choice.
  void SetDensityConnection(vtkAlgorithmOutput* density);
  void SetDensityData(vtkDataObject* density); ///< The density as a data object, without a pipeline.
  ///@}

  ///@{
  /// Photons that leave the lights, all together. Default: 100000. Valid: 0 and above.
  vtkSetMacro(NumberOfPhotons, vtkIdType);
  vtkGetMacro(NumberOfPhotons, vtkIdType); ///< Photons that leave the lights, all together.
  ///@}

  ///@{
  /// Scatterings and reflections after which a photon is stored for the last time. What light it still has is missing: "CutOffPower".
  /// Default: 1000. Valid: 0 and above; 0 stores nothing but direct light.
  vtkSetMacro(MaximumBounces, int);
  vtkGetMacro(MaximumBounces, int); ///< Bounces after which a photon is stored for the last time.
  ///@}

  ///@{
  /// Photons of a map, at most: a run that would store more ends with an error. Default: 20000000. Valid: 1 and above.
  vtkSetMacro(MaximumStoredPhotons, vtkIdType);
  vtkGetMacro(MaximumStoredPhotons, vtkIdType); ///< Photons of a map, at most.
  ///@}

  ///@{
  /// Store light straight from the lamps too, with "Bounces" 0. Default: off. Valid: on, off.
  vtkSetMacro(StoreDirect, bool);
  vtkGetMacro(StoreDirect, bool); ///< Whether light straight from the lamps is stored too.
  /// Store light straight from the lamps too.
  vtkBooleanMacro(StoreDirect, bool); ///< Store light that has bounced alone.
  ///@}

  ///@{
  /// Scattering coefficient of the medium, 1 / world unit. SetSigmaS() sets every wavelength; SetSigmaSSpectrum() then sets the
  /// sample with an index from 0, or the first ones, the others keep SigmaS. Default: 0.1. Valid: 0 and above.
  void SetSigmaS(double sigmaS);
  vtkGetMacro(SigmaS, double);                         ///< SigmaS of wavelengths that have none of their own.
  double GetSigmaSSpectrum(int index);                 ///< SigmaS of one wavelength sample.
  void SetSigmaSSpectrum(vtkDataArray* coefficients);  ///< SigmaS of the first samples, in place of all that were set.
  void SetSigmaSSpectrum(int index, double sigmaS);    ///< SigmaS of one wavelength sample, index from 0.
  void ClearSigmaSSpectrum();                          ///< Every sample is SigmaS again.
  ///@}

  ///@{
  /// Absorption coefficient of the medium, 1 / world unit, set as SigmaS is. Default: 0. Valid: 0 and above.
  void SetSigmaA(double sigmaA);
  vtkGetMacro(SigmaA, double);                         ///< SigmaA of wavelengths that have none of their own.
  double GetSigmaASpectrum(int index);                 ///< SigmaA of one wavelength sample.
  void SetSigmaASpectrum(vtkDataArray* coefficients);  ///< SigmaA of the first samples, in place of all that were set.
  void SetSigmaASpectrum(int index, double sigmaA);    ///< SigmaA of one wavelength sample, index from 0.
  void ClearSigmaASpectrum();                          ///< Every sample is SigmaA again.
  ///@}

  ///@{
  /// Into which directions the medium scatters, as in vtkScatteringImageFilter. Default: Isotropic. BlasiSchlick takes
  /// PhaseLobes, HenyeyGreenstein takes PhaseAsymmetry.
  vtkSetMacro(PhaseFunction, int);
  vtkGetMacro(PhaseFunction, int); ///< 0 Isotropic, 1 BlasiSchlick, 2 HenyeyGreenstein, 3 Rayleigh.
  void SetPhaseFunctionToBlasiSchlick() { this->SetPhaseFunction(BlasiSchlick); } ///< The two lobes of PhaseLobes.
  void SetPhaseFunctionToIsotropic() { this->SetPhaseFunction(Isotropic); }       ///< All directions alike.
  void SetPhaseFunctionToRayleigh() { this->SetPhaseFunction(Rayleigh); } ///< Particles much smaller than a wavelength.
  /// The lobe of PhaseAsymmetry.
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HenyeyGreenstein); }
  ///@}

  ///@{
  /// Asymmetry g of HenyeyGreenstein: the mean cosine. Default: 0. Valid: between -1 and 1, positive forward.
  vtkSetMacro(PhaseAsymmetry, double);
  vtkGetMacro(PhaseAsymmetry, double); ///< HenyeyGreenstein: the mean cosine.
  ///@}

  ///@{
  /// The two lobes of BlasiSchlick: weight w of the first, and their k1 and k2. Default: 0.5, 0.46, -0.46, the Rayleigh
  /// preset. Valid: weight 0..1, k between -1 and 1, positive forward.
  vtkSetVector3Macro(PhaseLobes, double);
  /// BlasiSchlick: weight of the first lobe, k1, k2.
  vtkGetVector3Macro(PhaseLobes, double);
  ///@}

  ///@{
  /// Set PhaseFunction to BlasiSchlick with named lobes (Blasi, Le Saec and Schlick 1993): Rayleigh (0.5, 0.46, -0.46), HazyMie
  /// (0.12, -0.50, 0.70) and MurkyMie (0.19, -0.65, 0.91).
  void SetPhasePresetToRayleigh();
  void SetPhasePresetToHazyMie();  ///< BlasiSchlick with lobes 0.12, -0.50, 0.70: haze.
  void SetPhasePresetToMurkyMie(); ///< BlasiSchlick with lobes 0.19, -0.65, 0.91: murk.
  ///@}

  ///@{
  /// Diffuse reflectance of surfaces where the mesh has no cell array "Reflectance". Default: 0.5. Valid: 0..1.
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double); ///< Diffuse reflectance of surfaces without a cell array "Reflectance", 0..1.
  ///@}

  ///@{
  /// The box that the medium fills, world units: x from, to, y from, to, z from, to. Default: 1, -1, 1, -1, 1, -1, which stands
  /// for the joint bounds of mesh and light as in vtkScatteringImageFilter. Valid: from at most to.
  vtkSetVector6Macro(MediumBounds, double);
  /// The box that the medium fills, world units: x from, to, y from, to, z from, to.
  vtkGetVector6Macro(MediumBounds, double);
  ///@}

  ///@{
  /// Any integer: chooses the photons. Default: 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Number that chooses the photons.
  ///@}

  ///@{
  /// The mesh that photons fly in, its search tree and the density, kept for the next photons and for other filters, see
  /// vtkScatteringImageFilter.
  vtkObject* GetPreparedScene();
  vtkTypeInt64 GetPreparedMemory();        ///< Bytes that the scene takes.
  /// Fly photons in the mesh of another filter's scene. Default: a scene of its own.
  void SetPreparedScene(vtkObject* scene);
  vtkIdType GetNumberOfPreparations();     ///< Meshes and trees that were built here.
  void ReleasePreparedScene();             ///< Keep nothing until the next run.
  ///@}

protected:
  vtkPhotonMapFilter();
  ~vtkPhotonMapFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPhotonMapFilter(const vtkPhotonMapFilter&) = delete;
  void operator=(const vtkPhotonMapFilter&) = delete;

  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  void SetPhasePreset(const shadowcones::SchlickLobes& lobes);
  /// @return false, with a sentence in @p error, where something is missing or wrong.
  bool ReadInputs(vtkInformationVector** inputs, shadowcones::PhotonInputs& read, std::string& error);
  bool ReadMedium(shadowcones::PhotonInputs& read, std::string& error) const;
  void WriteField(const shadowcones::PhotonInputs& read, vtkPolyData* output) const;

  vtkIdType NumberOfPhotons = 100000;
  int MaximumBounces = 1000;
  vtkIdType MaximumStoredPhotons = 20000000;
  bool StoreDirect = false;
  double Reflectance = 0.5;
  double MediumBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double SigmaS = 0.1;
  std::map<int, double> SigmaSSpectrum; // samples that differ from SigmaS
  double SigmaA = 0.0;
  std::map<int, double> SigmaASpectrum; // samples that differ from SigmaA
  int PhaseFunction = Isotropic;
  double PhaseAsymmetry = 0.0;
  double PhaseLobes[3] = { 0.5, 0.46, -0.46 };
  int Seed = 1;

  std::unique_ptr<shadowcones::PreparedUser> Prepared;
};

#endif
