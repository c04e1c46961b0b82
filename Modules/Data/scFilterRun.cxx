// SPDX-License-Identifier: BSD-3-Clause
#include "scFilterRun.h"

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace shadowcones
{

Monitor MonitorOf(vtkAlgorithm* algorithm)
{
  Monitor monitor;
  monitor.Progress = [algorithm](double share) { algorithm->UpdateProgress(share); };
  monitor.Aborted = [algorithm]() { return algorithm->GetAbortExecute() != 0; };
  return monitor;
}

PieceRequest RequestedPiece(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = std::max(request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT()), 0);
  vtkInformation* info = outputVector->GetInformationObject(port);
  PieceRequest piece;
  if (info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    piece.NumberOfPieces = std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
    piece.Piece =
      std::clamp(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()), 0, piece.NumberOfPieces - 1);
  }
  return piece;
}

void HandlePieces(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
}

void RequestWholeInputs(vtkAlgorithm* algorithm, vtkInformationVector** inputVector, int firstPort)
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
