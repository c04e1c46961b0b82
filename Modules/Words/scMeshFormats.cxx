// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshFormats.h"

#include <algorithm>

namespace shadowcones
{

namespace
{

std::string FileNameOf(const std::string& path)
{
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

} // namespace

const std::vector<std::string>& MeshFormats()
{
  static const std::vector<std::string> formats{ "vtp", "vtk", "vtu", "ply", "stl", "obj", "3ds", "gltf", "glb" };
  return formats;
}

std::string ExtensionOf(const std::string& path)
{
  const std::string name = FileNameOf(path);
  const std::size_t dot = name.find_last_of('.');
  std::string extension = dot == std::string::npos ? std::string() : name.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

bool IsMeshFileName(const std::string& path)
{
  const std::vector<std::string>& formats = MeshFormats();
  return std::find(formats.begin(), formats.end(), ExtensionOf(path)) != formats.end();
}

std::string StemOf(const std::string& path)
{
  const std::string name = FileNameOf(path);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

} // namespace shadowcones
