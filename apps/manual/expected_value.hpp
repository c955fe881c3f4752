/// What may stand behind an option, or as an argument, told by what the help says of it.
#pragma once

#include <string>
#include <vector>

#include "apps/manual/command_tree.hpp"

namespace manual {

struct ExpectedValue {
  std::vector<std::string> words;    ///< "smooth", "rough"; "auto" beside a number
  bool files = false;                ///< a file; any where there are no endings
  std::vector<std::string> endings;  ///< of the files: "h5"
  bool folders = false;
  bool keys = false;      ///< KEY=VALUE of a setting
  bool commands = false;  ///< a command of the program
};

[[nodiscard]] ExpectedValue expected(const Option& option);
[[nodiscard]] ExpectedValue expected(const Argument& argument);

/// Its names as the help shows them, without the one by its key; of a setting that the help does not show,
/// all.
[[nodiscard]] std::vector<std::string> listed_names(const Option& option);

/// The names with a dot in them, by which settings that the help does not show are known too.
[[nodiscard]] std::vector<std::string> names_by_key(const Option& option);

/// Where the name of a phase stands in a name of an option: "--PHASE.young".
[[nodiscard]] bool is_of_phases(const Option& option);

/// The options with those of the phases written out for the phases that there are by default.
[[nodiscard]] std::vector<Option> with_phases(const std::vector<Option>& options);

/// The keys of scene files that the command takes behind --set; none where it has no --set.
[[nodiscard]] std::vector<std::string> keys_of(const Command& command);

/// One of those keys as an option, for a sentence on them: "--generate.width".   @pre there is a key.
[[nodiscard]] std::string option_by_key(const Command& command);

}  // namespace manual
