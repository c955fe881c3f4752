/// Two runs with known answers, in two seconds.
/// What is well with this machine and this program, and what is not.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/system/machine.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/version.hpp"

namespace app {

struct SelfTest {
  static constexpr double allowed_modulus_error = 2e-3, allowed_peak_error = 1e-3;

  double modulus_error = 0;  ///< of a block without cracks over E / (1 - nu^2) [-]
  double peak_error = 0;     ///< of the peak stress of a block with aggregates that cracks, over the one that
                             ///< it had where the program was made [-]
  bool same_on_threads = false;   ///< that run has the same bits on one thread and on several
  int threads = 1;                ///< those
  double updates_per_second = 0;  ///< point-updates on one thread [1/s]
  double share_of_peak = 0;  ///< operations of them over what one core can do at most, measured just now [-]

  [[nodiscard]] bool is_right() const {
    return modulus_error < allowed_modulus_error && peak_error < allowed_peak_error && same_on_threads;
  }
};

/// @param threads  to compare with one, > 1 where there are as many cores.
[[nodiscard]] SelfTest run_self_test(int threads);

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
