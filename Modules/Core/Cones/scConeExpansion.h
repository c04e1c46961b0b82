// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeExpansion.h
 * @brief Axis, base radius and half angles of a cone from its vectors (section 3.2.2). Internal to Core.
 */
#ifndef scConeExpansion_h
#define scConeExpansion_h

#include "scCone.h"
#include "scConeSet.h"
#include "scLightExtent.h"
#include "scShadowVectorView.h"

namespace shadowcones
{

/// Fill Axis, BaseRadius, HalfAngle and InnerHalfAngle of a cone whose Center and Normal are known.
void ExpandCone(const ShadowVectorView& vectors, const std::vector<vtkIdType>& members, const LightExtent& light,
  const ConeSetOptions& options, double planeRadius, Cone& cone);

} // namespace shadowcones

#endif
