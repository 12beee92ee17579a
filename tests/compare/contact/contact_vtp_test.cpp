// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Files for ParaView, as VTK's own reader understands them (Debian: python3-vtk9).
#include "compare/contact/contact_vtp.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <variant>

#include "meshes/generate/boxes.h"
#include "pcm/engine.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using nlohmann::json;

/// What VTK reads in a file; null where VTK is not installed.
json read_by_vtk(const std::string& file) {
  const std::string command = PCM_PYTHON " '" PCM_SOURCE_DIR "/tests/compare/contact/print_vtp.py' '" + file + "' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  const int status = pclose(pipe);
  constexpr int kNoVtk = 77, kNoPython = 127;
  if (WIFEXITED(status) && (WEXITSTATUS(status) == kNoVtk || WEXITSTATUS(status) == kNoPython)) return {};
  json read = json::parse(text, nullptr, false);
  EXPECT_TRUE(read.is_object()) << text;
  return read;
}

std::vector<double> numbers_of(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& x : points) numbers.insert(numbers.end(), x.data(), x.data() + 3);
  return numbers;
}

/// Two boxes, one put through the other's upper side: one polygon, elements on E.
class ContactVtp : public testing::Test {
 protected:
  const TriangleMesh E_ = generate::box({1, 1, 1}), F_ = generate::box({1, 1, 1});
  const Pose pose_{Eigen::Matrix3d{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}, {0.1, 0.2, 0.9}};
  const PlacedSurfaces placed_{E_, F_, pose_};
  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_.path("vtk");

  ContactRecord contact(const Eigen::Vector3d& r) {
    fast::Workspace workspace;
    const fast::Pairing pairing{fast::Surface(E_), fast::Surface(F_), {}, Mode::both, Scheme::barycentric};
    return contact_record(fast::evaluate(pairing, {pose_.A, r}, {}, {}, workspace), {});
  }
};

TEST_F(ContactVtp, VtkReadsSurfacesPolygonsAndElementsBitForBit) {
  const ContactRecord record = contact(pose_.r);
  ContactVtpFolder(folder_).write(record, placed_);
  const json E = read_by_vtk(folder_ + "/E_1.vtp");
  if (E.is_null()) GTEST_SKIP() << "VTK's Python module (Debian: python3-vtk9) is not installed";
  const json F = read_by_vtk(folder_ + "/F_1.vtp");
  for (const json* surface : {&E, &F}) {
    EXPECT_EQ((*surface)["errors"], 0);
    EXPECT_EQ((*surface)["polygons"], 12);
    EXPECT_EQ((*surface)["cells"], json(E_.faces));
  }
  EXPECT_EQ(E["points"], json(numbers_of(E_.vertices)));
  EXPECT_EQ(F["points"], json(numbers_of(placed_.vertices_F_Me)));
  std::vector<double> active(12, 0), pressures(12, 0), penetrations(12, 0);
  for (const Index f : record.E.intersected) active[static_cast<std::size_t>(f)] = 1;
  for (const Index f : record.E.inner) active[static_cast<std::size_t>(f)] = 2;
  for (const fast::Element& e : record.elements) {
    if (e.master != Side::E) continue;
    pressures[static_cast<std::size_t>(e.master_face)] = pressure(e);
    penetrations[static_cast<std::size_t>(e.master_face)] = e.penetration;
  }
  EXPECT_GT(*std::max_element(pressures.begin(), pressures.end()), 0);
  EXPECT_EQ(E["cell_data"]["active"], json(active));
  EXPECT_EQ(E["cell_data"]["pressure"], json(pressures));
  EXPECT_EQ(E["cell_data"]["penetration"], json(penetrations));

  const json polygons = read_by_vtk(folder_ + "/polygons_1.vtp");
  EXPECT_EQ(polygons["errors"], 0);
  ASSERT_EQ(record.polygons.size(), 1U);
  const std::vector<fast::Crossing>& crossings = record.polygons[0].points;
  std::vector<Eigen::Vector3d> points;
  std::vector<double> edge_of, edges, faces;
  for (const fast::Crossing& x : crossings) {
    points.push_back(x.position_Me);
    edge_of.push_back(x.edge_side == Side::E ? 0 : 1);
    edges.insert(edges.end(), {static_cast<double>(x.edge[0]), static_cast<double>(x.edge[1])});
    faces.push_back(x.face);
  }
  EXPECT_EQ(polygons["points"], json(numbers_of(points)));
  EXPECT_EQ(polygons["lines"], 1);
  std::vector<std::size_t> closed_line(crossings.size());
  std::iota(closed_line.begin(), closed_line.end(), 0);
  closed_line.push_back(0);
  EXPECT_EQ(polygons["cells"], json({closed_line}));
  EXPECT_EQ(polygons["point_data"]["edge_of"], json(edge_of));
  EXPECT_EQ(polygons["point_data"]["edge"], json(edges));
  EXPECT_EQ(polygons["point_data"]["face"], json(faces));
  EXPECT_EQ(polygons["cell_data"]["closed"], json({1.0}));

  const json elements = read_by_vtk(folder_ + "/elements_1.vtp");
  EXPECT_EQ(elements["errors"], 0);
  EXPECT_EQ(elements["vertices"], record.elements.size());
  std::vector<Eigen::Vector3d> positions, forces;
  std::vector<double> element_pressures, element_penetrations, masters;
  for (const fast::Element& e : record.elements) {
    positions.push_back(e.position_Me);
    forces.push_back(e.force_Me);
    element_pressures.push_back(e.normal_force / e.area);
    element_penetrations.push_back(e.penetration);
    masters.push_back(e.master == Side::E ? 0 : 1);
  }
  EXPECT_EQ(elements["points"], json(numbers_of(positions)));
  EXPECT_EQ(elements["point_data"]["force"], json(numbers_of(forces)));
  EXPECT_EQ(elements["point_data"]["pressure"], json(element_pressures));
  EXPECT_EQ(elements["point_data"]["penetration"], json(element_penetrations));
  EXPECT_EQ(elements["point_data"]["master"], json(masters));
}

TEST_F(ContactVtp, VtkReadsFilesWithoutPolygonsAndElements) {
  ContactVtpFolder(folder_).write(contact({5, 0, 0}), placed_);
  for (const std::string file : {"/polygons_1.vtp", "/elements_1.vtp"}) {
    const json read = read_by_vtk(folder_ + file);
    if (read.is_null()) GTEST_SKIP() << "VTK's Python module (Debian: python3-vtk9) is not installed";
    EXPECT_EQ(read["errors"], 0) << file;
    EXPECT_EQ(read["points"], json::array());
    EXPECT_EQ(read["cells"], json::array());
  }
}

TEST_F(ContactVtp, TheCollectionShowsFourPartsAtEachPose) {
  ContactVtpFolder folder(folder_);
  for (int i = 0; i < 2; ++i) folder.write(contact(pose_.r), placed_);
  const std::string list = content_of(folder_ + "/contacts.pvd");
  for (const std::string entry :
       {R"(timestep="1" part="0" file="E_1.vtp")", R"(timestep="1" part="3" file="elements_1.vtp")",
        R"(timestep="2" part="1" file="F_2.vtp")", R"(timestep="2" part="2" file="polygons_2.vtp")"})
    EXPECT_NE(list.find(entry), std::string::npos) << entry << " in " << list;
  EXPECT_TRUE(list.ends_with("</Collection>\n</VTKFile>\n"));
  EXPECT_EQ(list.find("</Collection>"), list.rfind("</Collection>"));
}

TEST_F(ContactVtp, WithoutPolygonsThatWereNotWantedThreePartsAreShown) {
  ContactVtpFolder(folder_).write(contact(pose_.r), placed_, false);
  EXPECT_EQ(content_of(folder_ + "/contacts.pvd").find("polygons"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/polygons_1.vtp"));
}

TEST_F(ContactVtp, TensionIsANegativePressureOfItsFace) {
  ContactRecord record;
  fast::Element pulled;
  pulled.master_face = 3;
  pulled.area = 0.5;
  pulled.normal_force = -2;
  record.elements = {pulled};
  const VtpPolyData data = surface_vtp(record, placed_, Side::E);
  const auto& pressures = std::get<std::vector<double>>(data.cell_data.front().values);
  EXPECT_EQ(pressures[3], -4);
  EXPECT_EQ(pressures[2], 0);
}

TEST_F(ContactVtp, AFolderThatCannotBeMadeIsRefused) {
  expect_bad_input([] { ContactVtpFolder("/dev/null/there"); }, "can't be created");
}

}  // namespace
}  // namespace pcm::compare
