// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/stills.h"

#include <algorithm>

#include "meshes/files/text_file.h"
#include "simulate/page/check_recording.h"
#include "simulate/scenes/still_instants.h"
#include "simulate/stills/picture.h"
#include "simulate/stills/png.h"

namespace pcm::simulate {

const Frame& frame_next_to(double t, const std::vector<Frame>& frames) {
  const auto after = std::find_if(frames.begin() + 1, frames.end(), [t](const Frame& frame) { return frame.t >= t; });
  if (after == frames.end()) return frames.back();
  const auto before = after - 1;
  return t - before->t <= after->t - t ? *before : *after;
}

std::vector<std::filesystem::path> write_stills(const std::filesystem::path& folder, const Recording& recording,
                                                const std::vector<double>& instants) {
  check_recording(recording);
  const RunView view = view_of(recording);
  std::vector<std::filesystem::path> files;
  for (const double t : instants) {
    files.push_back(folder / still_name(t));
    // Binary, and whole or not there, as text is written too.
    write_text_file(files.back(), png_bytes(picture(recording, frame_next_to(t, recording.frames), view)));
  }
  return files;
}

}  // namespace pcm::simulate
