/// The runs that a study consists of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/study/study.hpp"

namespace app {

/// One run of a study.
struct Member {
  std::size_t number = 0;             ///< 0, 1, ...: all points with the first seed, all with the next ...
  std::size_t point = 0;              ///< in the space of the parameters
  std::vector<Value> values;          ///< of the parameters, in their order
  std::optional<std::uint64_t> seed;  ///< none: the seeds of the scene
  std::string id;                     ///< 16 hexadecimal digits of the SHA-256 of member_scene()
};

/// Every member, found valid as far as can be told without its specimen.
/// @throws Rejected (Exit::data) naming the first member that is not, and its values.
[[nodiscard]] std::vector<Member> list_members(const Study& study);

/// Settings of a member: those of the scene with its values and seed, to run on one thread, without frames.
/// Settled: a file that the specimen is read from is pinned by its SHA-256.
/// @throws Rejected.
[[nodiscard]] Settings member_settings(const Study& study, const Member& member);

/// The resolved scene of a member's settings, without a title and the folders of its files: what its result
/// depends on, and no more.
[[nodiscard]] std::string member_scene(Settings settings);

/// "member 17 (loading.velocity = 0.05 m/s, seed 3)".
[[nodiscard]] std::string name_of(const Study& study, const Member& member);

/// Refuse the whole study for the sake of a member.   @throws Rejected (Exit::data).
[[noreturn]] void refuse_member(const Study& study, const Member& member, std::vector<Complaint> complaints);

}  // namespace app
