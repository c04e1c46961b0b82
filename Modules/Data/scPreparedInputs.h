// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPreparedInputs.h
 * @brief Inputs of filters that are read, and built upon, once for as long as they do not change.
 */
#ifndef scPreparedInputs_h
#define scPreparedInputs_h

#include "ShadowConesDataModule.h"
#include "scConeHierarchy.h"
#include "scDensityGrid.h"
#include "scMeshData.h"
#include "scOccluderScene.h"
#include "scPreparedScene.h"
#include "scSceneLights.h"
#include "scVisibilityGrid.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace shadowcones
{

class VisibilityGridSampler;

/// Cones as they were read, before AssignCones(), and the input that they are from, as "The cone set on input port 1".
struct ConeSetOfInput
{
  vtkPolyData* Data;
  const std::vector<Cone>& Cones;
  const char* Input;
};

struct SHADOWCONESDATA_EXPORT PreparedMesh : PreparedItem
{
  TriangleMesh Mesh;
  Box Bounds; ///< with its receivers
  vtkIdType NumberOfCasters = 0;
  std::uint64_t CastersFingerprint = 0;

  std::int64_t Memory() const override;
};

/// A mesh, read. Without one an empty mesh. @return nullptr, with a sentence in @p error, where it cannot be read.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedMesh> PrepareMesh(
  PreparedUser& user, vtkDataObject* input, std::string& error);
/// The mesh without its receivers: the very same where it has none.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedMesh> PrepareCasters(
  PreparedUser& user, const std::shared_ptr<const PreparedMesh>& mesh);

struct SHADOWCONESDATA_EXPORT PreparedOccluders : PreparedItem
{
  explicit PreparedOccluders(const std::shared_ptr<const PreparedMesh>& mesh);

  const std::shared_ptr<const PreparedMesh> Mesh;
  const OccluderScene Scene;

  std::int64_t Memory() const override { return this->Scene.Memory(); }
};

/// The search tree of a mesh. Throws as OccluderScene does.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedOccluders> PrepareOccluders(
  PreparedUser& user, const std::shared_ptr<const PreparedMesh>& mesh);

struct SHADOWCONESDATA_EXPORT PreparedReflectance : PreparedItem
{
  SurfaceReflectance Reflectance;

  std::int64_t Memory() const override { return MemoryOf(this->Reflectance.Values); }
};

/// ReadReflectance() of a prepared mesh, whose input is there.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedReflectance> PrepareReflectance(
  PreparedUser& user, const PreparedMesh& mesh, std::size_t wavelengths, double missing, std::string& error);

struct SHADOWCONESDATA_EXPORT PreparedNormals : PreparedItem
{
  std::vector<float> Normals; ///< empty: the mesh has none

  std::int64_t Memory() const override { return MemoryOf(this->Normals); }
};

/// ReadPointNormals() of a prepared mesh, whose input is there. @return nullptr, with a sentence in @p error.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedNormals> PrepareNormals(
  PreparedUser& user, const PreparedMesh& mesh, std::string& error);

struct SHADOWCONESDATA_EXPORT PreparedCones : PreparedItem
{
  std::vector<std::unique_ptr<const ConeHierarchy>> OfLights;

  std::int64_t Memory() const override;
};

/// A hierarchy for each light over its cones, which were made from what has these stamps.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedCones> PrepareCones(PreparedUser& user,
  const std::vector<InputStamp>& stamps, const std::vector<std::vector<Cone>>& conesOf, const Box& bounds,
  double length);

struct SHADOWCONESDATA_EXPORT PreparedProof : PreparedItem
{
  bool Proved = false;
  std::string Changed; ///< a sentence, where the certificate is one of other cones

  std::int64_t Memory() const override { return static_cast<std::int64_t>(sizeof(*this) + this->Changed.capacity()); }
};

/// AreProved() of cones that were read from a cone set, for a prepared mesh and lights that have these stamps.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedProof> PrepareProof(PreparedUser& user,
  const ConeSetOfInput& cones, const PreparedMesh& mesh, const std::vector<Light>& lights,
  const std::vector<InputStamp>& lightStamps);

/// A grid for each light, laid out for the camera's rays.
struct SHADOWCONESDATA_EXPORT PreparedGrids : PreparedItem
{
  std::vector<VisibilityGrid> Grids;
  std::vector<std::shared_ptr<const VisibilityGridSampler>> Layouts;
  std::string SaidOfBricks; ///< empty: nothing is to be said
  std::vector<std::string> SaidOfLights;

  void LayOut();
  std::int64_t Memory() const override;
};

/// The grids of a visibility volume in the order of the lights.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedGrids> PrepareGrids(PreparedUser& user, vtkImageData* volume,
  const std::vector<InputStamp>& lightStamps, const SceneLights& lights, std::string& error);

struct SHADOWCONESDATA_EXPORT PreparedDensity : PreparedItem
{
  DensityGrid Density;

  std::int64_t Memory() const override { return MemoryOf(this->Density.Values); }
};

/// ReadDensity() of an image.
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedDensity> PrepareDensity(
  PreparedUser& user, vtkImageData* input, vtkDataArray* chosen, std::string& error);

} // namespace shadowcones

#endif
