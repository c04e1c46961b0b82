// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCommandLine.h
 * @brief The command line as a whole: every command adds itself.
 */
#ifndef scCommandLine_h
#define scCommandLine_h

#include <memory>
#include <string>

namespace CLI
{
class App;
}

namespace shadowcones
{
/// Image.
void AddImageCommand(CLI::App& program);
/// Vectors, cones, accuracy, bench.
void AddChainCommands(CLI::App& program);
/// Probe, irradiance, fluence, shadow-of.
void AddAskCommands(CLI::App& program);
/// Widths, footprints, solids, page.
void AddShapeCommands(CLI::App& program);
/// Sun-hours.
void AddSunCommand(CLI::App& program);

/// One command of the program with its help: what it does, and three examples, a line each.
CLI::App* AddCommand(CLI::App& program, const std::string& name, const std::string& does, const std::string& examples);

/// The whole program, ready to parse; a command that is found runs.
std::unique_ptr<CLI::App> MakeProgram();

/// Is there a command of that name?
bool IsCommand(const CLI::App& program, const std::string& name);

/// The manual as man reads it.
std::string MakeManual(const CLI::App& program);
/// Completion for bash.
std::string MakeCompletion(const CLI::App& program);
} // namespace shadowcones

#endif
