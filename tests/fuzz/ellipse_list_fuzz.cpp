// Any text as a list of ellipses: it is refused with complaints, or a specimen can be drawn or refused.
#include "apps/scene/ellipse_list.hpp"
#include "specimen/body/error.hpp"
#include "specimen/body/specimen.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto ellipses = app::parse_ellipse_list({reinterpret_cast<const char*>(data), size}, "list.csv");
    (void)specimen::draw_ellipses(ellipses, 0.04, 0.03, 0.5e-3);
  } catch (const app::Rejected&) {
    return 0;  // refused, as it may be
  } catch (const specimen::Error&) {
    return 0;
  }
  return 0;
}
