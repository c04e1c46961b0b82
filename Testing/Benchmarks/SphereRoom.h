// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SphereRoom.h
 * @brief A sphere of many triangles beneath a disc light, and the filters that make volumes and images of it.
 */
#ifndef SphereRoom_h
#define SphereRoom_h

#include "BenchmarkScene.h"

#include "vtkAreaLightSource.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScatteringImageFilter.h"
#include "vtkSphereSource.h"
#include "vtkVisibilityVolume.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace shadowcones
{

inline double SecondsOf(const std::function<void()>& run)
{
  const double start = Now();
  run();
  return Now() - start;
}

/// A sphere of about so many triangles in the middle of the room, beneath a disc light, seen from the front.
struct SphereRoom
{
  explicit SphereRoom(double triangles)
  {
    const int across = std::max(8, static_cast<int>(std::lround(std::sqrt(triangles))));
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(across);
    source->SetPhiResolution(across / 2 + 1);
    source->SetRadius(1.0);
    source->SetCenter(0.0, 2.5, 0.0);
    source->Update();
    this->Mesh->ShallowCopy(source->GetOutput());
    this->Mesh->GetPointData()->SetNormals(nullptr);
    this->Light->SetShapeToDisc();
    this->Light->SetCenter(0.0, 5.49, 0.0);
    this->Light->SetNormal(0.0, -1.0, 0.0);
    this->Light->SetRadius(0.5);
    this->Volume->SetMeshData(this->Mesh);
    this->Volume->SetLightConnection(this->Light->GetOutputPort());
    this->Volume->SetBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
    this->Camera->SetPosition(0.0, 2.65, 10.0);
    this->Camera->SetFocalPoint(0.0, 2.65, 0.0);
    this->Image->SetInputData(this->Mesh);
    this->Image->SetLightConnection(this->Light->GetOutputPort());
    this->Image->SetVisibilityVolumeConnection(this->Volume->GetOutputPort());
    this->Image->SetModeToVolume();
    this->Image->SetCamera(this->Camera);
    this->Image->SetMediumBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  }
  double Frame()
  {
    return SecondsOf(
      [this]
      {
        this->Camera->Azimuth(0.5);
        this->Image->Update();
      });
  }
  double MedianOfFrames(int count)
  {
    std::vector<double> seconds;
    for (int k = 0; k < count; ++k)
    {
      seconds.push_back(this->Frame());
    }
    std::nth_element(seconds.begin(), seconds.begin() + count / 2, seconds.end());
    return seconds[static_cast<std::size_t>(count / 2)];
  }

  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkAreaLightSource> Light;
  vtkNew<vtkVisibilityVolume> Volume;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkScatteringImageFilter> Image;
};

} // namespace shadowcones

#endif
