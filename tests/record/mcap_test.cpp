// Tests of MCAP recordings, read back by an independent reader.
#include "record/mcap.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>
#include <sstream>

#include "burnish/dynamics/placement.hpp"
#include "record/page_data.hpp"
#include "record/page_json.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

/// Reads the fields of a record in order.
class Fields {
 public:
  explicit Fields(std::string bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t number(int size) {
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_.at(at_++))) << (8 * i);
    return value;
  }
  std::string bytes(std::uint64_t size) {
    if (size > bytes_.size() - at_) throw std::out_of_range("record ends early");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  std::string text() { return bytes(number(4)); }
  std::string rest() { return bytes(bytes_.size() - at_); }
  bool done() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

struct Record {
  int op;
  std::size_t offset, length;  // offset within the read bytes, length with the record's head
  std::string body;
};

std::vector<Record> records_in(const std::string& bytes) {
  std::vector<Record> records;
  for (std::size_t at = 0; at < bytes.size();) {
    Fields head(bytes.substr(at, 9));
    const int op = static_cast<int>(head.number(1));
    const std::size_t size = head.number(8);
    records.push_back({op, at, size + 9, bytes.substr(at + 9, size)});
    EXPECT_EQ(records.back().body.size(), size);
    at += size + 9;
  }
  return records;
}

struct Message {
  std::string topic;
  std::uint64_t time;
  Json json;
};

/// Reads a whole file into its messages and checks every index.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    bytes_ = text.str();
    const std::string magic("\x89MCAP\x30\r\n", 8);
    EXPECT_EQ(bytes_.substr(0, 8), magic);
    EXPECT_EQ(bytes_.substr(bytes_.size() - 8), magic);
    for (const Record& record : records_in(bytes_.substr(8, bytes_.size() - 16)))
      take(record, record.offset + 8);
    EXPECT_EQ(order_.front(), 1);
    EXPECT_EQ(order_.back(), 2);
  }

  std::vector<Message> messages;
  std::map<std::string, std::map<std::string, std::string>> metadata;
  std::map<std::string, std::string> schema_of;  // name of the schema by topic
  int chunks = 0;

 private:
  void take(const Record& record, std::size_t offset) {
    order_.push_back(record.op);
    Fields fields(record.body);
    switch (record.op) {
      case 2: {
        const std::uint64_t summary = fields.number(8), offsets = fields.number(8);
        EXPECT_EQ(summary, summary_start_);
        EXPECT_GT(offsets, summary);
        // The checksum covers the summary up to the checksum itself.
        const std::size_t end = offset + 9 + 16;
        EXPECT_EQ(fields.number(4), crc32(bytes_.substr(summary, end - summary)));
        break;
      }
      case 3: {
        const auto id = fields.number(2);
        schemas_[id] = fields.text();
        EXPECT_EQ(fields.text(), "jsonschema");
        EXPECT_TRUE(Json::parse(fields.text()).is_object());
        break;
      }
      case 4: {
        const auto id = fields.number(2), schema = fields.number(2);
        topics_[id] = fields.text();
        EXPECT_TRUE(schemas_.contains(schema));
        schema_of[topics_[id]] = schemas_[schema];
        EXPECT_EQ(fields.text(), "json");
        break;
      }
      case 6:
        take_chunk(fields, offset, record.length);
        break;
      case 7: {
        const auto channel = fields.number(2);
        Fields entries(fields.text());
        while (!entries.done()) {
          const auto time = entries.number(8), at = entries.number(8);
          EXPECT_TRUE(placed_.contains({channel, time, at}));
          ++indexed_;
        }
        break;
      }
      case 8:
        take_chunk_index(fields);
        break;
      case 0x0B:
        EXPECT_EQ(fields.number(8), messages.size());
        EXPECT_EQ(fields.number(2), schemas_.size());
        EXPECT_EQ(fields.number(4), topics_.size());
        EXPECT_EQ(fields.number(4), 0U);
        EXPECT_EQ(fields.number(4), metadata.size());
        EXPECT_EQ(fields.number(4), static_cast<std::uint64_t>(chunks));
        EXPECT_EQ(indexed_, messages.size());
        break;
      case 0x0C: {
        const std::string name = fields.text();
        Fields pairs(fields.text());
        while (!pairs.done()) {
          const std::string key = pairs.text();
          metadata[name][key] = pairs.text();
        }
        break;
      }
      case 0x0D: {
        const auto at = fields.number(8), length = fields.number(8);
        EXPECT_EQ(bytes_.at(at), '\x0C');
        EXPECT_EQ(records_in(bytes_.substr(at, length)).size(), 1U);
        break;
      }
      case 0x0F:
        EXPECT_EQ(fields.number(4), crc32(bytes_.substr(0, offset)));
        summary_start_ = offset + record.length;
        break;
      default:
        break;
    }
  }

  void take_chunk(Fields& fields, std::size_t offset, std::size_t length) {
    ++chunks;
    chunk_lengths_[offset] = length;
    const auto start = fields.number(8), end = fields.number(8), size = fields.number(8);
    const auto crc = fields.number(4);
    EXPECT_EQ(fields.text(), "");
    EXPECT_EQ(fields.number(8), size);
    const std::string inside = fields.rest();
    EXPECT_EQ(inside.size(), size);
    EXPECT_EQ(crc32(inside), crc);
    placed_.clear();
    for (const Record& record : records_in(inside)) {
      if (record.op != 5) {
        take(record, 0);
        continue;
      }
      Fields message(record.body);
      const auto channel = message.number(2);
      EXPECT_EQ(message.number(4), messages.size());
      const auto time = message.number(8);
      EXPECT_EQ(message.number(8), time);
      EXPECT_GE(time, start);
      EXPECT_LE(time, end);
      ASSERT_TRUE(topics_.contains(channel));
      messages.push_back({topics_[channel], time, Json::parse(message.rest())});
      placed_.insert({channel, time, record.offset});
    }
  }

  void take_chunk_index(Fields& fields) {
    (void)fields.bytes(16);
    const auto at = fields.number(8);
    ASSERT_TRUE(chunk_lengths_.contains(at));
    EXPECT_EQ(fields.number(8), chunk_lengths_[at]);
    Fields offsets(fields.text());
    while (!offsets.done()) {
      const auto channel = offsets.number(2), index = offsets.number(8);
      Fields record(bytes_.substr(index, 11));
      EXPECT_EQ(record.number(1), 7U);
      (void)record.number(8);
      EXPECT_EQ(record.number(2), channel);
    }
  }

  std::string bytes_;
  std::vector<int> order_;
  std::map<std::uint64_t, std::string> schemas_, topics_;
  std::set<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>> placed_;
  std::map<std::uint64_t, std::uint64_t> chunk_lengths_;
  std::size_t indexed_ = 0, summary_start_ = 0;
};

std::filesystem::path scratch_file() {
  return std::filesystem::temp_directory_path() /
         ("burnish_" + std::to_string(getpid()) + "_" +
          ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".mcap");
}

TEST(Mcap, Checksum_EqualsTheCrc32OfZip) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32("6789", crc32("12345")), 0xCBF43926U);
}

TEST(Mcap, ManyChunks_AreReadBack) {
  const std::filesystem::path file = scratch_file();
  McapWriter out(file, "test");
  const auto schema = out.add_schema("Number", R"({"type":"object"})");
  const auto a = out.add_channel(schema, "/a"), b = out.add_channel(schema, "/b");
  const std::string padding(1000, 'x');
  constexpr int count = 3000;
  for (int i = 0; i < count; ++i)
    out.write(i % 3 == 0 ? b : a, 1'000'000ULL * static_cast<std::uint64_t>(i),
              R"({"i":)" + std::to_string(i) + R"(,"p":")" + padding + "\"}");
  out.add_metadata("facts", {{"colour", "blue"}, {"empty", ""}});
  out.finish();
  const Reader reader(file);
  EXPECT_GE(reader.chunks, 3);
  ASSERT_EQ(reader.messages.size(), static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Message& message = reader.messages[static_cast<std::size_t>(i)];
    EXPECT_EQ(message.topic, i % 3 == 0 ? "/b" : "/a");
    EXPECT_EQ(message.json["i"], i);
    EXPECT_EQ(message.time, 1'000'000ULL * static_cast<std::uint64_t>(i));
  }
  EXPECT_EQ(reader.metadata.at("facts").at("colour"), "blue");
  std::filesystem::remove(file);
}

TEST(Mcap, EmptyRecording_IsValid) {
  const std::filesystem::path file = scratch_file();
  McapWriter out(file, "test");
  out.finish();
  const Reader reader(file);
  EXPECT_TRUE(reader.messages.empty());
  std::filesystem::remove(file);
}

TEST(Mcap, BadFileSchemaOrChannel_IsRefused) {
  expect_words(refusal([] { McapWriter("/nowhere/at/all.mcap", "test"); }), {"cannot write"});
  const std::filesystem::path file = scratch_file();
  McapWriter out(file, "test");
  expect_words(refusal([&] { (void)out.add_channel(1, "/a"); }), {"schema 1", "does not exist"});
  expect_words(refusal([&] { out.write(3, 0, "{}"); }), {"channel 3", "does not exist"});
  std::filesystem::remove(file);
}

TEST(Mcap, Run_IsWrittenWithFramesForcesAndMetrics) {
  const std::filesystem::path file = scratch_file();
  RunPage run = page_of_run(400, 10);
  run.plans = PlanRecord{
      .time = {0.0, 0.1}, .terms = {"force", "position"}, .costs = {{0.5, 0.5}, {0.5, 0.5}}};
  write_run_mcap(run, file);
  const Reader reader(file);
  EXPECT_EQ(reader.schema_of.at("/tf"), "foxglove.FrameTransforms");
  EXPECT_EQ(reader.schema_of.at("/tool_pose"), "foxglove.PoseInFrame");
  EXPECT_EQ(reader.schema_of.at("/scene"), "foxglove.SceneUpdate");
  EXPECT_EQ(reader.metadata.at("run").at("name"), "made_up");
  EXPECT_EQ(reader.metadata.at("metrics").at("force_rmse"), "null N");
  std::map<std::string, int> counts;
  std::uint64_t last = 0;
  const auto begin = static_cast<std::uint64_t>(run.created) * 1'000'000'000ULL;
  std::set<std::string> children;
  for (const Message& message : reader.messages) {
    EXPECT_GE(message.time, last);
    last = message.time;
    ++counts[message.topic];
    const double t = 1e-9 * static_cast<double>(message.time - begin);
    if (message.topic == "/joint_states") {
      EXPECT_EQ(message.json["name"], Json::parse(R"(["hinge", "spin"])"));
      EXPECT_NEAR(message.json["position"][0].get<double>(), 0.5 * t, 1e-9);
    }
    if (message.topic == "/force") {
      EXPECT_EQ(message.json["force_normal"], 30);
      const Json& stamp = message.json["timestamp"];
      EXPECT_EQ(
          stamp["sec"].get<std::uint64_t>() * 1'000'000'000ULL + stamp["nsec"].get<std::uint64_t>(),
          message.time);
    }
    if (message.topic != "/tf" && message.topic != "/tf_static") continue;
    for (const Json& transform : message.json["transforms"]) {
      children.insert(transform["child_frame_id"]);
      if (transform["child_frame_id"] != "wheel") continue;
      const Eigen::Isometry3d wheel =
          frame_placement(run.robot.model, Eigen::Vector3d(0.5 * t, 1.0, 0.0), "wheel");
      EXPECT_NEAR(transform["translation"]["x"].get<double>(), wheel.translation().x(), 1e-8);
      EXPECT_NEAR(transform["translation"]["y"].get<double>(), wheel.translation().y(), 1e-8);
    }
  }
  EXPECT_EQ(children, (std::set<std::string>{"base", "arm", "wheel"}));
  EXPECT_EQ(counts["/force"], 41);
  EXPECT_EQ(counts["/tf_static"], 1);
  EXPECT_EQ(counts["/costs"], 2);
  EXPECT_EQ(counts["/solver"], 400);
  std::filesystem::remove(file);
}

TEST(Mcap, RobotWithoutATool_HasNoForceAndNoPath) {
  const std::filesystem::path file = scratch_file();
  RunPage run = page_of_run(0);
  run.tool_frame.clear();
  add_trace(run, page_trace(run.robot.model, 400), 10);
  for (const PageColumn& column : run.columns)
    EXPECT_TRUE(column.name == "force_target" ||
                (column.name.rfind("force_", 0) != 0 && column.name.rfind("path_", 0) != 0))
        << column.name;
  write_run_mcap(run, file);
  const Reader reader(file);
  for (const char* topic : {"/force", "/task", "/tool_pose", "/target_pose"})
    EXPECT_FALSE(reader.schema_of.contains(topic)) << topic;
  EXPECT_TRUE(reader.schema_of.contains("/joint_states"));
  EXPECT_GT(reader.messages.size(), 40U);
  std::filesystem::remove(file);
}

TEST(Mcap, CurvedSurface_TargetTipTouchesTheSurface) {
  const std::filesystem::path file = scratch_file();
  RunPage run = page_of_run(400, 10);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Surface surface(SurfaceShape::parse("sphere:0.2"),
                        run.path_origin_world - run.tip_radius * up, up);
  run.surface.nominal = surface;
  write_run_mcap(run, file);
  int poses = 0;
  for (const Message& message : Reader(file).messages) {
    if (message.topic != "/target_pose") continue;
    const Json& p = message.json["pose"]["position"];
    const Eigen::Vector3d tip(p["x"].get<double>(), p["y"].get<double>(), p["z"].get<double>());
    EXPECT_NEAR(surface.at(tip).distance, run.tip_radius, 1e-9);
    ++poses;
  }
  EXPECT_GT(poses, 10);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace burnish::testing
