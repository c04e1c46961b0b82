// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * @brief A small scene that is rendered in every mode: the tests of the image are made of these. Cameras.
 */
#ifndef Scenes_h
#define Scenes_h

#include "TestCones.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scCamera.h"
#include "scCone.h"
#include "scConeHierarchy.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scVisibilityGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

inline Camera LookAt(const Vector3& from, const Vector3& to, double halfHeight, bool parallel = false)
{
  Camera camera;
  camera.Position = from;
  camera.Forward = Normalized(to - from);
  const Vector3 up = std::abs(camera.Forward.Y) < 0.9 ? Vector3{ 0.0, 1.0, 0.0 } : Vector3{ 0.0, 0.0, 1.0 };
  camera.Right = Normalized(Cross(camera.Forward, up));
  camera.Up = Cross(camera.Right, camera.Forward);
  camera.HalfHeight = halfHeight;
  camera.Parallel = parallel;
  return camera;
}

inline const char* NameOf(ScatteringMode mode)
{
  static const char* const names[] = { "BruteForce", "Medium", "Fast", "Guided", "Soft", "Volume" };
  return names[static_cast<int>(mode)];
}

/// All but Fast, which the truth is not asked of.
constexpr ScatteringMode ExactModes[] = { ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Guided,
  ScatteringMode::Soft, ScatteringMode::Volume };

struct ImageTestScene
{
  Light Source;
  Medium Fog;
  TestMesh Mesh;
  std::vector<Cone> Bounds; ///< of the shadow
  std::vector<Cone> Discs;  ///< occluders, for Soft
  Camera Eye;
  ScatteringOptions Options;
  VisibilityGridOptions GridOptions; ///< of Soft and Volume; Method is set by the mode

  ImageTestScene()
  {
    this->Options.NumberOfSteps = 128;
    this->Options.MaximumHalvings = 8;
    this->Options.IntensityThreshold = 0.02;
    this->Options.NumberOfSurfaceLightSamples = 0;
    this->Options.RelativeErrorGoal = 1e-3;
    this->Options.MaximumSamples = 1 << 16;
    this->Options.NumberOfEdgeSamples = 1; // closed forms and references look along the centres of the pixels
  }
  void SetSize(int width, int height)
  {
    this->Options.Width = width;
    this->Options.Height = height;
    this->Options.Extent = { 0, width - 1, 0, height - 1 };
  }
  void SetLight(
    LightShape shape, const Vector3& center, const Vector3& normal, double radius, std::vector<double> spectrum)
  {
    this->Source = MakeLight(shape, center, normal, radius, std::move(spectrum));
  }
  void SetMedium(std::vector<double> sigmaS, std::vector<double> sigmaA, const Vector3& low, const Vector3& high)
  {
    this->Fog.SigmaS = std::move(sigmaS);
    this->Fog.SigmaA = std::move(sigmaA);
    this->Fog.Bounds.Min = low;
    this->Fog.Bounds.Max = high;
  }
  /// Something that no light or ray meets.
  void AddNothing()
  {
    this->Mesh.AddSheet(this->Fog.Bounds.Max + 9.0 * this->Fog.Bounds.Size(),
      { 0.1 * this->Fog.Bounds.Size().X, 0.0, 0.0 }, { 0.0, 0.1 * this->Fog.Bounds.Size().Y, 0.0 });
  }
  /// A disc across the z axis, itself and the cone that bounds its shadow.
  void AddDisc(const Vector3& center, double radius, const Vector3& axis, double halfAngle)
  {
    this->Mesh.AddDisc(center, radius);
    this->Discs.push_back(MakeCone(center, axis, radius, halfAngle));
    this->Bounds.push_back(MakeCone(center, axis, 1.01 * radius, halfAngle));
  }

  VisibilityGrid FillGrid(ScatteringMode mode, const OccluderScene& occluders) const
  {
    VisibilityGridOptions options = this->GridOptions;
    options.Method = mode == ScatteringMode::Soft ? VisibilityMethod::Soft : VisibilityMethod::Exact;
    VisibilityGrid grid;
    EXPECT_TRUE(FillVisibilityGrid(mode == ScatteringMode::Soft ? this->Discs : this->Bounds, this->Source,
      mode == ScatteringMode::Soft ? nullptr : &occluders, this->Fog.Bounds, options, {}, grid));
    return grid;
  }
  ScatteringImage Render(ScatteringMode mode, const ConeHierarchy* cones, const VisibilityGrid* grid) const
  {
    const OccluderScene occluders(this->Mesh.View());
    ScatteringOptions options = this->Options;
    options.Mode = mode;
    ScatteringImage image;
    EXPECT_TRUE(RenderScattering({ occluders, this->Source, this->Fog, this->Eye, cones, grid }, options, {}, image));
    return image;
  }
  /// With the cones, and with the grid that the mode asks for.
  ScatteringImage Render(ScatteringMode mode) const
  {
    const ConeHierarchy cones(this->Bounds, this->Fog.Bounds);
    VisibilityGrid grid;
    const bool needsGrid = mode == ScatteringMode::Soft || mode == ScatteringMode::Volume;
    if (needsGrid)
    {
      const OccluderScene occluders(this->Mesh.View());
      grid = this->FillGrid(mode, occluders);
    }
    return this->Render(mode, &cones, needsGrid ? &grid : nullptr);
  }
  Ray PixelRay(int i, int j) const { return this->Eye.PixelRay(i, j, this->Options.Width, this->Options.Height); }
};

} // namespace testsupport
} // namespace shadowcones

#endif
