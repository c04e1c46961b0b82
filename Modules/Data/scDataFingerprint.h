// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scDataFingerprint.h
 * @brief Data objects told apart by all that they hold.
 */
#ifndef scDataFingerprint_h
#define scDataFingerprint_h

#include "ShadowConesDataModule.h"
#include "scFingerprint.h"

class vtkAbstractArray;
class vtkDataObject;

namespace shadowcones
{

/// Add an array: its type, components and values.
SHADOWCONESDATA_EXPORT void AddArray(vtkAbstractArray* array, Fingerprint& fingerprint);

/// Add points, cells, grids and every array of a data object, block by block where it is composite; null is data too.
SHADOWCONESDATA_EXPORT void AddData(vtkDataObject* data, Fingerprint& fingerprint);

} // namespace shadowcones

#endif
