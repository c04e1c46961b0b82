// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetGeometry.h"

#include "scConeData.h"
#include "scConeSurface.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scParameterRanges.h"
#include "scSentence.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
using namespace shadowcones;

/// Collects polygons that carry the arrays of their cone.
class SurfaceBuilder
{
public:
  SurfaceBuilder(vtkPolyData* coneSet, vtkPolyData* output)
    : ConeSet(coneSet)
    , Output(output)
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->ConeIds->SetName("ConeId");
    this->Output->GetCellData()->CopyAllOn();
    this->Output->GetCellData()->CopyAllocate(coneSet->GetPointData());
  }

  vtkIdType AddPoint(const Vector3& point, const Vector3& normal)
  {
    this->Normals->InsertNextTuple3(normal.X, normal.Y, normal.Z);
    return this->Points->InsertNextPoint(point.X, point.Y, point.Z);
  }

  void AddPolygon(vtkIdType cone, std::initializer_list<vtkIdType> ids)
  {
    this->AddPolygon(cone, ids.size(), ids.begin());
  }

  void AddPolygon(vtkIdType cone, std::size_t count, const vtkIdType* ids)
  {
    const vtkIdType cell = this->Polygons->InsertNextCell(static_cast<vtkIdType>(count), ids);
    this->ConeIds->InsertNextValue(cone);
    this->Output->GetCellData()->CopyData(this->ConeSet->GetPointData(), cone, cell);
  }

  /// A ring of quads along the generators.
  void AddSide(vtkIdType cone, const std::vector<ConeGenerator>& generators)
  {
    const auto count = static_cast<vtkIdType>(generators.size());
    vtkIdType first = this->Points->GetNumberOfPoints();
    for (const ConeGenerator& generator : generators)
    {
      this->AddPoint(generator.Base, generator.Normal);
      this->AddPoint(generator.End, generator.Normal);
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType next = (i + 1) % count;
      this->AddPolygon(cone, { first + 2 * i, first + 2 * next, first + 2 * next + 1, first + 2 * i + 1 });
    }
  }

  /// The base disc, facing the light.
  void AddBase(vtkIdType cone, const Vector3& normal, const std::vector<ConeGenerator>& generators)
  {
    std::vector<vtkIdType> ids;
    for (auto generator = generators.rbegin(); generator != generators.rend(); ++generator)
    {
      ids.push_back(this->AddPoint(generator->Base, normal));
    }
    this->AddPolygon(cone, ids.size(), ids.data());
  }

  void Finish()
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetPolys(this->Polygons);
    this->Output->GetPointData()->SetNormals(this->Normals);
    this->Output->GetCellData()->AddArray(this->ConeIds);
    this->Output->GetCellData()->Squeeze();
  }

private:
  vtkPolyData* ConeSet;
  vtkPolyData* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkIdTypeArray> ConeIds;
};

/// The set's own size; what a plane or box cuts may reach further. A single cone has no size but its base's.
double AutomaticLength(vtkPolyData* coneSet, const std::vector<Cone>& cones, int cut)
{
  double size = coneSet->GetLength();
  for (std::size_t i = 0; i < cones.size() && !(coneSet->GetLength() > 0.0); ++i)
  {
    size = std::max(size, 10.0 * cones[i].BaseRadius);
  }
  return (cut == vtkConeSetGeometry::CutLength ? 1.0 : 4.0) * size;
}
} // anonymous namespace

vtkStandardNewMacro(vtkConeSetGeometry);
scDefineGuardedRequests(vtkConeSetGeometry);

vtkConeSetGeometry::vtkConeSetGeometry()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkConeSetGeometry::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkConeSetGeometry::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

bool vtkConeSetGeometry::ReadCut(ConeCut& cut, std::string& error) const
{
  error = FirstOutOfRange(
    { InRange("Resolution", this->Resolution, 3, 65536), OneOf("Cut", this->Cut, { "Length", "Plane", "Box" }),
      { "Length", this->Length, this->Length >= 0.0, "0 (automatic) or above" } });
  cut.Where = static_cast<ConeCut::Kind>(this->Cut);
  cut.Length = this->Length;
  const double* n = this->PlaneNormal;
  cut.PlaneOrigin = { this->PlaneOrigin[0], this->PlaneOrigin[1], this->PlaneOrigin[2] };
  cut.PlaneNormal = Normalized({ n[0], n[1], n[2] });
  if (error.empty() && this->Cut == CutPlane && !(Dot(cut.PlaneNormal, cut.PlaneNormal) > 0.5))
  {
    error = Sentence("PlaneNormal is (", n[0], ", ", n[1], ", ", n[2], "): a plane needs a direction.");
  }
  const double* b = this->BoxBounds;
  for (int axis = 0; axis < 3 && error.empty() && this->Cut == CutBox; ++axis)
  {
    if (!(b[2 * axis] <= b[2 * axis + 1])) // infinite ones are fine
    {
      error = Sentence(
        "BoxBounds along ", "xyz"[axis], " run from ", b[2 * axis], " to ", b[2 * axis + 1], "; they must ascend.");
    }
  }
  cut.Bounds = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
  return error.empty();
}

int vtkConeSetGeometry::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  std::vector<Cone> cones;
  ConeCut cut;
  std::string error;
  if (!run.AreInputsWhole(error) || !ReadConeSet(input, cones, error) ||
    !CheckAttributes(input->GetPointData(), input->GetNumberOfPoints(), "point", error) || !this->ReadCut(cut, error))
  {
    return run.Fail(error);
  }
  cut.Length = cut.Length > 0.0 ? cut.Length : AutomaticLength(input, cones, this->Cut);

  SurfaceBuilder sides(input, vtkPolyData::GetData(outputVector, 0));
  SurfaceBuilder bases(input, vtkPolyData::GetData(outputVector, 1));
  SurfaceBuilder inner(input, vtkPolyData::GetData(outputVector, 2));
  const Monitor monitor = MonitorOf(this);
  std::vector<ConeGenerator> generators;
  const PieceRequest piece = RequestedPiece(request, outputVector);
  const vtkIdType begin = piece.Begin(static_cast<vtkIdType>(cones.size()));
  const vtkIdType end = piece.End(static_cast<vtkIdType>(cones.size()));
  for (vtkIdType i = begin; i < end; ++i)
  {
    if ((i - begin) % 1024 == 0)
    {
      monitor.Progress(static_cast<double>(i - begin) / static_cast<double>(end - begin));
      if (monitor.IsAborted())
      {
        return 1; // the outputs stay empty
      }
    }
    ConeGenerators(cones[i], cones[i].HalfAngle, this->Resolution, cut, generators);
    sides.AddSide(i, generators);
    bases.AddBase(i, -cones[i].Axis, generators);
    ConeGenerators(cones[i], cones[i].InnerHalfAngle, this->Resolution, cut, generators);
    inner.AddSide(i, generators);
  }
  sides.Finish();
  bases.Finish();
  inner.Finish();
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData::GetData(outputVector, port)->GetFieldData()->PassData(input->GetFieldData());
  }
  return 1;
}

void vtkConeSetGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const cuts[] = { "Length", "Plane", "Box" };
  os << indent << "Cut: " << (this->Cut >= 0 && this->Cut <= 2 ? cuts[this->Cut] : "invalid") << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "PlaneOrigin: " << Listed(this->PlaneOrigin, 3) << "\n";
  os << indent << "PlaneNormal: " << Listed(this->PlaneNormal, 3) << "\n";
  os << indent << "BoxBounds: " << Listed(this->BoxBounds, 6) << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
