/** What the readers of surfaces say of files that they refuse, in French: whole sentences and what is put into them. */
import type { Texts } from '../translate';

export const READERS: Texts = {
  // Where.
  'end of file': 'fin du fichier',
  'PLY, header: {0}': 'PLY, en-tête : {0}',
  'text, {0}: {1}': 'texte, {0} : {1}',
  '{0}, byte {1}': '{0}, octet {1}',
  'JSON line {0} column {1}': 'JSON, ligne {0}, colonne {1}',
  'piece {0}, face {1}': 'partie {0}, face {1}',
  'face {0}': 'face {0}',
  'vertex {0}': 'sommet {0}',
  'cell {0}': 'cellule {0}',
  'volume cell {0}': 'cellule de volume {0}',
  'element {0}': 'élément {0}',
  'object {0}': 'objet {0}',
  'triangle {0} of the object {1}': 'triangle {0} de l’objet {1}',
  'accessor {0}': 'accesseur {0}',
  'buffer {0}': 'buffer {0}',
  'buffer view {0}': 'bufferView {0}',
  'image {0}': 'image {0}',
  'mesh {0}': 'maillage {0}',
  'node {0}': 'nœud {0}',
  'node {0} of clip {1}': 'nœud {0} de l’animation {1}',
  'node {0} of a skin': 'nœud {0} d’un skin',
  'scene {0}': 'scène {0}',
  'skin {0}': 'skin {0}',
  // Points without faces.
  'a point needs three numbers, but {0}': 'il faut trois nombres à un point, mais {0}',
  'points, {0}: {1}': 'points, {0} : {1}',
  'a cloud has to have three points at least that are different and finite, and of the {0} here so many are: {1}':
    'un nuage doit avoir au moins trois points différents et finis, et des {0} d’ici, autant le sont : {1}',
  'all {0} points lie on lines, so no triangles can be made between them; give points of a surface':
    'les {0} points sont tous sur des lignes, donc aucun triangle ne peut les relier ; donnez des points d’une surface',
  'there is not enough memory to join {0} points; give fewer':
    'la mémoire ne suffit pas pour relier {0} points ; donnez-en moins',
  // How much.
  '{0} bytes': '{0} octets',
  '{0} KB': '{0} ko',
  '{0} MB': '{0} Mo',
  // What is left out, one kind after the other.
  '{0}; {1}': '{0} ; {1}',
  '1 point or line was left out': '1 point ou ligne ignoré',
  '{0} points or lines were left out': '{0} points ou lignes ignorés',
  '1 statement of a curve or a surface of free form was left out; save the model as polygons':
    '1 instruction de courbe ou de surface de forme libre ignorée ; enregistrez le modèle en polygones',
  '{0} statements of curves or surfaces of free form were left out; save the model as polygons':
    '{0} instructions de courbes ou de surfaces de forme libre ignorées ; enregistrez le modèle en polygones',
  '1 cell that fills space was left out': '1 cellule de volume ignorée',
  '{0} cells that fill space were left out': '{0} cellules de volume ignorées',
  '1 statement is not known and was left out': '1 instruction inconnue ignorée',
  '{0} statements are not known and were left out': '{0} instructions inconnues ignorées',
  '1 backslash ends a line; the next one begins a statement of its own and was not joined to it':
    '1 barre oblique inverse termine une ligne ; la suivante commence une instruction et n’y a pas été jointe',
  '{0} backslashes end lines; the next one begins a statement of its own and was not joined to it':
    '{0} barres obliques inverses terminent des lignes ; la suivante commence une instruction et n’y a pas été jointe',
  '1 facet has no endfacet': '1 facette n’a pas de endfacet',
  '{0} facets have no endfacet': '{0} facettes n’ont pas de endfacet',
  'the end of the file is missing; it may be cut short': 'la fin du fichier manque ; il est peut-être tronqué',
  'there is more behind the end; it was left out': 'il y a des données après la fin ; elles sont ignorées',
  '1 curved cell became flat between its corners': '1 cellule courbe est devenue plane entre ses coins',
  '{0} curved cells became flat between their corners': '{0} cellules courbes sont devenues planes entre leurs coins',
  '1 polygon crosses itself; its triangles are a guess': '1 polygone se recoupe ; ses triangles sont une supposition',
  '{0} polygons cross themselves; their triangles are a guess':
    '{0} polygones se recoupent ; leurs triangles sont une supposition',
  // What is not a mesh.
  '{0} is empty: nothing is in it; save or copy it again':
    '{0} est vide : il ne contient rien ; enregistrez-le ou copiez-le de nouveau',
  'this is a pointer to the mesh, not the mesh; fetch it by `git lfs pull`':
    'ceci est un pointeur vers le maillage, non le maillage ; récupérez-le par `git lfs pull`',
  'this is a web page, not a mesh; download the file itself':
    'ceci est une page web, non un maillage ; téléchargez le fichier lui-même',
  'this is UTF-16 text; save it as UTF-8': 'c’est un texte en UTF-16 ; enregistrez-le en UTF-8',
  'this format': 'ce format',
  'convert {0} to GLB, in {1} or by `assimp export`': 'convertissez {0} en GLB, dans {1} ou par `assimp export`',
  'Blender up to version 4.5': 'Blender jusqu’à la version 4.5',
  'the file holds none; export the surface as triangles':
    'le fichier n’en contient aucun ; exportez la surface en triangles',
  'the only one has zero area; check the scale of the file': 'le seul a une aire nulle ; vérifiez l’échelle du fichier',
  'all {0} have zero area; check the scale of the file':
    'les {0} ont tous une aire nulle ; vérifiez l’échelle du fichier',
  // Numbers and vertices in text.
  'a vertex needs three numbers, but {0}': 'un sommet demande trois nombres, mais {0}',
  'it is missing': 'rien ne suit',
  'there are {0}; the file may be cut short: copy or export it again':
    'il y en a {0} ; le fichier est peut-être tronqué : copiez-le ou exportez-le de nouveau',
  '"{0}" is found': 'on trouve « {0} »',
  '"{0}" has a decimal comma; save the file with decimal points':
    '« {0} » a une virgule décimale ; enregistrez le fichier avec des points décimaux',
  'vertex {0} does not exist; there are {1}, counted from {2}':
    'le sommet {0} n’existe pas ; il y en a {1}, comptés à partir de {2}',
  // OBJ.
  'vertex {0} counts back beyond the {1} vertices so far':
    'le sommet {0} compte en arrière au-delà des {1} sommets lus jusque-là',
  '"{0}" is not a vertex index; they count from 1':
    '« {0} » n’est pas un indice de sommet ; ils comptent à partir de 1',
  // OFF.
  '"{0}" is not an OFF header; save it as plain OFF': '« {0} » n’est pas un en-tête OFF ; enregistrez-le en OFF simple',
  'binary OFF': 'le format OFF binaire',
  'save it as ASCII OFF or binary PLY': 'enregistrez-le en OFF ASCII ou en PLY binaire',
  'the number of dimensions': 'le nombre de dimensions',
  'a space of {0} dimensions': 'un espace à {0} dimensions',
  'give every vertex three coordinates': 'donnez trois coordonnées à chaque sommet',
  'the number of vertices': 'le nombre de sommets',
  'the number of faces': 'le nombre de faces',
  '{0}; the file is cut short, save it again': '{0} ; le fichier est tronqué, enregistrez-le de nouveau',
  '{0} is missing; the file is cut short, save it again':
    'il manque {0} ; le fichier est tronqué, enregistrez-le de nouveau',
  '{0} is expected, but "{1}" is found; correct the line': 'on attend {0}, mais on trouve « {1} » ; corrigez la ligne',
  'vertex {0} needs {1} numbers, but {2}; correct the line':
    'le sommet {0} demande {1} nombres, mais {2} ; corrigez la ligne',
  '{0} of {1} vertices are missing': 'il manque {0} des {1} sommets',
  '{0} of {1} faces are missing': 'il manque {0} des {1} faces',
  'the number of corners of a face': 'le nombre de coins d’une face',
  'corner {0} of face {1} is missing; correct the line': 'le coin {0} de la face {1} manque ; corrigez la ligne',
  'a vertex of a face': 'un sommet d’une face',
  // PLY.
  'the file ends before it': 'le fichier se termine avant',
  '{0} should be a number, but {1}; the file is damaged or cut short, save it again':
    '{0} devrait être un nombre, mais {1} ; le fichier est endommagé ou tronqué, enregistrez-le de nouveau',
  'its length is {0}': 'sa longueur est {0}',
  'vertex {0} is no index, which is whole and not negative; repair the file':
    'le sommet {0} n’est pas un indice : il faut un nombre entier, non négatif ; réparez le fichier',
  'it has no {0}; export the mesh with them': 'il lui manque {0} ; exportez le maillage complet',
  'x, y and z': 'x, y et z',
  'list of vertex indices': 'la liste des indices de sommets',
  'there is no end_header; the file is cut short, save it again':
    'il n’y a pas de end_header ; le fichier est tronqué, enregistrez-le de nouveau',
  'there is no format line; save the file again': 'il n’y a pas de ligne format ; enregistrez le fichier de nouveau',
  '{0}: "{1}"': '{0} : « {1} »',
  'unknown encoding; save as ascii or binary_little_endian':
    'encodage inconnu ; enregistrez en ascii ou binary_little_endian',
  'the count is not a whole number': 'la quantité n’est pas un nombre entier',
  'there are vertices twice, and faces count in one list of them; merge both lists':
    'il y a deux listes de sommets, et les faces n’en comptent qu’une ; réunissez-les',
  'unknown property type': 'type de propriété inconnu',
  'a property before any element': 'une propriété avant tout élément',
  'not a header line; the file is damaged': 'ce n’est pas une ligne d’en-tête ; le fichier est endommagé',
  // STL.
  'text that begins with "solid" and has facets is expected; save the file again':
    'on attend un texte qui commence par « solid » et a des facettes ; enregistrez le fichier de nouveau',
  'the file is shorter than an STL header; save it again':
    'le fichier est plus court qu’un en-tête STL ; enregistrez-le de nouveau',
  '{0} of {1} triangles are missing; save it again':
    'il manque {0} des {1} triangles ; enregistrez le fichier de nouveau',
  'the facet is cut short by the end of the file; save it again':
    'la facette est coupée par la fin du fichier ; enregistrez-le de nouveau',
  'a facet has {0} corners instead of 3': 'une facette a {0} coins au lieu de 3',
  // GIFTI and FreeSurfer.
  'the array {0} has no size or no type of numbers; save the file again':
    'le tableau {0} n’a pas de taille ou de type de nombres ; enregistrez le fichier de nouveau',
  'the array {0} has rows of {1} numbers in place of 3; save the file again':
    'le tableau {0} a des lignes de {1} nombres au lieu de 3 ; enregistrez le fichier de nouveau',
  'there is no surface in it; give the file of points and triangles (.surf.gii)':
    'il ne contient pas de surface ; donnez le fichier des points et des triangles (.surf.gii)',
  'there are no labels in it; give a .label.gii file': 'il ne contient pas d’étiquettes ; donnez un fichier .label.gii',
  'several maps of labels in one file': 'plusieurs cartes d’étiquettes dans un fichier',
  'the annotation has no table of names; save it with its colors':
    'l’annotation n’a pas de table de noms ; enregistrez-la avec ses couleurs',
  'several surfaces in one file': 'plusieurs surfaces dans un fichier',
  'save each by itself': 'enregistrez chacune à part',
  'it does not begin as a surface of FreeSurfer does; save it again, in binary form':
    'il ne commence pas comme une surface de FreeSurfer ; enregistrez-le de nouveau, sous forme binaire',
  // Archives, and 3MF.
  'it holds no mesh of a format known here; unpack it and see what it holds':
    'elle ne contient aucun maillage d’un format connu ici ; décompressez-la et regardez ce qu’elle contient',
  'it holds {0} meshes ({1}{2}); unpack it and name one':
    'elle contient {0} maillages ({1}{2}) ; décompressez-la et nommez-en un',
  'it is damaged or cut short; copy it again': 'les données sont endommagées ou tronquées ; copiez-les de nouveau',
  'it holds more than {0} files; save it again': 'elle contient plus de {0} fichiers ; enregistrez-la de nouveau',
  'two files of the archive have this name; pack it again':
    'deux fichiers de l’archive ont ce nom ; compressez-la de nouveau',
  'it is damaged or cut short; copy the file again': 'il est endommagé ou tronqué ; copiez le fichier de nouveau',
  'it is not in the file; save it again': 'il n’est pas dans le fichier ; enregistrez-le de nouveau',
  'encryption ({0})': 'le chiffrement ({0})',
  'save it without protection': 'enregistrez-le sans protection',
  'packing by method {0} ({1})': 'le mode de compression {0} ({1})',
  'pack it by deflation': 'compressez-le par deflate',
  'no build item of {0} shows a mesh that it holds, or as support alone; save the model with its build':
    'aucun élément de build de {0} ne montre un maillage du fichier, sinon comme support ; enregistrez le modèle avec son build',
  'its components are nested in a circle or without end; save the model again':
    'ses composants sont imbriqués en cercle ou sans fin ; enregistrez le modèle de nouveau',
  'it is used and not defined; save the model again':
    'il est utilisé sans être défini ; enregistrez le modèle de nouveau',
  'an object has no identifier; save the model again':
    'un objet n’a pas d’identifiant ; enregistrez le modèle de nouveau',
  'a triangle needs three vertices': 'un triangle demande trois sommets',
  'it is not text in UTF-8; save the model again': 'ce n’est pas un texte en UTF-8 ; enregistrez le modèle de nouveau',
  'the XML is not well-formed; the file is damaged, save it again':
    'le XML est mal formé ; le fichier est endommagé, enregistrez-le de nouveau',
  // VTK.
  'the file is cut short; copy it again': 'le fichier est tronqué ; copiez-le de nouveau',
  'the dataset {0}': 'le jeu de données {0}',
  'extract its surface and save it as PolyData': 'extrayez sa surface et enregistrez-la en PolyData',
  'extract its surface and save it as polygonal data':
    'extrayez sa surface et enregistrez-la en données polygonales (POLYDATA)',
  'compression by {0}': 'le format de compression {0}',
  'save it compressed by zlib or not at all': 'enregistrez-le compressé par zlib, ou sans compression',
  'the array {0} is damaged or cut short; save the file again':
    'le tableau {0} est endommagé ou tronqué ; enregistrez le fichier de nouveau',
  'the array {0} has no type of numbers; save the file again':
    'le tableau {0} n’a pas de type de nombres ; enregistrez le fichier de nouveau',
  'in the array {0} a number should be, but {1}': 'le tableau {0} devrait avoir un nombre, mais {1}',
  'expected ASCII or BINARY; save the file again': 'on attend ASCII ou BINARY ; enregistrez le fichier de nouveau',
  '"{0}" is no {1} statement': '« {0} » n’est pas une instruction {1}',
  '{0}; the file is damaged, save it again': '{0} ; le fichier est endommagé, enregistrez-le de nouveau',
  '{0} numbers should follow, and the file ends': '{0} nombres devraient suivre, et le fichier se termine',
  'a number should follow, but {0}': 'un nombre devrait suivre, mais {0}',
  'the offsets and the points of cells should follow': 'les décalages et les points de cellules devraient suivre',
  'cell {0} has too few points': 'la cellule {0} a trop peu de points',
  'this is no array of numbers': 'ce n’est pas un tableau de nombres',
  'it uses point {0}, but there are only {1}; repair the file':
    'elle utilise le point {0}, mais il n’y en a que {1} ; réparez le fichier',
  'a convex point set': 'un ensemble convexe de points',
  'a polyhedron': 'un polyèdre',
  'a parametric cell': 'une cellule paramétrique',
  'a cell of type {0}': 'une cellule de type {0}',
  'it has too few points; save the file again': 'elle a trop peu de points ; enregistrez le fichier de nouveau',
  'a point index is negative or not whole; repair the file':
    'un indice de point est négatif ou n’est pas entier ; réparez le fichier',
  'its type or its points are missing; the file is damaged':
    'son type ou ses points manquent ; le fichier est endommagé',
};
