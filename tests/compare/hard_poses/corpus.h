// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/verify/routes/held_pairing.h"

/// The hardest poses that were found, each with the true answer beside it (corpus.json, made by write_hard_poses).
namespace pcm::compare::hard_poses_test {

/// A pose of a built-in pair at rest, E the master, under ContactLaw's defaults.
struct CorpusPose {
  std::string pair;
  Scheme scheme = Scheme::barycentric;
  std::string hard_for;  ///< "bound": a climb ended there; "margins": of the stratum adversarial
  Pose pose;
  Eigen::Vector3d true_force_Me = Eigen::Vector3d::Zero();   ///< of the exact problem, correctly rounded, N
  Eigen::Vector3d true_torque_Me = Eigen::Vector3d::Zero();  ///< N m
  double margin = 0;                                         ///< the least of any decision (least_margins.h)
  double error_over_bound = 0;                               ///< of the force
};

/// The names of the pairs that are searched, small ones of each kind.
const std::vector<std::string>& searched_pairs();

/// These pairs, ready to be asked.
class CorpusPairs {
 public:
  CorpusPairs();
  const HeldPairing& held(const std::string& pair, Scheme scheme) const;

 private:
  std::map<std::pair<std::string, Scheme>, std::unique_ptr<HeldPairing>> held_;
};

/// One pose a line, all numbers hexadecimal.
std::string corpus_text(const std::vector<CorpusPose>& poses);
std::vector<CorpusPose> corpus_from(const std::string& text);

}  // namespace pcm::compare::hard_poses_test
