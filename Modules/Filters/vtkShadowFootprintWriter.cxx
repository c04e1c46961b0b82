// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFootprintWriter.h"

#include "scFootprintData.h"
#include "scOccluderNames.h"
#include "scWholeFile.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

// Headers of later VTKs rename VTK's own copy of the library for all that come after them: then that one it is.
#ifdef VTK_NLOHMANN_JSON
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

using namespace shadowcones;
using Json = nlohmann::ordered_json;

vtkStandardNewMacro(vtkShadowFootprintWriter);

namespace
{
/// Twice the area seen from above; positive where it runs counter-clockwise.
double TwiceArea(const std::vector<Vector3>& ring)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    // From the first point, so that large coordinates do not cancel.
    const Vector3 a = ring[k] - ring[0];
    const Vector3 b = ring[(k + 1) % ring.size()] - ring[0];
    sum += a.X * b.Y - a.Y * b.X;
  }
  return sum;
}

/// Does a ring hold a point, seen from above?
bool Holds(const std::vector<Vector3>& ring, const Vector3& p)
{
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    const Vector3& a = ring[k];
    const Vector3& b = ring[(k + 1) % ring.size()];
    if ((a.Y > p.Y) != (b.Y > p.Y) && p.X < a.X + (p.Y - a.Y) / (b.Y - a.Y) * (b.X - a.X))
    {
      inside = !inside;
    }
  }
  return inside;
}

/// Rings of one light, occluder and class: which are holes, and of which.
struct Nesting
{
  std::vector<const OutlineRing*> Rings;

  std::vector<int> Depths() const
  {
    std::vector<int> depths;
    for (const OutlineRing* ring : this->Rings)
    {
      depths.push_back(static_cast<int>(std::count_if(this->Rings.begin(), this->Rings.end(),
        [ring](const OutlineRing* other) { return other != ring && Holds(other->Points, ring->Points.front()); })));
    }
    return depths;
  }
  /// The holes of an outer ring: those one deeper that lie in it.
  std::vector<std::size_t> HolesOf(std::size_t outer, const std::vector<int>& depths) const
  {
    std::vector<std::size_t> holes;
    for (std::size_t k = 0; k < this->Rings.size(); ++k)
    {
      if (depths[k] == depths[outer] + 1 && Holds(this->Rings[outer]->Points, this->Rings[k]->Points.front()))
      {
        holes.push_back(k);
      }
    }
    return holes;
  }
};

/// A ring that turns as it should, its first point again at its end.
Json RingOf(const OutlineRing& outline, bool counterClockwise, bool withHeights)
{
  std::vector<Vector3> points = outline.Points;
  if ((TwiceArea(points) > 0.0) != counterClockwise)
  {
    std::reverse(points.begin() + 1, points.end());
  }
  points.push_back(points.front());
  Json ring = Json::array();
  for (const Vector3& p : points)
  {
    ring.push_back(withHeights ? Json::array({ p.X, p.Y, p.Z }) : Json::array({ p.X, p.Y }));
  }
  return ring;
}

Json FeatureOf(const Nesting& group, std::size_t outer, const std::vector<int>& depths,
  const std::vector<std::string>& names, bool withHeights)
{
  const OutlineRing& outline = *group.Rings[outer];
  Json rings = Json::array({ RingOf(outline, true, withHeights) });
  double area = 0.5 * std::fabs(TwiceArea(outline.Points));
  for (const std::size_t hole : group.HolesOf(outer, depths))
  {
    rings.push_back(RingOf(*group.Rings[hole], false, withHeights));
    area -= 0.5 * std::fabs(TwiceArea(group.Rings[hole]->Points));
  }
  Json properties;
  if (outline.OccluderId >= 0 && static_cast<std::size_t>(outline.OccluderId) < names.size())
  {
    properties["OccluderName"] = names[static_cast<std::size_t>(outline.OccluderId)];
  }
  properties["OccluderId"] = outline.OccluderId;
  properties["LightId"] = outline.LightId;
  properties["ShadowClass"] = outline.ShadowClass;
  properties["Shadow"] = outline.ShadowClass == 2 ? "umbra" : "whole shadow";
  properties["Area"] = area;
  return { { "type", "Feature" }, { "properties", properties },
    { "geometry", { { "type", "Polygon" }, { "coordinates", rings } } } };
}

/// All polygons of the outlines; @p leftOut those that are open or have no area.
Json CollectionOf(const std::vector<OutlineRing>& outlines, const std::vector<std::string>& names, vtkIdType& leftOut)
{
  bool withHeights = false;
  leftOut = 0;
  std::map<std::tuple<int, int, int>, Nesting> groups;
  for (const OutlineRing& outline : outlines)
  {
    if (!outline.Closed || outline.Points.size() < 3 || TwiceArea(outline.Points) == 0.0)
    {
      ++leftOut;
      continue;
    }
    groups[{ outline.LightId, outline.OccluderId, outline.ShadowClass }].Rings.push_back(&outline);
    withHeights = withHeights ||
      std::any_of(outline.Points.begin(), outline.Points.end(), [](const Vector3& p) { return p.Z != 0.0; });
  }
  Json features = Json::array();
  for (const auto& [key, group] : groups)
  {
    const std::vector<int> depths = group.Depths();
    for (std::size_t k = 0; k < depths.size(); ++k)
    {
      if (depths[k] % 2 == 0)
      {
        features.push_back(FeatureOf(group, k, depths, names, withHeights));
      }
    }
  }
  return { { "type", "FeatureCollection" }, { "features", features } };
}
} // anonymous namespace

vtkShadowFootprintWriter::~vtkShadowFootprintWriter()
{
  delete[] this->FileName;
}

int vtkShadowFootprintWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkShadowFootprintWriter::WriteData()
{
  auto* input = vtkPolyData::SafeDownCast(this->GetInput());
  std::vector<OutlineRing> outlines;
  std::string error;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no FileName to write to: set it.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  if (!ReadOutlines(input, outlines, error))
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  vtkIdType leftOut = 0;
  const Json collection = CollectionOf(outlines, ReadOccluderNames(input->GetFieldData()), leftOut);
  // Names that are no UTF-8 keep what can be kept of them.
  if (!WriteWholeFile(this->FileName, collection.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"))
  {
    vtkErrorMacro("The file \"" << this->FileName
                                << "\" cannot be written: is there such a folder, may it be written to, "
                                   "and is there room left?");
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    return;
  }
  if (leftOut > 0)
  {
    vtkWarningMacro(<< leftOut << " of " << outlines.size()
                    << " outlines are left out: they are open, or have no area seen from above.");
  }
}

void vtkShadowFootprintWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
