// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointSource.h
 * @brief The exact light around a point source in an infinite scattering medium.
 */
#ifndef PointSource_h
#define PointSource_h

#include "TestMeshes.h"

#include <cmath>

namespace shadowcones
{
namespace testsupport
{

/// tanh(kappa / c) = kappa: the inverse of the diffusion length, of which Case, de Hoffmann and Placzek (1953) print a table.
inline double InverseDiffusionLength(double albedo)
{
  double low = 1e-9;
  double high = 1.0 - 1e-15;
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (albedo * std::atanh(middle) > middle ? high : low) = middle;
  }
  return low;
}

/**
 * Fluence at a distance, in mean free paths, from an isotropic point source of 1 W in an infinite medium with isotropic scattering
 * (Case, de Hoffmann and Placzek, "Introduction to the Theory of Neutron Diffusion", 1953): the asymptotic part
 * and the integral over the cut.
 */
inline double ExactFluence(double albedo, double r)
{
  const double kappa = InverseDiffusionLength(albedo);
  const double asymptotic = kappa * kappa * std::exp(-kappa * r) /
    (2.0 * Pi * r * albedo * albedo * (1.0 / (1.0 - kappa * kappa) - 1.0 / albedo));
  // kappa' = 1 / u from 1 to infinity.
  const int steps = 4000;
  double transient = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double u = (i + 0.5) / steps;
    const double real = 1.0 - albedo * u * std::atanh(u);
    const double imaginary = 0.5 * albedo * Pi * u;
    transient += std::exp(-r / u) / (u * u) / (real * real + imaginary * imaginary) / steps;
  }
  return asymptotic + transient / (4.0 * Pi * r);
}

} // namespace testsupport
} // namespace shadowcones

#endif
