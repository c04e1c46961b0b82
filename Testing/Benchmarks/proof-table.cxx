// SPDX-License-Identifier: BSD-3-Clause
// What is proved, how tight it is and what it costs, a line for each scene and light.
//
//   fitted    Tuning Automatic without a mesh: what the photons saw
//   proved    Tuning Conservative with the mesh: fitted cones that grow, and added ones, of which there are so many
//   default   Tuning Automatic with the mesh: of these and cones around parts of the mesh those that are tighter
//   shadow    share of the cones' volume that is in shadow, by samples drawn evenly in the scene's region
//   check     the independent check of the default set, and the leaks that the search for a point in shadow outside its cones found
//   seconds   for vectors, cones and proof, with Tuning Manual and by default
#include "ConeAdversary.h"
#include "ProgramOptions.h"
#include "ProofScenes.h"

#include "scClassifyByCones.h"
#include "scConeAccuracy.h"
#include "scConeProofCheck.h"
#include "scConeTally.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include "vtkObject.h"

#include <algorithm>
#include <cstdio>
#include <exception>

using namespace shadowcones;

namespace
{
struct Setting
{
  vtkIdType Vectors = 5800;
  int Points = 20000;
  long long Tries = 20000;
};

/// Samples in a region, and how much of the cones' volume is in shadow there.
class Samples
{
public:
  Samples(const ProofScene& scene, int count)
  {
    const OccluderScene occluders(scene.Mesh.View());
    DrawSamplePoints(scene.Region, count, 20240, {}, this->Points);
    MeasureTruth(this->Points, occluders, scene.Light, 64, 20240, {}, this->Truth);
  }
  double Precision(const std::vector<Cone>& cones) const
  {
    std::vector<SamplePrediction> predictions;
    std::vector<ConeTally> tallies;
    ClassifyByCones(this->Points, this->Truth, cones, {}, predictions, tallies);
    return TallyAccuracy(this->Truth, predictions, cones, 0).All.Precision().Value;
  }

private:
  std::vector<Vector3> Points;
  std::vector<SampleTruth> Truth;
};

AdversaryResult Search(const ProofScene& scene, const std::vector<Cone>& cones, long long tries)
{
  constexpr int parts = 16;
  const ConeAdversary adversary(scene.Mesh.View(), scene.Light, cones);
  std::vector<AdversaryResult> found(parts);
  ParallelFor(parts, {},
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType part = first; part < last; ++part)
      {
        found[part] = adversary.Search((tries + parts - 1) / parts, static_cast<std::uint64_t>(part + 1));
      }
    });
  AdversaryResult all;
  for (const AdversaryResult& part : found)
  {
    all.Inside += part.Inside;
    all.Outside += part.Outside;
    all.Leaks += part.Leaks;
  }
  return all;
}

void PrintHeader()
{
  std::printf("%-14s %-9s %9s | %6s %6s | %6s %5s %6s | %6s %6s %6s | %-7s %9s %9s %6s | %7s %7s\n", "scene", "light",
    "triangles", "fitted", "shadow", "proved", "added", "shadow", "default", "shadow", "made of", "check", "tries", "outside", "leaks",
    "manual", "default");
}

/// @return whether nothing leaks.
bool PrintRow(const ProofScene& scene, const Setting& setting)
{
  constexpr int manual = 0;
  constexpr int conservative = 1;
  constexpr int automatic = 4;
  const ProofSceneCones fitted = MakeCones(scene, setting.Vectors, { automatic, true, false });
  const ProofSceneCones proved = MakeCones(scene, setting.Vectors, { conservative, true, true });
  const ProofSceneCones standard = MakeCones(scene, setting.Vectors, { automatic, true, true });
  const ProofSceneCones untuned = MakeCones(scene, setting.Vectors, { manual, false, true });
  const Samples samples(scene, setting.Points);
  bool checked = true;
  for (const ProofSceneCones* cones : { &proved, &standard, &untuned })
  {
    ConeProofCheck check;
    CheckConeProof(scene.Mesh.View(), scene.Light, cones->Cones, cones->CertifiedBounds, {}, check);
    checked = checked && check.Proved && cones->Certified;
  }
  const AdversaryResult leaks = Search(scene, standard.Cones, setting.Tries);
  const long long added = std::count_if(proved.Cones.begin(), proved.Cones.end(),
    [](const Cone& cone) { return cone.Origin == ConeOrigin::Added; });
  const bool parts = standard.Choice.find("parts of the mesh were taken") != std::string::npos;
  std::printf("%-14s %-9s %9zu | %6zu %6.3f | %6zu %5lld %6.3f | %6zu %6.3f %6s | %-7s %9lld %9lld %6lld | %7.2f %7.2f\n",
    scene.Name.c_str(), scene.LightName.c_str(), scene.Mesh.Triangles.size() / 3, fitted.Cones.size(),
    samples.Precision(fitted.Cones), proved.Cones.size(), added, samples.Precision(proved.Cones), standard.Cones.size(),
    samples.Precision(standard.Cones), parts ? "parts" : "fitted", checked ? "proved" : "NOT", setting.Tries, leaks.Outside,
    leaks.Leaks, untuned.Seconds, standard.Seconds);
  std::fflush(stdout);
  return checked && leaks.Leaks == 0;
}
} // anonymous namespace

int main(int argc, char** argv)
{
  Setting setting;
  std::vector<std::string> scenes;
  std::vector<std::string> lights;
  ProgramOptions commandLine("What is proved, how tight it is and what it costs");
  commandLine.Add("--scene", scenes, "some of the scenes; all of them where none is named");
  commandLine.Add("--light", lights,
    "lights in place of the scenes' own: disc, rectangle, sphere, point, sun, mesh; where none is named the chair has each of them");
  commandLine.Add("--vectors", setting.Vectors, "shadow vectors asked for");
  commandLine.AddPositive("--points", setting.Points, "sample points of each scene");
  commandLine.Add("--tries", setting.Tries, "points looked for in shadow and outside every cone");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  vtkObject::GlobalWarningDisplayOff();
  bool whole = true;
  try
  {
    PrintHeader();
    for (const std::string& name : scenes.empty() ? ProofSceneNames() : scenes)
    {
      std::vector<std::string> own = lights.empty() ? std::vector<std::string>{ "" } : lights;
      if (lights.empty() && name == "chair")
      {
        own = ProofLightNames();
      }
      for (const std::string& light : own)
      {
        whole = PrintRow(MakeProofScene(name, light), setting) && whole;
      }
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  std::printf("%s\n", whole ? "All sets are proved, and no leak was found." : "SOME SETS ARE NOT PROVED, OR LEAK.");
  return whole ? 0 : 1;
}
