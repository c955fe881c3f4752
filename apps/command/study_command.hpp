/// mesopix study: run a scene many times, with other seeds and values.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/system/interrupt.hpp"
#include "apps/command/study_input.hpp"
#include "apps/study/study_whole.hpp"

namespace app {

class StudyCommand : public Command {
 public:
  explicit StudyCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  void check_options() const;
  [[nodiscard]] int workers() const;
  [[nodiscard]] double until_ci() const;
  [[nodiscard]] std::string command() const;
  [[nodiscard]] std::vector<Member> wanted(const std::vector<Member>& members) const;
  [[nodiscard]] StudyTally work(const Study& study, const std::vector<Member>& members,
                                const InterruptGuard& guard, Console& console) const;
  [[nodiscard]] Exit run_part(const Study& study, const std::vector<Member>& members, Console& console) const;
  [[nodiscard]] Exit run_whole(Study study, std::vector<Member> members, Console& console) const;
  [[nodiscard]] Exit say_interrupted(const StudyTally& tally, const std::vector<Member>& members,
                                     Console& console) const;
  void finish(const WholeStudy& whole, Console& console) const;

  StudyInput input_;
  std::vector<std::unique_ptr<Command>> below_;  ///< submit, status, collect
  std::string members_;
  std::string jobs_;
  std::string until_ci_;
  bool retry_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
