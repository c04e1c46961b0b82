// SPDX-License-Identifier: BSD-3-Clause
// Images and volumes of meshes in blocks: one answer, with names and a fingerprint, and a word where inputs do not match.
#include "ImageTesting.h"

#include "scFingerprints.h"
#include "scOccluderNames.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

using namespace imagetesting;

namespace
{

/// The plate and the floor of PlateAndFloor() as two blocks, the plate with a reflectance of its own.
vtkSmartPointer<vtkMultiBlockDataSet> Blocks()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto cover = TiltedPlate();
  shadowcones::AddDoubleArray(cover->GetCellData(), "Reflectance", 1, { 0.5 });
  blocks->SetBlock(0, cover);
  blocks->SetBlock(1, Floor());
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "plate");
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "floor");
  return blocks;
}

vtkSmartPointer<vtkAreaLightSource> Lamp()
{
  auto lamp = vtkSmartPointer<vtkAreaLightSource>::New();
  SetLamp(lamp);
  return lamp;
}

} // namespace

TEST(MeshBlocks, OneImageOfAllBlocks)
{
  vtkNew<vtkScatteringImageFilter> filter;
  filter->SetLightConnection(Lamp()->GetOutputPort());
  filter->SetResolution(8, 8);
  filter->SetReflectance(0.5);
  filter->SetInputData(PlateAndFloor());
  filter->Update();
  vtkNew<vtkImageData> joined;
  joined->DeepCopy(filter->GetOutput());
  filter->SetInputDataObject(0, Blocks());
  filter->Update();
  vtkImageData* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(image, nullptr);
  for (const char* name : arrays)
  {
    vtkDataArray* a = joined->GetPointData()->GetArray(name);
    vtkDataArray* b = image->GetPointData()->GetArray(name);
    ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
    EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())),
      0)
      << name;
  }
  EXPECT_EQ(shadowcones::ReadOccluderNames(image->GetFieldData()), (std::vector<std::string>{ "plate", "floor" }));
  EXPECT_EQ(shadowcones::ReadFingerprints("CastersFingerprint", image->GetFieldData()),
    shadowcones::ReadFingerprints("CastersFingerprint", joined->GetFieldData()));

  // The floor, which the camera sees, has no array: it reflects what the filter says.
  vtkDataArray* surfaces = image->GetPointData()->GetArray("SurfaceRadiance");
  EXPECT_GT(surfaces->GetRange(0)[1], 0.0);
  filter->SetReflectance(0.0);
  filter->Update();
  surfaces = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetArray("SurfaceRadiance");
  EXPECT_EQ(surfaces->GetRange(0)[1], 0.0);
}

TEST(MeshBlocks, VolumesAndImagesNoticeAnotherMesh)
{
  vtkNew<vtkVisibilityVolume> volume;
  volume->SetInputData(BoundingCone());
  volume->SetLightConnection(Lamp()->GetOutputPort());
  volume->SetMeshData(Blocks());
  volume->SetDimensions(5, 5, 5);
  EXPECT_EQ(WarningsOf(volume), "");
  vtkNew<vtkImageData> filled;
  filled->DeepCopy(volume->GetOutput());
  EXPECT_EQ(shadowcones::ReadOccluderNames(filled->GetFieldData()), (std::vector<std::string>{ "plate", "floor" }));

  vtkNew<vtkScatteringImageFilter> image;
  image->SetLightConnection(Lamp()->GetOutputPort());
  image->SetVisibilityVolumeData(filled);
  image->SetModeToVolume();
  image->SetResolution(2, 2);
  image->SetInputData(PlateAndFloor());
  EXPECT_EQ(WarningsOf(image), "") << "the same triangles in one piece";
  image->SetInputData(Disc());
  const std::string part =
    "The visibility volume on input port 3 was made from other casters than those of the mesh on "
    "input port 0";
  EXPECT_NE(WarningsOf(image).find(part), std::string::npos);

  const auto cones = BoundingCone();
  shadowcones::WriteFingerprints("CastersFingerprint", { 5 }, cones->GetFieldData());
  volume->SetInputData(cones);
  EXPECT_NE(WarningsOf(volume).find("The cone set on input port 0 was made from other casters"), std::string::npos);
  image->SetModeToGuided();
  image->SetConeSetData(cones);
  EXPECT_NE(WarningsOf(image).find("The cone set on input port 2 was made from other casters"), std::string::npos);
}
