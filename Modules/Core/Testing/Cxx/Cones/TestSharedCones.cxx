// SPDX-License-Identifier: BSD-3-Clause
// Cones fitted by several processes together: the values of one alone, and a share of the work for each.
#include "ThreadTeam.h"
#include "scConeSet.h"
#include "scLightExtent.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// Vectors down from a slab and from a sheet in it, lit with a spread of directions; the paths that left them, and some that are lit.
struct Slab
{
  explicit Slab(int count)
  {
    RandomStream random(12, 0);
    for (int i = 0; i < count; ++i)
    {
      // Not on a plane alone: the places of processes meet all over, and the search tree is built anew meanwhile.
      const double side = i % 3 ? 1.0 : 0.4;
      const Vector3 p{ side * (2.0 * random.Next() - 1.0), side * (2.0 * random.Next() - 1.0), i % 2 ? 0.0 : 0.3 * random.Next() };
      const Vector3 d = Normalized({ 0.2 + 0.2 * random.Next(), 0.2 * random.Next(), -1.0 });
      const Vector3 e = p - 5.0 * d;
      this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
      this->EmissionPoints.insert(this->EmissionPoints.end(), { e.X, e.Y, e.Z });
      this->Directions.insert(
        this->Directions.end(), { static_cast<float>(d.X), static_cast<float>(d.Y), static_cast<float>(d.Z) });
      this->States.push_back(i % 4 ? 1 : 0);
      this->OccluderIds.push_back(p.X > 0.1 ? 2 : 1);
    }
  }
  ShadowVectorView View() const
  {
    return { static_cast<vtkIdType>(this->States.size()), this->Points.data(), this->Directions.data(),
      this->EmissionPoints.data(), this->OccluderIds.data(), nullptr };
  }
  PhotonPathView Paths() const
  {
    return { static_cast<vtkIdType>(this->States.size()), this->Points.data(), this->EmissionPoints.data(),
      this->Directions.data(), this->States.data(), nullptr };
  }

  std::vector<double> Points;
  std::vector<double> EmissionPoints;
  std::vector<float> Directions;
  std::vector<int> OccluderIds;
  std::vector<int> States;
};

ConeSetOptions Small()
{
  ConeSetOptions options;
  options.NumberOfNeighbors = 60;
  options.NumberOfSectors = 8;
  options.PointsPerRing = 6;
  options.MinimumVectorsPerCone = 7;
  return options;
}

void ExpectSame(const ConeSet& a, const ConeSet& b)
{
  EXPECT_EQ(a.ConeIds, b.ConeIds);
  EXPECT_EQ(a.NumberOfDiscarded, b.NumberOfDiscarded);
  ASSERT_EQ(a.Cones.size(), b.Cones.size());
  const auto values = [](const Cone& c)
  {
    return std::vector<double>{ c.Center.X, c.Center.Y, c.Center.Z, c.Axis.X, c.Axis.Y, c.Axis.Z, c.BaseRadius, c.HalfAngle,
      c.InnerHalfAngle, c.Normal.X, c.Normal.Y, c.Normal.Z, c.Planarity, c.Overspill, 1.0 * c.OccluderId,
      1.0 * c.VectorCount, 1.0 * c.LightId };
  };
  for (std::size_t i = 0; i < a.Cones.size(); ++i)
  {
    ASSERT_EQ(values(a.Cones[i]), values(b.Cones[i])) << i;
  }
}
} // anonymous namespace

TEST(SharedCones, AreThoseOfOneProcess)
{
  const Slab vectors(3000);
  const LightExtent light = LightExtentOf(vectors.EmissionPoints.data(), vectors.View().Count);
  for (const bool overlap : { false, true })
  {
    ConeSetOptions options = Small();
    options.Overlap = overlap;
    options.Leftovers = overlap ? ConeLeftovers::Discard : ConeLeftovers::Cover;
    options.MaximumOverspill = overlap ? 1.0 : 0.3;
    ConeSet alone;
    ASSERT_TRUE(FitConeSet(vectors.View(), vectors.Paths(), light, options, {}, alone));
    ASSERT_GT(alone.Cones.size(), 50u);
    for (const int size : { 2, 3, 4 })
    {
      std::vector<vtkIdType> items(static_cast<std::size_t>(size));
      RunAsTeam(size,
        [&](ThreadTeam& team)
        {
          ConeSet set;
          EXPECT_TRUE(FitConeSet(vectors.View(), vectors.Paths(), light, options, {}, set, &team));
          ExpectSame(set, alone);
          items[static_cast<std::size_t>(team.GetRank())] = team.Items;
        });
      vtkIdType all = 0;
      for (const vtkIdType of : items)
      {
        all += of;
      }
      EXPECT_LT(*std::max_element(items.begin(), items.end()), 1.3 * static_cast<double>(all) / size);
    }
  }
}

TEST(SharedCones, EndInAllProcessesWhereOneStops)
{
  const Slab vectors(3000);
  RunAsTeam(2,
    [&](ThreadTeam& team)
    {
      Monitor monitor;
      int asked = 0;
      monitor.Aborted = [&] { return team.GetRank() == 1 && ++asked > 20; };
      ConeSet set;
      EXPECT_FALSE(FitConeSet(vectors.View(), {}, LightExtent(), Small(), monitor, set, &team));
    });
}
