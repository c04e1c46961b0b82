// SPDX-License-Identifier: BSD-3-Clause
#include "scPhaseFunction.h"

#include "scConstants.h"

#include <algorithm>
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

/// The inverse of a lobe's integral over cosines from -1.
double SampleSchlickLobe(double k, double u)
{
  return (2.0 * u - 1.0 + k) / (1.0 - k + 2.0 * k * u);
}

/// The same of Henyey and Greenstein, multiplied out: it is exact at g = 0 too.
double SampleHenyeyGreenstein(double g, double u)
{
  const double s = 2.0 * u - 1.0;
  const double root = 1.0 + g * s;
  const double square = g * g;
  return (2.0 * s * (1.0 + square) + g * (s * s + 3.0) + g * square * (s * s - 1.0)) / (2.0 * root * root);
}

/// The real root of c^3 + 3 c = 8 u - 4, by Cardano.
double SampleRayleigh(double u)
{
  const double q = 4.0 * u - 2.0;
  const double root = std::cbrt(std::fabs(q) + std::sqrt(q * q + 1.0));
  return std::copysign(root - 1.0 / root, q);
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

double SamplePhaseCosine(const PhaseFunction& phase, double u)
{
  double cosine = 2.0 * u - 1.0;
  switch (phase.Kind)
  {
    case PhaseFunctionKind::BlasiSchlick:
    {
      const SchlickLobes& lobes = phase.Lobes;
      cosine = u < lobes.Weight ? SampleSchlickLobe(lobes.K1, u / lobes.Weight)
                                : SampleSchlickLobe(lobes.K2, (u - lobes.Weight) / (1.0 - lobes.Weight));
      break;
    }
    case PhaseFunctionKind::HenyeyGreenstein:
      cosine = SampleHenyeyGreenstein(phase.Asymmetry, u);
      break;
    case PhaseFunctionKind::Rayleigh:
      cosine = SampleRayleigh(u);
      break;
    case PhaseFunctionKind::Isotropic:
      break;
  }
  return std::clamp(cosine, -1.0, 1.0);
}

} // namespace shadowcones
