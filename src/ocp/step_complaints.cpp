// Warnings about stages whose explicit steps are unstable: contact gains, friction, damping and
// springs.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/ocp/step_check.hpp"
#include "ocp/problem_impl.hpp"
#include "ocp/sliding_step.hpp"

namespace burnish {
namespace {

/// Linear error dynamics e'' + rate e' + stiffness e = 0.
struct Mode {
  double stiffness = 0.0;  ///< Stiffness per mass [1/s^2]
  double rate = 0.0;       ///< Damping per mass [1/s]
};

/// Returns the largest factor by which one step of an integrator amplifies an error of the mode.
double growth(const Mode& mode, double step, Integrator integrator) {
  using Complex = std::complex<double>;
  const auto roots = [](double trace, double determinant) {
    const Complex root = std::sqrt(Complex(0.25 * trace * trace - determinant));
    return std::array<Complex, 2>{0.5 * trace + root, 0.5 * trace - root};
  };
  double largest = 0.0;
  if (integrator == Integrator::SemiImplicitEuler) {
    const double damped = 1.0 - step * mode.rate;
    for (const Complex& z : roots(1.0 + damped - step * step * mode.stiffness, damped))
      largest = std::max(largest, std::abs(z));
    return largest;
  }
  for (const Complex& root : roots(-mode.rate, mode.stiffness)) {
    const Complex z = step * root;
    largest =
        std::max(largest, std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))));
  }
  return largest;
}

bool grows(const Mode& mode, double step, Integrator integrator) {
  constexpr double rounding = 1e-6;
  return growth(mode, step, integrator) > 1.0 + rounding;
}

/// Returns the longest stable step [s], by bisection between 0 and the unstable `step`.
double longest_step(const Mode& mode, double step, Integrator integrator) {
  double low = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + step);
    (grows(mode, middle, integrator) ? step : low) = middle;
  }
  return low;
}

/// Returns the value rounded to two digits, up or down.
double two_digits(double value, bool up) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  const double count = value / unit;
  constexpr double rounding = 1e-9;
  return unit * (up ? std::ceil(count * (1.0 - rounding)) : std::floor(count * (1.0 + rounding)));
}

/// One stage of a problem, at its initial state.
class StageSteps {
 public:
  StageSteps(const Problem& problem, int index)
      : problem_(problem),
        stage_(problem.spec().stages[to_size(index)]),
        step_(ocp::explicit_step(problem.spec(), stage_)) {}

  void complain(std::vector<std::string>& sentences) {
    for (const ContactSpec& contact : problem_.spec().contacts) {
      if (std::find(stage_.contacts.begin(), stage_.contacts.end(), contact.name) ==
          stage_.contacts.end())
        continue;
      about_gains(contact, sentences);
      if (contact.friction) about_friction(contact, sentences);
    }
    about_joints(sentences);
  }

 private:
  std::string begin(const std::string& of) const {
    return "stage " + in_quotes(stage_.name) + ", " + of;
  }
  std::string steps() const { return "steps of " + number(step_) + " s"; }

  void about_gains(const ContactSpec& contact, std::vector<std::string>& sentences) const {
    for (int d = 0; d < 6; ++d) {
      if (!contact.directions.has(d)) continue;
      const Mode mode{contact.kp[d], contact.kd[d]};
      if (!grows(mode, step_, stage_.integrator)) continue;
      sentences.push_back(
          begin("contact ") + in_quotes(contact.name) + ": its gains kp " + number(mode.stiffness) +
          " 1/s^2 and kd " + number(mode.rate) + " 1/s are unstable with " + steps() +
          " (kd times step is " + number(two_digits(mode.rate * step_, true)) +
          "); wanted smaller gains, or a step of at most " +
          number(two_digits(longest_step(mode, step_, stage_.integrator), false)) + " s");
      return;
    }
  }

  void about_friction(const ContactSpec& contact, std::vector<std::string>& sentences) const {
    const auto sliding = ocp::sliding_step(problem_.spec(), stage_, contact);
    const double speed = contact.friction->fade_speed();
    if (!sliding || speed >= sliding->speed()) return;
    sentences.push_back(
        begin("contact ") + in_quotes(contact.name) + ": in one of the " + steps() +
        ", its friction of " + number(two_digits(sliding->coefficient * sliding->force, true)) +
        " N slows the tool (" + number(two_digits(sliding->mass, false)) + " kg) by " +
        number(two_digits(sliding->speed(), true)) + " m/s, more than the friction speed of " +
        number(speed) + " m/s, so the tool overshoots rest; wanted a friction speed of at least " +
        number(two_digits(4.0 * sliding->speed(), true)) +
        " m/s or none (chosen automatically), or a step of at most " +
        number(two_digits(step_ * speed / sliding->speed(), false)) + " s");
  }

  /// Warns about damping, friction and springs of the joints. The decay rate of each joint, with
  /// the other joints free, is a lower bound of the robot's fastest decay rate.
  void about_joints(std::vector<std::string>& sentences) const {
    const ocp::CompiledProblem& compiled = ocp::ProblemInside::of(problem_).compiled;
    if (!compiled.passive) return;
    const PassiveJoints& passive = *compiled.passive;
    const int nv = compiled.model.nv;
    const Eigen::Map<const Eigen::VectorXd> x(problem_.initial_state(), problem_.state().nx);
    const Eigen::VectorXd q = x.head(compiled.model.nq), zero = Eigen::VectorXd::Zero(nv);
    Eigen::VectorXd stiffness = zero, damping = zero;
    std::vector<double> slopes(passive.springs.places.size());
    spring_slopes(passive.springs, q.data(), slopes.data());
    for (std::size_t s = 0; s < slopes.size(); ++s) {
      const Springs::Place& place = passive.springs.places[s];
      if (place.row != place.column) continue;
      stiffness[place.row] -= slopes[s];
      damping[place.row] -= place.by_v;
    }
    ContactDynamics dynamics = contact_dynamics();
    if (!is_usable(dynamics.forward(q, zero, zero))) return;
    const Eigen::VectorXd at_rest = dynamics.a();
    double largest_loss = 0.0;  // speed that friction removes in a step [rad/s or m/s]
    for (int k = 0; k < nv; ++k) {
      const double friction = passive.friction[to_size(k)];
      damping[k] += passive.damping[to_size(k)];
      if (damping[k] <= 0.0 && stiffness[k] <= 0.0 && friction <= 0.0) continue;
      if (!is_usable(dynamics.forward(q, zero, Eigen::VectorXd::Unit(nv, k)))) return;
      const double mobility = dynamics.a()[k] - at_rest[k];  // per torque [1/(kg m^2) or 1/kg]
      largest_loss = std::max(largest_loss, mobility * friction * step_);
      about_mode(k, {mobility * std::max(stiffness[k], 0.0), mobility * damping[k]}, sentences);
    }
    if (largest_loss > passive.slip)
      sentences.push_back(begin("joint friction: in one of the ") + steps() +
                          ", friction slows a joint by up to " +
                          number(two_digits(largest_loss, true)) +
                          " rad/s (m/s), more than the slip_velocity of " + number(passive.slip) +
                          ", so the joint overshoots rest; wanted a slip_velocity of at least " +
                          number(two_digits(2.0 * largest_loss, true)) + ", or a step of at most " +
                          number(two_digits(step_ * passive.slip / largest_loss, false)) + " s");
  }

  /// Warns about damping and springs of a joint.
  void about_mode(int entry, const Mode& mode, std::vector<std::string>& sentences) const {
    if (!grows(mode, step_, stage_.integrator)) return;
    sentences.push_back(
        begin("joint entry ") + in_quotes(problem_.model().v_name(entry)) + ": its springs (" +
        number(mode.stiffness) + " 1/s^2) and damping (" + number(mode.rate) +
        " 1/s) are unstable with " + steps() + "; wanted a step of at most " +
        number(two_digits(longest_step(mode, step_, stage_.integrator), false)) + " s");
  }

  ContactDynamics contact_dynamics() const {
    std::vector<ContactSpec> held;
    for (ContactSpec each : contacts_at(problem_.spec().contacts, problem_.spec().start_time))
      if (std::find(stage_.contacts.begin(), stage_.contacts.end(), each.name) !=
          stage_.contacts.end())
        held.push_back(std::move(each));
    return ContactDynamics(problem_.model(), held, {.mu = 1e-6});
  }

  const Problem& problem_;
  const Stage& stage_;
  double step_;  ///< Longest explicit step of the stage [s]
};

}  // namespace

std::vector<std::string> step_complaints(const Problem& problem) {
  std::vector<std::string> sentences;
  for (std::size_t s = 0; s < problem.spec().stages.size(); ++s)
    if (!problem.spec().stages[s].impact)
      StageSteps(problem, static_cast<int>(s)).complain(sentences);
  return sentences;
}

}  // namespace burnish
