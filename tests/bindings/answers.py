# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""answers.py FOLDER: asks, through the Python module, what write_answers has written there, and compares every bit."""

import sys
from pathlib import Path

import numpy as np
import pcm

MODES = ["E", "F", "both"]
SCHEMES = ["barycentric", "clipped"]
DAMPING_MODES = ["no_tension", "full", "compression"]
WANTED = ["polygons", "areas", "force", "elements", "bound", "statistics", "tangent"]
NUMBERS = 52


def bits_of(values):
    """Doubles, integers or truths as 64 bits each."""
    array = np.asarray(values)
    return (array if array.dtype.kind == "f" else array.astype(np.int64)).ravel().view(np.uint64)


def bits_of_rows(rows):
    """Row by row, field by field."""
    if len(rows) == 0:
        return np.zeros(0, np.uint64)
    columns = [bits_of(rows[name]).reshape(len(rows), -1) for name in rows.dtype.names]
    return np.hstack(columns).ravel()


def checksum(contact):
    """The exclusive or of the bits of all lists, those of the i-th number rotated left by i modulo 64."""
    lists = [bits_of_rows(rows) for rows in (contact.elements, contact.polygons, contact.crossings)]
    for area in (contact.E, contact.F):
        lists += [bits_of(area.intersected), bits_of(area.inner)]
    if contact.tangent is not None:
        lists.append(bits_of(contact.tangent))
    bits = np.concatenate(lists)
    shift = np.arange(len(bits), dtype=np.uint64) % np.uint64(64)
    back = (np.uint64(64) - shift) % np.uint64(64)
    return np.bitwise_xor.reduce((bits << shift) | (bits >> back), initial=np.uint64(0))


def bound_numbers(bound):
    if bound is None:
        return [0, 0], np.zeros(8)
    return [1, bound.flipped], [*bound.force_Me, *bound.torque_Me, bound.penetration_at_least, bound.penetration_at_most]


def numbers_of(contact):
    E, F, s = contact.E, contact.F, contact.statistics
    given, bound = bound_numbers(contact.bound)
    integers = [contact.touching, contact.nested, contact.ambiguous, contact.has_volume, contact.penetration_exceeded,
                contact.too_deep, contact.undefined_areas, contact.patches, len(contact.polygons),
                len(contact.crossings), contact.element_count, len(contact.elements), len(E.intersected), len(E.inner),
                len(F.intersected), len(F.inner), *given]
    doubles = [*contact.force_Me, *contact.torque_Me, contact.max_penetration, contact.volume, E.area,
               *E.vector_area_Me, F.area, *F.vector_area_Me, *bound, s.patch_area, s.mean_penetration, s.max_pressure,
               s.mean_pressure, s.max_normal_velocity, s.max_tangential_velocity, *s.centre_of_pressure_Me]
    return np.concatenate([bits_of(integers), bits_of(np.array(doubles)), [checksum(contact)]])


def row_numbers(row):
    """Those of numbers_of that a row of evaluate_many has, in the same order; and which these are."""
    truths = ["touching", "nested", "ambiguous", "has_volume", "penetration_exceeded", "too_deep", "undefined_areas",
              "patches"]
    doubles = ["force_Me", "torque_Me", "max_penetration", "volume", "area_E", "vector_area_E_Me", "area_F",
               "vector_area_F_Me", "force_bound_Me", "torque_bound_Me", "penetration_at_least", "penetration_at_most",
               "patch_area", "mean_penetration", "max_pressure", "mean_pressure", "max_normal_velocity",
               "max_tangential_velocity", "centre_of_pressure_Me"]
    integers = [row[name] for name in truths] + [row["element_count"], row["flipped"]]
    places = [*range(len(truths)), 10, 17, *range(18, NUMBERS - 1)]
    return np.concatenate([bits_of([int(i) for i in integers]), *(bits_of(row[name]) for name in doubles)]), places


def read_surface(path):
    """As a file has it, taken apart into arrays and put together again."""
    surface = pcm.Surface.read(path)
    return pcm.Surface(surface.vertices, surface.faces)


def read_pairing(folder, files, numbers):
    E, F = (read_surface(folder / file) for file in files.split())
    mode, scheme, damping_mode = (int(i) for i in numbers[:3])
    stiffness, c_E, c_F, damping, depth, friction, slip, greatest = numbers[3:11].view(np.float64)
    law = pcm.ContactLaw(stiffness=stiffness, layer_stiffness=(c_E, c_F) if c_E != 0 else None, damping=damping,
                         transition_depth=depth, friction=friction, slip_velocity=slip, max_penetration=greatest,
                         damping_mode=DAMPING_MODES[damping_mode])
    return pcm.Pairing(E, F, law, MODES[mode], SCHEMES[scheme]), int(numbers[11])


def numbers_in(line):
    return np.array([int(word, 16) for word in line.split()], dtype=np.uint64)


def same_by_evaluate(pairing, question, expected):
    wanted = {name: bool(int(question[0]) >> i & 1) for i, name in enumerate(WANTED)}
    state = question[1:].view(np.float64)
    contact = pairing.evaluate(state[:9].reshape(3, 3), state[9:12], state[12:15], state[15:18], **wanted)
    return np.array_equal(numbers_of(contact), expected)


def differing_rows(pairing, questions):
    """How many rows of evaluate_many differ from what evaluate says, for everything that it may be asked for."""
    states = np.array(questions)[:, 1:].copy().view(np.float64)
    A, r, v, w = states[:, :9].reshape(-1, 3, 3), states[:, 9:12], states[:, 12:15], states[:, 15:18]
    rows = pairing.evaluate_many(A, r, v, w, bound=True, statistics=True, threads=2)
    differing = 0
    for i, row in enumerate(rows):
        contact = pairing.evaluate(A[i], r[i], v[i], w[i], polygons=False, elements=False, bound=True, statistics=True)
        numbers, places = row_numbers(row)
        differing += not np.array_equal(numbers, numbers_of(contact)[places])
    return differing


def main(folder):
    lines = iter((folder / "answers.txt").read_text().splitlines())
    poses = differing = 0
    for _ in range(int(next(lines))):
        pairing, count = read_pairing(folder, next(lines), numbers_in(next(lines)))
        questions = []
        for _ in range(count):
            question, expected = numbers_in(next(lines)), numbers_in(next(lines))
            differing += not same_by_evaluate(pairing, question, expected)
            questions.append(question)
        differing += differing_rows(pairing, questions)
        poses += count
    print(f"{poses} poses, {differing} with another answer")
    return 0 if differing == 0 else 1


sys.exit(main(Path(sys.argv[1])))
