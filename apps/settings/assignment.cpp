#include "apps/settings/assignment.hpp"

#include <array>

namespace app {
namespace {

Complaint about(const Assignment& given, std::string allowed, std::string cure = {}) {
  return {given.place, given.field, given.written, std::move(allowed), std::move(cure)};
}

void apply_one(const Assignment& given, Settings& settings, std::vector<Complaint>& complaints) {
  const auto field = find_field(given.key);
  if (!field) {
    complaints.push_back({given.place, given.field, "unknown key", suggest_key(given.key, settings), {}});
    return;
  }
  try {
    field->set(settings, given.value);
  } catch (const Mistake& mistake) {
    complaints.push_back(about(given, mistake.allowed, mistake.cure));
  }
}

void check_sources(const Origins& origins, const Settings& settings, std::vector<Complaint>& complaints) {
  const SpecimenChoice& choice = settings.specimen;
  const std::array<std::pair<const char*, bool>, 4> sources{{{"specimen.file", !choice.file.empty()},
                                                             {"specimen.picture", !choice.picture.empty()},
                                                             {"specimen.ellipses", !choice.ellipses.empty()},
                                                             {"ellipses", !choice.ellipse_list.empty()}}};
  const char* first = nullptr;
  for (const auto& [key, given] : sources) {
    if (!given) continue;
    if (first != nullptr)
      complaints.push_back(
          locate(origins, complaint(key, std::string("given beside ") + first,
                                    "a specimen has one source: file, picture, ellipses, or none of "
                                    "them for random aggregates")));
    first = key;
  }
}

}  // namespace

Assignment given_as_option(std::string key, Kind kind, std::string field, std::string text) {
  Assignment given;
  given.key = std::move(key);
  given.value = from_command_line(kind, text);
  given.field = std::move(field);
  given.written = std::move(text);
  return given;
}

void apply(const std::vector<Assignment>& assignments, Settings& settings,
           std::vector<Complaint>& complaints) {
  for (const Assignment& given : assignments) apply_one(given, settings, complaints);
}

std::vector<Complaint> check_use(const Origins& origins, const Settings& settings) {
  std::vector<Complaint> complaints;
  check_sources(origins, settings, complaints);
  for (const auto& [key, given] : origins)
    if (const std::string reason = why_unused(key, settings); !reason.empty())
      complaints.push_back(about(given, reason, "remove it"));
  return complaints;
}

Complaint locate(const Origins& origins, Complaint complaint) {
  if (const auto found = origins.find(complaint.field); found != origins.end()) {
    complaint.place = found->second.place;
    complaint.field = found->second.field;
    return complaint;
  }
  // About a table, such as phases.mortar, or what is not given in it: where its first setting stands.
  std::string table = complaint.field + ".";
  const std::size_t dot = complaint.field.rfind('.');
  if (dot != complaint.field.find('.')) table = complaint.field.substr(0, dot + 1);
  const auto first = origins.lower_bound(table);
  if (first != origins.end() && first->first.rfind(table, 0) == 0) complaint.place = first->second.place;
  return complaint;
}

}  // namespace app
