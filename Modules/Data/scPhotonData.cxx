// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonData.h"

#include "scFieldArrays.h"
#include "scFingerprints.h"
#include "scInputStamp.h"
#include "scMedium.h"
#include "scPhotonMap.h"
#include "scSentence.h"
#include "scTuples.h"
#include "scWarnings.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <utility>

namespace shadowcones
{
namespace
{
constexpr const char* kindName = "PhotonMap";

/// What is connected.
std::vector<vtkPolyData*> MapsOf(vtkInformationVector* port)
{
  std::vector<vtkPolyData*> maps;
  for (int k = 0; k < port->GetNumberOfInformationObjects(); ++k)
  {
    if (vtkPolyData* map = vtkPolyData::GetData(port, k))
    {
      maps.push_back(map);
    }
  }
  return maps;
}

bool ReadKind(vtkPolyData* map, PhotonMapKind& kind, std::string& error)
{
  vtkDataArray* array = map->GetFieldData()->GetArray(kindName);
  const double value = array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : -1.0;
  if (value != 0.0 && value != 1.0)
  {
    error = "It has no field array \"PhotonMap\" of 0 (surface) or 1 (volume): connect output ports 0 and 1 of a "
            "vtkPhotonMapFilter.";
    return false;
  }
  kind = static_cast<PhotonMapKind>(static_cast<int>(value));
  return true;
}

bool CopyPowers(vtkDataArray* array, StoredPhotons& photons, std::string& error)
{
  const int wavelengths = array->GetNumberOfComponents();
  for (vtkIdType id = 0; id < array->GetNumberOfTuples(); ++id)
  {
    for (int k = 0; k < wavelengths; ++k)
    {
      const double power = array->GetComponent(id, k);
      if (!(power >= 0.0) || std::isinf(power))
      {
        error = Sentence(
          "The \"Power\" of photon ", id, " at wavelength sample ", k, " is ", power, ": it must be 0 or above.");
        return false;
      }
      photons.Powers.push_back(static_cast<float>(power));
    }
  }
  return true;
}

bool ReadPhotons(
  vtkPolyData* map, std::size_t wavelengths, PhotonMapKind kind, StoredPhotons& photons, std::string& error)
{
  const vtkIdType count = map->GetNumberOfPoints();
  photons = StoredPhotons();
  photons.NumberOfWavelengths = wavelengths;
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = map->GetPointData();
  vtkDataArray *directions, *normals, *powers, *bounces;
  const Need needNormals = kind == PhotonMapKind::Surface ? Need::Required : Need::Optional;
  if (!FindArray(data, "photon map", "Direction", 3, count, Need::Required, directions, error) ||
    !FindArray(data, "photon map", "Normal", 3, count, needNormals, normals, error) ||
    !FindArray(data, "photon map", "Power", static_cast<int>(wavelengths), count, Need::Required, powers, error) ||
    !FindArray(data, "photon map", "Bounces", 1, count, Need::Required, bounces, error) ||
    !CopyFinitePoints(map, "photon", photons.Points, error) ||
    !CopyDirections(directions, "photon", photons.Directions, error) || !CopyPowers(powers, photons, error) ||
    !CopyWholeNumbers(bounces, "photon", NotNegative, photons.Bounces, error))
  {
    return false;
  }
  return kind != PhotonMapKind::Surface || CopyDirections(normals, "photon", photons.Normals, error);
}

/// The photons that have bounced, with a share of their power, after those that are there.
void AppendIndirect(const StoredPhotons& photons, double share, StoredPhotons& all)
{
  all.NumberOfWavelengths = photons.NumberOfWavelengths;
  for (vtkIdType id = 0; id < photons.Count(); ++id)
  {
    const int bounces = photons.Bounces[static_cast<std::size_t>(id)];
    if (bounces < 1)
    {
      continue;
    }
    const auto append = [id](auto& to, const auto& from, std::size_t components)
    {
      const auto first = from.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(id) * components);
      to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(components));
    };
    append(all.Points, photons.Points, 3);
    append(all.Directions, photons.Directions, 3);
    append(all.Normals, photons.Normals, photons.Normals.empty() ? 0 : 3);
    for (std::size_t k = 0; k < photons.NumberOfWavelengths; ++k)
    {
      all.Powers.push_back(static_cast<float>(share * static_cast<double>(photons.Power(id)[k])));
    }
    all.Bounces.push_back(bounces);
  }
}

/// All photons of a port by kind. @return false, with a sentence in @p error.
bool ReadPhotonMaps(
  vtkInformationVector* port, std::size_t wavelengths, std::array<StoredPhotons, 2>& photons, std::string& error)
{
  const std::vector<vtkPolyData*> maps = MapsOf(port);
  std::vector<PhotonMapKind> kinds(maps.size());
  std::array<int, 2> counts{ { 0, 0 } };
  for (std::size_t k = 0; k < maps.size(); ++k)
  {
    if (!ReadKind(maps[k], kinds[k], error))
    {
      return false;
    }
    counts[static_cast<std::size_t>(kinds[k])] += 1;
  }
  for (std::size_t k = 0; k < maps.size(); ++k)
  {
    StoredPhotons one;
    if (!ReadPhotons(maps[k], wavelengths, kinds[k], one, error))
    {
      return false;
    }
    const auto kind = static_cast<std::size_t>(kinds[k]);
    AppendIndirect(one, 1.0 / counts[kind], photons[kind]);
  }
  return true;
}

/// Does a field array say the same? Where it is not there, nothing is said.
bool Says(vtkFieldData* field, const char* name, const std::vector<double>& values)
{
  vtkDataArray* array = field->GetArray(name);
  if (!array)
  {
    return true;
  }
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples()) *
    static_cast<std::size_t>(array->GetNumberOfComponents());
  if (count != values.size())
  {
    return false;
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    const int components = array->GetNumberOfComponents();
    const double value = array->GetComponent(static_cast<vtkIdType>(k) / components, static_cast<int>(k) % components);
    if (value != values[k])
    {
      return false;
    }
  }
  return true;
}

std::string NamesOfOthers(vtkFieldData* field, const Medium& medium)
{
  const Box& box = medium.Bounds;
  const PhaseFunction& phase = medium.Phase;
  const std::pair<const char*, std::vector<double>> values[] = { { "SigmaS", medium.SigmaS },
    { "SigmaA", medium.SigmaA },
    { "MediumBounds", { box.Min.X, box.Max.X, box.Min.Y, box.Max.Y, box.Min.Z, box.Max.Z } },
    { "PhaseFunction", { static_cast<double>(phase.Kind) } },
    { "PhaseLobes", { phase.Lobes.Weight, phase.Lobes.K1, phase.Lobes.K2 } },
    { "PhaseAsymmetry", { phase.Asymmetry } } };
  std::string names;
  for (const auto& [name, own] : values)
  {
    names += Says(field, name, own) ? "" : (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}
} // anonymous namespace

void WritePhotons(const StoredPhotons& photons, PhotonMapKind kind, vtkPolyData* output)
{
  SetVertices(output, photons.Points);
  vtkPointData* data = output->GetPointData();
  AddFloatArray(data, "Direction", 3, photons.Directions);
  if (kind == PhotonMapKind::Surface)
  {
    AddFloatArray(data, "Normal", 3, photons.Normals);
  }
  AddFloatArray(data, "Power", static_cast<int>(photons.NumberOfWavelengths), photons.Powers);
  AddIntArray(data, "Bounces", 1, photons.Bounces);
  AddIntArray(output->GetFieldData(), kindName, 1, { static_cast<int>(kind) });
}

void WritePhotonAccount(const PhotonAccount& account, vtkFieldData* field)
{
  const auto wavelengths = static_cast<int>(account.Emitted.size());
  AddDoubleArray(field, "EmittedPower", wavelengths, account.Emitted);
  AddDoubleArray(field, "PowerAbsorbedBySurfaces", wavelengths, account.AbsorbedBySurfaces);
  AddDoubleArray(field, "PowerAbsorbedByMedium", wavelengths, account.AbsorbedByMedium);
  AddDoubleArray(field, "EscapedPower", wavelengths, account.Escaped);
  AddDoubleArray(field, "CutOffPower", wavelengths, account.CutOff);
}

void WritePhase(const Medium& medium, vtkFieldData* field)
{
  const PhaseFunction& phase = medium.Phase;
  AddIntArray(field, "PhaseFunction", 1, { static_cast<int>(phase.Kind) });
  AddDoubleArray(field, "PhaseLobes", 3, { phase.Lobes.Weight, phase.Lobes.K1, phase.Lobes.K2 });
  AddDoubleArray(field, "PhaseAsymmetry", 1, { phase.Asymmetry });
}

std::shared_ptr<const PreparedPhotons> PreparePhotons(PreparedUser& user, vtkInformationVector* port,
  std::size_t wavelengths, int neighbours, const Monitor& monitor, std::string& error)
{
  PreparedKey key(PreparedKind::Photons);
  key.Add(StampsOf(&port, 1)).Add(static_cast<std::uint64_t>(neighbours)).Add(std::uint64_t(wavelengths));
  return user.Get<PreparedPhotons>(key,
    [&]() -> std::shared_ptr<const PreparedPhotons>
    {
      std::array<StoredPhotons, 2> photons;
      auto made = std::make_shared<PreparedPhotons>();
      return ReadPhotonMaps(port, wavelengths, photons, error) &&
          PreparePhotonEstimates(
            std::move(photons[0]), std::move(photons[1]), neighbours, 1, monitor, made->Estimates)
        ? made
        : nullptr;
    });
}

void ComparePhotonMaps(vtkInformationVector* port, const Medium& medium, const std::vector<std::uint64_t>& lights,
  const std::vector<std::uint64_t>& casters, Warnings& warnings)
{
  for (vtkPolyData* map : MapsOf(port))
  {
    vtkFieldData* field = map->GetFieldData();
    const std::string input = "A photon map on input port 5";
    warnings.Add(CompareFingerprints(
      castersFingerprint, field, casters, input, "casters than those of the mesh on input port 0"));
    warnings.Add(CompareFingerprints(lightFingerprint, field, lights, input, "lights than those on input port 1"));
    warnings.Add(OtherMedium(NamesOfOthers(field, medium)));
  }
}

} // namespace shadowcones
