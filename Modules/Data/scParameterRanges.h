// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scParameterRanges.h
 * @brief The valid values of a filter's parameters as a table, and the sentence for one that is not.
 */
#ifndef scParameterRanges_h
#define scParameterRanges_h

#include "ShadowConesDataModule.h"

#include <initializer_list>
#include <string>

namespace shadowcones
{

/// Parameters with the same bound in several filters.
constexpr int mostLightSamples = 65536;

/// The value of a parameter, whether it is valid, and which values are.
struct ParameterRange
{
  const char* Name;
  double Value;
  bool Valid;
  std::string Range; ///< reads on from "it must be"
};

/// A whole number in [least, most]: "in least..most".
SHADOWCONESDATA_EXPORT ParameterRange InRange(const char* name, int value, int least, int most);

/// One of the names, which count from 0: "Exact (0) or Soft (1)".
SHADOWCONESDATA_EXPORT ParameterRange OneOf(const char* name, int value, std::initializer_list<const char*> names);

/// @return the sentence for the first that is not valid; empty where all are.
SHADOWCONESDATA_EXPORT std::string FirstOutOfRange(std::initializer_list<ParameterRange> parameters);

/// Three counts of points along x, y and z: each at least 2, their product below 2^31. @return a sentence, or nothing.
SHADOWCONESDATA_EXPORT std::string CheckDimensions(const char* name, const int dimensions[3]);

} // namespace shadowcones

#endif
