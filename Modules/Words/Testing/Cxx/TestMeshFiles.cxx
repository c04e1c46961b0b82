// SPDX-License-Identifier: BSD-3-Clause
// Files of meshes: every format gives the same mesh, names become occluders, and broken files are errors.
#include "vtkMeshFiles.h"

#include "Messages.h"
#include "vtkLabelOccluders.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMassProperties.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

vtkSmartPointer<vtkPolyData> Ball()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(sphere->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

template <typename Number>
void Append(std::string& bytes, Number value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string Chunk(std::uint16_t id, const std::string& inside)
{
  std::string bytes;
  Append(bytes, id);
  Append(bytes, static_cast<std::uint32_t>(inside.size() + 6));
  return bytes + inside;
}

std::string As3ds(vtkPolyData* mesh)
{
  std::string points;
  Append(points, static_cast<std::uint16_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Append(points, static_cast<float>(mesh->GetPoint(i)[axis]));
    }
  }
  std::string faces;
  Append(faces, static_cast<std::uint16_t>(mesh->GetNumberOfPolys()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      Append(faces, static_cast<std::uint16_t>(mesh->GetCell(i)->GetPointId(corner)));
    }
    Append(faces, std::uint16_t(0));
  }
  const std::string object = std::string("ball") + '\0' + Chunk(0x4100, Chunk(0x4110, points) + Chunk(0x4120, faces));
  return Chunk(0x4D4D, Chunk(0x0002, std::string(4, '\3')) + Chunk(0x3D3D, Chunk(0x4000, object)));
}

// A tetrahedron of glTF with its buffer beside it in the one file (glb).
std::string AsGlb()
{
  std::string buffer;
  for (const float value : { 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f })
  {
    Append(buffer, value);
  }
  for (const int index : { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 })
  {
    Append(buffer, static_cast<std::uint16_t>(index));
  }
  std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                     R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
                     R"("buffers":[{"byteLength":72}],"bufferViews":[{"buffer":0,"byteLength":48},)"
                     R"({"buffer":0,"byteOffset":48,"byteLength":24}],"accessors":[{"bufferView":0,)"
                     R"("componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
                     R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
  json.append((4 - json.size() % 4) % 4, ' ');
  std::string bytes = "glTF";
  Append(bytes, std::uint32_t(2));
  Append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  Append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  Append(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

class MeshFiles : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = fs::current_path() / "TestMeshFiles" /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }

  template <typename Writer>
  std::string Write(const std::string& name, vtkDataObject* data)
  {
    vtkNew<Writer> writer;
    writer->SetInputDataObject(data);
    writer->SetFileName(this->Path(name).c_str());
    writer->Write();
    return this->Path(name);
  }
  std::string WriteBytes(const std::string& name, const std::string& bytes)
  {
    std::ofstream(this->Path(name), std::ios::binary) << bytes;
    return this->Path(name);
  }
  static std::string Bytes(const std::string& path)
  {
    std::ifstream file(path, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  }
  // The ball in every format but glb.
  std::vector<std::string> AllFormats()
  {
    auto ball = Ball();
    vtkNew<vtkAppendFilter> append;
    append->AddInputData(ball);
    append->Update();
    return { this->Write<vtkXMLPolyDataWriter>("a.vtp", ball), this->Write<vtkPolyDataWriter>("a.vtk", ball),
      this->Write<vtkXMLUnstructuredGridWriter>("a.vtu", append->GetOutput()),
      this->Write<vtkPLYWriter>("a.ply", ball), this->Write<vtkSTLWriter>("a.STL", ball),
      this->Write<vtkOBJWriter>("a.obj", ball), this->WriteBytes("a.3ds", As3ds(ball)) };
  }
  static std::string ErrorOf(const std::string& path)
  {
    vtkNew<vtkMeshFiles> files;
    files->AddFileName(path);
    EXPECT_FALSE(files->Read()) << path;
    EXPECT_EQ(files->GetOutput()->GetNumberOfBlocks(), 0u);
    EXPECT_EQ(files->GetMesh(0), nullptr);
    return files->GetError();
  }

  fs::path Folder;
};

double VolumeOf(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(mesh);
  return properties->GetVolume();
}

std::string Names(vtkLabelOccluders* occluders)
{
  occluders->Update();
  auto* names = vtkStringArray::SafeDownCast(occluders->GetOutput()->GetFieldData()->GetAbstractArray("OccluderNames"));
  std::string text;
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    text += (i > 0 ? "|" : "") + names->GetValue(i);
  }
  return text;
}

} // namespace

TEST_F(MeshFiles, EveryFormatGivesTheSameMesh)
{
  auto ball = Ball();
  vtkNew<vtkMeshFiles> files;
  for (const std::string& path : this->AllFormats())
  {
    files->AddFileName(path);
  }
  ASSERT_TRUE(files->Read()) << files->GetError();
  ASSERT_EQ(files->GetOutput()->GetNumberOfBlocks(), 7u);
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_EQ(files->GetMesh(i)->GetNumberOfPolys(), ball->GetNumberOfPolys()) << files->GetFileName(i);
    EXPECT_NEAR(VolumeOf(files->GetMesh(i)), VolumeOf(ball), 1e-5) << files->GetFileName(i);
  }
  EXPECT_EQ(files->GetName(0), "a");
  EXPECT_EQ(files->GetName(6), "a 7");
}

TEST_F(MeshFiles, Gltf)
{
  vtkNew<vtkMeshFiles> files;
  files->AddFileName(this->WriteBytes("part.glb", AsGlb()));
  ASSERT_TRUE(files->Read()) << files->GetError();
  EXPECT_EQ(files->GetMesh(0)->GetNumberOfPolys(), 4);
  EXPECT_NEAR(VolumeOf(files->GetMesh(0)), 1.0 / 6.0, 1e-6);
}

TEST_F(MeshFiles, OccludersByFileAndComponent)
{
  auto ball = Ball();
  vtkNew<vtkMeshFiles> files;
  files->AddFileName(this->Write<vtkSTLWriter>("chair.stl", ball));
  files->AddFileName(this->Write<vtkSTLWriter>("table.stl", ball));
  ASSERT_TRUE(files->Read()) << files->GetError();
  vtkNew<vtkLabelOccluders> occluders;
  files->LabelOccluders(occluders);
  EXPECT_EQ(Names(occluders), "chair|table");
  files->RemoveAllFileNames();
  files->AddFileName(this->Path("chair.stl"));
  ASSERT_TRUE(files->Read());
  files->LabelOccluders(occluders);
  EXPECT_EQ(Names(occluders), "0");
  files->SetOccludersByToFile();
  files->LabelOccluders(occluders);
  EXPECT_EQ(Names(occluders), "chair");
}

TEST_F(MeshFiles, FaultsAreSentences)
{
  EXPECT_SAYS(ErrorOf(this->Path("none.stl")), "There is no file \"");
  EXPECT_SAYS(ErrorOf(this->WriteBytes("mesh.xyz", "1")), "is of no format that is read. Known are vtp, vtk, vtu, ply");
  EXPECT_SAYS(ErrorOf(this->WriteBytes("empty.obj", "")), "empty.obj\" is empty.");
  EXPECT_SAYS(ErrorOf(this->WriteBytes("words.ply", "this is no mesh\n")), "words.ply\" cannot be read as ply: ");
  EXPECT_SAYS(ErrorOf(this->WriteBytes("points.obj", "v 0 0 0\nv 1 0 0\n")), "points.obj\" has no polygons");
  EXPECT_SAYS(ErrorOf(this->WriteBytes("a.3ds", "this is no mesh")), "cannot be read as 3ds: it does not begin as a .3ds file.");
  fs::create_directory(this->Path("folder.stl"));
  EXPECT_SAYS(ErrorOf(this->Path("folder.stl")), "is no file that can be read: is it a folder?");
  vtkNew<vtkMeshFiles> none;
  EXPECT_FALSE(none->Read());
  EXPECT_SAYS(none->GetError(), "There is no mesh file to read.");
}

TEST_F(MeshFiles, PolygonsOfTwoCornersAreLeftOut)
{
  const std::string path = this->WriteBytes("stumps.vtk",
    "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nPOLYGONS 4 13\n3 0 1 2\n2 0 1\n"
    "1 3\n3 0 2 3\nCELL_DATA 4\nSCALARS part int 1\nLOOKUP_TABLE default\n10 11 12 13\n");
  vtkNew<vtkMeshFiles> files;
  files->AddFileName(path);
  ASSERT_TRUE(files->Read()) << files->GetError();
  vtkPolyData* mesh = files->GetMesh(0);
  ASSERT_EQ(mesh->GetNumberOfCells(), 2);
  EXPECT_EQ(mesh->GetCell(1)->GetPointId(2), 3);
  EXPECT_EQ(mesh->GetCellData()->GetArray("part")->GetTuple1(1), 13.0);
}

// What crashes VTK's readers: files cut short, bytes changed. Whatever comes of it, this program goes on, and each triangle
// that is read has its points.
TEST_F(MeshFiles, BrokenFilesDoNotCrash)
{
  std::vector<std::string> paths = this->AllFormats();
  paths.push_back(this->WriteBytes("a.glb", AsGlb()));
  std::mt19937_64 random(3);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int refused = 0;
  for (const std::string& path : paths)
  {
    const std::string whole = Bytes(path);
    for (int i = 0; i < 8; ++i)
    {
      std::string bytes = i < 3 ? whole.substr(0, below(whole.size())) : whole;
      for (int change = 0; i >= 3 && change < (i < 6 ? 1 : 8); ++change)
      {
        bytes[below(i < 5 ? std::min<std::size_t>(whole.size(), 400) : whole.size())] = "9-\xFF\0 "[below(5)];
      }
      vtkNew<vtkMeshFiles> files;
      files->AddFileName(this->WriteBytes("broken" + fs::path(path).extension().string(), bytes));
      if (!files->Read())
      {
        ++refused;
        const std::string error = files->GetError();
        EXPECT_FALSE(error.empty());
        EXPECT_TRUE(std::all_of(error.begin(), error.end(), [](char c) { return c >= 0x20 && c <= 0x7E; })) << error;
        continue;
      }
      vtkPolyData* mesh = files->GetMesh(0);
      EXPECT_GT(mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips(), 0);
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
      {
        for (vtkIdType k = 0; k < mesh->GetCell(cell)->GetNumberOfPoints(); ++k)
        {
          EXPECT_LT(mesh->GetCell(cell)->GetPointId(k), mesh->GetNumberOfPoints());
        }
      }
    }
  }
  EXPECT_GT(refused, 20);
}
