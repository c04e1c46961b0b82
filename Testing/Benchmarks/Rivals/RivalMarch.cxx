// SPDX-License-Identifier: BSD-3-Clause
#include "RivalMarch.h"

#include "scLightRule.h"
#include "scLightSampler.h"
#include "scMediumInterval.h"
#include "scMediumOpticalDepth.h"
#include "scParallel.h"
#include "scPhaseFunction.h"
#include "scRenderScattering.h"
#include "scVisibilityGrid.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace shadowcones
{

//------------------------------------------------------------------------------
double ScatteredTowardsCamera(const ScatteringScene& scene, const ExtinctionGroups& groups, const Ray& line, double begin,
  double t, const IncidentSample& sample)
{
  const Vector3 point = line.Origin + t * line.Direction;
  const double depth =
    t - begin + std::min(sample.Distance, ExitDistance(scene.Medium.Bounds, point, sample.Direction));
  double value = 0.0;
  for (std::size_t g = 0; g < groups.SigmaT.size(); ++g)
  {
    value += groups.MeanScatteredRadiance[g] * TransmittanceOver(groups.SigmaT[g], depth);
  }
  return value * sample.Weight * EvaluatePhaseFunction(scene.Medium.Phase, Dot(sample.Direction, line.Direction));
}

//------------------------------------------------------------------------------
EvenAngle::EvenAngle(const Light& light, const Ray& line)
  : Plain(IsAtInfinity(light))
{
  if (!this->Plain)
  {
    this->Nearest = Dot(light.Center - line.Origin, line.Direction);
    this->Height = std::max(0.15, Length(light.Center - line.Origin - this->Nearest * line.Direction));
  }
}

double EvenAngle::At(double t) const
{
  return this->Plain ? t : std::atan((t - this->Nearest) / this->Height);
}

double EvenAngle::Distance(double variable) const
{
  return this->Plain ? variable : this->Nearest + this->Height * std::tan(variable);
}

double EvenAngle::Slope(double variable) const
{
  const double cosine = std::cos(variable);
  return this->Plain ? 1.0 : this->Height / (cosine * cosine);
}

//------------------------------------------------------------------------------
RivalMarch::RivalMarch(const ScatteringScene& scene, int width, int height, int places)
  : Subject(scene)
  , Columns(width)
  , Lines(height)
  , Places(places)
  , Groups(scene.Light.Spectrum, scene.Medium)
  , Rays(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  , Weights(Rays.size())
{
  this->RenderUnshadowed();
  ParallelFor(static_cast<vtkIdType>(this->Rays.size()), Monitor(),
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType pixel = begin; pixel < end; ++pixel)
      {
        this->Prepare(static_cast<std::size_t>(pixel));
      }
    });
}

//------------------------------------------------------------------------------
void RivalMarch::RenderUnshadowed()
{
  const Box& bounds = this->Subject.Medium.Bounds;
  VisibilityGrid nothing;
  nothing.Origin = bounds.Min;
  nothing.Spacing = bounds.Size();
  nothing.Dimensions = { 2, 2, 2 };
  nothing.Visibility.assign(8, 1.0f);
  nothing.ShadowClasses.assign(8, 0);
  nothing.Marked.assign(8, 0);
  ScatteringOptions options;
  options.Mode = ScatteringMode::Volume;
  options.Width = this->Columns;
  options.Height = this->Lines;
  options.Extent = { 0, this->Columns - 1, 0, this->Lines - 1 };
  options.NumberOfSurfaceLightSamples = 0;
  options.NumberOfEdgeSamples = 1;
  options.LightVisible = false;
  const ScatteringScene& scene = this->Subject;
  ScatteringImage image;
  for (int run = 0; run < 3; ++run)
  {
    const std::clock_t start = std::clock();
    RenderScattering({ scene.Occluders, scene.Light, scene.Medium, scene.Camera, nullptr, &nothing }, options, Monitor(), image);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    this->UnshadowedSeconds = run == 0 ? seconds : std::min(seconds, this->UnshadowedSeconds);
  }
  for (std::size_t pixel = 0; pixel < this->Rays.size(); ++pixel)
  {
    double value = 0.0;
    for (int k = 0; k < image.NumberOfWavelengths; ++k)
    {
      value += image.InScattering[pixel * static_cast<std::size_t>(image.NumberOfWavelengths) + static_cast<std::size_t>(k)];
    }
    this->Unshadowed.push_back(value / image.NumberOfWavelengths);
  }
}

//------------------------------------------------------------------------------
void RivalMarch::Prepare(std::size_t pixel)
{
  const ScatteringScene& scene = this->Subject;
  const auto width = static_cast<std::size_t>(this->Columns);
  RivalRay& ray = this->Rays[pixel];
  ray.Key = HashSeed(1, pixel);
  ray.Line = scene.Camera.PixelRay(
    static_cast<double>(pixel % width), static_cast<double>(pixel / width), this->Columns, this->Lines);
  const MediumInterval part = MediumIntervalOf(
    scene.Medium.Bounds, scene.Occluders, ray.Line, NearestSurface(scene.Occluders, ray.Line));
  if (!part.Crosses)
  {
    return;
  }
  const EvenAngle even(scene.Light, ray.Line);
  const LightRule rule(scene.Light, 1);
  const double first = even.At(part.Begin);
  const double step = (even.At(part.EndOfMarch) - first) / this->Places;
  RandomStream random(2, pixel);
  double sum = 0.0;
  for (int k = 0; k < this->Places; ++k)
  {
    const double variable = first + (k + random.Next()) * step;
    const double t = std::clamp(even.Distance(variable), part.Begin, part.EndOfMarch);
    double light = 0.0;
    rule.ForEach(ray.Line.Origin + t * ray.Line.Direction, [&](const IncidentSample& sample)
      { light += ScatteredTowardsCamera(scene, this->Groups, ray.Line, part.Begin, t, sample); });
    ray.Cuts.push_back(even.Distance(first + k * step));
    ray.Places.push_back(t);
    this->Weights[pixel].push_back(light * even.Slope(variable));
    sum += this->Weights[pixel].back();
  }
  ray.Cuts.push_back(part.EndOfMarch);
  for (double& weight : this->Weights[pixel])
  {
    weight = sum > 0.0 ? weight / sum : 0.0;
  }
}

//------------------------------------------------------------------------------
void RivalMarch::Render(const Rival& rival, std::vector<double>& image) const
{
  image.resize(this->Rays.size());
  ParallelFor(static_cast<vtkIdType>(this->Rays.size()), Monitor(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> blocked;
      for (auto pixel = static_cast<std::size_t>(begin); pixel < static_cast<std::size_t>(end); ++pixel)
      {
        double hidden = 0.0;
        if (this->Rays[pixel].Count() > 0)
        {
          rival.BlockedAlong(this->Rays[pixel], blocked);
          for (std::size_t k = 0; k < blocked.size(); ++k)
          {
            hidden += this->Weights[pixel][k] * blocked[k];
          }
        }
        image[pixel] = this->Unshadowed[pixel] * (1.0 - hidden);
      }
    });
}

//------------------------------------------------------------------------------
void RivalMarch::TracePaths(int samples, bool evenAngle, std::vector<double>& image) const
{
  const ScatteringScene& scene = this->Subject;
  image.assign(this->Rays.size(), 0.0);
  ParallelFor(static_cast<vtkIdType>(this->Rays.size()), Monitor(),
    [&](vtkIdType begin, vtkIdType end)
    {
      LightSampler sampler(scene.Light, LightSampling::Auto);
      for (auto pixel = static_cast<std::size_t>(begin); pixel < static_cast<std::size_t>(end); ++pixel)
      {
        const RivalRay& ray = this->Rays[pixel];
        if (ray.Count() == 0)
        {
          continue;
        }
        const double from = ray.Cuts.front();
        const double to = ray.Cuts.back();
        const EvenAngle even(scene.Light, ray.Line);
        const double first = even.At(from);
        const double width = even.At(to) - first;
        RandomStream random(3, pixel);
        double sum = 0.0;
        for (int k = 0; k < samples; ++k)
        {
          const double u = random.Next();
          const double variable = first + u * width;
          const double t = evenAngle ? std::clamp(even.Distance(variable), from, to) : from + u * (to - from);
          const Vector3 point = ray.Line.Origin + t * ray.Line.Direction;
          sampler.MoveTo(point);
          const double a = random.Next();
          const IncidentSample sample = sampler.Sample(a, random.Next());
          if (sample.Weight > 0.0 && !scene.Occluders.Occluded(point, sample.Direction, 0.0, sample.Distance))
          {
            sum += (evenAngle ? width * even.Slope(variable) : to - from) *
              ScatteredTowardsCamera(scene, this->Groups, ray.Line, from, t, sample);
          }
        }
        image[pixel] = sum / samples;
      }
    });
}

} // namespace shadowcones
