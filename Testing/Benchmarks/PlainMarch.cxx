// SPDX-License-Identifier: BSD-3-Clause
#include "PlainMarch.h"

#include "scExtinctionGroups.h"
#include "scLightSampler.h"
#include "scLightStrata.h"
#include "scMediumInterval.h"
#include "scMediumOpticalDepth.h"
#include "scPixelRay.h"
#include "scPrimaryHit.h"
#include "scRandom.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace shadowcones
{
namespace
{
class EmbreeRays
{
public:
  explicit EmbreeRays(const OccluderScene& scene)
    : Scene(scene)
  {
  }
  bool Nearest(const Vector3& origin, const Vector3& direction, double, double& t, vtkIdType& triangle) const
  {
    RayHit hit;
    const bool found = this->Scene.Intersect(origin, direction, 0.0, HUGE_VAL, hit);
    t = hit.T;
    triangle = hit.Triangle;
    return found;
  }
  bool Blocked(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const
  {
    return this->Scene.Occluded(origin, direction, tMin, tMax);
  }

private:
  const OccluderScene& Scene;
};

class LocatorRays
{
public:
  explicit LocatorRays(vtkStaticCellLocator* locator)
    : Locator(locator)
  {
  }
  bool Nearest(const Vector3& origin, const Vector3& direction, double tMax, double& t, vtkIdType& triangle)
  {
    double share = 0.0;
    const bool found = this->Find(origin, direction, 0.0, tMax, share, triangle);
    t = share * tMax;
    return found;
  }
  bool Blocked(const Vector3& origin, const Vector3& direction, double tMin, double tMax)
  {
    double share = 0.0;
    vtkIdType triangle = -1;
    return this->Find(origin, direction, tMin, tMax, share, triangle);
  }

private:
  bool Find(
    const Vector3& origin, const Vector3& direction, double tMin, double tMax, double& share, vtkIdType& triangle)
  {
    const Vector3 from = origin + tMin * direction;
    const Vector3 to = origin + tMax * direction;
    const double a[3] = { from.X, from.Y, from.Z };
    const double b[3] = { to.X, to.Y, to.Z };
    double x[3];
    double parametric[3];
    int subId = 0;
    return this->Locator->IntersectWithLine(a, b, 0.0, share, x, parametric, subId, triangle, this->Cell) != 0;
  }

  vtkStaticCellLocator* Locator;
  vtkNew<vtkGenericCell> Cell;
};

struct Node
{
  double T = 0.0;
  std::uint64_t Key = 0;
  double Intensity = 0.0;
};

/// One a thread.
template <class Rays>
class PlainMarcher
{
public:
  PlainMarcher(
    const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups, Rays& rays)
    : Scene(scene)
    , Options(options)
    , Groups(groups)
    , Strata(options.NumberOfLightSamples)
    , Sampler(scene.Light, options.Sampling)
    , Tests(rays)
  {
  }

  double March(int i, int j)
  {
    const Medium& medium = this->Scene.Medium;
    this->CameraRay = this->Scene.Camera.PixelRay(i, j, this->Options.Width, this->Options.Height);
    this->Samples = 0;
    PrimaryHit hit;
    double begin = 0.0;
    double far = HUGE_VAL;
    if (!medium.Bounds.Clip(this->CameraRay.Origin, this->CameraRay.Direction, begin, far))
    {
      return 0.0;
    }
    if (!this->Tests.Nearest(this->CameraRay.Origin, this->CameraRay.Direction, 1.01 * far, hit.T, hit.Triangle))
    {
      hit = PrimaryHit();
    }
    const MediumInterval interval = MediumIntervalOf(medium.Bounds, this->Scene.Occluders, this->CameraRay, hit);
    if (!interval.Crosses)
    {
      return 0.0;
    }
    this->Begin = interval.Begin;
    this->PixelSeed = HashSeed(this->Options.Seed, PixelIndex(this->Options, i, j));

    const int steps = this->Options.NumberOfSteps;
    this->Nodes.resize(static_cast<std::size_t>(steps) + 1);
    double largest = 0.0;
    for (int k = 0; k <= steps; ++k)
    {
      Node& node = this->Nodes[static_cast<std::size_t>(k)];
      node.T = k == steps ? interval.EndOfMarch
                          : interval.Begin + static_cast<double>(k) / steps * (interval.EndOfMarch - interval.Begin);
      node.Key = static_cast<std::uint64_t>(k) << 16;
      this->Evaluate(node);
      largest = std::max(largest, node.Intensity);
    }
    this->Threshold = this->Options.IntensityThreshold * largest;
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < this->Nodes.size(); ++k)
    {
      sum += this->Integrate(this->Nodes[k], this->Nodes[k + 1], 0);
    }
    return sum;
  }

  int NumberOfSamples() const { return this->Samples; }
  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  double Integrate(const Node& a, const Node& b, int depth)
  {
    if (depth < this->Options.MaximumHalvings && std::fabs(a.Intensity - b.Intensity) > this->Threshold)
    {
      Node middle;
      middle.T = 0.5 * (a.T + b.T);
      middle.Key = (a.Key + b.Key) / 2;
      this->Evaluate(middle);
      return this->Integrate(a, middle, depth + 1) + this->Integrate(middle, b, depth + 1);
    }
    return 0.5 * (b.T - a.T) * (a.Intensity + b.Intensity);
  }

  void Evaluate(Node& node)
  {
    const Vector3 point = this->CameraRay.Origin + node.T * this->CameraRay.Direction;
    RandomStream random(this->PixelSeed, node.Key);
    this->Sampler.MoveTo(point);
    double sum = 0.0;
    for (int s = 0; s < this->Strata.Count(); ++s)
    {
      const LightStrata::Point uv = this->Strata.Draw(s, random);
      const IncidentSample sample = this->Sampler.Sample(uv.U, uv.V);
      if (!(sample.Weight > 0.0))
      {
        continue;
      }
      ++this->OcclusionRays;
      if (this->Tests.Blocked(point, sample.Direction, 0.0, sample.Distance))
      {
        continue;
      }
      const double depth = node.T - this->Begin +
        std::min(sample.Distance, ExitDistance(this->Scene.Medium.Bounds, point, sample.Direction));
      double value = 0.0;
      for (std::size_t g = 0; g < this->Groups.SigmaT.size(); ++g)
      {
        value += this->Groups.MeanScatteredRadiance[g] * TransmittanceOver(this->Groups.SigmaT[g], depth);
      }
      const double cosine = Dot(sample.Direction, this->CameraRay.Direction);
      sum += sample.Weight * EvaluatePhaseFunction(this->Scene.Medium.Phase, cosine) * value;
    }
    node.Intensity = sum / this->Strata.Count();
    this->Samples += this->Strata.Count();
  }

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  const LightStrata Strata;
  LightSampler Sampler;
  Rays& Tests;
  Ray CameraRay;
  double Begin = 0.0;
  double Threshold = 0.0;
  std::uint64_t PixelSeed = 0;
  std::vector<Node> Nodes;
  int Samples = 0;
  vtkIdType OcclusionRays = 0;
};

/// @param source what the constructor of Rays takes.
template <class Rays, class Source>
PlainImage March(const ScatteringScene& scene, const Source& source, const ScatteringOptions& options, int stride)
{
  PlainImage image;
  image.Stride = stride;
  for (int j = 0; j < options.Height; j += stride)
  {
    for (int i = 0; i < options.Width; i += stride)
    {
      image.Pixels.push_back(i + options.Width * j);
    }
  }
  image.Values.resize(image.Pixels.size());
  image.Samples.resize(image.Pixels.size());
  const ExtinctionGroups groups(scene.Light.Spectrum, scene.Medium);
  std::atomic<vtkIdType> occlusionRays{ 0 };
  vtkSMPTools::For(0, static_cast<vtkIdType>(image.Pixels.size()), 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      Rays rays(source);
      PlainMarcher<Rays> marcher(scene, options, groups, rays);
      for (vtkIdType k = begin; k < end; ++k)
      {
        const auto at = static_cast<std::size_t>(k);
        const int pixel = image.Pixels[at];
        image.Values[at] = marcher.March(pixel % options.Width, pixel / options.Width);
        image.Samples[at] = marcher.NumberOfSamples();
      }
      occlusionRays += marcher.NumberOfOcclusionRays();
    });
  image.NumberOfOcclusionRays = occlusionRays;
  return image;
}
} // namespace

//------------------------------------------------------------------------------
PlainImage MarchWithEmbree(const ScatteringScene& scene, const ScatteringOptions& options, int stride)
{
  return March<EmbreeRays, OccluderScene>(scene, scene.Occluders, options, stride);
}

//------------------------------------------------------------------------------
LocatorScene::LocatorScene(const TriangleMeshView& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfPoints);
  for (vtkIdType k = 0; k < mesh.NumberOfPoints; ++k)
  {
    points->SetPoint(k, mesh.Points + 3 * k);
  }
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType k = 0; k < mesh.NumberOfTriangles; ++k)
  {
    triangles->InsertNextCell(3, mesh.Triangles + 3 * k);
  }
  this->Mesh->SetPoints(points);
  this->Mesh->SetPolys(triangles);
  this->Mesh->BuildCells();
  this->Search->SetDataSet(this->Mesh);
  this->Search->BuildLocator();
}

//------------------------------------------------------------------------------
PlainImage MarchWithLocator(
  const ScatteringScene& scene, const LocatorScene& locator, const ScatteringOptions& options, int stride)
{
  return March<LocatorRays, vtkStaticCellLocator*>(scene, locator.Locator(), options, stride);
}

} // namespace shadowcones
