// SPDX-License-Identifier: Apache-2.0
// Asks the chart of temperature and viscosity of fluidpower.pro, by Dzyanis Sukhanitski, through its fields in degrees Celsius and cSt.
"use strict";
const fields = {}, none = () => {};
const jQuery = (name) => ({ val: () => fields[name.slice(1)], html: none, change: none });
const google = { load: none, setOnLoadCallback: none };
const page = require("./answering.js").load(["calcs/l_and_h.js", "calcs/viscosity-chart3.js"], { jQuery, google });

exports.astm_d341_viscosity = (q) => {
  Object.assign(fields, { temp1_m: q.first_temperature - 273.15, visc1_m: 1e6 * q.first_viscosity,
    temp2_m: q.second_temperature - 273.15, visc2_m: 1e6 * q.second_viscosity });
  return 1e-6 * page.getViscx(q.temperature - 273.15);
};
exports.viscosity_index = (q) => {
  Object.assign(fields, { temp1_m: 40, visc1_m: 1e6 * q.kinematic_viscosity_40, temp2_m: 100, visc2_m: 1e6 * q.kinematic_viscosity_100 });
  return page.getVI();
};
