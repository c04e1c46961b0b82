// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scKeptImage.h
 * @brief The last image that a filter rendered, kept for another exposure. Internal to Imaging.
 *
 * Its arrays are those of the filter's output, so that it costs no memory while that lives.
 */
#ifndef scKeptImage_h
#define scKeptImage_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkInformationVector;

namespace shadowcones
{

/// Which object stood on an input, and when it last changed.
struct InputStamp
{
  const vtkDataObject* Data = nullptr;
  vtkMTimeType Changed = 0; ///< the object, or a block of it
  vtkMTimeType Updated = 0; ///< by the pipeline

  bool operator==(const InputStamp& other) const
  {
    return this->Data == other.Data && this->Changed == other.Changed && this->Updated == other.Updated;
  }
};

struct KeptImage
{
  vtkSmartPointer<vtkImageData> Pixels; ///< all arrays but "RGB"; nullptr: none
  std::vector<double> Wavelengths;      ///< nm
  double Exposure = 0.0;                ///< that of the whole image, whatever the extent of Pixels; 0: not known

  /// Drop all of it where an input, or a parameter that the rendering depends on, has changed since.
  void DropIfOld(vtkInformationVector** inputs, int numberOfPorts, vtkMTimeType parametersChanged);
  void Drop();
  bool HoldsPixels(const int extent[6]) const;

private:
  std::vector<InputStamp> Inputs;
  vtkMTimeType ParametersChanged = 0;
};

} // namespace shadowcones

#endif
