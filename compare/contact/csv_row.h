// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pcm::compare {

/// One row of a CSV file, filled column by column, and the names of its columns, so that both are written down in one
/// place. Doubles read back bit for bit; what is not known is an empty field.
class CsvRow {
 public:
  /// `unit` stands in brackets behind the name; none where there is none.
  void add(std::string_view name, std::string_view unit, std::optional<double> value);
  /// Three columns, name_x and so on.
  void add(const std::string& name, std::string_view unit, const std::optional<Eigen::Vector3d>& vector);
  void add_count(std::string_view name, std::optional<std::int64_t> count);
  void add_flag(std::string_view name, std::optional<bool> flag);  ///< 1 or 0
  void add_word(std::string_view name, std::string_view word);

  const std::string& names() const { return names_; }
  const std::string& values() const { return values_; }

 private:
  void add_field(std::string_view name, std::string_view unit, const std::string& field);

  std::string names_, values_;
};

}  // namespace pcm::compare
