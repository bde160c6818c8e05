#include "loop_parts.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/sentence.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::python {

namespace {

/// Status of a call that raised an exception.
constexpr Status failed = Status::NotEvaluated;

std::string type_of(const py::object& object) {
  return py::cast<std::string>(py::type::of(object).attr("__name__"));
}

/// Returns true if the object or its class declares the attribute, without evaluating properties.
bool declares(const py::object& object, const char* name) {
  const py::object find = py::module_::import("inspect").attr("getattr_static");
  return !find(object, name, py::none()).is_none();
}

/// Returns true if the object has the attribute. A property that raises an exception counts as
/// present, so that reading it shows the exception.
bool has(const py::object& object, const char* name) {
  return declares(object, name) || py::hasattr(object, name);
}

/// Returns an attribute of an object. Throws Error if the object lacks the attribute.
py::object attribute(const py::object& object, const char* kind, const char* name) {
  try {
    return object.attr(name);
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_AttributeError) || declares(object, name)) throw;
    throw Error(std::string(kind) + ": " + type_of(object) + " has no '" + name +
                "'; wanted an object with the attributes of burnish." + kind);
  }
}

template <class Value>
Value read(const py::object& object, const char* kind, const char* name) {
  const py::object value = attribute(object, kind, name);
  py::detail::make_caster<Value> caster;
  if (!caster.load(value, true))
    throw Error(std::string(kind) + "." + name + ": got " + py::cast<std::string>(py::repr(value)) +
                "; wanted " + wanted<Value>());
  return py::detail::cast_op<Value&>(caster);
}

/// Reads the wrenches on the touches (tools and feet) of a scene, one per column.
Wrenches read_wrenches(const py::object& object, const char* kind, Eigen::Index touches) {
  const Eigen::MatrixXd values = read<Eigen::MatrixXd>(object, kind, "wrenches");
  if (values.rows() != 6 || values.cols() != touches)
    throw Error(std::string(kind) + ".wrenches: got " + std::to_string(values.rows()) + " x " +
                std::to_string(values.cols()) + " numbers; wanted 6 x " + std::to_string(touches) +
                ", one column per touch of the scene");
  return values;
}

Eigen::VectorXd read_vector(const py::object& object, const char* kind, const char* name,
                            Eigen::Index size) {
  Eigen::VectorXd values = read<Eigen::VectorXd>(object, kind, name);
  if (values.size() != size)
    throw Error(std::string(kind) + "." + name + ": got " + std::to_string(values.size()) +
                " numbers; wanted " + std::to_string(size));
  return values;
}

py::array_t<double> array_of(const Eigen::Ref<const Eigen::VectorXd>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace

BoundMpc::BoundMpc(const MpcSpec& spec)
    : BoundController(std::make_unique<MpcController>(spec)),
      spec_(spec),
      mpc_(static_cast<MpcController*>(controller.get())) {}

PressingPath guarded(PressingPath path, const std::shared_ptr<KeptException>& kept) {
  if (!path.task) return path;
  path.task = [task = std::move(path.task), kept, last = TaskPoint{}](double t) mutable {
    try {
      last = task(t);
    } catch (...) {
      kept->keep();
    }
    return last;
  };
  return path;
}

/// Calls a Python plant and copies its state; stores exceptions.
class PlantPart::Adaptor final : public Plant {
 public:
  explicit Adaptor(const py::object& plant)
      : object_(plant),
        model_(read<Model>(plant, "Plant", "model")),
        dt_(read<double>(plant, "Plant", "dt")),
        q_(model_.q_neutral),
        v_(Eigen::VectorXd::Zero(model_.nv)),
        friction_(v_) {
    for (const char* name : {"reset", "step"}) (void)attribute(plant, "Plant", name);
    const bool has_scene = py::hasattr(plant, "scene");
    scene_ =
        checked_scene(model_, has_scene ? read<SceneSpec>(plant, "Plant", "scene") : SceneSpec{});
    wrenches_.setZero(6, static_cast<Eigen::Index>(scene_.touches.size()));
    if (!(dt_ > 0.0))
      throw Error("Plant.dt: got " + std::to_string(dt_) + "; wanted a time above 0 s");
    (void)has_wrenches();
  }

  const Model& model() const override { return model_; }
  const SceneSpec& scene() const override { return scene_; }
  double dt() const override { return dt_; }
  double time() const override { return time_; }
  const Eigen::VectorXd& q() const override { return q_; }
  const Eigen::VectorXd& v() const override { return v_; }
  const Wrenches& wrenches() const override { return wrenches_; }
  const Eigen::VectorXd& friction_torque() const override { return friction_; }

  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept override {
    return guarded([&] {
      const py::object answer = object_.attr("reset")(array_of(q), array_of(v));
      has_time_ = py::hasattr(object_, "time");
      has_wrenches_ = has_wrenches();
      has_friction_ = py::hasattr(object_, "friction_torque");
      return take(answer, 0.0);
    });
  }

  Status step(const ConstVectorRef& tau) noexcept override {
    return guarded([&] { return take(object_.attr("step")(array_of(tau)), time_ + dt_); });
  }

  void save(PlantSnapshot& /*snapshot*/) const override {
    throw Error("Plant.save: this is a plant in Python; call its own method save()");
  }
  Status restore(const PlantSnapshot& /*snapshot*/) noexcept override { return Status::WrongSize; }

  KeptException kept;

 private:
  template <class Call>
  Status guarded(Call&& call) noexcept {
    try {
      const py::gil_scoped_acquire lock;
      return call();
    } catch (...) {
      kept.keep();
      return failed;
    }
  }

  /// Returns whether the object has wrenches. Throws Error for an object that has only the contact
  /// force of earlier versions.
  bool has_wrenches() const {
    if (py::hasattr(object_, "wrenches")) return true;
    if (py::hasattr(object_, "contact_force_world"))
      throw Error("Plant: " + type_of(object_) +
                  " has 'contact_force_world'; wanted 'wrenches' of shape (6, touches): the wrench "
                  "on each touch of the scene, in the axes of the frame of the touch");
    return false;
  }

  /// Reads the return value of a call, and the state of the plant after the call.
  Status take(const py::object& answer, double time) {
    const auto status = answer.is_none() ? Status::Ok : py::cast<Status>(answer);
    if (!is_usable(status)) return status;
    const Eigen::VectorXd q = read_vector(object_, "Plant", "q", model_.nq);
    const Eigen::VectorXd v = read_vector(object_, "Plant", "v", model_.nv);
    if (!q.allFinite() || !v.allFinite()) return Status::NotFinite;
    if (has_wrenches_) wrenches_ = read_wrenches(object_, "Plant", wrenches_.cols());
    if (has_friction_) friction_ = read_vector(object_, "Plant", "friction_torque", model_.nv);
    time_ = has_time_ ? read<double>(object_, "Plant", "time") : time;
    q_ = q;
    v_ = v;
    return status;
  }

  py::object object_;
  Model model_;
  SceneSpec scene_;
  double dt_, time_ = 0.0;
  Eigen::VectorXd q_, v_;
  Wrenches wrenches_;
  Eigen::VectorXd friction_;
  bool has_time_ = false, has_wrenches_ = false, has_friction_ = false;
};

PlantPart::PlantPart(py::object plant) : object_(std::move(plant)) {
  if (py::isinstance<BoundPlant>(object_)) {
    bound_ = &py::cast<BoundPlant&>(object_);
    plant_ = bound_->plant.get();
  } else {
    adaptor_ = std::make_unique<Adaptor>(object_);
    plant_ = adaptor_.get();
  }
}
PlantPart::~PlantPart() = default;

std::exception_ptr PlantPart::take_exception() noexcept {
  return adaptor_ ? adaptor_->kept.take() : nullptr;
}

std::optional<Busy::Lock> PlantPart::lock(const char* what) const {
  if (bound_ == nullptr) return std::nullopt;
  return std::optional<Busy::Lock>(std::in_place, bound_->busy, what);
}

class ControllerPart::Adaptor final : public Controller {
 public:
  explicit Adaptor(const py::object& controller)
      : object_(controller), nv_(read<int>(controller, "Controller", "nv")) {
    for (const char* name : {"reset", "tick"}) (void)attribute(controller, "Controller", name);
    if (nv_ < 0) throw Error("Controller.nv: got " + std::to_string(nv_) + "; wanted at least 0");
    command_.tau = Eigen::VectorXd::Zero(nv_);
    using Units = std::map<std::string, std::string>;
    if (has(controller, "signals"))
      for (const auto& [name, unit] : read<Units>(controller, "Controller", "signals"))
        signals_.push_back({name, unit});
    if (!signals_.empty()) (void)attribute(controller, "Controller", "signal_values");
    values_.resize(signals_.size());
    if (has(controller, "tools"))
      tools_ = read<std::vector<std::string>>(controller, "Controller", "tools");
    if (!has(controller, "touches")) return;
    using Frames = std::optional<std::vector<std::string>>;
    if (const Frames frames = read<Frames>(controller, "Controller", "touches"))
      for (touches_.emplace(); const std::string& frame : *frames) touches_->push_back({frame});
  }

  int nv() const override { return nv_; }
  std::optional<std::vector<TouchSensor>> touches() const override { return touches_; }
  std::vector<std::string> tools() const override { return tools_; }
  std::vector<TraceColumn> signals() const override { return signals_; }
  void write_signals(std::span<double> values) const noexcept override {
    std::copy(values_.begin(), values_.end(), values.begin());
  }

  void reset() noexcept override {
    try {
      command_ = Command{Eigen::VectorXd::Zero(nv_)};
      const py::gil_scoped_acquire lock;
      object_.attr("reset")();
    } catch (...) {
      kept.keep();
    }
  }

  const Command& tick(const Measurement& measurement) noexcept override {
    try {
      const py::gil_scoped_acquire lock;
      take(object_.attr("tick")(measurement));
      take_signals();
    } catch (...) {
      kept.keep();
      command_.status = failed;
    }
    return command_;
  }

  KeptException kept;

 private:
  /// Reads a Command, or only its torque.
  void take(const py::object& answer) {
    Command command;
    py::detail::make_caster<Command> whole;
    py::detail::make_caster<Eigen::VectorXd> torque;
    if (whole.load(answer, true)) {
      command = py::detail::cast_op<Command&>(whole);
    } else if (!answer.is_none() && torque.load(answer, true)) {
      command.tau = py::detail::cast_op<Eigen::VectorXd&>(torque);
    } else {
      throw Error("Controller.tick: got " + py::cast<std::string>(py::repr(answer)) +
                  "; wanted a Command, or only its torques");
    }
    if (command.tau.size() != nv_)
      throw Error("Controller.tick: the torque has " + std::to_string(command.tau.size()) +
                  " entries; wanted " + std::to_string(nv_));
    command_ = command;
  }

  /// Reads the values of all signals.
  void take_signals() {
    if (signals_.empty()) return;
    using Values = std::map<std::string, double>;
    const Values values = read<Values>(object_, "Controller", "signal_values");
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      const auto at = values.find(signals_[i].name);
      if (at == values.end())
        throw Error("Controller.signal_values: got no value for signal " +
                    in_quotes(signals_[i].name) + "; wanted one for each entry of 'signals'");
      values_[i] = at->second;
    }
  }

  py::object object_;
  int nv_;
  std::vector<TraceColumn> signals_;
  std::vector<double> values_;  ///< Values of signals_ at the last tick.
  std::optional<std::vector<TouchSensor>> touches_;
  std::vector<std::string> tools_;
  Command command_;
};

ControllerPart::ControllerPart(py::object controller) : object_(std::move(controller)) {
  if (py::isinstance<BoundController>(object_)) {
    bound_ = &py::cast<BoundController&>(object_);
    controller_ = bound_->controller.get();
  } else {
    adaptor_ = std::make_unique<Adaptor>(object_);
    controller_ = adaptor_.get();
  }
}
ControllerPart::~ControllerPart() = default;

std::exception_ptr ControllerPart::take_exception() noexcept {
  return adaptor_ ? adaptor_->kept.take() : bound_->take_exception();
}

std::optional<Busy::Lock> ControllerPart::lock(const char* what) const {
  if (bound_ == nullptr) return std::nullopt;
  return std::optional<Busy::Lock>(std::in_place, bound_->busy, what);
}

}  // namespace burnish::python
