// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/composition/open_link.h"
#include "engine/slave_eeprom.h"
#include "master/sii/sii_writer.h"

namespace syncline::cli {
namespace {

struct SiiOptions {
  EepromRequest slave;
  std::string file;
  std::uint16_t alias = 0;
  bool json = false, undo = false;
};

void save(Context& context, const SiiOptions& options) {
  const auto distinct = CommandFiles().reads_link("link", options.slave.link).writes("file", options.file).check();
  if (!distinct) return context.fail_with(distinct.error());
  const auto bytes = save_eeprom(options.slave, options.file);
  if (!bytes) return context.fail_with(bytes.error());
  if (options.json) return context.print({{"file", options.file}, {"bytes", *bytes}});
  context.console.out << fmt::format("{}: {} bytes from slave {}\n", options.file, *bytes, options.slave.position);
}

void print_report(Context& context, const SiiOptions& options, const Result<SiiWriteReport>& report,
                  std::string_view what) {
  if (!report) return context.fail_with(report.error());
  if (options.json) {
    return context.print({{"position", options.slave.position},
                          {"words", report->words},
                          {"written", report->written},
                          {"verified", true}});
  }
  context.console.out << fmt::format(
      "slave {}: {}; {} of {} words were different and written, all read back right. The ESC "
      "takes its configuration and alias from the EEPROM at the next power-on.\n",
      options.slave.position, what, report->written, report->words);
}

CLI::App* add_slave_command(CLI::App& sii, const std::shared_ptr<SiiOptions>& options, const std::string& name,
                            const std::string& description) {
  auto* command = sii.add_subcommand(name, description);
  command->add_option("link", options->slave.link, "LINK")->required();
  command->add_option("position", options->slave.position, "Position of the slave, 0 is the first")->required();
  command->add_flag("--json", options->json, "Print JSON");
  return command;
}

/// Runs `work` with Ctrl-C leading to an orderly end: what was half written is put back.
template <class Work>
std::function<void()> interruptible(const std::shared_ptr<SiiOptions>& options, Work work) {
  return [options, work] {
    const InterruptGuard interrupt;
    options->slave.open = [](const std::string& link) { return open_link(link); };
    options->slave.cancel = &interrupt.interrupted();
    work(*options);
  };
}

}  // namespace

void add_sii_command(CLI::App& app, Context& context) {
  auto* sii = app.add_subcommand("sii", "Read or write the EEPROM of a slave");
  sii->require_subcommand(1);

  auto reading = std::make_shared<SiiOptions>();
  auto* read = add_slave_command(*sii, reading, "read", "Copy the EEPROM into a file");
  read->add_option("file", reading->file, "File to write")->required();
  read->callback(interruptible(reading, [&context](const SiiOptions& options) { save(context, options); }));

  auto writing = std::make_shared<SiiOptions>();
  auto* write = add_slave_command(*sii, writing, "write", "Write a file into the EEPROM and verify it");
  write->add_option("file", writing->file, "EEPROM image (binary)")->required();
  write->callback(interruptible(writing, [&context](const SiiOptions& options) {
    print_report(context, options, load_eeprom(options.slave, options.file), options.file + " is in the EEPROM");
  }));

  auto naming = std::make_shared<SiiOptions>();
  auto* alias = add_slave_command(*sii, naming, "alias", "Write the station alias with its checksum");
  alias->add_option("value", naming->alias, "Station alias, 0 to 65535; 0 is none")->required();
  alias->callback(interruptible(naming, [&context](const SiiOptions& options) {
    print_report(context, options, set_eeprom_alias(options.slave, options.alias),
                 fmt::format("the alias is {}", options.alias));
  }));

  auto finishing = std::make_shared<SiiOptions>();
  auto* finish =
      add_slave_command(*sii, finishing, "finish", "End a write that was cut short because the program was killed");
  finish->add_flag("--undo", finishing->undo, "Put back what the EEPROM held before that write");
  finish->callback(interruptible(finishing, [&context](const SiiOptions& options) {
    print_report(context, options, finish_eeprom(options.slave, options.undo),
                 options.undo ? "the write is taken back" : "the write is finished");
  }));
}

}  // namespace syncline::cli
