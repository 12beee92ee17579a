// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/program.h"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "compare/io/split_at_commas.h"
#include "pcm/bad_input.h"
#include "pcm/version.h"

namespace pcm::compare {
namespace {

/// A closed standard stream would lend its number to the next file opened, and what is printed would end up there. So
/// each such number is taken by something that can't be written to: printing then fails and is reported.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    if (open("/dev/null", O_RDONLY) == -1) return;
  }
}

/// The subcommand that the command line has got to, for pointing at its help.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : full_name(*app.get_parent()) + ' ' + app.get_name();
}

/// What is wrong with the command line, and where the right one is described.
std::string describe(const CLI::ParseError& error, const CLI::App& program) {
  const CLI::App& command = innermost(program);
  const bool wants_subcommand = !command.get_subcommands([](const CLI::App*) { return true; }).empty();
  const std::vector<std::string> unexpected = command.remaining();
  std::string what = error.what();
  if (!unexpected.empty() && unexpected.front().size() > 1 && unexpected.front().front() == '-') {
    what = "unknown option '" + unexpected.front() + "'";
  } else if (!unexpected.empty()) {
    what = (wants_subcommand ? "unknown command '" : "unexpected argument '") + unexpected.front() + "'";
  } else if (wants_subcommand) {
    what = "a command is missing";
  }
  return what + "; see '" + full_name(command) + " --help'";
}

[[noreturn]] void refuse_empty_value(const std::string& option) {
  throw BadInput(option + ": the value is empty; name a value or leave the option out");
}

/// Throws BadInput naming the first option given as --name= with nothing behind it, where CLI11 would take the next
/// word for its value, another option even, or as -n=value.
void refuse_options_without_value(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    if (word.starts_with("--") && word.find('=') == word.size() - 1)
      refuse_empty_value(word.substr(0, word.size() - 1));
    if (word.size() > 2 && word[0] == '-' && word[1] != '-' && word[2] == '=')
      throw BadInput(word + ": leave out '=', which would be part of the value");
  }
}

/// Throws BadInput naming an option whose list has an empty item: CLI11 leaves it out.
void refuse_empty_items(const CLI::App& command, const std::vector<std::string>& words) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_delimiter() == '\0') continue;
    const std::string name = option->get_name();
    for (std::size_t k = 0; k < words.size(); ++k) {
      const bool with_sign = words[k].starts_with(name + "=");
      if (!with_sign && words[k] != name) continue;
      std::vector<std::string> lists;
      if (with_sign) lists.push_back(words[k].substr(name.size() + 1));
      for (std::size_t next = k + 1; next < words.size() && !words[next].starts_with('-'); ++next)
        lists.push_back(words[next]);
      for (const std::string& list : lists) {
        const std::vector<std::string> items = split_at_commas(list);
        if (items.size() > 1 && std::find(items.begin(), items.end(), "") != items.end())
          throw BadInput(name + ": '" + list + "' has an empty item; leave out the comma");
      }
    }
  }
}

/// Throws BadInput naming an option or argument whose value is empty, as that of a shell's variable that is not set: it
/// would pass for one that is not given.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_inject_separator()) continue;  // CLI11 has empty ones between groups of values
    for (const std::string& value : option->results())
      if (value.empty()) refuse_empty_value(option->get_name());
  }
}

}  // namespace

int exit_status_of(const std::function<Exit()>& work) {
  occupy_closed_streams();
  Exit status = Exit::bad_input;
  try {
    const Exit verdict = work();
    flush_output();
    status = verdict;
  } catch (const BadInput& error) {
    complain(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.path1().string() + ": " + error.code().message() + "; check the name");
  } catch (const std::system_error& error) {
    complain(error.what());
  } catch (const std::bad_alloc&) {
    complain("out of memory");
  } catch (const std::exception& error) {
    complain(std::string("a fault of this program: ") + error.what());
  }
  return static_cast<int>(status);
}

Exit run_command_line(int argc, char** argv, const std::function<void(CLI::App&, Run&)>& add_commands) {
  CLI::App program("Polygonal contact between triangulated surfaces: a fast engine held against an exact oracle.",
                   "pcm");
  program.set_version_flag("--version", "pcm " PCM_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Exit status: 0 if all is well, 1 for a negative verdict, 2 for bad input.\n"
      "Example:\n  pcm contact E.obj F.obj\n'pcm COMMAND --help' describes a command.");
  Run run;
  add_commands(program, run);

  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  refuse_options_without_value(words);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help or --version
    program.exit(request);
    return Exit::success;
  } catch (const CLI::ParseError& error) {
    complain(describe(error, program));
    return Exit::bad_input;
  }
  refuse_empty_values(innermost(program));
  refuse_empty_items(innermost(program), words);
  return run();
}

void list_command(CLI::App& program, const std::string& name, const std::string& description) {
  program.add_subcommand(name, description);
}

}  // namespace pcm::compare
