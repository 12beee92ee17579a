// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "tests/fuzz/target.h"

namespace pcm::fuzz {

namespace {

constexpr std::array kTargets = {
    Target{"obj", read_obj_file},   Target{"off", read_off_file},       Target{"poses", read_poses_file},
    Target{"case", read_case_file}, Target{"contact", compare_contact},
};

}  // namespace

std::span<const Target> targets() {
  return kTargets;
}

const Target& target_named(std::string_view name) {
  for (const Target& target : kTargets) {
    if (target.name == name) return target;
  }
  throw std::invalid_argument("no such target: " + std::string(name));
}

}  // namespace pcm::fuzz
