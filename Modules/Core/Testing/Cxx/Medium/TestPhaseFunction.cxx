// SPDX-License-Identifier: BSD-3-Clause
#include "scPhaseFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace shadowcones;

namespace
{

constexpr double pi = 3.14159265358979323846;

/// Integral over the sphere of p(cos) cos^power, by Simpson's rule in the cosine.
double Moment(const PhaseFunction& phase, int power)
{
  const int steps = 20000;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double cosine = -1.0 + 2.0 * i / steps;
    const double weight = i == 0 || i == steps ? 1.0 : (i % 2 ? 4.0 : 2.0);
    sum += weight * EvaluatePhaseFunction(phase, cosine) * std::pow(cosine, power);
  }
  return 2.0 * pi * sum * (2.0 / steps) / 3.0;
}

std::vector<PhaseFunction> AllKinds()
{
  return { { PhaseFunctionKind::Isotropic, {}, 0.0 }, { PhaseFunctionKind::Rayleigh, {}, 0.0 },
    { PhaseFunctionKind::HenyeyGreenstein, {}, 0.75 }, { PhaseFunctionKind::HenyeyGreenstein, {}, -0.4 },
    { PhaseFunctionKind::BlasiSchlick, { 1.0, 0.6, 0.0 }, 0.0 },
    { PhaseFunctionKind::BlasiSchlick, SchlickRayleigh(), 0.0 },
    { PhaseFunctionKind::BlasiSchlick, SchlickHazyMie(), 0.0 },
    { PhaseFunctionKind::BlasiSchlick, SchlickMurkyMie(), 0.0 } };
}

} // namespace

TEST(PhaseFunction, EveryKindIntegratesToOne)
{
  for (const PhaseFunction& phase : AllKinds())
  {
    EXPECT_NEAR(Moment(phase, 0), 1.0, 1e-8) << "kind " << static_cast<int>(phase.Kind) << " k1 " << phase.Lobes.K1;
  }
}

TEST(PhaseFunction, IsotropicIsOneOverFourPi)
{
  EXPECT_DOUBLE_EQ(EvaluatePhaseFunction({}, 0.3), 1.0 / (4.0 * pi));
}

TEST(PhaseFunction, HenyeyGreensteinHasItsAsymmetryAsMeanCosine)
{
  EXPECT_NEAR(Moment({ PhaseFunctionKind::HenyeyGreenstein, {}, 0.6 }, 1), 0.6, 1e-8);
  EXPECT_NEAR(Moment({ PhaseFunctionKind::HenyeyGreenstein, {}, -0.3 }, 1), -0.3, 1e-8);
}

TEST(PhaseFunction, PositiveLobesScatterForward)
{
  const PhaseFunction forward{ PhaseFunctionKind::BlasiSchlick, { 1.0, 0.5, 0.0 }, 0.0 };
  // S(k) at cos = 1 over cos = -1 is ((1 + k) / (1 - k))^2.
  EXPECT_NEAR(EvaluatePhaseFunction(forward, 1.0) / EvaluatePhaseFunction(forward, -1.0), 9.0, 1e-12);
}

TEST(PhaseFunction, TwoLobesComeWithin5Point2PercentOfRayleigh)
{
  const PhaseFunction lobes{ PhaseFunctionKind::BlasiSchlick, SchlickRayleigh(), 0.0 };
  const PhaseFunction exact{ PhaseFunctionKind::Rayleigh, {}, 0.0 };
  double worst = 0.0;
  for (int i = -1000; i <= 1000; ++i)
  {
    const double cosine = i / 1000.0;
    worst =
      std::fmax(worst, std::fabs(EvaluatePhaseFunction(lobes, cosine) / EvaluatePhaseFunction(exact, cosine) - 1.0));
  }
  EXPECT_LE(worst, 0.052);
  EXPECT_GT(worst, 0.01) << "the preset is an approximation, not the function itself";
}

TEST(PhaseFunction, MiePresetsPeakForwardAsThePowersTheyFit)
{
  // Nishita's hazy 1/2 + 9/2 ((1 + cos) / 2)^8 and murky 1/2 + 33/2 ((1 + cos) / 2)^32, over 4 pi.
  const double forward = 1.0;
  EXPECT_NEAR(
    4.0 * pi * EvaluatePhaseFunction({ PhaseFunctionKind::BlasiSchlick, SchlickHazyMie(), 0.0 }, forward), 5.0, 0.1);
  EXPECT_NEAR(
    4.0 * pi * EvaluatePhaseFunction({ PhaseFunctionKind::BlasiSchlick, SchlickMurkyMie(), 0.0 }, forward), 17.0, 0.4);
}

TEST(PhaseFunction, SampledCosinesInvertTheIntegral)
{
  for (const PhaseFunction& phase : AllKinds())
  {
    // Of two lobes each has a part of the interval: there the share of cosines up to one is counted.
    const int samples = 20000;
    for (const double limit : { -0.8, -0.1, 0.45, 0.93 })
    {
      int below = 0;
      for (int i = 0; i < samples; ++i)
      {
        below += SamplePhaseCosine(phase, (i + 0.5) / samples) <= limit ? 1 : 0;
      }
      const int steps = 2000;
      double share = 0.0;
      for (int i = 0; i < steps; ++i)
      {
        const double cosine = -1.0 + (limit + 1.0) * (i + 0.5) / steps;
        share += 2.0 * pi * EvaluatePhaseFunction(phase, cosine) * (limit + 1.0) / steps;
      }
      EXPECT_NEAR(below, samples * share, 2.1 + 1e-5 * samples) << "kind " << static_cast<int>(phase.Kind);
    }
  }
}
