// The sliders of the network over which others are heard of: delay, jitter, loss.

import { worst } from "../net/link";
import type { Network } from "../net/wire";
import { element } from "./elements";
import { output } from "./skills";

export class NetworkSliders {
  private readonly delay = element<HTMLInputElement>("net-delay");
  private readonly jitter = element<HTMLInputElement>("net-jitter");
  private readonly loss = element<HTMLInputElement>("net-loss");

  /** @param onChange the person has moved a slider */
  constructor(onChange: () => void) {
    this.delay.max = String(worst.delay);
    this.jitter.max = String(worst.jitter);
    this.loss.max = String(worst.loss);
    for (const slider of [this.delay, this.jitter, this.loss]) {
      slider.addEventListener("input", () => {
        this.showNumbers();
        onChange();
      });
    }
    this.show({ delay: 0, jitter: 0, loss: 0 });
  }

  /** What the sliders stand at. */
  get network(): Network {
    return { delay: Number(this.delay.value), jitter: Number(this.jitter.value), loss: Number(this.loss.value) };
  }

  show({ delay, jitter, loss }: Network): void {
    this.delay.value = String(delay);
    this.jitter.value = String(jitter);
    this.loss.value = String(loss);
    this.showNumbers();
  }

  private showNumbers(): void {
    output(this.delay, `${this.delay.value} ms`);
    output(this.jitter, `± ${this.jitter.value} ms`);
    output(this.loss, `${this.loss.value} %`);
  }
}
