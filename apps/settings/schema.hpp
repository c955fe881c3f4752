/// The one table of settings. Command line options, scene files, help, validation and the resolved scene all
/// come from it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/settings/codec.hpp"
#include "apps/settings/settings.hpp"
#include "apps/text/complaint.hpp"

namespace app {

/// A setting held in an object of type T (Settings, or mpm::Phase for the properties of every phase): its
/// key, what it may be, and how it is read into and written from the object.
template <class T>
struct FieldOf {
  std::string key;   ///< "loading.velocity"; "young" for a property of phases
  std::string help;  ///< one line, without the default
  Form form;
  std::function<void(T&, const Value&)> set;  ///< throws Mistake
  std::function<Value(const T&)> get;
};

/// @param access  pointer to the member of a T, or a generic lambda that gives it, const or not.
template <class T, class Codec, class Access>
FieldOf<T> make_field(std::string key, std::string help, Codec codec, Access access) {
  return {std::move(key), std::move(help), codec.form(),
          [codec, access](T& object, const Value& value) { std::invoke(access, object) = codec.read(value); },
          [codec, access](const T& object) { return codec.write(std::invoke(access, object)); }};
}

using Field = FieldOf<Settings>;
using PhaseField = FieldOf<mpm::Phase>;

/// A table of the scene file and a heading of the help.
struct Group {
  std::string name;           ///< "loading"
  std::string title;          ///< "Loading"
  std::string option_prefix;  ///< before the names of its short options: "itz-" for --itz-mode
};

/// In the order in which they are written.
[[nodiscard]] const std::vector<Group>& groups();

/// Every setting but those of the phases, group by group.
[[nodiscard]] const std::vector<Field>& fields();

/// Settings of earlier versions under the names that they had then: read, but never written.
[[nodiscard]] const std::vector<Field>& former_fields();

/// Those of a table; of phases none.
[[nodiscard]] std::vector<Field> fields_of(std::string_view group);

/// The properties of each phase, [phases.NAME].
[[nodiscard]] const std::vector<PhaseField>& phase_fields();

/// Labels have a byte, and one of them is void.
inline constexpr std::size_t most_phases = 255;

/// Letters, digits, _ and -, so that it can stand in keys and options.
[[nodiscard]] bool is_phase_name(std::string_view name);

/// Field of a key, "phases.NAME.PROPERTY" included.
[[nodiscard]] std::optional<Field> find_field(std::string_view key);

/// Whether a table of scenes has this name; that of [[ellipses]] is a list.
[[nodiscard]] bool is_group(std::string_view name);

/// The keys of all settings, of those of the phases that there are too.
[[nodiscard]] std::vector<std::string> every_key(const Settings& settings);

/// For an unknown key: the one that it seems to be, or the keys of its table.
[[nodiscard]] Suggestion suggest_key(std::string_view key, const Settings& settings);

/// "loading" of "loading.velocity"; "phases" of "phases.mortar.young"; "ellipses" of "ellipses[3].x".
[[nodiscard]] std::string group_of(std::string_view key);

/// "velocity" of "loading.velocity".
[[nodiscard]] std::string leaf_of(std::string_view key);

/// Whether a key, or a whole table, says what the specimen is made from.
[[nodiscard]] bool is_of_specimen(std::string_view key);

/// Whether it depends on a setting which others have an effect.
[[nodiscard]] bool decides_use(std::string_view key);

/// Why a setting has no effect with this method of solution; empty when it has one. A scene that is run by
/// both methods may hold the settings of both.
[[nodiscard]] std::string why_unused_by_method(std::string_view key, const mpm::Scene& scene);

/// Why a setting has no effect, in half a sentence; empty when it has one. A setting without effect that the
/// user gave is a mistake of theirs, and the resolved scene leaves it out.
[[nodiscard]] std::string why_unused(std::string_view key, const Settings& settings);

}  // namespace app
