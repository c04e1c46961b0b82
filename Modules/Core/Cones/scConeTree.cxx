// SPDX-License-Identifier: BSD-3-Clause
#include "scConeTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shadowcones
{
namespace
{
constexpr std::size_t leafSize = 4;
/// Slices are at most this many times longer than wide, so that boxes fit slanted cones; at most this many a cone.
constexpr double sliceAspect = 2.0;
constexpr int largestNumberOfSlices = 16;

void AddDisc(const Cone& cone, double tangent, double height, Box& box)
{
  const Vector3 center = cone.Center + height * cone.Axis;
  const Vector3 extent = DiscExtent(cone.Axis, RadiusAt(cone.BaseRadius, tangent, height));
  box.Add(center - extent);
  box.Add(center + extent);
}

/// Round-off must not cut a cone's skin from its box.
void Grow(Box& box)
{
  const double size = std::max({ std::abs(box.Min.X), std::abs(box.Min.Y), std::abs(box.Min.Z), std::abs(box.Max.X),
    std::abs(box.Max.Y), std::abs(box.Max.Z) });
  const double margin = 1e-9 * box.Diagonal() + 8.0 * std::numeric_limits<double>::epsilon() * size;
  box.Min = box.Min - Vector3{ margin, margin, margin };
  box.Max = box.Max + Vector3{ margin, margin, margin };
}

bool Overlap(const Box& a, const Box& b)
{
  return a.Min.X <= b.Max.X && a.Max.X >= b.Min.X && a.Min.Y <= b.Max.Y && a.Max.Y >= b.Min.Y && a.Min.Z <= b.Max.Z &&
    a.Max.Z >= b.Min.Z;
}

/// How far a cone reaches, and into how many slices it is cut; none where it does not reach into the bounds.
struct Slicing
{
  Slicing(const Cone& cone, const Box& bounds, double length)
    : Tangent(std::tan(cone.HalfAngle))
    , End(std::min({ length, HighestCorner(cone, bounds), TipHeight(cone.BaseRadius, Tangent) }))
  {
    if (this->End >= 0.0)
    {
      const double width = std::max(cone.BaseRadius, 0.5 * RadiusAt(cone.BaseRadius, this->Tangent, this->End));
      const double slices = width > 0.0 ? std::ceil(this->End / (sliceAspect * width)) : 1.0 * largestNumberOfSlices;
      // Bounds that are empty have no end, which gives no number.
      this->Count = std::isnan(slices) ? 0 : static_cast<int>(std::clamp(slices, 1.0, 1.0 * largestNumberOfSlices));
    }
  }

  double Tangent;
  double End;
  int Count = 0;
};

} // anonymous namespace

ConeTree ConeTree::OverSlices(const std::vector<Cone>& cones, const Box& bounds, double length)
{
  std::size_t most = 0;
  for (const Cone& cone : cones)
  {
    most += static_cast<std::size_t>(Slicing(cone, bounds, length).Count);
  }
  std::vector<Entry> entries;
  entries.reserve(most); // growing by doubling would take up to three times that for a moment
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    const Cone& cone = cones[i];
    const Slicing slicing(cone, bounds, length);
    const double tangent = slicing.Tangent;
    const double end = slicing.End;
    const int slices = slicing.Count;
    for (int slice = 0; slice < slices; ++slice)
    {
      Entry entry;
      entry.Cone = static_cast<int>(i);
      entry.Low = end * slice / slices;
      entry.High = end * (slice + 1) / slices;
      AddDisc(cone, tangent, entry.Low, entry.Bounds);
      AddDisc(cone, tangent, entry.High, entry.Bounds);
      Grow(entry.Bounds);
      if (Overlap(entry.Bounds, bounds))
      {
        entries.push_back(entry);
      }
    }
  }
  return ConeTree(std::move(entries));
}

ConeTree ConeTree::OverBases(const std::vector<Cone>& cones)
{
  std::vector<Entry> entries(cones.size());
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    entries[i].Cone = static_cast<int>(i);
    AddDisc(cones[i], 0.0, 0.0, entries[i].Bounds);
    Grow(entries[i].Bounds);
  }
  return ConeTree(std::move(entries));
}

ConeTree::ConeTree(std::vector<Entry> entries)
  : Entries(std::move(entries))
{
  if (this->Entries.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw std::length_error("a tree holds at most 2^31 - 1 slices of cones");
  }
  if (!this->Entries.empty())
  {
    this->Nodes.reserve(2 * this->Entries.size() / leafSize + 2);
    this->BuildNode(0, this->Entries.size());
  }
}

void ConeTree::BuildNode(std::size_t begin, std::size_t end)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Box bounds;
  Box centers;
  for (std::size_t i = begin; i < end; ++i)
  {
    bounds.Add(this->Entries[i].Bounds);
    centers.Add(this->Entries[i].Bounds.Center());
  }
  this->Nodes[index].Bounds = bounds;
  if (end - begin <= leafSize)
  {
    this->Nodes[index].Right = static_cast<int>(begin);
    this->Nodes[index].Count = static_cast<int>(end - begin);
    return;
  }

  // Halve along the longest axis of the centres: balanced, hence a stack of 64 is deep enough.
  const Vector3 size = centers.Size();
  const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(this->Entries.begin() + begin, this->Entries.begin() + middle, this->Entries.begin() + end,
    [axis](const Entry& a, const Entry& b) {
      const double ca = a.Bounds.Min[axis] + a.Bounds.Max[axis];
      const double cb = b.Bounds.Min[axis] + b.Bounds.Max[axis];
      return ca != cb ? ca < cb : a.Cone != b.Cone ? a.Cone < b.Cone : a.Low < b.Low;
    });
  this->BuildNode(begin, middle);
  this->Nodes[index].Right = static_cast<int>(this->Nodes.size());
  this->BuildNode(middle, end);
}

} // namespace shadowcones
