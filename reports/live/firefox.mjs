// SPDX-License-Identifier: Apache-2.0
// The page's live part in Firefox, by WebDriver BiDi: `node firefox.mjs PAGE NODE_MODULES`, as `make live-firefox` calls it.
// Types, drags, verifies and shares a link, and holds the numbers of 200 contacts to those of Node, bit for bit. Exit code 1: something differs.
import assert from "node:assert/strict";
import fs from "node:fs";
import {createRequire} from "node:module";
import path from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";
import vm from "node:vm";

const [, , page, modules] = process.argv, here = path.dirname(fileURLToPath(import.meta.url));
const require = createRequire(path.join(path.resolve(modules), "x.js"));
const puppeteer = await import(pathToFileURL(require.resolve("puppeteer-core")));

globalThis.tribocheckForm = JSON.parse(fs.readFileSync(path.join(here, "form.json"), "utf8"));
vm.runInThisContext(fs.readFileSync(path.join(here, "live.js"), "utf8"));
const model = await globalThis.tribocheckLive.Model.from(fs.readFileSync(path.join(here, "tribocheck.wasm")));

const browser = await puppeteer.launch({browser: "firefox", executablePath: "/usr/bin/firefox-esr", headless: true});
try {
  const tab = await browser.newPage();
  await tab.setViewport({width: 1400, height: 900});
  const address = pathToFileURL(path.resolve(page)).href;
  await tab.goto(`${address}#live`);
  await tab.waitForFunction(() => globalThis.tribocheckLive?.page?.drawn > 0);

  // Each drag gives the number that Node's model has of the same text.
  const told = await tab.evaluate((count) => {
    const entry = document.querySelector('[data-drag="load"]'), found = [], times = [];
    for (let k = 0; k < count; ++k) {
      entry.value = k % 150 - 75;
      const start = performance.now();
      entry.dispatchEvent(new Event("input", {bubbles: true}));
      times.push(performance.now() - start);
      const {state, model} = tribocheckLive.page, at = Number(state.values.at);
      found.push([tribocheckLive.tomlOf(state), at, ...Object.values(model.points(at, at, 1)).map(([one]) => String(one))]);
    }
    return {found, time: times.sort((a, b) => a - b)[count / 2]};
  }, 200);
  for (const [toml, at, ...numbers] of told.found) {
    assert.deepEqual(model.read(toml).filter(([kind]) => kind === "error"), []);
    assert.deepEqual(Object.values(model.points(at, at, 1)).map(([one]) => String(one)), numbers);
  }

  const load = await tab.$('[data-path="load"]');
  await load.evaluate((one) => one.select());
  await load.type("-5");
  assert.match(await tab.$eval("#live-load-fault", (one) => one.textContent), /^-5 is not allowed; allowed: a number above 0/);
  await load.evaluate((one) => one.select());
  await load.type("72.5");
  assert.match(await tab.$eval('[data-part="text"]', (one) => one.value), /^load = 72\.5 /m);
  await tab.click('[data-do="verify"]');
  assert.match(await tab.$eval(".verdict", (one) => one.textContent), /^Verified in this browser/);

  await tab.waitForFunction(() => location.hash.includes("load=72.5"));
  const link = await tab.evaluate(() => location.href), numbers = await tab.$eval('[data-part="numbers"]', (one) => one.textContent);
  await tab.goto("about:blank");
  await tab.goto(link);
  await tab.waitForFunction(() => globalThis.tribocheckLive?.page?.drawn > 0);
  assert.equal(await tab.$eval('[data-part="numbers"]', (one) => one.textContent), numbers);
  console.log(`${await browser.version()}: the live part has Node's bits at ${told.found.length} contacts; a drag takes ${told.time.toFixed(1)} ms of script in the median`);
} finally {
  await browser.close();
}
