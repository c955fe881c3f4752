#include "apps/command/study_input.hpp"

#include <filesystem>

#include "apps/command/command.hpp"
#include "apps/study/study_file.hpp"

namespace app {

namespace fs = std::filesystem;

void StudyInput::add_to(Options& options) {
  options.value("STUDY", file_, "study.toml; mesopix study --help shows what stands in it",
                file_form({"toml"}));
  options.value("-o,--output", folder_, "folder [runs/STUDY]", folder_form());
}

void StudyInput::check() const {
  if (file_.empty()) throw Rejected(Exit::usage, "STUDY", "missing", "", "mesopix study STUDY.toml");
  if (kind_of_input(file_) != InputKind::scene)
    throw Rejected(Exit::usage, "STUDY", file_, "must be a study, study.toml",
                   "mesopix study --help shows what stands in it");
}

StudyFolder StudyInput::folder() const {
  return StudyFolder(folder_.empty() ? fs::path("runs") / fs::path(file_).stem() : fs::path(folder_));
}

std::vector<std::string> StudyInput::words() const {
  std::vector<std::string> words{file_};
  if (!folder_.empty()) words.insert(words.end(), {"-o", folder_});
  return words;
}

OpenStudy open_study(const StudyInput& input) {
  input.check();
  OpenStudy open{read_study(input.file()), {}, input.folder()};
  open.members = list_members(open.study);
  open.folder.open(open.study, open.members);
  return open;
}

}  // namespace app
