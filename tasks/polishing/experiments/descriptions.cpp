#include "polishing/experiments/descriptions.hpp"

namespace burnish::polishing {

const Description& description_of(const ExperimentSpec* /*of*/) {
  using E = ExperimentSpec;
  static const Description all =
      Describe<E>("polishing", "ExperimentSpec", "How an experiment is performed.")
          .field("plant", &E::plant, "MUJOCO where this build has it")
          .field("seeds", &E::seeds, "at most 10 000; 0: the experiment's own number")
          .field("first_seed", &E::first_seed)
          .field("threads", &E::threads, "runs at once; 0: as many as there are cores")
          .field("quick", &E::quick, "few and short runs, to see whether it works")
          .field("surfaces", &E::surfaces, "empty: the experiment's own")
          .field("ranges", &E::ranges, "of `seeds`: usual, wide or curved; empty: usual")
          .field("robots", &E::robots,
                 "of the experiments `robots` and `force_test`; empty: their own")
          .field(
              "tools", &E::tools,
              "the frame that each of these holds its tool with; \"tool\" for those that lack one")
          .field("folder", &E::folder,
                 "of the experiment `robots`: a folder with descriptions of public robots, which "
                 "are tried in place of those that come along; its list is robots.yaml there, or "
                 "the shipped one; empty: none")
          .field("overrides", &E::overrides,
                 "changes to the task, as override_task() takes them; what the experiment sweeps "
                 "is set after them")
          .field("progress", &E::progress,
                 "called now and then with the share that is done, 0 to 1, and what is being done; "
                 "from one thread at a time, but not always the same one. Returning False stops "
                 "the experiment.");
  return all;
}

const Description& description_of(const ResultColumn* /*of*/) {
  using R = ResultColumn;
  static const Description all =
      Describe<R>("polishing", "ResultColumn", "What stands in a column of a table.")
          .field("name", &R::name)
          .required()
          .field("unit", &R::unit, "empty for text and counts")
          .field("digits", &R::digits, "behind the point, in Markdown; CSV has all of them");
  return all;
}

const Description& description_of(const ResultTable* /*of*/) {
  using R = ResultTable;
  static const Description all =
      Describe<R>("polishing", "ResultTable",
                  "Results as a table: named columns with units, cells of text or numbers. "
                  "pandas.DataFrame(table.rows, columns=table.names) makes a data frame of it.")
          .field("name", &R::name, "of one word, such as \"runs\"")
          .required()
          .field("title", &R::title, "for people")
          .field("columns", &R::columns)
          .field("rows", &R::rows)
          .field("for_people", &R::for_people, "False: too long to be read");
  return all;
}

const Description& description_of(const Figure* /*of*/) {
  using F = Figure;
  static const Description all =
      Describe<F>("polishing", "Figure", "A plot, and its file's name without ending.")
          .result()
          .field("name", &F::name, "of its file, without ending")
          .field("plot", &F::plot);
  return all;
}

const Description& description_of(const NamedTask* /*of*/) {
  using N = NamedTask;
  static const Description all =
      Describe<N>("polishing", "NamedTask", "A task worth running again by itself.")
          .result()
          .field("name", &N::name, "of its file, without ending")
          .field("task", &N::task);
  return all;
}

const Description& description_of(const ExperimentReport* /*of*/) {
  using E = ExperimentReport;
  static const Description all =
      Describe<E>("polishing", "ExperimentReport", "What came out of an experiment.")
          .result()
          .field("title", &E::title)
          .field(
              "tables", &E::tables,
              "the first one has a row for every run (force_test: for every figure and controller)")
          .field("figures", &E::figures)
          .field("tasks", &E::tasks)
          .field("findings", &E::findings, "sentences")
          .field("failures", &E::failures, "runs that did not polish, and why; empty: all did")
          .field("interrupted", &E::interrupted);
  return all;
}

}  // namespace burnish::polishing
