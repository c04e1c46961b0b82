// SPDX-License-Identifier: BSD-3-Clause
#include "scScene.h"

#include "scFailure.h"
#include "scUpdate.h"
#include "vtkAlgorithm.h"
#include "vtkAreaLightSource.h"
#include "vtkLabelOccluders.h"
#include "vtkLightWords.h"
#include "vtkMeshFiles.h"
#include "vtkPolyData.h"
#include "vtkSceneDefaults.h"

#include <CLI/CLI.hpp>

namespace
{
using shadowcones::ExitUsage;
using shadowcones::Failure;
using shadowcones::SceneOptions;

/// Metres in a world unit.
double UnitLength(const std::string& unit)
{
  static const std::pair<const char*, double> units[] = { { "mm", 0.001 }, { "cm", 0.01 }, { "m", 1.0 },
    { "km", 1000.0 }, { "in", 0.0254 }, { "ft", 0.3048 } };
  for (const auto& [name, metres] : units)
  {
    if (unit == name)
    {
      return metres;
    }
  }
  char* end = nullptr;
  const double metres = std::strtod(unit.c_str(), &end);
  if (unit.empty() || *end != '\0' || !(metres > 0.0))
  {
    throw Failure(
      "--unit " + unit + ": expected mm, cm, m, km, in, ft, or the metres in a unit, such as 0.01", ExitUsage);
  }
  return metres;
}

/// The words of the lamps, one lamp a line: the shell has split them, and each lamp begins with a word that has a colon.
std::string LightText(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    const bool begins =
      word.find(':') != std::string::npos || word.find(' ') != std::string::npos || vtkMeshFiles::IsMeshFileName(word);
    text += text.empty() ? "" : begins ? "\n" : " ";
    text += word;
  }
  return text;
}

int AxisOf(const std::string& up)
{
  return up.empty() ? vtkSceneDefaults::Automatic
    : up == "x"     ? vtkSceneDefaults::X
    : up == "y"     ? vtkSceneDefaults::Y
                    : vtkSceneDefaults::Z;
}

void ReadMeshes(const SceneOptions& options, vtkLabelOccluders* occluders)
{
  vtkNew<vtkMeshFiles> files;
  for (const std::string& name : options.Meshes)
  {
    files->AddFileName(name);
  }
  files->SetOccludersBy(options.Occluders == "file" ? vtkMeshFiles::File
      : options.Occluders == "component"            ? vtkMeshFiles::Component
                                                    : vtkMeshFiles::Automatic);
  if (!files->Read())
  {
    throw Failure(files->GetError());
  }
  files->LabelOccluders(occluders);
}
} // namespace

namespace shadowcones
{
void AddSceneOptions(CLI::App* command, SceneOptions& options, bool lights)
{
  command->add_option("MESH", options.Meshes, "Files of meshes: " + vtkMeshFiles::GetFormats())
    ->required()
    ->type_name("FILE");
  if (lights)
  {
    command
      ->add_option("--light", options.Lights,
        "Lamps in words: disc:0,5,0 radius 0.5 facing 0,-1,0; rectangle:, sphere:, point:, 'sun: azimuth 135 altitude "
        "40'; or "
        "the name of a mesh file or of a text file with lamps. Default: a lamp that suits the mesh")
      ->type_name("WORDS");
  }
  command
    ->add_option("--occluders", options.Occluders, "What makes one occluder: each file, or each component of a mesh")
    ->check(CLI::IsMember({ "auto", "file", "component" }))
    ->capture_default_str();
  command->add_option("--unit", options.Unit, "What a unit of the mesh is: mm, cm, m, km, in, ft, or metres")
    ->capture_default_str();
  command->add_option("--up", options.Up, "Which way is up. Default: what mesh and lights speak for")
    ->check(CLI::IsMember({ "x", "y", "z" }));
  command->add_option("--seed", options.Seed, "Seed of the random numbers: the same gives the same bytes")
    ->capture_default_str();
  command->add_flag("-q,--quiet", options.Quiet, "No progress and no warnings");
}

Scene::Scene(const SceneOptions& options, bool lights)
{
  ReadMeshes(options, this->Occluders);
  Update(this->Occluders, "reading", options.Quiet);
  this->Defaults->SetUp(AxisOf(options.Up));
  this->Defaults->SetMesh(this->Occluders->GetOutput());

  if (lights && !options.Lights.empty())
  {
    vtkNew<vtkLightWords> words;
    words->SetUnitLength(UnitLength(options.Unit));
    if (!options.Up.empty())
    {
      words->SetUp(options.Up == "x", options.Up == "y", options.Up == "z");
    }
    const std::string text = LightText(options.Lights);
    if (!words->Read(text))
    {
      throw Failure(words->GetError() + "\n  --light " + text, words->GetErrorLine() ? ExitUsage : ExitFailed);
    }
    for (int i = 0; i < words->GetNumberOfLights(); ++i)
    {
      this->Lights.emplace_back(words->GetLight(i));
      Update(this->Lights.back(), "lamps", true);
      this->Defaults->AddLight(this->Lights.back()->GetOutputDataObject(0));
    }
  }
  if (!this->Defaults->Find())
  {
    throw Failure(this->Defaults->GetError());
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Up[axis] = this->Defaults->GetFoundUp() == axis + 1;
  }
  if (lights && this->Lights.empty())
  {
    vtkNew<vtkAreaLightSource> lamp;
    this->Defaults->PlaceLight(lamp);
    this->Lights.emplace_back(lamp);
  }
}

Scene::~Scene() = default;
} // namespace shadowcones
