// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TracedBoard.h
 * @brief Shadow vectors and photon paths of a board under a lamp, for tests of vtkConeSetFilter.
 */
#ifndef TracedBoard_h
#define TracedBoard_h

#include "TestPolyData.h"
#include "vtkAreaLightSource.h"
#include "vtkShadowVectorFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace shadowcones
{
namespace testsupport
{

/// Lamp, board and floor: 3000 vectors on the board's back.
class Traced
{
public:
  Traced()
  {
    this->Light = LampAbove(3.0);
    this->Filter->SetInputData(MeshBuilder().AddBox(0.0, 0.0, 1.0, 0.8, 0.8, 0.02, 4).AddSquare(0.0, 3.0, -1).Build());
    this->Filter->SetLightConnection(this->Light->GetOutputPort());
    this->Filter->SetTargetNumberOfVectors(3000);
    this->Filter->SetToPaper();
    this->Filter->SetSeed(9);
    this->Filter->Update();
  }
  /// Copies that a test may spoil.
  vtkSmartPointer<vtkPolyData> Vectors() { return this->Copy(0); }
  vtkSmartPointer<vtkPolyData> Paths() { return this->Copy(1); }

private:
  vtkSmartPointer<vtkPolyData> Copy(int port)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(this->Filter->GetOutput(port));
    return copy;
  }
  vtkSmartPointer<vtkAreaLightSource> Light;
  vtkNew<vtkShadowVectorFilter> Filter;
};

inline Traced& Board()
{
  static Traced traced;
  return traced;
}

} // namespace testsupport
} // namespace shadowcones

#endif
