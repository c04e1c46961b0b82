// SPDX-License-Identifier: BSD-3-Clause
#include "scProvedSet.h"

#include "scCone.h"

#include <algorithm>
#include <utility>

namespace shadowcones
{
namespace
{

/// Receivers are the room; without any the casters' own bounds say where shadow matters.
Box RegionOf(const TriangleMeshView& mesh)
{
  for (vtkIdType i = 0; i < mesh.NumberOfTriangles; ++i)
  {
    if (mesh.OccluderId(i) < 0)
    {
      return MeshBounds(mesh);
    }
  }
  return {};
}

void AssignVectors(const ShadowVectorView& vectors, ConeSet& set)
{
  const bool all =
    std::none_of(set.Cones.begin(), set.Cones.end(), [](const Cone& cone) { return cone.Origin != ConeOrigin::Added; });
  set.NumberOfDiscarded = 0;
  for (std::size_t i = 0; i < set.ConeIds.size(); ++i)
  {
    vtkIdType& id = set.ConeIds[i];
    if (all || id < 0)
    {
      const Vector3 point{ vectors.Points[3 * i], vectors.Points[3 * i + 1], vectors.Points[3 * i + 2] };
      const auto holds = [&](const Cone& cone)
      { return (!vectors.LightIds || cone.LightId == vectors.LightIds[i]) && ConeContains(cone, point); };
      const auto found = std::find_if(set.Cones.begin(), set.Cones.end(), holds);
      id = found != set.Cones.end() ? static_cast<vtkIdType>(found - set.Cones.begin()) : -1;
      set.NumberOfDiscarded += id < 0 ? 1 : 0;
      if (id >= 0 && found->Origin == ConeOrigin::Added)
      {
        ++found->VectorCount;
      }
    }
  }
}

} // namespace

bool ProveFittedSet(const TriangleMeshView& mesh, const std::vector<Light>& lights, const ShadowVectorView& vectors,
  bool choose, const Monitor& monitor, ConeSet& set, ConeProof& proof, ProofChoice& choice)
{
  ConeProofOptions options;
  options.Region = RegionOf(mesh);
  if (!ProveConeSet(mesh, lights, set.Cones, options, monitor.Part(0.0, choose ? 0.5 : 1.0), proof))
  {
    return false;
  }
  if (choose)
  {
    ConeProof parts;
    if (!ProveConeSet(mesh, lights, {}, options, monitor.Part(0.5, 1.0), parts))
    {
      return false;
    }
    choice = { IsTighter(parts, proof), proof.Cones.size(), parts.Cones.size(), proof.Volume, parts.Volume };
    if (choice.TakesParts)
    {
      proof = std::move(parts);
    }
  }
  set.Cones = proof.Cones;
  AssignVectors(vectors, set);
  return true;
}

} // namespace shadowcones
