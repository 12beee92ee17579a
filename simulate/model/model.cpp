// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/model/model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "pcm/bad_input.h"
#include "pcm/simbody.h"

namespace pcm::simulate {
namespace {

SimTK::Vec3 to_simtk(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

SimTK::Transform to_simtk(const Placement& placement) {
  SimTK::Mat33 R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = placement.R(i, j);
  return {SimTK::Rotation(R), to_simtk(placement.p)};
}

/// Simbody counts inertia about the body's origin: Steiner's theorem.
SimTK::MassProperties to_simtk(const MassProperties& mass) {
  const Eigen::Vector3d& c = mass.centre_B;
  const Eigen::Matrix3d I =
      mass.inertia_B + mass.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  return {mass.mass, to_simtk(c), SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))};
}

SimTK::MobilizedBody mobilized(SimTK::MobilizedBody& parent, const Joint& joint, const SimTK::Body& body) {
  const SimTK::Transform in_parent = to_simtk(joint.in_parent), in_body = to_simtk(joint.in_body);
  switch (joint.type) {
    case JointType::weld:
      return SimTK::MobilizedBody::Weld(parent, in_parent, body, in_body);
    case JointType::pin:
      return SimTK::MobilizedBody::Pin(parent, in_parent, body, in_body);
    case JointType::slider:
      return SimTK::MobilizedBody::Slider(parent, in_parent, body, in_body);
    case JointType::universal:
      return SimTK::MobilizedBody::Universal(parent, in_parent, body, in_body);
    case JointType::gimbal:
      return SimTK::MobilizedBody::Gimbal(parent, in_parent, body, in_body);
    case JointType::ball:
      return SimTK::MobilizedBody::Ball(parent, in_parent, body, in_body);
    case JointType::free:
      return SimTK::MobilizedBody::Free(parent, in_parent, body, in_body);
  }
  throw BadInput("joint: no such type");
}

/// Vectors without coordinates are the same: they have no memory to compare.
bool same_bits(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0);
}

/// dy/dt of a state that is realized to Stage::Acceleration.
void read_slope(const SimTK::State& state, Eigen::VectorXd& dydt) {
  const SimTK::Vector &qdot = state.getQDot(), &udot = state.getUDot();
  for (int i = 0; i < qdot.size(); ++i) dydt[i] = qdot[i];
  for (int i = 0; i < udot.size(); ++i) dydt[qdot.size() + i] = udot[i];
}

bool has_quaternion(JointType type) {
  return type == JointType::ball || type == JointType::free;
}

}  // namespace

struct Model::Data {
  explicit Data(const Scene& from);

  SimTK::MobilizedBody& carrier_of(Index body) {
    if (body < 0) return matter.updGround();
    return bodies[static_cast<std::size_t>(body)];
  }
  void add_body(const Body& body);
  void add_joint_forces(const Joint& joint, const SimTK::MobilizedBody& body);
  /// y into `of`, realized to `stage`.
  void realize(SimTK::State& of, double t, const Eigen::VectorXd& y, SimTK::Stage stage) const;
  /// y into `state`, likewise. Where it is there already, what is known of it stays known.
  void realize(double t, const Eigen::VectorXd& y, SimTK::Stage stage);
  Eigen::VectorXd y() const;
  void observe_contact(Index pairing, const fast::Contact& contact, Observation& observation) const;
  double joint_power() const;
  double kinetic_energy() const;

  Scene scene;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::Gravity gravity;
  pcm::simbody::ContactForces contacts{forces, matter};
  std::vector<SimTK::MobilizedBody> bodies;
  struct Damper {
    SimTK::MobilizedBodyIndex body;
    SimTK::MobilizerUIndex speed;
    double damping;
  };
  std::vector<Damper> dampers;
  struct Bumper {
    SimTK::MobilizedBodyIndex body;
    Limit limit;
    SimTK::Force::MobilityLinearStop force;
  };
  std::vector<Bumper> bumpers;
  bool moves_by_prescription = false;
  SimTK::State state;
  Eigen::VectorXd realized_y;  ///< of `state`, empty before the first
  SimTK::State linear_state;   ///< its forces are by tangents
  ModelCounters counters;
};

Model::Data::Data(const Scene& from) : scene(from) {
  gravity = SimTK::Force::Gravity(forces, matter, to_simtk(scene.gravity_G));
  for (const Body& body : scene.bodies) add_body(body);
  for (const SceneSurface& surface : scene.surfaces) {
    const SimTK::MobilizedBody& carrier = carrier_of(surface.body);
    contacts.add_surface(carrier, to_simtk(surface.at_B), surface.surface);
  }
  for (const ScenePairing& p : scene.pairings) contacts.add_pairing(p.E, p.F, p.law, p.mode, p.scheme);
  state = system.realizeTopology();
  matter.setUseEulerAngles(state, false);
  system.realizeModel(state);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Joint& joint = scene.bodies[b].joint;
    for (std::size_t i = 0; i < joint.coordinates.size(); ++i)
      bodies[b].setOneQ(state, static_cast<int>(i), joint.coordinates[i]);
    for (std::size_t i = 0; i < joint.speeds.size(); ++i)
      bodies[b].setOneU(state, static_cast<int>(i), joint.speeds[i]);
    if (joint.prescribed_speed) bodies[b].setOneU(state, 0, *joint.prescribed_speed);
    if (joint.type != JointType::free) continue;
    // Simbody places frame K in frame J; ours is B in G.
    system.realize(state, SimTK::Stage::Position);
    const Body& body = scene.bodies[b];
    const SimTK::MobilizedBody& parent = bodies[b].getParentMobilizedBody();
    const SimTK::Transform X_PB = ~parent.getBodyTransform(state) * to_simtk(body.at_G);
    bodies[b].setQToFitTransform(state, ~bodies[b].getInboardFrame(state) * X_PB * bodies[b].getOutboardFrame(state));
    system.realize(state, SimTK::Stage::Velocity);
    bodies[b].setUToFitVelocity(state, {SimTK::Vec3(0), SimTK::Vec3(0)});
    system.realize(state, SimTK::Stage::Velocity);
    // Velocity of K in J, with the parent's own motion taken off, is what the speeds of a free joint are.
    const SimTK::Rotation R_JG = ~(parent.getBodyRotation(state) * bodies[b].getInboardFrame(state).R());
    const SimTK::Vec3 arm_G = bodies[b].getBodyRotation(state) * bodies[b].getOutboardFrame(state).p();
    const SimTK::Vec3 w = to_simtk(body.angular_velocity_G) - parent.getBodyAngularVelocity(state);
    const SimTK::Vec3 point_P =
        bodies[b].findStationLocationInAnotherBody(state, bodies[b].getOutboardFrame(state).p(), parent);
    const SimTK::Vec3 v = to_simtk(body.velocity_G) + to_simtk(body.angular_velocity_G) % arm_G -
                          parent.findStationVelocityInGround(state, point_P);
    bodies[b].setUToFitVelocity(state, {R_JG * w, R_JG * v});
  }
  system.realize(state, SimTK::Stage::Velocity);
  linear_state = state;
}

void Model::Data::add_body(const Body& body) {
  SimTK::MobilizedBody& parent = carrier_of(body.joint.parent);
  SimTK::MobilizedBody added = mobilized(parent, body.joint, SimTK::Body::Rigid(to_simtk(body.mass)));
  if (body.joint.prescribed_speed) {
    const SimTK::Motion::Steady motion(added, *body.joint.prescribed_speed);
    moves_by_prescription = true;
  }
  add_joint_forces(body.joint, added);
  bodies.push_back(added);
}

void Model::Data::add_joint_forces(const Joint& joint, const SimTK::MobilizedBody& body) {
  if (joint.damping > 0) {
    const int speeds = joint.type == JointType::free   ? 6
                       : joint.type == JointType::ball ? 3
                                                       : coordinate_count(joint.type);
    for (int i = 0; i < speeds; ++i) {
      const SimTK::MobilizerUIndex speed(i);
      const SimTK::Force::MobilityLinearDamper damper(forces, body, speed, joint.damping);
      dampers.push_back({body.getMobilizedBodyIndex(), speed, joint.damping});
    }
  }
  for (const Limit& limit : joint.limits) {
    const SimTK::Force::MobilityLinearStop stop(forces, body, SimTK::MobilizerQIndex(limit.coordinate), limit.stiffness,
                                                limit.dissipation, limit.from, limit.to);
    bumpers.push_back({body.getMobilizedBodyIndex(), limit, stop});
  }
}

void Model::Data::realize(SimTK::State& of, double t, const Eigen::VectorXd& y, SimTK::Stage stage) const {
  of.setTime(t);
  SimTK::Vector& q = of.updQ();
  for (int i = 0; i < q.size(); ++i) q[i] = y[i];
  SimTK::Vector& u = of.updU();
  for (int i = 0; i < u.size(); ++i) u[i] = y[q.size() + i];
  system.realize(of, SimTK::Stage::Time);
  system.prescribe(of);
  system.realize(of, stage);
}

void Model::Data::realize(double t, const Eigen::VectorXd& y, SimTK::Stage stage) {
  if (t == state.getTime() && same_bits(y, realized_y)) {
    system.realize(state, stage);
    return;
  }
  realized_y.resize(0);
  realize(state, t, y, stage);
  realized_y = y;
}

Eigen::VectorXd Model::Data::y() const {
  const SimTK::Vector &q = state.getQ(), &u = state.getU();
  Eigen::VectorXd y(q.size() + u.size());
  for (int i = 0; i < q.size(); ++i) y[i] = q[i];
  for (int i = 0; i < u.size(); ++i) y[q.size() + i] = u[i];
  return y;
}

namespace {

/// Where to show a force: the centre of pressure of elements that press, and among them also where some pull.
class CentreOfForce {
 public:
  void add(const fast::Element& e) {
    by_force_.add(std::abs(e.normal_force), e.position_Me);
    by_area_.add(e.area, e.position_Me);
  }
  /// Of one element at least.
  Eigen::Vector3d place() const { return (by_force_.sum > 0 ? by_force_ : by_area_).mean(); }

 private:
  struct Mean {
    double sum = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    void add(double weight, const Eigen::Vector3d& x) {
      sum += weight;
      moment += weight * x;
    }
    Eigen::Vector3d mean() const { return moment / sum; }
  };
  Mean by_force_, by_area_;
};

}  // namespace

void Model::Data::observe_contact(Index p, const fast::Contact& contact, Observation& observation) const {
  const ScenePairing& pairing = scene.pairings[static_cast<std::size_t>(p)];
  PairingObservation& result = observation.pairings[static_cast<std::size_t>(p)];
  result.touching = contact.touching;
  result.nested = contact.nested;
  result.too_deep = contact.too_deep;
  result.elements = contact.element_count;
  result.max_penetration = contact.max_penetration;
  const Pose& E = observation.surfaces_G[static_cast<std::size_t>(pairing.E)];
  result.force_G = E.A * contact.force_Me;
  const double share = pairing.mode == Mode::both ? 0.5 : 1;
  CentreOfForce centre_Me;
  for (const fast::Element& e : contact.elements) {
    centre_Me.add(e);
    result.normal_force += share * e.normal_force;
    result.tangential_force += share * e.tangential_force;
    observation.powers.damping +=
        share * (e.normal_force - pcm::simbody::elastic_force(contacts.pairing(p), e)) * e.normal_velocity;
    observation.powers.friction += share * e.tangential_force * e.tangential_velocity;
    observation.elements.push_back({p, e.master, e.master_face, e.slave_face, e.normal_force / e.area});
  }
  result.patch_area = share * contact.statistics.patch_area;
  if (!contact.elements.empty()) result.centre_of_force_G = E.A * centre_Me.place() + E.r;
}

double Model::Data::kinetic_energy() const {
  double energy = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (scene.bodies[b].joint.prescribed_speed) continue;
    const SimTK::SpatialVec V = bodies[b].getBodyVelocity(state);
    energy += 0.5 * (~V * (bodies[b].getBodySpatialInertiaInGround(state) * V));
  }
  return energy;
}

// A bumper's force is k x (1 + d dx/dt), never pulling; what exceeds its spring's k x is damping.
double Model::Data::joint_power() const {
  double power = 0;
  for (const Damper& d : dampers) {
    const double u = matter.getMobilizedBody(d.body).getOneU(state, d.speed);
    power += d.damping * u * u;
  }
  for (const Bumper& b : bumpers) {
    const SimTK::MobilizedBody& body = matter.getMobilizedBody(b.body);
    const double q = body.getOneQ(state, b.limit.coordinate), speed = body.getOneQDot(state, b.limit.coordinate);
    const bool above = q > b.limit.to;
    if (!above && q >= b.limit.from) continue;
    const double x = above ? q - b.limit.to : b.limit.from - q;
    const double rate = above ? speed : -speed;
    const double spring = b.limit.stiffness * x;
    const double force = std::max(0.0, spring * (1 + b.limit.dissipation * rate));
    power += (force - spring) * rate;
  }
  return power;
}

Model::Model(const Scene& scene) {
  try {
    data_ = std::make_unique<Data>(scene);
  } catch (const SimTK::Exception::Base& error) {
    throw BadInput(std::string("the scene can't be set up: ") + error.what());
  }
}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

Eigen::Index Model::size() const {
  return data_->state.getNQ() + data_->state.getNU();
}

Eigen::Index Model::degrees_of_freedom() const {
  Eigen::Index prescribed = 0;
  for (const Body& body : data_->scene.bodies) prescribed += body.joint.prescribed_speed.has_value();
  return data_->state.getNU() - prescribed;
}

Eigen::VectorXd Model::start() const {
  return data_->y();
}

std::vector<StateColumn> Model::columns() const {
  std::vector<StateColumn> all(static_cast<std::size_t>(size()));
  const auto put = [&all](const std::vector<StateColumn>& columns, int at) {
    std::copy(columns.begin(), columns.end(), all.begin() + at);
  };
  for (std::size_t b = 0; b < data_->bodies.size(); ++b) {
    const Body& body = data_->scene.bodies[b];
    if (body.joint.type == JointType::weld) continue;
    put(coordinate_columns(body), data_->bodies[b].getFirstQIndex(data_->state));
    put(speed_columns(body), data_->state.getNQ() + data_->bodies[b].getFirstUIndex(data_->state));
  }
  return all;
}

Eigen::VectorXd Model::normalised(const Eigen::VectorXd& y) const {
  Eigen::VectorXd result = y;
  for (std::size_t b = 0; b < data_->bodies.size(); ++b) {
    if (const std::optional<double>& speed = data_->scene.bodies[b].joint.prescribed_speed)
      result[data_->state.getNQ() + static_cast<int>(data_->bodies[b].getFirstUIndex(data_->state))] = *speed;
    if (!has_quaternion(data_->scene.bodies[b].joint.type)) continue;
    auto quaternion = result.segment<4>(static_cast<int>(data_->bodies[b].getFirstQIndex(data_->state)));
    const double length = quaternion.norm();
    // It drifts by the integrator's error, which is far less.
    if (!(length > 0.5 && length < 2))
      throw BadInput("the quaternion of body '" + data_->scene.bodies[b].name + "' has length " +
                     std::to_string(length) + "; it must be 1");
    quaternion /= length;
  }
  return result;
}

Evaluation Model::derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
  Data& data = *data_;
  data.realize(t, y, SimTK::Stage::Velocity);
  const std::int64_t unmoved = data.contacts.counters().unmoved;
  const std::vector<pcm::simbody::PairingAnswer>* asked = nullptr;
  try {
    asked = &data.contacts.answers(data.state);
  } catch (const BadInput&) {
    // A state that an integrator tries, beyond what the engine takes: it has no finite derivative there.
    dydt.setConstant(std::numeric_limits<double>::quiet_NaN());
    return Evaluation::available;
  }
  const std::vector<pcm::simbody::PairingAnswer>& answers = *asked;
  data.counters.law_only += data.contacts.counters().unmoved - unmoved;
  for (const pcm::simbody::PairingAnswer& answer : answers) {
    data.counters.nested += answer.nested;
    data.counters.penetration_exceeded += answer.penetration_exceeded;
    if (answer.nested || answer.penetration_exceeded) return Evaluation::not_here;
  }
  data.system.realize(data.state, SimTK::Stage::Acceleration);
  read_slope(data.state, dydt);
  return Evaluation::available;
}

void Model::remember(double t, const Eigen::VectorXd& y) {
  data_->realized_y.resize(0);  // what the engine finds is kept from here on, so it is found anew
  data_->realize(t, y, SimTK::Stage::Velocity);
  data_->contacts.remember(data_->state);
}

void Model::forget() {
  data_->contacts.forget();
}

TangentCost Model::linearise(double t, const Eigen::VectorXd& y) {
  Data& data = *data_;
  data.realize(t, y, SimTK::Stage::Velocity);
  const auto tangents = std::make_shared<const pcm::simbody::ContactTangents>(data.contacts.tangents(data.state));
  if (tangents->complete) data.contacts.linearise(data.linear_state, tangents);
  return {tangents->complete, tangents->any() ? 1 : 0};
}

void Model::linear_derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
  data_->realize(data_->linear_state, t, y, SimTK::Stage::Acceleration);
  read_slope(data_->linear_state, dydt);
}

Observation Model::observe(double t, const Eigen::VectorXd& y) {
  Data& data = *data_;
  data.realize(t, y, data.moves_by_prescription ? SimTK::Stage::Acceleration : SimTK::Stage::Velocity);
  Observation result;
  for (Index s = 0; s < static_cast<Index>(data.scene.surfaces.size()); ++s)
    result.surfaces_G.push_back(data.contacts.surface_pose(data.state, s));
  result.pairings.resize(data.scene.pairings.size());
  data.contacts.visit_elements(
      data.state, [&](Index p, const Pose& pose, const Velocity& velocity, const fast::Contact& contact) {
        data.observe_contact(p, contact, result);
        result.pairings[static_cast<std::size_t>(p)].pose = pose;
        result.pairings[static_cast<std::size_t>(p)].velocity = velocity;
        result.energies.elastic += pcm::simbody::elastic_energy(data.contacts.pairing(p), pose, contact);
      });
  result.energies.kinetic = data.kinetic_energy();
  result.energies.gravity = data.gravity.calcPotentialEnergyContribution(data.state);
  for (const Data::Bumper& bumper : data.bumpers)
    result.energies.bumpers += bumper.force.calcPotentialEnergyContribution(data.state);
  result.powers.joints = data.joint_power();
  if (data.moves_by_prescription) result.powers.motions = data.matter.calcMotionPower(data.state);
  return result;
}

const ModelCounters& Model::counters() const {
  return data_->counters;
}

}  // namespace pcm::simulate
