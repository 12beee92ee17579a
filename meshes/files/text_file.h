// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pcm {

/// The whole of a text file. Throws BadInput naming the file where it is missing, is a folder, can't be read or is
/// binary (holds a NUL byte).
std::string read_text_file(const std::filesystem::path& path);

/// Writes a text file, or replaces the one that is there: under a name of its own at first, so that a file of that name
/// is always whole. Throws BadInput naming the file where it can't be written.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// Removes what a program that was killed while it wrote `path` left beside it. For files that nobody else writes.
void remove_unfinished(const std::filesystem::path& path);

/// Walks through a text line by line, as blank-separated words.
///
/// Understands line feeds, carriage returns and both, a leading UTF-8 byte order mark, `#` comments to the end of the
/// line, and lines continued by a final backslash. Lines without a word are skipped. The text must outlive the object.
class TextLines {
 public:
  /// `name` says in messages where the text comes from.
  TextLines(std::string_view text, std::string name);

  /// Goes on to the next line that has words; false at the end.
  bool next();

  /// The words of the current line; valid until the next call of next().
  const std::vector<std::string_view>& words() const { return words_; }

  /// Number of the current line, from 1; of the first one where lines are continued.
  std::int64_t line() const { return line_; }

  /// Throws BadInput "name:line: what" for the current line, or for another one.
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::int64_t line, const std::string& what) const;

  /// Throws BadInput "name: what" for the text as a whole.
  [[noreturn]] void fail_as_a_whole(const std::string& what) const;

 private:
  std::string_view take_physical_line();
  void split(std::string_view line);

  std::string_view rest_;
  std::string name_;
  std::int64_t line_ = 0;
  std::int64_t next_line_ = 1;
  std::string joined_;
  std::vector<std::string_view> words_;
};

/// `word` in quotes, shortened where it is long and with unprintable bytes replaced: for messages.
std::string in_quotes(std::string_view word);

}  // namespace pcm
