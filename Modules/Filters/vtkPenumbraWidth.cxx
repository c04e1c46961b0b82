// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraWidth.h"

#include "scCellPoints.h"
#include "scConeData.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scParameterRanges.h"
#include "scPenumbraRuler.h"
#include "scProbePoints.h"
#include "scSentence.h"
#include "scShadowScene.h"
#include "scTeam.h"
#include "scWarnings.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

using namespace shadowcones;

vtkStandardNewMacro(vtkPenumbraWidth);
scDefineGuardedRequests(vtkPenumbraWidth);

namespace
{
constexpr int lightPort = 1;
constexpr int meshPort = 2;
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

Vector3 VectorAt(const std::vector<double>& values, std::size_t index)
{
  return { values[3 * index], values[3 * index + 1], values[3 * index + 2] };
}

/// A polyline of the input, by its cell and its points.
struct InputLine
{
  vtkIdType Cell;
  std::vector<vtkIdType> Ids;
  std::vector<Vector3> Points;
};

std::vector<InputLine> ReadLines(vtkPolyData* data)
{
  std::vector<InputLine> lines;
  vtkNew<vtkIdList> ids;
  vtkIdType cell = data->GetNumberOfVerts();
  vtkCellArray* cells = data->GetLines();
  for (cells->InitTraversal(); cells->GetNextCell(ids); ++cell)
  {
    lines.push_back({ cell, { ids->begin(), ids->end() }, {} });
    for (const vtkIdType id : *ids)
    {
      double p[3];
      data->GetPoint(id, p);
      lines.back().Points.push_back({ p[0], p[1], p[2] });
    }
  }
  return lines;
}

/// The normals of the planes that meet in each point, by area; empty where VTK gives none.
std::vector<double> NormalsOfSurface(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(surface);
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(bare);
  filter->SplittingOff();
  filter->ConsistencyOff();
  filter->Update();
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetNormals();
  std::vector<double> normals;
  if (array && array->GetNumberOfTuples() == surface->GetNumberOfPoints())
  {
    normals.resize(3 * static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->GetTuple(i, normals.data() + 3 * i);
    }
  }
  return normals;
}

/// Widths as lines, with what is known of each.
class WidthLines
{
public:
  void Add(const PenumbraEdge& edge, vtkIdType input, int light)
  {
    for (const Vector3& p : { edge.Dark, edge.Bright })
    {
      this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
    }
    this->Widths.push_back(static_cast<float>(edge.Width));
    this->Errors.push_back(static_cast<float>(edge.Error));
    this->OccluderIds.push_back(edge.OccluderId);
    this->LightIds.push_back(light);
    this->InputIds.push_back(input);
  }

  void Write(vtkPolyData* output) const
  {
    SetVertices(output, this->Points);
    vtkNew<vtkCellArray> lines;
    for (vtkIdType k = 0; k < static_cast<vtkIdType>(this->Widths.size()); ++k)
    {
      lines->InsertNextCell({ 2 * k, 2 * k + 1 });
    }
    output->SetVerts(nullptr);
    output->SetLines(lines);
    AddFloatArray(output->GetCellData(), "PenumbraWidth", 1, this->Widths);
    AddFloatArray(output->GetCellData(), "PenumbraWidthError", 1, this->Errors);
    AddIntArray(output->GetCellData(), "OccluderId", 1, this->OccluderIds);
    AddIntArray(output->GetCellData(), "LightId", 1, this->LightIds);
    AddIdArray(output->GetCellData(), "InputId", this->InputIds);
  }

private:
  std::vector<double> Points;
  std::vector<float> Widths;
  std::vector<float> Errors;
  std::vector<int> OccluderIds;
  std::vector<int> LightIds;
  std::vector<vtkIdType> InputIds;
};

/// @p measure fills in the edges of a range of lines: each process those of its share, then all have all. @return false where aborted.
bool MeasureLines(Team* team, const Monitor& monitor, const std::function<void(vtkIdType, vtkIdType)>& measure,
  std::vector<std::vector<PenumbraEdge>>& lines)
{
  const TeamShare share(team, static_cast<vtkIdType>(lines.size()));
  std::vector<vtkIdType> counts(lines.size(), 0);
  std::vector<PenumbraEdge> edges; // of this process, then of all
  TeamJoin join(team);
  join.AddItems(counts, share);
  join.Add(edges);
  const auto finish = [&]
  {
    for (vtkIdType k = 0; k < share.Own(); ++k)
    {
      const auto line = static_cast<std::size_t>(share.Item(k));
      counts[line] = static_cast<vtkIdType>(lines[line].size());
      edges.insert(edges.end(), lines[line].begin(), lines[line].end());
    }
  };
  if (!TeamFor(team, join, share, monitor, measure, finish))
  {
    return false;
  }
  auto next = edges.begin();
  for (int rank = 0; AreSeveral(team) && rank < team->GetSize(); ++rank)
  {
    for (vtkIdType k = 0; k < share.Of(rank); ++k)
    {
      const auto line = static_cast<std::size_t>(share.Item(k, rank));
      lines[line].assign(next, next + counts[line]);
      next += counts[line];
    }
  }
  return true;
}
} // anonymous namespace

struct vtkPenumbraWidth::Scene
{
  ShadowScene Shadows;
  ProbePoints Points;
  std::vector<double> Normals; ///< of Points; empty: the input is one of lines
  bool Facing = false;         ///< they say which side the light must come from
  std::vector<InputLine> Lines;
};

struct vtkPenumbraWidth::Results
{
  std::vector<PenumbraPlace> Places;                ///< a light each, those of a point side by side
  std::vector<std::vector<PenumbraEdge>> LineEdges; ///< a line and light each
};

vtkPenumbraWidth::vtkPenumbraWidth()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

scDefineInputPort(vtkPenumbraWidth, Mesh, meshPort);
scDefineLightPort(vtkPenumbraWidth, lightPort);

int vtkPenumbraWidth::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, "vtkPolyData", info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkPenumbraWidth::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  return 1;
}

int vtkPenumbraWidth::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

bool vtkPenumbraWidth::ReadInputs(vtkInformationVector** inputs, Scene& scene, std::string& error) const
{
  error = FirstOutOfRange(
    { { "Lower", this->Lower, this->Lower > 0.0 && this->Lower < this->Upper, "above 0 and below Upper" },
      { "Upper", this->Upper, this->Upper < 1.0, "below 1" },
      InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples),
      InRange("SamplesPerLine", this->SamplesPerLine, 2, 1000000),
      { "MaximumDistance", this->MaximumDistance, this->MaximumDistance >= 0.0 && !std::isinf(this->MaximumDistance),
        "0 or above and finite" } });
  vtkPolyData* data = vtkPolyData::GetData(inputs[0]);
  if (!error.empty() || !ReadShadowScene(inputs, lightPort, meshPort, scene.Shadows, error) ||
    !CheckCellPoints(data, error) || !ReadProbePoints(data, false, true, scene.Points, error))
  {
    return false;
  }
  const bool surface = data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
  scene.Facing = !scene.Points.Normals.empty();
  if (surface || data->GetNumberOfLines() == 0)
  {
    scene.Normals = scene.Points.Normals;
    if (scene.Normals.empty() && surface)
    {
      const std::vector<double> all = NormalsOfSurface(data);
      for (std::size_t k = 0; k < scene.Points.Items.size() && !all.empty(); ++k)
      {
        const vtkIdType item = scene.Points.Items[k];
        const Vector3 normal = VectorAt(all, static_cast<std::size_t>(item));
        scene.Normals.insert(scene.Normals.end(), { normal.X, normal.Y, normal.Z });
      }
    }
    if (scene.Normals.empty() && scene.Points.Count() > 0)
    {
      error =
        "The data on input port 0 have neither polygons nor lines, and their points no active normals: a width is "
        "measured on a surface or along a line.";
    }
    return error.empty();
  }
  scene.Lines = ReadLines(data);
  return true;
}

bool vtkPenumbraWidth::Measure(const Scene& scene, Team* team, Results& results)
{
  PenumbraWidthOptions options;
  options.Lower = this->Lower;
  options.Upper = this->Upper;
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.SamplesPerLine = this->SamplesPerLine;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  Box bounds = scene.Points.Bounds;
  bounds.Add(MeshBounds(scene.Shadows.Mesh.View()));
  options.MaximumWidth = this->MaximumDistance > 0.0 ? this->MaximumDistance : bounds.Diagonal();
  const Vector3 reach{ options.MaximumWidth, options.MaximumWidth, options.MaximumWidth };
  bounds.Min = bounds.Min - reach;
  bounds.Max = bounds.Max + reach;

  const std::vector<Light>& lights = scene.Shadows.Lights.Lights;
  const std::size_t count = lights.size();
  const OccluderScene occluders(scene.Shadows.Mesh.View());
  std::vector<std::unique_ptr<const PenumbraRuler>> rulers;
  for (const Light& light : lights)
  {
    rulers.push_back(
      std::make_unique<const PenumbraRuler>(ConesEverywhere(bounds, 1), light, occluders, bounds, options));
  }
  const Monitor monitor = MonitorOf(this);
  const double share = scene.Lines.empty() ? 0.0 : 0.8;
  results.LineEdges.resize(scene.Lines.size() * count);
  results.Places.resize(static_cast<std::size_t>(scene.Points.Count()) * count);
  const auto measureLines = [&](vtkIdType begin, vtkIdType end)
  {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
    {
      results.LineEdges[k] = rulers[k % count]->Along(scene.Lines[k / count].Points);
    }
  };
  const auto measurePoints = [&](vtkIdType begin, vtkIdType end)
  {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
    {
      const Vector3 point = VectorAt(scene.Points.Points, k / count);
      const Vector3 normal = scene.Normals.empty() ? Vector3{} : Normalized(VectorAt(scene.Normals, k / count));
      results.Places[k] = Dot(normal, normal) > 0.0 ? rulers[k % count]->At(point, normal, scene.Facing)
                                                    : rulers[k % count]->Look(point, nullptr);
    }
  };
  const TeamShare places(team, static_cast<vtkIdType>(results.Places.size()), 16 * static_cast<vtkIdType>(count));
  TeamJoin join(team);
  join.AddItems(results.Places, places);
  return MeasureLines(team, monitor.Part(0.0, share), measureLines, results.LineEdges) &&
    TeamFor(team, join, places, monitor.Part(share, 1.0), measurePoints);
}

void vtkPenumbraWidth::Write(const Scene& scene, Results& results, vtkPolyData* places, vtkPolyData* widths) const
{
  const std::size_t lights = scene.Shadows.Lights.Lights.size();
  const auto total = static_cast<std::size_t>(scene.Points.NumberOfItems) * lights;
  std::vector<float> width(total, unknown);
  std::vector<float> error(total, unknown);
  std::vector<float> visibility(total, unknown);
  std::vector<int> occluders(total, -1);
  WidthLines lines;
  const auto put = [&](const PenumbraEdge& edge, vtkIdType point, std::size_t light)
  {
    width[static_cast<std::size_t>(point) * lights + light] = static_cast<float>(edge.Width);
    error[static_cast<std::size_t>(point) * lights + light] = static_cast<float>(edge.Error);
  };
  for (std::size_t k = 0; k < results.Places.size(); ++k)
  {
    const PenumbraPlace& place = results.Places[k];
    const vtkIdType point = scene.Points.Items[k / lights];
    const std::size_t at = static_cast<std::size_t>(point) * lights + k % lights;
    visibility[at] = static_cast<float>(place.Visibility);
    occluders[at] = place.OccluderId;
    if (place.Edge.Width > 0.0)
    {
      put(place.Edge, point, k % lights);
      lines.Add(place.Edge, point, static_cast<int>(k % lights));
    }
  }
  for (std::size_t k = 0; k < results.LineEdges.size(); ++k)
  {
    const InputLine& line = scene.Lines[k / lights];
    for (const PenumbraEdge& edge : results.LineEdges[k])
    {
      lines.Add(edge, line.Cell, static_cast<int>(k % lights));
      double length = 0.0;
      for (std::size_t corner = 0; corner < line.Points.size(); ++corner)
      {
        length += corner > 0 ? Length(line.Points[corner] - line.Points[corner - 1]) : 0.0;
        if (length >= edge.From && length <= edge.To)
        {
          put(edge, line.Ids[corner], k % lights);
        }
      }
    }
  }
  const auto components = static_cast<int>(lights);
  AddFloatArray(places->GetPointData(), "PenumbraWidth", components, width);
  AddFloatArray(places->GetPointData(), "PenumbraWidthError", components, error);
  AddFloatArray(places->GetPointData(), "Visibility", components, visibility);
  AddIntArray(places->GetPointData(), "OccluderId", components, occluders);
  lines.Write(widths);
}

int vtkPenumbraWidth::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  Scene scene;
  Results results;
  if (!run.AreInputsWhole(error) || !this->ReadInputs(inputVector, scene, error))
  {
    return run.Fail(error);
  }
  try
  {
    if (!this->Measure(scene, run.GetTeam(), results))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Measuring the penumbra failed: ", ReasonOf(exception)));
  }
  vtkPolyData* places = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* widths = vtkPolyData::GetData(outputVector, 1);
  places->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
  this->Write(scene, results, places, widths);
  WriteShadowScene(scene.Shadows, places);
  WriteShadowScene(scene.Shadows, widths);
  Warnings said;
  said.Add(scene.Shadows.Lights.Warnings);
  said.Say(this);
  return 1;
}

void vtkPenumbraWidth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lower: " << this->Lower << "\n";
  os << indent << "Upper: " << this->Upper << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "SamplesPerLine: " << this->SamplesPerLine << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
