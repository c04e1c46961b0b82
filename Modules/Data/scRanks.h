// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRanks.h
 * @brief Processes of vtkMultiProcessController that run a filter together, and what they exchange.
 *
 * A filter is run together where the controller that is global has several processes and this one is asked for the piece of its
 * own rank, as ParaView and parallel programs ask. What such a filter needs as a whole it asks of the filters before it
 * together: in every process they will run, with the same demand, and so can share the work and join the results. A filter that
 * stands already in one of the processes is not asked so, as it would not run there. Where nothing is asked together, as in a
 * script that updates in one process only, nobody waits for anybody.
 */
#ifndef scRanks_h
#define scRanks_h

#include "ShadowConesDataModule.h"
#include "scTeam.h"

#include <vector>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

namespace shadowcones
{

/// What this process did and exchanged in filters that were run together, since it began or was reset.
struct RankWork
{
  vtkIdType Items = 0;           ///< photons, points, sets of parameters
  vtkIdType Rays = 0;            ///< where they are counted
  vtkIdType Meetings = 0;        ///< calls of the controller in which all take part
  vtkIdType Sent = 0;            ///< bytes from this process to all others, each counted once
  vtkIdType Received = 0;        ///< bytes of the others
  double Seconds = 0.0;          ///< in these calls, waiting included
  double ProcessorSeconds = 0.0; ///< of them: most controllers wait busily
};

/// That of this process; may be set to {}.
SHADOWCONESDATA_EXPORT RankWork& WorkOfThisProcess();

/// The processes of a controller.
class SHADOWCONESDATA_EXPORT Ranks : public Team
{
public:
  /// @param controller nullptr: a team of one.
  explicit Ranks(vtkMultiProcessController* controller);

  int GetRank() const override;
  int GetSize() const override;
  std::vector<TeamState> Meet(TeamState own) override;
  std::vector<vtkIdType> GatherNumbers(const std::vector<vtkIdType>& own) override;
  void GatherBytes(const unsigned char* own, const std::vector<vtkIdType>& lengths, unsigned char* all) override;
  void Count(vtkIdType items) override;

  /// Have the processes agreed that this task is over? Behind that nobody listens.
  bool IsOver() const { return this->Over; }
  /// Was any of them stopped, or failed?
  bool IsBroken() const { return this->Broken; }

private:
  vtkMultiProcessController* Controller;
  bool Over = false;
  bool Broken = false;
};

/// The controller of the processes that run the filter together at this request, or nullptr.
SHADOWCONESDATA_EXPORT vtkMultiProcessController* ControllerOfRun(
  vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector);

/// Say of all outputs that their filter can be asked together, and is not yet.
SHADOWCONESDATA_EXPORT void OfferTogether(vtkInformationVector* outputVector);

/// It has been done, or was not: nobody is to find it later.
SHADOWCONESDATA_EXPORT void ForgetTogether(vtkInformationVector* outputVector);

/**
 * Ask the inputs from @p firstPort on together where this filter is run so, and where they will run in all processes. Their
 * requests stand already.
 */
SHADOWCONESDATA_EXPORT void AskTogether(vtkAlgorithm* algorithm, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, int firstPort);

} // namespace shadowcones

#endif
