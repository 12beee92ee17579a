// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contestants/contestant.h"
#include "compare/peers/ode_pair.h"

/// Contact points are merged where they are alike.
int main() {
  using namespace pcm::compare;
  const OpenOde open;
  return converse_as<TouchContestant<OdePair>>();
}
