// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever the user can get wrong ends with status 2, one line on standard error that names it, and no output.

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "tests/compare/run_pcm.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

constexpr std::string_view kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

void expect_one_line_naming(const Outcome& outcome, const std::string& named) {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find(named), std::string::npos) << "expected '" << named << "' in: " << outcome.err;
}

void expect_bad_input(const Words& arguments, const std::string& named) {
  const Outcome outcome = run_pcm(arguments);
  expect_one_line_naming(outcome, named);
  EXPECT_EQ(outcome.out, "");
}

class ProgramBadInput : public testing::Test {
 protected:
  const TemporaryFolder scratch_;
  const std::string surface_ = scratch_.write("tetrahedron.obj", kTetrahedron);

  void expect_bad_contact(const Words& options, const std::string& named) {
    Words arguments{"contact", surface_, surface_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    SCOPED_TRACE(testing::PrintToString(options));
    expect_bad_input(arguments, named);
  }

  void expect_bad_surface(const std::string& file, const std::string& named) {
    SCOPED_TRACE(file);
    expect_bad_input({"contact", file, surface_}, named);
    expect_bad_input({"contact", surface_, file, "--engine", "reference"}, named);
  }

  void expect_bad_poses(const std::string& text, const std::string& named) {
    SCOPED_TRACE(text);
    expect_bad_contact({"--poses", scratch_.write("poses.txt", text)}, named);
  }
};

TEST_F(ProgramBadInput, NamesLongerThanFileSystemsTake) {
  const std::string name(300, 'a');
  expect_bad_contact({"--csv", name + "/x.csv"}, name + "/x.csv: File name too long");
  expect_bad_contact({"--elements", name}, name + ": File name too long");
  expect_bad_contact({"--poses", name}, name + ": ");
  expect_bad_surface(name + ".obj", name + ".obj: ");
  expect_bad_input({"verify", "--poses", "1", "--out", name}, name + ": ");
  expect_bad_input({"simulate", name}, name + ": ");
}

TEST_F(ProgramBadInput, CommandsAndOptions) {
  expect_bad_input({}, "command");
  expect_bad_input({"frobnicate"}, "frobnicate");
  expect_bad_input({"--frobnicate"}, "--frobnicate");
  expect_bad_input({"mesh"}, "command");
  expect_bad_input({"mesh", "frobnicate"}, "frobnicate");
  expect_bad_input({"contact"}, "E");
  expect_bad_input({"contact", surface_}, "F");
  expect_bad_input({"contact", surface_, surface_, surface_}, surface_);
  expect_bad_input({"mesh", "check"}, "FILE");
  expect_bad_input({"mesh", "check", "--frobnicate", surface_}, "--frobnicate");
  expect_bad_contact({"--frobnicate"}, "--frobnicate");
  expect_bad_contact({"--poses"}, "--poses");
  expect_bad_contact({"--engine", "slow"}, "--engine");
  expect_bad_contact({"--engine=fast", "--engine=fast"}, "--engine");
  expect_bad_contact({"--mode", "G"}, "--mode");
  expect_bad_contact({"--scheme", "other"}, "--scheme");
  expect_bad_contact({"--engine", "reference", "--bound"}, "--bound");
  expect_bad_contact({"--engine", "published-2003", "--bound"}, "--bound");
  expect_bad_contact({"--engine", "published-2003", "--problem", "exact"}, "--problem");
  expect_bad_contact({"--engine", "published-2023", "--scheme", "clipped"}, "--engine");
  expect_bad_contact({"--engine", "reference", "--problem", "other"}, "--problem");
  expect_bad_contact({"--problem", "exact"}, "--problem");
}

TEST_F(ProgramBadInput, NumbersOfTheLaw) {
  for (const std::string option : {"--stiffness", "--max-penetration"}) {
    for (const std::string value : {"0", "-1", "nan", "inf", "1e999", "", "1x", "1,0"})
      expect_bad_contact({option + "=" + value}, option);
  }
  for (const std::string option : {"--damping", "--transition-depth", "--friction", "--slip-velocity"}) {
    for (const std::string value : {"-1", "nan", "inf", "-inf", "1e999", "one"})
      expect_bad_contact({option + "=" + value}, option);
  }
  expect_bad_contact({"--damping", "-1"}, "--damping");
  for (const std::string option : {"--stiffness", "--damping", "--max-penetration"})
    expect_bad_contact({option, ""}, option);
  expect_bad_contact({"--damping-mode", "half"}, "--damping-mode");
}

TEST_F(ProgramBadInput, Layers) {
  expect_bad_contact({"--stiffness-E=1e6"}, "--stiffness-F");
  expect_bad_contact({"--stiffness-F=1e6"}, "--stiffness-E");
  expect_bad_contact({"--stiffness-E=inf", "--stiffness-F=inf"}, "rigid");
  expect_bad_contact({"--stiffness-E=0", "--stiffness-F=1"}, "--stiffness-E");
  expect_bad_contact({"--stiffness-E=1", "--stiffness-F=nan"}, "--stiffness-F");
  expect_bad_contact({"--stiffness=1", "--stiffness-E=1", "--stiffness-F=1"}, "--stiffness");
  expect_bad_contact({"--layer-E=1e6,0.3,0.01"}, "--layer-F");
  expect_bad_contact({"--layer-E=1e6,0.3,0.01", "--layer-F=1e6,0.3,0.01", "--stiffness=1"}, "--stiffness");
  expect_bad_contact({"--layer-E=inf,0.3,0.01", "--layer-F=inf,0.3,0.01"}, "rigid");
  for (const std::string value : {"1e6,0.3", "1e6,0.3,0.01,1", "0,0.3,0.01", "1e6,0.45,0.01", "1e6,-1,0.01",
                                  "1e6,0.3,0", "1e6,0.3,inf", "1e6,nan,1", "1e308,0.3,1e-308", ",,"})
    expect_bad_contact({"--layer-E=1e6,0.3,0.01", "--layer-F=" + value}, "--layer-F");
}

TEST_F(ProgramBadInput, Surfaces) {
  expect_bad_surface(scratch_.path("missing.obj"), "missing.obj");
  expect_bad_surface(scratch_.path("."), scratch_.path("."));
  std::filesystem::create_directory(scratch_.path("folder.obj"));
  expect_bad_surface(scratch_.path("folder.obj"), "folder.obj");
  expect_bad_surface(scratch_.write("binary.obj", std::string_view("v 0 0\0 0\n", 9)), "binary.obj");
  expect_bad_surface(scratch_.write("empty.obj", ""), "empty.obj");
  expect_bad_surface(scratch_.write("no_face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "no_face.obj");
  expect_bad_surface(scratch_.write("number.obj", "v 0 0 zero\n"), "number.obj:1");
  expect_bad_surface(scratch_.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "index.obj:4");
  expect_bad_surface(scratch_.write("corners.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), "corners.obj:4");
  expect_bad_surface(scratch_.write("infinite.obj", "v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n"), "infinite.obj:2");
  expect_bad_surface(scratch_.write("surface.stl", kTetrahedron), "surface.stl");
}

TEST_F(ProgramBadInput, UnfitSurfaces) {
  expect_bad_surface(scratch_.write("zero_area.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "zero_area.obj");
  expect_bad_surface(scratch_.write("inside_out.obj",
                                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                    "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"),
                     "inside_out.obj");
}

TEST_F(ProgramBadInput, Poses) {
  expect_bad_contact({"--poses", scratch_.path("missing.txt")}, "missing.txt");
  expect_bad_contact({"--poses", scratch_.path("")}, "folder");
  expect_bad_poses("", "poses.txt");
  expect_bad_poses("# only a comment\n\n", "poses.txt");
  expect_bad_poses("# comment\n\n1 0 0 0 1 0 0 0 1 0 0\n", "poses.txt:3");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 0 0\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 0 0 0 0 0 0 0 0\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 nan\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 inf\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 1e999\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 0x\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1 0 0 0,\n", "poses.txt:1");
  expect_bad_poses("1 0 0 0 1 0 0 0 1.00000001 0 0 0\n", "rotation");
  expect_bad_poses("1 0 0 0 1 0 0 0 -1 0 0 0\n", "rotation");
  expect_bad_poses("1e200 0 0 0 1 0 0 0 1 0 0 0\n", "rotation");
  expect_bad_poses(std::string(2'000'000, '1'), "poses.txt:1");
}

TEST_F(ProgramBadInput, ABadPoseLeavesTheLinesBeforeIt) {
  const std::string poses = scratch_.write("poses.txt", "1 0 0 0 1 0 0 0 1 5 5 5\n\n1 2 3\n");
  const Outcome outcome = run_pcm({"contact", surface_, surface_, "--poses", poses});
  expect_one_line_naming(outcome, "poses.txt:3");
  EXPECT_EQ(lines_of(outcome.out).size(), 1U);
}

TEST_F(ProgramBadInput, EndlessDevices) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "this system has no /dev/zero";
  std::filesystem::create_symlink("/dev/zero", scratch_.path("endless.obj"));
  expect_bad_surface(scratch_.path("endless.obj"), "binary");
  expect_bad_contact({"--poses", "/dev/zero"}, "/dev/zero:1");
}

TEST_F(ProgramBadInput, LawOfVerifyWhereItHasNoPart) {
  for (const char* other : {"--audits", "--known-answers", "--error-budget", "--stability"})
    expect_bad_input({"verify", other, "--quick", "--friction", "0.5"}, "random poses");
  expect_bad_input({"verify", "--case", "case.json", "--stiffness", "1e5"}, "random poses");
  expect_bad_input({"verify", "--poses", "6", "--stiffness", "-1"}, "--stiffness");
}

TEST_F(ProgramBadInput, OptionsOfVerify) {
  for (const std::string value : {"0", "-1", "1e3", "1.5", "", "99999999999999999999", "all"})
    for (const std::string option : {"--poses", "--jobs"}) expect_bad_input({"verify", option, value}, option);
  for (const std::string value : {"-1", "x", "18446744073709551616"})
    expect_bad_input({"verify", "--seed", value}, "--seed");
  expect_bad_input({"verify", "--strata", "generic,sausage"}, "sausage");
  expect_bad_input({"verify", "--pair", surface_, surface_, "--pair", surface_, surface_, "--poses", "12"}, "pair ");
  expect_bad_input({"verify", "--pair", surface_, surface_, "--strata", "generic,grazing", "--poses", "1"}, "generic");
  expect_bad_input({"verify", "--pair", surface_}, "--pair");
  expect_bad_input({"verify", "--pair", surface_, surface_, surface_}, surface_);
  expect_bad_input({"verify", "--pair", surface_, scratch_.path("missing.obj")}, "missing.obj");
  expect_bad_input({"verify", "--poses", "6", "--out", surface_}, surface_);
  expect_bad_input({"verify", "--poses", "6", "--out", ""}, "--out");
  expect_bad_input({"verify", "--case", ""}, "--case: the value is empty");
  expect_bad_input({"verify", "--case", scratch_.path("missing.json")}, "missing.json");
  expect_bad_input({"verify", "--case", scratch_.path("")}, "folder");
  expect_bad_input({"verify", "--case", surface_}, "no case file");
  expect_bad_input({"verify", "--engine", "slow"}, "--engine");
  expect_bad_input({"verify", "--engine", "published-2003", "--scheme", "clipped"}, "--engine");
  expect_bad_input({"verify", "--audits", "--engine", "published-2003"}, "--audits");
  expect_bad_input({"verify", "--quick"}, "--quick goes with --known-answers, --error-budget, --audits or --stability");
  expect_bad_input({"verify", "--error-budget", "--known-answers"}, "--error-budget");
  expect_bad_input({"verify", "--error-budget", "--scheme", "clipped"}, "--error-budget");
  expect_bad_input({"verify", "--stability", "--scheme", "clipped"}, "--stability");
  expect_bad_input({"verify", "--stability", "--audits"}, "--stability");
  expect_bad_input({"verify", "--stability", "--quick", "--seed", "x"}, "--seed");
  expect_bad_input({"verify", "--error-budget", "--quick", "--jobs", "0"}, "--jobs");
  expect_bad_input({"verify", "--error-budget", "--quick", "--out", surface_}, surface_);
}

TEST_F(ProgramBadInput, FolderOfARefusedRunIsLeftAsItIs) {
  std::filesystem::create_directory(scratch_.path("run"));
  const std::string own = scratch_.write("run/state.probe", "precious");
  expect_bad_input({"verify", "--strata", "generic,grazing", "--pair", surface_, surface_, "--poses", "1", "--out",
                    scratch_.path("run")},
                   "generic");
  EXPECT_EQ(content_of(own), "precious");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch_.path("run")), {}), 1);
}

TEST_F(ProgramBadInput, EmptyValuesAreNotTakenForOptionsThatAreNotGiven) {
  expect_bad_input({"contact", "", surface_}, "E: the value is empty");
  expect_bad_input({"verify", "--out", "", "--poses", "6"}, "--out: the value is empty");
  expect_bad_input({"simulate", "bubbles", "--duration", ""}, "--duration: the value is empty");
  expect_bad_input({"simulate", "bubbles", "--integrator", ""}, "--integrator: the value is empty");
}

TEST_F(ProgramBadInput, AnEmptyValueBehindAnEqualsSignDoesNotTakeTheNextOptionForIt) {
  expect_bad_contact({"--csv=", "--full"}, "--csv: the value is empty");
  expect_bad_contact({"--poses=", "--full"}, "--poses: the value is empty");
  expect_bad_input({"poses", "--out=", "--catalogue"}, "--out: the value is empty");
  expect_bad_input({"simulate", "bubbles", "--out=", "--print"}, "--out: the value is empty");
}

TEST_F(ProgramBadInput, ListsWithEmptyItems) {
  const std::string out = scratch_.path("out");
  for (const std::string list : {"generic,,nested", "generic,", ",generic"}) {
    expect_bad_input({"poses", "--out", out, "--poses", "6", "--strata", list},
                     "--strata: '" + list + "' has an empty");
    expect_bad_input({"verify", "--poses", "6", "--strata=" + list}, "--strata: '" + list + "' has an empty");
  }
  expect_bad_input({"verify", "--poses", "6", "--strata", "generic", "nested,"}, "--strata: 'nested,' has an empty");
  expect_bad_input({"verify", "--poses", "6", "--engine", "fast,"}, "--engine: 'fast,' has an empty");
  expect_bad_input({"judge", "a.jsonl", "--poses", out, "--tolerance", "force=1,,torque=1"}, "--tolerance: ");
  expect_bad_input({"inspect", surface_, surface_, "--path", surface_, "--normal", "0,0,1,"}, "--normal: ");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(ProgramBadInput, StateOfAVerificationThatIsDamagedOrAnothers) {
  const std::string folder = scratch_.path("run");
  const Words verify{"verify", "--poses", "6", "--pair", surface_, surface_, "--out", folder};
  ASSERT_EQ(run_pcm(verify).status, 0);
  Words other = verify;
  other[2] = "7";
  expect_bad_input(other, folder);

  const std::string kept = content_of(folder + "/campaign.sqlite");
  std::string altered = kept;
  const std::string poses = "\"poses\":6";
  ASSERT_NE(altered.find(poses), std::string::npos);
  altered.replace(altered.find(poses), poses.size(), "\"poses\":5");
  for (const std::string& damaged : {kept.substr(0, kept.size() / 2), std::string("{}"), altered}) {
    scratch_.write("run/campaign.sqlite", damaged);
    expect_one_line_naming(run_pcm(verify), "run");
  }
}

TEST_F(ProgramBadInput, MakingAndConverting) {
  expect_bad_input({"mesh", "make"}, "NAME");
  expect_bad_input({"mesh", "make", "sausage"}, "sausage");
  expect_bad_input({"mesh", "make", "wedge", "--tilt_degrees=1e-300"}, "wedge: with these parameters a coordinate is");
  expect_bad_input({"mesh", "make", "box", "--sausage=1"}, "sausage");
  expect_bad_input({"mesh", "make", "box", "-o", "box.OFF"}, "only Wavefront OBJ is written");
  expect_bad_input({"mesh", "make", "box", "--extent_x"}, "--extent_x");
  expect_bad_input({"mesh", "make", "box", "--extent_x=0"}, "extent_x");
  expect_bad_input({"mesh", "make", "box", "--extent_x=nan"}, "extent_x");
  expect_bad_input({"mesh", "make", "box", "--extent_x=1", "--extent_x=2"}, "--extent_x");
  expect_bad_input({"mesh", "make", "box", "--extent_x=1", "--extent-x=2"}, "--extent_x: it is given twice");
  expect_bad_input({"mesh", "make", "box", "-o=box.obj"}, "-o=box.obj: leave out '='");
  expect_bad_input({"mesh", "make", "box", "sausage"}, "sausage");
  expect_bad_input({"mesh", "make", "torus", "--segments=3.5"}, "segments");
  expect_bad_input({"mesh", "make", "box", "-o", scratch_.path("nowhere/box.obj")}, "nowhere");
  expect_bad_input({"mesh", "make", "box", "-o", scratch_.path("")}, scratch_.path(""));
  expect_bad_input({"mesh", "make", "box", "-o", "-"}, "-o: name a file");
  expect_bad_input({"mesh", "make", "box", "-o", ""}, "--output: the value is empty");
  expect_bad_input({"mesh", "convert", surface_}, "OUT");
  expect_bad_input({"mesh", "convert", surface_, scratch_.path("out.stl")}, "out.stl");
  expect_bad_input({"mesh", "convert", scratch_.path("missing.obj"), scratch_.path("out.obj")}, "missing.obj");
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("out.obj")));
  const std::string before = content_of(surface_);
  expect_bad_input({"mesh", "convert", surface_, surface_}, "name another file for OUT");
  EXPECT_EQ(content_of(surface_), before);
}

TEST_F(ProgramBadInput, OutputThatCannotBeWritten) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const Words& arguments :
       {Words{"--help"}, Words{"--version"}, Words{"contact", "--help"}, Words{"mesh", "make", "box"},
        Words{"mesh", "check", surface_}, Words{"contact", surface_, surface_}}) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    expect_one_line_naming(run_pcm(arguments, "/dev/full"), "standard output");
  }
}

}  // namespace
}  // namespace pcm::compare
