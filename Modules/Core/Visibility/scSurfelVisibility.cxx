// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfelVisibility.h"

#include "scSurfelMask.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Wider penumbrae are as good as everywhere.
constexpr double widestHalfAngle = 1.5;
/// Points within this share of the radius from a disc's plane lie on it; on curved surfaces within three rms distances.
constexpr double flatTolerance = 1e-3;
constexpr double curvedTolerance = 3.0;
} // anonymous namespace

bool PenumbraOf(const Cone& disc, const Light& light, const LightExtent& extent, Cone& penumbra)
{
  penumbra = disc;
  penumbra.Axis = extent.AtInfinity ? light.Normal : Normalized(disc.Center - extent.Center);
  const double cosine = Dot(penumbra.Axis, disc.Normal);
  const double depth = disc.BaseRadius * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  penumbra.Center = disc.Center - depth * penumbra.Axis;
  PenumbraAngles(extent, penumbra.Center, penumbra.Axis, disc.BaseRadius, penumbra.HalfAngle, penumbra.InnerHalfAngle);
  return penumbra.HalfAngle > 0.0 && penumbra.HalfAngle < widestHalfAngle && Length(penumbra.Axis) > 0.5;
}

SurfelVisibility::SurfelVisibility(
  const std::vector<Cone>& cones, const LightPatterns& light, const Box& bounds, bool onSurfaces)
  : Light(light)
  , Tree(ConeTree::OverSlices({}, bounds, HUGE_VAL))
{
  const LightExtent extent = LightExtentOf(light.Lamp());
  for (const Cone& cone : cones)
  {
    if (!(cone.BaseRadius > 0.0))
    {
      continue;
    }
    const double tolerance = onSurfaces ? std::max(flatTolerance, curvedTolerance * cone.Planarity) : flatTolerance;
    const auto index = static_cast<int>(this->Surfels.size());
    this->Surfels.push_back(
      { cone.Center, cone.Normal, cone.BaseRadius, tolerance * cone.BaseRadius, cone.OccluderId });
    Cone penumbra;
    if (PenumbraOf(cone, light.Lamp(), extent, penumbra))
    {
      this->Penumbrae.push_back(penumbra);
      this->Tangents.push_back(std::tan(penumbra.HalfAngle));
      this->SurfelOf.push_back(index);
    }
    else
    {
      this->Unbounded.push_back(index);
    }
  }
  this->Tree = ConeTree::OverSlices(this->Penumbrae, bounds, HUGE_VAL);
}

void SurfelVisibility::Find(const Vector3& point, std::vector<int>& surfels) const
{
  surfels = this->Unbounded;
  this->Tree.ForEachAtPoint(point,
    [&](const ConeTree::Entry& entry)
    {
      const Cone& cone = this->Penumbrae[entry.Cone];
      const Vector3 offset = point - cone.Center;
      const double height = Dot(offset, cone.Axis);
      // Rounding must not drop a disc at the skin of its penumbra or between two slices.
      const double radius = (cone.BaseRadius + height * this->Tangents[entry.Cone]) * (1.0 + 1e-9);
      const double margin = 1e-9 * (std::abs(height) + cone.BaseRadius);
      const Vector3 lateral = offset - height * cone.Axis;
      if (height >= entry.Low - margin && height <= entry.High + margin && Dot(lateral, lateral) <= radius * radius)
      {
        surfels.push_back(this->SurfelOf[entry.Cone]);
      }
    });
}

void SurfelVisibility::Hide(
  const Vector3& point, const std::vector<int>& surfels, const LightView& view, OccluderMasks& masks) const
{
  for (const int index : surfels)
  {
    this->HideBySurfel(this->Surfels[index], point, view, masks);
  }
}

void SurfelVisibility::HideBySurfel(
  const Surfel& surfel, const Vector3& point, const LightView& view, OccluderMasks& masks) const
{
  const Vector3 q = point - surfel.Center;
  const double height = Dot(surfel.Normal, q);
  if (std::abs(height) <= surfel.Tolerance)
  {
    return;
  }
  std::uint64_t* words = masks.Of(surfel.OccluderId);
  const double square = surfel.Radius * surfel.Radius;
  if (!view.A)
  {
    const GeneralSurfel general{ { q.X, q.Y, q.Z }, { surfel.Normal.X, surfel.Normal.Y, surfel.Normal.Z }, height,
      square, IsAtInfinity(this->Light.Lamp()) ? 0.0 : 1.0 };
    for (std::size_t block = 0; block < masks.NumberOfBlocks; ++block)
    {
      words[block] |=
        GeneralSurfelMask(general, view.X.data() + 64 * block, view.Y.data() + 64 * block, view.Z.data() + 64 * block);
    }
    return;
  }
  // E and n.w are linear in the light's plane.
  const Vector3 toCenter = this->Light.Lamp().Center - point;
  const double s0 = Dot(surfel.Normal, toCenter);
  const double s1 = Dot(surfel.Normal, this->Light.AxisU());
  const double s2 = Dot(surfel.Normal, this->Light.AxisV());
  const Vector3 e0 = s0 * q - height * toCenter;
  const Vector3 e1 = s1 * q - height * this->Light.AxisU();
  const Vector3 e2 = s2 * q - height * this->Light.AxisV();
  const PlanarSurfel planar{ { Dot(e0, e0) - square * s0 * s0, 2.0 * (Dot(e0, e1) - square * s0 * s1),
                               2.0 * (Dot(e0, e2) - square * s0 * s2), Dot(e1, e1) - square * s1 * s1,
                               2.0 * (Dot(e1, e2) - square * s1 * s2), Dot(e2, e2) - square * s2 * s2 },
    { height * (height + s0), height * s1, height * s2 } };
  for (std::size_t block = 0; block < masks.NumberOfBlocks; ++block)
  {
    words[block] |= PlanarSurfelMask(planar, view.A + 64 * block, view.B + 64 * block);
  }
}

} // namespace shadowcones
