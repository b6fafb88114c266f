// Some people get ill from pictures that sway: their system says so, and what moves for the eye alone stands still.

const wish = matchMedia("(prefers-reduced-motion: reduce)");

export function isCalm(): boolean {
  return wish.matches;
}
