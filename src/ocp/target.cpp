// Converts targets and rotations from the user's form to target entries for the kernels.
#include <algorithm>
#include <limits>

#include "dynamics/reference.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

void store_target(const CompiledTerm& term, const ConstVectorRef& value, double* out) {
  const auto store_rotation = [](const ConstVectorRef& xyzw, double* to) {
    Eigen::Map<Eigen::Matrix3d>(to, 3, 3) = rotation_matrix(xyzw);
  };
  switch (term.load) {
    case CompiledTerm::Load::Plain:
      std::copy_n(value.data(), term.signal_size, out);
      break;
    case CompiledTerm::Load::Rotation:
      store_rotation(value.head<4>(), out);
      break;
    case CompiledTerm::Load::Placement:
      std::copy_n(value.data(), 3, out);
      store_rotation(value.segment<4>(3), out + 3);
      break;
  }
}

void load_targets(const CompiledStage& stage, double time, const InputValues& inputs,
                  Eigen::VectorXd& scratch, double* out) {
  for (const CompiledTerm& term : stage.terms) {
    if (term.target_size == 0) continue;
    auto value = scratch.head(term.signal_size);
    term.signal.at(time, value, inputs);
    store_target(term, value, out + term.target);
  }
  for (const CompiledTurning& turning : stage.turnings) {
    auto xyzw = scratch.head(4);
    turning.rotation.at(time, xyzw, inputs);
    Eigen::Map<Eigen::Matrix3d> rotation(out + turning.target, 3, 3);
    if (is_unit_quaternion(xyzw)) {
      rotation = rotation_matrix(xyzw);
    } else {
      rotation.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  for (const CompiledSurface& followed : stage.surfaces)
    store_surface(followed.surface, out + followed.target);
  for (const CompiledFriction& friction : stage.frictions)
    out[friction.target] = friction.coefficient;
}

void store_surface(const Quadric& surface, double* out) {
  const Eigen::Matrix3d& Q = surface.Q;
  for (const double entry : {Q(0, 0), Q(0, 1), Q(0, 2), Q(1, 1), Q(1, 2), Q(2, 2), surface.b[0],
                             surface.b[1], surface.b[2], surface.c})
    *out++ = entry;
}

int add_surface(const Reference& reference, CompiledSurface followed, CompiledStage& stage) {
  if (!reference.quadric) return -1;
  followed.surface = *reference.quadric;
  followed.target = stage.targets;
  stage.surfaces.push_back(followed);
  stage.targets += surface_size;
  return followed.target;
}

int add_turning(const Reference& reference, int contact, const std::string& of,
                CompiledStage& stage) {
  if (reference.rotation_over_time.empty()) return -1;
  stage.turnings.push_back({reference.rotation_over_time, stage.targets, contact, of});
  stage.targets += 9;
  return stage.turnings.back().target;
}

}  // namespace burnish::ocp
