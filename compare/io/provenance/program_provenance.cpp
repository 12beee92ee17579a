// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/provenance/program_provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/io/provenance/commit.h"
#include "pcm/version.h"

namespace pcm::compare {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown processor";
}

/// What the kernel keeps of it: arguments, each ended by a zero byte. Where the program lies is nobody's business.
std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string text;
  for (std::string word; std::getline(file, word, '\0');) {
    if (!text.empty()) text += ' ';
    text += text.empty() ? std::filesystem::path(word).filename().string() : quoted_for_shell(word);
  }
  return text.empty() ? "unknown" : text;
}

}  // namespace

std::string quoted_for_shell(const std::string& word) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_-+./,:=@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  // Control characters and whatever may be no UTF-8, byte by byte.
  if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; })) {
    std::string bytes = "$'";
    for (const char c : word) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x20 || byte >= 0x7f)
        bytes += fmt::format("\\x{:02x}", byte);
      else
        bytes += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
    }
    return bytes + "'";
  }
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? R"('\'')" : std::string(1, c);
  return quoted + "'";
}

ProgramProvenance this_program() {
#ifdef __clang__
  const char* const compiler = "clang " __clang_version__;
#else
  const char* const compiler = "gcc " __VERSION__;
#endif
  return {PCM_VERSION, commit(), command_line(), processor_name(), compiler, PCM_COMPILE_FLAGS};
}

nlohmann::ordered_json provenance_json(const ProgramProvenance& program) {
  return {{"version", program.version},     {"commit", program.commit},     {"command_line", program.command_line},
          {"processor", program.processor}, {"compiler", program.compiler}, {"flags", program.flags}};
}

ProgramProvenance program_from(const nlohmann::ordered_json& provenance) {
  return {provenance.at("version"),   provenance.at("commit"),   provenance.at("command_line"),
          provenance.at("processor"), provenance.at("compiler"), provenance.at("flags")};
}

}  // namespace pcm::compare
