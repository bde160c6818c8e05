// Tests of texts that are unreasonably long, nested or repetitive: a reader reads or refuses each
// text within a second. It refuses a text that would expand beyond memory before building its
// contents.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "burnish/urdf/urdf.hpp"
#include "fuzz/readers.hpp"
#include "support/refusal.hpp"

namespace burnish::fuzz {
namespace {

/// Joins numbered pieces to a text of about 64 kB.
std::string many_pieces(const std::function<std::string(const std::string&)>& piece,
                        std::size_t bytes = 64000, const char* between = ",") {
  std::string text;
  for (int i = 0; text.size() < bytes; ++i)
    text += (i == 0 ? "" : between) + piece(std::to_string(i));
  return text;
}
std::string many_pieces(const std::string& piece, std::size_t bytes = 64000) {
  return many_pieces([&](const std::string&) { return piece; }, bytes);
}
std::string repeated(int count, const std::string& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

struct LongText {
  const char* name;
  const Reader& reader;
  std::string (*text)();  ///< makes the text on demand, because all texts are 30 MB
  std::string refusal;    ///< expected part of the refusal; empty: the text is read
};
void PrintTo(const LongText& text, std::ostream* out) { *out << text.name; }

const std::string pendulum = "robot: pendulum\nstages: {s: {costs: {r: {type: joint_velocity}}}}\n";
std::string costs(const std::string& entries, const std::string& horizon) {
  return "robot: pendulum\nstages: {s: {costs: &c {" + entries + "}}}\nhorizon: " + horizon + "\n";
}

std::string name_of(const ::testing::TestParamInfo<LongText>& info) { return info.param.name; }

class LongInput : public ::testing::TestWithParam<LongText> {};

TEST_P(LongInput, AnyText_IsReadOrRefusedWithinASecond) {
  const LongText& info = GetParam();
  const std::string sentence = run(info.reader, info.text());
  if (info.refusal.empty()) {
    EXPECT_EQ(sentence, "");
  }
  EXPECT_NE(sentence.find(info.refusal), std::string::npos) << sentence;
}

INSTANTIATE_TEST_SUITE_P(
    Problem, LongInput,
    ::testing::Values(
        LongText{"knots", problem, [] { return std::string(pendulum + "horizon: [s: 100000]\n"); },
                 ""},
        LongText{"too_many_knots", problem,
                 [] { return std::string(pendulum + "horizon: [s: 100000, s: 1]\n"); },
                 "more than 100000 knots"},
        LongText{"repeated_repeats", problem,
                 [] {
                   return std::string(
                       pendulum + "horizon: [{repeat: 50000, of: [{repeat: 3, of: [s: 1]}]}]\n");
                 },
                 "the repeated entries have more than 100000 knots"},
        LongText{"segments", problem,
                 [] {
                   return std::string(pendulum + "horizon: [" +
                                      many_pieces("{repeat: 90000, of: [s: 1]}") + "]\n");
                 },
                 "more than 100000 knots"},
        LongText{"nested_repeats", problem,
                 [] {
                   return std::string(pendulum + "horizon: [" + repeated(28, "{repeat: 1, of: [") +
                                      "{repeat: 90000, of: [s: 1]}" + repeated(28, "]}") + "]\n");
                 },
                 ""},
        LongText{"doubling_aliases", problem,
                 [] {
                   std::string text = pendulum + "a0: &a0 [s: 1]\n";
                   for (int i = 1; i < 25; ++i) {
                     const std::string last = "{repeat: 2, of: *a" + std::to_string(i - 1) + "}";
                     text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last +
                             "," + last + "]\n";
                   }
                   return text + "horizon: *a24\n";
                 },
                 "expand to more than 200000 values"},
        LongText{"nested_anchors", problem,
                 [] {
                   std::string text = "x: ";
                   for (int i = 0; i < 60; ++i) text += "&a" + std::to_string(i) + " [";
                   return text + many_pieces("1", 60000) + repeated(60, "]") + "\n";
                 },
                 "expand to more than 200000 values"},
        LongText{"alias_of_itself", problem,
                 [] { return std::string(pendulum + "horizon: &h [{repeat: 2, of: *h}]\n"); },
                 "an alias refers to a value that contains it"},
        LongText{"nesting", problem,
                 [] {
                   return std::string(pendulum + "horizon: " + repeated(150, "[") +
                                      repeated(150, "]") + "\n");
                 },
                 "nested more than 64 deep"},
        LongText{"keys", problem,
                 [] {
                   return std::string(
                       "{" + many_pieces([](const auto& i) { return "k" + i + ": 1"; }) + "}");
                 },
                 "key 'k0' is unknown"},
        LongText{
            "contacts", problem,
            [] {
              return std::string(
                  "robot: pendulum\ncontacts: {" +
                  many_pieces([](const auto& i) { return "c" + i + ": {tool: tip}"; }) +
                  "}\nstages: {s: {costs: {r: {type: control, target: hold}}}}\nhorizon: [s: 1]\n");
            },
            "contacts; wanted at most 100"},
        LongText{"holds", problem,
                 [] {
                   return std::string(costs(many_pieces([](const auto& i) {
                                              return "r" + i + ": {type: control, target: hold}";
                                            }),
                                            "[s: 1]"));
                 },
                 ""},
        LongText{"costs_by_alias", problem,
                 [] {
                   return std::string(
                       "robot: pendulum\nstages: {s: {costs: &c {" +
                       many_pieces([](const auto& i) { return "r" + i + ": {type: control}"; },
                                   10000) +
                       "}}, " +
                       many_pieces([](const auto& i) { return "s" + i + ": {costs: *c}"; }, 1000) +
                       "}\nhorizon: [s: 1]\n");
                 },
                 "more than 10000 costs"},
        LongText{"targets", problem,
                 [] {
                   return std::string(
                       costs(many_pieces([](const auto& i) { return "r" + i + ": {type: state}"; }),
                             "[s: 100000]"));
                 },
                 "wanted at most 10000000 of these in all knots together"},
        LongText{"path", problem,
                 [] { return std::string("robot: " + repeated(30000, "a/") + "\n"); },
                 "does not exist"},
        LongText{"name", problem,
                 [] { return std::string("robot: " + std::string(60000, 'a') + "\n"); },
                 "does not exist"},
        LongText{"file", problem, [] { return std::string(std::string((4 << 20) + 1, '\n')); },
                 "larger than 4 MB"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Task, LongInput,
    ::testing::Values(
        LongText{"steps", task,
                 [] { return std::string("controller: {horizon: 1e6, step: 1e-3}\n"); },
                 "more than 100000 steps"},
        LongText{"rows", task, [] { return std::string("path: {kind: zigzag, rows: 1000000}\n"); },
                 "wanted at most 10000"},
        LongText{"points", task,
                 [] {
                   return std::string("path: {kind: points, points: [" + many_pieces("[0, 1]") +
                                      "]}\n");
                 },
                 ""},
        LongText{"override", task,
                 [] { return std::string("force: 30\n#set " + repeated(30000, "a.") + "b=1\n"); },
                 "nested more than 64 deep"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Robot, LongInput,
    ::testing::Values(
        LongText{"frames", robot,
                 [] {
                   return std::string("urdf: arm7.urdf\nframes: {" + many_pieces([](const auto& i) {
                                        return "f" + i + ": {parent: flange}";
                                      }) +
                                      "}\n");
                 },
                 ""},
        LongText{"postures_by_alias", robot,
                 [] {
                   return std::string(
                       "urdf: arm7.urdf\npostures: {p: &p {" +
                       many_pieces([](const auto& i) { return "j" + i + ": 1"; }, 32000) + "}, " +
                       many_pieces([](const auto& i) { return "q" + i + ": *p"; }, 32000) + "}\n");
                 },
                 "expand to more than 200000 values"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Description, LongInput,
    ::testing::Values(
        LongText{"attributes", urdf,
                 [] {
                   return std::string(
                       "<robot name='a'><link name='l' " +
                       many_pieces([](const auto& i) { return "a" + i + "=''"; }, 64000, " ") +
                       "/></robot>");
                 },
                 "more than 100 attributes"},
        LongText{"nesting", urdf,
                 [] { return std::string("<robot name='a'>" + repeated(20000, "<a>")); },
                 "nested too deeply"},
        LongText{"name", urdf,
                 [] {
                   return std::string("<robot name='a'><link name='" + std::string(32000, 'a') +
                                      "'/><joint name='j' type='fixed'><parent link='" +
                                      std::string(31000, 'a') +
                                      "'/><child link='b'/></joint></robot>");
                 },
                 "does not exist"},
        LongText{"bodies", mjcf,
                 [] {
                   return std::string("<mujoco><worldbody>" + many_pieces("<body><joint/></body>") +
                                      "</worldbody></mujoco>");
                 },
                 "more than 2000 links"},
        LongText{"bodies_in_bodies", mjcf,
                 [] {
                   return std::string("<mujoco><worldbody>" + repeated(90, "<body><joint/>") +
                                      repeated(90, "</body>") + "</worldbody></mujoco>");
                 },
                 ""},
        LongText{"classes", mjcf,
                 [] {
                   return std::string(
                       "<mujoco><default>" +
                       many_pieces([](const auto& i) { return "<default class='c" + i + "'>"; },
                                   14000, "") +
                       repeated(400, "</default>") + "</default></mujoco>");
                 },
                 "line 1"},
        LongText{"joints", mjcf,
                 [] {
                   return std::string("<mujoco><worldbody><body>" + many_pieces("<joint/>", 15000) +
                                      "</body></worldbody></mujoco>");
                 },
                 "links"},
        LongText{"equalities", mjcf,
                 [] {
                   return std::string("<mujoco><worldbody><body>" +
                                      repeated(30, "<body><joint name='a'/></body>") +
                                      "</body></worldbody><equality>" +
                                      many_pieces("<joint joint1='a' joint2='b'/>") +
                                      "</equality></mujoco>");
                 },
                 "does not exist"},
        LongText{"file", urdf, [] { return std::string(std::string((16 << 20) + 1, ' ')); },
                 "larger than 16 MB"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Request, LongInput,
    ::testing::Values(
        LongText{"states", request,
                 [] {
                   return std::string(R"({"robot": "talos", "states": [)" + many_pieces("{}") +
                                      "]}");
                 },
                 ""},
        LongText{"requests", request,
                 [] {
                   return std::string(
                       "[" + many_pieces(R"({"robot": "talos", "compute": ["forward"]})", 40000) +
                       "]");
                 },
                 ""},
        LongText{"too_many_requests", request,
                 [] { return std::string("[" + many_pieces(R"({"robot": "pendulum"})") + "]"); },
                 "requests; wanted at most 1000"},
        LongText{"too_many_states", request,
                 [] {
                   return std::string(R"({"robot": "talos", "states": [)" +
                                      many_pieces("{}", 1200000) + "]}");
                 },
                 "of memory; wanted at most 400 MB"},
        LongText{"file", request, [] { return std::string(std::string((32 << 20) + 1, ' ')); },
                 "larger than 32 MB"},
        LongText{"nesting", request,
                 [] { return std::string(repeated(32000, "[") + repeated(32000, "]")); },
                 "nested more than 64 deep"},
        LongText{"contacts", request,
                 [] {
                   return std::string(R"({"robot": "pendulum", "contacts": [)" +
                                      many_pieces([](const auto& i) {
                                        return R"({"name": "c)" + i + R"(", "tool": "tip"})";
                                      }) +
                                      "]}");
                 },
                 "contacts; wanted at most 100"},
        LongText{"path", request,
                 [] { return std::string(R"({"robot": ")" + repeated(32000, "a/") + R"("})"); },
                 "does not exist"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Table, LongInput,
    ::testing::Values(
        LongText{"columns", table, [] { return std::string(std::string(64000, ',')); },
                 "columns; wanted at most 10000"},
        LongText{"cells", table, [] { return std::string("time,u\n" + std::string(64000, ',')); },
                 "has 64001 cells; wanted 2"},
        LongText{"rows", table, [] { return std::string("time\n" + repeated(32000, "1\n")); }, ""}),
    name_of);

TEST(LongFile, EndlessUrdf_IsRefused) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "needs /dev/zero";
  testing::expect_words(testing::refusal([] { read_urdf("/dev/zero"); }), {"larger than 64 MB"});
}

}  // namespace
}  // namespace burnish::fuzz
