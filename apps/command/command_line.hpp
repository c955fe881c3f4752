/// Command line options made from the schema.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "apps/settings/assignment.hpp"
#include "apps/settings/offer.hpp"

namespace app {

/// The options of a command, each with what may stand behind it.
class Options : public CLI::App {
 public:
  explicit Options(const std::string& name, const std::string& description = {}, CLI::App* parent = nullptr)
      : CLI::App(description, name, parent) {}

  /// Those of a new command below the program or another command.
  [[nodiscard]] static Options& below(CLI::App& parent, const std::string& name,
                                      const std::string& description);

  /// An option or an argument that is read into a variable.
  template <class T>
  CLI::Option* value(const std::string& names, T& variable, const std::string& help, Form form) {
    return expect(add_option(names, variable, help), std::move(form));
  }

  /// Says what may stand behind an option, or as an argument.
  CLI::Option* expect(CLI::Option* option, Form form);

 private:
  friend Form form_of(const CLI::App& command, const CLI::Option& option);

  std::map<const CLI::Option*, Form> forms_;
};

/// What may stand behind an option of a command, or as its argument; behind a switch nothing.
[[nodiscard]] Form form_of(const CLI::App& command, const CLI::Option& option);

/// "-o", "--output".
[[nodiscard]] std::vector<std::string> names_of(const CLI::Option& option);

/// The settings that one subcommand offers as options.
///
/// Every setting is --KEY ("--loading.velocity"). Those of the `own` groups have a short name too
/// ("--velocity") and stand in the help. A property of a phase is --PHASE.PROPERTY ("--mortar.young").
/// --set KEY=VALUE does the same for any key. In names of options - and _ are the same.
class SettingOptions {
 public:
  SettingOptions(Options& options, Offer offer);

  /// Takes the options of phases out of the arguments of the subcommand (their names are the user's, so they
  /// cannot be registered), and spells the names of the others with "-".
  [[nodiscard]] std::vector<std::string> take_phase_options(const std::vector<std::string>& arguments);

  /// What was given, after parsing.   @throws Rejected (Exit::usage) for a setting that is given twice.
  [[nodiscard]] std::vector<Assignment> assignments() const;

 private:
  struct Bound {
    Field field;
    CLI::Option* option;
  };

  void add_group(Options& options, const Group& group, bool in_help);
  void add_field(Options& options, const Group& group, const Field& field, bool in_help);
  void add_phase_help(Options& options, const Group& group);
  [[nodiscard]] Assignment from_set(const std::string& text) const;

  Offer offer_;
  std::vector<Bound> bound_;
  CLI::Option* set_ = nullptr;
  std::vector<Assignment> phases_;
};

/// Help in the words of the schema: first name of an option, its type, its default.
[[nodiscard]] std::shared_ptr<CLI::Formatter> help_formatter();

/// @throws Rejected (Exit::usage) for arguments that the subcommand did not understand, with "did you mean".
void refuse_remaining(const CLI::App& command);

}  // namespace app
