// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderParts.h
 * @brief Parts of casting triangles, small enough for cones to hold, and which of them cones hold already. Internal to Core.
 */
#ifndef scOccluderParts_h
#define scOccluderParts_h

#include "scBoundingCone.h"
#include "scFlatFace.h"
#include "scLightParts.h"
#include "scParallel.h"
#include "scProofMargins.h"
#include "scTriangleMesh.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// A piece of a triangle before a part of the light.
struct OccluderPart
{
  std::array<Vector3, 3> Corners;
  vtkIdType Triangle = 0;
  int Light = 0; ///< index of the part of the light
};

/// A mesh, the parts of a light, and how finely parts of occluders are cut.
class OccluderParts
{
public:
  OccluderParts(const TriangleMeshView& mesh, const Light& light, const ProofMargins& margins);

  const TriangleMeshView& Mesh() const { return this->View; }
  const std::vector<LightPart>& LightParts() const { return this->Lights; }
  const ProofMargins& Margins() const { return this->Margin; }
  /// The corners of what of a part casts shadow, with margins; none behind a one-sided light.
  std::vector<HeldPoint> CastingPoints(const OccluderPart& part) const;

  /**
   * All parts that no cone holds with all their shadow before a part of the light, in an order that depends on the mesh
   * alone; parts that are too large are cut at the middle of their longest edge. @param proved the number of parts that a
   * cone holds. @return false where aborted.
   */
  bool FindUnproved(const std::vector<Cone>& cones, const Monitor& monitor, std::vector<OccluderPart>& unproved,
    vtkIdType& proved) const;

private:
  struct Node
  {
    Box Bounds;
    vtkIdType Begin = 0; ///< triangles in Order
    vtkIdType End = 0;
  };
  class Search;

  void BuildNodes();

  TriangleMeshView View;
  std::vector<LightPart> Lights;
  FlatFace Face; ///< triangles that are flush with it cast nothing
  ProofMargins Margin;
  double LargestEdge = 0.0;
  std::vector<vtkIdType> Order;           ///< of the triangles along a curve that fills space
  std::vector<std::vector<Node>> Levels; ///< leaves first; node i of a level holds the nodes 4 i to 4 i + 3 below
};

} // namespace shadowcones

#endif
