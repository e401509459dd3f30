// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_schema.h"

#include <algorithm>

namespace syncline::eni {
namespace {

using enum EniValue;

// Columns: name, value, order, at least, at most (0 = any number), type. Inner types stand before those that use them.

constexpr EniChild kValidateChildren[] = {{"Data", kBytes, 0, 1}, {"DataMask", kBytes, 1}, {"Timeout", kInt, 2, 1}};
constexpr EniAttribute kValidateAttributes[] = {{"Type", kText}, {"Signed", kBool}};
constexpr EniType kValidate{kValidateChildren, kValidateAttributes};

constexpr EniChild kInitCmdChildren[] = {{"Transition", kTransition, 0, 0, 0},
                                         {"BeforeSlave", kBool, 1},
                                         {"Comment", kText, 2},
                                         {"Requires", kRequires, 3},
                                         {"Cmd", kByte, 4, 1},
                                         {"Adp", kUInt16, 5},
                                         {"Ado", kUInt16, 5},
                                         {"Addr", kUInt32, 5},
                                         {"Data", kBytes, 6},
                                         {"DataLength", kUInt16, 6},
                                         {"Cnt", kUInt16, 7},
                                         {"Retries", kInt, 8},
                                         {"Validate", kChildren, 9, 0, 1, &kValidate},
                                         {"Timeout", kInt, 9}};
constexpr EniChoice kInitCmdChoices[] = {{"Ado", "Addr", true}, {"Data", "DataLength", true}, {"Validate", "Timeout"}};
constexpr EniType kInitCmd{kInitCmdChildren, {}, kInitCmdChoices};

constexpr EniChild kInitCmdsChildren[] = {{"InitCmd", kChildren, 0, 0, 0, &kInitCmd}};
constexpr EniType kInitCmds{kInitCmdsChildren};

constexpr EniChild kMasterInfoChildren[] = {
    {"Name", kText, 0, 1}, {"Destination", kMac, 1, 1}, {"Source", kMac, 2, 1}, {"EtherType", kBytes, 3}};
constexpr EniType kMasterInfo{kMasterInfoChildren};

constexpr EniChild kMailboxStatesChildren[] = {{"StartAddr", kUInt32, 0, 1}, {"Count", kUInt16, 1, 1}};
constexpr EniType kMailboxStates{kMailboxStatesChildren};

constexpr EniChild kMasterEoEChildren[] = {
    {"MaxPorts", kInt, 0, 1}, {"MaxFrames", kInt, 1, 1}, {"MaxMACs", kInt, 2, 1}};
constexpr EniType kMasterEoE{kMasterEoEChildren};

constexpr EniChild kMasterChildren[] = {{"Info", kChildren, 0, 1, 1, &kMasterInfo},
                                        {"MailboxStates", kChildren, 1, 0, 1, &kMailboxStates},
                                        {"EoE", kChildren, 2, 0, 1, &kMasterEoE},
                                        {"InitCmds", kChildren, 3, 0, 1, &kInitCmds}};
constexpr EniType kMaster{kMasterChildren};

constexpr EniChild kIdentificationChildren[] = {{"Ado", kHexDec, 0, 1}};
constexpr EniAttribute kIdentificationAttributes[] = {{"Value", kHexDec, true}};
constexpr EniType kIdentification{kIdentificationChildren, kIdentificationAttributes};

constexpr EniChild kSlaveInfoChildren[] = {
    {"Name", kText, 0, 1},          {"PhysAddr", kUInt16, 1},
    {"AutoIncAddr", kUInt16, 2},    {"Identification", kChildren, 3, 0, 1, &kIdentification},
    {"Physics", kPhysics, 4},       {"VendorId", kUInt32, 5, 1},
    {"ProductCode", kUInt32, 6, 1}, {"RevisionNo", kUInt32, 7, 1},
    {"SerialNo", kUInt32, 8, 1},    {"ProductRevision", kText, 9}};
constexpr EniType kSlaveInfo{kSlaveInfoChildren};

constexpr EniChild kRangeChildren[] = {{"BitStart", kUInt32, 0, 1}, {"BitLength", kUInt32, 1, 1}};
constexpr EniAttribute kRangeAttributes[] = {{"Sm0", kBool},  {"Sm1", kBool},  {"Sm2", kBool},  {"Sm3", kBool},
                                             {"Sm4", kBool},  {"Sm5", kBool},  {"Sm6", kBool},  {"Sm7", kBool},
                                             {"Sm8", kBool},  {"Sm9", kBool},  {"Sm10", kBool}, {"Sm11", kBool},
                                             {"Sm12", kBool}, {"Sm13", kBool}, {"Sm14", kBool}, {"Sm15", kBool}};
constexpr EniType kRange{kRangeChildren, kRangeAttributes};

constexpr EniChild kSyncManagerChildren[] = {
    {"Type", kSmType, 0, 1},         {"MinSize", kUInt16, 1},      {"MaxSize", kUInt16, 2}, {"DefaultSize", kUInt16, 3},
    {"StartAddress", kUInt16, 4, 1}, {"ControlByte", kByte, 5, 1}, {"Enable", kBool, 6, 1}, {"Virtual", kBool, 7},
    {"Watchdog", kInt, 8},           {"Pdo", kUInt16, 9, 0, 0}};
constexpr EniType kSyncManager{kSyncManagerChildren};

constexpr EniChild kEntryChildren[] = {{"Index", kHexDec, 0, 1}, {"SubIndex", kHexDec, 1}, {"BitLen", kUInt16, 2, 1},
                                       {"Name", kText, 3, 0, 0}, {"Comment", kText, 4},    {"DataType", kText, 5}};
constexpr EniAttribute kEntryAttributes[] = {{"Fixed", kBool}};
constexpr EniType kEntry{kEntryChildren, kEntryAttributes};

constexpr EniChild kPdoChildren[] = {{"Index", kHexDec, 0, 1},
                                     {"Name", kText, 1, 1, 0},
                                     {"Exclude", kHexDec, 2, 0, 0},
                                     {"Entry", kChildren, 3, 0, 0, &kEntry}};
constexpr EniAttribute kPdoAttributes[] = {{"Fixed", kBool},
                                           {"Mandatory", kBool},
                                           {"Virtual", kBool},
                                           {"Sm", kByte},
                                           {"Su", kByte},
                                           {"PdoOrder", kInt},
                                           {"OSFac", kInt},
                                           {"OSMin", kInt},
                                           {"OSMax", kInt},
                                           {"OSIndexInc", kInt},
                                           {"OverwrittenByModule", kBool}};
constexpr EniType kPdo{kPdoChildren, kPdoAttributes};

constexpr EniChild kProcessDataChildren[] = {
    {"Send", kChildren, 0, 0, 0, &kRange},        {"Recv", kChildren, 1, 0, 0, &kRange},
    {"Sm0", kChildren, 2, 0, 1, &kSyncManager},   {"Sm1", kChildren, 3, 0, 1, &kSyncManager},
    {"Sm2", kChildren, 4, 0, 1, &kSyncManager},   {"Sm3", kChildren, 5, 0, 1, &kSyncManager},
    {"Sm4", kChildren, 6, 0, 1, &kSyncManager},   {"Sm5", kChildren, 7, 0, 1, &kSyncManager},
    {"Sm6", kChildren, 8, 0, 1, &kSyncManager},   {"Sm7", kChildren, 9, 0, 1, &kSyncManager},
    {"Sm8", kChildren, 10, 0, 1, &kSyncManager},  {"Sm9", kChildren, 11, 0, 1, &kSyncManager},
    {"Sm10", kChildren, 12, 0, 1, &kSyncManager}, {"Sm11", kChildren, 13, 0, 1, &kSyncManager},
    {"Sm12", kChildren, 14, 0, 1, &kSyncManager}, {"Sm13", kChildren, 15, 0, 1, &kSyncManager},
    {"Sm14", kChildren, 16, 0, 1, &kSyncManager}, {"Sm15", kChildren, 17, 0, 1, &kSyncManager},
    {"RxPdo", kChildren, 18, 0, 0, &kPdo},        {"TxPdo", kChildren, 18, 0, 0, &kPdo}};
constexpr EniType kProcessData{kProcessDataChildren};

constexpr EniChild kMailboxSendChildren[] = {
    {"Start", kUInt16, 0, 1}, {"Length", kUInt16, 1, 1}, {"ShortSend", kBool, 2}};
constexpr EniType kMailboxSend{kMailboxSendChildren};

constexpr EniChild kMailboxRecvChildren[] = {
    {"Start", kUInt16, 0, 1}, {"Length", kUInt16, 1, 1}, {"PollTime", kInt, 2}, {"StatusBitAddr", kUInt32, 3}};
constexpr EniType kMailboxRecv{kMailboxRecvChildren};

constexpr EniChild kBootStrapChildren[] = {{"Send", kChildren, 0, 1, 1, &kMailboxSend},
                                           {"Recv", kChildren, 1, 1, 1, &kMailboxRecv}};
constexpr EniType kBootStrap{kBootStrapChildren};

constexpr EniChild kCoeInitCmdChildren[] = {{"Transition", kTransition, 0, 1, 0},
                                            {"Comment", kText, 1},
                                            {"Timeout", kInt, 2, 1},
                                            {"Ccs", kByte, 3, 1},
                                            {"Index", kUInt16, 4, 1},
                                            {"SubIndex", kByte, 5, 1},
                                            {"Data", kBytes, 6},
                                            {"Disabled", kBool, 7}};
constexpr EniAttribute kCoeInitCmdAttributes[] = {{"Fixed", kBool}, {"CompleteAccess", kBool}};
constexpr EniType kCoeInitCmd{kCoeInitCmdChildren, kCoeInitCmdAttributes};

constexpr EniChild kCoeInitCmdsChildren[] = {{"InitCmd", kChildren, 0, 0, 0, &kCoeInitCmd}};
constexpr EniType kCoeInitCmds{kCoeInitCmdsChildren};

constexpr EniChild kCoEChildren[] = {{"InitCmds", kChildren, 0, 0, 1, &kCoeInitCmds}, {"Profile", kAnything, 1}};
constexpr EniType kCoE{kCoEChildren};

constexpr EniChild kSoeInitCmdChildren[] = {{"Transition", kSoeTransition, 0, 1, 0},
                                            {"Comment", kText, 1},
                                            {"Timeout", kInt, 2, 1},
                                            {"OpCode", kByte, 3, 1},
                                            {"DriveNo", kByte, 4, 1},
                                            {"IDN", kUInt16, 5, 1},
                                            {"Elements", kByte, 6, 1},
                                            {"Attribute", kByte, 7, 1},
                                            {"Data", kBytes, 8},
                                            {"Disabled", kBool, 9}};
constexpr EniAttribute kSoeInitCmdAttributes[] = {{"Fixed", kBool}};
constexpr EniType kSoeInitCmd{kSoeInitCmdChildren, kSoeInitCmdAttributes};

constexpr EniChild kSoeInitCmdsChildren[] = {{"InitCmd", kChildren, 0, 0, 0, &kSoeInitCmd}};
constexpr EniType kSoeInitCmds{kSoeInitCmdsChildren};

constexpr EniChild kSoEChildren[] = {{"InitCmds", kChildren, 0, 0, 1, &kSoeInitCmds}};
constexpr EniType kSoE{kSoEChildren};

constexpr EniChild kMailboxInitCmdChildren[] = {{"Transition", kTransition, 0, 1, 0},
                                                {"Comment", kText, 1},
                                                {"Timeout", kInt, 2, 1},
                                                {"Data", kBytes, 3, 1},
                                                {"Disabled", kBool, 4}};
constexpr EniAttribute kMailboxInitCmdAttributes[] = {{"Fixed", kBool}};
constexpr EniType kMailboxInitCmd{kMailboxInitCmdChildren, kMailboxInitCmdAttributes};

constexpr EniChild kMailboxInitCmdsChildren[] = {{"InitCmd", kChildren, 0, 0, 0, &kMailboxInitCmd}};
constexpr EniType kMailboxInitCmds{kMailboxInitCmdsChildren};

constexpr EniChild kAoEChildren[] = {{"InitCmds", kChildren, 0, 0, 1, &kMailboxInitCmds}, {"NetId", kText, 1}};
constexpr EniType kAoE{kAoEChildren};

constexpr EniChild kEoEChildren[] = {{"InitCmds", kChildren, 0, 0, 1, &kMailboxInitCmds}};
constexpr EniAttribute kEoEAttributes[] = {{"Disabled", kBool}};
constexpr EniType kEoE{kEoEChildren, kEoEAttributes};

constexpr EniChild kOtherProtocolChildren[] = {{"InitCmds", kChildren, 0, 0, 1, &kMailboxInitCmds}};
constexpr EniType kOtherProtocol{kOtherProtocolChildren};

constexpr EniChild kMailboxChildren[] = {{"Send", kChildren, 0, 1, 1, &kMailboxSend},
                                         {"Recv", kChildren, 1, 1, 1, &kMailboxRecv},
                                         {"BootStrap", kChildren, 2, 0, 1, &kBootStrap},
                                         {"Protocol", kProtocol, 3, 0, 0},
                                         {"CoE", kChildren, 4, 0, 1, &kCoE},
                                         {"SoE", kChildren, 5, 0, 1, &kSoE},
                                         {"AoE", kChildren, 6, 0, 1, &kAoE},
                                         {"EoE", kChildren, 7, 0, 1, &kEoE},
                                         {"FoE", kChildren, 8, 0, 1, &kOtherProtocol},
                                         {"VoE", kChildren, 9, 0, 1, &kOtherProtocol}};
constexpr EniAttribute kMailboxAttributes[] = {{"DataLinkLayer", kBool}};
constexpr EniType kMailbox{kMailboxChildren, kMailboxAttributes};

constexpr EniChild kPreviousPortChildren[] = {{"DeviceId", kInt, 0}, {"Port", kPort, 1, 1}, {"PhysAddr", kUInt16, 2}};
constexpr EniAttribute kPreviousPortAttributes[] = {{"Selected", kBool}};
constexpr EniType kPreviousPort{kPreviousPortChildren, kPreviousPortAttributes};

constexpr EniChild kHotConnectChildren[] = {
    {"GroupName", kText, 0}, {"GroupMemberCnt", kUInt16, 1, 1}, {"IdentifyCmd", kChildren, 2, 1, 0, &kInitCmd}};
constexpr EniType kHotConnect{kHotConnectChildren};

constexpr EniChild kDcChildren[] = {{"PotentialReferenceClock", kBool, 0},
                                    {"ReferenceClock", kBool, 1},
                                    {"CycleTime0", kInt, 2},
                                    {"CycleTime1", kInt, 3},
                                    {"ShiftTime", kInt, 4}};
constexpr EniType kDc{kDcChildren};

constexpr EniChild kSlaveChildren[] = {{"Info", kChildren, 0, 1, 1, &kSlaveInfo},
                                       {"ProcessData", kChildren, 1, 0, 1, &kProcessData},
                                       {"Mailbox", kChildren, 2, 0, 1, &kMailbox},
                                       {"InitCmds", kChildren, 3, 0, 1, &kInitCmds},
                                       {"PreviousPort", kChildren, 4, 0, 0, &kPreviousPort},
                                       {"HotConnect", kChildren, 5, 0, 1, &kHotConnect},
                                       {"DC", kChildren, 6, 0, 1, &kDc}};
constexpr EniType kSlave{kSlaveChildren};

constexpr EniChild kCopyInfoChildren[] = {
    {"SrcBitOffs", kHexDec, 0, 1}, {"DstBitOffs", kHexDec, 1, 1}, {"BitSize", kHexDec, 2, 1}};
constexpr EniType kCopyInfo{kCopyInfoChildren};

constexpr EniChild kCopyInfosChildren[] = {{"CopyInfo", kChildren, 0, 0, 0, &kCopyInfo}};
constexpr EniType kCopyInfos{kCopyInfosChildren};

constexpr EniChild kCyclicCmdChildren[] = {
    {"State", kState, 0, 1, 4},   {"Comment", kText, 1},         {"Cmd", kByte, 2, 1},
    {"Adp", kUInt16, 3},          {"Ado", kUInt16, 3},           {"Addr", kUInt32, 3},
    {"Data", kBytes, 4},          {"DataLength", kUInt16, 4},    {"Cnt", kUInt16, 5},
    {"InputOffs", kUInt32, 6, 1}, {"OutputOffs", kUInt32, 7, 1}, {"CopyInfos", kChildren, 8, 0, 1, &kCopyInfos}};
constexpr EniChoice kCyclicCmdChoices[] = {{"Ado", "Addr", true}, {"Data", "DataLength", true}};
constexpr EniType kCyclicCmd{kCyclicCmdChildren, {}, kCyclicCmdChoices};

constexpr EniChild kFrameChildren[] = {{"Comment", kText, 0}, {"Cmd", kChildren, 1, 1, 0, &kCyclicCmd}};
constexpr EniType kFrame{kFrameChildren};

constexpr EniChild kCyclicChildren[] = {{"Comment", kText, 0},
                                        {"CycleTime", kInt, 1},
                                        {"Priority", kInt, 2},
                                        {"TaskId", kText, 3},
                                        {"Frame", kChildren, 4, 1, 0, &kFrame}};
constexpr EniType kCyclic{kCyclicChildren};

constexpr EniChild kVariableChildren[] = {{"Name", kText, 0, 1},
                                          {"Comment", kText, 1},
                                          {"DataType", kText, 2},
                                          {"BitSize", kUInt32, 3, 1},
                                          {"BitOffs", kUInt32, 4, 1}};
constexpr EniType kVariable{kVariableChildren};

constexpr EniChild kImageChildren[] = {{"ByteSize", kUInt32, 0, 1}, {"Variable", kChildren, 1, 0, 0, &kVariable}};
constexpr EniType kImage{kImageChildren};

constexpr EniChild kProcessImageChildren[] = {{"Inputs", kChildren, 0, 0, 1, &kImage},
                                              {"Outputs", kChildren, 1, 0, 1, &kImage}};
constexpr EniType kProcessImage{kProcessImageChildren};

constexpr EniChild kConfigChildren[] = {{"Master", kChildren, 0, 1, 1, &kMaster},
                                        {"Slave", kChildren, 1, 0, 0, &kSlave},
                                        {"Cyclic", kChildren, 2, 0, 0, &kCyclic},
                                        {"ProcessImage", kChildren, 3, 0, 1, &kProcessImage}};
constexpr EniType kConfig{kConfigChildren};

constexpr EniChild kRootChildren[] = {{"Manufacturer", kAnything, 0}, {"Config", kChildren, 1, 1, 1, &kConfig}};
constexpr EniAttribute kRootAttributes[] = {{"Version", kText}, {"EncryptionVersion", kText}};
constexpr EniType kRoot{kRootChildren, kRootAttributes};

}  // namespace

const EniChild* EniType::child(std::string_view name) const {
  const auto found = std::ranges::find_if(children, [&](const EniChild& c) { return name == c.name; });
  return found == children.end() ? nullptr : &*found;
}

const EniAttribute* EniType::attribute(std::string_view name) const {
  const auto found = std::ranges::find_if(attributes, [&](const EniAttribute& a) { return name == a.name; });
  return found == attributes.end() ? nullptr : &*found;
}

const EniType& eni_schema() { return kRoot; }

}  // namespace syncline::eni
