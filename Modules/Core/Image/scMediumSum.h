// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumSum.h
 * @brief The medium terms of several lights, added up. Internal to Core.
 */
#ifndef scMediumSum_h
#define scMediumSum_h

#include "scParallel.h"
#include "scPixelArray.h"
#include "scScatteringImage.h"

#include "vtkType.h"

#include <cstddef>

namespace shadowcones
{

/// Adds up the medium terms of lights, of which there is one at least.
class MediumSum
{
public:
  /// @return false where aborted.
  bool Add(const ScatteringImage& term, const Monitor& monitor);
  /// @return false where aborted.
  bool Write(const Monitor& monitor, ScatteringImage& image) const;

private:
  void WritePixel(std::size_t pixel, ScatteringImage& image) const;

  bool IsEmpty = true;
  PixelArray<double> InScattering;
  PixelArray<double> Errors; ///< of means over wavelengths; HUGE_VAL: not known
  PixelArray<int> Samples;
  vtkIdType OcclusionRays = 0;
  vtkIdType ShadowLines = 0;
  vtkIdType ThickRays = 0; ///< summed over lights
  double OpticalDepth = 0.0;
};

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
    // A square's blocks go together: they share its unshadowed light.
    const ScatteringMode mode = this->Context.Options.Mode;
    std::vector<TileRange> blocks;
    std::vector<vtkIdType> squares;
    for (const TileRange& square : TilesOf(extent, MediumTerm::SquareSide(mode)))
    {
      squares.push_back(static_cast<vtkIdType>(blocks.size()));
      const std::vector<TileRange> inside =
        TilesOf({ square.I0, square.I1, square.J0, square.J1 }, MediumTerm::BlockSide(mode));
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
    const auto term = std::make_shared<MediumTerm>(this->Context, this->Shared, this->Hits, this->Image);
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
