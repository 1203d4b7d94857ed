/** What lies on the surface: cells and images. */
import type { Texts } from '../translate';

export const SURFACE: Texts = {
  Cells: 'Cellules',
  '{0} cell': '{0} cellule',
  '{0} cells': '{0} cellules',
  'What is nearest to each source, in colors, by exact distances':
    'Ce qui est le plus proche de chaque source, en couleurs, par distances exactes',
  'Nearest source': 'Source la plus proche',
  Percentage: 'Pourcentage',
  Area: 'Aire',
  Borders: 'Frontières',
  'as seen, SVG': 'telles que vues, SVG',
  'as seen, PDF': 'telles que vues, PDF',
  Spread: 'Répartir',
  'Number of sources': 'Nombre de sources',
  'So many sources, each as far from those before as can be':
    'Autant de sources, chacune aussi loin que possible des précédentes',
  'Spread 2 to {0} sources.': 'Répartissez de 2 à {0} sources.',
  Relax: 'Équilibrer',
  'Moves the sources to the middles of their cells, step by step':
    'Déplace les sources vers les milieux de leurs cellules, pas à pas',
  Mean: 'Moyenne',
  'Sends the walker to the mean of the sources: where their squared distances sum to least':
    'Envoie le marcheur à la moyenne des sources : là où la somme de leurs distances au carré est la plus petite',
  'Save borders': 'Enregistrer les frontières',
  'The borders, where another source becomes the nearest one':
    'Les frontières, là où une autre source devient la plus proche',
  'Cells are on surfaces alone.': 'Les cellules sont sur des surfaces seulement.',
  'Cells are of two sources or more.': 'Les cellules sont celles de deux sources au moins.',
  'Where costs differ no distance is exact, and cells are not known.':
    'Là où les coûts diffèrent, aucune distance n’est exacte et les cellules ne sont pas connues.',
  'A source is on no triangle.': 'Une source n’est sur aucun triangle.',
  'Distance from curves': 'Distance aux courbes',
  'Exact distance from all of a curve, not its places alone, negative inside; in two colors':
    'Distance exacte à toute la courbe, non à ses seuls points, négative à l’intérieur ; en deux couleurs',
  Offsets: 'Courbes parallèles',
  'Save offsets': 'Enregistrer les courbes parallèles',
  'The curve and its offsets on both sides, as far apart as the stripes':
    'La courbe et ses parallèles des deux côtés, aussi distantes que les rayures',
  'Blue is inside, up to {0} deep; orange is outside, up to {1} away.':
    'Le bleu est l’intérieur, jusqu’à {0} de profondeur ; l’orange est l’extérieur, jusqu’à {1}.',
  'Curves are on surfaces alone.': 'Les courbes sont sur des surfaces seulement.',
  'There is no curve yet: draw a line or a stroke, or choose a boundary.':
    'Il n’y a pas encore de courbe : dessinez une ligne ou un trait, ou choisissez un bord.',
  'Where costs differ no distance from curves is known.':
    'Là où les coûts diffèrent, aucune distance aux courbes n’est connue.',
  'Exact distance from all of each curve, with a sign, in two colors, and files of its offsets.':
    'Distance exacte à toute la courbe, avec un signe, en deux couleurs, et fichiers de ses parallèles.',
  'The curve and its offsets as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.':
    'La courbe et ses parallèles en DXF, OBJ, CSV ou GLB, ou telles que vues, en SVG ou PDF.',
  'From curves': 'Des courbes',
  'Colors of {0} cell.': 'Couleurs de {0} cellule.',
  'Colors of {0} cells.': 'Couleurs de {0} cellules.',
  'Distance from curves: {0} inside to {1} outside, by color.':
    'Distance aux courbes : de {0} à l’intérieur à {1} à l’extérieur, par couleur.',
  '{0} inside of the curve · {1}': '{0} à l’intérieur de la courbe · {1}',
  '{0} from the curve · {1}': '{0} de la courbe · {1}',
  Loops: 'Boucles',
  'Loops and curves': 'Boucles et courbes',
  'Loops and curves are on surfaces alone.': 'Les boucles et les courbes sont sur des surfaces seulement.',
  'Loop through the sources': 'Boucle par les sources',
  'A closed curve of shortest paths through the sources in their order; through one or two, one that cannot shrink':
    'Courbe fermée de plus courts chemins par les sources, dans leur ordre ; par une ou deux, une qui ne peut se réduire',
  'Save the loop': 'Enregistrer la boucle',
  'The loop through the sources as a curve': 'La boucle par les sources comme courbe',
  'A loop is through one source or more.': 'Une boucle passe par une source ou plus.',
  'This loop shrinks to a point: place sources on the way around a handle or a hole, or three and more.':
    'Cette boucle se réduit à un point : placez des sources sur le tour d’une anse ou d’un trou, ou trois et plus.',
  'The loop is {0} long.': 'La boucle est longue de {0}.',
  'Bézier curve of the sources': 'Courbe de Bézier des sources',
  'A smooth curve from the first source to the last, which those between draw toward them':
    'Courbe lisse de la première source à la dernière, que celles entre elles attirent',
  Curve: 'Courbe',
  'Save the curve': 'Enregistrer la courbe',
  'The Bézier curve as a curve on the surface': 'La courbe de Bézier comme courbe sur la surface',
  'A Bézier curve is of two sources or more.': 'Une courbe de Bézier est de deux sources ou plus.',
  'The curve is {0} long.': 'La courbe est longue de {0}.',
  'A closed curve of shortest paths through the sources in their order.':
    'Courbe fermée de plus courts chemins par les sources, dans leur ordre.',
  'The loop as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.':
    'La boucle en DXF, OBJ, CSV ou GLB, ou telle que vue, en SVG ou PDF.',
  'A smooth curve that the sources control, by shortest paths instead of straight lines.':
    'Courbe lisse que les sources contrôlent, par de plus courts chemins au lieu de droites.',
  'The Bézier curve as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.':
    'La courbe de Bézier en DXF, OBJ, CSV ou GLB, ou telle que vue, en SVG ou PDF.',
  'Carried from the sources': 'Transportées depuis les sources',
  Heading: 'Cap',
  'Arrows of a direction at the sources that is carried along shortest paths, which keeps its angle with them.':
    'Flèches d’une direction aux sources, transportée le long de plus courts chemins, avec lesquels elle garde son angle.',
  'That direction at the sources: degrees counterclockwise from upright, seen from outside.':
    'Cette direction aux sources : degrés depuis la verticale, dans le sens inverse des aiguilles d’une montre, vue de l’extérieur.',
  'Log map of the first source, CSV': 'Carte logarithmique de la première source, CSV',
  'There is no source yet. Place one on the surface.': 'Il n’y a pas encore de source. Placez-en une sur la surface.',
  'Loops around handles': 'Boucles autour des anses',
  'Closed curves that cannot shrink to a point, as short as they can be':
    'Courbes fermées qui ne peuvent se réduire à un point, aussi courtes que possible',
  'Save loops': 'Enregistrer les boucles',
  'The loops around handles as curves': 'Les boucles autour des anses comme courbes',
  '{0} loop.': '{0} boucle.',
  '{0} loops.': '{0} boucles.',
  'The shortest: {0}.': 'Les plus courtes : {0}.',
  'The surface has no handle: all closed curves shrink to points.':
    'La surface n’a pas d’anse : toute courbe fermée se réduit à un point.',
  'Closed geodesics around each handle and through it, with their lengths.':
    'Géodésiques fermées autour de chaque anse et à travers elle, avec leurs longueurs.',
  'The loops as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.':
    'Les boucles en DXF, OBJ, CSV ou GLB, ou telles que vues, en SVG ou PDF.',
  'Images on the surface': 'Images sur la surface',
  Compass: 'Boussole',
  'Polar rings': 'Anneaux polaires',
  Grid: 'Grille',
  Star: 'Étoile',
  Image: 'Image',
  'Image file': 'Fichier d’image',
  'Image file…': 'Fichier d’image…',
  'Lay on': 'Poser',
  'Lays the image on the model, in the middle of what is seen':
    'Pose l’image sur le modèle, au milieu de ce qui est vu',
  'An image of your own; one can be dropped on the model, too':
    'Une image à vous ; on peut aussi en déposer une sur le modèle',
  'The images with the parts of the surface that they cover, with texture coordinates':
    'Les images avec les parties de la surface qu’elles couvrent, avec coordonnées de texture',
  'Save images as GLB': 'Enregistrer les images en GLB',
  'Images are on surfaces alone.': 'Les images sont sur des surfaces seulement.',
  'There can be up to {0} images.': 'Il peut y avoir jusqu’à {0} images.',
  'Select; its handles move, turn and scale it':
    'Sélectionner ; ses poignées la déplacent, la tournent et l’agrandissent',
  'Delete this image': 'Supprimer cette image',
  'Delete image {0}': 'Supprimer l’image {0}',
  Angle: 'Angle',
  'Handles of the image': 'Poignées de l’image',
  'Middle of the image; arrows move it, Delete removes it':
    'Milieu de l’image ; les flèches la déplacent, Suppr la retire',
  'Right side of the image; arrows turn and scale it':
    'Côté droit de l’image ; les flèches la tournent et l’agrandissent',
  'The browser cannot read this image. Save it as PNG or JPEG.':
    'Le navigateur ne peut pas lire cette image. Enregistrez-la en PNG ou JPEG.',
  'This browser cannot draw images beside the page. Try another browser.':
    'Ce navigateur ne peut pas dessiner d’images à côté de la page. Essayez un autre navigateur.',
  'An image can have up to {0} MiB.': 'Une image peut avoir jusqu’à {0} Mio.',
  'The image of this scene is not in this browser. Choose it again.':
    'L’image de cette scène n’est pas dans ce navigateur. Choisissez-la de nouveau.',
  'An image of the page that is laid on the model: along the surface, as a sticker.':
    'Une image de la page posée sur le modèle : le long de la surface, comme un autocollant.',
  'Half of the longer side of the image, along the surface.':
    'La moitié du plus long côté de l’image, le long de la surface.',
  'By how much the image is turned counterclockwise; at 0° it stands upright.':
    'De combien l’image est tournée en sens antihoraire ; à 0° elle est droite.',
};
