<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Wiedergabe</translation>
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
        <source>&amp;Open sequence…</source>
        <translation>Sequenz ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open &amp;video…</source>
        <translation>&amp;Video öffnen…</translation>
    </message>
    <message>
        <source>&amp;Import a recording…</source>
        <translation>Aufnahme &amp;importieren…</translation>
    </message>
    <message>
        <source>Li&amp;brary…</source>
        <translation>&amp;Bibliothek…</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>&amp;Demo öffnen</translation>
    </message>
    <message>
        <source>Play a &amp;log…</source>
        <translation>&amp;Protokoll abspielen…</translation>
    </message>
    <message>
        <source>E&amp;xport the settings…</source>
        <translation>Einstellungen e&amp;xportieren…</translation>
    </message>
    <message>
        <source>I&amp;mport settings…</source>
        <translation>Einstellungen i&amp;mportieren…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>5 s &amp;back</source>
        <translation>5 s &amp;zurück</translation>
    </message>
    <message>
        <source>5 s &amp;forward</source>
        <translation>5 s &amp;vor</translation>
    </message>
    <message>
        <source>1 min back</source>
        <translation>1 min zurück</translation>
    </message>
    <message>
        <source>1 min forward</source>
        <translation>1 min vor</translation>
    </message>
    <message>
        <source>To the b&amp;eginning</source>
        <translation>Zum An&amp;fang</translation>
    </message>
    <message>
        <source>To the e&amp;nd</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>&amp;Loop: from here, to here, off</source>
        <translation>&amp;Schleife: von hier, bis hier, aus</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>Normale Geschwindigkeit</translation>
    </message>
    <message>
        <source>Quieter</source>
        <translation>Leiser</translation>
    </message>
    <message>
        <source>Louder</source>
        <translation>Lauter</translation>
    </message>
    <message>
        <source>&amp;Mute</source>
        <translation>Stu&amp;mm</translation>
    </message>
    <message>
        <source>&amp;Stop the force</source>
        <translation>Kraft &amp;stoppen</translation>
    </message>
    <message>
        <source>&amp;Re-arm the force</source>
        <translation>Kraft f&amp;reigeben</translation>
    </message>
    <message>
        <source>Set up the &amp;device…</source>
        <translation>&amp;Gerät einrichten…</translation>
    </message>
    <message>
        <source>Get to &amp;know the forces…</source>
        <translation>Die Kräfte &amp;kennenlernen…</translation>
    </message>
    <message>
        <source>Measure l&amp;atencies…</source>
        <translation>L&amp;atenzen messen…</translation>
    </message>
    <message>
        <source>Live &amp;plots</source>
        <translation>&amp;Kurven</translation>
    </message>
    <message>
        <source>Simulated &amp;grip</source>
        <translation>Simulierter &amp;Griff</translation>
    </message>
    <message>
        <source>S&amp;ync plot</source>
        <translation>S&amp;ync-Verlauf</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>&amp;Statistik</translation>
    </message>
    <message>
        <source>Fa&amp;ults of the simulated device…</source>
        <translation>Fe&amp;hler des simulierten Geräts…</translation>
    </message>
    <message>
        <source>&amp;Fullscreen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Keyboard…</source>
        <translation>&amp;Tastatur…</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>Ü&amp;ber</translation>
    </message>
</context>
<context>
    <name>AnalysisPage</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>&amp;Analyse</source>
        <translation>&amp;Auswerten</translation>
    </message>
    <message>
        <source>Compute statistics and figures anew</source>
        <translation>Statistik und Abbildungen neu berechnen</translation>
    </message>
    <message>
        <source>&amp;Save report…</source>
        <translation>Bericht &amp;speichern…</translation>
    </message>
    <message>
        <source>Write report, figures and numbers into a new folder</source>
        <translation>Bericht, Abbildungen und Zahlen in einen neuen Ordner schreiben</translation>
    </message>
    <message>
        <source>Analysing</source>
        <translation>Auswertung läuft</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>Saved in {0}</source>
        <translation>Gespeichert in {0}</translation>
    </message>
    <message>
        <source>Where shall the folder of the report be made?</source>
        <translation>Wo soll der Ordner des Berichts angelegt werden?</translation>
    </message>
</context>
<context>
    <name>AnalysisWindow</name>
    <message>
        <source>Analysis – {0}</source>
        <translation>Auswertung – {0}</translation>
    </message>
</context>
<context>
    <name>Choices</name>
    <message>
        <source>Realistic</source>
        <translation>Realistisch</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keins</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>From file</source>
        <translation>Aus Datei</translation>
    </message>
    <message>
        <source>From a log</source>
        <translation>Aus Protokoll</translation>
    </message>
</context>
<context>
    <name>ChooseMenus</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Sound &amp;output</source>
        <translation>&amp;Tonausgabe</translation>
    </message>
    <message>
        <source>As the system says</source>
        <translation>Wie vom System vorgegeben</translation>
    </message>
    <message>
        <source>Fullscreen &amp;on</source>
        <translation>Vollbild &amp;auf</translation>
    </message>
    <message>
        <source>The window&apos;s screen</source>
        <translation>Bildschirm des Fensters</translation>
    </message>
</context>
<context>
    <name>ClipFrame</name>
    <message>
        <source>Picture at the cursor</source>
        <translation>Bild am Zeiger</translation>
    </message>
</context>
<context>
    <name>Controls</name>
    <message>
        <source>Volume {n} %</source>
        <translation>Lautstärke {n} %</translation>
    </message>
    <message>
        <source>Muted</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ton an</translation>
    </message>
    <message>
        <source>Speed {x:.2f}</source>
        <translation>Geschwindigkeit {x:.2f}</translation>
    </message>
    <message>
        <source>Loop off</source>
        <translation>Schleife aus</translation>
    </message>
    <message>
        <source>Loop from {a}</source>
        <translation>Schleife ab {a}</translation>
    </message>
    <message>
        <source>Loop from {a} to {b}</source>
        <translation>Schleife von {a} bis {b}</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>plays a clip</source>
        <translation>spielt einen Clip</translation>
    </message>
</context>
<context>
    <name>DevicePage</name>
    <message>
        <source>Pull the grip out as far as it goes, then push it in until it locks</source>
        <translation>Den Griff ganz herausziehen, dann hineinschieben, bis er einrastet</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>Nach links</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>Zu Ihnen hin</translation>
    </message>
    <message>
        <source>Away from you</source>
        <translation>Von Ihnen weg</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Feel every direction, gentle first</source>
        <translation>Jede Richtung spüren, zuerst sanft</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Take the force away at once (Esc)</source>
        <translation>Die Kraft sofort wegnehmen (Esc)</translation>
    </message>
    <message>
        <source>Hold the grip loosely. You will feel every direction three times, gentle first. Esc, STOP or a button on the grip ends it at once.</source>
        <translation>Halten Sie den Griff locker. Sie spüren jede Richtung dreimal, zuerst sanft. Esc, STOPP oder eine Taste am Griff beendet es sofort.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Get to know the forces: {name}</source>
        <translation>Die Kräfte kennenlernen: {name}</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Give the device back</source>
        <translation>Das Gerät zurückgeben</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>These were all the forces that you can meet.</source>
        <translation>Das waren alle Kräfte, die Ihnen begegnen können.</translation>
    </message>
    <message>
        <source>The haptics process has ended.</source>
        <translation>Der Haptikprozess ist zu Ende.</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open the folder of a sequence</source>
        <translation>Ordner einer Sequenz öffnen</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Play the force of a log</source>
        <translation>Die Kraft eines Protokolls abspielen</translation>
    </message>
    <message>
        <source>Logs (*.jsonl *.json *.log);;All files (*)</source>
        <translation>Protokolle (*.jsonl *.json *.log);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a device first, then get to know its forces</source>
        <translation>Wählen Sie zuerst ein Gerät, dann lernen Sie seine Kräfte kennen</translation>
    </message>
    <message>
        <source>Export the settings</source>
        <translation>Einstellungen exportieren</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
</context>
<context>
    <name>EmptyPage</name>
    <message>
        <source>Feel the motion of what you watch</source>
        <translation>Spüren, was man sieht</translation>
    </message>
    <message>
        <source>Open a sequence or a video, or drop one here. A video alone plays without force; import it with its motion to feel it.</source>
        <translation>Öffnen Sie eine Sequenz oder ein Video, oder ziehen Sie es hierher. Ein Video allein läuft ohne Kraft; importieren Sie es mit seiner Bewegung, um sie zu spüren.</translation>
    </message>
    <message>
        <source>Play the demo</source>
        <translation>Demo abspielen</translation>
    </message>
    <message>
        <source>A simulated ride; made on first use</source>
        <translation>Eine simulierte Fahrt; beim ersten Mal erzeugt</translation>
    </message>
    <message>
        <source>Open a sequence…</source>
        <translation>Sequenz öffnen…</translation>
    </message>
    <message>
        <source>The folder of a sequence</source>
        <translation>Der Ordner einer Sequenz</translation>
    </message>
    <message>
        <source>Library…</source>
        <translation>Bibliothek…</translation>
    </message>
    <message>
        <source>The sequences that were imported</source>
        <translation>Die importierten Sequenzen</translation>
    </message>
    <message>
        <source>Import a recording…</source>
        <translation>Aufnahme importieren…</translation>
    </message>
    <message>
        <source>Make a sequence of a video and its motion</source>
        <translation>Aus Video und Bewegung eine Sequenz machen</translation>
    </message>
    <message>
        <source>Choose the device…</source>
        <translation>Gerät wählen…</translation>
    </message>
    <message>
        <source>Which haptic device is moved; the simulated one needs no hardware</source>
        <translation>Welches haptische Gerät bewegt wird; das simulierte braucht keine Hardware</translation>
    </message>
</context>
<context>
    <name>ErrorGateway</name>
    <message>
        <source>Something went wrong inside the program ({kind}: {text}); the force was stopped and the playback paused. Details are on the terminal.</source>
        <translation>Im Programm ist etwas schiefgegangen ({kind}: {text}); die Kraft wurde gestoppt und die Wiedergabe angehalten. Einzelheiten stehen im Terminal.</translation>
    </message>
</context>
<context>
    <name>Extras</name>
    <message>
        <source>Goes on at {time}; Home for the beginning</source>
        <translation>Weiter bei {time}; Pos1 für den Anfang</translation>
    </message>
</context>
<context>
    <name>FaultPanel</name>
    <message>
        <source>Re-arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Let the force come back (Ctrl+R)</source>
        <translation>Die Kraft wiederkommen lassen (Strg+R)</translation>
    </message>
    <message>
        <source>Device anew</source>
        <translation>Gerät neu</translation>
    </message>
    <message>
        <source>Start the simulated device again</source>
        <translation>Das simulierte Gerät neu starten</translation>
    </message>
    <message>
        <source>Faults of the simulated device</source>
        <translation>Fehler des simulierten Geräts</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No faults any more</source>
        <translation>Keine Fehler mehr</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Rule that answered</source>
        <translation>Regel, die griff</translation>
    </message>
    <message>
        <source>Reaction, ms</source>
        <translation>Reaktion, ms</translation>
    </message>
    <message>
        <source>No force, ms</source>
        <translation>Kraftlos, ms</translation>
    </message>
    <message>
        <source>What came of the faults</source>
        <translation>Was aus den Fehlern wurde</translation>
    </message>
    <message>
        <source>Only a simulated device takes faults, and only while this panel is open: choose it in the window, then press Device anew.</source>
        <translation>Nur ein simuliertes Gerät nimmt Fehler an, und nur, solange dieses Feld offen ist: wählen Sie es im Fenster, dann drücken Sie Gerät neu.</translation>
    </message>
    <message>
        <source>The device has failed: press Device anew.</source>
        <translation>Das Gerät ist ausgefallen: Gerät neu drücken.</translation>
    </message>
    <message>
        <source>Play a clip with force, so that there is one to take away.</source>
        <translation>Spielen Sie einen Clip mit Kraft, damit es eine wegzunehmen gibt.</translation>
    </message>
    <message>
        <source>There is a force. Press a fault and watch what takes it away.</source>
        <translation>Es wirkt eine Kraft. Drücken Sie einen Fehler und sehen Sie, was sie wegnimmt.</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>Unplug it</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Stall, 60 ms</source>
        <translation>Stockt 60 ms</translation>
    </message>
    <message>
        <source>Stall, 300 ms</source>
        <translation>Stockt 300 ms</translation>
    </message>
    <message>
        <source>Nonsense answers</source>
        <translation>Unsinnige Antworten</translation>
    </message>
    <message>
        <source>Lose the homing</source>
        <translation>Referenz verlieren</translation>
    </message>
    <message>
        <source>Let go of the grip</source>
        <translation>Griff loslassen</translation>
    </message>
    <message>
        <source>Press a grip button</source>
        <translation>Taste am Griff</translation>
    </message>
    <message>
        <source>Position is NaN</source>
        <translation>Position ist NaN</translation>
    </message>
    <message>
        <source>Force is NaN</source>
        <translation>Kraft ist NaN</translation>
    </message>
    <message>
        <source>Loop late, 35 ms</source>
        <translation>Schleife 35 ms zu spät</translation>
    </message>
    <message>
        <source>Loop still, 80 ms</source>
        <translation>Schleife steht 80 ms</translation>
    </message>
    <message>
        <source>Command 25 ms old</source>
        <translation>Befehl 25 ms alt</translation>
    </message>
    <message>
        <source>Window hangs, 0.4 s</source>
        <translation>Fenster hängt 0,4 s</translation>
    </message>
    <message>
        <source>Window hangs, 1.3 s</source>
        <translation>Fenster hängt 1,3 s</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.webm *.m4v *.360 *.MP4 *.MOV *.LRV);;All files (*)</source>
        <translation>Videos (*.mp4 *.mov *.mkv *.avi *.webm *.m4v *.360 *.MP4 *.MOV *.LRV);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Settings (*.json)</source>
        <translation>Einstellungen (*.json)</translation>
    </message>
</context>
<context>
    <name>FilesPage</name>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation>Bewegungsprotokoll</translation>
    </message>
    <message>
        <source>inside the video</source>
        <translation>im Video</translation>
    </message>
    <message>
        <source>Drop a recording here</source>
        <translation>Eine Aufnahme hier ablegen</translation>
    </message>
    <message>
        <source>&amp;Keep the answers…</source>
        <translation>Antworten &amp;behalten…</translation>
    </message>
    <message>
        <source>Write a template for all logs of this logger</source>
        <translation>Eine Vorlage für alle Protokolle dieses Loggers schreiben</translation>
    </message>
    <message>
        <source>Drop a video here, with the log of its motion sensor if that was a device of its own. GoPro cameras keep their motion inside the video.</source>
        <translation>Ziehen Sie ein Video hierher, mit dem Protokoll des Bewegungssensors, wenn das ein eigenes Gerät war. GoPro-Kameras legen die Bewegung im Video ab.</translation>
    </message>
    <message>
        <source>&amp;Video</source>
        <translation>&amp;Video</translation>
    </message>
    <message>
        <source>Motion &amp;log</source>
        <translation>&amp;Protokoll</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>with sound</source>
        <translation>mit Ton</translation>
    </message>
    <message>
        <source>without sound</source>
        <translation>ohne Ton</translation>
    </message>
    <message>
        <source>Video: {camera}{width} × {height}, {rate} pictures a second, {duration}, {sound}</source>
        <translation>Video: {camera}{width} × {height}, {rate} Bilder je Sekunde, {duration}, {sound}</translation>
    </message>
    <message>
        <source>Motion: {recorder}, {rate} samples a second, {duration}, gaps: {gaps}</source>
        <translation>Bewegung: {recorder}, {rate} Werte je Sekunde, {duration}, Lücken: {gaps}</translation>
    </message>
    <message>
        <source>It turned so much that gravity does not show its axes.</source>
        <translation>Der Sensor drehte sich so sehr, dass die Schwerkraft seine Achsen nicht zeigt.</translation>
    </message>
    <message>
        <source>Axes: x to its right, y to its front, z to its top; on average {up} was up</source>
        <translation>Achsen: x nach rechts, y nach vorn, z nach oben; im Mittel war {up} oben</translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation>Video wählen</translation>
    </message>
    <message>
        <source>Motion logs (*.csv *.txt *.log *.zip *.gcsv *.json *.bin *.gpmf);;All files (*)</source>
        <translation>Bewegungsprotokolle (*.csv *.txt *.log *.zip *.gcsv *.json *.bin *.gpmf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a motion log</source>
        <translation>Bewegungsprotokoll wählen</translation>
    </message>
    <message>
        <source>Templates (*.json)</source>
        <translation>Vorlagen (*.json)</translation>
    </message>
    <message>
        <source>Choose a template</source>
        <translation>Vorlage wählen</translation>
    </message>
    <message>
        <source>Where shall the template be written?</source>
        <translation>Wohin soll die Vorlage geschrieben werden?</translation>
    </message>
</context>
<context>
    <name>FirmwareDialog</name>
    <message>
        <source>The Falcon&apos;s firmware</source>
        <translation>Die Firmware des Falcon</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.BIN);;All files (*)</source>
        <translation>Firmware (*.bin *.BIN);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>I accept the licence</source>
        <translation>Ich nehme die Lizenz an</translation>
    </message>
    <message>
        <source>Keep it all the same</source>
        <translation>Trotzdem behalten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>GripView</name>
    <message>
        <source>No device: choose {name} to see what would be felt</source>
        <translation>Kein Gerät: mit „{name}“ sieht man, was zu spüren wäre</translation>
    </message>
    <message>
        <source>The device has failed</source>
        <translation>Das Gerät ist ausgefallen</translation>
    </message>
    <message>
        <source>The haptics process has ended</source>
        <translation>Der Haptikprozess ist beendet</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>The position is not known</source>
        <translation>Die Position ist unbekannt</translation>
    </message>
    <message>
        <source>Simulated grip</source>
        <translation>Simulierter Griff</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Force is off</source>
        <translation>Kraft ist aus</translation>
    </message>
    <message>
        <source>Force is {what}</source>
        <translation>Kraft: {what}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>zu Ihnen</translation>
    </message>
    <message>
        <source>Thick arrow: the force on the hand. Thin white arrow: the planned force. Purple arrow: the share that keeps the grip inside.
Drag or use the arrow keys to look from elsewhere, the wheel or + and − to come nearer, a double click or 0 to go back.</source>
        <translation>Dicker Pfeil: die Kraft auf die Hand. Dünner Pfeil: die geplante Kraft. Violetter Pfeil: der Anteil, der den Griff innen hält.
Ziehen oder Pfeiltasten drehen die Ansicht, Rad oder + und − holen sie heran, Doppelklick oder 0 stellt sie zurück.</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>force {force}, grip {out} from the centre</source>
        <translation>Kraft {force}, Griff {out} von der Mitte</translation>
    </message>
    <message>
        <source>{force:.1f} N</source>
        <translation>{force:.1f} N</translation>
    </message>
    <message>
        <source>centring {force:.1f} N</source>
        <translation>Zentrierung {force:.1f} N</translation>
    </message>
    <message>
        <source>{out:.0f} mm of {most:.0f}</source>
        <translation>{out:.0f} mm von {most:.0f}</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>none</source>
        <translation>keins</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>startet</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>ausgefallen</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>pull the grip out, then push it in</source>
        <translation>Griff herausziehen, dann hineinschieben</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>Falcon</source>
        <translation>Falcon</translation>
    </message>
    <message>
        <source>Falcon on simulated USB</source>
        <translation>Falcon an simuliertem USB</translation>
    </message>
    <message>
        <source>Game pad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keins</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>fading in</source>
        <translation>blendet ein</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>fading out</source>
        <translation>blendet aus</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>GESTOPPT</translation>
    </message>
    <message>
        <source>the window hung</source>
        <translation>das Fenster hing</translation>
    </message>
    <message>
        <source>the player ended</source>
        <translation>der Player endete</translation>
    </message>
    <message>
        <source>the track is broken</source>
        <translation>die Spur ist defekt</translation>
    </message>
    <message>
        <source>button on the grip</source>
        <translation>Knopf am Griff</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>abgezogen</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>das Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>the device answers nonsense</source>
        <translation>das Gerät antwortet Unsinn</translation>
    </message>
    <message>
        <source>the computer stood still</source>
        <translation>der Rechner stand still</translation>
    </message>
    <message>
        <source>the grip was let go</source>
        <translation>der Griff wurde losgelassen</translation>
    </message>
    <message>
        <source>the grip is at its edge</source>
        <translation>der Griff ist am Rand</translation>
    </message>
    <message>
        <source>FIFO</source>
        <translation>FIFO</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>no, {us:.0f} µs, {missed} missed</source>
        <translation>nein, {us:.0f} µs, {missed} verpasst</translation>
    </message>
    <message>
        <source>yes, {us:.0f} µs, {missed} missed</source>
        <translation>ja, {us:.0f} µs, {missed} verpasst</translation>
    </message>
    <message>
        <source>OFF {p50:+.1f}, {p95:+.1f} ms</source>
        <translation>VERSETZT {p50:+.1f}; {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{p50:+.1f}, {p95:+.1f} ms</source>
        <translation>{p50:+.1f}; {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>{shown} gezeigt, {dropped} weg</translation>
    </message>
    <message>
        <source>damaged: {damaged} broken, {dropped} dropped</source>
        <translation>beschädigt: {damaged} defekt, {dropped} verworfen</translation>
    </message>
    <message>
        <source>audio</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>no sound</source>
        <translation>kein Ton</translation>
    </message>
    <message>
        <source>monotonic</source>
        <translation>monoton</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>keine Daten</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>watch</source>
        <translation>beachten</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
</context>
<context>
    <name>HealthLine</name>
    <message>
        <source>Health</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>The haptic device and what it does</source>
        <translation>Das haptische Gerät und was es tut</translation>
    </message>
    <message>
        <source>Simulated, fading out</source>
        <translation>Simuliert, blendet aus</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>Class of the 1 kHz loop: FIFO is best, slice nearly as good, normal lets it be late by milliseconds</source>
        <translation>Klasse der 1-kHz-Schleife: FIFO ist am besten, Scheibe fast so gut, normal lässt sie Millisekunden zu spät kommen</translation>
    </message>
    <message>
        <source>Real-time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>99 % of the loop&apos;s wake-ups in the last 10 s were no later than this; missed are periods that were skipped. When more than 1 % are, the force is held to 3 N</source>
        <translation>99 % der Takte der letzten 10 s kamen nicht später als so; verpasste wurden übersprungen. Sind es mehr als 1 %, bleibt die Kraft unter 3 N</translation>
    </message>
    <message>
        <source>yes, 888 µs, 88 missed</source>
        <translation>ja, 888 µs, 88 verpasst</translation>
    </message>
    <message>
        <source>Force − picture</source>
        <translation>Kraft − Bild</translation>
    </message>
    <message>
        <source>How much later the force comes than its picture: median and 95 % of the last 20 s. More than 15 ms early or 50 ms late is felt</source>
        <translation>Wie viel später die Kraft kommt als ihr Bild: Median und 95 % der letzten 20 s. Mehr als 15 ms zu früh oder 50 ms zu spät spürt man</translation>
    </message>
    <message>
        <source>OFF +88.8, +88.8 ms</source>
        <translation>VERSETZT +88,8, +88,8 ms</translation>
    </message>
    <message>
        <source>How much later the force comes than its sound: median and 95 % of the last 20 s. More than 15 ms early or 50 ms late is felt</source>
        <translation>Wie viel später die Kraft kommt als ihr Ton: Median und 95 % der letzten 20 s. Mehr als 15 ms zu früh oder 50 ms zu spät spürt man</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Kraft − Ton</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Shown in time, and dropped because they came too late</source>
        <translation>Rechtzeitig gezeigt, und weggelassen, weil sie zu spät kamen</translation>
    </message>
    <message>
        <source>88888 shown, 88 dropped</source>
        <translation>88888 gezeigt, 88 weg</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>What leads: the sound that is heard, or the machine&apos;s monotonic clock where there is no sound</source>
        <translation>Was führt: der hörbare Ton, oder die monotone Uhr des Rechners, wo es keinen Ton gibt</translation>
    </message>
    <message>
        <source>monotonic</source>
        <translation>monoton</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>About hapticplayer</source>
        <translation>Über hapticplayer</translation>
    </message>
    <message>
        <source>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Plays a video and lets you feel the motion of whoever recorded it.&lt;/p&gt;&lt;p&gt;After Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Spielt ein Video und lässt die Bewegung dessen spüren, der es aufgenommen hat.&lt;/p&gt;&lt;p&gt;Nach Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;MIT-Lizenz.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>HomingPicture</name>
    <message>
        <source>The Falcon&apos;s grip</source>
        <translation>Der Griff des Falcon</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>links unten</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keines</translation>
    </message>
    <message>
        <source>Homed: {legs}</source>
        <translation>Referenziert: {legs}</translation>
    </message>
    <message>
        <source>in</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>out</source>
        <translation>außen</translation>
    </message>
</context>
<context>
    <name>ImportWizard</name>
    <message>
        <source>Import a recording</source>
        <translation>Aufnahme importieren</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Stop this work; nothing is left behind</source>
        <translation>Diese Arbeit anhalten; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>&amp;Import another…</source>
        <translation>&amp;Weitere importieren…</translation>
    </message>
    <message>
        <source>Begin again with other files</source>
        <translation>Mit anderen Dateien neu beginnen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>To the step before</source>
        <translation>Zum vorigen Schritt</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>To the next step</source>
        <translation>Zum nächsten Schritt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>Synchronisieren</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Befestigung</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>&amp;Play it</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Looking at {0}</source>
        <translation>{0} wird angesehen</translation>
    </message>
    <message>
        <source>Importing {0}</source>
        <translation>{0} wird importiert</translation>
    </message>
</context>
<context>
    <name>JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop this work; nothing is left behind</source>
        <translation>Diese Arbeit beenden; nichts bleibt zurück</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Keyboard</source>
        <translation>Tastatur</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
    <message>
        <source>Press the key that the chosen command shall have</source>
        <translation>Drücken Sie die Taste für den gewählten Befehl</translation>
    </message>
    <message>
        <source>Use this key</source>
        <translation>Taste übernehmen</translation>
    </message>
    <message>
        <source>Give the key to the chosen command</source>
        <translation>Dem gewählten Befehl diese Taste geben</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Give the chosen command its first keys again</source>
        <translation>Dem gewählten Befehl seine ersten Tasten zurückgeben</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Give every command its first keys again</source>
        <translation>Jedem Befehl seine ersten Tasten zurückgeben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>This key always stops the force; it stays</source>
        <translation>Diese Taste stoppt immer die Kraft; sie bleibt</translation>
    </message>
    <message>
        <source>Press a key in the field first</source>
        <translation>Drücken Sie zuerst eine Taste im Feld</translation>
    </message>
    <message>
        <source>{key} is taken by “{command}”</source>
        <translation>{key} gehört schon zu „{command}“</translation>
    </message>
</context>
<context>
    <name>LatencyPage</name>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>All together, compensated</source>
        <translation>Alles zusammen, ausgeglichen</translation>
    </message>
    <message>
        <source>Tap to the picture</source>
        <translation>Zum Bild tippen</translation>
    </message>
    <message>
        <source>Tap to the sound</source>
        <translation>Zum Ton tippen</translation>
    </message>
    <message>
        <source>Tap to the force</source>
        <translation>Zur Kraft tippen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Play a beat each second</source>
        <translation>Jede Sekunde einen Schlag abspielen</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Take the force away at once (Esc)</source>
        <translation>Die Kraft sofort wegnehmen (Esc)</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>Tap with each beat (space bar)</source>
        <translation>Mit jedem Schlag tippen (Leertaste)</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Remember these numbers for these outputs</source>
        <translation>Diese Zahlen für diese Ausgaben merken</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Measure latencies</source>
        <translation>Latenzen messen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
    <message>
        <source>{n} of {least} taps</source>
        <translation>{n} von {least} Mal getippt</translation>
    </message>
    <message>
        <source>{n} taps: {ms:.0f} ± {spread:.0f} ms</source>
        <translation>{n} Mal: {ms:.0f} ± {spread:.0f} ms</translation>
    </message>
    <message>
        <source>Each second there are a flash, a beep and a gentle push. Hold the grip loosely and press Start. Esc, STOP or a button on the grip ends it.</source>
        <translation>Jede Sekunde kommen ein Blitz, ein Ton und ein sanfter Stoß. Halten Sie den Griff locker und drücken Sie Start. Esc, STOPP oder eine Taste am Griff beendet es.</translation>
    </message>
    <message>
        <source>Change the numbers until flash, beep and push come together. What comes late needs a larger number.</source>
        <translation>Ändern Sie die Zahlen, bis Blitz, Ton und Stoß zusammen kommen. Was zu spät kommt, braucht eine größere Zahl.</translation>
    </message>
    <message>
        <source>Press the space bar with each beat, at least eight times; first to the picture, then to the sound and the force. The differences are put into the numbers; refine them with all together.</source>
        <translation>Drücken Sie mit jedem Schlag die Leertaste, mindestens achtmal; erst zum Bild, dann zum Ton und zur Kraft. Die Unterschiede werden in die Zahlen übernommen; verfeinern Sie sie mit allem zusammen.</translation>
    </message>
</context>
<context>
    <name>LatencyWatch</name>
    <message>
        <source>The sound output {name} is {ms:.0f} ms behind</source>
        <translation>Die Tonausgabe {name} hinkt {ms:.0f} ms nach</translation>
    </message>
    <message>
        <source>The sound output {name} seems to be wireless</source>
        <translation>Die Tonausgabe {name} scheint drahtlos zu sein</translation>
    </message>
    <message>
        <source>it may be later still than it says. Use headphones with a cable, or measure it: Playback, Measure latencies</source>
        <translation>sie kann noch später sein, als sie sagt. Nehmen Sie Kopfhörer mit Kabel oder messen Sie sie: Wiedergabe, Latenzen messen</translation>
    </message>
</context>
<context>
    <name>LibraryDetails</name>
    <message>
        <source>Force tracks</source>
        <translation>Kraftspuren</translation>
    </message>
    <message>
        <source>Force track</source>
        <translation>Kraftspur</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektiv</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source> N per m/s²</source>
        <translation> N je m/s²</translation>
    </message>
    <message>
        <source>&amp;Add a track…</source>
        <translation>Spur &amp;hinzufügen…</translation>
    </message>
    <message>
        <source>A force track from a CSV file</source>
        <translation>Eine Kraftspur aus einer CSV-Datei</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>Rename the track</source>
        <translation>Die Spur umbenennen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove the track</source>
        <translation>Die Spur entfernen</translation>
    </message>
    <message>
        <source>Use this &amp;gain</source>
        <translation>&amp;Verstärkung nehmen</translation>
    </message>
    <message>
        <source>Make the realistic and the random track anew</source>
        <translation>Die realistische und die zufällige Spur neu erzeugen</translation>
    </message>
    <message>
        <source>about {peak} N at the peak, {rms} N RMS…</source>
        <translation>etwa {peak} N Spitze, {rms} N effektiv…</translation>
    </message>
    <message>
        <source>{peak} N at the peak, {rms} N RMS, {share} of the samples at the limit; workspace: relaxed hand {relaxed}, normal {normal}, firm {firm}</source>
        <translation>{peak} N Spitze, {rms} N effektiv, {share} der Werte an der Grenze; Arbeitsraum: lockere Hand {relaxed}, normale {normal}, feste {firm}</translation>
    </message>
    <message>
        <source>the force would stop</source>
        <translation>die Kraft würde anhalten</translation>
    </message>
    <message>
        <source>Making the force anew</source>
        <translation>Die Kraft wird neu erzeugt</translation>
    </message>
    <message>
        <source>Force tracks (*.csv);;All files (*)</source>
        <translation>Kraftspuren (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a force track</source>
        <translation>Kraftspur wählen</translation>
    </message>
    <message>
        <source>Adding {name}</source>
        <translation>{name} wird hinzugefügt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>LibraryPage</name>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Bring back what was deleted last</source>
        <translation>Das zuletzt Gelöschte zurückholen</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Stop this work; nothing is left behind</source>
        <translation>Diese Arbeit anhalten; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Bring in a recording</source>
        <translation>Eine Aufnahme hereinholen</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>O&amp;rdner…</translation>
    </message>
    <message>
        <source>Show another folder</source>
        <translation>Einen anderen Ordner zeigen</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>Another title</source>
        <translation>Ein anderer Titel</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Read every file, check it</source>
        <translation>Jede Datei lesen und prüfen</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Löschen…</translation>
    </message>
    <message>
        <source>Move it to the bin</source>
        <translation>In den Papierkorb legen</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Play it (Enter)</source>
        <translation>Abspielen (Eingabe)</translation>
    </message>
    <message>
        <source>There is nothing here yet; import a recording.</source>
        <translation>Hier ist noch nichts; importieren Sie eine Aufnahme.</translation>
    </message>
    <message>
        <source>Nothing is called so</source>
        <translation>Nichts gefunden</translation>
    </message>
    <message>
        <source>Where are sequences kept?</source>
        <translation>Wo liegen die Sequenzen?</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>{title}: every file is as it was written</source>
        <translation>{title}: Jede Datei ist, wie sie geschrieben wurde</translation>
    </message>
    <message>
        <source>Move {title} to the bin? It can be brought back from there.</source>
        <translation>{title} in den Papierkorb legen? Von dort kann man sie zurückholen.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>{title} cannot be moved to the bin; nothing was deleted.</source>
        <translation>{title} kann nicht in den Papierkorb gelegt werden; nichts wurde gelöscht.</translation>
    </message>
    <message>
        <source>{title} is in the bin.</source>
        <translation>{title} liegt im Papierkorb.</translation>
    </message>
</context>
<context>
    <name>LookMenus</name>
    <message>
        <source>&amp;Look</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie die Arbeitsfläche</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache (Language)</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>Diese Meldung ausblenden</translation>
    </message>
</context>
<context>
    <name>Mirror</name>
    <message>
        <source>The participant&apos;s picture</source>
        <translation>Das Bild der teilnehmenden Person</translation>
    </message>
    <message>
        <source>A page is shown</source>
        <translation>Eine Seite wird gezeigt</translation>
    </message>
</context>
<context>
    <name>MountingPage</name>
    <message>
        <source>Mounting</source>
        <translation>Befestigung</translation>
    </message>
    <message>
        <source>The device stands</source>
        <translation>Das Gerät steht</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source> N per m/s²</source>
        <translation> N je m/s²</translation>
    </message>
    <message>
        <source>The same for all sequences that are to be compared</source>
        <translation>Dieselbe für alle Sequenzen, die verglichen werden sollen</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Looks forward, upright</source>
        <translation>Blickt nach vorn, aufrecht</translation>
    </message>
    <message>
        <source>Looks forward, upside down</source>
        <translation>Blickt nach vorn, kopfüber</translation>
    </message>
    <message>
        <source>Looks backward, upright</source>
        <translation>Blickt nach hinten, aufrecht</translation>
    </message>
    <message>
        <source>Looks to the right, upright</source>
        <translation>Blickt nach rechts, aufrecht</translation>
    </message>
    <message>
        <source>Looks to the left, upright</source>
        <translation>Blickt nach links, aufrecht</translation>
    </message>
    <message>
        <source>Looks forward, left side up</source>
        <translation>Blickt nach vorn, linke Seite oben</translation>
    </message>
    <message>
        <source>Looks forward, right side up</source>
        <translation>Blickt nach vorn, rechte Seite oben</translation>
    </message>
    <message>
        <source>Lies on its back, looks up</source>
        <translation>Liegt auf dem Rücken, blickt nach oben</translation>
    </message>
    <message>
        <source>Looks down</source>
        <translation>Blickt nach unten</translation>
    </message>
    <message>
        <source>Right {right}, front {front}, up {up}</source>
        <translation>Rechts {right}, vorn {front}, oben {up}</translation>
    </message>
    <message>
        <source>before its user: forward pulls the hand away</source>
        <translation>vor der Person: vorwärts zieht die Hand weg</translation>
    </message>
    <message>
        <source>to the right of its user</source>
        <translation>rechts von der Person</translation>
    </message>
    <message>
        <source>behind its user</source>
        <translation>hinter der Person</translation>
    </message>
    <message>
        <source>to the left of its user</source>
        <translation>links von der Person</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Keep sequences in another folder</source>
        <translation>Sequenzen in einem anderen Ordner aufbewahren</translation>
    </message>
    <message>
        <source>&amp;Mounting</source>
        <translation>&amp;Befestigung</translation>
    </message>
    <message>
        <source>The &amp;device stands</source>
        <translation>Das &amp;Gerät steht</translation>
    </message>
    <message>
        <source>&amp;Gain</source>
        <translation>&amp;Verstärkung</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>The drawing shows the recorder on its actor, who looks to the front; the dashed line is where gravity says that up was.</source>
        <translation>Die Zeichnung zeigt das Aufnahmegerät an der Person, die nach vorn blickt; die gestrichelte Linie zeigt, wo nach der Schwerkraft oben war.</translation>
    </message>
    <message>
        <source>It turned so much that gravity does not tell which is right.</source>
        <translation>Es drehte sich so sehr, dass die Schwerkraft nicht sagt, welche stimmt.</translation>
    </message>
    <message>
        <source>Gravity agrees. Which side was the front only you can know.</source>
        <translation>Die Schwerkraft stimmt überein. Welche Seite vorn war, können nur Sie wissen.</translation>
    </message>
    <message>
        <source>Gravity says that another side was up.</source>
        <translation>Nach der Schwerkraft war eine andere Seite oben.</translation>
    </message>
    <message>
        <source>Where shall sequences be kept?</source>
        <translation>Wo sollen Sequenzen aufbewahrt werden?</translation>
    </message>
</context>
<context>
    <name>Numbers</name>
    <message>
        <source>yyyy-MM-dd</source>
        <extracomment>how a date is written in figures, in Qt&apos;s letters</extracomment>
        <translation>dd.MM.yyyy</translation>
    </message>
</context>
<context>
    <name>PlayerWindow</name>
    <message>
        <source>hapticplayer</source>
        <translation>hapticplayer</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>Acceleration around the playhead</source>
        <translation>Beschleunigung um die Abspielstelle</translation>
    </message>
    <message>
        <source>This clip has no motion data</source>
        <translation>Dieser Clip hat keine Bewegungsdaten</translation>
    </message>
    <message>
        <source>Force around the playhead</source>
        <translation>Kraft um die Abspielstelle</translation>
    </message>
    <message>
        <source>Acceleration, m/s²</source>
        <translation>Beschleunigung, m/s²</translation>
    </message>
    <message>
        <source>x right</source>
        <translation>x rechts</translation>
    </message>
    <message>
        <source>y front</source>
        <translation>y vorn</translation>
    </message>
    <message>
        <source>z up</source>
        <translation>z oben</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>y up</source>
        <translation>y oben</translation>
    </message>
    <message>
        <source>z to you</source>
        <translation>z zu Ihnen</translation>
    </message>
    <message>
        <source>thin: planned</source>
        <translation>dünn: geplant</translation>
    </message>
    <message>
        <source>Click: go there. Drag: move. Wheel or + and −: zoom. Double click or Enter: as before</source>
        <translation>Klick: dorthin. Ziehen: verschieben. Rad oder + und −: Zoom. Doppelklick oder Eingabe: wie zuvor</translation>
    </message>
    <message>
        <source>Save this view: {plot}</source>
        <translation>Diese Ansicht speichern: {plot}</translation>
    </message>
    <message>
        <source>Save this view as PNG, SVG or CSV</source>
        <translation>Diese Ansicht als PNG, SVG oder CSV speichern</translation>
    </message>
    <message>
        <source>Picture (*.png);;Drawing (*.svg);;Numbers (*.csv)</source>
        <translation>Bild (*.png);;Zeichnung (*.svg);;Zahlen (*.csv)</translation>
    </message>
    <message>
        <source>{name}: choose a name that ends in {kinds}</source>
        <translation>{name}: wählen Sie einen Namen, der auf {kinds} endet</translation>
    </message>
</context>
<context>
    <name>PlotsPlace</name>
    <message>
        <source>Live plots</source>
        <translation>Kurven</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>Good: ready for use</source>
        <translation>Gut: kann verwendet werden</translation>
    </message>
    <message>
        <source>Doubtful: look at what is marked</source>
        <translation>Zweifelhaft: sehen Sie sich an, was markiert ist</translation>
    </message>
    <message>
        <source>Bad: better record or import it again</source>
        <translation>Schlecht: besser neu aufnehmen oder importieren</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Synchronisation</translation>
    </message>
    <message>
        <source>Clock drift</source>
        <translation>Gang der Uhr</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Gravity left at rest</source>
        <translation>Restschwerkraft in Ruhe</translation>
    </message>
    <message>
        <source>Sensor at its limit</source>
        <translation>Sensor an der Grenze</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Clip without motion</source>
        <translation>Clip ohne Bewegung</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>Kraft an der Grenze</translation>
    </message>
    <message>
        <source>Use of the workspace</source>
        <translation>Nutzung des Arbeitsraums</translation>
    </message>
    <message>
        <source>Heat of the motors</source>
        <translation>Wärme der Motoren</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>residual {ms} ms, confidence {confidence} ({how})</source>
        <translation>Rest {ms}&#xa0;ms, Sicherheit {confidence} ({how})</translation>
    </message>
    <message>
        <source>{share} of the motion; {count}, the longest {s} s</source>
        <translation>{share} der Bewegung; {count}, die längste {s}&#xa0;s</translation>
    </message>
    <message>
        <source>{share} of the samples; the peak is {n} N</source>
        <translation>{share} der Werte; die Spitze ist {n}&#xa0;N</translation>
    </message>
    <message>
        <source>three pats</source>
        <translation>drei Klopfer</translation>
    </message>
    <message>
        <source>variance</source>
        <translation>Varianz</translation>
    </message>
    <message>
        <source>one clock</source>
        <translation>eine Uhr</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>relaxed hand</source>
        <translation>lockere Hand</translation>
    </message>
    <message>
        <source>normal hand</source>
        <translation>normale Hand</translation>
    </message>
    <message>
        <source>firm hand</source>
        <translation>feste Hand</translation>
    </message>
    <message>
        <source>The force would stop; lower the gain</source>
        <translation>Die Kraft würde anhalten; Verstärkung senken</translation>
    </message>
    <message>
        <source>Look again, and give three pats next time</source>
        <translation>Noch einmal ansehen; nächstes Mal dreimal klopfen</translation>
    </message>
    <message>
        <source>Pat at the end of a long recording too</source>
        <translation>Bei langen Aufnahmen auch am Ende klopfen</translation>
    </message>
    <message>
        <source>Record at 100 Hz or more</source>
        <translation>Mit 100 Hz oder mehr aufnehmen</translation>
    </message>
    <message>
        <source>Stand still for a few seconds at the start</source>
        <translation>Am Anfang einige Sekunden stillstehen</translation>
    </message>
    <message>
        <source>Choose a larger range of the accelerometer</source>
        <translation>Größeren Messbereich des Beschleunigungssensors wählen</translation>
    </message>
    <message>
        <source>There is no force there; try another card</source>
        <translation>Dort gibt es keine Kraft; andere Speicherkarte versuchen</translation>
    </message>
    <message>
        <source>Start the log before the clip, end it after</source>
        <translation>Das Protokoll vor dem Clip beginnen, danach beenden</translation>
    </message>
    <message>
        <source>Lower the gain</source>
        <translation>Verstärkung senken</translation>
    </message>
    <message>
        <source>Lower the gain, or play shorter clips</source>
        <translation>Verstärkung senken oder kürzere Clips spielen</translation>
    </message>
</context>
<context>
    <name>QualityView</name>
    <message>
        <source>Quality report</source>
        <translation>Qualitätsbericht</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>This sequence cannot be played</source>
        <translation>Diese Sequenz kann nicht abgespielt werden</translation>
    </message>
</context>
<context>
    <name>RecentMenu</name>
    <message>
        <source>Forget all</source>
        <translation>Alles vergessen</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>Opening {name}</source>
        <translation>{name} wird geöffnet</translation>
    </message>
    <message>
        <source>Preparing the demo</source>
        <translation>Die Demo wird vorbereitet</translation>
    </message>
    <message>
        <source>Something else is being done; wait for it or cancel it</source>
        <translation>Es läuft schon etwas; warten Sie, oder brechen Sie es ab</translation>
    </message>
    <message>
        <source>Bring the grip to the middle first, then re-arm again</source>
        <translation>Bringen Sie den Griff erst in die Mitte und geben Sie dann wieder frei</translation>
    </message>
    <message>
        <source>The haptics process has ended; choose the device again</source>
        <translation>Der Haptikprozess ist beendet; wählen Sie das Gerät noch einmal</translation>
    </message>
</context>
<context>
    <name>SessionControl</name>
    <message>
        <source>Session – hapticplayer</source>
        <translation>Sitzung – hapticplayer</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>New note</source>
        <translation>Neue Notiz</translation>
    </message>
    <message>
        <source>A note; Enter keeps it</source>
        <translation>Eine Notiz; die Eingabetaste speichert sie</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop the clip; it begins again</source>
        <translation>Den Clip anhalten; er beginnt von vorn</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Play the last trial again</source>
        <translation>Den letzten Durchgang noch einmal spielen</translation>
    </message>
    <message>
        <source>Skip…</source>
        <translation>Überspringen…</translation>
    </message>
    <message>
        <source>Leave this step out</source>
        <translation>Diesen Schritt auslassen</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Beenden…</translation>
    </message>
    <message>
        <source>End the session for good</source>
        <translation>Die Sitzung endgültig beenden</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Try to save once more</source>
        <translation>Noch einmal zu speichern versuchen</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Take the force away (Esc)</source>
        <translation>Die Kraft wegnehmen (Esc)</translation>
    </message>
    <message>
        <source>Volume {n} %, the same for the whole session</source>
        <translation>Lautstärke {n} %, für die ganze Sitzung gleich</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>, trial {k} of {n}</source>
        <translation>, Durchgang {k} von {n}</translation>
    </message>
    <message>
        <source>, attempt {n}</source>
        <translation>, Versuch {n}</translation>
    </message>
    <message>
        <source>Nothing has been played yet</source>
        <translation>Es wurde noch nichts gespielt</translation>
    </message>
    <message>
        <source>The last trial was played as it should be</source>
        <translation>Der letzte Durchgang lief, wie er soll</translation>
    </message>
    <message>
        <source>The last trial was not sound: {reasons}</source>
        <translation>Der letzte Durchgang war nicht einwandfrei: {reasons}</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Why is this step left out?</source>
        <translation>Warum wird dieser Schritt ausgelassen?</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Die Sitzung beenden</translation>
    </message>
    <message>
        <source>Why does it end? All answers given so far are kept.</source>
        <translation>Warum endet sie? Alle bisherigen Antworten bleiben erhalten.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The session has not ended. Close, and go on with it later?</source>
        <translation>Die Sitzung ist nicht zu Ende. Schließen und später fortsetzen?</translation>
    </message>
    <message>
        <source>consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>spielt</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>cannot be saved</source>
        <translation>kann nicht gespeichert werden</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>ended early</source>
        <translation>vorzeitig beendet</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>the contract stopped it ({0})</source>
        <translation>der Sicherheitsvertrag hat angehalten ({0})</translation>
    </message>
    <message>
        <source>force and picture were apart</source>
        <translation>Kraft und Bild lagen auseinander</translation>
    </message>
    <message>
        <source>force and sound were apart</source>
        <translation>Kraft und Ton lagen auseinander</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>to be repeated</source>
        <translation>wird wiederholt</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>the session was ended</source>
        <translation>die Sitzung wurde beendet</translation>
    </message>
    <message>
        <source>stopped by the operator</source>
        <translation>von der Versuchsleitung angehalten</translation>
    </message>
    <message>
        <source>the participant pressed Esc</source>
        <translation>die Person hat Esc gedrückt</translation>
    </message>
    <message>
        <source>the participant pressed the space bar</source>
        <translation>die Person hat die Leertaste gedrückt</translation>
    </message>
    <message>
        <source>another program came in front</source>
        <translation>ein anderes Programm kam nach vorn</translation>
    </message>
    <message>
        <source>the window was to be closed</source>
        <translation>das Fenster sollte geschlossen werden</translation>
    </message>
    <message>
        <source>the clip is damaged</source>
        <translation>der Clip ist beschädigt</translation>
    </message>
    <message>
        <source>pictures were dropped</source>
        <translation>Bilder wurden ausgelassen</translation>
    </message>
    <message>
        <source>there was no sound</source>
        <translation>es gab keinen Ton</translation>
    </message>
    <message>
        <source>sound was missing</source>
        <translation>Ton hat gefehlt</translation>
    </message>
    <message>
        <source>there was no device</source>
        <translation>es gab kein Gerät</translation>
    </message>
    <message>
        <source>the device was lost</source>
        <translation>das Gerät ging verloren</translation>
    </message>
    <message>
        <source>the loop missed periods</source>
        <translation>die Schleife hat Perioden verpasst</translation>
    </message>
    <message>
        <source>the device said nothing</source>
        <translation>das Gerät hat nichts gesagt</translation>
    </message>
    <message>
        <source>the record has gaps</source>
        <translation>die Aufzeichnung hat Lücken</translation>
    </message>
    <message>
        <source>{size}; screens in all: {n}</source>
        <translation>{size}; Bildschirme insgesamt: {n}</translation>
    </message>
    <message>
        <source>{n} GB free</source>
        <translation>{n} GB frei</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
</context>
<context>
    <name>SetupPage</name>
    <message>
        <source>Firmware file…</source>
        <translation>Firmware-Datei…</translation>
    </message>
    <message>
        <source>Keep your copy of the firmware</source>
        <translation>Ihre Kopie der Firmware aufbewahren</translation>
    </message>
    <message>
        <source>Feel the forces…</source>
        <translation>Kräfte fühlen…</translation>
    </message>
    <message>
        <source>Feel every direction, gentle first</source>
        <translation>Jede Richtung fühlen, erst sanft</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>Dieses Gerät benutzen</translation>
    </message>
    <message>
        <source>Play with it from now on</source>
        <translation>Von jetzt an damit spielen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Keep the device from before</source>
        <translation>Das bisherige Gerät behalten</translation>
    </message>
    <message>
        <source>Set up the device</source>
        <translation>Das Gerät einrichten</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>That file cannot be used</source>
        <translation>Diese Datei ist nicht brauchbar</translation>
    </message>
</context>
<context>
    <name>SetupTexts</name>
    <message>
        <source>The Falcon cannot be used</source>
        <translation>Der Falcon kann nicht benutzt werden</translation>
    </message>
    <message>
        <source>The Falcon is not plugged in</source>
        <translation>Der Falcon ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>Connect its USB cable and its power supply; it is found by itself.</source>
        <translation>Schließen Sie sein USB-Kabel und sein Netzteil an; er wird von selbst gefunden.</translation>
    </message>
    <message>
        <source>Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and plug it in.</source>
        <translation>Kopieren Sie die udev-Regel {rule} nach /etc/udev/rules.d, ziehen Sie den Falcon dann ab und stecken Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>You have no permission to use the Falcon</source>
        <translation>Sie dürfen den Falcon nicht benutzen</translation>
    </message>
    <message>
        <source>Another program uses the Falcon</source>
        <translation>Ein anderes Programm benutzt den Falcon</translation>
    </message>
    <message>
        <source>Close that program; then it goes on by itself.</source>
        <translation>Schließen Sie dieses Programm; dann geht es von selbst weiter.</translation>
    </message>
    <message>
        <source>The Falcon has the wrong driver</source>
        <translation>Der Falcon hat den falschen Treiber</translation>
    </message>
    <message>
        <source>Give it the driver WinUSB, with the program Zadig, in place of FTDI&apos;s or Force Dimension&apos;s; then unplug it and plug it in.</source>
        <translation>Geben Sie ihm mit dem Programm Zadig den Treiber WinUSB anstelle dessen von FTDI oder Force Dimension; ziehen Sie ihn dann ab und stecken Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware</source>
        <translation>Der Falcon braucht seine Firmware</translation>
    </message>
    <message>
        <source>It belongs to Novint and may not be passed on with this program. Take nvent_firmware.bin from a libnifalcon source archive and choose the file here, once.</source>
        <translation>Sie gehört Novint und darf mit diesem Programm nicht weitergegeben werden. Nehmen Sie nvent_firmware.bin aus einem Quellarchiv von libnifalcon und wählen Sie die Datei hier einmal aus.</translation>
    </message>
    <message>
        <source>Pull the grip out, as far as it goes</source>
        <translation>Ziehen Sie den Griff ganz heraus</translation>
    </message>
    <message>
        <source>Push the grip in, until it locks</source>
        <translation>Schieben Sie den Griff hinein, bis er einrastet</translation>
    </message>
    <message>
        <source>The Falcon is ready</source>
        <translation>Der Falcon ist bereit</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Verbindung wird hergestellt</translation>
    </message>
    <message>
        <source>Loading the firmware</source>
        <translation>Die Firmware wird geladen</translation>
    </message>
    <message>
        <source>A button on the grip is pressed.</source>
        <translation>Eine Taste am Griff ist gedrückt.</translation>
    </message>
    <message>
        <source>Move the grip: the picture follows.</source>
        <translation>Bewegen Sie den Griff: das Bild folgt.</translation>
    </message>
    <message>
        <source>Joints that have found their zero: {legs}. There is no force.</source>
        <translation>Gelenke, die ihre Null gefunden haben: {legs}. Es wirkt keine Kraft.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keines</translation>
    </message>
    <message>
        <source>Nothing has to be set up</source>
        <translation>Nichts ist einzurichten</translation>
    </message>
    <message>
        <source>A Falcon that is only computed, held by a simulated hand: for trying everything without hardware.</source>
        <translation>Ein Falcon, der nur gerechnet wird, von einer simulierten Hand gehalten: um alles ohne Gerät auszuprobieren.</translation>
    </message>
    <message>
        <source>Connect a DualSense or a DualShock 4 by its USB cable. It shakes as strongly as the force is; it has no direction.</source>
        <translation>Schließen Sie einen DualSense oder DualShock 4 mit dem USB-Kabel an. Er rüttelt so stark, wie die Kraft ist; eine Richtung hat er nicht.</translation>
    </message>
    <message>
        <source>The clip plays without force.</source>
        <translation>Der Clip läuft ohne Kraft.</translation>
    </message>
    <message>
        <source>The firmware of the Falcon belongs to Novint Technologies. libnifalcon passes it on under Novint&apos;s SDK licence (its file license/LICENSE_NOVINT.txt): for personal, noncommercial use, free of charge, and every recipient is bound by it. Read that licence; by going on you say that you may use this file. It stays on this computer.</source>
        <translation>Die Firmware des Falcon gehört Novint Technologies. libnifalcon gibt sie unter Novints SDK-Lizenz weiter (dort die Datei license/LICENSE_NOVINT.txt): für persönlichen, nicht kommerziellen Gebrauch, kostenlos, und jeder Empfänger ist an sie gebunden. Lesen Sie diese Lizenz; wenn Sie fortfahren, sagen Sie, dass Sie diese Datei benutzen dürfen. Sie bleibt auf diesem Computer.</translation>
    </message>
    <message>
        <source>The file is sound, but it is none of the firmware files that are known. It would run the motors. Keep it only if you know where it comes from.</source>
        <translation>Die Datei ist heil, aber keine der bekannten Firmware-Dateien. Sie würde die Motoren steuern. Behalten Sie sie nur, wenn Sie wissen, woher sie kommt.</translation>
    </message>
</context>
<context>
    <name>StartPanel</name>
    <message>
        <source>Participant</source>
        <translation>Teilnehmende Person</translation>
    </message>
    <message>
        <source>New participant</source>
        <translation>Neue Person</translation>
    </message>
    <message>
        <source>Go on with {code}</source>
        <translation>Mit {code} fortfahren</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Play a clip</source>
        <translation>Einen Clip spielen</translation>
    </message>
    <message>
        <source>Listen whether the sound is heard</source>
        <translation>Hören, ob der Ton ankommt</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Stays as it is for the whole session, and is kept with it</source>
        <translation>Bleibt für die ganze Sitzung gleich und wird mit ihr gespeichert</translation>
    </message>
    <message>
        <source>The sound is heard</source>
        <translation>Der Ton ist zu hören</translation>
    </message>
    <message>
        <source>Begin although something is not in order</source>
        <translation>Beginnen, obwohl nicht alles in Ordnung ist</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Show the first page to the participant</source>
        <translation>Der Person die erste Seite zeigen</translation>
    </message>
    <message>
        <source>Language of the pages</source>
        <translation>Sprache der Seiten</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Balance so far</source>
        <translation>Bisherige Verteilung</translation>
    </message>
    <message>
        <source>each condition {a} to {b} times at each place, {c} to {d} times after each other</source>
        <translation>jede Bedingung {a}- bis {b}-mal an jeder Stelle, {c}- bis {d}-mal nach jeder anderen</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Grip found</source>
        <translation>Griff gefunden</translation>
    </message>
    <message>
        <source>Real-time class</source>
        <translation>Echtzeitklasse</translation>
    </message>
    <message>
        <source>Participant&apos;s screen</source>
        <translation>Bildschirm der Person</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Datenträger</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>gehört</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>nicht bestätigt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>the device has said nothing yet</source>
        <translation>das Gerät hat sich noch nicht gemeldet</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
</context>
<context>
    <name>Statistics</name>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>{shown} gezeigt, {dropped} weg</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Feedback</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>Late, µs</source>
        <translation>Verspätung, µs</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>{n} in 10 s, {missed} missed</source>
        <translation>{n} in 10 s, {missed} verpasst</translation>
    </message>
    <message>
        <source>Force − picture, ms</source>
        <translation>Kraft − Bild, ms</translation>
    </message>
    <message>
        <source>Force − sound, ms</source>
        <translation>Kraft − Ton, ms</translation>
    </message>
    <message>
        <source>Latency, ms</source>
        <translation>Latenz, ms</translation>
    </message>
    <message>
        <source>Planned, N</source>
        <translation>Geplant, N</translation>
    </message>
    <message>
        <source>Sent, N</source>
        <translation>Gesendet, N</translation>
    </message>
    <message>
        <source>Centring, N</source>
        <translation>Zentrierung, N</translation>
    </message>
    <message>
        <source>Grip, mm</source>
        <translation>Griff, mm</translation>
    </message>
    <message>
        <source>picture {0:.0f}  sound {1:.0f}  force {2:.0f}  output {3:.0f}</source>
        <translation>Bild {0:.0f}  Ton {1:.0f}  Kraft {2:.0f}  Ausgabe {3:.0f}</translation>
    </message>
</context>
<context>
    <name>StudyEditor</name>
    <message>
        <source>Study – {name}</source>
        <translation>Studie – {name}</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Never the same sequence twice in a row</source>
        <translation>Nie zweimal nacheinander dieselbe Sequenz</translation>
    </message>
    <message>
        <source>The operator does not see the condition</source>
        <translation>Die Leitung sieht die Bedingung nicht</translation>
    </message>
    <message>
        <source>Show the published wording where there is one</source>
        <translation>Den veröffentlichten Wortlaut zeigen, wo es ihn gibt</translation>
    </message>
    <message>
        <source>Offer markers and force to other programs on this machine (LSL)</source>
        <translation>Marken und Kraft anderen Programmen auf diesem Rechner anbieten (LSL)</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Random for each participant</source>
        <translation>Zufällig für jede Person</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Lateinisches Quadrat</translation>
    </message>
    <message>
        <source>Williams: balanced for what came before</source>
        <translation>Williams: ausgeglichen nach dem Vorangegangenen</translation>
    </message>
    <message>
        <source>From orders.csv</source>
        <translation>Aus orders.csv</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose the folder of a sequence</source>
        <translation>Den Ordner einer Sequenz wählen</translation>
    </message>
    <message>
        <source>Folder of a sequence</source>
        <translation>Ordner einer Sequenz</translation>
    </message>
    <message>
        <source> (published)</source>
        <translation> (veröffentlicht)</translation>
    </message>
</context>
<context>
    <name>StudyMenu</name>
    <message>
        <source>&amp;Study</source>
        <translation>&amp;Studie</translation>
    </message>
    <message>
        <source>&amp;New study…</source>
        <translation>&amp;Neue Studie…</translation>
    </message>
    <message>
        <source>&amp;Edit study…</source>
        <translation>Studie &amp;bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Run a participant…</source>
        <translation>&amp;Sitzung durchführen…</translation>
    </message>
    <message>
        <source>&amp;Analyse study…</source>
        <translation>Studie &amp;auswerten…</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Folder of a study</source>
        <translation>Ordner einer Studie</translation>
    </message>
</context>
<context>
    <name>SyncPage</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Media time at which the log&apos;s clock reads zero</source>
        <translation>Medienzeit, zu der die Uhr des Protokolls null zeigt</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Sound later than picture</source>
        <translation>Ton später als Bild</translation>
    </message>
    <message>
        <source>How much later than its picture the camera&apos;s sound comes</source>
        <translation>Um wie viel der Ton der Kamera später kommt als ihr Bild</translation>
    </message>
    <message>
        <source>keep for this camera</source>
        <translation>für diese Kamera behalten</translation>
    </message>
    <message>
        <source>I have looked and listened: this offset is right</source>
        <translation>Ich habe hingesehen und hingehört: Dieser Versatz stimmt</translation>
    </message>
    <message>
        <source>&amp;Whole clip</source>
        <translation>&amp;Ganzer Clip</translation>
    </message>
    <message>
        <source>Show the whole clip</source>
        <translation>Den ganzen Clip zeigen</translation>
    </message>
    <message>
        <source>The &amp;pats</source>
        <translation>Die &amp;Klopfer</translation>
    </message>
    <message>
        <source>Show the pats closely</source>
        <translation>Die Klopfer aus der Nähe zeigen</translation>
    </message>
    <message>
        <source>&amp;Hear</source>
        <translation>An&amp;hören</translation>
    </message>
    <message>
        <source>Play what is shown: the clip left, a tick at each knock right</source>
        <translation>Spielen, was zu sehen ist: links der Clip, rechts ein Tick zu jedem Stoß</translation>
    </message>
    <message>
        <source>&amp;Offset</source>
        <translation>&amp;Versatz</translation>
    </message>
    <message>
        <source>S&amp;ound later than picture</source>
        <translation>T&amp;on später als Bild</translation>
    </message>
    <message>
        <source>Drag the acceleration until it lies under the sound; the arrow keys move it by 1 ms, with Shift by 10 ms, with Ctrl by 100 ms. The wheel zooms; the picture is that at the cursor, which comma and point move.</source>
        <translation>Ziehen Sie die Beschleunigung, bis sie unter dem Ton liegt; die Pfeiltasten bewegen sie um 1 ms, mit Umschalt um 10 ms, mit Strg um 100 ms. Das Rad vergrößert; das Bild ist das am Zeiger, den Komma und Punkt bewegen.</translation>
    </message>
    <message>
        <source>{recorder} keeps its motion on the clip&apos;s own clock.</source>
        <translation>{recorder} führt die Bewegung auf der Uhr des Clips.</translation>
    </message>
    <message>
        <source>Nothing to go by: {why}. Give the offset by hand.</source>
        <translation>Kein Anhaltspunkt: {why}. Geben Sie den Versatz von Hand an.</translation>
    </message>
    <message>
        <source>The offset was moved by hand.</source>
        <translation>Der Versatz wurde von Hand verschoben.</translation>
    </message>
    <message>
        <source>The pats were found (confidence {confidence}, residual {ms} ms).</source>
        <translation>Die Klopfer wurden gefunden (Sicherheit {confidence}, Rest {ms} ms).</translation>
    </message>
    <message>
        <source>The pats are not certain (confidence {confidence}). Look whether the same events lie under each other, and drag them if not.</source>
        <translation>Die Klopfer sind nicht sicher (Sicherheit {confidence}). Sehen Sie nach, ob dieselben Ereignisse untereinander liegen, und ziehen Sie sie sonst.</translation>
    </message>
    <message>
        <source>No three pats are both heard and felt; drag by hand.</source>
        <translation>Keine drei Klopfer sind zu hören und zu fühlen; ziehen Sie von Hand.</translation>
    </message>
</context>
<context>
    <name>SyncPlot</name>
    <message>
        <source>Sync plot</source>
        <translation>Sync-Verlauf</translation>
    </message>
    <message>
        <source>How much later than its picture and its sound the force came in the last 30 s. Nobody feels what lies between 15 ms early and 50 ms late</source>
        <translation>Um wie viel später als ihr Bild und ihr Ton die Kraft in den letzten 30 s kam. Was zwischen 15 ms zu früh und 50 ms zu spät liegt, spürt niemand</translation>
    </message>
    <message>
        <source>Force − picture</source>
        <translation>Kraft − Bild</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Kraft − Ton</translation>
    </message>
</context>
<context>
    <name>SyncStrip</name>
    <message>
        <source>Sound and acceleration</source>
        <translation>Ton und Beschleunigung</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>{time} s</source>
        <translation>{time} s</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>{title}: {text}</source>
        <translation>{title}: {text}</translation>
    </message>
    <message>
        <source>riding</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>drawing the ride</source>
        <translation>die Fahrt wird gezeichnet</translation>
    </message>
    <message>
        <source>adding telemetry</source>
        <translation>Telemetrie</translation>
    </message>
    <message>
        <source>writing the logs</source>
        <translation>Protokolle werden geschrieben</translation>
    </message>
    <message>
        <source>listening</source>
        <translation>Ton wird angehört</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>gelesen wird</translation>
    </message>
    <message>
        <source>synchronising</source>
        <translation>wird synchronisiert</translation>
    </message>
    <message>
        <source>removing gravity</source>
        <translation>Schwerkraft wird entfernt</translation>
    </message>
    <message>
        <source>predicting excursions</source>
        <translation>Ausschläge werden vorhergesagt</translation>
    </message>
    <message>
        <source>rendering the force</source>
        <translation>Kraft wird berechnet</translation>
    </message>
    <message>
        <source>copying the clip</source>
        <translation>Clip wird kopiert</translation>
    </message>
    <message>
        <source>computing checksums</source>
        <translation>Prüfsummen</translation>
    </message>
    <message>
        <source>reading the answers</source>
        <translation>Antworten werden gelesen</translation>
    </message>
    <message>
        <source>analysing</source>
        <translation>ausgewertet wird</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>gezeichnet wird</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>geschrieben wird</translation>
    </message>
    <message>
        <source>writing the numbers</source>
        <translation>Zahlen werden geschrieben</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position in the clip: click or drag</source>
        <translation>Stelle im Clip: klicken oder ziehen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Speed; Backspace for normal speed</source>
        <translation>Geschwindigkeit; Rücktaste für normale</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Feedback</translation>
    </message>
    <message>
        <source>Which force goes with the clip</source>
        <translation>Welche Kraft zum Clip gehört</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Which haptic device is moved</source>
        <translation>Welches haptische Gerät bewegt wird</translation>
    </message>
    <message>
        <source>Fullscreen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Show the clip and nothing else (F)</source>
        <translation>Nur den Clip zeigen (F)</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Volume (9 and 0)</source>
        <translation>Lautstärke (9 und 0)</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ton an</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>{name} (M)</source>
        <translation>{name} (M)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>{name} (Space)</source>
        <translation>{name} (Leertaste)</translation>
    </message>
    <message>
        <source>The force was stopped: let it come back (Ctrl+R)</source>
        <translation>Die Kraft wurde gestoppt: wieder freigeben (Strg+R)</translation>
    </message>
    <message>
        <source>Take the force away at once and pause (Esc)</source>
        <translation>Die Kraft sofort wegnehmen und anhalten (Esc)</translation>
    </message>
    <message>
        <source>Re-arm the force</source>
        <translation>Kraft freigeben</translation>
    </message>
    <message>
        <source>Stop the force</source>
        <translation>Kraft stoppen</translation>
    </message>
    <message>
        <source>Re-arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
</context>
<context>
    <name>Triad</name>
    <message>
        <source>Right is {right}, front is {front}, up is {up}</source>
        <translation>Rechts ist {right}, vorn ist {front}, oben ist {up}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
</context>
<context>
    <name>VideoSurface</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>_Question</name>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>KEY=VALUE, several with blanks between</source>
        <translation>SCHLÜSSEL=WERT, mehrere mit Leerzeichen dazwischen</translation>
    </message>
    <message>
        <source>&amp;Answer</source>
        <translation>&amp;Antworten</translation>
    </message>
    <message>
        <source>Read the log with this answer</source>
        <translation>Das Protokoll mit dieser Antwort lesen</translation>
    </message>
    <message>
        <source>&amp;Template…</source>
        <translation>&amp;Vorlage…</translation>
    </message>
    <message>
        <source>Take the answers from a file</source>
        <translation>Die Antworten aus einer Datei nehmen</translation>
    </message>
</context>
</TS>
