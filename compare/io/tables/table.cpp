// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pcm::compare {
namespace {

/// Empty where there is no value, or one that JSON has no word for.
std::string csv_field(const nlohmann::ordered_json& value) {
  assert(value.is_primitive());
  if (value.is_null() || (value.is_number_float() && !std::isfinite(value.get<double>()))) return "";
  return value.is_string() ? quoted(value.get<std::string>()) : value.dump();
}

}  // namespace

TableCell number_cell(double x, int digits) {
  if (std::isnan(x)) return empty_cell();
  if (std::isinf(x)) return {fmt::format("{}", x), x};
  const int leading = x == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::fabs(x))));
  return {fmt::format("{:.{}f}", x, std::clamp(digits - 1 - leading, 0, 12)), x};
}

TableCell count_cell(std::int64_t n) {
  return {fmt::format("{}", n), n};
}

TableCell empty_cell() {
  return {"-", nullptr};
}

std::string on_screen(const Table& table) {
  std::vector<std::size_t> widths;
  for (const Column& column : table.columns) widths.push_back(column.title.size());
  for (const std::vector<TableCell>& row : table.rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].text.size());

  std::string text;
  const auto add_line = [&](const auto& word_of) {
    std::string line;
    for (std::size_t c = 0; c < widths.size(); ++c)
      line += table.columns[c].is_number ? fmt::format("{:>{}}  ", word_of(c), widths[c])
                                         : fmt::format("{:<{}}  ", word_of(c), widths[c]);
    text += line.erase(line.find_last_not_of(' ') + 1) + '\n';
  };
  add_line([&](std::size_t c) { return table.columns[c].title; });
  for (const std::vector<TableCell>& row : table.rows) add_line([&](std::size_t c) { return row[c].text; });
  return text;
}

std::string markdown(const Table& table) {
  const auto escaped = [](const std::string& words) {
    std::string cell;
    for (const char c : words) cell += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
    return cell;
  };
  std::string text = "|", rule = "|";
  for (const Column& column : table.columns) {
    text += fmt::format(" {} |", escaped(column.title));
    rule += column.is_number ? "--:|" : "---|";
  }
  text += '\n' + rule + '\n';
  for (const std::vector<TableCell>& row : table.rows) {
    text += '|';
    for (const TableCell& cell : row) text += fmt::format(" {} |", escaped(cell.text));
    text += '\n';
  }
  return text;
}

std::string csv(const Table& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    text += fmt::format("{}{}", c == 0 ? "" : ",", table.columns[c].key);
  text += '\n';
  for (const std::vector<TableCell>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      text += fmt::format("{}{}", c == 0 ? "" : ",", csv_field(row[c].value));
    text += '\n';
  }
  return text;
}

nlohmann::ordered_json json(const Table& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::vector<TableCell>& row : table.rows) {
    nlohmann::ordered_json object;
    for (std::size_t c = 0; c < row.size(); ++c) object[table.columns[c].key] = row[c].value;
    rows.push_back(std::move(object));
  }
  return rows;
}

std::string quoted(const std::string& words) {
  std::string field = "\"";
  for (const char c : words) {
    if (c == '"') field += c;
    field += c;
  }
  field += '"';
  return field;
}

}  // namespace pcm::compare
