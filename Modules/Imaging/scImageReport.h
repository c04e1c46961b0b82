// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageReport.h
 * @brief What a rendered image says of itself: numbers for the filter's warnings. Internal to Imaging.
 */
#ifndef scImageReport_h
#define scImageReport_h

#include "scImageScene.h"

#include "vtkType.h"

namespace shadowcones
{

struct PixelCounts
{
  vtkIdType Pixels = 0;
  vtkIdType Bright = 0;   ///< with light of any kind
  vtkIdType InMedium = 0; ///< whose ray loses light in the medium
  vtkIdType Missed = 0;   ///< Guided: sampling ended above the error goal
  double WorstError = 0.0; ///< of those
};
PixelCounts CountPixels(const ScatteringImage& image, const ScatteringOptions& options);

/// Triangles that cast shadows.
vtkIdType CountCasters(const TriangleMesh& mesh);

/// Does any light get lost in the medium?
bool Attenuates(const Medium& medium);

/// The share of a box that lies outside a visibility volume, 0..1; 0 for a flat box.
double ShareBeyond(const Box& box, const VisibilityGrid& grid);

} // namespace shadowcones

#endif
