// Opens reports in a real browser and checks what a reader would see.
//
//   node check.mjs PLAN.html FAILED.html
//
// The first is the report of a plan that was rehearsed, the second that of a run that left objects behind. Needs the package
// `playwright-core`, a Chromium (`CHROMIUM` or one of the usual names) and, for the layout on paper, `pdftotext`.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

// The package may be installed anywhere: it is looked for from the working directory.
const { chromium } = createRequire(pathToFileURL(join(process.cwd(), "from")))("playwright-core");

const faults = [];
const check = (holds, what) => {
  if (!holds) faults.push(what);
};

const [plan, failed] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });

const open = async (file, width) => {
  const page = await browser.newPage({ viewport: { width, height: 900 } });
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) faults.push(`${file}: ${message.text()}`);
  });
  page.on("pageerror", (error) => faults.push(`${file}: ${error.message}`));
  await page.goto(pathToFileURL(resolve(file)).href);
  return page;
};

// Waits a little for something that must come true.
const eventually = (page, holds, argument, what) =>
  page.waitForFunction(holds, argument, { timeout: 3000 }).catch(() => check(false, what));

const view = (page) => page.locator("#world").getAttribute("transform");

// Words that stand on two lines, and elements that stick out of the window to the right.
const layout = (page) =>
  page.evaluate(() => {
    const broken = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node.parentElement.closest("script, svg, select, noscript")) continue;
      for (const { 0: word, index } of node.data.matchAll(/[\p{L}\p{N}]+/gu)) {
        const range = document.createRange();
        range.setStart(node, index);
        range.setEnd(node, index + word.length);
        const lines = new Set([...range.getClientRects()].filter((r) => r.width > 0).map((r) => Math.round(r.top)));
        if (lines.size > 1) broken.push(word);
      }
    }
    const out = [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().right > innerWidth + 1);
    return { broken, out: out.map((e) => `${e.tagName}#${e.id}`), scrolls: document.documentElement.scrollWidth > innerWidth };
  });

for (const file of [plan, failed]) {
  for (const width of [1280, 390]) {
    const page = await open(file, width);
    const { broken, out, scrolls } = await layout(page);
    check(broken.length === 0, `${file} at ${width} px: broken words ${broken.join(", ")}`);
    check(out.length === 0 && !scrolls, `${file} at ${width} px: wider than the window: ${out.join(", ")}`);
    await page.close();
  }
}

// Verdicts.
{
  const page = await open(failed, 1280);
  const badges = await page.locator(".badge").allTextContents();
  check(/^\u2717 \d+ of \d+ trials gathered everything$/.test(badges[0] || ""), `first badge of the failed run: ${badges[0]}`);
  check(await page.locator(".badge").first().evaluate((b) => b.classList.contains("bad")), "the first badge is not red");
  const first = await page.locator("main > section").first().getAttribute("id");
  check(first === "failures", `the page of a failed run begins with ${first}`);
  const text = await page.locator("body").innerText();
  check(!/\bNaN\b|undefined|Infinity/.test(text), "the page says NaN, undefined or Infinity");
  check(!/\d\.\d{6,}/.test(text), `a number with too many digits: ${text.match(/\d\.\d{6,}/)}`);

  // What is swept never runs ahead of the robots that are shown.
  const ends = await page.evaluate(() => {
    const apart = [];
    for (let share = 0.05; share <= 1; share += 0.05) {
      const slider = document.getElementById("time");
      slider.value = share * slider.max;
      slider.dispatchEvent(new Event("input"));
      const robots = [...document.querySelectorAll("#duo .robot.moving")].map((r) => {
        const { e, f } = r.transform.baseVal.consolidate().matrix;
        return [e, f];
      });
      const shown = [...document.querySelectorAll("#duo .swept path")].filter((p) => p.style.display !== "none");
      const d = shown.map((p) => p.getAttribute("d")).filter(Boolean).pop();
      if (!d) continue;
      const ring = d.slice(d.lastIndexOf("M") + 1, -1).split("L").map((p) => p.split(" ").map(Number));
      for (const [x, y] of robots) apart.push(Math.min(...ring.map(([u, v]) => Math.hypot(u - x, v - y))));
    }
    return { apart: Math.max(...apart), count: apart.length, radius: data.radius };
  });
  check(ends.count > 20 && ends.apart < 0.5 * ends.radius, `swept and robots are up to ${ends.apart} m apart`);
  await page.close();
}

// Zoom by wheel, keys, buttons; the way back by double click.
{
  const page = await open(plan, 1280);
  const whole = await view(page);
  const box = await page.locator("#map-window").boundingBox();
  await page.locator("#map").scrollIntoViewIfNeeded();
  const map = await page.locator("#map").boundingBox();
  const middle = [map.x + map.width / 2, map.y + Math.min(map.height / 2, 300)];
  check(box !== null, "there is no map");
  await page.mouse.move(...middle);
  await page.mouse.wheel(0, -300);
  const moved = (before) => document.getElementById("world").getAttribute("transform") !== before;
  await eventually(page, moved, whole, "the wheel does not zoom");
  const zoomed = await view(page);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 60, middle[1] + 30);
  await page.mouse.up();
  check((await view(page)) !== zoomed, "dragging does not move a zoomed map");
  await page.mouse.dblclick(...middle);
  check((await view(page)) === whole, "a double click does not show everything");
  await page.locator("#map").focus();
  await page.keyboard.press("+");
  const near = await view(page);
  check(near !== whole, "the plus key does not zoom");
  await page.keyboard.press("ArrowLeft");
  check((await view(page)) !== near, "an arrow key does not move a zoomed map");
  await page.keyboard.press("0");
  check((await view(page)) === whole, "the key 0 does not show everything");
  await page.locator("#zoom-in").click();
  check((await view(page)) !== whole, "the button does not zoom");
  await page.locator("#zoom-fit").click();
  check((await view(page)) === whole, "the button does not show everything");

  // A wheel that turns away from a map shown as a whole scrolls the page.
  await page.mouse.move(...middle);
  const top = await page.evaluate(() => scrollY);
  await page.mouse.wheel(0, 200);
  await eventually(page, (before) => scrollY > before, top, "the wheel does not scroll past a map shown as a whole");
  const letters = await page.locator("#map .letter").allTextContents();
  check(letters.filter((l) => l === "L").length >= 3 && letters.filter((l) => l === "R").length >= 3, "robots have no letters");
  const dashes = await page.locator("#layer-paths .right.path").evaluate((p) => getComputedStyle(p).strokeDasharray);
  check(dashes !== "none", "the right path has no dashes");
  await page.close();
}

// On paper: every chart is on one page with its axis, and nothing is cut at the side.
let paper = "looked at";
try {
  execFileSync("pdftotext", ["-v"], { stdio: "ignore" });
} catch {
  paper = "not looked at: there is no pdftotext";
}
if (paper === "looked at") {
  const folder = mkdtempSync(join(tmpdir(), "pairtrawl-page-"));
  for (const file of [plan, failed]) {
    const page = await open(file, 1280);
    const plots = await page.locator(".plot h3").allTextContents();
    const pdf = join(folder, "page.pdf");
    await page.pdf({ path: pdf, format: "A4" });
    const sheets = execFileSync("pdftotext", ["-raw", pdf, "-"], { encoding: "utf8" }).split("\f");
    let found = 0;
    sheets.forEach((sheet, i) => {
      const words = sheet.replace(/\s+/g, " ");
      const titles = plots.filter((title) => words.includes(title)).length;
      const axes = words.split("time (s)").length - 1;
      check(titles === axes, `${file}, page ${i + 1} on paper: ${titles} titles of charts, ${axes} axes`);
      found += axes;
    });
    check(plots.length > 0 && found === plots.length, `${file} on paper: ${found} of ${plots.length} charts`);
    await page.emulateMedia({ media: "print" });
    await page.setViewportSize({ width: 690, height: 1000 });
    const { out } = await layout(page);
    check(out.length === 0, `${file} on paper: wider than the page: ${out.join(", ")}`);
    await page.close();
  }
  rmSync(folder, { recursive: true });
}

await browser.close();
for (const fault of faults) console.error(`FAULT ${fault}`);
console.log(`pages in a browser: ${faults.length} faults; paper ${paper}`);
process.exit(faults.length === 0 ? 0 : 1);
