// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonWalk.h"

#include "scConstants.h"
#include "scFrame.h"
#include "scTriangleReflectance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowcones
{
namespace
{
void Add(std::vector<double>& sums, const std::vector<double>& values)
{
  std::transform(sums.begin(), sums.end(), values.begin(), sums.begin(), std::plus<double>());
}

/// The direction at this cosine from an axis, around which it is turned by a share of a full turn.
Vector3 DirectionAround(const Vector3& axis, double cosine, double turn)
{
  const Frame frame = FrameAround(axis);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double azimuth = TwoPi * turn;
  return Normalized(
    sine * std::cos(azimuth) * frame.U + sine * std::sin(azimuth) * frame.V + cosine * axis);
}

void Append(std::vector<float>& values, const Vector3& v)
{
  values.insert(values.end(), { static_cast<float>(v.X), static_cast<float>(v.Y), static_cast<float>(v.Z) });
}
} // anonymous namespace

PhotonWalk::PhotonWalk(const PhotonMapScene& scene, const PhotonMapOptions& options, const FreeFlight& flight,
  const std::vector<RayRules>& rules)
  : Scene(scene)
  , Options(options)
  , Flight(flight)
  , Rules(rules)
{
  const Medium& medium = scene.Medium;
  for (std::size_t k = 0; k < medium.SigmaS.size(); ++k)
  {
    const double sigmaT = medium.SigmaS[k] + medium.SigmaA[k];
    this->SigmasDiffer = this->SigmasDiffer || (k > 0 && sigmaT != this->SigmaT.front());
    this->SigmaT.push_back(sigmaT);
    this->Albedo.push_back(sigmaT > 0.0 ? medium.SigmaS[k] / sigmaT : 0.0);
  }
  this->Weights.resize(this->SigmaT.size());
  this->Shares.resize(this->SigmaT.size());
  this->After.resize(this->SigmaT.size());
}

void PhotonWalk::Follow(const Photon& photon, RandomStream& random, PhotonMap& map)
{
  if (!this->Start(photon))
  {
    return;
  }
  Add(map.Account.Emitted, this->Weights);
  RayRules rules = this->Rules[static_cast<std::size_t>(photon.Light)];
  for (bool flies = true; flies; rules = {})
  {
    const FlightEnd end = this->Fly(rules, random);
    if (end.Collides)
    {
      flies = this->Collide(end.T, random, map);
    }
    else if (end.Hit.Triangle >= 0)
    {
      flies = this->Reflect(end, random, map);
    }
    else
    {
      Add(map.Account.Escaped, this->Weights);
      flies = false;
    }
  }
}

bool PhotonWalk::Start(const Photon& photon)
{
  const std::vector<double>& spectrum = this->Scene.Lights[static_cast<std::size_t>(photon.Light)].Spectrum;
  const auto count = static_cast<double>(spectrum.size());
  const double mean = std::accumulate(spectrum.begin(), spectrum.end(), 0.0) / count;
  if (!(photon.Power > 0.0) || !(mean > 0.0))
  {
    return false;
  }
  for (std::size_t k = 0; k < spectrum.size(); ++k)
  {
    this->Weights[k] = photon.Share * photon.Power * spectrum[k] / mean;
  }
  std::fill(this->Shares.begin(), this->Shares.end(), 1.0);
  this->Hero = this->SigmasDiffer ? static_cast<std::size_t>(photon.Turn * count) : 0;
  this->Line = { photon.Origin, photon.Direction };
  this->Bounces = 0;
  return true;
}

PhotonWalk::FlightEnd PhotonWalk::Fly(const RayRules& rules, RandomStream& random)
{
  FlightEnd end;
  const bool meets =
    this->Scene.Occluders.Intersect(this->Line.Origin, this->Line.Direction, 0.0, HUGE_VAL, end.Hit, rules);
  end.Hit.Triangle = meets ? end.Hit.Triangle : -1;
  end.T = meets ? end.Hit.T : HUGE_VAL;
  RayInterval inside{ 0.0, end.T };
  if (this->Scene.Medium.Bounds.Clip(this->Line.Origin, this->Line.Direction, inside.Begin, inside.End))
  {
    const double t = this->Flight.Sample(this->SigmaT[this->Hero], this->Line, inside, random);
    end.Collides = t < inside.End;
    end.T = end.Collides ? t : end.T;
    if (this->SigmasDiffer)
    {
      this->Weigh(
        this->Flight.OpticalDepth(this->Line, { inside.Begin, std::min(t, inside.End) }), end.Collides);
    }
  }
  return end;
}

/// Change weights and shares for a flight over an optical depth in units of sigma_t.
void PhotonWalk::Weigh(double opticalDepth, bool collides)
{
  const double hero = this->SigmaT[this->Hero];
  double mean = 0.0;
  for (std::size_t k = 0; k < this->SigmaT.size(); ++k)
  {
    const double passes = std::exp(-(this->SigmaT[k] - hero) * opticalDepth);
    this->After[k] = collides ? passes * this->SigmaT[k] / hero : passes;
    mean += this->Shares[k] * this->After[k] / static_cast<double>(this->SigmaT.size());
  }
  for (std::size_t k = 0; k < this->SigmaT.size(); ++k)
  {
    this->Weights[k] *= this->After[k] / mean;
    this->Shares[k] *= this->After[k] / mean;
  }
}

/// @return whether the photon flies on, scattered.
bool PhotonWalk::Collide(double t, RandomStream& random, PhotonMap& map)
{
  const Vector3 point = this->Line.Origin + t * this->Line.Direction;
  std::transform(this->Weights.begin(), this->Weights.end(), this->Albedo.begin(), this->After.begin(),
    std::multiplies<double>());
  this->Store(point, this->After, map.Volume);
  if (!this->GoOn(this->After, map.Account.AbsorbedByMedium, random, map))
  {
    return false;
  }
  const double cosine = SamplePhaseCosine(this->Scene.Medium.Phase, random.Next());
  this->Line = { point, DirectionAround(this->Line.Direction, cosine, random.Next()) };
  return true;
}

/// @return whether the photon flies on, reflected.
bool PhotonWalk::Reflect(const FlightEnd& end, RandomStream& random, PhotonMap& map)
{
  const Vector3 point = this->Line.Origin + end.T * this->Line.Direction;
  const Vector3 normal = (end.Hit.FrontFacing ? 1.0 : -1.0) * this->Scene.Occluders.TriangleNormal(end.Hit.Triangle);
  const vtkIdType stored = map.Surface.Count();
  this->Store(point, this->Weights, map.Surface);
  if (map.Surface.Count() > stored)
  {
    Append(map.Surface.Normals, normal);
  }
  for (std::size_t k = 0; k < this->Weights.size(); ++k)
  {
    this->After[k] = this->Weights[k] *
      TriangleReflectance(this->Options.SurfaceReflectance, this->Options.ReflectanceComponents,
        this->Options.Reflectance, end.Hit.Triangle, k);
  }
  if (!this->GoOn(this->After, map.Account.AbsorbedBySurfaces, random, map))
  {
    return false;
  }
  // Lambert: the squared cosine is uniform.
  const double cosine = std::sqrt(random.Next());
  this->Line = { point + RoundingAlong(this->Line.Origin, end.T) * normal,
    DirectionAround(normal, cosine, random.Next()) };
  return true;
}

/// Absorb what is not in @p after, and draw whether the photon goes on with that.
bool PhotonWalk::GoOn(
  const std::vector<double>& after, std::vector<double>& absorbed, RandomStream& random, PhotonMap& map)
{
  double sumBefore = 0.0;
  double sumAfter = 0.0;
  for (std::size_t k = 0; k < after.size(); ++k)
  {
    absorbed[k] += this->Weights[k] - after[k];
    sumBefore += this->Weights[k];
    sumAfter += after[k];
  }
  if (!(sumAfter > 0.0))
  {
    return false;
  }
  if (this->Bounces == this->Options.MaximumBounces)
  {
    Add(map.Account.CutOff, after);
    return false;
  }
  const double goesOn = std::min(sumAfter / sumBefore, 1.0);
  if (goesOn < 1.0 && random.Next() >= goesOn)
  {
    return false;
  }
  std::transform(
    after.begin(), after.end(), this->Weights.begin(), [goesOn](double weight) { return weight / goesOn; });
  ++this->Bounces;
  return true;
}

void PhotonWalk::Store(const Vector3& point, const std::vector<double>& powers, StoredPhotons& photons) const
{
  const bool any = std::any_of(powers.begin(), powers.end(), [](double power) { return power > 0.0; });
  if (!any || (this->Bounces == 0 && !this->Options.StoreDirect))
  {
    return;
  }
  photons.Points.insert(photons.Points.end(), { point.X, point.Y, point.Z });
  Append(photons.Directions, this->Line.Direction);
  for (const double power : powers)
  {
    photons.Powers.push_back(static_cast<float>(power));
  }
  photons.Bounces.push_back(this->Bounces);
}

} // namespace shadowcones
