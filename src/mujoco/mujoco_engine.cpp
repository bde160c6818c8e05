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

/// Returns MuJoCo's geom attributes of a surface. A plane is drawn as a square with sides of
/// 2 * `half_side` [m]. `place` is the placement of the surface's frame in its body.
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
        constexpr double half_thickness = 0.002;  // of the box drawn for a plane [m]
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
  constexpr double arm = 0.1;  // distance from the frame's origin, m; chosen by hand
  const Directions held = loop.directions;
  const int turns = (held.has(3) ? 1 : 0) + (held.has(4) ? 1 : 0) + (held.has(5) ? 1 : 0);
  if ((held.bits & Directions::linear().bits) != Directions::linear().bits || turns == 1)
    throw Error("the MuJoCo plant closes loops at points and thus holds x, y and z, but loop " +
                in_quotes(loop.name) + " holds " + held.text() +
                "; wanted x,y,z, alone or with at least two of rx,ry,rz");
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

std::string touch_name(std::size_t i) { return "touch_" + std::to_string(i); }

/// Returns geom attributes for the robot's part (tool or foot), except name and collision.
std::string part_of(const Model& model, const TouchSpec& touch) {
  constexpr double half_thickness = 0.01;  // of a rectangle, m
  Eigen::Isometry3d in_body = model.frames[to_size(model.frame_index(touch.frame))].placement;
  if (!touch.is_rectangle())
    return "type=\"sphere\"" + pose_attributes(in_body) + " size=\"" + numbers(touch.radius) + "\"";
  in_body.translation() += half_thickness * in_body.linear().col(2);
  return "type=\"box\"" + pose_attributes(in_body) + " size=\"" +
         numbers(touch.half_x, touch.half_y, half_thickness) + "\"";
}

/// Adds a touch (tool or foot) and its surface. The two geoms have a collision bit of their own, so
/// they collide only with each other. Without `collides`, they do not collide.
void add_touch(const Model& model, const TouchSpec& touch, std::size_t i, bool collides,
               Additions& to) {
  const SurfaceSpec& surface = touch.surface;
  const std::string bit = collides ? std::to_string(1U << i) : "0";
  const std::string common = " condim=\"" + std::string(surface.friction > 0.0 ? "3" : "1") +
                             "\" friction=\"" + numbers(surface.friction, 0.0, 0.0) +
                             "\" contype=\"" + bit + "\" conaffinity=\"" + bit + "\"/>\n";
  const double side = std::isinf(surface.extent) ? surface.half_size : surface.extent;
  const auto frame_of = [&](const std::string& name) -> const Frame& {
    return model.frames[to_size(model.frame_index(name))];
  };
  const bool carried = !surface.frame.empty();
  std::string& holder = carried ? to.bodies[frame_of(surface.frame).body] : to.world;
  const Eigen::Isometry3d place =
      carried ? frame_of(surface.frame).placement : Eigen::Isometry3d::Identity();
  holder +=
      "<geom name=\"" + touch_name(i) + "_surface\" " + geom_of(surface, side, place) + common;
  to.bodies[frame_of(touch.frame).body] +=
      "<geom name=\"" + touch_name(i) + "\" " + part_of(model, touch) + common;
}

void add_touches(const Model& model, const SceneSpec& scene, bool own_contact, Additions& to) {
  constexpr std::size_t bits = 31;  // of MuJoCo's collision masks
  if (scene.touches.size() > bits)
    throw Error("the scene has " + std::to_string(scene.touches.size()) +
                " touches; wanted at most " + std::to_string(bits) + " for MuJoCo");
  for (std::size_t i = 0; i < scene.touches.size(); ++i)
    add_touch(model, scene.touches[i], i, own_contact || scene.touches[i].is_support, to);
}

/// Returns the additions to the robot's text: touches with their surfaces, followers and loops.
Additions additions_for(const Model& model, const SceneSpec& scene,
                        const MujocoPlantOptions& options) {
  Additions result;
  result.joint_stops = options.joint_stops;
  result.options = R"(cone="elliptic" integrator="Euler" timestep=")" + numbers(options.dt) +
                   "\" impratio=\"" + numbers(options.friction_ratio) + "\" tolerance=\"" +
                   numbers(options.tolerance) + "\" iterations=\"" +
                   std::to_string(options.max_iterations) + "\"";
  add_touches(model, scene, options.contact == MujocoContact::Engine, result);
  // Upper bound of the number of constraint rows: friction, limits, followers, loops and contacts.
  const std::size_t contacts = 8 + 4 * scene.touches.size();
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

/// Sets stiffness [N/m] and damping [Ns/m] of a contact, on the geoms of the touch and of its
/// surface. `d` is MuJoCo's impedance, in (0, 1).
void load_contact(double stiffness, double damping, mjtNum d, mjModel& m, const TouchIds& touch) {
  const double inverse_inertia =
      m.body_invweight0[2 * touch.body] + m.body_invweight0[2 * m.geom_bodyid[touch.surface_geom]];
  const double R = (1.0 - d) / d * inverse_inertia;
  for (const int geom : {touch.surface_geom, touch.geom}) {
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

/// Sets the equality constraints of followers, which precede those of loops. Followers accelerate
/// like their leaders; the plant corrects positions after steps. Returns the number of followers.
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

std::vector<TouchIds> ids_of(const Model& robot, const SceneSpec& scene, const mjModel& m) {
  std::vector<TouchIds> result;
  for (std::size_t i = 0; i < scene.touches.size(); ++i) {
    const TouchSpec& touch = scene.touches[i];
    const int geom = mj_name2id(&m, mjOBJ_GEOM, touch_name(i).c_str());
    result.push_back({geom, m.geom_bodyid[geom],
                      mj_name2id(&m, mjOBJ_GEOM, (touch_name(i) + "_surface").c_str()),
                      site_id(robot, m, touch.frame), site_id(robot, m, touch.surface.frame)});
  }
  return result;
}

}  // namespace

Engine::Engine(const Model& robot, const SceneSpec& wanted, const MujocoPlantOptions& options)
    : model(robot),
      scene(checked_scene(robot, wanted)),
      m((check(options), compile(describe(robot, additions_for(robot, scene, options))))),
      d(mj_makeData(m.get())),
      coordinates(robot, *m),
      touches(ids_of(robot, scene, *m)),
      own_contact(options.contact == MujocoContact::Engine) {
  load_figures(model, *m, *d);
  load_joint_friction(model, coordinates, *m);
  load_loops(model, load_followers(*m), *m);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const TouchSpec& touch = scene.touches[i];
    if (own_contact) check_engine_supports(touch.surface);
    const double corners = touch.is_rectangle() ? 4.0 : 1.0;  // contact points
    // The damping of a foot is stiff and needs implicit steps, because the foot is light compared
    // with its load. An impedance closer to 1 makes MuJoCo's steps more implicit. Chosen by hand.
    constexpr double support_impedance = 0.95;
    load_contact(touch.surface.stiffness / corners, touch.surface.damping / corners,
                 touch.is_support ? support_impedance : options.impedance, *m, touches[i]);
  }
}

void Engine::stiffen_equalities() const {
  // At MuJoCo's largest impedance, the error is 1e-4 of the acceleration. The scale makes it 1e-8.
  constexpr mjtNum compliance_scale = 1e-4;
  for (int row = 0; row < d->nefc; ++row) {
    if (d->efc_type[row] != mjCNSTR_EQUALITY) continue;
    d->efc_R[row] *= compliance_scale;
    d->efc_D[row] /= compliance_scale;
  }
}

/// MuJoCo's planes are infinite, so collisions beside the surface are switched off.
void Engine::update_surface_extents(const Wrenches& wrenches) const {
  if (!own_contact) return;
  bool placed = false;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (std::isinf(scene.touches[i].surface.extent)) continue;
    if (!placed) mj_kinematics(m.get(), d.get());
    placed = true;
    const Eigen::Map<const Eigen::Vector3d> tip(d->site_xpos + 3 * touches[i].site);
    const bool in_contact = !wrenches.col(static_cast<Eigen::Index>(i)).isZero(0.0);
    const int bit = is_over(scene.touches[i], tip, in_contact) ? 1 << i : 0;
    m->geom_contype[touches[i].surface_geom] = m->geom_conaffinity[touches[i].surface_geom] = bit;
  }
}

void Engine::update_ground_friction(double time) const noexcept {
  if (scene.slippery_ground.empty()) return;
  for (std::size_t i = 0; i < touches.size(); ++i)
    for (const int geom : {touches[i].geom, touches[i].surface_geom})
      if (scene.touches[i].is_support)
        m->geom_friction[3 * geom] = friction_under(scene, scene.touches[i], time);
}

Vector6 Engine::contact_wrench(const TouchIds& touch) const {
  using Vector3 = Eigen::Map<const Eigen::Vector3d>;
  const Vector3 origin(d->site_xpos + 3 * touch.site);
  const AxesMap axes = axes_of(touch);
  Vector6 sum = Vector6::Zero();
  // MuJoCo orders the two geoms of a contact by type, and reports the force on geom2.
  for (int i = 0; i < d->ncon; ++i) {
    const mjContact& contact = d->contact[i];
    const bool second = contact.geom2 == touch.geom, first = contact.geom1 == touch.geom;
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

}  // namespace burnish::mujoco
