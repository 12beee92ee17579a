// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contestants/contestant.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "compare/judge/lines/answer_lines.h"
#include "compare/judge/poses/poses_folder.h"

namespace pcm::compare {

int converse(const MakeContestant& make) {
  try {
    PosesReader reader("/dev/stdin", "");
    std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Contestant>> known;
    while (const std::optional<PosedQuestion> question = reader.next()) {
      std::unique_ptr<Contestant>& contestant = known[{question->E, question->F}];
      if (!contestant) contestant = make(reader.surfaces()[question->E].mesh, reader.surfaces()[question->F].mesh);
      std::cout << dump_exactly(answer_json(question->id, contestant->answer(*question), Notation::decimal))
                << std::endl;
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}

GivenAnswer answer_of_pairs(std::vector<FacePair> pairs) {
  GivenAnswer answer;
  answer.touching = !pairs.empty();
  std::sort(pairs.begin(), pairs.end());
  answer.crossing_pairs = std::move(pairs);
  return answer;
}

}  // namespace pcm::compare
