#include "apps/text/complaint.hpp"

#include <fmt/format.h>

#include "apps/text/utf8.hpp"

namespace app {
namespace {

/// A part of a complaint, cut where it is longer than anybody reads.
std::string shown(const std::string& part) {
  constexpr std::size_t longest = 2000;
  std::string text = printable(part.substr(0, longest));
  return part.size() > longest ? text + "..." : text;
}

std::string all_lines(const std::vector<Complaint>& complaints) {
  std::string lines;
  for (const Complaint& complaint : complaints) {
    if (!lines.empty()) lines += '\n';
    lines += text(complaint);
  }
  return lines;
}

}  // namespace

std::string text(const Place& place) {
  if (place.line == 0) return place.file;
  return fmt::format("{}:{}:{}", place.file, place.line, place.column);
}

std::string text(const Complaint& complaint) {
  std::string line;
  const char* separator = ": ";
  const auto append = [&](const std::string& part) {
    if (part.empty()) return;
    if (!line.empty()) line += separator;
    line += shown(part);
  };
  append(text(complaint.place));
  append(complaint.field);
  const std::size_t subject = line.size();
  for (const std::string* part : {&complaint.value, &complaint.defect, &complaint.allowed, &complaint.cure}) {
    if (line.size() > subject) separator = "; ";
    append(*part);
  }
  return line;
}

Complaint complaint(std::string field, std::string value, std::string allowed, std::string cure) {
  Complaint result;
  result.field = std::move(field);
  result.value = std::move(value);
  result.allowed = std::move(allowed);
  result.cure = std::move(cure);
  return result;
}

namespace {

std::string with_two_dashes(std::string name) { return "--" + name; }

std::string (*spelling_of_options)(std::string) = &with_two_dashes;

}  // namespace

std::string option_name(const std::string& name) { return spelling_of_options(name); }

void call_options_by(std::string (*spelling)(std::string name)) { spelling_of_options = spelling; }

std::string text(const Suggestion& suggestion) {
  return suggestion.meant.empty() ? suggestion.otherwise : "did you mean " + suggestion.meant + "?";
}

Complaint unknown_key(Place place, std::string key, const Suggestion& suggestion) {
  return {std::move(place), std::move(key), "", "", text(suggestion), "unknown key", suggestion.meant};
}

Rejected::Rejected(Exit exit_code, std::vector<Complaint> all)
    : std::runtime_error(all_lines(all)), code(exit_code), complaints(std::move(all)) {}

}  // namespace app
