// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/poses/poses_file.h"
#include "pcm/engine.h"

namespace pcm::compare {

/// What a pose says about one choice of master, in the barycentric scheme.
struct MasterAtPose {
  Index elements = 0;
  double across = 0;    ///< diameter of a disc as large as the contact, in mean edge lengths of the faces in it
  double error = 0;     ///< |F - F_c| / |F_c|, F_c the clipped integral with the same master
  double greatest = 0;  ///< share of the greatest element in the force: what it jumps by when that one is lost
  Index too_deep = 0;   ///< faces whose penetration line leaves the master first
  bool lost = false;    ///< no element although the clipped integral has a force
  bool clamped = false;
  double seconds = 0, clipped_seconds = 0;  ///< of an evaluation of the force
};

/// The same over all poses in contact.
struct MasterSummary {
  Mode mode = Mode::E;
  double elements = 0;      ///< median
  double across = 0;        ///< median
  double median_error = 0;  ///< see MasterAtPose
  double greatest_error = 0;
  double greatest_element = 0;              ///< the greatest
  std::int64_t too_deep = 0;                ///< sum
  std::int64_t lost = 0;                    ///< poses
  std::int64_t clamped = 0;                 ///< poses
  double seconds = 0, clipped_seconds = 0;  ///< medians
};

/// Which surface should be master.
struct MasterAdvice {
  std::int64_t poses = 0;                ///< looked at
  std::int64_t in_contact = 0;           ///< with a force, or faces too deep to have one
  std::array<MasterSummary, 3> masters;  ///< E, F, both
  double model_gap = 0;  ///< median of |F_E - F_F| / mean |F| of the clipped integrals: what the choice itself means
  std::optional<Mode> master;  ///< none where no pose has a force
  std::string reason;          ///< one sentence
};

/// Gathers poses and advises. Elastic force only: velocities play no part. The choice: fewest poses at which the force
/// is lost, then fewest faces too deep, then the least median error; of those within a tenth of the least, the fastest.
/// Times are the machine's, so near ties may fall either way.
class MasterAdviser {
 public:
  MasterAdviser(const fast::Surface& surface_E, const fast::Surface& surface_F, const ContactLaw& law);

  /// Throws BadInput where the engine refuses the pose.
  void add(const Pose& pose);
  MasterAdvice advice() const;

 private:
  struct OneSided {
    Eigen::Vector3d force_Me, clipped_Me;
    MasterAtPose at;
  };
  OneSided look(const fast::Pairing& barycentric, const fast::Pairing& clipped, const Pose& pose);

  std::vector<fast::Pairing> barycentric_, clipped_;  // masters E, F and both
  fast::Workspace workspace_;
  std::int64_t poses_ = 0;
  std::int64_t in_contact_ = 0;
  std::array<std::vector<MasterAtPose>, 3> seen_;
  std::vector<double> gaps_;
};

/// The table and the sentence.
std::string master_advice_text(const MasterAdvice& advice);

}  // namespace pcm::compare
