// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonDiscs.h
 * @brief Radiance along rays from the photons of a medium: the beam radiance estimate.
 *
 * After Jarosz, Zwicker and Jensen ("The Beam Radiance Estimate for Volumetric Photon Mapping", Eurographics 2008): every
 * photon is a disc that faces the ray, with the radius within which it has so many neighbours; a ray gathers all discs that
 * it pierces, each once, so that nothing is marched. The kernel is 3 / (pi r^2) (1 - d^2 / r^2)^2, d from the ray.
 */
#ifndef scPhotonDiscs_h
#define scPhotonDiscs_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scPhaseFunction.h"
#include "scRay.h"
#include "scRayInterval.h"
#include "scStoredPhotons.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

class SHADOWCONESCORE_EXPORT PhotonDiscs
{
public:
  /// Nothing until Build().
  PhotonDiscs() = default;

  /// Take photons, whose order changes, and whose discs are to hold so many neighbours. @return false where aborted.
  bool Build(StoredPhotons photons, int neighbours, const Monitor& monitor);

  /// A disc that a ray pierces.
  struct Pierced
  {
    vtkIdType Photon = 0; ///< in Photons()
    double T = 0.0;       ///< along the ray
    double Kernel = 0.0;  ///< 1 / square unit
  };
  /**
   * Call visit(Pierced) for every disc that the ray pierces inside this part of it, or beyond its end by less than so many of
   * the disc's radii, @p beyond. Where a ray ends at a slanted surface, as many photons in front of that lie beyond the end as are
   * missing before it: an estimate that takes them, up to the tangent of the slant, is right to first order.
   */
  template <typename Visitor>
  void ForEachPierced(const Ray& ray, const RayInterval& part, double beyond, Visitor&& visit) const;

  bool Empty() const { return this->Discs.empty(); }
  const StoredPhotons& Photons() const { return this->Stored; }
  /// Mean radius of the discs, world units.
  double MeanRadius() const;
  std::int64_t Memory() const;

private:
  struct Disc
  {
    float Center[3]; ///< from Origin
    float Radius;
    int Photon;
  };
  struct Node
  {
    float Min[3]; ///< box around all discs, whichever way they face, from Origin
    float Max[3];
    int Right = 0; ///< inner node: its right child, the left one follows it; leaf: first disc
    int Count = 0; ///< leaf: number of discs; inner node: 0
    float Radius = 0.0f; ///< largest of its discs
  };

  std::vector<vtkIdType> ChosenFor(int neighbours) const;
  bool FindRadii(int neighbours, const Monitor& monitor);
  void BuildNode(std::size_t begin, std::size_t end);
  void SortPhotons();
  static bool MeetsRay(
    const Node& node, const double (&origin)[3], const double (&inverse)[3], RayInterval part);

  StoredPhotons Stored;
  Vector3 Origin;
  std::vector<Disc> Discs;
  std::vector<Node> Nodes;
};

inline bool PhotonDiscs::MeetsRay(
  const Node& node, const double (&origin)[3], const double (&inverse)[3], RayInterval part)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = (node.Min[axis] - origin[axis]) * inverse[axis];
    const double b = (node.Max[axis] - origin[axis]) * inverse[axis];
    const double near = a < b ? a : b;
    const double far = a < b ? b : a;
    part.Begin = near > part.Begin ? near : part.Begin;
    part.End = far < part.End ? far : part.End;
  }
  return part.Begin <= part.End;
}

template <typename Visitor>
void PhotonDiscs::ForEachPierced(const Ray& ray, const RayInterval& part, double beyond, Visitor&& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  const Vector3 from = ray.Origin - this->Origin;
  const Vector3& along = ray.Direction;
  const double origin[3] = { from.X, from.Y, from.Z };
  // A finite stand-in for 1 / 0: no NaN where a ray runs in the face of a box.
  const auto inverseOf = [](double x) { return x != 0.0 ? 1.0 / x : 1e300; };
  const double inverse[3] = { inverseOf(along.X), inverseOf(along.Y), inverseOf(along.Z) };
  int stack[64];
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const int index = stack[--size];
    const Node& node = this->Nodes[static_cast<std::size_t>(index)];
    if (!MeetsRay(node, origin, inverse, { part.Begin, part.End + beyond * node.Radius }))
    {
      continue;
    }
    if (node.Count == 0)
    {
      stack[size++] = node.Right;
      stack[size++] = index + 1;
      continue;
    }
    for (int k = node.Right; k < node.Right + node.Count; ++k)
    {
      const Disc& disc = this->Discs[static_cast<std::size_t>(k)];
      const Vector3 to = Vector3{ disc.Center[0], disc.Center[1], disc.Center[2] } - from;
      const double t = Dot(to, along);
      const Vector3 across = to - t * along;
      const double squaredRadius = static_cast<double>(disc.Radius) * disc.Radius;
      const double squared = Dot(across, across);
      if (squared < squaredRadius && t > part.Begin && t < part.End + beyond * disc.Radius)
      {
        constexpr double threeOverPi = 0.95492965855137201461;
        const double rest = 1.0 - squared / squaredRadius;
        visit(Pierced{ disc.Photon, t, threeOverPi * rest * rest / squaredRadius });
      }
    }
  }
}

} // namespace shadowcones

#endif
