// SPDX-License-Identifier: BSD-3-Clause
#include "scTuples.h"

#include "scOccluderNames.h"
#include "scSentence.h"

#include "vtkPolyData.h"

#include <cstdint>
#include <limits>

namespace shadowcones
{
namespace
{

/// Lengths this close to 1 are rounding, and are put right.
constexpr double UnitTolerance = 1e-3;

} // namespace

bool ReadWholeNumber(
  vtkDataArray* array, const char* item, vtkIdType i, const WholeRange& range, int& value, std::string& error)
{
  const double given = array->GetComponent(i, 0);
  if (!(given >= range.Least && given <= range.Most && given == std::floor(given)))
  {
    error = Sentence(
      "The \"", array->GetName(), "\" of ", item, " ", i, " is ", ShortestText(given), ": it must be ", range.Expected, ".");
    return false;
  }
  value = static_cast<int>(given);
  return true;
}

bool CopyWholeNumbers(
  vtkDataArray* array, const char* item, const WholeRange& range, std::vector<int>& values, std::string& error)
{
  values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  bool good = true;
  for (vtkIdType i = 0; good && i < array->GetNumberOfTuples(); ++i)
  {
    good = ReadWholeNumber(array, item, i, range, values[i], error);
  }
  return good;
}

bool CopyOccluderIds(vtkDataArray* array, const char* item, std::vector<int>& ids, std::string& error)
{
  std::vector<GivenId> given;
  if (!ReadGivenIds(array, item, given, error))
  {
    return false;
  }
  ids.resize(given.size());
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    if (given[i].Rest != 0.0 || given[i].Whole > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    {
      error = Sentence("The \"", array->GetName(), "\" of ", item, " ", i, " is ", given[i].Text(),
        ": it must be a whole number below 2^31. Number occluders from 0, as vtkLabelOccluders does.");
      return false;
    }
    ids[i] = given[i].Receiver ? -1 : static_cast<int>(given[i].Whole);
  }
  return true;
}

void CopyPoints(vtkPolyData* input, std::vector<double>& points)
{
  const vtkIdType count = input->GetNumberOfPoints();
  points.resize(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, points.data() + 3 * i);
  }
}

bool CopyFinitePoints(vtkPolyData* input, const char* item, std::vector<double>& points, std::string& error)
{
  CopyPoints(input, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (const char* fault = FaultOf(points[i]))
    {
      error = Sentence("The position of ", item, " ", i / 3, " ", fault, ".");
      return false;
    }
  }
  return true;
}

bool CopyTriples(vtkDataArray* array, const char* item, std::vector<double>& values, std::string& error)
{
  values.resize(3 * static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double value = array->GetComponent(i, c);
      if (const char* fault = FaultOf(value))
      {
        error = Sentence("The \"", array->GetName(), "\" of ", item, " ", i, " ", fault, ".");
        return false;
      }
      values[3 * i + c] = value;
    }
  }
  return true;
}

bool ReadUnitVector(vtkDataArray* array, const char* item, vtkIdType i, Vector3& vector, std::string& error)
{
  vector = { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
  const double length = Length(vector);
  if (!(std::abs(length - 1.0) <= UnitTolerance))
  {
    error = std::string("The \"") + array->GetName() + "\" of " + item + " " + std::to_string(i) +
      (std::isfinite(length) ? " has the length " + std::to_string(length) + ", not 1." : " is not finite.");
    return false;
  }
  vector = Normalized(vector);
  return true;
}

bool CopyDirections(vtkDataArray* array, const char* item, std::vector<float>& directions, std::string& error)
{
  constexpr double singlePrecision = 1e-6;
  directions.resize(3 * static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    Vector3 unit;
    if (!ReadUnitVector(array, item, i, unit, error))
    {
      return false;
    }
    const Vector3 given{ array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
    const Vector3& kept = std::abs(Length(given) - 1.0) < singlePrecision ? given : unit;
    for (int c = 0; c < 3; ++c)
    {
      directions[3 * i + c] = static_cast<float>(kept[c]);
    }
  }
  return true;
}

} // namespace shadowcones
