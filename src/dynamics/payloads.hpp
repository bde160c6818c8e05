// Payloads of a robot, one per body.
#pragma once

#include <string_view>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/model/inertia.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Payloads that were set at frames of a robot. A payload replaces an earlier one of the same body.
class Payloads {
 public:
  explicit Payloads(const Model& model) : model_(model), bodies_(model.joints.size()) {}
  Payloads(const Payloads&) = delete;  // frames are views of model_
  Payloads& operator=(const Payloads&) = delete;

  /// Records a payload, which the dynamics of the same model must already have accepted. Does not
  /// allocate. Throws Error as frame_on_body() does.
  void set(std::string_view frame, const InertiaSpec& payload) {
    const Frame& at = frame_on_body("set_payload", model_, frame);
    bodies_[to_size(at.body)] = {at.name, payload, true};
  }
  double mass() const {  ///< Mass of all payloads [kg].
    double sum = 0.0;
    for (const Body& body : bodies_) sum += body.payload.mass;
    return sum;
  }
  /// Calls visit(frame, payload) with the latest payload of each body whose payload was set since
  /// the last hand_over(). A removed payload has mass 0.
  void hand_over(const auto& visit) {
    for (Body& body : bodies_) {
      if (body.is_new) visit(body.frame, body.payload);
      body.is_new = false;
    }
  }

 private:
  struct Body {
    std::string_view frame;  ///< Name of the frame in model_.
    InertiaSpec payload = {};
    bool is_new = false;
  };
  Model model_;
  std::vector<Body> bodies_;
};

}  // namespace burnish
