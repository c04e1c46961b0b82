// SPDX-License-Identifier: BSD-3-Clause
// What every filter promises to the pipeline: times on any input port, and inputs that are whole in every process.
#include "Cases.h"
#include "Messages.h"

#include "scTeam.h"

#include "vtkDummyCommunicator.h"
#include "vtkDummyController.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <vector>

using namespace invariants;
using namespace shadowcones::testsupport;
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{

/// A source of one data object that offers times, and notes for which it was run.
class TimedSource : public vtkAlgorithm
{
public:
  static TimedSource* New();
  vtkTypeMacro(TimedSource, vtkAlgorithm);

  vtkSmartPointer<vtkDataObject> Data;
  std::vector<double> Steps;
  std::vector<double> Range;
  std::vector<double> Asked;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) && !info->Has(vtkDataObject::DATA_OBJECT()))
    {
      info->Set(vtkDataObject::DATA_OBJECT(), vtk::TakeSmartPointer(this->Data->NewInstance()));
    }
    else if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
    {
      this->Describe(info);
    }
    else if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
    {
      const double time = info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : -1.0;
      this->Asked.push_back(time);
      vtkDataObject* output = vtkDataObject::GetData(info);
      output->ShallowCopy(this->Data);
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    }
    return 1;
  }

protected:
  TimedSource()
  {
    this->SetNumberOfInputPorts(0);
    this->SetNumberOfOutputPorts(1);
  }
  int FillOutputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
    return 1;
  }

private:
  void Describe(vtkInformation* info)
  {
    if (!this->Steps.empty())
    {
      info->Set(Pipeline::TIME_STEPS(), this->Steps.data(), static_cast<int>(this->Steps.size()));
    }
    if (!this->Range.empty())
    {
      info->Set(Pipeline::TIME_RANGE(), this->Range.data(), 2);
    }
    if (auto* image = vtkImageData::SafeDownCast(this->Data))
    {
      info->Set(Pipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
      info->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
      info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
    }
  }
};
vtkStandardNewMacro(TimedSource);

/// A setting with a source at every input port; runs of its filter stop as soon as they report progress.
struct TimedSetting
{
  Setting Own;
  std::vector<vtkSmartPointer<TimedSource>> Sources; ///< of Own.Inputs
  vtkNew<vtkCallbackCommand> Stop;

  explicit TimedSetting(const Case& one)
    : Own(one.Make(Size::Small))
  {
    for (const auto& [port, data] : this->Own.Inputs)
    {
      auto source = vtkSmartPointer<TimedSource>::New();
      source->Data = data;
      this->Own.Filter->SetInputConnection(port, source->GetOutputPort());
      this->Sources.push_back(source);
    }
    this->Stop->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
    this->Own.Filter->AddObserver(vtkCommand::ProgressEvent, this->Stop);
  }

  std::vector<double> Offered(vtkInformationDoubleVectorKey* key, int port)
  {
    vtkInformation* info = this->Own.Filter->GetOutputInformation(port);
    const double* values = info->Get(key);
    return values ? std::vector<double>(values, values + info->Length(key)) : std::vector<double>();
  }

  void ExpectOffers(const std::vector<double>& steps, const std::vector<double>& range)
  {
    this->Own.Filter->UpdateInformation();
    for (int port = 0; port < this->Own.Filter->GetNumberOfOutputPorts(); ++port)
    {
      EXPECT_EQ(this->Offered(Pipeline::TIME_STEPS(), port), steps) << "output port " << port;
      EXPECT_EQ(this->Offered(Pipeline::TIME_RANGE(), port), range) << "output port " << port;
    }
  }

  /// Run for a time. Since 9.2 VTK empties what was stopped, and gives it the time of the first input; whole runs are tried in Python.
  void Ask(double time)
  {
    const int last = this->Own.Filter->GetNumberOfOutputPorts() - 1;
    this->Own.Filter->SetAbortExecute(0);
    this->Own.Filter->UpdateTimeStep(time);
    if (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0))
    {
      return;
    }
    vtkInformation* made = this->Own.Filter->GetOutputDataObject(last)->GetInformation();
    ASSERT_TRUE(made->Has(vtkDataObject::DATA_TIME_STEP()));
    EXPECT_EQ(made->Get(vtkDataObject::DATA_TIME_STEP()), time);
  }
};

/// Two processes; the other one has the bytes of this one, but for the input at one port, and stops where work is to be shared.
class TwoProcesses : public vtkDummyCommunicator
{
public:
  static TwoProcesses* New();
  vtkTypeMacro(TwoProcesses, vtkDummyCommunicator);

  int UnlikePort = -1;
  int Comparisons = 0;

  int AllReduceVoidArray(const void* own, void* all, vtkIdType length, int, int) override
  {
    std::memcpy(all, own, sizeof(int) * static_cast<std::size_t>(length));
    return 1;
  }
  int AllGatherVoidArray(const void* own, void* all, vtkIdType length, int type) override
  {
    if (type == VTK_INT)
    {
      auto* states = static_cast<int*>(all);
      states[0] = *static_cast<const int*>(own);
      states[1] = states[0] == static_cast<int>(shadowcones::TeamState::Joining)
        ? static_cast<int>(shadowcones::TeamState::Stopped)
        : states[0];
      return 1;
    }
    ++this->Comparisons;
    auto* bytes = static_cast<unsigned char*>(all);
    std::memcpy(bytes, own, static_cast<std::size_t>(length));
    std::memcpy(bytes + length, own, static_cast<std::size_t>(length));
    // Inputs that are not compared have no bytes set.
    const unsigned char* unlike = bytes + 8 * std::max(this->UnlikePort, 0);
    if (this->UnlikePort >= 0 && std::any_of(unlike, unlike + 8, [](unsigned char byte) { return byte != 0; }))
    {
      bytes[length + 8 * this->UnlikePort + 3] ^= 0x10;
    }
    return 1;
  }

protected:
  TwoProcesses()
  {
    this->MaximumNumberOfProcesses = 2;
    this->NumberOfProcesses = 2;
  }
};
vtkStandardNewMacro(TwoProcesses);

/// Makes the two processes those of the program, while it lives.
struct Parallel
{
  vtkNew<TwoProcesses> Communicator;
  vtkNew<vtkDummyController> Controller;

  Parallel()
  {
    this->Controller->SetCommunicator(this->Communicator);
    vtkMultiProcessController::SetGlobalController(this->Controller);
  }
  ~Parallel() { vtkMultiProcessController::SetGlobalController(nullptr); }
};

class PipelinePromises : public testing::TestWithParam<Case>
{
};

} // namespace

TEST_P(PipelinePromises, TimesOfAllInputsAreOfferedAndAskedFor)
{
  TimedSetting setting(GetParam());
  Messages messages(setting.Own.Filter);
  if (setting.Sources.empty())
  {
    GTEST_SKIP() << "no inputs";
  }
  setting.ExpectOffers({}, {});
  std::vector<TimedSource*> timed;
  // Each input alone.
  for (std::size_t k = 0; k < setting.Sources.size(); ++k)
  {
    const auto& source = setting.Sources[k];
    const bool timeless = setting.Own.Inputs[k].first == GetParam().TimelessPort;
    source->Steps = { 0.5, 2.0 };
    source->Range = { 0.5, 2.0 };
    source->Modified();
    const std::vector<double> own = timeless ? std::vector<double>() : source->Steps;
    setting.ExpectOffers(own, own);
    for (const double time : { 2.0, 0.5, 1.0 })
    {
      if (!timeless)
      {
        setting.Ask(time);
        EXPECT_EQ(source->Asked.back(), time);
      }
    }
    if (!timeless)
    {
      timed.push_back(source);
    }
    source->Steps.clear();
    source->Range.clear();
    source->GetOutputInformation(0)->Remove(Pipeline::TIME_STEPS());
    source->GetOutputInformation(0)->Remove(Pipeline::TIME_RANGE());
    source->Modified();
  }
  setting.ExpectOffers({}, {});
  // All together: other steps, and one with a range only.
  double k = 0.0;
  for (TimedSource* source : timed)
  {
    source->Steps = { 1.0, 1.5 + k };
    source->Range = { 1.0, 1.5 + k };
    source->Modified();
    k += 1.0;
  }
  std::vector<double> steps{ 1.0 };
  for (double step = 1.5; step < 1.0 + k; step += 1.0)
  {
    steps.push_back(step);
  }
  setting.ExpectOffers(steps, { 1.0, 0.5 + k });
  TimedSource* const last = timed.back();
  last->Steps.clear();
  last->GetOutputInformation(0)->Remove(Pipeline::TIME_STEPS());
  last->Range = { -3.0, 0.25 };
  last->Modified();
  steps.pop_back();
  setting.ExpectOffers(
    steps.size() > 1 ? steps : std::vector<double>(), { -3.0, steps.size() > 1 ? steps.back() : 0.25 });
}

TEST_P(PipelinePromises, AnInputThatIsNotWholeInEveryProcessIsAnError)
{
  if (GetParam().Make(Size::Small).Inputs.empty())
  {
    GTEST_SKIP() << "no inputs";
  }
  Parallel parallel;
  TimedSetting setting(GetParam());
  vtkAlgorithm* filter = setting.Own.Filter;
  const auto said = [&](int piece, int pieces)
  {
    Messages messages(filter);
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->UpdatePiece(piece, pieces, 0);
    return messages.Errors;
  };
  EXPECT_EQ(said(0, 2), ""); // a mesh that every process read
  EXPECT_EQ(parallel.Communicator->Comparisons, 1);
  EXPECT_EQ(said(0, 1), ""); // one process that works alone waits for nobody
  EXPECT_EQ(said(1, 2), "");
  EXPECT_EQ(parallel.Communicator->Comparisons, 1);
  for (const auto& [port, data] : setting.Own.Inputs)
  {
    // What is probed may be spread.
    const bool spread = port == 0 && (filter->IsA("vtkConeSetProbe") || filter->IsA("vtkSunHours"));
    parallel.Communicator->UnlikePort = port;
    const std::string text = said(0, 2);
    const std::string start = "Input port " + std::to_string(port) + " is not the same in all 2 processes: process 1 has ";
    EXPECT_EQ(text.find(start) != std::string::npos, !spread) << text;
    for (int output = 0; output < filter->GetNumberOfOutputPorts(); ++output)
    {
      auto* set = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(output));
      EXPECT_TRUE(spread || !set || set->GetNumberOfPoints() == 0 || set->GetPointData()->GetNumberOfArrays() == 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, PipelinePromises, testing::ValuesIn(AllCases()),
  [](const testing::TestParamInfo<Case>& info) { return info.param.Name; });
