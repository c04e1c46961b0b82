// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scGhosts.h
 * @brief Which cells and points are there: what the array "vtkGhostType" marks as hidden, or as another rank's.
 */
#ifndef scGhosts_h
#define scGhosts_h

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace shadowcones
{

/// Marks of cells and points of a data set; without the array none is marked.
class Ghosts
{
public:
  explicit Ghosts(vtkDataSetAttributes* data)
    : Marks(vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName())))
  {
  }

  bool Any() const { return this->Marks != nullptr; }
  /// A cell that is blanked, or refined by other cells.
  bool IsCellHidden(vtkIdType cell) const
  {
    return this->Has(cell, vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL);
  }
  /// A cell that another rank or piece has.
  bool IsCellDuplicate(vtkIdType cell) const { return this->Has(cell, vtkDataSetAttributes::DUPLICATECELL); }
  bool IsPointHidden(vtkIdType point) const { return this->Has(point, vtkDataSetAttributes::HIDDENPOINT); }
  bool IsPointDuplicate(vtkIdType point) const { return this->Has(point, vtkDataSetAttributes::DUPLICATEPOINT); }

private:
  bool Has(vtkIdType item, int marks) const
  {
    return this->Marks && item >= 0 && item < this->Marks->GetNumberOfTuples() && (this->Marks->GetValue(item) & marks) != 0;
  }
  vtkUnsignedCharArray* Marks;
};

} // namespace shadowcones

#endif
