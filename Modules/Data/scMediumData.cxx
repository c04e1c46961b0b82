// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumData.h"

#include "scFieldArrays.h"
#include "scParameterRanges.h"
#include "scSentence.h"

#include "vtkFieldData.h"

#include <cmath>

namespace shadowcones
{

namespace
{
/// The values of a coefficient at every wavelength. @return false, with a sentence, where one is not valid or not used.
bool ReadCoefficient(const char* name, const SpectrumSamples& samples, double all, std::size_t wavelengths,
  std::vector<double>& values, std::string& error)
{
  if (!ReadSpectrum(name, samples, all, static_cast<int>(wavelengths), values, error))
  {
    return false;
  }
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    if (!(values[k] >= 0.0) || std::isinf(values[k]))
    {
      error = Sentence(name, " is ", values[k], " at wavelength sample ", k, ": it must be 0 or above and finite.");
      return false;
    }
  }
  return true;
}
} // anonymous namespace

bool ReadParticles(
  const ParticleSettings& settings, std::size_t wavelengths, Medium& medium, std::string& error)
{
  const double(&lobes)[3] = settings.PhaseLobes;
  medium.Phase = { static_cast<PhaseFunctionKind>(settings.PhaseFunction), { lobes[0], lobes[1], lobes[2] },
    settings.PhaseAsymmetry };
  return ReadCoefficient("SigmaS", settings.SigmaSSpectrum, settings.SigmaS, wavelengths, medium.SigmaS, error) &&
    ReadCoefficient("SigmaA", settings.SigmaASpectrum, settings.SigmaA, wavelengths, medium.SigmaA, error);
}

std::string CheckPhase(int kind, const double lobes[3], double asymmetry)
{
  const auto isBetween = [](double value, double low, double high) { return value > low && value < high; };
  std::string fault =
    FirstOutOfRange({ OneOf("PhaseFunction", kind, { "Isotropic", "BlasiSchlick", "HenyeyGreenstein", "Rayleigh" }),
      { "PhaseAsymmetry", asymmetry, isBetween(asymmetry, -1.0, 1.0), "between -1 and 1" } });
  if (fault.empty() &&
    (!(lobes[0] >= 0.0 && lobes[0] <= 1.0) || !isBetween(lobes[1], -1.0, 1.0) || !isBetween(lobes[2], -1.0, 1.0)))
  {
    fault = Sentence("PhaseLobes are ", lobes[0], ", ", lobes[1], ", ", lobes[2],
      ": the weight must be in 0..1, k1 and k2 between -1 and 1.");
  }
  return fault;
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
