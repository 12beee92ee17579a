#!/bin/sh
# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
# with_pkg_config.sh COMPILER PREFIX SOURCE SURFACE: builds the consumer with what pcm.pc in the prefix says, and runs it.
set -eu
PKG_CONFIG_PATH=$(dirname "$(find "$2" -name pcm.pc)")
export PKG_CONFIG_PATH
flags=$(pkg-config --cflags --libs pcm)
# shellcheck disable=SC2086 # a list of words
"$1" -std=c++17 -ffast-math "$3" $flags -o with_pkg_config
exec ./with_pkg_config "$4"
