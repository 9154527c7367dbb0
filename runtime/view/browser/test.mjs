// Tests pages and animated SVGs in a headless Chromium.
//
//   node test.mjs FOLDER CHROMIUM [SCREENSHOTS]
//
// FOLDER contains the output of pages.rs. Tests that pages play, that cursors and values follow, that every state is drawn like the frame in
// its file, that keys and pointers work, in light, dark, narrow, printed, and with reduced motion; and measures frames per second.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [folder, executablePath, screenshots] = process.argv.slice(2);
const PAGES = ["four_bar", "slider_crank", "stewart_platform", "chain", "double_pendulum"];
const QUIET = ["--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic"];

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu", ...QUIET] });
let failures = 0;

/// Opens a file; any console error and any request for another file is a failure.
async function opened(name, options, look) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  const url = pathToFileURL(path.resolve(folder, name)).href;
  const trouble = [];
  page.on("console", (message) => trouble.push(message.text()));
  page.on("pageerror", (error) => trouble.push(error.message));
  page.on("request", (request) => request.url() !== url && !request.url().startsWith("data:") && trouble.push(`asks for ${request.url()}`));
  await page.goto(url);
  try {
    await look(page);
    assert.deepEqual(trouble, []);
  } finally {
    await context.close();
  }
}

async function test(name, body) {
  try {
    await body();
    console.log(`ok    ${name}`);
  } catch (error) {
    failures += 1;
    console.log(`FAIL  ${name}\n${error.stack}`);
  }
}

async function picture(page, name, options = {}) {
  if (!screenshots) return;
  fs.mkdirSync(screenshots, { recursive: true });
  await page.screenshot({ path: path.join(screenshots, `${name}.png`), ...options });
}

const state = (page) => page.evaluate(() => Number(document.documentElement.dataset.state));
const still = { reducedMotion: "reduce" };

/// For each diagram the position of its cursor, of the moment shown, and the value shown of each curve; and the values in the data.
const followed = (page) =>
  page.evaluate(() => {
    const data = JSON.parse(document.getElementById("data").textContent);
    const shown = Number(document.documentElement.dataset.state);
    const [first, last] = [data.values[0], data.values.at(-1)];
    return [...document.querySelectorAll(".uplot")].map((plot, number) => {
      const [over, cursor] = [".u-over", ".u-cursor-x"].map((name) => plot.querySelector(name).getBoundingClientRect());
      const texts = [...plot.querySelectorAll(".u-legend .u-value")].slice(1).map((cell) => cell.textContent);
      return {
        cursor: cursor.left - over.left,
        moment: ((data.values[shown] - first) / (last - first)) * over.width,
        shown: texts.map((text) => Number.parseFloat(text.replaceAll("−", "-"))),
        values: data.plots[number].series.map(({ values }) => values[shown]),
      };
    });
  });

async function assertFollowed(page) {
  const plots = await followed(page);
  assert.ok(plots.length > 0);
  for (const { cursor, moment, shown, values } of plots) {
    assert.ok(Math.abs(cursor - moment) < 2, `the cursor is at ${cursor} instead of ${moment}`);
    shown.forEach((value, number) => {
      const exact = values[number];
      assert.ok(Math.abs(value - exact) <= 1e-3 * Math.abs(exact) + 1e-3, `${value} is shown instead of ${exact}`);
    });
  }
}

for (const name of PAGES) {
  await test(`${name} plays, and its cursors follow`, () =>
    opened(`${name}.html`, {}, async (page) => {
      await page.waitForTimeout(400);
      const before = await state(page);
      await page.waitForTimeout(400);
      const after = await state(page);
      assert.ok(before > 0 && after !== before, `from ${before} to ${after}`);
      await page.keyboard.press("Space");
      const paused = await state(page);
      await page.waitForTimeout(150);
      assert.equal(await state(page), paused);
      await assertFollowed(page);
      await picture(page, name);
    }));
}

await test("every state is drawn as its frame", () =>
  opened("four_bar_24.html", still, async (page) => {
    for (let frame = 0; frame < 24; frame++) {
      const file = fs.readFileSync(path.join(folder, "four_bar_frames", `${String(frame).padStart(4, "0")}.svg`), "utf8");
      await page.locator("#moment").fill(String(frame));
      const [drawn, expected] = await page.evaluate((file) => {
        const told = (node) =>
          [node.tagName, ...[...node.attributes].map(({ name, value }) => `${name}=${value}`).sort(), node.textContent].join(" ");
        const tree = new DOMParser().parseFromString(file, "image/svg+xml").documentElement;
        // Traces come before the marks, and the scale, which rests, after them.
        const foot = document.querySelector("#marks").parentNode;
        const below = [...foot.children].slice([...foot.children].indexOf(document.querySelector("#marks")) + 2).length;
        const isMark = (node) => !["title", "desc", "style", "rect"].includes(node.tagName) && node.getAttribute("class") !== "trace";
        const all = [...tree.children].filter(isMark);
        return [[...document.querySelector("#marks").children].map(told), all.slice(0, all.length - below).map(told)];
      }, file);
      assert.ok(drawn.length > 10);
      assert.deepEqual(drawn, expected);
    }
  }));

await test("keys do what they say", () =>
  opened("four_bar.html", still, async (page) => {
    assert.equal(await state(page), 0, "with reduced motion it waits");
    const pressed = async (key, expected) => {
      await page.keyboard.press(key);
      assert.equal(await state(page), expected, key);
    };
    await pressed("ArrowRight", 1);
    await pressed("Shift+ArrowRight", 11);
    await pressed("ArrowLeft", 10);
    await pressed("End", 999);
    await pressed("ArrowRight", 999);
    await pressed("Home", 0);
    const speed = () => page.locator("#speed").inputValue();
    const one = Number(await speed());
    await page.keyboard.press("+");
    assert.equal(Number(await speed()), 2 * one);
    await page.keyboard.press("-");
    await page.keyboard.press("-");
    assert.equal(Number(await speed()), one / 2);
    await page.keyboard.press("Space");
    await page.waitForTimeout(200);
    assert.ok((await state(page)) > 0);
    assert.equal(await page.locator("#play").getAttribute("aria-label"), "Pause");
    await page.locator("#play").focus();
    await page.keyboard.press("Space");
    assert.equal(await page.locator("#play").getAttribute("aria-label"), "Play", "a button is pressed once");
  }));

await test("the pointer takes the motion along", () =>
  opened("four_bar.html", still, async (page) => {
    const box = await page.locator(".u-over").first().boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 20);
    await page.mouse.down();
    assert.ok(Math.abs((await state(page)) - 500) < 4);
    await page.mouse.move(box.x + box.width / 4, box.y + 20);
    await page.mouse.up();
    assert.ok(Math.abs((await state(page)) - 250) < 4);
    await assertFollowed(page);
  }));

await test("a motion begins again at its end", () =>
  opened("slider_crank.html", still, async (page) => {
    await page.locator("#moment").fill("175");
    await page.keyboard.press("Space");
    await page.waitForTimeout(600);
    const now = await state(page);
    assert.ok(now > 0 && now < 120, `at ${now}`);
  }));

await test("independent results are circles that are apart", () =>
  opened("slider_crank.html", still, async (page) => {
    // In the first diagram, columns of pixels in the colour of ink between its axes, as runs.
    const runs = await page.evaluate(() => {
      const [canvas, over] = ["canvas", ".u-over"].map((name) => document.querySelector(`.uplot ${name}`));
      const [whole, inner] = [canvas, over].map((node) => node.getBoundingClientRect());
      const [left, top] = [inner.left - whole.left + 2, inner.top - whole.top + 2].map((part) => Math.ceil(part * devicePixelRatio));
      const [width, height] = [inner.width - 4, inner.height - 4].map((part) => Math.floor(part * devicePixelRatio));
      const { data } = canvas.getContext("2d").getImageData(left, top, width, height);
      const isInk = (at) => data[at + 3] > 200 && data[at] < 60 && data[at + 1] < 60 && data[at + 2] < 60;
      const isMarked = (x) => Array.from({ length: height }, (_, y) => 4 * (y * width + x)).some(isInk);
      const columns = Array.from({ length: width }, (_, x) => isMarked(x));
      return columns.filter((marked, x) => marked && !columns[x - 1]).length;
    });
    assert.ok(runs > 10 && runs < 60, `${runs} circles`);
  }));

await test("values may be missing, tiny or huge, and the abscissa another one", () =>
  opened("gaps.html", still, async (page) => {
    const values = () => page.locator(".u-legend tr:not(:first-child) .u-value").allInnerTexts();
    await page.locator("#moment").fill("0");
    assert.deepEqual(await values(), ["–", "–", "1.0947e−12 m", "2.1894e+11 Pa"]);
    await page.locator("#moment").fill("50");
    assert.match((await values())[0], /^0\.\d{5}$/);
    assert.equal(await page.locator("#readout").innerText(), "crank = 181.8 °");
    assert.equal(await page.title(), "Gaps & <limits>");
    await page.keyboard.press("Space");
    await page.waitForTimeout(300);
    assert.ok((await state(page)) > 50);
    await picture(page, "gaps");
  }));

await test("one state is a page, too", () =>
  opened("one_state.html", {}, async (page) => {
    await page.keyboard.press("End");
    await page.keyboard.press("Space");
    assert.equal(await state(page), 0);
    assert.equal(await page.locator("#marks").locator("circle").count(), 4);
    await picture(page, "one_state");
  }));

await test("light and dark", async () => {
  const colours = (page) =>
    page.evaluate(() => [getComputedStyle(document.body).backgroundColor, getComputedStyle(document.querySelector(".l")).stroke]);
  await opened("four_bar.html", { ...still, colorScheme: "dark" }, async (page) => {
    const dark = await colours(page);
    assert.deepEqual(dark, ["rgb(22, 24, 29)", "rgb(230, 230, 230)"]);
    await page.locator("#moment").fill("600");
    await picture(page, "four_bar_dark");
    await page.locator("#theme").click();
    assert.deepEqual(await colours(page), ["rgb(255, 255, 255)", "rgb(28, 28, 28)"]);
    await page.locator("#theme").click();
    assert.deepEqual(await colours(page), dark);
  });
  await opened("stewart_platform.html", { ...still, colorScheme: "dark" }, (page) => picture(page, "stewart_platform_dark"));
});

for (const name of PAGES) {
  await test(`${name} fits a phone`, () =>
    opened(`${name}.html`, { ...still, viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true }, async (page) => {
      await page.waitForTimeout(100);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      await page.locator("#moment").fill("40");
      await assertFollowed(page);
      await picture(page, `${name}_phone`, { fullPage: true });
    }));
}

await test("on paper there are no controls, and one page is enough", () =>
  opened("four_bar.html", { ...still, colorScheme: "dark" }, async (page) => {
    await page.locator("#moment").fill("300");
    await page.emulateMedia({ media: "print" });
    const display = (name) => getComputedStyle(document.querySelector(name)).display;
    const hidden = await page.evaluate(`[".controls", "#theme"].map(${display})`);
    assert.deepEqual(hidden, ["none", "none"]);
    assert.equal(await page.locator(".shown").innerText(), "t = 1.2012 s");
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
    await page.emulateMedia({ media: null });
    await page.evaluate(() => {
      // State of the printed page.
      const told = () => {
        const [over, cursor] = [".u-over", ".u-cursor-x"].map((name) => document.querySelector(name).getBoundingClientRect());
        document.title = JSON.stringify([document.querySelector(".uplot").clientWidth, (cursor.left - over.left) / over.width]);
      };
      addEventListener("beforeprint", () => queueMicrotask(told));
    });
    const paper = await page.pdf({ format: "A4" });
    assert.equal(paper.toString("latin1").match(/\/Type \/Page\b/g).length, 1);
    if (screenshots) fs.writeFileSync(path.join(screenshots, "four_bar.pdf"), paper);
    const [width, moment] = JSON.parse(await page.title());
    assert.equal(width, 640);
    assert.ok(Math.abs(moment - 300 / 999) < 0.01, `on paper the cursor is at ${moment}`);
    assert.ok((await page.evaluate(() => document.querySelector(".uplot").clientWidth)) < 640, "and then as before");
    await assertFollowed(page);
  }));

await test("names are told to those who do not see", () =>
  opened("four_bar.html", still, async (page) => {
    const buttons = [["button", "Play"], ["button", "Light or dark"]];
    for (const [role, name] of [...buttons, ["slider", "t in s"], ["group", "rocker angle in °"], ["combobox", "speed"]]) {
      assert.equal(await page.getByRole(role, { name, exact: true }).count(), 1, `${role} ${name}`);
    }
    await page.locator("#moment").fill("500");
    assert.equal(await page.locator("#moment").getAttribute("aria-valuetext"), "t = 2.0020 s");
    assert.match(await page.locator("#about").textContent(), /^Four-bar: 3 bodies, 4 joints, 1 drive\.$/);
  }));

for (const name of PAGES) {
  await test(`${name}.svg moves by itself, and rests where motion is reduced`, async () => {
    const twice = async (page) => {
      const one = await page.screenshot();
      await page.waitForTimeout(500);
      return [one, await page.screenshot()];
    };
    await opened(`${name}.svg`, {}, async (page) => {
      const [one, two] = await twice(page);
      assert.ok(!one.equals(two));
      await picture(page, `${name}_svg`);
    });
    await opened(`${name}.svg`, still, async (page) => {
      const [one, two] = await twice(page);
      assert.ok(one.equals(two));
    });
  });
}

for (const name of ["four_bar", "chain", "stewart_platform"]) {
  await test(`${name}: frames a second`, () =>
    opened(`${name}.html`, {}, async (page) => {
      const session = await page.context().newCDPSession(page);
      await session.send("Performance.enable");
      const work = async () => {
        const { metrics } = await session.send("Performance.getMetrics");
        return Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
      };
      await page.waitForTimeout(500);
      const before = await work();
      const frames = await page.evaluate(
        () =>
          new Promise((resolve) => {
            const [times, states] = [[], new Set()];
            const next = (now) => {
              times.push(now);
              states.add(document.documentElement.dataset.state);
              if (now - times[0] < 4000) requestAnimationFrame(next);
              else resolve({ each: (now - times[0]) / (times.length - 1), states: states.size });
            };
            requestAnimationFrame(next);
          }),
      );
      const after = await work();
      const each = (name) => ((after[name] - before[name]) * frames.each) / 4;
      const [script, layout] = [each("ScriptDuration"), each("LayoutDuration") + each("RecalcStyleDuration")].map((ms) => ms.toFixed(2));
      const rate = 1000 / frames.each;
      const counted = `${rate.toFixed(1)} frames/s, ${frames.states} states shown`;
      console.log(`      ${name}: ${counted}; each ${script} ms of script, ${layout} ms of layout`);
      // How fast depends on the machine, and is measured only.
      assert.ok(frames.states > 10);
    }));
}

await browser.close();
console.log(failures ? `${failures} failed` : "all passed");
process.exitCode = failures ? 1 : 0;
