// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityGridFiller.h"

#include "scConeHierarchy.h"
#include "scSurfelVisibility.h"
#include "scWholeLight.h"

namespace shadowcones
{
namespace
{
/// The whole shadow of a base disc; of a disc next to the light, as wide as can be.
Cone WidePenumbraOf(const Cone& disc, const Light& light, const LightExtent& extent)
{
  constexpr double widest = 1.5;
  Cone penumbra;
  if (!PenumbraOf(disc, light, extent, penumbra))
  {
    penumbra.HalfAngle = widest;
  }
  return penumbra;
}

/// What is known of a vertex.
struct VertexAnswer
{
  float Visibility = 1.0f;
  float Fluence = 0.0f;
  float FluenceError = 0.0f;
  unsigned char ShadowClass = 0;
  unsigned char Marked = 0;
};
} // anonymous namespace

VisibilityGridFiller::VisibilityGridFiller(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene,
  const Box& bounds, const VisibilityGridOptions& options, VisibilityGrid& grid)
  : Cones(cones)
  , Lamp(light)
  , Options(options)
  , Grid(grid)
  , Asked(cones, light, scene, bounds, options)
{
  grid = {};
  grid.Dimensions = options.Dimensions;
  grid.Origin = bounds.Min;
  const Vector3 size = bounds.Size();
  grid.Spacing = { size.X / (options.Dimensions[0] - 1), size.Y / (options.Dimensions[1] - 1),
    size.Z / (options.Dimensions[2] - 1) };
  const std::size_t count = grid.VertexIndex(0, 0, options.Dimensions[2]);
  grid.Visibility.assign(count, 1.0f);
  grid.ShadowClasses.assign(count, static_cast<unsigned char>(ShadowClass::Lit));
  grid.Marked.assign(count, 0);
  grid.Fluence.assign(options.Fluence ? count : 0, 0.0f);
  grid.FluenceErrors.assign(grid.Fluence.size(), 0.0f);
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool all = options.Extent[2 * axis] > options.Extent[2 * axis + 1];
    this->First[axis] = all ? 0 : std::max(0, options.Extent[2 * axis]);
    this->Last[axis] =
      all ? options.Dimensions[axis] - 1 : std::min(options.Dimensions[axis] - 1, options.Extent[2 * axis + 1]);
  }
}

bool VisibilityGridFiller::Mark(const Box& bounds, const Monitor& monitor)
{
  // Cones thinner than a cell are widened until they hold a vertex of every cell they pass.
  const double least = 0.5 * Length(this->Grid.Spacing);
  const LightExtent extent = LightExtentOf(this->Lamp);
  std::vector<Cone> reach;
  for (const Cone& cone : this->Cones)
  {
    reach.push_back(this->Options.Method == VisibilityMethod::Soft ? WidePenumbraOf(cone, this->Lamp, extent) : cone);
    reach.back().BaseRadius = std::max(reach.back().BaseRadius, least);
  }
  // Vertices on the faces of the box belong to it, whatever the rounding.
  const Vector3 margin = 0.5 * this->Grid.Spacing;
  const ConeHierarchy hierarchy(reach, { bounds.Min - margin, bounds.Max + margin });
  std::vector<unsigned char>& marks = this->Grid.Marked;
  if (!hierarchy.MarkGrid(this->Grid.Origin, this->Grid.Spacing, this->Grid.Dimensions, monitor, marks.data()))
  {
    return false;
  }
  // A vertex next to a cone belongs to a cell that the cone reaches: one more along each axis.
  std::vector<unsigned char> wide(marks.size());
  const std::array<int, 3>& n = this->Grid.Dimensions;
  std::size_t stride = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto widen = [&](vtkIdType firstRow, vtkIdType endOfRows)
    {
      for (vtkIdType row = firstRow; row < endOfRows; ++row)
      {
        std::array<int, 3> at{ 0, static_cast<int>(row % n[1]), static_cast<int>(row / n[1]) };
        for (; at[0] < n[0]; ++at[0])
        {
          const std::size_t id = this->Grid.VertexIndex(at[0], at[1], at[2]);
          const int before = at[axis] > 0 ? marks[id - stride] : 0;
          const int after = at[axis] + 1 < n[axis] ? marks[id + stride] : 0;
          wide[id] = static_cast<unsigned char>(marks[id] | before | after);
        }
      }
    };
    if (!ParallelFor(static_cast<vtkIdType>(n[1]) * n[2], { nullptr, monitor.Aborted }, widen))
    {
      return false;
    }
    marks.swap(wide);
    stride *= static_cast<std::size_t>(n[axis]);
  }
  return true;
}

/// The fluence at all wanted vertices as if nothing were in the way, where it is asked for.
bool VisibilityGridFiller::FillWholeFluence(const Monitor& monitor)
{
  VisibilityGrid& grid = this->Grid;
  const vtkIdType rows = this->Last[1] - this->First[1] + 1;
  const vtkIdType layers = this->Last[2] - this->First[2] + 1;
  return grid.Fluence.empty() ||
    ParallelFor(rows * layers, monitor,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const int j = this->First[1] + static_cast<int>(row % rows);
          const int k = this->First[2] + static_cast<int>(row / rows);
          for (int i = this->First[0]; i <= this->Last[0]; ++i)
          {
            grid.Fluence[grid.VertexIndex(i, j, k)] =
              static_cast<float>(WholeFluence(this->Lamp, grid.Vertex(i, j, k)));
          }
        }
      });
}

bool VisibilityGridFiller::FillVertices(const Monitor& monitor)
{
  VisibilityGrid& grid = this->Grid;
  const int nx = grid.Dimensions[0];
  const int ny = grid.Dimensions[1];
  std::vector<vtkIdType> wanted;
  if (!this->FillWholeFluence(monitor.Part(0.0, 0.02)))
  {
    return false;
  }
  const auto collect = [&](vtkIdType row, const auto& found)
  {
    const auto j = static_cast<int>(row % ny);
    const auto k = static_cast<int>(row / ny);
    for (int i = 0; i < nx; ++i)
    {
      const std::size_t id = grid.VertexIndex(i, j, k);
      const bool inside = i >= this->First[0] && i <= this->Last[0] && j >= this->First[1] && j <= this->Last[1] &&
        k >= this->First[2] && k <= this->Last[2];
      grid.Marked[id] = inside ? grid.Marked[id] : 0;
      if (grid.Marked[id])
      {
        found(static_cast<vtkIdType>(id));
      }
    }
  };
  const vtkIdType rows = static_cast<vtkIdType>(ny) * grid.Dimensions[2];
  if (!CollectRows(rows, monitor.Part(0.02, 0.05), collect, wanted))
  {
    return false;
  }
  const TeamShare share(this->Options.Workers, static_cast<vtkIdType>(wanted.size()), pointsPerBlock);
  const auto write = [&grid](std::size_t id, const VertexAnswer& answer)
  {
    grid.Marked[id] = answer.Marked;
    grid.Visibility[id] = answer.Visibility;
    grid.ShadowClasses[id] = answer.ShadowClass;
    if (!grid.Fluence.empty() && answer.Marked)
    {
      grid.Fluence[id] = answer.Fluence;
      grid.FluenceErrors[id] = answer.FluenceError;
    }
  };
  // Answers are held apart only where others have to get them: they take more than the grid itself.
  std::vector<VertexAnswer> answers(AreSeveral(this->Options.Workers) ? wanted.size() : 0);
  TeamJoin join(this->Options.Workers);
  join.AddItems(answers, share);
  const auto ask = [&](vtkIdType begin, vtkIdType end)
  {
    vtkIdType rays = 0;
    for (vtkIdType w = begin; w < end; ++w)
    {
      const auto id = static_cast<std::size_t>(wanted[static_cast<std::size_t>(w)]);
      const auto i = static_cast<int>(id % nx);
      const auto j = static_cast<int>(id / nx % ny);
      const auto k = static_cast<int>(id / nx / ny);
      VisibilitySampler::Answer answer;
      VertexAnswer to;
      to.Marked = this->Asked.Ask(grid.Vertex(i, j, k), answer, rays) ? 1 : 0;
      to.Visibility = answer.Fraction;
      to.ShadowClass = static_cast<unsigned char>(answer.Class);
      to.Fluence = static_cast<float>(answer.Fluence.Factor);
      to.FluenceError = static_cast<float>(answer.Fluence.Error);
      if (answers.empty())
      {
        write(id, to);
      }
      else
      {
        answers[static_cast<std::size_t>(w)] = to;
      }
    }
    return rays;
  };
  if (!this->AskShare(share, join, monitor.Part(0.05, 1.0), ask))
  {
    return false;
  }
  for (std::size_t w = 0; w < answers.size(); ++w)
  {
    write(static_cast<std::size_t>(wanted[w]), answers[w]);
  }
  return true;
}

} // namespace shadowcones
