// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightData.h
 * @brief Lights as poly data: the field arrays that carry the exact shape, written and read.
 */
#ifndef scLightData_h
#define scLightData_h

#include "ShadowConesDataModule.h"
#include "scLight.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkFieldData;
class vtkPolyData;

namespace shadowcones
{

/**
 * Add the exact shape to the field data of @p output: "LightShape" (int 1), "LightCenter", "LightNormal" (double 3),
 * "LightAxes" (double, two tuples of 3: Rectangle's half edges), "LightRadius" (double 1), "LightSpectrum" (double, one
 * a wavelength sample).
 */
SHADOWCONESDATA_EXPORT void WriteLightFieldData(const Light& light, vtkDataObject* output);

/**
 * Write a Sun: a vertex at its centre, which stands for it on the screen, with its direction as active normals "Normals" (double
 * 3), which transforms turn, and the field data of its exact shape.
 */
SHADOWCONESDATA_EXPORT void WriteSun(const Light& sun, vtkPolyData* output);

/// Add "LightFingerprint" (unsigned 64-bit, one value a light: FingerprintOf) to the field data of an output.
SHADOWCONESDATA_EXPORT void WriteLightFingerprints(const std::vector<Light>& lights, vtkDataObject* output);
/// What WriteLightFingerprints wrote; none where there is no such array.
SHADOWCONESDATA_EXPORT std::vector<std::uint64_t> ReadLightFingerprints(vtkFieldData* data);

/**
 * Tell in the field data of an output which lights it is of, and nothing of other lights: their exact shapes as above
 * and "LightFingerprint" (see WriteLightFingerprints). Several lights have a tuple each ("LightAxes": 6 components,
 * "LightSpectrum": one a wavelength); a mesh among them has "LightShape" 5, and one alone has no shape at all.
 */
SHADOWCONESDATA_EXPORT void WriteLights(const std::vector<Light>& lights, vtkDataObject* output);
/// The exact shapes that WriteLights wrote; a mesh has no triangles. None where there is no "LightShape".
SHADOWCONESDATA_EXPORT bool ReadLightShapes(vtkFieldData* data, std::vector<Light>& lights, std::string& error);
/// Take the arrays of a light away, from data that are none or that belong to another one: they ride along with meshes.
SHADOWCONESDATA_EXPORT void RemoveLightFieldData(vtkFieldData* data);

/**
 * Read a light and prepare it for sampling: from the field data where "LightShape" is there, else every polygon of the mesh
 * emits along its normal, and without polygons every vertex is a point light. A mesh's spectrum is its field array
 * "LightSpectrum", or 1 at each of seven samples.
 *
 * An exact shape is believed where it fits the mesh, to rounding of the points' type, or where there is no mesh. A mesh
 * that was moved, turned or scaled as a whole gives its shape a new place and size. Otherwise (a part cut off, two
 * lamps joined, stretched) its polygons shine, and @p warning says what does not fit and by how much. A Sun is one
 * vertex, whose place does not matter; its direction is that of the vertex' normal where it has one that was turned,
 * else a vertex that was moved warns.
 *
 * @return false, with a sentence in @p error, where there is no light: null or empty input, zero area, a value that is
 * not finite, a field array missing or of the wrong size, an exact shape without what it is the shape of.
 */
SHADOWCONESDATA_EXPORT bool ReadLight(
  vtkPolyData* input, Light& light, std::string& error, std::string* warning = nullptr);

/// The wavelengths in nm where a light or an image says so ("LightWavelengths"), else the default ones for so many samples.
/// @return false, with a sentence in @p error, where one is not a number above 0.
SHADOWCONESDATA_EXPORT bool ReadWavelengths(
  vtkDataObject* data, std::size_t count, std::vector<double>& wavelengths, std::string& error);

} // namespace shadowcones

#endif
