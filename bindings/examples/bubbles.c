// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcm/pcm.h>
#include <stdio.h>

int main(void) {
  const double A[9] = {1, 0, 0, 0, 0.96, -0.28, 0, 0.28, 0.96};  // by rows
  const double r[3] = {0.16, 0.02, 0.01};
  pcm_surface* bubble;
  pcm_law law;
  pcm_pairing* pairing;
  pcm_workspace* workspace;  // one per thread
  pcm_answer answer = {.size = sizeof answer};
  pcm_error error;
  pcm_law_init(&law, sizeof law, NULL);
  law.stiffness = 5.9e5;
  if (pcm_surface_read("meshes/surfaces/bubble.obj", &bubble, &error) ||
      pcm_pairing_define(bubble, bubble, &law, PCM_MODE_BOTH, PCM_BARYCENTRIC, &pairing, &error) ||
      pcm_workspace_define(&workspace, &error) ||
      pcm_evaluate(pairing, A, r, NULL, NULL, PCM_WANTED_FORCE, workspace, &answer, &error)) {
    fprintf(stderr, "%s\n", error.text);
    return 2;
  }
  printf("force on E: %g %g %g N\n", answer.force_Me[0], answer.force_Me[1], answer.force_Me[2]);
  pcm_workspace_dispose(workspace);
  pcm_pairing_dispose(pairing);
  pcm_surface_dispose(bubble);
  return 0;
}
