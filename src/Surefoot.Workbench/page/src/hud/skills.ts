// The sliders: run skill, jump skill, burden.

import type { Settings, Welcome } from "../net/wire";
import { element } from "./elements";

export class Skills {
  private readonly run = element<HTMLInputElement>("run-skill");
  private readonly jump = element<HTMLInputElement>("jump-skill");
  private readonly burden = element<HTMLInputElement>("burden");
  private capacity = 1;

  /** @param onChange the person has moved a slider */
  constructor(onChange: (settings: Settings) => void) {
    for (const slider of [this.run, this.jump, this.burden]) {
      slider.addEventListener("input", () => {
        this.showNumbers();
        onChange(this.settings);
      });
    }
  }

  /** What the sliders stand at. */
  get settings(): Settings {
    return { runSkill: Number(this.run.value), jumpSkill: Number(this.jump.value), burden: Number(this.burden.value) };
  }

  /** How far the sliders go. */
  welcome(welcome: Welcome): void {
    this.capacity = Math.max(1, welcome.burdenCapacity);
    this.run.max = this.jump.max = String(welcome.maxSkill);
    this.burden.max = String(welcome.maxBurden);
  }

  show(settings: Settings): void {
    this.run.value = String(settings.runSkill);
    this.jump.value = String(settings.jumpSkill);
    this.burden.value = String(settings.burden);
    this.showNumbers();
  }

  private showNumbers(): void {
    output(this.run, this.run.value);
    output(this.jump, this.jump.value);
    const share = Math.round((100 * Number(this.burden.value)) / this.capacity);
    output(this.burden, `${this.burden.value} (${share} %)`);
    this.burden.setAttribute("aria-valuetext", `${this.burden.value}, ${share} percent of what can be carried`);
  }
}

/** The number beside a slider. */
export function output(slider: HTMLInputElement, text: string): void {
  document.querySelector<HTMLOutputElement>(`output[for="${slider.id}"]`)!.value = text;
}
