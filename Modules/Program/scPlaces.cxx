// SPDX-License-Identifier: BSD-3-Clause
#include "scPlaces.h"

#include "scFailure.h"
#include "scScene.h"
#include "scSentence.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLabelOccluders.h"
#include "vtkMeshFiles.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSceneDefaults.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace
{
using shadowcones::ExitUsage;
using shadowcones::Failure;
using shadowcones::PlaceOptions;
using shadowcones::ReadNumbers;
using shadowcones::Scene;
using shadowcones::Sentence;

bool EndsIn(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Points with a vertex each; all look the same way where @p facing has three numbers.
vtkSmartPointer<vtkDataSet> MakePoints(vtkPoints* points, const std::vector<double>& facing)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  if (!facing.empty())
  {
    const double length = std::sqrt(facing[0] * facing[0] + facing[1] * facing[1] + facing[2] * facing[2]);
    if (!(length > 0.0))
    {
      throw Failure("--facing: expected a direction x,y,z that is not 0,0,0", ExitUsage);
    }
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      normals->InsertNextTuple3(facing[0] / length, facing[1] / length, facing[2] / length);
    }
    data->GetPointData()->SetNormals(normals);
  }
  return data;
}

/// The parts of a line between commas, without blanks and quotation marks around them.
std::vector<std::string> PartsOf(const std::string& line)
{
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, ',');)
  {
    const std::size_t first = part.find_first_not_of(" \t\r\"");
    const std::size_t last = part.find_last_not_of(" \t\r\"");
    parts.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
  }
  return parts;
}

/// The rows of a table with columns x, y, z.
void ReadTable(const std::string& path, vtkPoints* points)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = PartsOf(line);
  std::size_t columns[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string name(1, static_cast<char>('x' + axis));
    columns[axis] = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    if (columns[axis] == names.size())
    {
      throw Failure(Sentence(path, ": expected columns named x, y and z in the first line; there is none named ", name));
    }
  }
  for (int row = 2; std::getline(file, line); ++row)
  {
    const std::vector<std::string> parts = PartsOf(line);
    double point[3];
    for (int axis = 0; axis < 3 && !parts.empty(); ++axis)
    {
      char* end = nullptr;
      const std::string text = columns[axis] < parts.size() ? parts[columns[axis]] : "";
      point[axis] = std::strtod(text.c_str(), &end);
      if (text.empty() || *end != '\0' || !std::isfinite(point[axis]))
      {
        throw Failure(
          Sentence(path, ": line ", row, ": expected a number in column ", names[columns[axis]], ", found '", text, "'"));
      }
    }
    if (!parts.empty())
    {
      points->InsertNextPoint(point);
    }
  }
}

/// A surface with normals of its faces; points are split where they differ.
vtkSmartPointer<vtkDataSet> WithNormals(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->ConsistencyOff();
  normals->SetFeatureAngle(30.0);
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkDataSet> MakeGrid(const PlaceOptions& options, const Scene& scene)
{
  const std::vector<double> numbers = ReadNumbers(options.Grid, 3, "--grid");
  double bounds[6];
  scene.Defaults->GetMediumBounds(bounds);
  std::copy(options.Bounds.begin(), options.Bounds.end(), bounds);
  auto grid = vtkSmartPointer<vtkImageData>::New();
  int size[3];
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(numbers[axis] >= 1.0 && numbers[axis] <= 4096.0))
    {
      throw Failure("--grid " + options.Grid + ": expected three whole numbers from 1 to 4096", ExitUsage);
    }
    size[axis] = static_cast<int>(numbers[axis]);
    spacing[axis] = (bounds[2 * axis + 1] - bounds[2 * axis]) / std::max(1, size[axis] - 1);
  }
  grid->SetDimensions(size);
  grid->SetOrigin(bounds[0], bounds[2], bounds[4]);
  grid->SetSpacing(spacing);
  return grid;
}

/// A level square below the mesh, which looks up.
vtkSmartPointer<vtkDataSet> MakeGround(const PlaceOptions& options, const Scene& scene)
{
  double bounds[6];
  scene.Occluders->GetOutput()->GetBounds(bounds);
  const int up = scene.Defaults->GetFoundUp() - 1;
  const int right = (up + 1) % 3;
  const int front = (up + 2) % 3;
  const bool automatic = options.Ground == "auto";
  const std::vector<double> numbers = automatic ? std::vector<double>() : ReadNumbers(options.Ground, 3, "--ground");
  const double height = automatic ? bounds[2 * up] : numbers[0];
  const double across = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  const double size = automatic ? 4.0 * across : numbers[1];
  // Asked before it becomes a whole number, which may not hold it.
  if (!(size > 0.0) || (!automatic && !(numbers[2] >= 2.0 && numbers[2] < 16386.0)))
  {
    throw Failure(
      "--ground " + options.Ground + ": expected height,size,points: a size above 0 and 2 to 16385 points a side",
      ExitUsage);
  }
  const int cells = automatic ? 128 : static_cast<int>(numbers[2]) - 1;
  double corner[3];
  corner[up] = height;
  corner[right] = 0.5 * (bounds[2 * right] + bounds[2 * right + 1] - size);
  corner[front] = 0.5 * (bounds[2 * front] + bounds[2 * front + 1] - size);
  double ends[2][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    ends[0][axis] = corner[axis] + (axis == right ? size : 0.0);
    ends[1][axis] = corner[axis] + (axis == front ? size : 0.0);
  }
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(corner);
  plane->SetPoint1(ends[0]);
  plane->SetPoint2(ends[1]);
  plane->SetResolution(cells, cells);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkDataSet> ReadPlaces(const PlaceOptions& options)
{
  if (EndsIn(options.File, ".csv"))
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    ReadTable(options.File, points);
    return MakePoints(points, options.Facing);
  }
  vtkNew<vtkMeshFiles> files;
  files->AddFileName(options.File);
  if (!files->Read())
  {
    throw Failure(files->GetError());
  }
  return WithNormals(files->GetMesh(0));
}
} // namespace

namespace shadowcones
{
std::vector<double> ReadNumbers(const std::string& text, std::size_t count, const std::string& option)
{
  std::vector<double> numbers;
  for (const char* at = text.c_str();;)
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(at, &end));
    if (end == at || (*end != ',' && *end != '\0') || !std::isfinite(numbers.back()))
    {
      numbers.clear();
      break;
    }
    if (*end == '\0')
    {
      break;
    }
    at = end + 1;
  }
  if (numbers.size() != count)
  {
    throw Failure(
      option + " " + text + ": expected " + std::to_string(count) + " numbers with commas between them", ExitUsage);
  }
  return numbers;
}

void AddPlaceOptions(CLI::App* command, PlaceOptions& options, bool surfaces)
{
  auto* file = command->add_option("--where", options.File,
    surfaces ? "Ask on the surface of a mesh file. Default: on the mesh itself"
             : "Ask at the points of a csv file (columns x, y, z) or of a mesh file. Default: on the mesh itself");
  file->check(CLI::ExistingFile);
  auto* ground = command->add_option("--ground", options.Ground,
    "Ask on a level square: height,size,points a side, or auto: below the mesh, 4 times as wide, 129 points a side");
  ground->excludes(file);
  if (surfaces)
  {
    return;
  }
  auto* points = command->add_option("--at", options.Points, "Ask at points, x,y,z each");
  points->excludes(file)->excludes(ground);
  auto* grid = command->add_option("--grid", options.Grid, "Ask at the points of a grid, nx,ny,nz of them");
  grid->excludes(file)->excludes(ground)->excludes(points);
  command->add_option("--bounds", options.Bounds, "The box of the grid: x,x,y,y,z,z. Default: that of the medium")
    ->delimiter(',')
    ->expected(6);
  command->add_option("--facing", options.Facing, "The side of points that light counts on, x,y,z. Default: every side")
    ->delimiter(',')
    ->expected(3);
}

vtkSmartPointer<vtkDataSet> FindPlaces(const PlaceOptions& options, const Scene& scene)
{
  if (!options.Points.empty())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const std::string& text : options.Points)
    {
      points->InsertNextPoint(ReadNumbers(text, 3, "--at").data());
    }
    return MakePoints(points, options.Facing);
  }
  return !options.File.empty() ? ReadPlaces(options)
    : !options.Grid.empty()    ? MakeGrid(options, scene)
    : !options.Ground.empty()  ? MakeGround(options, scene)
                               : WithNormals(scene.Occluders->GetOutput());
}
} // namespace shadowcones
