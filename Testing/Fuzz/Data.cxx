// SPDX-License-Identifier: BSD-3-Clause
// Data of strangers: built from bytes so that most of it is as it should be, and given to filters.
#include "Bytes.h"
#include "FiniteData.h"
#include "Harnesses.h"

#include "scDensityData.h"
#include "scLightData.h"
#include "scVisibilityData.h"
#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetGeometry.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"
#include "vtkSunHours.h"
#include "vtkVisibilityVolume.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <functional>
#include <string_view>

namespace fuzz
{
namespace
{

using namespace shadowcones;

/// Does an input go on to what takes long? One in so many does, chosen by all of its bytes: others that are made from it are drawn
/// anew, so that slow ones do not breed slow ones.
bool GoesOn(const std::uint8_t* raw, std::size_t count, std::size_t oneIn)
{
  const std::string_view bytes(reinterpret_cast<const char*>(raw), count);
  return GoesAllTheWay() || std::hash<std::string_view>()(bytes) % oneIn == 0;
}

/// Update, and look at every number that comes out.
void Run(vtkAlgorithm* filter, const testsupport::HandedOn& handedOn = {})
{
  vtkObject::GlobalWarningDisplayOff();
  filter->Update();
  const std::string found = testsupport::NotFiniteOf(filter, handedOn);
  Check(found.empty(), std::string(filter->GetClassName()) + ": " + found);
}

vtkSmartPointer<vtkPolyData> OutputOf(vtkAlgorithm* filter, int port = 0)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
}

vtkSmartPointer<vtkPoints> PointsOf(Bytes& bytes, int count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(bytes.OneIn(2) ? VTK_FLOAT : VTK_DOUBLE);
  for (int k = 0; k < count; ++k)
  {
    double p[3] = { bytes.Number(), bytes.Number(), bytes.Number() };
    for (double& x : p)
    {
      x = points->GetDataType() == VTK_FLOAT && std::fabs(x) > 3e38 && std::isfinite(x) ? 1e30 : x;
    }
    points->InsertNextPoint(p);
  }
  return points;
}

/// Cells that mostly use points that are there.
vtkSmartPointer<vtkCellArray> CellsOf(Bytes& bytes, int count, int points, int corners)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (bytes.OneIn(4))
  {
    cells->Use32BitStorage();
  }
  for (int k = 0; k < count; ++k)
  {
    const int shape = bytes.Byte();
    std::vector<vtkIdType> ids(static_cast<std::size_t>(shape % 8 == 7 ? shape / 32 : corners));
    for (vtkIdType& id : ids)
    {
      const int byte = bytes.Byte();
      id = byte >= 250 ? (byte - 253) * 1000 : points > 0 ? byte % points : 0;
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> MeshOf(Bytes& bytes)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  const int points = bytes.Below(24);
  const int polygons = bytes.Below(24);
  mesh->SetPoints(PointsOf(bytes, points));
  mesh->SetPolys(CellsOf(bytes, polygons, points, 3));
  vtkIdType cells = polygons;
  if (bytes.OneIn(4))
  {
    mesh->SetStrips(CellsOf(bytes, 2, points, 5));
    cells += 2;
  }
  if (bytes.OneIn(4))
  {
    mesh->SetLines(CellsOf(bytes, 2, points, 2));
    mesh->SetVerts(CellsOf(bytes, 1, points, 1));
    cells += 3;
  }
  if (bytes.OneIn(2))
  {
    AddArrays(bytes, { { "OccluderId", VTK_INT, 1, Values::Id }, { "Reflectance", VTK_FLOAT, 1, Values::Fraction },
        { "vtkGhostType", VTK_UNSIGNED_CHAR, 1, Values::Flag } }, cells, mesh->GetCellData());
    AddArrays(bytes, { { "Normals", VTK_FLOAT, 3, Values::Unit }, { "vtkGhostType", VTK_UNSIGNED_CHAR, 1, Values::Flag } },
      points, mesh->GetPointData());
    AddArrays(bytes, { { "OccluderNames", VTK_STRING, 1, Values::Any } }, 3, mesh->GetFieldData());
  }
  return mesh;
}

vtkSmartPointer<vtkAreaLightSource> MakeLamp(bool wide)
{
  auto made = vtkSmartPointer<vtkAreaLightSource>::New();
  made->SetShape(wide ? vtkAreaLightSource::Disc : vtkAreaLightSource::Point);
  made->SetCenter(0.0, 0.0, 9.0);
  made->SetNormal(0.0, 0.0, -1.0);
  made->SetNumberOfWavelengths(2);
  made->SetResolution(8);
  made->Update();
  return made;
}

/// Mostly a point, for which a sample is enough: places on a disc take a filter longer to choose than all else here together.
vtkPolyData* Lamp(Bytes& bytes)
{
  static const vtkSmartPointer<vtkAreaLightSource> lamps[2] = { MakeLamp(false), MakeLamp(true) };
  return lamps[bytes.OneIn(16) ? 1 : 0]->GetOutput();
}

/// A triangle with an id.
vtkPolyData* Sheet()
{
  static const vtkSmartPointer<vtkLabelOccluders> labels = []
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-1.0, -1.0, 1.0);
    points->InsertNextPoint(1.0, -1.0, 1.0);
    points->InsertNextPoint(0.0, 1.5, 1.0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 2 });
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    auto made = vtkSmartPointer<vtkLabelOccluders>::New();
    made->SetInputData(mesh);
    made->Update();
    return made;
  }();
  return labels->GetOutput();
}

vtkPolyData* Places()
{
  static const vtkSmartPointer<vtkPolyData> places = []
  {
    auto made = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    for (const double x : { 0.0, 0.7, 2.5 })
    {
      points->InsertNextPoint(x, 0.1, -1.0);
    }
    made->SetPoints(points);
    return made;
  }();
  return places;
}

/// An image of a pixel, or of four.
void SetSmall(Bytes& bytes, vtkScatteringImageFilter* image, int mode)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.2, -9.0, 0.5);
  camera->SetFocalPoint(0.0, 0.0, 0.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  image->SetCamera(camera);
  image->SetResolution(1, 1);
  if (bytes.OneIn(8))
  {
    image->SetResolution(2, 2);
  }
  image->SetMode(mode);
  image->SetMediumBounds(-3.0, 3.0, -3.0, 3.0, -2.0, 8.0);
  image->SetSigmaS(0.1);
  image->SetNumberOfSteps(4);
  image->SetNumberOfLightSamples(2);
  image->SetNumberOfSurfaceLightSamples(2);
  image->SetRelativeErrorGoal(0.3);
  image->SetMaximumSamples(16);
  image->SetInputData(Sheet());
  image->SetLightData(Lamp(bytes));
}

vtkSmartPointer<vtkImageData> ImageOf(Bytes& bytes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int first = bytes.Below(3) - 1;
  image->SetExtent(first, first + bytes.Below(4), 0, bytes.Below(4), 0, bytes.Below(4));
  if (bytes.OneIn(4))
  {
    image->SetOrigin(bytes.Number(), bytes.Number(), bytes.Number());
    image->SetSpacing(bytes.Number(), bytes.Number(), bytes.Number());
  }
  if (bytes.OneIn(8))
  {
    double turned[9];
    std::generate(turned, turned + 9, [&] { return bytes.Number(); });
    image->SetDirectionMatrix(turned);
  }
  return image;
}

void Light(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  vtkObject::GlobalWarningDisplayOff();
  vtkSmartPointer<vtkPolyData> lamp = MeshOf(bytes);
  if (bytes.OneIn(2))
  {
    AddArrays(bytes, LightPlans(), 1, lamp->GetFieldData());
  }
  if (bytes.OneIn(4))
  {
    lamp->SetPoints(nullptr);
    lamp->SetPolys(nullptr);
  }
  shadowcones::Light light;
  std::string error;
  std::string warning;
  if (!ReadLight(lamp, light, error, &warning))
  {
    Check(!error.empty(), "a fault of a light has a sentence");
    return;
  }
  if (!GoesOn(raw, count, 16))
  {
    return; // a probe takes a thousand times as long as reading does
  }
  bytes.Byte();
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(Places());
  probe->SetLightData(lamp);
  probe->SetMeshData(Sheet());
  probe->SetNumberOfLightSamples(4);
  probe->ComputeFluenceRateOn();
  Run(probe);
}

void Mesh(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  const int further = bytes.Below(16);
  const auto mesh = MeshOf(bytes);
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(mesh);
  labels->SetLabelBy(further % 4);
  Run(labels, { "Normals", "Reflectance" });
  if (GoesOn(raw, count, 64))
  {
    vtkNew<vtkConeSetProbe> probe;
    probe->SetInputData(Places());
    probe->SetLightData(Lamp(bytes));
    probe->SetMeshData(mesh);
    probe->SetNumberOfLightSamples(4);
    Run(probe);
  }
}

/// The same as far as cones that are proved, which takes far longer.
void Chain(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(MeshOf(bytes));
  Run(labels, { "Normals", "Reflectance" });
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputData(labels->GetOutput());
  vectors->SetLightData(Lamp(bytes));
  vectors->SetNumberOfPhotons(64);
  Run(vectors);
  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputData(OutputOf(vectors));
  cones->SetMeshData(labels->GetOutput());
  Run(cones);
}

void Vectors(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  vtkNew<vtkPolyData> vectors;
  const int number = bytes.Below(40);
  vectors->SetPoints(PointsOf(bytes, number));
  AddArrays(bytes, { { "Direction", VTK_FLOAT, 3, Values::Unit }, { "EmissionPoint", VTK_DOUBLE, 3, Values::Any },
      { "OccluderId", VTK_INT, 1, Values::Id }, { "LightId", VTK_INT, 1, Values::Flag } }, number, vectors->GetPointData());
  if (bytes.OneIn(2))
  {
    AddArrays(bytes, LightPlans(), 1, vectors->GetFieldData());
  }
  vtkNew<vtkConeSetFilter> cones;
  cones->SetInputData(vectors);
  if (bytes.OneIn(2))
  {
    vtkNew<vtkPolyData> paths;
    const int length = bytes.Below(20);
    paths->SetPoints(PointsOf(bytes, length));
    AddArrays(bytes, { { "PathState", VTK_INT, 1, Values::Flag }, { "EmissionPoint", VTK_DOUBLE, 3, Values::Any },
        { "Direction", VTK_FLOAT, 3, Values::Unit }, { "LightId", VTK_INT, 1, Values::Flag } }, length, paths->GetPointData());
    cones->SetPhotonPathData(paths);
  }
  cones->SetTuningToManual();
  cones->SetMinimumVectorsPerCone(3);
  cones->SetNumberOfNeighbors(8);
  cones->SetExpansion(bytes.Below(3));
  cones->SetOverlap(bytes.OneIn(2));
  testsupport::HandedOn handedOn; // the lights are described as they came
  for (const ArrayPlan& plan : LightPlans())
  {
    handedOn.insert(plan.Name);
  }
  Run(cones, handedOn);
}

void ConeSet(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  vtkNew<vtkPolyData> set;
  const int number = bytes.Below(12);
  set->SetPoints(PointsOf(bytes, number));
  AddArrays(bytes, { { "Axis", VTK_FLOAT, 3, Values::Unit }, { "BaseRadius", VTK_FLOAT, 1, Values::Positive },
      { "HalfAngle", VTK_FLOAT, 1, Values::Fraction }, { "InnerHalfAngle", VTK_FLOAT, 1, Values::Fraction },
      { "Normal", VTK_FLOAT, 3, Values::Unit }, { "OccluderId", VTK_INT, 1, Values::Id },
      { "VectorCount", VTK_INT, 1, Values::Id }, { "Planarity", VTK_FLOAT, 1, Values::Fraction },
      { "Overspill", VTK_FLOAT, 1, Values::Fraction }, { "LightId", VTK_INT, 1, Values::Flag },
      { "ConeOrigin", VTK_INT, 1, Values::Flag } }, number, set->GetPointData());
  AddArrays(bytes, { { "Certified", VTK_INT, 1, Values::Flag }, { "CosineCorrection", VTK_INT, 1, Values::Flag } }, 1,
    set->GetFieldData());
  const int kind = bytes.Below(3);
  if (kind == 0 || !GoesOn(raw, count, 4))
  {
    vtkNew<vtkConeSetGeometry> geometry;
    geometry->SetInputData(set);
    geometry->SetResolution(3 + bytes.Below(4));
    geometry->SetCut(bytes.Below(3));
    Run(geometry);
    return;
  }
  if (kind == 1)
  {
    vtkNew<vtkVisibilityVolume> volume;
    volume->SetDimensions(3, 3, 3);
    volume->SetBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
    volume->SetMethodToSoft();
    volume->SetNumberOfLightSamples(4);
    volume->SetInputData(set);
    volume->SetLightData(Lamp(bytes));
    Run(volume);
    return;
  }
  vtkNew<vtkConeSetProbe> probe;
  probe->SetMethod(bytes.Below(2));
  probe->SetInputData(Places());
  probe->SetConeSetData(set);
  probe->SetLightData(Lamp(bytes));
  probe->SetMeshData(Sheet());
  probe->SetNumberOfLightSamples(4);
  Run(probe);
}

void Volume(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  const auto image = ImageOf(bytes);
  AddArrays(bytes, { { "Visibility", VTK_FLOAT, 1, Values::Fraction }, { "ShadowClass", VTK_UNSIGNED_CHAR, 1, Values::Flag },
      { "Marked", VTK_UNSIGNED_CHAR, 1, Values::Flag } }, image->GetNumberOfPoints(), image->GetPointData());
  if (bytes.OneIn(2))
  {
    AddArrays(bytes, { { "BrickParts", VTK_INT, 1, Values::Flag }, { "BrickDimensions", VTK_INT, 3, Values::Positive } }, 1,
      image->GetFieldData());
    AddArrays(bytes, { { "BrickCells", VTK_ID_TYPE, 1, Values::Id }, { "BrickVisibility", VTK_FLOAT, 27, Values::Fraction },
        { "BrickLightId", VTK_INT, 1, Values::Flag } }, bytes.Below(4), image->GetFieldData());
  }
  std::vector<VisibilityGrid> grids;
  std::string error;
  std::string warning;
  vtkObject::GlobalWarningDisplayOff();
  if (!ReadVisibilityGrids(image, grids, error, warning))
  {
    Check(!error.empty(), "a fault of a volume has a sentence");
    return;
  }
  if (!GoesOn(raw, count, 8))
  {
    return;
  }
  vtkNew<vtkScatteringImageFilter> filter;
  SetSmall(bytes, filter, vtkScatteringImageFilter::Volume);
  filter->SetVisibilityVolumeData(image);
  Run(filter);
}

/// A volume that is refined where shadows end, with its arrays as numbers of double precision.
vtkImageData* RefinedVolume()
{
  static const vtkSmartPointer<vtkImageData> refined = []
  {
    static const vtkSmartPointer<vtkAreaLightSource> lamp = MakeLamp(false);
    vtkNew<vtkVisibilityVolume> volume;
    volume->SetMeshData(Sheet());
    volume->SetLightData(lamp->GetOutput());
    volume->SetMethodToExact();
    volume->SetDimensions(4, 4, 4);
    volume->SetBounds(-3.0, 3.0, -3.0, 3.0, -2.0, 4.0);
    volume->SetBrickParts(2);
    volume->SetNumberOfLightSamples(4);
    volume->Update();
    auto made = vtkSmartPointer<vtkImageData>::New();
    made->ShallowCopy(volume->GetOutput());
    for (const char* name : { "BrickParts", "BrickCells", "BrickVisibility", "BrickDimensions", "BrickPlacement" })
    {
      vtkNew<vtkDoubleArray> numbers;
      Check(made->GetFieldData()->GetArray(name) != nullptr, "the volume has bricks");
      numbers->DeepCopy(made->GetFieldData()->GetArray(name));
      numbers->SetName(name);
      made->GetFieldData()->AddArray(numbers);
    }
    return made;
  }();
  return refined;
}

/// Bricks as they are written, with some of their numbers and sizes changed.
void Bricks(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  vtkNew<vtkImageData> image;
  image->DeepCopy(RefinedVolume());
  vtkFieldData* field = image->GetFieldData();
  while (!bytes.IsEmpty())
  {
    const char* const names[] = { "BrickCells", "BrickVisibility", "BrickParts", "BrickLightId", "BrickDimensions" };
    const char* name = names[bytes.Below(5)];
    if (!field->GetArray(name))
    {
      vtkNew<vtkDoubleArray> lights;
      lights->SetName(name);
      lights->SetNumberOfComponents(bytes.OneIn(8) ? 2 : 1);
      lights->SetNumberOfTuples(bytes.OneIn(8) ? bytes.Below(20) : field->GetArray("BrickCells")->GetNumberOfTuples());
      lights->Fill(0.0);
      field->AddArray(lights);
    }
    vtkDataArray* array = field->GetArray(name);
    if (bytes.OneIn(16))
    {
      array->SetNumberOfTuples(bytes.Below(20));
    }
    if (array->GetNumberOfTuples() > 0)
    {
      array->SetComponent(bytes.Byte() % array->GetNumberOfTuples(), bytes.Byte() % array->GetNumberOfComponents(), bytes.Number());
    }
  }
  std::vector<VisibilityGrid> grids;
  std::string error;
  std::string warning;
  if (ReadVisibilityGrids(image, grids, error, warning) && GoesOn(raw, count, 16))
  {
    vtkNew<vtkScatteringImageFilter> filter;
    SetSmall(bytes, filter, vtkScatteringImageFilter::Volume);
    filter->SetVisibilityVolumeData(image);
    Run(filter);
  }
}

/// A density, and a picture in it by @p mode for one input in @p oneIn: the picture takes a thousand times as long as reading does.
void DensityBy(int mode, std::size_t oneIn, const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  const auto image = ImageOf(bytes);
  AddArrays(bytes, { { bytes.OneIn(2) ? "Density" : "Smoke", VTK_FLOAT, 1, Values::Positive } }, image->GetNumberOfPoints(),
    image->GetPointData());
  DensityGrid grid;
  std::string error;
  vtkObject::GlobalWarningDisplayOff();
  if (!ReadDensity(image, nullptr, grid, error))
  {
    Check(!error.empty(), "a fault of a density has a sentence");
    return;
  }
  if (!GoesOn(raw, count, oneIn))
  {
    return;
  }
  bytes.Byte();
  vtkNew<vtkScatteringImageFilter> filter;
  SetSmall(bytes, filter, mode);
  filter->SetDensityData(image);
  Run(filter);
  vtkDataArray* radiance = filter->GetOutput()->GetPointData()->GetArray("Radiance");
  Check(!radiance || radiance->GetNumberOfTuples() == 0 || radiance->GetRange()[0] >= 0.0, "no light is less than none");
}

void Density(const std::uint8_t* raw, std::size_t count)
{
  DensityBy(vtkScatteringImageFilter::BruteForce, 16, raw, count);
}

/// Guided looks along as many rays for a picture of one pixel as for a small one.
void Fog(const std::uint8_t* raw, std::size_t count)
{
  DensityBy(vtkScatteringImageFilter::Guided, 2, raw, count);
}

const Entry entries[] = { { "light", Light }, { "mesh", Mesh }, { "chain", Chain }, { "vectors", Vectors }, { "cone-set", ConeSet },
  { "volume", Volume }, { "bricks", Bricks }, { "density", Density }, { "fog", Fog } };

} // namespace
} // namespace fuzz
