// docs/gallery.md: each figure with its images and the links of their scenes.

const ADDRESS = 'http://localhost:5173/';

const INTRODUCTION = [
  '# Gallery',
  '',
  'Scenes drawn by Heatwalk; many repeat figures of the INF555 report by He and Hung. `npm run gallery` makes this document.',
  '',
  `The caption below each image opens its scene on a page that \`npm start\` serves at ${ADDRESS}, or after the address that it prints.`,
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
  return lines;
}
