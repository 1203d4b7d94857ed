/** What the reader of glTF says of files that it refuses, in French, and what a motion lacks. */
import type { Texts } from '../translate';

export const GLTF: Texts = {
  '{0}; export the file again': '{0} ; exportez le fichier de nouveau',
  '{0}; export it again': '{0} ; exportez-le de nouveau',
  'it does not exist': 'il n’existe pas',
  'there are only {0}; export the file again': 'il n’y en a que {0} ; exportez le fichier de nouveau',
  'there are only {0} of them; export the file again': 'il n’y en a que {0} ; exportez le fichier de nouveau',
  // JSON.
  'the text is cut short here; copy or export it again':
    'le texte est tronqué ici ; copiez-le ou exportez-le de nouveau',
  'lists and objects within each other are more than 127 deep here; export it with fewer':
    'plus de 127 listes et objets sont imbriqués ici ; exportez-le avec moins',
  '{0} at line {1} column {2}': '{0}, ligne {1}, colonne {2}',
  'expected value': 'une valeur est attendue',
  'expected ident': 'true, false ou null est attendu',
  'expected `:`': '« : » est attendu',
  'expected `,` or `]`': '« , » ou « ] » est attendu',
  'expected `,` or `}`': '« , » ou « } » est attendu',
  'key must be a string': 'une clé doit être un texte entre guillemets',
  'invalid escape': 'échappement invalide',
  'invalid number': 'nombre invalide',
  'number out of range': 'nombre trop grand',
  'control character (\\u0000-\\u001F) found while parsing a string':
    'caractère de contrôle (\\u0000-\\u001F) dans un texte',
  'trailing comma': 'virgule de trop',
  'trailing characters': 'caractères de trop',
  'invalid unicode code point': 'caractère Unicode invalide',
  'missing field `{0}`': 'la propriété `{0}` manque',
  'duplicate field `{0}`': 'la propriété `{0}` est double',
  'invalid type: {0}, expected {1}': 'type invalide : {0} au lieu de {1}',
  'string "{0}"': 'texte « {0} »',
  'integer `{0}`': 'nombre entier `{0}`',
  'floating point `{0}`': 'nombre `{0}`',
  'boolean `{0}`': 'booléen `{0}`',
  'invalid value: {0}, expected {1}': 'valeur invalide : {0} au lieu de {1}',
  // The container.
  'the file begins neither as GLB nor as JSON; export it again':
    'le début du fichier n’est ni GLB ni JSON ; exportez-le de nouveau',
  'the GLB file is damaged: {0} is no version; export it again':
    'le fichier GLB est endommagé : {0} n’est pas une version ; exportez-le de nouveau',
  'the GLB file is cut short; copy it again': 'le fichier GLB est tronqué ; copiez-le de nouveau',
  'version {0}': 'ce format en version {0}',
  'export the file as glTF 2.0': 'exportez le fichier en glTF 2.0',
  'export the file without this extension': 'exportez le fichier sans cette extension',
  'it reaches beyond its buffer of {0} bytes; the file is cut short':
    'il dépasse son buffer de {0} octets ; le fichier est tronqué',
  'it has neither a URI nor a binary chunk; export the file again':
    'il n’a ni URI ni bloc binaire ; exportez le fichier de nouveau',
  'its data URI has no comma before the data; export the file again':
    'son URI data: n’a pas de virgule avant les données ; exportez le fichier de nouveau',
  'its base64 data is damaged; export the file again':
    'ses données base64 sont endommagées ; exportez le fichier de nouveau',
  // Accessors.
  'its count is too large': 'son nombre d’éléments est trop grand',
  'vertex indices must be unsigned integers': 'les indices de sommets doivent être des entiers non signés',
  'its component type is unknown': 'son type de composantes est inconnu',
  'its type is not {0}': 'son type n’est pas {0}',
  'its compressed values have another type; export the file again':
    'ses valeurs compressées ont un autre type ; exportez le fichier de nouveau',
  'it has no data; export the file again': 'il n’a pas de données ; exportez le fichier de nouveau',
  'its sparse indices have an unknown type': 'ses indices creux (sparse) ont un type inconnu',
  'its sparse count is too large': 'son nombre de valeurs creuses (sparse) est trop grand',
  'its sparse index {0} is out of range': 'son indice creux (sparse) {0} est hors limites',
  'its elements overlap: the byte stride is too small':
    'ses éléments se recouvrent : l’intervalle en octets (byteStride) est trop petit',
  'it reaches beyond its buffer view; the file is cut short or damaged':
    'il dépasse son bufferView ; le fichier est tronqué ou endommagé',
  // Nodes and meshes.
  'a morph target has another number of vertices than its mesh; export the file again':
    'une cible de morphing n’a pas autant de sommets que son maillage ; exportez le fichier de nouveau',
  'joint {0} of vertex {1} does not exist; export the file again':
    'l’articulation {0} du sommet {1} n’existe pas ; exportez le fichier de nouveau',
  'its instances have attributes of different lengths; export the file again':
    'ses instances ont des attributs de longueurs différentes ; exportez le fichier de nouveau',
  'no node of the scene that is shown has a mesh of the file; export it with its scene':
    'aucun nœud de la scène montrée n’a de maillage du fichier ; exportez-le avec sa scène',
  'primitive {0} of node {1}': 'primitive {0} du nœud {1}',
  'its mode is unknown; export the file again': 'son mode est inconnu ; exportez le fichier de nouveau',
  'it has two parents or is its own ancestor; the nodes must form trees, export the file again':
    'il a deux parents ou est son propre ancêtre ; les nœuds doivent former des arbres, exportez le fichier de nouveau',
  // Compression.
  'its {0} names no buffer view; export the file again':
    'son {0} n’indique aucun bufferView ; exportez le fichier de nouveau',
  'its Draco data has no attribute {0}, which accessor {1} stands for':
    'ses données Draco n’ont pas d’attribut {0}, que représente l’accesseur {1}',
  'attribute {0} of its Draco data has a component type that glTF has not':
    'l’attribut {0} de ses données Draco a un type de composantes que glTF n’a pas',
  'attribute {0} of its Draco data is damaged': 'l’attribut {0} de ses données Draco est endommagé',
  'its Draco data is damaged or of an unknown version; export the file again':
    'ses données Draco sont endommagées ou d’une version inconnue ; exportez le fichier de nouveau',
  'its compressed data is of another kind, or of a later version':
    'ses données compressées sont d’une autre sorte ou d’une version plus récente',
  'it does not fit into memory': 'il ne tient pas en mémoire',
  'a channel of its compressed data has an unknown mode': 'un canal de ses données compressées a un mode inconnu',
  'its compressed indices are of another kind, or of a later version':
    'ses indices compressés sont d’une autre sorte ou d’une version plus récente',
  'it refers to a triangle before the first': 'il renvoie à un triangle avant le premier',
  'its number of corners is not divisible by 3': 'son nombre de coins n’est pas divisible par 3',
  'its compressed data is cut short': 'ses données compressées sont tronquées',
  'its compressed data is too long': 'ses données compressées sont trop longues',
  'a number in its compressed data is too long': 'un nombre de ses données compressées est trop long',
  'it does not say where its bytes are': 'il ne dit pas où sont ses octets',
  'its elements have an impossible size': 'ses éléments ont une taille impossible',
  'its compression mode is unknown': 'son mode de compression est inconnu',
  'its filter does not fit the size of its elements': 'son filtre ne convient pas à la taille de ses éléments',
  'its compression filter is unknown': 'son filtre de compression est inconnu',
  'it does not say how many elements it has': 'il ne dit pas combien d’éléments il a',
  'an index has more than 16 bits': 'un indice a plus de 16 bits',
  // Motions.
  'the motion cannot be used: {0} does not exist': 'le mouvement est inutilisable : {0} n’existe pas',
  'node {0} does not exist': 'le nœud {0} n’existe pas',
  'a skin does not exist': 'un skin n’existe pas',
  'joint {0} of the skin does not exist': 'l’articulation {0} du skin n’existe pas',
  'arrays have other lengths than the {0} vertices from {1} on':
    'des tableaux n’ont pas la longueur des {0} sommets à partir de {1}',
  'node {0}, the parent of node {1}, does not exist': 'le nœud {0}, parent du nœud {1}, n’existe pas',
  'a node is its own ancestor': 'un nœud est son propre ancêtre',
};
