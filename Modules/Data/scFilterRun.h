// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFilterRun.h
 * @brief What every filter shares: progress and abort, piece requests.
 */
#ifndef scFilterRun_h
#define scFilterRun_h

#include "ShadowConesDataModule.h"
#include "scParallel.h"
#include "vtkType.h"

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

namespace shadowcones
{

/// Progress and abort of a filter, as Core sees them.
SHADOWCONESDATA_EXPORT Monitor MonitorOf(vtkAlgorithm* algorithm);

struct PieceRequest
{
  int Piece = 0;
  int NumberOfPieces = 1;

  /// First item of this piece among count; the next piece's first item is its end.
  vtkIdType Begin(vtkIdType count) const { return PieceBound(count, this->Piece, this->NumberOfPieces); }
  vtkIdType End(vtkIdType count) const { return PieceBound(count, this->Piece + 1, this->NumberOfPieces); }
};

/// The piece that is asked of the output port whose update is under way.
SHADOWCONESDATA_EXPORT PieceRequest RequestedPiece(vtkInformation* request, vtkInformationVector* outputVector);

/// Tell the pipeline that every output can be asked for in pieces.
SHADOWCONESDATA_EXPORT void HandlePieces(vtkInformationVector* outputVector);

/// Ask every input from @p firstPort on for all of its data.
SHADOWCONESDATA_EXPORT void RequestWholeInputs(
  vtkAlgorithm* algorithm, vtkInformationVector** inputVector, int firstPort = 0);

} // namespace shadowcones

#endif
