// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumData.h"

#include "scFieldArrays.h"
#include "scSentence.h"

#include "vtkFieldData.h"

#include <cmath>
#include <limits>

namespace shadowcones
{

void SetSample(std::vector<double>& spectrum, int index, double value)
{
  const auto k = static_cast<std::size_t>(index);
  if (k >= spectrum.size())
  {
    spectrum.resize(k + 1, std::numeric_limits<double>::quiet_NaN());
  }
  spectrum[k] = value;
}

double GetSample(const std::vector<double>& spectrum, int index, double all)
{
  const auto k = static_cast<std::size_t>(index);
  return index < 0 || k >= spectrum.size() || std::isnan(spectrum[k]) ? all : spectrum[k];
}

bool ReadCoefficient(const char* name, const std::vector<double>& spectrum, double all, std::size_t wavelengths,
  std::vector<double>& values, std::string& error)
{
  if (spectrum.size() > wavelengths)
  {
    error = Sentence("Set", name, "Spectrum was given wavelength sample ", spectrum.size() - 1, ", but the light has ",
      wavelengths, " samples.");
    return false;
  }
  values.resize(wavelengths);
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    values[k] = GetSample(spectrum, static_cast<int>(k), all);
    if (!(values[k] >= 0.0) || std::isinf(values[k]))
    {
      error = Sentence(name, " is ", values[k], " at wavelength sample ", k, ": it must be 0 or above and finite.");
      return false;
    }
  }
  return true;
}

void WriteMedium(const Medium& medium, vtkFieldData* field)
{
  const auto wavelengths = static_cast<int>(medium.SigmaS.size());
  AddDoubleArray(field, "SigmaS", wavelengths, medium.SigmaS);
  AddDoubleArray(field, "SigmaA", wavelengths, medium.SigmaA);
  const Box& box = medium.Bounds;
  AddDoubleArray(field, "MediumBounds", 6, { box.Min.X, box.Max.X, box.Min.Y, box.Max.Y, box.Min.Z, box.Max.Z });
}

} // namespace shadowcones
