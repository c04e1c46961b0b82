// SPDX-License-Identifier: BSD-3-Clause
#include "ReferencePixels.h"

#include "scReference.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <stdexcept>
#include <type_traits>

namespace shadowcones
{
namespace
{
double MeanOverWavelengths(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

/// To be raised where the rule of the reference changes.
constexpr int referenceVersion = 3;

/// FNV-1a over the bytes of everything that a reference depends on.
class ContentHash
{
public:
  template <class Value>
  void Add(const Value& value)
  {
    static_assert(std::is_arithmetic_v<Value>, "padding is no content");
    unsigned char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    for (const unsigned char byte : bytes)
    {
      this->State = (this->State ^ byte) * 0x100000001B3ull;
    }
  }
  template <class Value>
  void Add(const std::vector<Value>& values)
  {
    this->Add(values.size());
    for (const Value& value : values)
    {
      this->Add(value);
    }
  }
  void Add(const Vector3& v)
  {
    this->Add(v.X);
    this->Add(v.Y);
    this->Add(v.Z);
  }
  std::uint64_t Value() const { return this->State; }

private:
  std::uint64_t State = 0xCBF29CE484222325ull;
};

std::uint64_t HashOf(const BenchmarkScene& scene, int size, int pixels, int samples)
{
  const Light& light = scene.Light;
  const Medium& medium = scene.Medium;
  const Camera& camera = scene.Camera;
  ContentHash hash;
  for (const int number : { referenceVersion, size, pixels, samples })
  {
    hash.Add(number);
  }
  hash.Add(scene.Room.Points);
  hash.Add(scene.Room.Triangles);
  hash.Add(static_cast<int>(light.Shape));
  for (const Vector3& v : { light.Center, light.Normal, light.AxisU, light.AxisV })
  {
    hash.Add(v);
  }
  hash.Add(light.Radius);
  hash.Add(light.Spectrum);
  for (const std::array<Vector3, 3>& triangle : light.Triangles)
  {
    for (const Vector3& v : triangle)
    {
      hash.Add(v);
    }
  }
  for (const Vector3& v : light.Vertices)
  {
    hash.Add(v);
  }
  hash.Add(medium.SigmaS);
  hash.Add(medium.SigmaA);
  hash.Add(medium.Bounds.Min);
  hash.Add(medium.Bounds.Max);
  const PhaseFunction& phase = medium.Phase;
  hash.Add(static_cast<int>(phase.Kind));
  for (const double number : { phase.Asymmetry, phase.Lobes.Weight, phase.Lobes.K1, phase.Lobes.K2 })
  {
    hash.Add(number);
  }
  for (const Vector3& v : { camera.Position, camera.Forward, camera.Right, camera.Up })
  {
    hash.Add(v);
  }
  hash.Add(camera.Parallel);
  hash.Add(camera.HalfHeight);
  return hash.Value();
}

/// False where the file is not there or not whole.
bool ReadTruth(const std::string& file, std::vector<PixelTruth>& truth)
{
  std::ifstream in(file);
  std::vector<PixelTruth> kept(truth.size());
  for (PixelTruth& pixel : kept)
  {
    if (!(in >> pixel.I >> pixel.J >> pixel.Mean >> pixel.StandardError))
    {
      return false;
    }
  }
  truth.swap(kept);
  return true;
}

void WriteTruth(const std::string& file, const std::vector<PixelTruth>& truth)
{
  std::ofstream out(file);
  out << std::setprecision(12);
  for (const PixelTruth& pixel : truth)
  {
    out << pixel.I << ' ' << pixel.J << ' ' << pixel.Mean << ' ' << pixel.StandardError << '\n';
  }
  if (!out.flush())
  {
    throw std::runtime_error("Cannot write '" + file + "'.");
  }
}
} // namespace

//------------------------------------------------------------------------------
std::vector<PixelTruth> SpreadPixels(int size, int count)
{
  std::vector<PixelTruth> pixels(count);
  for (int k = 0; k < count; ++k)
  {
    const double turns = 0.61803398874989485 * static_cast<double>(k);
    pixels[k].I = static_cast<int>((turns - std::floor(turns)) * size);
    pixels[k].J = static_cast<int>((static_cast<double>(k) + 0.5) / count * size);
  }
  return pixels;
}

//------------------------------------------------------------------------------
std::vector<PixelTruth> ReferencePixels(
  const BenchmarkScene& scene, int size, int pixels, int samples, const std::string& folder)
{
  char hash[17];
  std::snprintf(hash, sizeof(hash), "%016llx", static_cast<unsigned long long>(HashOf(scene, size, pixels, samples)));
  const std::string file = folder + "/scattering-reference-" + scene.Name + "-" + hash + ".txt";
  std::vector<PixelTruth> truth = SpreadPixels(size, pixels);
  if (ReadTruth(file, truth))
  {
    return truth;
  }

  std::fprintf(stderr, "%s: making the reference, %d pixels x %d samples ...\n", scene.Name.c_str(), pixels, samples);
  const double start = Now();
  const ReferenceScene slow(scene.Room.View());
  vtkSMPTools::For(0, pixels, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        PixelTruth& pixel = truth[k];
        const ReferenceEstimate estimate =
          ReferenceInScattering(slow, scene.Light, scene.Medium, scene.Camera, pixel.I, pixel.J, size, size, samples);
        pixel.Mean = MeanOverWavelengths(estimate.Mean);
        pixel.StandardError = MeanOverWavelengths(estimate.StandardError);
      }
    });
  std::fprintf(stderr, "%s: %.0f s\n", scene.Name.c_str(), Now() - start);
  WriteTruth(file, truth);
  return truth;
}

//------------------------------------------------------------------------------
double MeanOfPixel(const ScatteringImage& image, std::size_t pixel)
{
  double value = 0.0;
  for (int k = 0; k < image.NumberOfWavelengths; ++k)
  {
    value += image.InScattering[pixel * image.NumberOfWavelengths + k];
  }
  return value / image.NumberOfWavelengths;
}

//------------------------------------------------------------------------------
ImageError Compare(const std::vector<double>& values, const std::vector<PixelTruth>& truth)
{
  double squares = 0.0;
  double noise = 0.0;
  double noiseSquares = 0.0;
  double sum = 0.0;
  double difference = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    const PixelTruth& pixel = truth[k];
    squares += (values[k] - pixel.Mean) * (values[k] - pixel.Mean);
    const double variance = pixel.StandardError * pixel.StandardError;
    noise += variance;
    noiseSquares += variance * variance;
    difference += values[k] - pixel.Mean;
    sum += pixel.Mean;
  }
  const auto count = static_cast<double>(truth.size());
  ImageError error;
  error.Rms = std::sqrt(std::max(squares - noise, 0.0) / count) / (sum / count);
  error.Bias = difference / sum;
  error.Reference = std::sqrt(noise / count) / (sum / count);
  error.Smallest = std::sqrt(2.0 * std::sqrt(2.0 * noiseSquares) / count) / (sum / count);
  return error;
}

} // namespace shadowcones
