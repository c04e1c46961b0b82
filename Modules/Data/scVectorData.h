// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVectorData.h
 * @brief Shadow vectors, photon paths and shadow photons as poly data.
 */
#ifndef scVectorData_h
#define scVectorData_h

#include "ShadowConesDataModule.h"
#include "scFilterRun.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"
#include "scShadowVectors.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace shadowcones
{

/// Shadow vectors as read from a data set; holds what ShadowVectorView points to.
struct SHADOWCONESDATA_EXPORT ShadowVectorArrays
{
  std::vector<double> Points;         ///< 3
  std::vector<float> Directions;      ///< 3
  std::vector<double> EmissionPoints; ///< 3; empty where the input has none
  std::vector<int> OccluderIds;       ///< empty where the input has none
  std::vector<int> LightIds;          ///< empty where the input has none: all 0

  ShadowVectorView View() const;
};

/**
 * Read shadow vectors: "Direction" is required, "OccluderId" and "LightId" are optional, "EmissionPoint" is optional
 * unless @p needEmissionPoints. @return false, with a sentence in @p error that names the array or the vector at fault.
 */
SHADOWCONESDATA_EXPORT bool ReadShadowVectors(
  vtkPolyData* input, ShadowVectorArrays& vectors, std::string& error, bool needEmissionPoints = false);

/// Photon paths as read from a data set; holds what PhotonPathView points to.
struct SHADOWCONESDATA_EXPORT PhotonPathArrays
{
  std::vector<double> Points;         ///< 3, where the path ends
  std::vector<double> EmissionPoints; ///< 3
  std::vector<float> Directions;      ///< 3
  std::vector<int> States;            ///< 0 lit, 1 blocked
  std::vector<int> LightIds;          ///< empty where the input has none: all 0

  PhotonPathView View() const;
};

/**
 * Read photon paths: "PathState" (0 or 1), "EmissionPoint", "Direction" and, optional, "LightId", one tuple a point.
 * @return false, with a sentence in @p error that names the array or the path at fault.
 */
SHADOWCONESDATA_EXPORT bool ReadPhotonPaths(vtkPolyData* input, PhotonPathArrays& paths, std::string& error);

/// Write the documented arrays of shadow vectors, photon paths and shadow photons, a vertex each. What is written is freed.
SHADOWCONESDATA_EXPORT void WriteShadowVectors(ShadowVectors& vectors, vtkPolyData* output);
SHADOWCONESDATA_EXPORT void WritePhotonPaths(PhotonPaths& paths, vtkPolyData* output);
SHADOWCONESDATA_EXPORT void WriteShadowPhotons(ShadowPhotons& photons, vtkPolyData* output);

/// Write the vectors of @p input that the piece holds, with all their arrays and the cone of each, "ConeId".
SHADOWCONESDATA_EXPORT void WriteLabelledVectors(
  vtkPolyData* input, const std::vector<vtkIdType>& coneIds, const PieceRequest& piece, vtkPolyData* output);

} // namespace shadowcones

#endif
