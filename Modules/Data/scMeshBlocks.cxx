// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshBlocks.h"

#include "scSentence.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace shadowcones
{
namespace
{

/// Walks through composite data.
class BlockCollector
{
public:
  explicit BlockCollector(std::vector<MeshBlock>& blocks)
    : Blocks(blocks)
  {
  }

  bool Collect(vtkDataObject* object, const std::string& name, bool ownBlock, std::string& error)
  {
    if (auto* polyData = vtkPolyData::SafeDownCast(object))
    {
      MeshBlock block;
      block.Data = polyData;
      block.Number = ownBlock ? this->NumberOfBlocks++ : this->NumberOfBlocks;
      block.Name = name;
      block.FirstPoint = this->NumberOfPoints;
      block.FirstCell = this->NumberOfCells;
      this->NumberOfPoints += polyData->GetNumberOfPoints();
      this->NumberOfCells += polyData->GetNumberOfCells();
      this->Blocks.push_back(block);
      return true;
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
    {
      return this->CollectTree(tree, name, error);
    }
    MeshBlock block;
    block.Number = this->NumberOfBlocks;
    block.Name = name;
    error = Sentence("Block ", block.Label(), " is a ", object->GetClassName(),
      ": every block must be a vtkPolyData. Run vtkDataSetSurfaceFilter on it first, or take it out.");
    return false;
  }

private:
  bool CollectTree(vtkDataObjectTree* tree, const std::string& name, std::string& error)
  {
    const bool pieces = vtkPartitionedDataSet::SafeDownCast(tree) != nullptr;
    auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
    iterator->TraverseSubTreeOff();
    iterator->VisitOnlyLeavesOff();
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const char* own =
        iterator->HasCurrentMetaData() ? iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
      const bool named = own && *own && !(pieces && !name.empty());
      if (!this->Collect(iterator->GetCurrentDataObject(), named ? own : name, !pieces, error))
      {
        return false;
      }
    }
    this->NumberOfBlocks += pieces;
    return true;
  }

  std::vector<MeshBlock>& Blocks;
  int NumberOfBlocks = 0;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
};

} // namespace

std::string MeshBlock::Label() const
{
  return this->Name.empty() ? std::to_string(this->Number) : Sentence(this->Number, " (\"", this->Name, "\")");
}

bool CollectBlocks(vtkDataObject* input, std::vector<MeshBlock>& blocks, std::string& error)
{
  blocks.clear();
  return !input || BlockCollector(blocks).Collect(input, std::string(), true, error);
}

bool HasBlocks(vtkDataObject* input)
{
  return vtkDataObjectTree::SafeDownCast(input) && !vtkPartitionedDataSet::SafeDownCast(input);
}

void AcceptBlocks(vtkInformation* portInformation)
{
  // The first type decides what the executive iterates over: with a composite first it would not for other ports.
  portInformation->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
}

} // namespace shadowcones
