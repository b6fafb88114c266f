// What a page asks of the server, over a connection.

import type { Connection } from "./connection";
import {
  encodeAskWalk,
  encodeAutoRun,
  encodeCreature,
  encodeFocusLost,
  encodeGoto,
  encodeInput,
  encodeMouseTurning,
  encodeNetwork,
  encodePlaceAt,
  encodePointer,
  encodeSettings,
  encodeUse,
} from "./encode";
import type { Network, Settings, Spot } from "./wire";

export class Requests {
  private sequence = 0;
  private held = 0;

  constructor(private readonly connection: Connection) {}

  keys(held: number): void {
    this.held = held;
    this.sendKeys();
  }

  settings({ runSkill, jumpSkill, burden }: Settings): void {
    this.connection.send(encodeSettings(runSkill, jumpSkill, burden));
  }

  goto(place: number): void {
    this.connection.send(encodeGoto(place));
  }

  placeAt(spot: Spot): void {
    this.connection.send(encodePlaceAt(spot));
  }

  use(): void {
    this.connection.send(encodeUse());
  }

  pointer(buttons: number, right: number): void {
    this.connection.send(encodePointer(buttons, right));
  }

  mouseTurning(on: boolean): void {
    this.connection.send(encodeMouseTurning(on));
  }

  autoRun(): void {
    this.connection.send(encodeAutoRun());
    this.sendKeys();
  }

  focusLost(): void {
    this.connection.send(encodeFocusLost());
    this.keys(0);
  }

  /** How bad the network is over which others are heard of, and whether it is to be shown where they are in truth. */
  network(network: Network, truth: boolean): void {
    this.connection.send(encodeNetwork(network, truth));
  }

  /** @param wish one of `Wish` */
  creature(body: number, wish: number): void {
    this.connection.send(encodeCreature(body, wish));
  }

  /** What was done last? The answer is a frame of its own. */
  askWalk(): void {
    this.connection.send(encodeAskWalk());
  }

  /** Bytes as they are; for tests of the server. */
  raw(bytes: ArrayBuffer): void {
    this.connection.send(bytes);
  }

  /** Says which keys are held; each frame has a number, by which a pose says that it was taken. */
  private sendKeys(): void {
    this.sequence = (this.sequence + 1) >>> 0;
    this.connection.send(encodeInput(this.held, this.sequence));
  }
}
