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
        <source>&amp;Edit</source>
        <translation>Éd&amp;ition</translation>
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
        <source>&amp;Device</source>
        <translation>A&amp;ppareil</translation>
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
        <source>Replay a &amp;log…</source>
        <translation>Re&amp;jouer un journal…</translation>
    </message>
    <message>
        <source>Re&amp;cord…</source>
        <translation>Enregistrer une pri&amp;se…</translation>
    </message>
    <message>
        <source>&amp;Playlist…</source>
        <translation>&amp;Liste de lecture…</translation>
    </message>
    <message>
        <source>Edit &amp;effects…</source>
        <translation>Modifier les &amp;effets…</translation>
    </message>
    <message>
        <source>Re&amp;ndering…</source>
        <translation>Re&amp;ndu…</translation>
    </message>
    <message>
        <source>S&amp;hare…</source>
        <translation>Parta&amp;ger…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation>
    </message>
    <message>
        <source>E&amp;xport settings…</source>
        <translation>E&amp;xporter les réglages…</translation>
    </message>
    <message>
        <source>&amp;Back 5 s</source>
        <translation>5 s en a&amp;rrière</translation>
    </message>
    <message>
        <source>&amp;Forward 5 s</source>
        <translation>5 s en a&amp;vant</translation>
    </message>
    <message>
        <source>Back 1 min</source>
        <translation>1 min en arrière</translation>
    </message>
    <message>
        <source>Forward 1 min</source>
        <translation>1 min en avant</translation>
    </message>
    <message>
        <source>Go to the b&amp;eginning</source>
        <translation>Aller au &amp;début</translation>
    </message>
    <message>
        <source>Go to the e&amp;nd</source>
        <translation>Aller à la &amp;fin</translation>
    </message>
    <message>
        <source>Ne&amp;xt file</source>
        <translation>Fichier suiva&amp;nt</translation>
    </message>
    <message>
        <source>P&amp;revious file</source>
        <translation>Fichier pré&amp;cédent</translation>
    </message>
    <message>
        <source>Repea&amp;t: off, this clip, all</source>
        <translation>Ré&amp;péter&#xa0;: non, ce clip, tous</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Image suivante</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Image précédente</translation>
    </message>
    <message>
        <source>&amp;Loop: set start, set end, off</source>
        <translation>&amp;Boucle&#xa0;: début, fin, arrêt</translation>
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
        <source>&amp;Try out the forces…</source>
        <translation>E&amp;ssayer les forces…</translation>
    </message>
    <message>
        <source>&amp;Grip view</source>
        <translation>Vue de la poi&amp;gnée</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>&amp;Agrandir</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>Ré&amp;duire</translation>
    </message>
    <message>
        <source>As large as fits</source>
        <translation>Aussi grand que possible</translation>
    </message>
    <message>
        <source>Save this frame as a pictu&amp;re</source>
        <translation>Enregistrer cette &amp;image</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Guide</translation>
    </message>
    <message>
        <source>&amp;System check…</source>
        <translation>&amp;Vérification du système…</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>&amp;Signaler un problème…</translation>
    </message>
    <message>
        <source>Simulated &amp;motion rig…</source>
        <translation>Plateforme de &amp;mouvement simulée…</translation>
    </message>
    <message>
        <source>Effects, point or cursor a frame back</source>
        <translation>Effets, point ou curseur une image en arrière</translation>
    </message>
    <message>
        <source>Effects, point or cursor a frame forward</source>
        <translation>Effets, point ou curseur une image en avant</translation>
    </message>
    <message>
        <source>Effects or point ten frames, or cursor 1 s back</source>
        <translation>Effets ou point de dix images, ou curseur de 1 s, en arrière</translation>
    </message>
    <message>
        <source>Effects or point ten frames, or cursor 1 s forward</source>
        <translation>Effets ou point de dix images, ou curseur de 1 s, en avant</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Marqueur précédent</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Marqueur suivant</translation>
    </message>
    <message>
        <source>Select all effects</source>
        <translation>Sélectionner tous les effets</translation>
    </message>
    <message>
        <source>Select the next effect as well</source>
        <translation>Sélectionner aussi l’effet suivant</translation>
    </message>
    <message>
        <source>Select the previous effect as well</source>
        <translation>Sélectionner aussi l’effet précédent</translation>
    </message>
    <message>
        <source>Next fade or point of the effect</source>
        <translation>Fondu ou point suivant de l’effet</translation>
    </message>
    <message>
        <source>Previous fade or point of the effect</source>
        <translation>Fondu ou point précédent de l’effet</translation>
    </message>
    <message>
        <source>Raise the point</source>
        <translation>Monter le point</translation>
    </message>
    <message>
        <source>Lower the point</source>
        <translation>Descendre le point</translation>
    </message>
    <message>
        <source>Raise the point by ten steps</source>
        <translation>Monter le point de dix pas</translation>
    </message>
    <message>
        <source>Lower the point by ten steps</source>
        <translation>Descendre le point de dix pas</translation>
    </message>
    <message>
        <source>Add a control point at the cursor</source>
        <translation>Ajouter un point de contrôle au curseur</translation>
    </message>
    <message>
        <source>Switch the effects on or off</source>
        <translation>Activer ou désactiver les effets</translation>
    </message>
    <message>
        <source>Delete the effects, or the point</source>
        <translation>Supprimer les effets, ou le point</translation>
    </message>
    <message>
        <source>Duplicate the effects</source>
        <translation>Dupliquer les effets</translation>
    </message>
    <message>
        <source>Copy the effects</source>
        <translation>Copier les effets</translation>
    </message>
    <message>
        <source>Paste the effects at the cursor</source>
        <translation>Coller les effets au curseur</translation>
    </message>
    <message>
        <source>Go back without force; again for faster</source>
        <translation>Reculer sans force&#xa0;; encore une fois pour aller plus vite</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play; again for faster</source>
        <translation>Lire&#xa0;; encore une fois pour aller plus vite</translation>
    </message>
    <message>
        <source>Set a marker at the cursor</source>
        <translation>Poser un marqueur au curseur</translation>
    </message>
    <message>
        <source>End of the effect a frame back</source>
        <translation>Fin de l’effet une image en arrière</translation>
    </message>
    <message>
        <source>End of the effect a frame forward</source>
        <translation>Fin de l’effet une image en avant</translation>
    </message>
    <message>
        <source>Start of the effect a frame back</source>
        <translation>Début de l’effet une image en arrière</translation>
    </message>
    <message>
        <source>Start of the effect a frame forward</source>
        <translation>Début de l’effet une image en avant</translation>
    </message>
    <message>
        <source>Cursor a frame back</source>
        <translation>Curseur une image en arrière</translation>
    </message>
    <message>
        <source>Cursor a frame forward</source>
        <translation>Curseur une image en avant</translation>
    </message>
    <message>
        <source>Cursor to the beginning</source>
        <translation>Curseur au début</translation>
    </message>
    <message>
        <source>Cursor to the end</source>
        <translation>Curseur à la fin</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Événement précédent</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Événement suivant</translation>
    </message>
    <message>
        <source>Offer the effect of the event at the cursor</source>
        <translation>Proposer l’effet de l’événement au curseur</translation>
    </message>
    <message>
        <source>Undo the change of effects</source>
        <translation>Annuler la modification des effets</translation>
    </message>
    <message>
        <source>Redo the change of effects</source>
        <translation>Rétablir la modification des effets</translation>
    </message>
    <message>
        <source>Save the effects</source>
        <translation>Enregistrer les effets</translation>
    </message>
    <message>
        <source>Inject fa&amp;ults…</source>
        <translation>&amp;Injecter des défauts…</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Raccourcis &amp;clavier…</translation>
    </message>
    <message>
        <source>Measure l&amp;atencies…</source>
        <translation>Mesurer les l&amp;atences…</translation>
    </message>
    <message>
        <source>Other feedbac&amp;k…</source>
        <translation>Autre re&amp;tour haptique…</translation>
    </message>
    <message>
        <source>&amp;Outputs…</source>
        <translation>S&amp;orties…</translation>
    </message>
    <message>
        <source>Live &amp;plots</source>
        <translation>&amp;Courbes</translation>
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
        <source>&amp;Fullscreen</source>
        <translation>&amp;Plein écran</translation>
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
        <source>Compute statistics and figures again</source>
        <translation>Recalculer les statistiques et les figures</translation>
    </message>
    <message>
        <source>Write the report, its figures and the data to a new folder</source>
        <translation>Écrire le rapport, les figures et les données dans un nouveau dossier</translation>
    </message>
    <message>
        <source>No valid answer yet: there is nothing to publish.</source>
        <translation>Aucune réponse valide pour l’instant&#xa0;: il n’y a rien à publier.</translation>
    </message>
    <message>
        <source>The report is in English, ready for publication.</source>
        <translation>Le rapport est en anglais, prêt à être publié.</translation>
    </message>
    <message>
        <source>Saved to {0}</source>
        <translation>Enregistré dans {0}</translation>
    </message>
    <message>
        <source>Choose where to create the report folder</source>
        <translation>Où créer le dossier du rapport&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Save report…</source>
        <translation>Enregi&amp;strer le rapport…</translation>
    </message>
    <message>
        <source>The report is in English.</source>
        <translation>Le rapport est en anglais.</translation>
    </message>
    <message>
        <source>Analysing</source>
        <translation>Analyse en cours</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
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
    <name>ChangeBar</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Enre&amp;gistrer</translation>
    </message>
    <message>
        <source>Save the effects and render the force with them (Ctrl+S)</source>
        <translation>Enregistrer les effets et calculer la force avec eux (Ctrl+S)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Pas encore enregistré</translation>
    </message>
</context>
<context>
    <name>CheckList</name>
    <message>
        <source>What the device needs</source>
        <translation>Ce dont l’appareil a besoin</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <source>not visible from here</source>
        <translation>non visible d’ici</translation>
    </message>
</context>
<context>
    <name>CheckPage</name>
    <message>
        <source>System check</source>
        <translation>Vérification du système</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy the whole text</source>
        <translation>Copier tout le texte</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>What is installed, what is missing, and how to get it.</source>
        <translation>Ce qui est installé, ce qui manque, et comment l’obtenir.</translation>
    </message>
</context>
<context>
    <name>ChoiceForm</name>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Size and rate of the camera</source>
        <translation>Taille et cadence de la caméra</translation>
    </message>
    <message>
        <source>Microphone</source>
        <translation>Microphone</translation>
    </message>
    <message>
        <source>Motion sensor</source>
        <translation>Capteur de mouvement</translation>
    </message>
    <message>
        <source>Place of the motion sensor</source>
        <translation>Connexion du capteur de mouvement</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>&amp;Chercher à nouveau</translation>
    </message>
    <message>
        <source>Look for cameras and microphones again</source>
        <translation>Chercher à nouveau des caméras et des microphones</translation>
    </message>
    <message>
        <source>The folder that takes are saved in</source>
        <translation>Le dossier où les prises sont enregistrées</translation>
    </message>
    <message>
        <source>Save i&amp;n…</source>
        <translation>Enregistrer da&amp;ns…</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>Camér&amp;a</translation>
    </message>
    <message>
        <source>Si&amp;ze and rate</source>
        <translation>Taille et ca&amp;dence</translation>
    </message>
    <message>
        <source>M&amp;icrophone</source>
        <translation>M&amp;icrophone</translation>
    </message>
    <message>
        <source>Motion &amp;sensor</source>
        <translation>Capteur de &amp;mouvement</translation>
    </message>
    <message>
        <source>at &amp;place</source>
        <translation>conne&amp;xion</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>As the camera offers</source>
        <translation>Au choix de la caméra</translation>
    </message>
    <message>
        <source>{width} × {height}, {rate} fps</source>
        <translation>{width} × {height}, {rate} images/s</translation>
    </message>
    <message>
        <source>No camera was found: plug one in, and press Look again.</source>
        <translation>Aucune caméra trouvée&#xa0;: branchez-en une, puis «&#xa0;Chercher à nouveau&#xa0;».</translation>
    </message>
    <message>
        <source>No microphone was found.</source>
        <translation>Aucun microphone trouvé.</translation>
    </message>
    <message>
        <source>Without a motion sensor, motion can be suggested from the frames.</source>
        <translation>Sans capteur, un mouvement peut être proposé d’après les images.</translation>
    </message>
    <message>
        <source>Looking for cameras…</source>
        <translation>Recherche de caméras…</translation>
    </message>
    <message>
        <source>Options may follow a comma: {options}</source>
        <translation>Des options peuvent suivre une virgule&#xa0;: {options}</translation>
    </message>
    <message>
        <source>Choose where takes are saved</source>
        <translation>Choisir où les prises sont enregistrées</translation>
    </message>
</context>
<context>
    <name>Choices</name>
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
        <source>System default</source>
        <translation>Par défaut du système</translation>
    </message>
    <message>
        <source>Same screen as the window</source>
        <translation>L’écran de la fenêtre</translation>
    </message>
    <message>
        <source>Fullscreen &amp;on</source>
        <translation>Plein écran s&amp;ur</translation>
    </message>
</context>
<context>
    <name>ClipFrame</name>
    <message>
        <source>Frame at the cursor</source>
        <translation>Image au curseur</translation>
    </message>
</context>
<context>
    <name>ColumnMap</name>
    <message>
        <source>Column {number}</source>
        <translation>Colonne {number}</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Without → with effects: RMS {rms}, peak {peak}, at the limit {limit}, reach of a relaxed hand {reach}</source>
        <translation>Sans → avec effets&#xa0;: valeur efficace {rms}, crête {peak}, à la limite {limit}, course d’une main détendue {reach}</translation>
    </message>
    <message>
        <source>the force would be stopped</source>
        <translation>la force serait coupée</translation>
    </message>
</context>
<context>
    <name>ConditionDialog</name>
    <message>
        <source>Other feedback</source>
        <translation>Autre retour haptique</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Make this force and play it</source>
        <translation>Calculer cette force et la jouer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
</context>
<context>
    <name>ConditionForm</name>
    <message>
        <source>Feedback</source>
        <translation>Retour haptique</translation>
    </message>
    <message>
        <source>As rendered</source>
        <translation>Comme calculé</translation>
    </message>
    <message>
        <source>With the effects of the sequence</source>
        <translation>Avec les effets de la séquence</translation>
    </message>
    <message>
        <source>The next one</source>
        <translation>La suivante</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Choose a sequence folder</source>
        <translation>Choisir le dossier d’une séquence</translation>
    </message>
</context>
<context>
    <name>ConditionList</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Choose a condition</source>
        <translation>Choisir une condition</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Level (delay and gain)</source>
        <translation>Niveau (retard et gain)</translation>
    </message>
    <message>
        <source>Each of them is compared with</source>
        <translation>Chacune est comparée à</translation>
    </message>
    <message>
        <source>The standard</source>
        <translation>La référence</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Escalier</translation>
    </message>
    <message>
        <source>Each of them at these levels</source>
        <translation>Chacune à ces niveaux</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Delay of the force</source>
        <translation>Retard de la force</translation>
    </message>
    <message>
        <source>Gain of the force</source>
        <translation>Gain de la force</translation>
    </message>
    <message>
        <source>Repeats of each trial</source>
        <translation>Répétitions de chaque essai</translation>
    </message>
    <message>
        <source>The track {name} that each sequence has</source>
        <translation>La piste {name} que chaque séquence possède</translation>
    </message>
    <message>
        <source>another condition</source>
        <translation>autre condition</translation>
    </message>
    <message>
        <source>Each sequence is played under each condition. Sessions that have begun keep theirs.</source>
        <translation>Chaque séquence est jouée sous chaque condition. Les séances commencées gardent les leurs.</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>retard</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>gain</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Ce qui change</translation>
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
        <translation>Règle</translation>
    </message>
    <message>
        <source>First change</source>
        <translation>Premier changement</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Trials of each</source>
        <translation>Essais de chacune</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Nom dans les données</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>Dans les données et les figures&#xa0;: a à z, 0 à 9, _ et -</translation>
    </message>
    <message>
        <source>another name in the data</source>
        <translation>autre nom dans les données</translation>
    </message>
    <message>
        <source>another level</source>
        <translation>autre niveau</translation>
    </message>
</context>
<context>
    <name>ConditionPreview</name>
    <message>
        <source>Recorded force</source>
        <translation>Force enregistrée</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Force ressentie</translation>
    </message>
    <message>
        <source>Preview of the force</source>
        <translation>Aperçu de la force</translation>
    </message>
    <message>
        <source>Choose a recording for a sequence to see the force</source>
        <translation>Choisissez un enregistrement pour une séquence afin de voir la force</translation>
    </message>
    <message>
        <source>Computing the force…</source>
        <translation>Calcul de la force…</translation>
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
    <name>DemoEnd</name>
    <message>
        <source>End of the demo</source>
        <translation>Fin de la démo</translation>
    </message>
    <message>
        <source>That was the demo. What next?</source>
        <translation>C’était la démo. Et maintenant&#xa0;?</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Play the demo from its beginning</source>
        <translation>Lire la démo depuis le début</translation>
    </message>
    <message>
        <source>Import your own…</source>
        <translation>Importer une vidéo…</translation>
    </message>
    <message>
        <source>Create a sequence from a video and its motion data</source>
        <translation>Créer une séquence à partir d’une vidéo et de son mouvement</translation>
    </message>
    <message>
        <source>Choose a device…</source>
        <translation>Choisir un appareil…</translation>
    </message>
    <message>
        <source>The haptic device to use; the simulated one needs no hardware</source>
        <translation>L’appareil haptique à utiliser&#xa0;; le simulé ne demande aucun matériel</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>playing a clip</source>
        <translation>lecture d’un clip</translation>
    </message>
</context>
<context>
    <name>DeviceDialogs</name>
    <message>
        <source>Choose a device first, then try out its forces</source>
        <translation>Choisissez d’abord un appareil, puis essayez ses forces</translation>
    </message>
</context>
<context>
    <name>DeviceForm</name>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Address or settings</source>
        <translation>Adresse ou réglages</translation>
    </message>
</context>
<context>
    <name>DevicePage</name>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Feel every direction, starting gently</source>
        <translation>Sentir chaque direction, doucement d’abord</translation>
    </message>
    <message>
        <source>Stop the force immediately (Esc)</source>
        <translation>Couper la force immédiatement (Échap)</translation>
    </message>
    <message>
        <source>Try out the forces: {name}</source>
        <translation>Essayer les forces&#xa0;: {name}</translation>
    </message>
    <message>
        <source>Release the device</source>
        <translation>Libérer l’appareil</translation>
    </message>
    <message>
        <source>Demonstration finished.</source>
        <translation>Démonstration terminée.</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>You will feel each force three times, starting gently. Esc, STOP or a button on the device stops it immediately.</source>
        <translation>Vous sentirez chaque force trois fois, d’abord doucement. Échap, STOP ou un bouton de l’appareil l’arrête aussitôt.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>DevicePicture</name>
    <message>
        <source>Grip</source>
        <translation>Poignée</translation>
    </message>
    <message>
        <source>Force is off</source>
        <translation>La force est coupée</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Tester</translation>
    </message>
    <message>
        <source>Platform of the rig</source>
        <translation>Plateau de la plateforme</translation>
    </message>
    <message>
        <source>up {up} mm; roll {roll}, pitch {pitch}, yaw {yaw} degrees</source>
        <translation>hauteur {up} mm&#xa0;; roulis {roll}, tangage {pitch}, lacet {yaw} degrés</translation>
    </message>
    <message>
        <source>at the end of its reach</source>
        <translation>en bout de course</translation>
    </message>
    <message>
        <source>Motion shown {factor}× larger</source>
        <translation>Mouvement agrandi {factor} fois</translation>
    </message>
    <message>
        <source>Force along one axis</source>
        <translation>Force sur un axe</translation>
    </message>
    <message>
        <source>Strength of the vibration</source>
        <translation>Intensité de la vibration</translation>
    </message>
</context>
<context>
    <name>DeviceTestPanel</name>
    <message>
        <source>Test…</source>
        <translation>Tester…</translation>
    </message>
    <message>
        <source>Moves it gently; asks first</source>
        <translation>Le fait bouger doucement&#xa0;; demande d’abord</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop the force immediately (Esc)</source>
        <translation>Couper la force immédiatement (Échap)</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Avancement du test</translation>
    </message>
    <message>
        <source>Test the device</source>
        <translation>Tester l’appareil</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Lancer le test</translation>
    </message>
    <message>
        <source>Waiting until the device is at rest</source>
        <translation>En attente du repos de l’appareil</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>Coming to rest</source>
        <translation>Retour au repos</translation>
    </message>
</context>
<context>
    <name>DeviceTestWords</name>
    <message>
        <source>Esc or STOP ends it immediately.</source>
        <translation>Échap ou STOP l’arrête aussitôt.</translation>
    </message>
    <message>
        <source>It will move gently for {seconds} s, along and about one axis after the other.</source>
        <translation>Il bougera doucement pendant {seconds} s, le long et autour d’un axe après l’autre.</translation>
    </message>
    <message>
        <source>It will vibrate on the channels {channels}, one after the other, for {seconds} s, with up to {strength}.</source>
        <translation>Il vibrera sur les canaux {channels}, l’un après l’autre, pendant {seconds} s, jusqu’à {strength}.</translation>
    </message>
    <message>
        <source>It will vibrate for {seconds} s, with up to {strength}.</source>
        <translation>Il vibrera pendant {seconds} s, jusqu’à {strength}.</translation>
    </message>
    <message>
        <source>It will turn or pull to one side and to the other for {seconds} s, with up to {strength}.</source>
        <translation>Il tournera ou tirera d’un côté puis de l’autre pendant {seconds} s, jusqu’à {strength}.</translation>
    </message>
    <message>
        <source>It will push gently in each direction for {seconds} s, with up to {strength}.</source>
        <translation>Il poussera doucement dans chaque direction pendant {seconds} s, jusqu’à {strength}.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Channel {label}: {what}</source>
        <translation>Canal {label}&#xa0;: {what}</translation>
    </message>
    <message>
        <source>Surge: forwards and back</source>
        <translation>Avant et retour</translation>
    </message>
    <message>
        <source>Sway: to the right and back</source>
        <translation>À droite et retour</translation>
    </message>
    <message>
        <source>Heave: up and back</source>
        <translation>Vers le haut et retour</translation>
    </message>
    <message>
        <source>Roll: leaning to the right and back</source>
        <translation>Roulis à droite et retour</translation>
    </message>
    <message>
        <source>Pitch: nose up and back</source>
        <translation>Tangage vers le haut et retour</translation>
    </message>
    <message>
        <source>Yaw: turning to the left and back</source>
        <translation>Lacet à gauche et retour</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>Test finished.</source>
        <translation>Test terminé.</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open a sequence folder</source>
        <translation>Ouvrir le dossier d’une séquence</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Ouvrir une vidéo</translation>
    </message>
    <message>
        <source>Replay the forces of a log</source>
        <translation>Rejouer les forces d’un journal</translation>
    </message>
    <message>
        <source>Only the effects of a sequence can be edited: import the video first</source>
        <translation>Seuls les effets d’une séquence peuvent être modifiés&#xa0;: importez d’abord la vidéo</translation>
    </message>
    <message>
        <source>Only a sequence can be shared: import the video first. A file that was shared with you can be sent on as it is.</source>
        <translation>Seule une séquence peut être partagée&#xa0;: importez d’abord la vidéo. Un fichier qu’on a partagé avec vous peut être transmis tel quel.</translation>
    </message>
    <message>
        <source>Only a sequence can be rendered: import the video first, or unpack a file that was shared with you.</source>
        <translation>Seule la force d’une séquence peut être recalculée&#xa0;: importez d’abord la vidéo, ou dépaquetez un fichier qu’on a partagé avec vous.</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Exporter les réglages</translation>
    </message>
    <message>
        <source>Logs (*.jsonl *.json *.log);;All files (*)</source>
        <translation>Journaux (*.jsonl *.json *.log);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Importer des réglages</translation>
    </message>
</context>
<context>
    <name>Dropping</name>
    <message>
        <source>Clips: {count}. Imported, those with motion can be felt.</source>
        <translation>Clips&#xa0;: {count}. Une fois importés, ceux qui contiennent du mouvement peuvent être sentis.</translation>
    </message>
    <message>
        <source>Import all…</source>
        <translation>Tout importer…</translation>
    </message>
    <message>
        <source>{name} contains motion data, which plays once it is imported.</source>
        <translation>{name} contient des données de mouvement, jouées une fois importées.</translation>
    </message>
    <message>
        <source>Import and feel it…</source>
        <translation>Importer et sentir…</translation>
    </message>
    <message>
        <source>{name} has no motion data; drop its log here, or let its frames suggest it.</source>
        <translation>{name} n’a pas de données de mouvement&#xa0;; déposez ici son journal, ou laissez ses images suggérer un mouvement.</translation>
    </message>
    <message>
        <source>Suggest motion from the frames…</source>
        <translation>Suggérer un mouvement d’après les images…</translation>
    </message>
</context>
<context>
    <name>Editing</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Fondu</translation>
    </message>
    <message>
        <source>Move the point</source>
        <translation>Déplacer le point</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>Change the order</source>
        <translation>Modifier l’ordre</translation>
    </message>
    <message>
        <source>Marker {number}</source>
        <translation>Marqueur {number}</translation>
    </message>
    <message>
        <source>Set a marker</source>
        <translation>Poser un marqueur</translation>
    </message>
    <message>
        <source>Rename the marker</source>
        <translation>Renommer le marqueur</translation>
    </message>
    <message>
        <source>Remove the marker</source>
        <translation>Retirer le marqueur</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Supprimer le point</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Activer</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Désactiver</translation>
    </message>
</context>
<context>
    <name>EditingLanes</name>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>{count} effects are selected</source>
        <translation>{count} effets sont sélectionnés</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Supprimer le point</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Désactiver</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Activer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Add the effect: {name}, {span}</source>
        <translation>Ajouter l’effet&#xa0;: {name}, {span}</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>Edit effects</source>
        <translation>Modifier les effets</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effets</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Save your changes to the effects?</source>
        <translation>Enregistrer vos modifications des effets&#xa0;?</translation>
    </message>
    <message>
        <source>Rendering the force</source>
        <translation>Calcul de la force</translation>
    </message>
    <message>
        <source>Reading the sequence</source>
        <translation>Lecture de la séquence</translation>
    </message>
</context>
<context>
    <name>EffectPanel</name>
    <message>
        <source>Switched &amp;on</source>
        <translation>Act&amp;ivé</translation>
    </message>
    <message>
        <source>Add a copy after it (Ctrl+D)</source>
        <translation>Ajouter une copie à la suite (Ctrl+D)</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>D&amp;upliquer</translation>
    </message>
    <message>
        <source>Delete it (Del)</source>
        <translation>Supprimer (Suppr)</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>Suppri&amp;mer</translation>
    </message>
    <message>
        <source>Apply it earlier</source>
        <translation>Appliquer plus tôt</translation>
    </message>
    <message>
        <source>Apply it later</source>
        <translation>Appliquer plus tard</translation>
    </message>
    <message>
        <source>No effect is selected</source>
        <translation>Aucun effet sélectionné</translation>
    </message>
    <message>
        <source>{count} effects are selected</source>
        <translation>{count} effets sont sélectionnés</translation>
    </message>
    <message>
        <source>Place in the order in which they are applied</source>
        <translation>Place dans l’ordre d’application</translation>
    </message>
    <message>
        <source>Fade in</source>
        <translation>Fondu d’entrée</translation>
    </message>
    <message>
        <source>Fade out</source>
        <translation>Fondu de sortie</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Applies &amp;to</source>
        <translation>S’appli&amp;que à</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Drag a kind of effect onto the timeline, or click an event there. The recorded motion never changes.</source>
        <translation>Glissez un type d’effet sur la ligne de temps ou cliquez-y sur un événement. Le mouvement enregistré ne change jamais.</translation>
    </message>
    <message>
        <source>Control &amp;points: s after the start, value</source>
        <translation>&amp;Points de contrôle&#xa0;: s après le début, valeur</translation>
    </message>
    <message>
        <source>Such as 0 1; 0.5 2; 1 1 – empty for one value</source>
        <translation>Par exemple 0 1; 0.5 2; 1 1 – vide pour une seule valeur</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Motion before the rendering</source>
        <translation>Mouvement avant le rendu</translation>
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
        <source>front</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Change the numbers</source>
        <translation>Modifier les nombres</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Change the direction</source>
        <translation>Modifier la direction</translation>
    </message>
    <message>
        <source>Change the control points</source>
        <translation>Modifier les points de contrôle</translation>
    </message>
</context>
<context>
    <name>EmptyPage</name>
    <message>
        <source>Feel the motion of what you watch</source>
        <translation>Ressentez le mouvement de ce que vous regardez</translation>
    </message>
    <message>
        <source>Open a sequence or a video, or drop one here. A video on its own plays without force; import it with its motion data to feel it.</source>
        <translation>Ouvrez une séquence ou une vidéo, ou déposez-la ici. Une vidéo seule est lue sans force&#xa0;; importez-la avec ses données de mouvement pour la ressentir.</translation>
    </message>
    <message>
        <source>Open a sequence folder</source>
        <translation>Ouvrir le dossier d’une séquence</translation>
    </message>
    <message>
        <source>Your imported sequences</source>
        <translation>Les séquences importées</translation>
    </message>
    <message>
        <source>Create a sequence from a video and its motion data</source>
        <translation>Créer une séquence à partir d’une vidéo et de son mouvement</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Enregistrer une prise…</translation>
    </message>
    <message>
        <source>Record with a camera and a motion sensor</source>
        <translation>Enregistrer avec une caméra et un capteur de mouvement</translation>
    </message>
    <message>
        <source>Choose a device…</source>
        <translation>Choisir un appareil…</translation>
    </message>
    <message>
        <source>The haptic device to use; the simulated one needs no hardware</source>
        <translation>L’appareil haptique à utiliser&#xa0;; le simulé ne demande aucun matériel</translation>
    </message>
    <message>
        <source>Play the demo</source>
        <translation>Lire la démo</translation>
    </message>
    <message>
        <source>A simulated ride by bicycle</source>
        <translation>Une sortie à vélo simulée</translation>
    </message>
    <message>
        <source>Open a sequence…</source>
        <translation>Ouvrir une séquence…</translation>
    </message>
    <message>
        <source>Library…</source>
        <translation>Bibliothèque…</translation>
    </message>
    <message>
        <source>Import a recording…</source>
        <translation>Importer un enregistrement…</translation>
    </message>
</context>
<context>
    <name>EntryList</name>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove (Delete)</source>
        <translation>Retirer (Suppr)</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>removal</source>
        <translation>retrait</translation>
    </message>
    <message>
        <source>another order</source>
        <translation>autre ordre</translation>
    </message>
</context>
<context>
    <name>ErrorGateway</name>
    <message>
        <source>Internal error ({kind}: {text}). The force was stopped and playback paused.</source>
        <translation>Erreur interne ({kind}&#xa0;: {text}). La force a été coupée et la lecture mise en pause.</translation>
    </message>
    <message>
        <source>Help &gt; Report a problem saves the details.</source>
        <translation>Aide &gt; Signaler un problème enregistre les détails.</translation>
    </message>
    <message>
        <source>See the terminal for details.</source>
        <translation>Détails dans le terminal.</translation>
    </message>
</context>
<context>
    <name>Extras</name>
    <message>
        <source>Resuming at {time} (Home: from the start)</source>
        <translation>Reprise à {time} (Début&#xa0;: depuis le début)</translation>
    </message>
</context>
<context>
    <name>FaultPanel</name>
    <message>
        <source>Re-arm</source>
        <translation>Réarmer</translation>
    </message>
    <message>
        <source>Re-enable the force (Ctrl+R)</source>
        <translation>Rétablir la force (Ctrl+R)</translation>
    </message>
    <message>
        <source>Restart device</source>
        <translation>Redémarrer l’appareil</translation>
    </message>
    <message>
        <source>Start the simulated device again, without the fault</source>
        <translation>Redémarrer l’appareil simulé, sans le défaut</translation>
    </message>
    <message>
        <source>Inject faults into the simulated device</source>
        <translation>Injecter des défauts dans l’appareil simulé</translation>
    </message>
    <message>
        <source>Stop injecting faults</source>
        <translation>Ne plus injecter de défauts</translation>
    </message>
    <message>
        <source>Rule triggered</source>
        <translation>Règle déclenchée</translation>
    </message>
    <message>
        <source>Time to zero, ms</source>
        <translation>Temps jusqu’à zéro, ms</translation>
    </message>
    <message>
        <source>Fault results</source>
        <translation>Résultats des défauts</translation>
    </message>
    <message>
        <source>Faults can only be injected into a simulated device while this panel is open: choose it in the window, then press Restart device.</source>
        <translation>Les défauts ne s’injectent que dans un appareil simulé, tant que ce panneau est ouvert&#xa0;: choisissez-le dans la fenêtre, puis cliquez sur Redémarrer l’appareil.</translation>
    </message>
    <message>
        <source>The device has failed: press Restart device.</source>
        <translation>L’appareil est en panne&#xa0;: cliquez sur Redémarrer l’appareil.</translation>
    </message>
    <message>
        <source>Play a clip with force first.</source>
        <translation>Lisez d’abord un clip avec force.</translation>
    </message>
    <message>
        <source>The force is active. Press a fault to see how the safety contract responds.</source>
        <translation>La force est active. Déclenchez un défaut pour voir la réaction de la sécurité.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Panne</translation>
    </message>
    <message>
        <source>Reaction, ms</source>
        <translation>Réaction, ms</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>Stall, 60 ms</source>
        <translation>Blocage, 60&#xa0;ms</translation>
    </message>
    <message>
        <source>Stall, 300 ms</source>
        <translation>Blocage, 300&#xa0;ms</translation>
    </message>
    <message>
        <source>Unplug</source>
        <translation>Débrancher</translation>
    </message>
    <message>
        <source>Malformed replies</source>
        <translation>Réponses invalides</translation>
    </message>
    <message>
        <source>Lose homing</source>
        <translation>Perdre le repère</translation>
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
        <source>Loop stalled, 80 ms</source>
        <translation>Boucle bloquée, 80 ms</translation>
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
    <name>FeelNow</name>
    <message>
        <source>&amp;Feel it now</source>
        <translation>&amp;Ressentir</translation>
    </message>
    <message>
        <source>Feel what the sensor measures at this moment, on the haptic device</source>
        <translation>Ressentir sur l’appareil haptique ce que le capteur mesure en ce moment</translation>
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
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Drop a recording here</source>
        <translation>Déposez un enregistrement ici</translation>
    </message>
    <message>
        <source>embedded in the video</source>
        <translation>incluse dans la vidéo</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>Détection automatique</translation>
    </message>
    <message>
        <source>&amp;How the log is read…</source>
        <translation>&amp;Comment le journal est lu…</translation>
    </message>
    <message>
        <source>Units, axes, signs and more, with a check against gravity</source>
        <translation>Unités, axes, signes et plus encore, vérifiés d’après la pesanteur</translation>
    </message>
    <message>
        <source>&amp;Save as template…</source>
        <translation>Enregistrer comme &amp;modèle…</translation>
    </message>
    <message>
        <source>Save these answers as a template for all logs of this logger</source>
        <translation>Enregistrer ces réponses comme modèle pour tous les journaux de cet enregistreur</translation>
    </message>
    <message>
        <source>Drop a video here, together with its motion log if the sensor was a separate device. GoPro cameras store their motion data in the video.</source>
        <translation>Déposez une vidéo ici, avec son journal de mouvement si le capteur était un appareil séparé. Les caméras GoPro enregistrent leur mouvement dans la vidéo.</translation>
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
        <source>Se&amp;veral clips…</source>
        <translation>&amp;Plusieurs clips…</translation>
    </message>
    <message>
        <source>Import clips one after the other</source>
        <translation>Importer des clips l’un après l’autre</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>{log} is a motion log. Choose or drop the video of the ride.</source>
        <translation>{log} est un journal de mouvement. Choisissez ou déposez la vidéo du trajet.</translation>
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
        <source>Video: {camera}{width} × {height}, {rate} fps, {duration}, {sound}</source>
        <translation>Vidéo&#xa0;: {camera}{width} × {height}, {rate} images/s, {duration}, {sound}</translation>
    </message>
    <message>
        <source>Motion: {recorder}, {rate} Hz, {duration}, gaps: {gaps}</source>
        <translation>Mouvement&#xa0;: {recorder}, {rate} Hz, {duration}, lacunes&#xa0;: {gaps}</translation>
    </message>
    <message>
        <source>The sensor rotated too much to tell its axes from gravity.</source>
        <translation>Le capteur a trop tourné pour déterminer ses axes d’après la pesanteur.</translation>
    </message>
    <message>
        <source>Axes: x right, y forward, z up of the sensor; on average {up} pointed up</source>
        <translation>Axes&#xa0;: x à droite, y en avant, z en haut du capteur&#xa0;; en moyenne {up} pointait vers le haut</translation>
    </message>
    <message>
        <source>Save the template</source>
        <translation>Enregistrer le modèle</translation>
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
        <source>Install anyway</source>
        <translation>Installer quand même</translation>
    </message>
</context>
<context>
    <name>ForceTexts</name>
    <message>
        <source>Force tracks ({patterns})</source>
        <translation>Pistes de force ({patterns})</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>ForceWords</name>
    <message>
        <source>Pull the grip all the way out, then push it in until it locks</source>
        <translation>Tirez la poignée à fond, puis poussez-la jusqu’au verrouillage</translation>
    </message>
    <message>
        <source>{percent} % of its strength</source>
        <translation>{percent}&#xa0;% de sa force</translation>
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
</context>
<context>
    <name>GeneralFields</name>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Hide the condition from the operator</source>
        <translation>Cacher la condition à l’opérateur</translation>
    </message>
    <message>
        <source>Use the published wording of questions where there is one</source>
        <translation>Utiliser la formulation publiée des questions quand elle existe</translation>
    </message>
    <message>
        <source>Before a session</source>
        <translation>Avant une séance</translation>
    </message>
    <message>
        <source>Require a real device before a session starts</source>
        <translation>Exiger un appareil réel avant le début d’une séance</translation>
    </message>
    <message>
        <source>Ask the operator whether the sound is audible</source>
        <translation>Demander à l’opérateur si le son est audible</translation>
    </message>
    <message>
        <source>Stream markers and force to other programs on this computer (LSL)</source>
        <translation>Diffuser marqueurs et force vers d’autres programmes de cet ordinateur (LSL)</translation>
    </message>
    <message>
        <source>Record each session with LabRecorder</source>
        <translation>Enregistrer chaque séance avec LabRecorder</translation>
    </message>
    <message>
        <source>LSL streams that each trial needs</source>
        <translation>Flux LSL nécessaires à chaque essai</translation>
    </message>
    <message>
        <source>Least time between two clips</source>
        <translation>Temps minimal entre deux clips</translation>
    </message>
    <message>
        <source>Free disk space</source>
        <translation>Espace disque libre</translation>
    </message>
    <message>
        <source>Scheduling of the haptic loop</source>
        <translation>Ordonnancement de la boucle haptique</translation>
    </message>
    <message>
        <source>real time (FIFO)</source>
        <translation>temps réel (FIFO)</translation>
    </message>
    <message>
        <source>short time slices</source>
        <translation>tranches de temps courtes</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>A trial is marked as invalid above</source>
        <translation>Un essai est marqué comme non valide au-delà de</translation>
    </message>
    <message>
        <source>Dropped frames (share)</source>
        <translation>Images sautées (part)</translation>
    </message>
    <message>
        <source>Force to video or sound (median)</source>
        <translation>Force par rapport à la vidéo ou au son (médiane)</translation>
    </message>
    <message>
        <source>Missed periods of the haptic loop (share)</source>
        <translation>Périodes manquées de la boucle haptique (part)</translation>
    </message>
    <message>
        <source>Audio dropouts</source>
        <translation>Lacunes dans le son</translation>
    </message>
    <message>
        <source>conditions are compared by answers</source>
        <translation>les conditions sont comparées d’après les réponses</translation>
    </message>
    <message>
        <source>yes or no to each level of the force</source>
        <translation>oui ou non à chaque niveau de la force</translation>
    </message>
    <message>
        <source>which of two clips (forced choice)</source>
        <translation>lequel de deux clips (choix forcé)</translation>
    </message>
    <message>
        <source>a number for each level of the force</source>
        <translation>un nombre pour chaque niveau de la force</translation>
    </message>
    <message>
        <source>Kept as they are: the template ({template}), what the trials are for ({trial}), and the identifier by which sessions belong to the study ({id}).</source>
        <translation>Conservés tels quels&#xa0;: le modèle ({template}), le but des essais ({trial}) et l’identifiant qui rattache les séances à l’étude ({id}).</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Langues</translation>
    </message>
    <message>
        <source>other languages</source>
        <translation>autres langues</translation>
    </message>
</context>
<context>
    <name>GripView</name>
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
        <source>No device: choose {name} to see the simulated grip</source>
        <translation>Aucun appareil&#xa0;: choisissez {name} pour voir la poignée simulée</translation>
    </message>
    <message>
        <source>This device has no grip</source>
        <translation>Cet appareil n’a pas de poignée</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Position inconnue</translation>
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
        <source>Thick arrow: force on the hand. Thin white arrow: planned force. Purple arrow: the share that keeps the grip in the workspace.
Drag or use the arrow keys to rotate, the wheel or + and − to zoom, double-click or 0 to reset.</source>
        <translation>Flèche épaisse&#xa0;: force sur la main. Flèche blanche fine&#xa0;: force prévue. Flèche violette&#xa0;: la part qui maintient la poignée dans l’espace de travail.
Glisser ou flèches du clavier pour tourner, molette ou + et − pour zoomer, double clic ou 0 pour réinitialiser.</translation>
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
    <name>GuideWindow</name>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Rechercher dans le guide</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Aucun résultat</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
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
        <translation>disparu</translation>
    </message>
    <message>
        <source>pull the grip out, then push it in</source>
        <translation>tirez la poignée, puis enfoncez-la</translation>
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
        <source>late {p50:+.1f}, {p95:+.1f} ms</source>
        <translation>en retard {p50:+.1f}, {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>early {p50:+.1f}, {p95:+.1f} ms</source>
        <translation>en avance {p50:+.1f}, {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{damaged} damaged, {dropped} dropped</source>
        <translation>endommagées&#xa0;: {damaged}, sautées&#xa0;: {dropped}</translation>
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
        <source>{p50:+.1f}, {p95:+.1f} ms</source>
        <translation>{p50:+.1f}&#xa0;; {p95:+.1f} ms</translation>
    </message>
    <message>
        <source>{shown} shown, {dropped} dropped</source>
        <translation>vues&#xa0;: {shown}, sautées&#xa0;: {dropped}</translation>
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
        <translation>système</translation>
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
        <translation>Ordonnancement</translation>
    </message>
    <message>
        <source>Scheduling class of the 1 kHz loop: FIFO is best, slice nearly as good; with normal it may be milliseconds late</source>
        <translation>Classe d’ordonnancement de la boucle à 1 kHz&#xa0;: FIFO est la meilleure, tranche presque aussi bonne&#xa0;; avec normal, elle peut avoir des millisecondes de retard</translation>
    </message>
    <message>
        <source>99 % of the loop&apos;s wake-ups in the last 10 s were no later than this. Missed: skipped periods; above 1 % the force is limited to 3 N</source>
        <translation>99&#xa0;% des réveils de la boucle sur 10 s n’étaient pas plus tardifs. Manquées&#xa0;: périodes sautées&#xa0;; au-delà de 1&#xa0;%, la force est limitée à 3 N</translation>
    </message>
    <message>
        <source>Force − video</source>
        <translation>Force − vidéo</translation>
    </message>
    <message>
        <source>How much later the force comes than the video: median and 95th percentile of the last 20 s. More than 15 ms early or 50 ms late is noticeable</source>
        <translation>Retard de la force sur la vidéo&#xa0;: médiane et 95e centile des 20 dernières secondes. Plus de 15 ms d’avance ou 50 ms de retard se sent</translation>
    </message>
    <message>
        <source>early +88.8, +88.8 ms</source>
        <translation>en avance +88,8, +88,8 ms</translation>
    </message>
    <message>
        <source>How much later the force comes than the sound: median and 95th percentile of the last 20 s. More than 15 ms early or 50 ms late is noticeable</source>
        <translation>Retard de la force sur le son&#xa0;: médiane et 95e centile des 20 dernières secondes. Plus de 15 ms d’avance ou 50 ms de retard se sent</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Master clock: the audio output, or the computer&apos;s monotonic clock when there is no sound</source>
        <translation>Horloge de référence&#xa0;: la sortie audio, ou sans son l’horloge du système</translation>
    </message>
    <message>
        <source>Real-time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Force − son</translation>
    </message>
    <message>
        <source>no, 888 µs, 888 missed</source>
        <translation>non, 888 µs, manqués&#xa0;: 888</translation>
    </message>
    <message>
        <source>Frames shown on time, and dropped because they were late; the sign tells of the last 10 s</source>
        <translation>Images affichées à temps, et sautées car en retard&#xa0;; le signe concerne les 10 dernières secondes</translation>
    </message>
    <message>
        <source>88888 shown, 88 dropped</source>
        <translation>vues&#xa0;: 88888, sautées&#xa0;: 88</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>monotonic</source>
        <translation>système</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>About hapticplayer</source>
        <translation>À propos de hapticplayer</translation>
    </message>
    <message>
        <source>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Plays a video and lets you feel the motion of the camera.&lt;/p&gt;&lt;p&gt;Based on Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;hapticplayer {version}&lt;/b&gt;&lt;p&gt;Lit une vidéo et vous fait sentir le mouvement de la caméra.&lt;/p&gt;&lt;p&gt;D’après Danieau et al., A Framework for Enhancing Video Viewing Experience with Haptic Effects of Motion (2012).&lt;br&gt;Licence MIT.&lt;/p&gt;</translation>
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
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>&amp;Import another…</source>
        <translation>&amp;Importer un autre…</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retour</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Annuler&#xa0;; rien n’est conservé</translation>
    </message>
    <message>
        <source>Start again with other files</source>
        <translation>Recommencer avec d’autres fichiers</translation>
    </message>
    <message>
        <source>Go to the previous step</source>
        <translation>Étape précédente</translation>
    </message>
    <message>
        <source>Go to the next step</source>
        <translation>Étape suivante</translation>
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
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Reading {0}</source>
        <translation>Lecture de {0}</translation>
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
        <source>Cancel; nothing is kept</source>
        <translation>Annuler&#xa0;; rien n’est conservé</translation>
    </message>
    <message>
        <source>about {minutes} min left</source>
        <translation>encore {minutes} min environ</translation>
    </message>
    <message>
        <source>about {seconds} s left</source>
        <translation>encore {seconds} s environ</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Nouveau raccourci</translation>
    </message>
    <message>
        <source>Press the new shortcut for the selected command</source>
        <translation>Tapez le nouveau raccourci de la commande sélectionnée</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Attribuer</translation>
    </message>
    <message>
        <source>Assign this shortcut to the selected command</source>
        <translation>Attribuer ce raccourci à la commande sélectionnée</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Restore the default shortcut of the selected command</source>
        <translation>Rétablir le raccourci par défaut de la commande</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>Rétablir les raccourcis par défaut</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Commandes et raccourcis</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>This shortcut always stops the force and cannot be changed</source>
        <translation>Ce raccourci coupe toujours la force et ne peut être modifié</translation>
    </message>
    <message>
        <source>Press a shortcut in the field first</source>
        <translation>Tapez d’abord un raccourci dans le champ</translation>
    </message>
    <message>
        <source>{key} is already used by “{command}”</source>
        <translation>{key} est déjà utilisé par «&#xa0;{command}&#xa0;»</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout rétablir</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
</context>
<context>
    <name>KindList</name>
    <message>
        <source>Kinds of effects</source>
        <translation>Types d’effets</translation>
    </message>
    <message>
        <source>Drag onto the timeline; Enter adds at the cursor</source>
        <translation>Glissez sur la ligne de temps&#xa0;; Entrée ajoute au curseur</translation>
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
        <translation>Force x (droite)</translation>
    </message>
    <message>
        <source>Force y (up)</source>
        <translation>Force y (haut)</translation>
    </message>
    <message>
        <source>Force z (towards you)</source>
        <translation>Force z (vers vous)</translation>
    </message>
    <message>
        <source>± {peak} N</source>
        <translation>± {peak} N</translation>
    </message>
    <message>
        <source>The clip has no sound</source>
        <translation>Le clip n’a pas de son</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>No events found</source>
        <translation>Aucun événement trouvé</translation>
    </message>
    <message>
        <source>No effects</source>
        <translation>Aucun effet</translation>
    </message>
    <message>
        <source>Fade in {seconds} s</source>
        <translation>Fondu d’entrée {seconds} s</translation>
    </message>
    <message>
        <source>Fade out {seconds} s</source>
        <translation>Fondu de sortie {seconds} s</translation>
    </message>
    <message>
        <source>Point {number} of {count}: {time} s, {value}</source>
        <translation>Point {number} sur {count}&#xa0;: {time} s, {value}</translation>
    </message>
</context>
<context>
    <name>LatencyField</name>
    <message>
        <source>measured</source>
        <translation>mesurée</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>saisie</translation>
    </message>
    <message>
        <source>entered in its settings</source>
        <translation>saisie dans les réglages</translation>
    </message>
    <message>
        <source>kept by the device&apos;s clock</source>
        <translation>tenue par l’horloge de l’appareil</translation>
    </message>
    <message>
        <source>typical value, not measured</source>
        <translation>valeur courante, non mesurée</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latence</translation>
    </message>
    <message>
        <source>From a command to what is felt: compensated</source>
        <translation>De la commande au ressenti&#xa0;: compensée</translation>
    </message>
</context>
<context>
    <name>LatencyMonitor</name>
    <message>
        <source>The sound output {name} reports a latency of {ms:.0f} ms</source>
        <translation>La sortie audio {name} annonce une latence de {ms:.0f} ms</translation>
    </message>
    <message>
        <source>The sound output {name} seems to be wireless</source>
        <translation>La sortie son {name} semble être sans fil</translation>
    </message>
    <message>
        <source>the actual latency may be higher. Use wired headphones, or measure it: Device &gt; Measure latencies</source>
        <translation>la latence réelle peut être plus grande. Utilisez un casque filaire, ou mesurez-la&#xa0;: Appareil &gt; Mesurer les latences</translation>
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
        <source>Tap to the force</source>
        <translation>Taper sur la force</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>Taper</translation>
    </message>
    <message>
        <source>Tap to the flash</source>
        <translation>Taper sur le flash</translation>
    </message>
    <message>
        <source>Tap to the beep</source>
        <translation>Taper sur le bip</translation>
    </message>
    <message>
        <source>Play a beat every second</source>
        <translation>Jouer un battement par seconde</translation>
    </message>
    <message>
        <source>Stop the force immediately (Esc)</source>
        <translation>Couper la force immédiatement (Échap)</translation>
    </message>
    <message>
        <source>Tap on each beat (space bar)</source>
        <translation>Taper à chaque battement (barre d’espace)</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Save these latencies for these outputs</source>
        <translation>Enregistrer ces latences pour ces sorties</translation>
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
        <source>Discard changes</source>
        <translation>Annuler les modifications</translation>
    </message>
    <message>
        <source>Every second there is a flash, a beep and a gentle force pulse. Hold the grip loosely and press Start. Esc, STOP or a button on the grip stops it.</source>
        <translation>Chaque seconde, un flash, un bip et une légère impulsion de force. Tenez la poignée sans serrer et cliquez sur Démarrer. Échap, STOP ou un bouton de la poignée arrête tout.</translation>
    </message>
    <message>
        <source>Adjust the latencies until flash, beep and force come together. Increase the one that comes late.</source>
        <translation>Réglez les latences jusqu’à ce que flash, bip et force coïncident. Augmentez celle qui est en retard.</translation>
    </message>
    <message>
        <source>Press the space bar on each beat, at least eight times: first to the flash, then to the beep and the force. The differences are filled in; fine-tune them with &quot;All together&quot;.</source>
        <translation>Appuyez sur la barre d’espace à chaque battement, au moins huit fois&#xa0;: d’abord sur le flash, puis sur le bip et la force. Les différences sont inscrites&#xa0;; affinez-les avec «&#xa0;Tout ensemble&#xa0;».</translation>
    </message>
    <message>
        <source>{n} of {least} taps</source>
        <translation>Frappes&#xa0;: {n} sur {least}</translation>
    </message>
    <message>
        <source>{n} taps: {ms:.0f} ± {spread:.0f} ms</source>
        <translation>{n} frappes&#xa0;: {ms:.0f} ± {spread:.0f} ms</translation>
    </message>
</context>
<context>
    <name>LevelMeter</name>
    <message>
        <source>channel {channel} silent</source>
        <translation>canal {channel} silencieux</translation>
    </message>
    <message>
        <source>channel {channel} {db} dB, limited</source>
        <translation>canal {channel} {db} dB, limité</translation>
    </message>
    <message>
        <source>channel {channel} {db} dB</source>
        <translation>canal {channel} {db} dB</translation>
    </message>
</context>
<context>
    <name>LibraryChoice</name>
    <message>
        <source>Choose a recording</source>
        <translation>Choisir un enregistrement</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>There is no sequence in {folder}. Import a recording first (File &gt; Import), or choose another folder.</source>
        <translation>Il n’y a aucune séquence dans {folder}. Importez d’abord un enregistrement (Fichier &gt; Importer un enregistrement), ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Choisir</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Ajouter</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Choose a sequence in another folder</source>
        <translation>Choisir une séquence dans un autre dossier</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Sequence folder</source>
        <translation>Dossier de séquence</translation>
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
        <source>&amp;Add a track…</source>
        <translation>A&amp;jouter une piste…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Save the track for other software</source>
        <translation>Enregistrer la piste pour d’autres logiciels</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Reno&amp;mmer…</translation>
    </message>
    <message>
        <source>Add a force track from a file</source>
        <translation>Ajouter une piste de force à partir d’un fichier</translation>
    </message>
    <message>
        <source>Rename the track</source>
        <translation>Renommer la piste</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>En&amp;lever</translation>
    </message>
    <message>
        <source>Remove the track</source>
        <translation>Enlever la piste</translation>
    </message>
    <message>
        <source>Ren&amp;dering…</source>
        <translation>Rend&amp;u…</translation>
    </message>
    <message>
        <source>Render the force in another way, after a look at what changes</source>
        <translation>Calculer la force autrement, après un coup d’œil sur ce qui change</translation>
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
        <source>{name} does not say what its haptics are (modality Other, as the published encoder writes it for sound and AHAP). What are they?</source>
        <translation>{name} ne dit pas ce que sont ses effets haptiques (modalité Other, comme l’encodeur publié l’écrit pour le son et AHAP). Que sont-ils&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Force</source>
        <translation>&amp;Force</translation>
    </message>
    <message>
        <source>&amp;Vibration</source>
        <translation>&amp;Vibration</translation>
    </message>
    <message>
        <source>&amp;Leave them out</source>
        <translation>Les &amp;omettre</translation>
    </message>
    <message>
        <source>Export the track</source>
        <translation>Exporter la piste</translation>
    </message>
    <message>
        <source>Saving {name}</source>
        <translation>Enregistrement de {name}</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Enregistré&#xa0;: {name}</translation>
    </message>
    <message>
        <source>It keeps {what}</source>
        <translation>Contient {what}</translation>
    </message>
    <message>
        <source>{rendering}; one gain for each axis</source>
        <translation>{rendering}&#xa0;; un gain par axe</translation>
    </message>
    <message>
        <source>{rendering}; gain {gain} N per m/s²</source>
        <translation>{rendering}&#xa0;; gain {gain} N par m/s²</translation>
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
        <source>Undo the last deletion</source>
        <translation>Annuler la dernière suppression</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Annuler&#xa0;; rien n’est conservé</translation>
    </message>
    <message>
        <source>Import a recording</source>
        <translation>Importer un enregistrement</translation>
    </message>
    <message>
        <source>Choose the library folder</source>
        <translation>Choisir le dossier de la bibliothèque</translation>
    </message>
    <message>
        <source>&amp;Effects…</source>
        <translation>&amp;Effets…</translation>
    </message>
    <message>
        <source>Edit the effects</source>
        <translation>Modifier les effets</translation>
    </message>
    <message>
        <source>Change the title</source>
        <translation>Changer le titre</translation>
    </message>
    <message>
        <source>Check the checksums of all files</source>
        <translation>Vérifier les sommes de contrôle de tous les fichiers</translation>
    </message>
    <message>
        <source>Move to the bin</source>
        <translation>Déplacer vers la corbeille</translation>
    </message>
    <message>
        <source>Play (Enter)</source>
        <translation>Lire (Entrée)</translation>
    </message>
    <message>
        <source>&amp;Rendering…</source>
        <translation>Rend&amp;u…</translation>
    </message>
    <message>
        <source>Show in the file &amp;manager</source>
        <translation>&amp;Montrer dans le gestionnaire de fichiers</translation>
    </message>
    <message>
        <source>No sequences yet. Import a recording.</source>
        <translation>Pas encore de séquence. Importez un enregistrement.</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Aucun résultat</translation>
    </message>
    <message>
        <source>{title}: all files are intact</source>
        <translation>{title}&#xa0;: tous les fichiers sont intacts</translation>
    </message>
    <message>
        <source>Move {title} to the bin? You can restore it from there.</source>
        <translation>Déplacer {title} vers la corbeille&#xa0;? Vous pourrez l’en restaurer.</translation>
    </message>
    <message>
        <source>Could not move {title} to the bin; nothing was deleted.</source>
        <translation>Impossible de déplacer {title} vers la corbeille&#xa0;; rien n’a été supprimé.</translation>
    </message>
    <message>
        <source>Moved {title} to the bin.</source>
        <translation>{title} a été déplacé vers la corbeille.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;rrêter</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>Re&amp;nommer…</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>&amp;Vérifier</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Supprimer…</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
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
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
</context>
<context>
    <name>LivePane</name>
    <message>
        <source>Microphone</source>
        <translation>Microphone</translation>
    </message>
    <message>
        <source>Acceleration of the last seconds</source>
        <translation>Accélération des dernières secondes</translation>
    </message>
    <message>
        <source>Angular rate of the last seconds</source>
        <translation>Vitesse angulaire des dernières secondes</translation>
    </message>
    <message>
        <source>Acceleration with gravity, m/s²</source>
        <translation>Accélération avec gravité, m/s²</translation>
    </message>
    <message>
        <source>Angular rate, rad/s</source>
        <translation>Vitesse angulaire, rad/s</translation>
    </message>
    <message>
        <source>No camera</source>
        <translation>Pas de caméra</translation>
    </message>
    <message>
        <source>camera {rate} fps, dropped {lost}</source>
        <translation>caméra {rate} images/s, sautées&#xa0;: {lost}</translation>
    </message>
    <message>
        <source>sensor {rate} Hz, lost {lost}</source>
        <translation>capteur {rate} Hz, perdus&#xa0;: {lost}</translation>
    </message>
    <message>
        <source>gaps {count}</source>
        <translation>lacunes&#xa0;: {count}</translation>
    </message>
    <message>
        <source>marks {count}</source>
        <translation>marques&#xa0;: {count}</translation>
    </message>
    <message>
        <source>{free} GB free</source>
        <translation>{free} Go libres</translation>
    </message>
</context>
<context>
    <name>LivePicture</name>
    <message>
        <source>Live picture</source>
        <translation>Image en direct</translation>
    </message>
</context>
<context>
    <name>LivePlot</name>
    <message>
        <source>Wheel or + and −: zoom. Double-click or Enter: reset</source>
        <translation>Molette ou + et −&#xa0;: zoomer. Double clic ou Entrée&#xa0;: réinitialiser</translation>
    </message>
</context>
<context>
    <name>LogQuestionBox</name>
    <message>
        <source>&amp;Answer</source>
        <translation>&amp;Répondre</translation>
    </message>
    <message>
        <source>Read the log with this answer</source>
        <translation>Lire le journal avec cette réponse</translation>
    </message>
    <message>
        <source>Answer in a &amp;form…</source>
        <translation>Répondre dans un f&amp;ormulaire…</translation>
    </message>
    <message>
        <source>Units, axes, signs and more, with a check against gravity</source>
        <translation>Unités, axes, signes et plus encore, vérifiés d’après la pesanteur</translation>
    </message>
</context>
<context>
    <name>MarkerList</name>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Enter goes there, F2 renames, Delete removes</source>
        <translation>Entrée s’y rend, F2 renomme, Suppr retire</translation>
    </message>
    <message>
        <source>No markers yet. M sets one at the cursor.</source>
        <translation>Pas encore de marqueur. M en pose un au curseur.</translation>
    </message>
</context>
<context>
    <name>MergePage</name>
    <message>
        <source>Merge sessions of other machines</source>
        <translation>Fusionner les séances d’autres ordinateurs</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Site</translation>
    </message>
    <message>
        <source>Copy of the study</source>
        <translation>Copie de l’étude</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Copies to merge</source>
        <translation>Copies à fusionner</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>What came of this copy</source>
        <translation>Résultat de cette copie</translation>
    </message>
    <message>
        <source>Add the folders that have come back, or one that holds several: the names of its folders are those of the sites then. Sessions that are here already stay as they are. In the mixed models each site has an intercept of its own.</source>
        <translation>Ajoutez les dossiers revenus, ou un dossier qui en contient plusieurs&#xa0;: les noms de ses dossiers sont alors ceux des sites. Les séances déjà présentes restent telles quelles. Dans les modèles mixtes, chaque site a sa propre ordonnée à l’origine.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop; sessions that were added stay</source>
        <translation>Arrêter&#xa0;; les séances ajoutées restent</translation>
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
        <source>&amp;Add…</source>
        <translation>&amp;Ajouter…</translation>
    </message>
    <message>
        <source>Add a copy, or a folder that holds several</source>
        <translation>Ajouter une copie, ou un dossier qui en contient plusieurs</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Take the selected copy off this list</source>
        <translation>Retirer de cette liste la copie sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Merge</source>
        <translation>&amp;Fusionner</translation>
    </message>
    <message>
        <source>Add the sessions of all these copies</source>
        <translation>Ajouter les séances de toutes ces copies</translation>
    </message>
    <message>
        <source>&amp;Site of the selected copy</source>
        <translation>&amp;Site de la copie sélectionnée</translation>
    </message>
    <message>
        <source>● added: {added}, here already: {same}</source>
        <translation>● ajoutées&#xa0;: {added}, déjà présentes&#xa0;: {same}</translation>
    </message>
    <message>
        <source>▲ added: {added}, left out: {left}</source>
        <translation>▲ ajoutées&#xa0;: {added}, omises&#xa0;: {left}</translation>
    </message>
    <message>
        <source>Choose a copy of this study, or a folder of copies</source>
        <translation>Choisir une copie de cette étude, ou un dossier de copies</translation>
    </message>
    <message>
        <source>Merging</source>
        <translation>Fusion</translation>
    </message>
    <message>
        <source>Sessions added: {added}; here already: {same}; left out: {left}.</source>
        <translation>Séances ajoutées&#xa0;: {added}&#xa0;; déjà présentes&#xa0;: {same}&#xa0;; omises&#xa0;: {left}.</translation>
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
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the message, also in English, for a report</source>
        <translation>Copier le message, aussi en anglais, pour un rapport</translation>
    </message>
</context>
<context>
    <name>Mirror</name>
    <message>
        <source>The participant&apos;s view</source>
        <translation>Vue du participant</translation>
    </message>
    <message>
        <source>The participant sees a page</source>
        <translation>Le participant voit une page</translation>
    </message>
</context>
<context>
    <name>MountingPage</name>
    <message>
        <source>Mounting</source>
        <translation>Fixation</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Right {right}, front {front}, up {up}</source>
        <translation>Droite {right}, avant {front}, haut {up}</translation>
    </message>
    <message>
        <source>As the frames show, when it is imported</source>
        <translation>D’après les images, à l’importation</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Changer…</translation>
    </message>
    <message>
        <source>&amp;Mounting</source>
        <translation>&amp;Fixation</translation>
    </message>
    <message>
        <source>Choose another library folder</source>
        <translation>Choisir un autre dossier de bibliothèque</translation>
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
        <source>The drawing shows the recorder on the wearer, who faces forward; the dashed line shows which way was up, from gravity.</source>
        <translation>Le dessin montre l’enregistreur sur le porteur, qui regarde devant lui&#xa0;; la ligne pointillée indique le haut d’après la pesanteur.</translation>
    </message>
    <message>
        <source>Taken from the frames if they show it clearly; else you are asked.</source>
        <translation>Déterminée d’après les images si elles la montrent clairement&#xa0;; sinon, elle vous sera demandée.</translation>
    </message>
    <message>
        <source>The frames show this mounting (ratio {ratio} to the next best); gravity does not contradict it.</source>
        <translation>Les images montrent cette fixation (rapport {ratio} à la suivante)&#xa0;; la pesanteur ne la contredit pas.</translation>
    </message>
    <message>
        <source>The sensor rotated too much to determine the mounting from gravity.</source>
        <translation>Le capteur a trop tourné pour déterminer la fixation d’après la pesanteur.</translation>
    </message>
    <message>
        <source>Consistent with gravity. Only you know which side faced forward.</source>
        <translation>Compatible avec la pesanteur. Vous seul savez quel côté était devant.</translation>
    </message>
    <message>
        <source>Not consistent with gravity: another side was up.</source>
        <translation>Incompatible avec la pesanteur&#xa0;: un autre côté était en haut.</translation>
    </message>
    <message>
        <source>Choose the library folder</source>
        <translation>Choisir le dossier de la bibliothèque</translation>
    </message>
</context>
<context>
    <name>NewStudyDialog</name>
    <message>
        <source>New study</source>
        <translation>Nouvelle étude</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>For example: Bicycle rides 2026</source>
        <translation>Par exemple&#xa0;: Parcours à vélo 2026</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Créer</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Choisir un autre dossier</translation>
    </message>
    <message>
        <source>Languages of participants</source>
        <translation>Langues des participants</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Commencer avec</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>The study will be kept in {folder}</source>
        <translation>L’étude sera conservée dans {folder}</translation>
    </message>
    <message>
        <source>Choose where to create the study</source>
        <translation>Choisissez où créer l’étude</translation>
    </message>
    <message>
        <source>Choose a language for the participants&apos; pages</source>
        <translation>Choisissez une langue pour les pages des participants</translation>
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
    <name>OfferBar</name>
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
    <name>OrderPage</name>
    <message>
        <source>Orders</source>
        <translation>Ordres</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Never the same sequence twice in a row</source>
        <translation>Jamais deux fois de suite la même séquence</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>The same seed gives the same orders</source>
        <translation>La même graine donne les mêmes ordres</translation>
    </message>
    <message>
        <source>Take the orders of a file…</source>
        <translation>Reprendre les ordres d’un fichier…</translation>
    </message>
    <message>
        <source>A CSV file with order, position, sequence and feedback</source>
        <translation>Un fichier CSV avec order, position, sequence et feedback</translation>
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
        <source>Williams: balanced for carry-over</source>
        <translation>Williams&#xa0;: équilibré pour l’effet de report</translation>
    </message>
    <message>
        <source>From a table of your own (orders.csv)</source>
        <translation>D’après votre propre tableau (orders.csv)</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>next participant</source>
        <translation>prochain participant</translation>
    </message>
    <message>
        <source>example</source>
        <translation>exemple</translation>
    </message>
    <message>
        <source>There is no order yet: see the problems below.</source>
        <translation>Il n’y a pas encore d’ordre&#xa0;: voir les problèmes ci-dessous.</translation>
    </message>
    <message>
        <source>Every participant gets an order of their own, drawn from the seed and the participant&apos;s code.</source>
        <translation>Chaque participant reçoit son propre ordre, tiré de la graine et de son code.</translation>
    </message>
    <message>
        <source>Participants get the order that was used least; that of a session which ended early is given again.</source>
        <translation>Chaque participant reçoit l’ordre le moins utilisé&#xa0;; celui d’une séance terminée avant la fin est redonné.</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
</context>
<context>
    <name>OutputsPage</name>
    <message>
        <source>This device is already in use</source>
        <translation>Cet appareil est déjà utilisé</translation>
    </message>
    <message>
        <source>Settings may contain letters, digits and punctuation</source>
        <translation>Les réglages peuvent contenir des lettres, des chiffres et des signes de ponctuation</translation>
    </message>
    <message>
        <source>No more devices can be added; remove one first</source>
        <translation>Aucun autre appareil ne peut être ajouté&#xa0;; retirez-en un d’abord</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Also play on this device</source>
        <translation>Jouer aussi sur cet appareil</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop all of them (Esc)</source>
        <translation>Les arrêter tous (Échap)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The devices keep playing</source>
        <translation>Les appareils continuent de jouer</translation>
    </message>
    <message>
        <source>Address or settings</source>
        <translation>Adresse ou réglages</translation>
    </message>
    <message>
        <source>Nothing plays yet. Choose a device below and press Add.</source>
        <translation>Rien ne joue encore. Choisissez un appareil ci-dessous et appuyez sur Ajouter.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latence</translation>
    </message>
    <message>
        <source>Device to add</source>
        <translation>Appareil à ajouter</translation>
    </message>
    <message>
        <source>Latency that is compensated ({source})</source>
        <translation>Latence compensée ({source})</translation>
    </message>
    <message>
        <source>All of these play at once and stop at once. The first one leads: its position is shown and its buttons count. A rig moves with the motion of the recording: begin with a small gain.</source>
        <translation>Toutes jouent et s’arrêtent en même temps. La première mène&#xa0;: sa position est affichée et ses boutons comptent. Une plateforme suit le mouvement de l’enregistrement&#xa0;: commencez par un petit gain.</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Muet</translation>
    </message>
    <message>
        <source>Multiplies everything that this output plays</source>
        <translation>Multiplie tout ce que joue cette sortie</translation>
    </message>
    <message>
        <source>Test…</source>
        <translation>Tester…</translation>
    </message>
    <message>
        <source>Moves it gently; asks first</source>
        <translation>Le fait bouger doucement&#xa0;; demande d’abord</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Configurer…</translation>
    </message>
    <message>
        <source>What it needs, and how it is connected</source>
        <translation>Ce dont il a besoin et comment le brancher</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Release this device</source>
        <translation>Libérer cet appareil</translation>
    </message>
    <message>
        <source>Move up; the first one leads</source>
        <translation>Monter&#xa0;; la première mène</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
</context>
<context>
    <name>PagePreview</name>
    <message>
        <source>Full size</source>
        <translation>Taille réelle</translation>
    </message>
    <message>
        <source>Show the page on the participant&apos;s screen</source>
        <translation>Montrer la page sur l’écran du participant</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
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
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Choisir un autre dossier</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>This folder exists already: choose another place</source>
        <translation>Ce dossier existe déjà&#xa0;: choisissez un autre emplacement</translation>
    </message>
    <message>
        <source>Choose where to create the folder</source>
        <translation>Où créer le dossier&#xa0;?</translation>
    </message>
    <message>
        <source>Export the data</source>
        <translation>Exporter les données</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message>
        <source>The data will be written to {folder}</source>
        <translation>Les données seront écrites dans {folder}</translation>
    </message>
    <message>
        <source>Pack the study for other sites</source>
        <translation>Empaqueter l’étude pour d’autres sites</translation>
    </message>
    <message>
        <source>&amp;Pack</source>
        <translation>&amp;Empaqueter</translation>
    </message>
    <message>
        <source>Definition, orders and all sequences, without sessions, will be copied to {folder}</source>
        <translation>La définition, les ordres et toutes les séquences, sans les séances, seront copiés dans {folder}</translation>
    </message>
</context>
<context>
    <name>PlayBar</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Zoom in (+)</source>
        <translation>Agrandir (+)</translation>
    </message>
    <message>
        <source>Zoom out (−)</source>
        <translation>Réduire (−)</translation>
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
        <source>Zoom in</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Boucle</translation>
    </message>
    <message>
        <source>Repeat the selected effects, or what is in view without any</source>
        <translation>Répéter les effets sélectionnés ou, sans sélection, la partie visible</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>A&amp;vant</translation>
    </message>
    <message>
        <source>Show the force without effects behind it</source>
        <translation>Montrer derrière la force sans effets</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Mag&amp;nétisme</translation>
    </message>
    <message>
        <source>Snap to frames, events and other effects</source>
        <translation>Aligner sur les images, les événements et les autres effets</translation>
    </message>
</context>
<context>
    <name>PlayerWindow</name>
    <message>
        <source>Force stopped. {keys} re-arms it.</source>
        <translation>Force coupée. {keys} la réarme.</translation>
    </message>
    <message>
        <source>No next file</source>
        <translation>Pas de fichier suivant</translation>
    </message>
    <message>
        <source>No previous file</source>
        <translation>Pas de fichier précédent</translation>
    </message>
    <message>
        <source>Repeat off</source>
        <translation>Répétition désactivée</translation>
    </message>
    <message>
        <source>Repeat this clip</source>
        <translation>Répéter ce clip</translation>
    </message>
    <message>
        <source>Repeat all</source>
        <translation>Répéter tout</translation>
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
        <translation>Liste de lecture</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
    </message>
    <message>
        <source>Do not repeat</source>
        <translation>Ne pas répéter</translation>
    </message>
    <message>
        <source>Repeat this clip</source>
        <translation>Répéter ce clip</translation>
    </message>
    <message>
        <source>Repeat all</source>
        <translation>Répéter tout</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Ajouter…</translation>
    </message>
    <message>
        <source>Add videos; sequences can be dropped here</source>
        <translation>Ajouter des vidéos&#xa0;; les séquences peuvent être déposées ici</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Remove from the list; no file is deleted</source>
        <translation>Retirer de la liste&#xa0;; aucun fichier n’est supprimé</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Play it earlier</source>
        <translation>Lire plus tôt</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>Play it later</source>
        <translation>Lire plus tard</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>At the e&amp;nd</source>
        <translation>À la fi&amp;n</translation>
    </message>
    <message>
        <source>Clips play one after the other.</source>
        <translation>Les clips sont lus l’un après l’autre.</translation>
    </message>
    <message>
        <source>The list is empty. Add videos, or drop videos and sequences here. Without a list, Next and Previous play what is in the folder of the clip.</source>
        <translation>La liste est vide. Ajoutez des vidéos, ou déposez ici des vidéos et des séquences. Sans liste, «&#xa0;Fichier suivant&#xa0;» et «&#xa0;Fichier précédent&#xa0;» lisent ce qui est dans le dossier du clip.</translation>
    </message>
    <message>
        <source>Add videos</source>
        <translation>Ajouter des vidéos</translation>
    </message>
</context>
<context>
    <name>PlotArea</name>
    <message>
        <source>Live plots</source>
        <translation>Courbes</translation>
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
        <translation>Ce clip n’a pas de données de mouvement</translation>
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
        <source>z towards you</source>
        <translation>z vers vous</translation>
    </message>
    <message>
        <source>thin: planned</source>
        <translation>fin&#xa0;: prévue</translation>
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
        <source>PNG image (*.png);;SVG drawing (*.svg);;CSV data (*.csv)</source>
        <translation>Image PNG (*.png);;Dessin SVG (*.svg);;Données CSV (*.csv)</translation>
    </message>
    <message>
        <source>{name}: unsupported file type; choose one of {kinds}</source>
        <translation>{name}&#xa0;: type de fichier non pris en charge&#xa0;; choisissez {kinds}</translation>
    </message>
    <message>
        <source>Click: seek. Drag: pan. Wheel or + and −: zoom. Double-click or Enter: reset</source>
        <translation>Clic&#xa0;: aller à. Glisser&#xa0;: déplacer. Molette ou + et −&#xa0;: zoomer. Double clic ou Entrée&#xa0;: réinitialiser</translation>
    </message>
</context>
<context>
    <name>PreferencesPage</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Par défaut du système</translation>
    </message>
    <message>
        <source>Same screen as the window</source>
        <translation>L’écran de la fenêtre</translation>
    </message>
    <message>
        <source>Resume clips &amp;where they were left</source>
        <translation>Reprendre les clips &amp;où ils ont été quittés</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>Sound &amp;output</source>
        <translation>&amp;Sortie du son</translation>
    </message>
    <message>
        <source>&amp;Fullscreen on</source>
        <translation>&amp;Plein écran sur</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Saved frames</source>
        <translation>Images enregistrées</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>Ra&amp;ccourcis…</translation>
    </message>
    <message>
        <source>&amp;Devices…</source>
        <translation>Appare&amp;ils…</translation>
    </message>
    <message>
        <source>L&amp;atencies…</source>
        <translation>Lat&amp;ences…</translation>
    </message>
    <message>
        <source>O&amp;K</source>
        <translation>O&amp;K</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>More is set on pages of its own:</source>
        <translation>Le reste se règle sur des pages à part&#xa0;:</translation>
    </message>
</context>
<context>
    <name>ProcessingFields</name>
    <message>
        <source>Gravity removal</source>
        <translation>Retrait de la pesanteur</translation>
    </message>
    <message>
        <source>Time constant, s</source>
        <translation>Constante de temps, s</translation>
    </message>
    <message>
        <source>from the motion</source>
        <translation>d’après le mouvement</translation>
    </message>
    <message>
        <source>Accelerations that last much longer than this count as gravity</source>
        <translation>Les accélérations qui durent bien plus longtemps comptent comme pesanteur</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>For short recordings: the file with what a longer one of the same sensor tells of its errors</source>
        <translation>Pour les enregistrements courts&#xa0;: le fichier contenant ce qu’un enregistrement plus long du même capteur révèle de ses erreurs</translation>
    </message>
    <message>
        <source>Replace isolated s&amp;pikes</source>
        <translation>Re&amp;mplacer les pics isolés</translation>
    </message>
    <message>
        <source>Reconstruct short cli&amp;pped peaks</source>
        <translation>Re&amp;construire les courts sommets écrêtés</translation>
    </message>
    <message>
        <source>Average to, Hz</source>
        <translation>Moyenne à, Hz</translation>
    </message>
    <message>
        <source>Low-pass at, Hz</source>
        <translation>Passe-bas à, Hz</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>sans</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Choisir un étalonnage</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>Éta&amp;lonnage</translation>
    </message>
    <message>
        <source>Gra&amp;vity removal</source>
        <translation>Retrait de la pesa&amp;nteur</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>Good: ready for use</source>
        <translation>Bon&#xa0;: prêt à l’emploi</translation>
    </message>
    <message>
        <source>Doubtful: check the marked items</source>
        <translation>Douteux&#xa0;: vérifiez les points signalés</translation>
    </message>
    <message>
        <source>Bad: record or import it again</source>
        <translation>Mauvais&#xa0;: enregistrez ou importez de nouveau</translation>
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
        <source>Motion</source>
        <translation>Mouvement</translation>
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
        <source>Residual gravity at rest</source>
        <translation>Pesanteur résiduelle au repos</translation>
    </message>
    <message>
        <source>Sensor saturation</source>
        <translation>Saturation du capteur</translation>
    </message>
    <message>
        <source>Clip without motion data</source>
        <translation>Clip sans données de mouvement</translation>
    </message>
    <message>
        <source>Force saturation</source>
        <translation>Saturation de la force</translation>
    </message>
    <message>
        <source>Workspace used</source>
        <translation>Espace de travail utilisé</translation>
    </message>
    <message>
        <source>Motor heating</source>
        <translation>Échauffement des moteurs</translation>
    </message>
    <message>
        <source>residual {ms} ms, confirmed by a person ({how})</source>
        <translation>reste {ms}&#xa0;ms, confirmé par une personne ({how})</translation>
    </message>
    <message>
        <source>estimated from the picture, nothing measured it: sway in {sway}, bounce in {bounce} of the clip; gain {gain}</source>
        <translation>estimé d’après l’image, rien ne l’a mesuré&#xa0;: balancement dans {sway}, rebond dans {bounce} du clip&#xa0;; gain {gain}</translation>
    </message>
    <message>
        <source>{share} of the time; the peak is {n} N</source>
        <translation>{share} du temps&#xa0;; la crête est de {n} N</translation>
    </message>
    <message>
        <source>The force would be stopped; lower the gain</source>
        <translation>La force serait coupée&#xa0;; réduisez le gain</translation>
    </message>
    <message>
        <source>Record the motion with the next video</source>
        <translation>Enregistrez le mouvement avec la prochaine vidéo</translation>
    </message>
    <message>
        <source>Check the synchronisation</source>
        <translation>Vérifiez la synchronisation</translation>
    </message>
    <message>
        <source>Check the synchronisation; next time tap the recorder three times</source>
        <translation>Vérifiez la synchronisation&#xa0;; la prochaine fois, tapez trois fois sur l’enregistreur</translation>
    </message>
    <message>
        <source>In long recordings, tap at the end as well</source>
        <translation>Pour un long enregistrement, tapez aussi à la fin</translation>
    </message>
    <message>
        <source>Next time: record at 100 Hz or more</source>
        <translation>La prochaine fois&#xa0;: enregistrez à 100 Hz ou plus</translation>
    </message>
    <message>
        <source>Next time: keep still for a few seconds at the start</source>
        <translation>La prochaine fois&#xa0;: restez immobile quelques secondes au début</translation>
    </message>
    <message>
        <source>Next time: choose a larger accelerometer range</source>
        <translation>La prochaine fois&#xa0;: choisissez une plus grande plage d’accéléromètre</translation>
    </message>
    <message>
        <source>Next time: start the log before the clip and stop it after</source>
        <translation>La prochaine fois&#xa0;: démarrez le journal avant le clip et arrêtez-le après</translation>
    </message>
    <message>
        <source>There is no force in the gaps; try another memory card</source>
        <translation>Pas de force dans les lacunes&#xa0;; essayez une autre carte mémoire</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lacunes</translation>
    </message>
    <message>
        <source>Bad: change the rendering</source>
        <translation>Mauvais&#xa0;: changez le rendu</translation>
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
        <source>relaxed hand</source>
        <translation>main détendue</translation>
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
    <name>Question</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>QuestionList</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>Score: {text}</source>
        <translation>Score&#xa0;: {text}</translation>
    </message>
    <message>
        <source>(no wording yet)</source>
        <translation>(pas encore de formulation)</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Affichée</translation>
    </message>
    <message>
        <source>Text above the questions</source>
        <translation>Texte au-dessus des questions</translation>
    </message>
    <message>
        <source>All clips may be played again there</source>
        <translation>Tous les clips peuvent y être rejoués</translation>
    </message>
    <message>
        <source>The questions are shown one after the other</source>
        <translation>Les questions s’affichent l’une après l’autre</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licence</translation>
    </message>
    <message>
        <source>Wording</source>
        <translation>Formulation</translation>
    </message>
    <message>
        <source>Help line</source>
        <translation>Ligne d’aide</translation>
    </message>
    <message>
        <source>Kind of answer</source>
        <translation>Type de réponse</translation>
    </message>
    <message>
        <source>An answer is required</source>
        <translation>Une réponse est obligatoire</translation>
    </message>
    <message>
        <source>Part of the sum QoE, which is analysed first</source>
        <translation>Fait partie de la somme QoE, analysée en premier</translation>
    </message>
    <message>
        <source>Ask once for each kind of feedback</source>
        <translation>Demander une fois pour chaque type de retour</translation>
    </message>
    <message>
        <source>Unit in the data</source>
        <translation>Unité dans les données</translation>
    </message>
    <message>
        <source>another range</source>
        <translation>autre plage</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Remove this label</source>
        <translation>Retirer ce libellé</translation>
    </message>
    <message>
        <source>Add a label</source>
        <translation>Ajouter un libellé</translation>
    </message>
    <message>
        <source>another label</source>
        <translation>autre libellé</translation>
    </message>
    <message>
        <source>removal</source>
        <translation>retrait</translation>
    </message>
    <message>
        <source>another page</source>
        <translation>autre page</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Nom dans les données</translation>
    </message>
    <message>
        <source>Add a question or a page</source>
        <translation>Ajouter une question ou une page</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>Dans les données et les figures&#xa0;: a à z, 0 à 9, _ et -</translation>
    </message>
    <message>
        <source>Published wording</source>
        <translation>Formulation publiée</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>At most so many characters</source>
        <translation>Nombre maximal de caractères</translation>
    </message>
    <message>
        <source>Answer {n}</source>
        <translation>Réponse {n}</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Ajouter une réponse</translation>
    </message>
    <message>
        <source>Number that it counts as, if any</source>
        <translation>Nombre qu’elle vaut, le cas échéant</translation>
    </message>
    <message>
        <source>Remove this answer</source>
        <translation>Retirer cette réponse</translation>
    </message>
    <message>
        <source>another scale</source>
        <translation>autre échelle</translation>
    </message>
    <message>
        <source>another score</source>
        <translation>autre score</translation>
    </message>
    <message>
        <source>another question</source>
        <translation>autre question</translation>
    </message>
    <message>
        <source>another kind of answer</source>
        <translation>autre type de réponse</translation>
    </message>
    <message>
        <source>another answer</source>
        <translation>autre réponse</translation>
    </message>
</context>
<context>
    <name>QueuePage</name>
    <message>
        <source>Import several clips</source>
        <translation>Importer plusieurs clips</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation>Journal de mouvement</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Clips to import</source>
        <translation>Clips à importer</translation>
    </message>
    <message>
        <source>No clips yet: add some, or drop them here.</source>
        <translation>Pas encore de clip&#xa0;: ajoutez-en, ou déposez-les ici.</translation>
    </message>
    <message>
        <source>Each clip is imported with its own motion, or with the log of the same name, and tested. Clips that are in the library are only tested. A clip that needs an answer waits; the others go on.</source>
        <translation>Chaque clip est importé avec son propre mouvement, ou avec le journal du même nom, puis vérifié. Les clips qui sont déjà dans la bibliothèque sont seulement vérifiés. Un clip qui demande une réponse attend&#xa0;; les autres continuent.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Stop the queue; what is done is kept</source>
        <translation>Arrêter la file&#xa0;; ce qui est fait est conservé</translation>
    </message>
    <message>
        <source>&amp;Clips…</source>
        <translation>&amp;Clips…</translation>
    </message>
    <message>
        <source>Add clips and logs</source>
        <translation>Ajouter des clips et des journaux</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Add a folder of clips</source>
        <translation>Ajouter un dossier de clips</translation>
    </message>
    <message>
        <source>&amp;Answer…</source>
        <translation>&amp;Répondre…</translation>
    </message>
    <message>
        <source>Import the selected clip step by step</source>
        <translation>Importer le clip sélectionné étape par étape</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Play the selected sequence</source>
        <translation>Lire la séquence sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>Dé&amp;marrer</translation>
    </message>
    <message>
        <source>Import what is not yet there</source>
        <translation>Importer ce qui ne l’est pas encore</translation>
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
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>importing</source>
        <translation>importation en cours</translation>
    </message>
    <message>
        <source>● imported</source>
        <translation>● importé</translation>
    </message>
    <message>
        <source>● was there, intact</source>
        <translation>● déjà là, intact</translation>
    </message>
    <message>
        <source>▲ needs an answer</source>
        <translation>▲ demande une réponse</translation>
    </message>
    <message>
        <source>■ not imported</source>
        <translation>■ non importé</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>imported: {count}</source>
        <translation>importés&#xa0;: {count}</translation>
    </message>
    <message>
        <source>were there: {count}</source>
        <translation>déjà là&#xa0;: {count}</translation>
    </message>
    <message>
        <source>need an answer: {count}</source>
        <translation>demandent une réponse&#xa0;: {count}</translation>
    </message>
    <message>
        <source>not imported: {count}</source>
        <translation>non importés&#xa0;: {count}</translation>
    </message>
    <message>
        <source>stopped: {count}</source>
        <translation>arrêtés&#xa0;: {count}</translation>
    </message>
    <message>
        <source>importing: {count}</source>
        <translation>en cours d’importation&#xa0;: {count}</translation>
    </message>
    <message>
        <source>waiting: {count}</source>
        <translation>en attente&#xa0;: {count}</translation>
    </message>
    <message>
        <source>Clips: {count}</source>
        <translation>Clips&#xa0;: {count}</translation>
    </message>
    <message>
        <source>Choose clips and logs</source>
        <translation>Choisir des clips et des journaux</translation>
    </message>
    <message>
        <source>Choose a folder of clips</source>
        <translation>Choisir un dossier de clips</translation>
    </message>
</context>
<context>
    <name>RatingList</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a rating while a clip plays</source>
        <translation>Ajouter une évaluation pendant la lecture d’un clip</translation>
    </message>
    <message>
        <source>Ratings while a clip plays</source>
        <translation>Évaluations pendant la lecture d’un clip</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Curseur</translation>
    </message>
    <message>
        <source>Number every so often</source>
        <translation>Nombre à intervalles réguliers</translation>
    </message>
    <message>
        <source>Key that is held</source>
        <translation>Touche maintenue</translation>
    </message>
    <message>
        <source>(no wording yet)</source>
        <translation>(pas encore de formulation)</translation>
    </message>
    <message>
        <source>Wording</source>
        <translation>Formulation</translation>
    </message>
    <message>
        <source>Kind of rating</source>
        <translation>Type d’évaluation</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Asked for every</source>
        <translation>Demandé toutes les</translation>
    </message>
    <message>
        <source>Said aloud: the operator enters it</source>
        <translation>Dit à voix haute&#xa0;: l’opérateur le saisit</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>A letter, enter, shift or control</source>
        <translation>Une lettre, enter, shift ou control</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Nom dans les données</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>Dans les données et les figures&#xa0;: a à z, 0 à 9, _ et -</translation>
    </message>
    <message>
        <source>Ends clip and force from</source>
        <translation>Arrête clip et force à partir de</translation>
    </message>
    <message>
        <source>A value from which the clip ends; empty for none</source>
        <translation>Une valeur à partir de laquelle le clip s’arrête&#xa0;; vide&#xa0;: aucune</translation>
    </message>
    <message>
        <source>Text of the break after that</source>
        <translation>Texte de la pause qui suit</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>souris</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>touches fléchées</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Déplacé par</translation>
    </message>
    <message>
        <source>Add a label</source>
        <translation>Ajouter un libellé</translation>
    </message>
    <message>
        <source>another label</source>
        <translation>autre libellé</translation>
    </message>
    <message>
        <source>another rating</source>
        <translation>autre évaluation</translation>
    </message>
    <message>
        <source>another kind of rating</source>
        <translation>autre type d’évaluation</translation>
    </message>
</context>
<context>
    <name>Reading</name>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>choose or type</source>
        <translation>choisir ou saisir</translation>
    </message>
    <message>
        <source>accelerometer {axis}</source>
        <translation>accéléromètre {axis}</translation>
    </message>
    <message>
        <source>gyroscope {axis}</source>
        <translation>gyroscope {axis}</translation>
    </message>
    <message>
        <source>magnetometer {axis}</source>
        <translation>magnétomètre {axis}</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>ignorer</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>+1 g upwards</source>
        <translation>+1 g vers le haut</translation>
    </message>
    <message>
        <source>−1 g upwards</source>
        <translation>−1 g vers le haut</translation>
    </message>
    <message>
        <source>single values</source>
        <translation>instantanées</translation>
    </message>
    <message>
        <source>means over a window</source>
        <translation>moyennées sur une fenêtre</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Unité de temps</translation>
    </message>
    <message>
        <source>Accelerometer unit</source>
        <translation>Unité de l’accéléromètre</translation>
    </message>
    <message>
        <source>Gyroscope unit</source>
        <translation>Unité du gyroscope</translation>
    </message>
    <message>
        <source>Accelerometer reads</source>
        <translation>L’accéléromètre mesure</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Les valeurs sont</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Mesures par seconde</translation>
    </message>
    <message>
        <source>Magnetometer unit</source>
        <translation>Unité du magnétomètre</translation>
    </message>
    <message>
        <source>right {right}, front {front}, up {up}</source>
        <translation>droite {right}, avant {front}, haut {up}</translation>
    </message>
    <message>
        <source>not swapped</source>
        <translation>non échangées</translation>
    </message>
    <message>
        <source>accelerometer, gyroscope</source>
        <translation>accéléromètre, gyroscope</translation>
    </message>
    <message>
        <source>accelerometer, magnetometer</source>
        <translation>accéléromètre, magnétomètre</translation>
    </message>
    <message>
        <source>The wearer’s axes in the log</source>
        <translation>Axes du porteur dans le journal</translation>
    </message>
    <message>
        <source>Accelerometer x, y, z</source>
        <translation>Accéléromètre x, y, z</translation>
    </message>
    <message>
        <source>Gyroscope x, y, z</source>
        <translation>Gyroscope x, y, z</translation>
    </message>
    <message>
        <source>Gyroscope late by, s</source>
        <translation>Retard du gyroscope, s</translation>
    </message>
    <message>
        <source>Swapped columns</source>
        <translation>Colonnes échangées</translation>
    </message>
    <message>
        <source>If a sensor was stuck</source>
        <translation>Si un capteur était bloqué</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>aucune force</translation>
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
        <translation>Comment le journal est lu</translation>
    </message>
    <message>
        <source>Filled in from</source>
        <translation>Rempli d’après</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>Keep as</source>
        <translation>Conserver sous</translation>
    </message>
    <message>
        <source>a name, to use this for the next log</source>
        <translation>un nom, pour servir au prochain journal</translation>
    </message>
    <message>
        <source>From a &amp;file…</source>
        <translation>Depuis un &amp;fichier…</translation>
    </message>
    <message>
        <source>Load the answers from a template</source>
        <translation>Charger les réponses depuis un modèle</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Keep what was answered before</source>
        <translation>Garder les réponses précédentes</translation>
    </message>
    <message>
        <source>&amp;Use this</source>
        <translation>&amp;Utiliser</translation>
    </message>
    <message>
        <source>Read the log with these answers</source>
        <translation>Lire le journal avec ces réponses</translation>
    </message>
    <message>
        <source>F&amp;illed in from</source>
        <translation>Re&amp;mpli d’après</translation>
    </message>
    <message>
        <source>&amp;Keep as</source>
        <translation>&amp;Conserver sous</translation>
    </message>
    <message>
        <source>Say what each column of {name} holds and in which units. The check shows at once whether gravity agrees.</source>
        <translation>Indiquez ce que contient chaque colonne de {name}, et dans quelles unités. La vérification montre aussitôt si la pesanteur concorde.</translation>
    </message>
    <message>
        <source>{name} describes itself. Say here what it has wrong; the check shows at once whether gravity agrees.</source>
        <translation>{name} décrit son propre contenu. Indiquez ici ce qui y est faux&#xa0;; la vérification montre aussitôt si la pesanteur concorde.</translation>
    </message>
    <message>
        <source>Choose a template</source>
        <translation>Choisir un modèle</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Read: {rate} Hz, {duration}</source>
        <translation>Lu&#xa0;: {rate} Hz, {duration}</translation>
    </message>
    <message>
        <source>Never at rest: not compared with gravity (9.81 m/s²)</source>
        <translation>Jamais au repos&#xa0;: pas de comparaison avec la pesanteur (9.81 m/s²)</translation>
    </message>
    <message>
        <source>At rest {norm} m/s²; gravity is {gravity} m/s²</source>
        <translation>Au repos {norm} m/s²&#xa0;; la pesanteur est de {gravity} m/s²</translation>
    </message>
    <message>
        <source>Gravity hardly turns: the gyroscope cannot be compared</source>
        <translation>La pesanteur tourne à peine&#xa0;: le gyroscope ne peut pas être comparé</translation>
    </message>
    <message>
        <source>The gyroscope agrees with turning gravity</source>
        <translation>Le gyroscope concorde avec la rotation de la pesanteur</translation>
    </message>
    <message>
        <source>The gyroscope does not agree with turning gravity</source>
        <translation>Le gyroscope ne concorde pas avec la rotation de la pesanteur</translation>
    </message>
    <message>
        <source>Choose: {fields}</source>
        <translation>Choisissez&#xa0;: {fields}</translation>
    </message>
</context>
<context>
    <name>RecentMenu</name>
    <message>
        <source>Clear list</source>
        <translation>Vider la liste</translation>
    </message>
</context>
<context>
    <name>RecordPage</name>
    <message>
        <source>Record</source>
        <translation>Enregistrer une prise</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
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
        <source>&amp;Mark</source>
        <translation>Mar&amp;quer</translation>
    </message>
    <message>
        <source>Mark this moment in the recording</source>
        <translation>Marquer cet instant dans l’enregistrement</translation>
    </message>
    <message>
        <source>Pre&amp;view</source>
        <translation>Aperç&amp;u</translation>
    </message>
    <message>
        <source>Show picture, sound and motion for a minute; nothing is kept</source>
        <translation>Montrer image, son et mouvement pendant une minute&#xa0;; rien n’est gardé</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Start a recording</source>
        <translation>Commencer un enregistrement</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Arrê&amp;ter</translation>
    </message>
    <message>
        <source>Stop, and show the take</source>
        <translation>Arrêter et montrer la prise</translation>
    </message>
    <message>
        <source>Record &amp;again</source>
        <translation>Re&amp;commencer</translation>
    </message>
    <message>
        <source>Keep this take, and record another one</source>
        <translation>Garder cette prise et en faire une autre</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Make a sequence of this take</source>
        <translation>Faire une séquence de cette prise</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>Fermeture</translation>
    </message>
    <message>
        <source>Reading the take</source>
        <translation>Lecture de la prise</translation>
    </message>
    <message>
        <source>&amp;Allow</source>
        <translation>A&amp;utoriser</translation>
    </message>
    <message>
        <source>&amp;Do not allow</source>
        <translation>&amp;Ne pas autoriser</translation>
    </message>
    <message>
        <source>End pre&amp;view</source>
        <translation>Fin de l’aperç&amp;u</translation>
    </message>
    <message>
        <source>A recording is running. Stop it? What was recorded is kept.</source>
        <translation>Un enregistrement est en cours. L’arrêter&#xa0;? Ce qui a été enregistré est gardé.</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Continuer</translation>
    </message>
</context>
<context>
    <name>RecoveryBar</name>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Throw these changes away for good</source>
        <translation>Abandonner définitivement ces modifications</translation>
    </message>
    <message>
        <source>Changes to {name} from {moment} were not saved.</source>
        <translation>Des modifications de {name}, du {moment}, n’ont pas été enregistrées.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Restaurer</translation>
    </message>
</context>
<context>
    <name>RenderingFields</name>
    <message>
        <source>S&amp;often strong forces (soft knee at {knee} N)</source>
        <translation>Ad&amp;oucir les forces élevées (coude à {knee} N)</translation>
    </message>
    <message>
        <source>Compresses what is above instead of cutting it at the limit</source>
        <translation>Comprime ce qui dépasse au lieu de le couper à la limite</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendu</translation>
    </message>
    <message>
        <source>Kind of gain</source>
        <translation>Type de gain</translation>
    </message>
    <message>
        <source>One for all axes</source>
        <translation>Un pour tous les axes</translation>
    </message>
    <message>
        <source>One for each axis</source>
        <translation>Un par axe</translation>
    </message>
    <message>
        <source>Fitted to this clip</source>
        <translation>Ajusté à ce clip</translation>
    </message>
    <message>
        <source> N per m/s²</source>
        <translation> N par m/s²</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Use the same gain for all sequences that you compare</source>
        <translation>Le même gain pour toutes les séquences à comparer</translation>
    </message>
    <message>
        <source>Device position</source>
        <translation>Position de l’appareil</translation>
    </message>
    <message>
        <source>in front of the user: forward pulls the hand away</source>
        <translation>devant l’utilisateur&#xa0;: l’avant éloigne la main</translation>
    </message>
    <message>
        <source>to the right of the user</source>
        <translation>à droite de l’utilisateur</translation>
    </message>
    <message>
        <source>behind the user</source>
        <translation>derrière l’utilisateur</translation>
    </message>
    <message>
        <source>to the left of the user</source>
        <translation>à gauche de l’utilisateur</translation>
    </message>
    <message>
        <source>other axes</source>
        <translation>autres axes</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>The device’s right, up and towards the user in the wearer’s axes (x right, y front, z up), such as x,z,-y, or the nine numbers of a rotation, row by row</source>
        <translation>La droite, le haut et la direction de l’utilisateur de l’appareil, dans les axes du porteur de l’enregistreur (x droite, y avant, z haut), par exemple x,z,-y, ou les neuf nombres d’une rotation, ligne par ligne</translation>
    </message>
    <message>
        <source>Handlebar</source>
        <translation>Guidon</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Selle</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Felt point</source>
        <translation>Point ressenti</translation>
    </message>
    <message>
        <source>the recorder itself</source>
        <translation>l’enregistreur lui-même</translation>
    </message>
    <message>
        <source>{point}, from a recorder on the chest</source>
        <translation>{point}, enregistreur sur la poitrine</translation>
    </message>
    <message>
        <source>another point</source>
        <translation>un autre point</translation>
    </message>
    <message>
        <source>From the recorder</source>
        <translation>Depuis l’enregistreur</translation>
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
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>&amp;Rendering</source>
        <translation>&amp;Rendu</translation>
    </message>
    <message>
        <source>&amp;Gain</source>
        <translation>&amp;Gain</translation>
    </message>
    <message>
        <source>&amp;Device position</source>
        <translation>Position de l’&amp;appareil</translation>
    </message>
    <message>
        <source>&amp;Felt point</source>
        <translation>&amp;Point ressenti</translation>
    </message>
    <message>
        <source>Fitted to this clip: {gain} N per m/s². Sequences with different gains cannot be compared</source>
        <translation>Ajusté à ce clip&#xa0;: {gain} N par m/s². Des séquences de gains différents ne sont pas comparables</translation>
    </message>
    <message>
        <source>Faithful</source>
        <translation>Fidèle</translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation>Équilibré</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Égal</translation>
    </message>
    <message>
        <source>towards the user</source>
        <translation>vers l’utilisateur</translation>
    </message>
</context>
<context>
    <name>RenderingPage</name>
    <message>
        <source>Rendering</source>
        <translation>Rendu</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>détendue</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>ferme</translation>
    </message>
    <message>
        <source>Force, RMS</source>
        <translation>Force efficace</translation>
    </message>
    <message>
        <source>Force, peak</source>
        <translation>Force maximale</translation>
    </message>
    <message>
        <source>Time at the force limit</source>
        <translation>Temps à la limite de force</translation>
    </message>
    <message>
        <source>Workspace, {hand} hand</source>
        <translation>Espace de travail, main {hand}</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Arrê&amp;ter</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Annuler&#xa0;; rien n’est conservé</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;New sequence…</source>
        <translation>&amp;Nouvelle séquence…</translation>
    </message>
    <message>
        <source>Keep this sequence, and make another one in the library</source>
        <translation>Garder cette séquence et en créer une autre dans la bibliothèque</translation>
    </message>
    <message>
        <source>Change this se&amp;quence</source>
        <translation>&amp;Modifier cette séquence</translation>
    </message>
    <message>
        <source>Render the realistic and the random track again</source>
        <translation>Recalculer la piste réaliste et la piste aléatoire</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Predicting the excursion</source>
        <translation>Prévision de l’excursion</translation>
    </message>
    <message>
        <source>The sequence was rendered again</source>
        <translation>La force de la séquence a été recalculée</translation>
    </message>
    <message>
        <source>{title} ({rendering})</source>
        <translation>{title} ({rendering})</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Nouvelle séquence</translation>
    </message>
    <message>
        <source>New sequence: {folder}</source>
        <translation>Nouvelle séquence&#xa0;: {folder}</translation>
    </message>
    <message>
        <source>Rendering the force</source>
        <translation>Calcul de la force</translation>
    </message>
</context>
<context>
    <name>RenderingPicture</name>
    <message>
        <source>Force and predicted excursion: {before}, {after}</source>
        <translation>Force et excursion prévue&#xa0;: {before}, {after}</translation>
    </message>
    <message>
        <source>Excursion from the centre: beyond {far} mm outward force is reduced, at {end} mm the workspace ends</source>
        <translation>Excursion depuis le centre&#xa0;: au-delà de {far} mm la force vers l’extérieur est affaiblie, à {end} mm l’espace de travail se termine</translation>
    </message>
    <message>
        <source>Force to the right, N</source>
        <translation>Force vers la droite, N</translation>
    </message>
    <message>
        <source>Force up, N</source>
        <translation>Force vers le haut, N</translation>
    </message>
    <message>
        <source>Force towards the user, N</source>
        <translation>Force vers l’utilisateur, N</translation>
    </message>
    <message>
        <source>Excursion of a relaxed hand, mm</source>
        <translation>Excursion d’une main détendue, mm</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
</context>
<context>
    <name>ReportPage</name>
    <message>
        <source>Report a problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>Le rapport</translation>
    </message>
    <message>
        <source>What did you do, what happened, what did you expect?</source>
        <translation>Qu’avez-vous fait, que s’est-il passé, qu’attendiez-vous&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Enregistrer…</translation>
    </message>
    <message>
        <source>Save the report as a zip file</source>
        <translation>Enregistrer le rapport dans un fichier zip</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>This is all that the report holds: no names of your files or folders, nothing of your recordings. It is saved on this computer; nothing is sent.</source>
        <translation>C’est tout ce que contient le rapport&#xa0;: aucun nom de vos fichiers ou dossiers, rien de vos enregistrements. Il est enregistré sur cet ordinateur&#xa0;; rien n’est envoyé.</translation>
    </message>
    <message>
        <source>Your &amp;words</source>
        <translation>Vos &amp;mots</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Fichiers zip (*.zip)</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Enregistré&#xa0;: {name}</translation>
    </message>
</context>
<context>
    <name>RigPanel</name>
    <message>
        <source>Listening on this computer at the ports {ports}. Play on this rig, or let a game send its telemetry here.</source>
        <translation>À l’écoute sur cet ordinateur aux ports {ports}. Lisez sur cette plateforme, ou laissez un jeu envoyer sa télémétrie ici.</translation>
    </message>
    <message>
        <source>Not listening</source>
        <translation>Pas à l’écoute</translation>
    </message>
    <message>
        <source>No data received yet</source>
        <translation>Aucune donnée reçue pour l’instant</translation>
    </message>
    <message>
        <source>{format}: out of reach, {share:.0%} of it is done</source>
        <translation>{format}&#xa0;: hors de portée, {share:.0%} exécutés</translation>
    </message>
    <message>
        <source>{format}: followed</source>
        <translation>{format}&#xa0;: suivi</translation>
    </message>
    <message>
        <source>Simulated motion rig</source>
        <translation>Plateforme de mouvement simulée</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Stop listening</source>
        <translation>Ne plus écouter</translation>
    </message>
    <message>
        <source>&amp;Play on this rig</source>
        <translation>&amp;Lire sur cette plateforme</translation>
    </message>
    <message>
        <source>Add it to the outputs</source>
        <translation>L’ajouter aux sorties</translation>
    </message>
</context>
<context>
    <name>ScoreFields</name>
    <message>
        <source>Meaning (English)</source>
        <translation>Signification (en anglais)</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Composé de</translation>
    </message>
    <message>
        <source>Names of questions of the page, or of scores before it</source>
        <translation>Noms de questions de la page, ou de scores qui le précèdent</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Somme</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Computed as</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Inversées</translation>
    </message>
    <message>
        <source>Those that count from the other end of their range</source>
        <translation>Celles qui comptent depuis l’autre bout de leur plage</translation>
    </message>
    <message>
        <source>Factors of 1, x, x² …</source>
        <translation>Coefficients de 1, x, x² …</translation>
    </message>
    <message>
        <source>0, 2.5 multiplies the sum or mean by 2.5</source>
        <translation>0, 2.5 multiplie la somme ou la moyenne par 2,5</translation>
    </message>
    <message>
        <source>Least answers to a mean</source>
        <translation>Réponses requises pour la moyenne</translation>
    </message>
    <message>
        <source>All are needed where this is empty</source>
        <translation>Si ce champ est vide, toutes sont nécessaires</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Nom dans les données</translation>
    </message>
</context>
<context>
    <name>SequenceList</name>
    <message>
        <source>Add from the library…</source>
        <translation>Ajouter depuis la bibliothèque…</translation>
    </message>
    <message>
        <source>Choose one or several</source>
        <translation>En choisir une ou plusieurs</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>no recording yet</source>
        <translation>pas encore d’enregistrement</translation>
    </message>
    <message>
        <source>Choose a recording…</source>
        <translation>Choisir un enregistrement…</translation>
    </message>
    <message>
        <source>Choose from the library</source>
        <translation>Choisir dans la bibliothèque</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Nom dans les données</translation>
    </message>
    <message>
        <source>In data and figures: a to z, 0 to 9, _ and -</source>
        <translation>Dans les données et les figures&#xa0;: a à z, 0 à 9, _ et -</translation>
    </message>
    <message>
        <source>What sequences differ in, such as viewpoint = first here and viewpoint = third in others; the analysis compares feedbacks at each level</source>
        <translation>Ce qui distingue les séquences, par exemple viewpoint = first ici et viewpoint = third dans d’autres&#xa0;; l’analyse compare les retours à chaque niveau</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Facteurs</translation>
    </message>
    <message>
        <source>Titles are for you and for figures; participants never see them.</source>
        <translation>Les titres sont pour vous et pour les figures&#xa0;; les participants ne les voient jamais.</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Aucun pour l’instant</translation>
    </message>
    <message>
        <source>another sequence</source>
        <translation>autre séquence</translation>
    </message>
    <message>
        <source>another recording</source>
        <translation>autre enregistrement</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>Opening {name}</source>
        <translation>Ouverture de {name}</translation>
    </message>
    <message>
        <source>Making the force</source>
        <translation>Calcul de la force</translation>
    </message>
    <message>
        <source>Another task is running; wait for it or cancel it</source>
        <translation>Une autre tâche est en cours&#xa0;; attendez ou annulez-la</translation>
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
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Skip…</source>
        <translation>Passer…</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Terminer…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
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
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Terminer la séance</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Write a note; Enter saves it</source>
        <translation>Écrire une note&#xa0;; Entrée l’enregistre</translation>
    </message>
    <message>
        <source>Pause the clip; it will restart from the beginning</source>
        <translation>Mettre le clip en pause&#xa0;; il reprendra du début</translation>
    </message>
    <message>
        <source>Repeat the last trial</source>
        <translation>Répéter le dernier essai</translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation>Passer cette étape</translation>
    </message>
    <message>
        <source>End the session; it cannot be resumed</source>
        <translation>Terminer la séance&#xa0;; elle ne pourra pas être reprise</translation>
    </message>
    <message>
        <source>Participant&apos;s page</source>
        <translation>Page du participant</translation>
    </message>
    <message>
        <source>Show the participant&apos;s page over this panel</source>
        <translation>Montrer la page du participant par-dessus ce panneau</translation>
    </message>
    <message>
        <source>Sessions and data</source>
        <translation>Séances et données</translation>
    </message>
    <message>
        <source>Show what came of this session and those before</source>
        <translation>Afficher les résultats de cette séance et des précédentes</translation>
    </message>
    <message>
        <source>Close the session</source>
        <translation>Fermer la séance</translation>
    </message>
    <message>
        <source>Retry saving</source>
        <translation>Réessayer d’enregistrer</translation>
    </message>
    <message>
        <source>Stop the force (Esc)</source>
        <translation>Couper la force (Échap)</translation>
    </message>
    <message>
        <source>Volume {n} %, fixed for the session</source>
        <translation>Volume {n}&#xa0;%, fixe pour la séance</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Invalid trials: {k} of {n}</source>
        <translation>Essais non valides&#xa0;: {k} sur {n}</translation>
    </message>
    <message>
        <source>{reason} (trial {numbers})</source>
        <translation>{reason} (essai {numbers})</translation>
    </message>
    <message>
        <source>No trial played yet</source>
        <translation>Aucun essai joué</translation>
    </message>
    <message>
        <source>The last trial was valid</source>
        <translation>Le dernier essai est valide</translation>
    </message>
    <message>
        <source>The last trial was invalid: {reasons}</source>
        <translation>Le dernier essai n’est pas valide&#xa0;: {reasons}</translation>
    </message>
    <message>
        <source>Reason for skipping this step:</source>
        <translation>Raison de passer cette étape&#xa0;:</translation>
    </message>
    <message>
        <source>Nothing was skipped: the participant has gone on to another step meanwhile. To skip this one, press Skip again.</source>
        <translation>Rien n’a été passé&#xa0;: entre-temps, le participant est allé à une autre étape. Pour passer celle-ci, cliquez de nouveau sur «&#xa0;Passer&#xa0;».</translation>
    </message>
    <message>
        <source>Reason for ending the session (all answers so far are kept):</source>
        <translation>Raison de terminer la séance (toutes les réponses sont conservées)&#xa0;:</translation>
    </message>
    <message>
        <source>The session is not complete. Close it and resume later?</source>
        <translation>La séance n’est pas terminée. Fermer et reprendre plus tard&#xa0;?</translation>
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
        <source>between two clips</source>
        <translation>entre deux clips</translation>
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
        <source>saving failed</source>
        <translation>échec de l’enregistrement</translation>
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
    <name>SessionOutputs</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Let the session play on this device</source>
        <translation>Faire jouer la séance sur cet appareil</translation>
    </message>
    <message>
        <source>No device: participants feel nothing</source>
        <translation>Aucun appareil&#xa0;: les participants ne sentent rien</translation>
    </message>
    <message>
        <source>Remove this device</source>
        <translation>Retirer cet appareil</translation>
    </message>
    <message>
        <source>Remove {device}</source>
        <translation>Retirer {device}</translation>
    </message>
    <message>
        <source>This device is already in use</source>
        <translation>Cet appareil est déjà utilisé</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>to be repeated</source>
        <translation>à répéter</translation>
    </message>
    <message>
        <source>safety stop ({0})</source>
        <translation>arrêt de sécurité ({0})</translation>
    </message>
    <message>
        <source>an output did not play ({0})</source>
        <translation>une sortie n’a pas joué ({0})</translation>
    </message>
    <message>
        <source>{0} reached its limit</source>
        <translation>{0} a atteint sa limite</translation>
    </message>
    <message>
        <source>force and video out of sync</source>
        <translation>force et vidéo désynchronisées</translation>
    </message>
    <message>
        <source>force and sound out of sync</source>
        <translation>force et son désynchronisés</translation>
    </message>
    <message>
        <source>ratings could not be saved</source>
        <translation>les évaluations n’ont pas pu être enregistrées</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>passé</translation>
    </message>
    <message>
        <source>session ended</source>
        <translation>séance terminée</translation>
    </message>
    <message>
        <source>the force was stopped</source>
        <translation>la force a été coupée</translation>
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
        <source>another window took the focus</source>
        <translation>une autre fenêtre a pris le focus</translation>
    </message>
    <message>
        <source>the window was closed</source>
        <translation>la fenêtre a été fermée</translation>
    </message>
    <message>
        <source>frames dropped</source>
        <translation>images sautées</translation>
    </message>
    <message>
        <source>no sound</source>
        <translation>pas de son</translation>
    </message>
    <message>
        <source>gaps in the sound</source>
        <translation>lacunes dans le son</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>aucun appareil</translation>
    </message>
    <message>
        <source>device lost</source>
        <translation>appareil perdu</translation>
    </message>
    <message>
        <source>missed periods in the haptic loop</source>
        <translation>périodes manquées de la boucle haptique</translation>
    </message>
    <message>
        <source>no data from the device</source>
        <translation>pas de données de l’appareil</translation>
    </message>
    <message>
        <source>gaps in the record</source>
        <translation>lacunes dans l’enregistrement</translation>
    </message>
    <message>
        <source>the clip is damaged</source>
        <translation>le clip est endommagé</translation>
    </message>
</context>
<context>
    <name>SetupPage</name>
    <message>
        <source>Firmware file…</source>
        <translation>Micrologiciel…</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>Utiliser cet appareil</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Install your copy of the firmware</source>
        <translation>Installer votre copie du micrologiciel</translation>
    </message>
    <message>
        <source>Try out the forces…</source>
        <translation>Essayer les forces…</translation>
    </message>
    <message>
        <source>Feel every direction, starting gently</source>
        <translation>Sentir chaque direction, doucement d’abord</translation>
    </message>
    <message>
        <source>Use it for playback</source>
        <translation>L’utiliser pour la lecture</translation>
    </message>
    <message>
        <source>Play on several devices at once</source>
        <translation>Jouer sur plusieurs appareils à la fois</translation>
    </message>
    <message>
        <source>Outputs…</source>
        <translation>Sorties…</translation>
    </message>
    <message>
        <source>Keep the current device</source>
        <translation>Garder l’appareil actuel</translation>
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
        <source>Test</source>
        <translation>Tester</translation>
    </message>
    <message>
        <source>Looking for the device</source>
        <translation>Recherche de l’appareil</translation>
    </message>
    <message>
        <source>Not ready yet</source>
        <translation>Pas encore prêt</translation>
    </message>
    <message>
        <source>No setup needed</source>
        <translation>Aucune configuration nécessaire</translation>
    </message>
    <message>
        <source>Ready to be tested</source>
        <translation>Prêt à être testé</translation>
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
        <source>Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and plug it in.</source>
        <translation>Copiez la règle udev {rule} dans /etc/udev/rules.d, puis débranchez et rebranchez le Falcon.</translation>
    </message>
    <message>
        <source>The Falcon has the wrong driver</source>
        <translation>Le Falcon a un mauvais pilote</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware</source>
        <translation>Le Falcon a besoin de son micrologiciel</translation>
    </message>
    <message>
        <source>Connect its USB cable and power supply; it is detected automatically.</source>
        <translation>Branchez le câble USB et l’alimentation&#xa0;; il est détecté automatiquement.</translation>
    </message>
    <message>
        <source>Permission denied for the Falcon</source>
        <translation>Accès au Falcon refusé</translation>
    </message>
    <message>
        <source>The Falcon is in use by another program</source>
        <translation>Le Falcon est utilisé par un autre programme</translation>
    </message>
    <message>
        <source>Close that program; setup then continues automatically.</source>
        <translation>Fermez ce programme&#xa0;; la suite est automatique.</translation>
    </message>
    <message>
        <source>Replace FTDI&apos;s or Force Dimension&apos;s driver by WinUSB, using Zadig; then unplug it and plug it in again.</source>
        <translation>Remplacez le pilote de FTDI ou de Force Dimension par WinUSB, avec Zadig&#xa0;; débranchez-le puis rebranchez-le.</translation>
    </message>
    <message>
        <source>It belongs to Novint and cannot be distributed with this program. Take nvent_firmware.bin from a libnifalcon source archive and choose the file here, once.</source>
        <translation>Il appartient à Novint et ne peut être distribué avec ce programme. Prenez nvent_firmware.bin dans une archive source de libnifalcon et choisissez ce fichier ici, une seule fois.</translation>
    </message>
    <message>
        <source>Pull the grip all the way out</source>
        <translation>Tirez la poignée à fond</translation>
    </message>
    <message>
        <source>Push the grip in until it locks</source>
        <translation>Poussez la poignée jusqu’au verrouillage</translation>
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
        <source>Move the grip: the drawing follows.</source>
        <translation>Bougez la poignée&#xa0;: le dessin suit.</translation>
    </message>
    <message>
        <source>Homed joints: {legs}. The force is off.</source>
        <translation>Articulations repérées&#xa0;: {legs}. La force est coupée.</translation>
    </message>
    <message>
        <source>The Falcon&apos;s firmware belongs to Novint Technologies. libnifalcon distributes it under Novint&apos;s SDK licence (its file license/LICENSE_NOVINT.txt): free of charge for personal, noncommercial use, binding for every recipient. Read that licence; by continuing you confirm that you may use this file. It stays on this computer.</source>
        <translation>Le micrologiciel du Falcon appartient à Novint Technologies. libnifalcon le distribue sous la licence SDK de Novint (fichier license/LICENSE_NOVINT.txt)&#xa0;: gratuit pour un usage personnel et non commercial, et tout destinataire y est lié. Lisez cette licence&#xa0;; en continuant, vous confirmez avoir le droit d’utiliser ce fichier. Il reste sur cet ordinateur.</translation>
    </message>
    <message>
        <source>The file is intact but is not a known firmware image. It would drive the motors. Install it only if you trust its source.</source>
        <translation>Le fichier est intact mais n’est pas un micrologiciel connu. Il piloterait les moteurs. Ne l’installez que si sa source est sûre.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aucune encore</translation>
    </message>
</context>
<context>
    <name>SharePage</name>
    <message>
        <source>Share</source>
        <translation>Partager</translation>
    </message>
    <message>
        <source>&amp;One file (MKV)</source>
        <translation>&amp;Un seul fichier (MKV)</translation>
    </message>
    <message>
        <source>M&amp;P4, with a second file for the force</source>
        <translation>M&amp;P4, avec un second fichier pour la force</translation>
    </message>
    <message>
        <source>A video file to send: every player shows it, hapticplayer also plays the force.</source>
        <translation>Un fichier vidéo à envoyer&#xa0;: tous les lecteurs l’affichent, hapticplayer joue aussi la force.</translation>
    </message>
    <message>
        <source>Others can then render another force from it</source>
        <translation>D’autres peuvent alors en calculer une autre force</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Include &amp;motion and recorded samples</source>
        <translation>Inclure le &amp;mouvement et les échantillons enregistrés</translation>
    </message>
    <message>
        <source>Include &amp;names, dates and places</source>
        <translation>Inclure les &amp;noms, dates et lieux</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>Cancel; nothing is kept</source>
        <translation>Annuler&#xa0;; rien n’est conservé</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Enregistrer…</translation>
    </message>
    <message>
        <source>Choose a name, and write it</source>
        <translation>Choisir un nom et écrire le fichier</translation>
    </message>
    <message>
        <source>included</source>
        <translation>inclus</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omis</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Saved: {names}, {size}</source>
        <translation>Enregistré&#xa0;: {names}, {size}</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>What is shared</source>
        <translation>Ce qui est partagé</translation>
    </message>
    <message>
        <source>Matroska video (*.mkv)</source>
        <translation>Vidéo Matroska (*.mkv)</translation>
    </message>
    <message>
        <source>MP4 video (*.mp4)</source>
        <translation>Vidéo MP4 (*.mp4)</translation>
    </message>
    <message>
        <source>Share as</source>
        <translation>Partager sous</translation>
    </message>
    <message>
        <source>Sharing</source>
        <translation>Partage</translation>
    </message>
    <message>
        <source>{number} kB</source>
        <translation>{number} ko</translation>
    </message>
    <message>
        <source>{number} MB</source>
        <translation>{number} Mo</translation>
    </message>
</context>
<context>
    <name>Sides</name>
    <message>
        <source>Synchronise by the tap marks alone</source>
        <translation>Synchroniser d’après les tapotements seuls</translation>
    </message>
    <message>
        <source>Synchronise by the frames alone</source>
        <translation>Synchroniser d’après les images seules</translation>
    </message>
    <message>
        <source>Use the taps</source>
        <translation>Prendre les tapotements</translation>
    </message>
    <message>
        <source>Use the frames</source>
        <translation>Prendre les images</translation>
    </message>
</context>
<context>
    <name>SpokenNumber</name>
    <message>
        <source>The number that was said</source>
        <translation>Le nombre qui a été dit</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Valider</translation>
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
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Play a clip</source>
        <translation>Jouer un clip</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Resume {code}</source>
        <translation>Reprendre {code}</translation>
    </message>
    <message>
        <source>Check that the sound is audible</source>
        <translation>Vérifier que le son est audible</translation>
    </message>
    <message>
        <source>Fixed for the whole session and stored with it</source>
        <translation>Fixe pour toute la séance et enregistré avec elle</translation>
    </message>
    <message>
        <source>The sound is audible</source>
        <translation>Le son est audible</translation>
    </message>
    <message>
        <source>Start despite failed checks</source>
        <translation>Commencer malgré les contrôles en échec</translation>
    </message>
    <message>
        <source>Show the first page to the participant</source>
        <translation>Montrer la première page au participant</translation>
    </message>
    <message>
        <source>Start session</source>
        <translation>Démarrer la séance</translation>
    </message>
    <message>
        <source>Motion sensor of the demonstration</source>
        <translation>Capteur de mouvement de la démonstration</translation>
    </message>
    <message>
        <source>none; or what you move is felt, such as wt901:/dev/ttyUSB0</source>
        <translation>aucun&#xa0;; sinon, ce que vous bougez est ressenti, par exemple wt901:/dev/ttyUSB0</translation>
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
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Démonstration</translation>
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
        <source>There is one screen: from the start, the participant&apos;s page covers this panel. {keys} brings the panel back and pauses; participants are not told.</source>
        <translation>Il n’y a qu’un écran&#xa0;: dès le début, la page du participant recouvre ce panneau. {keys} le fait revenir et met en pause&#xa0;; les participants n’en sont pas informés.</translation>
    </message>
    <message>
        <source>this is the first participant</source>
        <translation>c’est le premier participant</translation>
    </message>
    <message>
        <source>each condition {a} to {b} times at each position, {c} to {d} times after each other condition</source>
        <translation>chaque condition {a} à {b} fois à chaque position, {c} à {d} fois après chaque autre</translation>
    </message>
    <message>
        <source>Grip homed</source>
        <translation>Poignée repérée</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Ordonnancement</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Participant&apos;s screen</source>
        <translation>Écran du participant</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disque</translation>
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
        <translation>Ordonnancement</translation>
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
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Lateness, µs</source>
        <translation>Retard, µs</translation>
    </message>
    <message>
        <source>Force − video, ms</source>
        <translation>Force − vidéo, ms</translation>
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
        <source>video {0:.0f}  sound {1:.0f}  force {2:.0f}  reported {3:.0f}</source>
        <translation>vidéo {0:.0f}  son {1:.0f}  force {2:.0f}  annoncé {3:.0f}</translation>
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
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>During clips</source>
        <translation>Pendant les clips</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Annuler (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z)</source>
        <translation>Rétablir (Ctrl+Maj+Z)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Enregistrement…</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Non enregistrée</translation>
    </message>
    <message>
        <source>Saved as a draft until the problems are solved</source>
        <translation>Enregistrée comme brouillon jusqu’à la résolution des problèmes</translation>
    </message>
    <message>
        <source>Saved; not ready for participants yet</source>
        <translation>Enregistrée&#xa0;; pas encore prête pour des participants</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Enregistrée</translation>
    </message>
    <message>
        <source>Changes that were not complete were restored. Undo goes back to the last complete study.</source>
        <translation>Des modifications incomplètes ont été restaurées. Annuler revient à la dernière étude complète.</translation>
    </message>
    <message>
        <source>restored changes</source>
        <translation>modifications restaurées</translation>
    </message>
    <message>
        <source>Not saved: close again to lose the changes</source>
        <translation>Non enregistrée&#xa0;: fermez de nouveau pour perdre les modifications</translation>
    </message>
    <message>
        <source>{trials} trials for each participant, about {minutes} minutes</source>
        <translation>{trials} essais par participant, environ {minutes} minutes</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
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
        <translation>modification&#xa0;: {what}</translation>
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
        <source>&amp;Sessions and data…</source>
        <translation>Séances et &amp;données…</translation>
    </message>
    <message>
        <source>&amp;Analyse study…</source>
        <translation>&amp;Analyser une étude…</translation>
    </message>
    <message>
        <source>Opening the session…</source>
        <translation>Ouverture de la séance…</translation>
    </message>
    <message>
        <source>Run a participant</source>
        <translation>Faire passer un participant</translation>
    </message>
    <message>
        <source>Study folder</source>
        <translation>Dossier d’étude</translation>
    </message>
</context>
<context>
    <name>StudyProcess</name>
    <message>
        <source>The session has ended with status {0}</source>
        <translation>La séance s’est terminée avec l’état {0}</translation>
    </message>
</context>
<context>
    <name>StudyResults</name>
    <message>
        <source>Sessions – {title}</source>
        <translation>Séances – {title}</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Séances</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>Non valides</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Text answers</source>
        <translation>Réponses en texte libre</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Terminer…</translation>
    </message>
    <message>
        <source>End a session that will not be resumed; its order is free again</source>
        <translation>Terminer une séance qui ne sera pas reprise&#xa0;; son ordre redevient libre</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Supprimer…</translation>
    </message>
    <message>
        <source>Delete a participant; says first what is erased</source>
        <translation>Supprimer un participant&#xa0;; dit d’abord ce qui est effacé</translation>
    </message>
    <message>
        <source>Pack…</source>
        <translation>Empaqueter…</translation>
    </message>
    <message>
        <source>Write a copy with all sequences, for other sites to run</source>
        <translation>Écrire une copie avec toutes les séquences, pour mener l’étude sur d’autres sites</translation>
    </message>
    <message>
        <source>Merge…</source>
        <translation>Fusionner…</translation>
    </message>
    <message>
        <source>Packed to {folder}. Sites can compare the checksum of what they got (SHA-256 of the manifest): {checksum}</source>
        <translation>Empaqueté dans {folder}. Les sites peuvent comparer la somme de contrôle de ce qu’ils ont reçu (SHA-256 du manifeste)&#xa0;: {checksum}</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Empaquetage</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Write the data for other programs</source>
        <translation>Écrire les données pour d’autres programmes</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Analyser</translation>
    </message>
    <message>
        <source>Statistics and report</source>
        <translation>Statistiques et rapport</translation>
    </message>
    <message>
        <source>Approve for export</source>
        <translation>Approuver pour l’export</translation>
    </message>
    <message>
        <source>The selected answers identify no one</source>
        <translation>Les réponses sélectionnées n’identifient personne</translation>
    </message>
    <message>
        <source>Answers in words may name a person. Read them; only those that you approve are exported.</source>
        <translation>Les réponses en texte libre peuvent nommer une personne. Lisez-les&#xa0;; seules celles que vous approuvez sont exportées.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Add the sessions of copies of this study on other machines</source>
        <translation>Ajouter les séances de copies de cette étude sur d’autres ordinateurs</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Nobody has taken part yet: Study &gt; Run a participant.</source>
        <translation>Personne n’a encore participé&#xa0;: Étude &gt; Faire passer un participant.</translation>
    </message>
    <message>
        <source>Sessions: {count}, complete: {done}, deleted: {deleted}</source>
        <translation>Séances&#xa0;: {count}, complètes&#xa0;: {done}, supprimées&#xa0;: {deleted}</translation>
    </message>
    <message>
        <source>Trial {n} ({condition}) is invalid: {reasons}</source>
        <translation>L’essai {n} ({condition}) n’est pas valide&#xa0;: {reasons}</translation>
    </message>
    <message>
        <source>Resumed: {n} times</source>
        <translation>Reprise&#xa0;: {n} fois</translation>
    </message>
    <message>
        <source>Damaged records: {n}</source>
        <translation>Enregistrements endommagés&#xa0;: {n}</translation>
    </message>
    <message>
        <source>All answers in words are approved.</source>
        <translation>Toutes les réponses en texte libre sont approuvées.</translation>
    </message>
    <message>
        <source>No answers in words yet.</source>
        <translation>Pas encore de réponses en texte libre.</translation>
    </message>
    <message>
        <source>trial {n}</source>
        <translation>essai {n}</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Terminer la séance</translation>
    </message>
    <message>
        <source>Reason for ending the session (all answers so far are kept):</source>
        <translation>Raison de terminer la séance (toutes les réponses sont conservées)&#xa0;:</translation>
    </message>
    <message>
        <source>Deleting</source>
        <translation>Suppression</translation>
    </message>
    <message>
        <source>Delete participant {code}? Answers to {answered} trials, the records of the device and the consent are erased ({count} files, {size}) and cannot be restored. That somebody was deleted stays, without the code. Exports and reports outside of the study are yours to delete.</source>
        <translation>Supprimer le participant {code}&#xa0;? Les réponses à {answered} essais, les enregistrements de l’appareil et le consentement sont effacés ({count} fichiers, {size}) et ne peuvent pas être restaurés. Qu’une personne a été supprimée reste noté, sans le code. C’est à vous de supprimer les exports et les rapports en dehors de l’étude.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>The participant was deleted.</source>
        <translation>Le participant a été supprimé.</translation>
    </message>
    <message>
        <source>Still named in: {files}. Write these again or remove them.</source>
        <translation>Encore nommé dans&#xa0;: {files}. Écrivez ces fichiers de nouveau, ou supprimez-les.</translation>
    </message>
    <message>
        <source>Exported to {folder}.</source>
        <translation>Exporté dans {folder}.</translation>
    </message>
    <message>
        <source>Exporting the data</source>
        <translation>Exportation des données</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>complète</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>non terminée</translation>
    </message>
    <message>
        <source>ended early</source>
        <translation>terminée avant la fin</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulée</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>After each clip</source>
        <translation>Après chaque clip</translation>
    </message>
    <message>
        <source>Before the first clip</source>
        <translation>Avant le premier clip</translation>
    </message>
    <message>
        <source>After the last clip</source>
        <translation>Après le dernier clip</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Consentement</translation>
    </message>
    <message>
        <source>Information about the device</source>
        <translation>Informations sur l’appareil</translation>
    </message>
    <message>
        <source>Before each clip</source>
        <translation>Avant chaque clip</translation>
    </message>
    <message>
        <source>Closing words</source>
        <translation>Mot de la fin</translation>
    </message>
    <message>
        <source>How long data are kept</source>
        <translation>Durée de conservation des données</translation>
    </message>
    <message>
        <source>Button: agree to take part</source>
        <translation>Bouton&#xa0;: accepter de participer</translation>
    </message>
    <message>
        <source>Button: decline to take part</source>
        <translation>Bouton&#xa0;: refuser de participer</translation>
    </message>
    <message>
        <source>Button: next page</source>
        <translation>Bouton&#xa0;: page suivante</translation>
    </message>
    <message>
        <source>Button: start the clip</source>
        <translation>Bouton&#xa0;: démarrer le clip</translation>
    </message>
    <message>
        <source>Button: feel the device</source>
        <translation>Bouton&#xa0;: sentir l’appareil</translation>
    </message>
    <message>
        <source>Answer: yes</source>
        <translation>Réponse&#xa0;: oui</translation>
    </message>
    <message>
        <source>Answer: no</source>
        <translation>Réponse&#xa0;: non</translation>
    </message>
    <message>
        <source>Name of a feedback, before its number</source>
        <translation>Nom d’un retour haptique, avant son numéro</translation>
    </message>
    <message>
        <source>Name of a clip, before its number</source>
        <translation>Nom d’un clip, avant son numéro</translation>
    </message>
    <message>
        <source>Mark of a question that may stay open</source>
        <translation>Marque d’une question qui peut rester sans réponse</translation>
    </message>
    <message>
        <source>Message: a question is not answered</source>
        <translation>Message&#xa0;: une question est sans réponse</translation>
    </message>
    <message>
        <source>Message: bring the grip to the centre</source>
        <translation>Message&#xa0;: ramener la poignée au centre</translation>
    </message>
    <message>
        <source>Page: paused</source>
        <translation>Page&#xa0;: en pause</translation>
    </message>
    <message>
        <source>Button: resume</source>
        <translation>Bouton&#xa0;: reprendre</translation>
    </message>
    <message>
        <source>Button: end early</source>
        <translation>Bouton&#xa0;: terminer avant la fin</translation>
    </message>
    <message>
        <source>Page: ended early</source>
        <translation>Page&#xa0;: terminé avant la fin</translation>
    </message>
    <message>
        <source>Page: answers cannot be saved</source>
        <translation>Page&#xa0;: les réponses ne peuvent pas être enregistrées</translation>
    </message>
    <message>
        <source>Label of {n}</source>
        <translation>Libellé de {n}</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Page {n}</source>
        <translation>Page {n}</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Buttons and messages</source>
        <translation>Boutons et messages</translation>
    </message>
    <message>
        <source>During clips</source>
        <translation>Pendant les clips</translation>
    </message>
    <message>
        <source>Least time between two clips</source>
        <translation>Temps minimal entre deux clips</translation>
    </message>
    <message>
        <source>A trial is marked as invalid above</source>
        <translation>Un essai est marqué comme non valide au-delà de</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Facteurs</translation>
    </message>
    <message>
        <source>Help line</source>
        <translation>Ligne d’aide</translation>
    </message>
    <message>
        <source>Unit in the data</source>
        <translation>Unité dans les données</translation>
    </message>
    <message>
        <source>Labels of points</source>
        <translation>Libellés des points</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Part of the sum QoE</source>
        <translation>Fait partie de la somme QoE</translation>
    </message>
    <message>
        <source>Scores</source>
        <translation>Scores</translation>
    </message>
    <message>
        <source>Questions of a score</source>
        <translation>Questions d’un score</translation>
    </message>
    <message>
        <source>Counts as</source>
        <translation>Compte pour</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Déplacé par</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>Asked for every</source>
        <translation>Demandé toutes les</translation>
    </message>
    <message>
        <source>Ends clip and force from</source>
        <translation>Arrête clip et force à partir de</translation>
    </message>
    <message>
        <source>Text of the break after that</source>
        <translation>Texte de la pause qui suit</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Langues</translation>
    </message>
    <message>
        <source>Published wording</source>
        <translation>Formulation publiée</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Name in the data</source>
        <translation>Nom dans les données</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Wording</source>
        <translation>Formulation</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Smallest number</source>
        <translation>Plus petit nombre</translation>
    </message>
    <message>
        <source>Largest number or length</source>
        <translation>Plus grand nombre ou longueur maximale</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
</context>
<context>
    <name>SuggestionBox</name>
    <message>
        <source>S&amp;uggest motion from the frames (estimate)</source>
        <translation>S&amp;uggérer le mouvement d’après les images (estimation)</translation>
    </message>
    <message>
        <source>Expect to feel turns of a vehicle, and steps when walking or riding; braking, knocks and potholes will be missing. Nothing measures this motion: set its strength by hand with the gain, and do not use it in a study without saying so. Slow motion and time lapse are taken as they play.</source>
        <translation>Vous sentirez les virages d’un véhicule et les pas à pied ou à cheval&#xa0;; freinages, chocs et nids-de-poule manqueront. Rien ne mesure ce mouvement&#xa0;: réglez sa force à la main avec le gain, et ne l’utilisez pas dans une étude sans le dire. Le ralenti et l’accéléré sont pris tels qu’ils sont lus.</translation>
    </message>
    <message>
        <source>This needs OpenCV: see Help &gt; System check.</source>
        <translation>Cela nécessite OpenCV&#xa0;: voir Aide &gt; Vérification du système.</translation>
    </message>
    <message>
        <source>Choose its motion log above, if there is one.</source>
        <translation>Choisissez ci-dessus son journal de mouvement, s’il existe.</translation>
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
        <source>Sound delay</source>
        <translation>Retard du son</translation>
    </message>
    <message>
        <source>How much later than the video the camera records its sound</source>
        <translation>De combien le son de la caméra retarde sur la vidéo</translation>
    </message>
    <message>
        <source>use for this camera</source>
        <translation>pour cette caméra</translation>
    </message>
    <message>
        <source>I have checked the offset by eye and ear</source>
        <translation>Décalage vérifié à l’œil et à l’oreille</translation>
    </message>
    <message>
        <source>&amp;Listen</source>
        <translation>É&amp;couter</translation>
    </message>
    <message>
        <source>Play the visible part: the clip on the left, a tick at each tap of the log on the right</source>
        <translation>Lire la partie visible&#xa0;: le clip à gauche, un tic à chaque tapotement du journal à droite</translation>
    </message>
    <message>
        <source>S&amp;ound delay</source>
        <translation>Retard du s&amp;on</translation>
    </message>
    <message>
        <source>{recorder} records its motion on the clip&apos;s clock; no synchronisation is needed.</source>
        <translation>{recorder} enregistre son mouvement sur l’horloge du clip&#xa0;; aucune synchronisation n’est nécessaire.</translation>
    </message>
    <message>
        <source>Could not synchronise: {why}. Enter the offset manually.</source>
        <translation>Synchronisation impossible&#xa0;: {why}. Saisissez le décalage à la main.</translation>
    </message>
    <message>
        <source>The offset was set manually.</source>
        <translation>Le décalage a été réglé à la main.</translation>
    </message>
    <message>
        <source>The tap marks and the frames disagree ({method}: {offset} s, {other}: {other_offset} s). Check which is right.</source>
        <translation>Les tapotements et les images se contredisent ({method}&#xa0;: {offset} s, {other}&#xa0;: {other_offset} s). Vérifiez ce qui est juste.</translation>
    </message>
    <message>
        <source>Synchronised: {method} (confidence {confidence}).</source>
        <translation>Synchronisé&#xa0;: {method} (confiance {confidence}).</translation>
    </message>
    <message>
        <source>Tap marks found (confidence {confidence}, residual {ms} ms).</source>
        <translation>Tapotements trouvés (confiance {confidence}, résidu {ms} ms).</translation>
    </message>
    <message>
        <source>The tap marks are uncertain (confidence {confidence}). Check that the same events line up, and drag them if not.</source>
        <translation>Les tapotements sont incertains (confiance {confidence}). Vérifiez que les mêmes événements sont alignés, sinon faites-les glisser.</translation>
    </message>
    <message>
        <source>No three taps found in both sound and motion; drag manually.</source>
        <translation>Pas de trois tapotements à la fois dans le son et le mouvement&#xa0;; alignez à la main.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>Slow motion</source>
        <translation>Ralenti</translation>
    </message>
    <message>
        <source>How many times slower than it was recorded the video plays: 8 if 240 frames per second play at 30; below 1 for a time lapse</source>
        <translation>Combien de fois la vidéo est plus lente que la prise de vue&#xa0;: 8 si 240 images par seconde sont lues à 30&#xa0;; moins de 1 pour un accéléré</translation>
    </message>
    <message>
        <source>Clock drift</source>
        <translation>Dérive de l’horloge</translation>
    </message>
    <message>
        <source> ppm</source>
        <translation> ppm</translation>
    </message>
    <message>
        <source>By how much faster the video runs than the log&apos;s clock</source>
        <translation>De combien la vidéo va plus vite que l’horloge du journal</translation>
    </message>
    <message>
        <source>Sound delay of a camera</source>
        <translation>Retard du son d’une caméra</translation>
    </message>
    <message>
        <source>The sound delay that is kept for a camera</source>
        <translation>Le retard du son enregistré pour une caméra</translation>
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
        <source>&amp;Close-up</source>
        <translation>&amp;Gros plan</translation>
    </message>
    <message>
        <source>Zoom to the tap marks, or to where the camera turned most</source>
        <translation>Zoomer sur les tapotements, ou là où la caméra tourne le plus</translation>
    </message>
    <message>
        <source>&amp;Offset</source>
        <translation>&amp;Décalage</translation>
    </message>
    <message>
        <source>Clock &amp;drift</source>
        <translation>Déri&amp;ve</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Méthode</translation>
    </message>
    <message>
        <source>Slow mo&amp;tion</source>
        <translation>Ralen&amp;ti</translation>
    </message>
    <message>
        <source>Drag the log&apos;s curves until they line up with the clip&apos;s; the arrow keys move them by 1 ms, with Shift 10 ms, with Ctrl 100 ms. The wheel zooms. The frame shown is the one at the cursor; comma and period move it.</source>
        <translation>Faites glisser les courbes du journal jusqu’à ce qu’elles s’alignent sur celles du clip&#xa0;; les flèches les déplacent de 1 ms, avec Maj 10 ms, avec Ctrl 100 ms. La molette zoome. L’image affichée est celle du curseur&#xa0;; la virgule et le point le déplacent.</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>son</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>rotation in the frames</source>
        <translation>rotation dans les images</translation>
    </message>
    <message>
        <source>gyro</source>
        <translation>gyroscope</translation>
    </message>
    <message>
        <source>as kept for…</source>
        <translation>comme pour…</translation>
    </message>
    <message>
        <source>{why}. Check below how much slower it plays than it was recorded (1: it does not), then enter the offset, or drag the log&apos;s curves.</source>
        <translation>{why}. Vérifiez ci-dessous combien de fois elle est plus lente que la prise de vue (1&#xa0;: elle ne l’est pas), puis saisissez le décalage, ou faites glisser les courbes du journal.</translation>
    </message>
    <message>
        <source>Enter the offset, or drag the log&apos;s curves.</source>
        <translation>Saisissez le décalage, ou faites glisser les courbes du journal.</translation>
    </message>
    <message>
        <source>Check the offset: {why}.</source>
        <translation>Vérifiez le décalage&#xa0;: {why}.</translation>
    </message>
    <message>
        <source>{recorder} records its motion with the clip.</source>
        <translation>{recorder} enregistre son mouvement avec le clip.</translation>
    </message>
    <message>
        <source>The rotation in the frames fits the log nowhere. Is it the log of this clip, and the video not stabilised? Drag manually.</source>
        <translation>La rotation dans les images ne correspond nulle part au journal. Est-ce bien celui de ce clip, et la vidéo n’est-elle pas stabilisée&#xa0;? Alignez à la main.</translation>
    </message>
    <message>
        <source>The frames are uncertain (confidence {confidence}): the gyro explains {share} % of the rotation ({doubt}). Check that both line up, and drag if not.</source>
        <translation>Les images sont incertaines (confiance {confidence})&#xa0;: le gyroscope explique {share} % de la rotation ({doubt}). Vérifiez que les deux s’alignent, sinon faites glisser.</translation>
    </message>
    <message>
        <source>Frames and tap marks agree, to ±{ms} ms (confidence {confidence}); the gyro explains {share} % of the rotation in the frames.</source>
        <translation>Images et tapotements concordent, à ±{ms} ms près (confiance {confidence})&#xa0;; le gyroscope explique {share} % de la rotation dans les images.</translation>
    </message>
    <message>
        <source>Frames and gyro fit, to ±{ms} ms (confidence {confidence}); the gyro explains {share} % of the rotation in the frames.</source>
        <translation>Images et gyroscope concordent, à ±{ms} ms près (confiance {confidence})&#xa0;; le gyroscope explique {share} % de la rotation dans les images.</translation>
    </message>
</context>
<context>
    <name>SyncPlot</name>
    <message>
        <source>Sync plot</source>
        <translation>Courbe de synchronisation</translation>
    </message>
    <message>
        <source>How much later than video and sound the force came in the last 30 s. Between 15 ms early and 50 ms late is not noticeable</source>
        <translation>Retard de la force sur la vidéo et le son durant les 30 dernières secondes. Entre 15 ms d’avance et 50 ms de retard, rien ne se sent</translation>
    </message>
    <message>
        <source>Force − video</source>
        <translation>Force − vidéo</translation>
    </message>
    <message>
        <source>Force − sound</source>
        <translation>Force − son</translation>
    </message>
</context>
<context>
    <name>SyncStrip</name>
    <message>
        <source>Clip and log over time</source>
        <translation>Clip et journal au fil du temps</translation>
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
        <translation>La prise au fil du temps</translation>
    </message>
    <message>
        <source>Click: seek, beside a mark exactly to it. Left and Right: 1 s, with Shift 5 s. Up and Down: previous and next mark. Wheel: zoom</source>
        <translation>Clic&#xa0;: aller à, ou exactement à une marque proche. Gauche et droite&#xa0;: 1 s, avec Maj 5 s. Haut et bas&#xa0;: marque précédente et suivante. Molette&#xa0;: zoomer</translation>
    </message>
</context>
<context>
    <name>TakeView</name>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Play the take with its sound</source>
        <translation>Lire la prise avec son son</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>son</translation>
    </message>
    <message>
        <source>acceleration without gravity, p</source>
        <translation>accélération sans gravité, p</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>dropped frames: {count}</source>
        <translation>images sautées&#xa0;: {count}</translation>
    </message>
    <message>
        <source>lost samples: {count}</source>
        <translation>mesures perdues&#xa0;: {count}</translation>
    </message>
    <message>
        <source>marks: {count}</source>
        <translation>marques&#xa0;: {count}</translation>
    </message>
    <message>
        <source>residual of the sensor&apos;s clock: {ms} ms</source>
        <translation>résidu de l’horloge du capteur&#xa0;: {ms} ms</translation>
    </message>
    <message>
        <source>No motion was recorded; the import can suggest some from the frames.</source>
        <translation>Aucun mouvement n’a été enregistré&#xa0;; l’importation peut en proposer un d’après les images.</translation>
    </message>
    <message>
        <source>No three taps were found: the clocks decide.</source>
        <translation>Pas de trois tapotements trouvés&#xa0;: les horloges décident.</translation>
    </message>
    <message>
        <source>Taps found: {count}. By them the clocks are {ms} ms apart, which the import corrects.</source>
        <translation>Tapotements trouvés&#xa0;: {count}. D’après eux, les horloges diffèrent de {ms} ms, ce que l’importation corrige.</translation>
    </message>
</context>
<context>
    <name>TextList</name>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Buttons and messages</source>
        <translation>Boutons et messages</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>{code} stands for the participant&apos;s code, {minutes} for the expected duration, {trials} and {feedbacks} for their numbers, {feel} for the label of the button that plays the demonstration.</source>
        <translation>{code} représente le code du participant, {minutes} la durée prévue, {trials} et {feedbacks} leur nombre, {feel} le libellé du bouton qui joue la démonstration.</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>{title}: {text}</source>
        <translation>{title}&#xa0;: {text}</translation>
    </message>
</context>
<context>
    <name>ThemeMenus</name>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Par défaut du système</translation>
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
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
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
        <translation>Temps</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Retour haptique</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Fullscreen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Playback speed (Backspace: normal speed)</source>
        <translation>Vitesse de lecture (Retour arrière&#xa0;: normale)</translation>
    </message>
    <message>
        <source>Position in the clip: click or drag. The strip below shows how strong the force is: the brighter, the stronger</source>
        <translation>Position dans le clip&#xa0;: cliquez ou glissez. La bande au-dessous montre la force&#xa0;: plus elle est claire, plus la force est grande</translation>
    </message>
    <message>
        <source>Force track to play</source>
        <translation>Piste de force à jouer</translation>
    </message>
    <message>
        <source>Haptic device</source>
        <translation>Appareil haptique</translation>
    </message>
    <message>
        <source>Fullscreen (F)</source>
        <translation>Plein écran (F)</translation>
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
        <translation>Pause</translation>
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
        <source>The force was stopped: re-arm it (Ctrl+R)</source>
        <translation>La force a été coupée&#xa0;: réarmer (Ctrl+R)</translation>
    </message>
    <message>
        <source>Stop the force immediately and pause (Esc)</source>
        <translation>Couper la force immédiatement et mettre en pause (Échap)</translation>
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
    <name>Unsaved</name>
    <message>
        <source>Changes from {moment} were not saved.</source>
        <translation>Des modifications du {moment} n’ont pas été enregistrées.</translation>
    </message>
    <message>
        <source>Changes from {moment} were not saved; the effects were changed since.</source>
        <translation>Des modifications du {moment} n’ont pas été enregistrées&#xa0;; les effets ont été modifiés depuis.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Restaurer</translation>
    </message>
</context>
<context>
    <name>VideoQuestion</name>
    <message>
        <source>Another video</source>
        <translation>Une autre vidéo</translation>
    </message>
    <message>
        <source>What is felt may not be what is seen. Feel the force anyway?</source>
        <translation>Ce qui est ressenti ne correspond peut-être pas à ce qui est vu. Ressentir la force quand même&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Feel the force</source>
        <translation>&amp;Ressentir la force</translation>
    </message>
    <message>
        <source>Play &amp;without</source>
        <translation>&amp;Sans la force</translation>
    </message>
</context>
<context>
    <name>VideoSurface</name>
    <message>
        <source>Video</source>
        <translation>Vidéo</translation>
    </message>
</context>
<context>
    <name>Viewing</name>
    <message>
        <source>A&amp;udio track</source>
        <translation>Piste a&amp;udio</translation>
    </message>
    <message>
        <source>Subt&amp;itles</source>
        <translation>Sous-t&amp;itres</translation>
    </message>
    <message>
        <source>&amp;Aspect ratio</source>
        <translation>&amp;Rapport d’image</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Comme filmé</translation>
    </message>
    <message>
        <source>Zoom {x:.0f}&#xa0;%</source>
        <translation>Zoom {x:.0f}&#xa0;%</translation>
    </message>
    <message>
        <source>Aspect ratio: {shape}</source>
        <translation>Rapport d’image&#xa0;: {shape}</translation>
    </message>
    <message>
        <source>No sound in this clip</source>
        <translation>Pas de son dans ce clip</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>No subtitles in this clip</source>
        <translation>Pas de sous-titres dans ce clip</translation>
    </message>
    <message>
        <source>Track {n}</source>
        <translation>Piste {n}</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Enregistré&#xa0;: {name}</translation>
    </message>
</context>
<context>
    <name>_LargePage</name>
    <message>
        <source>Close the preview (Esc)</source>
        <translation>Fermer l’aperçu (Échap)</translation>
    </message>
</context>
<context>
    <name>_Picture</name>
    <message>
        <source>The page as the participant sees it</source>
        <translation>La page telle que le participant la voit</translation>
    </message>
</context>
<context>
    <name>_Place</name>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
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
        <translation> et </translation>
    </message>
    <message>
        <source> and no </source>
        <translation> et pas de </translation>
    </message>
    <message>
        <source> and {count} damaged lines</source>
        <translation> et {count} lignes endommagées</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>, or </source>
        <translation>, ou </translation>
    </message>
    <message>
        <source>, others {known} s</source>
        <translation>, d’autres {known} s</translation>
    </message>
    <message>
        <source>, {norm:.2f} m/s2 at rest</source>
        <translation>, {norm:.2f} m/s2 au repos</translation>
    </message>
    <message>
        <source>1 g = {counts:.0f} and 2000 deg/s</source>
        <translation>1 g = {counts:.0f} et 2000 °/s</translation>
    </message>
    <message>
        <source>1 damaged line was skipped (line {line})</source>
        <translation>1 ligne est endommagée et a été omise (la première&#xa0;: ligne {line})</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>la connexion est rompue</translation>
    </message>
    <message>
        <source>CSV for Excel (UTF-8 with a byte order mark)</source>
        <translation>CSV pour Excel (UTF-8 avec indicateur d’ordre des octets)</translation>
    </message>
    <message>
        <source>CSV log</source>
        <translation>journal CSV</translation>
    </message>
    <message>
        <source>CSV with chosen columns</source>
        <translation>CSV aux colonnes choisies</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>la mémoire ne suffit pas</translation>
    </message>
    <message>
        <source>Connect its USB cable and its power supply. The settings choose another axis, or reverse the direction.</source>
        <translation>Branchez le câble USB et l’alimentation. Les réglages choisissent un autre axe ou inversent le sens.</translation>
    </message>
    <message>
        <source>Connect the amplifier of the shakers to the sound output. By default channels 1 and 2 play; the settings choose others.</source>
        <translation>Branchez l’amplificateur des vibreurs sur la sortie son. Par défaut, les canaux 1 et 2 jouent&#xa0;; les réglages en choisissent d’autres.</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>pas de réponse à temps</translation>
    </message>
    <message>
        <source>Consistency of force and video</source>
        <translation>Concordance de la force et de la vidéo</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>l’appareil est occupé</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>le quota du disque est épuisé</translation>
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
        <source>File exists</source>
        <translation>le fichier existe déjà</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>le nom du fichier est trop long</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>le fichier est trop grand</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>GPMF track</source>
        <translation>piste GPMF</translation>
    </message>
    <message>
        <source>Gyroflow gcsv</source>
        <translation>gcsv de Gyroflow</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erreur de lecture ou d’écriture</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>indication non valable</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>LSL streams cannot be kept on this machine ({reason})</source>
        <translation>les flux LSL ne peuvent pas rester sur cet ordinateur ({reason})</translation>
    </message>
    <message>
        <source>LSL streams cannot be opened ({reason})</source>
        <translation>les flux LSL ne peuvent pas être ouverts ({reason})</translation>
    </message>
    <message>
        <source>LSL streams need pylsl 1.18 or newer with its library</source>
        <translation>les flux LSL demandent pylsl 1.18 ou plus récent, avec sa bibliothèque</translation>
    </message>
    <message>
        <source>MARS logger</source>
        <translation>MARS logger</translation>
    </message>
    <message>
        <source>Motion-rig software: receives the motion of the recording over UDP, as from a game.</source>
        <translation>Logiciel d’une plateforme de mouvement&#xa0;: il reçoit le mouvement de l’enregistrement par UDP, comme d’un jeu.</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>plus de place sur le disque</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>cet appareil n’existe pas</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>ce fichier ou ce dossier n’existe pas</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ce n’est pas un dossier</translation>
    </message>
    <message>
        <source>Nothing moves but the picture.</source>
        <translation>Seule l’image bouge.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>ce n’est pas permis</translation>
    </message>
    <message>
        <source>Operation not supported</source>
        <translation>Opération non prise en charge</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>accès refusé</translation>
    </message>
    <message>
        <source>Quality of experience</source>
        <translation>Qualité d’expérience</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléatoire</translation>
    </message>
    <message>
        <source>Razor, raw output</source>
        <translation>Razor, sortie brute</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>le disque est en lecture seule</translation>
    </message>
    <message>
        <source>Realistic</source>
        <translation>Réaliste</translation>
    </message>
    <message>
        <source>Recorded force and controls</source>
        <translation>Force enregistrée et contrôles</translation>
    </message>
    <message>
        <source>Sensor Logger ({system})</source>
        <translation>Sensor Logger ({system})</translation>
    </message>
    <message>
        <source>Silence</source>
        <translation>Silence</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Tap marks</source>
        <translation>Tapotements</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>The compass is ignored: the file does not declare its axes.</source>
        <translation>La boussole est omise&#xa0;: le fichier ne dit pas quels axes elle a.</translation>
    </message>
    <message>
        <source>The compass is ignored: {what}.</source>
        <translation>La boussole est omise&#xa0;: {what}.</translation>
    </message>
    <message>
        <source>The file does not declare the sensor axes of {camera!r}: those of a HERO5 are assumed.</source>
        <translation>Le fichier ne dit pas comment le capteur est placé dans {camera!r}&#xa0;: les axes d’une HERO5 sont supposés.</translation>
    </message>
    <message>
        <source>The log has {count}, the longest of {length_s:.2f} s at {at_s:.2f} s.</source>
        <translation>Le journal a {count}, la plus longue de {length_s:.2f} s à {at_s:.2f} s.</translation>
    </message>
    <message>
        <source>The motion&apos;s timestamps are {lag_ms:+.1f} ms (± {sigma_ms:.2f} ms) off the frames, measured from the camera&apos;s own orientation at each frame (CORI); this is corrected.</source>
        <translation>Les horodatages du mouvement s’écartent des images de {lag_ms:+.1f} ms (± {sigma_ms:.2f} ms), mesuré d’après l’orientation que la caméra enregistre à chaque image (CORI)&#xa0;; c’est corrigé.</translation>
    </message>
    <message>
        <source>The protocol of Danieau et al. (2012): each clip with the recorded force, without force and with a random one; four questions after each.</source>
        <translation>Le protocole de Danieau et al. (2012)&#xa0;: chaque clip avec la force enregistrée, sans force et avec une force aléatoire&#xa0;; quatre questions après chacun.</translation>
    </message>
    <message>
        <source>The recorded force earlier or later than the video; after each clip, whether both went together.</source>
        <translation>La force enregistrée en avance ou en retard sur la vidéo&#xa0;; après chaque clip, si les deux allaient ensemble.</translation>
    </message>
    <message>
        <source>The same questions; the recorded force beside no force, the force of another clip, and the recorded force half a second late.</source>
        <translation>Les mêmes questions&#xa0;; la force enregistrée à côté d’aucune force, de la force d’un autre clip et de la force enregistrée en retard d’une demi-seconde.</translation>
    </message>
    <message>
        <source>This camera does not timestamp its samples: they are {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) off the frames, measured from the rotation in the frames; this is corrected.</source>
        <translation>Cette caméra n’horodate pas ses mesures&#xa0;: elles s’écartent des images de {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms), mesuré d’après la rotation dans les images&#xa0;; c’est corrigé.</translation>
    </message>
    <message>
        <source>This camera does not timestamp its samples: they may be 10 to 30 ms off.</source>
        <translation>Cette caméra ne date pas ses mesures&#xa0;: elles peuvent être décalées de 10 à 30 ms par rapport à l’image.</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>trop de liens symboliques</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>Ultimate IMU, stock firmware</source>
        <translation>Ultimate IMU, micrologiciel d’origine</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Oui ou non</translation>
    </message>
    <message>
        <source>`study status` lists them</source>
        <translation>`study status` en donne la liste</translation>
    </message>
    <message>
        <source>a GoPro&apos;s telemetry is read without it, and is damaged</source>
        <translation>la télémétrie d’une GoPro se lit sans lui, et elle est endommagée</translation>
    </message>
    <message>
        <source>a block of {count} words at {address:X} fits nowhere</source>
        <translation>un bloc de {count} mots à {address:X} n’a sa place nulle part</translation>
    </message>
    <message>
        <source>a clip cannot be copied onto itself</source>
        <translation>un clip ne peut pas être copié sur lui-même</translation>
    </message>
    <message>
        <source>a code has {length} letters, as `study status` lists them</source>
        <translation>un code a {length} lettres, comme `study status` les donne</translation>
    </message>
    <message>
        <source>a cutoff of {cutoff_hz:g} Hz is not below half the rate of the samples, {half_rate_hz:.4g} Hz</source>
        <translation>une fréquence de coupure de {cutoff_hz:g} Hz n’est pas inférieure à la moitié de la cadence des mesures, {half_rate_hz:.4g} Hz</translation>
    </message>
    <message>
        <source>a device is left out: {reason}</source>
        <translation>un appareil est omis&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>a direction of length 0 was taken as x {x:.2f}, y {y:.2f}, z {z:.2f}</source>
        <translation>une direction de longueur 0 a été prise comme x {x:.2f}, y {y:.2f}, z {z:.2f}</translation>
    </message>
    <message>
        <source>a duration of {length_s:g} s; give one from 1 to {longest_s:g} s</source>
        <translation>une durée de {length_s:g} s&#xa0;; indiquez de 1 à {longest_s:g} s</translation>
    </message>
    <message>
        <source>a force that is not a number was commanded, a defect of this program; please report it, and choose the device again</source>
        <translation>une force qui n’est pas un nombre a été demandée, un défaut de ce programme&#xa0;; veuillez le signaler et choisir de nouveau l’appareil</translation>
    </message>
    <message>
        <source>a force track needs at least one row</source>
        <translation>une piste de force demande au moins une ligne</translation>
    </message>
    <message>
        <source>a latency of {value:g} s is not between 0 and 1 s</source>
        <translation>une latence de {value:g} s n’est pas entre 0 et 1 s</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a part of it was recorded faster (Super Slow-mo)</source>
        <translation>une partie a été filmée plus vite (Super Slow-mo)</translation>
    </message>
    <message>
        <source>a sensor of {rate_hz:g} Hz averaged to {log_hz:g} Hz; give rates above 0, the second not above the first</source>
        <translation>un capteur à {rate_hz:g} Hz moyenné à {log_hz:g} Hz&#xa0;; indiquez des fréquences positives, la seconde ne dépassant pas la première</translation>
    </message>
    <message>
        <source>a session has one plan</source>
        <translation>une séance n’a qu’un plan</translation>
    </message>
    <message>
        <source>a sound of {rate_hz} Hz is too coarse; give 8000 or more</source>
        <translation>un son de {rate_hz} Hz est trop grossier&#xa0;; donnez 8000 ou plus</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a time constant is for the method smoother, not for {method}</source>
        <translation>une constante de temps ne vaut que pour la méthode smoother, pas pour {method}</translation>
    </message>
    <message>
        <source>a title must have 1 to {most} characters</source>
        <translation>un titre a de 1 à {most} caractères</translation>
    </message>
    <message>
        <source>about {count} samples were never recorded; the longest gap is {longest_s:.3g} s; nothing was put in their place</source>
        <translation>environ {count} mesures n’ont jamais été enregistrées&#xa0;; la plus longue lacune est de {longest_s:.3g} s&#xa0;; rien n’a été mis à leur place</translation>
    </message>
    <message>
        <source>accel-sign=+ if the recorder was that way up</source>
        <translation>accel-sign=+ si l’enregistreur était dans ce sens</translation>
    </message>
    <message>
        <source>accel-sign=-, or correct the sign in the log</source>
        <translation>accel-sign=-, ou corrigez le signe dans le journal</translation>
    </message>
    <message>
        <source>accelerometer</source>
        <translation>accéléromètre</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>ajoutez-la</translation>
    </message>
    <message>
        <source>add orders.csv</source>
        <translation>ajoutez orders.csv</translation>
    </message>
    <message>
        <source>after record {number}</source>
        <translation>après l’entrée {number}</translation>
    </message>
    <message>
        <source>all samples are the same, so the sensor was stuck</source>
        <translation>toutes les mesures sont égales, le capteur était donc bloqué</translation>
    </message>
    <message>
        <source>all samples are the same: was the sensor stuck?</source>
        <translation>toutes les mesures sont égales&#xa0;: le capteur était-il bloqué&#xa0;?</translation>
    </message>
    <message>
        <source>already exists</source>
        <translation>existe déjà</translation>
    </message>
    <message>
        <source>an effect of {share:g} times the paper&apos;s leaves the scale of {low} to {high}; choose a smaller one</source>
        <translation>un effet de {share:g} fois celui de l’article sort de l’échelle de {low} à {high}&#xa0;; choisissez-en un plus petit</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>an unknown logger</source>
        <translation>un enregistreur inconnu</translation>
    </message>
    <message>
        <source>angular rate in {unit}</source>
        <translation>vitesse angulaire en {unit}</translation>
    </message>
    <message>
        <source>another record has this number</source>
        <translation>une autre entrée a ce numéro</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>réponses</translation>
    </message>
    <message>
        <source>applied as given: {answers}</source>
        <translation>appliqué comme indiqué&#xa0;: {answers}</translation>
    </message>
    <message>
        <source>as its own times place it</source>
        <translation>d’après ses propres temps</translation>
    </message>
    <message>
        <source>as stored, orientation {orientation}</source>
        <translation>tel qu’enregistré, orientation {orientation}</translation>
    </message>
    <message>
        <source>as telemetry-parser gives them</source>
        <translation>tels que telemetry-parser les donne</translation>
    </message>
    <message>
        <source>as the camera&apos;s stamps begin</source>
        <translation>d’après le début des horodatages de la caméra</translation>
    </message>
    <message>
        <source>as the edit list cuts the video</source>
        <translation>selon la coupe de la vidéo par la liste de montage</translation>
    </message>
    <message>
        <source>ask for a file that was packed with it</source>
        <translation>demandez un fichier empaqueté avec lui</translation>
    </message>
    <message>
        <source>ask for the file again, or accept it</source>
        <translation>redemandez le fichier, ou acceptez-le</translation>
    </message>
    <message>
        <source>ask for the file again, or agree</source>
        <translation>redemandez le fichier, ou donnez votre accord</translation>
    </message>
    <message>
        <source>at the beginning</source>
        <translation>au début</translation>
    </message>
    <message>
        <source>at times nothing was played: {cause}; {remedy}</source>
        <translation>par moments, rien n’a été joué&#xa0;: {cause}&#xa0;; {remedy}</translation>
    </message>
    <message>
        <source>averaged from {rate_hz:.1f} to {average_hz:g} Hz</source>
        <translation>moyenné de {rate_hz:.1f} à {average_hz:g} Hz</translation>
    </message>
    <message>
        <source>axes=RIGHT,FRONT,UP in its axes, such as axes=x,-z,y</source>
        <translation>axes=DROITE,AVANT,HAUT dans ses axes, par exemple axes=x,-z,y</translation>
    </message>
    <message>
        <source>axes={axes} are not three axes; give right, front and up in the axes of the log, for example axes=x,-z,y</source>
        <translation>axes={axes} ne sont pas trois axes&#xa0;; donnez la droite, l’avant et le haut dans les axes du journal, par exemple axes=x,-z,y</translation>
    </message>
    <message>
        <source>axes={axes} mirror the log; change one sign: right, front and up have to follow the right hand</source>
        <translation>axes={axes} inversent le journal en miroir&#xa0;; changez un signe, car droite, avant et haut doivent suivre la main droite</translation>
    </message>
    <message>
        <source>axes={axes}, or the axes that were right, front, up</source>
        <translation>axes={axes} ou ce qui était autrement droite, avant, haut</translation>
    </message>
    <message>
        <source>axis without an id</source>
        <translation>axe sans identifiant</translation>
    </message>
    <message>
        <source>begin the file with {header}</source>
        <translation>commencez le fichier par {header}</translation>
    </message>
    <message>
        <source>begins without a header</source>
        <translation>commence sans en-tête</translation>
    </message>
    <message>
        <source>belongs to the clip {found!r}, not to {expected!r}</source>
        <translation>appartient au clip {found!r}, pas à {expected!r}</translation>
    </message>
    <message>
        <source>bring the streams to common times by interpolation first</source>
        <translation>ramenez d’abord les flux à des temps communs par interpolation</translation>
    </message>
    <message>
        <source>by the frames of the clip the mounting is {axes}, by gravity it is the other way up, so that the accelerometer has the other sign</source>
        <translation>d’après les images du clip, la fixation est {axes}, d’après la pesanteur elle est à l’envers&#xa0;; l’accéléromètre a donc le signe contraire</translation>
    </message>
    <message>
        <source>byte {number}</source>
        <translation>l’octet {number}</translation>
    </message>
    <message>
        <source>bytes {begin} to {end} (line {line}, {after}) are damaged</source>
        <translation>les octets {begin} à {end} (ligne {line}, {after}) sont endommagés</translation>
    </message>
    <message>
        <source>call the experimenter</source>
        <translation>appelez l’expérimentateur</translation>
    </message>
    <message>
        <source>cancelled; nothing was written</source>
        <translation>annulé&#xa0;; rien n’a été écrit</translation>
    </message>
    <message>
        <source>cannot be copied ({reason})</source>
        <translation>ne peut pas être copié ({reason})</translation>
    </message>
    <message>
        <source>cannot be decoded ({reason})</source>
        <translation>ne peut pas être décodé ({reason})</translation>
    </message>
    <message>
        <source>cannot be listed ({reason})</source>
        <translation>ne peut pas être listé ({reason})</translation>
    </message>
    <message>
        <source>cannot be positioned</source>
        <translation>ne peut pas être positionné</translation>
    </message>
    <message>
        <source>cannot be reached ({reason})</source>
        <translation>ne peut pas être atteint ({reason})</translation>
    </message>
    <message>
        <source>cannot be read ({reason})</source>
        <translation>ne peut pas être lu ({reason})</translation>
    </message>
    <message>
        <source>cannot be started ({reason})</source>
        <translation>ne peut pas être lancé ({reason})</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>ne peut pas être écrit</translation>
    </message>
    <message>
        <source>carry the time of their packet and were spread evenly</source>
        <translation>portent le temps de leur paquet et ont été réparties régulièrement</translation>
    </message>
    <message>
        <source>change the rights of the file</source>
        <translation>changez les droits du fichier</translation>
    </message>
    <message>
        <source>changes of the frequency within a second</source>
        <translation>les variations de la fréquence en moins d’une seconde</translation>
    </message>
    <message>
        <source>check the name and the folder</source>
        <translation>vérifiez le nom et le dossier</translation>
    </message>
    <message>
        <source>check the name and the rights of its folder</source>
        <translation>vérifiez le nom et les droits de son dossier</translation>
    </message>
    <message>
        <source>check the rights of the folder</source>
        <translation>vérifiez les droits du dossier</translation>
    </message>
    <message>
        <source>choose a clip with sound</source>
        <translation>choisissez un clip avec du son</translation>
    </message>
    <message>
        <source>choose a device first</source>
        <translation>choisissez d’abord un appareil</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>choisissez un fichier</translation>
    </message>
    <message>
        <source>choose a file that was exported by it</source>
        <translation>choisissez un fichier qu’il a exporté</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>choisissez un autre fichier</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>choisissez un autre dossier</translation>
    </message>
    <message>
        <source>choose another log</source>
        <translation>choisissez un autre journal</translation>
    </message>
    <message>
        <source>choose another {kind}</source>
        <translation>choisissez autre chose ({kind})</translation>
    </message>
    <message>
        <source>choose one of {known}</source>
        <translation>choisissez parmi {known}</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>fermez-la d’abord là-bas</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>complète</translation>
    </message>
    <message>
        <source>convert it to a smaller size</source>
        <translation>convertissez-la dans une taille plus petite</translation>
    </message>
    <message>
        <source>convert it with &apos;hapticplayer export&apos;</source>
        <translation>convertissez-le avec &apos;hapticplayer export&apos;</translation>
    </message>
    <message>
        <source>convert its sound to stereo at 48 kHz</source>
        <translation>convertissez son son en stéréo à 48 kHz</translation>
    </message>
    <message>
        <source>copy it again</source>
        <translation>copiez-le encore une fois</translation>
    </message>
    <message>
        <source>copy it again from the camera, or choose another file</source>
        <translation>copiez-le encore une fois depuis la caméra, ou choisissez un autre fichier</translation>
    </message>
    <message>
        <source>copy it again from the recorder</source>
        <translation>copiez-le encore une fois depuis l’enregistreur</translation>
    </message>
    <message>
        <source>copy it again, convert it to MP4 (H.264 and AAC), or choose another file</source>
        <translation>copiez-le encore une fois, convertissez-le en MP4 (H.264 et AAC), ou choisissez un autre fichier</translation>
    </message>
    <message>
        <source>copy the recording again from the camera</source>
        <translation>copiez encore une fois l’enregistrement depuis la caméra</translation>
    </message>
    <message>
        <source>copy the sequence again or import it again</source>
        <translation>copiez encore une fois la séquence, ou importez-la de nouveau</translation>
    </message>
    <message>
        <source>copy the session again</source>
        <translation>copiez encore une fois la séance</translation>
    </message>
    <message>
        <source>copy the study&apos;s folder to the other machine, then run it there</source>
        <translation>copiez le dossier de l’étude sur l’autre ordinateur, puis lancez-la là-bas</translation>
    </message>
    <message>
        <source>correct it</source>
        <translation>corrigez cela</translation>
    </message>
    <message>
        <source>could be {formats}</source>
        <translation>pourrait être {formats}</translation>
    </message>
    <message>
        <source>counts of {unit:.4g}</source>
        <translation>unités brutes de {unit:.4g}</translation>
    </message>
    <message>
        <source>cut it into parts</source>
        <translation>coupez-le en morceaux</translation>
    </message>
    <message>
        <source>cut the log into parts</source>
        <translation>coupez le journal en morceaux</translation>
    </message>
    <message>
        <source>cut the recording there and give the parts one by one</source>
        <translation>coupez l’enregistrement à cet endroit et donnez les morceaux un par un</translation>
    </message>
    <message>
        <source>damaged places: {places}, with {ticks} ticks</source>
        <translation>passages endommagés&#xa0;: {places}, avec {ticks} périodes</translation>
    </message>
    <message>
        <source>faults can only be injected into a simulated device that was opened for it</source>
        <translation>les pannes ne peuvent être injectées que dans un appareil simulé ouvert à cet effet</translation>
    </message>
    <message>
        <source>force, lossless</source>
        <translation>force, sans perte</translation>
    </message>
    <message>
        <source>has an invalid header</source>
        <translation>a un en-tête non valide</translation>
    </message>
    <message>
        <source>has an invalid header: {reason}</source>
        <translation>a un en-tête non valide&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>has no such subtitles</source>
        <translation>n’a pas de tels sous-titres</translation>
    </message>
    <message>
        <source>high</source>
        <translation>grande</translation>
    </message>
    <message>
        <source>if it is not in seconds, multiply {scale} by {per_s:.0f}; else average to {most_hz:g} samples a second</source>
        <translation>si ce n’est pas en secondes, multipliez {scale} par {per_s:.0f}&#xa0;; sinon, moyennez à {most_hz:g} mesures par seconde</translation>
    </message>
    <message>
        <source>is damaged in its header</source>
        <translation>est endommagé dans son en-tête</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>is not a recording of a haptic loop</source>
        <translation>n’est pas l’enregistrement d’une boucle haptique</translation>
    </message>
    <message>
        <source>is not the description of a sequence</source>
        <translation>ne décrit pas de séquence</translation>
    </message>
    <message>
        <source>device {name!r}: this version has no driver for it; use {known}</source>
        <translation>appareil {name!r}&#xa0;: cette version n’a pas de pilote pour lui&#xa0;; prenez {known}</translation>
    </message>
    <message>
        <source>does not declare iOS or Android, whose accelerations have opposite signs</source>
        <translation>ne dit pas s’il vient d’iOS ou d’Android, dont les accélérations sont de signes contraires</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminée</translation>
    </message>
    <message>
        <source>every sequence needs its track {name!r}</source>
        <translation>chaque séquence a la piste {name!r}&#xa0;; elle reste</translation>
    </message>
    <message>
        <source>export the acceleration with gravity, and the gyroscope</source>
        <translation>exportez l’accélération avec la pesanteur, et le gyroscope</translation>
    </message>
    <message>
        <source>export the log again</source>
        <translation>exportez encore une fois le journal</translation>
    </message>
    <message>
        <source>export the log again or choose another one</source>
        <translation>exportez encore une fois le journal ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>export the log as comma-separated text</source>
        <translation>exportez le journal en texte séparé par des virgules</translation>
    </message>
    <message>
        <source>export the recording again</source>
        <translation>exportez encore une fois l’enregistrement</translation>
    </message>
    <message>
        <source>export the recording as CSV</source>
        <translation>exportez l’enregistrement en CSV</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>a échoué</translation>
    </message>
    <message>
        <source>field_dip_rad must lie within a right angle, got {field_dip_rad}</source>
        <translation>field_dip_rad doit être inférieur à un angle droit, et vaut {field_dip_rad}</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>has {rows} rows of {columns} numbers{more}</source>
        <translation>a {rows} lignes de {columns} nombres{more}</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>ferme</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>dossier</translation>
    </message>
    <message>
        <source>force, rate and field must have as many samples</source>
        <translation>force, vitesse angulaire et champ doivent avoir autant d’échantillons</translation>
    </message>
    <message>
        <source>accel-sign must be + or -</source>
        <translation>accel-sign est + ou -</translation>
    </message>
    <message>
        <source>accel-sign=- if its accelerometer reads -1 g upwards</source>
        <translation>accel-sign=- si son accéléromètre indique -1 g vers le haut</translation>
    </message>
    <message>
        <source>accel-unit={fitting:.6g} to scale it to gravity</source>
        <translation>accel-unit={fitting:.6g} pour l’ajuster à la pesanteur</translation>
    </message>
    <message>
        <source>format=csv and columns=time,ax,ay,az,gx,gy,gz (- for others)</source>
        <translation>format=csv et columns=time,ax,ay,az,gx,gy,gz (- pour les autres)</translation>
    </message>
    <message>
        <source>free some memory and disk, and try again</source>
        <translation>libérez de la mémoire et du disque, puis réessayez</translation>
    </message>
    <message>
        <source>free some space or copy the sequence to a folder of your own</source>
        <translation>libérez de la place ou copiez la séquence dans un dossier à vous</translation>
    </message>
    <message>
        <source>from {lowest_hz:.1f} to {highest_hz:.1f} Hz</source>
        <translation>de {lowest_hz:.1f} à {highest_hz:.1f} Hz</translation>
    </message>
    <message>
        <source>from {place} on all rows carry the same time</source>
        <translation>à partir de la {place}, toutes les lignes portent le même temps</translation>
    </message>
    <message>
        <source>gcsv of {logger}</source>
        <translation>gcsv de {logger}</translation>
    </message>
    <message>
        <source>give a frequency in Hz</source>
        <translation>donnez une fréquence en Hz</translation>
    </message>
    <message>
        <source>give a higher rate or a longer recording</source>
        <translation>donnez une cadence plus élevée ou un enregistrement plus long</translation>
    </message>
    <message>
        <source>give a lower cutoff, or leave the low-pass out</source>
        <translation>donnez une fréquence de coupure plus basse, ou laissez le passe-bas de côté</translation>
    </message>
    <message>
        <source>give a lower rate; samples can be merged, not made up</source>
        <translation>donnez une cadence plus basse&#xa0;; des mesures se regroupent, elles ne s’inventent pas</translation>
    </message>
    <message>
        <source>give a rate in Hz, such as 30</source>
        <translation>donnez une cadence en Hz, par exemple 30</translation>
    </message>
    <message>
        <source>give a recording of a sensor that worked</source>
        <translation>donnez l’enregistrement d’un capteur qui a fonctionné</translation>
    </message>
    <message>
        <source>give a recording of at least a few seconds</source>
        <translation>donnez un enregistrement d’au moins quelques secondes</translation>
    </message>
    <message>
        <source>give a recording with at least two samples</source>
        <translation>donnez un enregistrement d’au moins deux mesures</translation>
    </message>
    <message>
        <source>give at least {least_hz:g} samples a second</source>
        <translation>donnez au moins {least_hz:g} mesures par seconde</translation>
    </message>
    <message>
        <source>give the angular rate in rad/s</source>
        <translation>donnez la vitesse angulaire en rad/s</translation>
    </message>
    <message>
        <source>restore the original file names</source>
        <translation>donnez aux fichiers les noms de leur enregistrement</translation>
    </message>
    <message>
        <source>give the folder of a sequence</source>
        <translation>donnez le dossier d’une séquence</translation>
    </message>
    <message>
        <source>give the folder of a sequence, or a video</source>
        <translation>donnez le dossier d’une séquence, ou une vidéo</translation>
    </message>
    <message>
        <source>give the folder of a study</source>
        <translation>donnez le dossier d’une étude</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>donnez le dossier d’un seul enregistrement</translation>
    </message>
    <message>
        <source>give the folder of the sequence</source>
        <translation>donnez le dossier de la séquence</translation>
    </message>
    <message>
        <source>give the folder or zip that the logger has written, or a sequence</source>
        <translation>donnez le dossier ou le zip que l’enregistreur a écrit, ou une séquence</translation>
    </message>
    <message>
        <source>give the folder with the files of all sensors</source>
        <translation>donnez le dossier avec les fichiers de tous les capteurs</translation>
    </message>
    <message>
        <source>give the forces in newton</source>
        <translation>donnez les forces en newtons</translation>
    </message>
    <message>
        <source>give the specific force in m/s2, about 9.8 at rest</source>
        <translation>donnez la force spécifique en m/s2, environ 9.8 au repos</translation>
    </message>
    <message>
        <source>give the specific force in m/s^2, about 9.8 at rest</source>
        <translation>donnez la force spécifique en m/s^2, environ 9.8 au repos</translation>
    </message>
    <message>
        <source>give the time of each sample in seconds</source>
        <translation>donnez le temps de chaque mesure en secondes</translation>
    </message>
    <message>
        <source>give the whole folder or zip, recorded with the gyroscope</source>
        <translation>donnez le dossier ou le zip entier, enregistré avec le gyroscope</translation>
    </message>
    <message>
        <source>give the whole zip, recorded with accelerometer and gyroscope</source>
        <translation>donnez le zip entier, enregistré avec l’accéléromètre et le gyroscope</translation>
    </message>
    <message>
        <source>give their times in seconds</source>
        <translation>donnez leurs temps en secondes</translation>
    </message>
    <message>
        <source>give three axes for each time</source>
        <translation>donnez trois axes pour chaque temps</translation>
    </message>
    <message>
        <source>give times in seconds of the clip</source>
        <translation>donnez des temps en secondes du clip</translation>
    </message>
    <message>
        <source>the accelerometer reads {norm:.2f} m/s2 at rest instead of 9.81</source>
        <translation>l’accéléromètre indique {norm:.2f} m/s2 au repos au lieu de 9,81</translation>
    </message>
    <message>
        <source>gravity shows that {sign}{axis} of the recorder was up, not its z</source>
        <translation>selon la pesanteur, {sign}{axis} de l’enregistreur était en haut, pas son z</translation>
    </message>
    <message>
        <source>, or {sign}</source>
        <translation>, ou {sign}</translation>
    </message>
    <message>
        <source>choose a folder with write permission</source>
        <translation>choisissez un dossier où vous pouvez écrire</translation>
    </message>
    <message>
        <source>choose a folder; a part of this path is a file or a dead link</source>
        <translation>choisissez un dossier&#xa0;; une partie de ce chemin est un fichier ou un lien mort</translation>
    </message>
    <message>
        <source>choose a playback log</source>
        <translation>choisissez un journal de lecture</translation>
    </message>
    <message>
        <source>choose a refresh rate of 30 Hz or more</source>
        <translation>choisissez une fréquence de rafraîchissement de 30 Hz ou plus</translation>
    </message>
    <message>
        <source>choose a shorter name</source>
        <translation>choisissez un nom plus court</translation>
    </message>
    <message>
        <source>choose another file, or replace it</source>
        <translation>choisissez un autre fichier, ou remplacez-le</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>choisissez-en un autre</translation>
    </message>
    <message>
        <source>choose another place; the report was printed</source>
        <translation>choisissez un autre emplacement&#xa0;; le rapport a été affiché</translation>
    </message>
    <message>
        <source>choose its folder</source>
        <translation>choisissez son dossier</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>choisissez-en un</translation>
    </message>
    <message>
        <source>choose the mounting: right, front and up of the wearer</source>
        <translation>choisissez la fixation&#xa0;: droite, avant et haut du porteur</translation>
    </message>
    <message>
        <source>close other programs, or give pings more time in Intiface</source>
        <translation>fermez d’autres programmes, ou laissez plus de temps aux pings dans Intiface</translation>
    </message>
    <message>
        <source>compare sound and motion by eye, then enter the offset</source>
        <translation>comparez à l’œil le son et le mouvement, puis saisissez le décalage</translation>
    </message>
    <message>
        <source>each tick of the device</source>
        <translation>chaque période de l’appareil</translation>
    </message>
    <message>
        <source>effects without a time begin at 0 s</source>
        <translation>les effets sans temps commencent à 0 s</translation>
    </message>
    <message>
        <source>enter another offset</source>
        <translation>saisissez un autre décalage</translation>
    </message>
    <message>
        <source>enter the media time at which the log&apos;s clock reads 0</source>
        <translation>saisissez le temps du média où l’horloge du journal indique 0</translation>
    </message>
    <message>
        <source>enter what is asked for by hand</source>
        <translation>saisissez à la main ce qui est demandé</translation>
    </message>
    <message>
        <source>export it again as PCM of 16, 24 or 32 bits, of up to {most} channels</source>
        <translation>exportez-le de nouveau en PCM de 16, 24 ou 32 bits, avec {most} canaux au plus</translation>
    </message>
    <message>
        <source>film something with detail, or use the taps</source>
        <translation>filmez quelque chose de détaillé, ou utilisez les tapotements</translation>
    </message>
    <message>
        <source>free {need_mb} MB there</source>
        <translation>libérez-y {need_mb} Mo</translation>
    </message>
    <message>
        <source>give its log, too, and {option} if asked</source>
        <translation>donnez aussi son journal, et {option} si cela est demandé</translation>
    </message>
    <message>
        <source>give the log of a motion sensor, too</source>
        <translation>donnez aussi le journal d’un capteur de mouvement</translation>
    </message>
    <message>
        <source>give the log, too, or have the motion estimated from the frames</source>
        <translation>donnez aussi le journal, ou faites estimer le mouvement d’après les images</translation>
    </message>
    <message>
        <source>gravity seems to be removed already: give the acceleration with gravity</source>
        <translation>la pesanteur semble déjà retirée&#xa0;: donnez l’accélération avec la pesanteur</translation>
    </message>
    <message>
        <source>gravity shows that {axis} was up, not the axis that was chosen</source>
        <translation>selon la pesanteur, {axis} était en haut, pas l’axe choisi</translation>
    </message>
    <message>
        <source>gravity was already removed by the recorder</source>
        <translation>la pesanteur avait déjà été retirée par l’enregistreur</translation>
    </message>
    <message>
        <source>gyro</source>
        <translation>gyroscope</translation>
    </message>
    <message>
        <source>has an unusual format ({bits} bits in {block} bytes for {channels} channels, {rate_hz} Hz)</source>
        <translation>a un format inhabituel ({bits} bits dans {block} octets pour {channels} canaux, {rate_hz} Hz)</translation>
    </message>
    <message>
        <source>has changed since it was written (its checksum differs)</source>
        <translation>a changé depuis son écriture (sa somme de contrôle diffère)</translation>
    </message>
    <message>
        <source>has more than {most} characters</source>
        <translation>a plus de {most} caractères</translation>
    </message>
    <message>
        <source>has more than {most} rows</source>
        <translation>a plus de {most} lignes</translation>
    </message>
    <message>
        <source>has no answers yet</source>
        <translation>n’a pas encore de réponses</translation>
    </message>
    <message>
        <source>has no timestamps, and its firmware has no fixed rate</source>
        <translation>n’a pas de temps, et son micrologiciel n’a pas de cadence fixe</translation>
    </message>
    <message>
        <source>has the unknown name {unknown!r}</source>
        <translation>a le nom inconnu {unknown!r}</translation>
    </message>
    <message>
        <source>has version {found} of the format, not {version}</source>
        <translation>a la version {found} du format, et non {version}</translation>
    </message>
    <message>
        <source>has {count} bytes instead of {expected}</source>
        <translation>a {count} octets au lieu de {expected}</translation>
    </message>
    <message>
        <source>has {count} columns, and a Razor M0 does not declare them</source>
        <translation>a {count} colonnes, et un Razor M0 ne dit pas lesquelles</translation>
    </message>
    <message>
        <source>has {count} columns, the header has {expected}</source>
        <translation>a {count} colonnes, l’en-tête en a {expected}</translation>
    </message>
    <message>
        <source>has {count} telemetry payloads, too many</source>
        <translation>a {count} blocs de télémétrie, c’est trop</translation>
    </message>
    <message>
        <source>holds Euler angles and no acceleration</source>
        <translation>contient des angles d’Euler et pas d’accélération</translation>
    </message>
    <message>
        <source>holds a force of {largest_n:.3g} N, beyond any device</source>
        <translation>contient une force de {largest_n:.3g} N, au-delà de tout appareil</translation>
    </message>
    <message>
        <source>holds acceleration from which the recorder has removed gravity, so it cannot be checked or levelled</source>
        <translation>contient une accélération dont l’enregistreur a retiré la pesanteur, elle ne peut donc être ni vérifiée ni mise de niveau</translation>
    </message>
    <message>
        <source>holds an acceleration of {largest:.3g} m/s2, beyond any sensor</source>
        <translation>contient une accélération de {largest:.3g} m/s2, au-delà de tout capteur</translation>
    </message>
    <message>
        <source>holds angles without angular rates, so motion cannot be computed</source>
        <translation>contient des angles sans vitesses angulaires, dont on ne peut pas tirer de mouvement</translation>
    </message>
    <message>
        <source>holds counts of an unknown range (norm {norm:.4g})</source>
        <translation>contient des unités brutes d’une plage inconnue (norme {norm:.4g})</translation>
    </message>
    <message>
        <source>holds more than {most} files</source>
        <translation>contient plus de {most} fichiers</translation>
    </message>
    <message>
        <source>holds no acceleration (only {held})</source>
        <translation>ne contient pas d’accélération (seulement {held})</translation>
    </message>
    <message>
        <source>holds no acceleration with gravity</source>
        <translation>ne contient pas d’accélération avec la pesanteur</translation>
    </message>
    <message>
        <source>holds no angular rate; gravity cannot be removed without it</source>
        <translation>ne contient pas de vitesse angulaire, sans laquelle la pesanteur ne se distingue pas du mouvement</translation>
    </message>
    <message>
        <source>holds no force</source>
        <translation>ne contient pas de force</translation>
    </message>
    <message>
        <source>holds no gyroscope (only {held})</source>
        <translation>ne contient pas de gyroscope (seulement {held})</translation>
    </message>
    <message>
        <source>holds no log of a known format</source>
        <translation>ne contient aucun journal connu</translation>
    </message>
    <message>
        <source>holds no order</source>
        <translation>ne contient aucun ordre</translation>
    </message>
    <message>
        <source>holds no positions that are read ({first})</source>
        <translation>ne contient aucune position lisible ({first})</translation>
    </message>
    <message>
        <source>holds no settings of this program</source>
        <translation>ne contient pas de réglages de ce programme</translation>
    </message>
    <message>
        <source>holds no {missing} file</source>
        <translation>ne contient pas de fichier {missing}</translation>
    </message>
    <message>
        <source>holds no {name}</source>
        <translation>ne contient pas {name}</translation>
    </message>
    <message>
        <source>holds several recordings ({first}, {second})</source>
        <translation>contient plusieurs enregistrements ({first}, {second})</translation>
    </message>
    <message>
        <source>holds {count} logs ({known})</source>
        <translation>contient {count} journaux ({known})</translation>
    </message>
    <message>
        <source>holds {name!r}, a name outside the zip</source>
        <translation>contient {name!r}, un nom qui mène hors du zip</translation>
    </message>
    <message>
        <source>if it is in g, multiply it by 9.80665; if gravity was removed already, give the acceleration with gravity</source>
        <translation>si c’est en g, multipliez par 9.80665&#xa0;; si la pesanteur a déjà été retirée, donnez l’accélération avec la pesanteur</translation>
    </message>
    <message>
        <source>import a recording, or ask for a file with its motion</source>
        <translation>importez un enregistrement, ou demandez un fichier avec son mouvement</translation>
    </message>
    <message>
        <source>import it again</source>
        <translation>importez de nouveau</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>est un périphérique, pas un fichier</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>est un tube, pas un fichier</translation>
    </message>
    <message>
        <source>is a socket, not a file</source>
        <translation>est un socket, pas un fichier</translation>
    </message>
    <message>
        <source>is a table of {count} columns ({shown}) without a description</source>
        <translation>est un tableau de {count} colonnes ({shown}) qui ne dit pas ce qu’elles sont</translation>
    </message>
    <message>
        <source>is an Excel workbook</source>
        <translation>est un classeur Excel</translation>
    </message>
    <message>
        <source>is damaged (its checksum differs)</source>
        <translation>est endommagé (sa somme de contrôle diffère)</translation>
    </message>
    <message>
        <source>is damaged ({reason})</source>
        <translation>est endommagé ({reason})</translation>
    </message>
    <message>
        <source>is empty (0 bytes)</source>
        <translation>est vide (0 octet)</translation>
    </message>
    <message>
        <source>is larger than the limit of {most_mb} MB</source>
        <translation>dépasse la limite de {most_mb} Mo</translation>
    </message>
    <message>
        <source>is larger than {most_gb} GB</source>
        <translation>dépasse {most_gb} Go</translation>
    </message>
    <message>
        <source>is longer than {most} characters</source>
        <translation>dépasse {most} caractères</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>n’est pas du JSON</translation>
    </message>
    <message>
        <source>is not a playback log</source>
        <translation>n’est pas un journal</translation>
    </message>
    <message>
        <source>is not a video</source>
        <translation>n’est pas une vidéo</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>is not a text file in UTF-8</source>
        <translation>n’est pas un fichier de texte en UTF-8</translation>
    </message>
    <message>
        <source>is not answered yet</source>
        <translation>n’a pas encore de réponse</translation>
    </message>
    <message>
        <source>is not available in {language!r}</source>
        <translation>n’existe pas en {language!r}</translation>
    </message>
    <message>
        <source>cannot be read by telemetry-parser ({reason})</source>
        <translation>n’est rien que telemetry-parser sache lire ({reason})</translation>
    </message>
    <message>
        <source>is of a newer version of this program</source>
        <translation>est d’une version plus récente de ce programme</translation>
    </message>
    <message>
        <source>is of a {name}, whose telemetry does not declare its axes</source>
        <translation>est d’une {name}, dont la télémétrie ne dit pas les axes</translation>
    </message>
    <message>
        <source>is open in another window</source>
        <translation>est ouverte dans une autre fenêtre</translation>
    </message>
    <message>
        <source>is text in UTF-16</source>
        <translation>est du texte en UTF-16</translation>
    </message>
    <message>
        <source>is the study {found}, not {expected}</source>
        <translation>est l’étude {found}, et non {expected}</translation>
    </message>
    <message>
        <source>is too large</source>
        <translation>est trop grand</translation>
    </message>
    <message>
        <source>is too large to be read at once</source>
        <translation>est trop volumineux pour être lu en une fois</translation>
    </message>
    <message>
        <source>it cannot be decoded any further</source>
        <translation>la suite ne peut pas être décodée</translation>
    </message>
    <message>
        <source>it cannot be probed</source>
        <translation>il ne peut pas être examiné</translation>
    </message>
    <message>
        <source>it cannot be read any further</source>
        <translation>la suite ne peut pas être lue</translation>
    </message>
    <message>
        <source>it died, status {status}</source>
        <translation>il s’est arrêté, état {status}</translation>
    </message>
    <message>
        <source>it does not begin with the boot loader&apos;s key 08AA</source>
        <translation>il ne commence pas par la clé 08AA du chargeur</translation>
    </message>
    <message>
        <source>it ends in its header</source>
        <translation>il finit dans son en-tête</translation>
    </message>
    <message>
        <source>it gives {duration_s:.0f} s as its duration</source>
        <translation>il indique {duration_s:.0f} s comme durée</translation>
    </message>
    <message>
        <source>it holds no accelerations</source>
        <translation>il ne contient pas d’accélérations</translation>
    </message>
    <message>
        <source>it holds no sound</source>
        <translation>il ne contient pas de son</translation>
    </message>
    <message>
        <source>it holds no video that can be shown</source>
        <translation>il ne contient pas de vidéo qui puisse être montrée</translation>
    </message>
    <message>
        <source>it holds {count} streams, expected 1 to {most}</source>
        <translation>il contient {count} flux, attendu&#xa0;: 1 à {most}</translation>
    </message>
    <message>
        <source>it holds {samples} motion samples in {payloads} payloads, as time-lapse recordings do</source>
        <translation>il contient {samples} mesures de mouvement en {payloads} blocs, comme un enregistrement en accéléré</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>il est tronqué</translation>
    </message>
    <message>
        <source>it is not a video or sound file that can be read</source>
        <translation>ce n’est ni une vidéo ni un son qui puisse être lu</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>il est trop grand</translation>
    </message>
    <message>
        <source>it looks like deg/s: multiply gx, gy, gz by 0.0174532925</source>
        <translation>cela ressemble à des °/s&#xa0;: multipliez gx, gy, gz par 0.0174532925</translation>
    </message>
    <message>
        <source>it seems to be in g: multiply it by 9.80665</source>
        <translation>cela semble être en g&#xa0;: multipliez par 9.80665</translation>
    </message>
    <message>
        <source>it did not accept all of the data at {place}</source>
        <translation>il n’a pas pris toutes les données à {place}</translation>
    </message>
    <message>
        <source>its accelerometer and gyro do not overlap in time</source>
        <translation>son accéléromètre et son gyroscope ne se recouvrent pas dans le temps</translation>
    </message>
    <message>
        <source>its accelerometer and gyroscope do not overlap in time</source>
        <translation>son accéléromètre et son gyroscope ne se recouvrent pas dans le temps</translation>
    </message>
    <message>
        <source>its arrays do not belong together</source>
        <translation>ses tableaux ne vont pas ensemble</translation>
    </message>
    <message>
        <source>its axes (MTRX) are not a matrix, so it is damaged</source>
        <translation>ses axes (MTRX) ne sont pas une matrice, elle est donc endommagée</translation>
    </message>
    <message>
        <source>its axes ({axes}) mirror the camera, so the telemetry is damaged</source>
        <translation>ses axes ({axes}) inversent la caméra en miroir, la télémétrie est donc endommagée</translation>
    </message>
    <message>
        <source>its axis {axis} was up, so the sensor was not mounted with {axes} to the right, front and up{words}</source>
        <translation>son axe {axis} était en haut, le capteur n’était donc pas monté avec {axes} vers la droite, l’avant et le haut{words}</translation>
    </message>
    <message>
        <source>its boot processor does not answer</source>
        <translation>son processeur de démarrage ne répond pas</translation>
    </message>
    <message>
        <source>its echo at {place} ended after {count} of {expected} bytes</source>
        <translation>son écho à {place} s’est arrêté après {count} octets sur {expected}</translation>
    </message>
    <message>
        <source>its echo at {place} was wrong</source>
        <translation>son écho à {place} était faux</translation>
    </message>
    <message>
        <source>its entry point {entry:06X} lies in none of its blocks</source>
        <translation>son point d’entrée {entry:06X} n’est dans aucun de ses blocs</translation>
    </message>
    <message>
        <source>its gravity cannot be used</source>
        <translation>sa pesanteur n’est pas utilisable</translation>
    </message>
    <message>
        <source>its gyro file has the norm {norm:.3g} of gravity, its accel file has not: the names are swapped</source>
        <translation>son fichier gyro a la norme {norm:.3g} de la pesanteur, son fichier accel ne l’a pas, les noms sont donc échangés</translation>
    </message>
    <message>
        <source>its headers are damaged</source>
        <translation>ses en-têtes sont endommagés</translation>
    </message>
    <message>
        <source>its index lists more samples than it has bytes</source>
        <translation>son index annonce plus d’échantillons qu’il n’a d’octets</translation>
    </message>
    <message>
        <source>its sound cannot be resampled</source>
        <translation>son son ne peut pas être rééchantillonné</translation>
    </message>
    <message>
        <source>its sound cannot be set up</source>
        <translation>son son ne peut pas être préparé</translation>
    </message>
    <message>
        <source>its sound has {channels} channels at {rate} Hz</source>
        <translation>son son a {channels} canaux à {rate} Hz</translation>
    </message>
    <message>
        <source>its telemetry ({camera}) holds no {kind} samples</source>
        <translation>sa télémétrie ({camera}) ne contient pas de mesures de {kind}</translation>
    </message>
    <message>
        <source>its telemetry claims {largest:.3g} {unit}, beyond what sensors measure</source>
        <translation>sa télémétrie prétend {largest:.3g} {unit}, au-delà de ce que mesurent des capteurs</translation>
    </message>
    <message>
        <source>its telemetry holds no accelerometer samples</source>
        <translation>sa télémétrie ne contient pas de mesures d’accéléromètre</translation>
    </message>
    <message>
        <source>its telemetry is larger than any camera&apos;s (payload {count} has {size_bytes} bytes)</source>
        <translation>sa télémétrie est plus grande que celle de toute caméra (le bloc {count} a {size_bytes} octets)</translation>
    </message>
    <message>
        <source>its telemetry track is damaged</source>
        <translation>sa piste de télémétrie est endommagée</translation>
    </message>
    <message>
        <source>its time stamps run backwards, so it is damaged</source>
        <translation>ses horodatages reculent, elle est donc endommagée</translation>
    </message>
    <message>
        <source>its units are not known</source>
        <translation>ses unités ne sont pas connues</translation>
    </message>
    <message>
        <source>its video cannot be set up</source>
        <translation>sa vidéo ne peut pas être préparée</translation>
    </message>
    <message>
        <source>its {key} is {value!r}, not a number above zero</source>
        <translation>son {key} est {value!r}, pas un nombre supérieur à zéro</translation>
    </message>
    <message>
        <source>lacks {missing}</source>
        <translation>il manque {missing}</translation>
    </message>
    <message>
        <source>leave LSL out</source>
        <translation>laissez LSL de côté</translation>
    </message>
    <message>
        <source>libusb is missing; install the package libusb-1.0-0 (Windows: put libusb-1.0.dll on the path)</source>
        <translation>libusb manque&#xa0;; installez le paquet libusb-1.0-0 (Windows&#xa0;: mettez libusb-1.0.dll dans le chemin de recherche)</translation>
    </message>
    <message>
        <source>line {number}</source>
        <translation>ligne {number}</translation>
    </message>
    <message>
        <source>look for values far beyond what a sensor can measure</source>
        <translation>cherchez des valeurs bien au-delà de ce qu’un capteur peut mesurer</translation>
    </message>
    <message>
        <source>looked for</source>
        <translation>cherché</translation>
    </message>
    <message>
        <source>made telemetry-parser return invalid data ({reason})</source>
        <translation>a fait répondre n’importe quoi à telemetry-parser ({reason})</translation>
    </message>
    <message>
        <source>magnetic field in {unit}</source>
        <translation>champ magnétique en {unit}</translation>
    </message>
    <message>
        <source>mapping axes</source>
        <translation>axes de la correspondance</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>ne peut pas être lu, faute de droits</translation>
    </message>
    <message>
        <source>motion low-passed at {lowpass_hz:g} Hz, zero phase</source>
        <translation>mouvement filtré par un passe-bas à {lowpass_hz:g} Hz, sans déphasage</translation>
    </message>
    <message>
        <source>names a column twice</source>
        <translation>nomme une colonne deux fois</translation>
    </message>
    <message>
        <source>names {count} columns, the table has {total} ({shown})</source>
        <translation>nomme {count} colonnes, le tableau en a {total} ({shown})</translation>
    </message>
    <message>
        <source>no Falcon is plugged in</source>
        <translation>aucun Falcon n’est branché</translation>
    </message>
    <message>
        <source>no Falcon is plugged in; connect its USB cable and its power supply</source>
        <translation>aucun Falcon n’est branché&#xa0;; branchez son câble USB et son alimentation</translation>
    </message>
    <message>
        <source>no Falcon {serial!r} is plugged in; choose one of {known}</source>
        <translation>aucun Falcon {serial!r} n’est branché&#xa0;; il y a&#xa0;: {known}</translation>
    </message>
    <message>
        <source>no leg reaches ({x:.1f}, {y:.1f}, {z:.1f}) mm</source>
        <translation>aucune jambe n’atteint ({x:.1f}, {y:.1f}, {z:.1f}) mm</translation>
    </message>
    <message>
        <source>none of its streams can be decoded, because its headers are damaged</source>
        <translation>aucun de ses flux ne peut être décodé, car ses en-têtes sont endommagés</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>nothing was recorded for {gap_s:.0f} s after {place}</source>
        <translation>rien n’a été enregistré pendant {gap_s:.0f} s après la {place}</translation>
    </message>
    <message>
        <source>give the file or folder of one of them instead</source>
        <translation>rien, mais donnez le fichier ou le dossier de l’un d’eux</translation>
    </message>
    <message>
        <source>AndroSensor</source>
        <translation>AndroSensor</translation>
    </message>
    <message>
        <source>BIDS (behaviour, and motion at 1 kHz)</source>
        <translation>BIDS (comportement, et mouvement à 1 kHz)</translation>
    </message>
    <message>
        <source>RaceChrono</source>
        <translation>RaceChrono</translation>
    </message>
    <message>
        <source>XDF, a file for each run</source>
        <translation>XDF, un fichier par passage</translation>
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
        <translation>sont {count} tableaux ({shown}) qui ne disent pas ce que sont leurs colonnes</translation>
    </message>
    <message>
        <source>begins with {count} NUL bytes</source>
        <translation>commence par {count} octets NUL</translation>
    </message>
    <message>
        <source>convert it to CSV with blackbox_decode</source>
        <translation>convertissez-le en CSV avec blackbox_decode</translation>
    </message>
    <message>
        <source>copy it again, or remove the bytes</source>
        <translation>copiez-le de nouveau, ou supprimez les octets</translation>
    </message>
    <message>
        <source>describes {count} of {total} tables (/ between them)</source>
        <translation>décrit {count} tableaux sur {total} (/ entre eux)</translation>
    </message>
    <message>
        <source>/dev/input/{node}: it has no such force feedback; devices that have: {known}</source>
        <translation>/dev/input/{node}&#xa0;: pas de tel retour de force&#xa0;; appareils qui en ont&#xa0;: {known}</translation>
    </message>
    <message>
        <source>./run sets them up in .venv</source>
        <translation>./run les installe dans .venv</translation>
    </message>
    <message>
        <source>; </source>
        <translation>&#xa0;; </translation>
    </message>
    <message>
        <source>A second or more without motion</source>
        <translation>Une seconde ou plus sans mouvement</translation>
    </message>
    <message>
        <source>A sensor at the end of its range</source>
        <translation>Un capteur au bout de sa plage de mesure</translation>
    </message>
    <message>
        <source>Add yourself to the group input, log out and log in again.</source>
        <translation>Ajoutez-vous au groupe input, puis fermez et rouvrez la session.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Amplitude at the end</source>
        <translation>Amplitude à la fin</translation>
    </message>
    <message>
        <source>Amplitude at the start</source>
        <translation>Amplitude au début</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>Artefact</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Bass shakers or voice coils on a sound output: they vibrate with the force.</source>
        <translation>Vibreurs de basse ou bobines sur une sortie son&#xa0;: ils vibrent avec la force.</translation>
    </message>
    <message>
        <source>Bends with 0.15 g or more sideways</source>
        <translation>Virages d’au moins 0,15 g de côté</translation>
    </message>
    <message>
        <source>Board that takes TCode: its vibration follows the strength of the force, not its direction.</source>
        <translation>Carte qui comprend le TCode&#xa0;: sa vibration suit l’intensité de la force, pas sa direction.</translation>
    </message>
    <message>
        <source>Braking</source>
        <translation>Freinage</translation>
    </message>
    <message>
        <source>Braking at up to {level_mps2:.1f} m/s², {change_mps:.0f} m/s slower</source>
        <translation>Freinage jusqu’à {level_mps2:.1f} m/s², {change_mps:.0f} m/s de moins</translation>
    </message>
    <message>
        <source>Changes only what would push a relaxed hand further than 26 mm from the centre.</source>
        <translation>Ne change que ce qui pousserait une main détendue à plus de 26 mm du centre.</translation>
    </message>
    <message>
        <source>Choose another device: only Linux has this interface.</source>
        <translation>Choisissez un autre appareil&#xa0;: seul Linux a cette interface.</translation>
    </message>
    <message>
        <source>Choose this game in the rig&apos;s software. Packets stay on this computer unless you enter another address.</source>
        <translation>Choisissez ce jeu dans le logiciel de la plateforme. Les paquets restent sur cet ordinateur tant que vous n’entrez pas une autre adresse.</translation>
    </message>
    <message>
        <source>Connect it as its maker says.</source>
        <translation>Branchez-le selon les instructions de son fabricant.</translation>
    </message>
    <message>
        <source>Connect it by cable or by Bluetooth.</source>
        <translation>Branchez-la par câble ou par Bluetooth.</translation>
    </message>
    <message>
        <source>Connect it; if it is connected, its driver is missing or has no such force feedback.</source>
        <translation>Branchez-le&#xa0;; s’il est branché, son pilote manque ou n’a pas ce retour de force.</translation>
    </message>
    <message>
        <source>Connect its USB cable and power supply; it is detected automatically.</source>
        <translation>Branchez le câble USB et l’alimentation&#xa0;; il est détecté automatiquement.</translation>
    </message>
    <message>
        <source>Connect its power supply and its USB cable.</source>
        <translation>Branchez l’alimentation et le câble USB.</translation>
    </message>
    <message>
        <source>Connect the board, and add yourself to the group dialout.</source>
        <translation>Branchez la carte et ajoutez-vous au groupe dialout.</translation>
    </message>
    <message>
        <source>Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the device and plug it in.</source>
        <translation>Copiez la règle udev {rule} dans /etc/udev/rules.d, puis débranchez et rebranchez l’appareil.</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Cubique</translation>
    </message>
    <message>
        <source>Cut-off frequency</source>
        <translation>Fréquence de coupure</translation>
    </message>
    <message>
        <source>Decay time</source>
        <translation>Temps de décroissance</translation>
    </message>
    <message>
        <source>Delayed</source>
        <translation>Retardée</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Modifiée</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>Enter HOST:PORT of a board or program that takes TCode by UDP, or a serial port such as /dev/ttyUSB0.</source>
        <translation>Entrez HOST:PORT d’une carte ou d’un programme qui reçoit le TCode par UDP, ou un port série comme /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>Facing backward, upright</source>
        <translation>Vers l’arrière, à l’endroit</translation>
    </message>
    <message>
        <source>Facing down</source>
        <translation>Vers le bas</translation>
    </message>
    <message>
        <source>Facing forward, left side up</source>
        <translation>Vers l’avant, côté gauche en haut</translation>
    </message>
    <message>
        <source>Facing forward, right side up</source>
        <translation>Vers l’avant, côté droit en haut</translation>
    </message>
    <message>
        <source>Facing forward, upright</source>
        <translation>Vers l’avant, à l’endroit</translation>
    </message>
    <message>
        <source>Facing forward, upside down</source>
        <translation>Vers l’avant, à l’envers</translation>
    </message>
    <message>
        <source>Facing left, upright</source>
        <translation>Vers la gauche, à l’endroit</translation>
    </message>
    <message>
        <source>Facing right, upright</source>
        <translation>Vers la droite, à l’endroit</translation>
    </message>
    <message>
        <source>First sudden rise</source>
        <translation>Première hausse soudaine</translation>
    </message>
    <message>
        <source>For studies: every participant gets nearly the same force, but long pushes are much weaker.</source>
        <translation>Pour les études&#xa0;: tous les participants reçoivent presque la même force, mais les poussées longues sont bien plus faibles.</translation>
    </message>
    <message>
        <source>Force in proportion to the motion, as in the paper.</source>
        <translation>Force proportionnelle au mouvement, comme dans l’article.</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Game pad that Linux can rumble: its vibration follows the strength of the force, not its direction.</source>
        <translation>Manette que Linux peut faire vibrer&#xa0;: la vibration suit l’intensité de la force, pas sa direction.</translation>
    </message>
    <message>
        <source>Given offset</source>
        <translation>Décalage donné</translation>
    </message>
    <message>
        <source>Haply Inverse3: its arm pushes and pulls in three directions.</source>
        <translation>Haply Inverse3&#xa0;: son bras pousse et tire dans trois directions.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service has {count} Inverse3; leave one connected, and choose the device again</source>
        <translation>l’Inverse Service de Haply a {count} Inverse3&#xa0;; n’en laissez qu’un branché, puis choisissez à nouveau l’appareil</translation>
    </message>
    <message>
        <source>High-pass</source>
        <translation>Passe-haut</translation>
    </message>
    <message>
        <source>Hold it loosely.</source>
        <translation>Tenez-le sans serrer.</translation>
    </message>
    <message>
        <source>Hold it with both hands.</source>
        <translation>Tenez-le à deux mains.</translation>
    </message>
    <message>
        <source>Hold it.</source>
        <translation>Tenez-le.</translation>
    </message>
    <message>
        <source>Hold the grip loosely.</source>
        <translation>Tenez la poignée sans serrer.</translation>
    </message>
    <message>
        <source>Impact</source>
        <translation>Choc</translation>
    </message>
    <message>
        <source>Impact of {peak_mps2:.1f} m/s²</source>
        <translation>Choc de {peak_mps2:.1f} m/s²</translation>
    </message>
    <message>
        <source>Impact of {peak_mps2:.1f} m/s², heard too</source>
        <translation>Choc de {peak_mps2:.1f} m/s², entendu aussi</translation>
    </message>
    <message>
        <source>Install the Python package sounddevice.</source>
        <translation>Installez le paquet Python sounddevice.</translation>
    </message>
    <message>
        <source>Intiface</source>
        <translation>Intiface</translation>
    </message>
    <message>
        <source>Intiface has no device that vibrates; connect one in Intiface and choose the device again</source>
        <translation>Intiface n’a aucun appareil qui vibre&#xa0;; connectez-en un dans Intiface et choisissez l’appareil à nouveau</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Inversée</translation>
    </message>
    <message>
        <source>Knock (decaying sine)</source>
        <translation>Choc (sinus amorti)</translation>
    </message>
    <message>
        <source>LabRecorder did not start at port {port} ({reason})</source>
        <translation>LabRecorder n’a pas démarré au port {port} ({reason})</translation>
    </message>
    <message>
        <source>LabRecorder does not answer at port {port} ({reason})</source>
        <translation>LabRecorder ne répond pas au port {port} ({reason})</translation>
    </message>
    <message>
        <source>LabRecorder was closed at port {port} ({reason})</source>
        <translation>LabRecorder a été fermé, port {port} ({reason})</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>Passe-bas</translation>
    </message>
    <message>
        <source>Lying on its back, facing up</source>
        <translation>Sur le dos, vers le haut</translation>
    </message>
    <message>
        <source>MISSING</source>
        <translation>MANQUE</translation>
    </message>
    <message>
        <source>MPEG haptics (ISO/IEC 23090-31), as JSON</source>
        <translation>Haptique MPEG (ISO/CEI 23090-31), en JSON</translation>
    </message>
    <message>
        <source>MPEG-V sensory effects (ISO/IEC 23005-3), as XML</source>
        <translation>Effets sensoriels MPEG-V (ISO/CEI 23005-3), en XML</translation>
    </message>
    <message>
        <source>Missing samples and isolated spikes</source>
        <translation>Échantillons manquants et pics isolés</translation>
    </message>
    <message>
        <source>Motion rig</source>
        <translation>Plateforme de mouvement</translation>
    </message>
    <message>
        <source>Nobody sits on it yet; its emergency stop is at hand.</source>
        <translation>Personne n’y est encore assis&#xa0;; l’arrêt d’urgence est à portée de main.</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Nothing has to be connected.</source>
        <translation>Il n’y a rien à brancher.</translation>
    </message>
    <message>
        <source>Novint Falcon: its grip pushes and pulls in three directions.</source>
        <translation>Novint Falcon&#xa0;: sa poignée pousse et tire dans trois directions.</translation>
    </message>
    <message>
        <source>One of several answers</source>
        <translation>Une réponse parmi plusieurs</translation>
    </message>
    <message>
        <source>OpenCV is installed, but cannot be loaded: {why}</source>
        <translation>OpenCV est installé, mais ne peut pas être chargé&#xa0;: {why}</translation>
    </message>
    <message>
        <source>Other sequence</source>
        <translation>Autre séquence</translation>
    </message>
    <message>
        <source>Own clock</source>
        <translation>Horloge propre</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Impulsion</translation>
    </message>
    <message>
        <source>Python packages</source>
        <translation>Paquets Python</translation>
    </message>
    <message>
        <source>Qt</source>
        <translation>Qt</translation>
    </message>
    <message>
        <source>Qt, with a font</source>
        <translation>Qt, avec une police</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
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
        <translation>Des échantillons manquent</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>Scale of points</source>
        <translation>Échelle de points</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Mise à l’échelle</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Several answers</source>
        <translation>Plusieurs réponses</translation>
    </message>
    <message>
        <source>Shaker</source>
        <translation>Vibreur</translation>
    </message>
    <message>
        <source>Shocks that stand out of what surrounds them</source>
        <translation>Chocs qui ressortent de ce qui les entoure</translation>
    </message>
    <message>
        <source>Shuffled</source>
        <translation>Permutée</translation>
    </message>
    <message>
        <source>Simulated Falcon, held by a simulated hand: for trying everything without hardware.</source>
        <translation>Falcon simulé, tenu par une main simulée&#xa0;: pour tout essayer sans matériel.</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Speed is lost at 0.3 g or more</source>
        <translation>La vitesse baisse à 0,3 g ou plus</translation>
    </message>
    <message>
        <source>Spike of a single sample, as a faulty logger writes</source>
        <translation>Pic d’un seul échantillon, comme en écrit un enregistreur défaillant</translation>
    </message>
    <message>
        <source>Start Haply&apos;s Inverse Service and connect the Inverse3, with its power supply. Enter HOST:PORT if the service runs on another computer.</source>
        <translation>Lancez l’Inverse Service de Haply et branchez l’Inverse3 et son alimentation. Entrez HOST:PORT si le service tourne sur un autre ordinateur.</translation>
    </message>
    <message>
        <source>Start Intiface, start its server and connect what vibrates there.</source>
        <translation>Lancez Intiface et son serveur, puis connectez-y ce qui vibre.</translation>
    </message>
    <message>
        <source>Start the program that passes TCode on to the board.</source>
        <translation>Lancez le programme qui transmet le TCode à la carte.</translation>
    </message>
    <message>
        <source>Start the rig&apos;s software.</source>
        <translation>Lancez le logiciel de la plateforme.</translation>
    </message>
    <message>
        <source>Start {title}.</source>
        <translation>Lancez {title}.</translation>
    </message>
    <message>
        <source>Stillness</source>
        <translation>Immobilité</translation>
    </message>
    <message>
        <source>TCode</source>
        <translation>TCode</translation>
    </message>
    <message>
        <source>The accelerometer is at the end of its range</source>
        <translation>L’accéléromètre est au bout de sa plage de mesure</translation>
    </message>
    <message>
        <source>The frames were compared by the motion vectors of the codec, which is coarse; with hapticplayer[vision] installed they are followed more exactly, those of H.265 too.</source>
        <translation>Les images ont été comparées d’après les vecteurs de mouvement du codec, donc grossièrement&#xa0;; avec hapticplayer[vision] installé, elles sont suivies plus exactement, celles de H.265 aussi.</translation>
    </message>
    <message>
        <source>The gyro is at the end of its range</source>
        <translation>Le gyroscope est au bout de sa plage de mesure</translation>
    </message>
    <message>
        <source>The network does not know this address: correct it.</source>
        <translation>Le réseau ne connaît pas cette adresse&#xa0;: corrigez-la.</translation>
    </message>
    <message>
        <source>The same questions about rides that were filmed by the rider and from outside; whether the force adds as much to both.</source>
        <translation>Les mêmes questions sur des trajets filmés par le conducteur et de l’extérieur&#xa0;; pour savoir si la force apporte autant aux deux.</translation>
    </message>
    <message>
        <source>The sound system does not answer: restart it.</source>
        <translation>Le système audio ne répond pas&#xa0;: redémarrez-le.</translation>
    </message>
    <message>
        <source>Third person against first</source>
        <translation>Troisième personne contre première</translation>
    </message>
    <message>
        <source>This camera does not timestamp its samples: they may be 10 to 30 ms off, and the frames could not tell by how much: {why}.</source>
        <translation>Cette caméra n’horodate pas ses mesures&#xa0;: elles peuvent s’écarter de 10 à 30 ms, et les images ne montrent pas de combien&#xa0;: {why}.</translation>
    </message>
    <message>
        <source>Toys through Intiface: their vibration follows the strength of the force, not its direction.</source>
        <translation>Jouets par Intiface&#xa0;: leur vibration suit l’intensité de la force, pas sa direction.</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Virage</translation>
    </message>
    <message>
        <source>Turn the amplifier low.</source>
        <translation>Baissez l’amplificateur.</translation>
    </message>
    <message>
        <source>Turn to the left with up to {level_mps2:.1f} m/s² for {length_s:.1f} s</source>
        <translation>Virage à gauche jusqu’à {level_mps2:.1f} m/s² pendant {length_s:.1f} s</translation>
    </message>
    <message>
        <source>Turn to the right with up to {level_mps2:.1f} m/s² for {length_s:.1f} s</source>
        <translation>Virage à droite jusqu’à {level_mps2:.1f} m/s² pendant {length_s:.1f} s</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>Jusqu’à</translation>
    </message>
    <message>
        <source>Visual analogue scale</source>
        <translation>Échelle visuelle analogique</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Volant</translation>
    </message>
    <message>
        <source>Wheel or joystick with a motor: it exerts one axis of the force, by default sideways.</source>
        <translation>Volant ou joystick à moteur&#xa0;: il exerce un axe de la force, par défaut le latéral.</translation>
    </message>
    <message>
        <source>a PulseAudio or PipeWire server answers</source>
        <translation>un serveur PulseAudio ou PipeWire répond</translation>
    </message>
    <message>
        <source>a calibration is for the method smoother, not for {method}</source>
        <translation>un étalonnage vaut pour la méthode smoother, pas pour {method}</translation>
    </message>
    <message>
        <source>a feedback cannot be rated like {name!r}; choose one of {known}</source>
        <translation>un retour ne peut pas être noté comme {name!r}&#xa0;; il y a {known}</translation>
    </message>
    <message>
        <source>a keyframe lies outside of any clip</source>
        <translation>une image clé se trouve en dehors de tout clip</translation>
    </message>
    <message>
        <source>a lever arm needs the angular rate of the recording</source>
        <translation>un bras de levier nécessite la vitesse angulaire de l’enregistrement</translation>
    </message>
    <message>
        <source>a matrix of forces is not three numbers a row</source>
        <translation>une matrice de forces n’a pas trois nombres par ligne</translation>
    </message>
    <message>
        <source>a part of the clip fits another part of the log: was the video cut?</source>
        <translation>une partie de la vidéo correspond à une autre partie du journal&#xa0;: la vidéo a-t-elle été coupée&#xa0;?</translation>
    </message>
    <message>
        <source>a rig moves only with the realistic feedback of a sequence that has its motion</source>
        <translation>une plateforme ne bouge qu’avec le retour réaliste d’une séquence qui contient son mouvement</translation>
    </message>
    <message>
        <source>a rig track needs at least one row</source>
        <translation>une piste de plateforme doit avoir au moins une ligne</translation>
    </message>
    <message>
        <source>a row for each change of the force</source>
        <translation>une ligne pour chaque changement de la force</translation>
    </message>
    <message>
        <source>a washout needs a track of straight lines, this one holds</source>
        <translation>un washout demande une piste de lignes droites, celle-ci maintient ses valeurs</translation>
    </message>
    <message>
        <source>accel-axes={accel} rate-axes={rate} if both sensors are {how}</source>
        <translation>accel-axes={accel} rate-axes={rate} si les deux capteurs sont {how}</translation>
    </message>
    <message>
        <source>acceleration was taken times {gain:.2g} N per m/s²</source>
        <translation>l’accélération a été multipliée par {gain:.2g} N par m/s²</translation>
    </message>
    <message>
        <source>add a page that is shown after each clip</source>
        <translation>ajoutez une page affichée après chaque clip</translation>
    </message>
    <message>
        <source>add a sequence</source>
        <translation>ajoutez une séquence</translation>
    </message>
    <message>
        <source>add an answer</source>
        <translation>ajoutez une réponse</translation>
    </message>
    <message>
        <source>add yourself to the group {name}, log in again</source>
        <translation>ajoutez-vous au groupe {name} et reconnectez-vous</translation>
    </message>
    <message>
        <source>allow rtprio {n} and memlock in /etc/security/limits.d</source>
        <translation>autorisez rtprio {n} et memlock dans /etc/security/limits.d</translation>
    </message>
    <message>
        <source>an array is missing or of the wrong kind ({reason})</source>
        <translation>un tableau manque ou n’est pas du bon type ({reason})</translation>
    </message>
    <message>
        <source>an effect lies outside of any clip</source>
        <translation>un effet se trouve en dehors de tout clip</translation>
    </message>
    <message>
        <source>ask for the file again</source>
        <translation>redemandez le fichier</translation>
    </message>
    <message>
        <source>at most {most} effects in a list</source>
        <translation>au plus {most} effets dans une liste</translation>
    </message>
    <message>
        <source>at most {most} markers in a list</source>
        <translation>au plus {most} marqueurs dans une liste</translation>
    </message>
    <message>
        <source>audio of three channels, for transducers</source>
        <translation>audio de trois canaux, pour vibreurs</translation>
    </message>
    <message>
        <source>cannot be compared ({problem})</source>
        <translation>ne peut pas être comparée ({problem})</translation>
    </message>
    <message>
        <source>cannot be copied into {kind} without changing its video</source>
        <translation>ne peut pas être copié en {kind} sans que sa vidéo change</translation>
    </message>
    <message>
        <source>cannot be fetched ({reason})</source>
        <translation>ne peut pas être récupéré ({reason})</translation>
    </message>
    <message>
        <source>cannot be read there ({problem})</source>
        <translation>ne peut pas être lue là-bas ({problem})</translation>
    </message>
    <message>
        <source>cannot be written ({reason}); it is as it was</source>
        <translation>ne peut pas être écrit ({reason})&#xa0;; il est inchangé</translation>
    </message>
    <message>
        <source>channels for {count} parts of the body act on one hand</source>
        <translation>des canaux pour {count} parties du corps agissent sur une main</translation>
    </message>
    <message>
        <source>check its cable and power supply, then test the device</source>
        <translation>vérifiez le câble et l’alimentation, puis testez l’appareil</translation>
    </message>
    <message>
        <source>checking the clip</source>
        <translation>vérification du clip</translation>
    </message>
    <message>
        <source>choose a file that was written by pack</source>
        <translation>choisissez un fichier écrit par pack</translation>
    </message>
    <message>
        <source>choose a larger tolerance, or another format</source>
        <translation>choisissez une plus grande tolérance ou un autre format</translation>
    </message>
    <message>
        <source>choose a lower sample rate, or another format</source>
        <translation>choisissez une fréquence d’échantillonnage plus basse ou un autre format</translation>
    </message>
    <message>
        <source>choose another clip</source>
        <translation>choisissez un autre clip</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>choisissez un autre format</translation>
    </message>
    <message>
        <source>choose another key</source>
        <translation>choisissez une autre clé</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>choisissez un autre nom</translation>
    </message>
    <message>
        <source>choose another track</source>
        <translation>choisissez une autre piste</translation>
    </message>
    <message>
        <source>choose the other kind of file, or convert it to MP4 and import it again</source>
        <translation>choisissez l’autre type de fichier, ou convertissez-le en MP4 et réimportez-le</translation>
    </message>
    <message>
        <source>choose the other kind of file, or convert the clip first</source>
        <translation>choisissez l’autre type de fichier, ou convertissez d’abord le clip</translation>
    </message>
    <message>
        <source>clips play silently, led by the system clock, until there is one</source>
        <translation>les clips sont lus sans son, au rythme de l’horloge du système, tant qu’il n’y en a pas</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>fermez d’autres programmes</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>columns={columns} (as the header suggests; - ignores a column)</source>
        <translation>columns={columns} (comme le suggère l’en-tête&#xa0;; - ignore une colonne)</translation>
    </message>
    <message>
        <source>comes after another value</source>
        <translation>suit une autre valeur</translation>
    </message>
    <message>
        <source>computer stalled</source>
        <translation>ordinateur bloqué</translation>
    </message>
    <message>
        <source>connect it, close this session and resume it</source>
        <translation>connectez-le, fermez cette séance et reprenez-la</translation>
    </message>
    <message>
        <source>contains no motion data</source>
        <translation>ne contient pas de données de mouvement</translation>
    </message>
    <message>
        <source>contents and checksums</source>
        <translation>contenu et sommes de contrôle</translation>
    </message>
    <message>
        <source>convert it to MP4 (H.264 and AAC) and import it again</source>
        <translation>convertissez-la en MP4 (H.264 et AAC) et réimportez-la</translation>
    </message>
    <message>
        <source>copy it from the other machine again; to use what is intact, move its folder into sessions</source>
        <translation>copiez-la encore une fois depuis l’autre ordinateur&#xa0;; pour utiliser ce qui est intact, déplacez son dossier dans sessions</translation>
    </message>
    <message>
        <source>copying the sequence</source>
        <translation>copie de la séquence</translation>
    </message>
    <message>
        <source>copying the sessions</source>
        <translation>copie des séances</translation>
    </message>
    <message>
        <source>correct the file, or remove it</source>
        <translation>corrigez le fichier, ou supprimez-le</translation>
    </message>
    <message>
        <source>cumulative-link mixed model ({link}): likelihood ratio of all feedbacks, pairs by Wald&apos;s t with Holm</source>
        <translation>modèle mixte à lien cumulatif ({link})&#xa0;: rapport de vraisemblance de tous les retours, paires par le t de Wald avec Holm</translation>
    </message>
    <message>
        <source>curve: its times must increase from 0 s</source>
        <translation>curve: ses temps doivent croître à partir de 0 s</translation>
    </message>
    <message>
        <source>curve: {kind} takes {most} points at most</source>
        <translation>curve: {kind} prend au plus {most} points</translation>
    </message>
    <message>
        <source>cut it into parts of some hours</source>
        <translation>découpez-le en parties de quelques heures</translation>
    </message>
    <message>
        <source>date</source>
        <translation>date</translation>
    </message>
    <message>
        <source>device not responding</source>
        <translation>l’appareil ne répond pas</translation>
    </message>
    <message>
        <source>device {name!r}: nothing but gain= can follow; use {kind}</source>
        <translation>appareil {name!r}&#xa0;: seul gain= peut suivre&#xa0;; utilisez {kind}</translation>
    </message>
    <message>
        <source>direction: must be three numbers that are not all zero</source>
        <translation>direction: doit être trois nombres qui ne sont pas tous nuls</translation>
    </message>
    <message>
        <source>display</source>
        <translation>affichage</translation>
    </message>
    <message>
        <source>divides the sequences as another factor does</source>
        <translation>répartit les séquences comme un autre facteur</translation>
    </message>
    <message>
        <source>does not declare its rate</source>
        <translation>n’indique pas sa fréquence</translation>
    </message>
    <message>
        <source>does not fit the definition of its session</source>
        <translation>ne correspond pas à la définition de sa séance</translation>
    </message>
    <message>
        <source>durations were taken as seconds, as in PlaySEM</source>
        <translation>les durées ont été prises en secondes, comme dans PlaySEM</translation>
    </message>
    <message>
        <source>early</source>
        <translation>tôt</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>l’effet</translation>
    </message>
    <message>
        <source>effect {number} ({kind}, from {start_s:g} to {end_s:g} s) is beyond the clip, which lasts {duration_s:.3f} s; move or remove it</source>
        <translation>l’effet {number} ({kind}, de {start_s:g} à {end_s:g} s) est au-delà du clip, qui dure {duration_s:.3f} s&#xa0;; déplacez-le ou enlevez-le</translation>
    </message>
    <message>
        <source>effects</source>
        <translation>effets</translation>
    </message>
    <message>
        <source>end_s: {end_s:g} s must come after start_s ({start_s:g} s), by {most_s:g} s at most</source>
        <translation>end_s: {end_s:g} s doit suivre start_s ({start_s:g} s), de {most_s:g} s au plus</translation>
    </message>
    <message>
        <source>ends before 0 s</source>
        <translation>se termine avant 0 s</translation>
    </message>
    <message>
        <source>enter one, or set it to false</source>
        <translation>saisissez-en un, ou mettez false</translation>
    </message>
    <message>
        <source>error RMS {rms:.4f} N, largest {largest:.4f} N ({compared})</source>
        <translation>erreur RMS {rms:.4f} N, maximale {largest:.4f} N ({compared})</translation>
    </message>
    <message>
        <source>excursions beyond {reach_mm:g} mm</source>
        <translation>les excursions au-delà de {reach_mm:g} mm</translation>
    </message>
    <message>
        <source>export it with semicolons, or with decimal points</source>
        <translation>exportez-le avec des points-virgules, ou avec des points décimaux</translation>
    </message>
    <message>
        <source>export its accelerometer and gyroscope as CSV, with FitCSVTool</source>
        <translation>exportez son accéléromètre et son gyroscope en CSV, avec FitCSVTool</translation>
    </message>
    <message>
        <source>export the accelerometer and the gyroscope too</source>
        <translation>exportez aussi l’accéléromètre et le gyroscope</translation>
    </message>
    <message>
        <source>export the log again, or write that line above the first row</source>
        <translation>exportez de nouveau le journal, ou écrivez cette ligne au-dessus de la première ligne de valeurs</translation>
    </message>
    <message>
        <source>export the log with the digits 0 to 9, as programs in English do</source>
        <translation>exportez le journal avec les chiffres 0 à 9, comme le font les programmes en anglais</translation>
    </message>
    <message>
        <source>export the recording again, or unpack it and give the folder</source>
        <translation>exportez de nouveau l’enregistrement, ou décompressez-le et donnez le dossier</translation>
    </message>
    <message>
        <source>fades: {fades_s:g} s together must fit into the {duration_s:g} s of the effect</source>
        <translation>fades: {fades_s:g} s au total doivent tenir dans les {duration_s:g} s de l’effet</translation>
    </message>
    <message>
        <source>feedback {feedback} has no parameter {name!r}; it has {known}</source>
        <translation>le retour {feedback} n’a pas de paramètre {name!r}&#xa0;; il a {known}</translation>
    </message>
    <message>
        <source>feedback {feedback} has no parameters</source>
        <translation>le retour {feedback} n’a pas de paramètres</translation>
    </message>
    <message>
        <source>finding events</source>
        <translation>recherche d’événements</translation>
    </message>
    <message>
        <source>following frames needs OpenCV, which cannot be loaded ({why})</source>
        <translation>suivre les images demande OpenCV, qui ne peut pas être chargé ({why})</translation>
    </message>
    <message>
        <source>following the frames</source>
        <translation>suivi des images</translation>
    </message>
    <message>
        <source>force for other programs</source>
        <translation>force pour d’autres programmes</translation>
    </message>
    <message>
        <source>force minus {what}: median {middle:+.1f} ms, worst trial {worst:+.1f} ms</source>
        <translation>force moins {what}&#xa0;: médiane {middle:+.1f} ms, pire essai {worst:+.1f} ms</translation>
    </message>
    <message>
        <source>force of the feedback random, lossless</source>
        <translation>force du retour aléatoire, sans perte</translation>
    </message>
    <message>
        <source>force of the feedback realistic, lossless</source>
        <translation>force du retour réaliste, sans perte</translation>
    </message>
    <message>
        <source>force of the feedback {name}, lossless</source>
        <translation>force du retour {name}, sans perte</translation>
    </message>
    <message>
        <source>force track</source>
        <translation>la piste de force</translation>
    </message>
    <message>
        <source>force vector, every millisecond</source>
        <translation>vecteur de force, chaque milliseconde</translation>
    </message>
    <message>
        <source>format</source>
        <translation>le format</translation>
    </message>
    <message>
        <source>frames and gyro agree about one axis only, as those of another ride can</source>
        <translation>les images et le gyroscope ne concordent que sur un seul axe, comme cela arrive avec un autre trajet</translation>
    </message>
    <message>
        <source>frames cannot be compared with the gyroscope at another speed</source>
        <translation>les images ne peuvent pas être comparées au gyroscope à une autre vitesse</translation>
    </message>
    <message>
        <source>free some space or choose a folder on another disk</source>
        <translation>libérez de la place ou choisissez un dossier sur un autre disque</translation>
    </message>
    <message>
        <source>full scale was taken as {full_n:.3g} N</source>
        <translation>la pleine échelle a été prise comme {full_n:.3g} N</translation>
    </message>
    <message>
        <source>gain_n_per_mps2 must be at most {most:g}</source>
        <translation>gain_n_per_mps2 ne doit pas dépasser {most:g}</translation>
    </message>
    <message>
        <source>give &quot;realistic&quot; the parameter &quot;effects&quot;: &quot;off&quot;</source>
        <translation>donnez à &quot;realistic&quot; le paramètre &quot;effects&quot;: &quot;off&quot;</translation>
    </message>
    <message>
        <source>give a recording of sensors that worked</source>
        <translation>donnez un enregistrement dont les capteurs fonctionnaient</translation>
    </message>
    <message>
        <source>give an effects.json</source>
        <translation>donnez un effects.json</translation>
    </message>
    <message>
        <source>give another full scale</source>
        <translation>indiquez une autre pleine échelle</translation>
    </message>
    <message>
        <source>give the folder of one of them instead</source>
        <translation>donnez plutôt le dossier de l’un d’eux</translation>
    </message>
    <message>
        <source>give the sequences different levels</source>
        <translation>donnez aux séquences des niveaux différents</translation>
    </message>
    <message>
        <source>give the times in seconds of media time</source>
        <translation>donnez les temps en secondes du temps du média</translation>
    </message>
    <message>
        <source>give the unit of its numbers, or a recording of a sensor that worked</source>
        <translation>donnez l’unité de ses nombres, ou un enregistrement d’un capteur qui fonctionnait</translation>
    </message>
    <message>
        <source>give times in seconds of media time</source>
        <translation>donnez les temps en secondes du temps du média</translation>
    </message>
    <message>
        <source>gravity turns by {turn_deg:.0f} degrees within 8 s in its accelerometer as its gyroscope does not show: an axis is dead, or the range of one or all another</source>
        <translation>dans son accéléromètre, la pesanteur tourne de {turn_deg:.0f} degrés en 8 s, ce que son gyroscope ne montre pas&#xa0;: un axe est mort, ou la plage d’un axe ou de tous est une autre</translation>
    </message>
    <message>
        <source>grip at the edge of the workspace</source>
        <translation>poignée au bord de l’espace de travail</translation>
    </message>
    <message>
        <source>grip button</source>
        <translation>bouton de la poignée</translation>
    </message>
    <message>
        <source>grip released</source>
        <translation>poignée lâchée</translation>
    </message>
    <message>
        <source>guard process not responding</source>
        <translation>processus de garde sans réponse</translation>
    </message>
    <message>
        <source>gyroscope</source>
        <translation>gyroscope</translation>
    </message>
    <message>
        <source>haptic pattern for iPhones</source>
        <translation>motif haptique pour iPhone</translation>
    </message>
    <message>
        <source>has a row for each reading of one sensor (column {number} holds {names})</source>
        <translation>a une ligne par mesure d’un seul capteur (la colonne {number} contient {names})</translation>
    </message>
    <message>
        <source>has decimal commas between commas: {count} cells below {names} names</source>
        <translation>a des virgules décimales entre des virgules&#xa0;: {count} cellules sous {names} noms</translation>
    </message>
    <message>
        <source>has more than {most_mb} MB of force and motion, which is too much for one file</source>
        <translation>a plus de {most_mb} Mo de force et de mouvement, trop pour un seul fichier</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>n’a pas de valeur</translation>
    </message>
    <message>
        <source>has no yes-or-no question after a clip</source>
        <translation>n’a pas de question à réponse oui ou non après un clip</translation>
    </message>
    <message>
        <source>has numbers in other digits than 0 to 9 ({found})</source>
        <translation>a des nombres en d’autres chiffres que 0 à 9 ({found})</translation>
    </message>
    <message>
        <source>has sent no sample yet</source>
        <translation>n’a encore envoyé aucune mesure</translation>
    </message>
    <message>
        <source>holds NUL bytes, as a logger leaves that loses its power</source>
        <translation>contient des octets NUL, comme en laisse un enregistreur privé de courant</translation>
    </message>
    <message>
        <source>holds a file that no sequence has, {name!r}</source>
        <translation>contient un fichier qu’aucune séquence n’a, {name!r}</translation>
    </message>
    <message>
        <source>holds no force and has none beside it</source>
        <translation>ne contient pas de force et n’en a pas à côté</translation>
    </message>
    <message>
        <source>holds no force that is understood</source>
        <translation>ne contient aucune force comprise</translation>
    </message>
    <message>
        <source>holds no force that is understood ({first})</source>
        <translation>ne contient aucune force comprise ({first})</translation>
    </message>
    <message>
        <source>holds no numbers</source>
        <translation>ne contient pas de nombres</translation>
    </message>
    <message>
        <source>holds no positions</source>
        <translation>ne contient pas de positions</translation>
    </message>
    <message>
        <source>holds no recorded samples</source>
        <translation>ne contient aucun échantillon enregistré</translation>
    </message>
    <message>
        <source>holds no samples</source>
        <translation>ne contient pas d’échantillons</translation>
    </message>
    <message>
        <source>holds no track {name!r}</source>
        <translation>ne contient aucune piste {name!r}</translation>
    </message>
    <message>
        <source>holds the force of a video, not the video</source>
        <translation>contient la force d’une vidéo, pas la vidéo</translation>
    </message>
    <message>
        <source>holds too many values</source>
        <translation>contient trop de valeurs</translation>
    </message>
    <message>
        <source>holds two attachments of one name</source>
        <translation>contient deux pièces jointes du même nom</translation>
    </message>
    <message>
        <source>in test, or being set up</source>
        <translation>en test ou en configuration</translation>
    </message>
    <message>
        <source>in the sequence {key!r}, {one!r} and {other!r} are the same force</source>
        <translation>dans la séquence {key!r}, {one!r} et {other!r} sont la même force</translation>
    </message>
    <message>
        <source>install the program again</source>
        <translation>réinstallez le programme</translation>
    </message>
    <message>
        <source>is a FIT file of a sports watch or cycle computer</source>
        <translation>est un fichier FIT d’une montre de sport ou d’un compteur de vélo</translation>
    </message>
    <message>
        <source>is a blackbox log of a flight controller</source>
        <translation>est un journal blackbox d’un contrôleur de vol</translation>
    </message>
    <message>
        <source>is a table of {program} without the acceleration of three axes</source>
        <translation>est un tableau de {program} sans l’accélération de trois axes</translation>
    </message>
    <message>
        <source>is a zip that is cut off, damaged or followed by other bytes ({reason})</source>
        <translation>est un zip coupé, endommagé ou suivi d’autres octets ({reason})</translation>
    </message>
    <message>
        <source>is a zip with other bytes before it</source>
        <translation>est un zip précédé d’autres octets</translation>
    </message>
    <message>
        <source>is an address, not a file of this machine</source>
        <translation>est une adresse, pas un fichier de cet ordinateur</translation>
    </message>
    <message>
        <source>is an archive that is not a zip</source>
        <translation>est une archive qui n’est pas un zip</translation>
    </message>
    <message>
        <source>is compressed with gzip</source>
        <translation>est compressé avec gzip</translation>
    </message>
    <message>
        <source>is it the log of this clip, and the video not stabilised?</source>
        <translation>est-ce le journal de cette vidéo, et la vidéo n’est-elle pas stabilisée&#xa0;?</translation>
    </message>
    <message>
        <source>is longer there ({count} more records); move the shorter one here out of the study and merge again</source>
        <translation>est plus longue là-bas ({count} entrées de plus)&#xa0;; déplacez hors de l’étude la plus courte, celle d’ici, et fusionnez de nouveau</translation>
    </message>
    <message>
        <source>is not MPEG-V (SEM)</source>
        <translation>n’est pas du MPEG-V (SEM)</translation>
    </message>
    <message>
        <source>is not a SHA-256 checksum</source>
        <translation>n’est pas une somme de contrôle SHA-256</translation>
    </message>
    <message>
        <source>is not a WAV file</source>
        <translation>n’est pas un fichier WAV</translation>
    </message>
    <message>
        <source>is not a calibration of a sensor</source>
        <translation>n’est pas l’étalonnage d’un capteur</translation>
    </message>
    <message>
        <source>is not a list of effects</source>
        <translation>n’est pas une liste d’effets</translation>
    </message>
    <message>
        <source>is not a template for logs (it must hold texts for {known})</source>
        <translation>n’est pas un modèle de journal (il peut contenir des textes pour {known})</translation>
    </message>
    <message>
        <source>is not overwritten, because it is not such a file written by hapticplayer</source>
        <translation>n’est pas remplacé, car ce n’est pas un tel fichier écrit par hapticplayer</translation>
    </message>
    <message>
        <source>is not valid XML ({reason})</source>
        <translation>n’est pas du XML valide ({reason})</translation>
    </message>
    <message>
        <source>is only used after a clip</source>
        <translation>n’est utilisé qu’après un clip</translation>
    </message>
    <message>
        <source>is too large (limit: {most_bytes} bytes)</source>
        <translation>est trop grand (limite&#xa0;: {most_bytes} octets)</translation>
    </message>
    <message>
        <source>is truncated in its header</source>
        <translation>est tronqué dans son en-tête</translation>
    </message>
    <message>
        <source>it has more than {most} boxes</source>
        <translation>elle a plus de {most} boîtes</translation>
    </message>
    <message>
        <source>it is a time lapse or TimeWarp (GoPro&apos;s rate: {rate})</source>
        <translation>c’est un accéléré ou un TimeWarp (cadence de la GoPro&#xa0;: {rate})</translation>
    </message>
    <message>
        <source>its attachments are too large (limit: {most_mb} MB in {files} files)</source>
        <translation>ses pièces jointes sont trop grandes (limite&#xa0;: {most_mb} Mo en {files} fichiers)</translation>
    </message>
    <message>
        <source>its beginning is hidden by an edit list, which no copy keeps</source>
        <translation>son début est masqué par une liste de montage, qu’aucune copie ne garde</translation>
    </message>
    <message>
        <source>its gyroscope does not turn as the camera in the frames of the clip</source>
        <translation>son gyroscope ne tourne pas comme la caméra dans les images du clip</translation>
    </message>
    <message>
        <source>its headers are too large</source>
        <translation>ses en-têtes sont trop grands</translation>
    </message>
    <message>
        <source>its lines end with CR alone</source>
        <translation>ses lignes se terminent par CR seul</translation>
    </message>
    <message>
        <source>its positions of {axis} go from 0 to 1, but a funscript&apos;s go to 100</source>
        <translation>ses positions de {axis} vont de 0 à 1, mais celles d’un funscript vont jusqu’à 100</translation>
    </message>
    <message>
        <source>its streams cannot be copied into {kind}</source>
        <translation>ses flux ne peuvent pas être copiés en {kind}</translation>
    </message>
    <message>
        <source>its telemetry has no usable timestamps and too few payloads ({count}) to tell the rate of its sensors</source>
        <translation>la télémétrie n’a pas d’horodatage utilisable et trop peu de blocs ({count}) pour déterminer la fréquence de ses capteurs</translation>
    </message>
    <message>
        <source>its times of {axis} look like seconds, but a funscript&apos;s are milliseconds</source>
        <translation>ses temps de {axis} semblent être des secondes, mais ceux d’un funscript sont des millisecondes</translation>
    </message>
    <message>
        <source>its video ({codec}) holds no motion vectors that can be read</source>
        <translation>sa vidéo ({codec}) ne contient pas de vecteurs de mouvement lisibles</translation>
    </message>
    <message>
        <source>its video cannot be read</source>
        <translation>sa vidéo ne peut pas être lue</translation>
    </message>
    <message>
        <source>kind of event</source>
        <translation>le type d’événement</translation>
    </message>
    <message>
        <source>lacks what is to be exported</source>
        <translation>ne contient pas ce qu’il faut exporter</translation>
    </message>
    <message>
        <source>levels, and differences of feedbacks at two levels: Wilcoxon with Holm over all, exact to {most} participants, then an approximation</source>
        <translation>niveaux, et différences entre retours à deux niveaux&#xa0;: Wilcoxon avec Holm sur l’ensemble, exact jusqu’à {most} participants, approché au-delà</translation>
    </message>
    <message>
        <source>make another of it with: {command}</source>
        <translation>faites-en un autre avec&#xa0;: {command}</translation>
    </message>
    <message>
        <source>mapping axes must be a rotation (orthogonal, determinant +1)</source>
        <translation>les axes de la correspondance doivent être une rotation (orthogonale, déterminant +1)</translation>
    </message>
    <message>
        <source>method</source>
        <translation>la méthode</translation>
    </message>
    <message>
        <source>missing: {names}</source>
        <translation>manquants&#xa0;: {names}</translation>
    </message>
    <message>
        <source>motion beside the force was left out ({count})</source>
        <translation>le mouvement à côté de la force a été laissé de côté ({count})</translation>
    </message>
    <message>
        <source>motion scene</source>
        <translation>la scène de mouvement</translation>
    </message>
    <message>
        <source>motion without gravity</source>
        <translation>mouvement sans pesanteur</translation>
    </message>
    <message>
        <source>mounting {text!r} not found; choose one of {known}, or give right, front and up of the wearer in the recorder&apos;s axes</source>
        <translation>il n’y a pas de fixation {text!r}&#xa0;; choisissez parmi {known}, ou donnez la droite, l’avant et le haut du porteur dans les axes de l’enregistreur</translation>
    </message>
    <message>
        <source>multiply it by {scale:.9g} in the log, or take the taps alone</source>
        <translation>multipliez-la par {scale:.9g} dans le journal, ou prenez les tapotements seuls</translation>
    </message>
    <message>
        <source>multiply its positions by 100</source>
        <translation>multipliez ses positions par 100</translation>
    </message>
    <message>
        <source>multiply its times by 1000</source>
        <translation>multipliez ses temps par 1000</translation>
    </message>
    <message>
        <source>must be a list of one or more of the choices</source>
        <translation>doit être une liste d’une ou de plusieurs des réponses proposées</translation>
    </message>
    <message>
        <source>must be a number from {least} to {most}</source>
        <translation>doit être un nombre de {least} à {most}</translation>
    </message>
    <message>
        <source>must be at least {limit}</source>
        <translation>doit être au moins {limit}</translation>
    </message>
    <message>
        <source>must be at most {limit}</source>
        <translation>doit être au plus {limit}</translation>
    </message>
    <message>
        <source>must be between {least} and {most}</source>
        <translation>doit être compris entre {least} et {most}</translation>
    </message>
    <message>
        <source>must be the two opposites, at {least} and at {most}</source>
        <translation>doit donner les deux contraires, à {least} et à {most}</translation>
    </message>
    <message>
        <source>must have 2 to {most} levels, has {count}</source>
        <translation>doit avoir 2 à {most} niveaux, et en a {count}</translation>
    </message>
    <message>
        <source>must have 2 to {most} points, has {count}</source>
        <translation>doit donner 2 à {most} points, et en donne {count}</translation>
    </message>
    <message>
        <source>must have at least {limit} characters</source>
        <translation>doit avoir au moins {limit} caractères</translation>
    </message>
    <message>
        <source>must have at least {limit} entries</source>
        <translation>doit avoir au moins {limit} entrées</translation>
    </message>
    <message>
        <source>must have at most {limit} characters</source>
        <translation>doit avoir au plus {limit} caractères</translation>
    </message>
    <message>
        <source>must have at most {limit} entries</source>
        <translation>doit avoir au plus {limit} entrées</translation>
    </message>
    <message>
        <source>must have {limit} entries</source>
        <translation>doit avoir {limit} entrées</translation>
    </message>
    <message>
        <source>name of a track, from a file</source>
        <translation>nom d’une piste, tiré d’un fichier</translation>
    </message>
    <message>
        <source>name: must have 1 to {most} characters in one line</source>
        <translation>name&#xa0;: doit avoir 1 à {most} caractères sur une seule ligne</translation>
    </message>
    <message>
        <source>names a part of {axes}</source>
        <translation>ne nomme qu’une partie de {axes}</translation>
    </message>
    <message>
        <source>needs a second sequence, whose force is felt</source>
        <translation>demande une deuxième séquence, dont la force est ressentie</translation>
    </message>
    <message>
        <source>neither DISPLAY nor WAYLAND_DISPLAY is set</source>
        <translation>ni DISPLAY ni WAYLAND_DISPLAY n’est défini</translation>
    </message>
    <message>
        <source>neither a sound server nor a sound card</source>
        <translation>ni serveur de son ni carte son</translation>
    </message>
    <message>
        <source>no device with such force feedback is plugged in; connect it, and see whether its driver is loaded</source>
        <translation>aucun appareil avec un tel retour de force n’est branché&#xa0;; branchez-le et vérifiez que son pilote est chargé</translation>
    </message>
    <message>
        <source>no direction in the file: x {x:.2f}, y {y:.2f}, z {z:.2f}</source>
        <translation>pas de direction dans le fichier&#xa0;: x {x:.2f}, y {y:.2f}, z {z:.2f}</translation>
    </message>
    <message>
        <source>no effect is switched on for this clip; add one to its sequence, or give the name of an edited track</source>
        <translation>aucun effet n’est activé pour ce clip&#xa0;; ajoutez-en un à sa séquence, ou donnez le nom d’une piste modifiée</translation>
    </message>
    <message>
        <source>no estimated bounce: two halves of the points do not agree on it, or it is wilder than any gait</source>
        <translation>pas de rebond estimé&#xa0;: deux moitiés des points ne s’accordent pas, ou il est plus violent que toute allure</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>aucune force</translation>
    </message>
    <message>
        <source>no motion can be estimated from its picture ({why})</source>
        <translation>aucun mouvement ne peut être estimé d’après son image ({why})</translation>
    </message>
    <message>
        <source>no offset is given, which this method needs</source>
        <translation>aucun décalage n’est donné, alors que cette méthode en demande un</translation>
    </message>
    <message>
        <source>no trial begins: {device} was lost ({reason})</source>
        <translation>aucun essai ne commence&#xa0;: {device} a été perdu ({reason})</translation>
    </message>
    <message>
        <source>nobody feels a simulated device: choose a real one, or allow sessions without one (first page of the study editor)</source>
        <translation>personne ne sent un appareil simulé&#xa0;: choisissez-en un réel, ou autorisez des séances sans appareil (première page de l’éditeur)</translation>
    </message>
    <message>
        <source>nobody listens at {address}: start the rig&apos;s software</source>
        <translation>personne n’écoute à {address}&#xa0;: lancez le logiciel de la plateforme</translation>
    </message>
    <message>
        <source>none on USB</source>
        <translation>aucun sur USB</translation>
    </message>
    <message>
        <source>not read: {what} ({count})</source>
        <translation>non lu&#xa0;: {what} ({count})</translation>
    </message>
    <message>
        <source>nothing is being recorded: {reason}</source>
        <translation>rien n’est enregistré&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>nothing takes TCode at {where} any more; connect it and choose the device again</source>
        <translation>plus rien n’accepte TCode à {where}&#xa0;; branchez-le et choisissez l’appareil à nouveau</translation>
    </message>
    <message>
        <source>offset {offset_s} s with rate {rate} is not a valid clock map; give finite numbers and a positive rate</source>
        <translation>le décalage {offset_s} s avec la cadence {rate} ne met pas les horloges en correspondance&#xa0;; donnez des nombres finis et une cadence positive</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>one gap</source>
        <translation>une lacune</translation>
    </message>
    <message>
        <source>only {count} of {total} rows hold both specific force and angular rate</source>
        <translation>seulement {count} lignes sur {total} contiennent à la fois la force spécifique et la vitesse angulaire</translation>
    </message>
    <message>
        <source>only {count} of {total} times can be used</source>
        <translation>seulement {count} temps sur {total} sont utilisables</translation>
    </message>
    <message>
        <source>only {share:.0%} of its samples are whole</source>
        <translation>seulement {share:.0%} de ses mesures sont entières</translation>
    </message>
    <message>
        <source>open its sequence first, then the log</source>
        <translation>ouvrez d’abord sa séquence, puis le journal</translation>
    </message>
    <message>
        <source>open the video of that name, which lies beside it</source>
        <translation>ouvrez la vidéo de ce nom, qui se trouve à côté</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>order {order} has a condition twice</source>
        <translation>l’ordre {order} a une condition deux fois</translation>
    </message>
    <message>
        <source>order {order} has two trials at position {position}</source>
        <translation>l’ordre {order} a deux essais à la position {position}</translation>
    </message>
    <message>
        <source>order {order} lacks {conditions}</source>
        <translation>dans l’ordre {order}, il manque {conditions}</translation>
    </message>
    <message>
        <source>order {order} plays {sequence} twice in a row</source>
        <translation>l’ordre {order} joue {sequence} deux fois de suite</translation>
    </message>
    <message>
        <source>other offsets fit nearly as well</source>
        <translation>d’autres décalages conviennent presque aussi bien</translation>
    </message>
    <message>
        <source>parts of the clip give different offsets</source>
        <translation>des parties du clip donnent des décalages différents</translation>
    </message>
    <message>
        <source>port {port} cannot be opened ({reason}); end what listens there</source>
        <translation>le port {port} ne peut pas être ouvert ({reason})&#xa0;; fermez ce qui y écoute</translation>
    </message>
    <message>
        <source>position lies outside of any clip</source>
        <translation>la position se trouve en dehors de tout clip</translation>
    </message>
    <message>
        <source>positions of a hand, for motion devices</source>
        <translation>positions d’une main, pour appareils de mouvement</translation>
    </message>
    <message>
        <source>positions were taken as the set-point of a spring of {stiffness:.3g} N/m, with the hand at the centre</source>
        <translation>les positions ont été prises comme consigne d’un ressort de {stiffness:.3g} N/m, la main au centre</translation>
    </message>
    <message>
        <source>positions, no newtons</source>
        <translation>positions, pas de newtons</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>le préréglage</translation>
    </message>
    <message>
        <source>rate-axes={axes} if the gyroscope is {how}</source>
        <translation>rate-axes={axes} si le gyroscope est {how}</translation>
    </message>
    <message>
        <source>ratings are shown without the force: {reason}</source>
        <translation>les évaluations sont affichées sans la force&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>read as {name}: specific force in {unit}</source>
        <translation>lu comme {name}&#xa0;: force spécifique en {unit}</translation>
    </message>
    <message>
        <source>read by telemetry-parser; its timestamps are those of a mean rate</source>
        <translation>lu par telemetry-parser&#xa0;; ses temps sont ceux d’une cadence moyenne</translation>
    </message>
    <message>
        <source>read from</source>
        <translation>lu</translation>
    </message>
    <message>
        <source>reading records of {code}</source>
        <translation>lecture des enregistrements de {code}</translation>
    </message>
    <message>
        <source>reading the copy</source>
        <translation>lecture de la copie</translation>
    </message>
    <message>
        <source>reading the sequence</source>
        <translation>lecture de la séquence</translation>
    </message>
    <message>
        <source>reading the sound</source>
        <translation>lecture du son</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>record again with the gravity sensor</source>
        <translation>enregistrez encore une fois avec le capteur de pesanteur</translation>
    </message>
    <message>
        <source>record at least {least} s</source>
        <translation>enregistrez au moins {least} s</translation>
    </message>
    <message>
        <source>record both at once</source>
        <translation>enregistrez les deux à la fois</translation>
    </message>
    <message>
        <source>record damaged</source>
        <translation>enregistrement endommagé</translation>
    </message>
    <message>
        <source>record normal video</source>
        <translation>filmez en vidéo normale</translation>
    </message>
    <message>
        <source>record the gravity sensor (iOS) or total acceleration (Android)</source>
        <translation>enregistrez le capteur de pesanteur (iOS) ou l’accélération totale (Android)</translation>
    </message>
    <message>
        <source>record the gyroscope too</source>
        <translation>enregistrez aussi le gyroscope</translation>
    </message>
    <message>
        <source>record with a camera that stores its motion, or give an IMU log</source>
        <translation>filmez avec une caméra qui enregistre son mouvement, ou donnez un journal d’IMU</translation>
    </message>
    <message>
        <source>recorded samples</source>
        <translation>échantillons enregistrés</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>détendue</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>retirez-en un</translation>
    </message>
    <message>
        <source>remove or complete the line</source>
        <translation>enlevez ou complétez la ligne</translation>
    </message>
    <message>
        <source>remove the line or correct the number</source>
        <translation>enlevez la ligne ou corrigez le nombre</translation>
    </message>
    <message>
        <source>remux it to MP4 so that its duration is written</source>
        <translation>remettez-la en MP4 pour que sa durée soit inscrite</translation>
    </message>
    <message>
        <source>repeat the one before and were left out</source>
        <translation>répètent la précédente et ont été omises</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>se répète</translation>
    </message>
    <message>
        <source>ride</source>
        <translation>le trajet</translation>
    </message>
    <message>
        <source>row {number}</source>
        <translation>ligne {number}</translation>
    </message>
    <message>
        <source>run a participant</source>
        <translation>faites passer un participant</translation>
    </message>
    <message>
        <source>run a participant first</source>
        <translation>faites d’abord passer un participant</translation>
    </message>
    <message>
        <source>samples have the shape {shape}, expected N x 3</source>
        <translation>les échantillons ont la forme {shape}, attendu N x 3</translation>
    </message>
    <message>
        <source>sampling must be averaged or instant</source>
        <translation>sampling est averaged ou instant</translation>
    </message>
    <message>
        <source>save it as text in UTF-8</source>
        <translation>enregistrez-le comme texte en UTF-8</translation>
    </message>
    <message>
        <source>say what it is</source>
        <translation>dites ce que c’est</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>la scène</translation>
    </message>
    <message>
        <source>see whether it is switched on</source>
        <translation>vérifiez qu’il est allumé</translation>
    </message>
    <message>
        <source>see whether the toy is connected and charged</source>
        <translation>vérifiez que l’appareil est connecté et chargé</translation>
    </message>
    <message>
        <source>sends another part than was asked for</source>
        <translation>envoie une autre partie que celle demandée</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>le capteur</translation>
    </message>
    <message>
        <source>sequence</source>
        <translation>la séquence</translation>
    </message>
    <message>
        <source>session {code} cannot be used: {what}</source>
        <translation>la séance {code} n’est pas utilisable&#xa0;: {what}</translation>
    </message>
    <message>
        <source>session {code} is {state}</source>
        <translation>la séance {code} est {state}</translation>
    </message>
    <message>
        <source>set up</source>
        <translation>préparé</translation>
    </message>
    <message>
        <source>shaker:{text}: {count} channels need one band, or one each, and each channel once</source>
        <translation>shaker:{text}&#xa0;: {count} canaux demandent une bande, ou une chacun, et chaque canal une fois</translation>
    </message>
    <message>
        <source>share it without the motion, or copy its folder</source>
        <translation>partagez-la sans le mouvement, ou copiez son dossier</translation>
    </message>
    <message>
        <source>share the time of another and were averaged with it</source>
        <translation>partagent le temps d’une autre et ont été moyennées avec elle</translation>
    </message>
    <message>
        <source>sigma and trust of an estimated motion</source>
        <translation>sigma et confiance d’un mouvement estimé</translation>
    </message>
    <message>
        <source>simulated camera</source>
        <translation>caméra simulée</translation>
    </message>
    <message>
        <source>size of the force, every millisecond</source>
        <translation>norme de la force, chaque milliseconde</translation>
    </message>
    <message>
        <source>smooth noise below 0.5 Hz, with the RMS of the realistic force</source>
        <translation>bruit lisse au-dessous de 0,5 Hz, de même valeur efficace que la force réaliste</translation>
    </message>
    <message>
        <source>soft_knee_n must be below force_limit_n, got {knee_n} and {limit_n}</source>
        <translation>soft_knee_n doit être inférieur à force_limit_n, reçu {knee_n} et {limit_n}</translation>
    </message>
    <message>
        <source>sort the rows by time or cut the recording there</source>
        <translation>triez les lignes par temps ou coupez l’enregistrement à cet endroit</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>son</translation>
    </message>
    <message>
        <source>sound above {limit_hz} Hz was left out</source>
        <translation>le son au-dessus de {limit_hz} Hz a été omis</translation>
    </message>
    <message>
        <source>sound through PulseAudio or PipeWire</source>
        <translation>son par PulseAudio ou PipeWire</translation>
    </message>
    <message>
        <source>specific force is acceleration plus the phone&apos;s gravity estimate</source>
        <translation>la force spécifique est l’accélération plus la pesanteur que donne le téléphone</translation>
    </message>
    <message>
        <source>start from a desktop session</source>
        <translation>démarrez depuis une session de bureau</translation>
    </message>
    <message>
        <source>starts at {time_s:.3f} s, but the clip ends at {duration_s:.3f} s</source>
        <translation>commence à {time_s:.3f} s, mais le clip finit à {duration_s:.3f} s</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>coupée</translation>
    </message>
    <message>
        <source>stopped by a button on the grip</source>
        <translation>arrêté par un bouton de la poignée</translation>
    </message>
    <message>
        <source>stopped, for the grip is more than 30 mm from the middle</source>
        <translation>arrêté&#xa0;: la poignée est à plus de 30 mm du centre</translation>
    </message>
    <message>
        <source>stopped, for the grip was faster than 0.5 m/s</source>
        <translation>arrêté&#xa0;: la poignée a dépassé 0,5 m/s</translation>
    </message>
    <message>
        <source>switch the Euler output of the board off and record again</source>
        <translation>désactivez la sortie d’Euler de la carte et enregistrez encore une fois</translation>
    </message>
    <message>
        <source>switch the board to its sensor output (#osct with Razor-AHRS)</source>
        <translation>mettez la carte en sortie de capteurs (#osct avec Razor-AHRS)</translation>
    </message>
    <message>
        <source>synchronising by frames is coarse, no motion is suggested from the frames</source>
        <translation>la synchronisation par les images est grossière, aucun mouvement n’est suggéré d’après les images</translation>
    </message>
    <message>
        <source>take another sequence, or add &apos;estimated&apos; to feedbacks</source>
        <translation>prenez une autre séquence, ou ajoutez &apos;estimated&apos; à feedbacks</translation>
    </message>
    <message>
        <source>telemetry is nested deeper than {levels} levels, so it is damaged</source>
        <translation>la télémétrie est imbriquée sur plus de {levels} niveaux, elle est donc endommagée</translation>
    </message>
    <message>
        <source>template</source>
        <translation>le modèle</translation>
    </message>
    <message>
        <source>text answers</source>
        <translation>réponses en texte libre</translation>
    </message>
    <message>
        <source>the Falcon</source>
        <translation>le Falcon</translation>
    </message>
    <message>
        <source>the Falcon answered none of the frames; home it, try again</source>
        <translation>le Falcon n’a répondu à aucun message&#xa0;; référencez-le et réessayez</translation>
    </message>
    <message>
        <source>the Falcon could not be {done} ({reason}); unplug it and plug it in again</source>
        <translation>le Falcon n’a pas pu être {done} ({reason})&#xa0;; débranchez-le et rebranchez-le</translation>
    </message>
    <message>
        <source>the Falcon did not answer after the silence; try again</source>
        <translation>le Falcon n’a pas répondu après la pause&#xa0;; réessayez</translation>
    </message>
    <message>
        <source>the Falcon did not start in {attempts} attempts (the last: {reason}); unplug its power and USB, plug both in, if you can without a hub, and try again</source>
        <translation>le Falcon n’a pas démarré en {attempts} tentatives (la dernière&#xa0;: {reason})&#xa0;; débranchez son alimentation et son USB, rebranchez les deux, si possible sans concentrateur, et réessayez</translation>
    </message>
    <message>
        <source>the Falcon does not answer any more; unplug its power and USB, and plug both in</source>
        <translation>le Falcon ne répond plus&#xa0;; débranchez son alimentation et son USB, puis rebranchez les deux</translation>
    </message>
    <message>
        <source>the Falcon does not answer; unplug its power and USB, and plug both in</source>
        <translation>le Falcon ne répond pas&#xa0;; débranchez son alimentation et son USB, puis rebranchez les deux</translation>
    </message>
    <message>
        <source>the Falcon has a driver that keeps libusb out; give it the driver WinUSB (with the program Zadig) in place of FTDI&apos;s or Force Dimension&apos;s</source>
        <translation>le Falcon a un pilote qui écarte libusb&#xa0;; donnez-lui le pilote WinUSB (avec le programme Zadig) à la place de celui de FTDI ou de Force Dimension</translation>
    </message>
    <message>
        <source>the Falcon is in use by another program; close that one and try again</source>
        <translation>le Falcon est utilisé par un autre programme&#xa0;; fermez-le et réessayez</translation>
    </message>
    <message>
        <source>the Falcon is not open; choose the device again</source>
        <translation>le Falcon n’est pas ouvert&#xa0;; choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>permission denied for the Falcon; copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and plug it in</source>
        <translation>vous n’avez pas le droit d’utiliser le Falcon&#xa0;; copiez la règle udev {rule} dans /etc/udev/rules.d, puis débranchez et rebranchez le Falcon</translation>
    </message>
    <message>
        <source>the Falcon was not homed within {limit_s:.0f} s; pull the grip all the way out, push it all the way in until it locks, and try again</source>
        <translation>le Falcon n’a pas trouvé son zéro en {limit_s:.0f} s&#xa0;; tirez la poignée à fond, poussez-la à fond jusqu’à ce qu’elle se bloque, et réessayez</translation>
    </message>
    <message>
        <source>the Falcon was unplugged, or its cable is loose; plug it in and choose the device again</source>
        <translation>le Falcon a été débranché, ou son câble est desserré&#xa0;; rebranchez-le et choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the Falcon&apos;s position has jumped and stayed away; home it again, then choose the device again</source>
        <translation>la position du Falcon a sauté et n’est pas revenue&#xa0;; faites-lui retrouver son zéro, puis choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the IMU&apos;s axes</source>
        <translation>axes de l’IMU</translation>
    </message>
    <message>
        <source>the Inverse3 is not open; choose the device again</source>
        <translation>l’Inverse3 n’est pas ouvert&#xa0;; choisissez-le à nouveau</translation>
    </message>
    <message>
        <source>the angular rate is zero throughout, so no rotation is assumed</source>
        <translation>la vitesse angulaire est partout nulle, aucune rotation n’est donc supposée</translation>
    </message>
    <message>
        <source>the angular rate reaches {largest:.3g} rad/s when it is read in {rate_unit}, which no sensor shows</source>
        <translation>la vitesse angulaire atteint {largest:.3g} rad/s quand elle est lue en {rate_unit}, ce qu’aucun capteur ne montre</translation>
    </message>
    <message>
        <source>the answer could not be saved ({reason})</source>
        <translation>la réponse n’a pas pu être enregistrée ({reason})</translation>
    </message>
    <message>
        <source>the answer ended early</source>
        <translation>la réponse s’est terminée trop tôt</translation>
    </message>
    <message>
        <source>the axes {text!r} mirror the motion; change one sign</source>
        <translation>les axes {text!r} inversent le mouvement en miroir&#xa0;; changez un signe</translation>
    </message>
    <message>
        <source>the board&apos;s axes</source>
        <translation>axes de la carte</translation>
    </message>
    <message>
        <source>the calibration is of {theirs}, the recording of {ours}; a calibration helps only if both are one sensor</source>
        <translation>l’étalonnage vient de {theirs}, l’enregistrement de {ours}&#xa0;; un étalonnage n’aide que si les deux viennent du même capteur</translation>
    </message>
    <message>
        <source>the camera rotates too slowly to show the time</source>
        <translation>la caméra tourne trop lentement pour indiquer le temps</translation>
    </message>
    <message>
        <source>the chip&apos;s axes</source>
        <translation>axes de la puce</translation>
    </message>
    <message>
        <source>the computer stalled repeatedly; close other programs, measure again</source>
        <translation>l’ordinateur s’est figé à plusieurs reprises&#xa0;; fermez les autres programmes et mesurez à nouveau</translation>
    </message>
    <message>
        <source>the cutoff</source>
        <translation>la fréquence de coupure</translation>
    </message>
    <message>
        <source>the device is not homed or not ready; set it up first</source>
        <translation>l’appareil n’est pas initialisé ou pas prêt&#xa0;; configurez-le d’abord</translation>
    </message>
    <message>
        <source>the device is not open; choose the device again</source>
        <translation>l’appareil n’est pas ouvert&#xa0;; choisissez-le à nouveau</translation>
    </message>
    <message>
        <source>the excursion that a normal hand would make; no newtons</source>
        <translation>l’excursion que ferait une main normale&#xa0;; pas de newtons</translation>
    </message>
    <message>
        <source>the experiment was paused; its clock skips the pause</source>
        <translation>l’expérience a été mise en pause&#xa0;; son horloge a continué sans la pause</translation>
    </message>
    <message>
        <source>the file ends at byte {size_bytes} but its header promises {promised_bytes}</source>
        <translation>le fichier finit à l’octet {size_bytes}, mais son en-tête en promet {promised_bytes}</translation>
    </message>
    <message>
        <source>the file ends at byte {size_bytes} but its index needs {indexed_bytes}</source>
        <translation>le fichier finit à l’octet {size_bytes}, mais son index en demande {indexed_bytes}</translation>
    </message>
    <message>
        <source>the file was removed</source>
        <translation>le fichier a été supprimé</translation>
    </message>
    <message>
        <source>the firmware was loaded and does not answer</source>
        <translation>le micrologiciel a été chargé et ne répond pas</translation>
    </message>
    <message>
        <source>the firmware&apos;s axes: x forward, y right, z down</source>
        <translation>axes du micrologiciel&#xa0;: x devant, y à droite, z en bas</translation>
    </message>
    <message>
        <source>the folder was replaced</source>
        <translation>le dossier a été remplacé</translation>
    </message>
    <message>
        <source>the force in newtons at every millisecond</source>
        <translation>la force en newtons à chaque milliseconde</translation>
    </message>
    <message>
        <source>the force in newtons on three axes, within the tolerance</source>
        <translation>la force en newtons sur trois axes, dans la tolérance</translation>
    </message>
    <message>
        <source>the force in newtons, at the sample rate</source>
        <translation>la force en newtons, à la fréquence d’échantillonnage</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms ahead of the sound: the computer may be overloaded; close other programs</source>
        <translation>la force a {ms:.0f} ms d’avance sur le son&#xa0;: l’ordinateur est peut-être surchargé&#xa0;; fermez d’autres programmes</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms ahead of the video: the computer may be overloaded; close other programs</source>
        <translation>la force est en avance de {ms:.0f} ms sur la vidéo&#xa0;: l’ordinateur est peut-être surchargé&#xa0;; fermez d’autres programmes</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms behind the sound: the computer may be overloaded; close other programs</source>
        <translation>la force est en retard de {ms:.0f} ms sur le son&#xa0;: l’ordinateur est peut-être surchargé&#xa0;; fermez d’autres programmes</translation>
    </message>
    <message>
        <source>the force is {ms:.0f} ms behind the video: the computer may be overloaded; close other programs</source>
        <translation>la force est en retard de {ms:.0f} ms sur la vidéo&#xa0;: l’ordinateur est peut-être surchargé&#xa0;; fermez d’autres programmes</translation>
    </message>
    <message>
        <source>the force of a motion that was estimated from the picture</source>
        <translation>la force d’un mouvement estimé d’après l’image</translation>
    </message>
    <message>
        <source>the force of the recorded motion</source>
        <translation>la force du mouvement enregistré</translation>
    </message>
    <message>
        <source>the force track goes from {first_s:.6g} s to {last_s:.6g} s, the clip to {duration_s:.6g} s</source>
        <translation>la piste de force va de {first_s:.6g} s à {last_s:.6g} s, le clip jusqu’à {duration_s:.6g} s</translation>
    </message>
    <message>
        <source>the force track was rejected: {reason}</source>
        <translation>la piste de force a été rejetée&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the format of {name!r} is unknown; choose one of {known}</source>
        <translation>le format de {name!r} est inconnu&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>the gyro explains {explained:.0%} of their rotation (video stabilised, or a calm camera)</source>
        <translation>le gyroscope explique {explained:.0%} de leur rotation (vidéo stabilisée ou caméra calme)</translation>
    </message>
    <message>
        <source>the motion of {key!r} was estimated from the picture, nothing measured it</source>
        <translation>le mouvement de {key!r} a été estimé d’après l’image, rien ne l’a mesuré</translation>
    </message>
    <message>
        <source>the motion of {title} was estimated from the picture, so there is no realistic feedback to make {name!r} of</source>
        <translation>le mouvement de {title} a été estimé d’après l’image, il n’y a donc pas de retour réaliste dont faire {name!r}</translation>
    </message>
    <message>
        <source>the motion was estimated from the picture, nothing measured it: its strength is a guess, and studies refuse it unless they name the feedback &apos;estimated&apos;</source>
        <translation>le mouvement a été estimé d’après l’image, rien ne l’a mesuré&#xa0;: sa force est supposée, et les études le refusent si elles ne nomment pas le retour &apos;estimated&apos;</translation>
    </message>
    <message>
        <source>the realistic force with the effects of the sequence on it</source>
        <translation>la force réaliste avec les effets de la séquence</translation>
    </message>
    <message>
        <source>the recording is incomplete: the disk at {disk} is full, or the file has reached its size limit</source>
        <translation>l’enregistrement est incomplet&#xa0;: le disque sur {disk} est plein, ou le fichier a atteint sa taille maximale</translation>
    </message>
    <message>
        <source>the rig at {address} cannot be reached ({reason}); check address and network, and choose the device again</source>
        <translation>la plateforme à {address} est injoignable ({reason})&#xa0;; vérifiez l’adresse et le réseau, puis choisissez à nouveau l’appareil</translation>
    </message>
    <message>
        <source>the rig is not open; choose the device again</source>
        <translation>la plateforme n’est pas ouverte&#xa0;; choisissez à nouveau l’appareil</translation>
    </message>
    <message>
        <source>the rotation of its gyroscope does not match that of gravity in its accelerometer: their axes or signs differ</source>
        <translation>la rotation de son gyroscope ne correspond pas à celle de la pesanteur dans son accéléromètre&#xa0;: leurs axes ou leurs signes diffèrent</translation>
    </message>
    <message>
        <source>the rows, of which the newest came first, were put in order</source>
        <translation>les lignes, dont la plus récente venait d’abord, ont été remises en ordre</translation>
    </message>
    <message>
        <source>the shaker is not open; choose the device again</source>
        <translation>le vibreur n’est pas ouvert&#xa0;; choisissez-le à nouveau</translation>
    </message>
    <message>
        <source>the simulated service has ended; choose the device again to start a new one</source>
        <translation>le service simulé s’est terminé&#xa0;; choisissez l’appareil à nouveau pour en démarrer un autre</translation>
    </message>
    <message>
        <source>the sound card {card!r} cannot be opened with {count} channels: {reason}; choose another card or profile</source>
        <translation>la carte son {card!r} ne peut pas être ouverte avec {count} canaux&#xa0;: {reason}&#xa0;; choisissez une autre carte ou un autre profil</translation>
    </message>
    <message>
        <source>the track needs more than {most} keyframes</source>
        <translation>la piste nécessite plus de {most} images clés</translation>
    </message>
    <message>
        <source>their rotation is not that of the gyro</source>
        <translation>leur rotation n’est pas celle du gyroscope</translation>
    </message>
    <message>
        <source>turn the volume up</source>
        <translation>augmentez le volume</translation>
    </message>
    <message>
        <source>up and down</source>
        <translation>mouvement vertical</translation>
    </message>
    <message>
        <source>update or restart it</source>
        <translation>mettez-le à jour ou redémarrez-le</translation>
    </message>
    <message>
        <source>use a record of the haptic loop</source>
        <translation>utilisez un enregistrement de la boucle haptique</translation>
    </message>
    <message>
        <source>use the taps, or enter the offset</source>
        <translation>utilisez les tapotements, ou saisissez le décalage</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>vibration</translation>
    </message>
    <message>
        <source>vibration of {hertz:g} Hz along x {x:.2f}, y {y:.2f}, z {z:.2f}: strength 100 was taken as {full_n:.3g} N</source>
        <translation>vibration de {hertz:g} Hz selon x {x:.2f}, y {y:.2f}, z {z:.2f}&#xa0;: l’intensité 100 a été prise comme {full_n:.3g} N</translation>
    </message>
    <message>
        <source>wait for it</source>
        <translation>attendez-les</translation>
    </message>
    <message>
        <source>wait until it is ready, or choose it again</source>
        <translation>attendez qu’il soit prêt, ou choisissez-le de nouveau</translation>
    </message>
    <message>
        <source>when each trial and interruption was</source>
        <translation>le moment de chaque essai et de chaque interruption</translation>
    </message>
    <message>
        <source>write one from a long log</source>
        <translation>écrivez-en un d’après un long journal</translation>
    </message>
    <message>
        <source>{axis}: its actions are null</source>
        <translation>{axis}&#xa0;: ses actions sont null</translation>
    </message>
    <message>
        <source>{clip}: its frames show the mounting {axes} (ratio {ratio:.1f}), not {used}; take it, or keep the axes of the log</source>
        <translation>{clip}&#xa0;: ses images montrent la fixation {axes} (rapport {ratio:.1f}), et non {used}&#xa0;; prenez-la, ou gardez les axes du journal</translation>
    </message>
    <message>
        <source>{clip}: motion is estimated as the video plays</source>
        <translation>{clip}&#xa0;: le mouvement est estimé à la vitesse de lecture de la vidéo</translation>
    </message>
    <message>
        <source>{clip}: taps and frames cannot be compared at another speed; enter the offset, too</source>
        <translation>{clip}&#xa0;: tapotements et images ne peuvent pas être comparés à une autre vitesse&#xa0;; saisissez aussi le décalage</translation>
    </message>
    <message>
        <source>{clip}: the frames do not tell whether the mounting is {axes} or {next_best} (ratio {ratio:.2f}); {give}</source>
        <translation>{clip}&#xa0;: les images ne disent pas si la fixation est {axes} ou {next_best} (rapport {ratio:.2f})&#xa0;; {give}</translation>
    </message>
    <message>
        <source>{clip}: by its frames the mounting is {axes}, but by gravity another side is up; is the video upright and not mirrored? Otherwise {give}</source>
        <translation>{clip}&#xa0;: d’après les images, la fixation est {axes}, mais d’après la pesanteur un autre côté était en haut&#xa0;; la vidéo est-elle droite et non inversée&#xa0;? Sinon&#xa0;: {give}</translation>
    </message>
    <message>
        <source>{look}; {brings}</source>
        <translation>{look}&#xa0;; {brings}</translation>
    </message>
    <message>
        <source>{name} holds no motion; choose one of {known}</source>
        <translation>{name} ne contient pas de mouvement&#xa0;; choisissez {known}</translation>
    </message>
    <message>
        <source>{text!r} is not a rotation; give nine numbers, row by row, with rows of length 1 at right angles and determinant +1</source>
        <translation>{text!r} n’est pas une rotation&#xa0;; donnez neuf nombres, ligne par ligne, avec des lignes de longueur 1, perpendiculaires, et un déterminant +1</translation>
    </message>
    <message>
        <source>{text!r} must be a time in s and a value</source>
        <translation>{text!r} doit être un temps en s et une valeur</translation>
    </message>
    <message>
        <source>{title} does not answer at {url}; start it and choose the device again</source>
        <translation>{title} ne répond pas à {url}&#xa0;; démarrez-le et choisissez l’appareil à nouveau</translation>
    </message>
    <message>
        <source>{title} has closed the connection; start it and choose the device again</source>
        <translation>{title} a fermé la connexion&#xa0;; démarrez-le et choisissez l’appareil à nouveau</translation>
    </message>
    <message>
        <source>{what} {name!r} not found; choose one of {known}</source>
        <translation>{what} {name!r} est introuvable&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>{where} cannot be opened: {reason}; see whether the board is connected and you may use it</source>
        <translation>{where} ne peut pas être ouvert&#xa0;: {reason}&#xa0;; vérifiez que la carte est branchée et que vous pouvez l’utiliser</translation>
    </message>
    <message>
        <source>{where} reports an error ({reason}); {remedy}, and choose the device again</source>
        <translation>{where} signale une erreur ({reason})&#xa0;; {remedy}, puis choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>{who} reports the error {code}; look at it in Haply&apos;s own program, and choose the device again</source>
        <translation>{who} signale l’erreur {code}&#xa0;; vérifiez-le dans le programme de Haply, puis choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>{word!r} is unknown; use {known}</source>
        <translation>{word!r} est inconnu&#xa0;; utilisez {known}</translation>
    </message>
    <message>
        <source>the grip did not give way to 1 N; hold it more loosely</source>
        <translation>la poignée n’a pas cédé à 1 N&#xa0;; tenez-la plus souplement</translation>
    </message>
    <message>
        <source>has no header row (t,gx,gy,gz,ax,ay,az) below its keys</source>
        <translation>n’a pas de ligne d’en-tête (t,gx,gy,gz,ax,ay,az) sous ses clés</translation>
    </message>
    <message>
        <source>has only {rate_hz:.1f} samples per second, too few for taps</source>
        <translation>n’a que {rate_hz:.1f} mesures par seconde, trop peu pour des tapotements</translation>
    </message>
    <message>
        <source>hold the grip, or lower the gain</source>
        <translation>tenez la poignée, ou baissez le gain</translation>
    </message>
    <message>
        <source>holds a file that is named like another part of it, {name!r}</source>
        <translation>contient un fichier nommé comme une autre de ses parties, {name!r}</translation>
    </message>
    <message>
        <source>holds a level twice</source>
        <translation>contient deux fois un niveau</translation>
    </message>
    <message>
        <source>holds half a character</source>
        <translation>contient un demi-caractère</translation>
    </message>
    <message>
        <source>holds telemetry of {maker}</source>
        <translation>contient de la télémétrie de {maker}</translation>
    </message>
    <message>
        <source>holds {held}; columns of gyro and accelerometer are needed (t,gx,gy,gz,ax,ay,az)</source>
        <translation>contient {held}&#xa0;; il faut des colonnes du gyroscope et de l’accéléromètre (t,gx,gy,gz,ax,ay,az)</translation>
    </message>
    <message>
        <source>holds {what} (.{part}), which are not read</source>
        <translation>contient des {what} (.{part}), qui ne sont pas lues</translation>
    </message>
    <message>
        <source>if these are a magnetometer&apos;s readings, give those of the accelerometer; else give the specific force in m/s^2, about 9.8 at rest</source>
        <translation>si ce sont des mesures d’un magnétomètre, donnez celles de l’accéléromètre&#xa0;; sinon donnez la force spécifique en m/s^2, environ 9.8 au repos</translation>
    </message>
    <message>
        <source>in swapped columns</source>
        <translation>dans des colonnes échangées</translation>
    </message>
    <message>
        <source>invalid force track</source>
        <translation>piste de force invalide</translation>
    </message>
    <message>
        <source>is JSON, not a table</source>
        <translation>est du JSON, pas un tableau</translation>
    </message>
    <message>
        <source>is XML or a web page, not a table</source>
        <translation>est du XML ou une page web, pas un tableau</translation>
    </message>
    <message>
        <source>is a session of the study {found}, not {expected}</source>
        <translation>est une séance de l’étude {found}, pas de {expected}</translation>
    </message>
    <message>
        <source>is a table with {count} columns of numbers, fewer than time and acceleration need; these columns hold text: {shown}</source>
        <translation>est un tableau avec {count} colonnes de nombres, moins qu’il n’en faut pour le temps et l’accélération&#xa0;; ces colonnes contiennent du texte&#xa0;: {shown}</translation>
    </message>
    <message>
        <source>is not the video that its force was made for ({reason})</source>
        <translation>n’est pas la vidéo pour laquelle la force a été calculée ({reason})</translation>
    </message>
    <message>
        <source>is not used in {kind} questions</source>
        <translation>n’est pas utilisé dans les questions {kind}</translation>
    </message>
    <message>
        <source>is not used in {kind} trials</source>
        <translation>n’est pas utilisé dans les essais {kind}</translation>
    </message>
    <message>
        <source>the Falcon is not homed; home it</source>
        <translation>le Falcon n’est pas référencé&#xa0;; référencez-le</translation>
    </message>
    <message>
        <source>the Falcon&apos;s firmware is missing ({path}); it may not be passed on with this program: take nvent_firmware.bin from a libnifalcon source archive and install it: Device &gt; Set up the device</source>
        <translation>le micrologiciel du Falcon manque ({path})&#xa0;; il ne peut pas être transmis avec ce programme&#xa0;: prenez nvent_firmware.bin dans une archive des sources de libnifalcon et installez-le&#xa0;: Appareil &gt; Préparer l’appareil</translation>
    </message>
    <message>
        <source>the analysis of {kind} trials is missing; install the extension that has it, or export the answers</source>
        <translation>l’analyse des essais {kind} manque&#xa0;; installez l’extension qui la contient, ou exportez les réponses</translation>
    </message>
    <message>
        <source>the board at {where} has restarted ({said}); check its supply and cable</source>
        <translation>la carte sur {where} a redémarré ({said})&#xa0;; vérifiez son alimentation et son câble</translation>
    </message>
    <message>
        <source>the board at {where} reports an error ({said}); check its channel, cable and supply, and choose the device again</source>
        <translation>la carte sur {where} signale une erreur ({said})&#xa0;; vérifiez son canal, son câble et son alimentation, puis choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the buttons of the wireless grip cannot be read; stop with Esc, and look at the grip in Haply&apos;s own program</source>
        <translation>les boutons de la poignée sans fil ne peuvent pas être lus&#xa0;; arrêtez avec Échap, et vérifiez la poignée dans le programme de Haply</translation>
    </message>
    <message>
        <source>the column {name!r} is not of a force</source>
        <translation>la colonne {name!r} n’appartient pas à une force</translation>
    </message>
    <message>
        <source>the first sudden rise of sound and motion is uncertain</source>
        <translation>la première montée soudaine du son et du mouvement est incertaine</translation>
    </message>
    <message>
        <source>the force of another clip needs its sequence: choose its folder</source>
        <translation>la force d’un autre clip demande sa séquence&#xa0;: choisissez son dossier</translation>
    </message>
    <message>
        <source>the guard did not start, so nothing is measured; run &apos;hapticplayer doctor&apos;</source>
        <translation>le gardien n’a pas démarré, rien n’est donc mesuré&#xa0;; lancez &apos;hapticplayer doctor&apos;</translation>
    </message>
    <message>
        <source>the guard has ended; measure again</source>
        <translation>le gardien s’est arrêté&#xa0;; mesurez à nouveau</translation>
    </message>
    <message>
        <source>the haptics process could not be started: {reason}</source>
        <translation>le processus haptique n’a pas pu être lancé&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the header is {header!r}</source>
        <translation>l’en-tête est {header!r}</translation>
    </message>
    <message>
        <source>the largest angular rate is {largest:.3g} rad/s</source>
        <translation>la plus grande vitesse angulaire est de {largest:.3g} rad/s</translation>
    </message>
    <message>
        <source>the largest number of participants must be between 3 and {most}</source>
        <translation>le plus grand nombre de participants doit être compris entre 3 et {most}</translation>
    </message>
    <message>
        <source>the legs cannot be assembled at these joint angles</source>
        <translation>les jambes ne peuvent pas être assemblées à ces angles d’articulation</translation>
    </message>
    <message>
        <source>the letter A</source>
        <translation>la lettre A</translation>
    </message>
    <message>
        <source>the list of orders is empty</source>
        <translation>la liste des ordres est vide</translation>
    </message>
    <message>
        <source>the log cannot be written ({reason})</source>
        <translation>le journal ne peut pas être écrit ({reason})</translation>
    </message>
    <message>
        <source>the log has no timestamps: 50 frames per second are assumed</source>
        <translation>le journal n’a pas de temps&#xa0;: 50 mesures par seconde sont supposées</translation>
    </message>
    <message>
        <source>the log is not synchronised: its clock is taken as media time; enter the offset</source>
        <translation>le journal n’est pas synchronisé&#xa0;: son horloge est prise comme temps du média&#xa0;; saisissez le décalage</translation>
    </message>
    <message>
        <source>the low-pass has no heading; choose one of ekf, vqf</source>
        <translation>le passe-bas n’a pas de cap&#xa0;; choisissez ekf ou vqf</translation>
    </message>
    <message>
        <source>the magnetometer was left out: {count} of {total} samples are empty</source>
        <translation>le magnétomètre a été omis&#xa0;: {count} mesures sur {total} sont vides</translation>
    </message>
    <message>
        <source>the motion cannot be separated from gravity</source>
        <translation>le mouvement ne peut pas être séparé de la pesanteur</translation>
    </message>
    <message>
        <source>the motion covers {first_s:.1f} to {last_s:.1f} s of media time, but the clip lasts from 0 to {duration_s:.1f} s</source>
        <translation>le mouvement couvre {first_s:.1f} à {last_s:.1f} s de temps du média, mais le clip dure de 0 à {duration_s:.1f} s</translation>
    </message>
    <message>
        <source>the motion covers {first_s:.1f} to {last_s:.1f} s of the clip&apos;s {duration_s:.1f} s; there is no force outside</source>
        <translation>le mouvement couvre {first_s:.1f} à {last_s:.1f} s des {duration_s:.1f} s du clip&#xa0;; il n’y a pas de force en dehors</translation>
    </message>
    <message>
        <source>the motion of {name} was recorded, which is better than an estimate from the picture; import it without an estimate</source>
        <translation>le mouvement de {name} a été enregistré, ce qui vaut mieux qu’une estimation d’après l’image&#xa0;; importez-le sans estimation</translation>
    </message>
    <message>
        <source>the motion track is empty, so there is no force to render</source>
        <translation>la piste de mouvement est vide, il n’y a donc pas de force à calculer</translation>
    </message>
    <message>
        <source>the motion where it is not valid</source>
        <translation>le mouvement là où il n’est pas valide</translation>
    </message>
    <message>
        <source>the norm of the specific force is {norm:.3g} where it is calmest, but gravity is {gravity:.3g} m/s^2</source>
        <translation>la norme de la force spécifique est de {norm:.3g} là où elle est la plus calme, mais la pesanteur est de {gravity:.3g} m/s^2</translation>
    </message>
    <message>
        <source>the number of samples is {count}; {least} to {most} can be used</source>
        <translation>le nombre de mesures est de {count}&#xa0;; de {least} à {most} sont utilisables</translation>
    </message>
    <message>
        <source>the number of simulated studies must be between {least} and {most}</source>
        <translation>le nombre d’études simulées doit être compris entre {least} et {most}</translation>
    </message>
    <message>
        <source>the other axes are in {names}</source>
        <translation>les autres axes sont dans {names}</translation>
    </message>
    <message>
        <source>the other clip has a force track of a single row</source>
        <translation>la piste de force de l’autre clip n’a qu’une ligne</translation>
    </message>
    <message>
        <source>the other clip has no force along an axis that this one uses</source>
        <translation>l’autre clip n’a pas de force sur un axe que celui-ci utilise</translation>
    </message>
    <message>
        <source>the output {name} appears twice</source>
        <translation>la sortie {name} figure deux fois</translation>
    </message>
    <message>
        <source>the phone&apos;s axes: x right, y top, z out of the screen</source>
        <translation>axes du téléphone&#xa0;: x à droite, y en haut, z hors de l’écran</translation>
    </message>
    <message>
        <source>the range of {range:g} % was not applied: 0 to 100 is the whole way</source>
        <translation>la plage (range) de {range:g} % n’a pas été appliquée&#xa0;: 0 à 100 est toute la course</translation>
    </message>
    <message>
        <source>the rate</source>
        <translation>la cadence</translation>
    </message>
    <message>
        <source>the realistic force in the opposite direction</source>
        <translation>la force réaliste en sens contraire</translation>
    </message>
    <message>
        <source>the realistic force of another clip, with the RMS of this one</source>
        <translation>la force réaliste d’un autre clip, de même valeur efficace que celui-ci</translation>
    </message>
    <message>
        <source>the realistic force, later than the picture</source>
        <translation>la force réaliste, en retard sur l’image</translation>
    </message>
    <message>
        <source>the realistic force, stronger or weaker</source>
        <translation>la force réaliste, plus forte ou plus faible</translation>
    </message>
    <message>
        <source>the record cannot be written ({reason})</source>
        <translation>l’enregistrement ne peut pas être écrit ({reason})</translation>
    </message>
    <message>
        <source>the recording contradicts the calibration, which was not used: it is of another sensor, or too old</source>
        <translation>l’enregistrement contredit l’étalonnage, qui n’a pas été utilisé&#xa0;: il vient d’un autre capteur ou est trop ancien</translation>
    </message>
    <message>
        <source>the recording has no end: it was truncated, or is still being written</source>
        <translation>l’enregistrement n’a pas de fin&#xa0;: il est tronqué, ou encore en cours d’écriture</translation>
    </message>
    <message>
        <source>the recording has no magnetometer to find the heading with</source>
        <translation>l’enregistrement n’a pas de magnétomètre pour trouver le cap</translation>
    </message>
    <message>
        <source>the recording is incomplete: its file could not be written</source>
        <translation>l’enregistrement est incomplet&#xa0;: son fichier n’a pas pu être écrit</translation>
    </message>
    <message>
        <source>the recording is incomplete: its file was removed</source>
        <translation>l’enregistrement est incomplet&#xa0;: son fichier a été supprimé</translation>
    </message>
    <message>
        <source>the recording is incomplete: its process ended with status {status}</source>
        <translation>l’enregistrement est incomplet&#xa0;: son processus s’est terminé avec le code {status}</translation>
    </message>
    <message>
        <source>the recording is incomplete: the disk is too slow</source>
        <translation>l’enregistrement est incomplet&#xa0;: le disque est trop lent</translation>
    </message>
    <message>
        <source>the sampling rate changes over the recording, {change}</source>
        <translation>la cadence des mesures change au cours de l’enregistrement, {change}</translation>
    </message>
    <message>
        <source>the scale of {key} is damaged ({scale})</source>
        <translation>l’échelle de {key} est endommagée ({scale})</translation>
    </message>
    <message>
        <source>the second half could not be drawn ({reason})</source>
        <translation>la seconde moitié n’a pas pu être dessinée ({reason})</translation>
    </message>
    <message>
        <source>the sensor rotated so much that gravity does not show its axes</source>
        <translation>le capteur a tant tourné que la pesanteur ne montre pas ses axes</translation>
    </message>
    <message>
        <source>the sensor&apos;s axes</source>
        <translation>les axes du capteur</translation>
    </message>
    <message>
        <source>the sequence {key!r} has changed since this session began</source>
        <translation>la séquence {key!r} a changé depuis le début de cette séance</translation>
    </message>
    <message>
        <source>the sequence {key!r} has no folder with a sequence</source>
        <translation>la séquence {key!r} n’a pas de dossier qui contienne une séquence</translation>
    </message>
    <message>
        <source>the simulated Falcon did not answer within {patience_s:.0f} s; try again, and run &apos;hapticplayer doctor&apos; if it stays so</source>
        <translation>le Falcon simulé n’a pas répondu en {patience_s:.0f} s&#xa0;; réessayez, et lancez «&#xa0;hapticplayer doctor&#xa0;» si cela persiste</translation>
    </message>
    <message>
        <source>the simulated Falcon was unplugged: its process has ended; choose the device again to start a new one</source>
        <translation>le Falcon simulé a été débranché&#xa0;: son processus s’est terminé&#xa0;; choisissez de nouveau l’appareil pour en lancer un autre</translation>
    </message>
    <message>
        <source>the size of the force and its frequency; no direction</source>
        <translation>la norme de la force et sa fréquence&#xa0;; pas de direction</translation>
    </message>
    <message>
        <source>the smoother has no heading; choose one of ekf, vqf, offline-vqf for it</source>
        <translation>le lisseur n’a pas de cap&#xa0;; choisissez ekf, vqf ou offline-vqf</translation>
    </message>
    <message>
        <source>the sound has the shape {shape}, expected (n, 1) or (n, 2)</source>
        <translation>le son a la forme {shape}, attendu&#xa0;: (n, 1) ou (n, 2)</translation>
    </message>
    <message>
        <source>the sound holds values that are not finite</source>
        <translation>le son contient des valeurs qui ne sont pas finies</translation>
    </message>
    <message>
        <source>the sound is silent</source>
        <translation>le son est muet</translation>
    </message>
    <message>
        <source>the specific force is {norm:.3g} m/s2 at rest when read in {accel_unit}, but gravity is 9.81</source>
        <translation>la force spécifique est de {norm:.3g} m/s2 au repos quand elle est lue en {accel_unit}, mais la pesanteur est de 9.81</translation>
    </message>
    <message>
        <source>the study requires a device: choose it above</source>
        <translation>l’étude exige un appareil&#xa0;: choisissez-le ci-dessus</translation>
    </message>
    <message>
        <source>the time stamps jitter by {share:.0f} % of an interval; an even clock fitted to them was used</source>
        <translation>les horodatages fluctuent de {share:.0f} % d’un intervalle&#xa0;; une horloge régulière ajustée sur eux a été utilisée</translation>
    </message>
    <message>
        <source>the time {fault} ({time_s} s after {last_s} s)</source>
        <translation>le temps {fault} ({time_s} s après {last_s} s)</translation>
    </message>
    <message>
        <source>the track ends at {end_s:.4g} s, after the longest clip ({most_s:.0f} s)</source>
        <translation>la piste se termine à {end_s:.4g} s, après le plus long clip ({most_s:.0f} s)</translation>
    </message>
    <message>
        <source>the track is too long for this format</source>
        <translation>la piste est trop longue pour ce format</translation>
    </message>
    <message>
        <source>the track needs {count} positions (limit: {most})</source>
        <translation>la piste nécessite {count} positions (limite&#xa0;: {most})</translation>
    </message>
    <message>
        <source>the wavelet stream is not base64</source>
        <translation>le flux d’ondelettes n’est pas en base64</translation>
    </message>
    <message>
        <source>the process was killed (exit status {status}), perhaps for want of memory; nothing was written</source>
        <translation>le travail a été arrêté de l’extérieur (état {status}), peut-être faute de mémoire&#xa0;; rien n’a été écrit</translation>
    </message>
    <message>
        <source>a track {name!r} exists; choose another name</source>
        <translation>il y a déjà une piste {name!r}&#xa0;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>there is no effect {name!r}; there is paper, none, or a share of the paper&apos;s effect such as 0.5</source>
        <translation>l’effet {name!r} est inconnu&#xa0;; il y a paper, none, ou une part de l’effet comme 0.5</translation>
    </message>
    <message>
        <source>there is no header, the file begins with numbers</source>
        <translation>il n’y a pas d’en-tête, le fichier commence par des nombres</translation>
    </message>
    <message>
        <source>there is no measure {measure!r}; choose one of {known}</source>
        <translation>la mesure {measure!r} est inconnue&#xa0;; il y a {known}</translation>
    </message>
    <message>
        <source>there is no sound output, so the clip plays silently</source>
        <translation>il n’y a pas de sortie de son, le clip est donc muet</translation>
    </message>
    <message>
        <source>there is no sound output: {reason}</source>
        <translation>il n’y a pas de sortie de son&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>track {name!r} not found</source>
        <translation>il n’y a pas de piste {name!r}</translation>
    </message>
    <message>
        <source>there is nothing in it</source>
        <translation>il n’y a rien dedans</translation>
    </message>
    <message>
        <source>not valid firmware for the Falcon: {reason}; choose the file nvent_firmware.bin of a libnifalcon source archive</source>
        <translation>pas un micrologiciel valable pour le Falcon&#xa0;: {reason}&#xa0;; choisissez le fichier nvent_firmware.bin d’une archive des sources de libnifalcon</translation>
    </message>
    <message>
        <source>this method takes no parameters</source>
        <translation>cette méthode n’a pas de paramètres</translation>
    </message>
    <message>
        <source>this method takes {expected}, not {given}</source>
        <translation>cette méthode accepte {expected}, et non {given}</translation>
    </message>
    <message>
        <source>this track loads the motors to {heat:.0f} % of their continuous force; it may be reduced</source>
        <translation>cette piste chauffe les moteurs à {heat:.0f}&#xa0;% de ce qu’ils supportent sans fin&#xa0;; ils peuvent l’affaiblir</translation>
    </message>
    <message>
        <source>this track would move a {hand} hand so far that the device trips ({trip}) at {at_s:.1f} s</source>
        <translation>cette piste déplacerait une main {hand} au point que la force s’arrête ({trip}) à {at_s:.1f} s</translation>
    </message>
    <message>
        <source>this track would reach {reach:.0f} % of the workspace with a relaxed hand, at {at_s:.1f} s; beyond {far:.0f} % outward force is reduced</source>
        <translation>cette piste atteindrait {reach:.0f}&#xa0;% de l’espace de travail avec une main détendue, à {at_s:.1f} s&#xa0;; au-delà de {far:.0f}&#xa0;%, la force vers l’extérieur est affaiblie</translation>
    </message>
    <message>
        <source>time_s has {ndim} axes, expected one</source>
        <translation>time_s a {ndim} axes, attendu&#xa0;: un</translation>
    </message>
    <message>
        <source>timeout</source>
        <translation>délai dépassé</translation>
    </message>
    <message>
        <source>took telemetry-parser {time_limit_s:g} s</source>
        <translation>a occupé telemetry-parser {time_limit_s:g} s</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>at most {largest_radps:.2f} rad/s</source>
        <translation>vitesse angulaire d’au plus {largest_radps:.2f} rad/s</translation>
    </message>
    <message>
        <source>update hapticplayer</source>
        <translation>mettez hapticplayer à jour</translation>
    </message>
    <message>
        <source>update the program, or export again with this version</source>
        <translation>mettez le programme à jour, ou exportez encore une fois avec cette version</translation>
    </message>
    <message>
        <source>use the version of hapticplayer that wrote it</source>
        <translation>utilisez la version de hapticplayer qui l’a écrit</translation>
    </message>
    <message>
        <source>without a readable number</source>
        <translation>sans numéro lisible</translation>
    </message>
    <message>
        <source>without names</source>
        <translation>sans noms</translation>
    </message>
    <message>
        <source>written to</source>
        <translation>écrit</translation>
    </message>
    <message>
        <source>{axes}{words} are right, front, up</source>
        <translation>{axes}{words} sont droite, avant, haut</translation>
    </message>
    <message>
        <source>{count} Falcons are plugged in: {known}; choose one, such as falcon:{serial}</source>
        <translation>{count} Falcon sont branchés&#xa0;: {known}&#xa0;; choisissez-en un, par exemple falcon:{serial}</translation>
    </message>
    <message>
        <source>{count} bytes are not a whole number of words, or too many</source>
        <translation>{count} octets ne font pas un nombre entier de mots, ou sont trop nombreux</translation>
    </message>
    <message>
        <source>{count} bytes follow its end</source>
        <translation>{count} octets suivent sa fin</translation>
    </message>
    <message>
        <source>{count} gaps</source>
        <translation>{count} lacunes</translation>
    </message>
    <message>
        <source>{count} gyroscope values were scaled twice and are ignored</source>
        <translation>{count} valeurs du gyroscope étaient mises à l’échelle deux fois et ont été omises</translation>
    </message>
    <message>
        <source>{count} damaged lines were skipped (the first: line {line})</source>
        <translation>{count} lignes sont endommagées et ont été omises (la première&#xa0;: ligne {line})</translation>
    </message>
    <message>
        <source>{clip}: the skew of the sound would have no effect, because the offset comes from elsewhere ({method}); leave it out</source>
        <translation>{clip}&#xa0;: le retard du son serait sans effet, car le décalage vient d’ailleurs ({method})&#xa0;; omettez-le</translation>
    </message>
    <message>
        <source>{clip}: the taps give an offset of {pats_s:.3f} s, the frames {frames_s:.3f} s; choose one of them, or enter the offset; if the camera&apos;s sound is late, say by how much</source>
        <translation>{clip}&#xa0;: les tapotements donnent un décalage de {pats_s:.3f} s, les images {frames_s:.3f} s&#xa0;; choisissez l’un des deux, ou saisissez le décalage&#xa0;; si le son de la caméra est en retard, dites de combien</translation>
    </message>
    <message>
        <source>{clip}: {what}, and neither frames nor taps tell which is right ({why}); enter the offset: {places}, or another one</source>
        <translation>{clip}&#xa0;: {what}, et ni les images ni les tapotements ne disent ce qui est juste ({why})&#xa0;; saisissez le décalage&#xa0;: {places}, ou un autre</translation>
    </message>
    <message>
        <source>{clip}: {why}; make a copy at its real speed ({copy}), or take it as it plays, or stretch the motion</source>
        <translation>{clip}&#xa0;: {why}&#xa0;; faites une copie à sa vitesse réelle ({copy}), ou prenez-le tel qu’il est lu, ou étirez le mouvement</translation>
    </message>
    <message>
        <source>{count} missing or implausible times were interpolated</source>
        <translation>{count} temps manquants ou aberrants ont été interpolés</translation>
    </message>
    <message>
        <source>{count} motion samples are too few; at least {least} are needed</source>
        <translation>{count} mesures de mouvement sont trop peu&#xa0;; il en faut au moins {least}</translation>
    </message>
    <message>
        <source>{count} motion samples within {span_ms:.3g} ms are not a recording of motion</source>
        <translation>{count} mesures de mouvement en {span_ms:.3g} ms ne sont pas un mouvement</translation>
    </message>
    <message>
        <source>{count} of {total} rows {done}</source>
        <translation>{count} lignes sur {total} {done}</translation>
    </message>
    <message>
        <source>{count} of {total} samples of {name} were missing, the first in {place}; they were filled in</source>
        <translation>{count} mesures sur {total} de {name} manquaient, la première à la {place}&#xa0;; elles ont été complétées</translation>
    </message>
    <message>
        <source>{count} packets in a row are damaged</source>
        <translation>{count} paquets de suite sont endommagés</translation>
    </message>
    <message>
        <source>{count} pairs of rows were swapped in time and put in order</source>
        <translation>{count} paires de lignes étaient inversées dans le temps et ont été remises en ordre</translation>
    </message>
    <message>
        <source>{count} rows without a time were left out, as they are in a gap</source>
        <translation>{count} lignes sans temps ont été omises, car elles sont dans une lacune</translation>
    </message>
    <message>
        <source>{count} samples have no rate</source>
        <translation>{count} mesures n’ont pas de cadence</translation>
    </message>
    <message>
        <source>{count} samples {interval_s} s apart are not a recording</source>
        <translation>{count} échantillons espacés de {interval_s} s ne forment pas un enregistrement</translation>
    </message>
    <message>
        <source>{count} telemetry payloads are damaged; the rest was read.</source>
        <translation>{count} blocs de télémétrie sont endommagés&#xa0;; le reste a été lu.</translation>
    </message>
    <message>
        <source>{file}, line 1</source>
        <translation>{file}, ligne 1</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, ligne {line}</translation>
    </message>
    <message>
        <source>{file}: as its axes are given, the wearer was upside down: by gravity the other side is up; choose another mounting, or {sign}, or keep the axes of the log</source>
        <translation>{file}&#xa0;: avec ces axes, le porteur avait la tête en bas&#xa0;: d’après la pesanteur, l’autre côté est en haut&#xa0;; choisissez une autre fixation, ou {sign}, ou gardez les axes du journal</translation>
    </message>
    <message>
        <source>{file}: columns={columns} {fault}</source>
        <translation>{file}&#xa0;: columns={columns} {fault}</translation>
    </message>
    <message>
        <source>{file}: is not a table of numbers; choose another log</source>
        <translation>{file}&#xa0;: n’est pas un tableau de nombres&#xa0;; choisissez un autre journal</translation>
    </message>
    <message>
        <source>{accel_unit} and {rate_unit} for {ranges}</source>
        <translation>{accel_unit} et {rate_unit} pour {ranges}</translation>
    </message>
    <message>
        <source>{key} has {count} samples, too many</source>
        <translation>{key} a {count} mesures, plus qu’on n’en lit</translation>
    </message>
    <message>
        <source>{leak_mps2:.2f} m/s2 of gravity remain while the recorder is stationary</source>
        <translation>{leak_mps2:.2f} m/s2 de pesanteur restent là où l’enregistreur est immobile</translation>
    </message>
    <message>
        <source>{line}, column {column}</source>
        <translation>{line}, colonne {column}</translation>
    </message>
    <message>
        <source>{name!r} is not a valid track name; use up to 40 letters, digits, blanks, dots and hyphens</source>
        <translation>{name!r} ne peut pas être le nom d’une piste&#xa0;; prenez jusqu’à 40 lettres, chiffres, espaces, points et traits d’union</translation>
    </message>
    <message>
        <source>{name!r} is not a Falcon; use falcon, or falcon:SERIAL</source>
        <translation>{name!r} n’est pas un Falcon&#xa0;; prenez falcon, ou falcon:SERIAL</translation>
    </message>
    <message>
        <source>(default)</source>
        <translation>(par défaut)</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>During each clip a slider says how badly force and video fit; the recorded force beside a weaker and a late one and none.</source>
        <translation>Pendant chaque clip, un curseur dit à quel point force et vidéo s’accordent mal&#xa0;; la force enregistrée à côté d’une plus faible, d’une en retard et d’aucune.</translation>
    </message>
    <message>
        <source>Each clip twice, once with a late force; the delay follows the answers (2-down 1-up).</source>
        <translation>Chaque clip deux fois, dont une avec une force en retard&#xa0;; le retard suit les réponses (2-down 1-up).</translation>
    </message>
    <message>
        <source>Each clip twice, once with a stronger or weaker force; in which one it was stronger (forced choice).</source>
        <translation>Chaque clip deux fois, dont une avec une force plus forte ou plus faible&#xa0;; dans lequel elle était plus forte (choix forcé).</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effets</translation>
    </message>
    <message>
        <source>Estimated</source>
        <translation>Estimé</translation>
    </message>
    <message>
        <source>Falcon on USB</source>
        <translation>Falcon sur USB</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Micrologiciel</translation>
    </message>
    <message>
        <source>Forces of several strengths; a number in proportion after each clip.</source>
        <translation>Des forces de plusieurs intensités&#xa0;; un nombre proportionnel après chaque clip.</translation>
    </message>
    <message>
        <source>Game pad that Linux can rumble</source>
        <translation>Manette que Linux peut faire vibrer</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service has no Inverse3; connect its cable and supply, and choose the device again</source>
        <translation>l’Inverse Service de Haply n’a pas d’Inverse3&#xa0;; branchez son câble et son alimentation, puis choisissez l’appareil à nouveau</translation>
    </message>
    <message>
        <source>Inverse3</source>
        <translation>Inverse3</translation>
    </message>
    <message>
        <source>Inverse3 on a simulated service</source>
        <translation>Inverse3 sur un service simulé</translation>
    </message>
    <message>
        <source>Just noticeable change</source>
        <translation>Changement juste perceptible</translation>
    </message>
    <message>
        <source>LabRecorder cannot write into a folder with braces in its name</source>
        <translation>LabRecorder ne peut pas écrire dans un dossier dont le nom contient des accolades</translation>
    </message>
    <message>
        <source>LabRecorder has not begun its file</source>
        <translation>LabRecorder n’a pas commencé son fichier</translation>
    </message>
    <message>
        <source>LabRecorder is still starting</source>
        <translation>LabRecorder est encore en train de démarrer</translation>
    </message>
    <message>
        <source>Linux</source>
        <translation>Linux</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Estimation de grandeur</translation>
    </message>
    <message>
        <source>Motion incongruence</source>
        <translation>Incongruence du mouvement</translation>
    </message>
    <message>
        <source>No motion: force here is gravity that was not removed</source>
        <translation>Pas de mouvement&#xa0;: ici, la force est de la pesanteur qui n’a pas été retirée</translation>
    </message>
    <message>
        <source>Permission for {path}</source>
        <translation>Autorisation pour {path}</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Program that listens at {where}</source>
        <translation>Programme qui écoute sur {where}</translation>
    </message>
    <message>
        <source>Python package {name}</source>
        <translation>Paquet Python {name}</translation>
    </message>
    <message>
        <source>Search on this computer</source>
        <translation>Recherche sur cet ordinateur</translation>
    </message>
    <message>
        <source>Sound output {card} with the channels {channels}</source>
        <translation>Sortie son {card} avec les canaux {channels}</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Escalier</translation>
    </message>
    <message>
        <source>Susceptibility (MSSQ-short) and symptoms (SSQ) before and after; during each clip sickness (FMS) each minute, which can end it, and vection by a held key.</source>
        <translation>Susceptibilité (MSSQ-short) et symptômes (SSQ) avant et après&#xa0;; pendant chaque clip, malaise (FMS) chaque minute, qui peut y mettre fin, et vection par une touche maintenue.</translation>
    </message>
    <message>
        <source>Wheel or joystick with a motor</source>
        <translation>Volant ou joystick à moteur</translation>
    </message>
    <message>
        <source>a Williams design contains every pair of neighbours, also of one sequence</source>
        <translation>un plan de Williams contient chaque paire de voisins, même d’une seule séquence</translation>
    </message>
    <message>
        <source>a death ends the force when the kernel has cleared up, 10 to 80 ms</source>
        <translation>un arrêt brutal coupe la force une fois que le noyau a fait le ménage, 10 à 80 ms</translation>
    </message>
    <message>
        <source>a force is not of this study</source>
        <translation>une force n’est pas de cette étude</translation>
    </message>
    <message>
        <source>a frame has the shape {shape}, expected {expected} of uint8</source>
        <translation>une image a la forme {shape}, attendu&#xa0;: {expected} en uint8</translation>
    </message>
    <message>
        <source>a pilot study must have at least five complete participants</source>
        <translation>une étude pilote doit avoir au moins cinq participants complets</translation>
    </message>
    <message>
        <source>a single sequence always follows itself</source>
        <translation>une seule séquence ne peut que se suivre elle-même</translation>
    </message>
    <message>
        <source>a smoother over the whole recording, with the sensor&apos;s errors</source>
        <translation>un lisseur sur tout l’enregistrement, avec les erreurs du capteur</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>add one: it is analysed</source>
        <translation>ajoutez-en une&#xa0;: elle est analysée</translation>
    </message>
    <message>
        <source>adding telemetry</source>
        <translation>ajout de la télémétrie</translation>
    </message>
    <message>
        <source>allowed: {known}</source>
        <translation>autorisé&#xa0;: {known}</translation>
    </message>
    <message>
        <source>alpha and power must be between 0 and 1</source>
        <translation>alpha et la puissance doivent être entre 0 et 1</translation>
    </message>
    <message>
        <source>amplitudes beyond 1 were limited</source>
        <translation>les amplitudes au-delà de 1 ont été limitées</translation>
    </message>
    <message>
        <source>analysing {measure}</source>
        <translation>analyse de {measure}</translation>
    </message>
    <message>
        <source>another rendering needs the folder of the sequence; unpack it</source>
        <translation>un autre rendu demande le dossier de la séquence&#xa0;; dépaquetez-la</translation>
    </message>
    <message>
        <source>cannot be opened again</source>
        <translation>ne peut pas être rouvert</translation>
    </message>
    <message>
        <source>check the address and the network</source>
        <translation>vérifiez l’adresse et le réseau</translation>
    </message>
    <message>
        <source>check the address, or ask who offers the file</source>
        <translation>vérifiez l’adresse, ou demandez à qui propose le fichier</translation>
    </message>
    <message>
        <source>check the network, then open it again</source>
        <translation>vérifiez le réseau, puis ouvrez-le de nouveau</translation>
    </message>
    <message>
        <source>checking {name}</source>
        <translation>vérification de {name}</translation>
    </message>
    <message>
        <source>clipped samples: {force} of the accelerometer ({force_marked} of them not reconstructed, marked as not valid), {rate} of the gyro ({rate_marked})</source>
        <translation>échantillons écrêtés&#xa0;: {force} de l’accéléromètre (dont {force_marked} non reconstruits, marqués comme non valides), {rate} du gyroscope ({rate_marked})</translation>
    </message>
    <message>
        <source>comparing needs two feedbacks or more</source>
        <translation>un seul retour ne peut être comparé à rien</translation>
    </message>
    <message>
        <source>condition {key} is not in the study</source>
        <translation>la condition {key} n’est pas dans l’étude</translation>
    </message>
    <message>
        <source>connection ended</source>
        <translation>connexion terminée</translation>
    </message>
    <message>
        <source>converting</source>
        <translation>conversion</translation>
    </message>
    <message>
        <source>copying the clip</source>
        <translation>copie du clip</translation>
    </message>
    <message>
        <source>does not give parts of this file</source>
        <translation>ne fournit pas de parties de ce fichier</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>download it and play the file</source>
        <translation>téléchargez-le et lisez le fichier</translation>
    </message>
    <message>
        <source>download it, and give the file</source>
        <translation>téléchargez-le, et donnez le fichier</translation>
    </message>
    <message>
        <source>drawing the figures</source>
        <translation>dessin des figures</translation>
    </message>
    <message>
        <source>drawing the ride</source>
        <translation>dessin du parcours</translation>
    </message>
    <message>
        <source>drawing {name}</source>
        <translation>dessin de {name}</translation>
    </message>
    <message>
        <source>duplicate entry {twice!r}</source>
        <translation>entrée en double {twice!r}</translation>
    </message>
    <message>
        <source>duplicate key {key!r}</source>
        <translation>la clé {key!r} figure deux fois</translation>
    </message>
    <message>
        <source>enter a feedback</source>
        <translation>indiquez un retour</translation>
    </message>
    <message>
        <source>estimated from the picture</source>
        <translation>estimé d’après l’image</translation>
    </message>
    <message>
        <source>export the force again</source>
        <translation>exportez de nouveau la force</translation>
    </message>
    <message>
        <source>fifo</source>
        <translation>FIFO</translation>
    </message>
    <message>
        <source>fitting {axis}</source>
        <translation>ajustement de {axis}</translation>
    </message>
    <message>
        <source>following frames needs OpenCV, which is not installed</source>
        <translation>suivre les images nécessite OpenCV, qui n’est pas installé</translation>
    </message>
    <message>
        <source>force belongs to this video, but neither it nor a file {name!r} beside it holds any; ask for both files again, and rename neither alone</source>
        <translation>une force accompagne cette vidéo, mais ni elle ni un fichier {name!r} à côté ne la contient&#xa0;; redemandez les deux fichiers et n’en renommez pas un seul</translation>
    </message>
    <message>
        <source>found no order in which no sequence is played twice in a row</source>
        <translation>aucun ordre trouvé dans lequel aucune séquence n’est jouée deux fois de suite</translation>
    </message>
    <message>
        <source>get the package again, or pack the study again</source>
        <translation>procurez-vous de nouveau le paquet, ou empaquetez de nouveau l’étude</translation>
    </message>
    <message>
        <source>give a link that needs none, such as a signed one</source>
        <translation>donnez un lien qui s’en passe, par exemple un lien signé</translation>
    </message>
    <message>
        <source>give one that begins with http:// or https://</source>
        <translation>donnez-en une qui commence par http:// ou https://</translation>
    </message>
    <message>
        <source>give the address that it leads to, if you trust it</source>
        <translation>donnez l’adresse à laquelle elle mène, si vous lui faites confiance</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>disparu</translation>
    </message>
    <message>
        <source>has a different number of columns</source>
        <translation>a un nombre de colonnes différent</translation>
    </message>
    <message>
        <source>has no choice of one answer after the clips</source>
        <translation>n’a pas de question à choix unique après les clips</translation>
    </message>
    <message>
        <source>has no question after a clip</source>
        <translation>ne demande rien après un clip</translation>
    </message>
    <message>
        <source>has no question for a number after a clip</source>
        <translation>n’a pas de question demandant un nombre après un clip</translation>
    </message>
    <message>
        <source>has no rows</source>
        <translation>n’a pas de lignes</translation>
    </message>
    <message>
        <source>has records of version {found}, this program reads {version}</source>
        <translation>contient des données de la version {found}, ce programme lit {version}</translation>
    </message>
    <message>
        <source>has two axes</source>
        <translation>a deux axes</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>entendu</translation>
    </message>
    <message>
        <source>holds a user name or password, which would be shown and stored</source>
        <translation>contient un nom d’utilisateur ou un mot de passe, qui serait affiché et enregistré</translation>
    </message>
    <message>
        <source>holds no motion that can be read</source>
        <translation>ne contient pas de mouvement lisible</translation>
    </message>
    <message>
        <source>hypothesis {text!r}: there is no {name!r}; choose one of {known}</source>
        <translation>hypothèse {text!r}&#xa0;: il n’y a pas de {name!r}&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>imu: {what}; from now on it has another clock</source>
        <translation>imu&#xa0;: {what}&#xa0;; à partir de maintenant, elle a une autre horloge</translation>
    </message>
    <message>
        <source>imu: {what}; the other streams continue, and it is recorded again as soon as it is back</source>
        <translation>imu&#xa0;: {what}&#xa0;; le reste continue, et elle sera reprise dès son retour</translation>
    </message>
    <message>
        <source>intensities beyond their range were limited</source>
        <translation>les intensités hors de leur plage ont été limitées</translation>
    </message>
    <message>
        <source>is being changed by another program</source>
        <translation>est en cours de modification par un autre programme</translation>
    </message>
    <message>
        <source>is damaged or missing, and the definition of the study has changed</source>
        <translation>est endommagé ou manquant, et la définition de l’étude a changé</translation>
    </message>
    <message>
        <source>is damaged or was altered (its checksum differs)</source>
        <translation>est endommagé ou a été modifié (sa somme de contrôle diffère)</translation>
    </message>
    <message>
        <source>is empty or has become shorter</source>
        <translation>est vide ou a raccourci</translation>
    </message>
    <message>
        <source>is missing: what the other force is compared with</source>
        <translation>manque&#xa0;: ce à quoi l’autre force est comparée</translation>
    </message>
    <message>
        <source>is not UTF-8 text</source>
        <translation>n’est pas du texte en UTF-8</translation>
    </message>
    <message>
        <source>is not a manifest of hapticplayer</source>
        <translation>n’est pas un manifeste de hapticplayer</translation>
    </message>
    <message>
        <source>is not a question of this page</source>
        <translation>n’est pas une question de cette page</translation>
    </message>
    <message>
        <source>is not a session</source>
        <translation>n’est pas une séance</translation>
    </message>
    <message>
        <source>is not a valid key</source>
        <translation>n’est pas une clé valide</translation>
    </message>
    <message>
        <source>is not the address of a file</source>
        <translation>n’est pas l’adresse d’un fichier</translation>
    </message>
    <message>
        <source>is not the definition of a study</source>
        <translation>ne décrit pas d’étude</translation>
    </message>
    <message>
        <source>is not used in ratings by {kind}</source>
        <translation>n’est pas utilisé dans les évaluations par {kind}</translation>
    </message>
    <message>
        <source>is not used without stop_at</source>
        <translation>n’est pas utilisé sans stop_at</translation>
    </message>
    <message>
        <source>is not valid JSON ({reason})</source>
        <translation>n’est pas du JSON valable ({reason})</translation>
    </message>
    <message>
        <source>is only used after the last trial</source>
        <translation>n’est utilisé qu’après le dernier essai</translation>
    </message>
    <message>
        <source>is only used with LSL</source>
        <translation>n’est utilisé qu’avec LSL</translation>
    </message>
    <message>
        <source>is refused by its server (status {status})</source>
        <translation>est refusé par son serveur (statut {status})</translation>
    </message>
    <message>
        <source>is the consent of {code}</source>
        <translation>est le consentement de {code}</translation>
    </message>
    <message>
        <source>is the plan of the study {found}, not {expected}</source>
        <translation>est le plan de l’étude {found}, et non de {expected}</translation>
    </message>
    <message>
        <source>is the session of {code}</source>
        <translation>est la séance de {code}</translation>
    </message>
    <message>
        <source>is_valid and reasons contradict each other</source>
        <translation>is_valid et reasons se contredisent</translation>
    </message>
    <message>
        <source>it appears twice</source>
        <translation>elle figure deux fois</translation>
    </message>
    <message>
        <source>it asks for none</source>
        <translation>elle n’en demande plus</translation>
    </message>
    <message>
        <source>it belongs to the study {found}</source>
        <translation>elle appartient à l’étude {found}</translation>
    </message>
    <message>
        <source>it holds half a character</source>
        <translation>il contient un demi-caractère</translation>
    </message>
    <message>
        <source>it holds no gyroscope, or its sensors share a clock</source>
        <translation>il ne contient pas de gyroscope, ou ses capteurs partagent une horloge</translation>
    </message>
    <message>
        <source>it holds no sound, in which taps could be heard</source>
        <translation>elle ne contient pas de son où des tapotements pourraient s’entendre</translation>
    </message>
    <message>
        <source>it holds no such samples, or states their unit</source>
        <translation>il ne contient pas de telles mesures, ou indique leur unité</translation>
    </message>
    <message>
        <source>it is {container}, which is not read</source>
        <translation>c’est {container}, qui n’est pas lu</translation>
    </message>
    <message>
        <source>it looks like microseconds: divide {scale} by 1000000</source>
        <translation>cela ressemble à des microsecondes&#xa0;: divisez {scale} par 1000000</translation>
    </message>
    <message>
        <source>it looks like milliseconds: divide {scale} by 1000</source>
        <translation>cela ressemble à des millisecondes&#xa0;: divisez {scale} par 1000</translation>
    </message>
    <message>
        <source>it looks like nanoseconds: divide {scale} by 1000000000</source>
        <translation>cela ressemble à des nanosecondes&#xa0;: divisez {scale} par 1000000000</translation>
    </message>
    <message>
        <source>it played another sequence {key!r} than was packed</source>
        <translation>elle a joué une autre séquence {key!r} que celle qui a été empaquetée</translation>
    </message>
    <message>
        <source>it ran a definition that was altered after the study was packed</source>
        <translation>elle a suivi une définition modifiée après l’empaquetage de l’étude</translation>
    </message>
    <message>
        <source>it seems to be in {unit}: multiply it by {factor:.6g}</source>
        <translation>cela semble être en {unit}&#xa0;: multipliez par {factor:.6g}</translation>
    </message>
    <message>
        <source>it was closed</source>
        <translation>elle a été fermée</translation>
    </message>
    <message>
        <source>it was recorded at {captured_hz:g} frames per second and plays at {shown_hz:g}</source>
        <translation>il a été enregistré à {captured_hz:g} images par seconde et est lu à {shown_hz:g}</translation>
    </message>
    <message>
        <source>its accelerometer reads {norm:.3g} m/s2 where it is calm, and its {sensor} would read {found:.3g}, as gravity: these columns are swapped</source>
        <translation>son accéléromètre mesure {norm:.3g} m/s2 au calme, et {sensor} donnerait {found:.3g}, comme la pesanteur&#xa0;: ces colonnes sont échangées</translation>
    </message>
    <message>
        <source>its checksum differs</source>
        <translation>sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>its clip has changed since it was imported (its checksum differs)</source>
        <translation>son clip a changé depuis l’importation (sa somme de contrôle diffère)</translation>
    </message>
    <message>
        <source>its columns are known</source>
        <translation>ses colonnes sont connues</translation>
    </message>
    <message>
        <source>its definition was altered since the study was packed</source>
        <translation>sa définition a été modifiée depuis l’empaquetage de l’étude</translation>
    </message>
    <message>
        <source>its edit list stretches time</source>
        <translation>sa liste de montage étire le temps</translation>
    </message>
    <message>
        <source>its force is 0 N from beginning to end</source>
        <translation>sa force est de 0 N du début à la fin</translation>
    </message>
    <message>
        <source>its format tells its sensors apart, or it does not have both</source>
        <translation>son format distingue ses capteurs, ou il n’a pas les deux</translation>
    </message>
    <message>
        <source>its frames are shown at other times</source>
        <translation>ses images sont montrées à d’autres moments</translation>
    </message>
    <message>
        <source>its frames of {width} x {height} pixels are too large (up to 8192 x 4320 are shown)</source>
        <translation>ses images de {width} x {height} pixels sont trop grandes (jusqu’à 8192 x 4320 sont montrées)</translation>
    </message>
    <message>
        <source>its gyroscope reads exactly 0 about {axes} throughout, but gravity turns in its accelerometer as it does not show</source>
        <translation>son gyroscope indique partout exactement 0 autour de {axes}, mais la pesanteur tourne dans son accéléromètre sans qu’il le montre</translation>
    </message>
    <message>
        <source>its gyroscope shows how gravity turns in its accelerometer {size_s:.2f} s too {how}: their clocks differ</source>
        <translation>son gyroscope montre la rotation de la pesanteur dans son accéléromètre {size_s:.2f} s trop {how}&#xa0;: leurs horloges diffèrent</translation>
    </message>
    <message>
        <source>its index lists {count} frames and pieces of sound, which is too much (limit: {most})</source>
        <translation>son index annonce {count} images et morceaux de son, c’est trop (limite&#xa0;: {most})</translation>
    </message>
    <message>
        <source>its index, tags or chapters are too large ({size_mb} MB)</source>
        <translation>son index, ses balises ou ses chapitres sont trop grands ({size_mb} Mo)</translation>
    </message>
    <message>
        <source>its last part names no variant of it</source>
        <translation>sa dernière partie n’en nomme aucune variante</translation>
    </message>
    <message>
        <source>its metadata say that it is a time lapse</source>
        <translation>d’après ses métadonnées, c’est un accéléré</translation>
    </message>
    <message>
        <source>its pixel format cannot be converted</source>
        <translation>son format de pixels ne peut pas être converti</translation>
    </message>
    <message>
        <source>its samples have times, or a rate of their own</source>
        <translation>ses mesures ont des temps, ou leur propre cadence</translation>
    </message>
    <message>
        <source>its server does not give parts of files (HTTP ranges)</source>
        <translation>son serveur ne fournit pas de parties de fichiers (plages HTTP)</translation>
    </message>
    <message>
        <source>its sound is heard at other times</source>
        <translation>son son est entendu à d’autres moments</translation>
    </message>
    <message>
        <source>its subtitles cannot be read</source>
        <translation>ses sous-titres ne peuvent pas être lus</translation>
    </message>
    <message>
        <source>its time</source>
        <translation>son temps</translation>
    </message>
    <message>
        <source>its tracks cannot be listed</source>
        <translation>ses pistes ne peuvent pas être listées</translation>
    </message>
    <message>
        <source>its video is not the one that the force was made for ({reason})</source>
        <translation>sa vidéo n’est pas celle pour laquelle la force a été faite ({reason})</translation>
    </message>
    <message>
        <source>keep the calibration of another recording</source>
        <translation>gardez l’étalonnage d’un autre enregistrement</translation>
    </message>
    <message>
        <source>larger than a file on the disk at {disk} may be (ulimit -f)</source>
        <translation>plus grand que ne peut l’être un fichier sur le disque {disk} (ulimit -f)</translation>
    </message>
    <message>
        <source>late</source>
        <translation>tard</translation>
    </message>
    <message>
        <source>left out: nothing</source>
        <translation>omis&#xa0;: rien</translation>
    </message>
    <message>
        <source>left out: {what}</source>
        <translation>omis&#xa0;: {what}</translation>
    </message>
    <message>
        <source>listening</source>
        <translation>écoute du son</translation>
    </message>
    <message>
        <source>low</source>
        <translation>petite</translation>
    </message>
    <message>
        <source>magnetometer</source>
        <translation>magnétomètre</translation>
    </message>
    <message>
        <source>make an MP4 of it with: {command}</source>
        <translation>faites-en un MP4 avec&#xa0;: {command}</translation>
    </message>
    <message>
        <source>make the force again</source>
        <translation>recalculez la force</translation>
    </message>
    <message>
        <source>malformed replies from the device</source>
        <translation>réponses invalides de l’appareil</translation>
    </message>
    <message>
        <source>media keys; the screen stays awake while a clip plays</source>
        <translation>touches multimédias&#xa0;; l’écran reste allumé pendant la lecture d’un clip</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>inversé en miroir</translation>
    </message>
    <message>
        <source>missing entry {name!r}</source>
        <translation>entrée manquante {name!r}</translation>
    </message>
    <message>
        <source>motion track of the camera, which may hold places (only an MP4 has it)</source>
        <translation>piste de mouvement de la caméra, qui peut contenir des lieux (seul un MP4 l’a)</translation>
    </message>
    <message>
        <source>move it to its own study</source>
        <translation>déplacez-la dans sa propre étude</translation>
    </message>
    <message>
        <source>move the grip to the centre first, then re-arm again</source>
        <translation>ramenez d’abord la poignée au centre, puis réarmez encore une fois</translation>
    </message>
    <message>
        <source>must be a letter from a to z, enter, shift or control</source>
        <translation>doit être une lettre de a à z, enter, shift ou control</translation>
    </message>
    <message>
        <source>must be more than least</source>
        <translation>doit être supérieur à least</translation>
    </message>
    <message>
        <source>must be one of the choices</source>
        <translation>a une réponse qui n’était pas proposée</translation>
    </message>
    <message>
        <source>must be {wanted}, not {kind}</source>
        <translation>doit être {wanted}, et non {kind}</translation>
    </message>
    <message>
        <source>must have 2 to {most} conditions, has {count}</source>
        <translation>donne {count} conditions&#xa0;; de 2 à {most} sont possibles</translation>
    </message>
    <message>
        <source>name of a file</source>
        <translation>nom d’un fichier</translation>
    </message>
    <message>
        <source>name or number of a device</source>
        <translation>nom ou numéro d’un appareil</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>imbriqué trop profondément</translation>
    </message>
    <message>
        <source>no data from the device yet</source>
        <translation>pas encore de données de l’appareil</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>aucun appareil</translation>
    </message>
    <message>
        <source>no estimated sway: no turns beyond what may be an error</source>
        <translation>pas de balancement estimé&#xa0;: aucun virage plus grand qu’une erreur possible</translation>
    </message>
    <message>
        <source>no force track</source>
        <translation>pas de piste de force</translation>
    </message>
    <message>
        <source>no joystick was found, but a rating is moved by one</source>
        <translation>aucun joystick n’a été trouvé, mais une évaluation en demande un</translation>
    </message>
    <message>
        <source>no media keys, and the screen may go dark while a clip plays</source>
        <translation>pas de touches multimédias, et l’écran peut s’éteindre pendant la lecture d’un clip</translation>
    </message>
    <message>
        <source>no part of the program is paged out</source>
        <translation>aucune partie du programme n’est déplacée sur le disque</translation>
    </message>
    <message>
        <source>no participant {code}</source>
        <translation>aucun participant {code}</translation>
    </message>
    <message>
        <source>no question has a published wording</source>
        <translation>aucune question n’a de formulation publiée</translation>
    </message>
    <message>
        <source>no sensor of it was stuck</source>
        <translation>aucun de ses capteurs n’était bloqué</translation>
    </message>
    <message>
        <source>no three taps are both heard and felt</source>
        <translation>aucune série de trois tapotements n’est à la fois entendue et sentie</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>none of its frames can be decoded</source>
        <translation>aucune de ses images ne peut être décodée</translation>
    </message>
    <message>
        <source>not compared with the track</source>
        <translation>non comparé à la piste</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>non confirmé</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>repère perdu</translation>
    </message>
    <message>
        <source>not read: the columns {names}</source>
        <translation>non lu&#xa0;: les colonnes {names}</translation>
    </message>
    <message>
        <source>not read: {what} beside it</source>
        <translation>non lu&#xa0;: {what} à côté</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>pas encore</translation>
    </message>
    <message>
        <source>nothing was played: {cause}; {remedy}</source>
        <translation>rien n’a été joué&#xa0;: {cause}&#xa0;; {remedy}</translation>
    </message>
    <message>
        <source>of {count} reference devices the first was taken</source>
        <translation>sur {count} appareils de référence, le premier a été pris</translation>
    </message>
    <message>
        <source>offer the first and the second clip</source>
        <translation>proposez le premier et le second clip</translation>
    </message>
    <message>
        <source>only {free_mb} MB of the disk are free, enough for {minutes:.0f} min</source>
        <translation>il ne reste que {free_mb} Mo libres sur le disque, assez pour {minutes:.0f} min</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>ouvrez-le de nouveau</translation>
    </message>
    <message>
        <source>open the study again and repeat the change</source>
        <translation>ouvrez de nouveau l’étude et refaites la modification</translation>
    </message>
    <message>
        <source>other programs may delay the force: close them</source>
        <translation>d’autres programmes peuvent retarder la force&#xa0;: fermez-les</translation>
    </message>
    <message>
        <source>otherwise enter the offset</source>
        <translation>sinon, saisissez le décalage</translation>
    </message>
    <message>
        <source>planned force, velocity, buttons and timing of each tick</source>
        <translation>force prévue, vitesse, boutons et temps de chaque période</translation>
    </message>
    <message>
        <source>play a clip, and tick the box if you hear it</source>
        <translation>jouez un clip, et cochez la case si vous l’entendez</translation>
    </message>
    <message>
        <source>play again</source>
        <translation>relancez la lecture</translation>
    </message>
    <message>
        <source>player ended</source>
        <translation>lecteur terminé</translation>
    </message>
    <message>
        <source>plug it in, or add yourself to the group &apos;input&apos;</source>
        <translation>branchez-le, ou ajoutez-vous au groupe &apos;input&apos;</translation>
    </message>
    <message>
        <source>plug it in, then begin the session again</source>
        <translation>branchez-le, puis recommencez la séance</translation>
    </message>
    <message>
        <source>predicting excursions</source>
        <translation>prévision des excursions</translation>
    </message>
    <message>
        <source>processors are kept out of deep sleep while a force may be on</source>
        <translation>les processeurs restent hors du sommeil profond tant qu’une force peut agir</translation>
    </message>
    <message>
        <source>processors may sleep deeply: the loop wakes up some 20 us later</source>
        <translation>les processeurs peuvent dormir profondément&#xa0;: la boucle se réveille environ 20 µs plus tard</translation>
    </message>
    <message>
        <source>pull the grip all the way out, then push it in until it locks</source>
        <translation>tirez la poignée à fond, puis poussez-la jusqu’à ce qu’elle se bloque</translation>
    </message>
    <message>
        <source>rate-axes={axes} to keep both as they are</source>
        <translation>rate-axes={axes} pour garder les deux tels quels</translation>
    </message>
    <message>
        <source>rate-delay=0 to keep both as they are</source>
        <translation>rate-delay=0 pour les laisser tous deux tels quels</translation>
    </message>
    <message>
        <source>rate-delay={delay_s:.2f} to take it back</source>
        <translation>rate-delay={delay_s:.2f} pour le compenser</translation>
    </message>
    <message>
        <source>rate-unit={unit} to scale it to gravity</source>
        <translation>rate-unit={unit} pour l’ajuster à la pesanteur</translation>
    </message>
    <message>
        <source>read as telemetry of the camera: specific force in m/s2, angular rate in rad/s; x right, y forward, z up{rest}; up to {largest_radps:.2f} rad/s</source>
        <translation>lu comme télémétrie de la caméra&#xa0;: force spécifique en m/s2, vitesse angulaire en rad/s&#xa0;; x à droite, y devant, z en haut{rest}&#xa0;; jusqu’à {largest_radps:.2f} rad/s</translation>
    </message>
    <message>
        <source>reading the answers</source>
        <translation>lecture des réponses</translation>
    </message>
    <message>
        <source>reading the sessions</source>
        <translation>lecture des séances</translation>
    </message>
    <message>
        <source>reading {name}</source>
        <translation>lecture de {name}</translation>
    </message>
    <message>
        <source>record at 100 Hz or more, or enter the offset</source>
        <translation>enregistrez à 100 Hz ou plus, ou saisissez le décalage</translation>
    </message>
    <message>
        <source>record both</source>
        <translation>enregistrez les deux</translation>
    </message>
    <message>
        <source>record it again</source>
        <translation>refaites l’enregistrement</translation>
    </message>
    <message>
        <source>record with sound, or enter the offset</source>
        <translation>enregistrez avec du son, ou saisissez le décalage</translation>
    </message>
    <message>
        <source>record {number} ({kind}) was left out: {reason}</source>
        <translation>l’entrée {number} ({kind}) a été omise&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>record {number}: the answer to {name!r} in {step} was left out: {reason}</source>
        <translation>entrée {number}&#xa0;: la réponse à {name!r} dans {step} a été omise&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>redirects from {scheme} to another scheme</source>
        <translation>redirige de {scheme} vers un autre schéma</translation>
    </message>
    <message>
        <source>redirects to a private address</source>
        <translation>redirige vers une adresse privée</translation>
    </message>
    <message>
        <source>redirects too often</source>
        <translation>redirige trop souvent</translation>
    </message>
    <message>
        <source>reference device {number:g} is not in the file; the first was taken</source>
        <translation>l’appareil de référence {number:g} n’est pas dans le fichier&#xa0;; le premier a été pris</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>enlevez-le</translation>
    </message>
    <message>
        <source>remove the column</source>
        <translation>supprimez la colonne</translation>
    </message>
    <message>
        <source>remove the constraint</source>
        <translation>retirez la contrainte</translation>
    </message>
    <message>
        <source>remove the constraint or add sequences</source>
        <translation>abandonnez la contrainte ou ajoutez des séquences</translation>
    </message>
    <message>
        <source>remove the constraint or choose random or latin-square</source>
        <translation>abandonnez la contrainte ou choisissez random ou latin-square</translation>
    </message>
    <message>
        <source>removing gravity</source>
        <translation>retrait de la pesanteur</translation>
    </message>
    <message>
        <source>remux it with FFmpeg (-c copy)</source>
        <translation>remuxez-la avec FFmpeg (-c copy)</translation>
    </message>
    <message>
        <source>remux it with MKVToolNix or FFmpeg, without them</source>
        <translation>remultiplexez-le sans eux avec MKVToolNix ou FFmpeg</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>renommez-le</translation>
    </message>
    <message>
        <source>rename it to {name!r} to feel it as {as_what}</source>
        <translation>renommez-le {name!r} pour le sentir comme {as_what}</translation>
    </message>
    <message>
        <source>rename one of them</source>
        <translation>renommez l’une d’elles</translation>
    </message>
    <message>
        <source>rendering the force</source>
        <translation>calcul de la force</translation>
    </message>
    <message>
        <source>restore the old sequence, or stop this session</source>
        <translation>rétablissez l’ancienne séquence, ou arrêtez cette séance</translation>
    </message>
    <message>
        <source>riding</source>
        <translation>parcours</translation>
    </message>
    <message>
        <source>rig option id={id} has no effect: packets of {format} have no ID; leave it out</source>
        <translation>l’option de plateforme id={id} est sans effet&#xa0;: les paquets de {format} n’ont pas d’ID&#xa0;; omettez-la</translation>
    </message>
    <message>
        <source>rotations</source>
        <translation>rotations</translation>
    </message>
    <message>
        <source>rotations, and what of the motion changes within {span_ms} ms</source>
        <translation>les rotations, et ce qui change dans le mouvement en moins de {span_ms} ms</translation>
    </message>
    <message>
        <source>samples of {bits} bits were taken from the lower end of {width} bytes</source>
        <translation>des échantillons de {bits} bits ont été pris dans le bas de {width} octets</translation>
    </message>
    <message>
        <source>save it with the line ends of Unix or Windows</source>
        <translation>enregistrez-le avec les fins de ligne d’Unix ou de Windows</translation>
    </message>
    <message>
        <source>save the answers of another log</source>
        <translation>enregistrez les réponses d’un autre journal</translation>
    </message>
    <message>
        <source>say it once</source>
        <translation>ne le donnez qu’une fois</translation>
    </message>
    <message>
        <source>session {code}: {key} was left out; it is not in the definition</source>
        <translation>séance {code}&#xa0;: {key} a été omis&#xa0;; absent de la définition</translation>
    </message>
    <message>
        <source>set &apos;lsl&apos; to true</source>
        <translation>mettez &apos;lsl&apos; à true</translation>
    </message>
    <message>
        <source>set the device up first</source>
        <translation>configurez d’abord l’appareil</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>raccourcissez-le</translation>
    </message>
    <message>
        <source>simulated {begin} of {studies} studies</source>
        <translation>{begin} études simulées sur {studies}</translation>
    </message>
    <message>
        <source>simulating studies of {size} participants</source>
        <translation>simulation d’études de {size} participants</translation>
    </message>
    <message>
        <source>skipping a step needs a reason</source>
        <translation>sauter une étape demande un motif</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>tranche</translation>
    </message>
    <message>
        <source>sort the file by time and remove duplicates</source>
        <translation>triez le fichier par temps et supprimez les doublons</translation>
    </message>
    <message>
        <source>spikes removed from {force} accelerometer, {rate} gyro, {field} magnetometer samples; {kept} samples stood out and were left as motion</source>
        <translation>pics retirés de {force} échantillons de l’accéléromètre, {rate} du gyroscope, {field} du magnétomètre&#xa0;; {kept} échantillons saillants laissés comme mouvement</translation>
    </message>
    <message>
        <source>start LabRecorder on this computer, tick &apos;Enable RCS&apos; and look at its window, then begin the session again</source>
        <translation>lancez LabRecorder sur cet ordinateur, cochez «&#xa0;Enable RCS&#xa0;» et regardez sa fenêtre, puis recommencez la séance</translation>
    </message>
    <message>
        <source>start a new session</source>
        <translation>commencez-en une nouvelle</translation>
    </message>
    <message>
        <source>start them, then begin the trial again</source>
        <translation>lancez-les, puis recommencez l’essai</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>démarrage</translation>
    </message>
    <message>
        <source>stop what it records, then begin the session again</source>
        <translation>arrêtez ce qu’il enregistre, puis recommencez la séance</translation>
    </message>
    <message>
        <source>stopped: {cause}; {remedy}</source>
        <translation>arrêté&#xa0;: {cause}&#xa0;; {remedy}</translation>
    </message>
    <message>
        <source>strengths</source>
        <translation>intensités</translation>
    </message>
    <message>
        <source>stuck must be no-force</source>
        <translation>stuck doit être no-force</translation>
    </message>
    <message>
        <source>stuck=no-force to have no force there, or record it again</source>
        <translation>stuck=no-force pour n’y avoir aucune force, ou refaites l’enregistrement</translation>
    </message>
    <message>
        <source>swapped must be {known}</source>
        <translation>swapped doit être {known}</translation>
    </message>
    <message>
        <source>swapped=no to keep them</source>
        <translation>swapped=no pour les garder</translation>
    </message>
    <message>
        <source>swapped={key} to swap them</source>
        <translation>swapped={key} pour les échanger</translation>
    </message>
    <message>
        <source>synchronising</source>
        <translation>synchronisation</translation>
    </message>
    <message>
        <source>takes column {number} for {name}, but it holds {text!r}; ignore it with -, or write it as numbers</source>
        <translation>prend la colonne {number} pour {name}, mais elle contient {text!r}&#xa0;; ignorez-la avec -, ou écrivez-la en nombres</translation>
    </message>
    <message>
        <source>the angular rate is not that of the camera in the frames of the clip, but would be if it were {scale:.3g} times as large</source>
        <translation>la vitesse angulaire n’est pas celle de la caméra dans les images du clip, mais le serait si elle était {scale:.3g} fois plus grande</translation>
    </message>
    <message>
        <source>the answers to {key!r} must be two: the clips</source>
        <translation>les réponses à {key!r} doivent être deux&#xa0;: les clips</translation>
    </message>
    <message>
        <source>the camera does not move: there is nothing to estimate</source>
        <translation>la caméra est immobile&#xa0;: rien à estimer</translation>
    </message>
    <message>
        <source>the camera in the frames does not turn as the gyroscope does, in any axes: a stabilised video, another offset, or the log of another clip</source>
        <translation>la caméra dans les images ne tourne pas comme le gyroscope, quels que soient les axes&#xa0;: vidéo stabilisée, autre décalage ou journal d’un autre clip</translation>
    </message>
    <message>
        <source>the camera in the frames turns as the gyroscope does</source>
        <translation>la caméra dans les images tourne comme le gyroscope</translation>
    </message>
    <message>
        <source>the camera turns too little to show the time</source>
        <translation>la caméra tourne trop peu pour indiquer le temps</translation>
    </message>
    <message>
        <source>the camera&apos;s rotation can be estimated in only {told_s:.2f} s of the video, at least {least_s:.0f} s are needed</source>
        <translation>la rotation de la caméra ne peut être estimée que dans {told_s:.2f} s de la vidéo, il en faut au moins {least_s:.0f} s</translation>
    </message>
    <message>
        <source>the camera&apos;s rotation in its frames against the gyro; coarse without the extra vision</source>
        <translation>la rotation de la caméra dans ses images contre le gyroscope&#xa0;; grossière sans l’extra vision</translation>
    </message>
    <message>
        <source>the camera&apos;s rotation in the frames fits the log nowhere (is it the log of this clip, and the video not stabilised?)</source>
        <translation>la rotation de la caméra dans les images ne correspond nulle part au journal (est-ce celui de cette vidéo, et la vidéo n’est-elle pas stabilisée&#xa0;?)</translation>
    </message>
    <message>
        <source>the causal filter of Laidig and Seel 2023</source>
        <translation>le filtre causal de Laidig et Seel 2023</translation>
    </message>
    <message>
        <source>the clip has no sound, which taps need</source>
        <translation>il n’y a pas de son où des tapotements pourraient s’entendre</translation>
    </message>
    <message>
        <source>the clip has {rate_hz:.0f} frames per second, too few to suggest motion; it needs {least_hz:.0f}</source>
        <translation>le clip a {rate_hz:.0f} images par seconde, trop peu pour suggérer un mouvement&#xa0;; il en faut {least_hz:.0f}</translation>
    </message>
    <message>
        <source>the clip is damaged: some of its frames are missing or broken</source>
        <translation>le clip est endommagé&#xa0;: certaines de ses images manquent ou sont défectueuses</translation>
    </message>
    <message>
        <source>the clip is too short to suggest motion; it needs {least_s:g} s</source>
        <translation>le clip est trop court pour suggérer un mouvement&#xa0;; il faut {least_s:g} s</translation>
    </message>
    <message>
        <source>the clip needs {needed_mb} MB and only {free_mb} MB are free</source>
        <translation>le clip demande {needed_mb} Mo, et seulement {free_mb} Mo sont libres</translation>
    </message>
    <message>
        <source>the clip was cut and joined, or its times were changed</source>
        <translation>le clip a été coupé et recollé, ou ses temps ont été changés</translation>
    </message>
    <message>
        <source>the clocks differ by {ppm:.0f} ppm or more: is the video played at the frame rate it was recorded with?</source>
        <translation>les horloges diffèrent d’au moins {ppm:.0f} ppm&#xa0;: la vidéo est-elle lue à la fréquence d’images à laquelle elle a été filmée&#xa0;?</translation>
    </message>
    <message>
        <source>the columns must be {columns}</source>
        <translation>les colonnes doivent être {columns}</translation>
    </message>
    <message>
        <source>the current page is {page}, not {expected}</source>
        <translation>c’est la page {page}, pas {expected}</translation>
    </message>
    <message>
        <source>the death of the player or its loop ends the force at once</source>
        <translation>l’arrêt brutal du lecteur ou de sa boucle coupe aussitôt la force</translation>
    </message>
    <message>
        <source>the device driver failed ({reason}); report this, and choose the device again</source>
        <translation>le pilote de l’appareil a échoué ({reason})&#xa0;; signalez-le, et choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the direction of the force</source>
        <translation>la direction de la force</translation>
    </message>
    <message>
        <source>the disk at {disk} is full</source>
        <translation>le disque sur {disk} est plein</translation>
    </message>
    <message>
        <source>the environment of the program</source>
        <translation>l’environnement du programme</translation>
    </message>
    <message>
        <source>the extension {name!r} cannot be used: {reason}; update or uninstall it</source>
        <translation>l’extension {name!r} ne peut pas être utilisée&#xa0;: {reason}&#xa0;; mettez-la à jour ou désinstallez-la</translation>
    </message>
    <message>
        <source>the force after the end of the clip ({end_s:.3f} s)</source>
        <translation>la force après la fin du clip ({end_s:.3f} s)</translation>
    </message>
    <message>
        <source>the force before 0 s</source>
        <translation>la force avant 0 s</translation>
    </message>
    <message>
        <source>the force goes on until {end_s:.3f} s, the clip ends at {clip_s:.3f} s</source>
        <translation>la force dure jusqu’à {end_s:.3f} s, le clip finit à {clip_s:.3f} s</translation>
    </message>
    <message>
        <source>the force in newtons</source>
        <translation>la force en newtons</translation>
    </message>
    <message>
        <source>the force is stopped; re-arm it first</source>
        <translation>la force est coupée&#xa0;; réarmez-la d’abord</translation>
    </message>
    <message>
        <source>the frames show an offset of {offset_s:.3f} s</source>
        <translation>les images montrent un décalage de {offset_s:.3f} s</translation>
    </message>
    <message>
        <source>the guard could not be started: {reason}</source>
        <translation>le gardien n’a pas pu démarrer&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the guard of the haptics process has ended, so the force is off; choose the device again</source>
        <translation>le processus de garde s’est terminé, la force est coupée&#xa0;; choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the gyroscope&apos;s axes were not compared with the frames: the camera hardly turns</source>
        <translation>les axes du gyroscope n’ont pas été comparés aux images&#xa0;: la caméra tourne à peine</translation>
    </message>
    <message>
        <source>the haptics process did not become ready in time; try again, and run &apos;hapticplayer doctor&apos; if it fails again</source>
        <translation>le processus haptique n’a pas été prêt à temps&#xa0;; réessayez, puis lancez &apos;hapticplayer doctor&apos; si l’échec se répète</translation>
    </message>
    <message>
        <source>the haptics process has ended, so the force is off; choose the device again</source>
        <translation>le processus haptique s’est terminé, la force est coupée&#xa0;; choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the haptics process has ended; test the device again</source>
        <translation>le processus haptique est terminé&#xa0;; testez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the home folder is unknown; set {variable} to the firmware&apos;s path</source>
        <translation>le dossier personnel est inconnu&#xa0;; donnez à {variable} le chemin du micrologiciel</translation>
    </message>
    <message>
        <source>the joystick cannot be opened ({reason})</source>
        <translation>le joystick ne peut pas être ouvert ({reason})</translation>
    </message>
    <message>
        <source>the kind is not known</source>
        <translation>le type est inconnu</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>le langage</translation>
    </message>
    <message>
        <source>the last step must be above 0 and not above the first change</source>
        <translation>le dernier pas doit être supérieur à 0 et ne pas dépasser le premier changement</translation>
    </message>
    <message>
        <source>the last {count} samples are missing</source>
        <translation>les {count} derniers échantillons manquent</translation>
    </message>
    <message>
        <source>the log has no angular rate, which frames could be compared with</source>
        <translation>le journal ne contient pas de vitesse angulaire à laquelle comparer les images</translation>
    </message>
    <message>
        <source>the loop comes before other programs: 3 late wake-ups a minute</source>
        <translation>la boucle passe avant les autres programmes&#xa0;: 3 réveils tardifs par minute</translation>
    </message>
    <message>
        <source>the loop competes with other programs: 22 late wake-ups a minute</source>
        <translation>la boucle est en concurrence avec d’autres programmes&#xa0;: 22 réveils tardifs par minute</translation>
    </message>
    <message>
        <source>the method frames needs a clip</source>
        <translation>la méthode frames a besoin d’un clip</translation>
    </message>
    <message>
        <source>the mixed model cannot be fitted: answers of at least {least} participants to all feedbacks are needed, and not all alike</source>
        <translation>le modèle mixte ne peut pas être ajusté&#xa0;: il faut des réponses d’au moins {least} participants à tous les retours, et pas toutes pareilles</translation>
    </message>
    <message>
        <source>the mixed model cannot be fitted: nearly all answers to a feedback are at an end of the scale; use the rank tests</source>
        <translation>le modèle mixte ne peut pas être ajusté&#xa0;: presque toutes les réponses à un retour sont à un bout de l’échelle&#xa0;; utilisez les tests de rangs</translation>
    </message>
    <message>
        <source>the motion in clips of Sony and Insta360 is not read</source>
        <translation>le mouvement des clips de Sony et d’Insta360 n’est pas lu</translation>
    </message>
    <message>
        <source>the offset you give, if any; else the clock that clip and log share; else taps and frames</source>
        <translation>le décalage indiqué, s’il y en a un&#xa0;; sinon l’horloge commune du clip et du journal&#xa0;; sinon tapotements et images</translation>
    </message>
    <message>
        <source>the point {at} has two labels</source>
        <translation>le point {at} a deux libellés</translation>
    </message>
    <message>
        <source>the quaternion Kalman filter of Sabatini 2006</source>
        <translation>le filtre de Kalman à quaternions de Sabatini 2006</translation>
    </message>
    <message>
        <source>the rate of its gyroscope is about {times:.2g} times too {how} for how gravity turns in its accelerometer</source>
        <translation>la vitesse de son gyroscope est environ {times:.2g} fois trop {how} pour la rotation de la pesanteur dans son accéléromètre</translation>
    </message>
    <message>
        <source>the same, forwards and backwards</source>
        <translation>le même, vers l’avant et vers l’arrière</translation>
    </message>
    <message>
        <source>the sequence {key!r}: {reason}</source>
        <translation>la séquence {key!r}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the server does not answer</source>
        <translation>le serveur ne répond pas</translation>
    </message>
    <message>
        <source>the simulated device stands in</source>
        <translation>l’appareil simulé le remplace</translation>
    </message>
    <message>
        <source>the slow part of the specific force is gravity</source>
        <translation>la partie lente de la force spécifique est la pesanteur</translation>
    </message>
    <message>
        <source>the standard is not one of two forces</source>
        <translation>la référence n’est pas l’une de deux forces</translation>
    </message>
    <message>
        <source>the text is too long to be saved ({found_kb} KB, at most {most_kb} KB)</source>
        <translation>le texte est trop long pour être enregistré ({found_kb} Ko, au plus {most_kb} Ko)</translation>
    </message>
    <message>
        <source>the window waits up to 80 ms for work in the background</source>
        <translation>la fenêtre attend jusqu’à 80 ms le travail en arrière-plan</translation>
    </message>
    <message>
        <source>the window, and without fifo the loop, have short time slices</source>
        <translation>la fenêtre et, sans fifo, la boucle ont des tranches de temps courtes</translation>
    </message>
    <message>
        <source>the window, and without fifo the loop, wait: 437 late wake-ups a minute</source>
        <translation>la fenêtre et, sans fifo, la boucle attendent&#xa0;: 437 réveils tardifs par minute</translation>
    </message>
    <message>
        <source>there are no frames to write</source>
        <translation>il n’y a pas d’images à écrire</translation>
    </message>
    <message>
        <source>there are no participants</source>
        <translation>il n’y a aucun participant</translation>
    </message>
    <message>
        <source>there is a sound card</source>
        <translation>il y a une carte son</translation>
    </message>
    <message>
        <source>there is data after the end of the recording</source>
        <translation>il y a des données après la fin de l’enregistrement</translation>
    </message>
    <message>
        <source>there is no judgement to analyse</source>
        <translation>il n’y a pas de jugement à analyser</translation>
    </message>
    <message>
        <source>there is no motion to find events in</source>
        <translation>il n’y a pas de mouvement où chercher des événements</translation>
    </message>
    <message>
        <source>there is no number above 0 to analyse</source>
        <translation>il n’y a pas de nombre supérieur à 0 à analyser</translation>
    </message>
    <message>
        <source>there is no output {name!r}</source>
        <translation>il n’y a pas de sortie {name!r}</translation>
    </message>
    <message>
        <source>there is no page {page!r} in {step}</source>
        <translation>il n’y a pas de page {page!r} dans {step}</translation>
    </message>
    <message>
        <source>there is no valid motion in the clip to fit a gain to</source>
        <translation>le clip ne contient aucun mouvement valide auquel ajuster un gain</translation>
    </message>
    <message>
        <source>there is none yet</source>
        <translation>il n’y en a pas encore</translation>
    </message>
    <message>
        <source>these LSL streams are not on this computer: {names}</source>
        <translation>ces flux LSL ne sont pas sur cet ordinateur&#xa0;: {names}</translation>
    </message>
    <message>
        <source>this condition needs the sequence of the clip</source>
        <translation>cette condition demande la séquence du clip</translation>
    </message>
    <message>
        <source>this haptic loop does not accept injected faults</source>
        <translation>cette boucle haptique n’accepte pas de pannes injectées</translation>
    </message>
    <message>
        <source>this installation cannot look at the frames of a clip</source>
        <translation>cette installation ne peut pas analyser les images d’un clip</translation>
    </message>
    <message>
        <source>this installation has no streams of the kind {name!r}; leave them out</source>
        <translation>cette installation n’a pas de flux du type {name!r}&#xa0;; omettez-les</translation>
    </message>
    <message>
        <source>those of the gyroscope not checked: gravity hardly turns</source>
        <translation>celles du gyroscope non vérifiées&#xa0;: la pesanteur tourne à peine</translation>
    </message>
    <message>
        <source>tidy CSV with a data dictionary</source>
        <translation>tableaux CSV avec un dictionnaire des données</translation>
    </message>
    <message>
        <source>times before that of their group count from it</source>
        <translation>les temps antérieurs à celui de leur groupe se comptent à partir de lui</translation>
    </message>
    <message>
        <source>times in a declared group count from its reference</source>
        <translation>les temps d’un groupe déclaré se comptent à partir de sa référence</translation>
    </message>
    <message>
        <source>title, mapping and provenance</source>
        <translation>titre, correspondance et provenance</translation>
    </message>
    <message>
        <source>to keep it</source>
        <translation>pour le garder</translation>
    </message>
    <message>
        <source>to take it as it is</source>
        <translation>pour le prendre tel quel</translation>
    </message>
    <message>
        <source>true motion of a simulation</source>
        <translation>mouvement vrai d’une simulation</translation>
    </message>
    <message>
        <source>the frames are uncertain (confidence {confidence:.2f}): the gyro explains {explained:.0%} of the camera&apos;s rotation, at an offset of {offset_s:.3f} s ({doubt})</source>
        <translation>les images sont incertaines (confiance {confidence:.2f})&#xa0;: le gyroscope explique {explained:.0%} de la rotation de la caméra, avec un décalage de {offset_s:.3f} s ({doubt})</translation>
    </message>
    <message>
        <source>A stream of LSL, by its name or type</source>
        <translation>Un flux LSL, par son nom ou son type</translation>
    </message>
    <message>
        <source>Camera and IMU have the recorder&apos;s clock, known to about {sigma_ms:.0f} ms</source>
        <translation>Caméra et IMU ont l’horloge de l’enregistreur, connue à environ {sigma_ms:.0f} ms près</translation>
    </message>
    <message>
        <source>Haptic experience</source>
        <translation>Expérience haptique</translation>
    </message>
    <message>
        <source>In Sensor Logger: Settings, Data Streaming, HTTP Push, Push URL {url}; then record Accelerometer, Gravity and Gyroscope.</source>
        <translation>Dans Sensor Logger&#xa0;: Settings, Data Streaming, HTTP Push, Push URL {url}&#xa0;; puis enregistrer Accelerometer, Gravity et Gyroscope.</translation>
    </message>
    <message>
        <source>Install hapticplayer[websockets]: {how}</source>
        <translation>Installez hapticplayer[websockets]&#xa0;: {how}</translation>
    </message>
    <message>
        <source>Lines of CSV on standard input (`-`) or a port</source>
        <translation>Lignes CSV de l’entrée standard (`-`) ou d’un port</translation>
    </message>
    <message>
        <source>Motion sickness and vection</source>
        <translation>Mal des transports et vection</translation>
    </message>
    <message>
        <source>Pair of opposites</source>
        <translation>Paire de contraires</translation>
    </message>
    <message>
        <source>Razor-AHRS, binary</source>
        <translation>Razor-AHRS, binaire</translation>
    </message>
    <message>
        <source>Razor-AHRS, text</source>
        <translation>Razor-AHRS, texte</translation>
    </message>
    <message>
        <source>Recorded here</source>
        <translation>Enregistré ici</translation>
    </message>
    <message>
        <source>Sensor Logger on a phone, which posts to this machine</source>
        <translation>Sensor Logger sur un téléphone, qui envoie ici</translation>
    </message>
    <message>
        <source>SensorServer on an Android phone, by WebSocket</source>
        <translation>SensorServer sur Android, par WebSocket</translation>
    </message>
    <message>
        <source>SparkFun Ultimate IMU, text of its stock firmware</source>
        <translation>SparkFun Ultimate IMU, texte d’origine</translation>
    </message>
    <message>
        <source>The Haptic Experience Inventory (HXI) after each clip; its wording is to be entered from your copy.</source>
        <translation>Le Haptic Experience Inventory (HXI) après chaque clip&#xa0;; sa formulation est à saisir d’après votre exemplaire.</translation>
    </message>
    <message>
        <source>The measurement in phyphox is started from here.</source>
        <translation>La mesure dans phyphox est lancée d’ici.</translation>
    </message>
    <message>
        <source>The recorder&apos;s clock was {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) off, measured from the {witness}; this is corrected.</source>
        <translation>L’horloge de l’enregistreur était décalée de {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms), selon une mesure par {witness}&#xa0;; c’est corrigé.</translation>
    </message>
    <message>
        <source>WitMotion WT901 and others with its protocol</source>
        <translation>WitMotion WT901 et ceux de même protocole</translation>
    </message>
    <message>
        <source>a lever arm needs a whole recording; feel the sensor where it is</source>
        <translation>un bras de levier nécessite un enregistrement entier&#xa0;; ressentez le capteur là où il est</translation>
    </message>
    <message>
        <source>accel-sign=+ if it reads +1 g on the axis that is up, at rest</source>
        <translation>accel-sign=+ s’il lit +1 g au repos sur l’axe qui est en haut</translation>
    </message>
    <message>
        <source>accel-sign=- if it reads -1 g there</source>
        <translation>accel-sign=- s’il y lit -1 g</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>ajoutez-vous au groupe dialout et reconnectez-vous</translation>
    </message>
    <message>
        <source>ask it once, or leave it out</source>
        <translation>posez-la une seule fois, ou omettez-la</translation>
    </message>
    <message>
        <source>begin with the line {names}, or name the columns</source>
        <translation>commencez par la ligne {names}, ou nommez les colonnes</translation>
    </message>
    <message>
        <source>by the frames</source>
        <translation>d’après les images</translation>
    </message>
    <message>
        <source>by the recorder&apos;s clock</source>
        <translation>d’après l’horloge de l’enregistreur</translation>
    </message>
    <message>
        <source>cannot be opened ({reason})</source>
        <translation>ne peut pas être ouvert ({reason})</translation>
    </message>
    <message>
        <source>cannot be written ({reason})</source>
        <translation>ne peut pas être écrit ({reason})</translation>
    </message>
    <message>
        <source>check its cable and its name</source>
        <translation>vérifiez son câble et son nom</translation>
    </message>
    <message>
        <source>check its cable and record again</source>
        <translation>vérifiez son câble et enregistrez de nouveau</translation>
    </message>
    <message>
        <source>check the cable and the name, see /dev/serial/by-id</source>
        <translation>vérifiez le câble et le nom, voir /dev/serial/by-id</translation>
    </message>
    <message>
        <source>check the sensor&apos;s cable, power and range</source>
        <translation>vérifiez le câble, l’alimentation et la plage du capteur</translation>
    </message>
    <message>
        <source>choose another camera or microphone, or unload and load the driver (uvcvideo with clock=CLOCK_MONOTONIC)</source>
        <translation>choisissez une autre caméra ou un autre microphone, ou déchargez puis rechargez le pilote (uvcvideo avec clock=CLOCK_MONOTONIC)</translation>
    </message>
    <message>
        <source>choose another format of the camera (NAME,input_format=mjpeg)</source>
        <translation>choisissez un autre format de la caméra (NAME,input_format=mjpeg)</translation>
    </message>
    <message>
        <source>choose its acceleration with gravity (the raw accelerometer)</source>
        <translation>choisissez son accélération avec la pesanteur (l’accéléromètre brut)</translation>
    </message>
    <message>
        <source>choose its acceleration with gravity, or another unit (accel-unit)</source>
        <translation>choisissez son accélération avec la pesanteur, ou une autre unité (accel-unit)</translation>
    </message>
    <message>
        <source>choose the folder of a recording</source>
        <translation>choisissez le dossier d’un enregistrement</translation>
    </message>
    <message>
        <source>connect it again</source>
        <translation>rebranchez-le</translation>
    </message>
    <message>
        <source>copy {file} to /etc/udev/rules.d</source>
        <translation>copiez {file} dans /etc/udev/rules.d</translation>
    </message>
    <message>
        <source>copy {file} to /etc/udev/rules.d and plug it in again</source>
        <translation>copiez {file} dans /etc/udev/rules.d, puis rebranchez-le</translation>
    </message>
    <message>
        <source>delivers nothing more (it has ended)</source>
        <translation>ne fournit plus rien (flux terminé)</translation>
    </message>
    <message>
        <source>devices behind Intiface or Haply&apos;s service are not reached</source>
        <translation>les appareils d’Intiface ou du service de Haply sont inaccessibles</translation>
    </message>
    <message>
        <source>does not answer ({reason})</source>
        <translation>ne répond pas ({reason})</translation>
    </message>
    <message>
        <source>does not declare {what}</source>
        <translation>ne déclare pas {what}</translation>
    </message>
    <message>
        <source>enter the wording</source>
        <translation>saisissez la formulation</translation>
    </message>
    <message>
        <source>finish it ({line})</source>
        <translation>terminez-le ({line})</translation>
    </message>
    <message>
        <source>give a usual rate, such as baud=115200</source>
        <translation>donnez un débit courant, par exemple baud=115200</translation>
    </message>
    <message>
        <source>give its rate, such as baud=115200, and check its output</source>
        <translation>donnez son débit, par exemple baud=115200, et vérifiez ce qu’il envoie</translation>
    </message>
    <message>
        <source>give the one that the app shows, such as 192.168.1.20:8080</source>
        <translation>donnez celle que l’application affiche, par exemple 192.168.1.20:8080</translation>
    </message>
    <message>
        <source>has ended</source>
        <translation>s’est terminé</translation>
    </message>
    <message>
        <source>holds no video, only motion</source>
        <translation>ne contient pas de vidéo, seulement du mouvement</translation>
    </message>
    <message>
        <source>holds the force of a video, and no video of its name lies beside it</source>
        <translation>contient la force d’une vidéo, et aucune vidéo de ce nom ne se trouve à côté</translation>
    </message>
    <message>
        <source>install hapticplayer[cameras], which reads it ({how})</source>
        <translation>installez hapticplayer[cameras], qui le lit ({how})</translation>
    </message>
    <message>
        <source>install hapticplayer[lsl] ({how}), or {otherwise}</source>
        <translation>installez hapticplayer[lsl] ({how}), ou {otherwise}</translation>
    </message>
    <message>
        <source>install hapticplayer[lsl], or choose another source</source>
        <translation>installez hapticplayer[lsl], ou choisissez une autre source</translation>
    </message>
    <message>
        <source>install hapticplayer[vision] ({how}), or convert it to H.264</source>
        <translation>installez hapticplayer[vision] ({how}), ou convertissez-la en H.264</translation>
    </message>
    <message>
        <source>install hapticplayer[vision], which synchronises without taps, finds the mounting of a sensor and suggests motion for a plain video ({how})</source>
        <translation>installez hapticplayer[vision], qui synchronise sans tapotements, trouve la fixation d’un capteur et propose un mouvement pour une simple vidéo ({how})</translation>
    </message>
    <message>
        <source>install hapticplayer[{name}] ({how})</source>
        <translation>installez hapticplayer[{name}] ({how})</translation>
    </message>
    <message>
        <source>is being recorded</source>
        <translation>est en cours d’enregistrement</translation>
    </message>
    <message>
        <source>is not a recording</source>
        <translation>n’est pas un enregistrement</translation>
    </message>
    <message>
        <source>is not an address</source>
        <translation>n’est pas une adresse</translation>
    </message>
    <message>
        <source>is only used with a mean of at least as many</source>
        <translation>ne s’emploie qu’avec une moyenne d’au moins autant de réponses</translation>
    </message>
    <message>
        <source>is to be worded</source>
        <translation>n’est pas encore formulé</translation>
    </message>
    <message>
        <source>its experiment does not record accelerometer and gyroscope together</source>
        <translation>son expérience n’enregistre pas ensemble l’accéléromètre et le gyroscope</translation>
    </message>
    <message>
        <source>its time stamps are {apart_s:.1f} s from this machine&apos;s clock, so nothing could be synchronised with it</source>
        <translation>ses horodatages sont à {apart_s:.1f} s de l’horloge de cet ordinateur, rien ne pourrait donc être synchronisé avec lui</translation>
    </message>
    <message>
        <source>its {count} channels ({labels}) do not say which are the accelerometer&apos;s</source>
        <translation>ses {count} canaux ({labels}) ne disent pas lesquels sont ceux de l’accéléromètre</translation>
    </message>
    <message>
        <source>lay the sensor down and let it rest for {rest_s:.1f} s</source>
        <translation>posez le capteur et laissez-le au repos {rest_s:.1f} s</translation>
    </message>
    <message>
        <source>look at the network and its firewall</source>
        <translation>vérifiez le réseau et son pare-feu</translation>
    </message>
    <message>
        <source>make one in phyphox: +, Add simple experiment, Accelerometer and Gyroscope, sensor rate 0 (fastest), then Allow remote access</source>
        <translation>créez-en une dans phyphox&#xa0;: +, «&#xa0;Add simple experiment&#xa0;», Accelerometer et Gyroscope, fréquence du capteur 0 (maximale), puis «&#xa0;Allow remote access&#xa0;»</translation>
    </message>
    <message>
        <source>move the sensor: the grip follows</source>
        <translation>bougez le capteur&#xa0;: la poignée suit</translation>
    </message>
    <message>
        <source>name questions of the page, or scores before it</source>
        <translation>nommez des questions de la page, ou des scores qui le précèdent</translation>
    </message>
    <message>
        <source>name them in their order</source>
        <translation>nommez-les dans leur ordre</translation>
    </message>
    <message>
        <source>no reports of studies, no figures in files</source>
        <translation>ni rapports d’études, ni figures dans des fichiers</translation>
    </message>
    <message>
        <source>no trial is streamed to LabRecorder</source>
        <translation>aucun essai n’est diffusé vers LabRecorder</translation>
    </message>
    <message>
        <source>none of its first {count} frames can be decoded</source>
        <translation>aucune de ses {count} premières images ne peut être décodée</translation>
    </message>
    <message>
        <source>nothing comes from the sensor: check its cable, power, range</source>
        <translation>rien ne vient du capteur&#xa0;: vérifiez câble, alimentation et portée</translation>
    </message>
    <message>
        <source>nothing is recorded; give a camera, an IMU, or both</source>
        <translation>rien n’est enregistré&#xa0;; donnez une caméra, une IMU, ou les deux</translation>
    </message>
    <message>
        <source>open an experiment in phyphox, and Allow remote access in its menu</source>
        <translation>ouvrez une expérience dans phyphox, puis «&#xa0;Allow remote access&#xa0;» dans son menu</translation>
    </message>
    <message>
        <source>pairs: Wilcoxon with Holm; friedman: Friedman&apos;s test; both exact to {most} participants, then approximations</source>
        <translation>pairs&#xa0;: Wilcoxon avec Holm&#xa0;; friedman&#xa0;: test de Friedman&#xa0;; exacts tous deux jusqu’à {most} participants, approchés au-delà</translation>
    </message>
    <message>
        <source>phyphox on a phone, which is asked</source>
        <translation>phyphox sur un téléphone, interrogé d’ici</translation>
    </message>
    <message>
        <source>put the video there, or give a sequence the force (import-force)</source>
        <translation>mettez-y la vidéo, ou donnez la force à une séquence (import-force)</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>record with a camera, or import a video with this log</source>
        <translation>enregistrez avec une caméra, ou importez une vidéo avec ce journal</translation>
    </message>
    <message>
        <source>recorded here</source>
        <translation>enregistré ici</translation>
    </message>
    <message>
        <source>rotation in the frames</source>
        <translation>rotation dans les images</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <source>sends acceleration from which gravity was removed</source>
        <translation>envoie une accélération dont la pesanteur a été retirée</translation>
    </message>
    <message>
        <source>sensor silent</source>
        <translation>capteur muet</translation>
    </message>
    <message>
        <source>sound is recorded with a camera; give one</source>
        <translation>le son s’enregistre avec une caméra&#xa0;; donnez-en une</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>entrée standard</translation>
    </message>
    <message>
        <source>start the program that sends it, in the same network</source>
        <translation>lancez le programme qui l’envoie, sur le même réseau</translation>
    </message>
    <message>
        <source>stop the recording first</source>
        <translation>arrêtez d’abord l’enregistrement</translation>
    </message>
    <message>
        <source>taps</source>
        <translation>tapotements</translation>
    </message>
    <message>
        <source>the Python package websockets is missing; install hapticplayer[websockets] ({how})</source>
        <translation>le paquet Python websockets manque&#xa0;; installez hapticplayer[websockets] ({how})</translation>
    </message>
    <message>
        <source>the accelerometer reads {norm_mps2:.3g} m/s2 at rest, gravity is 9.8</source>
        <translation>l’accéléromètre indique {norm_mps2:.3g} m/s2 au repos, la pesanteur vaut 9,8</translation>
    </message>
    <message>
        <source>the camera in the frames turns as the gyroscope would at {scale:.3g} times its rate</source>
        <translation>la caméra dans les images tourne comme le ferait le gyroscope à {scale:.3g} fois sa vitesse angulaire</translation>
    </message>
    <message>
        <source>the frames place the motion {off_s:+.2f} s from where the recorder&apos;s clock does</source>
        <translation>les images placent le mouvement à {off_s:+.2f} s de là où le place l’horloge de l’enregistreur</translation>
    </message>
    <message>
        <source>the report</source>
        <translation>le rapport</translation>
    </message>
    <message>
        <source>the sensor is heard less than {slow_hz:.0f} times a second and felt in jerks: set it to 100, or choose one that sends each sample at once</source>
        <translation>le capteur envoie moins de {slow_hz:.0f} fois par seconde et se ressent par à-coups&#xa0;: réglez-le à 100, ou choisissez-en un qui envoie chaque mesure aussitôt</translation>
    </message>
    <message>
        <source>the sign of its accelerometer</source>
        <translation>le signe de son accéléromètre</translation>
    </message>
    <message>
        <source>the sound card {card!r} no longer accepts sound ({reason}); connect it and choose the device again</source>
        <translation>la carte son {card!r} n’accepte plus de son ({reason})&#xa0;; branchez-la et choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>the source</source>
        <translation>la source</translation>
    </message>
    <message>
        <source>the source sends no angular rate, without which gravity cannot be told from motion; choose one with a gyroscope</source>
        <translation>la source n’envoie pas de vitesse angulaire, sans laquelle la pesanteur ne se distingue pas du mouvement&#xa0;; choisissez-en une avec gyroscope</translation>
    </message>
    <message>
        <source>the stream does not answer ({reason})</source>
        <translation>le flux ne répond pas ({reason})</translation>
    </message>
    <message>
        <source>the stream&apos;s axes</source>
        <translation>les axes du flux</translation>
    </message>
    <message>
        <source>the taps are uncertain (confidence {confidence:.2f}); the best offset is {offset_s:.3f} s{next_best}</source>
        <translation>les tapotements ne sont pas sûrs (confiance {confidence:.2f})&#xa0;: le meilleur décalage est de {offset_s:.3f} s{next_best}</translation>
    </message>
    <message>
        <source>the times of its packets and the camera&apos;s own place the motion {apart_s:.2f} s apart: the clip was cut</source>
        <translation>les temps de ses paquets et ceux de la caméra placent le mouvement à {apart_s:.2f} s d’écart&#xa0;: le clip a été coupé</translation>
    </message>
    <message>
        <source>the unit of its accelerometer</source>
        <translation>l’unité de son accéléromètre</translation>
    </message>
    <message>
        <source>the unit of its gyroscope</source>
        <translation>l’unité de son gyroscope</translation>
    </message>
    <message>
        <source>the unit of its times is known, or it has no times</source>
        <translation>l’unité de ses temps est connue, ou il n’a pas de temps</translation>
    </message>
    <message>
        <source>the {sensor} is slower than the log: each reading is held for {each} rows, so that there are {rate_hz:.4g} a second</source>
        <translation>plus lent que le journal&#xa0;: {sensor}&#xa0;; chaque mesure est tenue pendant {each} lignes, il y en a donc {rate_hz:.4g} par seconde</translation>
    </message>
    <message>
        <source>the {sensor} repeats its readings as a stuck sensor does, {share:.1%} of the time ({spans} from the start of the log); they are not used</source>
        <translation>{sensor}&#xa0;: les mesures se répètent comme celles d’un capteur bloqué, {share:.1%} du temps ({spans} depuis le début du journal)&#xa0;; elles ne sont pas utilisées</translation>
    </message>
    <message>
        <source>there is no such stream</source>
        <translation>ce flux n’existe pas</translation>
    </message>
    <message>
        <source>there is no trial {step!r}</source>
        <translation>il n’y a pas d’essai {step!r}</translation>
    </message>
    <message>
        <source>this is not the video that the force was made for ({reason}): it plays without force</source>
        <translation>ce n’est pas la vidéo pour laquelle la force a été faite ({reason})&#xa0;: elle est lue sans force</translation>
    </message>
    <message>
        <source>three channels were taken as x, y and z</source>
        <translation>trois canaux ont été pris comme x, y et z</translation>
    </message>
    <message>
        <source>three taps on the camera, heard and felt</source>
        <translation>trois tapotements sur la caméra, entendus et ressentis</translation>
    </message>
    <message>
        <source>timeSamples was not used where it is not that of the rows</source>
        <translation>timeSamples n’a pas été utilisé là où il n’est pas celui des lignes</translation>
    </message>
    <message>
        <source>times were taken as milliseconds</source>
        <translation>les temps ont été pris en millisecondes</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>tourné</translation>
    </message>
    <message>
        <source>two outputs send {what}; keep one of them</source>
        <translation>deux sorties envoient {what}&#xa0;; gardez-en une</translation>
    </message>
    <message>
        <source>two sessions of one code ({here} here, {there} there)</source>
        <translation>deux séances de même code ({here} ici, {there} là-bas)</translation>
    </message>
    <message>
        <source>unknown entry {name!r}</source>
        <translation>a l’entrée inconnue {name!r}</translation>
    </message>
    <message>
        <source>unpack it and give the file in it</source>
        <translation>décompressez-le et donnez le fichier qu’il contient</translation>
    </message>
    <message>
        <source>unpack it and give the folder</source>
        <translation>décompressez-la et donnez le dossier</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>débranché</translation>
    </message>
    <message>
        <source>unset {switch}</source>
        <translation>supprimez la variable {switch}</translation>
    </message>
    <message>
        <source>update the app, or choose another source</source>
        <translation>mettez l’application à jour, ou choisissez une autre source</translation>
    </message>
    <message>
        <source>use &apos;repeats&apos;</source>
        <translation>utilisez &apos;repeats&apos;</translation>
    </message>
    <message>
        <source>use L, R, V or A and a digit, such as V0</source>
        <translation>utilisez L, R, V ou A et un chiffre, par exemple V0</translation>
    </message>
    <message>
        <source>use Python {oldest} or newer, as in Debian 12 and 13</source>
        <translation>utilisez Python {oldest} ou plus récent, comme dans Debian 12 et 13</translation>
    </message>
    <message>
        <source>use a name in /dev/input, such as event5</source>
        <translation>utilisez un nom de /dev/input, par exemple event5</translation>
    </message>
    <message>
        <source>use at most {most} of a-z, 0-9, _ and -, without a - in front</source>
        <translation>prenez au plus {most} caractères parmi a-z, 0-9, _ et -, sans - au début</translation>
    </message>
    <message>
        <source>utc is not a time with its zone</source>
        <translation>utc n’est pas un temps avec son fuseau</translation>
    </message>
    <message>
        <source>vibration: full intensity was taken as {full_n:.3g} N</source>
        <translation>vibration&#xa0;: l’intensité maximale a été prise comme {full_n:.3g} N</translation>
    </message>
    <message>
        <source>video</source>
        <translation>vidéo</translation>
    </message>
    <message>
        <source>video and sound</source>
        <translation>image et son</translation>
    </message>
    <message>
        <source>wait a moment</source>
        <translation>attendez un instant</translation>
    </message>
    <message>
        <source>wait until nothing writes to it, then start again</source>
        <translation>attendez que plus rien n’y écrive, puis recommencez</translation>
    </message>
    <message>
        <source>wait until that has finished, or close it, then try again</source>
        <translation>attendez qu’il ait fini, ou fermez-le, puis réessayez</translation>
    </message>
    <message>
        <source>was altered since the study was packed</source>
        <translation>a été modifié depuis l’empaquetage de l’étude</translation>
    </message>
    <message>
        <source>was changed by another program meanwhile</source>
        <translation>a été modifié entre-temps par un autre programme</translation>
    </message>
    <message>
        <source>was changed on the server</source>
        <translation>a été modifié sur le serveur</translation>
    </message>
    <message>
        <source>was changed or replaced while it was read</source>
        <translation>a été modifié ou remplacé pendant sa lecture</translation>
    </message>
    <message>
        <source>was made by another process meanwhile</source>
        <translation>a été créé entre-temps par un autre processus</translation>
    </message>
    <message>
        <source>was not finished</source>
        <translation>n’a pas été terminé</translation>
    </message>
    <message>
        <source>was shared without its motion, so its force cannot be rendered again</source>
        <translation>a été partagée sans son mouvement, donc sa force ne peut pas être recalculée</translation>
    </message>
    <message>
        <source>was unplugged or closed</source>
        <translation>a été débranché ou fermé</translation>
    </message>
    <message>
        <source>was written by another version of the program</source>
        <translation>est d’une autre version du programme</translation>
    </message>
    <message>
        <source>wavelets were read as envelopes of {carrier_hz:.0f} Hz, their height is estimated</source>
        <translation>les ondelettes ont été lues comme enveloppes à {carrier_hz:.0f} Hz, leur hauteur est estimée</translation>
    </message>
    <message>
        <source>waves of more than {most_s:.0f} s</source>
        <translation>ondes de plus de {most_s:.0f} s</translation>
    </message>
    <message>
        <source>what changes within a millisecond</source>
        <translation>ce qui change en moins d’une milliseconde</translation>
    </message>
    <message>
        <source>what lies before 0 s was left out</source>
        <translation>ce qui est avant 0 s a été omis</translation>
    </message>
    <message>
        <source>what the processes share is a file for a moment, in /dev/shm</source>
        <translation>ce que les processus partagent est un instant un fichier, dans /dev/shm</translation>
    </message>
    <message>
        <source>what the processes share is memory without a name</source>
        <translation>ce que les processus partagent est une mémoire sans nom</translation>
    </message>
    <message>
        <source>what was recorded lasts from {first_s:.2f} to {last_s:.2f} s, the clip from 0 to {duration_s:.2f} s: it was cut, or plays at another speed</source>
        <translation>ce qui a été enregistré va de {first_s:.2f} à {last_s:.2f} s, le clip de 0 à {duration_s:.2f} s&#xa0;: il a été coupé, ou est lu à une autre vitesse</translation>
    </message>
    <message>
        <source>which has no accelerometer samples (DJI stores orientations only)</source>
        <translation>qui n’a pas de mesures d’accéléromètre (DJI n’enregistre que des orientations)</translation>
    </message>
    <message>
        <source>which has no motion</source>
        <translation>qui ne contient pas de mouvement</translation>
    </message>
    <message>
        <source>which nothing here reads</source>
        <translation>que rien ici ne lit</translation>
    </message>
    <message>
        <source>while memory is short, the window freezes for up to a second</source>
        <translation>quand la mémoire manque, la fenêtre se fige jusqu’à une seconde</translation>
    </message>
    <message>
        <source>whoever is in the network and knows the URL can send to port {port} of this machine while it records.</source>
        <translation>qui est sur le réseau et connaît l’URL peut envoyer au port {port} de cette machine pendant l’enregistrement.</translation>
    </message>
    <message>
        <source>window not responding</source>
        <translation>fenêtre sans réponse</translation>
    </message>
    <message>
        <source>windows under Wayland</source>
        <translation>fenêtres sous Wayland</translation>
    </message>
    <message>
        <source>windows under X11</source>
        <translation>fenêtres sous X11</translation>
    </message>
    <message>
        <source>with hapticplayer[vision] installed, the frames are compared with the gyro exactly, and those of H.265 too</source>
        <translation>avec hapticplayer[vision] installé, les images sont comparées exactement au gyroscope, celles de H.265 aussi</translation>
    </message>
    <message>
        <source>without</source>
        <translation>sans</translation>
    </message>
    <message>
        <source>without labels</source>
        <translation>sans libellés</translation>
    </message>
    <message>
        <source>work in the background takes only what nobody else wants</source>
        <translation>le travail en arrière-plan ne prend que ce que personne d’autre ne veut</translation>
    </message>
    <message>
        <source>write numbers without units or signs, or choose another log</source>
        <translation>écrivez des nombres sans unités ni signes, ou choisissez un autre journal</translation>
    </message>
    <message>
        <source>write the rows of each sensor to a file of its own and give both</source>
        <translation>écrivez les lignes de chaque capteur dans un fichier à part et donnez les deux</translation>
    </message>
    <message>
        <source>write the time of each sample with all its digits</source>
        <translation>écrivez le temps de chaque mesure avec tous ses chiffres</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>writing the force for other programs</source>
        <translation>écriture de la force pour d’autres programmes</translation>
    </message>
    <message>
        <source>writing the logs</source>
        <translation>écriture des journaux</translation>
    </message>
    <message>
        <source>writing the numbers</source>
        <translation>écriture des nombres</translation>
    </message>
    <message>
        <source>writing {code}</source>
        <translation>écriture de {code}</translation>
    </message>
    <message>
        <source>writing {file}</source>
        <translation>écriture de {file}</translation>
    </message>
    <message>
        <source>writing {name}</source>
        <translation>écriture de {name}</translation>
    </message>
    <message>
        <source>x right, y front, z up, as printed on it</source>
        <translation>x à droite, y en avant, z en haut, comme imprimé dessus</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>your quota of the disk at {disk} is used up</source>
        <translation>votre quota sur le disque {disk} est épuisé</translation>
    </message>
    <message>
        <source>your video editor</source>
        <translation>votre logiciel de montage</translation>
    </message>
    <message>
        <source>{added} sessions added, {same} were here already</source>
        <translation>séances ajoutées&#xa0;: {added}, déjà présentes&#xa0;: {same}</translation>
    </message>
    <message>
        <source>{answer}</source>
        <translation>{answer}</translation>
    </message>
    <message>
        <source>{at_s:.1f} s: {what}</source>
        <translation>{at_s:.1f} s&#xa0;: {what}</translation>
    </message>
    <message>
        <source>{axis} appears twice; the first was read</source>
        <translation>{axis} figure deux fois&#xa0;; le premier a été lu</translation>
    </message>
    <message>
        <source>{begin_s:.2f} to {end_s:.2f} s</source>
        <translation>{begin_s:.2f} à {end_s:.2f} s</translation>
    </message>
    <message>
        <source>{bytes} bytes, {rate:.3g} kbit/s ({packed:.3g} compressed; the track: {own:.3g})</source>
        <translation>{bytes} octets, {rate:.3g} kbit/s ({packed:.3g} compressé&#xa0;; la piste&#xa0;: {own:.3g})</translation>
    </message>
    <message>
        <source>{clip}: {why}; {look}</source>
        <translation>{clip}&#xa0;: {why}&#xa0;; {look}</translation>
    </message>
    <message>
        <source>{code}: no record of a device, markers only</source>
        <translation>{code}&#xa0;: aucun enregistrement d’un appareil, marqueurs seulement</translation>
    </message>
    <message>
        <source>{code}: played another sequence &apos;{key}&apos; than the sessions here</source>
        <translation>{code}&#xa0;: a joué une autre séquence «&#xa0;{key}&#xa0;» que les séances d’ici</translation>
    </message>
    <message>
        <source>{code}: {reason}</source>
        <translation>{code}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{complete} complete, {simulated} simulated; {invalid} of {trials} trials not valid</source>
        <translation>complètes&#xa0;: {complete}, simulées&#xa0;: {simulated}&#xa0;; essais non valides&#xa0;: {invalid} sur {trials}</translation>
    </message>
    <message>
        <source>{count} channels act along x {x:.2f}, y {y:.2f}, z {z:.2f}</source>
        <translation>{count} canaux agissent selon x {x:.2f}, y {y:.2f}, z {z:.2f}</translation>
    </message>
    <message>
        <source>{count} records are missing, the first is number {number}</source>
        <translation>{count} entrées manquent, la première est la numéro {number}</translation>
    </message>
    <message>
        <source>{count} rows are damaged</source>
        <translation>{count} lignes sont endommagées</translation>
    </message>
    <message>
        <source>{count} sessions by {program}</source>
        <translation>séances avec {program}&#xa0;: {count}</translation>
    </message>
    <message>
        <source>{count} text answers were left out: they have not been reviewed</source>
        <translation>{count} réponses en texte ont été omises&#xa0;: elles n’ont pas été relues</translation>
    </message>
    <message>
        <source>{count} ticks have times or values that no device has; they are left out</source>
        <translation>{count} pas ont des temps ou des valeurs qu’aucun appareil n’a&#xa0;; ils sont omis</translation>
    </message>
    <message>
        <source>{count} trials on {device}</source>
        <translation>essais sur {device}&#xa0;: {count}</translation>
    </message>
    <message>
        <source>{device} is a real device and does not accept injected faults</source>
        <translation>{device} est un appareil réel et n’accepte pas de pannes injectées</translation>
    </message>
    <message>
        <source>{device} option {part!r}: {reason}</source>
        <translation>{device}, option {part!r}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{device}, {state}</source>
        <translation>{device}, {state}</translation>
    </message>
    <message>
        <source>{early} of {count} sessions have answers but were not completed</source>
        <translation>{early} séances sur {count} ont des réponses mais n’ont pas été terminées</translation>
    </message>
    <message>
        <source>{empty} of {count} sessions have no answers</source>
        <translation>{empty} séances sur {count} n’ont aucune réponse</translation>
    </message>
    <message>
        <source>{file}: is damaged; the definition of the study was used</source>
        <translation>{file}&#xa0;: est endommagé&#xa0;; la définition de l’étude a été utilisée</translation>
    </message>
    <message>
        <source>{file}: is not of this session</source>
        <translation>{file}&#xa0;: n’est pas de cette séance</translation>
    </message>
    <message>
        <source>{file}: {what}</source>
        <translation>{file}&#xa0;: {what}</translation>
    </message>
    <message>
        <source>{file}: {what}; choose the mounting {name}, or another of {known}, or auto for what the frames tell, or forward to keep its axes{sign}</source>
        <translation>{file}&#xa0;: {what}&#xa0;; choisissez la fixation {name}, ou une autre de {known}, ou auto pour celle que montrent les images, ou forward pour garder ses axes{sign}</translation>
    </message>
    <message>
        <source>{folder} cannot be written ({reason}); what was recorded until now is kept</source>
        <translation>impossible d’écrire dans {folder} ({reason})&#xa0;; ce qui a été enregistré jusqu’ici est conservé</translation>
    </message>
    <message>
        <source>{free_gb:.1f} GB free</source>
        <translation>{free_gb:.1f} Go libres</translation>
    </message>
    <message>
        <source>{how} ({size} MB)</source>
        <translation>{how} ({size} Mo)</translation>
    </message>
    <message>
        <source>{how}; or {others}</source>
        <translation>{how}&#xa0;; ou {others}</translation>
    </message>
    <message>
        <source>{key!r} is not a feedback</source>
        <translation>{key!r} n’est pas un retour</translation>
    </message>
    <message>
        <source>{key!r} is the name of another condition</source>
        <translation>{key!r} est le nom d’une autre condition</translation>
    </message>
    <message>
        <source>{key!r} is the name of another step</source>
        <translation>{key!r} est le nom d’une autre étape</translation>
    </message>
    <message>
        <source>{key!r} is the name of the sum of questions</source>
        <translation>{key!r} est le nom de la somme des questions</translation>
    </message>
    <message>
        <source>{key} is not the condition of {step}</source>
        <translation>{key} n’est pas la condition de {step}</translation>
    </message>
    <message>
        <source>{key}={axes} are not three axes; give the sensor&apos;s x, y, z in its columns, such as y,x,z or x,-y,z</source>
        <translation>{key}={axes} ne sont pas trois axes&#xa0;; donnez les x, y, z du capteur dans ses colonnes, par exemple y,x,z ou x,-y,z</translation>
    </message>
    <message>
        <source>{key}={axes} if the {sensor} is {how}</source>
        <translation>{key}={axes} si&#xa0;: {sensor} {how}</translation>
    </message>
    <message>
        <source>{key}={factor:.9g} {words}</source>
        <translation>{key}={factor:.9g} {words}</translation>
    </message>
    <message>
        <source>{key}={unit} is not a unit; choose {known}, or give the factor to SI as a number between {least:g} and {largest:g}</source>
        <translation>{key}={unit} n’est pas une unité&#xa0;; choisissez {known}, ou donnez le facteur vers le SI, un nombre entre {least:g} et {largest:g}</translation>
    </message>
    <message>
        <source>{kind!r}</source>
        <translation>{kind!r}</translation>
    </message>
    <message>
        <source>{kind!r} was read as a sine</source>
        <translation>{kind!r} a été lu comme un sinus</translation>
    </message>
    <message>
        <source>{kind} was read as lines</source>
        <translation>{kind} a été lu comme des droites</translation>
    </message>
    <message>
        <source>{modality}: amplitude 1 was taken as {full_n:.3g} N</source>
        <translation>{modality}&#xa0;: l’amplitude 1 a été prise comme {full_n:.3g} N</translation>
    </message>
    <message>
        <source>{more} more</source>
        <translation>{more} autres</translation>
    </message>
    <message>
        <source>{name!r} has no parameters</source>
        <translation>{name!r} n’a pas de paramètres</translation>
    </message>
    <message>
        <source>{name!r} is asked for each feedback</source>
        <translation>{name!r} est demandé pour chaque retour</translation>
    </message>
    <message>
        <source>{name!r} is not a number that is known there</source>
        <translation>{name!r} n’est pas un nombre connu à cet endroit</translation>
    </message>
    <message>
        <source>{name!r} is not a plain file name</source>
        <translation>{name!r} n’est pas un simple nom de fichier</translation>
    </message>
    <message>
        <source>{name!r} is not in &apos;of&apos;</source>
        <translation>{name!r} n’est pas dans «&#xa0;of&#xa0;»</translation>
    </message>
    <message>
        <source>{name!r} is the name of a condition; choose another name</source>
        <translation>{name!r} est le nom d’une condition&#xa0;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>{name!r} is the name of something else</source>
        <translation>{name!r} est le nom d’autre chose</translation>
    </message>
    <message>
        <source>{name!r} moves no slider</source>
        <translation>{name!r} ne déplace aucun curseur</translation>
    </message>
    <message>
        <source>{name!r} must end with .mkv (one file) or .mp4 (with a side-car)</source>
        <translation>{name!r} doit finir par .mkv (un seul fichier) ou .mp4 (avec un fichier à côté)</translation>
    </message>
    <message>
        <source>{name} beside it was read, too</source>
        <translation>{name} à côté a été lu aussi</translation>
    </message>
    <message>
        <source>{name} does not hold numbers only ({reason})</source>
        <translation>{name} ne contient pas que des nombres ({reason})</translation>
    </message>
    <message>
        <source>{name} does not know the clip&apos;s clock; use the taps, or enter the offset</source>
        <translation>{name} ne connaît pas l’horloge du clip&#xa0;; utilisez les tapotements, ou saisissez le décalage</translation>
    </message>
    <message>
        <source>{name} has the shape {shape}, expected {count} x 3</source>
        <translation>{name} a la forme {shape}, attendu&#xa0;: {count} x 3</translation>
    </message>
    <message>
        <source>{name} has the shape {shape}, expected {expected}</source>
        <translation>{name} a la forme {shape}, attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>{name} has {count} rows, but there are {expected} times</source>
        <translation>{name} a {count} lignes, mais il y a {expected} temps</translation>
    </message>
    <message>
        <source>{name} holds a value that is not finite in row {row}</source>
        <translation>{name} contient à la ligne {row} une valeur qui n’est pas finie</translation>
    </message>
    <message>
        <source>{name} is missing</source>
        <translation>{name} manque</translation>
    </message>
    <message>
        <source>{name} is not a number</source>
        <translation>{name} n’est pas un nombre</translation>
    </message>
    <message>
        <source>{name} is only read; choose one of {known}</source>
        <translation>{name} est seulement lu&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>{name} is only written; choose one of {known}</source>
        <translation>{name} est seulement écrit&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>{name} is out of range</source>
        <translation>{name} est hors des limites</translation>
    </message>
    <message>
        <source>{name} is zero, not finite or beyond any sensor in {count} of {total} rows, first in {place}</source>
        <translation>{name} est nul, non fini ou au-delà de tout capteur dans {count} lignes sur {total}, d’abord à la {place}</translation>
    </message>
    <message>
        <source>{name} must be a number</source>
        <translation>{name} doit être un nombre</translation>
    </message>
    <message>
        <source>{name} must be a number, not {text!r}</source>
        <translation>{name} doit être un nombre, pas {text!r}</translation>
    </message>
    <message>
        <source>{name} must be a positive number, got {value}</source>
        <translation>{name} doit être un nombre positif, reçu&#xa0;: {value}</translation>
    </message>
    <message>
        <source>{name} must be a text, not {value}</source>
        <translation>{name} doit être un texte, pas {value}</translation>
    </message>
    <message>
        <source>{name} must be a whole number between {least} and {largest}{unit}, not {text}</source>
        <translation>{name} doit être un nombre entier entre {least} et {largest}{unit}, et non {text}</translation>
    </message>
    <message>
        <source>{name} must be above zero, not {value}</source>
        <translation>{name} doit être supérieur à zéro, et vaut {value}</translation>
    </message>
    <message>
        <source>{name} must be between {least} and {largest}{unit}, not {text}</source>
        <translation>{name} doit être entre {least} et {largest}{unit}, et non {text}</translation>
    </message>
    <message>
        <source>{name} must be one of {known}, not {value}</source>
        <translation>{name} doit être l’un de {known}, pas {value}</translation>
    </message>
    <message>
        <source>{name} must be positive and finite, got {value}</source>
        <translation>{name} doit être positif et fini, et vaut {value}</translation>
    </message>
    <message>
        <source>{name} must be true or false</source>
        <translation>{name} doit être true ou false</translation>
    </message>
    <message>
        <source>{name} must hold real numbers</source>
        <translation>{name} doit contenir des nombres réels</translation>
    </message>
    <message>
        <source>{name} must increase strictly, but row {row} has {time_s:.6f} s after {last_s:.6f} s</source>
        <translation>{name} doit croître strictement, mais la ligne {row} a {time_s:.6f} s après {last_s:.6f} s</translation>
    </message>
    <message>
        <source>{name} reaches {farthest_s:.3g} s, beyond any clip</source>
        <translation>{name} atteint {farthest_s:.3g} s, au-delà de tout clip</translation>
    </message>
    <message>
        <source>{name} reaches {largest_mps2:.3g} m/s2, beyond what sensors measure</source>
        <translation>{name} atteint {largest_mps2:.3g} m/s2, au-delà de ce que mesurent les capteurs</translation>
    </message>
    <message>
        <source>{name} was taken as {modality}</source>
        <translation>{name} a été pris comme {modality}</translation>
    </message>
    <message>
        <source>{name} would be above {most:g}</source>
        <translation>{name} dépasserait {most:g}</translation>
    </message>
    <message>
        <source>{name}: {kind} has no such parameter; it has {known}</source>
        <translation>{name}: {kind} n’a pas ce paramètre&#xa0;; il a {known}</translation>
    </message>
    <message>
        <source>{node}, but this user may not open it</source>
        <translation>{node}, mais cet utilisateur ne peut pas l’ouvrir</translation>
    </message>
    <message>
        <source>{norm:.2f} m/s2 at rest</source>
        <translation>{norm:.2f} m/s2 au repos</translation>
    </message>
    <message>
        <source>{notes}</source>
        <translation>{notes}</translation>
    </message>
    <message>
        <source>{note} (first in line {line})</source>
        <translation>{note} (d’abord à la ligne {line})</translation>
    </message>
    <message>
        <source>{offset_s:.3f} s, {by}</source>
        <translation>{offset_s:.3f} s, {by}</translation>
    </message>
    <message>
        <source>{one}; {other}</source>
        <translation>{one}&#xa0;; {other}</translation>
    </message>
    <message>
        <source>{option} {key}={value} {fault}; give one value</source>
        <translation>{option} {key}={value} {fault}&#xa0;; donnez une seule valeur</translation>
    </message>
    <message>
        <source>{option} {word!r} is not understood; give KEY=VALUE with one of {known}</source>
        <translation>{option} {word!r} n’est pas compris&#xa0;; donnez KEY=VALUE avec l’un de {known}</translation>
    </message>
    <message>
        <source>{order!r} are not axes, so the telemetry is damaged</source>
        <translation>{order!r} ne sont pas des axes, la télémétrie est donc endommagée</translation>
    </message>
    <message>
        <source>{output}: {what}</source>
        <translation>{output}&#xa0;: {what}</translation>
    </message>
    <message>
        <source>{package} exists for Python up to {newest} only</source>
        <translation>{package} n’existe que pour Python jusqu’à {newest}</translation>
    </message>
    <message>
        <source>{path}: cannot be restored ({reason})</source>
        <translation>{path}&#xa0;: ne peut pas être récupéré ({reason})</translation>
    </message>
    <message>
        <source>{path}: is not a log of {name}</source>
        <translation>{path}&#xa0;: n’est pas un journal de {name}</translation>
    </message>
    <message>
        <source>{path}: the frame cannot be written; choose another folder in the preferences</source>
        <translation>{path}&#xa0;: l’image ne peut pas être écrite&#xa0;; choisissez un autre dossier dans les préférences</translation>
    </message>
    <message>
        <source>{path}: {reason}</source>
        <translation>{path}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{percent:.2g} % of the time the force is at its limit</source>
        <translation>la force est à sa limite {percent:.2g}&#xa0;% du temps</translation>
    </message>
    <message>
        <source>{percent} %</source>
        <translation>{percent}&#xa0;%</translation>
    </message>
    <message>
        <source>{place} was left out, as its time is more than an hour apart</source>
        <translation>la {place} a été omise, car son temps est à plus d’une heure des autres</translation>
    </message>
    <message>
        <source>{purpose} needs {packages}, which this installation lacks</source>
        <translation>{purpose} nécessite {packages}, qui manque à cette installation</translation>
    </message>
    <message>
        <source>{rate_hz:g} Hz is above the rate of the samples, {input_rate_hz:.4g} Hz</source>
        <translation>{rate_hz:g} Hz dépasse la cadence des mesures, {input_rate_hz:.4g} Hz</translation>
    </message>
    <message>
        <source>{rate} samples per second are set in the sensor and kept.</source>
        <translation>{rate} mesures par seconde sont réglées dans le capteur et conservées.</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>{reason}; the copy in the journal was used</source>
        <translation>{reason}&#xa0;; la copie du journal a été utilisée</translation>
    </message>
    <message>
        <source>{scripted} of {count} sessions are simulated</source>
        <translation>{scripted} séances sur {count} sont simulées&#xa0;: personne n’y était</translation>
    </message>
    <message>
        <source>{server} answers</source>
        <translation>{server} répond</translation>
    </message>
    <message>
        <source>{server} is silent</source>
        <translation>{server} ne répond pas</translation>
    </message>
    <message>
        <source>{source} cannot send {rate} samples per second at {baud} baud; set it to 115200 baud with its maker&apos;s program, and give baud=115200</source>
        <translation>{source} ne peut pas envoyer {rate} mesures par seconde à {baud} bauds&#xa0;; réglez-le à 115200 bauds avec le programme du fabricant, et donnez baud=115200</translation>
    </message>
    <message>
        <source>{source} does not understand {part!r}; give each of {known} once, such as {name}=VALUE</source>
        <translation>{source} ne comprend pas {part!r}&#xa0;; donnez chacun de {known} une seule fois, par exemple {name}=VALUE</translation>
    </message>
    <message>
        <source>{source} needs a place; give one, such as {option} {source}:{example}</source>
        <translation>{source} a besoin d’une connexion&#xa0;; donnez-en une, par exemple {option} {source}:{example}</translation>
    </message>
    <message>
        <source>{source}: sound, but none of the known images ({known}; SHA-256 {sha256}...); it would run the motors: say that you want it</source>
        <translation>{source}&#xa0;: en bon état, mais aucun des micrologiciels connus ({known}&#xa0;; SHA-256 {sha256}...)&#xa0;; il ferait tourner les moteurs&#xa0;: dites que vous le voulez</translation>
    </message>
    <message>
        <source>{source}: {question} Allow it with {option} {source}:{text},allow=yes</source>
        <translation>{source}&#xa0;: {question} Autorisez-le avec {option} {source}:{text},allow=yes</translation>
    </message>
    <message>
        <source>{stream}: ends here, the disk at {disk} is full; what was recorded is kept</source>
        <translation>{stream}&#xa0;: s’arrête ici, le disque sur {disk} est plein&#xa0;; ce qui a été enregistré est conservé</translation>
    </message>
    <message>
        <source>{stream}: is back</source>
        <translation>{stream}&#xa0;: de retour</translation>
    </message>
    <message>
        <source>{stream}: nothing for {stall_s:.1f} s (check the cable, or wake the phone up); the other streams continue</source>
        <translation>{stream}&#xa0;: rien depuis {stall_s:.1f} s (vérifiez le câble, ou réveillez le téléphone)&#xa0;; le reste continue</translation>
    </message>
    <message>
        <source>{stream}: {what}</source>
        <translation>{stream}&#xa0;: {what}</translation>
    </message>
    <message>
        <source>{switch} names {unknown}, which is not a facility; choose from {known}</source>
        <translation>{switch} nomme {unknown}, qui n’est pas une fonction du système&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>{text!r} are not three axes; give the device&apos;s right, up and towards the user in the wearer&apos;s axes (x right, y front, z up), such as x,z,-y, or the nine numbers of a rotation, row by row</source>
        <translation>{text!r} ne sont pas trois axes&#xa0;; donnez la droite, le haut et la direction de l’utilisateur dans les axes du porteur de l’enregistreur (x droite, y avant, z haut), par exemple x,z,-y, ou les neuf nombres d’une rotation, ligne par ligne</translation>
    </message>
    <message>
        <source>{text!r} is not HOST:PORT</source>
        <translation>{text!r} n’est pas HOST:PORT</translation>
    </message>
    <message>
        <source>{text!r} is not a parameter; write NAME=VALUE</source>
        <translation>{text!r} n’est pas un paramètre&#xa0;; écrivez NOM=VALEUR</translation>
    </message>
    <message>
        <source>{text!r} is not a serial number, which has letters and digits only, nor gain=; see &apos;hapticplayer device list&apos;</source>
        <translation>{text!r} n’est ni un numéro de série, qui n’a que des lettres et des chiffres, ni gain=&#xa0;; voir «&#xa0;hapticplayer device list&#xa0;»</translation>
    </message>
    <message>
        <source>{text!r} is not an address of this machine; give one in full, such as {loopback} or 192.168.1.5</source>
        <translation>{text!r} n’est pas une adresse de cet ordinateur&#xa0;; donnez-en une en entier, par exemple {loopback} ou 192.168.1.5</translation>
    </message>
    <message>
        <source>{text}.</source>
        <translation>{text}.</translation>
    </message>
    <message>
        <source>{text}; taps and frames could not correct it: {why}.</source>
        <translation>{text}&#xa0;; tapotements et images n’ont pas pu la corriger&#xa0;: {why}.</translation>
    </message>
    <message>
        <source>{time_s:.3g} s is later than any clip</source>
        <translation>{time_s:.3g} s est plus tard que tout clip</translation>
    </message>
    <message>
        <source>{time} jumps back by {jump_s:.6g} s at {place}</source>
        <translation>{time} recule de {jump_s:.6g} s à {place}</translation>
    </message>
    <message>
        <source>{time} runs at {rate_hz:.3g} samples a second</source>
        <translation>{time} avance à {rate_hz:.3g} mesures par seconde</translation>
    </message>
    <message>
        <source>{time} runs at {rate_hz:.3g} samples a second, faster than any sensor</source>
        <translation>{time} avance à {rate_hz:.3g} mesures par seconde, plus vite que tout capteur</translation>
    </message>
    <message>
        <source>{time} runs backwards at {place}, and no order can be found</source>
        <translation>{time} recule à {place}, et aucun ordre ne peut être trouvé</translation>
    </message>
    <message>
        <source>{title} at {where}</source>
        <translation>{title} à {where}</translation>
    </message>
    <message>
        <source>{title} has no realistic feedback to make {name!r} of; import it first</source>
        <translation>{title} n’a pas de retour réaliste dont faire {name!r}&#xa0;; importez d’abord la vidéo</translation>
    </message>
    <message>
        <source>{title} refuses the effect ({reason}); close other programs that use it, and choose the device again</source>
        <translation>{title} refuse l’effet ({reason})&#xa0;; fermez les autres programmes qui l’utilisent, et choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>{title} was unplugged; plug it in and choose the device again</source>
        <translation>{title} a été débranché&#xa0;; branchez-le et choisissez l’appareil à nouveau</translation>
    </message>
    <message>
        <source>{title}: permission denied for {path}; add yourself to the group input and log in again</source>
        <translation>{title}&#xa0;: accès refusé à {path}&#xa0;; ajoutez-vous au groupe input et reconnectez-vous</translation>
    </message>
    <message>
        <source>{toy} has left Intiface; connect it there and choose the device again</source>
        <translation>{toy} a quitté Intiface&#xa0;; connectez-le là et choisissez de nouveau l’appareil</translation>
    </message>
    <message>
        <source>{unit} {axes}</source>
        <translation>{unit} {axes}</translation>
    </message>
    <message>
        <source>{unseen_s:.0f} s without estimate: cuts, dark, blurred or empty frames</source>
        <translation>{unseen_s:.0f} s sans estimation&#xa0;: coupes, images sombres, floues ou vides</translation>
    </message>
    <message>
        <source>{used!r} is used by another rating</source>
        <translation>{used!r} est utilisé par une autre évaluation</translation>
    </message>
    <message>
        <source>{value!r} is not a sequence of this study</source>
        <translation>{value!r} n’est pas une séquence de cette étude</translation>
    </message>
    <message>
        <source>{value!r} is not allowed</source>
        <translation>est {value!r}</translation>
    </message>
    <message>
        <source>{value} is not allowed</source>
        <translation>{value} n’est pas permis</translation>
    </message>
    <message>
        <source>{what} ({proof})</source>
        <translation>{what} ({proof})</translation>
    </message>
    <message>
        <source>{what}, but the numbers would fit another unit</source>
        <translation>{what}, mais les nombres correspondraient à une autre unité</translation>
    </message>
    <message>
        <source>{what}, with the axes that were given</source>
        <translation>{what}, avec les axes donnés</translation>
    </message>
    <message>
        <source>{what}, with the delay that was given</source>
        <translation>{what}, avec le retard donné</translation>
    </message>
    <message>
        <source>{what}, {why}</source>
        <translation>{what}, {why}</translation>
    </message>
    <message>
        <source>{what}; choose the mounting</source>
        <translation>{what}&#xa0;; choisissez la fixation</translation>
    </message>
    <message>
        <source>{where} does not answer {name}; restart it</source>
        <translation>{where} ne répond pas à {name}&#xa0;; redémarrez-le</translation>
    </message>
    <message>
        <source>{where} does not answer; see whether the toy is connected and charged, and restart Intiface</source>
        <translation>{where} ne répond pas&#xa0;; vérifiez que l’appareil est connecté et chargé, et redémarrez Intiface</translation>
    </message>
    <message>
        <source>{where} refuses: {reason}; update it</source>
        <translation>{where} refuse&#xa0;: {reason}&#xa0;; mettez-le à jour</translation>
    </message>
    <message>
        <source>{where} sends messages that make no sense; restart it</source>
        <translation>{where} envoie des messages qui n’ont pas de sens&#xa0;; redémarrez-le</translation>
    </message>
    <message>
        <source>{width_px} x {height_px}, {refresh_hz:.0f} Hz, screens: {screens}</source>
        <translation>{width_px} × {height_px}, {refresh_hz:.0f} Hz&#xa0;; écrans&#xa0;: {screens}</translation>
    </message>
    <message>
        <source>{width} x {height} pixels are too large for a frame</source>
        <translation>{width} x {height} pixels sont trop pour une image</translation>
    </message>
    <message>
        <source>the log is incomplete ({reason})</source>
        <translation>le journal est incomplet ({reason})</translation>
    </message>
    <message>
        <source>the sound output was lost; video and force continue</source>
        <translation>la sortie audio a été perdue&#xa0;; la vidéo et la force continuent</translation>
    </message>
    <message>
        <source>{count} places are damaged: {first}</source>
        <translation>{count} endroits sont endommagés&#xa0;: {first}</translation>
    </message>
    <message>
        <source>{count} positions of {axis} beyond 0 to 100 were limited</source>
        <translation>{count} positions de {axis} hors de 0 à 100 ont été limitées</translation>
    </message>
    <message>
        <source>{example} (a name for each column, - to ignore one, / between tables)</source>
        <translation>{example} (un nom par colonne, - pour en ignorer une, / entre les tableaux)</translation>
    </message>
    <message>
        <source>{file} is not used: order.method is {method}</source>
        <translation>{file} n’est pas utilisé&#xa0;: order.method est {method}</translation>
    </message>
    <message>
        <source>{file}: holds another plan</source>
        <translation>{file}&#xa0;: contient un autre plan</translation>
    </message>
    <message>
        <source>{file}: its times are clock times, not {unit}; leave out time-unit={unit}</source>
        <translation>{file}&#xa0;: ses temps sont des heures, pas {unit}&#xa0;; omettez time-unit={unit}</translation>
    </message>
    <message>
        <source>{file}: {option} has no effect: {form} does not use it, or this file says it itself; leave it out</source>
        <translation>{file}&#xa0;: {option} est sans effet&#xa0;: {form} ne l’utilise pas, ou ce fichier le dit lui-même&#xa0;; omettez-le</translation>
    </message>
    <message>
        <source>{file}: {option} {key}={value} has no effect on a log of {form}: {why}; leave it out</source>
        <translation>{file}&#xa0;: {option} {key}={value} est sans effet sur un journal de {form}&#xa0;: {why}&#xa0;; omettez-le</translation>
    </message>
    <message>
        <source>{log} is a motion log; choose the video that it belongs to</source>
        <translation>{log} est un journal de mouvement&#xa0;; choisissez la vidéo à laquelle il appartient</translation>
    </message>
    <message>
        <source>{log}: the taps fit, but the gyro explains only {explained:.0%} of the camera&apos;s rotation in the frames, in any axes: is it the log of this clip, and the video not stabilised? To take the taps alone, say so, or give their offset</source>
        <translation>{log}&#xa0;: les tapotements correspondent, mais le gyroscope n’explique que {explained:.0%} de la rotation de la caméra dans les images, quels que soient les axes&#xa0;: est-ce le journal de ce clip, et la vidéo n’est-elle pas stabilisée&#xa0;? Pour ne prendre que les tapotements, indiquez-le, ou donnez leur décalage</translation>
    </message>
    <message>
        <source>{reason}, or set {variable} to another path</source>
        <translation>{reason}, ou donnez à {variable} un autre chemin</translation>
    </message>
    <message>
        <source>{share} of the motion is not valid (gaps, missing or clipped samples) and has no force</source>
        <translation>{share} du mouvement n’est pas fiable (lacunes, mesures manquantes ou écrêtées)&#xa0;; il n’y a pas de force à cet endroit</translation>
    </message>
    <message>
        <source>{share} of the samples are at the sensor&apos;s limit</source>
        <translation>{share} des mesures sont à la limite du capteur</translation>
    </message>
    <message>
        <source>{text!r} is not a number</source>
        <translation>{text!r} n’est pas un nombre</translation>
    </message>
    <message>
        <source>{text!r} is not a participant&apos;s code</source>
        <translation>{text!r} n’est pas un code de participant</translation>
    </message>
    <message>
        <source>{text} is not a finite number</source>
        <translation>{text} n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>{time} (or rate-hz=100)</source>
        <translation>{time} (ou rate-hz=100)</translation>
    </message>
    <message>
        <source>{title} has no feedback {name!r}; choose one of {known}</source>
        <translation>{title} n’a pas de retour {name!r}&#xa0;; choisissez parmi {known}</translation>
    </message>
    <message>
        <source>{total_s:.4g} s of samples are less than one window of {window_s:.4g} s</source>
        <translation>{total_s:.4g} s de mesures font moins qu’une fenêtre de {window_s:.4g} s</translation>
    </message>
    <message>
        <source>{what} ({reason})</source>
        <translation>{what} ({reason})</translation>
    </message>
    <message>
        <source>{what} and are marked as not valid</source>
        <translation>{what} et sont marquées comme non valables</translation>
    </message>
    <message>
        <source>{what}; {remedy}</source>
        <translation>{what}&#xa0;; {remedy}</translation>
    </message>
    <message>
        <source>{where}: waiting for the server</source>
        <translation>{where}&#xa0;: attente du serveur</translation>
    </message>
    <message>
        <source>{where}: {reason}</source>
        <translation>{where}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{where}: {what}</source>
        <translation>{where}&#xa0;: {what}</translation>
    </message>
    <message>
        <source>CSV in SI units</source>
        <translation>CSV en unités SI</translation>
    </message>
    <message>
        <source>another camera</source>
        <translation>une autre caméra</translation>
    </message>
    <message>
        <source>decreases</source>
        <translation>diminue</translation>
    </message>
    <message>
        <source>the first sudden rise of sound and motion, as in the paper</source>
        <translation>la première hausse soudaine du son et du mouvement, comme dans l’article</translation>
    </message>
    <message>
        <source>the recording&apos;s own clock</source>
        <translation>l’horloge propre de l’enregistrement</translation>
    </message>
    <message>
        <source>the offset that is given</source>
        <translation>le décalage donné</translation>
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
