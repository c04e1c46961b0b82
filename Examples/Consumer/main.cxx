// SPDX-License-Identifier: BSD-3-Clause
// The chain on a cube under a lamp, and a few numbers of it: the least that a program of your own needs.
#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"

#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputConnection(cube->GetOutputPort());

  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(0.0, 3.0, 0.0);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.3);
  light->SetRadiance(10.0);

  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputConnection(occluders->GetOutputPort());
  vectors->SetLightConnection(light->GetOutputPort());
  vectors->SetTargetNumberOfVectors(5000);

  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetPhotonPathConnection(vectors->GetOutputPort(1));
  cones->SetMeshConnection(occluders->GetOutputPort());

  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(occluders->GetOutputPort());
  image->SetLightConnection(light->GetOutputPort());
  image->SetConeSetConnection(cones->GetOutputPort());
  image->SetResolution(48, 48);
  image->SetMediumBounds(-2.0, 2.0, -2.0, 3.0, -2.0, 2.0);
  image->Update();

  vtkDataArray* scattered = image->GetOutput()->GetPointData()->GetArray("InScattering");
  const vtkIdType numberOfVectors = vectors->GetOutput()->GetNumberOfPoints();
  const vtkIdType numberOfCones = cones->GetOutput()->GetNumberOfPoints();
  if (!scattered || numberOfVectors == 0 || numberOfCones == 0)
  {
    std::cerr << "The chain gave nothing: its messages stand above\n";
    return EXIT_FAILURE;
  }

  double range[2];
  scattered->GetRange(range, 0);
  std::cout << "shadow vectors " << numberOfVectors << "\ncones " << numberOfCones << "\nin-scattered radiance "
            << range[0] << " to " << range[1] << " W m^-2 sr^-1\n";
  return range[1] > range[0] ? EXIT_SUCCESS : EXIT_FAILURE;
}
