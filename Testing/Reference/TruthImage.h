// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TruthImage.h
 * @brief Pixels of the reference that took too long to compute them in a test: see Truth/README.md.
 */
#ifndef TruthImage_h
#define TruthImage_h

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace shadowcones
{

struct TruthPixel
{
  int I = 0;
  int J = 0;
  double Mean = 0.0;
  double Error = 0.0; ///< standard error
};

struct TruthImage
{
  static constexpr int Side = 48; ///< of the whole image
  static constexpr int Step = 2;  ///< every so many pixels along both axes
  std::vector<TruthPixel> Pixels; ///< empty where the file cannot be read

  explicit TruthImage(const std::string& path)
  {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line))
    {
      TruthPixel pixel;
      std::istringstream text(line);
      if (text >> pixel.I >> pixel.J >> pixel.Mean >> pixel.Error)
      {
        this->Pixels.push_back(pixel);
      }
    }
  }
};

} // namespace shadowcones

#endif
