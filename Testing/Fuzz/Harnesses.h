// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Harnesses.h
 * @brief What any bytes are given to: a function for each entry by which data of strangers come in.
 */
#ifndef Harnesses_h
#define Harnesses_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fuzz
{

/// Ends the process where something that was promised does not hold.
using Function = void (*)(const std::uint8_t* bytes, std::size_t count);

struct Harness
{
  const char* Name;
  Function Run;
};

void LightWords(const std::uint8_t* bytes, std::size_t count);
void CommandLine(const std::uint8_t* bytes, std::size_t count);
void FieldData(const std::uint8_t* bytes, std::size_t count);
void Light(const std::uint8_t* bytes, std::size_t count);
void Mesh(const std::uint8_t* bytes, std::size_t count);
void Vectors(const std::uint8_t* bytes, std::size_t count);
void ConeSet(const std::uint8_t* bytes, std::size_t count);
void Volume(const std::uint8_t* bytes, std::size_t count);
void Density(const std::uint8_t* bytes, std::size_t count);

inline const std::vector<Harness>& Harnesses()
{
  static const std::vector<Harness> all = { { "words", LightWords }, { "options", CommandLine },
    { "field-data", FieldData }, { "light", Light }, { "mesh", Mesh }, { "vectors", Vectors }, { "cone-set", ConeSet },
    { "volume", Volume }, { "density", Density } };
  return all;
}

} // namespace fuzz

#endif
