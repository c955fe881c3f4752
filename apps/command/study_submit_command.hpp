/// mesopix study submit: leave a study to Slurm, or to another program that runs commands.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/study/slurm_job.hpp"
#include "apps/command/study_input.hpp"

namespace app {

class StudySubmitCommand : public Command {
 public:
  explicit StudySubmitCommand(CLI::App& study);
  Exit run(Console& console) override;

 private:
  void check_options() const;
  [[nodiscard]] std::size_t chunk(std::size_t members) const;
  [[nodiscard]] int cpus() const;
  [[nodiscard]] SlurmJob job(const OpenStudy& open) const;
  void tell(const SlurmJob& job, const std::string& script, const std::string& id, Console& console) const;
  void submit(SlurmJob job, const OpenStudy& open, Console& console) const;

  StudyInput input_;
  bool slurm_ = false;
  bool commands_ = false;
  bool dry_run_ = false;
  bool json_ = false;
  bool quiet_ = false;
  std::string chunk_;
  std::string jobs_;
  std::vector<std::string> sbatch_;
};

}  // namespace app
