// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RivalRows.h
 * @brief Every rival with its settings on one scene: what it costs to build, to keep and to ask, and how far off its image is.
 */
#ifndef RivalRows_h
#define RivalRows_h

#include "ReferencePixels.h"

#include <string>
#include <vector>

namespace shadowcones
{

struct RivalSetting
{
  int Size = 96;
  int Places = 64; ///< a ray
  int Pixels = 512;    ///< compared with the reference
  int Samples = 4096;  ///< of the reference for each of them
  std::string Rows;    ///< only those whose name and setting hold this
  RoomLamp Light;
};

struct RivalRow
{
  std::string Name;
  std::string Setting;
  double BuildSeconds = 0.0; ///< of the processor, all threads; cones: photons, vectors, cones and their hierarchy
  double Megabytes = 0.0;    ///< of what was built, 1e6 bytes
  double ImageSeconds = 0.0; ///< of the processor, with the unshadowed light
  bool Whole = false;        ///< the image is not the unshadowed light less what is blocked: no part of its time is that of others
  ImageError Error;
  std::string Fault; ///< why it has no figures
  std::vector<double> Image;
};

struct RivalFigures
{
  std::string Scene;
  double LitSeconds = 0.0; ///< of the unshadowed light, part of every ImageSeconds that are not Whole
  double ReferenceNoise = 0.0;
  double SmallestError = 0.0; ///< that the reference can tell from none
  vtkIdType Triangles = 0;
  vtkIdType Cones = 0;
  std::vector<RivalRow> Rows;
};

RivalFigures MeasureRivals(const std::string& nameOrFile, const RivalSetting& setting);

} // namespace shadowcones

#endif
