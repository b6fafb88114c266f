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
