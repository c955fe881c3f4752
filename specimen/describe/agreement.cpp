#include "specimen/describe/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "specimen/body/error.hpp"

namespace specimen {
namespace {

std::string shape_text(const LabelledMask& mask) {
  return std::to_string(mask.labels.cols) + " x " + std::to_string(mask.labels.rows) + " px";
}

/// 1 for the pixels of a phase that have a neighbour across an edge which is of another phase.
Raster<std::uint8_t> boundary_of(const Raster<std::uint8_t>& labels, std::uint8_t label) {
  Raster<std::uint8_t> boundary(labels.rows, labels.cols, 0);
  const auto differs = [&](int r, int c) { return labels.contains(r, c) && labels(r, c) != label; };
  for (int r = 0; r < labels.rows; ++r)
    for (int c = 0; c < labels.cols; ++c)
      if (labels(r, c) == label)
        boundary(r, c) = differs(r - 1, c) || differs(r + 1, c) || differs(r, c - 1) || differs(r, c + 1);
  return boundary;
}

/// Offsets of the pixels within a distance of one.
std::vector<std::pair<int, int>> disc_of(int radius) {
  std::vector<std::pair<int, int>> offsets;
  for (int r = -radius; r <= radius; ++r)
    for (int c = -radius; c <= radius; ++c)
      if (r * r + c * c <= radius * radius) offsets.emplace_back(r, c);
  return offsets;
}

/// Share of the pixels of `one` that have one of `other` within the offsets; NaN without any.
double share_near(const Raster<std::uint8_t>& one, const Raster<std::uint8_t>& other,
                  const std::vector<std::pair<int, int>>& offsets) {
  double all = 0, near = 0;
  for (int r = 0; r < one.rows; ++r)
    for (int c = 0; c < one.cols; ++c) {
      if (one(r, c) == 0) continue;
      ++all;
      near += std::any_of(offsets.begin(), offsets.end(), [&](const auto& offset) {
        const int row = r + offset.first, col = c + offset.second;
        return other.contains(row, col) && other(row, col) != 0;
      });
    }
  return all > 0 ? near / all : not_known;
}

/// NaN where neither has a boundary; 0 where only one has.
double boundary_agreement(const Raster<std::uint8_t>& found, const Raster<std::uint8_t>& reference,
                          std::uint8_t label, const std::vector<std::pair<int, int>>& offsets) {
  const auto a = boundary_of(found, label), b = boundary_of(reference, label);
  const double precision = share_near(a, b, offsets), recall = share_near(b, a, offsets);
  if (std::isnan(precision) && std::isnan(recall)) return not_known;
  if (std::isnan(precision) || std::isnan(recall) || precision + recall == 0) return 0;
  return 2 * precision * recall / (precision + recall);
}

double phase_agreement(const Raster<std::uint8_t>& found, const Raster<std::uint8_t>& reference,
                       std::uint8_t label) {
  double both = 0, either = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool a = found.data[i] == label, b = reference.data[i] == label;
    both += a && b ? 1 : 0;
    either += a || b ? 1 : 0;
  }
  return either > 0 ? both / either : not_known;
}

void match_aggregates(const Raster<std::int32_t>& found, const Raster<std::int32_t>& reference,
                      Agreement& agreement) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> common;
  std::map<std::int32_t, double> area_found, area_reference;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::int32_t a = found.data[i], b = reference.data[i];
    if (a != 0) ++area_found[a];
    if (b != 0) ++area_reference[b];
    if (a != 0 && b != 0) ++common[{a, b}];
  }
  double sum = 0;
  for (const auto& [ids, both] : common) {
    const double share = both / (area_found[ids.first] + area_reference[ids.second] - both);
    if (share <= 0.5) continue;  // above a half an aggregate can have one match only
    sum += share;
    ++agreement.matched;
  }
  agreement.extra = static_cast<std::int64_t>(area_found.size()) - agreement.matched;
  agreement.missed = static_cast<std::int64_t>(area_reference.size()) - agreement.matched;
  const double all =
      static_cast<double>(agreement.matched) + static_cast<double>(agreement.extra + agreement.missed) / 2;
  agreement.panoptic_quality = all > 0 ? sum / all : not_known;
}

}  // namespace

Agreement agreement_of(const Segmented& found, const Segmented& reference, int tolerance) {
  const auto &a = found.mask.labels, &b = reference.mask.labels;
  if (a.rows != b.rows || a.cols != b.cols)
    throw Error("reference", shape_text(reference.mask), "the mask has " + shape_text(found.mask),
                "convert both to the same pixels");
  const auto offsets = disc_of(tolerance);
  Agreement agreement;
  const std::size_t labels = std::max(found.mask.phases.size(), reference.mask.phases.size());
  for (std::size_t label = 0; label < labels; ++label) {
    const auto one = static_cast<std::uint8_t>(label);
    agreement.phases.push_back({phase_agreement(a, b, one), boundary_agreement(a, b, one, offsets)});
  }
  match_aggregates(found.instances, reference.instances, agreement);
  return agreement;
}

}  // namespace specimen
