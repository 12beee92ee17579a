// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/model/state_columns.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "pcm/utf8_character.h"

namespace pcm::simulate {
namespace {

using Columns = std::vector<StateColumn>;

/// A body's name with `%` and two hexadecimal digits for each byte of what would end a cell or a line, and of `%`:
/// other names stay others.
std::string in_a_table(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string cell;
  while (!name.empty()) {
    const Utf8Character character = first_character(name);
    const std::string_view bytes = name.substr(0, std::max<std::size_t>(character.size, 1));
    const bool stays =
        !has_no_place_in_a_line(character) && std::string_view(",\"%").find(bytes) == std::string_view::npos;
    if (stays) cell += bytes;
    for (std::size_t k = 0; k < bytes.size() && !stays; ++k) {
      const auto byte = static_cast<unsigned char>(bytes[k]);
      cell += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
    name.remove_prefix(bytes.size());
  }
  return cell;
}

void add(Columns& columns, const Body& body, std::initializer_list<std::string_view> names, const char* unit) {
  for (const std::string_view name : names) columns.push_back({in_a_table(body.name) + "." + std::string(name), unit});
}

}  // namespace

Columns coordinate_columns(const Body& body) {
  Columns columns;
  switch (body.joint.type) {
    case JointType::weld:
      break;
    case JointType::pin:
      add(columns, body, {"angle"}, "rad");
      break;
    case JointType::slider:
      add(columns, body, {"displacement"}, "m");
      break;
    case JointType::universal:
      add(columns, body, {"angle_x", "angle_y"}, "rad");
      break;
    case JointType::gimbal:
      add(columns, body, {"angle_x", "angle_y", "angle_z"}, "rad");
      break;
    case JointType::free:
    case JointType::ball:
      add(columns, body, {"quaternion_w", "quaternion_x", "quaternion_y", "quaternion_z"}, "1");
      break;
  }
  if (body.joint.type == JointType::free) add(columns, body, {"x", "y", "z"}, "m");
  return columns;
}

Columns speed_columns(const Body& body) {
  Columns columns;
  switch (body.joint.type) {
    case JointType::weld:
      break;
    case JointType::pin:
      add(columns, body, {"rate"}, "rad/s");
      break;
    case JointType::slider:
      add(columns, body, {"speed"}, "m/s");
      break;
    case JointType::universal:
      add(columns, body, {"rate_x", "rate_y"}, "rad/s");
      break;
    case JointType::gimbal:
      add(columns, body, {"rate_x", "rate_y", "rate_z"}, "rad/s");
      break;
    case JointType::free:
    case JointType::ball:
      add(columns, body, {"omega_x", "omega_y", "omega_z"}, "rad/s");
      break;
  }
  if (body.joint.type == JointType::free) add(columns, body, {"v_x", "v_y", "v_z"}, "m/s");
  return columns;
}

}  // namespace pcm::simulate
