// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetAccuracy.h"

#include "scConeAccuracy.h"
#include "scConeData.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOptionalBounds.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace
{
using namespace shadowcones;

constexpr int coneSetPort = 1;
constexpr int meshPort = 2;
constexpr int lightPort = 3;

/// The points of a data set. @return false, with a sentence in @p error, where one is not finite.
bool ReadPoints(vtkDataSet* input, std::vector<Vector3>& points, std::string& error)
{
  points.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    double p[3];
    input->GetPoint(static_cast<vtkIdType>(k), p);
    points[k] = { p[0], p[1], p[2] };
    if (!IsFinite(points[k]))
    {
      error = "Sample point " + std::to_string(k) + " on input port 0 has a coordinate that is not finite.";
      return false;
    }
  }
  return true;
}

/// The classes that another classifier gave to the points; none without an array "ShadowClass".
bool ReadShadowClasses(vtkDataSet* input, std::vector<SamplePrediction>& predictions, std::string& error)
{
  vtkDataArray* classes = input ? input->GetPointData()->GetArray("ShadowClass") : nullptr;
  if (!classes)
  {
    return true;
  }
  if (classes->GetNumberOfComponents() != 1 || classes->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    error = "The point array \"ShadowClass\" on input port 0 must have one component and one value a point.";
    return false;
  }
  predictions.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t k = 0; k < predictions.size(); ++k)
  {
    const double value = classes->GetComponent(static_cast<vtkIdType>(k), 0);
    if (value != 0.0 && value != 1.0 && value != 2.0)
    {
      error = "The point array \"ShadowClass\" on input port 0 holds a value that is not 0, 1 or 2 at point " +
        std::to_string(k) + ".";
      return false;
    }
    predictions[k].Class = static_cast<unsigned char>(value);
  }
  return true;
}

/// The box that stands for bounds that are not set.
Box JointBounds(vtkPolyData* mesh, vtkPolyData* lightData, const Light& light)
{
  Box box;
  for (vtkPolyData* data : { mesh, IsAtInfinity(light) ? nullptr : lightData })
  {
    if (data && data->GetNumberOfPoints() > 0)
    {
      const double* b = data->GetBounds();
      box.Add(Vector3{ b[0], b[2], b[4] });
      box.Add(Vector3{ b[1], b[3], b[5] });
    }
  }
  return box;
}

/// The vertices [begin, end) of some points, with the arrays that the input has for them.
void WriteVertices(
  const std::vector<Vector3>& points, vtkDataSet* input, vtkIdType begin, vtkIdType end, vtkPolyData* output)
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
    data->CopyAllocate(input->GetPointData(), end - begin);
    data->CopyData(input->GetPointData(), 0, end - begin, begin);
    output->GetFieldData()->PassData(input->GetFieldData());
  }
}

void WriteSamples(const std::vector<SampleTruth>& truth, const std::vector<SamplePrediction>& predictions,
  const std::vector<Cone>& cones, vtkIdType begin, vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> prediction;
  vtkNew<vtkUnsignedCharArray> confusion;
  prediction->SetName("Prediction");
  confusion->SetName("Confusion");
  prediction->SetNumberOfTuples(count);
  confusion->SetNumberOfTuples(count);
  std::vector<float> visible, depths;
  std::vector<int> occluderIds;
  std::vector<vtkIdType> coneIds;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const SampleTruth& t = truth[begin + i];
    const SamplePrediction& p = predictions[begin + i];
    visible.push_back(static_cast<float>(t.Visibility()));
    prediction->SetValue(i, p.Class);
    confusion->SetValue(i, t.Shadowed() ? (p.Inside() ? 1 : 3) : (p.Inside() ? 2 : 0));
    coneIds.push_back(p.ConeId);
    occluderIds.push_back(CountedOccluder(t, p, cones));
    depths.push_back(static_cast<float>(CountedDepth(t, p)));
  }
  vtkPointData* data = output->GetPointData();
  AddFloatArray(data, "Truth", 1, visible);
  data->AddArray(prediction);
  data->AddArray(confusion);
  AddIdArray(data, "ConeId", coneIds);
  AddIntArray(data, "OccluderId", 1, occluderIds);
  AddFloatArray(data, "Depth", 1, depths);
  data->SetActiveScalars("Confusion");
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

void WriteSummary(const AccuracyTally& all, const std::vector<SampleTruth>& truth,
  const std::vector<SamplePrediction>& given, vtkTable* output)
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

void WriteCones(const std::vector<ConeTally>& tallies, const AccuracyTally& all, vtkIdType begin, vtkPolyData* output)
{
  std::vector<vtkIdType> counts;
  std::vector<float> precisions, lows, highs, lost;
  for (vtkIdType i = begin; i < begin + output->GetNumberOfPoints(); ++i)
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
} // anonymous namespace

vtkStandardNewMacro(vtkConeSetAccuracy);

vtkConeSetAccuracy::vtkConeSetAccuracy()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(5);
}

void vtkConeSetAccuracy::SetConeSetConnection(vtkAlgorithmOutput* coneSet)
{
  this->SetInputConnection(coneSetPort, coneSet);
}

void vtkConeSetAccuracy::SetConeSetData(vtkDataObject* coneSet)
{
  this->SetInputData(coneSetPort, coneSet);
}

void vtkConeSetAccuracy::SetMeshConnection(vtkAlgorithmOutput* mesh)
{
  this->SetInputConnection(meshPort, mesh);
}

void vtkConeSetAccuracy::SetMeshData(vtkDataObject* mesh)
{
  this->SetInputData(meshPort, mesh);
}

void vtkConeSetAccuracy::SetLightConnection(vtkAlgorithmOutput* light)
{
  this->SetInputConnection(lightPort, light);
}

void vtkConeSetAccuracy::SetLightData(vtkDataObject* light)
{
  this->SetInputData(lightPort, light);
}

int vtkConeSetAccuracy::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  // What is missing is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkConeSetAccuracy::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 || port == 4 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkConeSetAccuracy::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  HandlePieces(outputVector);
  return 1;
}

int vtkConeSetAccuracy::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  RequestWholeInputs(this, inputVector);
  return 1;
}

bool vtkConeSetAccuracy::CheckParameters()
{
  if (this->NumberOfSamples < 0 || this->NumberOfSamples > 1000000000)
  {
    vtkErrorMacro("NumberOfSamples is " << this->NumberOfSamples << "; it must be 0 to 1000000000.");
    return false;
  }
  if (this->NumberOfLightSamples < 1 || this->NumberOfLightSamples > 65536)
  {
    vtkErrorMacro("NumberOfLightSamples is " << this->NumberOfLightSamples << "; it must be 1 to 65536.");
    return false;
  }
  if (this->NumberOfDepthBins < 1 || this->NumberOfDepthBins > 100000)
  {
    vtkErrorMacro("NumberOfDepthBins is " << this->NumberOfDepthBins << "; it must be 1 to 100000.");
    return false;
  }
  const double* b = this->Bounds;
  const bool isSet = !AreUnsetBounds(b);
  for (int axis = 0; isSet && axis < 3; ++axis)
  {
    if (!std::isfinite(b[2 * axis]) || !std::isfinite(b[2 * axis + 1]) || b[2 * axis] > b[2 * axis + 1])
    {
      vtkErrorMacro("Bounds along "
        << "xyz"[axis] << " run from " << b[2 * axis] << " to " << b[2 * axis + 1]
        << ": they must be finite and in ascending order.");
      return false;
    }
  }
  return true;
}

int vtkConeSetAccuracy::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* sampleInput = vtkDataSet::GetData(inputVector[0]);
  vtkPolyData* coneInput = vtkPolyData::GetData(inputVector[coneSetPort]);
  vtkPolyData* meshInput = vtkPolyData::GetData(inputVector[meshPort]);
  vtkPolyData* lightInput = vtkPolyData::GetData(inputVector[lightPort]);
  if (!coneInput || !meshInput || !lightInput)
  {
    vtkErrorMacro(
      << (!coneInput ? "No cone set on input port 1: connect a vtkConeSetFilter with SetConeSetConnection."
             : !meshInput
             ? "No mesh on input port 2: connect a vtkLabelOccluders with SetMeshConnection."
             : "No light on input port 3: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection."));
    return 0;
  }

  std::vector<Cone> cones;
  TriangleMesh mesh;
  Light light;
  std::vector<Vector3> points;
  std::vector<SamplePrediction> given;
  std::string error;
  if (!this->CheckParameters())
  {
    return 0;
  }
  if (!ReadConeSet(coneInput, cones, error) || !ReadTriangles(meshInput, mesh, error) ||
    !ReadLight(lightInput, light, error) || (sampleInput && !ReadPoints(sampleInput, points, error)) ||
    !ReadShadowClasses(sampleInput, given, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  DropReceivers(mesh);

  const double* b = this->Bounds;
  const Box bounds =
    b[0] <= b[1] ? Box{ { b[0], b[2], b[4] }, { b[1], b[3], b[5] } } : JointBounds(meshInput, lightInput, light);
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  std::vector<SampleTruth> truth;
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  try
  {
    const OccluderScene scene(mesh.View());
    if ((!sampleInput &&
          !DrawSamplePoints(bounds, this->NumberOfSamples, seed, MonitorOf(this).Part(0.0, 0.02), points)) ||
      !MeasureTruth(points, scene, light, this->NumberOfLightSamples, seed, MonitorOf(this).Part(0.02, 0.9), truth) ||
      !ClassifyByCones(points, truth, cones, MonitorOf(this).Part(0.9, 1.0), predictions, tallies))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Measuring the accuracy failed: " << exception.what());
    return 0;
  }

  const AccuracyReport report = TallyAccuracy(truth, predictions, cones, this->NumberOfDepthBins);
  const PieceRequest piece = RequestedPiece(request, outputVector);
  const auto count = static_cast<vtkIdType>(points.size());
  vtkPolyData* sampleOutput = vtkPolyData::GetData(outputVector, 0);
  WriteVertices(points, sampleInput, piece.Begin(count), piece.End(count), sampleOutput);
  WriteSamples(truth, predictions, cones, piece.Begin(count), sampleOutput);
  if (piece.Piece == 0)
  {
    WriteSummary(report.All, truth, given, vtkTable::GetData(outputVector, 1));
    WriteOccluders(report, vtkTable::GetData(outputVector, 2));
    WriteDepths(report, vtkTable::GetData(outputVector, 3));
  }
  std::vector<Vector3> centers;
  for (const Cone& cone : cones)
  {
    centers.push_back(cone.Center);
  }
  const auto coneCount = static_cast<vtkIdType>(cones.size());
  vtkPolyData* coneOutput = vtkPolyData::GetData(outputVector, 4);
  WriteVertices(centers, coneInput, piece.Begin(coneCount), piece.End(coneCount), coneOutput);
  WriteCones(tallies, report.All, piece.Begin(coneCount), coneOutput);
  return 1;
}

void vtkConeSetAccuracy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << ", " << this->Bounds[1] << ", " << this->Bounds[2] << ", "
     << this->Bounds[3] << ", " << this->Bounds[4] << ", " << this->Bounds[5] << "\n";
  os << indent << "NumberOfDepthBins: " << this->NumberOfDepthBins << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
