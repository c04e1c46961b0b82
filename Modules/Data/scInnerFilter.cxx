// SPDX-License-Identifier: BSD-3-Clause
#include "scInnerFilter.h"

#include "scFilterRun.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

namespace shadowcones
{
namespace
{
struct Watch
{
  vtkAlgorithm* Inner;
  vtkAlgorithm* Outer;
  double From;
  double To;
  InnerRun* Run;
};

void Observe(vtkObject*, unsigned long event, void* data, void* message)
{
  const Watch& watch = *static_cast<Watch*>(data);
  if (event == vtkCommand::ErrorEvent)
  {
    if (watch.Run->Error.empty())
    {
      watch.Run->Error = PlainMessage(static_cast<const char*>(message));
    }
  }
  else if (event == vtkCommand::WarningEvent)
  {
    watch.Run->Said.Add(PlainMessage(static_cast<const char*>(message)));
  }
  else
  {
    watch.Outer->UpdateProgress(watch.From + (watch.To - watch.From) * watch.Inner->GetProgress());
    if (IsToStop(watch.Outer, 0))
    {
      watch.Inner->SetAbortExecute(1);
      watch.Run->Aborted = true;
    }
  }
}
} // anonymous namespace

std::string PlainMessage(const char* message)
{
  std::string text = message ? message : "";
  const std::size_t place = text.find("): ");
  const std::size_t name = text.rfind("vtk", place);
  if (place != std::string::npos && name != std::string::npos)
  {
    const std::string kind = text.substr(name, text.find(' ', name) - name);
    text = kind + ": " + text.substr(place + 3);
  }
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

void UpdateInside(vtkAlgorithm* inner, vtkAlgorithm* outer, double from, double to, InnerRun& run)
{
  if (!run.IsDone())
  {
    return;
  }
  Watch watch{ inner, outer, from, to, &run };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(Observe);
  observer->SetClientData(&watch);
  inner->AddObserver(vtkCommand::ProgressEvent, observer);
  for (vtkObject* speaker : { static_cast<vtkObject*>(inner), static_cast<vtkObject*>(inner->GetExecutive()) })
  {
    speaker->AddObserver(vtkCommand::ErrorEvent, observer);
    speaker->AddObserver(vtkCommand::WarningEvent, observer);
  }
  inner->Update();
  inner->RemoveObserver(observer);
  inner->GetExecutive()->RemoveObserver(observer);
}

} // namespace shadowcones
