// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterChain.h
 * @brief Mesh and light to labels, shadow vectors and cones, by the filters.
 */
#ifndef FilterChain_h
#define FilterChain_h

#include "Messages.h"

#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace shadowcones
{
namespace testsupport
{

/// With the parameters of the paper, until a test sets others.
class FilterChain
{
public:
  FilterChain(vtkPolyData* mesh, vtkPolyData* light, vtkIdType vectors)
  {
    this->Vectors->SetToPaper();
    this->Cones->SetToPaper();
    this->Labels->SetInputData(mesh);
    this->Vectors->SetInputConnection(this->Labels->GetOutputPort());
    this->Vectors->SetLightData(light);
    this->Vectors->SetTargetNumberOfVectors(vectors);
    this->Cones->SetInputConnection(this->Vectors->GetOutputPort());
    this->Cones->SetPhotonPathConnection(this->Vectors->GetOutputPort(1));
  }
  void Update()
  {
    Messages labels(this->Labels);
    Messages traced(this->Vectors);
    Messages fitted(this->Cones);
    this->Cones->Update();
    this->Said = labels.Errors + labels.Warnings + traced.Errors + traced.Warnings + fitted.Errors + fitted.Warnings;
  }
  double Cone(const char* array, vtkIdType cone, int component = 0)
  {
    return this->Cones->GetOutput()->GetPointData()->GetArray(array)->GetComponent(cone, component);
  }

  vtkNew<vtkLabelOccluders> Labels;
  vtkNew<vtkShadowVectorFilter> Vectors;
  vtkNew<vtkConeSetFilter> Cones;
  std::string Said; ///< by all three, at the last update
};

} // namespace testsupport
} // namespace shadowcones

#endif
