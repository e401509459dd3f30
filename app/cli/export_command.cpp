// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/cli/context.h"
#include "app/cli/findings_text.h"
#include "app/composition/load_config.h"
#include "eni/eni_file.h"

namespace syncline::cli {
namespace {

struct Options {
  std::string file, output, dialect = "ec-master";
  bool json = false;
};

void export_eni(Context& context, const Options& options) {
  CompileOptions compile_options;
  if (options.dialect == "twincat") compile_options.dialect = EniDialect::kTwinCat;
  const auto compiled = load_config(options.file, compile_options);
  if (!compiled) return context.fail_with(compiled.error());
  const bool refused = has_errors(compiled->findings);
  if (!refused) {
    if (auto status = eni::save_eni(compiled->config, options.output); !status) return context.fail_with(status.error());
  }
  if (refused) context.exit_code = kAnswerIsNo;
  if (options.json) {
    return context.print({{"file", options.output},
                          {"written", !refused},
                          {"slaves", compiled->config.slaves.size()},
                          {"findings", to_json(compiled->findings)}});
  }
  print(context.console.err, compiled->findings);
  if (refused) {
    context.console.err << "synclinectl: " << options.output << " was not written; mend the errors above first\n";
  } else {
    context.console.out << fmt::format("{}: {} slaves\n", options.output, compiled->config.slaves.size());
  }
}

}  // namespace

void add_export_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("export", "Write the ENI file of a project (or of an ENI)");
  auto options = std::make_shared<Options>();
  command->add_option("file", options->file, "Project or ENI file")->required();
  command->add_option("-o,--output", options->output, "ENI file to write")->required();
  command->add_option("--dialect", options->dialect, "ec-master or twincat")
      ->check(CLI::IsMember({"ec-master", "twincat"}));
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { export_eni(context, *options); });
}

}  // namespace syncline::cli
