// SPDX-License-Identifier: BSD-3-Clause
#include "scConeData.h"

#include "scCone.h"
#include "scFieldArrays.h"
#include "scTuples.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeUInt64Array.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shadowcones
{
namespace
{

bool CheckCone(const Cone& cone, vtkIdType i, std::string& error)
{
  const std::string ofCone = " of cone " + std::to_string(i);
  if (const char* fault = FaultOf(cone.Center))
  {
    error = "The position" + ofCone + " " + fault + ".";
  }
  else if (FaultOf(cone.BaseRadius) || cone.BaseRadius < 0.0)
  {
    error = "The \"BaseRadius\"" + ofCone + " is " + std::to_string(cone.BaseRadius) +
      ": it must be finite, at most 1e18 and not negative.";
  }
  else if (!(std::abs(cone.HalfAngle) < std::acos(0.0)))
  {
    error =
      "The \"HalfAngle\"" + ofCone + " is " + std::to_string(cone.HalfAngle) + ": it must lie between -pi/2 and pi/2.";
  }
  else if (!(std::abs(cone.InnerHalfAngle) < std::acos(0.0)))
  {
    error = "The \"InnerHalfAngle\"" + ofCone + " is " + std::to_string(cone.InnerHalfAngle) +
      ": it must lie between -pi/2 and pi/2.";
  }
  else if (const char* other = FaultOf({ cone.Planarity, cone.Overspill, 0.0 }))
  {
    error = "The \"Planarity\" or \"Overspill\"" + ofCone + " " + other + ".";
  }
  else
  {
    return true;
  }
  return false;
}

} // namespace

bool ReadConeSet(vtkPolyData* input, std::vector<Cone>& cones, std::string& error)
{
  cones.clear();
  if (!input)
  {
    error = "There is no cone set.";
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = input->GetPointData();
  const auto find = [&](const char* name, int components, Need need, vtkDataArray*& array)
  { return FindArray(data, "cone set", name, components, count, need, array, error); };

  vtkDataArray *axes, *radii, *angles, *innerAngles, *normals, *occluderIds, *vectorCounts, *planarities, *overspills,
    *lightIds, *origins;
  if (!find("Axis", 3, Need::Required, axes) || !find("BaseRadius", 1, Need::Required, radii) ||
    !find("HalfAngle", 1, Need::Required, angles) || !find("InnerHalfAngle", 1, Need::Optional, innerAngles) ||
    !find("Normal", 3, Need::Optional, normals) || !find("OccluderId", 1, Need::Optional, occluderIds) ||
    !find("VectorCount", 1, Need::Optional, vectorCounts) || !find("Planarity", 1, Need::Optional, planarities) ||
    !find("Overspill", 1, Need::Optional, overspills) || !find("LightId", 1, Need::Optional, lightIds) ||
    !find("ConeOrigin", 1, Need::Optional, origins))
  {
    return false;
  }

  std::vector<int> ids, counts, lights, kinds;
  if ((occluderIds && !CopyOccluderIds(occluderIds, "cone", ids, error)) ||
    (vectorCounts && !CopyWholeNumbers(vectorCounts, "cone", NotNegative, counts, error)) ||
    (lightIds && !CopyWholeNumbers(lightIds, "cone", {}, lights, error)) ||
    (origins && !CopyWholeNumbers(origins, "cone", { 0, 2, "0 (fitted), 1 (grown) or 2 (added)" }, kinds, error)))
  {
    return false;
  }
  std::vector<Cone> read(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    Cone& cone = read[i];
    double center[3];
    input->GetPoint(i, center);
    cone.Center = { center[0], center[1], center[2] };
    if (!ReadUnitVector(axes, "cone", i, cone.Axis, error) ||
      (normals && !ReadUnitVector(normals, "cone", i, cone.Normal, error)))
    {
      return false;
    }
    cone.Normal = normals ? cone.Normal : cone.Axis;
    cone.BaseRadius = radii->GetComponent(i, 0);
    cone.HalfAngle = angles->GetComponent(i, 0);
    cone.InnerHalfAngle = innerAngles ? innerAngles->GetComponent(i, 0) : -std::abs(cone.HalfAngle);
    cone.OccluderId = occluderIds ? ids[i] : 0;
    cone.VectorCount = vectorCounts ? counts[i] : 0;
    cone.Planarity = planarities ? planarities->GetComponent(i, 0) : 0.0;
    cone.Overspill = overspills ? overspills->GetComponent(i, 0) : -1.0;
    cone.LightId = lightIds ? lights[i] : 0;
    cone.Origin = static_cast<ConeOrigin>(origins ? kinds[i] : 0);
    if (!CheckCone(cone, i, error))
    {
      return false;
    }
  }
  cones = std::move(read);
  return true;
}

void UndoCosineCorrection(vtkFieldData* parameters, std::vector<Cone>& cones)
{
  constexpr double smallestCosine = 0.05;
  vtkDataArray* correction = parameters->GetArray("CosineCorrection");
  if (!correction || correction->GetNumberOfTuples() < 1 || correction->GetComponent(0, 0) == 0.0)
  {
    return;
  }
  for (Cone& cone : cones)
  {
    cone.BaseRadius /= std::max(std::abs(Dot(cone.Axis, cone.Normal)), smallestCosine);
  }
}

void WriteConeSet(const std::vector<Cone>& cones, vtkPolyData* output)
{
  std::vector<double> centers;
  std::vector<float> axes, radii, angles, innerAngles, normals, planarities, overspills;
  std::vector<int> occluderIds, vectorCounts, lightIds, origins;
  for (const Cone& cone : cones)
  {
    for (int c = 0; c < 3; ++c)
    {
      centers.push_back(cone.Center[c]);
      axes.push_back(static_cast<float>(cone.Axis[c]));
      normals.push_back(static_cast<float>(cone.Normal[c]));
    }
    radii.push_back(static_cast<float>(cone.BaseRadius));
    angles.push_back(static_cast<float>(cone.HalfAngle));
    innerAngles.push_back(static_cast<float>(cone.InnerHalfAngle));
    occluderIds.push_back(cone.OccluderId);
    vectorCounts.push_back(cone.VectorCount);
    planarities.push_back(static_cast<float>(cone.Planarity));
    overspills.push_back(static_cast<float>(cone.Overspill));
    lightIds.push_back(cone.LightId);
    origins.push_back(static_cast<int>(cone.Origin));
  }
  SetVertices(output, centers);
  vtkPointData* data = output->GetPointData();
  AddFloatArray(data, "Axis", 3, axes);
  AddFloatArray(data, "BaseRadius", 1, radii);
  AddFloatArray(data, "HalfAngle", 1, angles);
  AddFloatArray(data, "InnerHalfAngle", 1, innerAngles);
  AddFloatArray(data, "Normal", 3, normals);
  AddIntArray(data, "OccluderId", 1, occluderIds);
  AddIntArray(data, "VectorCount", 1, vectorCounts);
  AddFloatArray(data, "Planarity", 1, planarities);
  AddFloatArray(data, "Overspill", 1, overspills);
  AddIntArray(data, "LightId", 1, lightIds);
  AddIntArray(data, "ConeOrigin", 1, origins);
}

void WriteConeSetOptions(const ConeSetOptions& options, vtkFieldData* data)
{
  AddIntArray(data, "NumberOfNeighbors", 1, { options.NumberOfNeighbors });
  AddIntArray(data, "NumberOfSectors", 1, { options.NumberOfSectors });
  AddIntArray(data, "PointsPerRing", 1, { options.PointsPerRing });
  AddIntArray(data, "MinimumVectorsPerCone", 1, { options.MinimumVectorsPerCone });
  AddDoubleArray(data, "VarianceThreshold", 1, { options.VarianceThreshold });
  AddDoubleArray(data, "PlanarityThreshold", 1, { options.PlanarityThreshold });
  AddIntArray(data, "CosineCorrection", 1, { options.CosineCorrection ? 1 : 0 });
  AddIntArray(data, "Expansion", 1, { static_cast<int>(options.Expansion) });
  AddDoubleArray(data, "ExpansionFraction", 1, { options.ExpansionFraction });
  AddDoubleArray(data, "RadiusScale", 1, { options.RadiusScale });
  AddDoubleArray(data, "MaximumOverspill", 1, { options.MaximumOverspill });
  AddIntArray(data, "Overlap", 1, { options.Overlap ? 1 : 0 });
  AddIntArray(data, "Leftovers", 1, { static_cast<int>(options.Leftovers) });
}

void WriteConeTuning(const ConeTuningResult& tuning, vtkFieldData* data)
{
  AddDoubleArray(data, "TuningObjective", 1, { tuning.Objective });
  AddDoubleArray(data, "TuningLeak", 1, { tuning.Leak });
  AddDoubleArray(data, "TuningLost", 1, { tuning.Lost });
  AddIntArray(data, "TuningFits", 1, { tuning.NumberOfFits });
}

Box ReadCertifiedBounds(vtkFieldData* data)
{
  vtkDataArray* bounds = data->GetArray("CertifiedBounds");
  const auto edge = [bounds](int i) { return bounds->GetVariantValue(i).ToDouble(); };
  if (!bounds || bounds->GetNumberOfValues() != 6 || (edge(0) == -HUGE_VAL && edge(1) == HUGE_VAL))
  {
    return {};
  }
  const Box box{ { edge(0), edge(2), edge(4) }, { edge(1), edge(3), edge(5) } };
  const bool isBox = IsFinite(box.Min) && IsFinite(box.Max) && box.Min.X <= box.Max.X && box.Min.Y <= box.Max.Y &&
    box.Min.Z <= box.Max.Z;
  const Vector3 nowhere{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
  return isBox ? box : Box{ nowhere, nowhere };
}

std::vector<Cone> ConesEverywhere(const Box& region, std::size_t lights)
{
  std::vector<Cone> cones(lights, ConeAroundBox(region));
  for (std::size_t k = 0; k < lights; ++k)
  {
    cones[k].LightId = static_cast<int>(k);
  }
  return cones;
}

std::vector<Cone> ConesFor(const Box& region, std::size_t lights, const Box& proved, const std::vector<Cone>& cones)
{
  const bool beyond =
    !proved.Empty() && !region.Empty() && !(proved.Contains(region.Min) && proved.Contains(region.Max));
  return beyond ? ConesEverywhere(region, lights) : cones;
}

ConeCertificate CertificateOf(const ConeProof& proof, const std::vector<Cone>& cones, const TriangleMeshView& mesh,
  const std::vector<Light>& lights)
{
  ConeCertificate certificate;
  certificate.Certified = proof.Certified;
  certificate.Bounds = proof.CertifiedBounds;
  certificate.NumberOfProvedParts = proof.NumberOfProvedParts;
  certificate.NumberOfGrownCones = proof.NumberOfGrownCones;
  certificate.NumberOfAddedCones = proof.NumberOfAddedCones;
  certificate.NumberOfOccludersWithoutCone = proof.NumberOfOccludersWithoutCone;
  certificate.Hash = proof.Certified ? CertificateHash(cones, mesh, lights) : 0;
  return certificate;
}

void WriteConeCertificate(const ConeCertificate& certificate, vtkFieldData* data)
{
  const Box& b = certificate.Bounds;
  const double all = std::numeric_limits<double>::infinity();
  AddIntArray(data, "Certified", 1, { certificate.Certified ? 1 : 0 });
  AddDoubleArray(data, "CertifiedBounds", 6,
    b.Empty() ? std::vector<double>{ -all, all, -all, all, -all, all }
              : std::vector<double>{ b.Min.X, b.Max.X, b.Min.Y, b.Max.Y, b.Min.Z, b.Max.Z });
  AddIdArray(data, "NumberOfProvedParts", { certificate.NumberOfProvedParts });
  AddIdArray(data, "NumberOfGrownCones", { certificate.NumberOfGrownCones });
  AddIdArray(data, "NumberOfAddedCones", { certificate.NumberOfAddedCones });
  AddIdArray(data, "NumberOfOccludersWithoutCone", { certificate.NumberOfOccludersWithoutCone });
  vtkNew<vtkTypeUInt64Array> hash;
  hash->SetName("CertificateHash");
  hash->InsertNextValue(certificate.Hash);
  data->AddArray(hash);
}

ConeCertificate ReadConeCertificate(vtkFieldData* data, const std::vector<Cone>& cones, const TriangleMeshView& mesh,
  const std::vector<Light>& lights, std::string& why)
{
  ConeCertificate certificate;
  const auto value = [data](const char* name)
  {
    vtkDataArray* array = data->GetArray(name);
    return array && array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : 0.0;
  };
  auto* hash = vtkTypeUInt64Array::SafeDownCast(data->GetAbstractArray("CertificateHash"));
  if (value("Certified") == 0.0 || !hash || hash->GetNumberOfValues() != 1)
  {
    why = "the cone set says nothing of a proof: connect mesh and lights to vtkConeSetFilter, with Certify on";
    return certificate;
  }
  certificate.Hash = CertificateHash(cones, mesh, lights);
  if (certificate.Hash != hash->GetValue(0))
  {
    why = "cones, casters or lights are not those that the cone set was proved for";
    return certificate;
  }
  certificate.Bounds = ReadCertifiedBounds(data);
  certificate.NumberOfProvedParts = WholeOf<vtkIdType>(value("NumberOfProvedParts"));
  certificate.NumberOfGrownCones = WholeOf<vtkIdType>(value("NumberOfGrownCones"));
  certificate.NumberOfAddedCones = WholeOf<vtkIdType>(value("NumberOfAddedCones"));
  certificate.NumberOfOccludersWithoutCone = WholeOf<vtkIdType>(value("NumberOfOccludersWithoutCone"));
  certificate.Certified = true;
  return certificate;
}

} // namespace shadowcones
