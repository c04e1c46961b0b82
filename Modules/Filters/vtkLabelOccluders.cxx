// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLabelOccluders.h"

#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scLabelData.h"
#include "scMeshSurfaces.h"
#include "scParameterRanges.h"
#include "scSentence.h"
#include "scWarnings.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <string>

namespace
{

using namespace shadowcones;

OccluderLabel LabelOf(int labelBy, vtkDataObject* input)
{
  if (labelBy == vtkLabelOccluders::Automatic)
  {
    return HasBlocks(input) ? OccluderLabel::Block : OccluderLabel::Component;
  }
  const bool block = labelBy == vtkLabelOccluders::Block || labelBy == vtkLabelOccluders::Array;
  return block                            ? OccluderLabel::Block
    : labelBy == vtkLabelOccluders::Whole ? OccluderLabel::Whole
                                          : OccluderLabel::Component;
}

} // namespace

vtkStandardNewMacro(vtkLabelOccluders);
scDefineGuardedRequests(vtkLabelOccluders);

vtkLabelOccluders::vtkLabelOccluders()
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "OccluderId");
}

int vtkLabelOccluders::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  AcceptDataSets(info);
  return 1;
}

int vtkLabelOccluders::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkLabelOccluders::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Labels and winding need the whole mesh.
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

bool vtkLabelOccluders::ReadInput(vtkDataObject* input, GivenMesh& given, std::string& error)
{
  error = FirstOutOfRange({ OneOf("LabelBy", this->LabelBy, { "Automatic", "Component", "Block", "Whole", "Array" }),
    { "WeldTolerance", this->WeldTolerance, this->WeldTolerance >= 0.0 && this->WeldTolerance <= 0.1, "in 0..0.1" } });
  if (!error.empty() || !ReadGivenMesh(input, given, error))
  {
    return false;
  }
  const bool empty = given.Mesh.Points.empty() && given.IgnoredCells == 0;
  const bool allHidden = given.Mesh.NumberOfCells == 0 && given.HasCells;
  if (given.Mesh.SourceCells.empty() && !empty && !allHidden)
  {
    error = "The mesh has no polygons: only polygons and strips cast shadows.";
    return false;
  }
  if (this->LabelBy == Array)
  {
    const char* array = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
    return LabelByArray(array ? array : "OccluderId", given, error);
  }
  if (LabelOf(this->LabelBy, input) == OccluderLabel::Block)
  {
    LabelByBlock(given);
  }
  else
  {
    LabelByGiven(given);
  }
  return true;
}

int vtkLabelOccluders::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  GivenMesh given;
  std::string error;
  vtkSmartPointer<vtkDataObject> input; // what is given points into it
  if (!run.AreInputsWhole(error) ||
    !(input = SurfacesOf(vtkDataObject::GetData(inputVector[0]), given.ExtractedSurfaces, error)) ||
    !this->ReadInput(input, given, error))
  {
    return run.Fail(error);
  }
  OccluderTopologyOptions options;
  options.WeldTolerance = this->WeldTolerance;
  options.LabelBy = LabelOf(this->LabelBy, input);
  options.Orient = this->Orient;
  OccluderTopology topology;
  try
  {
    if (!BuildOccluderTopology(given.Mesh.View(), given.Labels.data(), options, MonitorOf(this), topology))
    {
      return 1; // aborted: the output stays empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(ReasonOf(exception));
  }
  if (topology.InputTriangles.empty() && !given.Mesh.SourceCells.empty())
  {
    return run.Fail(
      Sentence("No polygon of the mesh has an area: all ", topology.DegenerateTriangles, " triangles are degenerate."));
  }

  const PieceRequest piece = RequestedPiece(request, outputVector);
  const auto count = static_cast<vtkIdType>(topology.InputTriangles.size());
  WriteLabelledMesh(given, topology, piece.Begin(count), piece.End(count), vtkPolyData::GetData(outputVector));
  if (piece.Piece == 0) // every piece reads the whole mesh
  {
    const vtkIdType dropped = topology.DegenerateTriangles + topology.DuplicateTriangles;
    Warnings warnings;
    warnings.Add(TrianglesDropped(dropped, count + dropped));
    warnings.Add(CoarseCoordinates(input));
    warnings.Say(this);
  }
  return 1;
}

void vtkLabelOccluders::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelBy: " << this->LabelBy << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "Orient: " << (this->Orient ? "On" : "Off") << "\n";
}
