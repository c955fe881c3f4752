/// The runs that a study consists of, and where they lie in the space of its parameters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/study/study.hpp"

namespace app {

/// Points of Sobol's sequence in [0, 1)^dimensions from its point 1 on, one behind the other. More points
/// begin with the same ones. At most 1000 dimensions.
/// Source: Joe and Kuo (2008), Constructing Sobol sequences with better two-dimensional projections.
[[nodiscard]] std::vector<std::vector<double>> sobol_points(std::size_t dimensions, std::size_t count);

/// Points of a Latin hypercube in [0, 1)^dimensions: along each axis one point lies in each of `count`
/// strata, anywhere in it. The same on every machine.
/// Source: McKay, Beckman, Conover (1979).
[[nodiscard]] std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                               std::uint64_t seed);

/// Values of the parameters at every point of a plan, point by point: one point without values where only
/// seeds vary. Of a grid the last parameter changes first.
/// @throws Rejected (Exit::data) for a grid of more than 100 000 points.
[[nodiscard]] std::vector<std::vector<Value>> points_of(const StudyPlan& plan);

/// One run of a study.
struct Member {
  std::size_t number = 0;             ///< 0, 1, ...: all points with the first seed, all with the next ...
  std::size_t point = 0;              ///< in the space of the parameters
  std::vector<Value> values;          ///< of the parameters, in their order
  std::optional<std::uint64_t> seed;  ///< none: the seeds of the scene
  /// Those of the scene with its values and seed, to run on one thread, without frames; settled: a file that
  /// the specimen is read from is pinned by its SHA-256.
  std::shared_ptr<const Settings> settings = {};
  std::string id = {};  ///< identity_of() its settings
};

/// Every member, found valid as far as can be told without its specimen.
/// @param begun  the members of the study when it had fewer seeds; they stay as they are.
/// @throws Rejected (Exit::data) naming the first member that is not valid, and its values.
[[nodiscard]] std::vector<Member> list_members(const Study& study, std::vector<Member> begun = {});

/// The resolved scene of a member's settings, without a title and the folders of its files, as its result
/// keeps it.
[[nodiscard]] std::string member_scene(Settings settings);

/// What a result depends on, and no more: the version of the program and scene_values() without the title.
[[nodiscard]] std::string identity_text(Settings settings);

/// 16 hexadecimal digits of the SHA-256 of identity_text().
[[nodiscard]] std::string identity_of(const Settings& settings);

/// Of the rules that identity_text() follows: members that were kept by other rules have another identity.
inline constexpr int identity_format = 2;

/// "member 17 (loading.velocity = 0.05 m/s, seed 3)".
[[nodiscard]] std::string name_of(const Study& study, const Member& member);

/// Refuse the whole study for the sake of a member.   @throws Rejected (Exit::data).
[[noreturn]] void refuse_member(const Study& study, const Member& member, std::vector<Complaint> complaints);

}  // namespace app
