// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/scene_counters.h"

#include <cstddef>
#include <vector>

#include "compare/verify/routes/contact_fields.h"

namespace pcm::compare {

void hold_counters(const fast::SceneCounters& counters, const fast::WorkCounters& work_of_answer, Checks& checks) {
  checks.checked(Kind::work);
  const std::int64_t evaluated = counters.evaluated;
  if (counters.apart_by_boxes + counters.apart_by_certificate + evaluated != 1 || evaluated < 0 ||
      counters.apart_by_boxes < 0 || counters.apart_by_certificate < 0)
    checks.add(Kind::work, "scene: evaluated {} times, apart by boxes {} times, by a certificate {} times", evaluated,
               counters.apart_by_boxes, counters.apart_by_certificate);
  if (counters.certificates_sought < 0 || counters.certificates_sought > evaluated)
    checks.add(Kind::work, "scene: {} certificates sought after {} evaluations", counters.certificates_sought,
               evaluated);
  std::vector<std::int64_t> expected;
  fields::visit_work(evaluated == 0 ? fast::WorkCounters() : work_of_answer,
                     [&](const Field&, std::int64_t count) { expected.push_back(count); });
  std::size_t i = 0;
  fields::visit_work(counters.work, [&](const Field& field, std::int64_t count) {
    const std::int64_t of_answer = expected[i++];
    const bool holds = counters.certificates_sought == 0 ? count == of_answer : count >= of_answer;
    if (!holds) checks.add(Kind::work, "scene: {} is {}, that of its answer {}", field.name, count, of_answer);
  });
}

}  // namespace pcm::compare
