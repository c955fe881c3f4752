/// Archives in the format ZIP.
#pragma once

#include <string>
#include <vector>

#include "apps/export/roi.hpp"

namespace exchange {

/// Files as an archive, in their order, compressed, with no date of its own: the same files give the same
/// bytes.
/// @throws specimen::Error (Fault::write) naming `path`, under which it is to be kept.
[[nodiscard]] std::string zipped(const std::string& path, const std::vector<NamedBytes>& files);

}  // namespace exchange
