// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/answer_map.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "compare/explain/next_answer.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/wrong_answers/tested_engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

/// The edges that pass through faces, in order; none where the surfaces do not cross.
using CrossingKeys = std::vector<std::array<Index, 4>>;

CrossingKeys keys_of(const reference::Answer& answer) {
  CrossingKeys keys;
  for (const reference::Polygon& polygon : answer.polygons) {
    for (const reference::Crossing& x : polygon.points) keys.push_back(crossing_key(x));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Cell by cell, from below.
std::vector<Pose> poses_of(const MapGrid& grid, const Pose& middle) {
  std::vector<Pose> poses;
  for (int up = -grid.steps; up <= grid.steps; ++up) {
    for (int right = -grid.steps; right <= grid.steps; ++right) {
      Pose pose = middle;
      pose.r[grid.axes[0]] += right * grid.ulp;
      pose.r[grid.axes[1]] += up * grid.ulp;
      poses.push_back(pose);
    }
  }
  return poses;
}

std::vector<CrossingKeys> answers_of_oracle(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F,
                                            const std::vector<Pose>& poses) {
  const reference::Oracle oracle(mesh_E, mesh_F);
  std::vector<CrossingKeys> answers(poses.size());
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) {
    reference::Inquiry inquiry(oracle, poses[i]);
    answers[i] = keys_of(inquiry.facts(reference::Problem::rounded, Mode::E));
  });
  return answers;
}

std::vector<CrossingKeys> answers_of(Engine engine, const TriangleMesh& mesh_E, const TriangleMesh& mesh_F,
                                     const std::vector<Pose>& poses) {
  const auto tested = make_tested_engine(engine, mesh_E, mesh_F, {}, Mode::E, Scheme::barycentric);
  const Wanted polygons{.polygons = true, .areas = false, .force = false, .elements = false};
  TestedEngineWorkspace workspace;
  std::vector<CrossingKeys> answers;
  for (const Pose& pose : poses)
    answers.push_back(discrete_answer(tested->evaluate(pose, {}, polygons, workspace)).crossings);
  return answers;
}

/// Numbers answers in the order in which they are seen.
class Numbers {
 public:
  std::vector<std::size_t> of(const std::vector<CrossingKeys>& answers) {
    std::vector<std::size_t> numbers;
    for (const CrossingKeys& keys : answers)
      numbers.push_back(numbers_.try_emplace(keys, numbers_.size()).first->second);
    return numbers;
  }
  std::vector<std::string> in_words() const {
    std::vector<std::string> words(numbers_.size());
    for (const auto& [keys, number] : numbers_)
      words[number] = keys.empty() ? "no crossing" : fmt::format("{} crossings", keys.size());
    return words;
  }

 private:
  std::map<CrossingKeys, std::size_t> numbers_;
};

/// By how often the oracle gives them, then by number.
void order_by_frequency(AnswerMap& map) {
  std::vector<std::size_t> count(map.answers.size()), order(map.answers.size()), place(map.answers.size());
  for (const std::size_t answer : map.rows.front().answers) ++count[answer];
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return count[a] > count[b]; });
  std::vector<std::string> words;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    words.push_back(std::move(map.answers[order[i]]));
  }
  map.answers = std::move(words);
  for (MappedAnswers& row : map.rows) {
    for (std::size_t& answer : row.answers) answer = place[answer];
  }
}

}  // namespace

std::size_t AnswerMap::wrong(const MappedAnswers& row) const {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < row.answers.size(); ++i) differing += row.answers[i] != rows.front().answers[i];
  return differing;
}

AnswerMap answer_map(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose, MapGrid grid) {
  if (grid.ulp == 0) grid.ulp = ulp_of(coordinate_scale(mesh_E, mesh_F, pose));
  const std::vector<Pose> poses = poses_of(grid, pose);
  AnswerMap map;
  map.grid = grid;
  Numbers numbers;
  map.rows.push_back({"oracle", numbers.of(answers_of_oracle(mesh_E, mesh_F, poses))});
  // The variant of 2023 has no polygons.
  for (const Engine engine : {Engine::fast, Engine::published_2003})
    map.rows.push_back({std::string(name(engine)), numbers.of(answers_of(engine, mesh_E, mesh_F, poses))});
  map.answers = numbers.in_words();
  order_by_frequency(map);
  return map;
}

}  // namespace pcm::compare
