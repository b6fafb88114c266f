// What a page asks of the server, over a connection.

import type { Connection } from "./connection";
import {
  encodeAutoRun,
  encodeFocusLost,
  encodeGoto,
  encodeInput,
  encodeMouseTurning,
  encodePlaceAt,
  encodePointer,
  encodeSettings,
  encodeUse,
} from "./encode";
import type { Settings, Spot } from "./wire";

export class Requests {
  private sequence = 0;

  constructor(private readonly connection: Connection) {}

  keys(held: number): void {
    this.sequence = (this.sequence + 1) >>> 0;
    this.connection.send(encodeInput(held, this.sequence));
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
  }

  focusLost(): void {
    this.connection.send(encodeFocusLost());
  }

  /** Bytes as they are; for tests of the server. */
  raw(bytes: ArrayBuffer): void {
    this.connection.send(bytes);
  }
}
