// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DarkSpeed.h
 * @brief What Guided takes where most of the air is in shadow.
 */
#ifndef DarkSpeed_h
#define DarkSpeed_h

#include <string>

namespace shadowcones
{

/**
 * Print seconds and errors of Guided without cones at several goals and of the march with 128 steps by 4 light points, then the time
 * at the errors that are wanted: blinds 127 x 127 pixels (as many as 160 x 100), canopy 83 x 83 (96 x 72); and the room with blinds
 * 506 x 506 (640 x 400). Each picture three times, of which the shortest counts. References are kept in @p folder.
 */
void MeasureDark(const std::string& folder);

} // namespace shadowcones

#endif
