/// Which study a command is about.
/// mesopix study: run a scene many times, with other seeds and values.
/// mesopix study collect: tables and report of a study that ran elsewhere.
/// mesopix study submit: leave a study to Slurm, or to another program that runs commands.
/// mesopix study status: how far a study is, here and in the queue of Slurm.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/study/slurm.hpp"
#include "apps/study/study_folder.hpp"
#include "apps/study/study_growth.hpp"
#include "apps/system/processes.hpp"

namespace app {

/// The arguments STUDY and -o of a command.
class StudyInput {
 public:
  void add_to(Options& options);

  /// After parsing.   @throws Rejected (Exit::usage) for a study that is missing or is something else.
  void check() const;

  [[nodiscard]] const std::string& file() const { return file_; }
  /// What -o says, or runs/ with the name of the study.
  [[nodiscard]] StudyFolder folder() const;
  /// As they were given, for a command that goes on with it.
  [[nodiscard]] std::vector<std::string> words() const;

 private:
  std::string file_;
  std::string folder_;
};

/// The study, its members, and where they are kept.
struct OpenStudy {
  Study study;
  std::vector<Member> members;
  StudyFolder folder;
};

/// Read the study, and make its folder or go on with it.   @throws Rejected, mpm::FileError.
[[nodiscard]] OpenStudy open_study(const StudyInput& input);

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

class StudyCollectCommand : public Command {
 public:
  explicit StudyCollectCommand(CLI::App& study);
  Exit run(Console& console) override;

 private:
  StudyInput input_;
  bool json_ = false;
  bool quiet_ = false;
};

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

class StudyStatusCommand : public Command {
 public:
  explicit StudyStatusCommand(CLI::App& study);
  Exit run(Console& console) override;

 private:
  StudyInput input_;
  bool json_ = false;
};

}  // namespace app
