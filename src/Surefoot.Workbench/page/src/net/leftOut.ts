// What the server's world does without because it cannot be read.

export interface LeftOut {
  total: number;
  /** One sentence for each kind of thing, the first ones only. */
  lines: string[];
}

/** What is left out by now; nothing when the server does not answer. */
export async function fetchLeftOut(): Promise<LeftOut> {
  try {
    const answer = await fetch("/left-out.json");
    return (await answer.json()) as LeftOut;
  } catch {
    return { total: 0, lines: [] };
  }
}
