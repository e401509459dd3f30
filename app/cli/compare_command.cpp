// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/composition/load_config.h"
#include "config/network_compare.h"

namespace syncline::cli {
namespace {

struct Options {
  std::string left, right;
  bool json = false;
};

Json to_json(const std::vector<NetworkDifference>& differences) {
  Json rows = Json::array();
  for (const auto& d : differences) {
    rows.push_back({{"where", d.where}, {"field", d.field}, {"left", d.left}, {"right", d.right}});
  }
  return rows;
}

void compare(Context& context, const Options& options) {
  const auto left = load_config(options.left);
  if (!left) return context.fail_with(left.error());
  const auto right = load_config(options.right);
  if (!right) return context.fail_with(right.error());
  const auto differences = compare_networks(left->config, right->config);
  if (!differences.empty()) context.exit_code = kAnswerIsNo;
  if (options.json) {
    return context.print({{"left", options.left}, {"right", options.right}, {"differences", to_json(differences)}});
  }
  for (const auto& difference : differences) context.console.out << describe(difference) << '\n';
  context.console.out << fmt::format("{} differences in the commands\n", differences.size());
}

}  // namespace

void add_compare_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("compare", "Compare what two projects or ENI files make a master send");
  auto options = std::make_shared<Options>();
  command->add_option("left", options->left, "Project or ENI file")->required();
  command->add_option("right", options->right, "Project or ENI file")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { compare(context, *options); });
}

}  // namespace syncline::cli
