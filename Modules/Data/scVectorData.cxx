// SPDX-License-Identifier: BSD-3-Clause
#include "scVectorData.h"

#include "scFieldArrays.h"
#include "scHandOver.h"
#include "scTuples.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace shadowcones
{
namespace
{
/// A vertex for each point, whose coordinates are handed over.
void GiveVertices(vtkPolyData* output, std::vector<double>& points)
{
  const auto coordinates = HandOver<vtkDoubleArray>(3, points);
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  vtkpoints->SetData(coordinates);
  output->SetPoints(vtkpoints);
  output->SetVerts(VerticesOf(coordinates->GetNumberOfTuples()));
}
} // namespace

ShadowVectorView ShadowVectorArrays::View() const
{
  ShadowVectorView view;
  view.Count = static_cast<vtkIdType>(this->Points.size() / 3);
  view.Points = this->Points.data();
  view.Directions = this->Directions.data();
  view.EmissionPoints = this->EmissionPoints.empty() ? nullptr : this->EmissionPoints.data();
  view.OccluderIds = this->OccluderIds.empty() ? nullptr : this->OccluderIds.data();
  view.LightIds = this->LightIds.empty() ? nullptr : this->LightIds.data();
  return view;
}

bool ReadShadowVectors(vtkPolyData* input, ShadowVectorArrays& vectors, std::string& error, bool needEmissionPoints)
{
  vectors = ShadowVectorArrays();
  if (!input)
  {
    error = "There are no shadow vectors.";
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = input->GetPointData();
  const Need emission = needEmissionPoints ? Need::Required : Need::Optional;
  vtkDataArray *directions, *emissionPoints, *occluderIds, *lightIds;
  if (!FindArray(data, "shadow-vector input", "Direction", 3, count, Need::Required, directions, error) ||
    !FindArray(data, "shadow-vector input", "EmissionPoint", 3, count, emission, emissionPoints, error) ||
    !FindArray(data, "shadow-vector input", "OccluderId", 1, count, Need::Optional, occluderIds, error) ||
    !FindArray(data, "shadow-vector input", "LightId", 1, count, Need::Optional, lightIds, error))
  {
    return false;
  }
  ShadowVectorArrays read;
  if (!CopyFinitePoints(input, "shadow vector", read.Points, error) ||
    !CopyDirections(directions, "shadow vector", read.Directions, error) ||
    (emissionPoints && !CopyTriples(emissionPoints, "shadow vector", read.EmissionPoints, error)))
  {
    return false;
  }
  if (occluderIds && !CopyOccluderIds(occluderIds, "shadow vector", read.OccluderIds, error))
  {
    return false;
  }
  if (lightIds && !CopyWholeNumbers(lightIds, "shadow vector", NotNegative, read.LightIds, error))
  {
    return false;
  }
  vectors = std::move(read);
  return true;
}

PhotonPathView PhotonPathArrays::View() const
{
  PhotonPathView view;
  view.Count = static_cast<vtkIdType>(this->Points.size() / 3);
  view.Points = this->Points.data();
  view.EmissionPoints = this->EmissionPoints.data();
  view.Directions = this->Directions.data();
  view.States = this->States.data();
  view.LightIds = this->LightIds.empty() ? nullptr : this->LightIds.data();
  return view;
}

bool ReadPhotonPaths(vtkPolyData* input, PhotonPathArrays& paths, std::string& error)
{
  paths = PhotonPathArrays();
  if (!input)
  {
    error = "There are no photon paths.";
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = input->GetPointData();
  vtkDataArray *states, *emissionPoints, *directions, *lightIds;
  if (!FindArray(data, "photon-path input", "PathState", 1, count, Need::Required, states, error) ||
    !FindArray(data, "photon-path input", "EmissionPoint", 3, count, Need::Required, emissionPoints, error) ||
    !FindArray(data, "photon-path input", "Direction", 3, count, Need::Required, directions, error) ||
    !FindArray(data, "photon-path input", "LightId", 1, count, Need::Optional, lightIds, error))
  {
    return false;
  }
  PhotonPathArrays read;
  if (!CopyFinitePoints(input, "photon path", read.Points, error) ||
    !CopyTriples(emissionPoints, "photon path", read.EmissionPoints, error) ||
    !CopyDirections(directions, "photon path", read.Directions, error) ||
    !CopyWholeNumbers(states, "photon path", { 0, 1, "0 (lit) or 1 (blocked)" }, read.States, error) ||
    (lightIds && !CopyWholeNumbers(lightIds, "photon path", NotNegative, read.LightIds, error)))
  {
    return false;
  }
  paths = std::move(read);
  return true;
}

void WriteShadowVectors(ShadowVectors& vectors, vtkPolyData* output)
{
  GiveVertices(output, vectors.Points);
  vtkPointData* data = output->GetPointData();
  GiveArray<vtkFloatArray>(data, "Direction", 3, vectors.Directions);
  GiveArray<vtkFloatArray>(data, "Normal", 3, vectors.Normals);
  GiveArray<vtkIntArray>(data, "OccluderId", 1, vectors.OccluderIds);
  GiveArray<vtkDoubleArray>(data, "EmissionPoint", 3, vectors.EmissionPoints);
  GiveArray<vtkFloatArray>(data, "PathLength", 1, vectors.PathLengths);
  GiveArray<vtkFloatArray>(data, "Thickness", 1, vectors.Thicknesses);
  GiveArray<vtkIdTypeArray>(data, "PhotonIndex", 1, vectors.PhotonIndices);
  GiveArray<vtkIntArray>(data, "LightId", 1, vectors.LightIds);
}

void WritePhotonPaths(PhotonPaths& paths, vtkPolyData* output)
{
  GiveVertices(output, paths.Points);
  vtkPointData* data = output->GetPointData();
  GiveArray<vtkIntArray>(data, "PathState", 1, paths.States);
  GiveArray<vtkIntArray>(data, "OccluderId", 1, paths.OccluderIds);
  GiveArray<vtkDoubleArray>(data, "EmissionPoint", 3, paths.EmissionPoints);
  GiveArray<vtkFloatArray>(data, "Direction", 3, paths.Directions);
  GiveArray<vtkFloatArray>(data, "Power", 1, paths.Powers);
  GiveArray<vtkIdTypeArray>(data, "PhotonIndex", 1, paths.PhotonIndices);
  GiveArray<vtkIntArray>(data, "LightId", 1, paths.LightIds);
}

void WriteShadowPhotons(ShadowPhotons& photons, vtkPolyData* output)
{
  GiveVertices(output, photons.Points);
  vtkPointData* data = output->GetPointData();
  GiveArray<vtkFloatArray>(data, "Normal", 3, photons.Normals);
  GiveArray<vtkFloatArray>(data, "Direction", 3, photons.Directions);
  GiveArray<vtkFloatArray>(data, "Power", 1, photons.Powers);
  GiveArray<vtkIntArray>(data, "OccluderId", 1, photons.OccluderIds);
  GiveArray<vtkIntArray>(data, "ReceiverId", 1, photons.ReceiverIds);
  GiveArray<vtkIdTypeArray>(data, "PhotonIndex", 1, photons.PhotonIndices);
  GiveArray<vtkIntArray>(data, "LightId", 1, photons.LightIds);
}

void WriteLabelledVectors(
  vtkPolyData* input, const std::vector<vtkIdType>& coneIds, const PieceRequest& piece, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(coneIds.size());
  const vtkIdType begin = piece.Begin(count);
  const vtkIdType end = piece.End(count);
  std::vector<double> points(static_cast<std::size_t>(3 * (end - begin)));
  vtkPointData* data = output->GetPointData();
  data->CopyAllocate(input->GetPointData(), end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    input->GetPoint(i, &points[3 * (i - begin)]);
    data->CopyData(input->GetPointData(), i, i - begin);
  }
  SetVertices(output, points);
  AddIdArray(data, "ConeId", { coneIds.begin() + begin, coneIds.begin() + end });
}

} // namespace shadowcones
