// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetAccuracy.h"

#include "scConeAccuracy.h"
#include "scConeProof.h"
#include "scConeProofCheck.h"
#include "scConeData.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGhosts.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scSceneLights.h"
#include "scWarnings.h"

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

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <numeric>

namespace
{
using namespace shadowcones;

constexpr int coneSetPort = 1;
constexpr int meshPort = 2;
constexpr int lightPort = 3;

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
    if (!IsFinite(points[k]))
    {
      error = "Sample point " + std::to_string(items[k]) + " on input port 0 has a coordinate that is not finite.";
      return false;
    }
  }
  return true;
}

/// The classes that another classifier gave to the points, one light after the other; none without an array "ShadowClass".
bool ReadShadowClasses(vtkDataSet* input, const std::vector<vtkIdType>& items, int lights,
  std::vector<SamplePrediction>& predictions, std::string& error)
{
  vtkDataArray* classes = input ? input->GetPointData()->GetArray("ShadowClass") : nullptr;
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
      if (value != 0.0 && value != 1.0 && value != 2.0)
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

/// The box that stands for bounds that are not set.
Box JointBounds(const Box& mesh, const Box& lights)
{
  Box box = lights;
  box.Add(mesh);
  return box;
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

/// One component a light; @p truth and @p predictions hold all of @p all points for one light after the other.
void WriteSamples(const std::vector<SampleTruth>& truth, const std::vector<SamplePrediction>& predictions,
  const std::vector<Cone>& cones, vtkIdType all, vtkIdType begin, vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  const auto lights = all > 0 ? static_cast<int>(static_cast<vtkIdType>(truth.size()) / all) : 1;
  std::vector<unsigned char> classes, confusions;
  std::vector<float> visible, depths;
  std::vector<int> occluderIds;
  std::vector<vtkIdType> coneIds;
  for (vtkIdType i = begin; i < begin + count; ++i)
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

/// A closed box around each occluder.
TriangleMesh BoxesAround(const TriangleMesh& mesh)
{
  std::map<int, Box> boxes;
  const TriangleMeshView view = mesh.View();
  for (vtkIdType i = 0; i < 3 * view.NumberOfTriangles; ++i)
  {
    boxes[view.OccluderId(i / 3)].Add(view.Corner(i / 3, static_cast<int>(i % 3)));
  }
  TriangleMesh result;
  constexpr int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } };
  for (const auto& one : boxes)
  {
    const auto first = static_cast<vtkIdType>(result.Points.size() / 3);
    const Box& b = one.second;
    for (int i = 0; i < 8; ++i)
    {
      result.Points.insert(result.Points.end(),
        { i & 1 ? b.Max.X : b.Min.X, i & 2 ? b.Max.Y : b.Min.Y, i & 4 ? b.Max.Z : b.Min.Z });
    }
    for (const auto& f : faces)
    {
      result.Triangles.insert(
        result.Triangles.end(), { first + f[0], first + f[1], first + f[2], first + f[0], first + f[2], first + f[3] });
      result.OccluderIds.insert(result.OccluderIds.end(), 2, one.first);
    }
  }
  return result;
}

/// What else bounds the shadow: cones around parts of the mesh without photons, and each occluder's box swept along the light.
struct OtherBounds
{
  vtkIdType Clusters = -1; ///< number of cones; -1: not measured
  AccuracyTally OfClusters;
  AccuracyTally OfBoxes;
};

/// @return false where aborted.
bool MeasureOthers(const TriangleMesh& mesh, const std::vector<Light>& lights, const std::vector<Vector3>& points,
  const std::vector<SampleTruth>& truth, int lightSamples, std::uint64_t seed, const Monitor& monitor, OtherBounds& others)
{
  ConeProof parts;
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  if (!ProveConeSet(mesh.View(), lights, {}, {}, monitor.Part(0.0, 0.3), parts) ||
    !ClassifyByCones(lights.size(), points, truth, parts.Cones, monitor.Part(0.3, 0.5), predictions, tallies))
  {
    return false;
  }
  others.Clusters = static_cast<vtkIdType>(parts.Cones.size());
  others.OfClusters = TallyAccuracy(truth, predictions, parts.Cones, 0).All;
  const TriangleMesh boxes = BoxesAround(mesh);
  const OccluderScene scene(boxes.View());
  std::vector<SampleTruth> swept;
  if (!MeasureTruth(points, scene, lights, lightSamples, seed, monitor.Part(0.5, 1.0), swept))
  {
    return false;
  }
  predictions.assign(swept.size(), {});
  for (std::size_t i = 0; i < swept.size(); ++i)
  {
    predictions[i].Class = swept[i].Umbra() ? 2 : swept[i].Shadowed() ? 1 : 0;
  }
  others.OfBoxes = TallyAccuracy(truth, predictions, {}, 0).All;
  return true;
}

/// Has each light cones of its own that the independent check finds proved? @return false where aborted.
bool IsProved(const TriangleMesh& mesh, const std::vector<Light>& lights, const std::vector<Cone>& cones, const Box& held,
  const Monitor& monitor, bool& proved)
{
  const std::vector<std::vector<Cone>> own = ConesOfLights(cones, lights.size());
  proved = true;
  for (std::size_t k = 0; k < lights.size() && proved; ++k)
  {
    const double share = 1.0 / static_cast<double>(lights.size());
    const double begin = static_cast<double>(k) * share;
    ConeProofCheck check;
    if (!CheckConeProof(mesh.View(), lights[k], own[k], held, monitor.Part(begin, begin + share), check))
    {
      return false;
    }
    proved = check.Proved;
  }
  return true;
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

void vtkConeSetAccuracy::AddLightConnection(vtkAlgorithmOutput* light)
{
  this->AddInputConnection(lightPort, light);
}

void vtkConeSetAccuracy::AddLightData(vtkDataObject* light)
{
  this->AddInputDataInternal(lightPort, light);
}

void vtkConeSetAccuracy::RemoveAllLights()
{
  this->RemoveAllInputConnections(lightPort);
}

int vtkConeSetAccuracy::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == lightPort)
  {
    FillLightPortInformation(info);
    return 1;
  }
  if (port == meshPort)
  {
    AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  }
  // What is missing is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkConeSetAccuracy::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 || port == 4 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkConeSetAccuracy::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
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
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  vtkDataSet* sampleInput = vtkDataSet::GetData(inputVector[0]);
  vtkPolyData* coneInput = vtkPolyData::GetData(inputVector[coneSetPort]);
  vtkDataObject* meshInput = vtkDataObject::GetData(inputVector[meshPort]);
  if (!coneInput || !meshInput || inputVector[lightPort]->GetNumberOfInformationObjects() == 0)
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
  SceneLights lights;
  std::vector<Vector3> points;
  std::vector<SamplePrediction> given;
  const std::vector<vtkIdType> items = sampleInput ? VisiblePoints(sampleInput) : std::vector<vtkIdType>();
  if (!this->CheckParameters())
  {
    return 0;
  }
  if (!ReadConeSet(coneInput, cones, error) || !ReadTriangles(meshInput, mesh, error) ||
    !ReadLights(inputVector[lightPort], lights, error) || (sampleInput && !ReadPoints(sampleInput, items, points, error)) ||
    !ReadShadowClasses(sampleInput, items, static_cast<int>(lights.Lights.size()), given, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  const Box meshBounds = MeshBounds(mesh.View());
  const std::uint64_t fingerprint = CastersFingerprintOf(mesh);
  const std::string mismatch = CompareFingerprints(castersFingerprint, coneInput->GetFieldData(), { fingerprint },
    "The cone set on input port 1", "casters than those of the mesh on input port 2");
  if (!mismatch.empty())
  {
    vtkWarningMacro(<< mismatch);
  }
  DropReceivers(mesh);
  AssignCones(coneInput, lights, cones);
  if (static_cast<vtkIdType>(cones.size()) != coneInput->GetNumberOfPoints())
  {
    vtkErrorMacro("The cone set has no \"LightId\" and " << lights.Lights.size()
      << " lights are connected: accuracy is that of each light's own cones. Make them with vtkShadowVectorFilter and "
         "vtkConeSetFilter from all of the lights.");
    return 0;
  }
  for (const std::string& warning : lights.Warnings)
  {
    vtkWarningMacro(<< warning);
  }

  const double* b = this->Bounds;
  const Box bounds =
    b[0] <= b[1] ? Box{ { b[0], b[2], b[4] }, { b[1], b[3], b[5] } } : JointBounds(meshBounds, lights.Bounds);
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  std::vector<SampleTruth> truth;
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  bool proved = false;
  OtherBounds others;
  const Monitor monitor = MonitorOf(this);
  try
  {
    const OccluderScene scene(mesh.View());
    if ((!sampleInput &&
          !DrawSamplePoints(bounds, this->NumberOfSamples, seed, monitor.Part(0.0, 0.02), points)) ||
      !MeasureTruth(points, scene, lights.Lights, this->NumberOfLightSamples, seed, monitor.Part(0.02, 0.8), truth) ||
      !ClassifyByCones(lights.Lights.size(), points, truth, cones, monitor.Part(0.8, 0.85), predictions, tallies) ||
      (this->CompareBounds &&
        !MeasureOthers(
          mesh, lights.Lights, points, truth, this->NumberOfLightSamples, seed, monitor.Part(0.85, 0.95), others)) ||
      !IsProved(mesh, lights.Lights, cones, ReadCertifiedBounds(coneInput->GetFieldData()),
        monitor.Part(this->CompareBounds ? 0.95 : 0.85, 1.0), proved))
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
  WriteVertices(points, sampleInput, items, piece.Begin(count), piece.End(count), sampleOutput);
  WriteSamples(truth, predictions, cones, count, piece.Begin(count), sampleOutput);
  WriteLightFingerprints(lights.Lights, sampleOutput);
  if (piece.Piece == 0)
  {
    const auto inShadow = static_cast<vtkIdType>(report.All.TruePositives + report.All.FalseNegatives);
    Warnings warnings;
    warnings.Add(NoPlaceInShadow("samples", count, inShadow, static_cast<vtkIdType>(cones.size())));
    warnings.Add(NoPlaceLit("samples", count, count - static_cast<vtkIdType>(report.All.Umbra)));
    warnings.Add(TooManyDiscarded(coneInput->GetFieldData()));
    warnings.Say(this);
    WriteSummary(report.All, truth, given, proved, others, vtkTable::GetData(outputVector, 1));
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
  std::vector<vtkIdType> coneItems(cones.size());
  std::iota(coneItems.begin(), coneItems.end(), vtkIdType(0));
  WriteVertices(centers, coneInput, coneItems, piece.Begin(coneCount), piece.End(coneCount), coneOutput);
  WriteCones(tallies, report.All, piece.Begin(coneCount), coneOutput);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkFieldData* field = vtkDataObject::GetData(outputVector, port)->GetFieldData();
    WriteOccluderNames(mesh.OccluderNames, field);
    WriteFingerprints(castersFingerprint, { fingerprint }, field);
  }
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
  os << indent << "CompareBounds: " << (this->CompareBounds ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
