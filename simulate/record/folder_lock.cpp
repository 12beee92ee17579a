// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "pcm/bad_input.h"

namespace pcm::simulate {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(open((folder / kFolderLock).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ == -1)
    throw BadInput((folder / kFolderLock).string() + ": can't be written: " + std::generic_category().message(errno));
  if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(file_);
  throw BadInput(folder.string() +
                 ": another pcm simulate is writing there; wait for its end, or choose another folder");
}

FolderLock::~FolderLock() {
  close(file_);
}

}  // namespace pcm::simulate
