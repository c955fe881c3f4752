#include "apps/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/calibrate_command.hpp"
#include "apps/command_line.hpp"
#include "apps/convert_command.hpp"
#include "apps/doctor_command.hpp"
#include "apps/export_command.hpp"
#include "apps/generate_command.hpp"
#include "apps/inspect_command.hpp"
#include "apps/plot_command.hpp"
#include "apps/refusal.hpp"
#include "apps/report_command.hpp"
#include "apps/scene_command.hpp"
#include "apps/simulate_command.hpp"
#include "apps/study_command.hpp"
#include "apps/suggestion.hpp"
#include "apps/twin_command.hpp"
#include "apps/version.hpp"

namespace app {
namespace {

constexpr const char* footer_text =
    "From nothing to a broken specimen:\n"
    "  mesopix generate -o specimen.h5\n"
    "  mesopix simulate specimen.h5\n"
    "mesopix COMMAND --help tells more.\n"
    "Exit codes: 0 done, 64 wrong usage, 65 wrong data or physics, 70 a bug of ours, 74 input or output "
    "failed\n"
    "(what the disk took is kept, and the rest named), 75 interrupted with what was computed kept.";

/// The program and its subcommands.
class Program {
 public:
  explicit Program(const MoreCommands& more) {
    root_.formatter(help_formatter());
    root_.set_version_flag("--version", std::string("mesopix ") + version());
    root_.footer(footer_text);
    root_.allow_extras();
    add<GenerateCommand>();
    add<ConvertCommand>();
    add<TwinCommand>();
    add<SceneCommand>();
    add<SimulateCommand>();
    add<StudyCommand>();
    add<CalibrateCommand>();
    add<InspectCommand>();
    add<ReportCommand>();
    add<PlotCommand>();
    add<ExportCommand>();
    add<DoctorCommand>();
    for (const auto& make : more) commands_.push_back(make(root_));
  }

  Exit run(const std::vector<std::string>& arguments, Console& console) {
    if (arguments.empty()) {
      console.err << root_.help();
      return Exit::usage;
    }
    Command* command = find(arguments.front());
    if (command == nullptr && arguments.front().rfind('-', 0) != 0) refuse_command(arguments.front());
    std::vector<std::string> parsed(arguments.begin() + 1, arguments.end());
    if (command != nullptr) parsed = command->prepare(parsed);
    parsed.insert(parsed.begin(), arguments.front());
    std::reverse(parsed.begin(), parsed.end());  // the parser wants the last one first
    try {
      root_.parse(parsed);
    } catch (const CLI::Success& asked) {  // --help, --version
      return static_cast<Exit>(root_.exit(asked, console.out, console.err));
    } catch (const CLI::ArgumentMismatch& mismatch) {
      const std::string what = mismatch.what();
      throw Rejected(Exit::usage, complaint(what.substr(0, what.find(':')), "needs a value",
                                            "mesopix " + arguments.front() + " --help tells which"));
    }
    if (command == nullptr)
      throw Rejected(Exit::usage, complaint(arguments.front(), "is no command", "must be " + listed(names()),
                                            "mesopix --help tells what they do"));
    refuse_remaining(command->options());
    return command->run(console);
  }

 private:
  template <class Kind>
  void add() {
    commands_.push_back(std::make_unique<Kind>(root_));
  }

  Command* find(const std::string& name) {
    for (const auto& command : commands_)
      if (command->options().get_name() == name) return command.get();
    return nullptr;
  }

  std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& command : commands_) all.push_back(command->options().get_name());
    return all;
  }

  void refuse_command(const std::string& name) {
    throw Rejected(Exit::usage, complaint(name, "unknown command", "must be " + listed(names()),
                                          did_you_mean(name, names())));
  }

  CLI::App root_{"mesopix: from a picture of concrete to a broken specimen", "mesopix"};
  std::vector<std::unique_ptr<Command>> commands_;
};

Exit refuse(Console& console, const Rejected& refusal) {
  constexpr std::size_t told = 20;
  const std::vector<Complaint>& complaints = refusal.complaints;
  for (std::size_t i = 0; i < std::min(told, complaints.size()); ++i)
    console.err << "mesopix: " << text(complaints[i]) << '\n';
  if (complaints.size() > told)
    console.err << fmt::format("mesopix: and {}{} more\n",
                               complaints.size() < most_complaints ? "" : "at least ",
                               complaints.size() - told);
  console.err << std::flush;
  return refusal.code;
}

Exit run_and_flush(const std::vector<std::string>& arguments, Console& console, const MoreCommands& more) {
  const Exit code = Program(more).run(arguments, console);
  if (console.out.flush()) return code;
  throw Rejected(Exit::io, complaint("standard output", "cannot be written", ""));
}

}  // namespace

Exit run_program(const std::vector<std::string>& arguments, Console& console, const MoreCommands& more) {
  try {
    return run_and_flush(arguments, console, more);
  } catch (const CLI::ParseError& error) {
    return refuse(console, {Exit::usage, complaint(error.what(), "", "", "mesopix --help")});
  } catch (const std::exception&) {
    return refuse(console, refusal_of(std::current_exception(), console.origins));
  }
}

}  // namespace app
