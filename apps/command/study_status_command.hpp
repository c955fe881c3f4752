/// mesopix study status: how far a study is, here and in the queue of Slurm.
#pragma once

#include "apps/command/command.hpp"
#include "apps/command/study_input.hpp"

namespace app {

class StudyStatusCommand : public Command {
 public:
  explicit StudyStatusCommand(CLI::App& study);
  Exit run(Console& console) override;

 private:
  StudyInput input_;
  bool json_ = false;
};

}  // namespace app
