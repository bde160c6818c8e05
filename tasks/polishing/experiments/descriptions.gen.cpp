// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "polishing/experiments/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::polishing {

const Description& description_of(const ExperimentSpec* /*of*/) {
  using S = ExperimentSpec;
  static const Description all =
      Describe<S>("polishing", "ExperimentSpec",
                  "How an experiment is performed.")
          .field("plant", &S::plant,
                 "MUJOCO where this build has it")
          .field("seeds", &S::seeds,
                 "at most 10 000; 0: the experiment's own number")
          .field("first_seed", &S::first_seed)
          .field("threads", &S::threads,
                 "runs at once; 0: as many as there are cores")
          .field("quick", &S::quick,
                 "few and short runs, to see whether it works")
          .field("surfaces", &S::surfaces,
                 "empty: the experiment's own")
          .field("ranges", &S::ranges,
                 "of `seeds`: usual, wide or curved; empty: usual")
          .field("robots", &S::robots,
                 "of the experiments `robots` and `force_test`; empty: their own")
          .field("tools", &S::tools,
                 "the frame that each of these holds its tool with; \"tool\" for those that lack "
                 "one")
          .field("folder", &S::folder,
                 "of the experiment `robots`: a folder with descriptions of public robots, which "
                 "are tried in place of those that come along; its list is robots.yaml there, or "
                 "the shipped one; empty: none")
          .field("overrides", &S::overrides,
                 "changes to the task, as override_task() takes them; what the experiment sweeps "
                 "is set after them")
          .field("progress", &S::progress,
                 "called now and then with the share that is done, 0 to 1, and what is being "
                 "done; from one thread at a time, but not always the same one. Returning False "
                 "stops the experiment.");
  return all;
}

const Description& description_of(const Figure* /*of*/) {
  using S = Figure;
  static const Description all =
      Describe<S>("polishing", "Figure",
                  "A plot, and its file's name without ending.")
          .result()
          .field("name", &S::name,
                 "of its file, without ending")
          .field("plot", &S::plot);
  return all;
}

const Description& description_of(const NamedTask* /*of*/) {
  using S = NamedTask;
  static const Description all =
      Describe<S>("polishing", "NamedTask",
                  "A task worth running again by itself.")
          .result()
          .field("name", &S::name,
                 "of its file, without ending")
          .field("task", &S::task);
  return all;
}

const Description& description_of(const ExperimentReport* /*of*/) {
  using S = ExperimentReport;
  static const Description all =
      Describe<S>("polishing", "ExperimentReport",
                  "What came out of an experiment.")
          .result()
          .field("title", &S::title)
          .field("tables", &S::tables,
                 "the first one has a row for every run (force_test: for every figure and "
                 "controller)")
          .field("figures", &S::figures)
          .field("tasks", &S::tasks)
          .field("findings", &S::findings,
                 "sentences")
          .field("failures", &S::failures,
                 "runs that did not polish, and why; empty: all did")
          .field("interrupted", &S::interrupted);
  return all;
}

const Description& description_of(const ResultColumn* /*of*/) {
  using S = ResultColumn;
  static const Description all =
      Describe<S>("polishing", "ResultColumn",
                  "What stands in a column of a table.")
          .field("name", &S::name)
          .required()
          .field("unit", &S::unit,
                 "empty for text and counts")
          .field("digits", &S::digits,
                 "behind the point, in Markdown; CSV has all of them");
  return all;
}

const Description& description_of(const ResultTable* /*of*/) {
  using S = ResultTable;
  static const Description all =
      Describe<S>("polishing", "ResultTable",
                  "Results as a table: named columns with units, cells of text or numbers. "
                  "pandas.DataFrame(table.rows, columns=table.names) makes a data frame of it.")
          .field("name", &S::name,
                 "of one word, such as \"runs\"")
          .required()
          .field("title", &S::title,
                 "for people")
          .field("columns", &S::columns)
          .field("rows", &S::rows)
          .field("for_people", &S::for_people,
                 "False: too long to be read");
  return all;
}

}  // namespace burnish::polishing
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
