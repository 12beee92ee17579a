// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "compare/contact/contact_record.h"
#include "compare/contact/csv_row.h"
#include "compare/contact/placed_surfaces.h"
#include "compare/poses/poses_file.h"

namespace pcm::compare {

/// The contact at one state as a row; `pose` is its number, from 1. Of polygons that were not wanted nothing is told.
CsvRow pose_row(std::int64_t pose, const State& state, const ContactRecord& record, bool with_polygons);

/// One of its elements.
CsvRow element_row(std::int64_t pose, const fast::Element& element, const Eigen::Vector3d& face_centroid_Me);

}  // namespace pcm::compare
