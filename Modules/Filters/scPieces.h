// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPieces.h
 * @brief Piece requests: filters that see their whole input and give out a range of their result. Internal to Filters.
 */
#ifndef scPieces_h
#define scPieces_h

#include "scParallel.h"

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace shadowcones
{

struct PieceRequest
{
  int Piece = 0;
  int NumberOfPieces = 1;

  /// First item of this piece among count; the next piece's first item is its end.
  vtkIdType Begin(vtkIdType count) const { return PieceBound(count, this->Piece, this->NumberOfPieces); }
  vtkIdType End(vtkIdType count) const { return PieceBound(count, this->Piece + 1, this->NumberOfPieces); }
};

/// The piece that is asked of the output port whose update is under way.
inline PieceRequest RequestedPiece(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = std::max(request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT()), 0);
  vtkInformation* info = outputVector->GetInformationObject(port);
  PieceRequest piece;
  if (info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    piece.NumberOfPieces = std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
    piece.Piece = std::clamp(
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()), 0, piece.NumberOfPieces - 1);
  }
  return piece;
}

/// Tell the pipeline that every output can be asked for in pieces.
inline void HandlePieces(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
}

/// Ask every input from @p firstPort on for all of its data.
inline void RequestWholeInputs(vtkAlgorithm* algorithm, vtkInformationVector** inputVector, int firstPort = 0)
{
  for (int port = firstPort; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
}

} // namespace shadowcones

#endif
