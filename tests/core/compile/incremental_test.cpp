// SPDX-License-Identifier: Apache-2.0
#include "compile/incremental.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "settings/settings_keys.h"
#include "support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

/// An edit of the kind that a user makes: of the master, of one slave, or of the bus.
Project edited(Project project, std::uint32_t seed) {
  const Project other = test::RandomProject(seed).project();
  switch (seed % 7) {
    case 0:
      project.master = other.master;
      break;
    case 1:
      project.slaves.insert(project.slaves.end(), other.slaves.begin(), other.slaves.end());
      break;
    case 2:
      if (project.slaves.size() > 1) project.slaves.erase(project.slaves.begin());
      break;
    case 3:
      if (!other.slaves.empty()) project.slaves[seed / 7 % project.slaves.size()] = other.slaves.front();
      break;
    case 4: {
      auto& slave = project.slaves[seed / 7 % project.slaves.size()];
      slave.dc.op_mode.clear();
      slave.name += "x";
      break;
    }
    case 5: {
      auto& slave = project.slaves[seed / 7 % project.slaves.size()];
      std::swap(slave.output_unit, slave.input_unit);
      slave.assigned_tx_pdos.clear();
      break;
    }
    default:
      project.slaves[seed / 7 % project.slaves.size()].mailbox.state_bit ^= true;
      break;
  }
  return project;
}

TEST(IncrementalCompiler, GivesWhatCompileGivesAfterAnyEdits) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed, const std::vector<std::uint32_t>& edits, bool twincat) {
    const CompileOptions options{twincat ? EniDialect::kTwinCat : EniDialect::kEcEngineer};
    Project project = test::RandomProject(seed).project();
    project.slaves.push_back(default_slave(test::RandomProject(seed + 1).device(), 0));
    IncrementalCompiler compiler(options);
    for (std::size_t i = 0; i <= edits.size(); ++i) {
      const auto whole = compile(project, options);
      const auto updated = compiler.update(project);
      RC_ASSERT(whole.has_value() == updated.has_value());
      if (!whole) break;
      RC_ASSERT((*updated)->findings == whole->findings);
      RC_ASSERT((*updated)->config == whole->config);
      if (i < edits.size()) project = edited(std::move(project), edits[i]);
    }
  }));
}

Project two_slaves() {
  Project project;
  project.slaves = {default_slave(sample::coupler(), 0), default_slave(sample::digital_output(), 1)};
  return project;
}

TEST(IncrementalCompiler, DoesOnlyWhatAnEditTouches) {
  Project project = two_slaves();
  IncrementalCompiler compiler;
  ASSERT_TRUE(compiler.update(project));
  EXPECT_EQ(compiler.changed_slaves(), 2U);
  project.slaves[1].name = "Valve";
  const auto result = compiler.update(project);
  ASSERT_TRUE(result);
  EXPECT_EQ(compiler.changed_slaves(), 1U);
  EXPECT_EQ((*result)->config.slaves[1].name, "Valve");
  ASSERT_TRUE(compiler.update(project));
  EXPECT_EQ(compiler.changed_slaves(), 0U);
}

TEST(IncrementalCompiler, ComesBackAfterAProjectThatCannotBeBuilt) {
  Project project = two_slaves();
  IncrementalCompiler compiler;
  ASSERT_TRUE(compiler.update(project));
  EXPECT_EQ(compiler.update(Project{}).error().code, ErrorCode::kConfiguration);
  const auto result = compiler.update(project);
  ASSERT_TRUE(result);
  EXPECT_EQ((*result)->config, compile(project)->config);
}

}  // namespace
}  // namespace syncline
