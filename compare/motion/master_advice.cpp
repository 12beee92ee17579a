// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/master_advice.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string_view>

#include "compare/io/names.h"

namespace pcm::compare {
namespace {

constexpr std::array kMasters = {Mode::E, Mode::F, Mode::both};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Member>
std::vector<double> column(const std::vector<MasterAtPose>& seen, Member MasterAtPose::*member) {
  std::vector<double> values;
  for (const MasterAtPose& at : seen) values.push_back(static_cast<double>(at.*member));
  return values;
}

double relative(const Eigen::Vector3d& difference, const Eigen::Vector3d& truth) {
  return truth.stableNorm() > 0 ? difference.stableNorm() / truth.stableNorm() : 0;
}

/// Seconds that the force alone takes, on memory that has grown already.
double time_of(const fast::Pairing& pairing, const Pose& pose, fast::Workspace& workspace) {
  Wanted wanted;
  wanted.polygons = wanted.areas = wanted.elements = false;
  const auto start = std::chrono::steady_clock::now();
  fast::evaluate(pairing, pose, {}, wanted, workspace);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Mean edge length over the elements' faces, weighted by their areas, m.
double mean_edge(const fast::Pairing& pairing, const std::vector<fast::Element>& elements) {
  double weighted = 0, areas = 0;
  for (const fast::Element& element : elements) {
    const TriangleMesh& mesh = (element.master == Side::E ? pairing.surface_E() : pairing.surface_F()).mesh();
    const Triangle& face = mesh.faces[static_cast<std::size_t>(element.master_face)];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += (mesh.vertices[static_cast<std::size_t>(face[i])] -
              mesh.vertices[static_cast<std::size_t>(face[(i + 1) % 3])])
                 .norm();
    weighted += element.area * sum / 3;
    areas += element.area;
  }
  return areas > 0 ? weighted / areas : 0;
}

MasterSummary summarize(Mode mode, const std::vector<MasterAtPose>& seen) {
  MasterSummary sum;
  sum.mode = mode;
  sum.elements = median(column(seen, &MasterAtPose::elements));
  sum.across = median(column(seen, &MasterAtPose::across));
  sum.median_error = median(column(seen, &MasterAtPose::error));
  sum.seconds = median(column(seen, &MasterAtPose::seconds));
  sum.clipped_seconds = median(column(seen, &MasterAtPose::clipped_seconds));
  for (const MasterAtPose& at : seen) {
    sum.greatest_error = std::max(sum.greatest_error, at.error);
    sum.greatest_element = std::max(sum.greatest_element, at.greatest);
    sum.too_deep += at.too_deep;
    sum.lost += at.lost ? 1 : 0;
    sum.clamped += at.clamped ? 1 : 0;
  }
  return sum;
}

/// Of the masters of equal standing in `quantity`, those that are best.
template <class Quantity>
void keep_least(std::vector<const MasterSummary*>& left, double factor, const Quantity& quantity) {
  double least = quantity(*left.front());
  for (const MasterSummary* master : left) least = std::min(least, quantity(*master));
  std::erase_if(left, [&](const MasterSummary* master) { return quantity(*master) > factor * least; });
}

std::string percent(double share) {
  return share < 0.095 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

/// The choice in words: what decided, with the numbers.
std::string reason(const MasterSummary& chosen, const std::array<MasterSummary, 3>& masters, std::string_view decided) {
  std::string others;
  for (const MasterSummary& master : masters) {
    if (master.mode == chosen.mode) continue;
    others += others.empty() ? "" : ", ";
    others += fmt::format("{} {}", name(master.mode), percent(master.median_error));
    if (master.lost > 0) others += fmt::format(" and no force at {} pose{}", master.lost, master.lost == 1 ? "" : "s");
    if (master.too_deep > 0) others += fmt::format(" and {} faces too deep", master.too_deep);
  }
  const char* const poor =
      chosen.median_error > 0.5 ? " That is not near: refine the master, or use --scheme clipped." : "";
  const std::string deep = chosen.too_deep > 0 ? fmt::format(" and {} faces too deep", chosen.too_deep) : "";
  return fmt::format(
      "Use --mode {} for {}: with {:.0f} elements, {:.1f} across the contact, the force is off from the exact integral "
      "by "
      "{} in the median{} (others: {}).{}",
      name(chosen.mode), decided, chosen.elements, chosen.across, percent(chosen.median_error), deep, others, poor);
}

}  // namespace

MasterAdviser::MasterAdviser(const fast::Surface& surface_E, const fast::Surface& surface_F, const ContactLaw& law) {
  for (const Mode mode : kMasters) {
    barycentric_.emplace_back(surface_E, surface_F, law, mode, Scheme::barycentric);
    clipped_.emplace_back(surface_E, surface_F, law, mode, Scheme::clipped);
  }
}

MasterAdviser::OneSided MasterAdviser::look(const fast::Pairing& barycentric, const fast::Pairing& clipped,
                                            const Pose& pose) {
  OneSided side;
  Wanted wanted;
  wanted.polygons = wanted.areas = false;
  const fast::Contact& exact = fast::evaluate(clipped, pose, {}, wanted, workspace_);
  side.clipped_Me = exact.force_Me;
  const double diameter = 2 * std::sqrt(exact.statistics.patch_area / std::numbers::pi);
  const double edge = mean_edge(clipped, exact.elements);
  side.at.across = edge > 0 ? diameter / edge : 0;
  side.at.clipped_seconds = time_of(clipped, pose, workspace_);

  const fast::Contact& sampled = fast::evaluate(barycentric, pose, {}, wanted, workspace_);
  side.force_Me = sampled.force_Me;
  side.at.elements = sampled.element_count;
  side.at.too_deep = sampled.too_deep;
  side.at.clamped = sampled.penetration_exceeded;
  side.at.lost = sampled.element_count == 0 && side.clipped_Me.stableNorm() > 0;
  for (const fast::Element& element : sampled.elements)
    side.at.greatest = std::max(side.at.greatest, relative(element.force_Me, side.force_Me));
  side.at.error = relative(side.force_Me - side.clipped_Me, side.clipped_Me);
  side.at.seconds = time_of(barycentric, pose, workspace_);
  return side;
}

void MasterAdviser::add(const Pose& pose) {
  ++poses_;
  const OneSided E = look(barycentric_[0], clipped_[0], pose), F = look(barycentric_[1], clipped_[1], pose);
  const Eigen::Vector3d exact_Me = 0.5 * (E.clipped_Me + F.clipped_Me), sum_Me = 0.5 * (E.force_Me + F.force_Me);
  const double size = 0.5 * (E.clipped_Me.stableNorm() + F.clipped_Me.stableNorm());
  if (!(size > 0) && E.at.too_deep + F.at.too_deep == 0) return;
  ++in_contact_;
  MasterAtPose both;
  both.elements = E.at.elements + F.at.elements;
  both.across = std::min(E.at.across, F.at.across);
  both.error = relative(sum_Me - exact_Me, exact_Me);
  if (sum_Me.stableNorm() > 0)
    both.greatest = std::max(E.at.greatest * E.force_Me.stableNorm(), F.at.greatest * F.force_Me.stableNorm()) /
                    (2 * sum_Me.stableNorm());
  both.too_deep = E.at.too_deep + F.at.too_deep;
  both.lost = both.elements == 0;
  both.clamped = E.at.clamped || F.at.clamped;
  both.seconds = time_of(barycentric_[2], pose, workspace_);
  both.clipped_seconds = time_of(clipped_[2], pose, workspace_);
  seen_[0].push_back(E.at);
  seen_[1].push_back(F.at);
  seen_[2].push_back(both);
  if (size > 0) gaps_.push_back((E.clipped_Me - F.clipped_Me).stableNorm() / size);
}

MasterAdvice MasterAdviser::advice() const {
  MasterAdvice advice;
  advice.poses = poses_;
  advice.in_contact = in_contact_;
  advice.model_gap = median(gaps_);
  for (std::size_t i = 0; i < 3; ++i) advice.masters[i] = summarize(kMasters[i], seen_[i]);
  if (gaps_.empty()) {
    advice.reason = advice.in_contact == 0
                        ? "No pose has a force: there is nothing to choose by."
                        : "No pose has a force, whichever is master: the bodies are thinner than they penetrate.";
    return advice;
  }
  std::vector<const MasterSummary*> left{&advice.masters[0], &advice.masters[1], &advice.masters[2]};
  std::string_view decided = "its time, the errors being near";
  const auto narrow = [&](std::string_view why, double factor, const auto& quantity) {
    if (left.size() > 1) keep_least(left, factor, quantity);
    if (left.size() == 1 && decided == "its time, the errors being near") decided = why;
  };
  narrow("the force it does not lose", 1, [](const MasterSummary& m) { return static_cast<double>(m.lost); });
  narrow("its thickness", 1, [](const MasterSummary& m) { return static_cast<double>(m.too_deep); });
  narrow("its error", 1.1, [](const MasterSummary& m) { return m.median_error; });
  if (left.size() > 1)
    left = {*std::min_element(left.begin(), left.end(),
                              [](const MasterSummary* a, const MasterSummary* b) { return a->seconds < b->seconds; })};
  advice.master = left.front()->mode;
  advice.reason = reason(*left.front(), advice.masters, decided);
  return advice;
}

std::string master_advice_text(const MasterAdvice& advice) {
  std::string text = fmt::format("{} pose{}, {} in contact; barycentric scheme against the clipped integral\n\n",
                                 advice.poses, advice.poses == 1 ? "" : "s", advice.in_contact);
  text += fmt::format("{:>6} {:>9} {:>7} {:>10} {:>10} {:>9} {:>9} {:>7} {:>8} {:>7} {:>10}\n", "master", "elements",
                      "across", "error", "greatest", "one face", "too deep", "lost", "clamped", "us", "clipped us");
  for (const MasterSummary& m : advice.masters)
    text += fmt::format("{:>6} {:>9.0f} {:>7.1f} {:>10} {:>10} {:>9} {:>9} {:>7} {:>8} {:>7.0f} {:>10.0f}\n",
                        name(m.mode), m.elements, m.across, percent(m.median_error), percent(m.greatest_error),
                        percent(m.greatest_element), m.too_deep, m.lost, m.clamped, 1e6 * m.seconds,
                        1e6 * m.clipped_seconds);
  text +=
      fmt::format("\nThe clipped integrals of E and F differ by {}: what the choice of master means in itself.\n{}\n",
                  percent(advice.model_gap), advice.reason);
  return text;
}

}  // namespace pcm::compare
