<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
    <name>AboutDialog</name>
        <message>
            <source>About Syncline</source>
            <translation>Über Syncline</translation>
        </message>
        <message>
            <source>&lt;h3&gt;Syncline %1&lt;/h3&gt;&lt;p&gt;EtherCAT configurator and live synchronisation monitor.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Built with Qt %2 (LGPL) and Qwt %3 (Qwt License).&lt;/p&gt;</source>
            <translation>&lt;h3&gt;Syncline %1&lt;/h3&gt;&lt;p&gt;EtherCAT-Konfigurator und Live-Monitor der Synchronisation.&lt;/p&gt;&lt;p&gt;Apache-Lizenz 2.0. Gebaut mit Qt %2 (LGPL) und Qwt %3 (Qwt-Lizenz).&lt;/p&gt;</translation>
        </message>
        <message>
            <source>EtherCAT is a registered trademark and patented technology, licensed by Beckhoff Automation GmbH, Germany.</source>
            <translation>EtherCAT ist eine eingetragene Marke und patentierte Technologie, lizenziert durch die Beckhoff Automation GmbH, Deutschland.</translation>
        </message>
</context>
<context>
    <name>Actions</name>
        <message>
            <source>High &amp;Contrast</source>
            <translation>Hoher &amp;Kontrast</translation>
        </message>
        <message>
            <source>Make a recording of a capture of frames (pcap, pcapng) of any master, and show it</source>
            <translation>Aus einem Mitschnitt von Frames (pcap, pcapng) eines beliebigen Masters eine Aufzeichnung machen und zeigen</translation>
        </message>
        <message>
            <source>Import Capture as Recordin&amp;g…</source>
            <translation>Mitschnitt als Aufzeichnung im&amp;portieren…</translation>
        </message>
        <message>
            <source>Choose the B&amp;us…</source>
            <translation>Bus wähle&amp;n …</translation>
        </message>
        <message>
            <source>On which bus the machine runs: a network card, a scenario, or itself, simulated</source>
            <translation>An welchem Bus die Maschine läuft: Netzwerkkarte, Szenario, oder sie selbst, simuliert</translation>
        </message>
        <message>
            <source>Memor&amp;y for the Last…</source>
            <translation>Speiche&amp;r für die letzten …</translation>
        </message>
        <message>
            <source>How many of the latest cycles stay in memory, to be saved afterwards</source>
            <translation>Wie viele der letzten Zyklen im Speicher bleiben, um nachträglich gesichert zu werden</translation>
        </message>
    <message>
        <source>Comm&amp;issioning Report…</source>
        <translation>&amp;Inbetriebnahmebericht …</translation>
    </message>
    <message>
        <source>Judge the run that is shown by criteria, and write the page to hand over</source>
        <translation>Den gezeigten Lauf nach Kriterien beurteilen und die Seite zur Übergabe schreiben</translation>
    </message>
        <message>
            <source>Ne&amp;w Machine…</source>
            <translation>Neue &amp;Maschine …</translation>
        </message>
        <message>
            <source>Make a machine step by step: slaves, cycle, clocks, operation modes</source>
            <translation>Eine Maschine Schritt für Schritt anlegen: Slaves, Zyklus, Uhren, Betriebsarten</translation>
        </message>
        <message>
            <source>Take the last edit back</source>
            <translation>Die letzte Änderung zurücknehmen</translation>
        </message>
        <message>
            <source>Do again what was taken back</source>
            <translation>Das Zurückgenommene noch einmal tun</translation>
        </message>
        <message>
            <source>&amp;New</source>
            <translation>&amp;Neu</translation>
        </message>
        <message>
            <source>New project</source>
            <translation>Neues Projekt</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Öffnen …</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>&amp;Speichern</translation>
        </message>
        <message>
            <source>Save the project</source>
            <translation>Projekt speichern</translation>
        </message>
        <message>
            <source>Save &amp;As…</source>
            <translation>Speichern &amp;unter …</translation>
        </message>
        <message>
            <source>Save the project under another name</source>
            <translation>Projekt unter anderem Namen speichern</translation>
        </message>
        <message>
            <source>&amp;Export ENI…</source>
            <translation>&amp;ENI exportieren …</translation>
        </message>
        <message>
            <source>Write the network information file (ETG.2100)</source>
            <translation>Netzwerkbeschreibung schreiben (ETG.2100)</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>&amp;Beenden</translation>
        </message>
        <message>
            <source>Quit</source>
            <translation>Beenden</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Rückgängig</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Wiederholen</translation>
        </message>
        <message>
            <source>&amp;Demonstration Machine</source>
            <translation>&amp;Vorführmaschine</translation>
        </message>
        <message>
            <source>Scan the simulated demonstration machine and go online</source>
            <translation>Simulierte Vorführmaschine scannen und online gehen</translation>
        </message>
        <message>
            <source>&amp;Scan…</source>
            <translation>&amp;Scannen …</translation>
        </message>
        <message>
            <source>Scan a bus and make a project of it</source>
            <translation>Bus scannen und ein Projekt daraus machen</translation>
        </message>
        <message>
            <source>Go &amp;Online</source>
            <translation>&amp;Online gehen</translation>
        </message>
        <message>
            <source>Run the configuration on the bus</source>
            <translation>Konfiguration auf dem Bus ausführen</translation>
        </message>
        <message>
            <source>Go O&amp;ffline</source>
            <translation>O&amp;ffline gehen</translation>
        </message>
        <message>
            <source>Bring the bus to INIT and stop</source>
            <translation>Bus nach INIT bringen und anhalten</translation>
        </message>
        <message>
            <source>&amp;Clear Statistics</source>
            <translation>S&amp;tatistik zurücksetzen</translation>
        </message>
        <message>
            <source>Start counting anew</source>
            <translation>Neu zu zählen beginnen</translation>
        </message>
        <message>
            <source>Request %1 for all slaves (register 0x0120)</source>
            <translation>%1 für alle Slaves anfordern (Register 0x0120)</translation>
        </message>
        <message>
            <source>&amp;System Colours</source>
            <translation>&amp;Systemfarben</translation>
        </message>
        <message>
            <source>&amp;Light</source>
            <translation>&amp;Hell</translation>
        </message>
        <message>
            <source>&amp;Dark</source>
            <translation>&amp;Dunkel</translation>
        </message>
        <message>
            <source>Light/Dark</source>
            <translation>Hell/Dunkel</translation>
        </message>
        <message>
            <source>Switch between light and dark</source>
            <translation>Zwischen hell und dunkel wechseln</translation>
        </message>
        <message>
            <source>&amp;Reset Layout</source>
            <translation>&amp;Anordnung zurücksetzen</translation>
        </message>
        <message>
            <source>Put all panels back in their places</source>
            <translation>Alle Bereiche an ihren Platz zurücksetzen</translation>
        </message>
        <message>
            <source>&amp;About Syncline</source>
            <translation>&amp;Über Syncline</translation>
        </message>
        <message>
            <source>Version, licence and trademarks</source>
            <translation>Version, Lizenz und Marken</translation>
        </message>
        <message>
            <source>&amp;Expert Settings</source>
            <translation>&amp;Experteneinstellungen</translation>
        </message>
        <message>
            <source>Show the settings that few machines need</source>
            <translation>Die Einstellungen zeigen, die wenige Maschinen brauchen</translation>
        </message>
        <message>
            <source>Open a project, an ENI, an ESI file, a recording, a capture or a scenario</source>
            <translation>Ein Projekt, eine ENI, eine ESI-Datei, eine Aufzeichnung, einen Mitschnitt oder ein Szenario öffnen</translation>
        </message>
        <message>
            <source>&amp;Close Recording</source>
            <translation>Aufzeichnung s&amp;chließen</translation>
        </message>
        <message>
            <source>Show the project and its machine again in place of the recording</source>
            <translation>Wieder das Projekt und seine Maschine statt der Aufzeichnung zeigen</translation>
        </message>
        <message>
            <source>&amp;Record…</source>
            <translation>A&amp;ufzeichnen …</translation>
        </message>
        <message>
            <source>Record the running machine to a file, from now on</source>
            <translation>Die laufende Maschine von jetzt an in eine Datei aufzeichnen</translation>
        </message>
        <message>
            <source>Save the &amp;Last…</source>
            <translation>Das &amp;Letzte sichern …</translation>
        </message>
        <message>
            <source>Save the last stretch, which is still in memory, as a recording</source>
            <translation>Den letzten Abschnitt, der noch im Speicher ist, als Aufzeichnung sichern</translation>
        </message>
        <message>
            <source>&amp;Overview</source>
            <translation>Ü&amp;bersicht</translation>
        </message>
        <message>
            <source>Whether the machine is in sync, since when, and what happened first</source>
            <translation>Ob die Maschine synchron ist, seit wann, und was zuerst geschah</translation>
        </message>
        <message>
            <source>&amp;Go To…</source>
            <translation>Ge&amp;he zu …</translation>
        </message>
        <message>
            <source>Find a slave, a setting or a command</source>
            <translation>Einen Slave, eine Einstellung oder einen Befehl finden</translation>
        </message>
        <message>
            <source>Co&amp;mpare…</source>
            <translation>&amp;Vergleichen …</translation>
        </message>
        <message>
            <source>Compare the project with a file, the running machine or a bus, or two files</source>
            <translation>Das Projekt mit einer Datei, der laufenden Maschine oder einem Bus vergleichen, oder zwei Dateien</translation>
        </message>
        <message>
            <source>Save as &amp;Template…</source>
            <translation>Als Vor&amp;lage sichern …</translation>
        </message>
        <message>
            <source>Keep the project as what others can begin with</source>
            <translation>Das Projekt aufheben, damit andere damit beginnen können</translation>
        </message>
        <message>
            <source>Export with Re&amp;port</source>
            <translation>Mit Be&amp;richt exportieren</translation>
        </message>
        <message>
            <source>Write an HTML report of the machine beside each ENI that is exported</source>
            <translation>Neben jede ENI, die exportiert wird, einen HTML-Bericht der Maschine schreiben</translation>
        </message>
        <message>
            <source>&amp;Black Box of Frames…</source>
            <translation>&amp;Blackbox der Frames …</translation>
        </message>
        <message>
            <source>Keep the last frames of every run on disk, whole also after a crash</source>
            <translation>Die letzten Frames jedes Laufs auf dem Datenträger halten, ganz auch nach einem Absturz</translation>
        </message>
        <message>
            <source>O&amp;verlay Another Recording…</source>
            <translation>Andere Aufzeichnung dar&amp;überlegen …</translation>
        </message>
        <message>
            <source>Lay the curves of another recording over those of the one that is shown</source>
            <translation>Die Kurven einer anderen Aufzeichnung über die der gezeigten legen</translation>
        </message>
</context>
<context>
    <name>BusCommands</name>
        <message>
            <source>Choose Another &amp;Bus…</source>
            <translation>Anderen &amp;Bus wählen…</translation>
        </message>
        <message>
            <source>Choose</source>
            <translation>Wählen</translation>
        </message>
        <message>
            <source>EEPROM</source>
            <translation>EEPROM</translation>
        </message>
        <message>
            <source>The bus could not be scanned.</source>
            <translation>Der Bus konnte nicht gescannt werden.</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Scannen</translation>
        </message>
        <message>
            <source>Go Online</source>
            <translation>Online gehen</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>Master</translation>
        </message>
        <message>
            <source>The master could not go online.</source>
            <translation>Der Master konnte nicht online gehen.</translation>
        </message>
        <message>
            <source>Monitor the sync window</source>
            <translation>Sync-Fenster überwachen</translation>
        </message>
        <message>
            <source>A scan needs the bus for itself.</source>
            <translation>Ein Scan braucht den Bus für sich allein.</translation>
        </message>
        <message>
            <source>Restart the machine with the project as it is now?</source>
            <translation>Die Maschine mit dem Projekt neu starten, wie es jetzt ist?</translation>
        </message>
        <message>
            <source>All slaves go to INIT and come up again.</source>
            <translation>Alle Slaves gehen nach INIT und laufen wieder hoch.</translation>
        </message>
        <message>
            <source>Restart</source>
            <translation>Neu starten</translation>
        </message>
</context>
    <context>
    <name>CsvExport</name>
        <message>
            <source>Writing %1…</source>
            <translation>%1 wird geschrieben …</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
    </context>
<context>
    <name>ExportMenu</name>
        <message>
            <source>&amp;C Header of the Process Image…</source>
            <translation>&amp;C-Header des Prozessabbilds …</translation>
        </message>
        <message>
            <source>&amp;Process Image (CSV)…</source>
            <translation>&amp;Prozessabbild (CSV) …</translation>
        </message>
        <message>
            <source>P&amp;DOs and Their Entries (CSV)…</source>
            <translation>P&amp;DOs und ihre Einträge (CSV) …</translation>
        </message>
        <message>
            <source>&amp;Init Commands (CSV)…</source>
            <translation>&amp;Init-Kommandos (CSV) …</translation>
        </message>
        <message>
            <source>&amp;Slaves (CSV)…</source>
            <translation>&amp;Slaves (CSV) …</translation>
        </message>
        <message>
            <source>&amp;Topology (SVG)…</source>
            <translation>&amp;Topologie (SVG) …</translation>
        </message>
        <message>
            <source>Export Ta&amp;bles and Code</source>
            <translation>&amp;Tabellen und Code exportieren</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>The file could not be written.</source>
            <translation>Die Datei konnte nicht geschrieben werden.</translation>
        </message>
        <message>
            <source>Written to %1</source>
            <translation>Nach %1 geschrieben</translation>
        </message>
</context>
<context>
    <name>CutShortDialog</name>
        <message>
            <source>EEPROM write was cut short</source>
            <translation>Schreiben des EEPROMs wurde unterbrochen</translation>
        </message>
        <message>
            <source>What was cut short</source>
            <translation>Was unterbrochen wurde</translation>
        </message>
        <message>
            <source>Why it could not be ended</source>
            <translation>Warum es nicht beendet werden konnte</translation>
        </message>
        <message>
            <source>Writing the EEPROM</source>
            <translation>Schreiben des EEPROMs</translation>
        </message>
        <message>
            <source>&amp;Finish Writing</source>
            <translation>&amp;Zu Ende schreiben</translation>
        </message>
        <message>
            <source>&amp;Put Back Old Contents</source>
            <translation>Alten Inhalt &amp;wiederherstellen</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>&amp;Später</translation>
        </message>
        <message>
            <source>Finish writing</source>
            <translation>Zu Ende schreiben</translation>
        </message>
        <message>
            <source>Put back old contents</source>
            <translation>Alten Inhalt wiederherstellen</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>Später</translation>
        </message>
        <message>
            <source>Writing the EEPROM of slave %1 on %2 was cut short (begun %3 UTC). What it holds now is half old and half new: the slave may not start after its next power-on. Connect it and end the write.</source>
            <translation>Das Schreiben des EEPROMs von Slave %1 an %2 wurde unterbrochen (begonnen %3 UTC). Es enthält jetzt halb Altes und halb Neues: Nach dem nächsten Einschalten läuft der Slave vielleicht nicht mehr an. Schließen Sie ihn an und beenden Sie das Schreiben.</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>&amp;Abbrechen</translation>
        </message>
        <message>
            <source>The EEPROM of slave %1 on %2 holds its old contents again.</source>
            <translation>Das EEPROM von Slave %1 an %2 enthält wieder seinen alten Inhalt.</translation>
        </message>
        <message>
            <source>The EEPROM of slave %1 on %2 is written and verified.</source>
            <translation>Das EEPROM von Slave %1 an %2 ist geschrieben und geprüft.</translation>
        </message>
        <message>
            <source>The EEPROM of slave %1 on %2 is still half written; the next start offers to end it.</source>
            <translation>Das EEPROM von Slave %1 an %2 ist weiterhin halb geschrieben; der nächste Start bietet an, es zu beenden.</translation>
        </message>
        <message numerus="yes">
            <source>%n more write(s) follow.</source>
            <translation>
                <numerusform>%n weiteres folgt.</numerusform>
                <numerusform>%n weitere folgen.</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>CyclePlot</name>
        <message>
            <source>nominal</source>
            <translation>nominell</translation>
        </message>
        <message>
            <source>From one SYNC0 to the next: when the frame with the slave's outputs had ended there, in system time. Bars are logarithmic counts and fade with the age of their latest arrival; the dotted line is where outputs nominally come by the set value; shaded is what the slave needs for calculating and copying.</source>
            <translation>Von einem SYNC0 zum nächsten: wann der Frame mit den Ausgängen des Slaves dort zu Ende war, in Systemzeit. Die Balken sind logarithmische Anzahlen und verblassen mit dem Alter ihrer jüngsten Ankunft; die gepunktete Linie ist, wo Ausgänge nach dem Sollwert nominell kommen; schattiert ist, was der Slave zum Rechnen und Kopieren braucht.</translation>
        </message>
        <message>
            <source>calculating and copying</source>
            <translation>Rechnen und Kopieren</translation>
        </message>
</context>
<context>
    <name>CycleView</name>
        <message>
            <source>Slave whose SYNC0 period is shown</source>
            <translation>Slave, dessen SYNC0-Periode gezeigt wird</translation>
        </message>
        <message>
            <source>Margins and setpoint slips</source>
            <translation>Reserven und Sollwert-Aussetzer</translation>
        </message>
        <message>
            <source>Arrivals in the SYNC0 period</source>
            <translation>Ankünfte in der SYNC0-Periode</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>No slave with SYNC0 whose outputs can be followed</source>
            <translation>Kein Slave mit SYNC0, dessen Ausgänge verfolgt werden können</translation>
        </message>
        <message>
            <source>margin at least %1</source>
            <translation>Reserve mindestens %1</translation>
        </message>
        <message>
            <source>no arrivals</source>
            <translation>keine Ankünfte</translation>
        </message>
        <message>
            <source>99.9 %: %1</source>
            <translation>99,9 %: %1</translation>
        </message>
        <message>
            <source>calculating and copying %1</source>
            <translation>Rechnen und Kopieren %1</translation>
        </message>
        <message>
            <source>nominally %1</source>
            <translation>nominell %1</translation>
        </message>
        <message>
            <source>calculating and copying not known</source>
            <translation>Rechnen und Kopieren nicht bekannt</translation>
        </message>
        <message>
            <source>setpoint slips: %1</source>
            <translation>Sollwert-Aussetzer: %1</translation>
        </message>
        <message>
            <source>setpoint slips not known</source>
            <translation>Sollwert-Aussetzer nicht bekannt</translation>
        </message>
        <message>
            <source>SYNC0 %1, shift %2</source>
            <translation>SYNC0 %1, Shift %2</translation>
        </message>
</context>
<context>
    <name>DcmPanel</name>
        <message>
            <source>filtered ±%1</source>
            <translation>gefiltert ±%1</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM-Fehler</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>raw</source>
            <translation>roh</translation>
        </message>
        <message>
            <source>filtered</source>
            <translation>gefiltert</translation>
        </message>
        <message>
            <source>Time of the frame at the reference clock minus its wanted time in the cycle.</source>
            <translation>Zeit des Frames an der Referenzuhr minus seine Sollzeit im Zyklus.</translation>
        </message>
        <message>
            <source>drift %1</source>
            <translation>Drift %1</translation>
        </message>
        <message>
            <source>DCM is off</source>
            <translation>DCM ist aus</translation>
        </message>
</context>
<context>
    <name>DeviationPanel</name>
        <message>
            <source>DC deviation</source>
            <translation>DC-Abweichung</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <source>largest</source>
            <translation>größte</translation>
        </message>
        <message>
            <source>Register 0x092C (System Time Difference) of the slaves that follow the reference clock. Largest: the wire-or of all of them read by BRD where nothing else is in it, else the largest of their latest readings. Lines: signed values of single slaves.</source>
            <translation>Register 0x092C (System Time Difference) der Slaves, die der Referenzuhr folgen. Größte: das mit BRD gelesene verdrahtete Oder aller, wo sonst nichts darin ist, sonst der größte ihrer letzten Messwerte. Linien: vorzeichenbehaftete Werte einzelner Slaves.</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>Grenze ±%1</translation>
        </message>
        <message>
            <source>peak %1</source>
            <translation>Spitze %1</translation>
        </message>
</context>
<context>
    <name>DeviceEditor</name>
        <message>
            <source>All</source>
            <translation>Alle</translation>
        </message>
        <message>
            <source>All pages of the selected node</source>
            <translation>Alle Seiten des gewählten Knotens</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>Konfiguration</translation>
        </message>
        <message>
            <source>The pages that say what shall be</source>
            <translation>Die Seiten, die sagen, was sein soll</translation>
        </message>
        <message>
            <source>Diagnosis</source>
            <translation>Diagnose</translation>
        </message>
        <message>
            <source>The pages that show what is</source>
            <translation>Die Seiten, die zeigen, was ist</translation>
        </message>
        <message>
            <source>Which pages are shown</source>
            <translation>Welche Seiten gezeigt werden</translation>
        </message>
        <message>
            <source>Device editor</source>
            <translation>Geräteeditor</translation>
        </message>
        <message>
            <source>State of the selected node</source>
            <translation>Zustand des gewählten Knotens</translation>
        </message>
        <message>
            <source>Pages of the selected node</source>
            <translation>Seiten des gewählten Knotens</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s), cycle %1</source>
            <translation>
                <numerusform>%n Slave, Zyklus %1</numerusform>
                <numerusform>%n Slaves, Zyklus %1</numerusform>
            </translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>position %1, address %2</source>
            <translation>Position %1, Adresse %2</translation>
        </message>
</context>
<context>
    <name>ExplorerPanel</name>
        <message>
            <source>Project explorer</source>
            <translation>Projektbaum</translation>
        </message>
        <message>
            <source>Topology of the network</source>
            <translation>Topologie des Netzwerks</translation>
        </message>
        <message>
            <source>Classic</source>
            <translation>Klassisch</translation>
        </message>
        <message>
            <source>Tree by wiring: terminals below their coupler</source>
            <translation>Baum nach Verdrahtung: Klemmen unter ihrem Koppler</translation>
        </message>
        <message>
            <source>Flat</source>
            <translation>Flach</translation>
        </message>
        <message>
            <source>All slaves in bus order</source>
            <translation>Alle Slaves in der Reihenfolge des Busses</translation>
        </message>
        <message>
            <source>Topology</source>
            <translation>Topologie</translation>
        </message>
        <message>
            <source>Ports and cables; drag a slave to another port to rewire it</source>
            <translation>Ports und Kabel; einen Slave auf einen anderen Port ziehen, um ihn umzustecken</translation>
        </message>
        <message>
            <source>Error Counters at Its Cable (%1)</source>
            <translation>Fehlerzähler an seinem Kabel (%1)</translation>
        </message>
        <message>
            <source>Network of the machine</source>
            <translation>Netzwerk der Maschine</translation>
        </message>
        <message>
            <source>Which network of the machine is in work (Ctrl+F6: the next one)</source>
            <translation>Welches Netzwerk der Maschine bearbeitet wird (Strg+F6: das nächste)</translation>
        </message>
</context>
    <context>
    <name>FaultBanner</name>
        <message>
            <source>First fault</source>
            <translation>Erste Störung</translation>
        </message>
        <message>
            <source>The episode before</source>
            <translation>Die Störung davor</translation>
        </message>
        <message>
            <source>The next episode</source>
            <translation>Die nächste Störung</translation>
        </message>
    </context>
<context>
    <name>FileCommands</name>
        <message>
            <source>A new machine takes the place of the present one.</source>
            <translation>Eine neue Maschine tritt an die Stelle der jetzigen.</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <source>The project could not be opened.</source>
            <translation>Das Projekt konnte nicht geöffnet werden.</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>Projekt</translation>
        </message>
        <message>
            <source>Opened %1</source>
            <translation>%1 geöffnet</translation>
        </message>
        <message>
            <source>Save Project</source>
            <translation>Projekt speichern</translation>
        </message>
        <message>
            <source>Syncline projects (*.syncline)</source>
            <translation>Syncline-Projekte (*.syncline)</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Speichern</translation>
        </message>
        <message>
            <source>The project could not be saved.</source>
            <translation>Das Projekt konnte nicht gespeichert werden.</translation>
        </message>
        <message>
            <source>Saved %1</source>
            <translation>%1 gespeichert</translation>
        </message>
        <message>
            <source>Export ENI</source>
            <translation>ENI exportieren</translation>
        </message>
        <message>
            <source>EtherCAT network information (*.xml)</source>
            <translation>EtherCAT-Netzwerkbeschreibung (*.xml)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Exportieren</translation>
        </message>
        <message>
            <source>The ENI could not be written.</source>
            <translation>Die ENI konnte nicht geschrieben werden.</translation>
        </message>
        <message>
            <source>ENI written to %1</source>
            <translation>ENI nach %1 geschrieben</translation>
        </message>
        <message>
            <source>Syncline</source>
            <translation>Syncline</translation>
        </message>
        <message>
            <source>Save the changes to %1?</source>
            <translation>Änderungen an %1 speichern?</translation>
        </message>
        <message>
            <source>A new project begins without a machine.</source>
            <translation>Ein neues Projekt beginnt ohne Maschine.</translation>
        </message>
        <message>
            <source>%1 cannot be opened here.</source>
            <translation>%1 lässt sich hier nicht öffnen.</translation>
        </message>
        <message>
            <source>Another project is opened.</source>
            <translation>Ein anderes Projekt wird geöffnet.</translation>
        </message>
        <message>
            <source>Another window has %1 open.</source>
            <translation>Ein anderes Fenster hat %1 geöffnet.</translation>
        </message>
        <message>
            <source>It is %1. Here it can be looked at and changed, and be saved under another name. If that window is gone, delete %2.</source>
            <translation>Es ist %1. Hier kann das Projekt angesehen, geändert und unter anderem Namen gesichert werden. Gibt es jenes Fenster nicht mehr, löschen Sie %2.</translation>
        </message>
        <message>
            <source>Open Read-only</source>
            <translation>Nur lesend öffnen</translation>
        </message>
        <message>
            <source>Recover</source>
            <translation>Wiederherstellen</translation>
        </message>
        <message>
            <source>The unsaved work could not be read.</source>
            <translation>Die ungesicherte Arbeit konnte nicht gelesen werden.</translation>
        </message>
        <message>
            <source>Recovered %1; it is not saved yet</source>
            <translation>%1 wiederhergestellt; noch nicht gesichert</translation>
        </message>
        <message>
            <source>All that can be opened (*.syncline *.xml *.esi *.eni *.slrec *.csv *.pcap *.pcapng *.toml);;Syncline projects (*.syncline);;Recordings (*.slrec);;All files (*)</source>
            <translation>Alles, was sich öffnen lässt (*.syncline *.xml *.esi *.eni *.slrec *.csv *.pcap *.pcapng *.toml);;Syncline-Projekte (*.syncline);;Aufzeichnungen (*.slrec);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>a project, an ENI, an ESI, a recording, a capture or a scenario</source>
            <translation>ein Projekt, eine ENI, eine ESI, eine Aufzeichnung, ein Mitschnitt oder ein Szenario</translation>
        </message>
        <message>
            <source>Open %1, or compare the project with it?</source>
            <translation>%1 öffnen oder das Projekt damit vergleichen?</translation>
        </message>
        <message>
            <source>&amp;Compare</source>
            <translation>&amp;Vergleichen</translation>
        </message>
        <message>
            <source>&amp;Open</source>
            <translation>Ö&amp;ffnen</translation>
        </message>
        <message>
            <source>ENI written to %1, report to %2</source>
            <translation>ENI nach %1 geschrieben, Bericht nach %2</translation>
        </message>
        <message>
            <source>There is a report %1 already.</source>
            <translation>Es gibt schon einen Bericht %1.</translation>
        </message>
        <message>
            <source>It is replaced by the one of this export.</source>
            <translation>Er wird durch den dieses Exports ersetzt.</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>Ersetzen</translation>
        </message>
        <message>
            <source>Open %1 now?</source>
            <translation>%1 jetzt öffnen?</translation>
        </message>
        <message>
            <source>Syncline was started with it. The recovered work is not saved yet; what would take its place asks first.</source>
            <translation>Syncline wurde damit gestartet. Die wiederhergestellte Arbeit ist noch nicht gespeichert; was an ihre Stelle käme, fragt vorher.</translation>
        </message>
        <message>
            <source>%1 was not opened: the recovered work is shown</source>
            <translation>%1 wurde nicht geöffnet: gezeigt wird die wiederhergestellte Arbeit</translation>
        </message>
</context>
<context>
    <name>Glossary</name>
        <message>
            <source>Master</source>
            <translation>Master</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Slaves missing</source>
            <translation>Slaves fehlen</translation>
        </message>
        <message>
            <source>No response</source>
            <translation>Keine Antwort</translation>
        </message>
        <message>
            <source>Not monitored</source>
            <translation>Nicht überwacht</translation>
        </message>
        <message>
            <source>Not ready</source>
            <translation>Nicht bereit</translation>
        </message>
        <message>
            <source>Settling</source>
            <translation>Schwingt ein</translation>
        </message>
        <message>
            <source>In sync</source>
            <translation>Synchron</translation>
        </message>
        <message>
            <source>Out of sync</source>
            <translation>Nicht synchron</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Aus</translation>
        </message>
        <message>
            <source>Bus shift</source>
            <translation>Bus Shift</translation>
        </message>
        <message>
            <source>Master shift</source>
            <translation>Master Shift</translation>
        </message>
        <message>
            <source>Master reference clock</source>
            <translation>Master-Referenzuhr</translation>
        </message>
        <message>
            <source>Adapter reference clock</source>
            <translation>Adapter-Referenzuhr</translation>
        </message>
        <message>
            <source>External clock (DCX)</source>
            <translation>Externe Uhr (DCX)</translation>
        </message>
        <message>
            <source>Master shift by application</source>
            <translation>Master Shift durch die Anwendung</translation>
        </message>
        <message>
            <source>Unknown</source>
            <translation>Unbekannt</translation>
        </message>
        <message>
            <source>no reference clock</source>
            <translation>keine Referenzuhr</translation>
        </message>
        <message>
            <source>no reading of the reference clock</source>
            <translation>kein Messwert der Referenzuhr</translation>
        </message>
        <message>
            <source>error of the controller</source>
            <translation>Fehler des Reglers</translation>
        </message>
        <message>
            <source>schedule beyond its limit</source>
            <translation>Zeitplan über seiner Grenze</translation>
        </message>
        <message>
            <source>the reference clock has stepped</source>
            <translation>die Referenzuhr ist gesprungen</translation>
        </message>
        <message>
            <source>cycles left out</source>
            <translation>Zyklen ausgelassen</translation>
        </message>
        <message>
            <source>frames later than the set value allows</source>
            <translation>Frames später, als der Sollwert zulässt</translation>
        </message>
        <message>
            <source>settling</source>
            <translation>schwingt ein</translation>
        </message>
        <message>
            <source>on the way to the external clock</source>
            <translation>auf dem Weg zur externen Uhr</translation>
        </message>
        <message>
            <source>away from the external clock</source>
            <translation>nicht bei der externen Uhr</translation>
        </message>
</context>
<context>
    <name>Link</name>
        <message>
            <source>This machine (simulated)</source>
            <translation>Diese Maschine (simuliert)</translation>
        </message>
        <message>
            <source>Demonstration machine (simulated)</source>
            <translation>Vorführmaschine (simuliert)</translation>
        </message>
        <message>
            <source>Network card %1</source>
            <translation>Netzwerkkarte %1</translation>
        </message>
        <message>
            <source>Simulated: %1</source>
            <translation>Simuliert: %1</translation>
        </message>
</context>
<context>
    <name>LinkChooser</name>
        <message numerus="yes">
            <source>Simulated bus of the %n slave(s) of the project, as they are wired there</source>
            <translation>
                <numerusform>Simulierter Bus aus dem %n Slave des Projekts, so verkabelt wie dort</numerusform>
                <numerusform>Simulierter Bus aus den %n Slaves des Projekts, so verkabelt wie dort</numerusform>
            </translation>
        </message>
        <message>
            <source>Choose the Bus</source>
            <translation>Bus wählen</translation>
        </message>
        <message>
            <source>Where is the bus?</source>
            <translation>Wo ist der Bus?</translation>
        </message>
        <message>
            <source>Links</source>
            <translation>Links</translation>
        </message>
        <message>
            <source>Demonstration machine</source>
            <translation>Vorführmaschine</translation>
        </message>
        <message>
            <source>Simulated bus with a coupler, terminals and drives; no hardware needed</source>
            <translation>Simulierter Bus mit Koppler, Klemmen und Antrieben; ohne Hardware</translation>
        </message>
        <message>
            <source>Simulated bus</source>
            <translation>Simulierter Bus</translation>
        </message>
        <message>
            <source>Scenario File…</source>
            <translation>Szenariodatei …</translation>
        </message>
        <message>
            <source>Simulated bus from a scenario file</source>
            <translation>Simulierter Bus aus einer Szenariodatei</translation>
        </message>
        <message>
            <source>Network card, link up</source>
            <translation>Netzwerkkarte, verbunden</translation>
        </message>
        <message>
            <source>Network card, no link</source>
            <translation>Netzwerkkarte, nicht verbunden</translation>
        </message>
        <message>
            <source>No network card was found that can carry EtherCAT.</source>
            <translation>Es wurde keine Netzwerkkarte gefunden, die EtherCAT übertragen kann.</translation>
        </message>
        <message>
            <source>Open Scenario</source>
            <translation>Szenario öffnen</translation>
        </message>
        <message>
            <source>Scenarios (*.toml)</source>
            <translation>Szenarien (*.toml)</translation>
        </message>
        <message>
            <source>driver %1</source>
            <translation>Treiber %1</translation>
        </message>
</context>
<context>
    <name>LiveStrip</name>
        <message>
            <source>The worst %1</source>
            <translation>Die %1 schlechtesten</translation>
        </message>
        <message>
            <source>The worst one</source>
            <translation>Der schlechteste</translation>
        </message>
        <message>
            <source>Slaves that are drawn</source>
            <translation>Gezeichnete Slaves</translation>
        </message>
        <message>
            <source>Limit in the plots</source>
            <translation>Grenze in den Diagrammen</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Grenze</translation>
        </message>
        <message>
            <source>Limit in the project, such as 127 ns or 4 us. The sync window takes the nearest 2ⁿ − 1 ns.</source>
            <translation>Grenze im Projekt, etwa 127 ns oder 4 us. Das Sync-Fenster nimmt die nächsten 2ⁿ − 1 ns.</translation>
        </message>
        <message>
            <source>That is no limit. A number above zero with ns, us or ms:</source>
            <translation>Das ist keine Grenze. Eine Zahl über null mit ns, us oder ms:</translation>
        </message>
        <message>
            <source>Limit in the project…</source>
            <translation>Grenze im Projekt …</translation>
        </message>
        <message>
            <source>Distance of the Cursors</source>
            <translation>Abstand der Cursor</translation>
        </message>
        <message>
            <source>From A to B, such as 12.5 ms, 250 us, -1 s, or 50 Hz:</source>
            <translation>Von A nach B, etwa 12,5 ms, 250 us, -1 s oder 50 Hz:</translation>
        </message>
        <message>
            <source>That is no time. A number with ns, us, ms, s or Hz:</source>
            <translation>Das ist keine Zeit. Eine Zahl mit ns, us, ms, s oder Hz:</translation>
        </message>
        <message>
            <source>Distance of the cursors…</source>
            <translation>Abstand der Cursor …</translation>
        </message>
        <message>
            <source>Cursors stay on the screen</source>
            <translation>Cursor bleiben auf dem Bildschirm</translation>
        </message>
        <message>
            <source>Time axis</source>
            <translation>Zeitachse</translation>
        </message>
        <message>
            <source>Before now, or since the start</source>
            <translation>Vor jetzt, oder seit dem Start</translation>
        </message>
        <message>
            <source>Since the start</source>
            <translation>Seit dem Start</translation>
        </message>
        <message>
            <source>Time of day (UTC)</source>
            <translation>Uhrzeit (UTC)</translation>
        </message>
        <message>
            <source>Number of the cycle</source>
            <translation>Nummer des Zyklus</translation>
        </message>
        <message>
            <source>System time of the reference clock</source>
            <translation>Systemzeit der Referenzuhr</translation>
        </message>
        <message>
            <source>Value scale of this plot</source>
            <translation>Teilung der Werte dieses Diagramms</translation>
        </message>
        <message>
            <source>Linear</source>
            <translation>Linear</translation>
        </message>
        <message>
            <source>Signed logarithmic</source>
            <translation>Logarithmisch mit Vorzeichen</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>Logarithmisch</translation>
        </message>
        <message>
            <source>Value limits of this plot…</source>
            <translation>Grenzen der Werte dieses Diagramms …</translation>
        </message>
        <message>
            <source>Own time axis of this plot</source>
            <translation>Eigene Zeitachse dieses Diagramms</translation>
        </message>
        <message>
            <source>Copy figures</source>
            <translation>Zahlen kopieren</translation>
        </message>
        <message>
            <source>Note here…</source>
            <translation>Notiz hier …</translation>
        </message>
        <message>
            <source>Export the episode</source>
            <translation>Episode exportieren</translation>
        </message>
        <message>
            <source>Live plots</source>
            <translation>Live-Diagramme</translation>
        </message>
        <message>
            <source>No data: go online</source>
            <translation>Keine Daten: online gehen</translation>
        </message>
        <message>
            <source>Export the range shown</source>
            <translation>Gezeigten Bereich exportieren</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>Kommagetrennte Werte (*.csv)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Exportieren</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Export the plots</source>
            <translation>Diagramme exportieren</translation>
        </message>
        <message>
            <source>Cursor A here</source>
            <translation>Cursor A hierher</translation>
        </message>
        <message>
            <source>Cursor B here</source>
            <translation>Cursor B hierher</translation>
        </message>
        <message>
            <source>Remove cursors</source>
            <translation>Cursor entfernen</translation>
        </message>
        <message>
            <source>Show everything</source>
            <translation>Alles zeigen</translation>
        </message>
        <message>
            <source>Fit values</source>
            <translation>Werte einpassen</translation>
        </message>
        <message>
            <source>Keep the value axes as they are</source>
            <translation>Wertachsen festhalten</translation>
        </message>
        <message>
            <source>Copy picture</source>
            <translation>Bild kopieren</translation>
        </message>
        <message>
            <source>Export range as CSV…</source>
            <translation>Bereich als CSV exportieren …</translation>
        </message>
        <message>
            <source>Export picture…</source>
            <translation>Bild exportieren …</translation>
        </message>
        <message>
            <source>Replay from here</source>
            <translation>Wiedergabe ab hier</translation>
        </message>
        <message>
            <source>Lay this moment of %1 on cursor A</source>
            <translation>Diesen Zeitpunkt von %1 auf Cursor A legen</translation>
        </message>
        <message>
            <source>Show the plots</source>
            <translation>Diagramme zeigen</translation>
        </message>
</context>
<context>
    <name>PictureFile</name>
        <message>
            <source>PNG picture (*.png)</source>
            <translation>PNG-Bild (*.png)</translation>
        </message>
        <message>
            <source>SVG drawing (*.svg)</source>
            <translation>SVG-Zeichnung (*.svg)</translation>
        </message>
        <message>
            <source>PDF document (*.pdf)</source>
            <translation>PDF-Dokument (*.pdf)</translation>
        </message>
</context>
<context>
    <name>LiveStripToolbar</name>
        <message>
            <source>Own Plots</source>
            <translation>Eigene Diagramme</translation>
        </message>
        <message>
            <source>Any signals in as many plots as you like, instead of these; kept with the project</source>
            <translation>Beliebige Signale in beliebig vielen Diagrammen anstelle dieser; mit dem Projekt gespeichert</translation>
        </message>
        <message>
            <source>Trigger</source>
            <translation>Trigger</translation>
        </message>
        <message>
            <source>Stops or moves the plots where a signal or an event does what you wait for</source>
            <translation>Hält die Kurven an oder bewegt sie dorthin, wo ein Signal oder ein Ereignis tut, worauf Sie warten</translation>
        </message>
        <message>
            <source>Distribution</source>
            <translation>Verteilung</translation>
        </message>
        <message>
            <source>How often which value came, instead of the plots over time</source>
            <translation>Wie oft welcher Wert kam, statt der Kurven über der Zeit</translation>
        </message>
        <message>
            <source>Stability</source>
            <translation>Stabilität</translation>
        </message>
        <message>
            <source>How steady signals are over observation times, and their spectrum, instead of the plots</source>
            <translation>Wie stetig Signale über Beobachtungszeiten sind, und ihr Spektrum, statt der Kurven</translation>
        </message>
        <message>
            <source>1 s</source>
            <translation>1 s</translation>
        </message>
        <message>
            <source>10 s</source>
            <translation>10 s</translation>
        </message>
        <message>
            <source>60 s</source>
            <translation>60 s</translation>
        </message>
        <message>
            <source>10 min</source>
            <translation>10 min</translation>
        </message>
        <message>
            <source>Show the last %1</source>
            <translation>Die letzten %1 zeigen</translation>
        </message>
        <message>
            <source>Live</source>
            <translation>Live</translation>
        </message>
        <message>
            <source>Follow the newest sample (End)</source>
            <translation>Dem neuesten Wert folgen (Ende)</translation>
        </message>
        <message>
            <source>Show the end of the run (End)</source>
            <translation>Das Ende des Laufs zeigen (Ende)</translation>
        </message>
        <message>
            <source>The run has ended: its picture stands still</source>
            <translation>Der Lauf ist zu Ende: sein Bild steht</translation>
        </message>
        <message>
            <source>Ended, %1 before the end</source>
            <translation>Beendet, %1 vor dem Ende</translation>
        </message>
        <message>
            <source>Ended</source>
            <translation>Beendet</translation>
        </message>
        <message>
            <source>Freeze</source>
            <translation>Einfrieren</translation>
        </message>
        <message>
            <source>Stop the picture, not the acquisition (Space)</source>
            <translation>Bild anhalten, nicht die Aufnahme (Leertaste)</translation>
        </message>
        <message>
            <source>Cursors</source>
            <translation>Cursor</translation>
        </message>
        <message>
            <source>Two cursors to drag (keys A and B put them at the pointer)</source>
            <translation>Zwei ziehbare Cursor (Tasten A und B setzen sie an den Zeiger)</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>Einpassen</translation>
        </message>
        <message>
            <source>Fit the value axes to what is shown (F)</source>
            <translation>Wertachsen an das Gezeigte anpassen (F)</translation>
        </message>
        <message>
            <source>State of the plots</source>
            <translation>Zustand der Diagramme</translation>
        </message>
        <message>
            <source>Time between the cursors</source>
            <translation>Zeit zwischen den Cursorn</translation>
        </message>
        <message>
            <source>Export, axes and cursors</source>
            <translation>Export, Achsen und Cursor</translation>
        </message>
        <message>
            <source>Menu of the live plots</source>
            <translation>Menü der Live-Diagramme</translation>
        </message>
        <message>
            <source>Frozen, %1 behind</source>
            <translation>Eingefroren, %1 zurück</translation>
        </message>
        <message>
            <source>History, %1 behind</source>
            <translation>Verlauf, %1 zurück</translation>
        </message>
        <message>
            <source>   1/Δt %1 Hz</source>
            <translation>   1/Δt %1 Hz</translation>
        </message>
        <message>
            <source>B−A %1</source>
            <translation>B−A %1</translation>
        </message>
        <message>
            <source>A recording has no newest sample to follow</source>
            <translation>Eine Aufzeichnung hat keinen neuesten Wert, dem zu folgen wäre</translation>
        </message>
        <message>
            <source>A recording stands still</source>
            <translation>Eine Aufzeichnung steht still</translation>
        </message>
        <message>
            <source>Recording</source>
            <translation>Aufzeichnung</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>Where in the SYNC0 period of a slave its outputs come, instead of the plots</source>
            <translation>Wo in der SYNC0-Periode eines Slaves seine Ausgänge ankommen, anstelle der Kurven</translation>
        </message>
        <message>
            <source>The deviations of all slaves as a heat map, and their figures, instead of the plots</source>
            <translation>Die Abweichungen aller Slaves als Heatmap und ihre Kennzahlen, anstelle der Kurven</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Ansicht</translation>
        </message>
        <message>
            <source>What is shown instead of the plots over time</source>
            <translation>Was anstelle der Kurven über der Zeit gezeigt wird</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>Jetzt</translation>
        </message>
        <message>
            <source>Replay</source>
            <translation>Wiedergabe</translation>
        </message>
        <message>
            <source>Follow the moment of the replay (End)</source>
            <translation>Dem Zeitpunkt der Wiedergabe folgen (Ende)</translation>
        </message>
        <message>
            <source>Stop the picture, not the replay (Space)</source>
            <translation>Das Bild anhalten, nicht die Wiedergabe (Leertaste)</translation>
        </message>
        <message>
            <source>Leave only the figures of the plots</source>
            <translation>Nur die Zahlen der Diagramme stehen lassen</translation>
        </message>
</context>
<context>
    <name>MainWindow</name>
        <message>
            <source>The program ends.</source>
            <translation>Das Programm wird beendet.</translation>
        </message>
        <message>
            <source>Trigger</source>
            <translation>Trigger</translation>
        </message>
        <message>
            <source>A recording is shown; it has no pages of slaves</source>
            <translation>Eine Aufzeichnung wird gezeigt; sie hat keine Seiten der Slaves</translation>
        </message>
        <message>
            <source>A field holds what cannot be a value: mend it, or press Esc in it.</source>
            <translation>In einem Feld steht, was kein Wert sein kann: berichtigen oder darin Esc drücken.</translation>
        </message>
        <message>
            <source>Findings</source>
            <translation>Befunde</translation>
        </message>
        <message>
            <source>Findings (%1)</source>
            <translation>Befunde (%1)</translation>
        </message>
        <message>
            <source>Live plots</source>
            <translation>Live-Diagramme</translation>
        </message>
        <message>
            <source>Project Explorer</source>
            <translation>Projektbaum</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Meldungen</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;Datei</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>&amp;Bearbeiten</translation>
        </message>
        <message>
            <source>&amp;Network</source>
            <translation>&amp;Netzwerk</translation>
        </message>
        <message>
            <source>Request S&amp;tate</source>
            <translation>&amp;Zustand anfordern</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>&amp;Ansicht</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>&amp;Hilfe</translation>
        </message>
        <message>
            <source>Main</source>
            <translation>Hauptwerkzeugleiste</translation>
        </message>
        <message>
            <source>Request a state for all slaves</source>
            <translation>Zustand für alle Slaves anfordern</translation>
        </message>
        <message>
            <source>Request State</source>
            <translation>Zustand anfordern</translation>
        </message>
        <message>
            <source>Request a state for all slaves (register 0x0120)</source>
            <translation>Zustand für alle Slaves anfordern (Register 0x0120)</translation>
        </message>
        <message>
            <source>%1[*] – Syncline</source>
            <translation>%1[*] – Syncline</translation>
        </message>
        <message>
            <source>Revert to what runs</source>
            <translation>Zurück zu dem, was läuft</translation>
        </message>
        <message>
            <source>%1[*] (read-only) – Syncline</source>
            <translation>%1[*] (nur lesend) – Syncline</translation>
        </message>
        <message>
            <source>Recording %1 – Syncline</source>
            <translation>Aufzeichnung %1 – Syncline</translation>
        </message>
        <message>
            <source>Stop &amp;Recording</source>
            <translation>A&amp;ufzeichnung beenden</translation>
        </message>
        <message>
            <source>&amp;Record…</source>
            <translation>A&amp;ufzeichnen …</translation>
        </message>
        <message>
            <source>A recording is shown, and nothing runs: close it first (File, Close Recording)</source>
            <translation>Eine Aufzeichnung wird gezeigt, und nichts läuft: Schließen Sie sie zuerst (Datei, Aufzeichnung schließen)</translation>
        </message>
        <message>
            <source>Re&amp;play</source>
            <translation>&amp;Wiedergabe</translation>
        </message>
        <message>
            <source>&amp;Help on the Field</source>
            <translation>&amp;Hilfe zum Feld</translation>
        </message>
        <message>
            <source>Range, default and key of the field that has the focus</source>
            <translation>Bereich, Vorgabe und Schlüssel des Feldes, das den Fokus hat</translation>
        </message>
</context>
<context>
    <name>MasterDcPage</name>
        <message>
            <source>Distributed Clocks</source>
            <translation>Distributed Clocks</translation>
        </message>
        <message>
            <source>Clock Adjustment</source>
            <translation>Uhrenabgleich</translation>
        </message>
        <message>
            <source>Master Synchronisation (DCM)</source>
            <translation>Master-Synchronisation (DCM)</translation>
        </message>
        <message>
            <source>Sync Window Monitoring</source>
            <translation>Überwachung des Sync-Fensters</translation>
        </message>
        <message>
            <source>Slaves, live</source>
            <translation>Slaves, live</translation>
        </message>
        <message>
            <source>Master, live</source>
            <translation>Master, live</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>Referenzuhr</translation>
        </message>
        <message>
            <source>The master's clock leads: the reference clock is steered by a cyclic write to register 0x0910</source>
            <translation>Die Uhr des Masters führt: die Referenzuhr wird durch zyklisches Schreiben von Register 0x0910 gestellt</translation>
        </message>
        <message>
            <source>The reference clock leads: the master moves its send time. No extra cyclic command.</source>
            <translation>Die Referenzuhr führt: der Master verschiebt seinen Sendezeitpunkt. Kein zusätzliches zyklisches Kommando.</translation>
        </message>
        <message>
            <source>Master and slaves run on clocks of their own; the frame drifts through the SYNC grid</source>
            <translation>Master und Slaves laufen mit eigenen Uhren; der Frame wandert durch das SYNC-Raster</translation>
        </message>
        <message>
            <source>As bus shift, without a control loop: the reference clock is written the nominal time, and what a frame is far off it is made good. Needs an accurate cycle.</source>
            <translation>Wie Bus Shift, ohne Regelkreis: Der Referenzuhr wird die Sollzeit geschrieben, und was ein Frame weit davon abweicht, wird ausgeglichen. Braucht einen genauen Zyklus.</translation>
        </message>
        <message>
            <source>As bus shift, with the time that the network adapter puts into each frame while sending it</source>
            <translation>Wie Bus Shift, mit der Zeit, die der Netzwerkadapter beim Senden in jedes Telegramm einträgt</translation>
        </message>
        <message>
            <source>An external clock leads through a bridge device: the reference clock follows it, the master follows the reference clock</source>
            <translation>Eine externe Uhr führt über eine Brücke: Die Referenzuhr folgt ihr, der Master folgt der Referenzuhr</translation>
        </message>
        <message>
            <source>The reference clock leads, and the application moves the send time by the reported adjustment</source>
            <translation>Die Referenzuhr führt, und die Anwendung verschiebt den Sendezeitpunkt um die gemeldete Stellgröße</translation>
        </message>
        <message>
            <source>Set value automatic</source>
            <translation>Sollwert automatisch</translation>
        </message>
        <message>
            <source>Slaves in sync</source>
            <translation>Slaves synchron</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Zustand</translation>
        </message>
        <message>
            <source>Sync window of register 0x092C</source>
            <translation>Sync-Fenster von Register 0x092C</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <source>Register 0x092C: largest latest reading of the slaves that follow the reference clock</source>
            <translation>Register 0x092C: größter letzter Messwert der Slaves, die der Referenzuhr folgen</translation>
        </message>
        <message>
            <source>Settled after</source>
            <translation>Synchron nach</translation>
        </message>
        <message>
            <source>From the first cyclic frame</source>
            <translation>Ab dem ersten zyklischen Frame</translation>
        </message>
        <message>
            <source>The slave that leads on the bus</source>
            <translation>Der Slave, der auf dem Bus führt</translation>
        </message>
        <message>
            <source>Master in sync</source>
            <translation>Master synchron</translation>
        </message>
        <message>
            <source>Error of the controller, frames later than the set value allows, cycles left out: none of them within the settle time</source>
            <translation>Fehler des Reglers, Frames später, als der Sollwert zulässt, ausgelassene Zyklen: nichts davon innerhalb der Einschwingzeit</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>Frame late in the SYNC grid &gt; 0, filtered</source>
            <translation>Frame spät im SYNC-Raster &gt; 0, gefiltert</translation>
        </message>
        <message>
            <source>RMS / max</source>
            <translation>RMS / Max</translation>
        </message>
        <message>
            <source>Since in sync</source>
            <translation>Seit synchron</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>Drift</translation>
        </message>
        <message>
            <source>Reference clock's rate against the host's; the ceiling is about 600 ppm</source>
            <translation>Gang der Referenzuhr gegen den des Rechners; die Grenze liegt bei etwa 600 ppm</translation>
        </message>
        <message>
            <source>In sync after</source>
            <translation>Synchron nach</translation>
        </message>
        <message>
            <source>%1 / %2</source>
            <translation>%1 / %2</translation>
        </message>
        <message>
            <source>%1 (limit %2)</source>
            <translation>%1 (Grenze %2)</translation>
        </message>
        <message>
            <source>at once</source>
            <translation>sofort</translation>
        </message>
        <message>
            <source>in this cycle</source>
            <translation>in diesem Zyklus</translation>
        </message>
        <message>
            <source>Last heard of</source>
            <translation>Zuletzt gehört</translation>
        </message>
        <message>
            <source>How long ago something was last heard of each slave that follows</source>
            <translation>Wie lange es her ist, dass von jedem folgenden Slave zuletzt etwas gehört wurde</translation>
        </message>
        <message>
            <source>Frame, max / allowed</source>
            <translation>Frame, max / zulässig</translation>
        </message>
        <message>
            <source>Error of the schedule and how late frames were sent, together: largest since in sync, and at which a frame meets SYNC0</source>
            <translation>Fehler des Zeitplans und Verspätung beim Senden, zusammen: größter Wert seit synchron, und der, bei dem ein Frame auf SYNC0 trifft</translation>
        </message>
        <message>
            <source>%1 ago</source>
            <translation>vor %1</translation>
        </message>
        <message>
            <source>Two thirds of the cycle, and later on long buses</source>
            <translation>Zwei Drittel des Zyklus, auf langen Bussen später</translation>
        </message>
        <message>
            <source>External clock</source>
            <translation>Externe Uhr</translation>
        </message>
        <message>
            <source>Reference clock ahead of the external one &gt; 0, within half a cycle</source>
            <translation>Referenzuhr der externen voraus &gt; 0, innerhalb eines halben Zyklus</translation>
        </message>
</context>
    <context>
    <name>BathtubPlot</name>
        <message>
            <source>From one SYNC0 to the next: how probable it is that the outputs come later than a moment (the line that falls to the right), and earlier (the one that falls to the left). Dashed is what comes out if the rarest arrivals go on as they begin; shaded is what the slave needs for calculating and copying.</source>
            <translation>Von einem SYNC0 zum nächsten: wie wahrscheinlich es ist, dass die Ausgänge später als ein Zeitpunkt kommen (die Linie, die nach rechts fällt), und früher (die, die nach links fällt). Gestrichelt ist, was herauskommt, wenn die seltensten Ankünfte so weitergehen, wie sie beginnen; schattiert ist, was der Slave zum Rechnen und Kopieren braucht.</translation>
        </message>
    </context>
    <context>
    <name>CycleView</name>
        <message>
            <source>What is shown of the arrivals</source>
            <translation>Was von den Ankünften gezeigt wird</translation>
        </message>
        <message>
            <source>How probable late and early arrivals are</source>
            <translation>Wie wahrscheinlich späte und frühe Ankünfte sind</translation>
        </message>
        <message>
            <source>Arrivals</source>
            <translation>Ankünfte</translation>
        </message>
        <message>
            <source>Bathtub</source>
            <translation>Badewanne</translation>
        </message>
        <message>
            <source>How often outputs came when</source>
            <translation>Wie oft Ausgänge wann kamen</translation>
        </message>
        <message>
            <source>How probable it is that outputs come too late or too early</source>
            <translation>Wie wahrscheinlich es ist, dass Ausgänge zu spät oder zu früh kommen</translation>
        </message>
        <message>
            <source>%1 (extrapolated) in all but %2</source>
            <translation>%1 (extrapoliert) in allen bis auf %2</translation>
        </message>
        <message>
            <source>%1 in all but %2</source>
            <translation>%1 in allen bis auf %2</translation>
        </message>
        <message>
            <source>%1 arrivals: too few for a probability</source>
            <translation>%1 Ankünfte: zu wenige für eine Wahrscheinlichkeit</translation>
        </message>
        <message>
            <source>room before SYNC0: %1</source>
            <translation>Abstand vor SYNC0: %1</translation>
        </message>
        <message>
            <source>behind the one before: %1</source>
            <translation>hinter dem davor: %1</translation>
        </message>
        <message>
            <source>calculating and copying (%1) always has its time, as far as can be told</source>
            <translation>Rechnen und Kopieren (%1) hat immer seine Zeit, soweit sich das sagen lässt</translation>
        </message>
        <message>
            <source>too late for calculating and copying (%1): %2 at most, extrapolated</source>
            <translation>zu spät zum Rechnen und Kopieren (%1): höchstens %2, extrapoliert</translation>
        </message>
        <message>
            <source>too late for calculating and copying (%1): %2 at most</source>
            <translation>zu spät zum Rechnen und Kopieren (%1): höchstens %2</translation>
        </message>
    </context>
    <context>
    <name>JoinedText</name>
        <message>
            <source>%1, %2</source>
            <comment>parts of one sentence</comment>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>%1; %2</source>
            <comment>clauses of one sentence</comment>
            <translation>%1; %2</translation>
        </message>
        <message>
            <source>%1.</source>
            <comment>a sentence and its full stop</comment>
            <translation>%1.</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <comment>one sentence behind the other</comment>
            <translation>%1 %2</translation>
        </message>
    </context>
    <context>
    <name>HeatLegend</name>
        <message>
            <source>The largest magnitude of register 0x092C in each cell. Between two readings the older one holds; a cell is hatched where the slave was not read for longer than a few readings take, or no frame came back.</source>
            <translation>Der größte Betrag von Register 0x092C in jeder Zelle. Zwischen zwei Ablesungen gilt die ältere; schraffiert ist eine Zelle, wo der Slave länger nicht gelesen wurde, als wenige Ablesungen dauern, oder kein Frame zurückkam.</translation>
        </message>
        <message>
            <source>limit %1</source>
            <translation>Grenzwert %1</translation>
        </message>
        <message>
            <source>over</source>
            <translation>darüber</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>keine Ablesung</translation>
        </message>
    </context>
    <context>
    <name>HeatMapPlot</name>
        <message>
            <source>reference clock</source>
            <translation>Referenzuhr</translation>
        </message>
    </context>
    <context>
    <name>MaskChooser</name>
        <message>
            <source>Mask</source>
            <translation>Maske</translation>
        </message>
        <message>
            <source>Own mask</source>
            <translation>Eigene Maske</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Grenze</translation>
        </message>
        <message>
            <source>1/25 of the cycle</source>
            <translation>1/25 des Zyklus</translation>
        </message>
        <message>
            <source>The most that the figure can be while every value is within the limit of the signal: the sync window, or that of the DCM error</source>
            <translation>Das Höchste, was der Kennwert erreichen kann, solange jeder Wert in der Grenze des Signals liegt: dem Sync-Fenster oder der des DCM-Fehlers</translation>
        </message>
        <message>
            <source>The most that the figure can be while every value is within a twenty-fifth of the cycle</source>
            <translation>Das Höchste, was der Kennwert erreichen kann, solange jeder Wert in einem Fünfundzwanzigstel des Zyklus liegt</translation>
        </message>
        <message>
            <source>What you type: observation time and value, points parted by semicolons</source>
            <translation>Was Sie eintippen: Beobachtungszeit und Wert, Punkte durch Semikolons getrennt</translation>
        </message>
        <message>
            <source>Observation time and value: &quot;1ms 100ns; 1s 250ns&quot;. Between points the mask is straight on both logarithmic axes, outside of them nothing is asked. A value alone is asked at every time.</source>
            <translation>Beobachtungszeit und Wert: „1ms 100ns; 1s 250ns“. Zwischen den Punkten ist die Maske auf beiden logarithmischen Achsen gerade, außerhalb wird nichts verlangt. Ein Wert allein gilt für jede Zeit.</translation>
        </message>
        <message>
            <source>Nobody understands &quot;%1&quot; in the mask.</source>
            <translation>„%1“ in der Maske versteht niemand.</translation>
        </message>
    </context>
    <context>
    <name>SlaveFiguresModel</name>
        <message>
            <source>reference</source>
            <translation>Referenz</translation>
        </message>
        <message>
            <source>no DC</source>
            <translation>ohne DC</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>Jetzt</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>Alter</translation>
        </message>
        <message>
            <source>Max</source>
            <translation>Max</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>Over</source>
            <translation>Darüber</translation>
        </message>
        <message>
            <source>SM2 missed</source>
            <translation>SM2 verpasst</translation>
        </message>
        <message>
            <source>Course</source>
            <translation>Verlauf</translation>
        </message>
        <message>
            <source>By position</source>
            <translation>Nach der Position</translation>
        </message>
        <message>
            <source>The newest reading; a dash where it is too old to be present</source>
            <translation>Die neueste Ablesung; ein Strich, wo sie zu alt ist, um noch zu gelten</translation>
        </message>
        <message>
            <source>Of the newest reading, at the end of the range shown</source>
            <translation>Der neuesten Ablesung, am Ende des gezeigten Bereichs</translation>
        </message>
        <message>
            <source>The largest magnitude of all readings of the range shown</source>
            <translation>Der größte Betrag aller Ablesungen des gezeigten Bereichs</translation>
        </message>
        <message>
            <source>Of all readings, with their signs; sorted by its magnitude</source>
            <translation>Aller Ablesungen, mit Vorzeichen; sortiert nach dem Betrag</translation>
        </message>
        <message>
            <source>Root mean square of all readings, about zero</source>
            <translation>Effektivwert aller Ablesungen, um null</translation>
        </message>
        <message>
            <source>Part of the readings whose magnitude is over the limit</source>
            <translation>Anteil der Ablesungen, deren Betrag über dem Grenzwert liegt</translation>
        </message>
        <message>
            <source>SM2 events missed in the range shown; a dash without such a counter</source>
            <translation>Im gezeigten Bereich verpasste SM2-Ereignisse; ein Strich ohne einen solchen Zähler</translation>
        </message>
        <message>
            <source>The largest magnitudes over the range shown; the top is the limit</source>
            <translation>Die größten Beträge über den gezeigten Bereich; oben ist der Grenzwert</translation>
        </message>
        <message>
            <source>%1; too few readings, or too alike, to say how sure that is</source>
            <translation>%1; zu wenige oder zu ähnliche Ablesungen, um zu sagen, wie sicher das ist</translation>
        </message>
        <message>
            <source>%1; with 95 % certainty the true mean lies in it</source>
            <translation>%1; mit 95 % Sicherheit liegt der wahre Mittelwert darin</translation>
        </message>
    </context>
    <context>
    <name>SlavesView</name>
        <message>
            <source>Note</source>
            <translation>Notiz</translation>
        </message>
        <message>
            <source>Deviations of all slaves</source>
            <translation>Abweichungen aller Slaves</translation>
        </message>
        <message>
            <source>Colours of the deviations</source>
            <translation>Farben der Abweichungen</translation>
        </message>
        <message>
            <source>Reading under the pointer</source>
            <translation>Ablesung unter dem Zeiger</translation>
        </message>
        <message>
            <source>Figures of all slaves</source>
            <translation>Kennzahlen aller Slaves</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>%1 old</source>
            <translation>%1 alt</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>keine Ablesung</translation>
        </message>
        <message>
            <source>up to %1 in the cell</source>
            <translation>bis zu %1 in der Zelle</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>Grenzwert ±%1</translation>
        </message>
        <message>
            <source>%1: now %2, at most %3</source>
            <translation>%1: jetzt %2, höchstens %3</translation>
        </message>
            <message>
            <source>Farthest off is %1: %2</source>
            <translation>Am weitesten daneben liegt %1: %2</translation>
        </message>
</context>
    <context>
    <name>StabilityView</name>
        <message>
            <source>1/25 of the cycle</source>
            <translation>1/25 des Zyklus</translation>
        </message>
        <message>
            <source>own mask</source>
            <translation>eigene Maske</translation>
        </message>
        <message>
            <source>There is no mask yet.</source>
            <translation>Es gibt noch keine Maske.</translation>
        </message>
        <message>
            <source>The mask asks nothing at the observation times that are shown.</source>
            <translation>Die Maske verlangt bei den gezeigten Beobachtungszeiten nichts.</translation>
        </message>
        <message>
            <source>Keeps the mask; closest to it at τ %1: %2 of %3.</source>
            <translation>Hält die Maske ein; am nächsten bei τ %1: %2 von %3.</translation>
        </message>
        <message>
            <source>Beyond the mask at %1 of %2 observation times, from τ %3 on; furthest at %4: %5 where %6 is allowed.</source>
            <translation>Jenseits der Maske bei %1 von %2 Beobachtungszeiten, ab τ %3; am weitesten bei %4: %5, wo %6 erlaubt sind.</translation>
        </message>
    </context>
    <context>
    <name>StepText</name>
        <message>
            <source>overshoot %1 %</source>
            <translation>Überschwingen %1 %</translation>
        </message>
        <message>
            <source>settled after %1</source>
            <translation>eingeschwungen nach %1</translation>
        </message>
        <message>
            <source>not settled</source>
            <translation>nicht eingeschwungen</translation>
        </message>
        <message>
            <source>step %1: %2</source>
            <translation>Sprung %1: %2</translation>
        </message>
        <message>
            <source> (its controller without noise: %1)</source>
            <translation> (sein Regler ohne Rauschen: %1)</translation>
        </message>
    </context>
    <context>
    <name>SyncWindowFields</name>
        <message>
            <source>Limit</source>
            <translation>Grenze</translation>
        </message>
    </context>
    <context>
    <name>ClockStep</name>
        <message>
            <source>Its description has no distributed clocks.</source>
            <translation>Seine Beschreibung hat keine verteilten Uhren.</translation>
        </message>
        <message>
            <source>It may be missing; then nobody leads.</source>
            <translation>Er darf fehlen; dann führt niemand.</translation>
        </message>
        <message>
            <source>%1 stands before it, uses DC and would hear of its time a cycle late.</source>
            <translation>%1 steht vor ihm, nutzt DC und erführe seine Zeit einen Zyklus zu spät.</translation>
        </message>
        <message>
            <source>No</source>
            <translation>Nein</translation>
        </message>
        <message>
            <source>Yes</source>
            <translation>Ja</translation>
        </message>
        <message>
            <source>Better not</source>
            <translation>Besser nicht</translation>
        </message>
        <message>
            <source>Reference Clock</source>
            <translation>Referenzuhr</translation>
        </message>
        <message>
            <source>Slaves that move together need distributed clocks: one slave's clock leads, and the others follow it. Without synchronised motion leave them off.</source>
            <translation>Slaves, die sich gemeinsam bewegen, brauchen verteilte Uhren: Die Uhr eines Slaves führt, die anderen folgen ihr. Ohne synchrone Bewegung bleiben sie aus.</translation>
        </message>
        <message>
            <source>Distributed Clocks</source>
            <translation>Verteilte Uhren</translation>
        </message>
        <message>
            <source>Leads now</source>
            <translation>Führt jetzt</translation>
        </message>
        <message>
            <source>The slave whose clock the compiled project makes lead</source>
            <translation>Der Slave, dessen Uhr nach dem übersetzten Projekt führt</translation>
        </message>
        <message>
            <source>Which slaves can lead, and why not</source>
            <translation>Welche Slaves führen können, und warum nicht</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Can lead</source>
            <translation>Kann führen</translation>
        </message>
        <message>
            <source>Why not</source>
            <translation>Warum nicht</translation>
        </message>
    </context>
    <context>
    <name>CycleDialog</name>
        <message>
            <source>Cycle Times</source>
            <translation>Zykluszeiten</translation>
        </message>
        <message>
            <source>Cycles and who refuses them</source>
            <translation>Zyklen und wer sie ablehnt</translation>
        </message>
        <message>
            <source>&amp;Use This Cycle</source>
            <translation>Diesen Zyklus &amp;verwenden</translation>
        </message>
        <message>
            <source>The slaves accept: %1.</source>
            <translation>Die Slaves nehmen an: %1.</translation>
        </message>
</context>
<context>
    <name>CycleStep</name>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>How often the process data go over the network. All Sync Unit Cycles are multiples or fractions of it.</source>
            <translation>Wie oft die Prozessdaten über das Netz gehen. Alle Sync Unit Cycles sind Vielfache oder Bruchteile davon.</translation>
        </message>
        <message>
            <source>Network</source>
            <translation>Netz</translation>
        </message>
        <message>
            <source>Slaves accept</source>
            <translation>Slaves nehmen an</translation>
        </message>
        <message>
            <source>What drive families, object 0x1C32:05, operation modes and the frames leave</source>
            <translation>Was Antriebsfamilien, Objekt 0x1C32:05, Betriebsarten und die Frames zulassen</translation>
        </message>
        <message>
            <source>Cycles and who refuses them</source>
            <translation>Zyklen und wer sie ablehnt</translation>
        </message>
    </context>
<context>
    <name>CycleTable</name>
        <message>
            <source>Refused</source>
            <translation>Abgelehnt</translation>
        </message>
        <message>
            <source>Accepted by all</source>
            <translation>Alle nehmen ihn an</translation>
        </message>
        <message>
            <source>Taken with a loss</source>
            <translation>Mit Einbußen angenommen</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Because of</source>
            <translation>Wegen</translation>
        </message>
        <message>
            <source>Enter or a double click takes the cycle</source>
            <translation>Eingabe oder Doppelklick übernimmt den Zyklus</translation>
        </message>
        <message>
            <source>%1 to %2, in steps of %3</source>
            <translation>%1 bis %2, in Schritten von %3</translation>
        </message>
        <message>
            <source>any cycle</source>
            <translation>jeden Zyklus</translation>
        </message>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>%n weiterer</numerusform>
                <numerusform>%n weitere</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
</context>
    <context>
    <name>DcModeModel</name>
        <message>
            <source>no distributed clocks</source>
            <translation>keine verteilten Uhren</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Aus</translation>
        </message>
        <message>
            <source>User defined</source>
            <translation>Eigener Wert</translation>
        </message>
        <message>
            <source>As operation mode</source>
            <translation>Wie Betriebsart</translation>
        </message>
        <message>
            <source>As operation mode (%1)</source>
            <translation>Wie Betriebsart (%1)</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Operation mode</source>
            <translation>Betriebsart</translation>
        </message>
        <message>
            <source>Sync Unit Cycle</source>
            <translation>Sync Unit Cycle</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>Befund</translation>
        </message>
    </context>
    <context>
    <name>MachineDraft</name>
        <message>
            <source>Reading slave %1 of %2</source>
            <translation>Lese Slave %1 von %2</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>%n Slave auf %1 gefunden</numerusform>
                <numerusform>%n Slaves auf %1 gefunden</numerusform>
            </translation>
        </message>
        <message>
            <source>The scan was cancelled; the slaves are those of before.</source>
            <translation>Der Scan wurde abgebrochen; die Slaves sind die von vorher.</translation>
        </message>
        <message>
            <source>The machine of the window runs on this bus. Go offline first, or choose another bus.</source>
            <translation>Die Maschine des Fensters läuft auf diesem Bus. Erst offline gehen oder einen anderen Bus wählen.</translation>
        </message>
        <message>
            <source>Looking for slaves…</source>
            <translation>Suche Slaves …</translation>
        </message>
        <message numerus="yes">
            <source>A project was made of %1; exported again, %n command(s) would differ.</source>
            <translation>
                <numerusform>Aus %1 wurde ein Projekt; erneut exportiert wäre %n Kommando anders.</numerusform>
                <numerusform>Aus %1 wurde ein Projekt; erneut exportiert wären %n Kommandos anders.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) as in %1</source>
            <translation>
                <numerusform>%n Slave wie in %1</numerusform>
                <numerusform>%n Slaves wie in %1</numerusform>
            </translation>
        </message>
        <message>
            <source>Add a slave</source>
            <translation>Slave hinzufügen</translation>
        </message>
        <message>
            <source>%1 was added.</source>
            <translation>%1 wurde hinzugefügt.</translation>
        </message>
        <message>
            <source>Remove a slave</source>
            <translation>Slave entfernen</translation>
        </message>
    </context>
    <context>
    <name>ModesStep</name>
        <message>
            <source>Operation Modes</source>
            <translation>Betriebsarten</translation>
        </message>
        <message>
            <source>What each slave does with the SYNC signals, and how often. F2 or a double click opens a choice.</source>
            <translation>Was jeder Slave mit den SYNC-Signalen tut, und wie oft. F2 oder ein Doppelklick öffnet die Auswahl.</translation>
        </message>
        <message>
            <source>Change DC mode</source>
            <translation>DC-Betriebsart ändern</translation>
        </message>
        <message>
            <source>Operation modes of all slaves</source>
            <translation>Betriebsarten aller Slaves</translation>
        </message>
        <message>
            <source>What is found wrong with the selected slave</source>
            <translation>Was am gewählten Slave nicht stimmt</translation>
        </message>
    </context>
    <context>
    <name>NewMachineWizard</name>
        <message>
            <source>New Machine</source>
            <translation>Neue Maschine</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Schritt</translation>
        </message>
        <message>
            <source>What is decided here</source>
            <translation>Was hier entschieden wird</translation>
        </message>
        <message>
            <source>Why it does not go on</source>
            <translation>Warum es nicht weitergeht</translation>
        </message>
        <message>
            <source>&lt; Bac&amp;k</source>
            <translation>&lt; &amp;Zurück</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Zurück</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>Weiter</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>&amp;Finish</source>
            <translation>&amp;Fertigstellen</translation>
        </message>
        <message>
            <source>&amp;Next &gt;</source>
            <translation>&amp;Weiter &gt;</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>Fertigstellen</translation>
        </message>
        <message>
            <source>A field holds what cannot be a value: mend it, or press Esc in it.</source>
            <translation>In einem Feld steht, was kein Wert sein kann: berichtigen oder darin Esc drücken.</translation>
        </message>
        <message>
            <source>%1 exists already.</source>
            <translation>%1 gibt es schon.</translation>
        </message>
        <message>
            <source>Its contents go when the ENI is written.</source>
            <translation>Ihr Inhalt geht verloren, wenn die ENI geschrieben wird.</translation>
        </message>
        <message>
            <source>Overwrite</source>
            <translation>Überschreiben</translation>
        </message>
        <message>
            <source>Give up the new machine?</source>
            <translation>Die neue Maschine aufgeben?</translation>
        </message>
        <message>
            <source>What was chosen here goes. The project of the window stays as it is.</source>
            <translation>Was hier gewählt wurde, geht verloren. Das Projekt des Fensters bleibt, wie es ist.</translation>
        </message>
        <message>
            <source>Give Up</source>
            <translation>Aufgeben</translation>
        </message>
    </context>
    <context>
    <name>SourceStep</name>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Where do the slaves come from? The list on the right shows what the new machine has so far.</source>
            <translation>Woher kommen die Slaves? Die Liste rechts zeigt, was die neue Maschine schon hat.</translation>
        </message>
        <message>
            <source>A project is made of what the file lets be seen. Devices of the catalogue bring what an ENI does not hold.</source>
            <translation>Aus dem, was die Datei erkennen lässt, wird ein Projekt. Geräte des Katalogs bringen mit, was in keiner ENI steht.</translation>
        </message>
        <message>
            <source>Choose EN&amp;I…</source>
            <translation>EN&amp;I wählen …</translation>
        </message>
        <message>
            <source>All that a saved project holds, under a new name. The file stays as it is.</source>
            <translation>Alles, was ein gespeichertes Projekt enthält, unter neuem Namen. Die Datei bleibt, wie sie ist.</translation>
        </message>
        <message>
            <source>Choose &amp;Project…</source>
            <translation>&amp;Projekt wählen …</translation>
        </message>
        <message>
            <source>&amp;Scan of a bus</source>
            <translation>&amp;Scan eines Busses</translation>
        </message>
        <message>
            <source>&amp;ENI file</source>
            <translation>&amp;ENI-Datei</translation>
        </message>
        <message>
            <source>&amp;Device catalogue</source>
            <translation>&amp;Gerätekatalog</translation>
        </message>
        <message>
            <source>Project as a &amp;template</source>
            <translation>Projekt als &amp;Vorlage</translation>
        </message>
        <message>
            <source>What came of it</source>
            <translation>Was daraus wurde</translation>
        </message>
        <message>
            <source>A network card or a simulated bus. A bus whose slaves are running is only looked at, and nothing is written to it.</source>
            <translation>Eine Netzwerkkarte oder ein simulierter Bus. Ein Bus, dessen Slaves laufen, wird nur angesehen; geschrieben wird nichts.</translation>
        </message>
        <message>
            <source>Bus</source>
            <translation>Bus</translation>
        </message>
        <message>
            <source>Choose &amp;Bus and Scan…</source>
            <translation>&amp;Bus wählen und scannen …</translation>
        </message>
        <message>
            <source>Choose a bus and scan it</source>
            <translation>Einen Bus wählen und scannen</translation>
        </message>
        <message>
            <source>Cance&amp;l Scan</source>
            <translation>Scan a&amp;bbrechen</translation>
        </message>
        <message>
            <source>Cancel the scan</source>
            <translation>Den Scan abbrechen</translation>
        </message>
        <message>
            <source>Scan &amp;Fully…</source>
            <translation>&amp;Vollständig scannen …</translation>
        </message>
        <message>
            <source>Scan fully</source>
            <translation>Vollständig scannen</translation>
        </message>
        <message>
            <source>Why the scan is not whole</source>
            <translation>Warum der Scan nicht vollständig ist</translation>
        </message>
        <message>
            <source>Touch the running machine?</source>
            <translation>Die laufende Maschine berühren?</translation>
        </message>
        <message>
            <source>States stay as they are. EEPROMs are taken from their devices while they are read, the receive times of all slaves are latched, and slaves without a description are asked in PREOP.</source>
            <translation>Zustände bleiben, wie sie sind. EEPROMs werden ihren Geräten entzogen, während sie gelesen werden, die Empfangszeiten aller Slaves werden erfasst, und Slaves ohne Beschreibung werden in PREOP befragt.</translation>
        </message>
        <message>
            <source>Scan Fully</source>
            <translation>Vollständig scannen</translation>
        </message>
        <message>
            <source>Number of slaves</source>
            <translation>Zahl der Slaves</translation>
        </message>
        <message>
            <source>Slaves of the new machine</source>
            <translation>Slaves der neuen Maschine</translation>
        </message>
        <message>
            <source>&amp;Remove</source>
            <translation>En&amp;tfernen</translation>
        </message>
        <message>
            <source>Remove the selected slave with its branches</source>
            <translation>Den gewählten Slave mit seinen Zweigen entfernen</translation>
        </message>
        <message>
            <source>Remove the selected slave with its branches (Del)</source>
            <translation>Den gewählten Slave mit seinen Zweigen entfernen (Entf)</translation>
        </message>
        <message>
            <source>The bus is being scanned.</source>
            <translation>Der Bus wird gescannt.</translation>
        </message>
        <message>
            <source>The machine has no slaves yet.</source>
            <translation>Die Maschine hat noch keine Slaves.</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n Slave</numerusform>
                <numerusform>%n Slaves</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) of this bus are running. They were only looked at and nothing was written, so some of what they are may not be known.</source>
            <translation>
                <numerusform>%n Slave dieses Busses läuft. Es wurde nur geschaut und nichts geschrieben, daher ist vielleicht nicht alles über ihn bekannt.</numerusform>
                <numerusform>%n Slaves dieses Busses laufen. Es wurde nur geschaut und nichts geschrieben, daher ist vielleicht nicht alles über sie bekannt.</numerusform>
            </translation>
        </message>
        <message>
            <source>Scanned: %1</source>
            <translation>Gescannt: %1</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Scannen</translation>
        </message>
        <message>
            <source>Open ENI</source>
            <translation>ENI öffnen</translation>
        </message>
        <message>
            <source>EtherCAT network information (*.xml *.eni)</source>
            <translation>EtherCAT-Netzinformation (*.xml *.eni)</translation>
        </message>
        <message>
            <source>Open Project</source>
            <translation>Projekt öffnen</translation>
        </message>
        <message>
            <source>Syncline projects (*.syncline)</source>
            <translation>Syncline-Projekte (*.syncline)</translation>
        </message>
        <message>
            <source>Your templates (File, Save as Template)</source>
            <translation>Eigene Vorlagen (Datei, Als Vorlage sichern)</translation>
        </message>
        <message>
            <source>&amp;Your templates (File, Save as Template)</source>
            <translation>E&amp;igene Vorlagen (Datei, Als Vorlage sichern)</translation>
        </message>
        <message>
            <source>&amp;Use Template</source>
            <translation>Vorlage &amp;nehmen</translation>
        </message>
        <message>
            <source>Take the slaves of the template</source>
            <translation>Die Slaves der Vorlage nehmen</translation>
        </message>
        <message>
            <source>Re&amp;move Template…</source>
            <translation>Vorlage entfe&amp;rnen …</translation>
        </message>
        <message>
            <source>Remove the template</source>
            <translation>Die Vorlage entfernen</translation>
        </message>
    </context>
    <context>
    <name>SummaryStep</name>
        <message>
            <source>Summary</source>
            <translation>Zusammenfassung</translation>
        </message>
        <message>
            <source>Finish puts the machine into the window, where everything can be changed further. It is not saved yet.</source>
            <translation>Fertigstellen bringt die Maschine ins Fenster, wo sich alles weiter ändern lässt. Gespeichert ist sie dann noch nicht.</translation>
        </message>
        <message>
            <source>The new machine</source>
            <translation>Die neue Maschine</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>Referenzuhr</translation>
        </message>
        <message>
            <source>Master synchronisation</source>
            <translation>Master-Synchronisation</translation>
        </message>
        <message>
            <source>Sync window</source>
            <translation>Sync-Fenster</translation>
        </message>
        <message>
            <source>What the check found</source>
            <translation>Was die Prüfung fand</translation>
        </message>
        <message>
            <source>Findings</source>
            <translation>Befunde</translation>
        </message>
        <message>
            <source>&amp;Export the ENI to</source>
            <translation>ENI &amp;exportieren nach</translation>
        </message>
        <message>
            <source>Export the ENI, too</source>
            <translation>Auch die ENI exportieren</translation>
        </message>
        <message>
            <source>File of the ENI</source>
            <translation>Datei der ENI</translation>
        </message>
        <message>
            <source>Bro&amp;wse…</source>
            <translation>&amp;Durchsuchen …</translation>
        </message>
        <message>
            <source>Choose the file of the ENI</source>
            <translation>Die Datei der ENI wählen</translation>
        </message>
        <message>
            <source>The ENI needs a file name.</source>
            <translation>Die ENI braucht einen Dateinamen.</translation>
        </message>
        <message>
            <source>There is no folder %1.</source>
            <translation>Den Ordner %1 gibt es nicht.</translation>
        </message>
        <message>
            <source>Export ENI</source>
            <translation>ENI exportieren</translation>
        </message>
        <message>
            <source>EtherCAT network information (*.xml)</source>
            <translation>EtherCAT-Netzwerkbeschreibung (*.xml)</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>%1, with DC %2</source>
            <translation>%1, mit DC %2</translation>
        </message>
        <message>
            <source>distributed clocks are off</source>
            <translation>verteilte Uhren sind aus</translation>
        </message>
        <message>
            <source>monitored, limit %1</source>
            <translation>überwacht, Grenze %1</translation>
        </message>
        <message>
            <source>not monitored</source>
            <translation>nicht überwacht</translation>
        </message>
        <message>
            <source>The ENI is being checked…</source>
            <translation>Die ENI wird geprüft …</translation>
        </message>
        <message>
            <source>The check of project and ENI found nothing.</source>
            <translation>Die Prüfung von Projekt und ENI fand nichts.</translation>
        </message>
        <message numerus="yes">
            <source>%n error(s)</source>
            <translation>
                <numerusform>%n Fehler</numerusform>
                <numerusform>%n Fehler</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n Warnung</numerusform>
                <numerusform>%n Warnungen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n note(s)</source>
            <translation>
                <numerusform>%n Hinweis</numerusform>
                <numerusform>%n Hinweise</numerusform>
            </translation>
        </message>
        <message>
            <source>The check of project and ENI found: %1.</source>
            <translation>Die Prüfung von Projekt und ENI fand: %1.</translation>
        </message>
    </context>
    <context>
    <name>SyncStep</name>
        <message>
            <source>The master's clock leads and steers the reference clock, by a command in each frame. For several networks in one machine, or a host whose timer cannot be moved. It needs a steady host.</source>
            <translation>Die Uhr des Masters führt und stellt die Referenzuhr, mit einem Kommando in jedem Frame. Für mehrere Netze in einer Maschine oder einen Rechner, dessen Zeitgeber sich nicht verschieben lässt. Der Rechner muss ruhig laufen.</translation>
        </message>
        <message>
            <source>The reference clock leads and the master moves its send time after it. For one network; the slaves' SYNC signals have nothing of the host's jitter.</source>
            <translation>Die Referenzuhr führt, und der Master verschiebt seinen Sendezeitpunkt danach. Für ein einzelnes Netz; die SYNC-Signale der Slaves haben nichts vom Jitter des Rechners.</translation>
        </message>
        <message>
            <source>Nobody follows: the frames drift through the SYNC grid of the slaves. For machines without synchronised motion only.</source>
            <translation>Niemand folgt: Die Frames wandern durch das SYNC-Raster der Slaves. Nur für Maschinen ohne synchrone Bewegung.</translation>
        </message>
        <message>
            <source>Another way, for special hardware; the page Distributed Clocks of the master explains it.</source>
            <translation>Eine andere Art, für besondere Hardware; die Seite Verteilte Uhren des Masters erklärt sie.</translation>
        </message>
        <message>
            <source>Distributed clocks are off: there is nothing to bring together.</source>
            <translation>Verteilte Uhren sind aus: Es gibt nichts abzugleichen.</translation>
        </message>
        <message>
            <source>No slave has an operation mode with SYNC signals: there is nothing to bring together.</source>
            <translation>Kein Slave hat eine Betriebsart mit SYNC-Signalen: Es gibt nichts abzugleichen.</translation>
        </message>
        <message>
            <source>Networks keep step when each reference clock follows the one clock of the masters.</source>
            <translation>Netze bleiben im Gleichschritt, wenn jede Referenzuhr der einen Uhr der Master folgt.</translation>
        </message>
        <message>
            <source>In a single network the slave's clock is the steadiest one to follow.</source>
            <translation>In einem einzelnen Netz ist die Uhr des Slaves die ruhigste, der man folgen kann.</translation>
        </message>
        <message>
            <source>Synchronisation</source>
            <translation>Synchronisation</translation>
        </message>
        <message>
            <source>Master and reference clock run at slightly different speeds: one of them has to follow the other.</source>
            <translation>Master und Referenzuhr gehen etwas verschieden schnell: Einer muss dem anderen folgen.</translation>
        </message>
        <message>
            <source>Who follows whom</source>
            <translation>Wer folgt wem</translation>
        </message>
        <message>
            <source>Proposal</source>
            <translation>Vorschlag</translation>
        </message>
        <message>
            <source>Sync Window Monitoring</source>
            <translation>Überwachung des Sync-Fensters</translation>
        </message>
        <message>
            <source>What it is for</source>
            <translation>Wofür das ist</translation>
        </message>
        <message>
            <source>&amp;Several networks run in step</source>
            <translation>Mehrere &amp;Netze im Gleichschritt</translation>
        </message>
        <message>
            <source>Several networks run in step</source>
            <translation>Mehrere Netze im Gleichschritt</translation>
        </message>
        <message>
            <source>More than one EtherCAT network of the machine has to keep a common time</source>
            <translation>Mehr als ein EtherCAT-Netz der Maschine muss dieselbe Zeit halten</translation>
        </message>
        <message>
            <source>&amp;Use Proposal</source>
            <translation>Vorschlag ü&amp;bernehmen</translation>
        </message>
        <message>
            <source>Use the proposal</source>
            <translation>Den Vorschlag übernehmen</translation>
        </message>
    </context>
<context>
    <name>MasterGeneralPage</name>
        <message>
            <source>Accepted…</source>
            <translation>Angenommen …</translation>
        </message>
        <message>
            <source>Cycles that the slaves accept</source>
            <translation>Zyklen, die die Slaves annehmen</translation>
        </message>
        <message>
            <source>Cycle times that all slaves accept, who refuses the others, and why</source>
            <translation>Zykluszeiten, die alle Slaves annehmen, wer die anderen ablehnt, und warum</translation>
        </message>
        <message>
            <source>Recovery</source>
            <translation>Wiederanlauf</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Allgemein</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>Einstellungen</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>Konfiguration</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Configured slaves</source>
            <translation>Konfigurierte Slaves</translation>
        </message>
        <message>
            <source>Slaves with DC</source>
            <translation>Slaves mit DC</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Eingänge</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>Ausgänge</translation>
        </message>
        <message>
            <source>Cyclic frames</source>
            <translation>Zyklische Frames</translation>
        </message>
        <message>
            <source>State Machine</source>
            <translation>Zustandsmaschine</translation>
        </message>
        <message>
            <source>Bus</source>
            <translation>Bus</translation>
        </message>
        <message>
            <source>Current state</source>
            <translation>Aktueller Zustand</translation>
        </message>
        <message>
            <source>Lowest state of all slaves (register 0x0130)</source>
            <translation>Niedrigster Zustand aller Slaves (Register 0x0130)</translation>
        </message>
        <message>
            <source>Requested state</source>
            <translation>Angeforderter Zustand</translation>
        </message>
        <message>
            <source>State asked for last (register 0x0120)</source>
            <translation>Zuletzt angeforderter Zustand (Register 0x0120)</translation>
        </message>
        <message>
            <source>Request state %1</source>
            <translation>Zustand %1 anfordern</translation>
        </message>
        <message>
            <source>Request %1 for all slaves (register 0x0120)</source>
            <translation>%1 für alle Slaves anfordern (Register 0x0120)</translation>
        </message>
        <message>
            <source>Slaves answering</source>
            <translation>Antwortende Slaves</translation>
        </message>
        <message>
            <source>Slaves that answered the last state reading</source>
            <translation>Slaves, die die letzte Zustandsabfrage beantwortet haben</translation>
        </message>
        <message>
            <source>Cycles</source>
            <translation>Zyklen</translation>
        </message>
        <message>
            <source>Bus cycles since going online</source>
            <translation>Buszyklen seit dem Onlinegehen</translation>
        </message>
        <message>
            <source>Lost frames</source>
            <translation>Verlorene Frames</translation>
        </message>
        <message>
            <source>Frames that did not come back</source>
            <translation>Frames, die nicht zurückkamen</translation>
        </message>
        <message>
            <source>Working counter errors</source>
            <translation>Working-Counter-Fehler</translation>
        </message>
        <message>
            <source>Cycles whose working counter was not the expected one</source>
            <translation>Zyklen, deren Working Counter nicht der erwartete war</translation>
        </message>
        <message>
            <source>Cycles left out</source>
            <translation>Ausgelassene Zyklen</translation>
        </message>
        <message>
            <source>Cycles without a frame: the host came too late for them</source>
            <translation>Zyklen ohne Frame: der Host kam zu spät für sie</translation>
        </message>
        <message>
            <source>%1, %2 on the wire</source>
            <translation>%1, %2 auf der Leitung</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 von %2</translation>
        </message>
        <message>
            <source>Slaves whose distributed clock is set up (ENI Slave/DC)</source>
            <translation>Slaves, deren Distributed Clock eingerichtet wird (ENI Slave/DC)</translation>
        </message>
        <message>
            <source>Late frames</source>
            <translation>Verspätete Frames</translation>
        </message>
        <message>
            <source>Frames that came back after their cycle</source>
            <translation>Frames, die nach ihrem Zyklus zurückkamen</translation>
        </message>
        <message>
            <source>Frame Addresses</source>
            <translation>Adressen der Frames</translation>
        </message>
        <message>
            <source>Process Image</source>
            <translation>Prozessabbild</translation>
        </message>
        <message>
            <source>Real Time</source>
            <translation>Echtzeit</translation>
        </message>
        <message>
            <source>Process data of all slaves to the master</source>
            <translation>Prozessdaten aller Slaves zum Master</translation>
        </message>
        <message>
            <source>Process data of the master to all slaves</source>
            <translation>Prozessdaten des Masters an alle Slaves</translation>
        </message>
        <message>
            <source>Bytes on the wire and time for them at 100 Mbit/s, in a cycle; the page Frames and Cost says more</source>
            <translation>Bytes auf der Leitung und ihre Zeit bei 100 Mbit/s, in einem Zyklus; mehr sagt die Seite Frames und Aufwand</translation>
        </message>
</context>
<context>
    <name>MessageModel</name>
        <message>
            <source>%1
Setting %2</source>
            <translation>%1
Einstellung %2</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>Projekt</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Warnung</translation>
        </message>
        <message>
            <source>Information</source>
            <translation>Information</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <source>Severity</source>
            <translation>Schwere</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>Meldung</translation>
        </message>
        <message>
            <source>%1 by the clock of the recorded run</source>
            <translation>%1 nach der Uhr des aufgezeichneten Laufs</translation>
        </message>
        <message>
            <source>%1 by the clock of this computer</source>
            <translation>%1 nach der Uhr dieses Rechners</translation>
        </message>
        <message>
            <source>Run time</source>
            <translation>Laufzeit</translation>
        </message>
        <message>
            <source>Seconds of the run: since its first cycle, as on the axis of the plots</source>
            <translation>Sekunden des Laufs: seit seinem ersten Zyklus, wie auf der Achse der Diagramme</translation>
        </message>
        <message>
            <source>Time of day</source>
            <translation>Uhrzeit</translation>
        </message>
</context>
<context>
    <name>MessagesPanel</name>
        <message>
            <source>Filter messages</source>
            <translation>Meldungen filtern</translation>
        </message>
        <message>
            <source>Filter</source>
            <translation>Filter</translation>
        </message>
        <message>
            <source>Clear the log</source>
            <translation>Protokoll leeren</translation>
        </message>
        <message>
            <source>Clear the log; findings about the project stay</source>
            <translation>Protokoll leeren; Befunde zum Projekt bleiben</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Meldungen</translation>
        </message>
        <message>
            <source>Show information</source>
            <translation>Informationen zeigen</translation>
        </message>
        <message>
            <source>Show warnings</source>
            <translation>Warnungen zeigen</translation>
        </message>
        <message>
            <source>Show errors</source>
            <translation>Fehler zeigen</translation>
        </message>
</context>
<context>
    <name>NetworkModel</name>
        <message>
            <source>%1, network in work</source>
            <translation>%1, Netzwerk in Arbeit</translation>
        </message>
        <message>
            <source>%1, another network</source>
            <translation>%1, anderes Netzwerk</translation>
        </message>
        <message>
            <source>Node</source>
            <translation>Knoten</translation>
        </message>
        <message>
            <source>Position %1, station address %2 (register 0x0010)</source>
            <translation>Position %1, Stationsadresse %2 (Register 0x0010)</translation>
        </message>
        <message>
            <source>Reference clock of the project</source>
            <translation>Referenzuhr des Projekts</translation>
        </message>
        <message>
            <source>Distributed clocks on</source>
            <translation>Distributed Clocks ein</translation>
        </message>
        <message>
            <source>State %1</source>
            <translation>Zustand %1</translation>
        </message>
        <message>
            <source>State %1 (register 0x0130 = %2)</source>
            <translation>Zustand %1 (Register 0x0130 = %2)</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>no DC</source>
            <translation>kein DC</translation>
        </message>
        <message>
            <source>HC</source>
            <translation>HC</translation>
        </message>
        <message>
            <source>opt.</source>
            <translation>opt.</translation>
        </message>
        <message>
            <source>%1, position %2, address %3</source>
            <translation>%1, Position %2, Adresse %3</translation>
        </message>
        <message>
            <source>Hot-connect group %1</source>
            <translation>Hot-Connect-Gruppe %1</translation>
        </message>
        <message>
            <source>Optional: may be missing</source>
            <translation>Optional: darf fehlen</translation>
        </message>
        <message>
            <source>The cable to it is broken</source>
            <translation>Das Kabel dorthin ist unterbrochen</translation>
        </message>
</context>
<context>
    <name>Page</name>
        <message>
            <source>Project</source>
            <translation>Projekt</translation>
        </message>
</context>
<context>
    <name>PdoEntryModel</name>
        <message>
            <source>(padding)</source>
            <translation>(Füllbits)</translation>
        </message>
        <message>
            <source>Offset</source>
            <translation>Offset</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>Entry</source>
            <translation>Eintrag</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Typ</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
</context>
<context>
    <name>PdoModel</name>
        <message>
            <source>The device needs this PDO (Mandatory in the ESI)</source>
            <translation>Das Gerät braucht dieses PDO (Mandatory in der ESI)</translation>
        </message>
        <message>
            <source>Assigned through object 0x1C12</source>
            <translation>Zugeordnet über Objekt 0x1C12</translation>
        </message>
        <message>
            <source>Assigned through object 0x1C13</source>
            <translation>Zugeordnet über Objekt 0x1C13</translation>
        </message>
        <message>
            <source>PDO</source>
            <translation>PDO</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>SM</source>
            <translation>SM</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>Excluded by %1, which the device needs (Exclude and Mandatory in the ESI)</source>
            <translation>Ausgeschlossen durch %1, das das Gerät braucht (Exclude und Mandatory in der ESI)</translation>
        </message>
        <message>
            <source>Takes the place of %1: the device does not exchange both (Exclude in the ESI)</source>
            <translation>Tritt an die Stelle von %1: beide tauscht das Gerät nicht aus (Exclude in der ESI)</translation>
        </message>
</context>
<context>
    <name>ProcessDataPage</name>
        <message>
            <source>Process Data</source>
            <translation>Prozessdaten</translation>
        </message>
        <message>
            <source>Outputs (RxPDO)</source>
            <translation>Ausgänge (RxPDO)</translation>
        </message>
        <message>
            <source>Inputs (TxPDO)</source>
            <translation>Eingänge (TxPDO)</translation>
        </message>
        <message>
            <source>Assigned size, %1</source>
            <translation>Zugeordnete Größe, %1</translation>
        </message>
        <message>
            <source>Entries</source>
            <translation>Einträge</translation>
        </message>
        <message>
            <source>Entries of %1 %2</source>
            <translation>Einträge von %1 %2</translation>
        </message>
        <message>
            <source>%1 assigned</source>
            <translation>%1 zugeordnet</translation>
        </message>
        <message>
            <source>As slave, PDO and entry</source>
            <translation>Wie Slave, PDO und Eintrag</translation>
        </message>
</context>
<context>
    <name>ProjectDocument</name>
        <message>
            <source>Untitled</source>
            <translation>Unbenannt</translation>
        </message>
        <message>
            <source>Network %1</source>
            <translation>Netzwerk %1</translation>
        </message>
</context>
<context>
    <name>QObject</name>
        <message>
            <source>Syncline</source>
            <translation>Syncline</translation>
        </message>
</context>
<context>
    <name>ScanProgress</name>
        <message>
            <source>Scan</source>
            <translation>Scannen</translation>
        </message>
        <message>
            <source>Scan progress</source>
            <translation>Fortschritt des Scans</translation>
        </message>
        <message>
            <source>Looking for slaves…</source>
            <translation>Suche Slaves …</translation>
        </message>
        <message>
            <source>Reading slave %1 of %2</source>
            <translation>Lese Slave %1 von %2</translation>
        </message>
        <message>
            <source>Cancelling…</source>
            <translation>Wird abgebrochen …</translation>
        </message>
</context>
<context>
    <name>SlaveDcPage</name>
        <message>
            <source>Distributed Clocks</source>
            <translation>Distributed Clocks</translation>
        </message>
        <message>
            <source>Operation Mode</source>
            <translation>Betriebsart</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message>
            <source>SYNC1</source>
            <translation>SYNC1</translation>
        </message>
        <message>
            <source>Registers</source>
            <translation>Register</translation>
        </message>
        <message>
            <source>Live</source>
            <translation>Live</translation>
        </message>
        <message>
            <source>Mode</source>
            <translation>Betriebsart</translation>
        </message>
        <message>
            <source>Meaning</source>
            <translation>Bedeutung</translation>
        </message>
        <message>
            <source>ESI OpMode/Desc</source>
            <translation>ESI OpMode/Desc</translation>
        </message>
        <message>
            <source>AssignActivate</source>
            <translation>AssignActivate</translation>
        </message>
        <message>
            <source>ESI OpMode/AssignActivate, written to register 0x0980</source>
            <translation>ESI OpMode/AssignActivate, geschrieben in Register 0x0980</translation>
        </message>
        <message>
            <source>Bus cycle</source>
            <translation>Buszyklus</translation>
        </message>
        <message>
            <source>Cycle of the task that exchanges the slave&apos;s process data, base of the Sync Unit Cycle</source>
            <translation>Zyklus der Task, die die Prozessdaten des Slaves austauscht, Grundlage des Sync-Unit-Zyklus</translation>
        </message>
        <message>
            <source>0x0980 activation</source>
            <translation>0x0980 Aktivierung</translation>
        </message>
        <message>
            <source>Compiled value, as written in PREOP to SAFEOP</source>
            <translation>Berechneter Wert, wie er von PREOP nach SAFEOP geschrieben wird</translation>
        </message>
        <message>
            <source>0x09A0 SYNC0 cycle</source>
            <translation>0x09A0 SYNC0-Zyklus</translation>
        </message>
        <message>
            <source>Compiled value (ENI DC/CycleTime0)</source>
            <translation>Berechneter Wert (ENI DC/CycleTime0)</translation>
        </message>
        <message>
            <source>0x09A4 SYNC1</source>
            <translation>0x09A4 SYNC1</translation>
        </message>
        <message>
            <source>Compiled value (ENI DC/CycleTime1)</source>
            <translation>Berechneter Wert (ENI DC/CycleTime1)</translation>
        </message>
        <message>
            <source>0x0990 shift</source>
            <translation>0x0990 Verschiebung</translation>
        </message>
        <message>
            <source>Compiled part of the start time (ENI DC/ShiftTime)</source>
            <translation>Berechneter Teil der Startzeit (ENI DC/ShiftTime)</translation>
        </message>
        <message>
            <source>Role</source>
            <translation>Rolle</translation>
        </message>
        <message>
            <source>What this slave's clock does on the bus</source>
            <translation>Was die Uhr dieses Slaves auf dem Bus tut</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <source>SystemTimeDifference, register 0x092C</source>
            <translation>SystemTimeDifference, Register 0x092C</translation>
        </message>
        <message>
            <source>Propagation delay</source>
            <translation>Laufzeit</translation>
        </message>
        <message>
            <source>Register 0x0928, measured at start-up</source>
            <translation>Register 0x0928, beim Hochlauf gemessen</translation>
        </message>
        <message>
            <source>Missed SM2 events</source>
            <translation>Verpasste SM2-Ereignisse</translation>
        </message>
        <message>
            <source>Counter of the device (object 0x1C32)</source>
            <translation>Zähler des Geräts (Objekt 0x1C32)</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>Referenzuhr</translation>
        </message>
        <message>
            <source>Follows</source>
            <translation>Folgt</translation>
        </message>
        <message>
            <source>DC off</source>
            <translation>DC aus</translation>
        </message>
        <message>
            <source>%1 (object %2:%3)</source>
            <translation>%1 (Objekt %2:%3)</translation>
        </message>
        <message>
            <source>%1 (computed: it has no counter)</source>
            <translation>%1 (berechnet: er hat keinen Zähler)</translation>
        </message>
        <message>
            <source>Does not follow</source>
            <translation>Folgt nicht</translation>
        </message>
        <message>
            <source>CAN</source>
            <translation>CAN</translation>
        </message>
        <message>
            <source>Output Pins</source>
            <translation>Ausgangspins</translation>
        </message>
        <message>
            <source>Pin %1</source>
            <translation>Pin %1</translation>
        </message>
        <message>
            <source>One Cycle</source>
            <translation>Ein Zyklus</translation>
        </message>
        <message>
            <source>One cycle of the slave to scale</source>
            <translation>Ein Zyklus des Slaves, maßstäblich</translation>
        </message>
        <message>
            <source>Before SYNC0</source>
            <translation>Vor SYNC0</translation>
        </message>
        <message>
            <source>From the end of the frame with the slave's outputs to the SYNC0 that uses them</source>
            <translation>Vom Ende des Frames mit den Ausgängen des Slaves bis zu dem SYNC0, das sie verwendet</translation>
        </message>
        <message>
            <source>Calc + copy</source>
            <translation>Rechnen + Kopieren</translation>
        </message>
        <message>
            <source>What the slave needs of it: as it tells itself (0x1C32:06), else as its family is known</source>
            <translation>Was der Slave davon braucht: wie er es selbst sagt (0x1C32:06), sonst wie seine Familie bekannt ist</translation>
        </message>
        <message>
            <source>Compiled value, as written in PREOP to SAFEOP; online also what the slave has</source>
            <translation>Übersetzter Wert, wie er von PREOP nach SAFEOP geschrieben wird; online auch, was der Slave hat</translation>
        </message>
        <message>
            <source>%1, the slave has %2</source>
            <translation>%1, der Slave hat %2</translation>
        </message>
        <message>
            <source>%1, read back</source>
            <translation>%1, zurückgelesen</translation>
        </message>
        <message>
            <source>no SYNC0</source>
            <translation>kein SYNC0</translation>
        </message>
</context>
<context>
    <name>SaveName</name>
        <message>
            <source>%1 is there already. Replace it?</source>
            <translation>%1 ist schon da. Ersetzen?</translation>
        </message>
</context>
<context>
    <name>SlaveFilesPage</name>
        <message>
            <source>Files</source>
            <translation>Dateien</translation>
        </message>
        <message>
            <source>Most devices take firmware in BOOT only, where the buttons above lead the slave; other files are served in PREOP and above. What a name means, and which password opens it, says the device&apos;s manual.</source>
            <translation>Die meisten Geräte nehmen Firmware nur in BOOT, wohin die Schaltflächen oben den Slave führen; andere Dateien gibt es ab PREOP. Was ein Name bedeutet und welches Passwort ihn öffnet, sagt das Handbuch des Geräts.</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>What</source>
            <translation>Was</translation>
        </message>
        <message>
            <source>File in the slave</source>
            <translation>Datei im Slave</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>File here</source>
            <translation>Datei hier</translation>
        </message>
        <message>
            <source>Outcome</source>
            <translation>Ergebnis</translation>
        </message>
        <message>
            <source>Files that were transferred</source>
            <translation>Übertragene Dateien</translation>
        </message>
        <message>
            <source>How much of the file has been transferred</source>
            <translation>Wie viel der Datei übertragen ist</translation>
        </message>
        <message>
            <source>Name of the file in the slave</source>
            <translation>Name der Datei im Slave</translation>
        </message>
        <message>
            <source>Password of the slave, a number</source>
            <translation>Passwort des Slaves, eine Zahl</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keins</translation>
        </message>
        <message>
            <source>&amp;Read into File…</source>
            <translation>In Datei &amp;lesen …</translation>
        </message>
        <message>
            <source>Copy the slave&apos;s file into a file here</source>
            <translation>Die Datei des Slaves in eine Datei hier kopieren</translation>
        </message>
        <message>
            <source>&amp;Write from File…</source>
            <translation>Aus Datei &amp;schreiben …</translation>
        </message>
        <message>
            <source>Give a file to the slave</source>
            <translation>Dem Slave eine Datei geben</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>&amp;Abbrechen</translation>
        </message>
        <message>
            <source>End the transfer</source>
            <translation>Die Übertragung beenden</translation>
        </message>
        <message>
            <source>Password</source>
            <translation>Passwort</translation>
        </message>
        <message>
            <source>The machine was started without files (FoE) for this slave: restart it with the project as it is now.</source>
            <translation>Die Maschine wurde ohne Dateien (FoE) für diesen Slave gestartet: mit dem jetzigen Projekt neu starten.</translation>
        </message>
        <message>
            <source>The slave is in %1: lead it to PREOP, or to BOOT.</source>
            <translation>Der Slave ist in %1: nach PREOP oder BOOT führen.</translation>
        </message>
        <message>
            <source>%1: &quot;%2&quot; is being written, %3 of %4.</source>
            <translation>%1: „%2“ wird geschrieben, %3 von %4.</translation>
        </message>
        <message>
            <source>%1: &quot;%2&quot; is being read, %3 so far.</source>
            <translation>%1: „%2“ wird gelesen, bisher %3.</translation>
        </message>
        <message>
            <source>The password is a number of 32 bits, such as 1234 or 0x12AB: &quot;%1&quot; is none.</source>
            <translation>Das Passwort ist eine Zahl von 32 Bit, etwa 1234 oder 0x12AB: „%1“ ist keine.</translation>
        </message>
        <message>
            <source>Read File of the Slave</source>
            <translation>Datei des Slaves lesen</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>Alle Dateien (*)</translation>
        </message>
        <message>
            <source>Write File to the Slave</source>
            <translation>Datei in den Slave schreiben</translation>
        </message>
        <message>
            <source>The file could not be read.</source>
            <translation>Die Datei konnte nicht gelesen werden.</translation>
        </message>
        <message>
            <source>Write %1 (%2) into %3 as &quot;%4&quot;?</source>
            <translation>%1 (%2) als „%4“ in %3 schreiben?</translation>
        </message>
        <message>
            <source>Nothing brings back what the slave has under this name now, and a wrong firmware can leave a slave that no longer comes up. The slave must keep its power until it is done.</source>
            <translation>Nichts bringt zurück, was der Slave jetzt unter diesem Namen hat, und nach einer falschen Firmware kommt ein Slave vielleicht nicht mehr hoch. Bis es fertig ist, darf er die Versorgung nicht verlieren.</translation>
        </message>
        <message>
            <source>The slave is in %1: taking a file may stop it.</source>
            <translation>Der Slave ist in %1: Eine Datei anzunehmen kann ihn anhalten.</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>Schreiben</translation>
        </message>
        <message>
            <source>Cancelled: the slave has a part of it, or nothing</source>
            <translation>Abgebrochen: Der Slave hat einen Teil davon oder nichts</translation>
        </message>
        <message>
            <source>Cancelled</source>
            <translation>Abgebrochen</translation>
        </message>
        <message>
            <source>Written</source>
            <translation>Geschrieben</translation>
        </message>
        <message>
            <source>Read</source>
            <translation>Gelesen</translation>
        </message>
        <message>
            <source>&quot;%1&quot;: %2</source>
            <translation>„%1“: %2</translation>
        </message>
        <message>
            <source>write</source>
            <translation>schreiben</translation>
        </message>
        <message>
            <source>read</source>
            <translation>lesen</translation>
        </message>
</context>
<context>
    <name>SlaveGeneralPage</name>
        <message>
            <source>General</source>
            <translation>Allgemein</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>Gerät</translation>
        </message>
        <message>
            <source>Address</source>
            <translation>Adresse</translation>
        </message>
        <message>
            <source>Checks at Start-up</source>
            <translation>Prüfungen beim Hochlauf</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Zustand</translation>
        </message>
        <message>
            <source>Time-outs</source>
            <translation>Zeitgrenzen</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Typ</translation>
        </message>
        <message>
            <source>ESI Device/Type</source>
            <translation>ESI Device/Type</translation>
        </message>
        <message>
            <source>Vendor</source>
            <translation>Hersteller</translation>
        </message>
        <message>
            <source>SII word 0x0008, ESI Vendor/Id</source>
            <translation>SII-Wort 0x0008, ESI Vendor/Id</translation>
        </message>
        <message>
            <source>Product code</source>
            <translation>Produktcode</translation>
        </message>
        <message>
            <source>SII word 0x000A, ESI Type@ProductCode</source>
            <translation>SII-Wort 0x000A, ESI Type@ProductCode</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>Revision</translation>
        </message>
        <message>
            <source>SII word 0x000C, ESI Type@RevisionNo</source>
            <translation>SII-Wort 0x000C, ESI Type@RevisionNo</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>Seriennummer</translation>
        </message>
        <message>
            <source>SII word 0x000E</source>
            <translation>SII-Wort 0x000E</translation>
        </message>
        <message>
            <source>Described by</source>
            <translation>Beschrieben durch</translation>
        </message>
        <message>
            <source>File or EEPROM that the device description came from</source>
            <translation>Datei oder EEPROM, woher die Gerätebeschreibung stammt</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>Alias</translation>
        </message>
        <message>
            <source>Auto-increment</source>
            <translation>Auto-Inkrement</translation>
        </message>
        <message>
            <source>Position address used before the station address is set</source>
            <translation>Positionsadresse, bevor die Stationsadresse gesetzt ist</translation>
        </message>
        <message>
            <source>Current state</source>
            <translation>Aktueller Zustand</translation>
        </message>
        <message>
            <source>AL status (register 0x0130)</source>
            <translation>AL-Status (Register 0x0130)</translation>
        </message>
        <message>
            <source>AL status code</source>
            <translation>AL-Statuscode</translation>
        </message>
        <message>
            <source>Register 0x0134</source>
            <translation>Register 0x0134</translation>
        </message>
        <message>
            <source>Meaning of the AL status code</source>
            <translation>Bedeutung des AL-Statuscodes</translation>
        </message>
        <message>
            <source>INIT to PREOP</source>
            <translation>INIT nach PREOP</translation>
        </message>
        <message>
            <source>ESI Timeout/PreopTimeout</source>
            <translation>ESI Timeout/PreopTimeout</translation>
        </message>
        <message>
            <source>PREOP to SAFEOP to OP</source>
            <translation>PREOP nach SAFEOP nach OP</translation>
        </message>
        <message>
            <source>ESI Timeout/SafeopOpTimeout</source>
            <translation>ESI Timeout/SafeopOpTimeout</translation>
        </message>
        <message>
            <source>Back to INIT</source>
            <translation>Zurück nach INIT</translation>
        </message>
        <message>
            <source>ESI Timeout/BackToInitTimeout</source>
            <translation>ESI Timeout/BackToInitTimeout</translation>
        </message>
        <message>
            <source>Back to SAFEOP</source>
            <translation>Zurück nach SAFEOP</translation>
        </message>
        <message>
            <source>ESI Timeout/BackToSafeopTimeout</source>
            <translation>ESI Timeout/BackToSafeopTimeout</translation>
        </message>
        <message>
            <source>any</source>
            <translation>beliebig</translation>
        </message>
        <message>
            <source>%1, port %2</source>
            <translation>%1, Port %2</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>%1 + error</source>
            <translation>%1 + Fehler</translation>
        </message>
        <message>
            <source>Place on the Bus</source>
            <translation>Platz am Bus</translation>
        </message>
        <message>
            <source>In front</source>
            <translation>Davor</translation>
        </message>
        <message>
            <source>Slave and port in front of this one</source>
            <translation>Slave und Port vor diesem</translation>
        </message>
</context>
<context>
    <name>Sm2Panel</name>
        <message>
            <source>SM2 events missed</source>
            <translation>Verpasste SM2-Ereignisse</translation>
        </message>
        <message>
            <source>Events</source>
            <translation>Ereignisse</translation>
        </message>
        <message>
            <source>SM event missed counter, object 0x1C32:0B or 0x1C32:0C of the slaves that have one.</source>
            <translation>Zähler verpasster SM-Ereignisse, Objekt 0x1C32:0B oder 0x1C32:0C der Slaves, die einen haben.</translation>
        </message>
        <message>
            <source>no slave has this counter</source>
            <translation>kein Slave hat diesen Zähler</translation>
        </message>
        <message>
            <source>%1: %2/s</source>
            <translation>%1: %2/s</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>keine Ablesung</translation>
        </message>
</context>
<context>
    <name>StatusPanel</name>
        <message>
            <source>Connection</source>
            <translation>Verbindung</translation>
        </message>
        <message>
            <source>Whether the master runs, and the link carries frames</source>
            <translation>Ob der Master läuft und der Link Frames überträgt</translation>
        </message>
        <message>
            <source>Link</source>
            <translation>Link</translation>
        </message>
        <message>
            <source>What the bus is connected through</source>
            <translation>Worüber der Bus verbunden ist</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Slaves in the master's state, of all configured</source>
            <translation>Slaves im Zustand des Masters, von allen konfigurierten</translation>
        </message>
        <message>
            <source>Slaves in sync</source>
            <translation>Slaves synchron</translation>
        </message>
        <message>
            <source>Sync window of register 0x092C over all slaves that follow the reference clock</source>
            <translation>Sync-Fenster von Register 0x092C über alle Slaves, die der Referenzuhr folgen</translation>
        </message>
        <message>
            <source>Master in sync</source>
            <translation>Master synchron</translation>
        </message>
        <message>
            <source>Master synchronisation: error against its limit, late frames, cycles left out</source>
            <translation>Master-Synchronisation: Fehler gegen seine Grenze, verspätete Frames, ausgelassene Zyklen</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>Drift</translation>
        </message>
        <message>
            <source>Reference clock's rate against the host's</source>
            <translation>Gang der Referenzuhr gegen den des Rechners</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>Zykluszeit</translation>
        </message>
        <message>
            <source>Bus cycle</source>
            <translation>Buszyklus</translation>
        </message>
        <message>
            <source>Lost frames, late frames, cycles left out</source>
            <translation>Verlorene Frames, verspätete Frames, ausgelassene Zyklen</translation>
        </message>
        <message>
            <source>Frames that did not come back, or came after their cycle; cycles that the host came too late for; samples the display could not take</source>
            <translation>Frames, die nicht oder nach ihrem Zyklus zurückkamen; Zyklen, für die der Host zu spät kam; Messwerte, die die Anzeige nicht aufnehmen konnte</translation>
        </message>
        <message>
            <source>No link chosen</source>
            <translation>Kein Link gewählt</translation>
        </message>
        <message>
            <source>A link is chosen when scanning or going online</source>
            <translation>Ein Link wird beim Scannen oder Onlinegehen gewählt</translation>
        </message>
        <message>
            <source>Slaves %1/%2 %3</source>
            <translation>Slaves %1/%2 %3</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n Slave</numerusform>
                <numerusform>%n Slaves</numerusform>
            </translation>
        </message>
        <message>
            <source>DC: %1</source>
            <translation>DC: %1</translation>
        </message>
        <message>
            <source>DCM: %1</source>
            <translation>DCM: %1</translation>
        </message>
        <message>
            <source>Drift %1</source>
            <translation>Drift %1</translation>
        </message>
        <message>
            <source>Cycle %1</source>
            <translation>Zyklus %1</translation>
        </message>
        <message>
            <source>Lost %1  Late %2  Left out %3</source>
            <translation>Verloren %1  Spät %2  Ausgelassen %3</translation>
        </message>
        <message>
            <source>  Dropped %1</source>
            <translation>  Verworfen %1</translation>
        </message>
        <message>
            <source>Recording</source>
            <translation>Aufzeichnung</translation>
        </message>
        <message>
            <source>Recording %1</source>
            <translation>Aufzeichnung %1</translation>
        </message>
        <message>
            <source>%1
%2 written, %3 left on the disk</source>
            <translation>%1
%2 geschrieben, %3 frei auf dem Datenträger</translation>
        </message>
        <message>
            <source>
%1 cycles are missing in it: the disk was too slow</source>
            <translation>
%1 Zyklen fehlen darin: Der Datenträger war zu langsam</translation>
        </message>
        <message numerus="yes">
            <source>%n bit(s) forced</source>
            <translation>
                <numerusform>%n Bit erzwungen</numerusform>
                <numerusform>%n Bits erzwungen</numerusform>
            </translation>
        </message>
        <message>
            <source>Forced outputs</source>
            <translation>Erzwungene Ausgänge</translation>
        </message>
        <message>
            <source>Outputs that somebody holds at a value by hand: the page Variables releases them</source>
            <translation>Ausgänge, die jemand von Hand auf einem Wert hält: Die Seite Variablen gibt sie frei</translation>
        </message>
        <message numerus="yes">
            <source>%n other network(s) online</source>
            <translation>
                <numerusform>%n weiteres Netzwerk online</numerusform>
                <numerusform>%n weitere Netzwerke online</numerusform>
            </translation>
        </message>
        <message>
            <source>Networks that run beside the one in work:</source>
            <translation>Netzwerke, die neben dem bearbeiteten laufen:</translation>
        </message>
        <message>
            <source>Other networks</source>
            <translation>Andere Netzwerke</translation>
        </message>
        <message>
            <source>Black box</source>
            <translation>Blackbox</translation>
        </message>
        <message>
            <source>Black box ended</source>
            <translation>Blackbox beendet</translation>
        </message>
        <message>
            <source>Black box %1</source>
            <translation>Blackbox %1</translation>
        </message>
        <message>
            <source>Slaves %1</source>
            <translation>Slaves %1</translation>
        </message>
</context>
<context>
    <name>Sync</name>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>DC off</source>
            <translation>DC aus</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message numerus="yes">
            <source>%n of %1 do(es) not answer</source>
            <translation><numerusform>%n von %1 antwortet nicht</numerusform><numerusform>%n von %1 antworten nicht</numerusform></translation>
        </message>
</context>
<context>
    <name>SyncSettingsEditor</name>
        <message>
            <source>Device family</source>
            <translation>Gerätefamilie</translation>
        </message>
        <message>
            <source>Whose limits are known beyond the ESI (docs/device-families.md)</source>
            <translation>Deren Grenzen über die ESI hinaus bekannt sind (docs/device-families.md)</translation>
        </message>
        <message>
            <source>SYNC0 cycles</source>
            <translation>SYNC0-Zyklen</translation>
        </message>
        <message>
            <source>What the device takes; others are refused at SAFEOP</source>
            <translation>Was das Gerät annimmt; andere lehnt es bei SAFEOP ab</translation>
        </message>
        <message>
            <source>multiples of %1</source>
            <translation>Vielfache von %1</translation>
        </message>
        <message>
            <source>from %1</source>
            <translation>ab %1</translation>
        </message>
        <message>
            <source>to %1</source>
            <translation>bis %1</translation>
        </message>
        <message>
            <source>As device (%1)</source>
            <translation>Wie das Gerät (%1)</translation>
        </message>
        <message>
            <source>As device</source>
            <translation>Wie das Gerät</translation>
        </message>
        <message>
            <source>0 (never gives up)</source>
            <translation>0 (gibt nie auf)</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message numerus="yes">
            <source>%1 (%n miss(es) in a row)</source>
            <translation>
                <numerusform>%1 (%n verpasstes in Folge)</numerusform>
                <numerusform>%1 (%n verpasste in Folge)</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>SyncUnitEditor</name>
        <message>
            <source>Sync Unit Cycle of %1</source>
            <translation>Sync Unit Cycle von %1</translation>
        </message>
        <message>
            <source>Sync Unit Cycle</source>
            <translation>Sync Unit Cycle</translation>
        </message>
        <message>
            <source>Cycle of %1</source>
            <translation>Zyklus von %1</translation>
        </message>
        <message>
            <source>Shift of %1</source>
            <translation>Verschiebung von %1</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>Verschiebung</translation>
        </message>
        <message>
            <source>As operation mode (%1)</source>
            <translation>Wie Betriebsart (%1)</translation>
        </message>
        <message>
            <source>User defined</source>
            <translation>Benutzerdefiniert</translation>
        </message>
        <message>
            <source>Factor %1</source>
            <translation>Faktor %1</translation>
        </message>
        <message>
            <source>Off in this operation mode</source>
            <translation>Aus in dieser Betriebsart</translation>
        </message>
        <message>
            <source>Change Sync Unit Cycle of SYNC%1</source>
            <translation>Sync Unit Cycle von SYNC%1 ändern</translation>
        </message>
        <message>
            <source>Choose "User defined" above to set it.</source>
            <translation>Wählen Sie oben „Benutzerdefiniert“, um ihn zu setzen.</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
</context>
<context>
    <name>TracePanel</name>
        <message>
            <source>project ±%1</source>
            <translation>Projekt ±%1</translation>
        </message>
        <message>
            <source>Signal</source>
            <translation>Signal</translation>
        </message>
        <message>
            <source>At A</source>
            <translation>Bei A</translation>
        </message>
        <message>
            <source>At B</source>
            <translation>Bei B</translation>
        </message>
        <message>
            <source>B−A</source>
            <translation>B−A</translation>
        </message>
        <message>
            <source>Smallest</source>
            <translation>Kleinster</translation>
        </message>
        <message>
            <source>Largest</source>
            <translation>Größter</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Werte</translation>
        </message>
        <message>
            <source>Legend: %1</source>
            <translation>Legende: %1</translation>
        </message>
        <message>
            <source>Figures: %1</source>
            <translation>Zahlen: %1</translation>
        </message>
        <message>
            <source>no samples at A or B</source>
            <translation>keine Werte bei A oder B</translation>
        </message>
        <message>
            <source>B−A %1</source>
            <translation>B−A %1</translation>
        </message>
        <message>
            <source>   min %1   max %2   mean %3</source>
            <translation>   Min %1   Max %2   Mittel %3</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>%1: %2   %3: %4</source>
            <translation>%1: %2   %3: %4</translation>
        </message>
        <message>
            <source>the limit of %1 is exceeded</source>
            <translation>die Grenze von %1 ist überschritten</translation>
        </message>
        <message>
            <source>the limit of %1 is kept</source>
            <translation>die Grenze von %1 ist eingehalten</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Einheit</translation>
        </message>
        <message>
            <source>p99.9</source>
            <translation>p99,9</translation>
        </message>
        <message>
            <source>   p99.9 %1</source>
            <translation>   p99,9 %1</translation>
        </message>
</context>
<context>
    <name>TracePlot</name>
        <message>
            <source>Time since start − %1 s</source>
            <translation>Zeit seit Beginn − %1 s</translation>
        </message>
        <message>
            <source>project ±%1</source>
            <translation>Projekt ±%1</translation>
        </message>
        <message>
            <source>%1 (not linked)</source>
            <translation>%1 (nicht verbunden)</translation>
        </message>
        <message>
            <source>UTC, %1</source>
            <translation>UTC, %1</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>System time: not known</source>
            <translation>Systemzeit: nicht bekannt</translation>
        </message>
        <message>
            <source>System time − %1 s / s</source>
            <translation>Systemzeit − %1 s / s</translation>
        </message>
        <message>
            <source>Time before now</source>
            <translation>Zeit vor jetzt</translation>
        </message>
        <message>
            <source>Time before the end</source>
            <translation>Zeit vor dem Ende</translation>
        </message>
        <message>
            <source>Time since start</source>
            <translation>Zeit seit Beginn</translation>
        </message>
</context>
<context>
    <name>Units</name>
        <message numerus="yes">
            <source>%n Byte(s)</source>
            <translation>
                <numerusform>%n Byte</numerusform>
                <numerusform>%n Byte</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n Bit(s)</source>
            <translation>
                <numerusform>%n Bit</numerusform>
                <numerusform>%n Bit</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>VariablePanel</name>
        <message>
            <source>Variables</source>
            <translation>Variablen</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Variables of the process image in each cycle, as they are watched on the page Variables. Where a value did not come back there is a gap.</source>
            <translation>Variablen des Prozessabbilds in jedem Zyklus, wie sie auf der Seite Variablen beobachtet werden. Wo ein Wert nicht zurückkam, ist eine Lücke.</translation>
        </message>
        <message>
            <source>not known in the range shown</source>
            <translation>im gezeigten Bereich nicht bekannt</translation>
        </message>
        <message>
            <source>min %1   max %2</source>
            <translation>min %1   max %2</translation>
        </message>
</context>
<context>
    <name>VariablesRow</name>
        <message>
            <source>Watched variables</source>
            <translation>Beobachtete Variablen</translation>
        </message>
        <message>
            <source>Variables</source>
            <translation>Variablen</translation>
        </message>
        <message>
            <source>Switches</source>
            <translation>Schalter</translation>
        </message>
</context>
<context>
    <name>WelcomePage</name>
        <message>
            <source>Welcome</source>
            <translation>Willkommen</translation>
        </message>
        <message>
            <source>Configure a machine, run it, and see it in sync</source>
            <translation>Eine Maschine konfigurieren, betreiben und synchron sehen</translation>
        </message>
        <message>
            <source>Open %1</source>
            <translation>%1 öffnen</translation>
        </message>
        <message>
            <source>Pin %1</source>
            <translation>%1 anheften</translation>
        </message>
        <message>
            <source>Stays in the list</source>
            <translation>Bleibt in der Liste</translation>
        </message>
        <message>
            <source>Keep it in the list</source>
            <translation>In der Liste behalten</translation>
        </message>
        <message>
            <source>Begin with the simulated demonstration machine, a bus, devices of the catalogue, or a project file.</source>
            <translation>Mit der simulierten Vorführmaschine, einem Bus, Geräten des Katalogs oder einer Projektdatei beginnen.</translation>
        </message>
        <message>
            <source>New from a template of yours</source>
            <translation>Neu aus einer eigenen Vorlage</translation>
        </message>
        <message numerus="yes">
            <source>%n more in New Machine</source>
            <translation>
                <numerusform>%n weitere in „Neue Maschine“</numerusform>
                <numerusform>%n weitere in „Neue Maschine“</numerusform>
            </translation>
        </message>
        <message>
            <source>New from the template %1</source>
            <translation>Neu aus der Vorlage %1</translation>
        </message>
        <message>
            <source>Remove the template %1</source>
            <translation>Die Vorlage %1 entfernen</translation>
        </message>
        <message>
            <source>Remove this template</source>
            <translation>Diese Vorlage entfernen</translation>
        </message>
</context>
<context>
    <name>Workspace</name>
        <message>
            <source>ENI</source>
            <translation>ENI</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Notiz</translation>
        </message>
        <message>
            <source>The machine is running: go offline to change its slaves.</source>
            <translation>Die Maschine läuft: offline gehen, um ihre Slaves zu ändern.</translation>
        </message>
        <message>
            <source>A recording is shown: close it to change the slaves of the project (File, Close Recording).</source>
            <translation>Eine Aufzeichnung wird gezeigt: Schließen Sie sie, um die Slaves des Projekts zu ändern (Datei, Aufzeichnung schließen).</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Scannen</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>Konfiguration</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>%n Slave auf %1 gefunden</numerusform>
                <numerusform>%n Slaves auf %1 gefunden</numerusform>
            </translation>
        </message>
        <message>
            <source>Unsaved work is not kept</source>
            <translation>Ungesicherte Arbeit wird nicht aufbewahrt</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Monitor</source>
            <translation>Monitor</translation>
        </message>
        <message>
            <source>Replay</source>
            <translation>Wiedergabe</translation>
        </message>
        <message>
            <source>Controller log</source>
            <translation>Reglerprotokoll</translation>
        </message>
        <message>
            <source>Written to %1</source>
            <translation>Wird geschrieben nach %1</translation>
        </message>
        <message>
            <source>Lies in %1</source>
            <translation>Liegt in %1</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>Master</translation>
        </message>
        <message>
            <source>The master gives no sign of life: its thread hangs, or the adapter's driver does. What the slaves do now is not known, and no values are shown until it answers again. Go offline (Shift+F5); where it does not answer then either, restart the program.</source>
            <translation>Der Master gibt kein Lebenszeichen: Sein Thread hängt, oder der Treiber der Netzwerkkarte. Was die Slaves jetzt tun, ist nicht bekannt, und bis er wieder antwortet, werden keine Werte gezeigt. Gehen Sie offline (Umschalt+F5); antwortet er auch dann nicht, starten Sie das Programm neu.</translation>
        </message>
        <message>
            <source>The master answers again.</source>
            <translation>Der Master antwortet wieder.</translation>
        </message>
        <message>
            <source>The master did not go offline in time and is left to itself: the slaves may still be in OP, and it may still send. Make the machine safe by other means, and restart the program before you go online again.</source>
            <translation>Der Master ist nicht rechtzeitig offline gegangen und bleibt sich selbst überlassen: Die Slaves sind womöglich noch in OP, und er sendet womöglich noch. Bringen Sie die Maschine auf anderem Weg in einen sicheren Zustand, und starten Sie das Programm neu, bevor Sie wieder online gehen.</translation>
        </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Slaves %1</source>
        <translation>Slaves %1</translation>
    </message>
    <message>
        <source>each of slaves %1</source>
        <translation>jeweils Slave %1</translation>
    </message>
    <message>
        <source> to </source>
        <translation> bis </translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 Mal</translation>
    </message>
    <message>
        <source>the host</source>
        <translation>dem Rechner</translation>
    </message>
    <message>
        <source>nobody in the configuration</source>
        <translation>niemandem in der Konfiguration</translation>
    </message>
    <message>
        <source>slaves %1 to %2</source>
        <translation>Slaves %1 bis %2</translation>
    </message>
    <message>
        <source>slave %1</source>
        <translation>Slave %1</translation>
    </message>
</context>
<context>
    <name>FindingTable</name>
        <message>
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Warnung</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Hinweis</translation>
        </message>
        <message>
            <source>Severity</source>
            <translation>Schwere</translation>
        </message>
</context>
<context>
    <name>FindingModel</name>
        <message>
            <source>Where</source>
            <translation>Wo</translation>
        </message>
        <message>
            <source>Finding</source>
            <translation>Befund</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>Was zu tun ist</translation>
        </message>
</context>
<context>
    <name>FindingsPanel</name>
        <message>
            <source>A moment of a recording is shown. Findings are of the whole run: they stand at its end.</source>
            <translation>Ein Zeitpunkt einer Aufzeichnung wird gezeigt. Befunde gelten dem ganzen Lauf: Sie stehen an dessen Ende.</translation>
        </message>
        <message>
            <source>Findings about the project and the running bus</source>
            <translation>Befunde zum Projekt und zum laufenden Bus</translation>
        </message>
        <message>
            <source>Nothing found. What is wrong with the project, and what the running bus shows to be wrong, stands here with its cause and what to do.</source>
            <translation>Kein Befund. Was am Projekt falsch ist und was der laufende Bus an Fehlern zeigt, steht hier mit Ursache und Abhilfe.</translation>
        </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>Not in the ENI: %1</source>
        <translation>Nicht in der ENI: %1</translation>
    </message>
    <message>
        <source>Not in the ENI</source>
        <translation>Nicht in der ENI</translation>
    </message>
    <message>
        <source>decided by the master that runs the bus</source>
        <translation>entscheidet der Master, der den Bus betreibt</translation>
    </message>
    <message>
        <source>done by the master as it sets up the clocks</source>
        <translation>macht der Master, wenn er die Uhren einrichtet</translation>
    </message>
    <message>
        <source>of the controller in the master that runs the bus</source>
        <translation>gehört dem Regler im Master, der den Bus betreibt</translation>
    </message>
    <message>
        <source>judged by the master that runs the bus</source>
        <translation>beurteilt der Master, der den Bus betreibt</translation>
    </message>
    <message>
        <source>told by the master that runs the bus</source>
        <translation>meldet der Master, der den Bus betreibt</translation>
    </message>
    <message>
        <source>of the host that the master runs on</source>
        <translation>gehört dem Rechner, auf dem der Master läuft</translation>
    </message>
    <message>
        <source>kept in the project alone</source>
        <translation>steht nur im Projekt</translation>
    </message>
    <message>
        <source>VoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>VoE-Nachricht, die bei diesen Übergängen gesendet wird, K zählt ab 0; die Nummer hinter der letzten fügt eine an.</translation>
    </message>
    <message>
        <source>VoE start-up message</source>
        <translation>VoE-Startnachricht</translation>
    </message>
    <message>
        <source>FoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>FoE-Nachricht, die bei diesen Übergängen gesendet wird, K zählt ab 0; die Nummer hinter der letzten fügt eine an.</translation>
    </message>
    <message>
        <source>FoE start-up message</source>
        <translation>FoE-Startnachricht</translation>
    </message>
    <message>
        <source>EoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>EoE-Nachricht, die bei diesen Übergängen gesendet wird, K zählt ab 0; die Nummer hinter der letzten fügt eine an.</translation>
    </message>
    <message>
        <source>EoE start-up message</source>
        <translation>EoE-Startnachricht</translation>
    </message>
    <message>
        <source>AoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>AoE-Nachricht, die bei diesen Übergängen gesendet wird, K zählt ab 0; die Nummer hinter der letzten fügt eine an.</translation>
    </message>
    <message>
        <source>AoE start-up message</source>
        <translation>AoE-Startnachricht</translation>
    </message>
    <message>
        <source>TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [# comment]; nothing removes it</source>
        <translation>TRANSITIONS write REGISTER=HEX oder read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [# Kommentar]; nichts entfernt es</translation>
    </message>
    <message>
        <source>TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [after] [# comment]; nothing removes it</source>
        <translation>TRANSITIONS write REGISTER=HEX oder read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [after] [# Kommentar]; nichts entfernt es</translation>
    </message>
    <message>
        <source>TRANSITIONS data=HEX [fixed] [off] [timeout=MS] [# comment]; nothing removes it</source>
        <translation>TRANSITIONS data=HEX [fixed] [off] [timeout=MS] [# Kommentar]; nichts entfernt es</translation>
    </message>
    <message>
        <source>Added to the SYNC0 shift of slaves that are based on the input reference.</source>
        <translation>Kommt zur SYNC0-Verschiebung der Slaves, die auf die Eingangsreferenz bezogen sind.</translation>
    </message>
    <message>
        <source>The input shift of the master is added to the shift of SYNC0, so that inputs are latched for the next frame; auto as in the ESI.</source>
        <translation>Zur Verschiebung von SYNC0 kommt die Eingangsverschiebung des Masters, sodass Eingänge für den nächsten Frame erfasst werden; auto wie in der ESI.</translation>
    </message>
    <message>
        <source>Input reference</source>
        <translation>Eingangsreferenz</translation>
    </message>
    <message>
        <source>Register of all slaves that is written or read at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>Register aller Slaves, das bei diesen Übergängen geschrieben oder gelesen wird, K zählt ab 0; die Nummer hinter der letzten fügt eines an.</translation>
    </message>
    <message>
        <source>Register command of the master</source>
        <translation>Registerkommando des Masters</translation>
    </message>
    <message>
        <source>Register of the slave that is written or read at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>Register des Slaves, das bei diesen Übergängen geschrieben oder gelesen wird, K zählt ab 0; die Nummer hinter der letzten fügt eines an.</translation>
    </message>
    <message>
        <source>Register command</source>
        <translation>Registerkommando</translation>
    </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>Zykluszeit</translation>
        </message>
        <message>
            <source>Overlap inputs and outputs</source>
            <translation>Eingänge und Ausgänge überlagern</translation>
        </message>
        <message>
            <source>Bring back lost slaves</source>
            <translation>Verlorene Slaves zurückholen</translation>
        </message>
        <message>
            <source>Tries to leave an error state</source>
            <translation>Versuche, einen Fehlerzustand zu verlassen</translation>
        </message>
        <message>
            <source>Start without missing slaves</source>
            <translation>Ohne fehlende Slaves starten</translation>
        </message>
        <message>
            <source>Distributed clocks</source>
            <translation>Distributed Clocks</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>Referenzuhr</translation>
        </message>
        <message>
            <source>Show 64-bit system time</source>
            <translation>64-Bit-Systemzeit zeigen</translation>
        </message>
        <message>
            <source>Master synchronisation</source>
            <translation>Master-Synchronisation</translation>
        </message>
        <message>
            <source>Send to SYNC0</source>
            <translation>Senden bis SYNC0</translation>
        </message>
        <message>
            <source>In-sync limit</source>
            <translation>Synchron-Grenze</translation>
        </message>
        <message>
            <source>Monitor the sync window</source>
            <translation>Sync-Fenster überwachen</translation>
        </message>
        <message>
            <source>Limit 2ⁿ − 1</source>
            <translation>Grenze 2ⁿ − 1</translation>
        </message>
        <message>
            <source>Station address</source>
            <translation>Stationsadresse</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>Alias</translation>
        </message>
        <message>
            <source>Vendor</source>
            <translation>Hersteller</translation>
        </message>
        <message>
            <source>Product code</source>
            <translation>Produktcode</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>Revision</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>Seriennummer</translation>
        </message>
        <message>
            <source>Mode</source>
            <translation>Betriebsart</translation>
        </message>
        <message>
            <source>Potential reference clock</source>
            <translation>Mögliche Referenzuhr</translation>
        </message>
        <message>
            <source>Error limit</source>
            <translation>Fehlergrenze</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Art</translation>
        </message>
        <message>
            <source>Outputs (RxPDO)</source>
            <translation>Ausgänge (RxPDO)</translation>
        </message>
        <message>
            <source>Inputs (TxPDO)</source>
            <translation>Eingänge (TxPDO)</translation>
        </message>
        <message>
            <source>First with DC</source>
            <translation>Erster mit DC</translation>
        </message>
        <message>
            <source>Off (no DC commands)</source>
            <translation>Aus (ohne DC-Kommandos)</translation>
        </message>
        <message>
            <source>As operation mode</source>
            <translation>Wie die Betriebsart</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Aus</translation>
        </message>
        <message>
            <source>Bus shift</source>
            <translation>Bus Shift</translation>
        </message>
        <message>
            <source>Master shift</source>
            <translation>Master Shift</translation>
        </message>
        <message>
            <source>Master reference clock</source>
            <translation>Master-Referenzuhr</translation>
        </message>
        <message>
            <source>Adapter reference clock</source>
            <translation>Adapter-Referenzuhr</translation>
        </message>
        <message>
            <source>External clock (DCX)</source>
            <translation>Externe Uhr (DCX)</translation>
        </message>
        <message>
            <source>Master shift by application</source>
            <translation>Master Shift durch die Anwendung</translation>
        </message>
        <message>
            <source>Free run</source>
            <translation>Freilauf</translation>
        </message>
        <message>
            <source>SM event</source>
            <translation>SM-Ereignis</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message>
            <source>SYNC1</source>
            <translation>SYNC1</translation>
        </message>
        <message>
            <source>Name of the master in the ENI file.</source>
            <translation>Name des Masters in der ENI-Datei.</translation>
        </message>
        <message>
            <source>Time between two cyclic frames.</source>
            <translation>Zeit zwischen zwei zyklischen Frames.</translation>
        </message>
        <message>
            <source>Inputs and outputs of a slave share logical addresses, which halves the cyclic frame.</source>
            <translation>Eingänge und Ausgänge eines Slaves teilen sich logische Adressen, was das zyklische Frame halbiert.</translation>
        </message>
        <message>
            <source>Slaves that come back (cable healed, power back) are set up again and led to the state of the bus.</source>
            <translation>Slaves, die zurückkommen (Kabel heil, Strom wieder da), werden neu eingerichtet und in den Zustand des Busses geführt.</translation>
        </message>
        <message>
            <source>How often an error state is acknowledged and the state requested again; 0 leaves it to the user.</source>
            <translation>Wie oft ein Fehlerzustand quittiert und der Zustand erneut angefordert wird; 0 überlässt es dem Benutzer.</translation>
        </message>
        <message>
            <source>Goes online with the slaves that are there; the others join when they appear.</source>
            <translation>Geht mit den vorhandenen Slaves online; die anderen kommen dazu, wenn sie erscheinen.</translation>
        </message>
        <message>
            <source>Distributed clocks for the whole bus.</source>
            <translation>Distributed Clocks für den ganzen Bus.</translation>
        </message>
        <message>
            <source>Position of the slave whose clock all others follow; auto is the first slave with DC.</source>
            <translation>Position des Slaves, dessen Uhr alle anderen folgen; auto ist der erste Slave mit DC.</translation>
        </message>
        <message>
            <source>Reads and shows 64 bits of the system time (0x0910).</source>
            <translation>Liest und zeigt 64 Bit der Systemzeit (0x0910).</translation>
        </message>
        <message>
            <source>How the send time of the frames and the reference clock are brought together.</source>
            <translation>Wie Sendezeit der Frames und Referenzuhr zusammengebracht werden.</translation>
        </message>
        <message>
            <source>Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle, and later on long buses.</source>
            <translation>Abstand vom Senden des zyklischen Frames bis SYNC0; auto sind zwei Drittel des Zyklus, auf langen Bussen mehr.</translation>
        </message>
        <message>
            <source>Largest control error that still counts as in sync; 0 is 4000 ns.</source>
            <translation>Größter Regelfehler, der noch als synchron gilt; 0 sind 4000 ns.</translation>
        </message>
        <message>
            <source>Time inside that limit before the controller counts as in sync; 0 is 1500 ms.</source>
            <translation>Zeit innerhalb dieser Grenze, bevor der Regler als synchron gilt; 0 sind 1500 ms.</translation>
        </message>
        <message>
            <source>Watches the wire-ored system time difference of all slaves (0x092C).</source>
            <translation>Überwacht die verdrahtet veroderte Systemzeitdifferenz aller Slaves (0x092C).</translation>
        </message>
        <message>
            <source>Limit of the sync window: 2^exponent - 1 ns.</source>
            <translation>Grenze des Sync-Fensters: 2^Exponent - 1 ns.</translation>
        </message>
        <message>
            <source>Time inside the window before the bus counts as in sync.</source>
            <translation>Zeit im Fenster, bevor der Bus als synchron gilt.</translation>
        </message>
        <message>
            <source>Name of the slave in the ENI file.</source>
            <translation>Name des Slaves in der ENI-Datei.</translation>
        </message>
        <message>
            <source>Address that the master gives the slave (0x0010).</source>
            <translation>Adresse, die der Master dem Slave gibt (0x0010).</translation>
        </message>
        <message>
            <source>Address in the slave&apos;s EEPROM (0x0012); 0 is none.</source>
            <translation>Adresse im EEPROM des Slaves (0x0012); 0 ist keine.</translation>
        </message>
        <message>
            <source>Compares the vendor in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>Vergleicht beim Hochlauf den Hersteller im EEPROM des Slaves mit dem eingestellten.</translation>
        </message>
        <message>
            <source>Compares the product in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>Vergleicht beim Hochlauf den Produktcode im EEPROM des Slaves mit dem eingestellten.</translation>
        </message>
        <message>
            <source>Compares the revision in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>Vergleicht beim Hochlauf die Revision im EEPROM des Slaves mit der eingestellten.</translation>
        </message>
        <message>
            <source>Compares the serial in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>Vergleicht beim Hochlauf die Seriennummer im EEPROM des Slaves mit der eingestellten.</translation>
        </message>
        <message>
            <source>Operation mode of distributed clocks; where the ESI gives a mode its own PDOs, they are assigned too.</source>
            <translation>Betriebsart der Distributed Clocks; wo die ESI einer Betriebsart eigene PDOs gibt, werden sie auch zugeordnet.</translation>
        </message>
        <message>
            <source>Marks the slave as a possible reference clock in the ENI.</source>
            <translation>Kennzeichnet den Slave in der ENI als mögliche Referenzuhr.</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC0: above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI.</source>
            <translation>Sync Unit Cycle von SYNC0: über 0 vervielfacht, unter 0 teilt den Buszyklus; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Cycle of SYNC0 (0x09A0), before the factor.</source>
            <translation>Zyklus von SYNC0 (0x09A0), vor dem Faktor.</translation>
        </message>
        <message>
            <source>Shift of SYNC0; auto as in the ESI.</source>
            <translation>Verschiebung von SYNC0; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC1: above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI.</source>
            <translation>Sync Unit Cycle von SYNC1: über 0 vervielfacht, unter 0 teilt den Buszyklus; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Cycle of SYNC1 (0x09A4), before the factor.</source>
            <translation>Zyklus von SYNC1 (0x09A4), vor dem Faktor.</translation>
        </message>
        <message>
            <source>Shift of SYNC1; auto as in the ESI.</source>
            <translation>Verschiebung von SYNC1; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Error counter (3 more for a missed SM event, 1 less for a good one) at which the device gives up (0x10F1:02); 0 never, auto leaves the device&apos;s default.</source>
            <translation>Fehlerzähler (3 mehr für ein verpasstes SM-Ereignis, 1 weniger für ein gutes), bei dem das Gerät aufgibt (0x10F1:02); 0 nie, auto lässt die Vorgabe des Geräts.</translation>
        </message>
        <message>
            <source>What starts the device&apos;s cycle (0x1C32:01 and 0x1C33:01); auto as the operation mode says.</source>
            <translation>Was den Zyklus des Geräts auslöst (0x1C32:01 und 0x1C33:01); auto wie die Betriebsart sagt.</translation>
        </message>
        <message>
            <source>RxPDOs (outputs) in the order in which they lie in the process data.</source>
            <translation>RxPDOs (Ausgänge) in der Reihenfolge, in der sie in den Prozessdaten liegen.</translation>
        </message>
        <message>
            <source>TxPDOs (inputs) in the order in which they lie in the process data.</source>
            <translation>TxPDOs (Eingänge) in der Reihenfolge, in der sie in den Prozessdaten liegen.</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>Werte</translation>
        </message>
        <message>
            <source>Default</source>
            <translation>Vorgabe</translation>
        </message>
        <message>
            <source>Emptied field</source>
            <translation>Geleertes Feld</translation>
        </message>
        <message>
            <source>Goes to</source>
            <translation>Geht nach</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>Ändert</translation>
        </message>
        <message>
            <source>Key</source>
            <translation>Schlüssel</translation>
        </message>
        <message>
            <source>Register %1</source>
            <translation>Register %1</translation>
        </message>
        <message>
            <source>Object %1</source>
            <translation>Objekt %1</translation>
        </message>
        <message>
            <source>Destination address</source>
            <translation>Zieladresse</translation>
        </message>
        <message>
            <source>Destination address of the frames; broadcast unless a switch demands another.</source>
            <translation>Zieladresse der Frames; Broadcast, sofern kein Switch eine andere verlangt.</translation>
        </message>
        <message>
            <source>Source address</source>
            <translation>Quelladresse</translation>
        </message>
        <message>
            <source>Source address in the ENI file; zeros leave it to the network card.</source>
            <translation>Quelladresse in der ENI-Datei; Nullen überlassen sie der Netzwerkkarte.</translation>
        </message>
        <message>
            <source>Asking the clock</source>
            <translation>Uhr abfragen</translation>
        </message>
        <message>
            <source>Most of each wait that is spent asking the clock: earlier wake-ups for processor time. Used is what this host needs for 99 of 100 frames to leave at most 5 % of the cycle late, and at most a quarter of the cycle.</source>
            <translation>Höchster Teil jeder Wartezeit, in dem die Uhr abgefragt wird: früheres Aufwachen gegen Prozessorzeit. Benutzt wird, was dieser Rechner braucht, damit 99 von 100 Frames höchstens 5 % des Zyklus zu spät gehen, und höchstens ein Viertel des Zyklus.</translation>
        </message>
        <message>
            <source>Processor</source>
            <translation>Prozessor</translation>
        </message>
        <message>
            <source>Processor that the cyclic thread is bound to; auto leaves it to the system.</source>
            <translation>Prozessor, an den der zyklische Thread gebunden wird; auto überlässt es dem System.</translation>
        </message>
        <message>
            <source>Continuous propagation compensation</source>
            <translation>Laufzeiten ständig nachmessen</translation>
        </message>
        <message>
            <source>Measures the propagation delays again every 30 s and corrects them in small steps.</source>
            <translation>Misst die Laufzeiten alle 30 s neu und korrigiert sie in kleinen Schritten.</translation>
        </message>
        <message>
            <source>Burst, frames</source>
            <translation>Burst, Frames</translation>
        </message>
        <message>
            <source>Frames of the first drift compensation (FRMW or ARMW of 0x0910).</source>
            <translation>Frames des ersten Driftausgleichs (FRMW oder ARMW auf 0x0910).</translation>
        </message>
        <message>
            <source>Burst, frames a cycle</source>
            <translation>Burst, Frames je Zyklus</translation>
        </message>
        <message>
            <source>Frames of that burst in one cycle; where cycles are longer than 1 ms, in a tenth of one or in 1 ms.</source>
            <translation>Frames dieses Bursts in einem Zyklus; bei Zyklen über 1 ms in einem Zehntel davon oder in 1 ms.</translation>
        </message>
        <message>
            <source>Burst ends early</source>
            <translation>Burst endet früher</translation>
        </message>
        <message>
            <source>The burst ends when all slaves have settled.</source>
            <translation>Der Burst endet, sobald alle Slaves eingeschwungen sind.</translation>
        </message>
        <message>
            <source>Lead of the start time</source>
            <translation>Vorlauf der Startzeit</translation>
        </message>
        <message>
            <source>Lead of the SYNC start time (0x0990) on the time of writing it.</source>
            <translation>Vorlauf der SYNC-Startzeit (0x0990) vor dem Zeitpunkt, zu dem sie geschrieben wird.</translation>
        </message>
        <message>
            <source>Grid of the start time</source>
            <translation>Raster der Startzeit</translation>
        </message>
        <message>
            <source>Start times are multiples of this; 0 is the bus cycle.</source>
            <translation>Startzeiten sind Vielfache davon; 0 ist der Buszyklus.</translation>
        </message>
        <message>
            <source>First slave leads</source>
            <translation>Erster Slave führt</translation>
        </message>
        <message>
            <source>The first slave on the bus that has a system time leads, whatever is configured.</source>
            <translation>Der erste Slave am Bus mit einer Systemzeit führt, was auch immer konfiguriert ist.</translation>
        </message>
        <message>
            <source>Synchronise all slaves</source>
            <translation>Alle Slaves synchronisieren</translation>
        </message>
        <message>
            <source>Every slave that has a system time is synchronised, with or without a DC operation mode.</source>
            <translation>Jeder Slave mit einer Systemzeit wird synchronisiert, mit oder ohne DC-Betriebsart.</translation>
        </message>
        <message>
            <source>Delay measurements</source>
            <translation>Laufzeitmessungen</translation>
        </message>
        <message>
            <source>Latches of the receive times (0x0900) whose medians give the propagation delays.</source>
            <translation>Latches der Empfangszeiten (0x0900), deren Mediane die Laufzeiten ergeben.</translation>
        </message>
        <message>
            <source>Delay difference</source>
            <translation>Laufzeitdifferenz</translation>
        </message>
        <message>
            <source>Processing minus forwarding latency of the ESCs (tDiff of their data sheets); auto is 40 ns at ports with a cable and 20 ns at E-bus.</source>
            <translation>Verarbeitungs- minus Weiterleitungszeit der ESCs (tDiff ihrer Datenblätter); auto ist 40 ns an Ports mit Kabel und 20 ns am E-Bus.</translation>
        </message>
        <message>
            <source>Speed counter start</source>
            <translation>Startwert Speed Counter</translation>
        </message>
        <message>
            <source>Start value of the slaves' time control loops (0x0930): small ones follow faster, large ones smoother; auto suits the cycle.</source>
            <translation>Startwert der Zeitregelkreise der Slaves (0x0930): kleine folgen schneller, große ruhiger; auto passt zum Zyklus.</translation>
        </message>
        <message>
            <source>Filter depth, difference</source>
            <translation>Filtertiefe Differenz</translation>
        </message>
        <message>
            <source>Exponent of the average over the time differences (0x0934); auto is 0, and 4 to 6 in front of the reference clock.</source>
            <translation>Exponent des Mittelwerts über die Zeitdifferenzen (0x0934); auto ist 0, vor der Referenzuhr 4 bis 6.</translation>
        </message>
        <message>
            <source>Filter depth, speed counter</source>
            <translation>Filtertiefe Speed Counter</translation>
        </message>
        <message>
            <source>Exponent of the average over the clock period deviation (0x0935); auto is 8.</source>
            <translation>Exponent des Mittelwerts über die Abweichung der Taktperiode (0x0935); auto ist 8.</translation>
        </message>
        <message>
            <source>Tell of the reference clock</source>
            <translation>Referenzuhr melden</translation>
        </message>
        <message>
            <source>Tells presence and loss of the reference clock.</source>
            <translation>Meldet, dass die Referenzuhr da ist oder verloren ging.</translation>
        </message>
        <message>
            <source>Tell of slaves in sync</source>
            <translation>Slaves synchron melden</translation>
        </message>
        <message>
            <source>Tells when the slaves come in sync and fall out of it.</source>
            <translation>Meldet, wann die Slaves synchron werden und wann nicht mehr.</translation>
        </message>
        <message>
            <source>Tell of the clocks' state</source>
            <translation>Zustand der Uhren melden</translation>
        </message>
        <message>
            <source>Tells that the distributed clocks are initialised, or why not.</source>
            <translation>Meldet, dass die Distributed Clocks initialisiert sind, oder warum nicht.</translation>
        </message>
        <message>
            <source>Tell of the master in sync</source>
            <translation>Master synchron melden</translation>
        </message>
        <message>
            <source>Tells when the master comes in sync and falls out of it.</source>
            <translation>Meldet, wann der Master synchron wird und wann nicht mehr.</translation>
        </message>
        <message>
            <source>Gain</source>
            <translation>Verstärkung</translation>
        </message>
        <message>
            <source>Share of the control error that one cycle corrects while in sync (nCtlGain), in thousandths; 0 is 2.</source>
            <translation>Anteil des Regelfehlers, den ein Zyklus im synchronen Zustand korrigiert (nCtlGain), in Tausendsteln; 0 ist 2.</translation>
        </message>
        <message>
            <source>Drift error gain</source>
            <translation>Verstärkung Driftfehler</translation>
        </message>
        <message>
            <source>Multiplies the integral gain (nCtlDriftErrorGain): more follows a changing drift faster and lets more noise through; 0 is 3.</source>
            <translation>Vervielfacht die Integralverstärkung (nCtlDriftErrorGain): mehr folgt einer wechselnden Drift schneller und lässt mehr Rauschen durch; 0 ist 3.</translation>
        </message>
        <message>
            <source>Valid readings</source>
            <translation>Gültige Messwerte</translation>
        </message>
        <message>
            <source>Readings further than this from what is expected are invalid (nMaxValidVal); 0 is 3000 ns.</source>
            <translation>Messwerte, die weiter als dies vom Erwarteten entfernt sind, sind ungültig (nMaxValidVal); 0 ist 3000 ns.</translation>
        </message>
        <message>
            <source>Start delay</source>
            <translation>Startverzögerung</translation>
        </message>
        <message>
            <source>Wait before the control error is judged.</source>
            <translation>Wartezeit, bevor der Regelfehler beurteilt wird.</translation>
        </message>
        <message>
            <source>Control off</source>
            <translation>Regelung aus</translation>
        </message>
        <message>
            <source>Nothing is moved, so that the natural drift and the adjustment that would be made can be read (bCtlOff).</source>
            <translation>Nichts wird bewegt, so dass die natürliche Drift und die Korrektur, die gemacht würde, abzulesen sind (bCtlOff).</translation>
        </message>
        <message>
            <source>Standard loop values</source>
            <translation>Standardwerte der Regelkreise</translation>
        </message>
        <message>
            <source>Leaves the time control loops of the slaves (0x0930, 0x0934) at the values of their reset.</source>
            <translation>Lässt die Zeitregelkreise der Slaves (0x0930, 0x0934) auf den Werten nach dem Reset.</translation>
        </message>
        <message>
            <source>Controller log</source>
            <translation>Protokoll des Reglers</translation>
        </message>
        <message>
            <source>Keeps the log of the controller, one line a cycle (bLogEnabled).</source>
            <translation>Führt das Protokoll des Reglers, eine Zeile je Zyklus (bLogEnabled).</translation>
        </message>
        <message>
            <source>Network</source>
            <translation>Netz</translation>
        </message>
        <message>
            <source>Name of this network, where a machine has several (--network).</source>
            <translation>Name dieses Netzes, wenn eine Maschine mehrere hat (--network).</translation>
        </message>
        <message>
            <source>Logical start address</source>
            <translation>Logische Startadresse</translation>
        </message>
        <message>
            <source>Logical address of the first process data; auto as the dialect's tool.</source>
            <translation>Logische Adresse der ersten Prozessdaten; auto wie das Werkzeug des Dialekts.</translation>
        </message>
        <message>
            <source>Alignment</source>
            <translation>Ausrichtung</translation>
        </message>
        <message>
            <source>The data of each slave begin at a multiple of so many bytes in the process image.</source>
            <translation>Die Daten jedes Slaves beginnen im Prozessabbild an einem Vielfachen von so vielen Bytes.</translation>
        </message>
        <message>
            <source>Bit packing</source>
            <translation>Bitweise packen</translation>
        </message>
        <message>
            <source>Digital terminals are mapped bit by bit and may share bytes; off gives each whole bytes.</source>
            <translation>Digitale Klemmen werden bitweise abgebildet und können sich Bytes teilen; aus gibt jeder ganze Bytes.</translation>
        </message>
        <message>
            <source>Connected to</source>
            <translation>Verbunden mit</translation>
        </message>
        <message>
            <source>Where the slave is plugged in towards the master. One behind it only when that one's cables are swapped.</source>
            <translation>Wo der Slave in Richtung Master steckt. Einer hinter ihm nur, wenn dessen Kabel vertauscht sind.</translation>
        </message>
        <message>
            <source>Hot-connect group</source>
            <translation>Hot-Connect-Gruppe</translation>
        </message>
        <message>
            <source>This slave and those behind it may be absent and be plugged in anywhere, known by this slave's alias.</source>
            <translation>Dieser Slave und die hinter ihm dürfen fehlen und überall gesteckt werden, erkannt am Alias dieses Slaves.</translation>
        </message>
        <message>
            <source>Optional</source>
            <translation>Optional</translation>
        </message>
        <message>
            <source>The slave may be missing; it is known by its device ID or alias, and the others run without it.</source>
            <translation>Der Slave darf fehlen; er wird an seiner Geräte-ID oder am Alias erkannt, und die anderen laufen ohne ihn.</translation>
        </message>
        <message>
            <source>Revision rule</source>
            <translation>Revisionsregel</translation>
        </message>
        <message>
            <source>How check.revision compares (ETG.2000 CheckRevisionNo): LW and HW are the low and high words, G is newer; auto as in the ESI.</source>
            <translation>Wie check.revision vergleicht (ETG.2000 CheckRevisionNo): LW und HW sind unteres und oberes Wort, G ist neuer; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Compares the alias in the slave (0x0012) with the configured one at start-up.</source>
            <translation>Vergleicht beim Hochlauf den Alias im Slave (0x0012) mit dem konfigurierten.</translation>
        </message>
        <message>
            <source>Device ID</source>
            <translation>Geräte-ID</translation>
        </message>
        <message>
            <source>Explicit device ID (switches or display of the device, ETG.1020) that is compared at start-up.</source>
            <translation>Explizite Geräte-ID (Schalter oder Anzeige des Geräts, ETG.1020), die beim Hochlauf verglichen wird.</translation>
        </message>
        <message>
            <source>Watchdog divider</source>
            <translation>Watchdog-Teiler</translation>
        </message>
        <message>
            <source>Watchdog divider (0x0400): unit of the watchdogs is (value + 2) * 40 ns; auto as in the ESI.</source>
            <translation>Watchdog-Teiler (0x0400): Einheit der Watchdogs ist (Wert + 2) * 40 ns; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>PDI watchdog</source>
            <translation>PDI-Watchdog</translation>
        </message>
        <message>
            <source>PDI watchdog (0x0410) in units of the divider; 0 switches it off; auto as in the ESI.</source>
            <translation>PDI-Watchdog (0x0410) in Einheiten des Teilers; 0 schaltet ihn ab; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Process data watchdog</source>
            <translation>Prozessdaten-Watchdog</translation>
        </message>
        <message>
            <source>Process data watchdog (0x0420) in units of the divider; 0 switches it off; auto as in the ESI.</source>
            <translation>Prozessdaten-Watchdog (0x0420) in Einheiten des Teilers; 0 schaltet ihn ab; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Outputs trigger the watchdog</source>
            <translation>Ausgänge lösen Watchdog aus</translation>
        </message>
        <message>
            <source>Outputs trigger the process data watchdog (control byte of their SyncManagers, bit 6); auto as in the ESI.</source>
            <translation>Ausgänge triggern den Prozessdaten-Watchdog (Steuerbyte ihrer SyncManager, Bit 6); auto wie in der ESI.</translation>
        </message>
        <message>
            <source>INIT to PREOP</source>
            <translation>INIT nach PREOP</translation>
        </message>
        <message>
            <source>Time-out for INIT to PREOP or BOOT; auto as in the ESI.</source>
            <translation>Zeitgrenze für INIT nach PREOP oder BOOT; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>PREOP to SAFEOP to OP</source>
            <translation>PREOP nach SAFEOP nach OP</translation>
        </message>
        <message>
            <source>Time-out for PREOP to SAFEOP and SAFEOP to OP; auto as in the ESI.</source>
            <translation>Zeitgrenze für PREOP nach SAFEOP und SAFEOP nach OP; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Back to INIT</source>
            <translation>Zurück nach INIT</translation>
        </message>
        <message>
            <source>Time-out for the way back to INIT; auto as in the ESI.</source>
            <translation>Zeitgrenze für den Weg zurück nach INIT; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Back to SAFEOP</source>
            <translation>Zurück nach SAFEOP</translation>
        </message>
        <message>
            <source>Time-out for OP to SAFEOP; auto as in the ESI.</source>
            <translation>Zeitgrenze für OP nach SAFEOP; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Mailbox request</source>
            <translation>Mailbox-Anfrage</translation>
        </message>
        <message>
            <source>Time-out for the slave to take a mailbox request; auto as in the ESI.</source>
            <translation>Zeit, in der der Slave eine Mailbox-Anfrage annehmen muss; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Mailbox response</source>
            <translation>Mailbox-Antwort</translation>
        </message>
        <message>
            <source>Time-out for the slave to answer a mailbox request; auto as in the ESI.</source>
            <translation>Zeit, in der der Slave eine Mailbox-Anfrage beantworten muss; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Output mailbox</source>
            <translation>Ausgangs-Mailbox</translation>
        </message>
        <message>
            <source>Size of the output mailbox; auto as in the ESI.</source>
            <translation>Größe der Ausgangs-Mailbox; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Input mailbox</source>
            <translation>Eingangs-Mailbox</translation>
        </message>
        <message>
            <source>Size of the input mailbox; auto as in the ESI.</source>
            <translation>Größe der Eingangs-Mailbox; auto wie in der ESI.</translation>
        </message>
        <message>
            <source>Mailbox state by a bit</source>
            <translation>Mailbox-Zustand als Bit</translation>
        </message>
        <message>
            <source>The master learns of mail by a bit in the cyclic frames, where the device has an FMMU for it; off: it polls.</source>
            <translation>Der Master erfährt von Post durch ein Bit in den zyklischen Frames, wenn das Gerät eine FMMU dafür hat; aus: er fragt nach.</translation>
        </message>
        <message>
            <source>Poll time</source>
            <translation>Abfragezeit</translation>
        </message>
        <message>
            <source>How often the mailbox is polled; auto as the dialect's tool.</source>
            <translation>Wie oft die Mailbox abgefragt wird; auto wie das Werkzeug des Dialekts.</translation>
        </message>
        <message>
            <source>Ethernet (EoE)</source>
            <translation>Ethernet (EoE)</translation>
        </message>
        <message>
            <source>Ethernet frames are passed to and from the slave (EoE).</source>
            <translation>Ethernet-Frames werden zum Slave und von ihm weitergereicht (EoE).</translation>
        </message>
        <message>
            <source>Ethernet address</source>
            <translation>Ethernet-Adresse</translation>
        </message>
        <message>
            <source>Ethernet address that the slave gets at start-up (EoE).</source>
            <translation>Ethernet-Adresse, die der Slave beim Hochlauf bekommt (EoE).</translation>
        </message>
        <message>
            <source>IP address</source>
            <translation>IP-Adresse</translation>
        </message>
        <message>
            <source>IP address that the slave gets at start-up (EoE).</source>
            <translation>IP-Adresse, die der Slave beim Hochlauf bekommt (EoE).</translation>
        </message>
        <message>
            <source>Subnet mask</source>
            <translation>Subnetzmaske</translation>
        </message>
        <message>
            <source>Subnet mask that the slave gets at start-up (EoE).</source>
            <translation>Subnetzmaske, die der Slave beim Hochlauf bekommt (EoE).</translation>
        </message>
        <message>
            <source>Default gateway</source>
            <translation>Standard-Gateway</translation>
        </message>
        <message>
            <source>Default gateway that the slave gets at start-up (EoE).</source>
            <translation>Standard-Gateway, das der Slave beim Hochlauf bekommt (EoE).</translation>
        </message>
        <message>
            <source>Name server</source>
            <translation>Namensserver</translation>
        </message>
        <message>
            <source>Name server that the slave gets at start-up (EoE).</source>
            <translation>Namensserver, den der Slave beim Hochlauf bekommt (EoE).</translation>
        </message>
        <message>
            <source>Host name</source>
            <translation>Rechnername</translation>
        </message>
        <message>
            <source>Host name that the slave gets at start-up (EoE).</source>
            <translation>Rechnername, den der Slave beim Hochlauf bekommt (EoE).</translation>
        </message>
        <message>
            <source>AMS Net ID</source>
            <translation>AMS-Net-ID</translation>
        </message>
        <message>
            <source>AMS Net ID of the slave (AoE).</source>
            <translation>AMS-Net-ID des Slaves (AoE).</translation>
        </message>
        <message>
            <source>Sync Unit of the outputs</source>
            <translation>Sync Unit der Ausgänge</translation>
        </message>
        <message>
            <source>Sync Unit that exchanges the outputs; nothing for the unnamed one in the base task.</source>
            <translation>Sync Unit, die die Ausgänge austauscht; nichts für die unbenannte in der Basistask.</translation>
        </message>
        <message>
            <source>Sync Unit of the inputs</source>
            <translation>Sync Unit der Eingänge</translation>
        </message>
        <message>
            <source>Sync Unit that exchanges the inputs; nothing for the unnamed one in the base task.</source>
            <translation>Sync Unit, die die Eingänge austauscht; nichts für die unbenannte in der Basistask.</translation>
        </message>
        <message>
            <source>Input shift</source>
            <translation>Eingangsverschiebung</translation>
        </message>
        <message>
            <source>From the trigger to latching the inputs (0x1C33:03); auto as the operation mode says.</source>
            <translation>Vom Auslöser bis zum Übernehmen der Eingänge (0x1C33:03); auto wie die Betriebsart sagt.</translation>
        </message>
        <message>
            <source>CAN cycle</source>
            <translation>CAN-Zyklus</translation>
        </message>
        <message>
            <source>CAN cycle of a gateway (EL6751 0xF800:04), a multiple of the bus cycle; without SYNC0 the gateway is told the bus cycle, too. 0 is one CAN cycle a bus cycle, auto leaves the device's default.</source>
            <translation>CAN-Zyklus eines Gateways (EL6751 0xF800:04), ein Vielfaches des Buszyklus; ohne SYNC0 wird dem Gateway auch der Buszyklus mitgeteilt. 0 ist ein CAN-Zyklus je Buszyklus, auto lässt die Voreinstellung des Geräts.</translation>
        </message>
        <message>
            <source>TxPDO delay</source>
            <translation>TxPDO-Verzögerung</translation>
        </message>
        <message>
            <source>From the CAN SYNC message of a gateway to its first synchronous RxPDO (EL6751 0xF800:0E), in % of the CAN cycle.</source>
            <translation>Von der CAN-SYNC-Nachricht eines Gateways bis zum ersten synchronen RxPDO (EL6751 0xF800:0E), in % des CAN-Zyklus.</translation>
        </message>
        <message>
            <source>Output pin</source>
            <translation>Ausgangspin</translation>
        </message>
        <message>
            <source>What output pin K (from 1) of a drive shows on an oscilloscope (Copley 0x2193); auto leaves it alone.</source>
            <translation>Was der Ausgangspin K (ab 1) eines Antriebs am Oszilloskop zeigt (Copley 0x2193); auto lässt ihn, wie er ist.</translation>
        </message>
        <message>
            <source>Module</source>
            <translation>Modul</translation>
        </message>
        <message>
            <source>Module in place K of a modular device, counted from 0; its PDOs and start-up commands come with it.</source>
            <translation>Modul auf Platz K eines modularen Geräts, gezählt ab 0; seine PDOs und Startkommandos kommen mit.</translation>
        </message>
        <message>
            <source>Oversampling</source>
            <translation>Oversampling</translation>
        </message>
        <message>
            <source>How many samples of PDO 0xIIII a cycle carries; auto as the operation mode says.</source>
            <translation>Wie viele Abtastwerte des PDO 0xIIII ein Zyklus trägt; auto wie die Betriebsart sagt.</translation>
        </message>
        <message>
            <source>Variable</source>
            <translation>Variable</translation>
        </message>
        <message>
            <source>Name of the variable for entry K of PDO 0xIIII in the process image; nothing for SLAVE.PDO.ENTRY.</source>
            <translation>Name der Variablen für Eintrag K des PDO 0xIIII im Prozessabbild; nichts für SLAVE.PDO.EINTRAG.</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>auto</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>on</source>
            <translation>ein</translation>
        </message>
        <message>
            <source>off</source>
            <translation>aus</translation>
        </message>
        <message>
            <source>None (base task)</source>
            <translation>Keine (Basistask)</translation>
        </message>
        <message>
            <source>Expert setting: few machines need it</source>
            <translation>Experteneinstellung: wenige Maschinen brauchen sie</translation>
        </message>
        <message>
            <source>frames</source>
            <translation>Frames</translation>
        </message>
        <message>
            <source>bytes</source>
            <translation>Byte</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>Task</translation>
        </message>
        <message>
            <source>A task beside the base task, whose frames are sent in every MULTIPLE-th cycle; K counts from 0, the number behind the last adds one.</source>
            <translation>Ein Task neben dem Basis-Task, dessen Frames in jedem MULTIPLE-ten Zyklus gesendet werden; K zählt ab 0, die Nummer hinter dem letzten fügt einen hinzu.</translation>
        </message>
        <message>
            <source>Sync Unit</source>
            <translation>Sync Unit</translation>
        </message>
        <message>
            <source>Slaves that are exchanged together in datagrams of their own, in the base task or in TASK; K counts from 0, the number behind the last adds one.</source>
            <translation>Slaves, die zusammen in eigenen Datagrammen ausgetauscht werden, im Basis-Task oder in TASK; K zählt ab 0, die Nummer hinter der letzten fügt eine hinzu.</translation>
        </message>
        <message>
            <source>Mapping</source>
            <translation>Mapping</translation>
        </message>
        <message>
            <source>What PDO 0xIIII carries. Only PDOs that are not fixed can be changed.</source>
            <translation>Was PDO 0xIIII trägt. Nur PDOs, die nicht fest sind, können geändert werden.</translation>
        </message>
        <message>
            <source>Start-up command</source>
            <translation>Startkommando</translation>
        </message>
        <message>
            <source>CoE object that is written at these transitions, K counts from 0; the number behind the last adds one.</source>
            <translation>CoE-Objekt, das bei diesen Übergängen geschrieben wird, K zählt ab 0; die Nummer hinter dem letzten fügt eines hinzu.</translation>
        </message>
        <message>
            <source>SoE start-up command</source>
            <translation>SoE-Startkommando</translation>
        </message>
        <message>
            <source>IDN that is written at these transitions, K counts from 0; the number behind the last adds one.</source>
            <translation>IDN, die bei diesen Übergängen geschrieben wird, K zählt ab 0; die Nummer hinter der letzten fügt eine hinzu.</translation>
        </message>
        <message>
            <source>1..255 bytes of text</source>
            <translation>1..255 Byte Text</translation>
        </message>
        <message>
            <source>1..32 bytes of text</source>
            <translation>1..32 Byte Text</translation>
        </message>
        <message>
            <source>six hexadecimal bytes with colons</source>
            <translation>sechs hexadezimale Bytes mit Doppelpunkten</translation>
        </message>
        <message>
            <source>four numbers 0..255 with dots</source>
            <translation>vier Zahlen 0..255 mit Punkten</translation>
        </message>
        <message>
            <source>six numbers 0..255 with dots</source>
            <translation>sechs Zahlen 0..255 mit Punkten</translation>
        </message>
        <message>
            <source>name of a master.sync_unit.K</source>
            <translation>Name einer master.sync_unit.K</translation>
        </message>
        <message>
            <source>name of the group</source>
            <translation>Name der Gruppe</translation>
        </message>
        <message>
            <source>POSITION:A..D of another slave</source>
            <translation>POSITION:A..D eines anderen Slaves</translation>
        </message>
        <message>
            <source>NAME xMULTIPLE, 1..1000 bus cycles; nothing removes it</source>
            <translation>NAME xMULTIPLE, 1..1000 Buszyklen; nichts entfernt sie</translation>
        </message>
        <message>
            <source>NAME, NAME@TASK; nothing removes it</source>
            <translation>NAME, NAME@TASK; nichts entfernt sie</translation>
        </message>
        <message>
            <source>TRANSITIONS DRIVE:IDN=HEX [fixed] [off] [timeout=MS] [# comment]; IDN like S-0-0047; nothing removes it</source>
            <translation>TRANSITIONS DRIVE:IDN=HEX [fixed] [off] [timeout=MS] [# Kommentar]; IDN wie S-0-0047; nichts entfernt es</translation>
        </message>
        <message>
            <source>TRANSITIONS INDEX:SUB=HEX [complete] [fixed] [off] [adapt] [timeout=MS] [# comment]; nothing removes it</source>
            <translation>TRANSITIONS INDEX:SUB=HEX [complete] [fixed] [off] [adapt] [timeout=MS] [# Kommentar]; nichts entfernt es</translation>
        </message>
        <message>
            <source>indices of the device with commas, or nothing</source>
            <translation>Indizes des Geräts mit Kommas, oder nichts</translation>
        </message>
        <message>
            <source>INDEX:SUB:BITS with commas; INDEX 0 is padding</source>
            <translation>INDEX:SUB:BITS mit Kommas; INDEX 0 ist Füllung</translation>
        </message>
        <message>
            <source>0..last slave</source>
            <translation>0..letzter Slave</translation>
        </message>
        <message>
            <source>ident of a module that fits place K</source>
            <translation>Kennung eines Moduls, das auf Platz K passt</translation>
        </message>
        <message>
            <source>OSMin..OSMax of the PDO in the ESI</source>
            <translation>OSMin..OSMax des PDO in der ESI</translation>
        </message>
        <message>
            <source>a name of the ESI's OpMode</source>
            <translation>ein Name eines OpMode der ESI</translation>
        </message>
        <message>
            <source>words of the device family: nothing, sync0, frames, servo-period</source>
            <translation>Wörter der Gerätefamilie: nothing, sync0, frames, servo-period</translation>
        </message>
        <message>
            <source>its device's</source>
            <translation>wie sein Gerät</translation>
        </message>
        <message>
            <source>1001 + N</source>
            <translation>1001 + N</translation>
        </message>
        <message>
            <source>the first of the ESI</source>
            <translation>die erste der ESI</translation>
        </message>
        <message>
            <source>those of the ESI</source>
            <translation>die der ESI</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>nichts</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC0</source>
            <translation>Sync Unit Cycle von SYNC0</translation>
        </message>
        <message>
            <source>Cycle of SYNC0</source>
            <translation>Zyklus von SYNC0</translation>
        </message>
        <message>
            <source>Shift of SYNC0</source>
            <translation>Verschiebung von SYNC0</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC1</source>
            <translation>Sync Unit Cycle von SYNC1</translation>
        </message>
        <message>
            <source>Cycle of SYNC1</source>
            <translation>Zyklus von SYNC1</translation>
        </message>
        <message>
            <source>Shift of SYNC1</source>
            <translation>Verschiebung von SYNC1</translation>
        </message>
        <message>
            <source>Settle time of the window</source>
            <translation>Einschwingzeit des Fensters</translation>
        </message>
        <message>
            <source>Settle time of the controller</source>
            <translation>Einschwingzeit des Reglers</translation>
        </message>
</context>
<context>
    <name>FieldBinder</name>
        <message>
            <source>Change: %1</source>
            <translation>Ändern: %1</translation>
        </message>
        <message>
            <source>%1 (Expert)</source>
            <translation>%1 (Experte)</translation>
        </message>
        <message>
            <source>Finding: %1</source>
            <translation>Befund: %1</translation>
        </message>
        <message>
            <source>Reset to &amp;default</source>
            <translation>Auf &amp;Standard zurücksetzen</translation>
        </message>
        <message>
            <source>Reset: %1</source>
            <translation>Zurücksetzen: %1</translation>
        </message>
        <message>
            <source>Show in &amp;ENI</source>
            <translation>In der ENI &amp;zeigen</translation>
        </message>
</context>
<context>
    <name>NumberEdit</name>
        <message>
            <source>&quot;%1&quot; is no such number: %2</source>
            <translation>„%1“ ist keine solche Zahl: %2</translation>
        </message>
</context>
<context>
    <name>PresetEdit</name>
        <message>
            <source>&quot;%1&quot; is no such number: %2 %3</source>
            <translation>„%1“ ist keine solche Zahl: %2 %3</translation>
        </message>
</context>
<context>
    <name>MasterDcExpertPage</name>
        <message>
            <source>Distributed Clocks (Expert)</source>
            <translation>Distributed Clocks (Experte)</translation>
        </message>
        <message>
            <source>Clocks and Delays</source>
            <translation>Uhren und Laufzeiten</translation>
        </message>
        <message>
            <source>Burst and Start Time</source>
            <translation>Burst und Startzeit</translation>
        </message>
        <message>
            <source>Controller (DCM)</source>
            <translation>Regler (DCM)</translation>
        </message>
        <message>
            <source>Control Loops of the Slaves</source>
            <translation>Regelkreise der Slaves</translation>
        </message>
        <message>
            <source>Messages of the Clocks</source>
            <translation>Meldungen der Uhren</translation>
        </message>
</context>
<context>
    <name>SlaveTimingPage</name>
        <message>
            <source>Watchdogs (Expert)</source>
            <translation>Watchdogs (Experte)</translation>
        </message>
        <message>
            <source>Watchdogs</source>
            <translation>Watchdogs</translation>
        </message>
        <message>
            <source>Time-outs of State Changes</source>
            <translation>Zeitgrenzen der Zustandswechsel</translation>
        </message>
</context>
<context>
    <name>SlaveMailboxPage</name>
        <message>
            <source>Mailbox</source>
            <translation>Mailbox</translation>
        </message>
        <message>
            <source>Ethernet (EoE)</source>
            <translation>Ethernet (EoE)</translation>
        </message>
        <message>
            <source>ADS (AoE)</source>
            <translation>ADS (AoE)</translation>
        </message>
</context>
<context>
    <name>SlaveDataPage</name>
        <message>
            <source>Data Options</source>
            <translation>Datenoptionen</translation>
        </message>
        <message>
            <source>Oversampling</source>
            <translation>Oversampling</translation>
        </message>
        <message>
            <source>Sync Units</source>
            <translation>Sync Units</translation>
        </message>
</context>
<context>
    <name>SlaveModulesPage</name>
        <message>
            <source>Modules</source>
            <translation>Module</translation>
        </message>
        <message>
            <source>Modules in Slots</source>
            <translation>Module in Slots</translation>
        </message>
</context>
<context>
    <name>Questions</name>
        <message>
            <source>The machine is running. Take it offline?</source>
            <translation>Die Maschine läuft. Offline nehmen?</translation>
        </message>
        <message>
            <source>All slaves go to INIT.</source>
            <translation>Alle Slaves gehen nach INIT.</translation>
        </message>
        <message>
            <source>Go Offline</source>
            <translation>Offline gehen</translation>
        </message>
        <message>
            <source>Take %1 offline?</source>
            <translation>%1 offline nehmen?</translation>
        </message>
        <message>
            <source>A slave is being written to, which ends unfinished.</source>
            <translation>In einen Slave wird geschrieben, was unfertig endet.</translation>
        </message>
        <message>
            <source>A slave is being written to. Go offline all the same?</source>
            <translation>In einen Slave wird geschrieben. Trotzdem offline gehen?</translation>
        </message>
        <message>
            <source>An EEPROM gets back what it held; a slave that has half of a file may not come up any more.</source>
            <translation>Ein EEPROM bekommt zurück, was es enthielt; ein Slave, der eine halbe Datei hat, kommt vielleicht nicht mehr hoch.</translation>
        </message>
        <message>
            <source>The slaves may still be in OP.</source>
            <translation>Die Slaves sind womöglich noch in OP.</translation>
        </message>
        <message>
            <source>The master did not go offline in time: it ends with the program, and nobody has taken the slaves to INIT. Make the machine safe by other means.</source>
            <translation>Der Master ist nicht rechtzeitig offline gegangen: Er endet mit dem Programm, und niemand hat die Slaves nach INIT gebracht. Bringen Sie die Maschine auf anderem Weg in einen sicheren Zustand.</translation>
        </message>
</context>
<context>
    <name>SlaveStartupPage</name>
    <message>
        <source>Behind the slaves' commands of the transition instead of before them (ENI InitCmd/BeforeSlave)</source>
        <translation>Hinter den Kommandos der Slaves bei diesem Übergang statt davor (ENI InitCmd/BeforeSlave)</translation>
    </message>
    <message>
        <source>After the slaves</source>
        <translation>Nach den Slaves</translation>
    </message>
    <message>
        <source>Bits of the expected value that count, in hexadecimal; empty: all (ENI Validate/DataMask)</source>
        <translation>Bits des erwarteten Werts, die zählen, hexadezimal; leer: alle (ENI Validate/DataMask)</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>What a read has to bring, in hexadecimal; empty: anything (ENI Validate/Data)</source>
        <translation>Was gelesen werden muss, hexadezimal; leer: beliebig (ENI Validate/Data)</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Write: bytes in hexadecimal, in the order of the wire; read: how many bytes (ENI InitCmd/Data)</source>
        <translation>Schreiben: Bytes hexadezimal, in der Reihenfolge der Leitung; Lesen: wie viele Bytes (ENI InitCmd/Data)</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Byte address in the ESC: 0x09A8 (ENI InitCmd/Ado)</source>
        <translation>Byteadresse im ESC: 0x09A8 (ENI InitCmd/Ado)</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Off: the command stays in the project and is not in the ENI</source>
        <translation>Aus: das Kommando bleibt im Projekt und ist nicht in der ENI</translation>
    </message>
    <message>
        <source>Written or read; of a slave by its station address, of the master to all slaves (ENI InitCmd/Cmd)</source>
        <translation>Schreiben oder lesen; bei einem Slave über seine Stationsadresse, beim Master an alle Slaves (ENI InitCmd/Cmd)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>ms for the expected value to come (ENI Validate/Timeout)</source>
        <translation>ms, bis der erwartete Wert da ist (ENI Validate/Timeout)</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Binnen</translation>
    </message>
    <message>
        <source>a write has at least one byte</source>
        <translation>geschrieben wird mindestens ein Byte</translation>
    </message>
    <message>
        <source>a read takes 1 to %1 bytes</source>
        <translation>gelesen werden 1 bis %1 Bytes</translation>
    </message>
    <message>
        <source>"%1" is no register like 0x09A8</source>
        <translation>„%1“ ist kein Register wie 0x09A8</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Nachricht</translation>
    </message>
    <message>
        <source>What follows the mailbox header, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>Was auf den Mailbox-Kopf folgt, hexadezimal, in der Reihenfolge der Leitung (ENI InitCmd/Data)</translation>
    </message>
    <message>
        <source>FoE request, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>FoE-Anfrage, hexadezimal, in der Reihenfolge der Leitung (ENI InitCmd/Data)</translation>
    </message>
    <message>
        <source>EoE header and data, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>EoE-Kopf und Daten, hexadezimal, in der Reihenfolge der Leitung (ENI InitCmd/Data)</translation>
    </message>
    <message>
        <source>AoE header and data, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>AoE-Kopf und Daten, hexadezimal, in der Reihenfolge der Leitung (ENI InitCmd/Data)</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigenes</translation>
    </message>
    <message>
        <source>ESI</source>
        <translation>ESI</translation>
    </message>
    <message>
        <source>ESI: as the device's description has it; own: added or changed here</source>
        <translation>ESI: wie die Gerätebeschreibung es hat; eigenes: hier hinzugefügt oder geändert</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>start-up message</source>
        <translation>Startnachricht</translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation>Nachrichten (%1)</translation>
    </message>
        <message>
            <source>INIT to PREOP</source>
            <translation>INIT nach PREOP</translation>
        </message>
        <message>
            <source>PREOP to SAFEOP</source>
            <translation>PREOP nach SAFEOP</translation>
        </message>
        <message>
            <source>SAFEOP to OP</source>
            <translation>SAFEOP nach OP</translation>
        </message>
        <message>
            <source>INIT to BOOT</source>
            <translation>INIT nach BOOT</translation>
        </message>
        <message>
            <source>PREOP again</source>
            <translation>PREOP noch einmal</translation>
        </message>
        <message>
            <source>OP to SAFEOP</source>
            <translation>OP nach SAFEOP</translation>
        </message>
        <message>
            <source>OP to PREOP</source>
            <translation>OP nach PREOP</translation>
        </message>
        <message>
            <source>SAFEOP to PREOP</source>
            <translation>SAFEOP nach PREOP</translation>
        </message>
        <message>
            <source>SAFEOP to INIT</source>
            <translation>SAFEOP nach INIT</translation>
        </message>
        <message>
            <source>PREOP to INIT</source>
            <translation>PREOP nach INIT</translation>
        </message>
        <message>
            <source>Transitions</source>
            <translation>Übergänge</translation>
        </message>
        <message>
            <source>State changes at which the command is sent (ENI InitCmd/Transition)</source>
            <translation>Zustandswechsel, bei denen das Kommando gesendet wird (ENI InitCmd/Transition)</translation>
        </message>
        <message>
            <source>Time-out</source>
            <translation>Zeitlimit</translation>
        </message>
        <message>
            <source>ms for the answer; empty: the master&apos;s own (ENI InitCmd/Timeout)</source>
            <translation>ms für die Antwort; leer: das des Masters (ENI InitCmd/Timeout)</translation>
        </message>
        <message>
            <source>a time-out is a whole number of ms</source>
            <translation>ein Zeitlimit ist eine ganze Zahl von ms</translation>
        </message>
        <message>
            <source>Comment</source>
            <translation>Kommentar</translation>
        </message>
        <message>
            <source>Beside the command in the ENI (InitCmd/Comment)</source>
            <translation>Steht in der ENI beim Kommando (InitCmd/Comment)</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is no object like 0x6060:00</source>
            <translation>„%1“ ist kein Objekt wie 0x6060:00</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Decimal, or hexadecimal with 0x; bytes in the order of the wire (ENI InitCmd/Data)</source>
            <translation>Dezimal, oder hexadezimal mit 0x; Bytes in der Reihenfolge der Leitung (ENI InitCmd/Data)</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is no IDN like S-0-0047</source>
            <translation>„%1“ ist keine IDN wie S-0-0047</translation>
        </message>
        <message>
            <source>drives count from 0 to 7</source>
            <translation>Antriebe zählen von 0 bis 7</translation>
        </message>
        <message>
            <source>Enabled</source>
            <translation>Aktiv</translation>
        </message>
        <message>
            <source>Off: the command is kept, but not sent</source>
            <translation>Aus: das Kommando bleibt erhalten, wird aber nicht gesendet</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>Index and sub-index, hexadecimal: 0x6060:00 (ENI InitCmd/Index and SubIndex)</source>
            <translation>Index und Subindex, hexadezimal: 0x6060:00 (ENI InitCmd/Index und SubIndex)</translation>
        </message>
        <message>
            <source>Complete access</source>
            <translation>Complete Access</translation>
        </message>
        <message>
            <source>The value is the whole object, from sub-index 0 or 1 on (ENI InitCmd@CompleteAccess)</source>
            <translation>Der Wert ist das ganze Objekt, ab Subindex 0 oder 1 (ENI InitCmd@CompleteAccess)</translation>
        </message>
        <message>
            <source>Fixed</source>
            <translation>Fest</translation>
        </message>
        <message>
            <source>The device needs the command as it is (ENI InitCmd@Fixed)</source>
            <translation>Das Gerät braucht das Kommando so, wie es ist (ENI InitCmd@Fixed)</translation>
        </message>
        <message>
            <source>Adapt automatically</source>
            <translation>Automatisch anpassen</translation>
        </message>
        <message>
            <source>The value follows another setting, such as the cycle time (ESI InitCmd@AdaptAutomatically)</source>
            <translation>Der Wert folgt einer anderen Einstellung, etwa der Zykluszeit (ESI InitCmd@AdaptAutomatically)</translation>
        </message>
        <message>
            <source>Drive</source>
            <translation>Antrieb</translation>
        </message>
        <message>
            <source>Drive of the device, 0 to 7 (ENI InitCmd/DriveNo)</source>
            <translation>Antrieb des Geräts, 0 bis 7 (ENI InitCmd/DriveNo)</translation>
        </message>
        <message>
            <source>IDN</source>
            <translation>IDN</translation>
        </message>
        <message>
            <source>Standard or product parameter: S-0-0047, P-0-0100 (ENI InitCmd/IDN)</source>
            <translation>Standard- oder Produktparameter: S-0-0047, P-0-0100 (ENI InitCmd/IDN)</translation>
        </message>
        <message>
            <source>Bytes in hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
            <translation>Bytes hexadezimal, in der Reihenfolge der Leitung (ENI InitCmd/Data)</translation>
        </message>
        <message>
            <source>Start-up</source>
            <translation>Start</translation>
        </message>
        <message>
            <source>start-up command</source>
            <translation>Startkommando</translation>
        </message>
        <message>
            <source>SoE start-up command</source>
            <translation>SoE-Startkommando</translation>
        </message>
        <message>
            <source>Objects (CoE)</source>
            <translation>Objekte (CoE)</translation>
        </message>
        <message>
            <source>Parameters (SoE)</source>
            <translation>Parameter (SoE)</translation>
        </message>
        <message>
            <source>Data type</source>
            <translation>Datentyp</translation>
        </message>
        <message>
            <source>As what the value is written; the command holds its bytes</source>
            <translation>Als was der Wert geschrieben wird; das Kommando hält seine Bytes</translation>
        </message>
        <message>
            <source>Choose Object…</source>
            <translation>Objekt wählen …</translation>
        </message>
        <message>
            <source>Choose an object of the device</source>
            <translation>Ein Objekt des Geräts wählen</translation>
        </message>
        <message>
            <source>As described (%1)</source>
            <translation>Wie beschrieben (%1)</translation>
        </message>
        <message>
            <source>None: the slave starts with what it has.</source>
            <translation>Keine: der Slave startet mit dem, was er hat.</translation>
        </message>
        <message>
            <source>What is sent otherwise than listed</source>
            <translation>Was anders gesendet wird als aufgeführt</translation>
        </message>
        <message>
            <source>Sent for a bus cycle of %1, otherwise than listed: %2.</source>
            <translation>Für einen Buszyklus von %1 wird anders gesendet als aufgeführt: %2.</translation>
        </message>
</context>
<context>
    <name>FoundDialog</name>
        <message numerus="yes">
            <source>%n match(es)</source>
            <translation>
                <numerusform>%n stimmt überein</numerusform>
                <numerusform>%n stimmen überein</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n additional</source>
            <translation>
                <numerusform>%n zusätzlich</numerusform>
                <numerusform>%n zusätzlich</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n missing</source>
            <translation>
                <numerusform>%n fehlt</numerusform>
                <numerusform>%n fehlen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n moved</source>
            <translation>
                <numerusform>%n verschoben</numerusform>
                <numerusform>%n verschoben</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n wired otherwise</source>
            <translation>
                <numerusform>%n anders verdrahtet</numerusform>
                <numerusform>%n anders verdrahtet</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n in another revision</source>
            <translation>
                <numerusform>%n in anderer Revision</numerusform>
                <numerusform>%n in anderer Revision</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n other device(s)</source>
            <translation>
                <numerusform>%n anderes Gerät</numerusform>
                <numerusform>%n andere Geräte</numerusform>
            </translation>
        </message>
        <message>
            <source>Bus: %1. Beside the project: %2.</source>
            <translation>Bus: %1. Neben dem Projekt: %2.</translation>
        </message>
        <message>
            <source>Scan Result</source>
            <translation>Ergebnis des Scans</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) of this bus are running. They were only looked at and nothing was written, so some of what they are may not be known.</source>
            <translation>
                <numerusform>%n Slave dieses Busses läuft. Es wurde nur geschaut und nichts geschrieben, daher ist vielleicht nicht alles über ihn bekannt.</numerusform>
                <numerusform>%n Slaves dieses Busses laufen. Es wurde nur geschaut und nichts geschrieben, daher ist vielleicht nicht alles über sie bekannt.</numerusform>
            </translation>
        </message>
        <message>
            <source>Scan &amp;Fully…</source>
            <translation>&amp;Vollständig scannen …</translation>
        </message>
        <message>
            <source>Scan fully</source>
            <translation>Vollständig scannen</translation>
        </message>
        <message>
            <source>Touch the running machine?</source>
            <translation>Die laufende Maschine berühren?</translation>
        </message>
        <message>
            <source>States stay as they are. EEPROMs are taken from their devices while they are read, the receive times of all slaves are latched, and slaves without a description are asked in PREOP.</source>
            <translation>Zustände bleiben, wie sie sind. EEPROMs werden ihren Geräten entzogen, während sie gelesen werden, die Empfangszeiten aller Slaves werden erfasst, und Slaves ohne Beschreibung werden in PREOP befragt.</translation>
        </message>
        <message>
            <source>Scan Fully</source>
            <translation>Vollständig scannen</translation>
        </message>
        <message>
            <source>Slaves in the project and on the bus</source>
            <translation>Slaves im Projekt und am Bus</translation>
        </message>
        <message>
            <source>&amp;Take Over Ticked</source>
            <translation>&amp;Angekreuztes übernehmen</translation>
        </message>
        <message>
            <source>Take over what is ticked</source>
            <translation>Angekreuztes übernehmen</translation>
        </message>
        <message>
            <source>&amp;Replace Project…</source>
            <translation>Projekt &amp;ersetzen …</translation>
        </message>
        <message>
            <source>Replace the project</source>
            <translation>Das Projekt ersetzen</translation>
        </message>
        <message>
            <source>A new project of the bus with the defaults of its devices; all settings go</source>
            <translation>Ein neues Projekt des Busses mit den Vorgaben seiner Geräte; alle Einstellungen gehen</translation>
        </message>
        <message>
            <source>&amp;Keep Project</source>
            <translation>Projekt &amp;behalten</translation>
        </message>
        <message>
            <source>Keep the project</source>
            <translation>Das Projekt behalten</translation>
        </message>
        <message>
            <source>The other revision does not take these settings: %1</source>
            <translation>Die andere Revision nimmt diese Einstellungen nicht: %1</translation>
        </message>
        <message>
            <source>Replace the whole project?</source>
            <translation>Das ganze Projekt ersetzen?</translation>
        </message>
        <message>
            <source>Its settings go; Undo brings them back.</source>
            <translation>Seine Einstellungen gehen; Rückgängig bringt sie zurück.</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>Ersetzen</translation>
        </message>
</context>
<context>
    <name>FoundModel</name>
        <message>
            <source>Matches</source>
            <translation>Stimmt überein</translation>
        </message>
        <message>
            <source>Wired otherwise</source>
            <translation>Anders verdrahtet</translation>
        </message>
        <message>
            <source>Moved</source>
            <translation>Verschoben</translation>
        </message>
        <message>
            <source>Other revision</source>
            <translation>Andere Revision</translation>
        </message>
        <message>
            <source>Other device</source>
            <translation>Anderes Gerät</translation>
        </message>
        <message>
            <source>Missing</source>
            <translation>Fehlt</translation>
        </message>
        <message>
            <source>Additional</source>
            <translation>Zusätzlich</translation>
        </message>
        <message>
            <source>the master</source>
            <translation>dem Master</translation>
        </message>
        <message>
            <source>slave %1, port %2</source>
            <translation>Slave %1, Port %2</translation>
        </message>
        <message>
            <source>Revision %1 instead of %2</source>
            <translation>Revision %1 statt %2</translation>
        </message>
        <message>
            <source>%1 instead of %2</source>
            <translation>%1 statt %2</translation>
        </message>
        <message>
            <source>Not on the bus; ticked: goes out of the project</source>
            <translation>Nicht am Bus; angekreuzt: geht aus dem Projekt</translation>
        </message>
        <message>
            <source>Not in the project; ticked: comes in</source>
            <translation>Nicht im Projekt; angekreuzt: kommt hinein</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>Übernehmen</translation>
        </message>
        <message>
            <source>In the project</source>
            <translation>Im Projekt</translation>
        </message>
        <message>
            <source>On the bus</source>
            <translation>Am Bus</translation>
        </message>
        <message>
            <source>Difference</source>
            <translation>Unterschied</translation>
        </message>
        <message>
            <source>At position %1; in the project at %2</source>
            <translation>An Position %1; im Projekt an %2</translation>
        </message>
        <message>
            <source>Connected to %1; in the project to %2</source>
            <translation>Angeschlossen an %1; im Projekt an %2</translation>
        </message>
        <message>
            <source>Vendor %1, product %2 instead of %3, %4</source>
            <translation>Hersteller %1, Produkt %2 statt %3, %4</translation>
        </message>
</context>
<context>
    <name>ImportCommands</name>
        <message>
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <source>The ENI could not be read.</source>
            <translation>Die ENI konnte nicht gelesen werden.</translation>
        </message>
        <message numerus="yes">
            <source>A project was made of %1; exported again, %n command(s) would differ.</source>
            <translation>
                <numerusform>Aus %1 wurde ein Projekt; erneut exportiert wäre %n Kommando anders.</numerusform>
                <numerusform>Aus %1 wurde ein Projekt; erneut exportiert wären %n Kommandos anders.</numerusform>
            </translation>
        </message>
        <message>
            <source>Add the folder of this device description to the catalogue?</source>
            <translation>Den Ordner dieser Gerätebeschreibung in den Katalog aufnehmen?</translation>
        </message>
        <message>
            <source>All ESI files below %1 are read; scans then know their devices.</source>
            <translation>Alle ESI-Dateien unter %1 werden gelesen; Scans kennen dann ihre Geräte.</translation>
        </message>
        <message>
            <source>Add Folder</source>
            <translation>Ordner aufnehmen</translation>
        </message>
        <message>
            <source>Catalogue</source>
            <translation>Katalog</translation>
        </message>
        <message>
            <source>Reading the ESI files below %1 …</source>
            <translation>Die ESI-Dateien unter %1 werden gelesen …</translation>
        </message>
</context>
<context>
    <name>MasterTasksPage</name>
        <message>
            <source>Tasks (Expert)</source>
            <translation>Tasks (Experte)</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>Task</translation>
        </message>
        <message>
            <source>Name of the task (ENI Cyclic)</source>
            <translation>Name des Tasks (ENI Cyclic)</translation>
        </message>
        <message>
            <source>Bus cycles</source>
            <translation>Buszyklen</translation>
        </message>
        <message>
            <source>Its frames are sent in every so many-th bus cycle, 1 to 1000</source>
            <translation>Seine Frames werden in jedem so vielten Buszyklus gesendet, 1 bis 1000</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>Tasks beside the Base Task</source>
            <translation>Tasks neben dem Basis-Task</translation>
        </message>
        <message>
            <source>Sync Unit</source>
            <translation>Sync Unit</translation>
        </message>
        <message>
            <source>Slaves of one unit are exchanged in datagrams of their own</source>
            <translation>Slaves einer Unit werden in eigenen Datagrammen ausgetauscht</translation>
        </message>
        <message>
            <source>The task that exchanges the unit&apos;s process data</source>
            <translation>Der Task, der die Prozessdaten der Unit austauscht</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Sync Units</source>
            <translation>Sync Units</translation>
        </message>
        <message>
            <source>task</source>
            <translation>Task</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Unit</translation>
        </message>
        <message>
            <source>Base task</source>
            <translation>Basis-Task</translation>
        </message>
        <message>
            <source>None: all process data are exchanged in each bus cycle.</source>
            <translation>Keine: alle Prozessdaten werden in jedem Buszyklus ausgetauscht.</translation>
        </message>
        <message>
            <source>None: the slaves share their datagrams. Once there is a unit, slaves are dragged to it below.</source>
            <translation>Keine: Die Slaves teilen sich ihre Datagramme. Gibt es eine Unit, werden darunter Slaves zu ihr gezogen.</translation>
        </message>
</context>
<context>
    <name>ObjectPicker</name>
        <message>
            <source>Choose Object</source>
            <translation>Objekt wählen</translation>
        </message>
        <message>
            <source>Search objects</source>
            <translation>Objekte suchen</translation>
        </message>
        <message>
            <source>Index, name or type</source>
            <translation>Index, Name oder Typ</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Typ</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>Objects of the device</source>
            <translation>Objekte des Geräts</translation>
        </message>
        <message>
            <source>&amp;Choose</source>
            <translation>&amp;Wählen</translation>
        </message>
        <message>
            <source>Choose</source>
            <translation>Wählen</translation>
        </message>
</context>
<context>
    <name>PdoMappingEditor</name>
        <message>
            <source>Entries</source>
            <translation>Einträge</translation>
        </message>
        <message>
            <source>Entries of the selected PDO</source>
            <translation>Einträge des gewählten PDO</translation>
        </message>
        <message>
            <source>Selected Entry</source>
            <translation>Gewählter Eintrag</translation>
        </message>
        <message>
            <source>Choose Object…</source>
            <translation>Objekt wählen …</translation>
        </message>
        <message>
            <source>Choose an object of the device</source>
            <translation>Ein Objekt des Geräts wählen</translation>
        </message>
        <message>
            <source>PDO entry</source>
            <translation>PDO-Eintrag</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>Index and sub-index, hexadecimal: 0x6040:00; 0x0000:00 is padding</source>
            <translation>Index und Subindex, hexadezimal: 0x6040:00; 0x0000:00 füllt auf</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is no object like 0x6040:00</source>
            <translation>„%1“ ist kein Objekt wie 0x6040:00</translation>
        </message>
        <message>
            <source>Bits</source>
            <translation>Bits</translation>
        </message>
        <message>
            <source>Length of the entry, 1 to 255 bits</source>
            <translation>Länge des Eintrags, 1 bis 255 Bit</translation>
        </message>
        <message>
            <source>No PDO is selected.</source>
            <translation>Kein PDO ist gewählt.</translation>
        </message>
        <message>
            <source>The device does not let this PDO be changed (Fixed in the ESI).</source>
            <translation>Das Gerät lässt dieses PDO nicht ändern (Fixed in der ESI).</translation>
        </message>
        <message>
            <source>The device takes no other mapping (CoE PdoConfig in its ESI).</source>
            <translation>Das Gerät nimmt kein anderes Mapping (CoE PdoConfig in seiner ESI).</translation>
        </message>
</context>
<context>
    <name>RecentMenu</name>
        <message>
            <source>Open &amp;Recent</source>
            <translation>&amp;Zuletzt geöffnet</translation>
        </message>
        <message>
            <source>&amp;Pin This Project</source>
            <translation>Dieses Projekt &amp;anheften</translation>
        </message>
        <message>
            <source>&amp;Clear List</source>
            <translation>Liste &amp;leeren</translation>
        </message>
        <message>
            <source>Pinned projects stay</source>
            <translation>Angeheftete Projekte bleiben</translation>
        </message>
</context>
<context>
    <name>RecordEditor</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
        <message>
            <source>Selected</source>
            <translation>Gewählt</translation>
        </message>
</context>
<context>
    <name>RecordForm</name>
        <message>
            <source>Change: %1</source>
            <translation>Ändern: %1</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Neu</translation>
        </message>
        <message>
            <source>Add: %1</source>
            <translation>Hinzufügen: %1</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Remove: %1</source>
            <translation>Entfernen: %1</translation>
        </message>
        <message>
            <source>Move up: %1</source>
            <translation>Nach oben: %1</translation>
        </message>
        <message>
            <source>Move down: %1</source>
            <translation>Nach unten: %1</translation>
        </message>
</context>
<context>
    <name>RecoveryDialog</name>
        <message>
            <source>Recover Unsaved Work</source>
            <translation>Ungesicherte Arbeit wiederherstellen</translation>
        </message>
        <message>
            <source>A window ended before its edits were saved. They were kept; the files themselves are as they were last saved.</source>
            <translation>Ein Fenster endete, bevor seine Änderungen gesichert waren. Sie wurden aufbewahrt; die Dateien selbst sind, wie sie zuletzt gesichert wurden.</translation>
        </message>
        <message>
            <source>Unsaved work</source>
            <translation>Ungesicherte Arbeit</translation>
        </message>
        <message>
            <source>&amp;Recover</source>
            <translation>&amp;Wiederherstellen</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>&amp;Später</translation>
        </message>
        <message>
            <source>&amp;Discard…</source>
            <translation>&amp;Verwerfen …</translation>
        </message>
        <message>
            <source>Recover</source>
            <translation>Wiederherstellen</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>Später</translation>
        </message>
        <message>
            <source>Leaves it to the next start</source>
            <translation>Überlässt es dem nächsten Start</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>Unbenannt</translation>
        </message>
        <message numerus="yes">
            <source>kept %1, %n slave(s)</source>
            <translation>
                <numerusform>aufbewahrt %1, %n Slave</numerusform>
                <numerusform>aufbewahrt %1, %n Slaves</numerusform>
            </translation>
        </message>
        <message>
            <source>, last edit: %1</source>
            <translation>, letzte Änderung: %1</translation>
        </message>
        <message>
            <source>Never saved</source>
            <translation>Nie gesichert</translation>
        </message>
        <message>
            <source>Discard this work for good?</source>
            <translation>Diese Arbeit endgültig verwerfen?</translation>
        </message>
</context>
<context>
    <name>RunBar</name>
        <message>
            <source>Project and running machine</source>
            <translation>Projekt und laufende Maschine</translation>
        </message>
        <message>
            <source>Differences…</source>
            <translation>Unterschiede …</translation>
        </message>
        <message>
            <source>What the project says otherwise than the machine that runs</source>
            <translation>Was das Projekt anders sagt als die Maschine, die läuft</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>Anwenden</translation>
        </message>
        <message>
            <source>Restart…</source>
            <translation>Neu starten …</translation>
        </message>
        <message>
            <source>Takes the machine offline and starts it with the project</source>
            <translation>Nimmt die Maschine offline und startet sie mit dem Projekt</translation>
        </message>
        <message>
            <source>Revert</source>
            <translation>Zurücksetzen</translation>
        </message>
        <message>
            <source>Makes the project again what runs; Undo takes that back</source>
            <translation>Macht das Projekt wieder zu dem, was läuft; Rückgängig nimmt das zurück</translation>
        </message>
        <message numerus="yes">
            <source>The machine does not run what the project says: %n change(s).</source>
            <translation>
                <numerusform>Die Maschine führt nicht aus, was das Projekt sagt: %n Änderung.</numerusform>
                <numerusform>Die Maschine führt nicht aus, was das Projekt sagt: %n Änderungen.</numerusform>
            </translation>
        </message>
        <message>
            <source>Gives the parameters of the master synchronisation to the running machine</source>
            <translation>Gibt der laufenden Maschine die Parameter der Master-Synchronisation</translation>
        </message>
        <message>
            <source>Only parameters of the master synchronisation can be changed while the machine runs</source>
            <translation>Nur Parameter der Master-Synchronisation lassen sich ändern, während die Maschine läuft</translation>
        </message>
        <message>
            <source>The machine does not run what the project says.</source>
            <translation>Die Maschine führt nicht aus, was das Projekt sagt.</translation>
        </message>
</context>
<context>
    <name>SlaveSyncPage</name>
        <message>
            <source>Synchronisation</source>
            <translation>Synchronisation</translation>
        </message>
        <message>
            <source>Device Cycle</source>
            <translation>Zyklus des Geräts</translation>
        </message>
        <message>
            <source>CAN</source>
            <translation>CAN</translation>
        </message>
        <message>
            <source>Output Pins</source>
            <translation>Ausgangspins</translation>
        </message>
        <message>
            <source>Pin %1</source>
            <translation>Pin %1</translation>
        </message>
</context>
<context>
    <name>Overview</name>
        <message>
            <source>An event without words</source>
            <translation>Ein Ereignis ohne Worte</translation>
        </message>
        <message numerus="yes">
            <source>%n SM2 event(s) missed</source>
            <translation>
                <numerusform>%n SM2-Ereignis verpasst</numerusform>
                <numerusform>%n SM2-Ereignisse verpasst</numerusform>
            </translation>
        </message>
        <message>
            <source> (%1 times)</source>
            <translation> (%1-mal)</translation>
        </message>
        <message>
            <source>for %1</source>
            <translation>seit %1</translation>
        </message>
        <message>
            <source>, not lost since armed</source>
            <translation>, seit dem Scharfstellen nicht verloren</translation>
        </message>
        <message numerus="yes">
            <source>, last lost %1 ago, %n time(s)</source>
            <translation>
                <numerusform>, zuletzt vor %1 verloren, %n-mal</numerusform>
                <numerusform>, zuletzt vor %1 verloren, %n-mal</numerusform>
            </translation>
        </message>
        <message>
            <source>&lt;b&gt;Not armed yet:&lt;/b&gt; figures and faults count once the machine is in OP, and in sync where that is watched.</source>
            <translation>&lt;b&gt;Noch nicht scharf:&lt;/b&gt; Zahlen und Fehler zählen, sobald die Maschine in OP ist und synchron, wo das überwacht wird.</translation>
        </message>
        <message>
            <source>slaves: %1</source>
            <translation>Slaves: %1</translation>
        </message>
        <message>
            <source>master: %1</source>
            <translation>Master: %1</translation>
        </message>
        <message>
            <source>Now: %1.</source>
            <translation>Jetzt: %1.</translation>
        </message>
        <message>
            <source>Found so far: &lt;b&gt;%1&lt;/b&gt;</source>
            <translation>Bisher gefunden: &lt;b&gt;%1&lt;/b&gt;</translation>
        </message>
        <message>
            <source>&lt;b&gt;First: %1&lt;/b&gt; at %2.</source>
            <translation>&lt;b&gt;Zuerst: %1&lt;/b&gt; bei %2.</translation>
        </message>
        <message>
            <source> Then %1</source>
            <translation> Dann %1</translation>
        </message>
        <message>
            <source>; %1 more</source>
            <translation>; %1 weitere</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source> Not over: %1.</source>
            <translation> Nicht vorbei: %1.</translation>
        </message>
        <message>
            <source> It is episode %1 of %2 since %3.</source>
            <translation> Es ist die %1. von %2 Störungen ab %3.</translation>
        </message>
        <message>
            <source>&lt;b&gt;First: %1&lt;/b&gt; at %2, until %3.</source>
            <translation>&lt;b&gt;Zuerst: %1&lt;/b&gt; bei %2, bis %3.</translation>
        </message>
        <message>
            <source>&lt;b&gt;First: %1&lt;/b&gt; at %2, and it is not over.</source>
            <translation>&lt;b&gt;Zuerst: %1&lt;/b&gt; bei %2, und es ist nicht vorbei.</translation>
        </message>
        <message>
            <source>in the same cycle</source>
            <translation>im selben Zyklus</translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) before</source>
            <translation><numerusform>%n Zyklus davor</numerusform><numerusform>%n Zyklen davor</numerusform></translation>
        </message>
        <message>
            <source>%1 before</source>
            <translation>%1 davor</translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) later</source>
            <translation><numerusform>%n Zyklus später</numerusform><numerusform>%n Zyklen später</numerusform></translation>
        </message>
        <message>
            <source>%1 later</source>
            <translation>%1 später</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <comment>when, what</comment>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source> Seen %1.</source>
            <translation> Zu sehen %1.</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) do(es) not answer</source>
            <translation><numerusform>%n Slave antwortet nicht</numerusform><numerusform>%n Slaves antworten nicht</numerusform></translation>
        </message>
        <message>
            <source>&lt;b&gt;No fault&lt;/b&gt; for %2, since %1 of the run.</source>
            <translation>&lt;b&gt;Keine Störung&lt;/b&gt; seit %2, ab %1 des Laufs.</translation>
        </message>
        <message>
            <source>&lt;b&gt;Nothing fell or was lost&lt;/b&gt; for %2, since %1 of the run, but &lt;b&gt;%3&lt;/b&gt;</source>
            <translation>&lt;b&gt;Nichts fiel aus oder ging verloren&lt;/b&gt; seit %2, ab %1 des Laufs, aber &lt;b&gt;%3&lt;/b&gt;</translation>
        </message>
</context>
<context>
    <name>Recorded</name>
        <message>
            <source>Master</source>
            <translation>Master</translation>
        </message>
        <message>
            <source>cut short; whole up to its last second</source>
            <translation>abgebrochen; ganz bis zur letzten Sekunde</translation>
        </message>
        <message>
            <source>up to the end of the run</source>
            <translation>bis zum Ende des Laufs</translation>
        </message>
        <message>
            <source>stopped by the user</source>
            <translation>vom Benutzer beendet</translation>
        </message>
        <message>
            <source>the last stretch out of memory</source>
            <translation>der letzte Abschnitt aus dem Speicher</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Notiz</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>%1 min %2 s</source>
            <translation>%1 min %2 s</translation>
        </message>
        <message>
            <source>%1 h %2 min</source>
            <translation>%1 h %2 min</translation>
        </message>
        <message>
            <source>a machine</source>
            <translation>eine Maschine</translation>
        </message>
        <message>
            <source>%1 on %2, %3, %4 in %5 cycles of %6, %7</source>
            <translation>%1 an %2, %3, %4 in %5 Zyklen von %6, %7</translation>
        </message>
        <message>
            <source>; %1 cycles are missing in it</source>
            <translation>; %1 Zyklen fehlen darin</translation>
        </message>
        <message>
            <source>; the plots show the last %1 of them</source>
            <translation>; die Diagramme zeigen die letzten %1 davon</translation>
        </message>
        <message>
            <source>up to the end of the file</source>
            <translation>bis zum Ende der Datei</translation>
        </message>
        <message>
            <source>an imported run</source>
            <translation>ein importierter Lauf</translation>
        </message>
</context>
<context>
    <name>FigureCard</name>
        <message>
            <source>Margin: %1</source>
            <translation>Reserve: %1</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
</context>
<context>
    <name>OverviewPanel</name>
        <message>
            <source>mean</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <source>Since it was armed</source>
            <translation>Seit dem Scharfstellen</translation>
        </message>
        <message>
            <source>rms</source>
            <translation>Effektivwert</translation>
        </message>
        <message>
            <source>Root mean square about zero, since it was armed</source>
            <translation>Quadratischer Mittelwert um null, seit dem Scharfstellen</translation>
        </message>
        <message>
            <source>p99.99</source>
            <translation>p99,99</translation>
        </message>
        <message>
            <source>Of 10,000 cycles one is larger; magnitude, since it was armed</source>
            <translation>Von 10.000 Zyklen ist einer größer; Betrag, seit dem Scharfstellen</translation>
        </message>
        <message>
            <source>max</source>
            <translation>Maximum</translation>
        </message>
        <message>
            <source>Largest magnitude of all cycles since it was armed</source>
            <translation>Größter Betrag aller Zyklen seit dem Scharfstellen</translation>
        </message>
        <message>
            <source>Slaves in sync</source>
            <translation>Slaves synchron</translation>
        </message>
        <message>
            <source>Master in sync</source>
            <translation>Master synchron</translation>
        </message>
        <message>
            <source>Slaves: since when</source>
            <translation>Slaves: seit wann</translation>
        </message>
        <message>
            <source>Master: since when</source>
            <translation>Master: seit wann</translation>
        </message>
        <message>
            <source>DC deviation</source>
            <translation>DC-Abweichung</translation>
        </message>
        <message>
            <source>Register 0x092C of the slaves that follow the reference clock: the largest. With ≤ it is what the wire has or-ed of all of them: none is off by more, and perhaps none by so much</source>
            <translation>Register 0x092C der Slaves, die der Referenzuhr folgen: der größte Wert. Mit ≤ ist es, was die Leitung von allen verodert hat: keiner liegt weiter daneben, und vielleicht keiner so weit</translation>
        </message>
        <message>
            <source>SM2 events missed</source>
            <translation>Verpasste SM2-Ereignisse</translation>
        </message>
        <message>
            <source>Object 0x1C32:0B or 0x1C32:0C of the slaves that have one, since it was armed</source>
            <translation>Objekt 0x1C32:0B oder 0x1C32:0C der Slaves, die eines haben, seit dem Scharfstellen</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM-Fehler</translation>
        </message>
        <message>
            <source>Re-arm</source>
            <translation>Neu scharfstellen</translation>
        </message>
        <message>
            <source>Begin figures and faults anew</source>
            <translation>Zahlen und Störungen neu beginnen</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>Übersicht</translation>
        </message>
        <message>
            <source>worst</source>
            <translation>Schlimmster</translation>
        </message>
        <message>
            <source>The slave that has missed most</source>
            <translation>Der Slave, der am meisten verpasst hat</translation>
        </message>
        <message>
            <source>last</source>
            <translation>Zuletzt</translation>
        </message>
        <message>
            <source>When one was missed last</source>
            <translation>Wann zuletzt eines verpasst wurde</translation>
        </message>
        <message>
            <source>counted</source>
            <translation>Gezählt</translation>
        </message>
        <message>
            <source>For how long figures and faults have been counted</source>
            <translation>Wie lange Zahlen und Störungen schon gezählt werden</translation>
        </message>
        <message>
            <source>In sync?</source>
            <translation>Synchron?</translation>
        </message>
        <message>
            <source>The verdicts on slaves and master</source>
            <translation>Die Urteile über Slaves und Master</translation>
        </message>
        <message>
            <source>Mean, rms, quantile, maximum, missed events and faults begin anew now</source>
            <translation>Mittel, Effektivwert, Quantil, Maximum, verpasste Ereignisse und Störungen beginnen jetzt neu</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>Master</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>At the end: %1</source>
            <translation>Am Ende: %1</translation>
        </message>
        <message>
            <source>%1 at %2</source>
            <translation>%1 bei %2</translation>
        </message>
        <message>
            <source>no limit is set</source>
            <translation>keine Grenze gesetzt</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>Grenze ±%1</translation>
        </message>
        <message>
            <source>%1 % over the limit ±%2</source>
            <translation>%1 % über der Grenze ±%2</translation>
        </message>
        <message>
            <source>%1 % margin to ±%2</source>
            <translation>%1 % Reserve bis ±%2</translation>
        </message>
        <message>
            <source>no slave has this counter</source>
            <translation>kein Slave hat diesen Zähler</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>not counted yet</source>
            <translation>noch nicht gezählt</translation>
        </message>
        <message>
            <source>SYNC0 came without new outputs</source>
            <translation>SYNC0 kam ohne neue Ausgänge</translation>
        </message>
        <message>
            <source>A recording stays as it is</source>
            <translation>Eine Aufzeichnung bleibt, wie sie ist</translation>
        </message>
        <message>
            <source>Nothing has run yet: go online.</source>
            <translation>Noch ist nichts gelaufen: Gehen Sie online.</translation>
        </message>
        <message>
            <source>%1 times the limit ±%2</source>
            <translation>%1-mal die Grenze ±%2</translation>
        </message>
        <message>
            <source>Export and copy</source>
            <translation>Exportieren und kopieren</translation>
        </message>
        <message>
            <source>Export picture…</source>
            <translation>Bild exportieren …</translation>
        </message>
        <message>
            <source>Export the overview</source>
            <translation>Übersicht exportieren</translation>
        </message>
        <message>
            <source>Copy picture</source>
            <translation>Bild kopieren</translation>
        </message>
        <message>
            <source>Copy figures</source>
            <translation>Zahlen kopieren</translation>
        </message>
        <message>
            <source>Slaves in OP</source>
            <translation>Slaves in OP</translation>
        </message>
        <message>
            <source>Time of the frame at the reference clock minus its wanted time in the cycle. The margin is that of the filtered error as far as it has lasted for 200 ms: what is over before is no loss of synchronisation</source>
            <translation>Zeitpunkt des Frames an der Referenzuhr minus gewünschter Zeitpunkt im Zyklus. Die Reserve ist die des gefilterten Fehlers, soweit er 200 ms anhielt: was vorher vorbei ist, ist kein Verlust der Synchronisation</translation>
        </message>
        <message>
            <source>the others: %1</source>
            <translation>die übrigen: %1</translation>
        </message>
        <message>
            <source>%1 of %2 slaves in OP</source>
            <translation>%1 von %2 Slaves in OP</translation>
        </message>
        <message numerus="yes">
            <source>%n do(es) not answer</source>
            <translation><numerusform>%n antwortet nicht</numerusform><numerusform>%n antworten nicht</numerusform></translation>
        </message>
        <message numerus="yes">
            <source>lost %n time(s)</source>
            <translation><numerusform>%n-mal verloren</numerusform><numerusform>%n-mal verloren</numerusform></translation>
        </message>
        <message>
            <source>filtered, lasting: %1</source>
            <translation>gefiltert, anhaltend: %1</translation>
        </message>
        <message>
            <source>DCM error (raw)</source>
            <translation>DCM-Fehler (roh)</translation>
        </message>
</context>
<context>
    <name>RecordingBar</name>
        <message>
            <source>Recording that is shown</source>
            <translation>Aufzeichnung, die gezeigt wird</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <source>Close the recording</source>
            <translation>Die Aufzeichnung schließen</translation>
        </message>
        <message>
            <source>Shows the project and its machine again</source>
            <translation>Zeigt wieder das Projekt und seine Maschine</translation>
        </message>
        <message>
            <source>Recording %1 (not live): %2</source>
            <translation>Aufzeichnung %1 (nicht live): %2</translation>
        </message>
</context>
<context>
    <name>RecordingCommands</name>
        <message>
            <source>Recording of the Capture</source>
            <translation>Aufzeichnung des Mitschnitts</translation>
        </message>
        <message>
            <source>Captures (*.pcap *.pcapng *.cap);;All files (*)</source>
            <translation>Mitschnitte (*.pcap *.pcapng *.cap);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>Import a Capture</source>
            <translation>Mitschnitt importieren</translation>
        </message>
        <message>
            <source>Change Note</source>
            <translation>Notiz ändern</translation>
        </message>
        <message>
            <source>Add Note</source>
            <translation>Notiz hinzufügen</translation>
        </message>
        <message>
            <source>At %1 (empty takes the note away):</source>
            <translation>Bei %1 (leer nimmt die Notiz weg):</translation>
        </message>
        <message>
            <source>At %1:</source>
            <translation>Bei %1:</translation>
        </message>
        <message>
            <source>The note could not be written.</source>
            <translation>Die Notiz konnte nicht geschrieben werden.</translation>
        </message>
        <message>
            <source>Save the Episode</source>
            <translation>Episode sichern</translation>
        </message>
        <message>
            <source>Open Recording</source>
            <translation>Aufzeichnung öffnen</translation>
        </message>
        <message>
            <source>A recording is shown in its place.</source>
            <translation>Eine Aufzeichnung wird stattdessen gezeigt.</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <source>The recording %1 could not be opened.</source>
            <translation>Die Aufzeichnung %1 konnte nicht geöffnet werden.</translation>
        </message>
        <message>
            <source>Recordings (*.slrec)</source>
            <translation>Aufzeichnungen (*.slrec)</translation>
        </message>
        <message>
            <source>Recording</source>
            <translation>Aufzeichnung</translation>
        </message>
        <message>
            <source>Record</source>
            <translation>Aufzeichnen</translation>
        </message>
        <message>
            <source>The recording could not be started.</source>
            <translation>Die Aufzeichnung konnte nicht begonnen werden.</translation>
        </message>
        <message>
            <source>Recording to %1</source>
            <translation>Aufgezeichnet wird nach %1</translation>
        </message>
        <message>
            <source>The recording %1 has ended: %2</source>
            <translation>Die Aufzeichnung %1 ist zu Ende: %2</translation>
        </message>
        <message>
            <source>Recorded to %1</source>
            <translation>Aufgezeichnet nach %1</translation>
        </message>
        <message>
            <source>Save the &amp;Last…</source>
            <translation>Das &amp;Letzte sichern …</translation>
        </message>
        <message>
            <source>Save the &amp;Last %1…</source>
            <translation>Die &amp;letzten %1 sichern …</translation>
        </message>
        <message>
            <source>All that is in memory: %1</source>
            <translation>Alles, was im Speicher ist: %1</translation>
        </message>
        <message>
            <source>The last %1</source>
            <translation>Die letzten %1</translation>
        </message>
        <message>
            <source>Save the Last</source>
            <translation>Das Letzte sichern</translation>
        </message>
        <message>
            <source>The memory holds every cycle of the last %1 at most. Save:</source>
            <translation>Der Speicher hält jeden Zyklus der letzten %1 höchstens. Sichern:</translation>
        </message>
        <message>
            <source>Nothing could be saved.</source>
            <translation>Es konnte nichts gesichert werden.</translation>
        </message>
        <message>
            <source>The last stretch could not be saved.</source>
            <translation>Der letzte Abschnitt konnte nicht gesichert werden.</translation>
        </message>
        <message>
            <source>Saved to %1</source>
            <translation>Gesichert nach %1</translation>
        </message>
        <message>
            <source>Black box</source>
            <translation>Blackbox</translation>
        </message>
</context>
<context>
    <name>Dictionary</name>
        <message>
            <source>write in %1</source>
            <translation>schreiben in %1</translation>
        </message>
        <message>
            <source>text of at most %1</source>
            <translation>Text von höchstens %1</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 bis %2</translation>
        </message>
</context>
<context>
    <name>DictionaryReader</name>
        <message>
            <source>The slave does not tell its objects.</source>
            <translation>Der Slave nennt seine Objekte nicht.</translation>
        </message>
</context>
<context>
    <name>ObjectModel</name>
        <message>
            <source>Ticked entries are watched</source>
            <translation>Angehakte Einträge werden beobachtet</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Typ</translation>
        </message>
        <message>
            <source>Access</source>
            <translation>Zugriff</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Einheit</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Hex</source>
            <translation>Hex</translation>
        </message>
        <message>
            <source>%1, read from the slave</source>
            <translation>%1, aus dem Slave gelesen</translation>
        </message>
        <message>
            <source>Not read yet</source>
            <translation>Noch nicht gelesen</translation>
        </message>
        <message>
            <source>%1, the default: not read yet</source>
            <translation>%1, der Vorgabewert: noch nicht gelesen</translation>
        </message>
        <message>
            <source>Default</source>
            <translation>Vorgabe</translation>
        </message>
</context>
<context>
    <name>ObjectWriteBar</name>
        <message>
            <source>New value</source>
            <translation>Neuer Wert</translation>
        </message>
        <message>
            <source>Values with names</source>
            <translation>Werte mit Namen</translation>
        </message>
        <message>
            <source>&amp;Write</source>
            <translation>&amp;Schreiben</translation>
        </message>
        <message>
            <source>Write the value</source>
            <translation>Den Wert schreiben</translation>
        </message>
        <message>
            <source>Not possible; %1</source>
            <translation>Nicht möglich; %1</translation>
        </message>
</context>
<context>
    <name>OnlinePage</name>
        <message>
            <source>Offline. Go online (F5), in whatever state, to ask the slave itself.</source>
            <translation>Offline. Gehen Sie online (F5), in welchem Zustand auch immer, um den Slave selbst zu fragen.</translation>
        </message>
        <message>
            <source>The bus is going offline.</source>
            <translation>Der Bus geht offline.</translation>
        </message>
        <message>
            <source>The machine was started without this slave: restart it with the project as it is now.</source>
            <translation>Die Maschine wurde ohne diesen Slave gestartet: Starten Sie sie mit dem jetzigen Projekt neu.</translation>
        </message>
        <message>
            <source>The bus is starting.</source>
            <translation>Der Bus startet.</translation>
        </message>
        <message>
            <source>The slave does not answer: check its power and the cable in front of it.</source>
            <translation>Der Slave antwortet nicht: Prüfen Sie seine Versorgung und das Kabel davor.</translation>
        </message>
        <message>
            <source>%1 is in %2. %3</source>
            <translation>%1 ist in %2. %3</translation>
        </message>
        <message>
            <source>What became of the last request</source>
            <translation>Was aus der letzten Anfrage wurde</translation>
        </message>
        <message>
            <source>The master does not answer.</source>
            <translation>Der Master antwortet nicht.</translation>
        </message>
</context>
<context>
    <name>SlaveObjectsPage</name>
        <message>
            <source>Objects</source>
            <translation>Objekte</translation>
        </message>
        <message>
            <source>Where the objects are described</source>
            <translation>Wo die Objekte beschrieben sind</translation>
        </message>
        <message>
            <source>From the ESI</source>
            <translation>Aus der ESI</translation>
        </message>
        <message>
            <source>From the slave: all</source>
            <translation>Aus dem Slave: alle</translation>
        </message>
        <message>
            <source>From the slave: RxPDO</source>
            <translation>Aus dem Slave: RxPDO</translation>
        </message>
        <message>
            <source>From the slave: TxPDO</source>
            <translation>Aus dem Slave: TxPDO</translation>
        </message>
        <message>
            <source>From the slave: to be stored</source>
            <translation>Aus dem Slave: zu sichernde</translation>
        </message>
        <message>
            <source>From the slave: start-up</source>
            <translation>Aus dem Slave: Hochlauf</translation>
        </message>
        <message>
            <source>The slave tells its objects by SDO information (ETG.1000.6, 5.6.3)</source>
            <translation>Der Slave nennt seine Objekte durch SDO-Information (ETG.1000.6, 5.6.3)</translation>
        </message>
        <message>
            <source>Search objects</source>
            <translation>Objekte suchen</translation>
        </message>
        <message>
            <source>Index, name or value</source>
            <translation>Index, Name oder Wert</translation>
        </message>
        <message>
            <source>Watched only</source>
            <translation>Nur beobachtete</translation>
        </message>
        <message>
            <source>Show watched entries only</source>
            <translation>Nur beobachtete Einträge zeigen</translation>
        </message>
        <message>
            <source>Objects of the slave</source>
            <translation>Objekte des Slaves</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <source>&amp;Read</source>
            <translation>&amp;Lesen</translation>
        </message>
        <message>
            <source>Read the selected objects</source>
            <translation>Die gewählten Objekte lesen</translation>
        </message>
        <message>
            <source>Read &amp;All Shown</source>
            <translation>&amp;Alle gezeigten lesen</translation>
        </message>
        <message>
            <source>Read all entries that are shown</source>
            <translation>Alle gezeigten Einträge lesen</translation>
        </message>
        <message>
            <source>How often watched entries are read</source>
            <translation>Wie oft beobachtete Einträge gelesen werden</translation>
        </message>
        <message>
            <source>Watched: on demand</source>
            <translation>Beobachtete: auf Anforderung</translation>
        </message>
        <message>
            <source>Watched: every %1 s</source>
            <translation>Beobachtete: alle %1 s</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Stopp</translation>
        </message>
        <message>
            <source>Stop reading</source>
            <translation>Das Lesen beenden</translation>
        </message>
        <message>
            <source>&amp;CSV…</source>
            <translation>&amp;CSV …</translation>
        </message>
        <message>
            <source>Export the shown objects as comma separated values</source>
            <translation>Die gezeigten Objekte als kommagetrennte Werte exportieren</translation>
        </message>
        <message>
            <source>%1 of %2 objects</source>
            <translation>%1 von %2 Objekten</translation>
        </message>
        <message numerus="yes">
            <source>%n object(s)</source>
            <translation>
                <numerusform>%n Objekt</numerusform>
                <numerusform>%n Objekte</numerusform>
            </translation>
        </message>
        <message>
            <source>This slave does not speak CoE: it has no objects. Its registers and EEPROM can be read all the same.</source>
            <translation>Dieser Slave spricht kein CoE: Er hat keine Objekte. Seine Register und sein EEPROM lassen sich trotzdem lesen.</translation>
        </message>
        <message>
            <source>Objects can be read from PREOP on: lead the slave there first.</source>
            <translation>Objekte lassen sich ab PREOP lesen: Führen Sie den Slave zuerst dorthin.</translation>
        </message>
        <message>
            <source>The ESI describes no objects: choose &quot;From the slave&quot; when online.</source>
            <translation>Die ESI beschreibt keine Objekte: Wählen Sie online „Aus dem Slave“.</translation>
        </message>
        <message>
            <source>The slave is asked for its objects.</source>
            <translation>Der Slave wird nach seinen Objekten gefragt.</translation>
        </message>
        <message>
            <source>Choose an entry to write a value.</source>
            <translation>Wählen Sie einen Eintrag, um einen Wert zu schreiben.</translation>
        </message>
        <message>
            <source>%1 cannot be written.</source>
            <translation>%1 kann nicht geschrieben werden.</translation>
        </message>
        <message>
            <source>Nothing that can be read is selected.</source>
            <translation>Nichts Lesbares ist gewählt.</translation>
        </message>
        <message>
            <source>%1 of %2 entries</source>
            <translation>%1 von %2 Einträgen</translation>
        </message>
        <message>
            <source>%1 of %2 entries; the others say why in their line</source>
            <translation>%1 von %2 Einträgen; die anderen sagen in ihrer Zeile, warum</translation>
        </message>
        <message>
            <source>The slave acts upon the new value at once.</source>
            <translation>Der Slave richtet sich sofort nach dem neuen Wert.</translation>
        </message>
        <message>
            <source>The object is in the process data: the master writes it in each cycle and will overwrite this.</source>
            <translation>Das Objekt gehört zu den Prozessdaten: Der Master schreibt es in jedem Zyklus und wird dies überschreiben.</translation>
        </message>
        <message>
            <source>Write %1 to %2?</source>
            <translation>%1 in %2 schreiben?</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>Schreiben</translation>
        </message>
        <message>
            <source>%1 is written.</source>
            <translation>%1 ist geschrieben.</translation>
        </message>
        <message>
            <source>Written, but not to be read back: %1</source>
            <translation>Geschrieben, lässt sich aber nicht zurücklesen: %1</translation>
        </message>
        <message>
            <source>%1 is %2 now.</source>
            <translation>%1 ist jetzt %2.</translation>
        </message>
        <message>
            <source>Written, but the slave has made %1 of it.</source>
            <translation>Geschrieben, doch der Slave hat daraus %1 gemacht.</translation>
        </message>
        <message>
            <source>Stopped.</source>
            <translation>Beendet.</translation>
        </message>
        <message>
            <source>Export Objects</source>
            <translation>Objekte exportieren</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>Kommagetrennte Werte (*.csv)</translation>
        </message>
        <message>
            <source>The objects could not be exported.</source>
            <translation>Die Objekte konnten nicht exportiert werden.</translation>
        </message>
        <message>
            <source>Favourites</source>
            <translation>Favoriten</translation>
        </message>
        <message>
            <source>Objects that are watched in every device of this kind, also in other projects</source>
            <translation>Objekte, die bei jedem Gerät dieser Art beobachtet werden, auch in anderen Projekten</translation>
        </message>
        <message numerus="yes">
            <source>&amp;Watch %n favourite(s) of %1</source>
            <translation>
                <numerusform>%n Favoriten von %1 &amp;beobachten</numerusform>
                <numerusform>%n Favoriten von %1 &amp;beobachten</numerusform>
            </translation>
        </message>
        <message>
            <source>&amp;Make the watched entries the favourites of %1</source>
            <translation>Die beobachteten Einträge zu &amp;Favoriten von %1 machen</translation>
        </message>
        <message>
            <source>&amp;Forget the favourites of %1</source>
            <translation>Favoriten von %1 &amp;vergessen</translation>
        </message>
        <message>
            <source>No favourites of %1 yet</source>
            <translation>Noch keine Favoriten von %1</translation>
        </message>
</context>
<context>
    <name>SlaveRequests</name>
        <message>
            <source>Cancelled.</source>
            <translation>Abgebrochen.</translation>
        </message>
        <message>
            <source>The bus is offline: go online first (F5).</source>
            <translation>Der Bus ist offline: Gehen Sie zuerst online (F5).</translation>
        </message>
</context>
<context>
    <name>SlaveStateBar</name>
        <message>
            <source>AL status of the slave</source>
            <translation>AL-Status des Slaves</translation>
        </message>
        <message>
            <source>Acknowledge Error</source>
            <translation>Fehler quittieren</translation>
        </message>
        <message>
            <source>Acknowledge the error</source>
            <translation>Den Fehler quittieren</translation>
        </message>
        <message>
            <source>Writes the error acknowledge bit (0x0120 bit 4); the slave stays in its state</source>
            <translation>Schreibt das Quittierbit (0x0120 Bit 4); der Slave bleibt in seinem Zustand</translation>
        </message>
        <message>
            <source>Request %1 of this slave</source>
            <translation>%1 von diesem Slave anfordern</translation>
        </message>
        <message>
            <source>Leads this slave alone to %1, with its init commands (register 0x0120)</source>
            <translation>Führt nur diesen Slave nach %1, mit seinen Init-Kommandos (Register 0x0120)</translation>
        </message>
        <message>
            <source>The machine was started without this slave.</source>
            <translation>Die Maschine wurde ohne diesen Slave gestartet.</translation>
        </message>
        <message>
            <source>No answer (register 0x0130)</source>
            <translation>Keine Antwort (Register 0x0130)</translation>
        </message>
        <message>
            <source>AL status %1: %2</source>
            <translation>AL-Status %1: %2</translation>
        </message>
</context>
<context>
    <name>SlaveStateCommands</name>
        <message>
            <source>Go online first (F5).</source>
            <translation>Gehen Sie zuerst online (F5).</translation>
        </message>
        <message>
            <source>The machine was started without this slave.</source>
            <translation>Die Maschine wurde ohne diesen Slave gestartet.</translation>
        </message>
        <message>
            <source>The slave does not answer.</source>
            <translation>Der Slave antwortet nicht.</translation>
        </message>
        <message>
            <source>The whole bus is in INIT: request PREOP or more for all first.</source>
            <translation>Der ganze Bus ist in INIT: Fordern Sie zuerst PREOP oder mehr für alle an.</translation>
        </message>
        <message>
            <source>Its outputs stop and its inputs are no longer valid. The other slaves go on, and the master expects the working counter without it.</source>
            <translation>Seine Ausgänge stehen still, seine Eingänge gelten nicht mehr. Die anderen Slaves laufen weiter, und der Master erwartet den Working Counter ohne ihn.</translation>
        </message>
        <message>
            <source>It stays where you lead it: automatic recovery brings back only slaves that were lost or fell by themselves. A request of a state for the whole bus takes it along again.</source>
            <translation>Er bleibt, wohin Sie ihn führen: Die automatische Wiederherstellung holt nur Slaves zurück, die verloren gingen oder von selbst fielen. Eine Zustandsanforderung für den ganzen Bus nimmt ihn wieder mit.</translation>
        </message>
        <message>
            <source>The machine runs. Take %1 to %2?</source>
            <translation>Die Maschine läuft. %1 nach %2 führen?</translation>
        </message>
        <message>
            <source>Take to %1</source>
            <translation>Nach %1 führen</translation>
        </message>
        <message>
            <source>%1 is requested.</source>
            <translation>%1 ist angefordert.</translation>
        </message>
        <message>
            <source>It is in %1.</source>
            <translation>Er ist in %1.</translation>
        </message>
        <message>
            <source>The error is acknowledged; now request the state that it shall have.</source>
            <translation>Der Fehler ist quittiert; fordern Sie nun den Zustand an, den er haben soll.</translation>
        </message>
        <message>
            <source>Acknowledge Error</source>
            <translation>Fehler quittieren</translation>
        </message>
</context>
<context>
    <name>Counters</name>
        <message>
            <source>at least %1</source>
            <translation>mindestens %1</translation>
        </message>
        <message>
            <source> (+%1 in 10 s)</source>
            <translation> (+%1 in 10 s)</translation>
        </message>
        <message>
            <source>%1 s ago</source>
            <translation>vor %1 s</translation>
        </message>
</context>
<context>
    <name>EepromLines</name>
        <message>
            <source>Checksum of the configuration</source>
            <translation>Prüfsumme der Konfiguration</translation>
        </message>
        <message>
            <source>right</source>
            <translation>richtig</translation>
        </message>
        <message>
            <source>WRONG: the ESC does not load it</source>
            <translation>FALSCH: Der ESC lädt sie nicht</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>Alias</translation>
        </message>
        <message>
            <source>Vendor</source>
            <translation>Hersteller</translation>
        </message>
        <message>
            <source>Product code</source>
            <translation>Produktcode</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>Revision</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>Seriennummer</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>PDI control</source>
            <translation>PDI-Steuerung</translation>
        </message>
        <message>
            <source>PDI configuration</source>
            <translation>PDI-Konfiguration</translation>
        </message>
        <message>
            <source>Pulse length of SYNC signals</source>
            <translation>Pulslänge der SYNC-Signale</translation>
        </message>
        <message>
            <source>Mailbox to the slave (SM0)</source>
            <translation>Mailbox zum Slave (SM0)</translation>
        </message>
        <message>
            <source>Mailbox from the slave (SM1)</source>
            <translation>Mailbox vom Slave (SM1)</translation>
        </message>
        <message>
            <source>In BOOT to the slave</source>
            <translation>In BOOT zum Slave</translation>
        </message>
        <message>
            <source>In BOOT from the slave</source>
            <translation>In BOOT vom Slave</translation>
        </message>
        <message>
            <source>Mailbox protocols</source>
            <translation>Mailbox-Protokolle</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Order number</source>
            <translation>Bestellnummer</translation>
        </message>
        <message>
            <source>Group</source>
            <translation>Gruppe</translation>
        </message>
        <message>
            <source>E-bus current</source>
            <translation>E-Bus-Strom</translation>
        </message>
        <message>
            <source>%1, control %2</source>
            <translation>%1, Control %2</translation>
        </message>
        <message>
            <source>Distributed clocks: %1</source>
            <translation>Verteilte Uhren: %1</translation>
        </message>
        <message>
            <source>AssignActivate %1, SYNC0 %2, shift %3</source>
            <translation>AssignActivate %1, SYNC0 %2, Shift %3</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>Ausgänge</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Eingänge</translation>
        </message>
        <message>
            <source>Mailbox state</source>
            <translation>Mailbox-Status</translation>
        </message>
        <message>
            <source>Category %1</source>
            <translation>Kategorie %1</translation>
        </message>
</context>
<context>
    <name>RegisterModel</name>
        <message>
            <source>Address</source>
            <translation>Adresse</translation>
        </message>
        <message>
            <source>Register</source>
            <translation>Register</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Hex</source>
            <translation>Hex</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>Alter</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>last run</source>
            <translation>letzter Lauf</translation>
        </message>
</context>
<context>
    <name>SlaveCountersPage</name>
        <message>
            <source>Port</source>
            <translation>Port</translation>
        </message>
        <message>
            <source>Invalid frames</source>
            <translation>Ungültige Frames</translation>
        </message>
        <message>
            <source>Receive errors</source>
            <translation>Empfangsfehler</translation>
        </message>
        <message>
            <source>Forwarded errors</source>
            <translation>Weitergeleitete Fehler</translation>
        </message>
        <message>
            <source>Lost links</source>
            <translation>Linkverluste</translation>
        </message>
        <message>
            <source>Counter</source>
            <translation>Zähler</translation>
        </message>
        <message>
            <source>Total</source>
            <translation>Summe</translation>
        </message>
        <message>
            <source>Register</source>
            <translation>Register</translation>
        </message>
        <message>
            <source>Read</source>
            <translation>Gelesen</translation>
        </message>
        <message>
            <source>Error counters of the ports</source>
            <translation>Fehlerzähler der Ports</translation>
        </message>
        <message>
            <source>Other counters</source>
            <translation>Weitere Zähler</translation>
        </message>
        <message>
            <source>Counts since going online, or since the statistics were cleared. Invalid frames at a port: the fault is on the cable or the plug at this port. Forwarded errors alone: it is further in front.</source>
            <translation>Zählt ab dem Onlinegehen oder dem Löschen der Statistik. Ungültige Frames an einem Port: Der Fehler liegt am Kabel oder Stecker dieses Ports. Nur weitergeleitete Fehler: Er liegt weiter vorn.</translation>
        </message>
        <message>
            <source>not yet</source>
            <translation>noch nicht</translation>
        </message>
        <message>
            <source>in the last run</source>
            <translation>im letzten Lauf</translation>
        </message>
        <message>
            <source>Read: %1 (registers 0x0300 to 0x0313)</source>
            <translation>Gelesen: %1 (Register 0x0300 bis 0x0313)</translation>
        </message>
        <message>
            <source>Port %1 (%2)</source>
            <translation>Port %1 (%2)</translation>
        </message>
        <message>
            <source>Processing unit errors</source>
            <translation>Fehler der Processing Unit</translation>
        </message>
        <message>
            <source>PDI errors</source>
            <translation>PDI-Fehler</translation>
        </message>
        <message>
            <source>Process data watchdog expired</source>
            <translation>Prozessdaten-Watchdog abgelaufen</translation>
        </message>
        <message>
            <source>PDI watchdog expired</source>
            <translation>PDI-Watchdog abgelaufen</translation>
        </message>
        <message>
            <source>Counters</source>
            <translation>Zähler</translation>
        </message>
</context>
<context>
    <name>SlaveEepromPage</name>
        <message>
            <source>EEPROM</source>
            <translation>EEPROM</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Teil</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>What the EEPROM says</source>
            <translation>Was das EEPROM sagt</translation>
        </message>
        <message>
            <source>Bytes of the EEPROM</source>
            <translation>Bytes des EEPROM</translation>
        </message>
        <message>
            <source>Not read yet</source>
            <translation>Noch nicht gelesen</translation>
        </message>
        <message>
            <source>&amp;Read</source>
            <translation>&amp;Lesen</translation>
        </message>
        <message>
            <source>Read the whole EEPROM</source>
            <translation>Das ganze EEPROM lesen</translation>
        </message>
        <message>
            <source>&amp;Save…</source>
            <translation>&amp;Sichern …</translation>
        </message>
        <message>
            <source>Copy the EEPROM into a file</source>
            <translation>Das EEPROM in eine Datei kopieren</translation>
        </message>
        <message>
            <source>New alias</source>
            <translation>Neuer Alias</translation>
        </message>
        <message>
            <source>&amp;Write Alias…</source>
            <translation>Alias sch&amp;reiben …</translation>
        </message>
        <message>
            <source>Write the alias into the EEPROM</source>
            <translation>Den Alias in das EEPROM schreiben</translation>
        </message>
        <message>
            <source>Write &amp;Image…</source>
            <translation>&amp;Abbild schreiben …</translation>
        </message>
        <message>
            <source>Write a file into the EEPROM</source>
            <translation>Eine Datei in das EEPROM schreiben</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>Alias</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 von %2</translation>
        </message>
        <message>
            <source>Save EEPROM</source>
            <translation>EEPROM sichern</translation>
        </message>
        <message>
            <source>EEPROM images (*.bin)</source>
            <translation>EEPROM-Abbilder (*.bin)</translation>
        </message>
        <message>
            <source>The EEPROM could not be saved.</source>
            <translation>Das EEPROM konnte nicht gesichert werden.</translation>
        </message>
        <message>
            <source>Write alias %1 into the EEPROM of %2?</source>
            <translation>Alias %1 in das EEPROM von %2 schreiben?</translation>
        </message>
        <message>
            <source>It is written with its checksum and read back; the machine goes on. The slave takes it at its next power-on: until then 0x0012 shows the old one.</source>
            <translation>Er wird mit seiner Prüfsumme geschrieben und zurückgelesen; die Maschine läuft weiter. Der Slave übernimmt ihn beim nächsten Einschalten: Bis dahin zeigt 0x0012 den alten.</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>Schreiben</translation>
        </message>
        <message>
            <source>Alias %1 is in the EEPROM and read back. The slave takes it at its next power-on.</source>
            <translation>Alias %1 steht im EEPROM und ist zurückgelesen. Der Slave übernimmt ihn beim nächsten Einschalten.</translation>
        </message>
        <message>
            <source>Write EEPROM Image</source>
            <translation>EEPROM-Abbild schreiben</translation>
        </message>
        <message>
            <source>EEPROM images (*.bin);;All files (*)</source>
            <translation>EEPROM-Abbilder (*.bin);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>The image could not be read.</source>
            <translation>Das Abbild konnte nicht gelesen werden.</translation>
        </message>
        <message>
            <source>The image does not fit: it has %1, the EEPROM %2.</source>
            <translation>Das Abbild passt nicht: Es hat %1, das EEPROM %2.</translation>
        </message>
        <message>
            <source>Words that differ are written and read back; when one fails, all are put back. A wrong image can leave a slave that no longer comes up.</source>
            <translation>Abweichende Wörter werden geschrieben und zurückgelesen; misslingt eines, werden alle zurückgesetzt. Nach einem falschen Abbild kommt der Slave womöglich nicht mehr hoch.</translation>
        </message>
        <message>
            <source>The image is of another device (%1, product %2).</source>
            <translation>Das Abbild gehört zu einem anderen Gerät (%1, Produkt %2).</translation>
        </message>
        <message>
            <source>Write this image into the EEPROM of %1?</source>
            <translation>Dieses Abbild in das EEPROM von %1 schreiben?</translation>
        </message>
        <message>
            <source>The image is in the EEPROM and read back. The slave takes it at its next power-on.</source>
            <translation>Das Abbild steht im EEPROM und ist zurückgelesen. Der Slave übernimmt es beim nächsten Einschalten.</translation>
        </message>
        <message>
            <source>The EEPROM is being written.</source>
            <translation>Das EEPROM wird geschrieben.</translation>
        </message>
        <message>
            <source>%1 of %2 words are written.</source>
            <translation>%1 von %2 Wörtern sind geschrieben.</translation>
        </message>
</context>
<context>
    <name>SlaveRegistersPage</name>
        <message>
            <source>Registers</source>
            <translation>Register</translation>
        </message>
        <message>
            <source>Registers of the slave</source>
            <translation>Register des Slaves</translation>
        </message>
        <message>
            <source>Which registers are shown and read</source>
            <translation>Welche Register gezeigt und gelesen werden</translation>
        </message>
        <message>
            <source>All registers</source>
            <translation>Alle Register</translation>
        </message>
        <message>
            <source>Search registers</source>
            <translation>Register suchen</translation>
        </message>
        <message>
            <source>Address or name</source>
            <translation>Adresse oder Name</translation>
        </message>
        <message>
            <source>&amp;Read Shown</source>
            <translation>Gezeigte &amp;lesen</translation>
        </message>
        <message>
            <source>Read the registers that are shown</source>
            <translation>Die gezeigten Register lesen</translation>
        </message>
        <message>
            <source>Read &amp;One</source>
            <translation>&amp;Eines lesen</translation>
        </message>
        <message>
            <source>Read the selected register</source>
            <translation>Das gewählte Register lesen</translation>
        </message>
        <message>
            <source>How often the shown registers are read</source>
            <translation>Wie oft die gezeigten Register gelesen werden</translation>
        </message>
        <message>
            <source>On demand</source>
            <translation>Auf Anforderung</translation>
        </message>
        <message>
            <source>Every %1 s</source>
            <translation>Alle %1 s</translation>
        </message>
        <message>
            <source>New value, decimal or with 0x</source>
            <translation>Neuer Wert, dezimal oder mit 0x</translation>
        </message>
        <message>
            <source>&amp;Write…</source>
            <translation>&amp;Schreiben …</translation>
        </message>
        <message>
            <source>Write the register</source>
            <translation>Das Register schreiben</translation>
        </message>
        <message>
            <source>Choose a register to write it.</source>
            <translation>Wählen Sie ein Register, um es zu schreiben.</translation>
        </message>
        <message>
            <source>No register is shown that could be read along: choose one and read it alone.</source>
            <translation>Kein gezeigtes Register lässt sich mitlesen: Wählen Sie eines und lesen Sie es einzeln.</translation>
        </message>
        <message>
            <source>Choose a register first.</source>
            <translation>Wählen Sie zuerst ein Register.</translation>
        </message>
        <message>
            <source>not in this ESC</source>
            <translation>nicht in diesem ESC</translation>
        </message>
        <message>
            <source>Write %1 to register %2?</source>
            <translation>%1 in Register %2 schreiben?</translation>
        </message>
        <message>
            <source>The master has set this slave up and counts on its registers. A wrong value can stop the slave or the bus behind it, and nothing but going online anew puts it back.</source>
            <translation>Der Master hat diesen Slave eingerichtet und verlässt sich auf dessen Register. Ein falscher Wert kann den Slave oder den Bus dahinter anhalten, und erst ein neues Onlinegehen stellt ihn zurück.</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>Schreiben</translation>
        </message>
        <message>
            <source>%1 is written.</source>
            <translation>%1 ist geschrieben.</translation>
        </message>
        <message>
            <source>Written, but not to be read back: %1</source>
            <translation>Geschrieben, lässt sich aber nicht zurücklesen: %1</translation>
        </message>
        <message>
            <source>%1 is %2 now.</source>
            <translation>%1 ist jetzt %2.</translation>
        </message>
        <message>
            <source>Written, but the register shows %1.</source>
            <translation>Geschrieben, doch das Register zeigt %1.</translation>
        </message>
</context>
<context>
    <name>CatalogueModel</name>
        <message>
            <source>Other devices</source>
            <translation>Andere Geräte</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>Gerät</translation>
        </message>
        <message>
            <source>%1, revision %2</source>
            <translation>%1, Revision %2</translation>
        </message>
        <message>
            <source>%1
Product code %2, revision %3
%4</source>
            <translation>%1
Produktcode %2, Revision %3
%4</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>Revision</translation>
        </message>
</context>
<context>
    <name>CataloguePanel</name>
        <message>
            <source>Search the device catalogue</source>
            <translation>Den Gerätekatalog durchsuchen</translation>
        </message>
        <message>
            <source>Vendor, type, name or product code</source>
            <translation>Hersteller, Typ, Name oder Produktcode</translation>
        </message>
        <message>
            <source>Beginnings of words of the vendor, group, type, name or product code; all must occur.
A revision: #x00120000, or rev 18 as it is printed on the device; several: rev 16-18, rev 16-</source>
            <translation>Wortanfänge von Hersteller, Gruppe, Typ, Name oder Produktcode; alle müssen vorkommen.
Eine Revision: #x00120000, oder rev 18, wie sie auf dem Gerät steht; mehrere: rev 16-18, rev 16-</translation>
        </message>
        <message>
            <source>All revisions</source>
            <translation>Alle Revisionen</translation>
        </message>
        <message>
            <source>Show older revisions below each device, and devices that their vendor hides</source>
            <translation>Ältere Revisionen unter jedem Gerät zeigen und Geräte, die ihr Hersteller verbirgt</translation>
        </message>
        <message>
            <source>Devices of the catalogue</source>
            <translation>Geräte des Katalogs</translation>
        </message>
        <message>
            <source>The selected device</source>
            <translation>Das ausgewählte Gerät</translation>
        </message>
        <message>
            <source>Number of devices</source>
            <translation>Anzahl der Geräte</translation>
        </message>
        <message>
            <source>Reading of device descriptions</source>
            <translation>Lesen der Gerätebeschreibungen</translation>
        </message>
        <message>
            <source>Add to Machine</source>
            <translation>In die Maschine</translation>
        </message>
        <message>
            <source>Add the device behind the selected slave</source>
            <translation>Das Gerät hinter dem ausgewählten Slave einfügen</translation>
        </message>
        <message>
            <source>Add the device behind the slave that is selected in the explorer (Enter, or drag it there)</source>
            <translation>Das Gerät hinter dem Slave einfügen, der im Explorer ausgewählt ist (Enter, oder dorthin ziehen)</translation>
        </message>
        <message>
            <source>Read ESI…</source>
            <translation>ESI lesen …</translation>
        </message>
        <message>
            <source>Read ESI files into the catalogue</source>
            <translation>ESI-Dateien in den Katalog lesen</translation>
        </message>
        <message>
            <source>Read device descriptions of vendors into the catalogue</source>
            <translation>Gerätebeschreibungen der Hersteller in den Katalog lesen</translation>
        </message>
        <message>
            <source>Files…</source>
            <translation>Dateien …</translation>
        </message>
        <message>
            <source>Folder…</source>
            <translation>Ordner …</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>End reading; what was read is kept, the rest is read at the next start</source>
            <translation>Das Lesen beenden; was gelesen ist, bleibt, der Rest wird beim nächsten Start gelesen</translation>
        </message>
        <message>
            <source>Reading %1 (%2 of %3)</source>
            <translation>%1 wird gelesen (%2 von %3)</translation>
        </message>
        <message>
            <source>The catalogue is empty: read the ESI files of your devices.</source>
            <translation>Der Katalog ist leer: die ESI-Dateien Ihrer Geräte lesen.</translation>
        </message>
        <message numerus="yes">
            <source>None of the %n device(s) has all these words.</source>
            <translation>
                <numerusform>Das %n Gerät hat nicht alle diese Wörter.</numerusform>
                <numerusform>Keines der %n Geräte hat alle diese Wörter.</numerusform>
            </translation>
        </message>
        <message>
            <source>The first %1 of %2 devices: type more.</source>
            <translation>Die ersten %1 von %2 Geräten: mehr tippen.</translation>
        </message>
        <message>
            <source>%1 of %2 devices and revisions</source>
            <translation>%1 von %2 Geräten und Revisionen</translation>
        </message>
        <message>
            <source>Select a device to see what is known of it.</source>
            <translation>Ein Gerät auswählen, um zu sehen, was von ihm bekannt ist.</translation>
        </message>
        <message>
            <source>%1, product code %2</source>
            <translation>%1, Produktcode %2</translation>
        </message>
        <message>
            <source>Revision %1, ports %2</source>
            <translation>Revision %1, Ports %2</translation>
        </message>
        <message>
            <source>Revision rule %1</source>
            <translation>Revisionsregel %1</translation>
        </message>
        <message>
            <source>Hidden by its vendor</source>
            <translation>Von seinem Hersteller verborgen</translation>
        </message>
        <message>
            <source>Read ESI Files</source>
            <translation>ESI-Dateien lesen</translation>
        </message>
        <message>
            <source>Device descriptions (*.xml);;All files (*)</source>
            <translation>Gerätebeschreibungen (*.xml);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>Read a Folder of ESI Files</source>
            <translation>Einen Ordner mit ESI-Dateien lesen</translation>
        </message>
</context>
<context>
    <name>GoToDialog</name>
        <message>
            <source>Go To</source>
            <translation>Gehe zu</translation>
        </message>
        <message>
            <source>What can be gone to</source>
            <translation>Wohin es gehen kann</translation>
        </message>
        <message>
            <source>the master</source>
            <translation>der Master</translation>
        </message>
        <message>
            <source>slave %1, address %2, %3</source>
            <translation>Slave %1, Adresse %2, %3</translation>
        </message>
        <message>
            <source>setting</source>
            <translation>Einstellung</translation>
        </message>
        <message>
            <source>command</source>
            <translation>Befehl</translation>
        </message>
        <message>
            <source>Slave, setting, object or command to go to</source>
            <translation>Slave, Einstellung, Objekt oder Befehl, zu dem es gehen soll</translation>
        </message>
        <message>
            <source>A slave, a setting or its key, an object (6040, name), a command</source>
            <translation>Ein Slave, eine Einstellung oder ihr Schlüssel, ein Objekt (6040, Name), ein Befehl</translation>
        </message>
        <message>
            <source>Nothing fits. Slaves are found by name, position, address and type, settings by label and key, objects of their ESI by index and name.</source>
            <translation>Nichts passt. Slaves finden sich nach Name, Position, Adresse und Typ, Einstellungen nach Bezeichnung und Schlüssel, Objekte ihrer ESI nach Index und Name.</translation>
        </message>
</context>
<context>
    <name>MachineBuilding</name>
        <message numerus="yes">
            <source>%n new device(s) are in the catalogue.</source>
            <translation>
                <numerusform>%n neues Gerät ist im Katalog.</numerusform>
                <numerusform>%n neue Geräte sind im Katalog.</numerusform>
            </translation>
        </message>
        <message>
            <source>Device Catalogue</source>
            <translation>Gerätekatalog</translation>
        </message>
        <message>
            <source>Catalogue</source>
            <translation>Katalog</translation>
        </message>
</context>
<context>
    <name>ReplaceDialog</name>
        <message numerus="yes">
            <source>%1 and %n more</source>
            <translation>
                <numerusform>%1 und %n weitere</numerusform>
                <numerusform>%1 und %n weitere</numerusform>
            </translation>
        </message>
        <message>
            <source>Replace %1</source>
            <translation>%1 ersetzen</translation>
        </message>
        <message>
            <source>Now: %1, revision %2</source>
            <translation>Jetzt: %1, Revision %2</translation>
        </message>
        <message>
            <source>Search for another device</source>
            <translation>Ein anderes Gerät suchen</translation>
        </message>
        <message>
            <source>Its revisions are listed; type to search for another device</source>
            <translation>Hier stehen seine Revisionen; tippen, um ein anderes Gerät zu suchen</translation>
        </message>
        <message>
            <source>What it can be replaced by</source>
            <translation>Wodurch es ersetzt werden kann</translation>
        </message>
        <message>
            <source>What changes</source>
            <translation>Was sich ändert</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>Ersetzen</translation>
        </message>
        <message>
            <source>%1, revision %2</source>
            <translation>%1, Revision %2</translation>
        </message>
        <message>
            <source>The catalogue has no such device: read its ESI file, or type another name.</source>
            <translation>Der Katalog hat kein solches Gerät: seine ESI-Datei lesen oder einen anderen Namen tippen.</translation>
        </message>
        <message>
            <source>Choose one to see what changes.</source>
            <translation>Eines auswählen, um zu sehen, was sich ändert.</translation>
        </message>
        <message>
            <source>Reading…</source>
            <translation>Wird gelesen …</translation>
        </message>
        <message>
            <source>All settings stay.</source>
            <translation>Alle Einstellungen bleiben.</translation>
        </message>
        <message>
            <source>It does not take: %1. Everything else stays.</source>
            <translation>Es übernimmt nicht: %1. Alles andere bleibt.</translation>
        </message>
</context>
<context>
    <name>SlaveCommands</name>
        <message>
            <source>&amp;Add Device…</source>
            <translation>&amp;Gerät einfügen …</translation>
        </message>
        <message>
            <source>Choose a device in the catalogue for behind the selected slave</source>
            <translation>Im Katalog ein Gerät für hinter dem ausgewählten Slave wählen</translation>
        </message>
        <message>
            <source>&amp;Duplicate</source>
            <translation>&amp;Duplizieren</translation>
        </message>
        <message>
            <source>Put a copy behind the slave, with its branches</source>
            <translation>Eine Kopie hinter den Slave setzen, mit seinen Zweigen</translation>
        </message>
        <message>
            <source>&amp;Move Up</source>
            <translation>Nach &amp;oben</translation>
        </message>
        <message>
            <source>Change places with the slave before it in its line</source>
            <translation>Den Platz mit dem Slave davor in seiner Linie tauschen</translation>
        </message>
        <message>
            <source>Move Do&amp;wn</source>
            <translation>Nach &amp;unten</translation>
        </message>
        <message>
            <source>Change places with the slave behind it in its line</source>
            <translation>Den Platz mit dem Slave dahinter in seiner Linie tauschen</translation>
        </message>
        <message>
            <source>Re&amp;place…</source>
            <translation>&amp;Ersetzen …</translation>
        </message>
        <message>
            <source>Put another revision or another device in its place</source>
            <translation>Eine andere Revision oder ein anderes Gerät an seinen Platz setzen</translation>
        </message>
        <message>
            <source>Remo&amp;ve</source>
            <translation>Ent&amp;fernen</translation>
        </message>
        <message>
            <source>Take the slave with its branches out; its line closes</source>
            <translation>Den Slave mit seinen Zweigen herausnehmen; seine Linie schließt sich</translation>
        </message>
        <message>
            <source>Duplicate %1</source>
            <translation>%1 duplizieren</translation>
        </message>
        <message>
            <source>Move %1</source>
            <translation>%1 verschieben</translation>
        </message>
        <message>
            <source>Catalogue</source>
            <translation>Katalog</translation>
        </message>
        <message>
            <source>The description of the device could not be read.</source>
            <translation>Die Beschreibung des Geräts konnte nicht gelesen werden.</translation>
        </message>
        <message>
            <source>Add %1</source>
            <translation>%1 einfügen</translation>
        </message>
        <message>
            <source>Rewire %1</source>
            <translation>%1 umstecken</translation>
        </message>
        <message>
            <source>Remove %1</source>
            <translation>%1 entfernen</translation>
        </message>
        <message numerus="yes">
            <source>%1 was removed with %n slave(s) of its branches.</source>
            <translation>
                <numerusform>%1 wurde mit %n Slave seiner Zweige entfernt.</numerusform>
                <numerusform>%1 wurde mit %n Slaves seiner Zweige entfernt.</numerusform>
            </translation>
        </message>
        <message>
            <source>Replace %1</source>
            <translation>%1 ersetzen</translation>
        </message>
        <message numerus="yes">
            <source>%n setting(s) of the old device are gone; undo brings them back.</source>
            <translation>
                <numerusform>%n Einstellung des alten Geräts ist weg; Rückgängig bringt sie zurück.</numerusform>
                <numerusform>%n Einstellungen des alten Geräts sind weg; Rückgängig bringt sie zurück.</numerusform>
            </translation>
        </message>
        <message>
            <source>The slave is gone.</source>
            <translation>Den Slave gibt es nicht mehr.</translation>
        </message>
        <message>
            <source>No free port there, or nearer to the master, takes this device.</source>
            <translation>Kein freier Port dort oder näher am Master nimmt dieses Gerät auf.</translation>
        </message>
        <message>
            <source>That port is not free.</source>
            <translation>Dieser Port ist nicht frei.</translation>
        </message>
        <message>
            <source>A terminal needs an E-bus port, a device with a cable an Ethernet port.</source>
            <translation>Eine Klemme braucht einen E-Bus-Port, ein Gerät mit Kabel einen Ethernet-Port.</translation>
        </message>
        <message>
            <source>It has no port for what would hang behind it.</source>
            <translation>Es hat keinen Port für das, was dahinter hängen würde.</translation>
        </message>
        <message>
            <source>That place is behind the slave itself.</source>
            <translation>Dieser Platz ist hinter dem Slave selbst.</translation>
        </message>
        <message>
            <source>The slave stands first in its line.</source>
            <translation>Der Slave steht als erster in seiner Linie.</translation>
        </message>
        <message>
            <source>The slave stands last in its line.</source>
            <translation>Der Slave steht als letzter in seiner Linie.</translation>
        </message>
        <message>
            <source>A network has at most 65535 slaves.</source>
            <translation>Ein Netzwerk hat höchstens 65535 Slaves.</translation>
        </message>
</context>
<context>
    <name>LanguageMenu</name>
        <message>
            <source>Lan&amp;guage</source>
            <translation>Spra&amp;che</translation>
        </message>
        <message>
            <source>&amp;System Language</source>
            <translation>Sprache des S&amp;ystems</translation>
        </message>
</context>
<context>
    <name>DistributionView</name>
        <message>
            <source>each bar %1 wide</source>
            <translation>jeder Balken %1 breit</translation>
        </message>
        <message>
            <source>Reference clock against external clock</source>
            <translation>Referenzuhr gegen externe Uhr</translation>
        </message>
        <message>
            <source>Doubt of the send stamp</source>
            <translation>Unsicherheit des Sendestempels</translation>
        </message>
        <message>
            <source>Distribution</source>
            <translation>Verteilung</translation>
        </message>
        <message>
            <source>Signals of the distribution</source>
            <translation>Signale der Verteilung</translation>
        </message>
        <message>
            <source>Samples that count</source>
            <translation>Welche Werte zählen</translation>
        </message>
        <message>
            <source>Value axis of the distribution</source>
            <translation>Werteachse der Verteilung</translation>
        </message>
        <message>
            <source>All values</source>
            <translation>Alle Werte</translation>
        </message>
        <message>
            <source>Up to twice the limit</source>
            <translation>Bis zum doppelten Grenzwert</translation>
        </message>
        <message>
            <source>State of the distribution</source>
            <translation>Zustand der Verteilung</translation>
        </message>
        <message>
            <source>Quantiles</source>
            <translation>Quantile</translation>
        </message>
        <message>
            <source>50 %</source>
            <translation>50 %</translation>
        </message>
        <message>
            <source>99 %</source>
            <translation>99 %</translation>
        </message>
        <message>
            <source>99.9 %</source>
            <translation>99,9 %</translation>
        </message>
        <message>
            <source>99.99 %</source>
            <translation>99,99 %</translation>
        </message>
        <message>
            <source>Largest</source>
            <translation>Größter</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Werte</translation>
        </message>
        <message>
            <source>Samples of the bin</source>
            <translation>Werte der Klasse</translation>
        </message>
        <message>
            <source>The latest samples of the bin; a double click shows the moment in the plots</source>
            <translation>Die letzten Werte der Klasse; ein Doppelklick zeigt den Augenblick in den Kurven</translation>
        </message>
        <message>
            <source>Computing, %1 %</source>
            <translation>Zählt, %1 %</translation>
        </message>
        <message>
            <source>Time since start</source>
            <translation>Zeit seit Beginn</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>Send lateness</source>
            <translation>Verspätung beim Senden</translation>
        </message>
        <message>
            <source>Round trip</source>
            <translation>Umlaufzeit</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM-Fehler</translation>
        </message>
        <message>
            <source>DCM error, filtered</source>
            <translation>DCM-Fehler, gefiltert</translation>
        </message>
        <message>
            <source>DCM error with lateness</source>
            <translation>DCM-Fehler mit Verspätung</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>Drift</translation>
        </message>
        <message>
            <source>Adjustment</source>
            <translation>Korrektur</translation>
        </message>
        <message>
            <source>Largest deviation</source>
            <translation>Größte Abweichung</translation>
        </message>
        <message>
            <source>Deviation, or-ed (upper estimate)</source>
            <translation>Abweichung, verodert (obere Schätzung)</translation>
        </message>
        <message>
            <source>Network to slave</source>
            <translation>Netzwerk zu Slave</translation>
        </message>
        <message>
            <source>Master to network</source>
            <translation>Master zu Netzwerk</translation>
        </message>
        <message>
            <source>Frame late by</source>
            <translation>Frame zu spät um</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <source>Arrival phase</source>
            <translation>Ankunftsphase</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>Learned by the controller, a cycle</source>
            <translation>Vom Regler gelernt, je Zyklus</translation>
        </message>
        <message>
            <source>All adjustments</source>
            <translation>Alle Stellwerte zusammen</translation>
        </message>
</context>
<context>
    <name>SampleRange</name>
        <message>
            <source>Range shown</source>
            <translation>Gezeigter Bereich</translation>
        </message>
        <message>
            <source>Between the cursors</source>
            <translation>Zwischen den Cursorn</translation>
        </message>
        <message>
            <source>Since the figures were armed</source>
            <translation>Seit dem Scharfstellen</translation>
        </message>
        <message>
            <source>Set two cursors: keys A and B</source>
            <translation>Zwei Cursor setzen: Tasten A und B</translation>
        </message>
        <message>
            <source>Not armed: the machine has not been ready yet</source>
            <translation>Noch nicht scharf: Die Maschine war noch nicht bereit</translation>
        </message>
</context>
<context>
    <name>SignalChooser</name>
        <message>
            <source>Signals</source>
            <translation>Signale</translation>
        </message>
        <message>
            <source>Up to four signals over each other</source>
            <translation>Bis zu vier Signale übereinander</translation>
        </message>
        <message>
            <source>Deviation of a slave</source>
            <translation>Abweichung eines Slaves</translation>
        </message>
        <message>
            <source>Arrival phase of a slave</source>
            <translation>Ankunftsphase eines Slaves</translation>
        </message>
        <message>
            <source>Variable of the process image</source>
            <translation>Variable des Prozessabbilds</translation>
        </message>
        <message>
            <source>Watch others…</source>
            <translation>Andere beobachten …</translation>
        </message>
</context>
<context>
    <name>StabilityText</name>
        <message>
            <source>No samples in this range.</source>
            <translation>Keine Werte in diesem Bereich.</translation>
        </message>
        <message>
            <source>No even samples: between two gaps there are never as many as %1.</source>
            <translation>Keine gleichmäßigen Werte: zwischen zwei Lücken sind es nie %1 oder mehr.</translation>
        </message>
        <message>
            <source>Constant: nothing moves.</source>
            <translation>Konstant: nichts bewegt sich.</translation>
        </message>
        <message>
            <source>Jitter at short times: ADEV falls with slope %1, neighbouring values have little to do with each other.</source>
            <translation>Jitter bei kurzen Zeiten: ADEV fällt mit Steigung %1, benachbarte Werte haben wenig miteinander zu tun.</translation>
        </message>
        <message>
            <source>Hunting: it swings, with a period of about %1.</source>
            <translation>Pendeln: es schwingt mit einer Periode von etwa %1.</translation>
        </message>
        <message>
            <source>Drift at long times: ADEV rises with slope %1 up to the end, nothing takes it back.</source>
            <translation>Drift bei langen Zeiten: ADEV steigt mit Steigung %1 bis zum Ende, nichts nimmt sie zurück.</translation>
        </message>
        <message>
            <source>It moves away by about %1 in each second.</source>
            <translation>Es läuft in jeder Sekunde um etwa %1 davon.</translation>
        </message>
        <message>
            <source>Too few samples for a verdict.</source>
            <translation>Zu wenige Werte für ein Urteil.</translation>
        </message>
        <message>
            <source>Neither jitter, hunting nor drift stands out: slope of ADEV %1 at short times, %2 at long ones.</source>
            <translation>Weder Jitter noch Pendeln noch Drift fällt auf: Steigung der ADEV %1 bei kurzen Zeiten, %2 bei langen.</translation>
        </message>
        <message>
            <source>%1 samples, one each %2</source>
            <translation>%1 Werte, einer alle %2</translation>
        </message>
        <message>
            <source>%1 of %2 samples, one each %3</source>
            <translation>%1 von %2 Werten, einer alle %3</translation>
        </message>
        <message>
            <source>no gap</source>
            <translation>keine Lücke</translation>
        </message>
        <message numerus="yes">
            <source>%n gap(s)</source>
            <translation>
                <numerusform>%n Lücke</numerusform>
                <numerusform>%n Lücken</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 of them at a distance that is off by more than a tenth</source>
            <translation>%1 davon in einem Abstand, der um mehr als ein Zehntel abweicht</translation>
        </message>
        <message>
            <source>τ %1 to %2</source>
            <translation>τ %1 bis %2</translation>
        </message>
        <message>
            <source>Beyond the limit: MTIE is above %1 for times from %2 on, so values were beyond %3.</source>
            <translation>Über dem Grenzwert: MTIE liegt für Zeiten ab %2 über %1, also waren Werte jenseits von %3.</translation>
        </message>
        <message>
            <source>MTIE keeps the limit: it reaches %1 of %2.</source>
            <translation>MTIE hält den Grenzwert ein: sie erreicht %1 von %2.</translation>
        </message>
        <message>
            <source>beat of the two clocks</source>
            <translation>Schwebung der beiden Uhren</translation>
        </message>
        <message>
            <source>task, %1</source>
            <translation>Task, %1</translation>
        </message>
        <message>
            <source>mains, %1</source>
            <translation>Stromnetz, %1</translation>
        </message>
        <message>
            <source>swing of the DCM loop</source>
            <translation>Schwingen des DCM-Regelkreises</translation>
        </message>
        <message>
            <source>folded</source>
            <translation>gefaltet</translation>
        </message>
        <message>
            <source>One disturbance: nearly all that moves does so within %1.</source>
            <translation>Eine einzelne Störung: fast alle Bewegung liegt innerhalb von %1.</translation>
        </message>
</context>
<context>
    <name>StabilityView</name>
        <message>
            <source>Stability</source>
            <translation>Stabilität</translation>
        </message>
        <message>
            <source>Signals of the stability</source>
            <translation>Signale der Stabilität</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>ADEV</source>
            <translation>ADEV</translation>
        </message>
        <message>
            <source>TDEV</source>
            <translation>TDEV</translation>
        </message>
        <message>
            <source>MTIE</source>
            <translation>MTIE</translation>
        </message>
        <message>
            <source>Spectrum</source>
            <translation>Spektrum</translation>
        </message>
        <message>
            <source>Allan deviation: how much the rate changes from one observation time to the next</source>
            <translation>Allan-Abweichung: wie sehr sich der Gang von einer Beobachtungszeit zur nächsten ändert</translation>
        </message>
        <message>
            <source>Time deviation: how far averages over an observation time stray from an even course</source>
            <translation>Zeitabweichung: wie weit Mittel über eine Beobachtungszeit von einem stetigen Lauf abweichen</translation>
        </message>
        <message>
            <source>Maximum time interval error: the largest peak-to-peak value in any observation time</source>
            <translation>Maximaler Zeitintervallfehler: der größte Spitze-Spitze-Wert in irgendeiner Beobachtungszeit</translation>
        </message>
        <message>
            <source>Amplitude of each frequency</source>
            <translation>Amplitude jeder Frequenz</translation>
        </message>
        <message>
            <source>Samples that count</source>
            <translation>Welche Werte zählen</translation>
        </message>
        <message>
            <source>State of the stability</source>
            <translation>Zustand der Stabilität</translation>
        </message>
        <message>
            <source>What the curves say</source>
            <translation>Was die Kurven sagen</translation>
        </message>
        <message>
            <source>at most %1, limit %2</source>
            <translation>höchstens %1, Grenzwert %2</translation>
        </message>
        <message>
            <source>ADEV over the observation time τ</source>
            <translation>ADEV über der Beobachtungszeit τ</translation>
        </message>
        <message>
            <source>TDEV over the observation time τ</source>
            <translation>TDEV über der Beobachtungszeit τ</translation>
        </message>
        <message>
            <source>MTIE over the observation time τ</source>
            <translation>MTIE über der Beobachtungszeit τ</translation>
        </message>
        <message>
            <source>Amplitude over the frequency</source>
            <translation>Amplitude über der Frequenz</translation>
        </message>
        <message>
            <source>%1 windows of τ</source>
            <translation>%1 Fenster von τ</translation>
        </message>
        <message>
            <source>Too few samples without a gap for a spectrum.</source>
            <translation>Zu wenige Werte ohne Lücke für ein Spektrum.</translation>
        </message>
        <message>
            <source>No line stands out.</source>
            <translation>Keine Linie ragt heraus.</translation>
        </message>
        <message>
            <source>Lines are named by their frequency alone: a hint, no proof.</source>
            <translation>Linien sind allein nach ihrer Frequenz benannt: ein Hinweis, kein Beweis.</translation>
        </message>
        <message>
            <source>No limit is set that this signal could be held against.</source>
            <translation>Kein Grenzwert ist gesetzt, an dem dieses Signal zu messen wäre.</translation>
        </message>
        <message>
            <source>A magnitude, without a sign: a swing about zero shows at half its period.</source>
            <translation>Ein Betrag, ohne Vorzeichen: eine Schwingung um null zeigt sich mit halber Periode.</translation>
        </message>
        <message>
            <source>%1 windows averaged, one amplitude each %2.</source>
            <translation>%1 Fenster gemittelt, eine Amplitude alle %2.</translation>
        </message>
        <message>
            <source>%1; what is hollow rests on few windows of τ.</source>
            <translation>%1; was hohl ist, beruht auf wenigen Fenstern von τ.</translation>
        </message>
        <message>
            <source>Computing, %1 %</source>
            <translation>Zählt, %1 %</translation>
        </message>
</context>
<context>
    <name>HistogramPlot</name>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Value / %1</source>
            <translation>Wert / %1</translation>
        </message>
        <message>
            <source>limit ±%1 %2</source>
            <translation>Grenze ±%1 %2</translation>
        </message>
        <message>
            <source>below %1</source>
            <translation>unter %1</translation>
        </message>
        <message>
            <source>%1 and more</source>
            <translation>%1 und mehr</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 bis %2</translation>
        </message>
        <message>
            <source>Number of values</source>
            <translation>Anzahl der Werte</translation>
        </message>
</context>
<context>
    <name>EniModel</name>
        <message>
            <source>added</source>
            <translation>hinzugefügt</translation>
        </message>
        <message>
            <source>removed</source>
            <translation>entfernt</translation>
        </message>
        <message>
            <source>altered</source>
            <translation>geändert</translation>
        </message>
        <message>
            <source>before</source>
            <translation>vorher</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Zeile</translation>
        </message>
        <message>
            <source>Change</source>
            <translation>Änderung</translation>
        </message>
        <message>
            <source>ENI</source>
            <translation>ENI</translation>
        </message>
        <message numerus="yes">
            <source>… %n line(s) …</source>
            <translation>
                <numerusform>… %n Zeile …</numerusform>
                <numerusform>… %n Zeilen …</numerusform>
            </translation>
        </message>
        <message>
            <source>with the other value</source>
            <translation>mit dem anderen Wert</translation>
        </message>
        <message>
            <source>depends on the setting</source>
            <translation>hängt von der Einstellung ab</translation>
        </message>
</context>
<context>
    <name>EniFindingModel</name>
        <message>
            <source>Line</source>
            <translation>Zeile</translation>
        </message>
        <message>
            <source>Rule</source>
            <translation>Regel</translation>
        </message>
        <message>
            <source>Finding</source>
            <translation>Befund</translation>
        </message>
</context>
<context>
    <name>EniTextView</name>
        <message>
            <source>Text of the ENI</source>
            <translation>Text der ENI</translation>
        </message>
</context>
<context>
    <name>EniPage</name>
        <message>
            <source>ENI</source>
            <translation>ENI</translation>
        </message>
        <message>
            <source>Cyclic</source>
            <translation>Zyklisch</translation>
        </message>
        <message>
            <source>Process image</source>
            <translation>Prozessabbild</translation>
        </message>
        <message>
            <source>Other</source>
            <translation>Sonstiges</translation>
        </message>
        <message>
            <source>What stands against the ENI</source>
            <translation>Was gegen die ENI steht</translation>
        </message>
        <message>
            <source>ENI and what the checker says of it</source>
            <translation>ENI und was der Prüfer dazu sagt</translation>
        </message>
        <message>
            <source>Lines that changed</source>
            <translation>Zeilen, die anders wurden</translation>
        </message>
        <message>
            <source>Whether the ENI is up to date, and what the checker says of it</source>
            <translation>Ob die ENI aktuell ist und was der Prüfer dazu sagt</translation>
        </message>
        <message>
            <source>Dialect of the ENI</source>
            <translation>Dialekt der ENI</translation>
        </message>
        <message>
            <source>How the ENI is laid out and spelled, here and when it is exported: as EC-Engineer does, or as TwinCAT 3 does.</source>
            <translation>Wie die ENI aufgebaut und geschrieben wird, hier und beim Export: wie bei EC-Engineer oder wie bei TwinCAT 3.</translation>
        </message>
        <message>
            <source>Since when changes are shown</source>
            <translation>Seit wann Änderungen gezeigt werden</translation>
        </message>
        <message>
            <source>Changes since saved</source>
            <translation>Seit dem Speichern</translation>
        </message>
        <message>
            <source>Changes since exported</source>
            <translation>Seit dem Export</translation>
        </message>
        <message>
            <source>Changes since opened here</source>
            <translation>Seit dem Öffnen der Seite</translation>
        </message>
        <message>
            <source>The last change</source>
            <translation>Die letzte Änderung</translation>
        </message>
        <message>
            <source>Previous change</source>
            <translation>Vorige Änderung</translation>
        </message>
        <message>
            <source>Next change</source>
            <translation>Nächste Änderung</translation>
        </message>
        <message>
            <source>&amp;Only changes</source>
            <translation>N&amp;ur Änderungen</translation>
        </message>
        <message>
            <source>Show only the lines around changes</source>
            <translation>Nur die Zeilen um Änderungen zeigen</translation>
        </message>
        <message>
            <source>Co&amp;mpare…</source>
            <translation>&amp;Vergleichen …</translation>
        </message>
        <message>
            <source>Compare the project with a file</source>
            <translation>Das Projekt mit einer Datei vergleichen</translation>
        </message>
        <message>
            <source>E&amp;xport…</source>
            <translation>E&amp;xportieren …</translation>
        </message>
        <message>
            <source>Write the ENI to a file</source>
            <translation>Die ENI in eine Datei schreiben</translation>
        </message>
        <message>
            <source>Part of the ENI to go to</source>
            <translation>Teil der ENI, zu dem gesprungen wird</translation>
        </message>
        <message>
            <source>Go to</source>
            <translation>Gehe zu</translation>
        </message>
        <message>
            <source>Search the ENI</source>
            <translation>Die ENI durchsuchen</translation>
        </message>
        <message>
            <source>Search (Ctrl+F)</source>
            <translation>Suchen (Strg+F)</translation>
        </message>
        <message>
            <source>Previous place</source>
            <translation>Vorige Stelle</translation>
        </message>
        <message>
            <source>Next place</source>
            <translation>Nächste Stelle</translation>
        </message>
        <message>
            <source>What the checker says of the ENI</source>
            <translation>Was der Prüfer zur ENI sagt</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is not in it</source>
            <translation>„%1“ kommt nicht vor</translation>
        </message>
        <message>
            <source>The project cannot be compiled: %1</source>
            <translation>Das Projekt lässt sich nicht übersetzen: %1</translation>
        </message>
        <message>
            <source>What stands here is old: it was made at %1.</source>
            <translation>Was hier steht, ist alt: Es ist von %1.</translation>
        </message>
        <message numerus="yes">
            <source>%n error(s) of the project stand against this ENI.</source>
            <translation>
                <numerusform>%n Fehler des Projekts steht gegen diese ENI.</numerusform>
                <numerusform>%n Fehler des Projekts stehen gegen diese ENI.</numerusform>
            </translation>
        </message>
        <message>
            <source>Nothing has been changed yet</source>
            <translation>Noch ist nichts geändert</translation>
        </message>
        <message>
            <source>Not exported yet: nothing to compare with</source>
            <translation>Noch nicht exportiert: nichts zum Vergleichen</translation>
        </message>
        <message>
            <source>Not saved yet: nothing to compare with</source>
            <translation>Noch nicht gespeichert: nichts zum Vergleichen</translation>
        </message>
        <message>
            <source>No line differs</source>
            <translation>Keine Zeile ist anders</translation>
        </message>
        <message numerus="yes">
            <source>%n line(s) added</source>
            <translation>
                <numerusform>%n Zeile hinzugefügt</numerusform>
                <numerusform>%n Zeilen hinzugefügt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n removed</source>
            <translation>
                <numerusform>%n entfernt</numerusform>
                <numerusform>%n entfernt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n altered</source>
            <translation>
                <numerusform>%n geändert</numerusform>
                <numerusform>%n geändert</numerusform>
            </translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet …</translation>
        </message>
        <message>
            <source>Out of date</source>
            <translation>Veraltet</translation>
        </message>
        <message>
            <source>Being checked…</source>
            <translation>Wird geprüft …</translation>
        </message>
        <message numerus="yes">
            <source>%n error(s)</source>
            <translation>
                <numerusform>%n Fehler</numerusform>
                <numerusform>%n Fehler</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n Warnung</numerusform>
                <numerusform>%n Warnungen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n note(s)</source>
            <translation>
                <numerusform>%n Hinweis</numerusform>
                <numerusform>%n Hinweise</numerusform>
            </translation>
        </message>
        <message>
            <source>The checker finds nothing</source>
            <translation>Der Prüfer findet nichts</translation>
        </message>
        <message>
            <source>&amp;Report</source>
            <translation>Be&amp;richt</translation>
        </message>
        <message>
            <source>Write a report beside each ENI that is exported</source>
            <translation>Neben jede ENI, die exportiert wird, einen Bericht schreiben</translation>
        </message>
        <message>
            <source>An HTML file beside the ENI: slaves, clocks, frames, findings and the drawing of the wiring</source>
            <translation>Eine HTML-Datei neben der ENI: Slaves, Uhren, Frames, Befunde und die Zeichnung der Verkabelung</translation>
        </message>
        <message>
            <source>What depends on a setting</source>
            <translation>Was von einer Einstellung abhängt</translation>
        </message>
        <message>
            <source>Show &amp;Changes</source>
            <translation>Änderungen &amp;zeigen</translation>
        </message>
        <message>
            <source>Show changes in place of what depends</source>
            <translation>Änderungen zeigen statt dessen, was abhängt</translation>
        </message>
        <message>
            <source>Looking for what depends on &quot;%1&quot; of %2…</source>
            <translation>Es wird gesucht, was von „%1“ (%2) abhängt …</translation>
        </message>
        <message>
            <source>No other value of &quot;%1&quot; of %2 can be tried, so what depends on it is not known.</source>
            <translation>Von „%1“ (%2) lässt sich kein anderer Wert probieren; was davon abhängt, ist nicht bekannt.</translation>
        </message>
        <message>
            <source>&quot;%1&quot; of %2 does not change the ENI: it is used by the master at run time.</source>
            <translation>„%1“ (%2) ändert die ENI nicht: Der Master verwendet es zur Laufzeit.</translation>
        </message>
        <message>
            <source>Marked is what depends on &quot;%1&quot; of %2; struck out, how it would be with %3.</source>
            <translation>Markiert ist, was von „%1“ (%2) abhängt; durchgestrichen, wie es mit %3 wäre.</translation>
        </message>
</context>
<context>
    <name>ComparisonModel</name>
        <message>
            <source>Slaves</source>
            <translation>Slaves</translation>
        </message>
        <message>
            <source>Wiring</source>
            <translation>Verkabelung</translation>
        </message>
        <message>
            <source>Process data</source>
            <translation>Prozessdaten</translation>
        </message>
        <message>
            <source>Mailbox</source>
            <translation>Mailbox</translation>
        </message>
        <message>
            <source>Start-up</source>
            <translation>Hochlauf</translation>
        </message>
        <message>
            <source>Clocks</source>
            <translation>Uhren</translation>
        </message>
        <message>
            <source>Commands</source>
            <translation>Befehle</translation>
        </message>
        <message>
            <source>Cyclic</source>
            <translation>Zyklisch</translation>
        </message>
        <message>
            <source>Process image</source>
            <translation>Prozessabbild</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>Master</translation>
        </message>
        <message>
            <source>At run time</source>
            <translation>Im Betrieb</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>Einstellung</translation>
        </message>
        <message>
            <source>Position %1</source>
            <translation>Position %1</translation>
        </message>
        <message>
            <source>Network</source>
            <translation>Netz</translation>
        </message>
        <message numerus="yes">
            <source>%n difference(s)</source>
            <translation>
                <numerusform>%n Unterschied</numerusform>
                <numerusform>%n Unterschiede</numerusform>
            </translation>
        </message>
        <message>
            <source>What</source>
            <translation>Was</translation>
        </message>
        <message>
            <source>Class</source>
            <translation>Art</translation>
        </message>
</context>
<context>
    <name>CompareDialog</name>
        <message>
            <source>Changed since it was compared; choose the bus once more to look again.</source>
            <translation>Geändert, seit verglichen wurde; wählen Sie den Bus noch einmal, um neu nachzusehen.</translation>
        </message>
        <message>
            <source>A bus can only stand on the right</source>
            <translation>Ein Bus kann nur rechts stehen</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Vergleichen</translation>
        </message>
        <message>
            <source>How many differences there are</source>
            <translation>Wie viele Unterschiede es gibt</translation>
        </message>
        <message>
            <source>Left side of the comparison</source>
            <translation>Linke Seite des Vergleichs</translation>
        </message>
        <message>
            <source>Right side of the comparison</source>
            <translation>Rechte Seite des Vergleichs</translation>
        </message>
        <message>
            <source>Exchange the two sides</source>
            <translation>Die Seiten vertauschen</translation>
        </message>
        <message>
            <source>Search the differences</source>
            <translation>Die Unterschiede durchsuchen</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>Suchen</translation>
        </message>
        <message>
            <source>&amp;Only what matters</source>
            <translation>&amp;Nur was zählt</translation>
        </message>
        <message>
            <source>Only what matters</source>
            <translation>Nur was zählt</translation>
        </message>
        <message>
            <source>Leaves out names, and where data stand in the process image</source>
            <translation>Lässt Namen weg, und wo Daten im Prozessabbild stehen</translation>
        </message>
        <message>
            <source>Differences</source>
            <translation>Unterschiede</translation>
        </message>
        <message>
            <source>&amp;Copy</source>
            <translation>&amp;Kopieren</translation>
        </message>
        <message>
            <source>Copy the differences as text</source>
            <translation>Die Unterschiede als Text kopieren</translation>
        </message>
        <message>
            <source>&amp;Export CSV…</source>
            <translation>CSV &amp;exportieren …</translation>
        </message>
        <message>
            <source>Write the differences to a file</source>
            <translation>Die Unterschiede in eine Datei schreiben</translation>
        </message>
        <message>
            <source>File…</source>
            <translation>Datei …</translation>
        </message>
        <message>
            <source>Bus…</source>
            <translation>Bus …</translation>
        </message>
        <message>
            <source>Project (%1)</source>
            <translation>Projekt (%1)</translation>
        </message>
        <message>
            <source>Running machine</source>
            <translation>Laufende Maschine</translation>
        </message>
        <message>
            <source>Bus on %1</source>
            <translation>Bus an %1</translation>
        </message>
        <message>
            <source>Compare With</source>
            <translation>Vergleichen mit</translation>
        </message>
        <message>
            <source>Projects and ENI files (*.syncline *.xml *.eni);;All files (*)</source>
            <translation>Projekte und ENI-Dateien (*.syncline *.xml *.eni);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>Choose what the project is to be compared with.</source>
            <translation>Wählen, womit das Projekt verglichen werden soll.</translation>
        </message>
        <message>
            <source>Comparing…</source>
            <translation>Wird verglichen …</translation>
        </message>
        <message>
            <source>There is no difference.</source>
            <translation>Es gibt keinen Unterschied.</translation>
        </message>
        <message numerus="yes">
            <source>%n difference(s)</source>
            <translation>
                <numerusform>%n Unterschied</numerusform>
                <numerusform>%n Unterschiede</numerusform>
            </translation>
        </message>
        <message>
            <source>Where</source>
            <translation>Wo</translation>
        </message>
        <message>
            <source>Export Differences</source>
            <translation>Unterschiede exportieren</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>Kommagetrennte Werte (*.csv)</translation>
        </message>
        <message>
            <source>The differences could not be written.</source>
            <translation>Die Unterschiede konnten nicht geschrieben werden.</translation>
        </message>
        <message numerus="yes">
            <source>(%n of them are changes of the project; the others follow from these, or change nothing)</source>
            <translation>
                <numerusform>(%n davon ist eine Änderung des Projekts; die anderen folgen daraus oder ändern nichts)</numerusform>
                <numerusform>(%n davon sind Änderungen des Projekts; die anderen folgen daraus oder ändern nichts)</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>DiagnosisModel</name>
        <message>
            <source>Information</source>
            <translation>Information</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Warnung</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>%1 s since its start</source>
            <translation>%1 s seit seinem Start</translation>
        </message>
        <message>
            <source>Acknowledged</source>
            <translation>Quittiert</translation>
        </message>
        <message>
            <source>New</source>
            <translation>Neu</translation>
        </message>
        <message>
            <source>cannot be read: %1</source>
            <translation>nicht lesbar: %1</translation>
        </message>
        <message>
            <source>Text %1 of the ESI</source>
            <translation>Text %1 der ESI</translation>
        </message>
        <message>
            <source>Sub-index</source>
            <translation>Subindex</translation>
        </message>
        <message>
            <source>Severity</source>
            <translation>Schwere</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>Meldung</translation>
        </message>
        <message>
            <source>Diag code</source>
            <translation>Diag-Code</translation>
        </message>
        <message>
            <source>Text ID</source>
            <translation>Text-ID</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <source>DC time (ns)</source>
            <translation>DC-Zeit (ns)</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Zustand</translation>
        </message>
</context>
<context>
    <name>DiagnosisReader</name>
        <message>
            <source>Object 0x10F3 says nothing of its length.</source>
            <translation>Objekt 0x10F3 sagt nichts über seine Länge.</translation>
        </message>
</context>
<context>
    <name>SlaveHistoryPage</name>
        <message>
            <source>History</source>
            <translation>Historie</translation>
        </message>
        <message>
            <source>When full it keeps what nobody has acknowledged</source>
            <translation>Wenn sie voll ist, behält sie, was niemand quittiert hat</translation>
        </message>
        <message>
            <source>When full it overwrites the oldest message</source>
            <translation>Wenn sie voll ist, überschreibt sie die älteste Meldung</translation>
        </message>
        <message>
            <source>messages were thrown away because it was full</source>
            <translation>Meldungen wurden verworfen, weil sie voll war</translation>
        </message>
        <message>
            <source>messages were overwritten that nobody had acknowledged</source>
            <translation>Meldungen wurden überschrieben, die niemand quittiert hatte</translation>
        </message>
        <message>
            <source>each is sent as an emergency, too</source>
            <translation>jede wird auch als Emergency gesendet</translation>
        </message>
        <message>
            <source>none is sent as an emergency</source>
            <translation>keine wird als Emergency gesendet</translation>
        </message>
        <message>
            <source>information</source>
            <translation>Informationen</translation>
        </message>
        <message>
            <source>warnings</source>
            <translation>Warnungen</translation>
        </message>
        <message>
            <source>errors</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>not kept: %1</source>
            <translation>nicht aufgehoben: %1</translation>
        </message>
        <message>
            <source>Flags %1: %2.</source>
            <translation>Flags %1: %2.</translation>
        </message>
        <message>
            <source>Messages of the slave's diagnosis history, newest first</source>
            <translation>Meldungen der Diagnosehistorie des Slaves, neueste zuerst</translation>
        </message>
        <message>
            <source>&amp;Read</source>
            <translation>&amp;Lesen</translation>
        </message>
        <message>
            <source>Read the diagnosis history</source>
            <translation>Die Diagnosehistorie lesen</translation>
        </message>
        <message>
            <source>Object 0x10F3 (ETG.1020). Reading acknowledges nothing.</source>
            <translation>Objekt 0x10F3 (ETG.1020). Lesen quittiert nichts.</translation>
        </message>
        <message>
            <source>On demand</source>
            <translation>Auf Wunsch</translation>
        </message>
        <message>
            <source>Every %1 s</source>
            <translation>Alle %1 s</translation>
        </message>
        <message>
            <source>How often the diagnosis history is read</source>
            <translation>Wie oft die Diagnosehistorie gelesen wird</translation>
        </message>
        <message>
            <source>&amp;Acknowledge All…</source>
            <translation>Alle &amp;quittieren …</translation>
        </message>
        <message>
            <source>Acknowledge all messages of the diagnosis history</source>
            <translation>Alle Meldungen der Diagnosehistorie quittieren</translation>
        </message>
        <message>
            <source>Writes the newest message's sub-index to 0x10F3:03</source>
            <translation>Schreibt den Subindex der neuesten Meldung nach 0x10F3:03</translation>
        </message>
        <message>
            <source>&amp;CSV…</source>
            <translation>&amp;CSV …</translation>
        </message>
        <message>
            <source>Export the messages as comma-separated values</source>
            <translation>Die Meldungen als kommagetrennte Werte exportieren</translation>
        </message>
        <message>
            <source>This slave keeps no diagnosis history: it has no object 0x10F3.</source>
            <translation>Dieser Slave führt keine Diagnosehistorie: Er hat kein Objekt 0x10F3.</translation>
        </message>
        <message>
            <source>This slave does not speak CoE: it keeps no diagnosis history.</source>
            <translation>Dieser Slave spricht kein CoE: Er führt keine Diagnosehistorie.</translation>
        </message>
        <message>
            <source>The history can be read from PREOP on: lead the slave there first.</source>
            <translation>Die Historie lässt sich ab PREOP lesen: Führen Sie den Slave zuerst dorthin.</translation>
        </message>
        <message>
            <source>The history is empty.</source>
            <translation>Die Historie ist leer.</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>%1 of at most %2 messages. Newest: %3. Newest acknowledged: %4. New messages available: %5.</source>
            <translation>%1 von höchstens %2 Meldungen. Neueste: %3. Neueste quittierte: %4. Neue Meldungen vorhanden: %5.</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>ja</translation>
        </message>
        <message>
            <source>no</source>
            <translation>nein</translation>
        </message>
        <message numerus="yes">
            <source>Acknowledge %n message(s) of %1?</source>
            <translation>
                <numerusform>%n Meldung von %1 quittieren?</numerusform>
                <numerusform>%n Meldungen von %1 quittieren?</numerusform>
            </translation>
        </message>
        <message>
            <source>The messages stay in the slave until newer ones take their places, but nobody is told of them any more. The fault itself is not acknowledged by this.</source>
            <translation>Die Meldungen bleiben im Slave, bis neuere ihren Platz einnehmen, doch niemand wird mehr auf sie hingewiesen. Der Fehler selbst wird dadurch nicht quittiert.</translation>
        </message>
        <message>
            <source>Acknowledge</source>
            <translation>Quittieren</translation>
        </message>
        <message>
            <source>Export Diagnosis History</source>
            <translation>Diagnosehistorie exportieren</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>Kommagetrennte Werte (*.csv)</translation>
        </message>
        <message>
            <source>The history could not be exported.</source>
            <translation>Die Historie konnte nicht exportiert werden.</translation>
        </message>
</context>
<context>
    <name>TriggerMonitor</name>
        <message>
            <source>not armed</source>
            <translation>nicht scharf</translation>
        </message>
        <message>
            <source>armed: waits for a run</source>
            <translation>scharf: wartet auf einen Lauf</translation>
        </message>
        <message>
            <source>all of the recording was looked at</source>
            <translation>die ganze Aufzeichnung ist durchgesehen</translation>
        </message>
        <message>
            <source>looks through the recording</source>
            <translation>sieht die Aufzeichnung durch</translation>
        </message>
        <message>
            <source>fills the time before the trigger</source>
            <translation>füllt die Zeit vor dem Trigger</translation>
        </message>
        <message>
            <source>waits for the trigger</source>
            <translation>wartet auf den Trigger</translation>
        </message>
        <message>
            <source>triggered</source>
            <translation>ausgelöst</translation>
        </message>
        <message>
            <source>holds off</source>
            <translation>Sperrzeit</translation>
        </message>
        <message>
            <source>done: triggered once</source>
            <translation>fertig: einmal ausgelöst</translation>
        </message>
</context>
<context>
    <name>TriggerPanel</name>
        <message>
            <source>A signal, in every cycle of it, an event, or a finding</source>
            <translation>Ein Signal in jedem seiner Zyklen, ein Ereignis oder ein Befund</translation>
        </message>
        <message>
            <source>A finding</source>
            <translation>Ein Befund</translation>
        </message>
        <message>
            <source>Finding of the trigger</source>
            <translation>Befund des Triggers</translation>
        </message>
        <message>
            <source>Which finding; it counts at the moment at which it began, and one that is of the whole run has none</source>
            <translation>Welcher Befund; er zählt in dem Augenblick, in dem er begann, und einer des ganzen Laufs hat keinen</translation>
        </message>
        <message>
            <source>SM2 events missed</source>
            <translation>Verpasste SM2-Ereignisse</translation>
        </message>
        <message>
            <source>Frames lost in a cycle</source>
            <translation>Verlorene Rahmen in einem Zyklus</translation>
        </message>
        <message>
            <source>Deviation of a slave</source>
            <translation>Abweichung eines Slaves</translation>
        </message>
        <message>
            <source>Arrival phase of a slave</source>
            <translation>Ankunftsphase eines Slaves</translation>
        </message>
        <message>
            <source>Setpoint slips of a slave</source>
            <translation>Sollwert-Aussetzer eines Slaves</translation>
        </message>
        <message>
            <source>Trigger</source>
            <translation>Trigger</translation>
        </message>
        <message>
            <source>What the trigger watches</source>
            <translation>Was der Trigger beobachtet</translation>
        </message>
        <message>
            <source>Slave of the trigger</source>
            <translation>Slave des Triggers</translation>
        </message>
        <message>
            <source>Whose signal or event</source>
            <translation>Wessen Signal oder Ereignis</translation>
        </message>
        <message>
            <source>Condition of the trigger</source>
            <translation>Bedingung des Triggers</translation>
        </message>
        <message>
            <source>What the signal does</source>
            <translation>Was das Signal tut</translation>
        </message>
        <message>
            <source>rises to</source>
            <translation>steigt auf</translation>
        </message>
        <message>
            <source>falls to</source>
            <translation>fällt auf</translation>
        </message>
        <message>
            <source>crosses</source>
            <translation>kreuzt</translation>
        </message>
        <message>
            <source>leaves</source>
            <translation>verlässt</translation>
        </message>
        <message>
            <source>enters</source>
            <translation>betritt</translation>
        </message>
        <message>
            <source>Event of the trigger</source>
            <translation>Ereignis des Triggers</translation>
        </message>
        <message>
            <source>Which event</source>
            <translation>Welches Ereignis</translation>
        </message>
        <message>
            <source>Level of the trigger</source>
            <translation>Pegel des Triggers</translation>
        </message>
        <message>
            <source>The level, in the unit of the signal</source>
            <translation>Der Pegel, in der Einheit des Signals</translation>
        </message>
        <message>
            <source>Lower edge of the band</source>
            <translation>Untere Grenze des Bandes</translation>
        </message>
        <message>
            <source>Lower edge of the band; it belongs to the band</source>
            <translation>Untere Grenze des Bandes; sie gehört zum Band</translation>
        </message>
        <message>
            <source>Upper edge of the band</source>
            <translation>Obere Grenze des Bandes</translation>
        </message>
        <message>
            <source>Upper edge of the band; it belongs to the band</source>
            <translation>Obere Grenze des Bandes; sie gehört zum Band</translation>
        </message>
        <message>
            <source>Absolute</source>
            <translation>Betrag</translation>
        </message>
        <message>
            <source>Absolute value</source>
            <translation>Absoluter Wert</translation>
        </message>
        <message>
            <source>Whatever the sign of the signal is</source>
            <translation>Gleich welches Vorzeichen das Signal hat</translation>
        </message>
        <message>
            <source>Mode of the trigger</source>
            <translation>Betriebsart des Triggers</translation>
        </message>
        <message>
            <source>Automatic: the plots go on following. Normal: they move to the newest episode. Single: they stop at the first one.</source>
            <translation>Automatisch: Die Kurven folgen weiter. Normal: Sie gehen zur neuesten Episode. Einzeln: Sie halten bei der ersten an.</translation>
        </message>
        <message>
            <source>Automatic</source>
            <translation>Automatisch</translation>
        </message>
        <message>
            <source>Normal</source>
            <translation>Normal</translation>
        </message>
        <message>
            <source>Single</source>
            <translation>Einzeln</translation>
        </message>
        <message>
            <source>Time before the trigger</source>
            <translation>Zeit vor dem Trigger</translation>
        </message>
        <message>
            <source>What of the time before belongs to an episode</source>
            <translation>Was von der Zeit davor zu einer Episode gehört</translation>
        </message>
        <message>
            <source>Time after the trigger</source>
            <translation>Zeit nach dem Trigger</translation>
        </message>
        <message>
            <source>What of the time after belongs to an episode</source>
            <translation>Was von der Zeit danach zu einer Episode gehört</translation>
        </message>
        <message>
            <source>Hold-off</source>
            <translation>Sperrzeit</translation>
        </message>
        <message>
            <source>For so long after a trigger no other episode begins; those left out are counted</source>
            <translation>So lange nach einem Trigger beginnt keine weitere Episode; ausgelassene werden gezählt</translation>
        </message>
        <message>
            <source>Arm</source>
            <translation>Scharf</translation>
        </message>
        <message>
            <source>Arm the trigger</source>
            <translation>Trigger scharf schalten</translation>
        </message>
        <message>
            <source>State of the trigger</source>
            <translation>Zustand des Triggers</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>Davor</translation>
        </message>
        <message>
            <source>After</source>
            <translation>Danach</translation>
        </message>
        <message>
            <source>Save the episode</source>
            <translation>Episode sichern</translation>
        </message>
        <message>
            <source>Save…</source>
            <translation>Sichern …</translation>
        </message>
        <message>
            <source>Export the episode as CSV</source>
            <translation>Episode als CSV exportieren</translation>
        </message>
        <message>
            <source>CSV…</source>
            <translation>CSV …</translation>
        </message>
        <message>
            <source>The samples of the chosen episode, before and after included, as comma-separated values</source>
            <translation>Die Werte der gewählten Episode, mit davor und danach, durch Kommas getrennt</translation>
        </message>
        <message>
            <source>Episodes of the trigger</source>
            <translation>Episoden des Triggers</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Zyklus</translation>
        </message>
        <message>
            <source>Cause</source>
            <translation>Ursache</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Enter or a double click shows the episode in the plots; F2 names it</source>
            <translation>Eingabe oder Doppelklick zeigt die Episode in den Kurven; F2 benennt sie</translation>
        </message>
        <message>
            <source>An event</source>
            <translation>Ein Ereignis</translation>
        </message>
        <message>
            <source>Any slave</source>
            <translation>Alle Slaves</translation>
        </message>
        <message>
            <source>%1 %2: %3</source>
            <translation>%1 %2: %3</translation>
        </message>
        <message>
            <source> (%1 more in the hold-off)</source>
            <translation> (%1 weitere in der Sperrzeit)</translation>
        </message>
        <message>
            <source>What is shown is a recording already</source>
            <translation>Was gezeigt wird, ist schon eine Aufzeichnung</translation>
        </message>
        <message>
            <source>A recording of the chosen episode, out of memory</source>
            <translation>Eine Aufzeichnung der gewählten Episode, aus dem Speicher</translation>
        </message>
        <message>
            <source>A watched variable</source>
            <translation>Eine beobachtete Variable</translation>
        </message>
        <message>
            <source>Variable of the trigger</source>
            <translation>Variable des Triggers</translation>
        </message>
        <message>
            <source>Which variable; they are watched on the page Variables</source>
            <translation>Welche Variable; beobachtet werden sie auf der Seite Variablen</translation>
        </message>
        <message>
            <source>, %1 within the hold-off</source>
            <translation>, %1 innerhalb der Sperrzeit</translation>
        </message>
</context>
<context>
    <name>CableTip</name>
        <message>
            <source>%1 port %2</source>
            <translation>%1 Port %2</translation>
        </message>
        <message>
            <source>The link is up.</source>
            <translation>Der Link steht.</translation>
        </message>
        <message>
            <source>The cable is broken: nothing comes back over it.</source>
            <translation>Das Kabel ist unterbrochen: Darüber kommt nichts zurück.</translation>
        </message>
        <message>
            <source>%1 does not answer.</source>
            <translation>%1 antwortet nicht.</translation>
        </message>
        <message>
            <source>Offline: the link is not known.</source>
            <translation>Offline: Der Link ist nicht bekannt.</translation>
        </message>
        <message>
            <source>%1: not read yet</source>
            <translation>%1: noch nicht gelesen</translation>
        </message>
        <message>
            <source>%1 does not answer: no counters</source>
            <translation>%1 antwortet nicht: keine Zähler</translation>
        </message>
        <message>
            <source>%1, read %2:</source>
            <translation>%1, gelesen %2:</translation>
        </message>
        <message>
            <source>invalid frames %1, receive errors %2</source>
            <translation>ungültige Frames %1, Empfangsfehler %2</translation>
        </message>
        <message>
            <source>forwarded errors %1, lost links %2</source>
            <translation>weitergeleitete Fehler %1, Linkverluste %2</translation>
        </message>
        <message>
            <source>Here frames are damaged first: begin with this cable and its plugs.</source>
            <translation>Hier werden Frames zuerst beschädigt: Beginnen Sie mit diesem Kabel und seinen Steckern.</translation>
        </message>
        <message>
            <source>Frames were damaged or the link was lost on this cable.</source>
            <translation>Auf diesem Kabel wurden Frames beschädigt, oder der Link ging verloren.</translation>
        </message>
        <message>
            <source>Only forwarded errors: the frames were damaged on another cable.</source>
            <translation>Nur weitergeleitete Fehler: Beschädigt wurden die Frames auf einem anderen Kabel.</translation>
        </message>
        <message>
            <source>Cable: %1 to %2</source>
            <translation>Kabel: %1 nach %2</translation>
        </message>
        <message>
            <source>Click the number for the error counters of %1.</source>
            <translation>Ein Klick auf die Zahl führt zu den Fehlerzählern von %1.</translation>
        </message>
</context>
    <context>
        <name>TemplateCommands</name>
        <message>
            <source>Save as Template</source>
            <translation>Als Vorlage sichern</translation>
        </message>
        <message>
            <source>Name of the template:</source>
            <translation>Name der Vorlage:</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Sichern</translation>
        </message>
        <message>
            <source>There is a template %1 already.</source>
            <translation>Es gibt schon eine Vorlage %1.</translation>
        </message>
        <message>
            <source>What it holds is lost when it is replaced.</source>
            <translation>Was sie enthält, geht verloren, wenn sie ersetzt wird.</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>Ersetzen</translation>
        </message>
        <message>
            <source>Template</source>
            <translation>Vorlage</translation>
        </message>
        <message>
            <source>The template could not be saved.</source>
            <translation>Die Vorlage konnte nicht gesichert werden.</translation>
        </message>
        <message>
            <source>Saved the template %1</source>
            <translation>Die Vorlage %1 ist gesichert</translation>
        </message>
        <message>
            <source>The template %1 cannot be read.</source>
            <translation>Die Vorlage %1 kann nicht gelesen werden.</translation>
        </message>
        <message>
            <source>Remove the template %1?</source>
            <translation>Die Vorlage %1 entfernen?</translation>
        </message>
        <message>
            <source>Projects that were begun with it stay as they are.</source>
            <translation>Projekte, die mit ihr begonnen wurden, bleiben, wie sie sind.</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>The template %1 could not be removed.</source>
            <translation>Die Vorlage %1 konnte nicht entfernt werden.</translation>
        </message>
</context>
<context>
    <name>VariableModel</name>
        <message>
            <source>%1, byte %2 bit %3 of the process image's %4</source>
            <translation>%1, Byte %2 Bit %3 der %4 des Prozessabbilds</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Richtung</translation>
        </message>
        <message>
            <source>Forced</source>
            <translation>Erzwungen</translation>
        </message>
        <message>
            <source>Hex</source>
            <translation>Hex</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Eingang</translation>
        </message>
        <message>
            <source>Output</source>
            <translation>Ausgang</translation>
        </message>
        <message>
            <source>inputs</source>
            <translation>Eingänge</translation>
        </message>
        <message>
            <source>outputs</source>
            <translation>Ausgänge</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Lage</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Typ</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Variable</source>
            <translation>Variable</translation>
        </message>
        <message>
            <source>forced</source>
            <translation>erzwungen</translation>
        </message>
        <message>
            <source>Not known: it does not come back, or its slave does not exchange process data.</source>
            <translation>Nicht bekannt: Sie kommt nicht zurück, oder ihr Slave tauscht keine Prozessdaten aus.</translation>
        </message>
        <message>
            <source>Monitor</source>
            <translation>Monitor</translation>
        </message>
        <message>
            <source>watched</source>
            <translation>beobachtet</translation>
        </message>
</context>
<context>
    <name>VariablesPage</name>
        <message>
            <source>Variables</source>
            <translation>Variablen</translation>
        </message>
        <message>
            <source>The process image has %1 for inputs and %2 for outputs, with gaps and addresses that both use. Values are shown while the machine runs.</source>
            <translation>Im Prozessabbild sind %1 für Eingänge und %2 für Ausgänge, mit Lücken und gemeinsamen Adressen. Werte werden gezeigt, während die Maschine läuft.</translation>
        </message>
        <message>
            <source>%1 is an input.</source>
            <translation>%1 ist ein Eingang.</translation>
        </message>
        <message>
            <source>&amp;Force</source>
            <translation>&amp;Erzwingen</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>Erzwingen</translation>
        </message>
        <message>
            <source>All</source>
            <translation>Alle</translation>
        </message>
        <message>
            <source>All variables</source>
            <translation>Alle Variablen</translation>
        </message>
        <message>
            <source>Choose an output to force it.</source>
            <translation>Wählen Sie einen Ausgang, um ihn zu erzwingen.</translation>
        </message>
        <message>
            <source>Cycle %1</source>
            <translation>Zyklus %1</translation>
        </message>
        <message>
            <source>Force no output any more</source>
            <translation>Keinen Ausgang mehr erzwingen</translation>
        </message>
        <message>
            <source>Force outputs of the running machine?</source>
            <translation>Ausgänge der laufenden Maschine erzwingen?</translation>
        </message>
        <message>
            <source>Forced</source>
            <translation>Erzwungen</translation>
        </message>
        <message>
            <source>Hold the output at this value, whatever the application calculates</source>
            <translation>Den Ausgang auf diesem Wert halten, was immer die Anwendung berechnet</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Eingänge</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>Ausgänge</translation>
        </message>
        <message>
            <source>Let the application set this output again</source>
            <translation>Diesen Ausgang wieder der Anwendung überlassen</translation>
        </message>
        <message>
            <source>Name, type, or place</source>
            <translation>Name, Typ oder Lage</translation>
        </message>
        <message>
            <source>No slave that runs has this station address and identity.</source>
            <translation>Kein Slave, der läuft, hat diese Stationsadresse und Identität.</translation>
        </message>
        <message>
            <source>Outputs that are forced</source>
            <translation>Ausgänge, die erzwungen sind</translation>
        </message>
        <message>
            <source>Re&amp;lease</source>
            <translation>&amp;Freigeben</translation>
        </message>
        <message>
            <source>Release All</source>
            <translation>Alle freigeben</translation>
        </message>
        <message>
            <source>Search variables</source>
            <translation>Variablen suchen</translation>
        </message>
        <message>
            <source>Selected variable</source>
            <translation>Ausgewählte Variable</translation>
        </message>
        <message>
            <source>The project cannot be compiled: the messages say why.</source>
            <translation>Das Projekt kann nicht übersetzt werden: Die Meldungen sagen, warum.</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Value to force, decimal or with 0x</source>
            <translation>Zu erzwingender Wert, dezimal oder mit 0x</translation>
        </message>
        <message>
            <source>Variables of the process image</source>
            <translation>Variablen des Prozessabbilds</translation>
        </message>
        <message>
            <source>What the slaves are sent</source>
            <translation>Was den Slaves gesendet wird</translation>
        </message>
        <message>
            <source>What the slaves send</source>
            <translation>Was die Slaves senden</translation>
        </message>
        <message>
            <source>What the values are</source>
            <translation>Was die Werte sind</translation>
        </message>
        <message>
            <source>What they drive moves or switches at once, whatever the application and its interlocks say. They stay forced until they are released or the machine goes offline. This is asked once a run.</source>
            <translation>Was sie ansteuern, bewegt sich oder schaltet sofort, was immer die Anwendung und ihre Verriegelungen sagen. Sie bleiben erzwungen, bis sie freigegeben werden oder die Maschine offline geht. Gefragt wird einmal je Lauf.</translation>
        </message>
        <message>
            <source>Which variables are shown</source>
            <translation>Welche Variablen gezeigt werden</translation>
        </message>
        <message numerus="yes">
            <source>%n input(s) not known: they do not come back, or their slaves exchange none</source>
            <translation>
                <numerusform>%n Eingang nicht bekannt: Er kommt nicht zurück, oder sein Slave tauscht keine aus</numerusform>
                <numerusform>%n Eingänge nicht bekannt: Sie kommen nicht zurück, oder ihre Slaves tauschen keine aus</numerusform>
            </translation>
        </message>
        <message>
            <source>Watch in the Monitor</source>
            <translation>Im Monitor beobachten</translation>
        </message>
        <message>
            <source>&amp;Watch in the Monitor</source>
            <translation>Im &amp;Monitor beobachten</translation>
        </message>
        <message>
            <source>Record the variable in every cycle and draw it below the plots</source>
            <translation>Die Variable in jedem Zyklus aufzeichnen und unter den Kurven zeichnen</translation>
        </message>
        <message>
            <source>%1 variables are watched already: take one away first</source>
            <translation>Es werden schon %1 Variablen beobachtet: erst eine wegnehmen</translation>
        </message>
</context>
<context>
    <name>InitCommandsPage</name>
    <message numerus="yes">
        <source>%n command(s), in the order of the ENI. Those of mailboxes are set on the page Start-up of a slave, those of registers below.</source>
        <translation>
            <numerusform>%n Kommando, in der Reihenfolge der ENI. Die der Mailboxen stehen auf der Seite Start eines Slaves, die der Register unten.</numerusform>
            <numerusform>%n Kommandos, in der Reihenfolge der ENI. Die der Mailboxen stehen auf der Seite Start eines Slaves, die der Register unten.</numerusform>
        </translation>
    </message>
    <message>
        <source>register command</source>
        <translation>Registerkommando</translation>
    </message>
    <message>
        <source>Own register commands to all slaves</source>
        <translation>Eigene Registerkommandos an alle Slaves</translation>
    </message>
    <message>
        <source>Own register commands</source>
        <translation>Eigene Registerkommandos</translation>
    </message>
    <message>
        <source>None: the commands above are all.</source>
        <translation>Keine: die Kommandos oben sind alle.</translation>
    </message>
    <message>
        <source>Own, below</source>
        <translation>Eigenes, unten</translation>
    </message>
        <message numerus="yes">
            <source>%n zero byte(s)</source>
            <translation>
                <numerusform>%n Nullbyte</numerusform>
                <numerusform>%n Nullbytes</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n repeat(s)</source>
            <translation>
                <numerusform>%n Wiederholung</numerusform>
                <numerusform>%n Wiederholungen</numerusform>
            </translation>
        </message>
        <message>
            <source>counter %1</source>
            <translation>Zähler %1</translation>
        </message>
        <message>
            <source>within %1 ms</source>
            <translation>innerhalb von %1 ms</translation>
        </message>
        <message>
            <source>(off)</source>
            <translation>(aus)</translation>
        </message>
        <message>
            <source>Init Commands (Expert)</source>
            <translation>Init-Kommandos (Experte)</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Transition</source>
            <translation>Übergang</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>Kommando</translation>
        </message>
        <message>
            <source>To</source>
            <translation>An</translation>
        </message>
        <message>
            <source>Data</source>
            <translation>Daten</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>Antwort</translation>
        </message>
        <message>
            <source>Comment</source>
            <translation>Kommentar</translation>
        </message>
        <message>
            <source>Search init commands</source>
            <translation>Init-Kommandos suchen</translation>
        </message>
        <message>
            <source>Transition, register, object, or comment</source>
            <translation>Übergang, Register, Objekt oder Kommentar</translation>
        </message>
        <message>
            <source>Init commands</source>
            <translation>Init-Kommandos</translation>
        </message>
        <message>
            <source>The project cannot be compiled: the messages say why.</source>
            <translation>Das Projekt kann nicht übersetzt werden: Die Meldungen sagen, warum.</translation>
        </message>
        <message>
            <source>Origin</source>
            <translation>Herkunft</translation>
        </message>
        <message>
            <source>State machine</source>
            <translation>Zustandsmaschine</translation>
        </message>
        <message>
            <source>Addresses</source>
            <translation>Adressen</translation>
        </message>
        <message>
            <source>Check of the device</source>
            <translation>Prüfung des Geräts</translation>
        </message>
        <message>
            <source>SyncManagers</source>
            <translation>SyncManager</translation>
        </message>
        <message>
            <source>Process image</source>
            <translation>Prozessabbild</translation>
        </message>
        <message>
            <source>Distributed clocks</source>
            <translation>Distributed Clocks</translation>
        </message>
        <message>
            <source>Watchdogs</source>
            <translation>Watchdogs</translation>
        </message>
        <message>
            <source>Ports</source>
            <translation>Ports</translation>
        </message>
        <message>
            <source>PDO assignment</source>
            <translation>PDO-Zuordnung</translation>
        </message>
        <message>
            <source>PDO mapping</source>
            <translation>PDO-Mapping</translation>
        </message>
        <message>
            <source>ESI</source>
            <translation>ESI</translation>
        </message>
        <message>
            <source>Page Start-up</source>
            <translation>Seite Start</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>Einstellungen</translation>
        </message>
</context>
<context>
    <name>FramesPage</name>
        <message>
            <source>Frames and Cost</source>
            <translation>Frames und Aufwand</translation>
        </message>
        <message>
            <source>What a cycle costs</source>
            <translation>Was ein Zyklus kostet</translation>
        </message>
        <message>
            <source>Cyclic frames</source>
            <translation>Zyklische Frames</translation>
        </message>
        <message>
            <source>Frame</source>
            <translation>Frame</translation>
        </message>
        <message>
            <source>Every</source>
            <translation>Alle</translation>
        </message>
        <message>
            <source>Datagrams</source>
            <translation>Datagramme</translation>
        </message>
        <message>
            <source>Bytes</source>
            <translation>Bytes</translation>
        </message>
        <message>
            <source>Process data</source>
            <translation>Prozessdaten</translation>
        </message>
        <message>
            <source>Wire time</source>
            <translation>Leitungszeit</translation>
        </message>
        <message>
            <source>Datagrams of the selected frame</source>
            <translation>Datagramme des ausgewählten Frames</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>Kommando</translation>
        </message>
        <message>
            <source>Counter</source>
            <translation>Zähler</translation>
        </message>
        <message>
            <source>Sent in</source>
            <translation>Gesendet in</translation>
        </message>
        <message>
            <source>Comment</source>
            <translation>Kommentar</translation>
        </message>
        <message>
            <source>Slaves, the costliest first</source>
            <translation>Slaves, die aufwendigsten zuerst</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>Slave</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>Ausgänge</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Eingänge</translation>
        </message>
        <message>
            <source>Bytes in datagrams</source>
            <translation>Bytes in Datagrammen</translation>
        </message>
        <message>
            <source>Objects that could be exchanged by SDO instead</source>
            <translation>Objekte, die stattdessen per SDO ausgetauscht werden könnten</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>PDO</source>
            <translation>PDO</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>Saves</source>
            <translation>Spart</translation>
        </message>
        <message>
            <source>The project cannot be compiled: the messages say why.</source>
            <translation>Das Projekt kann nicht übersetzt werden: Die Meldungen sagen, warum.</translation>
        </message>
        <message>
            <source>Outputs %1, inputs %2, frames in a cycle of %4: %3. They take %5 on the wire, %6 % of the bandwidth.</source>
            <translation>Ausgänge %1, Eingänge %2, Frames in einem Zyklus von %4: %3. Sie brauchen %5 auf der Leitung, %6 % der Bandbreite.</translation>
        </message>
        <message>
            <source>The last frame is back after about %1.</source>
            <translation>Das letzte Frame ist nach etwa %1 zurück.</translation>
        </message>
        <message>
            <source>That is longer than the cycle.</source>
            <translation>Das ist länger als der Zyklus.</translation>
        </message>
</context>
<context>
    <name>NetworkCommands</name>
        <message>
            <source>Ne&amp;xt Network</source>
            <translation>Nä&amp;chstes Netzwerk</translation>
        </message>
        <message>
            <source>Work on the next network of the machine</source>
            <translation>Am nächsten Netzwerk der Maschine arbeiten</translation>
        </message>
        <message>
            <source>&amp;Add Network</source>
            <translation>Netzwerk &amp;hinzufügen</translation>
        </message>
        <message>
            <source>Add a network without slaves to the machine</source>
            <translation>Der Maschine ein Netzwerk ohne Slaves hinzufügen</translation>
        </message>
        <message>
            <source>Re&amp;move Network…</source>
            <translation>Netzwerk entfernen …</translation>
        </message>
        <message>
            <source>Take the network in work out of the machine</source>
            <translation>Das bearbeitete Netzwerk aus der Maschine nehmen</translation>
        </message>
        <message>
            <source>Network %1</source>
            <translation>Netzwerk %1</translation>
        </message>
        <message>
            <source>Take %1 out of the machine?</source>
            <translation>%1 aus der Maschine nehmen?</translation>
        </message>
        <message numerus="yes">
            <source>Its %n slave(s) go with it. That cannot be undone, but until the project is saved the file keeps it.</source>
            <translation>
                <numerusform>Sein %n Slave geht mit. Das lässt sich nicht rückgängig machen; bis das Projekt gespeichert wird, steht es noch in der Datei.</numerusform>
                <numerusform>Seine %n Slaves gehen mit. Das lässt sich nicht rückgängig machen; bis das Projekt gespeichert wird, steht es noch in der Datei.</numerusform>
            </translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>A bus is being scanned: wait for its slaves, or cancel the scan.</source>
            <translation>Ein Bus wird gescannt: Warten Sie auf seine Slaves, oder brechen Sie den Scan ab.</translation>
        </message>
        <message>
            <source>A recording is shown: close it first (File, Close Recording).</source>
            <translation>Eine Aufzeichnung wird gezeigt: Schließen Sie sie zuerst (Datei, Aufzeichnung schließen).</translation>
        </message>
        <message>
            <source>A slave is being written to: wait until it has been.</source>
            <translation>In einen Slave wird geschrieben: Warten Sie, bis es geschehen ist.</translation>
        </message>
        <message>
            <source>All Net&amp;works Offline</source>
            <translation>Alle Netzwer&amp;ke offline</translation>
        </message>
        <message>
            <source>Take all networks of the machine that run offline</source>
            <translation>Alle laufenden Netzwerke der Maschine offline nehmen</translation>
        </message>
</context>
<context>
    <name>FindingFixes</name>
        <message>
            <source>Show the Master</source>
            <translation>Den Master zeigen</translation>
        </message>
        <message>
            <source>Show Its Slave</source>
            <translation>Ihren Slave zeigen</translation>
        </message>
        <message>
            <source>Go to the Setting</source>
            <translation>Zur Einstellung gehen</translation>
        </message>
        <message numerus="yes">
            <source>Set %1 of %n slave(s) to %2</source>
            <translation>
                <numerusform>%1 von %n Slave auf %2 setzen</numerusform>
                <numerusform>%1 von %n Slaves auf %2 setzen</numerusform>
            </translation>
        </message>
        <message>
            <source>Set %1 to %2</source>
            <translation>%1 auf %2 setzen</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>Konfiguration</translation>
        </message>
        <message>
            <source>No single value of this setting mends it</source>
            <translation>Kein einzelner Wert dieser Einstellung behebt es</translation>
        </message>
</context>
<context>
    <name>RunState</name>
        <message>
            <source>DC: %1</source>
            <translation>DC: %1</translation>
        </message>
        <message>
            <source>DCM: %1</source>
            <translation>DCM: %1</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <source>Online</source>
            <translation>Online</translation>
        </message>
        <message>
            <source>Starting</source>
            <translation>Startet</translation>
        </message>
        <message>
            <source>Stopping</source>
            <translation>Hält an</translation>
        </message>
        <message>
            <source>no link</source>
            <translation>kein Link</translation>
        </message>
        <message>
            <source>outputs forced</source>
            <translation>Ausgänge erzwungen</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>No answer</source>
            <translation>Keine Antwort</translation>
        </message>
</context>
<context>
    <name>SyncUnitModel</name>
        <message>
            <source>Sync Unit, slave</source>
            <translation>Sync Unit, Slave</translation>
        </message>
        <message>
            <source>Process data</source>
            <translation>Prozessdaten</translation>
        </message>
        <message>
            <source>Outputs and inputs</source>
            <translation>Ausgänge und Eingänge</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>Ausgänge</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Eingänge</translation>
        </message>
        <message>
            <source>None (base task)</source>
            <translation>Keine (Basistask)</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n Slave</numerusform>
                <numerusform>%n Slaves</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>SyncUnitTree</name>
        <message>
            <source>Slaves of the Sync Units</source>
            <translation>Slaves der Sync Units</translation>
        </message>
        <message>
            <source>Drag slaves to the Sync Unit that exchanges them</source>
            <translation>Slaves zu der Sync Unit ziehen, die sie austauscht</translation>
        </message>
        <message>
            <source>Move to Sync Unit</source>
            <translation>In Sync Unit verschieben</translation>
        </message>
        <message>
            <source>Move to</source>
            <translation>Verschieben nach</translation>
        </message>
        <message>
            <source>Give the selected slaves to a Sync Unit</source>
            <translation>Die gewählten Slaves einer Sync Unit geben</translation>
        </message>
</context>
<context>
    <name>syncline::ui::SlavesView</name>
        <message numerus="yes">
            <source>%1 (and %n more here)</source>
            <translation>
                <numerusform>%1 (und %n weiteres hier)</numerusform>
                <numerusform>%1 (und %n weitere hier)</numerusform>
            </translation>
        </message>
</context>
    <context>
    <name>BlackBoxDialog</name>
        <message>
            <source>Black Box of Frames</source>
            <translation>Blackbox der Frames</translation>
        </message>
        <message>
            <source>Keeps the last frames of every run on disk, sent and received, in files that Wireshark reads. They are whole also after a crash or a power cut; the oldest are replaced.</source>
            <translation>Hält die letzten Frames jedes Laufs auf dem Datenträger, gesendete und empfangene, in Dateien, die Wireshark liest. Sie sind auch nach einem Absturz oder Stromausfall ganz; die ältesten werden ersetzt.</translation>
        </message>
        <message>
            <source>&amp;Keep the last frames of every run</source>
            <translation>Die &amp;letzten Frames jedes Laufs halten</translation>
        </message>
        <message>
            <source>Keep the last frames</source>
            <translation>Die letzten Frames halten</translation>
        </message>
        <message>
            <source>Folder of the files</source>
            <translation>Ordner der Dateien</translation>
        </message>
        <message>
            <source>&amp;Browse…</source>
            <translation>&amp;Durchsuchen …</translation>
        </message>
        <message>
            <source>Choose the folder</source>
            <translation>Den Ordner wählen</translation>
        </message>
        <message>
            <source>&amp;Folder</source>
            <translation>&amp;Ordner</translation>
        </message>
        <message>
            <source>Size of the files of a network together</source>
            <translation>Größe der Dateien eines Netzwerks zusammen</translation>
        </message>
        <message>
            <source>&amp;Size</source>
            <translation>&amp;Größe</translation>
        </message>
        <message>
            <source>How much time it holds</source>
            <translation>Wie viel Zeit sie hält</translation>
        </message>
        <message>
            <source>What it holds now</source>
            <translation>Was sie jetzt hält</translation>
        </message>
        <message>
            <source>OK</source>
            <translation>OK</translation>
        </message>
        <message>
            <source>Folder of the Black Box</source>
            <translation>Ordner der Blackbox</translation>
        </message>
        <message>
            <source>How much time that holds follows from the frames of a cycle: there are none yet.</source>
            <translation>Wie viel Zeit das hält, folgt aus den Frames eines Zyklus: es gibt noch keine.</translation>
        </message>
        <message>
            <source>Holds about the last %1 of this network's cycles.</source>
            <translation>Hält etwa die letzten %1 der Zyklen dieses Netzwerks.</translation>
        </message>
    </context>
    <context>
    <name>BlackBoxText</name>
        <message>
            <source>The last %1 of the run, %2 frames, in %3</source>
            <translation>Die letzten %1 des Laufs, %2 Frames, in %3</translation>
        </message>
        <message numerus="yes">
            <source>%n file(s), %1</source>
            <translation>
                <numerusform>%n Datei, %1</numerusform>
                <numerusform>%n Dateien, %1</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 frames are missing: the disk was too slow</source>
            <translation>%1 Frames fehlen: der Datenträger war zu langsam</translation>
        </message>
        <message>
            <source>No frame of the run yet</source>
            <translation>Noch kein Frame des Laufs</translation>
        </message>
    </context>
<context>
    <name>AcceptanceText</name>
    <message>
        <source>%1 for %2</source>
        <translation>%1 seit %2</translation>
    </message>
    <message>
        <source>; no value since it was armed</source>
        <translation>; kein Wert seit der Scharfschaltung</translation>
    </message>
    <message>
        <source>; largest %1 ns</source>
        <translation>; größter Wert %1 ns</translation>
    </message>
    <message>
        <source>, over the limit</source>
        <translation>, über dem Grenzwert</translation>
    </message>
    <message>
        <source>, %1 % margin</source>
        <translation>, %1 % Reserve</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Not accepted</source>
        <translation>Nicht angenommen</translation>
    </message>
    <message>
        <source>Not proven</source>
        <translation>Nicht nachgewiesen</translation>
    </message>
    <message>
        <source>in sync throughout, within ±%1 ns</source>
        <translation>durchweg synchron, innerhalb ±%1 ns</translation>
    </message>
    <message>
        <source>, %1 % to spare</source>
        <translation>, %1 % Reserve</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>höchstens %1</translation>
    </message>
    <message numerus="yes">
        <source>, lost %n time(s)</source>
        <translation><numerusform>, %n-mal verloren</numerusform><numerusform>, %n-mal verloren</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n episode(s)</source>
        <translation><numerusform>%n Episode</numerusform><numerusform>%n Episoden</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation><numerusform>%n Fehler</numerusform><numerusform>%n Fehler</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation><numerusform>%n Warnung</numerusform><numerusform>%n Warnungen</numerusform></translation>
    </message>
        <message>
            <source>; largest that lasted %1 ns</source>
            <translation>; größter anhaltender %1 ns</translation>
        </message>
</context>
<context>
    <name>CommissioningDialog</name>
    <message>
        <source>Commissioning Report</source>
        <translation>Inbetriebnahmebericht</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Maschine</translation>
    </message>
    <message>
        <source>Least time that it was watched for, minutes</source>
        <translation>Kürzeste Beobachtungszeit, Minuten</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>&amp;Watched for at least</source>
        <translation>&amp;Beobachtet mindestens</translation>
    </message>
    <message>
        <source>Least m&amp;argin</source>
        <translation>Kleinste &amp;Reserve</translation>
    </message>
    <message>
        <source>Least margin to the limits, percent</source>
        <translation>Kleinste Reserve zu den Grenzwerten, Prozent</translation>
    </message>
    <message>
        <source>SM2 &amp;events missed at most</source>
        <translation>Verpasste SM2-&amp;Ereignisse höchstens</translation>
    </message>
    <message>
        <source>Most SM2 events missed</source>
        <translation>Höchstzahl verpasster SM2-Ereignisse</translation>
    </message>
    <message>
        <source>&amp;Frames lost at most</source>
        <translation>Verlorene &amp;Frames höchstens</translation>
    </message>
    <message>
        <source>Most frames lost</source>
        <translation>Höchstzahl verlorener Frames</translation>
    </message>
    <message>
        <source>Wr&amp;ong working counters at most</source>
        <translation>Falsche &amp;Working Counter höchstens</translation>
    </message>
    <message>
        <source>Most wrong working counters</source>
        <translation>Höchstzahl falscher Working Counter</translation>
    </message>
    <message>
        <source>&amp;Cycles left out at most</source>
        <translation>Ausgelassene &amp;Zyklen höchstens</translation>
    </message>
    <message>
        <source>Most cycles left out</source>
        <translation>Höchstzahl ausgelassener Zyklen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Gefordert</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Write &amp;Page…</source>
        <translation>&amp;Seite schreiben …</translation>
    </message>
    <message>
        <source>Write the page</source>
        <translation>Seite schreiben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Write Page</source>
        <translation>Seite schreiben</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>The page could not be written.</source>
        <translation>Die Seite konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>Inbetriebnahme</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>MemoryDialog</name>
        <message>
            <source>Memory for the Last Cycles</source>
            <translation>Speicher für die letzten Zyklen</translation>
        </message>
        <message>
            <source>Every cycle of a run is kept in memory, so that the last stretch can be saved afterwards. The oldest go when the memory is full.</source>
            <translation>Jeder Zyklus eines Laufs bleibt im Speicher, damit das letzte Stück nachträglich gesichert werden kann. Ist der Speicher voll, gehen die ältesten.</translation>
        </message>
        <message>
            <source>Memory for each network</source>
            <translation>Speicher je Netzwerk</translation>
        </message>
        <message>
            <source>&amp;Memory for each network</source>
            <translation>&amp;Speicher je Netzwerk</translation>
        </message>
        <message>
            <source>How much time it holds</source>
            <translation>Wie viel Zeit er fasst</translation>
        </message>
        <message>
            <source>What is forgotten at once</source>
            <translation>Was sofort vergessen wird</translation>
        </message>
        <message>
            <source>OK</source>
            <translation>OK</translation>
        </message>
        <message>
            <source>How much time that is follows from the cycle time: nothing has run yet.</source>
            <translation>Wie viel Zeit das ist, folgt aus der Zykluszeit: noch ist nichts gelaufen.</translation>
        </message>
        <message>
            <source>Holds every cycle of about the last %1 of this network.</source>
            <translation>Fasst jeden Zyklus von etwa den letzten %1 dieses Netzwerks.</translation>
        </message>
        <message>
            <source>The last %1 are in memory: what is older than that goes at once.</source>
            <translation>Die letzten %1 sind im Speicher: was älter ist, geht sofort.</translation>
        </message>
</context>
<context>
    <name>ReplayBar</name>
        <message>
            <source>Replay of the recording</source>
            <translation>Wiedergabe der Aufzeichnung</translation>
        </message>
        <message>
            <source>To the &amp;Beginning</source>
            <translation>Zum &amp;Anfang</translation>
        </message>
        <message>
            <source>To the beginning of the recording</source>
            <translation>Zum Anfang der Aufzeichnung</translation>
        </message>
        <message>
            <source>Pre&amp;vious Event</source>
            <translation>&amp;Voriges Ereignis</translation>
        </message>
        <message>
            <source>To the event or note before</source>
            <translation>Zum Ereignis oder zur Notiz davor</translation>
        </message>
        <message>
            <source>Cycle B&amp;ack</source>
            <translation>Zyklus &amp;zurück</translation>
        </message>
        <message>
            <source>A cycle back</source>
            <translation>Einen Zyklus zurück</translation>
        </message>
        <message>
            <source>&amp;Play</source>
            <translation>A&amp;bspielen</translation>
        </message>
        <message>
            <source>&amp;Pause</source>
            <translation>An&amp;halten</translation>
        </message>
        <message>
            <source>Play the recording as it was live, or pause</source>
            <translation>Die Aufzeichnung abspielen, wie sie live war, oder anhalten</translation>
        </message>
        <message>
            <source>Cycle &amp;Further</source>
            <translation>Zyklus &amp;weiter</translation>
        </message>
        <message>
            <source>A cycle further</source>
            <translation>Einen Zyklus weiter</translation>
        </message>
        <message>
            <source>&amp;Next Event</source>
            <translation>&amp;Nächstes Ereignis</translation>
        </message>
        <message>
            <source>To the next event or note</source>
            <translation>Zum nächsten Ereignis oder zur nächsten Notiz</translation>
        </message>
        <message>
            <source>To the &amp;End</source>
            <translation>Zum &amp;Ende</translation>
        </message>
        <message>
            <source>To the end of the recording</source>
            <translation>Zum Ende der Aufzeichnung</translation>
        </message>
        <message>
            <source>&amp;Slower</source>
            <translation>&amp;Langsamer</translation>
        </message>
        <message>
            <source>Play slower</source>
            <translation>Langsamer abspielen</translation>
        </message>
        <message>
            <source>Fas&amp;ter</source>
            <translation>&amp;Schneller</translation>
        </message>
        <message>
            <source>Play faster</source>
            <translation>Schneller abspielen</translation>
        </message>
        <message>
            <source>&amp;Whole Recording</source>
            <translation>&amp;Ganze Aufzeichnung</translation>
        </message>
        <message>
            <source>Show the whole recording again (Esc in the plots or in this bar)</source>
            <translation>Wieder die ganze Aufzeichnung zeigen (Esc in den Kurven oder in dieser Leiste)</translation>
        </message>
        <message>
            <source>Speed of the replay</source>
            <translation>Geschwindigkeit der Wiedergabe</translation>
        </message>
        <message>
            <source>How fast the recording is played, against the time of the run (Alt+Minus, Alt+Plus)</source>
            <translation>Wie schnell die Aufzeichnung abgespielt wird, gemessen an der Zeit des Laufs (Alt+Minus, Alt+Plus)</translation>
        </message>
        <message>
            <source>Real time</source>
            <translation>Echtzeit</translation>
        </message>
        <message>
            <source>Moment of the recording</source>
            <translation>Zeitpunkt der Aufzeichnung</translation>
        </message>
        <message>
            <source>The moment that is shown; ticks are events and notes</source>
            <translation>Der Zeitpunkt, der gezeigt wird; Striche sind Ereignisse und Notizen</translation>
        </message>
        <message>
            <source>Time of the replay</source>
            <translation>Zeit der Wiedergabe</translation>
        </message>
        <message>
            <source>Whole</source>
            <translation>Ganze</translation>
        </message>
        <message>
            <source>Show the whole recording</source>
            <translation>Die ganze Aufzeichnung zeigen</translation>
        </message>
        <message>
            <source>%1 of %2 s</source>
            <translation>%1 von %2 s</translation>
        </message>
</context>
<context>
    <name>OverlayBar</name>
        <message>
            <source>Recording laid over the one that is shown</source>
            <translation>Aufzeichnung, die über der gezeigten liegt</translation>
        </message>
        <message>
            <source>Aligned by</source>
            <translation>Ausgerichtet an</translation>
        </message>
        <message>
            <source>By what the two recordings are aligned</source>
            <translation>Woran die beiden Aufzeichnungen ausgerichtet sind</translation>
        </message>
        <message>
            <source>Beginnings</source>
            <translation>Anfängen</translation>
        </message>
        <message>
            <source>Armed</source>
            <translation>Scharfstellen</translation>
        </message>
        <message>
            <source>First trigger</source>
            <translation>erstem Trigger</translation>
        </message>
        <message>
            <source>Hand</source>
            <translation>Hand</translation>
        </message>
        <message>
            <source>What lies over each other: the first cycles, the moments at which figures were armed (in OP and in sync), or the first episodes of the trigger as it is set in the panel Trigger</source>
            <translation>Was übereinander liegt: die ersten Zyklen, die Zeitpunkte, ab denen die Zahlen zählen (in OP und synchron), oder die ersten Episoden des Triggers, wie er im Feld Trigger eingestellt ist</translation>
        </message>
        <message>
            <source>later by</source>
            <translation>später um</translation>
        </message>
        <message>
            <source>How much later it is drawn</source>
            <translation>Wie viel später sie gezeichnet wird</translation>
        </message>
        <message>
            <source>How much later than with both beginnings together; arrow keys move it by a cycle. In the plots Ctrl and the arrow keys or dragging with Ctrl move it, too</source>
            <translation>Wie viel später als mit beiden Anfängen übereinander; die Pfeiltasten verschieben um einen Zyklus. In den Kurven verschieben Strg mit den Pfeiltasten und Ziehen mit Strg sie auch</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>Take the other recording away</source>
            <translation>Die andere Aufzeichnung wegnehmen</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Takes the recording that lies over this one away</source>
            <translation>Nimmt die Aufzeichnung weg, die über dieser liegt</translation>
        </message>
        <message>
            <source>One of the two recordings was not armed: it cannot be aligned so.</source>
            <translation>Eine der beiden Aufzeichnungen war nicht scharfgestellt: So kann nicht ausgerichtet werden.</translation>
        </message>
        <message>
            <source>The trigger as it is set does not occur in both recordings.</source>
            <translation>Der Trigger, wie er eingestellt ist, kommt nicht in beiden Aufzeichnungen vor.</translation>
        </message>
        <message>
            <source>Over it: %1</source>
            <translation>Darüber: %1</translation>
        </message>
</context>
<context>
    <name>OverlayFigures</name>
        <message>
            <source>Figures of both recordings over the range shown</source>
            <translation>Zahlen beider Aufzeichnungen über den gezeigten Bereich</translation>
        </message>
        <message>
            <source>Of every cycle of the range shown, at the places where the two lie over each other</source>
            <translation>Aus jedem Zyklus des gezeigten Bereichs, so wie die beiden übereinander liegen</translation>
        </message>
        <message>
            <source>rms</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>p99.99</source>
            <translation>p99.99</translation>
        </message>
        <message>
            <source>max</source>
            <translation>max</translation>
        </message>
        <message>
            <source>DC deviation: mean</source>
            <translation>DC-Abweichung: Mittel</translation>
        </message>
        <message>
            <source>DCM error: mean</source>
            <translation>DCM-Fehler: Mittel</translation>
        </message>
</context>
<context>
    <name>WindowOverlay</name>
        <message>
            <source>Overlay Another Recording</source>
            <translation>Andere Aufzeichnung darüberlegen</translation>
        </message>
        <message>
            <source>Recordings and tables (*.slrec *.csv);;All files (*)</source>
            <translation>Aufzeichnungen und Tabellen (*.slrec *.csv);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>No recording is shown that another could lie over.</source>
            <translation>Es wird keine Aufzeichnung gezeigt, über der eine andere liegen könnte.</translation>
        </message>
        <message>
            <source>Overlay</source>
            <translation>Überlagerung</translation>
        </message>
        <message>
            <source>The recording %1 could not be opened.</source>
            <translation>Die Aufzeichnung %1 konnte nicht geöffnet werden.</translation>
        </message>
</context>
<context>
    <name>Signals</name>
        <message>
            <source>Port %1: invalid frames</source>
            <translation>Port %1: ungültige Frames</translation>
        </message>
        <message>
            <source>Port %1: receive errors</source>
            <translation>Port %1: Empfangsfehler</translation>
        </message>
        <message>
            <source>Port %1: forwarded errors</source>
            <translation>Port %1: weitergeleitete Fehler</translation>
        </message>
        <message>
            <source>Port %1: lost links</source>
            <translation>Port %1: verlorene Links</translation>
        </message>
        <message>
            <source>Working counter, expected</source>
            <translation>Working Counter, erwartet</translation>
        </message>
        <message>
            <source>Working counter, received</source>
            <translation>Working Counter, empfangen</translation>
        </message>
        <message>
            <source>Frames lost in a cycle</source>
            <translation>In einem Zyklus verlorene Frames</translation>
        </message>
        <message>
            <source>Cycles left out before a cycle</source>
            <translation>Vor einem Zyklus ausgelassene Zyklen</translation>
        </message>
        <message>
            <source>Synchronisation of the slaves</source>
            <translation>Synchronisation der Slaves</translation>
        </message>
        <message>
            <source>Synchronisation of the master</source>
            <translation>Synchronisation des Masters</translation>
        </message>
        <message>
            <source>Lowest AL state of all slaves</source>
            <translation>Niedrigster AL-Zustand aller Slaves</translation>
        </message>
        <message>
            <source>Lost frames</source>
            <translation>Verlorene Frames</translation>
        </message>
        <message>
            <source>Late frames</source>
            <translation>Verspätete Frames</translation>
        </message>
        <message>
            <source>Cycles left out</source>
            <translation>Ausgelassene Zyklen</translation>
        </message>
        <message>
            <source>Wrong working counters</source>
            <translation>Falsche Working Counter</translation>
        </message>
        <message>
            <source>Frames too late for SYNC0</source>
            <translation>Frames zu spät für SYNC0</translation>
        </message>
        <message>
            <source>SM2 events missed</source>
            <translation>Verpasste SM2-Ereignisse</translation>
        </message>
        <message>
            <source>Fuse of the SM2 events</source>
            <translation>Sicherung der SM2-Ereignisse</translation>
        </message>
        <message>
            <source>Limit of the fuse</source>
            <translation>Grenze der Sicherung</translation>
        </message>
        <message>
            <source>Misses until the fuse trips</source>
            <translation>Ausfälle bis zum Auslösen</translation>
        </message>
        <message>
            <source>Cycle exceeded, outputs</source>
            <translation>Zyklus überschritten, Ausgänge</translation>
        </message>
        <message>
            <source>Cycle exceeded, inputs</source>
            <translation>Zyklus überschritten, Eingänge</translation>
        </message>
        <message>
            <source>Shift too short, outputs</source>
            <translation>Verschiebung zu kurz, Ausgänge</translation>
        </message>
        <message>
            <source>Shift too short, inputs</source>
            <translation>Verschiebung zu kurz, Eingänge</translation>
        </message>
        <message>
            <source>Clock slowed by</source>
            <translation>Uhr verlangsamt um</translation>
        </message>
        <message>
            <source>AL state</source>
            <translation>AL-Zustand</translation>
        </message>
        <message>
            <source>Process data watchdog</source>
            <translation>Prozessdaten-Watchdog</translation>
        </message>
        <message>
            <source>PDI watchdog</source>
            <translation>PDI-Watchdog</translation>
        </message>
        <message>
            <source>Processing unit errors</source>
            <translation>Fehler der Verarbeitungseinheit</translation>
        </message>
        <message>
            <source>PDI errors</source>
            <translation>PDI-Fehler</translation>
        </message>
        <message>
            <source>Propagation delay</source>
            <translation>Laufzeit</translation>
        </message>
        <message>
            <source>Setpoint slips</source>
            <translation>Sollwertaussetzer</translation>
        </message>
        <message>
            <source>Counts that may be higher</source>
            <translation>Zählwerte, die höher sein können</translation>
        </message>
        <message>
            <source>Port %1</source>
            <translation>Port %1</translation>
        </message>
        <message>
            <source>Variable</source>
            <translation>Variable</translation>
        </message>
</context>
<context>
    <name>FreeView</name>
        <message>
            <source>States</source>
            <translation>Zustände</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <source>Rate of a clock</source>
            <translation>Gang einer Uhr</translation>
        </message>
        <message>
            <source>Events</source>
            <translation>Ereignisse</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>%1, a second</source>
            <translation>%1 je Sekunde</translation>
        </message>
        <message>
            <source>DCM: error, adjustment, drift</source>
            <translation>DCM: Fehler, Stellwert, Drift</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM-Fehler</translation>
        </message>
        <message>
            <source>External clock</source>
            <translation>Externe Uhr</translation>
        </message>
        <message>
            <source>Adjustment and drift</source>
            <translation>Stellwert und Drift</translation>
        </message>
        <message>
            <source>AL states of all slaves</source>
            <translation>AL-Zustände aller Slaves</translation>
        </message>
        <message>
            <source>Frames of the bus</source>
            <translation>Frames des Busses</translation>
        </message>
        <message>
            <source>Round trip and send lateness</source>
            <translation>Umlaufzeit und Sendeverspätung</translation>
        </message>
        <message>
            <source>Counts of the bus</source>
            <translation>Zähler des Busses</translation>
        </message>
        <message>
            <source>Counters of %1</source>
            <translation>Zähler von %1</translation>
        </message>
        <message>
            <source>Errors at the ports</source>
            <translation>Fehler an den Ports</translation>
        </message>
        <message>
            <source>Counts of the device</source>
            <translation>Zähler des Geräts</translation>
        </message>
        <message>
            <source>Own plots</source>
            <translation>Eigene Diagramme</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Ansicht</translation>
        </message>
        <message>
            <source>Which view is shown; new ones, other names</source>
            <translation>Welche Ansicht gezeigt wird; neue, andere Namen</translation>
        </message>
        <message>
            <source>Add a plot</source>
            <translation>Ein Diagramm hinzufügen</translation>
        </message>
        <message>
            <source>Add Plot</source>
            <translation>Diagramm hinzufügen</translation>
        </message>
        <message>
            <source>One more plot below the others</source>
            <translation>Ein weiteres Diagramm unter den anderen</translation>
        </message>
        <message>
            <source>Whose view it is</source>
            <translation>Wessen Ansicht es ist</translation>
        </message>
        <message>
            <source>View: %1</source>
            <translation>Ansicht: %1</translation>
        </message>
        <message>
            <source>Proposed; becomes the project's when it is changed</source>
            <translation>Vorschlag; wird beim Ändern Teil des Projekts</translation>
        </message>
        <message>
            <source>No plot yet: Add Plot</source>
            <translation>Noch kein Diagramm: Diagramm hinzufügen</translation>
        </message>
        <message>
            <source>Views of the project</source>
            <translation>Ansichten des Projekts</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>Noch keine</translation>
        </message>
        <message>
            <source>Proposed</source>
            <translation>Vorgeschlagen</translation>
        </message>
        <message>
            <source>New view</source>
            <translation>Neue Ansicht</translation>
        </message>
        <message>
            <source>Own view</source>
            <translation>Eigene Ansicht</translation>
        </message>
        <message>
            <source>Rename…</source>
            <translation>Umbenennen …</translation>
        </message>
        <message>
            <source>Duplicate</source>
            <translation>Duplizieren</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>Löschen</translation>
        </message>
        <message>
            <source>Watch variables…</source>
            <translation>Variablen beobachten …</translation>
        </message>
        <message>
            <source>Rename View</source>
            <translation>Ansicht umbenennen</translation>
        </message>
        <message>
            <source>Name of the view</source>
            <translation>Name der Ansicht</translation>
        </message>
        <message>
            <source>Fuse and its limit</source>
            <translation>Sicherung und ihre Grenze</translation>
        </message>
</context>
<context>
    <name>FreePlot</name>
        <message>
            <source>not drawn</source>
            <translation>nicht gezeichnet</translation>
        </message>
        <message>
            <source>Signals…</source>
            <translation>Signale …</translation>
        </message>
        <message>
            <source>Choose signals and axes</source>
            <translation>Signale und Achsen wählen</translation>
        </message>
        <message>
            <source>Menu of this plot</source>
            <translation>Menü dieses Diagramms</translation>
        </message>
        <message>
            <source>Plot %1</source>
            <translation>Diagramm %1</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Zustand</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>Grenze ±%1</translation>
        </message>
        <message>
            <source>not there</source>
            <translation>nicht vorhanden</translation>
        </message>
        <message>
            <source>%1 (right)</source>
            <translation>%1 (rechts)</translation>
        </message>
        <message>
            <source>Nothing chosen yet: Signals…</source>
            <translation>Noch nichts gewählt: Signale …</translation>
        </message>
        <message>
            <source>min %1   max %2</source>
            <translation>min %1   max %2</translation>
        </message>
        <message>
            <source>Signals and axes…</source>
            <translation>Signale und Achsen …</translation>
        </message>
        <message>
            <source>Value scale</source>
            <translation>Teilung der Werte</translation>
        </message>
        <message>
            <source>Linear</source>
            <translation>Linear</translation>
        </message>
        <message>
            <source>Signed logarithmic</source>
            <translation>Logarithmisch mit Vorzeichen</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>Logarithmisch</translation>
        </message>
        <message>
            <source>Own time axis</source>
            <translation>Eigene Zeitachse</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Herausnehmen</translation>
        </message>
        <message>
            <source>Axis at the right</source>
            <translation>Achse rechts</translation>
        </message>
        <message>
            <source>Move up</source>
            <translation>Nach oben</translation>
        </message>
        <message>
            <source>Move down</source>
            <translation>Nach unten</translation>
        </message>
        <message>
            <source>Remove plot</source>
            <translation>Diagramm entfernen</translation>
        </message>
</context>
<context>
    <name>PlotDialog</name>
        <message>
            <source>About the marked signal</source>
            <translation>Über das markierte Signal</translation>
        </message>
        <message>
            <source>Signals and Axes of the Plot</source>
            <translation>Signale und Achsen des Diagramms</translation>
        </message>
        <message>
            <source>What is wrong</source>
            <translation>Was falsch ist</translation>
        </message>
        <message>
            <source>Search signals</source>
            <translation>Signale suchen</translation>
        </message>
        <message>
            <source>Slave and signal, such as: #1 lost</source>
            <translation>Slave und Signal, etwa: #1 Link</translation>
        </message>
        <message>
            <source>Signals of the run</source>
            <translation>Signale des Laufs</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <source>Add what is marked</source>
            <translation>Markiertes hinzufügen</translation>
        </message>
        <message>
            <source>Ctrl+A marks all that were found: several slaves at once</source>
            <translation>Strg+A markiert alles Gefundene: mehrere Slaves auf einmal</translation>
        </message>
        <message>
            <source>Signals in the plot</source>
            <translation>Signale im Diagramm</translation>
        </message>
        <message>
            <source>In the plot</source>
            <translation>Im Diagramm</translation>
        </message>
        <message>
            <source>A second</source>
            <translation>Je Sekunde</translation>
        </message>
        <message>
            <source>Axis right</source>
            <translation>Achse rechts</translation>
        </message>
        <message>
            <source>How many a second instead of how many: of counts</source>
            <translation>Wie viele je Sekunde statt wie viele: bei Zählern</translation>
        </message>
        <message>
            <source>On the value axis at the right</source>
            <translation>Auf der Werteachse rechts</translation>
        </message>
        <message>
            <source>Take Out</source>
            <translation>Herausnehmen</translation>
        </message>
        <message>
            <source>Take out what is marked (Del)</source>
            <translation>Markiertes herausnehmen (Entf)</translation>
        </message>
        <message>
            <source>Title</source>
            <translation>Titel</translation>
        </message>
        <message>
            <source>Title of the plot</source>
            <translation>Titel des Diagramms</translation>
        </message>
        <message>
            <source>By what it shows</source>
            <translation>Nach dem, was es zeigt</translation>
        </message>
        <message>
            <source>linear</source>
            <translation>linear</translation>
        </message>
        <message>
            <source>signed log</source>
            <translation>log ±</translation>
        </message>
        <message>
            <source>log</source>
            <translation>log</translation>
        </message>
        <message>
            <source>Value scale: %1</source>
            <translation>Teilung der Werte: %1</translation>
        </message>
        <message>
            <source>Value scale</source>
            <translation>Teilung der Werte</translation>
        </message>
        <message>
            <source>Left axis</source>
            <translation>Linke Achse</translation>
        </message>
        <message>
            <source>Right axis</source>
            <translation>Rechte Achse</translation>
        </message>
        <message>
            <source>Own time axis</source>
            <translation>Eigene Zeitachse</translation>
        </message>
        <message>
            <source>Time axis</source>
            <translation>Zeitachse</translation>
        </message>
        <message>
            <source>not linked to the others: own zoom and place</source>
            <translation>nicht mit den anderen verbunden: eigener Zoom und Ort</translation>
        </message>
        <message>
            <source>Limits are two numbers, the smaller one first.</source>
            <translation>Grenzen sind zwei Zahlen, die kleinere zuerst.</translation>
        </message>
        <message>
            <source>A logarithmic scale begins above zero.</source>
            <translation>Eine logarithmische Teilung beginnt über null.</translation>
        </message>
</context>
<context>
    <name>LimitsDialog</name>
        <message>
            <source>Value Limits: %1</source>
            <translation>Grenzen der Werte: %1</translation>
        </message>
        <message>
            <source>Left axis</source>
            <translation>Linke Achse</translation>
        </message>
        <message>
            <source>Right axis</source>
            <translation>Rechte Achse</translation>
        </message>
</context>
<context>
    <name>LimitFields</name>
        <message>
            <source>fixed</source>
            <translation>fest</translation>
        </message>
        <message>
            <source>%1: fixed limits</source>
            <translation>%1: feste Grenzen</translation>
        </message>
        <message>
            <source>%1: from</source>
            <translation>%1: von</translation>
        </message>
        <message>
            <source>%1: to</source>
            <translation>%1: bis</translation>
        </message>
        <message>
            <source>In ns, or with its unit: ns, µs, ms, s</source>
            <translation>In ns, oder mit Einheit: ns, µs, ms, s</translation>
        </message>
        <message>
            <source>A number</source>
            <translation>Eine Zahl</translation>
        </message>
        <message>
            <source>A number, in %1</source>
            <translation>Eine Zahl, in %1</translation>
        </message>
</context>
<context>
    <name>SignalTree</name>
        <message>
            <source>Bus</source>
            <translation>Bus</translation>
        </message>
        <message>
            <source>Variables of the process image</source>
            <translation>Variablen des Prozessabbilds</translation>
        </message>
        <message>
            <source>%1 (no values so far)</source>
            <translation>%1 (bisher ohne Werte)</translation>
        </message>
</context>
<context>
    <name>ReadingProgress</name>
        <message>
            <source>Reading %1…</source>
            <translation>%1 wird gelesen …</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Single slaves, counts, figures and events are shown as soon as all of it is read.</source>
            <translation>Einzelne Slaves, Zähler, Kennzahlen und Ereignisse erscheinen, sobald alles gelesen ist.</translation>
        </message>
</context>
<context>
    <name>OpeningPicture</name>
        <message>
            <source>First picture of the recording</source>
            <translation>Erstes Bild der Aufzeichnung</translation>
        </message>
</context>
<context>
    <name>TimingDiagram</name>
    <message>
        <source>Each frame reads the times of latched edges (0x09AE to 0x09CF).</source>
        <translation>Jeder Frame liest die Zeiten der erfassten Flanken (0x09AE bis 0x09CF).</translation>
    </message>
    <message>
        <source>The latch takes one edge until its time is read (0x09A8).</source>
        <translation>Das Latch nimmt eine Flanke auf, bis deren Zeit gelesen ist (0x09A8).</translation>
    </message>
    <message>
        <source>The device's own controller has the latch unit (0x09A8).</source>
        <translation>Der Controller des Geräts hat die Latch-Einheit (0x09A8).</translation>
    </message>
    <message>
        <source>Latch</source>
        <translation>Latch</translation>
    </message>
        <message>
            <source>Without SYNC0 the device works when its outputs come.</source>
            <translation>Ohne SYNC0 arbeitet das Gerät, wenn seine Ausgänge kommen.</translation>
        </message>
        <message>
            <source>Outputs are complete at the slave %1 after the frame has passed the reference clock.</source>
            <translation>Die Ausgänge sind am Slave vollständig %1 nachdem der Frame die Referenzuhr passiert hat.</translation>
        </message>
        <message>
            <source>It calculates and copies for %1.</source>
            <translation>Er rechnet und kopiert %1 lang.</translation>
        </message>
        <message>
            <source>SYNC0 comes at %1, every %2.</source>
            <translation>SYNC0 kommt bei %1, alle %2.</translation>
        </message>
        <message>
            <source>SYNC1 comes at %1, every %2.</source>
            <translation>SYNC1 kommt bei %1, alle %2.</translation>
        </message>
        <message>
            <source>%1 are left before SYNC0, which is too little.</source>
            <translation>%1 bleiben vor SYNC0, das ist zu wenig.</translation>
        </message>
        <message>
            <source>%1 are left before SYNC0.</source>
            <translation>%1 bleiben vor SYNC0.</translation>
        </message>
        <message>
            <source>Frame</source>
            <translation>Frame</translation>
        </message>
        <message>
            <source>Calc + copy</source>
            <translation>Rechnen + Kopieren</translation>
        </message>
</context>
    <context>
    <name>TracePanel</name>
        <message>
            <source>Mean 95 %</source>
            <translation>Mittel 95 %</translation>
        </message>
    </context>
<context>
    <name>SpokenValue</name>
        <message>
            <source>Nothing is shown</source>
            <translation>Nichts wird gezeigt</translation>
        </message>
</context>
<context>
    <name>SignalQuality</name>
        <message>
            <source>%1, within %2</source>
            <translation>%1, auf %2 genau</translation>
        </message>
        <message>
            <source>the newest is %1 old</source>
            <translation>die neueste ist %1 alt</translation>
        </message>
        <message>
            <source>%1 readings a second</source>
            <translation>%1 Lesungen je Sekunde</translation>
        </message>
        <message>
            <source>nobody tells who stamped the moment</source>
            <translation>wer den Zeitpunkt gestempelt hat, ist nicht bekannt</translation>
        </message>
        <message>
            <source>moment stamped by a probe, in hardware</source>
            <translation>Zeitpunkt von einer Sonde in Hardware gestempelt</translation>
        </message>
        <message>
            <source>moment stamped by the host that captured the frames</source>
            <translation>Zeitpunkt vom mitschneidenden Host gestempelt</translation>
        </message>
        <message>
            <source>moment stamped by the network card</source>
            <translation>Zeitpunkt von der Netzwerkkarte gestempelt</translation>
        </message>
        <message>
            <source>moment stamped by the kernel</source>
            <translation>Zeitpunkt vom Kernel gestempelt</translation>
        </message>
        <message>
            <source>moment stamped by the master's software</source>
            <translation>Zeitpunkt von der Software des Masters gestempelt</translation>
        </message>
        <message>
            <source>by the reference clock and the host's clock</source>
            <translation>nach Referenzuhr und Uhr des Hosts</translation>
        </message>
        <message>
            <source>by the clocks of the slaves</source>
            <translation>nach den Uhren der Slaves</translation>
        </message>
        <message>
            <source>by the host's clock</source>
            <translation>nach der Uhr des Hosts</translation>
        </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Import a Capture</source>
        <translation>Mitschnitt importieren</translation>
    </message>
    <message>
        <source>Times count from the first frame of %1.</source>
        <translation>Zeiten zählen ab dem ersten Frame von %1.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>end of the file</source>
        <translation>Ende der Datei</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>all frames</source>
        <translation>alle Frames</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> Frames</translation>
    </message>
    <message>
        <source>Limit of the slaves' deviation</source>
        <translation>Grenze der Abweichung der Slaves</translation>
    </message>
    <message>
        <source>Limit of the master's error</source>
        <translation>Grenze des Fehlers des Masters</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>&amp;Until</source>
        <translation>&amp;Bis</translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation>&amp;Höchstens</translation>
    </message>
    <message>
        <source>Limit of the slaves' &amp;deviation</source>
        <translation>Grenze der &amp;Abweichung der Slaves</translation>
    </message>
    <message>
        <source>Limit of the master's &amp;error</source>
        <translation>Grenze des &amp;Fehlers des Masters</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>The end comes before the begin.</source>
        <translation>Das Ende liegt vor dem Anfang.</translation>
    </message>
</context>
<context>
    <name>StartBar</name>
        <message>
            <source>Start that failed</source>
            <translation>Gescheiterter Start</translation>
        </message>
        <message>
            <source>Why the machine did not start</source>
            <translation>Warum die Maschine nicht anlief</translation>
        </message>
        <message>
            <source>Show the Slave</source>
            <translation>Slave zeigen</translation>
        </message>
        <message>
            <source>Show the slave that it is about</source>
            <translation>Den Slave zeigen, um den es geht</translation>
        </message>
        <message>
            <source>Scan and Compare…</source>
            <translation>Scannen und vergleichen…</translation>
        </message>
        <message>
            <source>Scan the bus and compare</source>
            <translation>Bus scannen und vergleichen</translation>
        </message>
        <message>
            <source>Looks what is on the bus and shows it beside the project: missing, more, another revision</source>
            <translation>Sieht nach, was am Bus ist, und zeigt es neben dem Projekt: was fehlt, was mehr ist, andere Revisionen</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <source>Close; the messages keep it</source>
            <translation>Schließen; in den Meldungen bleibt es stehen</translation>
        </message>
        <message>
            <source>The machine did not start. %1: %2</source>
            <translation>Die Maschine lief nicht an. %1: %2</translation>
        </message>
        <message>
            <source>The machine did not start; the messages say how far it came.</source>
            <translation>Die Maschine lief nicht an; die Meldungen sagen, wie weit sie kam.</translation>
        </message>
        <message numerus="yes">
            <source>(%n further slave(s) in the messages)</source>
            <translation>
                <numerusform>(%n weiterer Slave in den Meldungen)</numerusform>
                <numerusform>(%n weitere Slaves in den Meldungen)</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>Picture</name>
        <message>
            <source>Syncline, %1, cycle %2</source>
            <translation>Syncline, %1, Zyklus %2</translation>
        </message>
        <message>
            <source>Syncline, simulated machine, %1, cycle %2</source>
            <translation>Syncline, simulierte Maschine, %1, Zyklus %2</translation>
        </message>
</context>
</TS>
