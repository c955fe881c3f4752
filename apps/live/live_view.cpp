#include "apps/live/live_view.hpp"

#include <algorithm>
#include <thread>

#include "apps/live/watching.hpp"
#include "apps/live/progress_line.hpp"

namespace app {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double shortest_pause = 0.5;   ///< between two looks [s]
constexpr double costs_per_pause = 150;  ///< a look takes less than a hundredth of the time on one core
constexpr Seconds patience{2};           ///< with pages that do not ask any more
constexpr Seconds round_of_pages{0.7};   ///< in which every page that is open has asked

}  // namespace

LiveView::LiveView(LiveRun run, int port) : run_(std::move(run)) {
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

RunRecord LiveView::record(const Look& look) const {
  return {run_.specimen, run_.scene, look.result, run_.scene_toml, run_.scene_hash,
          run_.title,    run_.notes, {},          look.goes_on};
}

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
