// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitTile.h
 * @brief The unshadowed medium term of a square of pixels, from few rays and with a checked error. Internal to Core.
 *
 * The term is smooth over the image but at the edges of the medium and next to the light. Nine rays of a square are
 * computed and the others interpolated quadratically between them; other rays of the square are computed too and must
 * agree, else the rules become finer, or the square is cut in four. Squares of two pixels compute every ray.
 */
#ifndef scLitTile_h
#define scLitTile_h

#include "scCamera.h"
#include "scLitInterval.h"
#include "scLitPixel.h"
#include "scLitProfiler.h"
#include "scLitQuadrature.h"
#include "scRay.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace shadowcones
{

/// One a thread. Squares are aligned to the pixel (0, 0) of the image, so that results do not depend on what is asked for.
class LitTile
{
public:
  static constexpr int Side = 32; ///< pixels

  /**
   * @param tolerance largest error of checked rays, at any distance, over their sum; sums below a tenth of @p typical
   * count as that: see TypicalLitSums.
   */
  LitTile(const LitQuadrature& quadrature, const Camera& camera, int width, int height, double tolerance,
    const std::vector<double>& typical);

  /// Prepare the square whose first pixel is (i0, j0), unless it is the one at hand.
  void MoveTo(int i0, int j0);
  /// The profile of pixel (i, j), counted over the whole image, in the square; parts of a pixel count from its centre.
  void Interpolate(double i, double j, LitPixel& pixel);

  /// Rays computed so far.
  vtkIdType NumberOfRays() const { return this->Rays; }

private:
  /// Nine rays at 0, 1/2 and 1 of a leaf's size, i fastest; one where the size is 1.
  struct Sheet
  {
    int Faces = -1;
    std::size_t Nodes = 0; ///< where their values begin
  };
  struct Leaf
  {
    int I = 0;
    int J = 0;
    int Size = 0;
    LitLevel Level;
    double Tolerance = 0.0;
    double Reference = 0.0;
    std::size_t FirstSheet = 0; ///< one for each pair of faces that its rays pass
    std::size_t EndOfSheets = 0;
  };

  Ray RayOf(double i, double j) const { return this->View.PixelRay(i, j, this->Width, this->Height); }
  LitInterval IntervalOf(double i, double j) const { return this->Quadrature.Intervals.Find(this->RayOf(i, j)); }
  void Cut(int i, int j, int size, LitLevel level, double tolerance);
  bool Affords(const LitLevel& level) const;
  void RaiseLevel(int i0, int j0, int size, LitLevel& level, double& tolerance);
  void RaiseLevelFor(int i, int j, LitLevel& level, double& tolerance);
  bool AddLeaf(int i, int j, int size, const LitLevel& level, double tolerance);
  bool AddSheet(Leaf& leaf, int faces);
  void AddPixel(int i, int j, const LitLevel& level, double tolerance);
  void Register(const Leaf& leaf);
  const Leaf& LeafAt(double i, double j) const;
  void Blend(const Leaf& leaf, const Sheet& sheet, double i, double j, float* values);
  void Evaluate(const Ray& ray, const LitInterval& interval, const LitLevel& level, float* values);
  /// The same of a pixel of the square or at its end, unless that was computed before.
  void EvaluatePixel(int i, int j, const LitInterval& interval, const LitLevel& level, float* values);
  double CellFactor(const Ray& ray, const LitInterval& interval) const;
  double Difference(const float* a, const float* b, double factor) const;

  const LitQuadrature& Quadrature;
  const Camera& View;
  int Width;
  int Height;
  double Tolerance;
  std::vector<double> Smallest; ///< sums of a group below this count as this
  int I0 = 0;
  int J0 = 0;
  LitProfiler Profiler;
  std::vector<Leaf> Leaves;
  std::vector<Sheet> Sheets;
  std::vector<float> Values;
  std::vector<int> LeafOf; ///< a pixel of the square
  std::vector<float> Columns; ///< of the sheet and row that were blended last
  std::size_t BlendedNodes = 0;
  double BlendedRow = -1.0;
  std::array<std::vector<float>, 2> Scratch;
  /// What was computed last of the pixels of the square and at its ends.
  struct Computed
  {
    int Faces = -1;
    LitLevel Level;
  };
  std::vector<Computed> ComputedPixels;
  std::unique_ptr<float[]> ComputedValues; ///< a megabyte or two, written as pixels are computed
  vtkIdType Rays = 0;
};

/// Mean of the unshadowed term of every group over rays all over the image.
std::vector<double> TypicalLitSums(const LitQuadrature& quadrature, const Camera& camera, int width, int height);

} // namespace shadowcones

#endif
