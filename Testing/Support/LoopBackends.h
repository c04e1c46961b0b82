// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopBackends.h
 * @brief Choose what runs parallel loops, for tests that try several.
 */
#ifndef LoopBackends_h
#define LoopBackends_h

#include "vtkSMPTools.h"

#include <cstring>

namespace shadowcones::testsupport
{

/**
 * @return false where this VTK was built without it; and with the sanitizer for threads for libraries that were built
 * without it, as what their threads wait for is not seen.
 */
inline bool UseLoopBackend(const char* name)
{
#ifdef __SANITIZE_THREAD__
  if (std::strcmp(name, "TBB") == 0 || std::strcmp(name, "OpenMP") == 0)
  {
    return false;
  }
#endif
  return vtkSMPTools::SetBackend(name);
}

} // namespace shadowcones::testsupport

#endif
