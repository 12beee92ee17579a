// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pcm::compare {

/// One entry of a table, as people read it and as programs do.
struct TableCell {
  TableCell(std::string words) : text(std::move(words)), value(text) {}
  TableCell(const char* words) : TableCell(std::string(words)) {}
  TableCell(std::string words, nlohmann::ordered_json exact) : text(std::move(words)), value(std::move(exact)) {}

  std::string text;
  nlohmann::ordered_json value;  ///< a scalar; null where there is none
};

struct Column {
  std::string title;  ///< for people
  std::string key;    ///< for programs
  bool is_number = true;
};

/// The same rows for a screen, in Markdown, CSV and JSON. Every row has as many cells as there are columns.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<TableCell>> rows;
};

/// A number with so many significant digits, never in powers of ten; its full value for programs. Of infinity the word,
/// of NaN the empty cell.
TableCell number_cell(double x, int digits);
TableCell count_cell(std::int64_t n);
/// What has no value: "-".
TableCell empty_cell();

/// Columns padded with blanks, numbers to the right.
std::string on_screen(const Table& table);
std::string markdown(const Table& table);
/// With a line of keys at the top. What has no value and what is not finite are empty fields.
std::string csv(const Table& table);
/// An array with one object a row.
nlohmann::ordered_json json(const Table& table);

/// Words as one field of a CSV file.
std::string quoted(const std::string& words);

}  // namespace pcm::compare
