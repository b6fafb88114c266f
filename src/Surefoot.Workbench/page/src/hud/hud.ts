// Everything on the page that is not the world: panel, sliders, bar, menu, help, messages.

import type { Toggle } from "../net/link";
import type { Listing } from "../net/places";
import type { ServerFrame } from "../net/wire";
import { Cover } from "./cover";
import { CreatureCard } from "./creature";
import { element } from "./elements";
import { Focus } from "./focus";
import { Folds } from "./folds";
import { GoTo } from "./goTo";
import { Help } from "./help";
import { WalkMap } from "./map";
import { NetworkSliders } from "./network";
import { Notice } from "./notice";
import { Panel } from "./panel";
import { Skills } from "./skills";
import { Toasts } from "./toasts";
import { Toggles } from "./toggles";

interface Asks {
  settings: ConstructorParameters<typeof Skills>[0];
  toggle(name: Toggle, on: boolean): void;
  go: ConstructorParameters<typeof GoTo>[0];
  use(): void;
  copyWalk(): void;
  network(): void;
  creature(body: number, wish: number): void;
}

export class Hud {
  readonly panel = new Panel();
  readonly cover = new Cover();
  readonly toasts = new Toasts();
  readonly folds = new Folds();
  readonly map = new WalkMap();
  readonly focus: Focus;
  readonly notice: Notice;
  readonly help: Help;
  readonly goTo: GoTo;
  readonly skills: Skills;
  readonly network: NetworkSliders;
  readonly creature: CreatureCard;
  readonly toggles: Toggles;
  private readonly bar = element("charge");
  private readonly prompt = element("prompt");

  constructor(asks: Asks) {
    const toGame = (): void => this.focus.toGame();
    this.focus = new Focus(element("world"));
    this.skills = new Skills(asks.settings);
    this.network = new NetworkSliders(asks.network);
    this.creature = new CreatureCard(asks.creature, toGame);
    this.toggles = new Toggles(asks.toggle);
    this.notice = new Notice(toGame);
    this.help = new Help(toGame);
    this.goTo = new GoTo((destination) => {
      asks.go(destination);
      toGame();
    });
    element("copy-walk").addEventListener("click", () => asks.copyWalk());
    this.prompt.addEventListener("mousedown", (event) => event.preventDefault());
    this.prompt.addEventListener("click", () => asks.use());
  }

  /** Share of the jump bar that is filled, as shown. */
  get barFilled(): number {
    return this.bar.classList.contains("charging") ? Number(this.bar.getAttribute("aria-valuenow")) / 100 : 0;
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
    this.goTo.offer(places);
  }

  showCharge(charging: boolean, charge: number): void {
    if (this.bar.classList.toggle("charging", charging)) this.bar.removeAttribute("aria-hidden");
    else this.bar.setAttribute("aria-hidden", "true");
    if (!charging) return;
    const percent = Math.round(charge * 100);
    this.bar.setAttribute("aria-valuenow", String(percent));
    this.bar.querySelector("i")!.style.transform = `scaleX(${charge})`;
    this.bar.querySelector("span")!.textContent = `Jump ${percent} %`;
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

  showPanels(shown: boolean): void {
    document.body.classList.toggle("bare", !shown);
  }
}
