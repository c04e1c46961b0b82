// SPDX-License-Identifier: BSD-3-Clause
#include "scCasterBoxes.h"

#include <map>

namespace shadowcones
{

CasterBoxes BoxesOfCasters(const TriangleMeshView& mesh)
{
  std::map<int, Box> boxes;
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    if (mesh.OccluderId(t) >= 0)
    {
      boxes[mesh.OccluderId(t)].Add(mesh.BoundsOf(t));
    }
  }
  CasterBoxes casters;
  for (const auto& [id, box] : boxes)
  {
    casters.Ids.push_back(id);
    casters.Boxes.push_back(box);
  }
  return casters;
}

} // namespace shadowcones
