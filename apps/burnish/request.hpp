// Requests of `burnish eval` as plain data; docs/eval.md describes requests.
#pragma once

#include <filesystem>
#include <set>

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/robots/robot.hpp"

namespace burnish::app {

struct EvalState {
  Eigen::VectorXd q, v, tau, a;            ///< Vectors with nq, nv, nv and nv entries.
  Eigen::VectorXd lambda;                  ///< Contact forces, one entry per row of all contacts.
  std::vector<std::string> warnings = {};  ///< Warnings about the state, one sentence each.
};

struct EvalRequest {
  std::string robot_name;
  Robot robot;
  std::vector<ContactSpec> contacts;
  ContactSolver solver;
  std::vector<EvalState> states;
  std::set<std::string> compute;
  /// Evaluation that gives `forces`: "forward" or "inverse"; empty without forces.
  std::string forces_of;
  /// Reference frames in which forces are expressed, by name.
  std::vector<std::pair<std::string, Reference>> forces_in;
};

/// Contents of a request file: one request or a list of requests.
struct EvalRequests {
  std::vector<EvalRequest> requests;
  bool is_list = false;
};

/// Reads and checks all requests, so that errors are found before the first evaluation. `source`:
/// name of the text in messages. Relative paths of robots are searched in `folder`, then in the
/// working folder.
EvalRequests read_requests(const std::string& text, const std::string& source,
                           const std::filesystem::path& folder);

/// Returns the words that the key `compute` may list.
const std::vector<std::string>& computable();

}  // namespace burnish::app
