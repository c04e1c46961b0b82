// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonBalls.h"

#include "scBox.h"
#include "scPointTree.h"
#include "scRandom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace shadowcones
{
namespace
{
constexpr std::size_t ballsOfLeaf = 8;
/// Neighbours that are asked for: among a part of the photons they tell of more, in less time.
constexpr int askedNeighbours = 32;

/// Every so many-th of the photons, by a choice that knows nothing of their order.
std::vector<vtkIdType> ChosenOf(vtkIdType count, vtkIdType step)
{
  std::vector<vtkIdType> chosen;
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (HashSeed(1, static_cast<std::uint64_t>(id)) % static_cast<std::uint64_t>(step) == 0)
    {
      chosen.push_back(id);
    }
  }
  return chosen;
}

/// Values in the order that is given.
template <typename T>
void Sort(std::vector<T>& values, std::size_t components, const std::vector<int>& order)
{
  std::vector<T> sorted(values.size());
  for (std::size_t k = 0; k < order.size() && !values.empty(); ++k)
  {
    const auto from = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(order[k]) * components);
    std::copy_n(values.begin() + from, components, sorted.begin() + static_cast<std::ptrdiff_t>(k * components));
  }
  values = std::move(sorted);
}
} // anonymous namespace

bool PhotonBalls::Build(StoredPhotons photons, double neighbours, int dimension, const Monitor& monitor)
{
  this->Stored = std::move(photons);
  this->Balls.clear();
  this->Nodes.clear();
  this->Mean = 0.0;
  if (this->Stored.Count() == 0)
  {
    return true;
  }
  if (this->Stored.Count() > std::numeric_limits<int>::max())
  {
    throw std::length_error("a photon map holds at most 2^31 - 1 photons");
  }
  this->SortPhotons();
  if (!this->FindRadii(neighbours, dimension, monitor))
  {
    return false;
  }
  this->FindBoxes();
  return true;
}

void PhotonBalls::SortPhotons()
{
  Box bounds;
  const auto count = static_cast<std::size_t>(this->Stored.Count());
  for (vtkIdType id = 0; id < this->Stored.Count(); ++id)
  {
    bounds.Add(this->Stored.Point(id));
  }
  this->From = bounds.Center();
  this->Diagonal = bounds.Diagonal();
  this->Balls.resize(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vector3 place = this->Stored.Point(static_cast<vtkIdType>(k)) - this->From;
    this->Balls[k] = { { static_cast<float>(place.X), static_cast<float>(place.Y), static_cast<float>(place.Z) }, 0.0f };
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  this->Nodes.reserve(count / ballsOfLeaf * 4 + 1);
  this->BuildNode(0, count, order);
  Sort(this->Balls, 1, order);
  Sort(this->Stored.Points, 3, order);
  Sort(this->Stored.Directions, 3, order);
  Sort(this->Stored.Normals, 3, order);
  Sort(this->Stored.Powers, this->Stored.NumberOfWavelengths, order);
  Sort(this->Stored.Bounces, 1, order);
}

/// Halves along the longest side of the photons' box, down to leaves.
void PhotonBalls::BuildNode(std::size_t begin, std::size_t end, std::vector<int>& order)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  if (end - begin <= ballsOfLeaf)
  {
    this->Nodes[index].Right = static_cast<int>(begin);
    this->Nodes[index].Count = static_cast<int>(end - begin);
    return;
  }
  const auto coordinate = [this](int ball, int axis)
  { return this->Balls[static_cast<std::size_t>(ball)].Center[axis]; };
  int axis = 0;
  float longest = -1.0f;
  for (int other = 0; other < 3; ++other)
  {
    float low = std::numeric_limits<float>::max();
    float high = -low;
    for (std::size_t k = begin; k < end; ++k)
    {
      low = std::min(low, coordinate(order[k], other));
      high = std::max(high, coordinate(order[k], other));
    }
    axis = high - low > longest ? other : axis;
    longest = std::max(longest, high - low);
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&order](std::size_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end),
    [&coordinate, axis](int a, int b)
    {
      const float first = coordinate(a, axis);
      const float second = coordinate(b, axis);
      return first != second ? first < second : a < b;
    });
  this->BuildNode(begin, middle, order);
  this->Nodes[index].Right = static_cast<int>(this->Nodes.size());
  this->BuildNode(middle, end, order);
}

/// One radius for the photons of a leaf.
bool PhotonBalls::FindRadii(double neighbours, int dimension, const Monitor& monitor)
{
  const vtkIdType step = std::max<vtkIdType>(1, static_cast<vtkIdType>(neighbours) / askedNeighbours);
  const std::vector<vtkIdType> chosen = ChosenOf(this->Stored.Count(), step);
  const auto count = static_cast<vtkIdType>(chosen.size());
  const Vector3 half = 0.5 * this->Diagonal * Vector3{ 1.0, 1.0, 1.0 };
  const PointTree tree({ this->From - half, this->From + half }, count,
    [&](vtkIdType k) { return this->Stored.Point(chosen[static_cast<std::size_t>(k)]); });
  const int asked = static_cast<int>(std::min<vtkIdType>(askedNeighbours, std::max<vtkIdType>(count, 1)));
  // So many neighbours in the ball of a share of the photons stand for as many as are wanted.
  const double share = static_cast<double>(count) / static_cast<double>(this->Stored.Count());
  const double scale = std::pow(neighbours * share / asked, 1.0 / dimension);
  const double least = std::max(1e-6 * this->Diagonal, 1e-30);
  return ParallelFor(static_cast<vtkIdType>(this->Nodes.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> found;
      std::vector<double> squared;
      for (vtkIdType k = begin; k < end; ++k)
      {
        Node& leaf = this->Nodes[static_cast<std::size_t>(k)];
        Vector3 middle;
        for (int ball = 0; ball < leaf.Count; ++ball)
        {
          middle = middle + (1.0 / leaf.Count) * this->Stored.Point(leaf.Right + ball);
        }
        if (leaf.Count > 0)
        {
          tree.NearestTo(middle, asked, found, squared);
          leaf.Radius = static_cast<float>(std::max(squared.empty() ? 0.0 : scale * std::sqrt(squared.back()), least));
        }
      }
    });
}

/// Children come after their node.
void PhotonBalls::FindBoxes()
{
  double sum = 0.0;
  for (std::size_t index = this->Nodes.size(); index-- > 0;)
  {
    Node& node = this->Nodes[index];
    for (int axis = 0; axis < 3; ++axis)
    {
      float low = std::numeric_limits<float>::max();
      float high = -low;
      for (int k = node.Right; k < node.Right + node.Count; ++k)
      {
        PhotonBall& ball = this->Balls[static_cast<std::size_t>(k)];
        ball.Radius = node.Radius;
        low = std::min(low, ball.Center[axis] - ball.Radius);
        high = std::max(high, ball.Center[axis] + ball.Radius);
      }
      if (node.Count == 0)
      {
        const Node& left = this->Nodes[index + 1];
        const Node& right = this->Nodes[static_cast<std::size_t>(node.Right)];
        low = std::min(left.Min[axis], right.Min[axis]);
        high = std::max(left.Max[axis], right.Max[axis]);
        node.Radius = std::max(left.Radius, right.Radius);
      }
      node.Min[axis] = low;
      node.Max[axis] = high;
    }
    sum += static_cast<double>(node.Radius) * node.Count;
  }
  this->Mean = sum / static_cast<double>(this->Balls.size());
}

std::int64_t PhotonBalls::Memory() const
{
  return this->Stored.Memory() +
    static_cast<std::int64_t>(this->Balls.capacity() * sizeof(PhotonBall) + this->Nodes.capacity() * sizeof(Node));
}

} // namespace shadowcones
