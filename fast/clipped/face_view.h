// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fast/base/fast_clear_array.h"
#include "fast/posed/posed_pair.h"
#include "fast/prism/master_prism.h"
#include "fast/surface/own_sights.h"

namespace pcm::fast {

/// What the penetration lines of one master face meet. Its memory is kept from face to face.
struct FaceView {
  /// Faces of the slave, ascending: all that a prism may meet which is wider by `listed_wider_by`, m. Where there is
  /// none down to a depth by which the lines surely have left the master, deeper ones are not listed.
  std::vector<Index> slave_listed;
  double listed_wider_by = 0;
  double listed_to_depth = 0;               ///< that depth, m; infinite where all are listed
  FastClearArray<PrismPoint> slave_sights;  ///< by vertex of the slave: of all faces listed
  /// The slave's faces, then other ones of the master where these may lie before, ascending.
  std::vector<ProjectedFace> faces;
  /// The master's other faces were looked for down to this depth; -1 where it is known to be thick enough without, m.
  double own_depth = -1;
  /// The line of the barycentre may leave the slave, and it may meet another face of the master.
  bool slave_at_barycentre = false;
  bool own_at_barycentre = false;
};

/// Scratch memory of look_through.
struct FaceViewScratch {
  std::vector<Index> own_listed;  ///< other faces of the master near the prism
  std::vector<Index> open;        ///< of the search for faces
  std::vector<Index> over;        ///< listed faces of the slave that some line may meet
  std::vector<Index> entered;     ///< faces of the slave that the lines certainly enter
};

/// Looks through the prism of a master face. `nested`: a component of one surface lies in the other without crossing,
/// so that whole bodies may see nothing. Said or not, the answer is the same but for bounds, and for strips of rounding
/// size that several slivers of the master's own sheet hide from it together: where lines surely have left, there are
/// none.
void look_through(PosedPair& posed, Side master, Index face, const MasterPrism& prism, bool nested,
                  FaceViewScratch& scratch, FaceView& view);

/// What a master face sees of a face of the slave through which the lines leave, whatever lies before it: only where
/// that has an area for certain does it carry an element.
enum class SeenArea : std::uint8_t { none, uncertain, certain };
SeenArea seen_area(PosedPair& posed, Side master, const MasterPrism& prism, Index slave_face);

/// Whether other faces of the master may lie before what one of its faces sees.
enum class OwnFacesBefore : std::uint8_t {
  none,     ///< surely none
  leaning,  ///< only as faces that stand upright on the border of the prism lean over it in the exact problem
  some
};

/// As the face's thickness says it, for whatever is seen no deeper than this, m: in the rounded problem
/// and in the exact one.
OwnFacesBefore own_faces_before(const PosedPair& posed, Side master, const FaceGeometry& geometry, Index face,
                                double deepest);

/// The corners of another face of the master as one of its faces sees them.
SeenCorners own_corners(PosedSurface& master, Index face, OwnSights& sights, WorkCounters& work);

}  // namespace pcm::fast
