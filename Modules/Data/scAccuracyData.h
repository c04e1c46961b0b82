// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scAccuracyData.h
 * @brief The samples of an accuracy measurement, and its tables.
 */
#ifndef scAccuracyData_h
#define scAccuracyData_h

#include "ShadowConesDataModule.h"
#include "scAccuracyTally.h"
#include "scConeAccuracy.h"
#include "scConeTally.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;
class vtkTable;

namespace shadowcones
{

/// Samples that are given as the points of a data set, but for those that are hidden.
struct SHADOWCONESDATA_EXPORT AccuracySamples
{
  vtkDataSet* Input = nullptr;  ///< nullptr: none are given
  std::vector<vtkIdType> Items; ///< the point of the input of each sample
  std::vector<Vector3> Points;
  std::vector<SamplePrediction> Classes; ///< of another classifier, one light after the other; empty: it gave none
};

/**
 * Read samples and their optional point array "ShadowClass". @return false, with a sentence in @p error that names the point that
 * is not finite or has no valid class, or the array's wrong size.
 */
SHADOWCONESDATA_EXPORT bool ReadSamples(
  vtkDataSet* input, std::size_t lights, AccuracySamples& samples, std::string& error);

/// What else bounds the shadow: cones around parts of the mesh without photons, and each occluder's box swept along the light.
struct OtherBounds
{
  vtkIdType Clusters = -1; ///< number of cones; -1: not measured
  AccuracyTally OfClusters;
  AccuracyTally OfBoxes;
};

/// Samples [begin, end) with what the input has for them: "Truth", "Prediction", "Confusion" and more, one component a light.
SHADOWCONESDATA_EXPORT void WriteSamples(const AccuracySamples& samples, const std::vector<SampleTruth>& truth,
  const std::vector<SamplePrediction>& predictions, const std::vector<Cone>& cones, vtkIdType begin, vtkIdType end,
  vtkPolyData* output);
/// Rows "Quantity", "Value", "Low", "High".
SHADOWCONESDATA_EXPORT void WriteSummary(const AccuracyTally& all, const std::vector<SampleTruth>& truth,
  const std::vector<SamplePrediction>& given, bool proved, const OtherBounds& others, vtkTable* output);
SHADOWCONESDATA_EXPORT void WriteOccluders(const AccuracyReport& report, vtkTable* output);
SHADOWCONESDATA_EXPORT void WriteDepths(const AccuracyReport& report, vtkTable* output);
/// Cones [begin, end) of @p input with its arrays, and what each of them is worth.
SHADOWCONESDATA_EXPORT void WriteConeTallies(const std::vector<Cone>& cones, vtkPolyData* input,
  const std::vector<ConeTally>& tallies, const AccuracyTally& all, vtkIdType begin, vtkIdType end, vtkPolyData* output);

} // namespace shadowcones

#endif
