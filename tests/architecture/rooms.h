// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace pcm::test {

/// The rooms of a part of the project, from the bottom up: each includes itself and those above it in this list.
/// docs/DESIGN.md section 1.2 says what lies in them.
struct Part {
  std::string name;
  std::vector<std::string> rooms;
  /// In which room each public header lies, by its name: those of the vocabulary in the lowest one, so that all may
  /// include them, those of the facade in the one that implements them.
  std::map<std::string, std::string> public_headers;
};

inline const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"meshes",
       {"base", "exact", "validity", "files", "generate"},
       {{"triangle_mesh.h", "base"},
        {"bad_input.h", "base"},
        {"utf8_character.h", "base"},
        {"check.h", "validity"},
        {"read_mesh.h", "files"},
        {"write_obj.h", "files"}}},
      {"fast",
       {"base", "predicates", "prism", "surface", "posed", "law", "simd", "search", "crossings", "active", "force",
        "barycentric", "clipped", "bounds", "engine"},
       {{"inputs.h", "base"},
        {"layer_stiffness.h", "base"},
        {"work_counters.h", "base"},
        {"contact.h", "base"},
        {"savings.h", "base"},
        {"body_state.h", "base"},
        {"workspace.h", "engine"},
        {"engine.h", "engine"},
        {"pairing_memory.h", "engine"},
        {"scene.h", "engine"}}},
      // The oracle's own facade lies beside its rooms; the proofs ask it.
      {"reference",
       {"vocabulary", "numbers", "pose", "predicates", "crossings", "lines", "active", "combinatorics", "elements",
        "force", "", "proofs"},
       {}},
      {"compare",
       {"io",
        "random",
        "campaign",
        "bodies",
        "poses",
        "peers",
        "verify/bounds",
        "verify/verdict",
        "verify/routes",
        "verify/run",
        "verify/tables",
        "hard_poses",
        "published",
        "wrong_answers",
        "explain",
        "judge/lines",
        "judge/poses",
        "judge/judgement",
        "judge/engines",
        "contestants",
        "contact",
        "known_answers",
        "error_budget",
        "stability",
        "motion",
        "bench",
        "cli/frame",
        "cli/mesh",
        "cli/contact",
        "cli/verify",
        "cli/judge",
        "cli/bench",
        "cli/programs"},
       {}},
      {"simbody", {""}, {{"load_tangent.h", ""}, {"simbody.h", ""}}},
      {"bindings", {"c", "python", "examples"}, {}},
      {"simulate", {"integrators", "scenes", "model", "run", "record", "page", "paraview", "stills", "cli"}, {}},
  };
  return all;
}

}  // namespace pcm::test
