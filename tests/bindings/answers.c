// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// answers FOLDER: asks, through the C interface, what write_answers has written there, and compares every bit.
#include <inttypes.h>
#include <pcm/pcm.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kNumbers = 52 };

static pcm_error error;

static void checked(pcm_status status) {
  if (status == PCM_OK) return;
  fprintf(stderr, "status %d: %s\n", status, error.text);
  exit(1);
}

static uint64_t read_bits(FILE* in) {
  uint64_t bits = 0;
  if (fscanf(in, "%" SCNx64, &bits) != 1) {
    fprintf(stderr, "answers.txt ends too soon\n");
    exit(1);
  }
  return bits;
}

static double read_double(FILE* in) {
  const uint64_t bits = read_bits(in);
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

// The exclusive or of all bits added, those of the i-th number rotated left by i modulo 64.
typedef struct {
  uint64_t sum;
  unsigned count;
} checksum;

static void add(checksum* c, uint64_t bits) {
  const unsigned shift = c->count++ % 64;
  c->sum ^= shift == 0 ? bits : (bits << shift | bits >> (64 - shift));
}

static void add_integers(checksum* c, const int32_t* numbers, int count) {
  for (int i = 0; i < count; ++i) add(c, (uint64_t)numbers[i]);
}

static void add_doubles(checksum* c, const double* numbers, int count) {
  for (int i = 0; i < count; ++i) add(c, bits_of(numbers[i]));
}

static void add_elements(checksum* c, const pcm_workspace* workspace, int count) {
  pcm_element* elements = calloc((size_t)count + 1, sizeof *elements);
  checked(pcm_copy_elements(workspace, elements, (size_t)count, &error));
  for (const pcm_element* e = elements; e != elements + count; ++e) {
    add_integers(c, &e->master, 1);
    add_integers(c, &e->master_face, 1);
    add_integers(c, &e->slave_face, 1);
    const double scalars[] = {e->area,         e->penetration,     e->normal_velocity, e->tangential_velocity,
                              e->normal_force, e->tangential_force};
    add_doubles(c, scalars, 6);
    add_doubles(c, e->normal_Me, 3);
    add_doubles(c, e->position_Me, 3);
    add_doubles(c, e->force_Me, 3);
  }
  free(elements);
}

static void add_polygons(checksum* c, const pcm_workspace* workspace, int polygon_count, int crossing_count) {
  pcm_polygon* polygons = calloc((size_t)polygon_count + 1, sizeof *polygons);
  checked(pcm_copy_polygons(workspace, polygons, (size_t)polygon_count, &error));
  for (const pcm_polygon* p = polygons; p != polygons + polygon_count; ++p) {
    const int32_t numbers[] = {p->closed, p->first, p->count, p->patch};
    add_integers(c, numbers, 4);
  }
  free(polygons);
  pcm_crossing* crossings = calloc((size_t)crossing_count + 1, sizeof *crossings);
  checked(pcm_copy_crossings(workspace, crossings, (size_t)crossing_count, &error));
  for (const pcm_crossing* x = crossings; x != crossings + crossing_count; ++x) {
    const int32_t numbers[] = {x->edge_side, x->edge[0], x->edge[1], x->face};
    add_integers(c, numbers, 4);
    add_doubles(c, x->position_Me, 3);
  }
  free(crossings);
}

static void add_faces(checksum* c, const pcm_workspace* workspace, int side, int kind, int count) {
  int32_t* faces = calloc((size_t)count + 1, sizeof *faces);
  checked(pcm_copy_faces(workspace, side, kind, faces, (size_t)count, &error));
  add_integers(c, faces, count);
  free(faces);
}

static void add_tangent(checksum* c, const pcm_workspace* workspace) {
  double tangent[72];
  checked(pcm_copy_tangent(workspace, tangent, 72, &error));
  add_doubles(c, tangent, 72);
}

static uint64_t checksum_of(const pcm_workspace* workspace, const pcm_answer* answer, uint32_t wanted) {
  checksum c = {0, 0};
  add_elements(&c, workspace, answer->elements);
  add_polygons(&c, workspace, answer->polygons, answer->crossings);
  add_faces(&c, workspace, PCM_E, PCM_INTERSECTED, answer->E.intersected);
  add_faces(&c, workspace, PCM_E, PCM_INNER, answer->E.inner);
  add_faces(&c, workspace, PCM_F, PCM_INTERSECTED, answer->F.intersected);
  add_faces(&c, workspace, PCM_F, PCM_INNER, answer->F.inner);
  if ((wanted & PCM_WANTED_TANGENT) != 0) add_tangent(&c, workspace);
  return c.sum;
}

static uint64_t* put_doubles(uint64_t* to, const double* numbers, int count) {
  for (int i = 0; i < count; ++i) *to++ = bits_of(numbers[i]);
  return to;
}

static void numbers_of(const pcm_workspace* workspace, const pcm_answer* a, uint32_t wanted, uint64_t* to) {
  const int32_t integers[] = {
      a->touching,        a->nested,  a->ambiguous,     a->has_volume, a->penetration_exceeded, a->too_deep,
      a->undefined_areas, a->patches, a->polygons,      a->crossings,  a->element_count,        a->elements,
      a->E.intersected,   a->E.inner, a->F.intersected, a->F.inner,    a->bound.given,          a->bound.flipped};
  for (size_t i = 0; i < sizeof integers / sizeof *integers; ++i) *to++ = (uint64_t)integers[i];
  to = put_doubles(to, a->force_Me, 3);
  to = put_doubles(to, a->torque_Me, 3);
  to = put_doubles(to, &a->max_penetration, 1);
  to = put_doubles(to, &a->volume, 1);
  const pcm_active_area* areas[] = {&a->E, &a->F};
  for (int side = 0; side < 2; ++side) {
    to = put_doubles(to, &areas[side]->area, 1);
    to = put_doubles(to, areas[side]->vector_area_Me, 3);
  }
  to = put_doubles(to, a->bound.force_Me, 3);
  to = put_doubles(to, a->bound.torque_Me, 3);
  to = put_doubles(to, &a->bound.penetration_at_least, 1);
  to = put_doubles(to, &a->bound.penetration_at_most, 1);
  const pcm_statistics* s = &a->statistics;
  const double scalars[] = {s->patch_area,    s->mean_penetration,    s->max_pressure,
                            s->mean_pressure, s->max_normal_velocity, s->max_tangential_velocity};
  to = put_doubles(to, scalars, 6);
  to = put_doubles(to, s->centre_of_pressure_Me, 3);
  *to = checksum_of(workspace, a, wanted);
}

// As a file has it, taken apart into arrays and put together again.
static pcm_surface* read_surface(const char* folder, const char* file) {
  char path[1024];
  snprintf(path, sizeof path, "%s/%s", folder, file);
  pcm_surface *surface, *again;
  checked(pcm_surface_read(path, &surface, &error));
  size_t vertex_count, face_count;
  checked(pcm_surface_counts(surface, &vertex_count, &face_count, NULL, &error));
  double* vertices = malloc(3 * vertex_count * sizeof *vertices);
  int32_t* faces = malloc(3 * face_count * sizeof *faces);
  checked(pcm_surface_copy(surface, vertices, vertex_count, faces, face_count, &error));
  checked(pcm_surface_define(vertices, vertex_count, faces, face_count, &again, &error));
  free(vertices);
  free(faces);
  pcm_surface_dispose(surface);
  return again;
}

static pcm_pairing* read_pairing(FILE* in, const char* folder) {
  char file_E[64], file_F[64];
  if (fscanf(in, "%63s %63s", file_E, file_F) != 2) exit(1);
  pcm_surface *E = read_surface(folder, file_E), *F = read_surface(folder, file_F);
  const int32_t mode = (int32_t)read_bits(in), scheme = (int32_t)read_bits(in);
  pcm_law law;
  checked(pcm_law_init(&law, sizeof law, &error));
  law.damping_mode = (int32_t)read_bits(in);
  double* numbers[] = {&law.stiffness,        &law.layer_stiffness_E, &law.layer_stiffness_F, &law.damping,
                       &law.transition_depth, &law.friction,          &law.slip_velocity,     &law.max_penetration};
  for (int i = 0; i < 8; ++i) *numbers[i] = read_double(in);
  pcm_pairing* pairing;
  checked(pcm_pairing_define(E, F, &law, mode, scheme, &pairing, &error));
  pcm_surface_dispose(E);
  pcm_surface_dispose(F);
  return pairing;
}

static int differing_numbers(FILE* in, const pcm_pairing* pairing, pcm_workspace* workspace) {
  const uint32_t wanted = (uint32_t)read_bits(in);
  double state[18];
  for (int i = 0; i < 18; ++i) state[i] = read_double(in);
  pcm_answer answer = {.size = sizeof answer};
  checked(pcm_evaluate(pairing, state, state + 9, state + 12, state + 15, wanted, workspace, &answer, &error));
  uint64_t numbers[kNumbers];
  numbers_of(workspace, &answer, wanted, numbers);
  int differing = 0;
  for (int i = 0; i < kNumbers; ++i) differing += numbers[i] != read_bits(in);
  return differing;
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  char path[1024];
  snprintf(path, sizeof path, "%s/answers.txt", argv[1]);
  FILE* in = fopen(path, "r");
  int pairings = 0, poses = 0, differing = 0;
  if (in == NULL || fscanf(in, "%d", &pairings) != 1) return 1;
  pcm_workspace* workspace;  // the same for all pairings
  checked(pcm_workspace_define(&workspace, &error));
  for (int i = 0; i < pairings; ++i) {
    pcm_pairing* pairing = read_pairing(in, argv[1]);
    const int count = (int)read_bits(in);
    for (int k = 0; k < count; ++k) differing += differing_numbers(in, pairing, workspace) != 0;
    poses += count;
    pcm_pairing_dispose(pairing);
  }
  pcm_workspace_dispose(workspace);
  fclose(in);
  printf("%d poses, %d with another answer\n", poses, differing);
  return differing == 0 ? 0 : 1;
}
