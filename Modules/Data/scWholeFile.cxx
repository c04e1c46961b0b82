// SPDX-License-Identifier: BSD-3-Clause
#include "scWholeFile.h"

#include <cstdio>
#include <fstream>

namespace shadowcones
{

bool WriteWholeFile(const std::string& path, const std::string& text)
{
  const std::string beside = path + ".part";
  std::ofstream file(beside, std::ios::binary);
  file << text;
  file.close();
  if (file && std::rename(beside.c_str(), path.c_str()) == 0)
  {
    return true;
  }
  std::remove(beside.c_str());
  return false;
}

} // namespace shadowcones
