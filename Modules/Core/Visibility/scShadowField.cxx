// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowField.h"

#include "scGridBlock.h"
#include "scLampPlane.h"
#include "scShadowCasters.h"
#include "scShadowSamples.h"
#include "scShaft.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shadowcones
{
namespace
{
using Index = std::array<int, 3>;

/// Blocks of points with sides up to this long are not divided any more.
constexpr int leafSide = 4;
/// The grid is divided into at most this many blocks a side to begin with.
constexpr int coarseBlocks = 16;
/// Cells along the longest side of the region in which the outer solid is looked for.
constexpr int cellsToFind = 24;
/// Halvings of an edge: a thousandth.
constexpr int halvings = 10;
/// A surface keeps this share of an edge away from its ends: neighbours of a point then have room for triangles.
constexpr double smallestShare = 0.02;
/// Rays that may take turns in deciding where an edge leaves the full shadow.
constexpr int mostTurns = 24;
/// Middles of triangles may lie so far beyond the end of the solid, in cells.
constexpr double beyond = 0.004;
constexpr int roundsOfMoves = 2;

enum Answer : unsigned char
{
  No = 0,
  ForSure = 1, ///< with all of its block
  BySamples = 2
};

Index IndexOf(const RegularGrid& grid, vtkIdType id)
{
  const vtkIdType row = grid.Dimensions[0];
  const vtkIdType slice = row * grid.Dimensions[1];
  return { static_cast<int>(id % row), static_cast<int>(id % slice / row), static_cast<int>(id / slice) };
}

Vector3 PointAt(const RegularGrid& grid, vtkIdType id)
{
  const Index index = IndexOf(grid, id);
  return grid.Point(index[0], index[1], index[2]);
}

bool IsOutermost(const RegularGrid& grid, const Index& index)
{
  return index[0] == 0 || index[1] == 0 || index[2] == 0 || index[0] + 1 == grid.Dimensions[0] ||
    index[1] + 1 == grid.Dimensions[1] || index[2] + 1 == grid.Dimensions[2];
}

/// All blocks of the inner points of a grid, to begin with.
std::vector<GridBlock> BlocksOf(const RegularGrid& grid)
{
  Index blocks{};
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks[axis] = std::clamp((grid.Dimensions[axis] - 2) / leafSide, 1, coarseBlocks);
  }
  std::vector<GridBlock> all;
  for (int b = 0; b < blocks[0] * blocks[1] * blocks[2]; ++b)
  {
    const Index index = { b % blocks[0], b / blocks[0] % blocks[1], b / blocks[0] / blocks[1] };
    GridBlock block{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType inner = grid.Dimensions[axis] - 2;
      block.Begin[axis] = 1 + static_cast<int>(PieceBound(inner, index[axis], blocks[axis]));
      block.End[axis] = 1 + static_cast<int>(PieceBound(inner, index[axis] + 1, blocks[axis]));
    }
    all.push_back(block);
  }
  return all;
}

Box Around(const Vector3& center, const Vector3& half)
{
  return { center - half, center + half };
}

ShaftStart StartOf(const Box& box)
{
  ShaftStart start;
  start.Center = box.Center();
  start.Half = 0.5 * box.Size();
  return start;
}
} // anonymous namespace

struct ShadowField::Implementation
{
  Implementation(const OccluderScene& scene, const Light& light, int samples)
    : Bodies(LightBodiesOf(light))
    , Casters(scene.Mesh(), scene.RulesFor(FlatFaceOf(light)).Ignored, this->Bodies)
    , Samples(light, samples, scene)
    , Exact(std::all_of(this->Bodies.begin(), this->Bodies.end(), [](const LightBody& body) { return body.IsPoint(); }))
  {
  }

  Shaft To(const ShaftStart& start, const LightBody& body) const { return { start, body, this->Casters.Bounds() }; }

  bool Contains(const Vector3& place, ShadowBound bound) const
  {
    if (bound == ShadowBound::Inner || this->Exact)
    {
      const ShadowSamples::Answer answer = this->Samples.Ask(place, bound == ShadowBound::Outer);
      return answer.AnyHidden && (bound == ShadowBound::Outer || !answer.AnyVisible);
    }
    ShaftStart start;
    start.Center = place;
    return std::any_of(this->Bodies.begin(), this->Bodies.end(),
      [&](const LightBody& body)
      {
        const Shaft shaft = this->To(start, body);
        return shaft.Facing() > 0 && this->Casters.Meets(shaft);
      });
  }

  /// May anything in the box be less than lit?
  bool MayShade(const Box& box) const
  {
    return std::any_of(this->Bodies.begin(), this->Bodies.end(),
      [&](const LightBody& body)
      {
        const Shaft shaft = this->To(StartOf(box), body);
        return shaft.Facing() >= 0 && this->Casters.Meets(shaft);
      });
  }

  /// 1, 0: all of the box belongs to the solid, or nothing; -1: not known.
  int WholeBlock(const Box& box, ShadowBound bound) const
  {
    bool open = false;
    bool hidden = false;
    bool mixed = false;
    for (const LightBody& body : this->Bodies)
    {
      const Shaft shaft = this->To(StartOf(box), body);
      const int facing = shaft.Facing();
      if (facing < 0)
      {
        continue;
      }
      const ShaftFinding finding = facing > 0 ? this->Casters.Look(shaft) : ShaftFinding::Mixed;
      const bool isHidden = finding == ShaftFinding::Alike && this->Samples.IsHidden(box.Center(), body);
      hidden = hidden || isHidden;
      open = open || (finding != ShaftFinding::Mixed && !isHidden);
      mixed = mixed || finding == ShaftFinding::Mixed;
    }
    if (bound == ShadowBound::Outer ? hidden : open)
    {
      return bound == ShadowBound::Outer ? 1 : 0;
    }
    return mixed ? -1 : (hidden ? 1 : 0);
  }

  void Fill(const RegularGrid& grid, const GridBlock& block, ShadowBound bound, unsigned char* inside) const
  {
    Box box = block.Bounds(grid);
    if (bound == ShadowBound::Inner)
    {
      box.Max += grid.Spacing; // with what lies between its points and the next ones
    }
    const int whole = this->WholeBlock(box, bound);
    if (whole >= 0)
    {
      block.ForEachPoint(
        grid, [&](vtkIdType id, const Vector3&) { inside[id] = whole > 0 ? Answer::ForSure : Answer::No; });
      return;
    }
    const int longest = block.Longest();
    if (block.Side(longest) <= leafSide)
    {
      block.ForEachPoint(grid,
        [&](vtkIdType id, const Vector3& point)
        { inside[id] = this->Contains(point, bound) ? Answer::BySamples : Answer::No; });
      return;
    }
    GridBlock first = block;
    GridBlock second = block;
    first.End[longest] = second.Begin[longest] = block.Begin[longest] + block.Side(longest) / 2;
    this->Fill(grid, first, bound, inside);
    this->Fill(grid, second, bound, inside);
  }

  /// Does light pass between the point and one of its next neighbours, which are both in full shadow?
  bool HasGap(const RegularGrid& grid, vtkIdType id, const unsigned char* inside) const
  {
    const Vector3 point = PointAt(grid, id);
    const vtkIdType steps[3] = { 1, grid.Dimensions[0],
      static_cast<vtkIdType>(grid.Dimensions[0]) * grid.Dimensions[1] };
    const Vector3 halves[3] = { { 0.5 * grid.Spacing.X, 0.0, 0.0 }, { 0.0, 0.5 * grid.Spacing.Y, 0.0 },
      { 0.0, 0.0, 0.5 * grid.Spacing.Z } };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (inside[id + steps[axis]] != Answer::No && !this->Contains(point + halves[axis], ShadowBound::Inner))
      {
        return true;
      }
    }
    return false;
  }

  double CrossOuter(const Vector3& a, const Vector3& b) const
  {
    double in = 0.0;
    double out = 1.0;
    for (int k = 0; k < halvings; ++k)
    {
      const double middle = 0.5 * (in + out);
      (this->Contains(a + middle * (b - a), ShadowBound::Outer) ? in : out) = middle;
    }
    return out; // nothing of the shadow is lost
  }

  /**
   * A point of the light that is seen from the end is followed to where it hides; if another one is still seen there, that
   * one is followed from there on.
   */
  double CrossInner(const Vector3& a, const Vector3& b) const
  {
    double end = 1.0;
    int seen = this->Samples.Ask(b, false).FirstVisible;
    if (seen < 0) // the light does not shine there, or a gap was found on the way
    {
      end = 0.5;
      seen = this->Samples.Ask(a + end * (b - a), false).FirstVisible;
    }
    for (int turn = 0; turn < mostTurns && seen >= 0; ++turn)
    {
      double in = 0.0;
      double out = end;
      for (int k = 0; k < halvings; ++k)
      {
        const double middle = 0.5 * (in + out);
        (this->Samples.IsHidden(a + middle * (b - a), seen) ? in : out) = middle;
      }
      end = in;
      seen = end > 0.0 ? this->Samples.Ask(a + end * (b - a), false).FirstVisible : -1;
    }
    return seen < 0 ? end : 0.0;
  }

  /// How far the solid ends behind a point of the surface (Inner), or before it (Outer), up to @p most; 0: no farther than it may.
  double Excess(const Vector3& point, const Vector3& outward, double most, ShadowBound bound) const
  {
    const bool outer = bound == ShadowBound::Outer;
    const Vector3 way = outer ? outward : -outward;
    const auto isGood = [&](double distance) { return this->Contains(point + distance * way, bound) != outer; };
    if (isGood(beyond * most))
    {
      return 0.0;
    }
    // What a curved surface takes first, then what an edge may.
    double bad = 0.0;
    double good = 0.06 * most;
    while (good < most && !isGood(good))
    {
      bad = good;
      good = std::min(4.0 * good, most);
    }
    for (int k = 0; k < 3; ++k)
    {
      const double middle = 0.5 * (bad + good);
      (isGood(middle) ? good : bad) = middle;
    }
    return good;
  }

  /// Looks only at triangles of crossings that were @p moved before, and says which are now; at all where there are none.
  /// Move crossings by what the triangles around them exceed the solid (Inner), or fall short of it (Outer).
  bool MoveToTruth(const RegularGrid& grid, ShadowBound bound, const std::vector<double>& ends, const Monitor& monitor,
    GridSurface& surface, std::vector<unsigned char>& moved) const
  {
    std::vector<GridCrossing>& crossings = surface.Crossings;
    const double cell = std::min({ grid.Spacing.X, grid.Spacing.Y, grid.Spacing.Z });
    std::vector<double> excess(surface.Triangles.size());
    const auto isSettled = [&](vtkIdType t)
    {
      const auto& corners = surface.Triangles[t];
      return !moved.empty() && !moved[corners[0]] && !moved[corners[1]] && !moved[corners[2]];
    };
    const auto measure = [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        const auto& corners = surface.Triangles[t];
        const bool onFace = ends[corners[0]] == 0.0 && ends[corners[1]] == 0.0 && ends[corners[2]] == 0.0;
        const Vector3 a = surface.PointOf(grid, crossings[corners[0]]);
        const Vector3 b = surface.PointOf(grid, crossings[corners[1]]);
        const Vector3 c = surface.PointOf(grid, crossings[corners[2]]);
        excess[t] = onFace || isSettled(t)
          ? 0.0
          : this->Excess((1.0 / 3.0) * (a + b + c), Normalized(Cross(b - a, c - a)), cell, bound);
      }
    };
    const bool measured = ParallelFor(static_cast<vtkIdType>(excess.size()), monitor, measure);
    std::vector<double> moves(crossings.size(), 0.0);
    for (std::size_t t = 0; t < excess.size(); ++t)
    {
      for (const vtkIdType corner : surface.Triangles[t])
      {
        moves[corner] = std::max(moves[corner], excess[t]);
      }
    }
    moved.assign(crossings.size(), 0);
    for (std::size_t i = 0; i < crossings.size(); ++i)
    {
      moved[i] = moves[i] > 0.0;
      GridCrossing& c = crossings[i];
      const double edge = Length(PointAt(grid, c.Outside) - PointAt(grid, c.Inside));
      const double move = (bound == ShadowBound::Outer ? moves[i] : -moves[i]) / edge;
      c.Fraction = ends[i] > 0.0 ? std::clamp(c.Fraction + move, smallestShare, ends[i]) : c.Fraction;
    }
    return measured;
  }

  std::vector<LightBody> Bodies;
  ShadowCasters Casters;
  ShadowSamples Samples;
  bool Exact; ///< every ray to the light is asked for
};

Vector3 GridSurface::PointOf(const RegularGrid& grid, const GridCrossing& crossing) const
{
  const Vector3 a = PointAt(grid, crossing.Inside);
  return a + crossing.Fraction * (PointAt(grid, crossing.Outside) - a);
}

ShadowField::ShadowField(const OccluderScene& scene, const Light& light, int samples)
{
  if (IsAtInfinity(light) && light.Radius > widestSun)
  {
    throw std::invalid_argument("a Sun of more than 171 degrees has no solids.");
  }
  this->Impl = std::make_unique<Implementation>(scene, light, samples);
}

ShadowField::~ShadowField() = default;

bool ShadowField::Contains(const Vector3& place, ShadowBound bound) const
{
  return this->Impl->Contains(place, bound);
}

Box ShadowField::Find(const Box& region, ShadowBound bound, int resolution, const Monitor& monitor) const
{
  const bool outer = bound == ShadowBound::Outer;
  const RegularGrid grid = GridOver(region, outer ? cellsToFind : (resolution + 1) / 2);
  std::vector<unsigned char> inside(static_cast<std::size_t>(grid.NumberOfPoints()), 0);
  const auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType id = begin; id < end; ++id)
    {
      const Index index = IndexOf(grid, id);
      inside[id] = !IsOutermost(grid, index) &&
        this->Impl->MayShade(Around(grid.Point(index[0], index[1], index[2]), 0.5 * grid.Spacing));
    }
  };
  Box found;
  if (!(outer ? ParallelFor(grid.NumberOfPoints(), monitor, look)
              : this->Classify(grid, bound, monitor, inside.data())))
  {
    return found;
  }
  for (vtkIdType id = 0; id < grid.NumberOfPoints(); ++id)
  {
    if (inside[id])
    {
      // A cell of the outer solid is known as a whole; the inner one may reach to the next point.
      found.Add(Around(PointAt(grid, id), (outer ? 0.5 : 1.0) * grid.Spacing));
    }
  }
  return found.Empty() ? found : Intersection(found, region);
}

bool ShadowField::Classify(
  const RegularGrid& grid, ShadowBound bound, const Monitor& monitor, unsigned char* inside) const
{
  std::fill_n(inside, grid.NumberOfPoints(), static_cast<unsigned char>(Answer::No));
  if (grid.NumberOfPoints() == 0)
  {
    return true;
  }
  const std::vector<GridBlock> blocks = BlocksOf(grid);
  const bool inner = bound == ShadowBound::Inner;
  const bool filled = ParallelFor(static_cast<vtkIdType>(blocks.size()), monitor.Part(0.0, inner ? 0.7 : 1.0),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        this->Impl->Fill(grid, blocks[b], bound, inside);
      }
    });
  if (!filled)
  {
    return false;
  }
  std::vector<unsigned char> gaps(inner ? static_cast<std::size_t>(grid.NumberOfPoints()) : 0, 0);
  const bool looked = ParallelFor(static_cast<vtkIdType>(gaps.size()), monitor.Part(0.7, 1.0),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        gaps[id] = inside[id] == Answer::BySamples && this->Impl->HasGap(grid, id, inside);
      }
    });
  for (vtkIdType id = 0; id < grid.NumberOfPoints(); ++id)
  {
    inside[id] = inside[id] != Answer::No && !(inner && gaps[id]);
  }
  return looked;
}

bool ShadowField::Place(const RegularGrid& grid, ShadowBound bound, const Monitor& monitor, GridSurface& surface) const
{
  const Implementation& impl = *this->Impl;
  std::vector<GridCrossing>& crossings = surface.Crossings;
  // How far along its edge each may lie; to the face of the box in the outermost layer. Those on the face stay there.
  std::vector<double> ends(crossings.size());
  const bool placed = ParallelFor(static_cast<vtkIdType>(crossings.size()), monitor.Part(0.0, 0.5),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        GridCrossing& c = crossings[i];
        const bool outermost = IsOutermost(grid, IndexOf(grid, c.Outside));
        const Vector3 a = PointAt(grid, c.Inside);
        const Vector3 b = outermost ? 0.5 * (a + PointAt(grid, c.Outside)) : PointAt(grid, c.Outside);
        const bool onFace = outermost && impl.Contains(b, bound);
        const double fraction =
          onFace ? 1.0 : (bound == ShadowBound::Outer ? impl.CrossOuter(a, b) : impl.CrossInner(a, b));
        ends[i] = onFace ? 0.0 : (outermost ? 0.5 : 1.0 - smallestShare);
        c.Fraction = std::clamp(outermost ? 0.5 * fraction : fraction, smallestShare, 1.0 - smallestShare);
      }
    });
  std::vector<unsigned char> moved;
  for (int round = 0; placed && round < roundsOfMoves; ++round)
  {
    const double from = 0.5 + 0.5 * round / roundsOfMoves;
    if (!impl.MoveToTruth(grid, bound, ends, monitor.Part(from, from + 0.5 / roundsOfMoves), surface, moved))
    {
      return false;
    }
  }
  return placed;
}

Box ShadowReach(const Box& casters, const Light& light, double length)
{
  Box reach = casters;
  if (casters.Empty())
  {
    return reach;
  }
  const Vector3 grown{ length, length, length };
  const Box around = { casters.Min - grown, casters.Max + grown };
  if (IsAtInfinity(light))
  {
    const double spread = 2.0 * std::sin(0.5 * light.Radius);
    const Vector3 turned{ spread, spread, spread };
    for (const Vector3& way : { light.Normal - turned, light.Normal + turned })
    {
      reach.Add(casters.Min + length * way);
      reach.Add(casters.Max + length * way);
    }
    return Intersection(reach, around);
  }
  Box lamp;
  for (const LightBody& body : LightBodiesOf(light))
  {
    lamp.Add(body.Bounds());
  }
  // The least distance, so that all of the shadow moves by at least the length.
  const Vector3 gap{ std::max({ 0.0, casters.Min.X - lamp.Max.X, lamp.Min.X - casters.Max.X }),
    std::max({ 0.0, casters.Min.Y - lamp.Max.Y, lamp.Min.Y - casters.Max.Y }),
    std::max({ 0.0, casters.Min.Z - lamp.Max.Z, lamp.Min.Z - casters.Max.Z }) };
  const double distance = Length(gap);
  if (!(distance > 0.0))
  {
    return around;
  }
  const double factor = length / distance;
  reach.Add((1.0 + factor) * casters.Min - factor * lamp.Max);
  reach.Add((1.0 + factor) * casters.Max - factor * lamp.Min);
  return Intersection(reach, around);
}

} // namespace shadowcones
