// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitVariable.h
 * @brief The change of variable along one camera ray in which its cells are even. Internal to Core.
 */
#ifndef scLitVariable_h
#define scLitVariable_h

#include "scLitInterval.h"
#include "scLitProfileLayout.h"
#include "scLitQuadrature.h"
#include "scMediumOpticalDepth.h"
#include "scRay.h"
#include "scRayInterval.h"

#include <array>

namespace shadowcones
{

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
  LitVariable(
    const LitQuadrature& quadrature, const Ray& ray, const LitInterval& interval, const MediumOpticalDepth* depth);

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
  struct Part : RayInterval
  {
    int FirstCell = 0;
    int Cells = LitProfileLayout::Cells;
    bool Graded = false;    ///< dense: half of the cells at its beginning
    double Width = 0.0;     ///< of a cell in the variable, without grading
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

  double Nearest = 0.0;   ///< distance along the ray of its point nearest to the light
  double Scale = 1.0;     ///< its distance from the light, or 1 where the variable is a length
  double CellWidth = 0.0; ///< in the variable, as if there were no gap
  bool IsLength = false;
  bool Dense = false;
  bool Close = false;
  bool HasGap = false;
  double SigmaT = 0.0; ///< of the grading
  const MediumOpticalDepth* OpticalDepth = nullptr;
  std::array<Part, 2> Parts;
};

} // namespace shadowcones

#endif
