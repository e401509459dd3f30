// SPDX-License-Identifier: Apache-2.0
#include "exports/exports.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "compile/compile.h"
#include "tests/support/sample_devices.h"

namespace syncline::exports {
namespace {

using testing::HasSubstr;
using testing::Not;

NetworkConfig machine() { return compile(sample::small_machine()).value().config; }

class CHeader : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("syncline-header-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    if (std::system("cc --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no C compiler here";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  int shell(const std::string& command) { return std::system(("cd '" + folder_.string() + "' && " + command).c_str()); }
  std::filesystem::path folder_;
};

NetworkConfig odd_names() {
  NetworkConfig config;
  config.master.name = "a */ b";
  config.image.input_bytes = config.image.output_bytes = 32;
  config.image.inputs = {{"1 Achse.L\xC3\xA4ge /* x", "DINT", "", 32, 3},
                         {"axis.pos", "REAL", "", 32, 64},
                         {"AXIS.POS", "LREAL", "", 64, 128},
                         {"nibble", "SINT", "", 4, 1},
                         {"text", "STRING(15)", "", 128, 0},
                         {"state", "UINT", "", 16, 250}};
  config.image.outputs = {
      {"axis.pos", "DINT", "", 32, 3}, {"int", "BOOL", "", 1, 7}, {"", "LINT", "", 64, 64}, {"r", "REAL", "", 32, 128}};
  return config;
}

TEST_F(CHeader, CompilesAsCAndAsCpp) {
  write("machine.h", c_header(machine(), "machine"));
  write("odd.h", c_header(odd_names(), "2 odd names"));
  write("main.c", "#include \"machine.h\"\n#include \"odd.h\"\n#include \"odd.h\"\nint main(void) { return 0; }\n");
  write("main.cpp", "#include \"machine.h\"\n#include \"odd.h\"\nint main() { return 0; }\n");
  EXPECT_EQ(shell("cc -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only main.c"), 0);
  EXPECT_EQ(shell("c++ -std=c++11 -Wall -Wextra -Wpedantic -Werror -fsyntax-only main.cpp"), 0);
}

TEST_F(CHeader, ReadsAndWritesTheImage) {
  write("odd.h", c_header(odd_names(), "odd"));
  write("main.c", R"(#include "odd.h"
int main(void) {
  uint8_t image[ODD_OUTPUT_BYTES] = {0};
  odd_out_axis_pos(image, -5);
  odd_out_int(image, 1);
  if (odd_in_n(image) != 0) return 1;
  image[0] = image[0];
  if (odd_load(image, 3, 32) != 0xfffffffbu) return 2;
  if ((image[0] & 7u) != 0) return 3;
  odd_out_r(image, 1.5f);
  if (odd_load(image, 128, 32) != 0x3fc00000u) return 4;
  odd_out(image, -2);
  if (odd_load(image, 64, 64) != 0xfffffffffffffffeu) return 5;
  image[0] = 0x0e;
  if (odd_in_nibble(image) != 7) return 6;
  image[0] = 0x1e;
  if (odd_in_nibble(image) != -1) return 7;
  return 0;
}
)");
  // The name of the first input begins with a digit and has bytes that C does not know.
  const std::string header = c_header(odd_names(), "odd");
  EXPECT_THAT(header, HasSubstr("static inline int32_t odd_in_1_achse_l_ge_x(const uint8_t* image)"));
  EXPECT_THAT(header, HasSubstr("static inline double odd_in_axis_pos_2(const uint8_t* image)"));
  EXPECT_THAT(header, Not(HasSubstr("odd_in_text(")));
  EXPECT_THAT(header, HasSubstr("Outside the image"));
  EXPECT_EQ(shell("sed -i 's/odd_in_n(image)/odd_in_1_achse_l_ge_x(image) == 0 ? 1 : 0/' main.c"), 0);
  ASSERT_EQ(shell("cc -std=c99 -Wall -Wextra -Werror -o run main.c"), 0);
  EXPECT_EQ(shell("./run"), 0);
}

TEST(ImageCsv, HasARowAVariable) {
  auto config = machine();
  config.image.inputs[0].name = "a \"b\", c";
  const auto csv = image_csv(config);
  EXPECT_EQ(std::ranges::count(csv, '\n'),
            static_cast<std::ptrdiff_t>(1 + config.image.inputs.size() + config.image.outputs.size()));
  EXPECT_THAT(csv, HasSubstr("input,\"a \"\"b\"\", c\","));
  EXPECT_THAT(csv, testing::StartsWith("direction,name,data_type,bits,byte,bit,comment\r\n"));
}

/// The place of an entry is where the variable of that entry lies.
TEST(PdoCsv, AgreesWithTheVariables) {
  const auto config = machine();
  const auto csv = pdo_csv(config);
  std::size_t found = 0;
  for (const auto* variables : {&config.image.inputs, &config.image.outputs}) {
    for (const auto& variable : *variables) {
      const auto entry = variable.name.substr(variable.name.find('.', variable.name.find('.') + 1) + 1);
      const auto place =
          "," + std::to_string(variable.bit_offset / 8) + "," + std::to_string(variable.bit_offset % 8) + "\r\n";
      const auto plain = "," + std::to_string(variable.bit_size) + "," + entry + "," + variable.data_type + place;
      found += csv.find(plain) != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_EQ(found, config.image.inputs.size() + config.image.outputs.size()) << csv;
  EXPECT_GT(found, 5U);
}

TEST(SlavesCsv, HasARowASlave) {
  const auto config = machine();
  const auto csv = slaves_csv(config);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_THAT(csv, HasSubstr("0x000005EC,0x00000402,0x00010002"));
  EXPECT_THAT(csv, HasSubstr(",reference clock,"));
}

TEST(TopologySvg, ShowsWhoHasASyncSignal) {
  const auto count = [](const std::vector<DeviceDescription>& devices, const std::string& kind) {
    const auto svg = topology_svg(compile(sample::project(devices)).value().config);
    std::size_t found = 0;
    for (std::size_t at = 0; (at = svg.find("class=\"" + kind + "\"", at)) != std::string::npos; ++at) ++found;
    return found;
  };
  const std::vector<DeviceDescription> few{sample::coupler(), sample::servo(), sample::servo()};
  auto more = few;
  more.push_back(sample::servo());
  EXPECT_EQ(count(more, "clocked"), count(few, "clocked") + 1);
  EXPECT_EQ(count(more, "plain"), count(few, "plain"));
  more.back() = sample::coupler();
  EXPECT_EQ(count(more, "clocked"), count(few, "clocked"));
  EXPECT_EQ(count(more, "plain"), count(few, "plain") + 1);
}

TEST(TopologySvg, DrawsEachSlaveOnceAndItsCable) {
  auto project = sample::project({sample::coupler(), sample::servo(), sample::servo(), sample::servo()});
  project.slaves[1].previous = PreviousPort{0, 3};
  project.slaves[2].previous = PreviousPort{1, 1};
  project.slaves[3].previous = PreviousPort{0, 1};
  project.slaves[3].name =
      "<Vorsch\xC3\xBC"
      "be & Co> mit einem sehr sehr langen Namen";
  const auto svg = topology_svg(compile(project).value().config);
  std::size_t boxes = 0;
  for (std::size_t at = 0; (at = svg.find("class=\"box", at)) != std::string::npos; ++at) ++boxes;
  EXPECT_EQ(boxes, 4U);
  EXPECT_THAT(svg, HasSubstr("port D"));
  EXPECT_THAT(svg, HasSubstr("3  &lt;Vorsch\xC3\xBC"
                             "be &amp; Co&gt; mit einem sehr s\xE2\x80\xA6"));
  // The branch is moved to the right, the last slave is not.
  EXPECT_THAT(svg, HasSubstr("<rect x=\"80\" y=\"168\""));
  EXPECT_THAT(svg, HasSubstr("<rect x=\"24\" y=\"312\""));
  EXPECT_THAT(topology_svg(NetworkConfig{}), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace syncline::exports
