// SPDX-License-Identifier: BSD-3-Clause
#include "scAccuracyData.h"

#include "scFieldArrays.h"
#include "scGhosts.h"
#include "scSentence.h"
#include "scShadowClass.h"
#include "scTuples.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <numeric>

namespace shadowcones
{

namespace
{

/// The points of a data set that are not hidden.
std::vector<vtkIdType> VisiblePoints(vtkDataSet* input)
{
  std::vector<vtkIdType> items;
  const Ghosts ghosts(input->GetPointData());
  for (vtkIdType id = 0; id < input->GetNumberOfPoints(); ++id)
  {
    if (!ghosts.IsPointHidden(id))
    {
      items.push_back(id);
    }
  }
  return items;
}

/// These points of a data set. @return false, with a sentence in @p error, where one is not finite.
bool ReadPoints(
  vtkDataSet* input, const std::vector<vtkIdType>& items, std::vector<Vector3>& points, std::string& error)
{
  points.resize(items.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    double p[3];
    input->GetPoint(items[k], p);
    points[k] = { p[0], p[1], p[2] };
    if (const char* fault = FaultOf(points[k]))
    {
      error = Sentence("Sample point ", items[k], " on input port 0 has a coordinate that ", fault, ".");
      return false;
    }
  }
  return true;
}

/// The classes that another classifier gave to the points, one light after the other; none without an array "ShadowClass".
bool ReadShadowClasses(vtkDataSet* input, const std::vector<vtkIdType>& items, int lights,
  std::vector<SamplePrediction>& predictions, std::string& error)
{
  vtkDataArray* classes = input->GetPointData()->GetArray("ShadowClass");
  if (!classes)
  {
    return true;
  }
  if (classes->GetNumberOfComponents() != lights || classes->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    error = "The point array \"ShadowClass\" on input port 0 must have one component a light and one tuple a point.";
    return false;
  }
  for (int light = 0; light < lights; ++light)
  {
    for (const vtkIdType k : items)
    {
      const double value = classes->GetComponent(k, light);
      if (!IsShadowClass(value))
      {
        error = "The point array \"ShadowClass\" on input port 0 holds a value that is not 0, 1 or 2 at point " +
          std::to_string(k) + ".";
        return false;
      }
      predictions.emplace_back();
      predictions.back().Class = static_cast<unsigned char>(value);
    }
  }
  return true;
}

/// The vertices [begin, end) of some points, with the arrays that the input has for them: for those of @p items.
void WriteVertices(const std::vector<Vector3>& points, vtkDataSet* input, const std::vector<vtkIdType>& items,
  vtkIdType begin, vtkIdType end, vtkPolyData* output)
{
  std::vector<double> coordinates;
  coordinates.reserve(static_cast<std::size_t>(3 * (end - begin)));
  for (vtkIdType k = begin; k < end; ++k)
  {
    coordinates.insert(coordinates.end(), { points[k].X, points[k].Y, points[k].Z });
  }
  SetVertices(output, coordinates);
  if (input)
  {
    vtkPointData* data = output->GetPointData();
    data->CopyAllOn();
    data->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
    data->CopyAllocate(input->GetPointData(), end - begin);
    for (vtkIdType k = begin; k < end; ++k)
    {
      data->CopyData(input->GetPointData(), items[static_cast<std::size_t>(k)], k - begin);
    }
    output->GetFieldData()->PassData(input->GetFieldData());
  }
}

/// Rows of a quantity and its confidence interval.
class SummaryTable
{
public:
  SummaryTable() { this->Names->SetName("Quantity"); }
  void Add(const std::string& name, const Estimate& estimate)
  {
    this->Names->InsertNextValue(name);
    this->Values.push_back(estimate.Value);
    this->Lows.push_back(estimate.Low);
    this->Highs.push_back(estimate.High);
  }
  void Finish(vtkTable* output)
  {
    output->GetRowData()->AddArray(this->Names);
    AddDoubleArray(output->GetRowData(), "Value", 1, this->Values);
    AddDoubleArray(output->GetRowData(), "Low", 1, this->Lows);
    AddDoubleArray(output->GetRowData(), "High", 1, this->Highs);
  }

private:
  vtkNew<vtkStringArray> Names;
  std::vector<double> Values, Lows, Highs;
};

/// A value that is known.
Estimate Known(double value)
{
  return { value, value, value };
}

/// The columns that the tables by occluder and along the depth share.
template <class Tally>
void WriteQuantities(const std::vector<Tally>& rows, const AccuracyTally& all, vtkTable* output)
{
  std::vector<vtkIdType> counts;
  for (const Tally& row : rows)
  {
    counts.push_back(row.Samples());
  }
  AddIdArray(output->GetRowData(), "SampleCount", counts);
  const auto add = [&](const std::string& name, auto&& estimate)
  {
    std::vector<double> values, lows, highs;
    for (const Tally& row : rows)
    {
      const Estimate e = estimate(row);
      values.push_back(e.Value);
      lows.push_back(e.Low);
      highs.push_back(e.High);
    }
    AddDoubleArray(output->GetRowData(), name.c_str(), 1, values);
    AddDoubleArray(output->GetRowData(), (name + "Low").c_str(), 1, lows);
    AddDoubleArray(output->GetRowData(), (name + "High").c_str(), 1, highs);
  };
  add("Recall", [](const Tally& row) { return row.Recall(); });
  add("Precision", [](const Tally& row) { return row.Precision(); });
  add("IoU", [](const Tally& row) { return row.IoU(); });
  add("Leak", [](const Tally& row) { return row.Leak(); });
  add("Lost", [&](const Tally& row) { return row.AccuracyTally::Lost(all); });
}

} // namespace

bool ReadSamples(vtkDataSet* input, std::size_t lights, AccuracySamples& samples, std::string& error)
{
  samples.Input = input;
  samples.Items = VisiblePoints(input);
  return ReadPoints(input, samples.Items, samples.Points, error) &&
    ReadShadowClasses(input, samples.Items, static_cast<int>(lights), samples.Classes, error);
}

void WriteSamples(const AccuracySamples& samples, const std::vector<SampleTruth>& truth,
  const std::vector<SamplePrediction>& predictions, const std::vector<Cone>& cones, vtkIdType begin, vtkIdType end,
  vtkPolyData* output)
{
  WriteVertices(samples.Points, samples.Input, samples.Items, begin, end, output);
  const auto all = static_cast<vtkIdType>(samples.Points.size());
  const auto lights = all > 0 ? static_cast<int>(static_cast<vtkIdType>(truth.size()) / all) : 1;
  std::vector<unsigned char> classes, confusions;
  std::vector<float> visible, depths;
  std::vector<int> occluderIds;
  std::vector<vtkIdType> coneIds;
  for (vtkIdType i = begin; i < end; ++i)
  {
    for (vtkIdType light = 0; light < lights; ++light)
    {
      const SampleTruth& t = truth[light * all + i];
      const SamplePrediction& p = predictions[light * all + i];
      visible.push_back(static_cast<float>(t.Visibility()));
      classes.push_back(p.Class);
      confusions.push_back(t.Shadowed() ? (p.Inside() ? 1 : 3) : (p.Inside() ? 2 : 0));
      coneIds.push_back(p.ConeId);
      occluderIds.push_back(CountedOccluder(t, p, cones));
      depths.push_back(static_cast<float>(CountedDepth(t, p)));
    }
  }
  vtkPointData* data = output->GetPointData();
  AddFloatArray(data, "Truth", lights, visible);
  AddByteArray(data, "Prediction", classes, lights);
  AddByteArray(data, "Confusion", confusions, lights);
  AddIdArray(data, "ConeId", coneIds, lights);
  AddIntArray(data, "OccluderId", lights, occluderIds);
  AddFloatArray(data, "Depth", lights, depths);
  data->SetActiveScalars("Confusion");
}

void WriteSummary(const AccuracyTally& all, const std::vector<SampleTruth>& truth,
  const std::vector<SamplePrediction>& given, bool proved, const OtherBounds& others, vtkTable* output)
{
  SummaryTable table;
  table.Add("Recall", all.Recall());
  table.Add("Precision", all.Precision());
  table.Add("IoU", all.IoU());
  table.Add("Leak", all.Leak());
  table.Add("Lost", all.Lost());
  table.Add("LightPrecision", all.LightPrecision());
  table.Add("VolumeError", all.VolumeError());
  table.Add("UmbraPrecision", all.UmbraPrecision());
  table.Add("UmbraRecall", all.UmbraRecall());
  table.Add("Certified", Known(proved ? 1.0 : 0.0));
  if (others.Clusters >= 0)
  {
    table.Add("ClusterCones", Known(static_cast<double>(others.Clusters)));
    table.Add("ClusterPrecision", others.OfClusters.Precision());
    table.Add("ClusterRecall", others.OfClusters.Recall());
    table.Add("SweptBoxPrecision", others.OfBoxes.Precision());
    table.Add("SweptBoxRecall", others.OfBoxes.Recall());
  }
  if (!given.empty())
  {
    const AccuracyTally other = TallyAccuracy(truth, given, {}, 0).All;
    table.Add("ShadowClassRecall", other.Recall());
    table.Add("ShadowClassPrecision", other.Precision());
    table.Add("ShadowClassIoU", other.IoU());
    table.Add("ShadowClassUmbraPrecision", other.UmbraPrecision());
    table.Add("ShadowClassUmbraRecall", other.UmbraRecall());
  }
  table.Finish(output);
}

void WriteOccluders(const AccuracyReport& report, vtkTable* output)
{
  std::vector<int> ids;
  for (const OccluderTally& row : report.Occluders)
  {
    ids.push_back(row.OccluderId);
  }
  AddIntArray(output->GetRowData(), "OccluderId", 1, ids);
  WriteQuantities(report.Occluders, report.All, output);
}

void WriteDepths(const AccuracyReport& report, vtkTable* output)
{
  std::vector<double> lows, highs;
  for (const DepthTally& row : report.Depths)
  {
    lows.push_back(row.Low);
    highs.push_back(row.High);
  }
  AddDoubleArray(output->GetRowData(), "DepthMin", 1, lows);
  AddDoubleArray(output->GetRowData(), "DepthMax", 1, highs);
  WriteQuantities(report.Depths, report.All, output);
}

void WriteConeTallies(const std::vector<Cone>& cones, vtkPolyData* input, const std::vector<ConeTally>& tallies,
  const AccuracyTally& all, vtkIdType begin, vtkIdType end, vtkPolyData* output)
{
  std::vector<Vector3> centers;
  for (const Cone& cone : cones)
  {
    centers.push_back(cone.Center);
  }
  std::vector<vtkIdType> items(cones.size());
  std::iota(items.begin(), items.end(), vtkIdType(0));
  WriteVertices(centers, input, items, begin, end, output);
  std::vector<vtkIdType> counts;
  std::vector<float> precisions, lows, highs, lost;
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Estimate precision = tallies[i].Precision();
    counts.push_back(tallies[i].Samples);
    precisions.push_back(static_cast<float>(precision.Value));
    lows.push_back(static_cast<float>(precision.Low));
    highs.push_back(static_cast<float>(precision.High));
    lost.push_back(static_cast<float>(tallies[i].Lost(all)));
  }
  vtkPointData* data = output->GetPointData();
  AddIdArray(data, "SampleCount", counts);
  AddFloatArray(data, "Precision", 1, precisions);
  AddFloatArray(data, "PrecisionLow", 1, lows);
  AddFloatArray(data, "PrecisionHigh", 1, highs);
  AddFloatArray(data, "Lost", 1, lost);
}

} // namespace shadowcones
