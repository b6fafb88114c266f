import { describe, expect, it } from "vitest";
import { PoseTimeline, ServerClock, wrapAngle } from "./timeline";
import type { Pose } from "./wire";

const pose = (time: number, x: number, more: Partial<Pose> = {}): Pose => ({
  teleports: 0,
  flags: 3,
  time,
  cell: 0xa9b40001,
  position: { x, y: 10, z: 5 },
  yaw: 0,
  velocity: { x: 10, y: 0, z: 0 },
  charge: 0,
  forward: 1,
  sidestep: 0,
  ...more,
});
const blockWest = 0xa9 * 192;

describe("a timeline", () => {
  it("draws between two poses on the line that joins them", () => {
    const line = new PoseTimeline();
    for (let quantum = 0; quantum <= 5; quantum++) line.push(pose(1 + quantum * 0.04, 20 + quantum * 0.4));
    expect(line.at(1.09)?.position.x).toBeCloseTo(blockWest + 20.9, 9);
    expect(line.at(1.11)?.position.x).toBeCloseTo(blockWest + 21.1, 9);
  });

  it("evens out the unequal strides of whole animation frames", () => {
    const line = new PoseTimeline();
    // Quanta of 1/30 s at 79.5 frames a second of 4/30 m each: two or three frames a quantum (spec 01b, section 2).
    for (let quantum = 0; quantum <= 30; quantum++)
      line.push(pose(quantum / 30, (Math.floor(quantum * 2.65) * 4) / 30, { velocity: { x: 0, y: 0, z: 0 } }));
    let slowest = Infinity;
    let fastest = 0;
    for (let time = 0.2; time < 0.8; time += 1 / 60) {
      const speed = (line.at(time + 1 / 60)!.position.x - line.at(time)!.position.x) * 60;
      slowest = Math.min(slowest, speed);
      fastest = Math.max(fastest, speed);
    }
    expect(slowest).toBeGreaterThan(10.6 * 0.88);
    expect(fastest).toBeLessThan(10.6 * 1.12);
  });

  it("joins poses across a landblock's border", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 190));
    line.push(pose(1.2, 2, { cell: 0xaab40001 }));
    expect(line.at(1.1)?.position.x).toBeCloseTo(blockWest + 192, 9);
  });

  it("turns the short way round", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 0, { yaw: 3 }));
    line.push(pose(2, 0, { yaw: -3 }));
    expect(wrapAngle(line.at(1.5)!.yaw)).toBeCloseTo(Math.PI, 9);
  });

  it("goes on at the last velocity for a tenth of a second when poses are late", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 20));
    expect(line.at(1.05)?.position.x).toBeCloseTo(blockWest + 20.5, 9);
    expect(line.at(1.2)?.position.x).toBeCloseTo(blockWest + 21, 9);
  });

  it("does not draw a line between the two ends of a teleport", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 20));
    line.push(pose(1.04, 150, { teleports: 1, velocity: { x: 0, y: 0, z: 0 } }));
    expect(line.at(1.02)?.position.x).toBeCloseTo(blockWest + 150, 9);
  });
});

describe("the server's clock", () => {
  it("runs forward at the rate of time, behind by about a quantum", () => {
    const clock = new ServerClock(1 / 30);
    let last = -Infinity;
    for (let frame = 0; frame < 300; frame++) {
      const now = 100 + frame / 60;
      if (frame % 2 === 0) clock.arrived(now - 90, now + (frame % 6 === 0 ? 0.004 : 0));
      const drawn = clock.drawTime(now);
      expect(drawn).toBeGreaterThanOrEqual(last);
      last = drawn;
      if (frame > 120) {
        expect(now - 90 - drawn).toBeGreaterThan(1 / 30);
        expect(now - 90 - drawn).toBeLessThan(0.13);
      }
    }
  });
});
