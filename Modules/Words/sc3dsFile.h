// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file sc3dsFile.h
 * @brief The triangles of a .3ds file. (VTK's importer makes windows of it.) Internal to the module.
 */
#ifndef sc3dsFile_h
#define sc3dsFile_h

#include <array>
#include <string>
#include <vector>

namespace shadowcones
{

/// All objects of a file together.
struct Mesh3ds
{
  std::vector<std::array<float, 3>> Points;
  std::vector<std::array<int, 3>> Triangles; ///< indices of Points
};

/// Read the bytes of a file. @return false, with what is wrong in @p error, where they are none.
bool Parse3ds(const std::string& bytes, Mesh3ds& mesh, std::string& error);

} // namespace shadowcones

#endif
