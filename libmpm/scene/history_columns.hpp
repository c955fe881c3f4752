/// The history as a table: names, units and meanings of its columns, said once for every file that holds it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "libmpm/scene/result.hpp"

namespace mpm {

/// A column of the history, either of measured values or of counts.
struct HistoryColumn {
  std::string_view name;     ///< as the member of HistoryRow
  std::string_view unit;     ///< SI; "1" = without
  std::string_view meaning;  ///< one line
  std::variant<double HistoryRow::*, std::int64_t HistoryRow::*> member;
};

/// All columns, in the order of HistoryRow.
[[nodiscard]] const std::array<HistoryColumn, 15>& history_columns();

}  // namespace mpm
