// SPDX-License-Identifier: Apache-2.0
#include "config/command_data.h"

#include <gtest/gtest.h>

#include <optional>

#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "protocol/command.h"

namespace syncline {
namespace {

CyclicCmd command_of(Command command, std::uint32_t input_offset, std::uint32_t output_offset) {
  CyclicCmd cmd;
  cmd.command = command;
  cmd.data_length = 4;
  cmd.input_offset = input_offset;
  cmd.output_offset = output_offset;
  return cmd;
}

TEST(CommandData, OutputsGoWithWhatWritesAndInputsComeWithWhatReads) {
  ProcessImage image;
  const std::optional<ImageRange> here = ImageRange{64, 16}, elsewhere = ImageRange{96, 16};
  struct Kind {
    Command command;
    bool writes, reads;
  };
  for (const auto& kind : {Kind{Command::kLrw, true, true}, Kind{Command::kLwr, true, false},
                           Kind{Command::kLrd, false, true}, Kind{Command::kBrd, false, false}}) {
    const auto command = command_of(kind.command, 8, 8);
    EXPECT_EQ(writes_outputs(command, here, image), kind.writes);
    EXPECT_EQ(reads_inputs(command, here, image), kind.reads);
    EXPECT_FALSE(writes_outputs(command, elsewhere, image) || reads_inputs(command, elsewhere, image));
    EXPECT_FALSE(writes_outputs(command, std::nullopt, image) || reads_inputs(command, std::nullopt, image));
  }
  // Where a tool counts the headers, too.
  image.command_data_offset = 10;
  EXPECT_FALSE(writes_outputs(command_of(Command::kLrw, 8, 8), here, image));
  EXPECT_TRUE(writes_outputs(command_of(Command::kLrw, 8, 0), elsewhere, image));
}

TEST(CommandData, OfASlaveThatHasBothBothAreInTheBaseTask) {
  NetworkConfig config;
  config.slaves.resize(5);
  config.slaves[0].send = config.slaves[0].receive = ImageRange{0, 8};
  config.slaves[1].send = ImageRange{8, 8};
  config.slaves[1].receive = ImageRange{64, 8};
  config.slaves[2].send = ImageRange{64, 8};
  config.slaves[3].receive = ImageRange{16, 8};
  EXPECT_FALSE(is_exchanged_in_each_cycle(config, 0)) << "nothing is sent";
  config.cyclic.resize(2);
  config.cyclic[0].frames = {CyclicFrame{{command_of(Command::kNop, 0, 0)}},
                             CyclicFrame{{command_of(Command::kLrw, 0, 0)}}};
  config.cyclic[1].frames = {CyclicFrame{{command_of(Command::kLrw, 8, 8)}}};
  EXPECT_TRUE(is_exchanged_in_each_cycle(config, 0));
  EXPECT_FALSE(is_exchanged_in_each_cycle(config, 1)) << "its inputs come seldom";
  EXPECT_FALSE(is_exchanged_in_each_cycle(config, 2));
  EXPECT_TRUE(is_exchanged_in_each_cycle(config, 3));
  EXPECT_TRUE(is_exchanged_in_each_cycle(config, 4)) << "has none";
}

}  // namespace
}  // namespace syncline
