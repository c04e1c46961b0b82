// SPDX-License-Identifier: BSD-3-Clause
#include "scConeData.h"

#include "scFieldArrays.h"
#include "scTuples.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{
namespace
{

bool CheckCone(const Cone& cone, vtkIdType i, std::string& error)
{
  const std::string ofCone = " of cone " + std::to_string(i);
  if (!IsFinite(cone.Center))
  {
    error = "The position" + ofCone + " is not finite.";
  }
  else if (!std::isfinite(cone.BaseRadius) || cone.BaseRadius < 0.0)
  {
    error = "The \"BaseRadius\"" + ofCone + " is " + std::to_string(cone.BaseRadius) +
      ": it must be finite and not negative.";
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
  else if (!std::isfinite(cone.Planarity) || !std::isfinite(cone.Overspill))
  {
    error = "The \"Planarity\" or \"Overspill\"" + ofCone + " is not finite.";
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

  vtkDataArray *axes, *radii, *angles, *innerAngles, *normals, *occluderIds, *vectorCounts, *planarities, *overspills;
  if (!find("Axis", 3, Need::Required, axes) || !find("BaseRadius", 1, Need::Required, radii) ||
    !find("HalfAngle", 1, Need::Required, angles) || !find("InnerHalfAngle", 1, Need::Optional, innerAngles) ||
    !find("Normal", 3, Need::Optional, normals) || !find("OccluderId", 1, Need::Optional, occluderIds) ||
    !find("VectorCount", 1, Need::Optional, vectorCounts) || !find("Planarity", 1, Need::Optional, planarities) ||
    !find("Overspill", 1, Need::Optional, overspills))
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
    cone.OccluderId = occluderIds ? static_cast<int>(occluderIds->GetComponent(i, 0)) : 0;
    cone.VectorCount = vectorCounts ? static_cast<int>(vectorCounts->GetComponent(i, 0)) : 0;
    cone.Planarity = planarities ? planarities->GetComponent(i, 0) : 0.0;
    cone.Overspill = overspills ? overspills->GetComponent(i, 0) : -1.0;
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
  std::vector<int> occluderIds, vectorCounts;
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
}

void WriteConeTuning(const ConeTuningResult& tuning, vtkFieldData* data)
{
  AddDoubleArray(data, "TuningObjective", 1, { tuning.Objective });
  AddDoubleArray(data, "TuningLeak", 1, { tuning.Leak });
  AddDoubleArray(data, "TuningLost", 1, { tuning.Lost });
  AddIntArray(data, "TuningFits", 1, { tuning.NumberOfFits });
}

} // namespace shadowcones
