// SPDX-License-Identifier: BSD-3-Clause
#include "scConeTuning.h"

#include "scConeIntervals.h"
#include "scConeTree.h"
#include "scRandom.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace shadowcones
{
namespace
{
constexpr vtkIdType largestNumberOfVectors = 40000;
constexpr std::size_t largestNumberOfPaths = 6000;
constexpr double coneCost = 0.05;      ///< Conservative: what a cone per vector is worth in leak
constexpr double largestScale = 2.0;   ///< Soft: radii are not scaled beyond this
constexpr int numberOfProbes = 24;     ///< parameter sets spread over the ranges before the best is refined
constexpr int cellsPerSide = 12;       ///< Preview: columns in which lost and leaked light may cancel

/// A quarter of the photons, by a hash of what a vector and a path of the same photon have in common.
bool IsHeldOut(const double* emission, const float* direction)
{
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, emission + i, sizeof(double));
    std::uint32_t more = 0;
    std::memcpy(&more, direction + i, sizeof(float));
    hash = HashSeed(hash ^ bits, more);
  }
  return hash % 4 == 0;
}

/// A ray along a held-out path: lit up to Stop, in shadow from there on.
struct HeldOutPath
{
  Vector3 Origin;
  Vector3 Direction;
  double Stop;    ///< HUGE_VAL where the path is lit to its end
  int Column = 0; ///< of a grid across the paths, in which neighbouring paths share an entry
};

/// Vectors to fit and paths to judge by.
class TuningData
{
public:
  TuningData(const ShadowVectorView& vectors, const PhotonPathView& paths)
  {
    const vtkIdType stride = std::max<vtkIdType>(1, (vectors.Count + largestNumberOfVectors - 1) / largestNumberOfVectors);
    for (vtkIdType i = 0; i < vectors.Count; i += stride)
    {
      if (vectors.EmissionPoints && IsHeldOut(vectors.EmissionPoints + 3 * i, vectors.Directions + 3 * i))
      {
        continue;
      }
      this->Points.insert(this->Points.end(), vectors.Points + 3 * i, vectors.Points + 3 * i + 3);
      this->Directions.insert(this->Directions.end(), vectors.Directions + 3 * i, vectors.Directions + 3 * i + 3);
      if (vectors.EmissionPoints)
      {
        this->EmissionPoints.insert(
          this->EmissionPoints.end(), vectors.EmissionPoints + 3 * i, vectors.EmissionPoints + 3 * i + 3);
      }
      this->OccluderIds.push_back(vectors.OccluderIds ? vectors.OccluderIds[i] : 0);
    }

    Box bounds;
    for (vtkIdType i = 0; i < paths.Count; ++i)
    {
      const double* p = paths.Points + 3 * i;
      const double* e = paths.EmissionPoints + 3 * i;
      bounds.Add(Vector3{ p[0], p[1], p[2] });
      bounds.Add(Vector3{ e[0], e[1], e[2] });
      if (!IsHeldOut(e, paths.Directions + 3 * i) || this->Paths.size() >= largestNumberOfPaths)
      {
        continue;
      }
      HeldOutPath path;
      path.Origin = { e[0], e[1], e[2] };
      const float* d = paths.Directions + 3 * i;
      path.Direction = Normalized({ d[0], d[1], d[2] });
      path.Stop = paths.States[i] != 0 ? Length(Vector3{ p[0], p[1], p[2] } - path.Origin) : HUGE_VAL;
      this->NumberBlocked += paths.States[i] != 0;
      this->Paths.push_back(path);
    }
    const double margin = 0.5 * bounds.Diagonal();
    this->Region.Min = bounds.Min - Vector3{ margin, margin, margin };
    this->Region.Max = bounds.Max + Vector3{ margin, margin, margin };
    this->SetColumns();
    if (this->NumberBlocked == 0 || this->NumberBlocked == static_cast<vtkIdType>(this->Paths.size()))
    {
      throw std::invalid_argument("tuning needs both lit and blocked photon paths; of " +
        std::to_string(this->Paths.size()) + " held out, " + std::to_string(this->NumberBlocked) + " are blocked");
    }
  }

  /// Number the columns of a grid across the paths where they pass the middle of the region.
  void SetColumns()
  {
    Vector3 axis;
    for (const HeldOutPath& path : this->Paths)
    {
      axis += path.Direction;
    }
    axis = Normalized(axis);
    const Frame frame = FrameAround(axis);
    const Vector3 middle = this->Region.Center();
    std::vector<std::array<double, 2>> crossings;
    Box bounds;
    for (const HeldOutPath& path : this->Paths)
    {
      const Vector3 offset = path.Origin - middle;
      const double slope = std::max(Dot(path.Direction, axis), 1e-3);
      const Vector3 crossing = offset - (Dot(offset, axis) / slope) * path.Direction;
      crossings.push_back({ Dot(crossing, frame.U), Dot(crossing, frame.V) });
      bounds.Add(Vector3{ crossings.back()[0], crossings.back()[1], 0.0 });
    }
    const auto cell = [](double x, double low, double high) {
      return std::clamp(static_cast<int>((x - low) / std::max(high - low, 1e-300) * cellsPerSide), 0, cellsPerSide - 1);
    };
    for (std::size_t i = 0; i < crossings.size(); ++i)
    {
      this->Paths[i].Column = cell(crossings[i][0], bounds.Min.X, bounds.Max.X) * cellsPerSide +
        cell(crossings[i][1], bounds.Min.Y, bounds.Max.Y);
    }
  }

  ShadowVectorView Vectors() const
  {
    ShadowVectorView view;
    view.Count = static_cast<vtkIdType>(this->OccluderIds.size());
    view.Points = this->Points.data();
    view.Directions = this->Directions.data();
    view.EmissionPoints = this->EmissionPoints.empty() ? nullptr : this->EmissionPoints.data();
    view.OccluderIds = this->OccluderIds.data();
    return view;
  }

  std::vector<HeldOutPath> Paths;
  vtkIdType NumberBlocked = 0;
  Box Region;

private:
  std::vector<double> Points;
  std::vector<float> Directions;
  std::vector<double> EmissionPoints;
  std::vector<int> OccluderIds;
};

/// Lengths of light, summed over the held-out paths.
struct LightSums
{
  double Blocked = 0.0;
  double Leaked = 0.0; ///< blocked, outside the cones
  double Lost = 0.0;   ///< lit, inside the cones
  std::vector<double> Columns = std::vector<double>(cellsPerSide * cellsPerSide, 0.0); ///< leaked minus lost, by column
};

LightSums SumLight(const TuningData& data, const std::vector<Cone>& cones)
{
  const ConeHierarchy hierarchy(cones, data.Region);
  // Fixed chunks, joined in order: the sums do not depend on the number of threads.
  constexpr vtkIdType chunk = 256;
  const auto count = static_cast<vtkIdType>(data.Paths.size());
  std::vector<LightSums> parts(static_cast<std::size_t>((count + chunk - 1) / chunk));
  ParallelFor(static_cast<vtkIdType>(parts.size()), {}, [&](vtkIdType first, vtkIdType last) {
    std::vector<RayInterval> intervals;
    for (vtkIdType part = first; part < last; ++part)
    {
      for (vtkIdType i = part * chunk; i < std::min(count, (part + 1) * chunk); ++i)
      {
        const HeldOutPath& path = data.Paths[i];
        double begin = 0.0;
        double end = HUGE_VAL;
        if (!data.Region.Clip(path.Origin, path.Direction, begin, end))
        {
          continue;
        }
        const double stop = std::clamp(path.Stop, begin, end);
        hierarchy.Intersect(path.Origin, path.Direction, begin, end, intervals);
        double leaked = end - stop;
        double lost = 0.0;
        parts[part].Blocked += leaked;
        for (const RayInterval& interval : intervals)
        {
          leaked -= std::max(0.0, interval.End - std::max(interval.Begin, stop));
          lost += std::max(0.0, std::min(interval.End, stop) - interval.Begin);
        }
        leaked = std::max(0.0, leaked);
        parts[part].Leaked += leaked;
        parts[part].Lost += lost;
        parts[part].Columns[path.Column] += leaked - lost;
      }
    }
  });
  LightSums sums;
  for (const LightSums& part : parts)
  {
    sums.Blocked += part.Blocked;
    sums.Leaked += part.Leaked;
    sums.Lost += part.Lost;
    for (std::size_t column = 0; column < sums.Columns.size(); ++column)
    {
      sums.Columns[column] += part.Columns[column];
    }
  }
  return sums;
}

void SetSums(const LightSums& sums, ConeTuningResult& result)
{
  const double blocked = std::max(sums.Blocked, 1e-300);
  result.Leak = sums.Leaked / blocked;
  result.Lost = sums.Lost / blocked;
}

void MeasureConservative(const TuningData& data, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  SetSums(SumLight(data, cones), result);
  result.Objective =
    result.Leak + coneCost * static_cast<double>(cones.size()) / static_cast<double>(data.Vectors().Count);
}

/// The share of the angle at which as much lit light is lost inside the cones as blocked light leaks outside.
void MeasurePreview(const TuningData& data, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  const auto at = [&](double fraction) {
    std::vector<Cone> scaled = cones;
    for (Cone& cone : scaled)
    {
      cone.HalfAngle *= fraction;
    }
    return SumLight(data, scaled);
  };
  double low = 0.0;
  double high = 1.0;
  LightSums sums = at(low);
  double fraction = low;
  if (sums.Lost < sums.Leaked)
  {
    for (int i = 0; i < 8; ++i)
    {
      fraction = 0.5 * (low + high);
      sums = at(fraction);
      (sums.Lost < sums.Leaked ? low : high) = fraction;
    }
  }
  SetSums(sums, result);
  result.Options.ExpansionFraction = fraction;
  double imbalance = 0.0;
  for (const double column : sums.Columns)
  {
    imbalance += std::abs(column);
  }
  result.Objective = imbalance / std::max(sums.Blocked, 1e-300);
}

/// For each path the smallest factor on the radii at which a base disc blocks it; HUGE_VAL where none does up to the largest.
std::vector<double> BlockingScales(const TuningData& data, const std::vector<Cone>& cones)
{
  std::vector<Cone> discs = cones;
  for (Cone& disc : discs)
  {
    disc.BaseRadius *= largestScale;
    disc.Axis = disc.Normal;
  }
  const ConeTree tree = ConeTree::OverBases(discs);
  std::vector<double> scales(data.Paths.size(), HUGE_VAL);
  ParallelFor(static_cast<vtkIdType>(scales.size()), {}, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const HeldOutPath& path = data.Paths[i];
      tree.ForEachOnRay(path.Origin, path.Direction, 0.0, HUGE_VAL, [&](const ConeTree::Entry& entry) {
        const Cone& disc = cones[entry.Cone];
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
void MeasureSoft(const TuningData& data, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  const std::vector<double> scales = BlockingScales(data, cones);
  std::vector<double> lit;
  std::vector<double> blocked;
  for (std::size_t i = 0; i < scales.size(); ++i)
  {
    (std::isfinite(data.Paths[i].Stop) ? blocked : lit).push_back(scales[i]);
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

/// Fit with the options in the result, measure, and set what balances.
bool Measure(const TuningData& data, const LightExtent& light, ConeTuning tuning, const Monitor& monitor,
  ConeTuningResult& result)
{
  ConeSetOptions options = result.Options;
  options.ExpansionFraction = 1.0;
  options.RadiusScale = 1.0;
  ConeSet set;
  if (!FitConeSet(data.Vectors(), {}, light, options, Monitor{ nullptr, monitor.Aborted }, set))
  {
    return false;
  }
  switch (tuning)
  {
    case ConeTuning::Preview:
      MeasurePreview(data, set.Cones, result);
      break;
    case ConeTuning::Soft:
      MeasureSoft(data, set.Cones, result);
      break;
    default:
      MeasureConservative(data, set.Cones, result);
      break;
  }
  return true;
}

/// Where the search starts: what measuring found good for each use.
ConeSetOptions Recipe(ConeTuning tuning, ConeSetOptions options)
{
  options.NumberOfNeighbors = 100;
  options.PointsPerRing = 16;
  options.MinimumVectorsPerCone = 20;
  options.VarianceThreshold = tuning == ConeTuning::Soft ? 1.4 : 1.8;
  options.CosineCorrection = tuning == ConeTuning::Preview;
  options.Expansion = ConeExpansion::LightGeometry;
  options.Overlap = tuning != ConeTuning::Preview;
  options.ExpansionFraction = 1.0;
  options.RadiusScale = 1.0;
  options.MaximumOverspill = 1.0;
  return options;
}

/// The index-th of a sequence of parameter sets that is spread evenly over the useful ranges.
ConeSetOptions Probe(ConeSetOptions options, int index)
{
  const auto u = SobolPoint(1, static_cast<std::uint32_t>(index));
  options.NumberOfNeighbors = static_cast<int>(24.0 * std::pow(10.0, u[0]));
  options.VarianceThreshold = 1.1 + 2.0 * u[1];
  options.MinimumVectorsPerCone = std::min(options.NumberOfNeighbors, static_cast<int>(6.0 * std::pow(5.0, u[2])));
  options.PointsPerRing = std::min(options.NumberOfNeighbors - 1, static_cast<int>(6.0 + 18.0 * u[3]));
  return options;
}

/// Steps from the options to either side, one parameter at a time.
std::vector<ConeSetOptions> Neighbors(const ConeSetOptions& options)
{
  std::vector<ConeSetOptions> steps;
  for (const double factor : { 0.75, 1.35 })
  {
    ConeSetOptions step = options;
    step.NumberOfNeighbors = std::max(8, static_cast<int>(factor * options.NumberOfNeighbors));
    steps.push_back(step);
    step = options;
    step.MinimumVectorsPerCone = std::max(4, static_cast<int>(factor * options.MinimumVectorsPerCone));
    steps.push_back(step);
    step = options;
    step.PointsPerRing = std::max(4, static_cast<int>(factor * options.PointsPerRing));
    steps.push_back(step);
    step = options;
    step.VarianceThreshold = std::max(1.0, options.VarianceThreshold + (factor - 1.0));
    steps.push_back(step);
  }
  return steps;
}

} // anonymous namespace

bool MeasureTuning(const ShadowVectorView& vectors, const PhotonPathView& paths, const LightExtent& light,
  ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor, ConeTuningResult& result)
{
  result = {};
  result.Options = options;
  result.NumberOfFits = 1;
  return Measure(TuningData(vectors, paths), light, tuning, monitor, result);
}

bool TuneConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths, const LightExtent& light,
  ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor, ConeTuningResult& result)
{
  result = {};
  result.Options = options;
  if (tuning == ConeTuning::Manual)
  {
    return true;
  }
  const TuningData data(vectors, paths);
  result.Options = Recipe(tuning, options);
  if (!Measure(data, light, tuning, monitor, result))
  {
    return false;
  }
  result.StartObjective = result.Objective;
  result.NumberOfFits = 1;
  const auto attempt = [&](const ConeSetOptions& options) {
    if (CheckConeSetOptions(options))
    {
      return true;
    }
    ConeTuningResult candidate;
    candidate.Options = options;
    candidate.StartObjective = result.StartObjective;
    candidate.NumberOfFits = result.NumberOfFits + 1;
    if (!Measure(data, light, tuning, monitor, candidate))
    {
      return false;
    }
    if (candidate.Objective < result.Objective)
    {
      result = candidate;
    }
    result.NumberOfFits = candidate.NumberOfFits;
    if (monitor.Progress)
    {
      monitor.Progress(std::min(1.0, result.NumberOfFits / (numberOfProbes + 18.0)));
    }
    return true;
  };
  const ConeSetOptions recipe = result.Options;
  for (int probe = 0; probe < numberOfProbes; ++probe)
  {
    if (!attempt(Probe(recipe, probe)))
    {
      return false;
    }
  }
  for (int round = 0; round < 2; ++round)
  {
    const double before = result.Objective;
    for (const ConeSetOptions& step : Neighbors(result.Options))
    {
      if (!attempt(step))
      {
        return false;
      }
    }
    if (!(result.Objective < before))
    {
      break;
    }
  }
  return true;
}

} // namespace shadowcones
