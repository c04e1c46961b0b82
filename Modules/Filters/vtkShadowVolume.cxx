// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolume.h"

#include "scConeData.h"
#include "scConeDistanceField.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGuardedRequest.h"
#include "scInnerConeProof.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scParameterRanges.h"
#include "scProjectedShadow.h"
#include "scRegularGrid.h"
#include "scSceneLights.h"
#include "scSentence.h"
#include "scShadowField.h"
#include "scSolidData.h"
#include "scUmbraField.h"
#include "scVisibilityData.h"
#include "scWarnings.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <utility>

namespace
{
using namespace shadowcones;

constexpr int volumePort = 1;
constexpr int meshPort = 2;
constexpr int lightPort = 3;

/// Cones of one surface each, in ascending order of their keys.
using Groups = std::vector<std::pair<SolidKey, std::vector<Cone>>>;

Groups GroupCones(const std::vector<Cone>& cones, bool perOccluder)
{
  std::map<SolidKey, std::vector<Cone>> groups;
  for (const Cone& cone : cones)
  {
    groups[{ cone.LightId, perOccluder ? cone.OccluderId : -1 }].push_back(cone);
  }
  return { groups.begin(), groups.end() };
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
  if (!solid.Region.Empty() && CheckSolidRegion(solid.Region, resolution).empty())
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

/// The exact shapes of the lights that cones are of, from the field data of the cone set; @p known: of every cone.
bool ReadLightsOf(
  vtkFieldData* data, const std::vector<Cone>& cones, std::vector<Light>& lights, bool& known, std::string& error)
{
  if (!ReadLightShapes(data, lights, error))
  {
    return false;
  }
  known = std::all_of(cones.begin(), cones.end(),
    [&](const Cone& cone)
    {
      const auto id = static_cast<std::size_t>(cone.LightId);
      return cone.LightId >= 0 && id < lights.size() &&
        (lights[id].Shape != LightShape::Mesh || !lights[id].Triangles.empty() || !lights[id].Vertices.empty());
    });
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

/// The smallest box around what two boxes share; empty where they share no volume.
Box Shared(const Box& a, const Box& b)
{
  const Box box{ { std::max(a.Min.X, b.Min.X), std::max(a.Min.Y, b.Min.Y), std::max(a.Min.Z, b.Min.Z) },
    { std::min(a.Max.X, b.Max.X), std::min(a.Max.Y, b.Max.Y), std::min(a.Max.Z, b.Max.Z) } };
  const Vector3 size = box.Size();
  return size.X > 0.0 && size.Y > 0.0 && size.Z > 0.0 ? box : Box{};
}
} // anonymous namespace

/// What there is to make solids of.
struct vtkShadowVolume::Inputs
{
  std::vector<Cone> Cones;
  vtkNew<vtkFieldData> ConeData;
  TriangleMesh Mesh;
  SceneLights Lights;
  std::vector<VisibilityGrid> Volume; ///< one a light, or none
  Box Cut;                            ///< Bounds, or those of the volume; empty: none
  bool LimitedByCones = false;        ///< the cones are proved for this mesh and these lights
  std::vector<std::string> OccluderNames;
  std::vector<std::uint64_t> CastersFingerprints;
  Warnings Said;

  /// Where shadow of casters in a box may be that is asked for.
  Box RegionOf(const Box& casters, int light, double length) const
  {
    Box joint = this->Cut;
    joint.Add(casters);
    const bool cut = !this->Cut.Empty();
    const double reach = length > 0.0 ? length : (cut ? joint : MeshBounds(this->Mesh.View())).Diagonal();
    Box region = ShadowReach(casters, this->Lights.Lights[static_cast<std::size_t>(light)], reach);
    region = cut ? Shared(region, this->Cut) : Shared(region, region);
    if (!this->Volume.empty() && !region.Empty())
    {
      const VisibilityGrid& grid = this->Volume[static_cast<std::size_t>(light)];
      const Box whole = BoundsOf(grid);
      const bool covered = whole.Contains(region.Min) && whole.Contains(region.Max);
      region = covered ? Shared(region, ShadowOf(grid)) : region;
    }
    if (this->LimitedByCones && !region.Empty())
    {
      const auto own = ConesOfLights(this->Cones, this->Lights.Lights.size());
      region = ConeDistanceField(own[static_cast<std::size_t>(light)], ConeBound::Outer, HUGE_VAL, region).Region();
    }
    return region;
  }
};

/// Solids in the making: those of the requested piece.
struct vtkShadowVolume::Work
{
  PieceRequest Piece;
  Monitor Whole;
  SolidBuilder Solids[2]; ///< outer, inner
  vtkIdType Surfaces = 0; ///< that were asked for
  vtkIdType WithSurface = 0;
  vtkIdType WithSeveralParts = 0;
  std::string Error;

  /// The part of the monitor that belongs to step @p i of so many.
  Monitor Step(vtkIdType i, vtkIdType count) const
  {
    return this->Whole.Part(0.2 + 0.8 * static_cast<double>(i) / count, 0.2 + 0.8 * static_cast<double>(i + 1) / count);
  }
  /// True where the grid over a region can be had; else Error says why not.
  bool Check(const Box& region, int resolution, bool inner, const SolidKey& key)
  {
    const std::string fault = CheckSolidRegion(region, resolution);
    this->Error = fault.empty()
      ? fault
      : Sentence("The ", inner ? "inner" : "outer", " bound of occluder ", key.second, " needs ", fault);
    return fault.empty();
  }
  /// Sample a solid and add its surface.
  bool Contour(const Solid& solid, const SolidKey& key, int resolution, bool inner, const Monitor& monitor)
  {
    if (solid.Region.Empty())
    {
      return true;
    }
    if (!this->Check(solid.Region, resolution, inner, key))
    {
      return false;
    }
    const RegularGrid grid = GridOver(solid.Region, resolution);
    std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
    if (!solid.Sample(grid, monitor, values.data()))
    {
      return false;
    }
    this->Solids[inner ? 1 : 0].AddContour(grid, values, key);
    return true;
  }
  /// The same of what is truly seen.
  bool Contour(
    const ShadowField& field, Box& region, const SolidKey& key, int resolution, bool inner, const Monitor& monitor)
  {
    const ShadowBound bound = inner ? ShadowBound::Inner : ShadowBound::Outer;
    if (!region.Empty() && !this->Check(region, resolution, inner, key))
    {
      return false;
    }
    region = region.Empty() ? region : field.Find(region, bound, resolution, monitor.Part(0.0, 0.2));
    if (region.Empty() || monitor.IsAborted())
    {
      return !monitor.IsAborted();
    }
    const RegularGrid grid = GridOver(region, resolution);
    std::vector<unsigned char> inside(static_cast<std::size_t>(grid.NumberOfPoints()));
    if (!field.Classify(grid, bound, monitor.Part(0.2, 0.6), inside.data()))
    {
      return false;
    }
    GridSurface surface = SurfaceBetween(grid, inside);
    if (!field.Place(grid, bound, monitor.Part(0.6, 1.0), surface))
    {
      return false;
    }
    this->Solids[inner ? 1 : 0].Add(grid, surface, key);
    return true;
  }
};

vtkStandardNewMacro(vtkShadowVolume);
scDefineGuardedRequests(vtkShadowVolume);

vtkShadowVolume::vtkShadowVolume()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
}

scDefineInputPort(vtkShadowVolume, VisibilityVolume, volumePort);
scDefineInputPort(vtkShadowVolume, Mesh, meshPort);
scDefineLightPort(vtkShadowVolume, lightPort);

int vtkShadowVolume::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, port == volumePort ? "vtkImageData" : "vtkPolyData", info);
  return 1;
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

int vtkShadowVolume::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

std::string vtkShadowVolume::CheckParameters() const
{
  return FirstOutOfRange({ OneOf("Method", this->Method, { "Cones", "Visibility", "Projection" }),
    InRange("Resolution", this->Resolution, 4, 1024), OneOf("Umbra", this->Umbra, { "InnerCones", "BaseDiscs" }),
    InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples),
    { "Length", this->Length, this->Length >= 0.0 && std::isfinite(this->Length), "0 or above and finite" } });
}

std::string vtkShadowVolume::CheckConnections(vtkInformationVector** inputVector) const
{
  if (this->Method == Cones)
  {
    return vtkPolyData::GetData(inputVector[0])
      ? std::string()
      : "No cone set on input port 0: connect a vtkConeSetFilter, or connect mesh and light and use "
        "SetMethodToVisibility().";
  }
  if (!vtkDataObject::GetData(inputVector[meshPort]))
  {
    return "Visibility and Projection need the mesh on input port 2: connect it with SetMeshConnection, or use "
           "SetMethodToCones().";
  }
  return inputVector[lightPort]->GetNumberOfInformationObjects() > 0
    ? std::string()
    : "Visibility and Projection need a light on input port 3: connect a vtkAreaLightSource or a polygon mesh with "
      "SetLightConnection.";
}

bool vtkShadowVolume::ReadMeshAndLights(vtkInformationVector** inputVector, Inputs& in, std::string& error) const
{
  vtkPolyData* cones = vtkPolyData::GetData(inputVector[0]);
  vtkDataObject* mesh = vtkDataObject::GetData(inputVector[meshPort]);
  vtkImageData* volume = vtkImageData::GetData(inputVector[volumePort]);
  const bool lit = inputVector[lightPort]->GetNumberOfInformationObjects() > 0;
  if ((lit && !ReadLights(inputVector[lightPort], in.Lights, error)) || (mesh && !ReadTriangles(mesh, in.Mesh, error)))
  {
    return false;
  }
  if (in.Mesh.Triangles.empty() && in.Mesh.NumberOfCells > 0)
  {
    error = Sentence("The mesh on input port 2 has ", in.Mesh.NumberOfCells,
      " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first.");
    return false;
  }
  const std::uint64_t casters = CastersFingerprintOf(in.Mesh);
  if (mesh)
  {
    in.OccluderNames = in.Mesh.OccluderNames;
    in.CastersFingerprints = { CompareCasters(casters, meshPort, in.ConeData, "The cone set on input port 0", in.Said) };
    DropReceivers(in.Mesh);
  }
  if (lit && cones)
  {
    AssignCones(cones, in.Lights, in.Cones);
  }
  if (volume && this->Method == Visibility)
  {
    std::string warning;
    if (!ReadVisibilityGrids(volume, in.Volume, error, warning) ||
      !AssignGrids(volume->GetFieldData(), in.Lights, in.Volume, error))
    {
      return false;
    }
    CompareCasters(casters, meshPort, volume->GetFieldData(), "The visibility volume on input port 1", in.Said);
    in.Cut = this->HasBounds() ? in.Cut : BoundsOf(in.Volume.front());
  }
  return true;
}

bool vtkShadowVolume::ReadInputs(vtkInformationVector** inputVector, Inputs& in, std::string& error) const
{
  vtkPolyData* cones = vtkPolyData::GetData(inputVector[0]);
  error = this->CheckParameters();
  error = error.empty() ? this->CheckConnections(inputVector) : error;
  if (!error.empty() || (this->HasBounds() && !ReadSolidBounds("Bounds", this->Bounds, in.Cut, error)) ||
    (cones && !ReadConeSet(cones, in.Cones, error)))
  {
    return false;
  }
  if (cones)
  {
    in.ConeData->PassData(cones->GetFieldData());
  }
  if (!this->ReadMeshAndLights(inputVector, in, error))
  {
    return false;
  }
  if (this->Method != Cones && cones)
  {
    std::string why;
    const ConeCertificate certificate =
      ReadConeCertificate(in.ConeData, in.Cones, in.Mesh.View(), in.Lights.Lights, why);
    in.LimitedByCones = certificate.Certified && certificate.Bounds.Empty();
  }
  return true;
}

bool vtkShadowVolume::BuildFromCones(Inputs& in, Work& work) const
{
  const double length = this->Length > 0.0 ? this->Length : this->HasBounds() ? HUGE_VAL : DiagonalOfBases(in.Cones);
  if (!in.Cones.empty() && !(length > 0.0))
  {
    work.Error = "The base discs of the cone set have no extent to take a length from: set Length or Bounds.";
    return false;
  }
  std::vector<Light> lights = in.Lights.Lights;
  bool known = !lights.empty();
  const bool isOfDiscs = this->Umbra == BaseDiscs;
  if (!known && (isOfDiscs || !in.Mesh.Triangles.empty()) && !in.Cones.empty() &&
    !ReadLightsOf(in.ConeData, in.Cones, lights, known, work.Error))
  {
    return false;
  }
  if (isOfDiscs && !known && !in.Cones.empty())
  {
    work.Error =
      "Umbra is BaseDiscs, but the field data of the cone set does not carry the light (\"LightShape\"): use "
      "InnerCones, or cones of a light of vtkAreaLightSource.";
    return false;
  }
  std::vector<Cone> inner = in.Cones;
  const bool proves = !isOfDiscs && !in.Mesh.Triangles.empty();
  if (proves && known)
  {
    const OccluderScene scene(in.Mesh.View());
    InnerConeProof proof;
    if (!ProveInnerCones(scene, lights, in.Cones, work.Whole.Part(0.0, 0.2), proof))
    {
      return false;
    }
    inner = proof.Cones;
    AddIdArray(in.ConeData, "NumberOfWholeInnerCones", { proof.Whole });
    AddIdArray(in.ConeData, "NumberOfShrunkInnerCones", { proof.Shrunk });
    AddIdArray(in.ConeData, "NumberOfDroppedInnerCones", { proof.Dropped });
  }
  in.Said.Add(proves && !known && !in.Cones.empty() ? InnerConesNotProved() : std::string());
  AddIntArray(in.ConeData, "InnerCertified", 1, { proves && known ? 1 : 0 });

  const Groups groups = GroupCones(in.Cones, this->PerOccluder);
  std::map<SolidKey, std::vector<Cone>> innerOf;
  for (auto& group : GroupCones(inner, this->PerOccluder))
  {
    innerOf[group.first] = std::move(group.second);
  }
  const vtkIdType begin = work.Piece.Begin(static_cast<vtkIdType>(groups.size()));
  const vtkIdType end = work.Piece.End(static_cast<vtkIdType>(groups.size()));
  work.Surfaces = end - begin;
  for (vtkIdType i = begin; i < end; ++i)
  {
    const SolidKey key = groups[i].first;
    const Monitor part = work.Step(i - begin, end - begin);
    const Solid outer = UnionOfCones(groups[i].second, ConeBound::Outer, length, in.Cut);
    if (part.IsAborted() || !work.Contour(outer, key, this->Resolution, false, part.Part(0.0, 0.5)))
    {
      return false;
    }
    work.WithSurface += !outer.Region.Empty() && work.Solids[0].EndsWith(key.second) ? 1 : 0;
    const auto light = static_cast<std::size_t>(std::max(key.first, 0));
    const Solid hidden = isOfDiscs
      ? JointUmbra(groups[i].second, lights[light], length, in.Cut, this->Resolution, part.Part(0.5, 0.65))
      : UnionOfCones(innerOf[key], ConeBound::Inner, length, in.Cut);
    if (part.IsAborted() || !work.Contour(hidden, key, this->Resolution, true, part.Part(0.65, 1.0)))
    {
      return false;
    }
  }
  return true;
}

bool vtkShadowVolume::BuildFromMesh(Inputs& in, Work& work) const
{
  const std::map<int, TriangleMesh> occluders = SplitOccluders(in.Mesh, this->PerOccluder);
  std::vector<SolidKey> keys;
  for (int light = 0; light < static_cast<int>(in.Lights.Lights.size()); ++light)
  {
    for (const auto& occluder : occluders)
    {
      keys.emplace_back(light, occluder.first);
    }
    if (this->Method == Projection && !HasHardShadows(in.Lights.Lights[static_cast<std::size_t>(light)]))
    {
      work.Error = Sentence("Light ", light,
        " has a width, and casts soft shadows: Projection is for point lights and Suns of AngularDiameter 0. Use "
        "SetMethodToVisibility().");
      return false;
    }
  }
  AddIntArray(in.ConeData, "InnerCertified", 1, { this->Method == Projection ? 1 : 0 });
  const vtkIdType begin = work.Piece.Begin(static_cast<vtkIdType>(keys.size()));
  const vtkIdType end = work.Piece.End(static_cast<vtkIdType>(keys.size()));
  work.Surfaces = end - begin;
  for (vtkIdType i = begin; i < end; ++i)
  {
    const SolidKey key = keys[i];
    const TriangleMesh& mesh = occluders.at(key.second);
    const Light& light = in.Lights.Lights[static_cast<std::size_t>(key.first)];
    Box region = in.RegionOf(MeshBounds(mesh.View()), key.first, this->Length);
    const Monitor part = work.Step(i - begin, end - begin);
    if (part.IsAborted())
    {
      return false;
    }
    if (this->Method == Projection)
    {
      if (part.Progress)
      {
        part.Progress(0.0);
      }
      ProjectedShadow shadow;
      std::string fault;
      if (!region.Empty() && !ProjectShadow(mesh.View(), light, region, shadow, fault))
      {
        work.Error = Sentence("Occluder ", key.second, " ", fault);
        return false;
      }
      work.WithSeveralParts += shadow.NumberOfSolids > 1 ? 1 : 0;
      work.Solids[0].Add(shadow, key);
      work.Solids[1].Add(shadow, key);
    }
    else
    {
      const OccluderScene scene(mesh.View());
      const ShadowField field(scene, light, this->NumberOfLightSamples);
      if (!work.Contour(field, region, key, this->Resolution, false, part.Part(0.0, 0.5)) ||
        !work.Contour(field, region, key, this->Resolution, true, part.Part(0.5, 1.0)))
      {
        return false;
      }
    }
    work.WithSurface += !region.Empty() && work.Solids[0].EndsWith(key.second) ? 1 : 0;
  }
  return true;
}

int vtkShadowVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Inputs in;
  std::string error;
  const FilterRun run(this, request, inputVector, outputVector);
  if (!run.AreInputsWhole(error) || !this->ReadInputs(inputVector, in, error))
  {
    return run.Fail(error);
  }
  Work work;
  work.Piece = RequestedPiece(request, outputVector);
  work.Whole = MonitorOf(this);
  try
  {
    if (!(this->Method == Cones ? this->BuildFromCones(in, work) : this->BuildFromMesh(in, work)))
    {
      return work.Error.empty() ? 1 : run.Fail(work.Error); // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Building the solids failed: ", ReasonOf(exception)));
  }
  in.Said.Add(in.Lights.Warnings);
  in.Said.Add(OccludersWithoutSurface(work.Surfaces - work.WithSurface, work.Surfaces));
  in.Said.Add(SolidsOfSeveralParts(work.WithSeveralParts, work.Surfaces));
  in.Said.Say(this);
  AddIntArray(in.ConeData, "Method", 1, { this->Method });
  WriteOccluderNames(in.OccluderNames, in.ConeData);
  WriteFingerprints(castersFingerprint, in.CastersFingerprints, in.ConeData);
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* output = vtkPolyData::GetData(outputVector, port);
    work.Solids[port].Finish(output, in.ConeData);
    if (!in.Lights.Lights.empty())
    {
      WriteLightFingerprints(in.Lights.Lights, output);
    }
  }
  return 1;
}

void vtkShadowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: "
     << (this->Method == Cones           ? "Cones"
            : this->Method == Visibility ? "Visibility"
            : this->Method == Projection ? "Projection"
                                         : "invalid")
     << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Bounds: " << Listed(this->Bounds, 6) << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Umbra: "
     << (this->Umbra == InnerCones     ? "InnerCones"
            : this->Umbra == BaseDiscs ? "BaseDiscs"
                                       : "invalid")
     << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "PerOccluder: " << (this->PerOccluder ? "on" : "off") << "\n";
}
