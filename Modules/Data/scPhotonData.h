// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonData.h
 * @brief Photon maps as poly data, and what a photon map says of the medium that it was made in.
 */
#ifndef scPhotonData_h
#define scPhotonData_h

#include "ShadowConesDataModule.h"
#include "scPhotonEstimates.h"
#include "scPreparedScene.h"
#include "scStoredPhotons.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkFieldData;
class vtkInformationVector;
class vtkPolyData;

namespace shadowcones
{

class Warnings;
struct Medium;
struct PhotonAccount;

/// Values of the field array "PhotonMap".
enum class PhotonMapKind : int
{
  Surface = 0,
  Volume = 1
};

/// Write photons, a vertex each, and in the field data of which kind they are.
SHADOWCONESDATA_EXPORT void WritePhotons(const StoredPhotons& photons, PhotonMapKind kind, vtkPolyData* output);
/// Where the light went, one value a wavelength each.
SHADOWCONESDATA_EXPORT void WritePhotonAccount(const PhotonAccount& account, vtkFieldData* field);
/// "PhaseFunction" (int), "PhaseLobes" (double 3) and "PhaseAsymmetry" (double): beside what WriteMedium writes.
SHADOWCONESDATA_EXPORT void WritePhase(const Medium& medium, vtkFieldData* field);

struct SHADOWCONESDATA_EXPORT PreparedPhotons : PreparedItem
{
  PhotonEstimates Estimates;

  std::int64_t Memory() const override { return this->Estimates.Memory(); }
};

/**
 * The photon maps of a port, ready to be asked: those of each kind are averaged, and photons without a bounce left out. @param
 * neighbours see PreparePhotonEstimates. @return nullptr, with a sentence in @p error, where one of them is no photon map, or
 * without one where aborted.
 */
SHADOWCONESDATA_EXPORT std::shared_ptr<const PreparedPhotons> PreparePhotons(PreparedUser& user,
  vtkInformationVector* port, std::size_t wavelengths, int neighbours, const Monitor& monitor, std::string& error);

/// Warn where photon maps of a port were made in another medium than this, of other lights or casters than these.
SHADOWCONESDATA_EXPORT void ComparePhotonMaps(vtkInformationVector* port, const Medium& medium,
  const std::vector<std::uint64_t>& lights, const std::vector<std::uint64_t>& casters, Warnings& warnings);

} // namespace shadowcones

#endif
