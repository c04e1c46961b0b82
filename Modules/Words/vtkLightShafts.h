// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLightShafts
 * @brief The light shafts around a mesh, as a picture that stands in space: a mesh is enough.
 *
 * One filter for the whole chain: the mesh becomes labelled occluders (vtkLabelOccluders); a lamp, a camera and a medium that suit it
 * are found where none is given (vtkSceneDefaults); the picture is rendered (vtkScatteringImageFilter in Guided, without cones: for
 * one picture making them takes as long as they save); and it is placed where the camera looks: in the plane through its focal
 * point, across its direction of view, as large as what it sees there. Seen from that camera the picture covers the view.
 *
 * Input port 0: the mesh, vtkDataSet or composite data, as vtkLabelOccluders takes it. Cell data "OccluderId" below 0 marks
 * receivers, which catch shadow and cast none.
 *
 * Input port 1, optional and repeatable: the lights, vtkPolyData or composites of them, as vtkScatteringImageFilter takes
 * them. Without one the scene is lit by a disc of radiance 1 (W m^-2 sr^-1) that suits the mesh.
 *
 * Output port 0, "Picture": vtkPolyData, one quad a pixel, in the order of the image (its lowest row first). Cell data: every
 * array that vtkScatteringImageFilter gives, "RGB" (unsigned char, 3 components) are the active scalars.
 *
 * Output port 1, "Lamp": vtkPolyData, the lamp that was taken for want of one; empty where lights are connected.
 *
 * Output port 2, "Image": vtkImageData, that of vtkScatteringImageFilter, with point data.
 *
 * An empty mesh gives empty outputs. Field data of the picture and the image are those of vtkScatteringImageFilter.
 *
 * Memory is that of vtkScatteringImageFilter and 100 bytes more a pixel.
 *
 * @warning Every change renders anew, also of the exposure: vtkToneMapRadiance gives the image another one without a ray. For cones,
 * volumes, densities and spectra of the medium use the filters of the chain themselves.
 *
 * @sa vtkSceneDefaults vtkScatteringImageFilter vtkAreaLightSource
 */
#ifndef vtkLightShafts_h
#define vtkLightShafts_h

#include "ShadowConesWordsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the camera

#include <string> // For messages

class vtkAlgorithmOutput;
class vtkAreaLightSource;
class vtkCamera;
class vtkImageData;
class vtkSceneDefaults;
class vtkScatteringImageFilter;

class SHADOWCONESWORDS_EXPORT vtkLightShafts : public vtkPolyDataAlgorithm
{
public:
  static vtkLightShafts* New();
  vtkTypeMacro(vtkLightShafts, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  enum UpType { Automatic = 0, X = 1, Y = 2, Z = 3 };
  enum ToneCurveType { Linear = 0, Filmic = 1 };

  ///@{
  /**
   * The lights, input port 1: one a connection, or blocks of a composite, all with the same wavelengths. Optional: none stands for
   * the lamp that suits the mesh. Set replaces all of them.
   */
  void SetLightConnection(vtkAlgorithmOutput* light);
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more of them.
  void SetLightData(vtkDataObject* light);            ///< As data, without a pipeline.
  void AddLightData(vtkDataObject* light);            ///< One more as data.
  void RemoveAllLights();                             ///< The lamp that suits the mesh again.
  ///@}

  ///@{
  /**
   * The camera: position, focal point, view up, view angle (vertical, or horizontal where the camera says so) and
   * parallel projection with its scale. Its changes re-run the filter. Default: none, which takes the one that suits the mesh.
   */
  virtual void SetCamera(vtkCamera* camera);
  virtual vtkCamera* GetCamera(); ///< The camera, or None for one that suits the mesh.
  ///@}

  ///@{
  /**
   * Which way is up in the scene: an axis, or what vtkSceneDefaults finds. It places the lamp and the camera that suit the
   * mesh. Default: Automatic.
   */
  vtkSetMacro(Up, int);
  vtkGetMacro(Up, int); ///< 0 Automatic, 1 X, 2 Y, 3 Z.
  void SetUpToZ() { this->SetUp(Z); }                 ///< Along z.
  void SetUpToY() { this->SetUp(Y); }                 ///< Along y.
  void SetUpToX() { this->SetUp(X); }                 ///< Along x.
  void SetUpToAutomatic() { this->SetUp(Automatic); } ///< As the mesh and the lights speak for.
  ///@}

  ///@{
  /**
   * Width and height of the picture in pixels. Default: 320, 240. Valid: at least 1 each, and at most 2^31 - 1 pixels in all.
   */
  vtkSetVector2Macro(Resolution, int);
  /// Width and height of the picture, pixels.
  vtkGetVector2Macro(Resolution, int);
  ///@}

  ///@{
  /**
   * Relative standard error of each pixel to reach, as vtkScatteringImageFilter has it. Default: 0.02. Valid: above 0.
   */
  vtkSetMacro(RelativeErrorGoal, double);
  vtkGetMacro(RelativeErrorGoal, double); ///< The relative error to reach in each pixel.
  ///@}

  ///@{
  /**
   * Optical depth of the medium along the longest side of its box: how much light it scatters, at whatever size the mesh has.
   * The scattering coefficient is this over that side; there is no absorption. Default: 0.7. Valid: 0 and above; 0.2 is clear
   * air in a room, 3 thick fog.
   */
  vtkSetMacro(OpticalDepth, double);
  vtkGetMacro(OpticalDepth, double); ///< Optical depth of the medium along the longest side of its box.
  ///@}

  ///@{
  /**
   * Mean cosine of scattering (Henyey and Greenstein): 0 scatters evenly, 0.4 to 0.8 is haze that glows towards the light.
   * Default: 0. Valid: between -1 and 1.
   */
  vtkSetMacro(PhaseAsymmetry, double);
  vtkGetMacro(PhaseAsymmetry, double); ///< Mean cosine of scattering.
  ///@}

  ///@{
  /**
   * The box that the medium fills, world units: x from, to, y from, to, z from, to. Default: 1, -1, 1, -1, 1, -1, which stands
   * for the one that suits the mesh and near lamps.
   */
  vtkSetVector6Macro(MediumBounds, double);
  /// The box that the medium fills, world units.
  vtkGetVector6Macro(MediumBounds, double);
  ///@}

  ///@{
  /**
   * Diffuse reflectance of surfaces where the mesh has no cell data "Reflectance". Default: 0.5. Valid: 0 to 1.
   */
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double); ///< Diffuse reflectance of surfaces.
  ///@}

  ///@{
  /**
   * Whether the camera sees the light itself. Default: on.
   */
  vtkSetMacro(LightVisible, bool);
  vtkGetMacro(LightVisible, bool); ///< Whether the camera sees the light itself.
  /// Show the light itself.
  vtkBooleanMacro(LightVisible, bool); ///< Show what it lights alone.
  ///@}

  ///@{
  /**
   * How brightness is shown, see vtkToneMapRadiance. Default: Filmic.
   */
  vtkSetMacro(ToneCurve, int);
  vtkGetMacro(ToneCurve, int);                                ///< 0 Linear, 1 Filmic.
  void SetToneCurveToFilmic() { this->SetToneCurve(Filmic); } ///< The lamp and its surroundings keep their shape.
  void SetToneCurveToLinear() { this->SetToneCurve(Linear); } ///< In proportion, cut at white.
  ///@}

  ///@{
  /**
   * What "RGB" shows "Radiance" times, with AutoExposure off; white is 1 after that. Default: 1. Valid: above 0.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double); ///< What counts with AutoExposure off.
  ///@}

  ///@{
  /**
   * Whether the exposure comes from the image, see vtkToneMapRadiance. Default: on.
   */
  vtkSetMacro(AutoExposure, bool);
  /// Take the exposure from the image.
  vtkBooleanMacro(AutoExposure, bool); ///< Take Exposure.
  vtkGetMacro(AutoExposure, bool); ///< Whether the exposure comes from the image.
  ///@}

  ///@{
  /**
   * Seed of the random numbers; the same seed gives the same bytes. Default: 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Seed of the random numbers.
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkLightShafts();
  ~vtkLightShafts() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLightShafts(const vtkLightShafts&) = delete;
  void operator=(const vtkLightShafts&) = delete;

  std::string CheckParameters() const;
  void SetUpImage(vtkSceneDefaults* defaults, vtkScatteringImageFilter* image) const;

  vtkSmartPointer<vtkCamera> Camera;
  int Up = Automatic;
  int Resolution[2] = { 320, 240 };
  double RelativeErrorGoal = 0.02;
  double OpticalDepth = 0.7;
  double PhaseAsymmetry = 0.0;
  double MediumBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Reflectance = 0.5;
  bool LightVisible = true;
  bool AutoExposure = true;
  double Exposure = 1.0;
  int ToneCurve = Filmic;
  int Seed = 1;
};

#endif
