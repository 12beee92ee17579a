// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/path_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/io/names.h"

namespace pcm::compare {
namespace {

constexpr std::size_t kRows = 20;

/// The slave faces a load leaves through, in a few characters.
std::string slave_text(const FaceLoad& load) {
  if (load.slave_faces.empty()) return "-";
  if (load.slave_faces.size() == 1) return std::to_string(load.slave_faces.front());
  return fmt::format("{}+{}", load.slave_faces.front(), load.slave_faces.size() - 1);
}

std::string row(const ForceJump& jump) {
  const FaceJump& face = jump.faces.front();
  const std::string master = fmt::format("{} {}", name(face.loaded().master), face.loaded().face);
  const std::string slave = slave_text(face.before) + " -> " + slave_text(face.after);
  std::string notes;
  if (face.loaded().clamped) notes += " clamped";
  if (jump.faces.size() > 1) notes += fmt::format(" and {} more", jump.faces.size() - 1);
  return fmt::format("{:>10.4g} {:>7.2f} {:>10.3g} {:>14.9f}  {:<33} {:>9} {:>14}{}\n", jump.size(),
                     100 * jump.relative(), jump.torque_Me.stableNorm(), jump.before.position(), describe(face.cause),
                     master, slave, notes);
}

/// Jumps and the sum of their sizes; a jump counts under the cause of its greatest face.
struct Count {
  std::size_t jumps = 0;
  double sum = 0, greatest = 0;
  void add(const ForceJump& jump) {
    ++jumps;
    sum += jump.size();
    greatest = std::max(greatest, jump.size());
  }
};

Count count(const std::vector<ForceJump>& jumps, std::optional<JumpCause> cause = {}) {
  Count total;
  for (const ForceJump& jump : jumps)
    if (!cause || jump.faces.front().cause == *cause) total.add(jump);
  return total;
}

Json place_json(const PathPoint& point, const Pose& pose) {
  Json numbers = Json::array();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) numbers.push_back(pose.A(i, j));
  for (int i = 0; i < 3; ++i) numbers.push_back(pose.r[i]);
  return {{"at", point.position()}, {"segment", point.segment}, {"share", point.share()}, {"pose", std::move(numbers)}};
}

Json face_json(const FaceJump& face) {
  return {{"master", name(face.loaded().master)},
          {"face", face.loaded().face},
          {"slave_before", face.before.slave_faces},
          {"slave_after", face.after.slave_faces},
          {"force_before", json_vector(face.before.force_Me)},
          {"force_after", json_vector(face.after.force_Me)},
          {"clamped", face.before.clamped || face.after.clamped},
          {"cause", name(face.cause)},
          {"continuous", face.continuous}};
}

}  // namespace

std::string path_table(const PathReport& report) {
  const PathWalk& walk = report.walk;
  std::string text = fmt::format("{} poses, {} steps between two, {} evaluations; way {:.6g} m, turn {:.6g} rad, {}\n",
                                 report.path.segments().size() + 1, report.search.steps, walk.evaluations,
                                 report.path.length(), report.path.turn(), report.path.closed() ? "closed" : "open");
  text +=
      fmt::format("elastic force, {} scheme, mode {}: greatest {:.6g} N at {:.6f}\n\n", name(report.pairing.scheme()),
                  name(report.pairing.mode()), report.work.greatest_force, report.work.greatest_force_at.position());
  if (!walk.jumps.empty()) {
    text += fmt::format("{:>10} {:>7} {:>10} {:>14}  {:<33} {:>9} {:>14}\n", "jump, N", "percent", "N m", "at", "cause",
                        "face", "slave face");
    std::vector<const ForceJump*> order;
    for (const ForceJump& jump : walk.jumps) order.push_back(&jump);
    std::stable_sort(order.begin(), order.end(),
                     [](const ForceJump* a, const ForceJump* b) { return a->size() > b->size(); });
    for (std::size_t i = 0; i < std::min(order.size(), kRows); ++i) text += row(*order[i]);
    if (order.size() > kRows) text += fmt::format("... and {} smaller ones\n", order.size() - kRows);
    text += '\n';
    for (const JumpCause cause : kJumpCauses) {
      const Count of_cause = count(walk.jumps, cause);
      if (of_cause.jumps > 0)
        text += fmt::format("{:<33} {:>6} jumps, {:.4g} N together, greatest {:.4g} N\n", describe(cause),
                            of_cause.jumps, of_cause.sum, of_cause.greatest);
    }
  }
  const Count all = count(walk.jumps);
  text += fmt::format("jumps: {}, {:.6g} N together, greatest {:.6g} N\n", all.jumps, all.sum, all.greatest);
  if (walk.most_too_deep > 0) text += fmt::format("too deep: up to {} faces at a step\n", walk.most_too_deep);
  if (report.normal_Me) {
    const TangentialForce force = tangential_force(walk, *report.normal_Me);
    text += fmt::format("tangential force: greatest {:.6g} N at {:.6f}, normal force {:.6g} N there; ", force.greatest,
                        force.at.position(), force.normal_there);
    text += std::isfinite(force.share()) ? fmt::format("{:.4g} of the greatest normal force\n", force.share())
                                         : "there is no normal force anywhere\n";
  }
  const PathWork& work = report.work;
  text += fmt::format("work of the contact on F{}: {:.9g} J, +- {:.1g} J; {:.4g} of greatest force times way\n",
                      report.path.closed() ? ", left over after the loop" : "", work.work, work.error, work.share());
  return text;
}

Json jump_json(const ForceJump& jump) {
  Json json;
  json["before"] = place_json(jump.before, jump.pose_before);
  json["after"] = place_json(jump.after, jump.pose_after);
  json["jump"] = jump.size();
  json["relative"] = jump.relative();
  json["force"] = json_vector(jump.force_Me);
  json["torque"] = json_vector(jump.torque_Me);
  json["cause"] = name(jump.faces.front().cause);
  json["faces"] = Json::array();
  for (const FaceJump& face : jump.faces) json["faces"].push_back(face_json(face));
  return json;
}

Json path_json(const PathReport& report) {
  const PathWork& work = report.work;
  const Count all = count(report.walk.jumps);
  Json json;
  json["scheme"] = name(report.pairing.scheme());
  json["mode"] = name(report.pairing.mode());
  json["poses"] = report.path.segments().size() + 1;
  json["steps"] = report.search.steps;
  json["evaluations"] = report.walk.evaluations;
  json["length"] = report.path.length();
  json["turn"] = report.path.turn();
  json["closed"] = report.path.closed();
  json["greatest_force"] = work.greatest_force;
  json["greatest_torque"] = work.greatest_torque;
  json["jumps"] = all.jumps;
  json["sum_of_jumps"] = all.sum;
  json["greatest_jump"] = all.greatest;
  for (const JumpCause cause : kJumpCauses) {
    const Count of_cause = count(report.walk.jumps, cause);
    json["by_cause"][std::string(name(cause))] = {
        {"jumps", of_cause.jumps}, {"sum", of_cause.sum}, {"greatest", of_cause.greatest}};
  }
  json["too_deep"] = report.walk.most_too_deep;
  json["work"] = work.work;
  json["work_error"] = work.error;
  json["work_share"] = work.share();
  if (report.normal_Me) {
    const TangentialForce force = tangential_force(report.walk, *report.normal_Me);
    json["tangential"] = {{"greatest", force.greatest},
                          {"at", force.at.position()},
                          {"normal_there", force.normal_there},
                          {"share", std::isfinite(force.share()) ? Json(force.share()) : Json()}};
  }
  return json;
}

}  // namespace pcm::compare
