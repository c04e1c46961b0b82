// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolume.h"

#include "scConeData.h"
#include "scConeDistanceField.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scOptionalBounds.h"
#include "scParameterRanges.h"
#include "scRegularGrid.h"
#include "scSentence.h"
#include "scUmbraField.h"
#include "scWarnings.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

namespace
{
using namespace shadowcones;

constexpr vtkIdType largestNumberOfSamples = vtkIdType(1) << 28;
/// A surface keeps this share of a cell away from grid points: neighbours of a point then have room for triangles.
constexpr double smallestShare = 0.02;
/// Cells smaller than this share of their coordinates lose their digits.
constexpr double smallestCell = 1e-13;

/// What a surface bounds the shadow of: a light, and an occluder or -1 for all.
using SurfaceKey = std::pair<int, int>;
/// Cones of one surface each, in ascending order of their keys.
using Groups = std::vector<std::pair<SurfaceKey, std::vector<Cone>>>;

Groups GroupCones(const std::vector<Cone>& cones, bool perOccluder)
{
  std::map<SurfaceKey, std::vector<Cone>> groups;
  for (const Cone& cone : cones)
  {
    groups[{ cone.LightId, perOccluder ? cone.OccluderId : -1 }].push_back(cone);
  }
  return { groups.begin(), groups.end() };
}

/// Collects closed surfaces.
class SolidBuilder
{
public:
  /// Contour the field's zero; @p values is changed.
  void AddSurface(const RegularGrid& grid, std::vector<float>& values, const SurfaceKey& key)
  {
    const double nearest = smallestShare * std::min({ grid.Spacing.X, grid.Spacing.Y, grid.Spacing.Z });
    for (float& value : values)
    {
      value = static_cast<float>(value < 0.0f ? std::min<double>(value, -nearest) : std::max<double>(value, nearest));
    }
    vtkNew<vtkFloatArray> scalars;
    scalars->SetArray(values.data(), static_cast<vtkIdType>(values.size()), 1);
    vtkNew<vtkImageData> image; // in units of cells: its points are in single precision
    image->SetDimensions(grid.Dimensions.data());
    image->GetPointData()->SetScalars(scalars);
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0.0);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    this->Append(contour->GetOutput(), grid, key);
  }

  /// Did the last occluder with triangles have this id?
  bool EndsWith(int occluderId) const { return !this->OccluderIds.empty() && this->OccluderIds.back() == occluderId; }

  void Finish(vtkPolyData* output, vtkFieldData* fieldData)
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Triangles);
    AddIntArray(output->GetCellData(), "OccluderId", 1, this->OccluderIds);
    AddIntArray(output->GetCellData(), "LightId", 1, this->LightIds);
    output->GetFieldData()->PassData(fieldData);
  }

  SolidBuilder() { this->Points->SetDataTypeToDouble(); }

private:
  void Append(vtkPolyData* surface, const RegularGrid& grid, const SurfaceKey& key)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      this->Points->InsertNextPoint(grid.Origin.X + p[0] * grid.Spacing.X, grid.Origin.Y + p[1] * grid.Spacing.Y,
        grid.Origin.Z + p[2] * grid.Spacing.Z);
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    vtkCellArray* triangles = surface->GetPolys();
    for (triangles->InitTraversal(); triangles->GetNextCell(count, ids);)
    {
      // The contour faces the way the field falls, which is inward.
      const vtkIdType triangle[3] = { first + ids[0], first + ids[2], first + ids[1] };
      this->Triangles->InsertNextCell(3, triangle);
      this->LightIds.push_back(key.first);
      this->OccluderIds.push_back(key.second);
    }
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  std::vector<int> OccluderIds;
  std::vector<int> LightIds;
};

/// What a grid over the region would need that cannot be had; empty where it can.
std::string CheckRegion(const Box& region, int resolution)
{
  std::ostringstream fault;
  const Vector3 size = region.Size();
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({ largest, std::abs(region.Min[axis]), std::abs(region.Max[axis]) });
  }
  const double cell = std::max({ size.X, size.Y, size.Z }) / resolution;
  if (!std::isfinite(region.Diagonal()) || !(cell > smallestCell * largest))
  {
    fault << "cells of " << cell << " at coordinates up to " << largest
          << ", beyond double precision: set Bounds or Length.";
    return fault.str();
  }
  const vtkIdType samples = GridOver(region, resolution).NumberOfPoints();
  if (samples > largestNumberOfSamples)
  {
    fault << samples << " samples at Resolution " << resolution << ", more than " << largestNumberOfSamples
          << ": lower Resolution.";
  }
  return fault.str();
}

/// A region to contour, and the field in it.
struct Solid
{
  Box Region;
  std::function<bool(const RegularGrid& grid, const Monitor& monitor, float* values)> Sample;
};

Solid UnionOfCones(const std::vector<Cone>& cones, ConeBound bound, double length, const Box& bounds)
{
  const ConeDistanceField field(cones, bound, length, bounds);
  return { field.Region(), [field](const RegularGrid& grid, const Monitor& monitor, float* values) {
            return field.Sample(grid, monitor, values);
          } };
}

/// What the discs hide together, or one alone. Looked for with half of the resolution first: it may fill a small part
/// of the region.
Solid JointUmbra(const std::vector<Cone>& cones, const Light& light, double length, const Box& bounds, int resolution,
  const Monitor& monitor)
{
  const UmbraField field(cones, light, length, bounds);
  const ConeDistanceField inner(cones, ConeBound::Inner, length, bounds);
  Solid solid;
  solid.Region = field.Region();
  if (!solid.Region.Empty() && CheckRegion(solid.Region, resolution).empty())
  {
    solid.Region = field.Find(solid.Region, (resolution + 1) / 2, monitor);
  }
  if (!inner.Region().Empty())
  {
    solid.Region.Add(inner.Region());
  }
  solid.Sample = [field, inner, region = solid.Region](const RegularGrid& grid, const Monitor& part, float* values)
  {
    std::vector<float> alone(static_cast<std::size_t>(grid.NumberOfPoints()));
    if (!field.Sample(grid, region, part, values) || !inner.Sample(grid, Monitor{ {}, part.Aborted }, alone.data()))
    {
      return false;
    }
    std::transform(alone.begin(), alone.end(), values, values, [](float a, float b) { return std::min(a, b); });
    return true;
  };
  return solid;
}

/// The exact shape of every light that cones are of, from the field data of the cone set.
bool ReadLightsOf(vtkPolyData* coneSet, const std::vector<Cone>& cones, std::vector<Light>& lights, std::string& error)
{
  if (!ReadLightShapes(coneSet->GetFieldData(), lights, error))
  {
    return false;
  }
  const bool known = std::all_of(cones.begin(), cones.end(),
    [&](const Cone& cone)
    {
      const auto id = static_cast<std::size_t>(cone.LightId);
      return cone.LightId >= 0 && id < lights.size() && lights[id].Shape != LightShape::Mesh;
    });
  if (!known)
  {
    error = "Umbra is BaseDiscs, but the field data of the cone set does not carry the light (\"LightShape\"): use "
            "InnerCones, or cones of a light of vtkAreaLightSource.";
  }
  return known;
}

/// Sample a solid and add its surface. @return false, with what it needs in @p error where it is too large, or aborted.
bool Contour(const Solid& solid, const SurfaceKey& occluder, int resolution, const Monitor& monitor,
  SolidBuilder& surfaces, std::string& error)
{
  if (solid.Region.Empty())
  {
    return true;
  }
  error = CheckRegion(solid.Region, resolution);
  if (!error.empty())
  {
    return false;
  }
  const RegularGrid grid = GridOver(solid.Region, resolution);
  std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
  if (!solid.Sample(grid, monitor, values.data()))
  {
    return false;
  }
  surfaces.AddSurface(grid, values, occluder);
  return true;
}

double DiagonalOfBases(const std::vector<Cone>& cones)
{
  Box box;
  for (const Cone& cone : cones)
  {
    const Vector3 radius{ cone.BaseRadius, cone.BaseRadius, cone.BaseRadius };
    box.Add(cone.Center - radius);
    box.Add(cone.Center + radius);
  }
  return box.Diagonal();
}
} // anonymous namespace

vtkStandardNewMacro(vtkShadowVolume);

vtkShadowVolume::vtkShadowVolume()
{
  this->SetNumberOfOutputPorts(2);
}

bool vtkShadowVolume::HasBounds() const
{
  return !AreUnsetBounds(this->Bounds);
}

int vtkShadowVolume::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkShadowVolume::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  RequestWholeInputs(this, inputVector);
  return 1;
}

std::string vtkShadowVolume::CheckParameters() const
{
  return FirstOutOfRange(
    { InRange("Resolution", this->Resolution, 4, 1024), OneOf("Umbra", this->Umbra, { "InnerCones", "BaseDiscs" }),
      { "Length", this->Length, this->Length >= 0.0 && std::isfinite(this->Length), "0 or above and finite" } });
}

int vtkShadowVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    return run.Fail(error);
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  std::vector<Cone> cones;
  Box bounds;
  error = this->CheckParameters();
  if (!error.empty() || (this->HasBounds() && !ReadSolidBounds("Bounds", this->Bounds, bounds, error)) ||
    !ReadConeSet(input, cones, error))
  {
    return run.Fail(error);
  }
  const double length = this->Length > 0.0 ? this->Length : this->HasBounds() ? HUGE_VAL : DiagonalOfBases(cones);
  if (!cones.empty() && !(length > 0.0))
  {
    return run.Fail("The base discs of the cone set have no extent to take a length from: set Length or Bounds.");
  }

  std::vector<Light> lights;
  if (!cones.empty() && this->Umbra == BaseDiscs && !ReadLightsOf(input, cones, lights, error))
  {
    return run.Fail(error);
  }

  const Groups groups = GroupCones(cones, this->PerOccluder);
  const PieceRequest piece = RequestedPiece(request, outputVector);
  const vtkIdType begin = piece.Begin(static_cast<vtkIdType>(groups.size()));
  const vtkIdType end = piece.End(static_cast<vtkIdType>(groups.size()));
  const Monitor monitor = MonitorOf(this);
  SolidBuilder solids[2];
  vtkIdType withSurface = 0; // outer ones
  try
  {
    for (vtkIdType i = 2 * begin; i < 2 * end; ++i)
    {
      const auto& group = groups[i / 2];
      const double steps = static_cast<double>(2 * (end - begin));
      const Monitor part = monitor.Part((i - 2 * begin) / steps, (i - 2 * begin + 1) / steps);
      const auto light = static_cast<std::size_t>(std::max(group.first.first, 0));
      const Solid solid = i % 2 && this->Umbra == BaseDiscs
        ? JointUmbra(group.second, lights[light], length, bounds, this->Resolution, part.Part(0.0, 0.3))
        : UnionOfCones(group.second, i % 2 ? ConeBound::Inner : ConeBound::Outer, length, bounds);
      if (part.IsAborted() || !Contour(solid, group.first, this->Resolution, part.Part(0.3, 1.0), solids[i % 2], error))
      {
        return error.empty() ? 1 // aborted: the outputs stay empty
                             : run.Fail(Sentence("The ", i % 2 ? "inner" : "outer", " bound of occluder ",
                                 group.first.second, " needs ", error));
      }
      withSurface += i % 2 == 0 && !solid.Region.Empty() && solids[0].EndsWith(group.first.second) ? 1 : 0;
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Contouring the cones failed: ", exception.what()));
  }
  Warnings warnings;
  warnings.Add(OccludersWithoutSurface(end - begin - withSurface, end - begin));
  warnings.Say(this);
  for (int port = 0; port < 2; ++port)
  {
    solids[port].Finish(vtkPolyData::GetData(outputVector, port), input->GetFieldData());
  }
  return 1;
}

void vtkShadowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Bounds: " << Listed(this->Bounds, 6) << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Umbra: "
     << (this->Umbra == InnerCones     ? "InnerCones"
            : this->Umbra == BaseDiscs ? "BaseDiscs"
                                       : "invalid")
     << "\n";
  os << indent << "PerOccluder: " << (this->PerOccluder ? "on" : "off") << "\n";
}
