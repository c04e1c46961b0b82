// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConeSetTesting.h
 * @brief Shadow vectors made by hand, and the cones that are fitted to them.
 */
#ifndef ConeSetTesting_h
#define ConeSetTesting_h

#include "scConeSet.h"
#include "scConstants.h"
#include "scLightExtent.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"
#include "scVector3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace conesettesting
{

using namespace shadowcones;

struct Vectors
{
  std::vector<double> Points;
  std::vector<float> Directions;
  std::vector<double> EmissionPoints;
  std::vector<int> OccluderIds;

  void Add(const Vector3& p, const Vector3& direction, int occluder = 0)
  {
    const Vector3 d = Normalized(direction);
    const Vector3 e = p - 5.0 * d;
    this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
    this->Directions.insert(
      this->Directions.end(), { static_cast<float>(d.X), static_cast<float>(d.Y), static_cast<float>(d.Z) });
    this->EmissionPoints.insert(this->EmissionPoints.end(), { e.X, e.Y, e.Z });
    this->OccluderIds.push_back(occluder);
  }
  vtkIdType Count() const { return static_cast<vtkIdType>(this->OccluderIds.size()); }
  ShadowVectorView View() const
  {
    return { this->Count(), this->Points.data(), this->Directions.data(), this->EmissionPoints.data(),
      this->OccluderIds.data() };
  }
  Vector3 Point(vtkIdType i) const { return { this->Points[3 * i], this->Points[3 * i + 1], this->Points[3 * i + 2] }; }
  Vector3 Direction(vtkIdType i) const
  {
    return { this->Directions[3 * i], this->Directions[3 * i + 1], this->Directions[3 * i + 2] };
  }
};

inline ConeSet Fit(const Vectors& vectors, const ConeSetOptions& options, const PhotonPathView& paths = {})
{
  const LightExtent light = LightExtentOf(vectors.EmissionPoints.data(), vectors.Count());
  ConeSet result;
  EXPECT_TRUE(FitConeSet(vectors.View(), paths, light, options, {}, result));
  return result;
}

inline ConeSetOptions Options(int p1, int p2, int p3, int p4)
{
  ConeSetOptions options;
  options.NumberOfNeighbors = p1;
  options.NumberOfSectors = p2;
  options.PointsPerRing = p3;
  options.MinimumVectorsPerCone = p4;
  return options;
}

/// Points of a sunflower: as even as a disc can be covered, nearest to the centre first.
inline Vectors Sunflower(int count, double radius)
{
  Vectors vectors;
  for (int i = 0; i < count; ++i)
  {
    const double r = radius * std::sqrt((i + 0.0) / count);
    const double phi = i * Pi * (3.0 - std::sqrt(5.0));
    vectors.Add({ r * std::cos(phi), r * std::sin(phi), 0.0 }, { 0.0, 0.0, -1.0 });
  }
  return vectors;
}

} // namespace conesettesting

#endif
