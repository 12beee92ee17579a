// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The C interface's functions: each reads its arguments, asks the engine, writes its results.
#include "pcm/pcm.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/guard.h"
#include "bindings/c/inputs.h"
#include "bindings/c/sized.h"
#include "pcm/engine.h"
#include "pcm/read_mesh.h"
#include "pcm/version.h"

// What the opaque handles of the header are.
struct pcm_surface {
  pcm::fast::Surface surface;
};

struct pcm_pairing {
  pcm::fast::Pairing pairing;
};

struct pcm_workspace {
  pcm::fast::Workspace workspace;
  const pcm::fast::Contact* answer = nullptr;  ///< the last one, in `workspace`, where there is one
};

namespace {

using pcm::c::BadCall;
using pcm::c::given;
using pcm::c::guarded;

/// Makes a handle, or leaves it NULL.
template <class Handle, class Make>
pcm_status define(Handle** handle, pcm_error* error, const Make& make) {
  if (handle != nullptr) *handle = nullptr;
  return guarded(error, [&] {
    Handle*& made = given(handle, "where the handle is to be written");  // before there is what could be lost
    made = make().release();
  });
}

void require_room(const char* what, std::size_t size, std::size_t capacity) {
  if (capacity < size) {
    throw BadCall(std::string("there is room for ") + std::to_string(capacity) + " " + what + ", where there are " +
                  std::to_string(size));
  }
}

const pcm::fast::Contact& last_answer(const pcm_workspace* workspace) {
  const pcm::fast::Contact* answer = given(workspace, "workspace").answer;
  if (answer == nullptr) throw BadCall("the workspace has no answer: nothing was evaluated, or not with success");
  return *answer;
}

template <class List, class Entry>
void copy_out(const char* what, const List& list, Entry* to, std::size_t capacity) {
  require_room(what, list.size(), capacity);
  if (list.empty()) return;
  std::transform(list.begin(), list.end(), &given(to, what), [](const auto& entry) { return pcm::c::entry_of(entry); });
}

const std::vector<pcm::Index>& active_faces(const pcm::fast::Contact& contact, pcm::Side side, std::int32_t kind) {
  if (kind != PCM_INTERSECTED && kind != PCM_INNER)
    throw BadCall(std::string("kind is ") + std::to_string(kind) + "; it must be PCM_INTERSECTED or PCM_INNER");
  const pcm::fast::ActiveArea& area = side == pcm::Side::E ? contact.E : contact.F;
  return kind == PCM_INTERSECTED ? area.intersected : area.inner;
}

}  // namespace

int32_t pcm_abi_version(void) {
  return PCM_ABI_VERSION;
}

const char* pcm_version(void) {
  return PCM_VERSION;
}

// Surfaces ------------------------------------------------------------------------------------------------------------

pcm_status pcm_surface_define(const double* vertices, size_t vertex_count, const int32_t* faces, size_t face_count,
                              pcm_surface** surface, pcm_error* error) {
  return define(surface, error, [&] {
    return std::make_unique<pcm_surface>(
        pcm_surface{pcm::fast::Surface(pcm::c::mesh_from(vertices, vertex_count, faces, face_count))});
  });
}

pcm_status pcm_surface_read(const char* path, pcm_surface** surface, pcm_error* error) {
  return define(surface, error, [&] {
    return std::make_unique<pcm_surface>(pcm_surface{pcm::fast::Surface(pcm::read_mesh(&given(path, "path")))});
  });
}

pcm_status pcm_surface_counts(const pcm_surface* surface, size_t* vertex_count, size_t* face_count, int32_t* closed,
                              pcm_error* error) {
  return guarded(error, [&] {
    const pcm::fast::Surface& counted = given(surface, "surface").surface;
    if (vertex_count != nullptr) *vertex_count = counted.mesh().vertices.size();
    if (face_count != nullptr) *face_count = counted.mesh().faces.size();
    if (closed != nullptr) *closed = counted.closed();
  });
}

pcm_status pcm_surface_copy(const pcm_surface* surface, double* vertices, size_t vertex_capacity, int32_t* faces,
                            size_t face_capacity, pcm_error* error) {
  return guarded(error, [&] {
    const pcm::TriangleMesh& mesh = given(surface, "surface").surface.mesh();
    if (vertices != nullptr) require_room("vertices", mesh.vertices.size(), vertex_capacity);
    if (faces != nullptr) require_room("faces", mesh.faces.size(), face_capacity);
    if (vertices != nullptr) {
      for (const Eigen::Vector3d& vertex : mesh.vertices) vertices = std::copy_n(vertex.data(), 3, vertices);
    }
    if (faces != nullptr) {
      for (const pcm::Triangle& face : mesh.faces) faces = std::copy(face.begin(), face.end(), faces);
    }
  });
}

void pcm_surface_dispose(pcm_surface* surface) {
  delete surface;
}

// Pairings ------------------------------------------------------------------------------------------------------------

pcm_status pcm_law_init(pcm_law* law, size_t size, pcm_error* error) {
  return guarded(error, [&] {
    given(law, "law");
    pcm::c::write_sized(pcm::c::default_law(), pcm::c::known_size<pcm_law>(size, "law"), law);
  });
}

pcm_status pcm_pairing_define(const pcm_surface* E, const pcm_surface* F, const pcm_law* law, int32_t mode,
                              int32_t scheme, pcm_pairing** pairing, pcm_error* error) {
  return define(pairing, error, [&] {
    const pcm::fast::Surface& surface_E = given(E, "E").surface;
    const pcm::fast::Surface& surface_F = given(F, "F").surface;
    const pcm_law whole_law = pcm::c::read_sized(law, pcm::c::default_law(), "law");
    return std::make_unique<pcm_pairing>(pcm_pairing{pcm::fast::Pairing(
        surface_E, surface_F, pcm::c::law_from(whole_law), pcm::c::mode_from(mode), pcm::c::scheme_from(scheme))});
  });
}

void pcm_pairing_dispose(pcm_pairing* pairing) {
  delete pairing;
}

// Evaluation ----------------------------------------------------------------------------------------------------------

pcm_status pcm_workspace_define(pcm_workspace** workspace, pcm_error* error) {
  return define(workspace, error, [] { return std::make_unique<pcm_workspace>(); });
}

void pcm_workspace_dispose(pcm_workspace* workspace) {
  delete workspace;
}

pcm_status pcm_evaluate(const pcm_pairing* pairing, const double* A, const double* r, const double* v, const double* w,
                        uint32_t wanted, pcm_workspace* workspace, pcm_answer* answer, pcm_error* error) {
  if (workspace != nullptr) workspace->answer = nullptr;
  return guarded(error, [&] {
    given(workspace, "workspace");
    const std::size_t size = pcm::c::known_size<pcm_answer>(given(answer, "answer").size, "answer");
    const pcm::fast::Contact& contact =
        pcm::fast::evaluate(given(pairing, "pairing").pairing, pcm::c::pose_from(A, r), pcm::c::velocity_from(v, w),
                            pcm::c::wanted_from(wanted), workspace->workspace);
    pcm::c::write_sized(pcm::c::answer_of(contact), size, answer);
    workspace->answer = &contact;
  });
}

pcm_status pcm_copy_elements(const pcm_workspace* workspace, pcm_element* elements, size_t capacity, pcm_error* error) {
  return guarded(error, [&] { copy_out("elements", last_answer(workspace).elements, elements, capacity); });
}

pcm_status pcm_copy_polygons(const pcm_workspace* workspace, pcm_polygon* polygons, size_t capacity, pcm_error* error) {
  return guarded(error, [&] { copy_out("polygons", last_answer(workspace).polygons, polygons, capacity); });
}

pcm_status pcm_copy_crossings(const pcm_workspace* workspace, pcm_crossing* crossings, size_t capacity,
                              pcm_error* error) {
  return guarded(error, [&] { copy_out("crossings", last_answer(workspace).crossings, crossings, capacity); });
}

pcm_status pcm_copy_faces(const pcm_workspace* workspace, int32_t side, int32_t kind, int32_t* faces, size_t capacity,
                          pcm_error* error) {
  return guarded(error, [&] {
    const pcm::fast::Contact& contact = last_answer(workspace);
    copy_out("faces", active_faces(contact, pcm::c::side_from(side), kind), faces, capacity);
  });
}

pcm_status pcm_copy_tangent(const pcm_workspace* workspace, double* tangent, size_t capacity, pcm_error* error) {
  return guarded(error, [&] {
    const std::optional<pcm::fast::Tangent>& answered = last_answer(workspace).tangent;
    if (!answered) throw BadCall("the answer has no tangent: it was not asked for PCM_WANTED_TANGENT");
    require_room("numbers of a tangent", static_cast<std::size_t>(answered->size()), capacity);
    Eigen::Map<Eigen::Matrix<double, 6, 12, Eigen::RowMajor>>(&given(tangent, "tangent")) = *answered;
  });
}
