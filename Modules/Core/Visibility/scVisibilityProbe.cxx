// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityProbe.h"

#include "scBits.h"
#include "scConeHierarchy.h"
#include "scLampPlane.h"
#include "scLightPatterns.h"
#include "scSurfelVisibility.h"
#include "scWholeLight.h"

#include <algorithm>
#include <limits>
#include <optional>

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
  LightMask Seen;  ///< those of them that no occluder hides
  std::vector<OccluderScene::MetTriangle> Met;
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

/// Find the samples that neither the point's own surface nor an occluder hides. @return their number.
int FindSeen(Scratch& scratch)
{
  const std::size_t blocks = scratch.Masks.NumberOfBlocks;
  scratch.Seen = scratch.Above;
  int visible = 0;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    for (std::size_t i = 0; i < scratch.Masks.OccluderIds.size(); ++i)
    {
      scratch.Seen[block] &= ~scratch.Masks.Words[i * blocks + block];
    }
    visible += CountBits(scratch.Seen[block]);
  }
  return visible;
}

int CountAll(const LightMask& mask)
{
  int count = 0;
  for (const std::uint64_t word : mask)
  {
    count += CountBits(word);
  }
  return count;
}

/// The occluder of all triangles; none where there are several.
std::optional<int> OnlyOccluderOf(const TriangleMeshView& mesh)
{
  for (vtkIdType t = 1; t < mesh.NumberOfTriangles; ++t)
  {
    if (mesh.OccluderId(t) != mesh.OccluderId(0))
    {
      return {};
    }
  }
  return mesh.NumberOfTriangles > 0 ? std::optional<int>(mesh.OccluderId(0)) : std::nullopt;
}

LightPatternOptions PatternsOf(const VisibilityOptions& options)
{
  LightPatternOptions patterns;
  patterns.NumberOfSamples = options.NumberOfLightSamples;
  patterns.Seed = options.Seed;
  patterns.Same = options.SameSamples;
  patterns.Outline = options.Outline;
  return patterns;
}
} // anonymous namespace

struct VisibilityProbe::Implementation
{
  Implementation(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene, const Box& bounds,
    const VisibilityOptions& options)
    : Patterns(light, PatternsOf(options))
    , Scene(scene)
    , Rules(scene ? scene->RulesFor(FlatFaceOf(light)) : RayRules())
    , AtInfinity(IsAtInfinity(light))
    , Irradiance(options.Irradiance)
    , Fluence(options.Fluence)
  {
    LightBoundingSphere(light, this->Center, this->Radius);
    if (scene)
    {
      this->OnlyOccluder = OnlyOccluderOf(scene->Mesh());
    }
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
    const LightView& view = scratch.View;
    for (std::size_t block = 0; block < wanted.size(); ++block)
    {
      const std::size_t first = 64 * block;
      const std::uint64_t hidden = this->Scene->OccludedFrom(point, view.X.data() + first, view.Y.data() + first,
        view.Z.data() + first, wanted[block], this->AtInfinity, rules);
      if (this->OnlyOccluder && hidden != 0)
      {
        scratch.Masks.Of(*this->OnlyOccluder)[block] |= hidden;
        continue;
      }
      // Whose shadow it is asks for all that a ray meets.
      this->Scene->TrianglesFrom(point, view.X.data() + first, view.Y.data() + first, view.Z.data() + first, hidden,
        this->AtInfinity, scratch.Met, rules);
      for (const OccluderScene::MetTriangle& met : scratch.Met)
      {
        scratch.Masks.Of(this->Scene->Mesh().OccluderId(met.Triangle))[block] |= std::uint64_t(1) << met.Ray;
      }
    }
  }

  /// What hides samples from the point, into the scratch; its view is taken and the samples above the surface are found.
  void Hide(const Vector3& point, const Vector3* normal, int side, bool shadowed, Scratch& scratch) const
  {
    scratch.Above = scratch.View.Open;
    if (side == 0)
    {
      this->DropBelow(*normal, scratch);
    }
    scratch.Masks.Reset(this->Patterns.NumberOfBlocks());
    if (shadowed && this->Surfels)
    {
      this->Surfels->Hide(point, scratch.Discs, scratch.View, scratch.Masks);
    }
    else if (shadowed)
    {
      this->Trace(point, scratch.Above, scratch);
    }
  }

  /// All that the light brings, where nothing can hide it but the point's own surface.
  void AddWhole(const Vector3& point, const Vector3* normal, PointVisibility& result) const
  {
    if (this->Irradiance && normal)
    {
      result.Irradiance.Factor = WholeIrradiance(this->Patterns.Lamp(), point, *normal);
    }
    if (this->Fluence)
    {
      result.Fluence.Factor = WholeFluence(this->Patterns.Lamp(), point);
    }
  }

  /// What the samples that are seen bring. @param cut the surface's own plane may cut the light.
  void AddSeen(const Vector3& point, const Vector3* normal, bool shadowed, bool cut, const Scratch& scratch,
    PointVisibility& result) const
  {
    SeenWeights irradiance;
    SeenWeights fluence;
    for (int k = 0; k < this->Patterns.Count(); ++k)
    {
      const std::uint64_t bit = std::uint64_t(1) << (k % 64);
      if (!(scratch.View.Open[k / 64] & bit))
      {
        continue;
      }
      const bool seen = (scratch.Seen[k / 64] & bit) != 0;
      const double weight = this->Patterns.WeightOf(scratch.View, static_cast<std::size_t>(k));
      fluence.Add(weight, seen);
      if (normal)
      {
        const Vector3 to{ scratch.View.X[k], scratch.View.Y[k], scratch.View.Z[k] };
        irradiance.Add(weight * std::max(Dot(to, *normal) / Length(to), 0.0), seen);
      }
    }
    PointVisibility whole;
    this->AddWhole(point, normal, whole);
    // The plane of the surface cuts the closed form of the irradiance, not that of the fluence.
    result.Irradiance = shadowed ? irradiance.Of(whole.Irradiance.Factor) : whole.Irradiance;
    result.Fluence = shadowed || cut ? fluence.Of(whole.Fluence.Factor) : whole.Fluence;
    if (this->Patterns.IsExact())
    {
      result.Irradiance.Error = 0.0;
      result.Fluence.Error = 0.0;
    }
  }

  LightPatterns Patterns;
  const OccluderScene* Scene;
  RayRules Rules; ///< for what is flush with the light
  bool AtInfinity;
  bool Irradiance;
  bool Fluence;
  std::optional<int> OnlyOccluder; ///< of the mesh, where it has one alone: who hides a sample needs no asking
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
    impl.AddWhole(point, normal, result);
    return result;
  }

  impl.Patterns.LookFrom(point, scratch.View);
  SeenSamples seen;
  seen.Emitting = CountAll(scratch.View.Open);
  if (seen.Emitting == 0 || side < 0)
  {
    result.Fraction = 0.0;
    result.Class = ShadowClass::Umbra;
    return result;
  }

  impl.Hide(point, normal, side, shadowed, scratch);
  seen.Visible = FindSeen(scratch);
  result.OccluderId = MainOccluder(scratch);
  result.Fraction = seen.Fraction();
  result.Class = seen.Class();
  if (impl.Irradiance || impl.Fluence)
  {
    impl.AddSeen(point, normal, shadowed, side == 0, scratch, result);
  }
  if ((shadowed || side == 0) && !impl.Patterns.IsExact())
  {
    const double p = (seen.Visible + 0.5) / (seen.Emitting + 1.0);
    result.Error = std::sqrt(p * (1.0 - p) / seen.Emitting);
  }
  return result;
}

int VisibilityProbe::NumberOfSamples() const
{
  return this->Impl->Patterns.Count();
}

bool VisibilityProbe::AsksForIrradiance() const
{
  return this->Impl->Irradiance;
}

bool VisibilityProbe::AsksForFluence() const
{
  return this->Impl->Fluence;
}

int VisibilityProbe::ShadowsAt(
  const Vector3& point, const Vector3* normal, std::vector<HiddenSamples>& hidden, int& together) const
{
  thread_local Scratch scratch;
  const Implementation& impl = *this->Impl;
  hidden.clear();
  together = 0;
  const int side = normal ? impl.SideOf(point, *normal) : 1;
  if (side < 0)
  {
    return 0;
  }
  const bool shadowed = impl.MayBeShadowed(point, scratch);
  impl.Patterns.LookFrom(point, scratch.View);
  impl.Hide(point, normal, side, shadowed, scratch);
  const int shining = CountAll(scratch.Above);
  together = shining - FindSeen(scratch);
  const std::size_t blocks = scratch.Masks.NumberOfBlocks;
  for (std::size_t i = 0; i < scratch.Masks.OccluderIds.size(); ++i)
  {
    int count = 0;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      count += CountBits(scratch.Masks.Words[i * blocks + block] & scratch.Above[block]);
    }
    if (count > 0)
    {
      hidden.push_back({ scratch.Masks.OccluderIds[i], count });
    }
  }
  std::sort(hidden.begin(), hidden.end(),
    [](const HiddenSamples& a, const HiddenSamples& b) { return a.OccluderId < b.OccluderId; });
  return shining;
}

bool ProbeVisibility(const VisibilityProbe& probe, const double* points, const double* normals, vtkIdType count,
  const Monitor& monitor, VisibilityResult& result)
{
  return ProbeVisibility(std::vector<const VisibilityProbe*>{ &probe }, points, normals, count, monitor, result);
}

namespace
{
void Resize(const std::vector<const VisibilityProbe*>& probes, std::size_t size, VisibilityResult& result)
{
  const bool irradiance = !probes.empty() && probes.front()->AsksForIrradiance();
  const bool fluence = !probes.empty() && probes.front()->AsksForFluence();
  result.Visibility.resize(size);
  result.ShadowClasses.resize(size);
  result.OccluderIds.resize(size);
  result.Errors.resize(size);
  result.Irradiance.resize(irradiance ? size : 0);
  result.IrradianceErrors.resize(irradiance ? size : 0);
  result.Fluence.resize(fluence ? size : 0);
  result.FluenceErrors.resize(fluence ? size : 0);
}

void Put(const PointVisibility& visibility, bool hasNormal, std::size_t at, VisibilityResult& result)
{
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  result.Visibility[at] = static_cast<float>(visibility.Fraction);
  result.ShadowClasses[at] = static_cast<unsigned char>(visibility.Class);
  result.OccluderIds[at] = visibility.OccluderId;
  result.Errors[at] = static_cast<float>(visibility.Error);
  if (!result.Irradiance.empty())
  {
    result.Irradiance[at] = hasNormal ? static_cast<float>(visibility.Irradiance.Factor) : unknown;
    result.IrradianceErrors[at] = hasNormal ? static_cast<float>(visibility.Irradiance.Error) : unknown;
  }
  if (!result.Fluence.empty())
  {
    result.Fluence[at] = static_cast<float>(visibility.Fluence.Factor);
    result.FluenceErrors[at] = static_cast<float>(visibility.Fluence.Error);
  }
}
} // anonymous namespace

bool ProbeVisibility(const std::vector<const VisibilityProbe*>& probes, const double* points, const double* normals,
  vtkIdType count, const Monitor& monitor, VisibilityResult& result, Team* workers)
{
  Resize(probes, static_cast<std::size_t>(count) * probes.size(), result);
  constexpr vtkIdType pointsPerBlock = 64; // dealt out to processes: near ones take about as long
  const TeamShare share(workers, count, pointsPerBlock);
  const auto components = static_cast<vtkIdType>(probes.size());
  TeamJoin join(workers);
  join.AddItems(result.ShadowClasses, share, components);
  join.AddItems(result.OccluderIds, share, components);
  for (std::vector<float>* values : { &result.Visibility, &result.Errors, &result.Irradiance, &result.IrradianceErrors,
         &result.Fluence, &result.FluenceErrors })
  {
    join.AddItems(*values, share, components);
  }
  return TeamFor(workers, join, share, monitor,
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
          Put(probe->At(point, hasNormal ? &normal : nullptr), hasNormal, at, result);
          ++at;
        }
      }
    });
}

} // namespace shadowcones
