// SPDX-License-Identifier: BSD-3-Clause
#include "scOutputFile.h"

#include "scFailure.h"
#include "vtkCellCenters.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDelimitedTextWriter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkStringArray.h"
#include "vtkTIFFWriter.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <memory>
#include <system_error>

namespace
{
using shadowcones::FileKind;

std::string ExtensionOf(const std::string& path)
{
  const std::size_t dot = path.find_last_of("./");
  std::string extension = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot + 1);
  for (char& letter : extension)
  {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return extension == "tiff" ? "tif" : extension;
}

const char* ExtensionsOf(FileKind kind)
{
  return kind == FileKind::Points ? "csv, vtp, vti"
    : kind == FileKind::Surface   ? "stl, ply, obj, vtp"
                                  : "png, tif, vti";
}

/// The name of the file beside, of the same extension: some of VTK's writers look at it.
std::string Beside(const std::string& path)
{
  const std::size_t slash = path.rfind('/') + 1; // 0 where there is none
  return path.substr(0, slash) + ".part-" + path.substr(slash);
}

template <typename Writer>
bool WriteBy(vtkDataObject* data, const std::string& path)
{
  vtkNew<Writer> writer;
  writer->SetInputDataObject(data);
  writer->SetFileName(path.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

bool WriteText(const std::string& text, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return static_cast<bool>(file);
}

bool WriteAs(const std::string& extension, vtkDataObject* data, const std::string& path)
{
  return extension == "vtp" ? WriteBy<vtkXMLPolyDataWriter>(data, path)
    : extension == "vti"    ? WriteBy<vtkXMLImageDataWriter>(data, path)
    : extension == "stl"    ? WriteBy<vtkSTLWriter>(data, path)
    : extension == "ply"    ? WriteBy<vtkPLYWriter>(data, path)
    : extension == "obj"    ? WriteBy<vtkOBJWriter>(data, path)
    : extension == "png"    ? WriteBy<vtkPNGWriter>(data, path)
    : extension == "tif"    ? WriteBy<vtkTIFFWriter>(data, path)
                            : WriteText(shadowcones::MakeTable(data, false), path);
}

/// Codes as numbers: a table would write them as letters.
vtkSmartPointer<vtkAbstractArray> AsNumbers(vtkUnsignedCharArray* codes)
{
  auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->DeepCopy(codes);
  numbers->SetName(codes->GetName());
  return numbers;
}

/// The name of the occluder in each row, where a table tells of occluders that have names.
vtkSmartPointer<vtkStringArray> NamesOf(vtkDataObject* data, vtkDataArray* ids)
{
  auto* names = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("OccluderNames"));
  if (!names || !ids || ids->GetNumberOfComponents() != 1)
  {
    return nullptr;
  }
  auto column = vtkSmartPointer<vtkStringArray>::New();
  column->SetName("OccluderName");
  for (vtkIdType row = 0; row < ids->GetNumberOfTuples(); ++row)
  {
    const vtkIdType id = static_cast<vtkIdType>(ids->GetComponent(row, 0));
    column->InsertNextValue(id >= 0 && id < names->GetNumberOfValues() ? names->GetValue(id) : "");
  }
  return column;
}
} // namespace

namespace shadowcones
{
void CheckOutput(const std::string& path, FileKind kind)
{
  const std::string extension = ExtensionOf(path);
  const std::string known = ExtensionsOf(kind);
  if (extension.empty() || (", " + known + ",").find(", " + extension + ",") == std::string::npos)
  {
    throw Failure("-o " + path + ": expected a name that ends in one of " + known, ExitUsage);
  }
  const std::string beside = Beside(path);
  std::FILE* file = std::fopen(beside.c_str(), "wb");
  if (!file)
  {
    throw Failure("-o " + path + ": cannot be written: " + std::generic_category().message(errno));
  }
  std::fclose(file);
  std::remove(beside.c_str());
}

void WriteBeside(const std::string& path, const std::function<bool(const std::string&)>& write)
{
  const std::string beside = Beside(path);
  if (!write(beside) || std::rename(beside.c_str(), path.c_str()) != 0)
  {
    std::remove(beside.c_str());
    throw Failure(path + ": cannot be written; is the disk full? What was there before is as it was");
  }
}

void WriteOutput(vtkDataObject* data, const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  const bool isImage = vtkImageData::SafeDownCast(data) != nullptr;
  if ((extension == "vti" && !isImage) || (extension == "vtp" && isImage))
  {
    throw Failure(
      "-o " + path + ": " + (isImage ? "a grid is written as vti or csv" : "points are written as vtp or csv"),
      ExitUsage);
  }
  WriteBeside(path, [&](const std::string& beside) { return WriteAs(extension, data, beside); });
}

std::string MakeTable(vtkDataObject* data, bool cells)
{
  vtkNew<vtkCellCenters> centers;
  if (cells)
  {
    centers->SetInputDataObject(data);
    centers->Update();
  }
  vtkDataSet* points = cells ? centers->GetOutput() : vtkDataSet::SafeDownCast(data);
  vtkNew<vtkTable> table;
  static const char* const axes[] = { "x", "y", "z" };
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(axes[axis]);
    column->SetNumberOfValues(points->GetNumberOfPoints());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      column->SetValue(i, points->GetPoint(i)[axis]);
    }
    table->AddColumn(column);
  }
  for (int i = 0; i < points->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = points->GetPointData()->GetAbstractArray(i);
    auto* codes = vtkUnsignedCharArray::SafeDownCast(array);
    table->AddColumn(codes ? AsNumbers(codes).Get() : array);
  }
  if (const auto names = NamesOf(data, points->GetPointData()->GetArray("OccluderId")))
  {
    table->AddColumn(names);
  }
  vtkNew<vtkDelimitedTextWriter> writer;
  writer->SetInputData(table);
  writer->SetUseStringDelimiter(false);
  writer->WriteToOutputStringOn();
  writer->Write();
  const std::unique_ptr<char[]> text(writer->RegisterAndGetOutputString());
  return text ? text.get() : "";
}
} // namespace shadowcones
