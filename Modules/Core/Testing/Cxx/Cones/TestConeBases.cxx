// SPDX-License-Identifier: BSD-3-Clause
// Bases of cones on points made by hand: rings and where they stop, radius, occluder, and what spills over.
#include "ConeSetTesting.h"
#include "scCone.h"
#include "scConeSet.h"
#include "scConstants.h"
#include "scLightExtent.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace conesettesting;

TEST(ConeSetRings, AnEvenDiscIsTakenWhole)
{
  const Vectors vectors = Sunflower(97, 2.0); // the seed and six rings of 16
  const ConeSet set = Fit(vectors, Options(97, 8, 16, 20));
  ASSERT_EQ(set.Cones.size(), 1u);
  EXPECT_EQ(set.Cones[0].VectorCount, 97);
  EXPECT_NEAR(set.Cones[0].BaseRadius, 2.0 * std::sqrt(96.0 / 97.0), 1e-6);
  EXPECT_EQ(set.NumberOfDiscarded, 0);
}

TEST(ConeSetRings, StopAtAnEdge)
{
  // A wide sunflower cut off at x = 0.5: rings around its centre are whole up to there.
  const Vectors all = Sunflower(1000, 2.1);
  Vectors cut;
  for (vtkIdType i = 0; i < all.Count(); ++i)
  {
    if (all.Point(i).X < 0.5)
    {
      cut.Add(all.Point(i), all.Direction(i));
    }
  }
  ConeSetOptions options = Options(600, 20, 32, 20);
  options.CosineCorrection = false;
  // A sunflower is far more even than chance, about 0.3; a ring with the share f of its sectors empty has 1.6 f / (1 - f).
  options.VarianceThreshold = 0.45;
  const Cone first = Fit(cut, options).Cones.at(0);
  EXPECT_EQ(Length(first.Center), 0.0);
  // That is f = 0.22, reached by a circle of radius 0.5 / cos(0.22 pi) = 0.65.
  EXPECT_GT(first.BaseRadius, 0.45);
  EXPECT_LT(first.BaseRadius, 0.75);
  // Without an edge the same rings reach as far as the neighbours do.
  EXPECT_GT(Fit(all, options).Cones.at(0).BaseRadius, 1.3);
}

TEST(ConeSetRings, DispersionIsVarianceOverMean)
{
  // Rings of four around a seed, in four sectors: (counts) -> variance / mean.
  struct Case
  {
    std::vector<double> Degrees;
    double Dispersion;
  };
  const Case cases[] = { { { 45, 135, 225, 315 }, 0.0 }, { { 40, 50, 130, 140 }, 1.0 }, { { 40, 50, 55, 130 }, 1.5 },
    { { 30, 40, 50, 60 }, 3.0 }, { { 45, 50, 135, 225 }, 0.5 } };
  for (const Case& one : cases)
  {
    Vectors vectors;
    vectors.Add({}, { 0.0, 0.0, -1.0 });
    for (std::size_t i = 0; i < 4; ++i) // an even ring first, so that the set spans a plane
    {
      const double phi = (45.0 + 90.0 * static_cast<double>(i)) * Pi / 180.0;
      vectors.Add({ 0.5 * std::cos(phi), 0.5 * std::sin(phi), 0.0 }, { 0.0, 0.0, -1.0 });
    }
    for (const double degrees : one.Degrees)
    {
      const double phi = degrees * Pi / 180.0;
      vectors.Add({ std::cos(phi), std::sin(phi), 0.0 }, { 0.0, 0.0, -1.0 });
    }
    ConeSetOptions options = Options(9, 4, 4, 5);
    for (const double slack : { -0.01, 0.01 })
    {
      options.VarianceThreshold = std::max(0.0, one.Dispersion + slack);
      const ConeSet set = Fit(vectors, options);
      ASSERT_GE(set.Cones.size(), 1u);
      const bool outerRing = slack > 0.0 || one.Dispersion == 0.0;
      EXPECT_EQ(set.Cones[0].VectorCount, outerRing ? 9 : 5) << one.Dispersion;
      EXPECT_NEAR(set.Cones[0].BaseRadius, outerRing ? 1.0 : 0.5, 1e-6);
    }
  }
}

TEST(ConeSetRings, StopWhereTheSurfaceLeavesThePlane)
{
  // A sunflower on a sphere of radius 1: flat at first, curved further out.
  Vectors vectors;
  const Vectors flat = Sunflower(500, 0.95);
  for (vtkIdType i = 0; i < flat.Count(); ++i)
  {
    const Vector3 p = flat.Point(i);
    vectors.Add({ p.X, p.Y, std::sqrt(1.0 - p.X * p.X - p.Y * p.Y) }, { 0.0, 0.0, -1.0 });
  }
  ConeSetOptions options = Options(500, 10, 20, 20);
  options.CosineCorrection = false;
  const auto radius = [&](double threshold)
  {
    options.PlanarityThreshold = threshold;
    return Fit(vectors, options).Cones.at(0).BaseRadius;
  };
  // A cap of in-plane radius r leaves the plane through its top by about r^2 / 2: by r / 8 at a quarter.
  EXPECT_NEAR(radius(0.125), 0.25, 0.05);
  EXPECT_GT(radius(0.25), radius(0.125) + 0.1);
  EXPECT_GT(radius(0.0), 0.9); // no test
  options.PlanarityThreshold = 0.125;
  const Cone cone = Fit(vectors, options).Cones.at(0);
  EXPECT_GT(cone.Planarity, 0.03); // rms of r^2 / 2 over a disc, over r: r / sqrt(12)
  EXPECT_LT(cone.Planarity, 0.09);
}

TEST(ConeSetRadius, IsThatOfTheVectorsProjectedAlongTheLight)
{
  // A disc whose vectors were moved to and fro along slanting light: seen along the light it is the same disc.
  const Vector3 direction = Normalized({ 1.5, 0.0, -1.0 });
  const Vectors flat = Sunflower(97, 1.0);
  Vectors vectors;
  for (vtkIdType i = 0; i < flat.Count(); ++i)
  {
    vectors.Add(flat.Point(i) + (i == 0 ? 0.0 : i % 2 ? 0.05 : -0.05) * direction, direction);
  }
  ConeSetOptions options = Options(97, 8, 16, 20);
  options.CosineCorrection = false;
  EXPECT_NEAR(Fit(vectors, options).Cones.at(0).BaseRadius, std::sqrt(96.0 / 97.0), 0.008);
}

TEST(ConeSetRadius, IsCorrectedByTheCosine)
{
  // A plane tilted by 30 and 60 degrees against the light: in-plane radius r, r cos(theta) across the light.
  for (const double degrees : { 0.0, 30.0, 60.0 })
  {
    const double theta = degrees * Pi / 180.0;
    const Vectors flat = Sunflower(97, 1.0);
    Vectors vectors;
    for (vtkIdType i = 0; i < flat.Count(); ++i)
    {
      const Vector3 p = flat.Point(i);
      vectors.Add({ std::cos(theta) * p.X, p.Y, std::sin(theta) * p.X }, { 0.0, 0.0, -1.0 });
    }
    ConeSetOptions options = Options(97, 8, 16, 20);
    const double inPlane = std::sqrt(96.0 / 97.0);
    const Cone corrected = Fit(vectors, options).Cones.at(0);
    EXPECT_NEAR(corrected.BaseRadius, inPlane * std::cos(theta), 1e-6);
    options.CosineCorrection = false;
    const Cone plain = Fit(vectors, options).Cones.at(0);
    EXPECT_NEAR(plain.BaseRadius, inPlane, 1e-6);
    EXPECT_LT(Length(corrected.Axis - Vector3{ 0.0, 0.0, -1.0 }), 1e-6);
    EXPECT_LT(Length(corrected.Normal - Vector3{ std::sin(theta), 0.0, -std::cos(theta) }), 1e-6);
  }
}

TEST(ConeSetOccluder, IsThatOfMostVectors)
{
  Vectors vectors = Sunflower(97, 1.0);
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    vectors.OccluderIds[i] = i % 5 < 2 ? 3 : i % 5 == 2 ? 9 : -7; // 40 %, 20 %, 40 %
  }
  vectors.OccluderIds[0] = -7;
  vectors.OccluderIds[1] = -7;
  EXPECT_EQ(Fit(vectors, Options(97, 8, 16, 20)).Cones.at(0).OccluderId, -7);
  ShadowVectorView view = vectors.View();
  view.OccluderIds = nullptr;
  ConeSet set;
  ASSERT_TRUE(FitConeSet(view, {}, LightExtent(), Options(97, 8, 16, 20), {}, set));
  EXPECT_EQ(set.Cones.at(0).OccluderId, 0);
}

namespace
{
/// Parallel paths down through a square around the unit disc; those with x < edge end at z = end.
class PathsOverAnEdge
{
public:
  PathsOverAnEdge(double edge, double end)
  {
    for (int i = 0; i < 200; ++i)
    {
      for (int k = 0; k < 200; ++k)
      {
        const double x = -1.5 + 3.0 * (i + 0.5) / 200;
        const double y = -1.5 + 3.0 * (k + 0.5) / 200;
        const bool blocked = x < edge;
        this->Starts.insert(this->Starts.end(), { x, y, 5.0 });
        this->Points.insert(this->Points.end(), { x, y, blocked ? end : -9.0 });
        this->Directions.insert(this->Directions.end(), { 0.0f, 0.0f, -1.0f });
        this->States.push_back(blocked ? 1 : 0);
      }
    }
  }
  PhotonPathView View() const
  {
    return { static_cast<vtkIdType>(this->States.size()), this->Points.data(), this->Starts.data(),
      this->Directions.data(), this->States.data() };
  }

private:
  std::vector<double> Points;
  std::vector<double> Starts;
  std::vector<float> Directions;
  std::vector<int> States;
};
} // anonymous namespace

TEST(ConeSetOverspill, BasesAreTrimmedToTheShareAskedFor)
{
  const Vectors vectors = Sunflower(97, 1.0);
  const PathsOverAnEdge paths(0.4, 0.0);
  const auto trimmed = [&](double maximum)
  {
    ConeSetOptions options = Options(97, 8, 16, 20);
    options.MaximumOverspill = maximum;
    return Fit(vectors, options, paths.View()).Cones.at(0);
  };
  const Cone whole = trimmed(1.0);
  EXPECT_GT(whole.Overspill, 0.2);
  // No lit path is left inside the largest circle that stays behind the edge.
  EXPECT_NEAR(trimmed(0.0).BaseRadius, 0.4, 0.02);
  EXPECT_EQ(trimmed(0.0).Overspill, 0.0);
  const Cone tenth = trimmed(0.1);
  EXPECT_GT(tenth.BaseRadius, 0.4);
  EXPECT_LT(tenth.BaseRadius, whole.BaseRadius);
  EXPECT_NEAR(tenth.Overspill, 0.1, 0.005);
  EXPECT_NEAR(tenth.Planarity * tenth.BaseRadius, whole.Planarity * whole.BaseRadius, 1e-12);
}

TEST(ConeSetOverspill, IsTheShareOfLitPathsThroughTheBase)
{
  const Vectors vectors = Sunflower(97, 1.0);
  const auto overspill = [&](double edge, double end)
  {
    const PathsOverAnEdge paths(edge, end);
    return Fit(vectors, Options(97, 8, 16, 20), paths.View()).Cones.at(0).Overspill;
  };
  EXPECT_NEAR(overspill(0.0, 0.0), 0.5, 0.01); // half of the base spills
  EXPECT_EQ(overspill(9.0, 0.0), 0.0);
  EXPECT_EQ(overspill(-9.0, 0.0), 1.0);
  EXPECT_NEAR(overspill(0.5, 1.0), std::acos(0.5) / Pi - 0.5 * std::sqrt(0.75) / Pi, 0.01); // blocked before the base
  EXPECT_EQ(overspill(9.0, -3.0), 1.0); // blocked by something far behind the base: the base itself lets light through
}
