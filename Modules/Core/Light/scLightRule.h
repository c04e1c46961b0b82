// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightRule.h
 * @brief Deterministic quadrature over the light as a point sees it, for light that nothing blocks. Internal to Core.
 */
#ifndef scLightRule_h
#define scLightRule_h

#include "scBox.h"
#include "scLight.h"
#include "scLightSampler.h"
#include "scLightSampling.h"
#include "scLitKernel.h"
#include "scMeshLightRule.h"
#include "scSphericalEllipse.h"
#include "scSphericalRectangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace shadowcones
{

/**
 * Discs: Gauss rings in r^2 by even spokes; rectangles: products of Gauss rules; both over their area, and over their
 * solid angle where the point is near. Spheres and Suns: rings of their cone. Meshes: see scMeshLightRule.h; their
 * vertices one by one. Built once, used from any number of threads; the light must outlive it.
 */
class LightRule
{
public:
  static constexpr int NumberOfLevels = 5;
  /// @param level 0..4: 16 points of a disc or rectangle, then 36, 100, 256 and 1,024. No two are the same rule.
  LightRule(const Light& light, int level);
  LightRule(Light&& light, int level) = delete; // the light has to outlive its rule

  int Count() const { return static_cast<int>(std::max(this->Nodes.size(), this->Points.size())); }

  /// By points on the light's faces: always for meshes, for discs and rectangles that are far enough away.
  bool IsByArea(const Vector3& from) const
  {
    if (!this->HasNear)
    {
      return !this->Points.empty();
    }
    // At least so far above its plane or beside the circle around it.
    const Vector3 offset = from - this->Lamp.Center;
    const double height = Dot(offset, this->Lamp.Normal);
    return std::fabs(height) > this->Near || Dot(offset, offset) > height * height + this->BesideSquared;
  }
  /// Levels to add to this rule at a point: the nearer a disc or rectangle, the more of its points are needed.
  int LevelsNearer(const Vector3& from) const
  {
    if (!this->HasNear)
    {
      return 0;
    }
    const Vector3 offset = from - this->Lamp.Center;
    const double squared = Dot(offset, offset) / (this->Radius * this->Radius);
    // By solid angle cosines, attenuation and scattering vary over the light, and fewer points do again.
    return squared > 4.0 ? 0 : (squared > 1.0 || !this->IsByArea(from) ? 1 : 2);
  }
  /// The points of the rule by area; none for other lights.
  LightPoints AreaPoints() const
  {
    const std::size_t count = this->Points.size();
    const float* x = this->Offsets.data();
    return { x, x + count, x + 2 * count, x + 3 * count, x + 4 * count, x + 5 * count, x + 6 * count,
      static_cast<int>(count) };
  }
  /**
   * Add the parts of a mesh that are too near for its points by area, and list which points they stand for, as pairs of
   * the first one and the one behind the last; none for other lights. Both lists are overwritten.
   */
  void FindNear(const Vector3& from, std::vector<IncidentSample>& samples, std::vector<std::size_t>& replaced) const
  {
    samples.clear();
    replaced.clear();
    if (!this->Mesh || !this->Mesh->MayBeNear(from))
    {
      return;
    }
    for (const MeshLightRule::Patch& patch : this->Mesh->Patches())
    {
      if (this->Mesh->IsNear(patch, from))
      {
        this->Mesh->LookAt(patch, from, samples);
        replaced.insert(replaced.end(), { patch.FirstPoint, patch.EndOfPoints });
      }
    }
  }
  /// The rule by area as seen from a point in a box; @p direction of a ray through it, or a surface's normal.
  LightPointsView ViewFrom(const Vector3& point, const Vector3& direction, const Box& bounds) const
  {
    LightPointsView view;
    for (int axis = 0; axis < 3; ++axis)
    {
      view.Center[axis] = static_cast<float>(this->Middle[axis] - point[axis]);
      view.Direction[axis] = static_cast<float>(direction[axis]);
      view.Low[axis] = static_cast<float>(bounds.Min[axis] - point[axis]);
      view.High[axis] = static_cast<float>(bounds.Max[axis] - point[axis]);
    }
    return view;
  }

  /// Call visit(const IncidentSample&) for every point of the rule; the weights' sum is the light's solid angle.
  template <typename Visitor>
  void ForEach(const Vector3& from, Visitor&& visit) const
  {
    if (!this->Parallel.empty())
    {
      std::for_each(this->Parallel.begin(), this->Parallel.end(), visit);
      return;
    }
    if (this->IsByArea(from))
    {
      thread_local std::vector<IncidentSample> near;
      thread_local std::vector<std::size_t> replaced;
      this->FindNear(from, near, replaced);
      for (const IncidentSample& sample : near)
      {
        visit(sample);
      }
      auto skipped = replaced.begin();
      for (std::size_t k = 0; k < this->Points.size(); ++k)
      {
        if (skipped != replaced.end() && k == *skipped)
        {
          k = *(skipped + 1) - 1;
          skipped += 2;
          continue;
        }
        const LightPoint& lightPoint = this->Points[k];
        const Vector3 to = lightPoint.Position - from;
        const double squared = Dot(to, to);
        const double inverse = 1.0 / std::sqrt(squared);
        const double cosine = -Dot(to, lightPoint.Normal) * inverse;
        if (cosine > 0.0)
        {
          visit(IncidentSample{ inverse * to, squared * inverse, lightPoint.Area * cosine / squared });
        }
      }
      return;
    }
    if (this->Lamp.Shape == LightShape::Disc)
    {
      this->ForEachOfDisc(from, visit);
      return;
    }
    if (this->Lamp.Shape == LightShape::Rectangle)
    {
      this->ForEachOfRectangle(from, visit);
      return;
    }
    LightSampler sampler(this->Lamp, LightSampling::SolidAngle);
    sampler.MoveTo(from);
    for (const Node& node : this->Nodes)
    {
      IncidentSample sample = sampler.Sample(node.U, node.V);
      sample.Weight *= node.Weight;
      if (sample.Weight > 0.0)
      {
        visit(sample);
      }
    }
  }

private:
  /// By solid angle: rings by spokes of the ellipse that a near disc is seen as. Neighbouring rings' spokes take turns.
  template <typename Visitor>
  void ForEachOfDisc(const Vector3& from, Visitor&& visit) const
  {
    const SphericalEllipse ellipse(this->Lamp.Center, this->Lamp.Normal, this->Lamp.Radius, from);
    const double solidAngle = ellipse.SolidAngle();
    if (!(solidAngle > 0.0))
    {
      return;
    }
    const auto rings = static_cast<int>(this->Lines.Nodes.size());
    const int perQuarter = 2 * rings; // of two neighbouring rings
    std::array<SphericalEllipse::Spoke, 2 * LargestNumberOfRings> spokes;
    for (int k = 0; k < perQuarter; ++k)
    {
      spokes[static_cast<std::size_t>(k)] = ellipse.SpokeAt((k + 0.5) / perQuarter);
    }
    for (int ring = 0; ring < rings; ++ring)
    {
      const double weight = solidAngle * this->Lines.Weights[static_cast<std::size_t>(ring)] / (4 * rings);
      for (int spoke = 0; spoke < 4 * rings; ++spoke)
      {
        const int k = 2 * (spoke % rings) + ring % 2;
        const int quarter = spoke / rings;
        const Vector3 direction = ellipse.Along(spokes[static_cast<std::size_t>(quarter % 2 ? perQuarter - 1 - k : k)],
          quarter, this->Lines.Nodes[static_cast<std::size_t>(ring)]);
        const double cosine = -Dot(direction, this->Lamp.Normal);
        visit(IncidentSample{ direction, cosine > 0.0 ? ellipse.Height() / cosine : HUGE_VAL, weight });
      }
    }
  }
  template <typename Visitor>
  void ForEachOfRectangle(const Vector3& from, Visitor&& visit) const
  {
    const Light& light = this->Lamp;
    const SphericalRectangle rectangle(light.Center, light.Normal, light.AxisU, light.AxisV, from);
    const double solidAngle = rectangle.SolidAngle();
    if (!(solidAngle > 0.0))
    {
      return;
    }
    const bool byMap = solidAngle >= SphericalRectangle::MinimumSolidAngle;
    for (std::size_t i = 0; i < this->Lines.Nodes.size(); ++i)
    {
      const auto column = byMap ? rectangle.ColumnAt(this->Lines.Nodes[i]) : SphericalRectangle::Column{};
      for (std::size_t j = 0; j < this->Lines.Nodes.size(); ++j)
      {
        const double weight = this->Lines.Weights[i] * this->Lines.Weights[j];
        const Vector3 to = byMap ? rectangle.Along(column, this->Lines.Nodes[j])
                                 : light.Center - from + (2.0 * this->Lines.Nodes[i] - 1.0) * light.AxisU +
            (2.0 * this->Lines.Nodes[j] - 1.0) * light.AxisV;
        const double distance = Length(to);
        visit(IncidentSample{ (1.0 / distance) * to, distance,
          weight * (byMap ? solidAngle : LightArea(light) * std::fabs(Dot(to, light.Normal)) / std::pow(distance, 3)) });
      }
    }
  }

  static constexpr int LargestNumberOfRings = 16;
  struct Node
  {
    double U;
    double V;
    double Weight; ///< all sum to 1
  };
  void AddDisc(int rings);
  void AddRectangle(int side);
  void AddCone(int rings);
  void AddParallel();
  void AddVertices(std::size_t vertices, int level);
  void AddOffsets();
  void SetNear(double radius);

  const Light& Lamp;
  std::vector<LightPoint> Points; ///< Disc, Rectangle and Mesh, by area
  std::optional<MeshLightRule> Mesh;
  std::vector<float> Offsets; ///< of Points from the centre, their normals and areas, component by component
  std::vector<Node> Nodes;    ///< the others
  std::vector<IncidentSample> Parallel; ///< Sun: the nodes, which are the same from everywhere
  GaussLegendre Lines{ 1 };   ///< of a near disc's rings, or rectangle's lines
  bool HasNear = false;       ///< a disc or rectangle
  Vector3 Middle;             ///< of Points
  double Radius = 1.0;        ///< of the circle around a disc or rectangle
  double Near = 0.0;          ///< nearer than this: by solid angle
  double BesideSquared = 0.0; ///< squared radius of the circle, with a margin
};

} // namespace shadowcones

#endif
