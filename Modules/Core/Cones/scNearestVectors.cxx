// SPDX-License-Identifier: BSD-3-Clause
#include "scNearestVectors.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace shadowcones
{

struct NearestVectors::Tree
{
  pcl::KdTreeFLANN<pcl::PointXYZ> Search;
  pcl::PointCloud<pcl::PointXYZ>::Ptr Cloud{ new pcl::PointCloud<pcl::PointXYZ> };
};

NearestVectors::NearestVectors(const double* points, vtkIdType count)
  : Points(points)
  , NumberAlive(count)
{
  if (count > std::numeric_limits<pcl::index_t>::max())
  {
    throw std::length_error("a search tree holds at most 2^31 - 1 points");
  }
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
  this->Index = std::make_unique<Tree>();
  if (this->NumberAlive == 0)
  {
    return;
  }
  const Vector3 center = this->Bounds.Center();
  const double diagonal = this->Bounds.Diagonal();
  const double scale = diagonal > 0.0 ? 2.0 / diagonal : 1.0;
  this->TreeIds.reserve(static_cast<std::size_t>(this->NumberAlive));
  this->Index->Cloud->reserve(static_cast<std::size_t>(this->NumberAlive));
  for (std::size_t i = 0; i < this->Alive.size(); ++i)
  {
    if (this->Alive[i])
    {
      this->TreeIds.push_back(static_cast<vtkIdType>(i));
      this->Index->Cloud->push_back({ static_cast<float>(scale * (this->Points[3 * i] - center.X)),
        static_cast<float>(scale * (this->Points[3 * i + 1] - center.Y)),
        static_cast<float>(scale * (this->Points[3 * i + 2] - center.Z)) });
    }
  }
  this->Index->Search.setInputCloud(this->Index->Cloud);
}

void NearestVectors::Kill(vtkIdType id)
{
  this->NumberAlive -= this->Alive[id];
  this->Alive[id] = 0;
}

void NearestVectors::Prune()
{
  if (2 * this->NumberAlive < static_cast<vtkIdType>(this->TreeIds.size()))
  {
    this->Build();
  }
}

void NearestVectors::Query(vtkIdType id, int k, std::vector<vtkIdType>& ids) const
{
  thread_local pcl::Indices found;
  thread_local std::vector<float> distances;
  const auto entry = std::lower_bound(this->TreeIds.begin(), this->TreeIds.end(), id) - this->TreeIds.begin();
  const auto size = static_cast<vtkIdType>(this->TreeIds.size());

  // Dead neighbours take places: ask for more until enough of the living are among them.
  for (vtkIdType asked = std::min<vtkIdType>(k, size);; asked = std::min(2 * asked, size))
  {
    this->Index->Search.nearestKSearch(static_cast<pcl::index_t>(entry), static_cast<unsigned int>(asked), found, distances);
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
