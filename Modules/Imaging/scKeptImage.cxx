// SPDX-License-Identifier: BSD-3-Clause
#include "scKeptImage.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <algorithm>

namespace shadowcones
{

namespace
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

} // namespace

void KeptImage::Drop()
{
  this->Pixels = nullptr;
  this->Wavelengths.clear();
  this->Exposure = 0.0;
}

void KeptImage::DropIfOld(vtkInformationVector** inputs, int numberOfPorts, vtkMTimeType parametersChanged)
{
  std::vector<InputStamp> stamps;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    stamps.emplace_back(); // between ports
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      stamps.push_back(StampOf(vtkDataObject::GetData(inputs[port], i)));
    }
  }
  if (parametersChanged != this->ParametersChanged || !(stamps == this->Inputs))
  {
    this->Drop();
    this->ParametersChanged = parametersChanged;
    this->Inputs = stamps;
  }
}

bool KeptImage::HoldsPixels(const int extent[6]) const
{
  return this->Pixels && std::equal(extent, extent + 6, this->Pixels->GetExtent());
}

} // namespace shadowcones
