// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scInnerFilter.h
 * @brief A filter that another one runs inside it: its progress, its abort and its messages are those of the outer one.
 */
#ifndef scInnerFilter_h
#define scInnerFilter_h

#include "ShadowConesDataModule.h"
#include "scWarnings.h"

#include <string>

class vtkAlgorithm;

namespace shadowcones
{

/// A message of VTK without the place in its sources: "vtkThing: what is wrong".
SHADOWCONESDATA_EXPORT std::string PlainMessage(const char* message);

/// What inner filters said and did.
struct InnerRun
{
  std::string Error; ///< the first; empty: none
  Warnings Said;
  bool Aborted = false;
  bool IsDone() const { return this->Error.empty() && !this->Aborted; }
};

/**
 * Bring @p inner up to date for @p outer, whose progress goes from @p from to @p to meanwhile. Nothing is done where an earlier
 * filter of the same run failed. Where @p outer is to stop, @p inner stops.
 */
SHADOWCONESDATA_EXPORT void UpdateInside(vtkAlgorithm* inner, vtkAlgorithm* outer, double from, double to, InnerRun& run);

} // namespace shadowcones

#endif
