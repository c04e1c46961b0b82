// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshFiles.h"

#include "scMeshFile.h"
#include "scMeshFormats.h"
#include "vtkLabelOccluders.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkMeshFiles);

vtkMeshFiles::vtkMeshFiles()
  : Output(vtkSmartPointer<vtkMultiBlockDataSet>::New())
{
}

vtkMeshFiles::~vtkMeshFiles() = default;

void vtkMeshFiles::AddFileName(const std::string& name)
{
  this->FileNames.push_back(name);
  this->Modified();
}

void vtkMeshFiles::RemoveAllFileNames()
{
  this->FileNames.clear();
  this->Modified();
}

int vtkMeshFiles::GetNumberOfFileNames()
{
  return static_cast<int>(this->FileNames.size());
}

std::string vtkMeshFiles::GetFileName(int index)
{
  return index >= 0 && index < this->GetNumberOfFileNames() ? this->FileNames[index] : std::string();
}

std::string vtkMeshFiles::FreeName(const std::string& path) const
{
  const std::string stem = shadowcones::StemOf(path);
  std::string name = stem;
  for (int number = 2; std::find(this->Names.begin(), this->Names.end(), name) != this->Names.end(); ++number)
  {
    name = stem + " " + std::to_string(number);
  }
  return name;
}

bool vtkMeshFiles::Read()
{
  this->Names.clear();
  this->Meshes.clear();
  this->Error = this->FileNames.empty() ? "There is no mesh file to read." : "";
  try
  {
    for (const std::string& path : this->FileNames)
    {
      const vtkSmartPointer<vtkPolyData> mesh =
        this->Error.empty() ? shadowcones::ReadMeshFile(path, this->Error) : nullptr;
      if (mesh)
      {
        this->Names.push_back(this->FreeName(path));
        this->Meshes.push_back(mesh);
      }
    }
  }
  catch (const std::bad_alloc&)
  {
    this->Error = "There is not enough memory for the meshes of these files.";
  }
  if (!this->Error.empty())
  {
    this->Names.clear();
    this->Meshes.clear();
  }
  this->Output = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < this->Meshes.size(); ++i)
  {
    this->Output->SetBlock(i, this->Meshes[i]);
    this->Output->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), this->Names[i].c_str());
  }
  return this->Error.empty();
}

vtkMultiBlockDataSet* vtkMeshFiles::GetOutput()
{
  return this->Output;
}

vtkPolyData* vtkMeshFiles::GetMesh(int index)
{
  return index >= 0 && index < static_cast<int>(this->Meshes.size()) ? this->Meshes[index].Get() : nullptr;
}

std::string vtkMeshFiles::GetName(int index)
{
  return index >= 0 && index < static_cast<int>(this->Names.size()) ? this->Names[index] : std::string();
}

void vtkMeshFiles::LabelOccluders(vtkLabelOccluders* occluders)
{
  const bool alone = this->Meshes.size() == 1;
  const bool byFile = this->OccludersBy == File || (this->OccludersBy == Automatic && !alone);
  if (alone && !byFile)
  {
    // Without its block, so that components have numbers for names and not all the same one.
    occluders->SetInputDataObject(this->Meshes.front());
  }
  else
  {
    occluders->SetInputDataObject(this->Output);
  }
  const bool hasIds = alone && this->Meshes.front()->GetCellData()->HasArray("OccluderId");
  occluders->SetLabelBy(byFile                        ? vtkLabelOccluders::Block
      : hasIds && this->OccludersBy == Automatic      ? vtkLabelOccluders::Array
                                                      : vtkLabelOccluders::Component);
}

bool vtkMeshFiles::IsMeshFileName(const std::string& name)
{
  return shadowcones::IsMeshFileName(name);
}

std::string vtkMeshFiles::GetFormats()
{
  std::string list;
  for (const std::string& format : shadowcones::MeshFormats())
  {
    list += (list.empty() ? "" : ", ") + format;
  }
  return list;
}

void vtkMeshFiles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames:";
  for (const std::string& name : this->FileNames)
  {
    os << " \"" << name << "\"";
  }
  os << "\n";
  os << indent << "OccludersBy: " << this->OccludersBy << "\n";
  os << indent << "NumberOfMeshes: " << this->Meshes.size() << "\n";
  os << indent << "Error: " << this->Error << "\n";
}
