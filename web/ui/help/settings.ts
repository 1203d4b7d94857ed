import { t, type Words } from '../../texts';

/**
 * A line on every setting of the panel, by section and by the name that it has there; `see` is a heading of the documents.
 * Every control of the panel has one: a test looks.
 */
export interface Explanation {
  line: Words;
  see: string;
}

const about = (line: Words, see: string): Explanation => ({ line, see });

/** That of a setting by the name that it is shown by. */
export function explanationOf(section: string, shown: string): Explanation | undefined {
  return Object.entries(SETTINGS[section] ?? {}).find(([name]) => String(t(name)) === shown)?.[1];
}

export const SECTIONS: Record<string, string> = {
  scene: 'page#opening',
  animation: 'page#animations',
  sources: 'page#sources',
  ground: 'page#ground',
  inside: 'page#inside',
  solver: 'page#methods',
  compare: 'page#comparing',
  style: 'gallery',
  measure: 'page#tapes',
  girth: 'page#girth',
  charts: 'page#charts',
  display: 'page#materials',
  numbers: 'page#refinement',
  export: 'page#curves-and-data',
  share: 'page#link',
};

export const SETTINGS: Record<string, Record<string, Explanation>> = {
  scene: {
    'Correct unit': about(
      t(
        'What the lengths in the file are: millimeters, meters, inches, … The numbers stay, and the size of the model changes.',
      ),
      'page#units',
    ),
    'Convert to': about(
      t(
        'The unit of all lengths on the page and in saved files: millimeters, meters, inches, … The size of the model stays.',
      ),
      'page#units',
    ),
  },
  animation: {
    Animation: about(t('Which of the animations of the file is shown.'), 'page#animations'),
    Time: about(t('The moment at which the model stands, or begins to play.'), 'page#animations'),
    Speed: about(t('Times as fast as the file says.'), 'page#animations'),
    Loop: about(t('Begins again at the end.'), 'page#animations'),
    Distance: about(t('Measured in the pose of the file, or anew in each pose that is shown.'), 'page#animations'),
  },
  measure: {
    'Unit of the known length': about(t('The unit of lengths from then on.'), 'page#tapes'),
  },
  girth: {
    'Measure the girth': about(
      t('Shows the curves in which a plane cuts the surface, with their lengths.'),
      'page#girth',
    ),
    Position: about(t('Where the plane is, from one end of the mesh to the other.'), 'page#girth'),
    Turn: about(t('Direction of the plane around the axis that points up.'), 'page#girth'),
    Tilt: about(t('How far the direction of the plane is over the horizon; 90° is level.'), 'page#girth'),
    'Girth file': about(
      t('The curves in millimeters (DXF), in meters (GLB) or in the unit that is shown.'),
      'page#girth',
    ),
  },
  sources: {
    Draw: about(
      t('What a click or a drag on the surface adds: a line, a stroke, a whole boundary or part.'),
      'page#sources',
    ),
  },
  ground: {
    Brush: about(t('A drag on the surface paints instead of orbiting.'), 'page#ground'),
    Tool: about(t('What a stroke or a click does to the ground.'), 'page#ground'),
    Cost: about(t('What a unit of length costs where it is painted; 1 is bare ground.'), 'method#costs-and-walls'),
    Size: about(t('Radius of the brush.'), 'page#ground'),
    'Soft edge': about(t('Share of the brush in which the cost fades out.'), 'page#ground'),
    Slope: about(
      t(
        'Steep ground costs what a hiker takes there, as the mean of uphill and downhill, by Tobler’s hiking function.',
      ),
      'method#costs-and-walls',
    ),
    Height: about(t('What the highest place costs, as a multiple of the lowest.'), 'method#costs-and-walls'),
  },
  inside: {
    Tetrahedra: about(
      t('About how many fill what the surface encloses; more are slower and closer to the surface.'),
      'method#filling',
    ),
    'Cut away': about(t('Shows the inside: half of the mesh is left out, or a wedge of it.'), 'page#inside'),
    Position: about(t('Where the cut is, from one end of the mesh to the other.'), 'page#inside'),
    Turn: about(t('Direction of the cut around the axis that points up.'), 'page#inside'),
    Tilt: about(t('How far the cut leans over the horizon.'), 'page#inside'),
    Opening: about(t('Angle of the wedge.'), 'page#inside'),
    'Whole tetrahedra': about(t('Tetrahedra stay whole at the cut instead of being sliced.'), 'page#inside'),
    'Pull apart': about(t('Moves tetrahedra away from each other, so that all of them are seen.'), 'page#inside'),
    Shells: about(t('From one surface of equal distance to the next.'), 'page#inside'),
    'Arrows inside': about(t('Directions in which the distance grows, on the cut.'), 'page#inside'),
  },
  solver: {
    Method: about(t('How distance is found: at once by windows, smooth by heat, or exact.'), 'page#methods'),
    'Refine to exact': about(
      t('Makes the distance exact, from the sources outward, while nothing moves.'),
      'page#refinement',
    ),
    Path: about(
      t('How the walker goes: down the gradient, pulled straight, or on an exact shortest path.'),
      'method#paths',
    ),
    'Join components': about(
      t('Lets distance and paths cross where parts of a model touch.'),
      'method#components-that-touch',
    ),
    'Time factor m': about(
      t('Heat flows for t = m h², h the mean edge length. Longer is smoother and less accurate.'),
      'method#time-step',
    ),
    Boundary: about(t('What heat does at the rim of an open surface: it is kept in, or lost.'), 'method#boundaries'),
    'Exact region': about(
      t('Radius around the sources in which distances are exact from the start.'),
      'method#exact-region',
    ),
    'Multi-source': about(
      t('The nearest source decides, or heat of all sources is added up as other programs do.'),
      'method#several-sources',
    ),
    Operator: about(
      t('Triangles of the Laplacian: flipped to be Delaunay, as in the file, or with moved vertices.'),
      'method#operator-the-intrinsic-delaunay-triangulation',
    ),
    'Linear solver': about(
      t('Factors once, then milliseconds a source; or no factors, and each source takes longer.'),
      'method#conjugate-gradients',
    ),
    Windows: about(t('Windows kept of each half-edge: more are closer to exact and slower.'), 'method#propagation'),
  },
  compare: {
    Method: about(t('How distance is found right of the divider.'), 'page#comparing'),
    Windows: about(t('Windows that each half-edge keeps there.'), 'page#comparing'),
    'Refine to exact': about(t('Whether the field there is made exact at rest.'), 'page#comparing'),
    'Time factor m': about(t('How long heat flows there: t = m h².'), 'page#comparing'),
    Boundary: about(t('What boundaries of the surface do to heat there.'), 'page#comparing'),
    Operator: about(t('What triangles the Laplacian there is of.'), 'page#comparing'),
    'Linear solver': about(t('How linear systems are solved there.'), 'page#comparing'),
  },
  style: {
    Pattern: about(t('Bands, thin lines, or only the colors of the surface.'), 'gallery'),
    Period: about(t('From one stripe to the next.'), 'gallery'),
    'Stripe width': about(t('Share of the period that a stripe covers.'), 'gallery'),
    Offset: about(t('Moves the stripes away from the sources.'), 'gallery'),
    Sharpness: about(t('Hard or soft edges of stripes.'), 'gallery'),
    Relief: about(t('Stripes stand out of the surface, or are grooves in it.'), 'gallery'),
    Flow: about(t('Stripes run away from the sources, or towards them.'), 'gallery'),
    Surface: about(t('Colors and materials of the style, or those of the file.'), 'page#materials'),
    'Stripes lie': about(t('How stripes cover the materials of a file.'), 'page#materials'),
    Stripes: about(t('Color ramp of the stripes over the distance.'), 'gallery'),
    'Stripe color': about(t('One color for all stripes.'), 'gallery'),
    Color: about(t('Whether stripes change the color.'), 'gallery'),
    Normal: about(t('Whether stripes change the normals, and so stand out in the light.'), 'gallery'),
    Emission: about(t('Whether stripes glow.'), 'gallery'),
    'Specular (separate stripe material)': about(t('Whether stripes have a material of their own.'), 'gallery'),
    'Surface metalness': about(t('Plastic or metal between the stripes.'), 'gallery'),
    'Surface roughness': about(t('Mirror or chalk between the stripes.'), 'gallery'),
    'Surface emission': about(t('Light that comes out of the surface.'), 'gallery'),
    'Stripe metalness': about(t('Plastic or metal on the stripes.'), 'gallery'),
    'Stripe roughness': about(t('Mirror or chalk on the stripes.'), 'gallery'),
    'Stripe emission': about(t('Light that comes out of the stripes.'), 'gallery'),
    Lighting: about(t('What surrounds the model.'), 'page#cameras-and-lights'),
    'Rotate lighting': about(t('Turns the surroundings around the model.'), 'page#cameras-and-lights'),
  },
  display: {
    'Color by': about(
      t('The field in the stripes: distance, heat, or the error of the answer that came first.'),
      'method#heat-does-not-underflow',
    ),
    Legend: about(
      t('What the colors mean, a length to compare with, and where the axes of the file point.'),
      'page#the-stage',
    ),
    'Inactive parts (scenery)': about(t('Parts of the file that nobody walks on.'), 'page#models-of-several-parts'),
    'Mesh edges': about(t('The triangles of the file.'), 'method#operator-the-intrinsic-delaunay-triangulation'),
    'Boundary edges': about(t('Edges with a triangle on one side only.'), 'method#boundaries'),
    Contacts: about(t('Where distance crosses from one component to another.'), 'method#components-that-touch'),
    'Operator edges': about(
      t('The triangles that the Laplacian is built on.'),
      'method#operator-the-intrinsic-delaunay-triangulation',
    ),
    Isolines: about(
      t('Curves on which the distance is the same, at the edges of the stripes.'),
      'page#curves-and-data',
    ),
    'No arrows': about(t('No directions are drawn.'), 'method#directions'),
    'Heat gradient': about(t('Arrows along the unit gradient of heat, towards the sources.'), 'method#directions'),
    'Distance gradient': about(t('Arrows along the gradient of the distance.'), 'method#directions'),
    Crowd: about(t('Walkers that all take the shortest way to a source.'), 'method#crowds'),
    Up: about(t('The axis of the file that is drawn upward.'), 'page#up'),
    'Cameras of the file': about(t('Looks through a camera that the file has.'), 'page#cameras-and-lights'),
    'Lights of the file': about(t('Lights of the file in the place of those of the style.'), 'page#cameras-and-lights'),
  },
  export: {
    'Isolines at': about(
      t('A spacing, or values with commas between them; the period of the stripes where it is empty.'),
      'page#curves-and-data',
    ),
    File: about(t('Curves, or the surface cut along them into strips, also unrolled.'), 'page#curves-and-data'),
    Distances: about(t('A number a vertex, as a table or with the mesh.'), 'page#curves-and-data'),
    Path: about(t('The places that the walker comes through.'), 'page#curves-and-data'),
    Tracks: about(t('The ways of the crowd, one for each walker.'), 'page#curves-and-data'),
    'Reproduce by': about(t('The lines that give the same numbers outside of the page.'), 'page#curves-and-data'),
  },
  share: {
    'Image size': about(t('Pixels of a saved image, as a multiple of the window.'), 'page#images-and-videos'),
    Background: about(t('Saves what is behind the model too; else it is transparent.'), 'page#images-and-videos'),
    Video: about(t('What is recorded: a turn around the model, or the walk.'), 'page#images-and-videos'),
  },
};
