// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "protocol/al_state.h"

namespace syncline {
struct CyclicTask;
struct InitCmd;
struct MailboxConfig;
struct MasterConfig;
struct NetworkConfig;
struct ProcessImage;
struct SlaveConfig;
}  // namespace syncline

/// The parts of the ENI reader; read_eni() of eni_file.h puts them together. Missing elements give defaults, bad ones
/// leave an error in the context.
namespace syncline::eni {

class EniElement;

/// Slave, Cyclic and ProcessImage, each of which can be read by itself.
[[nodiscard]] bool is_eni_piece(std::string_view element, std::string_view parent);
[[nodiscard]] MasterConfig read_master(const EniElement& master);
[[nodiscard]] std::optional<MailboxConfig> read_mailbox(const EniElement& element);
[[nodiscard]] SlaveConfig read_slave(const EniElement& slave, std::uint16_t position);
/// One command, an InitCmd or an IdentifyCmd.
[[nodiscard]] InitCmd read_init_cmd(const EniElement& element);
[[nodiscard]] std::vector<InitCmd> read_init_cmds(const EniElement& init_cmds);
[[nodiscard]] CyclicTask read_cyclic(const EniElement& cyclic);
[[nodiscard]] ProcessImage read_process_image(const EniElement& image);
[[nodiscard]] std::vector<Transition> read_transitions(const EniElement& cmd);

/// What an ENI says only through its commands: see eni_reader_derived.cpp.
void derive_slave(SlaveConfig& slave);
void derive_network(NetworkConfig& config, const std::vector<std::uint16_t>& previous_addresses);

}  // namespace syncline::eni
