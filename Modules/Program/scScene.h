// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScene.h
 * @brief The meshes and lights that a command is about, as its command line names them.
 */
#ifndef scScene_h
#define scScene_h

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}
class vtkAreaLightSource;
class vtkLabelOccluders;
class vtkSceneDefaults;

namespace shadowcones
{
/// What every command takes.
struct SceneOptions
{
  std::vector<std::string> Meshes;
  std::vector<std::string> Lights; ///< words, as they were split by the shell
  std::string Occluders = "auto";
  std::string Unit = "m";
  std::string Up;
  int Seed = 1;
  bool Quiet = false;
};

/// The options of SceneOptions, for a command line. @param lights  whether it takes lights
void AddSceneOptions(CLI::App* command, SceneOptions& options, bool lights = true);

/// What was read: labelled occluders that are up to date, at least one light where lights are asked for, and what suits them.
class Scene
{
public:
  /// Read the files and the words. Throws a Failure that names the file or the word.
  explicit Scene(const SceneOptions& options, bool lights = true);
  ~Scene();

  vtkNew<vtkLabelOccluders> Occluders;
  std::vector<vtkSmartPointer<vtkAlgorithm>> Lights;
  vtkNew<vtkSceneDefaults> Defaults;
  double Up[3] = { 0.0, 0.0, 1.0 };

  /// Connect each of the lights to a filter.
  template <typename Filter>
  void ConnectLights(Filter* filter) const
  {
    for (const auto& light : this->Lights)
    {
      filter->AddLightConnection(light->GetOutputPort());
    }
  }
};
} // namespace shadowcones

#endif
