// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetProbe.h"

#include "scConeData.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scVisibilityData.h"
#include "scVisibilityProbe.h"

#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
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
  Box Bounds;
  bool OnSurfaces = false;

  vtkIdType Count() const { return static_cast<vtkIdType>(this->Points.size() / 3); }
};

/// @return false, with a sentence in @p error, where a coordinate is not finite.
bool ReadPlaces(vtkDataSet* data, bool atCells, bool useNormals, Places& places, std::string& error)
{
  const vtkIdType count = atCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  places.Points.resize(static_cast<std::size_t>(3 * count));
  if (atCells && count > 0)
  {
    vtkNew<vtkDoubleArray> centers;
    centers->SetNumberOfComponents(3);
    centers->SetNumberOfTuples(count);
    vtkCellCenters::ComputeCellCenters(data, centers);
    std::copy_n(centers->GetPointer(0), places.Points.size(), places.Points.begin());
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double* p = places.Points.data() + 3 * i;
    if (!atCells)
    {
      data->GetPoint(i, p);
    }
    const Vector3 point{ p[0], p[1], p[2] };
    if (!IsFinite(point))
    {
      error = (atCells ? "The centre of cell " : "Point ") + std::to_string(i) +
        " of the data set on input port 0 has a coordinate that is not finite.";
      return false;
    }
    places.Bounds.Add(point);
  }

  vtkDataSetAttributes* attributes =
    atCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  vtkDataArray* normals = useNormals ? attributes->GetNormals() : nullptr;
  if (normals && normals->GetNumberOfTuples() == count)
  {
    places.Normals.resize(places.Points.size());
    for (vtkIdType i = 0; i < count; ++i)
    {
      normals->GetTuple(i, places.Normals.data() + 3 * i);
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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  // What is missing is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkConeSetProbe::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // The data set is asked for what is asked of the output; the rest is needed as a whole.
  RequestWholeInputs(this, inputVector, 1);
  return 1;
}

bool vtkConeSetProbe::CheckRequest(vtkDataObject* cones, vtkDataObject* light, vtkDataObject* mesh)
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
  else if (!cones)
  {
    vtkErrorMacro("No cone set on input port 1: connect a vtkConeSetFilter with SetConeSetConnection.");
  }
  else if (!light)
  {
    vtkErrorMacro("No light on input port 2: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.");
  }
  else if (this->Method == EXACT && !mesh)
  {
    vtkErrorMacro("Exact needs the mesh on input port 3: connect it with SetMeshConnection, or use Soft.");
  }
  else
  {
    return true;
  }
  return false;
}

int vtkConeSetProbe::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  vtkPolyData* coneInput = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* lightInput = vtkPolyData::GetData(inputVector[2]);
  vtkPolyData* meshInput = vtkPolyData::GetData(inputVector[3]);
  if (!this->CheckRequest(coneInput, lightInput, meshInput))
  {
    return 0;
  }

  const bool exact = this->Method == EXACT;
  const bool atCells = this->Association == CELLS;
  std::vector<Cone> cones;
  Light light;
  TriangleMesh mesh;
  Places places;
  std::string error;
  if (!ReadConeSet(coneInput, cones, error) || !ReadLight(lightInput, light, error) ||
    (exact && !ReadTriangles(meshInput, mesh, error)) || !ReadPlaces(input, atCells, this->UseNormals, places, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (exact && mesh.Triangles.empty() && meshInput->GetNumberOfCells() > 0)
  {
    vtkErrorMacro("The mesh on input port 3 has "
      << meshInput->GetNumberOfCells()
      << " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first, or use Soft.");
    return 0;
  }
  DropReceivers(mesh);
  if (!exact)
  {
    UndoCosineCorrection(coneInput->GetFieldData(), cones);
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
    const VisibilityProbe probe(cones, light, exact ? &scene : nullptr, places.Bounds, options);
    if (!ProbeVisibility(probe, places.Points.data(), places.Normals.empty() ? nullptr : places.Normals.data(),
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
  WriteVisibility(result, atCells ? static_cast<vtkDataSetAttributes*>(output->GetCellData()) : output->GetPointData());
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
