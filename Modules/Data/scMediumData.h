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

/// What a filter has been told of the particles of its medium.
struct ParticleSettings
{
  const SpectrumSamples& SigmaSSpectrum;
  double SigmaS;
  const SpectrumSamples& SigmaASpectrum;
  double SigmaA;
  int PhaseFunction;
  const double (&PhaseLobes)[3];
  double PhaseAsymmetry;
};
/// Coefficients at every wavelength, and the phase function. @return false, with a sentence in @p error.
SHADOWCONESDATA_EXPORT bool ReadParticles(
  const ParticleSettings& settings, std::size_t wavelengths, Medium& medium, std::string& error);

/// What is wrong with a phase function as filters set it, as a sentence; empty where nothing is.
SHADOWCONESDATA_EXPORT std::string CheckPhase(int kind, const double lobes[3], double asymmetry);

/// SigmaS, SigmaA and MediumBounds as field data.
SHADOWCONESDATA_EXPORT void WriteMedium(const Medium& medium, vtkFieldData* field);

} // namespace shadowcones

/// The named phase functions of a filter that has PhaseLobes.
#define scDefinePhasePresets(Class)                                                                                    \
  void Class::SetPhasePreset(const shadowcones::SchlickLobes& lobes)                                                   \
  {                                                                                                                    \
    this->SetPhaseFunctionToBlasiSchlick();                                                                            \
    this->SetPhaseLobes(lobes.Weight, lobes.K1, lobes.K2);                                                             \
  }                                                                                                                    \
  void Class::SetPhasePresetToRayleigh()                                                                               \
  {                                                                                                                    \
    this->SetPhasePreset(shadowcones::SchlickRayleigh());                                                              \
  }                                                                                                                    \
  void Class::SetPhasePresetToHazyMie()                                                                                \
  {                                                                                                                    \
    this->SetPhasePreset(shadowcones::SchlickHazyMie());                                                               \
  }                                                                                                                    \
  void Class::SetPhasePresetToMurkyMie()                                                                               \
  {                                                                                                                    \
    this->SetPhasePreset(shadowcones::SchlickMurkyMie());                                                              \
  }

#endif
