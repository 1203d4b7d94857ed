/** The help, and the line on every setting. */
import type { Texts } from '../translate';

export const HELP: Texts = {
  Privacy: 'Vie privée',
  'Meshes are read and solved in this browser. Nothing is uploaded, counted or tracked; the page asks its own host alone, and that of an address that you open.':
    'Les maillages sont lus et résolus dans ce navigateur. Rien n’est envoyé, compté ni suivi ; la page ne demande rien qu’à son propre hôte, et à celui d’une adresse que vous ouvrez.',
  'Files that you open are kept in this browser only, to be opened again; so are your choices. The menu “Open” erases the files, and the browser all of it, with the data of this site.':
    'Les fichiers que vous ouvrez sont gardés dans ce navigateur seulement, pour être rouverts ; vos choix aussi. Le menu « Ouvrir » efface les fichiers, et le navigateur efface le tout avec les données de ce site.',
  'Report a fault': 'Signaler un défaut',
  'Nothing is sent by itself. Save the scene, which holds your mesh, copy the report, which names it, look at both, and hand them over.':
    'Rien n’est envoyé tout seul. Enregistrez la scène, qui contient votre maillage, copiez le rapport, qui le nomme, regardez les deux, et transmettez-les.',
  Report: 'Rapport',
  'Copy report': 'Copier le rapport',
  'A new report': 'Un nouveau rapport',
  'The source, and its license': 'Les sources, et leur licence',
  'Whoever runs this page has not said where its source is, and who takes reports.':
    'L’hébergeur de cette page n’a pas dit où en sont les sources, ni qui reçoit les rapports.',
  Language: 'Langue',
  'Close the help': 'Fermer l’aide',
  'All documents, with a search': 'Tous les documents, avec une recherche (en anglais)',
  Action: 'Action',
  Touch: 'Doigt',
  Mouse: 'Souris',
  Keyboard: 'Clavier',
  'Explain every setting of the panel': 'Expliquer chaque réglage du panneau',
  'Single-key shortcuts: letters, digits and signs': 'Raccourcis d’une seule touche : lettres, chiffres et signes',
  'Arrows, Enter and Space act while the model has the focus, all other keys everywhere but in fields.':
    'Les flèches, Entrée et Espace agissent quand le modèle a le focus ; les autres touches partout, sauf dans les champs.',
  'More about {0}': 'En savoir plus sur « {0} »',
  more: 'plus',
  Orbit: 'Tourner autour',
  drag: 'glisser',
  'one finger': 'un doigt',
  Pan: 'Déplacer la vue',
  'right-drag, or shift-drag beside the model': 'glisser à droite, ou maj-glisser à côté du modèle',
  'two fingers': 'deux doigts',
  'Ctrl+arrows': 'Ctrl+flèches',
  Zoom: 'Zoom',
  wheel: 'molette',
  pinch: 'pincer',
  'Frame the model': 'Cadrer le modèle',
  'double-click focuses a point': 'un double-clic vise un point',
  button: 'bouton',
  'Set the source': 'Placer la source',
  click: 'clic',
  tap: 'appui',
  Enter: 'Entrée',
  'Add a source': 'Ajouter une source',
  'ctrl + click': 'ctrl + clic',
  'tap with the Add tool': 'appui avec l’outil Ajouter',
  'Shift+Enter': 'Maj+Entrée',
  'Line of sources': 'Ligne de sources',
  'shift + click': 'maj + clic',
  'Draw, in the Sources section': 'Tracé, dans la section Sources',
  'Stroke, boundary, part as sources': 'Trait, bord, pièce comme sources',
  'List of sources': 'Liste de sources',
  'drop a CSV file': 'déposer un fichier CSV',
  'field in the Sources section': 'champ de la section Sources',
  'Ctrl+V': 'Ctrl+V',
  'Move a source': 'Déplacer une source',
  'drag its pin': 'glisser son épingle',
  arrows: 'flèches',
  'Move a corner of the selected line': 'Déplacer un coin de la ligne choisie',
  'Tab arrows': 'Tab flèches',
  'Remove the selected source': 'Enlever la source choisie',
  '× in the list': '× dans la liste',
  Delete: 'Suppr',
  'Place the walker': 'Placer le marcheur',
  'alt + click': 'alt + clic',
  'long press': 'appui long',
  'Read the distance': 'Lire la distance',
  hover: 'survol',
  'Tools: source, add, walker, measure': 'Outils : source, ajouter, marcheur, mesurer',
  buttons: 'boutons',
  'Measure from the walker to the source': 'Mesurer du marcheur à la source',
  'Measure, with that tool': 'Mesurer, avec cet outil',
  'End a tape': 'Terminer un ruban',
  'its last place': 'son dernier point',
  'Close a tape': 'Fermer un ruban',
  'double-click, or its first place': 'double-clic, ou son premier point',
  'its first place': 'son premier point',
  'Enter there': 'Entrée',
  'Move a place of a tape': 'Déplacer un point d’un ruban',
  'Pause or resume': 'Pause ou reprise',
  'Play or stop the animation': 'Lire ou arrêter l’animation',
  'Brush on or off; its size': 'Pinceau oui ou non ; sa taille',
  switch: 'interrupteur',
  'Fill the surface, cut it open; move the cut': 'Remplir la surface, l’ouvrir ; déplacer la coupe',
  'drag its handle': 'glisser sa poignée',
  'Turn the next axis up': 'Mettre l’axe suivant en haut',
  'Display section': 'section Affichage',
  'From the front, the side, above': 'De face, de côté, d’en haut',
  'Legend on or off': 'Montrer ou cacher la légende',
  'Move the legend': 'Déplacer la légende',
  'What the colors mean, a length to compare with, and where the axes of the file point.':
    'Ce que disent les couleurs, une longueur pour comparer, et où pointent les axes du fichier.',
  'Open a file': 'Ouvrir un fichier',
  'drop it, or paste it': 'le déposer, ou le coller',
  'Undo, redo': 'Annuler, rétablir',
  'Cancel, close, back out': 'Annuler, fermer, revenir',
  Esc: 'Échap',
  'This help': 'Cette aide',
  'What the lengths in the file are: millimeters, meters, inches, … The numbers stay, and the size of the model changes.':
    'Ce que sont les longueurs du fichier : millimètres, mètres, pouces, … Les nombres restent, et la taille du modèle change.',
  'The unit of all lengths on the page and in saved files: millimeters, meters, inches, … The size of the model stays.':
    'L’unité de toutes les longueurs sur la page et dans les fichiers enregistrés : millimètres, mètres, pouces, … La taille du modèle reste.',
  'Which of the animations of the file is shown.': 'L’animation du fichier qui est montrée.',
  'The moment at which the model stands, or begins to play.': 'Le moment où le modèle est arrêté, ou commence.',
  'Times as fast as the file says.': 'Combien de fois plus vite que le fichier.',
  'Begins again at the end.': 'Recommence à la fin.',
  'Measured in the pose of the file, or anew in each pose that is shown.':
    'Mesurée dans la pose du fichier, ou de nouveau dans chaque pose montrée.',
  'The unit of lengths from then on.': 'L’unité des longueurs à partir de là.',
  'What a click or a drag on the surface adds: a line, a stroke, a whole boundary or part.':
    'Ce qu’ajoute un clic ou un glissement sur la surface : une ligne, un trait, un bord ou une pièce entière.',
  'Curves where another source becomes the nearest one.': 'Courbes où une autre source devient la plus proche.',
  'Colors by the source that is nearest, by exact distances, with borders between them, areas, and files of the borders.':
    'Couleurs selon la source la plus proche, par distances exactes, avec les frontières entre elles, les aires, et des fichiers des frontières.',
  'A drag on the surface paints instead of orbiting.': 'Glisser sur la surface peint au lieu de tourner autour.',
  'What a stroke or a click does to the ground.': 'Ce qu’un trait ou un clic fait au terrain.',
  'What a unit of length costs where it is painted; 1 is bare ground.':
    'Ce que coûte une unité de longueur là où c’est peint ; 1 est le terrain nu.',
  'Radius of the brush.': 'Rayon du pinceau.',
  'Share of the brush in which the cost fades out.': 'Part du pinceau où le coût s’estompe.',
  'Steep ground costs what a hiker takes there, as the mean of uphill and downhill, by Tobler’s hiking function.':
    'Un terrain pentu coûte ce qu’y met un marcheur, moyenne de la montée et de la descente, par la fonction de marche de Tobler.',
  'What the highest place costs, as a multiple of the lowest.':
    'Ce que coûte l’endroit le plus haut, en multiple du plus bas.',
  'About how many fill what the surface encloses; more are slower and closer to the surface.':
    'Combien environ remplissent l’intérieur de la surface ; plus il y en a, plus c’est lent et proche de la surface.',
  'Shows the inside: half of the mesh is left out, or a wedge of it.':
    'Montre l’intérieur : la moitié du maillage est omise, ou un quartier.',
  'Where the cut is, from one end of the mesh to the other.': 'Où est la coupe, d’un bout à l’autre du maillage.',
  'Shows the curves in which a plane cuts the surface, with their lengths.':
    'Montre les courbes selon lesquelles un plan coupe la surface, avec leurs longueurs.',
  'Where the plane is, from one end of the mesh to the other.': 'Où est le plan, d’un bout du maillage à l’autre.',
  'Direction of the plane around the axis that points up.': 'Direction du plan autour de l’axe vertical.',
  'How far the direction of the plane is over the horizon; 90° is level.':
    'De combien la direction du plan s’élève au-dessus de l’horizon ; à 90° il est horizontal.',
  'The curves in millimeters (DXF), in meters (GLB) or in the unit that is shown.':
    'Les courbes en millimètres (DXF), en mètres (GLB) ou dans l’unité affichée.',
  'Direction of the cut around the axis that points up.': 'Direction de la coupe autour de l’axe vertical.',
  'How far the cut leans over the horizon.': 'Inclinaison de la coupe par rapport à l’horizon.',
  'Angle of the wedge.': 'Angle du quartier.',
  'Tetrahedra stay whole at the cut instead of being sliced.':
    'Les tétraèdres restent entiers à la coupe au lieu d’être tranchés.',
  'Moves tetrahedra away from each other, so that all of them are seen.':
    'Éloigne les tétraèdres les uns des autres, pour les voir tous.',
  'From one surface of equal distance to the next.': 'D’une surface d’égale distance à la suivante.',
  'Directions in which the distance grows, on the cut.': 'Directions où la distance croît, sur la coupe.',
  'How distance is found: at once by windows, smooth by heat, or exact.':
    'Comment la distance est trouvée : aussitôt par fenêtres, lisse par la chaleur, ou exacte.',
  'Makes the distance exact, from the sources outward, while nothing moves.':
    'Rend la distance exacte, à partir des sources, tant que rien ne bouge.',
  'How the walker goes: down the gradient, pulled straight, or on an exact shortest path.':
    'Comment va le marcheur : en descendant le gradient, en chemin redressé, ou sur un plus court chemin exact.',
  'Lets distance and paths cross where parts of a model touch.':
    'Laisse distance et chemins passer là où les pièces d’un modèle se touchent.',
  'Heat flows for t = m h², h the mean edge length. Longer is smoother and less accurate.':
    'La chaleur diffuse pendant t = m h², h étant la longueur moyenne des arêtes. Plus long : plus lisse et moins précis.',
  'What heat does at the rim of an open surface: it is kept in, or lost.':
    'Ce que fait la chaleur au bord d’une surface ouverte : elle est retenue, ou perdue.',
  'Radius around the sources in which distances are exact from the start.':
    'Rayon autour des sources où les distances sont exactes dès le début.',
  'The nearest source decides, or heat of all sources is added up as other programs do.':
    'La source la plus proche décide, ou la chaleur de toutes est sommée comme le font d’autres programmes.',
  'Triangles of the Laplacian: flipped to be Delaunay, as in the file, or with moved vertices.':
    'Triangles du laplacien : basculés pour être de Delaunay, comme dans le fichier, ou à sommets déplacés.',
  'Factors once, then milliseconds a source; or no factors, and each source takes longer.':
    'Une factorisation, puis des millisecondes par source ; ou aucune, et chaque source prend plus longtemps.',
  'Windows kept of each half-edge: more are closer to exact and slower.':
    'Fenêtres gardées par demi-arête : plus il y en a, plus c’est proche de l’exact et lent.',
  'How distance is found right of the divider.': 'Comment la distance est trouvée à droite de la séparation.',
  'Windows that each half-edge keeps there.': 'Fenêtres qu’y garde chaque demi-arête.',
  'Whether the field there is made exact at rest.': 'Si le champ y est rendu exact au repos.',
  'How long heat flows there: t = m h².': 'Combien de temps la chaleur y diffuse : t = m h².',
  'What boundaries of the surface do to heat there.': 'Ce que les bords de la surface y font à la chaleur.',
  'What triangles the Laplacian there is of.': 'Sur quels triangles le laplacien y est construit.',
  'How linear systems are solved there.': 'Comment les systèmes linéaires y sont résolus.',
  'Bands, thin lines, or only the colors of the surface.':
    'Des bandes, des lignes fines, ou seulement les couleurs de la surface.',
  'From one stripe to the next.': 'D’une bande à la suivante.',
  'Share of the period that a stripe covers.': 'Part de la période que couvre une bande.',
  'Moves the stripes away from the sources.': 'Éloigne les bandes des sources.',
  'Hard or soft edges of stripes.': 'Bords nets ou doux des bandes.',
  'Stripes stand out of the surface, or are grooves in it.': 'Les bandes ressortent de la surface, ou y sont creusées.',
  'Stripes run away from the sources, or towards them.': 'Les bandes s’éloignent des sources, ou s’en approchent.',
  'Colors and materials of the style, or those of the file.': 'Couleurs et matériaux du style, ou ceux du fichier.',
  'How stripes cover the materials of a file.': 'Comment les bandes couvrent les matériaux d’un fichier.',
  'Color ramp of the stripes over the distance.': 'Dégradé des bandes selon la distance.',
  'One color for all stripes.': 'Une seule couleur pour toutes les bandes.',
  'Whether stripes change the color.': 'Si les bandes changent la couleur.',
  'Whether stripes change the normals, and so stand out in the light.':
    'Si les bandes changent les normales, et ressortent ainsi à la lumière.',
  'Whether stripes glow.': 'Si les bandes luisent.',
  'Whether stripes have a material of their own.': 'Si les bandes ont leur propre matériau.',
  'Plastic or metal between the stripes.': 'Plastique ou métal entre les bandes.',
  'Mirror or chalk between the stripes.': 'Miroir ou craie entre les bandes.',
  'Light that comes out of the surface.': 'Lumière qui sort de la surface.',
  'Plastic or metal on the stripes.': 'Plastique ou métal sur les bandes.',
  'Mirror or chalk on the stripes.': 'Miroir ou craie sur les bandes.',
  'Light that comes out of the stripes.': 'Lumière qui sort des bandes.',
  'What surrounds the model.': 'Ce qui entoure le modèle.',
  'Turns the surroundings around the model.': 'Tourne l’entourage autour du modèle.',
  'The field in the stripes: distance, heat, or the error of the answer that came first.':
    'Le champ des bandes : distance, chaleur, ou erreur de la première réponse.',
  'Parts of the file that nobody walks on.': 'Pièces du fichier où personne ne marche.',
  'The triangles that join the points of a file without faces.':
    'Les triangles qui relient les points d’un fichier sans faces.',
  'The triangles and polygons of the file.': 'Les triangles et polygones du fichier.',
  'Edges with a triangle on one side only.': 'Arêtes avec un triangle d’un seul côté.',
  'Where distance crosses from one component to another.': 'Où la distance passe d’une composante à une autre.',
  'The triangles that the Laplacian is built on.': 'Les triangles sur lesquels le laplacien est construit.',
  'Curves on which the distance is the same, at the edges of the stripes.':
    'Courbes où la distance est la même, aux bords des bandes.',
  'Arrows along the unit gradient of heat, towards the sources.':
    'Flèches le long du gradient unitaire de la chaleur, vers les sources.',
  'Arrows along the gradient of the distance.': 'Flèches le long du gradient de la distance.',
  'Walkers that all take the shortest way to a source.':
    'Des marcheurs qui prennent tous le plus court chemin vers une source.',
  'The axis of the file that is drawn upward.': 'L’axe du fichier dessiné vers le haut.',
  'Looks through a camera that the file has.': 'Regarde à travers une caméra du fichier.',
  'Lights of the file in the place of those of the style.': 'Les lumières du fichier à la place de celles du style.',
  'A spacing, or values with commas between them; the period of the stripes where it is empty.':
    'Un pas, ou des valeurs séparées par des points-virgules ; la période des bandes si c’est vide.',
  'Curves, or the surface cut along them into strips, also unrolled.':
    'Des courbes, ou la surface découpée le long de celles-ci en bandes, dépliées aussi.',
  'A number a vertex, as a table or with the mesh.': 'Un nombre par sommet, en tableau ou avec le maillage.',
  'The places that the walker comes through.': 'Les endroits par où passe le marcheur.',
  'The ways of the crowd, one for each walker.': 'Les trajets de la foule, un par marcheur.',
  'The lines that give the same numbers outside of the page.':
    'Les lignes qui donnent les mêmes nombres hors de la page.',
  'Pixels of a saved image, as a multiple of the window.': 'Pixels d’une image enregistrée, en multiple de la fenêtre.',
  'Saves what is behind the model too; else it is transparent.':
    'Enregistre aussi ce qui est derrière le modèle ; sinon c’est transparent.',
  'What is recorded: a turn around the model, or the walk.': 'Ce qui est filmé : un tour du modèle, ou la marche.',
  'No directions are drawn.': 'Aucune direction n’est dessinée.',
  'download, export': 'télécharger, exporter',
  'tape, ruler, length': 'ruban, règle, longueur',
  'language, shortcuts, about, privacy': 'langue, raccourcis, à propos, vie privée',
  'import, load, drop': 'importer, charger, déposer',
  'zoom, center, reset the view': 'zoom, centrer, réinitialiser la vue',
};
