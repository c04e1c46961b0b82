// SPDX-License-Identifier: BSD-3-Clause
#include "scProvedSet.h"

#include "scCone.h"

#include <algorithm>
#include <utility>

namespace shadowcones
{
namespace
{
/// Cones around parts of the mesh, for each light, that are to be made at most.
constexpr int fewestParts = 16;
constexpr int mostParts = 140;

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

/// Cones around parts of the mesh, and whether they are tighter than the fitted ones can become. @return false where aborted.
bool MakeParts(const TriangleMeshView& mesh, const std::vector<Light>& lights, const std::vector<Cone>& fitted,
  const ConeProofOptions& options, const Monitor& monitor, ConeProof& parts, ProofChoice& choice)
{
  ConeProof before;
  before.Cones = fitted;
  before.Volume = VolumeOfCones(mesh, fitted, options);
  // No more than twice the fitted ones, for each light.
  ConeProofOptions few = options;
  const auto ofLight = static_cast<int>(2 * fitted.size() / std::max<std::size_t>(1, lights.size()));
  few.LargestNumberOfAddedCones = fitted.empty() ? 0 : std::clamp(ofLight, fewestParts, mostParts);
  if (!ProveConeSet(mesh, lights, {}, few, monitor, parts))
  {
    return false;
  }
  // Cones grow and are added: they hold no less once they are proved. As many and as large ones may still be proved as they are.
  choice = { IsTighter(parts, before) && parts.Volume < before.Volume, false, fitted.size(), parts.Cones.size(),
    before.Volume, parts.Volume };
  return true;
}

} // namespace

bool ProveFittedSet(const TriangleMeshView& mesh, const std::vector<Light>& lights, const ShadowVectorView& vectors,
  bool choose, const Monitor& monitor, ConeSet& set, ConeProof& proof, ProofChoice& choice)
{
  ConeProofOptions options;
  options.Region = RegionOf(mesh);
  ConeProof parts;
  if (choose && !MakeParts(mesh, lights, set.Cones, options, monitor.Part(0.0, 0.5), parts, choice))
  {
    return false;
  }
  if (!choice.TakesParts)
  {
    if (!ProveConeSet(mesh, lights, set.Cones, options, monitor.Part(choose ? 0.5 : 0.0, 1.0), proof))
    {
      return false;
    }
    choice = { choose && IsTighter(parts, proof), true, proof.Cones.size(), parts.Cones.size(), proof.Volume,
      parts.Volume };
  }
  if (choice.TakesParts)
  {
    proof = std::move(parts);
  }
  set.Cones = proof.Cones;
  AssignVectors(vectors, set);
  return true;
}

} // namespace shadowcones
