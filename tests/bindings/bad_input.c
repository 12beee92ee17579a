// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the C interface refuses: a status, a text that says what, and everything goes on working afterwards.
#include <math.h>
#include <pcm/pcm.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

// The call ends in this status, and its text holds these words; none where the call is right.
static void expect(int line, pcm_status actual, pcm_status wanted, const pcm_error* error, const char* words) {
  const int right = actual == wanted && (words == NULL ? error->text[0] == '\0' : strstr(error->text, words) != NULL);
  if (right) return;
  ++failures;
  printf("line %d: status %d with \"%s\", where %d with \"%s\" is wanted\n", line, (int)actual, error->text,
         (int)wanted, words == NULL ? "" : words);
}
#define EXPECT(status, wanted, words) expect(__LINE__, status, wanted, &error, words)
#define EXPECT_TRUE(condition)                                                       \
  do {                                                                               \
    if (!(condition)) ++failures, printf("line %d: not " #condition "\n", __LINE__); \
  } while (0)

static pcm_error error;

static const double kVertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int32_t kFaces[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
static const double kIdentity[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const double kNowhere[] = {0.1, 0.1, 0.1};

static pcm_surface* tetrahedron(void) {
  pcm_surface* surface;
  EXPECT(pcm_surface_define(kVertices, 4, kFaces, 4, &surface, &error), PCM_OK, NULL);
  return surface;
}

static void test_surfaces(void) {
  pcm_surface* surface = (pcm_surface*)&error;
  EXPECT(pcm_surface_define(kVertices, 4, kFaces, 4, NULL, &error), PCM_BAD_CALL, "NULL");
  EXPECT(pcm_surface_define(NULL, 4, kFaces, 4, &surface, &error), PCM_BAD_CALL, "vertices is NULL");
  EXPECT_TRUE(surface == NULL);
  EXPECT(pcm_surface_define(kVertices, 4, NULL, 4, &surface, &error), PCM_BAD_CALL, "faces is NULL");
  EXPECT(pcm_surface_define(NULL, 0, NULL, 0, &surface, &error), PCM_BAD_INPUT, "face");
  EXPECT(pcm_surface_define(kVertices, SIZE_MAX, kFaces, 4, &surface, &error), PCM_BAD_INPUT, "vertices");
  EXPECT(pcm_surface_define(kVertices, 4, kFaces, (size_t)1 << 31, &surface, &error), PCM_BAD_INPUT, "faces");
  EXPECT(pcm_surface_define(kVertices, 3, kFaces, 4, &surface, &error), PCM_BAD_INPUT, "surface");
  const int32_t repeated[] = {0, 0, 1};
  EXPECT(pcm_surface_define(kVertices, 4, repeated, 1, &surface, &error), PCM_BAD_INPUT, "surface");
  double vertices[12];
  memcpy(vertices, kVertices, sizeof vertices);
  vertices[4] = NAN;
  EXPECT(pcm_surface_define(vertices, 4, kFaces, 4, &surface, &error), PCM_BAD_INPUT, "finite");
  EXPECT(pcm_surface_read(NULL, &surface, &error), PCM_BAD_CALL, "path is NULL");
  EXPECT(pcm_surface_read("no_such_file.obj", &surface, &error), PCM_BAD_INPUT, "no_such_file.obj");
  EXPECT(pcm_surface_read("no_such_format.xyz", &surface, &error), PCM_BAD_INPUT, "no_such_format.xyz");
  EXPECT_TRUE(surface == NULL);
  EXPECT_TRUE(pcm_surface_read("no_such_file.obj", &surface, NULL) == PCM_BAD_INPUT);
}

static void test_copies_of_surfaces(void) {
  pcm_surface* surface = tetrahedron();
  size_t vertex_count = 0, face_count = 0;
  int32_t closed = 0;
  EXPECT(pcm_surface_counts(NULL, &vertex_count, NULL, NULL, &error), PCM_BAD_CALL, "surface is NULL");
  EXPECT(pcm_surface_counts(surface, &vertex_count, &face_count, &closed, &error), PCM_OK, NULL);
  EXPECT_TRUE(vertex_count == 4 && face_count == 4 && closed == 1);
  double vertices[12];
  int32_t faces[12];
  EXPECT(pcm_surface_copy(NULL, vertices, 4, faces, 4, &error), PCM_BAD_CALL, "surface is NULL");
  EXPECT(pcm_surface_copy(surface, vertices, 3, faces, 4, &error), PCM_BAD_CALL, "room for 3 vertices");
  EXPECT(pcm_surface_copy(surface, vertices, 4, faces, 3, &error), PCM_BAD_CALL, "room for 3 faces");
  EXPECT(pcm_surface_copy(surface, vertices, 4, NULL, 0, &error), PCM_OK, NULL);
  EXPECT_TRUE(memcmp(vertices, kVertices, sizeof vertices) == 0);
  pcm_surface_dispose(surface);
  pcm_surface_dispose(NULL);
}

static void test_laws_and_pairings(void) {
  pcm_law law;
  EXPECT(pcm_law_init(NULL, sizeof law, &error), PCM_BAD_CALL, "law is NULL");
  EXPECT(pcm_law_init(&law, 0, &error), PCM_BAD_CALL, "size is 0 bytes");
  EXPECT(pcm_law_init(&law, sizeof law + 8, &error), PCM_BAD_CALL, "bytes");
  EXPECT(pcm_law_init(&law, sizeof law, &error), PCM_OK, NULL);
  EXPECT_TRUE(law.size == sizeof law && law.stiffness == 1e6 && isinf(law.max_penetration));

  pcm_surface* E = tetrahedron();
  pcm_pairing* pairing = (pcm_pairing*)&error;
  EXPECT(pcm_pairing_define(E, E, &law, PCM_MODE_E, PCM_BARYCENTRIC, NULL, &error), PCM_BAD_CALL, "NULL");
  EXPECT(pcm_pairing_define(NULL, E, &law, PCM_MODE_E, PCM_BARYCENTRIC, &pairing, &error), PCM_BAD_CALL, "E is NULL");
  EXPECT(pcm_pairing_define(E, NULL, &law, PCM_MODE_E, PCM_BARYCENTRIC, &pairing, &error), PCM_BAD_CALL, "F is NULL");
  EXPECT(pcm_pairing_define(E, E, NULL, PCM_MODE_E, PCM_BARYCENTRIC, &pairing, &error), PCM_BAD_CALL, "law is NULL");
  EXPECT(pcm_pairing_define(E, E, &law, 3, PCM_BARYCENTRIC, &pairing, &error), PCM_BAD_CALL, "mode is 3");
  EXPECT(pcm_pairing_define(E, E, &law, PCM_MODE_E, -1, &pairing, &error), PCM_BAD_CALL, "scheme is -1");
  EXPECT_TRUE(pairing == NULL);

  // A struct that the library can't know, and numbers that no law has.
  const struct {
    size_t offset;
    double value;
    const char* words;
  } bad_numbers[] = {{offsetof(pcm_law, stiffness), 0, "stiffness"},
                     {offsetof(pcm_law, stiffness), NAN, "stiffness"},
                     {offsetof(pcm_law, layer_stiffness_E), 1e6, "c_F"},
                     {offsetof(pcm_law, layer_stiffness_F), NAN, "c_E"},
                     {offsetof(pcm_law, damping), -1, "damping"},
                     {offsetof(pcm_law, friction), INFINITY, "friction"},
                     {offsetof(pcm_law, max_penetration), 0, "max_penetration"}};
  for (size_t i = 0; i < sizeof bad_numbers / sizeof *bad_numbers; ++i) {
    pcm_law bad = law;
    memcpy((char*)&bad + bad_numbers[i].offset, &bad_numbers[i].value, sizeof(double));
    EXPECT(pcm_pairing_define(E, E, &bad, PCM_MODE_E, PCM_CLIPPED, &pairing, &error), PCM_BAD_INPUT,
           bad_numbers[i].words);
  }
  pcm_law bad = law;
  bad.size = 4;
  EXPECT(pcm_pairing_define(E, E, &bad, PCM_MODE_E, PCM_CLIPPED, &pairing, &error), PCM_BAD_CALL, "size is 4 bytes");
  bad = law;
  bad.damping_mode = 3;
  EXPECT(pcm_pairing_define(E, E, &bad, PCM_MODE_E, PCM_CLIPPED, &pairing, &error), PCM_BAD_CALL, "damping_mode is 3");
  bad = law;
  bad.reserved = 1;
  EXPECT(pcm_pairing_define(E, E, &bad, PCM_MODE_E, PCM_CLIPPED, &pairing, &error), PCM_BAD_CALL, "reserved is 1");
  pcm_surface_dispose(E);
  pcm_pairing_dispose(NULL);
}

static void test_lists(pcm_workspace* workspace, const pcm_answer* answer) {
  pcm_element elements[64];
  pcm_polygon polygons[8];
  pcm_crossing crossings[64];
  int32_t faces[8];
  EXPECT_TRUE(answer->elements > 0 && answer->elements <= 64 && answer->crossings > 1 && answer->crossings <= 64);
  EXPECT(pcm_copy_elements(NULL, elements, 64, &error), PCM_BAD_CALL, "workspace is NULL");
  EXPECT(pcm_copy_elements(workspace, NULL, 64, &error), PCM_BAD_CALL, "elements is NULL");
  EXPECT(pcm_copy_elements(workspace, elements, 0, &error), PCM_BAD_CALL, "room for 0 elements");
  EXPECT(pcm_copy_elements(workspace, elements, 64, &error), PCM_OK, NULL);
  EXPECT(pcm_copy_polygons(workspace, polygons, 0, &error), PCM_BAD_CALL, "room for 0 polygons");
  EXPECT(pcm_copy_polygons(workspace, polygons, 8, &error), PCM_OK, NULL);
  EXPECT(pcm_copy_crossings(workspace, crossings, 1, &error), PCM_BAD_CALL, "room for 1 crossings");
  EXPECT(pcm_copy_crossings(workspace, crossings, 64, &error), PCM_OK, NULL);
  double tangent[72];
  EXPECT(pcm_copy_tangent(workspace, tangent, 72, &error), PCM_BAD_CALL, "no tangent");
  EXPECT(pcm_copy_faces(workspace, 2, PCM_INNER, faces, 8, &error), PCM_BAD_CALL, "side is 2");
  EXPECT(pcm_copy_faces(workspace, PCM_E, 2, faces, 8, &error), PCM_BAD_CALL, "kind is 2");
  EXPECT(pcm_copy_faces(workspace, PCM_E, PCM_INTERSECTED, faces, 8, &error), PCM_OK, NULL);
}

static void test_evaluations(void) {
  pcm_surface* E = tetrahedron();
  pcm_law law;
  pcm_law_init(&law, sizeof law, NULL);
  pcm_pairing* pairing;
  EXPECT(pcm_pairing_define(E, E, &law, PCM_MODE_BOTH, PCM_CLIPPED, &pairing, &error), PCM_OK, NULL);
  pcm_workspace* workspace;
  EXPECT(pcm_workspace_define(NULL, &error), PCM_BAD_CALL, "NULL");
  EXPECT(pcm_workspace_define(&workspace, &error), PCM_OK, NULL);
  pcm_element element;
  EXPECT(pcm_copy_elements(workspace, &element, 1, &error), PCM_BAD_CALL, "no answer");

  pcm_answer answer = {.size = sizeof answer};
  const uint32_t all = 63;
#define EVALUATE(pairing, A, r, v, w, wanted, workspace, answer) \
  pcm_evaluate(pairing, A, r, v, w, wanted, workspace, answer, &error)
  EXPECT(EVALUATE(NULL, kIdentity, kNowhere, NULL, NULL, all, workspace, &answer), PCM_BAD_CALL, "pairing is NULL");
  EXPECT(EVALUATE(pairing, NULL, kNowhere, NULL, NULL, all, workspace, &answer), PCM_BAD_CALL, "A is NULL");
  EXPECT(EVALUATE(pairing, kIdentity, NULL, NULL, NULL, all, workspace, &answer), PCM_BAD_CALL, "r is NULL");
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, all, NULL, &answer), PCM_BAD_CALL, "workspace is NULL");
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, all, workspace, NULL), PCM_BAD_CALL, "answer is NULL");
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, 128, workspace, &answer), PCM_BAD_CALL, "wanted is 128");
  const double nan3[] = {0, NAN, 0}, reflection[] = {1, 0, 0, 0, 1, 0, 0, 0, -1};
  const double sheared[] = {1, 1e-6, 0, 0, 1, 0, 0, 0, 1};
  EXPECT(EVALUATE(pairing, kIdentity, nan3, NULL, NULL, all, workspace, &answer), PCM_BAD_INPUT, "finite");
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, nan3, NULL, all, workspace, &answer), PCM_BAD_INPUT, "finite");
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, nan3, all, workspace, &answer), PCM_BAD_INPUT, "finite");
  EXPECT(EVALUATE(pairing, reflection, kNowhere, NULL, NULL, all, workspace, &answer), PCM_BAD_INPUT, "reflection");
  EXPECT(EVALUATE(pairing, sheared, kNowhere, NULL, NULL, all, workspace, &answer), PCM_BAD_INPUT, "no rotation");
  EXPECT_TRUE(answer.touching == 0 && answer.size == sizeof answer);
  pcm_answer small = {.size = sizeof small - 1}, large = {.size = sizeof large + 1};
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, all, workspace, &small), PCM_BAD_CALL, "size");
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, all, workspace, &large), PCM_BAD_CALL, "size");

  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, all, workspace, &answer), PCM_OK, NULL);
  EXPECT_TRUE(answer.touching == 1 && answer.bound.given == 1 && answer.size == sizeof answer);
  // What is disposed of lives on in the pairing.
  pcm_surface_dispose(E);
  EXPECT(EVALUATE(pairing, kIdentity, kNowhere, NULL, NULL, all, workspace, &answer), PCM_OK, NULL);
  test_lists(workspace, &answer);
  EXPECT(EVALUATE(pairing, reflection, kNowhere, NULL, NULL, all, workspace, &answer), PCM_BAD_INPUT, "reflection");
  EXPECT(pcm_copy_elements(workspace, &element, 1, &error), PCM_BAD_CALL, "no answer");
  pcm_pairing_dispose(pairing);
  pcm_workspace_dispose(workspace);
  pcm_workspace_dispose(NULL);
}

// Longer than a pcm_error, of characters of three bytes: without the middle, cut between two of them, with the reason.
static void test_long_texts(void) {
  char path[4096] = "";
  for (int i = 0; i < 900; ++i) strcat(path, "\xe2\x82\xac");
  strcat(path, ".obj");
  pcm_surface* surface;
  EXPECT(pcm_surface_read(path, &surface, &error), PCM_BAD_INPUT, "\xe2\x82\xac");
  const size_t length = strlen(error.text);
  EXPECT_TRUE(length > sizeof error.text - 7 && length < sizeof error.text);
  EXPECT_TRUE(strstr(error.text, "\xac [...] \xe2") != NULL);
  EXPECT_TRUE(strstr(error.text, ".obj: ") != NULL && error.text[length - 1] != '\xac');
}

// A line end, and bytes that are no UTF-8: not begun, not ended, longer than needed, a surrogate, beyond the last.
static void test_texts_that_are_no_line_of_utf8(void) {
  pcm_surface* surface;
  EXPECT(pcm_surface_read("a\tb\x7f\xc2\x85\xe2\x80\xa8.obj", &surface, &error), PCM_BAD_INPUT, "a?b???.obj: ");
  EXPECT(pcm_surface_read("a\nb\x80\xc3.obj", &surface, &error), PCM_BAD_INPUT, "a?b??.obj: ");
  EXPECT(pcm_surface_read("\xc0\xaf\xe0\x80\xaf\xed\xa0\x80\xf4\x90\x80\x80.obj", &surface, &error), PCM_BAD_INPUT,
         "????????????.obj: ");
  EXPECT(pcm_surface_read("\xc3\xa4\xf0\x9f\x98\x80.obj", &surface, &error), PCM_BAD_INPUT,
         "\xc3\xa4\xf0\x9f\x98\x80.obj: ");
}

int main(void) {
  EXPECT_TRUE(pcm_abi_version() == PCM_ABI_VERSION && strlen(pcm_version()) >= 5);
  test_surfaces();
  test_copies_of_surfaces();
  test_laws_and_pairings();
  test_evaluations();
  test_long_texts();
  test_texts_that_are_no_line_of_utf8();
  printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
