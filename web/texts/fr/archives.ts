/** What is said of archives, which are opened in workers too. */
import type { Texts } from '../translate';

export const ARCHIVES: Texts = {
  'an archive may have 2 GiB at most; unpack it and open the files':
    'une archive peut avoir 2 Gio au plus ; décompressez-la et ouvrez les fichiers',
  '{0} is not in the archive': '{0} n’est pas dans l’archive',
  '{0} is encrypted; unpack the archive and open the files':
    '{0} est chiffré ; décompressez l’archive et ouvrez les fichiers',
  '{0} is packed by method {1}, which is not supported; pack it again as a plain .zip':
    '{0} est compressé par la méthode {1}, qui n’est pas lue ; recompressez-le en simple .zip',
  '{0} is damaged or cut short; copy it again': '{0} est endommagé ou tronqué ; copiez-le de nouveau',
  '{0} takes more than {1} MiB unpacked, too much for a file of this size':
    '{0} fait plus de {1} Mio une fois décompressé, trop pour un fichier de cette taille',
  '{0} and what is with it take more than {1} MiB unpacked, too much for an archive of this size':
    '{0} et ce qui l’accompagne prennent plus de {1} Mio une fois décompressés, trop pour une archive de cette taille',
  'the archive holds {0} twice; unpack it and open the files':
    'l’archive contient {0} deux fois ; décompressez-la et ouvrez les fichiers',
  '{0} claims to be {1} times as large as it is packed': '{0} prétend être {1} fois plus grand que compressé',
  'the archive is damaged or cut short; copy it again': 'l’archive est endommagée ou tronquée ; copiez-la de nouveau',
  'the archive holds {0} files, more than {1}; unpack it and open the files':
    'l’archive contient {0} fichiers, plus de {1} ; décompressez-la et ouvrez les fichiers',
};

/** Texts of the page: tools, workspaces, search and opening. */
export const SHELL: Texts = {
  'Draw a line of sources along edges': 'Dessiner une ligne de sources le long d’arêtes',
  'Draw a stroke of sources': 'Dessiner un trait de sources',
  'Make a whole boundary a source': 'Faire d’un bord entier une source',
  'Make a whole part a source': 'Faire d’une pièce entière une source',
  'Brush on or off': 'Pinceau en marche ou à l’arrêt',
  'Smaller brush': 'Pinceau plus petit',
  'Larger brush': 'Pinceau plus grand',
  'Zoom in': 'Agrandir',
  'Zoom out': 'Réduire',
  'Fill the surface, or cut it open': 'Remplir la surface, ou l’ouvrir d’une coupe',
  'Move the cut back': 'Reculer la coupe',
  'Move the cut forward': 'Avancer la coupe',
  'Search settings and commands': 'Chercher réglages et commandes',
  '{0} ({1})': '{0} ({1})',
  '{1}, {2}, in one piece.': '{1}, {2}, d’un seul tenant.',
  '{1}, {2}, in {0} pieces.': '{1}, {2}, en {0} morceaux.',
  '{0} join them, without a hole.': '{0} les relient, sans trou.',
  '{1} join them, with {0} hole or border.': '{1} les relient, avec {0} trou ou bord.',
  '{1} join them, with {0} holes and borders.': '{1} les relient, avec {0} trous et bords.',
  '{0} point is on no triangle.': '{0} point n’est sur aucun triangle.',
  '{0} points are on no triangle.': '{0} points ne sont sur aucun triangle.',
  Found: 'Trouvés',
  'Nothing has these words.': 'Rien ne contient ces mots.',
  'Close the search': 'Fermer la recherche',
  Search: 'Recherche',
  Preset: 'Modèle proposé',
  Workspaces: 'Espaces de travail',
  Share: 'Partage',
  'Open a file, a folder, an address or a preset': 'Ouvrir un fichier, un dossier, une adresse ou un modèle proposé',
  'Copy a link, save images, videos and data': 'Copier un lien, enregistrer images, vidéos et données',
  Details: 'Détails',
  'Address of a mesh or a .zip': 'Adresse d’un maillage ou d’un .zip',
  'This is no http or https address.': 'Ce n’est pas une adresse http ou https.',
  'Show the presets': 'Montrer les modèles proposés',
  Line: 'Ligne',
  Stroke: 'Trait',
  Part: 'Pièce',
  Cut: 'Coupe',
  'Pin {0}': 'Épingler {0}',
  'Keeps this workspace beside the next one': 'Garde cet espace de travail à côté du prochain',
  'Tools of the workspace': 'Outils de l’espace de travail',
  'The lengths in the file are in {0}': 'Les longueurs du fichier sont en {0}',
  '{0} points up': '{0} pointe vers le haut',
  '{0} across?': '{0} d’un coin à l’autre ?',
  'In which unit?': 'Dans quelle unité ?',
  'Unit of the file': 'Unité du fichier',
  'Axis that points up': 'Axe qui pointe vers le haut',
  'View from the front': 'Vue de face',
  'Orthographic or perspective': 'Orthographique ou en perspective',
  'View from the side': 'Vue de côté',
  'View from above': 'Vue de dessus',
  'Legend on or off': 'Légende affichée ou non',
};
