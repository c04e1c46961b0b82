// SPDX-License-Identifier: BSD-3-Clause
#include "RoomImage.h"

#include "scReference.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <stdexcept>

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

/// Part of the header of kept references: to be raised where the rule of the reference changes.
constexpr int referenceVersion = 2;

/// A number that changes with the scene, so that a stale file is not read.
double Fingerprint(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < mesh.Points.size(); ++k)
  {
    sum += mesh.Points[k] * std::cos(static_cast<double>(k));
  }
  return sum;
}
} // namespace

//------------------------------------------------------------------------------
Camera RoomCamera()
{
  Camera camera;
  camera.Position = { 0.0, 2.65, 10.0 };
  camera.HalfHeight = 0.37;
  return camera;
}

//------------------------------------------------------------------------------
Medium RoomMedium(const Light& light)
{
  Medium medium;
  medium.SigmaS.assign(light.Spectrum.size(), 0.12);
  medium.SigmaA.assign(light.Spectrum.size(), 0.0);
  medium.Bounds = RoomBounds();
  return medium;
}

//------------------------------------------------------------------------------
Room BuildRoom(const BenchmarkScene& scene, std::size_t wavelengths)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(SHADOWCONES_DATA_DIR "/cornell-box.vtp");
  reader->Update();
  TriangleMesh walls;
  std::string error;
  if (!ReadTriangles(reader->GetOutput(), walls, error))
  {
    throw std::runtime_error(error);
  }
  Room room;
  room.Mesh = scene.Mesh;
  room.Mesh.OccluderIds.resize(room.Mesh.Triangles.size() / 3, 0);
  room.Reflectance.assign(room.Mesh.OccluderIds.size() * wavelengths, 0.5f);
  const auto offset = static_cast<vtkIdType>(room.Mesh.Points.size() / 3);
  room.Mesh.Points.insert(room.Mesh.Points.end(), walls.Points.begin(), walls.Points.end());
  for (const vtkIdType id : walls.Triangles)
  {
    room.Mesh.Triangles.push_back(id + offset);
  }
  room.Mesh.OccluderIds.resize(room.Mesh.Triangles.size() / 3, -1);
  vtkDataArray* reflectance = reader->GetOutput()->GetCellData()->GetArray("Reflectance");
  for (const vtkIdType cell : walls.SourceCells)
  {
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      room.Reflectance.push_back(static_cast<float>(reflectance->GetComponent(cell, static_cast<int>(k))));
    }
  }
  return room;
}

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
  const BenchmarkScene& scene, const Room& room, int size, int pixels, int samples, const std::string& folder)
{
  char header[200];
  std::snprintf(header, sizeof(header), "%d %s %d %d %d %.6f", referenceVersion, scene.Name.c_str(), size,
    pixels, samples, Fingerprint(room.Mesh));
  const std::string file = folder + "/scattering-reference-" + scene.Name + ".txt";
  std::vector<PixelTruth> truth = SpreadPixels(size, pixels);
  std::ifstream in(file);
  std::string line;
  if (in && std::getline(in, line) && line == header)
  {
    bool whole = true;
    for (PixelTruth& pixel : truth)
    {
      whole = whole && static_cast<bool>(in >> pixel.I >> pixel.J >> pixel.Mean >> pixel.StandardError);
    }
    if (whole)
    {
      return truth;
    }
  }

  std::fprintf(stderr, "%s: making the reference, %d pixels x %d samples ...\n", scene.Name.c_str(), pixels,
    samples);
  const double start = Now();
  const ReferenceScene slow(room.Mesh.View());
  const Medium medium = RoomMedium(scene.Source);
  const Camera camera = RoomCamera();
  vtkSMPTools::For(0, pixels, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        PixelTruth& pixel = truth[k];
        const ReferenceEstimate estimate = ReferenceInScattering(
          slow, scene.Source, medium, camera, pixel.I, pixel.J, size, size, samples);
        pixel.Mean = MeanOverWavelengths(estimate.Mean);
        pixel.StandardError = MeanOverWavelengths(estimate.StandardError);
      }
    });
  std::fprintf(stderr, "%s: %.0f s\n", scene.Name.c_str(), Now() - start);
  std::ofstream out(file);
  out << header << '\n' << std::setprecision(12);
  for (const PixelTruth& pixel : truth)
  {
    out << pixel.I << ' ' << pixel.J << ' ' << pixel.Mean << ' ' << pixel.StandardError << '\n';
  }
  return truth;
}

//------------------------------------------------------------------------------
ImageError Compare(const std::vector<double>& values, const std::vector<PixelTruth>& truth)
{
  double squares = 0.0;
  double noise = 0.0;
  double sum = 0.0;
  double difference = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    const PixelTruth& pixel = truth[k];
    squares += (values[k] - pixel.Mean) * (values[k] - pixel.Mean);
    noise += pixel.StandardError * pixel.StandardError;
    difference += values[k] - pixel.Mean;
    sum += pixel.Mean;
  }
  const auto count = static_cast<double>(truth.size());
  ImageError error;
  error.Rms = std::sqrt(std::max(squares - noise, 0.0) / count) / (sum / count);
  error.Bias = difference / sum;
  error.Reference = std::sqrt(noise / count) / (sum / count);
  return error;
}

} // namespace shadowcones
