// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// What is tolerated in ESI files, and what happens to the index of them; see reason_words.h.
namespace syncline::words {

inline constexpr std::string_view kEsiReasons[] = {
    "\"{text}\" is read as {value}",
    "\"{text}\" has an odd number of digits; a zero is put in front",
    "hexadecimal numbers of this file begin with 0x instead of #x",
    "the text is not UTF-8, though it should be; read as {encoding}",
    "it names the encoding {name}, but its letters come in pairs as those of GB 2312; read as {encoding}",
    "it names the encoding {name}, but its letters stand alone as Western ones do; read as {encoding}",
    "the byte 0x{byte} is no letter of the encoding {name}; read as a control character",
    "Transition is missing; taken for PS",
    "Name is missing; taken from Desc",
    "MaxInstances is missing; taken for 1",
    "BitLen is missing; {bits} bits by the data type {type}",
    "the use \"{use}\" is not known; the FMMU counts as free",
    "the use \"{use}\" is not known; taken from the control byte 0x{control}",
    "the PDO 0x{index} excludes itself; that is left out",
    "the rule \"{rule}\" for {attribute} is not known",
    "{attribute} \"{text}\" is no number of 32 bits and is left out",
    "the picture is no hexadecimal data and is left out",
    "the dictionary has too many entries; the rest is left out",
    "the data type is left out: {error}",
    "the object is left out: {error}",
    "the module is left out: {error}",
    "the dictionary is left out: {error}",
    "the file is left out: {error}",
    "Device is left out: {error}",
    "Device {device} is left out: {error}",
    "\"{name}\" is another file, which is not read here",
    "the dictionary \"{name}\" is in another file, which is not read here",
    "\"{name}\" is no dictionary file: its root is <{root}>, not <EtherCATDict>",
    "no file describes the module 0x{module} of the slot \"{slot}\"",
    "the device catalogue is made again: {reason}",
    "it was damaged: {words}",
    "it is of version {version}, this program uses version {own}",
    "the ESI files are read anew each time: {error}",
};

}  // namespace syncline::words
