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

#include "scRay.h"
#include "scExtinction.h"
#include "scLightRule.h"
#include "scMediumDepth.h"
#include "scMediumSpan.h"

#include <array>
#include <vector>

namespace shadowcones
{

/**
 * Values of one ray, as floats in a row: 65 edges of the cells, distances from where its part in the medium begins;
 * then for each group of wavelengths 64 means over cells of the light scattered per unit of length, times the squared
 * distance from the light, which makes them smooth from ray to ray.
 */
struct LitProfileLayout
{
  static constexpr int Cells = 64;
  static constexpr int Edges = 72; ///< 65 in use
  int NumberOfGroups = 1;

  std::size_t Size() const { return static_cast<std::size_t>(Edges + this->NumberOfGroups * Cells); }
};

/// How fine a profile is computed.
struct LitLevel
{
  int Panels = 0; ///< 0 .. NumberOfPanelLevels - 1
  int Rule = 0;   ///< 0 .. LightRule::NumberOfLevels - 1
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
  /// The largest extinction where the medium is dense: half of the cells lie close behind a ray's entry then. 0: it is
  /// not.
  double DenseSigmaT = 0.0;
  /// The coarsest that is worth looking at.
  LitLevel FirstLevel() const;
};

/**
 * The change of variable of one ray, in which its cells are even: the angle under which they are seen from the light,
 * or the length for a light far away or at infinity. In a dense medium one half of the cells is even in that and the
 * other in the logarithm of the optical depth behind the entry, where all of the light comes from.
 */
class LitVariable
{
public:
  LitVariable() = default;
  /// @param depth of the ray, which it must outlive: nullptr in a homogeneous medium.
  LitVariable(const LitQuadrature& quadrature, const Ray& ray, const MediumSpan& span, const MediumDepth* depth);

  /// Cells are counted from 0 at the beginning to LitProfileLayout::Cells at the end; inside a gap nothing counts.
  double CellCoordinate(double t) const;
  double DistanceAt(double cellCoordinate) const;
  void FillEdges(double* edges) const;
  /// No cell reaches across this edge.
  bool IsGap(int edge) const { return this->HasGap && edge == LitProfileLayout::Cells / 2; }

  /// What the light at @p t is multiplied by to be even over cells, up to CellFactor(): see LitProfileLayout.
  double Flattened(double t, double cellCoordinate) const;
  /// What a mean of LitProfileLayout is multiplied by to be the integral over its cell.
  double CellFactor() const { return this->Dense ? 1.0 : this->CellWidth / this->Scale; }
  /// Does the ray pass the light so closely that single precision does not tell cells apart there?
  bool NeedsDouble() const { return this->Close; }

private:
  /// Cells in a row that no gap interrupts.
  struct Part
  {
    double Begin = 0.0;
    double End = 0.0;
    int FirstCell = 0;
    int Cells = LitProfileLayout::Cells;
    bool Graded = false; ///< dense: half of the cells at its beginning
    double Width = 0.0;  ///< of a cell in the variable, without grading
    double Logarithm = 0.0; ///< of the grading, over the part
  };
  void SetPart(Part& part, double begin, double end, int firstCell, int cells) const;
  /// Difference of the variable between two distances.
  double Between(double from, double to) const;
  double DepthBetween(double from, double to) const;
  double CoordinateIn(const Part& part, double t) const;
  double DistanceIn(const Part& part, double offset) const;
  const Part& PartOf(double cellCoordinate) const
  {
    return this->HasGap && cellCoordinate > LitProfileLayout::Cells / 2 ? this->Parts[1] : this->Parts[0];
  }
  void FillEven(const Part& part, double* edges) const;

  double Nearest = 0.0; ///< distance along the ray of its point nearest to the light
  double Scale = 1.0;   ///< its distance from the light, or 1 where the variable is a length
  double CellWidth = 0.0; ///< in the variable, as if there were no gap
  bool IsLength = false;
  bool Dense = false;
  bool Close = false;
  bool HasGap = false;
  double SigmaT = 0.0; ///< of the grading
  const MediumDepth* Depth = nullptr;
  std::array<Part, 2> Parts;
};

/// Computes profiles; one a thread.
class LitProfiler
{
public:
  explicit LitProfiler(const LitQuadrature& quadrature);
  /// Light points looked at from all nodes of a ray.
  static int NumberOfEvaluations(const LitQuadrature& quadrature, const LitLevel& level);
  /// @param values LitProfileLayout::Size() floats.
  void Evaluate(const Ray& ray, const MediumSpan& span, const LitLevel& level, float* values);

private:
  void IntegrateDensity(
    const Ray& ray, const LitVariable& variable, const double* edges, const LitLevel& level, float* values);
  /// Add what the light sends by way of the point at @p t to the camera, per unit of length and density, times a
  /// factor.
  void AddNode(const Ray& ray, double t, double factor, const LitLevel& level, double* value);
  void AddSample(const IncidentSample& sample, const Vector3& point, const Vector3& direction, double cameraLeg,
    double factor, double* value);
  void AddLightPoints(const LightRule& rule, const Vector3& point, const Vector3& direction, double cameraLeg,
    double factor, double* value);

  const LitQuadrature& Quadrature;
  MediumDepth Depth;
  std::vector<double> Nodes; ///< integrand at the nodes of one panel, group by group
  std::vector<float> Weights; ///< of light points
  std::vector<float> Cosines;
  std::vector<float> Legs;
  std::vector<IncidentSample> NearSamples;    ///< of a mesh
  std::vector<std::size_t> ReplacedPoints;
};

} // namespace shadowcones

#endif
