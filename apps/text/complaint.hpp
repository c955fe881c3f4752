/// What the program says when it cannot do what was asked, and how it exits then.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/text/utf8.hpp"

namespace app {

/// Exit codes, after sysexits.h.
enum class Exit : int {
  ok = 0,
  usage = 64,        ///< the command line
  data = 65,         ///< a scene, a picture, a specimen, or physics gone wrong
  internal = 70,     ///< our own bug
  io = 74,           ///< a file could not be read or written
  interrupted = 75,  ///< come again: ended by the user, or another program is at it
};

/// Where in a file; line 0 = in the file as a whole, empty file = on the command line.
struct Place {
  std::string file;
  int line = 0;    ///< 1, 2, ...
  int column = 0;  ///< 1, 2, ...
  friend bool operator==(const Place&, const Place&) = default;
};

[[nodiscard]] std::string text(const Place& place);  ///< "scene.toml:3:8"

/// One mistake of the user. Its text is one line: "FILE:LINE:COL: field: value; defect; allowed; cure", the
/// empty parts left out.
struct Complaint {
  Place place;
  std::string field;        ///< as the user wrote it: a key of the scene, or an option
  std::string value;        ///< as the user wrote it
  std::string allowed;      ///< what would have been accepted
  std::string cure;         ///< what to try
  std::string defect = {};  ///< what is wrong where it is no value: "unknown key"
  std::string meant = {};   ///< of an unknown key: the key or table that it seems to be, where one does
};

/// Each part cut at 2000 bytes.
[[nodiscard]] std::string text(const Complaint& complaint);

/// Complaints about one file that are kept; where there are so many, its reader goes no further.
inline constexpr std::size_t most_complaints = 100;

/// A complaint about the command line, or about something that has no place in a file.
[[nodiscard]] Complaint complaint(std::string field, std::string value, std::string allowed,
                                  std::string cure = {});

/// What users call an option: "--stop-drop", or what it is called where they write no command lines.
[[nodiscard]] std::string option_name(const std::string& name);

/// From now on options are called so in this process.   @param spelling  of the name without dashes before
/// it.
void call_options_by(std::string (*spelling)(std::string name));

/// What there is in place of a name that nothing has.
struct Suggestion {
  std::string meant;      ///< the name that it seems to be; empty = none is near
  std::string otherwise;  ///< what to tell then
};

[[nodiscard]] std::string text(const Suggestion& suggestion);  ///< "did you mean loading.velocity?"

[[nodiscard]] Complaint unknown_key(Place place, std::string key, const Suggestion& suggestion);

/// Gives a complaint about a field the place where the user set it.
using Locate = std::function<Complaint(Complaint)>;

/// The command was refused: every complaint there is, and the exit code.
struct Rejected : std::runtime_error {
  Rejected(Exit exit_code, std::vector<Complaint> all);
  Rejected(Exit exit_code, Complaint one) : Rejected(exit_code, std::vector{std::move(one)}) {}
  /// With one that has no place in a file, as complaint() makes it.
  Rejected(Exit exit_code, std::string field, std::string value, std::string allowed, std::string cure = {})
      : Rejected(exit_code,
                 complaint(std::move(field), std::move(value), std::move(allowed), std::move(cure))) {}
  Exit code;
  std::vector<Complaint> complaints;
};

/// A value that a reader cannot accept; who knows the field and its place makes a Complaint of it.
struct Mistake : std::runtime_error {
  explicit Mistake(std::string what_is_allowed, std::string how_to_cure = {})
      : std::runtime_error(what_is_allowed),
        allowed(std::move(what_is_allowed)),
        cure(std::move(how_to_cure)) {}
  std::string allowed;
  std::string cure;
};

}  // namespace app
