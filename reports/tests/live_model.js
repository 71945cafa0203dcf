// SPDX-License-Identifier: Apache-2.0
// The page's live part under Node, without a page. Each input line is JSON, [what, argument, …]; its answer is a line of JSON.
"use strict";
const fs = require("fs"), path = require("path"), readline = require("readline"), vm = require("vm");

const folder = path.join(process.env.TRIBOCHECK_ROOT, "reports/live");
globalThis.tribocheckForm = JSON.parse(fs.readFileSync(path.join(folder, "form.json"), "utf8"));
vm.runInThisContext(fs.readFileSync(path.join(folder, "live.js"), "utf8"));
const live = globalThis.tribocheckLive;

const answers = (model) => ({
  // The outputs of a scene at one speed, NaN as null; {told} where the scene has errors.
  solve: (toml, speed) => {
    const told = model.read(toml);
    if (told.some(([kind]) => kind === "error")) return {told};
    return Object.fromEntries(Object.entries(model.points(speed, speed, 1)).map(([name, [value]]) => {
      const {words} = model.outputs.find((one) => one.name === name) ?? {words: [""]};
      return [name, words[0] !== "" && !Number.isNaN(value) ? words[value] : value];
    }));
  },
  read: (toml) => model.read(toml),
  ask: (toml, call, ...numbers) => {
    model.read(toml);
    return model.lines(call, ...numbers);
  },
  state: (toml) => {
    model.read(toml);
    return live.stateOf(model);
  },
  form: (toml) => {
    model.read(toml);
    const state = live.stateOf(model);
    return [live.tomlOf(state), live.tomlOf(live.stateOfFragment(live.fragmentOf(state)))];
  },
  toml: (state) => live.tomlOf(state),
  quantities: (toml, at) => {
    model.read(toml);
    return live.quantitiesOf(model, at);
  },
  causes: (toml, at, mistakes, quantity, number, doubt) => {
    model.read(toml);
    return live.causesOf(model, mistakes, quantity, number, doubt, at);
  },
  typed: (text, unit) => live.typedNumber(text, unit),
  python: (state) => live.pythonOf(state),
  shifted: (text, power) => live.shifted(text, power),
  unpacked: (text) => Array.from(live.bytesOf(text)),
});

(async () => {
  const model = await live.Model.from(fs.readFileSync(path.join(folder, "tribocheck.wasm")));
  const known = answers(model);
  for await (const line of readline.createInterface({input: process.stdin})) {
    const [what, ...rest] = JSON.parse(line);
    process.stdout.write(JSON.stringify(known[what](...rest)) + "\n");
  }
})();
