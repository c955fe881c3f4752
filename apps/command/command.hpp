/// The base class of all commands, and the meanings of the exit codes.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/command/command_line.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/complaint.hpp"

namespace app {

struct ExitMeaning {
  Exit code;
  const char* name;   ///< in sysexits.h; empty where it has none
  const char* brief;  ///< "wrong usage"
  const char* whole;  ///< a sentence or two
};

/// Every exit code, the smallest first.
[[nodiscard]] const std::vector<ExitMeaning>& exit_meanings();

/// "0 done, 64 wrong usage, ...", in lines of less than 100 letters.
[[nodiscard]] std::string exit_summary();

class Command;
using CommandPointer = std::unique_ptr<Command>;

class Command {
 public:
  virtual ~Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  [[nodiscard]] Options& options() { return options_; }

  /// Arguments behind the name of the subcommand, as they may be handed to the parser.
  [[nodiscard]] virtual std::vector<std::string> prepare(const std::vector<std::string>& arguments) {
    return arguments;
  }

  /// Do what the parsed options say, or what those of the command below that was named say.
  /// @throws Rejected and the exceptions of the libraries.
  Exit execute(Console& console);

 protected:
  /// @param parent  the program, or the options of a command that has this one below it.
  Command(CLI::App& parent, const std::string& name, const std::string& description,
          const std::string& example)
      : options_(Options::below(parent, name, description)) {
    options_.formatter(help_formatter());
    options_.set_help_flag("-h,--help", "show this help, and do no more");
    options_.footer(example);
    options_.allow_extras();
  }

  /// Of this command itself, which is as quiet as it was told to be.
  virtual Exit run(Console& console) = 0;

  template <class T>
  CLI::Option* option(const std::string& names, T& value, const std::string& help, Form form) {
    return options_.value(names, value, help, std::move(form));
  }
  void flag(const std::string& names, bool& value, const std::string& help) {
    options_.add_flag(names, value, help);
  }
  void json_and_quiet(const std::string& json_help) {
    flag("--json", json_, json_help);
    flag("-q,--quiet", quiet_, "say nothing but errors");
  }

  /// @param usual  folder, where none is given.
  void folder_and_overwrite(const std::string& usual) {
    option("-o,--output", output_, "folder [" + usual + "]", folder_form());
    flag("--overwrite", overwrite_, "write into a folder that is not empty");
  }

  /// @throws Rejected (Exit::usage) for an argument that was not given.
  /// @param usage  of the command, to show what is missing.
  static void require(const std::string& argument, const std::string& name, const std::string& usage);

  std::vector<CommandPointer> below_;  ///< commands of its own
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;

 private:
  Options& options_;
};

/// One that has settings of the scene among its options.
class SettingsCommand : public Command {
 public:
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override {
    return settings_.take_phase_options(arguments);
  }

 protected:
  SettingsCommand(CLI::App& parent, const std::string& name, const std::string& description,
                  const std::string& example, Offer offer)
      : Command(parent, name, description, example), settings_(options(), std::move(offer)) {}

  SettingOptions settings_;
};

// The commands below the program.
[[nodiscard]] CommandPointer generate_command(CLI::App& program);   ///< random or listed ellipses -> specimen
[[nodiscard]] CommandPointer convert_command(CLI::App& program);    ///< picture -> specimen
[[nodiscard]] CommandPointer twin_command(CLI::App& program);       ///< random specimens like a picture
[[nodiscard]] CommandPointer scene_command(CLI::App& program);      ///< begin a scene, check and describe it
[[nodiscard]] CommandPointer simulate_command(CLI::App& program);   ///< break a specimen
[[nodiscard]] CommandPointer study_command(CLI::App& program);      ///< a scene many times
[[nodiscard]] CommandPointer calibrate_command(CLI::App& program);  ///< fit a scene to a peak or a curve
[[nodiscard]] CommandPointer inspect_command(CLI::App& program);    ///< what is in a file
[[nodiscard]] CommandPointer stiffness_command(CLI::App& program);  ///< effective moduli of specimens
[[nodiscard]] CommandPointer report_command(CLI::App& program);     ///< several runs on one page
[[nodiscard]] CommandPointer plot_command(CLI::App& program);       ///< pictures for papers and slides
[[nodiscard]] CommandPointer export_command(CLI::App& program);     ///< formats of other programs
[[nodiscard]] CommandPointer doctor_command(CLI::App& program);     ///< whether machine and program are ready
[[nodiscard]] CommandPointer help_command(CLI::App& program);       ///< how a command is used

}  // namespace app
