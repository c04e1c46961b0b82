// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterChecks.h
 * @brief Every filter asked of a scene in one mode: the list in AwkwardChecks.cxx is made of these.
 */
#ifndef FilterChecks_h
#define FilterChecks_h

#include "AwkwardChecks.h"

namespace robustness
{

///@{
/// ChainChecks.cxx: labels, vectors, cones.
Finding AskLabels(const Scene& scene, int by);
Finding AskVectors(const Scene& scene, int storage, bool target);
Finding AskCones(const Scene& scene, int tuning, int expansion, bool certify);
Finding AskGeometry(const Scene& scene, int cut);
///@}

///@{
/// VisibilityChecks.cxx: what places see of the lamp and of the Sun.
Finding AskProbe(const Scene& scene, int method, bool cones, bool raw, bool arriving);
Finding AskAccuracy(const Scene& scene);
Finding AskVolume(const Scene& scene, int method);
Finding AskSunHours(const Scene& scene, double diameter);
///@}

///@{
/// ShadowChecks.cxx: solids of shadows, and shadows on the ground.
Finding AskSolids(const Scene& scene, int method, int umbra);
Finding AskWidths(const Scene& scene);
Finding AskFootprints(const Scene& scene, bool write);
///@}

///@{
/// ImageChecks.cxx: pictures, and the page.
Finding AskImage(const Scene& scene, int mode);
Finding AskToneMap(const Scene& scene);
Finding AskPage(const Scene& scene);
///@}

} // namespace robustness

#endif
