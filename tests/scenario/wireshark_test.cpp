// SPDX-License-Identifier: Apache-2.0
// Frames before the eyes of an implementation that is not ours: Wireshark's dissector.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/composition/open_link.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "compile/compile.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/project_builder.h"
#include "record/black_box.h"
#include "tests/support/pcapng_file.h"
#include "tests/support/source_dir.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen((command + " 2>/dev/null").c_str(), "r"),
                                                             ::pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (const auto size = std::fread(part.data(), 1, part.size(), pipe.get())) text.append(part.data(), size);
  return text;
}

class Wireshark : public testing::Test {
 protected:
  void SetUp() override {
    if (output_of("tshark --version").empty())
      GTEST_SKIP() << "tshark is not here; scripts/setup --with-peers installs it";
  }
  void TearDown() override { fs::remove(capture_); }
  [[nodiscard]] std::string dissect(const std::string& options) const {
    return output_of("tshark -n -r " + capture_ + " " + options);
  }
  const std::string capture_ =
      (fs::temp_directory_path() / ("syncline-wireshark-" + std::to_string(::getpid()) + ".pcapng")).string();
};

TEST_F(Wireshark, FindsNothingMalformedInABringUpAndAMinuteOfOperation) {
  const std::string link = "sim:" + test::source_dir() + "/resources/demo/machine.toml?virtual";
  const auto scan = scan_bus(open_link(link));
  ASSERT_TRUE(scan);
  eni::EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  auto project = eni::project_from_scan(*scan, catalogue).project;
  project.master.dc.sync_window.enabled = true;
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  RunRequest request;
  request.duration = 65 * kSecond;
  request.capture = capture_;
  const auto outcome = run_network(compiled->config, open_link(link), request);
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->report.state, AlState::kOp);

  EXPECT_EQ(dissect("-Y '_ws.malformed || _ws.expert.severity == error'"), "");
  EXPECT_EQ(dissect("-Y '!ecatf' -c 10"), "") << "frames that are no EtherCAT to it";
  // A minute of cycles, out and back.
  const auto cycles = dissect("-Y 'ecat.lad && ecat.cmd == 0x0c' -T fields -e frame.number");
  EXPECT_GT(std::ranges::count(cycles, '\n'), 2 * 55'000);

  EXPECT_EQ(dissect("-Y 'eth.src == 00:00:00:00:00:00' -c 10"), "") << "frames without a source address";

  // Registers and mailbox by the dissector's names, wherever in the bring-up they come.
  const auto words = dissect(
      "-V -Y 'ecat.ado < 0x900 || ecat.ado == 0x918 || (ecat.ado > 0x91f && ecat.ado < 0x92c) || "
      "ecat.ado > 0x92c'");
  for (const auto* name : {"Phys Addr (0x10)", "ESC Status (0x110)", "AL Ctrl (0x120)", "AL Status (0x130)",
                           "DC RecvTime (0x918)", "DC SysTimeOffs", "DC SysTimeDelay (0x928)", "DC SpeedStart (0x930)",
                           "DC Activation (0x981)", "DC CycTime0 (0x9a0)", "DC StartTime0 (0x990)",
                           "Type: CoE (CANopen over EtherCAT)", "'Initiate Download' (1) Idx=0x1c12"}) {
    EXPECT_NE(words.find(name), std::string::npos) << name;
  }
}

/// Files of a black box, one of which a kill has cut in its last block.
TEST_F(Wireshark, ReadsABlackBoxWithItsComments) {
  const test::TemporaryFolder folder;
  const std::string link = "sim:" + test::source_dir() + "/resources/demo/machine.toml?virtual";
  const auto scan = scan_bus(open_link(link));
  ASSERT_TRUE(scan);
  eni::EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  const auto compiled = compile(eni::project_from_scan(*scan, catalogue).project);
  ASSERT_TRUE(compiled);
  std::unique_ptr<BlackBox> box;
  RunRequest request;
  request.duration = 12 * kSecond;
  request.on_ready = [&](MasterChannels& channels) -> Status {
    auto started = BlackBox::start(channels.frames, {.name = folder.file("box"),
                                                     .most_bytes = 16U << 20,
                                                     .keep_free_bytes = 0,
                                                     .virtual_time = true,
                                                     .program = "test",
                                                     .link = link,
                                                     .description = "demo"});
    if (!started) return tl::unexpected(started.error());
    box = std::move(*started);
    return {};
  };
  request.on_event = [&](const Event& event) {
    if (event.is<events::Online>()) box->note(event.time, "the bus is up");
  };
  ASSERT_TRUE(run_network(compiled->config, open_link(link), request));
  ASSERT_TRUE(box->finish());
  std::string comments;
  std::size_t frames = 0;
  const auto files = test::files_in(folder.path());
  ASSERT_GT(files.size(), 2U);
  for (const auto& file : files) {
    if (file == files.back()) fs::resize_file(file, fs::file_size(file) - 130);
    const auto of_file = [&](const std::string& options) { return output_of("tshark -n -r " + file + " " + options); };
    EXPECT_EQ(of_file("-Y '_ws.malformed || _ws.expert.severity == error || !ecatf'"), "") << file;
    const auto numbers = of_file("-T fields -e frame.number");
    frames += static_cast<std::size_t>(std::ranges::count(numbers, '\n'));
    comments += of_file("-Y frame.comment -T fields -e frame.comment");
  }
  EXPECT_EQ(frames, test::packets_in(files).size());
  EXPECT_GE(frames + 2, box->report().frames);
  EXPECT_EQ(comments, "the bus is up\n");
}

}  // namespace
}  // namespace syncline
