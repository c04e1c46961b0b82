// SPDX-License-Identifier: BSD-3-Clause
// Closed form 8: every phase function integrates to 1 and is the published one.
#include "ClosedForms.h"
#include "scPhaseFunction.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shadowcones;

namespace
{
std::vector<PhaseFunction> All()
{
  std::vector<PhaseFunction> all(1);
  for (const double g : { -0.7, 0.0, 0.3, 0.9 })
  {
    PhaseFunction phase;
    phase.Kind = PhaseFunctionKind::HenyeyGreenstein;
    phase.Asymmetry = g;
    all.push_back(phase);
  }
  for (const SchlickLobes& lobes : { SchlickLobes{ 1.0, 0.6, 0.0 }, SchlickLobes{ 0.3, 0.8, -0.5 }, SchlickRayleigh(),
         SchlickHazyMie(), SchlickMurkyMie() })
  {
    PhaseFunction phase;
    phase.Kind = PhaseFunctionKind::BlasiSchlick;
    phase.Lobes = lobes;
    all.push_back(phase);
  }
  PhaseFunction rayleigh;
  rayleigh.Kind = PhaseFunctionKind::Rayleigh;
  all.push_back(rayleigh);
  return all;
}
} // namespace

TEST(PhaseFunctions, IntegrateToOne)
{
  int index = 0;
  for (const PhaseFunction& phase : All())
  {
    const double whole = closedforms::OverSphere([&](double cosine) { return EvaluatePhaseFunction(phase, cosine); });
    EXPECT_NEAR(whole, 1.0, 1e-6) << "phase function " << index;
    ++index;
  }
}

TEST(PhaseFunctions, AreThePublishedOnes)
{
  PhaseFunction phase;
  for (double cosine = -1.0; cosine <= 1.0; cosine += 0.125)
  {
    phase.Kind = PhaseFunctionKind::Isotropic;
    EXPECT_DOUBLE_EQ(EvaluatePhaseFunction(phase, cosine), 0.25 / closedforms::Pi);
    phase.Kind = PhaseFunctionKind::Rayleigh;
    EXPECT_NEAR(EvaluatePhaseFunction(phase, cosine), closedforms::RayleighPhase(cosine), 1e-15);
    phase.Kind = PhaseFunctionKind::HenyeyGreenstein;
    phase.Asymmetry = 0.6;
    EXPECT_NEAR(EvaluatePhaseFunction(phase, cosine), closedforms::HenyeyGreenstein(0.6, cosine), 1e-13);
    phase.Kind = PhaseFunctionKind::BlasiSchlick;
    phase.Lobes = { 0.3, 0.8, -0.5 };
    EXPECT_NEAR(EvaluatePhaseFunction(phase, cosine),
      0.3 * closedforms::SchlickLobe(0.8, cosine) + 0.7 * closedforms::SchlickLobe(-0.5, cosine), 1e-13);
  }
}

TEST(PhaseFunctions, ForwardIsForward)
{
  PhaseFunction phase;
  phase.Kind = PhaseFunctionKind::HenyeyGreenstein;
  phase.Asymmetry = 0.5;
  EXPECT_GT(EvaluatePhaseFunction(phase, 1.0), EvaluatePhaseFunction(phase, -1.0));
  phase.Kind = PhaseFunctionKind::BlasiSchlick;
  phase.Lobes = SchlickMurkyMie();
  EXPECT_GT(EvaluatePhaseFunction(phase, 1.0), EvaluatePhaseFunction(phase, -1.0));
}

TEST(PhaseFunctions, TwoLobesComeWithinTheStatedShareOfRayleigh)
{
  PhaseFunction phase;
  phase.Kind = PhaseFunctionKind::BlasiSchlick;
  phase.Lobes = SchlickRayleigh();
  double worst = 0.0;
  for (double cosine = -1.0; cosine <= 1.0; cosine += 0.001)
  {
    const double exact = closedforms::RayleighPhase(cosine);
    worst = std::max(worst, std::abs(EvaluatePhaseFunction(phase, cosine) - exact) / exact);
  }
  EXPECT_LE(worst, 0.0525);
  EXPECT_GE(worst, 0.04);
}
