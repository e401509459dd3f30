// SPDX-License-Identifier: Apache-2.0
#include "record/black_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include "channels/event.h"
#include "channels/event_text.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "protocol/frame.h"
#include "reasons/because.h"
#include "support/attempt.h"
#include "support/pcapng_block.h"

namespace syncline {
namespace {

constexpr std::size_t kMostHeldBytes = std::size_t{16} << 20;
constexpr std::size_t kMostNotes = 8;       // of one frame; more go to the next ones
constexpr std::size_t kMostWaiting = 1000;  // for a frame, on a bus without any
constexpr std::size_t kLongestNote = 1000;
constexpr std::chrono::milliseconds kRealPeriod{100}, kVirtualPeriod{5};

/// Not within a character.
std::string shortened(std::string text) {
  if (text.size() <= kLongestNote) return text;
  auto size = kLongestNote;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;
  text.resize(size);
  return text + "...";
}

/// The files written so far are whole.
Error no_memory(const std::string& file) {
  return {.code = ErrorCode::kFileNotWritable, .detail = because("there is not enough memory"), .file = file};
}

}  // namespace

Result<std::unique_ptr<BlackBox>> BlackBox::start(std::shared_ptr<FrameRing> ring, const Options& options,
                                                  std::function<void(const Error&)> on_stopped) {
  auto segments = std::make_unique<FrameSegments>(FrameSegments::Options{.name = options.name,
                                                                         .most_bytes = options.most_bytes,
                                                                         .keep_free_bytes = options.keep_free_bytes,
                                                                         .sync = !options.virtual_time,
                                                                         .program = options.program,
                                                                         .interface = options.link,
                                                                         .description = options.description});
  if (auto status = segments->begin(); !status) return tl::unexpected(status.error());
  std::unique_ptr<BlackBox> box(new BlackBox(std::move(ring), options, std::move(segments), std::move(on_stopped)));
  if (auto status = box->begin(); !status) return tl::unexpected(status.error());
  return box;
}

BlackBox::BlackBox(std::shared_ptr<FrameRing> ring, const Options& options, std::unique_ptr<FrameSegments> segments,
                   std::function<void(const Error&)> on_stopped)
    : ring_(std::move(ring)),
      virtual_time_(options.virtual_time),
      segments_(std::move(segments)),
      no_memory_(no_memory(segments_->name())),
      on_stopped_(std::move(on_stopped)) {
  report_.name = segments_->name();
  ring_->open(virtual_time_ ? FrameRing::WhenFull::kWait : FrameRing::WhenFull::kLose, options.ring_bytes);
  publish({});
}

Status BlackBox::begin() {
  try {
    thread_ = std::thread([this] { run(); });
    return {};
  } catch (const std::system_error&) {
    ring_->close();  // or a producer on virtual time would wait for ever
    return tl::unexpected(no_memory_);
  }
}

BlackBox::~BlackBox() {
  attempt([this] { return finish(); });
}

void BlackBox::note(Nanoseconds time, std::string text) {
  const std::lock_guard lock(mutex_);
  if (!ending_ && !report_.error) notes_.push_back({time, shortened(std::move(text))});
}

void BlackBox::note(const Event& event) {
  if (auto words = event_words(event); !words.empty()) note(event.time, std::move(words));
}

BlackBox::Report BlackBox::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

Status BlackBox::finish() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  news_.notify_one();
  if (thread_.joinable()) thread_.join();
  return report_.error ? Status(tl::unexpected(*report_.error)) : Status{};
}

void BlackBox::run() noexcept {
  Status status;
  for (bool ending = false; status && !ending;) {
    {
      std::unique_lock lock(mutex_);
      ending = news_.wait_for(lock, virtual_time_ ? kVirtualPeriod : kRealPeriod, [this] { return ending_; });
    }
    if (ending) ring_->close();
    try {
      status = keep(ending);
    } catch (const std::exception&) {
      status = tl::unexpected(std::move(no_memory_));  // made before: there is none for it now
    }
  }
  if (status) return;
  ring_->close();
  stopped(std::move(status.error()));
}

Status BlackBox::keep(bool ending) {
  take();
  auto status = ending ? write_rest() : write(due());
  if (status && !ending) status = segments_->flush();
  publish(status);
  return status;
}

void BlackBox::stopped(Error error) noexcept {
  {
    const std::lock_guard lock(mutex_);
    if (!report_.error) report_.error = std::move(error);
  }
  try {
    if (on_stopped_) on_stopped_(*report_.error);
  } catch (const std::exception&) {
    return;  // not even for a sentence; the report has the error
  }
}

/// First the frames, then the notes: what is said of a frame that is written now has come by then.
void BlackBox::take() {
  ring_->read([this](const RingFrame& frame) { hold(frame); });
  std::deque<Note> notes;
  {
    const std::lock_guard lock(mutex_);
    notes.swap(notes_);
  }
  for (auto& note : notes) {
    if (taken_.size() >= kMostWaiting) {
      ++left_out_;
      continue;
    }
    const auto after = std::ranges::upper_bound(taken_, note.time, {}, &Note::time);
    taken_.insert(after, std::move(note));
  }
}

/// In the order of time: an answer is stamped when it came, and asked for when all frames of its cycle had gone.
void BlackBox::hold(const RingFrame& frame) {
  auto at = held_.end();
  while (at != held_.begin() && std::prev(at)->time > frame.time) --at;
  held_.insert(at, {frame.time, frame.direction, frame.lost_before, {frame.bytes.begin(), frame.bytes.end()}});
  held_bytes_ += frame.bytes.size();
  newest_ = std::max(newest_, frame.time);
  came_ = std::chrono::steady_clock::now();
}

/// Until when frames are written now. On virtual time never by how busy the host is.
Nanoseconds BlackBox::due() const {
  const bool silent = !virtual_time_ && std::chrono::steady_clock::now() - came_ > std::chrono::nanoseconds(kHeld);
  if (silent || newest_ == INT64_MIN) return newest_;
  return newest_ - kHeld;
}

Status BlackBox::write(Nanoseconds until) {
  while (!held_.empty() && (held_.front().time <= until || held_bytes_ > kMostHeldBytes)) {
    const auto frame = std::move(held_.front());
    held_.pop_front();
    held_bytes_ -= frame.bytes.size();
    const auto notes = notes_until(frame.time);
    told_lost_ += frame.lost_before;
    if (auto status = segments_->add({.time = frame.time,
                                      .direction = static_cast<std::uint8_t>(frame.direction),
                                      .lost_before = frame.lost_before,
                                      .notes = notes,
                                      .bytes = frame.bytes});
        !status) {
      return status;
    }
    written_ = frame.time;
    ++count_;
  }
  return {};
}

std::vector<std::string> BlackBox::notes_until(Nanoseconds time) {
  std::vector<std::string> texts;
  while (!taken_.empty() && taken_.front().time <= time && texts.size() < kMostNotes) {
    auto& note = taken_.front();
    if (note.time <= written_)
      note.text += fmt::format(" ({:.3f} ms before this frame)", static_cast<double>(time - note.time) / 1e6);
    texts.push_back(std::move(note.text));
    taken_.pop_front();
  }
  if (left_out_ > 0 && taken_.empty() && !texts.empty())
    texts.push_back(fmt::format("{} more events are left out", std::exchange(left_out_, 0)));
  return texts;
}

Status BlackBox::write_rest() {
  if (auto status = write(INT64_MAX); !status) return status;
  std::vector<std::string> rest;
  for (auto& note : taken_) rest.push_back(std::move(note.text));
  taken_.clear();
  return segments_->finish(rest, ring_->lost() - told_lost_);
}

void BlackBox::publish(const Status& status) {
  const std::lock_guard lock(mutex_);
  report_.files = segments_->segments().size();
  report_.bytes = report_.frames = 0;
  report_.begin = report_.end = 0;
  for (const auto& segment : segments_->segments()) {
    report_.bytes += segment.bytes;
    if (segment.frames == 0) continue;
    if (report_.frames == 0) report_.begin = segment.begin;
    report_.frames += segment.frames;
    report_.end = segment.end;
    report_.file = segment.path;
  }
  report_.replaced = count_ - std::min(count_, report_.frames);
  report_.lost = ring_->lost();
  if (!status && !report_.error) report_.error = status.error();
}

Nanoseconds black_box_reach(const NetworkConfig& config, std::uint64_t bytes) {
  double per_second = 0;
  for (const auto& task : config.cyclic) {
    std::size_t of_cycle = 0;
    for (const auto& frame : task.frames) {
      of_cycle += 2 * pcapng_packet_size(std::max(frame_bytes(frame), kMinEthernetFrame));  // out and back
    }
    if (task.cycle_time > 0) per_second += static_cast<double>(of_cycle) * 1e9 / static_cast<double>(task.cycle_time);
  }
  return per_second == 0 ? 0 : static_cast<Nanoseconds>(static_cast<double>(bytes) / per_second * 1e9);
}

}  // namespace syncline
