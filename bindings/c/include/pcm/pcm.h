// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The engine for C (C99), and for every language that calls C. Three tasks, as in the paper: define a pairing of two
// surfaces, evaluate it for as many states as wanted, dispose of it. docs/languages.md has an example, docs/PCM.md the
// model.
//
// Units are SI. Bodies E and F carry the markers Me and Mf; what ends in _Me is resolved in Me. Vertices and faces are
// numbered from 0, in the order they were given in or stand in their file.
//
// Errors: what can fail returns a status, writes why into the caller's pcm_error, and then changes nothing else but for
// setting a handle that it would have made to NULL, and for a workspace's last answer, which pcm_evaluate forgets.
// Nothing is thrown, printed or kept in global state.
//
// Threads: surfaces and pairings never change and may be shared; a workspace is for one thread at a time.
//
// Growth: pcm_law and pcm_answer begin with their size. They grow at their ends only, and the library knows by their
// size what the caller knows of them, so that it serves programs compiled with older headers. All other structs stay.
#ifndef PCM_PCM_H
#define PCM_PCM_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define PCM_API __attribute__((visibility("default")))
#else
#define PCM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// Raised where programs that use this header have to be compiled anew. The library's soname ends in it.
#define PCM_ABI_VERSION 1

/// The library's own PCM_ABI_VERSION and its version, such as "0.1.0".
PCM_API int32_t pcm_abi_version(void);
PCM_API const char* pcm_version(void);

/// What became of a call.
typedef int32_t pcm_status;
enum {
  PCM_OK = 0,
  PCM_BAD_INPUT = 1,       ///< a surface, law, pose or file that the user can mend
  PCM_BAD_CALL = 2,        ///< a call that the programmer can mend: a null pointer, an unknown size or flag
  PCM_OUT_OF_MEMORY = 3,   ///< memory ended
  PCM_INTERNAL_ERROR = 4,  ///< a bug of ours
};

/// Why a call failed, as one line of UTF-8 that ends in a zero byte: `?` stands for bytes that are no UTF-8 and for
/// control characters, ` [...] ` for the middle of what is too long. Empty where the call did not fail. Wherever a
/// pcm_error is passed it may be NULL.
typedef struct pcm_error {
  char text[1024];
} pcm_error;

// Surfaces -----------------------------------------------------------------------------------------------------------

/// A surface, checked and prepared for contact.
typedef struct pcm_surface pcm_surface;

/// From `vertex_count` vertices, three coordinates each, m, and `face_count` triangles, three vertex numbers each,
/// counterclockwise seen from outside the body. Both arrays are copied. PCM_BAD_INPUT where the surface is unfit for
/// contact (PCM section 2). Arrays count vertices and faces from 0, error texts from 1, as OBJ files do.
PCM_API pcm_status pcm_surface_define(const double* vertices, size_t vertex_count, const int32_t* faces,
                                      size_t face_count, pcm_surface** surface, pcm_error* error);

/// From a file, .obj or .off, whose coordinates are metres.
PCM_API pcm_status pcm_surface_read(const char* path, pcm_surface** surface, pcm_error* error);

/// How many vertices and faces it has; `closed` is 1 where it has no border, else 0. Each may be NULL.
PCM_API pcm_status pcm_surface_counts(const pcm_surface* surface, size_t* vertex_count, size_t* face_count,
                                      int32_t* closed, pcm_error* error);

/// Copies out what pcm_surface_define takes. Each array may be NULL, and has room for so many vertices or faces, which
/// must be enough.
PCM_API pcm_status pcm_surface_copy(const pcm_surface* surface, double* vertices, size_t vertex_capacity,
                                    int32_t* faces, size_t face_capacity, pcm_error* error);

/// Pairings made of it go on. NULL is disposed of already.
PCM_API void pcm_surface_dispose(pcm_surface* surface);

// Pairings -----------------------------------------------------------------------------------------------------------

/// Names of the two surfaces of a pairing.
enum { PCM_E = 0, PCM_F = 1 };

/// Whose faces carry the contact elements; both: each in turn, force and torque averaged.
enum { PCM_MODE_E = 0, PCM_MODE_F = 1, PCM_MODE_BOTH = 2 };

/// How the elastic foundation of a master face is sampled (PCM section 6): at its barycentre, as in the paper, or
/// integrated over it.
enum { PCM_BARYCENTRIC = 0, PCM_CLIPPED = 1 };

/// What damping may do to an element's normal force: never draw, (18); draw as well; act while approaching only.
enum { PCM_DAMPING_NO_TENSION = 0, PCM_DAMPING_FULL = 1, PCM_DAMPING_COMPRESSION = 2 };

/// Parameters of the force law (PCM section 7). All finite and not negative unless said; 0 by default unless said.
typedef struct pcm_law {
  size_t size;               ///< sizeof(pcm_law)
  double stiffness;          ///< c_l, N/m^3, > 0; 1e6 by default
  double layer_stiffness_E;  ///< c_E and c_F, N/m^3, > 0, infinite for a rigid body but not for both: in series they
  double layer_stiffness_F;  ///< take the place of `stiffness` (12). Both 0, the default: not given.
  double damping;            ///< d_l, N s/m^3
  double transition_depth;   ///< u_d, m: damping fades in up to this penetration (15); 0 turns the fade off
  double friction;           ///< mu
  double slip_velocity;      ///< v_eps, m/s: friction is regularised below it (20)
  double max_penetration;    ///< m, > 0; infinite by default. Deeper is clamped, point by point, and flagged.
  int32_t damping_mode;      ///< PCM_DAMPING_...
  int32_t reserved;          ///< 0
} pcm_law;

/// Fills in the defaults. `size` is sizeof(pcm_law).
PCM_API pcm_status pcm_law_init(pcm_law* law, size_t size, pcm_error* error);

/// Two surfaces with the law between them.
typedef struct pcm_pairing pcm_pairing;

/// `mode` is PCM_MODE_..., `scheme` PCM_BARYCENTRIC or PCM_CLIPPED. E and F may be one surface. The pairing needs
/// neither of them nor the law afterwards.
PCM_API pcm_status pcm_pairing_define(const pcm_surface* E, const pcm_surface* F, const pcm_law* law, int32_t mode,
                                      int32_t scheme, pcm_pairing** pairing, pcm_error* error);

/// NULL is disposed of already.
PCM_API void pcm_pairing_dispose(pcm_pairing* pairing);

// Evaluation ---------------------------------------------------------------------------------------------------------

/// Scratch memory and the last answer's lists; one for each thread, whatever the pairing. It grows to what the poses
/// need.
typedef struct pcm_workspace pcm_workspace;

PCM_API pcm_status pcm_workspace_define(pcm_workspace** workspace, pcm_error* error);

/// NULL is disposed of already.
PCM_API void pcm_workspace_dispose(pcm_workspace* workspace);

/// What is wanted, added up; nothing else is computed. None of them: only whether the surfaces touch.
enum {
  PCM_WANTED_POLYGONS = 1,     ///< intersection polygons and patches
  PCM_WANTED_AREAS = 2,        ///< clipped active areas and the volume of the intersection
  PCM_WANTED_FORCE = 4,        ///< contact elements, force and torque
  PCM_WANTED_ELEMENTS = 8,     ///< keep the elements, to be copied out, with their statistics; implies FORCE
  PCM_WANTED_BOUND = 16,       ///< rigorous bounds on the rounding errors of force and torque; implies PCM_WANTED_FORCE
  PCM_WANTED_STATISTICS = 32,  ///< the summary over the elements; implies PCM_WANTED_FORCE
  PCM_WANTED_TANGENT = 64,     ///< derivatives of force and torque, to be copied out; implies FORCE
};

/// What the contact is on one of the surfaces. Numbers of faces are given wherever anything but touch is wanted.
typedef struct pcm_active_area {
  double area;               ///< of its part inside the other body, m^2
  double vector_area_Me[3];  ///< integral of the outward normal over that part, m^2
  int32_t intersected;       ///< number of its faces that the other surface crosses
  int32_t inner;             ///< number of its faces that lie inside the other body
} pcm_active_area;

/// Bounds on |computed - true|, component by component, the truth being that of the real numbers which the pose's
/// doubles are: the rounding of F's vertices is included.
typedef struct pcm_bound {
  double force_Me[3];           ///< N
  double torque_Me[3];          ///< N m
  double penetration_at_least;  ///< m; the true greatest penetration lies between these two
  double penetration_at_most;   ///< m
  int32_t given;                ///< 1 where it was wanted, else 0
  int32_t flipped;              ///< 1 where a discrete decision may be another one, so that the bound is great
} pcm_bound;

/// Summary over the elements; all zero where there is none.
typedef struct pcm_statistics {
  double patch_area;                ///< sum of A_k, m^2
  double mean_penetration;          ///< area-weighted, m
  double max_pressure;              ///< greatest F_n / A_k, Pa
  double mean_pressure;             ///< area-weighted, Pa
  double max_normal_velocity;       ///< greatest |v_n|, m/s
  double max_tangential_velocity;   ///< greatest v_t, m/s
  double centre_of_pressure_Me[3];  ///< C_k weighted by F_n, m; 0 unless these sum to > 0
} pcm_statistics;

/// The answer at one state. What was not wanted is zero: all but `touching` where only that was asked for.
typedef struct pcm_answer {
  size_t size;                   ///< sizeof(pcm_answer), set by the caller
  int32_t touching;              ///< 1 where the surfaces cross, else 0; so with all flags
  int32_t nested;                ///< a part of one lies in the other uncrossed: no force, unless open or about a cavity
  int32_t ambiguous;             ///< an open surface labels faces both ways (PCM section 5)
  int32_t has_volume;            ///< 0 where a surface is open or the answer is ambiguous
  int32_t penetration_exceeded;  ///< deeper than the law's max_penetration
  int32_t too_deep;              ///< number of faces without a force: the body is thinner there than the penetration
  int32_t undefined_areas;       ///< number of faces whose area counts as 0: a border of the other surface ends there
  int32_t patches;               ///< number of contacts; borders that only the inside of a face joins count apart
  int32_t polygons;              ///< number of polygons to be copied out
  int32_t crossings;             ///< number of their points
  int32_t element_count;         ///< number of elements
  int32_t elements;              ///< number of elements to be copied out: all, or none where they were not wanted
  double force_Me[3];            ///< on body E, N
  double torque_Me[3];           ///< on body E about the origin of Mf, N m
  double max_penetration;        ///< greatest u, before clamping, m
  double volume;                 ///< of the intersection, m^3
  pcm_active_area E;
  pcm_active_area F;
  pcm_bound bound;
  pcm_statistics statistics;
} pcm_answer;

/// Evaluates the pairing at one state. F's points lie at x_E = A x_F + r: A, 9 numbers BY ROWS, is a rotation to 1e-9
/// and is used as given; r, 3 numbers, m. v = dr/dt seen in Me, m/s, and w, the angular velocity of F relative to E,
/// rad/s, are resolved in Me; NULL is 0. `wanted` is a sum of flags. Where it fails the workspace is left without an
/// answer.
PCM_API pcm_status pcm_evaluate(const pcm_pairing* pairing, const double* A, const double* r, const double* v,
                                const double* w, uint32_t wanted, pcm_workspace* workspace, pcm_answer* answer,
                                pcm_error* error);

// Lists of the last answer, copied into arrays of the caller with room for `capacity` entries; PCM_BAD_CALL where that
// is less than the list has, or where there is no answer.

/// A contact element: a master face and the slave face that its penetration lines leave through.
typedef struct pcm_element {
  int32_t master;  ///< PCM_E or PCM_F
  int32_t master_face;
  int32_t slave_face;
  int32_t reserved;            ///< 0
  double area;                 ///< A_k, m^2
  double penetration;          ///< u_k, clamped, m
  double normal_velocity;      ///< v_n, m/s, positive when approaching
  double tangential_velocity;  ///< v_t, m/s
  double normal_force;         ///< F_n, N
  double tangential_force;     ///< F_t, N
  double normal_Me[3];         ///< n_k, minus the normal of the master face
  double position_Me[3];       ///< C_k, m
  double force_Me[3];          ///< on body E, N (not halved in mode both)
} pcm_element;

/// By master (E first), then master face, then slave face.
PCM_API pcm_status pcm_copy_elements(const pcm_workspace* workspace, pcm_element* elements, size_t capacity,
                                     pcm_error* error);

/// An intersection polygon: `count` crossings from number `first` on, E's part inside F on the left seen from outside
/// E. A closed polygon's first point is not repeated.
typedef struct pcm_polygon {
  int32_t closed;  ///< 1, or 0 where it ends at borders
  int32_t first;
  int32_t count;
  int32_t patch;  ///< which contact it bounds, from 0
} pcm_polygon;

PCM_API pcm_status pcm_copy_polygons(const pcm_workspace* workspace, pcm_polygon* polygons, size_t capacity,
                                     pcm_error* error);

/// A point of a polygon: an edge of one surface passes through a face of the other.
typedef struct pcm_crossing {
  int32_t edge_side;  ///< whose edge it is, PCM_E or PCM_F; the face is the other's
  int32_t edge[2];    ///< its end vertices, the smaller number first
  int32_t face;
  double position_Me[3];  ///< m
} pcm_crossing;

PCM_API pcm_status pcm_copy_crossings(const pcm_workspace* workspace, pcm_crossing* crossings, size_t capacity,
                                      pcm_error* error);

/// Kinds of active faces: those that the other surface crosses, and those that lie inside the other body uncrossed.
enum { PCM_INTERSECTED = 0, PCM_INNER = 1 };

/// The active faces of a kind on one surface, PCM_E or PCM_F, ascending.
PCM_API pcm_status pcm_copy_faces(const pcm_workspace* workspace, int32_t side, int32_t kind, int32_t* faces,
                                  size_t capacity, pcm_error* error);

/// The derivatives of force and torque, 6 x 12 numbers BY ROWS: force_Me, then torque_Me, by r, m; by a turn of F about
/// Mf, rad; by v, m/s; by w, rad/s; all resolved in Me. At a kink of the law they are those of one side, and discrete
/// facts stay as they are (docs/PCM.md section 7.1). PCM_BAD_CALL where the last answer has none.
PCM_API pcm_status pcm_copy_tangent(const pcm_workspace* workspace, double* tangent, size_t capacity, pcm_error* error);

#ifdef __cplusplus
}
#endif

#endif
