// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/kept_figures.h"

#include "compare/io/tables/kept_values.h"

namespace pcm::compare::stability {
namespace {

using Kept = nlohmann::ordered_json;

Kept kept(const Figures& figures) {
  Kept list = Kept::array();
  for (const double x : figures) list.push_back(kept_number(x));
  return list;
}

Figures numbers_from(const Kept& list) {
  Figures figures{};
  for (std::size_t k = 0; k < figures.size(); ++k) figures[k] = number_from_kept(list.at(k));
  return figures;
}

}  // namespace

Kept kept_figures(const std::vector<PoseFigures>& poses) {
  Kept list = Kept::array();
  for (const PoseFigures& pose : poses) {
    Kept published = Kept::array();
    for (const PublishedFigures& p : pose.published)
      published.push_back(Kept::array({p.answered, p.same_elements, kept(p.error)}));
    list.push_back(
        Kept::array({pose.answered, pose.carries_force, pose.flipped, pose.unbounded, pose.outside_bound,
                     kept(pose.error), kept(pose.of_vertices), kept(pose.bound), kept(pose.condition), published}));
  }
  return list;
}

std::vector<PoseFigures> figures_from(const Kept& list) {
  std::vector<PoseFigures> poses;
  for (const Kept& entry : list) {
    PoseFigures& pose = poses.emplace_back();
    pose.answered = entry.at(0).get<bool>();
    pose.carries_force = entry.at(1).get<bool>();
    pose.flipped = entry.at(2).get<bool>();
    pose.unbounded = entry.at(3).get<bool>();
    pose.outside_bound = entry.at(4).get<std::string>();
    pose.error = numbers_from(entry.at(5));
    pose.of_vertices = numbers_from(entry.at(6));
    pose.bound = numbers_from(entry.at(7));
    pose.condition = numbers_from(entry.at(8));
    for (std::size_t a = 0; a < pose.published.size(); ++a) {
      const Kept& published = entry.at(9).at(a);
      pose.published[a] = {published.at(0).get<bool>(), published.at(1).get<bool>(), numbers_from(published.at(2))};
    }
  }
  return poses;
}

}  // namespace pcm::compare::stability
