// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowVectorView.h
 * @brief Shadow vectors as the fitting of cones sees them.
 */
#ifndef scShadowVectorView_h
#define scShadowVectorView_h

#include "vtkType.h"

namespace shadowcones
{

/// Shadow vectors, not owned; three doubles or floats each.
struct ShadowVectorView
{
  vtkIdType Count = 0;
  const double* Points = nullptr;
  const float* Directions = nullptr;      ///< unit, away from the light
  const double* EmissionPoints = nullptr; ///< on the light
  const int* OccluderIds = nullptr;       ///< one each, or nullptr: all 0
  const int* LightIds = nullptr;          ///< one each, or nullptr: all 0
};

} // namespace shadowcones

#endif
