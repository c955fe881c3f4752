/// Which study a command is about, and the commands below mesopix study.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/study/study_folder.hpp"

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

/// Leave a study to Slurm, or to another program that runs commands.
[[nodiscard]] CommandPointer study_submit_command(CLI::App& study);
/// How far it is, here and in the queue of Slurm.
[[nodiscard]] CommandPointer study_status_command(CLI::App& study);
/// Tables and report of one that ran elsewhere.
[[nodiscard]] CommandPointer study_collect_command(CLI::App& study);

}  // namespace app
