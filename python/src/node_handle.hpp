// View of a knot for residuals in Python, valid only during a call.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/ocp/node_view.hpp"
#include "burnish/ocp/residual.hpp"
#include "spec.hpp"

namespace burnish::python {

/// Python object with a view of a knot. Once the receiving call has ended, view() throws Error.
class NodeHandle {
 public:
  NodeHandle(const NodeView& view, const residual::Custom& names, bool with_derivatives)
      : view_(&view), names_(&names), with_derivatives_(with_derivatives) {}

  const NodeView& view() const {
    if (view_ == nullptr)
      throw Error(
          "NodeView: a view is used after the call that received it; wanted a copy of the values");
    return *view_;
  }
  bool with_derivatives() const { return with_derivatives_; }
  void end() { view_ = nullptr; }

  using Place = std::variant<int, std::string>;
  /// Return the index of a frame or contact, given by name or by index in the lists of the
  /// residual. Throw Error for an unknown name or index.
  int frame(const Place& at) const { return place(at, "frame", &residual::Custom::frames); }
  int contact(const Place& at) const { return place(at, "contact", &residual::Custom::contacts); }

 private:
  int place(const Place& at, const char* what,
            std::vector<std::string> residual::Custom::*list) const {
    view();  // throws if the call has ended; the names are then invalid too
    const std::vector<std::string>& known = names_->*list;
    const std::string who = "residual '" + names_->name + "': ";
    if (const int* index = std::get_if<int>(&at)) {
      if (*index < 0 || *index >= static_cast<int>(known.size()))
        throw Error(who + "there is no " + what + " " + std::to_string(*index) +
                    "; the number of declared " + what + "s is " + std::to_string(known.size()));
      return *index;
    }
    const auto& name = std::get<std::string>(at);
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw Error(who + "it does not declare the " + what + " '" + name + "'" +
                  did_you_mean(name, known));
    return static_cast<int>(found - known.begin());
  }

  const NodeView* view_;
  const residual::Custom* names_;
  bool with_derivatives_;
};

/// Lends a view to Python for the lifetime of this object. Must be used with the GIL.
class NodeLease {
 public:
  NodeLease(const NodeView& view, const residual::Custom& names, bool with_derivatives)
      : handle_(std::make_shared<NodeHandle>(view, names, with_derivatives)) {}
  ~NodeLease() { handle_->end(); }
  NodeLease(const NodeLease&) = delete;
  NodeLease& operator=(const NodeLease&) = delete;

  py::object object() const { return py::cast(handle_); }

 private:
  std::shared_ptr<NodeHandle> handle_;
};

}  // namespace burnish::python
