// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowVectors.h"

#include "scLampPlane.h"
#include "scLightShares.h"
#include "scPhotonEmission.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace shadowcones
{
namespace
{
constexpr vtkIdType photonsPerTask = 1024;
constexpr vtkIdType photonsPerVectorLimit = 1000;
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

template <typename T>
void Append(std::vector<T>& values, const std::vector<T>& more)
{
  values.insert(values.end(), more.begin(), more.end());
}

void Append(ShadowVectorResult& result, const ShadowVectorResult& more)
{
  Append(result.Vectors.Points, more.Vectors.Points);
  Append(result.Vectors.Directions, more.Vectors.Directions);
  Append(result.Vectors.Normals, more.Vectors.Normals);
  Append(result.Vectors.OccluderIds, more.Vectors.OccluderIds);
  Append(result.Vectors.EmissionPoints, more.Vectors.EmissionPoints);
  Append(result.Vectors.PathLengths, more.Vectors.PathLengths);
  Append(result.Vectors.Thicknesses, more.Vectors.Thicknesses);
  Append(result.Vectors.PhotonIndices, more.Vectors.PhotonIndices);
  Append(result.Vectors.LightIds, more.Vectors.LightIds);
  Append(result.Paths.Points, more.Paths.Points);
  Append(result.Paths.States, more.Paths.States);
  Append(result.Paths.OccluderIds, more.Paths.OccluderIds);
  Append(result.Paths.EmissionPoints, more.Paths.EmissionPoints);
  Append(result.Paths.Directions, more.Paths.Directions);
  Append(result.Paths.Powers, more.Paths.Powers);
  Append(result.Paths.PhotonIndices, more.Paths.PhotonIndices);
  Append(result.Paths.LightIds, more.Paths.LightIds);
  Append(result.Photons.Points, more.Photons.Points);
  Append(result.Photons.Normals, more.Photons.Normals);
  Append(result.Photons.Directions, more.Photons.Directions);
  Append(result.Photons.Powers, more.Photons.Powers);
  Append(result.Photons.OccluderIds, more.Photons.OccluderIds);
  Append(result.Photons.ReceiverIds, more.Photons.ReceiverIds);
  Append(result.Photons.PhotonIndices, more.Photons.PhotonIndices);
  Append(result.Photons.LightIds, more.Photons.LightIds);
  result.MeanSolidAngle += more.MeanSolidAngle;
}

/// Follows photons through a scene and writes down what they leave behind.
class PhotonTracer
{
public:
  PhotonTracer(const OccluderScene& scene, const std::vector<Light>& lights, const ShadowVectorOptions& options)
    : Scene(scene)
    , Emissions(EmissionsOf(lights, scene.Mesh()))
    , Shares(PowersOf(Emissions))
    , Options(options)
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

  /// How many of the first @p photons leave each light.
  std::vector<vtkIdType> PhotonsOfLights(vtkIdType photons) const { return this->Shares.Counts(photons); }

  void Trace(vtkIdType index, ShadowVectorResult& result) const
  {
    const LightShares::Place place = this->Shares.At(index);
    TracedPhoton photon;
    static_cast<EmittedPhoton&>(photon) =
      this->Emissions[static_cast<std::size_t>(place.Light)].Emit(this->Options.Seed, place.Index);
    photon.LightId = place.Light;
    result.MeanSolidAngle += photon.SolidAngle;
    if (photon.Power <= 0.0)
    {
      return;
    }
    thread_local std::vector<RayHit> hits;
    this->Scene.IntersectAll(photon.Origin, photon.Direction, 0.0, HUGE_VAL, hits,
      this->Rules[static_cast<std::size_t>(place.Light)]);

    // The path ends at the first receiver.
    std::size_t end = 0;
    while (end < hits.size() && this->OccluderOf(hits[end]) >= 0)
    {
      ++end;
    }
    this->StorePath(photon, index, hits, end, result.Paths);
    this->StoreVectors(photon, index, hits, end, result);
  }

private:
  struct TracedPhoton : EmittedPhoton
  {
    int LightId = 0;
  };

  static std::vector<PhotonEmission> EmissionsOf(const std::vector<Light>& lights, const TriangleMeshView& mesh)
  {
    std::vector<PhotonEmission> emissions;
    emissions.reserve(lights.size());
    for (const Light& light : lights)
    {
      emissions.emplace_back(light, mesh);
    }
    return emissions;
  }

  static std::vector<double> PowersOf(const std::vector<PhotonEmission>& emissions)
  {
    std::vector<double> powers;
    for (const PhotonEmission& emission : emissions)
    {
      powers.push_back(emission.Power());
    }
    return powers;
  }

  struct Passage
  {
    RayHit Entry;
    RayHit Exit;
  };

  int OccluderOf(const RayHit& hit) const { return this->Scene.Mesh().OccluderId(hit.Triangle); }

  /// Robust rays report both triangles of an edge that they hit: the second one is no further crossing.
  bool RepeatsCrossing(
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
  Passage PassageFrom(const EmittedPhoton& photon, const std::vector<RayHit>& hits, std::size_t entry) const
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

  void StorePath(const TracedPhoton& photon, vtkIdType index, const std::vector<RayHit>& hits, std::size_t end,
    PhotonPaths& paths) const
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
  void StoreVectors(const TracedPhoton& photon, vtkIdType index, const std::vector<RayHit>& hits, std::size_t end,
    ShadowVectorResult& result) const
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

  void StoreVector(
    const TracedPhoton& photon, vtkIdType index, const Passage& passage, ShadowVectors& vectors) const
  {
    const bool back = this->Options.Storage == VectorStorage::BackSide;
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

  void StoreShadowPhoton(const TracedPhoton& photon, vtkIdType index, const Passage& passage,
    const std::vector<RayHit>& hits, ShadowPhotons& photons) const
  {
    const int occluder = this->OccluderOf(passage.Entry);
    const auto next = std::find_if(hits.begin(), hits.end(), [&](const RayHit& hit) {
      return hit.T > passage.Exit.T + RoundingAlong(photon.Origin, hit.T) && this->OccluderOf(hit) != occluder;
    });
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

  const OccluderScene& Scene;
  const std::vector<PhotonEmission> Emissions; ///< one a light
  const LightShares Shares;
  const ShadowVectorOptions& Options;
  const std::vector<bool> Closed;
  std::vector<RayRules> Rules; ///< one a light: for what is flush with it
  Box Whole;
};

/// Trace photons [begin, end) in tasks of fixed size, and join what the tasks found in photon order.
bool TraceRange(const PhotonTracer& tracer, vtkIdType begin, vtkIdType end, const Monitor& monitor,
  ShadowVectorResult& result)
{
  const vtkIdType tasks = (end - begin + photonsPerTask - 1) / photonsPerTask;
  std::vector<ShadowVectorResult> parts(static_cast<std::size_t>(tasks));
  const bool finished = ParallelFor(tasks, monitor, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType task = first; task < last; ++task)
    {
      const vtkIdType taskBegin = begin + task * photonsPerTask;
      const vtkIdType taskEnd = std::min(end, taskBegin + photonsPerTask);
      for (vtkIdType photon = taskBegin; photon < taskEnd; ++photon)
      {
        tracer.Trace(photon, parts[task]);
      }
    }
  });
  if (finished)
  {
    for (ShadowVectorResult& part : parts)
    {
      Append(result, part);
      part = {};
    }
  }
  return finished;
}

/// Trace photons from 0 on until the target is met or the limit reached: @p photons are enough, @p traced were traced.
bool TraceUntil(const PhotonTracer& tracer, vtkIdType target, const Monitor& monitor, ShadowVectorResult& result,
  vtkIdType& photons, vtkIdType& traced)
{
  constexpr vtkIdType largest = std::numeric_limits<vtkIdType>::max();
  const vtkIdType limit = std::min(target, largest / photonsPerVectorLimit) * photonsPerVectorLimit;
  double done = 0.0; // each range takes half of the progress that is left: nobody knows how many there will be
  const std::vector<vtkIdType>& indices = result.Vectors.PhotonIndices;
  for (traced = 0; traced < limit;)
  {
    // Guess what is missing from the yield so far.
    const auto found = static_cast<double>(indices.size());
    const double yield = traced > 0 ? std::max(found, 1.0) / static_cast<double>(traced) : 0.5;
    const double guess = std::min(1.02 * (static_cast<double>(target) - found) / yield, double(1 << 20));
    const vtkIdType end = std::min(limit, traced + std::max(static_cast<vtkIdType>(guess), photonsPerTask));
    const double next = 0.5 * (done + 1.0);
    if (!TraceRange(tracer, traced, end, monitor.Part(done, next), result))
    {
      return false;
    }
    done = next;
    traced = end;
    if (static_cast<vtkIdType>(indices.size()) >= target)
    {
      photons = indices[static_cast<std::size_t>(target - 1)] + 1;
      return true;
    }
  }
  photons = traced;
  return true;
}

template <typename T>
void KeepRange(std::vector<T>& values, std::size_t components, std::size_t begin, std::size_t end)
{
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(components * end), values.end());
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(components * begin));
}

/// A photon stands for its part of what its own light sends.
void SharePowers(
  const std::vector<vtkIdType>& photonsOfLights, const std::vector<int>& lightIds, std::vector<float>& powers)
{
  std::vector<float> shares;
  for (const vtkIdType photons : photonsOfLights)
  {
    shares.push_back(static_cast<float>(1.0 / static_cast<double>(std::max<vtkIdType>(photons, 1))));
  }
  for (std::size_t i = 0; i < powers.size(); ++i)
  {
    powers[i] *= shares[static_cast<std::size_t>(lightIds[i])];
  }
}

/// Drop what photons outside [first, last) left behind.
void KeepPhotons(ShadowVectorResult& result, vtkIdType first, vtkIdType last)
{
  const auto range = [first, last](const std::vector<vtkIdType>& indices) {
    return std::make_pair(
      static_cast<std::size_t>(std::lower_bound(indices.begin(), indices.end(), first) - indices.begin()),
      static_cast<std::size_t>(std::lower_bound(indices.begin(), indices.end(), last) - indices.begin()));
  };
  {
    ShadowVectors& v = result.Vectors;
    const auto [begin, end] = range(v.PhotonIndices);
    KeepRange(v.Points, 3, begin, end);
    KeepRange(v.Directions, 3, begin, end);
    KeepRange(v.Normals, 3, begin, end);
    KeepRange(v.OccluderIds, 1, begin, end);
    KeepRange(v.EmissionPoints, 3, begin, end);
    KeepRange(v.PathLengths, 1, begin, end);
    KeepRange(v.Thicknesses, 1, begin, end);
    KeepRange(v.PhotonIndices, 1, begin, end);
    KeepRange(v.LightIds, 1, begin, end);
  }
  {
    PhotonPaths& p = result.Paths;
    const auto [begin, end] = range(p.PhotonIndices);
    KeepRange(p.Points, 3, begin, end);
    KeepRange(p.States, 1, begin, end);
    KeepRange(p.OccluderIds, 1, begin, end);
    KeepRange(p.EmissionPoints, 3, begin, end);
    KeepRange(p.Directions, 3, begin, end);
    KeepRange(p.Powers, 1, begin, end);
    KeepRange(p.PhotonIndices, 1, begin, end);
    KeepRange(p.LightIds, 1, begin, end);
  }
  {
    ShadowPhotons& p = result.Photons;
    const auto [begin, end] = range(p.PhotonIndices);
    KeepRange(p.Points, 3, begin, end);
    KeepRange(p.Normals, 3, begin, end);
    KeepRange(p.Directions, 3, begin, end);
    KeepRange(p.Powers, 1, begin, end);
    KeepRange(p.OccluderIds, 1, begin, end);
    KeepRange(p.ReceiverIds, 1, begin, end);
    KeepRange(p.PhotonIndices, 1, begin, end);
    KeepRange(p.LightIds, 1, begin, end);
  }
}

} // anonymous namespace

std::vector<bool> ClosedOccluders(const TriangleMeshView& mesh)
{
  struct Edge
  {
    int Occluder;
    vtkIdType Low;
    vtkIdType High;
    int Sign;
  };
  std::vector<Edge> edges;
  edges.reserve(static_cast<std::size_t>(3 * mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType a = mesh.Triangles[3 * t + corner];
      const vtkIdType b = mesh.Triangles[3 * t + (corner + 1) % 3];
      edges.push_back({ mesh.OccluderId(t), std::min(a, b), std::max(a, b), a < b ? 1 : -1 });
    }
  }
  const auto key = [](const Edge& e) { return std::tie(e.Occluder, e.Low, e.High); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });

  std::vector<int> open;
  for (std::size_t i = 0; i < edges.size();)
  {
    int balance = 0;
    const std::size_t first = i;
    for (; i < edges.size() && key(edges[i]) == key(edges[first]); ++i)
    {
      balance += edges[i].Sign;
    }
    if (balance != 0 && (open.empty() || open.back() != edges[first].Occluder))
    {
      open.push_back(edges[first].Occluder);
    }
  }
  std::vector<bool> closed(static_cast<std::size_t>(mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    closed[t] = !std::binary_search(open.begin(), open.end(), mesh.OccluderId(t));
  }
  return closed;
}

bool TraceShadowVectors(const OccluderScene& scene, const Light& light, const ShadowVectorOptions& options,
  const Monitor& monitor, ShadowVectorResult& result)
{
  return TraceShadowVectors(scene, std::vector<Light>{ light }, options, monitor, result);
}

bool TraceShadowVectors(const OccluderScene& scene, const std::vector<Light>& lights,
  const ShadowVectorOptions& options, const Monitor& monitor, ShadowVectorResult& result)
{
  result = {};
  const PhotonTracer tracer(scene, lights, options);
  vtkIdType photons = options.NumberOfPhotons;
  vtkIdType traced = 0;
  if (options.TargetNumberOfVectors > 0)
  {
    // Every piece has to find out how many photons the whole takes.
    if (!TraceUntil(tracer, options.TargetNumberOfVectors, monitor, result, photons, traced))
    {
      return false;
    }
    KeepPhotons(result, PieceBound(photons, options.Piece, options.NumberOfPieces),
      PieceBound(photons, options.Piece + 1, options.NumberOfPieces));
    if (monitor.Progress)
    {
      monitor.Progress(1.0);
    }
  }
  else
  {
    const vtkIdType begin = PieceBound(photons, options.Piece, options.NumberOfPieces);
    const vtkIdType end = PieceBound(photons, options.Piece + 1, options.NumberOfPieces);
    if (!TraceRange(tracer, begin, end, monitor, result))
    {
      return false;
    }
    traced = end - begin;
  }
  result.NumberOfPhotons = photons;
  result.PhotonsOfLights = tracer.PhotonsOfLights(photons);
  SharePowers(result.PhotonsOfLights, result.Paths.LightIds, result.Paths.Powers);
  SharePowers(result.PhotonsOfLights, result.Photons.LightIds, result.Photons.Powers);
  result.MeanSolidAngle = traced > 0 ? result.MeanSolidAngle / static_cast<double>(traced) : 0.0;
  return true;
}

} // namespace shadowcones
