#include "run_files.hpp"

#ifdef BURNISH_RUN_FILES
#include "burnish/polish_files.hpp"
#include "burnish/polish_page.hpp"
#endif

namespace burnish::python {

#ifdef BURNISH_RUN_FILES
std::vector<std::string> write_run_folder(const polishing::RunSpec& spec,
                                          const polishing::RunResult& result,
                                          const std::filesystem::path& folder,
                                          const FolderOptions& options) {
  if (options.record_every < 1)
    throw Error("RunResult.write: record_every is " + std::to_string(options.record_every) +
                "; wanted is a positive number of plant steps");
  app::PolishJob job{.name = options.name, .place = options.name, .spec = spec};
  job.command = "burnish polish task.yaml --controller " + name_of(spec.controller) + " --plant " +
                name_of(spec.plant) + (spec.check_reach ? "" : " --unchecked");
  std::vector<std::string> names = write_run(job, result, options.record_every, folder);
  app::PageWriter pages(options.page, options.recording);
  for (std::string& name : pages.write(job, result, options.record_every, folder))
    names.push_back(std::move(name));
  return names;
}
#else
std::vector<std::string> write_run_folder(const polishing::RunSpec&, const polishing::RunResult&,
                                          const std::filesystem::path&, const FolderOptions&) {
  throw Error(
      "RunResult.write: this build has no command line, whose files these are; trace.write_csv() "
      "and write_task() are there in all builds");
}
#endif

}  // namespace burnish::python
