// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Somebody else's program in C. Its argument is the surface bubble.obj.
#include <pcm/pcm.h>
#include <stdio.h>

int main(int argc, char** argv) {
  pcm_surface* surface;
  pcm_error error;
  size_t vertices = 0, faces = 0;
  int32_t closed = 0;
  if (argc != 2 || pcm_abi_version() != PCM_ABI_VERSION) return 2;
  if (pcm_surface_read(argv[1], &surface, &error) != PCM_OK) return 1;
  pcm_surface_counts(surface, &vertices, &faces, &closed, NULL);
  pcm_surface_dispose(surface);
  printf("pcm %s, %lu vertices, %lu faces, closed: %d\n", pcm_version(), (unsigned long)vertices, (unsigned long)faces,
         (int)closed);
  return 0;
}
