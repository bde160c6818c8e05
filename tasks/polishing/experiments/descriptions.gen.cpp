// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "polishing/experiments/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::polishing {

const Description& description_of(const ExperimentSpec* /*of*/) {
  using S = ExperimentSpec;
  static const Description all =
      Describe<S>("polishing", "ExperimentSpec",
                  "Options of an experiment.")
          .field("plant", &S::plant,
                 "Simulator; MUJOCO if this build includes it.")
          .field("seeds", &S::seeds,
                 "Number of seeds, at most 10 000; 0: the experiment's default.")
          .field("first_seed", &S::first_seed,
                 "First seed.")
          .field("threads", &S::threads,
                 "Number of parallel runs; 0: one per core.")
          .field("quick", &S::quick,
                 "Makes few and short runs, to test that the experiment works.")
          .field("surfaces", &S::surfaces,
                 "Surfaces; empty: the experiment's surfaces.")
          .field("ranges", &S::ranges,
                 "Ranges of the experiment `seeds`: usual, wide or curved; empty: usual.")
          .field("robots", &S::robots,
                 "Robots of the experiments `robots` and `force_test`; empty: the experiment's "
                 "robots.")
          .field("tools", &S::tools,
                 "Frames of the tools of `robots`, in order; \"tool\" for robots without an "
                 "entry.")
          .field("folder", &S::folder,
                 "Folder with descriptions of public robots for the experiment `robots`, in place"
                 " of the bundled robots. The list of robots is robots.yaml in the folder, or "
                 "else the bundled list. Empty: none.")
          .field("overrides", &S::overrides,
                 "Changes of the task, in the notation of override_task(); keys that the "
                 "experiment varies are set after them.")
          .field("progress", &S::progress,
                 "Called repeatedly with the completed fraction, 0 to 1, and the current run; "
                 "from one thread at a time, but from different threads. Returning False stops "
                 "the experiment.");
  return all;
}

const Description& description_of(const Figure* /*of*/) {
  using S = Figure;
  static const Description all =
      Describe<S>("polishing", "Figure",
                  "Plot with the name of its file.")
          .result()
          .field("name", &S::name,
                 "Name of the file, without extension.")
          .field("plot", &S::plot);
  return all;
}

const Description& description_of(const NamedTask* /*of*/) {
  using S = NamedTask;
  static const Description all =
      Describe<S>("polishing", "NamedTask",
                  "Task of a notable run, to repeat the run alone.")
          .result()
          .field("name", &S::name,
                 "Name of the file, without extension.")
          .field("task", &S::task);
  return all;
}

const Description& description_of(const ExperimentReport* /*of*/) {
  using S = ExperimentReport;
  static const Description all =
      Describe<S>("polishing", "ExperimentReport",
                  "Results of an experiment.")
          .result()
          .field("title", &S::title)
          .field("tables", &S::tables,
                 "Tables; the first has a row for every run (force_test: for every figure and "
                 "controller).")
          .field("figures", &S::figures)
          .field("tasks", &S::tasks)
          .field("findings", &S::findings,
                 "Main results, in sentences.")
          .field("failures", &S::failures,
                 "Runs that did not polish, with the reasons; empty: all runs polished.")
          .field("interrupted", &S::interrupted);
  return all;
}

const Description& description_of(const ResultColumn* /*of*/) {
  using S = ResultColumn;
  static const Description all =
      Describe<S>("polishing", "ResultColumn",
                  "Column of a table.")
          .field("name", &S::name)
          .required()
          .field("unit", &S::unit,
                 "Unit; empty for text and counts.")
          .field("digits", &S::digits,
                 "Digits after the decimal point in Markdown; CSV has all digits.");
  return all;
}

const Description& description_of(const ResultTable* /*of*/) {
  using S = ResultTable;
  static const Description all =
      Describe<S>("polishing", "ResultTable",
                  "Table of results: named columns with units, cells of text or numbers. "
                  "pandas.DataFrame(table.rows, columns=table.names) makes a data frame of it.")
          .field("name", &S::name,
                 "Name in one word, such as \"runs\".")
          .required()
          .field("title", &S::title,
                 "Heading.")
          .field("columns", &S::columns)
          .field("rows", &S::rows)
          .field("for_people", &S::for_people,
                 "False for long tables, which results.md omits.");
  return all;
}

}  // namespace burnish::polishing
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
