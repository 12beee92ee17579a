// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "compare/io/json/question_json.h"
#include "meshes/generate/boxes.h"
#include "pcm/write_obj.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {

/// A trajectory of two boxes that overlap at three poses, by hand, in a folder of its own.
class TinyTrajectory {
 public:
  static constexpr std::string_view kPoses =
      "# pushed in, tilted, and tilted further\n"
      "1 0 0  0 1 0  0 0 1   0.8 0.13 0.05   -1 0 0  0 0 0\n"
      "1 0 0  0 0.96 -0.28  0 0.28 0.96   0x1.8p-1 0.13 0.05   -1 0.5 0  0 0 0.5\n"
      "\n"
      "1 0 0  0 0.8 -0.6  0 0.6 0.8   0.7 0.13 0.05   -1 0.5 0  0.25 0 0.5\n";
  /// Of the poses in that text.
  static constexpr int kLines[] = {2, 3, 5};

  TinyTrajectory() {
    write_obj(generate::gridded_box(1, 3), folder_.path() / "first.obj");
    write_obj(generate::gridded_box(0.75, 2), folder_.path() / "second.obj");
    folder_.write("0.poses", kPoses);
    write_index([](Json&) {});
  }

  /// The index file with a change.
  void write_index(const std::function<void(Json&)>& alter) const {
    Json json = Json::parse(R"({
      "pcm_trajectory": 1,
      "surfaces": [{"name": "block", "file": "first.obj"}, {"name": "brick", "file": "second.obj"}],
      "pairings": [{"E": 0, "F": 1,
        "law": {"stiffness": "0x1p+19", "damping": "0x1p+9", "transition_depth": "0x1p-10", "friction": "0x1p-2",
                "slip_velocity": "0x1p-7", "max_penetration": "inf", "damping_mode": "compression"},
        "mode": "F", "scheme": "barycentric", "poses": "0.poses"}]})");
    alter(json);
    folder_.write("trajectory.json", json.dump());
  }

  std::string file() const { return folder_.path("trajectory.json"); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  const TemporaryFolder folder_;
};

}  // namespace pcm::compare
