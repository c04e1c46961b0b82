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
      Box& box = boxes[mesh.OccluderId(t)];
      for (int corner = 0; corner < 3; ++corner)
      {
        box.Add(mesh.Corner(t, corner));
      }
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
