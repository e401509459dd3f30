// SPDX-License-Identifier: Apache-2.0
#include "engine/background_master.h"

#include <utility>

#include "channels/background_master.h"
#include "channels/master_channels.h"
#include "engine/opened_link.h"
#include "engine/virtual_pacer.h"
#include "master/master_service.h"
#include "support/clock.h"

namespace syncline {
namespace {

class ServedMaster final : public BackgroundMaster {
 public:
  explicit ServedMaster(OpenedLink opened)
      : clock_(std::move(opened.clock)), service_(std::move(opened.link), *clock_) {}
  ~ServedMaster() override {
    end_thread();
    service_.shut_down();
  }
  ServedMaster(const ServedMaster&) = delete;
  ServedMaster& operator=(const ServedMaster&) = delete;

  [[nodiscard]] MasterChannels& channels() override { return service_.channels(); }
  [[nodiscard]] bool is_virtual() const override { return clock_->is_virtual(); }
  void start() override {
    if (started()) return;
    if (is_virtual()) {
      pacer_ = std::make_unique<VirtualPacer>(service_);
    } else {
      thread_ = std::make_unique<MasterThread>(service_);
    }
  }
  [[nodiscard]] bool started() const override { return thread_ || pacer_; }
  void stop() override { end_thread(); }
  bool step() override { return service_.step(); }
  void run_for(Nanoseconds duration) override { service_.run_for(duration); }
  [[nodiscard]] bool online() const override { return service_.online(); }

 private:
  void end_thread() {
    pacer_.reset();
    thread_.reset();
  }
  // In this order: the thread ends before the service, the service before the clock.
  std::unique_ptr<Clock> clock_;
  MasterService service_;
  std::unique_ptr<MasterThread> thread_;
  std::unique_ptr<VirtualPacer> pacer_;
};

}  // namespace

std::unique_ptr<BackgroundMaster> make_background_master(OpenedLink link) {
  return std::make_unique<ServedMaster>(std::move(link));
}

}  // namespace syncline
