// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/init_cmd.h"

namespace syncline {
struct CyclicTask;
struct MailboxConfig;
struct MasterConfig;
struct ProcessImage;
struct SlaveConfig;
}  // namespace syncline

/// The parts of the ENI writer; write_eni() of eni_file.h puts them together. Element order is that of the schema.
namespace syncline::eni {

class EniText;

/// ENI Validate@Type.
[[nodiscard]] std::string_view validate_name(ValidateType type);

void write_master(EniText& out, const MasterConfig& master);
void write_slave(EniText& out, const SlaveConfig& slave, const std::vector<SlaveConfig>& all);
void write_process_data(EniText& out, const SlaveConfig& slave);
void write_mailbox(EniText& out, const MailboxConfig& mailbox);
/// `element`: InitCmd, or IdentifyCmd in a hot-connect group.
void write_init_cmd(EniText& out, const InitCmd& cmd, const char* element = "InitCmd");
void write_init_cmds(EniText& out, const std::vector<InitCmd>& cmds);
void write_cyclic(EniText& out, const CyclicTask& task);
void write_process_image(EniText& out, const ProcessImage& image);

}  // namespace syncline::eni
