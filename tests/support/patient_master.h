// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "channels/background_master.h"
#include "channels/master_channels.h"

namespace syncline::test {

/// Online from the start; takes requests and answers when it is told to.
class PatientMaster final : public BackgroundMaster {
 public:
  explicit PatientMaster(bool is_virtual = true) : is_virtual_(is_virtual) {
    channels_.events.push({0, -1, events::Online{}});
  }
  [[nodiscard]] MasterChannels& channels() override { return channels_; }
  [[nodiscard]] bool is_virtual() const override { return is_virtual_; }
  void start() override {}
  [[nodiscard]] bool started() const override { return false; }
  void stop() override {}
  bool step() override { return false; }
  void run_for(Nanoseconds) override {}
  [[nodiscard]] bool online() const override { return false; }

  /// All that it has been given since the last time.
  std::vector<RequestTicket*> taken() {
    std::vector<RequestTicket*> tickets;
    while (auto* ticket = channels_.requests.pop()) tickets.push_back(ticket);
    return tickets;
  }

 private:
  MasterChannels channels_;
  bool is_virtual_;
};

}  // namespace syncline::test
