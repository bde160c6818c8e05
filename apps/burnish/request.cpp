#include "request.hpp"

#include <fmt/format.h>

#include <map>

#include "burnish/contact/contact_set.hpp"
#include "burnish/model/state.hpp"
#include "request_contact.hpp"
#include "robots/known_robots.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

/// The name as load_robot wants it.
std::string locate(const std::string& name, const fs::path& folder) {
  const fs::path path(name);
  if (path.is_absolute() || folder.empty()) return name;
  std::error_code ignored;
  const std::string bare = name.substr(0, name.rfind(':'));
  // A bare word such as "talos" is a robot's name before it is a folder's.
  if (!is_robot_path(name) && !is_robot_path(bare)) return name;
  if (fs::exists(folder / name, ignored) || fs::exists(folder / bare, ignored)) {
    return (folder / name).string();
  }
  return name;
}

Robot load_robot_of(const JsonReader& reader, const fs::path& folder) {
  RobotOverrides overrides;
  if (reader.has("base")) {
    const std::string base = reader["base"].text();
    if (base != "fixed" && base != "free_flyer") {
      reader["base"].refuse("unknown base '" + base + "'; wanted fixed or free_flyer");
    }
    overrides.base = base == "fixed" ? Base::Fixed : Base::FreeFlyer;
  }
  if (reader.has("lock")) overrides.locked = reader["lock"].texts();
  if (reader.has("free")) overrides.free = reader["free"].texts();
  if (reader.has("lock_posture")) overrides.posture = reader["lock_posture"].text();
  if (reader.has("strict")) overrides.strict = reader["strict"].yes_or_no();
  const JsonReader name = reader["robot"];
  return name.named([&] { return load_robot(locate(name.text(), folder), overrides); });
}

/// What requests of one list share.
struct Shared {
  fs::path folder;
  std::map<std::string, Robot> robots = {};  ///< of earlier requests: often they are the same
  std::size_t state_bytes = 0;
};

/// Its numbers, and what memory is lost between them.
std::size_t bytes_of_state(const Model& model, std::size_t rows) {
  const auto numbers = static_cast<std::size_t>(model.nq + 3 * model.nv) + rows;
  return sizeof(EvalState) + 5 * 32 + numbers * sizeof(double);
}

Robot read_robot(const JsonReader& reader, Shared& shared) {
  nlohmann::json wanted;
  for (const char* key : {"robot", "base", "lock", "free", "lock_posture", "strict"})
    if (reader.has(key)) wanted[key] = reader.json().at(key);
  const std::string name = wanted.dump();
  const auto found = shared.robots.find(name);
  if (found != shared.robots.end()) return found->second;
  return shared.robots.emplace(name, load_robot_of(reader, shared.folder)).first->second;
}

void add_frames(const JsonReader& list, Model& model) {
  for (const JsonReader& entry : list.entries()) {
    const Eigen::Isometry3d placement = entry.placement({"name", "parent"});
    Frame frame;
    frame.name = entry["name"].text();
    if (frame.name.empty() || frame.name == "world" || model.has_frame(frame.name)) {
      entry["name"].refuse("the name '" + frame.name + "' is empty or taken");
    }
    frame.kind = FrameKind::User;
    const JsonReader parent = entry["parent"];
    const int index = parent.named([&] { return model.frame_index(parent.text()); });
    const Frame& on = model.frames[static_cast<std::size_t>(index)];
    frame.body = on.body;
    frame.placement = on.placement * placement;
    model.frames.push_back(frame);
  }
}

ContactSolver read_solver(const JsonReader& reader) {
  reader.allow_only({"mu", "max_proximal_iterations", "proximal_tolerance"});
  ContactSolver solver;
  const auto not_negative = [&](const char* key, double otherwise) {
    if (!reader.has(key)) return otherwise;
    const double value = reader[key].number();
    if (value < 0.0) reader[key].refuse(fmt::format("it is {}; wanted no negative number", value));
    return value;
  };
  solver.mu = not_negative("mu", solver.mu);
  solver.proximal_tolerance = not_negative("proximal_tolerance", solver.proximal_tolerance);
  if (reader.has("max_proximal_iterations")) {
    solver.max_proximal_iterations = reader["max_proximal_iterations"].count();
  }
  return solver;
}

/// A list of all entries, or an object of some of them by name; the others are zero.
Eigen::VectorXd read_entries(const JsonReader& reader, const std::vector<std::string>& names) {
  const int size = static_cast<int>(names.size());
  if (!reader.is_object()) return reader.numbers(size);
  reader.allow_only(names);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size);
  for (int i = 0; i < size; ++i) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    if (reader.has(name)) result[i] = reader[name].number();
  }
  return result;
}

/// A list of nq numbers, the name of a posture, or a posture {joint: value or values}.
Eigen::VectorXd read_configuration(const JsonReader& reader, const Robot& robot) {
  return reader.named([&]() -> Eigen::VectorXd {
    if (reader.is_text()) return robot.posture(reader.text());
    if (!reader.is_object()) {
      const Eigen::VectorXd q = reader.numbers();
      check_configuration(robot.model, q, "q");
      return q;
    }
    Posture posture;
    for (const auto& item : reader.json().items()) {
      const JsonReader value(item.value(), item.key());
      if (value.is_list()) {
        const Eigen::VectorXd values = value.numbers();
        posture[item.key()].assign(values.begin(), values.end());
      } else {
        posture[item.key()] = {value.number()};
      }
    }
    return configuration(robot.model, posture);
  });
}

/// The robot of the states to read, the names of their entries, and the state that states nothing.
struct StateSpace {
  const Robot& robot;
  std::vector<std::string> v_names, row_names;
  Eigen::VectorXd q;
};

EvalState read_state(const JsonReader& reader, const StateSpace& space) {
  reader.allow_only({"q", "v", "tau", "a", "lambda"});
  const auto entries = [&](const char* key, const std::vector<std::string>& names) {
    if (reader.has(key)) return read_entries(reader[key], names);
    return Eigen::VectorXd(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(names.size())));
  };
  return {reader.has("q") ? read_configuration(reader["q"], space.robot) : space.q,
          entries("v", space.v_names), entries("tau", space.v_names), entries("a", space.v_names),
          entries("lambda", space.row_names)};
}

std::set<std::string> read_compute(const JsonReader& reader) {
  std::set<std::string> wanted;
  for (const std::string& word : reader.texts()) {
    const auto& known = computable();
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      const std::string hint = did_you_mean(word, known);
      reader.refuse(
          fmt::format("unknown word '{}'{}", word,
                      hint.empty() ? fmt::format("; known are {}", fmt::join(known, ", ")) : hint));
    }
    wanted.insert(word);
  }
  return wanted;
}

/// Everything is read and checked before anything is computed.
EvalRequest read_request(const JsonReader& reader, Shared& shared) {
  reader.allow_only({"robot", "base", "lock", "free", "lock_posture", "strict", "frames", "gravity",
                     "states", "contacts", "solver", "compute", "forces_in"});
  EvalRequest request;
  request.robot = read_robot(reader, shared);
  request.robot_name = reader["robot"].text();
  Model& model = request.robot.model;
  if (reader.has("frames")) add_frames(reader["frames"], model);
  if (reader.has("gravity")) model.gravity = reader["gravity"].numbers(3);
  if (reader.has("contacts")) {
    for (const JsonReader& entry : reader["contacts"].entries()) {
      request.contacts.push_back(read_contact(entry));
    }
  }
  const ContactSet set(model, request.contacts);
  if (reader.has("solver")) request.solver = read_solver(reader["solver"]);
  request.compute = {"forward"};
  if (reader.has("compute")) request.compute = read_compute(reader["compute"]);
  if (reader.has("forces_in")) {
    const JsonReader list = reader["forces_in"];
    request.forces_in = list.texts();
    for (const std::string& name : request.forces_in) {
      list.named([&] { return Reference::parse(name); });
    }
    request.compute.insert("forces");
  }
  StateSpace space{request.robot, {}, set.row_names(), request.robot.reference_configuration()};
  for (int k = 0; k < model.nv; ++k) space.v_names.push_back(model.v_name(k));
  if (!reader.has("states")) {
    request.states.push_back(read_state({nlohmann::json::object(), ""}, space));
    return request;
  }
  const JsonReader states = reader["states"];
  constexpr std::size_t megabyte = 1'000'000, most = 400 * megabyte;  // all are in memory at once
  const std::size_t count = states.is_list() ? states.json().size() : 0;
  shared.state_bytes += count * bytes_of_state(model, space.row_names.size());
  if (shared.state_bytes > most) {
    states.refuse(fmt::format(
        "its {} states and those before them take {} MB of memory; at most {} MB are read at once",
        count, shared.state_bytes / megabyte, most / megabyte));
  }
  for (const JsonReader& entry : states.entries()) {
    request.states.push_back(read_state(entry, space));
  }
  return request;
}

}  // namespace

const std::vector<std::string>& computable() {
  static const std::vector<std::string> words{"mass_matrix",
                                              "bias",
                                              "jacobian",
                                              "contact_velocity",
                                              "contact_error",
                                              "forward",
                                              "forward_derivatives",
                                              "inverse",
                                              "inverse_derivatives",
                                              "acceleration",
                                              "acceleration_derivatives",
                                              "forces",
                                              "frames",
                                              "diagnosis"};
  return words;
}

EvalRequests read_requests(const std::string& text, const std::string& source,
                           const fs::path& folder) {
  const nlohmann::json parsed = parse_json(text, source);
  const JsonReader reader(parsed, "");
  EvalRequests result;
  Shared shared{folder};
  result.is_list = reader.is_list();
  try {
    if (!result.is_list) {
      result.requests.push_back(read_request(reader, shared));
      return result;
    }
    // All robots are in memory at once.
    constexpr std::size_t most = 1000;
    const std::vector<JsonReader> entries = reader.entries();
    if (entries.size() > most) {
      reader.refuse(fmt::format(
          "it has {} requests; at most {} are answered at once, and each may have many states",
          entries.size(), most));
    }
    for (const JsonReader& entry : entries) {
      const JsonReader named(entry.json(), "request " + entry.place());
      result.requests.push_back(read_request(named, shared));
    }
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
  return result;
}

}  // namespace burnish::app
