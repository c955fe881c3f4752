#include "apps/report/deflate.hpp"

#include <zlib.h>

#include <bit>
#include <stdexcept>

#include "apps/text/html.hpp"

namespace output {

static_assert(std::endian::native == std::endian::little);

std::string deflated_base64(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, from, bytes.size(), Z_DEFAULT_COMPRESSION) !=
      Z_OK)
    throw std::runtime_error("no memory to compress what the page shows");
  packed.resize(size);
  return base64(packed);
}

}  // namespace output
