// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer drives: the harness that SHADOWCONES_HARNESS names.
#include "Harnesses.h"

#include "vtkSMPTools.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{
fuzz::Function chosen = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  const char* name = std::getenv("SHADOWCONES_HARNESS");
  for (const fuzz::Harness& harness : fuzz::Harnesses())
  {
    if (name && std::strcmp(harness.Name, name) == 0)
    {
      chosen = harness.Run;
    }
  }
  if (!chosen)
  {
    std::fprintf(stderr, "SHADOWCONES_HARNESS names no harness of this program\n");
    std::exit(2);
  }
  // Small data: threads would cost more than they save.
  vtkSMPTools::SetBackend("Sequential");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
  chosen(bytes, count);
  return 0;
}
