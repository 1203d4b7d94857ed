// The figures of the gallery: each has a title, a text and panels, and each panel a caption and the link of its scene.
// A panel with a third entry has a source at every point of the model under these points of the window (shares of it).
// Where a figure is `whole`, its panels are the window with the legend, else they are cut to the model.

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
    title: 'Presets',
    text: 'Each preset has its own style: what the stripes do to color, normal, emission and specular reflection.',
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
    text: 'At t = h² the heat far from the source is below the residual at which conjugate gradients stop, so its gradient is noise. Cholesky factors are accurate in every entry. (By default, conjugate gradients get a longer time step here.)',
    panels: [
      ['Conjugate gradients, t = h²', `m=icosphere&solver=cg&t=1&${plain}&${aside}`],
      ['Cholesky, t = h²', `m=icosphere&t=1&${plain}&${aside}`],
    ],
  },
  {
    name: 'gradients',
    title: 'Gradient of heat and gradient of distance',
    text: 'The unit field along the gradient of heat, and the gradient of the distance, which is fitted to that field and smoother.',
    panels: [
      ['Heat', 'm=high_genus&w=none&show=heat&near=0&refine=0&cam=0.6,0.35,1.5,-0.4,-0.2,0.3'],
      ['Distance', 'm=high_genus&w=none&show=distance&near=0&refine=0&cam=0.6,0.35,1.5,-0.4,-0.2,0.3'],
    ],
  },
  {
    name: 'time',
    title: 'Time step',
    text: 't = m h². After a short time heat follows the edges of the mesh; a long time smooths the distance.',
    panels: [
      ['m = 0.1', `m=triceratops&t=0.1&${plain}&${leg}`],
      ['m = 1', `m=triceratops&t=1&${plain}&${leg}`],
      ['m = 1000', `m=triceratops&t=1000&${plain}&${leg}`],
    ],
  },
  {
    name: 'boundary',
    title: 'Boundary conditions',
    text: 'After a long time (m = 1000), an insulated boundary (Neumann) bends the stripes so that they meet it at right angles, and a cold boundary (Dirichlet) bends them parallel to it. The average of both bends them little.',
    panels: [
      ['Neumann', `m=hemisphere&b=neumann&t=1000&${plain}`],
      ['Dirichlet', `m=hemisphere&b=dirichlet&t=1000&${plain}`],
      ['Average', `m=hemisphere&b=average&t=1000&${plain}`],
    ],
  },
  {
    name: 'sources',
    title: 'Many sources',
    text: 'If the heat of several sources is summed, no source has distance 0. With sources as constraints each has, without factoring again.',
    panels: [
      ['Summed', `m=icosphere&multi=summed&near=0&refine=0&w=none&cam=0.6,0.35,3.6,0,0,0`, LINE],
      ['Exact', `m=icosphere&w=none&cam=0.6,0.35,3.6,0,0,0`, LINE],
    ],
  },
  {
    name: 'navigation',
    title: 'Shortest paths',
    text: 'Walkers take the shortest path to the source.',
    panels: [
      ['On the horse', 'm=horse'],
      ['A crowd on the cow', 'm=animal&w=none&crowd=1200'],
    ],
  },
  {
    name: 'paths',
    title: 'Smoothed paths',
    text: 'Descent on the distance of a short time passes close to the corners; on that of a long time it keeps away from the walls.',
    panels: [
      ['m = 1', 'm=maze&way=descent&t=1&near=0&refine=0'],
      ['m = 1000', 'm=maze&way=descent&t=1000&near=0&refine=0'],
    ],
  },
  {
    name: 'measuring',
    title: 'Measuring',
    text: 'A tape is a shortest path with its length. A girth is the longest closed curve in which a plane, moved by hand, cuts the surface.',
    whole: true,
    panels: [
      ['Tapes on the horse', 'm=horse&w=none&unit=m&tape=1000,4000;200,3000'],
      ['Girth of the skull', 'm=skull&w=none&unit=cm&girth=0,90,0.2'],
    ],
  },
  {
    name: 'ground',
    title: 'Ground of different difficulty, and walls',
    text: 'Distance and paths where mud costs four times as much as grass and a road half; around walls, through a gate.',
    panels: [
      ['Mud and a road on hills', 'm=hike'],
      ['A village with walls', 'm=village'],
    ],
  },
  {
    name: 'on-the-surface',
    title: 'What distance leads to',
    text: 'An image laid on a cow by the log map; a broken curve, and what is inside of it; what is nearest to each of fourteen sources; closed geodesics around handles.',
    panels: [
      ['Images on the surface', 'm=images&w=none&s=none'],
      ['Distance from a broken curve', 'm=broken'],
      ['Cells', 'm=cells&w=none'],
      ['Loops around handles', 'm=high_genus&w=none&show=loops'],
    ],
  },
  {
    name: 'inside',
    title: 'Inside',
    text: 'Closed surfaces filled with tetrahedra, cut open: distance through the inside, with shells of equal distance, and tetrahedra pulled apart.',
    panels: [
      ['The teapot, filled', 'm=inside'],
      ['A bent pipe', 'm=pipe'],
      ['A cave between two spheres', 'm=cave'],
      ['Shells in the pipe, and a crowd', 'm=pipe&cut=none&spacing=0.08&crowd=80&look=citrus&w=none'],
      ['Tetrahedra pulled apart', 'm=cave&cut=plane&gap=0.6&w=none'],
      ['Shells before the cut', 'm=cave&cut=plane&turn=25&spacing=0.1&look=jade'],
    ],
  },
  {
    name: 'looking-closer',
    title: 'Other displays',
    text: 'Error, edges of the operator, and emission.',
    panels: [
      ['Error of the heat method against exact distances', 'm=bunny&paint=error&look=scientific&w=none'],
      ['Edges of the intrinsic Delaunay triangulation', 'm=teapot&look=contour&show=operator,boundary&w=none'],
      ['Emission in the night lighting', 'm=torus&w=none'],
    ],
  },
];
