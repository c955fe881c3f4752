/// Twins of one original, made, measured and written side by side.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/settings/settings.hpp"
#include "specimen/describe/misfit.hpp"
#include "specimen/picture/picture.hpp"
#include "specimen/describe/twin.hpp"

namespace app {

/// What twins are made from and called after.
struct TwinTask {
  std::string name;             ///< of the original, without its ending
  specimen::Specimen original;  ///< with its provenance
  Settings settings;            ///< of the scene to break twins in; its specimen is not looked at
  specimen::Descriptors descriptors;
  specimen::TwinPlan plan;
  specimen::ItzOptions itz;  ///< of the twins
  std::uint64_t seed = 1;    ///< of the first twin; the others have those after it
  int count = 0;
};

/// What is kept of a twin beside its file.
struct TwinRecord {
  std::uint64_t seed = 0;
  std::string file;  ///< its name in the folder
  specimen::Descriptors descriptors;
  bool relaxed = false;                          ///< plain placement was not enough
  int lost = 0;                                  ///< aggregates that hold no pixel centre
  specimen::Raster<specimen::Rgb> picture = {};  ///< of the first ones, else empty
};

inline constexpr std::size_t pictured_twins = 5;

/// "twin_001.h5".
[[nodiscard]] std::string twin_file(int number);

/// Make the twins on all cores and write each, with its preview, into the folder as soon as it is there.
/// @param stopped  asked before each twin.   @param made  told after each how many there are.
/// @return the twins in the order of their seeds; fewer when stopped.   @throws specimen::Error.
[[nodiscard]] std::vector<TwinRecord> make_twins(const TwinTask& task, const std::filesystem::path& folder,
                                                 const std::function<bool()>& stopped,
                                                 const std::function<void(std::size_t)>& made);

/// Descriptors of all twins.
[[nodiscard]] std::vector<specimen::Descriptors> descriptors_of(const std::vector<TwinRecord>& twins);

}  // namespace app
