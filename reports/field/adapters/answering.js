// SPDX-License-Identifier: Apache-2.0
// Answers the lines of `tribocheck verify` with the functions that a module exports: node answering.js MODULE. load() runs
// files of the folder FIELD_SOURCE as a page would; `names` are stand-ins for objects of the browser.
"use strict";
const fs = require("fs"), path = require("path"), vm = require("vm");

exports.load = (files, names) => {
  const page = vm.createContext({ console, ...names });
  for (const file of files) vm.runInContext(fs.readFileSync(path.join(process.env.FIELD_SOURCE, file), "utf8"), page);
  return page;
};

function answer(functions, { id, function: name = "operating_point", ...given }) {
  try {
    const result = Object.hasOwn(functions, name) ? functions[name](given) : undefined;
    if (result === undefined) return { id, skip: `${name} is not offered here` };
    return { id, ...(typeof result === "object" ? result : { value: result }) };
  } catch (error) {
    return { id, error: String(error) };
  }
}

const written = (key, value) => (typeof value === "number" && !Number.isFinite(value) ? String(value) : value);
if (require.main === module) {
  console.log = console.error;
  const functions = require(path.resolve(process.argv[2]));
  require("readline").createInterface({ input: process.stdin }).on("line",
    (line) => fs.writeSync(1, JSON.stringify(answer(functions, JSON.parse(line)), written) + "\n"));
}
