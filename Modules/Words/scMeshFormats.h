// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshFormats.h
 * @brief Names of files of meshes. Internal to the module.
 */
#ifndef scMeshFormats_h
#define scMeshFormats_h

#include <string>
#include <vector>

namespace shadowcones
{

/// Extensions of the formats that are read, in lower case and without the dot.
const std::vector<std::string>& MeshFormats();

/// The extension of a file's name in lower case and without the dot; empty where there is none.
std::string ExtensionOf(const std::string& path);

/// Does the file's name say that it holds a mesh?
bool IsMeshFileName(const std::string& path);

/// The file's name without folders and extension.
std::string StemOf(const std::string& path);

} // namespace shadowcones

#endif
