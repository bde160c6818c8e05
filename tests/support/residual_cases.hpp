// Residuals for the laws of optimal control problems. A new residual joins with one line in
// residual_cases().
#pragma once

#include "support/ocp_cases.hpp"

namespace burnish::test {

/// Reference whose axes follow a surface of the world, or of another frame, at `origin`.
inline Reference following(const Quadric& surface, const Anchor& axes = Anchor::Base,
                           const Anchor& origin = Anchor::Tool) {
  Reference result{origin, axes, tilt()};
  result.quadric = surface;
  return result;
}
inline Quadric saddle() { return Quadric::osculating({0.3, 0.0, 0.2}, tilt(), 0.15, 0.06, -0.2); }
inline Quadric ball() { return Quadric::sphere({0.2, -0.3, -4.0}, 0.4); }

struct ResidualCase {
  std::string name;
  std::function<Residual(const OcpSetup&)> make;
  Penalty penalty = {};
  bool at_the_end = true;  ///< needs neither controls nor forces
};

inline std::vector<ResidualCase> residual_cases(const OcpCase& test) {
  const bool at_the_end = test.acts_from_state();
  namespace R = residual;
  using Setup = const OcpSetup&;
  const Penalty abs = Penalty::smooth_absolute(0.3), quadratic;
  const Penalty inside =
      Penalty::barrier(Eigen::VectorXd::Constant(1, -0.2), Eigen::VectorXd::Constant(1, 0.3));
  const Penalty logarithm = Penalty::log_barrier(Eigen::VectorXd::Constant(1, -0.5),
                                                 Eigen::VectorXd::Constant(1, 1.5), 0.4);
  std::vector<ResidualCase> cases{
      {"state", [](Setup) { return R::State{}; }},
      {"state to target", [=](Setup s) { return R::State{s.state(test)}; }, abs},
      {"control", [](Setup) { return R::Control{0.5}; }, quadratic, false},
      {"joint position",
       [](Setup s) {
         return R::JointPosition{s.plain_joints(), 0.1};
       },
       inside},
      {"joint velocity", [](Setup) { return R::JointVelocity{}; }, logarithm},
      {"one velocity",
       [](Setup s) {
         return R::JointVelocity{{s.model.joints[1].name}, 0.2};
       }},
      {"joint torque", [](Setup) { return R::JointTorque{}; }, abs, at_the_end},
      {"position",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), Reference::world(tilt())};
       },
       inside},
      {"rotation",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion()};
       }},
      {"placement",
       [](Setup s) {
         return R::FramePlacement{s.tool, s.placement()};
       },
       logarithm},
      {"local velocity",
       [](Setup s) {
         return R::FrameVelocity{s.tool, Reference::local()};
       }},
      {"world velocity",
       [](Setup s) {
         return R::FrameVelocity{s.tool, Reference::world(), 0.1};
       }},
      {"turned local velocity",
       [](Setup s) {
         return R::FrameVelocity{s.tool, Reference::local(tilt()), s.random(6)};
       }},
      {"velocity in turning axes of the world",
       [](Setup s) {
         return R::FrameVelocity{s.tool, turning_reference(Anchor::World, Anchor::World), 0.1};
       },
       abs},
      {"velocity", [](Setup s) { return R::FrameVelocity{s.tool}; }, abs},
      {"velocity in the axes of another frame",
       [](Setup s) {
         return R::FrameVelocity{s.tool, {Anchor::Tool, s.other(), tilt()}, 0.1};
       }},
      {"position seen from another frame",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), {s.other(), Anchor::World, tilt()}};
       }},
      {"position in axes that turn in another frame",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), turning_reference(Anchor::World, s.other())};
       }},
      {"distance",
       [](Setup s) {
         return R::FrameDistance{s.tool, s.random(3)};
       },
       inside},
      {"distance from a line that turns with another frame",
       [](Setup s) {
         return R::FrameDistance{s.tool, s.random(3), Directions::x() | Directions::z(),
                                 turning_reference(Anchor::World, s.other())};
       }},
      {"rotation against another frame",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion(), {Anchor::Tool, s.other(), tilt()}};
       }},
      {"rotation against a surface",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion(), following(saddle())};
       },
       abs},
      {"rotation in turning axes",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion(),
                                 turning_reference(Anchor::World, Anchor::World)};
       }},
      {"inclination",
       [](Setup s) {
         return R::FrameInclination{s.tool, following(ball()), s.random(3), s.random(2)};
       },
       abs},
      {"inclination on a surface of another frame",
       [](Setup s) {
         return R::FrameInclination{s.tool, following(saddle(), s.other()), s.random(3)};
       }},
      {"inclination in the world", [](Setup s) { return R::FrameInclination{s.tool}; }, inside},
      {"height",
       [](Setup s) {
         return R::FrameHeight{s.tool, following(ball()), 0.1};
       },
       inside},
      {"height above a surface of another frame",
       [](Setup s) {
         return R::FrameHeight{s.tool, following(saddle(), middle_frame(s.model, s.tool))};
       }},
      {"position along a surface",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), following(saddle())};
       }},
      {"position along a surface of another frame",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), following(ball(), s.other(), Anchor::World)};
       }},
      {"distance along a surface",
       [](Setup s) {
         return R::FrameDistance{s.tool, s.random(3), Directions::x() | Directions::y(),
                                 following(saddle())};
       }},
      {"velocity along a surface",
       [](Setup s) {
         return R::FrameVelocity{s.tool, following(saddle()), s.random(6)};
       }},
      {"velocity along a surface of another frame",
       [](Setup s) {
         return R::FrameVelocity{s.tool, following(ball(), s.other(), s.other())};
       }},
      {"force",
       [](Setup s) {
         return R::ContactForce{"pad", {}, s.random(6)};
       },
       abs, at_the_end},
      {"force along a surface",
       [](Setup s) {
         return R::ContactForce{"pad", following(ball(), s.other()), s.random(6)};
       },
       abs, at_the_end},
      {"cone about a surface's normal",
       [](Setup) {
         return R::FrictionCone{"pad", 0.7, 2, following(saddle(), Anchor::Base, Anchor::World)};
       },
       quadratic, at_the_end},
      {"brace", [](Setup) { return R::ContactForce{"brace"}; }, quadratic, at_the_end},
      {"local force",
       [](Setup) {
         return R::ContactForce{"pad", Reference::local(tilt())};
       },
       quadratic, at_the_end},
      {"centered force",
       [](Setup) {
         return R::ContactForce{"pad", Reference::centered(), 3.0};
       },
       abs, at_the_end},
      {"world force",
       [](Setup) {
         return R::ContactForce{"brace", Reference::world()};
       },
       quadratic, at_the_end},
      {"force about another frame in turning axes",
       [](Setup s) {
         return R::ContactForce{"pad", turning_reference(s.other(), Anchor::Tool), 1.0};
       },
       quadratic, at_the_end},
      {"cone",
       [](Setup) {
         return R::FrictionCone{"pad", 0.4};
       },
       Penalty::at_least(1.0), at_the_end},
      {"local cone",
       [](Setup) {
         return R::FrictionCone{"pad", 0.7, 0, Reference::local()};
       },
       quadratic, at_the_end},
      {"pyramid",
       [](Setup) { return R::FrictionCone{.contact = "pad", .friction = 0.4, .sides = 5}; },
       Penalty::at_least(1.0), at_the_end},
      {"pressure", [](Setup) { return R::CenterOfPressure{"pad"}; }, quadratic, at_the_end},
      {"pressure and turning",
       [](Setup) { return R::CenterOfPressure{.contact = "pad", .friction = 0.3}; }, quadratic,
       at_the_end},
      {"centre of mass", [](Setup s) { return R::CenterOfMass{s.random(3)}; }},
      {"support",
       [](Setup) {
         return R::SupportMargin{{{-0.1, -0.2}, {0.3, -0.1}, {0.2, 0.3}, {-0.2, 0.1}}};
       },
       Penalty::at_least(0.3)},
      {"momentum", [](Setup) { return R::CentroidalMomentum{}; }, abs},
      {"own",
       [](Setup s) { return R::custom(WithoutJacobian{.frames = {s.tool}, .contacts = {"pad"}}); },
       abs, at_the_end},
      {"own with jacobian",
       [](Setup s) {
         return R::custom(WithJacobian{.frames = {s.tool}, .contacts = {"pad", "brace"}});
       },
       quadratic, at_the_end},
  };
  if (test.has_force_states) {
    cases.push_back({"force rate",
                     [](Setup s) {
                       return R::ContactForceRate{"pad", s.random(6)};
                     },
                     inside, false});
    cases.push_back(
        {"rate of a brace", [](Setup) { return R::ContactForceRate{"brace"}; }, abs, false});
  }
  if (test.torque_model)
    cases.push_back({"joint torque rate",
                     [](Setup) {
                       return R::JointTorqueRate{{}, 3.0};
                     },
                     inside, false});
  return cases;
}

/// Problem with one stage of one term per residual. Each stage has as many knots as a pack has
/// lanes, with growing steps. Residuals that may be terminal are also terminal costs.
inline ProblemSpec residual_problem(const OcpCase& test, const Model& model) {
  ProblemSpec spec = bare_problem(test, model);
  std::mt19937_64 generator(12);
  const OcpSetup setup{model, test.robot.tool, generator};
  for (const ResidualCase& residual_case : residual_cases(test)) {
    CostTerm term{.name = residual_case.name,
                  .residual = residual_case.make(setup),
                  .weight = 0.7,
                  .penalty = residual_case.penalty};
    spec.stages.push_back(
        {.name = residual_case.name, .contacts = {"brace", "pad"}, .costs = {term}});
    spec.stages.back().step = 0.02;
    spec.horizon.push_back({.stage = residual_case.name,
                            .knots = native_lanes,
                            .step = 0.03,
                            .duration = 0.04 * native_lanes});
    if (residual_case.at_the_end) spec.terminal.push_back(term);
  }
  return spec;
}

/// Whether the values `r` of a residual are within 0.1 rad of the cut of a logarithm or an angle,
/// where differences jump.
inline bool is_near_a_cut(const Residual& residual, const Eigen::VectorXd& r) {
  constexpr double largest = M_PI - 0.1;
  if (std::holds_alternative<residual::FrameRotation>(residual)) return r.norm() > largest;
  if (std::holds_alternative<residual::FramePlacement>(residual)) return r.tail(3).norm() > largest;
  if (const auto* of = std::get_if<residual::FrameInclination>(&residual)) {
    Eigen::VectorXd target = Eigen::VectorXd::Zero(2);
    if (!of->target.empty()) of->target.at(0.0, target);
    return (r + target).cwiseAbs().maxCoeff() > largest;
  }
  return false;
}

/// Returns a random state that is not near the cut of a term.
inline OcpState state_off_cuts(Problem& problem, int knot, int term, const Residual& residual,
                               std::mt19937_64& generator) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    OcpState state = random_ocp_state(problem, generator);
    if (!is_near_a_cut(residual, problem.residual(knot, term, state.x, state.u))) return state;
  }
  throw Error("every state is near the cut of an angle");
}

}  // namespace burnish::test
