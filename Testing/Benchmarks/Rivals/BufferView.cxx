// SPDX-License-Identifier: BSD-3-Clause
#include "BufferView.h"

#include "scFrame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shadowcones
{

//------------------------------------------------------------------------------
BufferView::BufferView(const Vector3& position, bool parallel, const TriangleMeshView& mesh, int resolution)
  : Parallel(parallel)
  , Resolution(resolution)
{
  const Vector3 middle = MeshBounds(mesh).Center();
  this->Origin = parallel ? middle : position;
  this->W = parallel ? -position : Normalized(middle - position);
  const Frame frame = FrameAround(this->W);
  this->U = frame.U;
  this->V = frame.V;
  double low[2] = { HUGE_VAL, HUGE_VAL };
  double high[2] = { -HUGE_VAL, -HUGE_VAL };
  for (vtkIdType k = 0; k < 3 * mesh.NumberOfTriangles; ++k)
  {
    const Vector3 to = mesh.Point(mesh.Triangles[k]) - this->Origin;
    const double depth = Dot(to, this->W);
    if (!parallel && !(depth > 1e-3 * Length(to)))
    {
      throw std::runtime_error("The light stands among the occluders: one shadow buffer cannot look all around.");
    }
    const double across[2] = { Dot(to, this->U) / (parallel ? 1.0 : depth), Dot(to, this->V) / (parallel ? 1.0 : depth) };
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], across[axis]);
      high[axis] = std::max(high[axis], across[axis]);
    }
  }
  // Two empty texels around, so that what lies at the border is lit.
  const double share = 2.0 / (resolution - 4.0);
  const double smallest = 1e-9 * (1.0 + std::max(high[0] - low[0], high[1] - low[1]));
  for (int axis = 0; axis < 2; ++axis)
  {
    const double width = std::max(high[axis] - low[axis], smallest);
    (axis == 0 ? this->LowU : this->LowV) = low[axis] - share * width;
    (axis == 0 ? this->TexelsU : this->TexelsV) = (resolution - 4.0) / width;
  }
}

//------------------------------------------------------------------------------
std::vector<float> BufferView::Depths(const TriangleMeshView& mesh) const
{
  std::vector<float> depths(static_cast<std::size_t>(this->Resolution) * static_cast<std::size_t>(this->Resolution), HUGE_VALF);
  for (vtkIdType triangle = 0; triangle < mesh.NumberOfTriangles; ++triangle)
  {
    const Spot corners[3] = { this->Look(mesh.Corner(triangle, 0)), this->Look(mesh.Corner(triangle, 1)),
      this->Look(mesh.Corner(triangle, 2)) };
    this->Draw(corners, depths);
  }
  return depths;
}

//------------------------------------------------------------------------------
void BufferView::Draw(const Spot (&corners)[3], std::vector<float>& depths) const
{
  const Spot& a = corners[0];
  const double bu = corners[1].U - a.U;
  const double bv = corners[1].V - a.V;
  const double cu = corners[2].U - a.U;
  const double cv = corners[2].V - a.V;
  const double area = bu * cv - bv * cu;
  if (area == 0.0)
  {
    return;
  }
  // What is linear across the picture: the depth of a parallel light, else its inverse.
  const auto linear = [this](double depth) { return this->Parallel ? depth : 1.0 / depth; };
  const double key = linear(a.Depth);
  const double keyB = linear(corners[1].Depth) - key;
  const double keyC = linear(corners[2].Depth) - key;
  const auto from = [](double low) { return std::max(0, static_cast<int>(std::ceil(low - 0.5))); };
  const auto to = [this](double high) { return std::min(this->Resolution - 1, static_cast<int>(std::floor(high - 0.5))); };
  const int beginU = from(a.U + std::min({ 0.0, bu, cu }));
  const int endU = to(a.U + std::max({ 0.0, bu, cu }));
  const int endV = to(a.V + std::max({ 0.0, bv, cv }));
  for (int j = from(a.V + std::min({ 0.0, bv, cv })); j <= endV; ++j)
  {
    const double dv = j + 0.5 - a.V;
    float* row = depths.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(this->Resolution);
    for (int i = beginU; i <= endU; ++i)
    {
      const double du = i + 0.5 - a.U;
      const double b = (du * cv - dv * cu) / area;
      const double c = (bu * dv - bv * du) / area;
      if (b >= 0.0 && c >= 0.0 && b + c <= 1.0)
      {
        const double value = key + b * keyB + c * keyC;
        row[i] = std::min(row[i], static_cast<float>(this->Parallel ? value : 1.0 / value));
      }
    }
  }
}

} // namespace shadowcones
