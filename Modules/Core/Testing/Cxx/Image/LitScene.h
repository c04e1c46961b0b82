// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LitScene.h
 * @brief Light in a box of medium, and its unshadowed term along rays, for tests of what reads that term.
 */
#ifndef LitScene_h
#define LitScene_h

#include "TestLights.h"
#include "scExtinctionGroups.h"
#include "scLitPixel.h"
#include "scLitQuadrature.h"
#include "scLitTile.h"

#include <numeric>

/// The camera looks along +x at a box 4 x 2 x 2 that begins at the origin's plane.
struct LitScene
{
  shadowcones::Light Source;
  shadowcones::Medium Fog;
  shadowcones::Camera Eye;
  shadowcones::ExtinctionGroups Groups;
  shadowcones::LitQuadrature Quadrature;

  explicit LitScene(shadowcones::Light light, double sigmaS = 0.1, double sigmaA = 0.0)
    : Source(std::move(light))
    , Fog(MakeFog(this->Source, sigmaS, sigmaA))
    , Groups(this->Source.Spectrum, this->Fog)
    , Quadrature(this->Source, this->Fog, this->Groups)
  {
    this->Eye.Position = { -1.0, 0.0, 0.0 };
    this->Eye.Forward = { 1.0, 0.0, 0.0 };
    this->Eye.Right = { 0.0, 0.0, 1.0 };
    this->Eye.Up = { 0.0, 1.0, 0.0 };
    this->Eye.Parallel = true;
    this->Eye.HalfHeight = 1.2;
  }
  static shadowcones::Medium MakeFog(const shadowcones::Light& light, double sigmaS, double sigmaA)
  {
    shadowcones::Medium fog;
    fog.SigmaS.assign(light.Spectrum.size(), sigmaS);
    fog.SigmaA.assign(light.Spectrum.size(), sigmaA);
    fog.Bounds.Min = { 0.0, -1.0, -1.0 };
    fog.Bounds.Max = { 4.0, 1.0, 1.0 };
    return fog;
  }
  /// Squares of a size x size image; errors are relative to each ray's own sum.
  shadowcones::LitTile TileOf(int size, double tolerance) const
  {
    const std::vector<double> typical(static_cast<std::size_t>(this->Groups.Count()), 0.0);
    return { this->Quadrature, this->Eye, size, size, tolerance, typical };
  }
  /// The profile of one pixel of a size x size image.
  shadowcones::LitPixel PixelOf(int i, int j, int size) const
  {
    shadowcones::LitTile tile = this->TileOf(size, 1e-3);
    shadowcones::LitPixel pixel;
    tile.MoveTo(0, 0);
    tile.Interpolate(i, j, pixel);
    return pixel;
  }
};

inline double SumOfCells(const shadowcones::LitPixel& pixel, int count = shadowcones::LitProfileLayout::Cells)
{
  return std::accumulate(pixel.Cells(0), pixel.Cells(0) + count, 0.0);
}

#endif
