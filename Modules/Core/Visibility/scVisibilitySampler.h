// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilitySampler.h
 * @brief What a vertex of a visibility grid is asked. Internal to Core.
 */
#ifndef scVisibilitySampler_h
#define scVisibilitySampler_h

#include "scArrivingLight.h"
#include "scBits.h"
#include "scLampPlane.h"
#include "scLightPatterns.h"
#include "scOccluderScene.h"
#include "scShadowClass.h"
#include "scVisibilityGrid.h"
#include "scVisibilityProbe.h"
#include "scWholeLight.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace shadowcones
{

/// Asks for the visible fraction at points anywhere, whether a cone holds them or not.
class VisibilitySampler
{
public:
  VisibilitySampler(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene, const Box& bounds,
    const VisibilityGridOptions& options)
    : Patterns(light, options.NumberOfLightSamples, options.Seed)
    , Scene(scene)
    , Rules(scene ? scene->RulesFor(FlatFaceOf(light)) : RayRules())
    , AtInfinity(IsAtInfinity(light))
    , Fluence(options.Fluence)
  {
    if (options.Method == VisibilityMethod::Soft)
    {
      VisibilityOptions soft;
      soft.Fluence = options.Fluence;
      soft.Method = VisibilityMethod::Soft;
      soft.NumberOfLightSamples = options.NumberOfLightSamples;
      soft.Seed = options.Seed;
      this->Discs = std::make_unique<VisibilityProbe>(cones, light, nullptr, bounds, soft);
    }
  }

  /// What is asked at a point.
  struct Answer
  {
    float Fraction = 1.0f;
    ShadowClass Class = ShadowClass::Lit;
    ArrivingLight Fluence; ///< where it is asked for
  };
  /// @return false, with nothing changed, where the light does not emit towards the point. @p rays grows by those sent.
  bool Ask(const Vector3& point, Answer& answer, vtkIdType& rays) const
  {
    if (this->Discs)
    {
      const PointVisibility soft = this->Discs->At(point);
      if (!(soft.Fraction > 0.0) && !this->Emits(point))
      {
        return false;
      }
      answer = { static_cast<float>(soft.Fraction), soft.Class, soft.Fluence };
      return true;
    }
    thread_local LightView view;
    this->Patterns.LookFrom(point, view);
    int open = 0;
    int hidden = 0;
    SeenWeights weights;
    for (std::size_t block = 0; block < view.Open.size(); ++block)
    {
      const std::size_t first = 64 * block;
      const std::uint64_t wanted = view.Open[block];
      const std::uint64_t blocked = this->Scene
        ? this->Scene->OccludedFrom(point, view.X.data() + first, view.Y.data() + first, view.Z.data() + first, wanted,
            this->AtInfinity, this->Rules)
        : 0;
      open += CountBits(wanted);
      hidden += CountBits(blocked);
      for (std::uint64_t left = this->Fluence ? wanted : 0; left != 0; left &= left - 1)
      {
        const int bit = LowestBit(left);
        weights.Add(this->Patterns.WeightOf(view, first + static_cast<std::size_t>(bit)), !((blocked >> bit) & 1));
      }
    }
    if (open == 0)
    {
      return false;
    }
    rays += this->Scene ? open : 0;
    const SeenSamples seen{ open, open - hidden };
    answer = { static_cast<float>(seen.Fraction()), seen.Class(), {} };
    if (this->Fluence)
    {
      answer.Fluence = weights.Of(WholeFluence(this->Patterns.Lamp(), point));
      answer.Fluence.Error = this->Patterns.IsExact() ? 0.0 : answer.Fluence.Error;
    }
    return true;
  }

private:
  /// Does the light send anything towards the point?
  bool Emits(const Vector3& point) const
  {
    thread_local LightView view;
    if (this->Patterns.IsWholeFrom(point))
    {
      return true;
    }
    this->Patterns.LookFrom(point, view);
    return std::any_of(view.Open.begin(), view.Open.end(), [](std::uint64_t word) { return word != 0; });
  }

  LightPatterns Patterns;
  const OccluderScene* Scene;
  RayRules Rules;
  bool AtInfinity;
  bool Fluence;
  std::unique_ptr<VisibilityProbe> Discs; ///< Soft
};

} // namespace shadowcones

#endif
