/// The manual pages of the program, in roff, the typesetter's language.
#pragma once

#include <string>
#include <vector>

#include "apps/manual/command_tree.hpp"

namespace manual {

/// Every letter shows as it is, at the beginning of a line too; "-" is the one that is typed.
[[nodiscard]] std::string roff(const std::string& text);
[[nodiscard]] std::string bold(const std::string& text);
[[nodiscard]] std::string italic(const std::string& text);

/// A manual page that grows from its title to its end.
class ManPage {
 public:
  /// @param name  "mesopix-study-submit".   @param section  1 or 5.   @param about  what the name is, on one
  /// line.
  ManPage(const std::string& name, int section, const std::string& about);

  void section(const std::string& title);     ///< "OPTIONS"
  void subsection(const std::string& title);  ///< "Loading"
  /// @param formatted, term  of roff(), bold() and italic().
  void paragraph(const std::string& formatted);
  void item(const std::string& term, const std::string& formatted);
  void verbatim(const std::vector<std::string>& lines);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool fresh_ = false;  ///< nothing stands below the last heading yet
};

struct File {
  std::string name;  ///< "mesopix-simulate.1"
  std::string text;
};

/// A page for the program and each of its commands, and mesopix-scene.5.
/// @param scene  text of a scene, for the example.
[[nodiscard]] std::vector<File> man_pages(const Command& program, const std::string& scene);

/// The one of the command.
[[nodiscard]] std::string command_man_page(const Command& command, const Command& program);

/// The one of scene files.
[[nodiscard]] std::string scene_man_page(const std::string& scene);

}  // namespace manual
