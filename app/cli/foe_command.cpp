// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/cli/visit_options.h"
#include "master/mailbox/foe_client.h"
#include "master/startup/slave_visit.h"
#include "support/text_bytes.h"
#include "support/whole_file.h"

namespace syncline::cli {
namespace {

struct FoeOptions {
  SlaveOnLink slave;
  std::string name, file;
  std::uint32_t password = 0;
  bool json = false, boot = false;
};

void report(Context& context, const FoeOptions& options, std::size_t bytes, bool written) {
  if (options.json) {
    return context.print({{"position", options.slave.position},
                          {"name", options.name},
                          {"file", options.file},
                          {"bytes", bytes},
                          {"written", written}});
  }
  context.console.out << fmt::format("slave {}: {} bytes of \"{}\" {} {}\n", options.slave.position, bytes,
                                     options.name, written ? "written from" : "read into", options.file);
}

void read_file(Context& context, const FoeOptions& options) {
  const auto distinct = CommandFiles().reads_link("link", options.slave.link).writes("file", options.file).check();
  if (!distinct) return context.fail_with(distinct.error());
  with_mailbox(
      context, options.slave,
      [&](SlaveVisit& visit) -> Status {
        const auto bytes = FoeClient(visit.mailbox()).read(options.name, options.password);
        if (!bytes) return tl::unexpected(bytes.error());
        if (auto status = write_whole_file(options.file, *bytes); !status) return status;
        report(context, options, bytes->size(), false);
        return {};
      },
      options.boot);
}

void write_file(Context& context, const FoeOptions& options) {
  const auto bytes = read_whole_file(options.file);
  if (!bytes) return context.fail_with(bytes.error());
  with_mailbox(
      context, options.slave,
      [&](SlaveVisit& visit) -> Status {
        if (auto status = FoeClient(visit.mailbox()).write(options.name, bytes_of(*bytes), options.password); !status)
          return status;
        report(context, options, bytes->size(), true);
        return {};
      },
      options.boot);
}

void add(CLI::App& foe, Context& context, const char* name, const char* description,
         void (*work)(Context&, const FoeOptions&)) {
  auto options = std::make_shared<FoeOptions>();
  auto* command = foe.add_subcommand(name, description);
  add_slave_options(*command, options->slave, options->json);
  command->add_option("name", options->name, "Name of the file in the slave")->required();
  command->add_option("file", options->file, "File here")->required();
  command->add_option("--password", options->password, "Password of the slave, a number");
  command->add_flag("--boot", options->boot,
                    "Lead the slave to BOOT for it, as firmware updates want, and back afterwards");
  command->callback([&context, options, work] { work(context, *options); });
}

}  // namespace

void add_foe_command(CLI::App& app, Context& context) {
  auto* foe = app.add_subcommand("foe", "Read or write a file of a slave (FoE)");
  foe->require_subcommand(1);
  add(*foe, context, "read", "Copy a file of the slave", read_file);
  add(*foe, context, "write", "Give a file to the slave", write_file);
}

}  // namespace syncline::cli
