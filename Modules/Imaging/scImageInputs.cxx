// SPDX-License-Identifier: BSD-3-Clause
#include "scImageInputs.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace shadowcones
{
namespace
{
Vector3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

/// Put a sentence together; always false, for a return.
template <typename... Parts>
bool Fail(std::string& error, const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  error = text.str();
  return false;
}
} // anonymous namespace

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
    return Fail(error, "Set", name, "Spectrum was given wavelength sample ", spectrum.size() - 1,
      ", but the light has ", wavelengths, " samples.");
  }
  values.resize(wavelengths);
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    values[k] = GetSample(spectrum, static_cast<int>(k), all);
    if (!(values[k] >= 0.0) || std::isinf(values[k]))
    {
      return Fail(error, name, " is ", values[k], " at wavelength sample ", k, ": it must be 0 or above and finite.");
    }
  }
  return true;
}

bool ReadBounds(const char* name, const double bounds[6], Box& box, std::string& error)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double from = bounds[2 * axis];
    const double to = bounds[2 * axis + 1];
    if (!(from <= to) || !std::isfinite(from) || !std::isfinite(to))
    {
      return Fail(error, name, " along ", "xyz"[axis], " run from ", from, " to ", to,
        ": they must be finite and in ascending order.");
    }
  }
  box = { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
  return true;
}

void LookAtFront(const Box& box, vtkCamera* camera)
{
  const double distance = 0.5 * box.Diagonal() / std::sin(vtkMath::RadiansFromDegrees(15.0));
  const Vector3 center = box.Center();
  camera->SetViewAngle(30.0);
  camera->SetFocalPoint(center.X, center.Y, center.Z);
  camera->SetPosition(center.X, center.Y, center.Z + (distance > 0.0 ? distance : 1.0));
  camera->SetViewUp(0.0, 1.0, 0.0);
}

bool ReadCamera(vtkCamera* camera, const int resolution[2], Camera& used, std::string& error)
{
  const Vector3 up = ToVector(camera->GetViewUp());
  const Vector3 view = ToVector(camera->GetFocalPoint()) - ToVector(camera->GetPosition());
  used.Position = ToVector(camera->GetPosition());
  used.Forward = Normalized(view);
  const Vector3 right = Cross(used.Forward, up);
  if (!IsFinite(view) || !IsFinite(right) || !(Length(view) > 0.0))
  {
    return Fail(error, "The camera's position and focal point must be finite and differ.");
  }
  if (!(Length(right) > 1e-9 * Length(up)))
  {
    return Fail(error, "The camera's view up runs along its direction of view: choose another with SetViewUp().");
  }
  used.Right = Normalized(right);
  used.Up = Cross(used.Right, used.Forward);
  used.Parallel = camera->GetParallelProjection() != 0;
  used.HalfHeight = camera->GetParallelScale();
  if (!used.Parallel)
  {
    used.HalfHeight = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    if (camera->GetUseHorizontalViewAngle())
    {
      used.HalfHeight *= static_cast<double>(resolution[1]) / resolution[0];
    }
  }
  if (!(used.HalfHeight > 0.0) || std::isinf(used.HalfHeight))
  {
    return Fail(error, "The camera's ", used.Parallel ? "parallel scale" : "view angle", " must be above 0.");
  }
  return true;
}

bool ReadReflectance(vtkPolyData* mesh, const std::vector<vtkIdType>& sourceCells, std::size_t wavelengths,
  ScatteringOptions& options, std::string& error)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray("Reflectance");
  if (!array)
  {
    return true;
  }
  const int components = array->GetNumberOfComponents();
  if (components != 1 && components != static_cast<int>(wavelengths))
  {
    return Fail(error, "Cell array \"Reflectance\" of the mesh has ", components, " components: it must have 1, or ",
      wavelengths, " as the light has wavelength samples.");
  }
  if (array->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    return Fail(error, "Cell array \"Reflectance\" of the mesh has ", array->GetNumberOfTuples(), " tuples for ",
      mesh->GetNumberOfCells(), " cells.");
  }
  options.ReflectanceComponents = components;
  options.SurfaceReflectance.reserve(sourceCells.size() * static_cast<std::size_t>(components));
  for (const vtkIdType cell : sourceCells)
  {
    for (int c = 0; c < components; ++c)
    {
      const double value = array->GetComponent(cell, c);
      if (!(value >= 0.0 && value <= 1.0))
      {
        return Fail(
          error, "Cell array \"Reflectance\" of the mesh is ", value, " at cell ", cell, ": it must be in 0..1.");
      }
      options.SurfaceReflectance.push_back(static_cast<float>(value));
    }
  }
  return true;
}

} // namespace shadowcones
