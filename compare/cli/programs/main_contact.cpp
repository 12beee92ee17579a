// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What asks about surfaces and contacts: pcm contact, explain, inspect and mesh.
#include "compare/cli/contact/contact.h"
#include "compare/cli/contact/explain.h"
#include "compare/cli/contact/inspect.h"
#include "compare/cli/frame/program.h"
#include "compare/cli/mesh/mesh.h"

int main(int argc, char** argv) {
  using namespace pcm::compare;
  return exit_status_of([=] {
    return run_command_line(argc, argv, [](CLI::App& program, Run& run) {
      add_contact_command(program, run);
      add_explain_command(program, run);
      add_inspect_command(program, run);
      add_mesh_command(program, run);
    });
  });
}
