// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judged_cases.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>

#include "compare/io/json/json_file.h"
#include "compare/io/provenance/sha256.h"
#include "compare/verify/verdict/case_file.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// The text under a key; empty where there is none.
std::string text_or_nothing(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

/// A name without a folder, so that nothing elsewhere is touched, whatever stands in the file.
bool is_name_of_case(const std::string& name) {
  return name.starts_with("case_") && name.ends_with(".json") && fs::path(name).filename() == name;
}

void remove_unchanged(const fs::path& file, const std::string& hash) {
  if (sha256_of_file(file) != hash) return;
  std::error_code error;
  fs::remove(file, error);
  if (error) throw BadInput(file.string() + ": of another judgement, and it can't be removed");
}

/// Longer names are none to many file systems.
constexpr std::size_t kLongestId = 180;

/// The name of the case file of a pose, whose id may hold anything and be of any length; another one than those taken.
std::string free_name(const std::string& id, std::set<std::string>& taken) {
  std::size_t length = std::min(id.size(), kLongestId);
  while (length < id.size() && (static_cast<unsigned char>(id[length]) & 0xC0U) == 0x80U) --length;  // within UTF-8
  std::string word = id.substr(0, length);
  std::replace_if(
      word.begin(), word.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '_');
  std::string name = case_file_name(word);
  for (int k = 2; !taken.insert(name).second; ++k) name = case_file_name(word + "-" + std::to_string(k));
  return name;
}

}  // namespace

void remove_judged_cases(const fs::path& folder) {
  const Json earlier = json_or_discarded(folder / "judgement.json");
  if (!earlier.is_object() || !earlier.contains("cases")) return;
  for (const Json& one : earlier["cases"]) {
    if (!one.is_object()) continue;
    if (const std::string name = text_or_nothing(one, "file"); is_name_of_case(name))
      remove_unchanged(folder / name, text_or_nothing(one, "sha256"));
  }
}

Json write_judged_cases(const fs::path& folder, const Judging& run) {
  Json written = Json::array();
  std::set<std::string> taken;  // by cases of others, too
  for (const auto& entry : fs::directory_iterator(folder)) taken.insert(entry.path().filename().string());
  for (const WrongAnswer& wrong : run.wrong_answers()) {
    const std::string name = free_name(run.judge().posed().questions[wrong.reply.question].id, taken);
    const std::string text = run.case_text(wrong);
    write_text_file(folder / name, text);
    written.push_back({{"file", name}, {"sha256", sha256(text)}});
  }
  return written;
}

}  // namespace pcm::compare
