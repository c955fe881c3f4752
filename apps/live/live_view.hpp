/// Lets the user watch a run in a browser while it goes on, and stop it there.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "apps/live/live_server.hpp"
#include "apps/report/run_record.hpp"
#include "libmpm/run/simulate.hpp"

namespace output {

/// How far a run is.
struct Stage {
  std::int64_t number = 0;  ///< of the look at it; the next look has a larger one
  double fraction = 0;      ///< that is done [-]
  std::string words;        ///< "42 %, strain 168e-6 ...", or how the run ended
};

/// The page of a report, but for what only a finished run has; a bar tells how far the run is and stops it.
/// Its script asks "now?have=NUMBER" every half second for a watching_update, and stops the run by a POST to
/// "stop".
[[nodiscard]] std::string watching_html(const RunRecord& record, const Stage& stage);

/// JSON without any of < > &, with the keys number, fraction, words, goes_on, strain, csv, charts (as in
/// report_data, without the sieve), film (film_growth, or null), parts (HTML by name).
[[nodiscard]] std::string watching_update(const RunRecord& record, const Stage& stage);

}  // namespace output

namespace app {

/// The solver hands over a copy of its result when a reader asks for news, and no more often than that all
/// which this costs, copying and drawing, stays below a hundredth of the time.
class LiveView {
 public:
  /// The specimen and the scene must outlive it.   @param port, @throws as LiveServer.
  LiveView(RunSubject run, int port);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  [[nodiscard]] std::string address() const { return server_->address(); }

  /// At every row of the history.   @return whether the run is to go on.
  [[nodiscard]] bool look(const mpm::Progress& progress);

  /// At the end: what the run has left, and how it ended in words. Returns when those who watch have it, or
  /// after two seconds.
  void finish(const mpm::Result& result, const std::string& words);

 private:
  using Clock = std::chrono::steady_clock;

  /// A result as it was at a row, in the hands of those who draw it.
  struct Look {
    mpm::Result result;
    double fraction = 0;
    std::string words;
    std::int64_t number = 0;
    bool goes_on = true;
  };

  void show(Look look);
  [[nodiscard]] std::shared_ptr<const Look> newest();
  [[nodiscard]] std::shared_ptr<const Look> ask_for_first();
  [[nodiscard]] RunRecord record(const Look& look) const;
  [[nodiscard]] std::optional<std::string> page();
  [[nodiscard]] std::optional<std::string> update(std::int64_t have);

  RunSubject run_;
  std::atomic<bool> wanted_ = false;   ///< a reader waits for a new look
  std::atomic<bool> stopped_ = false;  ///< by a reader
  std::mutex mutex_;                   ///< of all that follows
  std::condition_variable changed_;
  std::shared_ptr<const Look> look_;
  Clock::time_point taken_{};                    ///< when the newest look was
  double cost_ = 0;                              ///< of the newest look, copying and drawing [s]
  std::optional<Clock::time_point> last_asked_;  ///< when a page last asked for news
  std::int64_t told_ = 0;                        ///< number of the newest look that a page has got
  std::mutex drawing_;                           ///< one reader draws, the others wait for what it has drawn
  std::int64_t drawn_number_ = 0;                ///< guarded by drawing_
  std::string drawn_;                            ///< guarded by drawing_
  std::unique_ptr<LiveServer> server_;           ///< last: it ends first
};

}  // namespace app
