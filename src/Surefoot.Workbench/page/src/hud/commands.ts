// Keys that do something once.

import type { Toggle } from "../net/link";

interface Acts {
  toggle(name: Toggle): void;
  use(): void;
  autoRun(): void;
  recenter(): void;
  goTo(): void;
  copyWalk(): void;
  creature(): void;
  help(): void;
  closeHelp(): void;
}

/** What each key does, by its code. */
export function commands(acts: Acts): ReadonlyMap<string, () => void> {
  return new Map([
    ["KeyT", () => acts.toggle("triangles")],
    ["KeyV", () => acts.toggle("shapes")],
    ["KeyF", acts.use],
    ["KeyR", acts.autoRun],
    ["KeyM", () => acts.toggle("mouse")],
    ["KeyC", acts.recenter],
    ["KeyP", () => acts.toggle("panels")],
    ["KeyG", acts.goTo],
    ["KeyK", acts.copyWalk],
    ["KeyX", acts.creature],
    ["KeyB", () => acts.toggle("truth")],
    ["KeyH", acts.help],
    ["Slash", acts.help],
    ["Escape", acts.closeHelp],
  ]);
}
