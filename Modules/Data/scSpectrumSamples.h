// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSpectrumSamples.h
 * @brief A parameter with one value for all wavelengths and, where it was told so, own values for some of them.
 */
#ifndef scSpectrumSamples_h
#define scSpectrumSamples_h

#include "ShadowConesDataModule.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkDataArray;

namespace shadowcones
{

/// Own values by the index of their wavelength sample, which counts from 0.
using SpectrumSamples = std::map<int, double>;

/// @return true where that changed something.
SHADOWCONESDATA_EXPORT bool SetSample(SpectrumSamples& samples, int index, double value);
/// Own values for the first samples, in place of all that were set. @return true where that changed something.
SHADOWCONESDATA_EXPORT bool SetSamples(SpectrumSamples& samples, vtkDataArray* values);
SHADOWCONESDATA_EXPORT double GetSample(const SpectrumSamples& samples, int index, double all);

/// The values at @p count wavelengths. @return false, with a sentence in @p error, where one is set for another wavelength.
SHADOWCONESDATA_EXPORT bool ReadSpectrum(const char* name, const SpectrumSamples& samples, double all, int count,
  std::vector<double>& values, std::string& error);

/// As PrintSelf prints them.
SHADOWCONESDATA_EXPORT std::string TextOf(const SpectrumSamples& samples);

} // namespace shadowcones

/// The methods of a parameter with a spectrum, defined: its members are Name, a double, and NameSpectrum.
#define scDefineSpectrum(Class, Name)                                                                                  \
  void Class::Set##Name(double value)                                                                                  \
  {                                                                                                                    \
    if (this->Name != value || !this->Name##Spectrum.empty())                                                          \
    {                                                                                                                  \
      this->Name = value;                                                                                              \
      this->Name##Spectrum.clear();                                                                                    \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  void Class::Set##Name##Spectrum(int index, double value)                                                             \
  {                                                                                                                    \
    if (shadowcones::SetSample(this->Name##Spectrum, index, value))                                                    \
    {                                                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  void Class::Set##Name##Spectrum(vtkDataArray* values)                                                                \
  {                                                                                                                    \
    if (shadowcones::SetSamples(this->Name##Spectrum, values))                                                         \
    {                                                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  void Class::Clear##Name##Spectrum()                                                                                  \
  {                                                                                                                    \
    this->Set##Name##Spectrum(nullptr);                                                                                \
  }                                                                                                                    \
  double Class::Get##Name##Spectrum(int index)                                                                         \
  {                                                                                                                    \
    return shadowcones::GetSample(this->Name##Spectrum, index, this->Name);                                            \
  }

#endif
