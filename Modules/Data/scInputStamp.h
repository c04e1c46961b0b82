// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scInputStamp.h
 * @brief Whether an input is still what it was.
 */
#ifndef scInputStamp_h
#define scInputStamp_h

#include "ShadowConesDataModule.h"
#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkInformationVector;

namespace shadowcones
{

/// Which object stood on an input, and when it last changed. VTK never gives a time twice.
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

/// Of an object, which may be null.
SHADOWCONESDATA_EXPORT InputStamp StampOf(vtkDataObject* data);
/// Of the connections of some ports, with an empty one before those of each port.
SHADOWCONESDATA_EXPORT std::vector<InputStamp> StampsOf(vtkInformationVector* const* ports, int numberOfPorts);

} // namespace shadowcones

#endif
