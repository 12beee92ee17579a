// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/page/page_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "compare/io/base64.h"

namespace pcm::simulate {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "the page's arrays are little-endian");

/// Rounded; what is too great becomes infinite rather than undefined.
float to_float(double x) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return std::abs(x) > kMax ? std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(x > 0 ? 1 : -1))
                            : static_cast<float>(x);
}

template <typename Number>
json packed(const char* type, const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return {{"type", type}, {"base64", compare::base64(bytes)}};
}

json packed_floats(const std::vector<float>& numbers) {
  return packed("Float32", numbers);
}

json packed_doubles(const std::vector<double>& numbers) {
  std::vector<float> rounded(numbers.size());
  std::transform(numbers.begin(), numbers.end(), rounded.begin(), to_float);
  return packed_floats(rounded);
}

/// In 16 bits where they suffice, which makes a page of elements a quarter smaller.
json packed_indices(const std::vector<std::uint32_t>& indices) {
  const bool is_short = std::all_of(indices.begin(), indices.end(), [](std::uint32_t i) { return i <= 0xffff; });
  return is_short ? packed("Uint16", std::vector<std::uint16_t>(indices.begin(), indices.end()))
                  : packed("Uint32", indices);
}

void append(std::vector<float>& numbers, const Eigen::Vector3d& x) {
  for (const double component : x) numbers.push_back(to_float(component));
}

json surface_data(const RecordedSurface& surface) {
  std::vector<float> vertices;
  for (const Eigen::Vector3d& vertex : surface.mesh.vertices) append(vertices, vertex);
  std::vector<std::uint32_t> faces;
  for (const Triangle& face : surface.mesh.faces) faces.insert(faces.end(), face.begin(), face.end());
  return {{"name", surface.name},
          {"colour", surface.colour},
          {"vertices", packed_floats(vertices)},
          {"faces", packed_indices(faces)}};
}

json pose_data(const std::vector<Frame>& frames) {
  std::vector<float> poses;
  for (const Frame& frame : frames) {
    for (const Pose& pose : frame.poses_W) {
      const Eigen::Quaterniond orientation = Eigen::Quaterniond{pose.A}.normalized();
      for (const double component : orientation.coeffs()) poses.push_back(to_float(component));
      append(poses, pose.r);
    }
  }
  return packed_floats(poses);
}

std::uint32_t master_number(const RecordedElement& element) {
  return 2 * static_cast<std::uint32_t>(element.pairing) + (element.master == Side::E ? 0 : 1);
}

/// Elements of one master follow one another as a run, so that its number is written once.
void add_elements(json& data, const std::vector<Frame>& frames) {
  std::vector<std::uint32_t> runs, run_master, run_length, faces;
  std::vector<float> pressures;
  for (const Frame& frame : frames) {
    std::vector<RecordedElement> elements = frame.elements;
    std::stable_sort(elements.begin(), elements.end(), [](const RecordedElement& a, const RecordedElement& b) {
      return master_number(a) < master_number(b);
    });
    const std::size_t runs_before = run_master.size();
    for (const RecordedElement& element : elements) {
      if (run_master.size() == runs_before || run_master.back() != master_number(element)) {
        run_master.push_back(master_number(element));
        run_length.push_back(0);
      }
      ++run_length.back();
      faces.push_back(static_cast<std::uint32_t>(element.face));
      pressures.push_back(to_float(element.pressure));
    }
    runs.push_back(static_cast<std::uint32_t>(run_master.size() - runs_before));
  }
  data["element_runs"] = packed_indices(runs);
  data["run_master"] = packed_indices(run_master);
  data["run_length"] = packed_indices(run_length);
  data["face"] = packed_indices(faces);
  data["pressure"] = packed_floats(pressures);
}

void add_contacts(json& data, const std::vector<Frame>& frames) {
  std::vector<std::uint32_t> counts, pairings;
  std::vector<float> contacts;
  for (const Frame& frame : frames) {
    counts.push_back(static_cast<std::uint32_t>(frame.contacts.size()));
    for (const RecordedContact& contact : frame.contacts) {
      pairings.push_back(static_cast<std::uint32_t>(contact.pairing));
      append(contacts, contact.position_W);
      append(contacts, contact.force_W);
    }
  }
  data["contacts"] = packed_indices(counts);
  data["contact_pairing"] = packed_indices(pairings);
  data["contact"] = packed_floats(contacts);
}

json frame_data(const std::vector<Frame>& frames) {
  std::vector<double> times;
  for (const Frame& frame : frames) times.push_back(frame.t);
  json data{{"t", packed("Float64", times)}, {"poses", pose_data(frames)}};
  add_elements(data, frames);
  add_contacts(data, frames);
  return data;
}

void add_series(json& data, const std::vector<Series>& all) {
  std::map<std::vector<double>, std::size_t> numbers;
  data["times"] = json::array();
  data["series"] = json::array();
  for (const Series& series : all) {
    const auto [place, is_new] = numbers.try_emplace(series.t, numbers.size());
    if (is_new) data["times"].push_back(packed_doubles(series.t));
    data["series"].push_back({{"name", series.name},
                              {"unit", series.unit},
                              {"plot", series.plot},
                              {"logarithmic", series.logarithmic},
                              {"times", place->second},
                              {"value", packed_doubles(series.value)}});
  }
}

}  // namespace

json page_data(const Recording& recording) {
  json data{{"title", recording.title}, {"surfaces", json::array()}, {"pairings", json::array()}};
  for (const RecordedSurface& surface : recording.surfaces) data["surfaces"].push_back(surface_data(surface));
  for (const RecordedPairing& pairing : recording.pairings)
    data["pairings"].push_back(
        {{"name", pairing.name}, {"surfaces", std::array{pairing.surface_E, pairing.surface_F}}});
  data["frames"] = frame_data(recording.frames);
  add_series(data, recording.series);
  return data;
}

}  // namespace pcm::simulate
