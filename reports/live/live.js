// SPDX-License-Identifier: Apache-2.0
// The live part of the page: a form for a contact, which the model itself computes in WebAssembly (live.cpp). The page is
// complete without it. If scripts or WebAssembly cannot run, one sentence says that the live part is missing.
"use strict";

(() => {
// --- The model

// The bytes of a text in base 85, as Python's base64.b85encode writes them.
function bytesOf(text) {
  const signs = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~";
  const values = new Uint8Array(128);
  for (let i = 0; i < signs.length; ++i) values[signs.charCodeAt(i)] = i;
  const padded = text.padEnd(Math.ceil(text.length / 5) * 5, "~");
  const bytes = new Uint8Array(padded.length / 5 * 4), view = new DataView(bytes.buffer);
  for (let i = 0, to = 0; i < padded.length; to += 4) {
    let word = 0;
    for (let k = 0; k < 5; ++k) word = word * 85 + values[padded.charCodeAt(i++)];
    view.setUint32(to, word);
  }
  return bytes.subarray(0, bytes.length - (padded.length - text.length));
}

async function unpacked(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

// The calls that live.cpp exports, with texts as strings and lines as lists of cells.
class Model {
  // Each system call that the C library could make returns 8, the error "bad file descriptor" of WASI.
  static async from(bytes) {
    const {module, instance} = await WebAssembly.instantiate(bytes, new Proxy({}, {get: () => new Proxy({}, {get: () => () => 8})}));
    if (!module) throw new Error("no WebAssembly");
    return new Model(instance.exports);
  }
  constructor(calls) {
    this.calls = calls;
    calls._initialize();
    this.outputs = this.lines("live_outputs").map(([name, unit, meaning, words]) => ({name, unit, meaning, words: words.split(" ")}));
    this.fields = new Map(this.lines("live_fields").map(([path, type, unit, perCent, least, greatest, words, usual, meaning, allowed]) =>
      [path, {type, unit, least: Number(least), greatest: greatest === "inf" ? Infinity : Number(greatest), words: words.split(" "),
              usual, meaning, allowed}]));
    this.regimes = this.lines("live_regimes").map(([word]) => word);
  }
  lines(call, ...numbers) {
    const start = this.calls[call](...numbers), memory = new Uint8Array(this.calls.memory.buffer);
    const text = new TextDecoder().decode(memory.subarray(start, memory.indexOf(0, start)));
    return text.split("\n").slice(0, -1).map((line) => line.split("\t"));
  }
  numbers(count, call, ...numbers) {
    const start = this.calls[call](...numbers);
    return new Float64Array(this.calls.memory.buffer, start, count);
  }
  // Reads a scene's text, and holds the scene. Returns [kind, field, sentence] of each error and warning.
  read(toml) { this.put(toml); return this.lines("live_read"); }
  // Puts a text into the room, for a call that takes one.
  put(text) {
    const bytes = new TextEncoder().encode(text), start = this.calls.live_room(bytes.length);
    new Uint8Array(this.calls.memory.buffer).set(bytes, start);
  }
  // A function of the catalogue: its arguments and results, each a name, a unit and a meaning; null: there is none.
  function(name) {
    this.put(name);
    const lines = this.lines("live_function").map(([kind, ...rest]) => [kind, rest]);
    const of = (wanted) => lines.filter(([kind]) => kind === wanted).map(([, rest]) => rest);
    return lines.length === 0 ? null : {name, arguments: of("argument"), results: of("result")};
  }
  value(name, result, given) {
    this.put([name, result, ...Object.entries(given).map(([path, number]) => `${path}=${number}`)].join(","));
    return this.calls.live_value();
  }
  // The columns of `speed` and of all outputs, at `count` speeds; NaN: undefined.
  points(low, high, count) {
    const width = this.outputs.length + 1, all = this.numbers(width * count, "live_points", low, high, count);
    const columns = {};
    ["speed", ...this.outputs.map((one) => one.name)].forEach((name, k) => {
      columns[name] = Float64Array.from({length: count}, (_, i) => all[i * width + k]);
    });
    return columns;
  }
}

// --- Numbers and their units

// A decimal as text, times a power of ten: its digits stay as they are. Null: the text is no decimal.
function shifted(text, power) {
  const parts = /^([+-]?)(\d*)\.?(\d*)(?:e([+-]?\d+))?$/i.exec(text.trim());
  if (!parts || parts[2] + parts[3] === "") return null;
  const digits = (parts[2] + parts[3]).replace(/^0+/, "");
  if (digits === "") return "0";
  const end = Number(parts[4] ?? 0) - parts[3].length + power, sign = parts[1] === "-" ? "-" : "";
  const short = digits.replace(/0+$/, ""), zeros = end + digits.length - short.length;
  if (zeros >= 0 && short.length + zeros <= 7) return sign + short + "0".repeat(zeros);
  const point = short.length + zeros;
  if (zeros < 0 && point > 0) return `${sign}${short.slice(0, point)}.${short.slice(point)}`;
  if (point <= 0 && point > -4) return `${sign}0.${"0".repeat(-point)}${short}`;
  return `${sign}${short[0]}${short.length > 1 ? "." + short.slice(1) : ""}e${point - 1}`;
}

const valuesOf = (model) => Object.fromEntries(model.lines("live_values"));  // of the held scene, by path
const rounded = (number, digits = 6) => shifted(String(Number(number.toPrecision(digits))), 0) ?? String(number);

// The number in the unit that people use for it.
function usual(number, unit) {
  if (!Number.isFinite(number)) return "undefined";
  const scales = {m: [[1e-3, 3, "mm"], [1e-6, 6, "µm"], [0, 9, "nm"]], Pa: [[1e8, -9, "GPa"], [1e5, -6, "MPa"]]}[unit] ?? [];
  const scale = scales.find(([least]) => Math.abs(number) >= least);
  const text = scale && number !== 0 ? rounded(number * 10 ** scale[1], 4) : rounded(number, 4);
  return `${text}${unit === "" ? "" : " " + (scale && number !== 0 ? scale[2] : unit)}`;
}

// --- The form: a table of path, label, unit, power of ten of the unit, and for which shapes

// reports/live/form.json has SUPPLIES by kind, the two WAYS in which some inputs can be given, with the fields of each, the
// groups of rows of the FORM, PLACES (the field of a scene for an argument of a function), MISTAKES with numbers of a scene, and
// familiar FACTORS. The page has it among its data; outside a page it is a global.
const {SUPPLIES, WAYS, FORM, PLACES, MISTAKES, FACTORS} = globalThis.tribocheckForm ?? JSON.parse(document.getElementById("live-data").textContent).form;
const ROWS = FORM.flatMap(([, rows]) => rows);
const ROW = new Map(ROWS.map((row) => [row[0], row]));
const SLIDERS = ["load", "at", "lubricant.viscosity", "surface.summit_height_sd", "surface.m0", "supply"];
const SLIDER_RANGE = 30;  // a slider goes from 1/30 to 30 times the number that it starts with
const POINTS = 200;

// Whether another field makes this one useless. Such fields are not shown, and do not go into the scene.
function isIdle(state, path) {
  for (const [name, ways] of Object.entries(WAYS))
    for (const [way, paths] of Object.entries(ways)) if (paths.includes(path) && way !== state.values[name]) return true;
  if (path === "supply") return state.kind === "flooded";
  if (path === "closures.damiens_exponent") return state.values["closures.starvation"] !== "damiens";
  if (path === "lubricant.conductivity" || path === "lubricant.temperature_coefficient")
    return (state.values["lubricant.thermal"] ?? "none") === "none";
  return false;
}

// m₀ in m² from the text of a length with its unit, a roughness Rq: its square. Any other text stays as it is.
function squared(text) {
  const [, length, unit] = /^\s*([\d.]+)\s*(mm|µm|um|nm)\s*$/.exec(text.replace("μ", "µ")) ?? [];
  return unit ? String(Number(((length * {mm: 1e-3, nm: 1e-9}[unit] || length * 1e-6) ** 2).toPrecision(12))) : text;
}

// The scene of a contact {shape, kind, values by path} as TOML. A number with a unit stands as people write it; the reader converts it.
function tomlOf(state) {
  const number = (text, unit, power) => {
    if (unit === "m²") text = squared(text);
    if (power === 0 && /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text))
      return /^[+-]?(0|[1-9]\d*)(\.\d+)?(e[+-]?\d+)?$/i.test(text) ? text : String(Number(text));
    return JSON.stringify(/^[-+.\deE]+$/.test(text) && unit !== "" ? `${text} ${unit}` : text);
  };
  const told = {"": [`id = ${JSON.stringify(state.id)}`]};
  const put = (path, text, [unit, power]) => {
    const [, section, name] = /^(?:(.*)\.)?(.*)$/.exec(path);
    (told[section ?? ""] ??= []).push(`${name} = ${text}${power === 0 && unit ? `  # ${unit}` : ""}`);
  };
  for (const [path, , unit, power, shapes] of ROWS) {
    const text = (state.values[path] ?? "").trim();
    if (text === "" || isIdle(state, path) || path === "kind" || path === "at" || path in WAYS || path.startsWith("speed.") || (shapes && !shapes.split(" ").includes(state.shape))) continue;
    if (path === "lubricant.thermal" && text === "none") continue;
    if (path === "supply") {
      put(`supply.${state.kind}`, number(text, ...SUPPLIES[state.kind]), SUPPLIES[state.kind]);
    } else if (power === undefined) {
      put(path, JSON.stringify(text), ["", 1]);
    } else if (path !== "bodies.ellipticity" || text !== "1") {
      put(path, number(text, unit, power), [unit, power]);
    }
  }
  const speed = ["from", "to"].map((end) => [end, (state.values[`speed.${end}`] ?? "").trim()]).filter(([, text]) => text !== "")
    .map(([end, text]) => `${end} = ${number(text, "m/s", 0)}`);
  told[""].push(`speed = { ${[...speed, `count = ${POINTS}`].join(", ")} }  # m/s${Number(state.values.at) > 0 ? `; read at ${state.values.at} m/s` : ""}`);
  return Object.entries(told).map(([section, lines]) => (section ? `\n[${section}]\n` : "") + lines.join("\n") + "\n").join("");
}

function pythonOf(state) {
  return `import tribocheck\n\nscene = tribocheck.Scene("""\n${tomlOf(state).replaceAll("\\", "\\\\")}""")\n` +
    `print(scene.solve([${Number(state.values.at)}], outputs=["film", "asperity_load_share"${["lubricant.eyring_stress", "friction.boundary_coefficient"].every((path) => (state.values[path] ?? "").trim() !== "") ? ', "friction"' : ""}]))\n` +
    "print(scene.onset())\n";
}

// The held scene as a contact for the form.
function stateOf(model) {
  const told = valuesOf(model);
  const state = {id: told.id || "my contact", shape: told.shape, kind: "flooded", values: {}};
  const unitOf = (text, power) => shifted(String(text).length > 10 ? rounded(Number(text)) : text, -power);
  for (const [path, , , power] of ROWS)
    if (path in told) state.values[path] = power === undefined ? told[path] : unitOf(told[path], power);
  for (const [name, ways] of Object.entries(WAYS))
    state.values[name] = (Object.entries(ways).findLast(([, paths]) => paths[0] in told) ?? Object.entries(ways)[0])[0];
  for (const kind in SUPPLIES)
    if (`supply.${kind}` in told) {
      state.kind = kind;
      state.values.supply = unitOf(told[`supply.${kind}`], SUPPLIES[kind][1]);
    }
  state.values["speed.from"] = rounded(Number(told.low));
  state.values["speed.to"] = rounded(Number(told.high));
  state.values.at = rounded(Math.sqrt(told.low * told.high), 3);
  return state;
}

// A contact as the fragment of the page's address, and back.
function fragmentOf(state) {
  const parts = new URLSearchParams({id: state.id, shape: state.shape, kind: state.kind});
  for (const [path, , , , shapes] of ROWS)
    if (state.values[path] && (!shapes || shapes.split(" ").includes(state.shape))) parts.set(path, state.values[path]);
  return `#live?${parts}`;
}
function stateOfFragment(fragment) {
  if (!fragment.startsWith("#live?")) return null;
  const {id, shape, kind, ...values} = Object.fromEntries(new URLSearchParams(fragment.slice("#live?".length)));
  const isShape = ["circle", "ellipse", "line"].includes(shape), unknown = Object.keys(values).filter((path) => !ROW.has(path));
  if (!isShape) unknown.push(`shape=${shape}`);
  if (!(kind in SUPPLIES)) unknown.push(`kind=${kind}`);
  const state = {id: id ?? "my contact", shape: isShape ? shape : "circle", kind: kind in SUPPLIES ? kind : "flooded",
                 values: Object.fromEntries(Object.entries(values).filter(([path]) => ROW.has(path)))};
  for (const [name, ways] of Object.entries(WAYS)) state.values[name] ??= Object.keys(ways)[0];
  return unknown.length > 0 ? {...state, unknown} : state;
}

// --- A number of one's own

const givenOf = (told, at) => ({speed: at, ...Object.fromEntries(Object.entries(PLACES).filter(([, path]) => path in told).map(([argument, path]) => [argument, Number(told[path])]))});

// The quantities that a typed number can be: outputs of the whole contact (if `state` is given), films of smooth faces, Hertz' results.
function quantitiesOf(model, at, state = null) {
  const told = valuesOf(model), contact = Object.fromEntries(model.lines("live_contact").map((one) => [one[0], Number(one[3])]));
  const radius = told["bodies.reduced_radius"] ?? told["bodies.radius_x"];
  const numbers = {reduced_radius: radius, radius_x: radius, radius_y: radius, ...givenOf(told, at), load_per_length: told.load / told["bodies.length"],
                   ellipticity: told["bodies.ellipticity"] ?? contact.semi_axis_y / contact.semi_axis_x};
  const laws = model.lines("live_films", at).filter(([law]) => law !== "solved");
  laws.sort((a, b) => b[4] - a[4]);  // the scene's law first
  const hertz = {circle: "hertz_point", ellipse: "hertz_ellipse", line: "hertz_line"}[told.shape];
  const whole = (state ? model.outputs : []).filter((one) => one.words[0] === "")
    .map(({name, unit, meaning}) => ({name: "this contact", result: name, unit, meaning, state, law: told["closures.film"]}));
  const functions = [...laws.map(([law]) => law), hertz].flatMap((name) => {
    const known = model.function(name);
    if (!known || known.arguments.some(([argument]) => !(argument in numbers))) return [];
    const given = Object.fromEntries(known.arguments.map(([argument]) => [argument, Number(numbers[argument])]));
    return known.results.map(([result, unit, meaning]) => ({name, result, unit, meaning, given, isFilm: name !== hertz}));
  });
  return [...whole, ...functions];
}

// The arguments of a function, changed by a known mistake; null: the function or the held scene lacks an input of the mistake.
function misread(given, input, told) {
  const changed = {...given};
  for (const [argument, {times = 1, is, inverted, of, and, over}] of Object.entries(input))
    changed[argument] = of ? times * told[of] * (and ? told[and] : 1) / (over ? told[over] : 1) : is ?? (inverted ? 1 / given[argument] : given[argument] * times);
  return Object.keys(input).every((argument) => argument in given && !Number.isNaN(changed[argument])) ? changed : null;
}

// The numbers that a function gives with each known mistake, and those of other film laws: [text, number].
function madeOfFunction(model, mistakes, {name, result, given, isFilm}, at) {
  const made = [], told = valuesOf(model);
  for (const one of mistakes) {
    if (!one.functions.includes(name) && !(isFilm && one.functions.includes("film_laws"))) continue;
    const changed = misread(given, one.input, told), {times = 1, over} = one.result[result] ?? {};
    if (changed && (Object.keys(one.input).length > 0 || result in one.result))
      made.push([`${one.text} (${one.name})`, model.value(name, result, changed) * times / (over ? given[over] : 1)]);
  }
  if (isFilm)
    for (const [law, , film] of model.lines("live_films", at)) if (law !== name) made.push([`the film of ${law} in place of that of ${name}`, Number(film)]);
  return made;
}

// The numbers of a whole contact with each known mistake of an input, with each other law, smooth, and flooded: [text, number].
function madeOfContact(model, mistakes, {result, state, law}, at) {
  const told = valuesOf(model), given = givenOf(told, at), made = [];
  const solve = (text, values, kind = state.kind, speed = at) => {
    const changed = {...state, kind, values: {...state.values, ...values}};
    if (model.read(tomlOf(changed)).every(([what]) => what !== "error")) made.push([text, model.points(speed, speed, 1)[result][0]]);
  };
  const direct = Object.fromEntries(Object.entries(WAYS).map(([name, ways]) => [name, Object.keys(ways)[0]]));
  for (const one of mistakes) {
    if (Object.keys(one.input).length === 0 || !(one.functions.includes(law) || one.functions.includes("film_laws"))) continue;
    const changed = misread(given, one.input, told);
    if (!changed) continue;
    const values = {};
    for (const argument of Object.keys(one.input).filter((name) => name in PLACES))
      values[PLACES[argument]] = shifted(String(changed[argument]), -ROW.get(PLACES[argument])[3]);
    if ("viscosity" in one.input) values.oil = direct.oil;
    if ("effective_modulus" in one.input) values.modulus = direct.modulus;
    solve(`${one.text} (${one.name})`, values, state.kind, changed.speed);
  }
  for (const [path, {type, words}] of model.fields)
    if (type === "choice" && path in told && /^(closures|friction)\./.test(path))
      for (const word of words) if (word !== told[path]) solve(`${path} = ${word} in place of ${told[path]}`, {[path]: word});
  solve("smooth faces in place of rough ones", Object.fromEntries([...ROW.keys()].filter((path) => path.startsWith("surface.")).map((path) => [path, ""])));
  solve("as much oil as the contact can take in place of this supply", {}, "flooded");
  model.read(tomlOf(state));
  return made;
}

// The causes of a typed number, which is known to ± `doubt`. `texts` is [""] if the number is right, else the mistakes and other laws that
// give it. `nearest` is the nearest of them if none gives it. `right` is the model's own number.
function causesOf(model, mistakes, quantity, number, doubt, at) {
  const isNear = (one) => Math.abs(one - number) <= doubt + 1e-9 * Math.abs(number);
  const right = quantity.state ? model.points(at, at, 1)[quantity.result][0] : model.value(quantity.name, quantity.result, quantity.given);
  if (isNear(right)) return {right, texts: [""]};
  const made = (quantity.state ? madeOfContact : madeOfFunction)(model, [...mistakes, ...MISTAKES], quantity, at).filter(([, one]) => one !== right && Number.isFinite(one));
  const texts = [...new Set(made.filter(([, one]) => isNear(one)).map(([text]) => text))];
  const isOff = ([by]) => isNear(right * by) || isNear(right / by), known = FACTORS.find(isOff);
  const factor = known && `too ${number > right ? "large" : "small"} by a factor of ${known[1]}`;
  const away = ([, one]) => Math.abs(one / number - 1), [nearest] = made.sort((a, b) => away(a) - away(b));
  return {right, texts, factor, nearest: texts.length === 0 && nearest && away(nearest) < 0.02 && away(nearest) < 0.2 * Math.abs(right / number - 1) ? nearest : null};
}

// A typed number in SI units, and half a unit of its last digit; null: the text is no positive number with a unit that fits.
function typedNumber(text, unit) {
  const scales = {m: {m: 1, mm: 1e-3, "µm": 1e-6, um: 1e-6, nm: 1e-9}, Pa: {Pa: 1, kPa: 1e3, MPa: 1e6, GPa: 1e9}}[unit] ?? {"": 1, "%": 0.01};
  const parts = /^\s*(-?\d*\.?\d*(?:e[+-]?\d+)?)\s*(\S*)\s*$/i.exec(text.replace("μ", "µ"));
  const isPlain = {m: Number(parts?.[1]) < 0.01, Pa: Number(parts?.[1]) >= 1e5}[unit] ?? true;  // a number without a unit that can be one in SI units
  const scale = parts && (parts[2] === "" && isPlain ? 1 : scales[parts[2]]);
  if (!scale || !(Number(parts[1]) > 0 && Number(parts[1]) < Infinity)) return null;
  const [mantissa, power = "0"] = parts[1].toLowerCase().split("e");
  const decimals = (mantissa.split(".")[1] ?? "").length;
  return {number: Number(parts[1]) * scale, doubt: 0.5 * 10 ** (Number(power) - decimals) * scale};
}

// The text of a speed, in m/s. A text that is no number with m/s or mm/s is only trimmed.
function speedText(text) {
  const parts = /^\s*([\d.e+-]+)\s*(m\/s|mm\/s)\s*$/i.exec(text);
  return parts ? shifted(parts[1], parts[2] === "mm/s" ? -3 : 0) ?? text : text.trim();
}

globalThis.tribocheckLive = {quantitiesOf, causesOf, typedNumber, Model, bytesOf, unpacked, shifted, tomlOf, pythonOf, stateOf, fragmentOf, stateOfFragment};
if (typeof document === "undefined") return;

// --- Charts

const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

// Ticks of an axis: powers of ten, and between them 2 and 5 where there are few; else even steps.
function ticks([low, high], isLog) {
  if (isLog) {
    const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9), found = [];
    const step = Math.max(1, Math.ceil((last - first) / 5));
    for (let k = first - 1; k <= last; ++k)
      for (const part of last - first < 2 ? [1, 2, 5] : [1])
        if (part * 10 ** k >= low * (1 - 1e-9) && part * 10 ** k <= high * (1 + 1e-9) && (k - first) % step === 0) found.push(Number(`${part}e${k}`));
    return found;
  }
  const size = 10 ** Math.floor(Math.log10((high - low) / 4)), step = [1, 2, 5, 10].map((k) => k * size).find((one) => (high - low) / one <= 5);
  return Array.from({length: Math.floor((high - low) / step + 1e-9) + 1}, (_, k) => Math.ceil(low / step - 1e-9) * step + k * step)
    .filter((one) => one <= high * (1 + 1e-9)).map((one) => Number(one.toPrecision(12)));
}

function tickText(number) {
  if (number === 0 || (Math.abs(number) < 1e4 && Math.abs(number) >= 1e-3)) return String(number).replace("-", "−");
  const power = Math.floor(Math.log10(Math.abs(number)) + 1e-9), part = Number((number / 10 ** power).toPrecision(3));
  return `${part === 1 ? "" : part + "·"}10<tspan dy="-5" font-size="10">${String(power).replace("-", "−")}</tspan>`;
}

const BOX = {left: 62, right: 22, top: 44, bottom: 42, width: 480, height: 300};
const DASHES = ["", "7 4", "2 3", "10 3 2 3"];

// A chart as SVG: axes {name, ends, isLog}, lines {name, x, y}, marks at x, and `now`, the x that the numbers are for.
function chart(id, title, told, x, y, lines, {marks = [], now = null, cells = "", dots = []} = {}) {
  const {left, top, width, height} = BOX, right = width - BOX.right, bottom = height - BOX.bottom;
  const along = ({ends: [low, high], isLog}, from, to) => (value) =>
    from + (to - from) * (isLog ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));
  const atX = along(x, left, right), atY = along(y, bottom, top);
  let svg = `<svg role="img" viewBox="0 0 ${width} ${height}" aria-labelledby="${id}-title ${id}-desc"><title id="${id}-title">${escaped(title)}</title>` +
    `<desc id="${id}-desc">${escaped(told)}</desc><text class="name" x="${left}" y="16">${escaped(title)}</text>${cells ? cells(atX, atY) : ""}`;
  for (const one of ticks(x.ends, x.isLog))
    svg += `<path class="grid" d="M${atX(one).toFixed(1)} ${top}V${bottom}"/><text x="${atX(one).toFixed(1)}" y="${bottom + 18}" text-anchor="middle">${tickText(one)}</text>`;
  for (const one of ticks(y.ends, y.isLog))
    svg += `<path class="grid" d="M${left} ${atY(one).toFixed(1)}H${right}"/><text x="${left - 6}" y="${(atY(one) + 4).toFixed(1)}" text-anchor="end">${tickText(one)}</text>`;
  svg += `<rect class="frame" x="${left}" y="${top}" width="${right - left}" height="${bottom - top}"/>` +
    `<text x="${right}" y="${height - 6}" text-anchor="end">${escaped(x.name)}</text>`;
  for (const {x: place} of marks)
    if (place >= x.ends[0] && place <= x.ends[1]) svg += `<path class="mark" d="M${atX(place).toFixed(1)} ${top}V${bottom}"/>`;
  if (now !== null) svg += `<path class="now" d="M${atX(now).toFixed(1)} ${top}V${bottom}"/>`;
  lines.forEach((line, k) => {
    let path = "", isOn = false;
    for (let i = 0; i < line.x.length; ++i) {
      const value = line.y[i], isThere = value >= y.ends[0] * (y.isLog ? 1 - 1e-9 : 1) && value <= y.ends[1] * (1 + 1e-9);
      if (isThere) path += `${isOn ? "L" : "M"}${atX(line.x[i]).toFixed(1)} ${atY(value).toFixed(1)}`;
      isOn = isThere;
    }
    const colour = `style="stroke:var(--${["one", "two", "three", "four"][k]});stroke-dasharray:${DASHES[k] || "none"}"`;
    svg += `<path class="line" d="${path}" ${colour}/>`;
    if (line.name) {
      const place = left + k * (right - left) / lines.length;
      svg += `<path class="line" d="M${place} 33h22" ${colour}/><text x="${place + 27}" y="37">${escaped(line.name)}</text>`;
    }
  });
  for (const {x: atDot, y: value} of dots)
    svg += `<circle cx="${atX(atDot).toFixed(1)}" cy="${atY(value).toFixed(1)}" r="6" style="fill:var(--two);stroke:var(--card);stroke-width:2"/>`;
  return `${svg}</svg>`;
}

// The ends of an axis around all numbers above 0.
function ends(columns, most = 1e6) {
  let low = Infinity, high = 0;
  for (const column of columns) for (const one of column) if (one > 0) { low = Math.min(low, one); high = Math.max(high, one); }
  if (high === 0) return [0.1, 1];
  low = Math.max(low, high / most);
  return low * 1.2 < high ? [low / 1.1, high * 1.1] : [low / 2, high * 2];
}

// --- The page

const home = document.getElementById("live-part");
if (!home) return;
const find = (name) => home.querySelector(`[data-part="${name}"]`);

function table(caption, heads, rows) {
  const cell = ([text, kind]) => `<td${kind ? ` class="${kind}"` : ""}>${text}</td>`;
  return `<div class="scroll table" tabindex="0" role="region" aria-label="${escaped(caption)}"><table><caption><span>${escaped(caption)}</span></caption>` +
    `<thead><tr>${heads.map((head) => `<th scope="col">${escaped(head)}</th>`).join("")}</tr></thead>` +
    `<tbody>${rows.map(([head, ...cells]) => `<tr><th scope="row">${escaped(head)}</th>${cells.map(cell).join("")}</tr>`).join("")}</tbody></table></div>`;
}

class Page {
  constructor(model) {
    this.model = model;
    const {scenes, mistakes} = JSON.parse(document.getElementById("live-data").textContent);
    Object.assign(this, {scenes, mistakes});
    this.drawn = 0;  // number of updates, for measurements
    this.fill();
    home.querySelector(".live-missing").hidden = true;
    home.addEventListener("input", (event) => this.typed(event.target));
    home.addEventListener("click", (event) => this.clicked(event.target.closest("button")));
    home.querySelector("form").addEventListener("submit", (event) => event.preventDefault());
    find("own").addEventListener("keydown", ({key}) => { if (key === "Enter") this.test(); });
    find("start").addEventListener("change", ({target}) => { if (target.value) this.begin(this.scenes[target.value]); });
    const given = stateOfFragment(location.hash);
    if (given) this.show(given);
    else this.begin(Object.values(this.scenes)[0]);
    addEventListener("hashchange", () => { const shared = stateOfFragment(location.hash); if (shared) this.show(shared); });
  }

  // The frame of the page's template, with sliders and fields.
  fill() {
    const options = (words) => words.map((word) => `<option>${escaped(word)}</option>`).join("");
    const field = ([path, label, unit, power, shapes]) => {
      const id = `live-${path.replaceAll(".", "-")}`, info = this.model.fields.get(path);
      const entry = path === "kind" || path in WAYS ? `<select id="${id}" data-path="${path}">${options(Object.keys(WAYS[path] ?? SUPPLIES))}</select>`
        : power === undefined ? `<select id="${id}" data-path="${path}">${options(info.words)}</select>`
        : `<input type="text" id="${id}" data-path="${path}" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${id}-told ${id}-fault">`;
      return `<div class="field" data-shapes="${shapes ?? ""}"><label for="${id}">${escaped(label)}</label><span class="entry">${entry}` +
        `<span data-unit="${path}">${unit ?? ""}</span></span>${info?.meaning.length > 30 ? `<span class="told">${escaped(info.meaning)}</span>` : ""}` +
        `<span class="told" id="${id}-told"></span><span class="fault" id="${id}-fault" role="alert"></span></div>`;
    };
    const slider = (path) => `<div><label for="live-drag-${path.replaceAll(".", "-")}">${escaped(path === "at" ? "speed u" : path === "supply" ? "supply" : ROW.get(path)[1].split(",")[0])}` +
      ` <b></b></label><input type="range" id="live-drag-${path.replaceAll(".", "-")}" data-drag="${path}" min="-100" max="100" step="1" value="0"></div>`;
    home.append(document.getElementById("live-frame").content);
    find("start").insertAdjacentHTML("beforeend", options(Object.keys(this.scenes)));
    find("text-place").innerHTML = '<textarea id="live-text" data-part="text" spellcheck="false"></textarea>';  // Markdown takes no such element
    find("sliders").innerHTML = SLIDERS.map(slider).join("");
    home.querySelector("form").insertAdjacentHTML("beforeend", FORM.map(([name, rows]) => `<fieldset><legend>${name}</legend>${rows.map(field).join("")}</fieldset>`).join(""));
  }

  // A shipped scene, or a text from elsewhere.
  begin(toml) {
    const told = this.model.read(toml).filter(([kind]) => kind === "error");
    find("unread").textContent = told.map(([, path, sentence]) => (path ? `${path}: ${sentence}` : sentence)).join(" ");
    if (told.length > 0) return this.tell(told);
    const state = stateOf(this.model), at = /^speed = .*; read at (\S+) m\/s$/m.exec(toml)?.[1];
    if (Number(at) > 0) state.values.at = at;
    this.show(state, true);
  }

  show(state, isScene = false) {
    this.state = state;
    find("start").value = isScene && state.id in this.scenes ? state.id : "";
    for (const entry of home.querySelectorAll("[data-path]")) {
      const path = entry.dataset.path;
      const usual = this.model.fields.get(path)?.usual?.replaceAll('"', "") ?? "";
      entry.value = path === "shape" || path === "kind" ? state[path] : state.values[path] ?? (entry.tagName === "SELECT" ? usual : "");
      if (entry.tagName === "SELECT" && entry.value === "") entry.selectedIndex = 0;
    }
    find("done").textContent = state.unknown ? `The link has ${state.unknown.join(", ")}, which this page does not know: the rest of it is shown.` : "";
    this.middles = {};  // the number and the text in the middle of each slider
    this.update();
    for (const one of home.querySelectorAll("[data-drag]")) this.centre(one);
    this.showFields();
  }

  // The number of a slider in the unit of its field, also if it was typed in another unit; NaN: there is none.
  numberOf(path) {
    if (path === "at") return Number(this.state.values.at);
    const [place, power] = path === "supply" ? [`supply.${this.state.kind}`, SUPPLIES[this.state.kind][1]] : [path, ROW.get(path)[3]];
    return valuesOf(this.model)[place] * 10 ** -power;
  }

  // The numbers at both ends of a slider. The slider of the speed has the ends of the curve.
  endsOf(path) {
    const {values} = this.state, {number} = this.middles[path];
    return path === "at" ? [Number(values["speed.from"]), Number(values["speed.to"])] : [number / SLIDER_RANGE, number * SLIDER_RANGE];
  }

  // Moves a slider to its number. Its ends are set anew around the number, unless `isKept` and the number is between them.
  centre(drag, isKept = false) {
    const path = drag.dataset.drag, number = this.numberOf(path);
    if (!(number > 0)) return;
    const place = () => { const [low, high] = this.endsOf(path); return 200 * Math.log(number / low) / Math.log(high / low) - 100; };
    if (!(isKept && this.middles[path] && Math.abs(place()) <= 100)) this.middles[path] = {number, text: this.state.values[path]};
    drag.value = place();
  }

  typed(entry) {
    const {values} = this.state, path = entry.dataset.path ?? entry.dataset.drag;
    if (!path) return;
    find("start").value = "";  // so that the scene can be chosen again
    if (entry.dataset.drag) {
      const [low, high] = this.endsOf(path), number = low * (high / low) ** ((Number(entry.value) + 100) / 200);
      values[path] = entry.value === "0" && path !== "at" ? this.middles[path].text : rounded(Math.min(high, Math.max(low, number)), 3);
      if (path === "surface.summit_height_sd" && Number(values["surface.rms_roughness"]) > 0)  // Rq changes by the same factor
        this.put("surface.rms_roughness", rounded(values["surface.rms_roughness"] * values[path] / this.numberOf(path), 4));
      this.put(path, values[path]);
    } else if (path === "shape") {
      this.changeShape(entry.value);
    } else if (path === "kind") {
      this.changeSupply(entry.value);
    } else {
      values[path] = path === "at" || path.startsWith("speed.") ? speedText(entry.value) : entry.value;
    }
    this.update();
    if (!entry.dataset.drag) for (const one of home.querySelectorAll("[data-drag]")) this.centre(one, path !== "kind" || one.dataset.drag !== "supply");
  }

  put(path, text) { home.querySelector(`[data-path="${path}"]`).value = this.state.values[path] = text; }

  // The new shape begins with the radius of the old one, and with a film law of its kind.
  changeShape(shape) {
    const {values} = this.state, radius = values["bodies.reduced_radius"] || values["bodies.radius_x"] || "";
    for (const path of shape === "circle" ? ["bodies.reduced_radius"] : shape === "ellipse" ? ["bodies.radius_x", "bodies.radius_y"] : ["bodies.radius_x"])
      if (!values[path]) this.put(path, radius);
    if (shape === "line" && !values["bodies.length"]) this.put("bodies.length", "10");
    if ((shape === "line") !== (this.state.shape === "line")) this.put("closures.film", shape === "line" ? "moes_line" : "hamrock_dowson_central");
    this.state.shape = shape;
  }

  // The new kind of supply begins with the oil layer that the old kind gives at the speed `at`.
  changeSupply(kind) {
    const {values} = this.state, sd = Number(valuesOf(this.model)["surface.summit_height_sd"]), at = Number(values.at);
    const factors = {inlet_film: 1e-9, inlet_film_ratio: sd, inlet_flow: 1e-6 / at}, layer = this.numberOf("supply") * factors[this.state.kind];
    if (kind !== "flooded") this.put("supply", rounded((layer > 0 ? layer : 1e-7) / (factors[kind] || 2.5e-8), 3));
    this.state.kind = kind;
  }

  // Reads the state's contact and draws everything anew. If the contact cannot be read, its faults are told.
  update() {
    const {state, model} = this;
    state.values.at ??= "";
    const toml = tomlOf(state);
    const told = model.read(toml);
    if (find("text") !== document.activeElement) find("text").value = toml;
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => history.replaceState(null, "", fragmentOf(state)), 300);
    this.showFields();
    const low = Number(state.values["speed.from"]), high = Number(state.values["speed.to"]), at = Number(state.values.at);
    const errors = told.filter(([kind]) => kind === "error");
    if (state.kind !== "flooded" && (state.values.supply ?? "").trim() === "") errors.push(["error", `supply.${state.kind}`, "missing; allowed: a number above 0"]);
    if (errors.length === 0 && !(at >= low && at <= high))
      errors.push(["error", "at", `${state.values.at || "this"} is not allowed; allowed: a number from ${low} to ${high}, the curve's speeds, in m/s`]);
    const warnings = told.filter(([kind]) => kind === "warning");
    this.tell(errors, warnings);
    if (errors.length === 0) this.draw(low, high, at, warnings);
    ++this.drawn;
  }

  // Which fields there are for this shape and supply, what their numbers are in SI units, and which are physical.
  showFields() {
    const {state, model} = this;
    for (const one of home.querySelectorAll("[data-drag]")) {
      const path = one.dataset.drag, own = state.values[path] ?? "", text = Number(own) > 0 ? `${own} ${path === "supply" ? SUPPLIES[state.kind][0] : ROW.get(path)[2]}`.trim() : own;
      one.parentElement.hidden = !this.middles[path] || isIdle(state, path);
      one.setAttribute("aria-valuetext", text);
      one.parentElement.querySelector("b").textContent = text;
    }
    for (const box of home.querySelectorAll(".field")) {
      const entry = box.querySelector("[data-path]"), path = entry.dataset.path;
      box.hidden = Boolean(box.dataset.shapes && !box.dataset.shapes.split(" ").includes(state.shape)) || isIdle(state, path);
      let [, , unit, power] = ROW.get(path);
      if (path === "supply") {
        [unit, power] = SUPPLIES[state.kind];
        home.querySelector('[data-unit="supply"]').textContent = unit;
      }
      const info = model.fields.get(path === "supply" ? `supply.${state.kind}` : path);
      let text = path === "kind" ? SUPPLIES[state.kind][2] : "";
      if (info && power !== undefined) {
        const si = power !== 0 && entry.value !== "" ? shifted(entry.value, power) : null;
        const bound = (number) => shifted(String(number), -power);
        const range = Number.isFinite(info.greatest) ? `physical: ${bound(info.least)} to ${bound(info.greatest)} ${unit}`.trim() : "";
        text = [si === null ? "" : `${si} ${info.unit}`, range].filter((part) => part !== "").join("; ");
      }
      box.querySelector("[id$=-told]").textContent = text;
    }
  }

  // Puts a sentence beside a field and returns the box of the field; null: this contact has no such field.
  tellBeside(path, sentence) {
    const box = home.querySelector(`.field:not([hidden]) [data-path="${path.startsWith("supply.") ? "supply" : path}"]`)?.closest(".field") ?? null, place = box?.querySelector(".fault");
    if (place) place.textContent += `${place.textContent && " "}${sentence}`;
    return box;
  }

  // Tells faults and warnings beside their fields. A line above the form names the fields with faults.
  tell(errors, warnings = []) {
    const rest = [], names = [];
    for (const one of home.querySelectorAll(".field .fault")) one.textContent = "";
    for (const one of home.querySelectorAll("[data-path]")) one.removeAttribute("aria-invalid");
    for (const [kind, path, sentence] of [...errors, ...warnings]) {
      const box = this.tellBeside(path, sentence);
      if (kind === "warning") continue;
      box?.querySelector("[data-path]").setAttribute("aria-invalid", "true");
      if (box) names.push(box.querySelector("label").textContent);
      else rest.push(path ? `${path}: ${sentence}` : sentence);
    }
    find("faults").textContent = (names.length ? `Mend below: ${[...new Set(names)].join("; ")}. ` : "") + rest.join(" ");
    const isStale = this.isStale = errors.length > 0;
    for (const name of ["charts", "numbers", "onsets", "films", "limits"]) find(name).classList.toggle("stale", isStale);
    if (isStale) find("said").textContent = `${this.quantities ? "The numbers below are of the last contact that could be read" : "This contact cannot be read yet"}; mend ${names.join("; ") || "it"}.`;
  }

  draw(low, high, at, warnings) {
    const {model} = this, curve = model.points(low, high, POINTS), here = model.points(at, at, 1);
    const onsets = model.lines("live_onsets").map(([name, meaning, speed, film, parameter, why]) =>
      ({name, meaning, x: speed === "" ? NaN : Number(speed), film: Number(film), parameter, why}));
    const x = {name: "speed [m/s]", ends: [low, high], isLog: true}, more = {marks: onsets.filter((one) => one.x > 0), now: at};
    const value = (name) => here[name][0];
    const word = (name) => model.outputs.find((one) => one.name === name).words[value(name)] ?? "undefined";
    const told = valuesOf(model), isSmooth = !("surface.summit_height_sd" in told), share = 100 * value("asperity_load_share");
    const why = Object.fromEntries(model.lines("live_undefined", at)), limits = model.lines("live_limits", at).filter((one) => one[6] === "0");
    for (const one of limits) this.tellBeside(one[9], `It is not in the physical range.${one[10] ? ` Perhaps ${one[10]} was meant.` : ""}`);
    const beyond = limits.length === 0 ? "" : ` Beyond limits of the model (last table): ${limits.map(([name]) => name).join(", ")}.`;
    const said = why.film ? `At ${rounded(at, 4)} m/s there is no number: ${why.film}.`
      : `At ${rounded(at, 4)} m/s: film h* ${usual(value("film"), "m")}${isSmooth ? "" : `, λ* = h*/σ_s ${rounded(value("film_parameter"), 4)}`}${value("lambda_ratio") > 0 ? `, Λ ${rounded(value("lambda_ratio"), 4)}` : ""}, ` +
      `summits carry ${isSmooth ? "nothing (smooth)" : share < 1e-6 ? "less than 1e-6 %" : usual(share, "%")}, ` +
      `friction ${Number.isNaN(value("friction")) ? "undefined" : rounded(value("friction"), 4)}, regime ${word("regime")}, inlet ${word("inlet")}.${beyond}`;
    find("said").textContent = said;
    const friction = ends([curve.friction], 1e4);
    find("friction").innerHTML = chart("live-friction", "Stribeck curve", said, x, {ends: friction, isLog: friction[1] > 5 * friction[0]},
                                       [{name: "friction μ", x: curve.speed, y: curve.friction}], more);
    const nanometers = (column) => column.map((one) => one * 1e9);
    const films = [nanometers(curve.film), nanometers(curve.film_flooded)];
    find("film").innerHTML = chart("live-film", "Film [nm]", said, x, {ends: ends(films, 1e4), isLog: true},
                                   [{name: "film h*", x: curve.speed, y: films[0]}, ...(this.state.kind === "flooded" ? [] : [{name: "with plenty of oil", x: curve.speed, y: films[1]}])], more);
    find("shares").innerHTML = chart("live-shares", "Shares of the load", said, x, {ends: [0, 1], isLog: false},
                                     [{name: "summits A", x: curve.speed, y: curve.asperity_load_share}, {name: "film 1 − A", x: curve.speed, y: curve.fluid_load_share}], more);
    this.drawMap(at);
    this.drawNumbers(at, here, told, why);
    find("onsets").innerHTML = table("Onsets of starvation, and the least friction: dashed lines in the charts", ["criterion", "speed, m/s", "film", "λ", "meaning, or why there is none"],
      onsets.map((one) => [one.name, [one.why ? "none" : rounded(one.x, 5), "number"], [one.why ? "" : usual(one.film, "m"), "number"],
                           [one.why || isSmooth ? "" : rounded(Number(one.parameter), 4), "number"], [escaped(one.why || one.meaning), "prose"]]));
    this.drawFilms(at);
    this.listQuantities(at);
    find("limits").innerHTML = (warnings.length ? `<p>${warnings.map(([, path, sentence]) => escaped(`${path}: ${sentence}`)).join("<br>")}</p>` : "") +
      (limits.length === 0 ? "<p>At this speed the contact is within all limits of the model that are known.</p>"
        : table(`Limits of the model that this contact goes beyond at ${rounded(at, 4)} m/s`, ["limit", "assumption that is not met", "here", "allowed", "touches"],
                limits.map(([name, assumption, number, least, greatest, unit, , touches, advice, , likely]) => [name,
                  [escaped(assumption + (likely ? ` Perhaps ${likely} was meant.` : "") + (advice ? ` (${advice})` : "")), "prose"], [usual(Number(number), unit), "number"],
                  [greatest === "inf" ? `from ${usual(Number(least), unit)}` : Number(least) === 0 ? `to ${usual(Number(greatest), unit)}`
                    : `${usual(Number(least), unit)} to ${usual(Number(greatest), unit)}`, "number"], [escaped(touches), "word"]])));
  }

  drawNumbers(at, here, told, why) {
    if (!("surface.rms_roughness" in told)) why.lambda_ratio = "no roughness Rq is given";
    if (Number.isNaN(here.friction[0])) why.friction ??= "it needs Eyring's stress and the coefficient μ_b";
    const rows = this.model.outputs.map(({name, unit, meaning, words}) => {
      const number = here[name][0], isWord = words[0] !== "";
      const text = why[name] || Number.isNaN(number) ? "undefined" : isWord ? words[number] : usual(number, unit);
      return [name, [text, isWord ? "word" : "number"], [why[name] || isWord || Number.isNaN(number) ? "" : `${rounded(number)} ${unit}`.trim(), "number"],
              [escaped(why[name] ? `undefined: ${why[name]}` : meaning), "prose"]];
    });
    const faces = [["σ_s", "surface.summit_height_sd"], ["Rq", "surface.rms_roughness"], ["η₀", "lubricant.viscosity"]].filter(([, path]) => path in told)
      .map(([symbol, path]) => [path.split(".")[1], symbol, "given, or from what is given", told[path], this.model.fields.get(path).unit]);
    const contact = [...this.model.lines("live_contact"), ...faces].map(([name, symbol, meaning, number, unit]) =>
      [name, [usual(Number(number), unit), "number"], [`${rounded(Number(number))} ${unit}`.trim(), "number"], [escaped(`${symbol}, ${meaning}`), "prose"]]);
    find("numbers").innerHTML = table(`The numbers at ${rounded(at, 4)} m/s`, ["number", "value", "in SI units", "meaning"], [...rows, ...contact]);
  }

  drawMap(at) {
    const {model, state} = this, isLine = state.shape === "line", count = 40;
    const [own, other] = model.numbers(2, "live_map", at, 0, 1, 0, 1, 0);
    const around = (number, least, most) => {
      const middle = Math.log10(number);
      return [Math.min(least, Math.floor(middle - 0.5)), Math.max(most, Math.ceil(middle + 0.5))];
    };
    const [x0, x1] = isLine ? around(own, -1, 4) : around(own, 1, 11), [y0, y1] = isLine ? around(other, -1, 2) : around(other, 0, 9);
    const map = model.numbers(3 + count * count, "live_map", at, x0, x1, y0, y1, count), regime = model.regimes[map[2]].replaceAll("_", " ");
    const x = {name: isLine ? "load number M" : "viscosity number g_V", ends: [10 ** x0, 10 ** x1], isLog: true};
    const y = {ends: [10 ** y0, 10 ** y1], isLog: true};
    const cells = (atX, atY) => {
      const edge = (low, high, i) => 10 ** (low + (high - low) * i / count);
      let text = "";
      for (let i = 0; i < count; ++i)
        for (let j = 0, from = 0; j < count; ++j) {  // neighbours in a column with the same regime make one rectangle
          if (j + 1 < count && map[3 + i * count + j + 1] === map[3 + i * count + j]) continue;
          const left = atX(edge(x0, x1, i)), top = atY(edge(y0, y1, j + 1));
          text += `<rect x="${left.toFixed(1)}" y="${top.toFixed(1)}" width="${(atX(edge(x0, x1, i + 1)) - left + 0.3).toFixed(1)}" ` +
            `height="${(atY(edge(y0, y1, from)) - top + 0.3).toFixed(1)}" style="fill:var(--map${map[3 + i * count + j]})"/>`;
          from = j + 1;
        }
      return text;
    };
    const names = new Set(map.subarray(3));
    find("map").innerHTML = chart("live-map", `Regime: ${regime}`, `The map of regimes over ${x.name} and ${isLine ? "material number L" : "elasticity number g_E"}; this contact is ${regime}.`,
                                  x, y, [], {cells, dots: [{x: own, y: other}]}) +
      `<p class="note">Upwards: ${isLine ? "material number L" : "elasticity number g_E"}. ${[...names].sort().map((one) =>
        `<span style="background:var(--map${one})">&nbsp;${model.regimes[one].replaceAll("_", " ")}&nbsp;</span>`).join(" ")}</p>`;
  }

  drawFilms(at) {
    const rows = this.model.lines("live_films", at), solved = Object.fromEntries(rows.filter(([law]) => law === "solved").map(([, least, film]) => [least, Number(film)]));
    const laws = new Set(rows.map(([law]) => law));  // those of this shape
    for (const option of home.querySelector('[data-path="closures.film"]').options) option.disabled = !laws.has(option.value);
    const bar = (part) => `<span aria-hidden="true" style="display:inline-block;height:.7em;width:${Math.min(6, Math.abs(part) * 12).toFixed(2)}rem;background:var(--${part < 0 ? "one" : "four"})"></span>`;
    find("films").innerHTML = table(`Films of smooth faces in plenty of oil at ${rounded(at, 4)} m/s, and how far each is from the solved one, central or least`,
      ["law", "film", "from the solved film", "remark"],
      rows.map(([law, isMinimum, number, beyond, isScenes]) => {
        const part = Number(number) / solved[isMinimum] - 1, isCompared = law !== "solved" && Number.isFinite(part);
        return [law === "solved" ? `solved ${isMinimum === "1" ? "least" : "central"} film` : law, [usual(Number(number), "m"), "number"], [isCompared ? `${part < 0 ? "−" : "+"}${rounded(100 * Math.abs(part), 3)} % ${bar(part)}` : "", "word"],
                [escaped([isScenes === "1" ? "the scene's law" : "", isMinimum === "1" ? "least film" : "", beyond].filter((one) => one).join("; ")), "prose"]];
      }));
  }

  listQuantities(at) {
    this.quantities = quantitiesOf(this.model, at, this.state);
    const names = this.quantities.map(({name, result, state, isFilm}) => (state ? `${result} of this contact` : isFilm ? `film of smooth faces by ${name}` : `${result} by ${name}`));
    const list = find("quantity"), chosen = list.selectedIndex;
    find("cause").textContent = "";
    if (names.join() === [...list.options].map((one) => one.text).join()) return;
    list.innerHTML = names.map((one) => `<option>${escaped(one)}</option>`).join("");
    list.selectedIndex = chosen >= 0 && chosen < names.length ? chosen : names.indexOf("film of this contact");
  }

  test() {
    find("cause").textContent = this.isStale ? "This contact cannot be read, so that there is no right number; mend its fields first." : this.verdict();
  }

  verdict() {
    const quantity = this.quantities[find("quantity").selectedIndex], {unit} = quantity, own = typedNumber(find("own").value, unit);
    if (!own) return `"${find("own").value}" is not allowed; allowed: a number above 0${unit ? ` with its unit, as ${unit === "m" ? "152 nm" : "1.08 GPa"}` : ""}`;
    const off = (one) => {
      const ratio = one / own.number;
      return ratio > 0.5 && ratio < 2 ? `${rounded(100 * Math.abs(1 / ratio - 1), 3)} % ${ratio < 1 ? "more" : "less"} than that` : `${rounded(1 / ratio, 4)} times that`;
    };
    const {right, texts, factor, nearest} = causesOf(this.model, this.mistakes, quantity, own.number, own.doubt, Number(this.state.values.at));
    const here = `${quantity.state ? `${quantity.result} is` : `${quantity.name} gives`} ${usual(right, unit)}`;
    return !(Number.isFinite(right)) ? `There is no right number: ${quantity.result} is undefined here.`
      : texts[0] === "" ? `Right, to all digits that you typed: ${here}.`
      : texts.length > 0 ? `Not right: ${here}, and your number is ${off(right)}. It is the number of ${texts.length > 1 ? "each of these: " : ""}${texts.join("; ")}.`
      : factor ? `Not right: ${here}, and your number is ${factor}.`
      : `Not right: ${here}, and your number is ${off(right)}. None of the single mistakes and laws that this page knows gives all its digits` +
        `${nearest ? `; the nearest is ${nearest[0]}, which gives ${usual(nearest[1], unit)}: yours is ${off(nearest[1])}` : ""}. ` +
        `The program asks your code at many inputs and finds more, also two mistakes at once: tribocheck verify --subject "your command"; its README begins with how to install it.`;
  }

  async clicked(button) {
    const what = button?.dataset.do;
    if (what === "test") this.test();
    if (what === "read") this.begin(find("text").value);
    if (what === "verify") this.verify();
    const text = {link: () => new URL(fragmentOf(this.state), location.href).href, toml: () => tomlOf(this.state), python: () => pythonOf(this.state)}[what];
    if (!text) return;
    find("text").value = text();
    let isCopied = true;
    try {
      await navigator.clipboard.writeText(text());
    } catch {  // a page from a file may not write to the clipboard: the text is shown, to be copied by hand
      isCopied = false;
      find("text").closest("details").open = true;
      find("text").select();
    }
    const isFaulty = home.querySelector('.live [aria-invalid="true"]') ? " It has the faults that are told at its fields." : "";
    find("done").textContent = (isCopied ? "Copied." : "The browser does not let this page copy: the text is selected below.") + isFaulty;
  }

  verify() {
    const start = performance.now(), rows = this.model.lines("live_verify"), took = performance.now() - start;
    const worst = rows.reduce((a, b) => (Number(b[3]) <= Number(a[3]) || Number.isNaN(Number(a[3])) ? a : b)), count = rows.reduce((sum, one) => sum + Number(one[2]), 0);
    const isKept = rows.every((one) => Number(one[3]) <= 1);
    find("verdict").innerHTML = `<p class="verdict">${isKept ? "Verified in this browser" : "NOT verified in this browser"}: ${count} certified rows of ${new Set(rows.map((one) => one[0])).size} ` +
      `functions, the worst conditioned among them, in ${rounded(took, 2)} ms. The greatest error takes ${rounded(100 * worst[3], 2)} % of its bound ` +
      `(${escaped(worst[0])}, row ${escaped(worst[4])}). So this browser computes the formulas within the program's bounds at these inputs; your contact is not among them.</p>` +
      `<details class="more"><summary>The certified rows: numbers known to more digits than these have</summary>` + table("Certified rows in this browser", ["function", "result", "rows", "greatest error, of its bound", "row"],
            rows.map(([name, output, number, part, row]) => [name, [escaped(output), "word"], [number, "number"], [`${rounded(100 * part, 2)} %`, "number"], [escaped(row), "word"]])) + "</details>";
  }
}

// --- The start: when the live part comes near the window, or when the address asks for it

let started = null;
async function startOnce() {
  try {
    const packed = bytesOf(document.getElementById("live-wasm").textContent.trim());
    tribocheckLive.page = new Page(await Model.from(await unpacked(packed)));
  } catch (fault) {
    console.warn(`The live part is missing: ${fault}`);  // the sentence in its place stays
  }
}
const start = () => (started ??= startOnce());
new IntersectionObserver((seen) => { if (seen.some((one) => one.isIntersecting)) start(); }, {rootMargin: "400px"}).observe(home);
const goTo = async () => { if (location.hash.startsWith("#live?")) { await start(); home.scrollIntoView(); } };
addEventListener("hashchange", goTo);
goTo();
})();
