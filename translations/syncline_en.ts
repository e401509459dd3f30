<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>CutShortDialog</name>
        <message numerus="yes">
            <source>%n more write(s) follow.</source>
            <translation>
                <numerusform>%n more write follows.</numerusform>
                <numerusform>%n more writes follow.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>DeviceEditor</name>
        <message numerus="yes">
            <source>%n slave(s), cycle %1</source>
            <translation>
                <numerusform>%n slave, cycle %1</numerusform>
                <numerusform>%n slaves, cycle %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Events</name>
        <message numerus="yes">
            <source>Process data watchdog expired (%n time(s))</source>
            <translation>
                <numerusform>Process data watchdog expired (%n time)</numerusform>
                <numerusform>Process data watchdog expired (%n times)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>PDI watchdog expired (%n time(s)): the firmware is silent</source>
            <translation>
                <numerusform>PDI watchdog expired (%n time): the firmware is silent</numerusform>
                <numerusform>PDI watchdog expired (%n times): the firmware is silent</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Distributed clocks initialised: %n slave(s), reference clock at position %1</source>
            <translation>
                <numerusform>Distributed clocks initialised: %n slave, reference clock at position %1</numerusform>
                <numerusform>Distributed clocks initialised: %n slaves, reference clock at position %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) lost</source>
            <translation>
                <numerusform>%n frame lost</numerusform>
                <numerusform>%n frames lost</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n event(s) were lost: the queue was full</source>
            <translation>
                <numerusform>%n event was lost: the queue was full</numerusform>
                <numerusform>%n events were lost: the queue was full</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) back late, up to %1 after the deadline (%2 of them told as lost before)</source>
            <translation>
                <numerusform>%n frame back late, up to %1 after the deadline (%2 of them told as lost before)</numerusform>
                <numerusform>%n frames back late, up to %1 after the deadline (%2 of them told as lost before)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) back late, up to %1 after the deadline</source>
            <translation>
                <numerusform>%n frame back late, up to %1 after the deadline</numerusform>
                <numerusform>%n frames back late, up to %1 after the deadline</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) left out, the host sent nothing for up to %1</source>
            <translation>
                <numerusform>%n cycle left out, the host sent nothing for up to %1</numerusform>
                <numerusform>%n cycles left out, the host sent nothing for up to %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Slaves out of sync, deviation %1; %n slave(s) over the limit</source>
            <translation>
                <numerusform>Slaves out of sync, deviation %1; %n slave over the limit</numerusform>
                <numerusform>Slaves out of sync, deviation %1; %n slaves over the limit</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>StatusPanel</name>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n slave</numerusform>
                <numerusform>%n slaves</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Units</name>
        <message numerus="yes">
            <source>%n Byte(s)</source>
            <translation>
                <numerusform>%n byte</numerusform>
                <numerusform>%n bytes</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n Bit(s)</source>
            <translation>
                <numerusform>%n bit</numerusform>
                <numerusform>%n bits</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Workspace</name>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>%n slave found on %1</numerusform>
                <numerusform>%n slaves found on %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>SyncSettingsEditor</name>
        <message numerus="yes">
            <source>%1 (%n miss(es) in a row)</source>
            <translation>
                <numerusform>%1 (%n miss in a row)</numerusform>
                <numerusform>%1 (%n misses in a row)</numerusform>
            </translation>
        </message>
    </context>
</TS>
