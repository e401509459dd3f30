// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "config/compile/compile.h"
#include "eni/esi_reader.h"
#include "master/operation.h"
#include "tests/support/source_dir.h"
#include "tests/support/test_bus.h"

namespace {

// Counts this binary's allocations while a test wants it.
std::atomic<bool> counting{false};
std::atomic<std::size_t> allocations{0};

void* allocate(std::size_t size) {
  if (counting.load(std::memory_order_relaxed)) ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// With inlining the compiler sees malloc on one side only and takes the pair for a mismatch.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
// By default these forms end in the ones above, but a sanitizer brings its own: std::stable_partition would
// get memory from the sanitizer and give it back to us.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (counting.load(std::memory_order_relaxed)) ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept { return operator new(size, tag); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace syncline {
namespace {

/// The bus of the test allocates; that is not the master's doing.
class UncountedLink final : public Link {
 public:
  explicit UncountedLink(Link& inner) : inner_(inner) {}
  Status send(std::span<const std::uint8_t> frame) override {
    const Pause pause;
    return inner_.send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    const Pause pause;
    return inner_.receive(buffer, deadline);
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_.describe(); }

 private:
  struct Pause {
    bool before = counting.exchange(false);
    ~Pause() { counting = before; }
  };
  Link& inner_;
};

TEST(SteadyCycle, AllocatesNothing) {
  VirtualClock clock;
  test::TestBus bus(clock, 2);
  const auto esi = eni::read_esi(test::source_dir() + "/resources/esi/SL-SV7.xml");
  ASSERT_TRUE(esi);
  Project project;
  project.master.dc.sync_window.enabled = true;
  project.master.dc.burst_total = 100;
  for (std::uint16_t i = 0; i < 2; ++i) {
    project.slaves.push_back(default_slave(esi->devices.front(), i));
    sii::Image image;
    image.vendor_id = esi->devices.front().identity.vendor_id;
    image.product_code = esi->devices.front().identity.product_code;
    bus.slave(i).sii = sii::encode(image);
    bus.slave(i).has_mailbox = true;
    bus.slave(i).objects[0x1C320C] = {0, 0};
  }
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  UncountedLink link(bus);
  FrameExchange exchange(link, clock);
  MasterChannels channels;
  Operation operation(compiled->config, exchange, clock, channels);
  ASSERT_TRUE(operation.start(AlState::kOp));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(operation.run_cycle());

  allocations = 0;
  counting = true;
  bool ok = true;
  for (int i = 0; i < 2000; ++i) ok = operation.run_cycle().has_value() && ok;
  counting = false;
  EXPECT_TRUE(ok);
  EXPECT_EQ(allocations, 0U);
  // The counter was read many times meanwhile: this covers the mailbox, too.
  EXPECT_TRUE(operation.run().snapshot.slaves[0].sm2_missed.valid);
}

TEST(SteadyCycle, TheCountingCounts) {
  allocations = 0;
  counting = true;
  auto* memory = new std::vector<int>(100);
  counting = false;
  delete memory;
  EXPECT_GE(allocations, 2U);
}

}  // namespace
}  // namespace syncline
