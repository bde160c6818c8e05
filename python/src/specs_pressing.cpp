#include "specs_pressing.hpp"

#include "task_run.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<PlanArrays>::table() {
  static const SpecTable fields = SpecTable("burnish.pressing", "PlanRecord")
                                      .field("time", &PlanArrays::time)
                                      .field("terms", &PlanArrays::terms)
                                      .field("costs", &PlanArrays::costs)
                                      .field("step", &PlanArrays::step)
                                      .field("q", &PlanArrays::q)
                                      .field("x", &PlanArrays::x)
                                      .field("u", &PlanArrays::u)
                                      .field("K", &PlanArrays::K)
                                      .field("Vx", &PlanArrays::Vx)
                                      .field("Vxx", &PlanArrays::Vxx);
  return fields;
}

namespace {

/// Array with the dimensions plans x columns.
RowMatrix matrix_of(const std::vector<double>& values, Eigen::Index plans, int columns) {
  return Eigen::Map<const RowMatrix>(values.data(), plans, columns);
}
/// Array with the dimensions plans x rows x columns.
template <class T>
PlanCube<T> cube_of(const std::vector<T>& values, Eigen::Index plans, int rows, int columns) {
  return {py::array_t<T>({static_cast<py::ssize_t>(plans), py::ssize_t{rows}, py::ssize_t{columns}},
                         values.data())};
}
std::vector<double> values_of(const RowMatrix& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}
template <class T>
std::vector<T> values_of(const PlanCube<T>& cube) {
  return {cube.array.data(), cube.array.data() + cube.array.size()};
}

}  // namespace

PlanArrays arrays_of(const PlanRecord& record) {
  const auto plans = static_cast<Eigen::Index>(record.time.size());
  const PlanStart& start = record.start;
  PlanArrays arrays{.time = Eigen::Map<const Eigen::VectorXd>(record.time.data(), plans),
                    .terms = record.terms,
                    .costs = RowMatrix(static_cast<Eigen::Index>(record.terms.size()), plans),
                    .step = record.step,
                    .q = cube_of(record.q, plans, record.knots, record.nq),
                    .x = matrix_of(start.x, plans, start.nx),
                    .u = matrix_of(start.u, plans, start.nu),
                    .K = cube_of(start.K, plans, start.nu, start.ndx),
                    .Vx = matrix_of(start.Vx, plans, start.ndx),
                    .Vxx = cube_of(start.Vxx, plans, start.ndx, start.ndx)};
  for (std::size_t term = 0; term < record.terms.size(); ++term)
    arrays.costs.row(static_cast<Eigen::Index>(term)) =
        Eigen::Map<const Eigen::RowVectorXd>(record.costs[term].data(), plans);
  return arrays;
}

PlanRecord record_of(const PlanArrays& arrays) {
  const py::array_t<float>& q = arrays.q.array;
  PlanRecord record;
  record.time = {arrays.time.begin(), arrays.time.end()};
  record.terms = arrays.terms;
  record.knots = static_cast<int>(q.shape(1));
  record.nq = static_cast<int>(q.shape(2));
  record.step = arrays.step;
  record.q = values_of(arrays.q);
  record.start = {.nx = static_cast<int>(arrays.x.cols()),
                  .ndx = static_cast<int>(arrays.Vx.cols()),
                  .nu = static_cast<int>(arrays.u.cols()),
                  .x = values_of(arrays.x),
                  .u = values_of(arrays.u),
                  .K = values_of(arrays.K),
                  .Vx = values_of(arrays.Vx),
                  .Vxx = values_of(arrays.Vxx)};
  for (const auto& row : arrays.costs.rowwise()) record.costs.emplace_back(row.begin(), row.end());
  return record;
}

py::object progress_of(const py::object& spec, const char* what, const char* module,
                       const char* wanted) {
  if (!py::isinstance(spec, py::module_::import(module).attr(wanted)))
    throw py::type_error(std::string(what) + ": wanted a " + wanted);
  return spec.attr("progress");
}

py::tuple state_of(const TaskRun& run) {
  return py::make_tuple(run.trace, arrays_of(run.plans), run.plant_status, run.fault,
                        run.interrupted, run.succeeded, run.ticks, run.first_tick, run.wall_time,
                        run.outcome, run.standing);
}

void set_state(TaskRun& run, const py::tuple& state) {
  std::size_t next = 0;
  const auto take = [&](auto& entry) {
    entry = py::cast<std::decay_t<decltype(entry)>>(state[next++]);
  };
  take(run.trace);
  PlanArrays plans;
  take(plans);
  run.plans = record_of(plans);
  take(run.plant_status);
  take(run.fault);
  take(run.interrupted);
  take(run.succeeded);
  take(run.ticks);
  take(run.first_tick);
  take(run.wall_time);
  take(run.outcome);
  take(run.standing);
}

}  // namespace burnish::python
