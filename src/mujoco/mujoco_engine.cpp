#include "mujoco/mujoco_engine.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/dynamics/reference.hpp"
#include "mujoco/descriptions.gen.hpp"

namespace burnish::mujoco {
namespace {

void check(const MujocoPlantOptions& options) {
  check_ranges(description_of(&options), &options,
               [](const std::string& entry) { return "the MuJoCo plant's " + entry; });
}

/// Returns MuJoCo's geom attributes of a surface. A plane is drawn as a square with this half side
/// [m]. `place` is the placement of the surface's frame in its body.
std::string geom_of(const SurfaceSpec& surface, double half_side, const Eigen::Isometry3d& place) {
  using Kind = SurfaceShape::Kind;
  constexpr double half_length = 5.0;  // of the capsule that represents a cylinder, m
  const SurfaceShape& shape = surface.shape;
  const Surface placed = surface_of(surface);
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.translation() = placed.center();
  at.linear() = placed.axes();
  const std::string pose = pose_attributes(place * at) + " size=\"";
  switch (shape.kind) {
    case Kind::Sphere:
      return "type=\"sphere\"" + pose + numbers(shape.radius) + "\"";
    case Kind::Cylinder:
      return "type=\"capsule\"" + pose + numbers(shape.radius, half_length) + "\"";
    case Kind::Ellipsoid:
      return "type=\"ellipsoid\"" + pose +
             numbers(shape.semi_axes.x(), shape.semi_axes.y(), shape.semi_axes.z()) + "\"";
    default:  // MuJoCo has no such geom; the tangent plane is drawn
      at.translation() = surface.point;
      at.linear() = Reference::surface_with_normal(surface.normal).rotation;
      if (!surface.frame.empty()) {               // MuJoCo's planes cannot move
        constexpr double half_thickness = 0.002;  // m
        at.translation() -= half_thickness * at.linear().col(2);
        return "type=\"box\"" + pose_attributes(place * at) + " size=\"" +
               numbers(half_side, half_side, half_thickness) + "\"";
      }
      return "type=\"plane\"" + pose_attributes(at) + " size=\"" +
             numbers(half_side, half_side, 0.01) + "\"";
  }
}

/// Throws Error unless MuJoCo's own contact supports the surface.
void check_engine_supports(const SurfaceSpec& surface) {
  using Kind = SurfaceShape::Kind;
  const SurfaceShape& shape = surface.shape;
  if (!surface.frame.empty())
    throw Error("MuJoCo's own contact does not support a surface that the robot carries (frame " +
                in_quotes(surface.frame) +
                "); wanted a surface in the world, or the exact contact model (contact: exact)");
  if (!surface.motion.is_at_rest())
    throw Error(
        "MuJoCo's own contact does not support a moving surface; wanted a surface at rest, or "
        "the exact contact model (contact: exact)");
  const bool is_supported = shape.kind == Kind::Plane || shape.kind == Kind::Sphere ||
                            shape.kind == Kind::Cylinder || shape.kind == Kind::Ellipsoid;
  if (!is_supported || shape.hollow)
    throw Error("MuJoCo's own contact does not support a " + shape.text() +
                "; wanted a plane, or a sphere, cylinder or ellipsoid that is not hollow, or "
                "the exact contact model (contact: exact)");
}

/// Returns the points at which MuJoCo connects a loop's frames, in the frames' axes [m]: one point
/// for a ball joint, two along the free axis for a hinge, three for a rigid connection.
std::vector<Eigen::Vector3d> points_of(const Loop& loop) {
  constexpr double arm = 0.1;  // distance of the points, m; chosen by hand
  const Directions held = loop.directions;
  const int turns = (held.has(3) ? 1 : 0) + (held.has(4) ? 1 : 0) + (held.has(5) ? 1 : 0);
  if ((held.bits & Directions::linear().bits) != Directions::linear().bits || turns == 1)
    throw Error("the MuJoCo plant closes loops at points and thus holds x, y and z, but loop " +
                in_quotes(loop.name) + " holds " + held.text() +
                "; wanted x,y,z, alone or with two or three of rx,ry,rz");
  if (turns == 0) return {Eigen::Vector3d::Zero()};
  if (turns == 3)
    return {Eigen::Vector3d::Zero(), Eigen::Vector3d(arm, 0.0, 0.0),
            Eigen::Vector3d(0.0, arm, 0.0)};
  const int axis = !held.has(3) ? 0 : !held.has(4) ? 1 : 2;
  return {-arm * Eigen::Vector3d::Unit(axis), arm * Eigen::Vector3d::Unit(axis)};
}

/// Returns MuJoCo's connections of the loops, without points. load_loops() sets the points, because
/// MuJoCo would compute the second one from the neutral posture, in which the loop can be open.
std::string connections_of(const Model& model) {
  std::string text;
  for (const Loop& loop : model.loops) {
    const auto body = [&](const std::string& frame) {
      return body_name(model.frames[to_size(model.frame_index(frame))].body);
    };
    for (std::size_t i = 0; i < points_of(loop).size(); ++i)
      text += "<connect body1=\"" + body(loop.first) + "\" body2=\"" + body(loop.second) +
              "\" anchor=\"0 0 0\"/>\n";
  }
  return text;
}

/// Sets the points of the connections in their bodies, and the gains against drift. `first` is the
/// index of the first connection among the equality constraints.
void load_loops(const Model& model, int first, mjModel& m) {
  constexpr mjtNum d = mjMAXIMP;
  const LoopGains gains = LoopGains::for_step(m.opt.timestep);
  int i = first;
  for (const Loop& loop : model.loops)
    for (const Eigen::Vector3d& point : points_of(loop)) {
      mjtNum* data = m.eq_data + mjNEQDATA * i;
      for (const std::string& name : {loop.first, loop.second}) {
        const Frame& frame = model.frames[to_size(model.frame_index(name))];
        const Eigen::Vector3d at = frame.placement * point;
        mju_copy3(data, at.data());
        data += 3;
      }
      mjtNum* solref = m.eq_solref + mjNREF * i;
      solref[0] = -gains.kp;
      solref[1] = -gains.kd;
      const mjtNum constant[mjNIMP] = {d, d, 0.001, 0.5, 2.0};
      mju_copy(m.eq_solimp + mjNIMP * i, constant, mjNIMP);
      ++i;
    }
}

std::string support_name(std::size_t i) { return "support_" + std::to_string(i); }

/// Adds the supports and their planes. Each support collides only with its own plane, by its
/// own collision bit. Bits 0 and 1 are for tip and surface.
void add_supports(const Model& model, const SceneSpec& scene, Additions& to) {
  constexpr std::size_t first = 2, bits = 30;
  constexpr double half_thickness = 0.01;  // of a planar foot, m
  if (scene.supports.size() > bits - first)
    throw Error("the scene has " + std::to_string(scene.supports.size()) +
                " supports; wanted at most " + std::to_string(bits - first) + " for MuJoCo");
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const SupportSpec& support = scene.supports[i];
    const std::string bit = std::to_string(1U << (first + i));
    const std::string collision = " contype=\"" + bit + "\" conaffinity=\"" + bit + "\" condim=\"" +
                                  (support.friction > 0.0 ? "3" : "1") + "\" friction=\"" +
                                  numbers(support.friction, 0.0, 0.0) + "\"/>\n";
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.translation() = support.point;
    at.linear() = Reference::surface_with_normal(support.normal).rotation;
    to.world += "<geom name=\"" + support_name(i) + R"(_plane" type="plane" size="1 1 0.01")" +
                pose_attributes(at) + collision;
    const Frame& frame = model.frames[to_size(model.frame_index(support.frame))];
    Eigen::Isometry3d in_body = frame.placement;
    std::string shape = R"(type="sphere" size=")" + numbers(support.radius) + "\"";
    if (support.is_sole()) {
      in_body.translation() += half_thickness * in_body.linear().col(2);
      shape =
          R"(type="box" size=")" + numbers(support.half_x, support.half_y, half_thickness) + "\"";
    }
    to.bodies[frame.body] +=
        "<geom name=\"" + support_name(i) + "\" " + shape + pose_attributes(in_body) + collision;
  }
}

/// Adds the surface and the tip, which collide only with each other.
void add_tip(const Model& model, const SceneSpec& scene, bool collides, Additions& to) {
  const SurfaceSpec& surface = scene.surface;
  const Frame& tip = model.frames[to_size(model.frame_index(scene.tip.frame))];
  const std::string common = " condim=\"" + std::string(surface.friction > 0.0 ? "3" : "1") +
                             "\" friction=\"" + numbers(surface.friction, 0.0, 0.0) + "\"";
  const double side = std::isinf(surface.extent) ? surface.half_size : surface.extent;
  const Frame* const carrier =
      surface.frame.empty() ? nullptr : &model.frames[to_size(model.frame_index(surface.frame))];
  std::string& holder = carrier == nullptr ? to.world : to.bodies[carrier->body];
  const Eigen::Isometry3d place =
      carrier == nullptr ? Eigen::Isometry3d::Identity() : carrier->placement;
  holder += "<geom name=\"surface\" " + geom_of(surface, side, place) + common +
            (collides ? " contype=\"2\"" : " contype=\"0\"") +
            (collides ? " conaffinity=\"1\"/>\n" : " conaffinity=\"0\"/>\n");
  to.bodies[tip.body] += R"(<geom name="tip" type="sphere")" + pose_attributes(tip.placement) +
                         " size=\"" + numbers(scene.tip.radius) + "\"" + common +
                         " contype=\"1\" conaffinity=\"2\"/>\n";
}

/// Returns the surface, the tip, the supports, followers and loops as additions to the robot's
/// text.
Additions additions_for(const Model& model, const SceneSpec& scene,
                        const MujocoPlantOptions& options) {
  Additions result;
  result.joint_stops = options.joint_stops;
  result.options = R"(cone="elliptic" integrator="Euler" timestep=")" + numbers(options.dt) +
                   "\" impratio=\"" + numbers(options.friction_ratio) + "\" tolerance=\"" +
                   numbers(options.tolerance) + "\" iterations=\"" +
                   std::to_string(options.max_iterations) + "\"";
  if (scene.tip.exists()) add_tip(model, scene, options.contact == MujocoContact::Engine, result);
  add_supports(model, scene, result);
  // Upper bound of the number of constraint rows: friction, limits, followers, loops and contacts.
  const std::size_t contacts = 8 + 4 * scene.supports.size();
  const auto rows =
      4 * to_size(model.nv) + model.joints.size() + 9 * model.loops.size() + 5 * contacts;
  result.sections = "<size njmax=\"" + std::to_string(rows) + "\" nconmax=\"" +
                    std::to_string(contacts) + "\"/>\n<equality>\n";
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const auto& follows = model.joints[i].follows;
    if (!follows) continue;
    result.sections += "<joint joint1=\"" + joint_name(static_cast<int>(i)) + "\" joint2=\"" +
                       joint_name(follows->leader) + "\" polycoef=\"" +
                       numbers(follows->offset, follows->multiplier, 0.0, 0.0, 0.0) + "\"/>\n";
  }
  result.sections += connections_of(model) + "</equality>\n";
  return result;
}

/// Sets the stiffness [N/m] and the damping [Ns/m] of a contact on both geoms. `d` is the
/// impedance, in (0, 1).
void load_contact(double stiffness, double damping, mjtNum d, mjModel& m, int plane_geom,
                  int tip_geom) {
  const double inverse_inertia = m.body_invweight0[2 * m.geom_bodyid[tip_geom]] +
                                 m.body_invweight0[2 * m.geom_bodyid[plane_geom]];
  const double R = (1.0 - d) / d * inverse_inertia;
  for (const int geom : {plane_geom, tip_geom}) {
    mjtNum* solref = m.geom_solref + mjNREF * geom;
    solref[0] = -stiffness * R * d;
    solref[1] = -damping * R * d;
    const mjtNum constant[mjNIMP] = {d, d, 0.001, 0.5, 2.0};
    mju_copy(m.geom_solimp + mjNIMP * geom, constant, mjNIMP);
  }
}

/// Sets the damping and Coulomb friction of the joints. In MuJoCo, a joint under friction creeps
/// with the speed R/B per unit of torque (R: regularization, B: damping of the constraint). An
/// impedance close to 1, and a B that halves the creep in a step, keep the creep of a light joint
/// below 1e-3 rad/s per Nm.
void load_joint_friction(const Model& model, const Coordinates& coordinates, mjModel& m) {
  constexpr mjtNum d = 0.999;
  for (int k = 0; k < model.nv; ++k) {
    const int theirs = coordinates.entry(k);
    m.dof_damping[theirs] = model.damping[k];
    m.dof_frictionloss[theirs] = model.friction[k];
    m.dof_solref[mjNREF * theirs] = 0.0;
    m.dof_solref[mjNREF * theirs + 1] = -0.5 * d / m.opt.timestep;
    const mjtNum constant[mjNIMP] = {d, d, 0.001, 0.5, 2.0};
    mju_copy(m.dof_solimp + mjNIMP * theirs, constant, mjNIMP);
  }
}

/// Sets the equality constraints of followers, which are the first equalities: they accelerate like
/// their leaders, and the plant corrects their positions after each step. Returns their number.
int load_followers(mjModel& m) {
  constexpr mjtNum d = mjMAXIMP;
  int i = 0;
  for (; i < m.neq && m.eq_type[i] == mjEQ_JOINT; ++i) {
    mju_zero(m.eq_solref + mjNREF * i, mjNREF);
    const mjtNum constant[mjNIMP] = {d, d, 0.001, 0.5, 2.0};
    mju_copy(m.eq_solimp + mjNIMP * i, constant, mjNIMP);
  }
  return i;
}

/// Returns MuJoCo's id of the site at a frame of the robot; -1 for an empty name.
int site_id(const Model& robot, const mjModel& m, const std::string& frame) {
  if (frame.empty()) return -1;
  return mj_name2id(&m, mjOBJ_SITE, site_name(robot.frame_index(frame)).c_str());
}

}  // namespace

Engine::Engine(const Model& robot, const SceneSpec& wanted, const MujocoPlantOptions& options)
    : model(robot),
      scene(checked_scene(robot, wanted)),
      m((check(options), compile(describe(robot, additions_for(robot, scene, options))))),
      d(mj_makeData(m.get())),
      coordinates(robot, *m),
      tip_geom(mj_name2id(m.get(), mjOBJ_GEOM, "tip")),
      surface_geom(mj_name2id(m.get(), mjOBJ_GEOM, "surface")),
      tip_site(site_id(robot, *m, scene.tip.frame)),
      tip_body(tip_geom < 0 ? -1 : m->geom_bodyid[tip_geom]),
      surface_site(site_id(robot, *m, scene.surface.frame)),
      own_contact(options.contact == MujocoContact::Engine) {
  if (own_contact && has_tip()) check_engine_supports(scene.surface);
  load_figures(model, *m, *d);
  load_joint_friction(model, coordinates, *m);
  load_loops(model, load_followers(*m), *m);
  if (has_tip())
    load_contact(scene.surface.stiffness, scene.surface.damping, options.impedance, *m,
                 surface_geom, tip_geom);
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const SupportSpec& support = scene.supports[i];
    const auto id = [&](int kind, const std::string& name) {
      return mj_name2id(m.get(), kind, name.c_str());
    };
    supports.push_back({id(mjOBJ_GEOM, support_name(i)), id(mjOBJ_GEOM, support_name(i) + "_plane"),
                        id(mjOBJ_SITE, site_name(robot.frame_index(support.frame)))});
    const double corners = support.is_sole() ? 4.0 : 1.0;  // contact points of the foot
    // The damping of a foot is stiff and needs implicit steps, because the foot is light compared
    // with its load. An impedance closer to 1 makes MuJoCo's steps more implicit. Chosen by hand.
    constexpr double impedance = 0.95;
    load_contact(support.stiffness / corners, support.damping / corners, impedance, *m,
                 supports.back().plane, supports.back().geom);
  }
}

void Engine::stiffen_equalities() const {
  // Reduces the error that remains at MuJoCo's largest impedance, 1e-4 of the acceleration.
  constexpr mjtNum compliance_scale = 1e-4;
  for (int row = 0; row < d->nefc; ++row) {
    if (d->efc_type[row] != mjCNSTR_EQUALITY) continue;
    d->efc_R[row] *= compliance_scale;
    d->efc_D[row] /= compliance_scale;
  }
}

/// MuJoCo's planes are infinite, so collisions beside the surface are switched off.
void Engine::update_surface_extent(bool in_contact) const {
  if (std::isinf(scene.surface.extent) || !own_contact || !has_tip()) return;
  mj_kinematics(m.get(), d.get());
  const Eigen::Map<const Eigen::Vector3d> tip(d->site_xpos + 3 * tip_site);
  const bool over = is_over(scene, tip, in_contact);
  m->geom_contype[surface_geom] = over ? 2 : 0;
  m->geom_conaffinity[surface_geom] = over ? 1 : 0;
}

void Engine::update_ground_friction(double time) const noexcept {
  if (scene.slippery_ground.empty()) return;
  for (std::size_t i = 0; i < supports.size(); ++i)
    for (const int geom : {supports[i].geom, supports[i].plane})
      m->geom_friction[3 * geom] = friction_under(scene, scene.supports[i], time);
}

Eigen::Matrix<double, 6, 1> Engine::support_wrench(const Support& support) const {
  using Vector3 = Eigen::Map<const Eigen::Vector3d>;
  const Vector3 origin(d->site_xpos + 3 * support.site);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(d->site_xmat +
                                                                            9 * support.site);
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  for (int i = 0; i < d->ncon; ++i) {
    const mjContact& contact = d->contact[i];
    const bool second = contact.geom2 == support.geom, first = contact.geom1 == support.geom;
    if (!first && !second) continue;
    mjtNum wrench[6], force[3];
    mj_contactForce(m.get(), d.get(), i, wrench);
    mju_rotVecMatT(force, wrench, contact.frame);  // rows of the frame are its axes
    const Eigen::Vector3d f_world = (second ? 1.0 : -1.0) * Vector3(force);
    sum.head<3>() += axes.transpose() * f_world;
    sum.tail<3>() += axes.transpose() * (Vector3(contact.pos) - origin).cross(f_world);
  }
  return sum;
}

Eigen::Vector3d Engine::contact_force_world() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (!has_tip()) return sum;
  // MuJoCo orders the two geoms of a contact by type, and reports the force on geom2.
  for (int i = 0; i < d->ncon; ++i) {
    const mjContact& contact = d->contact[i];
    const bool second = contact.geom2 == tip_geom && contact.geom1 == surface_geom;
    const bool first = contact.geom1 == tip_geom && contact.geom2 == surface_geom;
    if (!first && !second) continue;
    mjtNum wrench[6], force[3];
    mj_contactForce(m.get(), d.get(), i, wrench);
    mju_rotVecMatT(force, wrench, contact.frame);  // rows of the frame are its axes
    sum += (second ? 1.0 : -1.0) * Eigen::Map<const Eigen::Vector3d>(force);
  }
  return sum;
}

}  // namespace burnish::mujoco
