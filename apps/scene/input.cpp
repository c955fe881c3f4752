#include "apps/scene/input.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "apps/system/files.hpp"

namespace app {

InputKind kind_of_input(const std::string& path) {
  if (std::filesystem::is_directory(path)) return InputKind::folder;
  require_regular_file(path);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Rejected(Exit::io, path, std::generic_category().message(errno), "must be a file that can be read");
  std::array<char, 8> start{};
  stream.read(start.data(), start.size());
  using namespace std::string_view_literals;
  if (std::string_view(start.data(), start.size()) == "\x89HDF\r\n\x1a\n"sv) return InputKind::hdf5;
  return std::filesystem::path(path).extension() == ".toml" ? InputKind::scene : InputKind::picture;
}

Resolved resolve_ellipses(const std::string& path, const std::vector<Assignment>& given) {
  const SceneFile scene = path.empty() ? SceneFile() : read_scene_file(path);
  Resolved resolved = resolve(scene, given);
  const Source source = source_of(resolved.settings);
  if (source != Source::file && source != Source::picture) return resolved;
  const bool picture = source == Source::picture;
  throw Rejected(Exit::data, locate(resolved.origins,
                                    complaint(picture ? "specimen.picture" : "specimen.file", "given",
                                              "generate draws ellipses",
                                              picture ? "use mesopix convert" : "it is a specimen already")));
}

Resolved resolve_picture(const std::string& input, std::vector<Assignment> given) {
  if (kind_of_input(input) != InputKind::scene) {
    given.insert(given.begin(), given_as_option("specimen.picture", Kind::path, "PICTURE", input));
    return resolve({}, given);
  }
  Resolved resolved = resolve(read_scene_file(input), given);
  if (source_of(resolved.settings) == Source::picture) return resolved;
  throw Rejected(Exit::data, input, "has no specimen.picture", "convert needs a picture",
                 "use mesopix generate for ellipses");
}

Resolved resolve_input(const char* argument, const std::string& input, std::vector<Assignment> given) {
  const InputKind kind = kind_of_input(input);
  if (kind == InputKind::folder)
    throw Rejected(Exit::usage, argument, input, "is a folder; must be a specimen, a scene or a picture");
  if (kind == InputKind::scene) return resolve(read_scene_file(input), given);
  const char* key = kind == InputKind::hdf5 ? "specimen.file" : "specimen.picture";
  given.insert(given.begin(), given_as_option(key, Kind::path, argument, input));
  return resolve({}, given);
}

Resolved resolve_scene(const std::string& input, const std::vector<Assignment>& given) {
  if (kind_of_input(input) != InputKind::scene)
    throw Rejected(Exit::usage, "SCENE", input, "must be a scene, scene.toml",
                   "mesopix simulate INPUT --print-scene writes one");
  return resolve(read_scene_file(input), given);
}

}  // namespace app
