// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>

#include "compare/contact/csv_row.h"

namespace pcm::compare {

/// A CSV file that grows row by row; each row is in the file once it is written.
class CsvFile {
 public:
  /// Begins the file, or empties the one that is there, with the names of the columns. Throws BadInput where it can't
  /// be written.
  CsvFile(const std::string& path, const CsvRow& any_row);

  /// Throws BadInput where it can't be written.
  void write(const CsvRow& row) { write_line(row.values()); }

 private:
  void write_line(const std::string& line);

  std::string path_;
  std::ofstream file_;
};

}  // namespace pcm::compare
