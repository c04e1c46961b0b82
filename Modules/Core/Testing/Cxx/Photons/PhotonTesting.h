// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PhotonTesting.h
 * @brief Photons traced at a small mesh, and a sheet for them to meet.
 */
#ifndef PhotonTesting_h
#define PhotonTesting_h

#include "TestMeshes.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace photontesting
{

using namespace shadowcones;
using namespace shadowcones::testsupport;

inline ShadowVectorResult Trace(const TestMesh& mesh, const Light& light, const ShadowVectorOptions& options)
{
  const OccluderScene scene(mesh.View());
  ShadowVectorResult result;
  EXPECT_TRUE(TraceShadowVectors(scene, light, options, {}, result));
  return result;
}

inline ShadowVectorOptions Photons(vtkIdType count, VectorStorage storage = VectorStorage::BackSide)
{
  ShadowVectorOptions options;
  options.NumberOfPhotons = count;
  options.Storage = storage;
  return options;
}

template <typename T>
Vector3 At(const std::vector<T>& values, std::size_t i)
{
  return { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
}

inline TestMesh Sheet(double half)
{
  TestMesh mesh;
  mesh.AddSheet({ -half, -half, 0.0 }, { 2.0 * half, 0.0, 0.0 }, { 0.0, 2.0 * half, 0.0 }, 4);
  return mesh;
}

} // namespace photontesting

#endif
