// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/kept_values.h"

#include <fmt/core.h>

#include <cstdlib>
#include <system_error>
#include <utility>

#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

std::string line_of(const std::string& name, const nlohmann::ordered_json& value) {
  return nlohmann::ordered_json::array({name, value}).dump() + '\n';
}

}  // namespace

nlohmann::ordered_json kept_number(double x) {
  return fmt::format("{:a}", x);
}

double number_from_kept(const nlohmann::ordered_json& kept) {
  return std::strtod(kept.get<std::string>().c_str(), nullptr);
}

KeptValues::KeptValues(std::filesystem::path file, const nlohmann::ordered_json& identity) : file_(std::move(file)) {
  read(identity);
  // Anew, without lines that were cut off; whole or not at all.
  std::string lines = identity.dump() + '\n';
  for (const auto& [name, value] : values_) lines += line_of(name, value);
  write_text_file(file_, lines);
  out_.open(file_, std::ios::app);
}

void KeptValues::read(const nlohmann::ordered_json& identity) {
  std::ifstream in(file_);
  std::string line;
  if (!std::getline(in, line)) return;
  const auto held = nlohmann::ordered_json::parse(line, nullptr, false);
  if (!held.is_object() || held.value("format", nlohmann::ordered_json()) != identity.at("format"))
    throw BadInput(file_.string() + ": is there, and no values of a run; move it away, or choose another folder");
  if (held != identity) return;
  while (std::getline(in, line)) {
    const auto entry = nlohmann::ordered_json::parse(line, nullptr, false);
    if (entry.is_array() && entry.size() == 2 && entry[0].is_string())
      values_.emplace(entry[0].get<std::string>(), entry[1]);
  }
}

std::size_t KeptValues::size() const {
  const std::lock_guard lock(mutex_);
  return values_.size();
}

nlohmann::ordered_json KeptValues::get(const std::string& name, const std::function<nlohmann::ordered_json()>& find) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = values_.find(name); known != values_.end()) return known->second;
  }
  nlohmann::ordered_json found = find();
  if (file_.empty()) return found;
  const std::lock_guard lock(mutex_);
  values_.emplace(name, found);
  out_ << line_of(name, found) << std::flush;
  if (!out_) throw BadInput(file_.string() + ": can't be written");
  return found;
}

double KeptValues::number(const std::string& name, const std::function<double()>& find) {
  return number_from_kept(get(name, [&] { return kept_number(find()); }));
}

void KeptValues::finish() {
  if (file_.empty()) return;
  out_.close();
  std::error_code none_there;
  std::filesystem::remove(file_, none_there);
}

}  // namespace pcm::compare
