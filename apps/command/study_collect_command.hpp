/// mesopix study collect: tables and report of a study that ran elsewhere.
#pragma once

#include "apps/command/command.hpp"
#include "apps/command/study_input.hpp"

namespace app {

class StudyCollectCommand : public Command {
 public:
  explicit StudyCollectCommand(CLI::App& study);
  Exit run(Console& console) override;

 private:
  StudyInput input_;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
