#include "apps/live/live_view.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/live/progress_line.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_data.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"
#include "apps/text/markup.hpp"

namespace output {
namespace {

using Json = nlohmann::ordered_json;

std::string bar(const Stage& stage) {
  return fmt::format(
      "<div class=\"watch\" id=\"watch\" data-number=\"{}\">\n"
      "<progress id=\"watch-done\" max=\"1\" value=\"{:.4f}\" aria-label=\"Share of the run that is done\">"
      "</progress>\n<span id=\"watch-words\" role=\"status\">{}</span>\n"
      "<button type=\"button\" id=\"watch-stop\">Stop the run</button>\n</div>\n",
      stage.number, stage.fraction, escape(stage.words));
}

}  // namespace

std::string watching_html(const RunRecord& record, const Stage& stage) {
  const auto stands = [&](const char* name, std::string (*of)(const RunRecord&)) {
    return standing(name, [&] { return of(record); });
  };
  return watching_page(
      title_of(record),
      header_html(record) + bar(stage) + stands("Stress and strain", curve_section) +
          stands("Film of the damage", film_section) + stands("Energies and failures", ledger_section) +
          stands("Specimen", specimen_section) + stands("Solution and provenance", solution_section) +
          stands("Notes", notes_section) + stands("Scene", scene_section) + glossary_section() +
          citation_section(record),
      report_data(record));
}

std::string watching_update(const RunRecord& record, const Stage& stage) {
  const Json csv = record.goes_on ? Json(nullptr) : Json(deflated_base64(curve_csv(record)));
  return inert_text({{"number", stage.number},
                     {"fraction", stage.fraction},
                     {"words", stage.words},
                     {"goes_on", record.goes_on},
                     {"strain", strain_json(record)},
                     {"csv", csv},
                     {"charts", charts_of_run(record)},
                     {"film", has_film(record) ? film_growth(record) : Json(nullptr)},
                     {"parts",
                      {{"facts", facts_part(record)},
                       {"failures", failures_part(record)},
                       {"solution", solution_part(record)}}}});
}

}  // namespace output

namespace app {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double shortest_pause = 0.5;   ///< between two looks [s]
constexpr double costs_per_pause = 150;  ///< a look takes less than a hundredth of the time on one core
constexpr Seconds patience{2};           ///< with pages that do not ask any more
constexpr Seconds round_of_pages{0.7};   ///< in which every page that is open has asked

}  // namespace

LiveView::LiveView(RunSubject run, int port) : run_(std::move(run)) {
  server_ = std::make_unique<LiveServer>(
      port, LiveAnswers{[this] { return page(); }, [this](std::int64_t have) { return update(have); },
                        [this] { stopped_ = true; }});
}

LiveView::~LiveView() = default;

bool LiveView::look(const mpm::Progress& progress) {
  if (wanted_.load(std::memory_order_relaxed)) {
    const Clock::time_point begin = Clock::now();
    Look look{progress.so_far(), progress.fraction, progress_text(run_.scene, progress), 0, true};
    const std::lock_guard lock(mutex_);
    cost_ = Seconds(Clock::now() - begin).count();
    show(std::move(look));
  }
  return !stopped_.load(std::memory_order_relaxed);
}

/// @pre mutex_ is held.
void LiveView::show(Look look) {
  look.number = look_ ? look_->number + 1 : 1;
  look_ = std::make_shared<const Look>(std::move(look));
  taken_ = Clock::now();
  wanted_ = false;
  changed_.notify_all();
}

void LiveView::finish(const mpm::Result& result, const std::string& words) {
  std::unique_lock lock(mutex_);
  show({result, 1, words, 0, false});
  const Clock::time_point begin = Clock::now();
  if (!last_asked_ || begin - *last_asked_ > patience) return;
  changed_.wait_for(lock, patience, [&] { return told_ == look_->number; });
  lock.unlock();
  std::this_thread::sleep_until(begin + round_of_pages);
}

std::shared_ptr<const LiveView::Look> LiveView::newest() {
  const std::lock_guard lock(mutex_);
  last_asked_ = Clock::now();
  const double age = Seconds(*last_asked_ - taken_).count();
  if (!look_ || (look_->goes_on && age > std::max(shortest_pause, costs_per_pause * cost_))) wanted_ = true;
  return look_;
}

std::shared_ptr<const LiveView::Look> LiveView::ask_for_first() {
  std::shared_ptr<const Look> look = newest();
  if (look) return look;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] { return look_ != nullptr; });
  return look_;
}

RunRecord LiveView::record(const Look& look) const { return {run_, look.result, {}, look.goes_on}; }

std::optional<std::string> LiveView::page() {
  const std::shared_ptr<const Look> look = ask_for_first();
  if (!look) return std::nullopt;
  return output::watching_html(record(*look), {look->number, look->fraction, look->words});
}

std::optional<std::string> LiveView::update(std::int64_t have) {
  const std::shared_ptr<const Look> look = newest();
  if (!look || look->number <= have) return std::nullopt;
  const std::lock_guard draws(drawing_);
  if (drawn_number_ != look->number) {
    const Clock::time_point begin = Clock::now();
    drawn_ = output::watching_update(record(*look), {look->number, look->fraction, look->words});
    drawn_number_ = look->number;
    const std::lock_guard lock(mutex_);
    cost_ += Seconds(Clock::now() - begin).count();
  }
  const std::lock_guard lock(mutex_);
  told_ = std::max(told_, look->number);
  changed_.notify_all();
  return drawn_;
}

}  // namespace app
