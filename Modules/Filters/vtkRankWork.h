// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRankWork
 * @brief What this process did, and exchanged with others, in filters that several processes run together.
 *
 * Where the global vtkMultiProcessController has several processes and each asks for the piece of its own rank, filters share
 * their work: each process does a part, and all get what all of them need. This class counts it in this process, since the
 * program began or Reset() was called: to see that work is shared evenly, and what exchanging costs. Nothing is counted in a
 * process that works alone, but rays.
 *
 * @sa vtkShadowVectorFilter, vtkConeSetFilter, vtkVisibilityVolume, vtkConeSetProbe, vtkSunHours, vtkPenumbraWidth
 */
#ifndef vtkRankWork_h
#define vtkRankWork_h

#include "ShadowConesFiltersModule.h"
#include "vtkObject.h"

class SHADOWCONESFILTERS_EXPORT vtkRankWork : public vtkObject
{
public:
  static vtkRankWork* New();
  vtkTypeMacro(vtkRankWork, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Count from 0 again.
  static void Reset();
  /// Photons, points, seeds of cones and sets of parameters that this process did of what is shared.
  static vtkIdType GetNumberOfItems();
  /// Rays that this process sent for grids and images.
  static vtkIdType GetNumberOfRays();
  /// Calls of the controller in which all processes take part.
  static vtkIdType GetNumberOfMeetings();
  /// Bytes that this process gave to the others, each counted once.
  static vtkIdType GetBytesSent();
  /// Bytes that it got of the others.
  static vtkIdType GetBytesReceived();
  /// Seconds in these calls, waiting for the others included.
  static double GetSeconds();
  /// Processor seconds in these calls: MPI mostly waits busily.
  static double GetProcessorSeconds();

protected:
  vtkRankWork() = default;
  ~vtkRankWork() override = default;

private:
  vtkRankWork(const vtkRankWork&) = delete;
  void operator=(const vtkRankWork&) = delete;
};

#endif
