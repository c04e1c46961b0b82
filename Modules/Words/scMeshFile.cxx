// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshFile.h"

#include "sc3dsFile.h"
#include "scCellPoints.h"
#include "scChildProcess.h"
#include "scMeshFormats.h"
#include "scSentence.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFieldData.h"
#include "vtkGLTFReader.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sys/stat.h>
#include <system_error>

namespace shadowcones
{

namespace
{

// Keeps the first error of all of VTK, without the place in VTK's sources that it comes from.
class ErrorKeeper : public vtkOutputWindow
{
public:
  static ErrorKeeper* New();
  vtkTypeMacro(ErrorKeeper, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (!this->Error.empty())
    {
      return;
    }
    this->Error = text;
    const std::size_t start = this->Error.find("): ");
    this->Error.erase(0, start == std::string::npos ? 0 : start + 3);
    this->Error.erase(std::min(this->Error.find('\n'), this->Error.size()));
    // Readers quote what they found, which may be any bytes.
    this->Error.resize(std::min<std::size_t>(this->Error.size(), 200));
    std::replace_if(
      this->Error.begin(), this->Error.end(), [](char c) { return c < 0x20 || c > 0x7E; }, '?');
    while (!this->Error.empty() && (this->Error.back() == ' ' || this->Error.back() == '.'))
    {
      this->Error.pop_back();
    }
  }
  std::string Error;
};
vtkStandardNewMacro(ErrorKeeper);

bool HaveTuples(vtkFieldData* data, vtkIdType tuples)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
    {
      return false;
    }
  }
  return true;
}

// What no filter may meet: cells of points that are not there, arrays that are too short.
std::string FaultOf(vtkDataObject* object)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      std::string fault = FaultOf(leaves->GetCurrentDataObject());
      if (!fault.empty())
      {
        return fault;
      }
    }
    return std::string();
  }
  auto* data = vtkDataSet::SafeDownCast(object);
  if (!data)
  {
    return object ? Sentence("it holds a ", object->GetClassName(), ", which has no surface") : "it holds nothing";
  }
  const vtkIdType points = data->GetNumberOfPoints();
  std::string fault;
  if (!CheckCellPoints(data, fault))
  {
    return "a cell uses a point that is not there";
  }
  return HaveTuples(data->GetPointData(), points) && HaveTuples(data->GetCellData(), data->GetNumberOfCells())
    ? std::string()
    : "an array has not one value for each point or cell";
}

template <typename Reader>
vtkSmartPointer<vtkDataObject> ReadBy(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkDataObject> ReadLegacy(const std::string& path)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkDataObject> ReadByVTK(const std::string& path, const std::string& format)
{
  return format == "vtp"                     ? ReadBy<vtkXMLPolyDataReader>(path)
    : format == "vtu"                        ? ReadBy<vtkXMLUnstructuredGridReader>(path)
    : format == "ply"                        ? ReadBy<vtkPLYReader>(path)
    : format == "stl"                        ? ReadBy<vtkSTLReader>(path)
    : format == "obj"                        ? ReadBy<vtkOBJReader>(path)
    : format == "gltf" || format == "glb"    ? ReadBy<vtkGLTFReader>(path)
                                             : ReadLegacy(path);
}

// First letters of what the process that reads answers.
constexpr char Bad = 'B';   // what is wrong
constexpr char Good = 'G';  // the data
constexpr char Large = 'L'; // the data are right, and too large for one message

std::string ReadAndTell(const std::string& path, const std::string& format)
{
  vtkNew<ErrorKeeper> keeper;
  vtkOutputWindow::SetInstance(keeper);
  vtkObject::GlobalWarningDisplayOn();
  const vtkSmartPointer<vtkDataObject> data = ReadByVTK(path, format);
  const std::string fault = keeper->Error.empty() ? FaultOf(data) : keeper->Error;
  if (!fault.empty())
  {
    return Bad + fault;
  }
  if (data->GetActualMemorySize() > 1000000) // KiB; messages have 2 GiB at most
  {
    return std::string(1, Large);
  }
  vtkNew<vtkCharArray> message;
  vtkCommunicator::MarshalDataObject(data, message);
  return Good + std::string(message->GetPointer(0), static_cast<std::size_t>(message->GetNumberOfValues()));
}

vtkSmartPointer<vtkDataObject> ReadInChild(
  const std::string& path, const std::string& format, std::int64_t size, std::string& error)
{
  ChildLimits limits;
  limits.Seconds = 30.0 + 1e-6 * static_cast<double>(size);
  limits.Memory = (std::int64_t(2) << 30) + 100 * size;
  std::string answer;
  const ChildEnd end = RunInChild([&]() { return ReadAndTell(path, format); }, limits, answer);
  if (end == ChildEnd::TimedOut)
  {
    error = Sentence("reading did not end within ", static_cast<int>(limits.Seconds), " seconds");
  }
  else if (end == ChildEnd::NotBegun)
  {
    error = "the system has no process or memory left for it";
  }
  else if (end == ChildEnd::Crashed || answer.empty())
  {
    error = "the file is damaged, or not of this format";
  }
  else if (answer.front() == Bad)
  {
    error = answer.substr(1);
  }
  if (!error.empty())
  {
    return nullptr;
  }
  if (answer.front() == Large)
  {
    return ReadByVTK(path, format);
  }
  vtkNew<vtkCharArray> message;
  message->SetArray(&answer[1], static_cast<vtkIdType>(answer.size() - 1), 1);
  return vtkCommunicator::UnMarshalDataObject(message);
}

vtkSmartPointer<vtkDataObject> Read3ds(const std::string& path, std::string& error)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  Mesh3ds mesh;
  if (!Parse3ds(bytes, mesh, error))
  {
    return nullptr;
  }
  vtkNew<vtkPoints> points;
  for (const auto& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : mesh.Triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* object)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(object))
  {
    return mesh;
  }
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    vtkNew<vtkAppendPolyData> append;
    auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      append->AddInputData(SurfaceOf(leaves->GetCurrentDataObject()));
    }
    if (append->GetNumberOfInputConnections(0) > 0)
    {
      append->Update();
    }
    return append->GetOutput();
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(object);
  surface->Update();
  return surface->GetOutput();
}

bool HasStumps(vtkCellArray* cells)
{
  for (vtkIdType k = 0; cells && k < cells->GetNumberOfCells(); ++k)
  {
    if (cells->GetCellSize(k) < 3)
    {
      return true;
    }
  }
  return false;
}

// Without polygons and strips of fewer than three corners: they cover nothing, and VTK 9.1 ends where it is asked for one of them.
vtkSmartPointer<vtkPolyData> WithoutStumps(vtkPolyData* mesh)
{
  if (!HasStumps(mesh->GetPolys()) && !HasStumps(mesh->GetStrips()))
  {
    return mesh;
  }
  vtkNew<vtkPolyData> whole;
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkNew<vtkIdList> kept;
  for (vtkIdType k = 0; k < cell; ++k)
  {
    kept->InsertNextId(k);
  }
  const auto copy = [&](vtkCellArray* from, vtkCellArray* to)
  {
    for (vtkIdType k = 0; k < from->GetNumberOfCells(); ++k, ++cell)
    {
      vtkIdType corners = 0;
      const vtkIdType* ids = nullptr;
      from->GetCellAtId(k, corners, ids);
      if (corners >= 3)
      {
        to->InsertNextCell(corners, ids);
        kept->InsertNextId(cell);
      }
    }
  };
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  copy(mesh->GetPolys(), polys);
  copy(mesh->GetStrips(), strips);
  whole->SetPoints(mesh->GetPoints());
  whole->SetVerts(mesh->GetVerts());
  whole->SetLines(mesh->GetLines());
  whole->SetPolys(polys);
  whole->SetStrips(strips);
  whole->GetPointData()->ShallowCopy(mesh->GetPointData());
  whole->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  whole->GetCellData()->CopyAllOn();
  whole->GetCellData()->CopyAllocate(mesh->GetCellData(), kept->GetNumberOfIds());
  for (vtkIdType k = 0; k < kept->GetNumberOfIds(); ++k)
  {
    whole->GetCellData()->CopyData(mesh->GetCellData(), kept->GetId(k), k);
  }
  return whole;
}

std::string CannotBeOpened(const std::string& path)
{
  return Sentence("\"", path, "\" cannot be opened: ", std::generic_category().message(errno), ".");
}

// What is wrong with the file before it is opened; its size in bytes.
std::string FaultOfFile(const std::string& path, std::int64_t& size)
{
  struct stat status;
  if (stat(path.c_str(), &status) != 0)
  {
    return errno == ENOENT || errno == ENOTDIR ? Sentence("There is no file \"", path, "\".") : CannotBeOpened(path);
  }
  size = status.st_size;
  if (!S_ISREG(status.st_mode))
  {
    return Sentence("\"", path, "\" is no file that can be read: is it a folder?");
  }
  if (!std::ifstream(path))
  {
    return CannotBeOpened(path);
  }
  return size == 0 ? Sentence("\"", path, "\" is empty.") : std::string();
}

std::string AllFormats()
{
  std::string list;
  for (const std::string& format : MeshFormats())
  {
    list += (list.empty() ? "" : ", ") + format;
  }
  return list;
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadMeshFile(const std::string& path, std::string& error)
{
  std::int64_t size = 0;
  error = FaultOfFile(path, size);
  if (error.empty() && !IsMeshFileName(path))
  {
    error = Sentence("\"", path, "\" is of no format that is read. Known are ", AllFormats(), ".");
  }
  if (!error.empty())
  {
    return nullptr;
  }
  const std::string format = ExtensionOf(path);
  const vtkSmartPointer<vtkDataObject> data =
    format == "3ds" ? Read3ds(path, error) : ReadInChild(path, format, size, error);
  if (!data)
  {
    error = Sentence("\"", path, "\" cannot be read as ", format, ": ", error, ".");
    return nullptr;
  }
  vtkSmartPointer<vtkPolyData> mesh = WithoutStumps(SurfaceOf(data));
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    error = Sentence("\"", path, "\" has no polygons: nothing in it casts a shadow or shines.");
    return nullptr;
  }
  return mesh;
}

} // namespace shadowcones
