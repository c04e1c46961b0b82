// SPDX-License-Identifier: BSD-3-Clause
// The command 'shadowcones'.
#include "scCommandLine.h"
#include "scFailure.h"
#include "scTerminal.h"
#include "vtkLogger.h"
#include "vtkOutputWindow.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <new>

int main(int argc, char** argv)
{
  using namespace shadowcones;
  // Messages of filters come as sentences of this program.
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  WatchInterrupt();
  const std::unique_ptr<CLI::App> program = MakeProgram();
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--manual" || first == "--completion")
  {
    std::cout << (first == "--manual" ? MakeManual(*program) : MakeCompletion(*program));
    return ExitDone;
  }
  if (!first.empty() && first[0] != '-' && !IsCommand(*program, first))
  {
    std::fprintf(stderr, "shadowcones: there is no command '%s': see shadowcones --help\n", first.c_str());
    return ExitUsage;
  }
  try
  {
    program->parse(argc, argv);
    std::cout.flush();
    if (!std::cout)
    {
      throw Failure("standard output: cannot be written; is the disk full?");
    }
    return ExitDone;
  }
  catch (const CLI::ParseError& error)
  {
    return program->exit(error) == 0 ? ExitDone : ExitUsage;
  }
  catch (const Failure& failure)
  {
    std::fprintf(stderr, "shadowcones: %s\n", failure.what());
    return failure.Code;
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(stderr, "shadowcones: out of memory; ask for less: a smaller --size, --grid or --resolution\n");
    return ExitFailed;
  }
}
