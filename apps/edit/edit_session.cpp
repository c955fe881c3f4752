#include "apps/edit/edit_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/edit/edit_page.hpp"
#include "apps/job/specimen_report.hpp"
#include "apps/settings/offer.hpp"
#include "apps/text/complaint.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double most_sketched =
    3e5;                             ///< pixels that are sorted after each stroke: about a second of one core
constexpr double most_shown = 12e6;  ///< pixels of the picture that a page gets
constexpr std::size_t largest_order = 2'000'000;  ///< [bytes]: the longest stroke
constexpr double no_scale = 1e-3;  ///< pixel size where none is known; nothing that has a unit is shown [m]

/// What pages are told of a number that is none.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

LiveReply refused(int status, const std::string& why) {
  return {status, Json{{"error", why}}.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

std::string bytes_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool has_scale(const specimen::ConvertOptions& options, const specimen::Picture& picture) {
  return options.width > 0 || options.source_pixel_size > 0 || picture.pixel_size > 0;
}

void check_key(const std::string& key) {
  const auto& keys = edited_settings();
  if (std::find(keys.begin(), keys.end(), key) == keys.end())
    throw Rejected(Exit::data, key.substr(0, 60), "", "is no setting of the page");
}

}  // namespace

const std::vector<std::string>& edited_settings() {
  static const std::vector<std::string> keys{
      "convert.width",          "convert.pixels",     "convert.even_light", "convert.smooth",
      "convert.drop_islands",   "convert.fill_holes", "convert.open",       "convert.close",
      "convert.split_touching", "convert.split_depth"};
  return keys;
}

struct EditSession::Sketched {
  ShownMask mask;
  Json found;
};

EditSession::EditSession(EditTask task, StrokeBook book)
    : task_(std::move(task)),
      sketch_(specimen::sketch_of(task_.picture, most_sketched)),
      shown_(shown_picture(task_.picture, most_shown)),
      book_(std::move(book)),
      given_(task_.given),
      settings_(task_.settle(given_)) {
  worker_ = std::thread([this] { work(); });
}

EditSession::~EditSession() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

/// @pre mutex_ is held.
void EditSession::touch() {
  ++number_;
  changed_.notify_all();
}

LiveAnswers EditSession::answers() {
  LiveAnswers answers;
  answers.option = "--edit";
  answers.largest_order = largest_order;
  answers.page = [this] {
    const std::lock_guard lock(mutex_);
    return edit_page(task_.name, settings_);
  };
  answers.update = [this](std::int64_t have) { return update(have); };
  answers.stop = [this] {
    const std::lock_guard lock(mutex_);
    wish_ = EditWish::finish;
    changed_.notify_all();
  };
  const char* bytes = "application/octet-stream";
  answers.parts["photo"] = [this, bytes] { return LiveReply{200, shown_.bytes, bytes}; };
  answers.parts["mask"] = [this, bytes] {
    const std::lock_guard lock(mutex_);
    return mask_ ? LiveReply{200, mask_->bytes, bytes} : refused(404, "there is no mask yet");
  };
  answers.parts["strokes"] = [this] {
    const std::lock_guard lock(mutex_);
    return LiveReply{200, bytes_of(strokes_json())};
  };
  const auto takes = [&](const char* name, void (EditSession::*apply)(const nlohmann::json&)) {
    answers.orders[name] = [this, apply](const std::string& content) {
      return change(content, [&](const nlohmann::json& order) { (this->*apply)(order); });
    };
  };
  takes("add", &EditSession::add);
  takes("remove", &EditSession::remove);
  takes("set", &EditSession::set);
  answers.orders["undo"] = [this](const std::string&) {
    return change("{}", [&](const nlohmann::json&) { book_.undo(); });
  };
  answers.orders["redo"] = [this](const std::string&) {
    return change("{}", [&](const nlohmann::json&) { book_.redo(); });
  };
  answers.orders["make"] = [this](const std::string&) {
    const std::lock_guard lock(mutex_);
    want_to_make();
    return LiveReply{200, "{}"};
  };
  return answers;
}

LiveReply EditSession::change(const std::string& content,
                              const std::function<void(const nlohmann::json& order)>& apply) {
  const nlohmann::json order = nlohmann::json::parse(content, nullptr, false);
  if (!order.is_object()) return refused(400, "no JSON object");
  const std::lock_guard lock(mutex_);
  const std::int64_t before = book_.version();
  try {
    apply(order);
  } catch (const nlohmann::json::exception&) {
    return refused(400, "a value is missing, or of another type");
  } catch (const Rejected& rejected) {
    return refused(400, rejected.what());
  } catch (const specimen::Error& error) {
    return refused(error.fault == specimen::Fault::write ? 507 : 400, error.what());
  }
  if (book_.version() != before) ++wanted_;
  touch();
  return {200, Json{{"number", number_}, {"version", book_.version()}}.dump()};
}

void EditSession::add(const nlohmann::json& order) {
  specimen::StrokeLine line;
  line.phase = order.at("phase").get<std::string>();
  line.width = order.at("width").get<double>();
  for (const nlohmann::json& point : order.at("points"))
    line.points.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
  book_.add(line);
}

void EditSession::remove(const nlohmann::json& order) {
  if (order.at("version").get<std::int64_t>() != book_.version())
    throw Rejected(Exit::data, "strokes", "have changed in the meantime", "", "erase once more");
  book_.remove(order.at("strokes").get<std::vector<std::size_t>>());
}

/// An order {"KEY": "text" or null, ...}; null = as if it were not given.
void EditSession::set(const nlohmann::json& order) {
  std::vector<Assignment> given = given_;
  for (const auto& [key, text] : order.items()) {
    check_key(key);
    const auto takes_place = [&, &name = key](const Assignment& one) {
      return one.key == name || (name == "convert.width" && one.key == "convert.pixel_size");
    };
    std::erase_if(given, takes_place);
    const bool is_off = text == "false";  // as it is, unless a scene says otherwise
    if (text.is_null() || (is_off && text_of_setting(key, task_.settle(given)) == "false")) continue;
    given.push_back(given_as_option(key, find_field(key)->form.kind, "--" + with_dashes(leaf_of(key)),
                                    text.get<std::string>()));
  }
  settings_ = task_.settle(given);
  given_ = std::move(given);
  ++wanted_;
}

/// @pre mutex_ is held.
void EditSession::want_to_make() {
  if (is_making_) return;
  wish_ = EditWish::make;
  is_making_ = true;
  fault_.clear();
  touch();
}

Json EditSession::strokes_json() const {
  Json strokes = Json::array();
  for (const specimen::StrokeLine& line : book_.lines())
    strokes.push_back({{"phase", line.phase}, {"width", line.width}, {"points", line.points}});
  return {{"version", book_.version()}, {"strokes", strokes}};
}

Json EditSession::settings_json() const {
  Json values = Json::object();
  for (const std::string& key : edited_settings()) values[key] = text_of_setting(key, settings_);
  return values;
}

Json EditSession::state() const {
  const specimen::Crop& crop = task_.crop;
  Json made = nullptr;
  if (made_)
    made = {{"files", made_->files},
            {"strokes", made_->strokes},
            {"command", made_->command},
            {"is_current", made_of_ == wanted_}};
  return {{"number", number_},
          {"version", book_.version()},
          {"file", book_.file()},
          {"can_undo", book_.can_undo()},
          {"can_redo", book_.can_redo()},
          {"picture",
           {{"cols", task_.picture.cols()},
            {"rows", task_.picture.rows()},
            {"shown_cols", shown_.cols},
            {"shown_rows", shown_.rows},
            {"aspect", task_.picture.pixel_aspect},
            {"crop", {crop.x, crop.y, crop.width, crop.height}}}},
          {"settings", settings_json()},
          {"has_scale", has_scale(settings_.convert, task_.picture)},
          {"is_sorting", sorted_ != wanted_},
          {"is_making", is_making_},
          {"has_ended", has_ended_},
          {"mask_version", mask_version_},
          {"found", found_},
          {"fault", fault_},
          {"made", made}};
}

std::optional<std::string> EditSession::update(std::int64_t have) {
  const std::lock_guard lock(mutex_);
  told_ = std::max(told_, std::min(have, number_));
  changed_.notify_all();
  if (have == number_) return std::nullopt;
  return bytes_of(state());
}

namespace {

/// What a page tells about a mask.
Json about(const ShownMask& mask, const Json& figures, double uncertain,
           const std::vector<std::string>& notes) {
  return {{"rows", mask.rows},     {"cols", mask.cols},
          {"x", mask.x},           {"y", mask.y},
          {"step_x", mask.step_x}, {"step_y", mask.step_y},
          {"figures", figures},    {"uncertain", finite(uncertain)},
          {"notes", notes}};
}

Json without_scale(Json figures) {
  for (const char* key : {"width_m", "height_m", "pixel_size_m", "warnings"}) figures.erase(key);
  for (const char* key : {"smallest_m", "largest_m", "sieve"}) figures["aggregates"].erase(key);
  return figures;
}

}  // namespace

EditSession::Sketched EditSession::sort(const std::vector<specimen::StrokeLine>& lines,
                                        const Settings& settings) const {
  specimen::ConvertOptions options = settings.convert;
  options.strokes.clear();
  options.label_phases.clear();
  options.stroke_lines = lines;
  const bool is_scaled = has_scale(options, task_.picture);
  if (!is_scaled) {
    options.source_pixel_size = no_scale;
    options.drop_islands = -1;
  }
  const auto begin = std::chrono::steady_clock::now();
  specimen::Converted converted =
      specimen::convert_picture(sketch_.picture, specimen::options_for(sketch_, options));
  Sketched sketched;
  sketched.mask = shown_mask(converted.segmented, converted.uncertain, options.crop, task_.picture.cols(),
                             task_.picture.pixel_aspect);
  specimen::ItzOptions no_itz;
  no_itz.mode = specimen::ItzMode::none;
  const specimen::Specimen specimen = specimen::make_specimen(std::move(converted.segmented), no_itz, {});
  const Json figures = specimen_json(specimen, {});
  std::vector<std::string> notes = converted.report.notes;
  if (!is_scaled) std::erase_if(notes, [](const std::string& note) { return note.find(" mm") != note.npos; });
  sketched.found =
      about(sketched.mask, is_scaled ? figures : without_scale(figures), converted.report.uncertain, notes);
  sketched.found["factor"] = sketch_.factor;
  sketched.found["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return sketched;
}

void EditSession::work() {
  for (std::unique_lock lock(mutex_);;) {
    changed_.wait(lock, [&] { return ends_ || sorted_ != wanted_; });
    if (ends_) return;
    const std::int64_t wanted = wanted_;
    const std::vector<specimen::StrokeLine> lines = book_.lines();
    const Settings settings = settings_;
    lock.unlock();
    Sketched sketched;
    std::string why;
    try {
      if (!lines.empty()) sketched = sort(lines, settings);
    } catch (...) {
      why = refusal_of(std::current_exception()).what();
    }
    lock.lock();
    const bool is_of_specimen = made_ && made_of_ == wanted && mask_ != nullptr;  // it came in between
    if (!is_of_specimen && why.empty() && !lines.empty()) {
      mask_ = std::make_shared<const ShownMask>(std::move(sketched.mask));
      found_ = std::move(sketched.found);
      ++mask_version_;
    } else if (!is_of_specimen) {
      mask_ = nullptr;
      found_ = {{"why", lines.empty() ? "" : why}};
      ++mask_version_;
    }
    sorted_ = wanted;
    touch();
  }
}

EditWish EditSession::wait(std::chrono::milliseconds at_most) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, at_most, [&] { return wish_ != EditWish::none; });
  return std::exchange(wish_, EditWish::none);
}

EditSession::Wanted EditSession::wanted() {
  const std::lock_guard lock(mutex_);
  made_of_ = wanted_;
  made_.reset();
  return {book_.lines(), given_};
}

void EditSession::made(Made made) {
  ShownMask mask = shown_mask(made.segmentation, made.uncertain_at, task_.crop, task_.picture.cols(),
                              task_.picture.pixel_aspect);
  made.segmentation = {};
  made.uncertain_at = {};
  const std::lock_guard lock(mutex_);
  if (made_of_ == wanted_) {
    mask_ = std::make_shared<const ShownMask>(std::move(mask));
    found_ = about(*mask_, made.figures, made.uncertain, made.notes);
    found_["factor"] = 1;
    sorted_ = wanted_;
    ++mask_version_;
  }
  made_ = std::move(made);
  is_making_ = false;
  touch();
}

void EditSession::failed(const std::string& why) {
  const std::lock_guard lock(mutex_);
  fault_ = why;
  is_making_ = false;
  touch();
}

void EditSession::finish() {
  std::unique_lock lock(mutex_);
  has_ended_ = true;
  touch();
  changed_.wait_for(lock, std::chrono::seconds(1), [&] { return told_ == number_; });
}

}  // namespace app
