import { describe, expect, it } from "vitest";
import { readLink, toggleDefaults, writeLink } from "./link";

const limits = { maxSkill: 1000, maxBurden: 45_000 };

describe("a link", () => {
  it("says skills, place and toggles, and is read as it was written", () => {
    const toggles = { ...toggleDefaults, triangles: true, shapes: true, mouse: false, truth: true };
    const net = { delay: 200, jitter: 100, loss: 5 };
    const written = writeLink({ run: 800, jump: 0, burden: 7000, at: "0xA9B50032,156,24.01,20,90", net, toggles });
    expect(written).toBe("?run=800&jump=0&burden=7000&at=0xA9B50032,156,24.01,20,90&net=200,100,5&on=triangles,shapes,truth&off=mouse");
    expect(readLink(written, limits)).toEqual({
      link: { run: 800, jump: 0, burden: 7000, at: "0xA9B50032,156,24.01,20,90", net, toggles },
      ignored: [],
    });
    const named = writeLink({ at: "The foot of the mountain & 5 %", toggles: { ...toggleDefaults } });
    expect(readLink(named, limits).link.at).toBe("The foot of the mountain & 5 %");
  });

  it("that says nothing is empty", () => {
    expect(writeLink({ toggles: { ...toggleDefaults } })).toBe("");
    expect(readLink("", limits)).toEqual({ link: { toggles: toggleDefaults }, ignored: [] });
  });

  it("with impossible values keeps the others and says each that it leaves out", () => {
    const { link, ignored } = readLink("?run=1001&jump=-5&burden=1e3&on=triangles,walls&colour=red&run=700", limits);
    expect(link).toEqual({ run: 700, toggles: { ...toggleDefaults, triangles: true } });
    expect(ignored).toEqual([
      "run=1001 (a whole number from 0 to 1000)",
      "jump=-5 (a whole number from 0 to 1000)",
      "burden=1e3 (a whole number from 0 to 45000)",
      "on=walls (triangles, shapes, mouse, panels, truth)",
      "colour=red (run, jump, burden, at, net, on, off)",
    ]);
  });

  it("that says a thing twice holds to the last of it, and says what it leaves out", () => {
    const { link, ignored } = readLink("?run=300&at=Here&run=400&at=There&on=shapes,triangles&off=triangles&jump=5&jump=5", limits);
    expect(link).toEqual({ run: 400, jump: 5, at: "There", toggles: { ...toggleDefaults, shapes: true } });
    expect(ignored).toEqual(["run=300 (said otherwise later)", "at=Here (said otherwise later)", "on=triangles (said otherwise later)"]);
  });

  it("says how bad the network is, and leaves out one that is none", () => {
    for (const bad of ["1001,0,0", "0,1001,0", "0,0,51", "1,2", "1,2,3,4", "1,2,x", "-1,0,0", ""]) {
      const { link, ignored } = readLink(`?net=${bad}`, limits);
      expect(link).toEqual({ toggles: toggleDefaults });
      expect(ignored[0]).toContain("(delay, jitter, loss: to 1000 ms, 1000 ms, 50 %)");
    }
    expect(readLink("?net=1000,1000,50", limits).link.net).toEqual({ delay: 1000, jitter: 1000, loss: 50 });
    expect(writeLink({ net: { delay: 0, jitter: 0, loss: 0 }, toggles: { ...toggleDefaults } })).toBe("");
  });

  it("however long or odd is cut to what a line holds", () => {
    for (const query of [`?run=${"9".repeat(5000)}`, "?on=__proto__", "?on=constructor", "?%ff=%00", `?${"x".repeat(9000)}`]) {
      const { link, ignored } = readLink(query, limits);
      expect(link).toEqual({ toggles: toggleDefaults });
      expect(ignored).toHaveLength(1);
      expect(ignored[0].length).toBeLessThan(130);
    }
  });
});
