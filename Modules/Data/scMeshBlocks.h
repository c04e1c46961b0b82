// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshBlocks.h
 * @brief Poly data, alone or in composite data of any depth, as a list of surfaces.
 */
#ifndef scMeshBlocks_h
#define scMeshBlocks_h

#include "ShadowConesDataModule.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkPolyData;

namespace shadowcones
{

/// A poly data of an input, the block that it belongs to, and where its points and cells begin among those of all.
struct MeshBlock
{
  vtkPolyData* Data = nullptr; ///< of the input: as long as that lives
  int Number = 0;              ///< partitions of one partitioned data set share it
  std::string Name;            ///< as given, or else that of what holds the block; empty where there is none
  vtkIdType FirstPoint = 0;
  vtkIdType FirstCell = 0;

  /// How messages call it: 3 ("roof").
  std::string Label() const;
};

/**
 * List the poly data of @p input: of itself, or of multiblock data and partitioned collections of any depth, whose empty
 * blocks are left out. @return false, with a sentence in @p error that names the block, where one is no poly data.
 */
SHADOWCONESDATA_EXPORT bool CollectBlocks(vtkDataObject* input, std::vector<MeshBlock>& blocks, std::string& error);

/// Is it composite data whose blocks are to be occluders or lamps of their own, and not pieces of one?
SHADOWCONESDATA_EXPORT bool HasBlocks(vtkDataObject* input);

/// Let an input port take poly data or composites of them, which reach the filter as a whole.
SHADOWCONESDATA_EXPORT void AcceptBlocks(vtkInformation* portInformation);

} // namespace shadowcones

#endif
