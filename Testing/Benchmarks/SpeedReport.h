// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpeedReport.h
 * @brief The figures of one scene as tables and as JSON.
 */
#ifndef SpeedReport_h
#define SpeedReport_h

#include "JsonWriter.h"
#include "SpeedFigures.h"

namespace shadowcones
{

void PrintSpeed(const SpeedFigures& figures);
/// One object of a list.
void WriteSpeed(const SpeedFigures& figures, JsonWriter& json);

} // namespace shadowcones

#endif
