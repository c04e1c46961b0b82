// SPDX-License-Identifier: BSD-3-Clause
#include "scWarnings.h"

#include "scSentence.h"
#include "scVisibilityGrid.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSetGet.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>

namespace shadowcones
{

namespace
{

/// Shares above these are said.
constexpr double mostDiscarded = 0.3;
constexpr double mostMissed = 0.01;
constexpr double nearlyHalfSpace = 6.0; // sr
constexpr double mostLeak = 0.01;
constexpr double mostCoarse = 0.01;
constexpr double fewSteps = 8.0; // of single precision, in an edge
constexpr double mostSharp = 0.25;
constexpr double mostDropped = 0.1;
/// Corners that differ by more than this cannot tell where between them the edge is.
constexpr float sharpRange = 0.5f;
constexpr double mostCutOff = 0.005;
constexpr double mostBeyond = 0.01;
constexpr double mostUnlikeRays = 0.2; ///< cones darken penumbrae by a tenth or so
/// Fewer places than these may well lie on one side of a shadow.
constexpr vtkIdType fewPlaces = 10;

std::string Percent(double share)
{
  std::ostringstream text;
  text << std::setprecision(3) << 100.0 * share << " %";
  return text.str();
}

std::string Percent(vtkIdType part, vtkIdType whole)
{
  return Percent(static_cast<double>(part) / static_cast<double>(whole));
}

double FirstValue(vtkFieldData* field, const char* name, double otherwise)
{
  vtkDataArray* array = field ? field->GetArray(name) : nullptr;
  return array && array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : otherwise;
}

template <typename Predicate>
vtkIdType CountDistinct(const std::vector<int>& ids, Predicate counts)
{
  std::vector<int> distinct;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(distinct), counts);
  std::sort(distinct.begin(), distinct.end());
  return std::unique(distinct.begin(), distinct.end()) - distinct.begin();
}

/// The largest less the smallest of the corners of a cell in an array of n[0] x n[1] values a layer.
float RangeOfCorners(const float* corner, std::size_t row, std::size_t layer)
{
  float low = *corner;
  float high = *corner;
  for (const std::size_t step : { std::size_t(1), row, row + 1, layer, layer + 1, layer + row, layer + row + 1 })
  {
    low = std::min(low, corner[step]);
    high = std::max(high, corner[step]);
  }
  return high - low;
}

struct SharpCells
{
  double Sharp = 0.0; ///< a cell of a brick counts as its share of the volume
  double All = 0.0;   ///< with a corner that was asked for
};

double SharpShareOfBrick(const float* values, int parts)
{
  const auto row = static_cast<std::size_t>(parts) + 1;
  double sharp = 0.0;
  for (int k = 0; k < parts; ++k)
  {
    for (int j = 0; j < parts; ++j)
    {
      for (int i = 0; i < parts; ++i)
      {
        sharp += RangeOfCorners(values + i + row * (j + row * k), row, row * row) > sharpRange ? 1.0 : 0.0;
      }
    }
  }
  return sharp / (static_cast<double>(parts) * parts * parts);
}

SharpCells CountSharpCells(const VisibilityGrid& grid)
{
  const std::array<int, 3>& n = grid.Dimensions;
  const auto row = static_cast<std::size_t>(n[0]);
  const std::size_t layer = row * static_cast<std::size_t>(n[1]);
  const auto valuesOfBrick =
    static_cast<std::size_t>(grid.BrickParts + 1) * (grid.BrickParts + 1) * (grid.BrickParts + 1);
  SharpCells count;
  std::size_t brick = 0; // bricks and cells ascend together
  for (int k = 0; k + 1 < n[2]; ++k)
  {
    for (int j = 0; j + 1 < n[1]; ++j)
    {
      for (int i = 0; i + 1 < n[0]; ++i)
      {
        const std::size_t corner = grid.VertexIndex(i, j, k);
        const bool refined = brick < grid.BrickCells.size() && grid.BrickCells[brick] == grid.CellIndex(i, j, k);
        if (grid.Marked[corner] || grid.Marked[corner + 1 + row + layer] || refined)
        {
          count.All += 1.0;
          count.Sharp += refined
            ? SharpShareOfBrick(grid.BrickVisibility.data() + brick * valuesOfBrick, grid.BrickParts)
            : RangeOfCorners(grid.Visibility.data() + corner, row, layer) > sharpRange ? 1.0
                                                                                       : 0.0;
        }
        brick += refined ? 1 : 0;
      }
    }
  }
  return count;
}

struct CoarsePolygons
{
  vtkIdType Coarse = 0; ///< with an edge of a few steps between numbers in single precision
  vtkIdType All = 0;
};

bool HasCoarseEdge(vtkPoints* points, vtkIdType count, const vtkIdType* corners)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    double a[3];
    double b[3];
    points->GetPoint(corners[i], a);
    points->GetPoint(corners[(i + 1) % count], b);
    double length = 0.0;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      length = std::max(length, std::fabs(b[axis] - a[axis]));
      largest = std::max({ largest, std::fabs(a[axis]), std::fabs(b[axis]) });
    }
    if (length > 0.0 && length < fewSteps * largest * std::numeric_limits<float>::epsilon())
    {
      return true;
    }
  }
  return false;
}

void CountCoarsePolygons(vtkPolyData* mesh, CoarsePolygons& count)
{
  if (!mesh || !mesh->GetPoints())
  {
    return;
  }
  const bool single = mesh->GetPoints()->GetDataType() == VTK_FLOAT;
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  count.All += mesh->GetNumberOfPolys();
  auto polygons = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); single && !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    polygons->GetCurrentCell(size, corners);
    const bool exist =
      std::all_of(corners, corners + size, [numberOfPoints](vtkIdType i) { return i >= 0 && i < numberOfPoints; });
    count.Coarse += exist && HasCoarseEdge(mesh->GetPoints(), size, corners) ? 1 : 0;
  }
}

} // namespace

void Warnings::Add(const std::string& sentence)
{
  if (!sentence.empty() && std::find(this->Sentences.begin(), this->Sentences.end(), sentence) == this->Sentences.end())
  {
    this->Sentences.push_back(sentence);
  }
}

void Warnings::Add(const std::vector<std::string>& sentences)
{
  for (const std::string& sentence : sentences)
  {
    this->Add(sentence);
  }
}

void Warnings::Say(vtkAlgorithm* speaker) const
{
  for (const std::string& sentence : this->Sentences)
  {
    vtkWarningWithObjectMacro(speaker, << sentence);
  }
}

std::string NothingInShadow(vtkIdType photons, vtkIdType blocked)
{
  return photons > 0 && blocked == 0
    ? Sentence("None of ", photons,
        " photons met an occluder: nothing is in shadow. Check where the light is and which way it faces; cells with a "
        "negative OccluderId cast no shadow.")
    : std::string();
}

std::string NothingLit(vtkIdType photons, vtkIdType blocked, double solidAngle)
{
  return photons > 0 && blocked == photons && solidAngle >= nearlyHalfSpace
    ? Sentence("All ", photons,
        " photons were stopped by an occluder, wherever they went: nothing is lit, as by a lamp in a closed box. Move "
        "the "
        "light, or open the mesh; walls that only catch shadows take a negative OccluderId.")
    : std::string();
}

std::string OccludersWithoutVectors(const std::vector<int>& casters, const std::vector<int>& vectors)
{
  const auto isCaster = [](int id) { return id >= 0; };
  const auto occluders = CountDistinct(casters, isCaster);
  const vtkIdType without = occluders - CountDistinct(vectors, isCaster);
  return without > 0 && without < occluders
    ? Sentence(without, " of ", occluders,
        " occluders have no shadow vector: no cone will hold their shadows, which may count as lit. Take more photons "
        "(TargetNumberOfVectors or NumberOfPhotons), unless the light does not reach them.")
    : std::string();
}

std::string TooFewVectors(vtkIdType scarce, vtkIdType minimum, vtkIdType needed)
{
  return scarce > 0
    ? Sentence(scarce, " times an occluder has fewer than ", minimum,
        " shadow vectors of a light, though photons were aimed at it: hardly any light reaches it, or it is thin. ",
        needed > 0 ? Sentence("About ", needed, " photons are needed: SetNumberOfPhotons(", needed, ")") : "Take more photons",
        ", or set MinimumVectorsPerOccluder to 0.")
    : std::string();
}

std::string TargetNotMet(vtkIdType vectors, vtkIdType target, vtkIdType photons)
{
  return vectors < target
    ? Sentence("Only ", vectors, " of ", target, " vectors were stored by ", photons,
        " photons: hardly any light meets an occluder. Check where the light is and which way it faces.")
    : std::string();
}

std::string UnusedParameters(const std::string& names)
{
  return names.empty() ? names
                       : "Tuning chooses these parameters, and what they were set to is not used: " + names +
      ". Use SetTuningToManual to fit with them.";
}

std::string NotProved()
{
  return "The cone set is not proved: the shadow vectors do not carry the exact shape of the light. Connect the light "
         "with "
         "SetLightConnection, or set Certify off.";
}

std::string NothingToLearnFrom(const std::string& lacking)
{
  return lacking.empty() ? lacking
                         : "Tuning found too little to learn from: " + lacking +
      ". Cones are bounds from the light's geometry instead; more photons, or a mesh and a light to prove them with, "
      "make "
      "them better.";
}

std::string NoCones(vtkIdType cones, vtkIdType vectors)
{
  return cones == 0 && vectors > 0
    ? Sentence("No cones from ", vectors,
        " shadow vectors: everything counts as lit where this set is used. Lower MinimumVectorsPerCone, raise "
        "VarianceThreshold, or take more vectors.")
    : std::string();
}

std::string OccludersWithoutCone(const std::vector<int>& vectors, const std::vector<vtkIdType>& coneIds)
{
  std::vector<int> held;
  for (std::size_t i = 0; i < std::min(vectors.size(), coneIds.size()); ++i)
  {
    if (coneIds[i] >= 0)
    {
      held.push_back(vectors[i]);
    }
  }
  const auto all = [](int) { return true; };
  const vtkIdType occluders = CountDistinct(vectors, all);
  const vtkIdType without = occluders - CountDistinct(held, all);
  return without > 0 && without < occluders
    ? Sentence(without, " of ", occluders,
        " occluders have no shadow vector in any cone: their shadows may count as lit. Take more vectors, lower "
        "MinimumVectorsPerCone, or raise VarianceThreshold.")
    : std::string();
}

std::string ConesLeak(double leak)
{
  return leak > mostLeak
    ? Sentence("The cones are to hold the shadow, and ", Percent(leak),
        " of the blocked light of photons held out lies outside them: it may count as lit. Take more vectors, and "
        "SetStorageToHitPoint() of vtkShadowVectorFilter.")
    : std::string();
}

std::string TooManyDiscarded(vtkFieldData* field, bool proved)
{
  const double discarded = FirstValue(field, "DiscardedFraction", 0.0);
  return discarded > mostDiscarded && !proved
    ? Sentence(Percent(discarded),
        " of the shadow vectors lie in no cone, and the cones are taken for all that can be in shadow: shadows outside "
        "them count as lit. Take more vectors, set Overlap on, raise VarianceThreshold, or SetTuningToConservative().")
    : std::string();
}

std::string ConesChanged(const char* input)
{
  return std::string(input) +
    " says that it is proved, but not of these cones: they were cut, scaled or edited since, or some were left out. They "
    "are taken as not proved, and shadow outside them counts as lit. Use the cone set as vtkConeSetFilter makes it.";
}

std::string EmptyConeSet(vtkIdType cones, vtkIdType castingTriangles)
{
  return cones == 0 && castingTriangles > 0 ? Sentence("The cone set is empty, but ", castingTriangles,
                                                " triangles of the mesh cast shadows: all counts as lit. See what "
                                                "vtkConeSetFilter and vtkShadowVectorFilter say.")
                                            : std::string();
}

std::string NoPlaceInShadow(const char* places, vtkIdType asked, vtkIdType inShadow, vtkIdType cones)
{
  return asked >= fewPlaces && inShadow == 0 && cones > 0
    ? Sentence("None of ", asked, " ", places, " is in shadow, although there are ", cones,
        " cones: do they belong to this light and mesh, and are all in the same units?")
    : std::string();
}

std::string NoPlaceLit(const char* places, vtkIdType asked, vtkIdType lit)
{
  return asked >= fewPlaces && lit == 0
    ? Sentence("None of ", asked, " ", places,
        " sees any of the light: nothing is lit. Is the light in a closed box, and does it face them?")
    : std::string();
}

std::string TooCoarse(const VisibilityGrid& grid, const char* remedy)
{
  const SharpCells count = CountSharpCells(grid);
  const double share = count.All > 0.0 ? count.Sharp / count.All : 0.0;
  return share > mostSharp
    ? Sentence(Percent(share), " of the ", static_cast<vtkIdType>(count.All),
        " cells in reach of a shadow hold an edge that their corners cannot follow: shadows are blurred. ", remedy)
    : std::string();
}

std::string OutOfFirstBounds(const Box& scene)
{
  return Sentence(
    "Bounds are not set, and at this time the scene reaches out of the box around it at the first time: from ",
    scene.Min.X, ", ", scene.Min.Y, ", ", scene.Min.Z, " to ", scene.Max.X, ", ", scene.Max.Y, ", ", scene.Max.Z,
    ". Set Bounds that hold all of it.");
}

std::string OccludersWithoutSurface(vtkIdType without, vtkIdType occluders)
{
  return without > 0
    ? Sentence(without, " of ", occluders,
        " occluders have no surface: their shadows lie outside Bounds, or are thinner than a cell. Raise Resolution, or "
        "widen Bounds.")
    : std::string();
}

std::string SunNeverUp(vtkIdType steps, double minimum, double highest)
{
  return steps > 0 && !(highest > minimum)
    ? Sentence("The Sun is above MinimumAltitude, ", minimum, " degrees, in none of the ", steps,
        " steps of its path: the highest is at ", highest,
        " degrees, and all hours are 0. Check Latitude, Longitude, Start and End of the vtkSunPath.")
    : std::string();
}

std::string SolidsOfSeveralParts(vtkIdType several, vtkIdType occluders)
{
  return several > 0
    ? Sentence(several, " of ", occluders,
        " solids are made of several convex parts, which overlap where their shadows do and are not united. Use "
        "SetMethodToVisibility() for one surface.")
    : std::string();
}

std::string InnerConesNotProved()
{
  return "The mesh is connected, but neither the light is nor does the cone set carry it: inner cones are not proved. "
         "Connect the light with SetLightConnection.";
}

std::string TrianglesDropped(vtkIdType dropped, vtkIdType triangles)
{
  return static_cast<double>(dropped) > mostDropped * static_cast<double>(triangles)
    ? Sentence(dropped, " of ", triangles, " triangles (", Percent(dropped, triangles),
        ") were dropped, which have repeated points, no area, or the points of another one. Lower WeldTolerance, or "
        "mend "
        "the mesh.")
    : std::string();
}

std::string CoarseCoordinates(vtkDataObject* mesh)
{
  CoarsePolygons count;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(mesh))
  {
    auto block = vtk::TakeSmartPointer(blocks->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      CountCoarsePolygons(vtkPolyData::SafeDownCast(block->GetCurrentDataObject()), count);
    }
  }
  CountCoarsePolygons(vtkPolyData::SafeDownCast(mesh), count);
  return static_cast<double>(count.Coarse) > mostCoarse * static_cast<double>(count.All)
    ? Sentence(count.Coarse, " of ", count.All, " polygons (", Percent(count.Coarse, count.All),
        ") have an edge of less than 8 steps between coordinates in single precision: the mesh is too large, or too "
        "far "
        "from the origin, for its detail. Write its points in double precision, or move it to the origin first.")
    : std::string();
}

std::string MediumNotSeen(vtkIdType pixels, vtkIdType through)
{
  return pixels > 0 && through == 0 ? Sentence("None of ", pixels,
                                        " camera rays passes the medium before a surface: there is no light shaft to "
                                        "see. Check MediumBounds and the camera.")
                                    : std::string();
}

std::string NothingSeen(vtkIdType pixels, vtkIdType bright)
{
  return pixels > 0 && bright == 0 ? Sentence("All ", pixels,
                                       " pixels are black: no light comes to the camera. Check which way the light "
                                       "faces, whether the mesh encloses it, its "
                                       "Radiance, and SigmaS.")
                                   : std::string();
}

std::string GoalNotMet(vtkIdType pixels, vtkIdType missed, double goal, double worst, int maximumSamples)
{
  return pixels > 0 && static_cast<double>(missed) > mostMissed * static_cast<double>(pixels)
    ? Sentence(missed, " of ", pixels, " pixels (", Percent(missed, pixels), ") miss the RelativeErrorGoal of ", goal,
        ", the worst with a relative error of ", worst, ": MaximumSamples, ", maximumSamples,
        ", ends their sampling. Raise it, or accept the noise.")
    : std::string();
}

std::string SurfaceGoalNotMet(vtkIdType pixels, vtkIdType missed, double goal, double worst, int maximumSamples)
{
  return pixels > 0 && static_cast<double>(missed) > mostMissed * static_cast<double>(pixels)
    ? Sentence("The surfaces of ", missed, " of ", pixels, " pixels (", Percent(missed, pixels),
        ") miss the RelativeErrorGoal of ", goal, ", the worst with a relative error of ", worst, ": MaximumSamples, ",
        maximumSamples, ", ends their sampling. Raise it, or accept the noise.")
    : std::string();
}

std::string MediumBeyondVolume(double share)
{
  return share > mostBeyond ? Sentence(Percent(share),
                                " of the medium lies outside the visibility volume, where everything counts as lit: "
                                "set Bounds of the volume to "
                                "MediumBounds.")
                            : std::string();
}

std::string ThickSteps(vtkIdType rays, vtkIdType pixels, double opticalDepth, int steps)
{
  if (rays == 0)
  {
    return {};
  }
  // Steps of a tenth are too bright by a third of a per cent.
  const double enough = std::ceil(steps * opticalDepth / 0.1);
  const std::string more =
    enough <= 1e6 ? Sentence("SetNumberOfSteps(", static_cast<int>(enough), "), or ") : std::string();
  return Sentence("The medium is too dense for NumberOfSteps = ", steps, ": at ", rays, " of ", pixels,
    " pixels light fades within a step of the march, over an optical depth of up to ", opticalDepth,
    " which it makes too bright by ", std::ceil(100.0 * (opticalDepth / std::tanh(opticalDepth) - 1.0)), " %. Use ",
    more, "SetModeToGuided(), which resolves media of any density.");
}

std::string NotWhatRaysFind(const char* mode, int pixels, double light, double error)
{
  return pixels > 0 && error > mostUnlikeRays
    ? Sentence("Mode ", mode, " asks no rays, and cones hold more than the shadow, or less: at ", pixels,
        " pixels the medium shows ", Percent(light), " of the light that rays find, and a pixel is off by ",
        Percent(error), " of their mean (root of the mean square). Use SetModeToGuided(), or a vtkVisibilityVolume of "
        "Method Exact with SetModeToVolume().")
    : std::string();
}

std::string UnusedExposure(double exposure)
{
  return exposure != 1.0 ? Sentence("Exposure is ", exposure,
                             ", but AutoExposure is on and finds its own: call AutoExposureOff() to use it.")
                         : std::string();
}

std::string OtherMedium(const std::string& names)
{
  return names.empty() ? names
                       : Sentence("A photon map on input port 5 was made in another medium (", names,
                           "): its light is not that of this image. Set the same on vtkPhotonMapFilter.");
}

std::string LightCutOff(double share, int maximumBounces)
{
  return share > mostCutOff ? Sentence(Percent(share), " of the light was still on its way after MaximumBounces = ",
                                maximumBounces, " and is missing: raise it.")
                            : std::string();
}

std::string NoPhotonStored(vtkIdType photons)
{
  return Sentence("None of ", photons,
    " photons meets a surface or the medium after a bounce: there is no light but the direct one. Check Reflectance, "
    "SigmaS, MediumBounds and which way the light faces.");
}

} // namespace shadowcones
