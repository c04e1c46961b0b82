// SPDX-License-Identifier: BSD-3-Clause
#include "scInputStamp.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace shadowcones
{

InputStamp StampOf(vtkDataObject* data)
{
  InputStamp stamp;
  if (data)
  {
    stamp = { data, data->GetMTime(), data->GetUpdateTime() };
  }
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      stamp.Changed = std::max(stamp.Changed, blocks->GetCurrentDataObject()->GetMTime());
    }
  }
  return stamp;
}

std::vector<InputStamp> StampsOf(vtkInformationVector* const* ports, int numberOfPorts)
{
  std::vector<InputStamp> stamps;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    stamps.emplace_back();
    for (int i = 0; i < ports[port]->GetNumberOfInformationObjects(); ++i)
    {
      stamps.push_back(StampOf(vtkDataObject::GetData(ports[port], i)));
    }
  }
  return stamps;
}

} // namespace shadowcones
