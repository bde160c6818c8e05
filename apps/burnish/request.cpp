#include "request.hpp"

#include <fmt/format.h>

#include <map>

#include "base/sentence.hpp"
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

Robot read_robot(const Reader& reader, Shared& shared) {
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
    const Frame& on = model.frames[static_cast<std::size_t>(index)];
    frame.body = on.body;
    frame.placement = on.placement * placement;
    model.frames.push_back(frame);
  }
}

/// The robot of the states to read, the names of their entries, and the state that states nothing.
struct StateSpace {
  const Robot& robot;
  Eigen::VectorXd q;
  std::vector<files::RowGroup> v_rows, contact_rows;
  bool strict = false;  ///< refuse states about which something is odd
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

/// Every word of a list, or the only one.
std::set<std::string> read_compute(const Reader& reader) {
  std::set<std::string> wanted;
  if (!reader.is_list()) return {reader.word(computable())};
  for (const Reader& entry : reader.entries()) wanted.insert(entry.word(computable()));
  return wanted;
}

/// A contact without a target has it where the tool stands in the first state, as everywhere. Up to
/// version 0.2 it was the identity: where that makes a difference, it has to be said.
void read_contacts(const Reader& reader, const Eigen::VectorXd& q, EvalRequest& request) {
  for (const auto& [name, entry] : files::contacts_in(reader)) {
    const ContactSpec spec = files::read_contact(name, entry, request.robot.model, q);
    const bool pulls = !spec.kp.isZero(0.0);
    if (!entry.has("target") && (pulls || request.compute.contains("contact_error")))
      entry.refuse(std::string("key 'target' is missing, and ") +
                   (pulls ? "kp is not 0" : "its contact_error is asked for") +
                   "; wanted \"target\": \"here\" for where the tool stands in the first state, or "
                   "\"target\": {\"xyz\": [0, 0, 0]} for the frame 'base', as up to version 0.2");
    request.contacts.push_back(spec);
  }
}

/// A reference, a list of them, each called what it is, or an object of them by names of their own.
void read_forces_in(const Reader& reader, EvalRequest& request) {
  const auto add = [&](const std::string& own_name, const Reader& entry) {
    const Reference reference = files::read_reference(entry);
    entry.named([&] {  // frames that there are
      return compile_reference(request.robot.model, reference, world_frame(), world_frame());
    });
    const std::string name = own_name.empty() ? reference.name() : own_name;
    for (const auto& [taken, other] : request.forces_in)
      if (taken == name &&
          (other.rotation != reference.rotation || other.quadric || reference.quadric))
        entry.refuse("two references are called " + in_quotes(name) +
                     "; wanted an object of references by names of their own");
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

/// Returns the evaluation that forces belong to: `forward` if it is requested, else `inverse`, else
/// a `forward` of their own. Refuses forces of a motion that is not the requested one.
std::string forces_of(const EvalRequest& request, const Reader& reader) {
  const auto wants = [&](const char* word) { return request.compute.contains(word); };
  if (!wants("forces")) return "";
  if (wants("forward") || wants("forward_derivatives")) return "forward";
  if (wants("inverse") || wants("inverse_derivatives")) return "inverse";
  const std::string wanted =
      "; wanted \"inverse\" in compute for the forces of a and lambda, or \"forward\" for those of "
      "tau";
  if (wants("acceleration") || wants("acceleration_derivatives"))
    reader.refuse("compute asks for forces beside an acceleration, which has none" + wanted);
  const auto states = reader.find("states");
  if (!states || !states->is_list()) return "forward";
  for (const Reader& state : states->entries())
    for (const char* key : {"a", "lambda"})
      if (state.has(key))
        state[key].refuse(std::string("it is stated, and compute asks for forces alone, which do "
                                      "not use it") +
                          wanted);
  return "forward";
}

void read_states(const Reader& states, const StateSpace& space, Shared& shared,
                 EvalRequest& request) {
  constexpr std::size_t megabyte = 1'000'000, most = 400 * megabyte;  // all are in memory at once
  shared.state_bytes +=
      states.size() * bytes_of_state(request.robot.model, space.contact_rows.size());
  if (shared.state_bytes > most) {
    states.refuse(fmt::format(
        "its {} states and those before them take {} MB of memory; at most {} MB are read at once",
        states.size(), shared.state_bytes / megabyte, most / megabyte));
  }
  for (const Reader& entry : states.entries()) request.states.push_back(read_state(entry, space));
}

/// Everything is read and checked before anything is computed.
EvalRequest read_request(const Reader& reader, Shared& shared) {
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
    compute->refuse("it asks for loop_inverse, and robot " + in_quotes(model.name) +
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
  Shared shared{folder};
  result.is_list = reader.is_list();
  // All robots are in memory at once.
  constexpr std::size_t most = 1000;
  if (result.is_list && reader.size() > most) {
    reader.refuse(fmt::format(
        "it has {} requests; at most {} are answered at once, and each may have many states",
        reader.size(), most));
  }
  const std::vector<Reader> entries = result.is_list ? reader.entries() : std::vector{reader};
  for (const Reader& entry : entries)
    result.requests.push_back(entry.named([&] { return read_request(entry, shared); }));
  return result;
}

}  // namespace burnish::app
