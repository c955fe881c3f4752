/// The charts of a specimen.
#pragma once

#include <vector>

#include "apps/drawing/chart.hpp"
#include "specimen/body/specimen.hpp"

namespace output {

/// Sieve curve of the aggregates by area [%] against diameter [mm]; without series when there are none.
[[nodiscard]] Chart sieve_chart(const specimen::Specimen& specimen);

/// The sieve curves of DIN 1045-2 and of Fuller between the sizes of the specimen, and Fuller's in a plane
/// cut after Walraven.
[[nodiscard]] std::vector<Series> sieve_references(const specimen::Specimen& specimen);

}  // namespace output
