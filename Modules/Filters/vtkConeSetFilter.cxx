// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetFilter.h"

#include "scAdapters.h"
#include "scConeSet.h"
#include "scLightData.h"
#include "scPieces.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <exception>

namespace
{
using namespace shadowcones;

/// The light's extent, from its exact shape in the field data or else from the emission points.
bool ReadLightExtent(
  vtkPolyData* vectors, const ShadowVectorArrays& arrays, LightExtent& extent, Light& light, std::string& error)
{
  if (!vectors->GetFieldData()->GetAbstractArray("LightShape"))
  {
    extent = LightExtentOf(arrays.EmissionPoints.data(), static_cast<vtkIdType>(arrays.EmissionPoints.size() / 3));
    return true;
  }
  if (!ReadLight(vectors, light, error))
  {
    return false;
  }
  extent = LightExtentOf(light);
  return true;
}

std::vector<Cone> SliceOf(const std::vector<Cone>& cones, const PieceRequest& piece)
{
  const auto count = static_cast<vtkIdType>(cones.size());
  return { cones.begin() + piece.Begin(count), cones.begin() + piece.End(count) };
}

/// The vectors [begin, end) of the input with all their arrays, and the cone of each.
void WriteLabelledVectors(
  vtkPolyData* input, const std::vector<vtkIdType>& coneIds, const PieceRequest& piece, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(coneIds.size());
  const vtkIdType begin = piece.Begin(count);
  const vtkIdType end = piece.End(count);
  std::vector<double> points(static_cast<std::size_t>(3 * (end - begin)));
  vtkPointData* data = output->GetPointData();
  data->CopyAllocate(input->GetPointData(), end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    input->GetPoint(i, &points[3 * (i - begin)]);
    data->CopyData(input->GetPointData(), i, i - begin);
  }
  SetVertices(output, points);
  AddIdArray(data, "ConeId", { coneIds.begin() + begin, coneIds.begin() + end });
}
} // anonymous namespace

vtkStandardNewMacro(vtkConeSetFilter);

vtkConeSetFilter::vtkConeSetFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

void vtkConeSetFilter::SetPhotonPathConnection(vtkAlgorithmOutput* paths)
{
  this->SetInputConnection(1, paths);
}

void vtkConeSetFilter::SetPhotonPathData(vtkDataObject* paths)
{
  this->SetInputData(1, paths);
}

int vtkConeSetFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1 ? 1 : 0);
  return 1;
}

int vtkConeSetFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  HandlePieces(outputVector);
  return 1;
}

int vtkConeSetFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  RequestWholeInputs(this, inputVector);
  return 1;
}

int vtkConeSetFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* vectorInput = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* pathInput = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* coneOutput = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* vectorOutput = vtkPolyData::GetData(outputVector, 1);

  ConeSetOptions options;
  options.NumberOfNeighbors = this->NumberOfNeighbors;
  options.NumberOfSectors = this->NumberOfSectors;
  options.PointsPerRing = this->PointsPerRing;
  options.MinimumVectorsPerCone = this->MinimumVectorsPerCone;
  options.VarianceThreshold = this->VarianceThreshold;
  options.PlanarityThreshold = this->PlanarityThreshold;
  options.CosineCorrection = this->CosineCorrection;
  options.Expansion = static_cast<ConeExpansion>(this->Expansion);
  options.ExpansionFraction = this->ExpansionFraction;
  options.Overlap = this->Overlap;
  if (const char* fault = CheckConeSetOptions(options))
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }

  ShadowVectorArrays vectors;
  PhotonPathArrays paths;
  LightExtent extent;
  Light light;
  std::string error;
  const bool hasShape = vectorInput->GetFieldData()->GetAbstractArray("LightShape") != nullptr;
  if (!ReadShadowVectors(vectorInput, vectors, error, !hasShape) || !CheckPointArrays(vectorInput, error) ||
    (pathInput && !ReadPhotonPaths(pathInput, paths, error)) ||
    (vectorInput->GetNumberOfPoints() > 0 && !ReadLightExtent(vectorInput, vectors, extent, light, error)))
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  ConeSet result;
  try
  {
    if (!FitConeSet(vectors.View(), paths.View(), extent, options, MonitorOf(this), result))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Fitting cones failed: " << exception.what());
    return 0;
  }

  const PieceRequest piece = RequestedPiece(request, outputVector);
  WriteConeSet(SliceOf(result.Cones, piece), coneOutput);
  WriteLabelledVectors(vectorInput, result.ConeIds, piece, vectorOutput);
  coneOutput->GetFieldData()->PassData(vectorInput->GetFieldData());
  vectorOutput->GetFieldData()->PassData(vectorInput->GetFieldData());
  this->AddParameters(coneOutput->GetFieldData());
  const auto numberOfVectors = static_cast<vtkIdType>(result.ConeIds.size());
  AddIdArray(coneOutput->GetFieldData(), "NumberOfVectors", { numberOfVectors });
  AddIdArray(coneOutput->GetFieldData(), "NumberOfCones", { static_cast<vtkIdType>(result.Cones.size()) });
  AddIdArray(coneOutput->GetFieldData(), "NumberOfDiscarded", { result.NumberOfDiscarded });
  AddDoubleArray(coneOutput->GetFieldData(), "DiscardedFraction", 1,
    { numberOfVectors > 0 ? static_cast<double>(result.NumberOfDiscarded) / static_cast<double>(numberOfVectors) : 0.0 });
  return 1;
}

void vtkConeSetFilter::AddParameters(vtkFieldData* data) const
{
  AddIntArray(data, "Tuning", 1, { this->Tuning });
  AddIntArray(data, "NumberOfNeighbors", 1, { this->NumberOfNeighbors });
  AddIntArray(data, "NumberOfSectors", 1, { this->NumberOfSectors });
  AddIntArray(data, "PointsPerRing", 1, { this->PointsPerRing });
  AddIntArray(data, "MinimumVectorsPerCone", 1, { this->MinimumVectorsPerCone });
  AddDoubleArray(data, "VarianceThreshold", 1, { this->VarianceThreshold });
  AddDoubleArray(data, "PlanarityThreshold", 1, { this->PlanarityThreshold });
  AddIntArray(data, "CosineCorrection", 1, { this->CosineCorrection ? 1 : 0 });
  AddIntArray(data, "Expansion", 1, { this->Expansion });
  AddDoubleArray(data, "ExpansionFraction", 1, { this->ExpansionFraction });
  AddIntArray(data, "Overlap", 1, { this->Overlap ? 1 : 0 });
}

void vtkConeSetFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const expansions[] = { "MaximumDeviation", "RadiusRatio", "LightGeometry" };
  os << indent << "Tuning: Manual\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "NumberOfSectors: " << this->NumberOfSectors << "\n";
  os << indent << "PointsPerRing: " << this->PointsPerRing << "\n";
  os << indent << "MinimumVectorsPerCone: " << this->MinimumVectorsPerCone << "\n";
  os << indent << "VarianceThreshold: " << this->VarianceThreshold << "\n";
  os << indent << "PlanarityThreshold: " << this->PlanarityThreshold << "\n";
  os << indent << "CosineCorrection: " << (this->CosineCorrection ? "on" : "off") << "\n";
  os << indent << "Expansion: "
     << (this->Expansion >= 0 && this->Expansion <= 2 ? expansions[this->Expansion] : "invalid") << "\n";
  os << indent << "ExpansionFraction: " << this->ExpansionFraction << "\n";
  os << indent << "Overlap: " << (this->Overlap ? "on" : "off") << "\n";
}
