// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOutputFile.h
 * @brief Files that are whole or not there: written beside, then renamed.
 */
#ifndef scOutputFile_h
#define scOutputFile_h

#include <functional>
#include <string>

class vtkDataObject;

namespace shadowcones
{
/// Kinds of results, by what a file of them may be.
enum class FileKind
{
  Points,  ///< points with arrays: csv, vtp; of grids vti
  Surface, ///< triangles: stl, ply, obj, vtp
  Picture  ///< images: png, tif, vti
};

/**
 * Whether a result may be written there, before the work begins: throws a Failure that names the extensions where the one of @p path is
 * none of the kind, and one that says why where the file cannot be made.
 */
void CheckOutput(const std::string& path, FileKind kind);

/// Write a data object in the format of the extension of @p path. Throws a Failure, and leaves what was there, where that fails.
void WriteOutput(vtkDataObject* data, const std::string& path);

/// Call @p write with the name of a file beside @p path, then give it that name. @param write  false where it could not
void WriteBeside(const std::string& path, const std::function<bool(const std::string& beside)>& write);

/// Points or cells with all their arrays as comma-separated values. @param cells  the cells' centres and arrays
std::string MakeTable(vtkDataObject* data, bool cells);
} // namespace shadowcones

#endif
