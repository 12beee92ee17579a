// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/located_json.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "compare/io/json/strict_json.h"
#include "pcm/bad_input.h"

namespace pcm::simulate {
namespace {

using Json = nlohmann::json;

/// Where the parser is. Its last character may be one beyond the token, so a line feed counts once another character
/// was read.
struct Position {
  int line = 1;
  bool line_ends = false;

  void read(char c) {
    line += line_ends;
    line_ends = c == '\n';
  }
};

/// Over the text, telling `Position` of every character that is read.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    position_->read(*at_++);
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Position* position_;
};

std::string escaped(std::string key) {
  const auto replace = [&key](char from, const char* to) {
    for (std::size_t i = key.find(from); i != std::string::npos; i = key.find(from, i + 2)) key.replace(i, 1, to);
  };
  replace('~', "~0");
  replace('/', "~1");
  return key;
}

/// Notes the line of every value by its pointer.
class LineRecorder : public nlohmann::json_sax<Json> {
 public:
  LineRecorder(const Position& position, std::map<std::string, int>& lines) : position_(position), lines_(lines) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    levels_.back().token = escaped(name);
    return levels_.back().keys.insert(name).second || refuse("the key '" + name + "' is there twice");
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
    error = e.what();
    return false;
  }

  std::string error;    ///< of the parser
  std::string refusal;  ///< of what the parser lets pass
  int refused_line = 0;

 private:
  struct Level {
    bool array = false;
    std::size_t next = 0;
    std::string token;
    std::set<std::string> keys;
  };

  bool refuse(const std::string& what) {
    refusal = what;
    refused_line = position_.line;
    return false;
  }
  std::string pointer() const {
    std::string text;
    for (const Level& level : levels_) text += "/" + level.token;
    return text;
  }
  bool value() {
    if (!levels_.empty() && levels_.back().array) levels_.back().token = std::to_string(levels_.back().next++);
    lines_[pointer()] = position_.line;
    return true;
  }
  bool open(bool array) {
    value();
    if (levels_.size() >= compare::kMostJsonLevels)
      return refuse("lists and objects lie in one another more than " + std::to_string(compare::kMostJsonLevels) +
                    " levels deep");
    levels_.push_back({array, 0, "", {}});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  const Position& position_;
  std::map<std::string, int>& lines_;
  std::vector<Level> levels_;
};

/// The schema's validator takes those from 2^63 on for negative ones.
bool large_integers_to_double(int /*depth*/, Json::parse_event_t event, Json& parsed) {
  if (event == Json::parse_event_t::value && parsed.is_number_unsigned() && parsed.get<std::uint64_t>() >> 63 != 0)
    parsed = parsed.get<double>();
  return true;
}

/// "/bodies/0/mass" as people write it: bodies[0].mass.
std::string readable(const std::string& pointer) {
  std::string text;
  const Json::json_pointer tokens(pointer);
  for (Json::json_pointer rest = tokens; !rest.empty(); rest.pop_back()) {
    const std::string& token = rest.back();
    const bool number = std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
    const bool first = rest.parent_pointer().empty();
    text = (number ? "[" + token + "]" : (first ? "" : ".") + token) + text;
  }
  return text;
}

}  // namespace

LocatedJson::LocatedJson(std::string file, const std::string& text) : file_(std::move(file)) {
  Position position;
  LineRecorder recorder(position, lines_);
  const CountingIterator begin(text.data(), &position), end(text.data() + text.size(), &position);
  if (!Json::sax_parse(begin, end, &recorder)) {
    if (recorder.refused_line > 0) {
      throw BadInput(file_ + ":" + std::to_string(recorder.refused_line) + ": " + recorder.refusal);
    }
    const std::size_t colon = recorder.error.find(": ");
    throw BadInput(file_ + ":" + std::to_string(position.line) +
                   ": no JSON: " + (colon == std::string::npos ? recorder.error : recorder.error.substr(colon + 2)));
  }
  document_ = Json::parse(text, large_integers_to_double);
}

std::string LocatedJson::place(std::string pointer) const {
  auto found = lines_.find(pointer);
  while (found == lines_.end() && !pointer.empty()) {
    pointer.erase(pointer.rfind('/'));
    found = lines_.find(pointer);
  }
  return found == lines_.end() ? file_ : file_ + ":" + std::to_string(found->second);
}

void LocatedJson::refuse(const std::string& pointer, const std::string& what) const {
  const std::string where = readable(pointer);
  throw BadInput(place(pointer) + ": " + (where.empty() ? "" : where + ": ") + what);
}

}  // namespace pcm::simulate
