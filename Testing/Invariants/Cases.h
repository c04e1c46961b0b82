// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cases.h
 * @brief Every filter of the project in a ready-made setting, for tests of what all of them promise.
 */
#ifndef Cases_h
#define Cases_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace invariants
{

/// A filter, and data for its input ports. Tests connect them, so that they can look at the data afterwards.
struct Setting
{
  vtkSmartPointer<vtkAlgorithm> Filter;
  std::vector<std::pair<int, vtkSmartPointer<vtkDataObject>>> Inputs; ///< port, data
  void Connect();
};

enum class Size
{
  Small, ///< well under a second
  Large  ///< a second and more: an abort shows
};

struct Case
{
  std::string Name;
  std::function<Setting(Size)> Make;
  bool Long = true;    ///< has work to report progress of, and to abort
  bool Divides = true; ///< pieces are parts; else each piece is the whole
  int TimelessPort = -1; ///< an input that is the same at all times: its times are not offered
};

inline void PrintTo(const Case& one, std::ostream* os)
{
  *os << one.Name;
}

const std::vector<Case>& AllCases();

/// The mesh with labels of vtkLabelOccluders.
vtkSmartPointer<vtkPolyData> LabelledMesh(vtkPolyData* input);
/// The lamp of the examples' room, moved and scaled.
vtkSmartPointer<vtkPolyData> RoomLamp(double scale = 1.0, double offset = 0.0);

} // namespace invariants

#endif
