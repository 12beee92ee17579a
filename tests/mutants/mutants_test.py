# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of how mutants are drawn, told apart, kept and reported. Nothing is built."""

import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from pathlib import Path

sys.dont_write_bytecode = True

import checks
import draw
import report
from campaign import NO_PROGRAM, Campaign, Refused, Results, picked_mutants, planted_mutant, refuse_no_program_by_hand
from draw import first_drawn
from hand_picked import PICKED
from mutant import BadMutant, Mutant, by_hand
from scratch import is_of_sources
from tokens import tokens_of

ROOT = Path(__file__).resolve().parents[2]

SOURCE = """\
// SPDX-License-Identifier: none
#include <a/b-c.h>
#define SUM(a, b) \\
  ((a) + (b))
/* 1 + 2 */
static_assert(1 + 1 == 2, "one " + "two");
template <class T>
[[nodiscard]] std::vector<T> f(const T& a, double* p) {
  assert(a < 3 && "x < y");
  const char* text = "a + b // c";  // d - e
  const char* raw = R"x(g - h)x";
  const char sign = '+';
  for (int i = 0; i < 7; ++i) g(-a);
  clear(p);
  if (a < 4) return Side::E;
  return 0.5 * *p - 1;
}
"""


def all_sites(text):
    return [(kind, *site) for kind, sites in draw.sites_in(text).items() for site in sites]


def read(file):
    return (ROOT / file).read_text(encoding="utf-8")


class Tokens(unittest.TestCase):
    def test_are_none_of_comments_strings_directives_and_assertions(self):
        texts = [token.text for token in tokens_of(SOURCE)]
        for unseen in ("SPDX", "include", "SUM", "two", "d", "e", "g - h", "static_assert", "assert", "nodiscard"):
            self.assertNotIn(unseen, texts)
        self.assertIn("clear", texts)

    def test_are_where_they_say(self):
        for token in tokens_of(SOURCE):
            self.assertEqual(SOURCE[token.offset : token.end], token.text)

    def test_numbers_are_whole(self):
        numbers = [t.text for t in tokens_of("a = 0x1p-53 + 1e-10 - 2.0F * 1'000 / 0b0100U;") if t.kind == "number"]
        self.assertEqual(numbers, ["0x1p-53", "1e-10", "2.0F", "1'000", "0b0100U"])


class Sites(unittest.TestCase):
    def test_are_operators_between_operands_only(self):
        found = {(kind, before, after) for kind, _, before, after in all_sites(SOURCE)}
        self.assertIn(("comparison", "<", "<="), found)
        self.assertIn(("arithmetic", "*", "/"), found)
        self.assertIn(("arithmetic", "-", "+"), found)
        self.assertIn(("sign", "-", ""), found)
        self.assertIn(("side", "E", "F"), found)
        self.assertIn(("constant", "7", "8"), found)
        self.assertIn(("constant", "0.5", "(2 * 0.5)"), found)
        self.assertIn(("statement", "clear(p);", ";"), found)
        # One product, two comparisons: no pointer, no template's bracket.
        self.assertEqual(sum(kind == "arithmetic" and before == "*" for kind, _, before, _ in all_sites(SOURCE)), 1)
        self.assertEqual(sum(kind == "comparison" and after == "<=" for kind, _, _, after in all_sites(SOURCE)), 2)

    def test_change_every_number(self):
        sites = all_sites("f(0.0, 0x0p0, 0.5, 10.0, 0.F);")
        found = {(before, after) for kind, _, before, after in sites if kind == "constant"}
        self.assertEqual(
            found,
            {("0.0", "1.0"), ("0x0p0", "1.0"), ("0.F", "1.0")}
            | {(x, after) for x in ("0.5", "10.0") for after in (f"(2 * {x})", f"({x} / 2)")},
        )

    def test_lie_in_code(self):
        for room in draw.ROOMS:
            for file in draw.sources_of(ROOT, room):
                text = read(file)
                for kind, offset, before, after in all_sites(text):
                    self.assertEqual(text[offset : offset + len(before)], before)
                    self.assertNotEqual(before, after)
                    line = text[text.rfind("\n", 0, offset) + 1 : offset]
                    self.assertNotIn("//", line, f"{file}: {line}")
                    self.assertFalse(line.startswith("#"), f"{file}: {line}")
                    self.assertNotIn("static_assert(", line, f"{file}: {line}")


class Draw(unittest.TestCase):
    def test_is_the_same_for_the_same_seed(self):
        for room in draw.ROOMS:
            one, again = first_drawn(ROOT, room, 1, 300), first_drawn(ROOT, room, 1, 300)
            self.assertEqual(one, again)
            self.assertEqual(one[:100], first_drawn(ROOT, room, 1, 100))
            self.assertNotEqual(one, first_drawn(ROOT, room, 2, 300))

    def test_has_each_once_in_many_files_and_of_every_kind(self):
        for room in draw.ROOMS:
            mutants = first_drawn(ROOT, room, 1, 300)
            self.assertEqual(len(mutants), 300)
            self.assertEqual(len({mutant.id for mutant in mutants}), 300)
            self.assertGreater(len({mutant.file for mutant in mutants}), 30)
            kinds = {"arithmetic", "comparison", "logic", "sign", "constant", "call", "side", "statement"}
            self.assertEqual({mutant.kind for mutant in mutants}, kinds)
            for mutant in mutants:
                text = read(mutant.file)
                self.assertEqual(len(mutant.applied_to(text)), len(text) + len(mutant.after) - len(mutant.before))

    def drawn_from(self, files):
        with tempfile.TemporaryDirectory() as root:
            for name, text in files.items():
                path = Path(root) / "fast" / name
                path.parent.mkdir(exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return [(mutant.file, mutant.id) for mutant in draw.Draw(root, "fast", 1)]

    def test_of_a_file_is_not_changed_by_others_nor_by_lines_that_move(self):
        one = "int f(int a) {\n  return a + 3 < 4;\n}\n"
        other = "int g(int a) {\n  return a * 7 - 5;\n}\n"
        drawn = self.drawn_from({"a.cpp": one, "b.cpp": other})
        self.assertEqual(len(set(drawn)), len(drawn))
        moved = self.drawn_from({"a.cpp": "// Comment.\n" + one, "b.cpp": other})
        self.assertEqual(drawn, moved)
        grown = self.drawn_from({"a.cpp": one + other.replace("g", "h").replace("7", "8"), "b.cpp": other})
        of_other = [mutant for mutant in drawn if mutant[0] == "fast/b.cpp"]
        self.assertEqual(of_other, [mutant for mutant in grown if mutant[0] == "fast/b.cpp"])
        self.assertLess(set(drawn), set(grown))

    def test_tells_lines_that_are_alike_apart_however_far_they_are_indented(self):
        def function(*lines):
            return {"a.cpp": "void f(int a) {\n" + "".join(lines) + "}\n"}

        line, indented = "  if (a < 1) return;\n", "      if (a < 1) return;\n"
        one = self.drawn_from(function(line))
        self.assertEqual(one, self.drawn_from(function(indented)))
        for two in (self.drawn_from(function(line, line)), self.drawn_from(function(line, indented))):
            self.assertEqual(len(set(two)), 2 * len(one))
            self.assertLess(set(one), set(two))

    def test_has_no_two_mutants_of_one_id(self):
        for room in draw.ROOMS:
            ids = [mutant.id for mutant in draw.Draw(ROOT, room, 1)]
            self.assertEqual(len(set(ids)), len(ids))


class Picked(unittest.TestCase):
    def test_texts_are_there_once_each(self):
        mutants = picked_mutants(read)
        self.assertEqual(len(mutants), len(PICKED))
        self.assertGreaterEqual(len(mutants), 40)
        self.assertEqual(len({mutant.id for mutant in mutants}), len(mutants))
        for mutant in mutants:
            self.assertTrue(mutant.why)
        for room in draw.ROOMS:
            self.assertEqual(planted_mutant(read, room).room, room)

    def test_texts_that_are_not_there_once_are_refused(self):
        for before in ("b", "x"):
            with self.assertRaises(BadMutant):
                by_hand("fast/a.cpp", before, "c", "why", "a b b")

    def test_that_do_not_compile_are_refused_where_a_drawn_one_is_replaced(self):
        entry = {"state": NO_PROGRAM, "message": "no such name"}
        with self.assertRaisesRegex(Refused, "fast/a.cpp.*why.*\n.*no such name"):
            refuse_no_program_by_hand(by_hand("fast/a.cpp", "b", "c", "why", "a b"), entry)
        refuse_no_program_by_hand(Mutant("fast", "fast/a.cpp", 2, "b", "c", "call"), entry)

    def test_are_known_again_where_lines_have_moved(self):
        one = by_hand("fast/a.cpp", "b", "c", "why", "a b")
        self.assertEqual(one.id, by_hand("fast/a.cpp", "b", "c", "why", "\n\na b").id)
        with self.assertRaises(BadMutant):
            one.applied_to("\n\na b")


class KeptResults(unittest.TestCase):
    def test_are_read_back_and_the_last_one_holds(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results.jsonl"
            results = Results(path)
            results.add({"id": "a", "state": "survived"})
            results.add({"id": "b", "state": "caught"})
            results.add({"id": "a", "state": "caught"})
            self.assertEqual(Results(path).get("a")["state"], "caught")
            self.assertEqual(len(Results(path).all()), 2)

    def test_outlive_a_line_that_was_cut_off(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results.jsonl"
            Results(path).add({"id": "a", "state": "caught"})
            path.write_text(path.read_text() + '{"id": "b", "st')
            results = Results(path)
            self.assertIsNone(results.get("b"))
            results.add({"id": "c", "state": "caught"})
            self.assertEqual({entry["id"] for entry in Results(path).all()}, {"a", "c"})


class ScratchOfNothing:
    """Stands for the copy of the sources: nothing is copied or built, and whether a fault is in it is remembered."""

    build_folder = Path("nowhere")
    source = ROOT
    has_fault = False

    def __init__(self, *folders):
        del folders

    def refresh(self):
        pass

    configure = refresh

    def build(self, *targets):
        pass

    def digest(self, folders):
        return "-".join(folders)

    def read(self, file):
        return read(file)

    def write(self, file, text):
        self.has_fault = text != read(file)


class Campaigns(unittest.TestCase):
    def run_once(self, folder, catches=True, again=False, names=("tests",)):
        """How many programs were run on mutants, and what is known then."""
        results = Path(folder) / "results.jsonl"
        asked, prepared = 0, False
        with unittest.mock.patch("campaign.Scratch", ScratchOfNothing):
            campaign = Campaign(ROOT, Path(folder), results, "a commit", names, False, (500,), again, 1, str)

            def run(command, allowed=None, **options):
                nonlocal asked
                asked += prepared
                return checks.Ended(int(campaign._scratch.has_fault and (catches or not prepared)), "", 1.0, False)

            with unittest.mock.patch("checks.run", run):
                campaign.prepare(draw.ROOMS)
                prepared = True
                campaign.run(draw.ROOMS, 2, 1, picked=False)
        return asked, Results(results).all()

    def test_of_both_rooms_know_the_times_of_the_programs_of_either(self):
        with tempfile.TemporaryDirectory() as folder:
            _, found = self.run_once(folder)
            self.assertEqual({entry["room"] for entry in found}, set(draw.ROOMS))
            self.assertEqual({entry["state"] for entry in found}, {"caught"})

    def test_try_no_mutant_twice_while_its_file_is_as_it_was(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.run_once(folder)[0], 4)
            with unittest.mock.patch.object(ScratchOfNothing, "digest", lambda self, folders: "changed"):
                self.assertEqual(self.run_once(folder)[0], 0)
            with unittest.mock.patch("campaign.digest_of", lambda text: "changed"):
                self.assertEqual(self.run_once(folder)[0], 4)

    def test_know_at_which_sources_each_check_was_asked(self):
        with tempfile.TemporaryDirectory() as folder:
            self.run_once(folder, catches=False)
            with unittest.mock.patch.object(ScratchOfNothing, "digest", lambda self, folders: "changed"):
                # Another check is asked at the changed sources; the first one's answers stay those of the old ones.
                self.run_once(folder, catches=False, names=("verify",))
                asked, _ = self.run_once(folder, catches=False, again=True)
            self.assertGreater(asked, 0)

    def test_ask_survivors_again_where_that_is_wanted_and_something_has_changed(self):
        with tempfile.TemporaryDirectory() as folder:
            _, found = self.run_once(folder, catches=False)
            self.assertEqual({entry["state"] for entry in found}, {"survived"})
            self.assertEqual(self.run_once(folder, again=True)[0], 0)
            with unittest.mock.patch.object(ScratchOfNothing, "digest", lambda self, folders: "changed"):
                self.assertEqual(self.run_once(folder)[0], 0)
                asked, found = self.run_once(folder, again=True)
            self.assertEqual(asked, 4)
            self.assertEqual({entry["state"] for entry in found}, {"caught"})


class Findings(unittest.TestCase):
    def ended(self, status, output, ran_out_of_time=False):
        return checks.Ended(status, output, 1.0, ran_out_of_time)

    def test_name_the_test(self):
        run = "[ RUN      ] Engine.Answers\n"
        failed = run + "[  FAILED  ] Engine.Answers (3 ms)\n"
        self.assertEqual(checks.failed_test(self.ended(1, failed)), "Engine.Answers")
        self.assertEqual(checks.failed_test(self.ended(-11, run)), "SIGSEGV in Engine.Answers")
        self.assertEqual(checks.failed_test(self.ended(-24, run, True)), "time limit in Engine.Answers")
        suite = "The following tests FAILED:\n\t 12 - Scene.Moves (Failed)\nErrors while running CTest\n"
        self.assertEqual(checks.failed_of_suite(self.ended(8, suite)), "Scene.Moves")

    def test_read_the_verdict(self):
        line = "NOT verified: 500 poses, 283 touching, 12 disagreements; see out"
        self.assertEqual(checks.verdict("a table\n" + line + "\n"), (500, 12, line))
        self.assertIsNone(checks.verdict("error: no such folder\n"))

    def test_count_disagreements_by_kind(self):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "verification.csv"
            table.write_text("pair,disagreements,force disagreements,bound disagreements\na,3,2,0\nb,1,1,0\n")
            self.assertEqual(checks.disagreements_by_kind(table), {"force": 3})

    def test_want_a_program_built_when_those_before_it_have_passed(self):
        first, second, *_ = [program.split("/")[-1] for program in checks.TEST_PROGRAMS["reference"]]
        built = []

        def run(command, *limits, **options):
            return self.ended(int(Path(command[0]).name == second), "")

        with unittest.mock.patch("checks.run", run):
            checks.Checks("nowhere", built.extend).check("tests", "reference", measure=True)
        self.assertEqual(built, [first, second])

    def test_end_programs_that_never_do(self):
        ended = checks.run([sys.executable, "-c", "while True: pass"], allowed=1)
        self.assertTrue(ended.ran_out_of_time)

    def test_are_none_where_the_machine_killed_the_program(self):
        kill_itself = "import os, signal; os.kill(os.getpid(), signal.SIGKILL)"
        with self.assertRaisesRegex(checks.MachineFailed, "killed from outside"):
            checks.run([sys.executable, "-c", kill_itself], allowed=100)

    def test_of_builds_tell_sources_from_the_machine(self):
        self.assertTrue(is_of_sources("fast/a.cpp:3:9: error: 'b' was not declared in this scope\n"))
        self.assertTrue(is_of_sources("/usr/bin/ld: a.o: in function `f':\na.cpp:(.text+0x5): undefined reference to `g'\n"))
        self.assertFalse(is_of_sources("fatal error: error writing to /tmp/a.s: No space left on device\n"))
        self.assertFalse(is_of_sources("fast/a.cpp:3:9: error: x\nc++: fatal error: Killed signal terminated program\n"))
        self.assertFalse(is_of_sources("ninja: fatal: posix_spawn: Resource temporarily unavailable\n"))


class Options(unittest.TestCase):
    def refused(self, *options):
        command = [sys.executable, ROOT / "tests" / "mutants" / "mutants.py", *options]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 2)
        return ended.stderr

    def test_that_say_nothing_are_refused(self):
        self.assertIn("'-1' is no whole number from 0 on", self.refused("--list", "--", "-1"))
        self.assertIn("'x' is no whole number from 1 on", self.refused("--poses", "500,x"))
        self.assertIn("'0' is no whole number from 1 on", self.refused("--jobs", "0"))
        self.assertIn("room compare is none of fast, reference", self.refused("--list", "--rooms", "compare"))


class Report(unittest.TestCase):
    def entry(self, state, found, **more):
        entry = {"id": "a", "room": "fast", "file": "fast/a.cpp", "line": 3, "kind": "sign", "why": "", "before": "-"}
        entry |= {"after": "", "code": "a = «- → »b;", "state": state, "checks": found}
        return entry | more

    def test_counts_each_mutant_where_it_was_caught_first(self):
        passed = {"by": "", "poses": 0, "disagreements": 0, "seconds": 1}
        failed = {"by": "force", "poses": 500, "disagreements": 7, "seconds": 1}
        entries = [
            self.entry("caught", {"tests": passed, "verify": failed}),
            self.entry("caught", {"tests": failed, "verify": failed}),
            self.entry("survived", {"tests": passed, "verify": passed}),
            self.entry("not a program", {}),
        ]
        self.assertIn("| fast, drawn | 3 | 1 | 1 | 0 | 1 | 1 |", report.summary_table(entries))
        self.assertIn("force (7 of 500 poses)", report.markdown(entries))
        with tempfile.TemporaryDirectory() as folder:
            report.write(entries, Path(folder))
            self.assertEqual(len((Path(folder) / "mutants.csv").read_text().splitlines()), 5)


class AMutant(unittest.TestCase):
    def test_knows_its_line(self):
        self.assertEqual(Mutant("fast", "fast/a.cpp", 4, "b", "c", "call").line_in("a\na\nb\n"), 3)

    def test_shows_its_line_with_the_fault_marked(self):
        mutant = Mutant("fast", "fast/a.cpp", 10, "+", "-", "arithmetic")
        self.assertEqual(mutant.shown_in("a\n  b = c + d;\n"), "b = c «+ → -» d;")


if __name__ == "__main__":
    unittest.main()
