// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramOptions.h"

#include "vtkType.h"

#include <CLI/CLI.hpp>

#include <array>

ProgramOptions::ProgramOptions(const std::string& purpose)
  : Parser(std::make_unique<CLI::App>(purpose))
{
}

ProgramOptions::~ProgramOptions() = default;

template <typename T>
void ProgramOptions::Add(const std::string& name, T& value, const std::string& help)
{
  this->Parser->add_option(name, value, help)->capture_default_str();
}

template <typename T>
void ProgramOptions::AddPositive(const std::string& name, T& value, const std::string& help)
{
  this->Parser->add_option(name, value, help)->check(CLI::PositiveNumber)->capture_default_str();
}

template <typename T>
void ProgramOptions::AddWithin(const std::string& name, T& value, const std::string& help, int least, int most)
{
  this->Parser->add_option(name, value, help)->check(CLI::Range(least, most))->capture_default_str();
}

void ProgramOptions::AddChoice(
  const std::string& name, std::vector<std::string>& value, const std::string& help, const std::vector<std::string>& choices)
{
  this->Parser->add_option(name, value, help)->check(CLI::IsMember(choices))->capture_default_str();
}

void ProgramOptions::AddNamed(
  const std::string& name, std::vector<int>& value, const std::string& help, const std::map<std::string, int>& names)
{
  this->Parser->add_option(name, value, help)->transform(CLI::CheckedTransformer(names));
}

void ProgramOptions::AddFlag(const std::string& name, bool& value, const std::string& help)
{
  this->Parser->add_flag(name, value, help);
}

std::optional<int> ProgramOptions::Read(int argc, char* argv[])
{
  try
  {
    this->Parser->parse(argc, argv);
  }
  catch (const CLI::ParseError& end)
  {
    return this->Parser->exit(end);
  }
  return std::nullopt;
}

template void ProgramOptions::Add(const std::string&, bool&, const std::string&);
template void ProgramOptions::Add(const std::string&, int&, const std::string&);
template void ProgramOptions::Add(const std::string&, unsigned int&, const std::string&);
template void ProgramOptions::Add(const std::string&, vtkIdType&, const std::string&);
template void ProgramOptions::Add(const std::string&, double&, const std::string&);
template void ProgramOptions::Add(const std::string&, std::string&, const std::string&);
template void ProgramOptions::Add(const std::string&, std::array<double, 3>&, const std::string&);
template void ProgramOptions::Add(const std::string&, std::vector<int>&, const std::string&);
template void ProgramOptions::Add(const std::string&, std::vector<vtkIdType>&, const std::string&);
template void ProgramOptions::Add(const std::string&, std::vector<double>&, const std::string&);
template void ProgramOptions::Add(const std::string&, std::vector<std::string>&, const std::string&);
template void ProgramOptions::AddPositive(const std::string&, int&, const std::string&);
template void ProgramOptions::AddPositive(const std::string&, unsigned int&, const std::string&);
template void ProgramOptions::AddPositive(const std::string&, vtkIdType&, const std::string&);
template void ProgramOptions::AddPositive(const std::string&, double&, const std::string&);
template void ProgramOptions::AddWithin(const std::string&, int&, const std::string&, int, int);
template void ProgramOptions::AddWithin(const std::string&, std::vector<int>&, const std::string&, int, int);
