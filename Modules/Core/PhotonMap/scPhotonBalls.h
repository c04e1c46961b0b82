// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonBalls.h
 * @brief Photons, each with the radius within which it has so many neighbours, in a tree of boxes.
 */
#ifndef scPhotonBalls_h
#define scPhotonBalls_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scStoredPhotons.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// A photon and its radius, from the origin of all. Its place among the balls is that of its photon.
struct PhotonBall
{
  float Center[3];
  float Radius;
};

/**
 * Photons that lie together in space lie together in memory; a leaf of up to 8 has one radius, which comes from the photons
 * around its middle. A query visits leaves in one order, whatever it leaves out: sums over photons have the same bits for
 * any set of points or rays that are asked together.
 */
class SHADOWCONESCORE_EXPORT PhotonBalls
{
public:
  struct Node
  {
    float Min[3]; ///< box around all balls
    float Max[3];
    int Right = 0; ///< inner node: its right child, the left one follows it; leaf: first ball
    int Count = 0; ///< leaf: number of balls; inner node: 0
    float Radius = 0.0f; ///< largest of its balls
  };

  /**
   * Take photons, whose order changes. @param neighbours of a photon within its radius, may be below 1. @param dimension 3 where
   * photons fill space, 2 where they lie on surfaces. @return false where aborted.
   */
  bool Build(StoredPhotons photons, double neighbours, int dimension, const Monitor& monitor);

  /// Call visit(ball) for every ball of the leaves for which, as for all nodes above, meets(node) is true.
  template <typename Meets, typename Visitor>
  void ForEach(Meets&& meets, Visitor&& visit) const
  {
    int stack[64];
    int size = 0;
    stack[size++] = 0;
    while (size > 0 && !this->Nodes.empty())
    {
      const int index = stack[--size];
      const Node& node = this->Nodes[static_cast<std::size_t>(index)];
      if (!meets(node))
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
        visit(static_cast<std::size_t>(k));
      }
    }
  }

  const PhotonBall& operator[](std::size_t ball) const { return this->Balls[ball]; }
  bool Empty() const { return this->Balls.empty(); }
  const StoredPhotons& Photons() const { return this->Stored; }
  const Vector3& Origin() const { return this->From; }
  /// Mean radius, world units.
  double MeanRadius() const { return this->Mean; }
  std::int64_t Memory() const;

private:
  void SortPhotons();
  void BuildNode(std::size_t begin, std::size_t end, std::vector<int>& order);
  bool FindRadii(double neighbours, int dimension, const Monitor& monitor);
  void FindBoxes();

  StoredPhotons Stored;
  Vector3 From;
  double Diagonal = 0.0;
  double Mean = 0.0;
  std::vector<PhotonBall> Balls;
  std::vector<Node> Nodes;
};

} // namespace shadowcones

#endif
