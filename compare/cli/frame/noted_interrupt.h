// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pcm::compare {

/// While it lives the first SIGINT or SIGTERM is only noted; a second signal, either of the two, ends the program.
class NotedInterrupt {
 public:
  NotedInterrupt();
  NotedInterrupt(const NotedInterrupt&) = delete;
  NotedInterrupt& operator=(const NotedInterrupt&) = delete;
  ~NotedInterrupt();

  /// Once noted it stays, also for others of this class.
  bool interrupted() const;
};

}  // namespace pcm::compare
