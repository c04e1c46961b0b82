// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumData.h
 * @brief The coefficients of a medium, as set and as field data.
 */
#ifndef scMediumData_h
#define scMediumData_h

#include "ShadowConesDataModule.h"
#include "scMedium.h"
#include "scSpectrumSamples.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkFieldData;

namespace shadowcones
{

/// The values of a coefficient at every wavelength. @return false, with a sentence in @p error, where one is not valid or not used.
SHADOWCONESDATA_EXPORT bool ReadCoefficient(const char* name, const SpectrumSamples& samples, double all,
  std::size_t wavelengths, std::vector<double>& values, std::string& error);

/// What is wrong with a phase function as filters set it, as a sentence; empty where nothing is.
SHADOWCONESDATA_EXPORT std::string CheckPhase(int kind, const double lobes[3], double asymmetry);

/// SigmaS, SigmaA and MediumBounds as field data.
SHADOWCONESDATA_EXPORT void WriteMedium(const Medium& medium, vtkFieldData* field);

} // namespace shadowcones

#endif
