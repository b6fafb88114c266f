// The address of the page: what it says of skills, place and what is shown. Whoever opens it finds the same.

import type { Network } from "./wire";

/** What can be on or off, and what it is at first. */
export const toggleDefaults = { triangles: false, shapes: false, mouse: true, panels: true, truth: false } as const;

export type Toggle = keyof typeof toggleDefaults;

export type Toggles = Record<Toggle, boolean>;

/** What a link asks for. */
export interface Link {
  /** Skills and burden that differ from the server's own. */
  run?: number;
  jump?: number;
  burden?: number;
  /** A place's name, or a cell and metres. */
  at?: string;
  /** How bad the network is over which others are heard of, when it is not perfect. */
  net?: Network;
  toggles: Toggles;
}

/** The worst network: milliseconds, milliseconds, percent. */
export const worst: Network = { delay: 1000, jitter: 1000, loss: 50 };

/** The highest that a server allows. */
export interface Limits {
  maxSkill: number;
  maxBurden: number;
}

const longestShown = 60;

/** Reads an address's query. What is impossible is left out of the link, and said: one reason each. */
export function readLink(query: string, limits: Limits): { link: Link; ignored: string[] } {
  const link: Link = { toggles: { ...toggleDefaults } };
  const ignored: string[] = [];
  const said = new Map<string, string>();
  const again = (key: string, part: string): void => {
    const before = said.get(key);
    if (before !== undefined && before !== part) ignored.push(`${before} (said otherwise later)`);
    said.set(key, part);
  };
  const number = (name: "run" | "jump" | "burden", text: string, most: number): void => {
    if (/^\d{1,9}$/.test(text) && Number(text) <= most) {
      link[name] = Number(text);
      again(name, shown(name, text));
    } else ignored.push(`${shown(name, text)} (a whole number from 0 to ${most})`);
  };
  const network = (text: string): void => {
    const [delay, jitter, loss, ...more] = text.split(",").map((part) => (/^\d{1,9}$/.test(part) ? Number(part) : Number.NaN));
    if (more.length === 0 && delay <= worst.delay && jitter <= worst.jitter && loss <= worst.loss) {
      link.net = { delay, jitter, loss };
      again("net", shown("net", text));
    } else ignored.push(`${shown("net", text)} (delay, jitter, loss: to ${worst.delay} ms, ${worst.jitter} ms, ${worst.loss} %)`);
  };
  const toggle = (text: string, on: boolean): void => {
    for (const name of text.split(",")) {
      if (Object.hasOwn(toggleDefaults, name)) {
        link.toggles[name as Toggle] = on;
        again(`toggle ${name}`, shown(on ? "on" : "off", name));
      } else ignored.push(`${shown(on ? "on" : "off", name)} (${Object.keys(toggleDefaults).join(", ")})`);
    }
  };
  for (const [name, text] of new URLSearchParams(query)) {
    if (name === "run" || name === "jump") number(name, text, limits.maxSkill);
    else if (name === "burden") number(name, text, limits.maxBurden);
    else if (name === "net") network(text);
    else if (name === "on") toggle(text, true);
    else if (name === "off") toggle(text, false);
    else if (name === "at") {
      link.at = text;
      again(name, shown(name, text));
    } else ignored.push(`${shown(name, text)} (run, jump, burden, at, net, on, off)`);
  }
  return { link, ignored };
}

/** The query that says this, empty when there is nothing to say. */
export function writeLink(link: Link): string {
  const parts: string[] = [];
  for (const name of ["run", "jump", "burden"] as const) if (link[name] !== undefined) parts.push(`${name}=${link[name]}`);
  if (link.at !== undefined) parts.push(`at=${link.at.replace(/[^\w,.-]/g, encodeURIComponent)}`);
  const { delay, jitter, loss } = link.net ?? { delay: 0, jitter: 0, loss: 0 };
  if (delay + jitter + loss > 0) parts.push(`net=${delay},${jitter},${loss}`);
  const changed = (Object.keys(toggleDefaults) as Toggle[]).filter((name) => link.toggles[name] !== toggleDefaults[name]);
  for (const [key, on] of [
    ["on", true],
    ["off", false],
  ] as const) {
    const names = changed.filter((name) => link.toggles[name] === on);
    if (names.length > 0) parts.push(`${key}=${names.join(",")}`);
  }
  return parts.length > 0 ? `?${parts.join("&")}` : "";
}

/** A part of a link as it is shown to a person, whatever is in it. */
export function shown(name: string, text: string): string {
  const whole = text === "" ? name : `${name}=${text}`;
  return whole.length > longestShown ? `${whole.slice(0, longestShown)}…` : whole;
}
