// SPDX-License-Identifier: BSD-3-Clause
#include "scFilterRun.h"

#include "scDataFingerprint.h"
#include "scRanks.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <set>
#include <vector>

namespace shadowcones
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The times that inputs offer.
struct InputTimes
{
  std::set<double> Steps;
  double Range[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };

  bool Empty() const { return this->Range[0] > this->Range[1]; }
  double First() const { return this->Steps.empty() ? this->Range[0] : *this->Steps.begin(); }

  void Add(vtkInformation* info)
  {
    for (int i = 0; i < info->Length(Pipeline::TIME_STEPS()); ++i)
    {
      const double step = info->Get(Pipeline::TIME_STEPS(), i);
      this->Steps.insert(step);
      this->Reach(step);
    }
    for (int i = 0; i < info->Length(Pipeline::TIME_RANGE()); ++i)
    {
      this->Reach(info->Get(Pipeline::TIME_RANGE(), i));
    }
  }

private:
  void Reach(double time)
  {
    this->Range[0] = std::min(this->Range[0], time);
    this->Range[1] = std::max(this->Range[1], time);
  }
};

int RequestedPort(vtkInformation* request)
{
  return std::max(request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT()), 0);
}

template <typename Call>
void ForEachConnection(vtkAlgorithm* algorithm, vtkInformationVector** inputVector, int firstPort, Call call)
{
  for (int port = firstPort; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      call(port, i, inputVector[port]->GetInformationObject(i));
    }
  }
}
} // anonymous namespace

Monitor MonitorOf(vtkAlgorithm* algorithm)
{
  Monitor monitor;
  monitor.Progress = [algorithm](double share) { algorithm->UpdateProgress(share); };
  monitor.Aborted = [algorithm]() { return IsToStop(algorithm, 0); };
  return monitor;
}

PieceRequest RequestedPiece(vtkInformation* request, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(RequestedPort(request));
  PieceRequest piece;
  if (info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    piece.NumberOfPieces = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
    piece.Piece = std::clamp(info->Get(Pipeline::UPDATE_PIECE_NUMBER()), 0, piece.NumberOfPieces - 1);
  }
  return piece;
}

void OfferImage(vtkInformation* outputInformation, const int dimensions[3], const double* bounds)
{
  int whole[6];
  double spacing[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    whole[2 * axis] = 0;
    whole[2 * axis + 1] = dimensions[axis] - 1;
    if (bounds && bounds[2 * axis] < bounds[2 * axis + 1])
    {
      origin[axis] = bounds[2 * axis];
      spacing[axis] = (bounds[2 * axis + 1] - origin[axis]) / whole[2 * axis + 1];
    }
  }
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  outputInformation->Set(vtkDataObject::SPACING(), spacing, 3);
  outputInformation->Set(vtkDataObject::ORIGIN(), origin, 3);
  outputInformation->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
}

void HandlePieces(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
}

void OfferTimes(vtkAlgorithm* algorithm, vtkInformationVector** inputVector, vtkInformationVector* outputVector,
  int timeless)
{
  InputTimes times;
  ForEachConnection(algorithm, inputVector, 0,
    [&times, timeless](int port, int, vtkInformation* info)
    {
      if (port != timeless)
      {
        times.Add(info);
      }
    });
  const std::vector<double> steps(times.Steps.begin(), times.Steps.end());
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Remove(Pipeline::TIME_STEPS());
    info->Remove(Pipeline::TIME_RANGE());
    if (!steps.empty())
    {
      info->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    }
    if (!times.Empty())
    {
      info->Set(Pipeline::TIME_RANGE(), times.Range, 2);
    }
  }
  OfferTogether(outputVector);
}

void RequestWholeInputs(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int firstPort)
{
  ForEachConnection(algorithm, inputVector, firstPort,
    [](int, int, vtkInformation* info)
    {
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (info->Has(Pipeline::WHOLE_EXTENT()))
      {
        info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
      }
    });
  AskTogether(algorithm, request, inputVector, outputVector, firstPort);
}

void UpdateInputs(vtkAlgorithm* algorithm, vtkInformationVector** inputVector)
{
  ForEachConnection(algorithm, inputVector, 0,
    [algorithm](int port, int connection, vtkInformation* info)
    {
      int producerPort = 0;
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, connection, producerPort);
      vtkNew<vtkInformationVector> requests;
      requests->SetNumberOfInformationObjects(producer->GetNumberOfOutputPorts());
      vtkInformation* request = requests->GetInformationObject(producerPort);
      request->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      InputTimes times;
      times.Add(info);
      if (!times.Empty())
      {
        request->Set(Pipeline::UPDATE_TIME_STEP(), times.First());
      }
      vtkNew<vtkInformation> before;
      before->CopyEntry(info, Pipeline::UPDATE_TIME_STEP());
      producer->Update(producerPort, requests);
      info->CopyEntry(before, Pipeline::UPDATE_TIME_STEP());
    });
}

void EmptyOutput(vtkDataObject* output)
{
  output->Initialize();
  output->GetInformation()->Set(vtkDataObject::DATA_EXTENT_TYPE(), output->GetExtentType());
}

void EmptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      EmptyOutput(output);
    }
  }
}

bool RequestedExtent(vtkInformation* outputInformation, int extent[6])
{
  int whole[6];
  outputInformation->Get(Pipeline::WHOLE_EXTENT(), whole);
  outputInformation->Get(Pipeline::UPDATE_EXTENT(), extent);
  bool any = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = std::max(extent[2 * axis], whole[2 * axis]);
    extent[2 * axis + 1] = std::min(extent[2 * axis + 1], whole[2 * axis + 1]);
    any = any && extent[2 * axis] <= extent[2 * axis + 1];
  }
  return any;
}

FilterRun::FilterRun(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
  : Algorithm(algorithm)
  , Request(request)
  , Inputs(inputVector)
  , Outputs(outputVector)
{
  // Of others the pipeline has passed on the field data of the first input, which stay.
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkImageData* image = vtkImageData::GetData(outputVector, port))
    {
      EmptyOutput(image);
    }
  }
}

namespace
{

/// Stamp every output with the time that was asked for, else with that of the first input that has one.
void StampOutputs(
  vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkNew<vtkInformation> stamp;
  vtkInformation* asked = outputs->GetInformationObject(RequestedPort(request));
  if (asked->Has(Pipeline::TIME_RANGE()) && asked->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    stamp->Set(vtkDataObject::DATA_TIME_STEP(), asked->Get(Pipeline::UPDATE_TIME_STEP()));
  }
  ForEachConnection(algorithm, inputs, 0,
    [&stamp](int, int, vtkInformation* info)
    {
      vtkDataObject* input = vtkDataObject::GetData(info);
      if (input && !stamp->Has(vtkDataObject::DATA_TIME_STEP()))
      {
        stamp->CopyEntry(input->GetInformation(), vtkDataObject::DATA_TIME_STEP());
      }
    });
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->GetInformation()->CopyEntry(stamp, vtkDataObject::DATA_TIME_STEP());
    }
  }
}

} // namespace

/// Tell the others how it went, where they do not know yet; leave nothing where one failed.
void FilterRun::Agree()
{
  if (!this->Members)
  {
    return;
  }
  if (!this->Members->IsOver())
  {
    const bool failed = this->Failed || std::uncaught_exceptions() > 0; // out of memory, which is said elsewhere
    const std::vector<TeamState> states = this->Members->Meet(failed ? TeamState::Failed : TeamState::Done);
    const auto unlike = std::find_if(states.begin(), states.end(), [](TeamState state) { return state != TeamState::Done; });
    if (!failed && unlike != states.end() && *unlike != TeamState::Stopped)
    {
      vtkErrorWithObjectMacro(this->Algorithm, << "Process " << unlike - states.begin() << " of " << states.size()
                                               << " failed, and says why: there is no output in any of them.");
    }
  }
  if (this->Members->IsBroken())
  {
    for (int port = 0; port < this->Outputs->GetNumberOfInformationObjects(); ++port)
    {
      if (vtkDataObject* output = vtkDataObject::GetData(this->Outputs, port))
      {
        // Released, it is made again at the next update, in all processes.
        output->ReleaseData();
        output->GetInformation()->Set(vtkDataObject::DATA_EXTENT_TYPE(), output->GetExtentType());
        this->Outputs->GetInformationObject(port)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
      }
    }
  }
}

FilterRun::~FilterRun()
{
  try
  {
    this->Agree();
    ForgetTogether(this->Outputs);
    StampOutputs(this->Algorithm, this->Request, this->Inputs, this->Outputs);
  }
  catch (...)
  {
    // Out of memory: the run fails, and what it leaves is empty and needs no time.
  }
}

bool FilterRun::AreInputsWhole(std::string& error, int firstPort) const
{
  vtkMultiProcessController* controller =
    ControllerOfRun(this->Algorithm, this->Request, this->Inputs, this->Outputs);
  if (!controller)
  {
    return true;
  }
  this->Members = std::make_unique<Ranks>(controller);
  int lacking = -1;
  ForEachConnection(this->Algorithm, this->Inputs, 0,
    [&lacking](int port, int, vtkInformation* info)
    {
      vtkDataObject* data = vtkDataObject::GetData(info);
      lacking = lacking < 0 && data && data->GetDataReleased() ? port : lacking;
    });
  std::vector<Fingerprint> ports(static_cast<std::size_t>(this->Algorithm->GetNumberOfInputPorts()));
  ForEachConnection(this->Algorithm, this->Inputs, 0,
    [&ports](int port, int, vtkInformation* info) { AddData(vtkDataObject::GetData(info), ports[port]); });
  std::vector<vtkIdType> own(ports.size());
  for (std::size_t port = 0; port < ports.size(); ++port)
  {
    const std::uint64_t value = ports[port].Value();
    std::memcpy(&own[port], &value, sizeof(value));
  }
  const std::vector<vtkIdType> all = this->Members->GatherNumbers(own);
  this->Same.assign(ports.size(), true);
  for (std::size_t at = 0; at < all.size(); ++at)
  {
    const std::size_t port = at % ports.size();
    const bool same = all[at] == all[port];
    this->Same[port] = this->Same[port] && same;
    if (!same && lacking < 0 && error.empty() && static_cast<int>(port) >= firstPort)
    {
      error = "Input port " + std::to_string(port) + " is not the same in all " +
        std::to_string(this->Members->GetSize()) + " processes: process " + std::to_string(at / ports.size()) +
        " has other data than process 0, and an answer from a part of a mesh would be wrong. Gather it first: save the "
        "mesh to one file and read that, which gives the whole to every process.";
    }
  }
  if (lacking >= 0)
  {
    error = "Input port " + std::to_string(lacking) + " has nothing: the filter before it failed, and says why.";
  }
  return error.empty();
}

Team* FilterRun::GetTeam() const
{
  return this->Members.get();
}

Team* FilterRun::GetTeamOn(int port) const
{
  return this->Members && this->Same[static_cast<std::size_t>(port)] ? this->Members.get() : nullptr;
}

int FilterRun::Fail(const std::string& error) const
{
  EmptyOutputs(this->Outputs);
  vtkErrorWithObjectMacro(this->Algorithm, << error);
  this->Failed = true;
  return this->Members ? 1 : 0;
}

} // namespace shadowcones
