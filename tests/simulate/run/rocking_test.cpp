// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A box that rocks on a plate, through the whole path: scene file, Simbody's model, contact, integrator.
//
// The plate's faces carry the elements (mode E), its layer is a million times as stiff as the box's, so that forces act
// in the plate's plane (13) and upwards. An elastic foundation on a plane is then a fluid of weight density c: its
// force is c times the volume that the box displaces, through that volume's centre.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/simulate/run/run_scene.h"

namespace pcm::simulate::rocking_test {
namespace {

class Rocking : public KnownMotion {};
INSTANTIATE_TEST_SUITE_P(Methods, Rocking, kEachMethodOfHigherOrder, method_name);

constexpr double kMass = 50, kGravity = 9.81, kStiffness = 1e6;                  // kg, m/s^2, N/m^3
constexpr double kWidth = 0.4, kBreadth = 0.5, kHeight = 0.6;                    // along x, y, z, m
constexpr double kInertia = kMass * (kWidth * kWidth + kHeight * kHeight) / 12;  // about y
constexpr double kFriction = 0.5, kSlipVelocity = 1e-2;

/// The scene of a box whose centre is at (0, 0, z), turned by `angle` about y.
std::string box_on_plate(double friction, double z, double angle, double duration) {
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return std::string(text);
  };
  return R"({"laws": {"law": {"layers": [1e12, )" + number(kStiffness) + R"(], "slip_velocity": )" +
         number(kSlipVelocity) + R"(, "friction": )" + number(friction) + R"(}},
    "ground": {"surfaces": [{"name": "plate", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 3, "thickness": 2}}]},
    "bodies": [{"name": "box", "mass": 50, "at": {"position": [0, 0, )" +
         number(z) + R"(], "rotation": {"axis": [0, 1, 0], "angle": )" + number(angle) + R"(}},
      "surfaces": [{"name": "box", "make": "box", "parameters": {"extent_x": 0.4, "extent_y": 0.5, "extent_z": 0.6}}]}],
    "pairings": [{"E": "plate", "F": "box", "law": "law", "mode": "E", "scheme": "clipped"}],
    "gravity": [0, 0, -9.81], "duration": )" +
         number(duration) + R"(, "integrator": {"greatest_step": 0.005}})";
}

/// Of a free joint's quaternion that turns about y.
double angle_of(const Eigen::VectorXd& y) {
  return 2 * std::atan2(y[2], y[0]);
}

/// Errors of steps are up to 500 times the tolerance where nothing amplifies them (integrators/accuracy_test.cpp).
constexpr double kTolerance = 1e-8, kError = 500 * kTolerance;

/// The box afloat: how deep it lies, and the circular frequencies of its roll and its heave. The metacentre is above
/// the centre of buoyancy by I_foot / V, V = m g / c, and m g GM restores the roll, GM = I_foot / V - (h - draught)
/// / 2. Another m g draught / 4 does: where the side that rises overhangs, draught^2 / 2 times the angle of the cross
/// section displaces nothing (see `displaced`).
struct Ship {
  double volume = kMass * kGravity / kStiffness;
  double draught = volume / (kWidth * kBreadth);
  double metacentre = kBreadth * kWidth * kWidth * kWidth / 12 / volume - (kHeight - draught) / 2 + draught / 4;
  double roll = std::sqrt(kMass * kGravity * metacentre / kInertia);
  double heave = std::sqrt(kStiffness * kWidth * kBreadth / kMass);
};

// While the whole foot stays in contact, the box is a ship. To the first order in the angle it rolls, and does not move
// otherwise. To the second it displaces angle^2 h / 4 more at twice the frequency, near that of its heave; with the
// force of that the part of weight in the roll's stiffness varies, (h / 2) / GM of it.
TEST_P(Rocking, OfABoxThatStandsIsAShipsRoll) {
  constexpr double kAngle = 1e-3, kEnd = 0.5;
  const Ship ship;
  const double w = ship.roll;
  ASSERT_LT(kAngle * kWidth / 2, ship.draught);
  const double moved = kAngle * kAngle * kHeight / 4 / std::abs(1 - std::pow(2 * w / ship.heave, 2));
  const double bound = kError + kAngle * (w * kEnd / 2) * (moved / ship.draught) * (kHeight / 2 / ship.metacentre);
  const Scene scene = scene_with(box_on_plate(0, kHeight / 2 - ship.draught, kAngle, kEnd), GetParam(), kTolerance);
  const Eigen::VectorXd y = end_of(scene);
  std::printf("angle %.9f, closed form %.9f; rate %.9f, %.9f; bound %.3g\n", angle_of(y), kAngle * std::cos(w * kEnd),
              y[kWy], -kAngle * w * std::sin(w * kEnd), bound);
  EXPECT_NEAR(angle_of(y), kAngle * std::cos(w * kEnd), bound);
  EXPECT_NEAR(y[kWy], -kAngle * w * std::sin(w * kEnd), w * bound);
  EXPECT_NEAR(y[kX], 0, kError);
  EXPECT_NEAR(y[kZ], kHeight / 2 - ship.draught, kError + 2 * moved);
}

/// x, z, angle about y, and their rates.
using PlaneState = Eigen::Matrix<double, 6, 1>;

/// Of a convex polygon, what is not above the zero of a height that is linear in the place.
template <typename Height>
std::vector<Eigen::Vector2d> part_below(const std::vector<Eigen::Vector2d>& polygon, const Height& height) {
  std::vector<Eigen::Vector2d> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double h_a = height(a), h_b = height(b);
    if (h_a <= 0) part.push_back(a);
    if ((h_a <= 0) != (h_b <= 0)) part.push_back(a + h_a / (h_a - h_b) * (b - a));
  }
  return part;
}

/// The box's cross section, counterclockwise in x and z.
std::vector<Eigen::Vector2d> cross_section(const PlaneState& s) {
  const double sine = std::sin(s[2]), cosine = std::cos(s[2]);
  std::vector<Eigen::Vector2d> corners;
  for (const auto& [side, end] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    const double X = side * kWidth / 2, Z = end * kHeight / 2;
    corners.emplace_back(s[0] + cosine * X + sine * Z, s[1] - sine * X + cosine * Z);
  }
  return corners;
}

struct Displaced {
  double area = 0, first_moment = 0;  ///< m^2, m^3: about x = 0
};

/// The part of the box's cross section below the waterline: below z = 0, and not where a side overhangs, for the
/// plate's penetration line enters the box there.
Displaced displaced(const PlaneState& s) {
  const std::vector<Eigen::Vector2d> box = cross_section(s);
  std::vector<Eigen::Vector2d> below = part_below(box, [](const Eigen::Vector2d& p) { return p[1]; });
  double left = s[0] + kHeight, right = s[0] - kHeight;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Eigen::Vector2d &a = box[i], &b = box[(i + 1) % box.size()];
    if ((a[1] <= 0) == (b[1] <= 0)) continue;
    const double crossing = a[0] + a[1] / (a[1] - b[1]) * (b[0] - a[0]);
    left = std::min(left, crossing);
    right = std::max(right, crossing);
  }
  below = part_below(below, [=](const Eigen::Vector2d& p) { return left - p[0]; });
  below = part_below(below, [=](const Eigen::Vector2d& p) { return p[0] - right; });
  Displaced result;
  for (std::size_t i = 0; i < below.size(); ++i) {
    const Eigen::Vector2d &a = below[i], &b = below[(i + 1) % below.size()];
    const double twice = a[0] * b[1] - b[0] * a[1];
    result.area += twice / 2;
    result.first_moment += twice * (a[0] + b[0]) / 6;
  }
  return result;
}

/// Buoyancy, gravity, and friction (20) in the plane z = 0, in which all points of the box slip alike.
PlaneState rate(const PlaneState& s) {
  const Displaced water = displaced(s);
  const double normal = kStiffness * kBreadth * water.area;
  const double slip = s[3] - s[5] * s[1], part = std::min(std::abs(slip) / kSlipVelocity, 1.0);
  const double friction = -std::copysign(kFriction * normal * part * (2 - part), slip);
  const double moment = -s[1] * friction - kStiffness * kBreadth * (water.first_moment - s[0] * water.area);
  PlaneState answer;
  answer << s[3], s[4], s[5], friction / kMass, normal / kMass - kGravity, moment / kInertia;
  return answer;
}

/// By the classical Runge-Kutta method: its steps of 1e-5 s are a tenth of what the stiffest friction, 2 mu F_n / (m
/// v_eps) with the greatest F_n of an impact, some 10 m g, is stable for, and its error is far below the integrators'.
PlaneState reference(PlaneState s, double end, const std::function<void(const PlaneState&)>& visit) {
  const int steps = static_cast<int>(std::lround(end / 1e-5));
  const double h = end / steps;
  for (int i = 0; i < steps; ++i) {
    const PlaneState a = rate(s), b = rate(s + h / 2 * a), c = rate(s + h / 2 * b), d = rate(s + h * c);
    s += h / 6 * (a + 2 * b + 2 * c + d);
    visit(s);
  }
  return s;
}

// Tipped on its edge, it falls back on its foot, rocks over to the other edge and back: it lifts off, lands and slips.
// Errors grow as an inverted pendulum's, by exp(p t), p^2 = m g R / I_edge = 3 g / (4 R) with R half the diagonal.
TEST_P(Rocking, OfABoxFromEdgeToEdgeIsThatOfItsPlaneEquations) {
  constexpr double kAngle = 0.05, kEnd = 0.5, kDepth = 0.004;
  const double z = kHeight / 2 * std::cos(kAngle) + kWidth / 2 * std::sin(kAngle) - kDepth;
  PlaneState start = PlaneState::Zero();
  start[1] = z;
  start[2] = kAngle;
  int landings = 0;
  double angle_before = kAngle;
  const PlaneState expected = reference(start, kEnd, [&](const PlaneState& s) {
    landings += (s[2] > 0) != (angle_before > 0);
    angle_before = s[2];
  });
  ASSERT_GE(landings, 2);
  const Eigen::VectorXd y = end_of(scene_with(box_on_plate(kFriction, z, kAngle, kEnd), GetParam(), kTolerance));
  const double growth = std::exp(std::sqrt(0.75 * kGravity / (std::hypot(kWidth, kHeight) / 2)) * kEnd);
  std::printf("x %.3g, z %.3g, angle %.3g off; angle %.6f, %d landings, growth %.3g\n", y[kX] - expected[0],
              y[kZ] - expected[1], angle_of(y) - expected[2], expected[2], landings, growth);
  EXPECT_NEAR(y[kX], expected[0], growth * kError);
  EXPECT_NEAR(y[kZ], expected[1], growth * kError);
  EXPECT_NEAR(angle_of(y), expected[2], growth * kError);
}

/// The box that stands and rolls, from 4e-3 rad on for 0.5 s, in steps without interruption.
Scene standing_box(const IntegratorSettings& settings) {
  Scene scene = scene_with(box_on_plate(0, kHeight / 2 - Ship().draught, 4e-3, 0.5), settings.method,
                           settings.relative_tolerance);
  scene.integrator = settings;
  scene.output.checkpoint_interval = scene.duration;
  return scene;
}

/// Angle, and its rate over the frequency, so that errors of phase and of amplitude weigh alike.
Eigen::Vector2d roll(const IntegratorSettings& settings) {
  const Eigen::VectorXd y = end_of(standing_box(settings));
  return {angle_of(y), y[kWy] / Ship().roll};
}

const IntegratorSettings kFinest{Method::dormand_prince, 1e-12, 1e-12, 5e-3};

// All errors are let pass, so that every step but the first few is the greatest; halved, the error falls by 2^order.
// The foot stays in contact, where forces are smooth.
TEST(Order, OfExplicitMethodsInASceneIsTheirs) {
  const Eigen::Vector2d expected = roll(kFinest);
  const auto observed = [&](Method method) {
    const auto error = [&](double step) { return (roll({method, 0.5, 1e6, step}) - expected).norm(); };
    const double coarse = error(0.01), fine = error(0.005);
    std::printf("%s: errors %.3g, %.3g rad, order %.2f\n", std::string(name(method)).c_str(), coarse, fine,
                std::log2(coarse / fine));
    return std::log2(coarse / fine);
  };
  EXPECT_NEAR(observed(Method::dormand_prince), 5, 0.3);
  EXPECT_NEAR(observed(Method::runge_kutta_merson), 4, 0.3);
}

// Error tests bound what a step commits; what becomes of that by the end falls at least by the power p / (p + 1) of the
// tolerance, with formulas of order p, here from 3 on: 10^(4 * 3 / 4).
TEST_P(Rocking, OfABoxThatStandsFollowsTheTolerance) {
  const Eigen::Vector2d expected = roll(kFinest);
  const auto error = [&](double tolerance) {
    return (roll({GetParam(), tolerance, tolerance, 0.05}) - expected).norm();
  };
  const double coarse = error(1e-5), fine = error(1e-9);
  std::printf("%s: errors %.3g, %.3g rad\n", std::string(name(GetParam())).c_str(), coarse, fine);
  EXPECT_LT(fine, 1e-3 * coarse);
}

}  // namespace
}  // namespace pcm::simulate::rocking_test
