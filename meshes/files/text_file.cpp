// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/files/text_file.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <system_error>
#include <utility>

#include "pcm/bad_input.h"

namespace pcm {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

constexpr std::string_view kUnfinished = ".part";

/// A name beside `path` that nothing else uses.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  std::random_device random;
  std::filesystem::path name = path;
  name += std::string(kUnfinished) + std::to_string(random());
  return name;
}

/// Whether `name` is one that temporary_name gives to the file `of`.
bool is_temporary_name(std::string_view name, const std::string& of) {
  const std::string begin = of + std::string(kUnfinished);
  return name.starts_with(begin) && name.size() > begin.size() &&
         name.find_first_not_of("0123456789", begin.size()) == std::string_view::npos;
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw BadInput(name + ": no such file; check the path");
  if (std::filesystem::is_directory(status)) throw BadInput(name + ": this is a folder; name a file in it");

  std::ifstream file(path, std::ios::binary);
  if (!file) throw BadInput(name + ": the file can't be opened; check its permissions");
  std::string text;
  if (std::filesystem::is_regular_file(status)) {  // A pipe or a device has no size.
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error) text.reserve(size);
  }
  // A device may be endless, so every piece is looked at before the next is read.
  std::vector<char> piece(std::size_t{1} << 16);
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const std::string_view characters(piece.data(), static_cast<std::size_t>(file.gcount()));
    if (characters.find('\0') != std::string_view::npos)
      throw BadInput(name + ": this is a binary file (it holds NUL bytes); a text file is needed");
    text += characters;
  }
  if (file.bad()) throw BadInput(name + ": reading the file failed; check the disk");
  return text;
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw BadInput(name + ": this is a folder or a device; name a file");
  const std::filesystem::path temporary = temporary_name(path);
  std::ofstream file(temporary, std::ios::binary);
  if (!file)
    throw BadInput(name + ": the file can't be created; check that its folder exists and that you may write to it");
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  bool written = !file.fail();
  if (written) {
    std::filesystem::rename(temporary, path, error);
    written = !error;
  }
  if (!written) {
    std::filesystem::remove(temporary, error);
    throw BadInput(name + ": writing the file failed; check the space on the disk and your permissions");
  }
}

void remove_unfinished(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::error_code error;
  std::vector<std::filesystem::path> unfinished;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_temporary_name(entry->path().filename().string(), name)) unfinished.push_back(entry->path());
  for (const std::filesystem::path& file : unfinished) std::filesystem::remove(file, error);
}

TextLines::TextLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TextLines::next() {
  words_.clear();
  while (words_.empty() && !rest_.empty()) {
    line_ = next_line_;
    std::string_view line = take_physical_line();
    if (!line.ends_with('\\')) {
      split(line);
      continue;
    }
    joined_.clear();
    while (line.ends_with('\\')) {
      line.remove_suffix(1);
      joined_.append(line).push_back(' ');
      line = rest_.empty() ? std::string_view() : take_physical_line();
    }
    joined_.append(line);
    split(joined_);
  }
  return !words_.empty();
}

std::string_view TextLines::take_physical_line() {
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
  std::string_view line = rest_.substr(0, end);
  const std::size_t ending = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
  rest_ = rest_.substr(std::min(end + ending, rest_.size()));
  ++next_line_;
  line = line.substr(0, line.find('#'));
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

void TextLines::split(std::string_view line) {
  std::size_t i = 0;
  while (i < line.size()) {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    const std::size_t start = i;
    while (i < line.size() && !is_blank(line[i])) ++i;
    words_.push_back(line.substr(start, i - start));
  }
}

void TextLines::fail_at(std::int64_t line, const std::string& what) const {
  throw BadInput(name_ + ":" + std::to_string(line) + ": " + what);
}

void TextLines::fail_as_a_whole(const std::string& what) const {
  throw BadInput(name_ + ": " + what);
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kLongest)) text.push_back(c >= ' ' && c <= '~' ? c : '?');
  return text + (word.size() > kLongest ? "...'" : "'");
}

}  // namespace pcm
