// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/standstill_search.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "channels/latest_box.h"
#include "channels/processor_holder.h"
#include "support/hard_threads.h"
#include "support/real_time.h"
#include "support/stop_signals.h"

namespace syncline {

namespace {

ProcessorHolder holder_of(const ThreadRun& run) {
  ProcessorHolder holder;
  const auto length = std::min(run.name.size(), holder.name.size() - 1);
  std::copy_n(run.name.begin(), length, holder.name.begin());
  holder.kernel = run.kernel;
  holder.at_a_time = run.ran / static_cast<Nanoseconds>(run.slices);
  holder.times = run.slices;
  return holder;
}

}  // namespace

std::chrono::milliseconds next_search_after(std::chrono::milliseconds last, bool told_something_new,
                                            std::chrono::milliseconds period) {
  constexpr int kMostPeriods = 32;
  return told_something_new ? period : std::min(2 * last, kMostPeriods * period);
}

struct StandstillSearch::Impl {
  explicit Impl(Options own_options) : options(std::move(own_options)) {
    const StopSignalsBlocked deaf;  // whoever started the run hears them
    try {
      thread = std::thread([this] { search(); });
    } catch (const std::system_error&) {
      return;  // without it nobody is named, and that is all
    }
  }
  ~Impl() {
    {
      const std::scoped_lock lock(mutex);
      stop = true;
    }
    wake.notify_one();
    if (thread.joinable()) thread.join();
  }

  void search() noexcept {
    try {
      run();
    } catch (const std::exception&) {
      return;  // without memory for it nobody is named any more; the run goes on
    }
  }

  void run() {
    give_up_real_time();  // a thread has the priority of the one that starts it
    const auto before = hard_threads(options.priority, options.proc);
    std::string told;
    auto pause = options.period;
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, pause, [this] { return stop; })) {
      if (!wanted.exchange(false, std::memory_order_relaxed)) continue;
      const auto now = hard_threads(options.priority, options.proc);
      const auto longest = longest_at_a_time(before, now);
      if (longest) found.publish(holder_of(*longest));
      pause = next_search_after(pause, longest && longest->name != told, options.period);
      if (longest) told = longest->name;
    }
  }

  const Options options;
  LatestBox<ProcessorHolder> found;
  std::atomic<bool> wanted{false};
  std::mutex mutex;  // of stop alone: the cyclic thread never sees it
  std::condition_variable wake;
  bool stop = false;
  std::thread thread;
};

StandstillSearch::StandstillSearch(Options options) : impl_(std::make_unique<Impl>(std::move(options))) {}
StandstillSearch::~StandstillSearch() = default;

void StandstillSearch::note_standstill() { impl_->wanted.store(true, std::memory_order_relaxed); }
bool StandstillSearch::read(ProcessorHolder& holder) { return impl_->found.read(holder); }

}  // namespace syncline
