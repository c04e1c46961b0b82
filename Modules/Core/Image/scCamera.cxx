// SPDX-License-Identifier: BSD-3-Clause
#include "scCamera.h"

namespace shadowcones
{

Ray Camera::PixelRay(double i, double j, int width, int height) const
{
  const double aspect = static_cast<double>(width) / height;
  const double x = (2.0 * (i + 0.5) / width - 1.0) * aspect * this->HalfHeight;
  const double y = (2.0 * (j + 0.5) / height - 1.0) * this->HalfHeight;
  const Vector3 offset = x * this->Right + y * this->Up;
  if (this->Parallel)
  {
    return { this->Position + offset, this->Forward };
  }
  return { this->Position, Normalized(this->Forward + offset) };
}

} // namespace shadowcones
