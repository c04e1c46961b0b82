// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rival.h
 * @brief A way to hold the shadow of a mesh in space: what every one of them has to answer.
 */
#ifndef Rival_h
#define Rival_h

#include "scRandom.h"
#include "scRay.h"
#include "scRayInterval.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// A camera ray's part in the medium, cut into cells, with a place in each.
struct RivalRay
{
  Ray Line;
  std::vector<double> Cuts;   ///< distances, ascending; one more than cells
  std::vector<double> Places; ///< distances, one a cell
  std::uint64_t Key = 0;      ///< random numbers of the ray start from it

  std::size_t Count() const { return this->Places.size(); }
  Vector3 Place(std::size_t k) const { return this->Line.Origin + this->Places[k] * this->Line.Direction; }
};

/// Built once, asked often, from any number of threads.
class Rival
{
public:
  virtual ~Rival() = default;
  /// The share of the light that is blocked, 0..1, at the place of each cell, or over the cell where that is known.
  virtual void BlockedAlong(const RivalRay& ray, std::vector<double>& blocked) const = 0;
  /// Bytes of what was built, without the mesh; of the mesh's search tree where rays are asked when rendering.
  virtual std::int64_t Memory() const = 0;
};

/// A rival that answers point by point.
class PointRival : public Rival
{
public:
  virtual double BlockedAt(const Vector3& x, RandomStream& random) const = 0;

  void BlockedAlong(const RivalRay& ray, std::vector<double>& blocked) const override
  {
    blocked.resize(ray.Count());
    for (std::size_t k = 0; k < ray.Count(); ++k)
    {
      RandomStream random(ray.Key, k);
      blocked[k] = this->BlockedAt(ray.Place(k), random);
    }
  }
};

} // namespace shadowcones

#endif
