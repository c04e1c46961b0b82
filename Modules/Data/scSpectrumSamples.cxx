// SPDX-License-Identifier: BSD-3-Clause
#include "scSpectrumSamples.h"

#include "scSentence.h"

#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <algorithm>

namespace shadowcones
{

bool SetSample(SpectrumSamples& samples, int index, double value)
{
  const auto added = samples.emplace(index, value);
  const bool changed = added.second || added.first->second != value;
  added.first->second = value;
  return changed;
}

bool SetSamples(SpectrumSamples& samples, vtkDataArray* values)
{
  SpectrumSamples own;
  for (vtkIdType i = 0; values && i < values->GetNumberOfValues(); ++i)
  {
    own.emplace(static_cast<int>(i), values->GetVariantValue(i).ToDouble());
  }
  const bool changed = own != samples;
  samples.swap(own);
  return changed;
}

double GetSample(const SpectrumSamples& samples, int index, double all)
{
  const auto found = samples.find(index);
  return found == samples.end() ? all : found->second;
}

bool ReadSpectrum(const char* name, const SpectrumSamples& samples, double all, int count, std::vector<double>& values,
  std::string& error)
{
  const auto isOutside = [count](const auto& sample) { return sample.first < 0 || sample.first >= count; };
  const auto wrong = std::find_if(samples.begin(), samples.end(), isOutside);
  if (wrong != samples.end())
  {
    error = Sentence(
      name, "Spectrum is set for wavelength sample ", wrong->first, ": the light has ", count, ", which count from 0.");
    return false;
  }
  values.resize(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    values[static_cast<std::size_t>(k)] = GetSample(samples, k, all);
  }
  return true;
}

std::string TextOf(const SpectrumSamples& samples)
{
  std::string text;
  for (const auto& sample : samples)
  {
    text += Sentence(text.empty() ? "" : " ", "[", sample.first, "] ", sample.second);
  }
  return text.empty() ? "(none)" : text;
}

} // namespace shadowcones
