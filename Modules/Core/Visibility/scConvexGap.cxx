// SPDX-License-Identifier: BSD-3-Clause
#include "scConvexGap.h"

namespace shadowcones
{

void GapSimplex::Keep(const std::array<int, 3>& which, int count)
{
  std::array<Vector3, 3> kept;
  for (int k = 0; k < count; ++k)
  {
    kept[k] = this->Points[which[k]];
  }
  std::copy(kept.begin(), kept.begin() + count, this->Points.begin());
  this->Count = count;
}

Vector3 GapSimplex::ReduceSegment()
{
  const Vector3 a = this->Points[0];
  const Vector3 ab = this->Points[1] - a;
  const double squared = Dot(ab, ab);
  const double t = squared > 0.0 ? -Dot(a, ab) / squared : 0.0;
  if (t <= 0.0 || t >= 1.0)
  {
    this->Keep({ t <= 0.0 ? 0 : 1, 0, 0 }, 1);
    return this->Points[0];
  }
  return a + t * ab;
}

/// Ericson, Real-Time Collision Detection, 5.1.5, with the origin as the point.
Vector3 GapSimplex::ReduceTriangle()
{
  const Vector3 a = this->Points[0];
  const Vector3 b = this->Points[1];
  const Vector3 c = this->Points[2];
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double d1 = -Dot(ab, a);
  const double d2 = -Dot(ac, a);
  const double d3 = -Dot(ab, b);
  const double d4 = -Dot(ac, b);
  const double d5 = -Dot(ab, c);
  const double d6 = -Dot(ac, c);
  const double va = d3 * d6 - d5 * d4;
  const double vb = d5 * d2 - d1 * d6;
  const double vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc;
  if (va > 0.0 && vb > 0.0 && vc > 0.0)
  {
    return a + (vb / sum) * ab + (vc / sum) * ac;
  }
  // On an edge or corner: the nearest of the three edges.
  constexpr int edges[3][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 } };
  GapSimplex best;
  Vector3 nearest;
  double least = HUGE_VAL;
  for (const auto& edge : edges)
  {
    GapSimplex side;
    side.Add(this->Points[edge[0]]);
    side.Add(this->Points[edge[1]]);
    const Vector3 point = side.ReduceSegment();
    if (Dot(point, point) < least)
    {
      least = Dot(point, point);
      nearest = point;
      best = side;
    }
  }
  *this = best;
  return nearest;
}

bool GapSimplex::Reduce(Vector3& nearest)
{
  if (this->Count < 4)
  {
    nearest = this->Count == 3 ? this->ReduceTriangle() : this->Count == 2 ? this->ReduceSegment() : this->Points[0];
    return true;
  }
  // The origin is outside of the faces that have it and the fourth point on two sides.
  constexpr int faces[4][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 }, { 1, 3, 2, 0 } };
  GapSimplex best;
  double least = HUGE_VAL;
  for (const auto& face : faces)
  {
    const Vector3 a = this->Points[face[0]];
    const Vector3 normal = Cross(this->Points[face[1]] - a, this->Points[face[2]] - a);
    if (Dot(normal, a) * Dot(normal, this->Points[face[3]] - a) < 0.0)
    {
      continue;
    }
    GapSimplex side;
    for (int k = 0; k < 3; ++k)
    {
      side.Add(this->Points[face[k]]);
    }
    const Vector3 point = side.ReduceTriangle();
    if (Dot(point, point) < least)
    {
      least = Dot(point, point);
      nearest = point;
      best = side;
    }
  }
  if (!std::isfinite(least))
  {
    return false;
  }
  *this = best;
  return true;
}

} // namespace shadowcones
