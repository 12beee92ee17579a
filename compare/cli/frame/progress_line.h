// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace pcm::compare {

/// A line on standard error that says what is being done, written over each time; nothing where that is no terminal.
class ProgressLine {
 public:
  ProgressLine();
  void show(const std::string& what) const;
  /// Before anything else is printed.
  void wipe() const;

 private:
  bool terminal_;
};

}  // namespace pcm::compare
