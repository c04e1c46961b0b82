// SPDX-License-Identifier: BSD-3-Clause
// Images of gigabytes: an abort is seen before their memory is touched.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scToneMap.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// Bytes that the process has in memory; 0 where the system does not say.
double ResidentBytes()
{
  std::ifstream file("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace

TEST(LargeImage, AnAbortIsSeenBeforeItsMemoryIsTouched)
{
  if (ResidentBytes() == 0.0)
  {
    GTEST_SKIP() << "the system does not say how much memory is in use";
  }
  constexpr int side = 4000;
  const std::vector<double> ones(7, 1.0);
  TestMesh mesh;
  mesh.AddSheet({ -1.0, 0.0, -1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 });
  const OccluderScene occluders(mesh.View());
  const Light light = MakeLight(LightShape::Disc, { 0.0, 2.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.4, ones);
  Medium medium;
  medium.SigmaS = medium.SigmaA = ones;
  medium.Bounds = { { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 } };
  Camera camera;
  camera.Position = { 0.0, 0.0, 7.0 };
  ScatteringOptions options;
  options.Width = options.Height = side;
  options.Extent = { 0, side - 1, 0, side - 1 };
  // Of the questions the first few come at the beginning of each stage and the others every moment.
  for (const int answered : { 0, 2, 4 })
  {
    int asked = 0;
    Monitor monitor;
    monitor.Aborted = [&asked, answered] { return asked++ >= answered; };
    const double before = ResidentBytes();
    ScatteringImage image;
    EXPECT_FALSE(RenderScattering({ occluders, light, medium, camera }, options, monitor, image));
    const double ofImage = side * side * (4.0 * 7.0 + 5.0) * sizeof(float);
    EXPECT_LT(ResidentBytes() - before, 0.25 * ofImage) << answered;
  }
}

TEST(LargeImage, ColoursStopWhereTheMonitorSaysSo)
{
  const std::vector<float> radiance(2000, 1.0f);
  std::vector<unsigned char> rgb(3000, 7);
  Monitor monitor;
  monitor.Aborted = [] { return true; };
  EXPECT_FALSE(ToneMap(radiance.data(), 1000, { { 450.0, 600.0 }, 1.0, ToneCurve::Linear }, monitor, rgb.data()));
  EXPECT_EQ(rgb, std::vector<unsigned char>(3000, 7));
}
