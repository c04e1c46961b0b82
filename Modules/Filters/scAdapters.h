// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scAdapters.h
 * @brief Between VTK data and Core's plain views, for every filter of the project.
 */
#ifndef scAdapters_h
#define scAdapters_h

#include "ShadowConesFiltersModule.h"
#include "scConeSet.h"
#include "scOccluderScene.h"
#include "scParallel.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkPolyData;

namespace shadowcones
{

/// Progress and abort of a filter, as Core sees them.
SHADOWCONESFILTERS_EXPORT Monitor MonitorOf(vtkAlgorithm* algorithm);

/// A poly data's polygons and strips as triangles, in double precision; holds what TriangleMeshView points to.
struct SHADOWCONESFILTERS_EXPORT TriangleMesh
{
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::vector<int> OccluderIds;       ///< per triangle; empty where the input has no cell array "OccluderId"
  std::vector<vtkIdType> SourceCells; ///< per triangle, the cell of the input that it comes from

  TriangleMeshView View() const;
};

/**
 * Read the polygons and strips of @p input as triangles; concave polygons are fine, lines and vertices are ignored.
 * @return false, with a sentence in @p error that names the point that is not finite, the cell that uses a point that
 * is not there, or a cell array "OccluderId" of the wrong size. Empty input gives an empty mesh.
 */
SHADOWCONESFILTERS_EXPORT bool ReadTriangles(vtkPolyData* input, TriangleMesh& mesh, std::string& error);

/**
 * Read a cone set from its documented arrays. "Axis", "BaseRadius" and "HalfAngle" are required. The others have
 * fallbacks: "InnerHalfAngle" is -|HalfAngle| (the shortest umbra that a light can leave), "Normal" is the axis,
 * "OccluderId", "VectorCount" and "Planarity" are 0, "Overspill" is -1. Axes and normals within 1e-3 of unit length are
 * normalised.
 * @return false, with a sentence in @p error that names the array that is missing or has the wrong size, or the cone
 * whose value is not valid. No points give no cones.
 */
SHADOWCONESFILTERS_EXPORT bool ReadConeSet(vtkPolyData* input, std::vector<Cone>& cones, std::string& error);
/// Write cones as vertices with the documented arrays of a cone set.
SHADOWCONESFILTERS_EXPORT void WriteConeSet(const std::vector<Cone>& cones, vtkPolyData* output);

/// Leave out the triangles of receivers, whose "OccluderId" is negative: they cast no shadow.
SHADOWCONESFILTERS_EXPORT void DropReceivers(TriangleMesh& mesh);
/**
 * Discs as wide as the vectors they were fitted to: figure 5's cosine is taken back where a cone set's field data,
 * @p parameters, tells of it.
 */
SHADOWCONESFILTERS_EXPORT void UndoCosineCorrection(vtkFieldData* parameters, std::vector<Cone>& cones);

/// Shadow vectors as read from a data set; holds what ShadowVectorView points to.
struct SHADOWCONESFILTERS_EXPORT ShadowVectorArrays
{
  std::vector<double> Points;         ///< 3
  std::vector<float> Directions;      ///< 3
  std::vector<double> EmissionPoints; ///< 3; empty where the input has none
  std::vector<int> OccluderIds;       ///< empty where the input has none

  ShadowVectorView View() const;
};

/**
 * Read shadow vectors: "Direction" is required, "OccluderId" is optional, "EmissionPoint" is optional unless
 * @p needEmissionPoints. @return false, with a sentence in @p error that names the array or the vector at fault.
 */
SHADOWCONESFILTERS_EXPORT bool ReadShadowVectors(
  vtkPolyData* input, ShadowVectorArrays& vectors, std::string& error, bool needEmissionPoints = false);

/// Photon paths as read from a data set; holds what PhotonPathView points to.
struct SHADOWCONESFILTERS_EXPORT PhotonPathArrays
{
  std::vector<double> Points;         ///< 3, where the path ends
  std::vector<double> EmissionPoints; ///< 3
  std::vector<float> Directions;      ///< 3
  std::vector<int> States;            ///< 0 lit, 1 blocked

  PhotonPathView View() const;
};

/**
 * Read photon paths: "PathState" (0 or 1), "EmissionPoint" and "Direction", one tuple a point. @return false, with a
 * sentence in @p error that names the array or the path at fault.
 */
SHADOWCONESFILTERS_EXPORT bool ReadPhotonPaths(vtkPolyData* input, PhotonPathArrays& paths, std::string& error);

/// Every point array has a value for each point, so that it can be passed on. @return false, with a sentence in @p error.
SHADOWCONESFILTERS_EXPORT bool CheckPointArrays(vtkPolyData* input, std::string& error);

/// A new named array with a copy of values, components a tuple; types as in the name.
SHADOWCONESFILTERS_EXPORT void AddFloatArray(
  vtkFieldData* data, const char* name, int components, const std::vector<float>& values);
SHADOWCONESFILTERS_EXPORT void AddDoubleArray(
  vtkFieldData* data, const char* name, int components, const std::vector<double>& values);
SHADOWCONESFILTERS_EXPORT void AddIntArray(
  vtkFieldData* data, const char* name, int components, const std::vector<int>& values);
SHADOWCONESFILTERS_EXPORT void AddIdArray(vtkFieldData* data, const char* name, const std::vector<vtkIdType>& values);
/// Points in double precision with one vertex cell each.
SHADOWCONESFILTERS_EXPORT void SetVertices(vtkPolyData* output, const std::vector<double>& points);

} // namespace shadowcones

#endif
