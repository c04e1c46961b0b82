// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonTracer.h"

#include "scLampPlane.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Times the rounding: a ray along a slanted edge meets the two triangles a little apart.
constexpr double sameCrossing = 100.0;

void Append(std::vector<double>& values, const Vector3& v)
{
  values.insert(values.end(), { v.X, v.Y, v.Z });
}

void Append(std::vector<float>& values, const Vector3& v)
{
  values.insert(values.end(), { static_cast<float>(v.X), static_cast<float>(v.Y), static_cast<float>(v.Z) });
}
} // anonymous namespace

PhotonTracer::PhotonTracer(const OccluderScene& scene, const std::vector<Light>& lights, VectorStorage storage)
  : Scene(scene)
  , Storage(storage)
  , Closed(ClosedOccluders(scene.Mesh()))
  , Whole(scene.Bounds())
{
  for (const Light& light : lights)
  {
    this->Rules.push_back(scene.RulesFor(FlatFaceOf(light)));
    Vector3 center;
    double radius = 0.0;
    LightBoundingSphere(light, center, radius);
    if (!IsAtInfinity(light))
    {
      this->Whole.Add(center - Vector3{ radius, radius, radius });
      this->Whole.Add(center + Vector3{ radius, radius, radius });
    }
  }
}

void PhotonTracer::Trace(const EmittedPhoton& emitted, int light, vtkIdType index, ShadowVectorResult& result) const
{
  TracedPhoton photon;
  static_cast<EmittedPhoton&>(photon) = emitted;
  photon.LightId = light;
  result.MeanSolidAngle += photon.SolidAngle;
  if (photon.Power <= 0.0)
  {
    return;
  }
  thread_local std::vector<RayHit> hits;
  this->Scene.IntersectAll(
    photon.Origin, photon.Direction, 0.0, HUGE_VAL, hits, this->Rules[static_cast<std::size_t>(photon.LightId)]);

  // The path ends at the first receiver.
  std::size_t end = 0;
  while (end < hits.size() && this->OccluderOf(hits[end]) >= 0)
  {
    ++end;
  }
  this->StorePath(photon, index, hits, end, result.Paths);
  this->StoreVectors(photon, index, hits, end, result);
}

/// Robust rays report both triangles of an edge that they hit: the second one is no further crossing.
bool PhotonTracer::RepeatsCrossing(
  const EmittedPhoton& photon, const std::vector<RayHit>& hits, std::size_t entry, std::size_t i) const
{
  const double rounding = sameCrossing * RoundingAlong(photon.Origin, hits[i].T);
  const vtkIdType* ids = this->Scene.Mesh().Triangles;
  for (std::size_t j = i; j-- > entry && hits[i].T - hits[j].T <= rounding;)
  {
    const vtkIdType* a = ids + 3 * hits[j].Triangle;
    const vtkIdType* b = ids + 3 * hits[i].Triangle;
    if (hits[j].FrontFacing == hits[i].FrontFacing && std::find_first_of(a, a + 3, b, b + 3) != a + 3)
    {
      return true;
    }
  }
  return false;
}

/**
 * From the entry to where the path leaves the same solid, be it behind a receiver (a leg sunk into a floor); an open sheet
 * is left where it is met.
 */
PhotonTracer::Passage PhotonTracer::PassageFrom(
  const EmittedPhoton& photon, const std::vector<RayHit>& hits, std::size_t entry) const
{
  Passage passage{ hits[entry], hits[entry] };
  if (!this->Closed[passage.Entry.Triangle])
  {
    return passage;
  }
  const int occluder = this->OccluderOf(passage.Entry);
  int depth = 0;
  for (std::size_t i = entry; i < hits.size(); ++i)
  {
    if (this->OccluderOf(hits[i]) != occluder || this->RepeatsCrossing(photon, hits, entry, i))
    {
      continue;
    }
    depth += hits[i].FrontFacing ? 1 : -1;
    if (depth <= 0)
    {
      passage.Exit = hits[i];
      break;
    }
  }
  return passage;
}

void PhotonTracer::StorePath(const TracedPhoton& photon, vtkIdType index, const std::vector<RayHit>& hits,
  std::size_t end, PhotonPaths& paths) const
{
  const bool blocked = end > 0;
  double length = 0.0;
  if (!hits.empty())
  {
    length = hits[0].T;
  }
  else
  {
    double tMin = 0.0;
    length = HUGE_VAL;
    this->Whole.Clip(photon.Origin, photon.Direction, tMin, length);
    length = std::isfinite(length) ? std::max(length, 0.0) : 0.0;
  }
  Append(paths.Points, photon.Origin + length * photon.Direction);
  paths.States.push_back(blocked ? 1 : 0);
  paths.OccluderIds.push_back(blocked ? this->OccluderOf(hits[0]) : -1);
  Append(paths.EmissionPoints, photon.Origin);
  Append(paths.Directions, photon.Direction);
  paths.Powers.push_back(static_cast<float>(photon.Power));
  paths.PhotonIndices.push_back(index);
  paths.LightIds.push_back(photon.LightId);
}

/// One vector for each occluder along the path, and a shadow photon on the surface behind the first one.
void PhotonTracer::StoreVectors(const TracedPhoton& photon, vtkIdType index, const std::vector<RayHit>& hits,
  std::size_t end, ShadowVectorResult& result) const
{
  thread_local std::vector<int> seen;
  seen.clear();
  for (std::size_t i = 0; i < end; ++i)
  {
    const int occluder = this->OccluderOf(hits[i]);
    if (std::find(seen.begin(), seen.end(), occluder) != seen.end())
    {
      continue;
    }
    const Passage passage = this->PassageFrom(photon, hits, i);
    if (seen.empty())
    {
      this->StoreShadowPhoton(photon, index, passage, hits, result.Photons);
    }
    seen.push_back(occluder);
    this->StoreVector(photon, index, passage, result.Vectors);
  }
}

void PhotonTracer::StoreVector(
  const TracedPhoton& photon, vtkIdType index, const Passage& passage, ShadowVectors& vectors) const
{
  const bool back = this->Storage == VectorStorage::BackSide;
  const RayHit& hit = back ? passage.Exit : passage.Entry;
  Vector3 normal = this->Scene.TriangleNormal(hit.Triangle);
  // A sheet has no outside: its normal is taken on the side where the vector is stored. So is that of a solid without exit.
  const bool sheet = !this->Closed[hit.Triangle] || (back && passage.Exit.Triangle == passage.Entry.Triangle);
  if (sheet && (Dot(normal, photon.Direction) > 0.0) != back)
  {
    normal = -normal;
  }
  Append(vectors.Points, photon.Origin + hit.T * photon.Direction);
  Append(vectors.Directions, photon.Direction);
  Append(vectors.Normals, normal);
  vectors.OccluderIds.push_back(this->OccluderOf(hit));
  Append(vectors.EmissionPoints, photon.Origin);
  vectors.PathLengths.push_back(static_cast<float>(hit.T));
  vectors.Thicknesses.push_back(static_cast<float>(passage.Exit.T - passage.Entry.T));
  vectors.PhotonIndices.push_back(index);
  vectors.LightIds.push_back(photon.LightId);
}

void PhotonTracer::StoreShadowPhoton(const TracedPhoton& photon, vtkIdType index, const Passage& passage,
  const std::vector<RayHit>& hits, ShadowPhotons& photons) const
{
  const int occluder = this->OccluderOf(passage.Entry);
  const auto next = std::find_if(hits.begin(), hits.end(),
    [&](const RayHit& hit)
    { return hit.T > passage.Exit.T + RoundingAlong(photon.Origin, hit.T) && this->OccluderOf(hit) != occluder; });
  if (next == hits.end())
  {
    return;
  }
  Append(photons.Points, photon.Origin + next->T * photon.Direction);
  Append(photons.Normals, this->Scene.TriangleNormal(next->Triangle));
  Append(photons.Directions, photon.Direction);
  photons.Powers.push_back(static_cast<float>(-photon.Power));
  photons.OccluderIds.push_back(occluder);
  photons.ReceiverIds.push_back(this->OccluderOf(*next));
  photons.PhotonIndices.push_back(index);
  photons.LightIds.push_back(photon.LightId);
}

} // namespace shadowcones
