// SPDX-License-Identifier: BSD-3-Clause
#include "scPolygonTriangulation.h"

#include "scFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace shadowcones
{
namespace
{

struct Point2
{
  double X = 0.0;
  double Y = 0.0;
};

/// Twice the area of a triangle, positive where it is wound anticlockwise.
double TwiceArea(const Point2& a, const Point2& b, const Point2& c)
{
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

double Distance(const Point2& a, const Point2& b)
{
  return std::hypot(b.X - a.X, b.Y - a.Y);
}

/// The sum over the edges whose half is the area, along the polygon's normal (Newell).
Vector3 AreaVector(const std::vector<Vector3>& corners)
{
  Vector3 sum;
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    sum += Cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return sum;
}

/// How near two points or a point and a line must be to touch.
double Resolution(const std::vector<Vector3>& corners)
{
  constexpr double shareOfSize = 1e-13;
  double size = 0.0;
  double largest = 0.0;
  for (const Vector3& p : corners)
  {
    size = std::max(size, Length(p - corners[0]));
    largest = std::max({ largest, std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }
  return std::max(shareOfSize * size, 2.0 * std::numeric_limits<double>::epsilon() * largest);
}

/// Cuts ears off a polygon in the plane that is wound anticlockwise.
class EarCutter
{
public:
  EarCutter(std::vector<Point2> points, double resolution)
    : Points(std::move(points))
    , Resolution(resolution)
  {
  }

  bool Cut(std::vector<int>& triangles)
  {
    this->Ring.clear();
    for (int i = 0; i < static_cast<int>(this->Points.size()); ++i)
    {
      if (this->Ring.empty() || !this->Touch(this->Ring.back(), i))
      {
        this->Ring.push_back(i);
      }
    }
    while (this->Ring.size() > 1 && this->Touch(this->Ring.front(), this->Ring.back()))
    {
      this->Ring.pop_back();
    }
    const std::vector<int> outline = this->Ring;
    const bool convex = this->IsConvex();
    if (!convex && this->CrossesItself())
    {
      return false;
    }
    std::size_t at = 0;
    while (this->Ring.size() > 2)
    {
      if (!this->CutOne(at, triangles))
      {
        return false;
      }
    }
    return convex || this->GoesRoundOnce(outline, triangles);
  }

private:
  enum class Care
  {
    NothingTouches, ///< no other corner in the ear or on its border
    NothingInside,  ///< corners may lie on the border
    NoArea          ///< a spike, or a corner on a straight edge: nothing is lost
  };

  bool Touch(int a, int b) const { return Distance(this->Points[a], this->Points[b]) <= this->Resolution; }

  /// 1 where c lies left of the line from a to b, -1 where right of it, 0 where on it.
  int Side(const Point2& a, const Point2& b, const Point2& c) const
  {
    const double area = TwiceArea(a, b, c);
    const double border = this->Resolution * Distance(a, b);
    return area > border ? 1 : area < -border ? -1 : 0;
  }
  int Side(int a, int b, int c) const { return this->Side(this->Points[a], this->Points[b], this->Points[c]); }

  int Turn(std::size_t k) const
  {
    const std::size_t n = this->Ring.size();
    const int a = this->Ring[(k + n - 1) % n];
    const int b = this->Ring[k];
    const int c = this->Ring[(k + 1) % n];
    // Measured from the corner itself: short edges keep their digits.
    const double area = TwiceArea(this->Points[b], this->Points[c], this->Points[a]);
    const double border = this->Resolution *
      std::max({ Distance(this->Points[a], this->Points[b]), Distance(this->Points[b], this->Points[c]),
        Distance(this->Points[a], this->Points[c]) });
    return area > border ? 1 : area < -border ? -1 : 0;
  }

  /// Every corner turns left or goes straight on, and the outline goes round once.
  bool IsConvex() const
  {
    int changes = 0;
    bool right = true;
    const std::size_t n = this->Ring.size();
    for (std::size_t k = 0; k <= n; ++k)
    {
      const Point2& a = this->Points[this->Ring[k % n]];
      const Point2& b = this->Points[this->Ring[(k + 1) % n]];
      const bool nowRight = b.X > a.X || (b.X == a.X && b.Y > a.Y);
      changes += k > 0 && nowRight != right;
      right = nowRight;
      if (this->Turn(k % n) < 0 || this->IsSpike(k % n))
      {
        return false;
      }
    }
    return changes <= 2;
  }

  /// The outline turns back on itself at this corner.
  bool IsSpike(std::size_t k) const
  {
    const std::size_t n = this->Ring.size();
    const Point2& a = this->Points[this->Ring[(k + n - 1) % n]];
    const Point2& b = this->Points[this->Ring[k]];
    const Point2& c = this->Points[this->Ring[(k + 1) % n]];
    return this->Turn(k) == 0 && (a.X - b.X) * (c.X - b.X) + (a.Y - b.Y) * (c.Y - b.Y) > 0.0;
  }

  /// Segments that cross at a point inside both.
  bool Cross(int a, int b, int c, int d) const
  {
    return this->Side(a, b, c) * this->Side(a, b, d) < 0 && this->Side(c, d, a) * this->Side(c, d, b) < 0;
  }

  bool CrossesItself() const
  {
    // Sorted by where they begin, edges need be compared only while they overlap along x.
    const std::size_t n = this->Ring.size();
    const auto low = [this, n](std::size_t k)
    { return std::min(this->Points[this->Ring[k]].X, this->Points[this->Ring[(k + 1) % n]].X); };
    const auto high = [this, n](std::size_t k)
    { return std::max(this->Points[this->Ring[k]].X, this->Points[this->Ring[(k + 1) % n]].X); };
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&low](std::size_t a, std::size_t b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = i + 1; j < n && low(order[j]) <= high(order[i]); ++j)
      {
        if (this->Cross(this->Ring[order[i]], this->Ring[(order[i] + 1) % n], this->Ring[order[j]],
              this->Ring[(order[j] + 1) % n]))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool IsEar(std::size_t k, Care care) const
  {
    const std::size_t n = this->Ring.size();
    const int a = this->Ring[(k + n - 1) % n];
    const int b = this->Ring[k];
    const int c = this->Ring[(k + 1) % n];
    const int turn = this->Turn(k);
    if (care == Care::NoArea)
    {
      return turn == 0;
    }
    if (turn <= 0)
    {
      return false;
    }
    const int least = care == Care::NothingTouches ? 0 : 1;
    for (std::size_t i = 0; i < n; ++i)
    {
      const int p = this->Ring[i];
      const int q = this->Ring[(i + 1) % n];
      if (p != a && p != b && p != c && !this->Touch(p, a) && !this->Touch(p, b) && !this->Touch(p, c) &&
        this->Side(a, b, p) >= least && this->Side(b, c, p) >= least && this->Side(c, a, p) >= least)
      {
        return false;
      }
      if (this->Cross(c, a, p, q))
      {
        return false;
      }
    }
    return true;
  }

  /// Cut the next ear after corner number @p at.
  bool CutOne(std::size_t& at, std::vector<int>& triangles)
  {
    for (const Care care : { Care::NothingTouches, Care::NothingInside, Care::NoArea })
    {
      const std::size_t n = this->Ring.size();
      for (std::size_t step = 0; step < n; ++step)
      {
        const std::size_t k = (at + step) % n;
        if (this->IsEar(k, care))
        {
          triangles.insert(triangles.end(), { this->Ring[(k + n - 1) % n], this->Ring[k], this->Ring[(k + 1) % n] });
          this->Ring.erase(this->Ring.begin() + static_cast<std::ptrdiff_t>(k));
          at = k + 1; // every second corner: triangles stay fat
          return true;
        }
      }
    }
    return false;
  }

  /// How often the outline goes round a point.
  int WindingNumber(const std::vector<int>& outline, const Point2& p) const
  {
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Point2& a = this->Points[outline[i]];
      const Point2& b = this->Points[outline[(i + 1) % outline.size()]];
      if ((a.Y <= p.Y) != (b.Y <= p.Y))
      {
        const bool left = TwiceArea(a, b, p) > 0.0;
        winding += a.Y <= p.Y ? (left ? 1 : 0) : (left ? 0 : -1);
      }
    }
    return winding;
  }

  bool GoesRoundOnce(const std::vector<int>& outline, const std::vector<int>& triangles) const
  {
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    {
      const Point2& a = this->Points[triangles[t]];
      const Point2& b = this->Points[triangles[t + 1]];
      const Point2& c = this->Points[triangles[t + 2]];
      const double height = TwiceArea(a, b, c) / std::max({ Distance(a, b), Distance(b, c), Distance(c, a) });
      if (height > 16.0 * this->Resolution &&
        this->WindingNumber(outline, { (a.X + b.X + c.X) / 3.0, (a.Y + b.Y + c.Y) / 3.0 }) != 1)
      {
        return false;
      }
    }
    return true;
  }

  std::vector<Point2> Points;
  double Resolution;
  std::vector<int> Ring; ///< corners that are left
};

/// The corners as seen against a direction, anticlockwise.
std::vector<Point2> Project(const std::vector<Vector3>& corners, const Vector3& u, const Vector3& v)
{
  std::vector<Point2> points;
  points.reserve(corners.size());
  for (const Vector3& p : corners)
  {
    points.push_back({ Dot(p - corners[0], u), Dot(p - corners[0], v) });
  }
  return points;
}

bool CutEars(const std::vector<Vector3>& corners, const Vector3& area, double resolution, std::vector<int>& triangles)
{
  // Along the axis that the polygon faces most: coordinates stay as they are.
  const std::array<Vector3, 3> axes{ Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 }, Vector3{ 0.0, 0.0, 1.0 } };
  int axis = std::abs(area.Y) > std::abs(area.X) ? 1 : 0;
  axis = std::abs(area.Z) > std::abs(area[axis]) ? 2 : axis;
  const Vector3& u = axes[static_cast<std::size_t>((axis + 1) % 3)];
  const Vector3& v = axes[static_cast<std::size_t>((axis + 2) % 3)];
  const bool back = area[axis] < 0.0;
  if (EarCutter(Project(corners, back ? v : u, back ? u : v), resolution).Cut(triangles))
  {
    return true;
  }
  // Warped outlines may be simple along their mean normal alone.
  triangles.clear();
  const Frame frame = FrameAround(Normalized(area));
  return EarCutter(Project(corners, frame.U, frame.V), resolution).Cut(triangles);
}

/// Cut along the shorter diagonal that lies inside. @return false where neither is seen to.
bool CutQuad(const std::vector<Vector3>& corner, std::vector<int>& triangles)
{
  const auto agreement = [&corner](int a, int b, int c, int d)
  {
    const Vector3 first = Cross(corner[b] - corner[a], corner[c] - corner[a]);
    const Vector3 second = Cross(corner[c] - corner[a], corner[d] - corner[a]);
    return Dot(first, second);
  };
  // A diagonal outside a concave quad gives two triangles that face opposite ways.
  const bool evenValid = agreement(0, 1, 2, 3) > 0.0;
  const bool oddValid = agreement(1, 2, 3, 0) > 0.0;
  if (!evenValid && !oddValid)
  {
    return false;
  }
  const bool oddShorter = Length(corner[1] - corner[3]) < Length(corner[0] - corner[2]);
  if (oddValid && (!evenValid || oddShorter))
  {
    triangles = { 1, 2, 3, 1, 3, 0 };
  }
  else
  {
    triangles = { 0, 1, 2, 0, 2, 3 };
  }
  return true;
}

/// Every edge is walked there and back: nothing is left between them.
bool IsThereAndBack(const std::vector<Vector3>& corners, double resolution)
{
  std::vector<Vector3> path;
  for (const Vector3& p : corners)
  {
    if (path.size() > 1 && Length(p - path[path.size() - 2]) <= resolution)
    {
      path.pop_back();
    }
    else if (path.empty() || Length(p - path.back()) > resolution)
    {
      path.push_back(p);
    }
  }
  while (path.size() > 2 && Length(path[1] - path.back()) <= resolution)
  {
    path.erase(path.begin());
    path.pop_back();
  }
  return path.size() < 3;
}

void Fan(int count, std::vector<int>& triangles)
{
  triangles.clear();
  for (int i = 1; i + 1 < count; ++i)
  {
    triangles.insert(triangles.end(), { 0, i, i + 1 });
  }
}

} // namespace

bool TriangulatePolygon(const std::vector<Vector3>& corners, std::vector<int>& triangles)
{
  triangles.clear();
  const auto count = static_cast<int>(corners.size());
  if (count < 4)
  {
    Fan(count, triangles);
    return true;
  }
  if (count == 4 && CutQuad(corners, triangles))
  {
    return true;
  }
  const double resolution = Resolution(corners);
  const Vector3 area = AreaVector(corners);
  double size = 0.0;
  double reach = 0.0; // from the line between the first corner and the one furthest from it
  Vector3 far;
  for (const Vector3& p : corners)
  {
    const double distance = Length(p - corners[0]);
    far = distance > size ? p - corners[0] : far;
    size = std::max(size, distance);
  }
  for (const Vector3& p : corners)
  {
    reach = size > 0.0 ? std::max(reach, Length(Cross(p - corners[0], far)) / size) : 0.0;
  }
  if (reach <= resolution)
  {
    Fan(count, triangles);
    return true;
  }
  if (IsThereAndBack(corners, resolution))
  {
    return true;
  }
  if (Length(area) > resolution * size && CutEars(corners, area, resolution, triangles))
  {
    return true;
  }
  triangles.clear();
  return false;
}

} // namespace shadowcones
