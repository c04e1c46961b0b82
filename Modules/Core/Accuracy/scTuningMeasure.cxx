// SPDX-License-Identifier: BSD-3-Clause
#include "scTuningMeasure.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scConeTree.h"
#include "scOccluderInterval.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace shadowcones
{
namespace
{
constexpr double coneCost = 0.05;      ///< Conservative: what a cone per vector is worth in leak
constexpr double boundsMargin = 0.5;   ///< Conservative: light counts in the paths' bounds, grown by this share of them
constexpr double previewMargin = 0.25; ///< Preview: the same, nearer to the occluders, where images look
constexpr double largestScale = 2.0;   ///< Soft: radii are not scaled beyond this
constexpr double tightLeak = 0.25;     ///< Tight: what leaks gets cones around parts of the mesh, which are tighter
/// Tight: for each light, of three quarters of the vectors; all of them make some 150. Each one more costs tightConeCost.
constexpr double mostTightCones = 120.0;
constexpr double tightConeCost = 0.01;

/// Lengths of light, summed over the held-out paths.
struct LightSums
{
  double Blocked = 0.0;
  double Leaked = 0.0; ///< blocked, outside the cones
  double Lost = 0.0;   ///< lit, inside the cones
};

LightSums SumLight(const TuningValidation& validation, const std::vector<Cone>& cones)
{
  std::vector<std::unique_ptr<ConeHierarchy>> hierarchies;
  for (const std::vector<Cone>& ofLight : ConesOfLights(cones, validation.Lights))
  {
    hierarchies.push_back(std::make_unique<ConeHierarchy>(ofLight, validation.Region));
  }
  // Fixed chunks, joined in order: the sums do not depend on the number of threads.
  constexpr vtkIdType chunk = 256;
  const auto count = static_cast<vtkIdType>(validation.Data.HeldOut.size());
  std::vector<LightSums> parts(static_cast<std::size_t>((count + chunk - 1) / chunk));
  ParallelFor(static_cast<vtkIdType>(parts.size()), {},
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<OccluderInterval> intervals;
      for (vtkIdType part = first; part < last; ++part)
      {
        for (vtkIdType i = part * chunk; i < std::min(count, (part + 1) * chunk); ++i)
        {
          const HeldOutPath& path = validation.Data.HeldOut[i];
          double begin = 0.0;
          double end = HUGE_VAL;
          if (!validation.Region.Clip(path.Origin, path.Direction, begin, end))
          {
            continue;
          }
          const double stop = std::clamp(path.Stop, begin, end);
          hierarchies[path.Light]->Intersect(path.Origin, path.Direction, begin, end, intervals);
          double leaked = end - stop;
          double lost = 0.0;
          parts[part].Blocked += leaked;
          for (const OccluderInterval& interval : intervals)
          {
            leaked -= std::max(0.0, interval.End - std::max(interval.Begin, stop));
            lost += std::max(0.0, std::min(interval.End, stop) - interval.Begin);
          }
          parts[part].Leaked += std::max(0.0, leaked);
          parts[part].Lost += lost;
        }
      }
    });
  LightSums sums;
  for (const LightSums& part : parts)
  {
    sums.Blocked += part.Blocked;
    sums.Leaked += part.Leaked;
    sums.Lost += part.Lost;
  }
  return sums;
}

void SetSums(const LightSums& sums, ConeTuningResult& result)
{
  const double blocked = std::max(sums.Blocked, 1e-300);
  result.Leak = sums.Leaked / blocked;
  result.Lost = sums.Lost / blocked;
}

void MeasureConservative(const TuningValidation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  SetSums(SumLight(validation, cones), result);
  result.Objective =
    result.Leak + coneCost * static_cast<double>(cones.size()) / static_cast<double>(validation.Data.Vectors().Count);
}

/// What the proof closes costs little: the light of the cones that is not in shadow counts.
void MeasureTight(const TuningValidation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  SetSums(SumLight(validation, cones), result);
  const double held = 1.0 - result.Leak;
  const double most = mostTightCones * static_cast<double>(validation.Lights);
  result.Objective = result.Lost / std::max(held + result.Lost, 1e-300) + tightLeak * result.Leak +
    tightConeCost * std::max(0.0, static_cast<double>(cones.size()) - most);
}

/// For each sample the smallest share of the half angles at which a cone holds it; HUGE_VAL: none does at @p largest.
std::vector<double> HoldingFractions(const TuningValidation& validation, const std::vector<Cone>& cones, double largest)
{
  std::vector<Cone> narrow = cones;
  for (Cone& cone : narrow)
  {
    cone.HalfAngle *= largest;
  }
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(cones, validation.Lights);
  std::vector<ConeTree> trees;
  for (const std::vector<Cone>& ofLight : ConesOfLights(narrow, validation.Lights))
  {
    trees.push_back(ConeTree::OverSlices(ofLight, validation.Region, HUGE_VAL));
  }
  std::vector<double> fractions(validation.Samples.size(), HUGE_VAL);
  ParallelFor(static_cast<vtkIdType>(fractions.size()), {},
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double smallest = HUGE_VAL;
        const std::size_t light = validation.Samples[i].Light;
        trees[light].AnyAtPoint(validation.Samples[i].Point,
          [&](const ConeTree::Entry& entry)
          {
            const Cone& cone = conesOf[light][entry.Cone];
            const Vector3 offset = validation.Samples[i].Point - cone.Center;
            const double height = Dot(offset, cone.Axis);
            const double beyond = std::sqrt(std::max(0.0, Dot(offset, offset) - height * height)) - cone.BaseRadius;
            if (height >= 0.0)
            {
              smallest = std::min(smallest, beyond > 0.0 ? std::atan2(beyond, height) / cone.HalfAngle : 0.0);
            }
            return smallest == 0.0;
          });
        fractions[i] = smallest <= largest ? smallest : HUGE_VAL;
      }
    });
  return fractions;
}

/// The share of the angle at which as much lit light is lost inside the cones as blocked light leaks outside.
void MeasurePreview(const TuningValidation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  std::vector<double> fractions;
  const auto at = [&](double limit)
  {
    LightSums sums;
    for (std::size_t i = 0; i < fractions.size(); ++i)
    {
      const PathSample& sample = validation.Samples[i];
      const bool inside = fractions[i] <= limit;
      sums.Blocked += sample.Blocked ? sample.Length : 0.0;
      sums.Leaked += sample.Blocked && !inside ? sample.Length : 0.0;
      sums.Lost += !sample.Blocked && inside ? sample.Length : 0.0;
    }
    return sums;
  };
  // Few samples lie in narrow cones, and the balance mostly lies there: wide ones are asked only where it does not.
  LightSums sums;
  double high = 0.0;
  for (const double largest : { 0.25, 1.0 })
  {
    high = largest;
    fractions = HoldingFractions(validation, cones, largest);
    sums = at(largest);
    if (sums.Lost >= sums.Leaked)
    {
      break;
    }
  }
  double low = 0.0;
  sums = at(low);
  high = sums.Lost < sums.Leaked ? high : low;
  for (int i = 0; i < 12 && low < high; ++i)
  {
    const double middle = 0.5 * (low + high);
    sums = at(middle);
    (sums.Lost < sums.Leaked ? low : high) = middle;
  }
  const double fraction = high;
  sums = at(fraction);
  SetSums(sums, result);
  result.Options.ExpansionFraction = fraction;

  constexpr int side = TuningData::CellsPerSide;
  std::vector<double> cells(side * side * side, 0.0);
  for (std::size_t i = 0; i < fractions.size(); ++i)
  {
    const PathSample& sample = validation.Samples[i];
    if (sample.Blocked != (fractions[i] <= fraction))
    {
      cells[sample.Cell] += sample.Blocked ? sample.Length : -sample.Length;
    }
  }
  double imbalance = 0.0;
  for (const double cell : cells)
  {
    imbalance += std::abs(cell);
  }
  result.Objective = imbalance / std::max(sums.Blocked, 1e-300);
}

/// For each path the smallest factor on the radii at which a base disc blocks it; HUGE_VAL where none does up to the largest.
std::vector<double> BlockingScales(const TuningValidation& validation, const std::vector<Cone>& cones)
{
  std::vector<Cone> discs = cones;
  for (Cone& disc : discs)
  {
    disc.BaseRadius *= largestScale;
    disc.Axis = disc.Normal;
  }
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(cones, validation.Lights);
  std::vector<ConeTree> trees;
  for (const std::vector<Cone>& ofLight : ConesOfLights(discs, validation.Lights))
  {
    trees.push_back(ConeTree::OverBases(ofLight));
  }
  std::vector<double> scales(validation.Data.HeldOut.size(), HUGE_VAL);
  ParallelFor(static_cast<vtkIdType>(scales.size()), {}, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const HeldOutPath& path = validation.Data.HeldOut[i];
      trees[path.Light].ForEachOnRay(path.Origin, path.Direction, 0.0, HUGE_VAL, [&](const ConeTree::Entry& entry) {
        const Cone& disc = conesOf[path.Light][entry.Cone];
        const double slope = Dot(path.Direction, disc.Normal);
        const double t = Dot(disc.Center - path.Origin, disc.Normal) / slope;
        if (t > 0.0 && std::isfinite(t))
        {
          const double distance = Length(path.Origin + t * path.Direction - disc.Center);
          scales[i] = std::min(scales[i], distance / disc.BaseRadius);
        }
      });
    }
  });
  return scales;
}

/// The factor on the radii at which as many lit paths are caught as blocked ones are missed.
void MeasureSoft(const TuningValidation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  const std::vector<double> scales = BlockingScales(validation, cones);
  std::vector<double> lit;
  std::vector<double> blocked;
  for (std::size_t i = 0; i < scales.size(); ++i)
  {
    (std::isfinite(validation.Data.HeldOut[i].Stop) ? blocked : lit).push_back(scales[i]);
  }
  std::sort(lit.begin(), lit.end());
  std::sort(blocked.begin(), blocked.end());
  const auto caught = [](const std::vector<double>& sorted, double scale) {
    return static_cast<double>(std::upper_bound(sorted.begin(), sorted.end(), scale) - sorted.begin());
  };
  double low = 0.0;
  double high = largestScale;
  for (int i = 0; i < 30; ++i)
  {
    const double scale = 0.5 * (low + high);
    const double missed = static_cast<double>(blocked.size()) - caught(blocked, scale);
    (caught(lit, scale) < missed ? low : high) = scale;
  }
  const auto total = static_cast<double>(blocked.size());
  const double positives = caught(blocked, low);
  const double falsePositives = caught(lit, low);
  result.Options.RadiusScale = low;
  result.Leak = (total - positives) / total;
  result.Lost = falsePositives / total;
  result.Objective = 1.0 - positives / (total + falsePositives);
}
} // anonymous namespace

//------------------------------------------------------------------------------
TuningValidation::TuningValidation(const ShadowVectorView& vectors, const PhotonPathView& paths, std::size_t lights,
  ConeTuning tuning, vtkIdType largestNumberOfVectors)
  : Data(vectors, paths, largestNumberOfVectors)
  , Lights(lights)
  , Region(Data.Region(tuning == ConeTuning::Preview ? previewMargin : boundsMargin))
{
  if (tuning == ConeTuning::Preview)
  {
    this->Samples = this->Data.SamplesIn(this->Region);
  }
}

//------------------------------------------------------------------------------
bool MeasureFit(const TuningValidation& validation, const std::vector<LightExtent>& lights, ConeTuning tuning,
  const Monitor& monitor, ConeTuningResult& result)
{
  ConeSetOptions options = result.Options;
  options.ExpansionFraction = 1.0;
  options.RadiusScale = 1.0;
  ConeSet set;
  const PhotonPathView paths = options.MaximumOverspill < 1.0 ? validation.Data.Paths() : PhotonPathView{};
  if (!FitConeSet(validation.Data.Vectors(), paths, lights, options, Monitor{ nullptr, monitor.Aborted }, set))
  {
    return false;
  }
  switch (tuning)
  {
    case ConeTuning::Preview:
      MeasurePreview(validation, set.Cones, result);
      break;
    case ConeTuning::Soft:
      MeasureSoft(validation, set.Cones, result);
      break;
    case ConeTuning::Tight:
      MeasureTight(validation, set.Cones, result);
      break;
    default:
      MeasureConservative(validation, set.Cones, result);
      break;
  }
  return true;
}

} // namespace shadowcones
