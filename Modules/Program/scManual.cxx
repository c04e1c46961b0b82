// SPDX-License-Identifier: BSD-3-Clause
// The manual and the completion, from the options themselves.
#include "scCommandLine.h"

#include <CLI/CLI.hpp>

namespace
{
/// Text as troff takes it: no line begins with a command, and a dash is a dash.
std::string Troff(const std::string& text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool first = i == 0 || text[i - 1] == '\n';
    result += first && (text[i] == '.' || text[i] == '\'') ? "\\&" : "";
    result += text[i] == '\\' ? "\\e" : text[i] == '-' ? "\\-" : std::string(1, text[i]);
  }
  return result;
}

void AddOptions(const CLI::App& command, std::string& page)
{
  for (const CLI::Option* option : command.get_options())
  {
    const std::string kind = option->get_type_name();
    const std::string standard = option->get_default_str();
    page +=
      ".TP\n.B " + Troff(option->get_name(false, true)) + (kind.empty() ? "" : " \\fI" + Troff(kind) + "\\fR") + "\n";
    page += Troff(option->get_description()) + (standard.empty() ? "" : " (" + Troff(standard) + ")") + "\n";
  }
}

std::vector<const CLI::App*> CommandsOf(const CLI::App& program)
{
  return program.get_subcommands([](const CLI::App*) { return true; });
}
} // namespace

namespace shadowcones
{
std::string MakeManual(const CLI::App& program)
{
  std::string page =
    ".TH SHADOWCONES 1 \"\" \"shadowcones " SHADOWCONES_VERSION "\"\n.SH NAME\nshadowcones \\- light, penumbra and "
    "umbra of meshes\n.SH SYNOPSIS\n.B shadowcones\n\\fICOMMAND\\fR \\fIMESH\\fR... [\\fIOPTIONS\\fR]\n"
    ".SH DESCRIPTION\n" +
    Troff(program.get_description()) + "\n.SH COMMANDS\n";
  for (const CLI::App* command : CommandsOf(program))
  {
    page += ".SS " + Troff(command->get_name()) + "\n" + Troff(command->get_description()) + "\n";
    AddOptions(*command, page);
    page += ".PP\n.nf\n" + Troff(command->get_footer()) + "\n.fi\n";
  }
  return page + ".SH EXIT STATUS\n0 done, 1 failed, 2 command line not understood, 130 interrupted.\n";
}

std::string MakeCompletion(const CLI::App& program)
{
  std::string commands;
  std::string cases;
  for (const CLI::App* command : CommandsOf(program))
  {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    std::string options;
    for (const CLI::Option* option : command->get_options())
    {
      for (const std::string& name : option->get_lnames())
      {
        options += (options.empty() ? "--" : " --") + name;
      }
    }
    cases += "    " + command->get_name() + ") options=\"" + options + "\" ;;\n";
  }
  return "# Completion of shadowcones for bash.\n_shadowcones()\n{\n  local word=\"${COMP_WORDS[COMP_CWORD]}\" "
         "options=\"\"\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W \"" +
    commands + " --help --version\" -- \"$word\"))\n    return\n  fi\n  case \"${COMP_WORDS[1]}\" in\n" + cases +
    "  esac\n  if [ \"${word#-}\" != \"$word\" ]; then\n    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n  "
    "else\n"
    "    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\ncomplete -o filenames -F _shadowcones shadowcones\n";
}
} // namespace shadowcones
