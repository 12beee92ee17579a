// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace pcm::compare {

/// A number as it is kept, bit for bit, also an infinite one or NaN.
nlohmann::ordered_json kept_number(double x);
double number_from_kept(const nlohmann::ordered_json& kept);

/// What a command has worked out so far, by name, in a file: it may be ended at any time, and goes on from there when
/// it is called again. A line a value, written at once.
class KeptValues {
 public:
  /// Keeps nothing.
  KeptValues() = default;
  /// `identity`: under the key "format" what such files are, then of what the values are, and of the program. A file of
  /// other ones is begun anew; a line that was cut off is left out. Throws BadInput where the file can't be written,
  /// and where another one of that name is there.
  KeptValues(std::filesystem::path file, const nlohmann::ordered_json& identity);

  /// How many values are there.
  std::size_t size() const;
  /// The value that is kept under the name, else what `find` finds, which is kept. From any thread, of different names.
  nlohmann::ordered_json get(const std::string& name, const std::function<nlohmann::ordered_json()>& find);
  /// A number, bit for bit.
  double number(const std::string& name, const std::function<double()>& find);
  /// Removes the file: all has been told.
  void finish();

 private:
  void read(const nlohmann::ordered_json& identity);

  std::filesystem::path file_;
  std::ofstream out_;
  mutable std::mutex mutex_;
  std::map<std::string, nlohmann::ordered_json> values_;
};

}  // namespace pcm::compare
