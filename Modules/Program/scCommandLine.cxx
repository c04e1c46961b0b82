// SPDX-License-Identifier: BSD-3-Clause
#include "scCommandLine.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace shadowcones
{
CLI::App* AddCommand(CLI::App& program, const std::string& name, const std::string& does, const std::string& examples)
{
  CLI::App* command = program.add_subcommand(name, does);
  command->footer("Examples:\n" + examples);
  return command;
}

std::unique_ptr<CLI::App> MakeProgram()
{
  auto program = std::make_unique<CLI::App>(
    "Which part of space is lit, in penumbra or in umbra, whose shadow is it, and what does it look like?",
    "shadowcones");
  program->set_version_flag("--version", "shadowcones " SHADOWCONES_VERSION);
  program->require_subcommand(1);
  program->failure_message(CLI::FailureMessage::simple);
  program->footer("Examples:\n"
                  "  shadowcones image chair.stl -o shafts.png\n"
                  "  shadowcones probe house.obj --light 'sun: azimuth 135 altitude 40' --at 3,0,1\n"
                  "  shadowcones sun-hours block.glb --latitude 52.5 --longitude 13.4 --start 2026-06-21 --end "
                  "2026-06-22 --ground auto\n"
                  "Exit codes: 0 done, 1 failed, 2 command line not understood, 130 interrupted.\n"
                  "shadowcones COMMAND --help tells more.");
  AddImageCommand(*program);
  AddAskCommands(*program);
  AddShapeCommands(*program);
  AddSunCommand(*program);
  AddChainCommands(*program);
  return program;
}

bool IsCommand(const CLI::App& program, const std::string& name)
{
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(), [&](const CLI::App* one) { return one->get_name() == name; });
}
} // namespace shadowcones
