// SPDX-License-Identifier: Apache-2.0
#include "app/composition/background_master.h"

#include <utility>

#include "app/composition/open_link.h"
#include "app/composition/virtual_pacer.h"
#include "master/master_service.h"

namespace syncline {
namespace {

class ComposedMaster final : public BackgroundMaster {
 public:
  explicit ComposedMaster(OpenedLink opened)
      : clock_(std::move(opened.clock)), service_(std::move(opened.link), *clock_) {}
  ~ComposedMaster() override {
    pacer_.reset();
    thread_.reset();
    service_.shut_down();
  }
  ComposedMaster(const ComposedMaster&) = delete;
  ComposedMaster& operator=(const ComposedMaster&) = delete;

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
  bool step() override { return service_.step(); }
  void run_for(Nanoseconds duration) override { service_.run_for(duration); }
  [[nodiscard]] bool online() const override { return service_.online(); }

 private:
  // In this order: the thread ends before the service, the service before the clock.
  std::unique_ptr<Clock> clock_;
  MasterService service_;
  std::unique_ptr<MasterThread> thread_;
  std::unique_ptr<VirtualPacer> pacer_;
};

}  // namespace

Result<std::unique_ptr<BackgroundMaster>> open_background_master(std::string_view link) {
  auto opened = open_link(link);
  if (!opened) return tl::unexpected(opened.error());
  return std::make_unique<ComposedMaster>(std::move(*opened));
}

}  // namespace syncline
