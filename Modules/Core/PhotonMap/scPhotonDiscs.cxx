// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonDiscs.h"

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
constexpr std::size_t discsOfLeaf = 8;
/// Neighbours that are asked for: among a part of the photons they tell of more, in less time.
constexpr int askedNeighbours = 8;
} // anonymous namespace

bool PhotonDiscs::Build(StoredPhotons photons, int neighbours, const Monitor& monitor)
{
  this->Stored = std::move(photons);
  this->Discs.clear();
  this->Nodes.clear();
  if (this->Stored.Count() == 0)
  {
    return true;
  }
  if (this->Stored.Count() > std::numeric_limits<int>::max())
  {
    throw std::length_error("a photon map holds at most 2^31 - 1 photons");
  }
  if (!this->FindRadii(neighbours, monitor))
  {
    return false;
  }
  this->Nodes.reserve(this->Discs.size() / discsOfLeaf * 4 + 1);
  this->BuildNode(0, this->Discs.size());
  this->SortPhotons();
  return !monitor.IsAborted();
}

/// The photons that are asked for neighbours: all, or of many a part that knows nothing of their order.
std::vector<vtkIdType> PhotonDiscs::ChosenFor(int neighbours) const
{
  constexpr vtkIdType many = 64;
  const vtkIdType step = this->Stored.Count() >= many * neighbours ? std::max(1, neighbours / askedNeighbours) : 1;
  std::vector<vtkIdType> chosen;
  for (vtkIdType id = 0; id < this->Stored.Count(); ++id)
  {
    if (HashSeed(1, static_cast<std::uint64_t>(id)) % static_cast<std::uint64_t>(step) == 0)
    {
      chosen.push_back(id);
    }
  }
  return chosen;
}

/// Radii within which a photon has so many neighbours, itself left out.
bool PhotonDiscs::FindRadii(int neighbours, const Monitor& monitor)
{
  Box bounds;
  for (vtkIdType id = 0; id < this->Stored.Count(); ++id)
  {
    bounds.Add(this->Stored.Point(id));
  }
  this->Origin = bounds.Center();
  const std::vector<vtkIdType> chosen = this->ChosenFor(neighbours);
  const auto count = static_cast<vtkIdType>(chosen.size());
  const PointTree tree(
    bounds, count, [&](vtkIdType k) { return this->Stored.Point(chosen[static_cast<std::size_t>(k)]); });
  const double share = static_cast<double>(count) / static_cast<double>(this->Stored.Count());
  const int asked = share < 1.0 ? askedNeighbours : neighbours;
  // k neighbours in a ball of a share of the photons stand for as many as are asked for.
  const double scale = std::cbrt(neighbours * share / asked);
  const double least = 1e-6 * bounds.Diagonal();
  this->Discs.resize(static_cast<std::size_t>(this->Stored.Count()));
  return ParallelFor(this->Stored.Count(), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> found;
      std::vector<double> squared;
      for (vtkIdType id = begin; id < end; ++id)
      {
        const Vector3 point = this->Stored.Point(id);
        const bool isInTree = std::binary_search(chosen.begin(), chosen.end(), id);
        tree.NearestTo(point, asked + (isInTree ? 1 : 0), found, squared);
        const double radius = std::max(scale * std::sqrt(squared.back()), least);
        const Vector3 place = point - this->Origin;
        this->Discs[static_cast<std::size_t>(id)] = { { static_cast<float>(place.X), static_cast<float>(place.Y),
                                                        static_cast<float>(place.Z) },
          static_cast<float>(radius), static_cast<int>(id) };
      }
    });
}

void PhotonDiscs::BuildNode(std::size_t begin, std::size_t end)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Node node;
  for (std::size_t k = begin; k < end; ++k)
  {
    node.Radius = std::max(node.Radius, this->Discs[k].Radius);
  }
  float low[3];
  float high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = node.Min[axis] = std::numeric_limits<float>::max();
    high[axis] = node.Max[axis] = -std::numeric_limits<float>::max();
    for (std::size_t k = begin; k < end; ++k)
    {
      const Disc& disc = this->Discs[k];
      low[axis] = std::min(low[axis], disc.Center[axis]);
      high[axis] = std::max(high[axis], disc.Center[axis]);
      node.Min[axis] = std::min(node.Min[axis], disc.Center[axis] - disc.Radius);
      node.Max[axis] = std::max(node.Max[axis], disc.Center[axis] + disc.Radius);
    }
  }
  if (end - begin <= discsOfLeaf)
  {
    node.Right = static_cast<int>(begin);
    node.Count = static_cast<int>(end - begin);
    this->Nodes[index] = node;
    return;
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other)
  {
    axis = high[other] - low[other] > high[axis] - low[axis] ? other : axis;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t k) { return this->Discs.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end),
    [axis](const Disc& a, const Disc& b)
    {
      return a.Center[axis] != b.Center[axis] ? a.Center[axis] < b.Center[axis] : a.Photon < b.Photon;
    });
  this->BuildNode(begin, middle);
  node.Right = static_cast<int>(this->Nodes.size());
  this->Nodes[index] = node;
  this->BuildNode(middle, end);
}

/// Photons in the order of their discs: those that a ray gathers lie together in memory.
void PhotonDiscs::SortPhotons()
{
  const auto sort = [this](auto& values, std::size_t components)
  {
    std::decay_t<decltype(values)> sorted(values.size());
    for (std::size_t k = 0; k < this->Discs.size() && !values.empty(); ++k)
    {
      const std::size_t from = static_cast<std::size_t>(this->Discs[k].Photon) * components;
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(from), components,
        sorted.begin() + static_cast<std::ptrdiff_t>(k * components));
    }
    values = std::move(sorted);
  };
  sort(this->Stored.Points, 3);
  sort(this->Stored.Directions, 3);
  sort(this->Stored.Normals, 3);
  sort(this->Stored.Powers, this->Stored.NumberOfWavelengths);
  sort(this->Stored.Bounces, 1);
  for (std::size_t k = 0; k < this->Discs.size(); ++k)
  {
    this->Discs[k].Photon = static_cast<int>(k);
  }
}

double PhotonDiscs::MeanRadius() const
{
  const double sum = std::accumulate(this->Discs.begin(), this->Discs.end(), 0.0,
    [](double total, const Disc& disc) { return total + static_cast<double>(disc.Radius); });
  return this->Discs.empty() ? 0.0 : sum / static_cast<double>(this->Discs.size());
}

std::int64_t PhotonDiscs::Memory() const
{
  return this->Stored.Memory() +
    static_cast<std::int64_t>(this->Discs.capacity() * sizeof(Disc) + this->Nodes.capacity() * sizeof(Node));
}

} // namespace shadowcones
