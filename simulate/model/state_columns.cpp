// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/model/state_columns.h"

#include <algorithm>
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

/// Of a joint: coordinates beside their speeds, by name and unit.
struct JointColumns {
  Columns coordinates, speeds;
};

JointColumns columns_of(JointType type) {
  switch (type) {
    case JointType::weld:
      return {};
    case JointType::pin:
      return {{{"angle", "rad"}}, {{"rate", "rad/s"}}};
    case JointType::slider:
      return {{{"displacement", "m"}}, {{"speed", "m/s"}}};
    case JointType::universal:
      return {{{"angle_x", "rad"}, {"angle_y", "rad"}}, {{"rate_x", "rad/s"}, {"rate_y", "rad/s"}}};
    case JointType::gimbal:
      return {{{"angle_x", "rad"}, {"angle_y", "rad"}, {"angle_z", "rad"}},
              {{"rate_x", "rad/s"}, {"rate_y", "rad/s"}, {"rate_z", "rad/s"}}};
    case JointType::ball:
    case JointType::free:
      break;
  }
  JointColumns columns{{{"quaternion_w", "1"}, {"quaternion_x", "1"}, {"quaternion_y", "1"}, {"quaternion_z", "1"}},
                       {{"omega_x", "rad/s"}, {"omega_y", "rad/s"}, {"omega_z", "rad/s"}}};
  if (type == JointType::ball) return columns;
  for (const char* axis : {"x", "y", "z"}) {
    columns.coordinates.push_back({axis, "m"});
    columns.speeds.push_back({std::string("v_") + axis, "m/s"});
  }
  return columns;
}

Columns of_body(const Body& body, Columns columns) {
  for (StateColumn& column : columns) column.name = in_a_table(body.name) + "." + column.name;
  return columns;
}

}  // namespace

Columns coordinate_columns(const Body& body) {
  return of_body(body, columns_of(body.joint.type).coordinates);
}

Columns speed_columns(const Body& body) {
  return of_body(body, columns_of(body.joint.type).speeds);
}

}  // namespace pcm::simulate
