// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFootprints.h"

#include "scConeData.h"
#include "scFilterRun.h"
#include "scFootprintData.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scParameterRanges.h"
#include "scSentence.h"
#include "scShadowFootprint.h"
#include "scShadowScene.h"
#include "scWarnings.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <exception>

using namespace shadowcones;

vtkStandardNewMacro(vtkShadowFootprints);
scDefineGuardedRequests(vtkShadowFootprints);

namespace
{
constexpr int lightPort = 1;
constexpr int meshPort = 2;
constexpr double mostTriangles = 1 << 26;
} // anonymous namespace

struct vtkShadowFootprints::Scene
{
  ShadowScene Shadows;
  TriangleMesh Surface;
  std::vector<double> Normals; ///< of its points, or none
  Box Bounds;
  double Spacing = 0.0;
};

vtkShadowFootprints::vtkShadowFootprints()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

scDefineInputPort(vtkShadowFootprints, Mesh, meshPort);
scDefineLightPort(vtkShadowFootprints, lightPort);

int vtkShadowFootprints::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, "vtkPolyData", info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkShadowFootprints::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  return 1;
}

int vtkShadowFootprints::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

bool vtkShadowFootprints::ReadInputs(vtkInformationVector** inputs, Scene& scene, std::string& error) const
{
  error = FirstOutOfRange(
    { { "Spacing", this->Spacing, this->Spacing >= 0.0 && !std::isinf(this->Spacing), "0 or above and finite" },
      InRange("Refinements", this->Refinements, 0, 8),
      InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples) });
  vtkPolyData* data = vtkPolyData::GetData(inputs[0]);
  if (!error.empty() || !ReadShadowScene(inputs, lightPort, meshPort, scene.Shadows, error) ||
    !ReadSurface(data, scene.Surface, error))
  {
    return false;
  }
  if (scene.Surface.Triangles.empty() && scene.Surface.NumberOfCells > 0)
  {
    error = Sentence("The data on input port 0 have ", scene.Surface.NumberOfCells,
      " cells and no polygon: footprints are asked for on a surface. Run vtkDataSetSurfaceFilter first.");
    return false;
  }
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  if (normals && 3 * normals->GetNumberOfTuples() == static_cast<vtkIdType>(scene.Surface.Points.size()))
  {
    scene.Normals.resize(scene.Surface.Points.size());
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      normals->GetTuple(i, scene.Normals.data() + 3 * i);
    }
  }
  scene.Bounds = MeshBounds(scene.Surface.View());
  scene.Spacing = this->Spacing > 0.0 ? this->Spacing : 0.01 * scene.Bounds.Diagonal();
  const double triangles =
    scene.Surface.Triangles.empty() ? 0.0 : CountFootprintTriangles(scene.Surface.View(), scene.Spacing);
  if (triangles > mostTriangles)
  {
    error = Sentence("Spacing ", scene.Spacing, " cuts the surface into some ", triangles, " triangles, and ",
      mostTriangles, " are the most: raise it.");
    return false;
  }
  return true;
}

bool vtkShadowFootprints::Find(const Scene& scene, std::vector<ShadowFootprints>& found)
{
  FootprintOptions options;
  options.Spacing = scene.Spacing;
  options.Refinements = this->Refinements;
  options.PerOccluder = this->PerOccluder;
  VisibilityOptions asked;
  asked.NumberOfLightSamples = this->NumberOfLightSamples;
  asked.Seed = static_cast<std::uint64_t>(this->Seed);
  asked.Outline = true;

  const std::vector<Light>& lights = scene.Shadows.Lights.Lights;
  const OccluderScene occluders(scene.Shadows.Mesh.View());
  const FootprintSurface surface{ scene.Surface.View(), scene.Normals.empty() ? nullptr : scene.Normals.data() };
  const Monitor monitor = MonitorOf(this);
  found.resize(lights.size());
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    const VisibilityProbe probe(ConesEverywhere(scene.Bounds, 1), lights[k], &occluders, scene.Bounds, asked);
    const auto count = static_cast<double>(lights.size());
    if (!FindShadowFootprints(
          probe, surface, options, monitor.Part(static_cast<double>(k) / count, (k + 1.0) / count), found[k]))
    {
      return false;
    }
  }
  return true;
}

int vtkShadowFootprints::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  Scene scene;
  if (!run.AreInputsWhole(error) || !this->ReadInputs(inputVector, scene, error))
  {
    return run.Fail(error);
  }
  std::vector<ShadowFootprints> found;
  try
  {
    if (!scene.Surface.Triangles.empty() && !this->Find(scene, found))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Finding the footprints failed: ", ReasonOf(exception)));
  }
  vtkPolyData* outlines = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* areas = vtkPolyData::GetData(outputVector, 1);
  WriteFootprints(found, outlines, areas);
  WriteShadowScene(scene.Shadows, outlines);
  WriteShadowScene(scene.Shadows, areas);
  Warnings said;
  said.Add(scene.Shadows.Lights.Warnings);
  said.Say(this);
  return 1;
}

void vtkShadowFootprints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Refinements: " << this->Refinements << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "PerOccluder: " << (this->PerOccluder ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
