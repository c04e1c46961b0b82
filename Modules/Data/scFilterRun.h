// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFilterRun.h
 * @brief What every filter shares: progress and abort, piece and time requests, inputs that every process has as a whole.
 */
#ifndef scFilterRun_h
#define scFilterRun_h

#include "ShadowConesDataModule.h"
#include "scParallel.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace shadowcones
{
class Ranks;
class Team;

/// Is a filter to stop? VTK 9.3 asks what stands before and behind it too; before, a filter has a flag of its own.
template <typename Algorithm>
auto IsToStop(Algorithm* algorithm, int) -> decltype(algorithm->CheckAbort())
{
  return algorithm->CheckAbort();
}
template <typename Algorithm>
bool IsToStop(Algorithm* algorithm, long)
{
  return algorithm->GetAbortExecute() != 0;
}

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

/**
 * Tell the pipeline of an image of these dimensions, of which any extent can be asked for. It fills @p bounds; along an axis on
 * which these do not ascend, and without them, it has the origin 0 and the spacing 1.
 */
SHADOWCONESDATA_EXPORT void OfferImage(
  vtkInformation* outputInformation, const int dimensions[3], const double* bounds);

/**
 * Tell the pipeline at which times every output can be asked for: at the steps of all inputs, in ascending order and without
 * repeats; the range is the least that holds all of theirs. No time where no input has any. (The pipeline itself looks at
 * the first input alone, and does not run a filter again for another time unless the filter offers times.) An input on port
 * @p timeless is the same at every time, and does not count.
 */
SHADOWCONESDATA_EXPORT void OfferTimes(vtkAlgorithm* algorithm, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int timeless = -1);

/**
 * Ask every input from @p firstPort on for all of its data, images for their whole extent; together with other processes
 * where this filter is run so, see scRanks.h.
 */
SHADOWCONESDATA_EXPORT void RequestWholeInputs(vtkAlgorithm* algorithm, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, int firstPort = 0);

/**
 * Bring all inputs up to date, whole and at their first time: for a RequestInformation that has to look at data. The time
 * that was asked of them before is asked of them after.
 */
SHADOWCONESDATA_EXPORT void UpdateInputs(vtkAlgorithm* algorithm, vtkInformationVector** inputVector);

/// Leave nothing in an output but its kind of extent, by which the pipeline asks for the next one.
SHADOWCONESDATA_EXPORT void EmptyOutput(vtkDataObject* output);

/// The same for every output that there is.
SHADOWCONESDATA_EXPORT void EmptyOutputs(vtkInformationVector* outputs);

/// The part of an image's whole extent that is asked for. @return false where that has no point.
SHADOWCONESDATA_EXPORT bool RequestedExtent(vtkInformation* outputInformation, int extent[6]);

/**
 * One RequestData of a filter: made at its beginning, where it empties images, of which the pipeline keeps the scalars of the
 * run before. At its end every output is stamped with the time it stands for, and processes that have run it together tell
 * each other how it went: where it failed in one there are no outputs in any.
 */
class SHADOWCONESDATA_EXPORT FilterRun
{
public:
  FilterRun(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  ~FilterRun();
  FilterRun(const FilterRun&) = delete;
  FilterRun& operator=(const FilterRun&) = delete;

  /**
   * Are the inputs from @p firstPort on the same in every process? Filters need them whole: an answer from the part that one
   * process has would be wrong. Asked where processes run the filter together (see scRanks.h): in all of them, as in
   * ParaView, and before anything that could fail in one of them only. Not asked where the pipeline runs the filter for each
   * block of a composite input: processes may have unlike numbers of blocks.
   * @return false, with a sentence in @p error that names the port and says what to do.
   */
  bool AreInputsWhole(std::string& error, int firstPort = 0) const;

  /// Those who run the filter together, once AreInputsWhole() was asked; nullptr: this process alone.
  Team* GetTeam() const;
  /// The same, where the input at this port is the same in all: each may then answer for a share of it. Else nullptr.
  Team* GetTeamOn(int port) const;

  /**
   * Say what is wrong by vtkErrorMacro of the filter, and empty the outputs. @return what RequestData is to return: 0; where others run it too 1,
   * so that filters behind it, which meet, run in all processes or in none.
   */
  int Fail(const std::string& error) const;

private:
  void Agree();

  vtkAlgorithm* Algorithm;
  vtkInformation* Request;
  vtkInformationVector** Inputs;
  vtkInformationVector* Outputs;
  mutable std::unique_ptr<Ranks> Members;
  mutable std::vector<bool> Same; ///< input ports that hold the same data in all processes
  mutable bool Failed = false;
};

} // namespace shadowcones

#endif
