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
        <translation>&amp;Boucle : d’ici, à ici, non</translation>
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
        <source>Live &amp;plots</source>
        <translation>&amp;Courbes</translation>
    </message>
    <message>
        <source>Simulated &amp;grip</source>
        <translation>Poi&amp;gnée simulée</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>&amp;Statistiques</translation>
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
        <translation>Ouvrez une séquence ou une vidéo, ou déposez-la ici. Une vidéo seule est lue sans force ; importez-la avec son mouvement pour le ressentir.</translation>
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
        <translation>Quel appareil haptique est mû ; le simulé ne demande aucun matériel</translation>
    </message>
</context>
<context>
    <name>ErrorGateway</name>
    <message>
        <source>Something went wrong inside the program ({kind}: {text}); the force was stopped and the playback paused. Details are on the terminal.</source>
        <translation>Une erreur interne s’est produite ({kind} : {text}) ; la force a été arrêtée et la lecture suspendue. Les détails sont dans le terminal.</translation>
    </message>
</context>
<context>
    <name>Extras</name>
    <message>
        <source>Goes on at {time}; Home for the beginning</source>
        <translation>Reprise à {time} ; Origine pour le début</translation>
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
    <name>GripView</name>
    <message>
        <source>No device: choose {name} to see what would be felt</source>
        <translation>Aucun appareil : choisissez {name} pour voir ce qui serait ressenti</translation>
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
        <translation>Force : {what}</translation>
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
        <translation>Flèche épaisse : la force sur la main. Flèche fine : la force prévue. Flèche violette : la part qui garde la poignée à l’intérieur.
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
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Falcon</source>
        <translation>Falcon</translation>
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
        <translation>active</translation>
    </message>
    <message>
        <source>fading out</source>
        <translation>descend</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>ARRÊTÉE</translation>
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
        <translation>non, {us:.0f} µs, {missed} manqués</translation>
    </message>
    <message>
        <source>yes, {us:.0f} µs, {missed} missed</source>
        <translation>oui, {us:.0f} µs, {missed} manqués</translation>
    </message>
    <message>
        <source>{ms:+.1f} ms</source>
        <translation>{ms:+.1f} ms</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>{shown} vues, {dropped} sautées</translation>
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
        <translation>Classe de la boucle à 1 kHz : FIFO est la meilleure, tranche presque aussi bonne, normal la laisse en retard de millisecondes</translation>
    </message>
    <message>
        <source>Real-time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>99 % of the loop&apos;s wake-ups in the last 10 s were no later than this; missed are periods that were skipped. When more than 1 % are, the force is held to 3 N</source>
        <translation>99 % des réveils des 10 dernières s n’étaient pas plus en retard ; les manqués sont des périodes sautées. Au-delà de 1 %, la force est limitée à 3 N</translation>
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
        <source>How much later the force comes than its picture, median</source>
        <translation>De combien la force suit son image, médiane</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Force − son</translation>
    </message>
    <message>
        <source>How much later the force comes than its sound, median</source>
        <translation>De combien la force suit son son, médiane</translation>
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
        <translation>Ce qui mène : le son entendu, ou l’horloge monotone de la machine sans son</translation>
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
        <source>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Plays a video and lets you feel the motion of whoever recorded it.&lt;/p&gt;&lt;p&gt;After Danieau et al., Enhancing audiovisual experience with haptic feedback (2012).&lt;br&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Lit une vidéo et fait ressentir le mouvement de la personne qui l’a filmée.&lt;/p&gt;&lt;p&gt;D’après Danieau et al., Enhancing audiovisual experience with haptic feedback (2012).&lt;br&gt;Licence MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>Import a recording</source>
        <translation>Importer un enregistrement</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Vidéo</translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation>Journal du mouvement</translation>
    </message>
    <message>
        <source>inside the video</source>
        <translation>dans la vidéo</translation>
    </message>
    <message>
        <source>New folder</source>
        <translation>Nouveau dossier</translation>
    </message>
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
        <translation>Temps de la vidéo où l’horloge du journal marque zéro</translation>
    </message>
    <message>
        <source>A sequence is a folder with the clip, its motion and the force that belongs to it. Cameras such as GoPro keep their motion inside the video; otherwise give the log of a motion sensor.</source>
        <translation>Une séquence est un dossier avec la vidéo, son mouvement et la force qui lui appartient. Des caméras comme GoPro gardent le mouvement dans la vidéo ; sinon, donnez le journal d’un capteur de mouvement.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>&amp;Video</source>
        <translation>&amp;Vidéo</translation>
    </message>
    <message>
        <source>Motion &amp;log (CSV)</source>
        <translation>&amp;Journal du mouvement (CSV)</translation>
    </message>
    <message>
        <source>New &amp;folder</source>
        <translation>Nouveau &amp;dossier</translation>
    </message>
    <message>
        <source>&amp;Offset</source>
        <translation>Dé&amp;calage</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Make the sequence and open it</source>
        <translation>Créer la séquence et l’ouvrir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Import nothing</source>
        <translation>Ne rien importer</translation>
    </message>
    <message>
        <source>Choose a video that exists.</source>
        <translation>Choisissez une vidéo qui existe.</translation>
    </message>
    <message>
        <source>The motion log does not exist.</source>
        <translation>Le journal du mouvement n’existe pas.</translation>
    </message>
    <message>
        <source>Choose where the new folder shall be.</source>
        <translation>Choisissez où placer le nouveau dossier.</translation>
    </message>
    <message>
        <source>The new folder exists already; give another name.</source>
        <translation>Le dossier existe déjà ; donnez un autre nom.</translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation>Choisir une vidéo</translation>
    </message>
    <message>
        <source>Motion logs (*.csv);;All files (*)</source>
        <translation>Journaux de mouvement (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose a motion log</source>
        <translation>Choisir un journal de mouvement</translation>
    </message>
    <message>
        <source>Where shall the new folder be made?</source>
        <translation>Où créer le nouveau dossier ?</translation>
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
        <translation>Arrêter ce travail ; il n’en reste rien</translation>
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
        <translation>Cette touche arrête toujours la force ; elle reste</translation>
    </message>
    <message>
        <source>Press a key in the field first</source>
        <translation>Appuyez d’abord sur une touche dans le champ</translation>
    </message>
    <message>
        <source>{key} is taken by “{command}”</source>
        <translation>{key} est prise par « {command} »</translation>
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
        <translation>fin : prévue</translation>
    </message>
    <message>
        <source>Click: go there. Drag: move. Wheel or + and −: zoom. Double click or Enter: as before</source>
        <translation>Clic : y aller. Glisser : déplacer. Molette ou + et − : zoom. Double clic ou Entrée : comme avant</translation>
    </message>
    <message>
        <source>Save this view: {plot}</source>
        <translation>Enregistrer cette vue : {plot}</translation>
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
        <translation>{name} : choisissez un nom qui finit par {kinds}</translation>
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
        <source>Importing {name}</source>
        <translation>Importation de {name}</translation>
    </message>
    <message>
        <source>Something else is being done; wait for it or cancel it</source>
        <translation>Un autre travail est en cours ; attendez-le ou annulez-le</translation>
    </message>
    <message>
        <source>Bring the grip to the middle first, then re-arm again</source>
        <translation>Amenez d’abord la poignée au milieu, puis réarmez</translation>
    </message>
    <message>
        <source>The haptics process has ended; choose the device again</source>
        <translation>Le processus haptique s’est terminé ; choisissez l’appareil à nouveau</translation>
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
        <translation>{shown} vues, {dropped} sautées</translation>
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
        <translation>{n} en 10 s, {missed} manqués</translation>
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
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position in the clip: click or drag</source>
        <translation>Position dans la vidéo : cliquez ou glissez</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Speed; Backspace for normal speed</source>
        <translation>Vitesse ; Retour arrière pour la normale</translation>
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
        <translation>La force a été arrêtée : la laisser revenir (Ctrl+R)</translation>
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
    <name>VideoSurface</name>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
</context>
</TS>
