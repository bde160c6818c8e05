#include "request.hpp"

#include <fmt/format.h>

#include <map>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/model/state.hpp"
#include "document/text.hpp"
#include "dynamics/reference.hpp"
#include "files/read_parts.hpp"
#include "robots/read_inertia.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;
using document::Reader;

/// Data that all requests in a list have in common.
struct RequestCache {
  fs::path folder;
  std::map<std::string, Robot> robots = {};  ///< Robots loaded for earlier requests, by name.
  std::size_t state_bytes = 0;
};

/// Returns the memory of a state: the state's numbers, and the overhead of allocations [bytes].
std::size_t bytes_of_state(const Model& model, std::size_t rows) {
  const auto numbers = to_size(model.nq + 3 * model.nv) + rows;
  return sizeof(EvalState) + 5 * 32 + numbers * sizeof(double);
}

Robot read_robot(const Reader& reader, RequestCache& shared) {
  std::string wanted;
  for (const char* key : {"robot", "base", "lock", "free", "lock_posture", "strict"})
    if (const auto value = reader.find(key)) wanted += key + document::json_text(value->node());
  const auto found = shared.robots.find(wanted);
  if (found != shared.robots.end()) return found->second;
  Robot robot = files::read_robot(reader["robot"], shared.folder, files::read_overrides(reader));
  return shared.robots.emplace(wanted, std::move(robot)).first->second;
}

void add_frames(const Reader& list, Model& model) {
  for (const Reader& entry : list.entries()) {
    const Eigen::Isometry3d placement = files::read_placement(entry, {"name", "parent"});
    Frame frame;
    frame.name = entry["name"].text();
    if (frame.name == "world" || model.has_frame(frame.name))
      entry["name"].refuse("the name " + in_quotes(frame.name) + " is taken");
    frame.kind = FrameKind::User;
    const Reader parent = entry["parent"];
    const int index = parent.named([&] { return model.frame_index(parent.text()); });
    const Frame& on = model.frames[to_size(index)];
    frame.body = on.body;
    frame.placement = on.placement * placement;
    model.frames.push_back(frame);
  }
}

/// Context for reading states: the robot, the names of a state's entries, and the default state.
struct StateSpace {
  const Robot& robot;
  Eigen::VectorXd q;
  std::vector<files::RowGroup> v_rows, contact_rows;
  bool strict = false;  ///< True to reject states with warnings.
};

Eigen::VectorXd read_q(const Reader& state, const StateSpace& space) {
  const auto q = state.find("q");
  return q ? files::read_configuration(space.robot, *q, Posture()) : space.q;
}

EvalState read_state(const Reader& reader, const StateSpace& space) {
  reader.allow_only({"q", "v", "tau", "a", "lambda"});
  const auto entries = [&](const char* key, const std::vector<files::RowGroup>& rows) {
    const auto value = reader.find(key);
    if (value) return files::read_rows(*value, rows, 0.0);
    return Eigen::VectorXd(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size())));
  };
  EvalState state{read_q(reader, space), entries("v", space.v_rows), entries("tau", space.v_rows),
                  entries("a", space.v_rows), entries("lambda", space.contact_rows)};
  const Model& model = space.robot.model;
  if (const auto v = reader.find("v")) v->named([&] { check_tangent(model, state.v); });
  state.warnings = odd_state(model, state.q, state.v, state.tau);
  if (space.strict && !state.warnings.empty()) reader.refuse(state.warnings.front());
  return state;
}

std::vector<files::RowGroup> rows_named(const std::vector<std::string>& names) {
  std::vector<files::RowGroup> rows;
  for (const std::string& name : names) rows.push_back({name});
  return rows;
}

/// Reads the value of `compute`: a single word or a list.
std::set<std::string> read_compute(const Reader& reader) {
  std::set<std::string> wanted;
  if (!reader.is_list()) return {reader.word(computable())};
  for (const Reader& entry : reader.entries()) wanted.insert(entry.word(computable()));
  return wanted;
}

/// Reads the contacts. The default of `target` is the placement of the tool in the first state.
/// Until version 0.2, the default was the identity. Therefore, `target` is required where the two
/// defaults would give different results.
void read_contacts(const Reader& reader, const Eigen::VectorXd& q, EvalRequest& request) {
  for (const auto& [name, entry] : files::contacts_in(reader)) {
    const ContactSpec spec = files::read_contact(name, entry, request.robot.model, q);
    const bool pulls = !spec.kp.isZero(0.0);
    if (!entry.has("target") && (pulls || request.compute.contains("contact_error")))
      entry.refuse(
          std::string("key 'target' is missing, but ") +
          (pulls ? "kp is not 0" : "compute lists contact_error") +
          "; wanted \"target\": \"here\" (the placement of the tool in the first state) or "
          "\"target\": {\"xyz\": [0, 0, 0]} (the frame 'base', the default until version 0.2)");
    request.contacts.push_back(spec);
  }
}

/// Reads one reference frame, a list of frames, or an object whose keys name frames. Without keys,
/// reference frames are named after their contents.
void read_forces_in(const Reader& reader, EvalRequest& request) {
  const auto add = [&](const std::string& own_name, const Reader& entry) {
    const Reference reference = files::read_reference(entry);
    entry.named([&] {  // throws for unknown frames
      return compile_reference(request.robot.model, reference, world_frame(), world_frame());
    });
    const std::string name = own_name.empty() ? reference.name() : own_name;
    for (const auto& [taken, other] : request.forces_in)
      if (taken == name &&
          (other.rotation != reference.rotation || other.quadric || reference.quadric))
        entry.refuse("two references have the name " + in_quotes(name) +
                     "; wanted an object with a different key for each reference");
    request.forces_in.emplace_back(name, reference);
  };
  const bool is_reference = reader.has("origin") || reader.has("axes") || reader.has("surface") ||
                            reader.has("local") || reader.has("near");
  if (reader.is_list()) {
    for (const Reader& entry : reader.entries()) add("", entry);
  } else if (reader.is_map() && !is_reference) {
    for (const auto& [name, entry] : reader.items()) add(name, entry);
  } else {
    add("", reader);
  }
}

/// Returns the evaluation whose forces are reported. It is `forward` if requested, or else
/// `inverse` if requested, or else an additional `forward`. Throws Error if the request wants
/// forces for a motion that it does not evaluate.
std::string forces_of(const EvalRequest& request, const Reader& reader) {
  const auto wants = [&](const char* word) { return request.compute.contains(word); };
  if (!wants("forces")) return "";
  if (wants("forward") || wants("forward_derivatives")) return "forward";
  if (wants("inverse") || wants("inverse_derivatives")) return "inverse";
  const std::string wanted =
      "; wanted \"inverse\" in compute for the forces that a and lambda require, or \"forward\" "
      "for the forces that tau causes";
  if (wants("acceleration") || wants("acceleration_derivatives"))
    reader.refuse("\"compute\" lists \"forces\", which \"acceleration\" does not compute" + wanted);
  const auto states = reader.find("states");
  if (!states || !states->is_list()) return "forward";
  for (const Reader& state : states->entries())
    for (const char* key : {"a", "lambda"})
      if (state.has(key))
        state[key].refuse(
            std::string("it is given, but \"forces\" in compute does not depend on it") + wanted);
  return "forward";
}

void read_states(const Reader& states, const StateSpace& space, RequestCache& shared,
                 EvalRequest& request) {
  // Largest memory for the states of all requests [bytes]; chosen by hand. All these states are in
  // memory at once.
  constexpr std::size_t megabyte = 1'000'000, max_bytes = 400 * megabyte;
  shared.state_bytes +=
      states.size() * bytes_of_state(request.robot.model, space.contact_rows.size());
  if (shared.state_bytes > max_bytes) {
    states.refuse(
        fmt::format("its {} states, together with the states of earlier requests, need {} MB of "
                    "memory; wanted at most {} MB",
                    states.size(), shared.state_bytes / megabyte, max_bytes / megabyte));
  }
  for (const Reader& entry : states.entries()) request.states.push_back(read_state(entry, space));
}

/// Reads and checks a complete request, before anything is computed.
EvalRequest read_request(const Reader& reader, RequestCache& shared) {
  reader.allow_only({"robot", "base", "lock", "free", "lock_posture", "strict", "frames", "gravity",
                     "payload", "states", "contacts", "solver", "compute", "forces_in"});
  EvalRequest request;
  request.robot = read_robot(reader, shared);
  const Reader robot = reader["robot"];
  request.robot_name = robot.is_map() ? robot["name"].text() : robot.text();
  Model& model = request.robot.model;
  if (const auto frames = reader.find("frames")) add_frames(*frames, model);
  if (const auto gravity = reader.find("gravity")) model.gravity = gravity->vector3();
  if (const auto payload = reader.find("payload"))
    model = payload->named([&] { return with_payload(std::move(model), read_payload(*payload)); });
  if (const auto solver = reader.find("solver"))
    request.solver = files::read_contact_solver(*solver);
  const auto compute = reader.find("compute");
  request.compute = compute ? read_compute(*compute) : std::set<std::string>{"forward"};
  if (const auto forces_in = reader.find("forces_in")) {
    read_forces_in(*forces_in, request);
    request.compute.insert("forces");
  }
  request.forces_of = forces_of(request, reader);
  StateSpace space{request.robot, request.robot.reference_configuration(), {}, {}};
  if (const auto strict = reader.find("strict")) space.strict = strict->yes_or_no();
  const auto states = reader.find("states");
  if (const auto contacts = reader.find("contacts")) {
    const bool some = states && states->is_list() && states->size() > 0;
    read_contacts(*contacts, some ? read_q(states->entries().front(), space) : space.q, request);
  }
  request.contacts = reader.named([&] { return with_loops(model, request.contacts); });
  if (compute && request.compute.contains("loop_inverse") && model.loops.empty())
    compute->refuse("compute lists loop_inverse, but robot " + in_quotes(model.name) +
                    " has no loops; wanted \"inverse\"");
  const ContactSet set(model, request.contacts);
  std::vector<std::string> v_names;
  for (int k = 0; k < model.nv; ++k) v_names.push_back(model.v_name(k));
  space.v_rows = rows_named(v_names);
  space.contact_rows = rows_named(set.row_names());
  if (states)
    read_states(*states, space, shared, request);
  else
    request.states.push_back(read_state(Reader({.kind = document::Kind::Map}, ""), space));
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
                                              "loop_inverse",
                                              "acceleration",
                                              "acceleration_derivatives",
                                              "forces",
                                              "frames",
                                              "diagnosis"};
  return words;
}

EvalRequests read_requests(const std::string& text, const std::string& source,
                           const fs::path& folder) {
  const Reader reader = Reader::parse_json(text, source);
  EvalRequests result;
  RequestCache shared{folder};
  result.is_list = reader.is_list();
  constexpr std::size_t max_requests = 1000;  // chosen by hand; each may load a robot
  if (result.is_list && reader.size() > max_requests) {
    reader.refuse(fmt::format(
        "the list has {} requests; wanted at most {} (each request may have many states)",
        reader.size(), max_requests));
  }
  const std::vector<Reader> entries = result.is_list ? reader.entries() : std::vector{reader};
  for (const Reader& entry : entries)
    result.requests.push_back(entry.named([&] { return read_request(entry, shared); }));
  return result;
}

}  // namespace burnish::app
