// SPDX-License-Identifier: BSD-3-Clause
// Lights in words: the grammar, its faults with their columns, amounts of light, round trips, and any bytes.
#include "vtkLightWords.h"

#include "Messages.h"
#include "vtkAreaLightSource.h"

#include "vtkFieldData.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace
{

vtkSmartPointer<vtkAreaLightSource> LightOf(const std::string& text, double unitLength = 1.0)
{
  vtkNew<vtkLightWords> words;
  words->SetUnitLength(unitLength);
  EXPECT_TRUE(words->Read(text)) << words->GetError();
  EXPECT_EQ(words->GetNumberOfLights(), 1);
  return vtkAreaLightSource::SafeDownCast(words->GetLight(0));
}

void ExpectVector(const double* found, double x, double y, double z)
{
  EXPECT_NEAR(found[0], x, 1e-15);
  EXPECT_NEAR(found[1], y, 1e-15);
  EXPECT_NEAR(found[2], z, 1e-15);
}

double Sum(vtkAreaLightSource* light)
{
  double sum = 0.0;
  for (int i = 0; i < light->GetNumberOfWavelengths(); ++i)
  {
    sum += light->GetRadianceSpectrum(i);
  }
  return sum;
}

} // namespace

TEST(LightWords, DiscOfThePages)
{
  auto light = LightOf("disc:0,5,0 radius 0.5 facing 0,-1,0");
  EXPECT_EQ(light->GetShape(), vtkAreaLightSource::Disc);
  ExpectVector(light->GetCenter(), 0, 5, 0);
  ExpectVector(light->GetNormal(), 0, -1, 0);
  EXPECT_EQ(light->GetRadius(), 0.5);
  EXPECT_EQ(light->GetRadiance(), 1.0);
  EXPECT_EQ(light->GetNumberOfWavelengths(), 7);
}

TEST(LightWords, BlanksCapitalsAndEqualSignsDoNotMatter)
{
  auto light = LightOf("  Disc : 0 , 5 ,\t0  RADIUS = 0.5  facing\t0,-1,0 \n");
  EXPECT_EQ(vtkLightWords::GetWords(light), "disc:0,5,0 radius 0.5 facing 0,-1,0 radiance 1");
}

TEST(LightWords, Shapes)
{
  auto rectangle = LightOf("RECTANGLE: 1, 2 , 3  size=2,4 Facing -y up x radiance 1,2,3");
  EXPECT_EQ(rectangle->GetShape(), vtkAreaLightSource::Rectangle);
  ExpectVector(rectangle->GetNormal(), 0, -1, 0);
  ExpectVector(rectangle->GetUp(), 1, 0, 0);
  EXPECT_EQ(rectangle->GetWidth(), 2.0);
  EXPECT_EQ(rectangle->GetHeight(), 4.0);
  ASSERT_EQ(rectangle->GetNumberOfWavelengths(), 3);
  EXPECT_EQ(rectangle->GetRadianceSpectrum(1), 2.0);
  EXPECT_EQ(rectangle->GetRadianceSpectrum(2), 3.0);
  auto sphere = LightOf("sphere:1,2,3 diameter 3");
  EXPECT_EQ(sphere->GetShape(), vtkAreaLightSource::Sphere);
  EXPECT_EQ(sphere->GetRadius(), 1.5);
  EXPECT_EQ(LightOf("point:+1,2e1,-3.5")->GetCenter()[1], 20.0);
}

TEST(LightWords, SunByCompass)
{
  // From the south-east, 40 degrees up, z up and y north: it shines north-west and down.
  const double a = std::cos(vtkMath::RadiansFromDegrees(40.0)) * std::sqrt(0.5);
  const double b = std::sin(vtkMath::RadiansFromDegrees(40.0));
  auto sun = LightOf("sun: azimuth 135 altitude 40");
  EXPECT_EQ(sun->GetShape(), vtkAreaLightSource::Sun);
  ExpectVector(sun->GetNormal(), -a, a, -b);
  EXPECT_EQ(sun->GetAngularDiameter(), 0.533);
  // y up: north is -z, east is x.
  ExpectVector(LightOf("sun azimuth 135 altitude 40 up y diameter 0")->GetNormal(), -a, -b, -a);
  ExpectVector(LightOf("sun: azimuth 90 altitude 0 north x")->GetNormal(), 0, 1, 0); // east of x is -y
  ExpectVector(LightOf("sun: direction 0,0,-2")->GetNormal(), 0, 0, -2);
}

TEST(LightWords, UnitsOfLengthAndAngle)
{
  auto light = LightOf("disc:0,5 ,0 m radius 50cm facing -y", 0.001); // a mesh in millimetres
  ExpectVector(light->GetCenter(), 0, 5000, 0);
  EXPECT_DOUBLE_EQ(light->GetRadius(), 500.0);
  EXPECT_NEAR(LightOf("sun: direction -z diameter 0.01 rad")->GetAngularDiameter(), 0.01 * 180.0 / vtkMath::Pi(), 1e-12);
  EXPECT_NEAR(LightOf("sphere:0,0,0 radius 1 ft")->GetRadius(), 0.3048, 1e-15);
}

TEST(LightWords, FluxInWatts)
{
  // A Lambertian face sends out pi L a square metre.
  auto disc = LightOf("disc:0,0,0 radius 2 facing z flux 60 W wavelengths 5");
  EXPECT_NEAR(vtkMath::Pi() * vtkMath::Pi() * 4.0 * Sum(disc), 60.0, 1e-12);
  // The same lamp in millimetres has the same radiance.
  EXPECT_NEAR(LightOf("disc:0,0,0 radius 2000 facing z flux 60 W wavelengths 5", 0.001)->GetRadiance(), disc->GetRadiance(),
    1e-12);
  auto point = LightOf("point:0,0,0 flux 60 W");
  EXPECT_NEAR(4.0 * vtkMath::Pi() * Sum(point), 60.0, 1e-12);
  // In millimetres irradiance I / d^2 is to come in W m^-2: 1 m = 1000 units.
  EXPECT_NEAR(Sum(LightOf("point:0,0,0 intensity 5 W/sr", 0.001)) / (1000.0 * 1000.0), 5.0, 1e-12);
  EXPECT_NEAR(Sum(LightOf("sun: direction -z irradiance 1000 W/m2")), 1000.0, 1e-9);
  auto coloured = LightOf("rectangle:0,0,0 size 1,2 facing z flux 12 W spectrum 1,2,3");
  EXPECT_NEAR(coloured->GetRadianceSpectrum(2), 12.0 / 2.0 / (2.0 * vtkMath::Pi()), 1e-12); // half of it in the third
}

TEST(LightWords, FluxInLumens)
{
  // One wavelength sample is that at 550 nm, where the eye sees 0.995 of its best: 683 lm/W.
  auto green = LightOf("sphere:0,0,0 radius 1 flux 679.6 lm wavelengths 1");
  EXPECT_NEAR(green->GetRadiance() * 4.0 * vtkMath::Pi() * vtkMath::Pi(), 1.0, 0.02);
  EXPECT_NEAR(LightOf("point:0,0,0 intensity 1 cd")->GetRadiance(),
    LightOf("point:0,0,0 flux 12.566370614359172 lm")->GetRadiance(), 1e-15);
  EXPECT_NEAR(LightOf("sun: direction -z irradiance 90 klx")->GetRadiance(),
    LightOf("sun: direction -z irradiance 90000 lx")->GetRadiance(), 1e-12);
}

TEST(LightWords, SeveralLampsAndComments)
{
  vtkNew<vtkLightWords> words;
  ASSERT_TRUE(words->Read("# lamps\npoint:0,0,0; point:1,0,0 # beside it\n\nsphere:2,0,0 radius 1\n")) << words->GetError();
  EXPECT_EQ(words->GetNumberOfLights(), 3);
  EXPECT_EQ(words->GetLight(3), nullptr);
  EXPECT_EQ(words->GetLight(-1), nullptr);
}

TEST(LightWords, FaultsNameColumnFoundAndExpected)
{
  struct Case
  {
    const char* Text;
    int Column;
    const char* Said;
  };
  const std::vector<Case> cases{
    { "", 1, "expected a lamp, such as disc:0,5,0" },
    { "disk:0,5,0", 1, "found \"disk:0,5,0\"" },
    { "disc:0,5 radius 1", 10, "expected three numbers, x,y,z; found \"radius\"" },
    { "disc:0,5,0 raduis 1", 12, "expected a word of a disc: radius, diameter, facing, radiance" },
    { "disc:0,5,0 radius 1", 20, "the word \"facing\", which a disc needs; found the end" },
    { "disc:0,5,0 facing z", 20, "the word \"radius\" or \"diameter\", which a disc needs" },
    { "disc:0,5,0 radius 0 facing z", 19, "expected a length above 0; found \"0\"" },
    { "disc:0,5,0 radius -1 facing z", 19, "expected a length above 0" },
    { "disc:0,5,0 radius nan facing z", 19, "expected a length above 0; found \"nan\"" },
    { "disc:0,5,0 radius 1e999 facing z", 19, "found \"1e999\"" },
    { "disc:0,5,0 radius 1 radius 2", 21, "expected each word once" },
    { "disc:0,5,0 radius 1 diameter 2", 21, "nothing that says what \"radius\" has said" },
    { "disc:0,5,0 radius 1 facing 0,0,0", 28, "a direction whose length is neither 0 nor immense" },
    { "disc:0,5,0 radius 1 facing w", 28, "or an axis such as -z; found \"w\"" },
    { "disc:0,5,0 radius 1 lm facing z", 21, "found \"lm\"" },
    { "disc:0,5,0 radius 1parsec facing z", 20, "a blank or a unit behind the number; found \"parsec\"" },
    { "disc:0,5,0 radius 1 facing z flux 800", 38, "a flux of 0 and above, in W or lm; found the end" },
    { "disc:0,5,0 radius 1 facing z radiance 1 flux 800 lm", 41, "what \"radiance\" has said" },
    { "disc:0,5,0 radius 1 facing z radiance -1", 39, "numbers of 0 and above" },
    { "disc:0,5,0 radius 1 facing z spectrum 1,2", 42, "a total beside \"spectrum\"" },
    { "disc:0,5,0 radius 1 facing z radiance 1,2 wavelengths 3", 55, "as many wavelengths as the list has numbers, 2" },
    { "sun: azimuth 10", 16, "the word \"altitude\" or \"direction\", which a sun needs" },
    { "sun: azimuth 10 altitude 91", 26, "an altitude from -90 to 90 degrees" },
    { "sun: azimuth 10 altitude 20 up z north z", 40, "a north that does not run along up" },
    { "sun: direction -z diameter 180", 28, "an angle of 0 and above, below 180 degrees" },
    { "sun: direction -z flux 1 W", 19, "expected a word of a sun" },
    { "sphere:0,0,0 radius 1 resolution 2.5", 34, "a whole number from 3 to 4096" },
    { "mesh:\"lamp.stl", 6, "a second quotation mark" },
    { "mesh:", 6, "the name of a mesh file" },
    { "mesh:it's5\".stl", 1, "quotation marks of one kind at most" },
    { "sphere:0,0,0 diameter 4e-324", 23, "a length above 0" },
    { "point:0,0,0 intensity 1e308 cd", 23, "a number that is not that large" },
    { "point:0,0,0 caf\xC3\xA9 1", 13, "found \"caf??\"" },
  };
  vtkNew<vtkLightWords> words;
  for (const Case& each : cases)
  {
    EXPECT_FALSE(words->Read(each.Text)) << each.Text;
    EXPECT_EQ(words->GetErrorColumn(), each.Column) << each.Text << ": " << words->GetError();
    EXPECT_EQ(words->GetErrorLine(), 1);
    EXPECT_SAYS(words->GetError(), each.Said);
    EXPECT_EQ(words->GetNumberOfLights(), 0);
  }
  EXPECT_FALSE(words->Read("point:0,0,0\n# \xC3\xA9\npoint:0,0,q"));
  EXPECT_EQ(words->GetErrorLine(), 3);
  EXPECT_SAYS(words->GetError(), "The words of the light, line 3, column 11: expected three numbers");
  EXPECT_FALSE(words->Read("no-such-lamp.stl"));
  EXPECT_SAYS(words->GetError(), "There is no file \"no-such-lamp.stl\".");
  EXPECT_FALSE(words->Read("no-such-lamps.txt"));
  EXPECT_SAYS(words->GetError(), "The lights' file \"no-such-lamps.txt\" cannot be opened.");
  words->SetUnitLength(0.0);
  EXPECT_FALSE(words->Read("point:0,0,0"));
  EXPECT_SAYS(words->GetError(), "UnitLength is 0: it must be above 0 and finite.");
}

TEST(LightWords, RoundTripIsExact)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-10.0, 10.0);
  const auto positive = [&]() { return std::exp(any(random)); };
  for (int i = 0; i < 500; ++i)
  {
    vtkNew<vtkAreaLightSource> light;
    light->SetShape(i % 5);
    light->SetCenter(any(random), any(random) * 1e-30, any(random) * 1e30);
    light->SetNormal(any(random), any(random), any(random));
    light->SetUp(any(random), any(random), any(random));
    light->SetRadius(positive());
    light->SetWidth(positive());
    light->SetHeight(positive());
    light->SetAngularDiameter(std::fabs(any(random)));
    light->SetNumberOfWavelengths(1 + i % 9);
    light->SetResolution(3 + i % 50);
    light->SetRadiance(positive());
    if (i % 3 == 0)
    {
      light->SetRadianceSpectrum(i % (1 + i % 9), positive());
    }
    const std::string text = vtkLightWords::GetWords(light);
    auto back = LightOf(text);
    ASSERT_NE(back, nullptr) << text;
    EXPECT_EQ(vtkLightWords::GetWords(back), text);
    // What a light is, to the filters: its field data.
    light->Update();
    back->Update();
    for (const char* name : { "LightShape", "LightCenter", "LightNormal", "LightAxes", "LightRadius", "LightSpectrum" })
    {
      vtkDataArray* a = light->GetOutput()->GetFieldData()->GetArray(name);
      vtkDataArray* b = back->GetOutput()->GetFieldData()->GetArray(name);
      ASSERT_TRUE(a && b) << name;
      ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues()) << name;
      const bool used = (name != std::string("LightNormal") || i % 5 < 2 || i % 5 == 4) &&
        (name != std::string("LightAxes") || i % 5 == 1) && (name != std::string("LightRadius") || i % 5 % 2 == 0);
      for (vtkIdType k = 0; used && k < a->GetNumberOfValues(); ++k)
      {
        EXPECT_EQ(a->GetVariantValue(k).ToDouble(), b->GetVariantValue(k).ToDouble()) << name << " of " << text;
      }
    }
  }
  vtkNew<vtkAreaLightSource> none;
  none->SetShape(9);
  EXPECT_EQ(vtkLightWords::GetWords(none), "");
  none->SetShapeToDisc();
  none->SetRadius(std::nan(""));
  EXPECT_EQ(vtkLightWords::GetWords(none), "");
  EXPECT_EQ(vtkLightWords::GetWords(nullptr), "");
}

// Right words with bytes changed, cut and put together: understood or not, but never a crash, and a fault has its place.
TEST(LightWords, AnyBytes)
{
  const std::vector<std::string> seeds{ "disc:0,5,0 radius 0.5 facing 0,-1,0 flux 800 lm spectrum 1,2,3",
    "rectangle:1,2,3 size 2,4 m facing -y up x radiance 1,2", "sun: azimuth 135 altitude 40 up y north -z diameter 0.533",
    "point:0,0,0 intensity 5 W/sr wavelengths 3; sphere:1,1,1 diameter 2 in # end", "mesh:'a b.stl' radiance 2" };
  std::mt19937_64 random(2);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  vtkNew<vtkLightWords> words;
  int understood = 0;
  for (int i = 0; i < 40000; ++i)
  {
    std::string text = seeds[below(seeds.size())];
    for (std::size_t changes = below(6); changes > 0 && !text.empty(); --changes)
    {
      const std::size_t at = below(text.size());
      switch (below(4))
      {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, 1 + below(8));
          break;
        case 2:
          text.insert(at, 1, ",:;#'\"=-+.e0\n\0xmW"[below(17)]);
          break;
        default:
          text.insert(at, seeds[below(seeds.size())], 0, below(30));
          break;
      }
    }
    if (words->Read(text))
    {
      ++understood;
      EXPECT_GT(words->GetNumberOfLights(), 0);
    }
    else
    {
      EXPECT_FALSE(words->GetError().empty());
      EXPECT_EQ(words->GetNumberOfLights(), 0);
    }
  }
  EXPECT_GT(understood, 4000);
  EXPECT_LT(understood, 30000);
}

TEST(LightWords, MeshLampShinesWithItsFlux)
{
  const std::string name = "TestLightWords lamp.stl";
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputConnection(sphere->GetOutputPort());
  writer->SetFileName(name.c_str());
  writer->Write();
  vtkNew<vtkLightWords> words;
  ASSERT_TRUE(words->Read("mesh:'" + name + "' flux 10 W wavelengths 2")) << words->GetError();
  words->GetLight(0)->Update();
  auto* shining = vtkPolyData::SafeDownCast(words->GetLight(0)->GetOutputDataObject(0));
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(sphere->GetOutputPort());
  const double radiance = shining->GetFieldData()->GetArray("LightSpectrum")->GetTuple1(1);
  EXPECT_NEAR(2.0 * vtkMath::Pi() * properties->GetSurfaceArea() * radiance, 10.0, 1e-4);
  ASSERT_TRUE(words->Read(name)) << words->GetError(); // alone, with its blank
  ASSERT_TRUE(words->Read("mesh:\"" + name + "\" radiance 1,3")) << words->GetError();
  words->GetLight(0)->Update();
  auto* mesh = vtkPolyData::SafeDownCast(words->GetLight(0)->GetOutputDataObject(0));
  vtkDataArray* spectrum = mesh->GetFieldData()->GetArray("LightSpectrum");
  ASSERT_TRUE(spectrum);
  EXPECT_EQ(spectrum->GetTuple1(1), 3.0);
  std::remove(name.c_str());
}
