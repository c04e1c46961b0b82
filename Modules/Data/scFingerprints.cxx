// SPDX-License-Identifier: BSD-3-Clause
#include "scFingerprints.h"

#include "scMeshData.h"
#include "scRandom.h"
#include "scWarnings.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkTypeUInt64Array.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace shadowcones
{
namespace
{

using Triangle = std::array<Vector3, 3>;

/// The height above the longest side is a matter of rounding.
bool HasArea(const Triangle& t)
{
  const double longest = std::max({ Length(t[1] - t[0]), Length(t[2] - t[1]), Length(t[0] - t[2]) });
  double largest = 0.0;
  for (const Vector3& p : t)
  {
    largest = std::max({ largest, std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }
  return Length(Cross(t[1] - t[0], t[2] - t[0])) > 1e-14 * std::max(largest, longest) * longest;
}

bool ComesFirst(const Vector3& a, const Vector3& b)
{
  return a.X != b.X ? a.X < b.X : a.Y != b.Y ? a.Y < b.Y : a.Z < b.Z;
}

std::uint64_t HashOf(Triangle t)
{
  std::sort(t.begin(), t.end(), ComesFirst);
  std::uint64_t hash = 0;
  for (const Vector3& p : t)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double value = p[axis] + 0.0; // no -0
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      hash = HashSeed(hash, bits);
    }
  }
  return hash;
}

} // namespace

std::uint64_t CastersFingerprintOf(const TriangleMesh& mesh)
{
  const TriangleMeshView view = mesh.View();
  std::vector<std::uint64_t> hashes;
  for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
  {
    const Triangle triangle{ view.Corner(t, 0), view.Corner(t, 1), view.Corner(t, 2) };
    if (view.OccluderId(t) >= 0 && HasArea(triangle))
    {
      hashes.push_back(HashOf(triangle));
    }
  }
  std::sort(hashes.begin(), hashes.end());
  hashes.erase(std::unique(hashes.begin(), hashes.end()), hashes.end());
  std::uint64_t all = 0;
  for (const std::uint64_t hash : hashes)
  {
    all = HashSeed(all, hash);
  }
  return all;
}

void WriteFingerprints(const char* name, const std::vector<std::uint64_t>& fingerprints, vtkFieldData* data)
{
  if (fingerprints.empty())
  {
    return;
  }
  vtkNew<vtkTypeUInt64Array> array;
  array->SetName(name);
  for (const std::uint64_t fingerprint : fingerprints)
  {
    array->InsertNextValue(fingerprint);
  }
  data->AddArray(array);
}

std::vector<std::uint64_t> ReadFingerprints(const char* name, vtkFieldData* data)
{
  std::vector<std::uint64_t> fingerprints;
  vtkDataArray* array = data->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    fingerprints.push_back(array->GetVariantValue(i).ToTypeUInt64());
  }
  return fingerprints;
}

std::string CompareFingerprints(const char* name, vtkFieldData* data, const std::vector<std::uint64_t>& own,
  const std::string& input, const std::string& from)
{
  const std::vector<std::uint64_t> given = ReadFingerprints(name, data);
  return given.empty() || given == own
    ? std::string()
    : input + " was made from other " + from + ": shadows may be missing or out of place. Make it again from these.";
}

std::uint64_t CompareCasters(
  std::uint64_t casters, int meshPort, vtkFieldData* made, const std::string& input, Warnings& warnings)
{
  warnings.Add(CompareFingerprints(castersFingerprint, made, { casters }, input,
    "casters than those of the mesh on input port " + std::to_string(meshPort)));
  return casters;
}

} // namespace shadowcones
