// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSeedCovering.h
 * @brief Seeds in index order, each covering vectors around it by a cone. Internal to Core.
 */
#ifndef scSeedCovering_h
#define scSeedCovering_h

#include "scCone.h"
#include "scConeSet.h"
#include "scNearestVectors.h"
#include "scParallel.h"
#include "scTeam.h"

#include <functional>
#include <map>
#include <vector>

namespace shadowcones
{

/// What a seed would have.
struct ConeCandidate
{
  std::vector<vtkIdType> Neighbors; ///< living ones that it was made from; empty where they do not die
  std::vector<vtkIdType> Members;   ///< vectors that its cone covers; none: it makes no cone
  double Radius = 0.0;              ///< about that of its members around it
  shadowcones::Cone Cone;
};

/// How a seed makes a candidate: of the vectors, and of who lives. Called side by side.
using CandidateMaker = std::function<void(vtkIdType seed, ConeCandidate& candidate)>;

/// Candidates as bytes, for other processes.
struct ConeProposals
{
  struct Header
  {
    vtkIdType Seed = 0;
    double Radius = 0.0;
    int NumberOfNeighbors = 0;
    int NumberOfMembers = 0;
  };
  std::vector<Header> Headers;
  std::vector<int> Ids; ///< of each its neighbours, then its members
  std::vector<Cone> Cones;     ///< of those with members
  std::vector<vtkIdType> Ends; ///< how far each process came

  void AddTo(TeamJoin& join);
  void Add(vtkIdType seed, const ConeCandidate& candidate);
};

/**
 * The greedy covering of section 3.2.1. Every vector that is not covered yet is a seed once, in order of indices, and what its
 * cone covers is none any more. With vectors that die, those covered are no neighbours either.
 *
 * Candidates of some seeds are made side by side from the state before them, and taken when it is their turn; one whose
 * neighbours died meanwhile is made again. The result is that of one seed after the other, for any number of threads.
 *
 * Processes of a team do the same with places: the seeds of a window are dealt out by where they lie, each process covers its
 * own as if there were no others, and then all take what all propose, in order of indices. What a seed of another
 * process spoiled, which happens where their places meet, is made again by each.
 */
class SeedCovering
{
public:
  /// @param dying who dies where it is covered; nullptr: nobody does, and candidates are functions of their seeds alone.
  SeedCovering(const double* points, const CandidateMaker& make, NearestVectors* dying, Team* workers, ConeSet& result);

  /// Vectors of the result that have a cone are covered already. @return false where aborted.
  bool Run(const Monitor& monitor);

private:
  /// Seeds that processes share.
  struct Window
  {
    vtkIdType First = 0;
    vtkIdType End = 0;
    std::vector<int> Owners; ///< of each, -1 where it is no seed
  };
  class Replay;

  Vector3 PointOf(vtkIdType id) const
  {
    return { this->Points[3 * id], this->Points[3 * id + 1], this->Points[3 * id + 2] };
  }
  bool IsSeed(vtkIdType id) const;
  void ChooseSeeds(std::vector<vtkIdType>& seeds) const;
  bool TakeSeeds(vtkIdType end, const Monitor& monitor);
  void TakeInTurn(vtkIdType end);
  void Take(vtkIdType seed, ConeCandidate& candidate);
  void Accept(vtkIdType seed, const ConeCandidate& candidate);
  bool IsAlive(const std::vector<vtkIdType>& ids) const;
  bool Prune();
  bool IsEnough() const;
  bool RunTogether(const Monitor& monitor);
  Window NextWindow() const;
  bool Propose(const Window& window, const Monitor& monitor, ConeProposals& proposals);
  bool TakeProposals(const Window& window, const ConeProposals& proposals, const Monitor& monitor);

  const double* Points;
  const CandidateMaker& Make;
  NearestVectors* Dying;
  Team* Workers;
  ConeSet& Result;
  vtkIdType Count;
  std::vector<unsigned char> Covered;         ///< no longer a seed
  vtkIdType Next = 0;                         ///< seeds before it had their turn
  std::map<vtkIdType, ConeCandidate> Waiting; ///< of seeds whose turn comes
  double SumOfRadii = 0.0;                    ///< of all bases
  vtkIdType NumberOfBases = 0;
  // While this process proposes:
  const Window* Own = nullptr;
  ConeProposals* Proposed = nullptr;
  std::vector<vtkIdType> ToUncover;
  vtkIdType Spare = 0; ///< deaths until the tree is built anew
};

} // namespace shadowcones

#endif
