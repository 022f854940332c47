<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ai&amp;de</translation>
    </message>
    <message>
        <source>&amp;Open sequence…</source>
        <translation>&amp;Ouvrir une séquence…</translation>
    </message>
    <message>
        <source>Open &amp;video…</source>
        <translation>Ouvrir une &amp;vidéo…</translation>
    </message>
    <message>
        <source>&amp;Import a recording…</source>
        <translation>&amp;Importer un enregistrement…</translation>
    </message>
    <message>
        <source>Li&amp;brary…</source>
        <translation>&amp;Bibliothèque…</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>Ouvrir la &amp;démo</translation>
    </message>
    <message>
        <source>Play a &amp;log…</source>
        <translation>Lire un &amp;journal…</translation>
    </message>
    <message>
        <source>E&amp;xport the settings…</source>
        <translation>E&amp;xporter les réglages…</translation>
    </message>
    <message>
        <source>I&amp;mport settings…</source>
        <translation>I&amp;mporter des réglages…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou suspendre</translation>
    </message>
    <message>
        <source>5 s &amp;back</source>
        <translation>5 s en &amp;arrière</translation>
    </message>
    <message>
        <source>5 s &amp;forward</source>
        <translation>5 s en a&amp;vant</translation>
    </message>
    <message>
        <source>1 min back</source>
        <translation>1 min en arrière</translation>
    </message>
    <message>
        <source>1 min forward</source>
        <translation>1 min en avant</translation>
    </message>
    <message>
        <source>To the b&amp;eginning</source>
        <translation>Au &amp;début</translation>
    </message>
    <message>
        <source>To the e&amp;nd</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Image suivante</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Image précédente</translation>
    </message>
    <message>
        <source>&amp;Loop: from here, to here, off</source>
        <translation>&amp;Boucle&#xa0;: d’ici, à ici, non</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Plus lent</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Plus vite</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>Vitesse normale</translation>
    </message>
    <message>
        <source>Quieter</source>
        <translation>Moins fort</translation>
    </message>
    <message>
        <source>Louder</source>
        <translation>Plus fort</translation>
    </message>
    <message>
        <source>&amp;Mute</source>
        <translation>&amp;Muet</translation>
    </message>
    <message>
        <source>&amp;Stop the force</source>
        <translation>Arrêter la &amp;force</translation>
    </message>
    <message>
        <source>&amp;Re-arm the force</source>
        <translation>&amp;Réarmer la force</translation>
    </message>
    <message>
        <source>Set up the &amp;device…</source>
        <translation>Pré&amp;parer l’appareil…</translation>
    </message>
    <message>
        <source>Get to &amp;know the forces…</source>
        <translation>&amp;Découvrir les forces…</translation>
    </message>
    <message>
        <source>Measure l&amp;atencies…</source>
        <translation>Mesurer les l&amp;atences…</translation>
    </message>
    <message>
        <source>Live &amp;plots</source>
        <translation>&amp;Courbes</translation>
    </message>
    <message>
        <source>Simulated &amp;grip</source>
        <translation>Poi&amp;gnée simulée</translation>
    </message>
    <message>
        <source>S&amp;ync plot</source>
        <translation>Courbe de s&amp;ynchronisation</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>&amp;Statistiques</translation>
    </message>
    <message>
        <source>Fa&amp;ults of the simulated device…</source>
        <translation>Pa&amp;nnes de l’appareil simulé…</translation>
    </message>
    <message>
        <source>&amp;Fullscreen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>&amp;Keyboard…</source>
        <translation>&amp;Clavier…</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>À &amp;propos</translation>
    </message>
</context>
<context>
    <name>AnalysisPage</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>&amp;Analyse</source>
        <translation>&amp;Analyser</translation>
    </message>
    <message>
        <source>Compute statistics and figures anew</source>
        <translation>Recalculer les statistiques et les figures</translation>
    </message>
    <message>
        <source>&amp;Save report…</source>
        <translation>Enregi&amp;strer le rapport…</translation>
    </message>
    <message>
        <source>Write report, figures and numbers into a new folder</source>
        <translation>Écrire le rapport, les figures et les nombres dans un nouveau dossier</translation>
    </message>
    <message>
        <source>Analysing</source>
        <translation>Analyse en cours</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
    </message>
    <message>
        <source>Saved in {0}</source>
        <translation>Enregistré dans {0}</translation>
    </message>
    <message>
        <source>Where shall the folder of the report be made?</source>
        <translation>Où créer le dossier du rapport&#xa0;?</translation>
    </message>
</context>
<context>
    <name>AnalysisWindow</name>
    <message>
        <source>Analysis – {0}</source>
        <translation>Analyse – {0}</translation>
    </message>
</context>
<context>
    <name>Choices</name>
    <message>
        <source>Realistic</source>
        <translation>Réaliste</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléatoire</translation>
    </message>
    <message>
        <source>From file</source>
        <translation>D’un fichier</translation>
    </message>
    <message>
        <source>From a log</source>
        <translation>D’un journal</translation>
    </message>
</context>
<context>
    <name>ChooseMenus</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>Sound &amp;output</source>
        <translation>&amp;Sortie du son</translation>
    </message>
    <message>
        <source>As the system says</source>
        <translation>Celle du système</translation>
    </message>
    <message>
        <source>Fullscreen &amp;on</source>
        <translation>Plein écran s&amp;ur</translation>
    </message>
    <message>
        <source>The window&apos;s screen</source>
        <translation>L’écran de la fenêtre</translation>
    </message>
</context>
<context>
    <name>ClipFrame</name>
    <message>
        <source>Picture at the cursor</source>
        <translation>Image au curseur</translation>
    </message>
</context>
<context>
    <name>Controls</name>
    <message>
        <source>Volume {n} %</source>
        <translation>Volume {n} %</translation>
    </message>
    <message>
        <source>Muted</source>
        <translation>Muet</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Son activé</translation>
    </message>
    <message>
        <source>Speed {x:.2f}</source>
        <translation>Vitesse {x:.2f}</translation>
    </message>
    <message>
        <source>Loop off</source>
        <translation>Boucle désactivée</translation>
    </message>
    <message>
        <source>Loop from {a}</source>
        <translation>Boucle à partir de {a}</translation>
    </message>
    <message>
        <source>Loop from {a} to {b}</source>
        <translation>Boucle de {a} à {b}</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>plays a clip</source>
        <translation>lit une vidéo</translation>
    </message>
</context>
<context>
    <name>DevicePage</name>
    <message>
        <source>Pull the grip out as far as it goes, then push it in until it locks</source>
        <translation>Tirez la poignée à fond, puis enfoncez-la jusqu’au blocage</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Vers la droite</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>Vers la gauche</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Vers le bas</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>Vers vous</translation>
    </message>
    <message>
        <source>Away from you</source>
        <translation>Loin de vous</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Feel every direction, gentle first</source>
        <translation>Sentir chaque direction, doucement d’abord</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Take the force away at once (Esc)</source>
        <translation>Retirer la force immédiatement (Échap)</translation>
    </message>
    <message>
        <source>Hold the grip loosely. You will feel every direction three times, gentle first. Esc, STOP or a button on the grip ends it at once.</source>
        <translation>Tenez la poignée sans serrer. Vous sentirez chaque direction trois fois, doucement d’abord. Échap, STOP ou un bouton de la poignée y met fin aussitôt.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>Get to know the forces: {name}</source>
        <translation>Découvrir les forces&#xa0;: {name}</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Give the device back</source>
        <translation>Rendre l’appareil</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Repos</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>These were all the forces that you can meet.</source>
        <translation>Ce sont toutes les forces que vous pouvez rencontrer.</translation>
    </message>
    <message>
        <source>The haptics process has ended.</source>
        <translation>Le processus haptique s’est terminé.</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open the folder of a sequence</source>
        <translation>Ouvrir le dossier d’une séquence</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Ouvrir une vidéo</translation>
    </message>
    <message>
        <source>Play the force of a log</source>
        <translation>Rejouer la force d’un journal</translation>
    </message>
    <message>
        <source>Logs (*.jsonl *.json *.log);;All files (*)</source>
        <translation>Journaux (*.jsonl *.json *.log);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose a device first, then get to know its forces</source>
        <translation>Choisissez d’abord un appareil, puis découvrez ses forces</translation>
    </message>
    <message>
        <source>Export the settings</source>
        <translation>Exporter les réglages</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Importer des réglages</translation>
    </message>
</context>
<context>
    <name>EmptyPage</name>
    <message>
        <source>Feel the motion of what you watch</source>
        <translation>Ressentez le mouvement de ce que vous regardez</translation>
    </message>
    <message>
        <source>Open a sequence or a video, or drop one here. A video alone plays without force; import it with its motion to feel it.</source>
        <translation>Ouvrez une séquence ou une vidéo, ou déposez-la ici. Une vidéo seule est lue sans force&#xa0;; importez-la avec son mouvement pour le ressentir.</translation>
    </message>
    <message>
        <source>Play the demo</source>
        <translation>Lire la démo</translation>
    </message>
    <message>
        <source>A simulated ride; made on first use</source>
        <translation>Un trajet simulé, créé à la première utilisation</translation>
    </message>
    <message>
        <source>Open a sequence…</source>
        <translation>Ouvrir une séquence…</translation>
    </message>
    <message>
        <source>The folder of a sequence</source>
        <translation>Le dossier d’une séquence</translation>
    </message>
    <message>
        <source>Library…</source>
        <translation>Bibliothèque…</translation>
    </message>
    <message>
        <source>The sequences that were imported</source>
        <translation>Les séquences importées</translation>
    </message>
    <message>
        <source>Import a recording…</source>
        <translation>Importer un enregistrement…</translation>
    </message>
    <message>
        <source>Make a sequence of a video and its motion</source>
        <translation>Créer une séquence d’une vidéo et de son mouvement</translation>
    </message>
    <message>
        <source>Choose the device…</source>
        <translation>Choisir l’appareil…</translation>
    </message>
    <message>
        <source>Which haptic device is moved; the simulated one needs no hardware</source>
        <translation>Quel appareil haptique est mû&#xa0;; le simulé ne demande aucun matériel</translation>
    </message>
</context>
<context>
    <name>ErrorGateway</name>
    <message>
        <source>Something went wrong inside the program ({kind}: {text}); the force was stopped and the playback paused. Details are on the terminal.</source>
        <translation>Une erreur interne s’est produite ({kind}&#xa0;: {text})&#xa0;; la force a été arrêtée et la lecture suspendue. Les détails sont dans le terminal.</translation>
    </message>
</context>
<context>
    <name>Extras</name>
    <message>
        <source>Goes on at {time}; Home for the beginning</source>
        <translation>Reprise à {time}&#xa0;; Origine pour le début</translation>
    </message>
</context>
<context>
    <name>FaultPanel</name>
    <message>
        <source>Re-arm</source>
        <translation>Réarmer</translation>
    </message>
    <message>
        <source>Let the force come back (Ctrl+R)</source>
        <translation>Laisser revenir la force (Ctrl+R)</translation>
    </message>
    <message>
        <source>Device anew</source>
        <translation>Relancer</translation>
    </message>
    <message>
        <source>Start the simulated device again</source>
        <translation>Relancer l’appareil simulé</translation>
    </message>
    <message>
        <source>Faults of the simulated device</source>
        <translation>Pannes de l’appareil simulé</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>No faults any more</source>
        <translation>Plus de pannes</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Panne</translation>
    </message>
    <message>
        <source>Rule that answered</source>
        <translation>Règle appliquée</translation>
    </message>
    <message>
        <source>Reaction, ms</source>
        <translation>Réaction, ms</translation>
    </message>
    <message>
        <source>No force, ms</source>
        <translation>Sans force, ms</translation>
    </message>
    <message>
        <source>What came of the faults</source>
        <translation>Ce que les pannes ont donné</translation>
    </message>
    <message>
        <source>Only a simulated device takes faults, and only while this panel is open: choose it in the window, then press Device anew.</source>
        <translation>Seul un appareil simulé accepte des pannes, et seulement tant que ce panneau est ouvert&#xa0;: choisissez-le dans la fenêtre, puis appuyez sur Relancer.</translation>
    </message>
    <message>
        <source>The device has failed: press Device anew.</source>
        <translation>L’appareil est en panne&#xa0;: appuyez sur Relancer.</translation>
    </message>
    <message>
        <source>Play a clip with force, so that there is one to take away.</source>
        <translation>Lisez un clip avec force, pour qu’il y en ait une à retirer.</translation>
    </message>
    <message>
        <source>There is a force. Press a fault and watch what takes it away.</source>
        <translation>Il y a une force. Choisissez une panne et regardez ce qui la retire.</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>Unplug it</source>
        <translation>Débrancher</translation>
    </message>
    <message>
        <source>Stall, 60 ms</source>
        <translation>Blocage, 60&#xa0;ms</translation>
    </message>
    <message>
        <source>Stall, 300 ms</source>
        <translation>Blocage, 300&#xa0;ms</translation>
    </message>
    <message>
        <source>Nonsense answers</source>
        <translation>Réponses absurdes</translation>
    </message>
    <message>
        <source>Lose the homing</source>
        <translation>Perdre le zéro</translation>
    </message>
    <message>
        <source>Let go of the grip</source>
        <translation>Lâcher la poignée</translation>
    </message>
    <message>
        <source>Press a grip button</source>
        <translation>Bouton de la poignée</translation>
    </message>
    <message>
        <source>Position is NaN</source>
        <translation>Position NaN</translation>
    </message>
    <message>
        <source>Force is NaN</source>
        <translation>Force NaN</translation>
    </message>
    <message>
        <source>Loop late, 35 ms</source>
        <translation>Boucle en retard, 35 ms</translation>
    </message>
    <message>
        <source>Loop still, 80 ms</source>
        <translation>Boucle figée, 80 ms</translation>
    </message>
    <message>
        <source>Command 25 ms old</source>
        <translation>Commande âgée de 25 ms</translation>
    </message>
    <message>
        <source>Window hangs, 0.4 s</source>
        <translation>Fenêtre figée, 0,4 s</translation>
    </message>
    <message>
        <source>Window hangs, 1.3 s</source>
        <translation>Fenêtre figée, 1,3 s</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.webm *.m4v *.360 *.MP4 *.MOV *.LRV);;All files (*)</source>
        <translation>Vidéos (*.mp4 *.mov *.mkv *.avi *.webm *.m4v *.360 *.MP4 *.MOV *.LRV);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Settings (*.json)</source>
        <translation>Réglages (*.json)</translation>
    </message>
</context>
<context>
    <name>FilesPage</name>
    <message>
        <source>Video</source>
        <translation>Vidéo</translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation>Journal de mouvement</translation>
    </message>
    <message>
        <source>inside the video</source>
        <translation>dans la vidéo</translation>
    </message>
    <message>
        <source>Drop a recording here</source>
        <translation>Déposez un enregistrement ici</translation>
    </message>
    <message>
        <source>&amp;Keep the answers…</source>
        <translation>&amp;Garder les réponses…</translation>
    </message>
    <message>
        <source>Write a template for all logs of this logger</source>
        <translation>Écrire un modèle pour tous les journaux de cet enregistreur</translation>
    </message>
    <message>
        <source>Drop a video here, with the log of its motion sensor if that was a device of its own. GoPro cameras keep their motion inside the video.</source>
        <translation>Déposez ici une vidéo, avec le journal de son capteur de mouvement si c’était un appareil à part. Les caméras GoPro gardent le mouvement dans la vidéo.</translation>
    </message>
    <message>
        <source>&amp;Video</source>
        <translation>&amp;Vidéo</translation>
    </message>
    <message>
        <source>Motion &amp;log</source>
        <translation>&amp;Journal</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>with sound</source>
        <translation>avec son</translation>
    </message>
    <message>
        <source>without sound</source>
        <translation>sans son</translation>
    </message>
    <message>
        <source>Video: {camera}{width} × {height}, {rate} pictures a second, {duration}, {sound}</source>
        <translation>Vidéo&#xa0;: {camera}{width} × {height}, {rate} images par seconde, {duration}, {sound}</translation>
    </message>
    <message>
        <source>Motion: {recorder}, {rate} samples a second, {duration}, gaps: {gaps}</source>
        <translation>Mouvement&#xa0;: {recorder}, {rate} mesures par seconde, {duration}, lacunes&#xa0;: {gaps}</translation>
    </message>
    <message>
        <source>It turned so much that gravity does not show its axes.</source>
        <translation>Il a tant tourné que la pesanteur ne montre pas ses axes.</translation>
    </message>
    <message>
        <source>Axes: x to its right, y to its front, z to its top; on average {up} was up</source>
        <translation>Axes&#xa0;: x vers sa droite, y vers l’avant, z vers le haut&#xa0;; en moyenne {up} était en haut</translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation>Choisir une vidéo</translation>
    </message>
    <message>
        <source>Motion logs (*.csv *.txt *.log *.zip *.gcsv *.json *.bin *.gpmf);;All files (*)</source>
        <translation>Journaux de mouvement (*.csv *.txt *.log *.zip *.gcsv *.json *.bin *.gpmf);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose a motion log</source>
        <translation>Choisir un journal de mouvement</translation>
    </message>
    <message>
        <source>Templates (*.json)</source>
        <translation>Modèles (*.json)</translation>
    </message>
    <message>
        <source>Choose a template</source>
        <translation>Choisir un modèle</translation>
    </message>
    <message>
        <source>Where shall the template be written?</source>
        <translation>Où faut-il écrire le modèle&#xa0;?</translation>
    </message>
</context>
<context>
    <name>FirmwareDialog</name>
    <message>
        <source>The Falcon&apos;s firmware</source>
        <translation>Le micrologiciel du Falcon</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.BIN);;All files (*)</source>
        <translation>Micrologiciel (*.bin *.BIN);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>I accept the licence</source>
        <translation>J’accepte la licence</translation>
    </message>
    <message>
        <source>Keep it all the same</source>
        <translation>Le garder quand même</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>GripView</name>
    <message>
        <source>No device: choose {name} to see what would be felt</source>
        <translation>Aucun appareil&#xa0;: choisissez {name} pour voir ce qui serait ressenti</translation>
    </message>
    <message>
        <source>The device has failed</source>
        <translation>L’appareil est en panne</translation>
    </message>
    <message>
        <source>The haptics process has ended</source>
        <translation>Le processus haptique s’est terminé</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>The position is not known</source>
        <translation>La position n’est pas connue</translation>
    </message>
    <message>
        <source>Simulated grip</source>
        <translation>Poignée simulée</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Poignée</translation>
    </message>
    <message>
        <source>Force is off</source>
        <translation>La force est coupée</translation>
    </message>
    <message>
        <source>Force is {what}</source>
        <translation>Force&#xa0;: {what}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>vers vous</translation>
    </message>
    <message>
        <source>Thick arrow: the force on the hand. Thin white arrow: the planned force. Purple arrow: the share that keeps the grip inside.
Drag or use the arrow keys to look from elsewhere, the wheel or + and − to come nearer, a double click or 0 to go back.</source>
        <translation>Flèche épaisse&#xa0;: la force sur la main. Flèche fine&#xa0;: la force prévue. Flèche violette&#xa0;: la part qui garde la poignée à l’intérieur.
Glissez ou utilisez les flèches pour tourner la vue, la molette ou + et − pour l’approcher, un double clic ou 0 pour revenir.</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Aucun appareil</translation>
    </message>
    <message>
        <source>force {force}, grip {out} from the centre</source>
        <translation>force {force}, poignée à {out} du centre</translation>
    </message>
    <message>
        <source>{force:.1f} N</source>
        <translation>{force:.1f} N</translation>
    </message>
    <message>
        <source>centring {force:.1f} N</source>
        <translation>centrage {force:.1f} N</translation>
    </message>
    <message>
        <source>{out:.0f} mm of {most:.0f}</source>
        <translation>{out:.0f} mm sur {most:.0f}</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>démarrage</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>en panne</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>pull the grip out, then push it in</source>
        <translation>tirez la poignée, puis enfoncez-la</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Falcon</source>
        <translation>Falcon</translation>
    </message>
    <message>
        <source>Falcon on simulated USB</source>
        <translation>Falcon sur USB simulé</translation>
    </message>
    <message>
        <source>Game pad</source>
        <translation>Manette</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>fading in</source>
        <translation>monte</translation>
    </message>
    <message>
        <source>active</source>
        <translation>en marche</translation>
    </message>
    <message>
        <source>fading out</source>
        <translation>descend</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>ARRÊT</translation>
    </message>
    <message>
        <source>the window hung</source>
        <translation>la fenêtre était figée</translation>
    </message>
    <message>
        <source>the player ended</source>
        <translation>le lecteur s’est terminé</translation>
    </message>
    <message>
        <source>the track is broken</source>
        <translation>la piste est défectueuse</translation>
    </message>
    <message>
        <source>button on the grip</source>
        <translation>bouton de la poignée</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>débranché</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>l’appareil ne répond pas</translation>
    </message>
    <message>
        <source>the device answers nonsense</source>
        <translation>l’appareil répond n’importe quoi</translation>
    </message>
    <message>
        <source>the computer stood still</source>
        <translation>l’ordinateur s’est figé</translation>
    </message>
    <message>
        <source>the grip was let go</source>
        <translation>la poignée a été lâchée</translation>
    </message>
    <message>
        <source>the grip is at its edge</source>
        <translation>la poignée est au bord</translation>
    </message>
    <message>
        <source>FIFO</source>
        <translation>FIFO</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>tranche</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>no, {us:.0f} µs, {missed} missed</source>
        <translation>non, {us:.0f} µs, manqués&#xa0;: {missed}</translation>
    </message>
    <message>
        <source>yes, {us:.0f} µs, {missed} missed</source>
        <translation>oui, {us:.0f} µs, manqués&#xa0;: {missed}</translation>
    </message>
    <message>
        <source>OFF {p50:+.1f}, {p95:+.1f} ms</source>
        <translation>DÉCALÉ {p50:+.1f}&#xa0;; {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{p50:+.1f}, {p95:+.1f} ms</source>
        <translation>{p50:+.1f}&#xa0;; {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>vues&#xa0;: {shown}, sautées&#xa0;: {dropped}</translation>
    </message>
    <message>
        <source>damaged: {damaged} broken, {dropped} dropped</source>
        <translation>clip endommagé, illisibles&#xa0;: {damaged}, perdues&#xa0;: {dropped}</translation>
    </message>
    <message>
        <source>audio</source>
        <translation>son</translation>
    </message>
    <message>
        <source>no sound</source>
        <translation>pas de son</translation>
    </message>
    <message>
        <source>monotonic</source>
        <translation>monotone</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>pas de données</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>watch</source>
        <translation>à surveiller</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvais</translation>
    </message>
</context>
<context>
    <name>HealthLine</name>
    <message>
        <source>Health</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>The haptic device and what it does</source>
        <translation>L’appareil haptique et ce qu’il fait</translation>
    </message>
    <message>
        <source>Simulated, fading out</source>
        <translation>Simulé, descend</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Priorité</translation>
    </message>
    <message>
        <source>Class of the 1 kHz loop: FIFO is best, slice nearly as good, normal lets it be late by milliseconds</source>
        <translation>Classe de la boucle à 1 kHz&#xa0;: FIFO est la meilleure, tranche presque aussi bonne, normal la laisse en retard de millisecondes</translation>
    </message>
    <message>
        <source>Real-time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>99 % of the loop&apos;s wake-ups in the last 10 s were no later than this; missed are periods that were skipped. When more than 1 % are, the force is held to 3 N</source>
        <translation>99 % des réveils des 10 dernières s n’étaient pas plus en retard&#xa0;; les manqués sont des périodes sautées. Au-delà de 1 %, la force est limitée à 3 N</translation>
    </message>
    <message>
        <source>yes, 888 µs, 88 missed</source>
        <translation>oui, 888 µs, 88 manqués</translation>
    </message>
    <message>
        <source>Force − picture</source>
        <translation>Force − image</translation>
    </message>
    <message>
        <source>How much later the force comes than its picture: median and 95 % of the last 20 s. More than 15 ms early or 50 ms late is felt</source>
        <translation>Retard de la force sur son image&#xa0;: médiane et 95 % des 20 dernières secondes. Plus de 15 ms d’avance ou 50 ms de retard se sentent</translation>
    </message>
    <message>
        <source>OFF +88.8, +88.8 ms</source>
        <translation>DÉCALÉ +88,8, +88,8 ms</translation>
    </message>
    <message>
        <source>How much later the force comes than its sound: median and 95 % of the last 20 s. More than 15 ms early or 50 ms late is felt</source>
        <translation>Retard de la force sur son son&#xa0;: médiane et 95 % des 20 dernières secondes. Plus de 15 ms d’avance ou 50 ms de retard se sentent</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Force − son</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Shown in time, and dropped because they came too late</source>
        <translation>Montrées à temps, et sautées parce qu’elles venaient trop tard</translation>
    </message>
    <message>
        <source>88888 shown, 88 dropped</source>
        <translation>88888 vues, 88 sautées</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>What leads: the sound that is heard, or the machine&apos;s monotonic clock where there is no sound</source>
        <translation>Ce qui mène&#xa0;: le son entendu, ou l’horloge monotone de la machine sans son</translation>
    </message>
    <message>
        <source>monotonic</source>
        <translation>monotone</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>About hapticplayer</source>
        <translation>À propos de hapticplayer</translation>
    </message>
    <message>
        <source>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Plays a video and lets you feel the motion of whoever recorded it.&lt;/p&gt;&lt;p&gt;After Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Lit une vidéo et fait ressentir le mouvement de la personne qui l’a filmée.&lt;/p&gt;&lt;p&gt;D’après Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;Licence MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>HomingPicture</name>
    <message>
        <source>The Falcon&apos;s grip</source>
        <translation>La poignée du Falcon</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>De profil</translation>
    </message>
    <message>
        <source>top</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>bas gauche</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aucune encore</translation>
    </message>
    <message>
        <source>Homed: {legs}</source>
        <translation>Initialisées&#xa0;: {legs}</translation>
    </message>
    <message>
        <source>in</source>
        <translation>dedans</translation>
    </message>
    <message>
        <source>out</source>
        <translation>dehors</translation>
    </message>
</context>
<context>
    <name>ImportWizard</name>
    <message>
        <source>Import a recording</source>
        <translation>Importer un enregistrement</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Stop this work; nothing is left behind</source>
        <translation>Arrêter ce travail&#xa0;; rien n’est laissé</translation>
    </message>
    <message>
        <source>&amp;Import another…</source>
        <translation>&amp;Importer un autre…</translation>
    </message>
    <message>
        <source>Begin again with other files</source>
        <translation>Recommencer avec d’autres fichiers</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retour</translation>
    </message>
    <message>
        <source>To the step before</source>
        <translation>À l’étape précédente</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <source>To the next step</source>
        <translation>À l’étape suivante</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Fermer cette fenêtre</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>Synchroniser</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Fixation</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>&amp;Play it</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Looking at {0}</source>
        <translation>Examen de {0}</translation>
    </message>
    <message>
        <source>Importing {0}</source>
        <translation>Importation de {0}</translation>
    </message>
</context>
<context>
    <name>JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop this work; nothing is left behind</source>
        <translation>Arrêter ce travail&#xa0;; il n’en reste rien</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nouvelle touche</translation>
    </message>
    <message>
        <source>Press the key that the chosen command shall have</source>
        <translation>Appuyez sur la touche que la commande choisie doit avoir</translation>
    </message>
    <message>
        <source>Use this key</source>
        <translation>Utiliser la touche</translation>
    </message>
    <message>
        <source>Give the key to the chosen command</source>
        <translation>Donner la touche à la commande choisie</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Give the chosen command its first keys again</source>
        <translation>Rendre à la commande choisie ses premières touches</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout rétablir</translation>
    </message>
    <message>
        <source>Give every command its first keys again</source>
        <translation>Rendre à chaque commande ses premières touches</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Commandes et leurs touches</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>This key always stops the force; it stays</source>
        <translation>Cette touche arrête toujours la force&#xa0;; elle reste</translation>
    </message>
    <message>
        <source>Press a key in the field first</source>
        <translation>Appuyez d’abord sur une touche dans le champ</translation>
    </message>
    <message>
        <source>{key} is taken by “{command}”</source>
        <translation>{key} est prise par «&#xa0;{command}&#xa0;»</translation>
    </message>
</context>
<context>
    <name>LatencyPage</name>
    <message>
        <source>Preparing</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>All together, compensated</source>
        <translation>Tout ensemble, compensé</translation>
    </message>
    <message>
        <source>Tap to the picture</source>
        <translation>Taper sur l’image</translation>
    </message>
    <message>
        <source>Tap to the sound</source>
        <translation>Taper sur le son</translation>
    </message>
    <message>
        <source>Tap to the force</source>
        <translation>Taper sur la force</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Play a beat each second</source>
        <translation>Jouer un battement chaque seconde</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Take the force away at once (Esc)</source>
        <translation>Couper la force immédiatement (Échap)</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>Taper</translation>
    </message>
    <message>
        <source>Tap with each beat (space bar)</source>
        <translation>Taper à chaque battement (barre d’espace)</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Remember these numbers for these outputs</source>
        <translation>Retenir ces valeurs pour ces sorties</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Measure latencies</source>
        <translation>Mesurer les latences</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Ne rien changer</translation>
    </message>
    <message>
        <source>{n} of {least} taps</source>
        <translation>Frappes&#xa0;: {n} sur {least}</translation>
    </message>
    <message>
        <source>{n} taps: {ms:.0f} ± {spread:.0f} ms</source>
        <translation>{n} frappes&#xa0;: {ms:.0f} ± {spread:.0f} ms</translation>
    </message>
    <message>
        <source>Each second there are a flash, a beep and a gentle push. Hold the grip loosely and press Start. Esc, STOP or a button on the grip ends it.</source>
        <translation>Chaque seconde viennent un éclair, un bip et une légère poussée. Tenez la poignée sans serrer et appuyez sur Démarrer. Échap, STOP ou un bouton de la poignée y met fin.</translation>
    </message>
    <message>
        <source>Change the numbers until flash, beep and push come together. What comes late needs a larger number.</source>
        <translation>Changez les valeurs jusqu’à ce que l’éclair, le bip et la poussée viennent ensemble. Ce qui vient trop tard demande une valeur plus grande.</translation>
    </message>
    <message>
        <source>Press the space bar with each beat, at least eight times; first to the picture, then to the sound and the force. The differences are put into the numbers; refine them with all together.</source>
        <translation>Appuyez sur la barre d’espace à chaque battement, au moins huit fois&#xa0;; d’abord sur l’image, puis sur le son et la force. Les différences sont reportées dans les valeurs&#xa0;; affinez-les avec tout ensemble.</translation>
    </message>
</context>
<context>
    <name>LatencyWatch</name>
    <message>
        <source>The sound output {name} is {ms:.0f} ms behind</source>
        <translation>La sortie son {name} a {ms:.0f} ms de retard</translation>
    </message>
    <message>
        <source>The sound output {name} seems to be wireless</source>
        <translation>La sortie son {name} semble être sans fil</translation>
    </message>
    <message>
        <source>it may be later still than it says. Use headphones with a cable, or measure it: Playback, Measure latencies</source>
        <translation>elle peut être encore plus en retard qu’elle ne le dit. Prenez un casque à fil, ou mesurez-la&#xa0;: Lecture, Mesurer les latences</translation>
    </message>
</context>
<context>
    <name>LibraryDetails</name>
    <message>
        <source>Force tracks</source>
        <translation>Pistes de force</translation>
    </message>
    <message>
        <source>Force track</source>
        <translation>Piste de force</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Crête</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Espace de travail</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source> N per m/s²</source>
        <translation> N par m/s²</translation>
    </message>
    <message>
        <source>&amp;Add a track…</source>
        <translation>&amp;Ajouter une piste…</translation>
    </message>
    <message>
        <source>A force track from a CSV file</source>
        <translation>Une piste de force depuis un fichier CSV</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>&amp;Renommer…</translation>
    </message>
    <message>
        <source>Rename the track</source>
        <translation>Renommer la piste</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Enlever</translation>
    </message>
    <message>
        <source>Remove the track</source>
        <translation>Enlever la piste</translation>
    </message>
    <message>
        <source>Use this &amp;gain</source>
        <translation>Prendre ce &amp;gain</translation>
    </message>
    <message>
        <source>Make the realistic and the random track anew</source>
        <translation>Refaire la piste réaliste et l’aléatoire</translation>
    </message>
    <message>
        <source>about {peak} N at the peak, {rms} N RMS…</source>
        <translation>environ {peak} N de crête, {rms} N RMS…</translation>
    </message>
    <message>
        <source>{peak} N at the peak, {rms} N RMS, {share} of the samples at the limit; workspace: relaxed hand {relaxed}, normal {normal}, firm {firm}</source>
        <translation>{peak} N de crête, {rms} N RMS, {share} des valeurs à la limite&#xa0;; espace de travail&#xa0;: main souple {relaxed}, normale {normal}, ferme {firm}</translation>
    </message>
    <message>
        <source>the force would stop</source>
        <translation>la force s’arrêterait</translation>
    </message>
    <message>
        <source>Making the force anew</source>
        <translation>La force est refaite</translation>
    </message>
    <message>
        <source>Force tracks (*.csv);;All files (*)</source>
        <translation>Pistes de force (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose a force track</source>
        <translation>Choisir une piste de force</translation>
    </message>
    <message>
        <source>Adding {name}</source>
        <translation>Ajout de {name}</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
</context>
<context>
    <name>LibraryPage</name>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Bring back what was deleted last</source>
        <translation>Ramener ce qui a été supprimé en dernier</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;rrêter</translation>
    </message>
    <message>
        <source>Stop this work; nothing is left behind</source>
        <translation>Arrêter ce travail&#xa0;; rien n’est laissé</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Bring in a recording</source>
        <translation>Apporter un enregistrement</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Show another folder</source>
        <translation>Montrer un autre dossier</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>Re&amp;nommer…</translation>
    </message>
    <message>
        <source>Another title</source>
        <translation>Un autre titre</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>&amp;Vérifier</translation>
    </message>
    <message>
        <source>Read every file, check it</source>
        <translation>Lire et contrôler chaque fichier</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Supprimer…</translation>
    </message>
    <message>
        <source>Move it to the bin</source>
        <translation>Mettre à la corbeille</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Play it (Enter)</source>
        <translation>Lire (Entrée)</translation>
    </message>
    <message>
        <source>There is nothing here yet; import a recording.</source>
        <translation>Il n’y a encore rien ici&#xa0;; importez un enregistrement.</translation>
    </message>
    <message>
        <source>Nothing is called so</source>
        <translation>Rien ne porte ce nom</translation>
    </message>
    <message>
        <source>Where are sequences kept?</source>
        <translation>Où sont gardées les séquences&#xa0;?</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>{title}: every file is as it was written</source>
        <translation>{title}&#xa0;: chaque fichier est tel qu’il a été écrit</translation>
    </message>
    <message>
        <source>Move {title} to the bin? It can be brought back from there.</source>
        <translation>Mettre {title} à la corbeille&#xa0;? On peut l’en ramener.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>{title} cannot be moved to the bin; nothing was deleted.</source>
        <translation>{title} ne peut être mis à la corbeille&#xa0;; rien n’a été supprimé.</translation>
    </message>
    <message>
        <source>{title} is in the bin.</source>
        <translation>{title} est à la corbeille.</translation>
    </message>
</context>
<context>
    <name>LookMenus</name>
    <message>
        <source>&amp;Look</source>
        <translation>Appare&amp;nce</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Lan&amp;gue (Language)</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>Masquer ce message</translation>
    </message>
</context>
<context>
    <name>Mirror</name>
    <message>
        <source>The participant&apos;s picture</source>
        <translation>L’image du participant</translation>
    </message>
    <message>
        <source>A page is shown</source>
        <translation>Une page est affichée</translation>
    </message>
</context>
<context>
    <name>MountingPage</name>
    <message>
        <source>Mounting</source>
        <translation>Fixation</translation>
    </message>
    <message>
        <source>The device stands</source>
        <translation>L’appareil se trouve</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source> N per m/s²</source>
        <translation> N par m/s²</translation>
    </message>
    <message>
        <source>The same for all sequences that are to be compared</source>
        <translation>Le même pour toutes les séquences à comparer</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Looks forward, upright</source>
        <translation>Regarde devant, à l’endroit</translation>
    </message>
    <message>
        <source>Looks forward, upside down</source>
        <translation>Regarde devant, à l’envers</translation>
    </message>
    <message>
        <source>Looks backward, upright</source>
        <translation>Regarde derrière, à l’endroit</translation>
    </message>
    <message>
        <source>Looks to the right, upright</source>
        <translation>Regarde à droite, à l’endroit</translation>
    </message>
    <message>
        <source>Looks to the left, upright</source>
        <translation>Regarde à gauche, à l’endroit</translation>
    </message>
    <message>
        <source>Looks forward, left side up</source>
        <translation>Regarde devant, côté gauche en haut</translation>
    </message>
    <message>
        <source>Looks forward, right side up</source>
        <translation>Regarde devant, côté droit en haut</translation>
    </message>
    <message>
        <source>Lies on its back, looks up</source>
        <translation>Sur le dos, regarde en haut</translation>
    </message>
    <message>
        <source>Looks down</source>
        <translation>Regarde en bas</translation>
    </message>
    <message>
        <source>Right {right}, front {front}, up {up}</source>
        <translation>Droite {right}, avant {front}, haut {up}</translation>
    </message>
    <message>
        <source>before its user: forward pulls the hand away</source>
        <translation>devant la personne&#xa0;: l’avant tire la main</translation>
    </message>
    <message>
        <source>to the right of its user</source>
        <translation>à droite de la personne</translation>
    </message>
    <message>
        <source>behind its user</source>
        <translation>derrière la personne</translation>
    </message>
    <message>
        <source>to the left of its user</source>
        <translation>à gauche de la personne</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Changer…</translation>
    </message>
    <message>
        <source>Keep sequences in another folder</source>
        <translation>Garder les séquences dans un autre dossier</translation>
    </message>
    <message>
        <source>&amp;Mounting</source>
        <translation>&amp;Fixation</translation>
    </message>
    <message>
        <source>The &amp;device stands</source>
        <translation>L’&amp;appareil se trouve</translation>
    </message>
    <message>
        <source>&amp;Gain</source>
        <translation>&amp;Gain</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titre</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>The drawing shows the recorder on its actor, who looks to the front; the dashed line is where gravity says that up was.</source>
        <translation>Le dessin montre l’enregistreur sur la personne, qui regarde devant&#xa0;; le trait pointillé montre où était le haut selon la pesanteur.</translation>
    </message>
    <message>
        <source>It turned so much that gravity does not tell which is right.</source>
        <translation>Il a tant tourné que la pesanteur ne dit pas laquelle est juste.</translation>
    </message>
    <message>
        <source>Gravity agrees. Which side was the front only you can know.</source>
        <translation>La pesanteur est d’accord. Quel côté était l’avant, vous seul le savez.</translation>
    </message>
    <message>
        <source>Gravity says that another side was up.</source>
        <translation>Selon la pesanteur, un autre côté était en haut.</translation>
    </message>
    <message>
        <source>Where shall sequences be kept?</source>
        <translation>Où faut-il garder les séquences&#xa0;?</translation>
    </message>
</context>
<context>
    <name>Numbers</name>
    <message>
        <source>yyyy-MM-dd</source>
        <extracomment>how a date is written in figures, in Qt&apos;s letters</extracomment>
        <translation>dd/MM/yyyy</translation>
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
        <translation>Accélération autour de la tête de lecture</translation>
    </message>
    <message>
        <source>This clip has no motion data</source>
        <translation>Cette vidéo n’a pas de données de mouvement</translation>
    </message>
    <message>
        <source>Force around the playhead</source>
        <translation>Force autour de la tête de lecture</translation>
    </message>
    <message>
        <source>Acceleration, m/s²</source>
        <translation>Accélération, m/s²</translation>
    </message>
    <message>
        <source>x right</source>
        <translation>x droite</translation>
    </message>
    <message>
        <source>y front</source>
        <translation>y avant</translation>
    </message>
    <message>
        <source>z up</source>
        <translation>z haut</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Force, N</translation>
    </message>
    <message>
        <source>y up</source>
        <translation>y haut</translation>
    </message>
    <message>
        <source>z to you</source>
        <translation>z vers vous</translation>
    </message>
    <message>
        <source>thin: planned</source>
        <translation>fin&#xa0;: prévue</translation>
    </message>
    <message>
        <source>Click: go there. Drag: move. Wheel or + and −: zoom. Double click or Enter: as before</source>
        <translation>Clic&#xa0;: y aller. Glisser&#xa0;: déplacer. Molette ou + et −&#xa0;: zoom. Double clic ou Entrée&#xa0;: comme avant</translation>
    </message>
    <message>
        <source>Save this view: {plot}</source>
        <translation>Enregistrer cette vue&#xa0;: {plot}</translation>
    </message>
    <message>
        <source>Save this view as PNG, SVG or CSV</source>
        <translation>Enregistrer cette vue en PNG, SVG ou CSV</translation>
    </message>
    <message>
        <source>Picture (*.png);;Drawing (*.svg);;Numbers (*.csv)</source>
        <translation>Image (*.png);;Dessin (*.svg);;Nombres (*.csv)</translation>
    </message>
    <message>
        <source>{name}: choose a name that ends in {kinds}</source>
        <translation>{name}&#xa0;: choisissez un nom qui finit par {kinds}</translation>
    </message>
</context>
<context>
    <name>PlotsPlace</name>
    <message>
        <source>Live plots</source>
        <translation>Courbes</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>Good: ready for use</source>
        <translation>Bon&#xa0;: prêt à l’emploi</translation>
    </message>
    <message>
        <source>Doubtful: look at what is marked</source>
        <translation>Douteux&#xa0;: regardez ce qui est marqué</translation>
    </message>
    <message>
        <source>Bad: better record or import it again</source>
        <translation>Mauvais&#xa0;: mieux vaut refaire l’enregistrement ou l’importation</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteux</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvais</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Synchronisation</translation>
    </message>
    <message>
        <source>Clock drift</source>
        <translation>Dérive de l’horloge</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>Gravity left at rest</source>
        <translation>Pesanteur restante au repos</translation>
    </message>
    <message>
        <source>Sensor at its limit</source>
        <translation>Capteur à sa limite</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lacunes</translation>
    </message>
    <message>
        <source>Clip without motion</source>
        <translation>Clip sans mouvement</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>Force à sa limite</translation>
    </message>
    <message>
        <source>Use of the workspace</source>
        <translation>Usage de l’espace de travail</translation>
    </message>
    <message>
        <source>Heat of the motors</source>
        <translation>Chaleur des moteurs</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>residual {ms} ms, confidence {confidence} ({how})</source>
        <translation>reste {ms}&#xa0;ms, confiance {confidence} ({how})</translation>
    </message>
    <message>
        <source>{share} of the motion; {count}, the longest {s} s</source>
        <translation>{share} du mouvement&#xa0;; {count}, la plus longue {s}&#xa0;s</translation>
    </message>
    <message>
        <source>{share} of the samples; the peak is {n} N</source>
        <translation>{share} des valeurs&#xa0;; la crête est de {n}&#xa0;N</translation>
    </message>
    <message>
        <source>three pats</source>
        <translation>trois tapes</translation>
    </message>
    <message>
        <source>variance</source>
        <translation>variance</translation>
    </message>
    <message>
        <source>one clock</source>
        <translation>une seule horloge</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>relaxed hand</source>
        <translation>main souple</translation>
    </message>
    <message>
        <source>normal hand</source>
        <translation>main normale</translation>
    </message>
    <message>
        <source>firm hand</source>
        <translation>main ferme</translation>
    </message>
    <message>
        <source>The force would stop; lower the gain</source>
        <translation>La force s’arrêterait&#xa0;; baissez le gain</translation>
    </message>
    <message>
        <source>Look again, and give three pats next time</source>
        <translation>Regardez encore&#xa0;; trois tapes la prochaine fois</translation>
    </message>
    <message>
        <source>Pat at the end of a long recording too</source>
        <translation>Tapez aussi à la fin d’un long enregistrement</translation>
    </message>
    <message>
        <source>Record at 100 Hz or more</source>
        <translation>Enregistrez à 100 Hz ou plus</translation>
    </message>
    <message>
        <source>Stand still for a few seconds at the start</source>
        <translation>Restez immobile quelques secondes au début</translation>
    </message>
    <message>
        <source>Choose a larger range of the accelerometer</source>
        <translation>Choisissez une plus grande plage de l’accéléromètre</translation>
    </message>
    <message>
        <source>There is no force there; try another card</source>
        <translation>Il n’y a pas de force là&#xa0;; essayez une autre carte</translation>
    </message>
    <message>
        <source>Start the log before the clip, end it after</source>
        <translation>Commencez le journal avant le clip, finissez après</translation>
    </message>
    <message>
        <source>Lower the gain</source>
        <translation>Baissez le gain</translation>
    </message>
    <message>
        <source>Lower the gain, or play shorter clips</source>
        <translation>Baissez le gain, ou des clips plus courts</translation>
    </message>
</context>
<context>
    <name>QualityView</name>
    <message>
        <source>Quality report</source>
        <translation>Rapport de qualité</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>This sequence cannot be played</source>
        <translation>Cette séquence ne peut pas être lue</translation>
    </message>
</context>
<context>
    <name>RecentMenu</name>
    <message>
        <source>Forget all</source>
        <translation>Tout oublier</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>Opening {name}</source>
        <translation>Ouverture de {name}</translation>
    </message>
    <message>
        <source>Preparing the demo</source>
        <translation>Préparation de la démo</translation>
    </message>
    <message>
        <source>Something else is being done; wait for it or cancel it</source>
        <translation>Un autre travail est en cours&#xa0;; attendez-le ou annulez-le</translation>
    </message>
    <message>
        <source>Bring the grip to the middle first, then re-arm again</source>
        <translation>Amenez d’abord la poignée au milieu, puis réarmez</translation>
    </message>
    <message>
        <source>The haptics process has ended; choose the device again</source>
        <translation>Le processus haptique s’est terminé&#xa0;; choisissez l’appareil à nouveau</translation>
    </message>
</context>
<context>
    <name>SessionControl</name>
    <message>
        <source>Session – hapticplayer</source>
        <translation>Séance – hapticplayer</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>New note</source>
        <translation>Nouvelle note</translation>
    </message>
    <message>
        <source>A note; Enter keeps it</source>
        <translation>Une note&#xa0;; Entrée la conserve</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop the clip; it begins again</source>
        <translation>Arrêter le clip&#xa0;; il recommencera</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Play the last trial again</source>
        <translation>Rejouer le dernier essai</translation>
    </message>
    <message>
        <source>Skip…</source>
        <translation>Passer…</translation>
    </message>
    <message>
        <source>Leave this step out</source>
        <translation>Omettre cette étape</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Terminer…</translation>
    </message>
    <message>
        <source>End the session for good</source>
        <translation>Terminer la séance définitivement</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Try to save once more</source>
        <translation>Essayer encore d’enregistrer</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Take the force away (Esc)</source>
        <translation>Retirer la force (Échap)</translation>
    </message>
    <message>
        <source>Volume {n} %, the same for the whole session</source>
        <translation>Volume {n} %, le même pour toute la séance</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>, trial {k} of {n}</source>
        <translation>, essai {k} sur {n}</translation>
    </message>
    <message>
        <source>, attempt {n}</source>
        <translation>, tentative {n}</translation>
    </message>
    <message>
        <source>Nothing has been played yet</source>
        <translation>Rien n’a encore été joué</translation>
    </message>
    <message>
        <source>The last trial was played as it should be</source>
        <translation>Le dernier essai s’est déroulé correctement</translation>
    </message>
    <message>
        <source>The last trial was not sound: {reasons}</source>
        <translation>Le dernier essai n’est pas valable&#xa0;: {reasons}</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Why is this step left out?</source>
        <translation>Pourquoi omettre cette étape&#xa0;?</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Terminer la séance</translation>
    </message>
    <message>
        <source>Why does it end? All answers given so far are kept.</source>
        <translation>Pourquoi se termine-t-elle&#xa0;? Toutes les réponses données sont conservées.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The session has not ended. Close, and go on with it later?</source>
        <translation>La séance n’est pas terminée. Fermer et la reprendre plus tard&#xa0;?</translation>
    </message>
    <message>
        <source>consent</source>
        <translation>consentement</translation>
    </message>
    <message>
        <source>questions</source>
        <translation>questions</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>démonstration</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>cannot be saved</source>
        <translation>enregistrement impossible</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>ended early</source>
        <translation>terminé avant la fin</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>the contract stopped it ({0})</source>
        <translation>le contrat de sécurité l’a arrêté ({0})</translation>
    </message>
    <message>
        <source>force and picture were apart</source>
        <translation>la force et l’image étaient décalées</translation>
    </message>
    <message>
        <source>force and sound were apart</source>
        <translation>la force et le son étaient décalés</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>to be repeated</source>
        <translation>à répéter</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omis</translation>
    </message>
    <message>
        <source>the session was ended</source>
        <translation>la séance a été terminée</translation>
    </message>
    <message>
        <source>stopped by the operator</source>
        <translation>arrêté par l’opérateur</translation>
    </message>
    <message>
        <source>the participant pressed Esc</source>
        <translation>la personne a appuyé sur Échap</translation>
    </message>
    <message>
        <source>the participant pressed the space bar</source>
        <translation>la personne a appuyé sur la barre d’espace</translation>
    </message>
    <message>
        <source>another program came in front</source>
        <translation>un autre programme est passé devant</translation>
    </message>
    <message>
        <source>the window was to be closed</source>
        <translation>la fenêtre allait être fermée</translation>
    </message>
    <message>
        <source>the clip is damaged</source>
        <translation>le clip est endommagé</translation>
    </message>
    <message>
        <source>pictures were dropped</source>
        <translation>des images ont été perdues</translation>
    </message>
    <message>
        <source>there was no sound</source>
        <translation>il n’y avait pas de son</translation>
    </message>
    <message>
        <source>sound was missing</source>
        <translation>du son a manqué</translation>
    </message>
    <message>
        <source>there was no device</source>
        <translation>il n’y avait pas d’appareil</translation>
    </message>
    <message>
        <source>the device was lost</source>
        <translation>l’appareil a été perdu</translation>
    </message>
    <message>
        <source>the loop missed periods</source>
        <translation>la boucle a manqué des périodes</translation>
    </message>
    <message>
        <source>the device said nothing</source>
        <translation>l’appareil n’a rien dit</translation>
    </message>
    <message>
        <source>the record has gaps</source>
        <translation>l’enregistrement a des lacunes</translation>
    </message>
    <message>
        <source>{size}; screens in all: {n}</source>
        <translation>{size}&#xa0;; écrans en tout&#xa0;: {n}</translation>
    </message>
    <message>
        <source>{n} GB free</source>
        <translation>{n} Go libres</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
</context>
<context>
    <name>SetupPage</name>
    <message>
        <source>Firmware file…</source>
        <translation>Micrologiciel…</translation>
    </message>
    <message>
        <source>Keep your copy of the firmware</source>
        <translation>Garder votre copie du micrologiciel</translation>
    </message>
    <message>
        <source>Feel the forces…</source>
        <translation>Sentir les forces…</translation>
    </message>
    <message>
        <source>Feel every direction, gentle first</source>
        <translation>Sentir chaque direction, doucement d’abord</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>Utiliser cet appareil</translation>
    </message>
    <message>
        <source>Play with it from now on</source>
        <translation>Jouer avec lui désormais</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Keep the device from before</source>
        <translation>Garder l’appareil d’avant</translation>
    </message>
    <message>
        <source>Set up the device</source>
        <translation>Préparer l’appareil</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>That file cannot be used</source>
        <translation>Ce fichier n’est pas utilisable</translation>
    </message>
</context>
<context>
    <name>SetupTexts</name>
    <message>
        <source>The Falcon cannot be used</source>
        <translation>Le Falcon ne peut pas être utilisé</translation>
    </message>
    <message>
        <source>The Falcon is not plugged in</source>
        <translation>Le Falcon n’est pas branché</translation>
    </message>
    <message>
        <source>Connect its USB cable and its power supply; it is found by itself.</source>
        <translation>Branchez son câble USB et son alimentation&#xa0;; il est trouvé tout seul.</translation>
    </message>
    <message>
        <source>Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and plug it in.</source>
        <translation>Copiez la règle udev {rule} dans /etc/udev/rules.d, puis débranchez et rebranchez le Falcon.</translation>
    </message>
    <message>
        <source>You have no permission to use the Falcon</source>
        <translation>Vous n’avez pas le droit d’utiliser le Falcon</translation>
    </message>
    <message>
        <source>Another program uses the Falcon</source>
        <translation>Un autre programme utilise le Falcon</translation>
    </message>
    <message>
        <source>Close that program; then it goes on by itself.</source>
        <translation>Fermez ce programme&#xa0;; la suite vient toute seule.</translation>
    </message>
    <message>
        <source>The Falcon has the wrong driver</source>
        <translation>Le Falcon a un mauvais pilote</translation>
    </message>
    <message>
        <source>Give it the driver WinUSB, with the program Zadig, in place of FTDI&apos;s or Force Dimension&apos;s; then unplug it and plug it in.</source>
        <translation>Donnez-lui, avec le programme Zadig, le pilote WinUSB à la place de celui de FTDI ou de Force Dimension&#xa0;; puis débranchez-le et rebranchez-le.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware</source>
        <translation>Le Falcon a besoin de son micrologiciel</translation>
    </message>
    <message>
        <source>It belongs to Novint and may not be passed on with this program. Take nvent_firmware.bin from a libnifalcon source archive and choose the file here, once.</source>
        <translation>Il appartient à Novint et ne peut pas être fourni avec ce programme. Prenez nvent_firmware.bin dans une archive des sources de libnifalcon et choisissez le fichier ici, une seule fois.</translation>
    </message>
    <message>
        <source>Pull the grip out, as far as it goes</source>
        <translation>Tirez la poignée jusqu’au bout</translation>
    </message>
    <message>
        <source>Push the grip in, until it locks</source>
        <translation>Poussez la poignée jusqu’à ce qu’elle se bloque</translation>
    </message>
    <message>
        <source>The Falcon is ready</source>
        <translation>Le Falcon est prêt</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>Loading the firmware</source>
        <translation>Chargement du micrologiciel</translation>
    </message>
    <message>
        <source>A button on the grip is pressed.</source>
        <translation>Un bouton de la poignée est enfoncé.</translation>
    </message>
    <message>
        <source>Move the grip: the picture follows.</source>
        <translation>Bougez la poignée&#xa0;: l’image suit.</translation>
    </message>
    <message>
        <source>Joints that have found their zero: {legs}. There is no force.</source>
        <translation>Articulations qui ont trouvé leur zéro&#xa0;: {legs}. Il n’y a pas de force.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aucune encore</translation>
    </message>
    <message>
        <source>Nothing has to be set up</source>
        <translation>Rien n’est à préparer</translation>
    </message>
    <message>
        <source>A Falcon that is only computed, held by a simulated hand: for trying everything without hardware.</source>
        <translation>Un Falcon seulement calculé, tenu par une main simulée&#xa0;: pour tout essayer sans matériel.</translation>
    </message>
    <message>
        <source>Connect a DualSense or a DualShock 4 by its USB cable. It shakes as strongly as the force is; it has no direction.</source>
        <translation>Branchez une DualSense ou une DualShock 4 par son câble USB. Elle vibre aussi fort que la force&#xa0;; elle n’a pas de direction.</translation>
    </message>
    <message>
        <source>The clip plays without force.</source>
        <translation>Le clip est lu sans force.</translation>
    </message>
    <message>
        <source>The firmware of the Falcon belongs to Novint Technologies. libnifalcon passes it on under Novint&apos;s SDK licence (its file license/LICENSE_NOVINT.txt): for personal, noncommercial use, free of charge, and every recipient is bound by it. Read that licence; by going on you say that you may use this file. It stays on this computer.</source>
        <translation>Le micrologiciel du Falcon appartient à Novint Technologies. libnifalcon le transmet sous la licence SDK de Novint (son fichier license/LICENSE_NOVINT.txt)&#xa0;: pour un usage personnel et non commercial, gratuitement, et chaque destinataire y est lié. Lisez cette licence&#xa0;; en continuant, vous dites que vous pouvez utiliser ce fichier. Il reste sur cet ordinateur.</translation>
    </message>
    <message>
        <source>The file is sound, but it is none of the firmware files that are known. It would run the motors. Keep it only if you know where it comes from.</source>
        <translation>Le fichier est sain, mais ce n’est aucun des micrologiciels connus. Il commanderait les moteurs. Ne le gardez que si vous savez d’où il vient.</translation>
    </message>
</context>
<context>
    <name>StartPanel</name>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>New participant</source>
        <translation>Nouveau participant</translation>
    </message>
    <message>
        <source>Go on with {code}</source>
        <translation>Continuer avec {code}</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Play a clip</source>
        <translation>Jouer un clip</translation>
    </message>
    <message>
        <source>Listen whether the sound is heard</source>
        <translation>Vérifier que le son s’entend</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Stays as it is for the whole session, and is kept with it</source>
        <translation>Reste le même pendant toute la séance et est enregistré avec elle</translation>
    </message>
    <message>
        <source>The sound is heard</source>
        <translation>Le son s’entend</translation>
    </message>
    <message>
        <source>Begin although something is not in order</source>
        <translation>Commencer bien que tout ne soit pas en ordre</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Show the first page to the participant</source>
        <translation>Montrer la première page au participant</translation>
    </message>
    <message>
        <source>Language of the pages</source>
        <translation>Langue des pages</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Balance so far</source>
        <translation>Équilibre actuel</translation>
    </message>
    <message>
        <source>each condition {a} to {b} times at each place, {c} to {d} times after each other</source>
        <translation>chaque condition {a} à {b} fois à chaque place, {c} à {d} fois après chaque autre</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Grip found</source>
        <translation>Poignée repérée</translation>
    </message>
    <message>
        <source>Real-time class</source>
        <translation>Classe temps réel</translation>
    </message>
    <message>
        <source>Participant&apos;s screen</source>
        <translation>Écran du participant</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>entendu</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>non confirmé</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>pas d’appareil</translation>
    </message>
    <message>
        <source>the device has said nothing yet</source>
        <translation>l’appareil n’a encore rien dit</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>pas encore</translation>
    </message>
</context>
<context>
    <name>Statistics</name>
    <message>
        <source>Clip</source>
        <translation>Vidéo</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>vues&#xa0;: {shown}, sautées&#xa0;: {dropped}</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Priorité</translation>
    </message>
    <message>
        <source>Late, µs</source>
        <translation>Retard, µs</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Battements</translation>
    </message>
    <message>
        <source>{n} in 10 s, {missed} missed</source>
        <translation>{n} en 10 s, manqués&#xa0;: {missed}</translation>
    </message>
    <message>
        <source>Force − picture, ms</source>
        <translation>Force − image, ms</translation>
    </message>
    <message>
        <source>Force − sound, ms</source>
        <translation>Force − son, ms</translation>
    </message>
    <message>
        <source>Latency, ms</source>
        <translation>Latence, ms</translation>
    </message>
    <message>
        <source>Planned, N</source>
        <translation>Prévue, N</translation>
    </message>
    <message>
        <source>Sent, N</source>
        <translation>Envoyée, N</translation>
    </message>
    <message>
        <source>Centring, N</source>
        <translation>Centrage, N</translation>
    </message>
    <message>
        <source>Grip, mm</source>
        <translation>Poignée, mm</translation>
    </message>
    <message>
        <source>picture {0:.0f}  sound {1:.0f}  force {2:.0f}  output {3:.0f}</source>
        <translation>image {0:.0f}  son {1:.0f}  force {2:.0f}  sortie {3:.0f}</translation>
    </message>
</context>
<context>
    <name>StudyEditor</name>
    <message>
        <source>Study – {name}</source>
        <translation>Étude – {name}</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Never the same sequence twice in a row</source>
        <translation>Jamais deux fois de suite la même séquence</translation>
    </message>
    <message>
        <source>The operator does not see the condition</source>
        <translation>L’opérateur ne voit pas la condition</translation>
    </message>
    <message>
        <source>Show the published wording where there is one</source>
        <translation>Montrer le texte publié s’il existe</translation>
    </message>
    <message>
        <source>Offer markers and force to other programs on this machine (LSL)</source>
        <translation>Offrir marqueurs et force à d’autres programmes de cette machine (LSL)</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Random for each participant</source>
        <translation>Aléatoire pour chaque participant</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Carré latin</translation>
    </message>
    <message>
        <source>Williams: balanced for what came before</source>
        <translation>Williams&#xa0;: équilibré selon ce qui précède</translation>
    </message>
    <message>
        <source>From orders.csv</source>
        <translation>D’après orders.csv</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Choose the folder of a sequence</source>
        <translation>Choisir le dossier d’une séquence</translation>
    </message>
    <message>
        <source>Folder of a sequence</source>
        <translation>Dossier d’une séquence</translation>
    </message>
    <message>
        <source> (published)</source>
        <translation> (publié)</translation>
    </message>
</context>
<context>
    <name>StudyMenu</name>
    <message>
        <source>&amp;Study</source>
        <translation>É&amp;tude</translation>
    </message>
    <message>
        <source>&amp;New study…</source>
        <translation>&amp;Nouvelle étude…</translation>
    </message>
    <message>
        <source>&amp;Edit study…</source>
        <translation>&amp;Modifier une étude…</translation>
    </message>
    <message>
        <source>&amp;Run a participant…</source>
        <translation>&amp;Faire passer un participant…</translation>
    </message>
    <message>
        <source>&amp;Analyse study…</source>
        <translation>&amp;Analyser une étude…</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Nouvelle étude</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Folder of a study</source>
        <translation>Dossier d’une étude</translation>
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
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Media time at which the log&apos;s clock reads zero</source>
        <translation>Temps du média où l’horloge du journal indique zéro</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Sound later than picture</source>
        <translation>Son après l’image</translation>
    </message>
    <message>
        <source>How much later than its picture the camera&apos;s sound comes</source>
        <translation>De combien le son de la caméra vient après son image</translation>
    </message>
    <message>
        <source>keep for this camera</source>
        <translation>garder pour cette caméra</translation>
    </message>
    <message>
        <source>I have looked and listened: this offset is right</source>
        <translation>J’ai regardé et écouté&#xa0;: ce décalage est juste</translation>
    </message>
    <message>
        <source>&amp;Whole clip</source>
        <translation>Clip &amp;entier</translation>
    </message>
    <message>
        <source>Show the whole clip</source>
        <translation>Montrer tout le clip</translation>
    </message>
    <message>
        <source>The &amp;pats</source>
        <translation>Les &amp;tapes</translation>
    </message>
    <message>
        <source>Show the pats closely</source>
        <translation>Montrer les tapes de près</translation>
    </message>
    <message>
        <source>&amp;Hear</source>
        <translation>É&amp;couter</translation>
    </message>
    <message>
        <source>Play what is shown: the clip left, a tick at each knock right</source>
        <translation>Lire ce qui est montré&#xa0;: le clip à gauche, un tic à chaque choc à droite</translation>
    </message>
    <message>
        <source>&amp;Offset</source>
        <translation>&amp;Décalage</translation>
    </message>
    <message>
        <source>S&amp;ound later than picture</source>
        <translation>S&amp;on après l’image</translation>
    </message>
    <message>
        <source>Drag the acceleration until it lies under the sound; the arrow keys move it by 1 ms, with Shift by 10 ms, with Ctrl by 100 ms. The wheel zooms; the picture is that at the cursor, which comma and point move.</source>
        <translation>Tirez l’accélération jusqu’à ce qu’elle soit sous le son&#xa0;; les flèches la déplacent de 1 ms, avec Maj de 10 ms, avec Ctrl de 100 ms. La molette agrandit&#xa0;; l’image est celle du curseur, que la virgule et le point déplacent.</translation>
    </message>
    <message>
        <source>{recorder} keeps its motion on the clip&apos;s own clock.</source>
        <translation>{recorder} garde le mouvement sur l’horloge du clip.</translation>
    </message>
    <message>
        <source>Nothing to go by: {why}. Give the offset by hand.</source>
        <translation>Aucun repère&#xa0;: {why}. Donnez le décalage à la main.</translation>
    </message>
    <message>
        <source>The offset was moved by hand.</source>
        <translation>Le décalage a été déplacé à la main.</translation>
    </message>
    <message>
        <source>The pats were found (confidence {confidence}, residual {ms} ms).</source>
        <translation>Les tapes ont été trouvées (confiance {confidence}, reste {ms} ms).</translation>
    </message>
    <message>
        <source>The pats are not certain (confidence {confidence}). Look whether the same events lie under each other, and drag them if not.</source>
        <translation>Les tapes ne sont pas sûres (confiance {confidence}). Regardez si les mêmes événements sont l’un sous l’autre, sinon tirez-les.</translation>
    </message>
    <message>
        <source>No three pats are both heard and felt; drag by hand.</source>
        <translation>Trois tapes ne sont pas à la fois entendues et senties&#xa0;; tirez à la main.</translation>
    </message>
</context>
<context>
    <name>SyncPlot</name>
    <message>
        <source>Sync plot</source>
        <translation>Courbe de synchronisation</translation>
    </message>
    <message>
        <source>How much later than its picture and its sound the force came in the last 30 s. Nobody feels what lies between 15 ms early and 50 ms late</source>
        <translation>De combien la force est venue après son image et son son ces 30 dernières secondes. Personne ne sent ce qui reste entre 15 ms trop tôt et 50 ms trop tard</translation>
    </message>
    <message>
        <source>Force − picture</source>
        <translation>Force − image</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Force − son</translation>
    </message>
</context>
<context>
    <name>SyncStrip</name>
    <message>
        <source>Sound and acceleration</source>
        <translation>Son et accélération</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Accélération</translation>
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
        <translation>{title}&#xa0;: {text}</translation>
    </message>
    <message>
        <source>riding</source>
        <translation>parcours</translation>
    </message>
    <message>
        <source>drawing the ride</source>
        <translation>dessin du parcours</translation>
    </message>
    <message>
        <source>adding telemetry</source>
        <translation>ajout de la télémétrie</translation>
    </message>
    <message>
        <source>writing the logs</source>
        <translation>écriture des journaux</translation>
    </message>
    <message>
        <source>listening</source>
        <translation>écoute du son</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture de</translation>
    </message>
    <message>
        <source>synchronising</source>
        <translation>synchronisation</translation>
    </message>
    <message>
        <source>removing gravity</source>
        <translation>retrait de la pesanteur</translation>
    </message>
    <message>
        <source>predicting excursions</source>
        <translation>prévision des excursions</translation>
    </message>
    <message>
        <source>rendering the force</source>
        <translation>calcul de la force</translation>
    </message>
    <message>
        <source>copying the clip</source>
        <translation>copie du clip</translation>
    </message>
    <message>
        <source>computing checksums</source>
        <translation>sommes de contrôle</translation>
    </message>
    <message>
        <source>reading the answers</source>
        <translation>lecture des réponses</translation>
    </message>
    <message>
        <source>analysing</source>
        <translation>analyse de</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dessin de</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>writing the numbers</source>
        <translation>écriture des nombres</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
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
        <translation>Position dans la vidéo&#xa0;: cliquez ou glissez</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Speed; Backspace for normal speed</source>
        <translation>Vitesse&#xa0;; Retour arrière pour la normale</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Which force goes with the clip</source>
        <translation>Quelle force accompagne la vidéo</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Which haptic device is moved</source>
        <translation>Quel appareil haptique est mû</translation>
    </message>
    <message>
        <source>Fullscreen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Show the clip and nothing else (F)</source>
        <translation>Ne montrer que la vidéo (F)</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Volume (9 and 0)</source>
        <translation>Volume (9 et 0)</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Son activé</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Muet</translation>
    </message>
    <message>
        <source>{name} (M)</source>
        <translation>{name} (M)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Suspendre</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>{name} (Space)</source>
        <translation>{name} (Espace)</translation>
    </message>
    <message>
        <source>The force was stopped: let it come back (Ctrl+R)</source>
        <translation>La force a été arrêtée&#xa0;: la laisser revenir (Ctrl+R)</translation>
    </message>
    <message>
        <source>Take the force away at once and pause (Esc)</source>
        <translation>Retirer la force tout de suite et suspendre (Échap)</translation>
    </message>
    <message>
        <source>Re-arm the force</source>
        <translation>Réarmer la force</translation>
    </message>
    <message>
        <source>Stop the force</source>
        <translation>Arrêter la force</translation>
    </message>
    <message>
        <source>Re-arm</source>
        <translation>Réarmer</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
</context>
<context>
    <name>Triad</name>
    <message>
        <source>Right is {right}, front is {front}, up is {up}</source>
        <translation>La droite est {right}, l’avant {front}, le haut {up}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>front</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
</context>
<context>
    <name>VideoSurface</name>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
</context>
<context>
    <name>_Question</name>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>KEY=VALUE, several with blanks between</source>
        <translation>CLÉ=VALEUR, plusieurs séparées par des espaces</translation>
    </message>
    <message>
        <source>&amp;Answer</source>
        <translation>&amp;Répondre</translation>
    </message>
    <message>
        <source>Read the log with this answer</source>
        <translation>Lire le journal avec cette réponse</translation>
    </message>
    <message>
        <source>&amp;Template…</source>
        <translation>&amp;Modèle…</translation>
    </message>
    <message>
        <source>Take the answers from a file</source>
        <translation>Prendre les réponses d’un fichier</translation>
    </message>
</context>
</TS>
