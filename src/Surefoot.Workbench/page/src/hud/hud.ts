// Everything on the page that is not the world: panel, sliders, bar, menu, help, messages.

import type { Toggle } from "../net/link";
import type { Listing, Place } from "../net/places";
import type { ServerFrame } from "../net/wire";
import { Cover } from "./cover";
import { element } from "./elements";
import { Notice } from "./notice";
import { Panel } from "./panel";
import { Skills } from "./skills";
import { Toasts } from "./toasts";
import { Toggles } from "./toggles";

interface Asks {
  settings: ConstructorParameters<typeof Skills>[0];
  toggle(name: Toggle, on: boolean): void;
  goto(place: number): void;
}

export class Hud {
  readonly panel = new Panel();
  readonly cover = new Cover();
  readonly notice = new Notice();
  readonly toasts = new Toasts();
  readonly skills: Skills;
  readonly toggles: Toggles;
  private readonly bar = element("charge");
  private readonly prompt = element("prompt");
  private readonly places = element<HTMLSelectElement>("places");
  private listed: readonly Place[] = [];

  constructor(private readonly asks: Asks) {
    this.skills = new Skills(asks.settings);
    this.toggles = new Toggles(asks.toggle);
    this.places.addEventListener("change", () => {
      const index = Number(this.places.value);
      this.asks.goto(index);
      this.showHint(index);
      this.places.selectedIndex = 0;
      this.places.blur();
    });
    element("toggle-help").addEventListener("click", () => this.toggleHelp());
  }

  /** Share of the jump bar that is filled, as shown. */
  get barFilled(): number {
    return this.bar.classList.contains("charging") ? Number(this.bar.getAttribute("aria-valuenow")) / 100 : 0;
  }

  /** The places that the menu offers, by the index that the server knows them by. */
  get listedPlaces(): readonly Place[] {
    return this.listed;
  }

  receive(frame: ServerFrame): void {
    switch (frame.kind) {
      case "welcome":
        this.skills.welcome(frame);
        break;
      case "pose":
        this.panel.showPose(frame);
        break;
      case "touches":
        this.panel.showTouches(frame.touches);
        break;
      case "event":
        this.toasts.showEvent(frame);
        break;
    }
  }

  listPlaces({ world, places }: Listing): void {
    element("world-name").textContent = world;
    this.listed = places;
    this.places.replaceChildren(
      new Option("a place…", "", true, true),
      ...places.map((place, index) => new Option(place.name, String(index))),
    );
    this.places.options[0].disabled = true;
  }

  /** What there is to try at a named place. */
  showHint(place: number): void {
    const hint = this.listed[place]?.hint;
    if (hint) this.toasts.show(hint, "hint");
  }

  showCharge(charging: boolean, charge: number): void {
    this.bar.classList.toggle("charging", charging);
    if (!charging) return;
    const percent = Math.round(charge * 100);
    this.bar.setAttribute("aria-valuenow", String(percent));
    (this.bar.firstElementChild as HTMLElement).style.transform = `scaleX(${charge})`;
    this.bar.lastElementChild!.textContent = `Jump ${percent} %`;
  }

  /** What the key for doors would do here. */
  showDoor(door: { name: string; open: boolean } | null): void {
    this.prompt.hidden = door === null;
    const text = door?.open ? "closes the door" : "opens the door";
    if (door && this.prompt.lastElementChild!.textContent !== text) this.prompt.lastElementChild!.textContent = text;
  }

  showTriangles(shown: boolean): void {
    element("legend").hidden = !shown;
  }

  toggleHelp(shown = element("help").hidden): void {
    element("help").hidden = !shown;
    element("toggle-help").setAttribute("aria-pressed", String(shown));
  }

  showPanels(shown: boolean): void {
    document.body.classList.toggle("bare", !shown);
  }
}
