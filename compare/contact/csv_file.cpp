// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/csv_file.h"

#include "pcm/bad_input.h"

namespace pcm::compare {

CsvFile::CsvFile(const std::string& path, const CsvRow& any_row) : path_(path), file_(path, std::ios::binary) {
  write_line(any_row.names());
}

void CsvFile::write_line(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw BadInput(path_ + " can't be written; check the path and the disk");
}

}  // namespace pcm::compare
