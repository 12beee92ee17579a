// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace CLI {
class App;  // seen whole only where options are defined: the library costs every file seconds
}

/// What the subcommands of the program `pcm` share. Each lives in files of its own, NAME.{h,cpp}, with one function
/// `void add_NAME_command(CLI::App& program, Run& run)` that its program (programs.h) calls: it adds the subcommand
/// with its options, a footer with an example, and a callback that only sets `run`:
///
///     void add_area_command(CLI::App& program, Run& run) {
///       auto options = std::make_shared<AreaOptions>();
///       CLI::App* command = program.add_subcommand("area", "Print a surface's area");
///       command->footer("Example:\n  pcm area box.obj");
///       command->add_option("FILE", options->file, "The surface")->required();
///       command->callback([options, &run] { run = [options] { return area(*options); }; });
///     }
///
/// The work itself starts once the whole command line is understood. It writes to std::cout, throws BadInput (status 2)
/// for whatever the user can mend, and otherwise returns its status. program.h turns errors into one line on standard
/// error; a failed write to std::cout is found at the end, or earlier by `flush_output`.
namespace pcm::compare {

/// The program's exit statuses.
enum class Exit : int {
  success = 0,
  negative = 1,   ///< a negative verdict: a disagreement, a known answer missed, an unfit surface
  bad_input = 2,  ///< the command line, a file or the place to write to
};

/// What the chosen subcommand does.
using Run = std::function<Exit()>;

/// Sends on what was written to std::cout; throws BadInput where it can't be written (a full disk, a closed pipe).
void flush_output();

/// Prints "pcm: message" as one line on standard error, whatever the message holds. Errors are thrown rather than
/// printed wherever they end the work.
void complain(std::string message);

/// The number that an option was given, e.g. "--damping". All numbers are read by `parse_number`, correctly rounded;
/// bind options to a std::string, not to a double, whose reading by CLI11 rounds twice. These throw BadInput naming the
/// option where the text is no finite number or out of the range that the function's name says.
double finite_number(const std::string& option, const std::string& text);
double positive_number(const std::string& option, const std::string& text);
double nonnegative_number(const std::string& option, const std::string& text);
/// A whole number from `least` to `most`, in decimal digits.
std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most);

}  // namespace pcm::compare
