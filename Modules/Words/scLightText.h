// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightText.h
 * @brief A lamp in words, so that reading them gives the very same lamp. Internal to the module.
 */
#ifndef scLightText_h
#define scLightText_h

#include "scLightGrammar.h"

#include <string>

namespace shadowcones
{

/// The words of a lamp; of a total those of its unit.
std::string TextOf(const Lamp& lamp);

} // namespace shadowcones

#endif
