// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProjectedSolids.h
 * @brief Projection volumes (Crow 1977): the shadow of a mesh from a point as a closed solid, and where a ray runs inside.
 *
 * Of closed occluders the faces towards the light, of open ones all faces turned to it: these, the quadrilaterals behind their
 * outline, and their image beyond the medium bound the solid. A ray counts entries and exits, so that parts may overlap. One solid a
 * point of the light. Unlike ProjectShadow() it takes any mesh, and makes no surface that could be cut or measured.
 */
#ifndef ProjectedSolids_h
#define ProjectedSolids_h

#include "LampPoints.h"
#include "Rival.h"

#include "scBox.h"
#include "scOccluderScene.h"

#include <memory>
#include <vector>

namespace shadowcones
{

class ProjectedSolids : public Rival
{
public:
  /// @param bounds of the medium. The mesh's points are welded. Throws std::runtime_error where the light touches the mesh.
  ProjectedSolids(const TriangleMeshView& mesh, const Light& light, const Box& bounds, int points);

  void BlockedAlong(const RivalRay& ray, std::vector<double>& blocked) const override;
  std::int64_t Memory() const override;

private:
  struct Solid
  {
    std::vector<double> Points;
    std::vector<vtkIdType> Triangles;
    std::unique_ptr<OccluderScene> Search; ///< of the arrays above

    TriangleMeshView View() const;
  };
  static void Extrude(const TriangleMeshView& mesh, const std::vector<bool>& closed, const Vector3& light, bool parallel,
    const Box& bounds, Solid& solid);
  /// Share of each cell that lies inside, added up with a weight of its own.
  void AddSolid(std::size_t point, const RivalRay& ray, std::vector<double>& blocked, std::vector<double>& all) const;

  LampPoints Points;
  std::vector<std::unique_ptr<Solid>> Solids;
};

} // namespace shadowcones

#endif
