import { describe, expect, it } from "vitest";
import { WalkRecord } from "./walk";
import { writeScript, writeWalk } from "./walkCommand";
import { Key, type OwnPose, PoseFlag } from "./wire";

const settings = { runSkill: 300, jumpSkill: 250, burden: 0 };
const meadow = { cell: 0xa9b50032, x: 156, y: 24, z: 20, yaw: 0 };

/** A record and a player who walks north, with the server's clock and what it has taken. */
class Walker {
  readonly record = new WalkRecord(
    () => settings,
    () => null,
  );
  private sequence = 0;
  private ticks = 0;

  /** A tick at this time, which has taken all that was done. */
  tick(time: number, y: number, speed: number, teleports = 0): void {
    const standing = { flags: PoseFlag.Contact | PoseFlag.OnWalkable, velocity: { x: 0, y: speed, z: 0 }, sequence: this.sequence };
    this.record.receive({
      kind: "pose",
      time,
      cell: meadow.cell,
      position: { x: 156, y, z: 20 },
      yaw: 0,
      speed,
      teleports,
      tick: ++this.ticks,
      ...standing,
    } as OwnPose);
  }

  keys(held: number): void {
    this.record.keys(held, ++this.sequence);
  }

  autoRun(held: number): void {
    this.record.autoRun(held, ++this.sequence);
  }
}

describe("a script", () => {
  it("names keys as the command does", () => {
    expect(writeScript([{ keys: 0xff, seconds: 1 }])).toBe("W+S+A+D+Q+E+Shift+Space 1");
    expect(
      writeScript([
        { keys: Key.Forward, seconds: 3 },
        { keys: Key.Forward | Key.Jump, seconds: 0.6004 },
        { keys: 0, seconds: 0.25 },
      ]),
    ).toBe("W 3; W+Space 0.6; Wait 0.25");
  });

  it("joins what is the same, and passes over what took no time", () => {
    const legs = [
      { keys: Key.Forward, seconds: 1 },
      { keys: Key.Forward | Key.TurnLeft, seconds: 0.0004 },
      { keys: Key.Forward, seconds: 1 },
    ];
    expect(writeScript(legs)).toBe("W 2");
    expect(writeScript([])).toBe("Wait 1");
  });
});

describe("a command", () => {
  it("says place, heading and skills, and burden and files where there are any", () => {
    const legs = [{ keys: Key.Forward, seconds: 2 }];
    expect(writeWalk({ ...meadow, yaw: -Math.PI / 2 }, settings, legs, 0.0361, null)).toBe(
      'surefoot walk --at 0xA9B50032,156,24,20,90 --run 300 --jump 250 --quantum 36.1 --script "W 2"',
    );
    const loaded = { ...settings, burden: 7000 };
    expect(writeWalk(meadow, loaded, legs, null, "/games/Asheron's Call")).toContain(
      "--burden 7000 --dats '/games/Asheron'\\''s Call' --script",
    );
    expect(writeWalk(meadow, settings, legs, null, "C:\\Games\\AC")).toContain('--dats "C:\\Games\\AC" --script');
    expect(writeWalk(meadow, settings, legs, null, "/games/ac")).toContain("--dats /games/ac --script");
  });

  it("asks for quanta that the command can make", () => {
    const legs = [{ keys: Key.Forward, seconds: 2 }];
    expect(writeWalk(meadow, settings, legs, 0.0333333, null)).toContain("--quantum 33.34 ");
    expect(writeWalk(meadow, settings, legs, 0.7, null)).toContain("--quantum 200 ");
  });
});

describe("what was just done", () => {
  it("begins where the player set off and ends when it stands", () => {
    const player = new Walker();
    expect(player.record.command).toBeNull();
    player.tick(10, 24, 0);
    expect(player.record.command).toContain('--script "Wait 1"');
    player.tick(20, 24, 0);
    player.keys(Key.Forward);
    for (let i = 1; i <= 16; i++) player.tick(20 + i / 8, 24 + i, 8);
    player.keys(0);
    player.tick(22.125, 40.5, 3);
    for (let i = 2; i < 30; i++) player.tick(22 + i / 8, 40.5, 0);
    expect(player.record.command).toBe(
      'surefoot walk --at 0xA9B50032,156,24,20,0 --run 300 --jump 250 --quantum 125 --script "W 2; Wait 0.375"',
    );
    expect(player.record.metres).toBeCloseTo(16.5, 6);
    expect(player.record.seconds).toBeCloseTo(2.375, 6);
  });

  it("takes time from the server, however late its poses and the keys come", () => {
    const player = new Walker();
    player.tick(1, 24, 0);
    player.keys(Key.Forward);
    player.record.receive({
      time: 1.5,
      sequence: 0,
      teleports: 0,
      cell: meadow.cell,
      position: { x: 156, y: 24, z: 20 },
      speed: 0,
      flags: 3,
      velocity: { z: 0 },
    } as OwnPose);
    player.tick(1.75, 26, 8);
    player.keys(0);
    player.tick(2.25, 30, 8);
    expect(player.record.command).toContain('--script "W 0.25; Wait 0.5"');
  });

  it("goes on over a short halt, and begins anew after a rest", () => {
    const player = new Walker();
    player.tick(1, 24, 0);
    player.keys(Key.Forward);
    player.tick(2, 34, 10);
    player.keys(0);
    player.tick(3, 34, 0);
    player.keys(Key.Back);
    player.tick(4, 31, 5);
    player.keys(0);
    player.tick(4.25, 30, 0);
    expect(player.record.command).toContain('--script "W 1; Wait 1; S 1; Wait 0.25"');
    player.tick(6, 30, 0);
    player.keys(Key.TurnLeft);
    player.tick(6.5, 30, 0);
    expect(player.record.command).toBe('surefoot walk --at 0xA9B50032,156,30,20,0 --run 300 --jump 250 --quantum 200 --script "A 0.5"');
    expect(player.record.path).toHaveLength(1);
  });

  it("takes running without a key for the key, until one goes forward or back", () => {
    const player = new Walker();
    player.tick(2, 24, 0);
    player.autoRun(0);
    player.tick(3, 30, 10);
    player.keys(Key.TurnLeft);
    player.tick(3.5, 35, 10);
    player.keys(0);
    player.tick(4, 40, 10);
    player.keys(Key.Back);
    player.tick(5, 37, 5);
    player.keys(0);
    player.tick(5.125, 37, 0);
    expect(player.record.command).toContain('--script "W 1; W+A 0.5; W 0.5; S 1; Wait 0.125"');
  });

  it("charges a jump as long as it was charged, whenever its key came between two ticks", () => {
    const early = new Walker();
    early.tick(1, 24, 0);
    early.keys(Key.Forward);
    early.tick(2, 34, 10);
    early.keys(Key.Forward | Key.Jump);
    early.tick(3, 44, 10);
    early.keys(Key.Forward);
    early.record.jumped(0.75);
    early.tick(3.5, 49, 10);
    expect(early.record.command).toContain('--script "W 1.25; W+Space 0.75; W 0.5"');

    const late = new Walker();
    late.tick(1, 24, 0);
    late.keys(Key.Forward);
    late.tick(2, 34, 10);
    late.keys(Key.Forward | Key.Jump);
    late.tick(2.25, 36.5, 10);
    late.keys(Key.Forward);
    late.record.jumped(0.5);
    late.tick(3, 44, 10);
    expect(late.record.command).toContain('--script "W 0.75; W+Space 0.5; W 0.75"');

    const standing = new Walker();
    standing.tick(1, 24, 0);
    standing.keys(Key.Jump);
    standing.tick(1.5, 24, 0);
    standing.keys(0);
    standing.record.jumped(0.25);
    standing.tick(2, 24, 0);
    expect(standing.record.command).toContain('--script "Wait 0.25; Space 0.25; Wait 0.5"');

    const full = new Walker();
    full.tick(1, 24, 0);
    full.keys(Key.Jump);
    full.tick(3, 24, 0);
    full.keys(0);
    full.record.jumped(1);
    full.tick(3.5, 24, 0);
    expect(full.record.command).toContain('--script "Space 2; Wait 0.5"');
  });

  it("says that the command meets nobody, where somebody was in the way", () => {
    const player = new Walker();
    const touch = { footing: false, id: 1, normal: { x: 0, y: -1, z: 0 }, name: "" };
    player.tick(1, 24, 0);
    player.keys(Key.Forward);
    player.tick(2, 34, 10);
    player.record.touch([{ ...touch, type: 2 }]);
    expect(player.record.leftOut).toEqual([]);
    player.record.touch([
      { ...touch, type: 2 },
      { ...touch, type: 6 },
    ]);
    expect(player.record.leftOut).toEqual(["who was in the way"]);
  });

  it("begins anew at another place, and says what keys cannot", () => {
    const player = new Walker();
    player.tick(1, 24, 0);
    player.keys(Key.Forward);
    player.record.miss("what the mouse did");
    expect(player.record.leftOut).toEqual([]);
    player.tick(2, 34, 10);
    expect(player.record.leftOut).toEqual(["what the mouse did"]);
    player.tick(3, 100, 0, 1);
    expect(player.record.command).toContain("--at 0xA9B50032,156,100,20,0");
    expect(player.record.leftOut).toEqual([]);
  });
});
