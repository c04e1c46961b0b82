// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scKeptImage.h
 * @brief The last image that a filter rendered, kept for another exposure. Internal to Imaging.
 *
 * Its arrays are those of the filter's output, so that it costs no memory while that lives.
 */
#ifndef scKeptImage_h
#define scKeptImage_h

#include "scInputStamp.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkImageData;
class vtkInformationVector;

namespace shadowcones
{

struct ImageScene;
struct ScatteringImage;

/// Is that extent the whole image?
bool IsWhole(const int extent[6], const int resolution[2]);

struct KeptImage
{
  vtkSmartPointer<vtkImageData> Pixels; ///< all arrays but "RGB"; nullptr: none
  std::vector<double> Wavelengths;      ///< nm
  double Exposure = 0.0;                ///< that of the whole image, whatever the extent of Pixels; 0: not known

  /// Drop all of it where an input, or a parameter that the rendering depends on, has changed since.
  void DropIfOld(vtkInformationVector** inputs, int numberOfPorts, vtkMTimeType parametersChanged);
  void Drop();
  bool HoldsPixels(const int extent[6]) const;

  /// Keep the arrays of an image of the scene, which loses them and took so long to render.
  void KeepPixels(ScatteringImage& image, const ImageScene& scene, const int extent[6], double seconds);
  /// What is still to be rendered: the extent that is asked for, then those that the exposure of the whole image is found from.
  std::vector<std::array<int, 4>> MissingExtents(
    const int extent[6], const int resolution[2], bool automaticExposure) const;
  /// Find the exposure from the extents that were rendered for it, if any were: those from the @p first on.
  void KeepExposure(
    const std::vector<std::array<int, 4>>& extents, const std::vector<ScatteringImage>& images, std::size_t first);

private:
  std::vector<InputStamp> Inputs;
  vtkMTimeType ParametersChanged = 0;
};

} // namespace shadowcones

#endif
