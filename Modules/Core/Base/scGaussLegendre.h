// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scGaussLegendre.h
 * @brief Nodes and weights of Gauss-Legendre quadrature on [0, 1]. Internal to Core.
 */
#ifndef scGaussLegendre_h
#define scGaussLegendre_h

#include "scConstants.h"

#include <cmath>
#include <vector>

namespace shadowcones
{

/// Exact for polynomials up to degree 2 n - 1. Nodes ascend; weights sum to 1.
struct GaussLegendre
{
  std::vector<double> Nodes;
  std::vector<double> Weights;

  explicit GaussLegendre(int n)
    : Nodes(static_cast<std::size_t>(n))
    , Weights(static_cast<std::size_t>(n))
  {
    for (int k = 0; k < n; ++k)
    {
      // Newton's method on the Legendre polynomial P_n, from Tricomi's estimate of its roots.
      double x = std::cos(Pi * (k + 0.75) / (n + 0.5));
      double slope = 1.0;
      for (int step = 0; step < 8; ++step)
      {
        double before = 0.0;
        double value = 1.0;
        for (int j = 1; j <= n; ++j)
        {
          const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
          before = value;
          value = next;
        }
        slope = n * (x * value - before) / (x * x - 1.0);
        x -= value / slope;
      }
      this->Nodes[static_cast<std::size_t>(n - 1 - k)] = 0.5 * (1.0 + x);
      this->Weights[static_cast<std::size_t>(n - 1 - k)] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
  }
};

} // namespace shadowcones

#endif
