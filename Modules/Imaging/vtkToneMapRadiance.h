// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToneMapRadiance
 * @brief A picture of spectral radiance: "RGB" from "Radiance", exposed by itself or by hand.
 *
 * Each pixel's spectrum becomes linear sRGB by the colour-matching functions of CIE 1931, so that equal energy is white; it is
 * multiplied by the exposure, goes through the tone curve and is encoded as sRGB. 0 and less is black, and with the linear
 * curve 1 and more is full.
 *
 * With AutoExposure white is the 99th percentile of the luminance of "InScattering" + "SurfaceRadiance" (+ "MultipleScattering" +
 * "IndirectSurface", where they are there): a lamp that the camera
 * sees does not darken what it lights. An image that lacks one of them is exposed by "Radiance" alone, its lamp included. Where
 * the percentile is 0 the largest luminance is white; where all is black the exposure is 1. The percentile is taken over fixed
 * pixels of the whole image: squares in the middle of its tiles of 32 x 32 pixels, some 4,096 pixels, all of a smaller image.
 * Any part of an image gets the bytes that it has in the whole.
 *
 * Input port 0, vtkImageData: point data "Radiance" (any number, one component a wavelength sample), "InScattering" and
 * "SurfaceRadiance" (optional, as many components), as vtkScatteringImageFilter writes them. Field data "LightWavelengths" (nm,
 * one a wavelength sample) gives the colours; without it equal bins from 400 to 700 nm. Slices along z are pictures of one
 * exposure.
 *
 * Output port 0, vtkImageData: the input with all its arrays, and
 * - point data "RGB" (unsigned char, 3 components, the active scalars);
 * - field data "Exposure" (double): the exposure that was used.
 *
 * The bytes are the same for any number of threads and for any division into extents. With AutoExposure the whole input is
 * asked for, whatever extent is wanted; without it the same extent.
 *
 * @sa vtkScatteringImageFilter, which does the same for its own image without rendering anew.
 */
#ifndef vtkToneMapRadiance_h
#define vtkToneMapRadiance_h

#include "ShadowConesImagingModule.h" // For export macro
#include "vtkImageAlgorithm.h"

class SHADOWCONESIMAGING_EXPORT vtkToneMapRadiance : public vtkImageAlgorithm
{
public:
  static vtkToneMapRadiance* New();
  vtkTypeMacro(vtkToneMapRadiance, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  enum ToneCurveType
  {
    Linear = 0,
    Filmic = 1
  };

  ///@{
  /**
   * Find the exposure from the image, as described above. Off: Exposure is used. Default: on.
   */
  vtkSetMacro(AutoExposure, bool);
  vtkGetMacro(AutoExposure, bool); ///< Whether the exposure is found from the image.
  /// Find the exposure from the image; Exposure is not used.
  vtkBooleanMacro(AutoExposure, bool); ///< Use Exposure.
  ///@}

  ///@{
  /**
   * "RGB" shows Radiance times this, (W m^-2 sr^-1)^-1; 1 after that is white. Used with AutoExposure off; set to anything
   * but 1 with AutoExposure on, it is not used, with a warning. Default: 1. Valid: above 0, finite.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double); ///< Exposure by hand. The one that was used is in the output's field data "Exposure".
  ///@}

  ///@{
  /**
   * What becomes of red, green and blue before they are encoded as sRGB. Linear: nothing; what is brighter than white is cut.
   * Filmic: the fit of K. Narkowicz ("ACES Filmic Tone Mapping Curve", 2015) to the curve of the Academy Color Encoding System,
   * (x (2.51 x + 0.03)) / (x (2.43 x + 0.59) + 0.14): what AutoExposure makes white is light grey (0.80), white begins at 7.2 times
   * that, so that lamps and what is near them keep their shape. Default: Linear.
   */
  vtkSetMacro(ToneCurve, int);
  vtkGetMacro(ToneCurve, int); ///< 0 Linear, 1 Filmic.
  void SetToneCurveToLinear() { this->SetToneCurve(Linear); } ///< Brightness as it is, up to white.
  void SetToneCurveToFilmic() { this->SetToneCurve(Filmic); } ///< Highlights are rolled off.
  ///@}

protected:
  vtkToneMapRadiance() = default;
  ~vtkToneMapRadiance() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkToneMapRadiance(const vtkToneMapRadiance&) = delete;
  void operator=(const vtkToneMapRadiance&) = delete;

  bool AutoExposure = true;
  double Exposure = 1.0;
  int ToneCurve = Linear;
};

#endif
