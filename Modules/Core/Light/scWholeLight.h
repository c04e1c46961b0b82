// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scWholeLight.h
 * @brief What the whole of a light brings to a point where nothing is in the way, in closed form.
 *
 * Both are for a light whose spectrum is 1: times its spectrum they are W m^-2. They are what the mean over samples of
 * SampleIncidentLight tends to: a Sun is a disc of directions that together bring its spectrum.
 */
#ifndef scWholeLight_h
#define scWholeLight_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"

namespace shadowcones
{

/// Integral over all directions: the solid angle of the emitting side; Point: 1 / distance^2; Sun: 1.
SHADOWCONESCORE_EXPORT double WholeFluence(const Light& light, const Vector3& from);

/**
 * Integral of the cosine with @p normal (unit) over the directions above the plane through the point: Lambert's sum over the
 * edges of what that plane leaves of the light. A sphere counts as the disc that is seen of it; of a mesh every triangle
 * counts that faces the point, those behind others too.
 */
SHADOWCONESCORE_EXPORT double WholeIrradiance(const Light& light, const Vector3& from, const Vector3& normal);

} // namespace shadowcones

#endif
