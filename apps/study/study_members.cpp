#include "apps/study/study_members.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

#include "apps/scene/scene_text.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/study/study_points.hpp"
#include "apps/study/study_values.hpp"
#include "specimen/body/digest.hpp"
#include "specimen/body/error.hpp"

namespace app {
namespace {

constexpr std::size_t most_members = 100'000;
constexpr std::size_t id_digits = 16;

/// What the member sets, as if it had been given behind the scene.
std::vector<Assignment> assignments_of(const Study& study, const Member& member) {
  std::vector<Assignment> all;
  const auto& parameters = study.plan.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const Field& field : parameters[i].fields)
      all.push_back({field.key, member.values[i], parameters[i].place, "vary." + parameters[i].name,
                     toml_text(member.values[i])});
  if (member.seed)
    for (const std::string& table : study.plan.seed_of)
      all.push_back({table + ".seed",
                     {static_cast<std::int64_t>(*member.seed)},
                     study.plan.seed_of_place,
                     "seed_of",
                     "\"" + table + "\""});
  return all;
}

/// The source of a specimen, settled: files are read once, whatever the number of members.
SpecimenChoice settled(const Settings& settings) {
  static std::mutex mutex;
  static std::map<std::array<std::string, 4>, SpecimenChoice> known;
  const SpecimenChoice& choice = settings.specimen;
  if (choice.file.empty() && choice.picture.empty() && choice.ellipses.empty()) return choice;
  const std::scoped_lock lock(mutex);
  const std::array key{choice.file, choice.picture, choice.ellipses, choice.sha256};
  if (const auto found = known.find(key); found != known.end()) return found->second;
  Settings copy = settings;
  settle_source(copy);
  return known[key] = copy.specimen;
}

std::string without_folder(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Sizes of aggregates that no specimen can have.
void check_grading(const Settings& settings) {
  if (source_of(settings) == Source::generated) (void)packing_options(settings);
}

/// Fills in the id.
void check(const Study& study, Member& member) {
  try {
    const Settings settings = member_settings(study, member);
    check_grading(settings);
    member.id = specimen::sha256_of_text(member_scene(settings)).substr(0, id_digits);
  } catch (const Rejected& rejected) {
    refuse_member(study, member, rejected.complaints);
  } catch (const specimen::Error& error) {
    refuse_member(study, member, {complaint(error.field, error.value, error.allowed, error.cure)});
  }
}

/// A member that is the same run as another one tells nothing new.
void refuse_repetition(const Study& study, const Member& member,
                       std::map<std::string, std::size_t>& numbers) {
  const auto [first, is_new] = numbers.emplace(member.id, member.number);
  if (!is_new)
    refuse_member(study, member,
                  {complaint("study", fmt::format("the same run as member {}", first->second),
                             "members must differ in what their results depend on: not the title, threads or "
                             "frames",
                             "vary something else, or take fewer samples")});
}

void check_count(std::size_t points, std::size_t seeds) {
  if (points * seeds <= most_members) return;
  throw Rejected(Exit::data, complaint("study", fmt::format("{} points with {} seeds each", points, seeds),
                                       fmt::format("must have at most {} members", most_members),
                                       "take fewer of either"));
}

}  // namespace

std::vector<Member> list_members(const Study& study) {
  const std::vector<std::vector<Value>> points = points_of(study.plan);
  std::vector<std::optional<std::uint64_t>> seeds(study.plan.seeds.begin(), study.plan.seeds.end());
  if (seeds.empty()) seeds.emplace_back();
  check_count(points.size(), seeds.size());
  std::vector<Member> members;
  std::map<std::string, std::size_t> numbers;
  for (const auto& seed : seeds)
    for (std::size_t point = 0; point < points.size(); ++point) {
      members.push_back({members.size(), point, points[point], seed, {}});
      check(study, members.back());
      refuse_repetition(study, members.back(), numbers);
    }
  return members;
}

Settings member_settings(const Study& study, const Member& member) {
  Settings settings = resolve(study.base, assignments_of(study, member)).settings;
  settings.scene.threads = 1;
  settings.scene.frames = 0;
  settings.specimen = settled(settings);
  return settings;
}

std::string member_scene(Settings settings) {
  settings.title.clear();
  settings.specimen.file = without_folder(settings.specimen.file);
  settings.specimen.picture = without_folder(settings.specimen.picture);
  return scene_text(settings, Extent::whole, {});
}

void refuse_member(const Study& study, const Member& member, std::vector<Complaint> complaints) {
  for (Complaint& complaint : complaints)
    complaint.value += (complaint.value.empty() ? "in " : ", in ") + name_of(study, member);
  throw Rejected(Exit::data, std::move(complaints));
}

std::string name_of(const Study& study, const Member& member) {
  std::string values;
  for (std::size_t i = 0; i < member.values.size(); ++i)
    values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", study.plan.parameters[i].name,
                          text_of(study.plan.parameters[i], member.values[i]));
  if (member.seed) values += fmt::format("{}seed {}", values.empty() ? "" : ", ", *member.seed);
  return fmt::format("member {}{}", member.number, values.empty() ? "" : " (" + values + ")");
}

}  // namespace app
