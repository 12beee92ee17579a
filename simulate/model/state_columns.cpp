// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/model/state_columns.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace pcm::simulate {
namespace {

using Columns = std::vector<StateColumn>;

/// What would end a cell or a line there does not belong in a column's name.
std::string in_a_table(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ',' || c == '"' || (c >= 0 && c < ' '); }, '_');
  return name;
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
