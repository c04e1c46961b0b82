// SPDX-License-Identifier: BSD-3-Clause
#include "sc3dsFile.h"

#include "scSentence.h"

#include <cstdint>
#include <cstring>

namespace shadowcones
{

namespace
{

// Chunks that hold meshes, from the outside in, and the two that are read.
enum ChunkId : unsigned
{
  Main = 0x4D4D,
  Scene = 0x3D3D,
  Object = 0x4000,
  Triangles = 0x4100,
  PointList = 0x4110,
  FaceList = 0x4120
};

class Reader3ds
{
public:
  Reader3ds(const std::string& bytes, Mesh3ds& mesh)
    : Bytes(bytes)
    , Mesh(mesh)
  {
  }

  bool Read()
  {
    if (this->Bytes.size() < 6 || this->Number<std::uint16_t>(0) != Main)
    {
      this->Error = "it does not begin as a .3ds file";
      return false;
    }
    return this->ReadChunks(0, this->Bytes.size(), 0);
  }
  std::string Error;

private:
  template <typename T>
  T Number(std::size_t at) const // little endian, as the format and the processor are
  {
    T value;
    std::memcpy(&value, this->Bytes.data() + at, sizeof(T));
    return value;
  }

  bool Fail(std::size_t at, const char* what)
  {
    this->Error = Sentence("at byte ", at, " ", what);
    return false;
  }

  // The chunks between two places. Each kind of holder stands in one other kind alone, so this does not nest further.
  bool ReadChunks(std::size_t at, std::size_t end, unsigned holder)
  {
    while (end - at >= 6)
    {
      const unsigned id = this->Number<std::uint16_t>(at);
      const std::size_t length = this->Number<std::uint32_t>(at + 2);
      if (length < 6 || length > end - at)
      {
        return this->Fail(at, "a part is longer than what holds it");
      }
      if (!this->ReadChunk(id, at + 6, at + length, holder))
      {
        return false;
      }
      at += length;
    }
    return true;
  }

  bool ReadChunk(unsigned id, std::size_t at, std::size_t end, unsigned holder)
  {
    if ((id == Main && holder == 0) || (id == Scene && holder == Main))
    {
      return this->ReadChunks(at, end, id);
    }
    if (id == Object && holder == Scene)
    {
      const std::size_t name = this->Bytes.find('\0', at); // its end
      return name >= end ? this->Fail(at, "the name of an object does not end") : this->ReadChunks(name + 1, end, id);
    }
    if (id == Triangles && holder == Object)
    {
      this->FirstPoint = this->Mesh.Points.size();
      this->FirstTriangle = this->Mesh.Triangles.size();
      return this->ReadChunks(at, end, id) && this->CheckTriangles(at);
    }
    if (id == PointList && holder == Triangles)
    {
      return this->ReadPoints(at, end);
    }
    return id == FaceList && holder == Triangles ? this->ReadTriangles(at, end) : true;
  }

  bool ReadPoints(std::size_t at, std::size_t end)
  {
    const std::size_t count = end - at >= 2 ? this->Number<std::uint16_t>(at) : 0;
    if (end - at < 2 + 12 * count)
    {
      return this->Fail(at, "there are fewer points than the file says");
    }
    for (at += 2; this->Mesh.Points.size() < this->FirstPoint + count; at += 12)
    {
      this->Mesh.Points.push_back({ this->Number<float>(at), this->Number<float>(at + 4), this->Number<float>(at + 8) });
    }
    return true;
  }

  bool ReadTriangles(std::size_t at, std::size_t end)
  {
    const std::size_t count = end - at >= 2 ? this->Number<std::uint16_t>(at) : 0;
    if (end - at < 2 + 8 * count)
    {
      return this->Fail(at, "there are fewer triangles than the file says");
    }
    const int first = static_cast<int>(this->FirstPoint);
    at += 2;
    for (std::size_t i = 0; i < count; ++i, at += 8)
    {
      this->Mesh.Triangles.push_back({ first + this->Number<std::uint16_t>(at), first + this->Number<std::uint16_t>(at + 2),
        first + this->Number<std::uint16_t>(at + 4) });
    }
    return true;
  }

  // Points may stand behind the triangles that use them.
  bool CheckTriangles(std::size_t at)
  {
    for (std::size_t i = this->FirstTriangle; i < this->Mesh.Triangles.size(); ++i)
    {
      for (const int point : this->Mesh.Triangles[i])
      {
        if (static_cast<std::size_t>(point) >= this->Mesh.Points.size())
        {
          return this->Fail(at, "a triangle uses a point that is not there");
        }
      }
    }
    return true;
  }

  const std::string& Bytes;
  Mesh3ds& Mesh;
  std::size_t FirstPoint = 0;
  std::size_t FirstTriangle = 0;
};

} // namespace

bool Parse3ds(const std::string& bytes, Mesh3ds& mesh, std::string& error)
{
  mesh = Mesh3ds();
  Reader3ds reader(bytes, mesh);
  const bool read = reader.Read();
  error = reader.Error;
  return read;
}

} // namespace shadowcones
