// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSceneLights.h
 * @brief The lights of an input port: several connections, or the blocks of a composite.
 */
#ifndef scSceneLights_h
#define scSceneLights_h

#include "ShadowConesDataModule.h"
#include "scCone.h"
#include "scLight.h"
#include "scVisibilityGrid.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkInformation;
class vtkInformationVector;
class vtkPolyData;

namespace shadowcones
{

struct TriangleMesh;

/// All lights of a scene, in the order of connections and blocks: the k-th has the "LightId" k.
struct SHADOWCONESDATA_EXPORT SceneLights
{
  std::vector<Light> Lights;
  std::vector<double> Wavelengths;   ///< nm
  Box Bounds;                        ///< of the points of those that are not at infinity
  std::vector<std::string> Warnings; ///< sentences that a user must see
};

/// What a port of lights takes: any number of connections, each a poly data or a composite of them; or none.
SHADOWCONESDATA_EXPORT void FillLightPortInformation(vtkInformation* info);

/**
 * What a port takes of a filter that knows a mesh and lights: one of these, or else data of the class @p other. All are
 * optional to the pipeline: RequestData says what to connect.
 */
SHADOWCONESDATA_EXPORT void FillScenePortInformation(
  int port, int meshPort, int lightPort, const char* other, vtkInformation* info);

/**
 * Read the lights of a port, see ReadLight. Blocks that are not there are left out. @return false, with a sentence in
 * @p error: no light at all, a block that is no poly data, a fault of a light, or lights that differ in their
 * wavelengths.
 */
SHADOWCONESDATA_EXPORT bool ReadLights(vtkInformationVector* port, SceneLights& lights, std::string& error);

/**
 * Give cones read from @p coneSet the "LightId" of the connected light that they were made with: by "LightFingerprint",
 * or where the set has none (or other ones, which warns) by their number. Cones of lights that are not connected have
 * -1 or another id that is no light's. Cones without "LightId" are repeated for each of several lights, which warns.
 */
SHADOWCONESDATA_EXPORT void AssignCones(vtkPolyData* coneSet, SceneLights& lights, std::vector<Cone>& cones);

/**
 * Are cones, as they were read from @p coneSet and before AssignCones, proved for these casters and lights, in whatever
 * order these come? @param changed gets a sentence where the set says so of other cones than these, those of @p input ("The
 * cone set on input port 1").
 */
SHADOWCONESDATA_EXPORT bool AreProved(vtkPolyData* coneSet, const std::vector<Cone>& cones, const TriangleMesh& mesh,
  const std::vector<Light>& lights, const char* input, std::string& changed);

/**
 * Put the grids of a visibility volume in the order of the lights: by "LightFingerprint", or where there is none (or
 * other ones, which warns) as they are. @return false, with a sentence in @p error, where a light has no grid.
 */
SHADOWCONESDATA_EXPORT bool AssignGrids(
  vtkFieldData* volume, SceneLights& lights, std::vector<VisibilityGrid>& grids, std::string& error);

} // namespace shadowcones

#endif
