// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "simulate/record/recording.h"

namespace pcm::simulate {

/// A recorded simulation as one HTML page that needs nothing else: no network, no other file. It shows the scene in 3D
/// (by three.js, which is in it, under its MIT licence) and the series as plots, played, paused and scrubbed together.
///
/// Coordinates, pressures and series are rounded to floats: the page is for looking at, not for computing on. Times of
/// frames stay doubles.
///
/// For programs that drive the page: `#t=1.25` at the end of its address opens it paused at that instant;
/// `window.pcmReady` becomes true once the first frame is drawn; `window.pcmTime` is the instant shown, s;
/// `window.pcmProject([x, y, z])` is where a point of W lies in the window, px; `window.pcmArrowLength()` is that of
/// arrows, m/N.
///
/// Throws BadInput where there is nothing to show (no surface, no frame), where the recording contradicts itself
/// (check_recording.h), and where the program was built without three.js.
std::string page(const Recording& recording);

/// Throws BadInput where the program was built without three.js: for who wants to know before there is a recording.
void require_three_js();

/// Writes that page; throws BadInput also where the file can't be written.
void write_page(const std::filesystem::path& file, const Recording& recording);

}  // namespace pcm::simulate
