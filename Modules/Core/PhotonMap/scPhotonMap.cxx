// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonMap.h"

#include "scDensityGrid.h"
#include "scLampPlane.h"
#include "scLightShares.h"
#include "scPhotonWalk.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace shadowcones
{
namespace
{
/// Photons that a thread takes at once: few, so that an abort is served soon, since a path may be long.
constexpr vtkIdType photonsPerTask = 128;
/// Tasks between two looks at how much is stored, at most; and looks, at least, where there are so many tasks.
constexpr vtkIdType tasksPerRound = 512;
constexpr vtkIdType fewestRounds = 8;

/// For random numbers that no emission uses.
constexpr std::uint64_t pathStream = 0x70686F746F6E73ull;
constexpr std::uint64_t heroStream = 0x6865726F6573ull;
/// Its multiples spread evenly over [0, 1), whatever is taken of them: every hero has its share of any photons.
constexpr double goldenRatio = 0.61803398874989484820;

double Fraction(double x)
{
  return x - std::floor(x);
}

void Add(std::vector<double>& sums, const std::vector<double>& values)
{
  std::transform(sums.begin(), sums.end(), values.begin(), sums.begin(), std::plus<double>());
}

void Append(PhotonMap& map, const PhotonMap& more)
{
  map.Surface.Append(more.Surface);
  map.Volume.Append(more.Volume);
  Add(map.Account.Emitted, more.Account.Emitted);
  Add(map.Account.AbsorbedBySurfaces, more.Account.AbsorbedBySurfaces);
  Add(map.Account.AbsorbedByMedium, more.Account.AbsorbedByMedium);
  Add(map.Account.Escaped, more.Account.Escaped);
  Add(map.Account.CutOff, more.Account.CutOff);
}

PhotonMap EmptyMap(std::size_t wavelengths)
{
  PhotonMap map;
  map.Surface.NumberOfWavelengths = wavelengths;
  map.Volume.NumberOfWavelengths = wavelengths;
  map.Account = PhotonAccount(wavelengths);
  return map;
}

/// All that photons of any range share.
class PhotonSource
{
public:
  PhotonSource(const PhotonMapScene& scene, const PhotonMapOptions& options)
    : Scene(scene)
    , Options(options)
    , Flight(scene.Medium)
    , Emissions(EmissionsOf(scene))
    , Shares(PowersOf(Emissions))
    , Counts(Shares.Counts(options.NumberOfPhotons))
  {
    for (const Light& light : scene.Lights)
    {
      this->Rules.push_back(scene.Occluders.RulesFor(FlatFaceOf(light)));
    }
  }

  void Trace(vtkIdType begin, vtkIdType end, PhotonMap& map) const
  {
    PhotonWalk walk(this->Scene, this->Options, this->Flight, this->Rules);
    const std::uint64_t paths = HashSeed(this->Options.Seed, pathStream);
    const double firstTurn = RandomStream(this->Options.Seed, heroStream).Next();
    for (vtkIdType photon = begin; photon < end; ++photon)
    {
      const LightShares::LightPhoton one = this->Shares.At(photon);
      const auto light = static_cast<std::size_t>(one.Light);
      RandomStream random(paths, static_cast<std::uint64_t>(photon));
      PhotonWalk::Photon leaving;
      static_cast<EmittedPhoton&>(leaving) =
        this->Emissions[light].Emit(HashSeed(this->Options.Seed, light), one.Index);
      leaving.Light = one.Light;
      leaving.Share = 1.0 / static_cast<double>(this->Counts[light]);
      leaving.Turn = Fraction(firstTurn + goldenRatio * static_cast<double>(one.Index));
      walk.Follow(leaving, random, map);
    }
  }

private:
  /// Photons are sent at all that they can meet.
  static std::vector<PhotonEmission> EmissionsOf(const PhotonMapScene& scene)
  {
    Box target = scene.Medium.Bounds;
    target.Add(scene.Occluders.Bounds());
    std::vector<PhotonEmission> emissions;
    for (const Light& light : scene.Lights)
    {
      emissions.emplace_back(light, target, target.Diagonal());
    }
    return emissions;
  }
  static std::vector<double> PowersOf(const std::vector<PhotonEmission>& emissions)
  {
    std::vector<double> powers;
    for (const PhotonEmission& emission : emissions)
    {
      powers.push_back(emission.Power());
    }
    return powers;
  }

  const PhotonMapScene& Scene;
  const PhotonMapOptions& Options;
  const FreeFlight Flight;
  const std::vector<PhotonEmission> Emissions;
  const LightShares Shares;
  const std::vector<vtkIdType> Counts; ///< photons of each light
  std::vector<RayRules> Rules;
};

void ThrowIfTooMany(const StoredPhotons& photons, const char* kind, vtkIdType most)
{
  if (photons.Count() > most)
  {
    throw std::length_error(std::string("more than ") + std::to_string(most) + " " + kind + " photons are to be stored");
  }
}
} // anonymous namespace

bool TracePhotonMap(
  const PhotonMapScene& scene, const PhotonMapOptions& options, const Monitor& monitor, PhotonMap& map)
{
  const std::size_t wavelengths = scene.Medium.SigmaS.size();
  map = EmptyMap(wavelengths);
  if (options.NumberOfPhotons <= 0 || scene.Lights.empty())
  {
    return true;
  }
  const PhotonSource source(scene, options);
  const vtkIdType first = PieceBound(options.NumberOfPhotons, options.Piece, options.NumberOfPieces);
  const vtkIdType last = PieceBound(options.NumberOfPhotons, options.Piece + 1, options.NumberOfPieces);
  const vtkIdType tasksOfAll = (last - first + photonsPerTask - 1) / photonsPerTask;
  const vtkIdType photonsPerRound =
    photonsPerTask * std::clamp<vtkIdType>(tasksOfAll / fewestRounds, 1, tasksPerRound);
  for (vtkIdType round = first; round < last; round += photonsPerRound)
  {
    const vtkIdType end = std::min(last, round + photonsPerRound);
    const vtkIdType tasks = (end - round + photonsPerTask - 1) / photonsPerTask;
    std::vector<PhotonMap> parts(static_cast<std::size_t>(tasks), EmptyMap(wavelengths));
    const auto done = [&](vtkIdType photon)
    { return static_cast<double>(photon - first) / static_cast<double>(last - first); };
    const bool finished = ParallelFor(tasks, monitor.Part(done(round), done(end)),
      [&](vtkIdType begin, vtkIdType stop)
      {
        for (vtkIdType task = begin; task < stop; ++task)
        {
          const vtkIdType from = round + task * photonsPerTask;
          source.Trace(from, std::min(end, from + photonsPerTask), parts[static_cast<std::size_t>(task)]);
        }
      });
    if (!finished)
    {
      return false;
    }
    for (PhotonMap& part : parts)
    {
      Append(map, part);
      part = PhotonMap();
    }
    ThrowIfTooMany(map.Surface, "surface", options.MaximumStored);
    ThrowIfTooMany(map.Volume, "volume", options.MaximumStored);
  }
  return true;
}

} // namespace shadowcones
