// Keys that do something once.

interface Acts {
  triangles(): void;
  shapes(): void;
  use(): void;
  autoRun(): void;
  mouse(): void;
  recenter(): void;
  panels(): void;
  help(shown?: boolean): void;
}

/** What each key does, by its code. */
export function commands(acts: Acts): ReadonlyMap<string, () => void> {
  const help = (): void => acts.help();
  return new Map([
    ["KeyT", acts.triangles],
    ["KeyV", acts.shapes],
    ["KeyF", acts.use],
    ["KeyR", acts.autoRun],
    ["KeyM", acts.mouse],
    ["KeyC", acts.recenter],
    ["KeyP", acts.panels],
    ["KeyH", help],
    ["Slash", help],
    ["Escape", () => acts.help(false)],
  ]);
}
