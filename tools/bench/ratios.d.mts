export function judge(ratios: readonly number[]): {
  ratio: number;
  interval: [number, number];
  isCertain: boolean;
  verdict: 'same' | 'slower' | 'maybe same' | 'maybe slower';
};
