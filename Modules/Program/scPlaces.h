// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPlaces.h
 * @brief Where a command asks: points, a table of them, a data set, a grid, the ground, or the mesh itself.
 */
#ifndef scPlaces_h
#define scPlaces_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}
class vtkDataSet;

namespace shadowcones
{
class Scene;

/// Where to ask, as the command line says; one of the first four, else the mesh itself.
struct PlaceOptions
{
  std::vector<std::string> Points; ///< x,y,z each
  std::string File;                ///< csv, or what a mesh may be
  std::string Grid;                ///< nx,ny,nz
  std::string Ground;              ///< height,size,points
  std::vector<double> Bounds;      ///< of the grid
  std::vector<double> Facing;      ///< normal of points
};

/// The options of PlaceOptions. @param surfaces  only places that are surfaces
void AddPlaceOptions(CLI::App* command, PlaceOptions& options, bool surfaces);

/// The data set to ask at, with normals where it has a side. Throws a Failure.
vtkSmartPointer<vtkDataSet> FindPlaces(const PlaceOptions& options, const Scene& scene);

/// "1,2,3" as numbers; throws a Failure that names @p option where it is not @p count of them.
std::vector<double> ReadNumbers(const std::string& text, std::size_t count, const std::string& option);
} // namespace shadowcones

#endif
