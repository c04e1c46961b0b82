// SPDX-License-Identifier: BSD-3-Clause
// Shadow vectors and photon paths: what is read, what is refused and in which words.
#include "scVectorData.h"

#include "scFieldArrays.h"
#include "scHandOver.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Two shadow vectors that are photon paths too.
void MakeVectors(vtkPolyData* data)
{
  SetVertices(data, { 1, 2, 3, 4, 5, 6 });
  AddFloatArray(data->GetPointData(), "Direction", 3, { 0, 0, -1, 0.6f, 0, 0.8f });
  AddDoubleArray(data->GetPointData(), "EmissionPoint", 3, { 0, 0, 9, 0.1, 0, 9 });
  AddIntArray(data->GetPointData(), "OccluderId", 1, { 3, 4 });
  AddIntArray(data->GetPointData(), "PathState", 1, { 0, 1 });
}

} // namespace

TEST(VectorData, ShadowVectors)
{
  vtkNew<vtkPolyData> data;
  MakeVectors(data);
  ShadowVectorArrays vectors;
  std::string error;
  ASSERT_TRUE(ReadShadowVectors(data, vectors, error, true)) << error;
  const ShadowVectorView view = vectors.View();
  EXPECT_EQ(view.Count, 2);
  EXPECT_EQ(view.Points[5], 6.0);
  EXPECT_EQ(view.Directions[3], 0.6f);
  EXPECT_EQ(view.EmissionPoints[3], 0.1);
  EXPECT_EQ(view.OccluderIds[1], 4);

  data->GetPointData()->RemoveArray("OccluderId");
  data->GetPointData()->RemoveArray("EmissionPoint");
  ASSERT_TRUE(ReadShadowVectors(data, vectors, error)) << error;
  EXPECT_EQ(vectors.View().OccluderIds, nullptr);
  EXPECT_EQ(vectors.View().EmissionPoints, nullptr);
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error, true));
  EXPECT_EQ(error, "The shadow-vector input has no array \"EmissionPoint\".");
  EXPECT_EQ(vectors.View().Count, 0);

  AddDoubleArray(data->GetPointData(), "LightId", 1, { 0.0, 0.5 });
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error));
  EXPECT_EQ(error, "The \"LightId\" of shadow vector 1 is 0.5: it must be a whole number, 0 or more.");
  data->GetPointData()->GetArray("Direction")->SetComponent(1, 0, NaN);
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error));
  EXPECT_EQ(error, "The \"Direction\" of shadow vector 1 is not finite.");
  data->GetPointData()->RemoveArray("Direction");
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error));
  EXPECT_EQ(error, "The shadow-vector input has no array \"Direction\".");
  EXPECT_TRUE(ReadShadowVectors(vtkNew<vtkPolyData>(), vectors, error, true));
  EXPECT_EQ(vectors.View().Count, 0);
}

TEST(VectorData, PhotonPaths)
{
  vtkNew<vtkPolyData> data;
  MakeVectors(data);
  PhotonPathArrays paths;
  std::string error;
  ASSERT_TRUE(ReadPhotonPaths(data, paths, error)) << error;
  EXPECT_EQ(paths.View().Count, 2);
  EXPECT_EQ(paths.View().States[1], 1);
  EXPECT_EQ(paths.View().EmissionPoints[2], 9.0);

  AddIntArray(data->GetPointData(), "PathState", 1, { 0, 2 });
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The \"PathState\" of photon path 1 is 2: it must be 0 (lit) or 1 (blocked).");
  AddDoubleArray(data->GetPointData(), "PathState", 1, { 0.5, 1.0 });
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The \"PathState\" of photon path 0 is 0.5: it must be 0 (lit) or 1 (blocked).");
  data->GetPointData()->RemoveArray("PathState");
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The photon-path input has no array \"PathState\".");

  MakeVectors(data);
  data->GetPointData()->GetArray("EmissionPoint")->SetComponent(0, 2, NaN);
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The \"EmissionPoint\" of photon path 0 is not finite.");
}

TEST(HandOver, ValuesLastAsLongAsAnyArrayThatSharesThem)
{
  std::vector<float> values(1000, 7.0f);
  auto first = HandOver<vtkFloatArray>(1, values);
  EXPECT_TRUE(values.empty());
  vtkNew<vtkFloatArray> second;
  second->ShallowCopy(first);
  first = nullptr;
  const std::vector<float> others(1000, -1.0f); // would lie where memory was freed too early
  EXPECT_EQ(second->GetValue(500), 7.0f);
  second->InsertNextValue(8.0f); // grows, in memory of VTK's own
  EXPECT_EQ(second->GetValue(999), 7.0f);
  EXPECT_EQ(second->GetValue(1000), 8.0f);
  EXPECT_EQ(others.back(), -1.0f);
}

TEST(HandOver, NumbersBeyondSinglePrecisionAreNamed)
{
  vtkNew<vtkPolyData> data;
  std::vector<float> values = { 1.0f, std::numeric_limits<float>::infinity() };
  EXPECT_THROW(GiveArray<vtkFloatArray>(data->GetPointData(), "Power", 1, values), std::overflow_error);
  EXPECT_THROW(AddFloatArray(data->GetPointData(), "Power", 1, values), std::overflow_error);
  EXPECT_EQ(data->GetPointData()->GetArray("Power"), nullptr);
}
