// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowFootprint.h"

#include "scCutSurface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace shadowcones
{
namespace
{
constexpr int halvings = 12; // of a side: to a four thousandth
constexpr int lit = static_cast<int>(ShadowClass::Lit);
constexpr int penumbra = static_cast<int>(ShadowClass::Penumbra);
constexpr int umbra = static_cast<int>(ShadowClass::Umbra);

/// What an occluder does to a place; places have none of those that do nothing, in ascending order of ids.
struct Label
{
  int OccluderId;
  int Class;
  bool operator==(const Label& b) const { return this->OccluderId == b.OccluderId && this->Class == b.Class; }
};
using Labels = std::vector<Label>;

int ClassOf(const Labels& labels, int occluder)
{
  const auto found =
    std::find_if(labels.begin(), labels.end(), [occluder](const Label& label) { return label.OccluderId == occluder; });
  return found == labels.end() ? lit : found->Class;
}

/// The steps of FindShadowFootprints.
class Finder
{
public:
  Finder(const VisibilityProbe& probe, const FootprintSurface& surface, const FootprintOptions& options,
    ShadowFootprints& footprints)
    : Probe(probe)
    , Options(options)
    , Hard(probe.NumberOfSamples() == 1)
    , Surface(surface.Triangles, surface.Normals)
    , Result(footprints)
  {
    footprints = {};
  }

  bool Find(const Monitor& monitor);

private:
  /// Where an edge of a shadow passes a side, from the end that has less of it.
  struct Crossing
  {
    vtkIdType Outside;
    vtkIdType Inside;
    int OccluderId;
    int Class;
    double Share = 0.5; ///< of the way from Outside to Inside
  };
  /// A piece of an outline between two nodes: crossings from 0 on, or -1 - v for the corner v.
  using Piece = std::pair<vtkIdType, vtkIdType>;

  Labels LabelsAt(const Vector3& point, const Vector3& normal) const;
  bool AskCorners(const Monitor& monitor);
  bool IsMixed(const CutSurface::Triangle& t) const;
  void AddTriangle(const CutSurface::Triangle& t);
  void AddOccluder(const CutSurface::Triangle& t, int occluder);
  void AddPieces(const CutSurface::Triangle& t, int occluder, int kind);
  vtkIdType CrossingOn(vtkIdType a, vtkIdType b, int occluder, int kind);
  int KindAt(vtkIdType corner, int occluder) const
  {
    return ClassOf(this->AllLabels[static_cast<std::size_t>(corner)], occluder);
  }
  void FindBorders();
  bool IsBorder(vtkIdType a, vtkIdType b) const { return this->Uses.at(CutSurface::KeyOf(a, b)) == 1; }
  bool FindCrossings(const Monitor& monitor);
  void PlacePoints();
  void ChainPieces();
  vtkIdType PointOf(vtkIdType node);

  const VisibilityProbe& Probe;
  const FootprintOptions& Options;
  const bool Hard; ///< no penumbra
  CutSurface Surface;
  ShadowFootprints& Result;
  std::vector<Labels> AllLabels;               ///< of the surface's corners
  std::unordered_map<std::uint64_t, int> Uses; ///< of its sides
  std::vector<Crossing> Crossings;
  std::map<std::pair<int, int>, std::unordered_map<std::uint64_t, vtkIdType>>
    CrossingIds;                                            ///< by occluder and class, and side
  std::map<std::pair<int, int>, std::vector<Piece>> Pieces; ///< by occluder and class
  std::unordered_map<vtkIdType, vtkIdType> PointIds;        ///< of nodes
};

Labels Finder::LabelsAt(const Vector3& point, const Vector3& normal) const
{
  thread_local std::vector<HiddenSamples> hidden;
  int together = 0;
  const bool hasNormal = Dot(normal, normal) > 0.0;
  const int shining = this->Probe.ShadowsAt(point, hasNormal ? &normal : nullptr, hidden, together);
  Labels labels;
  if (shining > 0 && !this->Options.PerOccluder && together > 0)
  {
    labels.push_back({ -1, together == shining ? umbra : penumbra });
  }
  for (std::size_t k = 0; shining > 0 && this->Options.PerOccluder && k < hidden.size(); ++k)
  {
    labels.push_back({ hidden[k].OccluderId, hidden[k].Count == shining ? umbra : penumbra });
  }
  return labels;
}

/// Ask the corners that were not asked yet.
bool Finder::AskCorners(const Monitor& monitor)
{
  const auto first = static_cast<vtkIdType>(this->AllLabels.size());
  this->AllLabels.resize(this->Surface.Points.size());
  return ParallelFor(static_cast<vtkIdType>(this->AllLabels.size()) - first, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto k = static_cast<std::size_t>(first + begin); k < static_cast<std::size_t>(first + end); ++k)
      {
        this->AllLabels[k] =
          this->LabelsAt(this->Surface.Points[k], this->Surface.Normals.empty() ? Vector3{} : this->Surface.Normals[k]);
      }
    });
}

bool Finder::IsMixed(const CutSurface::Triangle& t) const
{
  const Labels& first = this->AllLabels[static_cast<std::size_t>(t[0])];
  return !(this->AllLabels[static_cast<std::size_t>(t[1])] == first &&
    this->AllLabels[static_cast<std::size_t>(t[2])] == first);
}

void Finder::FindBorders()
{
  for (const CutSurface::Triangle& t : this->Surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++this->Uses[CutSurface::KeyOf(t[k], t[(k + 1) % 3])];
    }
  }
}

vtkIdType Finder::CrossingOn(vtkIdType a, vtkIdType b, int occluder, int kind)
{
  const auto [found, isNew] = this->CrossingIds[{ occluder, kind }].emplace(
    CutSurface::KeyOf(a, b), static_cast<vtkIdType>(this->Crossings.size()));
  if (isNew)
  {
    const bool aInside = this->KindAt(a, occluder) >= kind;
    this->Crossings.push_back({ aInside ? b : a, aInside ? a : b, occluder, kind });
  }
  return found->second;
}

/// The outline's piece inside a triangle, the shadow on its left, and those along the surface's border.
void Finder::AddPieces(const CutSurface::Triangle& t, int occluder, int kind)
{
  vtkIdType leaves = 0;
  vtkIdType enters = 0;
  bool crosses = false;
  std::vector<Piece>& pieces = this->Pieces[{ occluder, kind }];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const vtkIdType a = t[k];
    const vtkIdType b = t[(k + 1) % 3];
    const bool aInside = this->KindAt(a, occluder) >= kind;
    const bool bInside = this->KindAt(b, occluder) >= kind;
    vtkIdType crossing = 0;
    if (aInside != bInside)
    {
      crosses = true;
      crossing = this->CrossingOn(a, b, occluder, kind);
      (aInside ? leaves : enters) = crossing;
    }
    if ((aInside || bInside) && this->IsBorder(a, b))
    {
      pieces.emplace_back(aInside ? -1 - a : crossing, bInside ? -1 - b : crossing);
    }
  }
  if (crosses)
  {
    pieces.emplace_back(leaves, enters);
  }
}

/// The areas of penumbra and umbra of one occluder in a triangle: its corners and crossings in their order around it.
void Finder::AddOccluder(const CutSurface::Triangle& t, int occluder)
{
  FootprintPolygon areas[2];
  areas[0] = { occluder, ShadowClass::Penumbra, {} };
  areas[1] = { occluder, ShadowClass::Umbra, {} };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const vtkIdType a = t[k];
    const vtkIdType b = t[(k + 1) % 3];
    const int from = this->KindAt(a, occluder);
    const int to = this->KindAt(b, occluder);
    if (from >= penumbra)
    {
      areas[from - penumbra].Points.push_back(-1 - a);
    }
    const auto cross = [&](int kind)
    {
      if ((from >= kind) != (to >= kind) && !(this->Hard && kind == penumbra))
      {
        const vtkIdType node = this->CrossingOn(a, b, occluder, kind);
        areas[0].Points.push_back(node);
        if (kind == umbra)
        {
          areas[1].Points.push_back(node);
        }
      }
    };
    cross(from < to ? penumbra : umbra);
    cross(from < to ? umbra : penumbra);
  }
  for (int k = this->Hard ? 1 : 0; k < 2; ++k)
  {
    if (areas[k].Points.size() >= 3)
    {
      this->Result.Polygons.push_back(areas[k]);
    }
  }
}

void Finder::AddTriangle(const CutSurface::Triangle& t)
{
  std::vector<int> occluders;
  for (const vtkIdType corner : t)
  {
    for (const Label& label : this->AllLabels[static_cast<std::size_t>(corner)])
    {
      occluders.push_back(label.OccluderId);
    }
  }
  std::sort(occluders.begin(), occluders.end());
  occluders.erase(std::unique(occluders.begin(), occluders.end()), occluders.end());
  for (const int occluder : occluders)
  {
    for (int kind = this->Hard ? umbra : penumbra; kind <= umbra; ++kind)
    {
      this->AddPieces(t, occluder, kind);
    }
    this->AddOccluder(t, occluder);
  }
}

bool Finder::FindCrossings(const Monitor& monitor)
{
  return ParallelFor(static_cast<vtkIdType>(this->Crossings.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      {
        Crossing& c = this->Crossings[k];
        double outside = 0.0;
        double inside = 1.0;
        for (int step = 0; step < halvings; ++step)
        {
          const double middle = 0.5 * (outside + inside);
          const Labels labels = this->LabelsAt(
            this->Surface.On(c.Outside, c.Inside, middle), this->Surface.NormalOn(c.Outside, c.Inside, middle));
          (ClassOf(labels, c.OccluderId) >= c.Class ? inside : outside) = middle;
        }
        c.Share = 0.5 * (outside + inside);
      }
    });
}

/// The point of a node, new where it has none yet.
vtkIdType Finder::PointOf(vtkIdType node)
{
  const auto [found, isNew] = this->PointIds.emplace(node, static_cast<vtkIdType>(this->Result.Points.size() / 3));
  if (isNew)
  {
    Vector3 p;
    if (node < 0)
    {
      p = this->Surface.Points[static_cast<std::size_t>(-1 - node)];
    }
    else
    {
      const Crossing& c = this->Crossings[static_cast<std::size_t>(node)];
      const Vector3& from = this->Surface.Points[static_cast<std::size_t>(c.Outside)];
      p = from + c.Share * (this->Surface.Points[static_cast<std::size_t>(c.Inside)] - from);
    }
    this->Result.Points.insert(this->Result.Points.end(), { p.X, p.Y, p.Z });
  }
  return found->second;
}

void Finder::PlacePoints()
{
  // Umbra does not begin before the shadow does, whatever the samples say along one side.
  for (const auto& [key, inner] : this->CrossingIds)
  {
    const auto outer = this->CrossingIds.find({ key.first, penumbra });
    if (key.second != umbra || outer == this->CrossingIds.end())
    {
      continue;
    }
    for (const auto& [side, id] : inner)
    {
      const auto begin = outer->second.find(side);
      if (begin != outer->second.end())
      {
        double& share = this->Crossings[static_cast<std::size_t>(id)].Share;
        share = std::max(share, this->Crossings[static_cast<std::size_t>(begin->second)].Share);
      }
    }
  }
  for (FootprintPolygon& polygon : this->Result.Polygons)
  {
    for (vtkIdType& point : polygon.Points)
    {
      point = this->PointOf(point);
    }
  }
}

/// Join pieces end to end: those that begin where none ends first, then closed ones.
void Finder::ChainPieces()
{
  for (const auto& group : this->Pieces)
  {
    // By their names: not every compiler takes those of a structured binding into a function.
    const auto& key = group.first;
    const auto& pieces = group.second;
    std::unordered_multimap<vtkIdType, std::size_t> from;
    std::unordered_map<vtkIdType, int> ends;
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      from.emplace(pieces[k].first, k);
      ++ends[pieces[k].second];
    }
    std::vector<bool> used(pieces.size(), false);
    const auto chain = [&](std::size_t first)
    {
      FootprintOutline outline;
      outline.OccluderId = key.first;
      outline.Class = static_cast<ShadowClass>(key.second);
      outline.Points.push_back(this->PointOf(pieces[first].first));
      std::size_t piece = first;
      while (piece < pieces.size())
      {
        used[piece] = true;
        const vtkIdType end = pieces[piece].second;
        outline.Closed = end == pieces[first].first;
        if (outline.Closed)
        {
          break;
        }
        outline.Points.push_back(this->PointOf(end));
        // The first of those that begin here, so that the order of a hash does not matter.
        piece = pieces.size();
        const auto range = from.equal_range(end);
        for (auto next = range.first; next != range.second; ++next)
        {
          piece = used[next->second] ? piece : std::min(piece, next->second);
        }
      }
      this->Result.Outlines.push_back(std::move(outline));
    };
    for (const bool open : { true, false })
    {
      for (std::size_t k = 0; k < pieces.size(); ++k)
      {
        if (!used[k] && (!open || ends.count(pieces[k].first) == 0))
        {
          chain(k);
        }
      }
    }
  }
}

bool Finder::Find(const Monitor& monitor)
{
  this->Surface.CutTo(this->Options.Spacing);
  const double ask = 0.5 / (this->Options.Refinements + 1.0);
  for (int round = 0; round <= this->Options.Refinements; ++round)
  {
    if (!this->AskCorners(monitor.Part(round * ask, (round + 1) * ask)))
    {
      return false;
    }
    if (round < this->Options.Refinements)
    {
      std::vector<unsigned char> mixed;
      for (const CutSurface::Triangle& t : this->Surface.Triangles)
      {
        mixed.push_back(this->IsMixed(t) ? 1 : 0);
      }
      this->Surface.CutMarked(mixed);
    }
  }
  this->FindBorders();
  for (const CutSurface::Triangle& t : this->Surface.Triangles)
  {
    this->AddTriangle(t);
  }
  if (!this->FindCrossings(monitor.Part(0.5, 1.0)))
  {
    return false;
  }
  this->PlacePoints();
  this->ChainPieces();
  this->Result.NumberOfPlaces = static_cast<vtkIdType>(this->Surface.Points.size());
  return true;
}
} // anonymous namespace

double CountFootprintTriangles(const TriangleMeshView& surface, double spacing)
{
  double area = 0.0;
  for (vtkIdType t = 0; t < surface.NumberOfTriangles; ++t)
  {
    const Vector3 a = surface.Corner(t, 0);
    area += 0.5 * Length(Cross(surface.Corner(t, 1) - a, surface.Corner(t, 2) - a));
  }
  // Halved sides leave triangles of a quarter of the largest area, on the average.
  return static_cast<double>(surface.NumberOfTriangles) + 4.0 * area / (spacing * spacing);
}

bool FindShadowFootprints(const VisibilityProbe& probe, const FootprintSurface& surface,
  const FootprintOptions& options, const Monitor& monitor, ShadowFootprints& footprints)
{
  return Finder(probe, surface, options, footprints).Find(monitor);
}

} // namespace shadowcones
