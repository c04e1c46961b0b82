// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BufferView.h
 * @brief What a point of the light sees of a mesh, as a picture of depths: the frame, and a plain z-buffer.
 */
#ifndef BufferView_h
#define BufferView_h

#include "scTriangleMesh.h"
#include "scVector3.h"

#include <vector>

namespace shadowcones
{

class BufferView
{
public:
  /**
   * Just wide enough for the mesh. @param position of the light point, or of a parallel light the unit vector towards it. Throws
   * std::runtime_error where the mesh is not all in front of the point: one picture cannot hold it then.
   */
  BufferView(const Vector3& position, bool parallel, const TriangleMeshView& mesh, int resolution);

  /// Where a place falls on the picture, in texels from its corner, and its depth along the view's axis.
  struct Spot
  {
    double U = 0.0;
    double V = 0.0;
    double Depth = 0.0;
    bool Inside = false; ///< of the picture, and in front of the light
  };
  Spot Look(const Vector3& x) const
  {
    const Vector3 to = x - this->Origin;
    Spot spot;
    spot.Depth = Dot(to, this->W);
    if (!this->Parallel && !(spot.Depth > 0.0))
    {
      return spot;
    }
    const double scale = this->Parallel ? 1.0 : 1.0 / spot.Depth;
    spot.U = (Dot(to, this->U) * scale - this->LowU) * this->TexelsU;
    spot.V = (Dot(to, this->V) * scale - this->LowV) * this->TexelsV;
    spot.Inside = spot.U >= 0.0 && spot.V >= 0.0 && spot.U < this->Resolution && spot.V < this->Resolution;
    return spot;
  }
  /// Depths of what is nearest at the middle of each texel, a row after the other; infinite where there is nothing.
  std::vector<float> Depths(const TriangleMeshView& mesh) const;
  int Side() const { return this->Resolution; }
  /// Texels a unit of tangent, or of length of a parallel light: the smaller of both ways.
  double Texels() const { return this->TexelsU < this->TexelsV ? this->TexelsU : this->TexelsV; }

private:
  void Draw(const Spot (&corners)[3], std::vector<float>& depths) const;

  bool Parallel;
  int Resolution;
  Vector3 Origin;
  Vector3 U;
  Vector3 V;
  Vector3 W; ///< away from the light
  double LowU = 0.0;
  double LowV = 0.0;
  double TexelsU = 1.0;
  double TexelsV = 1.0;
};

} // namespace shadowcones

#endif
