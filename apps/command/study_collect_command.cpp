#include "apps/command/study_input.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/study/study_outcome.hpp"
#include "apps/study/study_results.hpp"
#include "apps/text/markup.hpp"

namespace app {

namespace {

class StudyCollectCommand : public Command {
 public:
  explicit StudyCollectCommand(CLI::App& study)
      : Command(
            study, "collect", "Make tables and report of the members that are done",
            "Runs nothing. Exit code 75 when members are still open: what is there is written all the same.\n"
            "Example: after mesopix study submit, or mesopix study --members on several machines\n"
            "  mesopix study collect study.toml") {
    input_.add_to(options());
    json_and_quiet("number of members and mean peak as JSON on standard output");
  }

  Exit run(Console& console) override {
    const OpenStudy open = open_study(input_);
    const StudyResults results = read_results(open.folder, open.members);
    const std::size_t missing = results.count(MemberState::open);
    if (missing == open.members.size())
      throw Rejected(Exit::data, "study collect", open.folder.path().string(), "has no result yet",
                     "mesopix study submit");
    const std::vector<std::string> doubts =
        close_study(open.folder, open.study, open.members, results, console);
    for (const std::string& doubt : doubts) console.warn(doubt);
    if (json_) console.out << json_text(study_json(open.folder, open.study, open.members, results, doubts));
    if (missing > 0) {
      console.say(fmt::format("{} of {} members have no result yet", missing, open.members.size()));
      return Exit::interrupted;
    }
    refuse_failures(open.study, open.folder, open.members);
    return Exit::ok;
  }

 private:
  StudyInput input_;
};

}  // namespace

CommandPointer study_collect_command(CLI::App& parent) {
  return std::make_unique<StudyCollectCommand>(parent);
}

}  // namespace app
