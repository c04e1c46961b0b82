// SPDX-License-Identifier: BSD-3-Clause
#include "scPointTree.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace shadowcones
{

struct PointTree::Tree
{
  pcl::KdTreeFLANN<pcl::PointXYZ> Search;
  pcl::PointCloud<pcl::PointXYZ>::Ptr Cloud{ new pcl::PointCloud<pcl::PointXYZ> };
};

namespace
{
// Kept by each thread: a query allocates nothing once they have grown.
thread_local pcl::Indices nearest;
thread_local std::vector<float> distances;

pcl::PointXYZ InFrame(const Vector3& point, const Vector3& center, double scale)
{
  return { static_cast<float>(scale * (point.X - center.X)), static_cast<float>(scale * (point.Y - center.Y)),
    static_cast<float>(scale * (point.Z - center.Z)) };
}
} // anonymous namespace

PointTree::PointTree(const Box& bounds, vtkIdType count, const std::function<Vector3(vtkIdType)>& pointOf)
  : Count(count)
  , Index(std::make_unique<Tree>())
{
  if (count > std::numeric_limits<pcl::index_t>::max())
  {
    throw std::length_error("a search tree holds at most 2^31 - 1 points");
  }
  if (count == 0)
  {
    return;
  }
  const double diagonal = bounds.Diagonal();
  this->Center = bounds.Center();
  this->Scale = diagonal > 0.0 ? 2.0 / diagonal : 1.0;
  this->Index->Cloud->reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Index->Cloud->push_back(InFrame(pointOf(i), this->Center, this->Scale));
  }
  this->Index->Search.setInputCloud(this->Index->Cloud);
}

PointTree::~PointTree() = default;

std::int64_t PointTree::Memory() const
{
  constexpr std::int64_t bytesOfPoint = 48; // of the cloud, of the tree's copy and of its nodes
  return bytesOfPoint * static_cast<std::int64_t>(this->Count);
}

void PointTree::NearestTo(vtkIdType id, int k, std::vector<vtkIdType>& found) const
{
  const auto asked = static_cast<unsigned int>(std::min<vtkIdType>(k, this->Count));
  this->Index->Search.nearestKSearch(static_cast<pcl::index_t>(id), asked, nearest, distances);
  found.assign(nearest.begin(), nearest.end());
}

void PointTree::NearestTo(
  const Vector3& place, int k, std::vector<vtkIdType>& found, std::vector<double>& squared) const
{
  found.clear();
  squared.clear();
  if (this->Count == 0)
  {
    return;
  }
  const auto asked = static_cast<unsigned int>(std::min<vtkIdType>(k, this->Count));
  this->Index->Search.nearestKSearch(InFrame(place, this->Center, this->Scale), asked, nearest, distances);
  found.assign(nearest.begin(), nearest.end());
  const double unit = 1.0 / (this->Scale * this->Scale);
  std::transform(distances.begin(), distances.end(), std::back_inserter(squared),
    [unit](float distance) { return unit * static_cast<double>(distance); });
}

} // namespace shadowcones
