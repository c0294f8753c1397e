// Plans scenes in WebAssembly and by the program, and compares the plans number by number:
//   node apps/wasm/same_bits.mjs pairtrawl_wasm.wasm path/to/pairtrawl scene.toml...
// Everything must be the same but the seconds that the work took. Exits with 1 when something is not.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";

const [modulePath, program, ...scenes] = process.argv.slice(2);
if (scenes.length === 0) throw new Error("usage: same_bits.mjs MODULE PROGRAM SCENE...");
const { instance } = await WebAssembly.instantiate(readFileSync(modulePath), {});
const wasm = instance.exports;

/** The plan that the module makes of a scene, and the seconds that it took. */
function planInWasm(scene) {
  const begin = performance.now();
  const others = readdirSync(dirname(scene)).filter((name) => /\.(yaml|pgm|png)$/.test(name));
  for (const name of [basename(scene), ...others]) {
    for (const byte of Buffer.from(name)) wasm.push(byte);
    wasm.end_name();
    for (const byte of readFileSync(join(dirname(scene), name))) wasm.push(byte);
    wasm.end_file();
  }
  const hasPlan = wasm.plan();
  const text = Buffer.from(Uint8Array.from({ length: wasm.length() }, (_, i) => wasm.byte(i))).toString();
  if (!hasPlan) throw new Error(`${scene} in WebAssembly: ${text}`);
  return [JSON.parse(text), (performance.now() - begin) / 1000];
}

/** The plan that the program writes. */
function planNatively(scene) {
  const folder = mkdtempSync(join(tmpdir(), "pairtrawl-"));
  try {
    execFileSync(program, ["plan", scene, "-o", folder], { stdio: ["ignore", "ignore", "inherit"] });
    return JSON.parse(readFileSync(join(folder, "plan.json"), "utf8"));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Every path at which two JSON values differ; `same.numbers` counts the numbers that agree. */
function* differences(a, b, path, same) {
  if (path.endsWith(".seconds")) return;
  if (typeof a === "object" && a !== null && typeof b === "object" && b !== null) {
    for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) {
      yield* differences(a[key], b[key], `${path}.${key}`, same);
    }
  } else if (!Object.is(a, b)) {
    yield `${path}: ${a} in WebAssembly, ${b} natively`;
  } else if (typeof a === "number") {
    same.numbers += 1;
  }
}

let failed = false;
for (const scene of scenes) {
  const [plan, seconds] = planInWasm(scene);
  const same = { numbers: 0 };
  const found = [...differences(plan, planNatively(scene), "plan", same)];
  found.slice(0, 10).forEach((difference) => console.error(`${scene}: ${difference}`));
  const verdict = found.length === 0 ? "the same bits" : `${found.length} differences`;
  console.log(`${scene}: ${verdict}; ${same.numbers} numbers agree; ${seconds.toFixed(1)} s in WebAssembly`);
  // A comparison of nothing proves nothing.
  failed ||= found.length > 0 || same.numbers < 500;
}
process.exit(failed ? 1 : 0);
