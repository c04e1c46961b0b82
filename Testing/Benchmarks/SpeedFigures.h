// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpeedFigures.h
 * @brief What is measured on one scene in one run, and the comparisons at equal error that follow from it.
 */
#ifndef SpeedFigures_h
#define SpeedFigures_h

#include "ErrorCurve.h"
#include "ReferencePixels.h"
#include "TimedJobs.h"

#include "vtkType.h"

#include <string>
#include <vector>

namespace shadowcones
{

struct Stage
{
  std::string Name;
  JobTime Time;
  vtkIdType OcclusionRays = 0;
};

/// One mode with its knobs set.
struct ModeRow
{
  std::string Mode; ///< "BruteForce", "Stratified" (Guided without cones), "Guided", "Volume"
  std::string Knobs;
  bool Default = false;
  JobTime Frame;
  JobTime Fill; ///< Volume
  ImageError Error;
  vtkIdType FrameRays = 0;
  vtkIdType FillRays = 0;
};

/// One thread against as many as asked for.
struct ThreadsRow
{
  std::string Name;
  JobTime One;
  JobTime Many;
};

/// The march with the locator, on a share of the pixels.
struct LocatorFigures
{
  JobTime Build;
  JobTime March;
  JobTime EmbreeMarch; ///< the same march over the same pixels with Embree
  double Pixels = 0.0; ///< marched
  double OfPixels = 0.0;
  double Difference = 0.0;       ///< of the locator's values from BruteForce's, root of the mean square over the mean
  double EmbreeDifference = 0.0; ///< of all pixels marched with Embree from BruteForce's, the largest over the mean
  vtkIdType EmbreeRays = 0;      ///< of all pixels

  double SecondsOfImage(Clock clock) const { return this->March.By(clock) * this->OfPixels / this->Pixels; }
};

struct SpeedFigures
{
  std::string Scene;
  int Size = 0;
  int Threads = 0;
  vtkIdType Triangles = 0;
  vtkIdType Photons = 0;
  vtkIdType Vectors = 0;
  vtkIdType Cones = 0;
  double ReferenceNoise = 0.0;
  double SmallestError = 0.0; ///< that the reference can tell from none; smaller ones count as this
  std::vector<Stage> Stages;  ///< occluders, vectors, cones, hierarchy
  std::vector<ModeRow> Rows;
  LocatorFigures Locator;
  JobTime Unshadowed; ///< a frame of Volume with a grid in which nothing is marked
  std::vector<ThreadsRow> Threading;

  double StageSeconds(const std::string& name, Clock clock) const;
  const ModeRow& DefaultRow(const std::string& mode) const;
  /// Error against time of a mode; Volume with or without the time to fill its grid.
  std::vector<CurvePoint> Curve(const std::string& mode, Clock clock, bool withFill = false) const;
};

struct Comparison
{
  std::string Name;
  double Error = 0.0; ///< at which both are compared; 0: of no error
  std::string Ours;   ///< how the shorter time came about
  TimeAtError Time;
  TimeAtError Baseline;
  double Wanted = 0.0; ///< 0: no bound
  bool AtMost = false; ///< the bound is an upper one

  double Ratio() const { return this->Baseline.Seconds / this->Time.Seconds; }
  bool IsKnown() const { return this->Time.IsKnown() && this->Baseline.IsKnown(); }
  bool IsMet() const;
};

/// Processor time tells what a busy machine hides; rows on threads make no sense by it, and are left out.
std::vector<Comparison> CompareAtEqualError(const SpeedFigures& figures, Clock clock);

} // namespace shadowcones

#endif
