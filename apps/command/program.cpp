#include "apps/command/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "apps/command/command.hpp"
#include "apps/command/command_line.hpp"
#include "apps/command/completion.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/version.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

std::string footer_text() {
  return "From nothing to a broken specimen, and to what there is to see:\n"
         "  mesopix generate -o specimen.h5\n"
         "  mesopix simulate specimen.h5 -o runs/first\n"
         "  mesopix inspect runs/first\n"
         "The page runs/first/report.html shows the same and more. To begin with a picture of your own:\n"
         "  mesopix convert photo.jpg --width \"150 mm\" --pixels 300 -o specimen.h5\n"
         "mesopix COMMAND --help, or mesopix help COMMAND, tells more and ends with an example.\n"
         "Exit codes: " +
         exit_summary() + ".";
}

/// The program and its subcommands.
class Program {
 public:
  explicit Program(const MoreCommands& more) {
    root_.formatter(help_formatter());
    root_.set_help_flag("-h,--help", "show this help");
    root_.set_version_flag("--version", std::string("mesopix ") + version(), "tell the version");
    root_.footer(footer_text());
    root_.allow_extras();
    root_.require_subcommand(0, 1);  // a file may be called as a command is
    heading_ = "First, a specimen and a scene";
    add(generate_command(root_));
    add(convert_command(root_));
    add(twin_command(root_));
    add(scene_command(root_));
    heading_ = "Then, break it";
    add(simulate_command(root_));
    add(study_command(root_));
    add(calibrate_command(root_));
    heading_ = "Look at what came of it";
    add(stiffness_command(root_));
    add(inspect_command(root_));
    add(report_command(root_));
    add(plot_command(root_));
    add(export_command(root_));
    heading_ = "See what the program is worth";
    for (const auto& make : more) add(make(root_));
    heading_ = "Find help";
    add(doctor_command(root_));
    add(help_command(root_));
  }

  [[nodiscard]] const CLI::App& options() const { return root_; }

  Exit run(const std::vector<std::string>& arguments, Console& console) {
    if (arguments.empty()) {
      console.err << with_headings(root_.help(), console.err_is_coloured);
      return Exit::usage;
    }
    if (arguments.front() == "complete") {  // shells ask this, nobody types it
      console.out << completions(root_, {arguments.begin() + 1, arguments.end()});
      return Exit::ok;
    }
    try {
      return parsed(arguments).execute(console);
    } catch (const CLI::Success& asked) {  // --help, --version
      std::ostringstream told;
      const int code = root_.exit(asked, told, told);
      console.out << with_headings(told.str(), console.out_is_coloured);
      return static_cast<Exit>(code);
    }
  }

  /// The command that is named, with its options.   @throws Rejected, CLI::ParseError.
  Command& parsed(const std::vector<std::string>& arguments) {
    Command* command = find(arguments.front());
    if (command == nullptr && arguments.front().rfind('-', 0) != 0) refuse_command(arguments.front());
    std::vector<std::string> words(arguments.begin() + 1, arguments.end());
    if (command != nullptr) words = command->prepare(words);
    words.insert(words.begin(), arguments.front());
    std::reverse(words.begin(), words.end());  // the parser wants the last one first
    try {
      root_.parse(words);
    } catch (const CLI::ArgumentMismatch& mismatch) {
      const std::string what = mismatch.what();
      throw Rejected(Exit::usage, what.substr(0, what.find(':')), "needs a value",
                     "mesopix " + arguments.front() + " --help tells which");
    }
    if (command == nullptr)
      throw Rejected(Exit::usage, arguments.front(), "is no command", "must be " + listed(names()),
                     "mesopix --help tells what they do");
    refuse_remaining(command->options());
    return *command;
  }

 private:
  void add(CommandPointer command) {
    command->options().group(heading_);
    commands_.push_back(std::move(command));
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
    if (name == "reproduce" || name == "bench")  // evidence_commands() has them
      throw Rejected(Exit::usage, name, "is not in this build", "",
                     "./quickstart all builds it, or cmake with -DMESOPIX_EVIDENCE=ON");
    throw Rejected(Exit::usage, name, "unknown command", "must be " + listed(names()),
                   did_you_mean(name, names()));
  }

  CLI::App root_{"mesopix: from a picture of concrete to a broken specimen", "mesopix"};
  std::string heading_;  ///< in the help, of the commands that are added next
  std::vector<CommandPointer> commands_;
};

Exit refuse(Console& console, const Rejected& refusal) {
  constexpr std::size_t told = 20;
  const std::vector<Complaint>& complaints = refusal.complaints;
  const std::string who = in_red("mesopix:", console.err_is_coloured);
  for (std::size_t i = 0; i < std::min(told, complaints.size()); ++i)
    console.err << who << ' ' << text(complaints[i]) << '\n';
  if (complaints.size() > told)
    console.err << fmt::format("{} and {}{} more\n", who,
                               complaints.size() < most_complaints ? "" : "at least ",
                               complaints.size() - told);
  console.err << std::flush;
  return refusal.code;
}

Exit run_and_flush(const std::vector<std::string>& arguments, Console& console, const MoreCommands& more) {
  const Exit code = Program(more).run(arguments, console);
  if (console.out.flush()) return code;
  throw Rejected(Exit::io, "standard output", "cannot be written", "");
}

}  // namespace

Exit run_program(const std::vector<std::string>& arguments, Console& console, const MoreCommands& more) {
  try {
    return run_and_flush(arguments, console, more);
  } catch (const CLI::ParseError& error) {
    return refuse(console, {Exit::usage, complaint(error.what(), "", "", "mesopix --help")});
  } catch (const std::exception&) {
    return refuse(console, refusal_of(std::current_exception(), console.locate));
  }
}

void look_at_program(const Look& look, const MoreCommands& more) { look(Program(more).options()); }

void look_at_parsed(const std::vector<std::string>& arguments, const Look& look, const MoreCommands& more) {
  Program program(more);
  look(program.parsed(arguments).options());
}

}  // namespace app
