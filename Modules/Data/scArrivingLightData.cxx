// SPDX-License-Identifier: BSD-3-Clause
#include "scArrivingLightData.h"

#include "scFieldArrays.h"
#include "scSpectrum.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace shadowcones
{
namespace
{
/// The values of @p components quantities at some places, and their errors, from what lights of the spectrum 1 bring.
class LightSums
{
public:
  /// @param weights of each light its spectrum, or what else it counts with, one a component.
  LightSums(std::vector<std::vector<double>> weights, vtkIdType places)
    : Weights(std::move(weights))
    , Components(this->Weights.empty() ? 0 : this->Weights.front().size())
    , Values(this->Components * static_cast<std::size_t>(places), std::numeric_limits<float>::quiet_NaN())
    , Errors(this->Values)
  {
  }

  /// @param factorOf, errorOf of a light by its index. The errors of lights do not depend on each other.
  template <typename Factor, typename Error>
  void Put(vtkIdType place, const Factor& factorOf, const Error& errorOf)
  {
    for (std::size_t c = 0; c < this->Components; ++c)
    {
      double sum = 0.0;
      double squares = 0.0;
      for (std::size_t light = 0; light < this->Weights.size(); ++light)
      {
        const double weight = this->Weights[light][c];
        sum += weight * factorOf(light);
        squares += weight * errorOf(light) * weight * errorOf(light);
      }
      const std::size_t at = static_cast<std::size_t>(place) * this->Components + c;
      this->Values[at] = static_cast<float>(sum);
      this->Errors[at] = static_cast<float>(std::sqrt(squares));
    }
  }

  void Write(const std::string& name, vtkDataSetAttributes* data) const
  {
    const auto components = static_cast<int>(this->Components);
    AddFloatArray(data, name.c_str(), components, this->Values);
    AddFloatArray(data, (name + "Error").c_str(), components, this->Errors);
  }

private:
  std::vector<std::vector<double>> Weights;
  std::size_t Components;
  std::vector<float> Values;
  std::vector<float> Errors;
};

std::vector<std::vector<double>> SpectraOf(const std::vector<Light>& lights)
{
  std::vector<std::vector<double>> spectra;
  for (const Light& light : lights)
  {
    spectra.push_back(light.Spectrum);
  }
  return spectra;
}

/// What the spectrum of each light is worth to the eye, lm for each W of a light of spectrum 1.
std::vector<std::vector<double>> LuminancesOf(const std::vector<Light>& lights, const std::vector<double>& efficacy)
{
  std::vector<std::vector<double>> luminances;
  for (const Light& light : lights)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < efficacy.size(); ++k)
    {
      sum += efficacy[k] * light.Spectrum[k];
    }
    luminances.push_back({ sum });
  }
  return luminances;
}

} // anonymous namespace

void WriteArrivingLight(const VisibilityResult& result, const std::vector<Light>& lights,
  const ArrivingLightRequest& request, const std::vector<vtkIdType>& items, vtkIdType count, vtkDataSetAttributes* data)
{
  const std::size_t numberOfLights = lights.size();
  const auto write = [&](const char* name, std::vector<std::vector<double>> weights, const std::vector<float>& factors,
                       const std::vector<float>& errors)
  {
    LightSums sums(std::move(weights), count);
    for (std::size_t k = 0; k < items.size(); ++k)
    {
      const std::size_t first = k * numberOfLights;
      sums.Put(
        items[k], [&](std::size_t light) { return static_cast<double>(factors[first + light]); },
        [&](std::size_t light) { return static_cast<double>(errors[first + light]); });
    }
    sums.Write(name, data);
  };
  if (request.Irradiance)
  {
    write("Irradiance", SpectraOf(lights), result.Irradiance, result.IrradianceErrors);
  }
  if (request.Illuminance)
  {
    write("Illuminance", LuminancesOf(lights, request.Efficacy), result.Irradiance, result.IrradianceErrors);
  }
  if (request.FluenceRate)
  {
    write("FluenceRate", SpectraOf(lights), result.Fluence, result.FluenceErrors);
  }
}

void WriteFluenceRate(
  const std::vector<VisibilityGrid>& grids, const std::vector<Light>& lights, const int extent[6], vtkImageData* output)
{
  const VisibilityGrid& first = grids.front();
  if (first.Fluence.empty())
  {
    return;
  }
  LightSums sums(SpectraOf(lights), output->GetNumberOfPoints());
  vtkIdType to = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++to)
      {
        const std::size_t from = first.VertexIndex(i, j, k);
        sums.Put(
          to, [&](std::size_t light) { return static_cast<double>(grids[light].Fluence[from]); },
          [&](std::size_t light) { return static_cast<double>(grids[light].FluenceErrors[from]); });
      }
    }
  }
  sums.Write("FluenceRate", output->GetPointData());
}

std::vector<double> LuminousEfficacyAt(const std::vector<double>& wavelengths)
{
  constexpr double mostEfficacy = 683.0; // lm/W, at 555 nm
  std::vector<double> efficacy;
  for (const double wavelength : wavelengths)
  {
    efficacy.push_back(mostEfficacy * CieXyz(wavelength)[1]);
  }
  return efficacy;
}

} // namespace shadowcones
