// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/noted_interrupt.h"

#include <csignal>

namespace pcm::compare {
namespace {

/// A signal can't reach anything else.
volatile std::sig_atomic_t noted_interrupt = 0;

void handle_interrupts_by(void (*handler)(int)) {
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

void note_interrupt(int /*signal*/) {
  noted_interrupt = 1;
  handle_interrupts_by(SIG_DFL);
}

}  // namespace

NotedInterrupt::NotedInterrupt() {
  handle_interrupts_by(note_interrupt);
}

NotedInterrupt::~NotedInterrupt() {
  handle_interrupts_by(SIG_DFL);
}

bool NotedInterrupt::interrupted() const {
  return noted_interrupt != 0;
}

}  // namespace pcm::compare
