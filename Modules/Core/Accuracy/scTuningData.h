// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTuningData.h
 * @brief Photons split in two: vectors and paths to fit cones with, and paths held out to validate them by. Internal to Core.
 */
#ifndef scTuningData_h
#define scTuningData_h

#include "scBox.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"
#include "scVector3.h"

#include <string>
#include <vector>

namespace shadowcones
{

/// A ray along a held-out path: lit up to Stop, in shadow from there on.
struct HeldOutPath
{
  Vector3 Origin;
  Vector3 Direction;
  double Stop = HUGE_VAL; ///< HUGE_VAL where the path is lit to its end
  std::size_t Light = 0;
};

/// A piece of a held-out path, seen at its middle.
struct PathSample
{
  Vector3 Point;
  double Length = 0.0; ///< of the piece
  int Cell = 0;        ///< of a regular grid over the region of the samples
  bool Blocked = false;
  std::size_t Light = 0;
};

/**
 * A quarter of the photons is held out: those whose emission point and direction hash so, which a vector and a path of the
 * same photon have in common. At most 6,000 held-out paths are kept, evenly spread over the input.
 */
class TuningData
{
public:
  /// Cells along each side of the grid of the samples.
  static constexpr int CellsPerSide = 12;

  /// At most @p largestNumberOfVectors of the vectors, evenly spread, are kept, and as large a share of the other paths.
  TuningData(const ShadowVectorView& vectors, const PhotonPathView& paths, vtkIdType largestNumberOfVectors);

  /// Nothing, or what keeps the held-out paths from teaching anything: none is blocked or, where that is needed, none is lit.
  std::string Lacking(bool needLit) const;

  /// Vectors and paths of the photons that are not held out.
  ShadowVectorView Vectors() const;
  PhotonPathView Paths() const;

  /// Box around all paths, grown on each side by this share of its diagonal.
  Box Region(double margin) const;
  /// 8 pieces of each held-out path inside the box.
  std::vector<PathSample> SamplesIn(const Box& region) const;

  std::vector<HeldOutPath> HeldOut;

private:
  void AddVectors(const ShadowVectorView& vectors, vtkIdType stride);
  void AddPaths(const PhotonPathView& paths, vtkIdType stride);

  struct Rays
  {
    std::vector<double> Points;
    std::vector<float> Directions;
    std::vector<double> EmissionPoints;
    std::vector<int> Values; ///< occluders of vectors, states of paths
    std::vector<int> LightIds;
  };
  Rays FittedVectors;
  Rays FittedPaths;
  Box Bounds;
};

} // namespace shadowcones

#endif
