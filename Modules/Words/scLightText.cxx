// SPDX-License-Identifier: BSD-3-Clause
#include "scLightText.h"

#include "scSentence.h"

namespace shadowcones
{

namespace
{

std::string List(const std::vector<double>& values)
{
  std::string text;
  for (const double value : values)
  {
    text += (text.empty() ? "" : ",") + ShortestText(value);
  }
  return text;
}

std::string Triple(const Vector3& a)
{
  return List({ a.X, a.Y, a.Z });
}

std::string ShapeText(const Lamp& lamp)
{
  const Lamp usual;
  switch (lamp.Shape)
  {
    case LightShape::Disc:
      return "disc:" + Triple(lamp.Center) + " radius " + ShortestText(lamp.Radius) + " facing " + Triple(lamp.Normal);
    case LightShape::Rectangle:
      return "rectangle:" + Triple(lamp.Center) + " size " + List({ lamp.Width, lamp.Height }) + " facing " +
        Triple(lamp.Normal) + " up " + Triple(lamp.Up);
    case LightShape::Sphere:
      return "sphere:" + Triple(lamp.Center) + " radius " + ShortestText(lamp.Radius);
    case LightShape::Point:
      return "point:" + Triple(lamp.Center);
    case LightShape::Sun:
      return "sun: direction " + Triple(lamp.Normal) +
        (lamp.AngularDiameter == usual.AngularDiameter ? "" : " diameter " + ShortestText(lamp.AngularDiameter)) +
        (Length(lamp.Center) == 0.0 ? "" : " center " + Triple(lamp.Center));
    case LightShape::Mesh:
      break;
  }
  // A name holds quotes of one kind at most.
  const char quote = lamp.MeshFile.find('"') == std::string::npos ? '"' : '\'';
  return std::string("mesh:") + quote + lamp.MeshFile + quote;
}

std::string TotalText(const Lamp& lamp)
{
  const bool seen = lamp.Unit == LightUnit::Lumen;
  const bool equal = lamp.Spectrum.size() == 1;
  return (lamp.Shape == LightShape::Sun ? " irradiance " : " flux ") + ShortestText(lamp.Total) +
    (lamp.Shape == LightShape::Sun ? (seen ? " lx" : " W/m2") : (seen ? " lm" : " W")) +
    (equal ? "" : " spectrum " + List(lamp.Spectrum));
}

} // namespace

std::string TextOf(const Lamp& lamp)
{
  const Lamp usual;
  std::string text = ShapeText(lamp);
  text += lamp.Unit == LightUnit::None ? " radiance " + List(lamp.Spectrum) : TotalText(lamp);
  // A list says by itself how many wavelengths there are.
  if (lamp.Spectrum.size() == 1 && lamp.NumberOfWavelengths != usual.NumberOfWavelengths)
  {
    text += " wavelengths " + std::to_string(lamp.NumberOfWavelengths);
  }
  if ((lamp.Shape == LightShape::Disc || lamp.Shape == LightShape::Sphere) && lamp.Resolution != usual.Resolution)
  {
    text += " resolution " + std::to_string(lamp.Resolution);
  }
  return text;
}

} // namespace shadowcones
