// SPDX-License-Identifier: BSD-3-Clause
// What a query of the cone hierarchy costs, beside a linear scan and beside Embree with the cones as user geometry.
//
// n cones stand on a 4 x 4 square under a disc light, base radius 2.4 / sqrt(n): the density of a fitted, overlapping set. Rays
// cross the room as a camera's do; points are uniform in it. Every row is the median of several runs in one process; the
// exponents are slopes of log(time) over log(n) between neighbouring rows.
#include "ProgramOptions.h"
#include "Room.h"
#include "scCone.h"
#include "scConeHierarchy.h"
#include "scConeIntervals.h"
#include "scLight.h"
#include "scLightExtent.h"
#include "scOccluderInterval.h"
#include "scRandom.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>

using namespace shadowcones;

namespace
{
std::vector<Cone> MakeCones(int count)
{
  const Light light = testsupport::RoomLight({ 1.0 });
  const LightExtent extent = LightExtentOf(light);
  std::vector<Cone> cones(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    RandomStream random(1, static_cast<std::uint64_t>(i));
    Cone& cone = cones[i];
    cone.Center = { 4.0 * random.Next() - 2.0, 2.5 + random.Next(), 4.0 * random.Next() - 2.0 };
    cone.Axis = Normalized(cone.Center - light.Center);
    cone.Normal = cone.Axis;
    cone.BaseRadius = 2.4 / std::sqrt(static_cast<double>(count));
    cone.OccluderId = i;
    PenumbraAngles(extent, cone.Center, cone.Axis, cone.BaseRadius, cone.HalfAngle, cone.InnerHalfAngle);
  }
  return cones;
}

std::vector<Ray> MakeRays(int count)
{
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
  {
    RandomStream random(2, static_cast<std::uint64_t>(i));
    const Vector3 eye{ 0.0, 2.75, 10.0 };
    const Vector3 target{ 5.5 * random.Next() - 2.75, 5.2 * random.Next(), 2.75 };
    rays.push_back({ eye, Normalized(target - eye) });
  }
  return rays;
}

/// Median nanoseconds of one call, over runs of all items.
template <typename Body>
double Nanoseconds(int items, int runs, Body&& body)
{
  std::vector<double> times;
  for (int run = 0; run < runs; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < items; ++i)
    {
      body(i);
    }
    const std::chrono::duration<double, std::nano> span = std::chrono::steady_clock::now() - start;
    times.push_back(span.count() / items);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// The cones as user geometry: one box each, every cone along the ray noted, the hit refused.
class EmbreeCones
{
public:
  EmbreeCones(const std::vector<Cone>& cones, const Box& bounds)
    : Cones(cones)
    , Bounds(bounds)
    , Device(rtcNewDevice(nullptr))
    , Scene(rtcNewScene(this->Device))
  {
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(cones.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, BoundsOf, this);
    rtcSetGeometryIntersectFunction(geometry, Meet);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
  }
  ~EmbreeCones()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }
  EmbreeCones(const EmbreeCones&) = delete;
  EmbreeCones& operator=(const EmbreeCones&) = delete;

  void Intersect(const Ray& ray, std::vector<OccluderInterval>& intervals)
  {
    intervals.clear();
    double tMin = 0.0;
    double tMax = HUGE_VAL;
    if (!this->Bounds.Clip(ray.Origin, ray.Direction, tMin, tMax))
    {
      return;
    }
    this->Current = &ray;
    this->Found = &intervals;
    this->From = tMin;
    this->To = tMax;
    RTCRayHit hit{};
    hit.ray.org_x = static_cast<float>(ray.Origin.X);
    hit.ray.org_y = static_cast<float>(ray.Origin.Y);
    hit.ray.org_z = static_cast<float>(ray.Origin.Z);
    hit.ray.dir_x = static_cast<float>(ray.Direction.X);
    hit.ray.dir_y = static_cast<float>(ray.Direction.Y);
    hit.ray.dir_z = static_cast<float>(ray.Direction.Z);
    hit.ray.tnear = static_cast<float>(tMin);
    hit.ray.tfar = static_cast<float>(tMax);
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(this->Scene, &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(this->Scene, &context, &hit);
#endif
    MergeIntervals(intervals);
  }

private:
  static void BoundsOf(const RTCBoundsFunctionArguments* arguments)
  {
    const auto* self = static_cast<const EmbreeCones*>(arguments->geometryUserPtr);
    const Cone& cone = self->Cones[arguments->primID];
    const double height = (cone.Center.Y - self->Bounds.Min.Y) / std::max(-cone.Axis.Y, 1e-3);
    Box box;
    for (const double h : { 0.0, height })
    {
      const double r = cone.BaseRadius + h * std::tan(cone.HalfAngle);
      const Vector3 center = cone.Center + h * cone.Axis;
      box.Add(center - Vector3{ r, r, r });
      box.Add(center + Vector3{ r, r, r });
    }
    RTCBounds& out = *arguments->bounds_o;
    out.lower_x = static_cast<float>(std::max(box.Min.X, self->Bounds.Min.X));
    out.lower_y = static_cast<float>(std::max(box.Min.Y, self->Bounds.Min.Y));
    out.lower_z = static_cast<float>(std::max(box.Min.Z, self->Bounds.Min.Z));
    out.upper_x = static_cast<float>(std::min(box.Max.X, self->Bounds.Max.X));
    out.upper_y = static_cast<float>(std::min(box.Max.Y, self->Bounds.Max.Y));
    out.upper_z = static_cast<float>(std::min(box.Max.Z, self->Bounds.Max.Z));
  }
  static void Meet(const RTCIntersectFunctionNArguments* arguments)
  {
    if (!arguments->valid[0])
    {
      return;
    }
    auto* self = static_cast<EmbreeCones*>(arguments->geometryUserPtr);
    OccluderInterval interval;
    if (IntersectCone(self->Cones[arguments->primID], HUGE_VAL, { self->Current->Origin, self->Current->Direction },
          { self->From, self->To }, interval))
    {
      self->Found->push_back(interval);
    }
  }

  const std::vector<Cone>& Cones;
  const Box Bounds;
  RTCDevice Device;
  RTCScene Scene;
  const Ray* Current = nullptr;
  std::vector<OccluderInterval>* Found = nullptr;
  double From = 0.0;
  double To = 0.0;
};

double Exponent(double before, double after, double nBefore, double nAfter)
{
  return before > 0.0 ? std::log(after / before) / std::log(nAfter / nBefore) : 0.0;
}
} // anonymous namespace

int main(int argc, char** argv)
{
  std::vector<int> numbers{ 100, 1000, 10000, 100000 };
  int queries = 4000;
  int runs = 5;
  ProgramOptions commandLine("What a query of the cone hierarchy costs, beside a linear scan and beside Embree user geometry");
  commandLine.Add("--cones", numbers, "numbers of cones");
  commandLine.Add("--queries", queries, "rays and points");
  commandLine.Add("--runs", runs, "runs of which the median is printed");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }

  const Box room = testsupport::RoomBounds();
  const std::vector<Ray> rays = MakeRays(queries);
  std::vector<Vector3> points;
  for (int i = 0; i < queries; ++i)
  {
    RandomStream random(3, static_cast<std::uint64_t>(i));
    points.push_back({ 5.5 * random.Next() - 2.75, 5.2 * random.Next(), 5.5 * random.Next() - 2.75 });
  }
  std::printf("ns a query; exponents against the row above in brackets\n");
  std::printf("%8s %10s %18s %18s %14s %16s %18s %14s %10s\n", "cones", "build ms", "ray", "ray linear", "ray Embree",
    "ray by occluder", "point", "point linear", "hits/ray");
  double last[5] = {};
  double lastNumber = 1.0;
  for (const int number : numbers)
  {
    const std::vector<Cone> cones = MakeCones(number);
    const auto start = std::chrono::steady_clock::now();
    const ConeHierarchy hierarchy(cones, room);
    const double build = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    EmbreeCones embree(cones, room);
    std::vector<OccluderInterval> intervals;
    double sum = 0.0; // keeps the work from being dropped
    double hits = 0.0;
    const auto add = [&]()
    {
      for (const OccluderInterval& interval : intervals)
      {
        sum += interval.End - interval.Begin;
      }
    };
    const int linearQueries = std::max(20, std::min(queries, 20000000 / number));
    double times[5];
    times[0] = Nanoseconds(queries, runs, [&](int i) {
      hierarchy.Intersect(rays[i].Origin, rays[i].Direction, 0.0, HUGE_VAL, intervals);
      add();
    });
    times[1] = Nanoseconds(linearQueries, std::min(runs, 3), [&](int i) {
      intervals.clear();
      double tMin = 0.0;
      double tMax = HUGE_VAL;
      if (room.Clip(rays[i].Origin, rays[i].Direction, tMin, tMax))
      {
        OccluderInterval interval;
        for (const Cone& cone : cones)
        {
          if (IntersectCone(cone, HUGE_VAL, rays[i], { tMin, tMax }, interval))
          {
            intervals.push_back(interval);
          }
        }
      }
      hits += static_cast<double>(intervals.size());
      MergeIntervals(intervals);
      add();
    });
    times[2] = Nanoseconds(queries, runs, [&](int i) {
      embree.Intersect(rays[i], intervals);
      add();
    });
    const double perOccluder = Nanoseconds(queries, runs, [&](int i) {
      hierarchy.Intersect(rays[i].Origin, rays[i].Direction, 0.0, HUGE_VAL, intervals, true);
      add();
    });
    times[3] = Nanoseconds(queries, runs, [&](int i) { sum += hierarchy.Contains(points[i]); });
    times[4] = Nanoseconds(linearQueries, std::min(runs, 3), [&](int i) {
      sum += std::any_of(cones.begin(), cones.end(), [&](const Cone& cone) { return ConeContains(cone, points[i]); });
    });
    double exponents[5];
    for (int k = 0; k < 5; ++k)
    {
      exponents[k] = Exponent(last[k], times[k], lastNumber, number);
      last[k] = times[k];
    }
    std::printf("%8d %10.1f %11.0f [%4.2f] %11.0f [%4.2f] %14.0f %14.0f %11.0f [%4.2f] %14.0f %10.1f\n", number, build,
      times[0], exponents[0], times[1], exponents[1], times[2], perOccluder, times[3], exponents[3], times[4],
      hits / (linearQueries * std::min(runs, 3)));
    std::fflush(stdout);
    lastNumber = number;
    if (!std::isfinite(sum))
    {
      return 1;
    }
  }
  return 0;
}
