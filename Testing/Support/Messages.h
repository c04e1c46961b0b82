// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Messages.h
 * @brief What filters say, kept instead of printed, and their progress.
 */
#ifndef Messages_h
#define Messages_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <utility>

namespace shadowcones
{
namespace testsupport
{

/// Collects the errors and warnings of a filter and of its executive.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
    this->Callback->SetClientData(this);
    this->Callback->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* messages = static_cast<Messages*>(self);
        (event == vtkCommand::ErrorEvent ? messages->Errors : messages->Warnings) += static_cast<const char*>(text);
      });
    for (vtkObject* object : this->Speakers())
    {
      object->AddObserver(vtkCommand::ErrorEvent, this->Callback);
      object->AddObserver(vtkCommand::WarningEvent, this->Callback);
    }
  }
  ~Messages()
  {
    for (vtkObject* object : this->Speakers())
    {
      object->RemoveObserver(this->Callback);
    }
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  std::string Errors;
  std::string Warnings;

private:
  std::array<vtkObject*, 2> Speakers() { return { this->Algorithm, this->Algorithm->GetExecutive() }; }

  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<vtkCallbackCommand> Callback;
};

/// The errors of an update; empty where the filter is content.
inline std::string ErrorsOf(vtkAlgorithm* algorithm)
{
  Messages messages(algorithm);
  algorithm->Update();
  return messages.Errors;
}

/// The warnings of an update.
inline std::string WarningsOf(vtkAlgorithm* algorithm)
{
  Messages messages(algorithm);
  algorithm->Update();
  return messages.Warnings;
}

/// Calls a function at every ProgressEvent.
class OnProgress
{
public:
  OnProgress(vtkAlgorithm* filter, std::function<void(vtkAlgorithm*)> call)
    : Filter(filter)
    , Call(std::move(call))
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*)
      {
        auto* observer = static_cast<OnProgress*>(self);
        observer->Call(observer->Filter);
      });
    this->Tag = filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
  ~OnProgress() { this->Filter->RemoveObserver(this->Tag); }
  OnProgress(const OnProgress&) = delete;
  OnProgress& operator=(const OnProgress&) = delete;

private:
  vtkAlgorithm* Filter;
  std::function<void(vtkAlgorithm*)> Call;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag = 0;
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "said: " << (text)

} // namespace testsupport
} // namespace shadowcones

#endif
