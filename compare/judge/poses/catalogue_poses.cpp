// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/poses/catalogue_poses.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "compare/io/names.h"
#include "compare/judge/poses/poses_folder.h"
#include "compare/judge/poses/poses_writer.h"
#include "meshes/generate/degenerate/catalogue.h"

namespace pcm::compare {
namespace {

PosedQuestion question_of(const degenerate::Case& named, Scheme scheme, PosedSurfaces& surfaces) {
  PosedQuestion question;
  question.id = "catalogue/" + named.name + "/both" + (scheme == Scheme::clipped ? "/clipped" : "");
  question.pair = named.name;
  question.stratum = "catalogue";
  question.E = surfaces.number_of(named.E);
  question.F = surfaces.number_of(named.F);
  question.pose = {named.A, named.r};
  question.scheme = scheme;
  question.comment = named.shows;
  // The figure is the exact problem's.
  if (named.exactly_representable) question.known_volume = named.volume;
  return question;
}

}  // namespace

std::int64_t write_catalogue_poses(const std::filesystem::path& folder, Notation notation) {
  PosedSurfaces known;
  std::vector<PosedQuestion> questions;
  for (const degenerate::Case& named : degenerate::catalogue())
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
      questions.push_back(question_of(named, scheme, known));
  PosesWriter writer(folder, known, std::ssize(questions), "pcm poses --catalogue");
  for (const PosedQuestion& question : questions)
    writer.add(dump_exactly(pose_json(question, known.surfaces(), notation)));
  writer.finish();
  return std::ssize(questions);
}

}  // namespace pcm::compare
