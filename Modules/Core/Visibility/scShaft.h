// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShaft.h
 * @brief All that light passes on its way from a convex part of a light to a convex body. Internal to Core.
 */
#ifndef scShaft_h
#define scShaft_h

#include "scBox.h"
#include "scLight.h"
#include "scVector3.h"

#include <cmath>
#include <vector>

namespace shadowcones
{

/// A convex part of a light, by its own shape: nothing of it is cut off, and nothing added.
struct LightBody
{
  enum class Form
  {
    Points, ///< the hull of Corners
    Disc,   ///< Center, and Normal across it
    Ball,
    Directions ///< a Sun: Center is the unit way to its middle, Radius the tangent of its angular radius
  };
  Form Kind = Form::Points;
  Vector3 Center;
  double Radius = 0.0;
  std::vector<Vector3> Corners;
  bool OneSided = false; ///< it shines to where Normal . (x - Center) > 0 alone
  Vector3 Normal;

  bool AtInfinity() const { return this->Kind == Form::Directions; }
  bool IsPoint() const;
  /// The farthest point along a vector; not of Directions.
  Vector3 Farthest(const Vector3& along) const;
  Box Bounds() const; ///< not of Directions
  double Size = 0.0;  ///< the diagonal of its bounds
  Vector3 Middle() const { return this->Kind == Form::Points ? this->Corners[0] : this->Center; }
};

/// A Sun whose angular radius is above this (86 degrees) has no shaft.
constexpr double widestSun = 1.5;

/**
 * The convex parts of a light: one of a shape, one a face or vertex of a mesh of at most 64, else its hull (up to 256
 * corners) or the ball around it.
 */
std::vector<LightBody> LightBodiesOf(const Light& light);

/// A box, a point, or a disc across an axis: where a shaft starts.
struct ShaftStart
{
  Vector3 Center;
  Vector3 Half; ///< of a box
  Vector3 Axis; ///< of a disc
  double Radius = 0.0;

  Vector3 Middle() const { return this->Center; }
  Vector3 Farthest(const Vector3& along) const
  {
    if (this->Radius > 0.0)
    {
      return this->Center + this->Radius * Normalized(along - Dot(along, this->Axis) * this->Axis);
    }
    return this->Center +
      Vector3{ std::copysign(this->Half.X, along.X), std::copysign(this->Half.Y, along.Y),
        std::copysign(this->Half.Z, along.Z) };
  }
  /// Least and largest value of n . x.
  double Least(const Vector3& n) const { return Dot(n, this->Farthest(-n)); }
  double Largest(const Vector3& n) const { return Dot(n, this->Farthest(n)); }
};

/// The convex hull of a start and a light; without end towards a Sun, but cut beyond @p casters.
class Shaft
{
public:
  Shaft(const ShaftStart& start, const LightBody& light, const Box& casters);

  const ShaftStart& Start() const { return this->From; }
  const LightBody& Light() const { return this->To; }

  Vector3 Middle() const { return this->From.Center; }
  Vector3 Farthest(const Vector3& along) const;

  /// 1, -1: all ways from the start to the light go along n, or against it, and along every vector within @p spread of it; 0:
  /// neither.
  int SideOf(const Vector3& n, double spread = 0.0) const;

  /// 1: the light shines to all of the start; -1: to nothing of it; 0: to a part.
  int Facing() const;

private:
  ShaftStart From;
  const LightBody& To;
  double Reach = 0.0;   ///< towards a Sun
  double Longest = 1.0; ///< of the ways from the start to the light, at most; to a Sun of unit length along its middle
};

} // namespace shadowcones

#endif
