# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults chosen where somebody who knows the engine would look first: file, text, text in its place, what it breaks.

Each text occurs exactly once in its file; a test holds that, so that the list does not rot.
"""

PICKED = [
    # Signs of four points: the filter, the exact stage, the tie rule.
    (
        "fast/predicates/orientation.h",
        "(bycz - bzcy) * dx + (bzcx - bxcz) * dy",
        "(bycz - bzcy) * dx + (bxcz - bzcx) * dy",
        "a cofactor of orient3d",
    ),
    (
        "fast/predicates/orientation.h",
        "kFilterRelative = 9 * 0x1p-53;",
        "kFilterRelative = 4.5 * 0x1p-53;",
        "the filter's constant halved",
    ),
    (
        "fast/predicates/orientation.h",
        "(std::abs(bxcy) + std::abs(bycx) + kFilterUnderflow) * std::abs(dz) + kFilterUnderflow;",
        "0 * std::abs(dz);",
        "a third of the filter's bound",
    ),
    (
        "fast/predicates/orientation.h",
        "(6 * product * extent + kFilterUnderflow)",
        "(1 * product * extent + kFilterUnderflow)",
        "the bound shared by all points of a pair: one of six terms",
    ),
    (
        "fast/predicates/orientation.h",
        "bz * cx - bx * cz, bx * cy - by * cx};",
        "bx * cz - bz * cx, bx * cy - by * cx};",
        "a component of the plane's normal",
    ),
    (
        "fast/predicates/orientation.cpp",
        "{+1, {2, 3, kNone}, {kX, kNone}},         // v2z v1y",
        "{-1, {2, 3, kNone}, {kX, kNone}},         // v2z v1y",
        "one case of the tie rule",
    ),
    (
        "fast/predicates/orientation.cpp",
        "{-1, {3, kNone, kNone}, {kNone, kNone}},  // v3z v2y v1x",
        "{+1, {3, kNone, kNone}, {kNone, kNone}},  // v3z v2y v1x",
        "the last case of the tie rule",
    ),
    (
        "fast/predicates/orientation.cpp",
        "    {+1, {2, 3, kNone}, {kZ, kNone}},         // v2y v1x\n"
        "    {-1, {0, 1, 3}, {kX, kY}},                // v3z\n",
        "    {-1, {0, 1, 3}, {kX, kY}},                // v3z\n"
        "    {+1, {2, 3, kNone}, {kZ, kNone}},         // v2y v1x\n",
        "two cases of the tie rule in the wrong order",
    ),
    (
        "fast/predicates/orientation.cpp",
        "    {-1, {1, 2, 3}, {kX, kY}},                // v1z\n"
        "    {+1, {1, 2, 3}, {kX, kZ}},                // v1y\n",
        "    {+1, {1, 2, 3}, {kX, kZ}},                // v1y\n"
        "    {-1, {1, 2, 3}, {kX, kY}},                // v1z\n",
        "the first two cases of the tie rule in the wrong order",
    ),
    (
        "fast/predicates/orientation.cpp",
        "      parity = -parity;\n",
        "",
        "the parity of the order of ranks",
    ),
    (
        "fast/posed/transform.h",
        "return {vertex_Me(v, work).data(), first_rank_ + v};",
        "return {vertex_Me(v, work).data(), first_rank_ - v};",
        "ranks of vertices descend within a surface",
    ),
    # Crossings and polygons.
    (
        "fast/crossings/crossings.cpp",
        "node.from_above = is_above(above, corner) == surface.runs_forwards(edge_face, corner);",
        "node.from_above = is_above(above, corner);",
        "an edge shared by two faces that run through it in opposite directions",
    ),
    (
        "fast/crossings/pair_signs.h",
        "(is_above(signs.above_E, cyclic_corner(lone_F)) ? 0b0100U : 0b1000U);",
        "(is_above(signs.above_E, cyclic_corner(lone_F)) ? 0b1000U : 0b0100U);",
        "circulation on F: where a segment starts",
    ),
    (
        "fast/crossings/crossings.cpp",
        "    if (table_[at].key == key) return table_[at].value;\n",
        "",
        "an edge shared by two faces is entered as two crossings",
    ),
    (
        "fast/crossings/pair_signs.h",
        "(s[0][0] ^ s[1][0]) << 2 | (s[0][1] ^ s[1][1]) << 3;",
        "(s[0][1] ^ s[1][1]) << 2 | (s[0][0] ^ s[1][0]) << 3;",
        "which edge of F passes through E's face",
    ),
    (
        "fast/crossings/crossings.cpp",
        "list.winding_change += crossing.winding_change();",
        "list.winding_change = crossing.winding_change();",
        "an edge crossed twice",
    ),
    (
        "fast/crossings/crossings.cpp",
        "  capacity_ *= 2;\n  table_.start(capacity_);\n",
        "  capacity_ *= 2;\n  table_.start(capacity_);\n  return;\n",
        "crossings are forgotten as their table grows",
    ),
    (
        "fast/crossings/polygons.cpp",
        "std::rotate(begin, smallest, order.end());",
        "std::rotate(begin, begin, order.end());",
        "where a polygon starts",
    ),
    (
        "fast/crossings/polygons.cpp",
        "if (!nodes[i].has_previous) add(i, false);",
        "if (!nodes[i].has_previous && i < 64) add(i, false);",
        "an open polygon that begins late",
    ),
    (
        "fast/crossings/crossing_positions.cpp",
        "return at_a <= at_b ? Eigen::Vector3d(a + (at_a / sum) * (b - a)) :",
        "return at_a <= at_b ? Eigen::Vector3d(a + (at_b / sum) * (b - a)) :",
        "the share of an edge at which it crosses",
    ),
    # Candidates.
    (
        "fast/simd/overlap.cpp",
        "kBoxRoundings = 64, kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "kBoxRoundings = 1, kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "the margin of boxes in single precision",
    ),
    (
        "fast/simd/overlap.cpp",
        "kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "kPlaneRoundings = 2, kEdgeRoundings = 32;",
        "the margin of planes in single precision",
    ),
    (
        "fast/simd/overlap.cpp",
        "kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "kPlaneRoundings = 128, kEdgeRoundings = 0.5;",
        "the margin of edges in single precision",
    ),
    (
        "fast/simd/overlap.cpp",
        "kBoxRoundings = 64, kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "kBoxRoundings = 0, kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "no margin of boxes in single precision",
    ),
    (
        "fast/simd/overlap.cpp",
        "kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "kPlaneRoundings = 0, kEdgeRoundings = 32;",
        "no margin of planes in single precision",
    ),
    (
        "fast/simd/overlap.cpp",
        "kPlaneRoundings = 128, kEdgeRoundings = 32;",
        "kPlaneRoundings = 128, kEdgeRoundings = 0;",
        "no margin of edges in single precision",
    ),
    (
        "fast/simd/overlap_kernels.h",
        "pairs |= static_cast<LanePairs>(of_E) << (8 * j);\n  }\n  return pairs;\n}\n\n",
        "pairs |= static_cast<LanePairs>(of_E & 0x7fU) << (8 * j);\n  }\n  return pairs;\n}\n\n",
        "the last of eight lanes",
    ),
    (
        "fast/posed/placement.h",
        "width + (placement.position_error_E + margin)) return false;",
        "width + margin) return false;",
        "boxes without their rounding",
    ),
    (
        "fast/posed/transform.h",
        "    done_.start(surface.mesh.vertices.size());\n",
        "    if (!moved_ || pose_.r != pose.r) done_.start(surface.mesh.vertices.size());\n",
        "a stale vertex: those of the pose before stay where F has only turned about its marker",
    ),
    # Active areas.
    (
        "fast/active/winding.cpp",
        "if (above == orientation(face[0], face[1], face[2], z, work)) return 0;",
        "if (above < orientation(face[0], face[1], face[2], z, work)) return 0;",
        "passages of one direction are not seen",
    ),
    (
        "fast/active/winding.cpp",
        "  return above;\n",
        "  return -above;\n",
        "the sign of a passage",
    ),
    (
        "fast/active/active_areas.cpp",
        "if (component_crossed.contains(c)) continue;",
        "if (component_crossed.contains(c) || c > 0) continue;",
        "a lost component: all but the first are never nested",
    ),
    (
        "fast/active/active_areas.cpp",
        "if (surface_.component_faces.items() == 1 && !crossed_.intersected.empty()) return false;",
        "if (!crossed_.intersected.empty()) return false;",
        "a lost component: nested ones beside a crossed one",
    ),
    (
        "fast/active/active_areas.cpp",
        "found_.inner : found_.pockets;\n  list.insert(list.end(), found, found + count);",
        "found_.inner : found_.inner;\n  list.insert(list.end(), found, found + count);",
        "pockets, which the other surface winds about negatively, are taken for inner faces",
    ),
    (
        "fast/active/open_active_areas.cpp",
        "      ambiguous = true;\n      continue;\n",
        "      ambiguous = true;\n",
        "faces of an ambiguous set are labelled all the same",
    ),
    (
        "fast/active/face_shares.h",
        "      for (std::size_t i = range.begin; i < range.end; ++i) visit(of_threads_[range.thread], i);\n",
        "      for (std::size_t i = range.end; i-- > range.begin;) visit(of_threads_[range.thread], i);\n",
        "what a thread found is summed from the last face of a share to the first",
    ),
    (
        "fast/engine/engine.cpp",
        "  data.team.start();\n",
        "",
        "other threads stay at the first pose they were asked about",
    ),
    (
        "fast/clipped/clipped_elements.cpp",
        "record.add(own.beside);",
        "(void)own;",
        "what faces have beside elements is lost where threads looked through them",
    ),
    (
        "fast/active/inside_areas.cpp",
        "const double sign = side_ == Side::E ? 1 : -1;",
        "const double sign = side_ == Side::E ? -1 : 1;",
        "area on the wrong side of a segment",
    ),
    (
        "fast/active/inside_areas.cpp",
        "base = labels == kInside ? 1 : 0;",
        "base = 0;",
        "area on the wrong side of a face before an open surface",
    ),
    (
        "fast/active/inside_areas.cpp",
        "return other_closed_ ? static_cast<double>(active_.face_winding.at(face)) : 1.0;",
        "return 1.0;",
        "faces that the other surface winds about twice",
    ),
    (
        "fast/active/patches.cpp",
        "} else if (list.count == 2 && regions[0] < 0 && regions[1] < 0) {",
        "} else if (list.count == 3 && regions[0] < 0 && regions[1] < 0) {",
        "polygons that an edge joins which enters and leaves",
    ),
    # Penetration lines.
    (
        "fast/predicates/penetration_predicates.cpp",
        "numerator_of_difference(shifted_distance(n, s, f), shifted_distance(n, s, g));",
        "numerator_of_difference(shifted_distance(n, s, g), shifted_distance(n, s, f));",
        "the tie rule of penetration lines: which of two faces is met first",
    ),
    (
        "fast/predicates/penetration_predicates.cpp",
        "shifted_side(line_normal<Number>(line), difference<Number>(from, to), shift<Number>(line, order));",
        "shifted_side(line_normal<Number>(line), difference<Number>(to, from), shift<Number>(line, order));",
        "the tie rule of penetration lines: on which side of an edge",
    ),
    (
        "fast/barycentric/penetration_line.cpp",
        "if (order > 0 || (order == 0 && face > first.face)) return;",
        "if (order >= 0) return;",
        "of two faces that coincide the one found first",
    ),
    (
        "fast/barycentric/penetration_line.cpp",
        "    penetration.outcome = Penetration::Outcome::too_deep;\n",
        "    penetration.outcome = Penetration::Outcome::element;\n",
        "a line that leaves its own body first",
    ),
    (
        "fast/barycentric/penetration_walks.cpp",
        "constexpr double kDistanceError = 0x1p-29;",
        "constexpr double kDistanceError = 0x1p-50;",
        "the error of a distance that four lanes decide by",
    ),
    (
        "fast/barycentric/penetration_walks.cpp",
        "limits.thick_area = kThicknessTolerance * max_coordinate - line_error;",
        "limits.thick_area = 2 * kThicknessTolerance * max_coordinate - line_error;",
        "when a face's thickness holds at a pose",
    ),
    (
        "fast/surface/clearance.cpp",
        "clearance.beneath[1] = rounded_down(depth / max_coordinate);",
        "clearance.beneath[1] = rounded_down(4 * depth / max_coordinate);",
        "the room beneath a face, four times what there is",
    ),
    (
        "fast/surface/clearance.cpp",
        "inward[(k + 2) % 3]) + tangent * down;",
        "inward[(k + 1) % 3]) + tangent * down;",
        "planes through the corners of the room beneath a face",
    ),
    (
        "fast/surface/clearance.cpp",
        "inward[k] = unit(N.cross(p[(k + 1) % 3] - p[k]));",
        "inward[k] = N.cross(p[(k + 1) % 3] - p[k]).normalized();",
        "unit vectors from a square that loses its digits where surfaces are very small",
    ),
    # The law.
    (
        "fast/law/element_force.h",
        "const Number sliding = v_t > zero ? law.friction * pressing : zero;",
        "const Number sliding = v_t > zero ? law.friction * normal : zero;",
        "friction on a pulling element",
    ),
    (
        "fast/law/element_force.h",
        "sliding * slip * (2.0 - slip)",
        "sliding * slip * (1.0 + slip)",
        "friction below the slip velocity",
    ),
    (
        "fast/law/element_force.h",
        "const auto fades = penetration < law.transition_depth;",
        "const auto fades = penetration <= law.transition_depth;",
        "damping at the transition depth itself: the same, but for 0 / 0 and its slope",
    ),
    (
        "fast/force/element_sum.cpp",
        "return (element.position_Me - problem.pose.r).cross(element.force_Me);",
        "return element.position_Me.cross(element.force_Me);",
        "torque about the other marker, where elements are formed one by one",
    ),
    (
        "fast/simd/element_kernels.h",
        "store(cross(lever, force), lanes.torque_Me);",
        "store(cross(position, force), lanes.torque_Me);",
        "torque about the other marker",
    ),
    (
        "fast/simd/element_kernels.h",
        "const Vector4 v_k = limits.master_E ? v_F : -v_F;  // (17)",
        "const Vector4 v_k = v_F;  // (17)",
        "the velocity of the slave relative to the master F",
    ),
    (
        "fast/simd/element_kernels.h",
        "(four(limits.shift) * depth) * n;  // (13)",
        "(four(0.5) * depth) * n;  // (13)",
        "where an element lies between layers of unlike stiffness",
    ),
    (
        "fast/simd/element_kernels.h",
        "const Vector4 lever = position - four(limits.r_Me);",
        "const Vector4 lever = load(lanes.barycentre_Me) - four(limits.r_Me);",
        "the lever from the foot of an element, not from its point",
    ),
    (
        "fast/force/element_sum.cpp",
        "const LaneBits all = (1U << waiting_) - 1;",
        "const LaneBits all = waiting_ % kElementLanes == 0 ? (1U << waiting_) - 1 : (1U << (waiting_ - 1)) - 1;",
        "the tail of the lanes without its last element",
    ),
    (
        "fast/force/element_sum.cpp",
        "  form_waiting();\n  MasterForce total = sum_.total();",
        "  MasterForce total = sum_.total();",
        "the tail of the lanes is never formed",
    ),
    # Its derivatives.
    (
        "fast/simd/tangent_kernels.h",
        "  add({per_area, cross(motion.lever, per_area)}, parts.area);",
        "",
        "the area of what is seen stays as it is",
    ),
    (
        "fast/clipped/part_motion.cpp",
        "        add_edge(V, SeenEdge(h, static_cast<std::size_t>(kind)), a, b);",
        "        add_parts(V, a, a[kDepth], b, b[kDepth]);",
        "an edge that hides a part turns as if it were as deep as what it hides",
    ),
    (
        "fast/clipped/part_motion.cpp",
        "      add_parts(l * depth_f_.by_motion_Me, a, a[kDepth], b, b[kDepth]);",
        "",
        "where the master's own faces come through the slave's nothing moves",
    ),
    (
        "fast/clipped/visible_parts.cpp",
        "        relabelling.apply(outside);",
        "",
        "a side moves with an edge that ends before it does",
    ),
    (
        "fast/simd/tangent_kernels.h",
        "  const Vector4 carried = motion.from_master * along;",
        "  const Vector4 carried = along;",
        "which way an element of master F moves as it gets deeper",
    ),
    (
        "fast/simd/tangent_kernels.h",
        "  Vector4 operator()(const Vector4& x) const { return choice(used, x, Vector4{four(0), four(0), four(0)}); }",
        "  Vector4 operator()(const Vector4& x) const { return x; }",
        "lanes without an element count in derivatives",
    ),
    (
        "fast/force/tangent_sum.cpp",
        "    torque_by_position += cross_matrix(force_Me);\n",
        "",
        "the torque's arm from Mf, which moves",
    ),
    (
        "fast/force/tangent_sum.cpp",
        "force_by_velocity * v_x + force_by_spin * w_x - cross_matrix(force_Me)",
        "force_by_velocity * v_x - cross_matrix(force_Me)",
        "the angular velocity as seen from F, which turns",
    ),
    (
        "fast/barycentric/barycentric_elements.cpp",
        "const bool clamped = found[lane].depth >= problem_.law.max_penetration;",
        "const bool clamped = false;",
        "a clamped depth counts as one that grows",
    ),
    (
        "fast/engine/pairing_memory.cpp",
        " && a.tangent == b.tangent",
        "",
        "a known pose forgets that a tangent was wanted",
    ),
    (
        "fast/force/element_sum.cpp",
        "MasterForce mean{0.5 * (on_E.force_Me + on_F.force_Me), 0.5 * (on_E.torque_Me + on_F.torque_Me), std::nullopt};",
        "MasterForce mean{0.5 * (on_E.force_Me + on_F.force_Me), on_E.torque_Me, std::nullopt};",
        "the mean of both masters' torques",
    ),
    (
        "fast/force/force_problem.cpp",
        "with_velocities = law.damping != 0 || law.friction != 0 || with_statistics;",
        "with_velocities = law.damping != 0 || with_statistics;",
        "friction without damping, where neither elements nor statistics are wanted",
    ),
    (
        "fast/force/statistics_sum.h",
        "moment_Me_ += element.normal_force * element.position_Me;",
        "moment_Me_ += element.area * element.position_Me;",
        "the centre of pressure",
    ),
    # The clipped scheme.
    (
        "fast/clipped/visible_parts.cpp",
        "return !g.projected.of_master && g.projected.face < f.projected.face ? Order::before : Order::after;",
        "return !g.projected.of_master && g.projected.face > f.projected.face ? Order::before : Order::after;",
        "which of two faces that coincide hides the other",
    ),
    (
        "fast/clipped/visible_parts.cpp",
        "if (side_of_f != 2) return side_of_f > 0 ? Order::after : Order::before;",
        "if (side_of_f != 2) return side_of_f > 0 ? Order::before : Order::after;",
        "which of two faces lies before the other",
    ),
    (
        "fast/clipped/visible_parts.cpp",
        "by_low_s[j].low_s < f.high_s; ++j) {",
        "by_low_s[j].low_s < f.high_s && j < i + 16; ++j) {",
        "a face that overlaps many others",
    ),
    (
        "fast/clipped/clipped_elements.cpp",
        "  clamped.greatest = moments.greatest;\n",
        "",
        "the greatest penetration of a clamped part",
    ),
    (
        "fast/clipped/clipped_elements.cpp",
        "if (part.area > 0 && !part.is_element()) record.note_depth(part.moments.greatest, law);",
        "",
        "the greatest penetration of parts that carry no element",
    ),
    # Callers: what is wanted, what is remembered, scenes.
    (
        "fast/engine/engine.cpp",
        "  if (wanted.polygons || wanted.areas) {\n    chain_polygons",
        "  if (wanted.polygons) {\n    chain_polygons",
        "areas wanted alone",
    ),
    (
        "fast/engine/engine.cpp",
        "    contact.bound = force.bound;\n",
        "    if (wanted.elements) contact.bound = force.bound;\n",
        "a bound wanted alone",
    ),
    (
        "fast/engine/engine.cpp",
        "find_crossings(data.posed, {false, wanted.bound, savings.filters},",
        "find_crossings(data.posed, {false, wanted.bound && wanted.areas, savings.filters},",
        "the candidates that a bound reads, where it is wanted without areas",
    ),
    (
        "fast/engine/pairing_memory.cpp",
        "a.bound == b.bound && a.statistics == b.statistics && a.tangent == b.tangent;",
        "a.bound == b.bound && a.tangent == b.tangent;",
        "a remembered answer without statistics where these are wanted",
    ),
    (
        "fast/engine/scene.cpp",
        "remembered == nullptr || !same_bits(pose, remembered->pose)",
        "remembered == nullptr",
        "a remembered pose that is another one",
    ),
    (
        "fast/engine/scene.cpp",
        "const Eigen::Vector3d carried_W = E.velocity.w.cross(F.pose.r - E.pose.r);",
        "const Eigen::Vector3d carried_W = E.velocity.w.cross(F.pose.r);",
        "the relative velocity of two bodies, of which E is not at the origin",
    ),
    (
        "fast/engine/scene.cpp",
        "pairing.on_E = {force_W, torque_W + (F.r - E.r).cross(force_W)};",
        "pairing.on_E = {force_W, torque_W};",
        "torque about the other marker, in a scene",
    ),
    (
        "fast/posed/motion.h",
        "(to.r - from.r)) + turn.norm() * ball_F.radius;",
        "(to.r - from.r)) + 0.5 * turn.norm() * ball_F.radius;",
        "how far a turn may bring bodies that were apart, or pairs that are followed",
    ),
    # From pose to pose.
    (
        "fast/crossings/tracked_pairs.cpp",
        "return kShorter * pair_margin",
        "return 2 * pair_margin",
        "the way until a pair is looked at again, doubled",
    ),
    (
        "fast/crossings/tracked_pairs.cpp",
        "bool same = 3 * count < fewest_vertices;",
        "bool same = 3 * count < 3 * count + fewest_vertices;",
        "a component that passes through a surface between two poses",
    ),
    (
        "fast/crossings/tracked_pairs.cpp",
        "same = same && cross_alike(signs, signs_[i]);",
        "same = same && (cross_alike(signs, signs_[i]) || count == 1);",
        "a single pair that has begun to cross",
    ),
    (
        "fast/crossings/tracked_pairs.h",
        "return travelled < listed_until_;",
        "return travelled < 2 * listed_until_;",
        "pairs that come near after the list was made",
    ),
    (
        "fast/simd/overlap.cpp",
        "2 * in_double_E + tilt + in_units));",
        "2 * in_double_E + tilt));",
        "pairs that are followed: tests of planes without the margin",
    ),
    (
        "fast/barycentric/line_memory.h",
        "line.until -= travelled;",
        "line.until -= 0 * travelled;",
        "lines that are remembered too long",
    ),
    (
        "fast/barycentric/penetration_line.cpp",
        "if (known != nullptr && !(first.distance.greatest <= searched)) return std::nullopt;",
        "",
        "a face beyond those that are remembered of a line",
    ),
    (
        "fast/engine/tracking.cpp",
        "for (LineMemory& lines : lines_) lines.clear();",
        "",
        "lines remembered over a jump",
    ),
    (
        "fast/crossings/pair_margin.cpp",
        "return numerator * other.denominator < other.numerator * denominator;",
        "return numerator < other.numerator;",
        "the least of distances, their divisors forgotten",
    ),
    (
        "fast/crossings/pair_margin.cpp",
        "std::min(from_plane(from - face[0]), from_plane(to - face[0]))",
        "from_plane(from - face[0])",
        "an edge's end that comes through a face",
    ),
    (
        "fast/barycentric/line_margin.cpp",
        "double way = std::min(from_sides, cosine * nearest);",
        "double way = cosine * nearest;",
        "a settled line that leaves its face by a side",
    ),
    (
        "fast/barycentric/line_margin.cpp",
        "way = std::min(way, cosine * to_own_faces);",
        "",
        "a settled line that comes to meet its own body's faces",
    ),
    (
        "fast/barycentric/line_margin.cpp",
        "const double until_outside = (cosine - kConeCosine[cone]) * motion.turning_radius;",
        "const double until_outside = kInfinity;",
        "a settled line that turns out of the cone in which its face is clear",
    ),
    (
        "fast/barycentric/line_margin.cpp",
        "const double free_way = cosine * (line.slave_free - farthest);",
        "const double free_way = kInfinity;",
        "a settled line that comes to meet a face beyond those that were searched for",
    ),
    (
        "fast/barycentric/line_memory.h",
        "return travelled_ < line.settled_until;",
        "return travelled_ < 4 * line.settled_until;",
        "lines that count as settled for too long",
    ),
    (
        "fast/barycentric/line_memory.h",
        "    for (Line& line : past_.lines) line.settled_until = -std::numeric_limits<double>::infinity();\n"
        "    vertex_error_ = 2 * error;\n",
        "    vertex_error_ = 2 * error;\n",
        "lines settled for smaller errors of their body's vertices",
    ),
    (
        "fast/barycentric/penetration_walks.cpp",
        "if (has_lane(leaving.surely, lane)) {",
        "if (!has_lane(leaving.surely_not, lane)) {",
        "a line that may still leave the slave through the face it left, taken to do so",
    ),
    (
        "fast/barycentric/penetration_walks.cpp",
        "lanes_.slave_free.value[lane] = has_lane(has_only_, from) ? lines_[from]->slave_searched : 0;",
        "lanes_.slave_free.value[lane] = has_lane(has_only_, from) ? kInfinity : 0;",
        "how far the faces that are remembered are all of them",
    ),
    (
        "fast/engine/tracking.cpp",
        "for (LineMemory& lines : lines_) lines.start_travel_anew(travelled_);",
        "",
        "travel counted anew, but not that of lines",
    ),
    (
        "fast/clipped/line_beside_cut.cpp",
        "  longest.look_at_taken(polygon, heights);\n",
        "",
        "which line a border lies on, where a cut along it took a corner alone",
    ),
    # Bounds.
    (
        "fast/bounds/force_error.cpp",
        "cross_of_magnitudes(lever_error, force + result.force_Me) +",
        "",
        "the bound of a torque without the error of the lever",
    ),
    (
        "fast/bounds/law_error.cpp",
        "std::min(volume_error, area.size * depth.error + area.error * depth.greatest())",
        "std::min(0.01 * volume_error, area.size * depth.error + area.error * depth.greatest())",
        "the bound of an elastic force, a hundredth of it",
    ),
    (
        "fast/posed/vertex_rounding.h",
        "(std::abs(sum) + 8 * kUnitRoundoff * size)",
        "(0.25 * std::abs(sum) + 8 * kUnitRoundoff * size)",
        "the sharp rounding of a vertex, a quarter of it",
    ),
    # The oracle.
    (
        "reference/predicates/orientation.cpp",
        "sum = column % 2 == 0 ? sum + term : sum - term;",
        "sum = column % 3 == 0 ? sum + term : sum - term;",
        "a cofactor of the determinant",
    ),
    (
        "reference/predicates/orientation.cpp",
        "power += 1 << (3 * (rank[point] + 1) - (matching[point] + 1));",
        "power += 1 << (3 * rank[point] + matching[point]);",
        "the tie rule: x moves most, not z",
    ),
    (
        "reference/crossings/crossings.cpp",
        "crossing.starts = downward == (edge_side == Side::F);",
        "crossing.starts = downward;",
        "circulation on F",
    ),
    (
        "reference/crossings/crossings.cpp",
        "  found.erase(std::unique(found.begin(), found.end()), found.end());\n",
        "",
        "an edge shared by two faces is entered as two crossings",
    ),
    (
        "reference/active/active_areas.cpp",
        "if (!crossed_component[surface.component[f]]) active.nested = true;",
        "if (surface.component[f] == 0 && !crossed_component[0]) active.nested = true;",
        "a lost component",
    ),
    (
        "reference/force/law.h",
        "const T limit = field(law.friction) * max(F_n, zero);",
        "const T limit = field(law.friction) * F_n;",
        "friction on a pulling element",
    ),
    (
        "reference/force/law.h",
        "if (master == Side::F) v_k = minus_one * v_k;",
        "",
        "the velocity of the slave relative to the master F",
    ),
    (
        "reference/force/law.h",
        "const Vec3<T> arm = C_k - state.r;",
        "const Vec3<T> arm = C_k;",
        "torque about the other marker",
    ),
    (
        "reference/force/contact_force.cpp",
        "torque = torque + cross(element.load.arm, element.force_on_E);  // (22), (24)",
        "torque = torque + cross(element.load.position, element.force_on_E);  // (22), (24)",
        "torque about the other marker, in the sum alone",
    ),
    (
        "reference/elements/barycentric_elements.cpp",
        "if (order < 0 || (order == 0 && hit.face < first.face)) first = hit;",
        "if (order < 0) first = hit;",
        "of two faces that coincide the one found first",
    ),
    (
        "reference/elements/clipped_elements.cpp",
        "else if (g.side == plane_.master().side || f < g)",
        "else if (f < g)",
        "a face of the master that coincides with one of the slave",
    ),
    (
        "reference/crossings/coplanar.cpp",
        "for (const Rational* component : {&n.z, &n.y, &n.x})",
        "for (const Rational* component : {&n.x, &n.y, &n.z})",
        "to which side the tie rule moves faces in one plane",
    ),
]

#: By room: the file of a fault so coarse that every check has to notice it. A campaign begins with it.
PLANTED = {
    "fast": (
        "fast/simd/element_kernels.h",
        "const Vector4 straight = normal * n;",
        "const Vector4 straight = (normal * n) / four(2);",
        "planted: half of the normal force",
    ),
    "reference": (
        "reference/force/law.h",
        "const T elastic = layers.stiffness * A_k * u_k;  // (14)",
        "const T elastic = field(0.5) * layers.stiffness * A_k * u_k;  // (14)",
        "planted: half of the elastic force",
    ),
}
