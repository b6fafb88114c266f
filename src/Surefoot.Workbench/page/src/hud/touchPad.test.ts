import { describe, expect, it } from "vitest";
import { Key } from "../net/wire";
import { padKeys } from "./touchPad";

describe("the pad", () => {
  it("runs at its rim, walks half way out and rests in the middle", () => {
    expect(padKeys(0, 1)).toBe(Key.Forward);
    expect(padKeys(0, 0.5)).toBe(Key.Forward | Key.Walk);
    expect(padKeys(0.1, 0.1)).toBe(0);
    expect(padKeys(0, -3)).toBe(Key.Back);
  });

  it("has eight directions", () => {
    const at = (degrees: number): number => padKeys(Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180));
    expect([0, 45, 90, 135, 180, 225, 270, 315].map(at)).toEqual([
      Key.Forward,
      Key.Forward | Key.TurnRight,
      Key.TurnRight,
      Key.Back | Key.TurnRight,
      Key.Back,
      Key.Back | Key.TurnLeft,
      Key.TurnLeft,
      Key.Forward | Key.TurnLeft,
    ]);
    expect(at(20)).toBe(Key.Forward);
    expect(at(25)).toBe(Key.Forward | Key.TurnRight);
  });
});
