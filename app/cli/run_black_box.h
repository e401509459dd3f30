// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/cli/context.h"
#include "record/black_box.h"

namespace CLI {
class App;
}  // namespace CLI

namespace syncline {
struct Event;
struct MasterChannels;
}  // namespace syncline

namespace syncline::cli {

struct BlackBoxOptions {
  std::string name;  // "": none
  std::uint32_t mib = 64, keep_free_mib = 256;
};
void add_black_box_options(CLI::App& command, BlackBoxOptions& options);

/// The last frames of a run on disk. Does nothing without a name.
class RunBlackBox {
 public:
  RunBlackBox(Context& context, const BlackBoxOptions& options) : context_(context), options_(options) {}
  /// Before the first frame. kBadValue, kFileNotWritable.
  Status start(MasterChannels& channels, const std::string& file, const std::string& link, bool virtual_time);
  void add(const Event& event);
  /// What the thread that writes has said, in the thread that prints.
  void tell();
  /// The rest is on the disk; what failed is told now, at the latest.
  void finish();
  /// Nothing without a name, or when it could not be started.
  [[nodiscard]] bool is_on() const { return box_ != nullptr; }
  [[nodiscard]] Json json() const;
  [[nodiscard]] std::string text() const;

 private:
  Context& context_;
  const BlackBoxOptions& options_;
  std::mutex mutex_;
  std::optional<Error> stopped_;
  std::unique_ptr<BlackBox> box_;  // last: its thread uses what stands above
};

}  // namespace syncline::cli
