// SPDX-License-Identifier: BSD-3-Clause
#include "scPhaseFunction.h"

#include "scConstants.h"

#include <cmath>

namespace shadowcones
{

namespace
{

/// Schlick's rational lobe: Henyey and Greenstein without the power 3/2.
double SchlickLobe(double k, double cosine)
{
  const double root = 1.0 - k * cosine;
  return (1.0 - k * k) / (FourPi * root * root);
}

} // namespace

SchlickLobes SchlickRayleigh()
{
  return { 0.5, 0.46, -0.46 };
}

SchlickLobes SchlickHazyMie()
{
  return { 0.12, -0.50, 0.70 };
}

SchlickLobes SchlickMurkyMie()
{
  return { 0.19, -0.65, 0.91 };
}

double EvaluatePhaseFunction(const PhaseFunction& phase, double cosine)
{
  switch (phase.Kind)
  {
    case PhaseFunctionKind::BlasiSchlick:
    {
      const SchlickLobes& lobes = phase.Lobes;
      return lobes.Weight * SchlickLobe(lobes.K1, cosine) + (1.0 - lobes.Weight) * SchlickLobe(lobes.K2, cosine);
    }
    case PhaseFunctionKind::HenyeyGreenstein:
    {
      const double g = phase.Asymmetry;
      const double root = 1.0 + g * g - 2.0 * g * cosine;
      return (1.0 - g * g) / (FourPi * root * std::sqrt(root));
    }
    case PhaseFunctionKind::Rayleigh:
      return 0.75 / FourPi * (1.0 + cosine * cosine);
    case PhaseFunctionKind::Isotropic:
      break;
  }
  return 1.0 / FourPi;
}

} // namespace shadowcones
