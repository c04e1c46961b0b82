// SPDX-License-Identifier: BSD-3-Clause
#include "scRanks.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace shadowcones
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;
using Clock = std::chrono::steady_clock;

constexpr const char* location = "shadowcones";
/// Of an output: its filter can be asked together.
vtkInformationIntegerKey* const canBeAsked = new vtkInformationIntegerKey("CAN_SHARE", location);
/// Of an output: all processes ask for the whole of it now.
vtkInformationIntegerKey* const askedTogether = new vtkInformationIntegerKey("SHARED", location);

/// Counts what is exchanged, and how long it takes.
class Exchange
{
public:
  Exchange(vtkIdType sent, vtkIdType received)
    : Start(Clock::now())
    , Processor(std::clock())
  {
    RankWork& work = WorkOfThisProcess();
    ++work.Meetings;
    work.Sent += sent;
    work.Received += received;
  }
  ~Exchange()
  {
    RankWork& work = WorkOfThisProcess();
    work.Seconds += std::chrono::duration<double>(Clock::now() - this->Start).count();
    work.ProcessorSeconds += static_cast<double>(std::clock() - this->Processor) / CLOCKS_PER_SEC;
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

private:
  Clock::time_point Start;
  std::clock_t Processor;
};

vtkMultiProcessController* ControllerOfSeveral()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

/// Does the pipeline hand over the blocks of a composite input one by one? Processes may have unlike numbers of them.
bool IsIterated(vtkAlgorithm* algorithm, vtkInformationVector** inputVector)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* whole = algorithm->GetInputDataObject(port, i);
      if (vtkCompositeDataSet::SafeDownCast(whole) &&
        vtkDataObject::GetData(inputVector[port]->GetInformationObject(i)) != whole)
      {
        return true;
      }
    }
  }
  return false;
}

/// What ParaView puts behind each filter: it hands requests on as they are.
bool HandsOn(vtkAlgorithm* algorithm)
{
  return algorithm->IsA("vtkPVPostFilter") && algorithm->GetNumberOfInputConnections(0) == 1;
}

/// Will a filter run for the whole of an output? No where that is not sure.
bool WillRun(vtkAlgorithm* algorithm, vtkInformation* asked)
{
  auto* executive = vtkDemandDrivenPipeline::SafeDownCast(algorithm->GetExecutive());
  vtkDataObject* data = executive ? vtkDataObject::GetData(asked) : nullptr;
  if (!data)
  {
    return false;
  }
  vtkInformation* has = data->GetInformation();
  const bool hasPart = has->Has(vtkDataObject::DATA_NUMBER_OF_PIECES()) &&
    data->GetExtentType() == VTK_PIECES_EXTENT && has->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()) != 1;
  const bool hasOtherTime = asked->Has(Pipeline::TIME_RANGE()) && asked->Has(Pipeline::UPDATE_TIME_STEP()) &&
    has->Has(vtkDataObject::DATA_TIME_STEP()) &&
    has->Get(vtkDataObject::DATA_TIME_STEP()) != asked->Get(Pipeline::UPDATE_TIME_STEP());
  return data->GetDataReleased() || executive->GetPipelineMTime() > data->GetUpdateTime() || hasPart || hasOtherTime;
}

/// The output that is asked for by a connection, where its filter can be asked together and will run; else nullptr.
vtkInformation* OutputToAsk(vtkAlgorithm* algorithm, int inputPort, int connection)
{
  int port = 0;
  vtkAlgorithm* producer = algorithm->GetInputAlgorithm(inputPort, connection, port);
  while (producer)
  {
    vtkInformation* info = producer->GetOutputInformation(port);
    if (!WillRun(producer, info))
    {
      return nullptr;
    }
    if (!HandsOn(producer))
    {
      return info->Has(canBeAsked) ? info : nullptr;
    }
    producer = producer->GetInputAlgorithm(0, 0, port);
  }
  return nullptr;
}

/// Take back what was asked of an input, whatever stands between.
void Forget(vtkAlgorithm* algorithm, int inputPort, int connection)
{
  int port = 0;
  vtkAlgorithm* producer = algorithm->GetInputAlgorithm(inputPort, connection, port);
  while (producer)
  {
    producer->GetOutputInformation(port)->Remove(askedTogether);
    producer = HandsOn(producer) ? producer->GetInputAlgorithm(0, 0, port) : nullptr;
  }
}
} // anonymous namespace

RankWork& WorkOfThisProcess()
{
  static RankWork work;
  return work;
}

Ranks::Ranks(vtkMultiProcessController* controller)
  : Controller(controller)
{
}

int Ranks::GetRank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

int Ranks::GetSize() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

void Ranks::Count(vtkIdType items)
{
  WorkOfThisProcess().Items += items;
}

std::vector<TeamState> Ranks::Meet(TeamState own)
{
  const auto size = static_cast<std::size_t>(this->GetSize());
  std::vector<TeamState> states(size, own);
  if (size > 1)
  {
    const auto number = static_cast<int>(own);
    std::vector<int> numbers(size);
    const Exchange exchange(sizeof(int), static_cast<vtkIdType>((size - 1) * sizeof(int)));
    this->Controller->AllGather(&number, numbers.data(), 1);
    std::transform(
      numbers.begin(), numbers.end(), states.begin(), [](int state) { return static_cast<TeamState>(state); });
  }
  const auto count = [&states](TeamState state) { return std::count(states.begin(), states.end(), state); };
  this->Over = count(TeamState::Joining) < this->GetSize();
  this->Broken = this->Over && count(TeamState::Done) < this->GetSize();
  return states;
}

std::vector<vtkIdType> Ranks::GatherNumbers(const std::vector<vtkIdType>& own)
{
  std::vector<vtkIdType> all = own;
  if (this->GetSize() > 1)
  {
    all.resize(own.size() * static_cast<std::size_t>(this->GetSize()));
    const auto bytes = static_cast<vtkIdType>(own.size() * sizeof(vtkIdType));
    const Exchange exchange(bytes, bytes * (this->GetSize() - 1));
    // As bytes: not every controller has words of 64 bits.
    this->Controller->AllGather(
      reinterpret_cast<const unsigned char*>(own.data()), reinterpret_cast<unsigned char*>(all.data()), bytes);
  }
  return all;
}

void Ranks::GatherBytes(const unsigned char* own, const std::vector<vtkIdType>& lengths, unsigned char* all)
{
  const int size = this->GetSize();
  const int rank = this->GetRank();
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  vtkIdType total = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    offsets[i] = total;
    total += lengths[i];
  }
  const vtkIdType ownLength = lengths[static_cast<std::size_t>(rank)];
  constexpr vtkIdType most = vtkIdType(1) << 30; // MPI counts in words of 32 bits
  if (size > 1 && total <= most)
  {
    const Exchange exchange(ownLength, total - ownLength);
    unsigned char none = 0;
    this->Controller->AllGatherV(ownLength > 0 ? own : &none, total > 0 ? all : &none, ownLength,
      const_cast<vtkIdType*>(lengths.data()), offsets.data());
    return;
  }
  std::copy(own, own + ownLength, all + offsets[static_cast<std::size_t>(rank)]);
  for (int sender = 0; size > 1 && sender < size; ++sender)
  {
    const auto at = static_cast<std::size_t>(sender);
    for (vtkIdType begin = 0; begin < lengths[at]; begin += most)
    {
      const vtkIdType length = std::min(most, lengths[at] - begin);
      const Exchange exchange(sender == rank ? length : 0, sender == rank ? 0 : length);
      this->Controller->Broadcast(all + offsets[at] + begin, length, sender);
    }
  }
}

vtkMultiProcessController* ControllerOfRun(vtkAlgorithm* algorithm, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkMultiProcessController* controller = ControllerOfSeveral();
  const int port = std::max(request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT()), 0);
  vtkInformation* info = outputVector->GetInformationObject(port);
  if (!controller || !info || IsIterated(algorithm, inputVector))
  {
    return nullptr;
  }
  const int pieces = info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) ? info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) : 1;
  const bool isOwnPiece = pieces == controller->GetNumberOfProcesses() &&
    info->Get(Pipeline::UPDATE_PIECE_NUMBER()) == controller->GetLocalProcessId();
  return isOwnPiece || (pieces == 1 && info->Has(askedTogether)) ? controller : nullptr;
}

void OfferTogether(vtkInformationVector* outputVector)
{
  ForgetTogether(outputVector);
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(canBeAsked, 1);
  }
}

void ForgetTogether(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Remove(askedTogether);
  }
}

void AskTogether(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int firstPort)
{
  if (!ControllerOfSeveral() || IsIterated(algorithm, inputVector))
  {
    return;
  }
  vtkMultiProcessController* controller = ControllerOfRun(algorithm, request, inputVector, outputVector);
  constexpr std::size_t most = 31; // connections: bits of a number
  std::vector<vtkInformation*> outputs;
  int own = 0;
  for (int port = firstPort; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      Forget(algorithm, port, i);
      outputs.push_back(controller ? OutputToAsk(algorithm, port, i) : nullptr);
      own |= outputs.back() && outputs.size() <= most ? 1 << (outputs.size() - 1) : 0;
    }
  }
  if (!controller)
  {
    return;
  }
  int all = 0;
  {
    const Exchange exchange(sizeof(int), static_cast<vtkIdType>(sizeof(int)) * (controller->GetNumberOfProcesses() - 1));
    controller->AllReduce(&own, &all, 1, vtkCommunicator::BITWISE_AND_OP);
  }
  for (std::size_t i = 0; i < std::min(outputs.size(), most); ++i)
  {
    if (all & (1 << i))
    {
      outputs[i]->Set(askedTogether, 1);
    }
  }
}

} // namespace shadowcones
