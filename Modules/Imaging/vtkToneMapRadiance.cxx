// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToneMapRadiance.h"

#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scImageOutput.h"
#include "scLightData.h"
#include "scParameterRanges.h"
#include "scSentence.h"
#include "scWarnings.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <exception>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkToneMapRadiance);
scDefineGuardedRequests(vtkToneMapRadiance);

int vtkToneMapRadiance::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  shadowcones::OfferTimes(this, inputVector, outputVector);
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkToneMapRadiance::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The executive has asked for the same extent; the exposure is that of the whole image.
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  if (this->AutoExposure && inInfo->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
      inInfo->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
  }
  else
  {
    vtkInformation* outInfo = outputVector->GetInformationObject(0);
    inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
      outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()), 6);
  }
  return 1;
}

int vtkToneMapRadiance::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const shadowcones::FilterRun run(this, request, inputVector, outputVector);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  std::string error;
  if (this->AutoExposure && !run.AreInputsWhole(error))
  {
    return run.Fail(error);
  }
  if (!(this->Exposure > 0.0) || !std::isfinite(this->Exposure))
  {
    return run.Fail(shadowcones::Sentence("Exposure is ", this->Exposure, ": it must be above 0 and finite."));
  }
  const std::string curve =
    shadowcones::FirstOutOfRange({ shadowcones::OneOf("ToneCurve", this->ToneCurve, { "Linear", "Filmic" }) });
  if (!curve.empty())
  {
    return run.Fail(curve);
  }
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  const vtkIdType points = input ? input->GetNumberOfPoints() : 0;
  if (points == 0 || extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // nothing to show
  }
  vtkDataArray* radiance = input->GetPointData()->GetArray("Radiance");
  if (!radiance || radiance->GetNumberOfTuples() != points)
  {
    return run.Fail(shadowcones::Sentence("The image has no point array \"Radiance\" with one tuple for each of its ",
      points, " points: connect vtkScatteringImageFilter, or name the array so."));
  }

  std::vector<double> wavelengths;
  if (!shadowcones::ReadWavelengths(
        input, static_cast<std::size_t>(radiance->GetNumberOfComponents()), wavelengths, error))
  {
    return run.Fail(error);
  }
  double exposure = this->Exposure;
  try
  {
    if (this->AutoExposure)
    {
      exposure = shadowcones::FindExposure(input, wavelengths);
    }
    output->ShallowCopy(input);
    if (!shadowcones::WriteRgb(input, { wavelengths, exposure, static_cast<shadowcones::ToneCurve>(this->ToneCurve) },
          shadowcones::MonitorOf(this), output))
    {
      shadowcones::EmptyOutput(output);
      return 1; // aborted
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail("Tone mapping failed: " + shadowcones::ReasonOf(exception) + ".");
  }
  output->Crop(extent);
  shadowcones::Warnings warnings;
  warnings.Add(this->AutoExposure ? shadowcones::UnusedExposure(this->Exposure) : std::string());
  warnings.Say(this);
  return 1;
}

void vtkToneMapRadiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutoExposure: " << (this->AutoExposure ? "On" : "Off") << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ToneCurve: " << this->ToneCurve << "\n";
}
