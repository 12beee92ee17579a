// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/poses/poses_file.h"
#include "compare/verify/verdict/case_file.h"
#include "fast/base/same_bits.h"
#include "meshes/files/read_obj.h"
#include "meshes/files/read_off.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/write_obj.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"
#include "tests/meshes/same_bits.h"

namespace pcm::fuzz {

namespace {

/// What BadInput must be: one line that says something.
void require_message(const BadInput& refusal) {
  const std::string_view message = refusal.what();
  if (message.empty() || message.find('\n') != std::string_view::npos)
    throw Found("a refusal that is no line: '" + std::string(message) + "'");
}

/// Reads a surface; where it was taken, it is written and read again.
template <class Parse>
void read_surface(const Parse& parse, std::string_view bytes) {
  std::optional<TriangleMesh> mesh;
  try {
    mesh = parse(bytes, "bytes");
  } catch (const BadInput& refusal) {
    return require_message(refusal);
  }
  check(*mesh).summary();
  if (!same_bits(*mesh, parse_obj(format_obj(*mesh), "written"))) throw Found("written and read again, another mesh");
}

/// Of a law that is given by its layers, the stiffness is ignored.
bool same_stiffness(const ContactLaw& a, const ContactLaw& b) {
  if (!a.layers || !b.layers) return !a.layers && !b.layers && a.stiffness == b.stiffness;
  return a.layers->c_E == b.layers->c_E && a.layers->c_F == b.layers->c_F;
}

bool same_law(const ContactLaw& a, const ContactLaw& b) {
  return same_stiffness(a, b) && a.damping == b.damping && a.transition_depth == b.transition_depth &&
         a.friction == b.friction && a.slip_velocity == b.slip_velocity && a.max_penetration == b.max_penetration &&
         a.damping_mode == b.damping_mode;
}

/// Of a case, what a replay reads.
bool same_question(const compare::Case& a, const compare::Case& b) {
  return same_bits(a.E, b.E) && same_bits(a.F, b.F) && fast::same_bits(a.pose, b.pose) &&
         fast::same_bits(a.velocity, b.velocity) && same_law(a.law, b.law) && a.mode == b.mode && a.scheme == b.scheme;
}

void require_rotation(const Pose& pose) {
  if (!pose.A.allFinite() || !pose.r.allFinite()) throw Found("a pose that is not finite");
  const double off = (pose.A.transpose() * pose.A - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= 1.0001e-9)) throw Found("an orientation that is no rotation to 1e-9");
}

}  // namespace

void read_obj_file(std::string_view bytes) {
  read_surface(parse_obj, bytes);
}

void read_off_file(std::string_view bytes) {
  read_surface(parse_off, bytes);
}

void read_poses_file(std::string_view bytes) {
  // The first byte says how poses are written.
  compare::PoseReading reading;
  const int choice = bytes.empty() ? 0 : static_cast<unsigned char>(bytes.front()) % 6;
  reading.notation = static_cast<compare::OrientationNotation>(choice % 3);
  reading.orthonormalise = choice >= 3;
  const ScratchFile file(bytes.substr(bytes.empty() ? 0 : 1));
  try {
    compare::PosesFile poses(file.path(), reading);
    while (const std::optional<compare::State> state = poses.next()) {
      require_rotation(state->pose);
      if (!state->velocity.v.allFinite() || !state->velocity.w.allFinite())
        throw Found("a velocity that is not finite");
    }
  } catch (const BadInput& refusal) {
    require_message(refusal);
  }
}

void read_case_file(std::string_view bytes) {
  std::optional<compare::Case> posed;
  try {
    posed = compare::read_case(ScratchFile(bytes).path());
  } catch (const BadInput& refusal) {
    return require_message(refusal);
  }
  posed->file_E.clear();  // inline from now on
  posed->file_F.clear();
  const std::string text = format_case(*posed, nlohmann::ordered_json::object(), nlohmann::ordered_json::object());
  if (!same_question(*posed, compare::read_case(ScratchFile(text).path())))
    throw Found("written and read again, another case");
}

}  // namespace pcm::fuzz
