// Derivatives of every kind of contact against automatic differentiation and differences; see
// support/contact_laws.hpp.
#include <gtest/gtest.h>

#include <tuple>

#include "support/contact_laws.hpp"

namespace burnish::test {
namespace {

class ContactLaw : public ::testing::TestWithParam<std::tuple<LawRobot, std::string>> {};

TEST_P(ContactLaw, Derivatives_EqualAutomaticDifferentiationAndDifferences) {
  const auto& [robot, reference] = GetParam();
  for (const LawRow& row : sweep(robot, reference, law_states())) {
    SCOPED_TRACE(row.directions.text() + (row.two_bodies ? ", two bodies" : ", one body") +
                 ", worst: " + row.worst_case);
    EXPECT_GT(row.states, 0);
    EXPECT_LE(row.autodiff, 1e-9);
    EXPECT_LE(row.differences, 1e-5);
  }
}

std::string name_of_case(const ::testing::TestParamInfo<ContactLaw::ParamType>& info) {
  std::string name = std::get<0>(info.param).name + "_" + std::get<1>(info.param);
  for (char& c : name)
    if (c == ':') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(all, ContactLaw,
                         ::testing::Combine(::testing::ValuesIn(law_robots()),
                                            ::testing::ValuesIn(law_references())),
                         name_of_case);

}  // namespace
}  // namespace burnish::test
