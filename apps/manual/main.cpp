// Writes the manual pages and the reference, from the options of the program and
// the schema of scenes.   Usage: mesopix_manual FOLDER SCENE.toml
#include <filesystem>
#include <iostream>

#include "apps/command/program.hpp"
#include "apps/evidence_commands.hpp"
#include "apps/manual/man_pages.hpp"
#include "apps/manual/reference.hpp"
#include "apps/system/files.hpp"
#include "libmpm/files/replace_file.hpp"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& folder, const std::vector<manual::File>& files) {
  fs::remove_all(folder);  // a page of a command that is gone
  fs::create_directories(folder);
  for (const manual::File& file : files) mpm::replace_file((folder / file.name).string(), file.text);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: mesopix_manual FOLDER SCENE.toml\n";
    return static_cast<int>(app::Exit::usage);
  }
  try {
    const fs::path folder = argv[1];
    const std::string scene = app::read_text_file(argv[2]);
    manual::Command tree;
    app::look_at_program([&](const CLI::App& root) { tree = manual::command_tree(root); },
                         app::evidence_commands());
    write(folder / "man", manual::man_pages(tree, scene));
    write(folder / "reference", manual::reference(tree, scene));
  } catch (const std::exception& error) {
    std::cerr << "mesopix_manual: " << error.what() << '\n';
    return static_cast<int>(app::Exit::io);
  }
  return 0;
}
