// SPDX-License-Identifier: BSD-3-Clause
// One file because it is the manual of one filter.
/**
 * @class vtkScatteringImageFilter
 * @brief The light shafts that a camera sees in a participating medium lit by an area light.
 *
 * Single scattering of the light's radiance towards the camera along the part of every pixel's ray that lies in the
 * medium before the first surface, attenuated on both legs. A cone set tells where shadows can be. Six modes, from the
 * march of Hougs and Day ("Piecewise Constant Conic Sections for Accelerated Volume Density Rendering", section 4.3) to
 * faster estimators:
 *
 * - Guided: unshadowed light, by quadrature, times the share of it that is visible, by occlusion rays inside the cones
 *   until RelativeErrorGoal is met. Black, exactly, where every ray is blocked. Right where the cones bound the shadow;
 *   without a cone set the whole of every ray is sampled, which needs no cones and is slower.
 * - Volume: the blocked part is read from a visibility volume: one volume, any number of cameras.
 * - Soft: the blocked part from the cone set alone, without the mesh: the base discs of the cones are the occluders, on
 *   a grid of SoftDimensions. Its cones are to be discs (Tuning Soft of vtkConeSetFilter).
 * - BruteForce: a march with occlusion rays from every sample: the plain way. Needs no cones.
 * - Medium: the same samples, occlusion rays only inside the cones. Where the cones bound the shadow the image has the
 *   very bytes of BruteForce; where they do not, light leaks into it.
 * - Fast: the march without any occlusion ray; lit outside the cones, dark inside. Cones of full angle darken far too
 *   much: see vtkConeSetFilter's ExpansionFraction.
 *
 * BruteForce, Medium and Fast halve intervals of the march where the intensity differs too much between their ends,
 * over fresh stratified points of the light at every node.
 *
 * Surfaces are diffuse and alike on both sides, lit directly by the light: what nothing hides by quadrature, without
 * noise, and where something may be in the way with as many rays as RelativeErrorGoal asks for. Where the mesh has point
 * data "Normals" they are shaded with them, and rays start from the curved surface that these describe (Hanika, "Hacking
 * the Shadow Terminator", 2021): the shadow that a body casts on itself ends smoothly. Their shadows are traced with rays, in
 * Medium, Guided and Volume only where cones (without a cone set: marked points of the volume) reach. In Fast they are
 * dark inside the cones of *other* occluders than their own; in Soft their shadow is that of the grid one cell above.
 * That is single scattering and direct light. With photon maps on port 5 light that took more scatterings and reflections is
 * added, in every mode: in the medium by the beam radiance estimate (Jarosz, Zwicker and Jensen, Eurographics 2008), on
 * surfaces by the nearest photons. Its noise and blur are those of the maps: see PhotonNeighbors. Without maps
 * NumberOfPhotonPasses traces photons here, pass after pass.
 *
 * Input ports:
 * - 0, vtkPolyData: the mesh that casts and receives shadows; polygons and strips. Cell data "OccluderId" (int, 1
 *   component, optional; below 0: a receiver, which is seen and reflects, and hides no light), "Reflectance" (1 component or one a wavelength sample, 0..1, optional). Point data "Normals",
 *   else the active normals (3 components, any length, optional; turned to the camera's side; of length 0 or below
 *   their triangle: not used). It may be empty: the image then has no surfaces. Fast, Soft and Volume work without it.
 * - 1, vtkPolyData: the lights, from vtkAreaLightSource or any mesh of polygons, which emit along their normals; one a
 *   connection, or a block of a composite. What several lights send adds up; samples are taken for each of them, and
 *   each has its own cones ("LightId") and its own component of a visibility volume. A lamp hides no other. Field
 *   data "LightWavelengths" (nm, one a wavelength sample) gives "RGB" its colours; without it equal bins from 400 to
 *   700 nm.
 * - 2, vtkPolyData, optional: the cone set of vtkConeSetFilter. Needed by Medium, Fast and Soft; Guided and Volume are
 *   faster with it.
 * - 3, vtkImageData, optional: the visibility volume of vtkVisibilityVolume, or any image with point data "Visibility"
 *   (1 component, 0..1) at two points or more along every axis. Needed by Volume. Outside it everything is lit.
 * - 4, vtkImageData, optional, used in every mode: the density of the medium, which multiplies SigmaS and SigmaA. Point
 *   data: the array chosen with SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name), else
 *   "Density", else the active scalars, else the first array (1 component, 0 and above). Trilinear between its
 *   points, constant along an axis with a single one; where it does not reach there is no medium. Without it the density
 *   is 1.
 * - 5, vtkPolyData, optional, used in every mode: photon maps, output ports 0 and 1 of vtkPhotonMapFilter, one a connection
 *   in any order; one of them alone adds its own part. Several of a kind, of different Seed, are averaged: each more lowers noise
 *   and blur. Photons that have not bounced are left out: their light is in the image already.
 *
 * Output port 0, vtkImageData of Resolution[0] x Resolution[1] x 1 points; point (i, j) is a pixel, j upwards. Point
 * data:
 * - "Radiance" (float, one component a wavelength sample, W m^-2 sr^-1): InScattering + SurfaceRadiance + the light
 *   itself, with photon maps + MultipleScattering + IndirectSurface.
 * - "InScattering" (float, one component a wavelength sample): the medium term alone, up to the first surface.
 * - "SurfaceRadiance" (float, one component a wavelength sample): of the first surface, as seen through the medium. At
 *   edges these two, as the light itself, are means over the pixel; all else is of the ray through its centre.
 * - "Transmittance" (float, one component a wavelength sample, 0..1): of the medium to the first surface, or all
 *   through it.
 * - "Depth" (float, world units): along the ray to the first surface; -1 where there is none.
 * - "RelativeError" (float): one standard error of InScattering over its value, mean over wavelengths. Guided: of the
 *   samples and of the interpolated unshadowed light. BruteForce and Medium: from the differences between light
 *   samples; the steps of the march are not in it; -1 with one light sample. Volume and Soft: -1, not known. Fast: as
 *   BruteForce, without the error of its shadows. 0 where nothing scatters; 1 where InScattering is 0 because no sample
 *   saw any light, of which there may be some. Errors of several lights are added as they
 *   are, since the lights take the same random numbers: each meets RelativeErrorGoal, and so does their sum.
 * - "SurfaceRelativeError" (float): one standard error of SurfaceRadiance over its value, mean over wavelengths: of the
 *   shadow rays, with what they may have missed where all of them agree, and of the quadrature of unshadowed light. Where
 *   no cone reaches (Guided, Volume; in Volume without cones: no mark) it is that of the quadrature. -1 in Fast and
 *   Soft, whose shadows of surfaces have an unknown error. 0 where there is no surface, or none that faces a light; 1
 *   where SurfaceRadiance is 0 because no sample saw any light. Of several lights as "RelativeError".
 * - "SampleCount" (int): light samples taken for the medium term; in Volume and Soft places of the grid read.
 * - With photon maps or passes "MultipleScattering" (float, one component a wavelength sample): what the medium scatters towards the camera
 *   of light that was scattered or reflected before; "IndirectSurface" (float, one component a wavelength sample): what the
 *   first surface reflects of such light, as seen through the medium; "PhotonError" (float): one standard error of the two over
 *   their sum, mean over wavelengths, of the photons' noise: from the spread between passes, else as if photons were independent.
 *   Their blur is not in it.
 * - "RGB" (unsigned char, 3 components, the active scalars): Radiance times the exposure through ToneCurve as sRGB; equal
 *   energy is white, and what is negative within its error black.
 *
 * Field data: "LightFingerprint" (unsigned 64-bit, one value a light), "Mode" (int), "Seed" (int),
 * "RelativeErrorGoal" (double), "NumberOfOcclusionRays" (vtkIdType; of this
 * run and extent: those that filled a visibility volume before are in the volume's field data), "NumberOfShadowLines"
 * (vtkIdType; Guided: whole lines whose shadow was found at once, each counted as 16 samples and rays; 0: a first look
 * found that samples cost less), "RenderSeconds"
 * (double; the one array that differs from run to run), "CameraPosition", "CameraFocalPoint", "CameraViewUp" (double, 3
 * components), "CameraViewAngle" (double, degrees), "CameraParallelProjection" (int), "CameraParallelScale" (double),
 * "SigmaS", "SigmaA" (double, one component a wavelength sample), "MediumBounds" (double, 6 components),
 * "LightWavelengths" (double, nm, one tuple a wavelength sample), "Exposure" (double; that was used). With a cone set
 * "Certified" (int): 1 in Medium and Guided where the cones are proved for this mesh and these lights and are not cut,
 * else 0. Where medium or mesh reach out of the box in which a set is proved ("CertifiedBounds") rays are sent from
 * everywhere.
 *
 * The last image is kept for another exposure: its arrays are those of the output, which costs no memory while that lives
 * (4 bytes for each wavelength of four arrays and 16 more a pixel: 128 bytes with seven wavelengths).
 *
 * The bytes are the same for any number of threads and for any division into extents.
 *
 * @warning BruteForce, Medium and Fast have a finite step: light near a lamp inside the medium, and shafts thinner than
 * the medium's length over NumberOfSteps, want more steps. Volume knows its shadows to a cell or brick of the grid, and
 * cannot know whether the volume was made for this light and mesh. Near and far clipping planes, window centre, view
 * shear and lens parameters of the camera are not used.
 *
 * @sa vtkPhotonMapFilter vtkConeSetFilter vtkVisibilityVolume vtkAreaLightSource vtkLabelOccluders
 */
#ifndef vtkScatteringImageFilter_h
#define vtkScatteringImageFilter_h

#include "ShadowConesImagingModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For the camera and the last picture
#include "vtkTimeStamp.h" // For what has changed

#include <map>    // For the spectra
#include <memory> // For the image that is kept
#include <string> // For messages

class vtkAlgorithmOutput;
class vtkCamera;
class vtkDataArray;
class vtkImageData;

namespace shadowcones
{
class Warnings;
struct ImageScene;
struct KeptImage;
struct Monitor;
struct SchlickLobes;
class PreparedUser;
} // namespace shadowcones

class SHADOWCONESIMAGING_EXPORT vtkScatteringImageFilter : public vtkImageAlgorithm
{
public:
  static vtkScatteringImageFilter* New();
  vtkTypeMacro(vtkScatteringImageFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  enum ModeType
  {
    BruteForce = 0,
    Medium = 1,
    Fast = 2,
    Guided = 3,
    Soft = 4,
    Volume = 5
  };

  enum PhaseFunctionType
  {
    Isotropic = 0,
    BlasiSchlick = 1,
    HenyeyGreenstein = 2,
    Rayleigh = 3
  };

  enum ToneCurveType
  {
    Linear = 0,
    Filmic = 1
  };

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
   * The cone set, input port 2. Required by Medium, Fast and Soft, used by Guided and Volume, not by BruteForce.
   */
  void SetConeSetConnection(vtkAlgorithmOutput* cones);
  void SetConeSetData(vtkDataObject* cones); ///< The cone set as a data object, without a pipeline.
  ///@}

  ///@{
  /**
   * The visibility volume, input port 3. Required by Volume, not used by the others.
   */
  void SetVisibilityVolumeConnection(vtkAlgorithmOutput* volume);
  void SetVisibilityVolumeData(vtkDataObject* volume); ///< The visibility volume as a data object, without a pipeline.
  ///@}

  ///@{
  /**
   * The density of the medium, input port 4. Optional, used in every mode; nullptr: 1 everywhere. Where it has several
   * arrays, SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name) chooses; the name "(automatic)"
   * is no choice.
   */
  void SetDensityConnection(vtkAlgorithmOutput* density);
  void SetDensityData(vtkDataObject* density); ///< The density as a data object, without a pipeline.
  ///@}

  ///@{
  /**
   * Photon maps, input port 5: output ports 0 (surfaces) and 1 (medium) of vtkPhotonMapFilter, both or one of them. Optional,
   * used in every mode. Set replaces all of them. Maps of a kind are averaged.
   */
  void SetPhotonMapConnection(vtkAlgorithmOutput* photons);
  void SetPhotonMapData(vtkDataObject* photons);            ///< A photon map as a data object, without a pipeline.
  void AddPhotonMapConnection(vtkAlgorithmOutput* photons); ///< One more photon map.
  void AddPhotonMapData(vtkDataObject* photons);            ///< One more photon map as a data object, without a pipeline.
  void RemoveAllPhotonMaps();                               ///< No photon map is connected from here on.
  ///@}

  ///@{
  /**
   * The camera: position, focal point, view up, view angle (vertical, or horizontal where the camera says so) and
   * parallel projection with its scale. Its changes re-run the filter. Default: none, which looks along -z at the
   * sphere around the mesh's bounds (without a mesh: the medium's) with a view angle of 30 degrees.
   */
  virtual void SetCamera(vtkCamera* camera);
  virtual vtkCamera* GetCamera(); ///< The camera, or None for an automatic one.
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels. The aspect ratio follows from them. Default: 256, 256. Valid: at least 1
   * each, and at most 2^31 - 1 pixels in all.
   */
  vtkSetVector2Macro(Resolution, int);
  /// Width and height of the image, pixels.
  vtkGetVector2Macro(Resolution, int);
  ///@}

  ///@{
  /**
   * What occlusion is taken from, as described above. Default: Guided.
   */
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int); ///< 0 BruteForce, 1 Medium, 2 Fast, 3 Guided, 4 Soft, 5 Volume.
  void SetModeToBruteForce() { this->SetMode(BruteForce); } ///< A march with occlusion rays everywhere.
  void SetModeToMedium() { this->SetMode(Medium); }         ///< A march with occlusion rays inside the cones.
  void SetModeToFast() { this->SetMode(Fast); }             ///< A march without occlusion rays: dark inside the cones.
  void SetModeToGuided() { this->SetMode(Guided); } ///< Unshadowed light minus what is blocked, to RelativeErrorGoal.
  void SetModeToSoft() { this->SetMode(Soft); }     ///< Blocked light from the cones alone, without the mesh.
  void SetModeToVolume() { this->SetMode(Volume); } ///< Blocked light from a visibility volume.
  ///@}

  ///@{
  /**
   * A pixel takes as many samples as make the "RelativeError" of its medium term (Guided) and the "SurfaceRelativeError" of
   * its surfaces (every mode but Fast and Soft) about this, or MaximumSamples: so "Radiance" has it too. The medium's exceeds
   * it by 1.5 times at most. In pixels that are much darker than what the image shows it is a share of a tenth of that
   * image's mean brightness; surfaces of which no ray sees the light may err by this share of what they would show without
   * shadow. Default: 0.01. Valid: 0 and above; 0 takes MaximumSamples in every pixel that a cone reaches.
   */
  vtkSetMacro(RelativeErrorGoal, double);
  vtkGetMacro(RelativeErrorGoal, double); ///< The relative error of medium term and surfaces to reach in each pixel.
  ///@}

  ///@{
  /**
   * Light samples of a pixel, at most, each with one occlusion ray: of its medium term (Guided), and of each of its surfaces.
   * Default: 1024. Valid: at least 1.
   */
  vtkSetMacro(MaximumSamples, int);
  vtkGetMacro(MaximumSamples, int); ///< Light samples of a pixel, at most.
  ///@}

  ///@{
  /**
   * Soft: points along x, y and z of the grid over the medium's bounds on which the visible share of the light is
   * found. For more than one image of the same cones a vtkVisibilityVolume with Method Soft saves filling it again.
   * Default: 65, 65, 65. Valid: at least 2 each, at most 2^31 - 1 together.
   */
  vtkSetVector3Macro(SoftDimensions, int);
  /// Soft: points of the grid along x, y and z.
  vtkGetVector3Macro(SoftDimensions, int);
  ///@}

  ///@{
  /**
   * Soft: samples of the light for each point of the grid. Default: 64. Valid: 1 to 65,536.
   */
  vtkSetMacro(NumberOfSoftLightSamples, int);
  vtkGetMacro(NumberOfSoftLightSamples, int); ///< Soft: samples of the light for each point of the grid.
  ///@}

  ///@{
  /**
   * Scattering coefficient of the medium, 1 / world unit. SetSigmaS() sets every wavelength; SetSigmaSSpectrum() then
   * sets the sample with an index from 0, the others keep SigmaS. Default: 0.1. Valid: 0 and above.
   */
  void SetSigmaS(double sigmaS);
  vtkGetMacro(SigmaS, double); ///< Scattering coefficient of wavelengths that have none of their own, 1 / world unit.
  /// Scattering coefficient of one wavelength sample, index from 0, 1 / world unit.
  void SetSigmaSSpectrum(int index, double sigmaS);
  /// Scattering coefficients of the first samples, in place of all that were set, 1 / world unit.
  void SetSigmaSSpectrum(vtkDataArray* coefficients);
  void ClearSigmaSSpectrum();          ///< Every sample is SigmaS again.
  double GetSigmaSSpectrum(int index); ///< Scattering coefficient of one wavelength sample, 1 / world unit.
  ///@}

  ///@{
  /**
   * Absorption coefficient of the medium, 1 / world unit, set as SigmaS is. Default: 0. Valid: 0 and above.
   */
  void SetSigmaA(double sigmaA);
  vtkGetMacro(SigmaA, double); ///< Absorption coefficient of wavelengths that have none of their own, 1 / world unit.
  /// Absorption coefficient of one wavelength sample, index from 0, 1 / world unit.
  void SetSigmaASpectrum(int index, double sigmaA);
  /// Absorption coefficients of the first samples, in place of all that were set, 1 / world unit.
  void SetSigmaASpectrum(vtkDataArray* coefficients);
  void ClearSigmaASpectrum();          ///< Every sample is SigmaA again.
  double GetSigmaASpectrum(int index); ///< Absorption coefficient of one wavelength sample, 1 / world unit.
  ///@}

  ///@{
  /**
   * Into which directions the medium scatters. Default: Isotropic. BlasiSchlick takes PhaseLobes, HenyeyGreenstein
   * takes PhaseAsymmetry.
   */
  vtkSetMacro(PhaseFunction, int);
  vtkGetMacro(PhaseFunction, int); ///< 0 Isotropic, 1 BlasiSchlick, 2 HenyeyGreenstein, 3 Rayleigh.
  void SetPhaseFunctionToIsotropic() { this->SetPhaseFunction(Isotropic); }       ///< The same into all directions.
  void SetPhaseFunctionToBlasiSchlick() { this->SetPhaseFunction(BlasiSchlick); } ///< Two lobes, as PhaseLobes says.
  /// One lobe with the mean cosine PhaseAsymmetry.
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HenyeyGreenstein); }
  /// Particles much smaller than the wavelength.
  void SetPhaseFunctionToRayleigh() { this->SetPhaseFunction(Rayleigh); }
  ///@}

  ///@{
  /**
   * The two lobes of BlasiSchlick: weight w of the first, and their k1 and k2: w S(k1) + (1 - w) S(k2). A weight of 1
   * is one lobe alone. Default: 0.5, 0.46, -0.46, the Rayleigh preset. Valid: weight 0..1, k between -1 and 1, positive
   * forward.
   */
  vtkSetVector3Macro(PhaseLobes, double);
  /// BlasiSchlick: weight of the first lobe, k1, k2.
  vtkGetVector3Macro(PhaseLobes, double);
  ///@}

  ///@{
  /**
   * Set PhaseFunction to BlasiSchlick with named lobes (Blasi, Le Saec and Schlick 1993): Rayleigh (0.5, 0.46, -0.46;
   * within 5.2 % of Rayleigh), HazyMie (0.12, -0.50, 0.70) and MurkyMie (0.19, -0.65, 0.91).
   */
  void SetPhasePresetToRayleigh();
  void SetPhasePresetToHazyMie();  ///< BlasiSchlick with lobes 0.12, -0.50, 0.70: haze.
  void SetPhasePresetToMurkyMie(); ///< BlasiSchlick with lobes 0.19, -0.65, 0.91: murk.
  ///@}

  ///@{
  /**
   * Asymmetry g of HenyeyGreenstein: the mean cosine. Default: 0. Valid: between -1 and 1, positive forward.
   */
  vtkSetMacro(PhaseAsymmetry, double);
  vtkGetMacro(PhaseAsymmetry, double); ///< HenyeyGreenstein: the mean cosine.
  ///@}

  ///@{
  /**
   * The box that the medium fills, world units: x from, to, y from, to, z from, to. Default: 1, -1, 1, -1, 1, -1, which
   * stands for the joint bounds of mesh and light (without a Sun), each side enlarged by 10 % about the centre; a flat
   * side becomes 10 % of the diagonal. Without a mesh the bases of the cones stand for it, without both the visibility
   * volume is the box. Valid: from at most to; for Soft from below to.
   */
  vtkSetVector6Macro(MediumBounds, double);
  /// The box that the medium fills, world units: x from, to, y from, to, z from, to.
  vtkGetVector6Macro(MediumBounds, double);
  ///@}

  ///@{
  /**
   * BruteForce, Medium, Fast: equal intervals of the march along the part of a ray that lies in the medium. Default:
   * 32. Valid: 1 to 1,000,000.
   */
  vtkSetMacro(NumberOfSteps, int);
  vtkGetMacro(NumberOfSteps, int); ///< BruteForce, Medium, Fast: equal intervals of the march.
  ///@}

  ///@{
  /**
   * BruteForce, Medium, Fast: times that an interval of the march may be halved. Default: 3. Valid: 0..16.
   */
  vtkSetMacro(MaximumDepth, int);
  vtkGetMacro(MaximumDepth, int); ///< BruteForce, Medium, Fast: times that an interval may be halved.
  ///@}

  ///@{
  /**
   * BruteForce, Medium, Fast: an interval is halved where the intensities at its ends differ by more than this share of
   * the largest intensity at the ray's NumberOfSteps + 1 nodes. Default: 0.1. Valid: 0 and above.
   */
  vtkSetMacro(IntensityThreshold, double);
  vtkGetMacro(IntensityThreshold, double); ///< BruteForce, Medium, Fast: difference above which an interval is halved.
  ///@}

  ///@{
  /**
   * BruteForce, Medium, Fast: fresh stratified light points at every march sample. Default: 16. Valid: 1..65536.
   */
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< BruteForce, Medium, Fast: light points at every march sample.
  ///@}

  ///@{
  /**
   * Fewest light points for a surface that shadow may reach: half of them in a look that decides how many more
   * RelativeErrorGoal needs. Default: 16. Valid: 0..65536; 0 makes surfaces black.
   */
  vtkSetMacro(NumberOfSurfaceLightSamples, int);
  vtkGetMacro(NumberOfSurfaceLightSamples, int); ///< Fewest light points for a surface.
  ///@}

  ///@{
  /**
   * Where the corners of a pixel see other surfaces than its centre, 16 times so many camera rays tell which share of
   * the pixel each surface covers, and each is looked at along one ray; of more surfaces than twice this number some
   * are. A thing thinner than 0.7 pixels may slip through between the corners. Default: 4. Valid: 1 to 1024; 1: edges
   * are not anti-aliased.
   */
  vtkSetMacro(NumberOfEdgeSamples, int);
  vtkGetMacro(NumberOfEdgeSamples, int); ///< Camera rays where a pixel sees an edge.
  ///@}

  ///@{
  /**
   * The camera sees the light itself, with its exact shape, added to Radiance; it hides nothing. Default: on.
   */
  vtkSetMacro(LightVisible, bool);
  vtkGetMacro(LightVisible, bool); ///< Whether the camera sees the light itself.
  /// The camera sees the light itself.
  vtkBooleanMacro(LightVisible, bool); ///< Leave the light itself out of Radiance.
  ///@}

  ///@{
  /**
   * Diffuse reflectance of surfaces where the mesh has no cell array "Reflectance". Default: 0.5. Valid: 0..1.
   */
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double); ///< Diffuse reflectance of surfaces without a cell array "Reflectance", 0..1.
  ///@}

  ///@{
  /**
   * Neighbours of a photon within its radius: fewer are sharper, more are smoother. Default: 0, which takes 0.2 N^(1/2) of N
   * photons in the medium (8 to 4096) and 0.1 N^(2/3) on surfaces (32 to 4096), so that noise and blur shrink together, with N^(-1/3),
   * as photons become more. Valid: 0 and above.
   */
  vtkSetMacro(PhotonNeighbors, int);
  vtkGetMacro(PhotonNeighbors, int); ///< Neighbours of a photon within its radius; 0: automatic.
  ///@}

  ///@{
  /**
   * Trace photons here instead of taking photon maps: in so many passes of NumberOfPhotonsPerPass each, every one anew and
   * dropped when it has been asked. The mean of all passes is what one map of all their photons says, in the memory of one pass,
   * and "PhotonError" comes from the spread between them. More passes converge: the radius shrinks as photons become more.
   * Each part of an image traces all photons. Not used where photon maps are connected, with a warning. Default: 0, no photons.
   * Valid: 0 and above.
   */
  vtkSetMacro(NumberOfPhotonPasses, int);
  vtkGetMacro(NumberOfPhotonPasses, int); ///< Passes in which photons are traced here; 0: none.
  ///@}

  ///@{
  /**
   * Photons that leave the lights in a pass, all together. Default: 100000. Valid: 0 and above.
   */
  vtkSetMacro(NumberOfPhotonsPerPass, vtkIdType);
  vtkGetMacro(NumberOfPhotonsPerPass, vtkIdType); ///< Photons that leave the lights in a pass, all together.
  ///@}

  ///@{
  /**
   * Cones count up to this distance from their base only, world units (section 5 of the paper). Default: 0, not cut.
   * Valid: 0 and above.
   */
  vtkSetMacro(ConeLength, double);
  vtkGetMacro(ConeLength, double); ///< Distance from their base up to which cones count, world units; 0: not cut.
  ///@}

  ///@{
  /**
   * Find the exposure of "RGB" from the image, as vtkToneMapRadiance does: white is the 99th percentile of the luminance of
   * InScattering + SurfaceRadiance at fixed pixels of the whole image. Where a part of the image is asked for, those pixels
   * (some 4,096) are rendered too, once for all parts. Changing it renders nothing anew. Default: on.
   */
  virtual void SetAutoExposure(bool automatic);
  vtkGetMacro(AutoExposure, bool); ///< Whether the exposure is found from the image.
  /// Find the exposure from the image; Exposure is not used.
  vtkBooleanMacro(AutoExposure, bool); ///< Use Exposure.
  ///@}

  ///@{
  /**
   * "RGB" shows Radiance times this, (W m^-2 sr^-1)^-1; 1 after that is white. Used with AutoExposure off; set to anything
   * but 1 with AutoExposure on, it is not used, with a warning. Changing it renders nothing anew. Default: 1. Valid: above
   * 0, finite.
   */
  virtual void SetExposure(double exposure);
  vtkGetMacro(Exposure, double); ///< Exposure by hand. The one that was used is in the output's field data "Exposure".
  ///@}

  ///@{
  /**
   * What becomes of red, green and blue before they are encoded as sRGB: see vtkToneMapRadiance. Changing it renders nothing
   * anew. Default: Linear.
   */
  virtual void SetToneCurve(int curve);
  vtkGetMacro(ToneCurve, int); ///< 0 Linear, 1 Filmic.
  void SetToneCurveToLinear() { this->SetToneCurve(Linear); } ///< Brightness as it is, up to white.
  void SetToneCurveToFilmic() { this->SetToneCurve(Filmic); } ///< Highlights are rolled off.
  ///@}

  ///@{
  /**
   * Seed of the random numbers. Default: 1. Valid: any.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the random numbers.
  ///@}

  /**
   * The later of the filter's and the camera's time of change.
   */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Show the image at rising quality while it is made: coarse pictures of the whole come first, from one pixel for a
   * square of them, to an error goal of 0.05 at best, and cost about a tenth more. For each the event UpdateDataEvent
   * tells observers that GetPicture() has changed. Where a part of the image is asked for there is none. Default: off.
   * Valid: on, off.
   */
  void SetProgressive(bool progressive);
  vtkGetMacro(Progressive, bool); ///< Whether coarse pictures come first.
  /// Coarse pictures of the whole image come first.
  vtkBooleanMacro(Progressive, bool); ///< The image comes once, when it is finished.
  ///@}

  /**
   * With Progressive on, the last picture of the whole image, with the arrays of the output: while an update is under way
   * and after one that was aborted the best that there is. nullptr where there is none.
   */
  vtkImageData* GetPicture();

  ///@{
  /**
   * What is kept from one run to the next of what is costly to build: mesh, search tree, hierarchies
   * of cones, grids and density. It stands for as long as
   * the inputs that it is made from do not change. Another filter takes the same things instead of building its own
   * where a script hands the scene on: other->SetPreparedScene(this->GetPreparedScene()); the two then keep what both
   * need once. Results do not depend on it. nullptr: a scene of its own again.
   */
  vtkObject* GetPreparedScene();
  /// Keep what is costly to build together with another filter. Default: a scene of its own.
  void SetPreparedScene(vtkObject* scene);
  void ReleasePreparedScene(); ///< Free the memory; what is needed is built again.
  vtkTypeInt64 GetPreparedMemory(); ///< Bytes that the prepared scene takes.
  /// How often this filter has built any of it: it does not grow where an update finds all that it needs.
  vtkIdType GetNumberOfPreparations();
  ///@}

  /**
   * Occlusion rays sent by this filter since it was made. It does not grow where only the exposure has changed.
   */
  vtkGetMacro(NumberOfRaysSent, vtkIdType);

  /**
   * Mark the filter as changed: the image will be rendered anew.
   */
  void Modified() override;

protected:
  vtkScatteringImageFilter();
  ~vtkScatteringImageFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkScatteringImageFilter(const vtkScatteringImageFilter&) = delete;
  void operator=(const vtkScatteringImageFilter&) = delete;

  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  void SetPhasePreset(const shadowcones::SchlickLobes& lobes);
  void SetOptions(const int extent[6], shadowcones::ImageScene& scene) const;
  bool ReadScene(vtkInformationVector** inputs, shadowcones::ImageScene& scene, std::string& error);
  bool ShowCoarse(shadowcones::ImageScene& scene, const shadowcones::Monitor& monitor);
  bool RenderMissing(
    vtkInformationVector** inputs, const int extent[6], shadowcones::Warnings& warnings, std::string& error);

  vtkSmartPointer<vtkCamera> Camera;
  int Resolution[2] = { 256, 256 };
  int Mode = Guided;
  double RelativeErrorGoal = 0.01;
  int MaximumSamples = 1024;
  int SoftDimensions[3] = { 65, 65, 65 };
  int NumberOfSoftLightSamples = 64;
  double SigmaS = 0.1;
  double SigmaA = 0.0;
  std::map<int, double> SigmaSSpectrum; // samples that differ from SigmaS
  std::map<int, double> SigmaASpectrum; // samples that differ from SigmaA
  int PhaseFunction = Isotropic;
  double PhaseLobes[3] = { 0.5, 0.46, -0.46 };
  double PhaseAsymmetry = 0.0;
  double MediumBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  int NumberOfSteps = 32;
  int MaximumDepth = 3;
  double IntensityThreshold = 0.1;
  int NumberOfLightSamples = 16;
  int NumberOfSurfaceLightSamples = 16;
  int NumberOfEdgeSamples = 4;
  bool LightVisible = true;
  double Reflectance = 0.5;
  int PhotonNeighbors = 0;
  int NumberOfPhotonPasses = 0;
  vtkIdType NumberOfPhotonsPerPass = 100000;
  double ConeLength = 0.0;
  bool AutoExposure = true;
  double Exposure = 1.0;
  int ToneCurve = Linear;
  bool Progressive = false;
  int Seed = 1;

  vtkTimeStamp SceneTime; // when a parameter other than the exposure was set
  std::unique_ptr<shadowcones::KeptImage> Kept;
  std::unique_ptr<shadowcones::PreparedUser> Prepared;
  vtkIdType NumberOfRaysSent = 0;
  vtkSmartPointer<vtkImageData> Picture;
};

#endif
