// How a page comes into the world: as its link asks the first time, as it was when the connection breaks and is made again.

import { type Link, readLink, shown, type Toggles } from "./link";
import { type Listing, readDestination } from "./places";
import { EventKind, type Network, type OwnPose, type PlayerEvent, PoseFlag, type Settings, type Spot, type Welcome } from "./wire";

/** Why a player is not put where it wants to be, as the server numbers it. */
export const placeRefusals: Record<number, string> = {
  1: "this world has no such cell",
  2: "outside the map",
  3: "in none of the rooms there",
  4: "under the ground",
  5: "too high up",
  6: "something is in the way",
};

interface Asks {
  settings(settings: Settings): void;
  goto(place: number): void;
  placeAt(spot: Spot): void;
}

interface Tells {
  /** The skills that hold from now on. */
  settings(settings: Settings): void;
  /** How bad a network the link wants. */
  network(network: Network): void;
  /** What the link wants to be shown. */
  toggles(toggles: Toggles): void;
  /** A named place was asked for. */
  place(index: number): void;
  /** Parts of the link that are impossible. */
  ignored(parts: readonly string[]): void;
}

export class Entrance {
  private settings: Settings | null = null;
  private offered: Settings | null = null;
  private link: Link | null = null;
  private ignored: string[] = [];
  private wanted: string | null = null;
  private waiting = true;
  private here: Spot | null = null;

  /**
   * @param query of the page's address
   * @param listing the named places, when they have come
   */
  constructor(
    private readonly query: string,
    private readonly listing: Promise<Listing>,
    private readonly asks: Asks,
    private readonly tells: Tells,
  ) {}

  /** The player is not yet where it wants to be. */
  get entering(): boolean {
    return this.waiting;
  }

  /** Skills and place as a link says them: skills when they are not the server's own. */
  get asLink(): Pick<Link, "run" | "jump" | "burden"> & { spot: Spot | null } {
    const { settings, offered } = this;
    const differs = (name: keyof Settings): number | undefined =>
      settings && settings[name] !== offered?.[name] ? settings[name] : undefined;
    return { run: differs("runSkill"), jump: differs("jumpSkill"), burden: differs("burden"), spot: this.here };
  }

  /** A person has moved a slider. */
  chose(settings: Settings): void {
    this.settings = settings;
    this.asks.settings(settings);
  }

  welcome(welcome: Welcome): void {
    const { runSkill, jumpSkill, burden } = welcome;
    this.offered = { runSkill, jumpSkill, burden };
    if (this.link === null) this.open(welcome);
    this.tells.settings(this.settings ?? this.offered);
    if (this.settings) this.asks.settings(this.settings);
    this.waiting = this.wanted !== null || this.here !== null;
    if (this.wanted !== null) void this.goWhereLinked(this.wanted);
    else if (this.here) this.asks.placeAt(this.here);
    else this.tellIgnored();
  }

  pose(pose: OwnPose): void {
    if (this.waiting && pose.teleports === 0) return;
    this.arrive();
    if ((pose.flags & PoseFlag.Nowhere) === 0) this.here = { cell: pose.cell, ...pose.position, yaw: pose.yaw };
  }

  /** True when the event answers what the link asked for. */
  event(event: PlayerEvent): boolean {
    if (event.event !== EventKind.PlaceRefused || !this.waiting) return false;
    this.ignore(placeRefusals[event.code] ?? "nobody can be there");
    this.arrive();
    return true;
  }

  private open(welcome: Welcome): void {
    const { link, ignored } = readLink(this.query, welcome);
    this.link = link;
    this.ignored = ignored;
    this.wanted = link.at ?? null;
    const { run = welcome.runSkill, jump = welcome.jumpSkill, burden = welcome.burden } = link;
    if (link.run !== undefined || link.jump !== undefined || link.burden !== undefined)
      this.settings = { runSkill: run, jumpSkill: jump, burden };
    if (link.net) this.tells.network(link.net);
    this.tells.toggles(link.toggles);
  }

  private async goWhereLinked(wanted: string): Promise<void> {
    const { places } = await this.listing;
    const destination = readDestination(wanted, places);
    if ("error" in destination) {
      this.ignore(destination.error);
      this.arrive();
    } else if ("place" in destination) {
      this.asks.goto(destination.place);
      this.tells.place(destination.place);
    } else {
      this.asks.placeAt(destination.spot);
    }
  }

  private ignore(reason: string): void {
    this.ignored.push(this.wanted === null ? `the place where you were (${reason})` : `${shown("at", this.wanted)} (${reason})`);
  }

  private arrive(): void {
    if (!this.waiting) return;
    this.waiting = false;
    this.wanted = null;
    this.tellIgnored();
  }

  private tellIgnored(): void {
    if (this.ignored.length > 0) this.tells.ignored(this.ignored);
    this.ignored = [];
  }
}
