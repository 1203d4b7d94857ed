/** Sentences of the errors of modules and of the renderer, in French; their parts are in the files beside. */
import type { Texts } from '../translate';

export const REPORTS: Texts = {
  '{0}; use a mesh with fewer triangles, or the native program on a larger machine':
    '{0} ; utilisez un maillage de moins de triangles, ou le programme natif sur une machine plus grande',
  '{0}, or the native program on a larger machine': '{0}, ou le programme natif sur une machine plus grande',
  '{0}, or use the native program on a larger machine':
    '{0}, ou utilisez le programme natif sur une machine plus grande',
  '{0}; open both together, or the folder that holds them':
    '{0} ; ouvrez les deux ensemble, ou le dossier qui les contient',
  '{0}: not a mesh format known here; use glTF, GLB, OBJ, OFF, PLY, STL, 3MF, VTK, GIFTI or FreeSurfer':
    '{0} : format de maillage inconnu ici ; utilisez glTF, GLB, OBJ, OFF, PLY, STL, 3MF, VTK, GIFTI ou FreeSurfer',
  '{0}: {1} is not supported; {2}': '{0} : {1} n’est pas pris en charge ; {2}',
  'the file refers to {0}, which was not given': 'le fichier renvoie à {0}, qui n’a pas été donné',
  'no triangles: {0}': 'aucun triangle : {0}',
  'triangle {0} refers to vertex {1}, but there are only {2} vertices':
    'le triangle {0} renvoie au sommet {1}, mais il n’y a que {2} sommets',
  'vertex {0} has a coordinate that is not a finite number; repair the file':
    'le sommet {0} a une coordonnée qui n’est pas un nombre fini ; réparez le fichier',
  'vertex {0} has a coordinate beyond ±1e150, where areas are no numbers any more; scale the mesh down':
    'le sommet {0} a une coordonnée au-delà de ±1e150, où les aires ne sont plus des nombres ; réduisez le maillage',
  'a source lies in a wall, at face {0}; move it, or open the wall there':
    'une source est dans un mur, à la face {0} ; déplacez-la, ou ouvrez le mur à cet endroit',
  'there is no part {0}; the file has {1}, counted from 0':
    'il n’y a pas de pièce {0} ; le fichier en a {1}, comptées à partir de 0',
  'the vertices have no attribute {0}; {1}': 'les sommets n’ont pas d’attribut {0} ; {1}',
  'the file gives them none': 'le fichier ne leur en donne aucun',
  'there is no animation {0}; {1}': 'il n’y a pas d’animation {0} ; {1}',
  'the file has none': 'le fichier n’en a aucune',
  'the file has {0}': 'le fichier a {0}',
  'the motion cannot be used: {0}': 'le mouvement est inutilisable : {0}',
  'vertex {0} does not exist; there are {1}, counted from 0':
    'le sommet {0} n’existe pas ; il y en a {1}, comptés à partir de 0',
  'vertex {0} is used by no triangle of the surface; choose another':
    'le sommet {0} n’est dans aucun triangle de la surface ; choisissez-en un autre',
  'triangle {0} does not exist; there are {1}, counted from 0':
    'le triangle {0} n’existe pas ; il y en a {1}, comptés à partir de 0',
  'triangle {0} is in none of the chosen parts; choose another':
    'le triangle {0} n’est dans aucune des pièces choisies ; choisissez-en un autre',
  'triangle {0} has no area or repeats an earlier one and was dropped; choose another':
    'le triangle {0} n’a pas d’aire ou en répète un autre et a été écarté ; choisissez-en un autre',
  'vertex {0} has no edge to the vertex before it on the path':
    'le sommet {0} n’a pas d’arête vers le sommet précédent du chemin',
  'face {0} does not exist; there are {1}, counted from 0':
    'la face {0} n’existe pas ; il y en a {1}, comptées à partir de 0',
  'half-edge {0} does not exist; there are {1}, counted from 0':
    'la demi-arête {0} n’existe pas ; il y en a {1}, comptées à partir de 0',
  '{0} of the way along half-edge {1} is not on it; the fraction must lie between 0 and 1':
    'la fraction {0} de la demi-arête {1} est hors d’elle ; elle doit être entre 0 et 1',
  'face {0} with weights {1} is not a point of the surface: weights must not be negative and must sum to 1':
    'la face {0} avec les poids {1} n’est pas un point de la surface : les poids ne doivent pas être négatifs et leur somme doit être 1',
  'the point does not lie on face {0}': 'le point n’est pas sur la face {0}',
  'the {0} belongs to another surface; make it on this one':
    'cet élément ({0}) appartient à une autre surface ; créez-le sur celle-ci',
  'the file takes more than {0} of memory, the most that a file of {1} may take; it is damaged or made to fill memory, save it again':
    'le fichier prend plus de {0} de mémoire, le maximum pour un fichier de {1} ; il est endommagé ou fait pour remplir la mémoire, enregistrez-le de nouveau',
  'out of memory while {0}; choose a coarser resolution':
    'mémoire épuisée ({0}) ; choisissez une résolution plus grossière',
  'out of memory while {0}': 'mémoire épuisée ({0})',
  'analysing the matrix': 'analyse de la matrice',
  factoring: 'factorisation',
  filling: 'remplissage',
  'keeping windows': 'mémorisation des fenêtres',
  'ordering the unknowns': 'mise en ordre des inconnues',
  'reading the file': 'lecture du fichier',
  cancelled: 'annulé',
  'no source: give at least one': 'aucune source : donnez-en au moins une',
  '{0} is {1}; it must be {2}': '{0} vaut {1} ; il faut {2}',
  'side {0} is not glued to another one that is glued back, runs between the same vertices the other way and is as long':
    'le côté {0} n’est pas collé à un autre qui lui est collé en retour, relie les mêmes sommets en sens inverse et a la même longueur',
  'the triangles at vertex {0} are not one fan in a sheet of its own, so it has no tangent plane; take a vertex for each fan':
    'les triangles au sommet {0} ne forment pas un seul éventail sur un feuillet à part, il n’a donc pas de plan tangent ; prenez un sommet pour chaque éventail',
  'the {0} matrix is not positive definite at vertex {1}: the triangles around it are degenerate; choose the Delaunay operator or repair the mesh there':
    'la matrice {0} n’est pas définie positive au sommet {1} : les triangles qui l’entourent sont dégénérés ; choisissez l’opérateur de Delaunay ou réparez le maillage à cet endroit',
  'conjugate gradients did not converge in {0} steps; choose the Cholesky solver':
    'les gradients conjugués n’ont pas convergé en {0} pas ; choisissez le solveur de Cholesky',
  'conjugate gradients broke down after {0} steps: rounding on thin triangles leaves no positive definite matrix; choose the Cholesky solver':
    'les gradients conjugués ont échoué après {0} pas : les arrondis sur des triangles minces ne laissent pas de matrice définie positive ; choisissez le solveur de Cholesky',
  'factoring takes {0} of memory, more than there is; choose conjugate gradients, which need no factors':
    'la factorisation prend {0} de mémoire, plus qu’il n’y en a ; choisissez les gradients conjugués, qui n’ont pas besoin de facteurs',
  'a mesh of {0} triangles takes {1} of memory, more than the {2} there are':
    'un maillage de {0} triangles prend {1} de mémoire, plus que les {2} disponibles',
  '{0} windows of each half-edge of {1} triangles take {2} of memory, more than the {3} there are; keep one window, which fits':
    '{0} fenêtres pour chaque demi-arête de {1} triangles prennent {2} de mémoire, plus que les {3} disponibles ; gardez une fenêtre, qui tient',
  'exact distances and paths are not known where faces have different costs; ask for auto, propagation with a number of windows, or heat':
    'les distances et chemins exacts ne sont pas connus là où les faces ont des coûts différents ; choisissez automatique, propagation ou chaleur',
  'this distance was not found by heat; ask for the heat method':
    'cette distance n’a pas été trouvée par la chaleur ; choisissez la méthode de la chaleur',
  'no source can be reached from there: the parts are not connected':
    'aucune source n’est accessible de là : les pièces ne sont pas reliées',
  'the loop shrinks to a point, because it goes around no handle and no hole; give places on the way around one, or three and more that hold it':
    'la boucle se réduit à un point, car elle ne fait le tour d’aucune anse ni d’aucun trou ; donnez des lieux autour de l’un d’eux, ou au moins trois qui la retiennent',
  'there are no tetrahedra: give a tetrahedral mesh, or fill a closed surface':
    'il n’y a pas de tétraèdres : donnez un maillage tétraédrique, ou remplissez une surface fermée',
  'tetrahedron {0} names vertex {1}, but there are {2}': 'le tétraèdre {0} renvoie au sommet {1}, mais il y en a {2}',
  'vertex {0} is at {1}: every coordinate must be a finite number':
    'le sommet {0} est à {1} : chaque coordonnée doit être un nombre fini',
  'the largest coordinate is {0}, where it can be {1} to {2}; scale the mesh':
    'la plus grande coordonnée est {0}, alors qu’il faut {1} à {2} ; mettez le maillage à l’échelle',
  'all {0} tetrahedra are flat: none has a volume': 'les {0} tétraèdres sont tous plats : aucun n’a de volume',
  'tetrahedra {0} share the triangle of vertices {1}: two may, so take out those that overlap':
    'les tétraèdres {0} partagent le triangle des sommets {1} : deux le peuvent, retirez donc ceux qui se recouvrent',
  '{0} {1} are more than the {2} that can be numbered': '{0} ({1}) : c’est plus que les {2} qui peuvent être numérotés',
  'there is no vertex {0}: the mesh has {1}, counted from 0':
    'il n’y a pas de sommet {0} : le maillage en a {1}, comptés à partir de 0',
  'there is no tetrahedron {0}: the mesh has {1}, counted from 0':
    'il n’y a pas de tétraèdre {0} : le maillage en a {1}, comptés à partir de 0',
  'the weights {0} in tetrahedron {1} must be 0 or more, and sum to 1':
    'les poids {0} dans le tétraèdre {1} doivent être au moins 0, et leur somme 1',
  'a source starts from the distance {0}; it must be a finite number, 0 or more':
    'une source commence à la distance {0} ; il faut un nombre fini, au moins 0',
  '{0} values were given for {1} vertices: give one for each':
    '{0} valeurs ont été données pour {1} sommets : donnez-en une pour chacun',
  'a level is {0}; it must be a finite number': 'un niveau vaut {0} ; il faut un nombre fini',
  '{0} costs were given for {1} tetrahedra: give one for each':
    '{0} coûts ont été donnés pour {1} tétraèdres : donnez-en un pour chacun',
  'the cost of tetrahedron {0} is {1}; it must be from {2} to {3}, or infinite for a wall':
    'le coût du tétraèdre {0} est {1} ; il doit aller de {2} à {3}, ou être infini pour un mur',
  'the source {0} lies in a wall: all tetrahedra around it have an infinite cost':
    'la source {0} est dans un mur : tous les tétraèdres qui l’entourent ont un coût infini',
  'every tetrahedron is a wall: give one of them a finite cost':
    'chaque tétraèdre est un mur : donnez à l’un d’eux un coût fini',
  'the {0} belongs to another mesh': 'cet élément ({0}) appartient à un autre maillage',
  'the surface does not enclose a volume: it has {0}; close it, or choose parts that are closed':
    'la surface n’enferme pas de volume : elle a {0} ; fermez-la, ou choisissez des pièces fermées',
  'inside and outside of the surface cannot be told: its triangles disagree about them; repair the mesh, or choose other parts':
    'l’intérieur et l’extérieur de la surface ne se distinguent pas : ses triangles se contredisent ; réparez le maillage, ou choisissez d’autres pièces',
  'nothing of the inside is as thick as a cell; choose a finer resolution than {0} cells along the longest side':
    'rien de l’intérieur n’est aussi épais qu’une cellule ; choisissez une résolution plus fine que {0} cellules le long du plus grand côté',
  '{0}: not a format of tetrahedral meshes known here; use Medit (.mesh, .meshb), Gmsh (.msh), VTK (.vtu, .vtk) or TetGen (.node with .ele)':
    '{0} : format de maillage tétraédrique inconnu ici ; utilisez Medit (.mesh, .meshb), Gmsh (.msh), VTK (.vtu, .vtk) ou TetGen (.node avec .ele)',
  '{0} holds no faces: {1}': '{0} ne contient pas de faces : {1}',
  '{0} has a header and nothing else: neither vertices nor faces; save it again':
    '{0} a un en-tête et rien d’autre : ni sommets ni faces ; enregistrez-le de nouveau',
  '{0} is a single point without faces; a surface has triangles':
    '{0} est un seul point sans faces ; une surface a des triangles',
  '{0} is a cloud of {1} points without faces; make a surface of it first':
    '{0} est un nuage de {1} points sans faces ; faites-en d’abord une surface',
  '{0} holds no tetrahedra{1}; {2}': '{0} ne contient pas de tétraèdres{1} ; {2}',
  '{0} holds no tetrahedra; {1}': '{0} ne contient pas de tétraèdres ; {1}',
  '{0}: {1} {2} refers to vertex {3}, which does not exist; repair the file':
    '{0} : l’élément {1} {2} renvoie au sommet {3}, qui n’existe pas ; réparez le fichier',
  '{0} were split into tetrahedra; of {1} curved cells the corners were taken':
    '{0} découpés en tétraèdres ; de {1} cellules courbes, seuls les coins sont pris',
  '{0} were split into tetrahedra': '{0} découpés en tétraèdres',
  'of {0} curved cells the corners were taken': 'de {0} cellules courbes, seuls les coins sont pris',
  'strip {0} cannot be unrolled: it is curved, with an angle defect of {1} rad at vertex {2} and of {3} rad in all, where {4} is allowed; {5}':
    'la bande {0} ne peut être déroulée : elle est courbe, avec un défaut angulaire de {1} rad au sommet {2} et de {3} rad en tout, où {4} est permis ; {5}',
  'no spacing changes that, since one vertex has more than that, and only strips without such vertices are flat':
    'aucun pas n’y change rien, car un seul sommet dépasse cela, et seules les bandes sans tels sommets sont plates',
  'choose a smaller spacing': 'choisissez un pas plus petit',
  '{0} vertices need as many distances, not {1}': 'à {0} sommets il faut autant de distances, non {1}',
  'triangle {0} uses vertex {1}, and there are {2}, counted from 0':
    'le triangle {0} utilise le sommet {1}, et il y en a {2}, comptés à partir de 0',
  'vertex {0} has a {1} that is not a number': 'le sommet {0} a une valeur ({1}) qui n’est pas un nombre',
  'no isoline: {0}': 'aucune isoligne : {0}',
  'these are {0} isolines, and {1} are drawn at most; choose a larger spacing':
    'cela fait {0} isolignes, et {1} sont dessinées au plus ; choisissez un pas plus grand',
  'the strips have more vertices than 32 bits can number; choose fewer isolines':
    'les bandes ont plus de sommets que 32 bits ne peuvent en numéroter ; choisissez moins d’isolignes',
  'This browser offers neither WebGPU nor WebGL2. Turn on hardware acceleration or try another browser. ({0})':
    'Ce navigateur n’offre ni WebGPU ni WebGL2. Activez l’accélération matérielle ou essayez un autre navigateur. ({0})',
  'The graphics device could not be opened. Close other 3D pages and reload this one. ({0})':
    'La carte graphique n’a pas pu être ouverte. Fermez les autres pages 3D et rechargez celle-ci. ({0})',
  'The canvas cannot be used for drawing. Reload the page. ({0})':
    'Le canevas ne peut pas servir à dessiner. Rechargez la page. ({0})',
  'The mesh is too large for this graphics device: its {0} need {1} MB in one buffer, {2} MB are allowed. Simplify the mesh or switch the backend.':
    'Le maillage est trop grand pour cette carte graphique : ses données ({0}) prennent {1} Mo dans un tampon, {2} Mo sont permis. Simplifiez le maillage ou changez de moteur.',
  'A picture of {0} × {1} pixels is too large for this graphics device: {2} along a side are allowed. Choose a smaller one.':
    'Une image de {0} × {1} pixels est trop grande pour cette carte graphique : {2} par côté sont permis. Choisissez-en une plus petite.',
  'The {0} hold {1} numbers where {2} were expected.': 'Les données ({0}) ont {1} nombres au lieu de {2}.',
  'Triangle {0} refers to vertex {1}, but there are only {2} vertices.':
    'Le triangle {0} renvoie au sommet {1}, mais il n’y a que {2} sommets.',
  'The {0} hold a vector, number {1}, that is not finite.':
    'Les données ({0}) ont un vecteur, le numéro {1}, qui n’est pas fini.',
  'The {0} hold a place, number {1}, with a coordinate too large to be drawn. Centre and scale them.':
    'Les données ({0}) ont un point, le numéro {1}, dont une coordonnée est trop grande pour être dessinée. Centrez-les et mettez-les à l’échelle.',
  'The {0} is not a finite number of 0 or more.': 'La valeur ({0}) n’est pas un nombre fini, au moins 0.',
  'The graphics device is out of memory, so the picture is incomplete. Close other 3D pages or open a smaller mesh.':
    'La carte graphique n’a plus de mémoire, l’image est donc incomplète. Fermez les autres pages 3D ou ouvrez un maillage plus petit.',
  'The graphics device refused a step, so the picture may be incomplete. Reload the page if it stays so. ({0})':
    'La carte graphique a rejeté une étape, l’image peut donc être incomplète. Rechargez la page si cela reste. ({0})',
  'it is no intact KTX 2.0 file of a Basis Universal image':
    'ce n’est pas un fichier KTX 2.0 intact d’une image Basis Universal',
  'it is not one image in ETC1S or UASTC, as textures of glTF are':
    'ce n’est pas une image en ETC1S ou UASTC, comme le sont les textures de glTF',
  'it has {0} × {1} texels; 8192 either way are the most':
    'elle a {0} × {1} texels ; 8192 de chaque côté est le maximum',
  'its texels are damaged': 'ses texels sont endommagés',
  'No mesh is open.': 'Aucun maillage n’est ouvert.',
  'Only tetrahedra can be asked this, and the mesh is a surface.':
    'Cette question est pour des tétraèdres, et le maillage est une surface.',
  'Only a surface can be asked this, and the mesh is one of tetrahedra.':
    'Cette question est pour une surface, et le maillage est fait de tétraèdres.',
  'distances at places could not be had': 'les distances en ces endroits n’ont pas pu être obtenues',
  'line {0}': 'ligne {0}',
  'byte {0}': 'octet {0}',
  '{0}, {1}: {2}': '{0}, {1} : {2}',
};
