// Targets as users write them, as the kernels read them.
#include <Eigen/Geometry>
#include <algorithm>

#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

void store_target(const CompiledTerm& term, const ConstVectorRef& value, double* out) {
  const auto store_rotation = [](const Eigen::Vector4d& quaternion, double* to) {
    Eigen::Map<Eigen::Matrix3d>(to, 3, 3) =
        Eigen::Quaterniond(quaternion.normalized()).toRotationMatrix();
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

void load_target(const CompiledTerm& term, double time, Eigen::VectorXd& scratch, double* out) {
  if (term.target_size == 0) return;
  auto value = scratch.head(term.signal_size);
  term.signal.at(time, value);
  store_target(term, value, out);
}

}  // namespace burnish::ocp
