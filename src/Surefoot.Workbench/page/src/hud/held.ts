// What is held of the keys of movement, by all that can hold them.

export class Held {
  private readonly sources = new Map<string, number>();
  private bits = 0;

  /** @param onChange the bits held, whenever they change */
  constructor(private readonly onChange: (bits: number) => void) {}

  /** What one source holds from now on. */
  set(source: string, bits: number): void {
    this.sources.set(source, bits);
    let all = 0;
    for (const one of this.sources.values()) all |= one;
    if (all === this.bits) return;
    this.bits = all;
    this.onChange(all);
  }

  /** Nothing is held any more, without a word: whoever calls says so. */
  clear(): void {
    this.sources.clear();
    this.bits = 0;
  }
}
