// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetFilter.h"

#include "scConeData.h"
#include "scConeTuning.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scVectorData.h"

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
  options.RadiusScale = this->RadiusScale;
  options.MaximumOverspill = this->MaximumOverspill;
  options.Overlap = this->Overlap;
  if (this->Tuning < MANUAL || this->Tuning > SOFT)
  {
    vtkErrorMacro("Tuning is " << this->Tuning << "; it must be 0 (Manual), 1 (Conservative), 2 (Preview) or 3 (Soft).");
    return 0;
  }
  if (this->Tuning != MANUAL && !pathInput)
  {
    vtkErrorMacro("Tuning learns from photon paths and input port 1 has none: connect output port 1 of "
                  "vtkShadowVectorFilter with SetPhotonPathConnection, or use SetTuningToManual.");
    return 0;
  }
  if (this->MaximumOverspill < 1.0 && !pathInput)
  {
    vtkErrorMacro("MaximumOverspill is " << this->MaximumOverspill
      << " and input port 1 has no photon paths to see lit light by: connect output port 1 of vtkShadowVectorFilter with "
         "SetPhotonPathConnection, or set MaximumOverspill to 1.");
    return 0;
  }
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
  if (!ReadShadowVectors(vectorInput, vectors, error, !hasShape) || !CheckAttributes(vectorInput->GetPointData(), vectorInput->GetNumberOfPoints(), "point", error) ||
    (pathInput && !ReadPhotonPaths(pathInput, paths, error)) ||
    (vectorInput->GetNumberOfPoints() > 0 && !ReadLightExtent(vectorInput, vectors, extent, light, error)))
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  ConeSet result;
  ConeTuningResult tuning;
  const bool tuned = this->Tuning != MANUAL && vectorInput->GetNumberOfPoints() > 0;
  const Monitor monitor = MonitorOf(this);
  const double tuningShare = tuned ? 0.9 : 0.0;
  try
  {
    if (tuned &&
      !TuneConeSet(vectors.View(), paths.View(), extent, static_cast<ConeTuning>(this->Tuning), options,
        monitor.Part(0.0, tuningShare), tuning))
    {
      return 1; // aborted: the outputs stay empty
    }
    options = tuned ? tuning.Options : options;
    if (!FitConeSet(vectors.View(), paths.View(), extent, options, monitor.Part(tuningShare, 1.0), result))
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
  AddIntArray(coneOutput->GetFieldData(), "Tuning", 1, { this->Tuning });
  WriteConeSetOptions(options, coneOutput->GetFieldData());
  if (tuned)
  {
    WriteConeTuning(tuning, coneOutput->GetFieldData());
  }
  const auto numberOfVectors = static_cast<vtkIdType>(result.ConeIds.size());
  AddIdArray(coneOutput->GetFieldData(), "NumberOfVectors", { numberOfVectors });
  AddIdArray(coneOutput->GetFieldData(), "NumberOfCones", { static_cast<vtkIdType>(result.Cones.size()) });
  AddIdArray(coneOutput->GetFieldData(), "NumberOfDiscarded", { result.NumberOfDiscarded });
  AddDoubleArray(coneOutput->GetFieldData(), "DiscardedFraction", 1,
    { numberOfVectors > 0 ? static_cast<double>(result.NumberOfDiscarded) / static_cast<double>(numberOfVectors) : 0.0 });
  return 1;
}

void vtkConeSetFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const expansions[] = { "MaximumDeviation", "RadiusRatio", "LightGeometry" };
  static const char* const tunings[] = { "Manual", "Conservative", "Preview", "Soft" };
  os << indent << "Tuning: " << (this->Tuning >= 0 && this->Tuning <= 3 ? tunings[this->Tuning] : "invalid") << "\n";
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
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "MaximumOverspill: " << this->MaximumOverspill << "\n";
  os << indent << "Overlap: " << (this->Overlap ? "on" : "off") << "\n";
}
