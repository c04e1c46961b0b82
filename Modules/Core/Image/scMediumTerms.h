// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumTerms.h
 * @brief The tiles of a medium term, shared out among threads. Internal to Core.
 */
#ifndef scMediumTerms_h
#define scMediumTerms_h

#include "scLookedPixels.h"
#include "scMediumTerm.h"
#include "scParallel.h"
#include "scPrimaryHits.h"
#include "scRenderContext.h"
#include "scScatteringImage.h"
#include "scTileRange.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace shadowcones
{

/// The medium terms of the threads that make an image.
class MediumTerms
{
public:
  MediumTerms(
    const RenderContext& context, const MediumTerm::Shared& shared, const PrimaryHits& hits, ScatteringImage& image)
    : Context(context)
    , Shared(shared)
    , Hits(hits)
    , Image(image)
  {
  }

  /// Call body(term, tile) for all tiles of an extent. @return false where aborted.
  template <typename Body>
  bool ForTiles(const std::array<int, 4>& extent, const Monitor& monitor, Body&& body)
  {
    return this->ForTiles(extent, MediumTerm::BlockSide(this->Context.Options.Mode), monitor, std::forward<Body>(body));
  }
  /// The same for tiles of another side, which divides that of squares.
  template <typename Body>
  bool ForTiles(const std::array<int, 4>& extent, int side, const Monitor& monitor, Body&& body)
  {
    // A square's blocks go together: they share its unshadowed light.
    const ScatteringMode mode = this->Context.Options.Mode;
    std::vector<TileRange> blocks;
    std::vector<vtkIdType> squares;
    for (const TileRange& square : TilesOf(extent, MediumTerm::SquareSide(mode)))
    {
      squares.push_back(static_cast<vtkIdType>(blocks.size()));
      const std::vector<TileRange> inside = TilesOf({ square.I0, square.I1, square.J0, square.J1 }, side);
      blocks.insert(blocks.end(), inside.begin(), inside.end());
    }
    squares.push_back(static_cast<vtkIdType>(blocks.size()));
    return ParallelForGroups(squares, monitor,
      [&]() -> ItemBody
      {
        const std::shared_ptr<MediumTerm> term = this->AddTerm();
        return [term, &blocks, &body](vtkIdType block) { body(*term, blocks[static_cast<std::size_t>(block)]); };
      });
  }
  /// Tiles ask their neighbours from now on.
  void AskNeighbours(const LookedPixels& looked) { this->Looked = &looked; }
  void AddCounts() const
  {
    for (const auto& term : this->Terms)
    {
      this->Image.NumberOfOcclusionRays += term->NumberOfOcclusionRays();
      this->Image.NumberOfShadowLines += term->NumberOfShadowLines();
      this->Image.NumberOfThickRays += term->NumberOfThickRays();
      this->Image.MarchOpticalDepth = std::max(this->Image.MarchOpticalDepth, term->MarchOpticalDepth());
    }
  }

private:
  /// One a thread.
  std::shared_ptr<MediumTerm> AddTerm()
  {
    auto term = std::make_shared<MediumTerm>(this->Context, this->Shared, this->Hits, this->Image);
    if (this->Looked)
    {
      term->AskNeighbours(*this->Looked);
    }
    const std::lock_guard<std::mutex> lock(this->Gathering);
    this->Terms.push_back(term);
    return term;
  }

  const RenderContext& Context;
  const MediumTerm::Shared Shared;
  const PrimaryHits& Hits;
  ScatteringImage& Image;
  const LookedPixels* Looked = nullptr;
  std::mutex Gathering;
  std::vector<std::shared_ptr<MediumTerm>> Terms;
};

} // namespace shadowcones

#endif
