import { t, type Words } from '../../texts';

export interface Explanation {
  line: Words;
  /** A heading of the documents. */
  see: string;
}

const about = (line: Words, see: string): Explanation => ({ line, see });

/** That of a setting by the name that it is shown by. */
export function explanationOf(section: string, shown: string): Explanation | undefined {
  const found = Object.entries(SETTINGS[section] ?? {}).find(([name]) => String(t(name)) === shown)?.[1];
  if (found === undefined || (typeof found === 'object' && 'see' in found)) return found;
  return about(found, SECTIONS[section] ?? '');
}

/** Of each section a heading of the documents. */
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
  loops: 'page#loops',
  charts: 'page#charts',
  display: 'page#materials',
  decals: 'page#images-on-the-surface',
  numbers: 'page#refinement',
  export: 'page#curves-and-data',
  share: 'page#link',
};

/**
 * A line on every setting of the panel, by section and by the name that it has there; with a heading where that is not the section's.
 * Every control of the panel has one: a test looks.
 */
export const SETTINGS: Record<string, Record<string, Words | Explanation>> = {
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
    Animation: t('Which of the animations of the file is shown.'),
    Time: t('The moment at which the model stands, or begins to play.'),
    Speed: t('Times as fast as the file says.'),
    Loop: t('Begins again at the end.'),
    Distance: t('Measured in the pose of the file, or anew in each pose that is shown.'),
  },
  measure: {
    'Unit of the known length': t('The unit of lengths from then on.'),
  },
  decals: {
    Image: t('An image of the page that is laid on the model: along the surface, as a sticker.'),
    Size: t('Half of the longer side of the image, along the surface.'),
    Angle: t('By how much the image is turned counterclockwise; at 0° it stands upright.'),
  },
  loops: {
    'Loops around handles': t('Closed geodesics around each handle and through it, with their lengths.'),
    Loops: t('The loops as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.'),
    'Loop through the sources': t('A closed curve of shortest paths through the sources in their order.'),
    Loop: t('The loop as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.'),
    'Bézier curve of the sources': t(
      'A smooth curve that the sources control, by shortest paths instead of straight lines.',
    ),
    Curve: t('The Bézier curve as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.'),
  },
  girth: {
    'Measure the girth': t('Shows the curves in which a plane cuts the surface, with their lengths.'),
    Position: t('Where the plane is, from one end of the mesh to the other.'),
    Turn: t('Direction of the plane around the axis that points up.'),
    Tilt: t('How far the direction of the plane is over the horizon; 90° is level.'),
    'Girth file': t('The curves in millimeters (DXF), in meters (GLB) or in the unit that is shown.'),
  },
  sources: {
    Draw: t('What a click or a drag on the surface adds: a line, a stroke, a whole boundary or part.'),
    Borders: t('Curves where another source becomes the nearest one.'),
    'Distance from curves': about(
      t('Exact distance from all of each curve, with a sign, in two colors, and files of its offsets.'),
      'page#distance-from-curves',
    ),
    Offsets: t('The curve and its offsets as DXF, OBJ, CSV or GLB, or as seen, as SVG or PDF.'),
    Cells: about(
      t(
        'Colors by the source that is nearest, by exact distances, with borders between them, areas, and files of the borders.',
      ),
      'page#cells',
    ),
  },
  ground: {
    Brush: t('A drag on the surface paints instead of orbiting.'),
    Tool: t('What a stroke or a click does to the ground.'),
    Cost: about(t('What a unit of length costs where it is painted; 1 is bare ground.'), 'method#costs-and-walls'),
    Size: t('Radius of the brush.'),
    'Soft edge': t('Share of the brush in which the cost fades out.'),
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
    'Cut away': t('Shows the inside: half of the mesh is left out, or a wedge of it.'),
    Position: t('Where the cut is, from one end of the mesh to the other.'),
    Turn: t('Direction of the cut around the axis that points up.'),
    Tilt: t('How far the cut leans over the horizon.'),
    Opening: t('Angle of the wedge.'),
    'Whole tetrahedra': t('Tetrahedra stay whole at the cut instead of being sliced.'),
    'Pull apart': t('Moves tetrahedra away from each other, so that all of them are seen.'),
    Shells: t('From one surface of equal distance to the next.'),
    'Arrows inside': t('Directions in which the distance grows, on the cut.'),
  },
  solver: {
    Method: t('How distance is found: at once by windows, smooth by heat, or exact.'),
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
    Method: t('How distance is found right of the divider.'),
    Windows: t('Windows that each half-edge keeps there.'),
    'Refine to exact': t('Whether the field there is made exact at rest.'),
    'Time factor m': t('How long heat flows there: t = m h².'),
    Boundary: t('What boundaries of the surface do to heat there.'),
    Operator: t('What triangles the Laplacian there is of.'),
    'Linear solver': t('How linear systems are solved there.'),
  },
  style: {
    Pattern: t('Bands, thin lines, or only the colors of the surface.'),
    Period: t('From one stripe to the next.'),
    'Stripe width': t('Share of the period that a stripe covers.'),
    Offset: t('Moves the stripes away from the sources.'),
    Sharpness: t('Hard or soft edges of stripes.'),
    Relief: t('Stripes stand out of the surface, or are grooves in it.'),
    Flow: t('Stripes run away from the sources, or towards them.'),
    Surface: about(t('Colors and materials of the style, or those of the file.'), 'page#materials'),
    'Stripes lie': about(t('How stripes cover the materials of a file.'), 'page#materials'),
    Stripes: t('Color ramp of the stripes over the distance.'),
    'Stripe color': t('One color for all stripes.'),
    Color: t('Whether stripes change the color.'),
    Normal: t('Whether stripes change the normals, and so stand out in the light.'),
    Emission: t('Whether stripes glow.'),
    'Specular (separate stripe material)': t('Whether stripes have a material of their own.'),
    'Surface metalness': t('Plastic or metal between the stripes.'),
    'Surface roughness': t('Mirror or chalk between the stripes.'),
    'Surface emission': t('Light that comes out of the surface.'),
    'Stripe metalness': t('Plastic or metal on the stripes.'),
    'Stripe roughness': t('Mirror or chalk on the stripes.'),
    'Stripe emission': t('Light that comes out of the stripes.'),
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
    'Surface in the place of points': about(
      t('The triangles that join the points of a file without faces.'),
      'page#points',
    ),
    'Mesh edges': about(
      t('The triangles and polygons of the file.'),
      'method#operator-the-intrinsic-delaunay-triangulation',
    ),
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
    'Carried from the sources': about(
      t('Arrows of a direction at the sources that is carried along shortest paths, which keeps its angle with them.'),
      'page#carried-directions',
    ),
    Heading: about(
      t('That direction at the sources: degrees counterclockwise from upright, seen from outside.'),
      'page#carried-directions',
    ),
    Crowd: about(t('Walkers that all take the shortest way to a source.'), 'method#crowds'),
    Up: about(t('The axis of the file that is drawn upward.'), 'page#up'),
    'Cameras of the file': about(t('Looks through a camera that the file has.'), 'page#cameras-and-lights'),
    'Lights of the file': about(t('Lights of the file in the place of those of the style.'), 'page#cameras-and-lights'),
  },
  export: {
    'Isolines at': t('A spacing, or values with commas between them; the period of the stripes where it is empty.'),
    File: t('Curves, or the surface cut along them into strips, also unrolled.'),
    Distances: t('A number a vertex, as a table or with the mesh.'),
    Path: t('The places that the walker comes through.'),
    Tracks: t('The ways of the crowd, one for each walker.'),
    'Reproduce by': t('The lines that give the same numbers outside of the page.'),
  },
  share: {
    'Image size': about(t('Pixels of a saved image, as a multiple of the window.'), 'page#images-and-videos'),
    Background: about(t('Saves what is behind the model too; else it is transparent.'), 'page#images-and-videos'),
    Video: about(t('What is recorded: a turn around the model, or the walk.'), 'page#images-and-videos'),
  },
};
