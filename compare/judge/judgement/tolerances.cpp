// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/tolerances.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "meshes/files/parse_number.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// The fact's name as a word of an option.
std::string word_of(Fact fact) {
  std::string word(name(fact));
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

Fact value_named(const std::string& option, const std::string& word) {
  std::string known;
  for (std::size_t k = 0; k < kFacts; ++k) {
    const auto fact = static_cast<Fact>(k);
    if (!is_value(fact)) continue;
    if (word == word_of(fact)) return fact;
    known += (known.empty() ? "" : ", ") + word_of(fact);
  }
  throw BadInput(fmt::format("{}: {} is none of {}", option, in_quotes(word), known));
}

}  // namespace

double Tolerance::widen(double derived, double scale) const {
  return std::max({derived, relative * scale, absolute});
}

void Tolerances::add(const std::string& option, const std::vector<std::string>& words, double Tolerance::*which) {
  std::set<std::string> named;
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
      throw BadInput(fmt::format("{}: {} has no '='; write force=1e-6", option, in_quotes(word)));
    if (!named.insert(word.substr(0, sign)).second)
      throw BadInput(fmt::format("{}: {} is there twice", option, in_quotes(word.substr(0, sign))));
    const std::optional<double> value = parse_number(word.substr(sign + 1));
    if (!value || *value < 0)
      throw BadInput(fmt::format("{}: {} is no number from 0 on", option, in_quotes(word.substr(sign + 1))));
    all_[static_cast<std::size_t>(value_named(option, word.substr(0, sign)))].*which = *value;
  }
}

std::string Tolerances::text() const {
  std::string text;
  for (std::size_t k = 0; k < kFacts; ++k) {
    const Tolerance& tolerance = all_[k];
    if (tolerance.relative > 0)
      text += fmt::format("{}{} {:g}", text.empty() ? "" : ", ", kFactNames[k], tolerance.relative);
    if (tolerance.absolute > 0)
      text += fmt::format("{}{} {:g} absolute", text.empty() ? "" : ", ", kFactNames[k], tolerance.absolute);
  }
  return text;
}

}  // namespace pcm::compare
