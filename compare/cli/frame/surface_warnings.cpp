// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/surface_warnings.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "compare/cli/frame/command_line.h"
#include "pcm/check.h"
#include "reference/proofs/self_intersections.h"

namespace pcm::compare {

std::string self_intersection_warning(const TriangleMesh& mesh) {
  constexpr std::size_t kShown = 5;
  const std::vector<std::pair<Index, Index>> pairs = reference::self_intersections(mesh);
  if (pairs.empty()) return {};
  std::string text = std::to_string(pairs.size());
  text += pairs.size() == 1 ? " pair of faces that intersect: " : " pairs of faces that intersect: ";
  for (std::size_t i = 0; i < std::min(pairs.size(), kShown); ++i) {
    if (i > 0) text += ", ";
    text += std::to_string(std::int64_t{pairs[i].first} + 1) + "-" + std::to_string(std::int64_t{pairs[i].second} + 1);
  }
  if (pairs.size() > kShown) text += " and " + std::to_string(pairs.size() - kShown) + " more";
  return text + "; where the surface covers a place more than once, so do areas and volume";
}

std::string require_fit_or_warn(const TriangleMesh& mesh) {
  const MeshReport report = check(mesh);
  require_fit(report);
  std::vector<std::string> warnings;
  for (const MeshIssue& issue : report.issues())
    if (issue.severity == Severity::warning) warnings.push_back(issue.text);
  if (std::string text = self_intersection_warning(mesh); !text.empty()) warnings.push_back(std::move(text));
  if (warnings.empty()) return {};
  std::string line = "warning: " + mesh.name + ": " + warnings.front();
  for (std::size_t i = 1; i < warnings.size(); ++i) line += ". Also: " + warnings[i];
  return line;
}

void print_warnings(const std::string& warning_E, const std::string& warning_F) {
  if (!warning_E.empty()) complain(warning_E);
  if (!warning_F.empty() && warning_F != warning_E) complain(warning_F);
}

}  // namespace pcm::compare
