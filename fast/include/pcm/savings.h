// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcm::fast {

/// What is left out because it was not asked for or can't matter. No saving changes a bit of any answer that there is
/// without it; where a number that was not asked for leaves the range of doubles, or a relative pose that of poses, an
/// evaluation may throw BadInput without `only_wanted`, `velocities`, `broad_phase` or `certificates` and answer with
/// them. Each can be switched off, to measure what it is worth and to show just that. WorkCounters and SceneCounters
/// count the work that is left.
struct Savings {
  /// Scene: pairings whose bodies' boxes are apart are not looked at.
  bool broad_phase = true;
  /// Scene: nor are those that were apart by more than they can have moved since.
  bool certificates = true;
  /// Where only touch is asked for, the first crossing is the answer.
  bool first_crossing = true;
  /// F's vertices are transformed when first needed. Off: all of them in each evaluation.
  bool lazy_vertices = true;
  /// Modes E and F: no elements on the slave. Off: they are formed and thrown away.
  bool one_sided = true;
  /// Velocities at elements only where the law, the caller's elements or their statistics need them.
  bool velocities = true;
  /// Only what `Wanted` asks for. Off: all of it is computed, and what was not asked for thrown away.
  bool only_wanted = true;
  /// Crossings: exact arithmetic only where the floating-point filter can't tell.
  bool filters = true;
  /// PairingMemory, and scenes that remember poses: where only the velocity is another one, only the law is applied
  /// anew. Off: all is found anew.
  bool known_poses = true;
  /// PairingMemory, and scenes: what crosses is followed from pose to pose as long as steps are short. Off, or with
  /// `filters` off: it is found anew at each.
  bool coherence = true;

  /// Everything switched off.
  static constexpr Savings none() { return {false, false, false, false, false, false, false, false, false, false}; }
};
static_assert(sizeof(Savings) == 10, "none() has to name all of them");

}  // namespace pcm::fast
