// SPDX-License-Identifier: BSD-3-Clause
#include "scSceneLights.h"

#include "scConeData.h"
#include "scFingerprints.h"
#include "scLightData.h"
#include "scMeshBlocks.h"
#include "scMeshData.h"
#include "scSentence.h"
#include "scWarnings.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace shadowcones
{
namespace
{
/// The blocks of a data object, in their order; itself where it has none.
void CollectBlocks(vtkDataObject* object, std::vector<vtkDataObject*>& blocks)
{
  if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(object))
  {
    for (unsigned int k = 0; k < tree->GetNumberOfBlocks(); ++k)
    {
      CollectBlocks(tree->GetBlock(k), blocks);
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(object))
  {
    for (unsigned int k = 0; k < collection->GetNumberOfPartitionedDataSets(); ++k)
    {
      CollectBlocks(collection->GetPartitionedDataSet(k), blocks);
    }
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(object))
  {
    for (unsigned int k = 0; k < parts->GetNumberOfPartitions(); ++k)
    {
      CollectBlocks(parts->GetPartitionAsDataObject(k), blocks);
    }
  }
  else if (object)
  {
    blocks.push_back(object);
  }
}

bool AddLight(vtkDataObject* object, SceneLights& lights, std::string& error)
{
  const std::size_t id = lights.Lights.size();
  auto* data = vtkPolyData::SafeDownCast(object);
  if (!data)
  {
    error = Sentence("Light ", id, " is a ", object->GetClassName(),
      " where a vtkPolyData is needed: run vtkDataSetSurfaceFilter on it first.");
    return false;
  }
  Light light;
  std::string warning;
  if (!ReadLight(data, light, error, &warning))
  {
    return false;
  }
  if (!warning.empty())
  {
    lights.Warnings.push_back(std::move(warning));
  }
  std::vector<double> wavelengths;
  if (!ReadWavelengths(data, light.Spectrum.size(), wavelengths, error))
  {
    return false;
  }
  if (id == 0)
  {
    lights.Wavelengths = wavelengths;
  }
  else if (wavelengths.size() != lights.Wavelengths.size())
  {
    error = Sentence("Light 0 has ", lights.Wavelengths.size(), " wavelengths and light ", id, " has ",
      wavelengths.size(), ": all lights of an input must have the same. Set NumberOfWavelengths of each.");
    return false;
  }
  else if (wavelengths != lights.Wavelengths)
  {
    error = Sentence("The \"LightWavelengths\" of light 0 and light ", id,
      " differ: all lights of an input must have the same wavelengths.");
    return false;
  }
  if (!IsAtInfinity(light) && data->GetNumberOfPoints() > 0)
  {
    const double* b = data->GetBounds();
    lights.Bounds.Add(Vector3{ b[0], b[2], b[4] });
    lights.Bounds.Add(Vector3{ b[1], b[3], b[5] });
  }
  lights.Lights.push_back(std::move(light));
  return true;
}

/// For each of the fingerprints the light that has it, each light once; -1: none has.
std::vector<int> MatchLights(const std::vector<std::uint64_t>& fingerprints, const std::vector<Light>& lights)
{
  std::vector<bool> taken(lights.size(), false);
  std::vector<int> matches;
  for (const std::uint64_t fingerprint : fingerprints)
  {
    matches.push_back(-1);
    for (std::size_t k = 0; k < lights.size() && matches.back() < 0; ++k)
    {
      if (!taken[k] && FingerprintOf(lights[k]) == fingerprint)
      {
        taken[k] = true;
        matches.back() = static_cast<int>(k);
      }
    }
  }
  return matches;
}

/// The first light that is among no matches; -1: all are.
int UnmatchedLight(const std::vector<int>& matches, std::size_t lights)
{
  for (int k = 0; k < static_cast<int>(lights); ++k)
  {
    if (std::find(matches.begin(), matches.end(), k) == matches.end())
    {
      return k;
    }
  }
  return -1;
}

void ShareCones(SceneLights& lights, std::vector<Cone>& cones)
{
  lights.Warnings.push_back(Sentence("The cone set has no \"LightId\" and ", lights.Lights.size(),
    " lights are connected: its cones are taken to bound the shadow of each. Make them with vtkShadowVectorFilter and "
    "vtkConeSetFilter from all of the lights."));
  std::vector<Cone> all;
  for (std::size_t k = 0; k < lights.Lights.size(); ++k)
  {
    for (Cone cone : cones)
    {
      cone.LightId = static_cast<int>(k);
      all.push_back(cone);
    }
  }
  cones.swap(all);
}

/// Warn of cones of lights that are not there, and of lights without cones, where only numbers tell.
void CheckLightIds(SceneLights& lights, const std::vector<Cone>& cones)
{
  const auto count = static_cast<int>(lights.Lights.size());
  std::vector<vtkIdType> counts(lights.Lights.size(), 0);
  vtkIdType others = 0;
  for (const Cone& cone : cones)
  {
    const bool known = cone.LightId >= 0 && cone.LightId < count;
    ++(known ? counts[static_cast<std::size_t>(cone.LightId)] : others);
  }
  if (others > 0)
  {
    lights.Warnings.push_back(Sentence(others, " of ", cones.size(), " cones are of other lights than the ", count,
      " that are connected, and bound no shadow."));
  }
  const auto none = std::find(counts.begin(), counts.end(), 0);
  if (!cones.empty() && none != counts.end())
  {
    lights.Warnings.push_back(Sentence("No cone of the set is of light ", none - counts.begin(),
      ": it is taken to cast no shadow. Make cones with vtkShadowVectorFilter from all of the lights."));
  }
}
} // anonymous namespace

void FillLightPortInformation(vtkInformation* info)
{
  // Poly data first: VTK then neither runs a filter once a block nor stops doing so for later ports.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  // A missing light is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
}

void FillScenePortInformation(int port, int meshPort, int lightPort, const char* other, vtkInformation* info)
{
  if (port == lightPort)
  {
    FillLightPortInformation(info);
  }
  else if (port == meshPort)
  {
    AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), other);
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
}

bool ReadLights(vtkInformationVector* port, SceneLights& lights, std::string& error)
{
  lights = {};
  error.clear();
  std::vector<vtkDataObject*> blocks;
  for (int k = 0; k < port->GetNumberOfInformationObjects(); ++k)
  {
    CollectBlocks(vtkDataObject::GetData(port, k), blocks);
  }
  if (blocks.empty())
  {
    error = "There is no light: all of its blocks are empty.";
    return false;
  }
  for (vtkDataObject* block : blocks)
  {
    if (!AddLight(block, lights, error))
    {
      return false;
    }
  }
  return true;
}

bool AreProved(vtkPolyData* coneSet, const std::vector<Cone>& cones, const TriangleMesh& mesh,
  const std::vector<Light>& lights, const char* input, std::string& changed)
{
  vtkFieldData* data = coneSet->GetFieldData();
  vtkDataArray* certified = data->GetArray("Certified");
  if (!certified || certified->GetNumberOfValues() == 0 || certified->GetComponent(0, 0) == 0.0)
  {
    return false;
  }
  const std::vector<int> matches = MatchLights(ReadLightFingerprints(data), lights);
  std::vector<Light> asProved;
  for (const int match : matches)
  {
    if (match >= 0)
    {
      asProved.push_back(lights[static_cast<std::size_t>(match)]);
    }
  }
  if (asProved.size() != lights.size() || matches.size() != lights.size())
  {
    return false; // AssignCones says it
  }
  std::string why;
  if (ReadConeCertificate(data, cones, mesh.View(), asProved, why).Certified)
  {
    return true;
  }
  const std::vector<std::uint64_t> casters = ReadFingerprints(castersFingerprint, data);
  if (casters.empty() || casters.front() == CastersFingerprintOf(mesh))
  {
    changed = ConesChanged(input);
  }
  return false;
}

void AssignCones(vtkPolyData* coneSet, SceneLights& lights, std::vector<Cone>& cones)
{
  const bool hasIds = coneSet->GetPointData()->HasArray("LightId");
  const std::vector<std::uint64_t> fingerprints = ReadLightFingerprints(coneSet->GetFieldData());
  const std::vector<int> matches = MatchLights(fingerprints, lights.Lights);
  const int unmatched = UnmatchedLight(matches, lights.Lights.size());
  if (!fingerprints.empty() && unmatched < 0)
  {
    for (Cone& cone : cones)
    {
      const auto id = static_cast<std::size_t>(cone.LightId);
      cone.LightId = cone.LightId >= 0 && id < matches.size() ? matches[id] : -1;
    }
    return;
  }
  if (!fingerprints.empty())
  {
    lights.Warnings.push_back(
      Sentence("The cone set was made with other lights: light ", unmatched, " is none of its ", fingerprints.size(),
        ", and shadow outside the cones is missed. Run vtkShadowVectorFilter and vtkConeSetFilter with the lights that "
        "are connected here."));
  }
  if (!hasIds && lights.Lights.size() > 1)
  {
    ShareCones(lights, cones);
    return;
  }
  CheckLightIds(lights, cones);
}

bool AssignGrids(vtkFieldData* volume, SceneLights& lights, std::vector<VisibilityGrid>& grids, std::string& error)
{
  const std::vector<std::uint64_t> fingerprints = ReadLightFingerprints(volume);
  const std::vector<int> matches = MatchLights(fingerprints, lights.Lights);
  const int unmatched = UnmatchedLight(matches, lights.Lights.size());
  if (!fingerprints.empty() && fingerprints.size() == grids.size() && unmatched < 0)
  {
    std::vector<VisibilityGrid> ordered(lights.Lights.size());
    for (std::size_t k = 0; k < grids.size(); ++k)
    {
      if (matches[k] >= 0)
      {
        ordered[static_cast<std::size_t>(matches[k])] = std::move(grids[k]);
      }
    }
    grids.swap(ordered);
    return true;
  }
  if (grids.size() != lights.Lights.size())
  {
    error = Sentence("\"Visibility\" has ", grids.size(), " components and ", lights.Lights.size(),
      " lights are connected: it must have one a light.");
    return false;
  }
  if (!fingerprints.empty())
  {
    lights.Warnings.push_back(Sentence("The visibility volume was made with other lights: light ", unmatched,
      " is none of its ", fingerprints.size(), ". Run vtkVisibilityVolume with the lights that are connected here."));
  }
  return true;
}

} // namespace shadowcones
