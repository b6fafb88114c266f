// The named places of the world, and what a person may write to go somewhere.

import { looksLikeSpot, parseSpot } from "./spot";
import type { Spot } from "./wire";

export interface Place {
  name: string;
  cell: number;
  x: number;
  y: number;
  z: number;
  yaw: number;
  hint: string | null;
  /** Where to look from at first: radians around the player, counter-clockwise from behind. */
  lookFrom: number;
}

export interface Listing {
  world: string;
  places: Place[];
}

/** A named place by its index, a spot, or why the words are neither. */
export type Destination = { place: number } | { spot: Spot } | { error: string };

const retryAfter = 1000;

/** Asks until the server answers. */
export async function fetchPlaces(): Promise<Listing> {
  for (;;) {
    try {
      const answer = await fetch("/places.json");
      return (await answer.json()) as Listing;
    } catch {
      await new Promise((resolve) => setTimeout(resolve, retryAfter));
    }
  }
}

/** Reads a place's name, in any case, or a cell and metres. */
export function readDestination(text: string, places: readonly Place[]): Destination {
  const wanted = text.trim().toLowerCase();
  const place = places.findIndex(({ name }) => name.toLowerCase() === wanted);
  if (place >= 0) return { place };
  return looksLikeSpot(text) ? parseSpot(text) : { error: "there is no place of this name" };
}

/** The places in which all the words occur, by index, those first that are named so and begin so; all of them without a word. */
export function searchPlaces(text: string, places: readonly Place[]): number[] {
  const wanted = text.trim().toLowerCase().split(/\s+/).join(" ");
  const words = wanted.split(" ");
  const ranks: ((title: string, all: string) => boolean)[] = [
    (title) => title === wanted,
    (title) => title.replace(/^(the|a|in the|at the) /, "").startsWith(wanted) || title.startsWith(wanted),
    (title) => words.every((word) => ` ${title}`.includes(` ${word}`)),
    (title) => words.every((word) => title.includes(word)),
    (_, all) => words.every((word) => ` ${all}`.includes(` ${word}`)),
    (_, all) => words.every((word) => all.includes(word)),
  ];
  const ranked = places.map(({ name, hint }, index) => {
    const title = name.toLowerCase();
    return { index, rank: ranks.findIndex((fits) => fits(title, `${title} ${hint?.toLowerCase() ?? ""}`)) };
  });
  const found = ranked.filter(({ rank }) => rank >= 0);
  return found.sort((a, b) => a.rank - b.rank || a.index - b.index).map(({ index }) => index);
}
