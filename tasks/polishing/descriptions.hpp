// What the task's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/tasks/polishing/task.hpp"
#include "files/described_file.hpp"
#include "mpc/descriptions.hpp"

namespace burnish::polishing {

const Words& words_of(PathKind);
const Words& words_of(ForceAxes);
const Words& words_of(ForceProfile::Kind);
const Description& description_of(const ForceProfile*);
const Description& description_of(const PathSpec*);
const Description& description_of(const PlanarPoint*);
const Description& description_of(const Weights*);
const Description& description_of(const Waving*);
const Description& description_of(const Verdict*);
const Description& description_of(const Task*);

const files::DescribedFile& file_of(const Task*);
/// A checked task, and what said it. Throws Error as read_task() does.
files::Said<Task> parse_said_task(const std::string& text, const std::string& name,
                                  const std::vector<files::Override>& overrides = {});

}  // namespace burnish::polishing
