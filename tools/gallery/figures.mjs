// What the gallery shows: each figure a title, a text, and panels, each with its caption and the link of its scene.
// A panel with `line` has a source at every place of the model under these points of the window (shares of it).

const plain = 'op=plain&near=0&refine=0&w=none';

const aside = 'cam=2.1,0.3,3.6,0,0,0';
const leg = 'cam=-0.7,0.15,1.5,0.1,-0.2,0.1';

/** Points along a bent line, both ends included. */
const bent = (corners, steps) => [
  ...corners.slice(1).flatMap(([x, y], i) => {
    const [x0, y0] = corners[i];
    return Array.from({ length: steps }, (_, k) => [x0 + (k / steps) * (x - x0), y0 + (k / steps) * (y - y0)]);
  }),
  ...corners.slice(-1),
];
const LINE = bent([[0.27, 0.47], [0.6, 0.66], [0.66, 0.3]], 9); // prettier-ignore

export const FIGURES = [
  {
    name: 'family',
    title: 'The family',
    text: 'One solver, one renderer, a look each: what the stripes do to colour, relief, light and gloss is in the link.',
    panels: [
      ['Sphere', 'm=icosphere&w=none'],
      ['Horse', 'm=horse&w=none'],
      ['Ring', 'm=ring&w=none'],
      ['Triceratops', 'm=triceratops&w=none'],
      ['Skull on its stand', 'm=skull&w=none'],
      ['Cow', 'm=animal&w=none'],
      ['Tetrahedral frame', 'm=high_genus&w=none'],
      ['Maze with walls', 'm=maze&w=none'],
      ['Dragon (Stanford Computer Graphics Laboratory)', 'm=dragon&w=none'],
    ],
  },
  {
    name: 'solvers',
    title: 'Conjugate gradients and Cholesky',
    text: 'At t = h² conjugate gradients stop at a residual that far heat lies below: its gradient points anywhere. Cholesky factors are accurate entry by entry. (Left to themselves, conjugate gradients get a longer time step here.)',
    panels: [
      ['Conjugate gradients, t = h²', `m=icosphere&solver=cg&t=1&${plain}&${aside}`],
      ['Cholesky, t = h²', `m=icosphere&t=1&${plain}&${aside}`],
    ],
  },
  {
    name: 'gradients',
    title: 'Gradient of heat and gradient of distance',
    text: 'Heat flows along the unit field; the distance whose gradient comes nearest to that field is smoother than the field itself.',
    panels: [
      ['Heat', 'm=high_genus&w=none&show=heat&near=0&refine=0&cam=0.6,0.35,1.5,-0.4,-0.2,0.3'],
      ['Distance', 'm=high_genus&w=none&show=distance&near=0&refine=0&cam=0.6,0.35,1.5,-0.4,-0.2,0.3'],
    ],
  },
  {
    name: 'time',
    title: 'The time step',
    text: 't = m h². A short time follows the edges of the mesh, a long one rounds the distance off.',
    panels: [
      ['m = 0.1', `m=triceratops&t=0.1&${plain}&${leg}`],
      ['m = 1', `m=triceratops&t=1&${plain}&${leg}`],
      ['m = 1000', `m=triceratops&t=1000&${plain}&${leg}`],
    ],
  },
  {
    name: 'boundary',
    title: 'Boundary conditions',
    text: 'At a long time (m = 1000) heat that cannot leave (Neumann) bends the stripes at right angles to the boundary, heat that is taken away there (Dirichlet) along it; the mean of both bends them little.',
    panels: [
      ['Neumann', `m=hemisphere&b=neumann&t=1000&${plain}`],
      ['Dirichlet', `m=hemisphere&b=dirichlet&t=1000&${plain}`],
      ['Average', `m=hemisphere&b=average&t=1000&${plain}`],
    ],
  },
  {
    name: 'sources',
    title: 'Many sources',
    text: 'Adding up the heat of several sources leaves none of them at zero. Holding each at zero does, without factoring again.',
    panels: [
      ['Superposed', `m=icosphere&multi=superposed&near=0&refine=0&w=none&cam=0.6,0.35,3.6,0,0,0`, LINE],
      ['Exact', `m=icosphere&w=none&cam=0.6,0.35,3.6,0,0,0`, LINE],
    ],
  },
  {
    name: 'navigation',
    title: 'The way home',
    text: 'The walker takes the shortest way to its source.',
    panels: [
      ['On the horse', 'm=horse'],
      ['A crowd on the cow', 'm=animal&w=none&crowd=1200'],
    ],
  },
  {
    name: 'paths',
    title: 'Smoothed paths',
    text: 'Down the distance of a short time the way grazes the corners; down that of a long time it keeps away from the walls.',
    panels: [
      ['m = 1', 'm=maze&way=descent&t=1&near=0&refine=0'],
      ['m = 1000', 'm=maze&way=descent&t=1000&near=0&refine=0'],
    ],
  },
  {
    name: 'looking-closer',
    title: 'Looking closer',
    text: 'What the page shows beside the distance.',
    panels: [
      ['Error of the heat method against exact distances', 'm=bunny&paint=error&look=scientific&w=none'],
      ['Edges of the intrinsic Delaunay triangulation', 'm=teapot&look=contour&show=operator,boundary&w=none'],
      ['Glowing stripes at night', 'm=torus&w=none'],
    ],
  },
];
