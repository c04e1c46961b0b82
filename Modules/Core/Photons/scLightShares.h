// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightShares.h
 * @brief Which photons of a sequence leave which of several lights. Internal to Core.
 */
#ifndef scLightShares_h
#define scLightShares_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/**
 * Photons are dealt to lights in proportion to their powers, in a pattern that repeats: every stretch of the sequence
 * holds about the same shares. A light gets no less than an eighth of an equal share, so that a faint one casts shadows
 * too, but nothing where its power is 0.
 */
class LightShares
{
public:
  explicit LightShares(const std::vector<double>& powers);

  struct LightPhoton
  {
    int Light = 0;
    vtkIdType Index = 0; ///< among the photons of that light
  };
  LightPhoton At(vtkIdType photon) const;
  /// How many of the first @p photons each light has.
  std::vector<vtkIdType> Counts(vtkIdType photons) const;

private:
  std::vector<vtkIdType> InPattern; ///< of every light
  std::vector<LightPhoton> Pattern;
};

} // namespace shadowcones

#endif
