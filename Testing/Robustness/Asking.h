// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Asking.h
 * @brief An update of a filter as a finding: its messages, and whether every number that left it is finite.
 */
#ifndef Asking_h
#define Asking_h

#include "AwkwardChecks.h"
#include "FiniteData.h"
#include "Messages.h"

#include <sstream>
#include <string>

namespace robustness
{

inline Finding Wrong(const std::string& text)
{
  return { Verdict::Lost, text };
}

/**
 * Update a filter. Said or Lost where it gave a message, Lost where a number is not finite, else Sound.
 * @param mayRefuse  a part of a message that is right for any mesh
 */
inline Finding Ask(vtkAlgorithm* filter, const Scene& scene, const std::string& mayRefuse = std::string())
{
  shadowcones::testsupport::Messages messages(filter);
  filter->Update();
  const AwkwardMesh& mesh = scene.Mesh;
  if (!messages.Errors.empty())
  {
    const bool due = !mesh.Refusal.empty() ? messages.Errors.find(mesh.Refusal) != std::string::npos
                                           : !mesh.Casts() ||
        (!mayRefuse.empty() && messages.Errors.find(mayRefuse) != std::string::npos);
    return { due ? Verdict::Said : Verdict::Lost, messages.Errors };
  }
  if (!mesh.Refusal.empty())
  {
    return Wrong("no message of a mesh without a right answer");
  }
  const std::string found = shadowcones::testsupport::NotFiniteOf(filter);
  return found.empty() ? Finding() : Wrong(found);
}

template <typename... Parts>
Finding WrongOf(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return Wrong(text.str());
}

} // namespace robustness

#endif
