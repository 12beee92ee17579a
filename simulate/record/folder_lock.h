// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace pcm::simulate {

/// An empty file in the folder of a run. It is made before any other and stays.
inline constexpr const char* kFolderLock = ".pcm-simulate.lock";

/// Keeps a folder for one run, until this object or its process ends, however it does. Where the file system knows no
/// locks, it keeps nobody out.
class FolderLock {
 public:
  /// Throws BadInput where another one keeps the folder, or nothing can be written there.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int file_;  ///< a descriptor
};

}  // namespace pcm::simulate
