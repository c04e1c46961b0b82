// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRankWork.h"

#include "scRanks.h"

#include "vtkObjectFactory.h"

using namespace shadowcones;

vtkStandardNewMacro(vtkRankWork);

void vtkRankWork::Reset()
{
  WorkOfThisProcess() = {};
}

vtkIdType vtkRankWork::GetNumberOfItems()
{
  return WorkOfThisProcess().Items;
}

vtkIdType vtkRankWork::GetNumberOfRays()
{
  return WorkOfThisProcess().Rays;
}

vtkIdType vtkRankWork::GetNumberOfMeetings()
{
  return WorkOfThisProcess().Meetings;
}

vtkIdType vtkRankWork::GetBytesSent()
{
  return WorkOfThisProcess().Sent;
}

vtkIdType vtkRankWork::GetBytesReceived()
{
  return WorkOfThisProcess().Received;
}

double vtkRankWork::GetSeconds()
{
  return WorkOfThisProcess().Seconds;
}

double vtkRankWork::GetProcessorSeconds()
{
  return WorkOfThisProcess().ProcessorSeconds;
}

void vtkRankWork::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfItems: " << GetNumberOfItems() << "\n";
  os << indent << "NumberOfRays: " << GetNumberOfRays() << "\n";
  os << indent << "NumberOfMeetings: " << GetNumberOfMeetings() << "\n";
  os << indent << "BytesSent: " << GetBytesSent() << "\n";
  os << indent << "BytesReceived: " << GetBytesReceived() << "\n";
  os << indent << "Seconds: " << GetSeconds() << "\n";
  os << indent << "ProcessorSeconds: " << GetProcessorSeconds() << "\n";
}
