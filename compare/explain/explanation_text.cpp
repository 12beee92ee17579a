// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/explanation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/explain/words.h"

namespace pcm::compare {
namespace {

constexpr std::size_t kSignsShown = 4;

std::string point(const Eigen::Vector3d& x) {
  return fmt::format("({}, {}, {})", x[0], x[1], x[2]);
}

std::string direction(const Eigen::Vector3d& d) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(d[i]) == 1) return std::string(d[i] > 0 ? "+" : "-") + "xyz"[i];
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", d[0], d[1], d[2]);
}

std::string distance_text(double distance, double ulp) {
  return fmt::format("{:.4g} ulps, {:.4g} m", distance / ulp, distance);
}

std::string answer_text(const DiscreteAnswer& answer) {
  std::string line = answer.touching ? fmt::format("the surfaces touch in {} crossings", answer.crossings.size())
                                     : "the surfaces do not touch";
  line += fmt::format("; faces crossed: {} of E, {} of F; faces inside: {} of E, {} of F", answer.intersected[0].size(),
                      answer.intersected[1].size(), answer.inner[0].size(), answer.inner[1].size());
  if (answer.nested) line += "; nested";
  if (answer.ambiguous) line += "; ambiguous";
  return line;
}

/// "2 vertices on edges, 1 edge in a face"; empty where there is nothing.
std::string counts_text(const Explanation& explanation, std::size_t CoincidenceCount::*which) {
  std::string line;
  for (std::size_t k = 0; k < kCoincidenceKinds; ++k) {
    const std::size_t count = explanation.counts[k].*which;
    const KindWords& kind = words(static_cast<CoincidenceKind>(k));
    if (count > 0)
      line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, count == 1 ? kind.one : kind.several);
  }
  return line;
}

std::string pair_text(const Coincidence& c) {
  return fmt::format("{} and {}", text(c.features[0]), text(c.features[1]));
}

std::string coincidence_text(const ListedCoincidence& listed, double ulp, bool all) {
  const Coincidence& c = listed.coincidence;
  std::string out = fmt::format("\n{}: {}, at {}\n", words(c.kind).one, pair_text(c), point(c.position_Me));
  if (c.equal_normals) out += fmt::format("  normals: {}\n", *c.equal_normals ? "equal" : "opposite");
  out += c.exact() ? "  margin: 0, exactly\n" : fmt::format("  margin: {}\n", distance_text(c.margin, ulp));
  const std::size_t shown = all ? listed.signs.size() : std::min(kSignsShown, listed.signs.size());
  for (std::size_t k = 0; k < shown; ++k) out += "  " + text(listed.signs[k]) + "\n";
  if (shown < listed.signs.size()) out += fmt::format("  and {} signs more (--all)\n", listed.signs.size() - shown);
  return out;
}

/// "edge 4-5 of E through face 3 of F, face 7 of E inside"; empty where there is nothing.
std::string part_text(const AnswerPart& part, bool all) {
  std::vector<std::string> words;
  for (const auto& [side, from, to, face] : part.crossings)
    words.push_back(fmt::format("edge {}-{} of {} through face {} of {}", from, to, side == 0 ? "E" : "F", face,
                                side == 0 ? "F" : "E"));
  for (std::size_t k = 0; k < 2; ++k)
    for (const Index face : part.inner[k])
      words.push_back(fmt::format("face {} of {} inside", face, k == 0 ? "E" : "F"));
  const std::size_t shown = all ? words.size() : std::min(kSignsShown, words.size());
  std::string line =
      fmt::format("{}", fmt::join(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < words.size()) line += fmt::format(", and {} more (--all)", words.size() - shown);
  return line;
}

std::string change_text(const DiscreteAnswer& answer, const DiscreteAnswer& next, bool all) {
  std::string lines;
  if (const std::string gone = part_text(only_in(answer, next), all); !gone.empty()) lines += "  gone: " + gone + "\n";
  if (const std::string fresh = part_text(only_in(next, answer), all); !fresh.empty())
    lines += "  new: " + fresh + "\n";
  return lines;
}

std::string next_text(const Explanation& explanation, bool all) {
  if (!explanation.next) return "Other crossings or faces inside: found along no direction.\n";
  const NextAnswer& next = *explanation.next;
  return fmt::format("Other crossings or faces inside: within {}, along {}, at r = {}: {}.\n",
                     distance_text(next.distance, explanation.ulp), direction(next.direction), point(next.pose.r),
                     answer_text(next.answer)) +
         change_text(explanation.answer, next.answer, all);
}

std::string free_text(const Explanation& explanation) {
  if (explanation.free_distance > 0)
    return fmt::format("No r nearer than {} has others, A as it is.\n",
                       distance_text(explanation.free_distance, explanation.ulp));
  return "No distance is known to be free of them: features are as near as roundings.\n";
}

std::string nearest_text(const Explanation& explanation) {
  if (!explanation.nearest)
    return fmt::format("No features are nearer to each other than {:.4g} m.\n", explanation.searched);
  const Coincidence& c = *explanation.nearest;
  return fmt::format("The nearest features: {}, {} apart.\n", pair_text(c), distance_text(c.margin, explanation.ulp));
}

}  // namespace

std::string explanation_text(const Explanation& explanation, const ExplainOptions& options, bool all) {
  std::string out =
      fmt::format("Answer: {}; {} contact elements.\n", answer_text(explanation.answer), explanation.elements);
  if (!explanation.oracle_agrees) out += "ENGINE AND ORACLE DISAGREE: this is the engine's answer.\n";
  out +=
      fmt::format("Signs the engine asked for: {}; {} took exact arithmetic, {} of these were 0 and the tie rule's.\n",
                  explanation.work.predicates, explanation.work.exact_predicates, explanation.work.tie_breaks);
  out += fmt::format("An ulp is {:.4g} m, that of the greatest coordinate, {:.4g} m.\n", explanation.ulp,
                     explanation.scale);
  const CoincidenceCount total = explanation.total();
  if (total.exact > 0)
    out += fmt::format("Coincide exactly: {}.\n", counts_text(explanation, &CoincidenceCount::exact));
  if (total.near > 0)
    out += fmt::format("Nearly, within {:.4g} ulps: {}.\n", options.near_ulps,
                       counts_text(explanation, &CoincidenceCount::near));
  if (total.exact + total.near == 0)
    out +=
        fmt::format("Nothing coincides, not even within {:.4g} ulps. ", options.near_ulps) + nearest_text(explanation);
  out += next_text(explanation, all) + free_text(explanation);
  for (const ListedCoincidence& listed : explanation.listed) out += coincidence_text(listed, explanation.ulp, all);
  if (explanation.left_out > 0) out += fmt::format("\n{} coincidences more (--all).\n", explanation.left_out);
  return out;
}

}  // namespace pcm::compare
