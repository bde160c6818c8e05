// Floating-point operations per state: the kernels run on a scalar that counts.
#include <cstdio>

#include "cases.hpp"
#include "derivatives/constrained_derivatives.tpp"

namespace burnish::bench {
namespace {

struct Operations {
  long add = 0, multiply = 0, divide = 0, root = 0, trigonometric = 0;
};
Operations done;

/// A double that counts additions (with subtractions) and multiplications. Signs, comparisons and
/// choices are free.
class Counting {
 public:
  Counting() = default;
  Counting(double value) : value_(value) {}
  double value() const { return value_; }

  friend Counting operator+(Counting a, Counting b) { return ++done.add, a.value_ + b.value_; }
  friend Counting operator-(Counting a, Counting b) { return ++done.add, a.value_ - b.value_; }
  friend Counting operator*(Counting a, Counting b) { return ++done.multiply, a.value_ * b.value_; }
  friend Counting operator/(Counting a, Counting b) { return ++done.divide, a.value_ / b.value_; }
  Counting operator-() const { return -value_; }
  Counting& operator+=(Counting b) { return *this = *this + b; }
  Counting& operator-=(Counting b) { return *this = *this - b; }
  Counting& operator*=(Counting b) { return *this = *this * b; }
  friend bool operator<(Counting a, Counting b) { return a.value_ < b.value_; }

  friend Counting sqrt(Counting a) { return ++done.root, std::sqrt(a.value_); }
  friend Counting sin(Counting a) { return ++done.trigonometric, std::sin(a.value_); }
  friend Counting cos(Counting a) { return ++done.trigonometric, std::cos(a.value_); }
  friend Counting atan2(Counting y, Counting x) {
    return ++done.trigonometric, std::atan2(y.value_, x.value_);
  }

 private:
  double value_ = 0.0;
};

std::vector<Counting> counting(const Eigen::VectorXd& x) { return {x.begin(), x.end()}; }

void print(const char* work, const Case& what, const std::string& reference) {
  std::printf("%-28s %-15s %-4s %-8s %8ld %8ld %6ld %5ld %5ld\n", work, what.label.c_str(),
              what.contact.c_str(), reference.c_str(), done.multiply, done.add, done.divide,
              done.root, done.trigonometric);
}

void count(const Case& what, const std::string& reference) {
  const Model& model = model_of(what.robot);
  const States state = states_near_reference(what.robot, 1);
  const auto q = counting(state.q.col(0)), v = counting(state.v.col(0)),
             tau = counting(state.tau.col(0));
  ConstrainedDynamics<Counting> dynamics(model, ContactSet(model, what.specs(reference)), {});
  ConstrainedDerivatives<Counting> derivatives(dynamics);
  const std::vector<Counting> lambda(static_cast<std::size_t>(dynamics.rows()), Counting(1.0));

  done = {};
  dynamics.set_state(q.data(), v.data());
  dynamics.inverse(tau.data(), lambda.data());
  derivatives.inverse(dynamics);
  print("inverse_dynamics_derivatives", what, reference);

  done = {};
  dynamics.set_state(q.data(), v.data());
  dynamics.forward(tau.data());
  print("constrained_dynamics", what, reference);
  derivatives.forward(dynamics);
  print("constrained_derivatives", what, reference);
}

}  // namespace
}  // namespace burnish::bench

int main() {
  using namespace burnish::bench;
  std::printf("%-28s %-15s %-4s %-8s %8s %8s %6s %5s %5s\n", "work", "robot", "", "", "multiply",
              "add", "divide", "root", "trig");
  for (const Case& what : cases())
    for (const std::string& reference : references()) count(what, reference);
}
