// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCellPoints.h
 * @brief Do cells use points that are there? Asked before VTK is given data that nobody has looked at.
 */
#ifndef scCellPoints_h
#define scCellPoints_h

#include "ShadowConesDataModule.h"

#include <string>

class vtkDataObject;

namespace shadowcones
{

/**
 * Look at every cell of poly data and of unstructured grids, alone or in composite data; cells of other data sets are not listed.
 * @return false, with a sentence in @p error, at the first cell that uses a point that is not there, or of which it is not
 * known where it ends.
 */
SHADOWCONESDATA_EXPORT bool CheckCellPoints(vtkDataObject* data, std::string& error);

} // namespace shadowcones

#endif
