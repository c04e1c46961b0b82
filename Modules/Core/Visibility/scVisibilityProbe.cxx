// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityProbe.h"

#include "scBits.h"
#include "scConeHierarchy.h"
#include "scLampPlane.h"
#include "scLightPatterns.h"
#include "scSurfelVisibility.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// What one point needs; kept from point to point.
struct Scratch
{
  LightView View;
  OccluderMasks Masks;
  LightMask Above; ///< samples that the point's own surface lets through
  std::vector<RayHit> Hits;
  std::vector<int> Discs; ///< that may hide light
};

Box Grown(Box box)
{
  // Points on the faces of the box belong to it, whatever the rounding.
  const double size = std::max(Length(box.Min), Length(box.Max));
  const double margin = 1e-6 * box.Diagonal() + 1e-12 * size;
  box.Min = box.Min - Vector3{ margin, margin, margin };
  box.Max = box.Max + Vector3{ margin, margin, margin };
  return box;
}

/// The occluder that hides most samples, the smallest id of several; -1: none hides any.
int MainOccluder(const Scratch& scratch)
{
  const std::size_t blocks = scratch.Masks.NumberOfBlocks;
  int found = -1;
  int most = 0;
  for (std::size_t i = 0; i < scratch.Masks.OccluderIds.size(); ++i)
  {
    int hidden = 0;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      hidden += CountBits(scratch.Masks.Words[i * blocks + block] & scratch.Above[block]);
    }
    const int id = scratch.Masks.OccluderIds[i];
    if (hidden > most || (hidden == most && hidden > 0 && id < found))
    {
      most = hidden;
      found = id;
    }
  }
  return found;
}

/// Samples that neither the point's own surface nor an occluder hides.
int CountVisible(const Scratch& scratch)
{
  const std::size_t blocks = scratch.Masks.NumberOfBlocks;
  int visible = 0;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    std::uint64_t hidden = 0;
    for (std::size_t i = 0; i < scratch.Masks.OccluderIds.size(); ++i)
    {
      hidden |= scratch.Masks.Words[i * blocks + block];
    }
    visible += CountBits(scratch.Above[block] & ~hidden);
  }
  return visible;
}
} // anonymous namespace

struct VisibilityProbe::Implementation
{
  Implementation(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene, const Box& bounds,
    const VisibilityOptions& options)
    : Patterns(light, options.NumberOfLightSamples, options.Seed)
    , Scene(scene)
    , Rules(scene ? scene->RulesFor(FlatFaceOf(light)) : RayRules())
    , AtInfinity(IsAtInfinity(light))
  {
    LightBoundingSphere(light, this->Center, this->Radius);
    if (options.Method == VisibilityMethod::Soft)
    {
      this->Surfels = std::make_unique<SurfelVisibility>(cones, this->Patterns, Grown(bounds), options.OnSurfaces);
    }
    else
    {
      this->Bounds = std::make_unique<ConeHierarchy>(Lengthened(cones), Grown(bounds));
    }
  }

  /// 1: all of the light is above the surface; -1: all of it is below; 0: neither, or not known.
  int SideOf(const Vector3& point, const Vector3& normal) const
  {
    const Light& light = this->Patterns.Lamp();
    const double height = this->AtInfinity ? -Dot(normal, light.Normal) : Dot(normal, this->Center - point);
    const double reach = this->AtInfinity ? std::sin(light.Radius) : this->Radius;
    return height > reach ? 1 : (height < -reach ? -1 : 0);
  }

  /// Can an occluder hide anything from the point? Lists the discs that may.
  bool MayBeShadowed(const Vector3& point, Scratch& scratch) const
  {
    if (this->Surfels)
    {
      this->Surfels->Find(point, scratch.Discs);
      return !scratch.Discs.empty();
    }
    return this->Scene && this->Bounds->Contains(point);
  }

  /// Drop the samples below the point's own surface.
  void DropBelow(const Vector3& normal, Scratch& scratch) const
  {
    for (int k = 0; k < this->Patterns.Count(); ++k)
    {
      const Vector3 to{ scratch.View.X[k], scratch.View.Y[k], scratch.View.Z[k] };
      const std::uint64_t below = Dot(to, normal) > 0.0 ? 0 : 1;
      scratch.Above[k / 64] &= ~(below << (k % 64));
    }
  }

  /// Add what the mesh hides of the samples in @p wanted.
  void Trace(const Vector3& point, const LightMask& wanted, Scratch& scratch) const
  {
    RayRules rules = this->Rules;
    rules.StartTolerance = this->Scene->SurfaceTolerance(point);
    for (int k = 0; k < this->Patterns.Count(); ++k)
    {
      const std::uint64_t bit = std::uint64_t(1) << (k % 64);
      if (!(wanted[k / 64] & bit))
      {
        continue;
      }
      const Vector3 to{ scratch.View.X[k], scratch.View.Y[k], scratch.View.Z[k] };
      const double distance = Length(to);
      const Vector3 direction = (1.0 / distance) * to;
      const double end = this->AtInfinity ? HUGE_VAL : distance;
      if (!this->Scene->Occluded(point, direction, 0.0, end, rules))
      {
        continue;
      }
      this->Scene->IntersectAll(point, direction, 0.0, end, scratch.Hits, rules);
      for (const RayHit& hit : scratch.Hits)
      {
        scratch.Masks.Of(this->Scene->Mesh().OccluderId(hit.Triangle))[k / 64] |= bit;
      }
    }
  }

  LightPatterns Patterns;
  const OccluderScene* Scene;
  RayRules Rules; ///< for what is flush with the light
  bool AtInfinity;
  Vector3 Center;
  double Radius = 0.0;
  std::unique_ptr<SurfelVisibility> Surfels; ///< Soft
  std::unique_ptr<ConeHierarchy> Bounds;     ///< Exact
};

VisibilityProbe::VisibilityProbe(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene,
  const Box& bounds, const VisibilityOptions& options)
  : Impl(new Implementation(cones, light, scene, bounds, options))
{
}

VisibilityProbe::~VisibilityProbe() = default;

PointVisibility VisibilityProbe::At(const Vector3& point, const Vector3* normal) const
{
  thread_local Scratch scratch;
  const Implementation& impl = *this->Impl;
  PointVisibility result;

  // Where nothing can be in the way no sample is taken.
  const int side = normal ? impl.SideOf(point, *normal) : 1;
  const bool shadowed = impl.MayBeShadowed(point, scratch);
  if (side > 0 && !shadowed && impl.Patterns.IsWholeFrom(point))
  {
    return result;
  }

  impl.Patterns.LookFrom(point, scratch.View);
  SeenSamples seen;
  for (const std::uint64_t word : scratch.View.Open)
  {
    seen.Emitting += CountBits(word);
  }
  if (seen.Emitting == 0 || side < 0)
  {
    result.Fraction = 0.0;
    result.Class = ShadowClass::Umbra;
    return result;
  }

  scratch.Above = scratch.View.Open;
  if (side == 0)
  {
    impl.DropBelow(*normal, scratch);
  }
  scratch.Masks.Reset(impl.Patterns.NumberOfBlocks());
  if (shadowed && impl.Surfels)
  {
    impl.Surfels->Hide(point, scratch.Discs, scratch.View, scratch.Masks);
  }
  else if (shadowed)
  {
    impl.Trace(point, scratch.Above, scratch);
  }
  seen.Visible = CountVisible(scratch);

  result.OccluderId = MainOccluder(scratch);
  result.Fraction = seen.Fraction();
  result.Class = seen.Class();
  if ((shadowed || side == 0) && !impl.Patterns.IsExact())
  {
    const double p = (seen.Visible + 0.5) / (seen.Emitting + 1.0);
    result.Error = std::sqrt(p * (1.0 - p) / seen.Emitting);
  }
  return result;
}

bool ProbeVisibility(const VisibilityProbe& probe, const double* points, const double* normals, vtkIdType count,
  const Monitor& monitor, VisibilityResult& result)
{
  return ProbeVisibility(std::vector<const VisibilityProbe*>{ &probe }, points, normals, count, monitor, result);
}

bool ProbeVisibility(const std::vector<const VisibilityProbe*>& probes, const double* points, const double* normals,
  vtkIdType count, const Monitor& monitor, VisibilityResult& result)
{
  const auto size = static_cast<std::size_t>(count) * probes.size();
  result.Visibility.resize(size);
  result.ShadowClasses.resize(size);
  result.OccluderIds.resize(size);
  result.Errors.resize(size);
  return ParallelFor(count, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Vector3 point{ points[3 * i], points[3 * i + 1], points[3 * i + 2] };
        Vector3 normal;
        if (normals)
        {
          normal = Normalized({ normals[3 * i], normals[3 * i + 1], normals[3 * i + 2] });
        }
        const bool hasNormal = Dot(normal, normal) > 0.0;
        auto at = static_cast<std::size_t>(i) * probes.size();
        for (const VisibilityProbe* probe : probes)
        {
          const PointVisibility visibility = probe->At(point, hasNormal ? &normal : nullptr);
          result.Visibility[at] = static_cast<float>(visibility.Fraction);
          result.ShadowClasses[at] = static_cast<unsigned char>(visibility.Class);
          result.OccluderIds[at] = visibility.OccluderId;
          result.Errors[at] = static_cast<float>(visibility.Error);
          ++at;
        }
      }
    });
}

} // namespace shadowcones
