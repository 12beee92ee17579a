// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace pcm::simulate {

/// A JSON document that knows the line of every value.
class LocatedJson {
 public:
  /// Throws BadInput, naming `file` and line, where the text is no JSON or an object has a key twice.
  LocatedJson(std::string file, const std::string& text);

  const nlohmann::json& document() const { return document_; }
  /// "file:line" of the value at the pointer, e.g. "/bodies/0/mass", or of the nearest one that holds it.
  std::string place(std::string pointer) const;
  /// Throws BadInput: "file:line: bodies[0].mass: what is wrong".
  [[noreturn]] void refuse(const std::string& pointer, const std::string& what) const;

 private:
  std::string file_;
  nlohmann::json document_;
  std::map<std::string, int> lines_;  ///< by JSON pointer
};

}  // namespace pcm::simulate
