// What can be on or off, with a button each that says which.

import { type Toggle, type Toggles as ToggleStates, toggleDefaults } from "../net/link";

export class Toggles {
  private readonly states: ToggleStates = { ...toggleDefaults };

  /** @param onChange what has been switched */
  constructor(private readonly onChange: (name: Toggle, on: boolean) => void) {
    for (const button of buttons()) button.addEventListener("click", () => this.flip(button.dataset.toggle as Toggle));
  }

  get all(): Readonly<ToggleStates> {
    return this.states;
  }

  flip(name: Toggle): void {
    this.set(name, !this.states[name]);
  }

  set(name: Toggle, on: boolean): void {
    if (this.states[name] === on) return;
    this.states[name] = on;
    for (const button of buttons(name)) button.setAttribute("aria-pressed", String(on));
    this.onChange(name, on);
  }
}

function buttons(name?: Toggle): NodeListOf<HTMLElement> {
  return document.querySelectorAll<HTMLElement>(name === undefined ? "button[data-toggle]" : `button[data-toggle="${name}"]`);
}
