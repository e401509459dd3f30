// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/difference_json.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/terminal_reason.h"
#include "app/composition/load_config.h"
#include "app/composition/open_link.h"
#include "compare/compare_configs.h"
#include "compare/compare_run_time.h"
#include "compare/network_compare.h"
#include "engine/compare_bus.h"
#include "engine/opened_link.h"
#include "eni/project/project_file.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct CompareOptions {
  std::string left, right;
  bool details = false, look_only = false, json = false;
};

Json position(const std::optional<std::size_t>& slave) { return slave ? Json(*slave) : Json(); }

Json config_differences_json(const std::vector<ConfigDifference>& differences) {
  Json rows = Json::array();
  for (const auto& d : differences) {
    rows.push_back({{"where", place_text(d)},
                    {"field", facts_text(d.what)},
                    {"code", d.what.code},
                    {"left", d.left},
                    {"right", d.right},
                    {"group", group_name(d.group)},
                    {"slave", position(d.left_slave)},
                    {"right_slave", position(d.right_slave)},
                    {"text", describe(d)}});
  }
  return rows;
}

/// One line a difference, below a heading for each slave.
void print_differences(std::ostream& out, const std::vector<ConfigDifference>& differences) {
  std::string place;
  for (const auto& difference : differences) {
    if (place_text(difference) != place) {
      place = place_text(difference);
      out << place << '\n';
    }
    const std::string text = describe(difference);
    out << fmt::format("  {:<13} {}\n", group_name(difference.group), text.substr(place.size() + 2));
  }
}

/// LINK texts begin with one of these; everything else is a file.
bool is_link(const std::string& text) {
  return text.starts_with("sim:") || text.starts_with("nic:") || text.starts_with("replay:");
}

struct Compared {
  std::vector<ConfigDifference> differences;
  std::vector<NetworkDifference> details;
  std::vector<Finding> scan_findings;
};

Result<Compared> compare_any(const CompareOptions& options) {
  const auto left = load_config(options.left);
  if (!left) return tl::unexpected(left.error());
  Compared out;
  if (is_link(options.right)) {
    const InterruptGuard interrupt;
    auto bus =
        compare_bus(left->config, open_link(options.right), {.look_only = options.look_only}, &interrupt.interrupted());
    if (!bus) return tl::unexpected(bus.error());
    return Compared{std::move(bus->differences), {}, std::move(bus->findings)};
  }
  const auto right = load_config(options.right);
  if (!right) return tl::unexpected(right.error());
  out.differences = compare_configs(left->config, right->config);
  if (options.details) out.details = compare_networks(left->config, right->config);
  const auto left_project = eni::load_project(options.left);
  const auto right_project = eni::load_project(options.right);
  if (left_project && right_project) {
    const auto run_time = compare_run_time(*left_project, *right_project);
    out.differences.insert(out.differences.end(), run_time.begin(), run_time.end());
  }
  return out;
}

/// What would have no effect.
Status check_options(const CompareOptions& options) {
  if (options.details && is_link(options.right))
    return fail(ErrorCode::kBadValue, "--details", in_terminal("a bus has no commands to compare: leave it out"));
  if (options.look_only && !is_link(options.right)) {
    return fail(ErrorCode::kBadValue, "--look-only",
                in_terminal(options.right + " is a file, and no bus is scanned: leave it out, or name a LINK"));
  }
  return {};
}

void compare(Context& context, const CompareOptions& options) {
  if (const auto status = check_options(options); !status) return context.fail_with(status.error());
  const auto compared = compare_any(options);
  if (!compared) return context.fail_with(compared.error());
  if (!compared->differences.empty()) context.exit_code = kAnswerIsNo;
  for (const Finding& finding : compared->scan_findings) context.warn(finding);
  if (options.json) {
    Json report{{"left", options.left},
                {"right", options.right},
                {"differences", config_differences_json(compared->differences)}};
    if (options.details) report["details"] = differences_json(compared->details);
    return context.print(report);
  }
  print_differences(context.console.out, compared->differences);
  if (options.details) {
    context.console.out << "commands\n";
    for (const auto& difference : compared->details) context.console.out << "  " << describe(difference) << '\n';
  }
  context.console.out << counted(compared->differences.size(), "difference") + "\n";
}

}  // namespace

void add_compare_command(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("compare", "Compare the meaning of two ENI files or projects, or of one with a bus");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("left", options->left, "Project or ENI file")->required();
  command->add_option("right", options->right, "Project or ENI file, or the LINK of a bus")->required();
  command->add_flag("--details", options->details, "Also every command that differs, with its bytes");
  command->add_flag("--look-only", options->look_only, "Scan the bus without writing to it, as scan does");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { compare(context, *options); });
}

}  // namespace syncline::cli
