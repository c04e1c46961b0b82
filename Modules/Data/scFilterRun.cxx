// SPDX-License-Identifier: BSD-3-Clause
#include "scFilterRun.h"

#include "scDataFingerprint.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
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

/// Does the pipeline hand over the blocks of a composite input one by one?
bool IsIterated(vtkAlgorithm* algorithm, vtkInformationVector** inputVector)
{
  bool iterated = false;
  ForEachConnection(algorithm, inputVector, 0,
    [&](int port, int connection, vtkInformation* info)
    {
      vtkDataObject* whole = algorithm->GetInputDataObject(port, connection);
      iterated = iterated || (vtkCompositeDataSet::SafeDownCast(whole) && vtkDataObject::GetData(info) != whole);
    });
  return iterated;
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
}

void RequestWholeInputs(vtkAlgorithm* algorithm, vtkInformationVector** inputVector, int firstPort)
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

FilterRun::~FilterRun()
{
  try
  {
    StampOutputs(this->Algorithm, this->Request, this->Inputs, this->Outputs);
  }
  catch (...)
  {
    // Out of memory: the run fails, and what it leaves is empty and needs no time.
  }
}

bool FilterRun::AreInputsWhole(std::string& error, int firstPort) const
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const PieceRequest piece = RequestedPiece(this->Request, this->Outputs);
  const int processes = controller ? controller->GetNumberOfProcesses() : 1;
  if (processes < 2 || piece.NumberOfPieces != processes || piece.Piece != controller->GetLocalProcessId() ||
    IsIterated(this->Algorithm, this->Inputs))
  {
    return true;
  }
  std::vector<Fingerprint> ports(static_cast<std::size_t>(this->Algorithm->GetNumberOfInputPorts()));
  ForEachConnection(this->Algorithm, this->Inputs, firstPort,
    [&ports](int port, int, vtkInformation* info) { AddData(vtkDataObject::GetData(info), ports[port]); });
  // As bytes: controllers have no words of 64 bits on every system.
  const std::size_t size = ports.size() * sizeof(std::uint64_t);
  std::vector<unsigned char> own(size);
  std::vector<unsigned char> all(size * static_cast<std::size_t>(processes));
  for (std::size_t port = 0; port < ports.size(); ++port)
  {
    const std::uint64_t value = ports[port].Value();
    std::memcpy(own.data() + port * sizeof(value), &value, sizeof(value));
  }
  controller->AllGather(own.data(), all.data(), static_cast<vtkIdType>(size));
  for (std::size_t at = 0; at < all.size(); ++at)
  {
    if (all[at] != all[at % size])
    {
      error = "Input port " + std::to_string(at % size / sizeof(std::uint64_t)) + " is not the same in all " +
        std::to_string(processes) + " processes: process " + std::to_string(at / size) +
        " has other data than process 0, and an answer from a part of a mesh would be wrong. Gather it first: save the "
        "mesh to one file and read that, which gives the whole to every process.";
      return false;
    }
  }
  return true;
}

int FilterRun::Fail(const std::string& error) const
{
  vtkErrorWithObjectMacro(this->Algorithm, << error);
  return 0;
}

} // namespace shadowcones
