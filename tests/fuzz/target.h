// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

/// What hostile bytes are put before: each target takes any bytes at all. The tests try its corpus and a few thousand
/// mutations of it (fuzz_test.cpp), `./run fuzz` lets libFuzzer search for hours (libfuzzer.cpp).
namespace pcm::fuzz {

/// Thrown where bytes lead to a wrong answer; the text tells all that is needed to see it again.
class Found : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

struct Target {
  std::string_view name;  ///< of its corpus, corpus/NAME
  /// Returns where the bytes are refused as they should be, or answered rightly; else throws Found. Anything else that
  /// is thrown, or a crash, is a finding too. Keeps nothing from one call to the next.
  void (*run)(std::string_view bytes);
};

/// A surface file is refused with a message, or written and read again gives the same mesh, bit for bit.
void read_obj_file(std::string_view bytes);
/// The same, and read as OFF or not at all.
void read_off_file(std::string_view bytes);
/// A poses file is refused with a message, or each of its poses is finite and a rotation to 1e-9.
void read_poses_file(std::string_view bytes);
/// A case file is refused with a message, or written and read again gives the same question.
void read_case_file(std::string_view bytes);
/// Two small surfaces, a pose, a law: unfit, or engine and oracle agree, in everything that `pcm verify` holds.
void compare_contact(std::string_view bytes);

std::span<const Target> targets();

/// The target of that name. Throws std::invalid_argument where there is none.
const Target& target_named(std::string_view name);

}  // namespace pcm::fuzz
