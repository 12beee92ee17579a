#!/bin/sh
# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
# c_with_pkg_config.sh COMPILER PREFIX SOURCE SURFACE: builds the consumer in C with what pcm-c.pc in the prefix says, and
# runs it.
set -eu
PKG_CONFIG_PATH=$(dirname "$(find "$2" -name pcm-c.pc)")
LD_LIBRARY_PATH=$(dirname "$PKG_CONFIG_PATH")
export PKG_CONFIG_PATH LD_LIBRARY_PATH
flags=$(pkg-config --cflags --libs pcm-c)
# shellcheck disable=SC2086 # a list of words
"$1" -std=c99 "$3" $flags -o c_with_pkg_config
exec ./c_with_pkg_config "$4"
