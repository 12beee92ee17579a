// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/poses_file.h"

#include <Eigen/LU>
#include <array>

#include "fast/base/geometry.h"
#include "meshes/files/parse_number.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr std::size_t kPoseNumbers = 12;   // A by rows, r
constexpr std::size_t kStateNumbers = 18;  // the same, then v and w
constexpr double kRotationTolerance = 1e-9;
constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestLine = 1 << 20;  // Eighteen doubles with all their digits take 20,000 characters.

std::optional<std::string_view> take_word(std::string_view& rest) {
  const std::size_t start = rest.find_first_not_of(kBlanks);
  if (start == std::string_view::npos) return std::nullopt;
  rest.remove_prefix(start);
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

}  // namespace

bool is_rotation(const Eigen::Matrix3d& A) {
  return fast::orthogonality_error(A) <= kRotationTolerance && A.determinant() > 0;
}

std::optional<State> parse_state(std::string_view line) {
  std::string_view rest = line.substr(0, line.find('#'));
  std::array<double, kStateNumbers> numbers{};
  std::size_t count = 0;
  while (const std::optional<std::string_view> word = take_word(rest)) {
    const std::optional<double> number = parse_number(*word);
    if (!number) throw BadInput(in_quotes(*word) + " is not a finite number; write it as 0.1 or 0x1.8p-3");
    if (count < kStateNumbers) numbers[count] = *number;
    ++count;
  }
  if (count == 0) return std::nullopt;
  if (count != kPoseNumbers && count != kStateNumbers)
    throw BadInput(std::to_string(count) +
                   " numbers; a pose has 12 (the rotation A by rows, then r) or 18 (then v, w)");

  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  State state;
  state.pose.A = Eigen::Map<const RowMajor>(numbers.data());
  state.pose.r = Eigen::Map<const Eigen::Vector3d>(numbers.data() + 9);
  state.velocity.v = Eigen::Map<const Eigen::Vector3d>(numbers.data() + 12);
  state.velocity.w = Eigen::Map<const Eigen::Vector3d>(numbers.data() + 15);
  if (!is_rotation(state.pose.A))
    throw BadInput("the first nine numbers are not a rotation to 1e-9; give its rows with all their digits");
  return state;
}

PosesFile::PosesFile(const std::filesystem::path& path) : name_(path.string()) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw BadInput(name_ + ": no such file; check the path");
  if (std::filesystem::is_directory(status)) throw BadInput(name_ + ": this is a folder; name a poses file in it");
  file_.open(path);
  if (!file_) throw BadInput(name_ + ": the file can't be opened; check its permissions");
}

std::optional<State> PosesFile::next() {
  while (next_line()) {
    try {
      if (const std::optional<State> state = parse_state(text_)) {
        empty_ = false;
        return state;
      }
    } catch (const BadInput& error) {
      throw BadInput(place() + ": " + error.what());
    }
  }
  if (file_.bad()) throw BadInput(name_ + ": reading the file failed; check the disk");
  if (empty_) throw BadInput(name_ + ": the file holds no pose; give one a line");
  return std::nullopt;
}

bool PosesFile::next_line() {
  text_.clear();
  char c = 0;
  if (!file_.get(c)) return false;
  ++line_;
  bool in_comment = false;
  for (; file_ && c != '\n' && c != '\r'; file_.get(c)) {
    in_comment = in_comment || c == '#';
    if (in_comment) continue;
    if (text_.size() == kLongestLine)
      throw BadInput(place() + ": the line is longer than any pose; give one pose a line, as text");
    text_ += c;
  }
  if (file_ && c == '\r' && file_.peek() == '\n') file_.get(c);
  if (line_ == 1 && text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
  return true;
}

std::string PosesFile::place() const {
  return name_ + ":" + std::to_string(line_);
}

}  // namespace pcm::compare
