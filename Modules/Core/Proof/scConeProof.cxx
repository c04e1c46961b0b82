// SPDX-License-Identifier: BSD-3-Clause
#include "scConeProof.h"

#include "scBits.h"
#include "scBoundingCone.h"
#include "scCone.h"
#include "scConeClusters.h"
#include "scLightExtent.h"
#include "scOccluderParts.h"
#include "scRandom.h"
#include "scVolumeSample.h"

#include <algorithm>
#include <set>

namespace shadowcones
{
namespace
{
constexpr int addedWithoutGiven = 140;
constexpr int fewestAdded = 16;
/// The box that a cone holds where some part has none, in diagonals of the region to each side.
constexpr double heldMargin = 10.0;

Box Grown(const Box& box, double margin)
{
  return { box.Min - Vector3{ margin, margin, margin }, box.Max + Vector3{ margin, margin, margin } };
}

Box RegionOf(const Box& casters, const ConeProofOptions& options)
{
  return options.Region.Empty() ? Grown(casters, 0.5 * casters.Diagonal()) : options.Region;
}

/// One word for some values, in their order.
class ValueHash
{
public:
  void Add(double value) { this->Word = HashSeed(this->Word, BitsOf(value)); }
  void Add(const Vector3& v)
  {
    this->Add(v.X);
    this->Add(v.Y);
    this->Add(v.Z);
  }

  std::uint64_t Word = 0;
};

std::uint64_t HashOf(const Vector3& v)
{
  ValueHash hash;
  hash.Add(v);
  return hash.Word;
}

/// The same for any order of triangles and of the corners of each.
std::uint64_t HashOfCasters(const TriangleMeshView& mesh)
{
  std::uint64_t sum = 0;
  for (vtkIdType i = 0; i < mesh.NumberOfTriangles; ++i)
  {
    if (mesh.OccluderId(i) >= 0)
    {
      sum += Mix64(HashOf(mesh.Corner(i, 0)) + HashOf(mesh.Corner(i, 1)) + HashOf(mesh.Corner(i, 2)));
    }
  }
  return sum;
}

std::uint64_t HashOfLight(const Light& light)
{
  ValueHash hash;
  hash.Add(static_cast<double>(static_cast<int>(light.Shape)));
  if (light.Shape == LightShape::Mesh)
  {
    for (const auto& triangle : light.Triangles)
    {
      for (const Vector3& corner : triangle)
      {
        hash.Add(corner);
      }
    }
    for (std::size_t i = 0; light.Triangles.empty() && i < light.Vertices.size(); ++i)
    {
      hash.Add(light.Vertices[i]);
    }
    return hash.Word;
  }
  hash.Add(light.Shape == LightShape::Sun ? Vector3{} : light.Center);
  hash.Add(light.Shape == LightShape::Point || light.Shape == LightShape::Sphere ? Vector3{} : light.Normal);
  hash.Add(light.Shape == LightShape::Rectangle ? light.AxisU : Vector3{});
  hash.Add(light.Shape == LightShape::Rectangle ? light.AxisV : Vector3{});
  hash.Add(light.Shape == LightShape::Point || light.Shape == LightShape::Rectangle ? 0.0 : light.Radius);
  return hash.Word;
}

/// What a cone that was grown or added is for the consumers of its other values.
void Describe(const LightExtent& light, Cone& cone)
{
  cone.Normal = cone.Axis;
  double outer = 0.0;
  PenumbraAngles(light, cone.Center, cone.Axis, cone.BaseRadius, outer, cone.InnerHalfAngle);
}
/// Make the proof hold for one light, by the cones of that light alone.
bool ProveLight(const TriangleMeshView& mesh, const Light& light, int id, ClusterOptions options, const Monitor& monitor,
  std::set<int>& withoutCone, ConeProof& proof)
{
  std::vector<Cone> own;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < proof.Cones.size(); ++i)
  {
    if (proof.Cones[i].LightId == id)
    {
      own.push_back(proof.Cones[i]);
      places.push_back(i);
    }
  }
  options.LargestNumber = options.LargestNumber > 0 ? options.LargestNumber
    : own.empty()                                   ? addedWithoutGiven
                                                    : std::max(fewestAdded, static_cast<int>(own.size()));
  const OccluderParts parts(mesh, light, ProofMarginsOf(CasterBounds(mesh)));
  std::vector<OccluderPart> unproved;
  vtkIdType proved = 0;
  ClusterResult clusters;
  if (!parts.FindUnproved(own, monitor.Part(0.0, 0.4), unproved, proved) ||
    !HoldParts(parts, unproved, own, options, monitor.Part(0.4, 1.0), clusters))
  {
    return false;
  }
  const LightExtent extent = LightExtentOf(light);
  for (std::size_t i = 0; i < clusters.Cones.size(); ++i)
  {
    Cone cone = clusters.Cones[i];
    cone.LightId = id;
    if (i >= own.size())
    {
      cone.Origin = ConeOrigin::Added;
      Describe(extent, cone);
      proof.Cones.push_back(cone);
    }
    else if (clusters.Grown[i])
    {
      cone.Origin = ConeOrigin::Grown;
      Describe(extent, cone);
      proof.Cones[places[i]] = cone;
    }
  }
  for (const OccluderPart& part : clusters.WithoutCone)
  {
    withoutCone.insert(mesh.OccluderId(part.Triangle));
  }
  proof.NumberOfProvedParts += proved + static_cast<vtkIdType>(unproved.size() - clusters.WithoutCone.size());
  return true;
}
} // anonymous namespace

Cone StoredCone(const Cone& cone)
{
  Cone result = cone;
  result.Axis = StoredDirection(cone.Axis);
  result.Normal = StoredDirection(cone.Normal);
  result.BaseRadius = RoundToSingle(cone.BaseRadius);
  result.HalfAngle = RoundToSingle(cone.HalfAngle);
  result.InnerHalfAngle = RoundToSingle(cone.InnerHalfAngle);
  result.Planarity = RoundToSingle(cone.Planarity);
  result.Overspill = RoundToSingle(cone.Overspill);
  return result;
}

double VolumeOfCones(
  const TriangleMeshView& mesh, const std::vector<Cone>& cones, const ConeProofOptions& options)
{
  const Box casters = CasterBounds(mesh);
  return casters.Empty() ? 0.0 : VolumeSample(RegionOf(casters, options)).VolumeOf(cones);
}

bool IsTighter(const ConeProof& a, const ConeProof& b)
{
  constexpr double alike = 0.01;
  return std::abs(a.Volume - b.Volume) > alike * std::max(a.Volume, b.Volume) ? a.Volume < b.Volume
                                                                             : a.Cones.size() < b.Cones.size();
}

std::uint64_t CertificateHash(const std::vector<Cone>& cones, const TriangleMeshView& mesh, const std::vector<Light>& lights)
{
  ValueHash hash;
  for (const Cone& cone : cones)
  {
    const Cone stored = StoredCone(cone);
    hash.Add(stored.Center);
    hash.Add(stored.Axis);
    hash.Add(stored.BaseRadius);
    hash.Add(stored.HalfAngle);
    hash.Add(static_cast<double>(stored.LightId));
  }
  std::uint64_t word = HashSeed(hash.Word, HashOfCasters(mesh));
  for (const Light& light : lights)
  {
    word = HashSeed(word, HashOfLight(light));
  }
  return word;
}

bool ProveConeSet(const TriangleMeshView& mesh, const std::vector<Light>& lights, const std::vector<Cone>& given,
  const ConeProofOptions& options, const Monitor& monitor, ConeProof& proof)
{
  proof = {};
  for (const Cone& cone : given)
  {
    proof.Cones.push_back(StoredCone(cone));
    proof.Cones.back().Origin = ConeOrigin::Fitted;
  }
  const Box casters = CasterBounds(mesh);
  if (casters.Empty())
  {
    proof.Certified = true;
    return true;
  }
  ClusterOptions clusters;
  clusters.Region = RegionOf(casters, options);
  clusters.LargestNumber = options.LargestNumberOfAddedCones;
  std::set<int> withoutCone;
  const double fraction = 1.0 / std::max<double>(1.0, static_cast<double>(lights.size()));
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const double begin = static_cast<double>(i) * fraction;
    if (!ProveLight(
          mesh, lights[i], static_cast<int>(i), clusters, monitor.Part(begin, begin + fraction), withoutCone, proof))
    {
      return false;
    }
  }
  proof.NumberOfOccludersWithoutCone = static_cast<vtkIdType>(withoutCone.size());
  if (!withoutCone.empty())
  {
    proof.CertifiedBounds = Grown(clusters.Region, heldMargin * clusters.Region.Diagonal());
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
      proof.Cones.push_back(StoredCone(ConeAroundBox(proof.CertifiedBounds)));
      proof.Cones.back().Origin = ConeOrigin::Added;
      proof.Cones.back().LightId = static_cast<int>(i);
    }
  }
  for (const Cone& cone : proof.Cones)
  {
    proof.NumberOfGrownCones += cone.Origin == ConeOrigin::Grown ? 1 : 0;
    proof.NumberOfAddedCones += cone.Origin == ConeOrigin::Added ? 1 : 0;
  }
  proof.Volume = VolumeSample(clusters.Region).VolumeOf(proof.Cones);
  proof.Certified = true;
  return true;
}

} // namespace shadowcones
