// SPDX-License-Identifier: BSD-3-Clause
#include "scOptionalBounds.h"

#include "scSentence.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

bool AreUnsetBounds(const double bounds[6])
{
  constexpr double unset[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  return std::equal(bounds, bounds + 6, unset);
}

bool BoundsAround(const Box& bounds, const Box& lights, Box& around)
{
  Box joint = bounds;
  if (!lights.Empty())
  {
    joint.Add(lights.Min);
    joint.Add(lights.Max);
  }
  const double diagonal = joint.Diagonal();
  if (!(diagonal > 0.0))
  {
    return false;
  }
  const Vector3 size = joint.Size();
  const auto half = [diagonal](double side) { return side > 0.0 ? 0.55 * side : 0.05 * diagonal; };
  const Vector3 reach{ half(size.X), half(size.Y), half(size.Z) };
  around = { joint.Center() - reach, joint.Center() + reach };
  return true;
}

bool ReadBounds(const char* name, const double bounds[6], Box& box, std::string& error)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double from = bounds[2 * axis];
    const double to = bounds[2 * axis + 1];
    if (!(from <= to) || !std::isfinite(from) || !std::isfinite(to))
    {
      error = Sentence(
        name, " along ", "xyz"[axis], " run from ", from, " to ", to, ": they must be finite and in ascending order.");
      return false;
    }
  }
  box = { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
  return true;
}

bool ReadSolidBounds(const char* name, const double bounds[6], Box& box, std::string& error)
{
  if (!ReadBounds(name, bounds, box, error))
  {
    return false;
  }
  const Vector3 size = box.Size();
  if (!(std::min({ size.X, size.Y, size.Z }) > 0.0))
  {
    error = Sentence(name, " are flat: they must enclose a volume.");
  }
  return error.empty();
}

} // namespace shadowcones
