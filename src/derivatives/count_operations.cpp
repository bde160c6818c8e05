#include "derivatives/count_operations.hpp"

#include "base/to_size.hpp"
#include "derivatives/constrained_derivatives.tpp"

namespace burnish {
namespace {

thread_local Operations done;

/// Number that counts its arithmetic operations. Signs, comparisons and selections do not count.
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

}  // namespace

OperationCounts count_operations(const Model& model, const std::vector<ContactSpec>& contacts,
                                 const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& tau) {
  const auto at_q = counting(q), at_v = counting(v), at_tau = counting(tau);
  ConstrainedDynamics<Counting> dynamics(model, ContactSet(model, contacts), {});
  ConstrainedDerivatives<Counting> derivatives(dynamics);
  const std::vector<Counting> lambda(to_size(dynamics.rows()), Counting(1.0));
  OperationCounts counts;

  done = {};
  dynamics.set_state(at_q.data(), at_v.data());
  dynamics.inverse(at_tau.data(), lambda.data());
  derivatives.inverse(dynamics);
  counts.inverse_derivatives = done;

  done = {};
  dynamics.set_state(at_q.data(), at_v.data());
  dynamics.forward(at_tau.data());
  counts.dynamics = done;
  derivatives.forward(dynamics);
  counts.derivatives = done;
  return counts;
}

}  // namespace burnish
