/// What is well with this machine and this program, and what is not.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/text/complaint.hpp"
#include "apps/system/machine.hpp"
#include "apps/command/self_test.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/version.hpp"

namespace app {

enum class Health { ok, warning, failed };

struct Finding {
  Health health = Health::ok;
  std::string topic;     ///< "memory"
  std::string text;      ///< what was found
  std::string cure;      ///< what to do about it; empty where all is well
  Exit code = Exit::ok;  ///< of the program, where it failed
};

/// All that is looked at, as plain data.
struct Examination {
  Build build;
  Machine machine;
  std::vector<std::pair<std::string, std::string>> libraries;  ///< name, version
  std::string folder;                                          ///< the current one
  std::uint64_t free_disk = 0;                                 ///< there [bytes]
  std::string why_not_writable;                                ///< empty: it is
  bool has_terminal = false;                                   ///< messages go to one
  TerminalEnvironment terminal;
  std::string slurm;  ///< version of sbatch; empty = there is none
  SelfTest self_test;
};

/// Takes two seconds, most of them for the self test.
[[nodiscard]] Examination examine(bool has_terminal);

/// One for each topic, in the order in which they are told.
[[nodiscard]] std::vector<Finding> findings_of(const Examination& examination);

/// Exit::ok unless something failed.
[[nodiscard]] Exit code_of(const std::vector<Finding>& findings);

/// Those that are not ok.
[[nodiscard]] std::vector<Finding> unwell(const std::vector<Finding>& findings);

[[nodiscard]] std::string findings_text(const std::vector<Finding>& findings);

/// Findings and the figures that they go by.
[[nodiscard]] nlohmann::ordered_json examination_json(const Examination& examination,
                                                      const std::vector<Finding>& findings);

}  // namespace app
