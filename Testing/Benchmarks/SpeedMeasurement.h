// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpeedMeasurement.h
 * @brief Time and error of every mode over its knobs on one scene, and of the baselines, all in one run.
 */
#ifndef SpeedMeasurement_h
#define SpeedMeasurement_h

#include "BenchmarkScene.h"
#include "SpeedFigures.h"

#include <string>

namespace shadowcones
{

struct SpeedSetting
{
  int Size = 256;
  int Threads = 2;
  int Repeats = 5;
  double Enough = 20.0; ///< seconds that all runs of one job may take together
  int Pixels = 2048;    ///< compared with the reference
  int Samples = 65536;  ///< of the reference for each of them
  std::string Folder = ".";
  RoomLamp Light;
  vtkIdType Vectors = 0; ///< 0: what the scene chooses
  int LocatorStride = 8; ///< the march with the locator takes every so many pixels, both ways
};

SpeedFigures MeasureSpeed(const std::string& nameOrFile, const SpeedSetting& setting);

} // namespace shadowcones

#endif
