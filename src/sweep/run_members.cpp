#include "sweep/run_members.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>
#include <list>
#include <map>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "sweep/child_process.hpp"

namespace moraine {
namespace {

constexpr int most_tries = 3;
constexpr std::chrono::milliseconds look_interval(20);

volatile std::sig_atomic_t stop_requested = 0;

/// The second signal finds the default handler; that this process ends tells its children again.
void request_stop(int) {
  stop_requested = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

struct Running {
  std::size_t member;
  std::size_t slot;
  double started;
  std::uintmax_t log_start;
  ChildProcess process;
};

class MemberRuns {
 public:
  MemberRuns(std::vector<MemberFolder> const& members, std::vector<std::size_t> const& wanted,
             RunSettings const& settings, SweepCount count, SweepProgress& progress,
             std::function<void(std::size_t, MemberStatus const&)> const& ended)
      : members_(members),
        waiting_(wanted.begin(), wanted.end()),
        settings_(settings),
        count_(std::move(count)),
        progress_(progress),
        ended_(ended),
        slot_taken_(settings.at_once, false) {}

  bool run() {
    bool asked = false;
    while (!running_.empty() || (!waiting_.empty() && stop_requested == 0)) {
      if (stop_requested == 0) {
        start_where_free();
      } else if (!asked) {
        asked = true;
        progress_.say("stops the members that are running; their state is saved");
        for (Running const& run : running_) run.process.ask_to_stop();
      }
      collect();
      show();
      std::this_thread::sleep_for(look_interval);
    }
    return stop_requested == 0;
  }

 private:
  std::optional<std::size_t> free_slot() const {
    for (std::size_t slot = 0; slot < slot_taken_.size(); ++slot)
      if (!slot_taken_[slot]) return slot;
    return std::nullopt;
  }

  int threads_of(std::size_t slot) const {
    auto const lanes = static_cast<int>(settings_.at_once);
    int const more = static_cast<int>(slot) < settings_.threads % lanes ? 1 : 0;
    return std::max(1, settings_.threads / lanes + more);
  }

  void start_where_free() {
    while (!waiting_.empty()) {
      auto const slot = free_slot();
      if (!slot) return;
      start(waiting_.front(), *slot);
      waiting_.pop_front();
    }
  }

  void start(std::size_t member, std::size_t slot) {
    MemberFolder const& place = members_[member];
    std::string const threads = fmt::format("{}", threads_of(slot));
    std::vector<std::string> words{"moraine", "resume", place.folder.string()};
    if (!can_resume(place)) {
      prepare(place);
      words = {"moraine",
               "run",
               (place.folder / "case.toml").string(),
               "--output",
               place.folder.string(),
               "--force"};
    }
    words.insert(words.end(), {"--threads", threads});
    std::error_code ignored;
    auto const log_size = std::filesystem::file_size(log_of(place), ignored);
    running_.push_back({member, slot, progress_.now(), ignored ? 0 : log_size,
                        ChildProcess(std::move(words), log_of(place))});
    slot_taken_[slot] = true;
    ++tries_[member];
  }

  void collect() {
    for (auto run = running_.begin(); run != running_.end();) {
      if (auto const code = run->process.ended()) {
        slot_taken_[run->slot] = false;
        has_ended(*run, *code);
        run = running_.erase(run);
      } else {
        ++run;
      }
    }
  }

  void has_ended(Running const& run, int code) {
    MemberFolder const& place = members_[run.member];
    MemberStatus status = status_of(place);
    bool const killed = code > 128 && code != 130;
    // The folder speaks, not the exit code: all results of a run that was killed or failed while it
    // wrote its page are there, and would be lost if it ran again.
    if (status.state == MemberState::done) {
      progress_.learn(progress_.now() - run.started);
      ++count_.done;
      return ended_(run.member, status);
    }
    if (stop_requested != 0 && (killed || code == 130)) return;
    if (killed && tries_[run.member] < most_tries) {
      waiting_.push_front(run.member);
      return;
    }
    status = {MemberState::failed, failure_of(run, code)};
    // What ended by the machine's doing is taken up again by the next call.
    if (code >= 1 && code <= 3) note_failure(place, code, status.message);
    ++count_.failed;
    progress_.say(fmt::format("{} failed: {}", place.name, status.message));
    ended_(run.member, status);
  }

  std::string failure_of(Running const& run, int code) const {
    if (code == 130) return "was stopped from outside; the next call goes on with it";
    if (code > 128) return fmt::format("was killed by signal {}, {} times", code - 128, most_tries);
    std::string const reason = reason_of_failure(members_[run.member], run.log_start);
    return reason.empty() ? fmt::format("ended with exit code {}", code) : reason;
  }

  void show() {
    count_.running.clear();
    for (Running const& run : running_) count_.running.push_back(progress_.now() - run.started);
    progress_.update(count_);
  }

  std::vector<MemberFolder> const& members_;
  std::deque<std::size_t> waiting_;
  RunSettings settings_;
  SweepCount count_;
  SweepProgress& progress_;
  std::function<void(std::size_t, MemberStatus const&)> const& ended_;
  std::vector<bool> slot_taken_;
  std::list<Running> running_;
  std::map<std::size_t, int> tries_;
};

}  // namespace

bool run_members(std::vector<MemberFolder> const& members, std::vector<std::size_t> const& wanted,
                 RunSettings const& settings, SweepCount count, SweepProgress& progress,
                 std::function<void(std::size_t, MemberStatus const&)> const& ended) {
  count.at_once = settings.at_once;
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  bool const all = MemberRuns(members, wanted, settings, std::move(count), progress, ended).run();
  progress.finish();
  return all;
}

}  // namespace moraine
