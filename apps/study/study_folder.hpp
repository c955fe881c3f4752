/// What a study keeps on disk.
///   study.toml, scene.toml   the study and its scene, as they were given
///   specimen.h5              that they break, where a script gave one
///   format.json              identity_format, by which the members are named
///   members/ID.h5            result of a member (mpm::write_result), named by what it depends on
///   members/ID/checkpoints   of a member that was interrupted (CheckpointFolder)
///   failures/ID.json         why a member has none
///   table.csv, table.h5, timing.csv, report.html, cracks.png   what all of them say together
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/study/study_members.hpp"

namespace app {

class StudyFolder {
 public:
  explicit StudyFolder(std::filesystem::path path) : path_(std::move(path)) {}

  /// Make the folder, or go on with one that holds this study or a smaller one: whose members are all among
  /// the given ones.
  /// @throws Rejected (Exit::usage) for a folder of something else, saying what differs; (Exit::data) for one
  /// whose members another version has named otherwise; (Exit::io), mpm::FileError.
  void open(const Study& study, const std::vector<Member>& members) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }
  [[nodiscard]] std::filesystem::path result_file(const Member& member) const;
  [[nodiscard]] std::filesystem::path failure_file(const Member& member) const;
  /// Of a member that is not done yet.
  [[nodiscard]] std::filesystem::path run_folder(const Member& member) const;

  [[nodiscard]] bool has_result(const Member& member) const;
  [[nodiscard]] bool has_failed(const Member& member) const;
  /// Whether there is something to go on from.
  [[nodiscard]] bool has_begun(const Member& member) const;

  /// Keep why a member failed.   @throws mpm::FileError.
  void write_failure(const Study& study, const Member& member, const std::string& reason) const;
  /// What was kept; empty when it has not failed.   @throws Rejected for a file that is none of ours.
  [[nodiscard]] std::string failure(const Member& member) const;
  /// So that it is run again.
  void forget_failure(const Member& member) const;

 private:
  void check_format(const Study& study) const;

  std::filesystem::path path_;
};

}  // namespace app
