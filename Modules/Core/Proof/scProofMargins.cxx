// SPDX-License-Identifier: BSD-3-Clause
#include "scProofMargins.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

double ProofMargins::At(const Vector3& point) const
{
  const Vector3 offset = point - this->Center;
  return this->Least + this->Relative * std::max({ std::abs(offset.X), std::abs(offset.Y), std::abs(offset.Z) });
}

ProofMargins ProofMarginsOf(const Box& bounds)
{
  ProofMargins margins;
  margins.Center = bounds.Empty() ? Vector3{} : bounds.Center();
  margins.Relative = 5e-7;
  margins.Least = 1.5e-7 * bounds.Diagonal();
  return margins;
}

} // namespace shadowcones
