// SPDX-License-Identifier: BSD-3-Clause
#include "scNearestVectors.h"

#include <algorithm>

namespace shadowcones
{

NearestVectors::NearestVectors(const double* points, vtkIdType count)
  : Points(points)
  , NumberAlive(count)
{
  this->Alive.assign(static_cast<std::size_t>(count), 1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Bounds.Add(Vector3{ points[3 * i], points[3 * i + 1], points[3 * i + 2] });
  }
  this->Build();
}

NearestVectors::~NearestVectors() = default;

void NearestVectors::Build()
{
  this->TreeIds.clear();
  this->TreeIds.reserve(static_cast<std::size_t>(this->NumberAlive));
  for (std::size_t i = 0; i < this->Alive.size(); ++i)
  {
    if (this->Alive[i])
    {
      this->TreeIds.push_back(static_cast<vtkIdType>(i));
    }
  }
  this->Tree = std::make_unique<PointTree>(this->Bounds, static_cast<vtkIdType>(this->TreeIds.size()),
    [this](vtkIdType entry)
    {
      const double* point = this->Points + 3 * this->TreeIds[static_cast<std::size_t>(entry)];
      return Vector3{ point[0], point[1], point[2] };
    });
}

void NearestVectors::Kill(vtkIdType id)
{
  this->NumberAlive -= this->Alive[id];
  this->Alive[id] = 0;
}

void NearestVectors::Revive(vtkIdType id)
{
  this->NumberAlive += 1 - this->Alive[id];
  this->Alive[id] = 1;
}

bool NearestVectors::Prune()
{
  if (2 * this->NumberAlive < static_cast<vtkIdType>(this->TreeIds.size()))
  {
    this->Build();
    return true;
  }
  return false;
}

void NearestVectors::Query(vtkIdType id, int k, std::vector<vtkIdType>& ids) const
{
  thread_local std::vector<vtkIdType> found;
  const auto entry = std::lower_bound(this->TreeIds.begin(), this->TreeIds.end(), id) - this->TreeIds.begin();
  const auto size = static_cast<vtkIdType>(this->TreeIds.size());

  // Dead neighbours take places: ask for more until enough of the living are among them.
  for (vtkIdType asked = std::min<vtkIdType>(k, size);; asked = std::min(2 * asked, size))
  {
    this->Tree->NearestTo(entry, static_cast<int>(asked), found);
    ids.clear();
    for (std::size_t i = 0; i < found.size() && static_cast<int>(ids.size()) < k; ++i)
    {
      const vtkIdType point = this->TreeIds[found[i]];
      if (this->Alive[point])
      {
        ids.push_back(point);
      }
    }
    if (static_cast<int>(ids.size()) == k || asked == size)
    {
      return;
    }
  }
}

} // namespace shadowcones
