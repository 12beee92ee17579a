// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace pcm::compare {

/// The JSON schema (draft 7) of a line of poses.jsonl: pose.schema.json.
std::string_view pose_schema();
/// Of a line of answers: answer.schema.json.
std::string_view answer_schema();

}  // namespace pcm::compare
