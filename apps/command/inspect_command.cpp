#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "apps/job/specimen_report.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"
#include "specimen/picture/picture.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* inspect_footer =
    "Examples: a run; a photograph, whose scale and size convert will take; a specimen, for a script\n"
    "  mesopix inspect runs/specimen\n"
    "  mesopix inspect photo.jpg\n"
    "  mesopix inspect specimen.h5 --json";

Json result_json(const mpm::Result& result) {
  const double strain = result.history.empty() ? 0 : result.history.back().strain;
  Json figures{{"kind", "result"}};
  figures.update(Json(output::peak_figures(result)));
  figures.update(Json{{"last_strain", strain},
                      {"stop", output::word_of(result.stop)},
                      {"tension_failures", result.tension_failures},
                      {"shear_failures", result.shear_failures},
                      {"points", result.points},
                      {"steps", result.steps},
                      {"dt_s", result.dt},
                      {"wall_time_s", result.wall_time},
                      {"point_updates_per_second", result.point_updates_per_second()},
                      {"energy_error", result.energy_error},
                      {"instruction_set", result.instruction_set},
                      {"threads", result.threads},
                      {"history_rows", result.history.size()}});
  return figures;
}

std::string result_text(const Json& figures) {
  return fmt::format(
      "result: {} {:.4g} MPa at strain {}, ended at strain {} ({})\n"
      "  {} tension and {} shear failures of {} points\n"
      "  {} steps of {:.4g} s in {:.2f} s ({:.0f} million point updates a second, {})\n",
      figures["peak_reached"].get<bool>() ? "peak" : "no peak, largest stress",
      1e-6 * figures["largest_stress_Pa"].get<double>(),
      strain_text(figures["strain_at_largest_stress"].get<double>()),
      strain_text(figures["last_strain"].get<double>()), figures["stop"].get<std::string>(),
      figures["tension_failures"].get<std::int64_t>(), figures["shear_failures"].get<std::int64_t>(),
      figures["points"].get<std::int64_t>(), figures["steps"].get<std::int64_t>(),
      figures["dt_s"].get<double>(), figures["wall_time_s"].get<double>(),
      1e-6 * figures["point_updates_per_second"].get<double>(),
      figures["instruction_set"].get<std::string>());
}

Json picture_json(const std::string& path) {
  const specimen::Picture picture = specimen::read_picture(path);
  Json figures{{"kind", "picture"},
               {"columns", picture.cols()},
               {"rows", picture.rows()},
               {"channels", picture.colour.empty() ? 1 : 3},
               {"bits", picture.bits},
               {"pixel_size_m", picture.pixel_size > 0 ? Json(picture.pixel_size) : Json(nullptr)}};
  if (picture.gray.empty()) return figures;
  const std::set<double> values =
      picture.gray.data.visit([](const auto& all) { return std::set<double>(all.begin(), all.end()); });
  figures["distinct_values"] = values.size();
  figures["lowest"] = *values.begin();
  figures["highest"] = *values.rbegin();
  return figures;
}

std::string picture_text(const Json& figures) {
  const Json& size = figures["pixel_size_m"];
  const std::string scale =
      size.is_null() ? "no scale in the file" : fmt::format("pixels of {:.4g} mm", 1e3 * size.get<double>());
  std::string text =
      fmt::format("picture of {} x {} pixels, {}, {} bits, {}\n", figures["columns"].get<int>(),
                  figures["rows"].get<int>(), figures["channels"] == 1 ? "grey" : "colour",
                  figures["bits"].get<int>(), scale);
  if (figures.contains("distinct_values"))
    text += fmt::format("  {} values from {} to {}\n", figures["distinct_values"].get<std::size_t>(),
                        figures["lowest"].get<double>(), figures["highest"].get<double>());
  return text;
}

Json frame_json(const mpm::Frame& frame) {
  return {{"kind", "frame"},      {"points", frame.points.size()},
          {"time_s", frame.time}, {"strain", frame.strain},
          {"step", frame.step},   {"history_row", frame.row}};
}

std::string frame_text(const Json& figures) {
  return fmt::format("frame of {} points at strain {}, after {} steps\n",
                     figures["points"].get<std::size_t>(), strain_text(figures["strain"].get<double>()),
                     figures["step"].get<std::int64_t>());
}

Json table_json(const std::vector<mpm::TableColumn>& columns) {
  Json names = Json::array();
  for (const mpm::TableColumn& column : columns)
    names.push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
  return {{"kind", "table"}, {"rows", columns.empty() ? 0 : columns.front().rows()}, {"columns", names}};
}

std::string table_text(const Json& figures) {
  std::string text = fmt::format("table of {} rows and {} columns\n", figures["rows"].get<std::size_t>(),
                                 figures["columns"].size());
  for (const Json& column : figures["columns"])
    text += fmt::format("  {} [{}]: {}\n", column["name"].get<std::string>(),
                        column["unit"].get<std::string>(), column["meaning"].get<std::string>());
  return text;
}

/// Whichever reader accepts it.
Json hdf5_json(const std::string& path) {
  std::vector<std::string> faults;
  for (const std::function<Json()>& read : std::initializer_list<std::function<Json()>>{
           [&] { return result_json(read_result(path)); },
           [&] { return specimen_json(read_specimen(path), {}); },
           [&] { return frame_json(read_frame(path)); }, [&] { return table_json(read_table(path)); }}) {
    try {
      return read();
    } catch (const mpm::Error& error) {
      faults.emplace_back(error.what());
    } catch (const specimen::Error& error) {
      faults.emplace_back(error.what());
    }
  }
  throw Rejected(Exit::data, path, "neither a specimen nor a result, a frame or a table", faults[1],
                 faults[0]);
}

Json inspect(const std::string& path) {
  switch (kind_of_input(path)) {
    case InputKind::folder:
      check_one_run(path);
      return inspect((std::filesystem::path(path) / "result.h5").string());
    case InputKind::hdf5:
      return hdf5_json(path);
    case InputKind::picture:
      return picture_json(path);
    case InputKind::scene:
      throw Rejected(Exit::usage, path, "is a scene",
                     "must be a specimen, a result, a run folder, a frame, a table or a picture",
                     "mesopix simulate --print-scene " + path + " resolves it");
  }
  return {};
}

std::string figures_text(const Json& figures) {
  const auto kind = figures["kind"].get<std::string>();
  if (kind == "result") return result_text(figures);
  if (kind == "frame") return frame_text(figures);
  if (kind == "table") return table_text(figures);
  return kind == "picture" ? picture_text(figures) : specimen_text(figures);
}

class InspectCommand : public Command {
 public:
  explicit InspectCommand(CLI::App& program)
      : Command(program, "inspect",
                "Tell what is in a specimen, a result, a run folder, a frame, a table or a picture",
                inspect_footer) {
    option("FILE", file_, "specimen.h5, result.h5, folder of a run, frame, table.h5, or picture",
           file_form(picture_endings({"h5"})));
    flag("--json", json_, "as JSON");
  }

  Exit run(Console& console) override {
    require(file_, "FILE", "mesopix inspect FILE");
    const Json figures = inspect(file_);
    if (const auto doubts = figures.find("warnings"); doubts != figures.end())
      for (const Json& doubt : *doubts) console.warn(doubt.get<std::string>());
    console.out << (json_ ? json_text(figures) : printable_lines(figures_text(figures)));
    return Exit::ok;
  }

 private:
  std::string file_;
};

}  // namespace

CommandPointer inspect_command(CLI::App& parent) { return std::make_unique<InspectCommand>(parent); }

}  // namespace app
