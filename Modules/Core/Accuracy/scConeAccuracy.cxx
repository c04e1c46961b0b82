// SPDX-License-Identifier: BSD-3-Clause
#include "scConeAccuracy.h"

#include <algorithm>
#include <map>

namespace shadowcones
{

int CountedOccluder(const SampleTruth& truth, const SamplePrediction& prediction, const std::vector<Cone>& cones)
{
  if (truth.Shadowed())
  {
    return truth.OccluderId;
  }
  return prediction.ConeId >= 0 ? cones[prediction.ConeId].OccluderId : -1;
}

double CountedDepth(const SampleTruth& truth, const SamplePrediction& prediction)
{
  if (prediction.ConeId >= 0)
  {
    return prediction.Height;
  }
  return truth.Shadowed() ? truth.OccluderDistance : -1.0;
}

AccuracyReport TallyAccuracy(const std::vector<SampleTruth>& truth, const std::vector<SamplePrediction>& predictions,
  const std::vector<Cone>& cones, int depthBins)
{
  AccuracyReport report;
  double largest = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    largest = std::max(largest, truth[k].Emitting > 0 ? CountedDepth(truth[k], predictions[k]) : 0.0);
  }
  report.Depths.resize(static_cast<std::size_t>(depthBins));
  for (int bin = 0; bin < depthBins; ++bin)
  {
    report.Depths[bin].Low = largest * bin / depthBins;
    report.Depths[bin].High = largest * (bin + 1) / depthBins;
  }

  std::map<int, OccluderTally> occluders;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    report.All.Add(truth[k], predictions[k]);
    if (truth[k].Shadowed() || predictions[k].Inside())
    {
      OccluderTally& occluder = occluders[CountedOccluder(truth[k], predictions[k], cones)];
      occluder.Add(truth[k], predictions[k]);
    }
    const double depth = CountedDepth(truth[k], predictions[k]);
    if (depth >= 0.0 && depthBins > 0)
    {
      const double bin = largest > 0.0 ? depth / largest * depthBins : 0.0;
      report.Depths[static_cast<std::size_t>(std::clamp(bin, 0.0, depthBins - 1.0))].Add(truth[k], predictions[k]);
    }
  }
  for (auto& [id, tally] : occluders)
  {
    tally.OccluderId = id;
    report.Occluders.push_back(tally);
  }
  return report;
}

} // namespace shadowcones
