#include "apps/command/doctor.hpp"

#include <nlohmann/json.hpp>

#include "apps/command/command.hpp"
#include "apps/text/markup.hpp"

namespace app {
namespace {

constexpr const char* doctor_footer =
    "Looks at the machine, the current folder and the terminal, and solves two small scenes whose answers "
    "are "
    "known,\nin two seconds. Each line is ok, a warning with its cure, or failed. Exit codes: 0 ready, 70 "
    "the "
    "numbers are\nwrong, 74 the folder cannot be written to.\n"
    "Example:\n"
    "  mesopix doctor";

class DoctorCommand : public Command {
 public:
  explicit DoctorCommand(CLI::App& program)
      : Command(program, "doctor", "Tell whether this machine and this program are ready", doctor_footer) {
    flag("--json", json_, "findings and figures as JSON");
    flag("-q,--quiet", quiet_, "only what is not well");
  }

  Exit run(Console& console) override {
    const Examination examination = examine(console.err_is_terminal);
    const std::vector<Finding> all = findings_of(examination);
    const std::vector<Finding> findings = quiet_ ? unwell(all) : all;
    if (json_)
      console.out << json_text(examination_json(examination, findings));
    else
      console.out << findings_text(findings);
    return code_of(findings);
  }

 private:
};

}  // namespace

CommandPointer doctor_command(CLI::App& parent) { return std::make_unique<DoctorCommand>(parent); }

}  // namespace app
