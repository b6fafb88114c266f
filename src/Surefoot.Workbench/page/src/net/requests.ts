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
import { Button, type Settings, type Spot } from "./wire";

/** Is told what a person does, as it is sent. */
export interface Witness {
  keys(held: number, sequence: number): void;
  autoRun(held: number, sequence: number): void;
  /** Something that no script of keys can say. */
  miss(what: string): void;
}

export class Requests {
  private sequence = 0;
  private held = 0;

  constructor(
    private readonly connection: Connection,
    private readonly witness: Witness,
  ) {}

  keys(held: number): void {
    this.held = held;
    this.witness.keys(held, this.sendKeys());
  }

  settings({ runSkill, jumpSkill, burden }: Settings): void {
    this.witness.miss("the change of skills on the way");
    this.connection.send(encodeSettings(runSkill, jumpSkill, burden));
  }

  goto(place: number): void {
    this.connection.send(encodeGoto(place));
  }

  placeAt(spot: Spot): void {
    this.connection.send(encodePlaceAt(spot));
  }

  use(): void {
    this.witness.miss("the door");
    this.connection.send(encodeUse());
  }

  pointer(buttons: number, right: number): void {
    if ((buttons & Button.Right) !== 0) this.witness.miss("what the mouse did");
    this.connection.send(encodePointer(buttons, right));
  }

  mouseTurning(on: boolean): void {
    this.connection.send(encodeMouseTurning(on));
  }

  autoRun(): void {
    this.connection.send(encodeAutoRun());
    this.witness.autoRun(this.held, this.sendKeys());
  }

  focusLost(): void {
    this.connection.send(encodeFocusLost());
    this.keys(0);
  }

  /** Bytes as they are; for tests of the server. */
  raw(bytes: ArrayBuffer): void {
    this.connection.send(bytes);
  }

  /** Says which keys are held; each frame has a number, by which a pose says that it was taken. */
  private sendKeys(): number {
    this.sequence = (this.sequence + 1) >>> 0;
    this.connection.send(encodeInput(this.held, this.sequence));
    return this.sequence;
  }
}
