// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainRays.h
 * @brief Rays against every triangle of a list (Moeller and Trumbore, 1997), in double precision: the truth of these tests.
 */
#ifndef PlainRays_h
#define PlainRays_h

#include "scVector3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace robustness
{

class PlainRays
{
public:
  explicit PlainRays(const std::vector<shadowcones::Vector3>& corners)
    : Corners(corners)
  {
  }

  /// Distances of all hits along @p d, in its lengths, in no order; each face once, whatever its winding.
  std::vector<double> Hits(const shadowcones::Vector3& o, const shadowcones::Vector3& d) const
  {
    std::vector<double> hits;
    for (std::size_t k = 0; k < this->Corners.size(); k += 3)
    {
      const double t = this->Hit(k, o, d);
      if (t > 0.0)
      {
        hits.push_back(t);
      }
    }
    return hits;
  }
  double Nearest(const shadowcones::Vector3& o, const shadowcones::Vector3& d) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < this->Corners.size(); k += 3)
    {
      const double t = this->Hit(k, o, d);
      nearest = t > 0.0 ? std::min(nearest, t) : nearest;
    }
    return nearest;
  }
  /// Walls that are passed outward less those passed inward: 0 outside of all solids that are wound outward.
  int Winding(const shadowcones::Vector3& o, const shadowcones::Vector3& d) const
  {
    int winding = 0;
    for (std::size_t k = 0; k < this->Corners.size(); k += 3)
    {
      if (this->Hit(k, o, d) > 0.0)
      {
        const shadowcones::Vector3& a = this->Corners[k];
        winding += Dot(d, Cross(this->Corners[k + 1] - a, this->Corners[k + 2] - a)) > 0.0 ? 1 : -1;
      }
    }
    return winding;
  }
  /// Is there a triangle between the two?
  bool Blocked(const shadowcones::Vector3& a, const shadowcones::Vector3& b) const
  {
    for (std::size_t k = 0; k < this->Corners.size(); k += 3)
    {
      const double t = this->Hit(k, a, b - a);
      if (t > 0.0 && t < 1.0)
      {
        return true;
      }
    }
    return false;
  }

private:
  double Hit(std::size_t k, const shadowcones::Vector3& o, const shadowcones::Vector3& d) const
  {
    using namespace shadowcones;
    const Vector3 edge1 = this->Corners[k + 1] - this->Corners[k];
    const Vector3 edge2 = this->Corners[k + 2] - this->Corners[k];
    const Vector3 p = Cross(d, edge2);
    const double determinant = Dot(edge1, p);
    if (determinant == 0.0)
    {
      return -1.0;
    }
    const Vector3 s = o - this->Corners[k];
    const double u = Dot(s, p) / determinant;
    const Vector3 q = Cross(s, edge1);
    const double v = Dot(d, q) / determinant;
    return u < 0.0 || v < 0.0 || u + v > 1.0 ? -1.0 : Dot(edge2, q) / determinant;
  }

  const std::vector<shadowcones::Vector3>& Corners;
};

/// Points of a disc about a centre that faces down z, in equal areas: n rings of points that stand as dense everywhere.
inline std::vector<shadowcones::Vector3> PointsOfDisc(const shadowcones::Vector3& center, double radius, int rings)
{
  std::vector<shadowcones::Vector3> points;
  for (int ring = 0; ring < rings; ++ring)
  {
    const int count = 3 * (2 * ring + 1);
    for (int k = 0; k < count; ++k)
    {
      const double r = radius * (ring + 0.5) / rings;
      const double angle = 2.0 * 3.14159265358979323846 * (k + 0.31 * (ring % 3)) / count;
      points.push_back(center + shadowcones::Vector3{ r * std::cos(angle), r * std::sin(angle), 0.0 });
    }
  }
  return points;
}

} // namespace robustness

#endif
