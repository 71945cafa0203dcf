// SPDX-License-Identifier: Apache-2.0
// Asks OpenHertz, a page by Foad S. Farimani, through its fields in N, mm and GPa. Its results are read in um and MPa, before
// they are rounded for display. E* is given as two bodies with nu = 0.3.
"use strict";
const fields = {};
const document = { getElementById: (name) => (fields[name] ??= { style: {}, value: "0" }) };
const page = require("./answering.js").load(["scripts.js"], { document });

function ask(type, force, radius, E1, nu1, E2, nu2) {
  const given = { contactTypeList: type, forceValue: force, firstRadius: 1e3 * radius, secondRadiusValue: 1, cylinderLengthValue: 1e3,
    OrientationSelector: "2", firstElastic: 1e-9 * E1, firstPoisson: nu1, secondElastic: 1e-9 * E2, secondPoisson: nu2 };
  for (const name in given) document.getElementById(name).value = given[name];
  page.updateResults();
}
const both = (E) => [2 * E * (1 - 0.09), 0.3, 2 * E * (1 - 0.09), 0.3];

exports.effective_modulus = (q) => {
  ask("1", 1, 1, q.first_modulus, q.first_poisson_ratio, q.second_modulus, q.second_poisson_ratio);
  return 1e9 * page.globalEffectiveElasticity;
};
exports.hertz_point = (q) => {
  ask("1", q.load, q.reduced_radius, ...both(q.effective_modulus));
  return { radius: 1e-6 * page.globalContactRadius, peak_pressure: 1e6 * page.globalMaximumPressure, approach: 1e-6 * page.globalIndentation };
};
exports.hertz_line = (q) => {
  ask("3", q.load_per_length, q.reduced_radius, ...both(q.effective_modulus));
  const peak = 1e6 * page.globalMaximumPressure;
  return { half_width: 1e-6 * page.globalContactWidth, peak_pressure: peak, peak_shear: peak * page.calculateShearCo(0.3) };
};
