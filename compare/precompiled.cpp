// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Carries the precompiled headers of this room, see CMakeLists.txt; nothing else.
