// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In place of the files of the page that are compiled in: those of a program that was built without three.js.
#include "simulate/page/page_files.h"

namespace pcm::simulate {

const PageFiles& page_files() {
  static const PageFiles files{};
  return files;
}

}  // namespace pcm::simulate
