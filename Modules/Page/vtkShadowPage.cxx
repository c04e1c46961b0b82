// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPage.h"

#include "scCellPoints.h"
#include "scPageTemplate.h"
#include "scPageViewer.h"
#include "scWholeFile.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConeSetGeometry.h"
#include "vtkDataArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <sstream>

vtkStandardNewMacro(vtkShadowPage);

namespace
{
/// RFC 4648.
std::string Base64(const void* data, std::size_t size)
{
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const unsigned char* bytes = static_cast<const unsigned char*>(data);
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for (std::size_t i = 0; i < size; i += 3)
  {
    const std::size_t left = size - i;
    const std::uint32_t word = (bytes[i] << 16) | (left > 1 ? bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
    text += letters[word >> 18];
    text += letters[(word >> 12) & 63];
    text += left > 1 ? letters[(word >> 6) & 63] : '=';
    text += left > 2 ? letters[word & 63] : '=';
  }
  return text;
}

template <typename Value>
std::string Base64(const std::vector<Value>& values)
{
  return Base64(values.data(), values.size() * sizeof(Value));
}

/// A string of JSON that may stand inside a script of HTML.
std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    const unsigned char code = static_cast<unsigned char>(letter);
    if (code < 0x20 || letter == '<' || letter == '"' || letter == '\\')
    {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", code);
      quoted += escape;
    }
    else
    {
      quoted += letter;
    }
  }
  return quoted + '"';
}

/// Text of HTML.
std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    escaped += letter == '<' ? "&lt;" : letter == '&' ? "&amp;" : std::string(1, letter);
  }
  return escaped;
}

/// Cells as vtk.js has them: for each the number of its points, then their indices.
std::string Cells(vtkCellArray* cells)
{
  std::vector<std::uint32_t> packed;
  packed.reserve(static_cast<std::size_t>(cells->GetNumberOfCells() + cells->GetNumberOfConnectivityIds()));
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(cell, size, points);
    packed.push_back(static_cast<std::uint32_t>(size));
    packed.insert(packed.end(), points, points + size);
  }
  return Base64(packed);
}

/// What is to be drawn of a data set: triangles, lines and vertices; a vertex a point where there is no cell.
void Draw(vtkDataSet* data, vtkPolyData* drawn)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  vtkNew<vtkTriangleFilter> triangles;
  surface->SetInputData(data);
  triangles->SetInputConnection(surface->GetOutputPort());
  triangles->Update();
  drawn->ShallowCopy(triangles->GetOutput());
  if (drawn->GetNumberOfCells() > 0 || data->GetNumberOfPoints() == 0)
  {
    return;
  }

  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, data->GetPoint(i));
    vertices->InsertNextCell(1, &i);
  }
  drawn->Initialize();
  drawn->SetPoints(points);
  drawn->SetVerts(vertices);
  drawn->GetPointData()->ShallowCopy(data->GetPointData());
}

/// The template with a text in place of each mark, @NAME@; what the texts say is left alone.
std::string Filled(const std::string& form, const std::map<std::string, std::string>& texts)
{
  std::string page;
  for (std::size_t at = 0; at < form.size();)
  {
    const std::size_t end = form[at] == '@' ? form.find('@', at + 1) : std::string::npos;
    const auto text = end == std::string::npos ? texts.end() : texts.find(form.substr(at, end + 1 - at));
    page += text == texts.end() ? std::string(1, form[at]) : text->second;
    at = text == texts.end() ? at + 1 : end + 1;
  }
  return page;
}

std::string Joined(const std::vector<std::string>& parts)
{
  std::string joined;
  for (const std::string& part : parts)
  {
    joined += (joined.empty() ? "" : ",\n") + part;
  }
  return joined;
}

std::string Tuple(const double (&values)[3])
{
  std::ostringstream text;
  text << '[' << values[0] << ',' << values[1] << ',' << values[2] << ']';
  return text.str();
}
} // namespace

std::string vtkShadowPage::MakeLayer(
  vtkDataSet* data, const std::string& name, const std::string& look, const std::string& array)
{
  std::string fault;
  if (!shadowcones::CheckCellPoints(data, fault))
  {
    vtkErrorMacro("'" << name << "' cannot be drawn. " << fault);
    return {};
  }
  vtkNew<vtkPolyData> drawn;
  Draw(data, drawn);
  const vtkIdType number = drawn->GetNumberOfPoints();
  if (number == 0)
  {
    return {};
  }
  if (this->Layers.empty() && this->Steps.empty())
  {
    drawn->GetCenter(this->Middle);
  }

  std::vector<float> points(static_cast<std::size_t>(3 * number));
  for (vtkIdType i = 0; i < number; ++i)
  {
    double point[3];
    drawn->GetPoint(i, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      points[static_cast<std::size_t>(3 * i + axis)] = static_cast<float>(point[axis] - this->Middle[axis]);
    }
  }
  std::string layer = "{\"name\":" + Quoted(name) + look + ",\"points\":\"" + Base64(points) + '"';
  const std::pair<const char*, vtkCellArray*> kinds[] = { { "triangles", drawn->GetPolys() },
    { "lines", drawn->GetLines() }, { "vertices", drawn->GetVerts() } };
  for (const auto& [kind, cells] : kinds)
  {
    if (cells->GetNumberOfCells() > 0)
    {
      layer += std::string(",\"") + kind + "\":\"" + Cells(cells) + '"';
    }
  }

  if (!array.empty())
  {
    vtkDataArray* ofPoints = drawn->GetPointData()->GetArray(array.c_str());
    vtkDataArray* values = ofPoints ? ofPoints : drawn->GetCellData()->GetArray(array.c_str());
    std::vector<float> shown(static_cast<std::size_t>(values->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double value = values->GetComponent(i, 0);
      shown[static_cast<std::size_t>(i)] = static_cast<float>(value);
      if (std::isfinite(value))
      {
        const bool first = this->Range[0] > this->Range[1];
        this->Range[0] = first ? value : std::min(this->Range[0], value);
        this->Range[1] = first ? value : std::max(this->Range[1], value);
      }
    }
    layer +=
      std::string(",\"association\":\"") + (ofPoints ? "points" : "cells") + "\",\"values\":\"" + Base64(shown) + '"';
  }
  return layer + '}';
}

bool vtkShadowPage::AddMesh(
  vtkDataSet* mesh, const std::string& name, double red, double green, double blue, double opacity)
{
  if (!(opacity > 0.0 && opacity <= 1.0))
  {
    vtkErrorMacro("The opacity of '" << name << "' is " << opacity << ": it must be above 0 and at most 1.");
    return false;
  }
  std::ostringstream look;
  look << ",\"color\":[" << red << ',' << green << ',' << blue << "],\"opacity\":" << opacity;
  const std::string layer = mesh ? this->MakeLayer(mesh, name, look.str(), "") : std::string();
  if (layer.empty())
  {
    vtkErrorMacro("The mesh '" << name << "' has no points: there is nothing to show of it.");
    return false;
  }
  this->Layers.push_back(layer);
  this->Modified();
  return true;
}

bool vtkShadowPage::AddCones(vtkPolyData* cones, const std::string& name, double length)
{
  if (!cones || cones->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("The cone set '" << name << "' has no cones. Connect the output of vtkConeSetFilter.");
    return false;
  }
  vtkNew<vtkConeSetGeometry> geometry;
  geometry->SetInputData(cones);
  if (length > 0.0)
  {
    geometry->SetLength(length);
  }
  geometry->Update();
  return this->AddMesh(geometry->GetOutput(), name, 0.15, 0.35, 0.95, 0.25);
}

bool vtkShadowPage::AddAnswer(vtkDataSet* answer, const std::string& array, const std::string& label)
{
  const bool there =
    answer && (answer->GetPointData()->GetArray(array.c_str()) || answer->GetCellData()->GetArray(array.c_str()));
  if (!there)
  {
    vtkErrorMacro("The answer '" << label << "' has no point or cell array \"" << array
                                 << "\". Give it the output of vtkConeSetProbe, or the name of an array that it has.");
    return false;
  }
  if (!this->Steps.empty() && array != this->Quantity)
  {
    vtkErrorMacro("The answer '" << label << "' is to be coloured by \"" << array << "\", those before it by \""
                                 << this->Quantity << "\": one page has one legend.");
    return false;
  }
  const std::string layer = this->MakeLayer(answer, label, ",\"color\":[0,0,0],\"opacity\":1", array);
  if (layer.empty())
  {
    vtkErrorMacro("The answer '" << label << "' has no points: there is nothing to show of it.");
    return false;
  }
  this->Quantity = array;
  this->Steps.push_back(layer);
  this->Modified();
  return true;
}

void vtkShadowPage::Clear()
{
  this->Layers.clear();
  this->Steps.clear();
  this->Quantity.clear();
  this->Range[0] = 1.0;
  this->Range[1] = -1.0;
  this->Modified();
}

std::string vtkShadowPage::GetPage()
{
  if (this->Layers.empty() && this->Steps.empty())
  {
    return {};
  }
  std::ostringstream scene;
  scene.precision(9);
  scene << "{\"from\":" << Tuple(this->ViewDirection) << ",\"up\":" << Tuple(this->ViewUp);
  if (this->Range[0] <= this->Range[1])
  {
    // A legend of one colour says nothing, and no map can be made of it.
    const double high = this->Range[1] > this->Range[0] ? this->Range[1] : this->Range[0] + 1.0;
    scene << ",\"quantity\":" << Quoted(this->Quantity) << ",\"range\":[" << this->Range[0] << ',' << high << ']';
  }
  scene << ",\n\"layers\":[" << Joined(this->Layers) << "],\n\"steps\":[" << Joined(this->Steps) << "]}";

  return Filled(
    scPageTemplate, { { "@TITLE@", Escaped(this->Title) }, { "@SCENE@", scene.str() }, { "@VIEWER@", scPageViewer } });
}

bool vtkShadowPage::Write(const std::string& fileName)
{
  const std::string page = this->GetPage();
  if (page.empty())
  {
    vtkErrorMacro("There is nothing to write to '" << fileName << "': call AddMesh, AddCones or AddAnswer first.");
    return false;
  }
  if (!shadowcones::WriteWholeFile(fileName, page))
  {
    vtkErrorMacro("Cannot write '" << fileName << "': is the folder there, writable, and the disk not full?");
    return false;
  }
  return true;
}

void vtkShadowPage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->Title << '\n';
  os << indent << "ViewDirection: " << Tuple(this->ViewDirection) << '\n';
  os << indent << "ViewUp: " << Tuple(this->ViewUp) << '\n';
  os << indent << "Layers: " << this->Layers.size() << '\n';
  os << indent << "Steps: " << this->Steps.size() << '\n';
}
