// SPDX-License-Identifier: BSD-3-Clause
// Writes what some pixels of a room are in truth: see Truth/README.md. Run by hand, when the scene or the reference change.
#include "RoomTestScene.h"
#include "TruthImage.h"
#include "scParallel.h"
#include "scReference.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: write-truth chair|tree|blob samples > %s\n", "Testing/Reference/Truth/NAME.txt");
    return 1;
  }
  const ImageTestScene scene = RoomTestScene(argv[1]);
  const ReferenceScene slow(scene.Mesh.View());
  const int samples = std::atoi(argv[2]);
  constexpr int side = TruthImage::Side;
  constexpr int columns = side / TruthImage::Step;
  std::vector<TruthPixel> pixels(static_cast<std::size_t>(columns) * columns);
  ParallelFor(columns * columns, {},
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        const int i = TruthImage::Step * static_cast<int>(k % columns);
        const int j = TruthImage::Step * static_cast<int>(k / columns);
        const ReferenceEstimate estimate =
          ReferenceInScattering(slow, scene.Source, scene.Fog, scene.Eye, i, j, side, side, samples);
        pixels[static_cast<std::size_t>(k)] = { i, j, estimate.Mean[0], estimate.StandardError[0] };
      }
    });
  std::printf("# SPDX-License-Identifier: BSD-3-Clause\n");
  std::printf("# %s, %d x %d pixels, %d samples: i j mean standard-error\n", argv[1], side, side, samples);
  for (const TruthPixel& pixel : pixels)
  {
    std::printf("%d %d %.6g %.2g\n", pixel.I, pixel.J, pixel.Mean, pixel.Error);
  }
  return 0;
}
