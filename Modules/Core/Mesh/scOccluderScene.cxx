// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderScene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace shadowcones
{
namespace
{
constexpr double relativeEpsilon = 2e-6;
/// Rays in one query: eight fill the vectors of most machines.
constexpr int packetSize = OccluderScene::PacketSize;
/// In Embree's frame, where the mesh has a diagonal of 2: farther origins have too few digits in single precision.
constexpr double farthestPacket = 8.0;

/// A triangle on the way of a ray, and the distance to it in Embree's frame.
struct FoundTriangle
{
  unsigned int Triangle;
  float T;
};

/// One query: a ray in Embree's frame, and how its distances come back.
struct EmbreeRay
{
  RTCRay Ray;
  double Start; ///< world distance from the caller's origin to Ray's origin
};

void SetRay(RTCRay& ray, const Vector3& o, const Vector3& d, double tNear, double tFar)
{
  ray.org_x = static_cast<float>(o.X);
  ray.org_y = static_cast<float>(o.Y);
  ray.org_z = static_cast<float>(o.Z);
  ray.dir_x = static_cast<float>(d.X);
  ray.dir_y = static_cast<float>(d.Y);
  ray.dir_z = static_cast<float>(d.Z);
  ray.tnear = static_cast<float>(tNear);
  ray.tfar = static_cast<float>(tFar);
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
}

// Embree 3 and 4 differ in how a query is described and in nothing else that is used here.
#if RTC_VERSION_MAJOR >= 4
struct Query
{
  RTCRayQueryContext Context;
  std::vector<FoundTriangle>* Found = nullptr;
};
void CollectHit(const RTCFilterFunctionNArguments* arguments);

void Nearest(RTCScene scene, RTCRayHit& rayHit)
{
  rtcIntersect1(scene, &rayHit);
}
void NearestOfPacket(const int* valid, RTCScene scene, RTCRayHit8& rayHits)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &rayHits, &arguments);
}
void Any(RTCScene scene, RTCRay& ray)
{
  rtcOccluded1(scene, &ray);
}
void AnyOfPacket(const int* valid, RTCScene scene, RTCRay8& rays)
{
  rtcOccluded8(valid, scene, &rays);
}
void Collect(RTCScene scene, RTCRayHit& rayHit, std::vector<FoundTriangle>& found)
{
  Query query;
  rtcInitRayQueryContext(&query.Context);
  query.Found = &found;
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.Context;
  arguments.filter = CollectHit;
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  rtcIntersect1(scene, &rayHit, &arguments);
}
constexpr auto filterSceneFlag = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
#else
struct Query
{
  RTCIntersectContext Context;
  std::vector<FoundTriangle>* Found = nullptr;
};
void CollectHit(const RTCFilterFunctionNArguments* arguments);

void Nearest(RTCScene scene, RTCRayHit& rayHit)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &rayHit);
}
void NearestOfPacket(const int* valid, RTCScene scene, RTCRayHit8& rayHits)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &context, &rayHits);
}
void Any(RTCScene scene, RTCRay& ray)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
}
void AnyOfPacket(const int* valid, RTCScene scene, RTCRay8& rays)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded8(valid, scene, &context, &rays);
}
void Collect(RTCScene scene, RTCRayHit& rayHit, std::vector<FoundTriangle>& found)
{
  Query query;
  rtcInitIntersectContext(&query.Context);
  query.Found = &found;
  query.Context.filter = CollectHit;
  rtcIntersect1(scene, &query.Context, &rayHit);
}
constexpr auto filterSceneFlag = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
#endif

/// Note the triangle and reject the hit, so that the traversal goes on to the next one.
void CollectHit(const RTCFilterFunctionNArguments* arguments)
{
  auto* query = reinterpret_cast<Query*>(arguments->context);
  query->Found->push_back(
    { RTCHitN_primID(arguments->hit, arguments->N, 0), RTCRayN_tfar(arguments->ray, arguments->N, 0) });
  arguments->valid[0] = 0;
}
} // anonymous namespace

struct OccluderScene::Implementation
{
  TriangleMeshView Mesh;
  Box Bounds;
  Vector3 Center;
  double Scale = 1.0; ///< world to Embree's frame
  double Epsilon = 0.0;
  Box QueryBounds; ///< bounds with a margin: rays start and end inside
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;

  ~Implementation()
  {
    if (this->Scene)
    {
      rtcReleaseScene(this->Scene);
    }
    if (this->Device)
    {
      rtcReleaseDevice(this->Device);
    }
  }

  /// Start far rays at the bounds, in double precision, so that their origins keep their digits in single precision.
  bool Prepare(const Vector3& origin, const Vector3& direction, double tMin, double tMax, EmbreeRay& query) const
  {
    if (this->Bounds.Empty() || !this->QueryBounds.Clip(origin, direction, tMin, tMax))
    {
      return false;
    }
    query.Start = tMin;
    const Vector3 start = this->Scale * (origin + tMin * direction - this->Center);
    // Embree stops the program at a ray that is not a number.
    if (!IsFinite(start) || !IsFinite(direction))
    {
      return false;
    }
    SetRay(query.Ray, start, direction, 0.0, (tMax - tMin) * this->Scale);
    return true;
  }

  /// Distance to the triangle's plane in double precision; @p fallback where the ray runs along it.
  double Refine(vtkIdType triangle, const Vector3& origin, const Vector3& direction, double fallback) const
  {
    const Vector3 a = this->Mesh.Corner(triangle, 0);
    const Vector3 normal = Cross(this->Mesh.Corner(triangle, 1) - a, this->Mesh.Corner(triangle, 2) - a);
    const double slope = Dot(normal, direction);
    if (std::abs(slope) < 1e-3 * Length(normal))
    {
      return fallback;
    }
    return Dot(normal, a - origin) / slope;
  }
};

Box MeshBounds(const TriangleMeshView& mesh)
{
  Box bounds;
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    bounds.Add(mesh.Point(mesh.Triangles[i]));
  }
  return bounds;
}

OccluderScene::OccluderScene(const TriangleMeshView& mesh)
  : Impl(new Implementation)
{
  Implementation& impl = *this->Impl;
  impl.Mesh = mesh;
  impl.Bounds = MeshBounds(mesh);
  if (mesh.NumberOfTriangles == 0)
  {
    return;
  }
  if (mesh.NumberOfTriangles >= std::numeric_limits<unsigned int>::max() / 4)
  {
    throw std::runtime_error("the mesh has more triangles than Embree can address");
  }

  const double diagonal = impl.Bounds.Diagonal();
  impl.Center = impl.Bounds.Center();
  impl.Scale = diagonal > 0.0 ? 2.0 / diagonal : 1.0;
  impl.Epsilon = relativeEpsilon * diagonal;
  const Vector3 margin{ 1e-4 * diagonal, 1e-4 * diagonal, 1e-4 * diagonal };
  impl.QueryBounds = { impl.Bounds.Min - margin, impl.Bounds.Max + margin };

  // No "threads=1" here: it would throttle every user of TBB in the process.
  impl.Device = rtcNewDevice(nullptr);
  if (!impl.Device)
  {
    throw std::runtime_error("Embree could not be started (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
  }
  impl.Scene = rtcNewScene(impl.Device);
  rtcSetSceneFlags(impl.Scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | filterSceneFlag));

  RTCGeometry geometry = rtcNewGeometry(impl.Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
    3 * sizeof(float), static_cast<std::size_t>(mesh.NumberOfPoints)));
  auto* triangles = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
    RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), static_cast<std::size_t>(mesh.NumberOfTriangles)));
  if (!points || !triangles)
  {
    rtcReleaseGeometry(geometry);
    throw std::bad_alloc();
  }
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    const Vector3 p = impl.Scale * (mesh.Point(i) - impl.Center);
    points[3 * i] = static_cast<float>(p.X);
    points[3 * i + 1] = static_cast<float>(p.Y);
    points[3 * i + 2] = static_cast<float>(p.Z);
  }
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    triangles[i] = static_cast<unsigned int>(mesh.Triangles[i]);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl.Scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl.Scene);
}

OccluderScene::~OccluderScene() = default;

const TriangleMeshView& OccluderScene::Mesh() const
{
  return this->Impl->Mesh;
}

const Box& OccluderScene::Bounds() const
{
  return this->Impl->Bounds;
}

double OccluderScene::Epsilon() const
{
  return this->Impl->Epsilon;
}

bool OccluderScene::Intersect(
  const Vector3& origin, const Vector3& direction, double tMin, double tMax, RayHit& hit) const
{
  EmbreeRay query;
  if (!this->Impl->Prepare(origin, direction, tMin, tMax, query))
  {
    return false;
  }
  RTCRayHit rayHit;
  rayHit.ray = query.Ray;
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Nearest(this->Impl->Scene, rayHit);
  if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
  {
    return false;
  }
  hit.Triangle = rayHit.hit.primID;
  hit.T = this->Impl->Refine(hit.Triangle, origin, direction, query.Start + rayHit.ray.tfar / this->Impl->Scale);
  hit.FrontFacing = Dot(this->TriangleNormal(hit.Triangle), direction) <= 0.0;
  return true;
}

void OccluderScene::IntersectPacket(
  const Vector3* origins, const Vector3* directions, int count, RayHit* hits) const
{
  alignas(32) RTCRayHit8 packet;
  alignas(32) int valid[packetSize];
  double starts[packetSize] = {};
  for (int k = 0; k < packetSize; ++k)
  {
    EmbreeRay query{};
    const bool asked = k < count && this->Impl->Prepare(origins[k], directions[k], 0.0, HUGE_VAL, query);
    valid[k] = asked ? -1 : 0;
    starts[k] = query.Start;
    packet.ray.org_x[k] = query.Ray.org_x;
    packet.ray.org_y[k] = query.Ray.org_y;
    packet.ray.org_z[k] = query.Ray.org_z;
    packet.ray.dir_x[k] = query.Ray.dir_x;
    packet.ray.dir_y[k] = query.Ray.dir_y;
    packet.ray.dir_z[k] = query.Ray.dir_z;
    packet.ray.tnear[k] = query.Ray.tnear;
    packet.ray.tfar[k] = query.Ray.tfar;
    packet.ray.time[k] = 0.0f;
    packet.ray.mask[k] = ~0u;
    packet.ray.id[k] = 0;
    packet.ray.flags[k] = 0;
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  if (!this->Impl->Bounds.Empty())
  {
    NearestOfPacket(valid, this->Impl->Scene, packet);
  }
  for (int k = 0; k < count; ++k)
  {
    RayHit& hit = hits[k];
    hit = RayHit();
    if (valid[k] && packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID)
    {
      hit.Triangle = packet.hit.primID[k];
      const double found = starts[k] + packet.ray.tfar[k] / this->Impl->Scale;
      hit.T = this->Impl->Refine(hit.Triangle, origins[k], directions[k], found);
      hit.FrontFacing = Dot(this->TriangleNormal(hit.Triangle), directions[k]) <= 0.0;
    }
  }
}

void OccluderScene::IntersectAll(
  const Vector3& origin, const Vector3& direction, double tMin, double tMax, std::vector<RayHit>& hits) const
{
  hits.clear();
  EmbreeRay query;
  if (!this->Impl->Prepare(origin, direction, tMin, tMax, query))
  {
    return;
  }
  RTCRayHit rayHit;
  rayHit.ray = query.Ray;
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  thread_local std::vector<FoundTriangle> found;
  found.clear();
  Collect(this->Impl->Scene, rayHit, found);
  std::sort(found.begin(), found.end(), [](const FoundTriangle& a, const FoundTriangle& b) {
    return a.Triangle != b.Triangle ? a.Triangle < b.Triangle : a.T < b.T;
  });

  for (const FoundTriangle& one : found)
  {
    if (!hits.empty() && hits.back().Triangle == one.Triangle)
    {
      continue;
    }
    RayHit hit;
    hit.Triangle = one.Triangle;
    hit.T = this->Impl->Refine(one.Triangle, origin, direction, query.Start + one.T / this->Impl->Scale);
    hit.FrontFacing = Dot(this->TriangleNormal(one.Triangle), direction) <= 0.0;
    hits.push_back(hit);
  }
  std::sort(hits.begin(), hits.end(),
    [](const RayHit& a, const RayHit& b) { return a.T != b.T ? a.T < b.T : a.Triangle < b.Triangle; });
}

bool OccluderScene::Occluded(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const
{
  EmbreeRay query;
  if (!this->Impl->Prepare(origin, direction, tMin, tMax, query))
  {
    return false;
  }
  Any(this->Impl->Scene, query.Ray);
  return query.Ray.tfar < 0.0f;
}

std::uint64_t OccluderScene::OccludedFrom(const Vector3& origin, const double* x, const double* y, const double* z,
  std::uint64_t wanted, bool infinity) const
{
  const Implementation& impl = *this->Impl;
  const Vector3 start = impl.Scale * (origin - impl.Center);
  if (impl.Bounds.Empty() || !IsFinite(start))
  {
    return 0;
  }
  std::uint64_t occluded = 0;
  // From far away rays are to start at the bounds, each at its own place.
  if (Dot(start, start) > farthestPacket * farthestPacket)
  {
    for (int k = 0; k < 64; ++k)
    {
      const Vector3 to{ x[k], y[k], z[k] };
      const double distance = (wanted >> k) & 1u ? Length(to) : 0.0;
      const double end = infinity ? HUGE_VAL : distance - impl.Epsilon;
      const bool hit = distance > 0.0 && this->Occluded(origin, (1.0 / distance) * to, impl.Epsilon, end);
      occluded |= static_cast<std::uint64_t>(hit) << k;
    }
    return occluded;
  }
  for (int first = 0; first < 64; first += packetSize)
  {
    if (((wanted >> first) & ((1u << packetSize) - 1)) == 0)
    {
      continue;
    }
    alignas(32) RTCRay8 rays;
    alignas(32) int valid[packetSize];
    for (int k = 0; k < packetSize; ++k)
    {
      const double dx = x[first + k];
      const double dy = y[first + k];
      const double dz = z[first + k];
      const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
      const bool asked = ((wanted >> (first + k)) & 1u) && distance > 0.0 && std::isfinite(distance);
      const double scale = asked ? 1.0 / distance : 0.0;
      const double end = infinity ? HUGE_VAL : impl.Scale * (distance - impl.Epsilon);
      valid[k] = asked ? -1 : 0;
      rays.org_x[k] = static_cast<float>(start.X);
      rays.org_y[k] = static_cast<float>(start.Y);
      rays.org_z[k] = static_cast<float>(start.Z);
      rays.dir_x[k] = static_cast<float>(dx * scale);
      rays.dir_y[k] = static_cast<float>(dy * scale);
      rays.dir_z[k] = static_cast<float>(dz * scale);
      rays.tnear[k] = static_cast<float>(impl.Scale * impl.Epsilon);
      rays.tfar[k] = static_cast<float>(end);
      rays.time[k] = 0.0f;
      rays.mask[k] = ~0u;
      rays.id[k] = 0;
      rays.flags[k] = 0;
    }
    AnyOfPacket(valid, impl.Scene, rays);
    for (int k = 0; k < packetSize; ++k)
    {
      const bool hit = valid[k] && rays.tfar[k] < 0.0f;
      occluded |= static_cast<std::uint64_t>(hit) << (first + k);
    }
  }
  return occluded;
}

Vector3 OccluderScene::TriangleNormal(vtkIdType triangle) const
{
  const TriangleMeshView& mesh = this->Impl->Mesh;
  const Vector3 a = mesh.Corner(triangle, 0);
  return Normalized(Cross(mesh.Corner(triangle, 1) - a, mesh.Corner(triangle, 2) - a));
}

} // namespace shadowcones
