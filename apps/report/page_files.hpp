/// What makes the report page move, as text. It is kept as files in apps/report/page.
#pragma once

#include <string_view>

namespace output {

[[nodiscard]] std::string_view chart_style();        ///< CSS of uPlot
[[nodiscard]] std::string_view chart_library();      ///< uPlot: defines uPlot
[[nodiscard]] std::string_view animation_library();  ///< gifenc, a CommonJS module: fills `exports`
[[nodiscard]] std::string_view report_script();      ///< ours, which needs both
[[nodiscard]] std::string_view watching_script();    ///< follows it on the page of a run that goes on

}  // namespace output
