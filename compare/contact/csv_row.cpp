// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/csv_row.h"

#include <fmt/format.h>

namespace pcm::compare {

void CsvRow::add(std::string_view name, std::string_view unit, std::optional<double> value) {
  add_field(name, unit, value ? fmt::format("{}", *value) : "");
}

void CsvRow::add(const std::string& name, std::string_view unit, const std::optional<Eigen::Vector3d>& vector) {
  constexpr std::array<std::string_view, 3> kAxes = {"_x", "_y", "_z"};
  for (int i = 0; i < 3; ++i)
    add(name + std::string(kAxes[static_cast<std::size_t>(i)]), unit,
        vector ? std::optional<double>((*vector)[i]) : std::nullopt);
}

void CsvRow::add_count(std::string_view name, std::optional<std::int64_t> count) {
  add_field(name, "", count ? fmt::format("{}", *count) : "");
}

void CsvRow::add_flag(std::string_view name, std::optional<bool> flag) {
  add_field(name, "", !flag ? "" : *flag ? "1" : "0");
}

void CsvRow::add_word(std::string_view name, std::string_view word) {
  add_field(name, "", std::string(word));
}

void CsvRow::add_field(std::string_view name, std::string_view unit, const std::string& field) {
  const char* separator = names_.empty() ? "" : ",";
  names_ += unit.empty() ? fmt::format("{}{}", separator, name) : fmt::format("{}{} [{}]", separator, name, unit);
  values_ += separator + field;
}

}  // namespace pcm::compare
