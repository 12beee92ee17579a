// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/poses_file.h"

#include <array>
#include <iostream>

#include "meshes/files/parse_number.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr std::size_t kMatrix = 9, kQuaternion = 4;  // numbers of an orientation
constexpr std::size_t kMostNumbers = kMatrix + 9;    // then r, v and w
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

std::string counts_of(OrientationNotation notation) {
  return notation == OrientationNotation::matrix ? "a pose has 12 (the rotation A by rows, then r) or 18 (then v, w)"
                                                 : "a pose has 7 (a unit quaternion, then r) or 13 (then v, w)";
}

Rotation orientation_from(const std::array<double, kMostNumbers>& numbers, const PoseReading& reading) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  if (reading.notation == OrientationNotation::matrix)
    return rotation_from(Eigen::Matrix3d(Eigen::Map<const RowMajor>(numbers.data())), reading.orthonormalise);
  const bool w_first = reading.notation == OrientationNotation::wxyz;
  return rotation_from_quaternion(numbers[w_first ? 0 : 3],
                                  Eigen::Map<const Eigen::Vector3d>(&numbers[w_first ? 1 : 0]), reading.orthonormalise);
}

}  // namespace

std::optional<State> parse_state(std::string_view line, const PoseReading& reading) {
  std::string_view rest = line.substr(0, line.find('#'));
  std::array<double, kMostNumbers> numbers{};
  std::size_t count = 0;
  while (const std::optional<std::string_view> word = take_word(rest)) {
    const std::optional<double> number = parse_number(*word);
    if (!number) throw BadInput(in_quotes(*word) + " is not a finite number; write it as 0.1 or 0x1.8p-3");
    if (count < kMostNumbers) numbers[count] = *number;
    ++count;
  }
  if (count == 0) return std::nullopt;
  const std::size_t orientation = reading.notation == OrientationNotation::matrix ? kMatrix : kQuaternion;
  if (count != orientation + 3 && count != orientation + 9)
    throw BadInput(std::to_string(count) + " numbers; " + counts_of(reading.notation));

  const Rotation rotation = orientation_from(numbers, reading);
  const double* vectors = numbers.data() + orientation;
  State state;
  state.pose.A = rotation.A;
  state.replaced_error = rotation.replaced_error;
  state.pose.r = reading.metres_per_unit * Eigen::Map<const Eigen::Vector3d>(vectors);
  state.velocity.v = reading.metres_per_unit * Eigen::Map<const Eigen::Vector3d>(vectors + 3);
  state.velocity.w = Eigen::Map<const Eigen::Vector3d>(vectors + 6);
  if (!state.pose.r.allFinite() || !state.velocity.v.allFinite())
    throw BadInput("r or v is beyond what a double holds once it is in metres; check the scale");
  return state;
}

PosesFile::PosesFile(const std::filesystem::path& path, const PoseReading& reading)
    : name_(path == "-" ? "standard input" : path.string()), reading_(reading), standard_input_(path == "-") {
  if (standard_input_) return;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw BadInput(name_ + ": no such file; check the path");
  if (std::filesystem::is_directory(status)) throw BadInput(name_ + ": this is a folder; name a poses file in it");
  file_.open(path);
  if (!file_) throw BadInput(name_ + ": the file can't be opened; check its permissions");
}

std::istream& PosesFile::in() {
  if (standard_input_) return std::cin;
  return file_;
}

std::optional<State> PosesFile::next() {
  while (next_line()) {
    try {
      if (const std::optional<State> state = parse_state(text_, reading_)) {
        empty_ = false;
        return state;
      }
    } catch (const BadInput& error) {
      throw BadInput(place() + ": " + error.what());
    }
  }
  if (in().bad()) throw BadInput(name_ + ": reading failed; is it a folder, or the disk out of order?");
  if (empty_) throw BadInput(name_ + ": the file holds no pose; give one a line");
  return std::nullopt;
}

bool PosesFile::next_line() {
  text_.clear();
  char c = 0;
  std::istream& in = this->in();
  if (!in.get(c)) return false;
  ++line_;
  bool in_comment = false;
  for (; in && c != '\n' && c != '\r'; in.get(c)) {
    in_comment = in_comment || c == '#';
    if (in_comment) continue;
    if (text_.size() == kLongestLine)
      throw BadInput(place() + ": the line is longer than any pose; give one pose a line, as text");
    text_ += c;
  }
  if (in && c == '\r' && in.peek() == '\n') in.get(c);
  if (line_ == 1 && text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
  return true;
}

std::string PosesFile::place() const {
  return name_ + ":" + std::to_string(line_);
}

}  // namespace pcm::compare
