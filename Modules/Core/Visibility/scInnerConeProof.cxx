// SPDX-License-Identifier: BSD-3-Clause
#include "scInnerConeProof.h"

#include "scLampPlane.h"
#include "scLightExtent.h"
#include "scShadowCasters.h"
#include "scShadowSamples.h"
#include "scShaft.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace shadowcones
{
namespace
{
/// Smaller discs than this share of the base are not looked for.
constexpr double smallestDisc = 0.05;
/// Halvings in the search for the largest disc.
constexpr int halvings = 6;

/// A light and what hides it.
struct Lit
{
  Lit(const OccluderScene& scene, const Light& light)
    : Bodies(LightBodiesOf(light))
    , Casters(scene.Mesh(), scene.RulesFor(FlatFaceOf(light)).Ignored, this->Bodies)
    , Samples(light, 0, scene)
    , Extent(LightExtentOf(light))
  {
  }

  /// Does the mesh hide all of the light from all of the disc? False where that could not be shown.
  bool IsHiddenFrom(const ShaftStart& disc) const
  {
    bool any = false;
    for (const LightBody& body : this->Bodies)
    {
      const Shaft shaft(disc, body, this->Casters.Bounds());
      const int facing = shaft.Facing();
      if (facing < 0)
      {
        continue;
      }
      if (facing == 0 || this->Casters.Look(shaft) != ShaftFinding::Alike || !this->Samples.IsHidden(disc.Center, body))
      {
        return false;
      }
      any = true;
    }
    return any;
  }

  std::vector<LightBody> Bodies;
  ShadowCasters Casters;
  ShadowSamples Samples;
  LightExtent Extent;
};

/// How far a disc around the axis must be moved to lie behind a plane through its centre, over its radius.
double Tilt(const Cone& cone)
{
  const double along = std::fabs(Dot(cone.Axis, cone.Normal));
  return along > 1e-3 ? Length(Cross(cone.Axis, cone.Normal)) / along : 0.0;
}

/// The best disc of a cone that is proved: its radius is 0 where there is none.
ShaftStart BestDisc(const Lit& lit, const Cone& cone)
{
  const double tilt = Tilt(cone);
  const double size = cone.BaseRadius + 1e-6 * Length(cone.Center);
  // On the surface; behind it, if it is as steep as the base's normal says; deeper, in a body or behind it.
  const double heights[5] = { 1e-3, 1.05 * tilt + 1e-3, 0.5, 1.0, 2.0 };
  const double tangent = std::tan(cone.InnerHalfAngle);
  ShaftStart best;
  for (const double height : heights)
  {
    const auto discOf = [&](double share)
    {
      ShaftStart disc;
      const double moved = height * share * size;
      disc.Center = cone.Center + moved * cone.Axis;
      disc.Axis = cone.Axis;
      disc.Radius = std::min(share * cone.BaseRadius, RadiusAt(cone.BaseRadius, tangent, moved));
      return disc;
    };
    const auto isProved = [&](double share)
    {
      const ShaftStart disc = discOf(share);
      return disc.Radius > 0.0 && lit.IsHiddenFrom(disc);
    };
    double good = isProved(1.0) ? 1.0 : 0.0;
    // Only what beats the best so far is of use.
    const double least = std::max(smallestDisc, 1.02 * best.Radius / cone.BaseRadius);
    if (good == 0.0 && least < 1.0 && isProved(least))
    {
      good = least;
      double bad = 1.0;
      for (int k = 0; k < halvings; ++k)
      {
        const double middle = 0.5 * (good + bad);
        (isProved(middle) ? good : bad) = middle;
      }
    }
    if (good > 0.0 && discOf(good).Radius > best.Radius)
    {
      best = discOf(good);
    }
    if (good == 1.0)
    {
      break;
    }
  }
  return best;
}
} // anonymous namespace

bool ProveInnerCones(const OccluderScene& scene, const std::vector<Light>& lights, const std::vector<Cone>& cones,
  const Monitor& monitor, InnerConeProof& proof)
{
  std::vector<std::unique_ptr<const Lit>> lit;
  for (const Light& light : lights)
  {
    lit.push_back(std::make_unique<const Lit>(scene, light));
  }
  std::vector<Cone> best(cones);
  const bool done = ParallelFor(static_cast<vtkIdType>(cones.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Cone& cone = best[i];
        const bool known = cone.LightId >= 0 && static_cast<std::size_t>(cone.LightId) < lit.size();
        const ShaftStart disc = known && cone.BaseRadius > 0.0 ? BestDisc(*lit[cone.LightId], cone) : ShaftStart();
        cone.BaseRadius = disc.Radius;
        if (disc.Radius > 0.0)
        {
          cone.Center = disc.Center;
          PenumbraAngles(
            lit[cone.LightId]->Extent, cone.Center, cone.Axis, cone.BaseRadius, cone.HalfAngle, cone.InnerHalfAngle);
        }
      }
    });
  proof = {};
  for (std::size_t i = 0; i < best.size(); ++i)
  {
    const bool kept = best[i].BaseRadius > 0.0;
    const bool whole = kept && best[i].BaseRadius > 0.999 * cones[i].BaseRadius;
    ++(whole ? proof.Whole : (kept ? proof.Shrunk : proof.Dropped));
    if (kept)
    {
      proof.Cones.push_back(best[i]);
    }
  }
  return done;
}

} // namespace shadowcones
