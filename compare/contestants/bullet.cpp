// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contestants/contestant.h"
#include "compare/peers/bullet_pair.h"

int main() {
  using namespace pcm::compare;
  return converse_as<TouchContestant<BulletPair>>();
}
