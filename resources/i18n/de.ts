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
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
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
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
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
        <translation>Bibliothe&amp;k…</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>&amp;Demo öffnen</translation>
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
        <source>Replay a &amp;log…</source>
        <translation>&amp;Protokoll abspielen…</translation>
    </message>
    <message>
        <source>Re&amp;cord…</source>
        <translation>&amp;Aufnehmen…</translation>
    </message>
    <message>
        <source>&amp;Playlist…</source>
        <translation>&amp;Wiedergabeliste…</translation>
    </message>
    <message>
        <source>Edit &amp;effects…</source>
        <translation>&amp;Effekte bearbeiten…</translation>
    </message>
    <message>
        <source>Re&amp;ndering…</source>
        <translation>Re&amp;ndering…</translation>
    </message>
    <message>
        <source>S&amp;hare…</source>
        <translation>&amp;Teilen…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Voreinstellungen…</translation>
    </message>
    <message>
        <source>E&amp;xport settings…</source>
        <translation>Einstellungen e&amp;xportieren…</translation>
    </message>
    <message>
        <source>&amp;Back 5 s</source>
        <translation>5 s &amp;zurück</translation>
    </message>
    <message>
        <source>&amp;Forward 5 s</source>
        <translation>5 s &amp;vor</translation>
    </message>
    <message>
        <source>Back 1 min</source>
        <translation>1 min zurück</translation>
    </message>
    <message>
        <source>Forward 1 min</source>
        <translation>1 min vor</translation>
    </message>
    <message>
        <source>Go to the b&amp;eginning</source>
        <translation>Zum An&amp;fang</translation>
    </message>
    <message>
        <source>Go to the e&amp;nd</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Ne&amp;xt file</source>
        <translation>Nächste &amp;Datei</translation>
    </message>
    <message>
        <source>P&amp;revious file</source>
        <translation>V&amp;orige Datei</translation>
    </message>
    <message>
        <source>Repea&amp;t: off, this clip, all</source>
        <translation>&amp;Wiederholen: aus, dieser Clip, alle</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>&amp;Loop: set start, set end, off</source>
        <translation>Sch&amp;leife: Anfang, Ende, aus</translation>
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
        <source>&amp;Try out the forces…</source>
        <translation>&amp;Kräfte ausprobieren…</translation>
    </message>
    <message>
        <source>&amp;Grip view</source>
        <translation>&amp;Griffansicht</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>Ve&amp;rgrößern</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>Verklei&amp;nern</translation>
    </message>
    <message>
        <source>As large as fits</source>
        <translation>So groß wie möglich</translation>
    </message>
    <message>
        <source>Save this frame as a pictu&amp;re</source>
        <translation>Dieses B&amp;ild speichern</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;System check…</source>
        <translation>&amp;Systemprüfung…</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>&amp;Problem melden…</translation>
    </message>
    <message>
        <source>Simulated &amp;motion rig…</source>
        <translation>Simulierte &amp;Bewegungsplattform…</translation>
    </message>
    <message>
        <source>Effects, point or cursor a frame back</source>
        <translation>Effekte, Stützpunkt oder Cursor ein Bild zurück</translation>
    </message>
    <message>
        <source>Effects, point or cursor a frame forward</source>
        <translation>Effekte, Stützpunkt oder Cursor ein Bild vor</translation>
    </message>
    <message>
        <source>Effects or point ten frames, or cursor 1 s back</source>
        <translation>Effekte oder Stützpunkt zehn Bilder, oder Cursor 1 s zurück</translation>
    </message>
    <message>
        <source>Effects or point ten frames, or cursor 1 s forward</source>
        <translation>Effekte oder Stützpunkt zehn Bilder, oder Cursor 1 s vor</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Voriger Marker</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Nächster Marker</translation>
    </message>
    <message>
        <source>Select all effects</source>
        <translation>Alle Effekte auswählen</translation>
    </message>
    <message>
        <source>Select the next effect as well</source>
        <translation>Auch den nächsten Effekt auswählen</translation>
    </message>
    <message>
        <source>Select the previous effect as well</source>
        <translation>Auch den vorigen Effekt auswählen</translation>
    </message>
    <message>
        <source>Next fade or point of the effect</source>
        <translation>Nächste Blende oder nächster Stützpunkt des Effekts</translation>
    </message>
    <message>
        <source>Previous fade or point of the effect</source>
        <translation>Vorige Blende oder voriger Stützpunkt des Effekts</translation>
    </message>
    <message>
        <source>Raise the point</source>
        <translation>Stützpunkt anheben</translation>
    </message>
    <message>
        <source>Lower the point</source>
        <translation>Stützpunkt absenken</translation>
    </message>
    <message>
        <source>Raise the point by ten steps</source>
        <translation>Stützpunkt um zehn Schritte anheben</translation>
    </message>
    <message>
        <source>Lower the point by ten steps</source>
        <translation>Stützpunkt um zehn Schritte absenken</translation>
    </message>
    <message>
        <source>Add a control point at the cursor</source>
        <translation>Stützpunkt am Cursor hinzufügen</translation>
    </message>
    <message>
        <source>Switch the effects on or off</source>
        <translation>Effekte ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Delete the effects, or the point</source>
        <translation>Effekte oder Stützpunkt löschen</translation>
    </message>
    <message>
        <source>Duplicate the effects</source>
        <translation>Effekte duplizieren</translation>
    </message>
    <message>
        <source>Copy the effects</source>
        <translation>Effekte kopieren</translation>
    </message>
    <message>
        <source>Paste the effects at the cursor</source>
        <translation>Effekte am Cursor einfügen</translation>
    </message>
    <message>
        <source>Go back without force; again for faster</source>
        <translation>Rückwärts ohne Kraft; noch einmal: schneller</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play; again for faster</source>
        <translation>Abspielen; noch einmal: schneller</translation>
    </message>
    <message>
        <source>Set a marker at the cursor</source>
        <translation>Marker am Cursor setzen</translation>
    </message>
    <message>
        <source>End of the effect a frame back</source>
        <translation>Ende des Effekts ein Bild zurück</translation>
    </message>
    <message>
        <source>End of the effect a frame forward</source>
        <translation>Ende des Effekts ein Bild vor</translation>
    </message>
    <message>
        <source>Start of the effect a frame back</source>
        <translation>Anfang des Effekts ein Bild zurück</translation>
    </message>
    <message>
        <source>Start of the effect a frame forward</source>
        <translation>Anfang des Effekts ein Bild vor</translation>
    </message>
    <message>
        <source>Cursor a frame back</source>
        <translation>Cursor ein Bild zurück</translation>
    </message>
    <message>
        <source>Cursor a frame forward</source>
        <translation>Cursor ein Bild vor</translation>
    </message>
    <message>
        <source>Cursor to the beginning</source>
        <translation>Cursor an den Anfang</translation>
    </message>
    <message>
        <source>Cursor to the end</source>
        <translation>Cursor ans Ende</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Offer the effect of the event at the cursor</source>
        <translation>Den Effekt zum Ereignis am Cursor vorschlagen</translation>
    </message>
    <message>
        <source>Undo the change of effects</source>
        <translation>Änderung der Effekte rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the change of effects</source>
        <translation>Änderung der Effekte wiederholen</translation>
    </message>
    <message>
        <source>Save the effects</source>
        <translation>Effekte speichern</translation>
    </message>
    <message>
        <source>Inject fa&amp;ults…</source>
        <translation>&amp;Fehler einspeisen…</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>&amp;Tastenkürzel…</translation>
    </message>
    <message>
        <source>Measure l&amp;atencies…</source>
        <translation>&amp;Latenzen messen…</translation>
    </message>
    <message>
        <source>Other feedbac&amp;k…</source>
        <translation>Anderes Feed&amp;back…</translation>
    </message>
    <message>
        <source>&amp;Outputs…</source>
        <translation>&amp;Ausgaben…</translation>
    </message>
    <message>
        <source>Live &amp;plots</source>
        <translation>&amp;Kurven</translation>
    </message>
    <message>
        <source>S&amp;ync plot</source>
        <translation>S&amp;ync-Verlauf</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>S&amp;tatistik</translation>
    </message>
    <message>
        <source>&amp;Fullscreen</source>
        <translation>&amp;Vollbild</translation>
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
        <source>Compute statistics and figures again</source>
        <translation>Statistik und Abbildungen neu berechnen</translation>
    </message>
    <message>
        <source>Write the report, its figures and the data to a new folder</source>
        <translation>Bericht, Abbildungen und Daten in einen neuen Ordner schreiben</translation>
    </message>
    <message>
        <source>No valid answer yet: there is nothing to publish.</source>
        <translation>Noch keine gültige Antwort: Es gibt nichts zu veröffentlichen.</translation>
    </message>
    <message>
        <source>The report is in English, ready for publication.</source>
        <translation>Der Bericht ist auf Englisch, fertig zur Veröffentlichung.</translation>
    </message>
    <message>
        <source>Saved to {0}</source>
        <translation>Gespeichert in {0}</translation>
    </message>
    <message>
        <source>Choose where to create the report folder</source>
        <translation>Wo soll der Ordner des Berichts angelegt werden?</translation>
    </message>
    <message>
        <source>&amp;Save report…</source>
        <translation>Bericht &amp;speichern…</translation>
    </message>
    <message>
        <source>The report is in English.</source>
        <translation>Der Bericht ist auf Englisch.</translation>
    </message>
    <message>
        <source>Analysing</source>
        <translation>Auswertung läuft</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
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
    <name>ChangeBar</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the effects and render the force with them (Ctrl+S)</source>
        <translation>Effekte speichern und die Kraft damit rendern (Strg+S)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>CheckList</name>
    <message>
        <source>What the device needs</source>
        <translation>Was das Gerät braucht</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>not visible from here</source>
        <translation>von hier aus nicht zu sehen</translation>
    </message>
</context>
<context>
    <name>CheckPage</name>
    <message>
        <source>System check</source>
        <translation>Systemprüfung</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the whole text</source>
        <translation>Den ganzen Text kopieren</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>What is installed, what is missing, and how to get it.</source>
        <translation>Was installiert ist, was fehlt und woher man es bekommt.</translation>
    </message>
</context>
<context>
    <name>ChoiceForm</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Size and rate of the camera</source>
        <translation>Größe und Bildrate der Kamera</translation>
    </message>
    <message>
        <source>Microphone</source>
        <translation>Mikrofon</translation>
    </message>
    <message>
        <source>Motion sensor</source>
        <translation>Bewegungssensor</translation>
    </message>
    <message>
        <source>Place of the motion sensor</source>
        <translation>Anschluss des Bewegungssensors</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>&amp;Neu suchen</translation>
    </message>
    <message>
        <source>Look for cameras and microphones again</source>
        <translation>Kameras und Mikrofone noch einmal suchen</translation>
    </message>
    <message>
        <source>The folder that takes are saved in</source>
        <translation>Der Ordner, in dem Aufnahmen gespeichert werden</translation>
    </message>
    <message>
        <source>Save i&amp;n…</source>
        <translation>Spei&amp;chern in…</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Si&amp;ze and rate</source>
        <translation>&amp;Größe und Bildrate</translation>
    </message>
    <message>
        <source>M&amp;icrophone</source>
        <translation>M&amp;ikrofon</translation>
    </message>
    <message>
        <source>Motion &amp;sensor</source>
        <translation>Bewegungs&amp;sensor</translation>
    </message>
    <message>
        <source>at &amp;place</source>
        <translation>Anschl&amp;uss</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>As the camera offers</source>
        <translation>Wie die Kamera es anbietet</translation>
    </message>
    <message>
        <source>{width} × {height}, {rate} fps</source>
        <translation>{width} × {height}, {rate} Bilder/s</translation>
    </message>
    <message>
        <source>No camera was found: plug one in, and press Look again.</source>
        <translation>Keine Kamera gefunden: Schließen Sie eine an, und drücken Sie „Neu suchen“.</translation>
    </message>
    <message>
        <source>No microphone was found.</source>
        <translation>Kein Mikrofon gefunden.</translation>
    </message>
    <message>
        <source>Without a motion sensor, motion can be suggested from the frames.</source>
        <translation>Ohne Bewegungssensor kann Bewegung aus den Bildern vorgeschlagen werden.</translation>
    </message>
    <message>
        <source>Looking for cameras…</source>
        <translation>Kameras werden gesucht…</translation>
    </message>
    <message>
        <source>Options may follow a comma: {options}</source>
        <translation>Nach einem Komma sind Optionen möglich: {options}</translation>
    </message>
    <message>
        <source>Choose where takes are saved</source>
        <translation>Wo Aufnahmen gespeichert werden</translation>
    </message>
</context>
<context>
    <name>Choices</name>
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
        <source>System default</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Same screen as the window</source>
        <translation>Bildschirm des Fensters</translation>
    </message>
    <message>
        <source>Fullscreen &amp;on</source>
        <translation>Vollbild &amp;auf</translation>
    </message>
</context>
<context>
    <name>ClipFrame</name>
    <message>
        <source>Frame at the cursor</source>
        <translation>Bild am Cursor</translation>
    </message>
</context>
<context>
    <name>ColumnMap</name>
    <message>
        <source>Column {number}</source>
        <translation>Spalte {number}</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Without → with effects: RMS {rms}, peak {peak}, at the limit {limit}, reach of a relaxed hand {reach}</source>
        <translation>Ohne → mit Effekten: Effektivwert {rms}, Spitze {peak}, an der Grenze {limit}, Auslenkung einer lockeren Hand {reach}</translation>
    </message>
    <message>
        <source>the force would be stopped</source>
        <translation>die Kraft würde abgeschaltet</translation>
    </message>
</context>
<context>
    <name>ConditionDialog</name>
    <message>
        <source>Other feedback</source>
        <translation>Anderes Feedback</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Make this force and play it</source>
        <translation>Diese Kraft berechnen und abspielen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
</context>
<context>
    <name>ConditionForm</name>
    <message>
        <source>Feedback</source>
        <translation>Feedback</translation>
    </message>
    <message>
        <source>As rendered</source>
        <translation>Wie berechnet</translation>
    </message>
    <message>
        <source>With the effects of the sequence</source>
        <translation>Mit den Effekten der Sequenz</translation>
    </message>
    <message>
        <source>The next one</source>
        <translation>Die nächste</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose a sequence folder</source>
        <translation>Ordner einer Sequenz wählen</translation>
    </message>
</context>
<context>
    <name>ConditionList</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Choose a condition</source>
        <translation>Bedingung wählen</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Level (delay and gain)</source>
        <translation>Stufe (Verzögerung und Verstärkung)</translation>
    </message>
    <message>
        <source>Each of them is compared with</source>
        <translation>Jede davon wird verglichen mit</translation>
    </message>
    <message>
        <source>The standard</source>
        <translation>Der Standard</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Treppenverfahren</translation>
    </message>
    <message>
        <source>Each of them at these levels</source>
        <translation>Jede davon mit diesen Stufen</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Delay of the force</source>
        <translation>Verzögerung der Kraft</translation>
    </message>
    <message>
        <source>Gain of the force</source>
        <translation>Verstärkung der Kraft</translation>
    </message>
    <message>
        <source>Repeats of each trial</source>
        <translation>Wiederholungen jedes Durchgangs</translation>
    </message>
    <message>
        <source>The track {name} that each sequence has</source>
        <translation>Die Spur {name}, die jede Sequenz hat</translation>
    </message>
    <message>
        <source>another condition</source>
        <translation>andere Bedingung</translation>
    </message>
    <message>
        <source>Each sequence is played under each condition. Sessions that have begun keep theirs.</source>
        <translation>Jede Sequenz wird unter jeder Bedingung gespielt. Begonnene Sitzungen behalten ihre.</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>2-down 1-up</source>
        <translation>2-down 1-up</translation>
    </message>
    <message>
        <source>3-down 1-up</source>
        <translation>3-down 1-up</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>First change</source>
        <translation>Erste Änderung</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Trials of each</source>
        <translation>Durchgänge von jeder</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Name in den Daten</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>In Daten und Abbildungen: a bis z, 0 bis 9, _ und -</translation>
    </message>
    <message>
        <source>another name in the data</source>
        <translation>anderer Name in den Daten</translation>
    </message>
    <message>
        <source>another level</source>
        <translation>andere Stufe</translation>
    </message>
</context>
<context>
    <name>ConditionPreview</name>
    <message>
        <source>Recorded force</source>
        <translation>Aufgezeichnete Kraft</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gespürte Kraft</translation>
    </message>
    <message>
        <source>Preview of the force</source>
        <translation>Vorschau der Kraft</translation>
    </message>
    <message>
        <source>Choose a recording for a sequence to see the force</source>
        <translation>Wählen Sie für eine Sequenz eine Aufnahme, um die Kraft zu sehen</translation>
    </message>
    <message>
        <source>Computing the force…</source>
        <translation>Kraft wird berechnet…</translation>
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
    <name>DemoEnd</name>
    <message>
        <source>End of the demo</source>
        <translation>Ende der Demo</translation>
    </message>
    <message>
        <source>That was the demo. What next?</source>
        <translation>Das war die Demo. Wie geht es weiter?</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Noch einmal abspielen</translation>
    </message>
    <message>
        <source>Play the demo from its beginning</source>
        <translation>Die Demo von vorn abspielen</translation>
    </message>
    <message>
        <source>Import your own…</source>
        <translation>Eigenes importieren…</translation>
    </message>
    <message>
        <source>Create a sequence from a video and its motion data</source>
        <translation>Eine Sequenz aus einem Video und seinen Bewegungsdaten erzeugen</translation>
    </message>
    <message>
        <source>Choose a device…</source>
        <translation>Gerät wählen…</translation>
    </message>
    <message>
        <source>The haptic device to use; the simulated one needs no hardware</source>
        <translation>Das haptische Gerät; das simulierte braucht keine Hardware</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>playing a clip</source>
        <translation>spielt einen Clip ab</translation>
    </message>
</context>
<context>
    <name>DeviceDialogs</name>
    <message>
        <source>Choose a device first, then try out its forces</source>
        <translation>Wählen Sie zuerst ein Gerät und probieren Sie dann seine Kräfte aus</translation>
    </message>
</context>
<context>
    <name>DeviceForm</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Address or settings</source>
        <translation>Adresse oder Einstellungen</translation>
    </message>
</context>
<context>
    <name>DevicePage</name>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Feel every direction, starting gently</source>
        <translation>Jede Richtung spüren, sanft beginnend</translation>
    </message>
    <message>
        <source>Stop the force immediately (Esc)</source>
        <translation>Kraft sofort abschalten (Esc)</translation>
    </message>
    <message>
        <source>Try out the forces: {name}</source>
        <translation>Kräfte ausprobieren: {name}</translation>
    </message>
    <message>
        <source>Release the device</source>
        <translation>Gerät freigeben</translation>
    </message>
    <message>
        <source>Demonstration finished.</source>
        <translation>Vorführung beendet.</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>You will feel each force three times, starting gently. Esc, STOP or a button on the device stops it immediately.</source>
        <translation>Sie spüren jede Kraft dreimal, zuerst sanft. Esc, STOPP oder eine Taste am Gerät beendet sie sofort.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>DevicePicture</name>
    <message>
        <source>Grip</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Force is off</source>
        <translation>Kraft ist aus</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Platform of the rig</source>
        <translation>Platte der Bewegungsplattform</translation>
    </message>
    <message>
        <source>up {up} mm; roll {roll}, pitch {pitch}, yaw {yaw} degrees</source>
        <translation>{up} mm nach oben; Neigen {roll}, Nicken {pitch}, Drehen {yaw} Grad</translation>
    </message>
    <message>
        <source>at the end of its reach</source>
        <translation>am Ende der Reichweite</translation>
    </message>
    <message>
        <source>Motion shown {factor}× larger</source>
        <translation>Bewegung {factor}-fach vergrößert</translation>
    </message>
    <message>
        <source>Force along one axis</source>
        <translation>Kraft entlang einer Achse</translation>
    </message>
    <message>
        <source>Strength of the vibration</source>
        <translation>Stärke der Vibration</translation>
    </message>
</context>
<context>
    <name>DeviceTestPanel</name>
    <message>
        <source>Test…</source>
        <translation>Testen…</translation>
    </message>
    <message>
        <source>Moves it gently; asks first</source>
        <translation>Bewegt es sanft; fragt vorher</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Stop the force immediately (Esc)</source>
        <translation>Kraft sofort abschalten (Esc)</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Fortschritt des Tests</translation>
    </message>
    <message>
        <source>Test the device</source>
        <translation>Gerät testen</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Test starten</translation>
    </message>
    <message>
        <source>Waiting until the device is at rest</source>
        <translation>Warten, bis das Gerät ruht</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Coming to rest</source>
        <translation>Kommt zur Ruhe</translation>
    </message>
</context>
<context>
    <name>DeviceTestWords</name>
    <message>
        <source>Esc or STOP ends it immediately.</source>
        <translation>Esc oder STOPP beendet es sofort.</translation>
    </message>
    <message>
        <source>It will move gently for {seconds} s, along and about one axis after the other.</source>
        <translation>Es bewegt sich {seconds} s lang sanft, entlang und um eine Achse nach der anderen.</translation>
    </message>
    <message>
        <source>It will vibrate on the channels {channels}, one after the other, for {seconds} s, with up to {strength}.</source>
        <translation>Es vibriert {seconds} s lang auf den Kanälen {channels}, einem nach dem anderen, mit bis zu {strength}.</translation>
    </message>
    <message>
        <source>It will vibrate for {seconds} s, with up to {strength}.</source>
        <translation>Es vibriert {seconds} s lang, mit bis zu {strength}.</translation>
    </message>
    <message>
        <source>It will turn or pull to one side and to the other for {seconds} s, with up to {strength}.</source>
        <translation>Es dreht oder zieht {seconds} s lang zur einen und zur anderen Seite, mit bis zu {strength}.</translation>
    </message>
    <message>
        <source>It will push gently in each direction for {seconds} s, with up to {strength}.</source>
        <translation>Es drückt {seconds} s lang sanft in jede Richtung, mit bis zu {strength}.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>Channel {label}: {what}</source>
        <translation>Kanal {label}: {what}</translation>
    </message>
    <message>
        <source>Surge: forwards and back</source>
        <translation>Vor und zurück</translation>
    </message>
    <message>
        <source>Sway: to the right and back</source>
        <translation>Nach rechts und zurück</translation>
    </message>
    <message>
        <source>Heave: up and back</source>
        <translation>Nach oben und zurück</translation>
    </message>
    <message>
        <source>Roll: leaning to the right and back</source>
        <translation>Neigen nach rechts und zurück</translation>
    </message>
    <message>
        <source>Pitch: nose up and back</source>
        <translation>Nicken nach oben und zurück</translation>
    </message>
    <message>
        <source>Yaw: turning to the left and back</source>
        <translation>Drehen nach links und zurück</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Test finished.</source>
        <translation>Test beendet.</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open a sequence folder</source>
        <translation>Sequenzordner öffnen</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Replay the forces of a log</source>
        <translation>Kräfte eines Protokolls abspielen</translation>
    </message>
    <message>
        <source>Only the effects of a sequence can be edited: import the video first</source>
        <translation>Nur die Effekte einer Sequenz lassen sich bearbeiten: Video zuerst importieren</translation>
    </message>
    <message>
        <source>Only a sequence can be shared: import the video first. A file that was shared with you can be sent on as it is.</source>
        <translation>Nur eine Sequenz kann geteilt werden: Importieren Sie das Video zuerst. Eine Datei, die mit Ihnen geteilt wurde, können Sie weitergeben, wie sie ist.</translation>
    </message>
    <message>
        <source>Only a sequence can be rendered: import the video first, or unpack a file that was shared with you.</source>
        <translation>Nur die Kraft einer Sequenz kann neu berechnet werden: Importieren Sie zuerst das Video, oder entpacken Sie eine Datei, die mit Ihnen geteilt wurde.</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Einstellungen exportieren</translation>
    </message>
    <message>
        <source>Logs (*.jsonl *.json *.log);;All files (*)</source>
        <translation>Protokolle (*.jsonl *.json *.log);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
</context>
<context>
    <name>Dropping</name>
    <message>
        <source>Clips: {count}. Imported, those with motion can be felt.</source>
        <translation>Clips: {count}. Nach dem Import sind die mit Bewegung zu spüren.</translation>
    </message>
    <message>
        <source>Import all…</source>
        <translation>Alle importieren…</translation>
    </message>
    <message>
        <source>{name} contains motion data, which plays once it is imported.</source>
        <translation>{name} enthält Bewegungsdaten, die nach dem Import mitspielen.</translation>
    </message>
    <message>
        <source>Import and feel it…</source>
        <translation>Importieren und spüren…</translation>
    </message>
    <message>
        <source>{name} has no motion data; drop its log here, or let its frames suggest it.</source>
        <translation>{name} hat keine Bewegungsdaten; ziehen Sie das Protokoll hierher, oder lassen Sie Bewegung aus den Bildern vorschlagen.</translation>
    </message>
    <message>
        <source>Suggest motion from the frames…</source>
        <translation>Bewegung aus den Bildern vorschlagen…</translation>
    </message>
</context>
<context>
    <name>Editing</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Blende</translation>
    </message>
    <message>
        <source>Move the point</source>
        <translation>Stützpunkt verschieben</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Stützpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Change the order</source>
        <translation>Reihenfolge ändern</translation>
    </message>
    <message>
        <source>Marker {number}</source>
        <translation>Marker {number}</translation>
    </message>
    <message>
        <source>Set a marker</source>
        <translation>Marker setzen</translation>
    </message>
    <message>
        <source>Rename the marker</source>
        <translation>Marker umbenennen</translation>
    </message>
    <message>
        <source>Remove the marker</source>
        <translation>Marker entfernen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Stützpunkt löschen</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
</context>
<context>
    <name>EditingLanes</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>{count} effects are selected</source>
        <translation>{count} Effekte ausgewählt</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Stützpunkt löschen</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
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
        <source>Add the effect: {name}, {span}</source>
        <translation>Effekt hinzufügen: {name}, {span}</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>Edit effects</source>
        <translation>Effekte bearbeiten</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Save your changes to the effects?</source>
        <translation>Ihre Änderungen an den Effekten speichern?</translation>
    </message>
    <message>
        <source>Rendering the force</source>
        <translation>Kraft wird berechnet</translation>
    </message>
    <message>
        <source>Reading the sequence</source>
        <translation>Sequenz wird gelesen</translation>
    </message>
</context>
<context>
    <name>EffectPanel</name>
    <message>
        <source>Switched &amp;on</source>
        <translation>&amp;Eingeschaltet</translation>
    </message>
    <message>
        <source>Add a copy after it (Ctrl+D)</source>
        <translation>Eine Kopie dahinter einfügen (Strg+D)</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>D&amp;uplizieren</translation>
    </message>
    <message>
        <source>Delete it (Del)</source>
        <translation>Löschen (Entf)</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Apply it earlier</source>
        <translation>Früher anwenden</translation>
    </message>
    <message>
        <source>Apply it later</source>
        <translation>Später anwenden</translation>
    </message>
    <message>
        <source>No effect is selected</source>
        <translation>Kein Effekt ausgewählt</translation>
    </message>
    <message>
        <source>{count} effects are selected</source>
        <translation>{count} Effekte ausgewählt</translation>
    </message>
    <message>
        <source>Place in the order in which they are applied</source>
        <translation>Platz in der Reihenfolge, in der sie angewendet werden</translation>
    </message>
    <message>
        <source>Fade in</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Fade out</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Applies &amp;to</source>
        <translation>Gilt f&amp;ür</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Drag a kind of effect onto the timeline, or click an event there. The recorded motion never changes.</source>
        <translation>Eine Art von Effekt auf die Zeitleiste ziehen oder dort ein Ereignis anklicken. Die aufgezeichnete Bewegung ändert sich nie.</translation>
    </message>
    <message>
        <source>Control &amp;points: s after the start, value</source>
        <translation>Stütz&amp;punkte: s nach dem Anfang, Wert</translation>
    </message>
    <message>
        <source>Such as 0 1; 0.5 2; 1 1 – empty for one value</source>
        <translation>Etwa 0 1; 0.5 2; 1 1 – leer für einen einzigen Wert</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Motion before the rendering</source>
        <translation>Bewegung vor dem Rendern</translation>
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
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Change the numbers</source>
        <translation>Zahlen ändern</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change the direction</source>
        <translation>Richtung ändern</translation>
    </message>
    <message>
        <source>Change the control points</source>
        <translation>Stützpunkte ändern</translation>
    </message>
</context>
<context>
    <name>EmptyPage</name>
    <message>
        <source>Feel the motion of what you watch</source>
        <translation>Spüren, was man sieht</translation>
    </message>
    <message>
        <source>Open a sequence or a video, or drop one here. A video on its own plays without force; import it with its motion data to feel it.</source>
        <translation>Öffnen Sie eine Sequenz oder ein Video, oder ziehen Sie eines hierher. Ein Video allein spielt ohne Kraft; importieren Sie es mit seinen Bewegungsdaten, um es zu spüren.</translation>
    </message>
    <message>
        <source>Open a sequence folder</source>
        <translation>Sequenzordner öffnen</translation>
    </message>
    <message>
        <source>Your imported sequences</source>
        <translation>Die importierten Sequenzen</translation>
    </message>
    <message>
        <source>Create a sequence from a video and its motion data</source>
        <translation>Eine Sequenz aus einem Video und seinen Bewegungsdaten erzeugen</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Aufnehmen…</translation>
    </message>
    <message>
        <source>Record with a camera and a motion sensor</source>
        <translation>Mit einer Kamera und einem Bewegungssensor aufnehmen</translation>
    </message>
    <message>
        <source>Choose a device…</source>
        <translation>Gerät wählen…</translation>
    </message>
    <message>
        <source>The haptic device to use; the simulated one needs no hardware</source>
        <translation>Das haptische Gerät; das simulierte braucht keine Hardware</translation>
    </message>
    <message>
        <source>Play the demo</source>
        <translation>Demo abspielen</translation>
    </message>
    <message>
        <source>A simulated ride by bicycle</source>
        <translation>Eine simulierte Fahrt mit dem Fahrrad</translation>
    </message>
    <message>
        <source>Open a sequence…</source>
        <translation>Sequenz öffnen…</translation>
    </message>
    <message>
        <source>Library…</source>
        <translation>Bibliothek…</translation>
    </message>
    <message>
        <source>Import a recording…</source>
        <translation>Aufnahme importieren…</translation>
    </message>
</context>
<context>
    <name>EntryList</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove (Delete)</source>
        <translation>Entfernen (Entf)</translation>
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
        <source>removal</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>another order</source>
        <translation>andere Reihenfolge</translation>
    </message>
</context>
<context>
    <name>ErrorGateway</name>
    <message>
        <source>Internal error ({kind}: {text}). The force was stopped and playback paused.</source>
        <translation>Interner Fehler ({kind}: {text}). Die Kraft wurde abgeschaltet und die Wiedergabe angehalten.</translation>
    </message>
    <message>
        <source>Help &gt; Report a problem saves the details.</source>
        <translation>Hilfe &gt; Problem melden speichert die Einzelheiten.</translation>
    </message>
    <message>
        <source>See the terminal for details.</source>
        <translation>Einzelheiten stehen im Terminal.</translation>
    </message>
</context>
<context>
    <name>Extras</name>
    <message>
        <source>Resuming at {time} (Home: from the start)</source>
        <translation>Weiter bei {time} (Pos1: von vorn)</translation>
    </message>
</context>
<context>
    <name>FaultPanel</name>
    <message>
        <source>Re-arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Re-enable the force (Ctrl+R)</source>
        <translation>Kraft wieder zulassen (Strg+R)</translation>
    </message>
    <message>
        <source>Restart device</source>
        <translation>Gerät neu starten</translation>
    </message>
    <message>
        <source>Start the simulated device again, without the fault</source>
        <translation>Das simulierte Gerät neu starten, ohne den Fehler</translation>
    </message>
    <message>
        <source>Inject faults into the simulated device</source>
        <translation>Fehler in das simulierte Gerät einspeisen</translation>
    </message>
    <message>
        <source>Stop injecting faults</source>
        <translation>Keine Fehler mehr einspeisen</translation>
    </message>
    <message>
        <source>Rule triggered</source>
        <translation>Ausgelöste Regel</translation>
    </message>
    <message>
        <source>Time to zero, ms</source>
        <translation>Zeit bis null, ms</translation>
    </message>
    <message>
        <source>Fault results</source>
        <translation>Ergebnisse der Fehler</translation>
    </message>
    <message>
        <source>Faults can only be injected into a simulated device while this panel is open: choose it in the window, then press Restart device.</source>
        <translation>Fehler lassen sich nur in ein simuliertes Gerät einspeisen, solange dieses Fenster offen ist: wählen Sie es im Hauptfenster und drücken Sie „Gerät neu starten“.</translation>
    </message>
    <message>
        <source>The device has failed: press Restart device.</source>
        <translation>Das Gerät ist ausgefallen: drücken Sie „Gerät neu starten“.</translation>
    </message>
    <message>
        <source>Play a clip with force first.</source>
        <translation>Spielen Sie zuerst einen Clip mit Kraft ab.</translation>
    </message>
    <message>
        <source>The force is active. Press a fault to see how the safety contract responds.</source>
        <translation>Die Kraft ist aktiv. Lösen Sie einen Fehler aus und sehen Sie, wie die Sicherung reagiert.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Reaction, ms</source>
        <translation>Reaktion, ms</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>Stall, 60 ms</source>
        <translation>Stockt 60 ms</translation>
    </message>
    <message>
        <source>Stall, 300 ms</source>
        <translation>Stockt 300 ms</translation>
    </message>
    <message>
        <source>Unplug</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Malformed replies</source>
        <translation>Ungültige Antworten</translation>
    </message>
    <message>
        <source>Lose homing</source>
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
        <source>Loop stalled, 80 ms</source>
        <translation>Schleife steht, 80 ms</translation>
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
    <name>FeelNow</name>
    <message>
        <source>&amp;Feel it now</source>
        <translation>Jetzt s&amp;püren</translation>
    </message>
    <message>
        <source>Feel what the sensor measures at this moment, on the haptic device</source>
        <translation>Am haptischen Gerät spüren, was der Sensor gerade misst</translation>
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
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Drop a recording here</source>
        <translation>Eine Aufnahme hier ablegen</translation>
    </message>
    <message>
        <source>embedded in the video</source>
        <translation>im Video enthalten</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>Automatisch erkennen</translation>
    </message>
    <message>
        <source>&amp;How the log is read…</source>
        <translation>Wie das Protokoll &amp;gelesen wird…</translation>
    </message>
    <message>
        <source>Units, axes, signs and more, with a check against gravity</source>
        <translation>Einheiten, Achsen, Vorzeichen und mehr, mit einer Prüfung an der Schwerkraft</translation>
    </message>
    <message>
        <source>&amp;Save as template…</source>
        <translation>Als Vorlage &amp;speichern…</translation>
    </message>
    <message>
        <source>Save these answers as a template for all logs of this logger</source>
        <translation>Diese Antworten als Vorlage für alle Protokolle dieses Loggers speichern</translation>
    </message>
    <message>
        <source>Drop a video here, together with its motion log if the sensor was a separate device. GoPro cameras store their motion data in the video.</source>
        <translation>Ziehen Sie ein Video hierher, zusammen mit seinem Bewegungsprotokoll, wenn der Sensor ein eigenes Gerät war. GoPro-Kameras speichern ihre Bewegung im Video.</translation>
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
        <source>Se&amp;veral clips…</source>
        <translation>&amp;Mehrere Clips…</translation>
    </message>
    <message>
        <source>Import clips one after the other</source>
        <translation>Clips nacheinander importieren</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>{log} is a motion log. Choose or drop the video of the ride.</source>
        <translation>{log} ist ein Bewegungsprotokoll. Wählen Sie das Video der Fahrt, oder ziehen Sie es hierher.</translation>
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
        <source>Video: {camera}{width} × {height}, {rate} fps, {duration}, {sound}</source>
        <translation>Video: {camera}{width} × {height}, {rate} Bilder/s, {duration}, {sound}</translation>
    </message>
    <message>
        <source>Motion: {recorder}, {rate} Hz, {duration}, gaps: {gaps}</source>
        <translation>Bewegung: {recorder}, {rate} Hz, {duration}, Lücken: {gaps}</translation>
    </message>
    <message>
        <source>The sensor rotated too much to tell its axes from gravity.</source>
        <translation>Der Sensor hat sich zu stark gedreht, um seine Achsen aus der Schwerkraft zu bestimmen.</translation>
    </message>
    <message>
        <source>Axes: x right, y forward, z up of the sensor; on average {up} pointed up</source>
        <translation>Achsen: x rechts, y vorn, z oben am Sensor; im Mittel zeigte {up} nach oben</translation>
    </message>
    <message>
        <source>Save the template</source>
        <translation>Vorlage speichern</translation>
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
        <source>Install anyway</source>
        <translation>Trotzdem installieren</translation>
    </message>
</context>
<context>
    <name>ForceTexts</name>
    <message>
        <source>Force tracks ({patterns})</source>
        <translation>Kraftspuren ({patterns})</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>ForceWords</name>
    <message>
        <source>Pull the grip all the way out, then push it in until it locks</source>
        <translation>Ziehen Sie den Griff ganz heraus und schieben Sie ihn dann hinein, bis er einrastet</translation>
    </message>
    <message>
        <source>{percent} % of its strength</source>
        <translation>{percent}&#xa0;% seiner Stärke</translation>
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
</context>
<context>
    <name>GeneralFields</name>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Hide the condition from the operator</source>
        <translation>Bedingung vor der Versuchsleitung verbergen</translation>
    </message>
    <message>
        <source>Use the published wording of questions where there is one</source>
        <translation>Den veröffentlichten Wortlaut der Fragen benutzen, wo es einen gibt</translation>
    </message>
    <message>
        <source>Before a session</source>
        <translation>Vor einer Sitzung</translation>
    </message>
    <message>
        <source>Require a real device before a session starts</source>
        <translation>Vor dem Beginn einer Sitzung ein wirkliches Gerät verlangen</translation>
    </message>
    <message>
        <source>Ask the operator whether the sound is audible</source>
        <translation>Die Versuchsleitung fragen, ob der Ton zu hören ist</translation>
    </message>
    <message>
        <source>Stream markers and force to other programs on this computer (LSL)</source>
        <translation>Marker und Kraft an andere Programme auf diesem Rechner senden (LSL)</translation>
    </message>
    <message>
        <source>Record each session with LabRecorder</source>
        <translation>Jede Sitzung mit LabRecorder aufzeichnen</translation>
    </message>
    <message>
        <source>LSL streams that each trial needs</source>
        <translation>LSL-Ströme, die jeder Durchgang braucht</translation>
    </message>
    <message>
        <source>Least time between two clips</source>
        <translation>Mindestzeit zwischen zwei Clips</translation>
    </message>
    <message>
        <source>Free disk space</source>
        <translation>Freier Speicherplatz</translation>
    </message>
    <message>
        <source>Scheduling of the haptic loop</source>
        <translation>Zeitzuteilung der haptischen Schleife</translation>
    </message>
    <message>
        <source>real time (FIFO)</source>
        <translation>Echtzeit (FIFO)</translation>
    </message>
    <message>
        <source>short time slices</source>
        <translation>kurze Zeitscheiben</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>A trial is marked as invalid above</source>
        <translation>Ein Durchgang gilt als ungültig oberhalb von</translation>
    </message>
    <message>
        <source>Dropped frames (share)</source>
        <translation>Verworfene Bilder (Anteil)</translation>
    </message>
    <message>
        <source>Force to video or sound (median)</source>
        <translation>Abstand der Kraft zu Video oder Ton (Median)</translation>
    </message>
    <message>
        <source>Missed periods of the haptic loop (share)</source>
        <translation>Aussetzer der haptischen Schleife (Anteil)</translation>
    </message>
    <message>
        <source>Audio dropouts</source>
        <translation>Lücken im Ton</translation>
    </message>
    <message>
        <source>conditions are compared by answers</source>
        <translation>Bedingungen werden anhand von Antworten verglichen</translation>
    </message>
    <message>
        <source>yes or no to each level of the force</source>
        <translation>ja oder nein zu jeder Stufe der Kraft</translation>
    </message>
    <message>
        <source>which of two clips (forced choice)</source>
        <translation>welcher von zwei Clips (Zwangswahl)</translation>
    </message>
    <message>
        <source>a number for each level of the force</source>
        <translation>eine Zahl für jede Stufe der Kraft</translation>
    </message>
    <message>
        <source>Kept as they are: the template ({template}), what the trials are for ({trial}), and the identifier by which sessions belong to the study ({id}).</source>
        <translation>Unverändert bleiben: die Vorlage ({template}), wozu die Durchgänge dienen ({trial}), und die Kennung, nach der Sitzungen zur Studie gehören ({id}).</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Sprachen</translation>
    </message>
    <message>
        <source>other languages</source>
        <translation>andere Sprachen</translation>
    </message>
</context>
<context>
    <name>GripView</name>
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
        <source>No device: choose {name} to see the simulated grip</source>
        <translation>Kein Gerät: wählen Sie {name}, um den simulierten Griff zu sehen</translation>
    </message>
    <message>
        <source>This device has no grip</source>
        <translation>Dieses Gerät hat keinen Griff</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Position unbekannt</translation>
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
        <source>Thick arrow: force on the hand. Thin white arrow: planned force. Purple arrow: the share that keeps the grip in the workspace.
Drag or use the arrow keys to rotate, the wheel or + and − to zoom, double-click or 0 to reset.</source>
        <translation>Dicker Pfeil: Kraft auf die Hand. Dünner weißer Pfeil: geplante Kraft. Violetter Pfeil: der Anteil, der den Griff im Arbeitsraum hält.
Ziehen oder Pfeiltasten drehen die Ansicht, Rad oder + und − zoomen, Doppelklick oder 0 setzt zurück.</translation>
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
    <name>GuideWindow</name>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>none</source>
        <translation>keines</translation>
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
        <source>late {p50:+.1f}, {p95:+.1f} ms</source>
        <translation>zu spät {p50:+.1f}, {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>early {p50:+.1f}, {p95:+.1f} ms</source>
        <translation>zu früh {p50:+.1f}, {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{damaged} damaged, {dropped} dropped</source>
        <translation>{damaged} beschädigt, {dropped} verworfen</translation>
    </message>
    <message>
        <source>FIFO</source>
        <translation>FIFO</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>Zeitscheibe</translation>
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
        <source>{p50:+.1f}, {p95:+.1f} ms</source>
        <translation>{p50:+.1f}; {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>{shown} gezeigt, {dropped} verworfen</translation>
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
        <translation>Systemuhr</translation>
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
        <translation>Zeitzuteilung</translation>
    </message>
    <message>
        <source>Scheduling class of the 1 kHz loop: FIFO is best, slice nearly as good; with normal it may be milliseconds late</source>
        <translation>Zeitzuteilung der 1-kHz-Schleife: FIFO ist am besten, Zeitscheibe fast so gut; mit normal kann sie Millisekunden zu spät sein</translation>
    </message>
    <message>
        <source>99 % of the loop&apos;s wake-ups in the last 10 s were no later than this. Missed: skipped periods; above 1 % the force is limited to 3 N</source>
        <translation>99&#xa0;% der Aufwachzeiten der letzten 10 s waren höchstens so spät. Verpasst: ausgelassene Perioden; über 1&#xa0;% wird die Kraft auf 3 N begrenzt</translation>
    </message>
    <message>
        <source>Force − video</source>
        <translation>Kraft − Video</translation>
    </message>
    <message>
        <source>How much later the force comes than the video: median and 95th percentile of the last 20 s. More than 15 ms early or 50 ms late is noticeable</source>
        <translation>Um wie viel die Kraft später kommt als das Video: Median und 95.-Perzentil der letzten 20 s. Mehr als 15 ms zu früh oder 50 ms zu spät ist spürbar</translation>
    </message>
    <message>
        <source>early +88.8, +88.8 ms</source>
        <translation>zu früh +88,8, +88,8 ms</translation>
    </message>
    <message>
        <source>How much later the force comes than the sound: median and 95th percentile of the last 20 s. More than 15 ms early or 50 ms late is noticeable</source>
        <translation>Um wie viel die Kraft später kommt als der Ton: Median und 95.-Perzentil der letzten 20 s. Mehr als 15 ms zu früh oder 50 ms zu spät ist spürbar</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Master clock: the audio output, or the computer&apos;s monotonic clock when there is no sound</source>
        <translation>Führende Uhr: die Tonausgabe, oder ohne Ton die Systemuhr des Rechners</translation>
    </message>
    <message>
        <source>Real-time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Kraft − Ton</translation>
    </message>
    <message>
        <source>no, 888 µs, 888 missed</source>
        <translation>nein, 888 µs, 888 verpasst</translation>
    </message>
    <message>
        <source>Frames shown on time, and dropped because they were late; the sign tells of the last 10 s</source>
        <translation>Rechtzeitig gezeigte und wegen Verspätung verworfene Bilder; das Zeichen gilt für die letzten 10 s</translation>
    </message>
    <message>
        <source>88888 shown, 88 dropped</source>
        <translation>88888 gezeigt, 88 verworfen</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>monotonic</source>
        <translation>Systemuhr</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>About hapticplayer</source>
        <translation>Über hapticplayer</translation>
    </message>
    <message>
        <source>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Plays a video and lets you feel the motion of the camera.&lt;/p&gt;&lt;p&gt;Based on Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Spielt ein Video ab und lässt Sie die Bewegung der Kamera spüren.&lt;/p&gt;&lt;p&gt;Nach Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;MIT-Lizenz.&lt;/p&gt;</translation>
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
        <source>&amp;Stop</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>&amp;Import another…</source>
        <translation>&amp;Weitere importieren…</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Abbrechen; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>Start again with other files</source>
        <translation>Mit anderen Dateien neu beginnen</translation>
    </message>
    <message>
        <source>Go to the previous step</source>
        <translation>Zum vorigen Schritt</translation>
    </message>
    <message>
        <source>Go to the next step</source>
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
        <source>&amp;Play</source>
        <translation>A&amp;bspielen</translation>
    </message>
    <message>
        <source>Reading {0}</source>
        <translation>{0} wird gelesen</translation>
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
        <source>Cancel; nothing is kept</source>
        <translation>Abbrechen; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>about {minutes} min left</source>
        <translation>noch etwa {minutes} min</translation>
    </message>
    <message>
        <source>about {seconds} s left</source>
        <translation>noch etwa {seconds} s</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Neues Kürzel</translation>
    </message>
    <message>
        <source>Press the new shortcut for the selected command</source>
        <translation>Drücken Sie das neue Kürzel für den ausgewählten Befehl</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuweisen</translation>
    </message>
    <message>
        <source>Assign this shortcut to the selected command</source>
        <translation>Dieses Kürzel dem ausgewählten Befehl zuweisen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default shortcut of the selected command</source>
        <translation>Standardkürzel des ausgewählten Befehls wiederherstellen</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>Standardkürzel wiederherstellen</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Befehle und ihre Kürzel</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Kürzel</translation>
    </message>
    <message>
        <source>This shortcut always stops the force and cannot be changed</source>
        <translation>Dieses Kürzel schaltet immer die Kraft ab und lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>Press a shortcut in the field first</source>
        <translation>Drücken Sie zuerst ein Kürzel im Feld</translation>
    </message>
    <message>
        <source>{key} is already used by “{command}”</source>
        <translation>{key} wird schon für „{command}“ verwendet</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
</context>
<context>
    <name>KindList</name>
    <message>
        <source>Kinds of effects</source>
        <translation>Arten von Effekten</translation>
    </message>
    <message>
        <source>Drag onto the timeline; Enter adds at the cursor</source>
        <translation>Auf die Zeitleiste ziehen; Enter fügt am Cursor ein</translation>
    </message>
</context>
<context>
    <name>Lanes</name>
    <message>
        <source>{time} s</source>
        <translation>{time} s</translation>
    </message>
    <message>
        <source>Force x (right)</source>
        <translation>Kraft x (rechts)</translation>
    </message>
    <message>
        <source>Force y (up)</source>
        <translation>Kraft y (oben)</translation>
    </message>
    <message>
        <source>Force z (towards you)</source>
        <translation>Kraft z (zu Ihnen)</translation>
    </message>
    <message>
        <source>± {peak} N</source>
        <translation>± {peak} N</translation>
    </message>
    <message>
        <source>The clip has no sound</source>
        <translation>Der Clip hat keinen Ton</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>No events found</source>
        <translation>Keine Ereignisse gefunden</translation>
    </message>
    <message>
        <source>No effects</source>
        <translation>Keine Effekte</translation>
    </message>
    <message>
        <source>Fade in {seconds} s</source>
        <translation>Einblenden {seconds} s</translation>
    </message>
    <message>
        <source>Fade out {seconds} s</source>
        <translation>Ausblenden {seconds} s</translation>
    </message>
    <message>
        <source>Point {number} of {count}: {time} s, {value}</source>
        <translation>Stützpunkt {number} von {count}: {time} s, {value}</translation>
    </message>
</context>
<context>
    <name>LatencyField</name>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>entered in its settings</source>
        <translation>in den Einstellungen eingegeben</translation>
    </message>
    <message>
        <source>kept by the device&apos;s clock</source>
        <translation>von der Uhr des Geräts eingehalten</translation>
    </message>
    <message>
        <source>typical value, not measured</source>
        <translation>üblicher Wert, nicht gemessen</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>From a command to what is felt: compensated</source>
        <translation>Vom Befehl bis zum Fühlen: wird ausgeglichen</translation>
    </message>
</context>
<context>
    <name>LatencyMonitor</name>
    <message>
        <source>The sound output {name} reports a latency of {ms:.0f} ms</source>
        <translation>Die Tonausgabe {name} meldet eine Latenz von {ms:.0f} ms</translation>
    </message>
    <message>
        <source>The sound output {name} seems to be wireless</source>
        <translation>Die Tonausgabe {name} scheint drahtlos zu sein</translation>
    </message>
    <message>
        <source>the actual latency may be higher. Use wired headphones, or measure it: Device &gt; Measure latencies</source>
        <translation>die wirkliche Latenz kann größer sein. Nehmen Sie Kopfhörer mit Kabel, oder messen Sie sie: Gerät &gt; Latenzen messen</translation>
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
        <source>Tap to the force</source>
        <translation>Zur Kraft tippen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>Tap to the flash</source>
        <translation>Zum Blitz tippen</translation>
    </message>
    <message>
        <source>Tap to the beep</source>
        <translation>Zum Ton tippen</translation>
    </message>
    <message>
        <source>Play a beat every second</source>
        <translation>Jede Sekunde einen Takt abspielen</translation>
    </message>
    <message>
        <source>Stop the force immediately (Esc)</source>
        <translation>Kraft sofort abschalten (Esc)</translation>
    </message>
    <message>
        <source>Tap on each beat (space bar)</source>
        <translation>Bei jedem Takt tippen (Leertaste)</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Save these latencies for these outputs</source>
        <translation>Diese Latenzen für diese Ausgaben speichern</translation>
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
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Every second there is a flash, a beep and a gentle force pulse. Hold the grip loosely and press Start. Esc, STOP or a button on the grip stops it.</source>
        <translation>Jede Sekunde kommen ein Blitz, ein Ton und ein sanfter Kraftimpuls. Halten Sie den Griff locker und drücken Sie Start. Esc, STOPP oder eine Taste am Griff beendet es.</translation>
    </message>
    <message>
        <source>Adjust the latencies until flash, beep and force come together. Increase the one that comes late.</source>
        <translation>Stellen Sie die Latenzen ein, bis Blitz, Ton und Kraft zusammen kommen. Was zu spät kommt, braucht einen größeren Wert.</translation>
    </message>
    <message>
        <source>Press the space bar on each beat, at least eight times: first to the flash, then to the beep and the force. The differences are filled in; fine-tune them with &quot;All together&quot;.</source>
        <translation>Drücken Sie bei jedem Takt die Leertaste, mindestens achtmal: zuerst zum Blitz, dann zu Ton und Kraft. Die Differenzen werden eingetragen; stimmen Sie sie mit „Alle zusammen“ fein ab.</translation>
    </message>
    <message>
        <source>{n} of {least} taps</source>
        <translation>{n} von {least} Mal getippt</translation>
    </message>
    <message>
        <source>{n} taps: {ms:.0f} ± {spread:.0f} ms</source>
        <translation>{n} Mal: {ms:.0f} ± {spread:.0f} ms</translation>
    </message>
</context>
<context>
    <name>LevelMeter</name>
    <message>
        <source>channel {channel} silent</source>
        <translation>Kanal {channel} still</translation>
    </message>
    <message>
        <source>channel {channel} {db} dB, limited</source>
        <translation>Kanal {channel} {db} dB, begrenzt</translation>
    </message>
    <message>
        <source>channel {channel} {db} dB</source>
        <translation>Kanal {channel} {db} dB</translation>
    </message>
</context>
<context>
    <name>LibraryChoice</name>
    <message>
        <source>Choose a recording</source>
        <translation>Aufnahme wählen</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>There is no sequence in {folder}. Import a recording first (File &gt; Import), or choose another folder.</source>
        <translation>In {folder} ist keine Sequenz. Importieren Sie zuerst eine Aufnahme (Datei &gt; Aufnahme importieren), oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Wählen</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Choose a sequence in another folder</source>
        <translation>Eine Sequenz in einem anderen Ordner wählen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>Sequence folder</source>
        <translation>Sequenzordner</translation>
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
        <source>&amp;Add a track…</source>
        <translation>Spur hin&amp;zufügen…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Save the track for other software</source>
        <translation>Die Spur für andere Programme speichern</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Umbe&amp;nennen…</translation>
    </message>
    <message>
        <source>Add a force track from a file</source>
        <translation>Eine Kraftspur aus einer Datei hinzufügen</translation>
    </message>
    <message>
        <source>Rename the track</source>
        <translation>Die Spur umbenennen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>En&amp;tfernen</translation>
    </message>
    <message>
        <source>Remove the track</source>
        <translation>Die Spur entfernen</translation>
    </message>
    <message>
        <source>Ren&amp;dering…</source>
        <translation>Ren&amp;dering…</translation>
    </message>
    <message>
        <source>Render the force in another way, after a look at what changes</source>
        <translation>Die Kraft anders berechnen, nach einem Blick auf das, was sich ändert</translation>
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
        <source>{name} does not say what its haptics are (modality Other, as the published encoder writes it for sound and AHAP). What are they?</source>
        <translation>{name} sagt nicht, was seine Haptik ist (Modalität Other, wie sie der veröffentlichte Encoder für Ton und AHAP schreibt). Was ist sie?</translation>
    </message>
    <message>
        <source>&amp;Force</source>
        <translation>&amp;Kraft</translation>
    </message>
    <message>
        <source>&amp;Vibration</source>
        <translation>&amp;Vibration</translation>
    </message>
    <message>
        <source>&amp;Leave them out</source>
        <translation>&amp;Weglassen</translation>
    </message>
    <message>
        <source>Export the track</source>
        <translation>Spur exportieren</translation>
    </message>
    <message>
        <source>Saving {name}</source>
        <translation>{name} wird gespeichert</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Gespeichert: {name}</translation>
    </message>
    <message>
        <source>It keeps {what}</source>
        <translation>Erhalten bleibt: {what}</translation>
    </message>
    <message>
        <source>{rendering}; one gain for each axis</source>
        <translation>{rendering}; eine Verstärkung je Achse</translation>
    </message>
    <message>
        <source>{rendering}; gain {gain} N per m/s²</source>
        <translation>{rendering}; Verstärkung {gain} N je m/s²</translation>
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
        <source>Undo the last deletion</source>
        <translation>Letztes Löschen rückgängig machen</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Abbrechen; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>Import a recording</source>
        <translation>Aufnahme importieren</translation>
    </message>
    <message>
        <source>Choose the library folder</source>
        <translation>Ordner der Bibliothek wählen</translation>
    </message>
    <message>
        <source>&amp;Effects…</source>
        <translation>&amp;Effekte…</translation>
    </message>
    <message>
        <source>Edit the effects</source>
        <translation>Effekte bearbeiten</translation>
    </message>
    <message>
        <source>Change the title</source>
        <translation>Titel ändern</translation>
    </message>
    <message>
        <source>Check the checksums of all files</source>
        <translation>Prüfsummen aller Dateien prüfen</translation>
    </message>
    <message>
        <source>Move to the bin</source>
        <translation>In den Papierkorb verschieben</translation>
    </message>
    <message>
        <source>Play (Enter)</source>
        <translation>Abspielen (Eingabe)</translation>
    </message>
    <message>
        <source>&amp;Rendering…</source>
        <translation>Ren&amp;dering…</translation>
    </message>
    <message>
        <source>Show in the file &amp;manager</source>
        <translation>In der Datei&amp;verwaltung zeigen</translation>
    </message>
    <message>
        <source>No sequences yet. Import a recording.</source>
        <translation>Noch keine Sequenzen. Importieren Sie eine Aufnahme.</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>{title}: all files are intact</source>
        <translation>{title}: alle Dateien sind unversehrt</translation>
    </message>
    <message>
        <source>Move {title} to the bin? You can restore it from there.</source>
        <translation>{title} in den Papierkorb verschieben? Sie können es von dort wiederherstellen.</translation>
    </message>
    <message>
        <source>Could not move {title} to the bin; nothing was deleted.</source>
        <translation>{title} ließ sich nicht in den Papierkorb verschieben; nichts wurde gelöscht.</translation>
    </message>
    <message>
        <source>Moved {title} to the bin.</source>
        <translation>{title} wurde in den Papierkorb verschoben.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Löschen…</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
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
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>LivePane</name>
    <message>
        <source>Microphone</source>
        <translation>Mikrofon</translation>
    </message>
    <message>
        <source>Acceleration of the last seconds</source>
        <translation>Beschleunigung der letzten Sekunden</translation>
    </message>
    <message>
        <source>Angular rate of the last seconds</source>
        <translation>Drehrate der letzten Sekunden</translation>
    </message>
    <message>
        <source>Acceleration with gravity, m/s²</source>
        <translation>Beschleunigung mit Schwerkraft, m/s²</translation>
    </message>
    <message>
        <source>Angular rate, rad/s</source>
        <translation>Drehrate, rad/s</translation>
    </message>
    <message>
        <source>No camera</source>
        <translation>Keine Kamera</translation>
    </message>
    <message>
        <source>camera {rate} fps, dropped {lost}</source>
        <translation>Kamera {rate} Bilder/s, verworfen {lost}</translation>
    </message>
    <message>
        <source>sensor {rate} Hz, lost {lost}</source>
        <translation>Sensor {rate} Hz, verloren {lost}</translation>
    </message>
    <message>
        <source>gaps {count}</source>
        <translation>Lücken {count}</translation>
    </message>
    <message>
        <source>marks {count}</source>
        <translation>Marken {count}</translation>
    </message>
    <message>
        <source>{free} GB free</source>
        <translation>{free} GB frei</translation>
    </message>
</context>
<context>
    <name>LivePicture</name>
    <message>
        <source>Live picture</source>
        <translation>Livebild</translation>
    </message>
</context>
<context>
    <name>LivePlot</name>
    <message>
        <source>Wheel or + and −: zoom. Double-click or Enter: reset</source>
        <translation>Rad oder + und −: zoomen. Doppelklick oder Eingabe: zurücksetzen</translation>
    </message>
</context>
<context>
    <name>LogQuestionBox</name>
    <message>
        <source>&amp;Answer</source>
        <translation>&amp;Antworten</translation>
    </message>
    <message>
        <source>Read the log with this answer</source>
        <translation>Das Protokoll mit dieser Antwort lesen</translation>
    </message>
    <message>
        <source>Answer in a &amp;form…</source>
        <translation>In einem F&amp;ormular antworten…</translation>
    </message>
    <message>
        <source>Units, axes, signs and more, with a check against gravity</source>
        <translation>Einheiten, Achsen, Vorzeichen und mehr, mit einer Prüfung an der Schwerkraft</translation>
    </message>
</context>
<context>
    <name>MarkerList</name>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Enter goes there, F2 renames, Delete removes</source>
        <translation>Eingabe springt dorthin, F2 benennt um, Entf entfernt</translation>
    </message>
    <message>
        <source>No markers yet. M sets one at the cursor.</source>
        <translation>Noch keine Marker. M setzt einen am Cursor.</translation>
    </message>
</context>
<context>
    <name>MergePage</name>
    <message>
        <source>Merge sessions of other machines</source>
        <translation>Sitzungen anderer Rechner zusammenführen</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Standort</translation>
    </message>
    <message>
        <source>Copy of the study</source>
        <translation>Kopie der Studie</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Copies to merge</source>
        <translation>Kopien zum Zusammenführen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>What came of this copy</source>
        <translation>Was diese Kopie ergeben hat</translation>
    </message>
    <message>
        <source>Add the folders that have come back, or one that holds several: the names of its folders are those of the sites then. Sessions that are here already stay as they are. In the mixed models each site has an intercept of its own.</source>
        <translation>Fügen Sie die Ordner hinzu, die zurückgekommen sind, oder einen, der mehrere enthält: Dann sind die Namen seiner Ordner die der Standorte. Sitzungen, die schon hier sind, bleiben, wie sie sind. In den gemischten Modellen hat jeder Standort einen eigenen Achsenabschnitt.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop; sessions that were added stay</source>
        <translation>Anhalten; hinzugefügte Sitzungen bleiben</translation>
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
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Add a copy, or a folder that holds several</source>
        <translation>Eine Kopie hinzufügen, oder einen Ordner, der mehrere enthält</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the selected copy off this list</source>
        <translation>Die ausgewählte Kopie aus dieser Liste nehmen</translation>
    </message>
    <message>
        <source>&amp;Merge</source>
        <translation>&amp;Zusammenführen</translation>
    </message>
    <message>
        <source>Add the sessions of all these copies</source>
        <translation>Die Sitzungen aller dieser Kopien hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Site of the selected copy</source>
        <translation>&amp;Standort der ausgewählten Kopie</translation>
    </message>
    <message>
        <source>● added: {added}, here already: {same}</source>
        <translation>● hinzugefügt: {added}, schon vorhanden: {same}</translation>
    </message>
    <message>
        <source>▲ added: {added}, left out: {left}</source>
        <translation>▲ hinzugefügt: {added}, weggelassen: {left}</translation>
    </message>
    <message>
        <source>Choose a copy of this study, or a folder of copies</source>
        <translation>Wählen Sie eine Kopie dieser Studie oder einen Ordner mit Kopien</translation>
    </message>
    <message>
        <source>Merging</source>
        <translation>Wird zusammengeführt</translation>
    </message>
    <message>
        <source>Sessions added: {added}; here already: {same}; left out: {left}.</source>
        <translation>Hinzugefügte Sitzungen: {added}; schon vorhanden: {same}; weggelassen: {left}.</translation>
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
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the message, also in English, for a report</source>
        <translation>Meldung kopieren, auch auf Englisch, für einen Fehlerbericht</translation>
    </message>
</context>
<context>
    <name>Mirror</name>
    <message>
        <source>The participant&apos;s view</source>
        <translation>Ansicht der teilnehmenden Person</translation>
    </message>
    <message>
        <source>The participant sees a page</source>
        <translation>Die teilnehmende Person sieht eine Seite</translation>
    </message>
</context>
<context>
    <name>MountingPage</name>
    <message>
        <source>Mounting</source>
        <translation>Befestigung</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Right {right}, front {front}, up {up}</source>
        <translation>Rechts {right}, vorn {front}, oben {up}</translation>
    </message>
    <message>
        <source>As the frames show, when it is imported</source>
        <translation>Wie es die Bilder zeigen, beim Importieren</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>&amp;Mounting</source>
        <translation>&amp;Befestigung</translation>
    </message>
    <message>
        <source>Choose another library folder</source>
        <translation>Anderen Ordner für die Bibliothek wählen</translation>
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
        <source>The drawing shows the recorder on the wearer, who faces forward; the dashed line shows which way was up, from gravity.</source>
        <translation>Die Zeichnung zeigt den Rekorder an der Person, die nach vorn blickt; die gestrichelte Linie zeigt nach der Schwerkraft, wo oben war.</translation>
    </message>
    <message>
        <source>Taken from the frames if they show it clearly; else you are asked.</source>
        <translation>Wird aus den Bildern bestimmt, wenn sie es klar zeigen; sonst werden Sie gefragt.</translation>
    </message>
    <message>
        <source>The frames show this mounting (ratio {ratio} to the next best); gravity does not contradict it.</source>
        <translation>Die Bilder zeigen diese Befestigung (Verhältnis {ratio} zur nächstbesten); die Schwerkraft widerspricht ihr nicht.</translation>
    </message>
    <message>
        <source>The sensor rotated too much to determine the mounting from gravity.</source>
        <translation>Der Sensor hat sich zu stark gedreht, um die Befestigung aus der Schwerkraft zu bestimmen.</translation>
    </message>
    <message>
        <source>Consistent with gravity. Only you know which side faced forward.</source>
        <translation>Passt zur Schwerkraft. Welche Seite vorn war, wissen nur Sie.</translation>
    </message>
    <message>
        <source>Not consistent with gravity: another side was up.</source>
        <translation>Passt nicht zur Schwerkraft: eine andere Seite war oben.</translation>
    </message>
    <message>
        <source>Choose the library folder</source>
        <translation>Ordner der Bibliothek wählen</translation>
    </message>
</context>
<context>
    <name>NewStudyDialog</name>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>For example: Bicycle rides 2026</source>
        <translation>Zum Beispiel: Fahrradfahrten 2026</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>An&amp;legen</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Anderen Ordner wählen</translation>
    </message>
    <message>
        <source>Languages of participants</source>
        <translation>Sprachen der Teilnehmenden</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>The study will be kept in {folder}</source>
        <translation>Die Studie wird in {folder} gespeichert</translation>
    </message>
    <message>
        <source>Choose where to create the study</source>
        <translation>Wählen Sie, wo die Studie angelegt wird</translation>
    </message>
    <message>
        <source>Choose a language for the participants&apos; pages</source>
        <translation>Wählen Sie eine Sprache für die Seiten der Teilnehmenden</translation>
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
    <name>OfferBar</name>
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
    <name>OrderPage</name>
    <message>
        <source>Orders</source>
        <translation>Reihenfolgen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Never the same sequence twice in a row</source>
        <translation>Nie zweimal nacheinander dieselbe Sequenz</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>The same seed gives the same orders</source>
        <translation>Derselbe Startwert ergibt dieselben Reihenfolgen</translation>
    </message>
    <message>
        <source>Take the orders of a file…</source>
        <translation>Reihenfolgen aus einer Datei übernehmen…</translation>
    </message>
    <message>
        <source>A CSV file with order, position, sequence and feedback</source>
        <translation>Eine CSV-Datei mit order, position, sequence und feedback</translation>
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
        <source>Williams: balanced for carry-over</source>
        <translation>Williams: ausgewogen für Nachwirkungen</translation>
    </message>
    <message>
        <source>From a table of your own (orders.csv)</source>
        <translation>Aus einer eigenen Tabelle (orders.csv)</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>next participant</source>
        <translation>nächste Person</translation>
    </message>
    <message>
        <source>example</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>There is no order yet: see the problems below.</source>
        <translation>Es gibt noch keine Reihenfolge: siehe die Probleme unten.</translation>
    </message>
    <message>
        <source>Every participant gets an order of their own, drawn from the seed and the participant&apos;s code.</source>
        <translation>Jede Person bekommt eine eigene Reihenfolge, aus dem Startwert und ihrem Code ausgelost.</translation>
    </message>
    <message>
        <source>Participants get the order that was used least; that of a session which ended early is given again.</source>
        <translation>Jede Person bekommt die bisher am seltensten verwendete Reihenfolge; die einer vorzeitig beendeten Sitzung wird noch einmal vergeben.</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
</context>
<context>
    <name>OutputsPage</name>
    <message>
        <source>This device is already in use</source>
        <translation>Dieses Gerät wird schon verwendet</translation>
    </message>
    <message>
        <source>Settings may contain letters, digits and punctuation</source>
        <translation>Einstellungen dürfen Buchstaben, Ziffern und Satzzeichen enthalten</translation>
    </message>
    <message>
        <source>No more devices can be added; remove one first</source>
        <translation>Es können keine weiteren Geräte hinzugefügt werden; entfernen Sie erst eines</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgaben</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Also play on this device</source>
        <translation>Auch auf diesem Gerät spielen</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Stop all of them (Esc)</source>
        <translation>Alle anhalten (Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The devices keep playing</source>
        <translation>Die Geräte spielen weiter</translation>
    </message>
    <message>
        <source>Address or settings</source>
        <translation>Adresse oder Einstellungen</translation>
    </message>
    <message>
        <source>Nothing plays yet. Choose a device below and press Add.</source>
        <translation>Noch spielt nichts. Wählen Sie unten ein Gerät, und drücken Sie Hinzufügen.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Device to add</source>
        <translation>Gerät, das hinzukommt</translation>
    </message>
    <message>
        <source>Latency that is compensated ({source})</source>
        <translation>Latenz, die ausgeglichen wird ({source})</translation>
    </message>
    <message>
        <source>All of these play at once and stop at once. The first one leads: its position is shown and its buttons count. A rig moves with the motion of the recording: begin with a small gain.</source>
        <translation>Alle spielen gleichzeitig und halten gleichzeitig an. Die erste führt: Ihre Position wird gezeigt, und ihre Tasten gelten. Eine Bewegungsplattform bewegt sich mit der Bewegung der Aufnahme: Beginnen Sie mit einer kleinen Verstärkung.</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>Multiplies everything that this output plays</source>
        <translation>Multipliziert alles, was diese Ausgabe spielt</translation>
    </message>
    <message>
        <source>Test…</source>
        <translation>Testen…</translation>
    </message>
    <message>
        <source>Moves it gently; asks first</source>
        <translation>Bewegt es sanft; fragt vorher</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Einrichten…</translation>
    </message>
    <message>
        <source>What it needs, and how it is connected</source>
        <translation>Was es braucht und wie es angeschlossen wird</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Release this device</source>
        <translation>Dieses Gerät freigeben</translation>
    </message>
    <message>
        <source>Move up; the first one leads</source>
        <translation>Nach oben; die erste führt</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
</context>
<context>
    <name>PagePreview</name>
    <message>
        <source>Full size</source>
        <translation>Volle Größe</translation>
    </message>
    <message>
        <source>Show the page on the participant&apos;s screen</source>
        <translation>Die Seite auf dem Bildschirm der Person zeigen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
</context>
<context>
    <name>PlaceDialog</name>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Anderen Ordner wählen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>This folder exists already: choose another place</source>
        <translation>Diesen Ordner gibt es schon: Wählen Sie einen anderen Ort</translation>
    </message>
    <message>
        <source>Choose where to create the folder</source>
        <translation>Wählen Sie, wo der Ordner angelegt wird</translation>
    </message>
    <message>
        <source>Export the data</source>
        <translation>Daten exportieren</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>The data will be written to {folder}</source>
        <translation>Die Daten werden in {folder} geschrieben</translation>
    </message>
    <message>
        <source>Pack the study for other sites</source>
        <translation>Studie für andere Standorte packen</translation>
    </message>
    <message>
        <source>&amp;Pack</source>
        <translation>&amp;Packen</translation>
    </message>
    <message>
        <source>Definition, orders and all sequences, without sessions, will be copied to {folder}</source>
        <translation>Definition, Reihenfolgen und alle Sequenzen werden ohne Sitzungen nach {folder} kopiert</translation>
    </message>
</context>
<context>
    <name>PlayBar</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Zoom in (+)</source>
        <translation>Vergrößern (+)</translation>
    </message>
    <message>
        <source>Zoom out (−)</source>
        <translation>Verkleinern (−)</translation>
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
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>S&amp;chleife</translation>
    </message>
    <message>
        <source>Repeat the selected effects, or what is in view without any</source>
        <translation>Die ausgewählten Effekte wiederholen, oder ohne Auswahl den sichtbaren Teil</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>&amp;Vorher</translation>
    </message>
    <message>
        <source>Show the force without effects behind it</source>
        <translation>Dahinter die Kraft ohne Effekte zeigen</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Ei&amp;nrasten</translation>
    </message>
    <message>
        <source>Snap to frames, events and other effects</source>
        <translation>An Bildern, Ereignissen und anderen Effekten einrasten</translation>
    </message>
</context>
<context>
    <name>PlayerWindow</name>
    <message>
        <source>Force stopped. {keys} re-arms it.</source>
        <translation>Kraft abgeschaltet. {keys} gibt sie wieder frei.</translation>
    </message>
    <message>
        <source>No next file</source>
        <translation>Keine nächste Datei</translation>
    </message>
    <message>
        <source>No previous file</source>
        <translation>Keine vorige Datei</translation>
    </message>
    <message>
        <source>Repeat off</source>
        <translation>Wiederholen aus</translation>
    </message>
    <message>
        <source>Repeat this clip</source>
        <translation>Diesen Clip wiederholen</translation>
    </message>
    <message>
        <source>Repeat all</source>
        <translation>Alle wiederholen</translation>
    </message>
    <message>
        <source>hapticplayer</source>
        <translation>hapticplayer</translation>
    </message>
</context>
<context>
    <name>PlaylistPage</name>
    <message>
        <source>Playlist</source>
        <translation>Wiedergabeliste</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
    </message>
    <message>
        <source>Do not repeat</source>
        <translation>Nicht wiederholen</translation>
    </message>
    <message>
        <source>Repeat this clip</source>
        <translation>Diesen Clip wiederholen</translation>
    </message>
    <message>
        <source>Repeat all</source>
        <translation>Alle wiederholen</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Add videos; sequences can be dropped here</source>
        <translation>Videos hinzufügen; Sequenzen lassen sich hierher ziehen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove from the list; no file is deleted</source>
        <translation>Aus der Liste entfernen; keine Datei wird gelöscht</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Play it earlier</source>
        <translation>Früher spielen</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>Play it later</source>
        <translation>Später spielen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>At the e&amp;nd</source>
        <translation>A&amp;m Ende</translation>
    </message>
    <message>
        <source>Clips play one after the other.</source>
        <translation>Die Clips spielen nacheinander.</translation>
    </message>
    <message>
        <source>The list is empty. Add videos, or drop videos and sequences here. Without a list, Next and Previous play what is in the folder of the clip.</source>
        <translation>Die Liste ist leer. Fügen Sie Videos hinzu, oder ziehen Sie Videos und Sequenzen hierher. Ohne Liste spielen „Nächste Datei“ und „Vorige Datei“, was im Ordner des Clips liegt.</translation>
    </message>
    <message>
        <source>Add videos</source>
        <translation>Videos hinzufügen</translation>
    </message>
</context>
<context>
    <name>PlotArea</name>
    <message>
        <source>Live plots</source>
        <translation>Kurven</translation>
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
        <source>z towards you</source>
        <translation>z zu Ihnen</translation>
    </message>
    <message>
        <source>thin: planned</source>
        <translation>dünn: geplant</translation>
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
        <source>PNG image (*.png);;SVG drawing (*.svg);;CSV data (*.csv)</source>
        <translation>PNG-Bild (*.png);;SVG-Zeichnung (*.svg);;CSV-Daten (*.csv)</translation>
    </message>
    <message>
        <source>{name}: unsupported file type; choose one of {kinds}</source>
        <translation>{name}: Dateityp nicht unterstützt; wählen Sie {kinds}</translation>
    </message>
    <message>
        <source>Click: seek. Drag: pan. Wheel or + and −: zoom. Double-click or Enter: reset</source>
        <translation>Klick: springen. Ziehen: verschieben. Rad oder + und −: zoomen. Doppelklick oder Eingabe: zurücksetzen</translation>
    </message>
</context>
<context>
    <name>PreferencesPage</name>
    <message>
        <source>Preferences</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Same screen as the window</source>
        <translation>Bildschirm des Fensters</translation>
    </message>
    <message>
        <source>Resume clips &amp;where they were left</source>
        <translation>Clips dort fortsetzen, &amp;wo sie verlassen wurden</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>Sound &amp;output</source>
        <translation>&amp;Tonausgabe</translation>
    </message>
    <message>
        <source>&amp;Fullscreen on</source>
        <translation>&amp;Vollbild auf</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Saved frames</source>
        <translation>Gespeicherte Bilder</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>Tasten&amp;kürzel…</translation>
    </message>
    <message>
        <source>&amp;Devices…</source>
        <translation>&amp;Geräte…</translation>
    </message>
    <message>
        <source>L&amp;atencies…</source>
        <translation>&amp;Latenzen…</translation>
    </message>
    <message>
        <source>O&amp;K</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>More is set on pages of its own:</source>
        <translation>Anderes wird auf eigenen Seiten eingestellt:</translation>
    </message>
</context>
<context>
    <name>ProcessingFields</name>
    <message>
        <source>Gravity removal</source>
        <translation>Abzug der Schwerkraft</translation>
    </message>
    <message>
        <source>Time constant, s</source>
        <translation>Zeitkonstante, s</translation>
    </message>
    <message>
        <source>from the motion</source>
        <translation>aus der Bewegung</translation>
    </message>
    <message>
        <source>Accelerations that last much longer than this count as gravity</source>
        <translation>Beschleunigungen, die viel länger als dies dauern, gelten als Schwerkraft</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>For short recordings: the file with what a longer one of the same sensor tells of its errors</source>
        <translation>Für kurze Aufnahmen: die Datei mit dem, was eine längere desselben Sensors über seine Fehler verrät</translation>
    </message>
    <message>
        <source>Replace isolated s&amp;pikes</source>
        <translation>Einzelne Aus&amp;reißer ersetzen</translation>
    </message>
    <message>
        <source>Reconstruct short cli&amp;pped peaks</source>
        <translation>Kurze &amp;abgeschnittene Spitzen rekonstruieren</translation>
    </message>
    <message>
        <source>Average to, Hz</source>
        <translation>Mitteln auf, Hz</translation>
    </message>
    <message>
        <source>Low-pass at, Hz</source>
        <translation>Tiefpass bei, Hz</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>gar nicht</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Eine Kalibrierung wählen</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>&amp;Kalibrierung</translation>
    </message>
    <message>
        <source>Gra&amp;vity removal</source>
        <translation>Abzug der &amp;Schwerkraft</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>Good: ready for use</source>
        <translation>Gut: kann verwendet werden</translation>
    </message>
    <message>
        <source>Doubtful: check the marked items</source>
        <translation>Zweifelhaft: prüfen Sie, was markiert ist</translation>
    </message>
    <message>
        <source>Bad: record or import it again</source>
        <translation>Schlecht: nehmen Sie neu auf oder importieren Sie neu</translation>
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
        <source>Motion</source>
        <translation>Bewegung</translation>
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
        <source>Residual gravity at rest</source>
        <translation>Restschwerkraft in Ruhe</translation>
    </message>
    <message>
        <source>Sensor saturation</source>
        <translation>Sensor an der Grenze</translation>
    </message>
    <message>
        <source>Clip without motion data</source>
        <translation>Clip ohne Bewegungsdaten</translation>
    </message>
    <message>
        <source>Force saturation</source>
        <translation>Kraft an der Grenze</translation>
    </message>
    <message>
        <source>Workspace used</source>
        <translation>Genutzter Arbeitsraum</translation>
    </message>
    <message>
        <source>Motor heating</source>
        <translation>Erwärmung der Motoren</translation>
    </message>
    <message>
        <source>residual {ms} ms, confirmed by a person ({how})</source>
        <translation>Rest {ms}&#xa0;ms, von einer Person bestätigt ({how})</translation>
    </message>
    <message>
        <source>estimated from the picture, nothing measured it: sway in {sway}, bounce in {bounce} of the clip; gain {gain}</source>
        <translation>aus dem Bild geschätzt, nichts hat sie gemessen: Schwanken in {sway}, Auf und Ab in {bounce} des Clips; Verstärkung {gain}</translation>
    </message>
    <message>
        <source>{share} of the time; the peak is {n} N</source>
        <translation>{share} der Zeit; die Spitze ist {n}&#xa0;N</translation>
    </message>
    <message>
        <source>The force would be stopped; lower the gain</source>
        <translation>Die Kraft würde abgeschaltet; verringern Sie die Verstärkung</translation>
    </message>
    <message>
        <source>Record the motion with the next video</source>
        <translation>Zeichnen Sie beim nächsten Video die Bewegung mit auf</translation>
    </message>
    <message>
        <source>Check the synchronisation</source>
        <translation>Prüfen Sie die Synchronisierung</translation>
    </message>
    <message>
        <source>Check the synchronisation; next time tap the recorder three times</source>
        <translation>Prüfen Sie die Synchronisierung; klopfen Sie nächstes Mal dreimal auf den Rekorder</translation>
    </message>
    <message>
        <source>In long recordings, tap at the end as well</source>
        <translation>Klopfen Sie bei langen Aufnahmen auch am Ende</translation>
    </message>
    <message>
        <source>Next time: record at 100 Hz or more</source>
        <translation>Nächstes Mal: mit 100 Hz oder mehr aufnehmen</translation>
    </message>
    <message>
        <source>Next time: keep still for a few seconds at the start</source>
        <translation>Nächstes Mal: am Anfang einige Sekunden still halten</translation>
    </message>
    <message>
        <source>Next time: choose a larger accelerometer range</source>
        <translation>Nächstes Mal: einen größeren Messbereich des Beschleunigungssensors wählen</translation>
    </message>
    <message>
        <source>Next time: start the log before the clip and stop it after</source>
        <translation>Nächstes Mal: das Protokoll vor dem Clip starten und danach beenden</translation>
    </message>
    <message>
        <source>There is no force in the gaps; try another memory card</source>
        <translation>In den Lücken gibt es keine Kraft; versuchen Sie eine andere Speicherkarte</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Bad: change the rendering</source>
        <translation>Schlecht: Ändern Sie die Umsetzung</translation>
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
    <name>Question</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>QuestionList</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>Score: {text}</source>
        <translation>Score: {text}</translation>
    </message>
    <message>
        <source>(no wording yet)</source>
        <translation>(noch kein Wortlaut)</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Text above the questions</source>
        <translation>Text über den Fragen</translation>
    </message>
    <message>
        <source>All clips may be played again there</source>
        <translation>Alle Clips dürfen dort noch einmal abgespielt werden</translation>
    </message>
    <message>
        <source>The questions are shown one after the other</source>
        <translation>Die Fragen werden nacheinander gezeigt</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Wording</source>
        <translation>Wortlaut</translation>
    </message>
    <message>
        <source>Help line</source>
        <translation>Hilfezeile</translation>
    </message>
    <message>
        <source>Kind of answer</source>
        <translation>Art der Antwort</translation>
    </message>
    <message>
        <source>An answer is required</source>
        <translation>Eine Antwort ist nötig</translation>
    </message>
    <message>
        <source>Part of the sum QoE, which is analysed first</source>
        <translation>Teil der Summe QoE, die zuerst ausgewertet wird</translation>
    </message>
    <message>
        <source>Ask once for each kind of feedback</source>
        <translation>Für jede Art von Feedback einmal fragen</translation>
    </message>
    <message>
        <source>Unit in the data</source>
        <translation>Einheit in den Daten</translation>
    </message>
    <message>
        <source>another range</source>
        <translation>anderer Bereich</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Remove this label</source>
        <translation>Diese Beschriftung entfernen</translation>
    </message>
    <message>
        <source>Add a label</source>
        <translation>Beschriftung hinzufügen</translation>
    </message>
    <message>
        <source>another label</source>
        <translation>andere Beschriftung</translation>
    </message>
    <message>
        <source>removal</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>another page</source>
        <translation>andere Seite</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Name in den Daten</translation>
    </message>
    <message>
        <source>Add a question or a page</source>
        <translation>Frage oder Seite hinzufügen</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>In Daten und Abbildungen: a bis z, 0 bis 9, _ und -</translation>
    </message>
    <message>
        <source>Published wording</source>
        <translation>Veröffentlichter Wortlaut</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinste</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>At most so many characters</source>
        <translation>Höchstens so viele Zeichen</translation>
    </message>
    <message>
        <source>Answer {n}</source>
        <translation>Antwort {n}</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Antwort hinzufügen</translation>
    </message>
    <message>
        <source>Number that it counts as, if any</source>
        <translation>Zahl, als die sie zählt, falls angegeben</translation>
    </message>
    <message>
        <source>Remove this answer</source>
        <translation>Diese Antwort entfernen</translation>
    </message>
    <message>
        <source>another scale</source>
        <translation>andere Skala</translation>
    </message>
    <message>
        <source>another score</source>
        <translation>anderer Score</translation>
    </message>
    <message>
        <source>another question</source>
        <translation>andere Frage</translation>
    </message>
    <message>
        <source>another kind of answer</source>
        <translation>andere Art der Antwort</translation>
    </message>
    <message>
        <source>another answer</source>
        <translation>andere Antwort</translation>
    </message>
</context>
<context>
    <name>QueuePage</name>
    <message>
        <source>Import several clips</source>
        <translation>Mehrere Clips importieren</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation>Bewegungsprotokoll</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Clips to import</source>
        <translation>Zu importierende Clips</translation>
    </message>
    <message>
        <source>No clips yet: add some, or drop them here.</source>
        <translation>Noch keine Clips: Fügen Sie welche hinzu, oder ziehen Sie sie hierher.</translation>
    </message>
    <message>
        <source>Each clip is imported with its own motion, or with the log of the same name, and tested. Clips that are in the library are only tested. A clip that needs an answer waits; the others go on.</source>
        <translation>Jeder Clip wird mit seiner eigenen Bewegung oder mit dem Protokoll gleichen Namens importiert und geprüft. Clips, die schon in der Bibliothek sind, werden nur geprüft. Ein Clip, der eine Antwort braucht, wartet; die anderen laufen weiter.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Anh&amp;alten</translation>
    </message>
    <message>
        <source>Stop the queue; what is done is kept</source>
        <translation>Die Warteschlange anhalten; was fertig ist, bleibt</translation>
    </message>
    <message>
        <source>&amp;Clips…</source>
        <translation>&amp;Clips…</translation>
    </message>
    <message>
        <source>Add clips and logs</source>
        <translation>Clips und Protokolle hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Add a folder of clips</source>
        <translation>Einen Ordner mit Clips hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Answer…</source>
        <translation>A&amp;ntworten…</translation>
    </message>
    <message>
        <source>Import the selected clip step by step</source>
        <translation>Den ausgewählten Clip Schritt für Schritt importieren</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>A&amp;bspielen</translation>
    </message>
    <message>
        <source>Play the selected sequence</source>
        <translation>Die ausgewählte Sequenz abspielen</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>Import what is not yet there</source>
        <translation>Importieren, was noch nicht da ist</translation>
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
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>importing</source>
        <translation>wird importiert</translation>
    </message>
    <message>
        <source>● imported</source>
        <translation>● importiert</translation>
    </message>
    <message>
        <source>● was there, intact</source>
        <translation>● war schon da, unversehrt</translation>
    </message>
    <message>
        <source>▲ needs an answer</source>
        <translation>▲ braucht eine Antwort</translation>
    </message>
    <message>
        <source>■ not imported</source>
        <translation>■ nicht importiert</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>imported: {count}</source>
        <translation>importiert: {count}</translation>
    </message>
    <message>
        <source>were there: {count}</source>
        <translation>schon da: {count}</translation>
    </message>
    <message>
        <source>need an answer: {count}</source>
        <translation>Antwort nötig: {count}</translation>
    </message>
    <message>
        <source>not imported: {count}</source>
        <translation>nicht importiert: {count}</translation>
    </message>
    <message>
        <source>stopped: {count}</source>
        <translation>angehalten: {count}</translation>
    </message>
    <message>
        <source>importing: {count}</source>
        <translation>im Import: {count}</translation>
    </message>
    <message>
        <source>waiting: {count}</source>
        <translation>wartend: {count}</translation>
    </message>
    <message>
        <source>Clips: {count}</source>
        <translation>Clips: {count}</translation>
    </message>
    <message>
        <source>Choose clips and logs</source>
        <translation>Clips und Protokolle wählen</translation>
    </message>
    <message>
        <source>Choose a folder of clips</source>
        <translation>Ordner mit Clips wählen</translation>
    </message>
</context>
<context>
    <name>RatingList</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a rating while a clip plays</source>
        <translation>Bewertung während eines Clips hinzufügen</translation>
    </message>
    <message>
        <source>Ratings while a clip plays</source>
        <translation>Bewertungen während eines Clips</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Schieberegler</translation>
    </message>
    <message>
        <source>Number every so often</source>
        <translation>Zahl in Abständen</translation>
    </message>
    <message>
        <source>Key that is held</source>
        <translation>Gehaltene Taste</translation>
    </message>
    <message>
        <source>(no wording yet)</source>
        <translation>(noch kein Wortlaut)</translation>
    </message>
    <message>
        <source>Wording</source>
        <translation>Wortlaut</translation>
    </message>
    <message>
        <source>Kind of rating</source>
        <translation>Art der Bewertung</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinste</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Asked for every</source>
        <translation>Abgefragt alle</translation>
    </message>
    <message>
        <source>Said aloud: the operator enters it</source>
        <translation>Laut gesagt: Die Versuchsleitung gibt sie ein</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>A letter, enter, shift or control</source>
        <translation>Ein Buchstabe, enter, shift oder control</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Name in den Daten</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>In Daten und Abbildungen: a bis z, 0 bis 9, _ und -</translation>
    </message>
    <message>
        <source>Ends clip and force from</source>
        <translation>Beendet Clip und Kraft ab</translation>
    </message>
    <message>
        <source>A value from which the clip ends; empty for none</source>
        <translation>Ein Wert, ab dem der Clip endet; leer für keinen</translation>
    </message>
    <message>
        <source>Text of the break after that</source>
        <translation>Text der Pause danach</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Bewegt mit</translation>
    </message>
    <message>
        <source>Add a label</source>
        <translation>Beschriftung hinzufügen</translation>
    </message>
    <message>
        <source>another label</source>
        <translation>andere Beschriftung</translation>
    </message>
    <message>
        <source>another rating</source>
        <translation>andere Bewertung</translation>
    </message>
    <message>
        <source>another kind of rating</source>
        <translation>andere Art der Bewertung</translation>
    </message>
</context>
<context>
    <name>Reading</name>
    <message>
        <source>not stated</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>choose or type</source>
        <translation>wählen oder eintippen</translation>
    </message>
    <message>
        <source>accelerometer {axis}</source>
        <translation>Beschleunigungssensor {axis}</translation>
    </message>
    <message>
        <source>gyroscope {axis}</source>
        <translation>Gyroskop {axis}</translation>
    </message>
    <message>
        <source>magnetometer {axis}</source>
        <translation>Magnetometer {axis}</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>übergehen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>+1 g upwards</source>
        <translation>+1 g nach oben</translation>
    </message>
    <message>
        <source>−1 g upwards</source>
        <translation>−1 g nach oben</translation>
    </message>
    <message>
        <source>single values</source>
        <translation>Einzelwerte</translation>
    </message>
    <message>
        <source>means over a window</source>
        <translation>Mittelwerte über ein Fenster</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Einheit der Zeit</translation>
    </message>
    <message>
        <source>Accelerometer unit</source>
        <translation>Einheit der Beschleunigung</translation>
    </message>
    <message>
        <source>Gyroscope unit</source>
        <translation>Einheit des Gyroskops</translation>
    </message>
    <message>
        <source>Accelerometer reads</source>
        <translation>Beschleunigungssensor zeigt</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Werte sind</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Werte je Sekunde</translation>
    </message>
    <message>
        <source>Magnetometer unit</source>
        <translation>Einheit des Magnetometers</translation>
    </message>
    <message>
        <source>right {right}, front {front}, up {up}</source>
        <translation>rechts {right}, vorn {front}, oben {up}</translation>
    </message>
    <message>
        <source>not swapped</source>
        <translation>nicht vertauscht</translation>
    </message>
    <message>
        <source>accelerometer, gyroscope</source>
        <translation>Beschleunigung, Gyroskop</translation>
    </message>
    <message>
        <source>accelerometer, magnetometer</source>
        <translation>Beschleunigung, Magnetometer</translation>
    </message>
    <message>
        <source>The wearer’s axes in the log</source>
        <translation>Achsen der Person</translation>
    </message>
    <message>
        <source>Accelerometer x, y, z</source>
        <translation>Beschleunigungssensor x, y, z</translation>
    </message>
    <message>
        <source>Gyroscope x, y, z</source>
        <translation>Gyroskop x, y, z</translation>
    </message>
    <message>
        <source>Gyroscope late by, s</source>
        <translation>Gyroskop verspätet um, s</translation>
    </message>
    <message>
        <source>Swapped columns</source>
        <translation>Vertauschte Spalten</translation>
    </message>
    <message>
        <source>If a sensor was stuck</source>
        <translation>Wenn ein Sensor festhing</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>keine Kraft</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
</context>
<context>
    <name>ReadingPage</name>
    <message>
        <source>How the log is read</source>
        <translation>Wie das Protokoll gelesen wird</translation>
    </message>
    <message>
        <source>Filled in from</source>
        <translation>Vorausgefüllt mit</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Keep as</source>
        <translation>Speichern als</translation>
    </message>
    <message>
        <source>a name, to use this for the next log</source>
        <translation>ein Name, um dies für das nächste Protokoll zu verwenden</translation>
    </message>
    <message>
        <source>From a &amp;file…</source>
        <translation>Aus einer &amp;Datei…</translation>
    </message>
    <message>
        <source>Load the answers from a template</source>
        <translation>Antworten aus einer Vorlage laden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Keep what was answered before</source>
        <translation>Die bisherigen Antworten behalten</translation>
    </message>
    <message>
        <source>&amp;Use this</source>
        <translation>Ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Read the log with these answers</source>
        <translation>Das Protokoll mit diesen Antworten lesen</translation>
    </message>
    <message>
        <source>F&amp;illed in from</source>
        <translation>&amp;Vorausgefüllt mit</translation>
    </message>
    <message>
        <source>&amp;Keep as</source>
        <translation>&amp;Speichern als</translation>
    </message>
    <message>
        <source>Say what each column of {name} holds and in which units. The check shows at once whether gravity agrees.</source>
        <translation>Geben Sie an, was jede Spalte von {name} enthält und in welchen Einheiten. Die Prüfung zeigt sofort, ob die Schwerkraft dazu passt.</translation>
    </message>
    <message>
        <source>{name} describes itself. Say here what it has wrong; the check shows at once whether gravity agrees.</source>
        <translation>{name} beschreibt sich selbst. Geben Sie hier an, was daran falsch ist; die Prüfung zeigt sofort, ob die Schwerkraft dazu passt.</translation>
    </message>
    <message>
        <source>Choose a template</source>
        <translation>Vorlage wählen</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
    <message>
        <source>Read: {rate} Hz, {duration}</source>
        <translation>Gelesen: {rate} Hz, {duration}</translation>
    </message>
    <message>
        <source>Never at rest: not compared with gravity (9.81 m/s²)</source>
        <translation>Nie in Ruhe: nicht mit der Schwerkraft verglichen (9.81 m/s²)</translation>
    </message>
    <message>
        <source>At rest {norm} m/s²; gravity is {gravity} m/s²</source>
        <translation>In Ruhe {norm} m/s²; die Schwerkraft ist {gravity} m/s²</translation>
    </message>
    <message>
        <source>Gravity hardly turns: the gyroscope cannot be compared</source>
        <translation>Die Schwerkraft dreht sich kaum: Das Gyroskop lässt sich nicht vergleichen</translation>
    </message>
    <message>
        <source>The gyroscope agrees with turning gravity</source>
        <translation>Das Gyroskop passt zur Drehung der Schwerkraft</translation>
    </message>
    <message>
        <source>The gyroscope does not agree with turning gravity</source>
        <translation>Das Gyroskop passt nicht zur Drehung der Schwerkraft</translation>
    </message>
    <message>
        <source>Choose: {fields}</source>
        <translation>Wählen Sie: {fields}</translation>
    </message>
</context>
<context>
    <name>RecentMenu</name>
    <message>
        <source>Clear list</source>
        <translation>Liste leeren</translation>
    </message>
</context>
<context>
    <name>RecordPage</name>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
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
        <source>&amp;Mark</source>
        <translation>&amp;Markieren</translation>
    </message>
    <message>
        <source>Mark this moment in the recording</source>
        <translation>Diesen Moment in der Aufnahme markieren</translation>
    </message>
    <message>
        <source>Pre&amp;view</source>
        <translation>&amp;Vorschau</translation>
    </message>
    <message>
        <source>Show picture, sound and motion for a minute; nothing is kept</source>
        <translation>Bild, Ton und Bewegung eine Minute lang zeigen; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufnehmen</translation>
    </message>
    <message>
        <source>Start a recording</source>
        <translation>Eine Aufnahme beginnen</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Bee&amp;nden</translation>
    </message>
    <message>
        <source>Stop, and show the take</source>
        <translation>Beenden und die Aufnahme zeigen</translation>
    </message>
    <message>
        <source>Record &amp;again</source>
        <translation>Noch ei&amp;nmal</translation>
    </message>
    <message>
        <source>Keep this take, and record another one</source>
        <translation>Diese Aufnahme behalten und noch eine machen</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Make a sequence of this take</source>
        <translation>Aus dieser Aufnahme eine Sequenz machen</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>Wird geschlossen</translation>
    </message>
    <message>
        <source>Reading the take</source>
        <translation>Die Aufnahme wird gelesen</translation>
    </message>
    <message>
        <source>&amp;Allow</source>
        <translation>&amp;Erlauben</translation>
    </message>
    <message>
        <source>&amp;Do not allow</source>
        <translation>&amp;Nicht erlauben</translation>
    </message>
    <message>
        <source>End pre&amp;view</source>
        <translation>&amp;Vorschau beenden</translation>
    </message>
    <message>
        <source>A recording is running. Stop it? What was recorded is kept.</source>
        <translation>Eine Aufnahme läuft. Beenden? Was aufgenommen wurde, bleibt erhalten.</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Weiter aufnehmen</translation>
    </message>
</context>
<context>
    <name>RecoveryBar</name>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Throw these changes away for good</source>
        <translation>Diese Änderungen endgültig verwerfen</translation>
    </message>
    <message>
        <source>Changes to {name} from {moment} were not saved.</source>
        <translation>Änderungen an {name} vom {moment} wurden nicht gespeichert.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
</context>
<context>
    <name>RenderingFields</name>
    <message>
        <source>S&amp;often strong forces (soft knee at {knee} N)</source>
        <translation>Starke Kräfte abm&amp;ildern (weiches Knie bei {knee} N)</translation>
    </message>
    <message>
        <source>Compresses what is above instead of cutting it at the limit</source>
        <translation>Staucht, was darüber liegt, statt es an der Grenze abzuschneiden</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendering</translation>
    </message>
    <message>
        <source>Kind of gain</source>
        <translation>Art der Verstärkung</translation>
    </message>
    <message>
        <source>One for all axes</source>
        <translation>Eine für alle Achsen</translation>
    </message>
    <message>
        <source>One for each axis</source>
        <translation>Eine je Achse</translation>
    </message>
    <message>
        <source>Fitted to this clip</source>
        <translation>An diesen Clip angepasst</translation>
    </message>
    <message>
        <source> N per m/s²</source>
        <translation> N je m/s²</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Use the same gain for all sequences that you compare</source>
        <translation>Dieselbe Verstärkung für alle Sequenzen, die verglichen werden</translation>
    </message>
    <message>
        <source>Device position</source>
        <translation>Position des Geräts</translation>
    </message>
    <message>
        <source>in front of the user: forward pulls the hand away</source>
        <translation>vor der Person: vorwärts zieht die Hand weg</translation>
    </message>
    <message>
        <source>to the right of the user</source>
        <translation>rechts von der Person</translation>
    </message>
    <message>
        <source>behind the user</source>
        <translation>hinter der Person</translation>
    </message>
    <message>
        <source>to the left of the user</source>
        <translation>links von der Person</translation>
    </message>
    <message>
        <source>other axes</source>
        <translation>andere Achsen</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>The device’s right, up and towards the user in the wearer’s axes (x right, y front, z up), such as x,z,-y, or the nine numbers of a rotation, row by row</source>
        <translation>Rechts, oben und zur Person hin am Gerät, in den Achsen der Person mit dem Rekorder (x rechts, y vorn, z oben), etwa x,z,-y, oder die neun Zahlen einer Drehung, Zeile für Zeile</translation>
    </message>
    <message>
        <source>Handlebar</source>
        <translation>Lenker</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Felt point</source>
        <translation>Gefühlter Punkt</translation>
    </message>
    <message>
        <source>the recorder itself</source>
        <translation>der Rekorder selbst</translation>
    </message>
    <message>
        <source>{point}, from a recorder on the chest</source>
        <translation>{point}, Rekorder auf der Brust</translation>
    </message>
    <message>
        <source>another point</source>
        <translation>ein anderer Punkt</translation>
    </message>
    <message>
        <source>From the recorder</source>
        <translation>Vom Rekorder aus</translation>
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
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>&amp;Rendering</source>
        <translation>&amp;Rendering</translation>
    </message>
    <message>
        <source>&amp;Gain</source>
        <translation>&amp;Verstärkung</translation>
    </message>
    <message>
        <source>&amp;Device position</source>
        <translation>Position des &amp;Geräts</translation>
    </message>
    <message>
        <source>&amp;Felt point</source>
        <translation>Gefühlter &amp;Punkt</translation>
    </message>
    <message>
        <source>Fitted to this clip: {gain} N per m/s². Sequences with different gains cannot be compared</source>
        <translation>An diesen Clip angepasst: {gain} N je m/s². Sequenzen mit verschiedenen Verstärkungen sind nicht vergleichbar</translation>
    </message>
    <message>
        <source>Faithful</source>
        <translation>Getreu</translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation>Ausgewogen</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>towards the user</source>
        <translation>zur Person hin</translation>
    </message>
</context>
<context>
    <name>RenderingPage</name>
    <message>
        <source>Rendering</source>
        <translation>Rendering</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>lockere</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>feste</translation>
    </message>
    <message>
        <source>Force, RMS</source>
        <translation>Kraft, Effektivwert</translation>
    </message>
    <message>
        <source>Force, peak</source>
        <translation>Kraft, Spitze</translation>
    </message>
    <message>
        <source>Time at the force limit</source>
        <translation>Zeit an der Kraftgrenze</translation>
    </message>
    <message>
        <source>Workspace, {hand} hand</source>
        <translation>Arbeitsraum, {hand} Hand</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Abbrechen; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;New sequence…</source>
        <translation>&amp;Neue Sequenz…</translation>
    </message>
    <message>
        <source>Keep this sequence, and make another one in the library</source>
        <translation>Diese Sequenz behalten und eine weitere in der Bibliothek anlegen</translation>
    </message>
    <message>
        <source>Change this se&amp;quence</source>
        <translation>Diese Sequenz än&amp;dern</translation>
    </message>
    <message>
        <source>Render the realistic and the random track again</source>
        <translation>Die realistische und die zufällige Spur neu berechnen</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Predicting the excursion</source>
        <translation>Auslenkung wird vorhergesagt</translation>
    </message>
    <message>
        <source>The sequence was rendered again</source>
        <translation>Die Kraft der Sequenz wurde neu berechnet</translation>
    </message>
    <message>
        <source>{title} ({rendering})</source>
        <translation>{title} ({rendering})</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Neue Sequenz</translation>
    </message>
    <message>
        <source>New sequence: {folder}</source>
        <translation>Neue Sequenz: {folder}</translation>
    </message>
    <message>
        <source>Rendering the force</source>
        <translation>Kraft wird berechnet</translation>
    </message>
</context>
<context>
    <name>RenderingPicture</name>
    <message>
        <source>Force and predicted excursion: {before}, {after}</source>
        <translation>Kraft und vorhergesagte Auslenkung: {before}, {after}</translation>
    </message>
    <message>
        <source>Excursion from the centre: beyond {far} mm outward force is reduced, at {end} mm the workspace ends</source>
        <translation>Auslenkung aus der Mitte: jenseits von {far} mm wird die Kraft nach außen abgeschwächt, bei {end} mm endet der Arbeitsraum</translation>
    </message>
    <message>
        <source>Force to the right, N</source>
        <translation>Kraft nach rechts, N</translation>
    </message>
    <message>
        <source>Force up, N</source>
        <translation>Kraft nach oben, N</translation>
    </message>
    <message>
        <source>Force towards the user, N</source>
        <translation>Kraft zur Person hin, N</translation>
    </message>
    <message>
        <source>Excursion of a relaxed hand, mm</source>
        <translation>Auslenkung einer lockeren Hand, mm</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
</context>
<context>
    <name>ReportPage</name>
    <message>
        <source>Report a problem</source>
        <translation>Problem melden</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>Der Bericht</translation>
    </message>
    <message>
        <source>What did you do, what happened, what did you expect?</source>
        <translation>Was haben Sie getan, was ist geschehen, was haben Sie erwartet?</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>Speiche&amp;rn…</translation>
    </message>
    <message>
        <source>Save the report as a zip file</source>
        <translation>Den Bericht als Zip-Datei speichern</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>This is all that the report holds: no names of your files or folders, nothing of your recordings. It is saved on this computer; nothing is sent.</source>
        <translation>Das ist alles, was der Bericht enthält: keine Namen Ihrer Dateien oder Ordner, nichts aus Ihren Aufnahmen. Er wird auf diesem Rechner gespeichert; nichts wird gesendet.</translation>
    </message>
    <message>
        <source>Your &amp;words</source>
        <translation>Ihre &amp;Worte</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Zip-Dateien (*.zip)</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Gespeichert: {name}</translation>
    </message>
</context>
<context>
    <name>RigPanel</name>
    <message>
        <source>Listening on this computer at the ports {ports}. Play on this rig, or let a game send its telemetry here.</source>
        <translation>Hört auf diesem Rechner an den Ports {ports}. Spielen Sie auf dieser Bewegungsplattform ab, oder lassen Sie ein Spiel seine Telemetrie hierher senden.</translation>
    </message>
    <message>
        <source>Not listening</source>
        <translation>Hört nicht</translation>
    </message>
    <message>
        <source>No data received yet</source>
        <translation>Noch keine Daten empfangen</translation>
    </message>
    <message>
        <source>{format}: out of reach, {share:.0%} of it is done</source>
        <translation>{format}: außer Reichweite, {share:.0%} davon ausgeführt</translation>
    </message>
    <message>
        <source>{format}: followed</source>
        <translation>{format}: wird gefolgt</translation>
    </message>
    <message>
        <source>Simulated motion rig</source>
        <translation>Simulierte Bewegungsplattform</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Stop listening</source>
        <translation>Nicht mehr hören</translation>
    </message>
    <message>
        <source>&amp;Play on this rig</source>
        <translation>Auf dieser Plattform a&amp;bspielen</translation>
    </message>
    <message>
        <source>Add it to the outputs</source>
        <translation>Zu den Ausgaben hinzufügen</translation>
    </message>
</context>
<context>
    <name>ScoreFields</name>
    <message>
        <source>Meaning (English)</source>
        <translation>Bedeutung (Englisch)</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Gebildet aus</translation>
    </message>
    <message>
        <source>Names of questions of the page, or of scores before it</source>
        <translation>Namen von Fragen der Seite oder von Scores davor</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Computed as</source>
        <translation>Berechnet als</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Those that count from the other end of their range</source>
        <translation>Die vom anderen Ende ihres Bereichs an zählen</translation>
    </message>
    <message>
        <source>Factors of 1, x, x² …</source>
        <translation>Faktoren von 1, x, x² …</translation>
    </message>
    <message>
        <source>0, 2.5 multiplies the sum or mean by 2.5</source>
        <translation>0, 2.5 multipliziert Summe oder Mittelwert mit 2.5</translation>
    </message>
    <message>
        <source>Least answers to a mean</source>
        <translation>Mindestzahl der Antworten</translation>
    </message>
    <message>
        <source>All are needed where this is empty</source>
        <translation>Ist das leer, sind alle nötig</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Name in den Daten</translation>
    </message>
</context>
<context>
    <name>SequenceList</name>
    <message>
        <source>Add from the library…</source>
        <translation>Aus der Bibliothek hinzufügen…</translation>
    </message>
    <message>
        <source>Choose one or several</source>
        <translation>Eine oder mehrere wählen</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source>no recording yet</source>
        <translation>noch keine Aufnahme</translation>
    </message>
    <message>
        <source>Choose a recording…</source>
        <translation>Aufnahme wählen…</translation>
    </message>
    <message>
        <source>Choose from the library</source>
        <translation>Aus der Bibliothek wählen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Name in den Daten</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>In Daten und Abbildungen: a bis z, 0 bis 9, _ und -</translation>
    </message>
    <message>
        <source>What sequences differ in, such as viewpoint = first here and viewpoint = third in others; the analysis compares feedbacks at each level</source>
        <translation>Worin sich Sequenzen unterscheiden, etwa viewpoint = first hier und viewpoint = third bei anderen; die Auswertung vergleicht die Feedbacks auf jeder Stufe</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Titles are for you and for figures; participants never see them.</source>
        <translation>Titel sind für Sie und für Abbildungen; Teilnehmende sehen sie nie.</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>another sequence</source>
        <translation>andere Sequenz</translation>
    </message>
    <message>
        <source>another recording</source>
        <translation>andere Aufnahme</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>Opening {name}</source>
        <translation>{name} wird geöffnet</translation>
    </message>
    <message>
        <source>Making the force</source>
        <translation>Kraft wird berechnet</translation>
    </message>
    <message>
        <source>Another task is running; wait for it or cancel it</source>
        <translation>Eine andere Aufgabe läuft; warten Sie oder brechen Sie sie ab</translation>
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
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Skip…</source>
        <translation>Überspringen…</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Beenden…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
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
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Die Sitzung beenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Write a note; Enter saves it</source>
        <translation>Notiz schreiben; Eingabe speichert sie</translation>
    </message>
    <message>
        <source>Pause the clip; it will restart from the beginning</source>
        <translation>Clip anhalten; er beginnt danach von vorn</translation>
    </message>
    <message>
        <source>Repeat the last trial</source>
        <translation>Letzten Durchgang wiederholen</translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation>Diesen Schritt überspringen</translation>
    </message>
    <message>
        <source>End the session; it cannot be resumed</source>
        <translation>Sitzung beenden; sie lässt sich nicht fortsetzen</translation>
    </message>
    <message>
        <source>Participant&apos;s page</source>
        <translation>Seite der Person</translation>
    </message>
    <message>
        <source>Show the participant&apos;s page over this panel</source>
        <translation>Die Seite der Person über diesem Bedienfeld zeigen</translation>
    </message>
    <message>
        <source>Sessions and data</source>
        <translation>Sitzungen und Daten</translation>
    </message>
    <message>
        <source>Show what came of this session and those before</source>
        <translation>Die Ergebnisse dieser und früherer Sitzungen zeigen</translation>
    </message>
    <message>
        <source>Close the session</source>
        <translation>Die Sitzung schließen</translation>
    </message>
    <message>
        <source>Retry saving</source>
        <translation>Speichern erneut versuchen</translation>
    </message>
    <message>
        <source>Stop the force (Esc)</source>
        <translation>Kraft abschalten (Esc)</translation>
    </message>
    <message>
        <source>Volume {n} %, fixed for the session</source>
        <translation>Lautstärke {n}&#xa0;%, fest für die Sitzung</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Invalid trials: {k} of {n}</source>
        <translation>Ungültige Durchgänge: {k} von {n}</translation>
    </message>
    <message>
        <source>{reason} (trial {numbers})</source>
        <translation>{reason} (Durchgang {numbers})</translation>
    </message>
    <message>
        <source>No trial played yet</source>
        <translation>Noch kein Durchgang abgespielt</translation>
    </message>
    <message>
        <source>The last trial was valid</source>
        <translation>Der letzte Durchgang war gültig</translation>
    </message>
    <message>
        <source>The last trial was invalid: {reasons}</source>
        <translation>Der letzte Durchgang war ungültig: {reasons}</translation>
    </message>
    <message>
        <source>Reason for skipping this step:</source>
        <translation>Grund für das Überspringen:</translation>
    </message>
    <message>
        <source>Nothing was skipped: the participant has gone on to another step meanwhile. To skip this one, press Skip again.</source>
        <translation>Nichts wurde übersprungen: Die Person ist inzwischen bei einem anderen Schritt. Um diesen zu überspringen, drücken Sie noch einmal „Überspringen“.</translation>
    </message>
    <message>
        <source>Reason for ending the session (all answers so far are kept):</source>
        <translation>Grund für das Ende (alle bisherigen Antworten bleiben erhalten):</translation>
    </message>
    <message>
        <source>The session is not complete. Close it and resume later?</source>
        <translation>Die Sitzung ist nicht abgeschlossen. Schließen und später fortsetzen?</translation>
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
        <source>between two clips</source>
        <translation>zwischen zwei Clips</translation>
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
        <source>saving failed</source>
        <translation>Speichern fehlgeschlagen</translation>
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
    <name>SessionOutputs</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Let the session play on this device</source>
        <translation>Die Sitzung auf diesem Gerät spielen lassen</translation>
    </message>
    <message>
        <source>No device: participants feel nothing</source>
        <translation>Kein Gerät: Teilnehmende spüren nichts</translation>
    </message>
    <message>
        <source>Remove this device</source>
        <translation>Dieses Gerät entfernen</translation>
    </message>
    <message>
        <source>Remove {device}</source>
        <translation>{device} entfernen</translation>
    </message>
    <message>
        <source>This device is already in use</source>
        <translation>Dieses Gerät wird schon verwendet</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>to be repeated</source>
        <translation>wird wiederholt</translation>
    </message>
    <message>
        <source>safety stop ({0})</source>
        <translation>Sicherheitsabschaltung ({0})</translation>
    </message>
    <message>
        <source>an output did not play ({0})</source>
        <translation>eine Ausgabe hat nicht gespielt ({0})</translation>
    </message>
    <message>
        <source>{0} reached its limit</source>
        <translation>{0} hat die Grenze erreicht</translation>
    </message>
    <message>
        <source>force and video out of sync</source>
        <translation>Kraft und Video nicht synchron</translation>
    </message>
    <message>
        <source>force and sound out of sync</source>
        <translation>Kraft und Ton nicht synchron</translation>
    </message>
    <message>
        <source>ratings could not be saved</source>
        <translation>Bewertungen konnten nicht gespeichert werden</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>übersprungen</translation>
    </message>
    <message>
        <source>session ended</source>
        <translation>Sitzung beendet</translation>
    </message>
    <message>
        <source>the force was stopped</source>
        <translation>die Kraft wurde abgeschaltet</translation>
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
        <source>another window took the focus</source>
        <translation>ein anderes Fenster bekam den Fokus</translation>
    </message>
    <message>
        <source>the window was closed</source>
        <translation>das Fenster wurde geschlossen</translation>
    </message>
    <message>
        <source>frames dropped</source>
        <translation>Bilder verworfen</translation>
    </message>
    <message>
        <source>no sound</source>
        <translation>kein Ton</translation>
    </message>
    <message>
        <source>gaps in the sound</source>
        <translation>Lücken im Ton</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>device lost</source>
        <translation>Gerät verloren</translation>
    </message>
    <message>
        <source>missed periods in the haptic loop</source>
        <translation>Aussetzer der haptischen Schleife</translation>
    </message>
    <message>
        <source>no data from the device</source>
        <translation>keine Daten vom Gerät</translation>
    </message>
    <message>
        <source>gaps in the record</source>
        <translation>Lücken in der Aufzeichnung</translation>
    </message>
    <message>
        <source>the clip is damaged</source>
        <translation>der Clip ist beschädigt</translation>
    </message>
</context>
<context>
    <name>SetupPage</name>
    <message>
        <source>Firmware file…</source>
        <translation>Firmware-Datei…</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>Dieses Gerät benutzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Install your copy of the firmware</source>
        <translation>Ihre Kopie der Firmware installieren</translation>
    </message>
    <message>
        <source>Try out the forces…</source>
        <translation>Kräfte ausprobieren…</translation>
    </message>
    <message>
        <source>Feel every direction, starting gently</source>
        <translation>Jede Richtung spüren, sanft beginnend</translation>
    </message>
    <message>
        <source>Use it for playback</source>
        <translation>Für die Wiedergabe benutzen</translation>
    </message>
    <message>
        <source>Play on several devices at once</source>
        <translation>Auf mehreren Geräten zugleich abspielen</translation>
    </message>
    <message>
        <source>Outputs…</source>
        <translation>Ausgaben…</translation>
    </message>
    <message>
        <source>Keep the current device</source>
        <translation>Bisheriges Gerät behalten</translation>
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
        <source>Test</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Looking for the device</source>
        <translation>Das Gerät wird gesucht</translation>
    </message>
    <message>
        <source>Not ready yet</source>
        <translation>Noch nicht bereit</translation>
    </message>
    <message>
        <source>No setup needed</source>
        <translation>Keine Einrichtung nötig</translation>
    </message>
    <message>
        <source>Ready to be tested</source>
        <translation>Bereit zum Testen</translation>
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
        <source>Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and plug it in.</source>
        <translation>Kopieren Sie die udev-Regel {rule} nach /etc/udev/rules.d, ziehen Sie den Falcon dann ab und stecken Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>The Falcon has the wrong driver</source>
        <translation>Der Falcon hat den falschen Treiber</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware</source>
        <translation>Der Falcon braucht seine Firmware</translation>
    </message>
    <message>
        <source>Connect its USB cable and power supply; it is detected automatically.</source>
        <translation>Schließen Sie USB-Kabel und Netzteil an; er wird automatisch erkannt.</translation>
    </message>
    <message>
        <source>Permission denied for the Falcon</source>
        <translation>Keine Berechtigung für den Falcon</translation>
    </message>
    <message>
        <source>The Falcon is in use by another program</source>
        <translation>Ein anderes Programm benutzt den Falcon</translation>
    </message>
    <message>
        <source>Close that program; setup then continues automatically.</source>
        <translation>Schließen Sie das Programm; dann geht es automatisch weiter.</translation>
    </message>
    <message>
        <source>Replace FTDI&apos;s or Force Dimension&apos;s driver by WinUSB, using Zadig; then unplug it and plug it in again.</source>
        <translation>Ersetzen Sie den Treiber von FTDI oder Force Dimension mit Zadig durch WinUSB; ziehen Sie ihn dann ab und stecken Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>It belongs to Novint and cannot be distributed with this program. Take nvent_firmware.bin from a libnifalcon source archive and choose the file here, once.</source>
        <translation>Sie gehört Novint und darf nicht mit diesem Programm verteilt werden. Nehmen Sie nvent_firmware.bin aus einem Quellarchiv von libnifalcon und wählen Sie die Datei hier einmal aus.</translation>
    </message>
    <message>
        <source>Pull the grip all the way out</source>
        <translation>Ziehen Sie den Griff ganz heraus</translation>
    </message>
    <message>
        <source>Push the grip in until it locks</source>
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
        <source>Move the grip: the drawing follows.</source>
        <translation>Bewegen Sie den Griff: die Zeichnung folgt.</translation>
    </message>
    <message>
        <source>Homed joints: {legs}. The force is off.</source>
        <translation>Referenzierte Gelenke: {legs}. Die Kraft ist aus.</translation>
    </message>
    <message>
        <source>The Falcon&apos;s firmware belongs to Novint Technologies. libnifalcon distributes it under Novint&apos;s SDK licence (its file license/LICENSE_NOVINT.txt): free of charge for personal, noncommercial use, binding for every recipient. Read that licence; by continuing you confirm that you may use this file. It stays on this computer.</source>
        <translation>Die Firmware des Falcon gehört Novint Technologies. libnifalcon verteilt sie unter der SDK-Lizenz von Novint (Datei license/LICENSE_NOVINT.txt): kostenlos für persönlichen, nicht kommerziellen Gebrauch, bindend für alle Empfänger. Lesen Sie diese Lizenz; wenn Sie fortfahren, bestätigen Sie, dass Sie die Datei benutzen dürfen. Sie bleibt auf diesem Computer.</translation>
    </message>
    <message>
        <source>The file is intact but is not a known firmware image. It would drive the motors. Install it only if you trust its source.</source>
        <translation>Die Datei ist unversehrt, aber keine bekannte Firmware. Sie würde die Motoren steuern. Installieren Sie sie nur, wenn Sie der Quelle vertrauen.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keines</translation>
    </message>
</context>
<context>
    <name>SharePage</name>
    <message>
        <source>Share</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>&amp;One file (MKV)</source>
        <translation>&amp;Eine Datei (MKV)</translation>
    </message>
    <message>
        <source>M&amp;P4, with a second file for the force</source>
        <translation>M&amp;P4, mit einer zweiten Datei für die Kraft</translation>
    </message>
    <message>
        <source>A video file to send: every player shows it, hapticplayer also plays the force.</source>
        <translation>Eine Videodatei zum Verschicken: Jedes Programm zeigt sie, hapticplayer spielt auch die Kraft.</translation>
    </message>
    <message>
        <source>Others can then render another force from it</source>
        <translation>Andere können daraus dann eine andere Kraft berechnen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Include &amp;motion and recorded samples</source>
        <translation>&amp;Bewegung und aufgezeichnete Messwerte mitgeben</translation>
    </message>
    <message>
        <source>Include &amp;names, dates and places</source>
        <translation>&amp;Namen, Zeiten und Orte mitgeben</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Abbrechen; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>Speiche&amp;rn…</translation>
    </message>
    <message>
        <source>Choose a name, and write it</source>
        <translation>Einen Namen wählen und die Datei schreiben</translation>
    </message>
    <message>
        <source>included</source>
        <translation>enthalten</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>Saved: {names}, {size}</source>
        <translation>Gespeichert: {names}, {size}</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>What is shared</source>
        <translation>Was geteilt wird</translation>
    </message>
    <message>
        <source>Matroska video (*.mkv)</source>
        <translation>Matroska-Video (*.mkv)</translation>
    </message>
    <message>
        <source>MP4 video (*.mp4)</source>
        <translation>MP4-Video (*.mp4)</translation>
    </message>
    <message>
        <source>Share as</source>
        <translation>Teilen als</translation>
    </message>
    <message>
        <source>Sharing</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>{number} kB</source>
        <translation>{number} kB</translation>
    </message>
    <message>
        <source>{number} MB</source>
        <translation>{number} MB</translation>
    </message>
</context>
<context>
    <name>Sides</name>
    <message>
        <source>Synchronise by the tap marks alone</source>
        <translation>Nur nach den Klopfzeichen synchronisieren</translation>
    </message>
    <message>
        <source>Synchronise by the frames alone</source>
        <translation>Nur nach den Bildern synchronisieren</translation>
    </message>
    <message>
        <source>Use the taps</source>
        <translation>Klopfzeichen nehmen</translation>
    </message>
    <message>
        <source>Use the frames</source>
        <translation>Bilder nehmen</translation>
    </message>
</context>
<context>
    <name>SpokenNumber</name>
    <message>
        <source>The number that was said</source>
        <translation>Die gesagte Zahl</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingeben</translation>
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
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Play a clip</source>
        <translation>Einen Clip spielen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Resume {code}</source>
        <translation>{code} fortsetzen</translation>
    </message>
    <message>
        <source>Check that the sound is audible</source>
        <translation>Prüfen, ob der Ton zu hören ist</translation>
    </message>
    <message>
        <source>Fixed for the whole session and stored with it</source>
        <translation>Fest für die ganze Sitzung und mit ihr gespeichert</translation>
    </message>
    <message>
        <source>The sound is audible</source>
        <translation>Der Ton ist zu hören</translation>
    </message>
    <message>
        <source>Start despite failed checks</source>
        <translation>Trotz nicht bestandener Prüfungen beginnen</translation>
    </message>
    <message>
        <source>Show the first page to the participant</source>
        <translation>Der Person die erste Seite zeigen</translation>
    </message>
    <message>
        <source>Start session</source>
        <translation>Sitzung starten</translation>
    </message>
    <message>
        <source>Motion sensor of the demonstration</source>
        <translation>Bewegungssensor der Vorführung</translation>
    </message>
    <message>
        <source>none; or what you move is felt, such as wt901:/dev/ttyUSB0</source>
        <translation>keiner; sonst ist zu spüren, was Sie bewegen, etwa wt901:/dev/ttyUSB0</translation>
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
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Vorführung</translation>
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
        <source>There is one screen: from the start, the participant&apos;s page covers this panel. {keys} brings the panel back and pauses; participants are not told.</source>
        <translation>Es gibt nur einen Bildschirm: Vom Start an verdeckt die Seite der Person dieses Bedienfeld. {keys} holt es zurück und hält an; die Teilnehmenden erfahren davon nichts.</translation>
    </message>
    <message>
        <source>this is the first participant</source>
        <translation>dies ist die erste Person</translation>
    </message>
    <message>
        <source>each condition {a} to {b} times at each position, {c} to {d} times after each other condition</source>
        <translation>jede Bedingung {a}- bis {b}-mal an jeder Stelle, {c}- bis {d}-mal nach jeder anderen</translation>
    </message>
    <message>
        <source>Grip homed</source>
        <translation>Griff referenziert</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Zeitzuteilung</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Participant&apos;s screen</source>
        <translation>Bildschirm der Person</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Datenträger</translation>
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
        <source>{shown} shown, {dropped} dropped</source>
        <translation>{shown} gezeigt, {dropped} verworfen</translation>
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
        <translation>Zeitzuteilung</translation>
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
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Lateness, µs</source>
        <translation>Verspätung, µs</translation>
    </message>
    <message>
        <source>Force − video, ms</source>
        <translation>Kraft − Video, ms</translation>
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
        <source>video {0:.0f}  sound {1:.0f}  force {2:.0f}  reported {3:.0f}</source>
        <translation>Video {0:.0f}  Ton {1:.0f}  Kraft {2:.0f}  gemeldet {3:.0f}</translation>
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
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>During clips</source>
        <translation>Während der Clips</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z)</source>
        <translation>Wiederholen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Saved as a draft until the problems are solved</source>
        <translation>Als Entwurf gespeichert, bis die Probleme gelöst sind</translation>
    </message>
    <message>
        <source>Saved; not ready for participants yet</source>
        <translation>Gespeichert; noch nicht bereit für Teilnehmende</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Changes that were not complete were restored. Undo goes back to the last complete study.</source>
        <translation>Unvollständige Änderungen wurden wiederhergestellt. Rückgängig führt zur letzten vollständigen Studie zurück.</translation>
    </message>
    <message>
        <source>restored changes</source>
        <translation>wiederhergestellte Änderungen</translation>
    </message>
    <message>
        <source>Not saved: close again to lose the changes</source>
        <translation>Nicht gespeichert: Noch einmal schließen verwirft die Änderungen</translation>
    </message>
    <message>
        <source>{trials} trials for each participant, about {minutes} minutes</source>
        <translation>{trials} Durchgänge je Person, etwa {minutes} Minuten</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
</context>
<context>
    <name>StudyFields</name>
    <message>
        <source>{text} ({language})</source>
        <translation>{text} ({language})</translation>
    </message>
    <message>
        <source>change of {what}</source>
        <translation>Änderung: {what}</translation>
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
        <source>&amp;Sessions and data…</source>
        <translation>Sitzungen und &amp;Daten…</translation>
    </message>
    <message>
        <source>&amp;Analyse study…</source>
        <translation>Studie &amp;auswerten…</translation>
    </message>
    <message>
        <source>Opening the session…</source>
        <translation>Sitzung wird geöffnet…</translation>
    </message>
    <message>
        <source>Run a participant</source>
        <translation>Sitzung durchführen</translation>
    </message>
    <message>
        <source>Study folder</source>
        <translation>Studienordner</translation>
    </message>
</context>
<context>
    <name>StudyProcess</name>
    <message>
        <source>The session has ended with status {0}</source>
        <translation>Die Sitzung endete mit dem Status {0}</translation>
    </message>
</context>
<context>
    <name>StudyResults</name>
    <message>
        <source>Sessions – {title}</source>
        <translation>Sitzungen – {title}</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Text answers</source>
        <translation>Textantworten</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Beenden…</translation>
    </message>
    <message>
        <source>End a session that will not be resumed; its order is free again</source>
        <translation>Eine Sitzung beenden, die nicht fortgesetzt wird; ihre Reihenfolge wird wieder frei</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Delete a participant; says first what is erased</source>
        <translation>Eine Person löschen; sagt zuerst, was gelöscht wird</translation>
    </message>
    <message>
        <source>Pack…</source>
        <translation>Packen…</translation>
    </message>
    <message>
        <source>Write a copy with all sequences, for other sites to run</source>
        <translation>Eine Kopie mit allen Sequenzen schreiben, zur Durchführung an anderen Standorten</translation>
    </message>
    <message>
        <source>Merge…</source>
        <translation>Zusammenführen…</translation>
    </message>
    <message>
        <source>Packed to {folder}. Sites can compare the checksum of what they got (SHA-256 of the manifest): {checksum}</source>
        <translation>Nach {folder} gepackt. Standorte können die Prüfsumme dessen vergleichen, was sie bekommen haben (SHA-256 des Manifests): {checksum}</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Wird gepackt</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write the data for other programs</source>
        <translation>Die Daten für andere Programme schreiben</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Auswerten</translation>
    </message>
    <message>
        <source>Statistics and report</source>
        <translation>Statistik und Bericht</translation>
    </message>
    <message>
        <source>Approve for export</source>
        <translation>Für den Export freigeben</translation>
    </message>
    <message>
        <source>The selected answers identify no one</source>
        <translation>Die ausgewählten Antworten verraten niemanden</translation>
    </message>
    <message>
        <source>Answers in words may name a person. Read them; only those that you approve are exported.</source>
        <translation>Antworten in Worten können eine Person nennen. Lesen Sie sie; nur freigegebene werden exportiert.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Add the sessions of copies of this study on other machines</source>
        <translation>Die Sitzungen von Kopien dieser Studie auf anderen Rechnern hinzufügen</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Nobody has taken part yet: Study &gt; Run a participant.</source>
        <translation>Noch niemand hat teilgenommen: Studie &gt; Sitzung durchführen.</translation>
    </message>
    <message>
        <source>Sessions: {count}, complete: {done}, deleted: {deleted}</source>
        <translation>Sitzungen: {count}, vollständig: {done}, gelöscht: {deleted}</translation>
    </message>
    <message>
        <source>Trial {n} ({condition}) is invalid: {reasons}</source>
        <translation>Durchgang {n} ({condition}) ist ungültig: {reasons}</translation>
    </message>
    <message>
        <source>Resumed: {n} times</source>
        <translation>Fortgesetzt: {n}-mal</translation>
    </message>
    <message>
        <source>Damaged records: {n}</source>
        <translation>Beschädigte Aufzeichnungen: {n}</translation>
    </message>
    <message>
        <source>All answers in words are approved.</source>
        <translation>Alle Antworten in Worten sind freigegeben.</translation>
    </message>
    <message>
        <source>No answers in words yet.</source>
        <translation>Noch keine Antworten in Worten.</translation>
    </message>
    <message>
        <source>trial {n}</source>
        <translation>Durchgang {n}</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Die Sitzung beenden</translation>
    </message>
    <message>
        <source>Reason for ending the session (all answers so far are kept):</source>
        <translation>Grund für das Ende (alle bisherigen Antworten bleiben erhalten):</translation>
    </message>
    <message>
        <source>Deleting</source>
        <translation>Wird gelöscht</translation>
    </message>
    <message>
        <source>Delete participant {code}? Answers to {answered} trials, the records of the device and the consent are erased ({count} files, {size}) and cannot be restored. That somebody was deleted stays, without the code. Exports and reports outside of the study are yours to delete.</source>
        <translation>Person {code} löschen? Die Antworten zu {answered} Durchgängen, die Aufzeichnungen des Geräts und die Einwilligung werden gelöscht ({count} Dateien, {size}) und lassen sich nicht wiederherstellen. Dass jemand gelöscht wurde, bleibt vermerkt, ohne den Code. Exporte und Berichte außerhalb der Studie müssen Sie selbst löschen.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>The participant was deleted.</source>
        <translation>Die Person wurde gelöscht.</translation>
    </message>
    <message>
        <source>Still named in: {files}. Write these again or remove them.</source>
        <translation>Noch genannt in: {files}. Schreiben Sie diese neu, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>Exported to {folder}.</source>
        <translation>Nach {folder} exportiert.</translation>
    </message>
    <message>
        <source>Exporting the data</source>
        <translation>Daten werden exportiert</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>ended early</source>
        <translation>vorzeitig beendet</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>After each clip</source>
        <translation>Nach jedem Clip</translation>
    </message>
    <message>
        <source>Before the first clip</source>
        <translation>Vor dem ersten Clip</translation>
    </message>
    <message>
        <source>After the last clip</source>
        <translation>Nach dem letzten Clip</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Information about the device</source>
        <translation>Hinweise zum Gerät</translation>
    </message>
    <message>
        <source>Before each clip</source>
        <translation>Vor jedem Clip</translation>
    </message>
    <message>
        <source>Closing words</source>
        <translation>Schlussworte</translation>
    </message>
    <message>
        <source>How long data are kept</source>
        <translation>Wie lange Daten aufbewahrt werden</translation>
    </message>
    <message>
        <source>Button: agree to take part</source>
        <translation>Schaltfläche: der Teilnahme zustimmen</translation>
    </message>
    <message>
        <source>Button: decline to take part</source>
        <translation>Schaltfläche: die Teilnahme ablehnen</translation>
    </message>
    <message>
        <source>Button: next page</source>
        <translation>Schaltfläche: nächste Seite</translation>
    </message>
    <message>
        <source>Button: start the clip</source>
        <translation>Schaltfläche: den Clip starten</translation>
    </message>
    <message>
        <source>Button: feel the device</source>
        <translation>Schaltfläche: das Gerät spüren</translation>
    </message>
    <message>
        <source>Answer: yes</source>
        <translation>Antwort: ja</translation>
    </message>
    <message>
        <source>Answer: no</source>
        <translation>Antwort: nein</translation>
    </message>
    <message>
        <source>Name of a feedback, before its number</source>
        <translation>Name eines Feedbacks, vor seiner Nummer</translation>
    </message>
    <message>
        <source>Name of a clip, before its number</source>
        <translation>Name eines Clips, vor seiner Nummer</translation>
    </message>
    <message>
        <source>Mark of a question that may stay open</source>
        <translation>Kennzeichnung einer Frage, die offen bleiben darf</translation>
    </message>
    <message>
        <source>Message: a question is not answered</source>
        <translation>Meldung: Eine Frage ist nicht beantwortet</translation>
    </message>
    <message>
        <source>Message: bring the grip to the centre</source>
        <translation>Meldung: den Griff in die Mitte bringen</translation>
    </message>
    <message>
        <source>Page: paused</source>
        <translation>Seite: angehalten</translation>
    </message>
    <message>
        <source>Button: resume</source>
        <translation>Schaltfläche: fortsetzen</translation>
    </message>
    <message>
        <source>Button: end early</source>
        <translation>Schaltfläche: vorzeitig beenden</translation>
    </message>
    <message>
        <source>Page: ended early</source>
        <translation>Seite: vorzeitig beendet</translation>
    </message>
    <message>
        <source>Page: answers cannot be saved</source>
        <translation>Seite: Antworten lassen sich nicht speichern</translation>
    </message>
    <message>
        <source>Label of {n}</source>
        <translation>Beschriftung von {n}</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Page {n}</source>
        <translation>Seite {n}</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Buttons and messages</source>
        <translation>Schaltflächen und Meldungen</translation>
    </message>
    <message>
        <source>During clips</source>
        <translation>Während der Clips</translation>
    </message>
    <message>
        <source>Least time between two clips</source>
        <translation>Mindestzeit zwischen zwei Clips</translation>
    </message>
    <message>
        <source>A trial is marked as invalid above</source>
        <translation>Ein Durchgang gilt als ungültig oberhalb von</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Help line</source>
        <translation>Hilfezeile</translation>
    </message>
    <message>
        <source>Unit in the data</source>
        <translation>Einheit in den Daten</translation>
    </message>
    <message>
        <source>Labels of points</source>
        <translation>Beschriftungen der Punkte</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Part of the sum QoE</source>
        <translation>Teil der Summe QoE</translation>
    </message>
    <message>
        <source>Scores</source>
        <translation>Scores</translation>
    </message>
    <message>
        <source>Questions of a score</source>
        <translation>Fragen eines Scores</translation>
    </message>
    <message>
        <source>Counts as</source>
        <translation>Zählt als</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Bewegt mit</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Asked for every</source>
        <translation>Abgefragt alle</translation>
    </message>
    <message>
        <source>Ends clip and force from</source>
        <translation>Beendet Clip und Kraft ab</translation>
    </message>
    <message>
        <source>Text of the break after that</source>
        <translation>Text der Pause danach</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Sprachen</translation>
    </message>
    <message>
        <source>Published wording</source>
        <translation>Veröffentlichter Wortlaut</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Name in den Daten</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Wording</source>
        <translation>Wortlaut</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Smallest number</source>
        <translation>Kleinste Zahl</translation>
    </message>
    <message>
        <source>Largest number or length</source>
        <translation>Größte Zahl oder Länge</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
</context>
<context>
    <name>SuggestionBox</name>
    <message>
        <source>S&amp;uggest motion from the frames (estimate)</source>
        <translation>Bewegung a&amp;us den Bildern vorschlagen (Schätzung)</translation>
    </message>
    <message>
        <source>Expect to feel turns of a vehicle, and steps when walking or riding; braking, knocks and potholes will be missing. Nothing measures this motion: set its strength by hand with the gain, and do not use it in a study without saying so. Slow motion and time lapse are taken as they play.</source>
        <translation>Zu spüren sind Kurven eines Fahrzeugs und Schritte beim Gehen oder Reiten; Bremsen, Stöße und Schlaglöcher fehlen. Nichts misst diese Bewegung: Stellen Sie ihre Stärke von Hand mit der Verstärkung ein, und verwenden Sie sie in keiner Studie, ohne es zu sagen. Zeitlupe und Zeitraffer werden genommen, wie sie laufen.</translation>
    </message>
    <message>
        <source>This needs OpenCV: see Help &gt; System check.</source>
        <translation>Das braucht OpenCV: siehe Hilfe &gt; Systemprüfung.</translation>
    </message>
    <message>
        <source>Choose its motion log above, if there is one.</source>
        <translation>Wählen Sie oben das Bewegungsprotokoll, falls es eines gibt.</translation>
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
        <source>Sound delay</source>
        <translation>Tonverzögerung</translation>
    </message>
    <message>
        <source>How much later than the video the camera records its sound</source>
        <translation>Um wie viel später als das Video die Kamera den Ton aufzeichnet</translation>
    </message>
    <message>
        <source>use for this camera</source>
        <translation>für diese Kamera verwenden</translation>
    </message>
    <message>
        <source>I have checked the offset by eye and ear</source>
        <translation>Ich habe den Versatz mit Auge und Ohr geprüft</translation>
    </message>
    <message>
        <source>&amp;Listen</source>
        <translation>An&amp;hören</translation>
    </message>
    <message>
        <source>Play the visible part: the clip on the left, a tick at each tap of the log on the right</source>
        <translation>Den sichtbaren Teil abspielen: links der Clip, rechts ein Tick bei jedem Klopfen des Protokolls</translation>
    </message>
    <message>
        <source>S&amp;ound delay</source>
        <translation>Tonverzöge&amp;rung</translation>
    </message>
    <message>
        <source>{recorder} records its motion on the clip&apos;s clock; no synchronisation is needed.</source>
        <translation>{recorder} zeichnet die Bewegung nach der Uhr des Clips auf; Synchronisieren ist nicht nötig.</translation>
    </message>
    <message>
        <source>Could not synchronise: {why}. Enter the offset manually.</source>
        <translation>Synchronisieren nicht möglich: {why}. Geben Sie den Versatz von Hand ein.</translation>
    </message>
    <message>
        <source>The offset was set manually.</source>
        <translation>Der Versatz wurde von Hand gesetzt.</translation>
    </message>
    <message>
        <source>The tap marks and the frames disagree ({method}: {offset} s, {other}: {other_offset} s). Check which is right.</source>
        <translation>Klopfzeichen und Bilder widersprechen sich ({method}: {offset} s, {other}: {other_offset} s). Prüfen Sie, was stimmt.</translation>
    </message>
    <message>
        <source>Synchronised: {method} (confidence {confidence}).</source>
        <translation>Synchronisiert: {method} (Sicherheit {confidence}).</translation>
    </message>
    <message>
        <source>Tap marks found (confidence {confidence}, residual {ms} ms).</source>
        <translation>Klopfzeichen gefunden (Sicherheit {confidence}, Rest {ms} ms).</translation>
    </message>
    <message>
        <source>The tap marks are uncertain (confidence {confidence}). Check that the same events line up, and drag them if not.</source>
        <translation>Die Klopfzeichen sind unsicher (Sicherheit {confidence}). Prüfen Sie, ob dieselben Ereignisse untereinander liegen, und ziehen Sie sie sonst.</translation>
    </message>
    <message>
        <source>No three taps found in both sound and motion; drag manually.</source>
        <translation>Kein dreimaliges Klopfen in Ton und Bewegung gefunden; ziehen Sie von Hand.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>Slow motion</source>
        <translation>Zeitlupe</translation>
    </message>
    <message>
        <source>How many times slower than it was recorded the video plays: 8 if 240 frames per second play at 30; below 1 for a time lapse</source>
        <translation>Wievielmal langsamer als aufgenommen das Video läuft: 8, wenn 240 Bilder je Sekunde mit 30 laufen; unter 1 bei einem Zeitraffer</translation>
    </message>
    <message>
        <source>Clock drift</source>
        <translation>Gang der Uhr</translation>
    </message>
    <message>
        <source> ppm</source>
        <translation> ppm</translation>
    </message>
    <message>
        <source>By how much faster the video runs than the log&apos;s clock</source>
        <translation>Um wie viel schneller das Video läuft als die Uhr des Protokolls</translation>
    </message>
    <message>
        <source>Sound delay of a camera</source>
        <translation>Tonverzögerung einer Kamera</translation>
    </message>
    <message>
        <source>The sound delay that is kept for a camera</source>
        <translation>Die Tonverzögerung, die für eine Kamera gespeichert ist</translation>
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
        <source>&amp;Close-up</source>
        <translation>&amp;Ausschnitt</translation>
    </message>
    <message>
        <source>Zoom to the tap marks, or to where the camera turned most</source>
        <translation>Auf die Klopfzeichen zoomen oder dorthin, wo sich die Kamera am meisten dreht</translation>
    </message>
    <message>
        <source>&amp;Offset</source>
        <translation>&amp;Versatz</translation>
    </message>
    <message>
        <source>Clock &amp;drift</source>
        <translation>Gang der &amp;Uhr</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Methode</translation>
    </message>
    <message>
        <source>Slow mo&amp;tion</source>
        <translation>Zeit&amp;lupe</translation>
    </message>
    <message>
        <source>Drag the log&apos;s curves until they line up with the clip&apos;s; the arrow keys move them by 1 ms, with Shift 10 ms, with Ctrl 100 ms. The wheel zooms. The frame shown is the one at the cursor; comma and period move it.</source>
        <translation>Ziehen Sie die Kurven des Protokolls unter die des Clips; die Pfeiltasten verschieben sie um 1 ms, mit Umschalt 10 ms, mit Strg 100 ms. Das Rad zoomt. Gezeigt wird das Bild am Cursor; Komma und Punkt bewegen ihn.</translation>
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
        <source>rotation in the frames</source>
        <translation>Drehung in den Bildern</translation>
    </message>
    <message>
        <source>gyro</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>as kept for…</source>
        <translation>wie gespeichert für…</translation>
    </message>
    <message>
        <source>{why}. Check below how much slower it plays than it was recorded (1: it does not), then enter the offset, or drag the log&apos;s curves.</source>
        <translation>{why}. Prüfen Sie unten, wievielmal langsamer als aufgenommen es läuft (1: gar nicht), und geben Sie dann den Versatz ein, oder ziehen Sie die Kurven des Protokolls.</translation>
    </message>
    <message>
        <source>Enter the offset, or drag the log&apos;s curves.</source>
        <translation>Geben Sie den Versatz ein, oder ziehen Sie die Kurven des Protokolls.</translation>
    </message>
    <message>
        <source>Check the offset: {why}.</source>
        <translation>Prüfen Sie den Versatz: {why}.</translation>
    </message>
    <message>
        <source>{recorder} records its motion with the clip.</source>
        <translation>{recorder} zeichnet die Bewegung zusammen mit dem Clip auf.</translation>
    </message>
    <message>
        <source>The rotation in the frames fits the log nowhere. Is it the log of this clip, and the video not stabilised? Drag manually.</source>
        <translation>Die Drehung in den Bildern passt nirgends zum Protokoll. Gehört es zu diesem Clip, und ist das Video nicht stabilisiert? Ziehen Sie von Hand.</translation>
    </message>
    <message>
        <source>The frames are uncertain (confidence {confidence}): the gyro explains {share} % of the rotation ({doubt}). Check that both line up, and drag if not.</source>
        <translation>Die Bilder sind unsicher (Sicherheit {confidence}): Das Gyroskop erklärt {share} % der Drehung ({doubt}). Prüfen Sie, ob beide untereinander liegen, und ziehen Sie sonst.</translation>
    </message>
    <message>
        <source>Frames and tap marks agree, to ±{ms} ms (confidence {confidence}); the gyro explains {share} % of the rotation in the frames.</source>
        <translation>Bilder und Klopfzeichen stimmen überein, auf ±{ms} ms (Sicherheit {confidence}); das Gyroskop erklärt {share} % der Drehung in den Bildern.</translation>
    </message>
    <message>
        <source>Frames and gyro fit, to ±{ms} ms (confidence {confidence}); the gyro explains {share} % of the rotation in the frames.</source>
        <translation>Bilder und Gyroskop passen zusammen, auf ±{ms} ms (Sicherheit {confidence}); das Gyroskop erklärt {share} % der Drehung in den Bildern.</translation>
    </message>
</context>
<context>
    <name>SyncPlot</name>
    <message>
        <source>Sync plot</source>
        <translation>Sync-Verlauf</translation>
    </message>
    <message>
        <source>How much later than video and sound the force came in the last 30 s. Between 15 ms early and 50 ms late is not noticeable</source>
        <translation>Um wie viel die Kraft in den letzten 30 s später kam als Video und Ton. Zwischen 15 ms zu früh und 50 ms zu spät ist nicht spürbar</translation>
    </message>
    <message>
        <source>Force − video</source>
        <translation>Kraft − Video</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Kraft − Ton</translation>
    </message>
</context>
<context>
    <name>SyncStrip</name>
    <message>
        <source>Clip and log over time</source>
        <translation>Clip und Protokoll über der Zeit</translation>
    </message>
    <message>
        <source>{time} s</source>
        <translation>{time} s</translation>
    </message>
</context>
<context>
    <name>TakeStrip</name>
    <message>
        <source>The take over time</source>
        <translation>Die Aufnahme über der Zeit</translation>
    </message>
    <message>
        <source>Click: seek, beside a mark exactly to it. Left and Right: 1 s, with Shift 5 s. Up and Down: previous and next mark. Wheel: zoom</source>
        <translation>Klick: springen, neben einer Marke genau zu ihr. Links und Rechts: 1 s, mit Umschalt 5 s. Auf und Ab: vorige und nächste Marke. Rad: zoomen</translation>
    </message>
</context>
<context>
    <name>TakeView</name>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play the take with its sound</source>
        <translation>Die Aufnahme mit ihrem Ton abspielen</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>acceleration without gravity, p</source>
        <translation>Beschleunigung ohne Schwerkraft, p</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>dropped frames: {count}</source>
        <translation>verworfene Bilder: {count}</translation>
    </message>
    <message>
        <source>lost samples: {count}</source>
        <translation>verlorene Messwerte: {count}</translation>
    </message>
    <message>
        <source>marks: {count}</source>
        <translation>Marken: {count}</translation>
    </message>
    <message>
        <source>residual of the sensor&apos;s clock: {ms} ms</source>
        <translation>Rest der Uhr des Sensors: {ms} ms</translation>
    </message>
    <message>
        <source>No motion was recorded; the import can suggest some from the frames.</source>
        <translation>Es wurde keine Bewegung aufgezeichnet; der Import kann eine aus den Bildern vorschlagen.</translation>
    </message>
    <message>
        <source>No three taps were found: the clocks decide.</source>
        <translation>Kein dreimaliges Klopfen gefunden: Es gelten die Uhren.</translation>
    </message>
    <message>
        <source>Taps found: {count}. By them the clocks are {ms} ms apart, which the import corrects.</source>
        <translation>Klopfzeichen gefunden: {count}. Nach ihnen weichen die Uhren um {ms} ms ab; der Import berichtigt das.</translation>
    </message>
</context>
<context>
    <name>TextList</name>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Buttons and messages</source>
        <translation>Schaltflächen und Meldungen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>{code} stands for the participant&apos;s code, {minutes} for the expected duration, {trials} and {feedbacks} for their numbers, {feel} for the label of the button that plays the demonstration.</source>
        <translation>{code} steht für den Code der Person, {minutes} für die erwartete Dauer, {trials} und {feedbacks} für deren Anzahl, {feel} für die Beschriftung der Schaltfläche, die die Vorführung spielt.</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>{title}: {text}</source>
        <translation>{title}: {text}</translation>
    </message>
</context>
<context>
    <name>ThemeMenus</name>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Wie das System</translation>
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
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Feedback</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Fullscreen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Playback speed (Backspace: normal speed)</source>
        <translation>Wiedergabegeschwindigkeit (Rücktaste: normal)</translation>
    </message>
    <message>
        <source>Position in the clip: click or drag. The strip below shows how strong the force is: the brighter, the stronger</source>
        <translation>Stelle im Clip: klicken oder ziehen. Der Streifen darunter zeigt, wie stark die Kraft ist: je heller, desto stärker</translation>
    </message>
    <message>
        <source>Force track to play</source>
        <translation>Kraftspur zum Clip</translation>
    </message>
    <message>
        <source>Haptic device</source>
        <translation>Haptisches Gerät</translation>
    </message>
    <message>
        <source>Fullscreen (F)</source>
        <translation>Vollbild (F)</translation>
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
        <translation>Pause</translation>
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
        <source>The force was stopped: re-arm it (Ctrl+R)</source>
        <translation>Die Kraft wurde abgeschaltet: wieder zulassen (Strg+R)</translation>
    </message>
    <message>
        <source>Stop the force immediately and pause (Esc)</source>
        <translation>Kraft sofort abschalten und anhalten (Esc)</translation>
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
    <name>Unsaved</name>
    <message>
        <source>Changes from {moment} were not saved.</source>
        <translation>Änderungen vom {moment} wurden nicht gespeichert.</translation>
    </message>
    <message>
        <source>Changes from {moment} were not saved; the effects were changed since.</source>
        <translation>Änderungen vom {moment} wurden nicht gespeichert; die Effekte wurden seitdem geändert.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
</context>
<context>
    <name>VideoQuestion</name>
    <message>
        <source>Another video</source>
        <translation>Ein anderes Video</translation>
    </message>
    <message>
        <source>What is felt may not be what is seen. Feel the force anyway?</source>
        <translation>Was zu spüren ist, passt vielleicht nicht zu dem, was zu sehen ist. Die Kraft trotzdem spüren?</translation>
    </message>
    <message>
        <source>&amp;Feel the force</source>
        <translation>&amp;Kraft spüren</translation>
    </message>
    <message>
        <source>Play &amp;without</source>
        <translation>&amp;Ohne Kraft</translation>
    </message>
</context>
<context>
    <name>VideoSurface</name>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
</context>
<context>
    <name>Viewing</name>
    <message>
        <source>A&amp;udio track</source>
        <translation>To&amp;nspur</translation>
    </message>
    <message>
        <source>Subt&amp;itles</source>
        <translation>&amp;Untertitel</translation>
    </message>
    <message>
        <source>&amp;Aspect ratio</source>
        <translation>S&amp;eitenverhältnis</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Wie aufgenommen</translation>
    </message>
    <message>
        <source>Zoom {x:.0f}&#xa0;%</source>
        <translation>Zoom {x:.0f}&#xa0;%</translation>
    </message>
    <message>
        <source>Aspect ratio: {shape}</source>
        <translation>Seitenverhältnis: {shape}</translation>
    </message>
    <message>
        <source>No sound in this clip</source>
        <translation>Kein Ton in diesem Clip</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>No subtitles in this clip</source>
        <translation>Keine Untertitel in diesem Clip</translation>
    </message>
    <message>
        <source>Track {n}</source>
        <translation>Spur {n}</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Gespeichert: {name}</translation>
    </message>
</context>
<context>
    <name>_LargePage</name>
    <message>
        <source>Close the preview (Esc)</source>
        <translation>Vorschau schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>_Picture</name>
    <message>
        <source>The page as the participant sees it</source>
        <translation>Die Seite, wie die Person sie sieht</translation>
    </message>
</context>
<context>
    <name>_Place</name>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
</context>
<context>
    <name>engine</name>
    <message>
        <source> ({words})</source>
        <translation> ({words})</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source> and no </source>
        <translation> und kein </translation>
    </message>
    <message>
        <source> and {count} damaged lines</source>
        <translation> und {count} beschädigte Zeilen</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>, or </source>
        <translation>, oder </translation>
    </message>
    <message>
        <source>, others {known} s</source>
        <translation>, andere {known} s</translation>
    </message>
    <message>
        <source>, {norm:.2f} m/s2 at rest</source>
        <translation>, {norm:.2f} m/s2 in Ruhe</translation>
    </message>
    <message>
        <source>1 g = {counts:.0f} and 2000 deg/s</source>
        <translation>1 g = {counts:.0f} und 2000 °/s</translation>
    </message>
    <message>
        <source>1 damaged line was skipped (line {line})</source>
        <translation>1 Zeile ist beschädigt und wurde weggelassen (die erste: Zeile {line})</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>die Verbindung ist abgebrochen</translation>
    </message>
    <message>
        <source>CSV for Excel (UTF-8 with a byte order mark)</source>
        <translation>CSV für Excel (UTF-8 mit Byte-Reihenfolge-Marke)</translation>
    </message>
    <message>
        <source>CSV log</source>
        <translation>CSV-Protokoll</translation>
    </message>
    <message>
        <source>CSV with chosen columns</source>
        <translation>CSV mit gewählten Spalten</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>der Arbeitsspeicher reicht nicht</translation>
    </message>
    <message>
        <source>Connect its USB cable and its power supply. The settings choose another axis, or reverse the direction.</source>
        <translation>Schließen Sie USB-Kabel und Netzteil an. Die Einstellungen wählen eine andere Achse oder kehren die Richtung um.</translation>
    </message>
    <message>
        <source>Connect the amplifier of the shakers to the sound output. By default channels 1 and 2 play; the settings choose others.</source>
        <translation>Schließen Sie den Verstärker der Shaker an den Tonausgang an. Ohne Angabe spielen die Kanäle 1 und 2; die Einstellungen wählen andere.</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>es kam keine Antwort in der Zeit</translation>
    </message>
    <message>
        <source>Consistency of force and video</source>
        <translation>Übereinstimmung von Kraft und Video</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>das Gerät ist belegt</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>das Kontingent der Platte ist erschöpft</translation>
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
        <source>File exists</source>
        <translation>die Datei existiert schon</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>der Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>die Datei ist zu groß</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>GPMF track</source>
        <translation>GPMF-Spur</translation>
    </message>
    <message>
        <source>Gyroflow gcsv</source>
        <translation>Gyroflow-gcsv</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>ungültige Angabe</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>LSL streams cannot be kept on this machine ({reason})</source>
        <translation>LSL-Ströme können auf diesem Rechner nicht gehalten werden ({reason})</translation>
    </message>
    <message>
        <source>LSL streams cannot be opened ({reason})</source>
        <translation>LSL-Ströme können nicht geöffnet werden ({reason})</translation>
    </message>
    <message>
        <source>LSL streams need pylsl 1.18 or newer with its library</source>
        <translation>LSL-Ströme brauchen pylsl 1.18 oder neuer mit seiner Bibliothek</translation>
    </message>
    <message>
        <source>MARS logger</source>
        <translation>MARS logger</translation>
    </message>
    <message>
        <source>Motion-rig software: receives the motion of the recording over UDP, as from a game.</source>
        <translation>Software einer Bewegungsplattform: Sie bekommt die Bewegung der Aufnahme per UDP, wie von einem Spiel.</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf der Platte</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>kein solches Gerät</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>es ist kein Ordner</translation>
    </message>
    <message>
        <source>Nothing moves but the picture.</source>
        <translation>Nur das Bild bewegt sich.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>Operation not supported</source>
        <translation>Vorgang nicht unterstützt</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Quality of experience</source>
        <translation>Erlebnisqualität</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Razor, raw output</source>
        <translation>Razor, Rohausgabe</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>die Platte ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Realistic</source>
        <translation>Realistisch</translation>
    </message>
    <message>
        <source>Recorded force and controls</source>
        <translation>Aufgezeichnete Kraft und Kontrollen</translation>
    </message>
    <message>
        <source>Sensor Logger ({system})</source>
        <translation>Sensor Logger ({system})</translation>
    </message>
    <message>
        <source>Silence</source>
        <translation>Stille</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>Tap marks</source>
        <translation>Klopfzeichen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The compass is ignored: the file does not declare its axes.</source>
        <translation>Der Kompass wird weggelassen: Die Datei sagt nicht, welche Achsen er hat.</translation>
    </message>
    <message>
        <source>The compass is ignored: {what}.</source>
        <translation>Der Kompass wird weggelassen: {what}.</translation>
    </message>
    <message>
        <source>The file does not declare the sensor axes of {camera!r}: those of a HERO5 are assumed.</source>
        <translation>Die Datei sagt nicht, wie der Sensor in {camera!r} sitzt: Es werden die Achsen einer HERO5 angenommen.</translation>
    </message>
    <message>
        <source>The log has {count}, the longest of {length_s:.2f} s at {at_s:.2f} s.</source>
        <translation>Das Protokoll hat {count}, die längste von {length_s:.2f} s bei {at_s:.2f} s.</translation>
    </message>
    <message>
        <source>The motion&apos;s timestamps are {lag_ms:+.1f} ms (± {sigma_ms:.2f} ms) off the frames, measured from the camera&apos;s own orientation at each frame (CORI); this is corrected.</source>
        <translation>Die Zeitstempel der Bewegung weichen um {lag_ms:+.1f} ms (± {sigma_ms:.2f} ms) von den Bildern ab, gemessen an der Ausrichtung, die die Kamera zu jedem Bild speichert (CORI); das ist korrigiert.</translation>
    </message>
    <message>
        <source>The protocol of Danieau et al. (2012): each clip with the recorded force, without force and with a random one; four questions after each.</source>
        <translation>Der Versuch von Danieau et al. (2012): jeder Clip mit der aufgezeichneten Kraft, ohne Kraft und mit einer zufälligen; vier Fragen nach jedem.</translation>
    </message>
    <message>
        <source>The recorded force earlier or later than the video; after each clip, whether both went together.</source>
        <translation>Die aufgezeichnete Kraft früher oder später als das Video; nach jedem Clip die Frage, ob beide zusammenpassten.</translation>
    </message>
    <message>
        <source>The same questions; the recorded force beside no force, the force of another clip, and the recorded force half a second late.</source>
        <translation>Dieselben Fragen; die aufgezeichnete Kraft neben keiner Kraft, der Kraft eines anderen Clips und der um eine halbe Sekunde verspäteten.</translation>
    </message>
    <message>
        <source>This camera does not timestamp its samples: they are {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) off the frames, measured from the rotation in the frames; this is corrected.</source>
        <translation>Diese Kamera stempelt ihre Messwerte nicht: Sie weichen um {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) von den Bildern ab, gemessen an der Drehung in den Bildern; das ist korrigiert.</translation>
    </message>
    <message>
        <source>This camera does not timestamp its samples: they may be 10 to 30 ms off.</source>
        <translation>Diese Kamera stempelt ihre Werte nicht: Sie können 10 bis 30 ms neben dem Bild liegen.</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>zu viele symbolische Verknüpfungen</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Ultimate IMU, stock firmware</source>
        <translation>Ultimate IMU, Firmware des Herstellers</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja oder nein</translation>
    </message>
    <message>
        <source>`study status` lists them</source>
        <translation>`study status` zählt sie auf</translation>
    </message>
    <message>
        <source>a GoPro&apos;s telemetry is read without it, and is damaged</source>
        <translation>die Telemetrie einer GoPro wird ohne ihn gelesen, und sie ist beschädigt</translation>
    </message>
    <message>
        <source>a block of {count} words at {address:X} fits nowhere</source>
        <translation>ein Block von {count} Wörtern bei {address:X} passt nirgends hin</translation>
    </message>
    <message>
        <source>a clip cannot be copied onto itself</source>
        <translation>ein Clip kann nicht auf sich selbst kopiert werden</translation>
    </message>
    <message>
        <source>a code has {length} letters, as `study status` lists them</source>
        <translation>ein Code hat {length} Buchstaben, wie `study status` sie aufzählt</translation>
    </message>
    <message>
        <source>a cutoff of {cutoff_hz:g} Hz is not below half the rate of the samples, {half_rate_hz:.4g} Hz</source>
        <translation>eine Grenzfrequenz von {cutoff_hz:g} Hz liegt nicht unter der halben Rate der Werte, {half_rate_hz:.4g} Hz</translation>
    </message>
    <message>
        <source>a device is left out: {reason}</source>
        <translation>ein Gerät wird weggelassen: {reason}</translation>
    </message>
    <message>
        <source>a direction of length 0 was taken as x {x:.2f}, y {y:.2f}, z {z:.2f}</source>
        <translation>eine Richtung der Länge 0 gilt als x {x:.2f}, y {y:.2f}, z {z:.2f}</translation>
    </message>
    <message>
        <source>a duration of {length_s:g} s; give one from 1 to {longest_s:g} s</source>
        <translation>eine Dauer von {length_s:g} s; 1 bis {longest_s:g} s angeben</translation>
    </message>
    <message>
        <source>a force that is not a number was commanded, a defect of this program; please report it, and choose the device again</source>
        <translation>es wurde eine Kraft verlangt, die keine Zahl ist, ein Fehler dieses Programms; bitte melden Sie ihn und wählen Sie das Gerät noch einmal</translation>
    </message>
    <message>
        <source>a force track needs at least one row</source>
        <translation>eine Kraftspur braucht mindestens eine Zeile</translation>
    </message>
    <message>
        <source>a latency of {value:g} s is not between 0 and 1 s</source>
        <translation>eine Latenz von {value:g} s liegt nicht zwischen 0 und 1 s</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a part of it was recorded faster (Super Slow-mo)</source>
        <translation>ein Teil davon wurde schneller aufgenommen (Super Slow-mo)</translation>
    </message>
    <message>
        <source>a sensor of {rate_hz:g} Hz averaged to {log_hz:g} Hz; give rates above 0, the second not above the first</source>
        <translation>ein Sensor mit {rate_hz:g} Hz, gemittelt auf {log_hz:g} Hz; Raten über 0 angeben, die zweite nicht über der ersten</translation>
    </message>
    <message>
        <source>a session has one plan</source>
        <translation>eine Sitzung hat nur einen Plan</translation>
    </message>
    <message>
        <source>a sound of {rate_hz} Hz is too coarse; give 8000 or more</source>
        <translation>ein Ton mit {rate_hz} Hz ist zu grob; geben Sie 8000 oder mehr an</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a time constant is for the method smoother, not for {method}</source>
        <translation>eine Zeitkonstante gibt es nur für das Verfahren smoother, nicht für {method}</translation>
    </message>
    <message>
        <source>a title must have 1 to {most} characters</source>
        <translation>ein Titel hat 1 bis {most} Zeichen</translation>
    </message>
    <message>
        <source>about {count} samples were never recorded; the longest gap is {longest_s:.3g} s; nothing was put in their place</source>
        <translation>etwa {count} Werte wurden nie aufgezeichnet; die längste Lücke ist {longest_s:.3g} s; an ihre Stelle wurde nichts gesetzt</translation>
    </message>
    <message>
        <source>accel-sign=+ if the recorder was that way up</source>
        <translation>accel-sign=+, wenn der Rekorder so herum war</translation>
    </message>
    <message>
        <source>accel-sign=-, or correct the sign in the log</source>
        <translation>accel-sign=-, oder berichtigen Sie das Vorzeichen im Protokoll</translation>
    </message>
    <message>
        <source>accelerometer</source>
        <translation>Beschleunigungssensor</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>fügen Sie ihn hinzu</translation>
    </message>
    <message>
        <source>add orders.csv</source>
        <translation>fügen Sie orders.csv hinzu</translation>
    </message>
    <message>
        <source>after record {number}</source>
        <translation>nach Eintrag {number}</translation>
    </message>
    <message>
        <source>all samples are the same, so the sensor was stuck</source>
        <translation>alle Werte sind gleich, der Sensor hing also fest</translation>
    </message>
    <message>
        <source>all samples are the same: was the sensor stuck?</source>
        <translation>alle Werte sind gleich: Hing der Sensor fest?</translation>
    </message>
    <message>
        <source>already exists</source>
        <translation>existiert schon</translation>
    </message>
    <message>
        <source>an effect of {share:g} times the paper&apos;s leaves the scale of {low} to {high}; choose a smaller one</source>
        <translation>ein Effekt vom {share:g}-fachen der Veröffentlichung verlässt die Skala von {low} bis {high}; wählen Sie einen kleineren</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an unknown logger</source>
        <translation>ein unbekannter Logger</translation>
    </message>
    <message>
        <source>angular rate in {unit}</source>
        <translation>Drehrate in {unit}</translation>
    </message>
    <message>
        <source>another record has this number</source>
        <translation>ein anderer Eintrag hat diese Nummer</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>applied as given: {answers}</source>
        <translation>wie angegeben angewendet: {answers}</translation>
    </message>
    <message>
        <source>as its own times place it</source>
        <translation>nach ihren eigenen Zeiten</translation>
    </message>
    <message>
        <source>as stored, orientation {orientation}</source>
        <translation>wie gespeichert, Ausrichtung {orientation}</translation>
    </message>
    <message>
        <source>as telemetry-parser gives them</source>
        <translation>wie telemetry-parser sie liefert</translation>
    </message>
    <message>
        <source>as the camera&apos;s stamps begin</source>
        <translation>nach dem Beginn der Zeitstempel der Kamera</translation>
    </message>
    <message>
        <source>as the edit list cuts the video</source>
        <translation>wie die Schnittliste das Video schneidet</translation>
    </message>
    <message>
        <source>ask for a file that was packed with it</source>
        <translation>verlangen Sie eine Datei, die damit gepackt wurde</translation>
    </message>
    <message>
        <source>ask for the file again, or accept it</source>
        <translation>verlangen Sie die Datei noch einmal, oder lassen Sie sie zu</translation>
    </message>
    <message>
        <source>ask for the file again, or agree</source>
        <translation>verlangen Sie die Datei noch einmal, oder stimmen Sie zu</translation>
    </message>
    <message>
        <source>at the beginning</source>
        <translation>am Anfang</translation>
    </message>
    <message>
        <source>at times nothing was played: {cause}; {remedy}</source>
        <translation>zeitweise wurde nichts gespielt: {cause}; {remedy}</translation>
    </message>
    <message>
        <source>averaged from {rate_hz:.1f} to {average_hz:g} Hz</source>
        <translation>gemittelt von {rate_hz:.1f} auf {average_hz:g} Hz</translation>
    </message>
    <message>
        <source>axes=RIGHT,FRONT,UP in its axes, such as axes=x,-z,y</source>
        <translation>axes=RECHTS,VORN,OBEN in ihren Achsen, etwa axes=x,-z,y</translation>
    </message>
    <message>
        <source>axes={axes} are not three axes; give right, front and up in the axes of the log, for example axes=x,-z,y</source>
        <translation>axes={axes} sind keine drei Achsen; geben Sie rechts, vorn und oben in den Achsen des Protokolls an, etwa axes=x,-z,y</translation>
    </message>
    <message>
        <source>axes={axes} mirror the log; change one sign: right, front and up have to follow the right hand</source>
        <translation>axes={axes} spiegeln das Protokoll; drehen Sie ein Vorzeichen um, denn rechts, vorn und oben müssen der rechten Hand folgen</translation>
    </message>
    <message>
        <source>axes={axes}, or the axes that were right, front, up</source>
        <translation>axes={axes}, oder was sonst rechts, vorn, oben war</translation>
    </message>
    <message>
        <source>axis without an id</source>
        <translation>Achse ohne ID</translation>
    </message>
    <message>
        <source>begin the file with {header}</source>
        <translation>beginnen Sie die Datei mit {header}</translation>
    </message>
    <message>
        <source>begins without a header</source>
        <translation>beginnt ohne Kopf</translation>
    </message>
    <message>
        <source>belongs to the clip {found!r}, not to {expected!r}</source>
        <translation>gehört zum Clip {found!r}, nicht zu {expected!r}</translation>
    </message>
    <message>
        <source>bring the streams to common times by interpolation first</source>
        <translation>bringen Sie die Ströme zuerst durch Interpolation auf gemeinsame Zeiten</translation>
    </message>
    <message>
        <source>by the frames of the clip the mounting is {axes}, by gravity it is the other way up, so that the accelerometer has the other sign</source>
        <translation>nach den Bildern des Clips ist die Befestigung {axes}, nach der Schwerkraft steht sie auf dem Kopf; der Beschleunigungssensor hat also das andere Vorzeichen</translation>
    </message>
    <message>
        <source>byte {number}</source>
        <translation>Byte {number}</translation>
    </message>
    <message>
        <source>bytes {begin} to {end} (line {line}, {after}) are damaged</source>
        <translation>die Bytes {begin} bis {end} (Zeile {line}, {after}) sind beschädigt</translation>
    </message>
    <message>
        <source>call the experimenter</source>
        <translation>rufen Sie die Versuchsleitung</translation>
    </message>
    <message>
        <source>cancelled; nothing was written</source>
        <translation>abgebrochen; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>cannot be copied ({reason})</source>
        <translation>kann nicht kopiert werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be decoded ({reason})</source>
        <translation>kann nicht dekodiert werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be listed ({reason})</source>
        <translation>kann nicht aufgelistet werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be positioned</source>
        <translation>kann nicht positioniert werden</translation>
    </message>
    <message>
        <source>cannot be reached ({reason})</source>
        <translation>kann nicht erreicht werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be read ({reason})</source>
        <translation>kann nicht gelesen werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be started ({reason})</source>
        <translation>kann nicht gestartet werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>carry the time of their packet and were spread evenly</source>
        <translation>tragen die Zeit ihres Pakets und wurden gleichmäßig verteilt</translation>
    </message>
    <message>
        <source>change the rights of the file</source>
        <translation>ändern Sie die Rechte der Datei</translation>
    </message>
    <message>
        <source>changes of the frequency within a second</source>
        <translation>Änderungen der Frequenz innerhalb einer Sekunde</translation>
    </message>
    <message>
        <source>check the name and the folder</source>
        <translation>prüfen Sie Namen und Ordner</translation>
    </message>
    <message>
        <source>check the name and the rights of its folder</source>
        <translation>prüfen Sie den Namen und die Rechte des Ordners</translation>
    </message>
    <message>
        <source>check the rights of the folder</source>
        <translation>prüfen Sie die Rechte des Ordners</translation>
    </message>
    <message>
        <source>choose a clip with sound</source>
        <translation>wählen Sie einen Clip mit Ton</translation>
    </message>
    <message>
        <source>choose a device first</source>
        <translation>wählen Sie zuerst ein Gerät</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>choose a file that was exported by it</source>
        <translation>wählen Sie eine Datei, die es exportiert hat</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>choose another log</source>
        <translation>wählen Sie ein anderes Protokoll</translation>
    </message>
    <message>
        <source>choose another {kind}</source>
        <translation>wählen Sie etwas anderes ({kind})</translation>
    </message>
    <message>
        <source>choose one of {known}</source>
        <translation>wählen Sie eines von {known}</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>schließen Sie es zuerst dort</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>convert it to a smaller size</source>
        <translation>wandeln Sie es in eine kleinere Größe um</translation>
    </message>
    <message>
        <source>convert it with &apos;hapticplayer export&apos;</source>
        <translation>wandeln Sie es mit &apos;hapticplayer export&apos; um</translation>
    </message>
    <message>
        <source>convert its sound to stereo at 48 kHz</source>
        <translation>wandeln Sie den Ton in Stereo mit 48 kHz um</translation>
    </message>
    <message>
        <source>copy it again</source>
        <translation>kopieren Sie es noch einmal</translation>
    </message>
    <message>
        <source>copy it again from the camera, or choose another file</source>
        <translation>kopieren Sie es noch einmal von der Kamera, oder wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>copy it again from the recorder</source>
        <translation>kopieren Sie es noch einmal vom Rekorder</translation>
    </message>
    <message>
        <source>copy it again, convert it to MP4 (H.264 and AAC), or choose another file</source>
        <translation>kopieren Sie es noch einmal, wandeln Sie es in MP4 (H.264 und AAC) um, oder wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>copy the recording again from the camera</source>
        <translation>kopieren Sie die Aufnahme noch einmal von der Kamera</translation>
    </message>
    <message>
        <source>copy the sequence again or import it again</source>
        <translation>kopieren oder importieren Sie die Sequenz noch einmal</translation>
    </message>
    <message>
        <source>copy the session again</source>
        <translation>kopieren Sie die Sitzung noch einmal</translation>
    </message>
    <message>
        <source>copy the study&apos;s folder to the other machine, then run it there</source>
        <translation>kopieren Sie den Ordner der Studie auf den anderen Rechner, und führen Sie sie dort durch</translation>
    </message>
    <message>
        <source>correct it</source>
        <translation>berichtigen Sie es</translation>
    </message>
    <message>
        <source>could be {formats}</source>
        <translation>könnte {formats} sein</translation>
    </message>
    <message>
        <source>counts of {unit:.4g}</source>
        <translation>Zählwerten von {unit:.4g}</translation>
    </message>
    <message>
        <source>cut it into parts</source>
        <translation>teilen Sie sie in Stücke</translation>
    </message>
    <message>
        <source>cut the log into parts</source>
        <translation>teilen Sie das Protokoll in Stücke</translation>
    </message>
    <message>
        <source>cut the recording there and give the parts one by one</source>
        <translation>schneiden Sie die Aufnahme dort, und geben Sie die Stücke einzeln an</translation>
    </message>
    <message>
        <source>damaged places: {places}, with {ticks} ticks</source>
        <translation>beschädigte Stellen: {places}, mit {ticks} Takten</translation>
    </message>
    <message>
        <source>faults can only be injected into a simulated device that was opened for it</source>
        <translation>Fehler lassen sich nur bei einem simulierten Gerät einspielen, das dafür geöffnet wurde</translation>
    </message>
    <message>
        <source>force, lossless</source>
        <translation>Kraft, verlustfrei</translation>
    </message>
    <message>
        <source>has an invalid header</source>
        <translation>hat einen ungültigen Kopf</translation>
    </message>
    <message>
        <source>has an invalid header: {reason}</source>
        <translation>hat einen ungültigen Kopf: {reason}</translation>
    </message>
    <message>
        <source>has no such subtitles</source>
        <translation>hat keine solchen Untertitel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>if it is not in seconds, multiply {scale} by {per_s:.0f}; else average to {most_hz:g} samples a second</source>
        <translation>ist das nicht in Sekunden, multiplizieren Sie {scale} mit {per_s:.0f}; sonst mitteln Sie auf {most_hz:g} Werte je Sekunde</translation>
    </message>
    <message>
        <source>is damaged in its header</source>
        <translation>ist im Kopf beschädigt</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is not a recording of a haptic loop</source>
        <translation>ist keine Aufzeichnung einer haptischen Schleife</translation>
    </message>
    <message>
        <source>is not the description of a sequence</source>
        <translation>beschreibt keine Sequenz</translation>
    </message>
    <message>
        <source>device {name!r}: this version has no driver for it; use {known}</source>
        <translation>Gerät {name!r}: Diese Version hat keinen Treiber dafür; nehmen Sie {known}</translation>
    </message>
    <message>
        <source>does not declare iOS or Android, whose accelerations have opposite signs</source>
        <translation>sagt nicht, ob es von iOS oder Android kommt, deren Beschleunigungen entgegengesetzte Vorzeichen haben</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>every sequence needs its track {name!r}</source>
        <translation>jede Sequenz hat die Spur {name!r}; sie bleibt</translation>
    </message>
    <message>
        <source>export the acceleration with gravity, and the gyroscope</source>
        <translation>exportieren Sie die Beschleunigung mit Schwerkraft, und das Gyroskop</translation>
    </message>
    <message>
        <source>export the log again</source>
        <translation>exportieren Sie das Protokoll noch einmal</translation>
    </message>
    <message>
        <source>export the log again or choose another one</source>
        <translation>exportieren Sie das Protokoll noch einmal, oder wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>export the log as comma-separated text</source>
        <translation>exportieren Sie das Protokoll als Text, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>export the recording again</source>
        <translation>exportieren Sie die Aufnahme noch einmal</translation>
    </message>
    <message>
        <source>export the recording as CSV</source>
        <translation>exportieren Sie die Aufnahme als CSV</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>field_dip_rad must lie within a right angle, got {field_dip_rad}</source>
        <translation>field_dip_rad muss innerhalb eines rechten Winkels liegen, ist {field_dip_rad}</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>has {rows} rows of {columns} numbers{more}</source>
        <translation>hat {rows} Zeilen mit {columns} Zahlen{more}</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>feste</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>force, rate and field must have as many samples</source>
        <translation>Kraft, Drehrate und Feld müssen gleich viele Abtastwerte haben</translation>
    </message>
    <message>
        <source>accel-sign must be + or -</source>
        <translation>accel-sign ist + oder -</translation>
    </message>
    <message>
        <source>accel-sign=- if its accelerometer reads -1 g upwards</source>
        <translation>accel-sign=-, wenn der Beschleunigungssensor nach oben -1 g zeigt</translation>
    </message>
    <message>
        <source>accel-unit={fitting:.6g} to scale it to gravity</source>
        <translation>accel-unit={fitting:.6g}, um auf die Schwerkraft zu skalieren</translation>
    </message>
    <message>
        <source>format=csv and columns=time,ax,ay,az,gx,gy,gz (- for others)</source>
        <translation>format=csv und columns=time,ax,ay,az,gx,gy,gz (- für andere)</translation>
    </message>
    <message>
        <source>free some memory and disk, and try again</source>
        <translation>machen Sie etwas Arbeitsspeicher und Plattenplatz frei, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>free some space or copy the sequence to a folder of your own</source>
        <translation>machen Sie Platz frei, oder kopieren Sie die Sequenz in einen eigenen Ordner</translation>
    </message>
    <message>
        <source>from {lowest_hz:.1f} to {highest_hz:.1f} Hz</source>
        <translation>von {lowest_hz:.1f} bis {highest_hz:.1f} Hz</translation>
    </message>
    <message>
        <source>from {place} on all rows carry the same time</source>
        <translation>ab {place} tragen alle Zeilen dieselbe Zeit</translation>
    </message>
    <message>
        <source>gcsv of {logger}</source>
        <translation>gcsv von {logger}</translation>
    </message>
    <message>
        <source>give a frequency in Hz</source>
        <translation>geben Sie eine Frequenz in Hz an</translation>
    </message>
    <message>
        <source>give a higher rate or a longer recording</source>
        <translation>geben Sie eine höhere Rate oder eine längere Aufnahme an</translation>
    </message>
    <message>
        <source>give a lower cutoff, or leave the low-pass out</source>
        <translation>geben Sie eine niedrigere Grenzfrequenz an, oder lassen Sie den Tiefpass weg</translation>
    </message>
    <message>
        <source>give a lower rate; samples can be merged, not made up</source>
        <translation>geben Sie eine niedrigere Rate an; Werte lassen sich zusammenfassen, nicht erfinden</translation>
    </message>
    <message>
        <source>give a rate in Hz, such as 30</source>
        <translation>geben Sie eine Rate in Hz an, etwa 30</translation>
    </message>
    <message>
        <source>give a recording of a sensor that worked</source>
        <translation>geben Sie eine Aufnahme von einem Sensor an, der funktioniert hat</translation>
    </message>
    <message>
        <source>give a recording of at least a few seconds</source>
        <translation>geben Sie eine Aufnahme von mindestens einigen Sekunden an</translation>
    </message>
    <message>
        <source>give a recording with at least two samples</source>
        <translation>geben Sie eine Aufnahme mit mindestens zwei Werten an</translation>
    </message>
    <message>
        <source>give at least {least_hz:g} samples a second</source>
        <translation>geben Sie mindestens {least_hz:g} Werte je Sekunde an</translation>
    </message>
    <message>
        <source>give the angular rate in rad/s</source>
        <translation>geben Sie die Drehrate in rad/s an</translation>
    </message>
    <message>
        <source>restore the original file names</source>
        <translation>geben Sie den Dateien die Namen, mit denen sie aufgenommen wurden</translation>
    </message>
    <message>
        <source>give the folder of a sequence</source>
        <translation>geben Sie den Ordner einer Sequenz an</translation>
    </message>
    <message>
        <source>give the folder of a sequence, or a video</source>
        <translation>geben Sie den Ordner einer Sequenz oder ein Video an</translation>
    </message>
    <message>
        <source>give the folder of a study</source>
        <translation>geben Sie den Ordner einer Studie an</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>geben Sie den Ordner einer einzigen Aufnahme an</translation>
    </message>
    <message>
        <source>give the folder of the sequence</source>
        <translation>geben Sie den Ordner der Sequenz an</translation>
    </message>
    <message>
        <source>give the folder or zip that the logger has written, or a sequence</source>
        <translation>geben Sie den Ordner oder das Zip an, das der Logger geschrieben hat, oder eine Sequenz</translation>
    </message>
    <message>
        <source>give the folder with the files of all sensors</source>
        <translation>geben Sie den Ordner mit den Dateien aller Sensoren an</translation>
    </message>
    <message>
        <source>give the forces in newton</source>
        <translation>geben Sie die Kräfte in Newton an</translation>
    </message>
    <message>
        <source>give the specific force in m/s2, about 9.8 at rest</source>
        <translation>geben Sie die spezifische Kraft in m/s2 an, etwa 9.8 in Ruhe</translation>
    </message>
    <message>
        <source>give the specific force in m/s^2, about 9.8 at rest</source>
        <translation>geben Sie die spezifische Kraft in m/s^2 an, etwa 9.8 in Ruhe</translation>
    </message>
    <message>
        <source>give the time of each sample in seconds</source>
        <translation>geben Sie die Zeit jedes Werts in Sekunden an</translation>
    </message>
    <message>
        <source>give the whole folder or zip, recorded with the gyroscope</source>
        <translation>geben Sie den ganzen Ordner oder das Zip an, aufgenommen mit dem Gyroskop</translation>
    </message>
    <message>
        <source>give the whole zip, recorded with accelerometer and gyroscope</source>
        <translation>geben Sie das ganze Zip an, aufgenommen mit Beschleunigungssensor und Gyroskop</translation>
    </message>
    <message>
        <source>give their times in seconds</source>
        <translation>geben Sie ihre Zeiten in Sekunden an</translation>
    </message>
    <message>
        <source>give three axes for each time</source>
        <translation>geben Sie drei Achsen für jede Zeit an</translation>
    </message>
    <message>
        <source>give times in seconds of the clip</source>
        <translation>geben Sie Zeiten in Sekunden des Clips an</translation>
    </message>
    <message>
        <source>the accelerometer reads {norm:.2f} m/s2 at rest instead of 9.81</source>
        <translation>der Beschleunigungssensor zeigt in Ruhe {norm:.2f} m/s2 statt 9,81</translation>
    </message>
    <message>
        <source>gravity shows that {sign}{axis} of the recorder was up, not its z</source>
        <translation>nach der Schwerkraft war {sign}{axis} des Rekorders oben, nicht sein z</translation>
    </message>
    <message>
        <source>, or {sign}</source>
        <translation>, oder {sign}</translation>
    </message>
    <message>
        <source>choose a folder with write permission</source>
        <translation>wählen Sie einen Ordner, in den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>choose a folder; a part of this path is a file or a dead link</source>
        <translation>wählen Sie einen Ordner; ein Teil dieses Pfads ist eine Datei oder ein toter Verweis</translation>
    </message>
    <message>
        <source>choose a playback log</source>
        <translation>wählen Sie ein Wiedergabeprotokoll</translation>
    </message>
    <message>
        <source>choose a refresh rate of 30 Hz or more</source>
        <translation>wählen Sie eine Bildwiederholrate von 30 Hz oder mehr</translation>
    </message>
    <message>
        <source>choose a shorter name</source>
        <translation>wählen Sie einen kürzeren Namen</translation>
    </message>
    <message>
        <source>choose another file, or replace it</source>
        <translation>wählen Sie eine andere Datei, oder ersetzen Sie sie</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>wählen Sie eine andere</translation>
    </message>
    <message>
        <source>choose another place; the report was printed</source>
        <translation>wählen Sie einen anderen Ort; der Bericht wurde ausgegeben</translation>
    </message>
    <message>
        <source>choose its folder</source>
        <translation>wählen Sie ihren Ordner</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>wählen Sie eine</translation>
    </message>
    <message>
        <source>choose the mounting: right, front and up of the wearer</source>
        <translation>wählen Sie die Befestigung: rechts, vorn und oben der Person</translation>
    </message>
    <message>
        <source>close other programs, or give pings more time in Intiface</source>
        <translation>schließen Sie andere Programme, oder lassen Sie Pings in Intiface mehr Zeit</translation>
    </message>
    <message>
        <source>compare sound and motion by eye, then enter the offset</source>
        <translation>vergleichen Sie Ton und Bewegung mit dem Auge, und geben Sie dann den Versatz ein</translation>
    </message>
    <message>
        <source>each tick of the device</source>
        <translation>jeder Takt des Geräts</translation>
    </message>
    <message>
        <source>effects without a time begin at 0 s</source>
        <translation>Effekte ohne Zeit beginnen bei 0 s</translation>
    </message>
    <message>
        <source>enter another offset</source>
        <translation>geben Sie einen anderen Versatz ein</translation>
    </message>
    <message>
        <source>enter the media time at which the log&apos;s clock reads 0</source>
        <translation>geben Sie die Medienzeit ein, zu der die Uhr des Protokolls 0 zeigt</translation>
    </message>
    <message>
        <source>enter what is asked for by hand</source>
        <translation>geben Sie das Gefragte von Hand ein</translation>
    </message>
    <message>
        <source>export it again as PCM of 16, 24 or 32 bits, of up to {most} channels</source>
        <translation>exportieren Sie es noch einmal als PCM mit 16, 24 oder 32 Bit und bis zu {most} Kanälen</translation>
    </message>
    <message>
        <source>film something with detail, or use the taps</source>
        <translation>filmen Sie etwas mit Einzelheiten, oder nehmen Sie das Klopfen</translation>
    </message>
    <message>
        <source>free {need_mb} MB there</source>
        <translation>machen Sie dort {need_mb} MB frei</translation>
    </message>
    <message>
        <source>give its log, too, and {option} if asked</source>
        <translation>geben Sie auch sein Protokoll an, und {option}, wenn danach gefragt wird</translation>
    </message>
    <message>
        <source>give the log of a motion sensor, too</source>
        <translation>geben Sie auch das Protokoll eines Bewegungssensors an</translation>
    </message>
    <message>
        <source>give the log, too, or have the motion estimated from the frames</source>
        <translation>geben Sie auch das Protokoll an, oder lassen Sie die Bewegung aus den Bildern schätzen</translation>
    </message>
    <message>
        <source>gravity seems to be removed already: give the acceleration with gravity</source>
        <translation>die Schwerkraft scheint schon entfernt zu sein: Geben Sie die Beschleunigung mit Schwerkraft an</translation>
    </message>
    <message>
        <source>gravity shows that {axis} was up, not the axis that was chosen</source>
        <translation>nach der Schwerkraft war {axis} oben, nicht die gewählte Achse</translation>
    </message>
    <message>
        <source>gravity was already removed by the recorder</source>
        <translation>die Schwerkraft hatte der Rekorder schon entfernt</translation>
    </message>
    <message>
        <source>gyro</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>has an unusual format ({bits} bits in {block} bytes for {channels} channels, {rate_hz} Hz)</source>
        <translation>hat ein unübliches Format ({bits} Bit in {block} Byte für {channels} Kanäle, {rate_hz} Hz)</translation>
    </message>
    <message>
        <source>has changed since it was written (its checksum differs)</source>
        <translation>hat sich geändert, seit es geschrieben wurde (die Prüfsumme ist eine andere)</translation>
    </message>
    <message>
        <source>has more than {most} characters</source>
        <translation>hat mehr als {most} Zeichen</translation>
    </message>
    <message>
        <source>has more than {most} rows</source>
        <translation>hat mehr als {most} Zeilen</translation>
    </message>
    <message>
        <source>has no answers yet</source>
        <translation>hat noch keine Antworten</translation>
    </message>
    <message>
        <source>has no timestamps, and its firmware has no fixed rate</source>
        <translation>hat keine Zeiten, und die Firmware hat keine feste Rate</translation>
    </message>
    <message>
        <source>has the unknown name {unknown!r}</source>
        <translation>hat den unbekannten Namen {unknown!r}</translation>
    </message>
    <message>
        <source>has version {found} of the format, not {version}</source>
        <translation>hat Version {found} des Formats, nicht {version}</translation>
    </message>
    <message>
        <source>has {count} bytes instead of {expected}</source>
        <translation>hat {count} Bytes statt {expected}</translation>
    </message>
    <message>
        <source>has {count} columns, and a Razor M0 does not declare them</source>
        <translation>hat {count} Spalten, und ein Razor M0 sagt nicht, welche es sind</translation>
    </message>
    <message>
        <source>has {count} columns, the header has {expected}</source>
        <translation>hat {count} Spalten, der Kopf hat {expected}</translation>
    </message>
    <message>
        <source>has {count} telemetry payloads, too many</source>
        <translation>hat {count} Telemetrieblöcke, zu viele</translation>
    </message>
    <message>
        <source>holds Euler angles and no acceleration</source>
        <translation>enthält Eulerwinkel und keine Beschleunigung</translation>
    </message>
    <message>
        <source>holds a force of {largest_n:.3g} N, beyond any device</source>
        <translation>enthält eine Kraft von {largest_n:.3g} N, mehr als jedes Gerät kann</translation>
    </message>
    <message>
        <source>holds acceleration from which the recorder has removed gravity, so it cannot be checked or levelled</source>
        <translation>enthält Beschleunigung, aus der der Rekorder die Schwerkraft entfernt hat, sie lässt sich also weder prüfen noch ausrichten</translation>
    </message>
    <message>
        <source>holds an acceleration of {largest:.3g} m/s2, beyond any sensor</source>
        <translation>enthält eine Beschleunigung von {largest:.3g} m/s2, mehr als jeder Sensor misst</translation>
    </message>
    <message>
        <source>holds angles without angular rates, so motion cannot be computed</source>
        <translation>enthält Winkel ohne Drehraten, woraus sich keine Bewegung gewinnen lässt</translation>
    </message>
    <message>
        <source>holds counts of an unknown range (norm {norm:.4g})</source>
        <translation>enthält Zählwerte eines unbekannten Messbereichs (Betrag {norm:.4g})</translation>
    </message>
    <message>
        <source>holds more than {most} files</source>
        <translation>enthält mehr als {most} Dateien</translation>
    </message>
    <message>
        <source>holds no acceleration (only {held})</source>
        <translation>enthält keine Beschleunigung (nur {held})</translation>
    </message>
    <message>
        <source>holds no acceleration with gravity</source>
        <translation>enthält keine Beschleunigung mit Schwerkraft</translation>
    </message>
    <message>
        <source>holds no angular rate; gravity cannot be removed without it</source>
        <translation>enthält keine Drehrate, ohne die sich Schwerkraft und Bewegung nicht trennen lassen</translation>
    </message>
    <message>
        <source>holds no force</source>
        <translation>enthält keine Kraft</translation>
    </message>
    <message>
        <source>holds no gyroscope (only {held})</source>
        <translation>enthält kein Gyroskop (nur {held})</translation>
    </message>
    <message>
        <source>holds no log of a known format</source>
        <translation>enthält kein bekanntes Protokoll</translation>
    </message>
    <message>
        <source>holds no order</source>
        <translation>enthält keine Reihenfolge</translation>
    </message>
    <message>
        <source>holds no positions that are read ({first})</source>
        <translation>enthält keine Positionen, die gelesen werden ({first})</translation>
    </message>
    <message>
        <source>holds no settings of this program</source>
        <translation>enthält keine Einstellungen dieses Programms</translation>
    </message>
    <message>
        <source>holds no {missing} file</source>
        <translation>enthält keine Datei {missing}</translation>
    </message>
    <message>
        <source>holds no {name}</source>
        <translation>enthält kein {name}</translation>
    </message>
    <message>
        <source>holds several recordings ({first}, {second})</source>
        <translation>enthält mehrere Aufnahmen ({first}, {second})</translation>
    </message>
    <message>
        <source>holds {count} logs ({known})</source>
        <translation>enthält {count} Protokolle ({known})</translation>
    </message>
    <message>
        <source>holds {name!r}, a name outside the zip</source>
        <translation>enthält {name!r}, einen Namen, der aus dem Zip hinausführt</translation>
    </message>
    <message>
        <source>if it is in g, multiply it by 9.80665; if gravity was removed already, give the acceleration with gravity</source>
        <translation>wenn es in g ist, multiplizieren Sie mit 9.80665; wenn die Schwerkraft schon entfernt ist, geben Sie die Beschleunigung mit Schwerkraft an</translation>
    </message>
    <message>
        <source>import a recording, or ask for a file with its motion</source>
        <translation>importieren Sie eine Aufnahme, oder verlangen Sie eine Datei mit ihrer Bewegung</translation>
    </message>
    <message>
        <source>import it again</source>
        <translation>importieren Sie es noch einmal</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>ist ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>ist eine Pipe, keine Datei</translation>
    </message>
    <message>
        <source>is a socket, not a file</source>
        <translation>ist ein Socket, keine Datei</translation>
    </message>
    <message>
        <source>is a table of {count} columns ({shown}) without a description</source>
        <translation>ist eine Tabelle mit {count} Spalten ({shown}), die nicht sagt, was sie sind</translation>
    </message>
    <message>
        <source>is an Excel workbook</source>
        <translation>ist eine Excel-Arbeitsmappe</translation>
    </message>
    <message>
        <source>is damaged (its checksum differs)</source>
        <translation>ist beschädigt (die Prüfsumme ist eine andere)</translation>
    </message>
    <message>
        <source>is damaged ({reason})</source>
        <translation>ist beschädigt ({reason})</translation>
    </message>
    <message>
        <source>is empty (0 bytes)</source>
        <translation>ist leer (0 Bytes)</translation>
    </message>
    <message>
        <source>is larger than the limit of {most_mb} MB</source>
        <translation>ist größer als die Grenze von {most_mb} MB</translation>
    </message>
    <message>
        <source>is larger than {most_gb} GB</source>
        <translation>ist größer als {most_gb} GB</translation>
    </message>
    <message>
        <source>is longer than {most} characters</source>
        <translation>ist länger als {most} Zeichen</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>ist kein JSON</translation>
    </message>
    <message>
        <source>is not a playback log</source>
        <translation>ist kein Protokoll</translation>
    </message>
    <message>
        <source>is not a video</source>
        <translation>ist kein Video</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is not a text file in UTF-8</source>
        <translation>ist keine Textdatei in UTF-8</translation>
    </message>
    <message>
        <source>is not answered yet</source>
        <translation>ist noch nicht beantwortet</translation>
    </message>
    <message>
        <source>is not available in {language!r}</source>
        <translation>gibt es nicht auf {language!r}</translation>
    </message>
    <message>
        <source>cannot be read by telemetry-parser ({reason})</source>
        <translation>kann telemetry-parser nicht lesen ({reason})</translation>
    </message>
    <message>
        <source>is of a newer version of this program</source>
        <translation>ist von einer neueren Version dieses Programms</translation>
    </message>
    <message>
        <source>is of a {name}, whose telemetry does not declare its axes</source>
        <translation>ist von einer {name}, deren Achsen ihre Telemetrie nicht nennt</translation>
    </message>
    <message>
        <source>is open in another window</source>
        <translation>ist in einem anderen Fenster geöffnet</translation>
    </message>
    <message>
        <source>is text in UTF-16</source>
        <translation>ist Text in UTF-16</translation>
    </message>
    <message>
        <source>is the study {found}, not {expected}</source>
        <translation>ist die Studie {found}, nicht {expected}</translation>
    </message>
    <message>
        <source>is too large</source>
        <translation>ist zu groß</translation>
    </message>
    <message>
        <source>is too large to be read at once</source>
        <translation>ist zu groß, um auf einmal gelesen zu werden</translation>
    </message>
    <message>
        <source>it cannot be decoded any further</source>
        <translation>es kann nicht weiter dekodiert werden</translation>
    </message>
    <message>
        <source>it cannot be probed</source>
        <translation>es kann nicht untersucht werden</translation>
    </message>
    <message>
        <source>it cannot be read any further</source>
        <translation>es kann nicht weiter gelesen werden</translation>
    </message>
    <message>
        <source>it died, status {status}</source>
        <translation>er brach ab, Status {status}</translation>
    </message>
    <message>
        <source>it does not begin with the boot loader&apos;s key 08AA</source>
        <translation>sie beginnt nicht mit dem Schlüssel 08AA des Ladeprogramms</translation>
    </message>
    <message>
        <source>it ends in its header</source>
        <translation>sie endet in ihrem Kopf</translation>
    </message>
    <message>
        <source>it gives {duration_s:.0f} s as its duration</source>
        <translation>es gibt {duration_s:.0f} s als Dauer an</translation>
    </message>
    <message>
        <source>it holds no accelerations</source>
        <translation>sie enthält keine Beschleunigungen</translation>
    </message>
    <message>
        <source>it holds no sound</source>
        <translation>es enthält keinen Ton</translation>
    </message>
    <message>
        <source>it holds no video that can be shown</source>
        <translation>es enthält kein Video, das gezeigt werden kann</translation>
    </message>
    <message>
        <source>it holds {count} streams, expected 1 to {most}</source>
        <translation>es enthält {count} Ströme, erwartet werden 1 bis {most}</translation>
    </message>
    <message>
        <source>it holds {samples} motion samples in {payloads} payloads, as time-lapse recordings do</source>
        <translation>es enthält {samples} Bewegungswerte in {payloads} Blöcken, wie Zeitrafferaufnahmen es tun</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>it is not a video or sound file that can be read</source>
        <translation>es ist kein Video oder Ton, der gelesen werden kann</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>sie ist zu groß</translation>
    </message>
    <message>
        <source>it looks like deg/s: multiply gx, gy, gz by 0.0174532925</source>
        <translation>es sieht nach °/s aus: Multiplizieren Sie gx, gy, gz mit 0.0174532925</translation>
    </message>
    <message>
        <source>it seems to be in g: multiply it by 9.80665</source>
        <translation>es scheint in g zu sein: Multiplizieren Sie mit 9.80665</translation>
    </message>
    <message>
        <source>it did not accept all of the data at {place}</source>
        <translation>er nahm bei {place} nicht alle Daten an</translation>
    </message>
    <message>
        <source>its accelerometer and gyro do not overlap in time</source>
        <translation>Beschleunigungssensor und Gyroskop überlappen sich zeitlich nicht</translation>
    </message>
    <message>
        <source>its accelerometer and gyroscope do not overlap in time</source>
        <translation>Beschleunigungssensor und Gyroskop überlappen sich zeitlich nicht</translation>
    </message>
    <message>
        <source>its arrays do not belong together</source>
        <translation>die Felder passen nicht zusammen</translation>
    </message>
    <message>
        <source>its axes (MTRX) are not a matrix, so it is damaged</source>
        <translation>die Achsen (MTRX) sind keine Matrix, sie ist also beschädigt</translation>
    </message>
    <message>
        <source>its axes ({axes}) mirror the camera, so the telemetry is damaged</source>
        <translation>die Achsen ({axes}) spiegeln die Kamera, die Telemetrie ist also beschädigt</translation>
    </message>
    <message>
        <source>its axis {axis} was up, so the sensor was not mounted with {axes} to the right, front and up{words}</source>
        <translation>die Achse {axis} war oben, der Sensor war also nicht mit {axes} nach rechts, vorn und oben befestigt{words}</translation>
    </message>
    <message>
        <source>its boot processor does not answer</source>
        <translation>der Boot-Prozessor antwortet nicht</translation>
    </message>
    <message>
        <source>its echo at {place} ended after {count} of {expected} bytes</source>
        <translation>das Echo bei {place} endete nach {count} von {expected} Bytes</translation>
    </message>
    <message>
        <source>its echo at {place} was wrong</source>
        <translation>das Echo bei {place} war falsch</translation>
    </message>
    <message>
        <source>its entry point {entry:06X} lies in none of its blocks</source>
        <translation>der Einsprungpunkt {entry:06X} liegt in keinem der Blöcke</translation>
    </message>
    <message>
        <source>its gravity cannot be used</source>
        <translation>die Schwerkraft darin ist nicht zu gebrauchen</translation>
    </message>
    <message>
        <source>its gyro file has the norm {norm:.3g} of gravity, its accel file has not: the names are swapped</source>
        <translation>die gyro-Datei hat den Betrag {norm:.3g} der Schwerkraft, die accel-Datei nicht, die Namen sind also vertauscht</translation>
    </message>
    <message>
        <source>its headers are damaged</source>
        <translation>die Kopfdaten sind beschädigt</translation>
    </message>
    <message>
        <source>its index lists more samples than it has bytes</source>
        <translation>der Index nennt mehr Einträge, als es Bytes hat</translation>
    </message>
    <message>
        <source>its sound cannot be resampled</source>
        <translation>der Ton kann nicht umgerechnet werden</translation>
    </message>
    <message>
        <source>its sound cannot be set up</source>
        <translation>der Ton kann nicht eingerichtet werden</translation>
    </message>
    <message>
        <source>its sound has {channels} channels at {rate} Hz</source>
        <translation>der Ton hat {channels} Kanäle mit {rate} Hz</translation>
    </message>
    <message>
        <source>its telemetry ({camera}) holds no {kind} samples</source>
        <translation>die Telemetrie ({camera}) enthält keine Werte von {kind}</translation>
    </message>
    <message>
        <source>its telemetry claims {largest:.3g} {unit}, beyond what sensors measure</source>
        <translation>die Telemetrie behauptet {largest:.3g} {unit}, mehr als Sensoren messen</translation>
    </message>
    <message>
        <source>its telemetry holds no accelerometer samples</source>
        <translation>die Telemetrie enthält keine Werte des Beschleunigungssensors</translation>
    </message>
    <message>
        <source>its telemetry is larger than any camera&apos;s (payload {count} has {size_bytes} bytes)</source>
        <translation>die Telemetrie ist größer als die jeder Kamera (Block {count} hat {size_bytes} Bytes)</translation>
    </message>
    <message>
        <source>its telemetry track is damaged</source>
        <translation>die Telemetriespur ist beschädigt</translation>
    </message>
    <message>
        <source>its time stamps run backwards, so it is damaged</source>
        <translation>die Zeitstempel laufen rückwärts, sie ist also beschädigt</translation>
    </message>
    <message>
        <source>its units are not known</source>
        <translation>die Einheiten sind nicht bekannt</translation>
    </message>
    <message>
        <source>its video cannot be set up</source>
        <translation>das Video kann nicht eingerichtet werden</translation>
    </message>
    <message>
        <source>its {key} is {value!r}, not a number above zero</source>
        <translation>{key} ist {value!r}, keine Zahl über null</translation>
    </message>
    <message>
        <source>lacks {missing}</source>
        <translation>es fehlt {missing}</translation>
    </message>
    <message>
        <source>leave LSL out</source>
        <translation>lassen Sie LSL weg</translation>
    </message>
    <message>
        <source>libusb is missing; install the package libusb-1.0-0 (Windows: put libusb-1.0.dll on the path)</source>
        <translation>libusb fehlt; installieren Sie das Paket libusb-1.0-0 (Windows: legen Sie libusb-1.0.dll in den Suchpfad)</translation>
    </message>
    <message>
        <source>line {number}</source>
        <translation>Zeile {number}</translation>
    </message>
    <message>
        <source>look for values far beyond what a sensor can measure</source>
        <translation>suchen Sie nach Werten, die weit über dem liegen, was ein Sensor messen kann</translation>
    </message>
    <message>
        <source>looked for</source>
        <translation>gesucht</translation>
    </message>
    <message>
        <source>made telemetry-parser return invalid data ({reason})</source>
        <translation>ließ telemetry-parser Unsinn antworten ({reason})</translation>
    </message>
    <message>
        <source>magnetic field in {unit}</source>
        <translation>Magnetfeld in {unit}</translation>
    </message>
    <message>
        <source>mapping axes</source>
        <translation>Achsen der Zuordnung</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>darf nicht gelesen werden</translation>
    </message>
    <message>
        <source>motion low-passed at {lowpass_hz:g} Hz, zero phase</source>
        <translation>Bewegung mit Tiefpass bei {lowpass_hz:g} Hz, ohne Phasenverschiebung</translation>
    </message>
    <message>
        <source>names a column twice</source>
        <translation>nennt eine Spalte zweimal</translation>
    </message>
    <message>
        <source>names {count} columns, the table has {total} ({shown})</source>
        <translation>nennt {count} Spalten, die Tabelle hat {total} ({shown})</translation>
    </message>
    <message>
        <source>no Falcon is plugged in</source>
        <translation>kein Falcon ist angesteckt</translation>
    </message>
    <message>
        <source>no Falcon is plugged in; connect its USB cable and its power supply</source>
        <translation>kein Falcon ist angesteckt; schließen Sie sein USB-Kabel und sein Netzteil an</translation>
    </message>
    <message>
        <source>no Falcon {serial!r} is plugged in; choose one of {known}</source>
        <translation>kein Falcon {serial!r} ist angesteckt; es gibt: {known}</translation>
    </message>
    <message>
        <source>no leg reaches ({x:.1f}, {y:.1f}, {z:.1f}) mm</source>
        <translation>kein Bein erreicht ({x:.1f}, {y:.1f}, {z:.1f}) mm</translation>
    </message>
    <message>
        <source>none of its streams can be decoded, because its headers are damaged</source>
        <translation>keiner der Ströme lässt sich dekodieren, denn die Kopfdaten sind beschädigt</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>nothing was recorded for {gap_s:.0f} s after {place}</source>
        <translation>nach {place} wurde {gap_s:.0f} s lang nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>give the file or folder of one of them instead</source>
        <translation>nichts, aber geben Sie die Datei oder den Ordner von einem an</translation>
    </message>
    <message>
        <source>AndroSensor</source>
        <translation>AndroSensor</translation>
    </message>
    <message>
        <source>BIDS (behaviour, and motion at 1 kHz)</source>
        <translation>BIDS (Verhalten, und Bewegung mit 1 kHz)</translation>
    </message>
    <message>
        <source>RaceChrono</source>
        <translation>RaceChrono</translation>
    </message>
    <message>
        <source>XDF, a file for each run</source>
        <translation>XDF, eine Datei je Durchgang</translation>
    </message>
    <message>
        <source>Xsens DOT</source>
        <translation>Xsens DOT</translation>
    </message>
    <message>
        <source>Xsens MT Manager</source>
        <translation>Xsens MT Manager</translation>
    </message>
    <message>
        <source>are {count} tables ({shown}) without a description</source>
        <translation>sind {count} Tabellen ({shown}), die nicht sagen, was ihre Spalten sind</translation>
    </message>
    <message>
        <source>begins with {count} NUL bytes</source>
        <translation>beginnt mit {count} NUL-Bytes</translation>
    </message>
    <message>
        <source>convert it to CSV with blackbox_decode</source>
        <translation>wandeln Sie es mit blackbox_decode in CSV um</translation>
    </message>
    <message>
        <source>copy it again, or remove the bytes</source>
        <translation>kopieren Sie sie noch einmal, oder entfernen Sie die Bytes</translation>
    </message>
    <message>
        <source>describes {count} of {total} tables (/ between them)</source>
        <translation>beschreibt {count} von {total} Tabellen (/ dazwischen)</translation>
    </message>
    <message>
        <source>/dev/input/{node}: it has no such force feedback; devices that have: {known}</source>
        <translation>/dev/input/{node}: hat kein solches Force-Feedback; Geräte, die es haben: {known}</translation>
    </message>
    <message>
        <source>./run sets them up in .venv</source>
        <translation>./run richtet sie in .venv ein</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>A second or more without motion</source>
        <translation>Eine Sekunde oder länger ohne Bewegung</translation>
    </message>
    <message>
        <source>A sensor at the end of its range</source>
        <translation>Ein Sensor am Ende seines Messbereichs</translation>
    </message>
    <message>
        <source>Add yourself to the group input, log out and log in again.</source>
        <translation>Nehmen Sie sich in die Gruppe input auf und melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Amplitude at the end</source>
        <translation>Amplitude am Ende</translation>
    </message>
    <message>
        <source>Amplitude at the start</source>
        <translation>Amplitude am Anfang</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Bass shakers or voice coils on a sound output: they vibrate with the force.</source>
        <translation>Bass-Shaker oder Schwingspulen an einem Tonausgang: Sie vibrieren mit der Kraft.</translation>
    </message>
    <message>
        <source>Bends with 0.15 g or more sideways</source>
        <translation>Kurven mit mindestens 0,15 g zur Seite</translation>
    </message>
    <message>
        <source>Board that takes TCode: its vibration follows the strength of the force, not its direction.</source>
        <translation>Platine, die TCode versteht: Ihre Vibration folgt der Stärke der Kraft, nicht ihrer Richtung.</translation>
    </message>
    <message>
        <source>Braking</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>Braking at up to {level_mps2:.1f} m/s², {change_mps:.0f} m/s slower</source>
        <translation>Bremsen mit bis zu {level_mps2:.1f} m/s², {change_mps:.0f} m/s langsamer</translation>
    </message>
    <message>
        <source>Changes only what would push a relaxed hand further than 26 mm from the centre.</source>
        <translation>Ändert nur, was eine lockere Hand weiter als 26 mm aus der Mitte drücken würde.</translation>
    </message>
    <message>
        <source>Choose another device: only Linux has this interface.</source>
        <translation>Wählen Sie ein anderes Gerät: Nur Linux hat diese Schnittstelle.</translation>
    </message>
    <message>
        <source>Choose this game in the rig&apos;s software. Packets stay on this computer unless you enter another address.</source>
        <translation>Wählen Sie dieses Spiel in der Software der Bewegungsplattform. Die Pakete bleiben auf diesem Rechner, solange Sie keine andere Adresse eingeben.</translation>
    </message>
    <message>
        <source>Connect it as its maker says.</source>
        <translation>Schließen Sie es nach Anleitung des Herstellers an.</translation>
    </message>
    <message>
        <source>Connect it by cable or by Bluetooth.</source>
        <translation>Schließen Sie es per Kabel oder Bluetooth an.</translation>
    </message>
    <message>
        <source>Connect it; if it is connected, its driver is missing or has no such force feedback.</source>
        <translation>Schließen Sie es an; ist es angeschlossen, fehlt sein Treiber oder er kann dieses Force-Feedback nicht.</translation>
    </message>
    <message>
        <source>Connect its USB cable and power supply; it is detected automatically.</source>
        <translation>Schließen Sie USB-Kabel und Netzteil an; er wird automatisch erkannt.</translation>
    </message>
    <message>
        <source>Connect its power supply and its USB cable.</source>
        <translation>Schließen Sie Netzteil und USB-Kabel an.</translation>
    </message>
    <message>
        <source>Connect the board, and add yourself to the group dialout.</source>
        <translation>Schließen Sie die Platine an und nehmen Sie sich in die Gruppe dialout auf.</translation>
    </message>
    <message>
        <source>Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the device and plug it in.</source>
        <translation>Kopieren Sie die udev-Regel {rule} nach /etc/udev/rules.d, ziehen Sie das Gerät ab und stecken Sie es wieder an.</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>Cut-off frequency</source>
        <translation>Grenzfrequenz</translation>
    </message>
    <message>
        <source>Decay time</source>
        <translation>Abklingzeit</translation>
    </message>
    <message>
        <source>Delayed</source>
        <translation>Verzögert</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Enter HOST:PORT of a board or program that takes TCode by UDP, or a serial port such as /dev/ttyUSB0.</source>
        <translation>Geben Sie HOST:PORT einer Platine oder eines Programms ein, das TCode per UDP annimmt, oder eine serielle Schnittstelle wie /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>Facing backward, upright</source>
        <translation>Nach hinten gerichtet, aufrecht</translation>
    </message>
    <message>
        <source>Facing down</source>
        <translation>Nach unten gerichtet</translation>
    </message>
    <message>
        <source>Facing forward, left side up</source>
        <translation>Nach vorn gerichtet, linke Seite oben</translation>
    </message>
    <message>
        <source>Facing forward, right side up</source>
        <translation>Nach vorn gerichtet, rechte Seite oben</translation>
    </message>
    <message>
        <source>Facing forward, upright</source>
        <translation>Nach vorn gerichtet, aufrecht</translation>
    </message>
    <message>
        <source>Facing forward, upside down</source>
        <translation>Nach vorn gerichtet, kopfüber</translation>
    </message>
    <message>
        <source>Facing left, upright</source>
        <translation>Nach links gerichtet, aufrecht</translation>
    </message>
    <message>
        <source>Facing right, upright</source>
        <translation>Nach rechts gerichtet, aufrecht</translation>
    </message>
    <message>
        <source>First sudden rise</source>
        <translation>Erster plötzlicher Anstieg</translation>
    </message>
    <message>
        <source>For studies: every participant gets nearly the same force, but long pushes are much weaker.</source>
        <translation>Für Studien: alle Teilnehmenden bekommen fast dieselbe Kraft, aber lang anhaltende Kräfte sind viel schwächer.</translation>
    </message>
    <message>
        <source>Force in proportion to the motion, as in the paper.</source>
        <translation>Kraft im Verhältnis zur Bewegung, wie im Artikel.</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Game pad that Linux can rumble: its vibration follows the strength of the force, not its direction.</source>
        <translation>Gamepad, das Linux vibrieren lassen kann: Die Vibration folgt der Stärke der Kraft, nicht ihrer Richtung.</translation>
    </message>
    <message>
        <source>Given offset</source>
        <translation>Angegebener Versatz</translation>
    </message>
    <message>
        <source>Haply Inverse3: its arm pushes and pulls in three directions.</source>
        <translation>Haply Inverse3: Sein Arm drückt und zieht in drei Richtungen.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service has {count} Inverse3; leave one connected, and choose the device again</source>
        <translation>Haplys Inverse Service hat {count} Inverse3; lassen Sie eines angeschlossen und wählen Sie das Gerät neu</translation>
    </message>
    <message>
        <source>High-pass</source>
        <translation>Hochpass</translation>
    </message>
    <message>
        <source>Hold it loosely.</source>
        <translation>Halten Sie es locker.</translation>
    </message>
    <message>
        <source>Hold it with both hands.</source>
        <translation>Halten Sie es mit beiden Händen.</translation>
    </message>
    <message>
        <source>Hold it.</source>
        <translation>Halten Sie es fest.</translation>
    </message>
    <message>
        <source>Hold the grip loosely.</source>
        <translation>Halten Sie den Griff locker.</translation>
    </message>
    <message>
        <source>Impact</source>
        <translation>Stoß</translation>
    </message>
    <message>
        <source>Impact of {peak_mps2:.1f} m/s²</source>
        <translation>Stoß von {peak_mps2:.1f} m/s²</translation>
    </message>
    <message>
        <source>Impact of {peak_mps2:.1f} m/s², heard too</source>
        <translation>Stoß von {peak_mps2:.1f} m/s², auch zu hören</translation>
    </message>
    <message>
        <source>Install the Python package sounddevice.</source>
        <translation>Installieren Sie das Python-Paket sounddevice.</translation>
    </message>
    <message>
        <source>Intiface</source>
        <translation>Intiface</translation>
    </message>
    <message>
        <source>Intiface has no device that vibrates; connect one in Intiface and choose the device again</source>
        <translation>Intiface hat kein Gerät, das vibriert; verbinden Sie eines in Intiface und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Knock (decaying sine)</source>
        <translation>Schlag (abklingender Sinus)</translation>
    </message>
    <message>
        <source>LabRecorder did not start at port {port} ({reason})</source>
        <translation>LabRecorder ist an Port {port} nicht gestartet ({reason})</translation>
    </message>
    <message>
        <source>LabRecorder does not answer at port {port} ({reason})</source>
        <translation>LabRecorder antwortet an Port {port} nicht ({reason})</translation>
    </message>
    <message>
        <source>LabRecorder was closed at port {port} ({reason})</source>
        <translation>LabRecorder wurde geschlossen, Port {port} ({reason})</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>Lying on its back, facing up</source>
        <translation>Auf dem Rücken liegend, nach oben gerichtet</translation>
    </message>
    <message>
        <source>MISSING</source>
        <translation>FEHLT</translation>
    </message>
    <message>
        <source>MPEG haptics (ISO/IEC 23090-31), as JSON</source>
        <translation>MPEG-Haptik (ISO/IEC 23090-31), als JSON</translation>
    </message>
    <message>
        <source>MPEG-V sensory effects (ISO/IEC 23005-3), as XML</source>
        <translation>MPEG-V-Effekte (ISO/IEC 23005-3), als XML</translation>
    </message>
    <message>
        <source>Missing samples and isolated spikes</source>
        <translation>Fehlende Messwerte und einzelne Ausreißer</translation>
    </message>
    <message>
        <source>Motion rig</source>
        <translation>Bewegungsplattform</translation>
    </message>
    <message>
        <source>Nobody sits on it yet; its emergency stop is at hand.</source>
        <translation>Noch sitzt niemand darauf; der Notaus ist griffbereit.</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Nothing has to be connected.</source>
        <translation>Es muss nichts angeschlossen werden.</translation>
    </message>
    <message>
        <source>Novint Falcon: its grip pushes and pulls in three directions.</source>
        <translation>Novint Falcon: Sein Griff drückt und zieht in drei Richtungen.</translation>
    </message>
    <message>
        <source>One of several answers</source>
        <translation>Eine von mehreren Antworten</translation>
    </message>
    <message>
        <source>OpenCV is installed, but cannot be loaded: {why}</source>
        <translation>OpenCV ist installiert, lässt sich aber nicht laden: {why}</translation>
    </message>
    <message>
        <source>Other sequence</source>
        <translation>Andere Sequenz</translation>
    </message>
    <message>
        <source>Own clock</source>
        <translation>Eigene Uhr</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Puls</translation>
    </message>
    <message>
        <source>Python packages</source>
        <translation>Python-Pakete</translation>
    </message>
    <message>
        <source>Qt</source>
        <translation>Qt</translation>
    </message>
    <message>
        <source>Qt, with a font</source>
        <translation>Qt, mit einer Schrift</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektiv</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Rumble</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Samples are missing</source>
        <translation>Messwerte fehlen</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Scale of points</source>
        <translation>Skala mit Punkten</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Skaliert</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Several answers</source>
        <translation>Mehrere Antworten</translation>
    </message>
    <message>
        <source>Shaker</source>
        <translation>Shaker</translation>
    </message>
    <message>
        <source>Shocks that stand out of what surrounds them</source>
        <translation>Stöße, die aus ihrer Umgebung herausragen</translation>
    </message>
    <message>
        <source>Shuffled</source>
        <translation>Vertauscht</translation>
    </message>
    <message>
        <source>Simulated Falcon, held by a simulated hand: for trying everything without hardware.</source>
        <translation>Simulierter Falcon, gehalten von einer simulierten Hand: zum Ausprobieren ohne Hardware.</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Speed is lost at 0.3 g or more</source>
        <translation>Geschwindigkeit nimmt mit mindestens 0,3 g ab</translation>
    </message>
    <message>
        <source>Spike of a single sample, as a faulty logger writes</source>
        <translation>Ausreißer eines einzelnen Messwerts, wie ihn ein fehlerhafter Logger schreibt</translation>
    </message>
    <message>
        <source>Start Haply&apos;s Inverse Service and connect the Inverse3, with its power supply. Enter HOST:PORT if the service runs on another computer.</source>
        <translation>Starten Sie den Inverse Service von Haply, und schließen Sie das Inverse3 samt Netzteil an. Geben Sie HOST:PORT ein, wenn der Dienst auf einem anderen Rechner läuft.</translation>
    </message>
    <message>
        <source>Start Intiface, start its server and connect what vibrates there.</source>
        <translation>Starten Sie Intiface und darin den Server, und verbinden Sie dort, was vibriert.</translation>
    </message>
    <message>
        <source>Start the program that passes TCode on to the board.</source>
        <translation>Starten Sie das Programm, das TCode an die Platine weitergibt.</translation>
    </message>
    <message>
        <source>Start the rig&apos;s software.</source>
        <translation>Starten Sie die Software der Bewegungsplattform.</translation>
    </message>
    <message>
        <source>Start {title}.</source>
        <translation>Starten Sie {title}.</translation>
    </message>
    <message>
        <source>Stillness</source>
        <translation>Stillstand</translation>
    </message>
    <message>
        <source>TCode</source>
        <translation>TCode</translation>
    </message>
    <message>
        <source>The accelerometer is at the end of its range</source>
        <translation>Der Beschleunigungssensor ist am Ende seines Messbereichs</translation>
    </message>
    <message>
        <source>The frames were compared by the motion vectors of the codec, which is coarse; with hapticplayer[vision] installed they are followed more exactly, those of H.265 too.</source>
        <translation>Die Bilder wurden anhand der Bewegungsvektoren des Codecs verglichen, also grob; mit hapticplayer[vision] werden sie genauer verfolgt, auch die von H.265.</translation>
    </message>
    <message>
        <source>The gyro is at the end of its range</source>
        <translation>Der Drehratensensor ist am Ende seines Messbereichs</translation>
    </message>
    <message>
        <source>The network does not know this address: correct it.</source>
        <translation>Das Netzwerk kennt diese Adresse nicht: Berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>The same questions about rides that were filmed by the rider and from outside; whether the force adds as much to both.</source>
        <translation>Dieselben Fragen zu Fahrten, die von der fahrenden Person und von außen gefilmt wurden; ob die Kraft bei beiden gleich viel beiträgt.</translation>
    </message>
    <message>
        <source>The sound system does not answer: restart it.</source>
        <translation>Das Tonsystem antwortet nicht: Starten Sie es neu.</translation>
    </message>
    <message>
        <source>Third person against first</source>
        <translation>Dritte Person gegen erste Person</translation>
    </message>
    <message>
        <source>This camera does not timestamp its samples: they may be 10 to 30 ms off, and the frames could not tell by how much: {why}.</source>
        <translation>Diese Kamera stempelt ihre Messwerte nicht: Sie können um 10 bis 30 ms abweichen, und die Bilder zeigen nicht, um wie viel: {why}.</translation>
    </message>
    <message>
        <source>Toys through Intiface: their vibration follows the strength of the force, not its direction.</source>
        <translation>Toys über Intiface: Ihre Vibration folgt der Stärke der Kraft, nicht ihrer Richtung.</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Spur</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Turn the amplifier low.</source>
        <translation>Drehen Sie den Verstärker leise.</translation>
    </message>
    <message>
        <source>Turn to the left with up to {level_mps2:.1f} m/s² for {length_s:.1f} s</source>
        <translation>Linkskurve mit bis zu {level_mps2:.1f} m/s² für {length_s:.1f} s</translation>
    </message>
    <message>
        <source>Turn to the right with up to {level_mps2:.1f} m/s² for {length_s:.1f} s</source>
        <translation>Rechtskurve mit bis zu {level_mps2:.1f} m/s² für {length_s:.1f} s</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Visual analogue scale</source>
        <translation>Visuelle Analogskala</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Lenkrad</translation>
    </message>
    <message>
        <source>Wheel or joystick with a motor: it exerts one axis of the force, by default sideways.</source>
        <translation>Lenkrad oder Joystick mit Motor: Es übt eine Achse der Kraft aus, ohne Angabe die seitliche.</translation>
    </message>
    <message>
        <source>a PulseAudio or PipeWire server answers</source>
        <translation>ein Server von PulseAudio oder PipeWire antwortet</translation>
    </message>
    <message>
        <source>a calibration is for the method smoother, not for {method}</source>
        <translation>eine Kalibrierung gilt für das Verfahren smoother, nicht für {method}</translation>
    </message>
    <message>
        <source>a feedback cannot be rated like {name!r}; choose one of {known}</source>
        <translation>ein Feedback kann nicht wie {name!r} bewertet werden; es gibt {known}</translation>
    </message>
    <message>
        <source>a keyframe lies outside of any clip</source>
        <translation>ein Keyframe liegt außerhalb jedes Clips</translation>
    </message>
    <message>
        <source>a lever arm needs the angular rate of the recording</source>
        <translation>ein Hebelarm braucht die Drehrate der Aufnahme</translation>
    </message>
    <message>
        <source>a matrix of forces is not three numbers a row</source>
        <translation>eine Matrix von Kräften hat nicht drei Zahlen je Zeile</translation>
    </message>
    <message>
        <source>a part of the clip fits another part of the log: was the video cut?</source>
        <translation>ein Teil des Videos passt zu einem anderen Teil des Protokolls: Wurde das Video geschnitten?</translation>
    </message>
    <message>
        <source>a rig moves only with the realistic feedback of a sequence that has its motion</source>
        <translation>eine Plattform bewegt sich nur mit der realistischen Rückmeldung einer Sequenz, die ihre Bewegung hat</translation>
    </message>
    <message>
        <source>a rig track needs at least one row</source>
        <translation>eine Spur für eine Plattform braucht mindestens eine Zeile</translation>
    </message>
    <message>
        <source>a row for each change of the force</source>
        <translation>eine Zeile für jede Änderung der Kraft</translation>
    </message>
    <message>
        <source>a washout needs a track of straight lines, this one holds</source>
        <translation>ein Washout braucht eine Spur aus geraden Linien, diese hält ihre Werte</translation>
    </message>
    <message>
        <source>accel-axes={accel} rate-axes={rate} if both sensors are {how}</source>
        <translation>accel-axes={accel} rate-axes={rate}, wenn beide Sensoren {how} sind</translation>
    </message>
    <message>
        <source>acceleration was taken times {gain:.2g} N per m/s²</source>
        <translation>Beschleunigung wurde mit {gain:.2g} N je m/s² malgenommen</translation>
    </message>
    <message>
        <source>add a page that is shown after each clip</source>
        <translation>fügen Sie eine Seite hinzu, die nach jedem Clip gezeigt wird</translation>
    </message>
    <message>
        <source>add a sequence</source>
        <translation>fügen Sie eine Sequenz hinzu</translation>
    </message>
    <message>
        <source>add an answer</source>
        <translation>fügen Sie eine Antwort hinzu</translation>
    </message>
    <message>
        <source>add yourself to the group {name}, log in again</source>
        <translation>nehmen Sie sich in die Gruppe {name} auf, und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>allow rtprio {n} and memlock in /etc/security/limits.d</source>
        <translation>erlauben Sie rtprio {n} und memlock in /etc/security/limits.d</translation>
    </message>
    <message>
        <source>an array is missing or of the wrong kind ({reason})</source>
        <translation>ein Datenfeld fehlt oder ist von der falschen Art ({reason})</translation>
    </message>
    <message>
        <source>an effect lies outside of any clip</source>
        <translation>ein Effekt liegt außerhalb jedes Clips</translation>
    </message>
    <message>
        <source>ask for the file again</source>
        <translation>verlangen Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>at most {most} effects in a list</source>
        <translation>höchstens {most} Effekte in einer Liste</translation>
    </message>
    <message>
        <source>at most {most} markers in a list</source>
        <translation>höchstens {most} Marker in einer Liste</translation>
    </message>
    <message>
        <source>audio of three channels, for transducers</source>
        <translation>Audio mit drei Kanälen, für Shaker</translation>
    </message>
    <message>
        <source>cannot be compared ({problem})</source>
        <translation>lässt sich nicht vergleichen ({problem})</translation>
    </message>
    <message>
        <source>cannot be copied into {kind} without changing its video</source>
        <translation>kann nicht nach {kind} kopiert werden, ohne dass sich das Video ändert</translation>
    </message>
    <message>
        <source>cannot be fetched ({reason})</source>
        <translation>kann nicht geladen werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be read there ({problem})</source>
        <translation>lässt sich dort nicht lesen ({problem})</translation>
    </message>
    <message>
        <source>cannot be written ({reason}); it is as it was</source>
        <translation>kann nicht geschrieben werden ({reason}); es ist unverändert</translation>
    </message>
    <message>
        <source>channels for {count} parts of the body act on one hand</source>
        <translation>Kanäle für {count} Körperteile wirken auf eine Hand</translation>
    </message>
    <message>
        <source>check its cable and power supply, then test the device</source>
        <translation>prüfen Sie Kabel und Netzteil, und testen Sie das Gerät</translation>
    </message>
    <message>
        <source>checking the clip</source>
        <translation>Clip wird geprüft</translation>
    </message>
    <message>
        <source>choose a file that was written by pack</source>
        <translation>wählen Sie eine Datei, die mit pack geschrieben wurde</translation>
    </message>
    <message>
        <source>choose a larger tolerance, or another format</source>
        <translation>wählen Sie eine größere Toleranz oder ein anderes Format</translation>
    </message>
    <message>
        <source>choose a lower sample rate, or another format</source>
        <translation>wählen Sie eine niedrigere Abtastrate oder ein anderes Format</translation>
    </message>
    <message>
        <source>choose another clip</source>
        <translation>wählen Sie einen anderen Clip</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>wählen Sie ein anderes Format</translation>
    </message>
    <message>
        <source>choose another key</source>
        <translation>wählen Sie einen anderen Schlüssel</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>choose another track</source>
        <translation>wählen Sie eine andere Spur</translation>
    </message>
    <message>
        <source>choose the other kind of file, or convert it to MP4 and import it again</source>
        <translation>wählen Sie die andere Art von Datei, oder wandeln Sie es in MP4 um und importieren Sie es erneut</translation>
    </message>
    <message>
        <source>choose the other kind of file, or convert the clip first</source>
        <translation>wählen Sie die andere Art von Datei, oder wandeln Sie den Clip zuerst um</translation>
    </message>
    <message>
        <source>clips play silently, led by the system clock, until there is one</source>
        <translation>Clips laufen stumm nach der Systemuhr, bis eines davon da ist</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>columns={columns} (as the header suggests; - ignores a column)</source>
        <translation>columns={columns} (wie der Kopf es nahelegt; - übergeht eine Spalte)</translation>
    </message>
    <message>
        <source>comes after another value</source>
        <translation>folgt auf einen anderen Wert</translation>
    </message>
    <message>
        <source>computer stalled</source>
        <translation>Rechner stockte</translation>
    </message>
    <message>
        <source>connect it, close this session and resume it</source>
        <translation>schließen Sie es an, schließen Sie diese Sitzung, und setzen Sie sie fort</translation>
    </message>
    <message>
        <source>contains no motion data</source>
        <translation>enthält keine Bewegungsdaten</translation>
    </message>
    <message>
        <source>contents and checksums</source>
        <translation>Inhalt und Prüfsummen</translation>
    </message>
    <message>
        <source>convert it to MP4 (H.264 and AAC) and import it again</source>
        <translation>wandeln Sie es in MP4 (H.264 und AAC) um und importieren Sie es erneut</translation>
    </message>
    <message>
        <source>copy it from the other machine again; to use what is intact, move its folder into sessions</source>
        <translation>kopieren Sie es noch einmal vom anderen Rechner; um zu nutzen, was heil ist, verschieben Sie seinen Ordner nach sessions</translation>
    </message>
    <message>
        <source>copying the sequence</source>
        <translation>Sequenz wird kopiert</translation>
    </message>
    <message>
        <source>copying the sessions</source>
        <translation>Sitzungen werden kopiert</translation>
    </message>
    <message>
        <source>correct the file, or remove it</source>
        <translation>berichtigen Sie die Datei, oder entfernen Sie sie</translation>
    </message>
    <message>
        <source>cumulative-link mixed model ({link}): likelihood ratio of all feedbacks, pairs by Wald&apos;s t with Holm</source>
        <translation>gemischtes Cumulative-Link-Modell ({link}): Likelihood-Quotient aller Feedbacks, Paare nach Walds t mit Holm</translation>
    </message>
    <message>
        <source>curve: its times must increase from 0 s</source>
        <translation>curve: die Zeiten müssen ab 0 s ansteigen</translation>
    </message>
    <message>
        <source>curve: {kind} takes {most} points at most</source>
        <translation>curve: {kind} nimmt höchstens {most} Punkte</translation>
    </message>
    <message>
        <source>cut it into parts of some hours</source>
        <translation>teilen Sie es in Stücke von einigen Stunden</translation>
    </message>
    <message>
        <source>date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>device not responding</source>
        <translation>Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>device {name!r}: nothing but gain= can follow; use {kind}</source>
        <translation>Gerät {name!r}: Danach kann nur gain= folgen; verwenden Sie {kind}</translation>
    </message>
    <message>
        <source>direction: must be three numbers that are not all zero</source>
        <translation>direction: muss aus drei Zahlen bestehen, die nicht alle null sind</translation>
    </message>
    <message>
        <source>display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>divides the sequences as another factor does</source>
        <translation>teilt die Sequenzen so auf wie ein anderer Faktor</translation>
    </message>
    <message>
        <source>does not declare its rate</source>
        <translation>gibt seine Rate nicht an</translation>
    </message>
    <message>
        <source>does not fit the definition of its session</source>
        <translation>passt nicht zur Definition der Sitzung</translation>
    </message>
    <message>
        <source>durations were taken as seconds, as in PlaySEM</source>
        <translation>Dauern gelten als Sekunden, wie in PlaySEM</translation>
    </message>
    <message>
        <source>early</source>
        <translation>früh</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>effect {number} ({kind}, from {start_s:g} to {end_s:g} s) is beyond the clip, which lasts {duration_s:.3f} s; move or remove it</source>
        <translation>Effekt {number} ({kind}, von {start_s:g} bis {end_s:g} s) liegt hinter dem Ende des Clips, der {duration_s:.3f} s dauert; verschieben oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>end_s: {end_s:g} s must come after start_s ({start_s:g} s), by {most_s:g} s at most</source>
        <translation>end_s: {end_s:g} s muss nach start_s ({start_s:g} s) liegen, höchstens {most_s:g} s danach</translation>
    </message>
    <message>
        <source>ends before 0 s</source>
        <translation>endet vor 0 s</translation>
    </message>
    <message>
        <source>enter one, or set it to false</source>
        <translation>geben Sie einen an, oder setzen Sie es auf false</translation>
    </message>
    <message>
        <source>error RMS {rms:.4f} N, largest {largest:.4f} N ({compared})</source>
        <translation>Fehler RMS {rms:.4f} N, größter {largest:.4f} N ({compared})</translation>
    </message>
    <message>
        <source>excursions beyond {reach_mm:g} mm</source>
        <translation>Auslenkungen über {reach_mm:g} mm</translation>
    </message>
    <message>
        <source>export it with semicolons, or with decimal points</source>
        <translation>exportieren Sie es mit Semikolons oder mit Dezimalpunkten</translation>
    </message>
    <message>
        <source>export its accelerometer and gyroscope as CSV, with FitCSVTool</source>
        <translation>exportieren Sie Beschleunigungssensor und Gyroskop als CSV, mit FitCSVTool</translation>
    </message>
    <message>
        <source>export the accelerometer and the gyroscope too</source>
        <translation>exportieren Sie auch Beschleunigungssensor und Gyroskop</translation>
    </message>
    <message>
        <source>export the log again, or write that line above the first row</source>
        <translation>exportieren Sie das Protokoll noch einmal, oder schreiben Sie diese Zeile über die erste Zeile mit Werten</translation>
    </message>
    <message>
        <source>export the log with the digits 0 to 9, as programs in English do</source>
        <translation>exportieren Sie das Protokoll mit den Ziffern 0 bis 9, wie Programme auf Englisch</translation>
    </message>
    <message>
        <source>export the recording again, or unpack it and give the folder</source>
        <translation>exportieren Sie die Aufnahme noch einmal, oder entpacken Sie sie und geben Sie den Ordner an</translation>
    </message>
    <message>
        <source>fades: {fades_s:g} s together must fit into the {duration_s:g} s of the effect</source>
        <translation>fades: zusammen {fades_s:g} s müssen in die {duration_s:g} s des Effekts passen</translation>
    </message>
    <message>
        <source>feedback {feedback} has no parameter {name!r}; it has {known}</source>
        <translation>das Feedback {feedback} hat keinen Parameter {name!r}; es hat {known}</translation>
    </message>
    <message>
        <source>feedback {feedback} has no parameters</source>
        <translation>das Feedback {feedback} hat keine Parameter</translation>
    </message>
    <message>
        <source>finding events</source>
        <translation>Ereignisse werden gesucht</translation>
    </message>
    <message>
        <source>following frames needs OpenCV, which cannot be loaded ({why})</source>
        <translation>Um Bildern zu folgen, braucht es OpenCV, das sich nicht laden lässt ({why})</translation>
    </message>
    <message>
        <source>following the frames</source>
        <translation>Bilder werden verfolgt</translation>
    </message>
    <message>
        <source>force for other programs</source>
        <translation>Kraft für andere Programme</translation>
    </message>
    <message>
        <source>force minus {what}: median {middle:+.1f} ms, worst trial {worst:+.1f} ms</source>
        <translation>Kraft minus {what}: Median {middle:+.1f} ms, schlechtester Durchgang {worst:+.1f} ms</translation>
    </message>
    <message>
        <source>force of the feedback random, lossless</source>
        <translation>Kraft des Feedbacks zufällig, verlustfrei</translation>
    </message>
    <message>
        <source>force of the feedback realistic, lossless</source>
        <translation>Kraft des Feedbacks realistisch, verlustfrei</translation>
    </message>
    <message>
        <source>force of the feedback {name}, lossless</source>
        <translation>Kraft des Feedbacks {name}, verlustfrei</translation>
    </message>
    <message>
        <source>force track</source>
        <translation>Kraftspur</translation>
    </message>
    <message>
        <source>force vector, every millisecond</source>
        <translation>Kraftvektor, jede Millisekunde</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>frames and gyro agree about one axis only, as those of another ride can</source>
        <translation>Bilder und Gyroskop stimmen nur um eine Achse überein, wie es auch bei einer anderen Fahrt vorkommt</translation>
    </message>
    <message>
        <source>frames cannot be compared with the gyroscope at another speed</source>
        <translation>bei anderer Geschwindigkeit lassen sich die Bilder nicht mit dem Gyroskop vergleichen</translation>
    </message>
    <message>
        <source>free some space or choose a folder on another disk</source>
        <translation>machen Sie Platz frei, oder wählen Sie einen Ordner auf einem anderen Datenträger</translation>
    </message>
    <message>
        <source>full scale was taken as {full_n:.3g} N</source>
        <translation>Vollausschlag wurde als {full_n:.3g} N genommen</translation>
    </message>
    <message>
        <source>gain_n_per_mps2 must be at most {most:g}</source>
        <translation>gain_n_per_mps2 darf höchstens {most:g} sein</translation>
    </message>
    <message>
        <source>give &quot;realistic&quot; the parameter &quot;effects&quot;: &quot;off&quot;</source>
        <translation>geben Sie &quot;realistic&quot; den Parameter &quot;effects&quot;: &quot;off&quot;</translation>
    </message>
    <message>
        <source>give a recording of sensors that worked</source>
        <translation>geben Sie eine Aufnahme an, deren Sensoren funktioniert haben</translation>
    </message>
    <message>
        <source>give an effects.json</source>
        <translation>geben Sie eine effects.json an</translation>
    </message>
    <message>
        <source>give another full scale</source>
        <translation>einen anderen Vollausschlag angeben</translation>
    </message>
    <message>
        <source>give the folder of one of them instead</source>
        <translation>geben Sie stattdessen den Ordner einer davon an</translation>
    </message>
    <message>
        <source>give the sequences different levels</source>
        <translation>geben Sie den Sequenzen verschiedene Stufen</translation>
    </message>
    <message>
        <source>give the times in seconds of media time</source>
        <translation>geben Sie die Zeiten in Sekunden der Medienzeit an</translation>
    </message>
    <message>
        <source>give the unit of its numbers, or a recording of a sensor that worked</source>
        <translation>geben Sie die Einheit seiner Zahlen an, oder eine Aufnahme eines Sensors, der funktioniert hat</translation>
    </message>
    <message>
        <source>give times in seconds of media time</source>
        <translation>geben Sie Zeiten in Sekunden der Medienzeit an</translation>
    </message>
    <message>
        <source>gravity turns by {turn_deg:.0f} degrees within 8 s in its accelerometer as its gyroscope does not show: an axis is dead, or the range of one or all another</source>
        <translation>in seinem Beschleunigungssensor dreht sich die Schwerkraft innerhalb von 8 s um {turn_deg:.0f} Grad, was sein Gyroskop nicht zeigt: eine Achse ist ausgefallen, oder der Messbereich einer oder aller Achsen ist ein anderer</translation>
    </message>
    <message>
        <source>grip at the edge of the workspace</source>
        <translation>Griff am Rand des Arbeitsraums</translation>
    </message>
    <message>
        <source>grip button</source>
        <translation>Taste am Griff</translation>
    </message>
    <message>
        <source>grip released</source>
        <translation>Griff losgelassen</translation>
    </message>
    <message>
        <source>guard process not responding</source>
        <translation>Wachprozess antwortete nicht</translation>
    </message>
    <message>
        <source>gyroscope</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>haptic pattern for iPhones</source>
        <translation>Haptik-Muster für iPhones</translation>
    </message>
    <message>
        <source>has a row for each reading of one sensor (column {number} holds {names})</source>
        <translation>hat eine Zeile je Messwert eines einzelnen Sensors (Spalte {number} enthält {names})</translation>
    </message>
    <message>
        <source>has decimal commas between commas: {count} cells below {names} names</source>
        <translation>hat Dezimalkommas zwischen Kommas: {count} Zellen unter {names} Namen</translation>
    </message>
    <message>
        <source>has more than {most_mb} MB of force and motion, which is too much for one file</source>
        <translation>hat mehr als {most_mb} MB an Kraft und Bewegung, zu viel für eine Datei</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>hat keinen Wert</translation>
    </message>
    <message>
        <source>has no yes-or-no question after a clip</source>
        <translation>hat keine Ja-Nein-Frage nach einem Clip</translation>
    </message>
    <message>
        <source>has numbers in other digits than 0 to 9 ({found})</source>
        <translation>hat Zahlen mit anderen Ziffern als 0 bis 9 ({found})</translation>
    </message>
    <message>
        <source>has sent no sample yet</source>
        <translation>hat noch keinen Wert gesendet</translation>
    </message>
    <message>
        <source>holds NUL bytes, as a logger leaves that loses its power</source>
        <translation>enthält NUL-Bytes, wie sie ein Logger hinterlässt, dem der Strom ausgeht</translation>
    </message>
    <message>
        <source>holds a file that no sequence has, {name!r}</source>
        <translation>enthält eine Datei, die keine Sequenz hat, {name!r}</translation>
    </message>
    <message>
        <source>holds no force and has none beside it</source>
        <translation>enthält keine Kraft, und daneben liegt auch keine</translation>
    </message>
    <message>
        <source>holds no force that is understood</source>
        <translation>enthält keine Kraft, die verstanden wird</translation>
    </message>
    <message>
        <source>holds no force that is understood ({first})</source>
        <translation>enthält keine Kraft, die verstanden wird ({first})</translation>
    </message>
    <message>
        <source>holds no numbers</source>
        <translation>enthält keine Zahlen</translation>
    </message>
    <message>
        <source>holds no positions</source>
        <translation>enthält keine Positionen</translation>
    </message>
    <message>
        <source>holds no recorded samples</source>
        <translation>enthält keine aufgezeichneten Messwerte</translation>
    </message>
    <message>
        <source>holds no samples</source>
        <translation>enthält keine Abtastwerte</translation>
    </message>
    <message>
        <source>holds no track {name!r}</source>
        <translation>enthält keine Spur {name!r}</translation>
    </message>
    <message>
        <source>holds the force of a video, not the video</source>
        <translation>enthält die Kraft eines Videos, nicht das Video</translation>
    </message>
    <message>
        <source>holds too many values</source>
        <translation>enthält zu viele Werte</translation>
    </message>
    <message>
        <source>holds two attachments of one name</source>
        <translation>enthält zwei Anhänge mit demselben Namen</translation>
    </message>
    <message>
        <source>in test, or being set up</source>
        <translation>wird getestet oder eingerichtet</translation>
    </message>
    <message>
        <source>in the sequence {key!r}, {one!r} and {other!r} are the same force</source>
        <translation>in der Sequenz {key!r} sind {one!r} und {other!r} dieselbe Kraft</translation>
    </message>
    <message>
        <source>install the program again</source>
        <translation>installieren Sie das Programm neu</translation>
    </message>
    <message>
        <source>is a FIT file of a sports watch or cycle computer</source>
        <translation>ist eine FIT-Datei einer Sportuhr oder eines Fahrradcomputers</translation>
    </message>
    <message>
        <source>is a blackbox log of a flight controller</source>
        <translation>ist ein Blackbox-Protokoll eines Flugreglers</translation>
    </message>
    <message>
        <source>is a table of {program} without the acceleration of three axes</source>
        <translation>ist eine Tabelle von {program} ohne die Beschleunigung dreier Achsen</translation>
    </message>
    <message>
        <source>is a zip that is cut off, damaged or followed by other bytes ({reason})</source>
        <translation>ist ein ZIP, das abgeschnitten oder beschädigt ist oder dem andere Bytes folgen ({reason})</translation>
    </message>
    <message>
        <source>is a zip with other bytes before it</source>
        <translation>ist ein ZIP mit anderen Bytes davor</translation>
    </message>
    <message>
        <source>is an address, not a file of this machine</source>
        <translation>ist eine Adresse, keine Datei auf diesem Rechner</translation>
    </message>
    <message>
        <source>is an archive that is not a zip</source>
        <translation>ist ein Archiv, aber kein ZIP</translation>
    </message>
    <message>
        <source>is compressed with gzip</source>
        <translation>ist mit gzip komprimiert</translation>
    </message>
    <message>
        <source>is it the log of this clip, and the video not stabilised?</source>
        <translation>gehört das Protokoll zu diesem Video, und ist das Video nicht stabilisiert?</translation>
    </message>
    <message>
        <source>is longer there ({count} more records); move the shorter one here out of the study and merge again</source>
        <translation>ist dort länger (um {count} Einträge); verschieben Sie die kürzere hier aus der Studie, und führen Sie noch einmal zusammen</translation>
    </message>
    <message>
        <source>is not MPEG-V (SEM)</source>
        <translation>ist kein MPEG-V (SEM)</translation>
    </message>
    <message>
        <source>is not a SHA-256 checksum</source>
        <translation>ist keine SHA-256-Prüfsumme</translation>
    </message>
    <message>
        <source>is not a WAV file</source>
        <translation>ist keine WAV-Datei</translation>
    </message>
    <message>
        <source>is not a calibration of a sensor</source>
        <translation>ist keine Kalibrierung eines Sensors</translation>
    </message>
    <message>
        <source>is not a list of effects</source>
        <translation>ist keine Liste von Effekten</translation>
    </message>
    <message>
        <source>is not a template for logs (it must hold texts for {known})</source>
        <translation>ist keine Vorlage für ein Protokoll (sie darf Texte enthalten für {known})</translation>
    </message>
    <message>
        <source>is not overwritten, because it is not such a file written by hapticplayer</source>
        <translation>wird nicht überschrieben, denn es ist keine solche Datei von hapticplayer</translation>
    </message>
    <message>
        <source>is not valid XML ({reason})</source>
        <translation>ist kein gültiges XML ({reason})</translation>
    </message>
    <message>
        <source>is only used after a clip</source>
        <translation>wird nur nach einem Clip verwendet</translation>
    </message>
    <message>
        <source>is too large (limit: {most_bytes} bytes)</source>
        <translation>ist zu groß (Grenze: {most_bytes} Byte)</translation>
    </message>
    <message>
        <source>is truncated in its header</source>
        <translation>ist im Kopf abgeschnitten</translation>
    </message>
    <message>
        <source>it has more than {most} boxes</source>
        <translation>es hat mehr als {most} Boxen</translation>
    </message>
    <message>
        <source>it is a time lapse or TimeWarp (GoPro&apos;s rate: {rate})</source>
        <translation>es ist ein Zeitraffer oder TimeWarp (Rate der GoPro: {rate})</translation>
    </message>
    <message>
        <source>its attachments are too large (limit: {most_mb} MB in {files} files)</source>
        <translation>seine Anhänge sind zu groß (Grenze: {most_mb} MB in {files} Dateien)</translation>
    </message>
    <message>
        <source>its beginning is hidden by an edit list, which no copy keeps</source>
        <translation>sein Anfang ist durch eine Schnittliste verborgen, die keine Kopie behält</translation>
    </message>
    <message>
        <source>its gyroscope does not turn as the camera in the frames of the clip</source>
        <translation>sein Gyroskop dreht sich nicht wie die Kamera in den Bildern des Clips</translation>
    </message>
    <message>
        <source>its headers are too large</source>
        <translation>seine Kopfzeilen sind zu groß</translation>
    </message>
    <message>
        <source>its lines end with CR alone</source>
        <translation>seine Zeilen enden nur mit CR</translation>
    </message>
    <message>
        <source>its positions of {axis} go from 0 to 1, but a funscript&apos;s go to 100</source>
        <translation>seine Positionen von {axis} gehen von 0 bis 1, die eines Funscripts aber bis 100</translation>
    </message>
    <message>
        <source>its streams cannot be copied into {kind}</source>
        <translation>seine Spuren können nicht nach {kind} kopiert werden</translation>
    </message>
    <message>
        <source>its telemetry has no usable timestamps and too few payloads ({count}) to tell the rate of its sensors</source>
        <translation>die Telemetrie hat keine brauchbaren Zeitstempel und zu wenige Blöcke ({count}), um die Rate der Sensoren zu bestimmen</translation>
    </message>
    <message>
        <source>its times of {axis} look like seconds, but a funscript&apos;s are milliseconds</source>
        <translation>seine Zeiten von {axis} sehen nach Sekunden aus, aber die eines Funscripts sind Millisekunden</translation>
    </message>
    <message>
        <source>its video ({codec}) holds no motion vectors that can be read</source>
        <translation>sein Video ({codec}) enthält keine lesbaren Bewegungsvektoren</translation>
    </message>
    <message>
        <source>its video cannot be read</source>
        <translation>sein Video kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>kind of event</source>
        <translation>Ereignisart</translation>
    </message>
    <message>
        <source>lacks what is to be exported</source>
        <translation>enthält nicht, was zu exportieren ist</translation>
    </message>
    <message>
        <source>levels, and differences of feedbacks at two levels: Wilcoxon with Holm over all, exact to {most} participants, then an approximation</source>
        <translation>Stufen, und Unterschiede von Feedbacks auf zwei Stufen: Wilcoxon mit Holm über alle, bis {most} Personen exakt, darüber eine Näherung</translation>
    </message>
    <message>
        <source>make another of it with: {command}</source>
        <translation>machen Sie ein anderes daraus mit: {command}</translation>
    </message>
    <message>
        <source>mapping axes must be a rotation (orthogonal, determinant +1)</source>
        <translation>die Achsen der Zuordnung müssen eine Drehung sein (orthogonal, Determinante +1)</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>missing: {names}</source>
        <translation>es fehlen: {names}</translation>
    </message>
    <message>
        <source>motion beside the force was left out ({count})</source>
        <translation>Bewegung neben der Kraft wurde ausgelassen ({count})</translation>
    </message>
    <message>
        <source>motion scene</source>
        <translation>Bewegungsszene</translation>
    </message>
    <message>
        <source>motion without gravity</source>
        <translation>Bewegung ohne Schwerkraft</translation>
    </message>
    <message>
        <source>mounting {text!r} not found; choose one of {known}, or give right, front and up of the wearer in the recorder&apos;s axes</source>
        <translation>es gibt keine Befestigung {text!r}; wählen Sie eine von {known}, oder geben Sie rechts, vorn und oben der Person in den Achsen des Rekorders an</translation>
    </message>
    <message>
        <source>multiply it by {scale:.9g} in the log, or take the taps alone</source>
        <translation>multiplizieren Sie sie im Protokoll mit {scale:.9g}, oder nehmen Sie das Klopfen allein</translation>
    </message>
    <message>
        <source>multiply its positions by 100</source>
        <translation>multiplizieren Sie seine Positionen mit 100</translation>
    </message>
    <message>
        <source>multiply its times by 1000</source>
        <translation>multiplizieren Sie seine Zeiten mit 1000</translation>
    </message>
    <message>
        <source>must be a list of one or more of the choices</source>
        <translation>muss eine Liste mit mindestens einer der möglichen Antworten sein</translation>
    </message>
    <message>
        <source>must be a number from {least} to {most}</source>
        <translation>muss eine Zahl von {least} bis {most} sein</translation>
    </message>
    <message>
        <source>must be at least {limit}</source>
        <translation>muss mindestens {limit} sein</translation>
    </message>
    <message>
        <source>must be at most {limit}</source>
        <translation>darf höchstens {limit} sein</translation>
    </message>
    <message>
        <source>must be between {least} and {most}</source>
        <translation>muss zwischen {least} und {most} liegen</translation>
    </message>
    <message>
        <source>must be the two opposites, at {least} and at {most}</source>
        <translation>müssen die beiden Gegensätze sein, bei {least} und bei {most}</translation>
    </message>
    <message>
        <source>must have 2 to {most} levels, has {count}</source>
        <translation>muss 2 bis {most} Stufen haben, hat {count}</translation>
    </message>
    <message>
        <source>must have 2 to {most} points, has {count}</source>
        <translation>muss 2 bis {most} Punkte haben, hat {count}</translation>
    </message>
    <message>
        <source>must have at least {limit} characters</source>
        <translation>muss mindestens {limit} Zeichen haben</translation>
    </message>
    <message>
        <source>must have at least {limit} entries</source>
        <translation>muss mindestens {limit} Einträge haben</translation>
    </message>
    <message>
        <source>must have at most {limit} characters</source>
        <translation>darf höchstens {limit} Zeichen haben</translation>
    </message>
    <message>
        <source>must have at most {limit} entries</source>
        <translation>darf höchstens {limit} Einträge haben</translation>
    </message>
    <message>
        <source>must have {limit} entries</source>
        <translation>muss {limit} Einträge haben</translation>
    </message>
    <message>
        <source>name of a track, from a file</source>
        <translation>Name einer Spur, aus einer Datei</translation>
    </message>
    <message>
        <source>name: must have 1 to {most} characters in one line</source>
        <translation>name: muss 1 bis {most} Zeichen in einer Zeile haben</translation>
    </message>
    <message>
        <source>names a part of {axes}</source>
        <translation>nennt nur einen Teil von {axes}</translation>
    </message>
    <message>
        <source>needs a second sequence, whose force is felt</source>
        <translation>braucht eine zweite Sequenz, deren Kraft gespürt wird</translation>
    </message>
    <message>
        <source>neither DISPLAY nor WAYLAND_DISPLAY is set</source>
        <translation>weder DISPLAY noch WAYLAND_DISPLAY ist gesetzt</translation>
    </message>
    <message>
        <source>neither a sound server nor a sound card</source>
        <translation>weder ein Tonserver noch eine Soundkarte</translation>
    </message>
    <message>
        <source>no device with such force feedback is plugged in; connect it, and see whether its driver is loaded</source>
        <translation>kein Gerät mit solchem Force-Feedback ist angeschlossen; schließen Sie es an, und prüfen Sie, ob sein Treiber geladen ist</translation>
    </message>
    <message>
        <source>no direction in the file: x {x:.2f}, y {y:.2f}, z {z:.2f}</source>
        <translation>keine Richtung in der Datei: x {x:.2f}, y {y:.2f}, z {z:.2f}</translation>
    </message>
    <message>
        <source>no effect is switched on for this clip; add one to its sequence, or give the name of an edited track</source>
        <translation>für diesen Clip ist kein Effekt eingeschaltet; fügen Sie seiner Sequenz einen hinzu, oder geben Sie den Namen einer bearbeiteten Spur an</translation>
    </message>
    <message>
        <source>no estimated bounce: two halves of the points do not agree on it, or it is wilder than any gait</source>
        <translation>kein geschätztes Auf und Ab: zwei Hälften der Punkte stimmen darin nicht überein, oder es ist heftiger als jede Gangart</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>keine Kraft</translation>
    </message>
    <message>
        <source>no motion can be estimated from its picture ({why})</source>
        <translation>aus seinem Bild lässt sich keine Bewegung schätzen ({why})</translation>
    </message>
    <message>
        <source>no offset is given, which this method needs</source>
        <translation>es ist kein Versatz angegeben, den dieses Verfahren braucht</translation>
    </message>
    <message>
        <source>no trial begins: {device} was lost ({reason})</source>
        <translation>kein Durchgang beginnt: {device} ist ausgefallen ({reason})</translation>
    </message>
    <message>
        <source>nobody feels a simulated device: choose a real one, or allow sessions without one (first page of the study editor)</source>
        <translation>ein simuliertes Gerät spürt niemand: Wählen Sie ein wirkliches, oder erlauben Sie Sitzungen ohne Gerät (erste Seite im Studieneditor)</translation>
    </message>
    <message>
        <source>nobody listens at {address}: start the rig&apos;s software</source>
        <translation>bei {address} hört niemand zu: Starten Sie die Software der Plattform</translation>
    </message>
    <message>
        <source>none on USB</source>
        <translation>keiner am USB</translation>
    </message>
    <message>
        <source>not read: {what} ({count})</source>
        <translation>nicht gelesen: {what} ({count})</translation>
    </message>
    <message>
        <source>nothing is being recorded: {reason}</source>
        <translation>es wird nichts aufgezeichnet: {reason}</translation>
    </message>
    <message>
        <source>nothing takes TCode at {where} any more; connect it and choose the device again</source>
        <translation>an {where} nimmt nichts mehr TCode an; schließen Sie es an und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>offset {offset_s} s with rate {rate} is not a valid clock map; give finite numbers and a positive rate</source>
        <translation>Versatz {offset_s} s mit Rate {rate} ist keine Zuordnung der Uhren; geben Sie endliche Zahlen und eine positive Rate an</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>one gap</source>
        <translation>eine Lücke</translation>
    </message>
    <message>
        <source>only {count} of {total} rows hold both specific force and angular rate</source>
        <translation>nur {count} von {total} Zeilen enthalten spezifische Kraft und Drehrate zugleich</translation>
    </message>
    <message>
        <source>only {count} of {total} times can be used</source>
        <translation>nur {count} von {total} Zeiten sind zu gebrauchen</translation>
    </message>
    <message>
        <source>only {share:.0%} of its samples are whole</source>
        <translation>nur {share:.0%} der Werte sind vollständig</translation>
    </message>
    <message>
        <source>open its sequence first, then the log</source>
        <translation>öffnen Sie zuerst die zugehörige Sequenz, dann das Protokoll</translation>
    </message>
    <message>
        <source>open the video of that name, which lies beside it</source>
        <translation>öffnen Sie das Video dieses Namens, das daneben liegt</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>geöffnet</translation>
    </message>
    <message>
        <source>order {order} has a condition twice</source>
        <translation>Reihenfolge {order} hat eine Bedingung zweimal</translation>
    </message>
    <message>
        <source>order {order} has two trials at position {position}</source>
        <translation>Reihenfolge {order} hat zwei Durchgänge an Stelle {position}</translation>
    </message>
    <message>
        <source>order {order} lacks {conditions}</source>
        <translation>in Reihenfolge {order} fehlt {conditions}</translation>
    </message>
    <message>
        <source>order {order} plays {sequence} twice in a row</source>
        <translation>Reihenfolge {order} spielt {sequence} zweimal hintereinander</translation>
    </message>
    <message>
        <source>other offsets fit nearly as well</source>
        <translation>andere Versätze passen fast ebenso gut</translation>
    </message>
    <message>
        <source>parts of the clip give different offsets</source>
        <translation>Teile des Clips ergeben verschiedene Versätze</translation>
    </message>
    <message>
        <source>port {port} cannot be opened ({reason}); end what listens there</source>
        <translation>Port {port} lässt sich nicht öffnen ({reason}); beenden Sie, was dort zuhört</translation>
    </message>
    <message>
        <source>position lies outside of any clip</source>
        <translation>die Position liegt außerhalb jedes Clips</translation>
    </message>
    <message>
        <source>positions of a hand, for motion devices</source>
        <translation>Positionen einer Hand, für Bewegungsgeräte</translation>
    </message>
    <message>
        <source>positions were taken as the set-point of a spring of {stiffness:.3g} N/m, with the hand at the centre</source>
        <translation>Positionen wurden als Sollwert einer Feder von {stiffness:.3g} N/m genommen, mit der Hand in der Mitte</translation>
    </message>
    <message>
        <source>positions, no newtons</source>
        <translation>Positionen, keine Newton</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>rate-axes={axes} if the gyroscope is {how}</source>
        <translation>rate-axes={axes}, wenn das Gyroskop {how} ist</translation>
    </message>
    <message>
        <source>ratings are shown without the force: {reason}</source>
        <translation>Bewertungen werden ohne die Kraft gezeigt: {reason}</translation>
    </message>
    <message>
        <source>read as {name}: specific force in {unit}</source>
        <translation>gelesen als {name}: spezifische Kraft in {unit}</translation>
    </message>
    <message>
        <source>read by telemetry-parser; its timestamps are those of a mean rate</source>
        <translation>gelesen mit telemetry-parser; die Zeiten entsprechen einer mittleren Rate</translation>
    </message>
    <message>
        <source>read from</source>
        <translation>gelesen</translation>
    </message>
    <message>
        <source>reading records of {code}</source>
        <translation>Aufzeichnungen von {code} werden gelesen</translation>
    </message>
    <message>
        <source>reading the copy</source>
        <translation>Lese die Kopie</translation>
    </message>
    <message>
        <source>reading the sequence</source>
        <translation>Sequenz wird gelesen</translation>
    </message>
    <message>
        <source>reading the sound</source>
        <translation>Ton wird gelesen</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>record again with the gravity sensor</source>
        <translation>nehmen Sie noch einmal mit dem Schwerkraftsensor auf</translation>
    </message>
    <message>
        <source>record at least {least} s</source>
        <translation>nehmen Sie mindestens {least} s auf</translation>
    </message>
    <message>
        <source>record both at once</source>
        <translation>nehmen Sie beide zugleich auf</translation>
    </message>
    <message>
        <source>record damaged</source>
        <translation>Aufzeichnung beschädigt</translation>
    </message>
    <message>
        <source>record normal video</source>
        <translation>nehmen Sie gewöhnliches Video auf</translation>
    </message>
    <message>
        <source>record the gravity sensor (iOS) or total acceleration (Android)</source>
        <translation>nehmen Sie den Schwerkraftsensor (iOS) oder die Gesamtbeschleunigung (Android) auf</translation>
    </message>
    <message>
        <source>record the gyroscope too</source>
        <translation>nehmen Sie auch das Gyroskop auf</translation>
    </message>
    <message>
        <source>record with a camera that stores its motion, or give an IMU log</source>
        <translation>nehmen Sie mit einer Kamera auf, die ihre Bewegung speichert, oder geben Sie ein IMU-Protokoll an</translation>
    </message>
    <message>
        <source>recorded samples</source>
        <translation>aufgezeichnete Messwerte</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>lockere</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>entfernen Sie eine davon</translation>
    </message>
    <message>
        <source>remove or complete the line</source>
        <translation>entfernen oder ergänzen Sie die Zeile</translation>
    </message>
    <message>
        <source>remove the line or correct the number</source>
        <translation>entfernen Sie die Zeile, oder berichtigen Sie die Zahl</translation>
    </message>
    <message>
        <source>remux it to MP4 so that its duration is written</source>
        <translation>packen Sie es in MP4 um, damit die Dauer darin steht</translation>
    </message>
    <message>
        <source>repeat the one before and were left out</source>
        <translation>wiederholen die vorige und wurden weggelassen</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>wiederholt sich</translation>
    </message>
    <message>
        <source>ride</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>row {number}</source>
        <translation>Zeile {number}</translation>
    </message>
    <message>
        <source>run a participant</source>
        <translation>eine Sitzung durchführen</translation>
    </message>
    <message>
        <source>run a participant first</source>
        <translation>lassen Sie erst eine Person teilnehmen</translation>
    </message>
    <message>
        <source>samples have the shape {shape}, expected N x 3</source>
        <translation>die Abtastwerte haben die Form {shape}, erwartet N x 3</translation>
    </message>
    <message>
        <source>sampling must be averaged or instant</source>
        <translation>sampling ist averaged oder instant</translation>
    </message>
    <message>
        <source>save it as text in UTF-8</source>
        <translation>speichern Sie sie als Text in UTF-8</translation>
    </message>
    <message>
        <source>say what it is</source>
        <translation>geben Sie an, was es ist</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>see whether it is switched on</source>
        <translation>prüfen Sie, ob es eingeschaltet ist</translation>
    </message>
    <message>
        <source>see whether the toy is connected and charged</source>
        <translation>sehen Sie nach, ob das Gerät verbunden und geladen ist</translation>
    </message>
    <message>
        <source>sends another part than was asked for</source>
        <translation>sendet einen anderen Teil als verlangt</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>session {code} cannot be used: {what}</source>
        <translation>Sitzung {code} ist nicht zu gebrauchen: {what}</translation>
    </message>
    <message>
        <source>session {code} is {state}</source>
        <translation>Sitzung {code} ist {state}</translation>
    </message>
    <message>
        <source>set up</source>
        <translation>eingerichtet</translation>
    </message>
    <message>
        <source>shaker:{text}: {count} channels need one band, or one each, and each channel once</source>
        <translation>shaker:{text}: {count} Kanäle brauchen ein Band oder je eines, und jeden Kanal einmal</translation>
    </message>
    <message>
        <source>share it without the motion, or copy its folder</source>
        <translation>teilen Sie sie ohne die Bewegung, oder kopieren Sie ihren Ordner</translation>
    </message>
    <message>
        <source>share the time of another and were averaged with it</source>
        <translation>teilen die Zeit mit einer anderen und wurden mit ihr gemittelt</translation>
    </message>
    <message>
        <source>sigma and trust of an estimated motion</source>
        <translation>Sigma und Vertrauen einer geschätzten Bewegung</translation>
    </message>
    <message>
        <source>simulated camera</source>
        <translation>simulierte Kamera</translation>
    </message>
    <message>
        <source>size of the force, every millisecond</source>
        <translation>Betrag der Kraft, jede Millisekunde</translation>
    </message>
    <message>
        <source>smooth noise below 0.5 Hz, with the RMS of the realistic force</source>
        <translation>glattes Rauschen unter 0,5 Hz mit dem Effektivwert der realistischen Kraft</translation>
    </message>
    <message>
        <source>soft_knee_n must be below force_limit_n, got {knee_n} and {limit_n}</source>
        <translation>soft_knee_n muss unter force_limit_n liegen, angegeben sind {knee_n} und {limit_n}</translation>
    </message>
    <message>
        <source>sort the rows by time or cut the recording there</source>
        <translation>sortieren Sie die Zeilen nach der Zeit, oder schneiden Sie die Aufnahme dort</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>sound above {limit_hz} Hz was left out</source>
        <translation>Ton über {limit_hz} Hz wurde weggelassen</translation>
    </message>
    <message>
        <source>sound through PulseAudio or PipeWire</source>
        <translation>Ton über PulseAudio oder PipeWire</translation>
    </message>
    <message>
        <source>specific force is acceleration plus the phone&apos;s gravity estimate</source>
        <translation>die spezifische Kraft ist die Beschleunigung plus die Schwerkraft, wie das Telefon sie angibt</translation>
    </message>
    <message>
        <source>start from a desktop session</source>
        <translation>starten Sie aus einer Desktop-Sitzung</translation>
    </message>
    <message>
        <source>starts at {time_s:.3f} s, but the clip ends at {duration_s:.3f} s</source>
        <translation>beginnt bei {time_s:.3f} s, aber der Clip endet bei {duration_s:.3f} s</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>abgeschaltet</translation>
    </message>
    <message>
        <source>stopped by a button on the grip</source>
        <translation>durch eine Taste am Griff gestoppt</translation>
    </message>
    <message>
        <source>stopped, for the grip is more than 30 mm from the middle</source>
        <translation>gestoppt: der Griff ist mehr als 30 mm von der Mitte entfernt</translation>
    </message>
    <message>
        <source>stopped, for the grip was faster than 0.5 m/s</source>
        <translation>gestoppt: der Griff war schneller als 0,5 m/s</translation>
    </message>
    <message>
        <source>switch the Euler output of the board off and record again</source>
        <translation>schalten Sie die Euler-Ausgabe der Platine ab, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>switch the board to its sensor output (#osct with Razor-AHRS)</source>
        <translation>schalten Sie die Platine auf Sensorausgabe (#osct bei Razor-AHRS)</translation>
    </message>
    <message>
        <source>synchronising by frames is coarse, no motion is suggested from the frames</source>
        <translation>Synchronisieren nach den Bildern ist grob, und aus den Bildern wird keine Bewegung vorgeschlagen</translation>
    </message>
    <message>
        <source>take another sequence, or add &apos;estimated&apos; to feedbacks</source>
        <translation>nehmen Sie eine andere Sequenz, oder fügen Sie &apos;estimated&apos; zu feedbacks hinzu</translation>
    </message>
    <message>
        <source>telemetry is nested deeper than {levels} levels, so it is damaged</source>
        <translation>die Telemetrie ist tiefer als {levels} Ebenen geschachtelt, also beschädigt</translation>
    </message>
    <message>
        <source>template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>text answers</source>
        <translation>Textantworten</translation>
    </message>
    <message>
        <source>the Falcon</source>
        <translation>der Falcon</translation>
    </message>
    <message>
        <source>the Falcon answered none of the frames; home it, try again</source>
        <translation>der Falcon hat auf keine Nachricht geantwortet; referenzieren und noch einmal versuchen</translation>
    </message>
    <message>
        <source>the Falcon could not be {done} ({reason}); unplug it and plug it in again</source>
        <translation>der Falcon konnte nicht {done} werden ({reason}); ziehen Sie ihn ab und stecken Sie ihn wieder an</translation>
    </message>
    <message>
        <source>the Falcon did not answer after the silence; try again</source>
        <translation>der Falcon hat nach der Pause nicht geantwortet; noch einmal versuchen</translation>
    </message>
    <message>
        <source>the Falcon did not start in {attempts} attempts (the last: {reason}); unplug its power and USB, plug both in, if you can without a hub, and try again</source>
        <translation>der Falcon ist in {attempts} Versuchen nicht gestartet (zuletzt: {reason}); ziehen Sie Netzteil und USB ab, stecken Sie beide wieder an, möglichst ohne Hub, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the Falcon does not answer any more; unplug its power and USB, and plug both in</source>
        <translation>der Falcon antwortet nicht mehr; ziehen Sie Netzteil und USB ab, und stecken Sie beide wieder an</translation>
    </message>
    <message>
        <source>the Falcon does not answer; unplug its power and USB, and plug both in</source>
        <translation>der Falcon antwortet nicht; ziehen Sie Netzteil und USB ab, und stecken Sie beide wieder an</translation>
    </message>
    <message>
        <source>the Falcon has a driver that keeps libusb out; give it the driver WinUSB (with the program Zadig) in place of FTDI&apos;s or Force Dimension&apos;s</source>
        <translation>der Falcon hat einen Treiber, der libusb aussperrt; geben Sie ihm den Treiber WinUSB (mit dem Programm Zadig) statt dem von FTDI oder Force Dimension</translation>
    </message>
    <message>
        <source>the Falcon is in use by another program; close that one and try again</source>
        <translation>der Falcon wird von einem anderen Programm benutzt; schließen Sie es, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the Falcon is not open; choose the device again</source>
        <translation>der Falcon ist nicht geöffnet; wählen Sie das Gerät noch einmal</translation>
    </message>
    <message>
        <source>permission denied for the Falcon; copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and plug it in</source>
        <translation>Sie dürfen den Falcon nicht benutzen; kopieren Sie die udev-Regel {rule} nach /etc/udev/rules.d, ziehen Sie den Falcon dann ab und stecken Sie ihn wieder an</translation>
    </message>
    <message>
        <source>the Falcon was not homed within {limit_s:.0f} s; pull the grip all the way out, push it all the way in until it locks, and try again</source>
        <translation>der Falcon hat in {limit_s:.0f} s seine Nullstellung nicht gefunden; ziehen Sie den Griff ganz heraus, schieben Sie ihn ganz hinein, bis er einrastet, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the Falcon was unplugged, or its cable is loose; plug it in and choose the device again</source>
        <translation>der Falcon wurde abgezogen, oder sein Kabel ist lose; stecken Sie ihn an, und wählen Sie das Gerät noch einmal</translation>
    </message>
    <message>
        <source>the Falcon&apos;s position has jumped and stayed away; home it again, then choose the device again</source>
        <translation>die Position des Falcon ist gesprungen und weggeblieben; lassen Sie ihn seine Nullstellung neu finden, und wählen Sie das Gerät dann noch einmal</translation>
    </message>
    <message>
        <source>the IMU&apos;s axes</source>
        <translation>Achsen der IMU</translation>
    </message>
    <message>
        <source>the Inverse3 is not open; choose the device again</source>
        <translation>das Inverse3 ist nicht geöffnet; wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the angular rate is zero throughout, so no rotation is assumed</source>
        <translation>die Drehrate ist durchweg null, es wird also keine Drehung angenommen</translation>
    </message>
    <message>
        <source>the angular rate reaches {largest:.3g} rad/s when it is read in {rate_unit}, which no sensor shows</source>
        <translation>die Drehrate erreicht {largest:.3g} rad/s, wenn sie in {rate_unit} gelesen wird, was kein Sensor zeigt</translation>
    </message>
    <message>
        <source>the answer could not be saved ({reason})</source>
        <translation>die Antwort konnte nicht gespeichert werden ({reason})</translation>
    </message>
    <message>
        <source>the answer ended early</source>
        <translation>die Antwort endete zu früh</translation>
    </message>
    <message>
        <source>the axes {text!r} mirror the motion; change one sign</source>
        <translation>die Achsen {text!r} spiegeln die Bewegung; kehren Sie ein Vorzeichen um</translation>
    </message>
    <message>
        <source>the board&apos;s axes</source>
        <translation>Achsen der Platine</translation>
    </message>
    <message>
        <source>the calibration is of {theirs}, the recording of {ours}; a calibration helps only if both are one sensor</source>
        <translation>die Kalibrierung ist von {theirs}, die Aufnahme von {ours}; eine Kalibrierung hilft nur, wenn beide von demselben Sensor sind</translation>
    </message>
    <message>
        <source>the camera rotates too slowly to show the time</source>
        <translation>Die Kamera dreht sich zu langsam, um die Zeit zu zeigen</translation>
    </message>
    <message>
        <source>the chip&apos;s axes</source>
        <translation>Achsen des Chips</translation>
    </message>
    <message>
        <source>the computer stalled repeatedly; close other programs, measure again</source>
        <translation>der Rechner stockte wiederholt; andere Programme schließen und noch einmal messen</translation>
    </message>
    <message>
        <source>the cutoff</source>
        <translation>die Grenzfrequenz</translation>
    </message>
    <message>
        <source>the device is not homed or not ready; set it up first</source>
        <translation>das Gerät ist nicht referenziert oder nicht bereit; richten Sie es zuerst ein</translation>
    </message>
    <message>
        <source>the device is not open; choose the device again</source>
        <translation>das Gerät ist nicht geöffnet; wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the excursion that a normal hand would make; no newtons</source>
        <translation>die Auslenkung, die eine normale Hand machen würde; keine Newton</translation>
    </message>
    <message>
        <source>the experiment was paused; its clock skips the pause</source>
        <translation>das Experiment wurde angehalten; seine Uhr lief ohne die Pause weiter</translation>
    </message>
    <message>
        <source>the file ends at byte {size_bytes} but its header promises {promised_bytes}</source>
        <translation>die Datei endet bei Byte {size_bytes}, ihr Kopf verspricht aber {promised_bytes}</translation>
    </message>
    <message>
        <source>the file ends at byte {size_bytes} but its index needs {indexed_bytes}</source>
        <translation>die Datei endet bei Byte {size_bytes}, ihr Index braucht aber {indexed_bytes}</translation>
    </message>
    <message>
        <source>the file was removed</source>
        <translation>die Datei wurde entfernt</translation>
    </message>
    <message>
        <source>the firmware was loaded and does not answer</source>
        <translation>die Firmware wurde geladen und antwortet nicht</translation>
    </message>
    <message>
        <source>the firmware&apos;s axes: x forward, y right, z down</source>
        <translation>Achsen der Firmware: x vorn, y rechts, z unten</translation>
    </message>
    <message>
        <source>the folder was replaced</source>
        <translation>der Ordner wurde ersetzt</translation>
    </message>
    <message>
        <source>the force in newtons at every millisecond</source>
        <translation>die Kraft in Newton zu jeder Millisekunde</translation>
    </message>
    <message>
        <source>the force in newtons on three axes, within the tolerance</source>
        <translation>die Kraft in Newton auf drei Achsen, innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>the force in newtons, at the sample rate</source>
        <translation>die Kraft in Newton, mit der Abtastrate</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms ahead of the sound: the computer may be overloaded; close other programs</source>
        <translation>die Kraft ist dem Ton {ms:.0f} ms voraus: Der Rechner ist vielleicht überlastet; schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms ahead of the video: the computer may be overloaded; close other programs</source>
        <translation>die Kraft kommt {ms:.0f} ms vor dem Video: der Rechner ist möglicherweise überlastet; schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms behind the sound: the computer may be overloaded; close other programs</source>
        <translation>die Kraft kommt {ms:.0f} ms nach dem Ton: der Rechner ist möglicherweise überlastet; schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms behind the video: the computer may be overloaded; close other programs</source>
        <translation>die Kraft kommt {ms:.0f} ms nach dem Video: der Rechner ist möglicherweise überlastet; schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>the force of a motion that was estimated from the picture</source>
        <translation>die Kraft einer Bewegung, die aus dem Bild geschätzt wurde</translation>
    </message>
    <message>
        <source>the force of the recorded motion</source>
        <translation>die Kraft der aufgezeichneten Bewegung</translation>
    </message>
    <message>
        <source>the force track goes from {first_s:.6g} s to {last_s:.6g} s, the clip to {duration_s:.6g} s</source>
        <translation>die Kraftspur reicht von {first_s:.6g} s bis {last_s:.6g} s, der Clip bis {duration_s:.6g} s</translation>
    </message>
    <message>
        <source>the force track was rejected: {reason}</source>
        <translation>die Kraftspur wurde abgelehnt: {reason}</translation>
    </message>
    <message>
        <source>the format of {name!r} is unknown; choose one of {known}</source>
        <translation>das Format von {name!r} ist unbekannt; wählen Sie eines von {known}</translation>
    </message>
    <message>
        <source>the gyro explains {explained:.0%} of their rotation (video stabilised, or a calm camera)</source>
        <translation>Das Gyroskop erklärt {explained:.0%} ihrer Drehung (Video stabilisiert oder Kamera ruhig)</translation>
    </message>
    <message>
        <source>the motion of {key!r} was estimated from the picture, nothing measured it</source>
        <translation>die Bewegung von {key!r} wurde aus dem Bild geschätzt, nichts hat sie gemessen</translation>
    </message>
    <message>
        <source>the motion of {title} was estimated from the picture, so there is no realistic feedback to make {name!r} of</source>
        <translation>die Bewegung von {title} wurde aus dem Bild geschätzt, deshalb gibt es kein realistisches Feedback, aus dem {name!r} entstehen könnte</translation>
    </message>
    <message>
        <source>the motion was estimated from the picture, nothing measured it: its strength is a guess, and studies refuse it unless they name the feedback &apos;estimated&apos;</source>
        <translation>die Bewegung wurde aus dem Bild geschätzt, nichts hat sie gemessen: ihre Stärke ist geraten, und Studien lehnen sie ab, wenn sie das Feedback &apos;estimated&apos; nicht nennen</translation>
    </message>
    <message>
        <source>the realistic force with the effects of the sequence on it</source>
        <translation>die realistische Kraft mit den Effekten der Sequenz</translation>
    </message>
    <message>
        <source>the recording is incomplete: the disk at {disk} is full, or the file has reached its size limit</source>
        <translation>die Aufnahme ist unvollständig: Der Datenträger bei {disk} ist voll, oder die Datei hat ihre Höchstgröße erreicht</translation>
    </message>
    <message>
        <source>the rig at {address} cannot be reached ({reason}); check address and network, and choose the device again</source>
        <translation>die Plattform bei {address} ist nicht erreichbar ({reason}); prüfen Sie Adresse und Netz und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the rig is not open; choose the device again</source>
        <translation>die Plattform ist nicht geöffnet; wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the rotation of its gyroscope does not match that of gravity in its accelerometer: their axes or signs differ</source>
        <translation>die Drehung seines Gyroskops passt nicht zu der der Schwerkraft in seinem Beschleunigungssensor: Achsen oder Vorzeichen sind verschieden</translation>
    </message>
    <message>
        <source>the rows, of which the newest came first, were put in order</source>
        <translation>die Zeilen, deren neueste zuerst kam, wurden geordnet</translation>
    </message>
    <message>
        <source>the shaker is not open; choose the device again</source>
        <translation>der Shaker ist nicht geöffnet; wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the simulated service has ended; choose the device again to start a new one</source>
        <translation>der simulierte Dienst ist beendet; wählen Sie das Gerät erneut, um einen neuen zu starten</translation>
    </message>
    <message>
        <source>the sound card {card!r} cannot be opened with {count} channels: {reason}; choose another card or profile</source>
        <translation>die Soundkarte {card!r} kann nicht mit {count} Kanälen geöffnet werden: {reason}; wählen Sie eine andere Karte oder ein anderes Profil</translation>
    </message>
    <message>
        <source>the track needs more than {most} keyframes</source>
        <translation>die Spur braucht mehr als {most} Keyframes</translation>
    </message>
    <message>
        <source>their rotation is not that of the gyro</source>
        <translation>ihre Drehung ist nicht die des Gyroskops</translation>
    </message>
    <message>
        <source>turn the volume up</source>
        <translation>drehen Sie die Lautstärke auf</translation>
    </message>
    <message>
        <source>up and down</source>
        <translation>Auf und Ab</translation>
    </message>
    <message>
        <source>update or restart it</source>
        <translation>aktualisieren Sie es, oder starten Sie es neu</translation>
    </message>
    <message>
        <source>use a record of the haptic loop</source>
        <translation>verwenden Sie eine Aufzeichnung der haptischen Schleife</translation>
    </message>
    <message>
        <source>use the taps, or enter the offset</source>
        <translation>nehmen Sie das Klopfen, oder geben Sie den Versatz ein</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>vibration of {hertz:g} Hz along x {x:.2f}, y {y:.2f}, z {z:.2f}: strength 100 was taken as {full_n:.3g} N</source>
        <translation>Vibration mit {hertz:g} Hz entlang x {x:.2f}, y {y:.2f}, z {z:.2f}: Stärke 100 wurde als {full_n:.3g} N genommen</translation>
    </message>
    <message>
        <source>wait for it</source>
        <translation>warten Sie darauf</translation>
    </message>
    <message>
        <source>wait until it is ready, or choose it again</source>
        <translation>warten Sie, bis es bereit ist, oder wählen Sie es noch einmal</translation>
    </message>
    <message>
        <source>when each trial and interruption was</source>
        <translation>wann jeder Durchgang und jede Unterbrechung war</translation>
    </message>
    <message>
        <source>write one from a long log</source>
        <translation>schreiben Sie eine aus einem langen Protokoll</translation>
    </message>
    <message>
        <source>{axis}: its actions are null</source>
        <translation>{axis}: seine Aktionen sind null</translation>
    </message>
    <message>
        <source>{clip}: its frames show the mounting {axes} (ratio {ratio:.1f}), not {used}; take it, or keep the axes of the log</source>
        <translation>{clip}: Die Bilder zeigen die Befestigung {axes} (Verhältnis {ratio:.1f}), nicht {used}; übernehmen Sie sie, oder behalten Sie die Achsen des Protokolls</translation>
    </message>
    <message>
        <source>{clip}: motion is estimated as the video plays</source>
        <translation>{clip}: Die Bewegung wird so geschätzt, wie das Video läuft</translation>
    </message>
    <message>
        <source>{clip}: taps and frames cannot be compared at another speed; enter the offset, too</source>
        <translation>{clip}: Klopfen und Bilder lassen sich bei anderer Geschwindigkeit nicht vergleichen; geben Sie auch den Versatz ein</translation>
    </message>
    <message>
        <source>{clip}: the frames do not tell whether the mounting is {axes} or {next_best} (ratio {ratio:.2f}); {give}</source>
        <translation>{clip}: Die Bilder lassen offen, ob die Befestigung {axes} oder {next_best} ist (Verhältnis {ratio:.2f}); {give}</translation>
    </message>
    <message>
        <source>{clip}: by its frames the mounting is {axes}, but by gravity another side is up; is the video upright and not mirrored? Otherwise {give}</source>
        <translation>{clip}: Die Bilder ergeben die Befestigung {axes}, die Schwerkraft aber eine andere Seite oben; steht das Video aufrecht und ist es nicht gespiegelt? Sonst: {give}</translation>
    </message>
    <message>
        <source>{look}; {brings}</source>
        <translation>{look}; {brings}</translation>
    </message>
    <message>
        <source>{name} holds no motion; choose one of {known}</source>
        <translation>{name} enthält keine Bewegung; wählen Sie {known}</translation>
    </message>
    <message>
        <source>{text!r} is not a rotation; give nine numbers, row by row, with rows of length 1 at right angles and determinant +1</source>
        <translation>{text!r} ist keine Drehung; geben Sie neun Zahlen an, Zeile für Zeile, mit Zeilen der Länge 1, rechtwinklig zueinander, und Determinante +1</translation>
    </message>
    <message>
        <source>{text!r} must be a time in s and a value</source>
        <translation>{text!r} muss eine Zeit in s und ein Wert sein</translation>
    </message>
    <message>
        <source>{title} does not answer at {url}; start it and choose the device again</source>
        <translation>{title} antwortet nicht an {url}; starten Sie es und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>{title} has closed the connection; start it and choose the device again</source>
        <translation>{title} hat die Verbindung geschlossen; starten Sie es und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>{what} {name!r} not found; choose one of {known}</source>
        <translation>{what} {name!r} nicht gefunden; wählen Sie eines davon: {known}</translation>
    </message>
    <message>
        <source>{where} cannot be opened: {reason}; see whether the board is connected and you may use it</source>
        <translation>{where} kann nicht geöffnet werden: {reason}; prüfen Sie, ob die Platine angeschlossen ist und Sie sie benutzen dürfen</translation>
    </message>
    <message>
        <source>{where} reports an error ({reason}); {remedy}, and choose the device again</source>
        <translation>{where} meldet einen Fehler ({reason}); {remedy}, und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>{who} reports the error {code}; look at it in Haply&apos;s own program, and choose the device again</source>
        <translation>{who} meldet den Fehler {code}; sehen Sie in Haplys eigenem Programm nach, und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>{word!r} is unknown; use {known}</source>
        <translation>{word!r} ist unbekannt; verwenden Sie {known}</translation>
    </message>
    <message>
        <source>the grip did not give way to 1 N; hold it more loosely</source>
        <translation>der Griff gab bei 1 N nicht nach; lockerer halten</translation>
    </message>
    <message>
        <source>has no header row (t,gx,gy,gz,ax,ay,az) below its keys</source>
        <translation>hat unter den Schlüsseln keine Kopfzeile (t,gx,gy,gz,ax,ay,az)</translation>
    </message>
    <message>
        <source>has only {rate_hz:.1f} samples per second, too few for taps</source>
        <translation>hat nur {rate_hz:.1f} Werte je Sekunde, in denen sich Klopfen nicht zeigt</translation>
    </message>
    <message>
        <source>hold the grip, or lower the gain</source>
        <translation>halten Sie den Griff fest, oder senken Sie die Verstärkung</translation>
    </message>
    <message>
        <source>holds a file that is named like another part of it, {name!r}</source>
        <translation>enthält eine Datei, die wie ein anderer Teil heißt, {name!r}</translation>
    </message>
    <message>
        <source>holds a level twice</source>
        <translation>enthält eine Stufe zweimal</translation>
    </message>
    <message>
        <source>holds half a character</source>
        <translation>enthält ein halbes Zeichen</translation>
    </message>
    <message>
        <source>holds telemetry of {maker}</source>
        <translation>enthält Telemetrie von {maker}</translation>
    </message>
    <message>
        <source>holds {held}; columns of gyro and accelerometer are needed (t,gx,gy,gz,ax,ay,az)</source>
        <translation>enthält {held}; nötig sind Spalten von Gyroskop und Beschleunigungssensor (t,gx,gy,gz,ax,ay,az)</translation>
    </message>
    <message>
        <source>holds {what} (.{part}), which are not read</source>
        <translation>enthält {what} (.{part}), die nicht gelesen werden</translation>
    </message>
    <message>
        <source>if these are a magnetometer&apos;s readings, give those of the accelerometer; else give the specific force in m/s^2, about 9.8 at rest</source>
        <translation>sind es Werte eines Magnetometers, geben Sie die des Beschleunigungssensors an; sonst geben Sie die spezifische Kraft in m/s^2 an, etwa 9.8 in Ruhe</translation>
    </message>
    <message>
        <source>in swapped columns</source>
        <translation>in vertauschten Spalten</translation>
    </message>
    <message>
        <source>invalid force track</source>
        <translation>Kraftspur ungültig</translation>
    </message>
    <message>
        <source>is JSON, not a table</source>
        <translation>ist JSON, keine Tabelle</translation>
    </message>
    <message>
        <source>is XML or a web page, not a table</source>
        <translation>ist XML oder eine Webseite, keine Tabelle</translation>
    </message>
    <message>
        <source>is a session of the study {found}, not {expected}</source>
        <translation>ist eine Sitzung der Studie {found}, nicht {expected}</translation>
    </message>
    <message>
        <source>is a table with {count} columns of numbers, fewer than time and acceleration need; these columns hold text: {shown}</source>
        <translation>ist eine Tabelle mit {count} Zahlenspalten, weniger als Zeit und Beschleunigung brauchen; diese Spalten enthalten Text: {shown}</translation>
    </message>
    <message>
        <source>is not the video that its force was made for ({reason})</source>
        <translation>ist nicht das Video, für das die Kraft berechnet wurde ({reason})</translation>
    </message>
    <message>
        <source>is not used in {kind} questions</source>
        <translation>wird in Fragen der Art {kind} nicht verwendet</translation>
    </message>
    <message>
        <source>is not used in {kind} trials</source>
        <translation>wird in Durchgängen der Art {kind} nicht verwendet</translation>
    </message>
    <message>
        <source>the Falcon is not homed; home it</source>
        <translation>der Falcon ist nicht referenziert; referenzieren Sie ihn</translation>
    </message>
    <message>
        <source>the Falcon&apos;s firmware is missing ({path}); it may not be passed on with this program: take nvent_firmware.bin from a libnifalcon source archive and install it: Device &gt; Set up the device</source>
        <translation>die Firmware des Falcon fehlt ({path}); sie darf mit diesem Programm nicht weitergegeben werden: Nehmen Sie nvent_firmware.bin aus einem Quellarchiv von libnifalcon, und installieren Sie sie: Gerät &gt; Gerät einrichten</translation>
    </message>
    <message>
        <source>the analysis of {kind} trials is missing; install the extension that has it, or export the answers</source>
        <translation>die Auswertung für Durchgänge der Art {kind} fehlt; installieren Sie die Erweiterung, die sie enthält, oder exportieren Sie die Antworten</translation>
    </message>
    <message>
        <source>the board at {where} has restarted ({said}); check its supply and cable</source>
        <translation>die Platine an {where} hat neu gestartet ({said}); prüfen Sie Netzteil und Kabel</translation>
    </message>
    <message>
        <source>the board at {where} reports an error ({said}); check its channel, cable and supply, and choose the device again</source>
        <translation>die Platine an {where} meldet einen Fehler ({said}); prüfen Sie Kanal, Kabel und Netzteil, und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the buttons of the wireless grip cannot be read; stop with Esc, and look at the grip in Haply&apos;s own program</source>
        <translation>die Tasten des kabellosen Griffs lassen sich nicht lesen; halten Sie mit Esc an, und sehen Sie in Haplys eigenem Programm nach dem Griff</translation>
    </message>
    <message>
        <source>the column {name!r} is not of a force</source>
        <translation>die Spalte {name!r} gehört nicht zu einer Kraft</translation>
    </message>
    <message>
        <source>the first sudden rise of sound and motion is uncertain</source>
        <translation>der erste plötzliche Anstieg von Ton und Bewegung ist unsicher</translation>
    </message>
    <message>
        <source>the force of another clip needs its sequence: choose its folder</source>
        <translation>die Kraft eines anderen Clips braucht dessen Sequenz: Wählen Sie deren Ordner</translation>
    </message>
    <message>
        <source>the guard did not start, so nothing is measured; run &apos;hapticplayer doctor&apos;</source>
        <translation>der Wächter ist nicht gestartet, daher wird nichts gemessen; &apos;hapticplayer doctor&apos; ausführen</translation>
    </message>
    <message>
        <source>the guard has ended; measure again</source>
        <translation>der Wächter ist beendet; noch einmal messen</translation>
    </message>
    <message>
        <source>the haptics process could not be started: {reason}</source>
        <translation>der Haptikprozess konnte nicht gestartet werden: {reason}</translation>
    </message>
    <message>
        <source>the header is {header!r}</source>
        <translation>der Kopf ist {header!r}</translation>
    </message>
    <message>
        <source>the largest angular rate is {largest:.3g} rad/s</source>
        <translation>die größte Drehrate ist {largest:.3g} rad/s</translation>
    </message>
    <message>
        <source>the largest number of participants must be between 3 and {most}</source>
        <translation>die größte Zahl von Teilnehmenden muss zwischen 3 und {most} liegen</translation>
    </message>
    <message>
        <source>the legs cannot be assembled at these joint angles</source>
        <translation>bei diesen Gelenkwinkeln lassen sich die Beine nicht zusammensetzen</translation>
    </message>
    <message>
        <source>the letter A</source>
        <translation>dem Buchstaben A</translation>
    </message>
    <message>
        <source>the list of orders is empty</source>
        <translation>die Liste der Reihenfolgen ist leer</translation>
    </message>
    <message>
        <source>the log cannot be written ({reason})</source>
        <translation>das Protokoll kann nicht geschrieben werden ({reason})</translation>
    </message>
    <message>
        <source>the log has no timestamps: 50 frames per second are assumed</source>
        <translation>das Protokoll hat keine Zeiten: Es werden 50 Werte je Sekunde angenommen</translation>
    </message>
    <message>
        <source>the log is not synchronised: its clock is taken as media time; enter the offset</source>
        <translation>das Protokoll ist nicht synchronisiert: Seine Uhr gilt als Medienzeit; geben Sie den Versatz ein</translation>
    </message>
    <message>
        <source>the low-pass has no heading; choose one of ekf, vqf</source>
        <translation>der Tiefpass kennt keine Richtung; wählen Sie ekf oder vqf</translation>
    </message>
    <message>
        <source>the magnetometer was left out: {count} of {total} samples are empty</source>
        <translation>das Magnetometer wurde weggelassen: {count} von {total} Werten sind leer</translation>
    </message>
    <message>
        <source>the motion cannot be separated from gravity</source>
        <translation>die Bewegung lässt sich nicht von der Schwerkraft trennen</translation>
    </message>
    <message>
        <source>the motion covers {first_s:.1f} to {last_s:.1f} s of media time, but the clip lasts from 0 to {duration_s:.1f} s</source>
        <translation>die Bewegung reicht von {first_s:.1f} bis {last_s:.1f} s Medienzeit, aber der Clip dauert von 0 bis {duration_s:.1f} s</translation>
    </message>
    <message>
        <source>the motion covers {first_s:.1f} to {last_s:.1f} s of the clip&apos;s {duration_s:.1f} s; there is no force outside</source>
        <translation>die Bewegung reicht von {first_s:.1f} bis {last_s:.1f} s der {duration_s:.1f} s des Clips; außerhalb gibt es keine Kraft</translation>
    </message>
    <message>
        <source>the motion of {name} was recorded, which is better than an estimate from the picture; import it without an estimate</source>
        <translation>die Bewegung von {name} wurde aufgezeichnet, und das ist besser als eine Schätzung aus dem Bild; importieren Sie es ohne Schätzung</translation>
    </message>
    <message>
        <source>the motion track is empty, so there is no force to render</source>
        <translation>die Bewegungsspur ist leer, es gibt also keine Kraft zu berechnen</translation>
    </message>
    <message>
        <source>the motion where it is not valid</source>
        <translation>die Bewegung, wo sie nicht gültig ist</translation>
    </message>
    <message>
        <source>the norm of the specific force is {norm:.3g} where it is calmest, but gravity is {gravity:.3g} m/s^2</source>
        <translation>der Betrag der spezifischen Kraft ist {norm:.3g}, wo sie am ruhigsten ist, aber die Schwerkraft ist {gravity:.3g} m/s^2</translation>
    </message>
    <message>
        <source>the number of samples is {count}; {least} to {most} can be used</source>
        <translation>die Zahl der Werte ist {count}; {least} bis {most} sind zu gebrauchen</translation>
    </message>
    <message>
        <source>the number of simulated studies must be between {least} and {most}</source>
        <translation>die Zahl der simulierten Studien muss zwischen {least} und {most} liegen</translation>
    </message>
    <message>
        <source>the other axes are in {names}</source>
        <translation>die anderen Achsen sind in {names}</translation>
    </message>
    <message>
        <source>the other clip has a force track of a single row</source>
        <translation>die Kraftspur des anderen Clips hat nur eine Zeile</translation>
    </message>
    <message>
        <source>the other clip has no force along an axis that this one uses</source>
        <translation>der andere Clip hat keine Kraft entlang einer Achse, die dieser nutzt</translation>
    </message>
    <message>
        <source>the output {name} appears twice</source>
        <translation>die Ausgabe {name} kommt zweimal vor</translation>
    </message>
    <message>
        <source>the phone&apos;s axes: x right, y top, z out of the screen</source>
        <translation>Achsen des Telefons: x rechts, y oben, z aus dem Bildschirm</translation>
    </message>
    <message>
        <source>the range of {range:g} % was not applied: 0 to 100 is the whole way</source>
        <translation>der Bereich (range) von {range:g} % wurde nicht angewendet: 0 bis 100 ist der ganze Weg</translation>
    </message>
    <message>
        <source>the rate</source>
        <translation>die Rate</translation>
    </message>
    <message>
        <source>the realistic force in the opposite direction</source>
        <translation>die realistische Kraft in Gegenrichtung</translation>
    </message>
    <message>
        <source>the realistic force of another clip, with the RMS of this one</source>
        <translation>die realistische Kraft eines anderen Clips mit dem Effektivwert von diesem</translation>
    </message>
    <message>
        <source>the realistic force, later than the picture</source>
        <translation>die realistische Kraft, später als das Bild</translation>
    </message>
    <message>
        <source>the realistic force, stronger or weaker</source>
        <translation>die realistische Kraft, stärker oder schwächer</translation>
    </message>
    <message>
        <source>the record cannot be written ({reason})</source>
        <translation>die Aufzeichnung kann nicht geschrieben werden ({reason})</translation>
    </message>
    <message>
        <source>the recording contradicts the calibration, which was not used: it is of another sensor, or too old</source>
        <translation>die Aufnahme widerspricht der Kalibrierung, die deshalb nicht verwendet wurde: sie ist von einem anderen Sensor oder zu alt</translation>
    </message>
    <message>
        <source>the recording has no end: it was truncated, or is still being written</source>
        <translation>die Aufzeichnung hat kein Ende: sie ist abgeschnitten oder wird noch geschrieben</translation>
    </message>
    <message>
        <source>the recording has no magnetometer to find the heading with</source>
        <translation>die Aufnahme hat kein Magnetometer für die Richtung</translation>
    </message>
    <message>
        <source>the recording is incomplete: its file could not be written</source>
        <translation>die Aufnahme ist unvollständig: ihre Datei konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the recording is incomplete: its file was removed</source>
        <translation>die Aufnahme ist unvollständig: ihre Datei wurde gelöscht</translation>
    </message>
    <message>
        <source>the recording is incomplete: its process ended with status {status}</source>
        <translation>die Aufnahme ist unvollständig: ihr Prozess endete mit Status {status}</translation>
    </message>
    <message>
        <source>the recording is incomplete: the disk is too slow</source>
        <translation>die Aufnahme ist unvollständig: der Datenträger ist zu langsam</translation>
    </message>
    <message>
        <source>the sampling rate changes over the recording, {change}</source>
        <translation>die Abtastrate ändert sich in der Aufnahme, {change}</translation>
    </message>
    <message>
        <source>the scale of {key} is damaged ({scale})</source>
        <translation>der Maßstab von {key} ist beschädigt ({scale})</translation>
    </message>
    <message>
        <source>the second half could not be drawn ({reason})</source>
        <translation>die zweite Hälfte konnte nicht gezeichnet werden ({reason})</translation>
    </message>
    <message>
        <source>the sensor rotated so much that gravity does not show its axes</source>
        <translation>der Sensor drehte sich so sehr, dass die Schwerkraft seine Achsen nicht zeigt</translation>
    </message>
    <message>
        <source>the sensor&apos;s axes</source>
        <translation>die Achsen des Sensors</translation>
    </message>
    <message>
        <source>the sequence {key!r} has changed since this session began</source>
        <translation>die Sequenz {key!r} hat sich geändert, seit diese Sitzung begann</translation>
    </message>
    <message>
        <source>the sequence {key!r} has no folder with a sequence</source>
        <translation>zur Sequenz {key!r} gibt es keinen Ordner mit einer Sequenz</translation>
    </message>
    <message>
        <source>the simulated Falcon did not answer within {patience_s:.0f} s; try again, and run &apos;hapticplayer doctor&apos; if it stays so</source>
        <translation>der simulierte Falcon hat in {patience_s:.0f} s nicht geantwortet; versuchen Sie es noch einmal, und rufen Sie „hapticplayer doctor“ auf, wenn es so bleibt</translation>
    </message>
    <message>
        <source>the simulated Falcon was unplugged: its process has ended; choose the device again to start a new one</source>
        <translation>der simulierte Falcon wurde abgezogen: Sein Prozess ist beendet; wählen Sie das Gerät noch einmal, um einen neuen zu starten</translation>
    </message>
    <message>
        <source>the size of the force and its frequency; no direction</source>
        <translation>Betrag der Kraft und ihre Frequenz; keine Richtung</translation>
    </message>
    <message>
        <source>the smoother has no heading; choose one of ekf, vqf, offline-vqf for it</source>
        <translation>der Glätter kennt keine Richtung; wählen Sie dafür ekf, vqf oder offline-vqf</translation>
    </message>
    <message>
        <source>the sound has the shape {shape}, expected (n, 1) or (n, 2)</source>
        <translation>der Ton hat die Form {shape}, erwartet wird (n, 1) oder (n, 2)</translation>
    </message>
    <message>
        <source>the sound holds values that are not finite</source>
        <translation>der Ton enthält Werte, die nicht endlich sind</translation>
    </message>
    <message>
        <source>the sound is silent</source>
        <translation>der Ton ist stumm</translation>
    </message>
    <message>
        <source>the specific force is {norm:.3g} m/s2 at rest when read in {accel_unit}, but gravity is 9.81</source>
        <translation>die spezifische Kraft ist in Ruhe {norm:.3g} m/s2, wenn sie in {accel_unit} gelesen wird, aber die Schwerkraft ist 9.81</translation>
    </message>
    <message>
        <source>the study requires a device: choose it above</source>
        <translation>die Studie verlangt ein Gerät: Wählen Sie es oben</translation>
    </message>
    <message>
        <source>the time stamps jitter by {share:.0f} % of an interval; an even clock fitted to them was used</source>
        <translation>die Zeitstempel schwanken um {share:.0f} % eines Abtastintervalls; ein daran angepasster gleichmäßiger Takt wurde verwendet</translation>
    </message>
    <message>
        <source>the time {fault} ({time_s} s after {last_s} s)</source>
        <translation>die Zeit {fault} ({time_s} s nach {last_s} s)</translation>
    </message>
    <message>
        <source>the track ends at {end_s:.4g} s, after the longest clip ({most_s:.0f} s)</source>
        <translation>die Spur endet bei {end_s:.4g} s, nach dem längsten Clip ({most_s:.0f} s)</translation>
    </message>
    <message>
        <source>the track is too long for this format</source>
        <translation>die Spur ist zu lang für dieses Format</translation>
    </message>
    <message>
        <source>the track needs {count} positions (limit: {most})</source>
        <translation>die Spur braucht {count} Positionen (Grenze: {most})</translation>
    </message>
    <message>
        <source>the wavelet stream is not base64</source>
        <translation>der Wavelet-Strom ist kein Base64</translation>
    </message>
    <message>
        <source>the process was killed (exit status {status}), perhaps for want of memory; nothing was written</source>
        <translation>die Arbeit wurde von außen beendet (Status {status}), vielleicht aus Mangel an Arbeitsspeicher; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>a track {name!r} exists; choose another name</source>
        <translation>eine Spur {name!r} gibt es schon; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>there is no effect {name!r}; there is paper, none, or a share of the paper&apos;s effect such as 0.5</source>
        <translation>der Effekt {name!r} ist unbekannt; es gibt paper, none oder einen Anteil des Effekts wie 0.5</translation>
    </message>
    <message>
        <source>there is no header, the file begins with numbers</source>
        <translation>es gibt keinen Kopf, die Datei beginnt mit Zahlen</translation>
    </message>
    <message>
        <source>there is no measure {measure!r}; choose one of {known}</source>
        <translation>die Messgröße {measure!r} ist unbekannt; es gibt {known}</translation>
    </message>
    <message>
        <source>there is no sound output, so the clip plays silently</source>
        <translation>es gibt keine Tonausgabe, der Clip läuft also stumm</translation>
    </message>
    <message>
        <source>there is no sound output: {reason}</source>
        <translation>es gibt keine Tonausgabe: {reason}</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>track {name!r} not found</source>
        <translation>es gibt keine Spur {name!r}</translation>
    </message>
    <message>
        <source>there is nothing in it</source>
        <translation>es ist nichts darin</translation>
    </message>
    <message>
        <source>not valid firmware for the Falcon: {reason}; choose the file nvent_firmware.bin of a libnifalcon source archive</source>
        <translation>keine gültige Firmware für den Falcon: {reason}; wählen Sie die Datei nvent_firmware.bin eines Quellarchivs von libnifalcon</translation>
    </message>
    <message>
        <source>this method takes no parameters</source>
        <translation>diese Methode hat keine Parameter</translation>
    </message>
    <message>
        <source>this method takes {expected}, not {given}</source>
        <translation>diese Methode nimmt {expected}, nicht {given}</translation>
    </message>
    <message>
        <source>this track loads the motors to {heat:.0f} % of their continuous force; it may be reduced</source>
        <translation>diese Spur erwärmt die Motoren auf {heat:.0f} % dessen, was sie auf Dauer vertragen; sie könnten sie abschwächen</translation>
    </message>
    <message>
        <source>this track would move a {hand} hand so far that the device trips ({trip}) at {at_s:.1f} s</source>
        <translation>diese Spur würde eine {hand} Hand so bewegen, dass die Kraft abschaltet ({trip}), bei {at_s:.1f} s</translation>
    </message>
    <message>
        <source>this track would reach {reach:.0f} % of the workspace with a relaxed hand, at {at_s:.1f} s; beyond {far:.0f} % outward force is reduced</source>
        <translation>diese Spur würde mit einer lockeren Hand {reach:.0f} % des Arbeitsraums erreichen, bei {at_s:.1f} s; jenseits von {far:.0f} % wird die Kraft nach außen abgeschwächt</translation>
    </message>
    <message>
        <source>time_s has {ndim} axes, expected one</source>
        <translation>time_s hat {ndim} Achsen, erwartet wird eine</translation>
    </message>
    <message>
        <source>timeout</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>took telemetry-parser {time_limit_s:g} s</source>
        <translation>brauchte mit telemetry-parser {time_limit_s:g} s</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>at most {largest_radps:.2f} rad/s</source>
        <translation>höchste Drehrate {largest_radps:.2f} rad/s</translation>
    </message>
    <message>
        <source>update hapticplayer</source>
        <translation>aktualisieren Sie hapticplayer</translation>
    </message>
    <message>
        <source>update the program, or export again with this version</source>
        <translation>aktualisieren Sie das Programm, oder exportieren Sie noch einmal mit dieser Version</translation>
    </message>
    <message>
        <source>use the version of hapticplayer that wrote it</source>
        <translation>die Version von hapticplayer verwenden, die sie geschrieben hat</translation>
    </message>
    <message>
        <source>without a readable number</source>
        <translation>ohne lesbare Nummer</translation>
    </message>
    <message>
        <source>without names</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>written to</source>
        <translation>beschrieben</translation>
    </message>
    <message>
        <source>{axes}{words} are right, front, up</source>
        <translation>{axes}{words} sind rechts, vorn, oben</translation>
    </message>
    <message>
        <source>{count} Falcons are plugged in: {known}; choose one, such as falcon:{serial}</source>
        <translation>{count} Falcons sind angesteckt: {known}; wählen Sie einen, etwa falcon:{serial}</translation>
    </message>
    <message>
        <source>{count} bytes are not a whole number of words, or too many</source>
        <translation>{count} Bytes sind keine ganze Zahl von Wörtern, oder zu viele</translation>
    </message>
    <message>
        <source>{count} bytes follow its end</source>
        <translation>auf das Ende folgen {count} Bytes</translation>
    </message>
    <message>
        <source>{count} gaps</source>
        <translation>{count} Lücken</translation>
    </message>
    <message>
        <source>{count} gyroscope values were scaled twice and are ignored</source>
        <translation>{count} Gyroskopwerte waren zweimal skaliert und wurden weggelassen</translation>
    </message>
    <message>
        <source>{count} damaged lines were skipped (the first: line {line})</source>
        <translation>{count} Zeilen sind beschädigt und wurden weggelassen (die erste: Zeile {line})</translation>
    </message>
    <message>
        <source>{clip}: the skew of the sound would have no effect, because the offset comes from elsewhere ({method}); leave it out</source>
        <translation>{clip}: Die Tonverzögerung hätte keine Wirkung, weil der Versatz anderswoher kommt ({method}); lassen Sie sie weg</translation>
    </message>
    <message>
        <source>{clip}: the taps give an offset of {pats_s:.3f} s, the frames {frames_s:.3f} s; choose one of them, or enter the offset; if the camera&apos;s sound is late, say by how much</source>
        <translation>{clip}: Das Klopfen ergibt einen Versatz von {pats_s:.3f} s, die Bilder {frames_s:.3f} s; wählen Sie einen davon, oder geben Sie den Versatz ein; kommt der Ton der Kamera spät, geben Sie an, um wie viel</translation>
    </message>
    <message>
        <source>{clip}: {what}, and neither frames nor taps tell which is right ({why}); enter the offset: {places}, or another one</source>
        <translation>{clip}: {what}, und weder Bilder noch Klopfen zeigen, was stimmt ({why}); geben Sie den Versatz ein: {places} oder einen anderen</translation>
    </message>
    <message>
        <source>{clip}: {why}; make a copy at its real speed ({copy}), or take it as it plays, or stretch the motion</source>
        <translation>{clip}: {why}; machen Sie eine Kopie in wirklicher Geschwindigkeit ({copy}), oder nehmen Sie den Clip, wie er läuft, oder dehnen Sie die Bewegung</translation>
    </message>
    <message>
        <source>{count} missing or implausible times were interpolated</source>
        <translation>{count} fehlende oder wilde Zeiten wurden interpoliert</translation>
    </message>
    <message>
        <source>{count} motion samples are too few; at least {least} are needed</source>
        <translation>{count} Bewegungswerte sind zu wenige; mindestens {least} werden gebraucht</translation>
    </message>
    <message>
        <source>{count} motion samples within {span_ms:.3g} ms are not a recording of motion</source>
        <translation>{count} Bewegungswerte in {span_ms:.3g} ms sind keine Bewegung</translation>
    </message>
    <message>
        <source>{count} of {total} rows {done}</source>
        <translation>{count} von {total} Zeilen {done}</translation>
    </message>
    <message>
        <source>{count} of {total} samples of {name} were missing, the first in {place}; they were filled in</source>
        <translation>{count} von {total} Werten von {name} fehlten, der erste in {place}; sie wurden aufgefüllt</translation>
    </message>
    <message>
        <source>{count} packets in a row are damaged</source>
        <translation>{count} Pakete hintereinander sind beschädigt</translation>
    </message>
    <message>
        <source>{count} pairs of rows were swapped in time and put in order</source>
        <translation>{count} Zeilenpaare waren zeitlich vertauscht und wurden geordnet</translation>
    </message>
    <message>
        <source>{count} rows without a time were left out, as they are in a gap</source>
        <translation>{count} Zeilen ohne Zeit wurden weggelassen, da sie in einer Lücke stehen</translation>
    </message>
    <message>
        <source>{count} samples have no rate</source>
        <translation>{count} Werte haben keine Rate</translation>
    </message>
    <message>
        <source>{count} samples {interval_s} s apart are not a recording</source>
        <translation>{count} Abtastwerte im Abstand von {interval_s} s sind keine Aufnahme</translation>
    </message>
    <message>
        <source>{count} telemetry payloads are damaged; the rest was read.</source>
        <translation>{count} Telemetrieblöcke sind beschädigt; der Rest wurde gelesen.</translation>
    </message>
    <message>
        <source>{file}, line 1</source>
        <translation>{file}, Zeile 1</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, Zeile {line}</translation>
    </message>
    <message>
        <source>{file}: as its axes are given, the wearer was upside down: by gravity the other side is up; choose another mounting, or {sign}, or keep the axes of the log</source>
        <translation>{file}: Mit diesen Achsen stand die Person auf dem Kopf: Nach der Schwerkraft ist die andere Seite oben; wählen Sie eine andere Befestigung, oder {sign}, oder behalten Sie die Achsen des Protokolls</translation>
    </message>
    <message>
        <source>{file}: columns={columns} {fault}</source>
        <translation>{file}: columns={columns} {fault}</translation>
    </message>
    <message>
        <source>{file}: is not a table of numbers; choose another log</source>
        <translation>{file}: ist keine Tabelle mit Zahlen; wählen Sie ein anderes Protokoll</translation>
    </message>
    <message>
        <source>{accel_unit} and {rate_unit} for {ranges}</source>
        <translation>{accel_unit} und {rate_unit} für {ranges}</translation>
    </message>
    <message>
        <source>{key} has {count} samples, too many</source>
        <translation>{key} hat {count} Werte, mehr als gelesen werden</translation>
    </message>
    <message>
        <source>{leak_mps2:.2f} m/s2 of gravity remain while the recorder is stationary</source>
        <translation>{leak_mps2:.2f} m/s2 der Schwerkraft bleiben übrig, wo der Rekorder stillsteht</translation>
    </message>
    <message>
        <source>{line}, column {column}</source>
        <translation>{line}, Spalte {column}</translation>
    </message>
    <message>
        <source>{name!r} is not a valid track name; use up to 40 letters, digits, blanks, dots and hyphens</source>
        <translation>{name!r} kann nicht der Name einer Spur sein; nehmen Sie bis zu 40 Buchstaben, Ziffern, Leerzeichen, Punkte und Bindestriche</translation>
    </message>
    <message>
        <source>{name!r} is not a Falcon; use falcon, or falcon:SERIAL</source>
        <translation>{name!r} ist kein Falcon; nehmen Sie falcon oder falcon:SERIAL</translation>
    </message>
    <message>
        <source>(default)</source>
        <translation>(Standard)</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>During each clip a slider says how badly force and video fit; the recorded force beside a weaker and a late one and none.</source>
        <translation>Während jedes Clips gibt ein Schieberegler an, wie schlecht Kraft und Video zusammenpassen; die aufgezeichnete Kraft neben einer schwächeren, einer späten und keiner.</translation>
    </message>
    <message>
        <source>Each clip twice, once with a late force; the delay follows the answers (2-down 1-up).</source>
        <translation>Jeder Clip zweimal, einmal mit später Kraft; die Verzögerung folgt den Antworten (2-down 1-up).</translation>
    </message>
    <message>
        <source>Each clip twice, once with a stronger or weaker force; in which one it was stronger (forced choice).</source>
        <translation>Jeder Clip zweimal, einmal mit stärkerer oder schwächerer Kraft; in welchem war sie stärker (Zwangswahl).</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Estimated</source>
        <translation>Geschätzt</translation>
    </message>
    <message>
        <source>Falcon on USB</source>
        <translation>Falcon an USB</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Forces of several strengths; a number in proportion after each clip.</source>
        <translation>Kräfte verschiedener Stärke; nach jedem Clip eine Zahl im Verhältnis dazu.</translation>
    </message>
    <message>
        <source>Game pad that Linux can rumble</source>
        <translation>Gamepad, das Linux vibrieren lassen kann</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service has no Inverse3; connect its cable and supply, and choose the device again</source>
        <translation>der Inverse Service von Haply hat kein Inverse3; schließen Sie Kabel und Netzteil an und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>Inverse3</source>
        <translation>Inverse3</translation>
    </message>
    <message>
        <source>Inverse3 on a simulated service</source>
        <translation>Inverse3 an simuliertem Dienst</translation>
    </message>
    <message>
        <source>Just noticeable change</source>
        <translation>Eben merkliche Änderung</translation>
    </message>
    <message>
        <source>LabRecorder cannot write into a folder with braces in its name</source>
        <translation>LabRecorder kann nicht in einen Ordner mit geschweiften Klammern im Namen schreiben</translation>
    </message>
    <message>
        <source>LabRecorder has not begun its file</source>
        <translation>LabRecorder hat seine Datei nicht begonnen</translation>
    </message>
    <message>
        <source>LabRecorder is still starting</source>
        <translation>LabRecorder startet noch</translation>
    </message>
    <message>
        <source>Linux</source>
        <translation>Linux</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>Motion incongruence</source>
        <translation>Bewegungsinkongruenz</translation>
    </message>
    <message>
        <source>No motion: force here is gravity that was not removed</source>
        <translation>Keine Bewegung: Kraft ist hier Schwerkraft, die nicht entfernt wurde</translation>
    </message>
    <message>
        <source>Permission for {path}</source>
        <translation>Berechtigung für {path}</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Program that listens at {where}</source>
        <translation>Programm, das an {where} lauscht</translation>
    </message>
    <message>
        <source>Python package {name}</source>
        <translation>Python-Paket {name}</translation>
    </message>
    <message>
        <source>Search on this computer</source>
        <translation>Suche auf diesem Rechner</translation>
    </message>
    <message>
        <source>Sound output {card} with the channels {channels}</source>
        <translation>Tonausgang {card} mit den Kanälen {channels}</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Treppenverfahren</translation>
    </message>
    <message>
        <source>Susceptibility (MSSQ-short) and symptoms (SSQ) before and after; during each clip sickness (FMS) each minute, which can end it, and vection by a held key.</source>
        <translation>Anfälligkeit (MSSQ-short) und Symptome (SSQ) vorher und nachher; während jedes Clips jede Minute Übelkeit (FMS), die ihn beenden kann, und Vektion durch eine gehaltene Taste.</translation>
    </message>
    <message>
        <source>Wheel or joystick with a motor</source>
        <translation>Lenkrad oder Joystick mit Motor</translation>
    </message>
    <message>
        <source>a Williams design contains every pair of neighbours, also of one sequence</source>
        <translation>ein Williams-Plan enthält jedes Paar von Nachbarn, auch derselben Sequenz</translation>
    </message>
    <message>
        <source>a death ends the force when the kernel has cleared up, 10 to 80 ms</source>
        <translation>ein Absturz beendet die Kraft, wenn der Kernel aufgeräumt hat, nach 10 bis 80 ms</translation>
    </message>
    <message>
        <source>a force is not of this study</source>
        <translation>eine Kraft gehört nicht zu dieser Studie</translation>
    </message>
    <message>
        <source>a frame has the shape {shape}, expected {expected} of uint8</source>
        <translation>ein Bild hat die Form {shape}, erwartet wird {expected} aus uint8</translation>
    </message>
    <message>
        <source>a pilot study must have at least five complete participants</source>
        <translation>eine Pilotstudie braucht mindestens fünf vollständige Teilnehmer</translation>
    </message>
    <message>
        <source>a single sequence always follows itself</source>
        <translation>eine einzige Sequenz folgt zwangsläufig sich selbst</translation>
    </message>
    <message>
        <source>a smoother over the whole recording, with the sensor&apos;s errors</source>
        <translation>ein Glätter über die ganze Aufnahme, mit den Fehlern des Sensors</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>add one: it is analysed</source>
        <translation>fügen Sie eine hinzu: Sie wird ausgewertet</translation>
    </message>
    <message>
        <source>adding telemetry</source>
        <translation>Telemetrie</translation>
    </message>
    <message>
        <source>allowed: {known}</source>
        <translation>erlaubt: {known}</translation>
    </message>
    <message>
        <source>alpha and power must be between 0 and 1</source>
        <translation>Alpha und Teststärke müssen zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>amplitudes beyond 1 were limited</source>
        <translation>Amplituden über 1 wurden begrenzt</translation>
    </message>
    <message>
        <source>analysing {measure}</source>
        <translation>{measure} wird ausgewertet</translation>
    </message>
    <message>
        <source>another rendering needs the folder of the sequence; unpack it</source>
        <translation>eine andere Umsetzung braucht den Ordner der Sequenz; entpacken Sie sie</translation>
    </message>
    <message>
        <source>cannot be opened again</source>
        <translation>kann nicht wieder geöffnet werden</translation>
    </message>
    <message>
        <source>check the address and the network</source>
        <translation>prüfen Sie die Adresse und das Netzwerk</translation>
    </message>
    <message>
        <source>check the address, or ask who offers the file</source>
        <translation>prüfen Sie die Adresse, oder fragen Sie den Anbieter der Datei</translation>
    </message>
    <message>
        <source>check the network, then open it again</source>
        <translation>prüfen Sie das Netzwerk, und öffnen Sie sie dann noch einmal</translation>
    </message>
    <message>
        <source>checking {name}</source>
        <translation>{name} wird geprüft</translation>
    </message>
    <message>
        <source>clipped samples: {force} of the accelerometer ({force_marked} of them not reconstructed, marked as not valid), {rate} of the gyro ({rate_marked})</source>
        <translation>abgeschnittene Abtastwerte: {force} des Beschleunigungssensors ({force_marked} davon nicht rekonstruiert und als ungültig markiert), {rate} des Gyroskops ({rate_marked})</translation>
    </message>
    <message>
        <source>comparing needs two feedbacks or more</source>
        <translation>ein einziges Feedback kann mit nichts verglichen werden</translation>
    </message>
    <message>
        <source>condition {key} is not in the study</source>
        <translation>die Bedingung {key} ist nicht in der Studie</translation>
    </message>
    <message>
        <source>connection ended</source>
        <translation>Verbindung beendet</translation>
    </message>
    <message>
        <source>converting</source>
        <translation>wird umgewandelt</translation>
    </message>
    <message>
        <source>copying the clip</source>
        <translation>Clip wird kopiert</translation>
    </message>
    <message>
        <source>does not give parts of this file</source>
        <translation>gibt keine Teile dieser Datei heraus</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>download it and play the file</source>
        <translation>laden Sie sie herunter, und spielen Sie die Datei ab</translation>
    </message>
    <message>
        <source>download it, and give the file</source>
        <translation>laden Sie sie herunter, und geben Sie die Datei an</translation>
    </message>
    <message>
        <source>drawing the figures</source>
        <translation>Abbildungen werden gezeichnet</translation>
    </message>
    <message>
        <source>drawing the ride</source>
        <translation>die Fahrt wird gezeichnet</translation>
    </message>
    <message>
        <source>drawing {name}</source>
        <translation>{name} wird gezeichnet</translation>
    </message>
    <message>
        <source>duplicate entry {twice!r}</source>
        <translation>doppelter Eintrag {twice!r}</translation>
    </message>
    <message>
        <source>duplicate key {key!r}</source>
        <translation>der Schlüssel {key!r} steht zweimal da</translation>
    </message>
    <message>
        <source>enter a feedback</source>
        <translation>geben Sie ein Feedback an</translation>
    </message>
    <message>
        <source>estimated from the picture</source>
        <translation>aus dem Bild geschätzt</translation>
    </message>
    <message>
        <source>export the force again</source>
        <translation>exportieren Sie die Kraft noch einmal</translation>
    </message>
    <message>
        <source>fifo</source>
        <translation>FIFO</translation>
    </message>
    <message>
        <source>fitting {axis}</source>
        <translation>{axis} wird angepasst</translation>
    </message>
    <message>
        <source>following frames needs OpenCV, which is not installed</source>
        <translation>Bildern zu folgen braucht OpenCV, das nicht installiert ist</translation>
    </message>
    <message>
        <source>force belongs to this video, but neither it nor a file {name!r} beside it holds any; ask for both files again, and rename neither alone</source>
        <translation>zu diesem Video gehört Kraft, aber weder es noch eine Datei {name!r} daneben enthält sie; fragen Sie nach beiden Dateien und benennen Sie keine allein um</translation>
    </message>
    <message>
        <source>found no order in which no sequence is played twice in a row</source>
        <translation>keine Reihenfolge gefunden, in der keine Sequenz zweimal nacheinander kommt</translation>
    </message>
    <message>
        <source>get the package again, or pack the study again</source>
        <translation>holen Sie das Paket noch einmal, oder packen Sie die Studie noch einmal</translation>
    </message>
    <message>
        <source>give a link that needs none, such as a signed one</source>
        <translation>geben Sie einen Link an, der ohne auskommt, etwa einen signierten</translation>
    </message>
    <message>
        <source>give one that begins with http:// or https://</source>
        <translation>geben Sie eine an, die mit http:// oder https:// beginnt</translation>
    </message>
    <message>
        <source>give the address that it leads to, if you trust it</source>
        <translation>geben Sie die Adresse an, zu der sie führt, wenn Sie ihr vertrauen</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>has a different number of columns</source>
        <translation>hat eine andere Anzahl von Spalten</translation>
    </message>
    <message>
        <source>has no choice of one answer after the clips</source>
        <translation>hat keine Auswahl einer Antwort nach den Clips</translation>
    </message>
    <message>
        <source>has no question after a clip</source>
        <translation>fragt nichts nach einem Clip</translation>
    </message>
    <message>
        <source>has no question for a number after a clip</source>
        <translation>hat keine Frage nach einer Zahl nach einem Clip</translation>
    </message>
    <message>
        <source>has no rows</source>
        <translation>hat keine Zeilen</translation>
    </message>
    <message>
        <source>has records of version {found}, this program reads {version}</source>
        <translation>enthält Aufzeichnungen der Version {found}, dieses Programm liest {version}</translation>
    </message>
    <message>
        <source>has two axes</source>
        <translation>hat zwei Achsen</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>gehört</translation>
    </message>
    <message>
        <source>holds a user name or password, which would be shown and stored</source>
        <translation>enthält einen Benutzernamen oder ein Passwort, die angezeigt und gespeichert würden</translation>
    </message>
    <message>
        <source>holds no motion that can be read</source>
        <translation>enthält keine lesbare Bewegung</translation>
    </message>
    <message>
        <source>hypothesis {text!r}: there is no {name!r}; choose one of {known}</source>
        <translation>Hypothese {text!r}: {name!r} gibt es nicht; wählen Sie eines von {known}</translation>
    </message>
    <message>
        <source>imu: {what}; from now on it has another clock</source>
        <translation>imu: {what}; ab jetzt gilt eine andere Uhr</translation>
    </message>
    <message>
        <source>imu: {what}; the other streams continue, and it is recorded again as soon as it is back</source>
        <translation>imu: {what}; der Rest läuft weiter, und sie wird wieder aufgenommen, sobald sie zurück ist</translation>
    </message>
    <message>
        <source>intensities beyond their range were limited</source>
        <translation>Intensitäten außerhalb ihres Bereichs wurden begrenzt</translation>
    </message>
    <message>
        <source>is being changed by another program</source>
        <translation>wird gerade von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>is damaged or missing, and the definition of the study has changed</source>
        <translation>ist beschädigt oder fehlt, und die Definition der Studie hat sich geändert</translation>
    </message>
    <message>
        <source>is damaged or was altered (its checksum differs)</source>
        <translation>ist beschädigt oder wurde verändert (die Prüfsumme ist eine andere)</translation>
    </message>
    <message>
        <source>is empty or has become shorter</source>
        <translation>ist leer oder kürzer geworden</translation>
    </message>
    <message>
        <source>is missing: what the other force is compared with</source>
        <translation>fehlt: womit die andere Kraft verglichen wird</translation>
    </message>
    <message>
        <source>is not UTF-8 text</source>
        <translation>ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>is not a manifest of hapticplayer</source>
        <translation>ist kein Manifest von hapticplayer</translation>
    </message>
    <message>
        <source>is not a question of this page</source>
        <translation>ist keine Frage dieser Seite</translation>
    </message>
    <message>
        <source>is not a session</source>
        <translation>ist keine Sitzung</translation>
    </message>
    <message>
        <source>is not a valid key</source>
        <translation>ist kein gültiger Schlüssel</translation>
    </message>
    <message>
        <source>is not the address of a file</source>
        <translation>ist keine Adresse einer Datei</translation>
    </message>
    <message>
        <source>is not the definition of a study</source>
        <translation>beschreibt keine Studie</translation>
    </message>
    <message>
        <source>is not used in ratings by {kind}</source>
        <translation>wird in Bewertungen der Art {kind} nicht verwendet</translation>
    </message>
    <message>
        <source>is not used without stop_at</source>
        <translation>wird ohne stop_at nicht verwendet</translation>
    </message>
    <message>
        <source>is not valid JSON ({reason})</source>
        <translation>ist kein gültiges JSON ({reason})</translation>
    </message>
    <message>
        <source>is only used after the last trial</source>
        <translation>wird nur nach dem letzten Durchgang verwendet</translation>
    </message>
    <message>
        <source>is only used with LSL</source>
        <translation>wird nur mit LSL verwendet</translation>
    </message>
    <message>
        <source>is refused by its server (status {status})</source>
        <translation>wird vom Server verweigert (Status {status})</translation>
    </message>
    <message>
        <source>is the consent of {code}</source>
        <translation>ist die Einwilligung von {code}</translation>
    </message>
    <message>
        <source>is the plan of the study {found}, not {expected}</source>
        <translation>ist der Plan der Studie {found}, nicht {expected}</translation>
    </message>
    <message>
        <source>is the session of {code}</source>
        <translation>ist die Sitzung von {code}</translation>
    </message>
    <message>
        <source>is_valid and reasons contradict each other</source>
        <translation>is_valid und reasons widersprechen sich</translation>
    </message>
    <message>
        <source>it appears twice</source>
        <translation>er kommt zweimal vor</translation>
    </message>
    <message>
        <source>it asks for none</source>
        <translation>sie verlangt keinen</translation>
    </message>
    <message>
        <source>it belongs to the study {found}</source>
        <translation>sie gehört zur Studie {found}</translation>
    </message>
    <message>
        <source>it holds half a character</source>
        <translation>es enthält ein halbes Zeichen</translation>
    </message>
    <message>
        <source>it holds no gyroscope, or its sensors share a clock</source>
        <translation>es enthält kein Gyroskop, oder seine Sensoren haben dieselbe Uhr</translation>
    </message>
    <message>
        <source>it holds no sound, in which taps could be heard</source>
        <translation>es enthält keinen Ton, in dem Klopfen zu hören wäre</translation>
    </message>
    <message>
        <source>it holds no such samples, or states their unit</source>
        <translation>es enthält keine solchen Werte, oder es nennt ihre Einheit</translation>
    </message>
    <message>
        <source>it is {container}, which is not read</source>
        <translation>es ist {container}, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>it looks like microseconds: divide {scale} by 1000000</source>
        <translation>es sieht nach Mikrosekunden aus: Teilen Sie {scale} durch 1000000</translation>
    </message>
    <message>
        <source>it looks like milliseconds: divide {scale} by 1000</source>
        <translation>es sieht nach Millisekunden aus: Teilen Sie {scale} durch 1000</translation>
    </message>
    <message>
        <source>it looks like nanoseconds: divide {scale} by 1000000000</source>
        <translation>es sieht nach Nanosekunden aus: Teilen Sie {scale} durch 1000000000</translation>
    </message>
    <message>
        <source>it played another sequence {key!r} than was packed</source>
        <translation>gespielt wurde eine andere Sequenz {key!r} als die gepackte</translation>
    </message>
    <message>
        <source>it ran a definition that was altered after the study was packed</source>
        <translation>lief mit einer Definition, die nach dem Packen der Studie geändert wurde</translation>
    </message>
    <message>
        <source>it seems to be in {unit}: multiply it by {factor:.6g}</source>
        <translation>es scheint in {unit} zu sein: Multiplizieren Sie es mit {factor:.6g}</translation>
    </message>
    <message>
        <source>it was closed</source>
        <translation>wurde geschlossen</translation>
    </message>
    <message>
        <source>it was recorded at {captured_hz:g} frames per second and plays at {shown_hz:g}</source>
        <translation>er wurde mit {captured_hz:g} Bildern je Sekunde aufgenommen und läuft mit {shown_hz:g}</translation>
    </message>
    <message>
        <source>its accelerometer reads {norm:.3g} m/s2 where it is calm, and its {sensor} would read {found:.3g}, as gravity: these columns are swapped</source>
        <translation>sein Beschleunigungssensor misst in Ruhe {norm:.3g} m/s2, {sensor} wäre {found:.3g}, wie die Schwerkraft: Diese Spalten sind vertauscht</translation>
    </message>
    <message>
        <source>its checksum differs</source>
        <translation>die Prüfsumme weicht ab</translation>
    </message>
    <message>
        <source>its clip has changed since it was imported (its checksum differs)</source>
        <translation>der Clip hat sich seit dem Import geändert (die Prüfsumme weicht ab)</translation>
    </message>
    <message>
        <source>its columns are known</source>
        <translation>seine Spalten sind bekannt</translation>
    </message>
    <message>
        <source>its definition was altered since the study was packed</source>
        <translation>die Definition wurde geändert, seit die Studie gepackt wurde</translation>
    </message>
    <message>
        <source>its edit list stretches time</source>
        <translation>seine Schnittliste dehnt die Zeit</translation>
    </message>
    <message>
        <source>its force is 0 N from beginning to end</source>
        <translation>seine Kraft ist von Anfang bis Ende 0 N</translation>
    </message>
    <message>
        <source>its format tells its sensors apart, or it does not have both</source>
        <translation>sein Format unterscheidet die Sensoren, oder es hat nicht beide</translation>
    </message>
    <message>
        <source>its frames are shown at other times</source>
        <translation>seine Bilder werden zu anderen Zeiten gezeigt</translation>
    </message>
    <message>
        <source>its frames of {width} x {height} pixels are too large (up to 8192 x 4320 are shown)</source>
        <translation>die Bilder mit {width} x {height} Pixeln sind zu groß (bis 8192 x 4320 werden gezeigt)</translation>
    </message>
    <message>
        <source>its gyroscope reads exactly 0 about {axes} throughout, but gravity turns in its accelerometer as it does not show</source>
        <translation>sein Gyroskop zeigt um {axes} durchweg genau 0, aber die Schwerkraft dreht sich in seinem Beschleunigungssensor, wie es nicht zeigt</translation>
    </message>
    <message>
        <source>its gyroscope shows how gravity turns in its accelerometer {size_s:.2f} s too {how}: their clocks differ</source>
        <translation>sein Gyroskop zeigt die Drehung der Schwerkraft in seinem Beschleunigungssensor {size_s:.2f} s zu {how}: Ihre Uhren weichen ab</translation>
    </message>
    <message>
        <source>its index lists {count} frames and pieces of sound, which is too much (limit: {most})</source>
        <translation>der Index nennt {count} Bilder und Tonstücke, das ist zu viel (Grenze: {most})</translation>
    </message>
    <message>
        <source>its index, tags or chapters are too large ({size_mb} MB)</source>
        <translation>Index, Tags oder Kapitel sind zu groß ({size_mb} MB)</translation>
    </message>
    <message>
        <source>its last part names no variant of it</source>
        <translation>der letzte Teil nennt keine Variante davon</translation>
    </message>
    <message>
        <source>its metadata say that it is a time lapse</source>
        <translation>nach seinen Metadaten ist er ein Zeitraffer</translation>
    </message>
    <message>
        <source>its pixel format cannot be converted</source>
        <translation>sein Pixelformat kann nicht umgewandelt werden</translation>
    </message>
    <message>
        <source>its samples have times, or a rate of their own</source>
        <translation>seine Werte haben Zeiten oder eine eigene Rate</translation>
    </message>
    <message>
        <source>its server does not give parts of files (HTTP ranges)</source>
        <translation>der Server gibt keine Teile von Dateien heraus (HTTP-Bereiche)</translation>
    </message>
    <message>
        <source>its sound is heard at other times</source>
        <translation>sein Ton ist zu anderen Zeiten zu hören</translation>
    </message>
    <message>
        <source>its subtitles cannot be read</source>
        <translation>die Untertitel lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>its time</source>
        <translation>seine Zeit</translation>
    </message>
    <message>
        <source>its tracks cannot be listed</source>
        <translation>die Spuren lassen sich nicht auflisten</translation>
    </message>
    <message>
        <source>its video is not the one that the force was made for ({reason})</source>
        <translation>sein Video ist nicht das, für das die Kraft gemacht wurde ({reason})</translation>
    </message>
    <message>
        <source>keep the calibration of another recording</source>
        <translation>sichern Sie die Kalibrierung einer anderen Aufnahme</translation>
    </message>
    <message>
        <source>larger than a file on the disk at {disk} may be (ulimit -f)</source>
        <translation>größer, als eine Datei auf dem Datenträger bei {disk} sein darf (ulimit -f)</translation>
    </message>
    <message>
        <source>late</source>
        <translation>spät</translation>
    </message>
    <message>
        <source>left out: nothing</source>
        <translation>weggelassen: nichts</translation>
    </message>
    <message>
        <source>left out: {what}</source>
        <translation>weggelassen: {what}</translation>
    </message>
    <message>
        <source>listening</source>
        <translation>Ton wird angehört</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>magnetometer</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>make an MP4 of it with: {command}</source>
        <translation>machen Sie ein MP4 daraus mit: {command}</translation>
    </message>
    <message>
        <source>make the force again</source>
        <translation>berechnen Sie die Kraft neu</translation>
    </message>
    <message>
        <source>malformed replies from the device</source>
        <translation>ungültige Antworten des Geräts</translation>
    </message>
    <message>
        <source>media keys; the screen stays awake while a clip plays</source>
        <translation>Medientasten; der Bildschirm bleibt an, während ein Clip spielt</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>missing entry {name!r}</source>
        <translation>fehlender Eintrag {name!r}</translation>
    </message>
    <message>
        <source>motion track of the camera, which may hold places (only an MP4 has it)</source>
        <translation>Bewegungsspur der Kamera, die Orte enthalten kann (nur ein MP4 hat sie)</translation>
    </message>
    <message>
        <source>move it to its own study</source>
        <translation>verschieben Sie sie in ihre eigene Studie</translation>
    </message>
    <message>
        <source>move the grip to the centre first, then re-arm again</source>
        <translation>bringen Sie den Griff zuerst in die Mitte, und geben Sie die Kraft dann noch einmal frei</translation>
    </message>
    <message>
        <source>must be a letter from a to z, enter, shift or control</source>
        <translation>muss ein Buchstabe von a bis z, enter, shift oder control sein</translation>
    </message>
    <message>
        <source>must be more than least</source>
        <translation>muss größer als least sein</translation>
    </message>
    <message>
        <source>must be one of the choices</source>
        <translation>hat eine Antwort, die nicht angeboten wurde</translation>
    </message>
    <message>
        <source>must be {wanted}, not {kind}</source>
        <translation>muss {wanted} sein, nicht {kind}</translation>
    </message>
    <message>
        <source>must have 2 to {most} conditions, has {count}</source>
        <translation>ergibt {count} Bedingungen; 2 bis {most} gehen</translation>
    </message>
    <message>
        <source>name of a file</source>
        <translation>Name einer Datei</translation>
    </message>
    <message>
        <source>name or number of a device</source>
        <translation>Name oder Nummer eines Geräts</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>zu tief verschachtelt</translation>
    </message>
    <message>
        <source>no data from the device yet</source>
        <translation>noch keine Daten vom Gerät</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>no estimated sway: no turns beyond what may be an error</source>
        <translation>kein geschätztes Schwanken: keine Kurven, die größer sind als ein möglicher Fehler</translation>
    </message>
    <message>
        <source>no force track</source>
        <translation>keine Kraftspur</translation>
    </message>
    <message>
        <source>no joystick was found, but a rating is moved by one</source>
        <translation>kein Joystick gefunden, aber eine Bewertung wird mit einem bewegt</translation>
    </message>
    <message>
        <source>no media keys, and the screen may go dark while a clip plays</source>
        <translation>keine Medientasten, und der Bildschirm kann dunkel werden, während ein Clip spielt</translation>
    </message>
    <message>
        <source>no part of the program is paged out</source>
        <translation>kein Teil des Programms wird ausgelagert</translation>
    </message>
    <message>
        <source>no participant {code}</source>
        <translation>keine teilnehmende Person {code}</translation>
    </message>
    <message>
        <source>no question has a published wording</source>
        <translation>keine Frage hat einen veröffentlichten Wortlaut</translation>
    </message>
    <message>
        <source>no sensor of it was stuck</source>
        <translation>keiner seiner Sensoren hing fest</translation>
    </message>
    <message>
        <source>no three taps are both heard and felt</source>
        <translation>es gibt kein dreimaliges Klopfen, das zu hören und zu spüren ist</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>none of its frames can be decoded</source>
        <translation>keines seiner Bilder kann dekodiert werden</translation>
    </message>
    <message>
        <source>not compared with the track</source>
        <translation>nicht mit der Spur verglichen</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>nicht bestätigt</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>Referenz verloren</translation>
    </message>
    <message>
        <source>not read: the columns {names}</source>
        <translation>nicht gelesen: die Spalten {names}</translation>
    </message>
    <message>
        <source>not read: {what} beside it</source>
        <translation>nicht gelesen: {what} daneben</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>nothing was played: {cause}; {remedy}</source>
        <translation>es wurde nichts gespielt: {cause}; {remedy}</translation>
    </message>
    <message>
        <source>of {count} reference devices the first was taken</source>
        <translation>von {count} Bezugsgeräten gilt das erste</translation>
    </message>
    <message>
        <source>offer the first and the second clip</source>
        <translation>bieten Sie den ersten und den zweiten Clip an</translation>
    </message>
    <message>
        <source>only {free_mb} MB of the disk are free, enough for {minutes:.0f} min</source>
        <translation>auf dem Datenträger sind nur {free_mb} MB frei, genug für {minutes:.0f} min</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>öffnen Sie sie noch einmal</translation>
    </message>
    <message>
        <source>open the study again and repeat the change</source>
        <translation>öffnen Sie die Studie noch einmal, und wiederholen Sie die Änderung</translation>
    </message>
    <message>
        <source>other programs may delay the force: close them</source>
        <translation>andere Programme können die Kraft verzögern: Schließen Sie sie</translation>
    </message>
    <message>
        <source>otherwise enter the offset</source>
        <translation>geben Sie sonst den Versatz ein</translation>
    </message>
    <message>
        <source>planned force, velocity, buttons and timing of each tick</source>
        <translation>geplante Kraft, Geschwindigkeit, Tasten und Zeiten jedes Takts</translation>
    </message>
    <message>
        <source>play a clip, and tick the box if you hear it</source>
        <translation>spielen Sie einen Clip, und setzen Sie das Häkchen, wenn Sie ihn hören</translation>
    </message>
    <message>
        <source>play again</source>
        <translation>spielen Sie noch einmal ab</translation>
    </message>
    <message>
        <source>player ended</source>
        <translation>Player beendet</translation>
    </message>
    <message>
        <source>plug it in, or add yourself to the group &apos;input&apos;</source>
        <translation>schließen Sie ihn an, oder nehmen Sie sich in die Gruppe &apos;input&apos; auf</translation>
    </message>
    <message>
        <source>plug it in, then begin the session again</source>
        <translation>schließen Sie ihn an, und beginnen Sie die Sitzung dann noch einmal</translation>
    </message>
    <message>
        <source>predicting excursions</source>
        <translation>Auslenkungen werden vorhergesagt</translation>
    </message>
    <message>
        <source>processors are kept out of deep sleep while a force may be on</source>
        <translation>die Prozessoren schlafen nicht tief, solange eine Kraft wirken kann</translation>
    </message>
    <message>
        <source>processors may sleep deeply: the loop wakes up some 20 us later</source>
        <translation>die Prozessoren dürfen tief schlafen: Die Schleife wacht etwa 20 us später auf</translation>
    </message>
    <message>
        <source>pull the grip all the way out, then push it in until it locks</source>
        <translation>ziehen Sie den Griff ganz heraus, und schieben Sie ihn dann hinein, bis er einrastet</translation>
    </message>
    <message>
        <source>rate-axes={axes} to keep both as they are</source>
        <translation>rate-axes={axes}, um beide zu lassen, wie sie sind</translation>
    </message>
    <message>
        <source>rate-delay=0 to keep both as they are</source>
        <translation>rate-delay=0, um beide zu lassen, wie sie sind</translation>
    </message>
    <message>
        <source>rate-delay={delay_s:.2f} to take it back</source>
        <translation>rate-delay={delay_s:.2f}, um es zurückzunehmen</translation>
    </message>
    <message>
        <source>rate-unit={unit} to scale it to gravity</source>
        <translation>rate-unit={unit}, um auf die Schwerkraft zu skalieren</translation>
    </message>
    <message>
        <source>read as telemetry of the camera: specific force in m/s2, angular rate in rad/s; x right, y forward, z up{rest}; up to {largest_radps:.2f} rad/s</source>
        <translation>gelesen als Telemetrie der Kamera: spezifische Kraft in m/s2, Drehrate in rad/s; x rechts, y vorn, z oben{rest}; bis {largest_radps:.2f} rad/s</translation>
    </message>
    <message>
        <source>reading the answers</source>
        <translation>Antworten werden gelesen</translation>
    </message>
    <message>
        <source>reading the sessions</source>
        <translation>Sitzungen werden gelesen</translation>
    </message>
    <message>
        <source>reading {name}</source>
        <translation>{name} wird gelesen</translation>
    </message>
    <message>
        <source>record at 100 Hz or more, or enter the offset</source>
        <translation>nehmen Sie mit 100 Hz oder mehr auf, oder geben Sie den Versatz ein</translation>
    </message>
    <message>
        <source>record both</source>
        <translation>zeichnen Sie beide auf</translation>
    </message>
    <message>
        <source>record it again</source>
        <translation>nehmen Sie es noch einmal auf</translation>
    </message>
    <message>
        <source>record with sound, or enter the offset</source>
        <translation>nehmen Sie mit Ton auf, oder geben Sie den Versatz ein</translation>
    </message>
    <message>
        <source>record {number} ({kind}) was left out: {reason}</source>
        <translation>Eintrag {number} ({kind}) wurde weggelassen: {reason}</translation>
    </message>
    <message>
        <source>record {number}: the answer to {name!r} in {step} was left out: {reason}</source>
        <translation>Eintrag {number}: die Antwort auf {name!r} in {step} wurde weggelassen: {reason}</translation>
    </message>
    <message>
        <source>redirects from {scheme} to another scheme</source>
        <translation>leitet von {scheme} auf ein anderes Schema um</translation>
    </message>
    <message>
        <source>redirects to a private address</source>
        <translation>leitet auf eine private Adresse um</translation>
    </message>
    <message>
        <source>redirects too often</source>
        <translation>leitet zu oft um</translation>
    </message>
    <message>
        <source>reference device {number:g} is not in the file; the first was taken</source>
        <translation>das Bezugsgerät {number:g} ist nicht in der Datei; das erste gilt</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>entfernen Sie es</translation>
    </message>
    <message>
        <source>remove the column</source>
        <translation>entfernen Sie die Spalte</translation>
    </message>
    <message>
        <source>remove the constraint</source>
        <translation>die Einschränkung entfernen</translation>
    </message>
    <message>
        <source>remove the constraint or add sequences</source>
        <translation>lassen Sie die Einschränkung weg, oder fügen Sie Sequenzen hinzu</translation>
    </message>
    <message>
        <source>remove the constraint or choose random or latin-square</source>
        <translation>lassen Sie die Einschränkung weg, oder wählen Sie random oder latin-square</translation>
    </message>
    <message>
        <source>removing gravity</source>
        <translation>Schwerkraft wird entfernt</translation>
    </message>
    <message>
        <source>remux it with FFmpeg (-c copy)</source>
        <translation>packen Sie es mit FFmpeg um (-c copy)</translation>
    </message>
    <message>
        <source>remux it with MKVToolNix or FFmpeg, without them</source>
        <translation>packen Sie es mit MKVToolNix oder FFmpeg ohne sie um</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>benennen Sie ihn um</translation>
    </message>
    <message>
        <source>rename it to {name!r} to feel it as {as_what}</source>
        <translation>benennen Sie es in {name!r} um, um es als {as_what} zu spüren</translation>
    </message>
    <message>
        <source>rename one of them</source>
        <translation>eine davon umbenennen</translation>
    </message>
    <message>
        <source>rendering the force</source>
        <translation>Kraft wird berechnet</translation>
    </message>
    <message>
        <source>restore the old sequence, or stop this session</source>
        <translation>die alte Sequenz wiederherstellen oder diese Sitzung beenden</translation>
    </message>
    <message>
        <source>riding</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>rig option id={id} has no effect: packets of {format} have no ID; leave it out</source>
        <translation>Plattform-Option id={id} hat keine Wirkung: Pakete von {format} haben keine ID; lassen Sie sie weg</translation>
    </message>
    <message>
        <source>rotations</source>
        <translation>Drehungen</translation>
    </message>
    <message>
        <source>rotations, and what of the motion changes within {span_ms} ms</source>
        <translation>Drehungen, und was sich an der Bewegung innerhalb von {span_ms} ms ändert</translation>
    </message>
    <message>
        <source>samples of {bits} bits were taken from the lower end of {width} bytes</source>
        <translation>Werte von {bits} Bit wurden vom unteren Ende von {width} Byte genommen</translation>
    </message>
    <message>
        <source>save it with the line ends of Unix or Windows</source>
        <translation>speichern Sie es mit den Zeilenenden von Unix oder Windows</translation>
    </message>
    <message>
        <source>save the answers of another log</source>
        <translation>speichern Sie die Antworten eines anderen Protokolls</translation>
    </message>
    <message>
        <source>say it once</source>
        <translation>geben Sie es nur einmal an</translation>
    </message>
    <message>
        <source>session {code}: {key} was left out; it is not in the definition</source>
        <translation>Sitzung {code}: {key} wurde ausgelassen; es ist nicht in der Definition</translation>
    </message>
    <message>
        <source>set &apos;lsl&apos; to true</source>
        <translation>setzen Sie &apos;lsl&apos; auf true</translation>
    </message>
    <message>
        <source>set the device up first</source>
        <translation>richten Sie das Gerät zuerst ein</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>kürzen Sie ihn</translation>
    </message>
    <message>
        <source>simulated {begin} of {studies} studies</source>
        <translation>{begin} von {studies} Studien simuliert</translation>
    </message>
    <message>
        <source>simulating studies of {size} participants</source>
        <translation>Studien mit {size} Personen werden simuliert</translation>
    </message>
    <message>
        <source>skipping a step needs a reason</source>
        <translation>zum Überspringen eines Schritts ist ein Grund nötig</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>Zeitscheibe</translation>
    </message>
    <message>
        <source>sort the file by time and remove duplicates</source>
        <translation>sortieren Sie die Datei nach der Zeit, und entfernen Sie Wiederholungen</translation>
    </message>
    <message>
        <source>spikes removed from {force} accelerometer, {rate} gyro, {field} magnetometer samples; {kept} samples stood out and were left as motion</source>
        <translation>Ausreißer entfernt aus {force} Abtastwerten des Beschleunigungssensors, {rate} des Gyroskops, {field} des Magnetometers; {kept} auffällige Abtastwerte blieben als Bewegung</translation>
    </message>
    <message>
        <source>start LabRecorder on this computer, tick &apos;Enable RCS&apos; and look at its window, then begin the session again</source>
        <translation>starten Sie LabRecorder auf diesem Rechner, haken Sie „Enable RCS“ an, sehen Sie in sein Fenster, und beginnen Sie die Sitzung dann noch einmal</translation>
    </message>
    <message>
        <source>start a new session</source>
        <translation>beginnen Sie eine neue</translation>
    </message>
    <message>
        <source>start them, then begin the trial again</source>
        <translation>starten Sie sie, und beginnen Sie den Durchgang dann noch einmal</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>startet</translation>
    </message>
    <message>
        <source>stop what it records, then begin the session again</source>
        <translation>beenden Sie seine Aufnahme, und beginnen Sie die Sitzung dann noch einmal</translation>
    </message>
    <message>
        <source>stopped: {cause}; {remedy}</source>
        <translation>angehalten: {cause}; {remedy}</translation>
    </message>
    <message>
        <source>strengths</source>
        <translation>Stärken</translation>
    </message>
    <message>
        <source>stuck must be no-force</source>
        <translation>stuck muss no-force sein</translation>
    </message>
    <message>
        <source>stuck=no-force to have no force there, or record it again</source>
        <translation>stuck=no-force, damit dort keine Kraft ist, oder nehmen Sie es noch einmal auf</translation>
    </message>
    <message>
        <source>swapped must be {known}</source>
        <translation>swapped muss {known} sein</translation>
    </message>
    <message>
        <source>swapped=no to keep them</source>
        <translation>swapped=no, um sie zu lassen</translation>
    </message>
    <message>
        <source>swapped={key} to swap them</source>
        <translation>swapped={key}, um sie zu vertauschen</translation>
    </message>
    <message>
        <source>synchronising</source>
        <translation>wird synchronisiert</translation>
    </message>
    <message>
        <source>takes column {number} for {name}, but it holds {text!r}; ignore it with -, or write it as numbers</source>
        <translation>nimmt Spalte {number} für {name}, aber sie enthält {text!r}; übergehen Sie sie mit -, oder schreiben Sie sie als Zahlen</translation>
    </message>
    <message>
        <source>the angular rate is not that of the camera in the frames of the clip, but would be if it were {scale:.3g} times as large</source>
        <translation>die Drehrate ist nicht die der Kamera in den Bildern des Clips, wäre es aber, wenn sie {scale:.3g}-mal so groß wäre</translation>
    </message>
    <message>
        <source>the answers to {key!r} must be two: the clips</source>
        <translation>{key!r} muss zwei Antworten haben: die Clips</translation>
    </message>
    <message>
        <source>the camera does not move: there is nothing to estimate</source>
        <translation>die Kamera bewegt sich nicht: es gibt nichts zu schätzen</translation>
    </message>
    <message>
        <source>the camera in the frames does not turn as the gyroscope does, in any axes: a stabilised video, another offset, or the log of another clip</source>
        <translation>die Kamera in den Bildern dreht sich nicht wie das Gyroskop, gleich in welchen Achsen: ein stabilisiertes Video, ein anderer Versatz oder das Protokoll eines anderen Clips</translation>
    </message>
    <message>
        <source>the camera in the frames turns as the gyroscope does</source>
        <translation>die Kamera in den Bildern dreht sich wie das Gyroskop</translation>
    </message>
    <message>
        <source>the camera turns too little to show the time</source>
        <translation>die Kamera dreht sich zu wenig, um die Zeit zu zeigen</translation>
    </message>
    <message>
        <source>the camera&apos;s rotation can be estimated in only {told_s:.2f} s of the video, at least {least_s:.0f} s are needed</source>
        <translation>die Drehung der Kamera lässt sich nur in {told_s:.2f} s des Videos schätzen, mindestens {least_s:.0f} s sind nötig</translation>
    </message>
    <message>
        <source>the camera&apos;s rotation in its frames against the gyro; coarse without the extra vision</source>
        <translation>die Drehung der Kamera in ihren Bildern gegen das Gyroskop; ohne das Extra vision grob</translation>
    </message>
    <message>
        <source>the camera&apos;s rotation in the frames fits the log nowhere (is it the log of this clip, and the video not stabilised?)</source>
        <translation>die Drehung der Kamera in den Bildern passt nirgends zum Protokoll (gehört es zu diesem Video, und ist das Video nicht stabilisiert?)</translation>
    </message>
    <message>
        <source>the causal filter of Laidig and Seel 2023</source>
        <translation>das kausale Filter von Laidig und Seel 2023</translation>
    </message>
    <message>
        <source>the clip has no sound, which taps need</source>
        <translation>es gibt keinen Ton, in dem Klopfen zu hören wäre</translation>
    </message>
    <message>
        <source>the clip has {rate_hz:.0f} frames per second, too few to suggest motion; it needs {least_hz:.0f}</source>
        <translation>der Clip hat {rate_hz:.0f} Bilder pro Sekunde, zu wenige, um Bewegung vorzuschlagen; es müssen {least_hz:.0f} sein</translation>
    </message>
    <message>
        <source>the clip is damaged: some of its frames are missing or broken</source>
        <translation>der Clip ist beschädigt: einige seiner Bilder fehlen oder sind defekt</translation>
    </message>
    <message>
        <source>the clip is too short to suggest motion; it needs {least_s:g} s</source>
        <translation>der Clip ist zu kurz, um Bewegung vorzuschlagen; er muss {least_s:g} s haben</translation>
    </message>
    <message>
        <source>the clip needs {needed_mb} MB and only {free_mb} MB are free</source>
        <translation>der Clip braucht {needed_mb} MB, und nur {free_mb} MB sind frei</translation>
    </message>
    <message>
        <source>the clip was cut and joined, or its times were changed</source>
        <translation>der Clip wurde geschnitten und zusammengefügt, oder seine Zeiten wurden geändert</translation>
    </message>
    <message>
        <source>the clocks differ by {ppm:.0f} ppm or more: is the video played at the frame rate it was recorded with?</source>
        <translation>die Uhren weichen um mindestens {ppm:.0f} ppm voneinander ab: Wird das Video mit der Bildrate abgespielt, mit der es aufgenommen wurde?</translation>
    </message>
    <message>
        <source>the columns must be {columns}</source>
        <translation>die Spalten müssen {columns} sein</translation>
    </message>
    <message>
        <source>the current page is {page}, not {expected}</source>
        <translation>dies ist die Seite {page}, nicht {expected}</translation>
    </message>
    <message>
        <source>the death of the player or its loop ends the force at once</source>
        <translation>ein Absturz des Players oder seiner Schleife beendet die Kraft sofort</translation>
    </message>
    <message>
        <source>the device driver failed ({reason}); report this, and choose the device again</source>
        <translation>der Treiber des Geräts ist ausgefallen ({reason}); melden Sie das, und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the direction of the force</source>
        <translation>die Richtung der Kraft</translation>
    </message>
    <message>
        <source>the disk at {disk} is full</source>
        <translation>der Datenträger bei {disk} ist voll</translation>
    </message>
    <message>
        <source>the environment of the program</source>
        <translation>die Umgebung des Programms</translation>
    </message>
    <message>
        <source>the extension {name!r} cannot be used: {reason}; update or uninstall it</source>
        <translation>die Erweiterung {name!r} kann nicht verwendet werden: {reason}; aktualisieren oder entfernen Sie sie</translation>
    </message>
    <message>
        <source>the force after the end of the clip ({end_s:.3f} s)</source>
        <translation>die Kraft nach dem Ende des Clips ({end_s:.3f} s)</translation>
    </message>
    <message>
        <source>the force before 0 s</source>
        <translation>die Kraft vor 0 s</translation>
    </message>
    <message>
        <source>the force goes on until {end_s:.3f} s, the clip ends at {clip_s:.3f} s</source>
        <translation>die Kraft dauert bis {end_s:.3f} s, der Clip endet bei {clip_s:.3f} s</translation>
    </message>
    <message>
        <source>the force in newtons</source>
        <translation>die Kraft in Newton</translation>
    </message>
    <message>
        <source>the force is stopped; re-arm it first</source>
        <translation>die Kraft ist abgeschaltet; geben Sie sie zuerst frei</translation>
    </message>
    <message>
        <source>the frames show an offset of {offset_s:.3f} s</source>
        <translation>die Bilder zeigen einen Versatz von {offset_s:.3f} s</translation>
    </message>
    <message>
        <source>the guard could not be started: {reason}</source>
        <translation>der Wächter konnte nicht gestartet werden: {reason}</translation>
    </message>
    <message>
        <source>the guard of the haptics process has ended, so the force is off; choose the device again</source>
        <translation>der Wächter des Haptikprozesses wurde beendet, die Kraft ist aus; wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the gyroscope&apos;s axes were not compared with the frames: the camera hardly turns</source>
        <translation>die Achsen des Gyroskops wurden nicht mit den Bildern verglichen: Die Kamera dreht sich kaum</translation>
    </message>
    <message>
        <source>the haptics process did not become ready in time; try again, and run &apos;hapticplayer doctor&apos; if it fails again</source>
        <translation>der Haptikprozess war nicht rechtzeitig bereit; versuchen Sie es erneut und rufen Sie bei wiederholtem Fehler &apos;hapticplayer doctor&apos; auf</translation>
    </message>
    <message>
        <source>the haptics process has ended, so the force is off; choose the device again</source>
        <translation>der Haptikprozess wurde beendet, die Kraft ist aus; wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the haptics process has ended; test the device again</source>
        <translation>der Haptikprozess ist beendet; testen Sie das Gerät noch einmal</translation>
    </message>
    <message>
        <source>the home folder is unknown; set {variable} to the firmware&apos;s path</source>
        <translation>der persönliche Ordner ist unbekannt; {variable} auf den Pfad der Firmware setzen</translation>
    </message>
    <message>
        <source>the joystick cannot be opened ({reason})</source>
        <translation>der Joystick kann nicht geöffnet werden ({reason})</translation>
    </message>
    <message>
        <source>the kind is not known</source>
        <translation>die Art ist unbekannt</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>die Programmiersprache</translation>
    </message>
    <message>
        <source>the last step must be above 0 and not above the first change</source>
        <translation>der letzte Schritt muss über 0 liegen und darf nicht über der ersten Änderung liegen</translation>
    </message>
    <message>
        <source>the last {count} samples are missing</source>
        <translation>die letzten {count} Werte fehlen</translation>
    </message>
    <message>
        <source>the log has no angular rate, which frames could be compared with</source>
        <translation>das Protokoll enthält keine Drehrate, mit der Bilder verglichen werden könnten</translation>
    </message>
    <message>
        <source>the loop comes before other programs: 3 late wake-ups a minute</source>
        <translation>die Schleife kommt vor anderen Programmen: 3-mal je Minute wacht sie zu spät auf</translation>
    </message>
    <message>
        <source>the loop competes with other programs: 22 late wake-ups a minute</source>
        <translation>die Schleife konkurriert mit anderen Programmen: 22-mal je Minute wacht sie zu spät auf</translation>
    </message>
    <message>
        <source>the method frames needs a clip</source>
        <translation>das Verfahren frames braucht einen Clip</translation>
    </message>
    <message>
        <source>the mixed model cannot be fitted: answers of at least {least} participants to all feedbacks are needed, and not all alike</source>
        <translation>das gemischte Modell lässt sich nicht anpassen: Nötig sind Antworten von mindestens {least} Personen zu allen Feedbacks, und nicht alle gleich</translation>
    </message>
    <message>
        <source>the mixed model cannot be fitted: nearly all answers to a feedback are at an end of the scale; use the rank tests</source>
        <translation>das gemischte Modell lässt sich nicht anpassen: Fast alle Antworten zu einem Feedback liegen an einem Ende der Skala; verwenden Sie die Rangtests</translation>
    </message>
    <message>
        <source>the motion in clips of Sony and Insta360 is not read</source>
        <translation>die Bewegung in Clips von Sony und Insta360 wird nicht gelesen</translation>
    </message>
    <message>
        <source>the offset you give, if any; else the clock that clip and log share; else taps and frames</source>
        <translation>der angegebene Versatz, falls es einen gibt; sonst die gemeinsame Uhr von Clip und Protokoll; sonst Klopfzeichen und Bilder</translation>
    </message>
    <message>
        <source>the point {at} has two labels</source>
        <translation>der Punkt {at} hat zwei Beschriftungen</translation>
    </message>
    <message>
        <source>the quaternion Kalman filter of Sabatini 2006</source>
        <translation>das Quaternionen-Kalman-Filter von Sabatini 2006</translation>
    </message>
    <message>
        <source>the rate of its gyroscope is about {times:.2g} times too {how} for how gravity turns in its accelerometer</source>
        <translation>die Drehrate seines Gyroskops ist etwa {times:.2g}-mal zu {how} dafür, wie sich die Schwerkraft in seinem Beschleunigungssensor dreht</translation>
    </message>
    <message>
        <source>the same, forwards and backwards</source>
        <translation>dasselbe, vorwärts und rückwärts</translation>
    </message>
    <message>
        <source>the sequence {key!r}: {reason}</source>
        <translation>die Sequenz {key!r}: {reason}</translation>
    </message>
    <message>
        <source>the server does not answer</source>
        <translation>der Server antwortet nicht</translation>
    </message>
    <message>
        <source>the simulated device stands in</source>
        <translation>das simulierte Gerät springt ein</translation>
    </message>
    <message>
        <source>the slow part of the specific force is gravity</source>
        <translation>der langsame Anteil der spezifischen Kraft ist die Schwerkraft</translation>
    </message>
    <message>
        <source>the standard is not one of two forces</source>
        <translation>der Standard ist keine der zwei Kräfte</translation>
    </message>
    <message>
        <source>the text is too long to be saved ({found_kb} KB, at most {most_kb} KB)</source>
        <translation>der Text ist zu lang zum Speichern ({found_kb} KB, höchstens {most_kb} KB)</translation>
    </message>
    <message>
        <source>the window waits up to 80 ms for work in the background</source>
        <translation>Arbeit im Hintergrund lässt das Fenster bis zu 80 ms warten</translation>
    </message>
    <message>
        <source>the window, and without fifo the loop, have short time slices</source>
        <translation>das Fenster und, ohne fifo, die Schleife haben kurze Zeitscheiben</translation>
    </message>
    <message>
        <source>the window, and without fifo the loop, wait: 437 late wake-ups a minute</source>
        <translation>das Fenster und, ohne fifo, die Schleife warten: 437-mal je Minute wachen sie zu spät auf</translation>
    </message>
    <message>
        <source>there are no frames to write</source>
        <translation>es gibt keine Bilder zu schreiben</translation>
    </message>
    <message>
        <source>there are no participants</source>
        <translation>es gibt keine Teilnehmer</translation>
    </message>
    <message>
        <source>there is a sound card</source>
        <translation>es gibt eine Soundkarte</translation>
    </message>
    <message>
        <source>there is data after the end of the recording</source>
        <translation>nach dem Ende der Aufzeichnung folgen Daten</translation>
    </message>
    <message>
        <source>there is no judgement to analyse</source>
        <translation>es gibt kein Urteil, das sich auswerten ließe</translation>
    </message>
    <message>
        <source>there is no motion to find events in</source>
        <translation>es gibt keine Bewegung, in der Ereignisse gesucht werden könnten</translation>
    </message>
    <message>
        <source>there is no number above 0 to analyse</source>
        <translation>es gibt keine Zahl über 0, die sich auswerten ließe</translation>
    </message>
    <message>
        <source>there is no output {name!r}</source>
        <translation>es gibt keine Ausgabe {name!r}</translation>
    </message>
    <message>
        <source>there is no page {page!r} in {step}</source>
        <translation>in {step} gibt es keine Seite {page!r}</translation>
    </message>
    <message>
        <source>there is no valid motion in the clip to fit a gain to</source>
        <translation>im Clip gibt es keine gültige Bewegung, an die sich eine Verstärkung anpassen ließe</translation>
    </message>
    <message>
        <source>there is none yet</source>
        <translation>es gibt noch keine</translation>
    </message>
    <message>
        <source>these LSL streams are not on this computer: {names}</source>
        <translation>diese LSL-Ströme sind nicht auf diesem Rechner: {names}</translation>
    </message>
    <message>
        <source>this condition needs the sequence of the clip</source>
        <translation>diese Bedingung braucht die Sequenz des Clips</translation>
    </message>
    <message>
        <source>this haptic loop does not accept injected faults</source>
        <translation>diese haptische Schleife nimmt keine eingespielten Fehler an</translation>
    </message>
    <message>
        <source>this installation cannot look at the frames of a clip</source>
        <translation>diese Installation kann die Bilder eines Clips nicht auswerten</translation>
    </message>
    <message>
        <source>this installation has no streams of the kind {name!r}; leave them out</source>
        <translation>diese Installation hat keine Datenströme der Art {name!r}; lassen Sie sie weg</translation>
    </message>
    <message>
        <source>those of the gyroscope not checked: gravity hardly turns</source>
        <translation>die des Gyroskops nicht geprüft: die Schwerkraft dreht sich kaum</translation>
    </message>
    <message>
        <source>tidy CSV with a data dictionary</source>
        <translation>CSV-Tabellen mit einem Verzeichnis der Spalten</translation>
    </message>
    <message>
        <source>times before that of their group count from it</source>
        <translation>Zeiten, die vor der ihrer Gruppe liegen, zählen ab dieser</translation>
    </message>
    <message>
        <source>times in a declared group count from its reference</source>
        <translation>Zeiten in einer deklarierten Gruppe zählen ab deren Verweis</translation>
    </message>
    <message>
        <source>title, mapping and provenance</source>
        <translation>Titel, Zuordnung und Herkunft</translation>
    </message>
    <message>
        <source>to keep it</source>
        <translation>um es zu behalten</translation>
    </message>
    <message>
        <source>to take it as it is</source>
        <translation>um es zu nehmen, wie es ist</translation>
    </message>
    <message>
        <source>true motion of a simulation</source>
        <translation>wahre Bewegung einer Simulation</translation>
    </message>
    <message>
        <source>the frames are uncertain (confidence {confidence:.2f}): the gyro explains {explained:.0%} of the camera&apos;s rotation, at an offset of {offset_s:.3f} s ({doubt})</source>
        <translation>die Bilder sind unsicher (Sicherheit {confidence:.2f}): Das Gyroskop erklärt {explained:.0%} der Drehung der Kamera, bei einem Versatz von {offset_s:.3f} s ({doubt})</translation>
    </message>
    <message>
        <source>A stream of LSL, by its name or type</source>
        <translation>Ein LSL-Stream, nach Name oder Art</translation>
    </message>
    <message>
        <source>Camera and IMU have the recorder&apos;s clock, known to about {sigma_ms:.0f} ms</source>
        <translation>Kamera und IMU haben die Uhr des Rekorders, auf etwa {sigma_ms:.0f} ms genau</translation>
    </message>
    <message>
        <source>Haptic experience</source>
        <translation>Haptisches Erleben</translation>
    </message>
    <message>
        <source>In Sensor Logger: Settings, Data Streaming, HTTP Push, Push URL {url}; then record Accelerometer, Gravity and Gyroscope.</source>
        <translation>In Sensor Logger: Settings, Data Streaming, HTTP Push, Push URL {url}; dann Accelerometer, Gravity und Gyroscope aufnehmen.</translation>
    </message>
    <message>
        <source>Install hapticplayer[websockets]: {how}</source>
        <translation>Installieren Sie hapticplayer[websockets]: {how}</translation>
    </message>
    <message>
        <source>Lines of CSV on standard input (`-`) or a port</source>
        <translation>CSV-Zeilen von der Standardeingabe (`-`) oder einem Port</translation>
    </message>
    <message>
        <source>Motion sickness and vection</source>
        <translation>Bewegungskrankheit und Vektion</translation>
    </message>
    <message>
        <source>Pair of opposites</source>
        <translation>Gegensatzpaar</translation>
    </message>
    <message>
        <source>Razor-AHRS, binary</source>
        <translation>Razor-AHRS, binär</translation>
    </message>
    <message>
        <source>Razor-AHRS, text</source>
        <translation>Razor-AHRS, Text</translation>
    </message>
    <message>
        <source>Recorded here</source>
        <translation>Hier aufgenommen</translation>
    </message>
    <message>
        <source>Sensor Logger on a phone, which posts to this machine</source>
        <translation>Sensor Logger auf einem Telefon, sendet hierher</translation>
    </message>
    <message>
        <source>SensorServer on an Android phone, by WebSocket</source>
        <translation>SensorServer auf Android, per WebSocket</translation>
    </message>
    <message>
        <source>SparkFun Ultimate IMU, text of its stock firmware</source>
        <translation>SparkFun Ultimate IMU, Text der Werksfirmware</translation>
    </message>
    <message>
        <source>The Haptic Experience Inventory (HXI) after each clip; its wording is to be entered from your copy.</source>
        <translation>Das Haptic Experience Inventory (HXI) nach jedem Clip; seinen Wortlaut geben Sie aus Ihrem Exemplar ein.</translation>
    </message>
    <message>
        <source>The measurement in phyphox is started from here.</source>
        <translation>Die Messung in phyphox wird von hier aus gestartet.</translation>
    </message>
    <message>
        <source>The recorder&apos;s clock was {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) off, measured from the {witness}; this is corrected.</source>
        <translation>Die Uhr des Rekorders wich um {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) ab (gemessen: {witness}); das ist korrigiert.</translation>
    </message>
    <message>
        <source>WitMotion WT901 and others with its protocol</source>
        <translation>WitMotion WT901 und andere mit dem Protokoll</translation>
    </message>
    <message>
        <source>a lever arm needs a whole recording; feel the sensor where it is</source>
        <translation>ein Hebelarm braucht eine ganze Aufnahme; spüren Sie den Sensor dort, wo er ist</translation>
    </message>
    <message>
        <source>accel-sign=+ if it reads +1 g on the axis that is up, at rest</source>
        <translation>accel-sign=+, wenn er auf der Achse, die oben ist, in Ruhe +1 g anzeigt</translation>
    </message>
    <message>
        <source>accel-sign=- if it reads -1 g there</source>
        <translation>accel-sign=-, wenn er dort -1 g anzeigt</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>nehmen Sie sich in die Gruppe dialout auf, und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>ask it once, or leave it out</source>
        <translation>fragen Sie es einmal, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>begin with the line {names}, or name the columns</source>
        <translation>beginnen Sie mit der Zeile {names}, oder benennen Sie die Spalten</translation>
    </message>
    <message>
        <source>by the frames</source>
        <translation>nach den Bildern</translation>
    </message>
    <message>
        <source>by the recorder&apos;s clock</source>
        <translation>nach der Uhr des Rekorders</translation>
    </message>
    <message>
        <source>cannot be opened ({reason})</source>
        <translation>kann nicht geöffnet werden ({reason})</translation>
    </message>
    <message>
        <source>cannot be written ({reason})</source>
        <translation>kann nicht geschrieben werden ({reason})</translation>
    </message>
    <message>
        <source>check its cable and its name</source>
        <translation>prüfen Sie Kabel und Namen</translation>
    </message>
    <message>
        <source>check its cable and record again</source>
        <translation>prüfen Sie das Kabel, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>check the cable and the name, see /dev/serial/by-id</source>
        <translation>prüfen Sie Kabel und Namen, siehe /dev/serial/by-id</translation>
    </message>
    <message>
        <source>check the sensor&apos;s cable, power and range</source>
        <translation>prüfen Sie Kabel, Strom und Reichweite des Sensors</translation>
    </message>
    <message>
        <source>choose another camera or microphone, or unload and load the driver (uvcvideo with clock=CLOCK_MONOTONIC)</source>
        <translation>wählen Sie eine andere Kamera oder ein anderes Mikrofon, oder entladen Sie den Treiber und laden Sie ihn neu (uvcvideo mit clock=CLOCK_MONOTONIC)</translation>
    </message>
    <message>
        <source>choose another format of the camera (NAME,input_format=mjpeg)</source>
        <translation>wählen Sie ein anderes Format der Kamera (NAME,input_format=mjpeg)</translation>
    </message>
    <message>
        <source>choose its acceleration with gravity (the raw accelerometer)</source>
        <translation>wählen Sie die Beschleunigung mit Schwerkraft (den rohen Beschleunigungssensor)</translation>
    </message>
    <message>
        <source>choose its acceleration with gravity, or another unit (accel-unit)</source>
        <translation>wählen Sie die Beschleunigung mit Schwerkraft, oder eine andere Einheit (accel-unit)</translation>
    </message>
    <message>
        <source>choose the folder of a recording</source>
        <translation>wählen Sie den Ordner einer Aufnahme</translation>
    </message>
    <message>
        <source>connect it again</source>
        <translation>schließen Sie es wieder an</translation>
    </message>
    <message>
        <source>copy {file} to /etc/udev/rules.d</source>
        <translation>kopieren Sie {file} nach /etc/udev/rules.d</translation>
    </message>
    <message>
        <source>copy {file} to /etc/udev/rules.d and plug it in again</source>
        <translation>kopieren Sie {file} nach /etc/udev/rules.d, und stecken Sie es neu an</translation>
    </message>
    <message>
        <source>delivers nothing more (it has ended)</source>
        <translation>liefert nichts mehr (zu Ende)</translation>
    </message>
    <message>
        <source>devices behind Intiface or Haply&apos;s service are not reached</source>
        <translation>Geräte hinter Intiface oder dem Dienst von Haply sind nicht erreichbar</translation>
    </message>
    <message>
        <source>does not answer ({reason})</source>
        <translation>antwortet nicht ({reason})</translation>
    </message>
    <message>
        <source>does not declare {what}</source>
        <translation>sagt nichts über {what}</translation>
    </message>
    <message>
        <source>enter the wording</source>
        <translation>geben Sie den Wortlaut ein</translation>
    </message>
    <message>
        <source>finish it ({line})</source>
        <translation>schließen Sie sie ab ({line})</translation>
    </message>
    <message>
        <source>give a usual rate, such as baud=115200</source>
        <translation>geben Sie eine übliche Rate an, etwa baud=115200</translation>
    </message>
    <message>
        <source>give its rate, such as baud=115200, and check its output</source>
        <translation>geben Sie seine Rate an, etwa baud=115200, und prüfen Sie seine Ausgabe</translation>
    </message>
    <message>
        <source>give the one that the app shows, such as 192.168.1.20:8080</source>
        <translation>geben Sie die an, die die App zeigt, etwa 192.168.1.20:8080</translation>
    </message>
    <message>
        <source>has ended</source>
        <translation>ist zu Ende</translation>
    </message>
    <message>
        <source>holds no video, only motion</source>
        <translation>enthält kein Video, nur Bewegung</translation>
    </message>
    <message>
        <source>holds the force of a video, and no video of its name lies beside it</source>
        <translation>enthält die Kraft eines Videos, und kein Video dieses Namens liegt daneben</translation>
    </message>
    <message>
        <source>install hapticplayer[cameras], which reads it ({how})</source>
        <translation>installieren Sie hapticplayer[cameras], das es liest ({how})</translation>
    </message>
    <message>
        <source>install hapticplayer[lsl] ({how}), or {otherwise}</source>
        <translation>installieren Sie hapticplayer[lsl] ({how}), oder {otherwise}</translation>
    </message>
    <message>
        <source>install hapticplayer[lsl], or choose another source</source>
        <translation>installieren Sie hapticplayer[lsl], oder wählen Sie eine andere Quelle</translation>
    </message>
    <message>
        <source>install hapticplayer[vision] ({how}), or convert it to H.264</source>
        <translation>installieren Sie hapticplayer[vision] ({how}), oder wandeln Sie es in H.264 um</translation>
    </message>
    <message>
        <source>install hapticplayer[vision], which synchronises without taps, finds the mounting of a sensor and suggests motion for a plain video ({how})</source>
        <translation>installieren Sie hapticplayer[vision], das ohne Klopfen synchronisiert, die Befestigung eines Sensors findet und für ein Video allein Bewegung vorschlägt ({how})</translation>
    </message>
    <message>
        <source>install hapticplayer[{name}] ({how})</source>
        <translation>installieren Sie hapticplayer[{name}] ({how})</translation>
    </message>
    <message>
        <source>is being recorded</source>
        <translation>wird gerade aufgenommen</translation>
    </message>
    <message>
        <source>is not a recording</source>
        <translation>ist keine Aufnahme</translation>
    </message>
    <message>
        <source>is not an address</source>
        <translation>ist keine Adresse</translation>
    </message>
    <message>
        <source>is only used with a mean of at least as many</source>
        <translation>gilt nur bei einem Mittelwert aus mindestens so vielen</translation>
    </message>
    <message>
        <source>is to be worded</source>
        <translation>braucht noch einen Wortlaut</translation>
    </message>
    <message>
        <source>its experiment does not record accelerometer and gyroscope together</source>
        <translation>das Experiment zeichnet Beschleunigungssensor und Gyroskop nicht zusammen auf</translation>
    </message>
    <message>
        <source>its time stamps are {apart_s:.1f} s from this machine&apos;s clock, so nothing could be synchronised with it</source>
        <translation>die Zeitstempel weichen um {apart_s:.1f} s von der Uhr dieses Rechners ab; damit ließe sich nichts synchronisieren</translation>
    </message>
    <message>
        <source>its {count} channels ({labels}) do not say which are the accelerometer&apos;s</source>
        <translation>die {count} Kanäle ({labels}) sagen nicht, welche die des Beschleunigungssensors sind</translation>
    </message>
    <message>
        <source>lay the sensor down and let it rest for {rest_s:.1f} s</source>
        <translation>legen Sie den Sensor hin, und lassen Sie ihn {rest_s:.1f} s ruhen</translation>
    </message>
    <message>
        <source>look at the network and its firewall</source>
        <translation>prüfen Sie das Netz und seine Firewall</translation>
    </message>
    <message>
        <source>make one in phyphox: +, Add simple experiment, Accelerometer and Gyroscope, sensor rate 0 (fastest), then Allow remote access</source>
        <translation>legen Sie eines in phyphox an: +, Einfaches Experiment (Add simple experiment), Accelerometer und Gyroscope, Sensorrate 0 (schnellste), dann Fernzugriff erlauben (Allow remote access)</translation>
    </message>
    <message>
        <source>move the sensor: the grip follows</source>
        <translation>bewegen Sie den Sensor: Der Griff folgt</translation>
    </message>
    <message>
        <source>name questions of the page, or scores before it</source>
        <translation>nennen Sie Fragen der Seite oder Scores davor</translation>
    </message>
    <message>
        <source>name them in their order</source>
        <translation>nennen Sie sie in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>no reports of studies, no figures in files</source>
        <translation>keine Berichte zu Studien, keine Abbildungen in Dateien</translation>
    </message>
    <message>
        <source>no trial is streamed to LabRecorder</source>
        <translation>kein Durchgang wird an LabRecorder gesendet</translation>
    </message>
    <message>
        <source>none of its first {count} frames can be decoded</source>
        <translation>keines der ersten {count} Bilder lässt sich dekodieren</translation>
    </message>
    <message>
        <source>nothing comes from the sensor: check its cable, power, range</source>
        <translation>vom Sensor kommt nichts: Prüfen Sie Kabel, Strom und Reichweite</translation>
    </message>
    <message>
        <source>nothing is recorded; give a camera, an IMU, or both</source>
        <translation>es wird nichts aufgenommen; geben Sie eine Kamera, eine IMU oder beides an</translation>
    </message>
    <message>
        <source>open an experiment in phyphox, and Allow remote access in its menu</source>
        <translation>öffnen Sie ein Experiment in phyphox, und wählen Sie im Menü Fernzugriff erlauben (Allow remote access)</translation>
    </message>
    <message>
        <source>pairs: Wilcoxon with Holm; friedman: Friedman&apos;s test; both exact to {most} participants, then approximations</source>
        <translation>pairs: Wilcoxon mit Holm; friedman: Friedman-Test; beide bis {most} Personen exakt, darüber Näherungen</translation>
    </message>
    <message>
        <source>phyphox on a phone, which is asked</source>
        <translation>phyphox auf einem Telefon, wird abgefragt</translation>
    </message>
    <message>
        <source>put the video there, or give a sequence the force (import-force)</source>
        <translation>legen Sie das Video dorthin, oder geben Sie einer Sequenz die Kraft (import-force)</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lesen</translation>
    </message>
    <message>
        <source>record with a camera, or import a video with this log</source>
        <translation>nehmen Sie mit einer Kamera auf, oder importieren Sie ein Video mit diesem Protokoll</translation>
    </message>
    <message>
        <source>recorded here</source>
        <translation>hier aufgenommen</translation>
    </message>
    <message>
        <source>rotation in the frames</source>
        <translation>Drehung in den Bildern</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>sends acceleration from which gravity was removed</source>
        <translation>sendet eine Beschleunigung, aus der die Schwerkraft entfernt ist</translation>
    </message>
    <message>
        <source>sensor silent</source>
        <translation>Sensor sendet nicht</translation>
    </message>
    <message>
        <source>sound is recorded with a camera; give one</source>
        <translation>Ton wird mit einer Kamera aufgenommen; geben Sie eine an</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>Standardeingabe</translation>
    </message>
    <message>
        <source>start the program that sends it, in the same network</source>
        <translation>starten Sie das Programm, das ihn sendet, im selben Netz</translation>
    </message>
    <message>
        <source>stop the recording first</source>
        <translation>beenden Sie zuerst die Aufnahme</translation>
    </message>
    <message>
        <source>taps</source>
        <translation>Klopfzeichen</translation>
    </message>
    <message>
        <source>the Python package websockets is missing; install hapticplayer[websockets] ({how})</source>
        <translation>das Python-Paket websockets fehlt; installieren Sie hapticplayer[websockets] ({how})</translation>
    </message>
    <message>
        <source>the accelerometer reads {norm_mps2:.3g} m/s2 at rest, gravity is 9.8</source>
        <translation>der Beschleunigungssensor zeigt in Ruhe {norm_mps2:.3g} m/s2, die Schwerkraft ist 9,8</translation>
    </message>
    <message>
        <source>the camera in the frames turns as the gyroscope would at {scale:.3g} times its rate</source>
        <translation>die Kamera in den Bildern dreht sich, wie es das Gyroskop mit der {scale:.3g}-fachen Drehrate täte</translation>
    </message>
    <message>
        <source>the frames place the motion {off_s:+.2f} s from where the recorder&apos;s clock does</source>
        <translation>nach den Bildern liegt die Bewegung um {off_s:+.2f} s anders als nach der Uhr des Rekorders</translation>
    </message>
    <message>
        <source>the report</source>
        <translation>der Bericht</translation>
    </message>
    <message>
        <source>the sensor is heard less than {slow_hz:.0f} times a second and felt in jerks: set it to 100, or choose one that sends each sample at once</source>
        <translation>vom Sensor kommen weniger als {slow_hz:.0f} Werte je Sekunde, die Kraft ruckelt: Stellen Sie ihn auf 100, oder wählen Sie einen, der jeden Wert sofort sendet</translation>
    </message>
    <message>
        <source>the sign of its accelerometer</source>
        <translation>das Vorzeichen seines Beschleunigungssensors</translation>
    </message>
    <message>
        <source>the sound card {card!r} no longer accepts sound ({reason}); connect it and choose the device again</source>
        <translation>die Soundkarte {card!r} nimmt keinen Ton mehr an ({reason}); schließen Sie sie an, und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>the source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>the source sends no angular rate, without which gravity cannot be told from motion; choose one with a gyroscope</source>
        <translation>die Quelle sendet keine Drehrate, ohne die sich Schwerkraft und Bewegung nicht trennen lassen; wählen Sie eine mit Gyroskop</translation>
    </message>
    <message>
        <source>the stream does not answer ({reason})</source>
        <translation>der Stream antwortet nicht ({reason})</translation>
    </message>
    <message>
        <source>the stream&apos;s axes</source>
        <translation>die Achsen des Streams</translation>
    </message>
    <message>
        <source>the taps are uncertain (confidence {confidence:.2f}); the best offset is {offset_s:.3f} s{next_best}</source>
        <translation>das Klopfen ist unsicher (Sicherheit {confidence:.2f}): Der beste Versatz ist {offset_s:.3f} s{next_best}</translation>
    </message>
    <message>
        <source>the times of its packets and the camera&apos;s own place the motion {apart_s:.2f} s apart: the clip was cut</source>
        <translation>die Zeiten der Pakete und die der Kamera legen die Bewegung {apart_s:.2f} s auseinander: Der Clip wurde geschnitten</translation>
    </message>
    <message>
        <source>the unit of its accelerometer</source>
        <translation>die Einheit seines Beschleunigungssensors</translation>
    </message>
    <message>
        <source>the unit of its gyroscope</source>
        <translation>die Einheit seines Gyroskops</translation>
    </message>
    <message>
        <source>the unit of its times is known, or it has no times</source>
        <translation>die Einheit seiner Zeiten ist bekannt, oder es hat keine Zeiten</translation>
    </message>
    <message>
        <source>the {sensor} is slower than the log: each reading is held for {each} rows, so that there are {rate_hz:.4g} a second</source>
        <translation>langsamer als das Protokoll: {sensor}; jeder Messwert wird {each} Zeilen lang gehalten, es sind also {rate_hz:.4g} je Sekunde</translation>
    </message>
    <message>
        <source>the {sensor} repeats its readings as a stuck sensor does, {share:.1%} of the time ({spans} from the start of the log); they are not used</source>
        <translation>{sensor}: Werte wiederholen sich wie bei einem Sensor, der festhängt, {share:.1%} der Zeit ({spans} ab dem Beginn des Protokolls); sie werden nicht verwendet</translation>
    </message>
    <message>
        <source>there is no such stream</source>
        <translation>diesen Stream gibt es nicht</translation>
    </message>
    <message>
        <source>there is no trial {step!r}</source>
        <translation>es gibt keinen Durchgang {step!r}</translation>
    </message>
    <message>
        <source>this is not the video that the force was made for ({reason}): it plays without force</source>
        <translation>dies ist nicht das Video, für das die Kraft gemacht wurde ({reason}): Es läuft ohne Kraft</translation>
    </message>
    <message>
        <source>three channels were taken as x, y and z</source>
        <translation>drei Kanäle gelten als x, y und z</translation>
    </message>
    <message>
        <source>three taps on the camera, heard and felt</source>
        <translation>dreimaliges Klopfen auf die Kamera, gehört und gespürt</translation>
    </message>
    <message>
        <source>timeSamples was not used where it is not that of the rows</source>
        <translation>timeSamples wurde nicht verwendet, wo es nicht zu den Zeilen passt</translation>
    </message>
    <message>
        <source>times were taken as milliseconds</source>
        <translation>Zeiten gelten als Millisekunden</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>gedreht</translation>
    </message>
    <message>
        <source>two outputs send {what}; keep one of them</source>
        <translation>zwei Ausgaben senden {what}; behalten Sie eine davon</translation>
    </message>
    <message>
        <source>two sessions of one code ({here} here, {there} there)</source>
        <translation>zwei Sitzungen mit demselben Code ({here} hier, {there} dort)</translation>
    </message>
    <message>
        <source>unknown entry {name!r}</source>
        <translation>hat den unbekannten Eintrag {name!r}</translation>
    </message>
    <message>
        <source>unpack it and give the file in it</source>
        <translation>entpacken Sie sie und geben Sie die Datei darin an</translation>
    </message>
    <message>
        <source>unpack it and give the folder</source>
        <translation>entpacken Sie es und geben Sie den Ordner an</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>abgezogen</translation>
    </message>
    <message>
        <source>unset {switch}</source>
        <translation>entfernen Sie die Umgebungsvariable {switch}</translation>
    </message>
    <message>
        <source>update the app, or choose another source</source>
        <translation>aktualisieren Sie die App, oder wählen Sie eine andere Quelle</translation>
    </message>
    <message>
        <source>use &apos;repeats&apos;</source>
        <translation>verwenden Sie &apos;repeats&apos;</translation>
    </message>
    <message>
        <source>use L, R, V or A and a digit, such as V0</source>
        <translation>verwenden Sie L, R, V oder A und eine Ziffer, etwa V0</translation>
    </message>
    <message>
        <source>use Python {oldest} or newer, as in Debian 12 and 13</source>
        <translation>verwenden Sie Python {oldest} oder neuer, wie in Debian 12 und 13</translation>
    </message>
    <message>
        <source>use a name in /dev/input, such as event5</source>
        <translation>verwenden Sie einen Namen aus /dev/input, etwa event5</translation>
    </message>
    <message>
        <source>use at most {most} of a-z, 0-9, _ and -, without a - in front</source>
        <translation>nehmen Sie höchstens {most} Zeichen aus a-z, 0-9, _ und -, ohne - am Anfang</translation>
    </message>
    <message>
        <source>utc is not a time with its zone</source>
        <translation>utc ist keine Zeit mit Zeitzone</translation>
    </message>
    <message>
        <source>vibration: full intensity was taken as {full_n:.3g} N</source>
        <translation>Vibration: volle Stärke wurde als {full_n:.3g} N genommen</translation>
    </message>
    <message>
        <source>video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>video and sound</source>
        <translation>Bild und Ton</translation>
    </message>
    <message>
        <source>wait a moment</source>
        <translation>warten Sie einen Moment</translation>
    </message>
    <message>
        <source>wait until nothing writes to it, then start again</source>
        <translation>warten Sie, bis niemand mehr in die Datei schreibt, und beginnen Sie neu</translation>
    </message>
    <message>
        <source>wait until that has finished, or close it, then try again</source>
        <translation>warten Sie, bis es fertig ist, oder schließen Sie es, und versuchen Sie es dann noch einmal</translation>
    </message>
    <message>
        <source>was altered since the study was packed</source>
        <translation>wurde geändert, seit die Studie gepackt wurde</translation>
    </message>
    <message>
        <source>was changed by another program meanwhile</source>
        <translation>wurde inzwischen von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>was changed on the server</source>
        <translation>wurde auf dem Server geändert</translation>
    </message>
    <message>
        <source>was changed or replaced while it was read</source>
        <translation>wurde geändert oder ersetzt, während die Datei gelesen wurde</translation>
    </message>
    <message>
        <source>was made by another process meanwhile</source>
        <translation>wurde inzwischen von einem anderen Prozess angelegt</translation>
    </message>
    <message>
        <source>was not finished</source>
        <translation>wurde nicht abgeschlossen</translation>
    </message>
    <message>
        <source>was shared without its motion, so its force cannot be rendered again</source>
        <translation>wurde ohne ihre Bewegung geteilt, daher kann ihre Kraft nicht neu berechnet werden</translation>
    </message>
    <message>
        <source>was unplugged or closed</source>
        <translation>wurde abgezogen oder geschlossen</translation>
    </message>
    <message>
        <source>was written by another version of the program</source>
        <translation>ist von einer anderen Version des Programms</translation>
    </message>
    <message>
        <source>wavelets were read as envelopes of {carrier_hz:.0f} Hz, their height is estimated</source>
        <translation>Wavelets wurden als Hüllkurven mit {carrier_hz:.0f} Hz gelesen, ihre Höhe ist geschätzt</translation>
    </message>
    <message>
        <source>waves of more than {most_s:.0f} s</source>
        <translation>Wellen von mehr als {most_s:.0f} s</translation>
    </message>
    <message>
        <source>what changes within a millisecond</source>
        <translation>was sich innerhalb einer Millisekunde ändert</translation>
    </message>
    <message>
        <source>what lies before 0 s was left out</source>
        <translation>was vor 0 s liegt, wurde weggelassen</translation>
    </message>
    <message>
        <source>what the processes share is a file for a moment, in /dev/shm</source>
        <translation>was die Prozesse teilen, ist für einen Moment eine Datei in /dev/shm</translation>
    </message>
    <message>
        <source>what the processes share is memory without a name</source>
        <translation>was die Prozesse teilen, ist Speicher ohne Namen</translation>
    </message>
    <message>
        <source>what was recorded lasts from {first_s:.2f} to {last_s:.2f} s, the clip from 0 to {duration_s:.2f} s: it was cut, or plays at another speed</source>
        <translation>das Aufgezeichnete reicht von {first_s:.2f} bis {last_s:.2f} s, der Clip von 0 bis {duration_s:.2f} s: Er wurde geschnitten oder läuft mit anderer Geschwindigkeit</translation>
    </message>
    <message>
        <source>which has no accelerometer samples (DJI stores orientations only)</source>
        <translation>die keine Werte des Beschleunigungssensors hat (DJI speichert nur Ausrichtungen)</translation>
    </message>
    <message>
        <source>which has no motion</source>
        <translation>die keine Bewegung enthält</translation>
    </message>
    <message>
        <source>which nothing here reads</source>
        <translation>die hier nichts liest</translation>
    </message>
    <message>
        <source>while memory is short, the window freezes for up to a second</source>
        <translation>wenn der Arbeitsspeicher knapp ist, steht das Fenster bis zu einer Sekunde still</translation>
    </message>
    <message>
        <source>whoever is in the network and knows the URL can send to port {port} of this machine while it records.</source>
        <translation>wer im Netz ist und die URL kennt, kann während der Aufnahme an Port {port} dieses Rechners senden.</translation>
    </message>
    <message>
        <source>window not responding</source>
        <translation>Fenster reagierte nicht</translation>
    </message>
    <message>
        <source>windows under Wayland</source>
        <translation>Fenster unter Wayland</translation>
    </message>
    <message>
        <source>windows under X11</source>
        <translation>Fenster unter X11</translation>
    </message>
    <message>
        <source>with hapticplayer[vision] installed, the frames are compared with the gyro exactly, and those of H.265 too</source>
        <translation>mit hapticplayer[vision] werden die Bilder genau mit dem Gyroskop verglichen, auch die von H.265</translation>
    </message>
    <message>
        <source>without</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>without labels</source>
        <translation>ohne Beschriftung</translation>
    </message>
    <message>
        <source>work in the background takes only what nobody else wants</source>
        <translation>Arbeit im Hintergrund nimmt nur, was sonst niemand braucht</translation>
    </message>
    <message>
        <source>write numbers without units or signs, or choose another log</source>
        <translation>schreiben Sie Zahlen ohne Einheiten und Zeichen, oder wählen Sie ein anderes Protokoll</translation>
    </message>
    <message>
        <source>write the rows of each sensor to a file of its own and give both</source>
        <translation>schreiben Sie die Zeilen jedes Sensors in eine eigene Datei, und geben Sie beide an</translation>
    </message>
    <message>
        <source>write the time of each sample with all its digits</source>
        <translation>schreiben Sie die Zeit jedes Werts mit allen Ziffern</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>wird geschrieben</translation>
    </message>
    <message>
        <source>writing the force for other programs</source>
        <translation>die Kraft für andere Programme wird geschrieben</translation>
    </message>
    <message>
        <source>writing the logs</source>
        <translation>Protokolle werden geschrieben</translation>
    </message>
    <message>
        <source>writing the numbers</source>
        <translation>Zahlen werden geschrieben</translation>
    </message>
    <message>
        <source>writing {code}</source>
        <translation>{code} wird geschrieben</translation>
    </message>
    <message>
        <source>writing {file}</source>
        <translation>{file} wird geschrieben</translation>
    </message>
    <message>
        <source>writing {name}</source>
        <translation>{name} wird geschrieben</translation>
    </message>
    <message>
        <source>x right, y front, z up, as printed on it</source>
        <translation>x rechts, y vorn, z oben, wie aufgedruckt</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>your quota of the disk at {disk} is used up</source>
        <translation>Ihr Kontingent auf dem Datenträger bei {disk} ist aufgebraucht</translation>
    </message>
    <message>
        <source>your video editor</source>
        <translation>Ihrem Videoschnittprogramm</translation>
    </message>
    <message>
        <source>{added} sessions added, {same} were here already</source>
        <translation>{added} Sitzungen hinzugefügt, {same} waren schon hier</translation>
    </message>
    <message>
        <source>{answer}</source>
        <translation>{answer}</translation>
    </message>
    <message>
        <source>{at_s:.1f} s: {what}</source>
        <translation>{at_s:.1f} s: {what}</translation>
    </message>
    <message>
        <source>{axis} appears twice; the first was read</source>
        <translation>{axis} kommt zweimal vor; gelesen wurde das erste</translation>
    </message>
    <message>
        <source>{begin_s:.2f} to {end_s:.2f} s</source>
        <translation>{begin_s:.2f} bis {end_s:.2f} s</translation>
    </message>
    <message>
        <source>{bytes} bytes, {rate:.3g} kbit/s ({packed:.3g} compressed; the track: {own:.3g})</source>
        <translation>{bytes} Byte, {rate:.3g} kbit/s ({packed:.3g} komprimiert; die Spur: {own:.3g})</translation>
    </message>
    <message>
        <source>{clip}: {why}; {look}</source>
        <translation>{clip}: {why}; {look}</translation>
    </message>
    <message>
        <source>{code}: no record of a device, markers only</source>
        <translation>{code}: keine Aufzeichnung eines Geräts, nur Marker</translation>
    </message>
    <message>
        <source>{code}: played another sequence &apos;{key}&apos; than the sessions here</source>
        <translation>{code}: spielte eine andere Sequenz „{key}“ als die Sitzungen hier</translation>
    </message>
    <message>
        <source>{code}: {reason}</source>
        <translation>{code}: {reason}</translation>
    </message>
    <message>
        <source>{complete} complete, {simulated} simulated; {invalid} of {trials} trials not valid</source>
        <translation>{complete} vollständig, {simulated} simuliert; {invalid} von {trials} Durchgängen ungültig</translation>
    </message>
    <message>
        <source>{count} channels act along x {x:.2f}, y {y:.2f}, z {z:.2f}</source>
        <translation>{count} Kanäle wirken entlang x {x:.2f}, y {y:.2f}, z {z:.2f}</translation>
    </message>
    <message>
        <source>{count} records are missing, the first is number {number}</source>
        <translation>{count} Datensätze fehlen, der erste ist Nummer {number}</translation>
    </message>
    <message>
        <source>{count} rows are damaged</source>
        <translation>{count} Zeilen sind beschädigt</translation>
    </message>
    <message>
        <source>{count} sessions by {program}</source>
        <translation>{count} Sitzungen mit {program}</translation>
    </message>
    <message>
        <source>{count} text answers were left out: they have not been reviewed</source>
        <translation>{count} Textantworten wurden weggelassen: Sie wurden nicht durchgesehen</translation>
    </message>
    <message>
        <source>{count} ticks have times or values that no device has; they are left out</source>
        <translation>{count} Takte haben Zeiten oder Werte, die kein Gerät hat; sie werden weggelassen</translation>
    </message>
    <message>
        <source>{count} trials on {device}</source>
        <translation>{count} Durchgänge mit {device}</translation>
    </message>
    <message>
        <source>{device} is a real device and does not accept injected faults</source>
        <translation>{device} ist ein echtes Gerät und nimmt keine eingespielten Fehler an</translation>
    </message>
    <message>
        <source>{device} option {part!r}: {reason}</source>
        <translation>{device}, Option {part!r}: {reason}</translation>
    </message>
    <message>
        <source>{device}, {state}</source>
        <translation>{device}, {state}</translation>
    </message>
    <message>
        <source>{early} of {count} sessions have answers but were not completed</source>
        <translation>{early} von {count} Sitzungen haben Antworten, wurden aber nicht beendet</translation>
    </message>
    <message>
        <source>{empty} of {count} sessions have no answers</source>
        <translation>{empty} von {count} Sitzungen haben keine Antworten</translation>
    </message>
    <message>
        <source>{file}: is damaged; the definition of the study was used</source>
        <translation>{file}: ist beschädigt; die Definition der Studie wurde verwendet</translation>
    </message>
    <message>
        <source>{file}: is not of this session</source>
        <translation>{file}: gehört nicht zu dieser Sitzung</translation>
    </message>
    <message>
        <source>{file}: {what}</source>
        <translation>{file}: {what}</translation>
    </message>
    <message>
        <source>{file}: {what}; choose the mounting {name}, or another of {known}, or auto for what the frames tell, or forward to keep its axes{sign}</source>
        <translation>{file}: {what}; wählen Sie die Befestigung {name} oder eine andere von {known}, oder auto für das, was die Bilder zeigen, oder forward, um seine Achsen zu behalten{sign}</translation>
    </message>
    <message>
        <source>{folder} cannot be written ({reason}); what was recorded until now is kept</source>
        <translation>{folder} kann nicht geschrieben werden ({reason}); was bisher aufgenommen wurde, bleibt erhalten</translation>
    </message>
    <message>
        <source>{free_gb:.1f} GB free</source>
        <translation>{free_gb:.1f} GB frei</translation>
    </message>
    <message>
        <source>{how} ({size} MB)</source>
        <translation>{how} ({size} MB)</translation>
    </message>
    <message>
        <source>{how}; or {others}</source>
        <translation>{how}; oder {others}</translation>
    </message>
    <message>
        <source>{key!r} is not a feedback</source>
        <translation>{key!r} ist kein Feedback</translation>
    </message>
    <message>
        <source>{key!r} is the name of another condition</source>
        <translation>{key!r} ist der Name einer anderen Bedingung</translation>
    </message>
    <message>
        <source>{key!r} is the name of another step</source>
        <translation>{key!r} ist der Name eines anderen Schritts</translation>
    </message>
    <message>
        <source>{key!r} is the name of the sum of questions</source>
        <translation>{key!r} ist der Name der Summe von Fragen</translation>
    </message>
    <message>
        <source>{key} is not the condition of {step}</source>
        <translation>{key} ist nicht die Bedingung von {step}</translation>
    </message>
    <message>
        <source>{key}={axes} are not three axes; give the sensor&apos;s x, y, z in its columns, such as y,x,z or x,-y,z</source>
        <translation>{key}={axes} sind keine drei Achsen; geben Sie x, y, z des Sensors in seinen Spalten an, etwa y,x,z oder x,-y,z</translation>
    </message>
    <message>
        <source>{key}={axes} if the {sensor} is {how}</source>
        <translation>{key}={axes} im Fall: {sensor} {how}</translation>
    </message>
    <message>
        <source>{key}={factor:.9g} {words}</source>
        <translation>{key}={factor:.9g} {words}</translation>
    </message>
    <message>
        <source>{key}={unit} is not a unit; choose {known}, or give the factor to SI as a number between {least:g} and {largest:g}</source>
        <translation>{key}={unit} ist keine Einheit; wählen Sie {known}, oder geben Sie den Faktor zu SI als Zahl zwischen {least:g} und {largest:g} an</translation>
    </message>
    <message>
        <source>{kind!r}</source>
        <translation>{kind!r}</translation>
    </message>
    <message>
        <source>{kind!r} was read as a sine</source>
        <translation>{kind!r} wurde als Sinus gelesen</translation>
    </message>
    <message>
        <source>{kind} was read as lines</source>
        <translation>{kind} wurde als Geraden gelesen</translation>
    </message>
    <message>
        <source>{modality}: amplitude 1 was taken as {full_n:.3g} N</source>
        <translation>{modality}: Amplitude 1 wurde als {full_n:.3g} N genommen</translation>
    </message>
    <message>
        <source>{more} more</source>
        <translation>{more} weitere</translation>
    </message>
    <message>
        <source>{name!r} has no parameters</source>
        <translation>{name!r} hat keine Parameter</translation>
    </message>
    <message>
        <source>{name!r} is asked for each feedback</source>
        <translation>{name!r} wird für jedes Feedback gefragt</translation>
    </message>
    <message>
        <source>{name!r} is not a number that is known there</source>
        <translation>{name!r} ist dort nicht als Zahl bekannt</translation>
    </message>
    <message>
        <source>{name!r} is not a plain file name</source>
        <translation>{name!r} ist kein einfacher Dateiname</translation>
    </message>
    <message>
        <source>{name!r} is not in &apos;of&apos;</source>
        <translation>{name!r} steht nicht in &apos;of&apos;</translation>
    </message>
    <message>
        <source>{name!r} is the name of a condition; choose another name</source>
        <translation>{name!r} ist der Name einer Bedingung; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>{name!r} is the name of something else</source>
        <translation>{name!r} ist der Name von etwas anderem</translation>
    </message>
    <message>
        <source>{name!r} moves no slider</source>
        <translation>{name!r} bewegt keinen Schieberegler</translation>
    </message>
    <message>
        <source>{name!r} must end with .mkv (one file) or .mp4 (with a side-car)</source>
        <translation>{name!r} muss mit .mkv enden (eine Datei) oder mit .mp4 (mit einer Datei daneben)</translation>
    </message>
    <message>
        <source>{name} beside it was read, too</source>
        <translation>{name} daneben wurde auch gelesen</translation>
    </message>
    <message>
        <source>{name} does not hold numbers only ({reason})</source>
        <translation>{name} enthält nicht nur Zahlen ({reason})</translation>
    </message>
    <message>
        <source>{name} does not know the clip&apos;s clock; use the taps, or enter the offset</source>
        <translation>{name} kennt die Uhr des Clips nicht; nehmen Sie das Klopfen, oder geben Sie den Versatz ein</translation>
    </message>
    <message>
        <source>{name} has the shape {shape}, expected {count} x 3</source>
        <translation>{name} hat die Form {shape}, erwartet wird {count} x 3</translation>
    </message>
    <message>
        <source>{name} has the shape {shape}, expected {expected}</source>
        <translation>{name} hat die Form {shape}, erwartet wird {expected}</translation>
    </message>
    <message>
        <source>{name} has {count} rows, but there are {expected} times</source>
        <translation>{name} hat {count} Zeilen, aber es gibt {expected} Zeiten</translation>
    </message>
    <message>
        <source>{name} holds a value that is not finite in row {row}</source>
        <translation>{name} enthält in Zeile {row} einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>{name} is missing</source>
        <translation>{name} fehlt</translation>
    </message>
    <message>
        <source>{name} is not a number</source>
        <translation>{name} ist keine Zahl</translation>
    </message>
    <message>
        <source>{name} is only read; choose one of {known}</source>
        <translation>{name} wird nur gelesen; wählen Sie eines von {known}</translation>
    </message>
    <message>
        <source>{name} is only written; choose one of {known}</source>
        <translation>{name} wird nur geschrieben; wählen Sie eines von {known}</translation>
    </message>
    <message>
        <source>{name} is out of range</source>
        <translation>{name} liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>{name} is zero, not finite or beyond any sensor in {count} of {total} rows, first in {place}</source>
        <translation>{name} ist in {count} von {total} Zeilen null, nicht endlich oder jenseits jedes Sensors, zuerst in {place}</translation>
    </message>
    <message>
        <source>{name} must be a number</source>
        <translation>{name} muss eine Zahl sein</translation>
    </message>
    <message>
        <source>{name} must be a number, not {text!r}</source>
        <translation>{name} muss eine Zahl sein, nicht {text!r}</translation>
    </message>
    <message>
        <source>{name} must be a positive number, got {value}</source>
        <translation>{name} muss eine positive Zahl sein, war aber {value}</translation>
    </message>
    <message>
        <source>{name} must be a text, not {value}</source>
        <translation>{name} muss ein Text sein, nicht {value}</translation>
    </message>
    <message>
        <source>{name} must be a whole number between {least} and {largest}{unit}, not {text}</source>
        <translation>{name} muss eine ganze Zahl zwischen {least} und {largest}{unit} sein, nicht {text}</translation>
    </message>
    <message>
        <source>{name} must be above zero, not {value}</source>
        <translation>{name} muss über null liegen, ist {value}</translation>
    </message>
    <message>
        <source>{name} must be between {least} and {largest}{unit}, not {text}</source>
        <translation>{name} muss zwischen {least} und {largest}{unit} liegen, nicht {text}</translation>
    </message>
    <message>
        <source>{name} must be one of {known}, not {value}</source>
        <translation>{name} muss eines von {known} sein, nicht {value}</translation>
    </message>
    <message>
        <source>{name} must be positive and finite, got {value}</source>
        <translation>{name} muss positiv und endlich sein, ist {value}</translation>
    </message>
    <message>
        <source>{name} must be true or false</source>
        <translation>{name} muss true oder false sein</translation>
    </message>
    <message>
        <source>{name} must hold real numbers</source>
        <translation>{name} muss reelle Zahlen enthalten</translation>
    </message>
    <message>
        <source>{name} must increase strictly, but row {row} has {time_s:.6f} s after {last_s:.6f} s</source>
        <translation>{name} muss streng steigen, aber in Zeile {row} stehen {time_s:.6f} s nach {last_s:.6f} s</translation>
    </message>
    <message>
        <source>{name} reaches {farthest_s:.3g} s, beyond any clip</source>
        <translation>{name} reicht bis {farthest_s:.3g} s, weiter als jeder Clip</translation>
    </message>
    <message>
        <source>{name} reaches {largest_mps2:.3g} m/s2, beyond what sensors measure</source>
        <translation>{name} erreicht {largest_mps2:.3g} m/s2, mehr als Sensoren messen</translation>
    </message>
    <message>
        <source>{name} was taken as {modality}</source>
        <translation>{name} gilt als {modality}</translation>
    </message>
    <message>
        <source>{name} would be above {most:g}</source>
        <translation>{name} läge über {most:g}</translation>
    </message>
    <message>
        <source>{name}: {kind} has no such parameter; it has {known}</source>
        <translation>{name}: {kind} hat keinen solchen Parameter, sondern {known}</translation>
    </message>
    <message>
        <source>{node}, but this user may not open it</source>
        <translation>{node}, aber dieser Benutzer darf es nicht öffnen</translation>
    </message>
    <message>
        <source>{norm:.2f} m/s2 at rest</source>
        <translation>{norm:.2f} m/s2 in Ruhe</translation>
    </message>
    <message>
        <source>{notes}</source>
        <translation>{notes}</translation>
    </message>
    <message>
        <source>{note} (first in line {line})</source>
        <translation>{note} (zuerst in Zeile {line})</translation>
    </message>
    <message>
        <source>{offset_s:.3f} s, {by}</source>
        <translation>{offset_s:.3f} s, {by}</translation>
    </message>
    <message>
        <source>{one}; {other}</source>
        <translation>{one}; {other}</translation>
    </message>
    <message>
        <source>{option} {key}={value} {fault}; give one value</source>
        <translation>{option} {key}={value} {fault}; geben Sie einen Wert an</translation>
    </message>
    <message>
        <source>{option} {word!r} is not understood; give KEY=VALUE with one of {known}</source>
        <translation>{option} {word!r} wird nicht verstanden; geben Sie KEY=VALUE mit einem von {known} an</translation>
    </message>
    <message>
        <source>{order!r} are not axes, so the telemetry is damaged</source>
        <translation>{order!r} sind keine Achsen, die Telemetrie ist also beschädigt</translation>
    </message>
    <message>
        <source>{output}: {what}</source>
        <translation>{output}: {what}</translation>
    </message>
    <message>
        <source>{package} exists for Python up to {newest} only</source>
        <translation>{package} gibt es nur für Python bis {newest}</translation>
    </message>
    <message>
        <source>{path}: cannot be restored ({reason})</source>
        <translation>{path}: kann nicht zurückgeholt werden ({reason})</translation>
    </message>
    <message>
        <source>{path}: is not a log of {name}</source>
        <translation>{path}: ist kein Protokoll von {name}</translation>
    </message>
    <message>
        <source>{path}: the frame cannot be written; choose another folder in the preferences</source>
        <translation>{path}: Das Bild lässt sich nicht schreiben; wählen Sie in den Voreinstellungen einen anderen Ordner</translation>
    </message>
    <message>
        <source>{path}: {reason}</source>
        <translation>{path}: {reason}</translation>
    </message>
    <message>
        <source>{percent:.2g} % of the time the force is at its limit</source>
        <translation>{percent:.2g} % der Zeit ist die Kraft an ihrer Grenze</translation>
    </message>
    <message>
        <source>{percent} %</source>
        <translation>{percent} %</translation>
    </message>
    <message>
        <source>{place} was left out, as its time is more than an hour apart</source>
        <translation>{place} wurde weggelassen, da ihre Zeit mehr als eine Stunde abliegt</translation>
    </message>
    <message>
        <source>{purpose} needs {packages}, which this installation lacks</source>
        <translation>{purpose} braucht {packages}; das fehlt in dieser Installation</translation>
    </message>
    <message>
        <source>{rate_hz:g} Hz is above the rate of the samples, {input_rate_hz:.4g} Hz</source>
        <translation>{rate_hz:g} Hz liegen über der Rate der Werte, {input_rate_hz:.4g} Hz</translation>
    </message>
    <message>
        <source>{rate} samples per second are set in the sensor and kept.</source>
        <translation>{rate} Werte je Sekunde werden im Sensor eingestellt und bleiben gespeichert.</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>{reason}; the copy in the journal was used</source>
        <translation>{reason}; die Kopie im Journal wurde verwendet</translation>
    </message>
    <message>
        <source>{scripted} of {count} sessions are simulated</source>
        <translation>{scripted} von {count} Sitzungen sind simuliert: Niemand saß dort</translation>
    </message>
    <message>
        <source>{server} answers</source>
        <translation>{server} antwortet</translation>
    </message>
    <message>
        <source>{server} is silent</source>
        <translation>{server} antwortet nicht</translation>
    </message>
    <message>
        <source>{source} cannot send {rate} samples per second at {baud} baud; set it to 115200 baud with its maker&apos;s program, and give baud=115200</source>
        <translation>{source} kann bei {baud} Baud keine {rate} Werte je Sekunde senden; stellen Sie ihn mit dem Programm des Herstellers auf 115200 Baud, und geben Sie baud=115200 an</translation>
    </message>
    <message>
        <source>{source} does not understand {part!r}; give each of {known} once, such as {name}=VALUE</source>
        <translation>{source} versteht {part!r} nicht; geben Sie jedes von {known} einmal an, etwa {name}=WERT</translation>
    </message>
    <message>
        <source>{source} needs a place; give one, such as {option} {source}:{example}</source>
        <translation>{source} braucht einen Anschluss; geben Sie einen an, etwa {option} {source}:{example}</translation>
    </message>
    <message>
        <source>{source}: sound, but none of the known images ({known}; SHA-256 {sha256}...); it would run the motors: say that you want it</source>
        <translation>{source}: einwandfrei, aber keine der bekannten Firmware-Dateien ({known}; SHA-256 {sha256}...); sie würde die Motoren betreiben: Sagen Sie, dass Sie das wollen</translation>
    </message>
    <message>
        <source>{source}: {question} Allow it with {option} {source}:{text},allow=yes</source>
        <translation>{source}: {question} Erlauben Sie es mit {option} {source}:{text},allow=yes</translation>
    </message>
    <message>
        <source>{stream}: ends here, the disk at {disk} is full; what was recorded is kept</source>
        <translation>{stream}: endet hier, der Datenträger bei {disk} ist voll; was aufgenommen wurde, bleibt erhalten</translation>
    </message>
    <message>
        <source>{stream}: is back</source>
        <translation>{stream}: ist wieder da</translation>
    </message>
    <message>
        <source>{stream}: nothing for {stall_s:.1f} s (check the cable, or wake the phone up); the other streams continue</source>
        <translation>{stream}: nichts seit {stall_s:.1f} s (prüfen Sie das Kabel, oder wecken Sie das Telefon); der Rest läuft weiter</translation>
    </message>
    <message>
        <source>{stream}: {what}</source>
        <translation>{stream}: {what}</translation>
    </message>
    <message>
        <source>{switch} names {unknown}, which is not a facility; choose from {known}</source>
        <translation>{switch} nennt {unknown}, das gibt es nicht; wählen Sie aus {known}</translation>
    </message>
    <message>
        <source>{text!r} are not three axes; give the device&apos;s right, up and towards the user in the wearer&apos;s axes (x right, y front, z up), such as x,z,-y, or the nine numbers of a rotation, row by row</source>
        <translation>{text!r} sind keine drei Achsen; gesucht sind rechts, oben und zur Person hin am Gerät, in den Achsen der Person mit dem Rekorder (x rechts, y vorn, z oben), etwa x,z,-y, oder die neun Zahlen einer Drehung, Zeile für Zeile</translation>
    </message>
    <message>
        <source>{text!r} is not HOST:PORT</source>
        <translation>{text!r} ist nicht HOST:PORT</translation>
    </message>
    <message>
        <source>{text!r} is not a parameter; write NAME=VALUE</source>
        <translation>{text!r} ist kein Parameter; schreiben Sie NAME=WERT</translation>
    </message>
    <message>
        <source>{text!r} is not a serial number, which has letters and digits only, nor gain=; see &apos;hapticplayer device list&apos;</source>
        <translation>{text!r} ist weder eine Seriennummer, die nur Buchstaben und Ziffern hat, noch gain=; siehe „hapticplayer device list“</translation>
    </message>
    <message>
        <source>{text!r} is not an address of this machine; give one in full, such as {loopback} or 192.168.1.5</source>
        <translation>{text!r} ist keine Adresse dieses Rechners; geben Sie eine ganz an, etwa {loopback} oder 192.168.1.5</translation>
    </message>
    <message>
        <source>{text}.</source>
        <translation>{text}.</translation>
    </message>
    <message>
        <source>{text}; taps and frames could not correct it: {why}.</source>
        <translation>{text}; Klopfzeichen und Bilder konnten sie nicht korrigieren: {why}.</translation>
    </message>
    <message>
        <source>{time_s:.3g} s is later than any clip</source>
        <translation>{time_s:.3g} s ist später als jeder Clip</translation>
    </message>
    <message>
        <source>{time} jumps back by {jump_s:.6g} s at {place}</source>
        <translation>{time} springt bei {place} um {jump_s:.6g} s zurück</translation>
    </message>
    <message>
        <source>{time} runs at {rate_hz:.3g} samples a second</source>
        <translation>{time} läuft mit {rate_hz:.3g} Werten je Sekunde</translation>
    </message>
    <message>
        <source>{time} runs at {rate_hz:.3g} samples a second, faster than any sensor</source>
        <translation>{time} läuft mit {rate_hz:.3g} Werten je Sekunde, schneller als jeder Sensor</translation>
    </message>
    <message>
        <source>{time} runs backwards at {place}, and no order can be found</source>
        <translation>{time} läuft bei {place} rückwärts, und keine Reihenfolge lässt sich finden</translation>
    </message>
    <message>
        <source>{title} at {where}</source>
        <translation>{title} unter {where}</translation>
    </message>
    <message>
        <source>{title} has no realistic feedback to make {name!r} of; import it first</source>
        <translation>{title} hat kein realistisches Feedback, aus dem {name!r} entstehen kann; importieren Sie den Clip zuerst</translation>
    </message>
    <message>
        <source>{title} refuses the effect ({reason}); close other programs that use it, and choose the device again</source>
        <translation>{title} lehnt den Effekt ab ({reason}); schließen Sie andere Programme, die das Gerät verwenden, und wählen Sie es erneut</translation>
    </message>
    <message>
        <source>{title} was unplugged; plug it in and choose the device again</source>
        <translation>{title} wurde getrennt; schließen Sie es an und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>{title}: permission denied for {path}; add yourself to the group input and log in again</source>
        <translation>{title}: kein Zugriff auf {path}; nehmen Sie sich in die Gruppe input auf und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>{toy} has left Intiface; connect it there and choose the device again</source>
        <translation>{toy} hat Intiface verlassen; verbinden Sie es dort, und wählen Sie das Gerät erneut</translation>
    </message>
    <message>
        <source>{unit} {axes}</source>
        <translation>{unit} {axes}</translation>
    </message>
    <message>
        <source>{unseen_s:.0f} s without estimate: cuts, dark, blurred or empty frames</source>
        <translation>{unseen_s:.0f} s ohne Schätzung: Schnitte, dunkle, unscharfe oder leere Bilder</translation>
    </message>
    <message>
        <source>{used!r} is used by another rating</source>
        <translation>{used!r} wird von einer anderen Bewertung verwendet</translation>
    </message>
    <message>
        <source>{value!r} is not a sequence of this study</source>
        <translation>{value!r} ist keine Sequenz dieser Studie</translation>
    </message>
    <message>
        <source>{value!r} is not allowed</source>
        <translation>ist {value!r}</translation>
    </message>
    <message>
        <source>{value} is not allowed</source>
        <translation>{value} ist nicht erlaubt</translation>
    </message>
    <message>
        <source>{what} ({proof})</source>
        <translation>{what} ({proof})</translation>
    </message>
    <message>
        <source>{what}, but the numbers would fit another unit</source>
        <translation>{what}, aber die Zahlen würden zu einer anderen Einheit passen</translation>
    </message>
    <message>
        <source>{what}, with the axes that were given</source>
        <translation>{what}, mit den angegebenen Achsen</translation>
    </message>
    <message>
        <source>{what}, with the delay that was given</source>
        <translation>{what}, mit der angegebenen Verzögerung</translation>
    </message>
    <message>
        <source>{what}, {why}</source>
        <translation>{what}, {why}</translation>
    </message>
    <message>
        <source>{what}; choose the mounting</source>
        <translation>{what}; wählen Sie die Befestigung</translation>
    </message>
    <message>
        <source>{where} does not answer {name}; restart it</source>
        <translation>{where} antwortet nicht auf {name}; starten Sie es neu</translation>
    </message>
    <message>
        <source>{where} does not answer; see whether the toy is connected and charged, and restart Intiface</source>
        <translation>{where} antwortet nicht; sehen Sie nach, ob das Gerät verbunden und geladen ist, und starten Sie Intiface neu</translation>
    </message>
    <message>
        <source>{where} refuses: {reason}; update it</source>
        <translation>{where} lehnt ab: {reason}; aktualisieren Sie es</translation>
    </message>
    <message>
        <source>{where} sends messages that make no sense; restart it</source>
        <translation>{where} sendet Nachrichten ohne Sinn; starten Sie es neu</translation>
    </message>
    <message>
        <source>{width_px} x {height_px}, {refresh_hz:.0f} Hz, screens: {screens}</source>
        <translation>{width_px} × {height_px}, {refresh_hz:.0f} Hz; Bildschirme: {screens}</translation>
    </message>
    <message>
        <source>{width} x {height} pixels are too large for a frame</source>
        <translation>{width} x {height} Pixel sind zu groß für ein Bild</translation>
    </message>
    <message>
        <source>the log is incomplete ({reason})</source>
        <translation>das Protokoll ist unvollständig ({reason})</translation>
    </message>
    <message>
        <source>the sound output was lost; video and force continue</source>
        <translation>die Tonausgabe ist ausgefallen; Video und Kraft laufen weiter</translation>
    </message>
    <message>
        <source>{count} places are damaged: {first}</source>
        <translation>{count} Stellen sind beschädigt: {first}</translation>
    </message>
    <message>
        <source>{count} positions of {axis} beyond 0 to 100 were limited</source>
        <translation>{count} Positionen von {axis} außerhalb von 0 bis 100 wurden begrenzt</translation>
    </message>
    <message>
        <source>{example} (a name for each column, - to ignore one, / between tables)</source>
        <translation>{example} (ein Name je Spalte, - übergeht eine, / zwischen Tabellen)</translation>
    </message>
    <message>
        <source>{file} is not used: order.method is {method}</source>
        <translation>{file} wird nicht verwendet: order.method ist {method}</translation>
    </message>
    <message>
        <source>{file}: holds another plan</source>
        <translation>{file}: enthält einen anderen Plan</translation>
    </message>
    <message>
        <source>{file}: its times are clock times, not {unit}; leave out time-unit={unit}</source>
        <translation>{file}: Die Zeiten sind Uhrzeiten, nicht {unit}; lassen Sie time-unit={unit} weg</translation>
    </message>
    <message>
        <source>{file}: {option} has no effect: {form} does not use it, or this file says it itself; leave it out</source>
        <translation>{file}: {option} hat keine Wirkung: {form} verwendet es nicht, oder die Datei sagt es selbst; lassen Sie es weg</translation>
    </message>
    <message>
        <source>{file}: {option} {key}={value} has no effect on a log of {form}: {why}; leave it out</source>
        <translation>{file}: {option} {key}={value} hat keine Wirkung auf ein Protokoll von {form}: {why}; lassen Sie es weg</translation>
    </message>
    <message>
        <source>{log} is a motion log; choose the video that it belongs to</source>
        <translation>{log} ist ein Bewegungsprotokoll; wählen Sie das Video, zu dem es gehört</translation>
    </message>
    <message>
        <source>{log}: the taps fit, but the gyro explains only {explained:.0%} of the camera&apos;s rotation in the frames, in any axes: is it the log of this clip, and the video not stabilised? To take the taps alone, say so, or give their offset</source>
        <translation>{log}: Das Klopfen passt, aber das Gyroskop erklärt nur {explained:.0%} der Drehung der Kamera in den Bildern, gleich in welchen Achsen: Gehört das Protokoll zu diesem Clip, und ist das Video nicht stabilisiert? Um das Klopfen allein zu nehmen, geben Sie das an, oder geben Sie seinen Versatz an</translation>
    </message>
    <message>
        <source>{reason}, or set {variable} to another path</source>
        <translation>{reason}, oder setzen Sie {variable} auf einen anderen Pfad</translation>
    </message>
    <message>
        <source>{share} of the motion is not valid (gaps, missing or clipped samples) and has no force</source>
        <translation>{share} der Bewegung ist nicht zu trauen (Lücken, fehlende oder abgeschnittene Werte); dort gibt es keine Kraft</translation>
    </message>
    <message>
        <source>{share} of the samples are at the sensor&apos;s limit</source>
        <translation>{share} der Werte liegen an der Grenze des Sensors</translation>
    </message>
    <message>
        <source>{text!r} is not a number</source>
        <translation>{text!r} ist keine Zahl</translation>
    </message>
    <message>
        <source>{text!r} is not a participant&apos;s code</source>
        <translation>{text!r} ist kein Teilnahmecode</translation>
    </message>
    <message>
        <source>{text} is not a finite number</source>
        <translation>{text} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{time} (or rate-hz=100)</source>
        <translation>{time} (oder rate-hz=100)</translation>
    </message>
    <message>
        <source>{title} has no feedback {name!r}; choose one of {known}</source>
        <translation>{title} hat kein Feedback {name!r}; wählen Sie eines von {known}</translation>
    </message>
    <message>
        <source>{total_s:.4g} s of samples are less than one window of {window_s:.4g} s</source>
        <translation>{total_s:.4g} s Werte sind weniger als ein Fenster von {window_s:.4g} s</translation>
    </message>
    <message>
        <source>{what} ({reason})</source>
        <translation>{what} ({reason})</translation>
    </message>
    <message>
        <source>{what} and are marked as not valid</source>
        <translation>{what} und sind als ungültig markiert</translation>
    </message>
    <message>
        <source>{what}; {remedy}</source>
        <translation>{what}; {remedy}</translation>
    </message>
    <message>
        <source>{where}: waiting for the server</source>
        <translation>{where}: wartet auf den Server</translation>
    </message>
    <message>
        <source>{where}: {reason}</source>
        <translation>{where}: {reason}</translation>
    </message>
    <message>
        <source>{where}: {what}</source>
        <translation>{where}: {what}</translation>
    </message>
    <message>
        <source>CSV in SI units</source>
        <translation>CSV in SI-Einheiten</translation>
    </message>
    <message>
        <source>another camera</source>
        <translation>eine andere Kamera</translation>
    </message>
    <message>
        <source>decreases</source>
        <translation>nimmt ab</translation>
    </message>
    <message>
        <source>the first sudden rise of sound and motion, as in the paper</source>
        <translation>der erste plötzliche Anstieg von Ton und Bewegung, wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>the recording&apos;s own clock</source>
        <translation>die eigene Uhr der Aufnahme</translation>
    </message>
    <message>
        <source>the offset that is given</source>
        <translation>der gegebene Versatz</translation>
    </message>
    <message>
        <source>GoPro</source>
        <translation>GoPro</translation>
    </message>
    <message>
        <source>Sensor Logger</source>
        <translation>Sensor Logger</translation>
    </message>
    <message>
        <source>phyphox</source>
        <translation>phyphox</translation>
    </message>
    <message>
        <source>EuRoC</source>
        <translation>EuRoC</translation>
    </message>
    <message>
        <source>Razor 9DOF</source>
        <translation>Razor 9DOF</translation>
    </message>
    <message>
        <source>Razor M0</source>
        <translation>Razor M0</translation>
    </message>
    <message>
        <source>OpenCamera Sensors</source>
        <translation>OpenCamera Sensors</translation>
    </message>
</context>
</TS>
