// Plants and controllers as Python has them: the library's, and adaptors for those that are written
// in Python.
#pragma once

#include <exception>
#include <memory>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/plant.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"
#include "callback.hpp"
#include "machine.hpp"
#include "specs_sim.hpp"

namespace burnish::python {

/// What was thrown where nothing may be: the first exception, until it is taken.
class KeptException {
 public:
  /// Within a handler.
  void keep() noexcept {
    if (!first_) first_ = std::current_exception();
  }
  std::exception_ptr take() noexcept { return std::exchange(first_, nullptr); }

 private:
  std::exception_ptr first_;
};

/// A plant of the library.
struct BoundPlant {
  explicit BoundPlant(std::unique_ptr<Plant> made) : plant(std::move(made)) {}
  std::unique_ptr<Plant> plant;
  Busy busy;
};

/// A controller of the library.
class BoundController {
 public:
  explicit BoundController(std::unique_ptr<Controller> made) : controller(std::move(made)) {}
  BoundController(const BoundController&) = delete;
  BoundController& operator=(const BoundController&) = delete;
  virtual ~BoundController() = default;
  /// What functions of its specification threw since this was asked last.
  virtual std::exception_ptr take_exception() noexcept { return nullptr; }

  std::unique_ptr<Controller> controller;
  Busy busy;
};

class BoundMpc final : public BoundController {
 public:
  explicit BoundMpc(const MpcSpec& spec);
  MpcController& mpc() const { return *mpc_; }
  const MpcSpec& spec() const { return spec_; }
  std::exception_ptr take_exception() noexcept override { return mpc_->take_exception(); }

 private:
  MpcSpec spec_;
  MpcController* mpc_;
};

/// A controller that presses along a path; a task that throws leaves it with the point before.
class BoundPressing final : public BoundController {
 public:
  BoundPressing(std::unique_ptr<Controller> made, std::shared_ptr<KeptException> kept)
      : BoundController(std::move(made)), kept_(std::move(kept)) {}
  std::exception_ptr take_exception() noexcept override { return kept_->take(); }

 private:
  std::shared_ptr<KeptException> kept_;
};

/// The path with a task that keeps what it throws.
PressingPath guarded(PressingPath path, const std::shared_ptr<KeptException>& kept);

/// `Spec` has a PressingPath.
template <class Spec>
std::unique_ptr<BoundController> bound(const Model& model, Spec spec,
                                       std::unique_ptr<Controller> (*make)(const Model&,
                                                                           const Spec&)) {
  const auto kept = std::make_shared<KeptException>();
  spec.path = guarded(std::move(spec.path), kept);
  return std::make_unique<BoundPressing>(make(model, spec), kept);
}

/// A plant for a loop: the library's own, or an adaptor to an object of Python with the attributes
/// of burnish.Plant. Made with the interpreter's lock; its plant may be used without.
class PlantPart {
 public:
  /// Throws Error for an object that lacks something.
  explicit PlantPart(py::object plant);
  ~PlantPart();
  PlantPart(const PlantPart&) = delete;
  PlantPart& operator=(const PlantPart&) = delete;

  Plant& plant() const { return *plant_; }
  const py::object& object() const { return object_; }
  /// What Python threw in a reset or a step since this was asked last.
  std::exception_ptr take_exception() noexcept;
  /// Its lock while it is driven, if it is one of the library's.
  std::optional<Busy::Lock> lock(const char* what) const;

 private:
  class Adaptor;
  py::object object_;
  BoundPlant* bound_ = nullptr;
  std::unique_ptr<Adaptor> adaptor_;
  Plant* plant_ = nullptr;
};

/// The same for a controller.
class ControllerPart {
 public:
  explicit ControllerPart(py::object controller);
  ~ControllerPart();
  ControllerPart(const ControllerPart&) = delete;
  ControllerPart& operator=(const ControllerPart&) = delete;

  Controller& controller() const { return *controller_; }
  const py::object& object() const { return object_; }
  std::exception_ptr take_exception() noexcept;
  std::optional<Busy::Lock> lock(const char* what) const;

 private:
  class Adaptor;
  py::object object_;
  BoundController* bound_ = nullptr;
  std::unique_ptr<Adaptor> adaptor_;
  Controller* controller_ = nullptr;
};

}  // namespace burnish::python
