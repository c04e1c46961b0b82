// SPDX-License-Identifier: BSD-3-Clause
// Other ways to hold a shadow (section 2.2 of the paper) against cones: build, memory, time and error of the same image.
//
// Only the medium term counts. All go through one marcher: the unshadowed light of a pixel, the same number for all, less the share
// that a rival says is blocked at places along the ray. Path tracing and the modes of the modules make whole images of their own.
#include "JsonWriter.h"
#include "ProgramOptions.h"
#include "RivalRows.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkXMLImageDataWriter.h"

#include <cctype>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{
const char* const bunnyFile = "/usr/share/glmark2/models/bunny.obj";

std::vector<std::string> DefaultScenes()
{
  std::vector<std::string> scenes = { "chair", "tree", "blob" };
  if (std::ifstream(bunnyFile))
  {
    scenes.emplace_back("bunny");
  }
  return scenes;
}

void Print(const RivalFigures& figures, const RivalSetting& setting)
{
  std::printf("# %s: %lld triangles, %lld cones, %d x %d pixels, %d places a ray; unshadowed light %.3f s, in every image but those "
              "marked w; reference: noise %.4f, errors below %.4f cannot be told from none\n",
    figures.Scene.c_str(), static_cast<long long>(figures.Triangles), static_cast<long long>(figures.Cones), setting.Size,
    setting.Size, setting.Places, figures.LitSeconds, figures.ReferenceNoise, figures.SmallestError);
  std::printf("%-24s %-28s %8s %8s %9s %8s %8s\n", "rival", "setting", "build s", "MB", "image s", "error", "bias");
  for (const RivalRow& row : figures.Rows)
  {
    std::printf("%-24s %-28s ", row.Name.c_str(), row.Setting.c_str());
    if (!row.Fault.empty())
    {
      std::printf("%s\n", row.Fault.c_str());
      continue;
    }
    std::printf("%8.3f %8.2f %8.3f%c %7.2f%% %+7.2f%%\n", row.BuildSeconds, row.Megabytes, row.ImageSeconds, row.Whole ? 'w' : ' ',
      100.0 * row.Error.Rms, 100.0 * row.Error.Bias);
  }
  std::fflush(stdout);
}

void WriteJson(const RivalFigures& figures, JsonWriter& json)
{
  json.BeginObject();
  json.Write("scene", figures.Scene);
  json.Write("triangles", figures.Triangles);
  json.Write("cones", figures.Cones);
  json.Write("litSeconds", figures.LitSeconds);
  json.Write("smallestError", figures.SmallestError);
  json.BeginList("rows");
  for (const RivalRow& row : figures.Rows)
  {
    json.BeginObject();
    json.Write("rival", row.Name);
    json.Write("setting", row.Setting);
    json.Write("fault", row.Fault);
    json.Write("buildSeconds", row.BuildSeconds);
    json.Write("megabytes", row.Megabytes);
    json.Write("imageSeconds", row.ImageSeconds);
    json.Write("whole", row.Whole);
    json.Write("error", row.Error.Rms);
    json.Write("bias", row.Error.Bias);
    json.EndObject();
  }
  json.EndList();
  json.EndObject();
}

/// Letters and digits, the rest as single hyphens.
std::string FileName(const std::string& text)
{
  std::string name;
  for (const char c : text)
  {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain || (!name.empty() && name.back() != '-'))
    {
      name += plain ? c : '-';
    }
  }
  return name.substr(0, name.find_last_not_of('-') + 1);
}

void WriteImages(const RivalFigures& figures, int size, const std::string& folder)
{
  for (const RivalRow& row : figures.Rows)
  {
    if (row.Image.empty())
    {
      continue;
    }
    vtkNew<vtkDoubleArray> values;
    values->SetName("InScattering");
    for (const double value : row.Image)
    {
      values->InsertNextValue(value);
    }
    vtkNew<vtkImageData> image;
    image->SetDimensions(size, size, 1);
    image->GetPointData()->SetScalars(values);
    vtkNew<vtkXMLImageDataWriter> writer;
    const std::string file = folder + "/" + FileName(figures.Scene + " " + row.Name + " " + row.Setting) + ".vti";
    writer->SetFileName(file.c_str());
    writer->SetInputData(image);
    if (!writer->Write())
    {
      throw std::runtime_error("Cannot write '" + file + "'.");
    }
  }
}
} // namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Other ways to hold a shadow against cones: the same image through the same marcher.");
  RivalSetting setting;
  std::vector<std::string> scenes = DefaultScenes();
  std::string images;
  std::string jsonFile;
  int threads = 2;
  commandLine.Add("--scene", scenes, "chair, tree, blob, bunny (glmark2's), blinds, canopy, holes, colonnade, or a mesh file");
  commandLine.Add("--rows", setting.Rows, "only rivals whose name and setting hold this text");
  commandLine.AddPositive("--size", setting.Size, "width and height in pixels");
  commandLine.AddPositive("--places", setting.Places, "places along a ray");
  commandLine.AddPositive("--pixels", setting.Pixels, "pixels that are compared with the reference");
  commandLine.AddPositive("--samples", setting.Samples, "samples of the reference for each");
  commandLine.AddPositive("--light-radius", setting.Light.Radius, "radius of the room's disc light; .001 for a point");
  commandLine.Add("--threads", threads, "threads; times are of the processor, all threads together");
  commandLine.Add("--images", images, "folder that receives every image as .vti");
  commandLine.Add("--json", jsonFile, "file that receives the figures");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    vtkSMPTools::Initialize(threads);
    std::ofstream file;
    JsonWriter json(file);
    if (!jsonFile.empty())
    {
      file.open(jsonFile);
      json.BeginList();
    }
    for (const std::string& name : scenes)
    {
      const RivalFigures figures = MeasureRivals(name == "bunny" ? bunnyFile : name, setting);
      Print(figures, setting);
      if (!images.empty())
      {
        WriteImages(figures, setting.Size, images);
      }
      if (!jsonFile.empty())
      {
        WriteJson(figures, json);
      }
    }
    if (!jsonFile.empty())
    {
      json.EndList();
      if (!file.flush())
      {
        throw std::runtime_error("Cannot write '" + jsonFile + "'.");
      }
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "rivals: %s\n", failure.what());
    return 1;
  }
  return 0;
}
