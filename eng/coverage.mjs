// Prints the share of lines that the tests ran, by assembly, from the Cobertura reports in a folder: a line counts when any test project
// ran it. With --missing ASSEMBLY it lists the lines that no test ran instead.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const [folder, option, wanted] = process.argv.slice(2);
const assemblies = new Map();
for (const name of readdirSync(folder, { recursive: true }).filter((file) => /cobertura.*\.xml$/.test(file))) {
  const report = readFileSync(join(folder, name), "utf8");
  for (const [, assembly, body] of report.matchAll(/<package name="([^"]+)"[^>]*>([\s\S]*?)<\/package>/g)) {
    const lines = assemblies.get(assembly) ?? assemblies.set(assembly, new Map()).get(assembly);
    for (const [, file, content] of body.matchAll(/<class [^>]*filename="([^"]+)"[^>]*>([\s\S]*?)<\/class>/g)) {
      if (/[\\/]obj[\\/]/.test(file)) continue;
      for (const [, number, hits] of content.matchAll(/<line number="(\d+)" hits="(\d+)"/g)) {
        // Each report names files from a root of its own.
        const key = `${file.replace(/^.*Surefoot\.?\w*[\\/]/, "")}:${number}`;
        lines.set(key, Math.max(lines.get(key) ?? 0, Number(hits)));
      }
    }
  }
}

if (option === "--missing") {
  for (const [key, hits] of [...(assemblies.get(wanted) ?? [])].sort()) if (hits === 0) console.log(key);
} else {
  console.log("\nLines that tests ran, by assembly:");
  for (const [assembly, lines] of [...assemblies].sort()) {
    const run = [...lines.values()].filter((hits) => hits > 0).length;
    const share = ((100 * run) / lines.size).toFixed(2).padStart(6);
    if (lines.size > 0) console.log(`  ${assembly.padEnd(24)} ${share} %  (${run} of ${lines.size})`);
  }
}
