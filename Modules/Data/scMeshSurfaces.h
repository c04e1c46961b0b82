// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshSurfaces.h
 * @brief Any data set, or blocks of any data sets, as the poly data of their outer surfaces.
 */
#ifndef scMeshSurfaces_h
#define scMeshSurfaces_h

#include "ShadowConesDataModule.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkDataObject;
class vtkInformation;

namespace shadowcones
{

/// Let an input port take every data set and composite data, which reach the filter as a whole.
SHADOWCONESDATA_EXPORT void AcceptDataSets(vtkInformation* portInformation);

/**
 * The mesh of what such a port was given: poly data as they are; of other data sets the faces that belong to one cell
 * alone, and cells that are faces, with the arrays of their points and cells and "vtkOriginalCellIds" (id), the cell
 * that each belongs to. Nonlinear faces become triangles through their points. Cells that "vtkGhostType" marks as
 * duplicate or hidden, and cells that use a hidden point, are not there, so that what they hid is seen. Blocks keep
 * their order and names; adaptive grids become a multiblock. @p extracted counts the data sets that were no poly data.
 * @return nullptr, with a sentence in @p error, where there is no data set in it.
 */
SHADOWCONESDATA_EXPORT vtkSmartPointer<vtkDataObject> SurfacesOf(
  vtkDataObject* input, vtkIdType& extracted, std::string& error);

} // namespace shadowcones

#endif
