// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshFile.h
 * @brief One file of a mesh, read so that a broken one is an error and never a crash. Internal to the module.
 */
#ifndef scMeshFile_h
#define scMeshFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace shadowcones
{

/**
 * The polygons of a file, those of fewer than three corners left out; of volumes their surface, of several objects all together. VTK's readers work in a process of
 * their own, since some of them crash on broken files. @return nullptr, with a sentence in @p error that names the file, where there are none.
 */
vtkSmartPointer<vtkPolyData> ReadMeshFile(const std::string& path, std::string& error);

} // namespace shadowcones

#endif
