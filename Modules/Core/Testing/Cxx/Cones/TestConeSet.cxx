// SPDX-License-Identifier: BSD-3-Clause
// The covering of section 3.2.1 against a plain one, and rings, sectors, planes and discards on points made by hand.
// One file because every promise is asked of the same points made by hand.
#include "scCone.h"
#include "scConeSet.h"
#include "scFrame.h"
#include "scLightExtent.h"
#include "scPhotonPathView.h"
#include "scRandom.h"
#include "scShadowVectorView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace shadowcones;

namespace
{

constexpr double Pi = 3.14159265358979323846;

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

ConeSet Fit(const Vectors& vectors, const ConeSetOptions& options, const PhotonPathView& paths = {})
{
  const LightExtent light = LightExtentOf(vectors.EmissionPoints.data(), vectors.Count());
  ConeSet result;
  EXPECT_TRUE(FitConeSet(vectors.View(), paths, light, options, {}, result));
  return result;
}

ConeSetOptions Options(int p1, int p2, int p3, int p4)
{
  ConeSetOptions options;
  options.NumberOfNeighbors = p1;
  options.NumberOfSectors = p2;
  options.PointsPerRing = p3;
  options.MinimumVectorsPerCone = p4;
  return options;
}

/// Points of a sunflower: as even as a disc can be covered, nearest to the centre first.
Vectors Sunflower(int count, double radius)
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

/// A random square patch at z = 0, some of it twice as dense, lit from above with a spread of directions.
Vectors RandomPatch(int count)
{
  Vectors vectors;
  RandomStream random(11, 0);
  for (int i = 0; i < count; ++i)
  {
    const double side = i % 3 ? 1.0 : 0.4;
    const Vector3 p{ side * (2.0 * random.Next() - 1.0), side * (2.0 * random.Next() - 1.0), 0.0 };
    vectors.Add(p, { 0.2 + 0.2 * random.Next(), 0.2 * random.Next(), -1.0 }, p.X > 0.1 ? 2 : 1);
  }
  return vectors;
}

/// The covering in its plainest form, for vectors in the plane z = 0 lit from above.
ConeSet PlainCovering(const Vectors& vectors, const ConeSetOptions& options)
{
  const vtkIdType count = vectors.Count();
  std::vector<bool> alive(count, true);
  std::vector<bool> covered(count, false);
  ConeSet set;
  set.ConeIds.assign(count, -1);
  const Frame frame = FrameAround({ 0.0, 0.0, -1.0 });
  for (vtkIdType seed = 0; seed < count; ++seed)
  {
    if (covered[seed])
    {
      continue;
    }
    std::vector<std::pair<double, vtkIdType>> living;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (alive[i])
      {
        living.emplace_back(Length(vectors.Point(i) - vectors.Point(seed)), i);
      }
    }
    std::sort(living.begin(), living.end());
    living.resize(std::min<std::size_t>(living.size(), options.NumberOfNeighbors));
    std::size_t accepted = 1; // the seed
    while (accepted + options.PointsPerRing <= living.size())
    {
      std::vector<int> sectors(options.NumberOfSectors, 0);
      for (int i = 0; i < options.PointsPerRing; ++i)
      {
        const Vector3 offset = vectors.Point(living[accepted + i].second) - vectors.Point(seed);
        const double angle = std::atan2(Dot(offset, frame.V), Dot(offset, frame.U));
        ++sectors[std::min(
          options.NumberOfSectors - 1, static_cast<int>((angle / (2.0 * Pi) + 0.5) * options.NumberOfSectors))];
      }
      const double mean = static_cast<double>(options.PointsPerRing) / options.NumberOfSectors;
      double squares = 0.0;
      for (const int c : sectors)
      {
        squares += (c - mean) * (c - mean);
      }
      if (squares / options.NumberOfSectors / mean > options.VarianceThreshold)
      {
        break;
      }
      accepted += options.PointsPerRing;
    }
    if (accepted == 1 || static_cast<int>(accepted) < options.MinimumVectorsPerCone)
    {
      continue;
    }
    Cone cone;
    cone.Center = vectors.Point(seed);
    cone.BaseRadius = living[accepted - 1].first;
    cone.VectorCount = static_cast<int>(accepted);
    Vector3 sum;
    int ones = 0;
    for (std::size_t i = 0; i < accepted; ++i)
    {
      sum += vectors.Direction(living[i].second);
      ones += vectors.OccluderIds[living[i].second] == 1;
    }
    cone.Axis = Normalized(sum);
    cone.OccluderId = 2 * ones >= static_cast<int>(accepted) ? 1 : 2;
    for (std::size_t i = 0; i < accepted; ++i)
    {
      const vtkIdType id = living[i].second;
      cone.HalfAngle = std::max(cone.HalfAngle, std::acos(std::min(1.0, Dot(vectors.Direction(id), cone.Axis))));
      covered[id] = true;
      alive[id] = options.Overlap;
      if (set.ConeIds[id] < 0)
      {
        set.ConeIds[id] = static_cast<vtkIdType>(set.Cones.size());
      }
    }
    set.Cones.push_back(cone);
  }
  set.NumberOfDiscarded = std::count(set.ConeIds.begin(), set.ConeIds.end(), -1);
  return set;
}

} // namespace

TEST(ConeSetCovering, IsThatOfAPlainLoop)
{
  const Vectors vectors = RandomPatch(3000);
  for (const bool overlap : { false, true })
  {
    for (const ConeSetOptions& base : { Options(100, 20, 16, 20), Options(60, 8, 6, 7), Options(33, 20, 16, 33) })
    {
      ConeSetOptions options = base;
      options.Overlap = overlap;
      options.CosineCorrection = false;
      const ConeSet truth = PlainCovering(vectors, options);
      const ConeSet found = Fit(vectors, options);
      ASSERT_GT(truth.Cones.size(), 5u);
      ASSERT_EQ(found.Cones.size(), truth.Cones.size());
      EXPECT_EQ(found.ConeIds, truth.ConeIds);
      EXPECT_EQ(found.NumberOfDiscarded, truth.NumberOfDiscarded);
      EXPECT_TRUE(overlap || truth.NumberOfDiscarded > 0);
      for (std::size_t i = 0; i < truth.Cones.size(); ++i)
      {
        const Cone& a = found.Cones[i];
        const Cone& b = truth.Cones[i];
        EXPECT_EQ(Length(a.Center - b.Center), 0.0);
        EXPECT_EQ(a.VectorCount, b.VectorCount);
        EXPECT_EQ(a.OccluderId, b.OccluderId);
        EXPECT_NEAR(a.BaseRadius, b.BaseRadius, 1e-12);
        EXPECT_LT(Length(a.Axis - b.Axis), 1e-12);
        EXPECT_NEAR(a.HalfAngle, b.HalfAngle, 1e-6);
        EXPECT_LT(Length(a.Normal - Vector3{ 0.0, 0.0, -1.0 }), 1e-9);
        EXPECT_NEAR(a.Planarity, 0.0, 1e-9);
        EXPECT_EQ(a.Overspill, -1.0);
      }
    }
  }
}

TEST(ConeSetCovering, WithoutOverlapEveryVectorIsInOneConeAtMost)
{
  const Vectors vectors = RandomPatch(3000);
  ConeSetOptions options = Options(100, 20, 16, 20);
  const ConeSet apart = Fit(vectors, options);
  int sum = 0;
  for (const Cone& cone : apart.Cones)
  {
    sum += cone.VectorCount;
  }
  EXPECT_EQ(sum + apart.NumberOfDiscarded, vectors.Count());

  options.Overlap = true;
  const ConeSet overlapping = Fit(vectors, options);
  sum = 0;
  for (const Cone& cone : overlapping.Cones)
  {
    sum += cone.VectorCount;
  }
  EXPECT_GT(sum + overlapping.NumberOfDiscarded, vectors.Count());
  EXPECT_LT(overlapping.NumberOfDiscarded, apart.NumberOfDiscarded);
}

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

TEST(ConeSetDiscards, FewVectorsMakeNoCone)
{
  Vectors vectors = Sunflower(97, 1.0);
  for (int i = 0; i < 10; ++i) // a cluster far away, smaller than p4
  {
    vectors.Add({ 50.0 + 0.1 * i, 0.01 * (i % 3), 0.0 }, { 0.0, 0.0, -1.0 });
  }
  const ConeSet set = Fit(vectors, Options(97, 8, 16, 20));
  ASSERT_EQ(set.Cones.size(), 1u);
  EXPECT_EQ(set.NumberOfDiscarded, 10);
  for (vtkIdType i = 0; i < vectors.Count(); ++i)
  {
    EXPECT_EQ(set.ConeIds[i], i < 97 ? 0 : -1);
  }
  EXPECT_TRUE(Fit(vectors, Options(10, 8, 16, 5)).Cones.empty()); // not even one ring among ten neighbours
}

TEST(ConeSetDiscards, NoVectorsGiveNoCones)
{
  const ConeSet set = Fit({}, ConeSetOptions());
  EXPECT_TRUE(set.Cones.empty());
  EXPECT_TRUE(set.ConeIds.empty());
  EXPECT_EQ(set.NumberOfDiscarded, 0);
}

TEST(ConeSetDiscards, CoincidentAndCollinearVectorsAreHarmless)
{
  Vectors vectors;
  for (int i = 0; i < 200; ++i)
  {
    vectors.Add({ 1.0, 2.0, 3.0 }, { 0.0, 0.0, -1.0 });
  }
  for (int i = 0; i < 200; ++i)
  {
    vectors.Add({ 5.0 + 0.01 * i, 2.0, 3.0 }, { 0.0, 0.0, -1.0 });
  }
  for (int i = 0; i < 200; ++i) // directions without a mean
  {
    vectors.Add({ 9.0 + 0.1 * (i % 15), 0.1 * (i / 15), 3.0 }, { 0.0, 0.0, i % 2 ? 1.0 : -1.0 });
  }
  const ConeSet set = Fit(vectors, ConeSetOptions());
  for (const Cone& cone : set.Cones)
  {
    EXPECT_TRUE(IsFinite(cone.Center) && IsFinite(cone.Axis) && std::isfinite(cone.BaseRadius + cone.HalfAngle));
  }
  for (vtkIdType i = 0; i < 400; ++i)
  {
    EXPECT_EQ(set.ConeIds[i], -1); // neither a point nor a line covers the sectors
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

TEST(ConeSetLeftovers, EveryVectorOfACableGetsACone)
{
  // Along a line the sectors are never even: the paper discards all of it.
  Vectors cable;
  for (int i = 0; i < 100; ++i)
  {
    cable.Add({ 0.1 * i, 0.0, 0.0 }, { 0.0, 0.0, -1.0 });
  }
  cable.Add({ 5.0, 400.0, 0.0 }, { 0.0, 0.0, -1.0 });
  cable.Add({ 5.0, 0.05, 0.0 }, { 0.0, 0.0, -1.0 }, 7);
  ConeSetOptions options = Options(20, 20, 8, 10);
  EXPECT_EQ(Fit(cable, options).NumberOfDiscarded, cable.Count());
  options.Leftovers = ConeLeftovers::Cover;
  const ConeSet set = Fit(cable, options);
  EXPECT_EQ(set.NumberOfDiscarded, 0);
  ASSERT_GE(set.Cones.size(), 12u);
  EXPECT_LE(set.Cones.size(), 24u);
  for (vtkIdType i = 0; i < cable.Count(); ++i)
  {
    ASSERT_GE(set.ConeIds[i], 0) << i;
    const Cone& cone = set.Cones[set.ConeIds[i]];
    const Vector3 offset = cable.Point(i) - cone.Center;
    EXPECT_GE(offset.Z, -1e-12 - 1e-7) << i;
    EXPECT_LE(std::hypot(offset.X, offset.Y), cone.BaseRadius + 1e-9) << i;
    // Ten neighbours on a line reach half a unit to a side, or 0.9 at an end; none reaches across the gap of 400.
    EXPECT_LE(cone.BaseRadius, 0.91) << i;
  }
  EXPECT_EQ(set.Cones[set.ConeIds[100]].BaseRadius, 0.0);
  EXPECT_EQ(set.Cones[set.ConeIds[101]].OccluderId, 7);
}

TEST(ConeSetMonitor, AbortStopsAndProgressGrowsToOne)
{
  const Vectors vectors = RandomPatch(20000);
  std::vector<double> seen;
  Monitor monitor;
  monitor.Progress = [&](double share) { seen.push_back(share); };
  ConeSet set;
  ASSERT_TRUE(FitConeSet(vectors.View(), {}, LightExtent(), ConeSetOptions(), monitor, set));
  EXPECT_GT(seen.size(), 5u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
  seen.clear();
  monitor.Aborted = [&] { return seen.size() >= 2; };
  EXPECT_FALSE(FitConeSet(vectors.View(), {}, LightExtent(), ConeSetOptions(), monitor, set));
  EXPECT_EQ(seen.size(), 2u);
}

TEST(ConeSetOptions, AreCheckedOneByOne)
{
  EXPECT_EQ(CheckConeSetOptions({}), nullptr);
  const auto fault = [](auto change)
  {
    ConeSetOptions options;
    change(options);
    const char* text = CheckConeSetOptions(options);
    return std::string(text ? text : "");
  };
  const double nan = std::nan("");
  EXPECT_NE(fault([](auto& o) { o.NumberOfNeighbors = 2; }).find("NumberOfNeighbors"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfSectors = 0; }).find("NumberOfSectors"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.PointsPerRing = 0; }).find("PointsPerRing"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.MinimumVectorsPerCone = 0; }).find("MinimumVectorsPerCone"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfNeighbors = 19; }).find("p1"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfNeighbors = 536870912; }).find("3..1000000"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfSectors = 2147483647; }).find("1..65536"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.RadiusScale = HUGE_VAL; }).find("finite"), std::string::npos);
  // A ring of 99 fits beside the seed among 100 neighbours, one of 100 does not.
  EXPECT_EQ(fault([](auto& o) { o.PointsPerRing = 99; }), "");
  EXPECT_NE(fault([](auto& o) { o.PointsPerRing = 100; }).find("must be below NumberOfNeighbors"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.PointsPerRing = 2147483647; }).find("must be below"), std::string::npos);
  // One ring of 60 and the seed are 61 vectors; a second ring does not fit.
  const auto sixty = [&](int least)
  { return fault([least](auto& o) { o.PointsPerRing = 60, o.MinimumVectorsPerCone = least; }); };
  EXPECT_EQ(sixty(61), "");
  EXPECT_NE(sixty(62).find("no cone could ever hold enough vectors"), std::string::npos);
  EXPECT_NE(fault([=](auto& o) { o.VarianceThreshold = nan; }).find("VarianceThreshold"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.PlanarityThreshold = -0.1; }).find("PlanarityThreshold"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.ExpansionFraction = 1.1; }).find("ExpansionFraction"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.Leftovers = static_cast<ConeLeftovers>(2); }).find("Leftovers"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.Expansion = static_cast<ConeExpansion>(3); }).find("Expansion"), std::string::npos);
}
