#include "apps/command/doctor.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace

DoctorCommand::DoctorCommand(CLI::App& program)
    : Command(program, "doctor", "Tell whether this machine and this program are ready", doctor_footer) {
  options().add_flag("--json", json_, "findings and figures as JSON");
  options().add_flag("-q,--quiet", quiet_, "only what is not well");
}

Exit DoctorCommand::run(Console& console) {
  const Examination examination = examine(console.err_is_terminal);
  const std::vector<Finding> all = findings_of(examination);
  const std::vector<Finding> findings = quiet_ ? unwell(all) : all;
  if (json_)
    console.out << json_text(examination_json(examination, findings));
  else
    console.out << findings_text(findings);
  return code_of(findings);
}

}  // namespace app
