// The named places of the world, fetched once.

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
