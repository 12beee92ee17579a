#!/bin/sh
# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
# check_symbols.sh NM LIBRARY HEADER: the library shows the functions that the header declares, and nothing else.
set -eu
shown=$("$1" --dynamic --defined-only --extern-only "$2" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort)
declared=$(sed -n 's/^PCM_API .*[ *]\(pcm_[a-z_]*\)(.*/\1/p' "$3" | sort)
[ "$(echo "$declared" | wc -l)" -ge 10 ] || { echo "hardly a function is declared in $3"; exit 1; }
[ "$shown" = "$declared" ] && exit 0
printf 'shown:\n%s\ndeclared:\n%s\n' "$shown" "$declared"
exit 1
