// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scGuardedRequest.h
 * @brief No exception leaves a filter: out of memory, anywhere in a request, is a message and empty outputs.
 */
#ifndef scGuardedRequest_h
#define scGuardedRequest_h

#include "ShadowConesDataModule.h"

#include <exception>
#include <new>
#include <string>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

namespace shadowcones
{

inline constexpr const char* notEnoughMemory = "there is not enough memory; ask for less, or of less";

/// Why something failed, for the end of a sentence: an exception that says so itself, or memory that ended, which does not.
inline std::string ReasonOf(const std::exception& exception)
{
  return dynamic_cast<const std::bad_alloc*>(&exception) ? notEnoughMemory : exception.what();
}

/// Empty the outputs, as soon as there are any, and say by vtkErrorMacro of the filter what happened. @return 0.
SHADOWCONESDATA_EXPORT int FailRequest(vtkAlgorithm* algorithm, vtkInformation* request,
  vtkInformationVector* outputVector, const char* what) noexcept;

/// Any of a filter's requests.
template <typename Request>
int GuardRequest(
  vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputVector, const Request& process) noexcept
{
  try
  {
    return process();
  }
  catch (const std::bad_alloc&)
  {
    return FailRequest(algorithm, request, outputVector, notEnoughMemory);
  }
  catch (const std::exception& exception)
  {
    return FailRequest(algorithm, request, outputVector, exception.what());
  }
  catch (...)
  {
    return FailRequest(algorithm, request, outputVector, "an exception of an unknown kind.");
  }
}

} // namespace shadowcones

/// Every request of a filter passes here first.
#define scDefineGuardedRequests(Class)                                                                                 \
  int Class::ProcessRequest(                                                                                           \
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)                   \
  {                                                                                                                    \
    return shadowcones::GuardRequest(this, request, outputVector,                                                      \
      [&] { return this->Superclass::ProcessRequest(request, inputVector, outputVector); });                           \
  }

#endif
