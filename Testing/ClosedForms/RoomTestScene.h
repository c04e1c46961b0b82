// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RoomTestScene.h
 * @brief A mesh of Data/ in the foggy room, with cones that bound its shadow.
 */
#ifndef RoomTestScene_h
#define RoomTestScene_h

#include "scConeSet.h"
#include "scMeshData.h"
#include "scShadowVectors.h"
#include "ImageTestScene.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <string>

namespace shadowcones
{

/// Few, large cones that hold the shadow: 20,000 vectors at the hit points, overlapping, under the exact light.
inline std::vector<Cone> BoundingConesOf(const TriangleMeshView& mesh, const Light& light)
{
  const OccluderScene occluders(mesh);
  ShadowVectorOptions tracing;
  tracing.TargetNumberOfVectors = 20000;
  tracing.Storage = VectorStorage::HitPoint;
  ShadowVectorResult traced;
  EXPECT_TRUE(TraceShadowVectors(occluders, light, tracing, Monitor(), traced));
  ShadowVectorView view;
  view.Count = static_cast<vtkIdType>(traced.Vectors.OccluderIds.size());
  view.Points = traced.Vectors.Points.data();
  view.Directions = traced.Vectors.Directions.data();
  view.EmissionPoints = traced.Vectors.EmissionPoints.data();
  ConeSetOptions options;
  options.VarianceThreshold = 1.8;
  options.CosineCorrection = false;
  options.Expansion = ConeExpansion::LightGeometry;
  options.Overlap = true;
  ConeSet set;
  EXPECT_TRUE(FitConeSet(view, PhotonPathView(), LightExtentOf(light), options, Monitor(), set));
  return set.Cones;
}

/// "chair", "tree" or "blob" under a disc on the ceiling.
inline ImageTestScene RoomTestScene(const std::string& name)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((std::string(SHADOWCONES_DATA_DIR "/") + name + ".vtp").c_str());
  reader->Update();
  TriangleMesh mesh;
  std::string error;
  EXPECT_TRUE(ReadTriangles(reader->GetOutput(), mesh, error)) << error;
  ImageTestScene scene;
  scene.Mesh.Points = mesh.Points;
  scene.Mesh.Triangles = mesh.Triangles;
  scene.SetLight(LightShape::Disc, { 0.0, 5.49, 0.0 }, { 0.0, -1.0, 0.0 }, 0.5, { 1.0 });
  scene.SetMedium({ 0.12 }, { 0.05 }, { -2.75, 0.0, -2.75 }, { 2.75, 5.2, 2.75 });
  scene.Eye = LookAt({ 0.0, 2.65, 10.0 }, { 0.0, 2.65, 0.0 }, 0.37);
  scene.Bounds = Lengthened(BoundingConesOf(scene.Mesh.View(), scene.Source));
  return scene;
}

} // namespace shadowcones

#endif
