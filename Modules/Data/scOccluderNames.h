// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderNames.h
 * @brief Occluders as numbers from 0, and the ids or names by which users know them.
 */
#ifndef scOccluderNames_h
#define scOccluderNames_h

#include "ShadowConesDataModule.h"
#include "vtkType.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFieldData;

namespace shadowcones
{

/// An id as it was given in an array of any numeric type: whole numbers of 64 bits exactly.
struct GivenId
{
  std::uint64_t Whole = 0;
  double Rest = 0.0;     ///< below 1, of ids that are not whole
  bool Receiver = false; ///< it was below 0

  bool operator<(const GivenId& b) const
  {
    return this->Whole != b.Whole ? this->Whole < b.Whole : this->Rest < b.Rest;
  }
  std::string Text() const;
};

/**
 * Read the first component of an array of ids. @return false, with a sentence in @p error that names the item, such as
 * "cell", where one is not a number.
 */
SHADOWCONESDATA_EXPORT bool ReadGivenIds(
  vtkDataArray* array, const char* item, std::vector<GivenId>& ids, std::string& error);

/// Gives occluders their numbers, from 0 in the order in which they are met, and keeps their names.
class SHADOWCONESDATA_EXPORT OccluderNumbers
{
public:
  /// The number of the occluder of that key, new with that name where it was not met before.
  int Of(const std::string& key, const std::string& name);
  std::vector<std::string> Names;

private:
  std::map<std::string, int> Numbers;
};

/// The strings of field array "OccluderNames", by id; none where there is no such array.
SHADOWCONESDATA_EXPORT std::vector<std::string> ReadOccluderNames(vtkFieldData* data);
/// Add "OccluderNames"; where there are none, take the array of another data set away that rode along.
SHADOWCONESDATA_EXPORT void WriteOccluderNames(const std::vector<std::string>& names, vtkFieldData* data);

} // namespace shadowcones

#endif
