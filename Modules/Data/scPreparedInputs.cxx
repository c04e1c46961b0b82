// SPDX-License-Identifier: BSD-3-Clause
#include "scPreparedInputs.h"

#include "scDensityData.h"
#include "scFingerprint.h"
#include "scFingerprints.h"
#include "scScatteringScene.h"
#include "scVisibilityData.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace shadowcones
{
namespace
{
vtkIdType CountCasters(const TriangleMesh& mesh)
{
  if (mesh.OccluderIds.empty()) // without ids there are no receivers
  {
    return static_cast<vtkIdType>(mesh.Triangles.size() / 3);
  }
  return std::count_if(mesh.OccluderIds.begin(), mesh.OccluderIds.end(), [](auto id) { return id >= 0; });
}
} // anonymous namespace

std::int64_t PreparedMesh::Memory() const
{
  return MemoryOf(this->Mesh.Points) + MemoryOf(this->Mesh.Triangles) + MemoryOf(this->Mesh.OccluderIds) +
    MemoryOf(this->Mesh.SourceCells);
}

std::shared_ptr<const PreparedMesh> PrepareMesh(PreparedUser& user, vtkDataObject* input, std::string& error)
{
  if (!input)
  {
    static const auto none = std::make_shared<const PreparedMesh>();
    return none;
  }
  return user.Get<PreparedMesh>(PreparedKey(PreparedKind::Mesh).Add(StampOf(input)),
    [&]() -> std::shared_ptr<const PreparedMesh>
    {
      auto made = std::make_shared<PreparedMesh>();
      if (!ReadTriangles(input, made->Mesh, error))
      {
        return nullptr;
      }
      made->Bounds = MeshBounds(made->Mesh.View());
      made->NumberOfCasters = CountCasters(made->Mesh);
      made->CastersFingerprint = CastersFingerprintOf(made->Mesh);
      return made;
    });
}

std::shared_ptr<const PreparedMesh> PrepareCasters(PreparedUser& user, const std::shared_ptr<const PreparedMesh>& mesh)
{
  if (mesh->NumberOfCasters == static_cast<vtkIdType>(mesh->Mesh.SourceCells.size()))
  {
    return mesh;
  }
  return user.Get<PreparedMesh>(PreparedKey(PreparedKind::Casters).Add(mesh->Id),
    [&mesh]
    {
      auto made = std::make_shared<PreparedMesh>();
      made->Mesh = mesh->Mesh;
      made->Bounds = mesh->Bounds;
      made->NumberOfCasters = mesh->NumberOfCasters;
      made->CastersFingerprint = mesh->CastersFingerprint;
      DropReceivers(made->Mesh);
      return made;
    });
}

PreparedOccluders::PreparedOccluders(const std::shared_ptr<const PreparedMesh>& mesh)
  : Mesh(mesh)
  , Scene(mesh->Mesh.View())
{
}

std::shared_ptr<const PreparedOccluders> PrepareOccluders(
  PreparedUser& user, const std::shared_ptr<const PreparedMesh>& mesh)
{
  const auto make = [&mesh] { return std::make_shared<const PreparedOccluders>(mesh); };
  return mesh->Mesh.Triangles.empty()
    ? make()
    : user.Get<PreparedOccluders>(PreparedKey(PreparedKind::Occluders).Add(mesh->Id), make);
}

std::shared_ptr<const PreparedReflectance> PrepareReflectance(
  PreparedUser& user, const PreparedMesh& mesh, std::size_t wavelengths, double missing, std::string& error)
{
  const auto make = [&]() -> std::shared_ptr<const PreparedReflectance>
  {
    auto made = std::make_shared<PreparedReflectance>();
    return ReadReflectance(mesh.Mesh, wavelengths, missing, made->Reflectance, error) ? made : nullptr;
  };
  return mesh.Mesh.Triangles.empty()
    ? make()
    : user.Get<PreparedReflectance>(
        PreparedKey(PreparedKind::Reflectance).Add(mesh.Id).Add(std::uint64_t{ wavelengths }).Add(missing), make);
}

std::shared_ptr<const PreparedNormals> PrepareNormals(PreparedUser& user, const PreparedMesh& mesh, std::string& error)
{
  bool read = true;
  auto kept = user.Get<PreparedNormals>(PreparedKey(PreparedKind::Normals).Add(mesh.Id),
    [&]() -> std::shared_ptr<const PreparedNormals>
    {
      auto made = std::make_shared<PreparedNormals>();
      read = ReadPointNormals(mesh.Mesh, made->Normals, error);
      return read && !made->Normals.empty() ? made : nullptr;
    });
  return kept || !read ? kept : std::make_shared<const PreparedNormals>();
}

std::int64_t PreparedCones::Memory() const
{
  std::int64_t bytes = 0;
  for (const auto& cones : this->OfLights)
  {
    bytes += cones->Memory();
  }
  return bytes;
}

std::shared_ptr<const PreparedCones> PrepareCones(PreparedUser& user, const std::vector<InputStamp>& stamps,
  const std::vector<std::vector<Cone>>& conesOf, const Box& bounds, double length)
{
  return user.Get<PreparedCones>(PreparedKey(PreparedKind::Cones).Add(stamps).Add(bounds).Add(length),
    [&]
    {
      auto made = std::make_shared<PreparedCones>();
      for (const std::vector<Cone>& cones : conesOf)
      {
        made->OfLights.push_back(std::make_unique<const ConeHierarchy>(cones, bounds, length));
      }
      return made;
    });
}

std::shared_ptr<const PreparedProof> PrepareProof(PreparedUser& user, const ConeSetOfInput& cones,
  const PreparedMesh& mesh, const std::vector<Light>& lights, const std::vector<InputStamp>& lightStamps)
{
  const auto make = [&]
  {
    auto made = std::make_shared<PreparedProof>();
    made->Proved = AreProved(cones.Data, cones.Cones, mesh.Mesh, lights, cones.Input, made->Changed);
    return made;
  };
  if (!cones.Data->GetFieldData()->HasArray("Certified"))
  {
    return make();
  }
  // Cones are few beside triangles: they are looked at each time, whatever their stamp says.
  Fingerprint fingerprint;
  for (const Cone& cone : cones.Cones)
  {
    for (const Vector3& v : { cone.Center, cone.Axis, Vector3{ cone.BaseRadius, cone.HalfAngle, 1.0 * cone.LightId } })
    {
      fingerprint.AddNumber(v.X);
      fingerprint.AddNumber(v.Y);
      fingerprint.AddNumber(v.Z);
    }
  }
  PreparedKey key(PreparedKind::Proof);
  key.Add(StampOf(cones.Data)).Add(fingerprint.Value()).Add(mesh.Id).Add(lightStamps);
  return user.Get<PreparedProof>(key, make);
}

void PreparedGrids::LayOut()
{
  for (const VisibilityGrid& grid : this->Grids)
  {
    this->Layouts.push_back(LayOutGrid(grid));
  }
}

std::int64_t PreparedGrids::Memory() const
{
  std::int64_t bytes = 0;
  for (const VisibilityGrid& grid : this->Grids)
  {
    bytes += MemoryOf(grid.Visibility) + MemoryOf(grid.ShadowClasses) + MemoryOf(grid.Marked) +
      MemoryOf(grid.BrickCells) + MemoryOf(grid.BrickVisibility);
  }
  for (const auto& layout : this->Layouts)
  {
    bytes += MemoryOf(*layout);
  }
  return bytes;
}

std::shared_ptr<const PreparedGrids> PrepareGrids(PreparedUser& user, vtkImageData* volume,
  const std::vector<InputStamp>& lightStamps, const SceneLights& lights, std::string& error)
{
  return user.Get<PreparedGrids>(PreparedKey(PreparedKind::Grids).Add(StampOf(volume)).Add(lightStamps),
    [&]() -> std::shared_ptr<const PreparedGrids>
    {
      auto made = std::make_shared<PreparedGrids>();
      SceneLights warned = lights;
      warned.Warnings.clear();
      if (!ReadVisibilityGrids(volume, made->Grids, error, made->SaidOfBricks) ||
        !AssignGrids(volume->GetFieldData(), warned, made->Grids, error))
      {
        return nullptr;
      }
      made->SaidOfLights = warned.Warnings;
      made->LayOut();
      return made;
    });
}

std::shared_ptr<const PreparedDensity> PrepareDensity(
  PreparedUser& user, vtkImageData* input, vtkDataArray* chosen, std::string& error)
{
  PreparedKey key(PreparedKind::Density);
  key.Add(StampOf(input)).Add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(chosen)));
  return user.Get<PreparedDensity>(key,
    [&]() -> std::shared_ptr<const PreparedDensity>
    {
      auto made = std::make_shared<PreparedDensity>();
      return ReadDensity(input, chosen, made->Density, error) ? made : nullptr;
    });
}

} // namespace shadowcones
