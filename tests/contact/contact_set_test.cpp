// Several contacts at once: on one link, switched on and off, redundant, and invalid ones.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "support/contact_states.hpp"
#include "support/refusal.hpp"
#include "support/trees.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

TEST(ContactsOfOneLink, TwoContacts_EqualOneWithTheDirectionsOfBoth) {
  std::mt19937_64 generator(51);
  for (const std::string& name : {std::string("arm7"), humanoid().name}) {
    const Model model = robot(name);
    for (const Reference& reference : all_references()) {
      ContactSpec linear = contact("tool", "world", reference, Directions::linear());
      ContactSpec turning = contact("tool", "world", reference, Directions::parse("rx,ry"));
      turning.name = "tilts";
      ContactDynamics both(model, {linear, turning});
      ContactDynamics one(model,
                          {contact("tool", "world", reference, Directions::parse("x,y,z,rx,ry"))});
      const RobotState state = regular_state(model, one, generator);
      ASSERT_EQ(both.forward(state.q, state.v, state.tau), Status::Ok);
      ASSERT_EQ(one.forward(state.q, state.v, state.tau), Status::Ok);
      EXPECT_LT(relative_error(both.a(), one.a()), 1e-9) << reference.name();
      EXPECT_LT(relative_error(both.lambda(), one.lambda()), 1e-9) << reference.name();
      both.forward_derivatives();
      one.forward_derivatives();
      EXPECT_LT(relative_error(both.da_dq(), one.da_dq()), 1e-9) << reference.name();
      EXPECT_LT(relative_error(both.dlambda_dq(), one.dlambda_dq()), 1e-9) << reference.name();
      EXPECT_LT(relative_error(both.dlambda_dtau(), one.dlambda_dtau()), 1e-9) << reference.name();
    }
  }
}

/// Three contacts of a humanoid: two whose chains meet at the pelvis only, one between two links.
std::vector<ContactSpec> three_contacts() {
  ContactSpec left = contact("left_sole_link", "world", Reference::surface(tilt()));
  ContactSpec right = contact("right_sole_link", "world", Reference::world(), Directions::pad_z());
  ContactSpec hand =
      contact("tool", "leg_left_2_link", Reference::local(), Directions::parse("x,z,ry"));
  left.with_gains(40.0, 10.0);
  return {left, right, hand};
}

std::vector<ContactSpec> chosen(const std::vector<ContactSpec>& from, unsigned bits) {
  std::vector<ContactSpec> result;
  for (std::size_t i = 0; i < from.size(); ++i)
    if ((bits >> i & 1u) != 0) result.push_back(from[i]);
  return result;
}

/// Largest relative difference of all results of forward dynamics and its derivatives.
template <class Left, class Right>
double worst_difference(const Left& left, const Right& right) {
  double worst = 0.0;
  const auto compare = [&](const auto& x, const auto& y) {
    worst = std::max(worst, relative_error(x, y));
  };
  compare(left.a, right.a);
  compare(left.lambda, right.lambda);
  for (std::size_t i = 0; i < left.blocks.size(); ++i) compare(left.blocks[i], right.blocks[i]);
  return worst;
}

struct Results {
  Eigen::VectorXd a, lambda;
  std::vector<Eigen::MatrixXd> blocks;
};

Results results(ContactDynamics& d, const RobotState& s) {
  EXPECT_EQ(d.forward(s.q, s.v, s.tau), Status::Ok);
  EXPECT_EQ(d.forward_derivatives(), Status::Ok);
  return {d.a(),
          d.lambda(),
          {d.da_dq(), d.da_dv(), d.da_dtau(), d.dlambda_dq(), d.dlambda_dv(), d.dlambda_dtau(),
           d.jacobian(), d.contact_velocity(), d.contact_error()}};
}

Results results(ContactDynamicsBatch& d, const RobotState& s) {
  EXPECT_EQ(d.forward_with_derivatives(s.q, s.v, s.tau), Status::Ok);
  return {
      d.a(0),
      d.lambda(0),
      {d.da_dq(0), d.da_dv(0), d.da_dtau(0), d.dlambda_dq(0), d.dlambda_dv(0), d.dlambda_dtau(0)}};
}

/// Switches one random contact at a time, and compares with dynamics built for the active contacts.
template <class Dynamics, class Make>
void toggle_and_compare(const Make& make) {
  const Model model = humanoid().model();
  const std::vector<ContactSpec> all = three_contacts();
  Dynamics toggled = make(model, all);
  std::mt19937_64 generator(53);
  std::vector<char> active(all.size(), 1);
  ContactDynamics conditioning(model, all);
  for (int step = 0; step < 40; ++step) {
    const std::size_t which = generator() % all.size();
    active[which] = active[which] != 0 ? 0 : 1;
    toggled.set_active(static_cast<int>(which), active[which] != 0);
    unsigned bits = 0;
    for (std::size_t i = 0; i < all.size(); ++i) bits |= active[i] != 0 ? 1u << i : 0u;
    Dynamics fresh = make(model, chosen(all, bits));
    ASSERT_EQ(toggled.rows(), fresh.rows());
    const RobotState state = regular_state(model, conditioning, generator, 1e-4);
    EXPECT_LT(worst_difference(results(toggled, state), results(fresh, state)), 1e-10)
        << "contacts " << bits << " at step " << step;
  }
}

TEST(ContactSwitching, AnyOrder_EqualsASetWithoutTheContact) {
  toggle_and_compare<ContactDynamics>(
      [](const Model& model, const std::vector<ContactSpec>& contacts) {
        return ContactDynamics(model, contacts);
      });
}

TEST(ContactSwitching, AnyOrder_EqualsABatchWithoutTheContact) {
  toggle_and_compare<ContactDynamicsBatch>(
      [](const Model& model, const std::vector<ContactSpec>& contacts) {
        return ContactDynamicsBatch(model, contacts, 1);
      });
}

TEST(ContactSwitching, ActiveRows_AreNamedAndUnknownContactsRefused) {
  const Model model = humanoid().model();
  ContactDynamics dynamics(model, three_contacts());
  dynamics.set_active(0, false);
  EXPECT_FALSE(dynamics.is_active(0));
  EXPECT_EQ(dynamics.row_names(),
            (std::vector<std::string>{"right_sole_link/z", "right_sole_link/rx",
                                      "right_sole_link/ry", "tool/x", "tool/z", "tool/ry"}));
  expect_words(refusal([&] { dynamics.set_active(3, true); }),
               {"contact 3 does not exist", "has 3"});
  expect_words(refusal([&] { dynamics.set_active(-1, true); }), {"contact -1 does not exist"});
  expect_words(refusal([&] { dynamics.force("left_sole_lnk"); }), {"left_sole_link"});
}

std::vector<ContactSpec> pad_twice() {
  const Reference surface = Reference::surface(tilt());
  ContactSpec a = contact("tool", "world", surface, Directions::pad_z());
  ContactSpec b = a;
  a.name = "pad_a";
  b.name = "pad_b";
  return {a, b};
}

TEST(RedundantContacts, WithoutCompliance_GiveAStatusAndZeros) {
  const Model model = robot("arm7");
  std::mt19937_64 generator(57);
  ContactDynamics dynamics(model, pad_twice());
  const RobotState state = random_state(model, generator);
  EXPECT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::SingularContacts);
  EXPECT_EQ(dynamics.forward_derivatives(), Status::SingularContacts);
  EXPECT_EQ(dynamics.a(), Eigen::VectorXd::Zero(model.nv));
  EXPECT_EQ(dynamics.lambda(), Eigen::VectorXd::Zero(6));
  EXPECT_EQ(dynamics.da_dq(), RowMatrix::Zero(model.nv, model.nv));
  EXPECT_EQ(dynamics.dlambda_dtau(), RowMatrix::Zero(6, model.nv));
}

TEST(RedundantContacts, Diagnosis_NamesThemAndTheRowsThatImplyThem) {
  const Model model = robot("arm7");
  std::mt19937_64 generator(58);
  const ContactSet set(model, pad_twice());
  const Eigen::VectorXd q = random_configuration(model, generator);
  const ContactDiagnosis both = diagnose(model, set, q);
  EXPECT_EQ(both.text(),
            "contact 'pad_b', direction z: already held by pad_a/z\n"
            "contact 'pad_b', direction rx: already held by pad_a/rx\n"
            "contact 'pad_b', direction ry: already held by pad_a/ry\n");
  EXPECT_EQ(both.condition, std::numeric_limits<double>::infinity());
  const ContactDiagnosis one = diagnose(model, set, q, {1});
  EXPECT_EQ(one.text(), "the contacts are independent\n");
  EXPECT_LT(one.condition, 1e6);
}

TEST(RedundantContacts, ComplianceAndIterations_SplitTheForceEvenly) {
  const Model model = robot("arm7");
  std::mt19937_64 generator(59);
  const std::vector<ContactSpec> twice = pad_twice();
  ContactDynamics one(model, {twice[0]}), two(model, twice, {1e-6, 20, 1e-12});
  for (int i = 0; i < 20; ++i) {
    const RobotState state = regular_state(model, one, generator);
    ASSERT_EQ(one.forward(state.q, state.v, state.tau), Status::Ok);
    ASSERT_EQ(two.forward(state.q, state.v, state.tau), Status::Ok);
    EXPECT_LE(two.proximal_residual(), 1e-12);
    EXPECT_GE(two.proximal_iterations(), 1);
    EXPECT_LT(relative_error(two.a(), one.a()), 1e-8);
    const Eigen::VectorXd forces = two.lambda();
    EXPECT_LT(relative_error(forces.head(3) + forces.tail(3), one.lambda()), 1e-8);
    EXPECT_LT(relative_error(forces.head(3), forces.tail(3)), 1e-6) << "equal forces";
  }
}

TEST(RedundantContacts, TooFewIterations_GiveNotConverged) {
  const Model model = robot("arm7");
  std::mt19937_64 generator(60);
  ContactDynamics dynamics(model, pad_twice(), {10.0, 1, 1e-12});
  const RobotState state = random_state(model, generator);
  EXPECT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::NotConverged);
  EXPECT_EQ(dynamics.proximal_iterations(), 1);
  EXPECT_GT(dynamics.proximal_residual(), 1e-12);
  EXPECT_TRUE(dynamics.a().allFinite());
  EXPECT_GT(dynamics.a().norm(), 0.0);
}

Model two_links() { return build_model(testing::two_links()); }

TEST(StretchedArm, SingularPosture_IsReportedWithoutNan) {
  const Model model = two_links();
  const Eigen::Vector2d stretched(0.0, 0.0), turned(0.7, 0.0), v(0.5, -1.0), tau(3.0, -2.0);
  const auto tip = contact("tip", "world", Reference::centered(), Directions::parse("x,y"));
  for (const Eigen::Vector2d& q : {stretched, turned}) {
    ContactDynamics exact(model, {tip});
    EXPECT_EQ(exact.forward(q, v, tau), Status::SingularContacts);
    EXPECT_EQ(exact.forward_derivatives(), Status::SingularContacts);
    EXPECT_TRUE(exact.a().isZero(0.0));
    EXPECT_TRUE(exact.da_dq().isZero(0.0));
    ContactDynamics compliant(model, {tip}, {1e-6, 0, 1e-9});
    EXPECT_EQ(compliant.forward(q, v, tau), Status::Ok);
    EXPECT_EQ(compliant.forward_derivatives(), Status::Ok);
    EXPECT_TRUE(compliant.a().allFinite());
    EXPECT_TRUE(compliant.da_dq().allFinite());
    EXPECT_TRUE(compliant.dlambda_dv().allFinite());
  }
}

TEST(StretchedArm, Diagnosis_NamesImmovableAndRedundantDirections) {
  const Model model = two_links();
  const auto contacts_along = [&](const char* directions) {
    return ContactSet(
        model, {contact("tip", "world", Reference::centered(), Directions::parse(directions))});
  };
  EXPECT_EQ(diagnose(model, contacts_along("x,y"), Eigen::Vector2d(0.0, 0.0)).text(),
            "contact 'tip', direction x: no joint moves it at this posture\n");
  EXPECT_EQ(diagnose(model, contacts_along("x,y"), Eigen::Vector2d(0.7, 0.0)).text(),
            "contact 'tip', direction y: already held by tip/x\n");
  EXPECT_EQ(diagnose(model, contacts_along("x,y"), Eigen::Vector2d(0.7, 0.9)).text(),
            "the contacts are independent\n");
  EXPECT_EQ(diagnose(model, contacts_along("x,y,rz"), Eigen::Vector2d(0.7, 0.9)).text(),
            "contact 'tip', direction rz: already held by tip/x, tip/y\n");
  const Eigen::Vector2d unknown(std::nan(""), 0.0);
  expect_words(refusal([&] { diagnose(model, contacts_along("x"), unknown); }), {"q"});
}

TEST(InvalidContact, AnyDefect_IsRefusedWithTheReason) {
  const Model model = robot("arm7");
  const auto with = [&](const auto& change) {
    ContactSpec spec = contact("tool");
    spec.name = "pad";
    change(spec);
    return refusal([&] { ContactDynamics(model, {spec}); });
  };
  expect_words(with([](ContactSpec& s) { s.directions = Directions{}; }), {"'pad'", "empty"});
  expect_words(with([](ContactSpec& s) { s.tool = "tol"; }), {"'pad'", "'tol'", "'tool'"});
  expect_words(with([](ContactSpec& s) { s.base = "link_77"; }), {"'pad'", "base", "'link_7'"});
  expect_words(with([](ContactSpec& s) { s.base = "tool"; }), {"'pad'", "same body"});
  expect_words(with([](ContactSpec& s) { s.kp[2] = -1.0; }), {"'pad'", "gain"});
  expect_words(with([](ContactSpec& s) { s.kd[0] = std::nan(""); }), {"'pad'", "gain"});
  expect_words(with([](ContactSpec& s) { s.reference.rotation *= 2.0; }), {"'pad'", "rotation"});
  expect_words(refusal([&] {
                 ContactDynamics(model, {contact("tool"), contact("tool")});
               }),
               {"'tool'", "another contact has this name"});
  expect_words(refusal([&] { ContactDynamicsBatch(model, {}, 0); }), {"capacity is 0"});
}

}  // namespace
}  // namespace burnish::test
