#include "apps/settings/assignment.hpp"

#include <array>
#include <filesystem>
#include <new>

#include "apps/system/files.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"
#include "specimen/convert/convert.hpp"

namespace app {
namespace {

template <class Error>
Complaint complaint_of(const Error& error) {
  return complaint(error.field, error.value, error.allowed, error.cure);
}

std::vector<Complaint> complaints_of(const std::vector<mpm::FileError>& files) {
  std::vector<Complaint> complaints;
  for (const mpm::FileError& file : files) complaints.push_back(complaint_of(file));
  return complaints;
}

Rejected unplaced(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const Rejected& rejected) {
    return rejected;
  } catch (const specimen::NoScale& error) {
    Complaint unscaled = complaint_of(error);
    unscaled.cure = "give " + option_name("pixel-size") + " 0.5mm or " + option_name("width") + " 150mm";
    return {Exit::data, unscaled};
  } catch (const specimen::TwoReadings& error) {
    Complaint two = complaint_of(error);
    const auto choice = [](const std::string& phases) {
      return option_name("label-phases") + " " + shell_word(phases);
    };
    two.cure = "give " + choice(error.label_phases.at(0)) + " or " + choice(error.label_phases.at(1));
    return {Exit::data, two};
  } catch (const specimen::Error& error) {
    return {error.fault == specimen::Fault::write ? Exit::io : Exit::data, complaint_of(error)};
  } catch (const NotWritten& missing) {
    return {Exit::io, complaints_of(missing.files)};
  } catch (const mpm::FileError& error) {
    return {Exit::io, complaint_of(error)};
  } catch (const mpm::Error& error) {
    return {Exit::data, complaint_of(error)};
  } catch (const std::filesystem::filesystem_error& error) {
    return {Exit::io, "", error.what(), ""};
  } catch (const std::bad_alloc&) {
    return {Exit::data, "memory", "not enough", "", "use fewer, larger pixels"};
  } catch (const std::exception& error) {
    return {Exit::internal, "internal error", error.what(), "", "please report it"};
  }
}

}  // namespace

Rejected refusal_of(const std::exception_ptr& exception, const Locate& locate) {
  Rejected found = unplaced(exception);
  if (!locate) return found;
  std::vector<Complaint> placed;
  for (const Complaint& complaint : found.complaints) placed.push_back(locate(complaint));
  return {found.code, std::move(placed)};
}

namespace {

Complaint about(const Assignment& given, std::string allowed, std::string cure = {}) {
  return {given.place, given.field, given.written, std::move(allowed), std::move(cure)};
}

void apply_one(const Assignment& given, Settings& settings, std::vector<Complaint>& complaints) {
  const auto field = find_field(given.key);
  if (!field) {
    complaints.push_back(unknown_key(given.place, given.field, suggest_key(given.key, settings)));
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
  for (const auto& [key, given] : origins) {
    const bool in_file = !given.place.file.empty();
    if (in_file && !why_unused_by_method(key, settings.scene).empty()) continue;  // see note_of_left_out()
    if (const std::string reason = why_unused(key, settings); !reason.empty())
      complaints.push_back(about(given, reason, "remove it"));
  }
  return complaints;
}

std::string note_of_left_out(const Origins& origins, const Settings& settings) {
  std::vector<std::string> keys;
  std::string reason;
  for (const auto& [key, given] : origins)
    if (const std::string why = why_unused_by_method(key, settings.scene); !why.empty()) {
      keys.push_back(key);
      reason = why;  // the same for all of them
    }
  return keys.empty() ? "" : "left out, for each " + reason + ": " + listed(keys, "and");
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

Locate located_by(Origins origins) {
  return
      [origins = std::move(origins)](Complaint complaint) { return locate(origins, std::move(complaint)); };
}

}  // namespace app
