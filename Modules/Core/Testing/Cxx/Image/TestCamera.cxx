// SPDX-License-Identifier: BSD-3-Clause
#include "scCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

using namespace shadowcones;

namespace
{

constexpr int width = 31;
constexpr int height = 17;

/// Where VTK projects a point, in pixels of the image: 0 is the left edge of the first pixel.
void Project(vtkCamera* camera, const Vector3& p, double pixel[2])
{
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0);
  const double world[4] = { p.X, p.Y, p.Z, 1.0 };
  double clip[4];
  matrix->MultiplyPoint(world, clip);
  pixel[0] = 0.5 * (clip[0] / clip[3] + 1.0) * width;
  pixel[1] = 0.5 * (clip[1] / clip[3] + 1.0) * height;
}

void ExpectSameProjection(const Camera& camera, vtkCamera* reference)
{
  for (const int i : { 0, 7, 30 })
  {
    for (const int j : { 0, 8, 16 })
    {
      const Ray ray = camera.PixelRay(i, j, width, height);
      EXPECT_NEAR(Length(ray.Direction), 1.0, 1e-12);
      for (const double t : { 1.0, 9.0 })
      {
        double pixel[2];
        Project(reference, ray.Origin + t * ray.Direction, pixel);
        EXPECT_NEAR(pixel[0], i + 0.5, 1e-6);
        EXPECT_NEAR(pixel[1], j + 0.5, 1e-6);
      }
    }
  }
}

/// A tilted camera, as both see it.
Camera Tilted(vtkCamera* reference)
{
  reference->SetPosition(3.0, 2.0, 5.0);
  reference->SetFocalPoint(0.5, -1.0, 0.0);
  reference->SetViewUp(0.2, 1.0, -0.1);
  reference->SetClippingRange(0.1, 100.0);
  Camera camera;
  camera.Position = { 3.0, 2.0, 5.0 };
  camera.Forward = Normalized(Vector3{ 0.5, -1.0, 0.0 } - camera.Position);
  camera.Right = Normalized(Cross(camera.Forward, { 0.2, 1.0, -0.1 }));
  camera.Up = Cross(camera.Right, camera.Forward);
  return camera;
}

} // namespace

TEST(Camera, PerspectiveRaysMatchVtkCamera)
{
  vtkNew<vtkCamera> reference;
  Camera camera = Tilted(reference);
  reference->SetViewAngle(40.0);
  camera.HalfHeight = std::tan(vtkMath::RadiansFromDegrees(20.0));
  ExpectSameProjection(camera, reference);
}

TEST(Camera, ParallelRaysMatchVtkCamera)
{
  vtkNew<vtkCamera> reference;
  Camera camera = Tilted(reference);
  reference->ParallelProjectionOn();
  reference->SetParallelScale(2.5);
  camera.Parallel = true;
  camera.HalfHeight = 2.5;
  ExpectSameProjection(camera, reference);
}

TEST(Camera, TheMiddlePixelLooksForward)
{
  const Camera camera;
  const Ray ray = camera.PixelRay(2, 1, 5, 3);
  EXPECT_DOUBLE_EQ(ray.Direction.Z, -1.0);
  EXPECT_DOUBLE_EQ(ray.Direction.X, 0.0);
  EXPECT_DOUBLE_EQ(ray.Direction.Y, 0.0);
}
