#include "apps/run/run_location.hpp"

#include <string>
#include <system_error>

#include "apps/text/complaint.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

fs::path first_free(const fs::path& base) {
  make_folders(base.parent_path());
  fs::path folder = base;
  std::error_code error;
  // Only the run that makes a folder owns it, so that two runs at once do not share one.
  for (int number = 2; !fs::create_directory(folder, error); ++number) {
    if (error)
      throw Rejected(Exit::io,
                     complaint(folder.string(), error.message(), "must be a folder that can be made"));
    folder = base.string() + "-" + std::to_string(number);
  }
  return folder;
}

}  // namespace

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Rejected(Exit::io,
                   complaint(folder.string(), error.message(), "must be a folder that can be made"));
}

fs::path make_run_folder(const fs::path& wanted, const fs::path& stem, bool overwrite) {
  const fs::path folder = wanted.empty() ? fs::path("runs") / stem : wanted;
  if (wanted.empty() && !overwrite) return first_free(folder);
  std::error_code error;
  const bool taken = fs::exists(folder, error) && !(fs::is_directory(folder) && fs::is_empty(folder));
  if (taken && !fs::is_directory(folder))
    throw Rejected(Exit::usage,
                   complaint("-o", folder.string(), "is a file; must be a folder", "choose another name"));
  if (taken && !overwrite)
    throw Rejected(Exit::usage, complaint("-o", folder.string(), "is not empty",
                                          "choose another folder, or add --overwrite"));
  make_folders(folder);
  return folder;
}

}  // namespace app
