/// What twins leave on disk beside themselves.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/twin/twinning.hpp"

namespace app {

/// SI units in the names of the keys; what does not exist is null.
[[nodiscard]] nlohmann::ordered_json twins_json(const TwinTask& task, const std::vector<TwinRecord>& twins,
                                                const specimen::Misfit& misfit);

/// A line for the original and for each twin, SI units in the names of the columns.
[[nodiscard]] std::string twins_csv(const TwinTask& task, const std::vector<TwinRecord>& twins);

/// What was found.
struct TwinStatistics {
  specimen::Misfit misfit;
  std::vector<std::string> notes;  ///< of the conversion and of the twins
  std::string json;                ///< statistics.json
};

/// Compare the twins with their original and write into their folder:
///   original.h5      the original with its preview, as what the twins are like
///   statistics.csv   a line for it and for each twin
///   statistics.json  all figures, curves and misfits
///   report.html      all of it on one page that needs no network
///   scene.toml       a scene that breaks the first twin: loading, phases and solver of the settings
///   study.toml       a study that breaks them all
/// Twins of an earlier run that this one has not are removed.
/// @pre at least one twin.   @throws specimen::Error, mpm::FileError when the disk fails.
TwinStatistics write_twin_statistics(const std::filesystem::path& folder, const TwinTask& task,
                                     const std::vector<TwinRecord>& twins, std::vector<std::string> notes);

}  // namespace app
