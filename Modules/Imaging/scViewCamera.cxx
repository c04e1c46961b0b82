// SPDX-License-Identifier: BSD-3-Clause
#include "scViewCamera.h"

#include "scSentence.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <cmath>

namespace shadowcones
{
namespace
{
Vector3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

} // anonymous namespace

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
    error = Sentence("The camera's position and focal point must be finite and differ.");
    return false;
  }
  if (!(Length(right) > 1e-9 * Length(up)))
  {
    error = Sentence("The camera's view up runs along its direction of view: choose another with SetViewUp().");
    return false;
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
    error = Sentence("The camera's ", used.Parallel ? "parallel scale" : "view angle", " must be above 0.");
    return false;
  }
  return true;
}

} // namespace shadowcones
