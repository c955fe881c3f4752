// Any text as a scene: it is refused with complaints, or it can be written down and says the same again.
#include <cstdlib>

#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/text/complaint.hpp"

namespace {

std::string resolved_text(const std::string& text) {
  const app::Resolved resolved = app::resolve(app::parse_scene(text, "/scene.toml"), {});
  return app::scene_text(resolved.settings, app::Extent::whole, "/");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string once;
  try {
    once = resolved_text({reinterpret_cast<const char*>(data), size});
  } catch (const app::Rejected&) {
    return 0;  // refused, as it may be
  }
  if (resolved_text(once) != once) std::abort();
  return 0;
}
