// SPDX-License-Identifier: BSD-3-Clause
#include "scConeSlice.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// A ray as a cone sees it.
struct ConeRay
{
  Vector3 Start; ///< from the cone's centre
  Vector3 Direction;
  double Slope; ///< height per unit of the direction
};

/// Cut the part to what lies between two heights. @return false where nothing is left.
bool CutToHeights(const ConeSlice& slice, const ConeRay& ray, RayInterval& part)
{
  const double startHeight = Dot(ray.Start, slice.Whole.Axis);
  if (ray.Slope != 0.0)
  {
    const double a = (slice.Low - startHeight) / ray.Slope;
    const double b = (slice.High - startHeight) / ray.Slope;
    part.Begin = std::max(part.Begin, std::min(a, b));
    part.End = std::min(part.End, std::max(a, b));
  }
  else if (startHeight < slice.Low || startHeight > slice.High)
  {
    return false;
  }
  return part.Begin <= part.End;
}

/// Cut the part to where a t^2 + 2 b t + c <= 0, t counted from @p nearest. @return false where nothing is left.
bool CutToQuadratic(double a, double b, double c, double nearest, RayInterval& part)
{
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0)
  {
    return !(a > 0.0);
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t0 = a != 0.0 ? q / a : std::copysign(HUGE_VAL, q);
  const double t1 = q != 0.0 ? c / q : t0;
  const double first = nearest + std::min(t0, t1);
  const double second = nearest + std::max(t0, t1);
  if (a > 0.0 || (a == 0.0 && b != 0.0))
  {
    // a == 0: one root at infinity; the inside lies towards decreasing quadratic.
    const double from = a > 0.0 ? first : (b > 0.0 ? -HUGE_VAL : nearest - 0.5 * c / b);
    const double to = a > 0.0 ? second : (b > 0.0 ? nearest - 0.5 * c / b : HUGE_VAL);
    part.Begin = std::max(part.Begin, from);
    part.End = std::min(part.End, to);
    return true;
  }
  if (a < 0.0)
  {
    // Outside the roots, on one sheet each; the planes leave room for one of them only.
    if (part.Begin <= first)
    {
      part.End = std::min(part.End, first);
    }
    else
    {
      part.Begin = std::max(part.Begin, second);
    }
    return true;
  }
  return !(c > 0.0);
}
} // anonymous namespace

bool ConeSlice::Intersect(const Ray& ray, const RayInterval& part, RayInterval& inside) const
{
  const Vector3& axis = this->Whole.Axis;
  const ConeRay local{ ray.Origin - this->Whole.Center, ray.Direction, Dot(ray.Direction, axis) };
  RayInterval cut = part;
  if (!CutToHeights(*this, local, cut))
  {
    return false;
  }

  // Roots are counted from the point nearest to the cone's centre: digits are lost with the square of a far origin.
  const double nearest = -Dot(local.Start, local.Direction) / Dot(local.Direction, local.Direction);
  const Vector3 offset = local.Start + nearest * local.Direction;
  const double h = Dot(offset, axis);

  // Inside the sheet: |lateral|^2 <= (r + h tan)^2, appendix A with the apex moved to where the radius is 0.
  const Vector3 lateral = offset - h * axis;
  const Vector3 dLateral = local.Direction - local.Slope * axis;
  const double radius = this->Whole.BaseRadius + h * this->Tangent;
  const double dRadius = local.Slope * this->Tangent;
  const double a = Dot(dLateral, dLateral) - dRadius * dRadius;
  const double b = Dot(lateral, dLateral) - radius * dRadius;
  const double c = Dot(lateral, lateral) - radius * radius;
  if (!CutToQuadratic(a, b, c, nearest, cut) || !(cut.Begin <= cut.End))
  {
    return false;
  }
  inside = cut;
  return true;
}

} // namespace shadowcones
