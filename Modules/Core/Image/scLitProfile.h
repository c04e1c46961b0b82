// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitProfile.h
 * @brief The unshadowed medium term along one camera ray, cut into cells. Internal to Core.
 *
 * The ray's part in the medium is cut into 64 cells that are even in the angle under which they are seen from the
 * light, t = t0 + D tan(angle): equi-angular sampling (Kulla and Fajardo, EGSR 2012) turned into quadrature. In that
 * variable the light's 1 / d^2 is flat, and Gauss-Legendre panels integrate it with few nodes.
 */
#ifndef scLitProfile_h
#define scLitProfile_h

#include "scCamera.h"
#include "scExtinction.h"
#include "scLightRule.h"
#include "scMediumDepth.h"
#include "scMediumSpan.h"

#include <array>
#include <vector>

namespace shadowcones
{

/**
 * Values of one ray, as floats in a row: 65 edges of the cells, distances from a reference; then for each group of
 * wavelengths 64 means over cells of the light scattered per unit of length, times the squared distance from the light,
 * which makes them smooth from ray to ray.
 */
struct LitProfileLayout
{
  static constexpr int Cells = 64;
  static constexpr int Edges = 72; ///< 65 in use
  int NumberOfGroups = 1;

  std::size_t Size() const { return static_cast<std::size_t>(Edges + this->NumberOfGroups * Cells); }
};

/// What the profiles of an image share: quadrature rules of the light. The arguments must outlive it.
class LitQuadrature
{
public:
  static constexpr int NumberOfPanelLevels = 7; ///< 1, 2, 4 ... 64 panels of 8 nodes

  LitQuadrature(const Light& light, const Medium& medium, const ExtinctionGroups& groups);

  const Light& Source;
  const Medium& Fog;
  const ExtinctionGroups& Groups;
  LitProfileLayout Layout;
  std::vector<LightRule> Rules; ///< one a level
  MediumSpans Spans;
  Vector3 Center;               ///< of the light
  double Radius = 0.0;          ///< of the sphere around it
  double Extent = 0.0;          ///< diagonal of the medium
};

/// How fine a profile is computed.
struct LitLevel
{
  int Panels = 0; ///< 0 .. NumberOfPanelLevels - 1
  int Rule = 0;   ///< 0 .. LightRule::NumberOfLevels - 1
};

/// The change of variable of one ray. For a light far away or at infinity the variable is a length.
struct LitAngle
{
  LitAngle(const LitQuadrature& quadrature, const Ray& ray, const MediumSpan& span);

  double ToVariable(double t) const
  {
    return this->IsLength ? t : std::atan((t - this->Nearest) / this->Scale);
  }
  double ToDistance(double x) const { return this->IsLength ? x : this->Nearest + this->Scale * std::tan(x); }

  /// What the light at @p t is multiplied by to be even over cells: the squared distance from the light, about.
  double Flattened(double t) const
  {
    return this->IsLength ? 1.0 : this->Scale * this->Scale + (t - this->Nearest) * (t - this->Nearest);
  }

  double Nearest = 0.0; ///< distance along the ray of its point nearest to the light
  double Scale = 1.0;   ///< D, or 1 where the variable is a length
  bool IsLength = false;
  double CellWidth = 0.0; ///< in the variable
  /// What a mean of LitProfileLayout is multiplied by to be the integral over its cell.
  double CellFactor() const { return this->CellWidth / this->Scale; }
};

struct CellVariables;

/// Computes profiles; one a thread.
class LitProfiler
{
public:
  explicit LitProfiler(const LitQuadrature& quadrature);
  /// Light points looked at from all nodes of a ray.
  static int NumberOfEvaluations(const LitQuadrature& quadrature, const LitLevel& level);
  /// @param values LitProfileLayout::Size() floats.
  void Evaluate(const Ray& ray, const MediumSpan& span, double reference, const LitLevel& level, float* values);

private:
  void IntegrateDensity(const Ray& ray, const MediumSpan& span, const LitAngle& angle,
    const CellVariables& variables, double reference, const LitLevel& level, float* values);
  /// Add what the light sends by way of the point at @p t to the camera, per unit of length and density, times a factor.
  void AddNode(const Ray& ray, double t, double factor, const LitLevel& level, double* value);
  void AddLightPoints(const LightRule& rule, const Vector3& point, const Vector3& direction, double cameraLeg,
    double factor, double* value);

  const LitQuadrature& Quadrature;
  MediumDepth Depth;
  std::vector<double> Nodes; ///< integrand at the nodes of one panel, group by group
  std::vector<float> Weights; ///< of light points
  std::vector<float> Cosines;
  std::vector<float> Legs;
};

} // namespace shadowcones

#endif
