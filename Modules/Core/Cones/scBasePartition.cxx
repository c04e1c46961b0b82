// SPDX-License-Identifier: BSD-3-Clause
#include "scBasePartition.h"

#include "scConstants.h"
#include "scFrame.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Planes steeper than this against the mean direction (some 81 degrees) are not projected on.
constexpr double smallestCosine = 0.15;

struct PlanarPoint
{
  vtkIdType Id;
  double Radius;
  double Angle;
  double Height; ///< distance from the plane
};

Vector3 PointOf(const ShadowVectorView& vectors, vtkIdType id)
{
  return { vectors.Points[3 * id], vectors.Points[3 * id + 1], vectors.Points[3 * id + 2] };
}

/// Normal of the least-squares plane through the points' mean; @p fallback where the points span no plane or a steep one.
Vector3 FitNormal(const ShadowVectorView& vectors, const std::vector<vtkIdType>& ids, const Vector3& fallback)
{
  const Vector3 origin = PointOf(vectors, ids[0]);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const vtkIdType id : ids)
  {
    const Vector3 p = PointOf(vectors, id) - origin;
    const Eigen::Vector3d q(p.X, p.Y, p.Z);
    sum += q;
    squares += q * q.transpose();
  }
  const double n = static_cast<double>(ids.size());
  const Eigen::Matrix3d covariance = squares / n - (sum / n) * (sum / n).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& values = solver.eigenvalues();
  if (!(values(1) > 1e-6 * values(2)))
  {
    return fallback;
  }
  const Eigen::Vector3d axis = solver.eigenvectors().col(0);
  const Vector3 normal = Normalized({ axis(0), axis(1), axis(2) });
  const double cosine = Dot(normal, fallback);
  if (std::abs(cosine) < smallestCosine)
  {
    return fallback;
  }
  return cosine < 0.0 ? -normal : normal;
}

/// Variance over mean of the numbers of ring points in the sectors: about 1 where the ring is evenly covered.
double SectorDispersion(const PlanarPoint* ring, int count, std::vector<int>& sectors)
{
  std::fill(sectors.begin(), sectors.end(), 0);
  const int number = static_cast<int>(sectors.size());
  for (int i = 0; i < count; ++i)
  {
    const int sector = static_cast<int>((ring[i].Angle / (2.0 * Pi) + 0.5) * number);
    ++sectors[std::clamp(sector, 0, number - 1)];
  }
  const double mean = static_cast<double>(count) / number;
  double variance = 0.0;
  for (const int c : sectors)
  {
    variance += (c - mean) * (c - mean) / number;
  }
  return variance / mean;
}

double RmsHeight(const PlanarPoint* points, int count)
{
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += points[i].Height * points[i].Height;
  }
  return std::sqrt(sum / count);
}
} // anonymous namespace

Vector3 MeanDirection(const ShadowVectorView& vectors, const std::vector<vtkIdType>& ids)
{
  Vector3 sum;
  for (const vtkIdType id : ids)
  {
    const float* d = vectors.Directions + 3 * id;
    sum += { d[0], d[1], d[2] };
  }
  return Normalized(sum);
}

void PartitionBase(const ShadowVectorView& vectors, const std::vector<vtkIdType>& neighbors,
  const ConeSetOptions& options, BasePartition& base)
{
  base = {};
  const Vector3 mean = MeanDirection(vectors, neighbors);
  if (!(Dot(mean, mean) > 0.5))
  {
    return; // directions that cancel have no mean
  }
  base.Center = PointOf(vectors, neighbors[0]);
  base.Normal = FitNormal(vectors, neighbors, mean);

  thread_local std::vector<PlanarPoint> points;
  points.clear();
  const Frame frame = FrameAround(base.Normal);
  const double cosine = Dot(mean, base.Normal);
  for (std::size_t i = 1; i < neighbors.size(); ++i)
  {
    const Vector3 offset = PointOf(vectors, neighbors[i]) - base.Center;
    const double height = Dot(offset, base.Normal);
    const Vector3 projected = offset - (height / cosine) * mean;
    const double x = Dot(projected, frame.U);
    const double y = Dot(projected, frame.V);
    points.push_back({ neighbors[i], std::sqrt(x * x + y * y), std::atan2(y, x), height });
  }
  std::sort(points.begin(), points.end(),
    [](const PlanarPoint& a, const PlanarPoint& b) { return a.Radius != b.Radius ? a.Radius < b.Radius : a.Id < b.Id; });

  thread_local std::vector<int> sectors;
  sectors.resize(static_cast<std::size_t>(options.NumberOfSectors));
  const int ring = options.PointsPerRing;
  int accepted = 0;
  for (; accepted + ring <= static_cast<int>(points.size()); accepted += ring)
  {
    const PlanarPoint* first = points.data() + accepted;
    const double radius = first[ring - 1].Radius;
    const bool uneven = SectorDispersion(first, ring, sectors) > options.VarianceThreshold;
    const bool curved = options.PlanarityThreshold > 0.0 && RmsHeight(first, ring) > options.PlanarityThreshold * radius;
    if (uneven || curved)
    {
      break;
    }
  }
  if (accepted == 0)
  {
    return;
  }
  base.Radius = points[accepted - 1].Radius;
  base.RmsHeight = RmsHeight(points.data(), accepted);
  base.Members.push_back(neighbors[0]);
  for (int i = 0; i < accepted; ++i)
  {
    base.Members.push_back(points[i].Id);
  }
}

} // namespace shadowcones
