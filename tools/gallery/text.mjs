// docs/gallery.md: each figure with its images, the links of their scenes, and the fragments of these links to copy.

const ADDRESS = 'http://localhost:5173/';

const INTRODUCTION = [
  '# Gallery',
  '',
  'Scenes drawn by Heatwalk; many repeat figures of the INF555 report by He and Hung. `npm run gallery` makes this document.',
  '',
  `Start the page with \`npm start\`. Then the caption below each image opens its scene, at ${ADDRESS}. If \`npm start\``,
  'prints another address, append the fragment of the scene to it: the fragments are listed below the images.',
];
const COLUMNS = 3;

/** The text for the figures, each with `panels`: `{ caption, file, fragment }`, the file in docs/gallery/. */
export function galleryText(figures) {
  return [...INTRODUCTION, ...figures.flatMap(figureText), ''].join('\n');
}

function figureText({ title, text, panels }) {
  const lines = ['', `## ${title}`, '', text];
  for (let first = 0; first < panels.length; first += COLUMNS) {
    const row = panels.slice(first, first + COLUMNS);
    const cells = (cell) => `| ${row.map(cell).join(' | ')} |`;
    lines.push(
      '',
      cells(({ caption, file }) => `![${caption}](gallery/${file})`),
      `|${':---:|'.repeat(row.length)}`,
      cells(({ caption, fragment }) => `[${caption}](${ADDRESS}${fragment})`),
    );
  }
  const fragments = panels.map(({ caption, fragment }) => `- ${caption}: \`${fragment}\``);
  return [...lines, '', '<details>', '<summary>Fragments</summary>', '', ...fragments, '', '</details>'];
}
