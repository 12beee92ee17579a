# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python module refuses, and how it behaves as a module."""

import threading
import unittest

import numpy as np
import pcm

VERTICES = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
IDENTITY = np.eye(3)
R = [0.1, 0.1, 0.1]
NAN = float("nan")


def tetrahedron():
    return pcm.Surface(VERTICES, FACES)


def pairing(**law):
    return pcm.Pairing(tetrahedron(), tetrahedron(), pcm.ContactLaw(**law), mode="both")


class Refusals(unittest.TestCase):
    def expect(self, words, call, *arguments, **named):
        with self.assertRaises(pcm.BadInput) as caught:
            call(*arguments, **named)
        self.assertIn(words, str(caught.exception))

    def test_bad_input_is_a_value_error(self):
        self.assertTrue(issubclass(pcm.BadInput, ValueError))

    def test_surfaces(self):
        self.expect("shape (n, 3) is wanted, not (3,)", pcm.Surface, [0, 0, 0], FACES)
        self.expect("shape (n, 3) is wanted, not (4, 2)", pcm.Surface, np.zeros((4, 2)), FACES)
        self.expect("vertices: an array of numbers", pcm.Surface, "corner", FACES)
        self.expect("vertices: an array of numbers", pcm.Surface, np.zeros((4, 3), complex), FACES)
        self.expect("vertices: an array of numbers", pcm.Surface, [[0, 0, 0], [1]], FACES)
        self.expect("faces: an array of integers", pcm.Surface, VERTICES, np.array(FACES, float))
        self.expect("4294967296 is no vertex number", pcm.Surface, VERTICES, [[0, 1, 2**32]])
        self.expect("surface", pcm.Surface, VERTICES, [[0, 1, 4]])
        self.expect("surface", pcm.Surface, VERTICES, [[0, 0, 1]])
        self.expect("finite", pcm.Surface, [[NAN, 0, 0], *VERTICES[1:]], FACES)
        self.expect("face", pcm.Surface, np.zeros((0, 3)), np.zeros((0, 3), int))
        self.expect("no_such_file.obj", pcm.Surface.read, "no_such_file.obj")

    def test_laws_and_pairings(self):
        self.expect("stiffness", pairing, stiffness=0)
        self.expect("stiffness", pairing, stiffness=NAN)
        self.expect("c_F", pairing, layer_stiffness=(1e6, 0))
        self.expect("rigid", pairing, layer_stiffness=(float("inf"), float("inf")))
        self.expect("friction", pairing, friction=-1)
        self.expect("'damped'", pairing, damping_mode="damped")
        surface = tetrahedron()
        self.expect("'G'", pcm.Pairing, surface, surface, pcm.ContactLaw(), mode="G")
        self.expect("'exact'", pcm.Pairing, surface, surface, pcm.ContactLaw(), scheme="exact")
        self.assertRaises(TypeError, pcm.Pairing, surface, None, pcm.ContactLaw())
        self.assertRaises(TypeError, pcm.ContactLaw, 5.9e5)

    def test_states(self):
        evaluate = pairing().evaluate
        self.expect("A: an array of shape (3, 3) is wanted, not (9,)", evaluate, IDENTITY.ravel(), R)
        self.expect("r: an array of shape (3,) is wanted, not (2,)", evaluate, IDENTITY, [0, 0])
        masked = np.ma.masked_array([0.0, 0, 0], [0, 1, 0])
        self.expect("r: a masked array; give it filled", evaluate, IDENTITY, masked)
        self.expect("A: a masked array", evaluate, [masked, masked, masked], R)
        self.expect("A: a masked array", evaluate, (masked, [0, 1, 0], [0, 0, 1]), R)
        self.expect("A: an array of numbers", evaluate, None, R)
        self.expect("finite", evaluate, IDENTITY, [NAN, 0, 0])
        self.expect("finite", evaluate, IDENTITY, R, [NAN, 0, 0])
        self.expect("reflection", evaluate, -IDENTITY, R)
        self.expect("no rotation", evaluate, 2 * IDENTITY, R)

    def test_many_states(self):
        evaluate_many = pairing().evaluate_many
        A, r = np.tile(IDENTITY, (5, 1, 1)), np.tile(R, (5, 1))
        self.expect("A: an array of shape (n, 3, 3)", evaluate_many, IDENTITY, r)
        self.expect("r: an array of shape (5, 3) is wanted, not (4, 3)", evaluate_many, A, r[:4])
        self.expect("v: an array of shape (5, 3)", evaluate_many, A, r, R)
        self.expect("threads is 0", evaluate_many, A, r, threads=0)
        r[2:4, 1] = NAN
        for threads in (1, 2, 7):
            self.expect("pose 2: ", evaluate_many, A, r, threads=threads)


class Module(unittest.TestCase):
    def test_arrays_of_any_layout(self):
        """Columns first, strided and of integers: the numbers count, not where they lie."""
        whole = pairing().evaluate(IDENTITY, R).force_Me
        self.assertTrue(np.any(whole != 0))
        turn = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
        by_rows = pairing().evaluate(turn.astype(float), R).force_Me
        for A in (turn, np.asfortranarray(turn), np.repeat(turn, 2, axis=1)[:, ::2], turn.tolist()):
            np.testing.assert_array_equal(pairing().evaluate(A, R).force_Me, by_rows)
        self.assertTrue(np.any(pairing().evaluate(turn.T, R).force_Me != by_rows))

    def test_answers_are_copies(self):
        """An answer outlives the next evaluation, its pairing, and what is written into its arrays."""
        one = pairing()
        contact = one.evaluate(IDENTITY, R)
        elements = contact.elements
        before = elements.copy()
        one.evaluate(IDENTITY, [0.2, 0.1, 0.1])
        del one
        np.testing.assert_array_equal(contact.elements, before)
        elements["area"] = 0
        np.testing.assert_array_equal(contact.elements, before)

    def test_what_was_not_wanted(self):
        contact = pairing().evaluate(IDENTITY, R, polygons=False, areas=False, force=False, elements=False)
        self.assertTrue(contact.touching)
        self.assertIsNone(contact.bound)
        self.assertEqual(len(contact.elements) + len(contact.polygons) + contact.element_count, 0)
        self.assertIsNotNone(pairing().evaluate(IDENTITY, R, bound=True).bound)

    def test_truths_are_masks(self):
        r = np.array([R, [5, 5, 5], R])
        rows = pairing().evaluate_many(np.tile(IDENTITY, (3, 1, 1)), r)
        np.testing.assert_array_equal(rows["touching"], [True, False, True])
        self.assertEqual(rows[rows["touching"]].shape, (2,))
        self.assertEqual(len(pairing().evaluate_many(np.zeros((0, 3, 3)), np.zeros((0, 3)))), 0)

    def test_paths_that_are_no_utf_8_are_told(self):
        with self.assertRaises(pcm.BadInput) as caught:
            pcm.Surface.read(b"/there/is/no/b\xe9.obj")
        self.assertIn("/there/is/no/b\\xe9.obj", str(caught.exception))

    def test_patches_of_many_are_those_of_each_where_polygons_are_wanted(self):
        patches = pairing().evaluate(IDENTITY, R).patches
        self.assertGreater(patches, 0)
        A, r = np.tile(IDENTITY, (2, 1, 1)), np.array([R, R])
        self.assertEqual(list(pairing().evaluate_many(A, r, polygons=True)["patches"]), [patches, patches])
        self.assertEqual(list(pairing().evaluate_many(A, r)["patches"]), [0, 0])

    def test_threads_share_a_pairing(self):
        shared = pairing()
        wanted = [shared.evaluate(IDENTITY, [0.01 * i, 0.1, 0.1]).force_Me for i in range(20)]
        wrong = []

        def evaluate():
            for i in range(20):
                if not np.array_equal(shared.evaluate(IDENTITY, [0.01 * i, 0.1, 0.1]).force_Me, wanted[i]):
                    wrong.append(i)

        threads = [threading.Thread(target=evaluate) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_everything_has_a_docstring(self):
        for name, item in vars(pcm).items():
            if not name.startswith("_"):
                self.assertTrue(item.__doc__, name)
        for name in ("evaluate", "evaluate_many"):
            self.assertIn("shape", getattr(pcm.Pairing, name).__doc__)

    def test_texts(self):
        self.assertEqual(repr(tetrahedron()), "<pcm.Surface: 4 vertices, 4 faces, closed>")
        self.assertRegex(pcm.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
