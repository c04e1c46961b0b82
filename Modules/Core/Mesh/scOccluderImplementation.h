// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderImplementation.h
 * @brief What an OccluderScene holds. Internal to Core.
 */
#ifndef scOccluderImplementation_h
#define scOccluderImplementation_h

#include "scEmbreeQuery.h"
#include "scLineShadows.h"
#include "scOccluderCells.h"
#include "scOccluderScene.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace shadowcones
{

/// Embree's own memory; a limit makes it fail as if there were no more.
struct MemoryBudget
{
  std::atomic<std::int64_t> Used{ 0 };
  std::int64_t Limit = 0; ///< 0: none
};

struct OccluderScene::Implementation
{
  explicit Implementation(const TriangleMeshView& mesh);
  ~Implementation();
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void Build(OccluderCell& cell);
  /// Ask the cells on the way of the query's one ray: for the nearest hit, if @p best is given. @return is there any?
  bool Trace(EmbreeQuery& query, RayHit* best) const;
  /// Ask the one cell that there is for up to 64 rays from one point. @return bits of those that are kept from going on.
  std::uint64_t TraceFrom(const Vector3& origin, std::uint64_t wanted, EmbreeQuery& query) const;

  /// The triangles that a lamp's plane makes rays pass by.
  struct PassedBy
  {
    FlatFace Lamp;
    std::vector<unsigned char> Triangles; ///< empty: none
  };

  EmbreeQuery QueryOf(
    const Vector3& origin, const Vector3& direction, double begin, double end, const RayRules& rules) const
  {
    EmbreeQuery query(this->Mesh, rules);
    query.Origins = &origin;
    query.Directions = &direction;
    query.Begin = begin;
    query.End = end;
    return query;
  }

  const TriangleMeshView Mesh;
  const Box Bounds;
  const bool IsSinglePrecision;
  std::mutex Lock; ///< of Lamps
  std::vector<std::unique_ptr<PassedBy>> Lamps;
  OccluderCells Cells;
  MemoryBudget Memory;
  RTCDevice Device = nullptr;
  std::vector<EmbreeCell> Scenes; ///< of the cells
  std::once_flag LinesOnce;
  std::atomic<std::int64_t> LinesMemory{ 0 };
  std::unique_ptr<const LineShadows> Lines; ///< where they were asked for

private:
  void ThrowOnError() const;
  void AddGeometries(EmbreeCell& cell, const std::vector<CellPiece>& pieces);
  void AddGeometry(EmbreeCell& cell, unsigned int id, const std::vector<CellPiece>& pieces,
    const std::vector<unsigned int>& members);
  bool TraceCell(std::size_t index, EmbreeQuery& query, double first, double last, RayHit* best) const;
};

} // namespace shadowcones

#endif
