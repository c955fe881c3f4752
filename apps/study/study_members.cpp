#include "apps/study/study_members.hpp"

#include <fmt/format.h>
#include <array>
#include <boost/random/sobol.hpp>
#include <filesystem>
#include <map>
#include <mutex>
#include <numeric>
#include <utility>

#include "apps/job/specimen_source.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/study/study_values.hpp"
#include "apps/text/version.hpp"
#include "specimen/body/error.hpp"
#include "specimen/body/files.hpp"
#include "specimen/body/raster.hpp"

namespace app {
namespace {

constexpr double most_points = 100'000;

std::vector<std::vector<Value>> grid(const StudyPlan& plan) {
  double count = 1;
  for (const StudyParameter& parameter : plan.parameters)
    count *= static_cast<double>(parameter.levels.size());
  if (count > most_points)
    throw Rejected(Exit::data,
                   {plan.parameters.front().place, "vary", fmt::format("a grid of {:.0f} points", count),
                    fmt::format("must have at most {:.0f}", most_points),
                    "choose sampling = \"sobol\" and a number of samples"});
  std::vector<std::vector<Value>> points{{}};
  for (const StudyParameter& parameter : plan.parameters) {
    std::vector<std::vector<Value>> finer;
    for (const std::vector<Value>& point : points)
      for (const Value& level : parameter.levels) {
        finer.push_back(point);
        finer.back().push_back(level);
      }
    points = std::move(finer);
  }
  return points;
}

}  // namespace

std::vector<std::vector<double>> sobol_points(std::size_t dimensions, std::size_t count) {
  boost::random::sobol sequence(dimensions);  // it leaves out its point 0, the origin, by itself
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (std::vector<double>& point : points)
    for (double& u : point) u = static_cast<double>(sequence()) * 0x1p-64;
  return points;
}

std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                 std::uint64_t seed) {
  specimen::Random random(seed);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  std::vector<std::size_t> strata(count);
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    std::iota(strata.begin(), strata.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)  // Fisher and Yates
      std::swap(strata[i - 1], strata[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
    for (std::size_t i = 0; i < count; ++i)
      points[i][axis] = (static_cast<double>(strata[i]) + random.uniform()) / static_cast<double>(count);
  }
  return points;
}

std::vector<std::vector<Value>> points_of(const StudyPlan& plan) {
  if (plan.sampling == Sampling::grid) return grid(plan);
  const std::size_t dimensions = plan.parameters.size();
  const auto count = static_cast<std::size_t>(plan.samples);
  const auto places = plan.sampling == Sampling::sobol
                          ? sobol_points(dimensions, count)
                          : latin_hypercube(dimensions, count, plan.sampling_seed);
  std::vector<std::vector<Value>> points;
  for (const std::vector<double>& place : places) {
    points.emplace_back();
    for (std::size_t axis = 0; axis < dimensions; ++axis)
      points.back().push_back(value_at_place(plan.parameters[axis], place[axis]));
  }
  return points;
}

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

/// Fills in the settings and the id.
void settle(const Study& study, Member& member) {
  try {
    Settings settings = resolve_over(study.base, assignments_of(study, member)).settings;
    settings.scene.threads = 1;
    settings.scene.frames = 0;
    settings.specimen = settled(settings);
    check_grading(settings);
    member.id = identity_of(settings);
    member.settings = std::make_shared<const Settings>(std::move(settings));
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
  throw Rejected(Exit::data, "study", fmt::format("{} points with {} seeds each", points, seeds),
                 fmt::format("must have at most {} members", most_members), "take fewer of either");
}

}  // namespace

std::vector<Member> list_members(const Study& study, std::vector<Member> begun) {
  const std::vector<std::vector<Value>> points = points_of(study.plan);
  std::vector<std::optional<std::uint64_t>> seeds(study.plan.seeds.begin(), study.plan.seeds.end());
  if (seeds.empty()) seeds.emplace_back();
  check_count(points.size(), seeds.size());
  std::vector<Member> members = std::move(begun);
  std::map<std::string, std::size_t> numbers;
  for (const Member& member : members) numbers.emplace(member.id, member.number);
  while (members.size() < points.size() * seeds.size()) {
    const std::size_t number = members.size(), point = number % points.size();
    members.push_back({number, point, points[point], seeds[number / points.size()]});
    settle(study, members.back());
    refuse_repetition(study, members.back(), numbers);
  }
  return members;
}

std::string member_scene(Settings settings) {
  settings.title.clear();
  settings.specimen.file = without_folder(settings.specimen.file);
  settings.specimen.picture = without_folder(settings.specimen.picture);
  return scene_text(settings, Extent::whole, {});
}

std::string identity_text(Settings settings) {
  settings.title.clear();
  return std::string("mesopix = ") + version() + "\n" + scene_values(settings, Extent::whole);
}

std::string identity_of(const Settings& settings) {
  return specimen::sha256_of_text(identity_text(settings)).substr(0, id_digits);
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
