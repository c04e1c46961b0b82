// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFingerprints.h
 * @brief What an output was made from, so that inputs that do not belong together are noticed.
 */
#ifndef scFingerprints_h
#define scFingerprints_h

#include "ShadowConesDataModule.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkFieldData;

namespace shadowcones
{

class Warnings;
struct TriangleMesh;

constexpr const char* castersFingerprint = "CastersFingerprint";
constexpr const char* lightFingerprint = "LightFingerprint";

/**
 * A number for the casting triangles of a mesh: of the set of their corners' places, whatever the order of triangles and
 * corners, the winding, the labels, and however often a triangle is there. Receivers and triangles without area do not
 * count; without casters it is 0.
 */
SHADOWCONESDATA_EXPORT std::uint64_t CastersFingerprintOf(const TriangleMesh& mesh);

/// Add fingerprints as field data (vtkTypeUInt64Array, one component); nothing where there is none.
SHADOWCONESDATA_EXPORT void WriteFingerprints(
  const char* name, const std::vector<std::uint64_t>& fingerprints, vtkFieldData* data);
/// The fingerprints of that name; none where there is no such array.
SHADOWCONESDATA_EXPORT std::vector<std::uint64_t> ReadFingerprints(const char* name, vtkFieldData* data);

/**
 * Compare what an input says that it was made from with what is there. @return a warning, where they differ; empty where
 * they do not or where the input does not say. @p input names it with its port, @p from what it was made from, as in "The
 * cone set on input port 1" and "casters than those of the mesh on input port 3".
 */
SHADOWCONESDATA_EXPORT std::string CompareFingerprints(const char* name, vtkFieldData* data,
  const std::vector<std::uint64_t>& own, const std::string& input, const std::string& from);

/**
 * Warns where the field data @p made, of what @p input names as above, tell of other casters than those of the mesh on input
 * port @p meshPort, whose fingerprint is @p casters. @return that one.
 */
SHADOWCONESDATA_EXPORT std::uint64_t CompareCasters(
  std::uint64_t casters, int meshPort, vtkFieldData* made, const std::string& input, Warnings& warnings);

} // namespace shadowcones

#endif
