/// Twins of one original, made, measured and written side by side, from the wish for them as texts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/settings/offer.hpp"
#include "apps/settings/settings.hpp"
#include "specimen/describe/misfit.hpp"
#include "specimen/describe/twin.hpp"
#include "specimen/picture/picture.hpp"

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

/// Options of twin; empty = not given.
struct TwinWish {
  std::string count = "10";
  std::string seed = "1";
  std::string width;
  std::string height;
  std::string pixel_size;
  std::string gap = "auto";
  std::string border = "auto";
};

/// @throws Rejected (Exit::usage).
[[nodiscard]] specimen::TwinOptions twin_options(const TwinWish& wish);

/// @param input  path of the original: twins are called after its stem.   @param itz  of the twins.
/// @throws Rejected for a wish that cannot be read and for an original that tells of no inclusions;
/// specimen::Error.
[[nodiscard]] TwinTask make_twin_task(const TwinWish& wish, const std::string& input,
                                      const Settings& settings, const specimen::ItzOptions& itz,
                                      specimen::Specimen original);

}  // namespace app
