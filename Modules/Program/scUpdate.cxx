// SPDX-License-Identifier: BSD-3-Clause
#include "scUpdate.h"

#include "scFailure.h"
#include "scInnerFilter.h"
#include "scTerminal.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace
{
using shadowcones::PlainMessage;
using shadowcones::ProgressBar;

/// What the observer of one update knows.
struct Watch
{
  std::vector<vtkAlgorithm*> Chain;
  ProgressBar* Bar;
  bool Quiet;
  std::string Error;
};

void CollectUpstream(vtkAlgorithm* filter, std::vector<vtkAlgorithm*>& chain)
{
  if (std::find(chain.begin(), chain.end(), filter) != chain.end())
  {
    return;
  }
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int index = 0; index < filter->GetNumberOfInputConnections(port); ++index)
    {
      CollectUpstream(filter->GetInputConnection(port, index)->GetProducer(), chain);
    }
  }
  chain.push_back(filter);
}

void Observe(vtkObject* caller, unsigned long event, void* data, void* message)
{
  Watch* watch = static_cast<Watch*>(data);
  if (event == vtkCommand::ErrorEvent)
  {
    if (watch->Error.empty())
    {
      watch->Error = PlainMessage(static_cast<const char*>(message));
    }
    return;
  }
  if (event == vtkCommand::WarningEvent)
  {
    if (!watch->Quiet)
    {
      std::fprintf(stderr, "\rwarning: %s\n", PlainMessage(static_cast<const char*>(message)).c_str());
    }
    return;
  }
  if (shadowcones::IsInterrupted())
  {
    for (vtkAlgorithm* filter : watch->Chain)
    {
      filter->SetAbortExecute(1);
    }
  }
  if (caller == watch->Chain.back())
  {
    watch->Bar->Show(static_cast<vtkAlgorithm*>(caller)->GetProgress());
  }
}
} // namespace

namespace shadowcones
{
void Update(vtkAlgorithm* filter, const std::string& step, bool quiet)
{
  ProgressBar bar(step, quiet);
  Watch watch{ {}, &bar, quiet, {} };
  CollectUpstream(filter, watch.Chain);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(Observe);
  observer->SetClientData(&watch);
  std::vector<std::pair<vtkAlgorithm*, unsigned long>> observed;
  for (vtkAlgorithm* member : watch.Chain)
  {
    for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      observed.emplace_back(member, member->AddObserver(event, observer));
    }
  }
  filter->Update();
  for (const auto& [member, tag] : observed)
  {
    member->RemoveObserver(tag);
  }

  if (IsInterrupted())
  {
    throw Failure("interrupted; nothing was written", ExitInterrupted);
  }
  if (!watch.Error.empty())
  {
    throw Failure(watch.Error);
  }
  bar.Finish();
}
} // namespace shadowcones
