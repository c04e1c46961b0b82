// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLabelOccluders.h"

#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scMeshData.h"
#include "scOccluderTopology.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

namespace
{

using namespace shadowcones;

/// A poly data of the input and the block that it belongs to.
struct Leaf
{
  vtkPolyData* Data;
  int Block;
};

/// Add the poly data under @p object. @return false where there is data of another kind.
bool CollectLeaves(
  vtkDataObject* object, bool ownBlock, int& numberOfBlocks, std::vector<Leaf>& leaves, std::string& error)
{
  if (!object)
  {
    return true;
  }
  if (auto* polyData = vtkPolyData::SafeDownCast(object))
  {
    leaves.push_back({ polyData, ownBlock ? numberOfBlocks++ : numberOfBlocks });
    return true;
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    const bool pieces = vtkPartitionedDataSet::SafeDownCast(object) != nullptr;
    auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
    iterator->TraverseSubTreeOff();
    iterator->VisitOnlyLeavesOff();
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (!CollectLeaves(iterator->GetCurrentDataObject(), !pieces, numberOfBlocks, leaves, error))
      {
        return false;
      }
    }
    numberOfBlocks += pieces;
    return true;
  }
  error = "Block " + std::to_string(numberOfBlocks) + " is a " + object->GetClassName() +
    ": every block must be a vtkPolyData.";
  return false;
}

/// The polygons of all leaves as one mesh, and where each point and triangle comes from.
struct JoinedMesh
{
  TriangleMesh Mesh;
  std::vector<int> Blocks;            ///< one a triangle
  std::vector<int> TriangleLeaves;    ///< one a triangle; the cell is Mesh.SourceCells
  std::vector<vtkIdType> PointBegins; ///< of each leaf in Mesh.Points, and the end
  vtkIdType TriangulatedPolygons = 0;
  vtkIdType DroppedPolygons = 0; ///< fewer than three corners
  vtkIdType IgnoredCells = 0;

  int LeafOfPoint(vtkIdType point) const
  {
    const auto next = std::upper_bound(this->PointBegins.begin(), this->PointBegins.end(), point);
    return static_cast<int>(next - this->PointBegins.begin()) - 1;
  }
};

void CountCells(vtkPolyData* input, JoinedMesh& joined)
{
  joined.IgnoredCells += input->GetNumberOfVerts() + input->GetNumberOfLines();
  for (vtkIdType i = 0; i < input->GetNumberOfPolys(); ++i)
  {
    const vtkIdType corners = input->GetPolys()->GetCellSize(i);
    joined.TriangulatedPolygons += corners > 3;
    joined.DroppedPolygons += corners < 3;
  }
  for (vtkIdType i = 0; i < input->GetNumberOfStrips(); ++i)
  {
    const vtkIdType corners = input->GetStrips()->GetCellSize(i);
    joined.TriangulatedPolygons += corners >= 3;
    joined.DroppedPolygons += corners < 3;
  }
}

bool JoinLeaves(const std::vector<Leaf>& leaves, JoinedMesh& joined, std::string& error)
{
  joined.PointBegins.push_back(0);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    TriangleMesh part;
    vtkPolyData* data = leaves[leaf].Data;
    if (!ReadTriangles(data, part, error) ||
      !CheckAttributes(data->GetPointData(), data->GetNumberOfPoints(), "point", error) ||
      !CheckAttributes(data->GetCellData(), data->GetNumberOfCells(), "cell", error))
    {
      error = leaves.size() > 1 ? "Block " + std::to_string(leaves[leaf].Block) + ": " + error : error;
      return false;
    }
    CountCells(data, joined);
    const vtkIdType firstPoint = joined.PointBegins.back();
    const std::size_t count = part.SourceCells.size();
    joined.PointBegins.push_back(firstPoint + static_cast<vtkIdType>(part.Points.size() / 3));
    part.OccluderIds.resize(count, 0); // no array: no receivers
    std::transform(part.Triangles.begin(), part.Triangles.end(), part.Triangles.begin(),
      [firstPoint](vtkIdType id) { return id + firstPoint; });
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(joined.Mesh.Points, part.Points);
    append(joined.Mesh.Triangles, part.Triangles);
    append(joined.Mesh.OccluderIds, part.OccluderIds);
    append(joined.Mesh.SourceCells, part.SourceCells);
    joined.Blocks.insert(joined.Blocks.end(), count, leaves[leaf].Block);
    joined.TriangleLeaves.insert(joined.TriangleLeaves.end(), count, static_cast<int>(leaf));
  }
  return true;
}

/// Attributes that all leaves have, ready to be copied.
template <typename GetAttributes>
void ShareAttributes(const std::vector<Leaf>& leaves, GetAttributes get, vtkIdType count, vtkDataSetAttributes* to,
  vtkDataSetAttributes::FieldList& shared)
{
  for (const Leaf& leaf : leaves)
  {
    shared.IntersectFieldList(get(leaf.Data));
  }
  to->CopyNormalsOff();
  to->CopyAllocate(shared, count);
  to->CopyNormalsOn();
}

/// Triangles [begin, end) with their points and the attributes that came with them.
void WriteTriangles(const std::vector<Leaf>& leaves, const JoinedMesh& joined, const OccluderTopology& topology,
  vtkIdType begin, vtkIdType end, vtkPolyData* output)
{
  // Leaves without cells have no arrays to share.
  vtkDataSetAttributes::FieldList sharedPointData;
  vtkDataSetAttributes::FieldList sharedCellData;
  std::vector<Leaf> filled;
  std::vector<int> number;
  for (const Leaf& leaf : leaves)
  {
    number.push_back(static_cast<int>(filled.size()));
    if (leaf.Data->GetNumberOfCells() > 0)
    {
      filled.push_back(leaf);
    }
  }
  ShareAttributes(
    filled, [](vtkPolyData* data) { return data->GetPointData(); }, 3 * (end - begin), output->GetPointData(),
    sharedPointData);
  ShareAttributes(
    filled, [](vtkPolyData* data) { return data->GetCellData(); }, end - begin, output->GetCellData(), sharedCellData);

  std::vector<vtkIdType> outputPoint(topology.Points.size(), -1);
  for (vtkIdType corner = 3 * begin; corner < 3 * end; ++corner)
  {
    outputPoint[topology.Triangles[corner]] = 0;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < topology.Points.size(); ++i)
  {
    if (outputPoint[i] == 0)
    {
      const vtkIdType source = topology.Points[i];
      const int leaf = joined.LeafOfPoint(source);
      outputPoint[i] = points->InsertNextPoint(joined.Mesh.Points.data() + 3 * source);
      output->GetPointData()->CopyData(sharedPointData, leaves[leaf].Data->GetPointData(), number[leaf],
        source - joined.PointBegins[leaf], outputPoint[i]);
    }
  }

  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(end - begin + 1);
  connectivity->SetNumberOfValues(3 * (end - begin));
  vtkNew<vtkIntArray> occluderIds;
  occluderIds->SetName("OccluderId");
  occluderIds->SetNumberOfTuples(end - begin);
  for (vtkIdType t = begin; t < end; ++t)
  {
    const vtkIdType source = topology.SourceTriangles[t];
    const int leaf = joined.TriangleLeaves[source];
    offsets->SetValue(t - begin, 3 * (t - begin));
    for (int k = 0; k < 3; ++k)
    {
      connectivity->SetValue(3 * (t - begin) + k, outputPoint[topology.Triangles[3 * t + k]]);
    }
    occluderIds->SetValue(t - begin, topology.OccluderIds[t]);
    output->GetCellData()->CopyData(
      sharedCellData, leaves[leaf].Data->GetCellData(), number[leaf], joined.Mesh.SourceCells[source], t - begin);
  }
  offsets->SetValue(end - begin, 3 * (end - begin));
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetCellData()->AddArray(occluderIds);
}

void WriteReport(const JoinedMesh& joined, const OccluderTopology& topology, vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  const auto add = [data](const char* name, vtkIdType value)
  { AddIntArray(data, name, 1, { static_cast<int>(value) }); };
  add("NumberOfOccluders", static_cast<vtkIdType>(topology.Closed.size()));
  add("TriangulatedPolygons", joined.TriangulatedPolygons);
  add("WeldedPoints", topology.WeldedPoints);
  add("DroppedCells", topology.DegenerateTriangles + topology.DuplicateTriangles + joined.DroppedPolygons);
  add("IgnoredCells", joined.IgnoredCells);
  add("FlippedTriangles", topology.FlippedTriangles);
  add("NonManifoldEdges", topology.NonManifoldEdges);
  add("BoundaryEdges", topology.BoundaryEdges);
  AddByteArray(data, "OccluderClosed", topology.Closed);
}

OccluderLabel LabelOf(int labelBy, vtkDataObject* input)
{
  if (labelBy == vtkLabelOccluders::AUTOMATIC)
  {
    const bool blocks = vtkDataObjectTree::SafeDownCast(input) && !vtkPartitionedDataSet::SafeDownCast(input);
    return blocks ? OccluderLabel::Block : OccluderLabel::Component;
  }
  return labelBy == vtkLabelOccluders::BLOCK ? OccluderLabel::Block
    : labelBy == vtkLabelOccluders::WHOLE    ? OccluderLabel::Whole
                                             : OccluderLabel::Component;
}

} // namespace

vtkStandardNewMacro(vtkLabelOccluders);

int vtkLabelOccluders::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  // The first type decides: with poly data first the executive would hand over one block at a time.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkLabelOccluders::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLabelOccluders::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Labels and winding need the whole mesh.
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

int vtkLabelOccluders::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);

  const auto fail = [this, output](const std::string& message)
  {
    output->Initialize();
    vtkErrorMacro(<< message);
    return 0;
  };
  if (this->LabelBy < AUTOMATIC || this->LabelBy > WHOLE)
  {
    return fail(
      "LabelBy is " + std::to_string(this->LabelBy) + ": it must be Automatic, Component, Block or Whole (0 to 3).");
  }
  if (!(this->WeldTolerance >= 0.0 && this->WeldTolerance <= 0.1))
  {
    return fail("WeldTolerance is " + std::to_string(this->WeldTolerance) + ": it must lie between 0 and 0.1.");
  }
  std::vector<Leaf> leaves;
  int numberOfBlocks = 0;
  JoinedMesh joined;
  std::string error;
  if (!CollectLeaves(input, true, numberOfBlocks, leaves, error) || !JoinLeaves(leaves, joined, error))
  {
    return fail(error);
  }
  const bool empty = joined.PointBegins.back() == 0 && joined.IgnoredCells == 0;
  if (joined.Mesh.SourceCells.empty() && !empty)
  {
    return fail("The mesh has no polygons: only polygons and strips cast shadows.");
  }

  OccluderTopologyOptions options;
  options.WeldTolerance = this->WeldTolerance;
  options.LabelBy = LabelOf(this->LabelBy, input);
  options.Orient = this->Orient;
  OccluderTopology topology;
  try
  {
    if (!BuildOccluderTopology(joined.Mesh.View(), joined.Blocks.data(), options, MonitorOf(this), topology))
    {
      output->Initialize();
      return 1; // aborted
    }
  }
  catch (const std::exception& exception)
  {
    return fail(exception.what());
  }
  if (topology.SourceTriangles.empty() && !empty)
  {
    return fail("No polygon of the mesh has an area: all " + std::to_string(topology.DegenerateTriangles) +
      " triangles are degenerate.");
  }

  const int piece = outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int pieces = std::max(1, outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const auto count = static_cast<vtkIdType>(topology.SourceTriangles.size());
  WriteTriangles(leaves, joined, topology, count * piece / pieces, count * (piece + 1) / pieces, output);
  WriteReport(joined, topology, output);
  return 1;
}

void vtkLabelOccluders::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelBy: " << this->LabelBy << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "Orient: " << (this->Orient ? "On" : "Off") << "\n";
}
