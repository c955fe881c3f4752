#include "apps/specimen_input.hpp"

#include "apps/command.hpp"

namespace app {

Resolved resolve_input(const char* argument, const std::string& input, std::vector<Assignment> given) {
  const InputKind kind = kind_of_input(input);
  if (kind == InputKind::folder)
    throw Rejected(Exit::usage,
                   complaint(argument, input, "is a folder; must be a specimen, a scene or a picture"));
  if (kind == InputKind::scene) return resolve(read_scene_file(input), given);
  const char* key = kind == InputKind::hdf5 ? "specimen.file" : "specimen.picture";
  given.insert(given.begin(), given_as_option(key, Kind::path, argument, input));
  return resolve({}, given);
}

}  // namespace app
