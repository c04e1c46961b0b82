// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOptionalBounds.h
 * @brief Boxes that filters are given, or find.
 */
#ifndef scOptionalBounds_h
#define scOptionalBounds_h

#include "ShadowConesDataModule.h"
#include "scBox.h"

#include <string>

namespace shadowcones
{

/// True where six bounds are as filters have them before they are set: 1, -1, 1, -1, 1, -1.
SHADOWCONESDATA_EXPORT bool AreUnsetBounds(const double bounds[6]);
/**
 * The box that a medium or a visibility volume fills unless it is told: @p bounds (of the mesh) and those of the @p
 * lights (empty for a Sun), each side enlarged by 10 % about the centre; a flat side becomes 10 % of the diagonal.
 * @return false where there is nothing to take it from.
 */
SHADOWCONESDATA_EXPORT bool BoundsAround(const Box& bounds, const Box& lights, Box& around);

/// Six bounds as a box. @return false, with a sentence in @p error, where they do not ascend or are not finite.
SHADOWCONESDATA_EXPORT bool ReadBounds(const char* name, const double bounds[6], Box& box, std::string& error);
/// The same of a box that must have a volume.
SHADOWCONESDATA_EXPORT bool ReadSolidBounds(const char* name, const double bounds[6], Box& box, std::string& error);

} // namespace shadowcones

#endif
