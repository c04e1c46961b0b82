// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetProbe.h"

#include "scConeData.h"
#include "scConeIntervals.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGhosts.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scSceneLights.h"
#include "scVisibilityData.h"
#include "scVisibilityProbe.h"
#include "scWarnings.h"

#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <memory>

namespace
{
using namespace shadowcones;

constexpr int mostLightSamples = 65536;

/// Where the light is asked for: three coordinates each, and normals or none.
struct Places
{
  std::vector<double> Points;
  std::vector<double> Normals;
  std::vector<vtkIdType> Items; ///< the point or cell of each place
  vtkIdType NumberOfItems = 0;  ///< with those that are hidden
  Box Bounds;
  bool OnSurfaces = false;

  vtkIdType Count() const { return static_cast<vtkIdType>(this->Items.size()); }
};

/// The points or cells that are not hidden.
std::vector<vtkIdType> VisibleItems(vtkDataSet* data, bool atCells)
{
  const Ghosts cells(data->GetCellData());
  const Ghosts points(data->GetPointData());
  const vtkIdType count = atCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  std::vector<vtkIdType> items;
  items.reserve(static_cast<std::size_t>(count));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < count; ++i)
  {
    bool hidden = atCells ? cells.IsCellHidden(i) : points.IsPointHidden(i);
    if (atCells && points.Any())
    {
      data->GetCellPoints(i, corners);
      hidden = hidden ||
        std::any_of(corners->begin(), corners->end(), [&points](vtkIdType id) { return points.IsPointHidden(id); });
    }
    if (!hidden)
    {
      items.push_back(i);
    }
  }
  return items;
}

/// @return false, with a sentence in @p error, where a coordinate is not finite.
bool ReadPlaces(vtkDataSet* data, bool atCells, bool useNormals, Places& places, std::string& error)
{
  places.NumberOfItems = atCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  places.Items = VisibleItems(data, atCells);
  places.Points.resize(3 * places.Items.size());
  vtkNew<vtkDoubleArray> centers;
  if (atCells && places.NumberOfItems > 0)
  {
    centers->SetNumberOfComponents(3);
    centers->SetNumberOfTuples(places.NumberOfItems);
    vtkCellCenters::ComputeCellCenters(data, centers);
  }
  for (std::size_t k = 0; k < places.Items.size(); ++k)
  {
    double* p = places.Points.data() + 3 * k;
    if (atCells)
    {
      centers->GetTypedTuple(places.Items[k], p);
    }
    else
    {
      data->GetPoint(places.Items[k], p);
    }
    const Vector3 point{ p[0], p[1], p[2] };
    if (!IsFinite(point))
    {
      error = (atCells ? "The centre of cell " : "Point ") + std::to_string(places.Items[k]) +
        " of the data set on input port 0 has a coordinate that is not finite.";
      return false;
    }
    places.Bounds.Add(point);
  }

  vtkDataSetAttributes* attributes =
    atCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  vtkDataArray* normals = useNormals ? attributes->GetNormals() : nullptr;
  if (normals && normals->GetNumberOfTuples() == places.NumberOfItems)
  {
    places.Normals.resize(places.Points.size());
    for (std::size_t k = 0; k < places.Items.size(); ++k)
    {
      normals->GetTuple(places.Items[k], places.Normals.data() + 3 * k);
    }
  }
  vtkPolyData* surface = vtkPolyData::SafeDownCast(data);
  places.OnSurfaces =
    !places.Normals.empty() || (surface && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0);
  return true;
}
} // anonymous namespace

vtkStandardNewMacro(vtkConeSetProbe);

vtkConeSetProbe::vtkConeSetProbe()
{
  this->SetNumberOfInputPorts(4);
}

void vtkConeSetProbe::SetConeSetConnection(vtkAlgorithmOutput* cones)
{
  this->SetInputConnection(1, cones);
}

void vtkConeSetProbe::SetConeSetData(vtkDataObject* cones)
{
  this->SetInputData(1, cones);
}

void vtkConeSetProbe::SetLightConnection(vtkAlgorithmOutput* light)
{
  this->SetInputConnection(2, light);
}

void vtkConeSetProbe::SetLightData(vtkDataObject* light)
{
  this->SetInputData(2, light);
}

void vtkConeSetProbe::AddLightConnection(vtkAlgorithmOutput* light)
{
  this->AddInputConnection(2, light);
}

void vtkConeSetProbe::AddLightData(vtkDataObject* light)
{
  this->AddInputDataInternal(2, light);
}

void vtkConeSetProbe::RemoveAllLights()
{
  this->RemoveAllInputConnections(2);
}

void vtkConeSetProbe::SetMeshConnection(vtkAlgorithmOutput* mesh)
{
  this->SetInputConnection(3, mesh);
}

void vtkConeSetProbe::SetMeshData(vtkDataObject* mesh)
{
  this->SetInputData(3, mesh);
}

int vtkConeSetProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 2)
  {
    FillLightPortInformation(info);
    return 1;
  }
  if (port == 3)
  {
    AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  }
  // What is missing is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkConeSetProbe::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  return 1;
}

int vtkConeSetProbe::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // The data set is asked for what is asked of the output; the rest is needed as a whole.
  RequestWholeInputs(this, inputVector, 1);
  return 1;
}

bool vtkConeSetProbe::CheckRequest(vtkDataObject* cones, bool hasLight, vtkDataObject* mesh)
{
  if (this->Method != EXACT && this->Method != SOFT)
  {
    vtkErrorMacro("Method is " << this->Method << "; it must be 0 (Exact) or 1 (Soft).");
  }
  else if (this->Association != POINTS && this->Association != CELLS)
  {
    vtkErrorMacro("Association is " << this->Association << "; it must be 0 (Points) or 1 (Cells).");
  }
  else if (this->NumberOfLightSamples < 1 || this->NumberOfLightSamples > mostLightSamples)
  {
    vtkErrorMacro(
      "NumberOfLightSamples is " << this->NumberOfLightSamples << "; it must be 1 to " << mostLightSamples << ".");
  }
  else if (!hasLight)
  {
    vtkErrorMacro("No light on input port 2: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.");
  }
  else if (this->Method == EXACT && !mesh)
  {
    vtkErrorMacro("Exact needs the mesh on input port 3: connect it with SetMeshConnection, or use Soft.");
  }
  else if (!cones && this->Method == SOFT)
  {
    vtkErrorMacro("No cone set on input port 1: connect a vtkConeSetFilter with SetConeSetConnection, or connect the mesh and "
                  "use Exact.");
  }
  else
  {
    return true;
  }
  return false;
}

int vtkConeSetProbe::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error, 1))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  vtkPolyData* coneInput = vtkPolyData::GetData(inputVector[1]);
  vtkDataObject* meshInput = vtkDataObject::GetData(inputVector[3]);
  vtkNew<vtkFieldData> none;
  vtkFieldData* coneData = coneInput ? coneInput->GetFieldData() : none.Get();
  if (!this->CheckRequest(coneInput, inputVector[2]->GetNumberOfInformationObjects() > 0, meshInput))
  {
    return 0;
  }

  const bool exact = this->Method == EXACT;
  const bool atCells = this->Association == CELLS;
  std::vector<Cone> cones;
  SceneLights lights;
  TriangleMesh mesh;
  Places places;
  if ((coneInput && !ReadConeSet(coneInput, cones, error)) || !ReadLights(inputVector[2], lights, error) ||
    (exact && !ReadTriangles(meshInput, mesh, error)) || !ReadPlaces(input, atCells, this->UseNormals, places, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (exact && mesh.Triangles.empty() && mesh.NumberOfCells > 0)
  {
    vtkErrorMacro("The mesh on input port 3 has "
      << mesh.NumberOfCells
      << " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first, or use Soft.");
    return 0;
  }
  std::vector<std::string> names = exact ? mesh.OccluderNames : ReadOccluderNames(coneData);
  std::vector<std::uint64_t> fingerprints = ReadFingerprints(castersFingerprint, coneData);
  if (exact)
  {
    const std::uint64_t own = CastersFingerprintOf(mesh);
    const std::string mismatch = CompareFingerprints(castersFingerprint, coneData, { own },
      "The cone set on input port 1", "casters than those of the mesh on input port 3");
    fingerprints = { own };
    if (!mismatch.empty())
    {
      vtkWarningMacro(<< mismatch);
    }
  }
  DropReceivers(mesh);
  if (!exact)
  {
    UndoCosineCorrection(coneData, cones);
  }
  if (coneInput)
  {
    AssignCones(coneInput, lights, cones);
  }
  if (exact)
  {
    const std::size_t count = lights.Lights.size();
    cones = coneInput ? ConesFor(places.Bounds, count, coneData, cones)
                      : ConesEverywhere(places.Bounds, count);
  }

  VisibilityOptions options;
  options.Method = static_cast<VisibilityMethod>(this->Method);
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.OnSurfaces = places.OnSurfaces;
  VisibilityResult result;
  try
  {
    const OccluderScene scene(mesh.View());
    const std::vector<std::vector<Cone>> conesOf = ConesOfLights(cones, lights.Lights.size());
    std::vector<std::unique_ptr<const VisibilityProbe>> probes;
    std::vector<const VisibilityProbe*> asked;
    for (std::size_t k = 0; k < lights.Lights.size(); ++k)
    {
      probes.push_back(std::make_unique<const VisibilityProbe>(
        conesOf[k], lights.Lights[k], exact ? &scene : nullptr, places.Bounds, options));
      asked.push_back(probes.back().get());
    }
    if (!ProbeVisibility(asked, places.Points.data(), places.Normals.empty() ? nullptr : places.Normals.data(),
          places.Count(), MonitorOf(this), result))
    {
      return 1; // aborted: the output stays empty
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Probing failed: " << exception.what());
    return 0;
  }

  output->ShallowCopy(input);
  WriteLightFingerprints(lights.Lights, output);
  WriteOccluderNames(names, output->GetFieldData());
  if (!fingerprints.empty())
  {
    WriteFingerprints(castersFingerprint, fingerprints, output->GetFieldData());
  }
  WriteVisibility(result, static_cast<int>(lights.Lights.size()), places.Items, places.NumberOfItems,
    atCells ? static_cast<vtkDataSetAttributes*>(output->GetCellData()) : output->GetPointData());
  Warnings warnings;
  for (const std::string& warning : lights.Warnings)
  {
    warnings.Add(warning);
  }
  const auto numberOfCones = static_cast<vtkIdType>(cones.size());
  warnings.Add(EmptyConeSet(numberOfCones, static_cast<vtkIdType>(mesh.Triangles.size() / 3)));
  warnings.Add(exact ? TooManyDiscarded(coneData) : std::string());
  if (RequestedPiece(request, outputVector).NumberOfPieces == 1)
  {
    // A place counts once, whichever of the lights it is that it sees, or does not.
    const auto asked = places.Count();
    const auto lightCount = static_cast<vtkIdType>(lights.Lights.size());
    const auto count = [&](ShadowClass kind)
    {
      vtkIdType all = 0;
      for (vtkIdType i = 0; i < asked; ++i)
      {
        const unsigned char* classes = result.ShadowClasses.data() + i * lightCount;
        all += std::count(classes, classes + lightCount, static_cast<unsigned char>(kind)) == lightCount;
      }
      return all;
    };
    const char* const what = atCells ? "cells" : "points";
    warnings.Add(NoPlaceInShadow(what, asked, asked - count(ShadowClass::Lit), numberOfCones));
    warnings.Add(NoPlaceLit(what, asked, asked - count(ShadowClass::Umbra)));
  }
  warnings.Say(this);
  return 1;
}

void vtkConeSetProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == EXACT ? "Exact" : this->Method == SOFT ? "Soft" : "invalid") << "\n";
  os << indent << "Association: "
     << (this->Association == POINTS     ? "Points"
            : this->Association == CELLS ? "Cells"
                                         : "invalid")
     << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "UseNormals: " << (this->UseNormals ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
