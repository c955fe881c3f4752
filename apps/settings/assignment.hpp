/// Settings as the user wrote them, how they are applied, and what every exception means to who asked.
#pragma once

#include <exception>
#include <map>
#include <string>
#include <vector>

#include "apps/settings/codec.hpp"
#include "apps/settings/schema.hpp"
#include "apps/settings/settings.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"

namespace app {

/// @param option  its name, "stop-drop".   @throws Rejected (Exit::usage) for a text that the codec refuses.
template <class Codec>
[[nodiscard]] auto read_option(const char* option, const std::string& text, const Codec& codec) {
  try {
    return codec.read(from_command_line(Kind::integer, text));
  } catch (const Mistake& mistake) {
    throw Rejected(Exit::usage, option_name(option), text, mistake.allowed, mistake.cure);
  }
}

/// One setting that the user gave.
struct Assignment {
  std::string key;  ///< "loading.velocity"
  Value value;
  Place place;          ///< of the value in its file; empty on the command line
  std::string field;    ///< what messages call it: the key, or the option "--velocity"
  std::string written;  ///< the value as the user wrote it
};

/// A setting given as an option; `field` is the option as the user wrote it.
[[nodiscard]] Assignment given_as_option(std::string key, Kind kind, std::string field, std::string text);

using Origins = std::map<std::string, Assignment>;  ///< by key: what was given last

/// Apply one after the other, a later one wins; appends a complaint for each one that is refused.
void apply(const std::vector<Assignment>& assignments, Settings& settings,
           std::vector<Complaint>& complaints);

/// Complaints about settings that were given and have no effect, and about more than one source of the
/// specimen.
[[nodiscard]] std::vector<Complaint> check_use(const Origins& origins, const Settings& settings);

/// Names the keys of a scene file that have no effect with its method of solution and are left out; empty
/// when there are none. On the command line they are mistakes, see check_use().
[[nodiscard]] std::string note_of_left_out(const Origins& origins, const Settings& settings);

/// A complaint about a field of the libraries, at the place where the user set it.
[[nodiscard]] Complaint locate(const Origins& origins, Complaint complaint);
[[nodiscard]] Locate located_by(Origins origins);

/// The exception as a refusal, its complaints at the places where the user set what they are about. What none
/// of ours is becomes an internal error.   @pre there is an exception.
[[nodiscard]] Rejected refusal_of(const std::exception_ptr& exception, const Locate& locate = {});

}  // namespace app
