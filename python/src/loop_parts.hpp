// Plants and controllers for Python: those of the library, and adaptors for Python objects.
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

/// Stores the first exception of noexcept code until it is taken.
class KeptException {
 public:
  /// Must be called in an exception handler.
  void keep() noexcept {
    if (!first_) first_ = std::current_exception();
  }
  std::exception_ptr take() noexcept { return std::exchange(first_, nullptr); }

 private:
  std::exception_ptr first_;
};

/// Plant of the library.
struct BoundPlant {
  explicit BoundPlant(std::unique_ptr<Plant> made) : plant(std::move(made)) {}
  std::unique_ptr<Plant> plant;
  Busy busy;
};

/// Controller of the library.
class BoundController {
 public:
  explicit BoundController(std::unique_ptr<Controller> made) : controller(std::move(made)) {}
  BoundController(const BoundController&) = delete;
  BoundController& operator=(const BoundController&) = delete;
  virtual ~BoundController() = default;
  /// Returns and clears the exception that functions of the specification have thrown.
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

/// Controller that presses along a path. If the function PressingPath::task throws, the controller
/// uses the previous result of the function.
class BoundPressing final : public BoundController {
 public:
  BoundPressing(std::unique_ptr<Controller> made, std::shared_ptr<KeptException> kept)
      : BoundController(std::move(made)), kept_(std::move(kept)) {}
  std::exception_ptr take_exception() noexcept override { return kept_->take(); }

 private:
  std::shared_ptr<KeptException> kept_;
};

/// Returns `path` with a task function that stores exceptions in `kept`.
PressingPath guarded(PressingPath path, const std::shared_ptr<KeptException>& kept);

/// Makes a controller from `spec`, which must have a member `path` of type PressingPath.
template <class Spec>
std::unique_ptr<BoundController> bound(const Model& model, Spec spec,
                                       std::unique_ptr<Controller> (*make)(const Model&,
                                                                           const Spec&)) {
  const auto kept = std::make_shared<KeptException>();
  spec.path = guarded(std::move(spec.path), kept);
  return std::make_unique<BoundPressing>(make(model, spec), kept);
}

/// Plant of a loop: a plant of the library, or an adaptor for a Python object with the attributes
/// of burnish.Plant. The constructor needs the GIL; plant() can be used without the GIL.
class PlantPart {
 public:
  /// Throws Error if the object lacks an attribute.
  explicit PlantPart(py::object plant);
  ~PlantPart();
  PlantPart(const PlantPart&) = delete;
  PlantPart& operator=(const PlantPart&) = delete;

  Plant& plant() const { return *plant_; }
  const py::object& object() const { return object_; }
  /// Returns and clears the exception that Python code has thrown in reset() or step().
  std::exception_ptr take_exception() noexcept;
  /// Returns a lock that a loop holds while it uses a plant of the library. Returns nothing for a
  /// Python plant.
  std::optional<Busy::Lock> lock(const char* what) const;

 private:
  class Adaptor;
  py::object object_;
  BoundPlant* bound_ = nullptr;
  std::unique_ptr<Adaptor> adaptor_;
  Plant* plant_ = nullptr;
};

/// Controller of a loop: a controller of the library, or an adaptor for a Python object.
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
