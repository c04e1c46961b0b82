// SPDX-License-Identifier: BSD-3-Clause
#include "LampRays.h"

#include "scLightSampler.h"

namespace shadowcones
{

//------------------------------------------------------------------------------
LampRays::LampRays(const OccluderScene& scene, const Light& light, int count)
  : Scene(scene)
  , Lamp(light)
  , Points(light, count)
  , Strata(Points.Count())
{
}

//------------------------------------------------------------------------------
/// @param sample gives the vector to the light point of a number and its weight.
template <class Sample>
double LampRays::Ask(const Vector3& x, Sample&& sample) const
{
  double to[3][64];
  double weights[64];
  double sum = 0.0;
  std::uint64_t wanted = 0;
  for (int k = 0; k < this->Points.Count(); ++k)
  {
    Vector3 vector;
    sample(k, vector, weights[k]);
    to[0][k] = vector.X;
    to[1][k] = vector.Y;
    to[2][k] = vector.Z;
    sum += weights[k];
    wanted |= static_cast<std::uint64_t>(weights[k] > 0.0) << k;
  }
  if (wanted == 0)
  {
    return 0.0;
  }
  const std::uint64_t hidden = this->Scene.OccludedFrom(x, to[0], to[1], to[2], wanted, this->Points.Parallel);
  double blocked = 0.0;
  for (int k = 0; k < this->Points.Count(); ++k)
  {
    blocked += (hidden >> k & 1) ? weights[k] : 0.0;
  }
  return blocked / sum;
}

//------------------------------------------------------------------------------
double LampRays::BlockedAt(const Vector3& x, RandomStream& random) const
{
  LightSampler sampler(this->Lamp, LightSampling::Auto);
  sampler.MoveTo(x);
  return this->Ask(x,
    [&](int k, Vector3& vector, double& weight)
    {
      const LightStrata::Point uv = this->Strata.Draw(k, random);
      const IncidentSample incident = sampler.Sample(uv.U, uv.V);
      vector = this->Points.Parallel ? incident.Direction : incident.Distance * incident.Direction;
      weight = incident.Weight;
    });
}

//------------------------------------------------------------------------------
double LampRays::BlockedOfSamePoints(const Vector3& x) const
{
  return this->Ask(x,
    [&](int k, Vector3& vector, double& weight)
    {
      vector = this->Points.Towards(k, x);
      weight = this->Points.Weight(vector);
    });
}

} // namespace shadowcones
