// SPDX-License-Identifier: BSD-3-Clause
// The options of the benchmark programs.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/**
 * What a program is for, and where the values of its options go.
 *
 * CLI11 reads them. It takes longer to compile than most programs here, so it is compiled once, in ProgramOptions.cxx.
 */
class ProgramOptions
{
public:
  explicit ProgramOptions(const std::string& purpose);
  ~ProgramOptions();

  ProgramOptions(const ProgramOptions&) = delete;
  ProgramOptions& operator=(const ProgramOptions&) = delete;

  /**
   * A number, true or false, a text, or a list of numbers or texts. What `value` holds is the default, which the help shows.
   * T is bool, int, unsigned int, vtkIdType, double, std::string, std::array<double, 3>, or a vector of int, vtkIdType, double or std::string.
   */
  template <typename T>
  void Add(const std::string& name, T& value, const std::string& help);

  /** The same, for numbers above 0. */
  template <typename T>
  void AddPositive(const std::string& name, T& value, const std::string& help);

  /** The same, for numbers from `least` to `most`. */
  template <typename T>
  void AddWithin(const std::string& name, T& value, const std::string& help, int least, int most);

  /** A list of some of these texts. */
  void AddChoice(
    const std::string& name, std::vector<std::string>& value, const std::string& help, const std::vector<std::string>& choices);

  /** A list of numbers that have names. */
  void AddNamed(
    const std::string& name, std::vector<int>& value, const std::string& help, const std::map<std::string, int>& names);

  /** True where the option is given. */
  void AddFlag(const std::string& name, bool& value, const std::string& help);

  /** Read the command line. Empty where the program is to go on; else its exit status, after its help or a message was printed. */
  std::optional<int> Read(int argc, char* argv[]);

private:
  std::unique_ptr<CLI::App> Parser;
};
