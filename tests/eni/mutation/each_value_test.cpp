// SPDX-License-Identifier: Apache-2.0
// Changes one value of a good ENI after the other, wherever it stands, and asks the comparison whether it sees it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "compare/compare_configs.h"
#include "eni/format/eni_file.h"
#include "eni/mutation/defects.h"
#include "eni/xml/xml_text.h"
#include "support/eni_values.h"
#include "support/sample_folder.h"

namespace syncline::test {
namespace {

using Texts = std::vector<std::string>;

/// Elements that tell a reader of the file something and neither master nor slave: names, drawings, the choice that a
/// configurator has.
bool is_for_readers(const std::string& element) {
  static const std::set<std::string> elements = {"Comment",   "Name",       "Physics",   "ProductRevision",
                                                 "Exclude",   "TaskId",     "ProfileNo", "AddInfo",
                                                 "ShortName", "VendorName", "Priority"};
  return elements.contains(element);
}

/// The innermost element of that name around a place, from its start tag on; "" = none.
std::string around(const std::string& text, std::size_t at, const std::string& element) {
  const auto begin = text.rfind("<" + element, at);
  const auto end = begin == std::string::npos ? begin : text.find("</" + element + ">", begin);
  return end == std::string::npos || end < at ? "" : text.substr(begin, end - begin);
}

/// In a PDO: its data types and names say what is said by the variables; what no SyncManager carries is not exchanged.
bool is_word_of_pdo(const std::string& text, const EniValue& leaf) {
  std::string pdo = around(text, leaf.at, "RxPdo");
  if (pdo.empty()) pdo = around(text, leaf.at, "TxPdo");
  if (pdo.empty()) return false;
  const bool assigned = pdo.substr(0, pdo.find('>')).find("Sm=") != std::string::npos;
  return !assigned || leaf.element == "DataType";
}

/// A broadcast counts in its address, and a NOP goes to nobody.
bool is_address_of_all(const std::string& text, const EniValue& leaf) {
  if (leaf.element != "Adp") return false;
  const auto command = text.rfind("<Cmd>", leaf.at) + 5;
  const std::string code = text.substr(command, text.find('<', command) - command);
  return code == "0" || code == "7" || code == "8";
}

bool is_number(const std::string& value, const char* digits) {
  return !value.empty() && value.find_first_not_of(digits) == std::string::npos;
}

/// What stands there instead: other numbers, other bytes, and what stands in the next two elements of the kind.
Texts others(const std::string& element, const std::string& value, const Texts& of_kind, std::size_t place) {
  Texts out;
  if (element == "Data" || element == "DataMask") {
    for (std::size_t i = 0; i + 1 < value.size(); i += 2) {
      for (const unsigned bit : {0x01U, 0x04U, 0x80U}) {
        std::string bytes = value;
        bytes.replace(i, 2, fmt::format("{:02x}", std::stoul(value.substr(i, 2), nullptr, 16) ^ bit));
        out.push_back(std::move(bytes));
      }
    }
  } else if (is_number(value, "0123456789") && value.size() < 10) {
    const auto number = std::stol(value);
    for (const auto other : {number + 1, number + 8, std::max(number - 1, 0L), 0L})
      out.push_back(std::to_string(other));
  }
  for (std::size_t i = 1; i <= 2 && i < of_kind.size(); ++i) out.push_back(of_kind[(place + i) % of_kind.size()]);
  std::erase(out, value);
  return out;
}

class EachValue : public testing::TestWithParam<const char*> {};

/// One of `kEvery` is tried: all of them take a minute.
TEST_P(EachValue, ThatIsChangedIsADifference) {
  constexpr std::size_t kEvery = 29, kEnough = 90;
  const std::string whole = *eni::read_file((std::filesystem::path(source_dir()) / "tests" / GetParam()).string());
  const auto original = eni::parse_eni(whole, "whole.xml");
  ASSERT_TRUE(original);
  const auto leaves = leaves_of(whole);
  std::map<std::string, Texts> kinds;
  for (const EniValue& leaf : leaves) kinds[leaf.element].push_back(whole.substr(leaf.at, leaf.length));
  std::map<std::string, std::size_t> places;
  std::size_t turn = whole.size() % kEvery, tried = 0;
  for (const EniValue& leaf : leaves) {
    const Texts& of_kind = kinds[leaf.element];
    const std::string value = whole.substr(leaf.at, leaf.length);
    const std::size_t place = places[leaf.element]++;
    if (is_for_readers(leaf.element) || is_word_of_pdo(whole, leaf) || is_address_of_all(whole, leaf)) continue;
    for (const std::string& other : others(leaf.element, value, of_kind, place)) {
      if (turn++ % kEvery != 0) continue;
      std::string text = whole;
      text.replace(leaf.at, leaf.length, other);
      const auto changed = eni::parse_eni(text, "changed.xml");
      if (!changed || *changed == *original) continue;  // no ENI any more, or the same number in other digits
      ++tried;
      EXPECT_FALSE(compare_configs(*original, *changed).empty())
          << leaf.element << " " << value << " -> " << other << " in line "
          << 1 + std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(leaf.at), '\n');
    }
  }
  EXPECT_GT(tried, kEnough);
}

INSTANTIATE_TEST_SUITE_P(OwnFiles, EachValue,
                         testing::Values("samples/eni/row.eni.xml", "samples/eni/drives.eni.xml",
                                         "golden/small_machine.eni.xml", "golden/small_machine_twincat.eni.xml"));

NetworkConfig row() { return *eni::read_eni((own_samples("eni") / "row.eni.xml").string()); }

bool is_different(const NetworkConfig& left, const NetworkConfig& right) {
  return !compare_configs(left, right).empty() && !compare_configs(right, left).empty();
}

/// A slave comes to its state or not by the order of what it is told: whichever two neighbours change places.
TEST(EachOrder, OfTwoCommandsOfATransitionIsADifference) {
  const NetworkConfig good = row();
  std::size_t tried = 0;
  for (std::size_t s = 0; s < good.slaves.size(); ++s) {
    const auto& commands = good.slaves[s].init_cmds;
    for (std::size_t i = 0; i + 1 < commands.size(); ++i) {
      const bool together = std::ranges::any_of(commands[i].transitions, [&](Transition t) {
        return std::ranges::find(commands[i + 1].transitions, t) != commands[i + 1].transitions.end();
      });
      InitCmd next = commands[i + 1];
      next.comment = commands[i].comment;
      if (!together || next == commands[i]) continue;
      NetworkConfig swapped = good;
      std::swap(swapped.slaves[s].init_cmds[i], swapped.slaves[s].init_cmds[i + 1]);
      EXPECT_TRUE(is_different(good, swapped))
          << "slave " << s << ": " << commands[i].comment << " and " << commands[i + 1].comment;
      ++tried;
    }
  }
  EXPECT_GT(tried, 50U);
}

/// The bytes of an FMMU that is switched off follow from no place.
TEST(EachFmmu, ThatIsSwitchedOffIsComparedByteByByte) {
  const NetworkConfig good = row();
  for (const std::size_t byte : {0U, 3U, 4U, 6U, 7U, 8U, 12U}) {
    NetworkConfig changed = good;
    auto& commands = changed.slaves[1].init_cmds;
    const auto cleared = std::ranges::find_if(commands, [](const InitCmd& cmd) {
      return cmd.ado == 0x0600 && cmd.data.size() == 16 && (cmd.data[12] & 1) == 0;
    });
    ASSERT_NE(cleared, commands.end());
    cleared->data[byte] ^= 0x04;
    EXPECT_TRUE(is_different(good, changed)) << "byte " << byte;
  }
}

TEST(EachPdo, ThatIsCarriedAndNotDescribedAnyMoreIsADifference) {
  const NetworkConfig good = row();
  NetworkConfig changed = good;
  changed.slaves[1].pdos.erase(changed.slaves[1].pdos.begin());
  EXPECT_TRUE(is_different(good, changed));
  changed = good;
  changed.slaves[1].pdos[0].pdo.sync_manager = 3;
  EXPECT_TRUE(is_different(good, changed));
  // Whoever describes none at all says nothing about them.
  changed = good;
  changed.slaves[1].pdos.clear();
  EXPECT_FALSE(is_different(good, changed));
}

TEST(EachVariable, IsFoundByItsNameAndTakenForItsType) {
  const NetworkConfig good = row();
  NetworkConfig changed = good;
  changed.image.inputs[1].name = changed.image.inputs[0].name;
  EXPECT_TRUE(is_different(good, changed));
  changed = good;
  changed.image.outputs[0].data_type = "USINT";
  EXPECT_TRUE(is_different(good, changed));
  // Another tool has other names for all, or writes no types.
  changed = good;
  for (auto* variables : {&changed.image.inputs, &changed.image.outputs}) {
    for (Variable& variable : *variables) {
      variable.name = "Term." + variable.name;
      variable.data_type.clear();
    }
  }
  EXPECT_FALSE(is_different(good, changed));
}

TEST(EachCycle, ThatIsGivenAndGuessedIsNotTheSame) {
  const NetworkConfig good = row();
  NetworkConfig changed = good;
  changed.cyclic[0].cycle_time_given = false;
  EXPECT_TRUE(is_different(good, changed));
}

}  // namespace
}  // namespace syncline::test
