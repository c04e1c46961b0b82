// SPDX-License-Identifier: BSD-3-Clause
#include "scGuardedRequest.h"

#include "scFilterRun.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace shadowcones
{

int FailRequest(
  vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputVector, const char* what) noexcept
{
  try
  {
    // What is left of a run before is not what was asked for now.
    if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
    {
      EmptyOutputs(outputVector);
    }
    vtkErrorWithObjectMacro(algorithm, << "This filter could not finish: " << what);
  }
  catch (...)
  {
    // Not even for the sentence is there any memory; the pipeline still hears of the failure.
  }
  return 0;
}

} // namespace shadowcones
