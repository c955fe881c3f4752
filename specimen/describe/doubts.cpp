#include "specimen/describe/doubts.hpp"

#include <algorithm>
#include <cstdint>

#include "specimen/body/measure.hpp"

namespace specimen {
namespace {

bool is_made_to_order(const Provenance& provenance) {
  return provenance.source == "generated" || provenance.source == "ellipse list";
}

void doubt_phases(const LabelledMask& mask, std::vector<std::string>& doubts) {
  constexpr double most_void = 0.3, most_aggregate = 0.8;
  const std::vector<std::int64_t> counts = count_labels(mask);
  const auto whole = static_cast<double>(mask.labels.size());
  const auto count_of = [&](std::uint8_t label) {
    return label < counts.size() ? static_cast<double>(counts[label]) : 0;
  };
  if (const double pixels = count_of(phase::void_); pixels > most_void * whole)
    doubts.push_back(share_text(pixels, whole) + " of the area is void");
  if (const double pixels = count_of(phase::aggregate); pixels > most_aggregate * whole)
    doubts.push_back(share_text(pixels, whole) + " of the area is aggregate");
}

void doubt_aggregates(const Specimen& specimen, std::vector<std::string>& doubts) {
  constexpr double most_of_one = 0.5, few_pixels = 9.5;
  constexpr std::int64_t most_specks = 2000;
  if (specimen.inclusions.empty()) {
    doubts.emplace_back("there is no aggregate");
    return;
  }
  const double whole = specimen.mask.width() * specimen.mask.height();
  const double pixel = specimen.mask.pixel_size * specimen.mask.pixel_size;
  double largest = 0;
  std::int64_t specks = 0;
  for (const Inclusion& inclusion : specimen.inclusions) {
    largest = std::max(largest, inclusion.area);
    specks += inclusion.area < few_pixels * pixel;
  }
  if (largest > most_of_one * whole)
    doubts.push_back("one aggregate takes " + share_text(largest, whole) + " of the area");
  if (specks > most_specks) doubts.push_back(counted(specks, "aggregate") + " have at most nine pixels each");
}

void doubt_size(const LabelledMask& mask, std::vector<std::string>& doubts) {
  constexpr double least = 2e-3, most = 10;  // [m]
  if (mask.width() < least || mask.width() > most)
    doubts.push_back("the specimen is " +
                     (mask.width() > most ? short_number(mask.width()) + " m" : length_text(mask.width())) +
                     " wide");
}

}  // namespace

std::vector<std::string> doubts_of(const Specimen& specimen) {
  std::vector<std::string> doubts;
  if (is_made_to_order(specimen.provenance)) return doubts;
  doubt_phases(specimen.mask, doubts);
  doubt_aggregates(specimen, doubts);
  doubt_size(specimen.mask, doubts);
  doubts.insert(doubts.begin(), specimen.provenance.warnings.begin(), specimen.provenance.warnings.end());
  for (std::string& doubt : doubts) doubt += "; look at the specimen before you trust a result";
  return doubts;
}

}  // namespace specimen
