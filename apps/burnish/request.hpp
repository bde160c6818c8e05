// A request of `burnish eval`: docs/eval.md as plain values.
#pragma once

#include <filesystem>
#include <set>

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/robots/robot.hpp"

namespace burnish::app {

struct EvalState {
  Eigen::VectorXd q, v, tau, a;            ///< nq, nv, nv, nv
  Eigen::VectorXd lambda;                  ///< rows of all contacts
  std::vector<std::string> warnings = {};  ///< what is odd about it, one sentence each
};

struct EvalRequest {
  std::string robot_name;
  Robot robot;
  std::vector<ContactSpec> contacts;
  ContactSolver solver;
  std::vector<EvalState> states;
  std::set<std::string> compute;
  std::string forces_of;  ///< "forward" or "inverse": what `forces` belong to; empty without them
  std::vector<std::pair<std::string, Reference>> forces_in;  ///< by what they are called
};

/// What a file asks for: one request, or a list of them.
struct EvalRequests {
  std::vector<EvalRequest> requests;
  bool is_list = false;
};

/// Reads and checks everything, so that nothing is refused after the first state was evaluated.
/// `source` stands for the text's name in error sentences. A robot's path is looked up beside the
/// file in `folder` first, then where the program runs.
EvalRequests read_requests(const std::string& text, const std::string& source,
                           const std::filesystem::path& folder);

/// What `compute` may ask for.
const std::vector<std::string>& computable();

}  // namespace burnish::app
