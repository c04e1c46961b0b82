// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bytes.h
 * @brief Bytes as numbers that are worth trying, and as data of a given structure with some of it wrong.
 */
#ifndef Bytes_h
#define Bytes_h

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace fuzz
{

/// Say what does not hold, and end.
inline void Check(bool holds, const std::string& what)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken promise: %s\n", what.c_str());
    std::abort();
  }
}

/// Bytes one after the other; zeros behind their end.
class Bytes
{
public:
  Bytes(const std::uint8_t* bytes, std::size_t count)
    : Next(bytes)
    , Left(count)
  {
  }
  bool IsEmpty() const { return this->Left == 0; }
  int Byte()
  {
    if (this->Left == 0)
    {
      return 0;
    }
    --this->Left;
    return *this->Next++;
  }
  int Below(int count) { return this->Byte() % count; }
  /// True for one byte in so many.
  bool OneIn(int count) { return this->Byte() % count == count - 1; }
  /// A number: mostly a small one, now and then one that is easy to get wrong.
  double Number()
  {
    const int kind = this->Byte();
    if (kind < 224)
    {
      return (kind - 112) / 16.0;
    }
    if (kind < 232)
    {
      std::uint8_t raw[8];
      for (std::uint8_t& byte : raw)
      {
        byte = static_cast<std::uint8_t>(this->Byte());
      }
      double value = 0.0;
      std::memcpy(&value, raw, sizeof(value));
      return value;
    }
    const double awkward[] = { 0.0, -0.0, std::nan(""), HUGE_VAL, -HUGE_VAL, 1e-300, 1e300, -1e300, 3e38, 1e39, 2147483648.0,
      -2147483649.0, 1e19, 5e-324, 1e-20, 1e9, 65536.0, 1e7, 1e-7, -1.0, 255.0, 256.0, 0.5, 1e15 };
    return awkward[kind - 232];
  }

private:
  const std::uint8_t* Next;
  std::size_t Left;
};

/// What values an array usually has.
enum class Values
{
  Any,
  Positive,
  Fraction, ///< 0..1
  Unit,     ///< tuples of length 1
  Id,       ///< -1..5
  Flag      ///< 0, 1 or 2
};

/// An array as the documentation has it.
struct ArrayPlan
{
  const char* Name;
  int Type;
  int Components;
  Values Kind;
};

inline void Fill(Bytes& bytes, const ArrayPlan& plan, vtkDataArray* array)
{
  const bool strange = bytes.OneIn(8);
  std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double square = 0.0;
    for (double& value : tuple)
    {
      value = plan.Kind == Values::Id && !strange ? bytes.Byte() % 7 - 1
        : plan.Kind == Values::Flag && !strange   ? bytes.Byte() % 3
        : plan.Kind == Values::Fraction && !strange ? bytes.Byte() / 255.0
                                                    : bytes.Number();
      value = plan.Kind == Values::Positive && !strange ? std::fabs(value) + 1e-3 : value;
      square += value * value;
    }
    if (plan.Kind == Values::Unit && !strange)
    {
      const double length = std::sqrt(square);
      for (double& value : tuple)
      {
        value = length > 0.0 && std::isfinite(length) ? value / length : 0.0;
      }
      tuple.back() = length > 0.0 && std::isfinite(length) ? tuple.back() : 1.0;
    }
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      // A conversion to an integer type has to hold the number.
      const double value = tuple[static_cast<std::size_t>(c)];
      const bool whole = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
      const double low = std::max(array->GetDataTypeMin(), -9e18);
      const double high = std::min(array->GetDataTypeMax(), 9e18);
      const bool small = array->GetDataType() == VTK_DOUBLE || std::fabs(value) < 3e38 || !std::isfinite(value);
      array->SetComponent(i, c, whole ? (std::isnan(value) ? 0.0 : std::clamp(value, low, high)) : small ? value : 1e30);
    }
  }
}

/// Add the arrays of a plan, each as planned, missing, or of another type, width or length.
inline void AddArrays(Bytes& bytes, const std::vector<ArrayPlan>& plans, vtkIdType tuples, vtkFieldData* data)
{
  constexpr int types[] = { VTK_FLOAT, VTK_DOUBLE, VTK_INT, VTK_UNSIGNED_CHAR, VTK_ID_TYPE, VTK_UNSIGNED_LONG_LONG,
    VTK_SHORT, VTK_CHAR, VTK_STRING };
  for (const ArrayPlan& plan : plans)
  {
    const int fault = bytes.Byte();
    if (fault % 16 == 15)
    {
      continue;
    }
    const int type = fault % 16 == 14 ? types[bytes.Below(9)] : plan.Type;
    const int components = fault % 16 == 13 ? 1 + bytes.Below(7) : plan.Components;
    const vtkIdType count = fault % 16 == 12 ? bytes.Below(9) : tuples;
    vtkSmartPointer<vtkAbstractArray> array;
    array.TakeReference(vtkAbstractArray::CreateArray(type));
    array->SetName(plan.Name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(count);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      Fill(bytes, plan, numbers);
    }
    data->AddArray(array);
  }
}

/// The field data that describe lights.
inline const std::vector<ArrayPlan>& LightPlans()
{
  static const std::vector<ArrayPlan> plans = { { "LightShape", VTK_INT, 1, Values::Id },
    { "LightCenter", VTK_DOUBLE, 3, Values::Any }, { "LightNormal", VTK_DOUBLE, 3, Values::Unit },
    { "LightAxes", VTK_DOUBLE, 6, Values::Any }, { "LightRadius", VTK_DOUBLE, 1, Values::Positive },
    { "LightSpectrum", VTK_DOUBLE, 2, Values::Positive }, { "LightWavelengths", VTK_DOUBLE, 2, Values::Positive },
    { "LightFingerprint", VTK_UNSIGNED_LONG_LONG, 1, Values::Any } };
  return plans;
}

} // namespace fuzz

#endif
