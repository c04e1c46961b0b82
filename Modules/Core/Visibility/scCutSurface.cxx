// SPDX-License-Identifier: BSD-3-Clause
#include "scCutSurface.h"

#include "scBits.h"

#include <algorithm>
#include <map>
#include <unordered_set>

namespace shadowcones
{
namespace
{
Vector3 AtIndex(const double* values, vtkIdType id)
{
  return { values[3 * id], values[3 * id + 1], values[3 * id + 2] };
}

Vector3 InSinglePrecision(const Vector3& p)
{
  return { static_cast<float>(p.X), static_cast<float>(p.Y), static_cast<float>(p.Z) };
}

/// The longest side of a triangle, the first of several, by the corner where it begins.
int LongestSide(const CutSurface& surface, const CutSurface::Triangle& t)
{
  int longest = 0;
  double most = -1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double length =
      Length(surface.Points[static_cast<std::size_t>(t[(k + 1) % 3])] - surface.Points[static_cast<std::size_t>(t[k])]);
    if (length > most)
    {
      most = length;
      longest = k;
    }
  }
  return longest;
}
} // anonymous namespace

CutSurface::CutSurface(const TriangleMeshView& mesh, const double* normals)
{
  std::map<std::array<std::uint64_t, 6>, vtkIdType> known;
  std::vector<vtkIdType> ids(static_cast<std::size_t>(mesh.NumberOfPoints));
  for (vtkIdType id = 0; id < mesh.NumberOfPoints; ++id)
  {
    const Vector3 p = mesh.Point(id);
    const Vector3 n = normals ? Normalized(AtIndex(normals, id)) : Vector3{};
    const std::array<std::uint64_t, 6> key{ BitsOf(p.X), BitsOf(p.Y), BitsOf(p.Z), BitsOf(n.X), BitsOf(n.Y),
      BitsOf(n.Z) };
    const auto [found, isNew] = known.emplace(key, static_cast<vtkIdType>(this->Points.size()));
    ids[static_cast<std::size_t>(id)] = found->second;
    if (isNew)
    {
      this->Points.push_back(p);
      this->SinglePrecision =
        this->SinglePrecision && IsSinglePrecision(p.X) && IsSinglePrecision(p.Y) && IsSinglePrecision(p.Z);
      if (normals)
      {
        this->Normals.push_back(n);
      }
    }
  }
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    const vtkIdType* corners = mesh.Triangles + 3 * t;
    const Triangle triangle{ ids[static_cast<std::size_t>(corners[0])], ids[static_cast<std::size_t>(corners[1])],
      ids[static_cast<std::size_t>(corners[2])] };
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      this->Triangles.push_back(triangle);
    }
  }
}

Vector3 CutSurface::On(vtkIdType a, vtkIdType b, double t) const
{
  const Vector3& from = this->Points[static_cast<std::size_t>(a)];
  const Vector3 place = from + t * (this->Points[static_cast<std::size_t>(b)] - from);
  return this->SinglePrecision ? InSinglePrecision(place) : place;
}

Vector3 CutSurface::NormalOn(vtkIdType a, vtkIdType b, double t) const
{
  return this->Normals.empty() ? Vector3{}
                               : Normalized((1.0 - t) * this->Normals[static_cast<std::size_t>(a)] +
                                   t * this->Normals[static_cast<std::size_t>(b)]);
}

vtkIdType CutSurface::MiddleOf(vtkIdType a, vtkIdType b)
{
  const auto [found, isNew] = this->Middles.emplace(KeyOf(a, b), static_cast<vtkIdType>(this->Points.size()));
  if (isNew)
  {
    const Vector3 middle = this->On(std::min(a, b), std::max(a, b), 0.5);
    const Vector3 normal = this->NormalOn(std::min(a, b), std::max(a, b), 0.5);
    this->Points.push_back(middle);
    if (!this->Normals.empty())
    {
      this->Normals.push_back(normal);
    }
  }
  return found->second;
}

/// @param middles of the sides 0-1, 1-2, 2-0; -1: not cut.
void CutSurface::Divide(const Triangle& t, const std::array<vtkIdType, 3>& middles, std::vector<Triangle>& result) const
{
  const auto cuts = std::count_if(middles.begin(), middles.end(), [](vtkIdType id) { return id >= 0; });
  if (cuts == 3)
  {
    for (const Triangle& part : { Triangle{ t[0], middles[0], middles[2] }, Triangle{ t[1], middles[1], middles[0] },
           Triangle{ t[2], middles[2], middles[1] }, Triangle{ middles[0], middles[1], middles[2] } })
    {
      result.push_back(part);
    }
    return;
  }
  if (cuts == 0)
  {
    result.push_back(t);
    return;
  }
  // Cut off the longest side that is cut, then what is left in two triangles of one cut at most.
  int side = LongestSide(*this, t);
  while (middles[static_cast<std::size_t>(side)] < 0)
  {
    side = (side + 1) % 3;
  }
  const auto at = [side](int k) { return static_cast<std::size_t>((side + k) % 3); };
  const vtkIdType middle = middles[at(0)];
  this->Divide({ t[at(0)], middle, t[at(2)] }, { -1, -1, middles[at(2)] }, result);
  this->Divide({ middle, t[at(1)], t[at(2)] }, { -1, middles[at(1)], -1 }, result);
}

/// One round. @return false where no side was cut.
template <typename Chooser>
bool CutSurface::Cut(const Chooser& isCut)
{
  this->Middles.clear();
  std::vector<Triangle> result;
  result.reserve(this->Triangles.size());
  for (const Triangle& t : this->Triangles)
  {
    std::array<vtkIdType, 3> middles{ -1, -1, -1 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (isCut(t[k], t[(k + 1) % 3]))
      {
        middles[k] = this->MiddleOf(t[k], t[(k + 1) % 3]);
      }
    }
    this->Divide(t, middles, result);
  }
  this->Triangles.swap(result);
  return !this->Middles.empty();
}

void CutSurface::CutTo(double longest)
{
  const auto isLong = [this, longest](vtkIdType a, vtkIdType b)
  { return Length(this->Points[static_cast<std::size_t>(b)] - this->Points[static_cast<std::size_t>(a)]) > longest; };
  while (this->Cut(isLong))
  {
  }
}

void CutSurface::CutMarked(const std::vector<unsigned char>& marked)
{
  std::unordered_set<std::uint64_t> sides;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (std::size_t k = 0; marked[t] && k < 3; ++k)
    {
      sides.insert(KeyOf(this->Triangles[t][k], this->Triangles[t][(k + 1) % 3]));
    }
  }
  this->Cut([&sides](vtkIdType a, vtkIdType b) { return sides.count(KeyOf(a, b)) > 0; });
}

} // namespace shadowcones
