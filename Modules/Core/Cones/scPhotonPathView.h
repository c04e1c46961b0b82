// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonPathView.h
 * @brief Photon paths as the fitting of cones sees them.
 */
#ifndef scPhotonPathView_h
#define scPhotonPathView_h

#include "vtkType.h"

namespace shadowcones
{

/// Photon paths, not owned.
struct PhotonPathView
{
  vtkIdType Count = 0;
  const double* Points = nullptr;         ///< where the path ends
  const double* EmissionPoints = nullptr; ///< where it starts
  const float* Directions = nullptr;
  const int* States = nullptr;   ///< 0 lit, 1 blocked at Points
  const int* LightIds = nullptr; ///< one each, or nullptr: all 0
};

} // namespace shadowcones

#endif
