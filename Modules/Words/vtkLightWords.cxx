// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightWords.h"

#include "scFieldArrays.h"
#include "scLightData.h"
#include "scLightGrammar.h"
#include "scLightText.h"
#include "scMeshFile.h"
#include "scMeshFormats.h"
#include "scSentence.h"
#include "scSpectrum.h"
#include "vtkAreaLightSource.h"

#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace
{

using namespace shadowcones;

// Watts that leave a lamp whose radiance (of a point: intensity, W/sr per square of a world unit) is 1.
double EmissionOf(LightShape shape, double area, double unitLength)
{
  const double squareMetres = unitLength * unitLength;
  return shape == LightShape::Sun ? 1.0 : squareMetres * (area > 0.0 ? vtkMath::Pi() * area : 4.0 * vtkMath::Pi());
}

double AreaOf(const Lamp& lamp)
{
  switch (lamp.Shape)
  {
    case LightShape::Disc:
      return vtkMath::Pi() * lamp.Radius * lamp.Radius;
    case LightShape::Sphere:
      return 4.0 * vtkMath::Pi() * lamp.Radius * lamp.Radius;
    case LightShape::Rectangle:
      return lamp.Width * lamp.Height;
    default:
      return 0.0;
  }
}

vtkSmartPointer<vtkAreaLightSource> SourceOf(const Lamp& lamp, double unitLength)
{
  auto source = vtkSmartPointer<vtkAreaLightSource>::New();
  source->SetShape(static_cast<int>(lamp.Shape));
  source->SetCenter(lamp.Center.X, lamp.Center.Y, lamp.Center.Z);
  source->SetNormal(lamp.Normal.X, lamp.Normal.Y, lamp.Normal.Z);
  source->SetUp(lamp.Up.X, lamp.Up.Y, lamp.Up.Z);
  source->SetRadius(lamp.Radius);
  source->SetWidth(lamp.Width);
  source->SetHeight(lamp.Height);
  source->SetAngularDiameter(lamp.AngularDiameter);
  source->SetResolution(lamp.Resolution);
  source->SetNumberOfWavelengths(lamp.NumberOfWavelengths);
  const std::vector<double> radiances = RadiancesOf(lamp, EmissionOf(lamp.Shape, AreaOf(lamp), unitLength));
  source->SetRadiance(radiances.front());
  for (int i = 0; radiances.size() > 1 && i < lamp.NumberOfWavelengths; ++i)
  {
    source->SetRadianceSpectrum(i, radiances[i]);
  }
  return source;
}

vtkSmartPointer<vtkAlgorithm> MeshLampOf(const Lamp& lamp, double unitLength, std::string& error)
{
  const vtkSmartPointer<vtkPolyData> mesh = ReadMeshFile(lamp.MeshFile, error);
  Light light;
  if (!mesh || !ReadLight(mesh, light, error))
  {
    error = mesh ? Sentence("\"", lamp.MeshFile, "\" is no lamp: ", error) : error;
    return nullptr;
  }
  if (lamp.SaysHowMuch)
  {
    std::vector<double> radiances = RadiancesOf(lamp, EmissionOf(light.Shape, LightArea(light), unitLength));
    radiances.resize(lamp.NumberOfWavelengths, radiances.front());
    for (const char* name : { "LightSpectrum", "LightWavelengths" })
    {
      mesh->GetFieldData()->RemoveArray(name);
    }
    AddDoubleArray(mesh->GetFieldData(), "LightSpectrum", 1, radiances);
    AddDoubleArray(mesh->GetFieldData(), "LightWavelengths", 1, DefaultWavelengths(lamp.NumberOfWavelengths));
  }
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(mesh);
  return producer;
}

// The file's text where the text is the name of one that ends in .txt.
bool ReadText(const std::string& text, std::string& words, std::string& error)
{
  words = text;
  if (ExtensionOf(text) != "txt" || text.find('\n') != std::string::npos)
  {
    return true;
  }
  std::ifstream file(text, std::ios::binary);
  words.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  error = file ? "" : Sentence("The lights' file \"", text, "\" cannot be opened.");
  return error.empty();
}

} // namespace

vtkStandardNewMacro(vtkLightWords);

vtkLightWords::vtkLightWords() = default;
vtkLightWords::~vtkLightWords() = default;

bool vtkLightWords::Read(const std::string& text)
{
  this->Lights.clear();
  this->Error.clear();
  this->ErrorLine = 0;
  this->ErrorColumn = 0;
  LightGrammarOptions options;
  options.UnitLength = this->UnitLength;
  options.Up = { this->Up[0], this->Up[1], this->Up[2] };
  options.North = { this->North[0], this->North[1], this->North[2] };
  if (!(std::isfinite(this->UnitLength) && this->UnitLength > 0.0))
  {
    this->Error = Sentence("UnitLength is ", this->UnitLength, ": it must be above 0 and finite.");
    return false;
  }
  std::string words;
  if (!ReadText(text, words, this->Error))
  {
    return false;
  }
  std::vector<Lamp> lamps;
  LightFault fault;
  if (!ParseLamps(words, options, lamps, fault))
  {
    this->Error = words == text ? fault.Sentence : text + ": " + fault.Sentence;
    this->ErrorLine = fault.Line;
    this->ErrorColumn = fault.Column;
    return false;
  }
  for (const Lamp& lamp : lamps)
  {
    vtkSmartPointer<vtkAlgorithm> light;
    if (lamp.Shape == LightShape::Mesh)
    {
      light = MeshLampOf(lamp, this->UnitLength, this->Error);
    }
    else
    {
      light = SourceOf(lamp, this->UnitLength);
    }
    if (!light)
    {
      this->Lights.clear();
      return false;
    }
    this->Lights.push_back(light);
  }
  return true;
}

int vtkLightWords::GetNumberOfLights()
{
  return static_cast<int>(this->Lights.size());
}

vtkAlgorithm* vtkLightWords::GetLight(int index)
{
  return index >= 0 && index < this->GetNumberOfLights() ? this->Lights[index].Get() : nullptr;
}

std::string vtkLightWords::GetWords(vtkAreaLightSource* light)
{
  if (!light || light->GetShape() < 0 || light->GetShape() > vtkAreaLightSource::Sun)
  {
    return std::string();
  }
  Lamp lamp;
  const auto vector = [](const double* x) -> Vector3 { return { x[0], x[1], x[2] }; };
  lamp.Shape = static_cast<LightShape>(light->GetShape());
  lamp.Center = vector(light->GetCenter());
  lamp.Normal = vector(light->GetNormal());
  lamp.Up = vector(light->GetUp());
  lamp.Radius = light->GetRadius();
  lamp.Width = light->GetWidth();
  lamp.Height = light->GetHeight();
  lamp.AngularDiameter = light->GetAngularDiameter();
  lamp.NumberOfWavelengths = light->GetNumberOfWavelengths();
  lamp.Resolution = light->GetResolution();
  lamp.Spectrum.assign(1, light->GetRadiance());
  std::vector<double> own;
  for (int i = 0; i < std::min(lamp.NumberOfWavelengths, 1000); ++i)
  {
    own.push_back(light->GetRadianceSpectrum(i));
  }
  if (std::any_of(own.begin(), own.end(), [&](double value) { return value != lamp.Spectrum.front(); }))
  {
    lamp.Spectrum = own;
  }
  const std::string text = TextOf(lamp);
  std::vector<Lamp> read;
  LightFault fault;
  return ParseLamps(text, LightGrammarOptions(), read, fault) ? text : std::string();
}

void vtkLightWords::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UnitLength: " << this->UnitLength << "\n";
  os << indent << "Up: " << Listed(this->Up, 3) << "\n";
  os << indent << "North: " << Listed(this->North, 3) << "\n";
  os << indent << "NumberOfLights: " << this->Lights.size() << "\n";
  os << indent << "Error: " << this->Error << "\n";
}
