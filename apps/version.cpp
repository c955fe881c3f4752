#include "apps/version.hpp"

namespace app {

const char* version() { return MESOPIX_VERSION; }

}  // namespace app
