// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitProfiler.h
 * @brief Computes the unshadowed medium term along camera rays. Internal to Core.
 */
#ifndef scLitProfiler_h
#define scLitProfiler_h

#include "scLightLegs.h"
#include "scLightRule.h"
#include "scLightSampling.h"
#include "scLitInterval.h"
#include "scLitQuadrature.h"
#include "scLitVariable.h"
#include "scMediumOpticalDepth.h"
#include "scRay.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Computes profiles; one a thread.
class LitProfiler
{
public:
  explicit LitProfiler(const LitQuadrature& quadrature);
  /// Light points looked at from all nodes of a ray.
  static int NumberOfEvaluations(const LitQuadrature& quadrature, const LitLevel& level);
  /// @param values LitProfileLayout::Size() floats.
  void Evaluate(const Ray& ray, const LitInterval& interval, const LitLevel& level, float* values);

private:
  void IntegrateDensity(
    const Ray& ray, const LitVariable& variable, const double* edges, const LitLevel& level, float* values);
  /// Look at the light from the nodes of all panels, through the density: what lies between them is read from these, but
  /// in panels in which it is rough.
  void TabulateLight(const Ray& ray, const LitVariable& variable, const LitLevel& level);
  void FindRoughPanels();
  /// Add what the light sends to a place, whose cell coordinate is given, times a factor, with the camera's leg.
  void AddPlace(const Ray& ray, double t, double coordinate, double factor, const LitLevel& level, double* value);
  /// The same from the table: @p x of a panel.
  void AddFromTable(const Ray& ray, double t, int panel, double x, double factor, double* value) const;
  /// What the table holds is multiplied by this to be smooth along the ray: the squared distance from the light.
  double Evened(const Vector3& point) const;
  double DepthTowards(const Vector3& point, const IncidentSample& sample) const;
  /// Add what the light sends by way of the point at @p t to the camera, per unit of length and density, times a
  /// factor.
  void AddNode(const Ray& ray, double t, double cameraLeg, double factor, const LitLevel& level, double* value);
  void AddSample(const IncidentSample& sample, const Vector3& point, const Vector3& direction, double cameraLeg,
    double factor, double* value);
  void AddLightPoints(int level, const Vector3& point, const Vector3& direction, double cameraLeg,
    double factor, double* value);

  const LitQuadrature& Quadrature;
  MediumOpticalDepth OpticalDepth;
  LightLegs::Place Place;     ///< of the node at hand, where there is a table of means towards the light
  std::vector<double> Nodes;  ///< integrand at the nodes of one panel, group by group
  std::vector<double> Table;  ///< in a varying density: what the light sends to the nodes of all panels
  int TablePanels = 0;        ///< 0: there is none
  std::vector<char> RoughPanels; ///< of the table: 1 where polynomials do not follow it
  std::vector<float> Weights; ///< of light points
  std::vector<float> Cosines;
  std::vector<float> Legs;
  std::vector<IncidentSample> NearSamples; ///< of a mesh
  std::vector<std::size_t> ReplacedPoints;
};

} // namespace shadowcones

#endif
