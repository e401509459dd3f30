// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

#include "channels/command_queue.h"
#include "channels/event_queue.h"
#include "channels/frame_ring.h"
#include "channels/image_contents.h"
#include "channels/request_desk.h"
#include "channels/sample_ring.h"
#include "channels/snapshot_box.h"

namespace syncline {

class CyclicApplication;

/// The channels between the background core and whoever looks at it: commands, events, snapshot, image, samples,
/// and on request the raw frames. Everything crosses by value.
struct MasterChannels {
  CommandQueue commands;
  RequestDesk requests;  // on single slaves, beside the commands
  EventQueue events;
  SnapshotBox snapshot;
  ImageBox image;
  SampleRing samples;
  /// Of who drives the master in a thread of his own, on the virtual clock, and cannot take samples while it works (a
  /// bring-up is one step of it, however long it takes): called in the cycle in which the ring is half full. Set before
  /// the master is driven; null where somebody else takes them.
  std::function<void()> relieve{};
  /// Closed until somebody opens it, who may read on when the master has gone.
  std::shared_ptr<FrameRing> frames = std::make_shared<FrameRing>();
  /// Goes on with every step and every frame of the thread that drives the master, whatever it does: who looks from
  /// another thread sees by it that this one lives.
  std::atomic<std::uint64_t> heartbeat{0};
  std::atomic<bool> cancel{false};  // ends a scan or a bring-up within a cycle
  /// By how much the application makes the host's timer slower, in thousandths of its rate; holds until it is written
  /// again. In force in the mode master-shift-by-app and with control off. -20..20.
  std::atomic<double> timer_adjust_permil{0};
  std::atomic<CyclicApplication*> application{nullptr};  // none: the outputs stay 0; must outlive the cycles

  /// The driving thread: it lives. It is the only writer.
  void beat() { heartbeat.store(heartbeat.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed); }
};

}  // namespace syncline
